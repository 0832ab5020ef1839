"""Helpers of all kernels: frames as integers, random numbers, and the heap of future events."""

import numpy as np

from discostorm_simulation import state as st
from discostorm_simulation.kernels.decorators import inlined, not_inlined


@inlined
def access_point(state):
    """Return the access point of the current cell."""
    return state.hosts + state.here


@inlined
def pack_frame(kind, source, destination, item):
    """Pack row, source process, destination process and item into a frame."""
    processes = (destination << st.DESTINATION_SHIFT) | (source << st.SOURCE_SHIFT)
    return kind | processes | ((item & st.ITEMS) << st.ITEM_SHIFT)


@inlined
def kind_of(frame):
    """Return the row of the message table that a frame carries."""
    return frame & st.KIND_MASK


@inlined
def destination_of(frame):
    """Return the destination process of a unicast frame."""
    return (frame >> st.DESTINATION_SHIFT) & st.PROCESS_MASK


@inlined
def source_of(frame):
    """Return the source process of a frame."""
    return (frame >> st.SOURCE_SHIFT) & st.PROCESS_MASK


@inlined
def item_of(frame):
    """Return a frame's item: its index among the equal messages of a pair of processes."""
    return (frame >> st.ITEM_SHIFT) & st.ITEMS


@inlined
def random_bits(state):
    """Draw 64 random bits (xorshift64*, Vigna 2016)."""
    x = np.uint64(state.random)
    x ^= x >> np.uint64(12)
    x ^= x << np.uint64(25)
    x ^= x >> np.uint64(27)
    state.random = np.int64(x)
    return x * np.uint64(2685821657736338717)


@inlined
def draw_below(state, number):
    """Draw a uniform integer from 0 to below ``number``."""
    return (np.int64(random_bits(state) >> np.uint64(33)) * number) >> 31


@inlined
def draw_uniform(state):
    """Draw a uniform number from 0 to below 1."""
    return np.float64(np.int64(random_bits(state) >> np.uint64(11))) * 2.0**-53


@not_inlined
def schedule_event(cell, time, what):
    """Insert an event into the heap."""
    events = cell.events
    place = cell.state[0].events
    cell.state[0].events = place + 1
    while place > 0:
        above = (place - 1) >> 1
        if events[above].time <= time:
            break
        events[place] = events[above]
        place = above
    events[place].time, events[place].what = time, what


@not_inlined
def schedule_pair_event(cell, time, what, one, other, row):
    """Insert an event of a process, about another process and a message row, into the heap."""
    about = (other << st.PROCESS_BITS) | (row << (2 * st.PROCESS_BITS))
    schedule_event(cell, time, what | one | about)


@inlined
def next_event(cell):
    """Remove the earliest event from the heap, and return the event."""
    events = cell.events
    result = events[0].what
    count = cell.state[0].events - 1
    cell.state[0].events = count
    last, place = events[count], 0
    while True:
        lower = 2 * place + 1
        if lower >= count:
            break
        if lower + 1 < count and events[lower + 1].time < events[lower].time:
            lower += 1
        if events[lower].time >= last.time:
            break
        events[place] = events[lower]
        place = lower
    events[place] = last
    return result
