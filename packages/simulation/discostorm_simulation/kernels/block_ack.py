"""Block acknowledgement agreements: ADDBA request and response before the first A-MPDU.

If the response is late, a station sends single frames for a while and then requests the agreement
again (IEEE Std 802.11-2020, 10.25.2 and 11.5). Both times are ns-3's.
"""

import numpy as np

from discostorm_simulation import state as st
from discostorm_simulation.kernels.channel_access import enter_cell, request_access
from discostorm_simulation.kernels.decorators import inlined, not_inlined
from discostorm_simulation.kernels.primitives import access_point, schedule_event
from discostorm_simulation.kernels.queues import change_length, receiving_host

#: Time allowed for a response after the request's acknowledgement (5 ms), and duration of the
#: single frames that follow a late response (0.2 s), in ticks of 100 ns.
RESPONSE_TIMEOUT, RETRY_PAUSE = np.int64(50_000), np.int64(2_000_000)


@inlined
def is_established(cell, station, frame):
    """Return whether a station may send A-MPDUs to the receiver of this frame."""
    if station < cell.state[0].hosts:
        return cell.block_acks[station, st.UPWARD].state == st.ESTABLISHED
    return cell.block_acks[receiving_host(cell, frame), st.DOWNWARD].state == st.ESTABLISHED


@inlined
def is_addba_request(cell, station, direction):
    """Return whether a station's ADDBA frame is a request; if not, the frame is a response."""
    return (direction == st.UPWARD) == (station < cell.state[0].hosts)


@inlined
def queue_addba(cell, station, host, direction):
    """Queue an ADDBA request or response, ahead of the station's data."""
    state, block_ack = cell.state[0], cell.block_acks[host, direction]
    state.addba_frames += 1
    if is_addba_request(cell, station, direction):
        block_ack.request, block_ack.request_tries = state.addba_frames, 0
    else:
        waits = block_ack.response > 0
        block_ack.response, block_ack.response_tries = state.addba_frames, 0
        if waits:  # the new response replaces a waiting one
            return
    cell.addba[station].waiting += 1
    change_length(cell, station, 1)


@not_inlined
def choose_addba(cell, station):
    """Choose the station's oldest ADDBA frame; return whether the station has one."""
    state, its = cell.state[0], cell.addba[station]
    its.sends = -1
    if its.waiting == 0 or cell.stations[station].bar_pending:
        return False
    first, last = station, station + 1
    if station >= state.hosts:
        first, last = np.int64(0), state.hosts
    least = st.NEVER
    for host in range(first, last):
        if cell.cell_of[host] != state.here:
            continue
        for direction in range(2):
            block_ack = cell.block_acks[host, direction]
            asks = is_addba_request(cell, station, direction)
            order = block_ack.request if asks else block_ack.response
            if 0 < order < least:
                least = order
                its.sends = 2 * host + direction
    return True


@not_inlined
def request_block_ack(cell, host, direction):
    """Queue an ADDBA request of the station that may send now."""
    station = host if direction == st.UPWARD else access_point(cell.state[0])
    cell.block_acks[host, direction].state = st.REQUESTED
    queue_addba(cell, station, host, direction)
    cell.addba[station].sends = 2 * host + direction


@inlined
def dequeue_addba(cell, station, host, direction):
    """Remove an ADDBA request or response from the station's queue."""
    block_ack = cell.block_acks[host, direction]
    if is_addba_request(cell, station, direction):
        block_ack.request = 0
    else:
        block_ack.response = 0
    cell.addba[station].waiting -= 1
    cell.addba[station].sends = -1
    change_length(cell, station, -1)


@not_inlined
def addba_failed(cell, station, time):
    """Count an unacknowledged ADDBA frame; drop the frame after its last attempt."""
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


@not_inlined
def addba_arrived(cell, station, acknowledged):
    """Handle an acknowledged ADDBA frame; return the station that received the frame."""
    sends = cell.addba[station].sends
    host, direction = sends // 2, sends % 2
    dequeue_addba(cell, station, host, direction)
    other = access_point(cell.state[0]) if station == host else host
    if is_addba_request(cell, station, direction):
        schedule_event(cell, acknowledged + RESPONSE_TIMEOUT, st.ADDBA_TIMEOUT | sends)
        queue_addba(cell, other, host, direction)
    else:
        cell.block_acks[host, direction].state = st.ESTABLISHED
    return other


@not_inlined
def on_addba_timeout(cell, sends, time):
    """Handle a late ADDBA response: first allow single frames, later allow a new request."""
    host, direction = sends // 2, sends % 2
    block_ack = cell.block_acks[host, direction]
    if block_ack.state == st.UNANSWERED:
        block_ack.state = st.NO_BLOCK_ACK
    elif block_ack.state == st.REQUESTED:
        block_ack.state = st.UNANSWERED
        schedule_event(cell, time + RETRY_PAUSE, st.ADDBA_TIMEOUT | sends)
        enter_cell(cell, cell.cell_of[host])
        station = host if direction == st.UPWARD else access_point(cell.state[0])
        if cell.stations[station].length > 0:
            request_access(cell, station, time, time <= cell.state[0].idle)
