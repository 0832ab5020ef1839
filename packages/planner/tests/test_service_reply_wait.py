"""How long a server must wait for the reply reader of a client: against runs counted by hand."""

import numpy as np
import pytest

import discostorm as ds
from discostorm_planner.service_reply_wait import (
    REQUIRED_REPLY_SHARE,
    lost_reply_share,
    required_reply_wait,
)

NEVER = float("inf")


def test_the_share_of_replies_that_are_dropped_by_hand() -> None:
    halves = np.repeat([1.0, 3.0], 500)
    # In one of four cases the server learns of its client 2 s after the client learned of it.
    assert lost_reply_share(halves, 0.1) == pytest.approx(0.25, abs=0.002)
    assert lost_reply_share(halves, 2.0) == 0.0
    # Clients that never know the server do not ask; of the others half are never known.
    assert lost_reply_share(np.repeat([1.0, NEVER], 500), 60.0) == pytest.approx(0.5, abs=0.002)
    assert lost_reply_share([NEVER], 60.0) == 1.0


@pytest.mark.parametrize(
    ("times", "wait"),
    [
        ([1.0, 1.0, 1.0], 0.0),
        ([1.0, 1.0, 3.5], 2.5),
        ([[1.0, 1.0], [5.0, 5.0]], 0.0),  # both ends of a service are of one run
        ([1.0, NEVER], NEVER),
        ([NEVER, NEVER], NEVER),
    ],
)
def test_the_wait_of_few_pairs_by_hand(times: list[float], wait: float) -> None:
    assert required_reply_wait(times) == wait


def test_the_wait_lets_99_of_100_requests_through() -> None:
    """Draw both directions at random: the client knows the server, the server the client."""
    random = np.random.default_rng(1)
    times = random.exponential(1.0, 4000)
    client, server = random.choice(times, (2, 200_000))
    answered = np.mean(server - client <= required_reply_wait(times))
    assert abs(answered - REQUIRED_REPLY_SHARE) < 0.002
    assert abs(np.mean(server - client > 0.1) - lost_reply_share(times)) < 0.005


def test_a_few_pairs_that_never_complete_leave_the_wait_finite() -> None:
    times = np.append(np.linspace(0.0, 1.0, 999), NEVER)
    assert required_reply_wait(times) < 1.0
    assert required_reply_wait(np.append(times, [NEVER] * 20)) == NEVER


def test_plan_names_the_wait_of_the_runs_that_simulate_gives() -> None:
    fleet = ds.Fleet((ds.HostGroup(5, 2, 10),))
    plan = ds.plan(fleet, ds.PROTOCOLS["Fast DDS"])
    runs = ds.simulate(fleet, ds.PROTOCOLS["Fast DDS"], until=60.0, runs=10, seed=0)
    today = plan.discovery.today
    assert today is not None
    assert today.reply_wait == max(required_reply_wait(run) for run in runs.pair_times)
    assert "While nodes start, service servers need a max_blocking_time" in plan.why()
    zenoh = ds.plan(fleet, ds.PROTOCOLS["Zenoh"])
    assert "max_blocking_time" not in zenoh.why()
