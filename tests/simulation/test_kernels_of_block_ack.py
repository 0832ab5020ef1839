"""Agreements on block acknowledgements, rule by rule: the kernels that `make live` compiles."""

from typing import Any

import numpy as np

import discostorm as ds
from discostorm_simulation.engine import run_to_end
from discostorm_simulation.kernels.block_ack import (
    RESPONSE_TIMEOUT,
    addba_failed,
    on_addba_timeout,
    request_block_ack,
)
from discostorm_simulation.kernels.decorators import called_from_python
from discostorm_simulation.run import Scenario, set_up
from discostorm_simulation.state import (
    DOWNWARD,
    ESTABLISHED,
    NO_BLOCK_ACK,
    REQUESTED,
    UNANSWERED,
    UPWARD,
)


@called_from_python
def ask_in_vain(cell: Any, attempts: int) -> None:
    request_block_ack(cell, 0, UPWARD)
    for _ in range(attempts):
        cell.addba[0].sends = UPWARD
        addba_failed(cell, 0, 0)


@called_from_python
def wait_in_vain(cell: Any) -> None:
    on_addba_timeout(cell, UPWARD, RESPONSE_TIMEOUT)


def test_a_response_that_does_not_come_is_waited_for_and_then_asked_for_again() -> None:
    swarm = ds.Fleet.swarm(2, 1, 2)
    wifi = ds.Radio("802.11n", streams=2, aifsn=3, mpdus=64).wifi()
    what = set_up(Scenario(swarm, ds.ZENOH, wifi, queue=(np.inf, np.inf), recovery=False))
    cell, _ = what.cell(np.random.SeedSequence(0))
    agreement = cell.block_acks[0, UPWARD]
    ask_in_vain(cell, 6)
    assert (agreement["state"], cell.stations[0]["length"]) == (REQUESTED, 1)
    wait_in_vain(cell)
    assert agreement["state"] == UNANSWERED
    wait_in_vain(cell)
    assert agreement["state"] == NO_BLOCK_ACK
    cell, _ = what.cell(np.random.SeedSequence(0))
    ask_in_vain(cell, 7)
    assert (cell.block_acks[0, UPWARD]["state"], cell.stations[0]["length"]) == (UNANSWERED, 0)
    # Its frames go one by one, and the other direction is agreed on.
    cell = run_to_end(cell, 10**7, what.reserve)
    assert cell.state["open"] == 0
    assert (cell.block_acks["state"][0, [UPWARD, DOWNWARD]] == [UNANSWERED, ESTABLISHED]).all()
    assert (cell.log["frames"][cell.log["station"] == 0] <= 1).all()
