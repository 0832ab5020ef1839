"""Prediction errors of measured models on held-out captures, and the airtime of restarts.

Computed from the lab's counts, on the paper's channel. `bands.csv`: airtime of held-out points
relative to their model, within the captured range (the test half of the grid) and beyond
(`grids/beyond.csv`), and of swarms of the release that ROS 2 ships. `restarts.csv`: airtime of a
process restart and of a host that joins, relative to a common startup. This needs neither root nor
Debian.
"""

import argparse
from collections import defaultdict
from collections.abc import Iterator, Sequence
from pathlib import Path
from statistics import median
from typing import Any

import numpy as np
from counted_airtime import airtime_counted, airtime_expected
from fit_models import fitted_rows
from lab_data import BOOK, CORE, DATA, PLANNER, read_lab_table, write_table
from release_points import release_of, release_points

from discostorm.data import read_data
from discostorm.prediction_error import SIZE_CLASSES, points_outside_interval, relative_fleet_size
from discostorm.protocols.measured_tables import (
    configurations,
    measured_table,
    product_releases,
    products,
    table_with_counts,
)
from discostorm_book.lab_counts import (
    WINDOWS,
    GridPoint,
    grid_points,
    points_of_variant,
)

STORED_DIGITS = 3
RESTARTS = ("restart", "join")


def error_band_rows() -> Iterator[dict[str, Any]]:
    """Yield a row for each table, window and size class: measured airtime relative to the model."""
    for name in products() | configurations():
        table = measured_table(name)
        assert table.captured is not None
        held = [
            point
            for point in grid_points(name) + grid_points(name, "beyond")
            if point.use == "test"
        ]
        for window in WINDOWS:
            ratios = defaultdict(list)
            for point in [*held, *(shipped_points(name) if window == "startup" else ())]:
                taken = airtime_counted(point, window, table.family == "Zenoh")
                expected = airtime_expected(table, point.fleet, window)
                times = relative_fleet_size(point.fleet, table.captured)
                most = next(most for most in SIZE_CLASSES if max(times) <= most)
                ratios[most].append((float(np.median(taken)) / expected, *times))
            for most, found in sorted(ratios.items()):
                values, of_hosts, of_endpoints = zip(*found, strict=True)
                low, high = ratio_interval(values)
                yield {
                    "protocol": name,
                    "window": window,
                    "up_to": f"{most:g}",
                    "most_hosts": f"{max(of_hosts):.{STORED_DIGITS}g}",
                    "most_endpoints": f"{max(of_endpoints):.{STORED_DIGITS}g}",
                    "points": len(found),
                    "low": f"{low:.{STORED_DIGITS}f}",
                    "typical": f"{median(abs(value - 1) for value in values):.{STORED_DIGITS}f}",
                    "high": f"{high:.{STORED_DIGITS}f}",
                }


def ratio_interval(ratios: Sequence[float]) -> tuple[float, float]:
    """Return the ends of an interval of nine in ten, or least and most of fewer than 39 ratios.

    One more swarm is between the k-th least and the k-th most of n with a probability of
    (n + 1 - 2 k) / (n + 1).
    """
    ordered, beyond_end = sorted(ratios), points_outside_interval(len(ratios))
    return ordered[beyond_end], ordered[-1 - beyond_end]


def other_releases(name: str) -> list[str]:
    """Return the releases, such as fast_dds-3.2.5, that a table stands for besides its own."""
    fitted = product_releases().get(name, {}).get("versions")
    shipped = {
        f"{row['product'].lower().replace(' ', '_')}-{row['shipped']}"
        for row in read_data("vendors/ros.csv")
        if row["protocol"] == name and row["shipped"] != fitted
    }
    return sorted(shipped)


def shipped_points(name: str) -> Iterator[GridPoint]:
    """Yield the 12 s swarms of the other releases that ROS 2 ships and that this table covers.

    For example, the table for Cyclone DDS 0.10.5 is fitted to 0.10.2.
    """
    for release in other_releases(name):
        yield from release_points(release)


def points_by_release(name: str, server: str = "") -> Iterator[tuple[str, GridPoint]]:
    """Yield the swarms of the release that a table is fitted to, and of others it stands for."""
    for release in (release_of(product_releases()[name]), *other_releases(name)):
        for point in release_points(release, server):
            yield release, point


def held_out_rows(name: str) -> Iterator[dict[str, Any]]:
    """Yield a row for each swarm of a release: its airtime, measured and by its table [s].

    Swarms that the table is fitted to are compared with a table that is fitted without them;
    those of other releases, for which it stands as well, with the table itself.
    """
    table = product_releases()[name]
    fitted = release_of(table)
    measured = tuple(points_by_release(name))
    fit = [point for release, point in measured if (release, point.use) == (fitted, "fit")]
    for release, point in measured:
        rest = [other for other in fit if other is not point]
        rows = {row["message"]: row for row in fitted_rows(name, table, rest)}
        expected = airtime_expected(
            table_with_counts(name, table, rows, ""), point.fleet, "startup"
        )
        taken = airtime_counted(point, "startup", False)
        (group, *_) = point.fleet.groups
        yield {
            "protocol": name,
            "release": release,
            "point": point.name,
            "use": point.use if release == fitted else "test",
            "hosts": f"{point.fleet.hosts():g}",
            "processes": f"{group.processes:g}",
            "endpoints": f"{group.endpoints:g}",
            "runs": len(taken),
            "airtime_s": f"{np.median(taken):.4g}",
            "least_s": f"{taken.min():.4g}",
            "most_s": f"{taken.max():.4g}",
            "expected_s": f"{expected:.4g}",
        }


def release_server_rows() -> Iterator[dict[str, Any]]:
    """Yield a row for each swarm of a release with a Discovery Server: measured, by models [s]."""
    server = measured_table("Fast DDS Discovery Server")
    for name in product_releases():
        for release, point in points_by_release(name, "server"):
            (group,) = point.fleet.groups
            yield {
                "protocol": name,
                "release": release,
                "point": point.name,
                "hosts": f"{group.hosts:g}",
                "processes": f"{group.processes:g}",
                "endpoints": f"{group.endpoints:g}",
                "airtime_s": f"{np.median(airtime_counted(point, 'startup', False)):.4g}",
                "server_s": f"{airtime_expected(server, point.fleet, 'startup'):.4g}",
                "peers_s": f"{airtime_expected(measured_table(name), point.fleet, 'startup'):.4g}",
            }


def release_band_rows(rows: list[dict[str, Any]]) -> Iterator[dict[str, Any]]:
    """Yield a row for each release: the interval of the ratios."""
    for name in dict.fromkeys(row["protocol"] for row in rows):
        ratios = [
            float(row["airtime_s"]) / float(row["expected_s"])
            for row in rows
            if row["protocol"] == name
        ]
        low, high = ratio_interval(ratios)
        yield {
            "protocol": name,
            "window": "startup",
            "up_to": "1",
            "most_hosts": "1",
            "most_endpoints": "1",
            "points": len(ratios),
            "low": f"{low:.{STORED_DIGITS}f}",
            "typical": f"{median(abs(ratio - 1) for ratio in ratios):.{STORED_DIGITS}f}",
            "high": f"{high:.{STORED_DIGITS}f}",
        }


def restart_rows() -> Iterator[dict[str, Any]]:
    """Yield a row for each table and event: airtime relative to a startup, without periods.

    ``share`` is relative to the whole startup, ``factor`` to the same pairs of processes in it.
    Periodic traffic is subtracted.
    """
    names = {(row["product"], row["variant"]): name for name, row in products().items()}
    for key in dict.fromkeys(
        (run["product"], run["variant"]) for run in read_lab_table("restart_runs.csv")
    ):
        zenoh = products()[names[key]]["family"] == "Zenoh"
        shares, factors, sizes = defaultdict(list), defaultdict(list), []
        for point in points_of_variant(*key, 2, f"{DATA}/restart_"):
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
                "least_share": f"{min(shares[event]):.{STORED_DIGITS}f}",
                "most_share": f"{max(shares[event]):.{STORED_DIGITS}f}",
                "low": f"{min(factors[event]):.{STORED_DIGITS}g}",
                "high": f"{max(factors[event]):.{STORED_DIGITS}g}",
                "source": "restart_runs.csv and restart_counts.csv (lab/measure/restarts.py)",
            }


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=Path, help="folder, instead of those of the packages")
    given = parser.parse_args()
    swarms = [row for name in product_releases() for row in held_out_rows(name)]
    write_table((given.out or CORE) / "bands.csv", [*error_band_rows(), *release_band_rows(swarms)])
    write_table((given.out or BOOK) / "release_airtime.csv", swarms)
    write_table((given.out or BOOK) / "release_servers.csv", release_server_rows())
    write_table((given.out or PLANNER) / "restarts.csv", restart_rows())


if __name__ == "__main__":
    main()
