"""Who is on the channel: groups of like hosts, and what a fleet of them counts."""

import tomllib
from collections import Counter
from dataclasses import dataclass, replace
from functools import cached_property, reduce
from itertools import accumulate
from operator import add
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np
import sympy as sp
from numpy.typing import ArrayLike, NDArray

from discostorm import _checks, notation as nt
from discostorm._numeric import Polynomial, plain
from discostorm.data import read_data

#: A number, an array, a polynomial or a sympy expression: a fleet counts any of them alike.
Count = Any

#: What a group counts, and the least that is allowed; the most is `_checks.MOST`.
LEAST = {"hosts": 1, "processes": 1, "endpoints": 0}
COUNTS = tuple(LEAST)

#: Most groups in symbols: nobody reads as many, and what they count takes long to write out.
_MOST_SYMBOLIC = 1000


@dataclass(frozen=True, eq=False, repr=False)
class HostGroup:
    """Hosts that run the same software.

    Parameters
    ----------
    hosts : float, array or sympy.Expr
        Number of hosts in the group [1], from 1 to 1e9.
    processes : float, array or sympy.Expr
        Processes on each host [1], from 1 to 1e9.
    endpoints : float, array or sympy.Expr
        Endpoints of each process [1], from 0 to 1e9; of unlike processes, their mean.
    name : str, optional
        What to call it.
    nodes : float, optional
        Nodes with parameter services in each process [1], from 0 to as many as there are endpoints
        for, for `plan`; None if it is not known.
    shared : float or sympy.Expr, optional
        Endpoints of each process that match one in every other process, whatever the names of its
        others are [1], from 0 to `endpoints`. In ROS 2 those of topics with the same name
        everywhere: `discostorm.robots.shared_endpoints`.

    Raises
    ------
    ValueError
        If a number is NaN, infinite or out of range, or the shapes do not broadcast.
    TypeError
        If one is neither made of real numbers nor a sympy expression with symbols, or
        the name is not text.

    Examples
    --------
    >>> import discostorm as ds
    >>> ds.HostGroup(10, 1, 678, name="robots")
    HostGroup(hosts=10, processes=1, endpoints=678, name='robots')
    """

    hosts: Count
    processes: Count
    endpoints: Count
    name: str = ""
    nodes: float | None = None
    shared: Count = 0.0

    def __post_init__(self) -> None:
        _checks.instance("name", self.name, str)
        try:
            self._check()
        except (TypeError, ValueError) as error:
            if not self.name:
                raise
            raise type(error)(f"group {self.name!r}: {error}") from error

    def _check(self) -> None:
        """Check the numbers, and keep them as floats and arrays that nobody can change."""
        for count, least in LEAST.items():
            value = getattr(self, count)
            if (type(value) is float and least <= value <= _checks.MOST) or is_symbolic(value):
                continue
            value = _checks.numbers(count, value, least, _checks.MOST)
            if isinstance(value, np.ndarray):
                value = value + 0.0  # a copy, in which no zero is negative
                value.flags.writeable = False
            object.__setattr__(self, count, value)
        if not all(isinstance(count, float) for count in self.counts()):
            _checks.shape(**dict(zip(COUNTS, self.counts(), strict=True)))
        if self.nodes is not None:
            nodes = _checks.number("nodes", self.nodes, 0, _checks.MOST)
            check_nodes("nodes", nodes, self._fewest_endpoints)
            object.__setattr__(self, "nodes", nodes)
        if not is_symbolic(self.shared):
            most = self._fewest_endpoints
            shared = _checks.number("shared", self.shared, 0, most)
            object.__setattr__(self, "shared", shared)

    @property
    def _fewest_endpoints(self) -> float:
        """The endpoints that each process has at least; as many as can be if they are symbols."""
        if isinstance(self.endpoints, np.ndarray):
            return float(np.min(self.endpoints, initial=_checks.MOST))
        return self.endpoints if isinstance(self.endpoints, float) else _checks.MOST

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, HostGroup):
            return NotImplemented
        return self is other or self._key() == other._key()

    def __hash__(self) -> int:
        return hash(self._key())

    def __reduce__(self) -> tuple[type, tuple[Any, ...]]:
        # By way of the constructor, which makes the arrays read-only: also those of copies.
        return HostGroup, (*self.counts(), self.name, self.nodes, self.shared)

    def _key(self) -> tuple[Any, ...]:
        return (self.name, self.nodes, *map(_comparable, (*self.counts(), self.shared)))

    def counts(self) -> tuple[Count, ...]:
        """Return hosts, processes and endpoints."""
        return self.hosts, self.processes, self.endpoints

    def __repr__(self) -> str:
        parts = [
            f"{name}={_brief(count)}" for name, count in zip(COUNTS, self.counts(), strict=True)
        ]
        if self.name:
            parts.append(f"name={self.name!r}")
        if self.nodes is not None:
            parts.append(f"nodes={self.nodes:g}")
        if np.any(self.shared != 0):
            parts.append(f"shared={_brief(self.shared)}")
        return f"HostGroup({', '.join(parts)})"


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


@dataclass(frozen=True, repr=False)
class Fleet:
    """All hosts that share the channel.

    Parameters
    ----------
    groups : tuple of HostGroup
        At least one; their names, where given, differ.
    matching : float, optional
        Share of the endpoints that match one in every other process [1], from 0 to 1, beside
        those that always do: `HostGroup.shared`. Robots with ROS 2 namespaces of their own have 0,
        equal robots without have 1. Only tables of what products send depend on it.

    Raises
    ------
    ValueError
        If there is no group, two have the same name, their shapes do not broadcast, or `matching`
        is out of range.
    TypeError
        If one is not a HostGroup, or `matching` not a number.

    Examples
    --------
    >>> import discostorm as ds
    >>> robots = ds.HostGroup(2, 1, 678, name="robots")
    >>> laptop = ds.HostGroup(1, 1, 90, name="laptop")
    >>> round(ds.utilization(ds.DDS, ds.Fleet((robots, laptop))), 4)
    1.2014
    """

    groups: tuple[HostGroup, ...]
    matching: float = 0.0

    def __post_init__(self) -> None:
        matching = _checks.number("matching", self.matching, 0, 1)
        object.__setattr__(self, "matching", matching)
        object.__setattr__(self, "groups", _checks.members("groups", self.groups, HostGroup))
        names = Counter(group.name for group in self.groups if group.name)
        if twice := [name for name, times in names.items() if times > 1]:
            raise ValueError(f"groups must have names that differ; got {twice[0]!r} twice")
        _checks.shape(**self.arrays())

    def __repr__(self) -> str:
        matching = f", matching={self.matching:g}" if self.matching else ""
        return f"Fleet(groups={self.groups!r}{matching})"

    @classmethod
    def swarm(cls, hosts: Count, processes: Count, endpoints: Count) -> "Fleet":
        """Return the paper's homogeneous swarm: one group of like hosts."""
        return cls((HostGroup(hosts, processes, endpoints),))

    @classmethod
    def symbolic(cls, groups: int, matching: float = 0.0) -> "Fleet":
        """Return a fleet of that many groups in symbols; of one: the paper's N_H, N_P, N_E."""
        _checks.whole("groups", groups, 1, _MOST_SYMBOLIC)
        if groups == 1:
            return cls(SWARM.groups, matching)
        return cls(tuple(symbolic_group(index) for index in range(1, int(groups) + 1)), matching)

    @classmethod
    def from_toml(cls, path: str | PathLike[str]) -> "Fleet":
        """Return the fleet that a TOML file describes.

        The file has a table ``[[groups]]`` for each group of hosts, with one number each
        for ``hosts``, ``processes`` (of each host) and ``endpoints`` (of each process),
        and optionally a ``name``, ``nodes`` and ``shared``; see `HostGroup`. A group that tells
        ``nodes`` alone shares what ROS 2 does: `discostorm.robots.shared_endpoints`. Above the
        groups it may have ``matching``; see `Fleet`::

            matching = 0

            [[groups]]
            name = "robots"
            hosts = 10
            processes = 1
            endpoints = 678

        Parameters
        ----------
        path : str or path-like
            The file, in UTF-8.

        Returns
        -------
        Fleet
            Its groups in the order of the file.

        Raises
        ------
        OSError
            If the file cannot be read.
        ValueError
            If it is not TOML, or a key is missing, unknown or has a wrong value; the
            message names the file, the group, the key, the value and the allowed range.
        TypeError
            If `path` is neither text nor path-like.
        """
        name = _checks.path("path", path, "a TOML file")
        return cls.from_bytes(Path(name).read_bytes(), name)

    @classmethod
    def from_bytes(cls, content: bytes | bytearray | memoryview, name: str) -> "Fleet":
        """Return the fleet that the content of a TOML file describes; see `from_toml`.

        Errors call it by its name.
        """
        if not isinstance(content, (bytes, bytearray, memoryview)):
            raise TypeError(
                f"content must be bytes, a bytearray or a memoryview; got {_checks.short(content)}"
            )
        _checks.instance("name", name, str)
        try:
            # With a byte order mark, too, as Windows' editors write it.
            tables = tomllib.loads(bytes(content).decode("utf-8-sig").replace("\r\n", "\n"))
        except (UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
            raise ValueError(f"{name} must be a TOML file: {error}") from error
        except RecursionError:
            raise ValueError(f"{name} must be a TOML file; it is nested too deep to read") from None
        except ValueError:  # more digits than Python reads
            raise ValueError(f"{name} must be a TOML file of numbers with fewer digits") from None
        try:
            _only_keys(tables, ("groups", "matching"))
            groups = tables.get("groups")
            if not isinstance(groups, list) or not groups:
                raise ValueError(
                    f"it must have at least one [[groups]] table; got {_checks.short(groups)}"
                )
            matching = tables.get("matching", 0.0)
            if type(matching) not in (int, float):
                raise TypeError(
                    f"matching must be {_checks.wanted(0, 1)}; got {_checks.short(matching)}"
                )
            members = tuple(_group(index, table) for index, table in enumerate(groups, start=1))
            return cls(members, matching)
        except (TypeError, ValueError) as error:
            raise ValueError(f"{name}: {error}") from error

    def counts(self) -> tuple[Count, ...]:
        """Return hosts, processes and endpoints of one group after the other."""
        return tuple(count for group in self.groups for count in group.counts())

    def hosts(self) -> Count:
        """Return the number of hosts in the fleet."""
        return reduce(add, (group.hosts for group in self.groups))

    def once(self) -> Count:
        """Return 1, whatever is in the fleet; in its shape."""
        return 1 + 0 * self.hosts()

    def host_pairs(self) -> Count:
        """Return the number of ordered pairs of different hosts."""
        hosts = self.hosts()
        return hosts * (hosts - 1)

    def kinds_endpoints(self) -> Count:
        """Return the number of endpoints of one host of each group, added up."""
        present = (
            group.hosts > 0 if isinstance(group.hosts, np.ndarray) else 1 for group in self.groups
        )
        return reduce(
            add,
            (
                some * g.processes * g.endpoints
                for some, g in zip(present, self.groups, strict=True)
            ),
        )

    def processes(self) -> Count:
        """Return the number of processes in the fleet."""
        return reduce(add, (group.hosts * group.processes for group in self.groups))

    def pairs(self) -> Count:
        """Return the number of ordered pairs of processes on different hosts."""
        return reduce(add, self._pairs_from)

    def endpoint_pairs(self) -> Count:
        """Return the number of pairs of an endpoint and a process on another host."""
        pairs = zip(self._pairs_from, self.groups, strict=True)
        return reduce(add, (count * group.endpoints for count, group in pairs))

    @property
    def names(self) -> tuple[str, ...]:
        """What its groups are called; one without a name by its number, from 1 on."""
        given = {group.name for group in self.groups}
        numbers = (f"group {number}" for number in range(1, len(self.groups) + 1))
        return tuple(
            group.name or (f"{number} (unnamed)" if number in given else number)
            for group, number in zip(self.groups, numbers, strict=True)
        )

    def described(self) -> list[dict[str, Any]]:
        """Return its groups, of one number each, as what JSON can hold; keys as in `from_toml`."""
        return [
            {"name": name}
            | dict(
                zip((*COUNTS, "shared"), map(float, (*group.counts(), group.shared)), strict=True)
            )
            for name, group in zip(self.names, self.groups, strict=True)
        ]

    def endpoints(self) -> Count:
        """Return the number of endpoints in the fleet."""
        return reduce(add, (g.hosts * g.processes * g.endpoints for g in self.groups))

    def process_pairs(self) -> Count:
        """Return the number of ordered pairs of processes, on the same host or not."""
        processes = self.processes()
        return processes * (processes - 1)

    def thirds(self) -> Count:
        """Return the number of pairs of processes on different hosts, with a third one each."""
        return self.pairs() * (self.processes() - 2)

    def endpoint_thirds(self) -> Count:
        """Return the number of pairs of an endpoint and a process, with a third process each."""
        return self.endpoint_pairs() * (self.processes() - 2)

    def matched_writers(self) -> Count:
        """Return the number of pairs of a matched writer and a process on another host.

        Half of the endpoints are taken for writers.
        """
        pairs = zip(self._pairs_from, self.groups, strict=True)
        return reduce(add, (count * self._matched(group) for count, group in pairs)) / 2

    def unmatched(self) -> Count:
        """Return the number of pairs of an unmatched endpoint and a process on another host."""
        pairs = zip(self._pairs_from, self.groups, strict=True)
        return reduce(add, (count * self._unmatched(group) for count, group in pairs))

    def endpoint_processes(self) -> Count:
        """Return the number of pairs of an endpoint and another process, on any host."""
        return self.endpoints() * (self.processes() - 1)

    def lists(self) -> Count:
        """Return how many endpoints are listed if every process lists those that it has so far.

        It does so each time that it makes one: of :math:`N_E` endpoints
        :math:`N_E (N_E + 1) / 2` times.
        """
        return reduce(add, (g.hosts * g.processes * _listed(g) for g in self.groups))

    def list_pairs(self) -> Count:
        """Return the same as `lists` with each process on another host."""
        pairs = zip(self._pairs_from, self.groups, strict=True)
        return reduce(add, (count * _listed(group) for count, group in pairs))

    def unmatched_endpoints(self) -> Count:
        """Return the number of endpoints that match none."""
        return reduce(add, (g.hosts * g.processes * self._unmatched(g) for g in self.groups))

    def writers_that_match(self) -> Count:
        """Return the number of endpoints that match and write: half of those that match."""
        return self.matched() / 2

    def process_hosts(self) -> Count:
        """Return the number of pairs of a process and another host."""
        return self.processes() * (self.hosts() - 1)

    def endpoint_hosts(self) -> Count:
        """Return the number of pairs of an endpoint and another host."""
        return self.endpoints() * (self.hosts() - 1)

    def unmatched_hosts(self) -> Count:
        """Return the number of pairs of an unmatched endpoint and another host."""
        return self.unmatched_endpoints() * (self.hosts() - 1)

    def matched_hosts(self) -> Count:
        """Return the number of pairs of what matches on a host and another host.

        What matches one in every other process is the same in all processes of a host, and
        counts once.
        """
        names = reduce(add, (group.hosts * self._matched(group) for group in self.groups))
        return names * (self.hosts() - 1)

    def floods(self) -> Count:
        """Return how often hosts that are all linked pass on what is new of a link.

        That is: ends of links, times hosts that hear of one, times others that each tells.
        """
        others = self.hosts() - 1
        return self.host_pairs() * others * (others - 1)

    def matched_process_pairs(self) -> Count:
        """Return the number of ordered pairs of processes that match, on the same host or not.

        If any endpoints match, they do so in every pair; see `matching`.
        """
        return self.process_pairs() * self.matches()

    def matched_pairs(self) -> Count:
        """Return the number of ordered pairs of processes on different hosts that match."""
        return self.pairs() * self.matches()

    def matched_endpoints(self) -> Count:
        """Return the number of pairs of a matched endpoint and another process, on any host."""
        return self.matched() * (self.processes() - 1)

    def away(self) -> Count:
        """Return the number of processes on other hosts than one of the first group."""
        return self.processes() - self.groups[0].processes

    def endpoints_away(self) -> Count:
        """Return the number of endpoints on other hosts than one of the first group."""
        return self.endpoints() - self.groups[0].processes * self.groups[0].endpoints

    def matched_process_pairs_away(self) -> Count:
        """Return the number of pairs that match of a process `away` and another on any host."""
        return self.away() * (self.processes() - 1) * self.matches()

    def matched_endpoints_away(self) -> Count:
        """Return the number of pairs of a matched endpoint and another process `away`."""
        matched, first = self.matched(), self.groups[0]
        return matched * self.away() - (matched - first.processes * self._matched(first))

    def matches(self) -> Count:
        """Return 1 if anything matches, 0 if nothing does."""
        if self._of_numbers:
            return float(self.matching > 0 or any(group.shared for group in self.groups))
        some: Any = self.matching > 0
        for group in self.groups:
            shares = np.not_equal(group.shared, 0) if np.ndim(group.shared) else group.shared != 0
            # Where a group is left out it has no hosts; see `without`.
            some = some | (shares & (group.hosts > 0) if np.ndim(group.hosts) else bool(shares))
        return some * 1.0

    def matched(self) -> Count:
        """Return the number of endpoints that match one in every other process."""
        return reduce(add, (g.hosts * g.processes * self._matched(g) for g in self.groups))

    def _matched(self, group: HostGroup) -> Count:
        """Return how many of the endpoints of a process match one in every other."""
        shared = plain(group.shared) if isinstance(group.shared, float) else group.shared
        return shared + (group.endpoints - shared) * plain(self.matching)

    def _unmatched(self, group: HostGroup) -> Count:
        shared = plain(group.shared) if isinstance(group.shared, float) else group.shared
        return (group.endpoints - shared) * plain(1 - self.matching)

    def without(self, groups: range) -> "Fleet":
        """Return one fleet for each of some groups, which lacks its hosts: as arrays.

        Unlike that of any other fleet, a number of hosts may be 0.
        """
        lacking = []
        for index, group in enumerate(self.groups):
            gone = np.arange(groups.start, groups.stop) == index
            counts: dict[str, Any] = {"hosts": np.where(gone, 0.0, group.hosts)}
            if index == 0 and len(self.groups) > 1:
                # A server that was on one of its hosts is on one of the next group: see `away`.
                following = self.groups[1]
                counts["processes"] = np.where(gone, following.processes, group.processes)
                counts["endpoints"] = np.where(gone, following.endpoints, group.endpoints)
                counts["shared"] = np.where(gone, following.shared, group.shared)
            copy = object.__new__(HostGroup)
            vars(copy).update(vars(group) | counts)
            lacking.append(copy)
        return Fleet(tuple(lacking), self.matching)

    def arrays(self) -> dict[str, Count]:
        """Return the counts that are not single numbers, with their names."""
        if self._of_numbers:
            return {}
        return {
            f"groups[{index}].{name}": count
            for index, group in enumerate(self.groups)
            for name, count in zip(COUNTS, group.counts(), strict=True)
            if not isinstance(count, float)
        }

    @cached_property
    def _of_numbers(self) -> bool:
        """Whether all counts are single numbers."""
        return all(
            isinstance(count, float)
            for group in self.groups
            for count in (*group.counts(), group.shared)
        )

    @cached_property
    def _pairs_from(self) -> list[Count]:
        """For each group, its processes times the processes on other hosts."""
        own = [group.hosts * group.processes for group in self.groups]
        # What comes before and after is added up rather than subtracted from the total, which
        # would cancel.
        before, after = list(accumulate(own)), list(accumulate(reversed(own)))[::-1]
        pairs = []
        for index, group in enumerate(self.groups):
            remote = (group.hosts - 1) * group.processes
            if index:
                remote = remote + before[index - 1]
            if index + 1 < len(own):
                remote = remote + after[index + 1]
            pairs.append(own[index] * remote)
        return pairs


def _listed(group: HostGroup) -> Count:
    return group.endpoints * (group.endpoints + 1) / 2


def as_fleet(
    hosts: ArrayLike | Fleet, processes: ArrayLike | None, endpoints: ArrayLike | None
) -> Fleet:
    """Return the fleet that the arguments of `utilization` and `breakdown` describe."""
    given = {"processes": processes, "endpoints": endpoints}
    if isinstance(hosts, Fleet):
        for name, value in given.items():
            if value is not None:
                raise TypeError(
                    f"{name} must be left out when hosts is a Fleet; got {_checks.short(value)}"
                )
        fleet = hosts
    else:
        for name, value in given.items():
            if value is None:
                raise TypeError(f"{name} must be given unless hosts is a Fleet; got None")
        fleet = Fleet.swarm(hosts, processes, endpoints)
    reject_symbols(fleet)
    return fleet


def reject_symbols(fleet: Fleet) -> None:
    """Raise a TypeError if the fleet is in symbols."""
    for group in () if fleet._of_numbers else fleet.groups:
        for name, count in zip(COUNTS, group.counts(), strict=True):
            if is_symbolic(count):
                raise TypeError(
                    f"{name} must be a number here, not an expression; got {count}. "
                    "In symbols: Protocol.utilization"
                )


def is_symbolic(value: Any) -> bool:
    """Return whether it is an expression with an unknown, so that it has no value yet."""
    if isinstance(value, float):  # as nearly all are
        return False
    return isinstance(value, Polynomial) or (
        isinstance(value, sp.Expr) and bool(value.free_symbols)
    )


def symbolic_group(index: int) -> HostGroup:
    """Return a group in symbols: N_H1, N_P1 and N_E1 for index 1, and so on."""
    return HostGroup(*sp.symbols(f"N_H{index} N_P{index} N_E{index}", nonnegative=True))


def parameter_service_endpoints() -> int:
    """Return how many endpoints the parameter services of a node have [1]."""
    return sum(int(row["endpoints"]) for row in read_data("fleets/parameter_services.csv"))


def shared_endpoints(nodes: float = 0.0) -> float:
    """Return how many endpoints of a ROS 2 process match one in every other, whatever its names.

    Those of topics whose names no ROS 2 namespace changes: a writer and a reader of
    ``ros_discovery_info`` for each process, and of ``/parameter_events`` for each of its nodes
    (``fleets/shared_topics.csv``, with sources). It is assumed that ``/tf`` and the like are
    remapped into the namespace, and that nobody subscribes to ``/rosout``.

    Parameters
    ----------
    nodes : float, optional
        Nodes in the process [1]; 0 if left out, as of one that rclcpp did not make.

    Returns
    -------
    float
        How many [1].

    Examples
    --------
    >>> from discostorm.robots import shared_endpoints
    >>> shared_endpoints(), shared_endpoints(nodes=13)
    (2.0, 28.0)
    """
    per = {"process": 1.0, "node": _checks.number("nodes", nodes, 0, _checks.MOST)}
    rows = read_data("fleets/shared_topics.csv")
    return sum(per[row["per"]] * int(row["endpoints"]) for row in rows)


def check_nodes(name: str, nodes: float, endpoints: float) -> None:
    """Raise a ValueError unless a process of so many endpoints can have so many nodes."""
    each = parameter_service_endpoints()
    if nodes * each > endpoints:
        raise ValueError(
            f"{name} must be at most {endpoints / each:g} for processes of {endpoints:g} "
            f"endpoints, as the parameter services of a node have {each}; got {nodes:g}"
        )


def _comparable(count: Count) -> Any:
    """Return what two counts have in common if they are the same number, array or expression."""
    return (count.shape, count.tobytes()) if isinstance(count, np.ndarray) else count


def _brief(count: Count) -> str:
    if isinstance(count, np.ndarray):
        text = np.array2string(count, separator=", ", threshold=6, edgeitems=2)
        return " ".join(text.split())
    return str(count).removesuffix(".0")


def _only_keys(table: dict[str, Any], known: tuple[str, ...]) -> None:
    for key, value in table.items():
        if key not in known:
            raise ValueError(
                f"key must be {' or '.join(known)}; got {key} = {_checks.short(value)}"
            )


def _group(number: int, table: Any) -> HostGroup:
    """Return the group of one table of a fleet file; the error says which it is."""
    try:
        if not isinstance(table, dict):
            raise TypeError(
                f"it must be a table with {', '.join(COUNTS)}; got {_checks.short(table)}"
            )
        _only_keys(table, (*COUNTS, "name", "nodes", "shared"))
        for key, least in LEAST.items():
            allowed = _checks.wanted(least, _checks.MOST)
            if key not in table:
                raise ValueError(f"{key} is missing; it must be {allowed}")
            if type(table[key]) not in (int, float):
                raise TypeError(f"{key} must be {allowed}; got {_checks.short(table[key])}")
        for key in ("nodes", "shared"):
            if type(table.get(key, 0)) not in (int, float):
                allowed = _checks.wanted(0, _checks.MOST)
                raise TypeError(f"{key} must be {allowed}; got {_checks.short(table[key])}")
        group = HostGroup(**table | {"name": ""})
        if group.nodes is not None and "shared" not in table:
            group = replace(group, shared=min(shared_endpoints(group.nodes), group.endpoints))
        return replace(group, name=table.get("name", ""))
    except (TypeError, ValueError) as error:
        name = f" ({table['name']})" if isinstance(table, dict) and table.get("name") else ""
        raise ValueError(f"group {number}{name}: {error}") from error


#: The paper's swarm in symbols: every host runs N_P processes of N_E endpoints.
SWARM = Fleet.swarm(nt.N_H, nt.N_P, nt.N_E)
