"""The ledger of claims: verdicts are computed, and stay what they are."""

import json
import math
import re
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

import paper
import pytest
import sympy as sp
from paper import O_MULTI, O_UNI, R_MULTI, R_UNI, multicast, unicast

import discostorm as ds
from discostorm.data import read_data
from discostorm.messages import message
from discostorm.paper import claims, criteria
from discostorm.paper.quantities import swarms
from discostorm.uncertainty import saturation_bounds

ROOT = Path(__file__).parents[1]

# Held here on purpose: the verdicts that a reader may quote. By what is claimed, in a few words.
EXPECTED = {
    "exponentially": "contradicted",
    "meltdowns in swarms on standard Wi-Fi": "qualified",
    "meltdowns in swarms with Zenoh": "qualified",
    "Continuous broadcasting": "qualified",
    "root cause": "contradicted",
    "significant overhead of DDS": "reproduced",
    "lowest basic rate, 6": "qualified",
    "becomes a vulnerability": "reproduced",
    "operates via reliable unicast": "qualified",
    "fair comparison": "not checkable",
    "single host grows with the square": "contradicted",
    "pairing of two processes": "qualified",
    "two control messages to keep a link": "qualified",
    "is MCS 7": "qualified",
    "conservative configuration": "qualified",
    "approximately 120": "qualified",
    "approximately 180": "qualified",
    "KeepAlives consolidate": "qualified",
    "as printed": "qualified",
    "lower bound of the airtime": "qualified",
    "processes triggers a quadratic surge": "qualified",
    "quadratic surge with Zenoh": "qualified",
    "rmw_zenoh manages": "qualified",
    "slightly more efficient": "qualified",
    "due to fewer control messages": "reproduced",
    "gap between DDS and Zenoh remains marginal": "qualified",
    "DDS saturates at approximately 7": "reproduced",
    "Zenoh saturates at approximately 8": "reproduced",
    "Scouting costs more than DDS SPDP": "reproduced",
    "reliable synchronization of every pair": "qualified",
    "SEDP alone exceeds 100%": "reproduced",
    "sustained saturation": "qualified",
    "confined to small clusters": "qualified",
    "saturation points are precise": "qualified",
    "678 endpoints": "not checkable",
    "come from packet captures": "qualified",
    "before any application data": "qualified",
    "worse than the model predicts": "qualified",
    "Discovery Server is a single point": "reproduced",
    "at the router node": "qualified",
    "disrupt multiple communication sessions": "qualified",
    "The same of a Zenoh router": "reproduced",
    "significant configuration": "not checkable",
    "worst case for Zenoh": "qualified",
    "significantly reduces the traffic": "qualified",
}


PAIRS = 7 * 6 * 2**2
SEVEN = {name: paper.utilization(name, 7, 2, 10) for name in ("DDS", "Zenoh")}
SPLIT = {
    (name, processes): sum(paper.utilization(name, 3, processes, 40 // processes).values())
    for name in ("DDS", "Zenoh")
    for processes in (1, 8)
}
TOTAL = {name: sum(phases.values()) for name, phases in SEVEN.items()}
#: The least of what routers save of what peers with tokens send, whether names match or not.
START_SAVED = min(
    1
    - math.fsum(
        row.uplink_s + row.downlink_s
        for row in ds.breakdown(ds.PROTOCOLS["Zenoh router per host"], fleet).itertuples()
    )
    / math.fsum(
        row.uplink_s + row.downlink_s
        for row in ds.breakdown(ds.PROTOCOLS["Zenoh peer, tokens"], fleet).itertuples()
    )
    for fleet in (ds.Fleet((ds.HostGroup(7, 2, 10),), matching) for matching in (0.0, 1.0))
)
CONTROL = 2 * (unicast(116) + unicast(114) - unicast(84))


def standard(size: int) -> float:
    """Seconds of a frame up by 802.11n: 520 bits in each 3.6 us, then filled up to 4 us."""
    symbols = -(-(16 + 8 * size + 6) // 520)
    return 185.5e-6 + 4e-6 * -(-symbols * 36 // 40)


def standard_utilization() -> float:
    down = 121.5e-6 + 4e-6 * -(-(16 + 8 * 414 + 6) // 24)
    control = 2 * (standard(116) + standard(114))
    return 14 * (standard(414) + down) + PAIRS * 2 * (10 * standard(464) + control)


def with_ampdus(mpdus: int) -> Any:
    return ds.utilization(ds.DDS, 7, 2, 10, ds.Radio("802.11n", streams=2, mpdus=mpdus).wifi())


# Quantities of the ledger, in another way.
BY_HAND: dict[str, Any] = {
    "growth_factor DDS": 1,
    "load_variables DDS": 3,
    "host_load_variables DDS SPDP": 1,
    "control_saved": Fraction(1, 2),
    "messages_per_link DDS Heartbeat_message": 4,
    "messages_per_direction Zenoh KeepAlive_message": 2,
    "growth_exponent DDS Heartbeat_message 3 3 2 8 5 5": 2,
    "growth_exponent Zenoh Declaration 2 12 1 1 4 4": math.log(66, 6),
    "split_ratio Zenoh 3 8 40": SPLIT["Zenoh", 8] / SPLIT["Zenoh", 1],
    "saved_by_composing DDS 3 8 40": 1 - SPLIT["DDS", 1] / SPLIT["DDS", 8],
    "part_of_increase DDS control 3 8 40": (
        6 * (8**2 - 1) * 2 * (unicast(116) + unicast(114)) / (SPLIT["DDS", 8] - SPLIT["DDS", 1])
    ),
    "hosts_gained DDS 8 40": 7 - 2,
    "kinds_over UDP DDS SEDP": 3,
    "kinds_over TCP Zenoh all": 2,
    "default Fast_DDS initial_announcements": 5,
    "default Zenoh keep_alives": 4,
    "timestamps_bytes": 10 + 2,
    "overhead_of_named_intervals multicast": 34e-6 + 20e-6,
    "overhead_of_named_intervals unicast": 34e-6 + 40e-6 + 16e-6 + 28e-6,
    "airtime DDS SPDP 7 2 10": SEVEN["DDS"]["SPDP"],
    "airtime Zenoh Declaration 7 2 10": SEVEN["Zenoh"]["Declaration"],
    "share DDS multicast 7 2 10": SEVEN["DDS"]["SPDP"] / TOTAL["DDS"],
    "share_of_phase Zenoh Hello_message Scouting 7 2 10": (
        PAIRS * unicast(144) / SEVEN["Zenoh"]["Scouting"]
    ),
    "overhead_share DDS 7 2 10": (14 * (O_UNI + O_MULTI) + PAIRS * 14 * 2 * O_UNI) / TOTAL["DDS"],
    "largest_swarm DDS 2 10": 7,
    "largest_swarm Zenoh 1 678": 2,
    "gap 7 2 10": 1 - TOTAL["Zenoh"] / TOTAL["DDS"],
    "gap_of_phases 7 2 10": 1 - SEVEN["Zenoh"]["Declaration"] / SEVEN["DDS"]["SEDP"],
    "gap_limit": 1 - unicast(176) / unicast(464),
    "gap_from_control 7 2 10": CONTROL / (CONTROL + 10 * (unicast(464) - unicast(176))),
    "scouting_above_spdp 2 12 1 10": sum(
        (paper.utilization("Zenoh", h, 1, 10)["Scouting"] > h * multicast(414))
        for h in range(2, 13)
    ),
    "frame_bytes SPDP": 350 + 64,
    "payload_spread SPDP": Fraction(400 - 300, 2 * 350),
    "multicast_cost SPDP": (8 * 414 / R_MULTI + O_MULTI) / (8 * 414 / R_UNI + O_UNI),
    "bits_per_byte": 8,
    # Of SPDP, SEDP, Heartbeat and ACKNACK all but the Heartbeat.
    "payloads_measured DDS": Fraction(3, 4),
    "start_saved Zenoh_router_per_host 7": START_SAVED,
    # None of five runs, all of them, and all of the orphans lost the others.
    "runs_found Fast_DDS_Discovery_Server server_killed": 0,
    "runs_found Fast_DDS_Discovery_Server,_two server_cut_off": 1,
    "runs_undisturbed Fast_DDS_Discovery_Server server_cut_off survivors": 1,
    "runs_undisturbed Zenoh_router_per_host server_killed orphans_and_survivors": 0,
    "repeated_utilization DDS 3 1 678": 3 * multicast(414),
    "repeated_utilization Zenoh 7 2 10": (
        14 * multicast(80) + PAIRS * (unicast(144) + 2 * unicast(84))
    ),
    "control_share DDS 7 2 10": PAIRS * 2 * (unicast(116) + unicast(114)) / TOTAL["DDS"],
    "control_share Zenoh 7 2 10": PAIRS * 2 * unicast(84) / TOTAL["Zenoh"],
    "lowest_basic_rate 2.4": 1e6,
    "lowest_basic_rate 5": 6e6,
    "enumerated_down_for_up Zenoh Scouting 4 2 6": 1,
    "enumeration_ratio Zenoh 4 2 6": 1,
    "ht_rate 8": 2 * 65e6 / 10 / 0.9,
    "ht_rate 15": 2 * 65e6 / 0.9,
    "ht_rate_of_streams 7 1": 65e6 / 0.9,
    "ht_rates_above 2 20": 0,
    "ht_rates_above 2 40": 4,
    "ht_rates_above 3 20": 3,
    "overhead_with_backoff unicast": 185.5e-6,
    "overhead_with_backoff multicast": 121.5e-6,
    "standard_bound DDS 7 2 10": standard_utilization() / float(TOTAL["DDS"]),
    "aggregation_bound DDS 7 2 10": with_ampdus(64) / with_ampdus(1),
}


def test_payloads_move_the_saturation_point_by_less_than_all_parameters() -> None:
    known = {symbol.name: value for symbol, value in (ds.DDS.values() | ds.PAPER.values()).items()}
    fixed = {name: (value, value) for name, value in known.items() if not name.startswith("s_")}
    least, most = saturation_bounds(ds.DDS, 2, 10, ranges=fixed)
    spread = swarms.saturation_spread_by_payloads(ds.DDS, 2, 10)
    assert spread == pytest.approx(most - least)
    low, high = saturation_bounds(ds.DDS, 2, 10)
    of_all = swarms.saturation_spread(ds.DDS, 2, 10)
    assert of_all == pytest.approx(high - low)
    assert 0 < spread < of_all / 10


def test_remarks_about_aggregation_hold() -> None:
    told = [c for c in claims.claims() if "full A-MPDUs of 802.11n" in c.remark]
    assert len(told) == 5
    wifi = ds.Radio("802.11n", streams=2, mpdus=64).wifi()
    for protocol, swarm in [
        (ds.DDS, (10, 2, 10)),
        (ds.DDS, (100, 1, 0)),
        (ds.ZENOH, (100, 1, 0)),
        (ds.DDS, (3, 1, 678)),
        (ds.ZENOH, (3, 1, 678)),
    ]:
        alone = ds.utilization(protocol, *swarm, wifi=ds.Radio("802.11n", streams=2).wifi())
        assert ds.utilization(protocol, *swarm, wifi=wifi) < 1 < alone


@pytest.fixture
def fresh_values():
    """Compute quantities anew, and forget them afterwards."""
    caches = criteria.value_of, claims.claims
    for cache in caches:
        cache.cache_clear()
    yield
    for cache in caches:
        cache.cache_clear()


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
    thrice = tuple(replace(m, per_unit=3 * m.per_unit) for m in ds.DDS.messages)
    monkeypatch.setitem(criteria._PROTOCOLS, "DDS", replace(ds.DDS, messages=thrice))
    changed = {c.where for c in claims.claims() if c.test and not c.test.holds()}
    assert {"Eq. (1)", "Eq. (2)", "Eq. (3)", "Eq. (4)", "Eq. (5)", "Fig. 2"} <= changed


@pytest.mark.usefixtures("fresh_values")
def test_a_changed_payload_changes_verdicts(monkeypatch):
    monkeypatch.setattr(message, "header_bytes", lambda: {"UDP": 66, "TCP": 78})
    rows = [c for c in claims.claims() if c.test and c.test.quantity.startswith("frame_bytes")]
    assert {c.verdict() for c in rows} == {"contradicted"}


@pytest.mark.parametrize(("quantity", "value"), BY_HAND.items())
def test_quantities_by_hand(quantity, value):
    ours = criteria.Criterion(f"{quantity} = 0").ours()
    assert float(ours) == pytest.approx(float(value), rel=1e-12)


def test_whatever_is_not_reproduced_says_why():
    for claim in claims.claims():
        if claim.verdict() != "reproduced":
            assert claim.remark, claim.statement
        if claim.test is None:
            assert claim.weaker_test is None


def test_every_claim_leads_somewhere_in_the_book():
    pages = [path.read_text(encoding="utf-8") for path in (ROOT / "book").glob("*.md")]
    for path in (ROOT / "notebooks").glob("*.ipynb"):
        cells = json.loads(path.read_text(encoding="utf-8"))["cells"]
        pages += ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "markdown"]
    labels = {label for page in pages for label in re.findall(r"^\((.+)\)=$", page, re.MULTILINE)}
    for claim in claims.claims():
        assert claim.link in labels | {""}
        assert f"claims-{claim.section}" in labels


def deciding(claim: claims.Claim) -> list[criteria.Criterion]:
    return [test for test in (claim.test, claim.weaker_test) if test]


def test_a_soft_word_has_one_threshold_throughout() -> None:
    for claim in claims.claims():
        if not claim.test:
            continue
        read = {test.word for test in deciding(claim) if test.word}
        # Who says the word uses its threshold, and who uses it says the word.
        for word in criteria.soft_words().values():
            said = re.search(word.forms, claim.statement) is not None
            assert said is (claim.test.word == word), (claim.statement, word.word)
        assert bool(read) == bool(claim.reading)


def test_there_is_no_threshold_but_those_of_the_words() -> None:
    free = set()
    for claim in claims.claims():
        for test in deciding(claim):
            relation, value, *tolerance = test.paper.split()
            if relation in "<≤>≥" and not test.word:
                free.add(float(value))
            if relation == "≈" and not test.word:  # one word for each number that is about another
                assert float(tolerance[1]) <= 0.05e6, test.text
    # Full or not; more, fewer or as many; some or none: nothing that we chose.
    assert free == {0, 1}


def test_every_soft_word_is_used() -> None:
    used = {test.word for claim in claims.claims() for test in deciding(claim)}
    assert used - {None} == set(criteria.soft_words().values())


def test_a_weaker_test_is_another_one_and_says_why() -> None:
    """Without a remark a reader could not tell that both tests are of one sentence."""
    for claim in claims.claims():
        if claim.weaker_test:
            assert claim.remark, claim.statement
            assert claim.weaker_test.text != claim.test.text


def test_remarks_are_filled_in() -> None:
    (claim,) = (claim for claim in claims.claims() if "root cause" in claim.statement)
    by_unicast = 1 - SEVEN["DDS"]["SPDP"] / TOTAL["DDS"]
    assert f"{float(by_unicast):.1%} of the airtime is unicast" in claim.remark
    (claim,) = (claim for claim in claims.claims() if "approximately 180" in claim.statement)
    assert "add up to 118 µs" in claim.remark
    assert not [claim.remark for claim in claims.claims() if "{" in claim.remark]


def test_numbers_are_in_order():
    assert [claim.id for claim in claims.claims()] == list(range(1, len(claims.claims()) + 1))


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("frame_bytes SPDP", "test must read 'quantity arguments relation value' or .*; got 'fram"),
        ("frame_bytes SPDP is huge", "word must be one of approximately, .*; got 'huge'"),
        ("default OpenDDS lease = 1", "product must be one of Fast_DDS, .*; got 'OpenDDS'"),
        ("no_such_thing DDS = 1", "quantity must be one of .*; got 'no_such_thing'"),
        ("share DDS SEDP_mesage 7 2 10 < 1", "name must be one of .*; got 'SEDP_mesage'"),
        ("load DDS Hello = 0", "name must be one of .* for DDS; got 'Hello'"),
    ],
)
def test_a_wrong_test_is_refused(text, message):
    with pytest.raises(ValueError, match=message):
        criteria.Criterion(text).holds()


def test_parts_of_a_test() -> None:
    test = criteria.Criterion("share DDS SPDP 7 2 10 ≈ 0.5 ± 0.1")
    assert (test.quantity, test.paper) == ("share DDS SPDP 7 2 10", "≈ 0.5 ± 0.1")
    assert test.word is None
    for text, shown in {
        "gap_limit is marginal": "marginal: ≤ 0.1",
        "gap_limit is not marginal": "not marginal: > 0.1",
        "header UDP ≈ 64": "≈ 64",
    }.items():
        assert criteria.Criterion(text).paper == shown
        assert criteria.Criterion(text).word is not None


def test_a_report_says_of_each_claim_how_it_was_decided() -> None:
    lines = claims.report("zenoh").splitlines()
    said = "Eq. (9): Zenoh needs only two control messages to keep a link."
    (start,) = (number for number, line in enumerate(lines) if line.endswith(said))
    number = int(lines[start].removesuffix(f". {said}"))
    assert lines[start + 1 : start + 5] == [
        "   messages_per_link Zenoh KeepAlive_message is 4; the paper: = 2",
        "   messages_per_direction Zenoh KeepAlive_message is 2; weaker: = 2",
        "   -> qualified",
        f"{number + 1}. Sec. III-C: KeepAlives consolidate the checks of reliability in the "
        "session layer (we read: Declares go over a transport that leaves such checks to the "
        "session).",
    ]
    assert claims.report("dds").splitlines()[-1] == "   -> not checkable"
    verdicts = [line[6:] for line in lines if line.startswith("   -> ")]
    assert verdicts == [c.verdict() for c in claims.claims() if c.section == "zenoh"]


@pytest.mark.parametrize(
    ("test", "said"),
    [
        ("control_saved is significant", "at least 10% of the control messages of DDS saved by"),
        ("frame_bytes SPDP = 414", "414 B in a frame of SPDP: 414 B"),
        ("overhead_with_backoff unicast ≈ 180e-6", "about 180 µs for the same with the mean"),
        ("load DDS SPDP = N_H*N_P", "messages of all hosts, SPDP of DDS: the same"),
        (
            "share DDS SPDP 7 2 10 is not dominant",
            "at most 50% of the airtime for SPDP of DDS, 7 h",
        ),
        ("utilization DDS 3 1 40 is low", "DDS with 3 hosts of 1 process with 40 endpoints: 11%"),
        ("ht_rate 7 ≈ 144.4e6 ± 0.05e6", "about 144.4 Mbit/s ± 0.05 Mbit/s for MCS 7"),
        ("enumeration_ratio DDS 4 2 6 ≈ 1 ± 1e-12", "1 but for rounding as the ratio to the air"),
        ("utilization DDS 100 1 0 ≥ 1", "at least 100% of a second, DDS with 100 hosts of 1 pro"),
        ("utilization DDS 100 1 0 ≥ 1", ": 14.8 s"),
        ("start_saved Zenoh_router_per_host 100 > 0", "hosts: none, it takes 8 times as much"),
        (
            "default Cyclone_DDS sedp_multicast_wired = 0",
            "multicast of SEDP on a wired interface off by default, Cyclone DDS: on",
        ),
    ],
)
def test_tests_in_words(test: str, said: str) -> None:
    assert said in criteria.Criterion(test).in_words()


def test_every_quantity_has_words_and_says_how_it_is_known() -> None:
    named = [row["quantity"] for row in read_data("paper/quantities.csv")]
    parts = [test.quantity.split() for claim in claims.claims() for test in deciding(claim)]
    tested = {f"default {part[-1]}" if part[0] == "default" else part[0] for part in parts}
    assert sorted(tested) == sorted(named)
    known = {test.provenance for claim in claims.claims() for test in deciding(claim)}
    assert known <= {"computed", "read in sources", "simulated", "measured"}


def test_numbers_are_shown_to_four_digits_and_expressions_as_they_are() -> None:
    assert claims.shown(sp.Rational(1, 3)) == "0.3333"
    assert claims.shown(2 * ds.notation.N_H) == "2*N_H"
    assert claims.shown("") == ""


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
        ("header UDP ≈ 61", True),
        ("header UDP ≈ 60", False),
        ("header UDP is high", True),
        ("header UDP is not high", False),
        ("header UDP is small", False),
        ("header UDP is not small", True),
        ("load DDS SPDP = N_P*N_H", True),
        ("load DDS SPDP = N_P*N_H + 1", False),
    ],
)
def test_relations(text, holds):
    assert criteria.Criterion(text).holds() is holds
