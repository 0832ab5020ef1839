"""Zenoh over UDP: which datagrams are of its sessions; each of them is a batch."""

from collections import Counter

import numpy as np

from discostorm_capture import zenoh
from discostorm_capture._bytes import (
    Array,
    Bytes,
    Columns,
    buffer,
    codes,
    stack,
    take,
    times_before,
    view,
)
from discostorm_capture.zenoh_streams import Opening, openings_at, special_of

#: So much of a session whose start was not captured must be readable as Zenoh.
_ALIKE = 0.8
#: How many batches open a session for each side: Init and Open.
_TO_OPEN = 2


def sessions(
    parts: list[tuple[Bytes, Columns]], notes: Counter[str]
) -> tuple[Bytes, Columns, dict[int, Opening], Array]:
    """Return the datagrams of Zenoh's sessions, in the order of their frames.

    Where a session is opened says where else to look: packets are read in parts, and what
    fragments of IP make is a part of its own.

    Parameters
    ----------
    parts : list of tuple
        Where the bytes of datagrams are, and what `ip.datagrams` says of them.
    notes : Counter
        What is not read is counted here.

    Returns
    -------
    tuple
        The bytes; the datagrams with ``at``, ``end`` and the ``stream`` that each is of, one
        direction of a session; what opens a stream; and of each stream the other direction.
    """
    ends = np.unique(np.concatenate([np.zeros(0, np.int64), *(_opened(*part) for part in parts)]))
    data, table = _pool([(data, _of_sessions(found, ends)) for data, found in parts])
    there, back = _ends(table)
    stream, first = codes(there, back)
    pairs = list(zip(there[first].tolist(), back[first].tolist(), strict=True))
    number_of = {pair: index for index, pair in enumerate(pairs)}
    reverse = np.array([number_of.get((b, a), -1) for a, b in pairs], np.int64)
    openings = openings_at(data, table["at"], table["end"])
    opened = {int(stream[row]): openings[row] for row in sorted(openings, reverse=True)}
    begun = np.zeros(len(pairs) + 1, bool)  # the last one: there is no other direction
    begun[[*opened]] = True
    begun = begun[:-1] | begun[reverse]
    if not begun.all():
        begun |= _alike(data, table, stream)
    kept = begun[stream]
    if lost := int(np.count_nonzero(~kept)):
        notes[
            "UDP datagrams at ports of Zenoh that are not read: they are no batches of it, or "
            "encrypted or compressed"
        ] += lost
    sides = reverse.tolist()
    for of in range(len(pairs)):
        if special := special_of(of, sides, opened):
            rest = (stream == of) & (times_before(stream) >= _TO_OPEN)
            notes[f"bytes of Zenoh sessions with {special}"] += int(table["wire"][rest].sum())
            kept &= ~rest
    return data, take(table | {"stream": stream}, kept), opened, reverse


def _opened(data: Bytes, found: Columns) -> Array:
    """Return the ends, address and port, of whatever opens a session in a part."""
    opening = np.flatnonzero(zenoh.may_open(data, found["at"], found["size"]))
    if not len(opening):
        return opening
    at, end = found["at"][opening], (found["at"] + found["size"])[opening]
    first = zenoh.parse(data, at, end)
    whole = np.zeros(len(opening), bool)
    whole[first["batch"][first["end"] == end[first["batch"]]]] = True
    whole[first["batch"][first["code"] == zenoh.UNREADABLE]] = False
    ends: Array = np.concatenate(_ends(take(found, opening[whole])))
    return ends


def _ends(found: Columns) -> tuple[Array, Array]:
    """Return where datagrams are from and where they go to, each a number."""
    source, target, from_port, to_port = (
        found[key].astype(np.int64) for key in ("source", "target", "from_port", "to_port")
    )
    return source << 32 | from_port, target << 32 | to_port


def _of_sessions(found: Columns, ends: Array) -> Columns:
    """Return what is sent to an end of a session, or from or to Zenoh's port."""
    _, back = _ends(found)
    port = (found["from_port"] == zenoh.PORT) | (found["to_port"] == zenoh.PORT)
    return take(found, port | np.isin(back, ends))


def _pool(parts: list[tuple[Bytes, Columns]]) -> tuple[Bytes, Columns]:
    """Return the datagrams of all parts, with their bytes one after the other."""
    table = stack([found for _, found in parts])
    size = table["size"].astype(np.int64)
    end = np.cumsum(size)
    pool = buffer(int(size.sum()))
    whole, place = view(pool), 0
    for data, found in parts:
        bytes_ = view(data)
        for at, many in zip(found["at"].tolist(), found["size"].tolist(), strict=True):
            whole[place : place + many] = bytes_[at : at + many]
            place += many
    order = np.argsort(table["frame"], kind="stable")
    return pool, take(table | {"at": end - size, "end": end}, order)


def _alike(data: Bytes, table: Columns, stream: Array) -> Array:
    """Return of each stream whether nearly all of its datagrams can be read as batches."""
    found = zenoh.parse(data, table["at"], table["end"])
    good = np.zeros(len(stream), bool)
    good[found["batch"]] = True  # not of an empty one
    good[found["batch"][found["code"] == zenoh.UNREADABLE]] = False
    readable, all_ = np.bincount(stream, good), np.bincount(stream)
    alike: Array = readable >= _ALIKE * all_
    return alike
