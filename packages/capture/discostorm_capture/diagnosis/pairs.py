"""Who knows whom since when: pairs of processes of different hosts, and what each lacks."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from discostorm_capture._bytes import Array
from discostorm_capture.diagnosis.observations import ACKNACK, DATA, HEARTBEAT, Seen

#: Announcements that follow each other within this time are of one start [s].
TOGETHER = 5.0
#: Two acknowledgements further apart than this did not just overtake each other [s].
APART = 1.0


@dataclass(frozen=True)
class Pair:
    """What one process knows of another one on another host.

    Parameters
    ----------
    of, by : int
        Places among the processes: who is known, and who knows.
    heard : float
        When ``by`` first spoke to ``of``, which it can only if it heard of it [s]; infinite if
        never.
    complete : float
        When ``by`` had been told all endpoints of ``of`` [s]: infinite if it never confirmed
        that, NaN if the capture does not show it.
    sent : int
        How many endpoints ``of`` announced to it.
    forgotten : tuple of float
        When ``by`` began anew, having confirmed before [s].
    """

    of: int
    by: int
    heard: float
    complete: float
    sent: int
    forgotten: tuple[float, ...] = ()


def rtps_heard(seen: Seen) -> Array:
    """Return when each process (row) first spoke to each other one (column) [s]."""
    size = len(seen.processes)
    first = np.full((size, size), np.inf)
    told = (seen.process >= 0) & (seen.peer >= 0)
    np.minimum.at(first, (seen.process[told], seen.peer[told]), seen.time[told])
    return first


@dataclass(frozen=True)
class _Told:
    """What a process told by one of its writers: to whom, when, which samples."""

    time: Array
    number: Array
    peer: Array
    #: The last sample of the start, when it was first sent, and the last one of all.
    of_start: int
    last: int


def _writers(seen: Seen) -> dict[int, dict[int, _Told]]:
    """Return, by process and writer, what was told of endpoints."""
    spoken = (seen.process >= 0) & seen.of("kind", DATA, HEARTBEAT)
    data = seen.of("kind", DATA) & (seen.number > 0)
    writer = seen.rows["writer"].to_numpy(np.int64)
    found: dict[int, dict[int, _Told]] = {}
    for process, which, chosen in groups(spoken, seen.process, writer):
        sent = chosen[data[chosen]]
        last = int(seen.number[chosen].max(initial=0))
        if not last:
            continue
        told = _Told(
            seen.time[sent], seen.number[sent], seen.peer[sent], _of_start(seen, sent, last), last
        )
        found.setdefault(process, {})[which] = told
    return found


def _of_start(seen: Seen, sent: Array, last: int) -> int:
    """Return the last sample of those that were first told close together."""
    if not len(sent):
        return last
    numbers, first = np.unique(seen.number[sent], return_index=True)
    times = seen.time[sent][first]
    order = np.argsort(times, kind="stable")
    breaks = np.flatnonzero(np.diff(times[order]) > TOGETHER)
    upto = int(breaks[0]) + 1 if len(breaks) else len(order)
    return int(numbers[order[:upto]].max())


def groups(chosen: Array, *keys: Array) -> list[tuple[int, int, Array]]:
    """Return, for each two keys of the chosen rows, these rows in their order."""
    rows = np.flatnonzero(chosen)
    one, two = (key[rows] for key in keys)
    order = np.lexsort((two, one))
    rows, one, two = rows[order], one[order], two[order]
    if not len(rows):
        return []
    begins = np.append(0, np.flatnonzero((np.diff(one) != 0) | (np.diff(two) != 0)) + 1)
    return [
        (int(one[begin]), int(two[begin]), part)
        for begin, part in zip(begins, np.split(rows, begins[1:]), strict=True)
    ]


Acks = dict[tuple[int, int, int], tuple[Array, Array]]


def acknowledgements(seen: Seen) -> Acks:
    """Return by who confirms, whose writer's and which: when, and the first sample it lacks."""
    chosen = seen.of("kind", ACKNACK) & (seen.process >= 0) & (seen.peer >= 0)
    writer = seen.rows["writer"].to_numpy(np.int64)
    size = len(seen.processes)
    found: Acks = {}
    ends = seen.process * size + seen.peer
    for both, which, rows in groups(chosen, ends, writer):
        found[both // size, both % size, which] = (seen.time[rows], seen.number[rows])
    return found


def rtps_pairs(seen: Seen, wanted: list[tuple[int, int]]) -> list[Pair]:
    """Return what is known of ordered pairs: of whom, by whom."""
    heard = rtps_heard(seen)
    writers, acks = _writers(seen), acknowledgements(seen)
    nothing = np.zeros(0), np.zeros(0, np.int64)
    pairs = []
    spoke = _spoke(seen)
    for of, by in wanted:
        complete, sent, forgotten = heard[by, of], 0, set[float]()
        if complete == np.inf and (seen.host[by], seen.host[of]) in spoke:
            complete = np.nan  # before the capture, if it did
        tells = writers.get(of, {})
        if {of, by} & seen.secured and not tells:
            # What it tells is encrypted, and told to nobody without keys.
            complete = np.nan if (of, by) in seen.keyed else np.inf
        elif not tells and not np.isnan(complete):
            # Nothing to tell, if it knew to whom.
            back = (seen.host[of], seen.host[by]) in spoke and np.isinf(heard[of, by])
            complete = np.nan if back else max(complete, heard[of, by])
        for which, told in tells.items():
            times, bases = acks.get((by, of, which), nothing)
            confirmed = np.flatnonzero(bases > told.of_start)
            forgotten |= set(_begun_anew(times, bases))
            mine = (told.peer == by) | (told.peer < 0)
            sent += len(np.unique(told.number[mine]))
            if not len(confirmed):
                complete = np.nan if np.isnan(complete) else np.inf
                continue
            at = times[confirmed[0]]
            before = told.time[mine & (told.number <= told.of_start) & (told.time <= at)]
            # What was confirmed, and not told here, was told before the capture.
            complete = max(complete, before.max(initial=0.0))
        pairs.append(Pair(of, by, heard[by, of], float(complete), sent, _apart(forgotten)))
    return pairs


def _spoke(seen: Seen) -> set[tuple[str, str]]:
    """Return which host sent which what does not say of or for which process it is."""
    nobodys = ((seen.process < 0) | (seen.peer < 0)) & ~seen.multicast & ~seen.of("kind", "Hello")
    ends = seen.rows.loc[nobodys, ["sender", "receiver"]].drop_duplicates()
    return set(zip(ends["sender"].astype(str), ends["receiver"].astype(str), strict=True))


def _exchanged(seen: Seen) -> set[tuple[str, str]]:
    """Return which hosts exchange what cannot be read, as it began before the capture."""
    rows = seen.asides[(seen.asides["kind"] == "exchange").to_numpy()]
    return set(zip(rows["sender"].astype(str), rows["receiver"].astype(str), strict=True))


def _begun_anew(times: Array, bases: Array) -> list[float]:
    """Return when acknowledgements begin anew, having got somewhere before."""
    got = np.flatnonzero(bases > 1)
    if not len(got):
        return []
    again = np.flatnonzero((bases <= 1) & (np.arange(len(bases)) > got[0]))
    # The last time that something was confirmed before.
    before = times[got[np.searchsorted(got, again) - 1]]
    anew: list[float] = times[again][times[again] - before > APART].tolist()
    return anew


def _apart(times: set[float]) -> tuple[float, ...]:
    """Return times that are not within a start of each other."""
    found: list[float] = []
    for time in sorted(times):
        if not found or time - found[-1] > TOGETHER:
            found.append(time)
    return tuple(found)


def zenoh_pairs(seen: Seen, wanted: list[tuple[int, int]]) -> list[Pair]:
    """Return what is known of ordered pairs of Zenoh: a session is open, and what was declared."""
    size = len(seen.processes)
    told = (seen.process >= 0) & (seen.peer >= 0)
    both = seen.process * size + seen.peer
    opened: dict[int, Array] = {}
    declared: dict[int, Array] = {}
    heard: dict[int, float] = {}
    for mask, found in (
        (seen.of("submessage", "OpenAck"), opened),
        (seen.of("kind", "Declare"), declared),
    ):
        for ends, _, rows in groups(mask & told, both, np.zeros(len(both), np.int64)):
            found[ends] = seen.time[rows]
    for ends, _, rows in groups(told, both, np.zeros(len(both), np.int64)):
        heard[ends] = float(seen.time[rows[0]])
    pairs = []
    nothing = np.zeros(0)
    spoke = _spoke(seen) | _exchanged(seen)
    for of, by in wanted:
        there, back = of * size + by, by * size + of
        acks = np.sort(np.append(opened.get(there, nothing), opened.get(back, nothing)))
        times = declared.get(there, nothing)
        complete = np.inf
        if len(acks):
            of_start = times[: 1 + int(np.argmax(np.append(np.diff(times) > TOGETHER, True)))]
            complete = max(acks[0], of_start.max(initial=0.0))
        elif (there in heard and back in heard) or (seen.host[of], seen.host[by]) in spoke:
            complete = np.nan
        anew = tuple(acks[1:][np.diff(acks) > TOGETHER].tolist())
        pairs.append(Pair(of, by, heard.get(back, np.inf), float(complete), len(times), anew))
    return pairs
