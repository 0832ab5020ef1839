"""Test the ledger of claims: computed verdicts, and their words."""

import json
import math
import re
from collections import Counter
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from typing import Any

import paper_equations as paper
import pytest
import sympy as sp
from paper_equations import O_MULTI, O_UNI, R_MULTI, R_UNI, multicast, unicast
from support import ROOT

import discostorm as ds
from discostorm.data import read_data
from discostorm.messages import message
from discostorm.notation import N_H, N_P
from discostorm.uncertainty import saturation_bounds
from discostorm_book.ledger import claims, criteria
from discostorm_book.ledger.quantities import QUANTITIES, captured, evidence, frames, model

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


#: Quantities of the ledger, in another way; those that it compares with a number itself it has.
BY_HAND: list[tuple[Callable[..., Any], tuple[Any, ...], Any]] = [
    (model.growth_factor, (ds.DDS,), 1),
    (QUANTITIES["control_saved"], (), Fraction(1, 2)),
    (model.messages_per_link, (ds.DDS, "Heartbeat_message"), 4),
    (model.growth_exponent, (ds.DDS, "Heartbeat_message", 3, 3, 2, 8, 5, 5), 2),
    (model.growth_exponent, (ds.ZENOH, "Declaration", 2, 12, 1, 1, 4, 4), math.log(66, 6)),
    (model.split_ratio, (ds.ZENOH, 3, 8, 40), SPLIT["Zenoh", 8] / SPLIT["Zenoh", 1]),
    (QUANTITIES["saved_by_composing"], (ds.DDS, 3, 8, 40), 1 - SPLIT["DDS", 1] / SPLIT["DDS", 8]),
    (
        model.part_of_increase,
        (ds.DDS, "control", 3, 8, 40),
        (6 * (8**2 - 1) * 2 * (unicast(116) + unicast(114)) / (SPLIT["DDS", 8] - SPLIT["DDS", 1])),
    ),
    (QUANTITIES["hosts_gained"], (ds.DDS, 8, 40), 7 - 2),
    (QUANTITIES["kinds_over"], ("UDP", ds.DDS, "SEDP"), 3),
    (QUANTITIES["kinds_over"], ("TCP", ds.ZENOH, "all"), 2),
    (QUANTITIES["default"], ("Fast DDS", "initial_announcements"), 5),
    (QUANTITIES["default"], ("Zenoh", "keep_alives"), 4),
    (frames.timestamps_bytes, (), 10 + 2),
    (frames.overhead_without_backoff, ("multicast",), 34e-6 + 20e-6),
    (frames.overhead_without_backoff, ("unicast",), 34e-6 + 40e-6 + 16e-6 + 28e-6),
    (model.airtime, (ds.DDS, "SPDP", 7, 2, 10), SEVEN["DDS"]["SPDP"]),
    (model.airtime, (ds.ZENOH, "Declaration", 7, 2, 10), SEVEN["Zenoh"]["Declaration"]),
    (QUANTITIES["share"], (ds.DDS, "multicast", 7, 2, 10), SEVEN["DDS"]["SPDP"] / TOTAL["DDS"]),
    (
        QUANTITIES["share_of_phase"],
        (ds.ZENOH, "Hello_message", "Scouting", 7, 2, 10),
        (PAIRS * unicast(144) / SEVEN["Zenoh"]["Scouting"]),
    ),
    (
        model.overhead_share,
        (ds.DDS, 7, 2, 10),
        (14 * (O_UNI + O_MULTI) + PAIRS * 14 * 2 * O_UNI) / TOTAL["DDS"],
    ),
    (model.largest_swarm, (ds.DDS, 2, 10), 7),
    (model.largest_swarm, (ds.ZENOH, 1, 678), 2),
    (QUANTITIES["gap"], (7, 2, 10), 1 - TOTAL["Zenoh"] / TOTAL["DDS"]),
    (
        QUANTITIES["gap_of_phases"],
        (7, 2, 10),
        1 - SEVEN["Zenoh"]["Declaration"] / SEVEN["DDS"]["SEDP"],
    ),
    (model.gap_limit, (), 1 - unicast(176) / unicast(464)),
    (model.gap_from_control, (7, 2, 10), CONTROL / (CONTROL + 10 * (unicast(464) - unicast(176)))),
    (
        QUANTITIES["scouting_above_spdp"],
        (2, 12, 1, 10),
        sum(
            (paper.utilization("Zenoh", h, 1, 10)["Scouting"] > h * multicast(414))
            for h in range(2, 13)
        ),
    ),
    (frames.payload_spread, ("SPDP",), Fraction(400 - 300, 2 * 350)),
    (frames.multicast_cost, ("SPDP",), (8 * 414 / R_MULTI + O_MULTI) / (8 * 414 / R_UNI + O_UNI)),
    # Of SPDP, SEDP, Heartbeat and ACKNACK all but the Heartbeat.
    (evidence.payloads_measured, (ds.DDS,), Fraction(3, 4)),
    (QUANTITIES["least_saved"], ("Zenoh router per host", 7, 7, 2), START_SAVED),
    # All of five runs, and all of the orphans lost the others.
    (QUANTITIES["runs_found"], ("Fast DDS Discovery Server, two", "server cut off"), 1),
    (
        QUANTITIES["runs_undisturbed"],
        ("Fast DDS Discovery Server", "server cut off", "survivors"),
        1,
    ),
    (
        QUANTITIES["runs_undisturbed"],
        ("Zenoh router per host", "server killed", "orphans and survivors"),
        0,
    ),
    (QUANTITIES["repeated_utilization"], (ds.DDS, 3, 1, 678), 3 * multicast(414)),
    (
        QUANTITIES["repeated_utilization"],
        (ds.ZENOH, 7, 2, 10),
        (14 * multicast(80) + PAIRS * (unicast(144) + 2 * unicast(84))),
    ),
    (
        QUANTITIES["share"],
        (ds.DDS, "control", 7, 2, 10),
        PAIRS * 2 * (unicast(116) + unicast(114)) / TOTAL["DDS"],
    ),
    (
        QUANTITIES["share"],
        (ds.ZENOH, "control", 7, 2, 10),
        PAIRS * 2 * unicast(84) / TOTAL["Zenoh"],
    ),
    (QUANTITIES["lowest_basic_rate"], (2.4,), 1e6),
    (evidence.enumeration_ratio, (ds.ZENOH, 4, 2, 6), 1),
    (QUANTITIES["ht_rate"], (8,), 2 * 65e6 / 10 / 0.9),
    (QUANTITIES["ht_rate"], (15,), 2 * 65e6 / 0.9),
    (frames.ht_rate_of_streams, (7, 1), 65e6 / 0.9),
    (QUANTITIES["ht_rates_above"], (2, 20), 0),
    (QUANTITIES["ht_rates_above"], (2, 40), 4),
    (QUANTITIES["ht_rates_above"], (3, 20), 3),
    (frames.overhead_with_backoff, ("unicast",), 185.5e-6),
    (frames.overhead_with_backoff, ("multicast",), 121.5e-6),
    (frames.standard_bound, (ds.DDS, 7, 2, 10), standard_utilization() / float(TOTAL["DDS"])),
    # By the table of chapter 21; five Scouts and more are due at 1, 3, 7 and 15 s.
    (captured.sent_for_counted, ("Fast DDS", "SPDP"), 32),
    (captured.sent_for_counted, ("Zenoh peer", "Scout"), 4),
    (captured.sent_for_counted, ("Zenoh peer", "Declare"), Fraction(1, 2)),
    (QUANTITIES["sent_spread"], ("Fast DDS", "SPDP"), Fraction(1910, 12 * 19)),
    (QUANTITIES["sent_ratio"], ("Zenoh peer", "Declare", "Fast DDS", "SEDP"), Fraction(1, 2)),
    (captured.sessions_per_pair, ("Zenoh peer",), Fraction(4, 3)),
    # Of 24 s, each 3 s and each 8 s.
    (captured.repeats, ("Fast DDS", "SPDP"), 8),
    (captured.repeats, ("Zenoh peer", "Scout"), 3),
    (QUANTITIES["period"], ("Zenoh peer", "Scout"), 8),
    (QUANTITIES["burst_saved"], (ds.DDS, 2, 1), -evidence.burst_excess(ds.DDS, 2, 1)),
    (evidence.enumeration_agrees, (ds.ZENOH, 3, 2, 3), 1),
    # SEDP messages of a host of two processes: to one other or to two, of one endpoint or three.
    (evidence.enumerated_spread, (ds.DDS, "Heartbeat", 3, 2, 3), 2),
]


def test_payloads_move_the_saturation_point_by_less_than_all_parameters() -> None:
    known = {symbol.name: value for symbol, value in (ds.DDS.values() | ds.PAPER.values()).items()}
    fixed = {name: (value, value) for name, value in known.items() if not name.startswith("s_")}
    least, most = saturation_bounds(ds.DDS, 2, 10, ranges=fixed)
    spread = QUANTITIES["saturation_spread_by_payloads"](ds.DDS, 2, 10)
    assert spread == pytest.approx(most - least)
    low, high = saturation_bounds(ds.DDS, 2, 10)
    of_all = model.saturation_spread(ds.DDS, 2, 10)
    assert of_all == pytest.approx(high - low)
    assert 0 < spread < of_all / 10


def test_runs_of_one_swarm_scatter_as_the_rows_of_counts_say() -> None:
    sent: Counter[str] = Counter()
    for row in read_data("measured/counts.csv", "discostorm_book"):
        if row["window"] == "startup":
            sent[row["run"]] += int(row["messages"])
    runs: dict[tuple[str, ...], list[int]] = {}
    for run in read_data("measured/runs.csv", "discostorm_book"):
        if (run["product"], run["variant"]) == ("fast_dds", "default") and run["hosts"] != "1":
            swarm = tuple(run[name] for name in ("hosts", "processes", "endpoints", "names"))
            runs.setdefault(swarm, []).append(sent[run["run"]])
    assert captured.run_scatter("Fast DDS") == max(max(each) / min(each) for each in runs.values())


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


def by_key() -> dict[str, claims.Claim]:
    return {claim.key: claim for claim in claims.claims()}


def criterion_of(key: str) -> criteria.Criterion:
    return criteria.criteria_by_claim()[key]["test"]


@pytest.fixture
def fresh_values():
    """Compute quantities anew, and forget them afterwards."""
    caches = criteria._computed_value, claims.claims
    for cache in caches:
        cache.cache_clear()
    yield
    for cache in caches:
        cache.cache_clear()


def test_verdicts_are_what_the_ledger_states() -> None:
    """A verdict that a reader may quote changes only where somebody states another one."""
    every = claims.claims()
    assert {claim.key: claim.outcome() for claim in every} == {c.key: c.stated for c in every}
    assert {claim.stated for claim in every} == set(claims.VERDICTS)


def test_every_test_is_of_a_claim_and_every_key_of_one() -> None:
    keys = [claim.key for claim in claims.claims()]
    assert len(set(keys)) == len(keys)
    assert set(criteria.criteria_by_claim()) <= set(keys)
    for key, by_role in criteria.criteria_by_claim().items():
        assert "test" in by_role or "weaker" not in by_role, key


@pytest.mark.parametrize("number", range(1, 11))
def test_every_equation_of_a_load_is_reproduced(number):
    loads = [
        test
        for claim in claims.claims()
        for test in claim.tests
        if claim.where == f"Eq. ({number})" and re.match("(host_)?load ", test.quantity)
    ]
    assert loads
    assert all(test.holds() for test in loads)


@pytest.mark.parametrize(
    ("key", "sent"),
    [
        ("spdp-of-a-host", "32 SPDP messages per process"),
        ("spdp-needs-processes-alone", "8.4 times as much"),
        ("one-scout-per-process", "4 Scouts in the first twelve seconds"),
        ("a-hello-to-every-scout", "3.6 Hellos for each"),
        ("declares-of-a-host", "0.5 Declares for each"),
        ("declares-as-sedp", "0.5 Declares per SEDP message of Fast DDS"),
    ],
)
def test_what_products_were_measured_to_do_otherwise_is_said(key: str, sent: str) -> None:
    """A sentence about DDS or Zenoh as such does not hold by its equation alone."""
    claim = by_key()[key]
    assert claim.outcome() == "weaker holds"
    assert claim.provenance == "measured, computed"
    assert sent in claim.remark


def test_remarks_of_rows_decided_without_captures_do_not_say_measured() -> None:
    for claim in claims.claims():
        if claim.tests and "measured" not in claim.provenance:
            assert "easured" not in claim.remark, claim.key


@pytest.mark.usefixtures("fresh_values")
def test_what_is_called_measured_does_without_the_model(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: Any) -> None:
        raise AssertionError("computed")

    tests = [test for claim in claims.claims() for test in claim.tests]
    criteria._computed_value.cache_clear()
    for name in ("message_costs", "utilization", "saturation_hosts"):
        monkeypatch.setattr(evidence, name, refuse)
    told = {test.function.__name__ for test in tests if test.provenance == "measured"}
    assert {"runs_found", "sent_for_counted"} <= told
    for test in tests:
        if test.provenance == "measured":
            test.ours()


def test_no_claim_is_decided_by_the_variables_of_our_own_formula() -> None:
    assert not [test.text for c in claims.claims() for test in c.tests if "variables" in test.text]
    assert by_key()["half-publish"].outcome() == "no test"


def test_claims_are_decided_by_what_their_sentences_say() -> None:
    every = by_key()
    # Chapter 22 has a burst that takes less than the model says.
    assert every["lower-bound"].outcome() == "fails"
    assert evidence.burst_excess(ds.DDS, 2, 1) < 0
    assert evidence.burst_over_model(ds.DDS, 2, 1) < 1
    assert all(evidence.burst_over_model(ds.DDS, hosts, 1) > 1 for hosts in range(3, 13))
    # Of collisions and back-offs, not of the time; the model has none.
    assert every["bursts-are-worse"].test == criteria.Criterion(
        QUANTITIES["collided"], (ds.DDS, 7, 1), "is", "significant"
    )
    # Of all that is exchanged reliably by each pair, not of its control messages alone.
    assert every["surge-by-pairs"].test == criteria.Criterion(
        model.part_of_increase, (ds.DDS, "SEDP", 3, 8, 40), "is", "cause"
    )
    # Multicast is not the root, but the volume of packets is, which the same paragraph names.
    assert every["multicast-is-the-root-cause"].outcome() == "weaker holds"
    # Table II cannot test itself.
    for key in ("payload-varies", "payload-of-heartbeat", "payload-of-acknack"):
        assert every[key].test.provenance == "measured"  # type: ignore[union-attr]
    assert every["payload-of-heartbeat"].outcome() == "weaker holds"
    # What users can do, not what every remedy is.
    assert every["configuration-suffices"].outcome() == "holds"
    assert "deployment" not in every["synchronized-starts"].remark
    # Of the robot whose router died.
    assert every["router-single-point"].outcome() == "holds"


@pytest.mark.parametrize(
    ("key", "before", "after"),
    [
        ("made-for-wired", "multicast-is-the-root-cause", "multicast-is-a-vulnerability"),
        ("upper-bounds", "earlier-work", "configuration-suffices"),
        ("configuration-suffices", "upper-bounds", "three-levels-dds"),
        ("synchronized-starts", "half-publish", "locators-known-before"),
        ("locators-known-before", "synchronized-starts", "peers-are-the-worst-case"),
        ("spdp-is-periodic", "fair-comparison", "spdp-of-a-host"),
        ("multicast-once", "spdp-needs-processes-alone", "spdp-of-all"),
        ("scout-is-periodic", "discovery-interval", "scouting-of-a-host"),
        ("sessions-with-all", "scouting-both-ways", "declares-of-a-host"),
        ("one-message-one-frame", "declares-both-ways", "frame-spdp"),
    ],
)
def test_sentences_that_were_left_out_have_rows_in_their_places(
    key: str, before: str, after: str
) -> None:
    keys = [claim.key for claim in claims.claims()]
    place = keys.index(key)
    assert (keys[place - 1], keys[place + 1]) == (before, after)


@pytest.mark.parametrize("key", ["peers-are-the-worst-case", "servers-reduce-traffic"])
def test_routers_are_judged_within_the_measured_sizes_and_for_single_processes(key: str) -> None:
    """By our own models a router on each host costs more than peers of one process each."""
    claim = by_key()[key]
    assert claim.outcome() == "weaker holds"
    assert [test.arguments[1:] for test in claim.tests] == [(7, 16, 1), (7, 16, 2)]
    assert "N_P = 1" in claim.statement
    assert "N_P = 1" in claim.remark
    peers, routers = (
        ds.breakdown(ds.PROTOCOLS[name], ds.Fleet((ds.HostGroup(7, 1, 10),), 0.0))
        for name in ("Zenoh peer, tokens", "Zenoh router per host")
    )
    sent = [math.fsum(each["uplink_s"] + each["downlink_s"]) for each in (peers, routers)]
    assert sent[1] > sent[0]


@pytest.mark.parametrize(
    ("key", "outcome"),
    [
        ("retransmission-converges", "holds"),
        ("random-delays-help", "weaker holds"),
        ("discovery-is-sequential", "no test"),
        ("centralized-is-incomplete", "no test"),
        ("hello-for-lossy-networks", "no test"),
        ("experiments-will-tell", "no test"),
    ],
)
def test_sentences_that_came_last_leave_the_numbers_of_other_rows(key: str, outcome: str) -> None:
    claim = by_key()[key]
    assert claim.id > by_key()["explains-failures"].id == 138
    assert claim.outcome() == outcome


@pytest.mark.parametrize(
    "key",
    [
        "three-levels-dds",
        "sedp-is-unicast",
        "overhead-of-multicast",
        "overhead-of-unicast",
        "bytes-over-bits",
    ],
)
def test_sentences_are_read_as_their_authors_would(key: str) -> None:
    assert by_key()[key].outcome() == "holds"
    assert by_key()[key].remark


def test_delays_are_said_to_gain_only_hosts_that_the_runs_are_sure_of() -> None:
    rows = read_data("simulated/ladder.csv", "discostorm_book")
    low, high = (
        next(
            int(row[end])
            for row in rows
            if (row["protocol"], row["step"], row["mpdus"], row["limit_s"])
            == ("Zenoh", step, "1", "10")
        )
        for step, end in (("staggered", "hosts_low"), ("queues", "hosts_high"))
    )
    assert evidence.gained_by_delays(ds.ZENOH, 1) == low - high > 0


def test_a_figure_has_the_weakest_verdict_of_its_rows() -> None:
    order = ["holds", "weaker holds", "fails"]
    known = claims.figures()
    assert list(known) == ["1", "2", "3", "4"]
    for number, figure in known.items():
        about = [claim for claim in claims.claims() if claim.where == f"Fig. {number}"]
        assert list(figure.claims) == about
        decided = [claim.outcome() for claim in about if claim.test]
        assert figure.stated == figure.outcome()
        assert figure.stated == (max(decided, key=order.index) if decided else "no test")
        assert {figure.label} == ({f"claims-{claim.section}" for claim in about} or {""})


def test_figures_show_their_badges_in_their_chapters_and_on_the_map() -> None:
    table = (ROOT / "book/paper_map.md").read_text(encoding="utf-8")
    for number, figure in claims.figures().items():
        row = rf"\| {number} \| {figure.what} \| {{ref}}`Fig. {number} .*\| (.*) \|"
        assert re.findall(row, table) == [figure.badge()]
        if not figure.claims:
            continue
        (chapter,) = (
            path
            for path in (ROOT / "notebooks").glob("*.ipynb")
            if f"(paper-fig-{number})=" in path.read_text(encoding="utf-8")
        )
        cells = json.loads(chapter.read_text(encoding="utf-8"))["cells"]
        shown = [
            "".join(output["data"]["text/markdown"])
            for cell in cells
            for output in cell.get("outputs", [])
            if "text/markdown" in output.get("data", {})
        ]
        assert figure.caption() in [text.replace("\N{NO-BREAK SPACE}", " ") for text in shown]


@pytest.mark.usefixtures("fresh_values")
def test_a_changed_formula_changes_verdicts(monkeypatch):
    thrice = replace(
        ds.DDS, messages=tuple(replace(m, per_unit=3 * m.per_unit) for m in ds.DDS.messages)
    )
    for by_role in criteria.criteria_by_claim().values():
        for role, test in by_role.items():
            given = tuple(thrice if each is ds.DDS else each for each in test.arguments)
            monkeypatch.setitem(by_role, role, replace(test, arguments=given))
    changed = {c.where for c in claims.claims() if c.test and not c.test.holds()}
    assert {"Eq. (1)", "Eq. (2)", "Eq. (3)", "Eq. (4)", "Eq. (5)", "Fig. 2"} <= changed


@pytest.mark.usefixtures("fresh_values")
def test_a_changed_payload_changes_verdicts(monkeypatch):
    monkeypatch.setattr(message, "header_bytes", lambda: {"UDP": 66, "TCP": 78})
    rows = [c for c in claims.claims() if c.test and c.test.quantity.startswith("frame_bytes")]
    assert {c.outcome() for c in rows} == {"fails"}


@pytest.mark.parametrize(("function", "arguments", "value"), BY_HAND)
def test_quantities_by_hand(function, arguments, value):
    assert float(function(*arguments)) == pytest.approx(float(value), rel=1e-12)


def test_whatever_is_not_reproduced_says_why():
    """Without a remark a reader could not tell, either, that both tests are of one sentence."""
    for claim in claims.claims():
        assert claim.remark or (claim.outcome() == "holds" and not claim.weaker_test), claim.key
        assert len({test.text for test in claim.tests}) == len(claim.tests), claim.key


def test_every_claim_leads_somewhere_in_the_book():
    pages = [path.read_text(encoding="utf-8") for path in (ROOT / "book").glob("*.md")]
    for path in (ROOT / "notebooks").glob("*.ipynb"):
        cells = json.loads(path.read_text(encoding="utf-8"))["cells"]
        pages += ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "markdown"]
    labels = {label for page in pages for label in re.findall(r"^\((.+)\)=$", page, re.MULTILINE)}
    for claim in claims.claims():
        assert claim.link in labels | {""}
        assert f"claims-{claim.section}" in labels


def test_the_chapter_explains_every_verdict_and_the_page_colors_its_sign() -> None:
    (chapter,) = (ROOT / "notebooks").glob("*_ledger.ipynb")
    cells = json.loads(chapter.read_text(encoding="utf-8"))["cells"]
    prose = " ".join(" ".join("".join(cell["source"]).split()) for cell in cells)
    style = (ROOT / "book/_static/chapters.css").read_text(encoding="utf-8")
    for row in claims.VERDICTS.values():
        assert f"*{row['verdict']}*" in prose
        assert f'[data-verdict="{row["sign"]}"]' in style


def test_the_parts_of_the_ledger_have_the_rows_that_it_says() -> None:
    (chapter,) = (ROOT / "notebooks").glob("*_ledger.ipynb")
    cells = json.loads(chapter.read_text(encoding="utf-8"))["cells"]
    text = "\n".join("".join(cell["source"]) for cell in cells)
    said = re.findall(r"\(claims-(\w+)\)=\n\[.+\]\(#claims-\1\): rows (\d+) to (\d+)", text)
    rows: dict[str, list[int]] = {}
    for claim in claims.claims():
        rows.setdefault(claim.section, []).append(claim.id)
    assert [(name, int(a), int(b)) for name, a, b in said] == [
        (name, ids[0], ids[-1]) for name, ids in rows.items()
    ]
    for name, a, b in said:
        assert rows[name] == list(range(int(a), int(b) + 1))


#: Paragraphs of the paper's sections, list items apart, and sentences of its abstract.
PARAGRAPHS = {
    **{"I": 5, "II-A": 3, "II-B": 2, "III-A": 4, "III-B": 7, "III-C": 6},
    **{"IV-A": 4, "IV-B": 4, "IV-C": 6, "V": 3, "Abstract": 6},
}


def test_every_row_says_in_which_paragraph_its_sentence_stands() -> None:
    numbers = {f"({n})": "III-B" for n in range(1, 6)} | {f"({n})": "III-C" for n in range(6, 11)}
    numbers |= {"(11)": "IV-B", "(12)": "IV-B", "Table I": "II-B", "Table II": "IV-A"}
    numbers |= {f"Fig. {n}": "IV-C" for n in (2, 3, 4)}
    for claim in claims.claims():
        sections = []
        for place in claim.place.split("; "):
            section, _, paragraph = place.removeprefix("Sec. ").partition(", ")
            sections.append(section)
            if paragraph != "item Host":
                last = re.findall(r"\d+", paragraph)[-1]
                assert 1 <= int(last) <= PARAGRAPHS[section], claim.key
        if claim.where.startswith(("Eq.", "Table", "Fig.")):
            assert sections == [numbers[claim.where.removeprefix("Eq. ")]], claim.key
            assert claim.found_at == f"{claim.where}; {claim.place}"
        else:
            said = [part.removeprefix("Sec. ") for part in claim.where.split(", ")]
            assert sections == said, claim.key
            assert claim.found_at == claim.place


def test_a_vague_term_has_one_threshold_throughout() -> None:
    for claim in claims.claims():
        if not claim.test:
            continue
        read = {test.word for test in claim.tests if test.word}
        # Who says the word uses its threshold, and who uses it says the word.
        for word in criteria.vague_terms().values():
            said = re.search(word.forms, claim.statement) is not None
            assert said is (claim.test.word == word), (claim.statement, word.word)
        assert bool(read) == bool(claim.reading)


def test_there_is_no_threshold_but_those_of_the_words() -> None:
    free = set()
    for claim in claims.claims():
        for test in claim.tests:
            relation, value, *tolerance = test.paper.split()
            if relation in "<≤>≥" and not test.word:
                free.add(float(value))
            if relation == "≈" and not test.word:  # one word for each number that is about another
                assert float(tolerance[1]) <= 0.05e6, test.text
    # Full or not; more, fewer or as many; some or none: nothing that we chose.
    assert free == {0, 1}


def test_every_vague_term_is_used() -> None:
    used = {test.word for claim in claims.claims() for test in claim.tests}
    assert used - {None} == set(criteria.vague_terms().values())


def test_remarks_are_filled_in() -> None:
    (claim,) = (claim for claim in claims.claims() if "root cause" in claim.statement)
    by_unicast = 1 - SEVEN["DDS"]["SPDP"] / TOTAL["DDS"]
    assert f"{float(by_unicast):.1%} of the airtime is unicast" in claim.remark
    (claim,) = (claim for claim in claims.claims() if "approximately 180" in claim.statement)
    assert "add up to 118 µs" in claim.remark
    assert not [claim.remark for claim in claims.claims() if "{" in claim.remark]


@pytest.mark.parametrize(
    ("test", "message"),
    [
        (
            (QUANTITIES["header"], ("UDP",), "is", "huge"),
            "word must be one of approx.*; got 'huge'",
        ),
        (
            (QUANTITIES["default"], ("OpenDDS", "lease"), "=", 1),
            "product must be .*; got 'OpenDDS'",
        ),
        (
            (QUANTITIES["share"], (ds.DDS, "SEDP_mesage", 7, 2, 10), "<", 1),
            "name must be .*_mesage'",
        ),
        ((model.load, (ds.DDS, "Hello"), "=", 0), "name must be .* for DDS; got 'Hello'"),
    ],
)
def test_a_wrong_test_is_refused(test, message):
    with pytest.raises(ValueError, match=message):
        criteria.Criterion(*test).holds()


@pytest.mark.parametrize(
    ("key", "line", "words"),
    [
        (
            "scouting-of-all",
            "load Zenoh Scouting = N_H*N_P + N_H*(N_H - 1)*N_P**2",
            "messages of all hosts, Scouting of Zenoh: the same",
        ),
        (
            "sedp-is-unicast",
            "default Cyclone_DDS sedp_multicast_wifi = 0",
            "multicast of SEDP on Wi-Fi off by default, Cyclone DDS: off",
        ),
        (
            "zenoh-control-is-efficient",
            "control_saved is significant",
            "at least 10% of the control messages of DDS saved by Zenoh: 50%",
        ),
        (
            "spdp-is-minor",
            "share DDS SPDP 7 2 10 is not dominant",
            "at most 50% of the airtime for SPDP of DDS, 7 h",
        ),
        (
            "one-process-is-low-dds",
            "utilization DDS 3 1 40 is low",
            "DDS with 3 hosts of 1 process with 40 endpoints: 11%",
        ),
        (
            "hundred-hosts-melt-dds",
            "utilization DDS 100 1 0 ≥ 1",
            "at least 100% of a second, DDS with 100 hosts of 1 process with 0 endpoints: 14.8 s",
        ),
        ("frame-spdp", "frame_bytes SPDP = 414", "414 B in a frame of SPDP: 414 B"),
        (
            "overhead-of-unicast",
            "overhead_with_backoff unicast ≈ 180e-6",
            "about 180 µs for preamble, waits, mean back-off and acknowledgement, unicast: 186 µs",
        ),
        (
            "rate-is-mcs-7",
            "ht_rate 7 ≈ 144.4e6 ± 0.05e6",
            "about 144.4 Mbit/s ± 0.05 Mbit/s for MCS 7",
        ),
        (
            "utilization-adds-up",
            "enumeration_ratio DDS 4 2 6 ≈ 1 ± 1e-12",
            "1 but for rounding as the ratio to the air",
        ),
        (
            "peers-are-the-worst-case",
            "least_saved Zenoh_router_per_host 7 16 1 > 0",
            "on 7 to 16 hosts of 1 process: none, it takes 1.49 times as much",
        ),
    ],
)
def test_a_test_as_a_line_and_in_words(key: str, line: str, words: str) -> None:
    test = criterion_of(key)
    assert test.text == line
    assert words in test.in_words()


@pytest.mark.parametrize(
    ("key", "paper", "word"),
    [
        ("rate-is-mcs-7", "≈ 144.4e6 ± 0.05e6", None),
        ("gap-is-marginal", "marginal: ≤ 0.1", "marginal"),
        ("spdp-is-minor", "not dominant: ≤ 0.5", "dominant"),
        ("saturation-dds", "≈ 7", "approximately"),
    ],
)
def test_what_the_paper_says(key: str, paper: str, word: str | None) -> None:
    test = criterion_of(key)
    assert test.paper == paper
    assert test.word == (criteria.vague_terms()[word] if word else None)


def test_every_quantity_has_words_and_says_how_it_is_known() -> None:
    named = [row["quantity"] for row in read_data("paper/quantities.csv", "discostorm_book")]
    parts = [test.quantity.split() for claim in claims.claims() for test in claim.tests]
    tested = {f"default {part[-1]}" if part[0] == "default" else part[0] for part in parts}
    assert sorted(tested) == sorted(named)
    known = {test.provenance for claim in claims.claims() for test in claim.tests}
    assert known <= {"computed", "read in sources", "simulated", "measured"}


def test_numbers_are_shown_to_four_digits_and_expressions_as_they_are() -> None:
    assert claims.format_quantity(sp.Rational(1, 3)) == "0.3333"
    assert claims.format_quantity(2 * ds.notation.N_H) == "2*N_H"
    assert claims.format_quantity("") == ""


@pytest.mark.parametrize(
    ("said", "holds"),
    [
        (("=", 64), True),
        (("=", 65), False),
        (("≈", 65, 1), True),
        (("≈", 65, 0.5), False),
        (("<", 64), False),
        (("≤", 64), True),
        ((">", 64), False),
        (("≥", 64), True),
        (("≈", 61), True),
        (("≈", 60), False),
        (("is", "high"), True),
        (("is not", "high"), False),
        (("is", "small"), False),
        (("is not", "small"), True),
    ],
)
def test_relations(said: tuple[Any, ...], holds: bool) -> None:
    assert criteria.Criterion(QUANTITIES["header"], ("UDP",), *said).holds() is holds


def test_expressions_are_compared_for_all_values() -> None:
    asked = model.load, (ds.DDS, "SPDP"), "="
    assert criteria.Criterion(*asked, N_P * N_H).holds()
    assert not criteria.Criterion(*asked, N_P * N_H + 1).holds()
