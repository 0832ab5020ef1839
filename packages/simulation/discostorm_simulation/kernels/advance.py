"""The run itself: from one transmission or event to the next, until it is over."""

import numpy as np

from discostorm_simulation.kernels.channel_access import next_slot, synchronize
from discostorm_simulation.kernels.decorators import entry, njit, shared
from discostorm_simulation.kernels.delivery import load
from discostorm_simulation.kernels.frame_exchange import collide, send
from discostorm_simulation.kernels.primitives import next_event
from discostorm_simulation.kernels.recovery import happen, settled
from discostorm_simulation.state import GO_ON, MEMORY, NEVER, OVER


@shared
def sample(cell, time):
    """Record queue lengths at regular times; half as often whenever the table is full."""
    now = cell.now[0]
    while time >= now.sample:
        if now.samples == cell.samples.size:
            now.samples //= 2
            for place in range(now.samples):
                cell.samples[place].time = cell.samples[2 * place].time
                cell.samples[place].hosts = cell.samples[2 * place].hosts
                cell.samples[place].access_point = cell.samples[2 * place].access_point
            now.step *= 2
            now.sample = now.samples * now.step
            continue
        row = cell.samples[now.samples]
        row.time, row.hosts = now.sample, now.queued
        row.access_point = cell.stations[now.hosts].length
        now.samples += 1
        now.sample += now.step


@njit
def add_sender(cell, station, time, count):
    """Add a station to those that send now unless all that it has is too old."""
    if load(cell, station, time):
        cell.senders[count].station = station
        return count + 1
    cell.stations[station].waits = 0
    return count


@njit
def transmit(cell, time, slot):
    """Let all send whose back-off ends now."""
    now = cell.now[0]
    count = np.int64(0)
    if slot >= 0:
        place = slot & (cell.wheel.size - 1)
        station = np.int64(cell.wheel[place])
        cell.wheel[place] = -1
        while station >= 0:
            now.waiting -= 1
            following = np.int64(cell.behind[station])
            count = add_sender(cell, station, time, count)
            station = following
    if time >= now.stray_time:
        now.stray_time = NEVER
        for place in range(now.strays):
            stray = cell.strays[place]
            if stray.station >= 0:
                if time >= stray.time:
                    count = add_sender(cell, stray.station, time, count)
                    stray.station = -1
                else:
                    now.stray_time = min(now.stray_time, stray.time)
    if count == 0:
        return
    synchronize(cell, time, slot)
    station = cell.senders[0].station
    if count > 1:
        station = collide(cell, count, time)
        if station < 0:
            return
    send(cell, station, time)
    if count > 1:
        now.overlapping, now.others, now.damaged = 0, 0, 0


@entry
def advance(cell, until, reserve, steps):
    """Go on with a run: return `OVER` when it is, `MEMORY` to have more first, else `GO_ON`."""
    now, slot_ticks = cell.now[0], cell.radio[0].slot
    while steps > 0:
        if now.open == 0 and now.coming == 0 and settled(cell):
            return OVER
        if now.spare < reserve or now.events + reserve > cell.events.size:
            return MEMORY
        time, slot = NEVER, np.int64(-1)
        if now.waiting > 0:
            slot = next_slot(cell)
            time = now.base + (slot - now.slot) * slot_ticks
        if now.stray_time < time:
            time, slot = now.stray_time, np.int64(-1)
        happens = now.events > 0 and cell.events[0].time <= time
        if happens:
            time = cell.events[0].time
        if time > until:
            return OVER
        sample(cell, time)
        now.clock = time
        if happens:
            happen(cell, time, next_event(cell))
        else:
            transmit(cell, time, slot)
        steps -= 1
    return GO_ON
