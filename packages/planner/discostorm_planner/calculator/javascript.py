"""Python data and sympy expressions as JavaScript; what occurs more than once is said once."""

import json
from collections import Counter

import sympy as sp

from discostorm._numeric import cse_keep_rounding

#: Characters from which on it is worth a name.
SHORT = 16


class Code(str):
    """JavaScript itself, such as a function; any other text is data."""

    __slots__ = ()


#: Code, or what JSON can hold; infinite numbers, too.
Value = Code | str | float | bool | None | dict[str, "Value"] | list["Value"]


def javascript_of(expression: sp.Expr) -> Code:
    """Return an expression as a JavaScript function of an object that holds its symbols."""
    names = ", ".join(sorted(symbol.name for symbol in expression.free_symbols))
    shared, rest = cse_keep_rounding(sp.sympify(expression))
    lines = [f"const {symbol} = {sp.jscode(part)};" for symbol, part in shared]
    return Code(" ".join([f"({{ {names} }}) => {{", *lines, f"return {sp.jscode(rest)}; }}"]))


class Formulas:
    """The distinct formulas, each with a name that says what it is."""

    def __init__(self) -> None:
        self.names: dict[Code, str] = {}

    def name(self, expression: sp.Expr, hint: str) -> str:
        """Return the name of an expression."""
        code = javascript_of(expression)
        if code not in self.names:
            same = sum(name.rstrip("0123456789") == hint for name in self.names.values())
            self.names[code] = f"{hint}{same + 1}" if same else hint
        return self.names[code]

    def code(self) -> dict[str, Value]:
        """Return all of them by their names."""
        return {name: code for code, name in self.names.items()}


def leaf(value: object) -> str:
    """Return a text or a number as JavaScript, whole numbers without a point."""
    if isinstance(value, Code):
        return value
    if isinstance(value, (float, sp.Expr)):
        if value == sp.oo:
            return "Infinity"
        value = int(value) if float(value).is_integer() and value < 1e15 else float(value)
    return json.dumps(value, ensure_ascii=False)


def written(value: Value) -> str:
    """Return nested data as JavaScript, one entry a line where it is long."""
    if isinstance(value, dict):
        entries = [f"{leaf(key)}: {written(part)}" for key, part in value.items()]
        braces = "{}"
    elif isinstance(value, list):
        entries, braces = [written(part) for part in value], "[]"
    else:
        return leaf(value)
    line = ", ".join(entries)
    if len(line) < 300 and "\n" not in line:
        return f"{braces[0]}{line}{braces[1]}"
    return "\n".join([braces[0], *(f"{entry}," for entry in entries), braces[1]])


def said_once(value: Value) -> tuple[dict[str, Value], Value]:
    """Return what occurs more than once, by a name that stands for it, and the rest.

    A later one may stand on earlier ones. Short ones stay where they are.
    """
    many = Counter[str]()

    def count(part: Value) -> None:
        many[written(part)] += 1
        if many[written(part)] == 1 and isinstance(part, (dict, list)):
            for inner in part.values() if isinstance(part, dict) else part:
                count(inner)

    names: dict[str, Code] = {}
    said: dict[str, Value] = {}

    def named(part: Value) -> Value:
        whole = written(part)
        if whole in names:
            return names[whole]
        rest = part
        if isinstance(part, dict):
            rest = {key: named(inner) for key, inner in part.items()}
        elif isinstance(part, list):
            rest = [named(inner) for inner in part]
        if many[whole] == 1 or len(whole) < SHORT:
            return rest
        names[whole] = Code(f"s{len(names) + 1}")  # short: pages carry them
        said[names[whole]] = rest
        return names[whole]

    count(value)
    rest = named(value)
    return said, rest
