"""Who is on the channel: groups of like hosts, and what a fleet of them counts."""

from collections.abc import Iterable
from dataclasses import dataclass, fields
from functools import reduce
from operator import add
from typing import Any

import sympy as sp

from discostorm import _checks, notation as nt

#: A number, an array or a sympy expression: a fleet counts any of them alike.
Count = Any


@dataclass(frozen=True)
class HostGroup:
    """Hosts that run the same software.

    Parameters
    ----------
    hosts : float, array or sympy.Expr
        Number of hosts in the group, from 1 to 1e9.
    processes : float, array or sympy.Expr
        Processes on each host, from 1 to 1e9.
    endpoints : float, array or sympy.Expr
        Endpoints of each process, from 0 to 1e9.
    """

    hosts: Count
    processes: Count
    endpoints: Count

    def __post_init__(self) -> None:
        for field in fields(self):
            value = getattr(self, field.name)
            if not isinstance(value, sp.Expr):
                low = 0 if field.name == "endpoints" else 1
                value = _checks.numbers(field.name, value, low, _checks.MOST)
                object.__setattr__(self, field.name, value)


@dataclass(frozen=True)
class Fleet:
    """All hosts that share the channel.

    Parameters
    ----------
    groups : tuple of HostGroup
        At least one.
    """

    groups: tuple[HostGroup, ...]

    def __post_init__(self) -> None:
        if not self.groups:
            raise ValueError("groups must hold at least one HostGroup; got none")

    @classmethod
    def swarm(cls, hosts: Count, processes: Count, endpoints: Count) -> "Fleet":
        """Return the paper's homogeneous swarm: one group of like hosts."""
        return cls((HostGroup(hosts, processes, endpoints),))

    @classmethod
    def symbolic(cls, groups: int) -> "Fleet":
        """Return a fleet of that many groups in symbols; of one: the paper's N_H, N_P, N_E."""
        if groups == 1:
            return SWARM
        return cls(
            tuple(
                HostGroup(*sp.symbols(f"N_H{i} N_P{i} N_E{i}", nonnegative=True))
                for i in range(1, groups + 1)
            )
        )

    def counts(self) -> tuple[Count, ...]:
        """Return hosts, processes and endpoints of one group after the other."""
        return tuple(getattr(group, field.name) for group in self.groups for field in fields(group))

    def processes(self) -> Count:
        """Return the number of processes in the fleet."""
        return _total(group.hosts * group.processes for group in self.groups)

    def pairs(self) -> Count:
        """Return the number of ordered pairs of processes on different hosts."""
        return _total(self._pairs_from(group) for group in self.groups)

    def endpoint_pairs(self) -> Count:
        """Return the number of pairs of an endpoint and a process on another host."""
        return _total(self._pairs_from(group) * group.endpoints for group in self.groups)

    def _pairs_from(self, group: HostGroup) -> Count:
        remote = self.processes() - group.processes
        return group.hosts * group.processes * remote


def _total(counts: Iterable[Count]) -> Count:
    return reduce(add, counts)


#: The paper's swarm in symbols: every host runs N_P processes of N_E endpoints.
SWARM = Fleet.swarm(nt.N_H, nt.N_P, nt.N_E)
