"""What messages are counted by: one of what, to whom, and how many of them a fleet has.

A unit has two or three parts. *What* is sent for: a process, an endpoint, a host. *To* whom each
goes: to all at once, or once to each remote process, host or server. A *factor* multiplies both
where a third party has a say. `Unit.count` counts them in a fleet of groups; `Unit.senders` and
`Unit.receivers` name them, process by process, for those who follow each message.
"""

from dataclasses import dataclass
from typing import Any, Literal, get_args

import numpy as np
from numpy.typing import NDArray

from discostorm import _checks
from discostorm._numeric import plain
from discostorm.fleet import Count, Fleet

What = Literal[
    "process",
    "endpoint",
    "matched endpoint",
    "unmatched endpoint",
    "matched writer",
    "matched endpoint of others",
    "listed endpoint",
    "endpoint of a kind of host",
    "matched endpoint of a host",
    "host",
    "fleet",
]
To = Literal["all", "other process", "remote process", "other host", "server"]
Factor = Literal["third process", "third host", "match", "matched process", "link"]

#: Which end of a message has to be wireless, so that it takes the air on a hop: what it is sent
#: for; who receives it; or any host of the fleet, as all hear it.
End = Literal["holder", "receiver", "any"]


@dataclass(frozen=True, eq=False)
class Hosts:
    """A fleet of whole numbers, host by host, for those who name everybody.

    Parameters
    ----------
    processes, endpoints : ndarray
        Processes on each host, and endpoints of each of its processes [1].
    group : ndarray, optional
        The number of each host's group; all of one if left out.
    matching : float, optional
        That of the fleet [1].
    shared : ndarray, optional
        Of each host's processes, the endpoints that match in every other process [1].
    """

    processes: NDArray[np.int64]
    endpoints: NDArray[np.int64]
    group: NDArray[np.int64] | None = None
    matching: float = 0.0
    shared: NDArray[np.float64] | None = None

    @property
    def first(self) -> NDArray[np.int64]:
        """The number of the first process of each host."""
        return np.cumsum(self.processes) - self.processes

    @property
    def host_of(self) -> NDArray[np.int64]:
        """The host of each process."""
        return np.repeat(np.arange(self.processes.size), self.processes)

    @property
    def endpoints_of(self) -> NDArray[np.int64]:
        """The endpoints of each process [1]."""
        return self.endpoints[self.host_of]

    @property
    def matched_of(self) -> NDArray[np.float64]:
        """How many of the endpoints of each process match one in every other [1]."""
        shared = 0.0 * self.endpoints if self.shared is None else self.shared
        shared = shared[self.host_of]
        matched: NDArray[np.float64] = shared + (self.endpoints_of - shared) * self.matching
        return matched

    @property
    def matches(self) -> bool:
        """Whether anything matches."""
        return self.matching > 0 or (self.shared is not None and bool(self.shared.any()))

    @property
    def every(self) -> NDArray[np.int64]:
        """1 for each process."""
        return np.ones(self.host_of.size, np.int64)

    @property
    def speakers(self) -> NDArray[np.int64]:
        """1 for the first process of each host, 0 for others."""
        return np.isin(np.arange(self.host_of.size), self.first).astype(np.int64)

    @property
    def of_first_hosts(self) -> NDArray[np.int64]:
        """1 for each process on the first host of each group, 0 for others."""
        group = np.zeros_like(self.processes) if self.group is None else self.group
        _, first = np.unique(group, return_index=True)
        return np.isin(self.host_of, first).astype(np.int64)


@dataclass(frozen=True)
class Unit:
    """What a message is sent once, twice or more for; a fleet says how many there are.

    Parameters
    ----------
    what : str
        What there is one of. Half of the matched endpoints are taken for writers. A *listed
        endpoint* is in the list of its process each time that the process makes an endpoint: of
        :math:`N_E` endpoints :math:`N_E (N_E + 1) / 2` times. *Endpoint of a kind of host* counts
        one host of each group, *matched endpoint of a host* one process of each host.
    to : str, optional
        Who it is sent to: ``all`` at once if left out; to each ``other process``, but in one
        message for all; to each ``remote process``, on other hosts; to each ``other host``; to a
        ``server`` on a host of the first group, from the other hosts.
    factor : str, optional
        What multiplies the count: each ``third process`` or ``third host``; 1 if anything in the
        fleet matches and else 0 (``match``); each other process if anything matches (``matched
        process``); each end of a link that a further host hears of (``link``).
    group : int, optional
        Number of the group of the fleet that alone counts [1], from 0 on; all if left out. For user
        data.

    Raises
    ------
    ValueError
        If a part is none of these.

    Examples
    --------
    >>> Unit("endpoint", "remote process").count(Fleet.swarm(3, 2, 10))
    240.0
    """

    what: What
    to: To = "all"
    factor: Factor | None = None
    group: int | None = None

    def __post_init__(self) -> None:
        _checks.choice("what", self.what, get_args(What))
        _checks.choice("to", self.to, get_args(To))
        if self.factor is not None:
            _checks.choice("factor", self.factor, get_args(Factor), ", or None")

    @property
    def name(self) -> str:
        """What one of them is called, in data files as well."""
        names = {unit: name for name, unit in UNITS.items()}
        own = f"{self.what} to {self.to}" + (f" by {self.factor}" if self.factor else "")
        own += "" if self.group is None else f" of group {self.group + 1}"
        return names.get(self, own)

    @property
    def to_each(self) -> bool:
        """Whether each receiver gets its own, rather than all the same."""
        return self.to not in ("all", "other process")

    def count(self, fleet: Fleet, wireless: End | None = None) -> Count:
        """Return how many of them a fleet has: a number, array or expression, as its counts.

        Only those of which that end is ``wireless``, if one is given.
        """
        if wireless == "any" and all(group.wired for group in fleet.groups):
            return 0
        receivers = _receivers(self.to, fleet, wireless == "receiver")
        total: Count = 0
        for index, group in enumerate(fleet.groups):
            if (wireless == "holder" and group.wired) or self.group not in (None, index):
                continue
            own = _holders(self.what, fleet, index, away=self.to == "server")
            total = total + own * receivers[index] * _each(self.what, fleet, index)
        return total if self.factor is None else total * _factor(self.factor, fleet)

    def senders(self, hosts: Hosts) -> NDArray[Any]:
        """Return for how many of them each process sends: to all, or to each receiver [1]."""
        every, speakers = hosts.every, hosts.speakers
        if self.group is not None:
            mine = 0 * every if hosts.group is None else hosts.group[hosts.host_of]
            speakers = speakers * (mine == self.group)
        others = hosts.every.size - 1
        matched = hosts.matched_of
        sent: dict[What, NDArray[Any]] = {
            "process": every,
            "endpoint": hosts.endpoints_of,
            "matched endpoint": matched,
            "unmatched endpoint": hosts.endpoints_of - matched,
            "matched writer": matched / 2,
            "matched endpoint of others": matched.sum() - matched,
            "listed endpoint": hosts.endpoints_of * (hosts.endpoints_of + 1) / 2,
            "endpoint of a kind of host": hosts.endpoints_of * hosts.of_first_hosts,
            "matched endpoint of a host": speakers * matched,
            "host": speakers,
            "fleet": np.eye(1, every.size, dtype=np.int64).ravel(),
        }
        remote_hosts = hosts.processes.size - 1
        times: dict[Factor | None, float] = {
            None: 1,
            "third process": every.size - 2,
            "match": hosts.matches,
            "matched process": others * hosts.matches,
            "third host": remote_hosts - 1,
            "link": remote_hosts * (remote_hosts - 1),
        }
        if self.to == "other process":
            return sent[self.what] * others * times[self.factor]
        if self.to == "server":
            return sent[self.what] * times[self.factor] * (hosts.host_of > 0)
        return sent[self.what] * times[self.factor]

    def receivers(self, hosts: Hosts) -> NDArray[Any] | None:
        """Return 1 for each process that receives from each on another host, else 0.

        None if each goes to all at once.
        """
        if self.to == "remote process":
            return hosts.every
        if self.to == "other host":
            return hosts.speakers
        if self.to == "server":
            return np.eye(1, hosts.every.size, dtype=np.int64).ravel()
        return None


def _holders(what: What, fleet: Fleet, index: int, away: bool) -> Count:
    """Return how many processes or hosts of a group have some, perhaps away from the server."""
    group = fleet.groups[index]
    if what in ("host", "matched endpoint of a host"):
        return group.hosts
    if what == "endpoint of a kind of host":
        return group.processes
    if what == "fleet":
        return int(index == 0)
    if away and index == 0:
        return (group.hosts - 1) * group.processes
    return fleet.processes_of[index]


def _each(what: What, fleet: Fleet, index: int) -> Count:
    """Return how many of them one process or host of a group has."""
    group = fleet.groups[index]
    if what in ("endpoint", "endpoint of a kind of host"):
        return group.endpoints
    if what in ("matched endpoint", "matched endpoint of a host"):
        return fleet.matched_of[index]
    if what == "unmatched endpoint":
        return (group.endpoints - plain(group.shared)) * plain(1 - fleet.matching)
    if what == "matched writer":
        return fleet.matched_of[index] / 2
    if what == "matched endpoint of others":
        return fleet.matched_in_all - fleet.matched_of[index]
    if what == "listed endpoint":
        return group.endpoints * (group.endpoints + 1) / 2
    return 1


def _receivers(to: To, fleet: Fleet, wireless: bool) -> list[Count]:
    """Return how many of these, perhaps of the wireless ones, one of each group sends to."""
    hears = [not (wireless and group.wired) for group in fleet.groups]
    if to == "all":
        return [1] * len(hears)
    if to == "server":
        return [int(hears[0])] * len(hears)
    if to == "remote process":
        return fleet.wireless_remote_of if wireless else fleet.remote_of
    many = fleet.processes_of if to == "other process" else [g.hosts for g in fleet.groups]
    total = sum(number for number, hear in zip(many, hears, strict=True) if hear)
    return [total - int(hear) for hear in hears]


def _factor(factor: Factor, fleet: Fleet) -> Count:
    if factor == "third process":
        return fleet.processes() - 2
    if factor == "third host":
        return fleet.hosts() - 2
    if factor == "match":
        return fleet.matches()
    if factor == "matched process":
        return (fleet.processes() - 1) * fleet.matches()
    others = fleet.hosts() - 1
    return others * (others - 1)


@dataclass(frozen=True)
class OnAir:
    """Those of a unit whose messages take the air on one hop, in a fleet with wired hosts."""

    unit: Unit
    wireless: End

    def count(self, fleet: Fleet) -> Count:
        """Return how many of them a fleet has."""
        return self.unit.count(fleet, self.wireless)


#: All of them by what data files call them.
UNITS = {
    "process": Unit("process"),
    "ordered pair of processes on different hosts": Unit("process", "remote process"),
    "endpoint and process on another host": Unit("endpoint", "remote process"),
    "endpoint": Unit("endpoint"),
    "ordered pair of processes": Unit("process", "other process"),
    # What a third process occasions between two.
    "ordered pair of processes on different hosts and third process": Unit(
        "process", "remote process", "third process"
    ),
    "endpoint, process on another host and third process": Unit(
        "endpoint", "remote process", "third process"
    ),
    "matched writer, process on another host and third process": Unit(
        "matched writer", "remote process", "third process"
    ),
    "matched writer and process on another host": Unit("matched writer", "remote process"),
    "host": Unit("host"),
    "ordered pair of hosts": Unit("host", "other host"),
    "endpoint of a kind of host": Unit("endpoint of a kind of host"),
    "fleet": Unit("fleet"),
    "unmatched endpoint and process on another host": Unit("unmatched endpoint", "remote process"),
    "endpoint and other process": Unit("endpoint", "other process"),
    "two endpoints of a process, or one twice": Unit("listed endpoint"),
    "two endpoints of a process, or one twice, and process on another host": Unit(
        "listed endpoint", "remote process"
    ),
    "unmatched endpoint": Unit("unmatched endpoint"),
    "matched writer": Unit("matched writer"),
    # What routers, one a host, tell each other of what is behind them.
    "process and other host": Unit("process", "other host"),
    "endpoint and other host": Unit("endpoint", "other host"),
    "unmatched endpoint and other host": Unit("unmatched endpoint", "other host"),
    "matched endpoint of a host and other host": Unit("matched endpoint of a host", "other host"),
    # The news of a link that each router passes on to all others.
    "matched endpoint of a host": Unit("matched endpoint of a host"),
    "ordered pair of hosts and third host": Unit("host", "other host", "third host"),
    "end of a link, host that hears of it and other that it tells": Unit(
        "host", "other host", "link"
    ),
    # What a server passes on from one to another, wherever they run.
    "ordered pair of matched processes": Unit("process", "other process", "match"),
    "ordered pair of matched processes on different hosts": Unit(
        "process", "remote process", "match"
    ),
    "matched endpoint and other process": Unit("matched endpoint", "other process"),
    # With a server on a robot, messages of that robot's own processes take no air.
    "process away from the server": Unit("process", "server"),
    "endpoint away from the server": Unit("endpoint", "server"),
    "ordered pair of matched processes, one away from the server": Unit(
        "process", "server", "matched process"
    ),
    "matched endpoint and other process away from the server": Unit(
        "matched endpoint of others", "server"
    ),
}

PROCESS = UNITS["process"]
PAIR = UNITS["ordered pair of processes on different hosts"]
ENDPOINT_PAIR = UNITS["endpoint and process on another host"]
ENDPOINT = UNITS["endpoint"]
HOST = UNITS["host"]
HOST_PAIR = UNITS["ordered pair of hosts"]
KIND_ENDPOINT = UNITS["endpoint of a kind of host"]
FLEET = UNITS["fleet"]
MATCHED_WRITER = UNITS["matched writer and process on another host"]
UNMATCHED = UNITS["unmatched endpoint and process on another host"]
#: Who simulates these takes the first host for the server's, and has both ways sent by who is
#: away from it.
AWAY = {
    PROCESS: UNITS["process away from the server"],
    ENDPOINT: UNITS["endpoint away from the server"],
    UNITS["ordered pair of matched processes"]: UNITS[
        "ordered pair of matched processes, one away from the server"
    ],
    UNITS["matched endpoint and other process"]: UNITS[
        "matched endpoint and other process away from the server"
    ],
}
