"""Handle the events of middleware: messages that arrive, schedules, timers, leases.

Over UDP a writer repeats Heartbeats until all readers have acknowledged, and resends what an
ACKNACK requests (OMG DDSI-RTPS 2.5, 8.4; see `acknacks`). Over TCP it resends the first
missing announcement when its timer expires, with slow start (RFC 6298, 5681). A process that is
silent for a lease is forgotten, and may be rediscovered.

A wired server is the last process, at the access point. It passes a process's announcements on once
it has all of them; over UDP its own Heartbeats cover all that it has passed on to a process.
"""

import numpy as np

from discostorm_simulation import state as st
from discostorm_simulation.kernels import acknacks, channel_access, primitives, repair
from discostorm_simulation.kernels.block_ack import on_addba_timeout
from discostorm_simulation.kernels.channel_access import submit_frame
from discostorm_simulation.kernels.decorators import not_inlined
from discostorm_simulation.kernels.primitives import item_of, kind_of, pack_frame, source_of
from discostorm_simulation.kernels.queues import messages_to, multicast_count
from discostorm_simulation.kernels.user_data import is_user_data, may_send_data, send_user_data


@not_inlined
def send_messages_on_discovery(cell, source, to, time, passed_on):
    """Send the messages due on discovery to a process: directly, or passed on by the server."""
    tcp, held_back = False, False
    pulled = repair.data_on_request(cell)
    for row in range(cell.state[0].kinds):
        kind = cell.kinds[row]
        asked_for = pulled and kind.role == st.DATA
        on_leg = (kind.leg == st.PASSED_ON) == passed_on
        if kind.trigger == st.DISCOVERY and on_leg and not asked_for:
            if kind.delay > 0:
                cell.state[0].coming += 1
                held_back |= passed_on and kind.role == st.DATA
                due = time + kind.delay
                primitives.schedule_pair_event(cell, due, st.DELAYED, source, to, row)
            else:
                repair.send_messages(cell, row, source, to, time, np.int64(0))
            tcp |= kind.tcp > 0 and kind.role == st.DATA
            for number in range(1, kind.gap_number + 1):
                due = time + number * kind.gap_first
                primitives.schedule_pair_event(cell, due, st.REPEAT, source, to, row)
    if repair.is_relayed(cell, source, to) and not passed_on:
        return
    pair = cell.pairs[source, to]
    pair.announced_at, pair.acknowledged = max(time, 1), 0
    pair.served = -1 + (pulled or held_back)
    if passed_on:
        cell.processes[to].unintroduced += repair.missing_introductions(cell, to, source)
    if repair.announcement_count(cell, source, to) > 0:
        writer = cell.repairs[0].server if passed_on else source
        cell.pairs[writer, to].acknowledged = 0
        repair.start_heartbeats(cell, writer, time)
        if tcp:
            repair.start_rto_timer(cell, source, to, time)


@not_inlined
def discover_process(cell, finder, found, time):
    """Let process ``finder`` discover ``found``, and send it all messages due on discovery."""
    pair = cell.pairs[finder, found]
    pair.discovered, pair.last_heard = 1, time
    send_messages_on_discovery(cell, finder, found, time, False)
    if repair.data_on_request(cell):
        due = time + cell.repairs[0].preemptive_acknack_delay
        primitives.schedule_pair_event(cell, due, st.PREEMPTIVE, finder, found, 0)
    repair.update_completion(cell, finder, found, time)


@not_inlined
def pass_announcements_on(cell, process, time):
    """Let the server pass a process's announcements to all others, and theirs to the process."""
    server = cell.repairs[0].server
    if not cell.pairs[server, process].discovered:
        return
    for other in range(server):
        if other == process or not cell.pairs[server, other].discovered:
            continue
        for source, to in ((process, other), (other, process)):
            complete = cell.pairs[server, source].completed_at > 0
            if complete and not cell.pairs[source, to].announced_at and not cell.processes[to].mute:
                send_messages_on_discovery(cell, source, to, time, True)


@not_inlined
def forget_process(cell, reader, writer, time):
    """Remove a process, and all its announcements, from a reader's records."""
    pair, its = cell.pairs[reader, writer], cell.pairs[writer, reader]
    if not pair.discovered:
        return
    if its.announced_at and repair.is_relayed(cell, reader, writer):
        cell.processes[reader].unintroduced -= repair.missing_introductions(cell, reader, writer)
    if pair.completed_at and repair.counts_for_convergence(cell, reader, writer):
        cell.state[0].finished -= 1
    pair.discovered, pair.completed_at, pair.announced_at, pair.heard = 0, 0, 0, 0
    cell.state[0].known += pair.missing
    pair.missing = repair.announcement_count(cell, writer, reader)
    cell.state[0].known -= pair.missing
    for word in range(cell.received_bitmap.shape[2]):
        cell.received_bitmap[reader, writer, word] = 0
    cell.state[0].expired += 1
    # The new reader asks for everything: the writer's Heartbeats begin anew.
    its.acknowledged = 0
    if its.discovered and its.announced_at:
        repair.start_heartbeats(cell, writer, time)


@not_inlined
def forget_through_server(cell, process, time):
    """Let all processes forget a process that the server forgot; over TCP, also the reverse."""
    for other in range(cell.repairs[0].server):
        if other != process:
            forget_process(cell, other, process, time)
            if cell.repairs[0].topics == 0:
                forget_process(cell, process, other, time)
            cell.pairs[process, other].announced_at = 0
            cell.pairs[other, process].announced_at = 0


@not_inlined
def expire_leases(cell, reader, time):
    """Forget processes that were silent for a lease, and schedule the next check."""
    lease = cell.repairs[0].lease
    following = time + lease
    for writer in range(cell.processes.size):
        pair = cell.pairs[reader, writer]
        if pair.discovered and not repair.is_relayed(cell, reader, writer):
            if pair.last_heard + lease <= time:
                forget_process(cell, reader, writer, time)
                if cell.repairs[0].topics == 0:  # the connection ends for both
                    forget_process(cell, writer, reader, time)
                if reader == cell.repairs[0].server > 0:
                    forget_through_server(cell, writer, time)
                elif cell.repairs[0].server > 0 and cell.repairs[0].topics == 0:
                    forget_through_server(cell, reader, time)
            else:
                following = min(following, pair.last_heard + lease)
    primitives.schedule_event(cell, following, st.LEASE_CHECK | reader)


@not_inlined
def send_scheduled_messages(cell, host, burst, time):
    """Send the scheduled messages of a host's processes: to all, or to each discovered process."""
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
                    submit_frame(cell, pack_frame(row, process, process, item) | flag, time)
                continue
            if kind.leg == st.FROM_SERVER:
                server = cell.repairs[0].server
                if cell.pairs[server, process].discovered:
                    repair.send_messages(cell, row, server, process, time, flag)
                continue
            for other in range(cell.processes.size):
                if kind.user:
                    if may_send_data(cell, process, other):
                        send_user_data(cell, row, process, other, time)
                elif cell.pairs[process, other].discovered or kind.to_unknown:
                    repair.send_messages(cell, row, process, other, time, flag)


@not_inlined
def repeat_announcements(cell, process, time):
    """Repeat the announcements of a process whose table has no schedule for repetitions."""
    its, repairs = cell.processes[process], cell.repairs[0]
    for row in range(cell.state[0].kinds):
        kind = cell.kinds[row]
        if kind.to_all and kind.trigger == st.CLOCK:
            for item in range(multicast_count(cell, process, row)):
                submit_frame(cell, pack_frame(row, process, process, item) | st.STEADY, time)
        elif kind.to_unknown:
            for other in range(cell.processes.size):
                if not cell.pairs[process, other].discovered:
                    repair.send_messages(cell, row, process, other, time, st.STEADY)
    its.announce = min(2 * its.announce, repairs.announce_interval_max)
    primitives.schedule_event(cell, time + its.announce, st.ANNOUNCE | process)


@not_inlined
def send_answers(cell, frame, process, time):
    """Send the messages that answer a received message."""
    row, source = kind_of(frame), source_of(frame)
    for other in range(cell.state[0].kinds):
        kind = cell.kinds[other]
        if kind.trigger != st.ANSWER or kind.answers != row or kind.role == st.ACKNACK:
            continue
        early = time < cell.processes[source].start + kind.since
        if kind.when == (st.LATER if early else st.FIRST):
            continue
        for item in range(acknacks.answer_count(cell, other, process, source)):
            reply = pack_frame(other, process, source, item)
            submit_frame(cell, reply | (frame & st.STEADY), time)


@not_inlined
def receive_announcement(cell, frame, process, time):
    """Record an announcement that a process receives from another."""
    state, row, source = cell.state[0], kind_of(frame), source_of(frame)
    if item_of(frame) >= messages_to(cell, source, process, row):  # of a multicast for others
        return
    place = repair.announcements_before(cell, source, process, row) + item_of(frame)
    if not repair.has_received(cell, process, source, place):
        cell.received_bitmap[process, source, place // repair.WORD_BITS] |= np.int64(1) << (
            place % repair.WORD_BITS
        )
        cell.pairs[process, source].missing -= 1
        if repair.is_introduction(cell.kinds[row]) and cell.pairs[source, process].announced_at:
            cell.processes[process].unintroduced -= 1
        state.known += 1
        # A record that is 1% above the last record is progress.
        if state.known > state.most_known + state.most_known // 100:
            state.most_known, state.progress = state.known, max(state.progress, time)
        if cell.repairs[0].nack_response_delay > 0:
            asked = repair.counting_pair(cell, process, source).acknacks
            cell.came_after[process, source, place] = asked + 1
        repair.update_completion(cell, process, source, time)
    if repair.data_on_request(cell) and not frame & st.REPAIR:
        # The table counts acknowledgements of first sendings.
        for topic in range(cell.repairs[0].topics):
            if not acknacks.lacks_topic(cell, process, source, topic):
                cell.pairs[source, process].acknowledged |= 1 << topic
    if repair.is_relayed(cell, process, source) and cell.repairs[0].topics > 0:
        acknacks.receive_relayed_announcement(cell, frame, process, time)
    if cell.kinds[row].tcp:
        repair.on_tcp_ack(cell, source, process, place, frame, time)


@not_inlined
def refresh_lease(cell, frame, process, time):
    """Restart the leases of the processes that a message introduces; discover new ones."""
    kind, source = cell.kinds[kind_of(frame)], source_of(frame)
    first, last, hearing, end = source, source + 1, process, process + 1
    if kind.of_host:
        its = cell.stations[cell.processes[source].host]
        first, last = its.first, its.first + its.processes
    if kind.to_host:
        its = cell.stations[cell.processes[process].host]
        hearing, end = its.first, its.first + its.processes
    for reader in range(hearing, end):
        for other in range(first, last):
            if kind.informs and not cell.pairs[reader, other].discovered:
                discover_process(cell, reader, other, time)
            cell.pairs[reader, other].last_heard = time


@not_inlined
def receive_message(cell, frame, process, time):
    """Handle a message that a process receives."""
    kind, source = cell.kinds[kind_of(frame)], source_of(frame)
    its = cell.processes[process]
    server, passed_on = cell.repairs[0].server, kind.leg == st.PASSED_ON
    if time < its.start or (cell.processes[source].host == its.host and not kind.leg):
        return
    if passed_on:
        if not cell.pairs[process, server].discovered:
            return
        cell.pairs[process, server].last_heard = time
    # A session opens before its messages are handled.
    opening = kind.role == st.OTHER and (kind.leg > 0 or kind.to_host > 0)
    if opening and not frame & st.REPAIR:
        send_answers(cell, frame, process, time)
    refresh_lease(cell, frame, server if kind.leg == st.BACK else process, time)
    # Ignore messages of endpoints that are not matched yet.
    through = passed_on or kind.leg == st.BACK
    if kind.role != st.OTHER and not (through or cell.pairs[process, source].discovered):
        return
    if not frame & st.REPAIR and not opening:
        send_answers(cell, frame, process, time)
    if kind.role == st.OTHER and cell.repairs[0].preemptive_acknack_delay > 0:
        acknacks.receive_liveliness(cell, frame, process, time)
    if kind.role == st.DATA:
        receive_announcement(cell, frame, process, time)
    elif kind.role == st.HEARTBEAT:
        acknacks.receive_heartbeat(cell, frame, process, time)
    elif kind.role == st.ACKNACK:
        acknacks.receive_acknack(cell, frame, process, time)
    if server > 0 and process == server and (kind.informs or kind.role == st.DATA):
        its = cell.stations[cell.processes[source].host]
        for other in range(its.first, its.first + its.processes):
            if other == source or kind.of_host:
                pass_announcements_on(cell, other, time)


@not_inlined
def dispatch_event(cell, time, what):
    """Dispatch the event that is due."""
    kind, one = what & ~np.int64(2**56 - 1), what & st.PROCESS_MASK
    other = (what >> st.PROCESS_BITS) & st.PROCESS_MASK
    row = (what >> (2 * st.PROCESS_BITS)) & st.KIND_MASK
    if kind == st.SEND:
        period = cell.bursts[other, cell.state[0].kinds]
        if period > 0:
            primitives.schedule_event(cell, time + period, what)
        else:
            cell.state[0].coming -= 1
        if cell.state[0].repairs or is_user_data(cell, other):
            send_scheduled_messages(cell, one, other, time)
        else:
            channel_access.submit_burst(cell, one, other, time)
    elif kind == st.ANNOUNCE:
        repeat_announcements(cell, one, time)
    elif kind == st.HEARTBEAT_DUE:
        repair.send_heartbeats(cell, one, time)
    elif kind == st.LEASE_CHECK:
        expire_leases(cell, one, time)
    elif kind == st.RTO:
        repair.on_rto(cell, one, other, time)
    elif kind == st.ADDBA_TIMEOUT:
        on_addba_timeout(cell, one, time)
    elif kind == st.WIRE:
        node = (what & (2**56 - 1)) >> st.PROCESS_BITS
        channel_access.queue_at_station(cell, one, channel_access.take_from_wire(cell, node), time)
    elif kind == st.ANSWER_DUE and row == acknacks.RELAYED:
        acknacks.answer_relayed(cell, one, time)
    elif kind == st.ANSWER_DUE:
        acknacks.answer_requests(cell, one, row, 0, cell.processes.size, time)
    elif kind == st.ACKNACK_DUE:
        acknacks.send_delayed_acknack(cell, one, other, row, time)
    elif kind == st.PREEMPTIVE:
        acknacks.ask_for_heartbeats(cell, one, other, row, time)
    elif kind == st.DELAYED:
        passed_on = cell.kinds[row].leg == st.PASSED_ON
        # A process acknowledges introductions in their order, so one holds back all that follows.
        if passed_on and cell.processes[other].unintroduced > 0:
            primitives.schedule_event(cell, time + cell.kinds[row].delay, what)
            return
        cell.state[0].coming -= 1
        if passed_on:
            # The reader may have acknowledged all that came before.
            server = cell.repairs[0].server
            cell.pairs[one, other].served, cell.pairs[server, other].acknowledged = -1, 0
            repair.start_heartbeats(cell, server, time)
        repair.send_messages(cell, row, one, other, time, np.int64(0))
    elif cell.pairs[one, other].discovered:
        repair.send_messages(cell, row, one, other, time, st.STEADY)
