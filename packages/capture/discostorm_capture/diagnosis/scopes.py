"""Which processes ought to know each other: those of one protocol and domain."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import permutations

import numpy as np

from discostorm_capture.diagnosis.observations import Observations
from discostorm_capture.diagnosis.pairs import Pair, first_contacts, rtps_pairs, zenoh_pairs

#: Kinds of SPDP that only clients of a Discovery Server send: it is reliable between the two.
CLIENT = ("SPDP Heartbeat", "SPDP ACKNACK", "SPDP Gap")
#: Beyond every domain: processes with another domain tag are in another scope.
TAGGED = 1000


@dataclass(frozen=True)
class DiscoveryScope:
    """Processes that ought to know each other."""

    #: "RTPS" or "Zenoh".
    protocol: str
    #: The domain of RTPS; -1 if not known.
    domain: int
    #: Where they run; also hosts that only announce.
    hosts: tuple[str, ...]
    #: Their indices among the processes.
    members: tuple[int, ...]
    #: What is known of those on different hosts that ought to know each other.
    pairs: tuple[Pair, ...]


def scopes(obs: Observations) -> tuple[DiscoveryScope, ...]:
    """Return the scopes of a capture: one for each domain of RTPS, and one of Zenoh."""
    return (*_rtps_scopes(obs), *_zenoh_scope(obs))


def clients(obs: Observations) -> set[int]:
    """Return the processes of RTPS that use a Discovery Server."""
    return obs.senders(obs.isin("kind", *CLIENT)) - set(np.flatnonzero(obs.is_server).tolist())


def scouting(obs: Observations) -> tuple[str, ...]:
    """Return the hosts that look for others of Zenoh by multicast."""
    rows = obs.messages[obs.isin("kind", "Scout") & obs["multicast"]]
    return tuple(map(str, rows["sender"].unique()))


def _rtps_scopes(obs: Observations) -> Iterator[DiscoveryScope]:
    mine = np.flatnonzero(obs.is_rtps)
    domain = obs.processes["domain"].to_numpy(np.int64) + TAGGED * obs.tag
    known = np.unique(domain[mine][domain[mine] >= 0])
    if len(known) == 1:
        domain[mine] = known[0]
    served, serves, contact = clients(obs), obs.is_server, first_contacts(obs)

    def ought_to_discover(subject: int, observer: int) -> bool:
        """Tell whether a process of RTPS ought to know another one directly."""
        if {subject, observer} & served or serves[subject] or serves[observer]:
            # Clients know each other through their servers alone; servers, whom they are told of.
            between = bool(serves[subject] != serves[observer])
            spoke = np.isfinite([contact[subject, observer], contact[observer, subject]])
            return between and bool(spoke.any())
        return True

    for number in np.unique(domain[mine]).tolist():
        members = tuple(mine[domain[mine] == number].tolist())
        wanted = [pair for pair in _observable(obs, members) if ought_to_discover(*pair)]
        pairs = tuple(rtps_pairs(obs, wanted))
        yield DiscoveryScope("RTPS", number, obs.hosts_of(members), members, pairs)


def _zenoh_scope(obs: Observations) -> Iterator[DiscoveryScope]:
    members = tuple(np.flatnonzero((obs.processes["protocol"] == "Zenoh").to_numpy()).tolist())
    scouts = scouting(obs)
    hosts = tuple(dict.fromkeys((*obs.hosts_of(members), *scouts)))
    if not hosts:
        return
    calls_router = obs.is_server | (obs.processes["product"] == "Zenoh client").to_numpy()
    links = set(zip(obs.sender_index.tolist(), obs.receiver_index.tolist(), strict=True))
    wanted = [
        pair
        for pair in _observable(obs, members)
        if pair in links
        or pair[::-1] in links
        or (not calls_router[[*pair]].any() and {*obs.hosts_of(pair)} <= {*scouts})
    ]
    yield DiscoveryScope("Zenoh", -1, hosts, members, tuple(zenoh_pairs(obs, wanted)))


def _observable(obs: Observations, members: tuple[int, ...]) -> Iterator[tuple[int, int]]:
    """Yield the ordered pairs on different hosts whose unicast the capture has."""
    for pair in permutations(members, 2):
        hosts = obs.hosts_of(pair)
        if len(hosts) == 2 and obs.visible(*hosts):
            yield pair
