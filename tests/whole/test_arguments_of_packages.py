"""Arguments that the core checks, where other packages take them."""

import decimal
import json
from typing import Any

import numpy as np
import pandas as pd
import pytest

import discostorm as ds
from discostorm_planner import staggered_start
from discostorm_simulation.cell_setup import to_ticks

PAIR = ds.Fleet.swarm(2, 1, 1)


@pytest.mark.parametrize(
    "value",
    [[[1], [2, 3]], pd.Series([1.0, 2.0]), pd.NA, {}, "7", decimal.Decimal(1)],
    ids=lambda value: type(value).__name__,
)
@pytest.mark.parametrize(
    ("name", "call"),
    [
        ("window", lambda value: ds.plan(PAIR, window=value)),
        (r"queue\[0\]", lambda value: ds.simulate(PAIR, ds.DDS, ds.PAPER, queue=(value, 0.5))),
        (r"queue\[1\]", lambda value: ds.simulate(PAIR, ds.DDS, ds.PAPER, queue=(500, value))),
        (r"queue(\[0\])?", lambda value: ds.simulate(PAIR, ds.DDS, ds.PAPER, queue=value)),
    ],
)
def test_errors_are_the_packages_own(name: str, call: Any, value: Any) -> None:
    with pytest.raises((TypeError, ValueError), match=f"{name} must .*; got "):
        call(value)


def test_fleets_without_numbers_are_neither_planned_nor_simulated() -> None:
    for call in (ds.plan, lambda fleet: ds.simulate(fleet, ds.DDS, ds.PAPER)):
        with pytest.raises(TypeError, match="endpoints must be "):
            call(ds.Fleet.swarm(7, 2, []))


def test_ticks_of_the_simulator_have_a_largest_value() -> None:
    assert to_ticks(np.inf) == to_ticks(1e308) > to_ticks(1e6)


def test_robots_start_in_turn_up_to_a_million() -> None:
    text = r"hosts must be a whole number of at least 1 and at most 1e\+06; got 80000000"
    with pytest.raises(ValueError, match=text):
        staggered_start.start_times_in_turn(ds.DDS, hosts=8e7, processes=2, endpoints=10)


def test_json_of_a_plan_is_strict() -> None:
    slow = ds.Wifi("slow", ds.Link(1, 1e6), ds.Link(1, 1e6))
    fleet = ds.Fleet.swarm(1e9, 1, 1e9)
    text = ds.plan(fleet, wifi=slow).to_json()
    json.loads(text, parse_constant=pytest.fail)
