"""Findings about the capture itself: when it began, what it lacks, whose view it is, its clock."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import permutations

import numpy as np

from discostorm import words
from discostorm_capture.diagnosis.finding import Finding, listed
from discostorm_capture.diagnosis.observations import DATA, ENCRYPTED, HANDSHAKE, HEARTBEAT, Seen
from discostorm_capture.diagnosis.pairs import Pair, acknowledgements, groups
from discostorm_capture.diagnosis.reachability import PATIENCE, unheard


def began_late(seen: Seen) -> set[int]:
    """Return the processes that had told others of themselves before the capture began.

    Others confirm samples that the capture does not show, and never began with the first one.
    """
    acks = acknowledgements(seen)
    data = seen.of("kind", DATA) & (seen.process >= 0) & (seen.number > 0)
    writer = seen.rows["writer"].to_numpy(np.int64)
    # What a process tells long after it was heard first, and not from its first sample on, comes
    # after a start that the capture lacks.
    start = {
        (one, which)
        for one, which, rows in groups(data, seen.process, writer)
        if seen.number[rows].min() == 1 or seen.time[rows[0]] - seen.life[0][one] < LONG_AFTER
    }
    found: set[int] = set()
    for (_, of, which), (_, bases) in acks.items():
        if len(bases) and bases[0] > 1 and (of, which) not in start:
            found.add(of)
    return found | _settled(seen)


def _settled(seen: Seen) -> set[int]:
    """Return the processes that others know, and that say nothing that is said at a start.

    A start has Heartbeats or acknowledgements of endpoints, an acknowledgement of nothing yet, or
    a handshake.
    """
    speaks = seen.process >= 0
    starts = seen.of("kind", DATA, HEARTBEAT, HANDSHAKE)
    starts |= seen.of("submessage", "ACKNACK") & (seen.number <= 1)
    knows = ~seen.multicast & seen.of("protocol", "RTPS")
    known, starting = (
        set(np.unique(seen.process[mask & speaks]).tolist()) for mask in (knows, starts)
    )
    return known - starting


def record(seen: Seen, late: set[int]) -> Iterator[Finding]:
    """Yield what the capture cannot show, and why."""
    yield from _encrypted(seen)
    yield from _late(seen, late)
    yield from _lost(seen, late)
    if seen.view is not None:
        yield Finding(
            "view of one host",
            (seen.view,),
            f"all unicast that was captured is from or to {seen.view}",
        )
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
        f"DDS Security encrypts {int(hidden.sum()):,} messages of {listed([*hosts])}; keys "
        f"were sent in {len(pairs)} of {ought} pairs of processes on different hosts",
    )


#: So many jumps of the clock are told.
TOLD = 3
#: What is told so long after a process was heard first is not of its start [s].
LONG_AFTER = 1.0
#: Who waits for a confirmation asks again after two of the pauses before, soon, at the latest [s].
PAUSES, LEAST, MOST = 2.5, 3.0, 9.0


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
            "announced their endpoints before: the capture has none of these announcements",
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
    holes: dict[str, int] = {}
    for (of, _), count in holes_of(seen, late).items():
        holes[of] = max(holes.get(of, 0), count)
    if holes:
        said.append(
            f"the capture lacks {words.many(sum(holes.values()), 'sample')} about endpoints of "
            f"{listed(sorted(holes))} that others confirmed"
        )
    silent = unheard(seen)
    for host, count in silent.items():
        said.append(
            f"{count} messages to {host} answer what it sent, and nothing that it sent is in the "
            "capture"
        )
    if said:
        hosts = tuple(sorted({*holes, *silent}))
        yield Finding("capture lost part", hosts, "; ".join(said))


def unread(seen: Seen) -> tuple[str, ...]:
    """Return the hosts that speak in sessions, and none of whose processes the capture shows."""
    known = set(seen.host)
    told = seen.rows["sender"][seen.of("protocol", "Zenoh") & ~seen.multicast & (seen.process < 0)]
    return tuple(host for host in told.astype(str).unique() if host not in known)


def holes_of(seen: Seen, late: set[int]) -> dict[tuple[str, str], int]:
    """Return, by host and who confirms, how many samples were confirmed that the capture lacks.

    A process that had begun before the capture is left out, and so is what a Gap jumps over.
    """
    data = seen.of("kind", DATA) & (seen.process >= 0) & (seen.number > 0)
    gaps = seen.of("submessage", "GAP") & (seen.process >= 0)
    writer = seen.rows["writer"].to_numpy(np.int64)
    sent = {
        (one, which): rows for one, which, rows in groups(data, seen.process, writer) if len(rows)
    }
    jumped = {(one, which) for one, which, _ in groups(gaps, seen.process, writer)}
    found: dict[tuple[str, str], int] = {}
    nothing = np.zeros(0, np.int64)
    for (by, of, which), (_, bases) in acknowledgements(seen).items():
        if of in late or (of, which) in jumped:
            continue
        rows = sent.get((of, which), nothing)
        if bases.min() > 1 and not len(rows):
            continue
        last = int(bases.max()) - 1
        told = rows[(seen.peer[rows] < 0) | (seen.peer[rows] == by)]
        lacking = last - int((np.unique(seen.number[told]) <= last).sum())
        if lacking > 0:
            ends = str(seen.host[of]), str(seen.host[by])
            found[ends] = max(found.get(ends, 0), lacking)
    return found


def asked_no_more(seen: Seen, pair: Pair) -> bool:
    """Return whether a process tells all it has, and stops asking whether that arrived.

    Its Heartbeats go on until all is confirmed: if they end, a confirmation is not in the capture.
    """
    if not pair.sent:
        return False
    beats = seen.of("kind", HEARTBEAT) & (seen.process == pair.of)
    times = seen.time[beats & ((seen.peer == pair.by) | (seen.peer < 0))]
    if not len(times):
        return False
    end = min(float(seen.life[1][one]) for one in (pair.of, pair.by))
    pause = float(np.diff(times).max(initial=0.0))
    return end - float(times[-1]) > (max(PAUSES * pause, LEAST) if pause else MOST)


def unconfirmed(seen: Seen, lacking: list[Pair]) -> Iterator[Finding]:
    """Yield that confirmations are not in the capture."""
    hosts = tuple(dict.fromkeys(str(seen.host[pair.by]) for pair in lacking))
    yield Finding(
        "capture lost part",
        hosts,
        f"{listed(hosts)} confirmed endpoints of others, who ask no more, and the capture lacks "
        "these confirmations",
    )


def ended_early(seen: Seen, pending: list[Pair]) -> Iterator[Finding]:
    """Yield that processes did not know each other yet when the capture ended, soon after."""
    hosts = tuple(dict.fromkeys(str(seen.host[pair.by]) for pair in pending))
    if pending:
        pairs = words.many(len(pending), "pair")
        yield Finding(
            "capture ended early",
            hosts,
            f"when the capture ended, {pairs} of processes had not completed, which had been there "
            f"for less than {PATIENCE:.0f} s",
        )
