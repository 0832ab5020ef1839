"""Zenoh discovery in pure peer mode as the paper counts it (Sec. III-C, equations 6 to 10)."""

from discostorm.messages import ENDPOINT_PAIR, PAIR, PROCESS, Protocol, table2

ZENOH = Protocol(
    "Zenoh",
    (
        table2("Scout", "Scouting", "multicast", PROCESS, 1),
        table2("Hello", "Scouting", "unicast", PAIR, 1),
        table2("Declare", "Declaration", "unicast", ENDPOINT_PAIR, 1),
        table2("KeepAlive", "Declaration", "unicast", PAIR, 2),
    ),
)
