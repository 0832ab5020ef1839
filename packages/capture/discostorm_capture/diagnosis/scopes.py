"""Who ought to know whom: processes of one protocol and domain, with servers or without."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from itertools import permutations

import numpy as np

from discostorm_capture._bytes import Array
from discostorm_capture.diagnosis.observations import Seen
from discostorm_capture.diagnosis.pairs import Pair, rtps_heard, rtps_pairs, zenoh_pairs

#: What a client of a Discovery Server sends of SPDP, which is reliable between the two.
CLIENT = ("SPDP Heartbeat", "SPDP ACKNACK", "SPDP Gap")
PORT = 7447


@dataclass(frozen=True)
class Team:
    """Processes that ought to know each other.

    Parameters
    ----------
    protocol : str
        "RTPS" or "Zenoh".
    domain : int
        The domain of RTPS; -1 if not known.
    hosts : tuple of str
        Where they run; also hosts that only announce.
    members : tuple of int
        Places among the processes.
    pairs : tuple of Pair
        What is known of those on different hosts that ought to know each other.
    """

    protocol: str
    domain: int
    hosts: tuple[str, ...]
    members: tuple[int, ...]
    pairs: tuple[Pair, ...]


def teams(seen: Seen) -> tuple[Team, ...]:
    """Return the teams of a capture."""
    return (*_of_rtps(seen), *_of_zenoh(seen))


def clients(seen: Seen) -> set[int]:
    """Return the processes of RTPS that use a Discovery Server."""
    of_server = seen.of("kind", *CLIENT) & (seen.process >= 0)
    found = set(np.unique(seen.process[of_server]).tolist())
    serves = seen.processes["server"].to_numpy(bool)
    return {one for one in found if not serves[one]}


def _of_rtps(seen: Seen) -> Iterable[Team]:
    table = seen.processes
    mine = np.flatnonzero((table["protocol"] == "RTPS").to_numpy() & (seen.host != ""))
    if not len(mine):
        return
    served, serves = clients(seen), table["server"].to_numpy(bool)
    domain = table["domain"].to_numpy(np.int64).copy()
    known = np.unique(domain[mine][domain[mine] >= 0])
    if len(known) == 1:
        domain[mine] = known[0]
    heard = rtps_heard(seen)
    for number in np.unique(domain[mine]).tolist():
        members = [one for one in mine.tolist() if domain[one] == number]
        wanted = [
            (of, by)
            for of, by in permutations(members, 2)
            if seen.host[of] != seen.host[by] and _ought(of, by, served, serves, heard)
        ]
        pairs = tuple(rtps_pairs(seen, [pair for pair in wanted if _visible(seen, *pair)]))
        yield Team("RTPS", number, _hosts(seen, members), tuple(members), pairs)


def _ought(of: int, by: int, served: set[int], serves: Array, heard: Array) -> bool:
    """Return whether one process of RTPS ought to know another one directly."""
    if of in served or by in served or serves[of] or serves[by]:
        # Clients know each other through their servers alone; servers, whom they are told of.
        between = bool(serves[of]) != bool(serves[by])
        return between and bool(np.isfinite([heard[of, by], heard[by, of]]).any())
    return True


def _visible(seen: Seen, of: int, by: int) -> bool:
    return seen.view is None or seen.view in (seen.host[of], seen.host[by])


def _hosts(seen: Seen, members: Iterable[int]) -> tuple[str, ...]:
    return tuple(dict.fromkeys(str(seen.host[one]) for one in members))


def scouting(seen: Seen) -> tuple[str, ...]:
    """Return the hosts that look for others of Zenoh by multicast."""
    rows = seen.rows[seen.of("kind", "Scout") & seen.multicast]
    return tuple(map(str, rows["sender"].unique()))


def _of_zenoh(seen: Seen) -> Iterable[Team]:
    table = seen.processes
    mine = np.flatnonzero((table["protocol"] == "Zenoh").to_numpy() & (seen.host != ""))
    scouts = scouting(seen)
    members = mine.tolist()
    hosts = tuple(dict.fromkeys((*_hosts(seen, members), *scouts)))
    if not hosts:
        return
    serves = table["server"].to_numpy(bool)
    client = (table["product"] == "Zenoh client").to_numpy()
    spoke = set(zip(seen.process.tolist(), seen.peer.tolist(), strict=True))
    wanted = []
    for of, by in permutations(members, 2):
        if seen.host[of] == seen.host[by] or not _visible(seen, of, by):
            continue
        linked = (of, by) in spoke or (by, of) in spoke
        peers = not (client[of] or client[by] or serves[of] or serves[by])
        if linked or (peers and seen.host[of] in scouts and seen.host[by] in scouts):
            wanted.append((of, by))
    yield Team("Zenoh", -1, hosts, tuple(members), tuple(zenoh_pairs(seen, wanted)))
