"""How far measured models are from captures they were not fitted to, and what restarts take.

From the lab's counts, on the paper's channel: `bands.csv`, the airtime of held-out points relative
to their model, within the range that was captured for it (the half of the grid that tests it) and
beyond (`grids/beyond.csv`); and `restarts.csv`, what a process that restarts and a host that joins
take relative to the start of all. Needs neither root nor Debian.
"""

import argparse
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path
from statistics import median
from typing import Any

import numpy as np
from counted_airtime import airtime_counted, airtime_expected
from lab_data import CORE, DATA, PLANNER, read, write

from discostorm.measured import CLASSES, configurations, products, size_of
from discostorm.protocols.as_built import as_built
from discostorm_book.lab_counts import WINDOWS, beyond, points, points_of

DIGITS = 3
RESTARTS = ("restart", "join")


def bands() -> Iterator[dict[str, Any]]:
    """Yield a row for each table, window and class of sizes: what was measured beside the table."""
    for name in products() | configurations():
        table = as_built(name)
        assert table.captured is not None
        held = [point for point in points(name) + beyond(name) if point.use == "test"]
        for window in WINDOWS:
            ratios = defaultdict(list)
            for point in held:
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


def restarts() -> Iterator[dict[str, Any]]:
    """Yield a row for each table and event: what it takes beside a start, without what repeats.

    The share is that of a start of all; the factor is how many times what its pairs of processes
    take in such a start.
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
            # The windows are half as long as the steady one. What repeats grows with pairs.
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
    write((given.out or CORE) / "bands.csv", bands())
    write((given.out or PLANNER) / "restarts.csv", restarts())


if __name__ == "__main__":
    main()
