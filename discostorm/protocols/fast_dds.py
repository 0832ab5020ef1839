"""The paper's counts of DDS with the announcements, periods and lease of Fast DDS."""

from dataclasses import replace

from discostorm.messages import PAIR, Protocol, Schedule
from discostorm.protocols.defaults import defaults
from discostorm.protocols.paper import DDS

_VALUE = defaults("Fast DDS")
_SPDP = replace(
    DDS.message("SPDP"),
    schedule=Schedule(
        tuple(
            n * _VALUE["initial_period"] for n in range(int(_VALUE["initial_announcements"]) + 1)
        ),
        _VALUE["announcement_period"],
    ),
)

FAST_DDS = Protocol(
    "Fast DDS",
    (
        _SPDP,
        # Each announcement goes to every participant that is known, too.
        replace(
            _SPDP,
            name="UnicastSPDP",
            cast="unicast",
            unit=PAIR,
            per_unit=_VALUE["unicast_copies"],
        ),
        *DDS.of_phase("SEDP"),
    ),
    lease=_VALUE["lease"],
)
