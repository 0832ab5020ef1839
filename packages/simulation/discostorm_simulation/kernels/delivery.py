"""Delivery: the frames that a station sends next, and the next hop of frames that arrive."""

import numpy as np

from discostorm_simulation import state as st
from discostorm_simulation.kernels import primitives, queues
from discostorm_simulation.kernels.block_ack import choose_addba, is_established, request_block_ack
from discostorm_simulation.kernels.channel_access import queue_at_ap, relay_to_cells
from discostorm_simulation.kernels.decorators import inlined, not_inlined
from discostorm_simulation.kernels.middleware_events import receive_message, send_answers
from discostorm_simulation.kernels.user_data import receive_user_data

#: Flag in a frame's arrival time: this frame of an A-MPDU has not been received.
NOT_RECEIVED = np.int64(2**62)


@inlined
def move_frame_forward(cell, station, place, kept):
    """Move a frame of the window to an earlier index."""
    if kept < place:
        cell.window[station, kept] = cell.window[station, place]


@not_inlined
def exceeds_interference(cell, count, station, to, factor):
    """Return whether ``station`` is ``factor`` times stronger at ``to`` than all other senders."""
    others = 0.0
    for place in range(count):
        other = cell.senders[place].station
        if other == to:  # a sending station cannot receive
            return False
        if other != station:
            others += cell.power[other, to]
    return cell.power[station, to] > factor * others


@not_inlined
def deliver(cell, station, frame, time, alone):
    """Deliver a received frame: to access points' queues, or to its receiving processes."""
    state = cell.state[0]
    row = cell.kinds[primitives.kind_of(frame)]
    if station < state.hosts and row.down:
        if state.cells > 1:
            relay_to_cells(cell, frame, time, alone)
        else:
            queue_at_ap(cell, frame, time, alone)
        return
    burst = not frame & st.STEADY
    state.open -= burst
    if station < state.hosts or not row.multicast:
        state.arrived += burst
        if row.user:
            receive_user_data(cell, frame, time)
        if state.repairs:
            receive_message(cell, frame, primitives.destination_of(frame), time)
        elif row.user:
            send_answers(cell, frame, primitives.destination_of(frame), time)
        return
    sender, factor = queues.source_host(cell, frame), cell.radio[0].capture_threshold_basic
    for host in range(state.hosts):
        its = cell.stations[host]
        if host == sender or cell.cell_of[host] != state.here:
            continue
        deaf = state.overlapping > 0 and not exceeds_interference(
            cell, state.overlapping, station, host, factor
        )
        if deaf or (its.loss > 0 and primitives.draw_uniform(state) < its.loss):
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


@not_inlined
def deliver_in_order(cell, host, time, alone):
    """Deliver a host's frames in order; frames after a gap wait (10.25)."""
    its, ring = cell.stations[host], cell.radio[0].window
    end = cell.window[host, 0].number if its.held else its.following
    for number in range(its.passed, end):
        frame = cell.ordered[host, number % ring]
        if frame >= 0:
            cell.ordered[host, number % ring] = -1
            deliver(cell, host, frame, time, alone)
    its.passed = end


@not_inlined
def drop_expired(cell, station, time):
    """Drop the expired frames of a station's window."""
    its = cell.stations[station]
    kept = np.int64(0)
    for place in range(its.held):
        held = cell.window[station, place]
        if time - held.came > cell.radio[0].lifetime:
            queues.count_drop(cell, held.frame, station, st.EXPIRED)
            queues.change_length(cell, station, -1)
        else:
            move_frame_forward(cell, station, place, kept)
            kept += 1
    its.held = kept
    if cell.state[0].per_receiver:
        deliver_in_order(cell, station, time, True)


@inlined
def aggregates_per_host(cell, station):
    """Return whether the station is an access point that sends A-MPDUs, each to one host."""
    return cell.state[0].per_receiver and station >= cell.state[0].hosts


@not_inlined
def first_unblocked_entry(cell, node):
    """Return the first queued frame from ``node`` on that no pending agreement blocks, or -1."""
    state = cell.state[0]
    while node >= 0:
        if queues.frames_in_entry(cell.pool[node].frame):
            to = queues.receiving_host(cell, cell.pool[node].frame)
            if to >= state.hosts or cell.block_acks[to, st.DOWNWARD].state != st.REQUESTED:
                return node
        node = np.int64(cell.pool[node].next)
    return np.int64(-1)


@not_inlined
def fill_window_for_one_host(cell, time):
    """Fill the access point's window with frames for the host whose frame is oldest."""
    state, radio = cell.state[0], cell.radio[0]
    station = primitives.access_point(state)
    its = cell.stations[station]
    if its.bar_pending:
        return True
    its.held = 0
    node = queues.oldest_entry(cell, station, time)
    if state.cold:
        node = first_unblocked_entry(cell, node)
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
        if to >= state.hosts:
            queues.dequeue_after(cell, to, np.int64(-1))
            break
    return True


@inlined
def fill_window(cell, station, time):
    """Fill a station's window with its oldest frames; return whether the station can send."""
    radio, its = cell.radio[0], cell.stations[station]
    cold = cell.state[0].cold
    if cold and choose_addba(cell, station):
        return True
    if aggregates_per_host(cell, station):
        return fill_window_for_one_host(cell, time)
    if its.held and radio.lifetime < st.NEVER:
        drop_expired(cell, station, time)
    while its.held < radio.mpdus:
        if its.held and its.following - cell.window[station, 0].number >= radio.window:
            break
        node = queues.oldest_entry(cell, station, time)
        if node < 0:
            break
        frame, came, left = cell.pool[node].frame, cell.pool[node].came, np.int64(0)
        if frame < 0:
            left, burst = queues.frames_in_entry(frame) - 1, queues.burst_in_entry(frame)
            cell.pool[node].frame = queues.burst_entry(burst, left)
            frame = queues.next_frame(cell, station, burst)
            its.begun *= left > 0
        if left == 0:
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


@inlined
def row_in_current_cell(cell, frame):
    """Return the row of a frame with octets and times as on the current cell's channel."""
    return cell.kinds[cell.state[0].rows_at + primitives.kind_of(frame)]


@inlined
def subframe_octets(cell, frame):
    """Return the octets of an A-MPDU subframe: MPDU, delimiter and padding (9.7.1)."""
    padded = 4 + (row_in_current_cell(cell, frame).octets + 3) // 4 * 4
    return max(padded, cell.radio[0].min_subframe)


@inlined
def ppdu_duration(radio, octets):
    """Return the duration of a PPDU with that many octets of data [ticks]."""
    symbols = (radio.added + 8 * octets + radio.bits - 1) // radio.bits
    blocks = (symbols * radio.symbol + radio.grid - 1) // radio.grid
    return radio.preamble + blocks * radio.grid


@inlined
def plan_ppdu(cell, station):
    """Choose how many frames of the window to aggregate; return the PPDU's duration [ticks]."""
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
            return ppdu_duration(cell.radio[0], octets)
    its.sent = 1
    row = row_in_current_cell(cell, frame)
    return row.time_down if station >= cell.state[0].hosts else row.time_up


@inlined
def is_multicast(cell, station):
    """Return whether the station sends a multicast frame, which no station acknowledges."""
    if station < cell.state[0].hosts or cell.stations[station].sent == 0:
        return False
    return cell.kinds[primitives.kind_of(cell.window[station, 0].frame)].multicast > 0
