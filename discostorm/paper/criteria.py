"""The tests that decide claims: a quantity with its arguments, a relation, the paper's value.

Where the paper has a soft word instead of a number, the test has the word:
``control_share DDS 7 2 10 is significant``. What we read into it stands in
``data/paper/soft_words.csv``, once for each word, and holds for every claim.
"""

import operator
import re
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from typing import Any

import sympy as sp

from discostorm import notation as nt, words
from discostorm.data import read_data
from discostorm.paper.quantities import QUANTITIES
from discostorm.protocols import DDS, ZENOH

_PROTOCOLS = {"DDS": DDS, "Zenoh": ZENOH}
_SYMBOLS = {name: quantity.symbol for name, quantity in nt.NOTATION.items()}

_RELATIONS: dict[str, Callable[[Any, Any], bool]] = {
    "=": lambda ours, paper: bool(sp.cancel(ours - paper).is_zero),
    "<": operator.lt,
    "≤": operator.le,
    ">": operator.gt,
    "≥": operator.ge,
}
_TEST = re.compile(
    r"(?P<quantity>\w+)(?P<arguments>.*) "
    r"((?P<relation>[=≈<≤>≥]) (?P<paper>.+?)( ± (?P<tolerance>.+))?"
    r"|is (?P<negated>not )?(?P<word>[\w-]+))"
)
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


def _argument(word: str) -> Any:
    if word in _PROTOCOLS:
        return _PROTOCOLS[word]
    try:
        return float(word)
    except ValueError:
        return word


def _printed(text: str) -> Any:
    """Return a value of the paper: a number, or an expression in its symbols."""
    try:
        return float(text)
    except ValueError:
        return sp.sympify(text, locals=_SYMBOLS)


@cache
def value_of(quantity: str) -> Any:
    """Return a quantity, given by its name and arguments."""
    name, *arguments = quantity.split()
    if name not in QUANTITIES:
        raise ValueError(f"quantity must be one of {', '.join(QUANTITIES)}; got {name!r}")
    return QUANTITIES[name](*map(_argument, arguments))


@cache
def _quantity_words(quantity: str) -> dict[str, str]:
    """Return what a quantity, or which default, is called, its unit, and how it is known."""
    name, *arguments = quantity.split()
    called = f"{name} {arguments[-1]}" if name == "default" else name
    (row,) = (row for row in read_data("paper/quantities.csv") if row["quantity"] == called)
    return row


def _named(argument: str) -> str:
    """Return an argument of a quantity as a reader knows it."""
    if argument in _SYMBOLS:
        return f"${sp.latex(_SYMBOLS[argument])}$"
    if argument in {"all", "control", "multicast"}:
        return f"{argument} messages"
    return argument.removesuffix("_message").replace("_", " ")


def _singular(text: str) -> str:
    """Return a text in which one thing is not many of them."""
    return re.sub(
        r"\b1 (process(?=es\b)|(?:variable|message|bit|host|kind|frame)(?=s\b))e?s", r"1 \1", text
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


def _swarm(counts: list[str]) -> str:
    """Return hosts, processes and endpoints in words; nothing if these are not they."""
    try:
        hosts, processes, endpoints = map(float, counts)
    except ValueError:
        return ""
    return (
        f"{words.many(hosts, 'host')} of {words.many(processes, 'process', 'es')} "
        f"with {words.many(endpoints, 'endpoint')}"
    )


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
        for row in read_data("paper/soft_words.csv")
    }


def _soft_word(word: str) -> SoftWord:
    if word not in soft_words():
        raise ValueError(f"word must be one of {', '.join(soft_words())}; got {word!r}")
    return soft_words()[word]


@dataclass(frozen=True)
class Criterion:
    """What decides a claim: a quantity, a relation, and the paper's value.

    The value may be a soft word instead, ``is marginal`` or ``is not dominant``, and
    ``≈ 7`` without a tolerance is about 7, as far as the word "approximately" goes.
    """

    text: str

    def _part(self, name: str) -> str:
        match = _TEST.fullmatch(self.text)
        if match is None:
            raise ValueError(
                "test must read 'quantity arguments relation value' or 'quantity arguments is "
                f"word'; got {self.text!r}"
            )
        return match[name] or ""

    @property
    def word(self) -> SoftWord | None:
        """The soft word that it reads, if any."""
        if self._part("relation") == "≈" and not self._part("tolerance"):
            return _soft_word("approximately")
        return _soft_word(self._part("word")) if self._part("word") else None

    @property
    def paper(self) -> str:
        """The paper's value, with the relation to it."""
        if self._part("word"):
            word = _soft_word(self._part("word"))
            relation = _OPPOSITE[word.relation] if self._part("negated") else word.relation
            return f"{self._part('negated')}{word.word}: {relation} {word.threshold:g}"
        return self.text[self.text.index(f" {self._part('relation')} ") + 1 :]

    @property
    def quantity(self) -> str:
        """The quantity with its arguments."""
        return self._part("quantity") + self._part("arguments")

    def in_words(self) -> str:
        """Return what the test asks and what was found, as Markdown.

        Examples
        --------
        >>> Criterion("control_saved is significant").in_words()
        'at least 10% of the control messages of DDS saved by Zenoh: 50%'
        """
        _, *arguments = self.quantity.split()
        row = _quantity_words(self.quantity)
        word = self.word
        relation = self._part("relation") or (word.relation if word else "")
        if self._part("negated"):
            relation = _OPPOSITE[relation]
        paper = self._part("paper") or (f"{word.threshold:g}" if word else "")
        limit = _told(sp.sympify(paper, locals=_SYMBOLS), row["unit"])
        if tolerance := self._part("tolerance"):
            within = sp.sympify(tolerance)
            if within > _ROUNDING:
                limit += f" ± {_told(within, row['unit'])}"
            else:
                relation, limit = "=", f"{limit} but for rounding"
        said = row["words"].format(
            *map(_named, arguments),
            limit=_IN_WORDS[relation] + limit,
            names=" and ".join(
                _named(each) for each in arguments if each not in {*_PROTOCOLS, *_SYMBOLS}
            ),
            swarm=_swarm(arguments[-3:]),
        )
        found = _told(self.ours(), row["unit"])
        same = found == limit and found.startswith("$")
        return f"{_singular(said)}: {'the same' if same else found}"

    @property
    def provenance(self) -> str:
        """How the quantity is known: computed, read in sources, simulated or measured."""
        return _quantity_words(self.quantity)["provenance"]

    def ours(self) -> Any:
        """Return the quantity as computed by the package: a number or an expression."""
        return value_of(self.quantity)

    def holds(self) -> bool:
        """Return whether the relation between our value and the paper's holds."""
        ours = self.ours()
        if self._part("word"):
            word = _soft_word(self._part("word"))
            found = _RELATIONS[word.relation](ours, word.threshold)
            return bool(found) is not bool(self._part("negated"))
        paper = _printed(self._part("paper"))
        if self._part("relation") == "≈":
            about = _soft_word("approximately").threshold * abs(paper)
            return bool(abs(ours - paper) <= float(self._part("tolerance") or about))
        return bool(_RELATIONS[self._part("relation")](ours, paper))
