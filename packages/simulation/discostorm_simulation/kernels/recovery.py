"""What the middlewares do with what arrives: discovery, repair, leases.

Whoever learns of a process sends it what the table says answers an announcement, above all one
message for each of its own endpoints, an item. Over UDP a writer repeats Heartbeats to all
that have not acknowledged, a reader answers each with an ACKNACK, and what this says is
missing is sent again (OMG DDSI-RTPS 2.5, 8.4). Over TCP the sender repeats the first missing
item when its timer ends, doubles the timer, and goes on as in slow start (RFC 6298, 5681); the
acknowledgements of TCP travel for free. Who has not been heard of for a lease is forgotten
with all that it sent, and may be discovered again.
"""

import numpy as np

from discostorm_simulation.kernels.block_ack import give_up
from discostorm_simulation.kernels.channel_access import offer_burst, offer_new
from discostorm_simulation.kernels.decorators import njit, shared
from discostorm_simulation.kernels.primitives import (
    compose,
    item_of,
    kind_of,
    later,
    source_of,
    uniform,
)
from discostorm_simulation.kernels.queues import number, number_to_all
from discostorm_simulation.kernels.user_data import has_found, is_user_data, send_user_data
from discostorm_simulation.state import (
    ACKNACK,
    ANNOUNCE,
    ANSWER,
    BEAT,
    CLOCK,
    DATA,
    DISCOVERY,
    EXPIRE,
    FIRST,
    GIVE_UP,
    HEARTBEAT,
    ITEMS,
    LATER,
    OTHER,
    PROCESS_BITS,
    REPAIR,
    REPEAT,
    SEND,
    STEADY,
    TIMEOUT,
)

_MASK = (1 << PROCESS_BITS) - 1
_WORD = 64
#: Item of an acknowledgement that says nothing new.
EMPTY = np.int64(ITEMS)


@njit
def pair_event(what, one, other, row):
    """Return an event of one process about another and a row of the table."""
    return what | one | (other << PROCESS_BITS) | (row << (2 * PROCESS_BITS))


@shared
def first_of(cell, source, to, row):
    """Return how many items of the rows before one a process sends to another."""
    total = np.int64(0)
    for before in range(row):
        if cell.kinds[before].role == DATA:
            total += number(cell, source, to, before)
    return total


@shared
def items(cell, source, to):
    """Return how many items a process sends to another."""
    return first_of(cell, source, to, cell.now[0].kinds)


@njit
def has_item(cell, reader, writer, item):
    """Return whether an item of a writer has arrived at a reader."""
    return (cell.has[reader, writer, item // _WORD] >> (item % _WORD)) & 1


@njit
def first_item(cell, writer, reader, topic):
    """Return the first item of a topic; those of the next one begin where it ends."""
    return items(cell, writer, reader) * topic // max(cell.repairs[0].topics, 1)


@shared
def send_items(cell, row, source, to, time, flag):
    """Send all messages of a row for a pair of processes."""
    for item in range(number(cell, source, to, row)):
        offer_new(cell, compose(row, source, to, item) | flag, time)


@shared
def send_item(cell, source, to, item, time):
    """Send one item again."""
    place = item
    for row in range(cell.now[0].kinds):
        if cell.kinds[row].role == DATA:
            times = number(cell, source, to, row)
            if 0 <= place < times:
                offer_new(cell, compose(row, source, to, place) | REPAIR, time)
            place -= times


@shared
def complete(cell, reader, writer, time):
    """Note that a process may have all that it can know of another."""
    now, pair = cell.now[0], cell.pairs[reader, writer]
    if pair.known and pair.missing == 0 and pair.done == 0:
        pair.done = max(time, 1)
        now.finished += 1
        if now.finished == now.pairs and now.converged == 0:
            now.converged = time


@shared
def start_beating(cell, writer, time):
    """Let a writer send Heartbeats until all have acknowledged."""
    its, repairs = cell.processes[writer], cell.repairs[0]
    if repairs.topics > 0:
        its.heartbeat = repairs.heartbeat_period_initial
        if not its.beating:
            its.beating = 1
            later(cell, time + its.heartbeat, BEAT | writer)


@shared
def beat(cell, writer, time):
    """Send Heartbeats to all that have not acknowledged."""
    its, repairs = cell.processes[writer], cell.repairs[0]
    all_topics = (1 << repairs.topics) - 1
    waiting = False
    for reader in range(cell.processes.size):
        pair = cell.pairs[writer, reader]
        if pair.known and pair.offered and pair.acknowledged != all_topics:
            waiting = True
            for topic in range(repairs.topics):
                if not (pair.acknowledged >> topic) & 1:
                    frame = compose(repairs.heartbeat, writer, reader, topic)
                    offer_new(cell, frame | REPAIR, time)
    its.beating = waiting
    if waiting:
        its.heartbeat = min(2 * its.heartbeat, repairs.heartbeat_period_max)
        later(cell, time + its.heartbeat, BEAT | writer)


@shared
def arm(cell, source, to, time):
    """Start the timer of a connection unless it runs."""
    pair = cell.pairs[source, to]
    if pair.rto == 0:
        pair.rto = cell.repairs[0].rto_first
    pair.due = time + pair.rto
    if not pair.armed:
        pair.armed = 1
        later(cell, pair.due, pair_event(TIMEOUT, source, to, 0))


@shared
def end_timer(cell, source, to, time):
    """Send the first missing item again if the timer of a connection has really ended."""
    pair = cell.pairs[source, to]
    pair.armed = 0
    if not pair.offered or not pair.known or cell.pairs[to, source].missing == 0:
        return
    if pair.due > time:
        pair.armed = 1
        later(cell, pair.due, pair_event(TIMEOUT, source, to, 0))
        return
    for item in range(items(cell, source, to)):
        if not has_item(cell, to, source, item):
            send_item(cell, source, to, item, time)
            break
    pair.rto = min(2 * pair.rto, cell.repairs[0].rto_most)
    arm(cell, source, to, time)


@njit
def measure(cell, pair, sent_for):
    """Take a round trip into the timer (RFC 6298, 2)."""
    repairs = cell.repairs[0]
    if pair.round_trip == 0:
        pair.round_trip = max(sent_for, 1)
        pair.spread = sent_for // 2
    else:
        pair.spread += (abs(pair.round_trip - sent_for) - pair.spread) // 4
        pair.round_trip += (sent_for - pair.round_trip) // 8
    wanted = pair.round_trip + 4 * pair.spread
    pair.rto = min(max(wanted, repairs.rto_least), repairs.rto_most)


@shared
def acknowledge_tcp(cell, source, to, place, frame, time):
    """Let the sender of an item know that it has arrived."""
    pair = cell.pairs[source, to]
    if frame & REPAIR:
        again = 0
        for item in range(place + 1, items(cell, source, to)):
            if again < 2 and not has_item(cell, to, source, item):
                send_item(cell, source, to, item, time)
                again += 1
    else:
        measure(cell, pair, time - pair.offered)
    if cell.pairs[to, source].missing > 0:
        pair.due = time + pair.rto


@shared
def discover(cell, finder, found, time):
    """Let a process send what it has to one that it did not know."""
    now = cell.now[0]
    pair = cell.pairs[finder, found]
    pair.known = 1
    pair.heard, pair.offered, pair.acknowledged = time, max(time, 1), 0
    tcp = False
    for row in range(now.kinds):
        kind = cell.kinds[row]
        if kind.trigger == DISCOVERY:
            send_items(cell, row, finder, found, time, np.int64(0))
            tcp |= kind.tcp > 0 and kind.role == DATA
            if kind.gap_number > 0:
                what = pair_event(REPEAT, finder, found, row)
                for number in range(1, kind.gap_number + 1):
                    later(cell, time + number * kind.gap_first, what)
    if items(cell, finder, found) > 0:
        start_beating(cell, finder, time)
        if tcp:
            arm(cell, finder, found, time)
    complete(cell, finder, found, time)


@shared
def forget(cell, reader, writer, time):
    """Forget a process and all that it sent."""
    pair, its = cell.pairs[reader, writer], cell.pairs[writer, reader]
    if not pair.known:
        return
    if pair.done:
        cell.now[0].finished -= 1
    pair.known, pair.done, pair.offered = 0, 0, 0
    pair.missing = items(cell, writer, reader)
    for word in range(cell.has.shape[2]):
        cell.has[reader, writer, word] = 0
    cell.now[0].expired += 1
    # The new reader asks for everything: the writer's Heartbeats begin anew.
    its.acknowledged = 0
    if its.known and its.offered and its.acknowledged == 0:
        start_beating(cell, writer, time)


@shared
def expire(cell, reader, time):
    """Forget who has not been heard of for a lease; look again when the next may expire."""
    lease = cell.repairs[0].lease
    following = time + lease
    for writer in range(cell.processes.size):
        pair = cell.pairs[reader, writer]
        if pair.known:
            if pair.heard + lease <= time:
                forget(cell, reader, writer, time)
                if cell.repairs[0].topics == 0:  # the connection ends for both
                    forget(cell, writer, reader, time)
            else:
                following = min(following, pair.heard + lease)
    later(cell, following, EXPIRE | reader)


@shared
def send_by_clock(cell, host, batch, time):
    """Send what a host's processes send by the clock: to all, or to each that is known.

    User data go to those of whom everything is known, as a writer must have found the reader.
    """
    now, its = cell.now[0], cell.stations[host]
    flag = STEADY if cell.batches[batch, now.kinds] > 0 else np.int64(0)
    for process in range(its.first, its.first + its.processes):
        for row in range(now.kinds):
            kind = cell.kinds[row]
            if not cell.batches[batch, row] or kind.trigger != CLOCK:
                continue
            if kind.to_all and kind.user:
                send_user_data(cell, row, process, process, time)
                continue
            if kind.to_all:
                for item in range(number_to_all(cell, process, row)):
                    offer_new(cell, compose(row, process, process, item) | flag, time)
                continue
            for other in range(cell.processes.size):
                if kind.user:
                    if has_found(cell, process, other):
                        send_user_data(cell, row, process, other, time)
                elif cell.pairs[process, other].known or kind.to_unknown:
                    send_items(cell, row, process, other, time, flag)


@shared
def announce(cell, process, time):
    """Announce a process again whose table does not say when it does."""
    its, repairs = cell.processes[process], cell.repairs[0]
    for row in range(cell.now[0].kinds):
        kind = cell.kinds[row]
        if kind.to_all and kind.trigger == CLOCK:
            for item in range(number_to_all(cell, process, row)):
                offer_new(cell, compose(row, process, process, item) | STEADY, time)
    its.announce = min(2 * its.announce, repairs.announce_interval_max)
    later(cell, time + its.announce, ANNOUNCE | process)


@shared
def answers(cell, row, process, source):
    """Return how many messages of a row a process sends in answer to one of another's.

    On average as many as the table has of the one for each of the other.
    """
    answered = cell.kinds[row].answers
    wanted = cell.each[process, row]
    heard = cell.each[source, answered]
    if cell.kinds[answered].to_all:
        heard = cell.to_all[source, answered]
    before = cell.before[cell.kinds[row].set]
    if heard == 0 or before[source + 1] == before[source]:
        return np.int64(0)
    times = np.int64(wanted / heard)
    if times < wanted / heard:
        times += uniform(cell.now[0]) < wanted / heard - times
    return times


@shared
def answer(cell, frame, process, time):
    """Send what answers a message each time."""
    row, source = kind_of(frame), source_of(frame)
    for other in range(cell.now[0].kinds):
        kind = cell.kinds[other]
        if kind.trigger != ANSWER or kind.answers != row or kind.role == ACKNACK:
            continue
        early = time < cell.processes[source].start + kind.since
        if kind.when == (LATER if early else FIRST):
            continue
        for item in range(answers(cell, other, process, source)):
            reply = compose(other, process, source, item)
            offer_new(cell, reply | (frame & STEADY), time)


@shared
def acknowledge(cell, frame, process, time):
    """Answer a Heartbeat: whether something is missing; as often again as the table says."""
    repairs, source = cell.repairs[0], source_of(frame)
    topic = item_of(frame) % repairs.topics
    missing = False
    for item in range(
        first_item(cell, source, process, topic), first_item(cell, source, process, topic + 1)
    ):
        missing |= not has_item(cell, process, source, item)
    reply = compose(repairs.acknack, process, source, 2 * topic + (not missing))
    offer_new(cell, reply | (frame & REPAIR), time)
    if not frame & REPAIR:
        for _ in range(1, answers(cell, repairs.acknack, process, source)):
            offer_new(cell, compose(repairs.acknack, process, source, EMPTY), time)


@shared
def take_item(cell, frame, process, time):
    """Let a process take in an item of another."""
    row, source = kind_of(frame), source_of(frame)
    if item_of(frame) >= number(cell, source, process, row):  # of a multicast for others
        return
    place = first_of(cell, source, process, row) + item_of(frame)
    if not has_item(cell, process, source, place):
        cell.has[process, source, place // _WORD] |= np.int64(1) << (place % _WORD)
        cell.pairs[process, source].missing -= 1
        complete(cell, process, source, time)
    if cell.kinds[row].tcp:
        acknowledge_tcp(cell, source, process, place, frame, time)


@shared
def take_acknowledgement(cell, frame, process, time):
    """Send again what a reader says is missing, or note that nothing is."""
    source, topic = source_of(frame), item_of(frame) >> 1
    if item_of(frame) == EMPTY:
        return
    if item_of(frame) & 1:
        cell.pairs[process, source].acknowledged |= 1 << topic
        return
    for item in range(
        first_item(cell, process, source, topic), first_item(cell, process, source, topic + 1)
    ):
        if not has_item(cell, source, process, item):
            send_item(cell, process, source, item, time)


@shared
def hear(cell, frame, process, time):
    """Let a process learn of those that a message tells of."""
    kind, source = cell.kinds[kind_of(frame)], source_of(frame)
    first, last = source, source + 1
    if kind.of_host:
        its = cell.stations[cell.processes[source].host]
        first, last = its.first, its.first + its.processes
    for other in range(first, last):
        if kind.informs and not cell.pairs[process, other].known:
            discover(cell, process, other, time)
        cell.pairs[process, other].heard = time


@shared
def arrive(cell, frame, process, time):
    """Let a process take in a message."""
    kind, source = cell.kinds[kind_of(frame)], source_of(frame)
    its = cell.processes[process]
    if time < its.start or cell.processes[source].host == its.host:
        return
    hear(cell, frame, process, time)
    # What is not matched yet is not taken.
    if kind.role != OTHER and not cell.pairs[process, source].known:
        return
    if not frame & REPAIR:
        answer(cell, frame, process, time)
    if kind.role == DATA:
        take_item(cell, frame, process, time)
    elif kind.role == HEARTBEAT:
        acknowledge(cell, frame, process, time)
    elif kind.role == ACKNACK:
        take_acknowledgement(cell, frame, process, time)


@njit
def settled(cell):
    """Return whether everybody knows everybody, or need not.

    Beside user data a run without recovery lasts until its end is due.
    """
    now = cell.now[0]
    return now.converged > 0 if now.repairs else now.stamp == 0


@shared
def happen(cell, time, what):
    """Let happen what was to happen now."""
    kind, one = what & ~np.int64(2**56 - 1), what & _MASK
    other, row = (what >> PROCESS_BITS) & _MASK, (what >> (2 * PROCESS_BITS)) & 63
    if kind == SEND:
        period = cell.batches[other, cell.now[0].kinds]
        if period > 0:
            later(cell, time + period, what)
        else:
            cell.now[0].coming -= 1
        if cell.now[0].repairs or is_user_data(cell, other):
            send_by_clock(cell, one, other, time)
        else:
            offer_burst(cell, one, other, time)
    elif kind == ANNOUNCE:
        announce(cell, one, time)
    elif kind == BEAT:
        beat(cell, one, time)
    elif kind == EXPIRE:
        expire(cell, one, time)
    elif kind == TIMEOUT:
        end_timer(cell, one, other, time)
    elif kind == GIVE_UP:
        give_up(cell, one, time)
    elif cell.pairs[one, other].known:
        send_items(cell, row, one, other, time, STEADY)
