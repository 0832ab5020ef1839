"""The exchange of frames: how long it takes, what comes of it, and what a collision does.

What a station sends before its data, such as an RTS, would belong into `lengths`.
"""

import numpy as np

from discostorm_simulation.kernels.block_ack import action_arrived, action_failed, agreed
from discostorm_simulation.kernels.capture_effect import survivor
from discostorm_simulation.kernels.channel_access import (
    back_off,
    draw,
    enter,
    first_to_send,
    wait,
    wake,
)
from discostorm_simulation.kernels.decorators import njit, shared
from discostorm_simulation.kernels.delivery import (
    MISSING,
    aggregates,
    deliver,
    is_multicast,
    keep,
    pass_on,
    ppdu,
)
from discostorm_simulation.kernels.primitives import below, kind_of, uniform
from discostorm_simulation.kernels.queues import change_length, lose, receiver, take_after
from discostorm_simulation.state import (
    AIR,
    COLLISION,
    DOWN,
    ERROR,
    FAILED,
    NEVER,
    PARTS,
    RETRY,
    STEADY,
    SUCCESS,
    UP,
)


@njit
def lengths(cell, station):
    """Return how long a station sends: until its data end, and until nobody answers if others do.

    The two are the same, as a station begins with its data.
    """
    length = ppdu(cell, station)
    return length, length


@njit
def is_action(cell, station):
    """Return whether what a station sends is a request or response for an agreement."""
    its = cell.stations[station]
    return cell.now[0].cold and its.sent == 0 and not its.must_ask


@shared
def note(cell, station, start, end, outcome):
    """Record a transmission."""
    now, sent = cell.now[0], cell.stations[station].sent
    column = FAILED if outcome != SUCCESS else (UP if station < now.hosts else DOWN)
    # Beside user data requests go on when the burst is through.
    burst = sent == 0 and (now.stamp == 0 or now.open > 0)
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
        row.kind = -2 if is_action(cell, station) else -1
        if sent:
            row.kind = kind_of(cell.window[station, 0].frame)
        row.outcome = outcome


@shared
def give_up_single(cell, station):
    """Lose a frame without block acknowledgement that has failed too often, if it has."""
    now, its, held = cell.now[0], cell.stations[station], cell.window[station, 0]
    tries = cell.pool[held.number].tries if station == now.hosts else held.tries
    if tries < cell.radio[0].attempts or agreed(cell, station, held.frame):
        return
    lose(cell, held.frame, station, RETRY)
    change_length(cell, station, -1)
    if station == now.hosts:
        take_after(cell, receiver(cell, held.frame), np.int64(-1))
        return
    for place in range(1, its.held):
        keep(cell, station, place, place - 1)
    its.held -= 1


@njit
def count_failure(cell, station, time):
    """Note that nothing came back to a station."""
    now, radio, its = cell.now[0], cell.radio[0], cell.stations[station]
    # The counter of the station, QSRC, starts anew after the limit (10.23.2.2).
    its.failures = its.failures + 1 if its.failures < radio.attempts else 0
    if is_action(cell, station):
        action_failed(cell, station, time)
        return
    for place in range(its.sent):
        held = cell.window[station, place]
        if aggregates(cell, station):
            cell.pool[held.number].tries += 1
        else:
            held.tries += 1
    if its.sent > 1:
        its.must_ask = 1
    elif now.cold and its.sent:
        give_up_single(cell, station)
    # Under a block acknowledgement frames are repeated until they arrive or are too old.
    elif its.sent and radio.mpdus == 1 and cell.window[station, 0].tries >= radio.attempts:
        lose(cell, cell.window[station, 0].frame, station, RETRY)
        its.held = 0
        change_length(cell, station, -1)


@shared
def send_request(cell, station, time, end):
    """Let a station ask, undisturbed, what has arrived of an A-MPDU: nothing has."""
    now, radio, its = cell.now[0], cell.radio[0], cell.stations[station]
    now.idle = max(end + radio.sifs + radio.block_ack, now.others)
    now.base = now.idle + radio.aifs
    now.busy += end - time + radio.block_ack
    note(cell, station, time, now.idle, SUCCESS)
    its.must_ask, its.failures = 0, 0
    back_off(cell, station, now.base)


@shared
def send_action(cell, station, time, end):
    """Let a station send a request or response for an agreement, undisturbed."""
    now, radio = cell.now[0], cell.radio[0]
    now.idle = max(end + radio.sifs + radio.basic_ack, now.others)
    now.base = now.idle + radio.aifs
    now.busy += end - time + radio.basic_ack
    note(cell, station, time, now.idle, SUCCESS)
    cell.stations[station].failures = 0
    other = action_arrived(cell, station, now.idle)
    back_off(cell, station, now.base)
    if cell.stations[other].length > 0:
        wake(cell, other, end, False)


@shared
def take_arrived(cell, to):
    """Take what has arrived of the access point's last frames to a host off its queue."""
    station = cell.now[0].hosts
    last = np.int64(-1)
    for place in range(cell.stations[station].sent):
        held = cell.window[station, place]
        if held.came & MISSING:
            last = held.number
            cell.pool[last].tries += 1
        else:
            take_after(cell, to, last)


@shared
def send_multicast(cell, time, end):
    """Let the access point send to all at once; nobody acknowledges."""
    now = cell.now[0]
    station = now.hosts
    its, frame = cell.stations[station], cell.window[station, 0].frame
    now.idle = max(end, now.others)
    now.base = now.idle + cell.radio[0].aifs
    now.busy += end - time
    note(cell, station, time, end, SUCCESS)
    its.held, its.failures = 0, 0
    change_length(cell, station, -1)
    back_off(cell, station, now.base)
    deliver(cell, station, frame, end, its.sent == 1)


@njit
def send_unicast(cell, station, time, end):
    """Let a station send undisturbed to one receiver, which answers unless all is damaged."""
    now, radio, its = cell.now[0], cell.radio[0], cell.stations[station]
    answer = radio.ack if its.sent == 1 else radio.block_ack
    # Who hears the frame leaves time for the answer, whether it comes or not (NAV).
    now.idle = max(end + radio.sifs + answer, now.others)
    now.base = now.idle + radio.aifs
    link = station
    if station == now.hosts:
        link = receiver(cell, cell.window[station, 0].frame)
    loss = cell.stations[link].loss
    in_order = now.per_receiver and station < now.hosts
    good, damaged = np.int64(0), now.damaged
    for place in range(its.sent):
        held = cell.window[station, place]
        if place < damaged or (loss > 0 and uniform(now) < loss):
            held.came |= MISSING
        else:
            cell.senders[good].frame = held.frame
            if in_order:
                cell.ordered[station, held.number % radio.window] = held.frame
            good += 1
    if good == 0:
        for place in range(its.sent):
            cell.window[station, place].came &= ~MISSING
        now.busy += end - time
        note(cell, station, time, end, ERROR)
        count_failure(cell, station, end)
        back_off(cell, station, max(end + radio.timeout, now.others) + radio.aifs)
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
            if place >= its.sent or held.came & MISSING:
                held.tries += held.came >= MISSING
                held.came &= ~MISSING
                keep(cell, station, place, kept)
                kept += 1
        its.held = kept
    change_length(cell, station, -good)
    back_off(cell, station, now.base)
    alone = its.sent == 1 and now.others <= end
    if in_order:
        pass_on(cell, station, end, alone)
        return
    for place in range(good):
        deliver(cell, station, cell.senders[place].frame, end, alone)


@njit
def send(cell, station, time):
    """Let a station send undisturbed."""
    alone, _ = lengths(cell, station)
    if is_action(cell, station):
        send_action(cell, station, time, time + alone)
    elif cell.stations[station].sent == 0:
        send_request(cell, station, time, time + alone)
    elif is_multicast(cell, station):
        send_multicast(cell, time, time + alone)
    else:
        send_unicast(cell, station, time, time + alone)


@shared
def answer_to(cell, station, time):
    """Return when the answer to who is received in spite of others ends.

    And for how long others send when neither who is received nor the answer is on the air.
    """
    radio, its = cell.radio[0], cell.stations[station]
    end, _ = lengths(cell, station)
    end += time
    length, pause = radio.ack if its.sent == 1 else radio.block_ack, radio.sifs
    if is_action(cell, station):
        length = radio.basic_ack
    elif is_multicast(cell, station):
        length, pause = np.int64(0), np.int64(0)
    begun, others = end + pause, cell.now[0].others
    hidden = max(min(others, begun + length) - begun, 0)
    return begun + length, max(others - end, 0) - hidden


@shared
def collide(cell, count, time):
    """Let several stations send at once; return who is received in spite of the others, or -1.

    What becomes of its frame is left to `send`; of all others nothing arrives.
    """
    now, radio = cell.now[0], cell.radio[0]
    last = np.int64(0)
    for place in range(count):
        sender = cell.senders[place]
        _, together = lengths(cell, sender.station)
        sender.end = time + together
        last = max(last, sender.end)
    winner, answered, quiet, busy = np.int64(-1), last, last, last - time
    if now.unlike:
        winner = survivor(cell, count, time)
        if winner >= 0:
            now.others = last
            answered, busy = answer_to(cell, winner, time)
            quiet = max(last, answered)
    free = quiet
    if radio.heard > 0 and winner < 0:
        # Who takes a collision for one frame with errors leaves time for an answer (EIFS).
        free = max(last, cell.senders[below(now, count)].end + radio.heard)
    now.idle = quiet
    now.base = free + radio.aifs
    now.collisions += 1
    now.collided += count
    now.busy += busy
    now.wasted += busy
    least = NEVER
    for place in range(count):
        sender = cell.senders[place]
        station, base = sender.station, quiet + radio.aifs
        if station == winner:
            sender.base = NEVER
            continue
        its, held = cell.stations[station], cell.window[station, 0]
        note(cell, station, time, sender.end, COLLISION)
        if is_multicast(cell, station):
            # Nobody would have acknowledged it: the sender does not know.
            lose(cell, held.frame, station, AIR)
            its.held, its.failures = 0, 0
            change_length(cell, station, -1)
        else:
            count_failure(cell, station, last)
            # Who hears an answer to another one waits for its end, not for the own timeout.
            if winner < 0 or sender.end >= answered:
                base = max(sender.end + radio.timeout, quiet) + radio.aifs
        sender.slots, sender.base = draw(cell, station), base
        if its.length == 0 or base == now.base:
            wait(cell, station, base, sender.slots)
            sender.base = NEVER
        least = min(least, sender.base)
    if least == NEVER:
        return winner
    slot = first_to_send(cell, least) if winner < 0 else np.int64(-1)
    for place in range(count):
        sender = cell.senders[place]
        if sender.base < NEVER:
            if slot >= 0:
                enter(cell, sender.station, slot + radio.edca + sender.slots)
            else:
                wait(cell, sender.station, sender.base, sender.slots)
    return winner
