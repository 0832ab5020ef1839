"""A discovery protocol is a table of messages; its load and utilization follow from it.

`units` says what is counted, `schedule` when it is sent, `message` is a row of the table, and
`protocol` the table.
"""

from typing import TYPE_CHECKING, Any

from discostorm.messages import units
from discostorm.messages.message import (
    HOPS,
    LEAST_PER_UNIT,
    Hop,
    Message,
    Payload,
    Role,
    Transport,
    header_bytes,
    hop_airtime,
)
from discostorm.messages.protocol import Basis, Family, Protocol, Timers
from discostorm.messages.schedule import ONCE, PAPER_WINDOW, Schedule
from discostorm.messages.units import (
    AWAY,
    ENDPOINT,
    ENDPOINT_AWAY,
    ENDPOINT_HOST,
    ENDPOINT_PAIR,
    ENDPOINT_PROCESS,
    ENDPOINT_THIRD,
    FLEET,
    FLOOD,
    HOST,
    HOST_PAIR,
    KIND_ENDPOINT,
    LISTED,
    LISTED_PAIR,
    MATCHED_ENDPOINT,
    MATCHED_ENDPOINT_AWAY,
    MATCHED_HOST,
    MATCHED_PAIR,
    MATCHED_PROCESS_PAIR,
    MATCHED_PROCESS_PAIR_AWAY,
    MATCHED_WRITER,
    PAIR,
    PROCESS,
    PROCESS_HOST,
    PROCESS_PAIR,
    THIRD,
    UNITS,
    UNMATCHED,
    UNMATCHED_ENDPOINT,
    UNMATCHED_HOST,
    WRITER,
    OfProcesses,
    Unit,
)

__all__ = [
    "AWAY",
    "ENDPOINT",
    "ENDPOINT_AWAY",
    "ENDPOINT_HOST",
    "ENDPOINT_PAIR",
    "ENDPOINT_PROCESS",
    "ENDPOINT_THIRD",
    "FLEET",
    "FLOOD",
    "HOPS",
    "HOST",
    "HOST_PAIR",
    "KIND_ENDPOINT",
    "LEAST_PER_UNIT",
    "LISTED",
    "LISTED_PAIR",
    "MATCHED_ENDPOINT",
    "MATCHED_ENDPOINT_AWAY",
    "MATCHED_HOST",
    "MATCHED_PAIR",
    "MATCHED_PROCESS_PAIR",
    "MATCHED_PROCESS_PAIR_AWAY",
    "MATCHED_WRITER",
    "ONCE",
    "PAIR",
    "PAPER_WINDOW",
    "PROCESS",
    "PROCESS_HOST",
    "PROCESS_PAIR",
    "THIRD",
    "UNITS",
    "UNMATCHED",
    "UNMATCHED_ENDPOINT",
    "UNMATCHED_HOST",
    "WRITER",
    "Basis",
    "Family",
    "Hop",
    "Message",
    "OfProcesses",
    "Payload",
    "Protocol",
    "Role",
    "Schedule",
    "Timers",
    "Transport",
    "Unit",
    "header_bytes",
    "hop_airtime",
]


if not TYPE_CHECKING:

    def __getattr__(name: str) -> Any:
        # What was pickled when this was one module names the functions of its units here.
        return getattr(units, name)
