"""The criteria that decide claims: a quantity with its arguments, a relation, the paper's value."""

import operator
import re
from collections import defaultdict
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cache
from typing import Any

import sympy as sp

from discostorm import notation as nt, wording
from discostorm.data import read_data
from discostorm.messages import Protocol
from discostorm.protocols import DDS, ZENOH
from discostorm_book.ledger.quantities import QUANTITIES

_RELATIONS: dict[str, Callable[[Any, Any], bool]] = {
    "=": lambda ours, paper: bool(sp.cancel(ours - paper).is_zero),
    "<": operator.lt,
    "≤": operator.le,
    ">": operator.gt,
    "≥": operator.ge,
}
_OPPOSITE_RELATIONS = {"<": "≥", "≤": ">", ">": "≤", "≥": "<"}
_IN_WORDS = {"≈": "about ", "<": "less than ", "≤": "at most ", ">": "more than ", "≥": "at least "}
#: A tolerance no larger than this is for the rounding of floating point alone.
_ROUNDING = 1e-9
_PAPER = {protocol.name: protocol for protocol in (DDS, ZENOH)}


@dataclass(frozen=True)
class VagueTerm:
    """A vague word of the paper, and the threshold by which we interpret it."""

    word: str
    forms: str
    relation: str
    threshold: float
    reading: str


@cache
def vague_terms() -> dict[str, VagueTerm]:
    """Return the vague terms of the paper by their wording."""
    terms = {}
    for row in read_data("paper/vague_terms.csv", "discostorm_book"):
        word, forms, relation, threshold, reading, *_ = row.values()
        terms[word] = VagueTerm(word, forms, relation, float(threshold), reading)
    return terms


@cache
def _computed_value(function: Callable[..., Any], *arguments: Any) -> Any:
    return function(*arguments)


@dataclass(frozen=True)
class Criterion:
    """A criterion of a claim: a quantity with its arguments, a relation, and the paper's value."""

    function: Callable[..., Any]
    arguments: tuple[Any, ...]
    #: One of = ≈ < ≤ > ≥, or "is" and "is not" before a vague term.
    relation: str
    #: A number, an expression in the paper's symbols, or a vague term.
    value: Any
    #: Maximum difference for ≈; if 0, the threshold of the word "approximately".
    tolerance: float = 0.0
    #: Relation, value and tolerance as the ledger prints them.
    printed: str = field(default="", compare=False)

    def ours(self) -> Any:
        """Return the quantity as computed by the package: a number or an expression."""
        return _computed_value(self.function, *self.arguments)

    def holds(self) -> bool:
        """Return whether the relation between our value and the paper's holds."""
        relation, limit = self._threshold()
        if relation == "≈":
            about = vague_terms()["approximately"].threshold * abs(limit)
            return bool(abs(self.ours() - limit) <= (self.tolerance or about))
        return bool(_RELATIONS[relation](self.ours(), limit))

    def _threshold(self) -> tuple[str, Any]:
        """Return the relation and its number, which a vague term has, too."""
        if not isinstance(self.value, str):
            return self.relation, self.value
        if self.value not in vague_terms():
            raise ValueError(f"word must be one of {', '.join(vague_terms())}; got {self.value!r}")
        term = vague_terms()[self.value]
        relation = term.relation if self.relation == "is" else _OPPOSITE_RELATIONS[term.relation]
        return relation, term.threshold

    @property
    def word(self) -> VagueTerm | None:
        """The vague term that the criterion interprets, if any."""
        about = self.relation == "≈" and not self.tolerance
        return vague_terms().get("approximately" if about else self.value)

    @property
    def quantity(self) -> str:
        """The quantity with its arguments; names have _ for a space."""
        arguments = (_as_text(each).replace(" ", "_") for each in self.arguments)
        return " ".join([self.function.__name__, *arguments])

    @property
    def paper(self) -> str:
        """The paper's value, with the relation to it."""
        if isinstance(self.value, str):
            relation, threshold = self._threshold()
            return f"{self.relation} {self.value}: {relation} {threshold:g}".removeprefix("is ")
        return self.printed

    @property
    def text(self) -> str:
        """The criterion in a line: ``utilization DDS 10 1 2 ≥ 1``."""
        return f"{self.quantity} {self.printed}"

    @property
    def provenance(self) -> str:
        """The kind of evidence: computed, read in sources, simulated or measured."""
        return self._description()["provenance"]

    def _description(self) -> dict[str, str]:
        """Return the words, unit and provenance of the quantity, or of the default that it is."""
        name = self.function.__name__
        if name == "default":
            name = f"{name} {self.arguments[-1]}"
        rows = read_data("paper/quantities.csv", "discostorm_book")
        (row,) = (row for row in rows if row["quantity"] == name)
        return row

    def in_words(self) -> str:
        """Return the question of the criterion and our result, as Markdown.

        Examples
        --------
        >>> Criterion(QUANTITIES["control_saved"], (), "is", "significant").in_words()
        'at least 10% of the control messages of DDS saved by Zenoh: 50%'
        """
        unit, template = self._description()["unit"], self._description()["words"]
        relation, value = self._threshold()
        limit = _with_unit(value, unit)
        if self.tolerance > _ROUNDING:
            limit += f" ± {_with_unit(self.tolerance, unit)}"
        elif self.tolerance:
            relation, limit = "=", f"{limit} but for rounding"
        names = (each for each in self.arguments if isinstance(each, str))
        question = template.format(
            *map(_argument_label, self.arguments),
            limit=_IN_WORDS.get(relation, "") + limit,
            names=" and ".join(_argument_label(each) for each in names if each not in nt.NOTATION),
            swarm=_format_swarm(*self.arguments[-3:]) if "{swarm}" in template else "",
        )
        # Put the noun after a 1 into the singular.
        question = re.sub(
            r"\b1 (process(?=es\b)|(?:message|session|bit|host|kind|frame)(?=s\b))e?s",
            r"1 \1",
            question,
        )
        ours = _with_unit(self.ours(), unit)
        return f"{question}: {'the same' if ours == limit and ours.startswith('$') else ours}"


@cache
def criteria_by_claim() -> Mapping[str, dict[str, Criterion]]:
    """Return the criteria of each claim, and the numbers of its remark, by their roles."""
    criteria: dict[str, dict[str, Criterion]] = defaultdict(dict)
    for row in read_data("paper/claim_tests.csv", "discostorm_book"):
        relation, value, tolerance = row["relation"], row["value"], row["tolerance"]
        criteria[row["claim"]][row["role"]] = Criterion(
            QUANTITIES[row["quantity"]],
            tuple(map(_parse_argument, row["arguments"].split("; "))) if row["arguments"] else (),
            relation,
            value if relation in ("is", "is not", "") else _parse_number(value),
            float(tolerance or 0),
            f"{relation} {value}" + (f" ± {tolerance}" if tolerance else ""),
        )
    return criteria


def _parse_argument(text: str) -> Any:
    """Return an argument from the table: a number, a protocol of the paper, or text."""
    return _parse_number(text) if re.fullmatch(r"[\d.]+", text) else _PAPER.get(text, text)


def _parse_number(text: str) -> Any:
    """Return a number, or an expression in the symbols of the paper."""
    if "N_" in text:
        return sp.sympify(text, {name: entry.symbol for name, entry in nt.NOTATION.items()})
    return int(text) if text.isdigit() else float(text)


def _as_text(argument: Any) -> str:
    """Return an argument as text: a protocol by its name."""
    if isinstance(argument, Protocol):
        return argument.name
    return argument if isinstance(argument, str) else f"{argument:g}"


def _argument_label(argument: Any) -> str:
    """Return an argument of a quantity in the words of the page."""
    text = _as_text(argument)
    if text in nt.NOTATION:
        return f"${sp.latex(nt.NOTATION[text].symbol)}$"
    if text in {"all", "control", "multicast"}:
        return f"{text} messages"
    return text.removesuffix("_message")


def _with_unit(value: Any, unit: str) -> str:
    """Return a value in its unit, to three digits; an expression as LaTeX."""
    if unit == "expression" or not sp.sympify(value).is_number:
        return f"${sp.latex(sp.factor(value))}$"
    number = float(value)
    if unit == "switch":
        return "on" if number else "off"
    if unit == "saving" and number < 0:
        return f"none, it takes {1 - number:.3g} times as much"
    factor, suffix = {
        "percent": (100, "%"),
        "saving": (100, "%"),
        "second": (1, " s") if number >= 10 else (100, "%"),
        "bytes": (1, " B"),
        "rate": (1e-6, " Mbit/s"),
        "time": (1e6, " µs"),
    }.get(unit, (1, ""))
    scaled = float(f"{factor * number:.{4 if unit == 'rate' else 3}g}")
    return f"{scaled:,.10g}{suffix}"


def _format_swarm(hosts: float, processes: float, endpoints: float) -> str:
    """Return hosts, processes and endpoints in words."""
    return (
        f"{wording.count_noun(hosts, 'host')} of {wording.count_noun(processes, 'process', 'es')} "
        f"with {wording.count_noun(endpoints, 'endpoint')}"
    )
