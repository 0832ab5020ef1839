"""What DDS Security adds to a startup: swarms with it and without it, in the lab."""

from functools import cache

import numpy as np
import pandas as pd

from discostorm.data import read_data
from discostorm_book.comparison import airtime_counted
from discostorm_book.lab_counts import Point, points_of

#: Each product: what was run without security, beside it.
PRODUCTS = {
    "Fast DDS": ("fast_dds", "default"),
    "Cyclone DDS": ("cyclone_dds_0.10", "spdp"),
}
#: What is protected: all that SROS2 protects by default, or discovery alone.
ALL, DISCOVERY = "secure", "secure_discovery"
HANDSHAKE, KEYS = "Authentication", "Encrypted key exchange"


def _median(point: Point, window: str, *kinds: str) -> float:
    """Return the airtime of some kinds, of all if none is named, in the median of the runs [s]."""
    runs = {key: counts for key, counts in point.runs.items() if not kinds or key[1] in kinds}
    some = Point(point.name, point.use, point.fleet, runs, point.ready)
    return float(np.median(airtime_counted(some, window, zenoh=False)))


@cache
def _points(product: str) -> tuple[tuple[Point, Point, Point], ...]:
    """Return each swarm without security, with all of it, and for discovery alone."""
    name, plain = PRODUCTS[product]
    three = (points_of(name, variant, 1, "security_") for variant in (plain, ALL, DISCOVERY))
    return tuple(zip(*three, strict=True))


def startups() -> pd.DataFrame:
    """Return a row for each product and swarm, all airtime in medians of the runs.

    ``matching`` says whether names match; ``without_s``, ``secured_s`` and ``discovery_s`` are the
    airtime of a startup without security, with all and for discovery alone [s]; ``times`` and
    ``times_discovery`` compare these with the first [1]; ``handshake`` and ``keys`` are the parts
    of the secured startup that are either [1]; ``times_steady`` compares steady states [1].
    """
    rows = []
    for product in PRODUCTS:
        for plain, secured, discovery in _points(product):
            without, all_, some = (_median(one, "startup") for one in (plain, secured, discovery))
            rows.append(
                {
                    "product": product,
                    "swarm": plain.name[:-1],
                    "matching": plain.name.endswith("m"),
                    "without_s": without,
                    "secured_s": all_,
                    "discovery_s": some,
                    "times": all_ / without,
                    "times_discovery": some / without,
                    "handshake": _median(secured, "startup", HANDSHAKE) / all_,
                    "keys": _median(secured, "startup", KEYS) / all_,
                    "times_steady": _median(secured, "steady") / _median(plain, "steady"),
                }
            )
    return pd.DataFrame(rows)


def strangers(product: str) -> pd.DataFrame:
    """Return a row for each run of a product with security.

    Of its ``processes``, ``pairs`` are on different hosts, and the ``strangers`` never
    authenticated [1].
    """
    found = pd.DataFrame(read_data("measured/security_runs.csv", "discostorm_book"))
    found = found[(found["product"] == PRODUCTS[product][0]) & (found["strangers"] != "")]
    hosts, each = found["hosts"].astype(int), found["processes"].astype(int)
    return pd.DataFrame(
        {
            "processes": hosts * each,
            "pairs": hosts * (hosts - 1) * each**2,
            "strangers": found["strangers"].astype(int),
        }
    )
