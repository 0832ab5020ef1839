"""Agreements on block acknowledgements: ADDBA request and response, before the first A-MPDU.

Until a late response comes frames go one by one, or it is asked for again (IEEE Std 802.11-2020,
10.25.2 and 11.5; the two times are ns-3's).
"""

import numpy as np

from discostorm_simulation import state as st
from discostorm_simulation.kernels.channel_access import request_access
from discostorm_simulation.kernels.decorators import njit, shared
from discostorm_simulation.kernels.primitives import schedule_event
from discostorm_simulation.kernels.queues import change_length, receiving_host

#: How long a response may take after the acknowledgement of its request, and how long frames then
#: go one by one, in ticks of 100 ns: 5 ms and 0.2 s.
RESPONSE_TIMEOUT, RETRY_PAUSE = np.int64(50_000), np.int64(2_000_000)


@njit
def is_established(cell, station, frame):
    """Return whether a station may send A-MPDUs to the receiver of a frame."""
    if station < cell.state[0].hosts:
        return cell.block_acks[station, st.UPWARD].state == st.ESTABLISHED
    return cell.block_acks[receiving_host(cell, frame), st.DOWNWARD].state == st.ESTABLISHED


@njit
def is_addba_request(cell, station, direction):
    """Return whether what a station sends for an agreement is the request, not the response."""
    return (direction == st.UPWARD) == (station < cell.state[0].hosts)


@njit
def queue_addba(cell, station, host, direction):
    """Let a station send a request or response before its data."""
    state, block_ack = cell.state[0], cell.block_acks[host, direction]
    state.addba_frames += 1
    if is_addba_request(cell, station, direction):
        block_ack.request, block_ack.request_tries = state.addba_frames, 0
    else:
        waits = block_ack.response > 0
        block_ack.response, block_ack.response_tries = state.addba_frames, 0
        if waits:  # the newer one takes the place of the older
            return
    cell.addba[station].waiting += 1
    change_length(cell, station, 1)


@shared
def choose_addba(cell, station):
    """Choose the request or response that a station sends next; return whether there is one."""
    state, its = cell.state[0], cell.addba[station]
    its.sends = -1
    if its.waiting == 0 or cell.stations[station].bar_pending:
        return False
    first, last = station, station + 1
    if station == state.hosts:
        first, last = np.int64(0), state.hosts
    least = st.NEVER
    for host in range(first, last):
        for direction in range(2):
            block_ack = cell.block_acks[host, direction]
            order = block_ack.response
            if is_addba_request(cell, station, direction):
                order = block_ack.request
            if 0 < order < least:
                least = order
                its.sends = 2 * host + direction
    return True


@shared
def request_block_ack(cell, host, direction):
    """Let a station that may send now ask for an agreement."""
    station = host if direction == st.UPWARD else cell.state[0].hosts
    cell.block_acks[host, direction].state = st.REQUESTED
    queue_addba(cell, station, host, direction)
    cell.addba[station].sends = 2 * host + direction


@njit
def dequeue_addba(cell, station, host, direction):
    """Take a request or response off its queue."""
    block_ack = cell.block_acks[host, direction]
    if is_addba_request(cell, station, direction):
        block_ack.request = 0
    else:
        block_ack.response = 0
    cell.addba[station].waiting -= 1
    cell.addba[station].sends = -1
    change_length(cell, station, -1)


@shared
def addba_failed(cell, station, time):
    """Note that a request or response was not acknowledged; drop it after the last attempt."""
    sends = cell.addba[station].sends
    host, direction = sends // 2, sends % 2
    block_ack = cell.block_acks[host, direction]
    if is_addba_request(cell, station, direction):
        block_ack.request_tries += 1
        if block_ack.request_tries < cell.radio[0].attempts:
            return
        if block_ack.state == st.REQUESTED:
            block_ack.state = st.UNANSWERED
            schedule_event(cell, time + RETRY_PAUSE, st.ADDBA_TIMEOUT | sends)
    else:
        block_ack.response_tries += 1
        if block_ack.response_tries < cell.radio[0].attempts:
            return
    dequeue_addba(cell, station, host, direction)


@shared
def addba_arrived(cell, station, acknowledged):
    """Note that a request or response has arrived; return who has something to do."""
    sends = cell.addba[station].sends
    host, direction = sends // 2, sends % 2
    dequeue_addba(cell, station, host, direction)
    other = cell.state[0].hosts if station == host else host
    if is_addba_request(cell, station, direction):
        schedule_event(cell, acknowledged + RESPONSE_TIMEOUT, st.ADDBA_TIMEOUT | sends)
        queue_addba(cell, other, host, direction)
    else:
        cell.block_acks[host, direction].state = st.ESTABLISHED
    return other


@shared
def on_addba_timeout(cell, sends, time):
    """Go on without an agreement that has not come, or ask for it anew."""
    host, direction = sends // 2, sends % 2
    block_ack = cell.block_acks[host, direction]
    if block_ack.state == st.UNANSWERED:
        block_ack.state = st.NO_BLOCK_ACK
    elif block_ack.state == st.REQUESTED:
        block_ack.state = st.UNANSWERED
        schedule_event(cell, time + RETRY_PAUSE, st.ADDBA_TIMEOUT | sends)
        station = host if direction == st.UPWARD else cell.state[0].hosts
        if cell.stations[station].length > 0:
            request_access(cell, station, time, time <= cell.state[0].idle)
