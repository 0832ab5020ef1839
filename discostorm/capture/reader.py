"""From a file to the table of its messages."""

from collections import Counter
from dataclasses import dataclass
from os import PathLike
from typing import Any, BinaryIO

import numpy as np

from discostorm.capture import files, ip, link, rtps, tcp, zenoh
from discostorm.capture._bytes import (
    Array,
    Bytes,
    Columns,
    Numbers,
    buffer,
    codes,
    number,
    stack,
    take,
)

#: Packets read at a time, so that what is computed on the way stays small.
_AT_A_TIME = 1 << 15
#: What is seen twice is seen within this time [ns]: on several interfaces, or up and down.
_TWICE = 1_000_000_000
RTPS, ZENOH, TCP = range(3)
PROTOCOLS = ("RTPS", "Zenoh", "TCP")
WAYS = ("", "up", "down")
#: Segments of Zenoh's connections that carry no message of their own.
TCP_KINDS = ("TCP ACK", "TCP control", "TCP retransmission")
_ACK, _CONTROL, _AGAIN = range(3)
HTTPS = 443


class Process:
    """What is known of a process; more becomes known while a file is read."""

    def __init__(self, protocol: int, name: str, product: str = "") -> None:
        self.protocol, self.name, self.product = protocol, name, product
        #: The number of its address, and the frame it was seen in first; -1 if not known.
        self.host = self.since = -1
        self.endpoints: set[int] = set()
        self.tokens = 0
        self.announced = False


@dataclass(frozen=True)
class Reading:
    """All that a file told: messages as columns, names of their numbers, processes, notes."""

    name: str
    rows: Columns
    time: Array
    addresses: Numbers
    processes: list[Process]
    notes: Counter[str]
    packets: int
    cut: int


class _Reader:
    """What is gathered while a file is read."""

    def __init__(self, packets: files.Packets) -> None:
        self.packets = packets
        self.notes: Counter[str] = Counter()
        self.addresses, self.prefixes = Numbers(), Numbers()
        self.processes: dict[int, Process] = {}
        self.rows: list[Columns] = []
        self.datagrams: list[tuple[Bytes, Columns]] = []
        self.segments: list[Columns] = []
        self.pieces: list[Columns] = []
        self.sights: list[Columns] = []
        self.loopback: list[bool] = []
        self.domains: set[int] = set()
        self.several = (
            len(set(packets.links)) > 1
            or len(packets.links) > 1
            or any(link.LINKS.get(kind) in link.SEVERAL_VIEWS for kind in packets.links)
        )

    def packets_of(self, begin: int, end: int) -> None:
        """Read the packets of a part of the file."""
        table = take(self.packets.table, slice(begin, end))
        table["frame"] = np.arange(begin, begin + len(table["at"]))
        kinds = np.array(self.packets.links, np.int64)[table["interface"]]
        for kind in np.unique(kinds).tolist():
            mine = table if (kinds == kind).all() else take(table, kinds == kind)
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
        """Keep what tells whether a packet was seen before, if it may be seen twice."""
        if self.several and len(found["at"]):
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
        self.domains |= rtps.domains(messages["kind"][to_all], found["to_port"][datagram[to_all]])
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

    def saw(self, prefix: int, source: int, frame: int, vendor: int) -> None:
        """Keep where and when a process was seen first."""
        process = self.processes.get(prefix)
        if process is None:
            process = self.processes[prefix] = Process(RTPS, "")
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
        address = np.full(len(guid), -1)
        told = np.flatnonzero(announced["address"] > 0)
        address[told] = self.addresses.of(data, announced["address"][told], 4)
        for which, id_, spdp, sender, where, datagram in zip(
            prefix.tolist(),
            entity.tolist(),
            announced["spdp"].tolist(),
            announced["sender"].tolist(),
            address.tolist(),
            announced["datagram"].tolist(),
            strict=True,
        ):
            process = self.processes.get(which)
            if process is None:
                process = self.processes[which] = Process(RTPS, "")
            process.announced = True
            if not spdp:
                process.endpoints.add(id_)
            elif which != sender and process.host < 0:
                process.host = where  # somebody else tells of it
                process.since = int(found["frame"][datagram])

    def fragments(self) -> None:
        """Read what IP fragments make."""
        if self.pieces:
            pieces = stack(self.pieces)
            self.pieces = []
            data, made = ip.put_together(
                pieces, self.packets.data, self.packets.table["time"], self.notes
            )
            self.transport(data, made)


def _kept(found: Columns, *more: str) -> Columns:
    """Return what is still needed of datagrams or segments, as small as it can be."""
    small = ("frame", "size", "wire", "from_port", "to_port")
    return {name: found[name].astype(np.int32) for name in small} | {
        name: found[name] for name in ("at", "source", "target", "way", *more)
    }


def read(path: str | PathLike[str] | BinaryIO) -> Reading:
    """Return what a file tells; see `discostorm.read_capture`."""
    packets = files.read(path)
    reader = _Reader(packets)
    size = len(packets.table["at"])
    for begin in range(0, size, _AT_A_TIME):
        reader.packets_of(begin, min(begin + _AT_A_TIME, size))
    reader.fragments()
    if (count := len(reader.domains)) > 1:
        which = ", ".join(map(str, sorted(reader.domains)))
        reader.notes[
            f"domains of RTPS ({which}): only processes of the same one find each other, which "
            "the fleet does not know"
        ] = count
    copies = _copies(reader, size)
    _read_zenoh(reader, copies)
    cut = int(np.count_nonzero(packets.table["size"] < packets.table["length"]))
    time = packets.table["time"]
    parts = [*reader.rows, _no_rows()]
    reader.rows = []
    rows = stack([_complete(parts.pop(0)) for _ in range(len(parts))])
    rows["copy"] = copies[rows["frame"]]
    order = np.argsort(rows["frame"], kind="stable")
    for name in list(rows):
        rows[name] = rows[name][order]
    processes = _processes(reader, rows)
    return Reading(packets.name, rows, time, reader.addresses, processes, reader.notes, size, cut)


#: The columns of messages and their types.
_TYPES: dict[str, Any] = {
    "frame": np.int32,
    "protocol": np.uint8,
    "kind": np.uint16,
    "submessage": np.uint8,
    "entity": np.uint8,
    "size": np.int32,
    "reader": np.uint32,
    "writer": np.uint32,
    "bytes": np.int32,
    "process": np.int32,
    "peer": np.int32,
    "source": np.int32,
    "target": np.int32,
    "way": np.uint8,
    "udp": bool,
    "ends": bool,
    "frames": np.float32,
}


def _complete(part: Columns) -> Columns:
    """Return all columns of messages; what a part lacks is 0, of processes -1."""
    size = len(part["frame"])
    return {
        name: part[name].astype(kind, copy=False)
        if name in part
        else np.full(size, -1 if name in ("process", "peer") else 0, kind)
        for name, kind in _TYPES.items()
    }


def _no_rows() -> Columns:
    return {name: np.zeros(0, kind) for name, kind in _TYPES.items()}


def _copies(reader: _Reader, size: int) -> Array:
    """Return of each frame whether it shows what another one showed before."""
    copies = np.zeros(size, bool)
    if not reader.sights:
        return copies
    sights = stack(reader.sights)
    reader.sights = []
    keys = ("source", "target", "from_port", "to_port", "id", "wire", "check", "tail")
    code, _ = codes(*(sights[key] for key in keys))
    many = np.flatnonzero(np.bincount(code)[code] > 1)
    order = many[np.lexsort((sights["frame"][many], code[many]))]
    group, view, frame = code[order], sights["view"][order], sights["frame"][order]
    time, retry = reader.packets.table["time"][frame], sights["retry"][order]
    now, since, place = -1, 0, 0
    for which, when, where, again, number_ in zip(
        group.tolist(), time.tolist(), view.tolist(), retry.tolist(), frame.tolist(), strict=True
    ):
        same = which == now and when - since <= _TWICE and (where != place or again)
        if same:
            copies[number_] = True
        else:
            now, since, place = which, when, where
    if count := int(np.count_nonzero(copies)):
        reader.notes["packets seen again, on another interface or way; they are not compared"] += (
            count
        )
    return copies


# ---------------------------------------------------------------- Zenoh


def _read_zenoh(reader: _Reader, copies: Array) -> None:
    """Read the datagrams and streams of Zenoh."""
    known: dict[bytes, int] = {}
    for data, found in reader.datagrams:
        _read_datagrams(reader, data, found, known)
    reader.datagrams = []
    if reader.segments:
        parts, reader.segments = reader.segments, []
        streams = tcp.streams([take(part, ~copies[part["frame"]]) for part in parts])
        del parts
        _read_streams(reader, streams, known)


def _process(reader: _Reader, known: dict[bytes, int], zid: bytes, role: int) -> int:
    """Return the number of a process of Zenoh; numbers of both protocols differ."""
    which = known.setdefault(zid, -2 - len(known))
    role_name = ("router", "peer", "client", "")[role & 3]
    # As Zenoh writes it.
    name = f"{int.from_bytes(zid, 'little'):x}"
    reader.processes.setdefault(which, Process(ZENOH, name, f"Zenoh {role_name}".strip()))
    return which


def _zenoh_saw(reader: _Reader, which: int, source: int, frame: int) -> None:
    process = reader.processes[which]
    if process.since < 0 or frame < process.since:
        process.since = frame
    if process.host < 0 or reader.is_loopback(process.host):
        process.host = source


def _read_datagrams(reader: _Reader, data: Bytes, found: Columns, known: dict[bytes, int]) -> None:
    """Read scouting, and sessions over UDP."""
    group = ip.multicast(reader.addresses)[found["target"]]
    to_all = group | (found["to_port"] == zenoh.SCOUTING_PORT)
    code, identity = zenoh.scouting(data, found["at"], found["size"], to_all)
    is_scouting = code != zenoh.UNREADABLE
    rows = np.flatnonzero(is_scouting)
    process = np.full(len(rows), -1, np.int64)
    told = np.flatnonzero(identity["length"][rows] > 0)
    if len(told):
        place, length = (identity[key][rows[told]] for key in ("at", "length"))
        # In sixteen bytes each, with zeros behind those that are shorter.
        zids = buffer(16 * len(told))
        matrix = zids[: 16 * len(told)].reshape(-1, 16)
        octet = np.arange(16)
        matrix[:] = data[place[:, None] + octet] * (octet < length[:, None])
        numbers = Numbers()
        which = numbers.of(zids, 16 * np.arange(len(told)), 16)
        _, first = codes(which, found["source"][rows[told]])
        role = data[identity["at"][rows[told]] - 1] & 3
        ours = np.zeros(len(numbers.known), np.int64)
        for index in first.tolist():
            row = rows[told[index]]
            zid = matrix[index, : length[index]].tobytes()
            # A Scout does not say what sends it.
            is_hello = zenoh.NAMES[code[row]] == "Hello"
            ours[which[index]] = _process(reader, known, zid, int(role[index]) if is_hello else 3)
            _zenoh_saw(
                reader, int(ours[which[index]]), int(found["source"][row]), int(found["frame"][row])
            )
        process[told] = ours[which]
    reader.rows.append(
        {
            "frame": found["frame"][rows],
            "protocol": np.full(len(rows), ZENOH, np.uint8),
            "kind": code[rows],
            "submessage": code[rows],
            "bytes": found["wire"][rows],
            "process": process,
            "source": found["source"][rows],
            "target": found["target"][rows],
            "way": found["way"][rows],
            "udp": np.ones(len(rows), bool),
            "frames": found["parts"][rows],
        }
    )
    _read_udp_sessions(reader, data, take(found, ~is_scouting))


def _read_udp_sessions(reader: _Reader, data: Bytes, found: Columns) -> None:
    opening = np.flatnonzero(zenoh.may_open(data, found["at"], found["size"]))
    if not len(opening):
        return
    at = found["at"]
    end = at + found["size"]
    first = zenoh.parse(data, at[opening], end[opening])
    whole = np.zeros(len(opening), bool)
    whole[first["batch"][first["end"] == end[opening][first["batch"]]]] = True
    whole[first["batch"][first["code"] == zenoh.UNREADABLE]] = False
    ends = [found[key].astype(np.int64) for key in ("source", "target", "from_port", "to_port")]
    there, back = ends[0] << 32 | ends[2], ends[1] << 32 | ends[3]
    flows = set(zip(there[opening[whole]].tolist(), back[opening[whole]].tolist(), strict=True))
    flows |= {(b, a) for a, b in flows}
    mine = np.array(
        [pair in flows for pair in zip(there.tolist(), back.tolist(), strict=True)], bool
    )
    # A group that is joined is spoken to by all.
    groups = {b for _, b in flows}
    is_group = ip.multicast(reader.addresses)[found["target"]]
    mine |= is_group & np.isin(back, list(groups))
    found = take(found, mine)
    at = found["at"]
    messages = zenoh.parse(data, at, at + found["size"])
    batch = messages["batch"]
    size = messages["end"] - messages["at"]
    reader.rows.append(
        {
            "frame": found["frame"][batch],
            "protocol": np.full(len(batch), ZENOH, np.uint8),
            "kind": messages["code"],
            "submessage": messages["code"],
            "bytes": size,
            "source": found["source"][batch],
            "target": found["target"][batch],
            "way": found["way"][batch],
            "udp": np.ones(len(batch), bool),
            "frames": found["parts"][batch] * size / np.maximum(found["wire"][batch], 1),
        }
    )


def _read_streams(reader: _Reader, streams: tcp.Streams, known: dict[bytes, int]) -> None:
    """Read sessions over TCP."""
    data = reader.packets.data
    _note_tls(reader, data, streams)
    chosen = zenoh.chosen(data, streams)
    if len(others := zenoh.undecided(streams, chosen)):
        begun = list(zenoh.sessions(tcp.content(data, streams, others)))
        chosen = np.union1d(chosen, [*begun, *streams.reverse[begun]]).astype(np.int64)
    if not len(chosen):
        return
    content = tcp.content(data, streams, chosen)
    opened = zenoh.sessions(content)
    table = streams.table
    process = np.full(len(streams.first), -1, np.int64)
    for of, session in opened.items():
        row = streams.first[of]
        process[of] = _process(reader, known, session.zid, session.role)
        _zenoh_saw(reader, int(process[of]), int(table["source"][row]), int(table["frame"][row]))
    batches = zenoh.batches(content, streams, opened, reader.notes)
    found = zenoh.parse(content.data, batches["at"], batches["end"])
    if unreadable := int(np.count_nonzero(found["code"] == zenoh.UNREADABLE)):
        reader.notes["batches of Zenoh that cannot be read to their end"] += unreadable
    stream = batches["stream"][found["batch"]]
    # The length in front of a batch goes with its first message.
    first = np.diff(found["batch"], prepend=-1) != 0
    begin = found["at"] - 2 * first
    cost = _cost(content, table)
    piece = np.searchsorted(content.pieces["at"], found["end"] - 1, side="right") - 1
    done = content.pieces["done"][piece] if len(piece) else piece
    rows: Columns = {
        "frame": table["frame"][done],
        "protocol": np.full(len(done), ZENOH, np.uint8),
        "kind": found["code"],
        "submessage": found["code"],
        "bytes": found["end"] - begin,
        "frames": cost(found["end"]) - cost(begin),
        **_ends(table, streams.first[stream], process[stream], process[streams.reverse[stream]]),
    }
    rows["way"] = table["way"][done]
    number_ = found["number"]
    made, members = zenoh.put_together(content.data, found, stream, reader.notes)
    if made:
        inner, extra, number_2, stream_2 = _from_fragments(
            reader, made, members, found, rows, stream
        )
        rows = stack([rows, inner])
        number_ = np.append(number_, number_2)
        stream = np.append(stream, stream_2)
        texts = extra
    else:
        texts = {}
    reader.rows.append(rows)
    _zenoh_endpoints(reader, content, found, rows["submessage"], number_, stream, process, texts)
    _other_segments(reader, content, streams, chosen, process)


def _ends(table: Columns, row: Array, process: Array, peer: Array) -> Columns:
    """Return the columns that say who speaks to whom, by a segment's row."""
    return {
        "source": table["source"][row],
        "target": table["target"][row],
        "process": process,
        "peer": peer,
    }


def _cost(content: tcp.Content, table: Columns) -> Any:
    """Return the function that says how many segments it took up to a byte of the content."""
    pieces = content.pieces
    part = pieces["size"] / np.maximum(table["wire"][pieces["segment"]], 1)
    places = np.append(pieces["at"], pieces["at"][-1:] + pieces["size"][-1:])
    sums = np.append(0.0, np.cumsum(part))[: len(places)]

    def cost(at: Array) -> Array:
        return np.interp(at, places, sums) if len(places) else np.zeros(len(at))

    return cost


def _from_fragments(
    reader: _Reader,
    made: list[bytes],
    members: list[list[int]],
    found: Columns,
    rows: Columns,
    stream: Array,
) -> tuple[Columns, dict[int, bytes], Array, Array]:
    """Return the messages that fragments make; the bytes of fragments go to them."""
    length = np.array([len(part) for part in made], np.int64)
    end = np.cumsum(length)
    joined = np.frombuffer(b"".join(made) + bytes(64), np.uint8)
    inner = zenoh.parse(joined, end - length, end)
    batch = inner["batch"]
    last = np.array([part[-1] for part in members], np.int64)[batch]
    share = np.zeros(len(made))
    for index, part in enumerate(members):
        own = found["end"][part] - found["number"][part]  # without their heads
        ratio = own / np.maximum(rows["bytes"][part], 1)
        share[index] = float((rows["frames"][part] * ratio).sum())
        rows["frames"][part] *= 1 - ratio
        rows["bytes"][part] -= own
    size = inner["end"] - inner["at"]
    if unreadable := int(np.count_nonzero(inner["code"] == zenoh.UNREADABLE)):
        reader.notes["Zenoh messages in fragments that cannot be read"] += unreadable
    new = take(rows, last) | {
        "kind": inner["code"],
        "submessage": inner["code"],
        "bytes": size,
        "frames": share[batch] * size / np.maximum(length[batch], 1),
    }
    texts = {
        len(rows["frame"]) + index: joined[inner["at"][index] : inner["end"][index]].tobytes()
        for index in range(len(batch))
    }
    return new, texts, inner["number"], stream[last]


def _zenoh_endpoints(
    reader: _Reader,
    content: tcp.Content,
    found: Columns,
    code: Array,
    number_: Array,
    stream: Array,
    process: Array,
    texts: dict[int, bytes],
) -> None:
    """Keep what each process declares: subscribers and queryables, or the tokens of rmw_zenoh.

    A process declares to each other one; what it declares is the most that it does to one.
    """
    subscriber, queryable, token_code = map(
        zenoh.NAMES.index, ("DeclareSubscriber", "DeclareQueryable", "DeclareToken")
    )
    plain = np.flatnonzero((code == subscriber) | (code == queryable))
    _, first = codes(stream[plain], code[plain], number_[plain])
    for index, count in Counter(stream[plain[first]].tolist()).items():
        _declared(reader, int(process[index]), count, tokens=False)
    token = np.flatnonzero(code == token_code)
    _, first = codes(stream[token], number_[token])
    of_ros: Counter[int] = Counter()
    for row in token[first].tolist():
        text = texts.get(row)
        if text is None:
            text = content.data[found["at"][row] : found["end"][row]].tobytes()
        of_ros[int(stream[row])] += _is_ros_endpoint(text)
    for index, count in of_ros.items():
        _declared(reader, int(process[index]), count, tokens=True)


def _is_ros_endpoint(text: bytes) -> bool:
    """Return whether a token is of an endpoint: publisher, subscription, service or client."""
    return b"@ros2_lv/" in text and any(
        kind in text for kind in (b"/MP/", b"/MS/", b"/SS/", b"/SC/")
    )


def _declared(reader: _Reader, which: int, count: int, tokens: bool) -> None:
    process = reader.processes.get(which)
    if process is None or process.product == "Zenoh router":
        return  # a router passes on what others declare
    process.announced = True
    if tokens:
        process.tokens = max(process.tokens, count)
    elif count > len(process.endpoints):
        process.endpoints = set(range(count))


def _other_segments(
    reader: _Reader, content: tcp.Content, streams: tcp.Streams, chosen: Array, process: Array
) -> None:
    """Add the segments that TCP itself sends in the sessions of Zenoh."""
    table = streams.table
    zenohs = np.zeros(len(streams.first), bool)
    zenohs[chosen] = True
    empty = zenohs[table["stream"]] & (table["wire"] == 0)
    control = table["flags"] & (tcp.SYN | tcp.FIN | tcp.RST) > 0
    rows = np.append(np.flatnonzero(empty), content.old)
    kind = np.where(control[rows], _CONTROL, _ACK)
    kind[len(rows) - len(content.old) :] = _AGAIN
    stream = table["stream"][rows]
    reader.rows.append(
        {
            "frame": table["frame"][rows],
            "protocol": np.full(len(rows), TCP, np.uint8),
            "kind": kind,
            "submessage": kind,
            "bytes": table["wire"][rows],
            "way": table["way"][rows],
            "frames": np.ones(len(rows)),
            "ends": table["flags"][rows] & (tcp.FIN | tcp.RST) > 0,
            **_ends(table, rows, process[stream], process[streams.reverse[stream]]),
        }
    )


def _note_tls(reader: _Reader, data: Bytes, streams: tcp.Streams) -> None:
    """Count the connections that start with TLS, but for those of the web."""
    table = streams.table
    at = table["at"]
    hello = (
        (table["size"] > 5)
        & (data[at] == 22)
        & (data[at + 1] == 3)
        & (data[at + 2] <= 4)
        & (data[at + 5] == 1)
        & (table["to_port"] != HTTPS)
    )
    if count := len(np.unique(table["stream"][hello])):
        reader.notes["TCP connections with TLS, which is encrypted"] += count


# ---------------------------------------------------------------- processes


def _processes(reader: _Reader, rows: Columns) -> list[Process]:
    """Return the processes in the order in which they appeared; rows get their places there."""
    prefixes = list(reader.prefixes.known)
    for which, process in reader.processes.items():
        if process.protocol == RTPS:
            process.name = prefixes[which].hex()
    nobody = reader.prefixes.known.get(bytes(12), -1)
    reader.processes.pop(nobody, None)
    order = sorted(reader.processes, key=lambda which: (reader.processes[which].since, which))
    # Numbers of RTPS are from 0 on, those of Zenoh from -2 down.
    least = min([*order, -1])
    most = max([*order, len(prefixes) - 1, -1])
    place = np.full(most - least + 1, -1, np.int32)
    for index, which in enumerate(order):
        place[which - least] = index
    found = [reader.processes[which] for which in order]
    # Somebody who is only spoken to is not known otherwise.
    for name in ("process", "peer"):
        rows[name] = place[rows[name] - least]
    return found
