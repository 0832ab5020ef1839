"""Discovery traffic of ROS 2 middlewares on Wi-Fi: the model of the paper, executable."""

from typing import TYPE_CHECKING, Any

from discostorm._numeric import lambdify
from discostorm.fleet import Fleet, HostGroup
from discostorm.messages import (
    ENDPOINT_PAIR,
    ONCE,
    PAIR,
    PROCESS,
    Message,
    Payload,
    Protocol,
    Schedule,
    Unit,
)
from discostorm.protocols import DDS, PROTOCOLS, ZENOH
from discostorm.scalability import breakdown, saturation_hosts, utilization
from discostorm.wifi import PAPER, WIFI, Aggregation, Link, Padding, Radio, Wifi

if TYPE_CHECKING:
    from discostorm.capture import Capture, CaptureError as CaptureError, read_capture
    from discostorm.planner import Plan, Remedy, Share, plan
    from discostorm.simulation import Simulation, simulate

__version__ = "0.1.0"

__all__ = [
    "DDS",
    "ENDPOINT_PAIR",
    "ONCE",
    "PAIR",
    "PAPER",
    "PROCESS",
    "PROTOCOLS",
    "WIFI",
    "ZENOH",
    "Aggregation",
    "Capture",
    "Fleet",
    "HostGroup",
    "Link",
    "Message",
    "Padding",
    "Payload",
    "Plan",
    "Protocol",
    "Radio",
    "Remedy",
    "Schedule",
    "Share",
    "Simulation",
    "Unit",
    "Wifi",
    "breakdown",
    "lambdify",
    "plan",
    "read_capture",
    "saturation_hosts",
    "simulate",
    "utilization",
]

#: Loaded when they are asked for, by the package that has them.
_LATER = {
    **dict.fromkeys(("Capture", "CaptureError", "read_capture"), "discostorm.capture"),
    **dict.fromkeys(("Plan", "Remedy", "Share", "plan"), "discostorm.planner"),
    **dict.fromkeys(("Simulation", "simulate"), "discostorm.simulation"),
}


#: Modules that need not be imported by name.
_MODULES = frozenset(
    (
        "capture",
        "figures",
        "notation",
        "paper",
        "planner",
        "simulation",
        "timeline",
        "uncertainty",
        "wifi",
    )
)


def __getattr__(name: str) -> Any:
    from importlib import import_module

    if name in _MODULES:
        return import_module(f"discostorm.{name}")
    if name in _LATER:
        return getattr(import_module(_LATER[name]), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
