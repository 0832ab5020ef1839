"""The lab's counts of messages of real middleware, and its times of failures."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING, Literal

import numpy as np
from numpy.typing import NDArray

from discostorm import _checks
from discostorm.data import read_data
from discostorm.fleet import Fleet, HostGroup
from discostorm.messages import Protocol
from discostorm.protocols import DDS, PROTOCOLS, ZENOH
from discostorm.protocols.measured_tables import configurations, products

if TYPE_CHECKING:
    import pandas as pd

#: The windows that were counted, from when to when after the start [s].
WINDOWS = {"startup": (0.0, 12.0), "steady": (12.0, 36.0)}
#: Endpoints of a process on a topic that all processes share, in swarms named ``shared`` [1].
SHARED_ENDPOINTS = 2
#: Window, kind, subject ("" for all), cast, and hop ("" for both).
CountKey = tuple[str, str, str, str, str]
#: Columns that identify a measured time after a failure, without the run's number.
_FAILURE_COLUMNS = ("configuration", "event", "phase", "who", "quantity")


@dataclass(frozen=True)
class GridPoint:
    """A swarm of the grid, with all runs of one product and variant."""

    #: Hosts, processes and endpoints; topic names match (m), are unique (u), or one is shared (s).
    name: str
    #: The half of the grid: "fit" or "test".
    use: str
    fleet: Fleet
    #: Messages [1], frames [1] and bytes of payload [B], a row a run.
    runs: dict[CountKey, NDArray[np.float64]]
    #: When the last process of each run had made its endpoints [s].
    ready: NDArray[np.float64]

    def median(self, key: CountKey) -> NDArray[np.float64]:
        """Return the medians of messages, frames and bytes; zeros if there were none."""
        return np.median(self.runs[key], axis=0) if key in self.runs else np.zeros(3)


@cache
def counts_of_runs(tables: str) -> dict[str, dict[CountKey, NDArray[np.float64]]]:
    """Return the counts of each run, from the tables with this prefix."""
    counts: dict[str, dict[CountKey, NDArray[np.float64]]] = defaultdict(
        lambda: defaultdict(lambda: np.zeros(3))
    )
    for row in read_data(f"{tables}counts.csv", "discostorm_book"):
        cast = "multicast" if row["multicast"] == "1" else "unicast"
        numbers = np.array([float(row[name]) for name in ("messages", "frames", "bytes")])
        for about in {row["about"], ""}:
            key = (row["window"], row["kind"], about, cast, row.get("hops", ""))
            counts[row["run"]][key] += numbers
    return counts


@cache
def grid_points(name: str, part: Literal["", "shared", "beyond"] = "") -> tuple[GridPoint, ...]:
    """Return a model's points with two hosts or more: of the grid, with a shared topic, beyond."""
    models = products() | configurations()
    _checks.choice("name", name, list(models))
    tables = part or ("mitigation" if name in configurations() else "")
    # Tables of wired networks hold from three processes on: two processes send otherwise.
    row, prefix = models[name], f"measured/{tables}_" if tables else "measured/"
    return points_of_variant(row["product"], row["variant"], int(row["least_processes"]), prefix)


def points_of_variant(
    product: str, variant: str, processes_min: int = 2, tables: str = "measured/mitigation_"
) -> tuple[GridPoint, ...]:
    """Return the points of a product and variant, from the tables with a prefix."""
    runs_of: dict[tuple[str, ...], dict[str, float]] = defaultdict(dict)
    columns = ("hosts", "processes", "endpoints", "names", "use")
    for run in read_data(f"{tables}runs.csv", "discostorm_book"):
        if (run["product"], run["variant"]) == (product, variant):
            ready_s = float(run["endpoints_created_s"])
            runs_of[tuple(run[column] for column in columns)][run["run"]] = ready_s
    found, counts = [], counts_of_runs(tables)
    for (*swarm, names, use), runs in runs_of.items():
        hosts, processes, endpoints = map(int, swarm)
        if hosts < 2 or hosts * processes < processes_min:
            continue
        host = HostGroup(hosts, processes, endpoints, shared=SHARED_ENDPOINTS * (names == "shared"))
        fleet = Fleet((host,), matching=float(names == "matching"))
        found.append(point_from_runs(f"{'x'.join(swarm)}{names[0]}", use, fleet, runs, counts))
    return tuple(found)


def point_from_runs(
    name: str,
    use: str,
    fleet: Fleet,
    ready_s: Mapping[str, float],
    counts: Mapping[str, Mapping[CountKey, NDArray[np.float64]]],
) -> GridPoint:
    """Combine runs into a grid point; ``ready_s`` says when all endpoints of each run existed."""
    none = np.zeros(3)
    keys = sorted({key for run in ready_s for key in counts[run]})
    counted = {key: np.array([counts[run].get(key, none) for run in ready_s]) for key in keys}
    return GridPoint(name, use, fleet, counted, np.array(list(ready_s.values())))


def paper_protocol_of_product(name: str) -> Protocol:
    """Return the paper's messages for a product."""
    return DDS if PROTOCOLS[name].family == "DDS" else ZENOH


def sent_over_counted(name: str, message: str) -> list[float]:
    """Return the ratio of sent messages to the paper's count in a startup, for each swarm."""
    counted = paper_protocol_of_product(name).message(message)
    keys = [("startup", counted.kind, "", cast, "") for cast in ("unicast", "multicast")]
    return [
        sum(float(point.median(key)[0]) for key in keys) / load
        for point in grid_points(name)
        if (load := float(counted.load(point.fleet)))
    ]


def mean_payloads(name: str, kind: str) -> list[float]:
    """Return the mean payload of a kind of message in the startup window of each point [B]."""
    sizes = []
    for point in grid_points(name):
        keys = (("startup", kind, "", cast, "") for cast in ("multicast", "unicast"))
        messages, _, octets = np.sum([point.median(key) for key in keys], axis=0)
        if messages:
            sizes.append(float(octets / messages))
    return sizes


@cache
def _failure_rows(table: str) -> dict[tuple[str, ...], list[dict[str, str]]]:
    """Return the rows of a table of failures, one row per run, by the other columns."""
    rows_of: dict[tuple[str, ...], list[dict[str, str]]] = defaultdict(list)
    for row in read_data(f"measured/{table}.csv", "discostorm_book"):
        rows_of[tuple(row[name] for name in _FAILURE_COLUMNS)].append(row)
    return dict(rows_of)


def failure_times(
    configuration: str, event: str, phase: str, who: str, quantity: str
) -> NDArray[np.float64]:
    """Return a measured time of each run after a failure [s]; infinity if the event never came."""
    key = (configuration, event, phase, who, quantity)
    every = _failure_rows("deaths") | _failure_rows("outages")
    if key not in every:
        for position, name in enumerate(_FAILURE_COLUMNS):
            choices = {other[position] for other in every if other[:position] == key[:position]}
            _checks.choice(name, key[position], sorted(choices))
    return np.array([float(row["seconds"]) for row in every[key]])


def failure_summary(table: str = "deaths") -> pd.DataFrame:
    """Return the times that failures of servers, routers and robots took [s], over all runs."""
    import pandas as pd

    _checks.choice("table", table, ["deaths", "outages"])
    runs = pd.DataFrame(read_data(f"measured/{table}.csv", "discostorm_book"))
    runs = runs.astype(dict.fromkeys(("since_s", "watched_s", "seconds"), float))
    runs["finite"] = np.isfinite(runs["seconds"])
    columns = {"since_s": ("since_s", "first"), "watched_s": ("watched_s", "first")}
    columns |= {"runs": ("seconds", "size"), "happened": ("finite", "sum")}
    columns |= {"median_s": ("seconds", "median")}
    columns |= {"least_s": ("seconds", "min"), "most_s": ("seconds", "max")}
    return runs.groupby(list(_FAILURE_COLUMNS), sort=False).agg(**columns).reset_index()
