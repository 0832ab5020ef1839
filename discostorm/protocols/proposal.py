"""Our proposed discovery: one speaker per host, packed multicast announcements, coded repair.

Not a product. ``data/hybrid/messages.csv`` has what is sent without losses; the lab's prototype has
rules for losses, failures and late joiners. The contents of a frame have separate rows, which cost
only their bytes. Heartbeats are as often as rows say up to 100 hosts; of more hosts the period
grows, so the table is an upper bound. A set counts as one frame: a lower bound if it needs more.
"""

from collections.abc import Iterator
from typing import Any

from discostorm.data import read_data
from discostorm.messages import Protocol, Timers
from discostorm.protocols.measured_tables import messages_from_rows

_PARAMETERS = {row["quantity"]: float(row["value"]) for row in read_data("hybrid/parameters.csv")}


def _message_rows(name: str) -> Iterator[dict[str, Any]]:
    """Yield the rows of a table, with values in place of the names of quantities."""
    for row in read_data("hybrid/messages.csv"):
        if row["protocol"] == name:
            size, interval = _PARAMETERS[row["quantity"]], row["interval"]
            yield (
                row
                | dict.fromkeys(("payload_B", "low_B", "high_B"), size)
                | {
                    "cast": "multicast",
                    "transport": "UDP",
                    "per_unit": 1,
                    "starts_s": str(_PARAMETERS[interval]) if interval else "0",
                    "period_s": _PARAMETERS.get(interval),
                    "frames": 0 if row["inside"] else 1,
                    "source": f"data/hybrid/parameters.csv, {row['quantity']}",
                }
            )


def _table(name: str) -> Protocol:
    return Protocol(
        name,
        messages_from_rows(_message_rows(name)),
        lease=_PARAMETERS["lease"],
        key=name,
        basis="proposal",
        # A Heartbeat shows which sets a speaker lacks; others send these sets again.
        timers=Timers(_PARAMETERS["heartbeat"], _PARAMETERS["heartbeat"]),
    )


HYBRID = _table("hybrid")
HYBRID_ALIKE = _table("hybrid, alike")
