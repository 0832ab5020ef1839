"""Repair over UDP: Heartbeats, ACKNACKs that name missing announcements, and resent data.

A reader answers a Heartbeat after a delay. A writer resends what the ACKNACK names, even if it has
arrived since. If a table has ``preemptive_acknack_delay``, a writer sends its
data only on request, and a reader asks for Heartbeats that do not come.
"""

import numpy as np

from discostorm_simulation import state as st
from discostorm_simulation.kernels import primitives, repair
from discostorm_simulation.kernels.channel_access import submit_frame
from discostorm_simulation.kernels.decorators import inlined, not_inlined
from discostorm_simulation.kernels.primitives import item_of, kind_of, pack_frame, source_of
from discostorm_simulation.kernels.queues import counting_process, messages_to

#: Items of an ACKNACK without news, and of an ACKNACK that asks for a Heartbeat.
EMPTY, PREEMPTIVE = np.int64(st.ITEMS), np.int64(1) << (st.ITEM_BITS - 1)
#: Announcements that a client can ask a server for at once: an ACKNACK names up to 256 (OMG
#: DDSI-RTPS 2.5, 9.4.2.6), and the server has a writer of publications and one of subscriptions.
MAX_ASKED = np.int64(2 * 256)
#: Bit of `PAIR`'s ``due`` for all that a server passes on, as its topic, and of ``heard`` if the
#: reader asks for Heartbeats of a process behind the server.
RELAYED = np.int64(31)
#: An ACKNACK's item: whether it is positive (1 bit), topic (6 bits), number modulo 64.
_TOPIC_SHIFT, _NUMBER_SHIFT, _SIX_BITS = np.int64(1), np.int64(7), np.int64(63)


@not_inlined
def answer_count(cell, row, process, source):
    """Return how many messages answer one message: on average, the ratio of the table's counts."""
    answered = cell.kinds[row].answers
    wanted = cell.each[counting_process(cell, process, source, row), row]
    heard = cell.each[counting_process(cell, source, process, answered), answered]
    if cell.kinds[answered].to_all:
        heard = cell.to_all[source, answered]
    before = cell.receivers_before[cell.kinds[row].set]
    if heard == 0 or before[source + 1] == before[source]:
        return np.int64(0)
    times = np.int64(wanted / heard)
    if times < wanted / heard:
        if cell.kinds[answered].tcp and cell.kinds[answered].to_unknown:
            # If two processes connect to each other, one opens the session: the one that started
            # first, or the one that already knows the session.
            one, other = cell.processes[process].start, cell.processes[source].start
            first = one < other or (one == other and process < source)
            return times + (first or cell.pairs[process, source].discovered > 0)
        times += primitives.draw_uniform(cell.state[0]) < wanted / heard - times
    return times


@not_inlined
def missing_relayed(cell, reader, writer):
    """Return how many announcements of a writer that the server has passed on a reader lacks."""
    pair = cell.pairs[writer, reader]
    if pair.announced_at == 0:
        return np.int64(0)
    if pair.served < 0:
        return np.int64(cell.pairs[reader, writer].missing)
    if cell.processes[reader].unintroduced == 0:
        return np.int64(0)
    return repair.missing_introductions(cell, reader, writer)


@not_inlined
def lacks_relayed(cell, reader):
    """Return whether a reader lacks anything that the server has passed on."""
    found = False
    for writer in range(cell.repairs[0].server):
        found = found or missing_relayed(cell, reader, writer) > 0
    return found


@not_inlined
def accept_relayed(cell, reader, number, time):
    """Let the server resend what a reader lacks of what it has passed on, from the first on."""
    asked = np.int64(0)
    for writer in range(cell.repairs[0].server):
        missing = missing_relayed(cell, reader, writer) if asked < MAX_ASKED else np.int64(0)
        if missing > 0:
            asked += missing
            note_number(cell.pairs[writer, reader], number)
            accept_request(cell, writer, reader, RELAYED, time)


@not_inlined
def answer_relayed(cell, writer, time):
    """Let the server resend a process's announcements to the readers that have asked for them."""
    cell.pairs[writer, writer].due &= ~(1 << RELAYED)
    for reader in range(cell.repairs[0].server):
        pair, place = cell.pairs[writer, reader], np.int64(0)
        if not (pair.due >> RELAYED) & 1:
            continue
        for row in range(cell.state[0].kinds):
            kind = cell.kinds[row]
            if kind.role == st.DATA:
                times = messages_to(cell, writer, reader, row)
                # The server has not passed on yet what it delays until an introduction.
                ready = kind.delay == 0 or pair.served < 0
                for item in range(times if ready else np.int64(0)):
                    if is_requested(cell, writer, reader, RELAYED, place + item):
                        submit_frame(cell, pack_frame(row, writer, reader, item) | st.REPAIR, time)
                place += times
        pair.due &= ~(1 << RELAYED)
        pair.asked_in *= pair.due > 0


@inlined
def note_number(pair, number):
    """Record the number of the first ACKNACK that waits for an answer."""
    pair.asked_in = number if pair.due == 0 else min(number, pair.asked_in)


@not_inlined
def accept_request(cell, writer, reader, topic, time):
    """Resend a topic's missing announcements, at once or together with other readers' requests."""
    delay, its = cell.repairs[0].nack_response_delay, cell.pairs[writer, writer]
    cell.pairs[writer, reader].due |= 1 << topic
    if delay == 0 and topic == RELAYED:
        answer_relayed(cell, writer, time)
    elif delay == 0:
        answer_requests(cell, writer, topic, reader, reader + 1, time)
    elif not (its.due >> topic) & 1:
        its.due |= 1 << topic
        primitives.schedule_pair_event(cell, time + delay, st.ANSWER_DUE, writer, writer, topic)


@inlined
def is_requested(cell, writer, reader, topic, item):
    """Return whether a reader that has asked for a topic lacked an announcement then."""
    pair = cell.pairs[writer, reader]
    if not ((pair.due >> topic) & 1 and pair.announced_at):
        return False
    if not repair.has_received(cell, reader, writer, item):
        return True
    if cell.repairs[0].nack_response_delay == 0:
        return False
    return cell.came_after[reader, writer, item] > pair.asked_in


@not_inlined
def is_in_topic(cell, writer, reader, topic, item):
    """Return whether an announcement to a reader is of a topic."""
    first = repair.first_of_topic(cell, writer, reader, topic)
    return first <= item < repair.first_of_topic(cell, writer, reader, topic + 1)


@not_inlined
def answer_requests(cell, writer, topic, first, end, time):
    """Resend a topic's announcements to the readers in a range that have requested them."""
    its, begin, most = cell.processes[writer], st.NEVER, np.int64(0)
    cell.pairs[writer, writer].due &= ~(1 << topic)
    for reader in range(first, end):
        if (cell.pairs[writer, reader].due >> topic) & 1:
            begin = min(begin, repair.first_of_topic(cell, writer, reader, topic))
            most = max(most, repair.first_of_topic(cell, writer, reader, topic + 1))
    for item in range(begin, most):
        sent, again = False, False
        for reader in range(first, end):
            within = end == first + 1 or is_in_topic(cell, writer, reader, topic, item)
            if within and is_requested(cell, writer, reader, topic, item):
                served = (cell.pairs[writer, reader].served >> topic) & 1
                sent, again = True, again or served > 0
                flag = st.REPAIR * served
                repair.resend_announcement(cell, writer, reader, item, time, flag)
        its.sent += sent * cell.repairs[0].data_octets
        if sent and (again or cell.repairs[0].riding):
            repair.send_piggybacked_heartbeats(cell, writer, topic, time)
    for reader in range(first, end):
        pair = cell.pairs[writer, reader]
        if (pair.due >> topic) & 1:
            pair.served |= 1 << topic
            pair.due &= ~(1 << topic)
            pair.asked_in *= pair.due > 0


@not_inlined
def receive_heartbeat(cell, frame, process, time):
    """Answer a Heartbeat after the reader's delay, unless an answer waits already."""
    source, topic = source_of(frame), item_of(frame) % cell.repairs[0].topics
    pair, delay = cell.pairs[process, source], cell.repairs[0].heartbeat_response_delay
    pair.heard |= 1 << topic
    if delay == 0 or repair.is_relayed(cell, process, source):
        send_acknack(cell, frame, process, time)
    elif not (pair.replying >> topic) & 1:
        pair.replying |= 1 << topic
        row = topic + 32 * (frame & st.REPAIR > 0)
        primitives.schedule_pair_event(cell, time + delay, st.ACKNACK_DUE, process, source, row)


@not_inlined
def receive_relayed_announcement(cell, frame, process, time):
    """Answer the Heartbeat that rides on what the server passes on; later ask for users' ones."""
    repairs, source = cell.repairs[0], source_of(frame)
    heartbeat = pack_frame(repair.heartbeat_row(cell, process), repairs.server, process, 0)
    receive_heartbeat(cell, heartbeat | st.REPAIR, process, time)
    pair, delayed = cell.pairs[process, source], cell.kinds[kind_of(frame)].delay > 0
    if delayed and repairs.preemptive_acknack_delay > 0 and not (pair.heard >> RELAYED) & 1:
        pair.heard |= 1 << RELAYED
        due = time + repairs.preemptive_acknack_delay
        primitives.schedule_pair_event(cell, due, st.PREEMPTIVE, process, source, 0)


@not_inlined
def send_delayed_acknack(cell, process, source, row, time):
    """Send a delayed ACKNACK."""
    topic = row & 31
    cell.pairs[process, source].replying &= ~(1 << topic)
    if cell.pairs[process, source].discovered:
        frame = pack_frame(repair.heartbeat_row(cell, process), source, process, topic)
        send_acknack(cell, frame | (row > 31) * st.REPAIR, process, time)


@not_inlined
def ask_for_heartbeats(cell, process, source, times, time):
    """Ask a writer for missing Heartbeats, repeatedly and at growing intervals."""
    repairs, pair, left = cell.repairs[0], cell.pairs[process, source], False
    if not pair.discovered:
        return
    for row in range(cell.state[0].kinds):
        answered = cell.kinds[row].answers
        if row == repairs.acknack and not repairs.server:
            for topic in range(repairs.topics):
                if not (pair.heard >> topic) & 1:
                    left = True
                    reply = pack_frame(row, process, source, (topic << _TOPIC_SHIFT) | PREEMPTIVE)
                    submit_frame(cell, reply | st.REPAIR, time)
            continue
        heard = answered < 0 or (pair.heard >> (32 + answered)) & 1
        if not heard and cell.kinds[answered].asked:
            for _ in range(max(messages_to(cell, source, process, answered), 1)):
                left = True
                submit_frame(cell, pack_frame(row, process, source, PREEMPTIVE) | st.REPAIR, time)
    if left:
        times = min(times + 1, 30)
        doubled = times * (repairs.preemptive_acknack_factor - 1)
        due = time + (repairs.preemptive_acknack_delay << doubled)
        primitives.schedule_pair_event(cell, due, st.PREEMPTIVE, process, source, times)


@not_inlined
def receive_liveliness(cell, frame, process, time):
    """Handle Heartbeats and ACKNACKs of writers without announcements, such as liveliness."""
    kind, source = kind_of(frame), source_of(frame)
    if cell.kinds[kind].asked and cell.pairs[process, source].discovered:
        cell.pairs[process, source].heard |= 1 << (32 + kind)
        for row in range(cell.state[0].kinds if frame & st.REPAIR else np.int64(0)):
            if cell.kinds[row].answers == kind:
                submit_frame(cell, pack_frame(row, process, source, 0) | st.REPAIR, time)
    unknown = repair.is_relayed(cell, process, source) and cell.pairs[process, source].missing
    if frame & st.REPAIR and item_of(frame) == PREEMPTIVE and not unknown:
        answered = pack_frame(cell.kinds[kind].answers, process, source, 0)
        submit_frame(cell, answered | st.REPAIR, time)


@not_inlined
def lacks_topic(cell, reader, writer, topic):
    """Return whether a reader lacks announcements of a topic."""
    first = repair.first_of_topic(cell, writer, reader, topic)
    for item in range(first, repair.first_of_topic(cell, writer, reader, topic + 1)):
        if not repair.has_received(cell, reader, writer, item):
            return True
    return False


@not_inlined
def send_acknack(cell, frame, process, time):
    """Answer a Heartbeat with ACKNACKs, as many as the table has, that report missing data."""
    repairs, source = cell.repairs[0], source_of(frame)
    topic, pair = item_of(frame) % repairs.topics, repair.counting_pair(cell, process, source)
    missing = lacks_topic(cell, process, source, topic)
    asked = repair.is_relayed(cell, process, source)
    if asked or (frame & st.REPAIR and source == repairs.server > 0):
        missing |= lacks_relayed(cell, process)
    pair.acknacks += 1
    row = repair.acknack_row(cell, kind_of(frame))
    item = (not missing) | (topic << _TOPIC_SHIFT)
    if cell.repairs[0].nack_response_delay > 0:
        item |= (pair.acknacks & _SIX_BITS) << _NUMBER_SHIFT
    submit_frame(cell, pack_frame(row, process, source, item) | (frame & st.REPAIR), time)
    if not frame & st.REPAIR:
        for _ in range(1, answer_count(cell, row, process, source)):
            submit_frame(cell, pack_frame(row, process, source, EMPTY), time)


@not_inlined
def receive_acknack(cell, frame, process, time):
    """Resend the announcements that a reader reports missing, or record that none is."""
    source, topic = source_of(frame), (item_of(frame) >> _TOPIC_SHIFT) & _SIX_BITS
    if item_of(frame) == EMPTY:
        return
    if item_of(frame) & PREEMPTIVE:
        repair.send_heartbeat(cell, process, source, topic, time)
        return
    sent = repair.counting_pair(cell, source, process).acknacks
    number = sent - ((sent - (item_of(frame) >> _NUMBER_SHIFT)) & _SIX_BITS)
    note_number(cell.pairs[process, source], number)
    server, relayed = cell.repairs[0].server, repair.is_relayed(cell, source, process)
    if server > 0 and (relayed or process == server):
        if not item_of(frame) & 1:
            accept_relayed(cell, source, number, time)
        if relayed or not frame & st.REPAIR or lacks_relayed(cell, source):
            return
    if item_of(frame) & 1:
        cell.pairs[process, source].acknowledged |= 1 << topic
        return
    accept_request(cell, process, source, topic, time)
