"""The main loop of a run: from one transmission or event to the next."""

import numpy as np

from discostorm_simulation import state as st
from discostorm_simulation.kernels import channel_access
from discostorm_simulation.kernels.decorators import called_from_python, inlined, not_inlined
from discostorm_simulation.kernels.delivery import fill_window
from discostorm_simulation.kernels.frame_exchange import transmit_alone, transmit_together
from discostorm_simulation.kernels.middleware_events import dispatch_event
from discostorm_simulation.kernels.primitives import next_event


@not_inlined
def sample_queues(cell, time):
    """Sample the queue lengths at regular times; double the interval when the table is full."""
    state = cell.state[0]
    while time >= state.sample:
        if state.samples == cell.queue_samples.size:
            state.samples //= 2
            for place in range(state.samples):
                cell.queue_samples[place] = cell.queue_samples[2 * place]
            state.step *= 2
            state.sample = state.samples * state.step
            continue
        row = cell.queue_samples[state.samples]
        row.time, row.hosts, row.access_point = state.sample, state.queued, 0
        for station in range(state.hosts, state.hosts + state.cells):
            row.access_point += cell.stations[station].length
        state.samples += 1
        state.sample += state.step


@inlined
def add_sender(cell, station, time, count):
    """Add a station to the current senders unless all its frames have expired."""
    if fill_window(cell, station, time):
        cell.senders[count].station = station
        return count + 1
    cell.stations[station].waits = 0
    return count


@inlined
def transmit(cell, time, slot):
    """Transmit the frames of all stations whose back-off ends now."""
    state = cell.state[0]
    count = np.int64(0)
    if slot >= 0:
        wheel = cell.wheel[state.here]
        place = slot & (wheel.size - 1)
        station = np.int64(wheel[place])
        wheel[place] = -1
        while station >= 0:
            state.waiting -= 1
            following = np.int64(cell.behind[station])
            if count and cell.radio[0].cw_max == 0:  # nobody contends for a wire
                channel_access.enter_backoff_wheel(cell, station, slot + 1)
            else:
                count = add_sender(cell, station, time, count)
            station = following
    if time >= state.deferred_time:
        state.deferred_time = st.NEVER
        for place in range(state.deferred):
            waiting_station = cell.deferred[state.here, place]
            if waiting_station.station >= 0:
                if time >= waiting_station.time:
                    count = add_sender(cell, waiting_station.station, time, count)
                    waiting_station.station = -1
                else:
                    state.deferred_time = min(state.deferred_time, waiting_station.time)
    if count == 0:
        return
    channel_access.synchronize(cell, time, slot)
    station = cell.senders[0].station
    if count > 1:
        station = transmit_together(cell, count, time)
    if station >= 0:
        transmit_alone(cell, station, time)
    state.overlapping, state.others, state.damaged = 0, 0, 0


@called_from_python
def advance(cell, until, reserve, steps):
    """Simulate ``steps`` steps of a run; return `OVER`, `MEMORY` (needs more memory) or `GO_ON`."""
    state = cell.state[0]
    while steps > 0:
        # Without recovery, only user data prolong a run.
        complete = state.converged > 0 if state.repairs else state.stamp == 0
        if state.open == 0 and state.coming == 0 and complete:
            return st.OVER
        if state.spare < reserve or state.events + reserve > cell.events.size:
            return st.MEMORY
        if state.cells > 1:
            channel_access.enter_earliest_cell(cell)
        time, slot = st.NEVER, np.int64(-1)
        if state.waiting > 0:
            slot = channel_access.next_slot(cell)
            time = state.base + (slot - state.slot) * cell.radio[0].slot
        if state.deferred_time < time:
            time, slot = state.deferred_time, np.int64(-1)
        happens = state.events > 0 and cell.events[0].time <= time
        if happens:
            time = cell.events[0].time
        waits = state.patience > 0 and state.converged == 0
        if time > until or (waits and time > state.progress + state.patience):
            return st.OVER
        sample_queues(cell, time)
        state.clock = time
        if happens:
            dispatch_event(cell, time, next_event(cell))
        else:
            transmit(cell, time, slot)
        steps -= 1
    return st.GO_ON
