"""Zenoh over UDP: which datagrams are of its sessions; each of them is a batch."""

from collections import Counter

import numpy as np

from discostorm_capture import zenoh_messages
from discostorm_capture._bytes import Array, Bytes, Columns, cumcount, factorize, note, take_rows
from discostorm_capture.ip import sockets
from discostorm_capture.zenoh_messages import Opening, openings, parse_batches, reason_unreadable

#: The share of a session's datagrams that must be readable if its start was not captured.
_MIN_READABLE = 0.8


def sessions(
    data: Bytes, datagrams: Columns, notes: Counter[str]
) -> tuple[Columns, dict[int, Opening], Array]:
    """Return the datagrams of sessions by ``stream``, a direction; openings; other directions."""
    datagrams = datagrams | {"end": datagrams["at"] + datagrams["size"]}
    sender, receiver = sockets(datagrams)
    opening = np.flatnonzero(zenoh_messages.may_open(data, datagrams["at"], datagrams["size"]))
    opening = opening[_is_readable(data, take_rows(datagrams, opening))]
    ports = datagrams["from_port"], datagrams["to_port"]
    at_port = (ports[0] == zenoh_messages.PORT) | (ports[1] == zenoh_messages.PORT)
    ends = np.concatenate([sender[opening], receiver[opening]])
    rows = np.flatnonzero(at_port | np.isin(receiver, ends))
    table, sender, receiver = take_rows(datagrams, rows), sender[rows], receiver[rows]
    stream, first = factorize(sender, receiver)
    pairs = list(zip(sender[first].tolist(), receiver[first].tolist(), strict=True))
    number_of = {pair: number for number, pair in enumerate(pairs)}
    reverse = np.array([number_of.get((b, a), -1) for a, b in pairs], np.int64)
    opened: dict[int, Opening] = {}
    for row, session in openings(data, table["at"], table["end"]).items():
        opened.setdefault(int(stream[row]), session)
    is_zenoh = np.zeros(len(pairs) + 1, bool)  # the last one: no other direction
    is_zenoh[[*opened]] = True
    is_zenoh = is_zenoh[:-1] | is_zenoh[reverse]
    readable = np.bincount(stream, _is_readable(data, table), len(pairs))
    is_zenoh |= readable >= _MIN_READABLE * np.bincount(stream, minlength=len(pairs))
    kept = is_zenoh[stream]
    note(
        notes,
        ~kept,
        "UDP datagrams at ports of Zenoh that are not read: they are no batches of it, or "
        "encrypted or compressed",
    )
    turn, sides = cumcount(stream), reverse.tolist()
    for number in range(len(pairs)):
        if special := reason_unreadable(number, sides, opened):
            rest = (stream == number) & (turn >= zenoh_messages.TO_OPEN)
            notes[f"bytes of Zenoh sessions with {special}"] += int(table["wire"][rest].sum())
            kept &= ~rest
    return take_rows(table | {"stream": stream}, kept), opened, reverse


def _is_readable(data: Bytes, datagrams: Columns) -> Array:
    """Return which datagrams are batches that can be read to their end."""
    messages = parse_batches(data, datagrams["at"], datagrams["end"])
    readable = datagrams["size"] > 0
    readable[messages["batch"][messages["code"] == zenoh_messages.UNREADABLE]] = False
    return readable
