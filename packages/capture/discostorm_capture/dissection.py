"""The tables that all protocols fill: messages by number and processes by name."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from operator import itemgetter
from typing import TYPE_CHECKING, Any

import numpy as np

from discostorm_capture._types import Array, Columns
from discostorm_capture.endpoints import Endpoint

if TYPE_CHECKING:
    import pandas as pd

RTPS, ZENOH, TCP = range(3)
PROTOCOLS = ("RTPS", "Zenoh", "TCP")
#: The columns of messages by their type. Where a protocol has no value, processes are -1, others 0.
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
    """A process of RTPS or Zenoh; addresses are numbers."""

    protocol: int
    name: str
    product: str
    #: Its address, and the frame that shows it first; -1 if unknown.
    host: int
    first_frame: int
    endpoints: int
    #: Whether it announced anything, and whether it is a server or router of others.
    announced_anything: bool
    is_server: bool = False
    domain: int = -1
    announced_addresses: tuple[int, ...] = ()
    #: Whether its endpoints include publishers.
    counts_publishers: bool = True
    #: What it says: how long others keep it after it fell silent [s], its domain tag, and whether
    #: it has credentials of DDS Security.
    lease: float = float("inf")
    domain_tag: str = ""
    has_credentials: bool = False


@dataclass(frozen=True)
class RecordingQuality:
    """How a capture was recorded: what it lacks, and its clock."""

    #: The share of packets that were cut when they were captured [1].
    truncated_share: float
    #: Where the clock was set: the frame, and by how much [s].
    clock_steps: tuple[tuple[int, float], ...]
    #: From the earliest packet to the first in the file, and from there to the last [s].
    first_packet_time: float
    recorded_time: float
    #: Packets without a message: of "ARP", "TCP", "UDP" and "other".
    packets_without_messages: dict[str, int]
    #: What the capture itself says that it lacks, in words.
    gaps: tuple[str, ...]
    #: The share of multicast messages that the capture had shown before [1].
    duplicate_multicast_share: float = 0.0


@dataclass(frozen=True)
class Dissection:
    """The messages of a protocol as `message_table`, and by their numbers the processes."""

    messages: Columns
    processes: dict[int, Process]
    #: The endpoints that are announced, by name of the process and entity, each with the sequence
    #: number of its announcement; None if unreadable.
    endpoints: dict[tuple[str, int], tuple[int, Endpoint | None]] = field(default_factory=dict)


def message_table(packets: Columns, rows: Array, **columns: Array | int) -> Columns:
    """Return a table of messages, each of which a row of packets completed."""
    packet = ("frame", "source", "target", "direction")
    table: dict[str, Array | int] = {name: packets[name][rows] for name in packet}
    table |= {"submessage": columns["kind"], "peer": -1} | columns
    return {
        name: np.broadcast_to(table.get(name, 0), len(rows)).astype(dtype)
        for dtype, names in _COLUMNS_BY_TYPE.items()
        for name in names.split()
    }


def first_seen(
    sightings: Iterable[tuple[int, int, int]], loopback: Array
) -> dict[int, tuple[int, int]]:
    """Return the host, no loopback if it can be, and first frame of each sighted process."""
    first: dict[int, tuple[int, int]] = {}
    for frame, process, source in sorted(sightings, key=itemgetter(0)):
        host, since = first.get(process, (source, frame))
        first[process] = (source if loopback[host] else host), since
    return first


def finite_or_none(value: Any) -> Any:
    """Return a value; None for a number that JSON cannot hold."""
    return value if not isinstance(value, float) or np.isfinite(value) else None


def json_rows(table: pd.DataFrame) -> list[dict[str, Any]]:
    """Return the rows of a table as JSON can hold them."""
    rows = table.astype(object).to_dict("records")
    return [{str(key): finite_or_none(value) for key, value in row.items()} for row in rows]


def to_categorical(numbers: Array, names: Sequence[str]) -> Any:
    """Return names by their numbers, -1 for the last; only used names remain."""
    import pandas as pd

    dtype, number_of = _categorical_type(tuple(names))
    return pd.Categorical.from_codes(number_of[numbers], dtype=dtype).remove_unused_categories()


@lru_cache(maxsize=16)
def _categorical_type(names: tuple[str, ...]) -> tuple[pd.CategoricalDtype, Array]:
    """Return each name once, and the number among these of each given name."""
    import pandas as pd

    index = {name: index for index, name in enumerate(dict.fromkeys(names))}
    return pd.CategoricalDtype([*index]), np.array([index[name] for name in names], np.int32)
