"""Protocols and channels, given as objects or by the names that people use.

Every function that takes a protocol or a channel resolves it here, and so does the command line.
"""

from dataclasses import replace
from typing import TypeAlias

from discostorm import _checks, _names
from discostorm.data import read_data
from discostorm.messages import UNITS, Protocol
from discostorm.messages.legs import has_server
from discostorm.protocols import PROTOCOLS
from discostorm.ros_releases import forwarding_release, shipped_table
from discostorm.wifi.radio import AnyWifi as AnyWifi, as_wifi as as_wifi

#: A protocol, or its name such as "fastdds".
AnyProtocol: TypeAlias = Protocol | str
#: Units of messages that a server forwards on a match, with those if it forwards everything.
_FORWARDED = {
    UNITS["ordered pair of matched processes"]: UNITS["ordered pair of processes"],
    UNITS["matched endpoint and other process"]: UNITS["endpoint and other process"],
}


def as_protocol(protocol: AnyProtocol, ros: str | None = None) -> Protocol:
    """Return a given protocol, or the protocol of a name such as "fastdds" or "rmw_zenoh_cpp".

    The name of a product stands for the release that a ROS 2 distribution ships: the given one, or
    the newest with long-term support. So does that of its configuration with a server.
    """
    if isinstance(protocol, str):
        table = PROTOCOLS.find(protocol)
        rows = read_data("vendors/aliases.csv")
        exact = [_names.normalize(row["alias"]) for row in rows if row["exact"] == "yes"]
        if ros is None and _names.normalize(protocol) in exact:
            return table
        table = PROTOCOLS[shipped_table(table.name, ros)]
        if has_server(table) and table.family == "DDS":
            table = with_timers_of(table, PROTOCOLS[shipped_table(str(table.product), ros)])
        release, forwarding = forwarding_release(table.product or "", ros), forward_to_all(table)
        if not release or forwarding == table:
            return table
        name = table.name.replace(str(table.product), release)
        return replace(forwarding, name=name, key=table.key)
    _checks.instance("protocol", protocol, Protocol)
    return protocol


def with_timers_of(table: Protocol, release: Protocol) -> Protocol:
    """Return a server's table with the timers of the release of its clients."""
    repairs = release.timers is not None and release.timers.nack_response_delay > 0
    if not repairs or table.timers == release.timers or not has_server(table):
        return table
    return replace(table, timers=release.timers)


def forward_to_all(table: Protocol) -> Protocol:
    """Return a table whose server forwards everything, also where no endpoint matches."""
    of_all = table.messages
    messages = tuple(replace(each, unit=_FORWARDED.get(each.unit, each.unit)) for each in of_all)
    return table if messages == table.messages else replace(table, messages=messages, key=None)
