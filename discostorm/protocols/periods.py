"""The paper's counts with the announcements, periods and leases of products.

How many messages of which size is the paper's, when they are sent the product's. What the
products themselves send is in the files of their names.
"""

from dataclasses import replace
from itertools import accumulate

from discostorm.messages import PAIR, Message, Payload, Protocol, Schedule
from discostorm.protocols.defaults import defaults, timers
from discostorm.protocols.paper import DDS, ZENOH

_FAST_VALUE = defaults("Fast DDS")
_FAST_SPDP = replace(
    DDS.message("SPDP"),
    schedule=Schedule(
        tuple(
            n * _FAST_VALUE["initial_period"]
            for n in range(int(_FAST_VALUE["initial_announcements"]) + 1)
        ),
        _FAST_VALUE["announcement_period"],
    ),
)

FAST_DDS_PERIODS = Protocol(
    "DDS, periods of Fast DDS",
    (
        _FAST_SPDP,
        # Each announcement goes to every participant that is known, too.
        replace(
            _FAST_SPDP,
            name="UnicastSPDP",
            cast="unicast",
            unit=PAIR,
            per_unit=_FAST_VALUE["unicast_copies"],
        ),
        *DDS.of_phase("SEDP"),
    ),
    lease=_FAST_VALUE["lease"],
    family="DDS",
    product="Fast DDS",
    key="DDS, periods of Fast DDS",
    basis="timed",
    timers=timers("Fast DDS"),
)

_CYCLONE_VALUE = defaults("Cyclone DDS")
_CYCLONE_LEASE = _CYCLONE_VALUE["lease"]
_CYCLONE_ANNOUNCEMENT = Schedule(
    (0.0, _CYCLONE_VALUE["second_announcement"]),
    min(_CYCLONE_VALUE["spdp_interval"], _CYCLONE_LEASE - _CYCLONE_VALUE["spdp_margin"]),
)
_CYCLONE_REPLIES = Schedule(
    tuple(
        n * _CYCLONE_VALUE["directed_period"]
        for n in range(int(_CYCLONE_VALUE["directed_replies"]))
    )
)
_CYCLONE_ALIVE = Schedule((0.0,), _CYCLONE_LEASE - _CYCLONE_VALUE["liveliness_margin"])
_CYCLONE_SIZE = _CYCLONE_VALUE["liveliness_payload"]

CYCLONE_DDS_PERIODS = Protocol(
    "DDS, periods of Cyclone DDS",
    (
        replace(DDS.message("SPDP"), schedule=_CYCLONE_ANNOUNCEMENT),
        # To a participant that was not known.
        replace(
            DDS.message("SPDP"),
            name="DirectedSPDP",
            cast="unicast",
            unit=PAIR,
            schedule=_CYCLONE_REPLIES,
            answers="SPDP",
        ),
        *DDS.of_phase("SEDP"),
        Message(
            "Liveliness",
            "Liveliness",
            "unicast",
            "UDP",
            Payload(
                _CYCLONE_SIZE,
                _CYCLONE_SIZE,
                _CYCLONE_SIZE,
                "data/vendors/middleware_defaults.csv, liveliness_payload",
            ),
            PAIR,
            1,
            _CYCLONE_ALIVE,
            role="other",
        ),
        replace(
            DDS.message("ACKNACK"),
            name="LivelinessACK",
            phase="Liveliness",
            role="other",
            per_unit=1,
            schedule=_CYCLONE_ALIVE,
            answers="Liveliness",
        ),
    ),
    lease=_CYCLONE_LEASE,
    family="DDS",
    product="Cyclone DDS",
    key="DDS, periods of Cyclone DDS",
    basis="timed",
    timers=timers("Cyclone DDS"),
)

_ZENOH_VALUE = defaults("Zenoh")


def _gaps() -> list[float]:
    """Return the times between the first Scouts [s]: each longer, up to the period."""
    gaps = [0.0, _ZENOH_VALUE["scout_first"]]
    while gaps[-1] * _ZENOH_VALUE["scout_factor"] < _ZENOH_VALUE["scout_most"]:
        gaps.append(gaps[-1] * _ZENOH_VALUE["scout_factor"])
    return gaps


_ZENOH_SCOUTING = Schedule(tuple(accumulate(_gaps())), _ZENOH_VALUE["scout_most"])
_ZENOH_KEEP_ALIVE = _ZENOH_VALUE["lease"] / _ZENOH_VALUE["keep_alives"]

ZENOH_PERIODS = Protocol(
    "Zenoh, periods of Zenoh peer",
    (
        replace(ZENOH.message("Scout"), schedule=_ZENOH_SCOUTING),
        replace(ZENOH.message("Hello"), per_unit=_ZENOH_VALUE["hellos"], schedule=_ZENOH_SCOUTING),
        ZENOH.message("Declare"),
        # One each way, the first after a period of silence.
        replace(
            ZENOH.message("KeepAlive"),
            per_unit=1,
            schedule=Schedule((_ZENOH_KEEP_ALIVE,), _ZENOH_KEEP_ALIVE),
            answers=None,
        ),
    ),
    lease=_ZENOH_VALUE["lease"],
    family="Zenoh",
    product="Zenoh",
    key="Zenoh, periods of Zenoh peer",
    basis="timed",
    timers=timers("Zenoh"),
)


def by_product() -> dict[str, Protocol]:
    """Return these tables by the name of their product's table, which they then bear.

    Examples
    --------
    >>> list(by_product())
    ['Cyclone DDS', 'Fast DDS', 'Zenoh peer']
    """
    tables = {
        "Cyclone DDS": CYCLONE_DDS_PERIODS,
        "Fast DDS": FAST_DDS_PERIODS,
        "Zenoh peer": ZENOH_PERIODS,
    }
    return {name: replace(table, name=name) for name, table in tables.items()}
