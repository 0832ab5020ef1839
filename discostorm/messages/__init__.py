"""A discovery protocol is a table of messages; its load and utilization follow from it.

`units` says what is counted, `schedule` when it is sent, `message` is a row of the table, and
`protocol` the table. `data_table` makes one of what a fleet sends besides discovery.
"""

from discostorm.messages.data_table import DATA, data_table
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
from discostorm.messages.schedule import ONCE, PAPER_WINDOW, Schedule, checked_window
from discostorm.messages.units import (
    AWAY,
    ENDPOINT,
    ENDPOINT_PAIR,
    FLEET,
    HOST,
    HOST_PAIR,
    KIND_ENDPOINT,
    MATCHED_WRITER,
    PAIR,
    PROCESS,
    UNITS,
    UNMATCHED,
    Hosts,
    OnAir,
    Unit,
)

__all__ = [
    "AWAY",
    "DATA",
    "ENDPOINT",
    "ENDPOINT_PAIR",
    "FLEET",
    "HOPS",
    "HOST",
    "HOST_PAIR",
    "KIND_ENDPOINT",
    "LEAST_PER_UNIT",
    "MATCHED_WRITER",
    "ONCE",
    "PAIR",
    "PAPER_WINDOW",
    "PROCESS",
    "UNITS",
    "UNMATCHED",
    "Basis",
    "Family",
    "Hop",
    "Hosts",
    "Message",
    "OnAir",
    "Payload",
    "Protocol",
    "Role",
    "Schedule",
    "Timers",
    "Transport",
    "Unit",
    "checked_window",
    "data_table",
    "header_bytes",
    "hop_airtime",
]
