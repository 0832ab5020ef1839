"""Samples of user data, robots that send samples, and a fleet file without topics."""

from typing import Any

import discostorm as ds
from discostorm.flows import Flow

HEADERS = 24 + 4 + 8 + 20  # octets around IP's data: MAC, FCS, LLC and SNAP, IPv4
CYCLONE, FAST, ZENOH = "Cyclone DDS", "Fast DDS", "Zenoh"


def sample(octets: float, reliable: bool = False, to: Any = "all others") -> Flow:
    return Flow("own", to, rate=10, bytes=octets, reliable=reliable)


def fleet(*flows: Flow, hosts: float = 3, **others: Any) -> ds.Fleet:
    robots = ds.HostGroup(hosts, 2, 10, "robots", data=flows)
    return ds.Fleet((robots, *others.values()))


FILE = """
[[groups]]
name = "robots"
hosts = 3
processes = 2
endpoints = 40
"""


def read(text: str) -> ds.Fleet:
    return ds.Fleet.from_bytes((FILE + text).encode(), "fleet.toml")
