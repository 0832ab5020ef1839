"""From IP packets to UDP datagrams and TCP segments; fragments are put together."""

from collections import Counter
from ipaddress import ip_address

import numpy as np

from discostorm_capture._bytes import Array, Bytes, Columns, Numbers, number, numbers, stack, take

TCP, UDP, FRAGMENT = 6, 17, 44
#: Protocols that carry other packets: IPv4, IPv6, GRE; ports of UDP that do: VXLAN's and Geneve's.
TUNNELS, TUNNEL_PORTS = (4, 41, 47), (4789, 6081)
#: IPsec's Encapsulating Security Payload, and the port of WireGuard.
ENCRYPTED, WIREGUARD_PORT = 50, 51820
#: IPv6 extension headers: hop by hop, routing, destination, mobility; each tells its length.
_EXTENSIONS = (0, 43, 60, 135)
_AUTHENTICATION = 51
_MOST_EXTENSIONS = 8


def names(addresses: Numbers) -> list[str]:
    """Return addresses as text, in the order of their numbers."""
    return [str(ip_address(address)) for address in addresses.known]


def multicast(addresses: Numbers) -> Array:
    """Return of each address whether it is one of multicast or broadcast."""
    return np.array(
        [
            key[0] == 0xFF if len(key) == 16 else key[0] >> 4 == 0xE or key == b"\xff" * 4
            for key in addresses.known
        ],
        bool,
    )


def parse(data: Bytes, found: Columns, addresses: Numbers, notes: Counter[str]) -> Columns:
    """Return what IP packets carry.

    Takes what `link.ip_packets` returns. Adds ``source``, ``target`` (numbers of
    addresses), ``protocol``, ``id``, ``offset`` of a fragment [B], ``more`` and ``wire``, the
    bytes that were sent; ``at`` and ``end`` are those of the content then.
    """
    version = data[found["at"]] >> 4
    if count := int(np.count_nonzero((version != 4) & (version != 6))):
        notes["packets that are said to be IP, and are not"] += count
    parts = [
        part
        for number_, read in ((4, _version_4), (6, _version_6))
        if (mine := version == number_).any()
        for part in [read(data, take(found, mine), addresses, notes)]
    ]
    return stack(parts) if parts else _version_4(data, take(found, slice(0)), addresses, notes)


def _version_4(data: Bytes, found: Columns, addresses: Numbers, notes: Counter[str]) -> Columns:
    at = found["at"]
    first, total, id_, flags, protocol = numbers(data, at, ">u2", 5).T.astype(np.int64, order="C")
    header = (first >> 8 & 15) * 4
    # The card was to cut it into packets and to fill in the length.
    total = np.where(total == 0, found["end"] - at, total)
    good = (header >= 20) & (total >= header)
    if count := int(np.count_nonzero(~good & (at + 20 <= found["end"]))):
        notes["IP packets with a broken header"] += count
    good &= at + header <= found["end"]
    if not good.all():
        found, at, header, total = take(found, good), at[good], header[good], total[good]
        id_, flags, protocol = id_[good], flags[good], protocol[good]
    return found | {
        "source": addresses.of(data, at + 12, 4),
        "target": addresses.of(data, at + 16, 4),
        "protocol": (protocol & 0xFF).astype(np.uint8),
        "id": id_,
        "offset": (flags & 0x1FFF) * 8,
        "more": flags & 0x2000 > 0,
        "wire": total - header,
        "at": at + header,
        "end": np.minimum(found["end"], at + total),
    }


def _version_6(data: Bytes, found: Columns, addresses: Numbers, _notes: Counter[str]) -> Columns:
    found = take(found, found["end"] - found["at"] >= 40)
    start = found["at"]
    length = number(data, start + 4, ">u2").astype(np.int64)
    length = np.where(length == 0, found["end"] - start - 40, length)
    end = np.minimum(found["end"], start + 40 + length)
    following = data[start + 6].astype(np.int64)
    at = start + 40
    id_, offset = np.zeros(len(at), np.int64), np.zeros(len(at), np.int64)
    more, fragment = np.zeros(len(at), bool), np.zeros(len(at), bool)
    for _ in range(_MOST_EXTENSIONS):
        # What follows the header of a fragment is a piece of something.
        inside = (at + 8 <= end) & ~fragment
        cut = inside & (following == FRAGMENT)
        signed = inside & (following == _AUTHENTICATION)
        step = inside & np.isin(following, _EXTENSIONS) | cut | signed
        if not step.any():
            break
        here = np.where(step, at, 0)
        flags = number(data, here + 2, ">u2").astype(np.int64)
        offset = np.where(cut, flags & 0xFFF8, offset)
        more |= cut & (flags & 1 > 0)
        id_ = np.where(cut, number(data, here + 4, ">u4"), id_)
        fragment |= cut
        length_field = data[here + 1].astype(np.int64)
        size = np.where(signed, 4 * (length_field + 2), 8 * (length_field + 1))
        following = np.where(step, data[here], following)
        at = at + np.where(cut, 8, size * step)
    return found | {
        "source": addresses.of(data, start + 8, 16),
        "target": addresses.of(data, start + 24, 16),
        "protocol": following.astype(np.uint8),
        "id": id_,
        "offset": offset,
        "more": more,
        "wire": np.maximum(start + 40 + length - at, 0),
        "at": np.minimum(at, end),
        "end": end,
    }


def loopback(addresses: Numbers) -> Array:
    """Return of each address whether it is of a host's own loopback."""
    return np.array(
        [key[0] == 127 if len(key) == 4 else key == bytes(15) + b"\1" for key in addresses.known],
        bool,
    )


def is_piece(found: Columns) -> Array:
    """Return which of the packets that `parse` found are fragments."""
    return (found["offset"] > 0) | found["more"]


def datagrams(data: Bytes, found: Columns) -> Columns:
    """Return the UDP datagrams: ``at``, ``size`` and ``wire`` bytes of what they hold, ports."""
    found = take(found, (found["protocol"] == UDP) & (found["end"] - found["at"] >= 8))
    at = found["at"]
    from_port, to_port, length, check = numbers(data, at, ">u2", 4).T.astype(np.int64, order="C")
    wire = np.where((length >= 8) & (length <= found["wire"]), length, found["wire"]) - 8
    return found | {
        "at": at + 8,
        "size": np.minimum(found["end"] - at - 8, wire),
        "wire": wire,
        "from_port": from_port.astype(np.int32),
        "to_port": to_port.astype(np.int32),
        "check": check,
    }


def segments(data: Bytes, found: Columns) -> Columns:
    """Return the TCP segments, as `datagrams`, with ``sequence``, ``acknowledged``, ``flags``."""
    found = take(found, (found["protocol"] == TCP) & (found["end"] - found["at"] >= 20))
    at = found["at"]
    header = (data[at + 12].astype(np.int64) >> 4) * 4
    good = (header >= 20) & (header <= found["wire"])
    if not good.all():
        found, at, header = take(found, good), at[good], header[good]
    return found | {
        "at": at + header,
        "size": np.maximum(found["end"] - at - header, 0),
        "wire": found["wire"] - header,
        "from_port": number(data, at, ">u2").astype(np.int32),
        "to_port": number(data, at + 2, ">u2").astype(np.int32),
        "check": number(data, at + 16, ">u2"),
        "sequence": number(data, at + 4, ">u4"),
        "acknowledged": number(data, at + 8, ">u4"),
        "flags": data[at + 13],
    }
