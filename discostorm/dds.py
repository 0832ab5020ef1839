"""DDS discovery as the paper counts it (Sec. III-B, equations 1 to 5)."""

from discostorm.messages import ENDPOINT_PAIR, PAIR, PROCESS, Protocol, table2

DDS = Protocol(
    "DDS",
    (
        table2("SPDP", "SPDP", "multicast", PROCESS, 1),
        table2("SEDP", "SEDP", "unicast", ENDPOINT_PAIR, 1),
        # One each way for the two built-in topics, publications and subscriptions.
        table2("Heartbeat", "SEDP", "unicast", PAIR, 2),
        table2("ACKNACK", "SEDP", "unicast", PAIR, 2),
    ),
)
