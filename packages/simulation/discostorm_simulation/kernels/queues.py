"""What waits to be sent: queues with a length and a lifetime, and bursts that are not written out.

A burst of many frames waits as one entry; its frames are made one after the other when it is
their turn.
"""

import numpy as np

from discostorm_simulation.kernels.decorators import njit, shared
from discostorm_simulation.kernels.primitives import compose, destination_of, kind_of, source_of
from discostorm_simulation.state import AGE, FULL, ITEMS, LOSSES, NEXT_ITEM, RETRY, STEADY

#: An entry whose frame has been taken already.
_TAKEN = np.int64(2**62)
#: Most different bursts.
BATCHES = 256


@njit
def burst_entry(batch, frames):
    """Return the entry of so many frames of a burst."""
    return -1 - (frames * BATCHES + batch)


@njit
def frames_of(entry):
    """Return how many frames an entry stands for."""
    if entry < 0:
        return (-1 - entry) // BATCHES
    return np.int64(entry != _TAKEN)


@njit
def batch_of(entry):
    """Return which burst an entry stands for."""
    return (-1 - entry) % BATCHES


@njit
def is_steady(cell, batch):
    """Return whether a burst is one that comes again and again."""
    return cell.batches[batch, cell.now[0].kinds] > 0


@njit
def receivers(cell, frame):
    """Return how many are to receive a frame."""
    kind = cell.kinds[kind_of(frame)]
    return cell.now[0].links if kind.multicast and kind.down else np.int64(1)


@njit
def host_of(cell, frame):
    """Return the host that a frame is from."""
    return cell.processes[source_of(frame)].host


@shared
def lose(cell, frame, station, cause):
    """Count a frame as lost for good."""
    if not frame & STEADY:
        cell.now[0].open -= 1
        count_lost(cell, receivers(cell, frame), host_of(cell, frame), station, cause)
    elif cell.kinds[kind_of(frame)].user:
        lose_user_data(cell, frame, receivers(cell, frame), station, cause)


@shared
def lose_user_data(cell, frame, times, station, cause):
    """Count receptions of user data that will not be, in the order of `result.CAUSES`."""
    place = LOSSES + cause + 3 * (station == cell.now[0].hosts)
    cell.delays[cell.kinds[kind_of(frame)].user - 1, place] += times


@shared
def count_lost(cell, times, source, station, cause):
    """Count receptions that will not be, by the host they come from and by cause."""
    now = cell.now[0]
    cell.stations[source].missed += times
    host = station < now.hosts
    if cause == FULL:
        if host:
            now.host_full += times
        else:
            now.ap_full += times
    elif cause == AGE:
        if host:
            now.host_age += times
        else:
            now.ap_age += times
    elif cause == RETRY:
        if host:
            now.host_retry += times
        else:
            now.ap_retry += times
    else:
        now.on_air += times


@njit
def change_length(cell, station, frames):
    """Note that frames have come to a station or left it."""
    cell.stations[station].length += frames
    if station < cell.now[0].hosts:
        cell.now[0].queued += frames


@njit
def receiver(cell, frame):
    """Return the host that a frame goes to; of multicast the number of hosts."""
    if cell.kinds[kind_of(frame)].multicast:
        return cell.now[0].hosts
    return cell.processes[destination_of(frame)].host


@njit
def put(cell, station, entry, time):
    """Append an entry to a queue."""
    now, queue = cell.now[0], cell.stations[station]
    node = now.free
    waiting = cell.pool[node]
    now.free = waiting.next
    now.spare -= 1
    waiting.frame = entry
    waiting.came = time
    waiting.next = -1
    if queue.tail < 0:
        queue.head = node
    else:
        cell.pool[queue.tail].next = node
    queue.tail = node
    if now.per_receiver and station == now.hosts:
        # The access point finds the frames of one receiver without a search.
        to = cell.stations[receiver(cell, entry)]
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
    now, queue = cell.now[0], cell.stations[station]
    node = queue.head
    queue.head = cell.pool[node].next
    if queue.head < 0:
        queue.tail = -1
    cell.pool[node].next = now.free
    now.free = node
    now.spare += 1


@njit
def take_after(cell, host, node):
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
def take_same(cell, host):
    """Take the access point's first frame for a host; its entry leaves the queue later."""
    take_after(cell, host, np.int64(-1))


@shared
def first_entry(cell, station, time):
    """Return the first entry of a queue, after throwing out what is too old, or -1."""
    queue = cell.stations[station]
    while queue.head >= 0:
        waiting = cell.pool[queue.head]
        entry = waiting.frame
        if entry != _TAKEN:
            if time - waiting.came <= cell.radio[0].lifetime:
                return queue.head
            if cell.now[0].per_receiver and station == cell.now[0].hosts:
                take_same(cell, receiver(cell, entry))
            change_length(cell, station, -frames_of(entry))
            if entry < 0:
                lose_burst(cell, station, entry)
            else:
                lose(cell, entry, station, AGE)
        drop_head(cell, station)
    return np.int64(-1)


@shared
def lose_burst(cell, station, entry):
    """Count what is left of a burst as too old."""
    maker = cell.stations[station]
    left = frames_of(entry)
    multicast = frames_to_all(cell, station, batch_of(entry))
    if maker.begun:
        multicast -= maker.made
    multicast = min(max(multicast, 0), left)
    maker.begun = 0
    if not is_steady(cell, batch_of(entry)):
        cell.now[0].open -= left
        count_lost(cell, left + multicast * (cell.now[0].links - 1), station, station, AGE)


@shared
def number_to_all(cell, source, kind):
    """Return how many of a message a process sends to all; see `cell_setup`."""
    wanted = cell.to_all[source, kind]
    if cell.kinds[kind].whole:
        return np.int64(wanted)
    return np.int64(np.floor(wanted + cell.part[source, kind]))


@njit
def rank(cell, source, to, kind):
    """Return how many processes on other hosts receive a message before one does."""
    here = cell.processes[source].host
    before = cell.before[cell.kinds[kind].set]
    if cell.processes[to].host < here:
        return before[to]
    first = cell.stations[here].first
    return before[to] - before[first + cell.stations[here].processes] + before[first]


@shared
def number(cell, source, to, kind):
    """Return how many of a message a process sends to one on another host."""
    before = cell.before[cell.kinds[kind].set]
    if before[to + 1] == before[to]:
        return np.int64(0)
    wanted = cell.each[source, kind]
    if cell.kinds[kind].whole:
        return np.int64(wanted)
    place, part = rank(cell, source, to, kind), cell.part[source, kind]
    return np.int64(np.floor((place + 1) * wanted + part) - np.floor(place * wanted + part))


@shared
def number_to_each(cell, source, kind):
    """Return how many of a message a process sends to all its receivers together."""
    host = cell.processes[source].host
    before, first = cell.before[cell.kinds[kind].set], cell.stations[host].first
    own = before[first + cell.stations[host].processes] - before[first]
    wanted = (before[-1] - own) * cell.each[source, kind]
    if cell.kinds[kind].whole:
        return np.int64(wanted)
    return np.int64(np.floor(wanted + cell.part[source, kind]))


@shared
def frames_to_all(cell, host, batch):
    """Return how many frames, counted by process, a host sends in a burst."""
    total, its = np.int64(0), cell.stations[host]
    for kind in range(cell.now[0].kinds):
        if cell.kinds[kind].to_all and cell.batches[batch, kind]:
            for process in range(its.first, its.first + its.processes):
                total += number_to_all(cell, process, kind)
    return total


@njit
def burst_frames(cell, host, batch):
    """Return how many frames a host sends in a burst."""
    total, its = np.int64(0), cell.stations[host]
    for kind in range(cell.now[0].kinds):
        if cell.batches[batch, kind] and not cell.kinds[kind].to_all:
            for process in range(its.first, its.first + its.processes):
                total += number_to_each(cell, process, kind)
    return frames_to_all(cell, host, batch) + total


@njit
def ahead(cell, host, steps):
    """Return the host so many after one; the first follows the last."""
    other = host + steps
    return other if other < cell.now[0].hosts else other - cell.now[0].hosts


@njit
def target(cell, host):
    """Return the process that the next frame of a burst is for; what is for all is for itself."""
    maker = cell.stations[host]
    if not maker.stage:
        return maker.first + maker.process
    return cell.stations[ahead(cell, host, maker.steps)].first + maker.there


@njit
def count_next(cell, host, batch):
    """Note how many frames of a burst there are of the row of the table that is next."""
    maker = cell.stations[host]
    kind, process = maker.kind, maker.first + maker.process
    maker.times, maker.number = 0, 0
    if cell.batches[batch, kind] and cell.kinds[kind].to_all != maker.stage:
        if maker.stage:
            maker.number = number(cell, process, target(cell, host), kind)
        else:
            maker.number = number_to_all(cell, process, kind)


@njit
def like_last(maker):
    """Return whether the next frame of a burst is like the last but for its number."""
    # The number must not run over.
    return maker.begun and maker.times < maker.number and maker.times & ITEMS


@njit
def make_like_last(maker):
    """Return the next frame of a burst, which is like the last but for its number."""
    maker.times += 1
    maker.made += 1
    maker.last += NEXT_ITEM
    return maker.last


@njit
def make(cell, host, batch):
    """Return the next frame of a burst; see `make_another`."""
    maker = cell.stations[host]
    if like_last(maker):
        return make_like_last(maker)
    maker.last = make_another(cell, host, batch)
    return maker.last


@shared
def make_another(cell, host, batch):
    """Return the next frame of a burst, like the last or not.

    First the messages to all of each process, then, for each process, what goes to each
    remote process, the next host first, in the order of the table.
    """
    maker, hosts, kinds = cell.stations[host], cell.now[0].hosts, cell.now[0].kinds
    if not maker.begun:
        maker.begun, maker.made, maker.stage = 1, 0, 0
        maker.process, maker.steps, maker.there, maker.kind = 0, 1, 0, 0
        count_next(cell, host, batch)
    while maker.times == maker.number:
        maker.kind += 1
        if maker.kind == kinds:
            maker.kind = 0
            if maker.stage:
                maker.there += 1
                if maker.there == cell.stations[ahead(cell, host, maker.steps)].processes:
                    maker.there = 0
                    maker.steps += 1
            if maker.steps == hosts or not maker.stage:
                maker.steps = 1
                maker.process += 1
                if maker.process == maker.processes:
                    maker.process = 0
                    maker.stage = 1
        count_next(cell, host, batch)
    frame = compose(maker.kind, maker.first + maker.process, target(cell, host), maker.times)
    maker.times += 1
    maker.made += 1
    return frame | STEADY if is_steady(cell, batch) else frame
