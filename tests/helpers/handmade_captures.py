"""Capture files made by hand, without any code of the reader."""

import lzma
import struct
from collections.abc import Callable, Iterable
from pathlib import Path

from discostorm.data import data_path

CAPTURES = data_path("captures", "discostorm_capture")

#: A packet: time [ns], captured bytes, length on the wire.
Packet = tuple[int, bytes, int]


def packets(name: str, folder: Path = CAPTURES) -> list[Packet]:
    """Return the packets of a stored capture, which is Ethernet and little-endian."""
    raw = lzma.decompress((folder / f"{name}.pcap.xz").read_bytes())
    found, at = [], 24
    while at < len(raw):
        second, micro, size, length = struct.unpack_from("<IIII", raw, at)
        found.append((second * 10**9 + micro * 1000, raw[at + 16 : at + 16 + size], length))
        at += 16 + size
    return found


def pcap(found: Iterable[Packet], link: int = 1, order: str = "<", nano: bool = False) -> bytes:
    """Return a pcap file."""
    magic, tick = (0xA1B23C4D, 1) if nano else (0xA1B2C3D4, 1000)
    parts = [struct.pack(order + "IHHiIII", magic, 2, 4, 0, 0, 262144, link)]
    for time, data, length in found:
        head = (time // 10**9, time % 10**9 // tick, len(data), length)
        parts += [struct.pack(order + "IIII", *head), data]
    return b"".join(parts)


def block(kind: int, body: bytes, order: str = "<") -> bytes:
    """Return a block of a pcapng file."""
    body += bytes(-len(body) % 4)
    size = struct.pack(order + "I", len(body) + 12)
    return struct.pack(order + "I", kind) + size + body + size


def pcapng(
    found: Iterable[Packet], links: tuple[int, ...] = (1,), order: str = "<", resolution: int = 9
) -> bytes:
    """Return a pcapng file whose packets alternate between its interfaces."""
    head = struct.pack(order + "IHHq", 0x1A2B3C4D, 1, 0, -1)
    parts = [block(0x0A0D0D0A, head, order)]
    option = struct.pack(order + "HHB3xHH", 9, 1, resolution, 0, 0)
    parts += [block(1, struct.pack(order + "HHI", link, 0, 0) + option, order) for link in links]
    for index, (time, data, length) in enumerate(found):
        ticks = time // 10 ** (9 - resolution)
        fields = (index % len(links), ticks >> 32, ticks & 0xFFFFFFFF, len(data), length)
        parts.append(block(6, struct.pack(order + "IIIII", *fields) + data, order))
    return b"".join(parts)


def rewrap(found: Iterable[Packet], wrap: Callable[[bytes], bytes]) -> list[Packet]:
    """Return IPv4 packets in other frames; leave out all other packets."""
    return [
        (time, wrap(data[14:]), len(wrap(data[14:])) + length - len(data))
        for time, data, length in found
        if data[12:14] == b"\x08\x00"
    ]


_MAC = bytes.fromhex("020000000001020000000002")
_LLC = bytes.fromhex("aaaa030000000800")


def wifi(ip: bytes, flags: int = 1, subtype: int = 8, more: bytes = b"") -> bytes:
    """Return an 802.11 frame with QoS; the flags give its direction."""
    head = bytes([subtype << 4 | 8, flags]) + bytes(2) + _MAC + bytes(6) + bytes(2)
    return head + more + (bytes(2) if subtype & 8 else b"") + _LLC + ip


def amsdu(ip: bytes) -> bytes:
    """Return an A-MSDU with two parts: a short unrelated part, and the packet."""
    head = bytes([0x88, 1]) + bytes(2) + _MAC + bytes(6) + bytes(2) + b"\x80\x00"
    other = _MAC + struct.pack(">H", 9) + b"\xaa\xaa\x03\0\0\0\x99\x99\0"
    return head + other + bytes(-len(other) % 4) + _MAC + struct.pack(">H", len(ip) + 8) + _LLC + ip


def radiotap(frame: bytes, check: bool) -> bytes:
    """Return a frame with a radiotap header: time, flags, and a second presence word."""
    present = struct.pack("<II", 1 << 31 | 3, 0)
    body = bytes(4) + struct.pack("<QB", 7, 0x10 if check else 0)
    head = struct.pack("<BBH", 0, 0, 4 + len(present) + len(body)) + present + body
    return head + frame + (b"\xde\xad\xbe\xef" if check else b"")


#: Functions that put an IPv4 packet into a frame, by link type.
LINKS: dict[str, tuple[int, Callable[[bytes], bytes]]] = {
    "Ethernet": (1, lambda ip: _MAC + b"\x08\x00" + ip),
    "802.3 with SNAP": (1, lambda ip: _MAC + struct.pack(">H", min(len(ip) + 8, 1500)) + _LLC + ip),
    "VLAN": (1, lambda ip: _MAC + b"\x81\x00\x00\x05\x08\x00" + ip),
    "QinQ": (1, lambda ip: _MAC + b"\x88\xa8\x00\x05\x81\x00\x00\x06\x08\x00" + ip),
    "trailer": (1, lambda ip: _MAC + b"\x08\x00" + ip + b"padding"),
    "cooked": (113, lambda ip: struct.pack(">HHH8sH", 0, 1, 6, _MAC, 0x800) + ip),
    "cooked 2": (276, lambda ip: struct.pack(">HHIHBB8s", 0x800, 0, 2, 1, 0, 6, _MAC) + ip),
    "null, little-endian": (0, lambda ip: b"\x02\0\0\0" + ip),
    "null, big-endian": (0, lambda ip: b"\0\0\0\x02" + ip),
    "loop": (108, lambda ip: b"\0\0\0\x02" + ip),
    "raw": (101, lambda ip: ip),
    "raw IPv4": (228, lambda ip: ip),
    "802.11": (105, wifi),
    "802.11 without QoS": (105, lambda ip: wifi(ip, subtype=0)),
    "802.11 with HT control": (105, lambda ip: wifi(ip, flags=0x81)[:26] + bytes(4) + _LLC + ip),
    "802.11 of four addresses": (105, lambda ip: wifi(ip, flags=3, more=bytes(6))),
    "A-MSDU": (105, amsdu),
    "radiotap": (127, lambda ip: radiotap(wifi(ip, flags=2), False)),
    "radiotap with check sequence": (127, lambda ip: radiotap(wifi(ip, flags=2), True)),
}


def ipv6(ip: bytes, extension: bool = False) -> bytes:
    """Return the payload of an IPv4 packet as an IPv6 packet."""
    header = (ip[0] & 15) * 4
    body = ip[header : struct.unpack_from(">H", ip, 2)[0]]
    next_ = ip[9]
    if extension:
        body = bytes([next_, 0]) + b"\x01\x04\0\0\0\0" + body
        next_ = 0
    group = ip[16] >> 4 == 0xE
    there = (b"\xff\x02" if group else b"\xfe\x80") + bytes(10) + ip[16:20]
    return (
        struct.pack(">IHBB", 6 << 28, len(body), next_, 64)
        + b"\xfe\x80"
        + bytes(10)
        + ip[12:16]
        + there
        + body
    )


def ipv6_fragments(ip: bytes, size: int, id_: int) -> list[bytes]:
    """Return the payload as IPv6 fragments of some bytes, a multiple of 8."""
    whole = ipv6(ip)
    head, body, next_ = whole[:40], whole[40:], whole[6]
    parts = []
    for at in range(0, len(body), size):
        piece = body[at : at + size]
        more = at + size < len(body)
        extra = struct.pack(">BBHI", next_, 0, at | more, id_)
        length = struct.pack(">H", len(piece) + 8)
        parts.append(head[:4] + length + b"\x2c" + head[7:] + extra + piece)
    return parts


def ipv4_fragments(ip: bytes, size: int, id_: int) -> list[bytes]:
    """Return an IPv4 packet as fragments of some bytes, a multiple of 8."""
    head, body = ip[:20], ip[20:]
    parts = []
    for at in range(0, len(body), size):
        piece = body[at : at + size]
        more = 0x2000 * (at + size < len(body))
        fields = struct.pack(">HHH", len(piece) + 20, id_, at // 8 | more)
        parts.append(head[:2] + fields + head[8:] + piece)
    return parts


def udp(
    payload: bytes, source: int = 1, target: int = 2, ports: tuple[int, int] = (7410, 7411)
) -> bytes:
    """Return an IPv4 packet of a UDP datagram from 10.0.0.source to 10.0.0.target."""
    body = struct.pack(">HHHH", *ports, len(payload) + 8, 0) + payload
    head = struct.pack(">BBHHHBBH", 0x45, 0, len(body) + 20, 1, 0, 64, 17, 0)
    return head + bytes([10, 0, 0, source, 10, 0, 0, target]) + body


def rtps(*submessages: bytes, prefix: bytes = bytes(range(12))) -> bytes:
    """Return an RTPS message."""
    return b"RTPS\x02\x03\x01\x0f" + prefix + b"".join(submessages)


def submessage(
    kind: int, body: bytes, little: bool = True, flags: int = 0, size: int = -1
) -> bytes:
    """Return a submessage."""
    length = len(body) if size < 0 else size
    return struct.pack("<BBH" if little else ">BBH", kind, flags | little, length) + body


def tcp(
    payload: bytes,
    sequence: int,
    flags: int = 0x18,
    back: bool = False,
    ports: tuple[int, int] = (40000, 7447),
) -> bytes:
    """Return an IPv4 packet of a TCP segment between 10.0.0.1 and 10.0.0.2."""
    there, from_, to = ((2, 1), ports[1], ports[0]) if back else ((1, 2), *ports)
    body = struct.pack(">HHIIBBHHH", from_, to, sequence % 2**32, 0, 0x50, flags, 1000, 0, 0)
    head = struct.pack(">BBHHHBBH", 0x45, 0, len(body) + len(payload) + 20, 1, 0, 64, 6, 0)
    return head + bytes([10, 0, 0, there[0], 10, 0, 0, there[1]]) + body + payload


def prefix(host: int) -> bytes:
    """Return the GUID prefix of a host's only process, with Fast DDS."""
    return bytes([1, 15, 0, host]) + bytes(7) + bytes([host])


def dds(time: float, host: int, *submessages: bytes, to: int = 0) -> Packet:
    """Return a packet from 10.0.0.host to 10.0.0.to, or by multicast, in an Ethernet frame."""
    there = [submessage(0x0E, prefix(to))] if to else []
    ip = udp(rtps(*there, *submessages, prefix=prefix(host)), host, to or 1, (7410, 7410))
    if not to:
        ip = ip[:16] + bytes([239, 255, 0, 1]) + ip[20:]
        ip = ip[:22] + struct.pack(">H", 7400) + ip[24:]
    frame = _MAC + b"\x08\x00" + ip
    return round(time * 1e9), frame, len(frame)


def sample(writer: int, number: int) -> bytes:
    """Return a DATA submessage of a writer, with an empty list of parameters."""
    ids = struct.pack(">II", writer + 5, writer)
    body = bytes(2) + struct.pack("<H", 16) + ids + struct.pack("<iI", 0, number)
    return submessage(0x15, body + b"\0\x03\0\0\x01\0\0\0", flags=4)


#: Entity ids of the writers that announce participants and publishers.
SPDP, SEDP = 0x000100C2, 0x000003C2


def announce(time: float, host: int) -> Packet:
    """Return a participant announcement of a host's process."""
    return dds(time, host, sample(SPDP, 1))


def endpoint(time: float, host: int, to: int, number: int = 1) -> Packet:
    """Return the announcement of an endpoint."""
    return dds(time, host, sample(SEDP, number), to=to)


def acknowledge(time: float, host: int, to: int, base: int, missing: int = 0) -> Packet:
    """Return an ACKNACK: samples below ``base`` have arrived; some of the next are missing."""
    state = struct.pack("<iII", 0, base, missing)
    bits = struct.pack("<I", (1 << 32) - (1 << (32 - missing))) if missing else b""
    ids = struct.pack(">II", SEDP + 5, SEDP)
    return dds(time, host, submessage(6, ids + state + bits + bytes(4)), to=to)


def startup(time: float, *hosts: int) -> list[Packet]:
    """Return a startup in which every process announces one endpoint to every other process."""
    found = [announce(time, host) for host in hosts]
    for host in hosts:
        for to in hosts:
            if to != host:
                found.append(endpoint(time + 0.01, host, to))
                found.append(acknowledge(time + 0.02, to, host, 2))
    return found
