"""What messages are counted by: what one of it is called, how many a fleet has, who sends them."""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from discostorm import _checks
from discostorm.fleet import Count, Fleet, Hosts

#: Takes the hosts one by one, returns a number for each of their processes.
OfProcesses = Callable[[Hosts], NDArray[Any]]


@dataclass(frozen=True)
class Unit:
    """What a message is sent once, twice or more for; a fleet says how many there are.

    Who sends and who receives matters to those who name each message, such as `simulate`.
    The sum of the senders' numbers, for pairs over the receivers on other hosts, is the count.

    Parameters
    ----------
    name : str
        What one of them is called.
    count : callable
        Takes a `Fleet`, returns how many of them it has [1].
    senders : callable, optional
        Takes `discostorm.fleet.Hosts`, returns for each process how many of them it sends for
        [1]: in all, or to each receiver.
    receivers : callable, optional
        Takes the same, returns 1 for each process that receives from each on another host, else
        0. None if it is no unit of pairs: what is sent for it is for all, or for a peer that is
        wired to the access point.
    """

    name: str
    # How a function is shown has its address in it, which is another one each time.
    count: Callable[[Fleet], Count] = field(repr=False)
    senders: OfProcesses | None = field(default=None, repr=False)
    receivers: OfProcesses | None = field(default=None, repr=False)

    def __post_init__(self) -> None:
        _checks.instance("name", self.name, str)
        if not callable(self.count):
            raise TypeError(
                f"count must take a Fleet and return how many; got {_checks.short(self.count)}"
            )
        for side in ("senders", "receivers"):
            if not (getattr(self, side) is None or callable(getattr(self, side))):
                raise TypeError(
                    f"{side} must take Hosts and return a number for each process; "
                    f"got {getattr(self, side)!r}"
                )


def _every(hosts: Hosts) -> NDArray[Any]:
    return hosts.every


def _speakers(hosts: Hosts) -> NDArray[Any]:
    return hosts.speakers


def _endpoints(hosts: Hosts) -> NDArray[Any]:
    return hosts.endpoints_of


def _others(hosts: Hosts) -> NDArray[Any]:
    return hosts.every * (hosts.every.size - 1)


def _thirds(hosts: Hosts) -> NDArray[Any]:
    return hosts.every * (hosts.every.size - 2)


def _endpoint_thirds(hosts: Hosts) -> NDArray[Any]:
    return hosts.endpoints_of * (hosts.every.size - 2)


def _matched(hosts: Hosts) -> NDArray[Any]:
    return hosts.matched_of / 2


def _unmatched(hosts: Hosts) -> NDArray[Any]:
    return hosts.endpoints_of - hosts.matched_of


def _of_kinds(hosts: Hosts) -> NDArray[Any]:
    return hosts.endpoints_of * hosts.of_first_hosts


def _once(hosts: Hosts) -> NDArray[Any]:
    return np.eye(1, hosts.every.size, dtype=np.int64).ravel()


def _endpoint_processes(hosts: Hosts) -> NDArray[Any]:
    return hosts.endpoints_of * (hosts.every.size - 1)


def _listed(hosts: Hosts) -> NDArray[Any]:
    return hosts.endpoints_of * (hosts.endpoints_of + 1) / 2


def _if_matched(hosts: Hosts) -> NDArray[Any]:
    return hosts.every * hosts.matches


def _matched_others(hosts: Hosts) -> NDArray[Any]:
    return _others(hosts) * hosts.matches


def _matched_endpoints(hosts: Hosts) -> NDArray[Any]:
    return hosts.matched_of * (hosts.every.size - 1)


def _away(hosts: Hosts) -> NDArray[Any]:
    away: NDArray[Any] = hosts.every * (hosts.host_of > 0)
    return away


def _endpoints_away(hosts: Hosts) -> NDArray[Any]:
    away: NDArray[Any] = hosts.endpoints_of * (hosts.host_of > 0)
    return away


def _matched_others_away(hosts: Hosts) -> NDArray[Any]:
    others: NDArray[Any] = _matched_others(hosts) * _away(hosts)
    return others


def _matched_endpoints_away(hosts: Hosts) -> NDArray[Any]:
    others = hosts.matched_of.sum() - hosts.matched_of
    passed: NDArray[Any] = others * _away(hosts)
    return passed


def _matched_behind(hosts: Hosts) -> NDArray[Any]:
    return hosts.speakers * hosts.matched_of


def _floods(hosts: Hosts) -> NDArray[Any]:
    others = hosts.processes.size - 1
    return hosts.speakers * (others * (others - 1))


PROCESS = Unit("process", Fleet.processes, _every)
PAIR = Unit("ordered pair of processes on different hosts", Fleet.pairs, _every, _every)
ENDPOINT_PAIR = Unit(
    "endpoint and process on another host", Fleet.endpoint_pairs, _endpoints, _every
)
ENDPOINT = Unit("endpoint", Fleet.endpoints, _endpoints)
#: For what each process sends to the group for each of the others, wherever they run.
PROCESS_PAIR = Unit("ordered pair of processes", Fleet.process_pairs, _others)
#: For what a third process occasions between two.
THIRD = Unit(
    "ordered pair of processes on different hosts and third process",
    Fleet.thirds,
    _thirds,
    _every,
)
ENDPOINT_THIRD = Unit(
    "endpoint, process on another host and third process",
    Fleet.endpoint_thirds,
    _endpoint_thirds,
    _every,
)
MATCHED_WRITER = Unit(
    "matched writer and process on another host", Fleet.matched_writers, _matched, _every
)
HOST = Unit("host", Fleet.hosts, _speakers)
HOST_PAIR = Unit("ordered pair of hosts", Fleet.host_pairs, _speakers, _speakers)
#: For what is sent once, however many hosts run the same software.
KIND_ENDPOINT = Unit("endpoint of a kind of host", Fleet.kinds_endpoints, _of_kinds)
#: For what the whole fleet sends once.
FLEET = Unit("fleet", Fleet.once, _once)
UNMATCHED = Unit(
    "unmatched endpoint and process on another host", Fleet.unmatched, _unmatched, _every
)
ENDPOINT_PROCESS = Unit("endpoint and other process", Fleet.endpoint_processes, _endpoint_processes)
#: For a list of the endpoints that are made so far, told each time that one is made.
LISTED = Unit("two endpoints of a process, or one twice", Fleet.lists, _listed)
LISTED_PAIR = Unit(
    "two endpoints of a process, or one twice, and process on another host",
    Fleet.list_pairs,
    _listed,
    _every,
)
UNMATCHED_ENDPOINT = Unit("unmatched endpoint", Fleet.unmatched_endpoints, _unmatched)
WRITER = Unit("matched writer", Fleet.writers_that_match, _matched)
#: For what routers, one a host, tell each other of what is behind them.
PROCESS_HOST = Unit("process and other host", Fleet.process_hosts, _every, _speakers)
ENDPOINT_HOST = Unit("endpoint and other host", Fleet.endpoint_hosts, _endpoints, _speakers)
UNMATCHED_HOST = Unit(
    "unmatched endpoint and other host", Fleet.unmatched_hosts, _unmatched, _speakers
)
MATCHED_HOST = Unit(
    "matched endpoint of a host and other host", Fleet.matched_hosts, _matched_behind, _speakers
)
#: For the news of a link that each router passes on to all others.
FLOOD = Unit(
    "end of a link, host that hears of it and other that it tells", Fleet.floods, _floods, _speakers
)
#: For what a server passes on from one to another, wherever they run.
MATCHED_PROCESS_PAIR = Unit(
    "ordered pair of matched processes", Fleet.matched_process_pairs, _matched_others
)
MATCHED_PAIR = Unit(
    "ordered pair of matched processes on different hosts", Fleet.matched_pairs, _if_matched, _every
)
MATCHED_ENDPOINT = Unit(
    "matched endpoint and other process", Fleet.matched_endpoints, _matched_endpoints
)
#: Of a server on a host of the first group: what is on that host takes no air on its way to it.
#: Who simulates these takes the first host, and has both ways sent by who is away.
AWAY = Unit("process away from the server", Fleet.away, _away, _once)
ENDPOINT_AWAY = Unit("endpoint away from the server", Fleet.endpoints_away, _endpoints_away, _once)
MATCHED_PROCESS_PAIR_AWAY = Unit(
    "ordered pair of matched processes, one away from the server",
    Fleet.matched_process_pairs_away,
    _matched_others_away,
    _once,
)
MATCHED_ENDPOINT_AWAY = Unit(
    "matched endpoint and other process away from the server",
    Fleet.matched_endpoints_away,
    _matched_endpoints_away,
    _once,
)

#: All of them by name.
UNITS = {value.name: value for value in tuple(globals().values()) if isinstance(value, Unit)}
