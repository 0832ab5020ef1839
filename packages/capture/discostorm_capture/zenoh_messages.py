"""Parse messages of Zenoh's scouting, transport and network layers by their layouts.

A layout names the parts of a message in order, after its head, the first byte. A part with ``?`` is
present if the head has a flag, with ``!`` if not: ``A`` is 0x20, ``M`` 0x40, ``Z`` 0x80. ``=int``
is the number of a message; after ``@`` the number is the offset of the next part.
"""

import re
from collections.abc import Callable, Iterator
from functools import cache, partial
from typing import NamedTuple

import numpy as np

from discostorm.data import read_data
from discostorm_capture._types import Array, Bytes, Columns, Offsets

EndAndNumber = tuple[Offsets, Array]
MESSAGE_ROWS = read_data("vendors/zenoh_messages.csv", "discostorm_capture")
MESSAGE_NAMES = [row["name"] for row in MESSAGE_ROWS] + ["unreadable"]
MESSAGE_KINDS = [row["kind"] for row in MESSAGE_ROWS] + ["unreadable"]
UNREADABLE = len(MESSAGE_ROWS)
#: The code of a message, its row in the data file, by layer and id.
CODES = {row["layer"]: np.full(64, UNREADABLE, np.uint8) for row in MESSAGE_ROWS}
#: The layout of each message, by layer and kind.
_LAYOUTS: dict[str, dict[int, str]] = {layer: {} for layer in CODES}
for _code, _row in enumerate(MESSAGE_ROWS):
    CODES[_row["layer"]][int(_row["id"], 16)] = _code
    _LAYOUTS[_row["layer"]][int(_row["id"], 16) & 0x1F] = _row["layout"]
_MESSAGES = _LAYOUTS["transport"] | _LAYOUTS["network"] | {0x1E: "int?A ext?Z @ declaration"}
_DECLARATIONS = _LAYOUTS["declare"]
ZENOH_PORT, SCOUTING_PORT = 7447, 7446
#: Protocol versions that share the layouts used here.
READABLE_VERSIONS = (8, 9)
_SCOUT, _HELLO, _RESPONSE, _DECLARE, _PUT, _DEL = 1, 2, 0x1B, 0x1E, 1, 2
_, INIT, OPEN, CLOSE, KEEP_ALIVE, FRAME, FRAGMENT, JOIN = range(8)
#: Ids of two extensions of an Init, and of the Put extension for a payload in shared memory.
_LOW_LATENCY_EXT, _COMPRESSION_EXT, _SHARED_MEMORY_EXT = 5, 6, 2
#: Flags of a head: the message is a reply, more fragments follow, extensions follow.
ACK_FLAG, MORE_FLAG, EXT_FLAG = 0x20, 0x40, 0x80
#: Number of batches by which each side opens a session, always readable: Init and Open.
OPENING_BATCHES = 2
_FLAG_BITS = {"A": ACK_FLAG, "M": MORE_FLAG, "Z": EXT_FLAG}
#: The layout of a query inside of a message, with a head of its own.
_QUERY_LAYOUTS = {3: "int?A block?M ext?Z"}


def _read_layout(layout: str, data: Bytes, at: Offsets, end: Offsets, head: Array) -> EndAndNumber:
    """Return the ends of messages, `end` + 1 if they do not fit, and their numbers."""
    at, number = at.copy(), np.full(len(at), -1, np.int64)
    for name, sign, flag in _layout_parts(layout):
        if name == "@":
            number = at.copy()
            continue
        has_flag = head & flag > 0
        rows = np.flatnonzero((at <= end) & (has_flag if sign == "?" else ~has_flag))
        if name == "=int":
            number[rows], at[rows] = _read_varint(data, at[rows], end[rows])
        else:
            at[rows] = _PART_READERS[name](data, at[rows], end[rows], head[rows])
    return at, number


@cache
def _layout_parts(layout: str) -> list[tuple[str, str, int]]:
    """Return name, sign and flag of each part of a layout; flag 0 if it has none."""
    parts = re.findall(r"(=?\w+|@)(?:([?!])(\w+))?", layout)
    return [(name, sign, _FLAG_BITS.get(flag) or int(flag or 0)) for name, sign, flag in parts]


def _read_by_kind(
    layouts: dict[int, str], data: Bytes, at: Offsets, end: Offsets, _: Array
) -> EndAndNumber:
    """Read each message with the layout of its kind; return where it ends, and its number."""
    head, after, number = data[at], end + 1, np.zeros(len(at), np.int64)
    for kind, layout in layouts.items():
        rows = np.flatnonzero(head & 0x1F == kind)
        if len(rows):
            start = at[rows] + 1
            after[rows], number[rows] = _read_layout(layout, data, start, end[rows], head[rows])
    return after, number


# Each reader of a part takes its offset in many messages, the ends and the heads of these
# messages, and returns the offsets of what follows the part.


def _advance(at: Offsets, end: Offsets, count: Array | int) -> Offsets:
    return np.minimum(at + np.minimum(count, 1 << 30), end + 1)


def _read_varint(data: Bytes, at: Offsets, end: Offsets) -> tuple[Array, Offsets]:
    """Return integers of seven bits per byte, the lowest first, and the offsets after them."""
    byte = data[at].astype(np.int64)
    value, after, shift = byte & 0x7F, at + 1, 7
    rows = np.flatnonzero((byte > 0x7F) & (at < end))
    while len(rows):
        byte = data[after[rows]].astype(np.int64)
        # Numbers of nine bytes are not exact; they are not needed.
        value[rows] |= (byte & (0x7F if shift < 56 else 0x3F)) << shift
        after[rows] += 1
        shift += 7
        rows = rows[(byte > 0x7F) & (after[rows] < end[rows])] if shift < 63 else rows[:0]
    return value, np.minimum(after, end + 1)


def _skip_block(data: Bytes, at: Offsets, end: Offsets, _: Array) -> Offsets:
    length, at = _read_varint(data, at, end)
    return _advance(at, end, length)


def _skip_encoding(data: Bytes, at: Offsets, end: Offsets, _: Array) -> Offsets:
    id_, at = _read_varint(data, at, end)
    return _read_layout("block?1", data, at, end, id_)[0]


def _skip_extension_body(data: Bytes, at: Offsets, end: Offsets, head: Array) -> Offsets:
    """Skip what bits 5 and 6 of a head announce: nothing, an integer or a block."""
    encoding = head >> 5 & 3
    after, _ = _read_layout("int?1 block?2", data, at, end, np.where(encoding == 3, 0, encoding))
    return np.where(encoding == 3, end + 1, after)


def _skip_extensions(
    data: Bytes, at: Offsets, end: Offsets, _: Array, ids: Array | None = None
) -> Offsets:
    """Skip extensions; set the bit of each extension's id in `ids`, if given."""
    at, rows = at.copy(), np.flatnonzero(at <= end)
    while len(rows):
        head, last = data[at[rows]], end[rows]
        if ids is not None:
            ids[rows] |= 1 << (head & 0x0F).astype(np.int64)
        at[rows] = _skip_extension_body(data, np.minimum(at[rows] + 1, last + 1), last, head)
        rows = rows[(head & EXT_FLAG > 0) & (at[rows] < last)]
    return at


def _has_extension(data: Bytes, at: Offsets, end: Offsets, wanted: int) -> Array:
    """Return whether one of the extensions has the id ``wanted``."""
    ids = np.zeros(len(at), np.int64)
    _skip_extensions(data, np.where(at < end, at, end + 1), end, at, ids)
    return ids >> wanted & 1 > 0


def _skip_put_or_del(data: Bytes, at: Offsets, end: Offsets, _: Array) -> Offsets:
    """Skip a Put or a Del; an extension says whether a Put is in shared memory."""
    head, kind = data[at], data[at] & 0x1F
    start = np.where((kind == _PUT) | (kind == _DEL), at + 1, end + 1)
    flags = np.where(kind == _PUT, head, head & ~np.uint8(MORE_FLAG))
    start, _ = _read_layout("int?A block?A encoding?M", data, start, end, flags)
    after, _ = _read_layout("ext?Z", data, start, end, head)
    shared = (head & EXT_FLAG > 0) & _has_extension(data, start, after, _SHARED_MEMORY_EXT)
    return _read_layout("block?1 slices?2", data, after, end, (kind == _PUT) * (1 + shared))[0]


def _skip_interest_options(data: Bytes, at: Offsets, end: Offsets, head: Array) -> Offsets:
    options = np.where(head & 0x60 > 0, data[at], 0)
    flags = np.where(options & 0x10 > 0, options & 0x30, 0)
    start = _advance(at, end, (head & 0x60 > 0) * 1)
    return _read_layout("int?16 block?32", data, start, end, flags)[0]


def _skip_repeated(layout: str, data: Bytes, at: Offsets, end: Offsets, _: Array) -> Offsets:
    """Skip a count, and as many repetitions of a layout."""
    count, at = _read_varint(data, at, end)
    while len(rows := np.flatnonzero((count > 0) & (at < end))):
        at[rows], _ = _read_layout(layout, data, at[rows], end[rows], rows)
        count[rows] -= 1
    return np.where(count > 0, end + 1, at)


_PART_READERS: dict[str, Callable[[Bytes, Offsets, Offsets, Array], Offsets]] = {
    "1": lambda _data, at, end, _head: _advance(at, end, 1),
    "3": lambda _data, at, end, _head: _advance(at, end, 3),
    # A version; a byte with the role and the length of the identity; the identity.
    "zid": lambda data, at, end, _head: _advance(at, end, (data[at + 1] >> 4).astype(np.int64) + 3),
    "int": lambda data, at, end, _head: _read_varint(data, at, end)[1],
    "encoding": _skip_encoding,
    "rest": lambda _data, _at, end, _head: end,
    "ext": _skip_extensions,
    "block": _skip_block,
    "body": _skip_extension_body,
    "options": _skip_interest_options,
    "content": _skip_put_or_del,
    "slices": partial(_skip_repeated, "1 block"),
    "locators": partial(_skip_repeated, "block"),
    "query": lambda *given: _read_by_kind(_QUERY_LAYOUTS, *given)[0],
    "answer": lambda *given: _read_by_kind(_LAYOUTS["answer"], *given)[0],
    "declaration": lambda *given: _read_by_kind(_DECLARATIONS, *given)[0],
}


def parse_batches(data: Bytes, at: Offsets, end: Offsets) -> Columns:
    """Return the messages in batches, given the first byte and the end of each batch.

    One row per message: the index of its ``batch``; ``at`` and ``end``; ``code``, an index of
    `MESSAGE_NAMES`; ``head``, its first byte; ``number``, as in its layout. The unreadable rest of
    a batch is a row.
    """
    batch = np.arange(len(at))
    steps: list[tuple[Array, ...]] = [(batch[:0], at[:0], at[:0], batch[:0], batch[:0], batch[:0])]
    while len(at):
        head = data[at]
        kind = head & 0x1F
        after, value = _read_by_kind(_MESSAGES, data, at, end, head)
        flag = np.where((kind == INIT) | (kind == OPEN), head & ACK_FLAG, 0)
        code = np.where(kind < 8, CODES["transport"][kind | flag], CODES["network"][kind])
        declares = np.flatnonzero((kind == _DECLARE) & (after <= end))
        body = value[declares]
        code[declares] = CODES["declare"][data[body] & 0x1F]
        value[declares] = _read_by_kind(_DECLARATIONS, data, body, end[declares], body)[1]
        responds = np.flatnonzero((kind == _RESPONSE) & (after <= end))
        code[responds] = CODES["answer"][data[value[responds]] & 0x1F]
        bad = after > end
        code[bad] = UNREADABLE
        after = np.minimum(after, end)
        steps.append((batch, at, after, code, head, value))
        go_on = (after < end) & ~bad
        batch, at, end = batch[go_on], after[go_on], end[go_on]
    columns = [np.concatenate(parts) for parts in zip(*steps, strict=True)]
    order = np.argsort(columns[0], kind="stable")
    names = ("batch", "at", "end", "code", "head", "number")
    return {name: column[order] for name, column in zip(names, columns, strict=True)}


def key_expressions(data: Bytes, messages: Columns, code: int) -> Iterator[tuple[int, int, bytes]]:
    """Yield the row, scope and suffix of the key expression in each message of a kind.

    The kind is that of a Push or of a declared key expression.
    """
    rows = np.flatnonzero(messages["code"] == code)
    at, end, head = messages["at"][rows] + 1, messages["end"][rows], messages["head"][rows]
    if MESSAGE_ROWS[code]["layer"] == "declare":
        _, at = _read_layout("int?A ext?Z @", data, at, end, head)
        head, (at, _) = data[at], _read_layout("int", data, at + 1, end, head)
    scope, begin = _read_varint(data, at, end)
    length, after = _read_varint(data, begin, end)
    stop = np.where(head & ACK_FLAG > 0, _advance(after, end, length), after)
    columns = (column.tolist() for column in (rows, scope, after, stop))
    for row, prefix, first, last in zip(*columns, strict=True):
        yield row, prefix, data[first:last].tobytes()


def parse_scouting(
    data: Bytes, at: Offsets, size: Array, to_all: Array
) -> tuple[Array, Offsets, Array]:
    """Return each datagram's code, and offset and length of its identity, 0 if it has none.

    The code is `UNREADABLE` unless it is a Scout or Hello. ``to_all`` says which datagrams go to a
    multicast group or to the scouting port.
    """
    role, kind, end = data[at + 2], data[at] & 0x1F, at + size
    scout = (kind == _SCOUT) & to_all
    possible = (scout | (kind == _HELLO)) & np.isin(data[at + 1], READABLE_VERSIONS) & (size >= 3)
    length = ((role >> 4).astype(np.int64) + 1) * (~scout | (role & 8 > 0))
    head = np.where(scout, data[at] & ~np.uint8(ACK_FLAG), data[at])
    after, _ = _read_layout("locators?A ext?Z", data, _advance(at, end, 3 + length), end, head)
    good = possible & (after == end) & ((role & 0x0C == 0) | scout)
    code = np.where(good, CODES["scouting"][kind], UNREADABLE).astype(np.uint8)
    return code, at + 3, np.where(good, length, 0)


def opens_session(data: Bytes, at: Offsets, size: Array) -> Array:
    """Return which batches may open a session."""
    known: Array = np.isin(data[at] & 0x1F, (INIT, JOIN)) & np.isin(data[at + 1], READABLE_VERSIONS)
    return known & (size > 4)


class SessionOpening(NamedTuple):
    """What one side announces when it opens a session."""

    #: The identity of the process; its role: router, peer or client; its version of the protocol.
    zid: bytes
    role: int
    version: int
    #: Whether it replies to the opening of the other side.
    is_reply: bool
    #: The feature, if any, that makes the session unreadable if both sides agree on it.
    unreadable_feature: str


def session_openings(data: Bytes, at: Offsets, end: Offsets) -> dict[int, SessionOpening]:
    """Return the openings of sessions among batches, by index of the batch."""
    rows = np.flatnonzero(opens_session(data, at, end - at))
    at, end = at[rows], end[rows]
    head = data[at]
    after, extensions = _read_by_kind(_MESSAGES, data, at, end, head)
    is_init = head & 0x1F == INIT
    extensions = np.where(is_init & (head & EXT_FLAG > 0), extensions, end)
    features = (_COMPRESSION_EXT, _LOW_LATENCY_EXT)
    compression, low_latency = (_has_extension(data, extensions, end, of) for of in features)
    special = np.select([compression, low_latency], ["compression", "low latency"], "")
    result = {}
    for index in np.flatnonzero(after <= end).tolist():
        begin = int(at[index])
        length = (int(data[begin + 2]) >> 4) + 1
        result[int(rows[index])] = SessionOpening(
            zid=data[begin + 3 : begin + 3 + length].tobytes(),
            role=int(data[begin + 2]) & 3,
            version=int(data[begin + 1]),
            is_reply=bool(is_init[index] and head[index] & ACK_FLAG),
            unreadable_feature=str(special[index]),
        )
    return result


def unreadable_feature(stream: int, reverse: list[int], opened: dict[int, SessionOpening]) -> str:
    """Return the agreed feature that makes a session unreadable, "" if there is none."""
    sides = [opened[side] for side in (stream, reverse[stream]) if side in opened]
    answers = [side for side in sides if side.is_reply]
    features = (side.unreadable_feature for side in answers or sides)
    return next(filter(None, features), "")
