"""Print Python data and sympy expressions as JavaScript; repeated parts get a name."""

import json
from collections import Counter

import sympy as sp

from discostorm._numeric import cse_keep_rounding

#: Minimum length of a repeated part that gets a name [characters].
MIN_NAMED_LENGTH = 16


class JsCode(str):
    """JavaScript code, such as a function. Any other string is data."""

    __slots__ = ()


#: Code, or data that JSON can hold, infinite numbers included.
JsValue = JsCode | str | float | bool | None | dict[str, "JsValue"] | list["JsValue"]


def js_function(expression: sp.Expr) -> JsCode:
    """Print an expression as a JavaScript function of an object that holds its symbols."""
    names = ", ".join(sorted(symbol.name for symbol in expression.free_symbols))
    shared, rest = cse_keep_rounding(sp.sympify(expression))
    lines = [f"const {symbol} = {sp.jscode(part)};" for symbol, part in shared]
    return JsCode(" ".join([f"({{ {names} }}) => {{", *lines, f"return {sp.jscode(rest)}; }}"]))


class JsFormulas:
    """The distinct formulas, each under a descriptive name."""

    def __init__(self) -> None:
        self.names: dict[JsCode, str] = {}

    def name_of(self, expression: sp.Expr, hint: str) -> str:
        """Return the name of an expression; add the expression if it is new."""
        code = js_function(expression)
        if code not in self.names:
            same = sum(name.rstrip("0123456789") == hint for name in self.names.values())
            self.names[code] = f"{hint}{same + 1}" if same else hint
        return self.names[code]


def scalar_as_javascript(value: object) -> str:
    """Print a string or a number as JavaScript, integers without a decimal point."""
    if isinstance(value, JsCode):
        return value
    if isinstance(value, (float, sp.Expr)):
        if value == sp.oo:
            return "Infinity"
        value = int(value) if float(value).is_integer() and value < 1e15 else float(value)
    return json.dumps(value, ensure_ascii=False)


def js_text(value: JsValue) -> str:
    """Print nested data as JavaScript; long data get one entry per line."""
    if isinstance(value, dict):
        entries = [f"{scalar_as_javascript(key)}: {js_text(part)}" for key, part in value.items()]
        braces = "{}"
    elif isinstance(value, list):
        entries, braces = [js_text(part) for part in value], "[]"
    else:
        return scalar_as_javascript(value)
    line = ", ".join(entries)
    if len(line) < 300 and "\n" not in line:
        return f"{braces[0]}{line}{braces[1]}"
    return "\n".join([braces[0], *(f"{entry}," for entry in entries), braces[1]])


def name_repeated_parts(value: JsValue) -> tuple[dict[str, JsValue], JsValue]:
    """Replace repeated parts of nested data by names; return the named parts and the rest.

    A later part may refer to earlier parts. Short parts stay in place.
    """
    many = Counter[str]()

    def count(part: JsValue) -> None:
        many[js_text(part)] += 1
        if many[js_text(part)] == 1 and isinstance(part, (dict, list)):
            for inner in part.values() if isinstance(part, dict) else part:
                count(inner)

    names: dict[str, JsCode] = {}
    said: dict[str, JsValue] = {}

    def named(part: JsValue) -> JsValue:
        whole = js_text(part)
        if whole in names:
            return names[whole]
        rest = part
        if isinstance(part, dict):
            rest = {key: named(inner) for key, inner in part.items()}
        elif isinstance(part, list):
            rest = [named(inner) for inner in part]
        if many[whole] == 1 or len(whole) < MIN_NAMED_LENGTH:
            return rest
        names[whole] = JsCode(f"s{len(names) + 1}")  # short names, because pages carry them
        said[names[whole]] = rest
        return names[whole]

    count(value)
    rest = named(value)
    return said, rest
