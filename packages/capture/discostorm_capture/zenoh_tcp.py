"""Zenoh over TCP: recognize its streams, and find the batches in them."""

from array import array

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
        at, count = begin, 0
        if not is_start:
            at = end if special else _first_batch_after_gap(content, begin, end)
            unread += at - begin
        while at + 3 <= end and not (special and count == zenoh_messages.OPENING_BATCHES):
            after = at + 2 + data[at] + 256 * data[at + 1]
            if after > end or after == at + 2:
                break
            rows.extend((at + 2, after, stream))
            at, count = after, count + 1
        if special:
            notes[f"bytes of Zenoh sessions with {special}"] += end - at
        else:
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


def _first_batch_after_gap(content: StreamContent, begin: int, end: int) -> int:
    """Return the offset of the first batch after a gap; it must start a segment."""
    first, last = np.searchsorted(content.parts["at"], (begin, end))
    at, size = content.parts["at"][first:last], content.parts["size"][first:last]
    data = content.data
    good = np.flatnonzero(starts_with_batch(data, at, size) | is_init_batch(data, at, size))
    return int(at[good[0]]) if len(good) else end


def note_tls_connections(data: Bytes, streams: Streams, notes: Notes) -> None:
    """Note TCP connections that start with TLS, except those to port 443."""
    table = streams.segments
    at = table["at"]
    hello = (table["size"] > 5) & (data[at] == 22) & (data[at + 1] == 3) & (data[at + 2] <= 4)
    hello &= (data[at + 5] == 1) & (table["to_port"] != _HTTPS_PORT)
    if count := len(np.unique(table["stream"][hello])):
        notes["TCP connections are encrypted (TLS)"] += count
