"""Every sentence of a plan's answer and of its explanations, compared with stored texts.

`python packages/planner/tests/test_plan_text.py` writes the texts anew; read their diff.
"""

import math
from dataclasses import replace
from pathlib import Path
from unittest.mock import patch

import pytest

import discostorm as ds
from discostorm.robots import laptop, robots
from discostorm_planner import answer_text, fleet_changes, simulation_jobs

NAV2 = replace(robots()["Nav2 in one process"], hosts=10)
SWARM = ds.Fleet.swarm(3, 8, 5)
SENDING = ds.HostGroup(3, 2, 10, name="robots", data=(ds.flows.flow("scan", "all others"),))
HEAVY = replace(SENDING, hosts=60)
AC = ds.WIFI["802.11ac 80 MHz 2x2"]
PLANS = {
    "swarm_dds": (SWARM, "DDS", ds.PAPER, 1.0),
    "swarm_zenoh_20_s": (SWARM, "Zenoh", ds.PAPER, 20.0),
    "swarm_fast_dds_steady": (SWARM, "Fast DDS", ds.PAPER, math.inf),
    "small_fits": (ds.Fleet.swarm(2, 1, 5), "DDS", ds.PAPER, 1.0),
    "alone": (ds.Fleet.swarm(1, 1, 10), "DDS", ds.PAPER, 1.0),
    "nav2_converges": (ds.Fleet((replace(NAV2, hosts=8),)), "Fast DDS", AC, 1.0),
    "nav2_never_converges": (ds.Fleet((NAV2, laptop())), "DDS", AC, 1.0),
    "nav2_router": (ds.Fleet((NAV2, laptop())), "Zenoh router", AC, 1.0),
    "periodic_traffic_fills": (ds.Fleet.swarm(9, 15, 15), "Fast DDS", AC, 1.0),
    "periods_of_fast_dds": (SWARM, "DDS, periods of Fast DDS", AC, 1.0),
    "seven_groups": (
        ds.Fleet(tuple(ds.HostGroup(2, 1 + n % 3, 20 + 5 * n) for n in range(7))),
        "Cyclone DDS",
        ds.PAPER,
        1.0,
    ),
    "user_data": (ds.Fleet((SENDING,)), "DDS", ds.PAPER, 1.0),
    "user_data_overloads": (ds.Fleet((HEAVY,)), "DDS", AC, 1.0),
    "swarm_zenoh_router": (ds.Fleet.swarm(12, 2, 10), "Zenoh router", ds.PAPER, 1.0),
}


TEXTS = Path(__file__).with_name("plan_texts")
#: Limits of simulations: plans of the usual number of runs, and one whose fleet is too large and
#: that has fewer runs of large ones. The others, whose runs take longer, have `TWO` of each fleet.
USUAL, TWO = {"RUNS": simulation_jobs.RUNS}, {"RUNS": 2, "RUNS_IF_LONG": 2}
LIMITS = dict.fromkeys(("swarm_dds", "swarm_zenoh_router", "small_fits"), USUAL) | {
    "periodic_traffic_fills": {"RUNS_IF_LONG": 2, "LONG_RUN_S": 0.1, "MAX_RUN_SECONDS": 0.4}
}


def advice(name: str) -> str:
    fleet, protocol, wifi, window = PLANS[name]
    plan = ds.plan(fleet, ds.PROTOCOLS[protocol], wifi, window=window)
    with patch.multiple(simulation_jobs, **LIMITS.get(name, TWO)):
        return f"{plan.advice()}\n\n{plan.why()}\n"


@pytest.mark.parametrize("name", PLANS)
def test_advice_reads_as_stored(name: str) -> None:
    assert advice(name) == (TEXTS / f"{name}.txt").read_text(encoding="utf-8")


def test_numbers_tell_a_time_from_its_target_and_small_shares_apart_from_none() -> None:
    assert answer_text._time_beyond(11.06, 11) == "11.1 s"
    assert answer_text._time_beyond(10.96, 11) == "11 s"
    assert answer_text.format_share(0.0053) == "less than 1%"


def test_names_of_groups_get_an_s_only_where_they_are_words_in_the_singular() -> None:
    for count, name, told in (
        (4, "picker", "4 pickers"),
        (5, "drone", "5 drones"),
        (2, "delivery bay", "2 delivery bays"),
        (1, "desk", "1 desk"),
        (12, "robots", "12 robots"),
        (3, "bus", "3 bus"),
        (12, "TurtleBot 4", "12 TurtleBot 4"),
        (12, "TurtleBot 4 with Nav2", "12 TurtleBot 4 robots with Nav2"),
        (1, "Nav2 in one process", "1 Nav2 in one process"),
        (2, "turtlebot4", "2 turtlebot4"),
        (2, "AGV", "2 AGV"),
        (1_200, "cart", "1,200 carts"),
    ):
        assert fleet_changes.hosts_in_words(count, name) == told
    fleet = ds.Fleet((ds.HostGroup(2, 1, 5, "picker"), ds.HostGroup(1, 1, 5, "drone")))
    said = " ".join(ds.plan(fleet, ds.PROTOCOLS["Fast DDS"], AC).advice().split())
    assert said.startswith("Yes, this startup works: 2 pickers and 1 drone discover each other")


if __name__ == "__main__":
    for plan in PLANS:
        (TEXTS / f"{plan}.txt").write_text(advice(plan), encoding="utf-8")
