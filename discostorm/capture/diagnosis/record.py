"""Findings about the capture itself: when it began, what it lacks, whose view it is, its clock."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import permutations

import numpy as np

from discostorm.capture.diagnosis.finding import Finding, listed
from discostorm.capture.diagnosis.pairs import acknowledgements, groups
from discostorm.capture.diagnosis.seen import (
    ACKNACK,
    DATA,
    ENCRYPTED,
    HEARTBEAT,
    Seen,
)


def began_late(seen: Seen) -> set[int]:
    """Return the processes that had told others of themselves before the capture began.

    Others confirm samples that the capture does not show, and never began with the first one.
    """
    acks = acknowledgements(seen)
    data = seen.of("kind", DATA) & (seen.process >= 0) & (seen.number > 0)
    writer = seen.rows["writer"].to_numpy(np.int64)
    sent = {(one, which) for one, which, _ in groups(data, seen.process, writer)}
    found: set[int] = set()
    for (_, of, which), (_, bases) in acks.items():
        if len(bases) and bases[0] > 1 and (of, which) not in sent:
            found.add(of)
    return found | _settled(seen)


def _settled(seen: Seen) -> set[int]:
    """Return the processes that others know, and that say nothing that is said at a start.

    A start has Heartbeats or acknowledgements of endpoints, or an acknowledgement of nothing yet.
    """
    speaks = seen.process >= 0
    starts = seen.of("kind", DATA, HEARTBEAT, ACKNACK)
    starts |= seen.of("submessage", "ACKNACK") & (seen.number <= 1)
    knows = ~seen.multicast & seen.of("protocol", "RTPS")
    known, starting = (
        set(np.unique(seen.process[mask & speaks]).tolist()) for mask in (knows, starts)
    )
    return known - starting


def record(seen: Seen, late: set[int]) -> Iterator[Finding]:
    """Yield what the capture cannot show, and why."""
    if seen.view is not None:
        yield Finding(
            "view of one host", (seen.view,), "all unicast that was captured is from or to it"
        )
    yield from _encrypted(seen)
    yield from _late(seen, late)
    yield from _lost(seen, late)
    for frame, step in seen.jumps[:TOLD]:
        kind = "clock back" if step < 0 else "clock on"
        way = "back" if step < 0 else "on"
        yield Finding(kind, (), f"packet {frame}: its time is {abs(step):,.1f} s {way}")


def _encrypted(seen: Seen) -> Iterator[Finding]:
    """Yield that what processes announce is encrypted, and how many have each other's keys."""
    untold = seen.processes["endpoints"].to_numpy() == 0
    hidden = seen.of("kind", ENCRYPTED) & (seen.process >= 0)
    by = [one for one in np.unique(seen.process[hidden]).tolist() if untold[one]]
    if not by:
        return
    hosts = dict.fromkeys(str(seen.host[one]) for one in by)
    pairs = {(one, other) for one, other in seen.keyed if seen.host[one] != seen.host[other]}
    ought = sum(seen.host[one] != seen.host[other] for one, other in permutations(seen.secured, 2))
    yield Finding(
        "encrypted",
        tuple(hosts),
        f"DDS Security encrypts {int(hidden.sum()):,} messages of {listed([*hosts])}; in "
        f"{len(pairs)} of {ought} pairs of processes on different hosts one told the other its "
        "keys",
    )


#: So many jumps of the clock are told.
TOLD = 3


def _late(seen: Seen, late: set[int]) -> Iterator[Finding]:
    rtps = (seen.processes["protocol"] == "RTPS").to_numpy()
    spoke = np.isfinite(seen.life[0])
    zenoh = seen.of("protocol", "Zenoh") & seen.of("transport", "TCP")
    unknown = zenoh & (seen.process < 0)
    opened = seen.of("kind", "Init")
    hosts = {str(seen.host[one]) for one in late}
    if late and len(late) * 2 >= int((rtps & spoke).sum()):
        yield Finding(
            "capture began late",
            (),
            f"{len(late)} of {int((rtps & spoke).sum())} processes ({listed(sorted(hosts))}) had "
            "told others of their endpoints before: no message that did was captured",
        )
    elif zenoh.any() and unknown.sum() > 0.5 * zenoh.sum() and not opened[unknown].any():
        first = seen.rows["sender"][unknown].astype(str).unique().tolist()
        yield Finding(
            "capture began late",
            (),
            f"sessions of Zenoh ({listed(sorted(first))}) were open before the first packet",
        )


def _lost(seen: Seen, late: set[int]) -> Iterator[Finding]:
    said = list(seen.lost)
    holes = _holes(seen, late)
    if holes:
        count = sum(holes.values())
        said.append(
            f"{count} samples that tell of endpoints of {listed(sorted(holes))} were confirmed, "
            "and are not in the capture"
        )
    if said:
        yield Finding("capture lost part", tuple(sorted(holes)), "; ".join(said))


def _holes(seen: Seen, late: set[int]) -> dict[str, int]:
    """Return how many samples of each host were confirmed that the capture lacks.

    A process that had begun before the capture is left out, and so is what a Gap jumps over.
    """
    data = seen.of("kind", DATA) & (seen.process >= 0) & (seen.number > 0)
    gaps = seen.of("submessage", "GAP") & (seen.process >= 0)
    writer = seen.rows["writer"].to_numpy(np.int64)
    sent = {
        (one, which): np.unique(seen.number[rows])
        for one, which, rows in groups(data, seen.process, writer)
    }
    jumped = {(one, which) for one, which, _ in groups(gaps, seen.process, writer)}
    most: dict[tuple[int, int], int] = {}
    for (_, of, which), (_, bases) in acknowledgements(seen).items():
        if bases.min() <= 1 or (of, which) in sent:
            most[of, which] = max(most.get((of, which), 0), int(bases.max()) - 1)
    found: dict[str, int] = {}
    for (of, which), last in most.items():
        if of in late or (of, which) in jumped:
            continue
        numbers = sent.get((of, which), np.zeros(0, np.int64))
        lacking = last - int((numbers <= last).sum())
        if lacking > 0:
            host = str(seen.host[of])
            found[host] = found.get(host, 0) + lacking
    return found
