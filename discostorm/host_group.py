"""A group of hosts that run the same software: its counts, processes and their endpoints."""

from collections.abc import Sequence
from dataclasses import dataclass, fields, replace
from typing import Any

import numpy as np
import sympy as sp

from discostorm import _checks
from discostorm._numeric import Polynomial
from discostorm.fleet_file import COUNTS, MIN_COUNTS
from discostorm.flows import Flow
from discostorm.ros2_endpoints import parameter_service_endpoints

#: A number, an array, a polynomial or a sympy expression: a fleet counts any of them the same way.
Count = Any


@dataclass(frozen=True)
class Process:
    """Processes of a host that have equally many endpoints.

    Parameters
    ----------
    count, endpoints : float
        Processes on each host, from 1, and endpoints of each, from 0 [1]; whole numbers to 1e9.
    """

    count: float
    endpoints: float

    def __post_init__(self) -> None:
        for name, low in (("count", 1), ("endpoints", 0)):
            _checks.integer(name, getattr(self, name), low, _checks.MAX_COUNT)
            object.__setattr__(self, name, float(getattr(self, name)))


def count_and_mean_endpoints(sizes: Sequence[Process]) -> tuple[float, float]:
    """Return the number of processes, and the mean of their endpoints [1]."""
    number = sum(size.count for size in sizes)
    return number, sum(size.count * size.endpoints for size in sizes) / number


def even_sizes(processes: int, endpoints: int) -> tuple[Process, ...]:
    """Split a number of endpoints over processes as evenly as whole numbers allow."""
    fewest, larger = divmod(endpoints, processes)
    counts = ((larger, fewest + 1), (processes - larger, fewest))
    return tuple(Process(count, each) for count, each in counts if count)


@dataclass(frozen=True, eq=False, repr=False)
class HostGroup:
    """Hosts that run the same software.

    Parameters
    ----------
    hosts, processes, endpoints : float, array or sympy.Expr
        Number of hosts in the group, processes on each host, and endpoints of each process, their
        mean if processes differ [1]; to 1e9, from 1, endpoints from 0. Processes of unlike size
        are a tuple of `Process` in place of ``processes``, without ``endpoints``.
    name : str, optional
        What to call it.
    nodes : float, optional
        Nodes with parameter services in each process [1], for `plan`; None if unknown.
    shared : float or sympy.Expr, optional
        Endpoints of each process that match one in every other process, whatever the names of its
        others are [1]. In ROS 2 those of topics with the same name everywhere:
        `discostorm.robots.shared_endpoints`.
    own_types : float, optional
        Types of each process that only the same process of the group's other hosts knows, those of
        writers and of readers counted apart [1]. Fast DDS asks for them from version 3 on.
    wired : bool, optional
        Whether they are wired to the access point: their uplink takes no air, nor does the
        downlink to them. False if left out.
    data : tuple of Flow, optional
        What each host publishes for others once discovery is complete; nothing if left out.
        `discostorm.utilization` counts it for the phase "data".
    process_sizes : tuple of Process, optional
        Processes of unlike size, set by ``processes``, which then holds their number, and
        ``endpoints`` their mean; empty otherwise, also if a copy has other counts.
    cell : str, optional
        The cell whose access point they use: a name in `Fleet.cells`; empty without, or if wired.
    """

    hosts: Count
    processes: Count
    endpoints: Count = None
    name: str = ""
    nodes: float | None = None
    shared: Count = 0.0
    own_types: Count = 0.0
    wired: bool = False
    data: tuple[Flow, ...] = ()
    process_sizes: tuple[Process, ...] = ()
    cell: str = ""

    def __post_init__(self) -> None:
        for name, kind in (("name", str), ("wired", bool), ("cell", str)):
            _checks.instance(name, getattr(self, name), kind)
        group = f"group {_checks.shorten_name(self.name)!r}" if self.name else ""
        with _checks.prefix_errors(group):
            self._check()

    def _check(self) -> None:
        """Check the numbers, and keep them as floats and read-only arrays."""
        self._set_process_sizes()
        for count, low in MIN_COUNTS.items():
            value = getattr(self, count)
            if is_symbolic(value):
                continue
            value = _checks.numbers(count, value, low, _checks.MAX_COUNT)
            if isinstance(value, np.ndarray):
                value = value.copy()
                value.flags.writeable = False
            object.__setattr__(self, count, value)
        _checks.broadcast_shape(**dict(zip(COUNTS, self.counts(), strict=True)))
        fewest = self.endpoints
        if isinstance(fewest, np.ndarray):
            fewest = float(np.min(fewest, initial=_checks.MAX_COUNT))
        elif is_symbolic(fewest):
            fewest = _checks.MAX_COUNT
        if self.nodes is not None:
            nodes = _checks.number("nodes", self.nodes, 0, _checks.MAX_COUNT)
            if nodes * (each := parameter_service_endpoints()) > fewest:
                raise ValueError(
                    f"nodes must be at most {fewest / each:g}: each needs {each} endpoints for "
                    f"parameter services, and a process has {fewest:g}; got {nodes:g}"
                )
            object.__setattr__(self, "nodes", nodes)
        fewest = min((size.endpoints for size in self.process_sizes), default=fewest)
        for name in ("shared", "own_types"):
            if not is_symbolic(value := getattr(self, name)):
                object.__setattr__(self, name, _checks.number(name, value, 0, fewest))
        if self.data != ():
            object.__setattr__(self, "data", _checks.tuple_of("data", self.data, Flow))
            _checks.distinct("data", (flow.topic for flow in self.data), "topics")
            if not isinstance(self.hosts, float):
                raise ValueError(f"hosts must be one number if data are given; got {self.hosts}")

    def _set_process_sizes(self) -> None:
        """Set the counts from a list of processes; drop the list if other counts replaced it."""
        listed, known = self.processes, self.process_sizes
        if isinstance(listed, (tuple, list)) and any(isinstance(size, Process) for size in listed):
            sizes = _checks.tuple_of("processes", tuple(listed), Process)
            if self.endpoints is not None:
                rule = f"processes lists Process(count, endpoints); got {self.endpoints}"
                raise ValueError(f"endpoints must be left out where {rule}")
            for name, value in zip(COUNTS[1:], count_and_mean_endpoints(sizes), strict=True):
                object.__setattr__(self, name, value)
            object.__setattr__(self, "process_sizes", sizes)
        elif known and not np.array_equal(self.counts()[1:], count_and_mean_endpoints(known)):
            object.__setattr__(self, "process_sizes", ())
        if self.endpoints is None:
            allowed = _checks.describe_range(0, _checks.MAX_COUNT)
            raise TypeError(f"endpoints must be {allowed}, or set by a tuple of Process; got None")

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, HostGroup):
            return NotImplemented
        return self is other or self._key() == other._key()

    def __hash__(self) -> int:
        return hash(self._key())

    def __reduce__(self) -> tuple[type, tuple[Any, ...]]:
        # Use the constructor, so that arrays of copies are read-only as well.
        return HostGroup, tuple(getattr(self, field.name) for field in fields(self))

    def _key(self) -> tuple[Any, ...]:
        return tuple(_hashable_value(getattr(self, field.name)) for field in fields(self))

    def counts(self) -> tuple[Count, ...]:
        """Return hosts, processes and endpoints."""
        return self.hosts, self.processes, self.endpoints

    def with_integer_endpoints(self) -> "HostGroup":
        """Return the group with a mean number of endpoints split evenly over its processes."""
        mean, processes = float(self.endpoints), float(self.processes)
        if self.process_sizes or mean.is_integer() or not processes.is_integer():
            return self
        sizes = even_sizes(int(processes), round(processes * mean))
        shared = min(float(self.shared), *(size.endpoints for size in sizes))
        return replace(self, processes=sizes, endpoints=None, shared=shared, nodes=None)

    def __repr__(self) -> str:
        shown = [f"{name}={_brief(getattr(self, name))}" for name in COUNTS]
        if sizes := [f"Process({p.count:g}, {p.endpoints:g})" for p in self.process_sizes]:
            shown[1:] = [f"processes=({', '.join(sizes)},)"]
        shown += [f"name={self.name!r}"] * bool(self.name)
        shown += [] if self.nodes is None else [f"nodes={self.nodes:g}"]
        shown += [f"shared={_brief(self.shared)}"] * bool(self.shared != 0)
        shown += [f"own_types={self.own_types:g}"] * bool(self.own_types)
        shown += ["wired=True"] * self.wired
        shown += [f"cell={self.cell!r}"] * bool(self.cell)
        shown += [f"data=<{', '.join(flow.topic for flow in self.data)}>"] * bool(self.data)
        return _checks.shorten_repr(f"HostGroup({', '.join(shown)})")


def is_symbolic(value: Any) -> bool:
    """Return whether a count is an expression with an unknown symbol."""
    if isinstance(value, float):
        return False
    is_expression = isinstance(value, sp.Expr) and bool(value.free_symbols)
    return is_expression or isinstance(value, Polynomial)


def _hashable_value(value: Any) -> Any:
    """Return a value that compares and hashes by content, also for an array."""
    # Adding 0.0 makes negative zeros positive.
    return (value.shape, (value + 0.0).tobytes()) if isinstance(value, np.ndarray) else value


def _brief(count: Count) -> str:
    if isinstance(count, np.ndarray):
        return " ".join(np.array2string(count, separator=", ", threshold=6, edgeitems=2).split())
    return str(count).removesuffix(".0")
