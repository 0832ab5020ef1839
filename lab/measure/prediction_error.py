"""Prediction errors of measured models on held-out captures, and the airtime of restarts.

Computed from the lab's counts, on the paper's channel. `bands.csv`: airtime of held-out points
relative to their model, within the captured range (the test half of the grid) and beyond
(`grids/beyond.csv`), and of swarms of the release that ROS 2 ships. `restarts.csv`: airtime of a
process restart and of a host that joins, relative to a common startup. This needs neither root nor
Debian.
"""

import argparse
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path
from statistics import median
from typing import Any

import numpy as np
from counted_airtime import airtime_counted, airtime_expected
from fit_models import fitted_rows
from lab_data import BOOK, CORE, DATA, PLANNER, read, write
from release_points import release_of, release_points

from discostorm.data import read_data
from discostorm.measured import CLASSES, configurations, products, releases, size_of
from discostorm.protocols.as_built import as_built, with_counts
from discostorm_book.lab_counts import WINDOWS, Point, beyond, points, points_of

DIGITS = 3
RESTARTS = ("restart", "join")


def bands() -> Iterator[dict[str, Any]]:
    """Yield a row for each table, window and size class: measured airtime relative to the model."""
    for name in products() | configurations():
        table = as_built(name)
        assert table.captured is not None
        held = [point for point in points(name) + beyond(name) if point.use == "test"]
        for window in WINDOWS:
            ratios = defaultdict(list)
            for point in [*held, *(shipped_points(name) if window == "startup" else ())]:
                taken = airtime_counted(point, window, table.family == "Zenoh")
                told = airtime_expected(table, point.fleet, window)
                times = size_of(point.fleet, table.captured)
                most = next(most for most in CLASSES if max(times) <= most)
                ratios[most].append((float(np.median(taken)) / told, *times))
            for most, found in sorted(ratios.items()):
                values, of_hosts, of_endpoints = zip(*found, strict=True)
                yield {
                    "protocol": name,
                    "window": window,
                    "up_to": f"{most:g}",
                    "most_hosts": f"{max(of_hosts):.{DIGITS}g}",
                    "most_endpoints": f"{max(of_endpoints):.{DIGITS}g}",
                    "points": len(found),
                    "low": f"{min(values):.{DIGITS}f}",
                    "typical": f"{median(abs(value - 1) for value in values):.{DIGITS}f}",
                    "high": f"{max(values):.{DIGITS}f}",
                }


def shipped_points(name: str) -> Iterator[Point]:
    """Yield the swarms, of 12 s, of a release that ROS 2 ships and this table stands for.

    Such as Cyclone DDS 0.10.5: its table is fitted to 0.10.2.
    """
    shipped = {
        (row["product"], row["shipped"])
        for row in read_data("vendors/ros.csv")
        if row["protocol"] == name and name not in releases()
    }
    for product, version in sorted(shipped):
        yield from release_points(f"{product.lower().replace(' ', '_')}-{version}")


def held_out(name: str) -> Iterator[dict[str, Any]]:
    """Yield a row for each swarm of a release: its airtime, measured and by its table [s].

    Swarms that the table is fitted to are compared with a table that is fitted without them.
    """
    table = releases()[name]
    everyone = release_points(release_of(table))
    fit = [point for point in everyone if point.use == "fit"]
    for point in everyone:
        rest = [other for other in fit if other is not point]
        rows = {row["message"]: row for row in fitted_rows(name, table, rest)}
        expected = airtime_expected(with_counts(name, table, rows, ""), point.fleet, "startup")
        taken = airtime_counted(point, "startup", False)
        (group, *_) = point.fleet.groups
        yield {
            "protocol": name,
            "point": point.name,
            "use": point.use,
            "hosts": f"{point.fleet.hosts():g}",
            "processes": f"{group.processes:g}",
            "endpoints": f"{group.endpoints:g}",
            "runs": len(taken),
            "airtime_s": f"{np.median(taken):.4g}",
            "least_s": f"{taken.min():.4g}",
            "most_s": f"{taken.max():.4g}",
            "expected_s": f"{expected:.4g}",
        }


def release_servers() -> Iterator[dict[str, Any]]:
    """Yield a row for each swarm of a release with a Discovery Server: measured, by models [s]."""
    server = as_built("Fast DDS Discovery Server")
    for name, table in releases().items():
        for point in release_points(release_of(table), "server"):
            (group,) = point.fleet.groups
            yield {
                "protocol": name,
                "point": point.name,
                "hosts": f"{group.hosts:g}",
                "processes": f"{group.processes:g}",
                "endpoints": f"{group.endpoints:g}",
                "airtime_s": f"{np.median(airtime_counted(point, 'startup', False)):.4g}",
                "server_s": f"{airtime_expected(server, point.fleet, 'startup'):.4g}",
                "peers_s": f"{airtime_expected(as_built(name), point.fleet, 'startup'):.4g}",
            }


def release_bands(rows: list[dict[str, Any]]) -> Iterator[dict[str, Any]]:
    """Yield a row for each release: the least and the most of the ratios.

    Of n swarms, one more is inside with a probability of (n - 1) / (n + 1): nine in ten from 19.
    """
    for name in dict.fromkeys(row["protocol"] for row in rows):
        ratios = [
            float(row["airtime_s"]) / float(row["expected_s"])
            for row in rows
            if row["protocol"] == name
        ]
        yield {
            "protocol": name,
            "window": "startup",
            "up_to": "1",
            "most_hosts": "1",
            "most_endpoints": "1",
            "points": len(ratios),
            "low": f"{min(ratios):.{DIGITS}f}",
            "typical": f"{median(abs(ratio - 1) for ratio in ratios):.{DIGITS}f}",
            "high": f"{max(ratios):.{DIGITS}f}",
        }


def restarts() -> Iterator[dict[str, Any]]:
    """Yield a row for each table and event: airtime relative to a startup, without periods.

    ``share`` is relative to the whole startup, ``factor`` to the same pairs of processes in it.
    Periodic traffic is subtracted.
    """
    names = {(row["product"], row["variant"]): name for name, row in products().items()}
    for key in dict.fromkeys((run["product"], run["variant"]) for run in read("restart_runs.csv")):
        zenoh = products()[names[key]]["family"] == "Zenoh"
        shares, factors, sizes = defaultdict(list), defaultdict(list), []
        for point in points_of(*key, 2, f"{DATA}/restart_"):
            (group,) = point.fleet.groups
            hosts, each = int(group.hosts), int(group.processes)
            sizes.append(hosts * each)
            taken = {
                window: airtime_counted(point, window, zenoh)
                for window in ("startup", "steady", *RESTARTS)
            }
            # The windows are half as long as the steady window. Periodic traffic grows with pairs.
            repeated = taken["steady"] / 2
            more = {"restart": 1.0, "join": (hosts + 1) / (hosts - 1)}
            pairs = {"restart": 2 / (hosts * each), "join": 2 / (hosts - 1)}
            for event in RESTARTS:
                share = (taken[event] - more[event] * repeated) / (taken["startup"] - repeated)
                shares[event].extend(share)
                factors[event].append(float(np.median(share)) / pairs[event])
        for event in RESTARTS:
            yield {
                "protocol": names[key],
                "event": event,
                "points": len(factors[event]),
                "processes_min": min(sizes),
                "processes_max": max(sizes),
                "runs": len(shares[event]),
                "least_share": f"{min(shares[event]):.{DIGITS}f}",
                "most_share": f"{max(shares[event]):.{DIGITS}f}",
                "low": f"{min(factors[event]):.{DIGITS}g}",
                "high": f"{max(factors[event]):.{DIGITS}g}",
                "source": "restart_runs.csv and restart_counts.csv (lab/measure/restarts.py)",
            }


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=Path, help="folder, instead of those of the packages")
    given = parser.parse_args()
    swarms = [row for name in releases() for row in held_out(name)]
    write((given.out or CORE) / "bands.csv", [*bands(), *release_bands(swarms)])
    write((given.out or BOOK) / "release_airtime.csv", swarms)
    write((given.out or BOOK) / "release_servers.csv", release_servers())
    write((given.out or PLANNER) / "restarts.csv", restarts())


if __name__ == "__main__":
    main()
