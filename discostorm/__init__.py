"""Discovery traffic of ROS 2 middlewares on Wi-Fi: the model of the paper, executable."""

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
from discostorm.planner import Plan, Remedy, Share, plan
from discostorm.protocols import DDS, PROTOCOLS, ZENOH
from discostorm.scalability import breakdown, saturation_hosts, utilization
from discostorm.simulation import Simulation, simulate
from discostorm.wifi import PAPER, WIFI, Aggregation, Link, Padding, Radio, Wifi

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
    "saturation_hosts",
    "simulate",
    "utilization",
]
