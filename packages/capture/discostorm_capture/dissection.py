"""What dissecting RTPS and Zenoh yields: messages, processes, endpoints; helpers for tables."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from operator import itemgetter
from typing import Any

import numpy as np

from discostorm.files import json_ready
from discostorm_capture._types import Array, Columns, DataFrame
from discostorm_capture.endpoints import Endpoint

RTPS, ZENOH, TCP = range(3)
PROTOCOLS = ("RTPS", "Zenoh", "TCP")
#: The columns of messages, by type. A missing process is -1, any other missing value 0.
_COLUMNS_BY_TYPE: dict[Any, str] = {
    np.int32: "frame size number bytes process peer source target",
    np.uint8: "protocol submessage entity direction",
    np.uint16: "kind",
    np.uint32: "reader writer",
    np.int16: "missing",
    bool: "udp ends holes",
    np.float32: "frames",
}


@dataclass(frozen=True)
class Process:
    """A process that speaks RTPS or Zenoh; addresses are ids."""

    protocol: int
    name: str
    product: str
    #: Its address, and the first frame that shows it; -1 if unknown.
    host: int
    first_frame: int
    endpoints: int
    #: Whether it announced anything; `is_server`: whether it is a Discovery Server or Zenoh router.
    announced_anything: bool
    is_server: bool = False
    domain: int = -1
    announced_addresses: tuple[int, ...] = ()
    #: Whether `endpoints` includes publishers, which plain Zenoh does not announce.
    counts_publishers: bool = True
    #: Announced lease duration [s], NaN if unknown; domain tag; whether it has DDS Security
    #: credentials, and knows endpoints of others from a file (static discovery of Fast DDS).
    lease: float = float("nan")
    domain_tag: str = ""
    has_credentials: bool = False
    static: bool = False
    #: Whether it announces only its writers, or only its readers.
    is_half: bool = False
    #: The version of Zenoh's protocol; 0 if unknown.
    version: int = 0


@dataclass(frozen=True)
class Recording:
    """How a capture was recorded: what it lacks, and steps of its clock."""

    #: Share of packets truncated by the snaplen [1].
    truncated_share: float
    #: Steps of the clock: the frame after the step, and its size [s].
    clock_steps: tuple[tuple[int, float], ...]
    #: Time of the first packet in the file after the earliest, and from first to last [s].
    first_packet_time: float
    recorded_time: float
    #: Number of packets without a message: "ARP", "TCP", "UDP" and "other".
    packets_without_messages: dict[str, int]
    #: Text on each kind of data that the file itself shows to be missing.
    gaps: tuple[str, ...]
    #: Share of multicast messages that are duplicates [1].
    duplicate_multicast_share: float = 0.0


#: The sequence number of each announced endpoint, and the endpoint, None if unreadable, by process
#: name and entity id.
Endpoints = dict[tuple[str, int], tuple[int, Endpoint | None]]


@dataclass(frozen=True)
class Dissection:
    """The messages of a protocol, a `message_table`, and its processes by id."""

    messages: Columns
    processes: dict[int, Process]
    endpoints: Endpoints = field(default_factory=dict)
    #: Packets of samples with a time stamp in their content, with its seconds as ``to_port``.
    time_stamps: Columns = field(default_factory=dict)


def message_table(packets: Columns, rows: Array, protocol: int, kind: Array, **own: Any) -> Columns:
    """Return a table of messages; `rows` are the packets that completed them."""
    packet = packets.keys() & {"frame", "source", "target", "direction", "process", "peer"}
    table: dict[str, Array | int] = {"peer": -1} | {name: packets[name][rows] for name in packet}
    table |= {"protocol": protocol, "kind": kind, "submessage": kind, **own}
    return {
        name: np.broadcast_to(table.get(name, 0), len(rows)).astype(dtype)
        for dtype, names in _COLUMNS_BY_TYPE.items()
        for name in names.split()
    }


def first_seen(
    sightings: Iterable[tuple[int, int, int]], loopback: Array
) -> dict[int, tuple[int, int]]:
    """Return host (a loopback address only if no other is seen) and first frame per process."""
    first: dict[int, tuple[int, int]] = {}
    for frame, process, source in sorted(sightings, key=itemgetter(0)):
        host, since = first.get(process, (source, frame))
        first[process] = (source if loopback[host] else host), since
    return first


def json_rows(table: DataFrame) -> list[dict[str, Any]]:
    """Return the rows of a table with values that JSON can hold."""
    rows: list[dict[str, Any]] = json_ready(table.astype(object).to_dict("records"))
    return rows


def categorical(numbers: Array, names: Sequence[str]) -> Any:
    """Return a categorical of names by index, -1 for the last; drop unused names."""
    import pandas as pd

    dtype, number_of = _categorical_type(tuple(names))
    return pd.Categorical.from_codes(number_of[numbers], dtype=dtype).remove_unused_categories()


@lru_cache(maxsize=16)
def _categorical_type(names: tuple[str, ...]) -> tuple[Any, Array]:
    """Return a type with each name once, and the category index of each given name."""
    import pandas as pd

    index = {name: index for index, name in enumerate(dict.fromkeys(names))}
    return pd.CategoricalDtype([*index]), np.array([index[name] for name in names], np.int32)
