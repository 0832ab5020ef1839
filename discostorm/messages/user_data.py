"""The table of a fleet's user data: rows for the frames of samples, as a product sends them.

``data/vendors/data_framing.csv`` says how a sample becomes datagrams, or a batch of Zenoh segments.
These become frames by IP's fragments and TCP's segments on a link that carries 1500 octets.
Each topic has a row of full frames, one of the others, with their mean length, and one of answers.
"""

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from math import ceil

from discostorm.data import read_data
from discostorm.fleet import Fleet
from discostorm.flows import Flow
from discostorm.messages.message import HOPS, Hop, Message, Payload, Transport, header_bytes
from discostorm.messages.protocol import Protocol
from discostorm.messages.schedule import Schedule
from discostorm.messages.units import Unit

#: The phase of all user data.
DATA = "data"
#: Maximum IP payload of a frame [B]: 1500 without the IP header (RFC 894, RFC 791).
IP_DATA = 1480
#: Headers besides IP's: in the first frame of a datagram, and in each frame of a TCP segment [B].
UDP_HEADER, TCP_HEADER = 8, 20
#: Octets in a TCP header of Linux beyond 20: timestamps (RFC 7323, 3), padded.
TCP_OPTIONS = 12
#: At least each second full segment is acknowledged (RFC 5681, 4.2).
SEGMENTS_PER_ACK = 2


@dataclass(frozen=True)
class Framing:
    """Sizes with which a product frames samples in datagrams or segments [B]; see the data file.

    ``answered`` is the number of reliable samples, sent whole, per answer [1].
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
    """Return the framing of the first of these products or families in the data file."""
    parts: dict[str | None, dict[str, int]] = {}
    for row in read_data("vendors/data_framing.csv"):
        for product in row["of"].split(", "):
            parts.setdefault(product, {})[row["part"]] = int(row["value"])
    sizes = next(parts[name] for name in names if name in parts)
    transport: Transport = "UDP" if sizes["acknowledgement"] else "TCP"
    return Framing(transport, **sizes)


def datagram_sizes(flow: Flow, how: Framing) -> list[int]:
    """Return the sizes of the UDP datagrams, or batches in TCP's stream, of a sample [B]."""
    size = ceil(flow.bytes) + how.encapsulation
    heartbeat = how.heartbeat if flow.reliable else 0
    if size <= how.most_whole:
        return [how.message + how.timestamp + how.whole + size + heartbeat]
    fragments = -(-size // how.chunk)
    header = how.message + how.fragment
    between = how.heartbeat_fragment if flow.reliable else 0
    sizes = [header + how.chunk + between] * (fragments - 1)
    sizes.append(header + size - (fragments - 1) * how.chunk + heartbeat)
    sizes[0] += how.timestamp
    return sizes


def frames(flow: Flow, how: Framing) -> Counter[int]:
    """Count the frames of one sample by their IP payload [B]."""
    sizes = datagram_sizes(flow, how)
    packets, header = [UDP_HEADER + size for size in sizes], 0
    if how.transport == "TCP":
        packets, header = [sum(sizes)], TCP_HEADER + TCP_OPTIONS
    room = IP_DATA - header
    counts: Counter[int] = Counter()
    for size in packets:
        counts[IP_DATA] += size // room
        counts[size % room + header] += size % room > 0
    return +counts


def acknowledgement_frames(flow: Flow, how: Framing) -> tuple[float, int]:
    """Return the number of frames that acknowledge a sample [1], and their IP data [B]."""
    if how.transport == "TCP":
        return -(-sum(frames(flow, how).values()) // SEGMENTS_PER_ACK), TCP_HEADER + TCP_OPTIONS
    per_sample = 1 / how.answered if len(datagram_sizes(flow, how)) == 1 else 1.0
    return per_sample * flow.reliable, UDP_HEADER + how.acknowledgement


def user_data_protocol(protocol: Protocol, fleet: Fleet) -> Protocol | None:
    """Return the table of a fleet's user data; None without any.

    Data are framed as the protocol's product does, else as its family does, else as DDS does.
    """
    how = framing(protocol.product, protocol.family, "DDS")
    rows = [
        row
        for index, group in enumerate(fleet.groups)
        for flow in group.data
        for row in _topic_rows(flow, how, fleet, index)
    ]
    name = f"data beside {protocol.name}"
    return Protocol(name, tuple(rows)) if rows else None


def _topic_rows(flow: Flow, how: Framing, fleet: Fleet, index: int) -> Iterator[Message]:
    """Yield the rows of a topic of a group; none where no reader is on another host."""
    others = float(fleet.hosts()) - 1
    to_wired = flow.to == "wired host"
    if fleet.groups[index].wired if to_wired else others <= 0:
        return
    multicast = flow.to == "multicast" and how.transport == "UDP"
    once = to_wired or multicast
    unit = Unit("host", "all" if once else "other host", group=index)
    name = f"{flow.topic} of {fleet.names[index]}"

    def row(what: str, count: float, ip_data: float, hops: tuple[Hop, ...]) -> Message:
        headers = header_bytes()[how.transport] - header_bytes()["UDP"] + UDP_HEADER
        size = max(0.0, count * (ip_data - headers))
        return Message(
            name=f"{name}, {what}",
            phase=DATA,
            cast="multicast" if multicast else "unicast",
            transport=how.transport,
            payload=Payload(size, size, size, "data/vendors/data_framing.csv and the fleet"),
            unit=unit,
            per_unit=1 / others if flow.to == "one host" else 1.0,
            schedule=Schedule((1 / flow.rate,), 1 / flow.rate),
            hops=hops,
            frames=float(count),
            role="other",
        )

    forth, back = (("up",), ("down",)) if to_wired else (HOPS, HOPS)
    sizes = frames(flow, how)
    if full := sizes.pop(IP_DATA, 0):
        yield row("full frames", full, IP_DATA, forth)
    if rest := sum(sizes.values()):
        mean = sum(size * count for size, count in sizes.items()) / rest
        yield row("last frames", rest, mean, forth)
    count, ip_data = acknowledgement_frames(flow, how)
    if count:
        yield row("answers", count, ip_data, back)
