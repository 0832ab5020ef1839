"""Startups with and without DDS Security, as measured in the lab."""

import pandas as pd

from discostorm.data import data_path

#: The products that ran with DDS Security.
PRODUCTS = ("Fast DDS", "Cyclone DDS")


def startup_airtimes() -> pd.DataFrame:
    """Return the airtime with DDS Security and without, by product and swarm: medians [s]."""
    path = data_path("measured/security.csv")
    return pd.read_csv(path, float_precision="round_trip").drop(columns="runs")


def unauthenticated_pairs(product: str) -> pd.DataFrame:
    """Return the ``pairs`` of each secured run, and the ``strangers`` that never authenticated."""
    runs = pd.read_csv(data_path("measured/security_strangers.csv", "discostorm_book"))
    return runs[runs["product"] == product].drop(columns="product")
