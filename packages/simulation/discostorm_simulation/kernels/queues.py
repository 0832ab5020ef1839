"""What waits: queues with a length and a lifetime, in which a burst is a single entry."""

import numpy as np

from discostorm_simulation import state as st
from discostorm_simulation.kernels.decorators import njit, shared
from discostorm_simulation.kernels.primitives import compose, destination_of, kind_of, source_of

#: An entry whose frame has been taken already.
_TAKEN = np.int64(2**62)
#: Most different bursts.
MAX_BURSTS = 256


@njit
def burst_entry(burst, frames):
    """Return the entry of so many frames of a burst."""
    return -1 - (frames * MAX_BURSTS + burst)


@njit
def frames_of(entry):
    """Return how many frames an entry stands for."""
    if entry < 0:
        return (-1 - entry) // MAX_BURSTS
    return np.int64(entry != _TAKEN)


@njit
def burst_of(entry):
    """Return which burst an entry stands for."""
    return (-1 - entry) % MAX_BURSTS


@njit
def is_steady(cell, burst):
    """Return whether a burst is one that comes again and again."""
    return cell.bursts[burst, cell.state[0].kinds] > 0


@njit
def receiver_count(cell, frame):
    """Return how many are to receive a frame."""
    kind = cell.kinds[kind_of(frame)]
    return cell.state[0].links if kind.multicast and kind.down else np.int64(1)


@njit
def source_host(cell, frame):
    """Return the host that a frame is from."""
    return cell.processes[source_of(frame)].host


@shared
def count_drop(cell, frame, station, cause):
    """Count a frame as lost for good."""
    if not frame & st.STEADY:
        cell.state[0].open -= 1
        count_lost_receptions(
            cell, receiver_count(cell, frame), source_host(cell, frame), station, cause
        )
    elif cell.kinds[kind_of(frame)].user:
        count_user_data_drop(cell, frame, receiver_count(cell, frame), station, cause)


@shared
def count_user_data_drop(cell, frame, times, station, cause):
    """Count receptions of user data that will not be, in the order of `result.CAUSES`."""
    place = st.LOSSES + cause + 3 * (station == cell.state[0].hosts)
    cell.delays[cell.kinds[kind_of(frame)].user - 1, place] += times


@shared
def count_lost_receptions(cell, times, source, station, cause):
    """Count receptions that will not be, by the host they come from and by cause."""
    state = cell.state[0]
    cell.stations[source].missed += times
    host = station < state.hosts
    if cause == st.QUEUE_FULL:
        if host:
            state.host_full += times
        else:
            state.ap_full += times
    elif cause == st.EXPIRED:
        if host:
            state.host_age += times
        else:
            state.ap_age += times
    elif cause == st.RETRY_LIMIT:
        if host:
            state.host_retry += times
        else:
            state.ap_retry += times
    else:
        state.on_air += times


@njit
def change_length(cell, station, frames):
    """Note that frames have come to a station or left it."""
    cell.stations[station].length += frames
    if station < cell.state[0].hosts:
        cell.state[0].queued += frames


@njit
def receiving_host(cell, frame):
    """Return the host that a frame goes to; of multicast the number of hosts."""
    if cell.kinds[kind_of(frame)].multicast:
        return cell.state[0].hosts
    return cell.processes[destination_of(frame)].host


@njit
def append(cell, station, entry, time):
    """Append an entry to a queue."""
    state, queue = cell.state[0], cell.stations[station]
    node = state.free
    waiting = cell.pool[node]
    state.free = waiting.next
    state.spare -= 1
    waiting.frame = entry
    waiting.came = time
    waiting.next = -1
    if queue.tail < 0:
        queue.head = node
    else:
        cell.pool[queue.tail].next = node
    queue.tail = node
    if state.per_receiver and station == state.hosts:
        # The access point finds the frames of one receiver without a search.
        to = cell.stations[receiving_host(cell, entry)]
        waiting.same, waiting.number, waiting.tries = -1, to.to_number, 0
        to.to_number += 1
        if to.to_tail < 0:
            to.to_head = node
        else:
            cell.pool[to.to_tail].same = node
        to.to_tail = node


@njit
def drop_head(cell, station):
    """Take the first entry off a queue."""
    state, queue = cell.state[0], cell.stations[station]
    node = queue.head
    queue.head = cell.pool[node].next
    if queue.head < 0:
        queue.tail = -1
    cell.pool[node].next = state.free
    state.free = node
    state.spare += 1


@njit
def dequeue_after(cell, host, node):
    """Take the access point's frame for a host that comes after another one, or after none."""
    to = cell.stations[host]
    taken = to.to_head if node < 0 else cell.pool[node].same
    following = cell.pool[taken].same
    if node < 0:
        to.to_head = following
    else:
        cell.pool[node].same = following
    if following < 0:
        to.to_tail = node
    cell.pool[taken].frame = _TAKEN


@njit
def dequeue_first_for(cell, host):
    """Take the access point's first frame for a host; its entry leaves the queue later."""
    dequeue_after(cell, host, np.int64(-1))


@shared
def oldest_entry(cell, station, time):
    """Return the first entry of a queue, after throwing out what is too old, or -1."""
    queue = cell.stations[station]
    while queue.head >= 0:
        waiting = cell.pool[queue.head]
        entry = waiting.frame
        if entry != _TAKEN:
            if time - waiting.came <= cell.radio[0].lifetime:
                return queue.head
            if cell.state[0].per_receiver and station == cell.state[0].hosts:
                dequeue_first_for(cell, receiving_host(cell, entry))
            change_length(cell, station, -frames_of(entry))
            if entry < 0:
                drop_burst(cell, station, entry)
            else:
                count_drop(cell, entry, station, st.EXPIRED)
        drop_head(cell, station)
    return np.int64(-1)


@shared
def drop_burst(cell, station, entry):
    """Count what is left of a burst as too old."""
    generator = cell.stations[station]
    left = frames_of(entry)
    multicast = frames_to_all(cell, station, burst_of(entry))
    if generator.begun:
        multicast -= generator.made
    multicast = min(max(multicast, 0), left)
    generator.begun = 0
    if not is_steady(cell, burst_of(entry)):
        cell.state[0].open -= left
        count_lost_receptions(
            cell, left + multicast * (cell.state[0].links - 1), station, station, st.EXPIRED
        )


@shared
def multicast_count(cell, source, kind):
    """Return how many of a message a process sends to all; see `cell_setup`."""
    wanted = cell.to_all[source, kind]
    if cell.kinds[kind].whole:
        return np.int64(wanted)
    return np.int64(np.floor(wanted + cell.part[source, kind]))


@njit
def receiver_rank(cell, source, to, kind):
    """Return how many processes on other hosts receive a message before one does."""
    here = cell.processes[source].host
    before = cell.receivers_before[cell.kinds[kind].set]
    if cell.processes[to].host < here:
        return before[to]
    first = cell.stations[here].first
    return before[to] - before[first + cell.stations[here].processes] + before[first]


@shared
def messages_to(cell, source, to, kind):
    """Return how many of a message a process sends to one on another host."""
    before = cell.receivers_before[cell.kinds[kind].set]
    if before[to + 1] == before[to]:
        return np.int64(0)
    wanted = cell.each[source, kind]
    if cell.kinds[kind].whole:
        return np.int64(wanted)
    place, part = receiver_rank(cell, source, to, kind), cell.part[source, kind]
    return np.int64(np.floor((place + 1) * wanted + part) - np.floor(place * wanted + part))


@shared
def unicast_count(cell, source, kind):
    """Return how many of a message a process sends to all its receivers together."""
    host = cell.processes[source].host
    before, first = cell.receivers_before[cell.kinds[kind].set], cell.stations[host].first
    own = before[first + cell.stations[host].processes] - before[first]
    wanted = (before[-1] - own) * cell.each[source, kind]
    if cell.kinds[kind].whole:
        return np.int64(wanted)
    return np.int64(np.floor(wanted + cell.part[source, kind]))


@shared
def frames_to_all(cell, host, burst):
    """Return how many frames, counted by process, a host sends in a burst."""
    total, its = np.int64(0), cell.stations[host]
    for kind in range(cell.state[0].kinds):
        if cell.kinds[kind].to_all and cell.bursts[burst, kind]:
            for process in range(its.first, its.first + its.processes):
                total += multicast_count(cell, process, kind)
    return total


@njit
def burst_frames(cell, host, burst):
    """Return how many frames a host sends in a burst."""
    total, its = np.int64(0), cell.stations[host]
    for kind in range(cell.state[0].kinds):
        if cell.bursts[burst, kind] and not cell.kinds[kind].to_all:
            for process in range(its.first, its.first + its.processes):
                total += unicast_count(cell, process, kind)
    return frames_to_all(cell, host, burst) + total


@njit
def host_after(cell, host, steps):
    """Return the host so many after one; the first follows the last."""
    other = host + steps
    return other if other < cell.state[0].hosts else other - cell.state[0].hosts


@njit
def next_destination(cell, host):
    """Return the process that the next frame of a burst is for; what is for all is for itself."""
    generator = cell.stations[host]
    if not generator.stage:
        return generator.first + generator.process
    return cell.stations[host_after(cell, host, generator.steps)].first + generator.there


@njit
def count_next(cell, host, burst):
    """Note how many frames of a burst there are of the row of the table that is next."""
    generator = cell.stations[host]
    kind, process = generator.kind, generator.first + generator.process
    generator.times, generator.number = 0, 0
    if cell.bursts[burst, kind] and cell.kinds[kind].to_all != generator.stage:
        if generator.stage:
            generator.number = messages_to(cell, process, next_destination(cell, host), kind)
        else:
            generator.number = multicast_count(cell, process, kind)


@njit
def repeats_last(generator):
    """Return whether the next frame of a burst is like the last but for its number."""
    # The number must not run over.
    return generator.begun and generator.times < generator.number and generator.times & st.ITEMS


@njit
def repeat_last(generator):
    """Return the next frame of a burst, which is like the last but for its number."""
    generator.times += 1
    generator.made += 1
    generator.last += st.NEXT_ITEM
    return generator.last


@njit
def next_frame(cell, host, burst):
    """Return the next frame of a burst; see `make_another`."""
    generator = cell.stations[host]
    if repeats_last(generator):
        return repeat_last(generator)
    generator.last = advance_frame(cell, host, burst)
    return generator.last


@shared
def advance_frame(cell, host, burst):
    """Return the next frame of a burst: those to all first, then for each process host by host."""
    generator, hosts, kinds = cell.stations[host], cell.state[0].hosts, cell.state[0].kinds
    if not generator.begun:
        generator.begun, generator.made, generator.stage = 1, 0, 0
        generator.process, generator.steps, generator.there, generator.kind = 0, 1, 0, 0
        count_next(cell, host, burst)
    while generator.times == generator.number:
        generator.kind += 1
        if generator.kind == kinds:
            generator.kind = 0
            if generator.stage:
                generator.there += 1
                if (
                    generator.there
                    == cell.stations[host_after(cell, host, generator.steps)].processes
                ):
                    generator.there = 0
                    generator.steps += 1
            if generator.steps == hosts or not generator.stage:
                generator.steps = 1
                generator.process += 1
                if generator.process == generator.processes:
                    generator.process = 0
                    generator.stage = 1
        count_next(cell, host, burst)
    frame = compose(
        generator.kind,
        generator.first + generator.process,
        next_destination(cell, host),
        generator.times,
    )
    generator.times += 1
    generator.made += 1
    return frame | st.STEADY if is_steady(cell, burst) else frame
