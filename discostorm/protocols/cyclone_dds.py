"""The paper's counts of DDS with the announcements, periods and lease of Cyclone DDS."""

from dataclasses import replace

from discostorm.messages import PAIR, Message, Payload, Protocol, Schedule
from discostorm.protocols.defaults import defaults
from discostorm.protocols.paper import DDS

_VALUE = defaults("Cyclone DDS")
_LEASE = _VALUE["lease"]
_ANNOUNCEMENT = Schedule(
    (0.0, _VALUE["second_announcement"]),
    min(_VALUE["spdp_interval"], _LEASE - _VALUE["spdp_margin"]),
)
_REPLIES = Schedule(
    tuple(n * _VALUE["directed_period"] for n in range(int(_VALUE["directed_replies"])))
)
_ALIVE = Schedule((0.0,), _LEASE - _VALUE["liveliness_margin"])
_SIZE = _VALUE["liveliness_payload"]

CYCLONE_DDS = Protocol(
    "Cyclone DDS",
    (
        replace(DDS.message("SPDP"), schedule=_ANNOUNCEMENT),
        # To a participant that was not known.
        replace(
            DDS.message("SPDP"),
            name="DirectedSPDP",
            cast="unicast",
            unit=PAIR,
            schedule=_REPLIES,
            answers="SPDP",
        ),
        *DDS.of_phase("SEDP"),
        Message(
            "Liveliness",
            "Liveliness",
            "unicast",
            "UDP",
            Payload(
                _SIZE, _SIZE, _SIZE, "data/vendors/middleware_defaults.csv, liveliness_payload"
            ),
            PAIR,
            1,
            _ALIVE,
        ),
        replace(
            DDS.message("ACKNACK"),
            name="LivelinessACK",
            phase="Liveliness",
            per_unit=1,
            schedule=_ALIVE,
            answers="Liveliness",
        ),
    ),
    lease=_LEASE,
)
