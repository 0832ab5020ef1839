"""Who sends when: the contention of 802.11 stations for one medium.

Back-off counters are not counted down one by one: every station that waits stands in a wheel
at the number of the slot in which it will send, and a busy medium moves the clock under the
wheel. So a transmission costs the same whatever the number of stations. Who has just
collided waits for its timeout first and stands beside the wheel until the next transmission
brings all clocks together again.

The rules are those of IEEE Std 802.11-2020, 10.3 and 10.23.2 (EDCA, one access category).
"""

import numpy as np

from discostorm_simulation.kernels.decorators import njit, shared
from discostorm_simulation.kernels.primitives import below, kind_of
from discostorm_simulation.kernels.queues import (
    burst_entry,
    burst_frames,
    change_length,
    count_lost,
    first_entry,
    frames_to_all,
    host_of,
    is_steady,
    lose,
    make,
    put,
    receivers,
)
from discostorm_simulation.state import FULL, NEVER, STEADY


@njit
def enter(cell, station, slot):
    """Let a station wait in the wheel for its slot."""
    now, its = cell.now[0], cell.stations[station]
    place = slot & (cell.wheel.size - 1)
    its.send_slot = slot
    cell.behind[station] = cell.wheel[place]
    its.waits = 1
    cell.wheel[place] = station
    now.waiting += 1
    now.ahead = min(now.ahead, slot)


@njit
def draw(cell, station):
    """Return a new back-off of a station [slots]."""
    radio = cell.radio[0]
    doubled = (radio.cw_min + 1) << min(cell.stations[station].failures, 20)
    return below(cell.now[0], min(doubled, radio.cw_max + 1))


@njit
def wait(cell, station, base, slots):
    """Let a station wait for so many slots, from a tick of its own on or from all others'."""
    now, its = cell.now[0], cell.stations[station]
    if its.length == 0:
        its.send_slot, its.waits = now.slot + slots, 0
    elif base == now.base:
        enter(cell, station, now.slot + slots)
    else:
        stray = cell.strays[now.strays]
        now.strays += 1
        stray.station, stray.base, stray.left = station, base, slots
        stray.time = base + slots * cell.radio[0].slot
        now.stray_time = min(now.stray_time, stray.time)
        its.waits = 1


@njit
def back_off(cell, station, base):
    """Draw the back-off after a transmission and wait for it."""
    wait(cell, station, base, draw(cell, station))


@njit
def wake(cell, station, time, busy):
    """Let a station with something to send contend, if it does not yet.

    A back-off that still runs goes on. If it has run out, the station sends without one
    at the next slot on an idle medium, and draws one on a busy medium.
    """
    now, its = cell.now[0], cell.stations[station]
    if its.waits:
        return
    slot = now.slot
    if busy:
        if its.send_slot <= slot:
            slot += draw(cell, station)
    elif time >= now.base:
        slots = (time - now.base) // cell.radio[0].slot + 1
        if now.waiting == 0 and now.strays == 0:
            now.base += slots * cell.radio[0].slot
            now.slot += slots
            now.ahead = now.slot
        slot += slots
    enter(cell, station, max(its.send_slot, slot))


@njit
def next_slot(cell):
    """Return the next slot in which somebody in the wheel sends."""
    slot, mask = cell.now[0].ahead, cell.wheel.size - 1
    while cell.wheel[slot & mask] < 0:
        slot += 1
    cell.now[0].ahead = slot
    return slot


@njit
def first_to_send(cell, base):
    """Return the slot of the next transmission if it surely begins before a tick, or -1.

    Who counts from that tick on only may stand in the wheel at once, behind that slot.
    """
    now, radio = cell.now[0], cell.radio[0]
    if not radio.edca or radio.lifetime < NEVER or now.strays > 0 or now.waiting == 0:
        return np.int64(-1)
    slot = next_slot(cell)
    time = now.base + (slot - now.slot) * radio.slot
    if time >= base or (now.events > 0 and cell.events[0].time <= time):
        return np.int64(-1)
    return slot


@njit
def synchronize(cell, time, sent_slot):
    """Move the clock on to the transmission that starts now; everybody counts alike again.

    With EDCA a counter goes down at the end of AIFS and at the end of each idle slot, so once
    more than there were idle slots; with DCF only at the end of each idle slot.
    """
    now, radio = cell.now[0], cell.radio[0]
    if sent_slot >= 0:
        now.slot = sent_slot + radio.edca
    elif time >= now.base:
        now.slot += (time - now.base) // radio.slot + radio.edca
    base, gone = NEVER, np.int64(0)
    for place in range(now.strays):
        stray = cell.strays[place]
        if stray.base != base:  # most have waited since the same time: divide once
            base, gone = stray.base, np.int64(0)
            if time >= base:
                gone = (time - base) // radio.slot + radio.edca
        if stray.station >= 0:
            enter(cell, stray.station, now.slot + stray.left - gone)
    now.strays, now.stray_time = 0, NEVER


# ---------------------------------------------------------------- what comes to be sent


@njit
def room(cell, station, time):
    """Return how many frames a queue still takes; who is full throws out what is too old."""
    its = cell.stations[station]
    if its.length >= cell.radio[0].queue:
        first_entry(cell, station, time)
    return cell.radio[0].queue - its.length


@njit
def offer(cell, station, frame, time):
    """Put one frame into a queue; return whether there was room."""
    if room(cell, station, time) <= 0:
        lose(cell, frame, station, FULL)
        return False
    put(cell, station, frame, time)
    change_length(cell, station, 1)
    return True


@shared
def offer_new(cell, frame, time):
    """Hand a new frame of a process to its host, or to the access point if that is wired."""
    now = cell.now[0]
    if not frame & STEADY:
        now.open += 1
        now.expected += receivers(cell, frame)
        cell.stations[host_of(cell, frame)].sought += receivers(cell, frame)
    station = now.hosts
    if cell.kinds[kind_of(frame)].up:
        station = host_of(cell, frame)
    if offer(cell, station, frame, time):
        wake(cell, station, time, time <= now.idle)


@shared
def offer_burst(cell, host, batch, time):
    """Hand a burst to a host's queue: what does not fit is lost."""
    now = cell.now[0]
    total = burst_frames(cell, host, batch)
    if total == 0:
        return
    for kind in range(now.kinds):
        row = cell.kinds[kind]
        # What has one hop only is handed over frame by frame.
        if cell.batches[batch, kind] and not (row.up and row.down):
            for _ in range(total):
                offer_new(cell, make(cell, host, batch), time)
            cell.stations[host].begun = 0
            return
    fits = min(max(room(cell, host, time), 0), total)
    multicast = frames_to_all(cell, host, batch)
    if not is_steady(cell, batch):
        cut = max(multicast - fits, 0)
        now.open += fits
        now.expected += total + multicast * (now.links - 1)
        cell.stations[host].sought += total + multicast * (now.links - 1)
        count_lost(cell, total - fits + cut * (now.links - 1), host, host, FULL)
    if fits > 0:
        put(cell, host, burst_entry(batch, fits), time)
        change_length(cell, host, fits)
        wake(cell, host, time, time <= now.idle)
