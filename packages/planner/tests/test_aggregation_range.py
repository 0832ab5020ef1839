"""Ranges of a radio that aggregates: one entry, two ends."""

import json
import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

import discostorm as ds
from discostorm.cli import main
from discostorm.data import data_path
from discostorm.robots import laptop, robots
from discostorm.wifi.radio import aggregation_bounds, most_mpdus, radio_named
from discostorm_planner import simulation_jobs
from discostorm_planner.aggregation_range import AggregationRange
from discostorm_planner.configuration_folder import configuration_texts
from discostorm_planner.result import simulate_protocols

pytestmark = pytest.mark.usefixtures("few_runs")

AC = ds.WIFI["802.11ac 80 MHz 2x2"]
FAST_DDS = ds.PROTOCOLS["Fast DDS"]


def fleet_of(robot: str, hosts: float, laptops: int = 0) -> ds.Fleet:
    groups = [replace(robots()[robot], hosts=hosts)]
    return ds.Fleet((*groups, laptop()) if laptops else tuple(groups))


@pytest.mark.parametrize("name", ds.WIFI)
def test_every_radio_from_802_11n_on_has_two_ends_and_no_other(name: str) -> None:
    wifi = ds.WIFI[name]
    full, single = aggregation_bounds(wifi)
    assert single == wifi
    old = name.startswith(("802.11a ", "802.11g"))
    assert (full == single) == old
    if not old:
        assert full.aggregation is not None
        assert full.aggregation.mpdus == 64
        # The name of version 0.2.0, with ", A-MPDU 64", gives the same channels.
        assert aggregation_bounds(radio_named(f"{name}, A-MPDU 64").wifi()) == (full, single)
    assert most_mpdus("802.11a") == 1


def test_what_is_no_radios_channel_has_one_end() -> None:
    changed = replace(AC, unicast=replace(AC.unicast, overhead=1e-4))
    for wifi in (ds.PAPER, changed, ds.Wifi("own", ds.PAPER.unicast, ds.PAPER.multicast)):
        assert aggregation_bounds(wifi) == (wifi, wifi)
        plan = ds.plan(ds.Fleet.swarm(5, 2, 10), FAST_DDS, wifi)
        assert not plan.utilization_range.differs
        assert plan.utilization_range.single == plan.utilization
    many = ds.Radio("802.11ax", streams=2, width=80e6, mpdus=256).wifi()
    full, single = aggregation_bounds(many)
    assert full == many
    assert single == ds.WIFI["802.11ax 80 MHz 2x2"]
    assert aggregation_bounds(replace(AC, name="mine"))[1].name == "mine"


@pytest.mark.parametrize("hosts", [2, 5, 12, 40])
@pytest.mark.parametrize("name", ["DDS", "Fast DDS", "Zenoh router", "Cyclone DDS peers"])
def test_one_access_point_has_one_answer(name: str, hosts: int) -> None:
    """The names with and without aggregation give the same range: both channels are its ends."""
    table, fleet = ds.PROTOCOLS[name], fleet_of("Nav2 in one process", hosts)
    full = ds.Radio("802.11ac", streams=2, width=80e6, mpdus=64).wifi()
    plan, again = (ds.plan(fleet, table, wifi) for wifi in (AC, full))
    assert plan.to_dict(simulate=False) == again.to_dict(simulate=False)
    assert plan.utilization_range.single == ds.utilization(table, fleet, wifi=AC)
    assert plan.utilization_range.full == ds.utilization(table, fleet, wifi=full)
    assert plan.startup.single == ds.drain_time(table, fleet, wifi=AC)
    assert plan.startup.full == ds.drain_time(table, fleet, wifi=full)
    for found in (*plan.remedies, *plan.combinations):
        ends = [one.single for one in (found.range_before, found.range_after)]
        assert [found.before, found.utilization] == ends
    told = plan.to_dict(simulate=False)
    assert told["verdict"] == plan.verdict
    assert told["fits"] == (plan.utilization_range.single < 1)
    assert told["range"]["full_ampdus"] == plan.utilization_range.full


@pytest.mark.parametrize(
    ("full", "single", "verdict"),
    [
        (0.2, 0.9, "fits"),
        (0.2, 1.0, "may fit"),
        (0.99, 30.0, "may fit"),
        (1.2, 0.5, "may fit"),  # frames too long to share an exchange
        (1.0, 1.0, "does not fit"),
        (1.5, math.inf, "does not fit"),
    ],
)
def test_it_fits_if_the_slowest_end_does(full: float, single: float, verdict: str) -> None:
    assert AggregationRange(full, single).verdict == verdict
    plan = ds.plan(ds.Fleet.swarm(5, 2, 10), FAST_DDS, AC)
    assert replace(plan, utilization_range=AggregationRange(full, single)).verdict == verdict


def test_explanations_have_the_smaller_end_alone() -> None:
    plan = ds.plan(fleet_of("Nav2 in one process", 8), FAST_DDS, AC)
    low = plan.startup.full
    assert low < plan.startup.single
    text = " ".join(plan.why().split())
    assert f"busy for at least {low:.2f} s if nothing is lost. " in text
    assert "The drain time assumes full A-MPDUs. " in text
    assert f"{plan.startup.single:.1f} s" not in text
    assert "one message per frame" not in text
    # Airtime with one frame in each exchange would contradict the simulated times.
    assert "cuts the airtime" not in text
    paper = ds.plan(plan.fleet, FAST_DDS)
    simulate_protocols([paper])  # without changes, which take longest
    assert "at least" not in " ".join(paper.why().split()).partition("while nodes start")[0]


def test_the_answer_comes_first_then_airtime_then_why() -> None:
    plan = ds.plan(fleet_of("Nav2 in one process", 8), FAST_DDS, AC)
    text = " ".join(plan.why().split())
    assert text.startswith("Drain time: startup keeps the channel busy for ")
    order = ["Drain time", "of airtime", "Utilization in", "largest shares", "Changes, in the same"]
    places = [text.index(part) for part in order]
    assert places == sorted(places)
    # Stored simulations are for the calculator; the discovery time is simulated anew.
    assert "discovered each other" not in text


def test_a_change_may_make_it_fit() -> None:
    plan = ds.plan(fleet_of("Nav2 in one process", 12), FAST_DDS, AC)
    assert plan.verdict == "does not fit"
    verdicts = {found.verdict for found in plan.remedies}
    assert "may fit" in verdicts
    for found in plan.remedies:
        assert found.may_now_fit == (found.verdict == "may fit")
        assert found.now_fits == (found.verdict == "fits")
    assert any("The fleet may then fit." in found.sentence() for found in plan.remedies)
    assert "aggregation: already counted" in " ".join(plan.not_applicable)


# ---- the command ----


@pytest.fixture
def file(tmp_path: Path) -> str:
    path = tmp_path / "fleet.toml"
    path.write_text(
        '[[groups]]\nname = "robots"\nhosts = 8\nprocesses = 1\nendpoints = 678\nnodes = 13\n',
        encoding="utf-8",
    )
    return str(path)


def run(*arguments: str) -> Any:
    return CliRunner().invoke(main, list(arguments))


def test_paste_prints_the_configuration_of_each_change_that_the_answer_names() -> None:
    options = ("plan", "--hosts", "12", "--processes", "2", "--endpoints", "10")
    options = (*options, "--protocol", "Fast DDS 2.9")
    plan = ds.plan(ds.Fleet.swarm(12, 2, 10), FAST_DDS)
    answer = " ".join(run(*options, "--all").stdout.split())
    named = [change for change in plan.discovery.helpful if change.remedy.snippets]
    assert len(named) > 3
    for change in named:
        name = f"'{change.name}'" if " " in change.name else change.name
        assert f"--paste {name}." in answer
        done = run(*options, "--paste", change.name)
        assert done.exit_code == 0
        pieces = change.remedy.snippets
        texts = configuration_texts(plan.fleet, change.remedy, plan.within)
        assert done.stdout == "\n".join(texts)
        assert len(texts) == len(pieces)
        assert all(piece.load.split()[0] in done.stdout for piece in pieces)
        assert change.remedy.what[1:] in done.stderr
    rows = json.loads(run(*options, "--paste", "Discovery Server", "--json").stdout)
    server = plan.find_change("discovery server")
    assert [row["text"] for row in rows] == configuration_texts(plan.fleet, server, plan.within)
    assert "ADDRESS_OF_server:11811" in rows[1]["text"]


def test_the_window_of_a_pasted_staggered_start_is_that_of_the_plan(file: str) -> None:
    options = ("plan", file, "--protocol", "fast dds 2.9", "--paste", "staggered start")
    plan = ds.plan(ds.Fleet.from_toml(file), FAST_DDS)
    window = plan.find_change("staggered start").start_window
    assert 5 < window < 30
    assert f"\nWINDOW={math.ceil(window)}\n" in run(*options).stdout
    assert "\nWINDOW=5\n" in run(*options, "--within", "10").stdout  # at most half of the target


@pytest.mark.parametrize("name", ["0", "1", "discovery serve", "nothing like it"])
def test_paste_of_no_such_change_says_where_the_names_are(file: str, name: str) -> None:
    done = run("plan", file, "--paste", name)
    assert done.exit_code == 2
    assert "--paste: no change is named" in done.stderr
    near = "Did you mean 'discovery server'?" if name == "discovery serve" else "`plan --all` lists"
    assert near in " ".join(done.stderr.split())
    assert done.stdout == ""


@pytest.mark.parametrize("command", ["utilization", "saturation"])
def test_commands_have_both_ends(command: str) -> None:
    swarm = ("--processes", "2", "--endpoints", "10")
    hosts = ("--hosts", "7") if command == "utilization" else ()
    of = "utilization" if command == "utilization" else "hosts"
    rows = [
        json.loads(run(command, *hosts, *swarm, "--wifi", name, "--json").stdout)
        for name in (AC.name, f"{AC.name}, A-MPDU 64")
    ]
    assert rows[0] == rows[1]
    for row in rows[0]:
        table = ds.PROTOCOLS[row["protocol"]]
        # As in a fleet file, processes share ROS 2's own topics.
        fleet = ds.Fleet((ds.HostGroup(7, 2, 10, shared=2),))
        for key, wifi in ((of, AC), (f"{of}_full_ampdus", aggregation_bounds(AC)[0])):
            if command == "utilization":
                assert row[key] == ds.utilization(table, fleet, wifi=wifi)
            else:
                assert row[key] == ds.saturation_hosts(table, fleet=fleet, wifi=wifi)
    assert "This radio aggregates frames" in run(command, *hosts, *swarm, "--wifi", AC.name).stdout
    paper = run(command, *hosts, *swarm)
    assert "aggregates" not in paper.stdout
    assert "A-MPDU" not in paper.stdout


def test_radio_names_are_read_with_and_without_an_a_mpdu(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(simulation_jobs, "MAX_RUN_SECONDS", 0.0)  # simulates nothing
    path = str(data_path("fleets/nav2_laptop.toml"))
    for name in ds.WIFI:
        for ending in (
            "",
            *([", A-MPDU 64"] if aggregation_bounds(ds.WIFI[name])[0] != ds.WIFI[name] else []),
        ):
            done = run("plan", path, "--wifi", name + ending, "--json")
            assert done.exit_code == 0, done.output
            assert json.loads(done.stdout)["wifi"] == name
