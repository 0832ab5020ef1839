"""Discovery traffic of ROS 2 middlewares on Wi-Fi: the model of the paper, executable."""

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from discostorm._numeric import lambdify
    from discostorm.capture import Capture, CaptureError as CaptureError, read_capture
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
    from discostorm.model import breakdown, utilization
    from discostorm.planner import Plan, Remedy, Share
    from discostorm.planner.plan import plan
    from discostorm.protocols import DDS, PROTOCOLS, ZENOH
    from discostorm.saturation import saturation_hosts
    from discostorm.simulation import Simulation, simulate
    from discostorm.wifi import PAPER, WIFI, Aggregation, Link, Padding, Radio, Wifi

__version__ = "0.2.0"

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

#: What each module has of these. They are loaded when they are asked for, so that the command
#: line is there to answer Ctrl-C before NumPy and SymPy are loaded.
_OF_MODULE = {
    "_numeric": "lambdify",
    "capture": "Capture CaptureError read_capture",
    "fleet": "Fleet HostGroup",
    "messages": "ENDPOINT_PAIR ONCE PAIR PROCESS Message Payload Protocol Schedule Unit",
    "planner": "Plan Remedy Share",
    "planner.plan": "plan",
    "protocols": "DDS PROTOCOLS ZENOH",
    "model": "breakdown utilization",
    "saturation": "saturation_hosts",
    "simulation": "Simulation simulate",
    "wifi": "PAPER WIFI Aggregation Link Padding Radio Wifi",
}
_MODULE_OF = {name: module for module, names in _OF_MODULE.items() for name in names.split()}

#: Modules that need not be imported by name.
_MODULES = frozenset(
    (
        "capture",
        "data",
        "figures",
        "fleet",
        "messages",
        "notation",
        "paper",
        "planner",
        "protocols",
        "model",
        "saturation",
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
    if name in _MODULE_OF:
        value = getattr(import_module(f"discostorm.{_MODULE_OF[name]}"), name)
        globals()[name] = value  # the next time it is found without this function
        return value
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted({*globals(), *_MODULE_OF, *_MODULES})
