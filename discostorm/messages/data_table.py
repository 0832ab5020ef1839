"""The table of a fleet's user data: rows for the frames of samples, as a product sends them.

How a sample becomes datagrams, or a batch of Zenoh segments, is ``data/vendors/data_framing.csv``;
how these become frames are IP's fragments and TCP's segments on a link that carries 1500 octets.
Each topic has a row of frames that are full, one of those that are not, with their mean length, and
one of what answers. All are sent with their rate; none belongs to the burst.
"""

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from math import ceil

from discostorm.data import read_data
from discostorm.fleet import Fleet
from discostorm.flows import Flow
from discostorm.messages.message import Hop, Message, Payload, Transport, header_bytes
from discostorm.messages.protocol import Protocol
from discostorm.messages.schedule import Schedule
from discostorm.messages.units import Unit

#: The phase of all user data.
DATA = "data"
#: What a frame carries of an IP packet's data [B]: 1500 without IP's header (RFC 894, RFC 791).
IP_DATA = 1480
#: Headers in the first frame of a datagram, and in each of a TCP segment, beyond IP's [B].
UDP_HEADER, TCP_HEADER = 8, 20
#: Octets in a TCP header of Linux beyond 20: timestamps (RFC 7323, 3), padded.
TCP_OPTIONS = 12
#: At least each second full segment is acknowledged (RFC 5681, 4.2).
SEGMENTS_PER_ACK = 2


@dataclass(frozen=True)
class Framing:
    """How a product puts samples into datagrams or segments [B]; see its data file.

    ``answered`` is for how many reliable samples that are sent whole there is an answer [1].
    """

    transport: Transport
    message: int
    timestamp: int
    whole: int
    fragment: int
    encapsulation: int
    most_whole: int
    chunk: int
    heartbeat: int
    heartbeat_fragment: int
    acknowledgement: int
    answered: int


@cache
def framing(*names: str | None) -> Framing:
    """Return the framing of the first of these products or families of which it is known."""
    of = {
        name: row["of"]
        for row in read_data("vendors/data_framing.csv")
        for name in row["of"].split(", ")
    }
    known = next(of[name] for name in names if name in of)
    sizes = {
        row["part"]: int(row["value"])
        for row in read_data("vendors/data_framing.csv")
        if row["of"] == known
    }
    transport: Transport = "UDP" if sizes["acknowledgement"] else "TCP"
    return Framing(transport, **sizes)


def datagrams(flow: Flow, how: Framing) -> list[int]:
    """Return the data of UDP datagrams, or of batches in TCP's stream, that carry a sample [B]."""
    size = ceil(flow.bytes) + how.encapsulation
    last = how.heartbeat if flow.reliable else 0
    if size <= how.most_whole:
        return [how.message + how.timestamp + how.whole + size + last]
    many = -(-size // how.chunk)
    each = how.message + how.fragment
    between = how.heartbeat_fragment if flow.reliable else 0
    found = [each + how.chunk + between] * (many - 1)
    found.append(each + size - (many - 1) * how.chunk + last)
    found[0] += how.timestamp
    return found


def frames(flow: Flow, how: Framing) -> Counter[int]:
    """Return how many frames carry so much of IP's data each, for one sample."""
    if how.transport == "UDP":
        packets = [UDP_HEADER + size for size in datagrams(flow, how)]
        most, each = IP_DATA, 0
    else:
        packets = [sum(datagrams(flow, how))]
        most, each = IP_DATA - TCP_HEADER - TCP_OPTIONS, TCP_HEADER + TCP_OPTIONS
    found: Counter[int] = Counter()
    for size in packets:
        found[most + each] += size // most
        found[size % most + each] += size % most > 0
    return +found


def answers(flow: Flow, how: Framing) -> tuple[float, int]:
    """Return how many frames answer a sample [1], and how much of IP's data each has [B]."""
    if how.transport == "TCP":
        return -(-sum(frames(flow, how).values()) // SEGMENTS_PER_ACK), TCP_HEADER + TCP_OPTIONS
    many = 1 / how.answered if len(datagrams(flow, how)) == 1 else 1.0
    return many * flow.reliable, UDP_HEADER + how.acknowledgement


def data_table(protocol: Protocol, fleet: Fleet) -> Protocol | None:
    """Return the rows of what a fleet sends besides discovery, None if that is nothing.

    Data are framed as the protocol's product does or, of one that is not known, as its family
    does; a protocol of no family, which says nothing of data, leaves them to DDS.
    """
    if not fleet.has_data:
        return None
    how = framing(protocol.product, protocol.family, "DDS")
    rows = [
        row
        for index, group in enumerate(fleet.groups)
        for flow in group.data
        for row in _rows(flow, how, fleet, index)
    ]
    name = f"data beside {protocol.name}"
    return Protocol(name, tuple(rows)) if rows else None


def _rows(flow: Flow, how: Framing, fleet: Fleet, index: int) -> Iterator[Message]:
    """Yield the rows of a topic of a group; none where no reader is on another host."""
    group, others = fleet.groups[index], float(fleet.hosts()) - 1
    hops: tuple[Hop, ...] = ("up", "down")
    multicast = flow.to == "multicast" and how.transport == "UDP"
    unit, per_unit = Unit("host", "other host", group=index), 1.0
    if flow.to == "wired host":
        if group.wired:
            return
        hops, unit = ("up",), Unit("host", group=index)
    elif others <= 0:
        return
    elif flow.to == "one host":
        per_unit = 1 / others
    elif multicast:
        unit = Unit("host", group=index)
    name = f"{flow.topic} of {fleet.names[index]}"

    def row(what: str, many: float, data: float, back: bool = False) -> Message:
        headers = header_bytes()[how.transport] - header_bytes()["UDP"] + UDP_HEADER
        size = max(0.0, many * (data - headers))
        return Message(
            name=f"{name}, {what}",
            phase=DATA,
            cast="multicast" if multicast else "unicast",
            transport=how.transport,
            payload=Payload(size, size, size, "data/vendors/data_framing.csv and the fleet"),
            unit=unit,
            per_unit=per_unit,
            schedule=Schedule((1 / flow.rate,), 1 / flow.rate),
            hops=("down",) if back and hops == ("up",) else hops,
            frames=float(many),
            role="other",
        )

    sizes = frames(flow, how)
    full = sizes.pop(IP_DATA, 0)
    if full:
        yield row("full frames", full, IP_DATA)
    if rest := sum(sizes.values()):
        mean = sum(size * many for size, many in sizes.items()) / rest
        yield row("last frames", rest, mean)
    many, data = answers(flow, how)
    if many:
        yield row("answers", many, data, back=True)
