"""What is gathered while a file is read: messages of RTPS, and what Zenoh's are read from."""

from collections import Counter

import numpy as np

from discostorm_capture import fragments, ip, link, network_events, pcap, rtps, tcp
from discostorm_capture._bytes import Bytes, Columns, Numbers, codes, number, stack, take

RTPS, ZENOH, TCP = range(3)
PROTOCOLS = ("RTPS", "Zenoh", "TCP")
#: What a file lacks of what was sent, as notes call it.
LACKS = (fragments.MISSING, tcp.GAPS)


class KnownProcess:
    """What is known of a process; more becomes known while a file is read."""

    def __init__(self, protocol: int, name: str, product: str = "") -> None:
        self.protocol, self.name, self.product = protocol, name, product
        #: The number of its address, and the frame it was seen in first; -1 if not known.
        self.host = self.since = -1
        self.endpoints: set[int] = set()
        self.tokens = 0
        #: Whether it announced anything, and whether it is a server or router of others.
        self.announced = self.serves = False
        #: Its domain, -1 if not known, and the numbers of the addresses that it announces.
        self.domain = -1
        self.told: list[int] = []


class Gathered:
    """What is gathered while a file is read."""

    def __init__(self, packets: pcap.Packets) -> None:
        self.packets = packets
        #: What could not be read, and how often.
        self.notes: Counter[str] = Counter()
        #: The numbers of addresses, and of the GUID prefixes of RTPS.
        self.addresses, self.prefixes = Numbers(), Numbers()
        #: By the number of the prefix; of Zenoh by numbers from -2 down.
        self.processes: dict[int, KnownProcess] = {}
        #: The messages that were read.
        self.rows: list[Columns] = []
        #: What may be Zenoh: datagrams, and where their bytes are; segments of TCP.
        self.datagrams: list[tuple[Bytes, Columns]] = []
        self.segments: list[Columns] = []
        #: Fragments of IP.
        self.pieces: list[Columns] = []
        #: What says who is asked for, and what could not be delivered: see `asides`.
        self.asides: list[Columns] = []
        #: What tells packets that the capture shows twice.
        self.sights: list[Columns] = []
        self.loopback: list[bool] = []
        #: How many packets are of UDP and of TCP.
        self.mix: Counter[str] = Counter()
        #: Which process is in which domain.
        self.domains: set[tuple[int, int]] = set()

    def packets_of(self, begin: int, end: int) -> None:
        """Read the packets of a part of the file."""
        table = take(self.packets.table, slice(begin, end))
        table["frame"] = np.arange(begin, begin + len(table["at"]))
        kinds = np.array(self.packets.links, np.int64)[table["interface"]]
        for kind in np.unique(kinds).tolist():
            mine = table if (kinds == kind).all() else take(table, kinds == kind)
            self.asides.append(network_events.arp(self.packets.data, mine, kind, self.addresses))
            found = link.ip_packets(self.packets.data, mine, kind, self.notes)
            found = ip.parse(self.packets.data, found, self.addresses, self.notes)
            found["parts"] = np.ones(len(found["at"]), np.int32)
            piece = ip.is_piece(found)
            if piece.any():
                # What was cut cannot be put together; the first one is read as far as it goes.
                cut = found["end"] - found["at"] < found["wire"]
                self.pieces.append(take(found, piece & ~cut))
                found = take(found, ~piece | (cut & (found["offset"] == 0)))
            self.transport(self.packets.data, found)

    def transport(self, data: Bytes, found: Columns) -> None:
        """Read what whole IP packets carry."""
        datagrams = ip.datagrams(data, found)
        self.asides.append(network_events.unreachable(data, found, self.addresses))
        for name, number_ in (("UDP", ip.UDP), ("TCP", ip.TCP)):
            mine = found["protocol"] == number_
            whole = data is self.packets.data
            self.mix[name] += int(np.count_nonzero(mine) if whole else found["parts"][mine].sum())
        if encrypted := int((found["protocol"] == ip.ENCRYPTED).sum()):
            self.notes["encrypted IP packets"] += encrypted
        tunnels = int(np.isin(found["protocol"], ip.TUNNELS).sum())
        if tunnels := tunnels + int(np.isin(datagrams["to_port"], ip.TUNNEL_PORTS).sum()):
            self.notes[
                "packets in a tunnel (GRE, IP in IP, VXLAN, Geneve), which are not read"
            ] += tunnels
        self.see(data, datagrams)
        is_rtps = rtps.starts(data, datagrams["at"]) & (datagrams["size"] >= 4)
        self.rtps(data, take(datagrams, is_rtps))
        if not is_rtps.all():
            others = take(datagrams, ~is_rtps)
            self.note_encrypted(data, others)
            self.datagrams.append((data, _kept(others, "parts")))
        segments = ip.segments(data, found)
        if not len(segments["at"]):
            return
        if data is not self.packets.data:
            self.notes["TCP segments in IP fragments"] += len(segments["at"])
            return
        self.see(data, segments)
        tunneled = rtps.over_tcp(data, segments["at"]) & (segments["size"] >= 4)
        if count := int(np.count_nonzero(tunneled)):
            self.notes["TCP segments with RTPS over TCP"] += count
        self.segments.append(_kept(segments, "sequence", "flags"))

    def note_encrypted(self, data: Bytes, found: Columns) -> None:
        """Count what looks like DTLS, QUIC or WireGuard."""
        at, size = found["at"], found["size"]
        first = data[at]
        dtls = (first >= 20) & (first <= 25) & (number(data, at + 1, ">u2") >= 0xFEFC) & (size > 12)
        quic = (first >= 0xC0) & (number(data, at + 1, ">u4") == 1) & (size > 20)
        guard = (found["from_port"] == ip.WIREGUARD_PORT) | (found["to_port"] == ip.WIREGUARD_PORT)
        guard &= number(data, at, "<u4") - np.uint32(1) < 4
        for name, mask in (("DTLS", dtls), ("QUIC", quic), ("WireGuard", guard)):
            if count := int(np.count_nonzero(mask)):
                self.notes[f"datagrams of {name}, which are encrypted"] += count

    def see(self, data: Bytes, found: Columns) -> None:
        """Keep what tells whether a packet was seen before."""
        if len(found["at"]):
            # There are at least eight bytes of a header in front of an empty payload.
            tail = number(data, found["at"] + found["size"] - 8, "=u8")
            keys = ("source", "target", "from_port", "to_port", "id", "wire", "check")
            self.sights.append(
                {key: found[key] for key in (*keys, "frame", "view", "retry")} | {"tail": tail}
            )

    def rtps(self, data: Bytes, found: Columns) -> None:
        """Read RTPS datagrams."""
        if not len(found["at"]):
            return
        messages, announced = rtps.messages(data, found, self.prefixes, self.notes)
        datagram = messages.pop("datagram")
        frame, wire = found["frame"][datagram], found["wire"][datagram]
        self.rows.append(
            messages
            | {
                "frame": frame.astype(np.int32),
                "protocol": np.full(len(frame), RTPS, np.uint8),
                "kind": messages["kind"].astype(np.uint16),
                "source": found["source"][datagram],
                "target": found["target"][datagram],
                "way": found["way"][datagram],
                "udp": np.ones(len(frame), bool),
                "frames": found["parts"][datagram]
                * (messages["bytes"] / np.maximum(wire, 1)).astype(np.float32),
            }
        )
        to_all = ip.multicast(self.addresses)[found["target"][datagram]]
        self.domains |= rtps.domains(
            messages["process"][to_all],
            messages["kind"][to_all],
            found["to_port"][datagram[to_all]],
        )
        _, first = codes(messages["process"], found["source"][datagram])
        for row in first.tolist():
            at = int(found["at"][datagram[row]])
            self.saw(
                int(messages["process"][row]),
                int(found["source"][datagram[row]]),
                int(frame[row]),
                int(data[at + 6]) << 8 | int(data[at + 7]),
            )
        self.announced(data, found, announced)

    def note_domains(self) -> None:
        """Say of which domains there are messages, if not of one alone."""
        for process, domain in sorted(self.domains):
            self.processes[process].domain = domain
        domains = sorted({domain for _, domain in self.domains})
        if (count := len(domains)) > 1:
            which = ", ".join(map(str, domains))
            self.notes[
                f"domains of RTPS ({which}): only processes of the same one find each other, which "
                "the fleet does not know"
            ] = count

    def saw(self, prefix: int, source: int, frame: int, vendor: int) -> None:
        """Keep where and when a process was seen first."""
        process = self.processes.get(prefix)
        if process is None:
            process = self.processes[prefix] = KnownProcess(RTPS, "")
        if process.since < 0:
            process.since = frame
            process.product = rtps.VENDORS.get(vendor, f"vendor 0x{vendor:04x}")
        if process.host < 0 or self.is_loopback(process.host):
            process.host = source

    def is_loopback(self, address: int) -> bool:
        """Return whether an address is of a host's own loopback."""
        if address >= len(self.loopback):
            self.loopback = ip.loopback(self.addresses).tolist()
        return self.loopback[address]

    def announced(self, data: Bytes, found: Columns, announced: Columns) -> None:
        """Keep what is announced of participants and endpoints."""
        announced = take(announced, announced["guid"] > 0)
        guid = announced["guid"]
        if not len(guid):
            return
        prefix = self.prefixes.of(data, guid, 12)
        entity = number(data, guid + 12, ">u4").astype(np.int64)
        address, first = np.full(len(guid), -1), np.full(len(guid), -1)
        for known, key in ((address, "address"), (first, "first_address")):
            told = np.flatnonzero(announced[key] > 0)
            known[told] = self.addresses.of(data, announced[key][told], 4)
        for which, id_, spdp, serves, sender, where, begin, datagram in zip(
            prefix.tolist(),
            entity.tolist(),
            announced["spdp"].tolist(),
            rtps.serves(data, announced).tolist(),
            announced["sender"].tolist(),
            address.tolist(),
            first.tolist(),
            announced["datagram"].tolist(),
            strict=True,
        ):
            process = self.processes.get(which)
            if process is None:
                process = self.processes[which] = KnownProcess(RTPS, "")
            process.announced = True
            process.serves |= serves
            if not spdp:
                process.endpoints.add(id_)
                continue
            if which == sender:
                process.told += [one for one in (begin, where) if one not in process.told]
            if which != sender and process.host < 0:
                process.host = where  # somebody else tells of it
                process.since = int(found["frame"][datagram])

    @property
    def cut(self) -> int:
        """How many packets were cut when they were captured."""
        packets = self.packets.table
        return int(np.count_nonzero(packets["size"] < packets["length"]))

    def lost(self) -> list[str]:
        """Return what the file lacks of what was sent, so that it cannot be read."""
        cut = f"{self.cut} packets were cut when they were captured (snaplen)"
        lost = [cut] if self.cut else []
        return lost + [f"{n} {what}" for what, n in self.notes.items() if what in LACKS]

    def fragments(self) -> None:
        """Read what IP fragments make."""
        if self.pieces:
            pieces = stack(self.pieces)
            self.pieces = []
            data, made = fragments.put_together(
                pieces, self.packets.data, self.packets.table["time"], self.notes
            )
            self.transport(data, made)


def _kept(found: Columns, *more: str) -> Columns:
    """Return what is still needed of datagrams or segments, as small as it can be."""
    small = ("frame", "size", "wire", "from_port", "to_port")
    return {name: found[name].astype(np.int32) for name in small} | {
        name: found[name] for name in ("at", "source", "target", "way", *more)
    }
