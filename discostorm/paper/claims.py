"""The ledger of the paper's claims: what each says, what decides it, and the verdict.

The claims stand in ``data/paper/claims.csv``. A claim carries a *test*, such as
``saturation_hosts DDS 2 10 ≈ 7``: a quantity of `quantities` with its arguments, a
relation, and the value that the paper gives. Some carry a *weaker* test as well, what
remains of the same sentence when the first fails. Verdicts are computed from the tests.

A remark may hold a quantity, ``{share DDS unicast 7 2 10|.1%}``, which is filled in.
"""

import re
from collections import Counter
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING, Any, Literal

import sympy as sp

from discostorm.data import read_data
from discostorm.paper.criteria import Criterion, value_of

if TYPE_CHECKING:
    import pandas as pd


Verdict = Literal["reproduced", "qualified", "contradicted", "not checkable"]

VERDICTS: dict[Verdict, str] = {
    "reproduced": "holds as worded",
    "qualified": "holds with the qualification given",
    "contradicted": "does not hold by the paper's own equations",
    "not checkable": "the paper gives nothing to compute it from",
}

_FILLED = re.compile(r"\{(?P<quantity>[^|}]+)\|(?P<spec>[^}]+)\}")


@dataclass(frozen=True)
class Claim:
    """A checkable statement of the paper, in our words.

    Parameters
    ----------
    id : int
        Its number in the ledger, in the order of the paper.
    where : str
        Section, equation, table or figure of the paper.
    section : str
        Section of the ledger chapter in which it is decided.
    statement : str
        What it says.
    test : Criterion or None
        What decides it; None if nothing in the paper does.
    weaker_test : Criterion or None
        What is left of the same sentence if `test` fails.
    remark : str
        The qualification, how it is contradicted, or why it cannot be checked.
    link : str
        Label in the book where the quantity is derived.
    """

    id: int
    where: str
    section: str
    statement: str
    test: Criterion | None
    weaker_test: Criterion | None
    remark: str
    link: str

    @property
    def reading(self) -> str:
        """What we read into the soft words of the statement; empty if it has none."""
        tests = [test for test in (self.test, self.weaker_test) if test]
        words = dict.fromkeys(test.word for test in tests if test.word)
        return "; ".join(f"we read {word.word}: {word.reading}" for word in words)

    @property
    def provenance(self) -> str:
        """How the quantities of its tests are known; empty if it has none."""
        tests = [test for test in (self.test, self.weaker_test) if test]
        return ", ".join(dict.fromkeys(test.provenance for test in tests))

    def verdict(self) -> Verdict:
        """Return the verdict, computed from the tests."""
        if self.test is None:
            return "not checkable"
        if self.test.holds():
            return "reproduced"
        if self.weaker_test is not None and self.weaker_test.holds():
            return "qualified"
        return "contradicted"


@cache
def claims() -> tuple[Claim, ...]:
    """Return all claims, in the order of the paper."""

    def test(text: str) -> Criterion | None:
        return Criterion(text) if text else None

    return tuple(
        Claim(
            int(row["id"]),
            row["where"],
            row["section"],
            row["statement"],
            test(row["test"]),
            test(row["weaker_test"]),
            _FILLED.sub(_fill, row["remark"]),
            row["link"],
        )
        for row in read_data("paper/claims.csv")
    )


def _fill(found: re.Match[str]) -> str:
    """Return a quantity within a remark as text; the format ``µs`` is for seconds."""
    value, spec = float(value_of(found["quantity"])), found["spec"]
    return f"{value * 1e6:.0f} µs" if spec == "µs" else format(value, spec)


def ledger() -> "pd.DataFrame":
    """Return the ledger: one row a claim, with the paper's value, ours and the verdict.

    Returns
    -------
    pandas.DataFrame
        Indexed by id, with columns where, section, statement, reading, quantity, paper, ours,
        verdict, provenance, remark and link.
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


def report(section: str) -> str:
    """Return what decides each claim of a section of the ledger, and the verdict, in words.

    Raises
    ------
    ValueError
        If there is no such section.
    """
    chosen = [claim for claim in claims() if claim.section == section]
    if not chosen:
        known = ", ".join(dict.fromkeys(claim.section for claim in claims()))
        raise ValueError(f"section must be one of {known}; got {section!r}")
    lines = []
    for claim in chosen:
        lines.append(f"{claim.id}. {claim.where}: {claim.statement}")
        if claim.reading:
            lines.append(f"   {claim.reading}")
        for test, kind in ((claim.test, "the paper"), (claim.weaker_test, "weaker")):
            if test:
                lines.append(f"   {test.quantity} is {shown(test.ours())}; {kind}: {test.paper}")
        lines.append(f"   -> {claim.verdict()}")
    return "\n".join(lines)


def verdict_counts() -> "pd.DataFrame":
    """Return how many claims got each verdict: one row a verdict, with its meaning."""
    import pandas as pd

    counts = Counter(claim.verdict() for claim in claims())
    return pd.DataFrame(
        [(verdict, counts[verdict], meaning) for verdict, meaning in VERDICTS.items()],
        columns=["verdict", "claims", "it means"],
    ).set_index("verdict")
