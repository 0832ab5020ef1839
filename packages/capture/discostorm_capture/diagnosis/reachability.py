"""Which host hears which: announcements, and what is sent to it alone."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass

import numpy as np

from discostorm_capture._bytes import Array
from discostorm_capture.diagnosis.observations import ENCRYPTED, HANDSHAKE, KEYS, Seen
from discostorm_capture.diagnosis.scopes import Team, clients, scouting

#: So long must two hosts be there together before it counts that one does not answer [s].
PATIENCE = 4.0
#: Who is silent for this long is taken to be there all the same [s]: announcements are rare.
RARE = 10.0
#: So many answers to a host tell that it spoke.
ANSWERS = 3


@dataclass(frozen=True)
class Reach:
    """Which host hears which; the row hears the column.

    Parameters
    ----------
    hosts : tuple of str
        The hosts of rows and columns.
    expected : numpy.ndarray
        Whether the capture would show if the one heard the other.
    heard : numpy.ndarray
        Whether it answered an announcement of it.
    taken : numpy.ndarray
        Whether it confirmed anything that was sent to it alone.
    tried : numpy.ndarray
        Whether anything was sent to it alone that it would have confirmed.
    """

    hosts: tuple[str, ...]
    expected: Array
    heard: Array
    taken: Array
    tried: Array

    @property
    def deaf(self) -> Array:
        """Which does not hear which, though it should."""
        found: Array = self.expected & ~self.heard & ~self.taken
        return found

    @property
    def apart(self) -> Array:
        """Which hears announcements, and nothing that is sent to it alone."""
        found: Array = self.expected & self.heard & self.tried & ~self.taken
        return found


def reach(seen: Seen, team: Team, holes: Collection[tuple[str, str]] = ()) -> Reach:
    """Return which host of a team hears which.

    ``holes`` are the hosts of whose messages to others the capture lacks some, with these.
    """
    hosts = _announcing(seen, team)
    place = {host: index for index, host in enumerate(hosts)}
    size = len(hosts)
    heard, taken, tried = (np.zeros((size, size), bool) for _ in range(3))
    if team.protocol == "RTPS":
        _rtps(seen, place, heard, taken, tried)
    else:
        _zenoh(seen, place, heard, taken, tried)
    expected = _expected(seen, hosts)
    for of, by in holes:
        if of in place and by in place:
            expected[place[of], place[by]] = False
    return Reach(hosts, expected, heard, taken, tried)


def unheard(seen: Seen) -> dict[str, int]:
    """Return the hosts that others answer, and of which the capture shows nothing itself."""
    rows = seen.rows
    answers = seen.of("submessage", "ACKNACK") & (seen.number > 1)
    answers |= seen.of("kind", KEYS, ENCRYPTED)
    first = seen.of("submessage", "InitSyn") | seen.of("kind", "Scout", "Hello", "Join")
    answers |= seen.of("protocol", "Zenoh") & (seen.process >= 0) & ~first
    answers &= ~seen.multicast
    spoke = {*rows["sender"].astype(str).unique(), *seen.host}
    count = rows["receiver"][answers].astype(str).value_counts()
    return {str(host): int(n) for host, n in count.items() if host not in spoke and n >= ANSWERS}


def _announcing(seen: Seen, team: Team) -> tuple[str, ...]:
    """Return the hosts of a team that look for others by multicast."""
    if team.protocol == "Zenoh":
        return scouting(seen)
    announced = seen.of("kind", "SPDP") & seen.multicast & (seen.process >= 0)
    found = set(np.unique(seen.process[announced]).tolist()) - clients(seen)
    return tuple(dict.fromkeys(str(seen.host[one]) for one in team.members if one in found))


def _expected(seen: Seen, hosts: tuple[str, ...]) -> Array:
    end = float(seen.time[-1]) if len(seen.time) else 0.0
    size = len(hosts)
    expected = np.zeros((size, size), bool)
    for row, one in enumerate(hosts):
        for column, other in enumerate(hosts):
            lives = [seen.host_life[host] for host in (one, other)]
            begin = max(first for first, _ in lives)
            stop = min([end, *(last + RARE for _, last in lives)])
            visible = seen.view is None or seen.view in (one, other)
            expected[row, column] = row != column and visible and stop - begin >= PATIENCE
    return expected


def _ends(seen: Seen, place: dict[str, int], chosen: Array) -> tuple[Array, Array]:
    """Return the hosts that messages are from and for, -1 if others."""
    found = []
    for column in ("sender", "receiver"):
        words = seen.rows[column].cat
        numbers = np.array([place.get(str(word), -1) for word in words.categories] or [-1])
        found.append(numbers[words.codes.to_numpy()[chosen]])
    return found[0], found[1]


def _set(matrix: Array, rows: Array, columns: Array) -> None:
    known = (rows >= 0) & (columns >= 0)
    matrix[rows[known], columns[known]] = True


def _rtps(seen: Seen, place: dict[str, int], heard: Array, taken: Array, tried: Array) -> None:
    of_process = np.array([place.get(str(host), -1) for host in seen.host] or [-1])
    directed = np.flatnonzero((seen.process >= 0) & (seen.peer >= 0))
    by, of = of_process[seen.process[directed]], of_process[seen.peer[directed]]
    _set(heard, by, of)
    # What does not say for which process it is goes to an address that was announced.
    plain = np.flatnonzero((seen.process >= 0) & (seen.peer < 0) & ~seen.multicast)
    sender, receiver = _ends(seen, place, plain)
    _set(heard, sender, receiver)
    answers = seen.of("submessage", "ACKNACK")[directed]
    # Keys follow the handshake, each step of which answers the one before.
    got = seen.of("kind", KEYS, ENCRYPTED)[directed]
    got |= answers & ((seen.number[directed] > 1) | (seen.missing[directed] > 0))
    _set(taken, by[got], of[got])
    # A handshake is confirmed by its next step alone, which may fail for other reasons.
    asks = seen.of("submessage", "HEARTBEAT", "DATA") & ~seen.of("kind", "SPDP", HANDSHAKE)
    asks &= ~seen.multicast
    # A Heartbeat that tells of nothing is answered by nothing that tells it was heard.
    sender, receiver = _ends(seen, place, np.flatnonzero(asks & (seen.number > 0)))
    _set(tried, receiver, sender)
    # With DDS Security nothing is confirmed to who has none.
    secured = np.zeros(len(place), bool)
    secured[[one for one in of_process[[*seen.secured]] if one >= 0]] = True
    tried &= secured[:, None] == secured


def _zenoh(seen: Seen, place: dict[str, int], heard: Array, taken: Array, tried: Array) -> None:
    hello = np.flatnonzero(seen.of("kind", "Hello") & ~seen.multicast)
    by, of = _ends(seen, place, hello)
    _set(heard, by, of)
    _set(tried, of, by)
    asked = seen.asides
    ends = [
        np.array([place.get(str(host), -1) for host in asked[column]], np.int64)
        for column in ("sender", "receiver")
    ]
    kind = asked["kind"].astype(str).to_numpy()
    from_, to = ends
    answered = np.isin(kind, ["connection", "half", "refused"])
    _set(taken, to[answered], from_[answered])
    # What was open before the capture began was taken, too, whatever it carries.
    whole = np.isin(kind, ["connection", "exchange"])
    _set(taken, from_[whole], to[whole])
    calls = np.isin(kind, ["connection", "half", "refused", "unanswered"])
    _set(tried, to[calls], from_[calls])
    # Whoever says more in a session than its first message has heard the other side.
    first = seen.of("submessage", "InitSyn") | seen.of("kind", "Scout", "Hello", "Join")
    told = np.flatnonzero(seen.of("protocol", "Zenoh") & ~seen.multicast & ~first)
    speaker, listener = _ends(seen, place, told)
    _set(taken, speaker, listener)
