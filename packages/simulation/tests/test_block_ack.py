"""Agreements on block acknowledgements: what a robot that was just switched on sends first."""

from typing import Any, Literal

import numpy as np
import pytest

import discostorm as ds
from discostorm_simulation.engine import finish
from discostorm_simulation.kernels.block_ack import PATIENCE, action_failed, ask, give_up
from discostorm_simulation.kernels.decorators import entry
from discostorm_simulation.run import Scenario, set_up
from discostorm_simulation.state import AGREED, ASKED, DOWNWARD, NONE, SILENT, UPWARD

INFINITE = (float("inf"), float("inf"))


def channel(mpdus: int = 64) -> ds.Wifi:
    return ds.Radio("802.11n", streams=2, aifsn=3, mpdus=mpdus).wifi()


def burst(
    agreements: Literal["cold", "in place"], mpdus: int = 64, **options: Any
) -> ds.Simulation:
    given: dict[str, Any] = {"queue": None, "recovery": False, "runs": 5} | options
    swarm = ds.Fleet.swarm(4, 2, 10)
    return ds.simulate(swarm, ds.ZENOH, channel(mpdus), agreements=agreements, **given)


def test_request_and_response_come_before_the_first_aggregate() -> None:
    # The second host has nothing to collide with: it starts when the first is through.
    found = ds.simulate(
        ds.Fleet.swarm(2, 1, 10),
        ds.ZENOH,
        channel(),
        queue=None,
        start=np.array([0.0, 1.0]),
        recovery=False,
        agreements="cold",
    )
    table = found.transmission_table()
    first = table[table["start_s"] < 1.0]
    together = first["frames"] > 1
    asked = first["message"] == "block ACK agreement"
    up = first["station"] == "host 1"
    # Up: host, then access point; down: the access point, then the other host.
    assert first["station"][asked].tolist()[:2] == ["host 1", "access point"]
    assert sorted(first["station"][asked].tolist()[2:]) == ["access point", "host 2"]
    assert first.index[asked][1] < first.index[together & up][0]
    assert first.index[asked][3] < first.index[together & ~up][0]
    # 37 bytes at 6 Mbit/s, SIFS, and an acknowledgement of 14.
    length = first["end_s"][asked] - first["start_s"][asked]
    np.testing.assert_allclose(length, 76e-6 + 16e-6 + 44e-6, atol=1e-9)
    assert (asked.sum(), (table["message"] == "block ACK agreement").sum()) == (4, 8)


def test_each_agreement_is_made_once_and_nothing_is_lost() -> None:
    found = burst("cold", loss=0.1)
    assert (found.counts["arrived"] + found.counts["on_air"] == found.counts["expected"]).all()
    warm = burst("in place", loss=0.1)
    # Two frames for each of four hosts, up and down.
    assert (found.counts["requests"] >= warm.counts["requests"].min() + 16).all()
    assert np.median(found.drain_time) > np.median(warm.drain_time)


def test_without_aggregation_there_is_nothing_to_agree_on() -> None:
    cold, warm = burst("cold", 1), burst("in place", 1)
    np.testing.assert_array_equal(cold.drain_time, warm.drain_time)
    for name, count in cold.counts.items():
        np.testing.assert_array_equal(count, warm.counts[name])


@entry
def ask_in_vain(cell: Any, attempts: int) -> None:
    ask(cell, 0, UPWARD)
    for _ in range(attempts):
        cell.addba[0].sends = UPWARD
        action_failed(cell, 0, 0)


@entry
def wait_in_vain(cell: Any) -> None:
    give_up(cell, UPWARD, PATIENCE)


def test_a_response_that_does_not_come_is_waited_for_and_then_asked_for_again() -> None:
    swarm = ds.Fleet.swarm(2, 1, 2)
    what = set_up(Scenario(swarm, ds.ZENOH, channel(), queue=INFINITE, recovery=False))
    cell, _ = what.cell(np.random.SeedSequence(0))
    agreement = cell.block_acks[0, UPWARD]
    ask_in_vain(cell, 6)
    assert (agreement["state"], cell.stations[0]["length"]) == (ASKED, 1)
    wait_in_vain(cell)
    assert agreement["state"] == SILENT
    wait_in_vain(cell)
    assert agreement["state"] == NONE
    cell, _ = what.cell(np.random.SeedSequence(0))
    ask_in_vain(cell, 7)
    assert (cell.block_acks[0, UPWARD]["state"], cell.stations[0]["length"]) == (SILENT, 0)
    # Its frames go one by one, and the other direction is agreed on.
    cell = finish(cell, 10**7)
    assert cell.state["open"] == 0
    assert (cell.block_acks["state"][0, [UPWARD, DOWNWARD]] == [SILENT, AGREED]).all()
    assert (cell.log["frames"][cell.log["station"] == 0] <= 1).all()


def test_an_unknown_start_is_refused() -> None:
    with pytest.raises(ValueError, match="agreements must be 'cold' or"):
        burst("warm")  # type: ignore[arg-type]
