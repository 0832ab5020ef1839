"""Protocols and channels, given as objects or by the names that people use.

Every function that takes a protocol or a channel resolves it here, and so does the command line.
"""

from typing import TypeAlias

from discostorm import _checks, _names
from discostorm.data import read_data
from discostorm.messages import Protocol
from discostorm.protocols import PROTOCOLS
from discostorm.ros_releases import shipped_table
from discostorm.wifi.radio import AnyWifi as AnyWifi, as_wifi as as_wifi

#: A protocol, or its name such as "fastdds".
AnyProtocol: TypeAlias = Protocol | str


def as_protocol(protocol: AnyProtocol, ros: str | None = None) -> Protocol:
    """Return a protocol as it is, or that of a name such as "fastdds" or "rmw_zenoh_cpp".

    The name of a product stands for the release that a ROS 2 distribution ships: the given one, or
    the newest with long-term support.
    """
    if isinstance(protocol, str):
        table = PROTOCOLS.find(protocol)
        rows = read_data("vendors/aliases.csv")
        exact = [_names.key(row["alias"]) for row in rows if row["exact"] == "yes"]
        if ros is None and _names.key(protocol) in exact:
            return table
        return PROTOCOLS[shipped_table(table.name, ros)]
    _checks.instance("protocol", protocol, Protocol)
    return protocol
