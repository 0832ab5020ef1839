"""The tests that decide claims: a quantity with its arguments, a relation, the paper's value.

Where the paper has a soft word instead of a number, the test has the word:
``Test(control_share, (DDS, 7, 2, 10), "is", "significant")``. What we read into it stands in
``data/paper/soft_words.csv``, once for each word, and holds for every claim.
"""

import math
import operator
import re
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from typing import Any, Literal, TypeAlias

import sympy as sp

from discostorm import notation as nt, words
from discostorm.data import read_data
from discostorm.messages import Protocol

Relation: TypeAlias = Literal["=", "≈", "<", "≤", ">", "≥", "is", "is not"]

_RELATIONS: dict[str, Callable[[Any, Any], bool]] = {
    "=": lambda ours, paper: bool(sp.cancel(ours - paper).is_zero),
    "<": operator.lt,
    "≤": operator.le,
    ">": operator.gt,
    "≥": operator.ge,
}
_OPPOSITE = {"<": "≥", "≤": ">", ">": "≤", "≥": "<"}
_IN_WORDS = {
    "=": "",
    "≈": "about ",
    "<": "less than ",
    "≤": "at most ",
    ">": "more than ",
    "≥": "at least ",
}
#: A tolerance no larger than this is for the rounding of floating point alone.
_ROUNDING = 1e-9


@dataclass(frozen=True)
class SoftWord:
    """A word that a number can test, and the one threshold that we read into it."""

    word: str
    forms: str
    relation: str
    threshold: float
    reading: str


@cache
def soft_words() -> dict[str, SoftWord]:
    """Return the soft words of the paper, each with what we read into it."""
    return {
        row["word"]: SoftWord(
            row["word"], row["forms"], row["relation"], float(row["threshold"]), row["reading"]
        )
        for row in read_data("paper/soft_words.csv", "discostorm_book")
    }


@cache
def _value(quantity: Callable[..., Any], *arguments: Any) -> Any:
    return quantity(*arguments)


@dataclass(frozen=True)
class Test:
    """What decides a claim: a quantity, a relation, and the paper's value.

    Parameters
    ----------
    function : callable
        What computes the quantity, such as one of `discostorm_book.ledger.quantities`.
    arguments : tuple
        Its arguments.
    relation : str
        One of = ≈ < ≤ > ≥, or "is" and "is not" before a soft word. Without a tolerance ≈ means
        about as much, as far as the word "approximately" goes.
    value : float, sympy.Expr or str
        The paper's value: a number, an expression in its symbols, or a soft word.
    tolerance : float, optional
        How far off ≈ may be.
    """

    function: Callable[..., Any]
    arguments: tuple[Any, ...]
    relation: Relation
    value: Any
    tolerance: float = 0.0

    def ours(self) -> Any:
        """Return the quantity as computed by the package: a number or an expression."""
        return _value(self.function, *self.arguments)

    def holds(self) -> bool:
        """Return whether the relation between our value and the paper's holds."""
        relation, limit = self._limit()
        if relation == "≈":
            about = soft_words()["approximately"].threshold * abs(limit)
            return bool(abs(self.ours() - limit) <= (self.tolerance or about))
        return bool(_RELATIONS[relation](self.ours(), limit))

    def _limit(self) -> tuple[str, Any]:
        """Return the relation to a number, and the number, also of a soft word."""
        if not isinstance(self.value, str):
            return self.relation, self.value
        if self.value not in soft_words():
            raise ValueError(f"word must be one of {', '.join(soft_words())}; got {self.value!r}")
        word = soft_words()[self.value]
        relation = word.relation if self.relation == "is" else _OPPOSITE[word.relation]
        return relation, word.threshold

    @property
    def word(self) -> SoftWord | None:
        """The soft word that it reads, if any."""
        about = self.relation == "≈" and not self.tolerance
        return soft_words().get("approximately" if about else self.value)

    @property
    def quantity(self) -> str:
        """The quantity with its arguments; names have _ for a space."""
        arguments = (_plain(each).replace(" ", "_") for each in self.arguments)
        return " ".join([self.function.__name__, *arguments])

    @property
    def paper(self) -> str:
        """The paper's value, with the relation to it."""
        if isinstance(self.value, str):
            relation, threshold = self._limit()
            return f"{self.relation} {self.value}: {relation} {threshold:g}".removeprefix("is ")
        within = f" ± {_printed(self.tolerance, like=self.value)}" if self.tolerance else ""
        return f"{self.relation} {_printed(self.value)}{within}"

    @property
    def text(self) -> str:
        """The test in a line: ``utilization DDS 10 1 2 ≥ 1``."""
        said = f"{self.relation} {self.value}" if isinstance(self.value, str) else self.paper
        return f"{self.quantity} {said}"

    @property
    def provenance(self) -> str:
        """How the quantity is known: computed, read in sources, simulated or measured."""
        return self._described()["provenance"]

    def _described(self) -> dict[str, str]:
        """Return what the quantity, or which default, is called, its unit and provenance."""
        name = self.function.__name__
        called = f"{name} {self.arguments[-1]}" if name == "default" else name
        (row,) = (
            row
            for row in read_data("paper/quantities.csv", "discostorm_book")
            if row["quantity"] == called
        )
        return row

    def in_words(self) -> str:
        """Return what the test asks and what was found, as Markdown.

        Examples
        --------
        >>> from discostorm_book.ledger.quantities.model import control_saved
        >>> Test(control_saved, (), "is", "significant").in_words()
        'at least 10% of the control messages of DDS saved by Zenoh: 50%'
        """
        unit, template = self._described()["unit"], self._described()["words"]
        relation, value = self._limit()
        limit = _told(value, unit)
        if self.tolerance > _ROUNDING:
            limit += f" ± {_told(self.tolerance, unit)}"
        elif self.tolerance:
            relation, limit = "=", f"{limit} but for rounding"
        names = (each for each in self.arguments if isinstance(each, str))
        said = template.format(
            *map(_named, self.arguments),
            limit=_IN_WORDS[relation] + limit,
            names=" and ".join(_named(each) for each in names if each not in nt.NOTATION),
            swarm=_swarm(*self.arguments[-3:]) if "{swarm}" in template else "",
        )
        found = _told(self.ours(), unit)
        same = found == limit and found.startswith("$")
        return f"{_singular(said)}: {'the same' if same else found}"


def _plain(argument: Any) -> str:
    """Return an argument as text: a protocol by its name."""
    if isinstance(argument, Protocol):
        return argument.name
    return argument if isinstance(argument, str) else f"{argument:g}"


def _printed(value: Any, like: Any = None) -> str:
    """Return a number in thousands and the like, 120e-6; an expression as the paper writes it."""
    if isinstance(value, sp.Expr):
        return _as_written(value)
    size = abs(like or value)
    exponent = 0 if size == 0 or 1e-3 <= size < 1e4 else 3 * math.floor(math.log10(size) / 3)
    return f"{value / 10**exponent:g}" + (f"e{exponent}" if exponent else "")


def _as_written(load: sp.Expr) -> str:
    """Return a load as the paper writes it: hosts first, then processes, then endpoints."""
    products = []
    for term in sp.Add.make_args(load):
        factors = map(str, sp.Mul.make_args(term))
        in_order = sorted(factors, key=lambda text: text.replace("N_E", "N_Z"))
        products.append("*".join(f"({each})" if " " in each else each for each in in_order))
    return " + ".join(sorted(products, key=len))


def _named(argument: Any) -> str:
    """Return an argument of a quantity as a reader knows it."""
    text = _plain(argument)
    if text in nt.NOTATION:
        return f"${sp.latex(nt.NOTATION[text].symbol)}$"
    if text in {"all", "control", "multicast"}:
        return f"{text} messages"
    return text.removesuffix("_message")


def _singular(text: str) -> str:
    """Return a text in which one thing is not many of them."""
    return re.sub(
        r"\b1 (process(?=es\b)|(?:message|session|bit|host|kind|frame)(?=s\b))e?s", r"1 \1", text
    )


def _told(value: Any, unit: str) -> str:
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
    digits = 4 if unit == "rate" else 3
    scaled = float(f"{factor * number:.{digits}g}")
    return f"{scaled:,.10g}{suffix}"


def _swarm(hosts: float, processes: float, endpoints: float) -> str:
    """Return hosts, processes and endpoints in words."""
    return (
        f"{words.many(hosts, 'host')} of {words.many(processes, 'process', 'es')} "
        f"with {words.many(endpoints, 'endpoint')}"
    )
