"""What DDS Security adds to a startup: swarms with it and without it, in the lab."""

import pandas as pd

from discostorm.data import data_path

#: The products that ran with DDS Security.
PRODUCTS = ("Fast DDS", "Cyclone DDS")


def startups() -> pd.DataFrame:
    """Return a row for each product and swarm, all airtime in medians of the runs.

    ``matching`` says whether names match; ``without_s``, ``secured_s`` and ``discovery_s`` are the
    airtime of a startup without security, with all and for discovery alone [s]; ``times`` and
    ``times_discovery`` compare these with the first [1]; ``handshake`` and ``keys`` are the parts
    of the secured startup that are either [1]; ``times_steady`` compares steady states [1].
    """
    path = data_path("measured/security.csv", "discostorm_book")
    return pd.read_csv(path, float_precision="round_trip").drop(columns="runs")


def strangers(product: str) -> pd.DataFrame:
    """Return a row for each run of a product with security.

    Of its ``processes``, ``pairs`` are on different hosts, and the ``strangers`` never
    authenticated [1].
    """
    runs = pd.read_csv(data_path("measured/security_strangers.csv", "discostorm_book"))
    return runs[runs["product"] == product].drop(columns="product")
