"""Turn captured packets into UDP datagrams and TCP segments, and find duplicate packets."""

from collections import defaultdict
from dataclasses import dataclass, field
from functools import partial
from itertools import accumulate

import numpy as np

from discostorm_capture import ip, link_layer, network_events
from discostorm_capture._arrays import IdTable, concat, factorize, numbers_at, take_rows
from discostorm_capture._types import PADDING, Array, Bytes, Columns, Notes
from discostorm_capture.pcap import Packets

MISSING_FRAGMENTS_NOTE = "IP datagrams lack fragments"
#: Maximum time between fragments of a datagram [ns]; RFC 791 says 15 s, RFC 8200 60 s.
REASSEMBLY_TIMEOUT = 60_000_000_000
#: Maximum number of incomplete datagrams with the same id.
_MAX_PENDING = 16
_MAX_DATAGRAM_BYTES = 0xFFFF
#: Maximum time between two captures of one packet, as at two interfaces or hops [ns].
MAX_DUPLICATE_DELAY = 1_000_000_000
TUNNELS_NOTE = "packets in a tunnel (GRE, IP in IP, VXLAN, Geneve), which are not read"
COPIES_NOTE = "packets are copies (another interface or path, or mirrored); they are not compared"


@dataclass(frozen=True)
class IpContent:
    """The datagrams, segments and ARP or ICMP events of a capture, in the order of its packets."""

    #: The bytes of the file and of reassembled datagrams, and padding.
    data: Bytes
    addresses: IdTable
    #: The tables of `ip.udp_datagrams` and `ip.tcp_segments`.
    datagrams: Columns
    segments: Columns
    #: A table of the module `network_events`.
    network_events: Columns
    #: Number of "ARP", "UDP", "TCP" and "other" packets.
    packets: dict[str, int]


def parse_transport(packets: Packets, notes: Notes) -> IpContent:
    """Return the datagrams, segments and events in packets; note unreadable packets."""
    data, addresses = packets.data, IdTable()
    network = link_layer.ip_and_arp_packets(packets, notes)
    arp = network_events.arp_events(data, network, addresses)
    network = take_rows(network, network["ethertype"] != link_layer.ARP)
    network = ip.parse_ip(data, network, addresses, notes)
    data, network, broken = reassemble(data, network, packets.table["time"], notes)
    datagrams, segments = ip.udp_datagrams(data, network), ip.tcp_segments(data, network)
    notes.add_where(network["protocol"] == ip.IPSEC_ESP, "encrypted IP packets")
    notes.add_where(np.isin(network["protocol"], ip.TUNNEL_PROTOCOLS), TUNNELS_NOTE)
    notes.add_where(np.isin(datagrams["to_port"], ip.TUNNEL_PORTS), TUNNELS_NOTE)
    icmp = network_events.icmp_unreachable_events(data, network, addresses)
    start = packets.table["time"].min(initial=0)
    pings = network_events.echo_jitter(data, network, (packets.table["time"] - start) * 1e-9)
    own = network_events.own_addresses(network)
    events = concat(arp, icmp, network_events.icmp_echoes(data, network), pings, broken, own)
    counts = {"ARP": len(arp["frame"])} | {
        name: int(network["parts"][network["protocol"] == protocol].sum())
        for name, protocol in (("UDP", ip.UDP), ("TCP", ip.TCP))
    }
    counts["other"] = len(packets.table["at"]) - sum(counts.values())
    return IpContent(data, addresses, datagrams, segments, events, counts)


def note_encrypted_datagrams(data: Bytes, datagrams: Columns, notes: Notes) -> None:
    """Count datagrams that look like DTLS, QUIC or WireGuard."""
    at, size = datagrams["at"], datagrams["size"]
    first = data[at]
    dtls = (first >= 20) & (first <= 25) & (numbers_at(data, at + 1, ">u2") >= 0xFEFC) & (size > 12)
    quic = (first >= 0xC0) & (numbers_at(data, at + 1, ">u4") == 1) & (size > 20)
    ends = (datagrams[end] == ip.WIREGUARD_PORT for end in ("from_port", "to_port"))
    guard = np.logical_or(*ends)
    guard &= numbers_at(data, at, "<u4") - np.uint32(1) < 4
    for name, mask in (("DTLS", dtls), ("QUIC", quic), ("WireGuard", guard)):
        notes.add_where(mask, f"datagrams of {name}, which are encrypted")


def find_duplicate_frames(transport: IpContent, time: Array, notes: Notes) -> Array:
    """Return whether each frame repeats an earlier one, as from a mirror port or a merged file.

    Senders do not reuse an IP id so soon (RFC 6864, 4.1).
    """
    keys = ("source", "target", "from_port", "to_port", "id", "wire", "check")
    names = (*keys, "at", "size", "frame", "capture_point", "is_retry")
    tables = transport.datagrams, transport.segments
    packets = concat(*({name: table[name] for name in names} for table in tables))
    # This cannot run out of bytes: a header of at least eight precedes the payload.
    packets["tail"] = numbers_at(transport.data, packets["at"] + packets["size"] - 8, "=u8")
    code, _ = factorize(*(packets[key] for key in (*keys, "tail")))
    repeated = np.flatnonzero(np.bincount(code)[code] > 1)
    repeated = repeated[np.lexsort((packets["frame"][repeated], code[repeated]))]
    packets = take_rows(packets, repeated)
    # Without an IP id a repeated packet may be a new one; an 802.11 retry never is.
    identified = (packets["id"] > 0) & (packets["check"] > 0) | (packets["is_retry"] > 0)
    frame = packets["frame"]
    columns = code[repeated], time[frame], packets["capture_point"], identified, frame
    rows = zip(*(column.tolist() for column in columns), strict=True)
    duplicates = np.zeros(len(time), bool)
    last_packet, since, last_view = -1, 0, 0
    for packet, when, view, is_identified, frame in rows:
        in_time = packet == last_packet and when - since <= MAX_DUPLICATE_DELAY
        if in_time and (view != last_view or is_identified):
            duplicates[frame] = True
        else:
            last_packet, since, last_view = packet, when, view
    notes.add_where(duplicates, COPIES_NOTE)
    return duplicates


@dataclass
class _PendingDatagram:
    """A datagram in reassembly: rows by offset, length (0 if unknown) and bytes so far."""

    first_time: int
    rows: dict[int, int] = field(default_factory=dict)
    length: int = 0
    received_bytes: int = 0


def reassemble(
    data: Bytes, packets: Columns, time: Array, notes: Notes
) -> tuple[Bytes, Columns, Columns]:
    """Replace fragments by datagrams; return the extended bytes, the packets, and events.

    The events are the datagrams that lack fragments. A datagram gets the frame that completed it,
    and ``parts``, the number of its frames. A first fragment that the capture truncates stays, to
    be read as far as it goes.
    """
    is_fragment = (packets["offset"] > 0) | packets["more"]
    if not is_fragment.any():
        return data, packets, network_events.incomplete_datagrams(packets, np.array([], np.int64))
    truncated = packets["end"] - packets["at"] < packets["wire"]
    valid = (packets["wire"] > 0) & (packets["offset"] + packets["wire"] <= _MAX_DATAGRAM_BYTES)
    fragments = take_rows(packets, is_fragment & ~truncated & valid)
    rest = take_rows(packets, ~is_fragment | (truncated & (packets["offset"] == 0)))
    made, broken = _complete_datagrams(data, fragments, time)
    notes.add_where(broken >= 0, MISSING_FRAGMENTS_NOTE)
    content, starts, ends = data.data, fragments["at"].tolist(), fragments["end"].tolist()
    parts = [content]
    for datagram in made:
        rows = [row for _, row in sorted(datagram.rows.items())]
        parts += [content[starts[row] : ends[row]] for row in rows]
    last = np.array([next(reversed(one.rows.values())) for one in made], np.int64)
    wire = np.array([one.length for one in made], np.int64)
    end = len(data) + np.cumsum(wire)
    joined = take_rows(fragments, last) | {"at": end - wire, "end": end, "wire": wire}
    joined["parts"] = np.array([len(one.rows) for one in made], np.int32)
    replaced = concat(rest, joined)
    replaced = take_rows(replaced, np.argsort(replaced["frame"], kind="stable"))
    events = network_events.incomplete_datagrams(fragments, broken)
    return np.frombuffer(b"".join([*parts, bytes(PADDING)]), np.uint8), replaced, events


def _complete_datagrams(
    data: Bytes, fragments: Columns, time: Array
) -> tuple[list[_PendingDatagram], Array]:
    """Return the datagrams with all fragments, and the first row of each of the others."""
    pending: dict[tuple[int, ...], list[_PendingDatagram]] = defaultdict(list)
    complete, incomplete = [], []
    keys = ("source", "target", "protocol", "id", "capture_point")
    columns = (fragments[name].tolist() for name in (*keys, "offset", "wire", "more"))
    times, lengths = time[fragments["frame"]].tolist(), fragments["wire"].tolist()
    for row, (*key, offset, length, more) in enumerate(zip(*columns, strict=True)):
        waiting = pending[tuple(key)]
        while waiting and (
            times[row] - waiting[0].first_time > REASSEMBLY_TIMEOUT or len(waiting) > _MAX_PENDING
        ):
            incomplete.append(waiting.pop(0))
        # A second copy of a fragment starts another datagram with the same id: a packet that the
        # capture shows twice counts twice, whether it is fragmented or not.
        datagram = next((one for one in waiting if offset not in one.rows), None)
        if datagram is None:
            waiting.append(datagram := _PendingDatagram(times[row]))
        datagram.rows[offset] = row
        datagram.received_bytes += length
        if not more:
            datagram.length = offset + length
        if datagram.received_bytes != datagram.length:
            continue
        # Datagrams with overlapping fragments are dropped, as in Linux (RFC 5722).
        offsets, rows = zip(*sorted(datagram.rows.items()), strict=True)
        if [*offsets] == [*accumulate((lengths[row] for row in rows), initial=0)][:-1]:
            waiting.remove(datagram)
            complete.append(datagram)
    incomplete += [datagram for waiting in pending.values() for datagram in waiting]
    identities = partial(_fragment_identities, data, fragments)
    # All fragments of an incomplete datagram may repeat those of complete ones.
    used = set().union(*map(identities, complete if incomplete else ()))
    first_rows = {identities(one): next(iter(one.rows.values())) for one in incomplete}
    missing = sorted(row for identity, row in first_rows.items() if not identity <= used)
    return complete, np.array(missing, np.int64)


def _fragment_identities(
    data: Bytes, fragments: Columns, datagram: _PendingDatagram
) -> frozenset[tuple[object, ...]]:
    """Return what identifies each fragment of a datagram: addresses, id, offset and bytes."""
    return frozenset(
        (*(int(fragments[name][row]) for name in ("source", "target", "id", "offset")), content)
        for row in datagram.rows.values()
        for content in [data[fragments["at"][row] : fragments["end"][row]].tobytes()]
    )
