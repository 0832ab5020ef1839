"""Zenoh over TCP: which streams are its own, their sessions, batches and fragments."""

from array import array
from collections import Counter
from dataclasses import dataclass

import numpy as np

from discostorm_capture import zenoh
from discostorm_capture._bytes import Array, Bytes, Columns, Places, number, view
from discostorm_capture.tcp import GAPS, Content, Streams

#: The extension of a fragment that tells its priority.
_PRIORITY = 0x31


def is_batch(data: Bytes, at: Places, size: Array) -> Array:
    """Return which segments look as if they started with a batch of Zenoh."""
    length = number(data, at, "<u2").astype(np.int64)
    head = data[at + 2]
    kind = head & 0x1F
    plain = head & zenoh.EXTENDED == 0
    alike: Array = (
        ((kind == zenoh.KEEP_ALIVE) & plain & (length == 1))
        | ((kind == zenoh.CLOSE) & plain & (length == 2))
        | ((kind == zenoh.FRAME) & (length > 3))
        | ((kind == zenoh.FRAGMENT) & (length > 3))
        | ((kind == zenoh.OPEN) & (length > 3) & (length + 2 == size))
    )
    return alike & (size > 2)


def is_init(data: Bytes, at: Places, size: Array) -> Array:
    """Return which segments are an Init, the first that each side of a session sends."""
    length = number(data, at, "<u2").astype(np.int64)
    found: Array = (
        (size > 6)
        & (length + 2 == size)
        & (data[at + 2] & 0x1F == zenoh.INIT)
        & np.isin(data[at + 3], zenoh.VERSIONS)
        & (data[at + 4] & 0x0C == 0)
    )
    return found


def chosen(data: Bytes, streams: Streams) -> Array:
    """Return the numbers of the streams that are Zenoh's."""
    table = streams.table
    rows = np.flatnonzero(table["size"] > 0)
    at, size, stream = table["at"][rows], table["size"][rows], table["stream"][rows]
    count = len(streams.first)
    first = np.full(count, -1, np.int64)
    first[stream[::-1]] = np.arange(len(rows) - 1, -1, -1)
    init = np.zeros(count, bool)
    has = first >= 0
    init[has] = is_init(data, at[first[has]], size[first[has]])
    # Of one that was open before the capture, most of what it sends must look like it.
    alike = np.bincount(stream, is_batch(data, at, size), count)
    all_ = np.bincount(stream, minlength=count)
    known_port = np.zeros(count, bool)
    known_port[
        stream[(table["from_port"][rows] == zenoh.PORT) | (table["to_port"][rows] == zenoh.PORT)]
    ] = True
    begun = ~streams.complete & (alike >= 0.8 * all_) & (alike >= np.where(known_port, 1, 3))
    found = init | begun
    found |= found[streams.reverse]
    return np.flatnonzero(found)


def undecided(streams: Streams, chosen: Array) -> Array:
    """Return the other streams of Zenoh's port of which the start was captured.

    Their first segment may be too short to tell.
    """
    table = streams.table
    found = np.unique(table["stream"][_at_port(streams) & (table["size"] > 0)])
    return np.setdiff1d(found[streams.complete[found]], chosen)


def _at_port(streams: Streams) -> Array:
    """Return which segments are from or to Zenoh's port."""
    ports = streams.table["from_port"], streams.table["to_port"]
    found: Array = (ports[0] == zenoh.PORT) | (ports[1] == zenoh.PORT)
    return found


@dataclass(frozen=True)
class Opening:
    """What one side said when it opened a session.

    Parameters
    ----------
    zid : bytes
        The identity of the process.
    role : int
        Whether it is a router, a peer or a client.
    acknowledges : bool
        Whether it answers the other side's.
    special : str
        What makes the session unreadable if both sides want it; "" if nothing.
    """

    zid: bytes
    role: int
    acknowledges: bool
    special: str


def openings(content: Content) -> dict[int, Opening]:
    """Return what each stream of which the start was captured says first."""
    begun = [(at, end, stream) for at, end, stream, start in content.runs if start and end - at > 5]
    at, last, stream = np.array(begun, np.int64).reshape(-1, 3).T
    end = np.minimum(at + 2 + number(content.data, at, "<u2"), last)
    found = openings_at(content.data, at + 2, end)
    return {int(stream[index]): opening for index, opening in found.items()}


def openings_at(data: Bytes, at: Places, end: Places) -> dict[int, Opening]:
    """Return what batches say that open a session, by their place among those given."""
    head = data[at]
    after, extensions = zenoh.read_init(data, at + 1, end, head)
    joined, _ = zenoh.read_join(data, at + 1, end, head)
    known = zenoh.may_open(data, at, end - at)
    init = known & (head & 0x1F == zenoh.INIT) & (after <= end)
    join = known & (head & 0x1F == zenoh.JOIN) & (joined <= end)
    low_latency, compression = (
        init & (head & zenoh.EXTENDED > 0) & zenoh.has_extension(data, extensions, end, which)
        for which in (zenoh.LOW_LATENCY, zenoh.COMPRESSION)
    )
    found = {}
    for index in np.flatnonzero(init | join).tolist():
        here = int(at[index])
        length = (int(data[here + 2]) >> 4) + 1
        special = ""
        if compression[index]:
            special = "compression"
        elif low_latency[index]:
            special = "low latency"
        found[index] = Opening(
            zid=data[here + 3 : here + 3 + length].tobytes(),
            role=int(data[here + 2]) & 3,
            acknowledges=bool(init[index] and head[index] & zenoh.ANSWER),
            special=special,
        )
    return found


def batches(
    content: Content, streams: Streams, opened: dict[int, Opening], notes: Counter[str]
) -> Columns:
    """Return where each batch in streams starts and ends, and its ``stream``."""
    data, reverse = view(content.data), streams.reverse.tolist()
    begins, ends, owners = array("q"), array("q"), array("q")
    cut = 0
    for at, last, stream, start in content.runs:
        here, special = at, special_of(stream, reverse, opened)
        if not start:
            here = last if special else _aligned(content, at, last)
            cut += here - at
        found = 0
        # The opening of a session can be read in any case.
        while here + 3 <= last and not (special and found == 2):
            after = here + 2 + data[here] + 256 * data[here + 1]
            if after > last or after == here + 2:
                break
            begins.append(here + 2)
            ends.append(after)
            owners.append(stream)
            here = after
            found += 1
        if special:
            notes[f"bytes of Zenoh sessions with {special}"] += last - here
        else:
            cut += last - here
    if cut:
        notes["bytes of Zenoh streams next to gaps or to their ends"] += cut
    if gaps := len(content.runs) - len({stream for _, _, stream, _ in content.runs}):
        notes[GAPS] += gaps
    columns = {"at": begins, "end": ends, "stream": owners}
    return {name: np.array(column, np.int64) for name, column in columns.items()}


def special_of(stream: int, reverse: list[int], opened: dict[int, Opening]) -> str:
    """Return what makes a session unreadable, if anything: both sides must have agreed on it."""
    pair = [opened.get(stream), opened.get(reverse[stream])]
    said = [session for session in pair if session is not None]
    answers = [session for session in said if session.acknowledges]
    return next((session.special for session in answers or said if session.special), "")


def _aligned(content: Content, at: int, end: int) -> int:
    """Return where the first batch starts in what follows a gap: where a segment starts."""
    pieces = content.pieces
    first, last = np.searchsorted(pieces["at"], (at, end))
    places, sizes = pieces["at"][first:last], pieces["size"][first:last]
    data = content.data
    good = np.flatnonzero(is_batch(data, places, sizes) | is_init(data, places, sizes))
    return int(places[good[0]]) if len(good) else end


def put_together(
    data: Bytes, found: Columns, stream: Array, notes: Counter[str]
) -> tuple[list[bytes], list[list[int]]]:
    """Return the messages that fragments make, and the rows of their fragments.

    Parameters
    ----------
    data : numpy.ndarray
        Where the fragments are.
    found : dict
        As `parse` returns it.
    stream : numpy.ndarray
        The stream of each row.
    notes : Counter
        What could not be put together is counted here.
    """
    is_fragment = found["code"] == zenoh.CODES["transport"][zenoh.FRAGMENT]
    open_: dict[tuple[int, int, bytes], tuple[list[bytes], list[int]]] = {}
    made: list[bytes] = []
    rows: list[list[int]] = []
    for row in np.flatnonzero(is_fragment).tolist():
        head, at = int(found["head"][row]), int(found["at"][row])
        begin, end = int(found["number"][row]), int(found["end"][row])
        # The number ends with the first byte below 128; extensions tell the priority.
        place = at + 1
        while place < begin and data[place] > 127:
            place += 1
        priority = (
            bytes(b & 0x7F for b in data[place + 1 : place + 3].tolist())
            if head & zenoh.EXTENDED
            else b""
        )
        if priority[:1] != b"\x31":
            priority = b""
        key = int(stream[row]), head & 0x20, priority
        parts, members = open_.setdefault(key, ([], []))
        parts.append(data[begin:end].tobytes())
        members.append(row)
        if not head & 0x40:
            made.append(b"".join(parts))
            rows.append(members)
            del open_[key]
    if open_:
        notes["Zenoh messages of which fragments are missing"] += len(open_)
    return made, rows
