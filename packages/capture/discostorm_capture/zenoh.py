"""Zenoh: how every message of scouting, transport and network is laid out."""

from collections.abc import Callable

import numpy as np

from discostorm.data import read_data
from discostorm_capture._bytes import Array, Bytes, Columns, Places

ROWS = read_data("vendors/zenoh_messages.csv", "discostorm_capture")
NAMES = [row["name"] for row in ROWS] + ["unreadable"]
KINDS = [row["kind"] for row in ROWS] + ["unreadable"]
#: The code of a message, which is its row in the data file, by layer and id.
CODES = {
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
VERSIONS = (8, 9)
_SCOUT, _HELLO = 1, 2
_OAM, INIT, OPEN, CLOSE, KEEP_ALIVE, FRAME, FRAGMENT, JOIN = range(8)
_INTEREST, _RESPONSE_FINAL, _RESPONSE, _REQUEST, _PUSH, _DECLARE, _NETWORK_OAM = range(0x19, 0x20)
_PUT, _DEL, _QUERY, _REPLY, _ERROR = range(1, 6)
LOW_LATENCY, COMPRESSION = 5, 6
#: Flags of a message, and the one that says that extensions follow.
ANSWER, _I, _N, _M, EXTENDED = 0x20, 0x20, 0x20, 0x40, 0x80


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
        open_ = open_[(head & EXTENDED > 0) & (after[open_] < end[open_])]
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
    at = _where(_extensions, data, at, end, head & EXTENDED > 0)
    shared = put & (head & EXTENDED > 0) & has_extension(data, before, at, 2)
    at = _where(_slices, data, at, end, shared)
    return _where(_block, data, at, end, put & ~shared)


def has_extension(data: Bytes, at: Places, end: Places, wanted: int) -> Array:
    """Return whether one of the extensions from here to there has that number."""
    found = np.zeros(len(at), bool)
    open_ = np.flatnonzero(at < end)
    at = at.copy()
    while len(open_):
        head, at[open_] = _extension(data, at[open_], end[open_])
        found[open_] |= head & 0x0F == wanted
        open_ = open_[(head & EXTENDED > 0) & (at[open_] < end[open_])]
    return found


def _query(data: Bytes, at: Places, end: Places) -> Places:
    head = data[at]
    at = np.where(head & 0x1F == _QUERY, np.minimum(at + 1, end + 1), end + 1)
    at = _where(_plain_integer, data, at, end, head & 0x20 > 0)
    at = _where(_block, data, at, end, head & 0x40 > 0)
    return _where(_extensions, data, at, end, head & EXTENDED > 0)


def _answer(data: Bytes, at: Places, end: Places) -> Places:
    head = data[at]
    reply, error = head & 0x1F == _REPLY, head & 0x1F == _ERROR
    at = np.where(reply | error, np.minimum(at + 1, end + 1), end + 1)
    at = _where(_plain_integer, data, at, end, reply & (head & 0x20 > 0))
    at = _where(_encoding, data, at, end, error & (head & 0x40 > 0))
    at = _where(_extensions, data, at, end, head & EXTENDED > 0)
    at = _where(_content, data, at, end, reply)
    return _where(_block, data, at, end, error)


# ---------------------------------------------------------------- messages
# Each takes where messages go on behind their first byte, which it takes, too; it returns where
# they end and a number that they have: what is declared, where a fragment's content starts.

Layout = Callable[[Bytes, Places, Places, Array], tuple[Places, Array]]


def _zid(data: Bytes, at: Places, end: Places) -> Places:
    """Read a version, a role and an identity."""
    length = (data[at + 1] >> 4).astype(np.int64) + 1
    return _skip(at, end, 2 + length)


def read_init(data: Bytes, at: Places, end: Places, head: Array) -> tuple[Places, Array]:
    """Read an Init; the number is the place where its extensions start."""
    at = _skip(_zid(data, at, end), end, 3 * (head & 0x40 > 0))
    at = _where(_block, data, at, end, head & ANSWER > 0)
    return _where(_extensions, data, at, end, head & EXTENDED > 0), at


def _open(data: Bytes, at: Places, end: Places, head: Array) -> tuple[Places, Array]:
    at = _plain_integer(data, _plain_integer(data, at, end), end)
    at = _where(_block, data, at, end, head & ANSWER == 0)
    return _where(_extensions, data, at, end, head & EXTENDED > 0), at


def _close(data: Bytes, at: Places, end: Places, head: Array) -> tuple[Places, Array]:
    return _where(_extensions, data, np.minimum(at + 1, end + 1), end, head & EXTENDED > 0), at


def _keep_alive(data: Bytes, at: Places, end: Places, head: Array) -> tuple[Places, Array]:
    return _where(_extensions, data, at, end, head & EXTENDED > 0), at


def _frame(data: Bytes, at: Places, end: Places, head: Array) -> tuple[Places, Array]:
    number_, at = _integer(data, at, end)
    return _where(_extensions, data, at, end, head & EXTENDED > 0), number_


def _fragment(data: Bytes, at: Places, end: Places, head: Array) -> tuple[Places, Array]:
    after, _ = _frame(data, at, end, head)
    return np.where(after <= end, end, after), after


def read_join(data: Bytes, at: Places, end: Places, head: Array) -> tuple[Places, Array]:
    """Read a Join, by which a member of a group opens its side."""
    at = _skip(_zid(data, at, end), end, 3 * (head & 0x40 > 0))
    for _ in range(3):
        at = _plain_integer(data, at, end)
    return _where(_extensions, data, at, end, head & EXTENDED > 0), at


def _oam(data: Bytes, at: Places, end: Places, head: Array) -> tuple[Places, Array]:
    number_, at = _integer(data, at, end)
    at = _where(_extensions, data, at, end, head & EXTENDED > 0)
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
    return _where(_extensions, data, at, end, head & EXTENDED > 0), number_


def _declare(data: Bytes, at: Places, end: Places, head: Array) -> tuple[Places, Array]:
    at = _where(_plain_integer, data, at, end, head & _I > 0)
    at = _where(_extensions, data, at, end, head & EXTENDED > 0)
    body = data[at]
    kind = body & 0x1F
    at = np.minimum(at + 1, end + 1)
    known = CODES["declare"][kind] != UNREADABLE
    numbered = known & (kind != 0x1A)
    number_ = np.full(len(at), -1, np.int64)
    index = np.flatnonzero(numbered & (at <= end))
    number_[index], at[index] = _integer(data, at[index], end[index])
    new = numbered & (kind & 1 == 0)
    at = _where(_plain_integer, data, at, end, new)
    at = _where(_block, data, at, end, new & (body & _N > 0))
    at = _where(_extensions, data, at, end, body & EXTENDED > 0)
    # What is declared goes along with its number.
    return np.where(known, at, end + 1), number_ << 8 | CODES["declare"][kind]


def _push(data: Bytes, at: Places, end: Places, head: Array) -> tuple[Places, Array]:
    at = _expression(data, at, end, head & _N > 0)
    at = _where(_extensions, data, at, end, head & EXTENDED > 0)
    return _where(_content, data, at, end, at < end + 1), at


def _request(data: Bytes, at: Places, end: Places, head: Array) -> tuple[Places, Array]:
    number_, at = _integer(data, at, end)
    at = _expression(data, at, end, head & _N > 0)
    at = _where(_extensions, data, at, end, head & EXTENDED > 0)
    return _where(_query, data, at, end, at < end + 1), number_


def _response(data: Bytes, at: Places, end: Places, head: Array) -> tuple[Places, Array]:
    number_, at = _integer(data, at, end)
    at = _expression(data, at, end, head & _N > 0)
    at = _where(_extensions, data, at, end, head & EXTENDED > 0)
    return _where(_answer, data, at, end, at < end + 1), number_


_MESSAGES: dict[int, Layout] = {
    _OAM: _oam,
    INIT: read_init,
    OPEN: _open,
    CLOSE: _close,
    KEEP_ALIVE: _keep_alive,
    FRAME: _frame,
    FRAGMENT: _fragment,
    JOIN: read_join,
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
        flag_a = np.where((kind == INIT) | (kind == OPEN), head & ANSWER, 0)
        code = np.where(kind < 8, CODES["transport"][kind | flag_a], CODES["network"][kind])
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


def scopes(data: Bytes, at: Places, end: Places) -> Array:
    """Return the number of the key expression that each declaration refers to, 0 if to none."""
    head = data[at]
    at = _where(_plain_integer, data, at + 1, end, head & _I > 0)
    at = _where(_extensions, data, at, end, head & EXTENDED > 0)
    return _integer(data, _plain_integer(data, at + 1, end), end)[0]


# ---------------------------------------------------------------- datagrams


def scouting(data: Bytes, at: Places, size: Array, to_all: Array) -> tuple[Array, Columns]:
    """Return the code of each datagram, `UNREADABLE` if it is no Scout or Hello, and its identity.

    ``to_all`` says which go to a group or to the port of scouting. Of the identity the table
    has where it stands, ``at``, and its ``length``, 0 if it is not told.
    """
    code = np.full(len(at), UNREADABLE, np.uint8)
    place, length = np.zeros(len(at), np.int64), np.zeros(len(at), np.int64)
    told = np.isin(data[at + 1], VERSIONS) & (size >= 3)
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
        after = _where(_extensions, data, after, end, head & EXTENDED > 0)
        good = index[(after == end) & ((role & 0x0C == 0) | (found == _SCOUT))]
        code[good] = CODES[name][found]
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
    known: Array = np.isin(kind, (INIT, JOIN)) & np.isin(data[at + 1], VERSIONS)
    return known & (size > 4)
