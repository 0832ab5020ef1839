"""Channel access: contention by IEEE Std 802.11-2020, 10.3 and 10.23.2 (EDCA, one category).

Stations wait in a timing wheel at their sending slot, so the cost of a transmission does not grow
with their number. After a collision they wait outside the wheel until the next transmission.
"""

import numpy as np

from discostorm_simulation import state as st
from discostorm_simulation.kernels import primitives, queues
from discostorm_simulation.kernels.decorators import inlined, not_inlined


@inlined
def enter_backoff_wheel(cell, station, slot):
    """Insert a station into the timing wheel at its sending slot."""
    state, its = cell.state[0], cell.stations[station]
    wheel = cell.wheel[state.here]
    place = slot & (wheel.size - 1)
    its.send_slot, its.waits = slot, 1
    cell.behind[station] = wheel[place]
    wheel[place] = station
    state.waiting += 1
    state.ahead = min(state.ahead, slot)


@inlined
def draw_backoff(cell, station):
    """Draw a back-off for a station [slots]."""
    radio = cell.radio[0]
    doubled = (radio.cw_min + 1) << min(cell.stations[station].failures, 20)
    return primitives.draw_below(cell.state[0], min(doubled, radio.cw_max + 1))


@inlined
def start_backoff(cell, station, base, slots):
    """Start a back-off of ``slots`` slots, counted from the tick ``base``."""
    state, its = cell.state[0], cell.stations[station]
    if its.length == 0:
        its.send_slot, its.waits = state.slot + slots, 0
    elif base == state.base:
        enter_backoff_wheel(cell, station, state.slot + slots)
    else:
        waiting_station = cell.deferred[state.here, state.deferred]
        state.deferred += 1
        waiting_station.station, waiting_station.base, waiting_station.left = station, base, slots
        waiting_station.time = base + slots * cell.radio[0].slot
        state.deferred_time = min(state.deferred_time, waiting_station.time)
        its.waits = 1


@inlined
def back_off(cell, station, base):
    """Draw a station's back-off after a transmission, and start the back-off."""
    start_backoff(cell, station, base, draw_backoff(cell, station))


@inlined
def request_access(cell, station, time, busy):
    """Let a station with a frame contend for the channel; a running back-off continues."""
    state, its = cell.state[0], cell.stations[station]
    if its.waits:
        return
    slot = state.slot
    if busy:
        if its.send_slot <= slot:
            slot += draw_backoff(cell, station)
    elif time >= state.base:
        slots = (time - state.base) // cell.radio[0].slot + 1
        if state.waiting == 0 and state.deferred == 0:
            state.base += slots * cell.radio[0].slot
            state.slot += slots
            state.ahead = state.slot
        slot += slots
    enter_backoff_wheel(cell, station, max(its.send_slot, slot))


@inlined
def next_slot(cell):
    """Return the next slot in which a station of the wheel sends."""
    state = cell.state[0]
    slot, wheel = state.ahead, cell.wheel[state.here]
    while wheel[slot & (wheel.size - 1)] < 0:
        slot += 1
    state.ahead = slot
    return slot


@not_inlined
def enter_cell(cell, number):
    """Make a cell the current one: its channel and its radio."""
    state = cell.state[0]
    if number == state.here:
        return
    left, entered = cell.channels[state.here], cell.channels[number]
    left.base, left.slot, left.idle, left.ahead = state.base, state.slot, state.idle, state.ahead
    left.waiting, left.deferred = state.waiting, state.deferred
    left.deferred_time, left.next = state.deferred_time, state.deferred_time
    if state.waiting > 0:
        time = state.base + (next_slot(cell) - state.slot) * cell.radio[0].slot
        left.ahead, left.next = state.ahead, min(time, left.next)
    state.here = number
    state.base, state.slot, state.idle = entered.base, entered.slot, entered.idle
    state.ahead, state.waiting, state.deferred = entered.ahead, entered.waiting, entered.deferred
    state.deferred_time = entered.deferred_time
    state.per_receiver, state.cold = entered.per_receiver, entered.cold
    state.rows_at = number * state.kinds
    cell.radio[0] = cell.radio[1 + number]


@not_inlined
def enter_earliest_cell(cell):
    """Make the cell that transmits next the current one."""
    state = cell.state[0]
    first, time = state.here, state.deferred_time
    if state.waiting > 0:
        slots = next_slot(cell) - state.slot
        time = min(time, state.base + slots * cell.radio[0].slot)
    for number in range(state.cells):
        if number != state.here and cell.channels[number].next < time:
            first, time = np.int64(number), cell.channels[number].next
    enter_cell(cell, first)


@inlined
def next_slot_before(cell, base):
    """Return the slot of the next transmission if it certainly starts before ``base``, else -1."""
    state, radio = cell.state[0], cell.radio[0]
    # With several cells, another cell may transmit first and pass a frame on.
    if state.cells > 1 or not radio.edca or radio.lifetime < st.NEVER:
        return np.int64(-1)
    if state.deferred > 0 or state.waiting == 0:
        return np.int64(-1)
    slot = next_slot(cell)
    time = state.base + (slot - state.slot) * radio.slot
    if time >= base or (state.events > 0 and cell.events[0].time <= time):
        return np.int64(-1)
    return slot


@inlined
def synchronize(cell, time, sent_slot):
    """Restart all back-offs from the current transmission; EDCA counts AIFS as one slot."""
    state, radio = cell.state[0], cell.radio[0]
    if sent_slot >= 0:
        state.slot = sent_slot + radio.edca
    elif time >= state.base:
        state.slot += (time - state.base) // radio.slot + radio.edca
    base, gone = st.NEVER, np.int64(0)
    for place in range(state.deferred):
        waiting_station = cell.deferred[state.here, place]
        if waiting_station.base != base:  # divide only if the base differs
            base, gone = waiting_station.base, np.int64(0)
            if time >= base:
                gone = (time - base) // radio.slot + radio.edca
        if waiting_station.station >= 0:
            sends_at = state.slot + waiting_station.left - gone
            enter_backoff_wheel(cell, waiting_station.station, sends_at)
    state.deferred, state.deferred_time = 0, st.NEVER


@inlined
def free_slots(cell, station, time):
    """Return the free places of a queue [frames]; a full queue drops its expired frames first."""
    its = cell.stations[station]
    if its.length >= cell.radio[0].queue:
        queues.oldest_entry(cell, station, time)
    return cell.radio[0].queue - its.length


@inlined
def enqueue_or_drop(cell, station, frame, time):
    """Append a frame to a queue, or drop the frame if the queue is full; return whether it fits."""
    if free_slots(cell, station, time) <= 0:
        queues.count_drop(cell, frame, station, st.QUEUE_FULL)
        return False
    queues.append_entry(cell, station, frame, time)
    queues.change_length(cell, station, 1)
    return True


@not_inlined
def send_over_wire(cell, station, frame, time):
    """Send a frame over the wire to a station of another cell, where it arrives at a given time."""
    state, node = cell.state[0], cell.state[0].free
    cell.pool[node].frame, state.free = frame, cell.pool[node].next
    state.spare -= 1
    primitives.schedule_event(cell, time, st.WIRE | station | (node << st.PROCESS_BITS))


@not_inlined
def take_from_wire(cell, node):
    """Return a frame that has arrived over the wire."""
    state = cell.state[0]
    cell.pool[node].next, state.free = state.free, node
    state.spare += 1
    return cell.pool[node].frame


@inlined
def queue_at_station(cell, station, frame, time):
    """Queue a frame at a station of any cell, which then contends for its channel."""
    state = cell.state[0]
    if state.cells > 1 and cell.cell_of[station] != state.here:
        if time > state.clock:  # the other cell is not there yet
            send_over_wire(cell, station, frame, time)
            return
        enter_cell(cell, cell.cell_of[station])
    if enqueue_or_drop(cell, station, frame, time):
        request_access(cell, station, time, time <= state.idle)


@inlined
def queue_at_ap(cell, frame, time, alone):
    """Queue a host's frame at the access point of the current cell."""
    station = primitives.access_point(cell.state[0])
    if enqueue_or_drop(cell, station, frame, time):
        # Between a single frame and its acknowledgement, the medium is idle (10.23.2.2 a).
        request_access(cell, station, time, not alone)


@not_inlined
def relay_to_cells(cell, frame, time, alone):
    """Queue a host's frame at the access points of its receivers in several cells."""
    state = cell.state[0]
    first, end = np.int64(0), state.cells
    if cell.kinds[primitives.kind_of(frame)].multicast:
        state.open += (state.cells - 1) * (not frame & st.STEADY)
    else:
        first = cell.cell_of[queues.receiving_host(cell, frame)]
        end = first + 1
    for number in range(first, end):
        if number == state.here:
            queue_at_ap(cell, frame, time, alone)
        else:
            send_over_wire(cell, state.hosts + number, frame, time)


@not_inlined
def submit_frame(cell, frame, time):
    """Queue a process's new frame at its host; a wired host's frames go to the access point."""
    state = cell.state[0]
    source = queues.source_host(cell, frame)
    if not frame & st.STEADY:
        state.open += 1
        state.expected += queues.receiver_count(cell, frame, source)
        cell.stations[source].sought += queues.receiver_count(cell, frame, source)
    station = source
    if not cell.kinds[primitives.kind_of(frame)].up:
        station = state.hosts + cell.cell_of[cell.processes[primitives.destination_of(frame)].host]
    queue_at_station(cell, station, frame, time)


@not_inlined
def submit_burst(cell, host, burst, time):
    """Queue a burst at its host; drop the frames that do not fit."""
    state = cell.state[0]
    enter_cell(cell, cell.cell_of[host])
    total = queues.frames_of_burst(cell, host, burst)
    if total == 0:
        return
    for kind in range(state.kinds):
        row = cell.kinds[kind]
        # Frames with a single hop are queued one by one.
        if cell.bursts[burst, kind] and not (row.up and row.down):
            for _ in range(total):
                submit_frame(cell, queues.next_frame(cell, host, burst), time)
            cell.stations[host].begun = 0
            return
    fits = min(max(free_slots(cell, host, time), 0), total)
    multicast = queues.frames_to_all(cell, host, burst)
    if not queues.is_periodic(cell, burst):
        state.open += fits
        state.expected += total + multicast * (state.links - 1)
        cell.stations[host].sought += total + multicast * (state.links - 1)
        lost = total - fits + max(multicast - fits, 0) * (state.links - 1)
        queues.count_lost_receptions(cell, lost, host, host, st.QUEUE_FULL)
    if fits > 0:
        queues.append_entry(cell, host, queues.burst_entry(burst, fits), time)
        queues.change_length(cell, host, fits)
        request_access(cell, host, time, time <= state.idle)
