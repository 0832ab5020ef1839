"""Repair of losses by writers: Heartbeats over UDP, a timer for each pair over TCP."""

import numpy as np

from discostorm_simulation import state as st
from discostorm_simulation.kernels import primitives
from discostorm_simulation.kernels.channel_access import submit_frame
from discostorm_simulation.kernels.decorators import inlined, not_inlined
from discostorm_simulation.kernels.primitives import pack_frame
from discostorm_simulation.kernels.queues import messages_to

#: Bits of a word of `CellState.received_bitmap`.
WORD_BITS = 64


@not_inlined
def announcements_before(cell, source, to, row):
    """Return how many announcements a process sends to another from rows before ``row``."""
    total = np.int64(0)
    for before in range(row):
        if cell.kinds[before].role == st.DATA:
            total += messages_to(cell, source, to, before)
    return total


@not_inlined
def announcement_count(cell, source, to):
    """Return how many announcements a process sends to another."""
    return announcements_before(cell, source, to, cell.state[0].kinds)


@inlined
def has_received(cell, reader, writer, item):
    """Return whether a reader has received an announcement of a writer."""
    return (cell.received_bitmap[reader, writer, item // WORD_BITS] >> (item % WORD_BITS)) & 1


@inlined
def first_of_topic(cell, writer, reader, topic):
    """Return the index of a topic's first announcement; the previous topic ends before it."""
    return announcement_count(cell, writer, reader) * topic // max(cell.repairs[0].topics, 1)


@not_inlined
def send_messages(cell, row, source, to, time, flag):
    """Send all messages of a row for a pair of processes."""
    for item in range(messages_to(cell, source, to, row)):
        submit_frame(cell, pack_frame(row, source, to, item) | flag, time)


@not_inlined
def resend_announcement(cell, source, to, item, time, flag):
    """Send one announcement again, or on request for the first time."""
    place = item
    for row in range(cell.state[0].kinds):
        if cell.kinds[row].role == st.DATA:
            times = messages_to(cell, source, to, row)
            if 0 <= place < times:
                submit_frame(cell, pack_frame(row, source, to, place) | flag, time)
            place -= times


@inlined
def is_introduction(kind):
    """Return whether a row is what the server passes on at once: a process, not its endpoints."""
    return kind.role == st.DATA and kind.leg == st.PASSED_ON and kind.delay == 0


@not_inlined
def missing_introductions(cell, reader, writer):
    """Return how many introductions of a writer a reader has not received."""
    place, missing = np.int64(0), np.int64(0)
    for row in range(cell.state[0].kinds):
        if cell.kinds[row].role == st.DATA:
            end = place + messages_to(cell, writer, reader, row)
            for item in range(place, end if is_introduction(cell.kinds[row]) else place):
                missing += not has_received(cell, reader, writer, item)
            place = end
    return missing


@inlined
def is_relayed(cell, one, other):
    """Return whether two processes discover each other through a server."""
    server = cell.repairs[0].server
    return server > 0 and one != server and other != server


@not_inlined
def counts_for_convergence(cell, reader, writer):
    """Return whether convergence waits for this reader to have the writer's announcements."""
    if is_relayed(cell, reader, writer) and announcement_count(cell, writer, reader) == 0:
        return False
    of_server = cell.repairs[0].server > 0 and writer == cell.repairs[0].server
    return not (of_server or cell.processes[reader].mute)


@not_inlined
def update_completion(cell, reader, writer, time):
    """Record that a reader has all announcements of a writer, if it does."""
    state, pair = cell.state[0], cell.pairs[reader, writer]
    if pair.discovered and pair.missing == 0 and pair.completed_at == 0:
        pair.completed_at = max(time, 1)
        if not counts_for_convergence(cell, reader, writer):
            return
        state.finished += 1
        if state.finished > state.most:
            state.most, state.progress = state.finished, max(state.progress, time)
        if state.finished == state.pairs and state.converged == 0:
            state.converged = time


@not_inlined
def start_heartbeats(cell, writer, time):
    """Start a writer's Heartbeats, which end when all readers have acknowledged."""
    its, repairs = cell.processes[writer], cell.repairs[0]
    if repairs.topics > 0:
        its.heartbeat = repairs.heartbeat_period_initial
        if not its.heartbeat_active:
            its.heartbeat_active = 1
            primitives.schedule_event(cell, time + its.heartbeat, st.HEARTBEAT_DUE | writer)


@not_inlined
def heartbeat_row(cell, reader):
    """Return the row of the Heartbeats to a process."""
    server, found = cell.repairs[0].server, cell.repairs[0].heartbeat
    if server > 0:
        leg = np.int64(st.TO_SERVER) if reader == server else np.int64(st.FROM_SERVER)
        for row in range(cell.state[0].kinds):
            if cell.kinds[row].role == st.HEARTBEAT and cell.kinds[row].leg == leg:
                found = np.int64(row)
    return found


@not_inlined
def acknack_row(cell, heartbeat):
    """Return the row of the ACKNACKs that answer the Heartbeats of a row."""
    found = cell.repairs[0].acknack
    if cell.repairs[0].server > 0:
        for row in range(cell.state[0].kinds):
            if cell.kinds[row].role == st.ACKNACK and cell.kinds[row].answers == heartbeat:
                found = np.int64(row)
    return found


@inlined
def data_on_request(cell):
    """Return whether writers send announcements only on request, which a server does not."""
    return cell.repairs[0].preemptive_acknack_delay > 0 and cell.repairs[0].server == 0


@inlined
def counting_pair(cell, reader, writer):
    """Return the record that counts a reader's ACKNACKs for announcements of a writer."""
    if is_relayed(cell, reader, writer):
        return cell.pairs[reader, cell.repairs[0].server]
    return cell.pairs[reader, writer]


@inlined
def is_reader(cell, writer, reader):
    """Return whether a process has announced itself to another without a server in between."""
    pair = cell.pairs[writer, reader]
    return pair.discovered and pair.announced_at and not is_relayed(cell, writer, reader)


@not_inlined
def send_heartbeats(cell, writer, time):
    """Send Heartbeats until all readers have acknowledged; to all readers if data need requests."""
    its, repairs, lacking = cell.processes[writer], cell.repairs[0], np.int64(0)
    all_topics = (1 << repairs.topics) - 1
    for reader in range(cell.processes.size):
        if is_reader(cell, writer, reader):
            lacking |= ~cell.pairs[writer, reader].acknowledged
    for reader in range(cell.processes.size):
        due = lacking if data_on_request(cell) else ~cell.pairs[writer, reader].acknowledged
        if due & all_topics and is_reader(cell, writer, reader):
            for topic in range(repairs.topics):
                if (due >> topic) & 1:
                    send_heartbeat(cell, writer, reader, topic, time)
    its.heartbeat_active = (lacking & all_topics) != 0
    if its.heartbeat_active:
        its.heartbeat = min(2 * its.heartbeat, repairs.heartbeat_period_max)
        primitives.schedule_event(cell, time + its.heartbeat, st.HEARTBEAT_DUE | writer)


@not_inlined
def send_heartbeat(cell, writer, reader, topic, time):
    """Send a Heartbeat to a process, in addition to those sent on discovery."""
    frame = pack_frame(heartbeat_row(cell, reader), writer, reader, topic)
    submit_frame(cell, frame | st.REPAIR, time)


@not_inlined
def send_piggybacked_heartbeats(cell, writer, topic, time):
    """Piggyback Heartbeats to all readers on a frame's samples that find the send buffer full."""
    its, repairs = cell.processes[writer], cell.repairs[0]
    its.samples += repairs.samples
    while its.samples >= st.PARTS:
        its.samples -= st.PARTS
        its.used += its.sent  # each sample uses as many octets as the process has ever sent
        if its.used > repairs.send_buffer > 0:
            its.used = 0
            its.sent += repairs.heartbeat_octets
            for reader in range(cell.processes.size):
                if is_reader(cell, writer, reader):
                    send_heartbeat(cell, writer, reader, topic, time)


@not_inlined
def start_rto_timer(cell, source, to, time):
    """Start a connection's retransmission timer unless it runs."""
    pair = cell.pairs[source, to]
    if pair.rto == 0:
        pair.rto = cell.repairs[0].rto_first
    pair.expires_at = time + pair.rto
    if not pair.due:
        pair.due = 1
        primitives.schedule_pair_event(cell, pair.expires_at, st.RTO, source, to, 0)


@not_inlined
def on_rto(cell, source, to, time):
    """Resend the first missing announcement if the retransmission timer has really expired."""
    pair = cell.pairs[source, to]
    pair.due = 0
    announced = pair.announced_at and (pair.discovered or is_relayed(cell, source, to))
    if not announced or cell.pairs[to, source].missing == 0:
        return
    if pair.expires_at > time:
        pair.due = 1
        primitives.schedule_pair_event(cell, pair.expires_at, st.RTO, source, to, 0)
        return
    for item in range(announcement_count(cell, source, to)):
        if not has_received(cell, to, source, item):
            resend_announcement(cell, source, to, item, time, st.REPAIR)
            break
    pair.rto = min(2 * pair.rto, cell.repairs[0].rto_max)
    start_rto_timer(cell, source, to, time)


@inlined
def update_rto(cell, pair, sent_for):
    """Update the retransmission timeout by a round-trip time (RFC 6298, 2)."""
    repairs = cell.repairs[0]
    if pair.srtt == 0:
        pair.srtt, pair.rttvar = max(sent_for, 1), sent_for // 2
    else:
        pair.rttvar += (abs(pair.srtt - sent_for) - pair.rttvar) // 4
        pair.srtt += (sent_for - pair.srtt) // 8
    wanted = pair.srtt + 4 * pair.rttvar
    pair.rto = min(max(wanted, repairs.rto_min), repairs.rto_max)


@not_inlined
def on_tcp_ack(cell, source, to, place, frame, time):
    """Let the sender of an announcement handle its acknowledgement."""
    pair = cell.pairs[source, to]
    if frame & st.REPAIR:
        again = 0
        for item in range(place + 1, announcement_count(cell, source, to)):
            if again < 2 and not has_received(cell, to, source, item):
                resend_announcement(cell, source, to, item, time, st.REPAIR)
                again += 1
    else:
        update_rto(cell, pair, time - pair.announced_at)
    if cell.pairs[to, source].missing > 0:
        pair.expires_at = time + pair.rto
