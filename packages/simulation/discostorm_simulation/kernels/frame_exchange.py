"""Frame exchanges: their duration and outcome. An RTS would be added to `plan_ppdu`."""

import numpy as np

from discostorm_simulation import state as st
from discostorm_simulation.kernels import channel_access, delivery, queues
from discostorm_simulation.kernels.block_ack import addba_arrived, addba_failed, is_established
from discostorm_simulation.kernels.capture_effect import captured_station
from discostorm_simulation.kernels.decorators import inlined, not_inlined
from discostorm_simulation.kernels.primitives import access_point, draw_below, draw_uniform, kind_of


@inlined
def is_addba(cell, station):
    """Return whether the station sends an ADDBA request or response."""
    its = cell.stations[station]
    return cell.state[0].cold and its.sent == 0 and not its.bar_pending


@not_inlined
def log_transmission(cell, station, start, end, outcome):
    """Log a transmission, and count its frames and airtime."""
    state, sent = cell.state[0], cell.stations[station].sent
    column = st.FAILED if outcome != st.SUCCESS else (st.UP if station < state.hosts else st.DOWN)
    # With user data, ADDBA and BlockAckReq frames continue after the burst.
    burst = sent == 0 and (state.stamp == 0 or state.open > 0)
    if sent == 0:
        state.requests += 1
        cell.airtime[state.kinds, column] += (end - start) * st.PARTS
    else:
        state.ppdus += 1
        state.mpdus += sent
        each = (end - start) * st.PARTS // sent
        for place in range(sent):
            held = cell.window[station, place]
            state.retried += held.tries > 0
            cell.airtime[kind_of(held.frame), column] += each
            burst |= not held.frame & st.STEADY
    if burst:
        state.drained = max(state.drained, end)
    if state.logged < cell.log.size:
        row = cell.log[state.logged]
        state.logged += 1
        row.start, row.end, row.station, row.frames = start, end, station, sent
        row.kind = -2 if is_addba(cell, station) else -1
        if sent:
            row.kind = kind_of(cell.window[station, 0].frame)
        row.outcome = outcome


@not_inlined
def drop_after_last_attempt(cell, station):
    """Drop a frame without block acknowledgement if that was its last attempt."""
    state, its, held = cell.state[0], cell.stations[station], cell.window[station, 0]
    tries = cell.pool[held.number].tries if station >= state.hosts else held.tries
    if tries < cell.radio[0].attempts or is_established(cell, station, held.frame):
        return
    queues.count_drop(cell, held.frame, station, st.RETRY_LIMIT)
    queues.change_length(cell, station, -1)
    if station >= state.hosts:
        queues.dequeue_after(cell, queues.receiving_host(cell, held.frame), np.int64(-1))
        return
    for place in range(1, its.held):
        delivery.move_frame_forward(cell, station, place, place - 1)
    its.held -= 1


@inlined
def on_failure(cell, station, time):
    """Handle a transmission without an answer: count the failure and prepare the next attempt."""
    state, radio, its = cell.state[0], cell.radio[0], cell.stations[station]
    # The station's retry counter (QSRC) restarts after the limit (10.23.2.2).
    its.failures = its.failures + 1 if its.failures < radio.attempts else 0
    if is_addba(cell, station):
        addba_failed(cell, station, time)
        return
    for place in range(its.sent):
        held = cell.window[station, place]
        if delivery.aggregates_per_host(cell, station):
            cell.pool[held.number].tries += 1
        else:
            held.tries += 1
    if its.sent > 1:
        its.bar_pending = 1
    elif state.cold and its.sent:
        drop_after_last_attempt(cell, station)
    # With block acknowledgements, frames are retried until they arrive or expire.
    elif its.sent and radio.mpdus == 1 and cell.window[station, 0].tries >= radio.attempts:
        queues.count_drop(cell, cell.window[station, 0].frame, station, st.RETRY_LIMIT)
        its.held = 0
        queues.change_length(cell, station, -1)


@not_inlined
def send_bar(cell, station, time, end):
    """Send a BlockAckReq without a collision; the answer reports that no MPDU arrived."""
    state, radio, its = cell.state[0], cell.radio[0], cell.stations[station]
    state.idle = max(end + radio.sifs + radio.block_ack, state.others)
    state.base = state.idle + radio.aifs
    state.busy += end - time + radio.block_ack
    log_transmission(cell, station, time, state.idle, st.SUCCESS)
    its.bar_pending, its.failures = 0, 0
    channel_access.back_off(cell, station, state.base)


@not_inlined
def send_addba(cell, station, time, end):
    """Send an ADDBA request or response without a collision."""
    state, radio = cell.state[0], cell.radio[0]
    state.idle = max(end + radio.sifs + radio.basic_ack, state.others)
    state.base = state.idle + radio.aifs
    state.busy += end - time + radio.basic_ack
    log_transmission(cell, station, time, state.idle, st.SUCCESS)
    cell.stations[station].failures = 0
    other = addba_arrived(cell, station, state.idle)
    channel_access.back_off(cell, station, state.base)
    if cell.stations[other].length > 0:
        channel_access.request_access(cell, other, end, False)


@not_inlined
def dequeue_received(cell, to):
    """Remove the received frames to a host from the access point's queue."""
    station = access_point(cell.state[0])
    last = np.int64(-1)
    for place in range(cell.stations[station].sent):
        held = cell.window[station, place]
        if held.came & delivery.NOT_RECEIVED:
            last = held.number
            cell.pool[last].tries += 1
        else:
            queues.dequeue_after(cell, to, last)


@not_inlined
def send_multicast(cell, time, end):
    """Send the access point's multicast frame without a collision or an acknowledgement."""
    state = cell.state[0]
    station = access_point(state)
    its, frame = cell.stations[station], cell.window[station, 0].frame
    state.idle = max(end, state.others)
    state.base = state.idle + cell.radio[0].aifs
    state.busy += end - time
    log_transmission(cell, station, time, end, st.SUCCESS)
    its.held, its.failures = 0, 0
    queues.change_length(cell, station, -1)
    channel_access.back_off(cell, station, state.base)
    delivery.deliver(cell, station, frame, end, its.sent == 1)


@inlined
def send_unicast(cell, station, time, end):
    """Send a unicast PPDU without a collision; the receiver answers unless no MPDU is intact."""
    state, radio, its = cell.state[0], cell.radio[0], cell.stations[station]
    answer = radio.ack if its.sent == 1 else radio.block_ack
    # Stations that receive the frame reserve time for the answer, sent or not (NAV).
    state.idle = max(end + radio.sifs + answer, state.others)
    state.base = state.idle + radio.aifs
    link = station
    if station >= state.hosts:
        link = queues.receiving_host(cell, cell.window[station, 0].frame)
    loss = cell.stations[link].loss
    in_order = state.per_receiver and station < state.hosts
    good, damaged = np.int64(0), state.damaged
    for place in range(its.sent):
        held = cell.window[station, place]
        if place < damaged or (loss > 0 and draw_uniform(state) < loss):
            held.came |= delivery.NOT_RECEIVED
        else:
            cell.senders[good].frame = held.frame
            if in_order:
                cell.ordered[station, held.number % radio.window] = held.frame
            good += 1
    if good == 0:
        for place in range(its.sent):
            cell.window[station, place].came &= ~delivery.NOT_RECEIVED
        state.busy += end - time
        log_transmission(cell, station, time, end, st.ERROR)
        on_failure(cell, station, end)
        channel_access.back_off(cell, station, max(end + radio.timeout, state.others) + radio.aifs)
        return
    state.busy += end - time + answer
    log_transmission(cell, station, time, state.idle, st.SUCCESS)
    its.failures = 0
    if delivery.aggregates_per_host(cell, station):
        dequeue_received(cell, link)
    else:
        kept = np.int64(0)
        for place in range(its.held):
            held = cell.window[station, place]
            if place >= its.sent or held.came & delivery.NOT_RECEIVED:
                held.tries += held.came >= delivery.NOT_RECEIVED
                held.came &= ~delivery.NOT_RECEIVED
                delivery.move_frame_forward(cell, station, place, kept)
                kept += 1
        its.held = kept
    queues.change_length(cell, station, -good)
    channel_access.back_off(cell, station, state.base)
    alone = its.sent == 1 and state.others <= end
    if in_order:
        delivery.deliver_in_order(cell, station, end, alone)
        return
    for place in range(good):
        delivery.deliver(cell, station, cell.senders[place].frame, end, alone)


@inlined
def transmit_alone(cell, station, time):
    """Send a station's next transmission without a collision."""
    alone = delivery.plan_ppdu(cell, station)
    if is_addba(cell, station):
        send_addba(cell, station, time, time + alone)
    elif cell.stations[station].sent == 0:
        send_bar(cell, station, time, time + alone)
    elif delivery.is_multicast(cell, station):
        send_multicast(cell, time, time + alone)
    else:
        send_unicast(cell, station, time, time + alone)


@not_inlined
def end_of_answer(cell, station, time):
    """Return when the answer to a captured frame ends, and how long only other senders transmit."""
    radio, its = cell.radio[0], cell.stations[station]
    end = time + delivery.plan_ppdu(cell, station)
    length, pause = radio.ack if its.sent == 1 else radio.block_ack, radio.sifs
    if is_addba(cell, station):
        length = radio.basic_ack
    elif delivery.is_multicast(cell, station):
        length, pause = np.int64(0), np.int64(0)
    begun, others = end + pause, cell.state[0].others
    hidden = max(min(others, begun + length) - begun, 0)
    return begun + length, max(others - end, 0) - hidden


@not_inlined
def transmit_together(cell, count, time):
    """Send from several stations at once; return the captured station, or -1."""
    state, radio = cell.state[0], cell.radio[0]
    last = np.int64(0)
    for place in range(count):
        sender = cell.senders[place]
        sender.end = time + delivery.plan_ppdu(cell, sender.station)
        last = max(last, sender.end)
    winner, answered, quiet, busy = np.int64(-1), last, last, last - time
    if state.unlike:
        winner = captured_station(cell, count, time)
        if winner >= 0:
            state.others = last
            answered, busy = end_of_answer(cell, winner, time)
            quiet = max(last, answered)
    free = quiet
    if radio.eifs_extra > 0 and winner < 0:
        # Stations that take a collision for a damaged frame wait for its answer (EIFS).
        free = max(last, cell.senders[draw_below(state, count)].end + radio.eifs_extra)
    state.idle = quiet
    state.base = free + radio.aifs
    state.collisions += 1
    state.collided += count
    state.busy += busy
    state.wasted += busy
    least = st.NEVER
    for place in range(count):
        sender = cell.senders[place]
        station, base = sender.station, quiet + radio.aifs
        if station == winner:
            sender.base = st.NEVER
            continue
        its, held = cell.stations[station], cell.window[station, 0]
        log_transmission(cell, station, time, sender.end, st.COLLISION)
        if delivery.is_multicast(cell, station):
            # Multicast is never acknowledged, so the sender does not notice the loss.
            queues.count_drop(cell, held.frame, station, st.LOST_ON_AIR)
            its.held, its.failures = 0, 0
            queues.change_length(cell, station, -1)
        else:
            on_failure(cell, station, last)
            # Stations that receive another's answer wait for its end, not for their own timeout.
            if winner < 0 or sender.end >= answered:
                base = max(sender.end + radio.timeout, quiet) + radio.aifs
        sender.slots, sender.base = channel_access.draw_backoff(cell, station), base
        if its.length == 0 or base == state.base:
            channel_access.start_backoff(cell, station, base, sender.slots)
            sender.base = st.NEVER
        least = min(least, sender.base)
    if least == st.NEVER:
        return winner
    slot = channel_access.next_slot_before(cell, least) if winner < 0 else np.int64(-1)
    for place in range(count):
        sender = cell.senders[place]
        if sender.base < st.NEVER:
            if slot >= 0:
                sends_at = slot + radio.edca + sender.slots
                channel_access.enter_backoff_wheel(cell, sender.station, sends_at)
            else:
                channel_access.start_backoff(cell, sender.station, sender.base, sender.slots)
    return winner
