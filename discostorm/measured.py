"""What the lab counted of real middleware, and how long it took to notice deaths."""

from __future__ import annotations

from collections import defaultdict
from dataclasses import asdict, dataclass, replace
from functools import cache
from typing import TYPE_CHECKING, Literal

import numpy as np
from numpy.typing import NDArray

from discostorm import _checks
from discostorm.data import read_data
from discostorm.fleet import Fleet, HostGroup

if TYPE_CHECKING:
    import pandas as pd

#: The windows that were counted, from when to when after the start [s].
WINDOWS = {"startup": (0.0, 12.0), "steady": (12.0, 36.0)}

#: Endpoints of a process that are on the one topic of all, where the others are not [1].
SHARED = 2

#: Messages, frames and bytes where none was seen.
NONE = (0.0, 0.0, 0.0)

#: Window, kind, what it is about ("" for all), cast, and its only hop ("" if it takes both).
Key = tuple[str, str, str, str, str]


@dataclass(frozen=True)
class Point:
    """A point of the grid, as all runs of one product and variant saw it.

    Parameters
    ----------
    name : str
        Hosts, processes and endpoints, and whether names match (m), are unique (u), or one topic
        is shared beside unique ones (s).
    use : str
        The half of the grid: "fit" or "test".
    fleet : Fleet
        Its hosts.
    runs : dict
        By window, kind, what it is about, cast and hop: messages [1], frames [1] and bytes of
        payload [B], a row a run.
    ready : numpy.ndarray
        When the last process of each run had made its endpoints [s].
    """

    name: str
    use: str
    fleet: Fleet
    runs: dict[Key, NDArray[np.float64]]
    ready: NDArray[np.float64]

    def median(self, key: Key) -> NDArray[np.float64]:
        """Return the medians of messages, frames and bytes; zeros if none was seen."""
        return np.median(self.runs[key], axis=0) if key in self.runs else np.zeros(3)


@cache
def products() -> dict[str, dict[str, str]]:
    """Return the rows of ``data/vendors/products.csv`` by the name of the table."""
    return {row["protocol"]: row for row in read_data("vendors/products.csv")}


@cache
def arrangements() -> dict[str, dict[str, str]]:
    """Return the rows of ``data/vendors/arrangements.csv`` by the name of the table."""
    return {row["protocol"]: row for row in read_data("vendors/arrangements.csv")}


@cache
def _counts(kind: str) -> dict[str, dict[Key, tuple[float, ...]]]:
    counts: dict[str, dict[Key, tuple[float, ...]]] = defaultdict(dict)
    for row in read_data(f"measured/{kind}counts.csv", "discostorm_book"):
        messages, frames, octets = map(float, (row["messages"], row["frames"], row["bytes"]))
        cast = "multicast" if row["multicast"] == "1" else "unicast"
        of_run = counts[row["run"]]
        for about in {row["about"], ""}:
            key = (row["window"], row["kind"], about, cast, row.get("hops", ""))
            known = of_run.get(key, NONE)
            of_run[key] = (known[0] + messages, known[1] + frames, known[2] + octets)
    return counts


@cache
def points(name: str, shared: bool = False) -> tuple[Point, ...]:
    """Return the points of the grid that a table is held against, with at least two hosts.

    Parameters
    ----------
    name : str
        Of a table of ``data/vendors/products.csv`` or ``arrangements.csv``.
    shared : bool, optional
        Instead of these, the points of ``lab/shared.csv``, where the first writer and the first
        reader of each process are on one topic of all, and the others on topics of their own.

    Returns
    -------
    tuple of Point
        In the order of the grid. For a table of a network that is taken for wired, those with
        three processes or more, as two send otherwise.

    Raises
    ------
    ValueError
        If there is no such table.
    """
    known = products() | arrangements()
    _checks.choice("name", name, list(known))
    row, kind = known[name], "mitigation_" if name in arrangements() else ""
    kind = "shared_" if shared else kind
    return points_of(row["product"], row["variant"], int(row["least_processes"]), kind)


def points_of(
    product: str, variant: str, least: int = 2, kind: str = "mitigation_"
) -> tuple[Point, ...]:
    """Return the points of a product and variant that have at least so many processes [1].

    With the kind left out: of an arrangement of ``lab/mitigations.csv``, with a table or without.
    """
    of_point: dict[tuple[str, ...], dict[str, float]] = defaultdict(dict)
    for run in read_data(f"measured/{kind}runs.csv", "discostorm_book"):
        if (run["product"], run["variant"]) == (product, variant):
            columns = ("hosts", "processes", "endpoints", "names", "use")
            of_point[tuple(run[column] for column in columns)][run["run"]] = float(run["made_s"])
    found = []
    counts = _counts(kind)
    for (hosts, processes, endpoints, names, use), runs in of_point.items():
        if int(hosts) < 2 or int(hosts) * int(processes) < least:
            continue
        same = SHARED if names == "shared" else 0
        host = HostGroup(int(hosts), int(processes), int(endpoints), shared=same)
        found.append(
            Point(
                f"{hosts}x{processes}x{endpoints}{names[0]}",
                use,
                Fleet((host,), matching=float(names == "matching")),
                {
                    key: np.array([counts[run].get(key, NONE) for run in runs])
                    for key in sorted({key for run in runs for key in counts[run]})
                },
                np.array(list(runs.values())),
            )
        )
    return tuple(found)


def beyond(name: str) -> tuple[Point, ...]:
    """Return the points of ``lab/beyond.csv``, larger than the grid's, of a product's table."""
    row = products().get(name)
    if row is None:
        return ()
    return points_of(row["product"], row["variant"], int(row["least_processes"]), "beyond_")


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


def payloads(name: str, kind: str) -> list[float]:
    """Return the mean payload of a kind of message in the start-up window of each point [B]."""
    found = []
    for point in points(name):
        keys = (("startup", kind, "", cast, "") for cast in ("multicast", "unicast"))
        messages, _, octets = np.sum([point.median(key) for key in keys], axis=0)
        if messages:
            found.append(float(octets / messages))
    return found


#: What tells the rows of ``data/measured/deaths.csv`` and ``outages.csv`` apart, but for the runs.
_OF_DEATHS = ("arrangement", "event", "phase", "who", "quantity")


@cache
def _seconds(table: str = "deaths") -> dict[tuple[str, ...], list[dict[str, str]]]:
    found: dict[tuple[str, ...], list[dict[str, str]]] = defaultdict(list)
    for row in read_data(f"measured/{table}.csv", "discostorm_book"):
        found[tuple(row[name] for name in _OF_DEATHS)].append(row)
    return dict(found)


def death_times(
    arrangement: str, event: str, phase: str, who: str, quantity: str
) -> NDArray[np.float64]:
    """Return how long something took in each run after a server, router or robot had died [s].

    Parameters
    ----------
    arrangement : str
        Of ``data/measured/arrangements.csv``, such as "Zenoh router"; of an outage, "Fast DDS
        Discovery Server" or "Fast DDS Discovery Server, backup".
    event, phase, who, quantity : str
        What died, when it was looked at, whom it is about and what was measured, as
        ``data/measured/README.md`` has them.

    Returns
    -------
    numpy.ndarray
        A time a run [s]; infinite if it did not happen while it was watched.

    Raises
    ------
    ValueError
        If that was not measured.
    """
    key = (arrangement, event, phase, who, quantity)
    every = _seconds() | _seconds("outages")
    if key not in every:
        for position, name in enumerate(_OF_DEATHS):
            known = {other[position] for other in every if other[:position] == key[:position]}
            _checks.choice(name, key[position], sorted(known))
    return np.array([float(row["seconds"]) for row in every[key]])


def deaths(table: Literal["deaths", "outages"] = "deaths") -> pd.DataFrame:
    """Return what the lab saw when servers, routers and robots died, all runs taken together.

    Parameters
    ----------
    table : {"deaths", "outages"}, optional
        The file of ``data/measured``: of outages, a Discovery Server was away for a while in which
        a process began.

    Returns
    -------
    pandas.DataFrame
        A row for each ``arrangement``, ``event``, ``phase``, ``who`` and ``quantity``: how long
        after the death the phase begins, ``since_s``, and how long it was watched, ``watched_s``
        [s]; the number of ``runs`` and of those in which it ``happened`` [1]; ``median_s``,
        ``least_s`` and ``most_s`` of all runs [s], infinite where it did not happen.

    Notes
    -----
    What each quantity is, says ``data/measured/README.md``.
    """
    import pandas as pd

    _checks.choice("table", table, ["deaths", "outages"])
    rows = []
    for key, runs in _seconds(table).items():
        seconds = np.array([float(row["seconds"]) for row in runs])
        rows.append(
            dict(zip(_OF_DEATHS, key, strict=True))
            | {
                "since_s": float(runs[0]["since_s"]),
                "watched_s": float(runs[0]["watched_s"]),
                "runs": len(runs),
                "happened": int(np.isfinite(seconds).sum()),
                "median_s": float(np.median(seconds)),
                "least_s": float(seconds.min()),
                "most_s": float(seconds.max()),
            }
        )
    return pd.DataFrame(rows)
