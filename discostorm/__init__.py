"""Discovery traffic of ROS 2 middlewares on Wi-Fi: the model of the paper, executable."""

from discostorm._numeric import lambdify
from discostorm.dds import DDS
from discostorm.fleet import Fleet, HostGroup
from discostorm.messages import Message, Payload, Protocol, Unit
from discostorm.scalability import breakdown, saturation_hosts, utilization
from discostorm.wifi import PAPER, Link, Wifi
from discostorm.zenoh import ZENOH

__version__ = "0.1.0"

__all__ = [
    "DDS",
    "PAPER",
    "ZENOH",
    "Fleet",
    "HostGroup",
    "Link",
    "Message",
    "Payload",
    "Protocol",
    "Unit",
    "Wifi",
    "breakdown",
    "lambdify",
    "saturation_hosts",
    "utilization",
]
