"""The run itself: from one transmission to the next, with what arrives and what is lost."""

import numpy as np

from discostorm.simulation._compile import entry, njit, shared, sources
from discostorm.simulation.cell import (
    AGE,
    AIR,
    COLLISION,
    ERROR,
    NEVER,
    RETRY,
    STEADY,
    SUCCESS,
    below,
    destination_of,
    kind_of,
    next_event,
    next_random,
    scaled,
    uniform,
)
from discostorm.simulation.medium import (
    back_off,
    draw,
    enter,
    first_to_send,
    next_slot,
    offer,
    synchronize,
    wait,
    wake,
)
from discostorm.simulation.queues import (
    BATCHES,
    batch_of,
    burst_entry,
    change_length,
    drop_head,
    first_entry,
    frames_of,
    host_of,
    like_last,
    lose,
    make,
    make_like_last,
    receiver,
    receivers,
    take_after,
    take_same,
)
from discostorm.simulation.recovery import arrive, happen, settled

#: What `advance` returns: it is over, it wants more memory, or it has done its share.
OVER, MEMORY, SHARE = range(3)

#: Columns of `Cell.airtime`, which counts in parts of a tick.
UP, DOWN, FAILED = range(3)
PARTS = 1024

#: Marks a frame of an A-MPDU that has not arrived, in the time at which it came.
_MISSING = np.int64(2**62)


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
def keep(cell, station, place, kept):
    """Move a held frame forward."""
    if kept < place:
        held, free = cell.window[station, place], cell.window[station, kept]
        free.frame, free.came = held.frame, held.came
        free.number, free.tries = held.number, held.tries


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
        if now.repairs:
            arrive(cell, frame, destination_of(frame), time)
        return
    sender = host_of(cell, frame)
    for host in range(now.hosts):
        its = cell.stations[host]
        if host == sender:
            continue
        if its.loss > 0 and uniform(now) < its.loss:
            now.on_air += burst
            cell.stations[sender].missed += burst
            continue
        now.arrived += burst
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
    if node < 0:
        return False
    to = receiver(cell, cell.pool[node].frame)
    first = np.int64(cell.pool[node].number)
    while node >= 0 and its.held < radio.mpdus and cell.pool[node].number < first + radio.window:
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
    return its.held > 0 or its.must_ask > 0


@njit
def ppdu(cell, station):
    """Decide how many of the held frames go together; return how long they take."""
    its = cell.stations[station]
    if its.must_ask:
        its.sent = 0
        return cell.radio[0].request
    frame = cell.window[station, 0].frame
    if its.held > 1:
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


@shared
def note(cell, station, start, end, outcome):
    """Record a transmission."""
    now, sent = cell.now[0], cell.stations[station].sent
    column = FAILED if outcome != SUCCESS else (UP if station < now.hosts else DOWN)
    burst = sent == 0
    if sent == 1:  # by far the most
        held = cell.window[station, 0]
        now.ppdus += 1
        now.mpdus += 1
        now.retried += held.tries > 0
        cell.airtime[kind_of(held.frame), column] += (end - start) * PARTS
        burst = not held.frame & STEADY
    elif sent == 0:
        now.requests += 1
        cell.airtime[now.kinds, column] += (end - start) * PARTS
    else:
        now.ppdus += 1
        now.mpdus += sent
        each = (end - start) * PARTS // sent
        for place in range(sent):
            held = cell.window[station, place]
            now.retried += held.tries > 0
            cell.airtime[kind_of(held.frame), column] += each
            burst |= not held.frame & STEADY
    if burst:
        now.drained = max(now.drained, end)
    if now.logged < cell.log.size:
        row = cell.log[now.logged]
        now.logged += 1
        row.start, row.end, row.station, row.frames = start, end, station, sent
        row.kind = kind_of(cell.window[station, 0].frame) if sent else -1
        row.outcome = outcome


@shared
def sample(cell, time):
    """Record queue lengths at regular times; half as often whenever the table is full."""
    now = cell.now[0]
    while time >= now.sample:
        if now.samples == cell.samples.size:
            now.samples //= 2
            for place in range(now.samples):
                cell.samples[place].time = cell.samples[2 * place].time
                cell.samples[place].hosts = cell.samples[2 * place].hosts
                cell.samples[place].access_point = cell.samples[2 * place].access_point
            now.step *= 2
            now.sample = now.samples * now.step
            continue
        row = cell.samples[now.samples]
        row.time, row.hosts = now.sample, now.queued
        row.access_point = cell.stations[now.hosts].length
        now.samples += 1
        now.sample += now.step


@njit
def count_failure(cell, station):
    """Note that nothing came back to a station."""
    radio, its = cell.radio[0], cell.stations[station]
    # The counter of the station, QSRC, starts anew after the limit (10.23.2.2).
    its.failures = its.failures + 1 if its.failures < radio.attempts else 0
    for place in range(its.sent):
        held = cell.window[station, place]
        if aggregates(cell, station):
            cell.pool[held.number].tries += 1
        else:
            held.tries += 1
    if its.sent > 1:
        its.must_ask = 1
    # Under a block acknowledgement frames are repeated until they arrive or are too old.
    elif its.sent and radio.mpdus == 1 and cell.window[station, 0].tries >= radio.attempts:
        lose(cell, cell.window[station, 0].frame, station, RETRY)
        its.held = 0
        change_length(cell, station, -1)


@shared
def send_request(cell, station, time, end):
    """Let a station ask, undisturbed, what has arrived of an A-MPDU: nothing has."""
    now, radio, its = cell.now[0], cell.radio[0], cell.stations[station]
    now.idle = end + radio.sifs + radio.block_ack
    now.base = now.idle + radio.aifs
    now.busy += end - time + radio.block_ack
    note(cell, station, time, now.idle, SUCCESS)
    its.must_ask, its.failures = 0, 0
    back_off(cell, station, now.base)


@shared
def send_multicast(cell, time, end):
    """Let the access point send to all at once; nobody acknowledges."""
    now = cell.now[0]
    station = now.hosts
    its, frame = cell.stations[station], cell.window[station, 0].frame
    now.idle = end
    now.base = end + cell.radio[0].aifs
    now.busy += end - time
    note(cell, station, time, end, SUCCESS)
    its.held, its.failures = 0, 0
    change_length(cell, station, -1)
    back_off(cell, station, now.base)
    deliver(cell, station, frame, end, its.sent == 1)


@shared
def take_arrived(cell, to):
    """Take what has arrived of the access point's last frames to a host off its queue."""
    station = cell.now[0].hosts
    last = np.int64(-1)
    for place in range(cell.stations[station].sent):
        held = cell.window[station, place]
        if held.came & _MISSING:
            last = held.number
            cell.pool[last].tries += 1
        else:
            take_after(cell, to, last)


@njit
def send_unicast(cell, station, time, end):
    """Let a station send undisturbed to one receiver, which answers unless all is damaged."""
    now, radio, its = cell.now[0], cell.radio[0], cell.stations[station]
    answer = radio.ack if its.sent == 1 else radio.block_ack
    # Who hears the frame leaves time for the answer, whether it comes or not (NAV).
    now.idle = end + radio.sifs + answer
    now.base = now.idle + radio.aifs
    link = station
    if station == now.hosts:
        link = receiver(cell, cell.window[station, 0].frame)
    loss = cell.stations[link].loss
    in_order = now.per_receiver and station < now.hosts
    good = np.int64(0)
    for place in range(its.sent):
        held = cell.window[station, place]
        if loss > 0 and uniform(now) < loss:
            held.came |= _MISSING
        else:
            cell.senders[good].frame = held.frame
            if in_order:
                cell.ordered[station, held.number % radio.window] = held.frame
            good += 1
    if good == 0:
        for place in range(its.sent):
            cell.window[station, place].came &= ~_MISSING
        now.busy += end - time
        note(cell, station, time, end, ERROR)
        count_failure(cell, station)
        back_off(cell, station, end + radio.timeout + radio.aifs)
        return
    now.busy += end - time + answer
    note(cell, station, time, now.idle, SUCCESS)
    its.failures = 0
    if aggregates(cell, station):
        take_arrived(cell, link)
    else:
        kept = np.int64(0)
        for place in range(its.held):
            held = cell.window[station, place]
            if place >= its.sent or held.came & _MISSING:
                held.tries += held.came >= _MISSING
                held.came &= ~_MISSING
                keep(cell, station, place, kept)
                kept += 1
        its.held = kept
    change_length(cell, station, -good)
    back_off(cell, station, now.base)
    alone = its.sent == 1
    if in_order:
        pass_on(cell, station, end, alone)
        return
    for place in range(good):
        deliver(cell, station, cell.senders[place].frame, end, alone)


@shared
def collide(cell, count, time):
    """Let several stations send at once: nothing arrives."""
    now, radio = cell.now[0], cell.radio[0]
    last = np.int64(0)
    for place in range(count):
        sender = cell.senders[place]
        sender.end = time + ppdu(cell, sender.station)
        last = max(last, sender.end)
    free = last
    if radio.heard > 0:
        # Who takes a collision for one frame with errors leaves time for an answer (EIFS).
        free = max(last, cell.senders[below(now, count)].end + radio.heard)
    now.idle = last
    now.base = free + radio.aifs
    now.collisions += 1
    now.collided += count
    now.busy += last - time
    now.wasted += last - time
    least = NEVER
    for place in range(count):
        sender = cell.senders[place]
        station, base = sender.station, last + radio.aifs
        its, held = cell.stations[station], cell.window[station, 0]
        note(cell, station, time, sender.end, COLLISION)
        if is_multicast(cell, station):
            # Nobody would have acknowledged it: the sender does not know.
            lose(cell, held.frame, station, AIR)
            its.held, its.failures = 0, 0
            change_length(cell, station, -1)
        else:
            count_failure(cell, station)
            base = max(sender.end + radio.timeout, last) + radio.aifs
        sender.slots, sender.base = draw(cell, station), base
        if its.length == 0 or base == now.base:
            wait(cell, station, base, sender.slots)
            sender.base = NEVER
        least = min(least, sender.base)
    if least == NEVER:
        return
    slot = first_to_send(cell, least)
    for place in range(count):
        sender = cell.senders[place]
        if sender.base < NEVER:
            if slot >= 0:
                enter(cell, sender.station, slot + radio.edca + sender.slots)
            else:
                wait(cell, sender.station, sender.base, sender.slots)


@njit
def add_sender(cell, station, time, count):
    """Add a station to those that send now unless all that it has is too old."""
    if load(cell, station, time):
        cell.senders[count].station = station
        return count + 1
    cell.stations[station].waits = 0
    return count


@njit
def transmit(cell, time, slot):
    """Let all send whose back-off ends now."""
    now = cell.now[0]
    count = np.int64(0)
    if slot >= 0:
        place = slot & (cell.wheel.size - 1)
        station = np.int64(cell.wheel[place])
        cell.wheel[place] = -1
        while station >= 0:
            now.waiting -= 1
            following = np.int64(cell.behind[station])
            count = add_sender(cell, station, time, count)
            station = following
    if time >= now.stray_time:
        now.stray_time = NEVER
        for place in range(now.strays):
            stray = cell.strays[place]
            if stray.station >= 0:
                if time >= stray.time:
                    count = add_sender(cell, stray.station, time, count)
                    stray.station = -1
                else:
                    now.stray_time = min(now.stray_time, stray.time)
    if count == 0:
        return
    synchronize(cell, time, slot)
    if count > 1:
        collide(cell, count, time)
        return
    station = cell.senders[0].station
    end = time + ppdu(cell, station)
    if cell.stations[station].sent == 0:
        send_request(cell, station, time, end)
    elif is_multicast(cell, station):
        send_multicast(cell, time, end)
    else:
        send_unicast(cell, station, time, end)


def _advance(digest):
    """Return the loop of a run, compiled from the sources with this digest."""

    @entry
    def advance(cell, until, reserve, share):
        """Go on with a run until it is over, wants more memory, or has done its share.

        Returns
        -------
        int
            `OVER`, `MEMORY` or `SHARE`.
        """
        if not digest:  # never; the digest makes other sources compile anew
            return OVER
        now, slot_ticks = cell.now[0], cell.radio[0].slot
        while share > 0:
            if now.open == 0 and now.coming == 0 and settled(cell):
                return OVER
            if now.spare < reserve or now.events + reserve > cell.events.size:
                return MEMORY
            time, slot = NEVER, np.int64(-1)
            if now.waiting > 0:
                slot = next_slot(cell)
                time = now.base + (slot - now.slot) * slot_ticks
            if now.stray_time < time:
                time, slot = now.stray_time, np.int64(-1)
            happens = now.events > 0 and cell.events[0].time <= time
            if happens:
                time = cell.events[0].time
            if time > until:
                return OVER
            sample(cell, time)
            now.clock = time
            if happens:
                happen(cell, time, next_event(cell))
            else:
                transmit(cell, time, slot)
            share -= 1
        return SHARE

    return advance


advance = _advance(sources())
