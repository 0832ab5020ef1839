"""Output of a plan: sentences, table, JSON and figure."""

import json
import math
from dataclasses import replace
from typing import Any

import pytest
from planner_by_hand import (
    CHANNEL_KINDS,
    FIG3,
    LAPTOP,
    NAV2,
    NAV2_WITH_NODES,
    PLAN_OF_FIG3,
    PRODUCT_OF,
    ROBOTS,
    approx,
    remedy,
)

import discostorm as ds
from discostorm import wording
from discostorm.protocols import MEASURED, MITIGATED
from discostorm.protocols.measured_tables import product_releases
from discostorm_planner import simulation_jobs, staggered_start
from discostorm_planner.answer_text import phrase
from discostorm_planner.result import simulate_protocols

pytestmark = pytest.mark.usefixtures("few_runs")


def words_of_time(seconds: float) -> str:
    if seconds < 0.1:
        return f"{1000 * seconds:.3g} ms"
    if seconds >= 100:
        return f"{seconds / 60:.1f} minutes"
    return f"{seconds:.2f} s" if seconds < 10 else f"{seconds:.1f} s"


@pytest.mark.parametrize("name", ["DDS", "Zenoh"])
def test_a_staggered_start_has_the_window_of_the_rule_of_thumb(name: str) -> None:
    protocol = ds.PROTOCOLS[name]
    found = remedy(ds.plan(ds.Fleet.swarm(20, 2, 10), protocol), "staggered start")
    window, said = staggered_start.start_window(protocol, 20, 2, 10), found.sentence()
    assert found.start_window == window
    assert found.saved == 0
    assert f"over at least {words_of_time(window)}" in said


def test_what_is_repeated_and_fills_the_channel_is_said_first_and_no_window_is_advised() -> None:
    fleet = ds.Fleet((ds.HostGroup(12, 25, 30), ds.HostGroup(2, 3, 200)))
    plan = ds.plan(fleet, ds.PROTOCOLS["Fast DDS"])
    small = ds.plan(ds.Fleet.swarm(4, 2, 10), ds.PROTOCOLS["Fast DDS"])
    simulate_protocols([plan, small])  # without changes, which take longest
    assert plan.steady == ds.utilization(ds.PROTOCOLS["Fast DDS"], plan.fleet, window=math.inf) > 1
    assert plan.why().startswith("The periodic traffic alone needs ")
    assert not any("staggered start" in found.steps for found in plan.remedies)
    (reason,) = (r for r in plan.not_applicable if r.startswith("starting one after the other"))
    assert f"alone needs {wording.percent(plan.steady)} of the channel" in reason
    told = plan.to_dict(simulate=False)
    assert [told["steady"], told["steady_fits"]] == [plan.steady, False]
    for found, row in zip(
        (*plan.remedies, *plan.combinations), told["remedies"] + told["combinations"], strict=True
    ):
        fits = found.steady < 1
        assert (row["start_within_s"] is not None) == fits == math.isfinite(found.start_window)
        assert ("so the fleet never fits" in found.caution()) != fits
    assert {found.steady < 1 for found in plan.remedies} == {True, False}
    # Protocols that fit are reported as before.
    found = remedy(small, "staggered start")
    start = found.before - small.steady
    assert found.start_window == pytest.approx(start / (1 - small.steady))
    assert "The periodic traffic alone" not in small.why()


@pytest.mark.parametrize("name", ds.PROTOCOLS)
@pytest.mark.parametrize("window", [0.5, 1.0, 20, float("inf")])
def test_the_window_is_that_of_utilization_and_is_named(name: str, window: float) -> None:
    table = ds.PROTOCOLS[name]
    plan = ds.plan(FIG3, table, window=window)
    assert plan.utilization == ds.utilization(table, plan.fleet, window=window)
    for found in plan.remedies:
        parts = [
            ds.utilization(found.protocol, part, wifi=found.wifi, window=window)
            for part in found.fleets
        ]
        assert found.utilization == approx(sum(parts))
        assert found.window == window
    text = " ".join(plan.why().split())
    words = {0.5: "the first 0.5 s", 1: "the first second", 20: "the first 20 s"}
    assert words.get(window, "in the steady state") in text
    seconds = plan.to_dict(simulate=False)["window_s"]
    assert seconds == (None if window == float("inf") else window)
    assert ("This can only overstate the airtime" in text) == (table.repeats and window < 1e9)
    measured = name in MEASURED | MITIGATED | product_releases().keys()
    of_paper = table.family is not None
    assert ("as the paper does" in text) == (table.repeats and not measured and of_paper)
    assert (f"The measured model of {phrase(name)} comes from captures" in text) == measured
    if window == 20:
        assert f"needs {words_of_time(20 * plan.utilization)} of airtime" in text


def test_advice_names_what_is_composed_and_its_lines_are_short() -> None:
    assert str(PLAN_OF_FIG3) == PLAN_OF_FIG3.advice()
    for width in (40, 79):
        table, *_ = PLAN_OF_FIG3.why(width).split("What these numbers rest on")
        assert max(map(len, table.splitlines())) <= width
    sentences = [found.sentence() for found in ds.plan(NAV2, ds.ZENOH).remedies]
    assert any("changes the airtime by less than 0.5%" in sentence for sentence in sentences)
    assert any("raises the airtime by 9% (from 26.2 s to 28.4 s)" in s for s in sentences)
    many, two = replace(ROBOTS, processes=8), replace(ROBOTS, processes=2)
    for groups, what in (
        ((many,), "composing 8 processes into 1"),
        ((two, LAPTOP), 'composing 2 processes of "robots" into 1'),
        ((two, replace(LAPTOP, processes=3)), "composing the processes of each host into 1"),
    ):
        assert remedy(ds.plan(ds.Fleet(groups)), "processes").what == what


def test_table_and_json_hold_the_same_numbers() -> None:
    named = replace(NAV2_WITH_NODES.groups[0], name="Bodenläufer", hosts=5)
    plan = ds.plan(ds.Fleet((named, NAV2_WITH_NODES.groups[1])), ds.ZENOH)
    table = plan.to_frame()
    read = json.loads(plan.to_json())
    assert plan.to_json().splitlines()[1].startswith('  "')
    assert "Bodenläufer" in plan.to_json()
    assert read == plan.to_dict()
    assert read["utilization"] == plan.utilization
    assert read["fits"] is False
    assert [group["name"] for group in read["fleet"]] == ["Bodenläufer", "laptop"]
    assert read["left_out"] == list(plan.not_applicable) != []
    told = sum(map(len, plan.sections().values()))
    rest = len(plan.remedies) + len(plan.combinations) - told
    assert f"{rest} more changes, and says why it omits" in plan.why()
    assert read["fleet"][0]["endpoints"] == 678
    entries, every = read["remedies"] + read["combinations"], plan.remedies + plan.combinations
    assert list(table.index) == [entry["what"] for entry in entries]
    columns = (
        "before",
        "utilization",
        "saved",
        "best_case",
        "note",
        "all_find_each_other",
        "fails",
    )
    for column in columns:
        assert table[column].tolist() == [entry[column] for entry in entries]
    assert table["effort"].tolist() == [found.effort_rank for found in every]
    assert table["fits"].tolist() == [found.utilization < 1 for found in every]
    for entry, found in zip(entries, every, strict=True):
        assert entry["price"] == found.trade_offs
        assert len(entry["fleets"]) == len(found.fleets)
    assert [share.share for share in plan.shares] == [entry["share"] for entry in read["shares"]]


def test_no_number_has_two_names_in_json() -> None:
    """No two JSON entries with different names are always equal."""
    said = [
        ds.plan(fleet, table, window=window).to_dict(simulate=False)
        for fleet, window in ((NAV2_WITH_NODES, 20.0), (FIG3, 1.0))
        for table in ds.PROTOCOLS.values()
    ]
    levels = {
        "plan": said,
        "share": [share for plan in said for share in plan["shares"]],
        "remedy": [found for plan in said for found in plan["remedies"]],
    }
    for entries in levels.values():
        columns: dict[tuple[Any, ...], str] = {}
        for name in entries[0]:
            values = tuple(json.dumps(entry[name]) for entry in entries)
            assert values not in columns, (name, columns.get(values))
            columns[values] = name


def test_gains_are_told_from_what_there_was() -> None:
    plan = ds.plan(ds.Fleet.swarm(2, 1e8, 0))
    for found in plan.remedies:
        base = PRODUCT_OF.get(found.protocol.name)
        if base is not None:
            assert found.before == ds.utilization(ds.PROTOCOLS[base], plan.fleet)
            assert found.note == f"both values use the measured model of {base}"
        elif found.kind not in CHANNEL_KINDS:
            assert found.before == plan.utilization
    said = plan.remedies[0].sentence()
    assert "composing 100,000,000 processes into 1 cuts more than a year to" in said
    # The remaining load counts, however small its share of the previous load.
    tiny = [found for found in plan.combinations if found.saved == 1 and found.utilization]
    assert tiny
    assert all("(more than 99%)" in found.sentence() for found in tiny)


def test_what_a_change_adds_to_nothing_is_told() -> None:
    alone, on_robot = ds.Fleet.swarm(1, 2, 5), "Fast DDS Discovery Server, on a robot"
    plan = ds.plan(alone, ds.PROTOCOLS[on_robot])
    assert plan.utilization == 0
    wired = remedy(plan, "discovery server")
    taken = ds.utilization(ds.PROTOCOLS["Fast DDS Discovery Server"], plan.fleet)
    assert wired.sentence() == (
        f"a Discovery Server adds {1000 * taken:.1f} ms; nothing was sent before"
    )
    # In the other direction, nothing remains.
    back = remedy(ds.plan(alone, wired.protocol), "discovery server on a robot")
    assert (back.utilization, back.saved) == (0, 1)
    assert back.sentence().endswith(f"cuts {1000 * taken:.1f} ms to no time (100%)")


def test_several_things_are_told_in_the_plural() -> None:
    plan = ds.plan(FIG3, ds.PROTOCOLS["Fast DDS"])
    said = {found.kind: found.sentence() for found in plan.remedies}
    for kind, start in {
        "discovery server": "a Discovery Server cuts ",
        "two discovery servers": "two Discovery Servers cut ",
        "static endpoints": "static endpoints cut ",
        "processes": "composing 8 processes into 1 cuts ",
        "multicast rate": "sending multicast at 24 instead of 6 Mbit/s c",
        "hybrid": "the hybrid discovery cuts ",
    }.items():
        assert said[kind].startswith(start)
    assert all(" cut " in found.sentence() for found in plan.combinations)


def test_a_host_without_others_is_advised_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(simulation_jobs, "MAX_RUN_SECONDS", 0.0)  # simulates nothing
    for protocol in ds.PROTOCOLS.values():
        advice = ds.plan(ds.Fleet.swarm(1, 2, 10), protocol).why()
        assert advice.endswith("no other host receives its messages.")
        assert "Changes by airtime" not in advice
        assert "Changes by airtime" in ds.plan(ds.Fleet.swarm(2, 2, 10), protocol).why()


def test_sizes_beyond_the_captures_and_full_exchanges_are_told() -> None:
    table = ds.PROTOCOLS["Fast DDS"]
    assert table.captured is not None
    hosts, processes, endpoints = table.captured
    within = ds.plan(ds.Fleet.swarm(hosts, 1, endpoints), table).why()
    beyond = ds.plan(ds.Fleet.swarm(hosts, 1, endpoints + 1), table).why()
    assert f"{processes} processes in all and {endpoints} endpoints per process" in " ".join(
        within.split()
    )
    assert "we extrapolate" not in " ".join(within.split())
    assert "This fleet exceeds these limits, so we extrapolate." in " ".join(beyond.split())
    aggregated = ds.Radio("802.11ac", streams=2, width=80e6, mpdus=64).wifi()
    for size, verdict in (
        (2, "discovery fits"),
        (6, "discovery may fit"),
        (40, "discovery does not fit"),
    ):
        said = ds.plan(ds.Fleet.swarm(size, 2, 10), table, aggregated).why()
        assert verdict in " ".join(said.split())
    assert "discovery fits." in ds.plan(ds.Fleet.swarm(2, 1, 5), table).why()
