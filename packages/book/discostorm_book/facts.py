"""Facts of a chapter: values that a cell computes, and the text below it states in order."""

import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from IPython.display import display

from discostorm.data import read_data

_PACKAGE = "discostorm_book"
#: The key of an output's metadata that has the values, with all digits that matter.
KEY = "discostorm_facts"

_SCALES = {row["unit"]: float(row["factor"]) for row in read_data("facts/units.csv", _PACKAGE)}
#: Numbers in words, which may state a fact or not; "one" hardly ever does.
NUMBER_WORDS = {row["word"]: float(row["number"]) for row in read_data("facts/words.csv", _PACKAGE)}

#: Text with digits that states no result: code, formulas, links, names, numbers of sections.
_NOT_A_RESULT = re.compile(
    r"""
    ^```.*?^```            # code and directives
    | ^:{4,}\{.*$          # and what they are given
    | ^\$\$.*?^\$\$ .*?$   # formulas
    | `[^`\n]*`            # code, roles
    | \$[^$\n]+\$
    | (?<=\])\([^)\s]*\)   # where a link leads to
    | https?://\S+
    | ^\([\w-]+\)=$        # anchors
    | ^\s*\d+\.\s          # numbers of a list
    | \*\*\d+\.\*\*        # and of an exercise
    | <!--.*?-->
    | \b(?:[Cc]hapters?|[Ee]quations?|[Ss]ections?|[Ff]igures?|[Tt]ables?|[Pp]arts?|[Rr]ows?)
      \s\(?[\dIVX]+[\w.-]*\)?(?:(?:,\s|\sto\s|\sand\s|\N{EN DASH})\(?\d+\)?(?!\.?\d))*
    | (?:[Ff]igs?\.|Sec\.|Eqs?\.)
      \s\(?[\dIVX]+[\w.-]*\)?(?:(?:,\s|\sto\s|\sand\s|\N{EN DASH})\(?\d+\)?(?!\.?\d))*
    | \(\d{1,2}\)          # number of an equation
    | \[\d+\]              # of a reference
    | \bROS\s2\b | \bTurtleBot\s4\b | \bhost\s\d\b | 802\.11\w* | \b\d+x\d+\b
    | \b(?:version|versions|DDS|Zenoh|ns-3|Python)\s\d+(?:\.\d+)+
    | \b\d+\.\d+\.\d+\b
    | \b(?:19|20)\d\d\b(?=[-.,)\s])
    """,
    re.VERBOSE | re.MULTILINE | re.DOTALL,
)
_NUMERAL = re.compile(r"(?<![\w.,/^-])(?:\d{1,3}(?:,\d{3})+|\d+)(?:\.\d+)?(?![\w]|\.\d)")
_UNIT = re.compile(rf"[\s\N{{NO-BREAK SPACE}}]?({'|'.join(map(re.escape, _SCALES))})(?!\w)")
_RANGE = re.compile(r"(?:\N{EN DASH}| to | and | or |, | of )(?=\d)")
_WORD = re.compile(rf"\b({'|'.join(NUMBER_WORDS)})\b", re.IGNORECASE)
_ABOUT = re.compile(r"(?:about|some|roughly|nearly|almost|around)\s$", re.IGNORECASE)


@dataclass(frozen=True)
class Numeral:
    """A number of a text, its value, and by how much it may be off for its digits."""

    start: int
    end: int
    text: str
    value: float
    tolerance: float
    #: Words such as "two" may state a fact or not.
    optional: bool = False

    def states(self, fact: float) -> bool:
        """Return whether this is the fact, rounded."""
        return abs(fact - self.value) <= self.tolerance * (1 + 1e-9)


def facts(of: str = "", **values: Any) -> None:
    """Keep SI values that the text below must state, or the paragraph that begins with `of`."""
    shown = [f"{name.replace('_', ' ')} {float(value):.4g}" for name, value in values.items()]
    # Ten digits hide the last bit, which differs between processors. JSON has several ways to write
    # a number, so the values are kept as text.
    kept = [[name, f"{float(value):.10g}"] for name, value in values.items()]
    display({"text/plain": ", ".join(shown)}, raw=True, metadata={KEY: {"of": of, "values": kept}})


def numerals(text: str) -> list[Numeral]:
    """Return the numbers of a text that state something, in its order."""
    open_text = _NOT_A_RESULT.sub(lambda match: " " * len(match[0]), text)
    numbers = []
    for match in _NUMERAL.finditer(open_text):
        scale = _unit_factor(open_text, match.end())
        digits = match[0].replace(",", "")
        decimals = len(digits.partition(".")[2])
        step = 10.0**-decimals
        if not decimals and _ABOUT.search(open_text[: match.start()]):
            step = 10.0 ** (len(digits) - len(digits.rstrip("0")))
        value, tolerance = float(digits) * scale, step / 2 * scale
        numbers.append(Numeral(*match.span(), match[0], value, tolerance))
    for match in _WORD.finditer(open_text):
        value = NUMBER_WORDS[match[0].lower()]
        tolerance = 0.05 if value < 1 else 0.5
        numbers.append(Numeral(*match.span(), match[0], value, tolerance, optional=True))
    return sorted(numbers, key=lambda numeral: numeral.start)


def _unit_factor(text: str, end: int) -> float:
    """Return the factor of the unit behind a number; both ends of a range share one."""
    if unit := _UNIT.match(text, end):
        return _SCALES[unit[1]]
    if (more := _RANGE.match(text, end)) and (other := _NUMERAL.match(text, more.end())):
        return _unit_factor(text, other.end())
    return 1.0


def first_mismatch(text: str, values: Mapping[str, float]) -> str | None:
    """Return the first place where a text and its facts disagree; None if they agree."""
    numbers, names, kept = numerals(text), list(values), list(values.values())
    furthest = (0, 0)

    def fits(index: int, used: int) -> bool:
        nonlocal furthest
        furthest = max(furthest, (used, index))
        if index == len(numbers):
            return used == len(kept)
        numeral = numbers[index]
        if used < len(kept) and numeral.states(kept[used]) and fits(index + 1, used + 1):
            return True
        if any(numeral.states(fact) for fact in kept[:used]) and fits(index + 1, used):
            return True
        return numeral.optional and fits(index + 1, used)

    if fits(0, 0):
        return None
    used, index = furthest
    rest = ", ".join(f"{name} = {values[name]:.6g}" for name in names[used:])
    if index == len(numbers):
        return f"the text does not state {rest}"
    numeral = numbers[index]
    context = text[max(0, numeral.start - 60) : numeral.end + 30].replace("\n", " ")
    wanted = f"the next facts are {rest}" if rest else "no fact is left"
    return f"{numeral.text!r} in “…{context}…”: {wanted}"
