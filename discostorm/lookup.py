"""Protocols and channels, given as objects or by the names that people use.

Every function that takes a protocol or a channel resolves it here, and so does the command line.
"""

from typing import TypeAlias

from discostorm import _checks, _names
from discostorm.data import read_data
from discostorm.messages import Protocol
from discostorm.protocols import PROTOCOLS
from discostorm.ros_releases import shipped_table
from discostorm.wifi import PAPER, WIFI, Radio, Wifi
from discostorm.wifi.radio import radio_named

#: A protocol, or its name such as "fastdds"; a channel, a radio, or its name.
AnyProtocol: TypeAlias = Protocol | str
AnyWifi: TypeAlias = Wifi | Radio | str


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


def as_wifi(wifi: AnyWifi) -> Wifi:
    """Return a channel as it is, or that of a radio or a name: "paper", "802.11ac 80 MHz"."""
    if isinstance(wifi, str):
        if _names.key(wifi) == "paper":
            return PAPER
        try:
            wifi = radio_named(wifi)
        except ValueError as error:
            names = ", ".join(map(repr, ("paper", *WIFI)))
            raise ValueError(f"wifi must be {names} or another radio: {error}") from error
    if isinstance(wifi, Radio):
        return wifi.wifi()
    _checks.instance("wifi", wifi, Wifi)
    return wifi
