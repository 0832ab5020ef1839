"""Zenoh: every message of scouting, transport and network, in datagrams and TCP streams."""

from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from discostorm.capture._bytes import Array, Bytes, Columns, Places, number, take, view
from discostorm.capture.tcp import Content, Streams
from discostorm.data import read_data

ROWS = read_data("vendors/zenoh_messages.csv")
NAMES = [row["name"] for row in ROWS] + ["unreadable"]
KINDS = [row["kind"] for row in ROWS] + ["unreadable"]
#: The code of a message, which is its row in the data file, by layer and id.
_CODES = {
    layer: np.array(
        [
            next(
                (
                    code
                    for code, row in enumerate(ROWS)
                    if row["layer"] == layer and int(row["id"], 16) == id_
                ),
                len(ROWS),
            )
            for id_ in range(64)
        ],
        np.uint8,
    )
    for layer in ("scouting", "transport", "network", "declare")
}
UNREADABLE = len(ROWS)
PORT, SCOUTING_PORT = 7447, 7446
#: The versions of the protocol that are known to be alike in what is read here.
_VERSIONS = (8, 9)
_SCOUT, _HELLO = 1, 2
_OAM, _INIT, _OPEN, _CLOSE, _KEEP_ALIVE, _FRAME, _FRAGMENT, _JOIN = range(8)
_INTEREST, _RESPONSE_FINAL, _RESPONSE, _REQUEST, _PUSH, _DECLARE, _NETWORK_OAM = range(0x19, 0x20)
_PUT, _DEL, _QUERY, _REPLY, _ERROR = range(1, 6)
_LOW_LATENCY, _COMPRESSION = 5, 6
#: Flags of a message, and the one that says that extensions follow.
_A, _I, _N, _M, _Z = 0x20, 0x20, 0x20, 0x40, 0x80


# ---------------------------------------------------------------- parts of messages
# Each takes where a part of many messages starts, and where the messages end, and returns
# where the part ends: one behind the end of the message if it does not fit in there.


def _skip(at: Places, end: Places, many: Array) -> Places:
    return np.minimum(at + np.minimum(many, 1 << 30), end + 1)


def _integer(data: Bytes, at: Places, end: Places) -> tuple[Array, Places]:
    """Read integers of seven bits a byte, the lowest first; return them, too."""
    byte = data[at].astype(np.int64)
    value = byte & 0x7F
    after = at + 1
    open_ = np.flatnonzero((byte > 0x7F) & (at < end))
    shift = 7
    while len(open_):
        byte = data[after[open_]].astype(np.int64)
        # The ninth byte has all its bits; such numbers are not needed exactly.
        value[open_] |= (byte & (0x7F if shift < 56 else 0x3F)) << shift
        after[open_] += 1
        shift += 7
        open_ = open_[(byte > 0x7F) & (after[open_] < end[open_])] if shift < 63 else open_[:0]
    return value, np.minimum(after, end + 1)


def _block(data: Bytes, at: Places, end: Places) -> Places:
    """Read a length and as many bytes."""
    length, at = _integer(data, at, end)
    return _skip(at, end, length)


def _where(
    read: Callable[[Bytes, Places, Places], Places],
    data: Bytes,
    at: Places,
    end: Places,
    when: Array,
) -> Places:
    """Read a part that only some of the messages have."""
    index = np.flatnonzero(when & (at <= end))
    if len(index) == len(at):
        return read(data, at, end)
    if len(index):
        at = at.copy()
        at[index] = read(data, at[index], end[index])
    return at


def _plain_integer(data: Bytes, at: Places, end: Places) -> Places:
    return _integer(data, at, end)[1]


def _extension(data: Bytes, at: Places, end: Places) -> tuple[Array, Places]:
    """Read an extension; return its first byte, too."""
    head = data[at]
    after = np.minimum(at + 1, end + 1)
    encoding = head >> 5 & 3
    after = _where(_plain_integer, data, after, end, encoding == 1)
    after = _where(_block, data, after, end, encoding == 2)
    return head, np.where(encoding == 3, end + 1, after)


def _extensions(data: Bytes, at: Places, end: Places) -> Places:
    """Read extensions, each of which says whether another one follows."""
    after = at.copy()
    open_ = np.arange(len(at))
    while len(open_):
        head, after[open_] = _extension(data, after[open_], end[open_])
        open_ = open_[(head & _Z > 0) & (after[open_] < end[open_])]
    return after


def _expression(data: Bytes, at: Places, end: Places, named: Array) -> Places:
    """Read a key expression: a number and, if it is named, a text."""
    return _where(_block, data, _plain_integer(data, at, end), end, named)


def _timestamp(data: Bytes, at: Places, end: Places) -> Places:
    return _block(data, _plain_integer(data, at, end), end)


def _encoding(data: Bytes, at: Places, end: Places) -> Places:
    id_, at = _integer(data, at, end)
    return _where(_block, data, at, end, id_ & 1 > 0)


def _slices(data: Bytes, at: Places, end: Places) -> Places:
    """Read a payload in shared memory: how many slices, and of each a kind and a block."""
    count, after = _integer(data, at, end)
    count = np.minimum(count, end - at)
    open_ = np.flatnonzero(count > 0)
    while len(open_):
        after[open_] = _block(data, np.minimum(after[open_] + 1, end[open_]), end[open_])
        count[open_] -= 1
        open_ = open_[(count[open_] > 0) & (after[open_] < end[open_])]
    return after


def _content(data: Bytes, at: Places, end: Places) -> Places:
    """Read a Put or a Del, what a Push or a Reply carries."""
    head = data[at]
    kind = head & 0x1F
    put = kind == _PUT
    at = np.where(put | (kind == _DEL), np.minimum(at + 1, end + 1), end + 1)
    at = _where(_timestamp, data, at, end, head & 0x20 > 0)
    at = _where(_encoding, data, at, end, put & (head & 0x40 > 0))
    before = at
    at = _where(_extensions, data, at, end, head & _Z > 0)
    shared = put & (head & _Z > 0) & _has_extension(data, before, at, 2)
    at = _where(_slices, data, at, end, shared)
    return _where(_block, data, at, end, put & ~shared)


def _has_extension(data: Bytes, at: Places, end: Places, wanted: int) -> Array:
    """Return whether one of the extensions from here to there has that number."""
    found = np.zeros(len(at), bool)
    open_ = np.flatnonzero(at < end)
    at = at.copy()
    while len(open_):
        head, at[open_] = _extension(data, at[open_], end[open_])
        found[open_] |= head & 0x0F == wanted
        open_ = open_[(head & _Z > 0) & (at[open_] < end[open_])]
    return found


def _query(data: Bytes, at: Places, end: Places) -> Places:
    head = data[at]
    at = np.where(head & 0x1F == _QUERY, np.minimum(at + 1, end + 1), end + 1)
    at = _where(_plain_integer, data, at, end, head & 0x20 > 0)
    at = _where(_block, data, at, end, head & 0x40 > 0)
    return _where(_extensions, data, at, end, head & _Z > 0)


def _answer(data: Bytes, at: Places, end: Places) -> Places:
    head = data[at]
    reply, error = head & 0x1F == _REPLY, head & 0x1F == _ERROR
    at = np.where(reply | error, np.minimum(at + 1, end + 1), end + 1)
    at = _where(_plain_integer, data, at, end, reply & (head & 0x20 > 0))
    at = _where(_encoding, data, at, end, error & (head & 0x40 > 0))
    at = _where(_extensions, data, at, end, head & _Z > 0)
    at = _where(_content, data, at, end, reply)
    return _where(_block, data, at, end, error)


# ---------------------------------------------------------------- messages
# Each takes where messages go on behind their first byte, which it takes, too; it returns where
# they end and a number that they have: what is declared, where a fragment's content starts.

Message = Callable[[Bytes, Places, Places, Array], tuple[Places, Array]]


def _zid(data: Bytes, at: Places, end: Places) -> Places:
    """Read a version, a role and an identity."""
    length = (data[at + 1] >> 4).astype(np.int64) + 1
    return _skip(at, end, 2 + length)


def _init(data: Bytes, at: Places, end: Places, head: Array) -> tuple[Places, Array]:
    at = _skip(_zid(data, at, end), end, 3 * (head & 0x40 > 0))
    at = _where(_block, data, at, end, head & _A > 0)
    return _where(_extensions, data, at, end, head & _Z > 0), at


def _open(data: Bytes, at: Places, end: Places, head: Array) -> tuple[Places, Array]:
    at = _plain_integer(data, _plain_integer(data, at, end), end)
    at = _where(_block, data, at, end, head & _A == 0)
    return _where(_extensions, data, at, end, head & _Z > 0), at


def _close(data: Bytes, at: Places, end: Places, head: Array) -> tuple[Places, Array]:
    return _where(_extensions, data, np.minimum(at + 1, end + 1), end, head & _Z > 0), at


def _keep_alive(data: Bytes, at: Places, end: Places, head: Array) -> tuple[Places, Array]:
    return _where(_extensions, data, at, end, head & _Z > 0), at


def _frame(data: Bytes, at: Places, end: Places, head: Array) -> tuple[Places, Array]:
    number_, at = _integer(data, at, end)
    return _where(_extensions, data, at, end, head & _Z > 0), number_


def _fragment(data: Bytes, at: Places, end: Places, head: Array) -> tuple[Places, Array]:
    after, _ = _frame(data, at, end, head)
    return np.where(after <= end, end, after), after


def _join(data: Bytes, at: Places, end: Places, head: Array) -> tuple[Places, Array]:
    at = _skip(_zid(data, at, end), end, 3 * (head & 0x40 > 0))
    for _ in range(3):
        at = _plain_integer(data, at, end)
    return _where(_extensions, data, at, end, head & _Z > 0), at


def _oam(data: Bytes, at: Places, end: Places, head: Array) -> tuple[Places, Array]:
    number_, at = _integer(data, at, end)
    at = _where(_extensions, data, at, end, head & _Z > 0)
    encoding = head >> 5 & 3
    at = _where(_plain_integer, data, at, end, encoding == 1)
    at = _where(_block, data, at, end, encoding == 2)
    return np.where(encoding == 3, end + 1, at), number_


def _interest(data: Bytes, at: Places, end: Places, head: Array) -> tuple[Places, Array]:
    number_, at = _integer(data, at, end)
    asks = head & 0x60 > 0
    options = np.where(asks, data[at], 0)
    at = _skip(at, end, asks.astype(np.int64))
    restricted = options & 0x10 > 0
    at = _where(_plain_integer, data, at, end, restricted)
    at = _where(_block, data, at, end, restricted & (options & 0x20 > 0))
    return _where(_extensions, data, at, end, head & _Z > 0), number_


def _declare(data: Bytes, at: Places, end: Places, head: Array) -> tuple[Places, Array]:
    at = _where(_plain_integer, data, at, end, head & _I > 0)
    at = _where(_extensions, data, at, end, head & _Z > 0)
    body = data[at]
    kind = body & 0x1F
    at = np.minimum(at + 1, end + 1)
    known = _CODES["declare"][kind] != UNREADABLE
    numbered = known & (kind != 0x1A)
    number_ = np.full(len(at), -1, np.int64)
    index = np.flatnonzero(numbered & (at <= end))
    number_[index], at[index] = _integer(data, at[index], end[index])
    new = numbered & (kind & 1 == 0)
    at = _where(_plain_integer, data, at, end, new)
    at = _where(_block, data, at, end, new & (body & _N > 0))
    at = _where(_extensions, data, at, end, body & _Z > 0)
    # What is declared goes along with its number.
    return np.where(known, at, end + 1), number_ << 8 | _CODES["declare"][kind]


def _push(data: Bytes, at: Places, end: Places, head: Array) -> tuple[Places, Array]:
    at = _expression(data, at, end, head & _N > 0)
    at = _where(_extensions, data, at, end, head & _Z > 0)
    return _where(_content, data, at, end, at < end + 1), at


def _request(data: Bytes, at: Places, end: Places, head: Array) -> tuple[Places, Array]:
    number_, at = _integer(data, at, end)
    at = _expression(data, at, end, head & _N > 0)
    at = _where(_extensions, data, at, end, head & _Z > 0)
    return _where(_query, data, at, end, at < end + 1), number_


def _response(data: Bytes, at: Places, end: Places, head: Array) -> tuple[Places, Array]:
    number_, at = _integer(data, at, end)
    at = _expression(data, at, end, head & _N > 0)
    at = _where(_extensions, data, at, end, head & _Z > 0)
    return _where(_answer, data, at, end, at < end + 1), number_


_MESSAGES: dict[int, Message] = {
    _OAM: _oam,
    _INIT: _init,
    _OPEN: _open,
    _CLOSE: _close,
    _KEEP_ALIVE: _keep_alive,
    _FRAME: _frame,
    _FRAGMENT: _fragment,
    _JOIN: _join,
    _INTEREST: _interest,
    _RESPONSE_FINAL: _frame,
    _RESPONSE: _response,
    _REQUEST: _request,
    _PUSH: _push,
    _DECLARE: _declare,
    _NETWORK_OAM: _oam,
}


def parse(data: Bytes, at: Places, end: Places) -> Columns:
    """Return the messages in batches.

    Parameters
    ----------
    data : numpy.ndarray
        Where the batches are.
    at, end : numpy.ndarray
        Of each its first byte, and the one behind its last.

    Returns
    -------
    dict
        One row a message: its ``batch``; ``at`` and ``end``; its ``code``, a place in `NAMES`;
        ``head``, its first byte; ``number``, of what it declares, or the place where the
        content of a fragment starts. What cannot be read is a message, too.
    """
    batch = np.arange(len(at))
    none = np.zeros(0, np.int64)
    steps = [(batch[:0], at[:0], at[:0], none.astype(np.uint8), none.astype(np.uint8), none)]
    while len(at):
        head = data[at]
        kind = head & 0x1F
        after, value = end + 1, np.zeros(len(at), np.int64)
        for which, read in _MESSAGES.items():
            mine = np.flatnonzero(kind == which)
            if len(mine) == len(at):
                after, value = read(data, at + 1, end, head)
            elif len(mine):
                after[mine], value[mine] = read(data, at[mine] + 1, end[mine], head[mine])
        flag_a = np.where((kind == _INIT) | (kind == _OPEN), head & _A, 0)
        code = np.where(kind < 8, _CODES["transport"][kind | flag_a], _CODES["network"][kind])
        declares = kind == _DECLARE
        code = np.where(declares, value & 0xFF, code).astype(np.uint8)
        value = np.where(declares, value >> 8, value)
        bad = after > end
        code[bad] = UNREADABLE
        after = np.minimum(after, end)
        steps.append((batch, at, after, code, head, value))
        open_ = after < end
        open_ &= ~bad
        batch, at, end = batch[open_], after[open_], end[open_]
    columns = [np.concatenate(parts) for parts in zip(*steps, strict=True)]
    order = np.argsort(columns[0], kind="stable")
    names = ("batch", "at", "end", "code", "head", "number")
    return {name: column[order] for name, column in zip(names, columns, strict=True)}


# ---------------------------------------------------------------- datagrams


def scouting(data: Bytes, at: Places, size: Array, to_all: Array) -> tuple[Array, Columns]:
    """Return the code of each datagram, `UNREADABLE` if it is no Scout or Hello, and its identity.

    ``to_all`` says which go to a group or to the port of scouting. Of the identity the table
    has where it stands, ``at``, and its ``length``, 0 if it is not told.
    """
    code = np.full(len(at), UNREADABLE, np.uint8)
    place, length = np.zeros(len(at), np.int64), np.zeros(len(at), np.int64)
    told = np.isin(data[at + 1], _VERSIONS) & (size >= 3)
    kind = data[at] & 0x1F
    for found, name in ((_SCOUT, "scouting"), (_HELLO, "scouting")):
        index = np.flatnonzero(told & (kind == found) & (to_all if found == _SCOUT else True))
        here, head, role = at[index], data[at[index]], data[at[index] + 2]
        end = here + size[index]
        many = (role >> 4).astype(np.int64) + 1
        if found == _SCOUT:
            many = np.where(role & 8 > 0, many, 0)
        after = _skip(here, end, 3 + many)
        if found == _HELLO:
            after = _where(_locators, data, after, end, head & 0x20 > 0)
        after = _where(_extensions, data, after, end, head & _Z > 0)
        good = index[(after == end) & ((role & 0x0C == 0) | (found == _SCOUT))]
        code[good] = _CODES[name][found]
        place[good] = at[good] + 3
        length[good] = many[np.searchsorted(index, good)]
    return code, {"at": place, "length": length}


def _locators(data: Bytes, at: Places, end: Places) -> Places:
    count, after = _integer(data, at, end)
    open_ = np.flatnonzero(count > 0)
    while len(open_):
        after[open_] = _block(data, after[open_], end[open_])
        count[open_] -= 1
        open_ = open_[(count[open_] > 0) & (after[open_] < end[open_])]
    return np.where(count > 0, end + 1, after)


def may_open(data: Bytes, at: Places, size: Array) -> Array:
    """Return which datagrams may start a session of Zenoh over UDP."""
    kind = data[at] & 0x1F
    known: Array = np.isin(kind, (_INIT, _JOIN)) & np.isin(data[at + 1], _VERSIONS)
    return known & (size > 4)


# ---------------------------------------------------------------- streams


def is_batch(data: Bytes, at: Places, size: Array) -> Array:
    """Return which segments look as if they started with a batch of Zenoh."""
    length = number(data, at, "<u2").astype(np.int64)
    head = data[at + 2]
    kind = head & 0x1F
    plain = head & _Z == 0
    alike: Array = (
        ((kind == _KEEP_ALIVE) & plain & (length == 1))
        | ((kind == _CLOSE) & plain & (length == 2))
        | ((kind == _FRAME) & (length > 3))
        | ((kind == _FRAGMENT) & (length > 3))
        | ((kind == _OPEN) & (length > 3) & (length + 2 == size))
    )
    return alike & (size > 2)


def is_init(data: Bytes, at: Places, size: Array) -> Array:
    """Return which segments are an Init, the first that each side of a session sends."""
    length = number(data, at, "<u2").astype(np.int64)
    found: Array = (
        (size > 6)
        & (length + 2 == size)
        & (data[at + 2] & 0x1F == _INIT)
        & np.isin(data[at + 3], _VERSIONS)
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
    known_port[stream[(table["from_port"][rows] == PORT) | (table["to_port"][rows] == PORT)]] = True
    begun = ~streams.complete & (alike >= 0.8 * all_) & (alike >= np.where(known_port, 1, 3))
    found = init | begun
    found |= found[streams.reverse]
    return np.flatnonzero(found)


def undecided(streams: Streams, chosen: Array) -> Array:
    """Return the other streams of Zenoh's port of which the start was captured.

    Their first segment may be too short to tell.
    """
    table = streams.table
    at_port = (table["from_port"] == PORT) | (table["to_port"] == PORT)
    found = np.unique(table["stream"][at_port & (table["size"] > 0)])
    return np.setdiff1d(found[streams.complete[found]], chosen)


@dataclass(frozen=True)
class Session:
    """What one side said when it opened a session."""

    zid: bytes
    role: int
    acknowledges: bool
    special: str


def sessions(content: Content) -> dict[int, Session]:
    """Return what each stream of which the start was captured says first."""
    data, runs = content.data, take(content.runs, content.runs["start"])
    runs = take(runs, runs["end"] - runs["at"] >= 6)
    at = runs["at"]
    end = np.minimum(at + 2 + number(data, at, "<u2"), runs["end"])
    head = data[at + 2]
    after, place = _init(data, at + 3, end, head)
    good = (head & 0x1F == _INIT) & (after <= end)
    low_latency, compression = (
        good & (head & _Z > 0) & _has_extension(data, place, end, which)
        for which in (_LOW_LATENCY, _COMPRESSION)
    )
    found = {}
    for index in np.flatnonzero(good).tolist():
        here = int(at[index])
        length = (int(data[here + 4]) >> 4) + 1
        found[int(runs["stream"][index])] = Session(
            data[here + 5 : here + 5 + length].tobytes(),
            int(data[here + 4]) & 3,
            bool(head[index] & _A),
            "compression" * bool(compression[index]) or "low latency" * bool(low_latency[index]),
        )
    return found


def batches(
    content: Content, streams: Streams, opened: dict[int, Session], notes: Counter[str]
) -> Columns:
    """Return where each batch in streams starts and ends, and its ``stream``."""
    data, runs, pieces = content.data, content.runs, content.pieces
    reverse = streams.reverse.tolist()
    special = [_special(stream, reverse, opened) for stream in runs["stream"].tolist()]
    # Zenoh writes whole batches, so that most segments hold nothing else.
    run = np.searchsorted(runs["at"], pieces["at"], side="right") - 1
    piece, at, end = _whole_batches(data, pieces["at"], pieces["at"] + pieces["size"])
    whole = np.bincount(run[piece[end < 0]], minlength=len(special)) == 0
    whole &= np.array([not word for word in special], bool)
    mine = whole[run[piece]]
    parts = [(at[mine], end[mine], runs["stream"][run[piece[mine]]])]
    # Of the others batch by batch.
    content_ = view(data)
    cut = 0
    for index in np.flatnonzero(~whole).tolist():
        here, last, stream, start = (column[index].item() for column in runs.values())
        word = special[index]
        found: list[int] = []
        if not start:
            aligned = last if word else _aligned(content, here, last)
            cut += aligned - here
            here = aligned
        # The opening of a session can be read in any case.
        while here + 3 <= last and not (word and len(found) == 2):
            after = here + 2 + content_[here] + 256 * content_[here + 1]
            if after > last or after == here + 2:
                break
            found.append(here)
            here = after
        if word:
            notes[f"bytes of Zenoh sessions with {word}"] += int(runs["end"][index]) - here
        else:
            cut += last - here
        if found:
            begin = np.array(found, np.int64)
            parts.append((begin + 2, np.append(begin[1:], here), np.full(len(begin), stream)))
    if cut:
        notes["bytes of Zenoh streams next to gaps or to their ends"] += cut
    if gaps := len(special) - len(np.unique(runs["stream"])):
        notes["gaps in TCP streams of Zenoh, of what was not captured"] += gaps
    columns = [np.concatenate(column) for column in zip(*parts, strict=True)]
    order = np.argsort(columns[0], kind="stable")
    return dict(zip(("at", "end", "stream"), (column[order] for column in columns), strict=True))


def _whole_batches(data: Bytes, at: Places, end: Places) -> tuple[Array, Places, Places]:
    """Return the batches in pieces: which piece each is of, and where it starts and ends.

    If they do not fill a piece, it has one with the end -1.
    """
    which = np.arange(len(at))
    steps = [(which[:0], at[:0], end[:0])]
    while len(at):
        length = number(data, at, "<u2").astype(np.int64)
        after = at + 2 + length
        good = (length > 0) & (after <= end)
        steps.append((which, at + 2, np.where(good, after, -1)))
        open_ = good & (after < end)
        which, at, end = which[open_], after[open_], end[open_]
    piece, first, last = (np.concatenate(parts) for parts in zip(*steps, strict=True))
    return piece, first, last


def _special(stream: int, reverse: list[int], opened: dict[int, Session]) -> str:
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
    good = np.flatnonzero(is_batch(content.data, places, sizes))
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
    is_fragment = found["code"] == _CODES["transport"][_FRAGMENT]
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
            bytes(b & 0x7F for b in data[place + 1 : place + 3].tolist()) if head & _Z else b""
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
