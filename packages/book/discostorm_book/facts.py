"""Facts of a chapter: values that a cell computes, and the text below it states in order."""

import json
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from IPython.display import display

#: The key of an output's metadata that has the values, with all digits that matter.
KEY = "discostorm_facts"

_SCALES = {
    "%": 0.01, "ms": 1e-3, "µs": 1e-6, "ns": 1e-9, "kB": 1e3, "kbit/s": 1e3, "Mbit/s": 1e6,
    "MHz": 1e6, "GHz": 1e9, "million": 1e6,
}  # fmt: skip
_UP_TO_TWENTY = (
    "two three four five six seven eight nine ten eleven twelve thirteen fourteen fifteen sixteen "
    "seventeen eighteen nineteen twenty"
)
#: Numbers in words, which may state a fact or not; "one" hardly ever does.
NUMBER_WORDS = {word: float(n) for n, word in enumerate(_UP_TO_TWENTY.split(), start=2)} | {
    "half": 0.5, "twice": 2.0, "thirty": 30.0, "fifty": 50.0, "hundred": 100.0, "thousand": 1000.0
}  # fmt: skip

#: Text with digits that states no result: code, formulas, links, names, numbers of sections.
_APART = re.compile(
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
    slack: float
    #: Words such as "two" may state a fact or not.
    optional: bool = False

    def states(self, fact: float) -> bool:
        """Return whether this is the fact, rounded."""
        return abs(fact - self.value) <= self.slack * (1 + 1e-9)


def facts(of: str = "", **values: Any) -> None:
    """Keep values in SI units for the text below to state; `of` begins a paragraph elsewhere."""
    shown = [f"{name.replace('_', ' ')} {float(value):.4g}" for name, value in values.items()]
    # Ten digits hide a last bit, which differs between processors. As text, because
    # there is more than one way to write a number in JSON.
    kept = [[name, f"{float(value):.10g}"] for name, value in values.items()]
    metadata = {KEY: {"of": of, "values": kept}}
    display({"text/plain": ", ".join(shown)}, raw=True, metadata=metadata)


def numerals(text: str) -> list[Numeral]:
    """Return the numbers of a text that state something, in its order."""
    open_text = _APART.sub(lambda match: " " * len(match[0]), text)
    numbers = []
    for match in _NUMERAL.finditer(open_text):
        scale = _unit_factor(open_text, match.end())
        digits = match[0].replace(",", "")
        decimals = len(digits.partition(".")[2])
        step = 10.0**-decimals
        if not decimals and _ABOUT.search(open_text[: match.start()]):
            step = 10.0 ** (len(digits) - len(digits.rstrip("0")))
        value, slack = float(digits) * scale, step / 2 * scale
        numbers.append(Numeral(*match.span(), match[0], value, slack))
    for match in _WORD.finditer(open_text):
        value = NUMBER_WORDS[match[0].lower()]
        slack = 0.05 if value < 1 else 0.5
        numbers.append(Numeral(*match.span(), match[0], value, slack, optional=True))
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


@dataclass(frozen=True)
class Paragraphs:
    """Markdown of a notebook, with the facts that it states; None where no cell has any."""

    cells: tuple[int, ...]
    text: str
    values: Mapping[str, float] | None


def _facts_in_cell(cell: Mapping[str, Any]) -> list[Mapping[str, Any]]:
    return [
        {"of": kept["of"], "values": {name: float(value) for name, value in kept["values"]}}
        for output in cell.get("outputs", [])
        if (kept := output.get("metadata", {}).get(KEY))
    ]


def paragraphs(cells: Sequence[Mapping[str, Any]]) -> list[Paragraphs]:
    """Return the Markdown of a notebook, each piece with the facts that are for it."""
    named = {
        kept["of"]: kept["values"] for cell in cells for kept in _facts_in_cell(cell) if kept["of"]
    }
    pieces: list[tuple[list[int], list[str], Mapping[str, float] | None]] = [([], [], None)]
    for index, cell in enumerate(cells):
        if cell["cell_type"] != "markdown":
            pieces += [([], [], kept["values"]) for kept in _facts_in_cell(cell) if not kept["of"]]
            continue
        for text in re.split(r"\n{2,}", "".join(cell["source"])):
            start = next((of for of in named if text.startswith(of)), None)
            if start is None:
                pieces[-1][0].append(index)
                pieces[-1][1].append(text)
            else:
                pieces.insert(-1, ([index], [text], named[start]))
    return [
        Paragraphs(tuple(dict.fromkeys(where)), "\n\n".join(texts), values)
        for where, texts, values in pieces
    ]


def disagreements(cells: Sequence[Mapping[str, Any]]) -> list[str]:
    """Return where the text of a notebook and its facts disagree."""
    texts = ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "markdown"]
    problems = [
        f"no paragraph begins with {kept['of']!r}"
        for cell in cells
        for kept in _facts_in_cell(cell)
        if not any(re.search(rf"^{re.escape(kept['of'])}", text, re.MULTILINE) for text in texts)
    ]
    for piece in paragraphs(cells):
        if problem := first_mismatch(piece.text, piece.values or {}):
            where = ", ".join(map(str, piece.cells))
            problems.append(f"cell {where or 'of facts'}: {problem}")
    return problems


def has_facts(cells: Sequence[Mapping[str, Any]]) -> bool:
    """Return whether a notebook keeps facts."""
    return any(_facts_in_cell(cell) for cell in cells)


def read_cells(path: Path) -> list[dict[str, Any]]:
    """Return the cells of a notebook."""
    return list(json.loads(path.read_text(encoding="utf-8"))["cells"])
