"""What products really send: tables of `data/vendors/as_built.csv` and `measured/as_built.csv`.

The first says of each message what it is sent for and when, and where that stands in the
source; the second how many, and how large, where only measuring tells. `lab/fit.py` writes it.
"""

from collections.abc import Mapping
from typing import Any

import numpy as np

from discostorm.data import read_data
from discostorm.messages import UNITS, Message, Payload, Protocol, Schedule
from discostorm.protocols.defaults import defaults


def schedule(row: Mapping[str, str]) -> Schedule:
    """Return when a message of the table is sent."""
    starts = tuple(float(time) for time in row["starts_s"].split())
    return Schedule(starts, float(row["period_s"] or np.inf))


def as_built(name: str) -> Protocol:
    """Return the table of a product, of a name in ``data/vendors/products.csv``.

    A row of which nothing was measured is left out.
    """
    (product,) = (row for row in read_data("vendors/products.csv") if row["protocol"] == name)
    measured = {
        row["message"]: row for row in read_data("measured/as_built.csv") if row["protocol"] == name
    }
    rows = {
        row["message"]: row | measured[row["message"]]
        for row in read_data("vendors/as_built.csv")
        if row["protocol"] == name and float(measured[row["message"]]["per_unit"])
    }
    return Protocol(
        name,
        tuple(_message(row, known=rows) for row in rows.values()),
        lease=defaults(product["defaults"])["lease"],
        wired=as_built(product["wired"]) if product["wired"] else None,
    )


def _message(row: dict[str, str], known: Mapping[str, Any]) -> Message:
    source = f"{row['source']}; size: measured (discostorm/data/measured/as_built.csv)"
    nominal, low, high = (float(row[column]) for column in ("payload_B", "low_B", "high_B"))
    cast, transport = row["cast"], row["transport"]
    return Message(
        row["message"],
        row["phase"],
        "multicast" if cast == "multicast" else "unicast",
        "TCP" if transport == "TCP" else "UDP",
        Payload(nominal, low, high, source),
        UNITS[row["unit"]],
        float(row["per_unit"]),
        schedule(row),
        answers=row["answers"] if row["answers"] in known else None,
        frames=float(row["frames"]),
        kind=row["kind"],
    )
