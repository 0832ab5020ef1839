"""What products really send: tables of `data/vendors/as_built.csv` and `measured/as_built.csv`.

The first says of each message what it is sent for and when, and where that stands in the
source; the second how many, and how large, where only measuring tells. `lab/fit.py` writes it.
What they send when they are arranged otherwise than as shipped, against the storm, is in files
of the same columns, `mitigations.csv`.
"""

from collections.abc import Mapping
from typing import Any, cast as typed

import numpy as np

from discostorm.data import read_data
from discostorm.messages import (
    HOPS,
    UNITS,
    Basis,
    Family,
    Hop,
    Message,
    Payload,
    Protocol,
    Role,
    Schedule,
    Transport,
)
from discostorm.protocols.defaults import defaults, timers
from discostorm.wifi import Cast


def schedule(row: Mapping[str, str]) -> Schedule:
    """Return when a message of the table is sent."""
    starts = tuple(float(time) for time in row["starts_s"].split())
    return Schedule(starts, float(row["period_s"] or np.inf))


#: Of a row that is not fitted yet.
_NOTHING = {"per_unit": "0"}
#: By the name of a file of rows, the file that says what was run.
FAMILIES = {"as_built": "products", "mitigations": "arrangements"}


def as_built(name: str, family: str = "as_built") -> Protocol:
    """Return the table of a product, of a name in ``data/vendors/products.csv``.

    Of the family "mitigations": of a name in ``data/vendors/arrangements.csv``. A row of which
    nothing was measured is left out.
    """
    (product,) = (
        row for row in read_data(f"vendors/{FAMILIES[family]}.csv") if row["protocol"] == name
    )
    measured = {
        row["message"]: row
        for row in read_data(f"measured/{family}.csv")
        if row["protocol"] == name
    }
    rows = {
        row["message"]: row | measured[row["message"]]
        for row in read_data(f"vendors/{family}.csv")
        if row["protocol"] == name and float(measured.get(row["message"], _NOTHING)["per_unit"])
    }
    return Protocol(
        name,
        tuple(_message(row, rows, family) for row in rows.values()),
        lease=defaults(product["defaults"])["lease"],
        wired=as_built(product["wired"], family) if product["wired"] else None,
        family=typed(Family, product["family"]),
        product=product["defaults"],
        basis=typed(Basis, product["basis"]),
        timers=timers(product["defaults"]),
    )


def hops(row: Mapping[str, str]) -> tuple[Hop, ...]:
    """Return the hops of a message of the table: both, but where one end is wired."""
    return tuple(hop for hop in HOPS if row.get("hops") in ("", None, hop))


def _message(row: dict[str, str], known: Mapping[str, Any], family: str) -> Message:
    source = f"{row['source']}; size: measured (discostorm/data/measured/{family}.csv)"
    nominal, low, high = (float(row[column]) for column in ("payload_B", "low_B", "high_B"))
    return Message(
        row["message"],
        row["phase"],
        typed(Cast, row["cast"]),
        typed(Transport, row["transport"]),
        Payload(nominal, low, high, source),
        UNITS[row["unit"]],
        float(row["per_unit"]),
        schedule(row),
        hops(row),
        answers=row["answers"] if row["answers"] in known else None,
        frames=float(row["frames"]),
        kind=row["kind"],
        role=typed(Role, row["role"]),
        informs=row["informs"] == "yes",
    )
