"""What is no discovery, and tells why it fails: ARP, ICMP, connections that nobody takes."""

import numpy as np

from discostorm_capture import tcp
from discostorm_capture._bytes import Array, Bytes, Columns, Numbers, codes, number, stack, take
from discostorm_capture.link import LINKS

#: What an aside is about.
KINDS = (
    *("ARP request", "ARP reply", "unreachable"),
    *("connection", "refused", "unanswered", "half", "exchange"),
)
_REQUEST, _REPLY, UNREACHABLE, TAKEN, REFUSED, UNANSWERED, HALF, EXCHANGE = range(8)
LAST_OF_ARP = _REPLY
#: Where the type of a frame stands, by link type, and how long the header is.
_TYPE_AT = {"Ethernet": (12, 14), "Linux cooked": (14, 16), "Linux cooked v2": (0, 20)}
_ARP, _ARP_SIZE = 0x0806, 28
_ICMP, _UNREACHABLE = 1, 3
_ACK = 16
_TYPES = {"frame": np.int64, "kind": np.uint8, "source": np.int32, "target": np.int32}
_TYPES |= {"port": np.int32}


def rows(kind: int, **columns: Array) -> Columns:
    """Return rows of asides of a kind; what is not given is 0."""
    size = len(columns["frame"])
    columns["kind"] = np.full(size, kind)
    return {
        name: columns[name].astype(type_) if name in columns else np.zeros(size, type_)
        for name, type_ in _TYPES.items()
    }


def none() -> Columns:
    """Return a table without asides."""
    return {name: np.zeros(0, type_) for name, type_ in _TYPES.items()}


def arp(data: Bytes, packets: Columns, link: int, addresses: Numbers) -> Columns:
    """Return who asks by ARP for whose address, and who answers whom (RFC 826)."""
    type_at, header = _TYPE_AT.get(LINKS.get(link, ""), (0, 0))
    if not header:
        return none()
    at, size = packets["at"], packets["size"]
    is_arp = (size >= header + _ARP_SIZE) & (number(data, at + type_at, ">u2") == _ARP)
    if not is_arp.any():
        return none()
    at, frame = at[is_arp] + header, packets["frame"][is_arp]
    request = number(data, at + 6, ">u2") == 1
    source, target = addresses.of(data, at + 14, 4), addresses.of(data, at + 24, 4)
    found = rows(_REPLY, frame=frame, source=source, target=target)
    found["kind"][request] = _REQUEST
    return found


def unreachable(data: Bytes, found: Columns, addresses: Numbers) -> Columns:
    """Return what cannot be delivered, as ICMP says (RFC 792): to whom, and to which port."""
    icmp = found["protocol"] == _ICMP
    if not icmp.any():
        return none()
    found = take(found, icmp & (found["end"] - found["at"] >= 36) & (found["offset"] == 0))
    found = take(found, data[found["at"]] == _UNREACHABLE)
    inner = found["at"] + 8
    port_at = inner + (data[inner] & 15).astype(np.int64) * 4 + 2
    found, port_at = take(found, port_at + 2 <= found["end"]), port_at[port_at + 2 <= found["end"]]
    return rows(
        UNREACHABLE,
        frame=found["frame"],
        source=found["target"],  # who sent it and is told so
        target=addresses.of(data, found["at"] + 8 + 16, 4),
        port=number(data, port_at, ">u2"),
    )


def connections(streams: tcp.Streams) -> Columns:
    """Return who asks for a connection of TCP, one a connection, and what came of it."""
    table, first = streams.table, streams.first
    if not len(first):
        return none()
    flags = [np.zeros(len(first), bool) for _ in range(3)]
    syn, ack, rst = (table["flags"] & bit > 0 for bit in (tcp.SYN, _ACK, tcp.RST))
    for kept, mask in zip(flags, (syn & ack, ack & ~syn, rst), strict=True):
        kept[table["stream"][mask]] = True
    answers, acknowledges, resets = flags
    asks = np.flatnonzero((table["flags"][first] & (tcp.SYN | _ACK)) == tcp.SYN)
    open_ = (table["flags"][first] & (tcp.SYN | tcp.RST)) == 0
    open_ &= open_[streams.reverse] & (streams.reverse != np.arange(len(first)))
    exchanged = _ends_of(EXCHANGE, table, first[open_])
    back = streams.reverse[asks]
    here = back != asks
    answered = answers[back] & here
    kind = np.full(len(asks), UNANSWERED)
    kind[resets[back] & here & ~answered] = REFUSED
    kind[answered] = HALF
    kind[answered & acknowledges[asks]] = TAKEN
    found = _ends_of(TAKEN, table, first[asks])
    found["kind"] = kind.astype(np.uint8)
    return stack([found, exchanged])


def exchanges(datagrams: Columns) -> Columns:
    """Return who sends datagrams to whom and gets some back, one a direction."""
    names = ("source", "target", "from_port", "to_port")
    there = [datagrams[name].astype(np.int64) for name in names]
    if not len(there[0]):
        return none()
    _, first = codes(there[0] << 32 | there[2], there[1] << 32 | there[3])
    ends = {tuple(int(key[row]) for key in there): row for row in first.tolist()}
    both = [row for (a, b, m, n), row in ends.items() if (b, a, n, m) in ends and a != b]
    return _ends_of(EXCHANGE, datagrams, np.array(both, np.int64))


def _ends_of(kind: int, table: Columns, chosen: Array) -> Columns:
    """Return rows of asides of a kind with frame, ends and port of chosen packets."""
    return rows(
        kind,
        frame=table["frame"][chosen],
        source=table["source"][chosen],
        target=table["target"][chosen],
        port=table["to_port"][chosen],
    )
