"""How far measured tables were off where they were not fitted."""

from __future__ import annotations

from dataclasses import asdict, dataclass, replace
from functools import cache
from typing import TYPE_CHECKING, Literal

import numpy as np

from discostorm.data import read_data
from discostorm.fleet import Fleet

if TYPE_CHECKING:
    pass


@cache
def products() -> dict[str, dict[str, str]]:
    """Return the rows of ``data/vendors/products.csv`` by the name of the table."""
    return {row["protocol"]: row for row in read_data("vendors/products.csv")}


@cache
def configurations() -> dict[str, dict[str, str]]:
    """Return the rows of ``data/vendors/configurations.csv`` by the name of the table."""
    return {row["protocol"]: row for row in read_data("vendors/configurations.csv")}


#: How many times the measured range a fleet is at most [1]: within it, up to twice, and beyond. No
#: number of hosts is told from the second on: not measured.
CLASSES = (1.0, 2.0, np.inf)


#: How far beyond the range of its table a point lay: columns of ``data/measured/bands.csv``.
_MOST = ("most_hosts", "most_endpoints")


def size_of(fleet: Fleet, captured: tuple[int, ...]) -> tuple[float, float]:
    """Return how many times the most hosts or processes, and the most endpoints, it has [1].

    Captured were at most so many hosts, processes of all and endpoints of a process.
    """
    hosts = sum(group.hosts for group in fleet.groups)
    endpoints = max(group.endpoints for group in fleet.groups)
    of_hosts, of_all, of_process = captured
    many = max(float(hosts) / of_hosts, float(fleet.processes()) / of_all)
    return many, float(endpoints) / max(of_process, 1)


def most_hosts(captured: tuple[int, ...], processes: float) -> int:
    """Return up to how many hosts of so many processes a number is told: twice what was captured.

    Of more it is said that they are more, as nothing was measured there.
    """
    of_hosts, of_all, _ = captured
    return max(1, int(CLASSES[1] * min(of_hosts, of_all / processes)))


#: What is said of a band of a fleet that is larger than any that was measured.
BEYOND = "; we did not measure the error for a fleet of this size"


@dataclass(frozen=True)
class Band:
    """What captures took that a measured table was not fitted to, beside what the table says.

    Parameters
    ----------
    low, high : float
        The least and the most of the held-out points, each the median of its runs [1]: measured
        airtime as a part of the table's.
    typical : float
        The median of how far they were off [1].
    points : int
        How many there were [1].
    up_to : float
        Up to how many times the measured range they lay [1]: 1 is within it.
    most_hosts, most_endpoints : float
        The most of that range that any point had, in hosts or processes and in endpoints [1].
    beyond : bool
        Whether the fleet it was asked for has more than that: its error was not measured.
    """

    low: float
    high: float
    typical: float
    points: int
    up_to: float
    most_hosts: float
    most_endpoints: float
    beyond: bool

    def to_dict(self) -> dict[str, float | int | bool | None]:
        """Return it as what JSON can hold: infinity is None."""
        return asdict(self) | {"up_to": self.up_to if np.isfinite(self.up_to) else None}

    def sentence(self) -> str:
        """Return it in words, behind a sentence that says what was captured."""
        where = {1.0: "within that range", 2.0: "of up to twice that range"}.get(
            self.up_to, f"with up to {self.most_endpoints:.0f} times the endpoints"
        )
        beyond = BEYOND * self.beyond
        return (
            f"In {self.points} swarms {where} that we did not fit, discovery took "
            f"{self.low:.2f} to {self.high:.2f} times the airtime of the model (typical error "
            f"{self.typical:.0%}){beyond}."
        )


def band(
    protocol: str,
    fleet: Fleet,
    captured: tuple[int, ...],
    window: Literal["startup", "steady"] = "startup",
) -> Band | None:
    """Return how far a measured table was off where it was not fitted.

    Parameters
    ----------
    protocol : str
        The name of a table.
    fleet : Fleet
        Whose answer it is to go with.
    captured : tuple of int
        `Protocol.captured`: the most hosts, processes and endpoints that were captured.
    window : {"startup", "steady"}, optional
        The first 12 s, or the 24 s after them.

    Returns
    -------
    Band or None
        Of the held-out points of fleets as large as this one, or of the largest there were; None
        if nothing was held out.
    """
    rows = bands_of(protocol, window)
    if not rows:
        return None
    many, endpoints = size_of(fleet, captured)
    # Beyond twice the range none had more hosts: those of twice the range are the nearest.
    needed = max(min(many, CLASSES[1]), endpoints)
    found = next((row for row in rows if row.up_to >= needed), rows[-1])
    return replace(found, beyond=many > found.most_hosts or endpoints > found.most_endpoints)


@cache
def bands_of(protocol: str, window: Literal["startup", "steady"] = "startup") -> tuple[Band, ...]:
    """Return the bands of a table, one for each class of sizes measured, the smallest first."""
    rows = [
        row
        for row in read_data("measured/bands.csv")
        if (row["protocol"], row["window"]) == (protocol, window)
    ]
    most = [max(1.0, *(float(row[name]) for row in rows)) for name in _MOST if rows]
    return tuple(
        Band(
            low=float(row["low"]),
            high=float(row["high"]),
            typical=float(row["typical"]),
            points=int(row["points"]),
            up_to=float(row["up_to"]),
            most_hosts=most[0],
            most_endpoints=most[1],
            beyond=False,
        )
        for row in rows
    )
