"""From captured packets to UDP datagrams and TCP segments, and which of them are duplicates."""

from dataclasses import dataclass

import numpy as np

from discostorm_capture import fragments, ip, link, network_events
from discostorm_capture._bytes import (
    Array,
    Bytes,
    Columns,
    IdTable,
    Notes,
    factorize,
    note,
    numbers,
    stack_tables,
    take_rows,
)
from discostorm_capture.pcap import Packets

#: Two interfaces, or both directions of a Wi-Fi network, show a packet within this time [ns].
SEEN_AGAIN_WITHIN = 1_000_000_000
AGAIN = "packets seen again, on another interface or way, or mirrored; they are not compared"


@dataclass(frozen=True)
class Transport:
    """What the packets of a capture carry, in the order of the capture."""

    #: The bytes of the file and of reassembled datagrams, and padding.
    data: Bytes
    addresses: IdTable
    #: As `ip.datagrams` and `ip.segments`.
    datagrams: Columns
    segments: Columns
    #: As `network_events`.
    events: Columns
    #: How many packets are "ARP", "UDP", "TCP" and "other".
    packets: dict[str, int]


def transport_content(packets: Packets, notes: Notes) -> Transport:
    """Return the datagrams, segments and events in packets; notes count unreadable packets."""
    data, addresses = packets.data, IdTable()
    network = link.network_packets(packets, notes)
    arp = network_events.arp(data, network, addresses)
    network = take_rows(network, network["ethertype"] != link.ARP)
    network = ip.parse_ip(data, network, addresses, notes)
    data, network = fragments.reassemble(data, network, packets.table["time"], notes)
    datagrams, segments = ip.datagrams(data, network), ip.segments(data, network)
    note(notes, network["protocol"] == ip.ENCRYPTED, "encrypted IP packets")
    tunnels = int(np.count_nonzero(np.isin(network["protocol"], ip.TUNNELS)))
    tunnels += int(np.count_nonzero(np.isin(datagrams["to_port"], ip.TUNNEL_PORTS)))
    if tunnels:
        notes["packets in a tunnel (GRE, IP in IP, VXLAN, Geneve), which are not read"] += tunnels
    events = stack_tables(arp, network_events.unreachable(data, network, addresses))
    counts = {"ARP": len(arp["frame"])} | {
        name: int(network["parts"][network["protocol"] == protocol].sum())
        for name, protocol in (("UDP", ip.UDP), ("TCP", ip.TCP))
    }
    counts["other"] = len(packets.table["at"]) - sum(counts.values())
    return Transport(data, addresses, datagrams, segments, events, counts)


def note_encrypted(data: Bytes, datagrams: Columns, notes: Notes) -> None:
    """Count datagrams that look like DTLS, QUIC or WireGuard."""
    at, size = datagrams["at"], datagrams["size"]
    first = data[at]
    dtls = (first >= 20) & (first <= 25) & (numbers(data, at + 1, ">u2") >= 0xFEFC) & (size > 12)
    quic = (first >= 0xC0) & (numbers(data, at + 1, ">u4") == 1) & (size > 20)
    ends = (datagrams[end] == ip.WIREGUARD_PORT for end in ("from_port", "to_port"))
    guard = np.logical_or(*ends)
    guard &= numbers(data, at, "<u4") - np.uint32(1) < 4
    for name, mask in (("DTLS", dtls), ("QUIC", quic), ("WireGuard", guard)):
        note(notes, mask, f"datagrams of {name}, which are encrypted")


def duplicate_frames(transport: Transport, time: Array, notes: Notes) -> Array:
    """Return whether each frame shows again what an earlier one did: a mirror port, a merged file.

    A sender does not use an IP id again that soon (RFC 6864, 4.1).
    """
    keys = ("source", "target", "from_port", "to_port", "id", "wire", "check")
    names = (*keys, "at", "size", "frame", "view", "retry")
    packets = stack_tables(
        *({name: t[name] for name in names} for t in (transport.datagrams, transport.segments))
    )
    # At least eight bytes of a header precede an empty payload.
    packets["tail"] = numbers(transport.data, packets["at"] + packets["size"] - 8, "=u8")
    code, _ = factorize(*(packets[key] for key in (*keys, "tail")))
    repeated = np.flatnonzero(np.bincount(code)[code] > 1)
    repeated = repeated[np.lexsort((packets["frame"][repeated], code[repeated]))]
    packets = take_rows(packets, repeated)
    # A sender may repeat a packet without an id; a retry of 802.11 repeats a frame.
    identified = (packets["id"] > 0) & (packets["check"] > 0) | (packets["retry"] > 0)
    columns = code[repeated], time[packets["frame"]], packets["view"], identified, packets["frame"]
    rows = zip(*(column.tolist() for column in columns), strict=True)
    duplicates = np.zeros(len(time), bool)
    last_packet, since, last_view = -1, 0, 0
    for packet, when, view, is_identified, frame in rows:
        in_time = packet == last_packet and when - since <= SEEN_AGAIN_WITHIN
        if in_time and (view != last_view or is_identified):
            duplicates[frame] = True
        else:
            last_packet, since, last_view = packet, when, view
    note(notes, duplicates, AGAIN)
    return duplicates
