"""The first step of an answer: it is enough, and has every name that is printed."""

import pytest

import discostorm as ds
from discostorm.data import read_data
from discostorm_planner import change_simulation, discovery_time, simulation_jobs
from discostorm_planner.changes import Setting
from discostorm_planner.configuration_folder import configuration_texts
from discostorm_planner.discovery_time import DiscoveryTime

FAST_DDS = ds.PROTOCOLS["Fast DDS 3.6"]
AC = ds.WIFI["802.11ac 80 MHz 2x2"]
SMALL = ds.Fleet.swarm(12, 2, 10)


def test_where_no_change_is_enough_the_best_is_simulated_with_a_staggered_start() -> None:
    fleet = ds.Fleet.swarm(40, 6, 20)
    plan = ds.plan(fleet, FAST_DDS, AC)
    found = plan.discovery
    assert not found.works
    assert not [c for c in found.sufficient if "+" not in c.name]
    first = found.sufficient[0]
    assert first.name == "processes + staggered start"
    assert first.start_window > 0
    assert change_simulation.MIDDLEWARE_EFFORTS.isdisjoint(first.remedy.efforts)
    said = " ".join(plan.advice().split())
    assert "First step: 1. Composing 6 processes into" in said
    assert (
        f"and starting one after the other, at random times within {first.start_window:g} s" in said
    )
    assert plan.find_change(first.name) == first.remedy
    texts = configuration_texts(fleet, plan.find_change(first.name), plan.within)
    assert any(f"WINDOW={first.start_window:g}" in text for text in texts)
    assert any("ComposableNodeContainer" in text for text in texts)


@pytest.mark.parametrize(
    ("name", "kind"),
    [
        ("DDS domains", "domains"),
        ("dds DOMAINS", "domains"),
        ("Router on each host", "router on each host"),
        ("a Discovery Server", "discovery server"),
        ("Discovery Servers", "discovery server"),
        ("composing", "processes"),
        ("Composing 3 processes into 2 or fewer", "processes"),
        ("starting one after the other, at random times within 9 s", "staggered start"),
    ],
)
def test_a_change_has_every_name_that_the_answer_and_the_readme_print(name: str, kind: str) -> None:
    plan = ds.plan(ds.Fleet.swarm(6, 3, 20), FAST_DDS)
    assert kind in plan.find_change(name).steps
    with pytest.raises(ValueError, match="Did you mean 'a Discovery Server'"):
        plan.find_change("a discovry server")
    zenoh = ds.plan(ds.Fleet.swarm(6, 3, 20), "rmw_zenoh_cpp")
    with pytest.raises(ValueError, match="here: Zenoh router per host has it already or cannot"):
        zenoh.find_change("DDS domains")


def test_every_name_of_a_change_is_that_of_a_kind() -> None:
    kinds = {row["kind"] for row in read_data("vendors/remedies.csv")}
    for row in read_data("vendors/change_names.csv", "discostorm_planner"):
        assert row["kind"] in kinds, row
        assert row["source"]


def test_a_long_run_with_few_pairs_is_the_only_one() -> None:
    found = ds.plan(ds.Fleet.swarm(24, 12, 20), FAST_DDS, AC)
    job = simulation_jobs.prepare_job(found._setting, 60.0)
    assert isinstance(job, simulation_jobs.Job)
    assert job.cost_s > simulation_jobs.LONG_RUN_S
    work = simulation_jobs.WorkMeter(None, job.cost_s)
    ((place, time),) = simulation_jobs.simulate_jobs([job], work)
    assert isinstance(time, DiscoveryTime)
    assert (place, len(time.times)) == (0, 1)
    assert time.pairs_done[0] < discovery_time.MIN_PAIRS
    assert work.done == pytest.approx(work.total)
    short = simulation_jobs.prepare_job(Setting(SMALL, FAST_DDS, ds.PAPER), 60.0)
    assert isinstance(short, simulation_jobs.Job)
    assert [p for p, _ in simulation_jobs.simulate_jobs([job, short], work)] == [0, 1]


def test_times_beyond_those_watched_are_said_to_be_extrapolated() -> None:
    said = [
        " ".join(ds.plan(ds.Fleet.swarm(n, 2, 10), "Fast DDS 2.6", "802.11g").advice().split())
        for n in (4, 8)
    ]
    watched = "We observed real startups for at most 15 s, and extrapolate beyond."
    assert [watched in one for one in said] == [False, True]
