"""The ledger of claims: verdicts are computed, and stay what they are."""

import re
from dataclasses import replace
from pathlib import Path

import pytest

from discostorm import claims, messages

ROOT = Path(__file__).parents[1]

# Held here on purpose: the verdicts that a reader may quote. By what is claimed, in a few words.
EXPECTED = {
    "exponentially": "contradicted",
    "relies on periodic multicasting": "contradicted",
    "tens of robots inevitably": "qualified",
    "root cause": "contradicted",
    "comparison with DDS is fair": "contradicted",
    "single host grows with the square": "contradicted",
    "pairing of two processes": "qualified",
    "two control messages to keep a link": "qualified",
    "is MCS 7": "qualified",
    "conservative choice": "qualified",
    "O_multi is about 120": "qualified",
    "O_uni is about 180": "qualified",
    "as printed": "qualified",
    "lower bound of the airtime": "qualified",
    "slightly more efficient": "qualified",
    "with few endpoints and with many": "qualified",
    "gap between DDS and Zenoh is marginal": "qualified",
    "DDS saturates at approximately 7": "reproduced",
    "Zenoh saturates at approximately 8": "reproduced",
    "carries one host more": "contradicted",
    "Scouting costs more than DDS SPDP": "qualified",
    "above all the SEDP messages": "contradicted",
    "SEDP alone exceeds 100 %": "reproduced",
    "sustained saturation": "contradicted",
    "confined to small clusters": "qualified",
    "678 endpoints": "not checkable",
}


@pytest.fixture
def fresh_values():
    """Compute quantities anew, and forget them afterwards."""
    claims._value.cache_clear()
    yield
    claims._value.cache_clear()


@pytest.mark.parametrize(("words", "verdict"), EXPECTED.items())
def test_verdict(words, verdict):
    (claim,) = (claim for claim in claims.claims() if words in claim.statement)
    assert claim.verdict() == verdict


def test_all_other_claims_that_can_be_checked_are_reproduced():
    named = [c for c in claims.claims() if any(words in c.statement for words in EXPECTED)]
    others = [c for c in claims.claims() if c not in named and c.test]
    assert len(others) > 50
    assert {c.statement for c in others if c.verdict() != "reproduced"} == set()


@pytest.mark.parametrize("number", range(1, 11))
def test_every_equation_of_a_load_is_reproduced(number):
    rows = [
        c
        for c in claims.claims()
        if c.where == f"Eq. ({number})" and c.test and re.match("(host_)?load ", c.test.quantity)
    ]
    assert rows
    assert all(c.verdict() == "reproduced" for c in rows)


@pytest.mark.usefixtures("fresh_values")
def test_a_changed_formula_changes_verdicts(monkeypatch):
    thrice = tuple(replace(m, per_unit=3 * m.per_unit) for m in claims.DDS.messages)
    monkeypatch.setitem(claims._PROTOCOLS, "DDS", replace(claims.DDS, messages=thrice))
    changed = {c.where for c in claims.claims() if c.test and not c.test.holds()}
    assert {"Eq. (1)", "Eq. (2)", "Eq. (3)", "Eq. (4)", "Eq. (5)", "Fig. 2"} <= changed


@pytest.mark.usefixtures("fresh_values")
def test_a_changed_payload_changes_verdicts(monkeypatch):
    monkeypatch.setattr(messages, "header_bytes", lambda: {"UDP": 66, "TCP": 78})
    rows = [c for c in claims.claims() if c.test and c.test.quantity.startswith("frame_bytes")]
    assert {c.verdict() for c in rows} == {"contradicted"}


def test_whatever_is_not_reproduced_says_why():
    for claim in claims.claims():
        if claim.verdict() != "reproduced":
            assert claim.remark, claim.statement
        if claim.test is None:
            assert claim.weaker_test is None


def test_every_claim_leads_somewhere_in_the_book():
    sources = "".join(path.read_text() for path in (ROOT / "notebooks").glob("*.ipynb"))
    for claim in claims.claims():
        assert f'"({claim.link})=' in sources or not claim.link, claim.link
        assert f'"(claims-{claim.section})=' in sources, claim.section


def test_numbers_are_in_order():
    assert [claim.id for claim in claims.claims()] == list(range(1, len(claims.claims()) + 1))


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("frame_bytes SPDP", "test must read 'quantity arguments relation value'; got 'frame_"),
        ("no_such_thing DDS = 1", "quantity must be one of .*; got 'no_such_thing'"),
    ],
)
def test_a_wrong_test_is_refused(text, message):
    with pytest.raises(ValueError, match=message):
        claims.Test(text).holds()


def test_an_unknown_section_is_refused():
    with pytest.raises(ValueError, match=r"section must be one of introduction, .*; got 'x'"):
        claims.report("x")


@pytest.mark.parametrize(
    ("text", "holds"),
    [
        ("header UDP = 64", True),
        ("header UDP = 65", False),
        ("header UDP ≈ 65 ± 1", True),
        ("header UDP ≈ 65 ± 0.5", False),
        ("header UDP < 64", False),
        ("header UDP ≤ 64", True),
        ("header UDP > 64", False),
        ("header UDP ≥ 64", True),
        ("load DDS SPDP = N_P*N_H", True),
        ("load DDS SPDP = N_P*N_H + 1", False),
    ],
)
def test_relations(text, holds):
    assert claims.Test(text).holds() is holds
