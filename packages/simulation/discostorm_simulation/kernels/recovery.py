"""What the middlewares do with what arrives: discovery, repair, leases.

Over UDP a writer repeats Heartbeats until all have acknowledged, and sends again what an ACKNACK
says is missing (OMG DDSI-RTPS 2.5, 8.4). Over TCP the first missing item is repeated when its timer
ends, with slow start (RFC 6298, 5681). Who is silent for a lease is forgotten, and found again.
"""

import numpy as np

from discostorm_simulation import state as st
from discostorm_simulation.kernels import primitives
from discostorm_simulation.kernels.block_ack import on_addba_timeout
from discostorm_simulation.kernels.channel_access import submit_burst, submit_frame
from discostorm_simulation.kernels.decorators import njit, shared
from discostorm_simulation.kernels.primitives import compose, item_of, kind_of, source_of
from discostorm_simulation.kernels.queues import messages_to, multicast_count
from discostorm_simulation.kernels.user_data import is_user_data, may_send_data, send_user_data

_MASK = (1 << st.PROCESS_BITS) - 1
_WORD = 64
#: Item of an acknowledgement that says nothing new.
EMPTY = np.int64(st.ITEMS)


@njit
def pair_event(what, one, other, row):
    """Return an event of one process about another and a row of the table."""
    return what | one | (other << st.PROCESS_BITS) | (row << (2 * st.PROCESS_BITS))


@shared
def announcements_before(cell, source, to, row):
    """Return how many items of the rows before one a process sends to another."""
    total = np.int64(0)
    for before in range(row):
        if cell.kinds[before].role == st.DATA:
            total += messages_to(cell, source, to, before)
    return total


@shared
def announcement_count(cell, source, to):
    """Return how many items a process sends to another."""
    return announcements_before(cell, source, to, cell.state[0].kinds)


@njit
def has_received(cell, reader, writer, item):
    """Return whether an item of a writer has arrived at a reader."""
    return (cell.received_bitmap[reader, writer, item // _WORD] >> (item % _WORD)) & 1


@njit
def first_of_topic(cell, writer, reader, topic):
    """Return the first item of a topic; those of the next one begin where it ends."""
    return announcement_count(cell, writer, reader) * topic // max(cell.repairs[0].topics, 1)


@shared
def send_messages(cell, row, source, to, time, flag):
    """Send all messages of a row for a pair of processes."""
    for item in range(messages_to(cell, source, to, row)):
        submit_frame(cell, compose(row, source, to, item) | flag, time)


@shared
def resend_announcement(cell, source, to, item, time):
    """Send one item again."""
    place = item
    for row in range(cell.state[0].kinds):
        if cell.kinds[row].role == st.DATA:
            times = messages_to(cell, source, to, row)
            if 0 <= place < times:
                submit_frame(cell, compose(row, source, to, place) | st.REPAIR, time)
            place -= times


@shared
def update_completion(cell, reader, writer, time):
    """Note that a process may have all that it can know of another."""
    state, pair = cell.state[0], cell.pairs[reader, writer]
    if pair.discovered and pair.missing == 0 and pair.completed_at == 0:
        pair.completed_at = max(time, 1)
        state.finished += 1
        if state.finished == state.pairs and state.converged == 0:
            state.converged = time


@shared
def start_heartbeats(cell, writer, time):
    """Let a writer send Heartbeats until all have acknowledged."""
    its, repairs = cell.processes[writer], cell.repairs[0]
    if repairs.topics > 0:
        its.heartbeat = repairs.heartbeat_period_initial
        if not its.heartbeat_active:
            its.heartbeat_active = 1
            primitives.schedule_event(cell, time + its.heartbeat, st.HEARTBEAT_DUE | writer)


@shared
def send_heartbeats(cell, writer, time):
    """Send Heartbeats to all that have not acknowledged."""
    its, repairs = cell.processes[writer], cell.repairs[0]
    all_topics = (1 << repairs.topics) - 1
    waiting = False
    for reader in range(cell.processes.size):
        pair = cell.pairs[writer, reader]
        if pair.discovered and pair.announced_at and pair.acknowledged != all_topics:
            waiting = True
            for topic in range(repairs.topics):
                if not (pair.acknowledged >> topic) & 1:
                    frame = compose(repairs.heartbeat, writer, reader, topic)
                    submit_frame(cell, frame | st.REPAIR, time)
    its.heartbeat_active = waiting
    if waiting:
        its.heartbeat = min(2 * its.heartbeat, repairs.heartbeat_period_max)
        primitives.schedule_event(cell, time + its.heartbeat, st.HEARTBEAT_DUE | writer)


@shared
def start_rto_timer(cell, source, to, time):
    """Start the timer of a connection unless it runs."""
    pair = cell.pairs[source, to]
    if pair.rto == 0:
        pair.rto = cell.repairs[0].rto_first
    pair.expires_at = time + pair.rto
    if not pair.timer_running:
        pair.timer_running = 1
        primitives.schedule_event(cell, pair.expires_at, pair_event(st.RTO, source, to, 0))


@shared
def on_rto(cell, source, to, time):
    """Send the first missing item again if the timer of a connection has really ended."""
    pair = cell.pairs[source, to]
    pair.timer_running = 0
    if not pair.announced_at or not pair.discovered or cell.pairs[to, source].missing == 0:
        return
    if pair.expires_at > time:
        pair.timer_running = 1
        primitives.schedule_event(cell, pair.expires_at, pair_event(st.RTO, source, to, 0))
        return
    for item in range(announcement_count(cell, source, to)):
        if not has_received(cell, to, source, item):
            resend_announcement(cell, source, to, item, time)
            break
    pair.rto = min(2 * pair.rto, cell.repairs[0].rto_max)
    start_rto_timer(cell, source, to, time)


@njit
def update_rto(cell, pair, sent_for):
    """Take a round trip into the timer (RFC 6298, 2)."""
    repairs = cell.repairs[0]
    if pair.srtt == 0:
        pair.srtt = max(sent_for, 1)
        pair.rttvar = sent_for // 2
    else:
        pair.rttvar += (abs(pair.srtt - sent_for) - pair.rttvar) // 4
        pair.srtt += (sent_for - pair.srtt) // 8
    wanted = pair.srtt + 4 * pair.rttvar
    pair.rto = min(max(wanted, repairs.rto_min), repairs.rto_max)


@shared
def on_tcp_ack(cell, source, to, place, frame, time):
    """Let the sender of an item know that it has arrived."""
    pair = cell.pairs[source, to]
    if frame & st.REPAIR:
        again = 0
        for item in range(place + 1, announcement_count(cell, source, to)):
            if again < 2 and not has_received(cell, to, source, item):
                resend_announcement(cell, source, to, item, time)
                again += 1
    else:
        update_rto(cell, pair, time - pair.announced_at)
    if cell.pairs[to, source].missing > 0:
        pair.expires_at = time + pair.rto


@shared
def discover(cell, finder, found, time):
    """Let a process send what it has to one that it did not know."""
    state = cell.state[0]
    pair = cell.pairs[finder, found]
    pair.discovered = 1
    pair.last_heard, pair.announced_at, pair.acknowledged = time, max(time, 1), 0
    tcp = False
    for row in range(state.kinds):
        kind = cell.kinds[row]
        if kind.trigger == st.DISCOVERY:
            send_messages(cell, row, finder, found, time, np.int64(0))
            tcp |= kind.tcp > 0 and kind.role == st.DATA
            if kind.gap_number > 0:
                what = pair_event(st.REPEAT, finder, found, row)
                for number in range(1, kind.gap_number + 1):
                    primitives.schedule_event(cell, time + number * kind.gap_first, what)
    if announcement_count(cell, finder, found) > 0:
        start_heartbeats(cell, finder, time)
        if tcp:
            start_rto_timer(cell, finder, found, time)
    update_completion(cell, finder, found, time)


@shared
def forget(cell, reader, writer, time):
    """Forget a process and all that it sent."""
    pair, its = cell.pairs[reader, writer], cell.pairs[writer, reader]
    if not pair.discovered:
        return
    if pair.completed_at:
        cell.state[0].finished -= 1
    pair.discovered, pair.completed_at, pair.announced_at = 0, 0, 0
    pair.missing = announcement_count(cell, writer, reader)
    for word in range(cell.received_bitmap.shape[2]):
        cell.received_bitmap[reader, writer, word] = 0
    cell.state[0].expired += 1
    # The new reader asks for everything: the writer's Heartbeats begin anew.
    its.acknowledged = 0
    if its.discovered and its.announced_at and its.acknowledged == 0:
        start_heartbeats(cell, writer, time)


@shared
def expire_leases(cell, reader, time):
    """Forget who has not been heard of for a lease; look again when the next may expire."""
    lease = cell.repairs[0].lease
    following = time + lease
    for writer in range(cell.processes.size):
        pair = cell.pairs[reader, writer]
        if pair.discovered:
            if pair.last_heard + lease <= time:
                forget(cell, reader, writer, time)
                if cell.repairs[0].topics == 0:  # the connection ends for both
                    forget(cell, writer, reader, time)
            else:
                following = min(following, pair.last_heard + lease)
    primitives.schedule_event(cell, following, st.LEASE_CHECK | reader)


@shared
def send_by_clock(cell, host, burst, time):
    """Send what a host's processes send by the clock: to all, or to each that is known."""
    state, its = cell.state[0], cell.stations[host]
    flag = st.STEADY if cell.bursts[burst, state.kinds] > 0 else np.int64(0)
    for process in range(its.first, its.first + its.processes):
        for row in range(state.kinds):
            kind = cell.kinds[row]
            if not cell.bursts[burst, row] or kind.trigger != st.CLOCK:
                continue
            if kind.to_all and kind.user:
                send_user_data(cell, row, process, process, time)
                continue
            if kind.to_all:
                for item in range(multicast_count(cell, process, row)):
                    submit_frame(cell, compose(row, process, process, item) | flag, time)
                continue
            for other in range(cell.processes.size):
                if kind.user:
                    if may_send_data(cell, process, other):
                        send_user_data(cell, row, process, other, time)
                elif cell.pairs[process, other].discovered or kind.to_unknown:
                    send_messages(cell, row, process, other, time, flag)


@shared
def announce_again(cell, process, time):
    """Announce a process again whose table does not say when it does."""
    its, repairs = cell.processes[process], cell.repairs[0]
    for row in range(cell.state[0].kinds):
        kind = cell.kinds[row]
        if kind.to_all and kind.trigger == st.CLOCK:
            for item in range(multicast_count(cell, process, row)):
                submit_frame(cell, compose(row, process, process, item) | st.STEADY, time)
    its.announce = min(2 * its.announce, repairs.announce_interval_max)
    primitives.schedule_event(cell, time + its.announce, st.ANNOUNCE | process)


@shared
def answer_count(cell, row, process, source):
    """Return how many messages answer one of another's: on average as the table's counts say."""
    answered = cell.kinds[row].answers
    wanted = cell.each[process, row]
    heard = cell.each[source, answered]
    if cell.kinds[answered].to_all:
        heard = cell.to_all[source, answered]
    before = cell.receivers_before[cell.kinds[row].set]
    if heard == 0 or before[source + 1] == before[source]:
        return np.int64(0)
    times = np.int64(wanted / heard)
    if times < wanted / heard:
        times += primitives.uniform(cell.state[0]) < wanted / heard - times
    return times


@shared
def send_answers(cell, frame, process, time):
    """Send what answers a message each time."""
    row, source = kind_of(frame), source_of(frame)
    for other in range(cell.state[0].kinds):
        kind = cell.kinds[other]
        if kind.trigger != st.ANSWER or kind.answers != row or kind.role == st.ACKNACK:
            continue
        early = time < cell.processes[source].start + kind.since
        if kind.when == (st.LATER if early else st.FIRST):
            continue
        for item in range(answer_count(cell, other, process, source)):
            reply = compose(other, process, source, item)
            submit_frame(cell, reply | (frame & st.STEADY), time)


@shared
def send_acknack(cell, frame, process, time):
    """Answer a Heartbeat: whether something is missing; as often again as the table says."""
    repairs, source = cell.repairs[0], source_of(frame)
    topic = item_of(frame) % repairs.topics
    missing = False
    for item in range(
        first_of_topic(cell, source, process, topic),
        first_of_topic(cell, source, process, topic + 1),
    ):
        missing |= not has_received(cell, process, source, item)
    reply = compose(repairs.acknack, process, source, 2 * topic + (not missing))
    submit_frame(cell, reply | (frame & st.REPAIR), time)
    if not frame & st.REPAIR:
        for _ in range(1, answer_count(cell, repairs.acknack, process, source)):
            submit_frame(cell, compose(repairs.acknack, process, source, EMPTY), time)


@shared
def receive_announcement(cell, frame, process, time):
    """Let a process take in an item of another."""
    row, source = kind_of(frame), source_of(frame)
    if item_of(frame) >= messages_to(cell, source, process, row):  # of a multicast for others
        return
    place = announcements_before(cell, source, process, row) + item_of(frame)
    if not has_received(cell, process, source, place):
        cell.received_bitmap[process, source, place // _WORD] |= np.int64(1) << (place % _WORD)
        cell.pairs[process, source].missing -= 1
        update_completion(cell, process, source, time)
    if cell.kinds[row].tcp:
        on_tcp_ack(cell, source, process, place, frame, time)


@shared
def receive_acknack(cell, frame, process, time):
    """Send again what a reader says is missing, or note that nothing is."""
    source, topic = source_of(frame), item_of(frame) >> 1
    if item_of(frame) == EMPTY:
        return
    if item_of(frame) & 1:
        cell.pairs[process, source].acknowledged |= 1 << topic
        return
    for item in range(
        first_of_topic(cell, process, source, topic),
        first_of_topic(cell, process, source, topic + 1),
    ):
        if not has_received(cell, source, process, item):
            resend_announcement(cell, process, source, item, time)


@shared
def refresh_lease(cell, frame, process, time):
    """Let a process learn of those that a message tells of."""
    kind, source = cell.kinds[kind_of(frame)], source_of(frame)
    first, last = source, source + 1
    if kind.of_host:
        its = cell.stations[cell.processes[source].host]
        first, last = its.first, its.first + its.processes
    for other in range(first, last):
        if kind.informs and not cell.pairs[process, other].discovered:
            discover(cell, process, other, time)
        cell.pairs[process, other].last_heard = time


@shared
def receive_message(cell, frame, process, time):
    """Let a process take in a message."""
    kind, source = cell.kinds[kind_of(frame)], source_of(frame)
    its = cell.processes[process]
    if time < its.start or cell.processes[source].host == its.host:
        return
    refresh_lease(cell, frame, process, time)
    # What is not matched yet is not taken.
    if kind.role != st.OTHER and not cell.pairs[process, source].discovered:
        return
    if not frame & st.REPAIR:
        send_answers(cell, frame, process, time)
    if kind.role == st.DATA:
        receive_announcement(cell, frame, process, time)
    elif kind.role == st.HEARTBEAT:
        send_acknack(cell, frame, process, time)
    elif kind.role == st.ACKNACK:
        receive_acknack(cell, frame, process, time)


@njit
def is_converged(cell):
    """Return whether all know all; without recovery only user data keep a run from its end."""
    state = cell.state[0]
    return state.converged > 0 if state.repairs else state.stamp == 0


@shared
def dispatch_event(cell, time, what):
    """Let happen what was to happen now."""
    kind, one = what & ~np.int64(2**56 - 1), what & _MASK
    other, row = (what >> st.PROCESS_BITS) & _MASK, (what >> (2 * st.PROCESS_BITS)) & 63
    if kind == st.SEND:
        period = cell.bursts[other, cell.state[0].kinds]
        if period > 0:
            primitives.schedule_event(cell, time + period, what)
        else:
            cell.state[0].coming -= 1
        if cell.state[0].repairs or is_user_data(cell, other):
            send_by_clock(cell, one, other, time)
        else:
            submit_burst(cell, one, other, time)
    elif kind == st.ANNOUNCE:
        announce_again(cell, one, time)
    elif kind == st.HEARTBEAT_DUE:
        send_heartbeats(cell, one, time)
    elif kind == st.LEASE_CHECK:
        expire_leases(cell, one, time)
    elif kind == st.RTO:
        on_rto(cell, one, other, time)
    elif kind == st.ADDBA_TIMEOUT:
        on_addba_timeout(cell, one, time)
    elif cell.pairs[one, other].discovered:
        send_messages(cell, row, one, other, time, st.STEADY)
