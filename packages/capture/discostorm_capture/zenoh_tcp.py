"""Zenoh over TCP: recognize its streams, and find the batches in them."""

import itertools
from array import array
from collections.abc import Container, Iterator
from typing import Any

import numpy as np

from discostorm_capture import zenoh_messages
from discostorm_capture._arrays import numbers_at
from discostorm_capture._types import Array, Bytes, Columns, Notes, Offsets
from discostorm_capture.tcp import GAPS_NOTE, StreamContent, Streams, reassemble_streams
from discostorm_capture.zenoh_messages import SessionOpening

_HTTPS_PORT = 443
#: Minimum share of segments that look like batches in a stream without captured start [1], and
#: their minimum number at ports other than Zenoh's.
_MIN_BATCH_SHARE, _MIN_BATCH_SEGMENTS = 0.8, 3
#: Kinds of batches of a session; after a gap, so many in a row are no accident.
_BATCH_KINDS = range(zenoh_messages.INIT, zenoh_messages.FRAGMENT + 1)
_MIN_BATCHES = 4


def starts_with_batch(data: Bytes, at: Offsets, size: Array) -> Array:
    """Return which segments seem to start with a batch."""
    length = numbers_at(data, at, "<u2").astype(np.int64)
    head = data[at + 2]
    kind, plain = head & 0x1F, head & zenoh_messages.EXT_FLAG == 0
    alike: Array = (
        ((kind == zenoh_messages.KEEP_ALIVE) & plain & (length == 1))
        | ((kind == zenoh_messages.CLOSE) & plain & (length == 2))
        | (np.isin(kind, (zenoh_messages.FRAME, zenoh_messages.FRAGMENT)) & (length > 3))
        | ((kind == zenoh_messages.OPEN) & (length > 3) & (length + 2 == size))
    )
    return alike & (size > 2)


def is_init_batch(data: Bytes, at: Offsets, size: Array) -> Array:
    """Return which segments are an Init, the first batch of either side."""
    length = numbers_at(data, at, "<u2").astype(np.int64)
    opens = zenoh_messages.opens_session(data, at + 2, length)
    opens &= (data[at + 2] & 0x1F == zenoh_messages.INIT) & (length + 2 == size)
    opens &= data[at + 4] & 0x0C == 0
    return opens


def zenoh_streams(data: Bytes, streams: Streams) -> Array:
    """Return the indices of Zenoh's streams."""
    table, count = streams.segments, len(streams.first_segment)
    rows = np.flatnonzero(table["size"] > 0)
    at, size, stream = table["at"][rows], table["size"][rows], table["stream"][rows]
    has_content, first = np.unique(stream, return_index=True)
    opens = np.zeros(count, bool)
    opens[has_content] = is_init_batch(data, at[first], size[first])
    # If a stream was open before the capture, most of its segments must look like Zenoh.
    alike = np.bincount(stream, starts_with_batch(data, at, size), count)
    segments = np.bincount(stream, minlength=count)
    ports = (table[name][streams.first_segment] for name in ("from_port", "to_port"))
    at_port = np.logical_or(*(port == zenoh_messages.ZENOH_PORT for port in ports))
    is_open = ~streams.start_captured & (alike >= _MIN_BATCH_SHARE * segments)
    is_open &= alike >= np.where(at_port, 1, _MIN_BATCH_SEGMENTS)
    is_zenoh = opens | is_open
    is_zenoh |= is_zenoh[streams.opposite]
    # At Zenoh's port the first segment may be too short to decide; then reassemble the stream.
    short = np.flatnonzero(at_port & streams.start_captured & (segments > 0) & ~is_zenoh)
    if len(short):
        begun = [*stream_openings(reassemble_streams(data, streams, short))]
        is_zenoh[begun] = is_zenoh[streams.opposite[begun]] = True
    return np.flatnonzero(is_zenoh)


def stream_openings(content: StreamContent) -> dict[int, SessionOpening]:
    """Return the session opening of each stream with captured start."""
    begun = [run[:3] for run in content.gapless_runs if run[3] and run[1] - run[0] > 5]
    at, last, stream = np.array(begun, np.int64).reshape(-1, 3).T
    end = np.minimum(at + 2 + numbers_at(content.data, at, "<u2"), last)
    opened = zenoh_messages.session_openings(content.data, at + 2, end)
    return {int(stream[index]): opening for index, opening in opened.items()}


def find_batches(
    content: StreamContent, streams: Streams, opened: dict[int, SessionOpening], notes: Notes
) -> Columns:
    """Return the first byte and the end of each batch in streams, and its ``stream``."""
    data, reverse = content.data.data, streams.opposite.tolist()
    rows, unread = array("q"), 0
    for begin, end, stream, is_start in content.gapless_runs:
        special = zenoh_messages.unreadable_feature(stream, reverse, opened)
        at = begin
        if is_start:
            most = zenoh_messages.OPENING_BATCHES if special else end
            found = list(itertools.islice(_batches_from(data, begin, end), most))
            rows.extend(itertools.chain(*((*batch, stream) for batch in found)))
            at = found[-1][1] if found else begin
        if special:
            notes[f"bytes of Zenoh sessions with {special}"] += end - at
            continue
        for start in _possible_batches(content, at, end) if at < end else ():
            if start < at:
                continue
            found = [*_batches_from(data, start, end, _BATCH_KINDS)]
            if len(found) >= _MIN_BATCHES or (found and found[-1][1] == end):
                rows.extend(itertools.chain(*((*batch, stream) for batch in found)))
                unread, at = unread + start - at, found[-1][1]
        unread += end - at
    if unread:
        notes[
            "bytes of Zenoh streams could not be read, as they are next to gaps or at the ends"
        ] += unread
    runs = content.gapless_runs
    if gaps := len(runs) - len({stream for _, _, stream, _ in runs}):
        notes[GAPS_NOTE] += gaps
    columns = np.array(rows, np.int64).reshape(-1, 3).T
    return dict(zip(("at", "end", "stream"), columns, strict=True))


def _batches_from(
    data: Any, at: int, end: int, kinds: Container[int] = range(32)
) -> Iterator[tuple[int, int]]:
    """Yield the first byte and the end of successive batches, while these are of some kinds."""
    while at + 3 <= end:
        # A sender that breaks off a message may send an empty batch.
        at += 2 * (data[at] == data[at + 1] == 0)
        after = at + 2 + int.from_bytes(data[at : at + 2], "little")
        if after > end or after == at + 2 or data[at + 2] & 0x1F not in kinds:
            return
        yield at + 2, after
        at = after


def _possible_batches(content: StreamContent, begin: int, end: int) -> list[int]:
    """Return the offsets of segments that may start with a batch."""
    first, last = np.searchsorted(content.parts["at"], (begin, end))
    at, size = content.parts["at"][first:last], content.parts["size"][first:last]
    data = content.data
    alike = starts_with_batch(data, at, size) | is_init_batch(data, at, size)
    return [int(one) for one in at[alike]]


def note_tls_connections(data: Bytes, streams: Streams, notes: Notes) -> None:
    """Note TCP connections that start with TLS, except those to port 443."""
    table = streams.segments
    at = table["at"]
    hello = (table["size"] > 5) & (data[at] == 22) & (data[at + 1] == 3) & (data[at + 2] <= 4)
    hello &= (data[at + 5] == 1) & (table["to_port"] != _HTTPS_PORT)
    if count := len(np.unique(table["stream"][hello])):
        notes["TCP connections are encrypted (TLS)"] += count
