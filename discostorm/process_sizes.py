"""Processes with different numbers of endpoints on a host."""

from collections.abc import Sequence
from dataclasses import dataclass

from discostorm import _checks


@dataclass(frozen=True)
class Process:
    """Processes of a host that have equally many endpoints.

    Parameters
    ----------
    count, endpoints : float
        Number of these processes on each host, and endpoints of each of them [1]; whole numbers
        to 1e9, from 1 and from 0.
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
