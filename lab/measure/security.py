"""Compute how much DDS Security adds to a startup, from counted swarms with and without it.

Reads `lab/data/security_runs.csv` and `security_counts.csv`; needs neither root nor Debian.
"""

import argparse
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from counted_airtime import airtime_counted
from lab_data import BOOK, CORE, DATA, read_lab_table, write_table

from discostorm_book.lab_counts import GridPoint, points_of_variant

#: Each product, with its variant for runs without security.
PRODUCTS = {"Fast DDS": ("fast_dds", "default"), "Cyclone DDS": ("cyclone_dds_0.10", "spdp")}
#: Protections: all that SROS2 protects by default, or only discovery.
ALL_TRAFFIC, DISCOVERY_ONLY = "secure", "secure_discovery"
HANDSHAKE, KEYS = "Authentication", "Encrypted key exchange"


def secured_points(name: str, variant: str) -> tuple[GridPoint, ...]:
    """Return the points of a product and variant in the grid with and without security."""
    return points_of_variant(name, variant, 1, f"{DATA}/security_")


def median_airtime(point: GridPoint, window: str, *kinds: str) -> float:
    """Return the airtime of some kinds (default: all), as median of the runs [s]."""
    runs = {key: counts for key, counts in point.runs.items() if not kinds or key[1] in kinds}
    some = GridPoint(point.name, point.use, point.fleet, runs, point.ready)
    return float(np.median(airtime_counted(some, window, zenoh=False)))


def startup_rows() -> Iterator[dict[str, Any]]:
    """Yield a row for each product and swarm, with all digits."""
    for product, (name, plain_variant) in PRODUCTS.items():
        variants = (
            secured_points(name, each) for each in (plain_variant, ALL_TRAFFIC, DISCOVERY_ONLY)
        )
        for plain, secured, discovery in zip(*variants, strict=True):
            without, whole, some = (
                median_airtime(p, "startup") for p in (plain, secured, discovery)
            )
            yield {
                "product": product,
                "swarm": plain.name[:-1],
                "matching": plain.name.endswith("m"),
                "runs": sum(len(point.ready) for point in (plain, secured, discovery)),
                "without_s": without,
                "secured_s": whole,
                "discovery_s": some,
                "times": whole / without,
                "times_discovery": some / without,
                "handshake": median_airtime(secured, "startup", HANDSHAKE) / whole,
                "keys": median_airtime(secured, "startup", KEYS) / whole,
                "times_steady": median_airtime(secured, "steady") / median_airtime(plain, "steady"),
            }


def unauthenticated_pair_rows() -> Iterator[dict[str, Any]]:
    """Yield a row for each run with security: the number of pairs that never authenticated."""
    names = {name: product for product, (name, _) in PRODUCTS.items()}
    for run in read_lab_table("security_runs.csv"):
        if run["strangers"]:
            hosts, processes = int(run["hosts"]), int(run["processes"])
            yield {
                "product": names[run["product"]],
                "processes": hosts * processes,
                "pairs": hosts * (hosts - 1) * processes**2,
                "strangers": run["strangers"],
            }


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=Path, help="folder")
    given = parser.parse_args()
    write_table((given.out or CORE) / "security.csv", startup_rows())
    write_table((given.out or BOOK) / "security_strangers.csv", unauthenticated_pair_rows())


if __name__ == "__main__":
    main()
