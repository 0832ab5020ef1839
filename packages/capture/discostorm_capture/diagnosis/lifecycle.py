"""Findings about processes: who came late, fell silent, came again, or was forgotten."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from discostorm_capture._bytes import Array
from discostorm_capture.diagnosis.finding import Finding, listed
from discostorm_capture.diagnosis.observations import Seen
from discostorm_capture.diagnosis.pairs import groups
from discostorm_capture.diagnosis.scopes import CLIENT, Team

#: Who comes so long after the others did not start together with them [s].
LATE = 5.0
#: Silent is who says nothing for so many of its own longest pauses, and for this long [s]: of RTPS,
#: which repeats announcements, and of Zenoh, whose sessions end with TCP's connections.
PAUSES, SILENT, ZENOH_SILENT = 2.5, 12.0, 75.0
#: Who spoke so often without a pause of a second has stopped after this time [s].
OFTEN, STOPPED = 10, 4.0
#: What a host does that asks for a connection.
CALLS = ("connection", "half", "refused", "unanswered")
#: So long others must speak on after a process did last [s].
ON = 3.0
#: From so many on, starts of a host's processes are a loop, and lost leases come again and again.
LOOP, AGAIN = 3, 2


@dataclass(frozen=True)
class Life:
    """The life of a process: when it spoke first and last [s], and how it ended.

    ``end`` is "" if it goes on or this cannot be told, "left" if it said goodbye, else "silent".
    """

    first: float
    last: float
    end: str


def lives(seen: Seen) -> list[Life]:
    """Return the life of each process."""
    first, last = seen.life
    rtps = (seen.processes["protocol"] == "RTPS").to_numpy()
    end = float(seen.time.max(initial=0.0))
    closed, unseen = _ends(seen), _unseen(seen)
    found = []
    for one in range(len(seen.processes)):
        said, how = closed.get(one, (np.inf, ""))
        # Of what was said after a goodbye the rest is delivery.
        if how and last[one] - said < 1.0:
            found.append(Life(first[one], last[one], how))
            continue
        times = np.sort(seen.time[seen.process == one])
        pause = float(np.diff(times).max(initial=0.0))
        most = max(PAUSES * pause, SILENT if rtps[one] else ZENOH_SILENT)
        silent = end - last[one] > most and _heard_others(seen, one, last[one])
        silent &= one not in unseen
        found.append(Life(first[one], last[one], "silent" if silent else ""))
    return found


def _heard_others(seen: Seen, one: int, since: float) -> bool:
    """Return whether other hosts spoke on after a process did last."""
    others = (seen.rows["sender"] != seen.host[one]).to_numpy()
    return bool((seen.time[others] > since + ON).any())


def _unseen(seen: Seen) -> set[int]:
    """Return the processes of RTPS whose announcements do not cross the network.

    They call a server on their own host alone; what else they send may end at any time.
    """
    announce = seen.of("kind", "SPDP", *CLIENT) & (seen.process >= 0)
    heard = set(np.unique(seen.process[announce]).tolist())
    rtps = (seen.processes["protocol"] == "RTPS").to_numpy()
    return {one for one in np.flatnonzero(rtps).tolist() if one not in heard}


def _ends(seen: Seen) -> dict[int, tuple[float, str]]:
    """Return who ends, when and how: by a goodbye, or by a connection that its kernel closes.

    Whoever is the first to close a connection ends, unless its host calls others afterwards.
    """
    ends = seen.rows["ends"].to_numpy(bool) & (seen.process >= 0)
    found: dict[int, tuple[float, str]] = {}
    size = len(seen.processes)
    low, high = np.minimum(seen.process, seen.peer), np.maximum(seen.process, seen.peer)
    calls = seen.asides[seen.asides["kind"].isin(CALLS)]
    closing = ends & seen.of("protocol", "TCP") & (seen.peer >= 0)
    for _, _, rows in groups(closing, low * size + high, np.zeros(len(ends), np.int64)):
        one, when = int(seen.process[rows[0]]), float(seen.time[rows[0]])
        mine = (calls["sender"] == seen.host[one]).to_numpy()
        again = (seen.host == seen.host[one]) & (seen.life[0] > when)
        calls_on = not again.any() and bool((calls["time"].to_numpy()[mine] > when).any())
        if not calls_on and _heard_others(seen, one, when):
            found[one] = (when, "silent")
    for row in np.flatnonzero((ends & seen.of("kind", "SPDP")) | _closes(seen)).tolist():
        found[int(seen.process[row])] = (float(seen.time[row]), "left")
    return found


def _closes(seen: Seen) -> Array:
    """Return which messages close a session of Zenoh."""
    found: Array = seen.of("kind", "Close") & (seen.process >= 0)
    return found


def events(seen: Seen, teams: tuple[Team, ...], began_late: set[int]) -> Iterator[Finding]:
    """Yield who crashed, started again, left, joined later, or was forgotten."""
    alive = lives(seen)
    again = restarted(seen, alive)
    gone = [one for one, life in enumerate(alive) if life.end == "silent"]
    for host, starts in again.items():
        ends = [alive[one] for one in starts]
        times = listed([f"{life.first:.1f} s" for life in ends[1:]])
        kind = "crash loop" if len(starts) > LOOP else "restart"
        yield Finding(
            kind,
            (host,),
            f"{host}: processes began at {times}, each after the one before had gone silent",
        )
    for host, ones in _by_host(seen, gone).items():
        dead = [one for one in ones if one not in {x for s in again.values() for x in s[:-1]}]
        if dead:
            when = max(alive[one].last for one in dead)
            servers = seen.processes["server"].to_numpy(bool)[dead].any()
            if not servers:
                yield Finding(
                    "crash",
                    (host,),
                    f"{host}: last heard after {when:.1f} s, of a capture of {seen.duration:.1f} s",
                )
    left = [one for one, life in enumerate(alive) if life.end == "left"]
    for host, ones in _by_host(seen, left).items():
        when = max(alive[one].last for one in ones)
        yield Finding("left", (host,), f"{host} said goodbye after {when:.1f} s")
    yield from _joiners(seen, teams, alive, again, began_late)
    yield from _forgotten(seen, teams)


def _by_host(seen: Seen, ones: list[int]) -> dict[str, list[int]]:
    found: dict[str, list[int]] = {}
    for one in ones:
        found.setdefault(str(seen.host[one]), []).append(one)
    return found


def restarted(seen: Seen, alive: list[Life]) -> dict[str, list[int]]:
    """Return, by host, processes that follow each other: each began after the one before ended."""
    found: dict[str, list[int]] = {}
    product = seen.processes["product"].to_numpy(object)
    for host, ones in _by_host(seen, list(range(len(alive)))).items():
        spoken = [one for one in ones if np.isfinite(alive[one].first)]
        spoken.sort(key=lambda one: alive[one].first)
        free = [one for one in spoken if alive[one].end == "silent" or _stopped(seen, one)]
        chain: list[int] = []
        for one in spoken:
            before = [
                other
                for other in free
                if alive[other].last < alive[one].first and product[other] == product[one]
            ]
            if before:
                last = max(before, key=lambda other: alive[other].last)
                free.remove(last)
                chain += [last] * (last not in chain) + [one]
        if chain:
            found[host] = chain
    return found


def _stopped(seen: Seen, one: int) -> bool:
    """Return whether a process that spoke all the time has stopped, soon after as it may be."""
    times = np.sort(seen.time[seen.process == one])
    pause = float(np.diff(times).max(initial=0.0))
    often = len(times) >= OFTEN and pause <= 1.0 and times[-1] - times[0] >= 1.5
    quiet = float(seen.time.max()) - times[-1] if len(times) else 0.0
    return bool(often and quiet > max(PAUSES * pause, STOPPED))


def _joiners(
    seen: Seen,
    teams: tuple[Team, ...],
    alive: list[Life],
    again: dict[str, list[int]],
    began_late: set[int],
) -> Iterator[Finding]:
    """Yield the hosts whose first process began after all others were there."""
    newly = {one for starts in again.values() for one in starts[1:]}
    for team in teams:
        ones = [
            one
            for one in team.members
            if np.isfinite(alive[one].first) and one not in newly and one not in began_late
        ]
        ones.sort(key=lambda one: alive[one].first)
        hosts = _by_host(seen, ones)
        starts = sorted((alive[ones_[0]].first, host) for host, ones_ in hosts.items())
        for (first, host), (before, _) in zip(starts[1:], starts, strict=False):
            late = [one for one in ones if alive[one].first >= first]
            if first - before < LATE or not _told(team, hosts[host][0]):
                continue
            if began_late and not any(pair.sent for pair in team.pairs if pair.of in late):
                continue  # heard late, but of those that had told all before the capture
            who = tuple(_by_host(seen, late))
            times = [pair.complete for pair in team.pairs if {pair.of, pair.by} & set(late)]
            whole = max(times, default=np.inf)
            then = (
                f", and discovery was complete {whole - first:.1f} s later"
                if whole < np.inf
                else ""
            )
            yield Finding("late joiner", who, f"{listed(who)} began after {first:.1f} s{then}")
            break


def _told(team: Team, one: int) -> bool:
    """Return whether the capture shows how a process told others of itself, if it did."""
    mine = [pair for pair in team.pairs if pair.of == one]
    return not mine or any(not np.isnan(pair.complete) for pair in mine)


def _forgotten(seen: Seen, teams: tuple[Team, ...]) -> Iterator[Finding]:
    """Yield hosts that others forgot and found again, the one that most of it is about first."""
    count: dict[str, list[float]] = {}
    for team in teams:
        for pair in team.pairs:
            for host in {str(seen.host[pair.of]), str(seen.host[pair.by])}:
                count.setdefault(host, []).extend(pair.forgotten)
    most = max((len(times) for times in count.values()), default=0)
    if not most:
        return
    times = {host: _distinct(np.array(found)) for host, found in count.items()}
    hosts = tuple(host for host, found in count.items() if len(found) == most)
    chosen = max((times[host] for host in hosts), key=len)
    kind = "leases expire" if len(chosen) >= AGAIN else "forgotten"
    yield Finding(
        kind,
        hosts,
        f"{listed(hosts)}: rediscovered after {listed([f'{time:.1f} s' for time in chosen])} by "
        "hosts that had known it before",
    )


def _distinct(times: Array) -> list[float]:
    times = np.sort(times)
    return [float(time) for time in times[np.diff(times, prepend=-np.inf) > LATE]]
