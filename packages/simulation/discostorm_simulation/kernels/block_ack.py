"""How two stations agree on block acknowledgements before the first A-MPDU from one to the other.

Who has more than one frame for a receiver sends it an ADDBA request first; what is for this
receiver waits. The response contends like any frame, ahead of data. If it has not come in time,
frames go one by one, each with its acknowledgement, until the response comes or enough time has
passed to ask again (IEEE Std 802.11-2020, 10.25.2 and 11.5; the two times are ns-3's).
"""

import numpy as np

from discostorm_simulation.kernels.channel_access import wake
from discostorm_simulation.kernels.decorators import njit, shared
from discostorm_simulation.kernels.primitives import later
from discostorm_simulation.kernels.queues import change_length, receiver
from discostorm_simulation.state import (
    AGREED,
    ASKED,
    DOWNWARD,
    GIVE_UP,
    NEVER,
    NONE,
    SILENT,
    UPWARD,
)

#: How long a response may take after the acknowledgement of its request, and how long frames then
#: go one by one, in ticks of 100 ns: 5 ms and 0.2 s.
PATIENCE, PAUSE = np.int64(50_000), np.int64(2_000_000)


@njit
def agreed(cell, station, frame):
    """Return whether a station may send A-MPDUs to the receiver of a frame."""
    if station < cell.now[0].hosts:
        return cell.agreements[station, UPWARD].state == AGREED
    return cell.agreements[receiver(cell, frame), DOWNWARD].state == AGREED


@njit
def is_request(cell, station, direction):
    """Return whether what a station sends for an agreement is the request, not the response."""
    return (direction == UPWARD) == (station < cell.now[0].hosts)


@njit
def queue_action(cell, station, host, direction):
    """Let a station send a request or response before its data."""
    now, agreement = cell.now[0], cell.agreements[host, direction]
    now.actions += 1
    if is_request(cell, station, direction):
        agreement.request, agreement.request_tries = now.actions, 0
    else:
        waits = agreement.response > 0
        agreement.response, agreement.response_tries = now.actions, 0
        if waits:  # the newer one takes the place of the older
            return
    cell.actions[station].waiting += 1
    change_length(cell, station, 1)


@shared
def choose_action(cell, station):
    """Choose the request or response that a station sends next; return whether there is one."""
    now, its = cell.now[0], cell.actions[station]
    its.sends = -1
    if its.waiting == 0 or cell.stations[station].must_ask:
        return False
    first, last = station, station + 1
    if station == now.hosts:
        first, last = np.int64(0), now.hosts
    least = NEVER
    for host in range(first, last):
        for direction in range(2):
            agreement = cell.agreements[host, direction]
            order = agreement.response
            if is_request(cell, station, direction):
                order = agreement.request
            if 0 < order < least:
                least = order
                its.sends = 2 * host + direction
    return True


@shared
def ask(cell, host, direction):
    """Let a station that may send now ask for an agreement."""
    station = host if direction == UPWARD else cell.now[0].hosts
    cell.agreements[host, direction].state = ASKED
    queue_action(cell, station, host, direction)
    cell.actions[station].sends = 2 * host + direction


@njit
def end_action(cell, station, host, direction):
    """Take a request or response off its queue."""
    agreement = cell.agreements[host, direction]
    if is_request(cell, station, direction):
        agreement.request = 0
    else:
        agreement.response = 0
    cell.actions[station].waiting -= 1
    cell.actions[station].sends = -1
    change_length(cell, station, -1)


@shared
def action_failed(cell, station, time):
    """Note that a request or response was not acknowledged; drop it after the last attempt."""
    sends = cell.actions[station].sends
    host, direction = sends // 2, sends % 2
    agreement = cell.agreements[host, direction]
    if is_request(cell, station, direction):
        agreement.request_tries += 1
        if agreement.request_tries < cell.radio[0].attempts:
            return
        if agreement.state == ASKED:
            agreement.state = SILENT
            later(cell, time + PAUSE, GIVE_UP | sends)
    else:
        agreement.response_tries += 1
        if agreement.response_tries < cell.radio[0].attempts:
            return
    end_action(cell, station, host, direction)


@shared
def action_arrived(cell, station, acknowledged):
    """Note that a request or response has arrived; return who has something to do."""
    sends = cell.actions[station].sends
    host, direction = sends // 2, sends % 2
    end_action(cell, station, host, direction)
    other = cell.now[0].hosts if station == host else host
    if is_request(cell, station, direction):
        later(cell, acknowledged + PATIENCE, GIVE_UP | sends)
        queue_action(cell, other, host, direction)
    else:
        cell.agreements[host, direction].state = AGREED
    return other


@shared
def give_up(cell, sends, time):
    """Go on without an agreement that has not come, or ask for it anew."""
    host, direction = sends // 2, sends % 2
    agreement = cell.agreements[host, direction]
    if agreement.state == SILENT:
        agreement.state = NONE
    elif agreement.state == ASKED:
        agreement.state = SILENT
        later(cell, time + PAUSE, GIVE_UP | sends)
        station = host if direction == UPWARD else cell.now[0].hosts
        if cell.stations[station].length > 0:
            wake(cell, station, time, time <= cell.now[0].idle)
