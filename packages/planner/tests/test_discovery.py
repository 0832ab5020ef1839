"""The answer of a plan: discovery times that depend on fleet and seeds only, in few lines."""

import json
import math
from csv import DictReader
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import simulated_once
from click.testing import CliRunner

import discostorm as ds
from discostorm.cli import main
from discostorm.robots import robots
from discostorm_planner import (
    answer_text,
    change_simulation,
    discovery_time,
    fleet_changes,
    remedy_rules,
    simulation_jobs,
)
from discostorm_planner.change_simulation import DiscoveryResult
from discostorm_planner.changes import Setting
from discostorm_planner.discovery_time import DiscoveryTime
from discostorm_planner.result import simulate_protocols

FAST_DDS = ds.PROTOCOLS["Fast DDS 3.6"]
AC = ds.WIFI["802.11ac 80 MHz 2x2"]
SMALL = ds.Fleet.swarm(12, 2, 10)
#: As `--hosts 12 --processes 2 --endpoints 10` means it: processes share ROS 2's own topics.
GIVEN = ds.Fleet((ds.HostGroup(12, 2, 10, shared=2),))
#: What no answer and no explanation says.
FORBIDDEN = (
    *("(just below 100%)", "charged to", "Charged to", " at best", "over at least indefinitely"),
    *("hours → seconds", "of a second", "airtime of the first second", "for indefinitely"),
)


def as_it_is(fleet: ds.Fleet, protocol: ds.Protocol, wifi: ds.Wifi = ds.PAPER) -> DiscoveryResult:
    """Return the discovery of a fleet without its changes, which take longest to simulate."""
    plan = ds.plan(fleet, protocol, wifi)
    simulate_protocols([plan])
    return plan.discovery


def fleet_of(name: str, hosts: int) -> ds.Fleet:
    return ds.Fleet((replace(robots()[name], hosts=hosts),))


FLEETS = {
    "small robots": (SMALL, "Fast DDS", ds.PAPER),
    "small robots, Cyclone DDS": (SMALL, "Cyclone DDS", ds.PAPER),
    "small robots, Zenoh": (SMALL, "Zenoh peer, tokens", AC),
    "small robots, router": (SMALL, "Zenoh router", ds.PAPER),
    "nodes": (fleet_of("One bare node", 12), "Fast DDS", AC),
    "Nav2": (fleet_of("Nav2 in one process", 8), "Fast DDS", AC),
    "Nav2, paper": (fleet_of("Nav2 in one process", 4), "Fast DDS", ds.PAPER),
    "drones": (fleet_of("Drone, PX4 through uXRCE-DDS", 5), "Cyclone DDS", AC),
    "arms": (fleet_of("Manipulator with MoveIt", 4), "Fast DDS", ds.PAPER),
    "one TurtleBot 4": (fleet_of("TurtleBot 4 with Nav2", 2), "Fast DDS", AC),
    "too many": (ds.Fleet.swarm(100_000, 2, 10), "Fast DDS", ds.PAPER),
    "alone": (ds.Fleet.swarm(1, 2, 10), "Fast DDS", ds.PAPER),
}


@pytest.fixture(scope="module")
def plans() -> dict[str, ds.Plan]:
    return {name: ds.plan(f, ds.PROTOCOLS[p], wifi) for name, (f, p, wifi) in FLEETS.items()}


@pytest.mark.parametrize("name", FLEETS)
def test_an_answer_has_at_most_25_lines_and_none_of_the_old_phrases(
    name: str, plans: dict[str, ds.Plan]
) -> None:
    plan = plans[name]
    lines = plan.advice().splitlines()
    assert len(lines) <= 25
    assert max(map(len, lines)) <= 79
    assert lines[0].startswith(("Yes", "Probably", "No", "A single host"))
    told = " ".join(plan.advice().split()) + " ".join(plan.advice(all_changes=True).split())
    for phrase in FORBIDDEN:
        assert phrase not in told
        assert phrase not in " ".join(plan.why().split())
    assert "1.14 nodes" not in plan.why()


@pytest.mark.parametrize(
    ("release", "hosts", "verdict"),
    [
        (
            "Fast DDS 2.6",
            12,
            "No: 12 hosts do not complete discovery within 60 s (Fast DDS 2.6, on ",
        ),
        ("Fast DDS", 12, "No: 12 hosts do not complete discovery within 60 s (Fast DDS, on "),
        (
            "Fast DDS 2.14",
            12,
            "No: in 7 of 10 runs, 12 hosts do not complete discovery within 60 s (Fast DDS 2.14",
        ),
        ("Fast DDS 3.6", 12, "Yes, this startup works: 12 hosts discover each other within 60 s"),
        ("Fast DDS 2.6", 3, "Yes, this startup works: 3 hosts "),  # few messages are lost
    ],
)
def test_the_collapse_of_a_release_is_simulated_and_the_answer_is_sure(
    release: str, hosts: int, verdict: str
) -> None:
    plan = ds.plan(ds.Fleet.swarm(hosts, 2, 10), ds.PROTOCOLS[release])
    said = " ".join(plan.advice().split())
    assert said.startswith(verdict)
    assert plan.to_dict()["discovery"]["caution"] is None
    found = plan.discovery
    assert found.today is not None
    if found.works:
        assert found.surely_works
    else:
        assert math.isinf(found.today.median)
        assert found.today.lost > 0.5
        assert f"more than {release} can resend" in said


def test_an_interrupt_of_the_reboot_leaves_the_rest_of_the_answer(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def interrupted(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("discostorm_planner.result.simulate_late_join", interrupted)
    said = ds.plan(ds.Fleet.swarm(3, 2, 10), FAST_DDS).advice()
    assert said.startswith("Yes, this startup works")
    assert "reboot" not in said


@pytest.mark.parametrize(
    ("release", "slowest", "said"),
    [
        (
            "Fast DDS 2.6",
            1.05,
            "up to 12 hosts took 0.72 to 1.05 times",
        ),
        (
            "Fast DDS 2.14",
            1.19,
            "up to 12 hosts took 1.04 to 1.19 times",
        ),
    ],
)
def test_a_server_is_judged_by_the_release_of_its_clients(
    release: str, slowest: float, said: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(discovery_time, "MIN_RELATIVE_GAIN", 0.0)  # the server gains little here
    fleet = ds.Fleet((ds.HostGroup(8, 2, 10),), matching=1.0)
    plan = ds.plan(fleet, ds.PROTOCOLS[release], "802.11g 20 MHz")
    (server,) = (c for c in plan.discovery.changes if c.name == "discovery server")
    assert server.time is not None
    assert server.time.works(60)
    assert server.suffices(60)
    assert server.slowest == slowest
    assert said in " ".join(plan.advice().split())


def test_what_the_simulation_leaves_out_makes_an_answer_unsure_where_messages_are_lost(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def caution(protocol: ds.Protocol) -> str:
        fast_dds = protocol.key == FAST_DDS.key
        return "it repeats otherwise" if fast_dds else ""

    monkeypatch.setattr(remedy_rules, "simulation_caution", caution)
    few, many = (ds.plan(ds.Fleet.swarm(n, 2, 10), FAST_DDS) for n in (3, 12))
    assert few.advice().startswith("Yes, this startup works")
    assert few.discovery.surely_works
    said = " ".join(many.advice(all_changes=True).split())
    assert said.startswith("Not sure: in simulations, 12 hosts discover each other within 60 s")
    assert "). But it repeats otherwise." in said
    assert many.to_dict()["discovery"]["caution"] == "it repeats otherwise"
    assert (many.discovery.works, many.discovery.surely_works) == (True, False)
    kinds = {change.remedy.kind: change.time for change in many.discovery.changes}
    composed = kinds["processes"]
    assert composed is not None
    assert composed.works(60)
    covered = {change.remedy.kind for change in many.discovery.sufficient}
    assert "processes" not in covered
    assert {"static endpoints", "multicast endpoint data"} <= covered
    told = "To be sure, make one of these changes, least effort first:"
    assert told in said
    assert "First step" not in said
    options = ["plan", "--hosts", "12", "--processes", "2", "--endpoints", "10"]
    both = run(*options, "--protocol", "Fast DDS 3.6", "--protocol", "Fast DDS 2.6")
    assert "Not sure for Fast DDS 3.6: it repeats otherwise." in " ".join(both.stdout.split())


def test_a_robot_that_starts_later_is_simulated_after_the_others() -> None:
    robots = (ds.HostGroup(4, 1, 10, "small"), ds.HostGroup(3, 2, 10, "large"))
    desk = ds.HostGroup(1, 3, 10, "desk", wired=True)
    plan = ds.plan(ds.Fleet((*robots, desk)), FAST_DDS)
    today, late = plan.discovery.today, plan.late_join
    assert today is not None
    assert late is not None
    begin = math.ceil(today.times[-1])
    starts = [0.0] * 6 + [begin, 0.0]  # the last of the large ones
    fleet = ds.Fleet((*robots, desk))
    found = ds.simulate(fleet, FAST_DDS, ds.PAPER, runs=10, seed=0, until=60.0, start=starts)
    assert late.times == tuple(sorted(time - begin for time in found.convergence_time.tolist()))
    assert max(late.times) < today.median
    said = " ".join(plan.advice().split())
    assert "If one robot reboots, all others have rediscovered it 0." in said
    assert ", and no other robot's lease expires." in said
    again = plan.to_dict()["known_again"]
    assert again["median_s"] == late.median
    assert (again["low_s"], again["high_s"]) == late.median_interval
    assert again["runs_with_expired_leases"] == 0
    never = ds.plan(SMALL, ds.PROTOCOLS["Cyclone DDS"])
    assert never.late_join is None
    assert never.to_dict()["known_again"] is None
    said = " ".join(never.advice().split())
    assert "reboots" not in said
    assert ds.plan(ds.Fleet.swarm(1, 2, 10), FAST_DDS).late_join is None


def test_another_ros_release_is_a_change_where_it_was_measured() -> None:
    def releases(name: str) -> dict[str, str]:
        found = ds.plan(SMALL, ds.PROTOCOLS[name]).remedies
        return {r.protocol.name: r.what for r in found if r.kind == "release"}

    assert releases("Fast DDS 2.6") == {
        "Fast DDS 2.14": "moving to ROS 2 Jazzy (Fast DDS 2.14)",
        "Fast DDS 3.6": "moving to ROS 2 Lyrical (Fast DDS 3.6)",
    }
    # Jazzy is the newest with long-term support that ships it.
    assert releases("Cyclone DDS, version 11") == {
        "Cyclone DDS": "moving to ROS 2 Jazzy (Cyclone DDS)"
    }
    for name in ("Zenoh peer, tokens", "DDS", "Fast DDS Discovery Server"):
        assert not releases(name)
    plan = ds.plan(ds.Fleet.swarm(10, 2, 10), ds.PROTOCOLS["Fast DDS 2.6"])
    assert not any("switching to Fast DDS" in r.what for r in plan.remedies)
    assert not plan.discovery.works
    (release,) = (c for c in plan.discovery.helpful if c.remedy.kind == "release")
    assert release in plan.discovery.sufficient
    assert release.time is not None
    newer = as_it_is(plan.fleet, ds.PROTOCOLS["Fast DDS 2.14"])
    assert newer.today == release.time
    said = " ".join(plan.advice(all_changes=True).split())
    told = answer_text.describe_time(release.time)
    assert f"-> {told}. Effort: another ROS release. Trade-off: all computers need the new" in said


def test_domains_are_simulated_as_parts_that_share_the_channel() -> None:
    plan = ds.plan(SMALL, FAST_DDS)
    (domains,) = (c for c in plan.discovery.changes if c.remedy.kind == "domains")
    today = plan.discovery.today
    assert domains.time is not None
    assert today is not None
    assert domains not in plan.discovery.helpful
    parts = domains.remedy.fleets
    alone = ds.simulate(parts[0], FAST_DDS, ds.PAPER, runs=10, seed=0, until=60.0)
    assert np.median(alone.convergence_time) < domains.time.median < today.median
    said = " ".join(plan.advice(all_changes=True).split())
    assert f"no longer discover each other: splitting into {len(parts)} domains, " in said
    assert "Real times are longer, because messages of different domains also collide" in said
    job = simulation_jobs.prepare_job(Setting(SMALL, FAST_DDS, ds.PAPER), 60.0)
    assert isinstance(job, simulation_jobs.Job)
    slow = job.slowed_by(3.0).setup
    own = job.setup.kinds_of_cells["time_up"]
    assert (slow.kinds_of_cells["time_up"] == 3 * own).all()
    assert slow.radio["slot"] == 3 * job.setup.radio["slot"]
    assert slow.radio["lifetime"] == job.setup.radio["lifetime"]


def test_the_smallest_reduction_that_suffices_is_said_and_what_fits_as_it_is() -> None:
    fleet = ds.Fleet.swarm(12, 6, 8)
    plan = ds.plan(fleet, FAST_DDS)
    found = plan.discovery
    (change,) = (c for c in found.changes if c.remedy.kind == "processes")
    assert not found.works
    assert change.suffices(60)
    assert change.smallest is not None
    (composed,) = change.smallest.remedy.fleets
    count = int(composed.groups[0].processes)
    assert 1 < count < 6
    assert composed.groups[0].endpoints * count == 48
    more = fleet_changes.compose(fleet, count + 1)
    assert change.smallest.suffices(60)
    beyond = as_it_is(more, FAST_DDS)
    assert beyond.today is not None
    assert not beyond.works
    said = " ".join(plan.advice(all_changes=True).split())
    assert f"Composing 6 processes into {count} or fewer: never" in said
    assert " if all are composed into one" in said
    assert found.to_dict()["changes"][found.changes.index(change)]["enough"]["suffices"]


def test_the_first_step_needs_no_other_software() -> None:
    plan = ds.plan(ds.Fleet.swarm(12, 4, 60), FAST_DDS)
    found = plan.discovery
    assert all(
        change_simulation.SOFTWARE_EFFORTS.intersection(c.remedy.efforts) for c in found.sufficient
    )
    assert found.hosts_in_time is not None
    name, count, time = found.hosts_in_time
    assert (name, time.works(60)) == ("", True)
    assert 2 <= count < 12
    assert as_it_is(ds.Fleet.swarm(count, 4, 60), FAST_DDS).today == time
    more = as_it_is(ds.Fleet.swarm(count + 1, 4, 60), FAST_DDS)
    assert more.today is not None
    assert not more.works
    said = " ".join(plan.advice().split())
    stopgap = (
        f"Until you make such a change, start no more than {count} of the 12 hosts on this channel."
    )
    assert stopgap in said
    assert said.index("First step: 1. ") < said.index(stopgap)
    assert found.to_dict()["hosts_in_time"] == {"group": "", "hosts": count}
    assert ds.plan(SMALL, FAST_DDS).discovery.hosts_in_time is None


def test_a_change_with_which_the_simulation_cannot_tell_does_not_suffice() -> None:
    plan = ds.plan(SMALL, ds.PROTOCOLS["Fast DDS 2.6"])
    one = plan.discovery.changes[0]
    lossy = replace(one, time=replace(time(1.0, 1.0), lost=0.5), caution="")
    assert lossy.suffices(60)
    assert not replace(lossy, caution="it repeats otherwise").suffices(60)
    assert replace(lossy, caution="it repeats otherwise", time=time(1.0)).suffices(60)
    longer = [r for r in plan.remedies if r.kind == "announcements"]
    assert longer
    assert [r.protocol.key for r in longer] == [None]


def test_equal_seeds_give_equal_answers() -> None:
    one, other = (ds.plan(SMALL, FAST_DDS) for _ in range(2))
    assert one.discovery is one.discovery
    simulated_once.CACHED_RESULTS.clear()
    assert one.discovery == other.discovery
    assert one.to_json() == other.to_json()
    assert one.advice() == other.advice()


def test_today_is_what_simulate_finds_with_recovery() -> None:
    today = ds.plan(SMALL, FAST_DDS).discovery.today
    assert today is not None
    found = ds.simulate(SMALL, FAST_DDS, ds.PAPER, runs=10, seed=0, until=60.0)
    assert today.times == tuple(sorted(found.convergence_time.tolist()))
    assert today.median == pytest.approx(np.median(found.convergence_time))
    assert today.nine_of_ten == sorted(found.convergence_time)[8]
    assert today.median_interval == (today.times[1], today.times[8])
    done = [np.sort(run)[math.ceil(0.95 * run.size) - 1] for run in found.pair_times]
    assert today.most_pairs_s == pytest.approx(np.median(done))
    assert (today.repaired, today.simulated_seconds, today.pairs_done) == (True, 60.0, (1.0,) * 10)


def test_a_startup_works_if_nine_of_ten_runs_meet_the_target() -> None:
    at_ease, in_haste = (ds.plan(SMALL, FAST_DDS, within=within) for within in (60, 5))
    assert at_ease.discovery.today == in_haste.discovery.today
    assert (at_ease.discovery.works, in_haste.discovery.works) == (True, False)
    assert at_ease.advice().startswith("Yes, this startup works: 12 hosts discover each other ")
    assert in_haste.advice().startswith("No, not within 5 s: ")
    for change in in_haste.discovery.sufficient:
        assert change.time is not None
        assert change.time.nine_of_ten <= 5
    for wrong in (0, -1, 601, math.nan):
        with pytest.raises(ValueError, match="within must be"):
            ds.plan(SMALL, FAST_DDS, within=wrong)


def test_what_suffices_with_little_effort_comes_first_and_nothing_gains_less_than_it_scatters(
    plans: dict[str, ds.Plan],
) -> None:
    several = 0
    for plan in plans.values():
        found = plan.discovery if plan.fleet.hosts() > 1 else None
        if found is None or found.today is None:
            continue
        orders = [change.sort_key(found.within) for change in found.changes if change.time]
        assert orders == sorted(orders)
        # 9 single changes, 2 that split the fleet, and 3 combinations of each of three kinds.
        assert len({change.name for change in found.changes}) == len(found.changes) <= 20
        works = [change in found.sufficient for change in found.helpful]
        assert works == sorted(works, reverse=True)
        ranks = [
            (
                any(e in change_simulation.SOFTWARE_EFFORTS for e in c.remedy.efforts),
                c.remedy.effort_rank,
            )
            for c in found.sufficient
        ]
        assert ranks == sorted(ranks)
        for change in found.helpful:
            assert change.time is not None
            gained = change.time.median_interval[1] < found.today.median_interval[0]
            never = math.isinf(found.today.median_interval[0])
            assert gained or never or (change in found.sufficient and not found.surely_works)
        several += len(found.sufficient) > 1
        combined = any("+" in change.name for change in found.changes)
        singles = [c for c in found.sufficient if "+" not in c.name]
        assert not (combined and (found.surely_works or singles))
    assert several > 2


def time(*times: float, pairs: tuple[float, ...] = (), repaired: bool = True) -> DiscoveryTime:
    lost = (0.1, 0.0, 0.0)
    kept = (0.0,) * len(times)
    return DiscoveryTime(times, pairs, 1.0, 0.1, lost, kept, 60.0, repaired)


def test_times_that_overlap_gain_nothing_and_those_without_repairs_are_lower_bounds() -> None:
    today = time(8.0, 9.0, 10.0)
    assert time(5.0, 6.0, 7.9).is_shorter_than(today)
    assert not time(5.0, 6.0, 8.0).is_shorter_than(today)
    never = time(*[math.inf] * 3, pairs=(0.1, 0.2, 0.3))
    assert today.is_shorter_than(never)
    assert not never.is_shorter_than(today)
    assert time(*[math.inf] * 3, pairs=(0.4,) * 3).is_shorter_than(never)
    assert not time(*[math.inf] * 3, pairs=(0.3, 0.4, 0.5)).is_shorter_than(never)
    bound = time(1.0, 1.0, 1.0, repaired=False)
    assert bound.is_lower_bound
    assert not bound.works(60)
    assert answer_text.describe_time(bound) == "1 s or longer, with 10% of the messages lost"
    assert answer_text.describe_time(today) == "9 s (8 to 10 s)"
    assert answer_text.describe_time(time(0.0278, 0.0294, 0.0304)) == "29 ms (28 to 30 ms)"
    assert answer_text.describe_time(time(0.096, 0.1, 0.11)) == "0.1 s (96 ms to 0.11 s)"
    assert answer_text.describe_time(never) == "never (10% to 30% of pairs complete)"
    few = time(*[math.inf] * 3, pairs=(0.001, 0.005, 0.01))
    assert answer_text.describe_time(few) == "never (at most 1% of pairs complete)"
    named = [answer_text._most_runs(runs) for runs in (2, 3, 10)]
    assert named == ["both runs", "all 3 runs", "nine of ten runs"]


def test_a_startup_works_only_if_no_lease_expires_in_nine_of_ten_runs() -> None:
    kept = time(*[5.0] * 10)
    once = replace(kept, expired_per_pair=(0.0,) * 9 + (0.1,))
    twice = replace(kept, expired_per_pair=(0.0,) * 8 + (0.1,) * 2)
    assert [each.works(60) for each in (kept, once, twice)] == [True, True, False]
    # The run that is too slow is another than the one in which a lease expires.
    slow = replace(once, times=(*[5.0] * 9, 70.0), expired_per_pair=(0.1, *[0.0] * 9))
    assert not slow.works(60)
    assert replace(slow, expired_per_pair=(*[0.0] * 9, 0.1)).works(60)
    zenoh = ds.plan(SMALL, ds.PROTOCOLS["Zenoh peer, tokens"])
    found = zenoh.discovery
    assert found.today is not None
    assert found.today.nine_of_ten < 60
    runs = ds.simulate(SMALL, zenoh.protocol, ds.PAPER, runs=10, seed=0, until=60.0)
    assert found.today.expired_lease_runs == (runs.counts["expired"] > 0).sum() > 1
    assert not found.works
    said = " ".join(zenoh.advice().split())
    assert said.startswith("No: 12 hosts discover each other (Zenoh with peers and tokens")
    assert f"again in {found.today.expired_lease_runs} of 10 runs, because leases expire" in said
    for change in found.sufficient:
        assert change.time is not None
        assert change.time.expired_lease_runs <= 1


def test_what_stops_a_start_is_named() -> None:
    assert time(math.inf).slowdown_causes(1.0) == ["periodic traffic fills"]
    assert time(math.inf).slowdown_causes(0.5) == ["robots lose"]
    many = replace(time(math.inf), lost_by_place=(0.1, 0.2, 0.0), expired_per_pair=(3.0,))
    assert many.slowdown_causes(0.5) == ["access point loses", "leases end"]
    for key in ("periodic traffic fills", "robots lose", "access point loses", "leases end"):
        assert key in answer_text.SENTENCES
    plan = ds.plan(SMALL, ds.PROTOCOLS["Cyclone DDS"])
    said = " ".join(plan.advice().split())
    assert said.startswith("No: 12 hosts do not complete discovery within 60 s")
    assert "Meanwhile, leases expire" in said
    assert "of process pairs have discovered each other" in said
    said = " ".join(replace(plan, within=5.0).advice().split())
    told = "No, not within 5 s: 12 hosts do not complete discovery even within 60 s"
    assert said.startswith(told)


def test_a_fleet_that_is_not_simulated_has_its_drain_time_and_says_why() -> None:
    plan = ds.plan(ds.Fleet.swarm(100_000, 2, 10), FAST_DDS)
    assert plan.discovery.today is None
    said = " ".join(plan.advice().split())
    assert said.startswith("No: 100,000 hosts never complete discovery")
    assert "Not simulated: " in said
    assert "No change is enough: with each of them, periodic traffic alone still" in said
    assert "year" not in said + " ".join(plan.why().split()).replace("more than a year", "")


def test_wired_hosts_are_simulated_without_airtime_on_their_hop() -> None:
    carts = ds.HostGroup(6, 2, 40, "carts")
    desk = ds.HostGroup(1, 1, 40, "desk", wired=True)
    plan, all_on_air = (
        ds.plan(ds.Fleet((carts, one)), "Fast DDS 2.14", AC)
        for one in (desk, replace(desk, wired=False))
    )
    assert plan.discovery.today.median < all_on_air.discovery.today.median
    said = " ".join(plan.advice().split())
    assert said.startswith("Yes, this startup works: 6 carts and 1 desk discover each other ")
    full = "802.11ac 80 MHz, A-MPDU 64"
    found = ds.simulate(plan.fleet, "Fast DDS 2.14", full, until=60, runs=10)
    assert plan.discovery.today.times == tuple(sorted(found.convergence_time.tolist()))


def test_a_change_after_which_a_fleet_that_never_ends_falls_idle_says_when() -> None:
    plan = ds.plan(ds.Fleet.swarm(2000, 2, 10), FAST_DDS)
    assert math.isinf(plan.startup.bounds[0])
    said = " ".join(plan.advice().split())
    assert "Discovery Server: never -> the channel goes idle after" in said
    assert "cuts" not in said


def test_ready_made_robots_are_simulated_with_all_their_endpoints() -> None:
    turtlebots = fleet_of("TurtleBot 4 with Nav2", 2)
    assert ds.plan(turtlebots, FAST_DDS, AC).discovery.rounded == ()
    (group,) = turtlebots.groups
    # A mean without a list is distributed as evenly as whole endpoints can be.
    even = ds.Fleet((replace(group, process_sizes=()),))
    whole, rounded = simulation_jobs.simulated_fleet(even)
    sizes = whole.groups[0].process_sizes
    assert rounded == ()
    assert [(size.count, size.endpoints) for size in sizes] == [(4, 43), (18, 42)]


def test_a_mean_that_no_whole_endpoints_have_is_rounded_and_said() -> None:
    plan = ds.plan(ds.Fleet((ds.HostGroup(2, 2, 20.3, name="robots"),)), FAST_DDS, AC)
    assert plan.discovery.rounded == (("robots", 20.3, 20.5),)
    said = " ".join(plan.advice().split())
    assert "a process has 20.3 endpoints on average; we simulate 20.5." in said
    alike = ds.plan(ds.Fleet((ds.HostGroup(2, 3, 33.3, name="robots"),)), FAST_DDS, AC)
    assert alike.discovery.rounded
    assert "endpoints on average" not in " ".join(alike.advice().split())


def test_a_fleet_may_have_its_own_target() -> None:
    in_haste = replace(SMALL, within=5)
    plan = ds.plan(in_haste, FAST_DDS)
    assert plan.within == 5
    assert ds.plan(in_haste, FAST_DDS, within=20).within == 20
    assert ds.plan(SMALL, FAST_DDS).within == 60
    with pytest.raises(ValueError, match="within must be"):
        ds.plan(replace(SMALL, within=601), FAST_DDS)


def test_a_fleet_whose_largest_part_is_wired_gets_an_answer() -> None:
    wired = ds.HostGroup(3, 8, 40, "server", wired=True)
    plan = ds.plan(ds.Fleet((ds.HostGroup(1, 1, 18), wired)), FAST_DDS, "802.11ax 80 MHz")
    assert plan.discovery.works


def test_the_time_of_nine_runs_leaves_out_those_that_lose_leases() -> None:
    runs = replace(time(*range(1, 11)), expired_per_pair=(1.0, *[0.0] * 9))
    assert (runs.nine_of_ten, runs.nine_of_ten_unexpired) == (9, 10)
    assert runs.works(10)
    assert not runs.works(9)


def test_a_run_for_a_longer_target_waits_longer_for_progress() -> None:
    """Leases of 20 s expire before some robots find each other."""
    fleet = ds.Fleet.swarm(12, 6, 30)
    setting = Setting(fleet, FAST_DDS, AC)
    short, long = (simulation_jobs.prepare_job(setting, until) for until in (60.0, 300.0))
    assert isinstance(short, simulation_jobs.Job)
    assert isinstance(long, simulation_jobs.Job)
    assert long.setup.patience == 5 * short.setup.patience


def test_an_interrupt_leaves_what_is_known() -> None:
    plan = ds.plan(SMALL, FAST_DDS)
    calls = []

    def interrupt(done: float, total: float) -> None:
        calls.append((done, total))
        if len(calls) > 12:
            raise KeyboardInterrupt

    found = plan.simulate(interrupt, interruptible=True)
    assert not found.complete
    assert found.today == ds.plan(SMALL, FAST_DDS).discovery.today
    assert len(found.changes) < 3
    assert "Interrupted: " in " ".join(plan.advice().split())
    calls.clear()
    with pytest.raises(KeyboardInterrupt):
        plan.simulate(interrupt)


def test_an_interrupted_command_prints_what_is_known_and_exits_with_1(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def interrupted(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(change_simulation, "_simulate_prepared", interrupted)
    done = run("plan", "--hosts", "3", "--processes", "2", "--endpoints", "10")
    assert done.exit_code == 1
    assert done.stdout.startswith("Yes, this startup works")
    assert "Interrupted: " in done.stdout


def test_long_simulations_take_fewer_runs_by_their_estimate(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(simulation_jobs, "LONG_RUN_S", 0.0)
    today = ds.plan(SMALL, FAST_DDS).discovery.today
    assert today is not None
    assert len(today.times) == 3
    monkeypatch.setattr(simulation_jobs, "MAX_RUN_SECONDS", 0.0)
    assert ds.plan(SMALL, FAST_DDS).discovery.today is None


def run(*arguments: str) -> Any:
    return CliRunner().invoke(main, list(arguments))


def test_the_command_prints_answer_changes_and_explanations(tmp_path: Path) -> None:
    options = ("plan", "--hosts", "12", "--processes", "2", "--endpoints", "10")
    plan = ds.plan(GIVEN, FAST_DDS, within=5)
    why, also_all = (answer_text.fill(hint) for hint in ("why", "all"))
    assert run(*options, "--within", "5").stdout == f"{plan.advice()}\n{why} {also_all}\n"
    everything = plan.advice(all_changes=True)
    assert run(*options, "--within", "5", "--all").stdout == f"{everything}\n{why}\n"
    both = run(*options, "--within", "5", "--why").stdout
    assert both == f"{plan.advice()}\n{also_all}\n\n{plan.why()}\n"
    told = json.loads(run(*options, "--within", "5", "--json").stdout)["discovery"]
    assert (told["within_s"], told["works"]) == (5.0, False)
    assert [change["name"] for change in told["changes"]] == [
        change.name for change in plan.discovery.changes
    ]
    assert told == json.loads(plan.to_json())["discovery"]
    file = tmp_path / "fleet.toml"
    file.write_text("within = 5\n[[groups]]\nhosts = 12\nprocesses = 2\nendpoints = 10")
    assert run("plan", str(file)).stdout == f"{plan.advice()}\n{why} {also_all}\n"
    told = json.loads(run("plan", str(file), "--within", "7", "--json").stdout)["discovery"]
    assert told["within_s"] == 7
    refused = run(*options, "--within", "0")
    assert refused.exit_code == 2
    assert "within must be" in refused.stderr


def test_protocols_are_compared_by_discovery_time() -> None:
    names = ["Fast DDS 2.6", "Fast DDS 3.6", "Zenoh peer, tokens", "Cyclone DDS, version 11"]
    options = ["plan", "--hosts", "12", "--processes", "2", "--endpoints", "10"]
    several = [*options, *(word for name in names for word in ("--protocol", name))]
    told = json.loads(run(*several, "--json").stdout)
    times = {}
    for plan in told:
        alone = ds.plan(GIVEN, ds.PROTOCOLS[plan["protocol"]])
        today = alone.discovery.today
        assert today is not None
        unchanged = {"changes": [], "hosts_in_time": None}
        assert plan["discovery"] == alone.discovery.to_dict() | unchanged
        times[plan["protocol"]] = today.median
    assert [*times] == sorted(times, key=lambda name: times[name])
    assert times.keys() == set(names)
    table = run(*several).stdout
    assert max(map(len, table.splitlines())) < 80  # else it becomes a list
    order = [line[:23].rstrip() for line in table.splitlines()[2:]]
    assert [name for name in order if name in times] == [*times]
    zenoh = ds.plan(GIVEN, ds.PROTOCOLS["Zenoh peer, tokens"]).discovery.today
    assert zenoh is not None
    assert zenoh.expired_lease_runs > 1
    assert f"leases expire in {zenoh.expired_lease_runs} of 10 runs" in " ".join(table.split())
    rows = {row["protocol"]: row for row in DictReader(run(*several, "--csv").stdout.splitlines())}
    works = {name: (row["works"], row["sure"]) for name, row in rows.items()}
    assert works == {
        "Fast DDS 3.6": ("True", "True"),
        "Fast DDS 2.6": ("False", "True"),
        "Zenoh peer, tokens": ("False", "True"),
        "Cyclone DDS, version 11": ("False", "True"),
    }
    assert rows["Cyclone DDS, version 11"]["median_s"] == ""
    lonely = run("plan", "--hosts", "1", *options[3:], "--protocol", "paper").stdout
    assert lonely.startswith("A single host has no one to discover")


def test_ros_all_compares_the_releases_of_all_distributions() -> None:
    options = ["plan", "--hosts", "3", "--processes", "2", "--endpoints", "10", "--ros", "all"]
    rows = json.loads(run(*options, "--json").stdout)
    assert {row["protocol"] for row in rows} == {"Fast DDS 2.6", "Fast DDS 2.14", "Fast DDS 3.6"}
    assert run(*options, "--protocol", "fastdd").exit_code == 2
    assert "Did you mean 'Fast DDS'?" in run(*options, "--protocol", "fastdd").stderr


def test_a_comparison_leaves_out_what_takes_too_long_and_ends_with_an_interrupt(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    plans = [ds.plan(SMALL, ds.PROTOCOLS[name]) for name in ("Zenoh peer", "Fast DDS 2.14")]
    calls = []

    def interrupt(*work: float) -> None:
        calls.append(work)
        if len(calls) > 11:
            raise KeyboardInterrupt

    simulate_protocols(plans, interrupt)
    reasons = sorted(plan.discovery.reason for plan in plans)
    assert reasons == ["", "interrupted"]
    monkeypatch.setattr(change_simulation, "MAX_COST_S", 0.0)
    simulate_protocols(plans)
    assert [plan.discovery.reason for plan in plans] == [simulation_jobs.TOO_LARGE] * 2


def test_cyclone_dds_is_not_sure_where_many_messages_are_lost() -> None:
    for name in ("Cyclone DDS", "Cyclone DDS, version 11"):
        assert as_it_is(ds.Fleet.swarm(3, 2, 10), ds.PROTOCOLS[name], AC).surely_works
        many = ds.plan(ds.Fleet.swarm(8, 2, 20), ds.PROTOCOLS[name])
        assert (many.discovery.works, many.discovery.is_sure) == (True, False)
        said = " ".join(many.advice().split())
        assert said.startswith("Not sure: in simulations, 8 hosts discover each other within 60 s")
        assert f"). But {many.discovery.caution}." in said
        changes = {change.remedy.kind: change for change in many.discovery.changes}
        # Another configuration of it is no surer; another product is, also in a table made for it.
        multicast = changes["multicast endpoint data"]
        assert multicast.time is not None
        assert multicast.time.works(60)
        assert not multicast.suffices(60)
        assert not changes["discovery server"].caution
        assert multicast not in many.discovery.sufficient


@pytest.mark.parametrize(
    ("name", "measured", "times"),
    [
        ("Fast DDS 3.6", "Fast DDS 3.6", "1.1"),
        ("Cyclone DDS", "Cyclone DDS", "6.8"),  # hardly a message is lost: no caution
        ("Cyclone DDS, version 11", "Cyclone DDS", "6.8"),
        ("Zenoh peer", "", "2"),  # never compared
    ],
)
def test_an_answer_is_sure_only_if_the_slowest_measured_run_would_meet_the_target(
    name: str, measured: str, times: str
) -> None:
    table, few = ds.PROTOCOLS[name], ds.Fleet.swarm(3, 2, 10)
    clear = ds.plan(few, table, AC)
    assert clear.advice().startswith("Yes, this startup works")
    found = clear.discovery
    assert found.today is not None
    slow = found.slowest * found.today.nine_of_ten
    assert 3 * slow < 60
    near = ds.plan(few, table, AC, within=0.99 * slow)
    assert (near.discovery.works, near.discovery.surely_works) == (True, False)
    assert near.to_dict()["discovery"]["sure"] is False
    said = " ".join(near.advice().split())
    assert said.startswith("Probably: in simulations, 3 hosts discover each other within")
    took = f"real {measured} took up to {times} times as long as simulated"
    assert (took if measured else f"may take up to {times} times as long") in said
    assert ds.plan(few, table, AC, within=1.01 * slow).discovery.surely_works


def test_a_change_is_enough_only_if_the_slowest_measured_run_would_meet_the_target() -> None:
    plan = ds.plan(ds.Fleet.swarm(12, 2, 10), ds.PROTOCOLS["Fast DDS 3.6"], within=7)
    found = plan.discovery
    assert not found.works
    (fewer,) = (c for c in found.changes if c.name == "processes")
    assert fewer.time is not None
    assert fewer.time.works(7)
    assert fewer.slowest * fewer.time.nine_of_ten > 7
    assert fewer not in found.sufficient
    assert found.sufficient
    assert not plan.to_dict()["discovery"]["changes"][found.changes.index(fewer)]["suffices"]
    said = " ".join(plan.advice(all_changes=True).split())
    row = said.partition("Composing 2 processes into 1: ")[2]
    assert "Real runs may take up to 7.2 s, longer than your target." in row.partition(" 4. ")[0]
    # What is enough in simulations comes before what is not even that.
    levels = [c.suffices(7) + c.time.works(7) for c in found.helpful if c.time]
    assert levels == sorted(levels, reverse=True)
    options = ["plan", "--hosts", "12", "--processes", "2", "--endpoints", "10", "--within", "17"]
    both = run(*options, "--protocol", "Fast DDS 3.6", "--protocol", "Zenoh router")
    (row,) = (line for line in both.stdout.splitlines() if line.startswith("Fast DDS 3.6"))
    assert row.split()[-1] == "probably"


def test_what_takes_long_is_said_at_once_also_where_standard_error_is_no_terminal(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    options = ("plan", "--hosts", "3", "--processes", "2", "--endpoints", "10")
    quick = run(*options)
    monkeypatch.setattr("discostorm_planner.cli.plan._LONG_WORK_S", 0.0)
    slow = run(*options)
    assert slow.stdout == quick.stdout
    begun = "Unchanged, your startup needs at least "
    assert slow.stderr.removeprefix(quick.stderr).startswith(begun)
    assert slow.stderr.count("\n") == quick.stderr.count("\n") + 2
    assert f"So far: {slow.stdout[:40]}" in slow.stderr
    assert begun not in run(*options, "--json").stderr


def test_a_wired_server_without_endpoints_is_no_robot_of_the_verdict() -> None:
    server = ds.HostGroup(1, 1, 0, "server", wired=True)
    robots = ds.HostGroup(3, 2, 10, "robots")
    for groups, told in (
        ((robots, server), "3 robots discover each other"),
        ((replace(robots, name=""), replace(server, name="")), "3 hosts discover each other"),
        ((robots, replace(server, endpoints=1)), "3 robots and 1 server discover each other"),
    ):
        said = ds.plan(ds.Fleet(groups), FAST_DDS).advice()
        assert " ".join(said.split()).startswith(f"Yes, this startup works: {told}")
    many = ds.Fleet((replace(robots, hosts=12, processes=4, endpoints=40), server))
    plan = replace(ds.plan(many, FAST_DDS), remedies=(), combinations=())
    said, found = " ".join(plan.advice().split()), plan.discovery.hosts_in_time
    assert found is not None
    assert f"of the 12 robots on this channel. These {found[1]} hosts need" in said
