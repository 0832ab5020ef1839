"""Capture effect: which of several overlapping frames a station receives.

The frame's power must exceed the sum of the other frames by a threshold, which is lower for the
frame's start (basic rate). Between both thresholds, MPDUs that start after the others' end arrive.
"""

import numpy as np

from discostorm_simulation.kernels import delivery
from discostorm_simulation.kernels.decorators import inlined, not_inlined
from discostorm_simulation.kernels.primitives import access_point
from discostorm_simulation.kernels.queues import receiving_host


@inlined
def receiver_of_transmission(cell, station):
    """Return the receiving station of a transmission; for multicast, the access point (unused)."""
    if station < cell.state[0].hosts:
        return access_point(cell.state[0])
    if cell.stations[station].sent == 0 and not cell.stations[station].bar_pending:
        return cell.addba[station].sends // 2
    return receiving_host(cell, cell.window[station, 0].frame)


@inlined
def mpdus_started_within(cell, station, since):
    """Return the number of MPDUs that start in the first ``since`` ticks of a PPDU."""
    octets = np.int64(0)
    for place in range(cell.stations[station].sent):
        if delivery.ppdu_duration(cell.radio[0], octets) >= since:
            return np.int64(place)
        octets += delivery.subframe_octets(cell, cell.window[station, place].frame)
    return np.int64(cell.stations[station].sent)


@not_inlined
def is_captured(cell, count, station, time):
    """Return whether part of an overlapped transmission arrives; count its damaged MPDUs."""
    state, sent = cell.state[0], cell.stations[station].sent
    basic, full = cell.radio[0].capture_threshold_basic, cell.radio[0].capture_threshold
    state.damaged = 0
    if delivery.is_multicast(cell, station):
        for host in range(state.hosts):
            if delivery.exceeds_interference(cell, count, station, host, basic):
                return True
        return False
    to = receiver_of_transmission(cell, station)
    if not delivery.exceeds_interference(cell, count, station, to, basic):
        return False
    if sent == 0 or delivery.exceeds_interference(cell, count, station, to, full):
        return True
    others = np.int64(0)
    for place in range(count):
        if cell.senders[place].station != station:
            others = max(others, cell.senders[place].end)
    state.damaged = mpdus_started_within(cell, station, others - time) if sent > 1 else sent
    return state.damaged < sent


@not_inlined
def captured_station(cell, count, time):
    """Return the sender that is received despite the overlap, or -1."""
    for place in range(count):
        station = cell.senders[place].station
        if is_captured(cell, count, station, time):
            cell.state[0].overlapping = count
            return station
    cell.state[0].damaged = 0
    return np.int64(-1)
