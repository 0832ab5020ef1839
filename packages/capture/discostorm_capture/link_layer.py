"""Unwrap IP and ARP packets from frames: Ethernet, Linux cooked, loopback, raw IP, 802.11."""

from array import array
from collections.abc import Callable, Iterator
from struct import Struct
from typing import NamedTuple

import numpy as np

from discostorm.data import read_data
from discostorm_capture._types import Columns, Notes
from discostorm_capture.pcap import Packets

#: Direction of a Wi-Fi frame, to or from the access point, and of what the recording host sent on
#: Linux's "any" interface (PACKET_OUTGOING of packet(7)); otherwise 0.
UPLINK, DOWNLINK, OUTGOING = 1, 2, 3
_PACKET_OUTGOING = 4

IPV4, IPV6, ARP = 0x0800, 0x86DD, 0x0806
_IP_AND_ARP = (IPV4, IPV6, ARP)
_VLAN_ETHERTYPES, _MAX_VLAN_TAGS = (0x8100, 0x88A8, 0x9100), 4
#: EtherType of PPPoE sessions, EtherTypes by PPP protocol, and the first PPP protocol that only
#: controls the link (RFC 2516, RFC 1661).
_PPPOE_SESSION, _PPP_TYPES, _PPP_CONTROL = 0x8864, {0x0021: IPV4, 0x0057: IPV6}, 0x8000
#: EtherTypes that never hold IP: RARP, LLDP, EAPOL, PPPoE discovery, PTP, loopback tests.
_ETHERTYPES_WITHOUT_IP = (0x8035, 0x88CC, 0x888E, 0x88C7, 0x8863, 0x88F7, 0x9000)
_MIN_ETHERTYPE = 0x600  # smaller values are lengths
#: Address families of IP in loopback headers. That of IPv6 differs between systems.
_IP_FAMILIES = {2, 10, 24, 28, 30}
_MAX_PRESENT_WORDS = 8

_u16, _u32 = Struct(">H").unpack_from, Struct(">I").unpack_from
_le16, _le32 = Struct("<H").unpack_from, Struct("<I").unpack_from


class FramePayload(NamedTuple):
    """What a frame carries: EtherType, first byte and end, and how it was captured."""

    ethertype: int
    at: int
    end: int
    #: A number for the capturing interface and, if known, the direction of the frame there.
    capture_point: int
    direction: int = 0
    #: 1 if the frame is marked as an 802.11 retry.
    is_retry: int = 0
    #: The MAC addresses of the sender and of the receiver; 0 if the link type lacks them.
    mac: int = 0
    to_mac: int = 0


FramePayloads = Iterator[FramePayload]
LinkReader = Callable[[memoryview, int, int, int, Notes], FramePayloads]


def ip_and_arp_packets(packets: Packets, notes: Notes) -> Columns:
    """Return IP and ARP packets: fields of `FramePayload`, and ``frame``, the packet's index."""
    data, rows = packets.data.data, array("q")
    readers = [LINK_READERS.get(LINK_TYPE_NAMES.get(link, "")) for link in packets.link_types]
    columns = (packets.table[name].tolist() for name in ("at", "size", "interface"))
    for frame, (begin, size, interface) in enumerate(zip(*columns, strict=True)):
        read = readers[interface]
        if read is None:
            link = packets.link_types[interface]
            notes[f"packets have link type {link}, which we do not read"] += 1
            continue
        for payload in read(data, begin, begin + size, interface, notes):
            ethertype, at, end, *seen = payload
            if ethertype not in _IP_AND_ARP:
                ethertype, at = _skip_vlan_and_pppoe(data, ethertype, at, end)
            if ethertype not in _IP_AND_ARP:
                if ethertype >= _MIN_ETHERTYPE and ethertype not in _ETHERTYPES_WITHOUT_IP:
                    notes[f"frames have EtherType 0x{ethertype:04x}, which we do not read"] += 1
            elif at < end:
                rows.extend((frame, ethertype, at, end, *seen))
    names = ("frame", *FramePayload._fields)
    table = np.array(rows, np.int64).reshape(-1, len(names)).T.copy()
    return dict(zip(names, table, strict=True))


def _skip_vlan_and_pppoe(data: memoryview, ethertype: int, at: int, end: int) -> tuple[int, int]:
    """Return the EtherType and offset of what follows VLAN tags and PPPoE."""
    for _ in range(_MAX_VLAN_TAGS):
        if ethertype not in _VLAN_ETHERTYPES or at + 4 > end:
            break
        ethertype, at = _u16(data, at + 2)[0], at + 4
    if ethertype == _PPPOE_SESSION and at + 8 <= end:
        (protocol,), at = _u16(data, at + 6), at + 8
        ethertype = _PPP_TYPES.get(protocol, 0 if protocol >= _PPP_CONTROL else ethertype)
    return ethertype, at


def _skip_llc_snap(data: memoryview, at: int, end: int) -> tuple[int, int]:
    """Return the EtherType and offset after an LLC header with SNAP; EtherType 0 without SNAP."""
    if end - at >= 8 and _u32(data, at)[0] == 0xAAAA0300 and not _u16(data, at + 4)[0]:
        return _u16(data, at + 6)[0], at + 8
    return 0, at


def _read_ethernet(data: memoryview, at: int, end: int, point: int, _notes: Notes) -> FramePayloads:
    if end - at >= 14:
        ethertype, inner = _u16(data, at + 12)[0], at + 14
        if ethertype <= 1500:  # a length
            ethertype, inner = _skip_llc_snap(data, inner, end)
        to_mac, mac = (_u32(data, at + n)[0] << 16 | _u16(data, at + n + 4)[0] for n in (0, 6))
        yield FramePayload(ethertype, inner, end, point, mac=mac, to_mac=to_mac)


def _read_sll(data: memoryview, at: int, end: int, point: int, _notes: Notes) -> FramePayloads:
    if end - at >= 16:
        # Add the direction: the "any" interface may show a packet both as sent and as received.
        point = point << 8 | _u16(data, at)[0] & 0xFF
        direction = OUTGOING * (point & 0xFF == _PACKET_OUTGOING)
        yield FramePayload(_u16(data, at + 14)[0], at + 16, end, point, direction)


def _read_sll2(data: memoryview, at: int, end: int, point: int, _notes: Notes) -> FramePayloads:
    if end - at >= 20:
        point = (point << 40 | _u32(data, at + 4)[0] << 8 | data[at + 10]) & 2**63 - 1
        direction = OUTGOING * (data[at + 10] == _PACKET_OUTGOING)
        yield FramePayload(_u16(data, at)[0], at + 20, end, point, direction)


def _read_loopback(data: memoryview, at: int, end: int, point: int, notes: Notes) -> FramePayloads:
    if end - at >= 4:
        # Try both byte orders: the address family is in the one of the capturing machine.
        if {_u32(data, at)[0], _le32(data, at)[0]} & _IP_FAMILIES:
            yield FramePayload(IPV4, at + 4, end, point)
        else:
            notes["packets of loopback that are not IP"] += 1


def _read_raw_ip(_data: memoryview, at: int, end: int, point: int, _notes: Notes) -> FramePayloads:
    yield FramePayload(IPV4, at, end, point)


def _read_radiotap(data: memoryview, at: int, end: int, point: int, notes: Notes) -> FramePayloads:
    if end - at < 8:
        return
    (length,), (present,), words = _le16(data, at + 2), _le32(data, at + 4), 1
    last_word = min(_MAX_PRESENT_WORDS, (length - 5) // 4)
    while words <= last_word and _le32(data, at + 4 * words)[0] >> 31:
        words += 1
    # The flags follow the optional time stamp, which is aligned to eight bytes.
    offset = 4 + 4 * words
    offset = (offset + 7 & ~7) + 8 if present & 1 else offset
    flags = data[at + offset] if present & 2 and offset < length else 0
    if flags & 0x40:
        notes["Wi-Fi frames with a wrong check sequence, left out"] += 1
    elif data[at] == 0 and length >= 8:
        end -= 4 if flags & 0x10 else 0
        yield from _read_wifi(data, at + length, end, point, notes, padded=flags & 0x20 > 0)


def _read_wifi(
    data: memoryview, at: int, end: int, point: int, notes: Notes, padded: bool = False
) -> FramePayloads:
    # Skip all frames except data frames with a payload.
    if end - at < 24 or data[at] & 0x4F != 0x08:
        return
    first, second = data[at], data[at + 1]
    if second & 0x40:
        notes["encrypted Wi-Fi frames"] += 1
        return
    if second & 0x04 or data[at + 22] & 0x0F:
        notes["fragments of Wi-Fi frames"] += 1
        return
    distribution, has_qos = second & 3, first & 0x80 > 0  # To DS, From DS
    control = at + 24 + 6 * (distribution == 3)
    header = control - at + 2 * has_qos + 4 * (has_qos and second & 0x80 > 0)
    inner = at + (header + 3 & ~3 if padded else header)
    seen = point << 2 | distribution, {1: UPLINK, 2: DOWNLINK}.get(distribution, 0), second >> 3 & 1
    if not (has_qos and control < end and data[control] & 0x80):
        yield FramePayload(*_skip_llc_snap(data, inner, end), end, *seen)
        return
    while inner + 14 <= end:  # an A-MSDU: each subframe has its own addresses and length
        length = 14 + _u16(data, inner + 12)[0]
        part_end = min(inner + length, end)
        yield FramePayload(*_skip_llc_snap(data, inner + 14, part_end), part_end, *seen)
        inner += length + 3 & ~3


#: The reader of each link type, by its name in the data file.
LINK_READERS: dict[str, LinkReader] = {
    "Ethernet": _read_ethernet, "Linux cooked": _read_sll, "Linux cooked v2": _read_sll2,
    "raw IP": _read_raw_ip, "loopback": _read_loopback, "IEEE 802.11": _read_wifi,
    "IEEE 802.11 with radiotap": _read_radiotap,
}  # fmt: skip
_LINK_TYPES = read_data("vendors/link_types.csv", "discostorm_capture")
LINK_TYPE_NAMES = {int(row["id"]): row["what"] for row in _LINK_TYPES}
