"""Parse IP packets, UDP datagrams and TCP segments."""

from ipaddress import ip_address

import numpy as np

from discostorm_capture._arrays import IdTable, concat, number_rows_at, numbers_at, take_rows
from discostorm_capture._types import Array, Bytes, Columns, Notes

ICMP, TCP, UDP, FRAGMENT_HEADER = 1, 6, 17, 44
#: Protocols that carry other packets (IPv4, IPv6, GRE), and UDP ports that do (VXLAN, Geneve).
TUNNEL_PROTOCOLS, TUNNEL_PORTS = (4, 41, 47), (4789, 6081)
#: The protocol number of IPsec's Encapsulating Security Payload, and the port of WireGuard.
IPSEC_ESP, WIREGUARD_PORT = 50, 51820
#: IPv6 extension headers with a length field: hop by hop, routing, destination, mobility.
_EXTENSION_HEADERS = (0, 43, 60, 135)
_AUTHENTICATION_HEADER = 51
_MAX_EXTENSION_HEADERS = 8


def format_addresses(addresses: IdTable) -> list[str]:
    """Return addresses as text, in the order of their ids."""
    return [str(ip_address(address)) for address in addresses.ids]


def is_multicast(addresses: IdTable) -> Array:
    """Return whether each address is multicast or broadcast."""
    groups = [ip_address(key).is_multicast or key == b"\xff" * 4 for key in addresses.ids]
    return np.array(groups, bool)


def is_loopback(addresses: IdTable) -> Array:
    """Return whether each address is a loopback address."""
    return np.array([ip_address(key).is_loopback for key in addresses.ids], bool)


def parse_ip(data: Bytes, packets: Columns, addresses: IdTable, notes: Notes) -> Columns:
    """Return IP packets, with ``at`` and ``end`` of their payload instead of the header's.

    Adds columns: ``source`` and ``target``, ids of addresses; ``protocol``; ``id``; ``offset`` of a
    fragment [B], and whether ``more`` follow; ``wire``, payload bytes sent; ``parts``, frames [1].
    """
    version = data[packets["at"]] >> 4
    notes.add_where((version != 4) & (version != 6), "packets that are said to be IP, and are not")
    parsed = concat(
        _parse_ipv4(data, take_rows(packets, version == 4), addresses, notes),
        _parse_ipv6(data, take_rows(packets, version == 6), addresses),
    )
    parsed = take_rows(parsed, np.argsort(parsed["frame"], kind="stable"))
    return parsed | {"parts": np.ones(len(parsed["at"]), np.int32)}


def _parse_ipv4(data: Bytes, packets: Columns, addresses: IdTable, notes: Notes) -> Columns:
    """Return the payload of IPv4 packets (RFC 791)."""
    at = packets["at"]
    first, total, *_ = number_rows_at(data, at, ">u2", 2).T.astype(np.int64)
    header = (first >> 8 & 15) * 4
    # With segmentation offload, the length is 0 until the network card fills it in.
    total = np.where(total == 0, packets["end"] - at, total)
    good = (header >= 20) & (total >= header)
    notes.add_where(~good & (at + 20 <= packets["end"]), "IP packets with a broken header")
    good &= at + header <= packets["end"]
    packets, at, header, total = take_rows(packets, good), at[good], header[good], total[good]
    flags = numbers_at(data, at + 6, ">u2").astype(np.int64)
    return packets | {
        "source": addresses.ids_of(data, at + 12, 4),
        "target": addresses.ids_of(data, at + 16, 4),
        "protocol": data[at + 9],
        "id": numbers_at(data, at + 4, ">u2").astype(np.int64),
        "offset": (flags & 0x1FFF) * 8,
        "more": flags & 0x2000 > 0,
        "wire": total - header,
        "at": at + header,
        "end": np.minimum(packets["end"], at + total),
    }


def _parse_ipv6(data: Bytes, packets: Columns, addresses: IdTable) -> Columns:
    """Return the payload of IPv6 packets, after their extension headers (RFC 8200)."""
    packets = take_rows(packets, packets["end"] - packets["at"] >= 40)
    start = packets["at"]
    length = numbers_at(data, start + 4, ">u2").astype(np.int64)
    length = np.where(length == 0, packets["end"] - start - 40, length)
    end = np.minimum(packets["end"], start + 40 + length)
    following, at = data[start + 6].astype(np.int64), start + 40
    id_, offset = np.zeros((2, len(at)), np.int64)
    more, is_fragment = np.zeros((2, len(at)), bool)
    for _ in range(_MAX_EXTENSION_HEADERS):
        # After a fragment header comes payload, and no further header is read.
        inside = (at + 8 <= end) & ~is_fragment
        fragment = inside & (following == FRAGMENT_HEADER)
        signed = inside & (following == _AUTHENTICATION_HEADER)
        step = inside & np.isin(following, _EXTENSION_HEADERS) | fragment | signed
        if not step.any():
            break
        here = np.where(step, at, 0)
        flags = numbers_at(data, here + 2, ">u2").astype(np.int64)
        offset = np.where(fragment, flags & 0xFFF8, offset)
        more |= fragment & (flags & 1 > 0)
        id_ = np.where(fragment, numbers_at(data, here + 4, ">u4"), id_)
        is_fragment |= fragment
        length_field = data[here + 1].astype(np.int64)
        size = np.where(signed, 4 * (length_field + 2), 8 * (length_field + 1))
        following = np.where(step, data[here], following)
        at = at + np.where(fragment, 8, size * step)
    return packets | {
        "source": addresses.ids_of(data, start + 8, 16),
        "target": addresses.ids_of(data, start + 24, 16),
        "protocol": following.astype(np.uint8),
        "id": id_,
        "offset": offset,
        "more": more,
        "wire": np.maximum(start + 40 + length - at, 0),
        "at": np.minimum(at, end),
        "end": end,
    }


def udp_datagrams(data: Bytes, packets: Columns) -> Columns:
    """Return UDP datagrams: ``at``, captured ``size`` and ``wire`` bytes of payload, and ports."""
    has_header = packets["end"] - packets["at"] >= 8
    packets = take_rows(packets, has_header & (packets["protocol"] == UDP))
    at = packets["at"]
    from_port, to_port, length, check = number_rows_at(data, at, ">u2", 4).T.astype(np.int32)
    wire = np.where((length >= 8) & (length <= packets["wire"]), length, packets["wire"]) - 8
    return packets | {
        "at": at + 8,
        "size": np.minimum(packets["end"] - at - 8, wire),
        "wire": wire,
        "from_port": from_port,
        "to_port": to_port,
        "check": check,
    }


def sender_and_receiver_sockets(table: Columns) -> tuple[Array, Array]:
    """Return sender and receiver of datagrams or segments: address and port in one number."""
    ends = (("source", "from_port"), ("target", "to_port"))
    sender, receiver = (table[ip].astype(np.int64) << 32 | table[port] for ip, port in ends)
    return sender, receiver


def tcp_segments(data: Bytes, packets: Columns) -> Columns:
    """Return TCP segments: the columns of `udp_datagrams`, and fields of the TCP header."""
    has_header = packets["end"] - packets["at"] >= 20
    packets = take_rows(packets, has_header & (packets["protocol"] == TCP))
    header = (data[packets["at"] + 12].astype(np.int64) >> 4) * 4
    good = (header >= 20) & (header <= packets["wire"])
    packets, header = take_rows(packets, good), header[good]
    at = packets["at"]
    return packets | {
        "at": at + header,
        "size": np.maximum(packets["end"] - at - header, 0),
        "wire": packets["wire"] - header,
        "from_port": numbers_at(data, at, ">u2").astype(np.int32),
        "to_port": numbers_at(data, at + 2, ">u2").astype(np.int32),
        "check": numbers_at(data, at + 16, ">u2").astype(np.int32),
        "sequence": numbers_at(data, at + 4, ">u4").astype(np.int64),
        "acknowledges": numbers_at(data, at + 8, ">u4").astype(np.int64),
        "flags": data[at + 13],
        "window": numbers_at(data, at + 14, ">u2").astype(np.int32),
    }
