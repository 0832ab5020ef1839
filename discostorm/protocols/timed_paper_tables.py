"""The paper's counts with the announcements, periods and leases of products.

The paper says how many messages are sent and how long they are, the product when: rows of
``data/vendors/timed.csv``, each a message of the paper with what differs from it.
"""

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from discostorm._numeric import int_if_integral
from discostorm.data import read_data
from discostorm.messages import UNITS, Message, Payload, Protocol
from discostorm.protocols.defaults import defaults, timers
from discostorm.protocols.measured_tables import schedule_from_row
from discostorm.protocols.paper import DDS, ZENOH


def _timed_message(row: Mapping[str, str], paper: Protocol) -> Message:
    """Return a message of the paper, changed to the values in a row's filled cells."""
    changes: dict[str, Any] = {name: row[name] for name in ("phase", "cast", "role") if row[name]}
    if row["unit"]:
        changes["unit"] = UNITS[row["unit"]]
    if row["per_unit"]:
        changes["per_unit"] = int_if_integral(float(row["per_unit"]))
    if row["starts_s"]:
        changes["schedule"] = schedule_from_row(row)
    if row["answers"]:
        changes["answers"] = None if row["answers"] == "-" else row["answers"]
    if row["payload_B"]:
        size = float(row["payload_B"])
        changes |= {"payload": Payload(size, size, size, row["source"]), "kind": row["message"]}
    return replace(paper.message(row["like"]), name=row["message"], **changes)


def _with_product_timers(paper: Protocol, product: str, name: str) -> Protocol:
    """Return the paper's table with a product's schedules, lease and timers."""
    rows = [row for row in read_data("vendors/timed.csv") if row["protocol"] == name]
    return replace(
        paper,
        name=name,
        key=name,
        messages=tuple(_timed_message(row, paper) for row in rows),
        lease=defaults(product)["lease"],
        product=product,
        basis="timed",
        timers=timers(product),
    )


FAST_DDS_PERIODS = _with_product_timers(DDS, "Fast DDS", "DDS, periods of Fast DDS")
CYCLONE_DDS_PERIODS = _with_product_timers(DDS, "Cyclone DDS", "DDS, periods of Cyclone DDS")
ZENOH_PERIODS = _with_product_timers(ZENOH, "Zenoh", "Zenoh, periods of Zenoh peer")


def timed_by_product() -> dict[str, Protocol]:
    """Return these tables, each under the name of its product's table."""
    tables = (CYCLONE_DDS_PERIODS, FAST_DDS_PERIODS, ZENOH_PERIODS)
    products = {table.name.rpartition("periods of ")[2]: table for table in tables}
    return {name: replace(table, name=name) for name, table in products.items()}
