"""Queues with a maximum length and lifetime; a whole burst is one entry."""

import numpy as np

from discostorm_simulation import state as st
from discostorm_simulation.kernels import primitives
from discostorm_simulation.kernels.decorators import inlined, not_inlined
from discostorm_simulation.kernels.primitives import kind_of

#: Mark of an entry whose frame was already removed.
_REMOVED = np.int64(2**62)
#: Maximum number of different bursts.
MAX_BURSTS = 256


@inlined
def burst_entry(burst, frames):
    """Pack a burst and its remaining frames into a queue entry."""
    return -1 - (frames * MAX_BURSTS + burst)


@inlined
def frames_in_entry(entry):
    """Return the number of frames in a queue entry."""
    if entry < 0:
        return (-1 - entry) // MAX_BURSTS
    return np.int64(entry != _REMOVED)


@inlined
def burst_in_entry(entry):
    """Return the burst of a queue entry."""
    return (-1 - entry) % MAX_BURSTS


@inlined
def is_periodic(cell, burst):
    """Return whether a burst is periodic."""
    return cell.bursts[burst, cell.state[0].kinds] > 0


@inlined
def receiver_count(cell, frame, station):
    """Return how many hosts should receive a frame that a station sends."""
    state, kind = cell.state[0], cell.kinds[kind_of(frame)]
    if not (kind.multicast and kind.down):
        return np.int64(1)
    if state.cells == 1 or station < state.hosts:
        return state.links
    own = cell.cell_of[source_host(cell, frame)] == cell.cell_of[station]
    return cell.channels[cell.cell_of[station]].hosts - own


@inlined
def source_host(cell, frame):
    """Return the host of a frame's source process."""
    return cell.processes[primitives.source_of(frame)].host


@not_inlined
def count_drop(cell, frame, station, cause):
    """Count the receptions that a dropped frame costs."""
    lost = receiver_count(cell, frame, station)
    if not frame & st.STEADY:
        cell.state[0].open -= 1
        count_lost_receptions(cell, lost, source_host(cell, frame), station, cause)
    elif cell.kinds[kind_of(frame)].user:
        count_user_data_drop(cell, frame, lost, station, cause)


@not_inlined
def count_user_data_drop(cell, frame, times, station, cause):
    """Count lost receptions of user data by cause, in the order of `result.CAUSES`."""
    place = st.LOSSES + cause + 3 * (station >= cell.state[0].hosts)
    cell.delays[cell.kinds[kind_of(frame)].user - 1, place] += times


@not_inlined
def count_lost_receptions(cell, times, source, station, cause):
    """Count lost receptions by source host and by cause."""
    state = cell.state[0]
    cell.stations[source].missed += times
    at_host = times * (station < state.hosts)
    if cause == st.QUEUE_FULL:
        state.host_full += at_host
        state.ap_full += times - at_host
    elif cause == st.EXPIRED:
        state.host_age += at_host
        state.ap_age += times - at_host
    elif cause == st.RETRY_LIMIT:
        state.host_retry += at_host
        state.ap_retry += times - at_host
    else:
        state.on_air += times


@inlined
def change_length(cell, station, frames):
    """Change a station's queue length by a number of frames."""
    cell.stations[station].length += frames
    if station < cell.state[0].hosts:
        cell.state[0].queued += frames


@inlined
def receiving_host(cell, frame):
    """Return the host that receives a frame; its access point stands for multicast."""
    if cell.kinds[kind_of(frame)].multicast:
        return primitives.access_point(cell.state[0])
    return cell.processes[primitives.destination_of(frame)].host


@inlined
def append_entry(cell, station, entry, time):
    """Append an entry to a queue."""
    state, queue = cell.state[0], cell.stations[station]
    node = state.free
    waiting = cell.pool[node]
    state.free = waiting.next
    state.spare -= 1
    waiting.frame, waiting.came, waiting.next = entry, time, -1
    if queue.tail < 0:
        queue.head = node
    else:
        cell.pool[queue.tail].next = node
    queue.tail = node
    if state.per_receiver and station >= state.hosts:
        # A list per receiver lets the access point find a receiver's frames without a search.
        to = cell.stations[receiving_host(cell, entry)]
        waiting.same, waiting.number, waiting.tries = -1, to.to_number, 0
        to.to_number += 1
        if to.to_tail < 0:
            to.to_head = node
        else:
            cell.pool[to.to_tail].same = node
        to.to_tail = node


@inlined
def drop_head(cell, station):
    """Remove the first entry of a queue."""
    state, queue = cell.state[0], cell.stations[station]
    node = queue.head
    queue.head = cell.pool[node].next
    if queue.head < 0:
        queue.tail = -1
    cell.pool[node].next, state.free = state.free, node
    state.spare += 1


@inlined
def dequeue_after(cell, host, node):
    """Remove the access point's frame to a host after ``node``; for -1, the host's first frame."""
    to = cell.stations[host]
    taken = to.to_head if node < 0 else cell.pool[node].same
    following = cell.pool[taken].same
    if node < 0:
        to.to_head = following
    else:
        cell.pool[node].same = following
    if following < 0:
        to.to_tail = node
    cell.pool[taken].frame = _REMOVED


@not_inlined
def oldest_entry(cell, station, time):
    """Drop a queue's expired entries; return the first entry that is left, or -1."""
    queue = cell.stations[station]
    while queue.head >= 0:
        waiting = cell.pool[queue.head]
        entry = waiting.frame
        if entry != _REMOVED:
            if time - waiting.came <= cell.radio[0].lifetime:
                return queue.head
            if cell.state[0].per_receiver and station >= cell.state[0].hosts:
                dequeue_after(cell, receiving_host(cell, entry), np.int64(-1))
            change_length(cell, station, -frames_in_entry(entry))
            if entry < 0:
                drop_burst(cell, station, entry)
            else:
                count_drop(cell, entry, station, st.EXPIRED)
        drop_head(cell, station)
    return np.int64(-1)


@not_inlined
def drop_burst(cell, station, entry):
    """Count the remaining frames of a burst as expired."""
    generator = cell.stations[station]
    left = frames_in_entry(entry)
    multicast = frames_to_all(cell, station, burst_in_entry(entry))
    if generator.begun:
        multicast -= generator.made
    multicast = min(max(multicast, 0), left)
    generator.begun = 0
    if not is_periodic(cell, burst_in_entry(entry)):
        cell.state[0].open -= left
        lost = left + multicast * (cell.state[0].links - 1)
        count_lost_receptions(cell, lost, station, station, st.EXPIRED)


@not_inlined
def multicast_count(cell, source, kind):
    """Return how many messages of a row a process sends to all; see `cell_setup`."""
    return np.int64(np.floor(cell.to_all[source, kind] + cell.part[source, kind]))


@inlined
def receiver_rank(cell, source, to, kind):
    """Return how many processes on other hosts receive a message before process ``to``."""
    here = cell.processes[source].host
    before = cell.receivers_before[cell.kinds[kind].set]
    if cell.processes[to].host < here:
        return before[to]
    first = cell.stations[here].first
    return before[to] - before[first + cell.stations[here].processes] + before[first]


@inlined
def counting_process(cell, source, to, kind):
    """Return the process whose counts apply to a message from one process to another."""
    return to if cell.kinds[kind].leg == st.FROM_SERVER else source


@not_inlined
def messages_to(cell, source, to, kind):
    """Return how many messages of a row a process sends to a process on another host."""
    before = cell.receivers_before[cell.kinds[kind].set]
    at_home = cell.kinds[kind].to_host and cell.processes[source].host == cell.processes[to].host
    if before[to + 1] == before[to] or at_home:
        return np.int64(0)
    if cell.kinds[kind].leg == st.FROM_SERVER and source != cell.repairs[0].server:
        return np.int64(0)
    wanted = cell.each[counting_process(cell, source, to, kind), kind]
    if cell.kinds[kind].whole:
        return np.int64(wanted)
    place, part = receiver_rank(cell, source, to, kind), cell.part[source, kind]
    return np.int64(np.floor((place + 1) * wanted + part) - np.floor(place * wanted + part))


@not_inlined
def frames_to_all(cell, host, burst):
    """Return how many multicast frames all processes of a host send in a burst."""
    total, its = np.int64(0), cell.stations[host]
    for kind in range(cell.state[0].kinds):
        if cell.kinds[kind].to_all and cell.bursts[burst, kind]:
            for process in range(its.first, its.first + its.processes):
                total += multicast_count(cell, process, kind)
    return total


@inlined
def frames_of_burst(cell, host, burst):
    """Return how many frames a host sends in a burst: to all, and to each receiver elsewhere."""
    total, its = frames_to_all(cell, host, burst), cell.stations[host]
    for kind in range(cell.state[0].kinds):
        if cell.bursts[burst, kind] and not cell.kinds[kind].to_all:
            before = cell.receivers_before[cell.kinds[kind].set]
            remote = before[-1] - before[its.first + its.processes] + before[its.first]
            for process in range(its.first, its.first + its.processes):
                wanted = remote * cell.each[process, kind]
                total += np.int64(np.floor(wanted + cell.part[process, kind]))
    return total


@inlined
def host_after(cell, host, steps):
    """Return the host ``steps`` after this one; the first host follows the last."""
    return (host + steps) % cell.state[0].hosts


@inlined
def next_destination(cell, host):
    """Return the destination process of a burst's next frame; the source itself stands for all."""
    generator = cell.stations[host]
    if not generator.stage:
        return generator.first + generator.process
    return cell.stations[host_after(cell, host, generator.steps)].first + generator.there


@inlined
def count_frames_of_row(cell, host, burst):
    """Count the frames of a burst for its next row and destination."""
    generator = cell.stations[host]
    kind, process = generator.kind, generator.first + generator.process
    generator.times, generator.number = 0, 0
    if cell.bursts[burst, kind] and cell.kinds[kind].to_all != generator.stage:
        if generator.stage:
            generator.number = messages_to(cell, process, next_destination(cell, host), kind)
        else:
            generator.number = multicast_count(cell, process, kind)


@inlined
def next_frame(cell, host, burst):
    """Return a burst's next frame: the last with the next item number, or a computed one."""
    generator = cell.stations[host]
    # The item number must not overflow.
    if generator.begun and generator.times < generator.number and generator.times & st.ITEMS:
        generator.times += 1
        generator.made += 1
        generator.last += st.NEXT_ITEM
    else:
        generator.last = compute_next_frame(cell, host, burst)
    return generator.last


@not_inlined
def compute_next_frame(cell, host, burst):
    """Compute a burst's next frame: multicast frames first, then unicast frames host by host."""
    generator, hosts, kinds = cell.stations[host], cell.state[0].hosts, cell.state[0].kinds
    if not generator.begun:
        generator.begun, generator.made, generator.stage = 1, 0, 0
        generator.process, generator.steps, generator.there, generator.kind = 0, 1, 0, 0
        count_frames_of_row(cell, host, burst)
    while generator.times == generator.number:
        generator.kind += 1
        if generator.kind == kinds:
            generator.kind = 0
            if generator.stage:
                generator.there += 1
                other = cell.stations[host_after(cell, host, generator.steps)]
                if generator.there == other.processes:
                    generator.there = 0
                    generator.steps += 1
            if generator.steps == hosts or not generator.stage:
                generator.steps = 1
                generator.process += 1
                if generator.process == generator.processes:
                    generator.process = 0
                    generator.stage = 1
        count_frames_of_row(cell, host, burst)
    process, to = generator.first + generator.process, next_destination(cell, host)
    frame = primitives.pack_frame(generator.kind, process, to, generator.times)
    generator.times += 1
    generator.made += 1
    return frame | st.STEADY if is_periodic(cell, burst) else frame
