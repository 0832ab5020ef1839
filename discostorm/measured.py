"""How far measured tables were off in runs that they were not fitted to."""

from dataclasses import asdict, dataclass, replace
from functools import cache
from typing import Any, Literal

import numpy as np

from discostorm.data import read_data
from discostorm.files import json_ready
from discostorm.fleet import Fleet
from discostorm.protocols.as_built import configurations as configurations, products as products

#: The first 12 s of a capture, or the 24 s after them.
Window = Literal["startup", "steady"]

#: Classes of fleets by their size as a multiple of the measured range [1]: within it, up to twice,
#: and beyond. From the second on, answers do not give a number of hosts.
CLASSES = (1.0, 2.0, np.inf)

#: How a sentence about a band ends for a fleet that is larger than any that was measured.
BEYOND = "; we did not measure the error for a fleet of this size"


def size_of(fleet: Fleet, captured: tuple[int, ...]) -> tuple[float, float]:
    """Return a fleet's hosts or processes, and endpoints, as multiples of those captured [1].

    ``captured`` is that of a `Protocol`: maxima of hosts, processes and endpoints of a process.
    """
    max_hosts, max_processes, max_endpoints = captured
    endpoints = max(group.endpoints for group in fleet.groups)
    hosts = max(float(fleet.hosts()) / max_hosts, float(fleet.processes()) / max_processes)
    return hosts, float(endpoints) / max(max_endpoints, 1)


def most_hosts(captured: tuple[int, ...], processes: float) -> int:
    """Return the maximum number of hosts that an answer gives: twice as many as were captured."""
    max_hosts, max_processes, _ = captured
    return max(1, int(CLASSES[1] * min(max_hosts, max_processes / processes)))


@dataclass(frozen=True)
class ErrorBand:
    """How far a measured table was off in held-out runs: measured airtime by the table's."""

    low: float  #: minimum and maximum over the held-out points, each the median of its runs [1]
    high: float
    typical: float  #: median error of the points [1]
    points: int  #: number of points [1]
    up_to: float  #: size of their fleets as a multiple of the measured range [1]: 1 is within it
    most_hosts: float  #: largest such multiple of any point, in hosts or processes [1]
    most_endpoints: float  #: the same in endpoints [1]
    beyond: bool = False  #: whether the fleet in question is larger, so that its error is unknown

    def to_dict(self) -> Any:
        """Return it as what JSON can hold: infinity is None."""
        return json_ready(asdict(self))

    def sentence(self) -> str:
        """Return it in words, to follow a sentence that says what was captured."""
        where = {1.0: "within that range", 2.0: "of up to twice that range"}.get(
            self.up_to, f"with up to {self.most_endpoints:.0f} times the endpoints"
        )
        return (
            f"In {self.points} swarms {where} that we did not fit, discovery took "
            f"{self.low:.2f} to {self.high:.2f} times the airtime of the model (typical error "
            f"{self.typical:.0%}){BEYOND * self.beyond}."
        )


def band(
    protocol: str, fleet: Fleet, captured: tuple[int, ...], window: Window = "startup"
) -> ErrorBand | None:
    """Return how far the table of that name was off for held-out fleets of this size.

    For the largest there were if this fleet is larger; None if nothing was held out.
    """
    bands = error_bands(protocol, window)
    if not bands:
        return None
    hosts, endpoints = size_of(fleet, captured)
    # No point had more than twice the hosts: beyond that, those with twice are the nearest.
    needed = max(min(hosts, CLASSES[1]), endpoints)
    nearest = next((each for each in bands if each.up_to >= needed), bands[-1])
    beyond = hosts > nearest.most_hosts or endpoints > nearest.most_endpoints
    return replace(nearest, beyond=beyond)


@cache
def error_bands(protocol: str, window: Window = "startup") -> tuple[ErrorBand, ...]:
    """Return the bands of a table, one for each class of sizes measured, the smallest first."""
    rows = [
        row
        for row in read_data("measured/bands.csv")
        if (row["protocol"], row["window"]) == (protocol, window)
    ]
    hosts, endpoints = (
        max([1.0, *(float(row[name]) for row in rows)]) for name in ("most_hosts", "most_endpoints")
    )
    return tuple(
        ErrorBand(
            float(row["low"]),
            float(row["high"]),
            float(row["typical"]),
            int(row["points"]),
            float(row["up_to"]),
            hosts,
            endpoints,
        )
        for row in rows
    )
