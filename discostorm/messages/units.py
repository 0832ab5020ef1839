"""Units that count messages: an entity, its receivers, and how many of both a fleet has.

*What*: the entity that each message is about, a process, an endpoint or a host (`ENTITIES`). *To*:
its receivers, all at once or each remote process, host or server (`To`). A *factor* scales the
count, such as by matches (`FACTORS`).
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, Literal, NamedTuple, get_args

import numpy as np
from numpy.typing import NDArray

from discostorm import _checks
from discostorm._numeric import int_if_integral
from discostorm.data import read_data
from discostorm.fleet import Count, Fleet, HostGroup

#: Receivers of a message: all at once by multicast, or each receiver separately.
To = Literal["all", "other process", "remote process", "other host", "server"]
#: The processes that send a counted message: each process, the first process of each host, each
#: process of the first host of each group, or the first process of the fleet.
ProcessSet = Literal["process", "host", "first host of a group", "first process"]
#: The end that has to be wireless for a hop to take airtime: the sender of a message, its receiver,
#: or any host of the fleet, if all hosts receive the message.
WirelessEnd = Literal["sender", "receiver", "any"]

#: For each counted entity: the processes that send for it, and the property of `Hosts` to sum.
ENTITIES: dict[str, tuple[ProcessSet, str]] = {
    "process": ("process", "ones"),
    "endpoint": ("process", "endpoints_per_process"),
    "matched endpoint": ("process", "matched_per_process"),
    "unmatched endpoint": ("process", "unmatched_per_process"),
    "unknown type": ("process", "unknown_types_per_process"),
    "matched writer": ("process", "matched_writers"),
    "matched endpoint of others": ("process", "matched_elsewhere"),
    "listed endpoint": ("process", "list_entries_per_process"),
    "endpoint of a kind of host": ("first host of a group", "endpoints_per_process"),
    "matched endpoint of a host": ("host", "matched_of_host"),
    "host": ("host", "ones"),
    "fleet": ("first process", "ones"),
}


class FleetTotals(NamedTuple):
    """The processes and hosts of a fleet, and whether any endpoints match (1 or 0)."""

    processes: Count
    hosts: Count
    matches: float


#: Factors of a count: processes or hosts besides the sender and its receiver.
FACTORS: dict[str, Callable[[FleetTotals], Count]] = {
    "third process": lambda fleet: fleet.processes - 2,
    "third host": lambda fleet: fleet.hosts - 2,
    "match": lambda fleet: fleet.matches,
    "matched process": lambda fleet: (fleet.processes - 1) * fleet.matches,
    "link": lambda fleet: (fleet.hosts - 1) * (fleet.hosts - 2),
}


def _list_lengths(endpoints: Any) -> Any:
    """Return the total length of the lists that a process sends while it creates endpoints [1]."""
    return endpoints * (endpoints + 1) / 2


def _list_entries(group: HostGroup) -> Count:
    """Return the entries of all lists that a process of a group sends, in the mean [1]."""
    sizes = group.process_sizes
    lists = sum(size.count * _list_lengths(size.endpoints) for size in sizes) / group.processes
    return lists if sizes else _list_lengths(group.endpoints)


def _unmatched(group: HostGroup, matching: float) -> Count:
    return (group.endpoints - int_if_integral(group.shared)) * int_if_integral(1 - matching)


#: Functions of a fleet and a group's index that count what a process has, by names in `Hosts`.
_PER_PROCESS: dict[str, Callable[[Fleet, int], Count]] = {
    "ones": lambda *_: 1,
    "endpoints_per_process": lambda fleet, index: fleet.groups[index].endpoints,
    "list_entries_per_process": lambda fleet, index: _list_entries(fleet.groups[index]),
    "matched_per_process": lambda fleet, index: fleet.matched_per_process[index],
    "matched_of_host": lambda fleet, index: fleet.matched_per_process[index],
    "matched_writers": lambda fleet, index: fleet.matched_per_process[index] / 2,
    "unmatched_per_process": lambda fleet, index: _unmatched(fleet.groups[index], fleet.matching),
    "unknown_types_per_process": lambda fleet, index: fleet.unknown_types_per_process[index],
    "matched_elsewhere": lambda fleet, i: fleet.matched_in_all - fleet.matched_per_process[i],
}


@dataclass(frozen=True, eq=False)
class Hosts:
    """A table of a fleet's hosts; its properties are arrays with one value per process.

    `processes` counts the processes of each host, `endpoints` the endpoints of each process: one
    number per host, or one per process of the fleet. `group` is the index of each host's group; 0
    if left out. `Fleet` and `HostGroup` explain `matching`, `shared` and `own_types`.
    """

    processes: NDArray[np.int64]
    endpoints: NDArray[np.int64]
    group: NDArray[np.int64] | None = None
    matching: float = 0.0
    shared: NDArray[np.float64] | None = None
    own_types: NDArray[np.float64] | None = None
    first: NDArray[np.int64] = field(init=False)  #: index of the first process of each host
    host_of: NDArray[np.int64] = field(init=False)
    group_of: NDArray[np.int64] = field(init=False)
    ones: NDArray[np.int64] = field(init=False)  #: 1 for each process
    endpoints_per_process: NDArray[np.int64] = field(init=False)
    list_entries_per_process: NDArray[np.float64] = field(init=False)
    matched_per_process: NDArray[np.float64] = field(init=False)
    matched_writers: NDArray[np.float64] = field(init=False)
    matched_of_host: NDArray[np.float64] = field(init=False)  #: mean of the host's processes
    unmatched_per_process: NDArray[np.float64] = field(init=False)
    unknown_types_per_process: NDArray[np.float64] = field(init=False)
    matched_elsewhere: NDArray[np.float64] = field(init=False)  #: sum over other processes
    matches: bool = field(init=False)

    def __post_init__(self) -> None:
        host_of = np.repeat(np.arange(self.processes.size), self.processes)
        ones = np.ones(host_of.size, np.int64)
        endpoints = self.endpoints
        if endpoints.size != ones.size:
            endpoints = endpoints[host_of]
        shared = 0.0 * endpoints if self.shared is None else self.shared[host_of]
        matched = shared + (endpoints - shared) * self.matching
        of_hosts = np.bincount(host_of, matched, self.processes.size) / self.processes
        derived = {
            "first": np.cumsum(self.processes) - self.processes,
            "host_of": host_of,
            "group_of": 0 * ones if self.group is None else self.group[host_of],
            "ones": ones,
            "endpoints_per_process": endpoints,
            "list_entries_per_process": _list_lengths(endpoints),
            "matched_per_process": matched,
            "matched_writers": matched / 2,
            "matched_of_host": of_hosts[host_of],
            "unmatched_per_process": endpoints - matched,
            "unknown_types_per_process": self._unknown_types()[host_of],
            "matched_elsewhere": matched.sum() - matched,
            "matches": self.matching > 0 or bool(shared.any()),
        }
        for name, value in derived.items():
            object.__setattr__(self, name, value)

    def _unknown_types(self) -> NDArray[np.float64]:
        """Return how many types of other processes a process of each host lacks."""
        own = np.zeros(self.processes.size) if self.own_types is None else self.own_types
        groups = np.zeros(own.size, np.int64) if self.group is None else self.group
        _, first = np.unique(groups, return_index=True)
        return np.sum((self.processes * own)[first]) - own

    def process_mask(self, process_set: ProcessSet) -> NDArray[np.int64]:
        """Return 1 for each process of a set, else 0."""
        if process_set == "process":
            return self.ones
        if process_set == "first host of a group":
            _, first = np.unique(self.group_of, return_index=True)
            return np.isin(self.host_of, self.host_of[first]).astype(np.int64)
        chosen = self.first if process_set == "host" else self.first[:1]
        return np.isin(np.arange(self.host_of.size), chosen).astype(np.int64)


@dataclass(frozen=True)
class Unit:
    """A unit by which messages are counted; a fleet has a number of each unit.

    Parameters
    ----------
    what : str
        The entity that is counted, a key of `ENTITIES`. Half of the matched endpoints count as
        writers. A *listed endpoint* counts once for each list of endpoints that its process sends.
    to : str, optional
        Who it is sent to: ``all`` at once if left out; to each ``other process``, but in one
        message for all; to each ``remote process``, on other hosts; to each ``other host``; to a
        ``server`` on a host of the first group, from the other hosts.
    factor : str, optional
        What multiplies the count, a key of `FACTORS`.
    group : int, optional
        Index of the group of the fleet that alone counts [1]; all if left out. For user data.
    wireless : {"sender", "receiver", "any"}, optional
        The end that has to be wireless to count, in a fleet with wired hosts.
    """

    what: str
    to: To = "all"
    factor: str | None = None
    group: int | None = None
    wireless: WirelessEnd | None = None

    def __post_init__(self) -> None:
        _checks.choice("what", self.what, list(ENTITIES))
        _checks.choice("to", self.to, get_args(To))
        if self.factor is not None:
            _checks.choice("factor", self.factor, list(FACTORS), ", or None")

    @property
    def name(self) -> str:
        """The name in data files; the parts of the unit if no file names it."""
        names = {unit: name for name, unit in UNITS.items()}
        parts = f"{self.what} to {self.to}" + (f" by {self.factor}" if self.factor else "")
        parts += "" if self.group is None else f" of group {self.group + 1}"
        return names.get(self, parts)

    @property
    def to_each(self) -> bool:
        """Whether each receiver gets a separate message."""
        return self.to not in ("all", "other process")

    def count(self, fleet: Fleet) -> Count:
        """Return the number of these units in a fleet: a number, array or expression."""
        if self.wireless == "any" and all(group.wired for group in fleet.groups):
            return 0
        process_set, quantity = ENTITIES[self.what]
        receivers = self._receivers_per_sender(fleet)
        total: Count = 0
        for index, group in enumerate(fleet.groups):
            if (self.wireless == "sender" and group.wired) or self.group not in (None, index):
                continue
            at_server = int(self.to == "server" and index == 0)
            senders = {
                "process": (group.hosts - at_server) * group.processes,
                "host": group.hosts,
                "first host of a group": group.processes,
                "first process": int(index == 0),
            }[process_set]
            total = total + senders * receivers[index] * _PER_PROCESS[quantity](fleet, index)
        if self.factor is None:
            return total
        totals = FleetTotals(fleet.processes(), fleet.hosts(), fleet.matches())
        return total * FACTORS[self.factor](totals)

    def _receivers_per_sender(self, fleet: Fleet) -> list[Count]:
        """Return the number of receivers of one sender, for each group."""
        counted = [not (self.wireless == "receiver" and group.wired) for group in fleet.groups]
        if self.to == "all":
            return [1] * len(counted)
        if self.to == "server":
            return [int(counted[0])] * len(counted)
        if self.to == "remote process":
            wireless = self.wireless == "receiver"
            return fleet.wireless_remote_processes if wireless else fleet.remote_processes
        hosts = [group.hosts for group in fleet.groups]
        each = fleet.processes_per_group if self.to == "other process" else hosts
        total = sum(count for count, yes in zip(each, counted, strict=True) if yes)
        return [total - int(yes) for yes in counted]

    def units_per_process(self, hosts: Hosts) -> NDArray[Any]:
        """Return the number of these units that each process sends, per receiver or for all [1]."""
        process_set, quantity = ENTITIES[self.what]
        processes = hosts.ones.size
        sent: NDArray[Any] = hosts.process_mask(process_set) * getattr(hosts, quantity)
        if self.factor is not None:
            totals = FleetTotals(processes, hosts.processes.size, hosts.matches)
            sent = sent * FACTORS[self.factor](totals)
        if self.group is not None:
            sent = sent * (hosts.group_of == self.group)
        if self.to == "other process":
            return sent * (processes - 1)
        return sent * (hosts.host_of > 0) if self.to == "server" else sent

    def receiver_mask(self, hosts: Hosts) -> NDArray[Any] | None:
        """Return 1 for each process that receives from other hosts, else 0.

        None if a message goes to all processes at once.
        """
        if not self.to_each:
            return None
        process_sets: dict[str, ProcessSet] = {"remote process": "process", "other host": "host"}
        return hosts.process_mask(process_sets.get(self.to, "first process"))


#: Units by their names in data files.
UNITS = {
    row["unit"]: Unit(row["what"], row["to"], row["factor"] or None)  # type: ignore[arg-type]
    for row in read_data("vendors/units.csv")
}

PROCESS = UNITS["process"]
PAIR = UNITS["ordered pair of processes on different hosts"]
ENDPOINT_PAIR = UNITS["endpoint and process on another host"]
ENDPOINT = UNITS["endpoint"]
HOST = UNITS["host"]
MATCHED_WRITER = UNITS["matched writer and process on another host"]
#: Units for a server on a robot, by the units for a wired server. Messages of the server's own host
#: are left out, because they take no airtime; messages of other hosts take two hops.
UNIT_IF_SERVER_ON_ROBOT = {
    PROCESS: Unit("process", "server"),
    ENDPOINT: Unit("endpoint", "server"),
    Unit("process", "other process", "match"): Unit("process", "server", "matched process"),
    Unit("matched endpoint", "other process"): Unit("matched endpoint of others", "server"),
}
