"""The ledger of the paper's claims: what each says, what decides it, and the verdict.

``data/paper/claims.csv`` says of each claim, by a key, where the paper makes it, in our words,
and which outcome of its tests we state; its remark has places for what was computed.
``data/paper/places.csv`` says in which paragraph the paper makes it. The tests
are in `predicates`, by the same key: verdicts are computed from them. What an outcome is called
stands in ``data/paper/verdicts.csv``. A figure of the paper has the weakest verdict of the claims
about it, which ``data/paper/figures.csv`` lists.
"""

from collections import Counter
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING, Any, Literal

import sympy as sp

from discostorm import words
from discostorm.data import read_data
from discostorm_book.ledger.claim_tests import NUMBERS, TESTS, WEAKER
from discostorm_book.ledger.criteria import Test

if TYPE_CHECKING:
    import pandas as pd

#: What tests can say of a claim.
Outcome = Literal["holds", "weaker holds", "fails", "no test"]

#: What a figure is as good as: the first of these that one of its claims has.
_WEAKEST_FIRST: tuple[Outcome, ...] = ("fails", "weaker holds", "holds")

#: The word, the sign and the meaning of each outcome.
VERDICTS = {row["outcome"]: row for row in read_data("paper/verdicts.csv", "discostorm_book")}


@dataclass(frozen=True)
class Claim:
    """A checkable statement of the paper, in our words.

    Parameters
    ----------
    id : int
        Its number in the ledger, in the order of the paper.
    key : str
        What `predicates` knows it by.
    where : str
        Section, equation, table or figure of the paper.
    section : str
        Section of the ledger chapter in which it is decided.
    statement : str
        What it says.
    stated : str
        The outcome that the ledger states; a test compares it with `outcome`.
    test : Test or None
        What decides it; None if nothing in the paper does.
    weaker_test : Test or None
        What is left of the same sentence if `test` fails.
    remark : str
        The qualification, how it is contradicted, or why it cannot be checked.
    link : str
        Label in the book where the quantity is derived.
    place : str
        Paragraph of the paper, or sentence of its abstract, that says it.
    """

    id: int
    key: str
    where: str
    section: str
    statement: str
    stated: str
    test: Test | None
    weaker_test: Test | None
    remark: str
    link: str
    place: str

    @property
    def found_at(self) -> str:
        """Where a reader finds the sentence: equation, table or figure, section and paragraph."""
        numbered = self.where.startswith(("Eq.", "Fig.", "Table"))
        return f"{self.where}; {self.place}" if numbered else self.place

    @property
    def tests(self) -> list[Test]:
        """What decides it: none, one, or one and what is weaker."""
        return [test for test in (self.test, self.weaker_test) if test]

    @property
    def reading(self) -> str:
        """What we read into the soft words of the statement; empty if it has none."""
        words = dict.fromkeys(test.word for test in self.tests if test.word)
        return "; ".join(f"we read {word.word}: {word.reading}" for word in words)

    @property
    def provenance(self) -> str:
        """How the quantities of its tests are known; empty if it has none."""
        return ", ".join(dict.fromkeys(test.provenance for test in self.tests))

    def outcome(self) -> Outcome:
        """Return what its tests say."""
        if self.test is None:
            return "no test"
        if self.test.holds():
            return "holds"
        if self.weaker_test is not None and self.weaker_test.holds():
            return "weaker holds"
        return "fails"

    def verdict(self) -> str:
        """Return the verdict in a word, computed from the tests."""
        return VERDICTS[self.outcome()]["verdict"]

    def sign(self) -> str:
        """Return the sign of the verdict."""
        return VERDICTS[self.outcome()]["sign"]


@dataclass(frozen=True)
class Figure:
    """A figure of the paper, with the claims about it.

    Parameters
    ----------
    number : str
        Its number in the paper.
    what : str
        What it shows.
    stated : str
        The outcome that the book states as its badge; a test compares it with `outcome`.
    claims : tuple of Claim
        The claims about it; none of a drawing.
    label : str
        Label in the book of their section in the ledger; empty if there are none.
    """

    number: str
    what: str
    stated: str
    claims: tuple[Claim, ...]
    label: str

    def outcome(self) -> Outcome:
        """Return the weakest outcome of its claims, of those that have a test."""
        found = [claim.outcome() for claim in self.claims]
        return next((each for each in _WEAKEST_FIRST if each in found), "no test")

    def badge(self) -> str:
        """Return sign and verdict, and where its claims are, as Markdown.

        Examples
        --------
        >>> figures()["1"].badge()
        '? not checkable: a drawing'
        """
        word = VERDICTS[self.outcome()]
        said = f"{word['sign']} {word['verdict']}"
        if not self.claims:
            return f"{said}: a drawing"
        return f"{said} ([rows {_listed(self.claims)}](#{self.label}))"

    def caption(self) -> str:
        """Return the badge in sentences, for the chapter that makes the figure again."""
        counts = Counter(claim.verdict() for claim in self.claims)
        found = [
            f"{counts[word['verdict']]} {word['verdict']}"
            for word in VERDICTS.values()
            if counts[word["verdict"]]
        ]
        return (
            f"**Fig. {self.number} of the paper: {self.badge()}.** This is the weakest verdict of "
            f"{len(self.claims)} statements about the figure: {words.listed(found)}."
        )


def _listed(claims: tuple[Claim, ...]) -> str:
    """Return the numbers of claims, those that follow each other as a range."""
    runs: list[list[int]] = []
    for claim in claims:
        if runs and claim.id == runs[-1][-1] + 1:
            runs[-1].append(claim.id)
        else:
            runs.append([claim.id])
    return ", ".join(
        f"{run[0]}\N{EN DASH}{run[-1]}" if len(run) > 1 else f"{run[0]}" for run in runs
    )


@cache
def figures() -> dict[str, Figure]:
    """Return the figures of the paper, by their numbers."""
    by_key = {claim.key: claim for claim in claims()}
    return {
        row["figure"]: Figure(
            row["figure"],
            row["what"],
            row["outcome"],
            tuple(by_key[key] for key in row["claims"].split()),
            row["label"],
        )
        for row in read_data("paper/figures.csv", "discostorm_book")
    }


@cache
def claims() -> tuple[Claim, ...]:
    """Return all claims, in the order of the paper."""
    places = {row["key"]: row["place"] for row in read_data("paper/places.csv", "discostorm_book")}
    return tuple(
        Claim(
            number,
            row["key"],
            row["where"],
            row["section"],
            row["statement"],
            row["outcome"],
            TESTS.get(row["key"]),
            WEAKER.get(row["key"]),
            _remark(row["key"], row["remark"]),
            row["link"],
            places[row["key"]],
        )
        for number, row in enumerate(read_data("paper/claims.csv", "discostorm_book"), start=1)
    )


def _remark(key: str, template: str) -> str:
    """Return a remark with its numbers: what the tests found, also in µs, and others."""
    if "{" not in template:
        return template
    numbers = NUMBERS[key]() if key in NUMBERS else {}
    for name, tests in {"ours": TESTS, "weaker": WEAKER}.items():
        if key in tests and sp.sympify(tests[key].ours()).is_number:
            numbers[name] = float(tests[key].ours())
            numbers[f"{name}_us"] = 1e6 * numbers[name]
    return template.format(**numbers)


def ledger() -> "pd.DataFrame":
    """Return the ledger: one row a claim, with the paper's value, ours and the verdict.

    Returns
    -------
    pandas.DataFrame
        Indexed by id, with columns where, section, statement, reading, quantity, paper, ours,
        verdict, provenance, remark, link and place.
    """
    import pandas as pd

    return pd.DataFrame(map(row, claims())).set_index("id")


def row(claim: Claim) -> dict[str, Any]:
    """Return the row of a claim in `ledger`, its id included."""
    return {
        "id": claim.id,
        "where": claim.where,
        "section": claim.section,
        "statement": claim.statement,
        "reading": claim.reading,
        "quantity": claim.test.quantity if claim.test else "",
        "paper": claim.test.paper if claim.test else "",
        "ours": claim.test.ours() if claim.test else "",
        "verdict": claim.verdict(),
        "provenance": claim.provenance,
        "remark": claim.remark,
        "link": claim.link,
        "place": claim.place,
    }


def shown(value: Any) -> str:
    """Return a quantity as a reader wants it: numbers to four digits."""
    found = exact(value)
    return found if isinstance(found, str) else f"{found:.4g}"


def exact(value: Any) -> float | str:
    """Return a quantity as a machine wants it: a number with all its digits, or as text."""
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
