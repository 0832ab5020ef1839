"""What the lab counted of real middleware, and how long it took to notice deaths."""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING, Literal

import numpy as np
from numpy.typing import NDArray

from discostorm import _checks
from discostorm.data import read_data
from discostorm.fleet import Fleet, HostGroup
from discostorm.measured import configurations, products

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
        Of a table of ``data/vendors/products.csv`` or ``configurations.csv``.
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
    known = products() | configurations()
    _checks.choice("name", name, list(known))
    row, kind = known[name], "mitigation_" if name in configurations() else ""
    kind = "shared_" if shared else kind
    return points_of(row["product"], row["variant"], int(row["least_processes"]), kind)


def points_of(
    product: str, variant: str, least: int = 2, kind: str = "mitigation_"
) -> tuple[Point, ...]:
    """Return the points of a product and variant that have at least so many processes [1].

    With the kind left out: of an configuration of ``lab/mitigations.csv``, with a table or without.
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
_OF_DEATHS = ("configuration", "event", "phase", "who", "quantity")


@cache
def _seconds(table: str = "deaths") -> dict[tuple[str, ...], list[dict[str, str]]]:
    found: dict[tuple[str, ...], list[dict[str, str]]] = defaultdict(list)
    for row in read_data(f"measured/{table}.csv", "discostorm_book"):
        found[tuple(row[name] for name in _OF_DEATHS)].append(row)
    return dict(found)


def death_times(
    configuration: str, event: str, phase: str, who: str, quantity: str
) -> NDArray[np.float64]:
    """Return how long something took in each run after a server, router or robot had died [s].

    Parameters
    ----------
    configuration : str
        Of ``data/measured/configurations.csv``, such as "Zenoh router"; of an outage, "Fast DDS
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
    key = (configuration, event, phase, who, quantity)
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
        A row for each ``configuration``, ``event``, ``phase``, ``who`` and ``quantity``: how long
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
