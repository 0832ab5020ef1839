"""The ladder of assumptions shows what the package computes."""

import math

import numpy as np

import discostorm as ds
from discostorm import drain_times
from discostorm.wifi import Radio
from discostorm_book import assumption_ladder as ladder


def test_the_ladder_starts_at_the_paper_and_each_switch_moves_it() -> None:
    rungs = {(rung.switches, rung.protocol): rung for rung in ladder.fleet_limits()}
    assert len(rungs) == len(list(ladder.fleet_limits()))
    names = {switch.key: switch for switch in ladder.ASSUMPTIONS}
    assert f"{ladder.MPDUS} frames per A-MPDU" in names["aggregation"].name
    for switches, protocol in rungs:
        assert switches <= names.keys()
        assert all(set(names[key].needs) <= switches for key in switches)
        assert {(switches, other) for other in ladder.TABLES} <= rungs.keys(), protocol
    for protocol in ladder.TABLES:
        paper = rungs[frozenset(), protocol]
        full = ds.saturation_hosts(ds.PROTOCOLS[protocol], 2, 10)
        assert paper.full == full
        assert paper.fit < full <= paper.fit + 1
        for switch in ladder.ASSUMPTIONS:
            with_it = [
                one for (on, of), one in rungs.items() if switch.key in on and of == protocol
            ]
            assert any(one.fit != paper.fit for one in with_it), switch.key
    frames = Radio("802.11n", streams=2, mpdus=ladder.MPDUS).wifi()
    most = rungs[frozenset({"timing", "aggregation", "periods", "as built"}), "DDS"]
    fast = ds.PROTOCOLS["Fast DDS"]
    assert most.full == ds.saturation_hosts(fast, 2, 10, frames, window=fast.lease)


def test_with_timers_a_fleet_fits_if_all_is_carried_within_the_lease() -> None:
    """The rule of the page; the bound of the drain time would lose a robot of each."""
    fits = {}
    for rung in ladder.fleet_limits():
        if rung.switches == {"periods"}:
            fits[rung.protocol] = rung.fit
            table = ds.PROTOCOLS[ladder.TABLES[rung.protocol][1]]
            carried = [drain_times.first_idle(table, rung.fit + more, 2, 10) for more in (0, 1)]
            assert carried[0] <= table.lease < carried[1]
    assert fits == {"DDS": 22, "Zenoh": 20}


def test_the_row_of_queues_says_that_it_has_the_announcement_of_the_paper() -> None:
    """With the timers of Fast DDS so many robots would not fit."""
    (queues,) = (one for one in ladder.ASSUMPTIONS if one.key == "queues")
    assert "once at startup, as in the paper" in queues.why
    (rung,) = (
        one
        for one in ladder.fleet_limits()
        if one.protocol == "DDS" and one.switches == {"timing", "contention", "queues"}
    )
    fleet = ds.Fleet.swarm(rung.fit, 2, 10)
    repeated = ds.PROTOCOLS["DDS, periods of Fast DDS"]
    simulated = ds.simulate(fleet, repeated, ds.WIFI["802.11n 20 MHz 2x2"], runs=20)
    assert np.median(simulated.convergence_time) > repeated.lease


def test_a_simulated_rung_tells_of_its_runs() -> None:
    for rung in ladder.fleet_limits():
        low, high = rung.fits
        assert low <= rung.fit <= high
        assert bool(rung.runs) == math.isnan(rung.full)
        if rung.runs:
            assert f"ith {rung.fit} robots the median of " in rung.runs
            assert ("might change" in rung.runs) == (low < high)
        assert rung.shown == (f"{low}" if low == high else f"{low} to {high}")
