"""From fragments of IP to datagrams."""

from collections import Counter, defaultdict
from dataclasses import dataclass, field
from itertools import accumulate

import numpy as np

from discostorm_capture._bytes import PAD, Array, Bytes, Columns, as_memory, stack_tables, take_rows

MISSING = "IP datagrams of which fragments are missing"
#: Fragments of one datagram come within this time [ns]; RFC 791 and RFC 8200 say 15 s and 60 s.
LIFETIME = 60_000_000_000
#: Datagrams of one id that are reassembled at a time; others follow where fragments come twice.
_MAX_PENDING = 16
_MAX_LENGTH = 0xFFFF


@dataclass
class _Datagram:
    """A datagram in reassembly: start, rows by offset, length (0 if unknown), bytes so far."""

    since: int
    rows: dict[int, int] = field(default_factory=dict)
    total: int = 0
    received: int = 0


def reassemble(
    data: Bytes, packets: Columns, time: Array, notes: Counter[str]
) -> tuple[Bytes, Columns]:
    """Return IP packets with datagrams in place of their fragments, and the bytes that hold both.

    A datagram has the frame that completed it, and ``parts``, the number of its frames. The first
    fragment of a datagram that the capture truncates stays, to be read as far as it goes.
    """
    is_fragment = (packets["offset"] > 0) | packets["more"]
    if not is_fragment.any():
        return data, packets
    truncated = packets["end"] - packets["at"] < packets["wire"]
    valid = (packets["wire"] > 0) & (packets["offset"] + packets["wire"] <= _MAX_LENGTH)
    fragments = take_rows(packets, is_fragment & ~truncated & valid)
    rest = take_rows(packets, ~is_fragment | (truncated & (packets["offset"] == 0)))
    made = _reassembled(data, fragments, time, notes)
    # The bytes of datagrams follow those of the file.
    content, starts, ends = as_memory(data), fragments["at"].tolist(), fragments["end"].tolist()
    parts = [content]
    for datagram in made:
        rows = [row for _, row in sorted(datagram.rows.items())]
        parts += [content[starts[row] : ends[row]] for row in rows]
    last = np.array([next(reversed(one.rows.values())) for one in made], np.int64)
    wire = np.array([one.total for one in made], np.int64)
    end = len(data) + np.cumsum(wire)
    whole = take_rows(fragments, last) | {"at": end - wire, "end": end, "wire": wire}
    whole["parts"] = np.array([len(one.rows) for one in made], np.int32)
    both = stack_tables(rest, whole)
    both = take_rows(both, np.argsort(both["frame"], kind="stable"))
    return np.frombuffer(b"".join([*parts, bytes(PAD)]), np.uint8), both


def _reassembled(
    data: Bytes, fragments: Columns, time: Array, notes: Counter[str]
) -> list[_Datagram]:
    """Return the complete datagrams that fragments make, in one pass over them."""
    pending: dict[tuple[int, ...], list[_Datagram]] = defaultdict(list)
    complete, incomplete = [], []
    keys = ("source", "target", "protocol", "id", "view")
    columns = (fragments[name].tolist() for name in (*keys, "offset", "wire", "more"))
    times, lengths = time[fragments["frame"]].tolist(), fragments["wire"].tolist()
    for row, (*key, offset, length, more) in enumerate(zip(*columns, strict=True)):
        waiting = pending[tuple(key)]
        while waiting and (times[row] - waiting[0].since > LIFETIME or len(waiting) > _MAX_PENDING):
            incomplete.append(waiting.pop(0))
        # A fragment that was sent twice belongs to the next datagram with the same id: a packet
        # that the capture shows twice counts twice, as any other does.
        datagram = next((one for one in waiting if offset not in one.rows), None)
        if datagram is None:
            waiting.append(datagram := _Datagram(times[row]))
        datagram.rows[offset] = row
        datagram.received += length
        if not more:
            datagram.total = offset + length
        # Linux drops datagrams whose fragments overlap, too (RFC 5722).
        if datagram.received == datagram.total and _is_contiguous(datagram, lengths):
            waiting.remove(datagram)
            complete.append(datagram)
    incomplete += [datagram for waiting in pending.values() for datagram in waiting]
    _count_incomplete(data, fragments, complete, incomplete, notes)
    return complete


def _is_contiguous(datagram: _Datagram, lengths: list[int]) -> bool:
    """Return whether each fragment begins where the one before it ends."""
    offsets, rows = zip(*sorted(datagram.rows.items()), strict=True)
    return [*offsets] == [*accumulate((lengths[row] for row in rows), initial=0)][:-1]


def _count_incomplete(
    data: Bytes,
    fragments: Columns,
    complete: list[_Datagram],
    incomplete: list[_Datagram],
    notes: Counter[str],
) -> None:
    """Count incomplete datagrams once each, without repeated fragments of complete ones."""

    def contents(datagram: _Datagram) -> frozenset[tuple[object, ...]]:
        keys = ("source", "target", "id", "offset")
        return frozenset(
            (*(int(fragments[name][row]) for name in keys), data[begin:end].tobytes())
            for row in datagram.rows.values()
            for begin, end in [(fragments["at"][row], fragments["end"][row])]
        )

    used = set().union(*map(contents, complete if incomplete else ()))
    if missing := {part for part in map(contents, incomplete) if not part <= used}:
        notes[MISSING] += len(missing)
