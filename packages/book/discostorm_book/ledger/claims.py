"""The ledger of the paper's claims: statements, criteria and computed verdicts."""

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING, Any

import sympy as sp

from discostorm import wording
from discostorm.data import read_data
from discostorm_book.ledger import criteria
from discostorm_book.ledger.criteria import Criterion

if TYPE_CHECKING:
    import pandas as pd

#: Outcomes from the weakest; a figure has the weakest outcome of its claims.
_WEAKEST_FIRST = ("fails", "weaker holds", "holds")
#: The word, the sign and the meaning of each outcome.
VERDICTS = {row["outcome"]: row for row in read_data("paper/verdicts.csv", "discostorm_book")}


@dataclass(frozen=True)
class Claim:
    """A checkable statement of the paper, in our words, from the tables of ``data/paper``."""

    id: int
    key: str
    where: str
    #: A part of the ledger chapter.
    section: str
    statement: str
    #: The outcome that a test compares with `outcome`.
    stated: str
    remark: str
    #: A label in the book where the quantity is derived.
    link: str
    place: str
    #: Criteria of ``claim_tests.csv`` by role; none if nothing in the paper decides the claim.
    criteria: Mapping[str, Criterion]

    @property
    def test(self) -> Criterion | None:
        """The criterion of the claim; None if nothing in the paper decides it."""
        return self.criteria.get("test")

    @property
    def weaker_test(self) -> Criterion | None:
        """The criterion of a weaker reading of the sentence, which counts if the test fails."""
        return self.criteria.get("weaker")

    @property
    def found_at(self) -> str:
        """Where a reader finds the sentence: equation, table or figure, section and paragraph."""
        numbered = self.where.startswith(("Eq.", "Fig.", "Table"))
        return f"{self.where}; {self.place}" if numbered else self.place

    @property
    def tests(self) -> list[Criterion]:
        """The test and the weaker test, if the claim has them."""
        return [test for test in (self.test, self.weaker_test) if test]

    @property
    def reading(self) -> str:
        """Our readings of the vague terms of the statement; empty if it has none."""
        terms = dict.fromkeys(test.word for test in self.tests if test.word)
        return "; ".join(f"we read {term.word}: {term.reading}" for term in terms)

    @property
    def provenance(self) -> str:
        """The kinds of evidence of the tests, such as "computed"; empty without tests."""
        return ", ".join(dict.fromkeys(test.provenance for test in self.tests))

    def outcome(self) -> str:
        """Return the outcome of the tests: holds, weaker holds, fails or no test."""
        if self.test is None:
            return "no test"
        if self.test.holds():
            return "holds"
        return "weaker holds" if self.weaker_test and self.weaker_test.holds() else "fails"

    def verdict(self) -> str:
        """Return the verdict in a word, computed from the tests."""
        return VERDICTS[self.outcome()]["verdict"]

    def sign(self) -> str:
        """Return the sign of the verdict."""
        return VERDICTS[self.outcome()]["sign"]


@dataclass(frozen=True)
class PaperFigure:
    """A figure of the paper, its subject, its stated outcome, and the claims about it, if any."""

    number: str
    what: str
    stated: str
    claims: tuple[Claim, ...]
    label: str

    def outcome(self) -> str:
        """Return the weakest outcome of the claims that have a test."""
        outcomes = [claim.outcome() for claim in self.claims]
        return next((each for each in _WEAKEST_FIRST if each in outcomes), "no test")

    def badge(self) -> str:
        """Return sign and verdict as Markdown, with a link to the figure's claims.

        Examples
        --------
        >>> figures()["1"].badge()
        '? not checkable: a drawing'
        """
        word = VERDICTS[self.outcome()]
        verdict = f"{word['sign']} {word['verdict']}"
        if not self.claims:
            return f"{verdict}: a drawing"
        rows = _join_number_ranges([claim.id for claim in self.claims])
        return f"{verdict} ([rows {rows}](#{self.label}))"

    def caption(self) -> str:
        """Return the figure's verdict in sentences, for the chapter that reproduces the figure."""
        counts = Counter(claim.verdict() for claim in self.claims)
        verdicts = [word["verdict"] for word in VERDICTS.values()]
        parts = [f"{counts[verdict]} {verdict}" for verdict in verdicts if counts[verdict]]
        return (
            f"**Fig. {self.number} of the paper: {self.badge()}.** This is the weakest verdict of "
            f"{len(self.claims)} statements about the figure: {wording.join_words(parts)}."
        )


def _join_number_ranges(numbers: list[int]) -> str:
    """Return ascending numbers as text, with ranges for consecutive ones."""
    starts = [number for number in numbers if number - 1 not in numbers]
    ends = [number for number in numbers if number + 1 not in numbers]
    return ", ".join(
        f"{start}" if start == end else f"{start}\N{EN DASH}{end}"
        for start, end in zip(starts, ends, strict=True)
    )


@cache
def figures() -> dict[str, PaperFigure]:
    """Return the figures of the paper, by their numbers."""
    by_key = {claim.key: claim for claim in claims()}
    found = {}
    for row in read_data("paper/figures.csv", "discostorm_book"):
        number, what, stated, keys, label, _ = row.values()
        about = tuple(by_key[key] for key in keys.split())
        found[number] = PaperFigure(number, what, stated, about, label)
    return found


@cache
def claims() -> tuple[Claim, ...]:
    """Return all claims, in the order of the paper."""
    places = {row["key"]: row["place"] for row in read_data("paper/places.csv", "discostorm_book")}
    found = []
    for number, row in enumerate(read_data("paper/claims.csv", "discostorm_book"), start=1):
        key, where, section, statement, stated, remark, link = row.values()
        by_role = criteria.criteria_by_claim().get(key, {})
        remark, place = _fill_remark(remark, by_role), places[key]
        claim = Claim(number, key, where, section, statement, stated, remark, link, place, by_role)
        found.append(claim)
    return tuple(found)


def _fill_remark(remark: str, by_role: Mapping[str, Criterion]) -> str:
    """Return a remark with its numbers: ``ours``, ``weaker`` and others, each also in µs."""
    if "{" not in remark:
        return remark
    values = {"ours" if role == "test" else role: each.ours() for role, each in by_role.items()}
    numbers = {name: float(value) for name, value in values.items() if sp.sympify(value).is_number}
    return remark.format(**numbers, **{f"{name}_us": 1e6 * n for name, n in numbers.items()})


def ledger() -> "pd.DataFrame":
    """Return the ledger as a table: the `row` of each claim, indexed by id."""
    import pandas as pd

    return pd.DataFrame(map(row, claims())).set_index("id")


def row(claim: Claim) -> dict[str, Any]:
    """Return the row of a claim in `ledger`, with the paper's value, ours and the verdict."""
    head, tail = ("id", "where", "section", "statement", "reading"), ("remark", "link", "place")
    test = claim.test
    return {
        **{name: getattr(claim, name) for name in head},
        "quantity": test.quantity if test else "",
        "paper": test.paper if test else "",
        "ours": test.ours() if test else "",
        "verdict": claim.verdict(),
        "provenance": claim.provenance,
        **{name: getattr(claim, name) for name in tail},
    }


def format_quantity(value: Any) -> str:
    """Return a quantity as text, numbers to four digits."""
    value = exact_quantity(value)
    return value if isinstance(value, str) else f"{value:.4g}"


def exact_quantity(value: Any) -> float | str:
    """Return a quantity as a number with all its digits, an expression as text."""
    if isinstance(value, str):
        return value
    return float(value) if sp.sympify(value).is_number else str(value)


def verdict_counts() -> "pd.DataFrame":
    """Return how many claims got each verdict: one row a verdict, with its meaning."""
    import pandas as pd

    counts = Counter(claim.verdict() for claim in claims())
    rows = [
        (word["verdict"], counts[word["verdict"]], word["meaning"]) for word in VERDICTS.values()
    ]
    return pd.DataFrame(rows, columns=["verdict", "claims", "it means"]).set_index("verdict")
