"""Fleets: the groups of identical hosts on a channel, and their counts."""

from dataclasses import asdict, dataclass, replace
from functools import cached_property, reduce
from itertools import accumulate
from operator import add
from os import PathLike
from typing import Any

import sympy as sp
from numpy.typing import ArrayLike

from discostorm import _checks, notation as nt
from discostorm._numeric import int_if_integral
from discostorm.cells import Cell as Cell, check_cells
from discostorm.files import open_input
from discostorm.fleet_file import (
    COUNTS as COUNTS,
    MAX_BYTES as MAX_BYTES,
    MAX_DOMAIN,
    MIN_COUNTS as MIN_COUNTS,
    check_tables,
    error_context,
    fleet_tables,
)
from discostorm.flows import flow_from_table
from discostorm.host_group import (
    Count as Count,
    HostGroup as HostGroup,
    Process as Process,
    is_symbolic as is_symbolic,
)
from discostorm.robots import robot
from discostorm.ros2_endpoints import likely_shared
from discostorm.ros_releases import distribution_name

#: Maximum number of symbolic groups; more groups make very long expressions.
_MAX_SYMBOLIC_GROUPS = 1000


@dataclass(frozen=True, repr=False)
class Fleet:
    """All hosts that share the channel.

    Parameters
    ----------
    groups : tuple of HostGroup
        At least one; their names, where given, differ.
    matching : float, optional
        Share of the endpoints that match one in every other process [1], from 0 to 1, beside
        those that always do: `HostGroup.shared`. Robots with their own ROS 2 namespaces have 0,
        identical robots without have 1. Only tables of products depend on it.
    ros : str, optional
        The ROS 2 distribution of its hosts, such as "jazzy". Commands take the release it ships.
    within : float, optional
        Target of the discovery time for `plan` [s], above 0.
    domain, addresses : int, and tuple of (str, str), optional
        ROS_DOMAIN_ID, to 232 [1], and names of hosts with addresses, for ``plan --write``.
    cells : tuple of Cell, optional
        Access points with a channel each, where there are several; each wireless group then names
        its `HostGroup.cell`. A message to another cell goes up in the sender's and down in the
        receiver's, and takes nothing in between; multicast goes down in every cell. For
        `discostorm.cell_utilization`, and `by_cell` for all else.

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
    ros: str | None = None
    within: float | None = None
    domain: int | None = None
    addresses: tuple[tuple[str, str], ...] = ()
    cells: tuple[Cell, ...] = ()

    def __post_init__(self) -> None:
        if self.ros is not None:
            object.__setattr__(self, "ros", distribution_name(self.ros))
        if self.within is not None:
            within = _checks.number("within", self.within, 0, exclusive_min=True)
            object.__setattr__(self, "within", within)
        if self.domain is not None:
            _checks.integer("domain", self.domain, 0, MAX_DOMAIN)
        object.__setattr__(self, "matching", _checks.number("matching", self.matching, 0, 1))
        object.__setattr__(self, "groups", _checks.tuple_of("groups", self.groups, HostGroup))
        _checks.distinct("groups", (group.name for group in self.groups if group.name))
        _checks.broadcast_shape(**self.non_scalars())
        if self.cells != ():
            object.__setattr__(self, "cells", _checks.tuple_of("cells", self.cells, Cell))
        named = zip(self.names, self.groups, strict=True)
        check_cells(self.cells, [(name, group.cell, group.wired) for name, group in named])

    def __repr__(self) -> str:
        matching = f", matching={self.matching:g}" if self.matching else ""
        ros = f", ros={self.ros!r}" * (self.ros is not None)
        within = "" if self.within is None else f", within={self.within:g}"
        cells = f", cells=<{', '.join(cell.name for cell in self.cells)}>" if self.cells else ""
        return _checks.shorten_repr(f"Fleet(groups={self.groups!r}{matching}{ros}{within}{cells})")

    def _repr_html_(self) -> str:
        import pandas as pd  # here, as it would double the time of importing discostorm

        names = (*COUNTS, "shared", "wired")
        rows = [[getattr(group, name) for name in names] for group in self.groups]
        return pd.DataFrame(rows, self.names, names).round(2).to_html(float_format="{:g}".format)

    @classmethod
    def swarm(cls, hosts: Count, processes: Count, endpoints: Count) -> "Fleet":
        """Return the paper's homogeneous swarm: one group."""
        return cls((HostGroup(hosts, processes, endpoints),))

    @classmethod
    def symbolic(cls, groups: int, matching: float = 0.0) -> "Fleet":
        """Return a fleet of symbolic groups; one group has the paper's N_H, N_P and N_E."""
        _checks.integer("groups", groups, 1, _MAX_SYMBOLIC_GROUPS)
        if groups == 1:
            return cls(PAPER_SWARM.groups, matching)
        return cls(tuple(symbolic_group(index) for index in range(1, int(groups) + 1)), matching)

    @classmethod
    def from_toml(cls, path: str | PathLike[str]) -> "Fleet":
        """Return the fleet that a TOML file describes, with its groups in their order.

        The file has a table ``[[groups]]`` for each group of hosts, with one number each for
        ``hosts``, ``processes`` (of each host) and ``endpoints`` (of each process), and optionally
        ``name``, ``nodes``, ``shared``, ``own_types`` and ``wired``; see `HostGroup`. A group
        without ``shared`` shares what ROS 2 makes for its processes and nodes
        (`discostorm.robots.shared_endpoints`), for the likely number of nodes if it has no
        ``nodes`` either (`discostorm.robots.likely_nodes`); programs without ROS 2 say ``shared =
        0``. In place of ``processes`` and ``endpoints`` a group may name a ready-made ``robot``, or
        have a table ``[[groups.processes]]`` with ``count`` and ``endpoints`` for each size of its
        processes. Above the groups it may have ``matching``, ``ros``, ``within`` and ``domain``,
        and below them a table ``[addresses]``; see `Fleet`. Where there are several access points,
        it has a table ``[[cells]]`` with ``name``, ``wifi`` and optionally ``channel`` for each,
        and each wireless group has a ``cell``; see `Cell`. User data have a table for each topic,
        below its group: one of `discostorm.flows.topics`, or `discostorm.flows.Flow` with ``rate``
        in Hz, ``bytes`` and ``reliable``.

        An OSError says if the file cannot be read, a ValueError what is wrong in it.
        """
        name = _checks.path("path", path, "a TOML file")
        with open_input(name) as file:
            return cls.from_bytes(file.read(MAX_BYTES + 1), name)

    @classmethod
    def from_bytes(cls, content: bytes | bytearray | memoryview, name: str) -> "Fleet":
        """Return the fleet that the content of a named TOML file describes; see `from_toml`."""
        tables = fleet_tables(content, name)
        groups = []
        try:
            check_tables(tables)
            for number, table in enumerate(tables["groups"], start=1):
                with error_context(number, table):
                    groups.append(_group_from_table(table))
            above = {k: tables[k] for k in ("matching", "ros", "within", "domain") if k in tables}
            addresses = tuple(tables.get("addresses", {}).items())
            cells = tuple(Cell(**table) for table in tables.get("cells", ()))
            return cls(tuple(groups), addresses=addresses, cells=cells, **above)
        except (TypeError, ValueError) as error:
            raise ValueError(f"{name}: {error}") from error

    def counts(self) -> tuple[Count, ...]:
        """Return hosts, processes and endpoints, group by group."""
        return tuple(count for group in self.groups for count in group.counts())

    def hosts(self) -> Count:
        """Return the number of hosts in the fleet."""
        return reduce(add, (group.hosts for group in self.groups))

    def processes(self) -> Count:
        """Return the number of processes in the fleet."""
        return reduce(add, self.processes_per_group)

    @cached_property
    def processes_per_group(self) -> list[Count]:
        """The number of processes of each group."""
        return [group.hosts * group.processes for group in self.groups]

    @cached_property
    def remote_processes(self) -> list[Count]:
        """The number of processes on other hosts, for a process of each group."""
        return self._count_remote([True] * len(self.groups))

    @cached_property
    def wireless_remote_processes(self) -> list[Count]:
        """The number of processes on other, wireless hosts, for a process of each group."""
        return self._count_remote([not group.wired for group in self.groups])

    def _count_remote(self, counted: list[bool]) -> list[Count]:
        """Count remote processes in ``counted`` groups, as seen from a process of each group."""
        # Add the other groups; to subtract a group from the total would lose digits.
        of = [n if yes else 0 for n, yes in zip(self.processes_per_group, counted, strict=True)]
        before = list(accumulate(of[:-1], initial=0))
        after = list(accumulate(of[:0:-1], initial=0))[::-1]
        return [
            ((group.hosts - 1) * group.processes if yes else 0) + earlier + later
            for group, yes, earlier, later in zip(self.groups, counted, before, after, strict=True)
        ]

    @cached_property
    def matched_per_process(self) -> list[Count]:
        """The endpoints of a process that match one in every other process, for each group."""
        share = int_if_integral(self.matching)
        counts = ((group.endpoints, int_if_integral(group.shared)) for group in self.groups)
        return [own + (endpoints - own) * share for endpoints, own in counts]

    @cached_property
    def matched_in_all(self) -> Count:
        """The endpoints in the fleet that match one in every other process."""
        pairs = zip(self.processes_per_group, self.matched_per_process, strict=True)
        return reduce(add, (processes * matched for processes, matched in pairs))

    @cached_property
    def unknown_types_per_process(self) -> list[Count]:
        """The number of types of other processes that a process of each group lacks."""
        of_host = [group.processes * group.own_types for group in self.groups]
        return [sum(of_host) - group.own_types for group in self.groups]

    @property
    def has_data(self) -> bool:
        """Whether a group of the fleet sends data besides discovery."""
        return any(group.data for group in self.groups)

    def without_data(self) -> "Fleet":
        """Return the fleet with discovery alone."""
        groups = tuple(replace(group, data=()) for group in self.groups)
        return replace(self, groups=groups)

    @cached_property
    def has_wired(self) -> bool:
        """Whether a group of the fleet is wired to the access point."""
        return any(group.wired for group in self.groups)

    def with_hosts(self, index: int, hosts: Count) -> "Fleet":
        """Return the fleet with another number of hosts in the group at an index."""
        groups = (replace(g, hosts=hosts) if n == index else g for n, g in enumerate(self.groups))
        return replace(self, groups=tuple(groups))

    def by_cell(self) -> dict[Cell, "Fleet"]:
        """Return a fleet per cell, in which hosts of other cells are wired to its access point."""
        seen = {
            cell: tuple(replace(g, cell="", wired=g.cell != cell.name) for g in self.groups)
            for cell in self.cells
        }
        return {cell: replace(self, groups=groups, cells=()) for cell, groups in seen.items()}

    def reject_cells(self) -> None:
        """Raise a ValueError if the fleet has cells, for callers with one channel."""
        if self.cells:
            names = " and ".join(cell.name for cell in self.cells)
            raise ValueError(
                f"fleet must have no cells here, as only one channel is counted; got {names}. "
                "cell_utilization counts each cell; Fleet.by_cell makes each a fleet"
            )

    def matches(self) -> float:
        """Return 1 if any endpoints match, else 0."""
        return float(self.matching > 0 or any(group.shared != 0 for group in self.groups))

    @property
    def names(self) -> tuple[str, ...]:
        """The names of the groups; "group 1" and so on for unnamed ones."""
        given = {group.name for group in self.groups}
        numbers = (f"group {number}" for number in range(1, len(self.groups) + 1))
        return tuple(
            group.name or (f"{number} (unnamed)" if number in given else number)
            for group, number in zip(self.groups, numbers, strict=True)
        )

    def to_dicts(self) -> list[dict[str, Any]]:
        """Return the groups of a fleet of plain numbers, for JSON; keys as in `from_toml`."""
        return [
            {"name": name}
            | {count: float(getattr(group, count)) for count in (*COUNTS, "shared")}
            | ({"process_sizes": sizes} if (sizes := [*map(asdict, group.process_sizes)]) else {})
            | {k: own for k in ("own_types", "wired", "cell") if (own := getattr(group, k))}
            | ({"data": [asdict(flow) for flow in group.data]} if group.data else {})
            for name, group in zip(self.names, self.groups, strict=True)
        ]

    def non_scalars(self) -> dict[str, Count]:
        """Return the counts that are arrays or symbols, by their names."""
        return {
            f"groups[{index}].{name}": count
            for index, group in enumerate(self.groups)
            for name, count in zip(COUNTS, group.counts(), strict=True)
            if not isinstance(count, float)
        }


def symbolic_group(index: int) -> HostGroup:
    """Return a group in symbols: N_H1, N_P1 and N_E1 for index 1, and so on."""
    return HostGroup(*sp.symbols(f"N_H{index} N_P{index} N_E{index}", nonnegative=True))


def _group_from_table(table: dict[str, Any]) -> HostGroup:
    """Return the group that a table ``[[groups]]`` of a fleet file describes."""
    data = []
    for number, topic in enumerate(table.get("data", ()), start=1):
        with error_context(number, topic, "data"):
            data.append(flow_from_table(topic))
    given = table | {"name": "", "data": tuple(data)}
    name = table.get("name", "")
    if "robot" in given:
        group = robot(given.pop("robot"))
        return replace(group, **given | {"name": name or group.name})
    if isinstance(given["processes"], list):
        given["processes"] = tuple(Process(**size) for size in given["processes"])
    group = HostGroup(**given)
    if "shared" not in table:
        fewest = min((size.endpoints for size in group.process_sizes), default=group.endpoints)
        shared = min(likely_shared(group.endpoints, group.nodes), fewest)
        group = replace(group, shared=shared)
    return replace(group, name=name)


def as_fleet(
    hosts: ArrayLike | Fleet, processes: ArrayLike | None, endpoints: ArrayLike | None
) -> Fleet:
    """Return the fleet that the arguments of `utilization` and `breakdown` describe."""
    for name, value in {"processes": processes, "endpoints": endpoints}.items():
        if isinstance(hosts, Fleet) and value is not None:
            got = _checks.short_repr(value)
            raise TypeError(f"{name} must be left out when hosts is a Fleet; got {got}")
        if not isinstance(hosts, Fleet) and value is None:
            raise TypeError(f"{name} must be given unless hosts is a Fleet; got None")
    fleet = hosts if isinstance(hosts, Fleet) else Fleet.swarm(hosts, processes, endpoints)
    reject_symbols_and_cells(fleet)
    return fleet


def reject_symbols_and_cells(fleet: Fleet) -> None:
    """Raise a TypeError if the fleet is in symbols, a ValueError if it has cells."""
    fleet.reject_cells()
    for group in fleet.groups:
        for name, count in zip(COUNTS, group.counts(), strict=True):
            if is_symbolic(count):
                rule = f"a number here, not an expression; got {count}"
                raise TypeError(f"{name} must be {rule}. Or use Protocol.utilization")


#: The paper's swarm in symbols: every host runs N_P processes of N_E endpoints.
PAPER_SWARM = Fleet.swarm(nt.N_H, nt.N_P, nt.N_E)
