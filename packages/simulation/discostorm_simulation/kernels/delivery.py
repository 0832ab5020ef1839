"""What a station sends next, and where it goes when it has arrived."""

import numpy as np

from discostorm_simulation import state as st
from discostorm_simulation.kernels import queues
from discostorm_simulation.kernels.block_ack import choose_addba, is_established, request_block_ack
from discostorm_simulation.kernels.channel_access import enqueue_or_drop, request_access
from discostorm_simulation.kernels.decorators import njit, shared
from discostorm_simulation.kernels.primitives import destination_of, kind_of, uniform
from discostorm_simulation.kernels.recovery import receive_message, send_answers
from discostorm_simulation.kernels.user_data import receive_user_data

#: Marks a frame of an A-MPDU that has not arrived, in the time at which it came.
MISSING = np.int64(2**62)


@njit
def move_forward(cell, station, place, kept):
    """Move a held frame forward."""
    if kept < place:
        held, free = cell.window[station, place], cell.window[station, kept]
        free.frame, free.came = held.frame, held.came
        free.number, free.tries = held.number, held.tries


@shared
def exceeds_interference(cell, count, station, to, factor):
    """Return whether a station hears one of those that send now above the sum of the others."""
    others = 0.0
    for place in range(count):
        other = cell.senders[place].station
        if other == to:  # who sends hears nothing
            return False
        if other != station:
            others += cell.power[other, to]
    return cell.power[station, to] > factor * others


@njit
def hears_multicast(cell, host):
    """Return whether a host receives the access point's multicast in spite of others."""
    state = cell.state[0]
    return exceeds_interference(
        cell, state.overlapping, state.hosts, host, cell.radio[0].capture_threshold_basic
    )


@shared
def deliver(cell, station, frame, time, alone):
    """Pass on what has arrived: to the access point's queue, or to who it is for."""
    state = cell.state[0]
    row = cell.kinds[kind_of(frame)]
    if station < state.hosts and row.down:
        if enqueue_or_drop(cell, state.hosts, frame, time):
            # Between a single frame and its acknowledgement the medium is idle (10.23.2.2 a).
            request_access(cell, state.hosts, time, not alone)
        return
    burst = not frame & st.STEADY
    state.open -= burst
    if station < state.hosts or not row.multicast:
        state.arrived += burst
        if row.user:
            receive_user_data(cell, frame, time)
        if state.repairs:
            receive_message(cell, frame, destination_of(frame), time)
        elif row.user:
            send_answers(cell, frame, destination_of(frame), time)
        return
    sender = queues.source_host(cell, frame)
    for host in range(state.hosts):
        its = cell.stations[host]
        if host == sender:
            continue
        deaf = state.overlapping > 0 and not hears_multicast(cell, host)
        if deaf or (its.loss > 0 and uniform(state) < its.loss):
            state.on_air += burst
            cell.stations[sender].missed += burst
            if row.user:
                queues.count_user_data_drop(cell, frame, 1, station, st.LOST_ON_AIR)
            continue
        state.arrived += burst
        if row.user:
            receive_user_data(cell, frame, time)
        if state.repairs:
            for process in range(its.first, its.first + its.processes):
                receive_message(cell, frame, process, time)


@shared
def pass_on(cell, host, time, alone):
    """Pass on in order what has come from a host; what comes after a gap waits (10.25)."""
    its, ring = cell.stations[host], cell.radio[0].window
    end = cell.window[host, 0].number if its.held else its.following
    for number in range(its.passed, end):
        frame = cell.ordered[host, number % ring]
        if frame >= 0:
            cell.ordered[host, number % ring] = -1
            deliver(cell, host, frame, time, alone)
    its.passed = end


@shared
def drop_expired(cell, station, time):
    """Drop the held frames that are too old."""
    its = cell.stations[station]
    kept = np.int64(0)
    for place in range(its.held):
        held = cell.window[station, place]
        if time - held.came > cell.radio[0].lifetime:
            queues.count_drop(cell, held.frame, station, st.EXPIRED)
            queues.change_length(cell, station, -1)
        else:
            move_forward(cell, station, place, kept)
            kept += 1
    its.held = kept
    if cell.state[0].per_receiver:
        pass_on(cell, station, time, True)


@njit
def aggregates(cell, station):
    """Return whether a station is the access point and sends A-MPDUs, to one host each."""
    return cell.state[0].per_receiver and station == cell.state[0].hosts


@shared
def first_free(cell, node):
    """Return the access point's first frame from one on that waits for no agreement, or -1."""
    state = cell.state[0]
    while node >= 0:
        frames = queues.frames_of(cell.pool[node].frame)
        if frames:
            to = queues.receiving_host(cell, cell.pool[node].frame)
            if to == state.hosts or cell.block_acks[to, st.DOWNWARD].state != st.REQUESTED:
                return node
        node = np.int64(cell.pool[node].next)
    return np.int64(-1)


@shared
def fill_window_for_one(cell, time):
    """Fill what the access point sends next to the host that has waited longest."""
    state, radio = cell.state[0], cell.radio[0]
    station = state.hosts
    its = cell.stations[station]
    if its.bar_pending:
        return True
    its.held = 0
    node = queues.oldest_entry(cell, station, time)
    if state.cold:
        node = first_free(cell, node)
    if node < 0:
        return False
    to, most = queues.receiving_host(cell, cell.pool[node].frame), radio.mpdus
    if state.cold and to < state.hosts:
        block_ack = cell.block_acks[to, st.DOWNWARD].state
        if block_ack == st.NO_BLOCK_ACK and cell.pool[node].same >= 0:
            request_block_ack(cell, to, st.DOWNWARD)
            return True
        if block_ack != st.ESTABLISHED:
            most = np.int64(1)
    first = np.int64(cell.pool[node].number)
    while node >= 0 and its.held < most and cell.pool[node].number < first + radio.window:
        waiting, held = cell.pool[node], cell.window[station, its.held]
        held.frame, held.came, held.number = waiting.frame, waiting.came, node
        held.tries = waiting.tries
        its.held += 1
        node = waiting.same
        if to == state.hosts:
            queues.dequeue_first_for(cell, to)
            break
    return True


@njit
def fill_window(cell, station, time):
    """Fill what the station sends next, oldest first; return whether there is anything."""
    radio, its = cell.radio[0], cell.stations[station]
    cold = cell.state[0].cold
    if cold and choose_addba(cell, station):
        return True
    if aggregates(cell, station):
        return fill_window_for_one(cell, time)
    if its.held and radio.lifetime < st.NEVER:
        drop_expired(cell, station, time)
    while its.held < radio.mpdus:
        if its.held and its.following - cell.window[station, 0].number >= radio.window:
            break
        node = queues.oldest_entry(cell, station, time)
        if node < 0:
            break
        frame, came = cell.pool[node].frame, cell.pool[node].came
        if frame < 0:
            left, burst = queues.frames_of(frame) - 1, queues.burst_of(frame)
            cell.pool[node].frame = queues.burst_entry(burst, left)
            frame = queues.next_frame(cell, station, burst)
            if left == 0:
                its.begun = 0
                queues.drop_head(cell, station)
        else:
            queues.drop_head(cell, station)
        held = cell.window[station, its.held]
        held.frame, held.came, held.number, held.tries = frame, came, its.following, 0
        its.following += 1
        its.held += 1
    if cold and not its.bar_pending:
        state = cell.block_acks[station, st.UPWARD].state
        if state == st.REQUESTED:
            return False
        if state == st.NO_BLOCK_ACK and its.length > 1:
            request_block_ack(cell, station, st.UPWARD)
            return True
    return its.held > 0 or its.bar_pending > 0


@njit
def subframe_octets(cell, frame):
    """Return the bytes of a frame in an A-MPDU: with delimiter and padding (9.7.1)."""
    padded = 4 + (cell.kinds[kind_of(frame)].octets + 3) // 4 * 4
    return max(padded, cell.radio[0].min_subframe)


@njit
def data_ticks(radio, octets):
    """Return the duration of a PPDU with that many bytes of data."""
    symbols = (radio.added + 8 * octets + radio.bits - 1) // radio.bits
    blocks = (symbols * radio.symbol + radio.grid - 1) // radio.grid
    return radio.preamble + blocks * radio.grid


@njit
def plan_ppdu(cell, station):
    """Decide how many of the held frames go together; return how long they take."""
    its = cell.stations[station]
    if its.bar_pending:
        its.sent = 0
        return cell.radio[0].bar
    if cell.state[0].cold and cell.addba[station].sends >= 0:
        its.sent = 0
        return cell.radio[0].addba
    frame = cell.window[station, 0].frame
    if its.held > 1 and (not cell.state[0].cold or is_established(cell, station, frame)):
        octets, together = subframe_octets(cell, frame), np.int64(1)
        while together < its.held:
            more = octets + subframe_octets(cell, cell.window[station, together].frame)
            if more > cell.radio[0].max_bytes:
                break
            octets = more
            together += 1
        if together > 1:
            its.sent = together
            return data_ticks(cell.radio[0], octets)
    its.sent = 1
    row = cell.kinds[kind_of(frame)]
    return row.time_down if station == cell.state[0].hosts else row.time_up


@njit
def is_multicast(cell, station):
    """Return whether the station sends a frame that nobody acknowledges."""
    if station < cell.state[0].hosts or cell.stations[station].sent == 0:
        return False
    return cell.kinds[kind_of(cell.window[station, 0].frame)].multicast > 0
