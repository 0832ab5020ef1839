"""Prediction errors of measured tables, in runs that they were not fitted to."""

from dataclasses import asdict, dataclass, replace
from functools import cache
from typing import Any, Literal

import numpy as np

from discostorm.data import read_data
from discostorm.files import json_ready
from discostorm.fleet import Fleet

#: The first 12 s of a capture, or the 24 s after them.
Window = Literal["startup", "steady"]

#: Classes of fleets by their size as a multiple of the measured range [1]: within it, up to twice,
#: and beyond. Beyond the first class, answers do not give a number of hosts.
SIZE_CLASSES = (1.0, 2.0, np.inf)

#: End of the sentence about an error, for a fleet that is larger than any measured one.
BEYOND_CLAUSE = "; this fleet is larger, so expect errors of up to a factor of 2"

#: Fewest swarms whose minimum and maximum make an interval.
MIN_POINTS = 6


def relative_fleet_size(fleet: Fleet, captured: tuple[int, ...]) -> tuple[float, float]:
    """Return hosts (or processes) and endpoints of a fleet relative to the captured maximum [1].

    ``captured`` is that of a `Protocol`: maxima of hosts, processes and endpoints of a process.
    """
    max_hosts, max_processes, max_endpoints = captured
    endpoints = max(group.endpoints for group in fleet.groups)
    hosts = max(float(fleet.hosts()) / max_hosts, float(fleet.processes()) / max_processes)
    return hosts, float(endpoints) / max(max_endpoints, 1)


def max_covered_hosts(captured: tuple[int, ...], processes: float) -> int:
    """Return the largest number of hosts in an answer: twice the number of captured hosts."""
    max_hosts, max_processes, _ = captured
    return max(1, int(SIZE_CLASSES[1] * min(max_hosts, max_processes / processes)))


def points_outside_interval(points: int) -> int:
    """Return how many of the swarms lie beyond each end of an interval that holds 90% of them."""
    return max(0, (points + 1) // 20 - 1)


@dataclass(frozen=True)
class ErrorBand:
    """The error of a measured table in held-out runs: measured airtime over computed airtime."""

    low: float  #: ends of the interval over the held-out points, each the median of its runs [1]
    high: float
    typical: float  #: median error of the points [1]
    points: int  #: number of points [1]
    up_to: float  #: size of their fleets as a multiple of the measured range [1]: 1 is within it
    most_hosts: float  #: largest such multiple of any point, in hosts or processes [1]
    most_endpoints: float  #: the same in endpoints [1]
    beyond: bool = False  #: whether the fleet in question is larger, so that its error is unknown

    @property
    def coverage(self) -> float | None:
        """Probability that one more such swarm is in the range [1]; None below `MIN_POINTS`.

        Each of n + 1 swarms is equally likely to have the minimum or the maximum.
        """
        inside = self.points - 2 * points_outside_interval(self.points)
        return None if self.points < MIN_POINTS else (inside - 1) / (self.points + 1)

    def to_dict(self) -> Any:
        """Return the fields and the coverage for JSON, with None for infinity."""
        return json_ready(asdict(self) | {"coverage": self.coverage})

    def sentence(self) -> str:
        """Return the error as a sentence, to follow one about the captures."""
        where = {1.0: "within these limits", 2.0: "within twice these limits"}.get(
            self.up_to, f"with up to {self.most_endpoints:.0f} times as many endpoints"
        )
        inside = f"We expect {self.coverage or 0:.0%} of such swarms to be in this range"
        more = inside if self.coverage else "That is too few swarms for a confidence interval"
        kept = self.points - 2 * points_outside_interval(self.points)
        part_of = "" if kept == self.points else f"{kept} of "
        return (
            f"In {part_of}{self.points} swarms that were not used for the fit ({where}), discovery "
            f"took {self.low:.2f} to {self.high:.2f} times the predicted airtime (typical error "
            f"{self.typical:.0%}). {more}{BEYOND_CLAUSE * self.beyond}."
        )


def error_band(
    protocol: str, fleet: Fleet, captured: tuple[int, ...], window: Window = "startup"
) -> ErrorBand | None:
    """Return the error of a measured table for held-out fleets of this size.

    A fleet beyond all of them gets the error of the largest; without any, the result is None.
    """
    bands = error_bands(protocol, window)
    if not bands:
        return None
    hosts, endpoints = relative_fleet_size(fleet, captured)
    # We measured up to twice the hosts, so these points are the nearest to larger fleets.
    needed = max(min(hosts, SIZE_CLASSES[1]), endpoints)
    nearest = next((each for each in bands if each.up_to >= needed), bands[-1])
    beyond = hosts > nearest.most_hosts or endpoints > nearest.most_endpoints
    return replace(nearest, beyond=beyond)


@cache
def error_bands(protocol: str, window: Window = "startup") -> tuple[ErrorBand, ...]:
    """Return the error bands of a table, one for each class of sizes, the smallest first."""
    stored = read_data("measured/bands.csv")
    rows = [row for row in stored if (row["protocol"], row["window"]) == (protocol, window)]
    largest = ("most_hosts", "most_endpoints")
    hosts, endpoints = (max([1.0, *(float(row[name]) for row in rows)]) for name in largest)
    bands = []
    for row in rows:
        low, high, typical, up_to = (float(row[n]) for n in ("low", "high", "typical", "up_to"))
        bands.append(ErrorBand(low, high, typical, int(row["points"]), up_to, hosts, endpoints))
    return tuple(bands)
