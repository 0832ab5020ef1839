"""The paper's counts of Zenoh peers with the scouting, keep-alives and lease of Zenoh."""

from dataclasses import replace
from itertools import accumulate

from discostorm.messages import Protocol, Schedule
from discostorm.protocols.defaults import defaults
from discostorm.protocols.paper import ZENOH

_VALUE = defaults("Zenoh")


def _gaps() -> list[float]:
    """Return the times between the first Scouts [s]: each longer, up to the period."""
    gaps = [0.0, _VALUE["scout_first"]]
    while gaps[-1] * _VALUE["scout_factor"] < _VALUE["scout_most"]:
        gaps.append(gaps[-1] * _VALUE["scout_factor"])
    return gaps


_SCOUTING = Schedule(tuple(accumulate(_gaps())), _VALUE["scout_most"])
_KEEP_ALIVE = _VALUE["lease"] / _VALUE["keep_alives"]

ZENOH_PEER = Protocol(
    "Zenoh peer",
    (
        replace(ZENOH.message("Scout"), schedule=_SCOUTING),
        replace(ZENOH.message("Hello"), per_unit=_VALUE["hellos"], schedule=_SCOUTING),
        ZENOH.message("Declare"),
        # One each way, the first after a period of silence.
        replace(
            ZENOH.message("KeepAlive"),
            per_unit=1,
            schedule=Schedule((_KEEP_ALIVE,), _KEEP_ALIVE),
            answers=None,
        ),
    ),
    lease=_VALUE["lease"],
)
