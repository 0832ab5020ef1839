"""Reassemble TCP streams, whose segments may be repeated, reordered, overlapping or missing."""

from array import array
from collections.abc import Iterator
from dataclasses import dataclass
from heapq import heappop, heappush

import numpy as np

from discostorm_capture._arrays import cumcount, factorize, join_padded, take_rows
from discostorm_capture._types import Array, Bytes, Columns
from discostorm_capture.ip import sender_and_receiver_sockets

FIN, SYN, RST, ACK = 1, 2, 4, 16
#: Note on segments that the capture lacks.
GAPS_NOTE = "gaps in Zenoh's TCP streams, which lack uncaptured packets"


@dataclass(frozen=True)
class Streams:
    """The segments of a capture, grouped by stream: one direction of a connection."""

    #: `ip.tcp_segments` sorted by ``stream``, an index, with ``position``, the payload's offset in
    #: the stream [B], and ``arrived``: the other direction acknowledged it or was not captured.
    segments: Columns
    #: The first row of each stream; the index of the opposite stream, or its own if none was seen.
    first_segment: Array
    opposite: Array
    #: Whether the start of each stream was captured, so that position 0 is its first byte.
    start_captured: Array


def split_streams(segments: Columns) -> Streams:
    """Return segments grouped by stream."""
    sender, receiver = sender_and_receiver_sockets(segments)
    code, _ = factorize(sender, receiver)
    order = np.argsort(code, kind="stable")
    table, code = take_rows(segments, order), code[order]
    first, complete = _find_stream_starts(table, code)
    stream = np.cumsum(first) - 1
    first = np.flatnonzero(first)
    step = np.diff(table["sequence"], prepend=table["sequence"][:1])
    position = np.cumsum((step + (1 << 31)) % (1 << 32) - (1 << 31))
    # A SYN takes one sequence number.
    position += table["flags"] & SYN > 0
    position -= position[first][stream]
    reverse = _opposite_streams(sender[order][first], receiver[order][first])
    arrived = position + table["wire"] <= _acknowledged_until(table, first, stream, reverse)[stream]
    table |= {"position": position, "stream": stream, "arrived": arrived}
    return Streams(table, first, reverse, complete[first])


def _find_stream_starts(table: Columns, code: Array) -> tuple[Array, Array]:
    """Return masks of the segments that start a stream, and of those with SYN."""
    # Ports are reused: a SYN starts a new stream if its sequence number differs from the previous
    # SYN's, or if there was none.
    syn, sequence = table["flags"] & SYN > 0, table["sequence"]
    new = np.diff(code, prepend=-1) != 0
    index = np.arange(len(code))
    begin = np.maximum.accumulate(np.where(new, index, 0))
    last_syn = np.maximum.accumulate(np.where(syn, index, -1))
    before = np.concatenate([[-1], last_syn])[: len(code)]
    return new | (syn & ((before < begin) | (sequence != sequence[before]))), syn


def _acknowledged_until(table: Columns, first: Array, stream: Array, reverse: Array) -> Array:
    """Return the position up to which the opposite stream acknowledges each stream."""
    acks = np.flatnonzero(table["flags"] & ACK > 0)
    of = reverse[stream[acks]]
    position = _acknowledged_positions(table, acks, first[of])
    until = np.full(len(first), -1, np.int64)
    np.maximum.at(until, of, position)
    until[reverse == np.arange(len(first))] = np.iinfo(np.int64).max
    return until


def _acknowledged_positions(table: Columns, acks: Array, origin: Array) -> Array:
    """Return the positions that rows acknowledge in streams with these first rows."""
    step = table["acknowledges"][acks] - table["sequence"][origin]
    position = (step + (1 << 31)) % (1 << 32) - (1 << 31) - (table["flags"][origin] & SYN > 0)
    return np.asarray(position)


def acknowledgement_delays(streams: Streams, since: Array) -> Iterator[tuple[int, Array]]:
    """Yield the first row of each stream with payload, and how long segments were unacknowledged.

    `since` is the time of each frame [s], and so are the delays, of acknowledged segments only.
    """
    table, first = streams.segments, streams.first_segment
    time, ends = since[table["frame"]], np.append(first, len(table["wire"]))[1:]
    for begin, end, back in zip(first, ends, streams.opposite, strict=True):
        acks = np.arange(first[back], ends[back])
        acks = acks[(table["flags"][acks] & ACK > 0) & (first[back] != begin)]
        rows = np.arange(begin, end)[table["wire"][begin:end] > 0]
        until = np.maximum.accumulate(_acknowledged_positions(table, acks, begin))
        ack = np.searchsorted(until, (table["position"] + table["wire"])[rows])
        inside = ack < len(acks)
        if inside.any():
            yield int(begin), time[acks[ack[inside]]] - time[rows[inside]]


def _opposite_streams(sender: Array, receiver: Array) -> Array:
    """Return the index of each stream's opposite; the n-th uses of a pair of ports match."""
    pair, _ = factorize(np.minimum(sender, receiver), np.maximum(sender, receiver))
    forward = sender <= receiver
    use = cumcount(pair * 2 + forward)
    keys = list(zip(pair.tolist(), use.tolist(), forward.tolist(), strict=True))
    number_of = {key: number for number, key in enumerate(keys)}
    reverse = [number_of.get((*key, not way), own) for own, (*key, way) in enumerate(keys)]
    return np.array(reverse, np.int64)


@dataclass(frozen=True)
class StreamContent:
    """The reassembled bytes of streams, one stream after the other, without gaps."""

    data: Bytes
    #: Parts of segments in order: ``at``, the offset of a part in the bytes; ``size``; ``segment``,
    #: its row in `Streams.segments`; ``done``, the row of the segment that completed the stream up
    #: to this part.
    parts: Columns
    #: Begin and end of each run without gaps, its stream, and whether it starts that stream.
    gapless_runs: list[tuple[int, int, int, bool]]
    #: The rows of segments that carry no new bytes.
    retransmitted: Array


def reassemble_streams(data: Bytes, streams: Streams, chosen: Array) -> StreamContent:
    """Return the reassembled bytes of the chosen streams."""
    table = streams.segments
    rows = np.flatnonzero(np.isin(table["stream"], chosen) & (table["wire"] > 0))
    stream = table["stream"][rows]
    numbers, firsts = np.unique(stream, return_index=True)
    lasts = np.append(firsts, len(rows))[1:]
    parts = array("q")
    chunks, retransmitted = [], []
    runs: list[tuple[int, int, int, bool]] = []
    total, source = 0, data.data
    for number, first, last in zip(numbers.tolist(), firsts.tolist(), lasts.tolist(), strict=True):
        row = rows[first:last]
        names = ("position", "wire", "size", "at")
        position, wire, size, at = (table[name][row].tolist() for name in names)
        begin, from_start = total, bool(streams.start_captured[number]) and min(position) == 0
        for index, skip, length, done in _new_bytes_in_order(position, wire, size):
            if length > 0:
                parts.extend((total, length, row[index], row[done]))
                chunks.append(source[at[index] + skip : at[index] + skip + length])
                total += length
            elif length == 0:
                retransmitted.append(int(row[index]))
            else:  # a gap, or the end
                if total > begin:
                    runs.append((begin, total, number, from_start))
                begin, from_start = total, False
    columns = np.array(parts, np.int64).reshape(-1, 4).T
    return StreamContent(
        join_padded(*chunks),
        dict(zip(("at", "size", "segment", "done"), columns, strict=True)),
        runs,
        np.array(retransmitted, np.int64),
    )


def _new_bytes_in_order(
    position: list[int], wire: list[int], size: list[int]
) -> Iterator[tuple[int, int, int, int]]:
    """Yield segment, bytes to skip, number of new bytes (-1: gap or end), completing segment."""
    expected = min(position[0], 0) if 0 in position else position[0]
    waiting: list[tuple[int, int]] = []

    def new(index: int, done: int) -> Iterator[tuple[int, int, int, int]]:
        nonlocal expected
        skip = max(expected - position[index], 0)
        if skip >= wire[index]:
            yield index, 0, 0, done
            return
        if skip < size[index]:
            yield index, skip, size[index] - skip, done
        if size[index] < wire[index]:  # truncated by the snaplen
            yield index, 0, -1, done
        expected = position[index] + wire[index]

    for index, begin in enumerate(position):
        if begin > expected:
            heappush(waiting, (begin, index))
            continue
        yield from new(index, index)
        while waiting and waiting[0][0] <= expected:
            yield from new(heappop(waiting)[1], index)
    # The remaining segments follow gaps.
    while waiting:
        begin, index = heappop(waiting)
        if begin > expected:
            yield index, 0, -1, index
            expected = begin
        yield from new(index, index)
    yield 0, 0, -1, 0
