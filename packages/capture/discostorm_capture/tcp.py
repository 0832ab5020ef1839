"""TCP streams put together: what was sent again, reordered, overlaps or is lost."""

from array import array
from collections.abc import Iterator
from dataclasses import dataclass
from heapq import heappop, heappush

import numpy as np

from discostorm_capture._bytes import (
    PAD,
    Array,
    Bytes,
    Columns,
    codes,
    stack,
    take,
    times_before,
    view,
)

FIN, SYN, RST = 1, 2, 4
#: What a capture may lack, as notes call it.
GAPS = "gaps in TCP streams of Zenoh, of what was not captured"


@dataclass(frozen=True)
class Streams:
    """The segments of a capture by stream, each direction of a connection being one.

    Parameters
    ----------
    table : dict
        The segments, those of a stream together, in the order of the capture. Added to what
        `ip.segments` says are ``place``, where the content stands in the stream [B], and
        ``stream``, its number.
    first : numpy.ndarray
        Of each stream, its first row.
    reverse : numpy.ndarray
        Of each stream, the number of the other direction; its own if there is none.
    complete : numpy.ndarray
        Of each stream, whether its start was captured: ``place`` 0 is its first byte.
    """

    table: Columns
    first: Array
    reverse: Array
    complete: Array


def streams(parts: list[Columns]) -> Streams:
    """Return the segments of all parts by stream."""
    segments = stack(parts)
    ends = [segments[key].astype(np.int64) for key in ("source", "target", "from_port", "to_port")]
    there = (ends[0] << 32 | ends[2], ends[1] << 32 | ends[3])
    code, _ = codes(*there)
    order = np.argsort(code, kind="stable")
    table, code = take(segments, order), code[order]
    del segments
    sequence = table["sequence"]
    syn = table["flags"] & SYN > 0
    new = np.diff(code, prepend=-1) != 0
    # Ports are used again: a SYN with another number starts a stream of its own.
    index = np.arange(len(code))
    last_syn = np.maximum.accumulate(np.where(syn, index, -1)) if len(code) else index
    before = np.append(-1, last_syn[:-1])[: len(code)]
    start = np.flatnonzero(new)
    begin = start[np.cumsum(new) - 1] if len(start) else index
    again = syn & (before >= begin) & (sequence != sequence[before])
    # A SYN after the end of what was captured before it, too.
    again |= syn & (before < begin) & ~new
    new |= again
    stream = np.cumsum(new) - 1
    first = np.flatnonzero(new)
    step: Array = np.diff(sequence.astype(np.int64), prepend=sequence[:1].astype(np.int64))
    place = np.cumsum((step + (1 << 31)) % (1 << 32) - (1 << 31))
    # The SYN itself takes a number.
    place = place + syn
    complete = syn[first] if len(first) else np.zeros(0, bool)
    place = place - (place[first] if len(first) else place)[stream]
    table = table | {"place": place, "stream": stream.astype(np.int32)}
    # The other direction: the same connection, the same one of those that follow each other.
    forward = [key[order][first] for key in there]
    low, high = np.minimum(*forward), np.maximum(*forward)
    pair, _ = codes(low, high)
    side = forward[0] == low
    turn = times_before(pair * 2 + side)
    by_pair: dict[tuple[int, int, bool], int] = {
        key: number
        for number, key in enumerate(zip(pair.tolist(), turn.tolist(), side.tolist(), strict=True))
    }
    reverse = np.array(
        [by_pair.get((one, time, not way), number) for (one, time, way), number in by_pair.items()],
        np.int64,
    )
    return Streams(table, first, reverse, complete)


@dataclass(frozen=True)
class Content:
    """What streams carry.

    Parameters
    ----------
    data : numpy.ndarray
        The bytes, stream after stream, each without its gaps.
    pieces : dict
        ``at``, where a piece of a segment stands in it, in order; ``segment``, its row in
        `Streams.table`; ``done``, the row of the one that completed it.
    runs : list of tuple
        What has no gap, in order: where it starts and ends, its stream, and whether it is the
        start of the stream.
    old : numpy.ndarray
        The rows of segments that carry only what was sent before.
    """

    data: Bytes
    pieces: Columns
    runs: list[tuple[int, int, int, bool]]
    old: Array


def content(data: Bytes, streams_: Streams, chosen: Array) -> Content:
    """Return what the chosen streams carry."""
    table = streams_.table
    wanted = np.zeros(len(streams_.first), bool)
    wanted[chosen] = True
    rows = np.flatnonzero(wanted[table["stream"]] & (table["wire"] > 0))
    stream, place, wire, size = (table[key][rows] for key in ("stream", "place", "wire", "size"))
    numbers, firsts = np.unique(stream, return_index=True)
    lasts = np.append(firsts[1:], len(rows))
    skips, sizes, segments, done = (array("q") for _ in range(4))
    old: list[int] = []
    runs: list[tuple[int, int, int, bool]] = []
    total = 0
    for number, first, last in zip(numbers.tolist(), firsts.tolist(), lasts.tolist(), strict=True):
        mine = slice(first, last)
        row, places = rows[mine].tolist(), place[mine].tolist()
        begin, from_start = total, bool(streams_.complete[number]) and min(places) == 0
        for which, skip, many, by in _ordered(places, wire[mine].tolist(), size[mine].tolist()):
            if many > 0:
                skips.append(skip)
                sizes.append(many)
                segments.append(row[which])
                done.append(row[by])
                total += many
            elif many == 0:
                old.append(row[which])
            else:  # a gap
                if total > begin:
                    runs.append((begin, total, number, from_start))
                begin, from_start = total, False
        if total > begin:
            runs.append((begin, total, number, from_start))
    length, segment = np.array(sizes, np.int64), np.array(segments, np.int64)
    pieces = {
        "at": np.cumsum(length) - length,
        "size": length,
        "segment": segment,
        "done": np.array(done, np.int64),
    }
    at = table["at"][segment] + np.array(skips, np.int64)
    source = view(data)
    parts = [source[a : a + n] for a, n in zip(at.tolist(), sizes, strict=True)]
    joined = b"".join([*parts, bytes(PAD)])
    return Content(np.frombuffer(joined, np.uint8), pieces, runs, np.array(old, np.int64))


def _ordered(
    place: list[int], wire: list[int], size: list[int]
) -> Iterator[tuple[int, int, int, int]]:
    """Yield what of which segment is new, in the order of the stream: segment, skipped, bytes, by.

    ``by`` is the segment with which everything up to there was there. No bytes: nothing of it
    is new. Fewer than none: a gap.
    """
    expected = min(place[0], 0) if 0 in place else place[0]
    waiting: list[tuple[int, int]] = []

    def new(which: int, by: int) -> Iterator[tuple[int, int, int, int]]:
        nonlocal expected
        skip = max(expected - place[which], 0)
        if skip >= wire[which]:
            yield which, 0, 0, by
            return
        if skip < size[which]:
            yield which, skip, size[which] - skip, by
        if size[which] < wire[which]:  # cut when it was captured
            yield which, 0, -1, by
        expected = place[which] + wire[which]

    for which, here in enumerate(place):
        if here > expected:
            heappush(waiting, (here, which))
            continue
        yield from new(which, which)
        while waiting and waiting[0][0] <= expected:
            yield from new(heappop(waiting)[1], which)
    # What is left comes after something that was not captured.
    while waiting:
        here, which = heappop(waiting)
        if here > expected:
            yield which, 0, -1, which
            expected = here
        yield from new(which, which)
