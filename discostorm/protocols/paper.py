"""DDS and Zenoh discovery as the paper counts them (Sec. III, equations 1 to 10)."""

from discostorm.data import read_data
from discostorm.messages import (
    ENDPOINT_PAIR,
    PAIR,
    PROCESS,
    Message,
    Payload,
    Protocol,
    Transport,
    Unit,
)
from discostorm.wifi import Cast


def table2(
    name: str,
    phase: str,
    cast: Cast,
    unit: Unit,
    per_unit: float,
    answers: str | None = None,
) -> Message:
    """Return the message of that name with its size and transport from the paper's Table II."""
    (row,) = (row for row in read_data("paper/table2.csv") if row["message"] == name)
    payload = Payload(
        float(row["payload_B"]), float(row["low_B"]), float(row["high_B"]), row["source"]
    )
    transport: Transport = "TCP" if row["transport"] == "TCP" else "UDP"
    return Message(name, phase, cast, transport, payload, unit, per_unit, answers=answers)


DDS = Protocol(
    "DDS",
    (
        table2("SPDP", "SPDP", "multicast", PROCESS, 1),
        table2("SEDP", "SEDP", "unicast", ENDPOINT_PAIR, 1, "SPDP"),
        # One each way for the two built-in topics, publications and subscriptions.
        table2("Heartbeat", "SEDP", "unicast", PAIR, 2, "SPDP"),
        table2("ACKNACK", "SEDP", "unicast", PAIR, 2, "Heartbeat"),
    ),
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
)
