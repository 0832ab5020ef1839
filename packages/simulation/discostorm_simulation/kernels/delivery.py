"""What a station sends next, and where it goes when it has arrived."""

import numpy as np

from discostorm_simulation.kernels.block_ack import agreed, ask, choose_action
from discostorm_simulation.kernels.channel_access import offer, wake
from discostorm_simulation.kernels.decorators import njit, shared
from discostorm_simulation.kernels.primitives import destination_of, kind_of, uniform
from discostorm_simulation.kernels.queues import (
    batch_of,
    burst_entry,
    change_length,
    drop_head,
    first_entry,
    frames_of,
    host_of,
    lose,
    lose_user_data,
    make,
    receiver,
    take_same,
)
from discostorm_simulation.kernels.recovery import answer, arrive
from discostorm_simulation.kernels.user_data import take_user_data
from discostorm_simulation.state import (
    AGE,
    AGREED,
    AIR,
    ASKED,
    DOWNWARD,
    NEVER,
    NONE,
    STEADY,
    UPWARD,
)

#: Marks a frame of an A-MPDU that has not arrived, in the time at which it came.
MISSING = np.int64(2**62)


@njit
def keep(cell, station, place, kept):
    """Move a held frame forward."""
    if kept < place:
        held, free = cell.window[station, place], cell.window[station, kept]
        free.frame, free.came = held.frame, held.came
        free.number, free.tries = held.number, held.tries


@shared
def prevails(cell, count, station, to, factor):
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
def hears(cell, host):
    """Return whether a host receives the access point's multicast in spite of others."""
    now = cell.now[0]
    return prevails(cell, now.overlapping, now.hosts, host, cell.radio[0].exceeds_basic)


@shared
def deliver(cell, station, frame, time, alone):
    """Pass on what has arrived: to the access point's queue, or to who it is for."""
    now = cell.now[0]
    row = cell.kinds[kind_of(frame)]
    if station < now.hosts and row.down:
        if offer(cell, now.hosts, frame, time):
            # Between a single frame and its acknowledgement the medium is idle (10.23.2.2 a).
            wake(cell, now.hosts, time, not alone)
        return
    burst = not frame & STEADY
    now.open -= burst
    if station < now.hosts or not row.multicast:
        now.arrived += burst
        if row.user:
            take_user_data(cell, frame, time)
        if now.repairs:
            arrive(cell, frame, destination_of(frame), time)
        elif row.user:
            answer(cell, frame, destination_of(frame), time)
        return
    sender = host_of(cell, frame)
    for host in range(now.hosts):
        its = cell.stations[host]
        if host == sender:
            continue
        deaf = now.overlapping > 0 and not hears(cell, host)
        if deaf or (its.loss > 0 and uniform(now) < its.loss):
            now.on_air += burst
            cell.stations[sender].missed += burst
            if row.user:
                lose_user_data(cell, frame, 1, station, AIR)
            continue
        now.arrived += burst
        if row.user:
            take_user_data(cell, frame, time)
        if now.repairs:
            for process in range(its.first, its.first + its.processes):
                arrive(cell, frame, process, time)


@shared
def pass_on(cell, host, time, alone):
    """Pass on what has come to the access point from a host, in order.

    What comes after a missing frame waits until that is there or given up (10.25).
    """
    its, ring = cell.stations[host], cell.radio[0].window
    end = cell.window[host, 0].number if its.held else its.following
    for number in range(its.passed, end):
        frame = cell.ordered[host, number % ring]
        if frame >= 0:
            cell.ordered[host, number % ring] = -1
            deliver(cell, host, frame, time, alone)
    its.passed = end


@shared
def throw_out_old(cell, station, time):
    """Drop the held frames that are too old."""
    its = cell.stations[station]
    kept = np.int64(0)
    for place in range(its.held):
        held = cell.window[station, place]
        if time - held.came > cell.radio[0].lifetime:
            lose(cell, held.frame, station, AGE)
            change_length(cell, station, -1)
        else:
            keep(cell, station, place, kept)
            kept += 1
    its.held = kept
    if cell.now[0].per_receiver:
        pass_on(cell, station, time, True)


@njit
def aggregates(cell, station):
    """Return whether a station is the access point and sends A-MPDUs, to one host each."""
    return cell.now[0].per_receiver and station == cell.now[0].hosts


@shared
def first_free(cell, node):
    """Return the access point's first frame from one on that waits for no agreement, or -1."""
    now = cell.now[0]
    while node >= 0:
        frames = frames_of(cell.pool[node].frame)
        if frames:
            to = receiver(cell, cell.pool[node].frame)
            if to == now.hosts or cell.agreements[to, DOWNWARD].state != ASKED:
                return node
        node = np.int64(cell.pool[node].next)
    return np.int64(-1)


@shared
def load_to_one(cell, time):
    """Fill what the access point sends next to the host that has waited longest.

    What is not for all stays in the queue until it has arrived: so whoever has waited longest then
    is next, not who lacks a part of the last A-MPDU.
    """
    now, radio = cell.now[0], cell.radio[0]
    station = now.hosts
    its = cell.stations[station]
    if its.must_ask:
        return True
    its.held = 0
    node = first_entry(cell, station, time)
    if now.cold:
        node = first_free(cell, node)
    if node < 0:
        return False
    to, most = receiver(cell, cell.pool[node].frame), radio.mpdus
    if now.cold and to < now.hosts:
        state = cell.agreements[to, DOWNWARD].state
        if state == NONE and cell.pool[node].same >= 0:
            ask(cell, to, DOWNWARD)
            return True
        if state != AGREED:
            most = np.int64(1)
    first = np.int64(cell.pool[node].number)
    while node >= 0 and its.held < most and cell.pool[node].number < first + radio.window:
        waiting, held = cell.pool[node], cell.window[station, its.held]
        held.frame, held.came, held.number = waiting.frame, waiting.came, node
        held.tries = waiting.tries
        its.held += 1
        node = waiting.same
        if to == now.hosts:
            take_same(cell, to)
            break
    return True


@njit
def load(cell, station, time):
    """Fill what the station sends next, oldest first; return whether there is anything."""
    radio, its = cell.radio[0], cell.stations[station]
    cold = cell.now[0].cold
    if cold and choose_action(cell, station):
        return True
    if aggregates(cell, station):
        return load_to_one(cell, time)
    if its.held and radio.lifetime < NEVER:
        throw_out_old(cell, station, time)
    while its.held < radio.mpdus:
        if its.held and its.following - cell.window[station, 0].number >= radio.window:
            break
        node = first_entry(cell, station, time)
        if node < 0:
            break
        frame, came = cell.pool[node].frame, cell.pool[node].came
        if frame < 0:
            left, batch = frames_of(frame) - 1, batch_of(frame)
            cell.pool[node].frame = burst_entry(batch, left)
            frame = make(cell, station, batch)
            if left == 0:
                its.begun = 0
                drop_head(cell, station)
        else:
            drop_head(cell, station)
        held = cell.window[station, its.held]
        held.frame, held.came, held.number, held.tries = frame, came, its.following, 0
        its.following += 1
        its.held += 1
    if cold and not its.must_ask:
        state = cell.agreements[station, UPWARD].state
        if state == ASKED:
            return False
        if state == NONE and its.length > 1:
            ask(cell, station, UPWARD)
            return True
    return its.held > 0 or its.must_ask > 0


@njit
def subframe(cell, frame):
    """Return the bytes of a frame in an A-MPDU: with delimiter and padding (9.7.1)."""
    padded = 4 + (cell.kinds[kind_of(frame)].octets + 3) // 4 * 4
    return max(padded, cell.radio[0].least_subframe)


@njit
def data_ticks(radio, octets):
    """Return the duration of a PPDU with that many bytes of data."""
    symbols = (radio.added + 8 * octets + radio.bits - 1) // radio.bits
    blocks = (symbols * radio.symbol + radio.grid - 1) // radio.grid
    return radio.preamble + blocks * radio.grid


@njit
def ppdu(cell, station):
    """Decide how many of the held frames go together; return how long they take."""
    its = cell.stations[station]
    if its.must_ask:
        its.sent = 0
        return cell.radio[0].request
    if cell.now[0].cold and cell.actions[station].sends >= 0:
        its.sent = 0
        return cell.radio[0].action
    frame = cell.window[station, 0].frame
    if its.held > 1 and (not cell.now[0].cold or agreed(cell, station, frame)):
        octets, together = subframe(cell, frame), np.int64(1)
        while together < its.held:
            more = octets + subframe(cell, cell.window[station, together].frame)
            if more > cell.radio[0].most_bytes:
                break
            octets = more
            together += 1
        if together > 1:
            its.sent = together
            return data_ticks(cell.radio[0], octets)
    its.sent = 1
    row = cell.kinds[kind_of(frame)]
    return row.time_down if station == cell.now[0].hosts else row.time_up


@njit
def is_multicast(cell, station):
    """Return whether the station sends a frame that nobody acknowledges."""
    if station < cell.now[0].hosts or cell.stations[station].sent == 0:
        return False
    return cell.kinds[kind_of(cell.window[station, 0].frame)].multicast > 0
