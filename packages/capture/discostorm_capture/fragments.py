"""From fragments to IP packets."""

from collections import Counter

import numpy as np

from discostorm_capture._bytes import (
    Array,
    Bytes,
    Columns,
    buffer,
    codes,
    take,
    times_before,
    view,
)

MISSING = "IP datagrams of which fragments are missing"
#: Fragments of one datagram come within this time [ns]; RFC 791 and RFC 8200 say 15 s and 60 s.
_LIFETIME = 60_000_000_000
#: So often it is tried to put together what overlaps and has holes.
_MOST_FAILURES = 16


def put_together(
    pieces: Columns, data: Bytes, time: Array, notes: Counter[str]
) -> tuple[Bytes, Columns]:
    """Return what fragments make.

    Parameters
    ----------
    pieces : dict
        The fragments, as `parse` returns them; none is cut.
    data : numpy.ndarray
        Where they are.
    time : numpy.ndarray
        Of each frame [ns].
    notes : Counter
        What could not be read is counted here.

    Returns
    -------
    tuple
        The bytes of the packets, and their table. A packet has the frame that completed it,
        and ``parts``, the number of its frames.
    """
    pieces = take(pieces, pieces["offset"] + pieces["wire"] <= 0xFFFF)
    group, _ = codes(*(pieces[key] for key in ("source", "target", "protocol", "id", "view")))
    order = np.argsort(group, kind="stable")
    pieces, group = take(pieces, order), group[order]
    chosen, runs = _runs(pieces, group, data, time[pieces["frame"]], notes)
    pieces = take(pieces, chosen)
    # Each run of pieces makes one datagram, laid out one after the other.
    first = np.flatnonzero(np.diff(runs, prepend=-1))
    count = np.diff(first, append=len(runs))
    last = first + count - 1
    total = np.maximum.reduceat(pieces["offset"] + pieces["wire"], first) if len(first) else first
    start = np.cumsum(total) - total
    pool = buffer(int(total.sum()))
    at = np.repeat(start, count) + pieces["offset"]
    size = pieces["end"] - pieces["at"]
    source, target = view(data), view(pool)
    for to, from_, many in zip(at.tolist(), pieces["at"].tolist(), size.tolist(), strict=True):
        target[to : to + many] = source[from_ : from_ + many]
    frame = np.maximum.reduceat(pieces["frame"], first) if len(first) else pieces["frame"]
    made = take(pieces, last) | {
        "at": start,
        "end": start + total,
        "wire": total,
        "frame": frame,
        "parts": count.astype(np.int32),
    }
    return pool, made


def _runs(
    pieces: Columns, group: Array, data: Bytes, time: Array, notes: Counter[str]
) -> tuple[Array, Array]:
    """Return which pieces make whole datagrams, in order, and of each the datagram's number."""
    late = (np.diff(group, prepend=-1) != 0) | (np.diff(time, prepend=time[:1]) > _LIFETIME)
    run, easy = _in_order(pieces, late)
    chosen, runs = np.flatnonzero(easy), run[easy]
    # Those out of order, sent twice or with holes, one by one. What repeats a piece belongs to
    # the next datagram of the kind, so that a packet seen twice counts twice as any other does.
    part = np.cumsum(late)
    code, first = codes(part, pieces["offset"], pieces["wire"])
    left, layer = np.flatnonzero(~easy), np.zeros(len(group), np.int64)
    layer[left] = times_before(code[left])
    left = left[np.lexsort((left, layer[left], part[left]))]
    together: list[list[int]] = []
    now, since = (-1, 0), 0
    for which in left.tolist():
        kind, when = (int(group[which]), int(layer[which])), int(time[which])
        if kind != now or when - since > _LIFETIME:
            together.append([])
            now, since = kind, when
        together[-1].append(which)
    hard: list[int] = []
    hard_runs: list[int] = []
    rests = []
    for some in together:
        made, rest = _out_of_order(pieces, some)
        rests.append(rest)
        for members in made:
            hard += members
            # Any number that no other datagram has.
            hard_runs += [len(group) + members[0]] * len(members)
    chosen = np.append(chosen, np.array(hard, np.int64))
    # What only repeats pieces that were used, or that are missing anyway, is no datagram.
    used = first.copy()
    used[code[chosen]] = chosen

    def repeats(which: int, other: int) -> bool:
        one, two = (data[pieces["at"][at] : pieces["end"][at]] for at in (which, other))
        return which != other and np.array_equal(one, two)

    lost = 0
    for rest in rests:
        kinds = code[rest].tolist()
        lost += not all(
            repeats(which, used[kind]) or repeats(which, first[kind])
            for which, kind in zip(rest, kinds, strict=True)
        )
    if lost:
        notes[MISSING] += lost
    return chosen, np.append(runs, np.array(hard_runs, np.int64))


def _in_order(pieces: Columns, late: Array) -> tuple[Array, Array]:
    """Return of each piece the number of its run, and whether that is a whole datagram in order.

    A run starts at the first piece of a datagram, and where ``late`` says so.
    """
    offset, more = pieces["offset"], pieces["more"]
    start = late | (offset == 0)
    follows = np.ones(len(offset), bool)
    follows[1:] = offset[1:] == (offset + pieces["wire"])[:-1]
    last = np.append(start[1:], True)
    good = np.where(start, offset == 0, follows) & (more != last)
    run = np.cumsum(start) - 1
    return run, np.logical_and.reduceat(good, np.flatnonzero(start))[run]


def _out_of_order(pieces: Columns, rows: list[int]) -> tuple[list[list[int]], list[int]]:
    """Return the pieces of each datagram that some of one kind make, and what is left."""
    made: list[list[int]] = []
    waiting: dict[int, tuple[int, int]] = {}  # offset: (end, row)
    total, held, failed = 0, 0, 0
    for row in rows:
        offset = int(pieces["offset"][row])
        end = offset + int(pieces["wire"][row])
        old = waiting.get(offset, (offset, 0))[0]
        if old < end:
            held += end - old
            waiting[offset] = end, row
        if not pieces["more"][row]:
            total = end
        if not total or held < total or failed > _MOST_FAILURES:
            continue
        covered, members = 0, []
        for at, (behind, member) in sorted(waiting.items()):
            if at > covered or covered >= total:
                break
            members.append(member)
            covered = max(covered, behind)
        if covered < total:
            failed += 1  # overlaps, and a hole
            continue
        made.append(members)
        waiting, total, held = {}, 0, 0
    return made, [row for _, row in waiting.values()]
