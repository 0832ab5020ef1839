"""DDS and Zenoh discovery as the paper counts them (Sec. III, equations 1 to 10).

For simulated recovery they have the timers of Fast DDS and of Zenoh, as the paper names none.
"""

from typing import cast as typed

from discostorm.data import read_data
from discostorm.messages import (
    ENDPOINT_PAIR,
    PAIR,
    PROCESS,
    Message,
    Payload,
    Protocol,
    Role,
    Transport,
    Unit,
)
from discostorm.protocols.defaults import timers
from discostorm.wifi import Cast


def table2(
    name: str,
    phase: str,
    cast: Cast,
    unit: Unit,
    per_unit: float,
    answers: str | None = None,
) -> Message:
    """Return a message of the paper's Table II; the data file has its size, transport and role."""
    (row,) = (row for row in read_data("paper/table2.csv") if row["message"] == name)
    payload = Payload(
        float(row["payload_B"]), float(row["low_B"]), float(row["high_B"]), row["source"]
    )
    return Message(
        name,
        phase,
        cast,
        typed(Transport, row["transport"]),
        payload,
        unit,
        per_unit,
        answers=answers,
        role=typed(Role, row["role"]),
        informs=row["informs"] == "yes",
    )


DDS = Protocol(
    "DDS",
    (
        table2("SPDP", "SPDP", "multicast", PROCESS, 1),
        table2("SEDP", "SEDP", "unicast", ENDPOINT_PAIR, 1, "SPDP"),
        # One each way for the two built-in topics, publications and subscriptions.
        table2("Heartbeat", "SEDP", "unicast", PAIR, 2, "SPDP"),
        table2("ACKNACK", "SEDP", "unicast", PAIR, 2, "Heartbeat"),
    ),
    family="DDS",
    basis="paper",
    timers=timers("Fast DDS"),
    key="DDS",
)

#: In pure peer mode.
ZENOH = Protocol(
    "Zenoh",
    (
        table2("Scout", "Scouting", "multicast", PROCESS, 1),
        table2("Hello", "Scouting", "unicast", PAIR, 1, "Scout"),
        table2("Declare", "Declaration", "unicast", ENDPOINT_PAIR, 1, "Hello"),
        table2("KeepAlive", "Declaration", "unicast", PAIR, 2, "Hello"),
    ),
    family="Zenoh",
    basis="paper",
    timers=timers("Zenoh"),
    key="Zenoh",
)
