"""Dissect Zenoh: its messages and processes, over UDP and TCP."""

import re
from collections import Counter, defaultdict
from dataclasses import dataclass, field
from ipaddress import ip_address
from operator import itemgetter

import numpy as np

from discostorm_capture import ip, tcp, zenoh_messages, zenoh_tcp
from discostorm_capture._arrays import IdTable, concat, cumcount, factorize, join_padded, take_rows
from discostorm_capture._types import Array, Bytes, Columns, Notes
from discostorm_capture.dissection import (
    TCP,
    ZENOH,
    Dissection,
    Endpoints,
    Process,
    first_seen,
    message_table,
)
from discostorm_capture.endpoints import (
    ROS_TOKEN_PATTERN,
    Endpoint,
    endpoint_of_ros_token,
    key_of_ros_token,
)
from discostorm_capture.transport import IpContent
from discostorm_capture.zenoh_messages import CODES, FRAGMENT, MORE_FLAG, SCOUTING_PORT, UNREADABLE

#: Kinds of TCP segments, in connections of Zenoh, that complete no message.
TCP_KINDS = ("TCP ACK", "TCP control", "TCP retransmission")
_ACK, _CONTROL, _RETRANSMISSION = range(3)
_ROUTER, _UNKNOWN_ROLE = 0, 3
_ROLES = ("router", "peer", "client")
_code_of = zenoh_messages.MESSAGE_NAMES.index
_HELLO, _TOKEN, _PUSH, _CLOSE = map(_code_of, ("Hello", "DeclareToken", "Push", "Close"))
_KEY_EXPRESSION, _LINK_STATES = map(_code_of, ("DeclareKeyExpr", "OAM (network)"))
#: Codes of declarations of endpoints. A DeclareToken also declares one if it names one of ROS 2.
_ENDPOINT_CODES = [*map(_code_of, ("DeclareSubscriber", "DeclareQueryable"))]
#: IPv4 address of a locator in a Hello: where its process listens.
_LOCATOR = re.compile(rb"/((?:(?:25[0-5]|2[0-4]\d|1?\d?\d)\.){3}(?:25[0-5]|2[0-4]\d|1?\d?\d)):")
#: Where a process listens only for its own host, in what a router tells of its links.
_LOOPBACK = re.compile(rb"/(?:127\.0\.0\.1|\[::1\]|localhost):\d+")
#: Minimum share of readable datagrams in a session without captured start [1].
_MIN_READABLE_SHARE = 0.8
#: Head of the QoS extension of a fragment, which has its priority; flag of a reliable fragment.
_QOS_EXTENSION, _RELIABLE_FLAG = 0x31, 0x20
#: The attachment of a sample of rmw_zenoh: its sequence number, its time, the writer's GID
#: (rmw_zenoh_cpp, src/detail/attachment_helpers.cpp); where it begins, at most [B].
_ATTACHMENT = re.compile(rb"[\x43\xc3]\x21(.{8})(.{8})\x10.{16}", re.DOTALL)
_MAX_ATTACHMENT_OFFSET = 100
#: How sessions are opened, by stream.
Openings = dict[int, zenoh_messages.SessionOpening]


@dataclass(frozen=True)
class _Roster:
    """What messages of all transports say about processes, by their ids in `zids`; notes."""

    notes: Notes
    zids: IdTable = field(default_factory=IdTable)
    #: Frame, process and source address of each message with an identity; roles in them.
    sightings: list[tuple[int, int, int]] = field(default_factory=list)
    roles: dict[int, set[int]] = field(default_factory=lambda: defaultdict(set))
    #: Maximum number of endpoints, and of endpoint tokens, that a process declares to another one.
    endpoint_counts: dict[int, int] = field(default_factory=dict)
    token_counts: dict[int, int] = field(default_factory=dict)
    #: Frame, declaring process and text of each token that names an endpoint of rmw_zenoh.
    ros_tokens: list[tuple[int, int, re.Match[bytes]]] = field(default_factory=list)
    #: The key expressions of samples; a message has the number of its own, plus 1, as ``writer``.
    keys: IdTable = field(default_factory=IdTable)
    #: Process, frame, source address and seconds of the time stamp of each sample of rmw_zenoh.
    time_stamps: list[tuple[int, ...]] = field(default_factory=list)
    #: The longest list of listening addresses in one message of a process.
    listening_addresses: dict[int, set[int]] = field(default_factory=lambda: defaultdict(set))
    #: The version of the protocol with which a process opens sessions.
    versions: dict[int, int] = field(default_factory=dict)

    def add(self, zid: bytes, role: int, packets: Columns, row: int) -> int:
        """Record an identity and role in a packet; return the id of the process."""
        id_ = self.zids.id_of(zid)
        self.sightings.append((int(packets["frame"][row]), id_, int(packets["source"][row])))
        self.roles[id_].add(role)
        return id_


def split_scouting(transport: IpContent, datagrams: Columns) -> tuple[Columns, Columns]:
    """Separate datagrams of scouting, with added ``code`` and identity, from all others."""
    to_all = ip.is_multicast(transport.addresses)[datagrams["target"]]
    to_all |= datagrams["to_port"] == SCOUTING_PORT
    at, size = datagrams["at"], datagrams["size"]
    code, zid_at, zid_length = zenoh_messages.parse_scouting(transport.data, at, size, to_all)
    scouts = datagrams | {"code": code, "zid_at": zid_at, "zid_length": zid_length}
    return take_rows(scouts, code != UNREADABLE), take_rows(datagrams, code == UNREADABLE)


def dissect_zenoh(
    transport: IpContent, scouts: Columns, datagrams: Columns, streams: tcp.Streams, notes: Notes
) -> Dissection:
    """Return the messages of Zenoh, and the processes that sent them."""
    data, seen = transport.data, _Roster(notes)
    messages = concat(
        _dissect_scouting(data, scouts, seen, transport.addresses),
        *_dissect_udp_sessions(data, datagrams, seen),
        *_dissect_tcp_sessions(data, streams, seen),
    )
    names = [f"{int.from_bytes(zid, 'little'):x}" for zid in seen.zids.ids]  # as Zenoh writes it
    domains, found = defaultdict[str, set[int]](set), dict[bytes, tuple[int, str, Endpoint]]()
    publishers = defaultdict[bytes, dict[str, int]](dict)
    for _, declares, match in sorted(seen.ros_tokens, key=itemgetter(0)):
        # A router forwards tokens of other processes, whose own sessions may not be captured.
        session = match["session"].decode()
        name = session if session in names else [*names, ""][declares]
        domains[name].add(int(match["domain"]))
        found.setdefault(match[0], (len(found) + 1, name, endpoint_of_ros_token(match)))
        if match["kind"] == b"MP":
            publishers[key_of_ros_token(match)].setdefault(name, found[match[0]][0])
    _replace_keys(messages, seen, names, publishers)
    first = first_seen(seen.sightings, ip.is_loopback(transport.addresses))
    processes = {}
    for id_, name in enumerate(names):
        is_router, role = _ROUTER in seen.roles[id_], min(seen.roles[id_])
        tokens = seen.token_counts.get(id_, 0)
        processes[id_] = Process(
            ZENOH,
            name,
            "Zenoh" if role == _UNKNOWN_ROLE else f"Zenoh {_ROLES[role]}",
            *first[id_],
            endpoints=0 if is_router else tokens or seen.endpoint_counts.get(id_, 0),
            announced_anything=not is_router
            and (id_ in seen.endpoint_counts or id_ in seen.token_counts),
            is_server=is_router,
            counts_publishers=tokens > 0,
            announced_addresses=tuple(sorted(seen.listening_addresses[id_])),
            domain=max(domains[name]) if len(domains[name]) == 1 else -1,
            version=seen.versions.get(id_, 0),
        )
    ros: Endpoints = {(name, number): (0, end) for number, name, end in found.values()}
    own = [row[1:] for row in seen.time_stamps if _ROUTER not in seen.roles[row[0]]]
    frame, source, seconds = np.array(own, np.int64).reshape(-1, 3).T
    stamps = {"frame": frame, "source": source, "target": source, "to_port": seconds}
    return Dissection(messages, processes, ros, stamps)


def _replace_keys(
    messages: Columns, seen: _Roster, names: list[str], publishers: dict[bytes, dict[str, int]]
) -> None:
    """Replace the key expressions of samples by the ids of the endpoints that publish them."""
    rows = np.flatnonzero(messages["writer"])
    code, first = factorize(messages["process"][rows], messages["writer"][rows])
    writers, keys = np.zeros(len(first), np.uint32), [*seen.keys.ids]
    for index, row in enumerate(rows[first].tolist()):
        of = publishers.get(keys[messages["writer"][row] - 1], {})
        # A router forwards samples of other processes.
        writers[index] = of.get([*names, ""][messages["process"][row]], min(of.values(), default=0))
    messages["writer"][rows] = writers[code]


def _dissect_scouting(data: Bytes, scouts: Columns, seen: _Roster, addresses: IdTable) -> Columns:
    """Return the messages of scouting; only a Hello has the role of its sender."""
    is_hello = scouts["code"] == _HELLO
    process = np.full(len(is_hello), -1, np.int64)
    for row in np.flatnonzero(scouts["zid_length"]).tolist():
        begin = int(scouts["zid_at"][row])
        end = begin + int(scouts["zid_length"][row])
        role = int(data[begin - 1]) & 3 if is_hello[row] else _UNKNOWN_ROLE
        process[row] = id_ = seen.add(data[begin:end].tobytes(), role, scouts, row)
        if is_hello[row]:
            locators = data[end : scouts["at"][row] + scouts["size"][row]].tobytes()
            texts = _LOCATOR.findall(locators)
            named = {addresses.id_of(ip_address(text.decode()).packed) for text in texts}
            listens = seen.listening_addresses
            listens[id_] = max(named, listens[id_], key=len)
    columns = {
        "bytes": scouts["wire"],
        "frames": scouts["parts"],
        "number": np.where(is_hello, 0, data[scouts["at"] + 2] & 7),  # roles: 1 is a router
    }
    rows = np.arange(len(process))
    return message_table(scouts, rows, ZENOH, scouts["code"], process=process, udp=True, **columns)


def _dissect_udp_sessions(data: Bytes, datagrams: Columns, seen: _Roster) -> list[Columns]:
    """Return the messages of sessions over UDP, where each datagram is one batch."""
    table, opened, reverse = _udp_sessions(data, datagrams, seen.notes)
    # Assign in reverse order, so that the first row of each stream remains.
    first = np.zeros(len(reverse), np.int64)
    first[table["stream"][::-1]] = np.arange(len(table["stream"]))[::-1]
    table = _with_processes(opened, table, first, reverse, seen)
    parsed = _parse_batches(data, table, seen.notes)
    batch, size = parsed["batch"], parsed["end"] - parsed["at"]
    frames = table["parts"][batch] * size / np.maximum(table["wire"][batch], 1)
    code = parsed["code"]
    messages = message_table(table, batch, ZENOH, code, bytes=size, udp=True, frames=frames)
    return _add_fragments(data, parsed, messages, reverse, seen)


def _dissect_tcp_sessions(data: Bytes, streams: tcp.Streams, seen: _Roster) -> list[Columns]:
    """Return the messages of sessions over TCP, and their segments without a message."""
    zenoh_tcp.note_tls_connections(data, streams, seen.notes)
    table = streams.segments
    chosen = zenoh_tcp.zenoh_streams(data, streams)
    content = tcp.reassemble_streams(data, streams, chosen)
    opened = zenoh_tcp.stream_openings(content)
    first = streams.first_segment
    table = _with_processes(opened, table, first, streams.opposite, seen)
    batches = zenoh_tcp.find_batches(content, streams, opened, seen.notes)
    batches["process"] = table["process"][first[batches["stream"]]]
    parsed = _parse_batches(content.data, batches, seen.notes)
    # The length before a batch belongs to its first message.
    begin = parsed["at"] - 2 * (np.diff(parsed["batch"], prepend=-1) != 0)
    part = np.searchsorted(content.parts["at"], parsed["end"] - 1, side="right") - 1
    cost_end, cost_begin = (_count_segments(content, table, at) for at in (parsed["end"], begin))
    done, frames = content.parts["done"][part], cost_end - cost_begin
    sizes = {"bytes": parsed["end"] - begin, "frames": frames, "missing": ~table["arrived"][done]}
    # The number of a Close is its reason.
    sizes["number"] = np.where(parsed["code"] == _CLOSE, content.data[parsed["at"] + 1], 0)
    messages = message_table(table, done, ZENOH, parsed["code"], **sizes)
    tables = _add_fragments(content.data, parsed, messages, streams.opposite, seen)
    return [*tables, _tcp_segments(content, table, chosen)]


def _with_processes(
    opened: Openings, table: Columns, first: Array, opposite: Array, seen: _Roster
) -> Columns:
    """Return packets with their ``process``, and its ``peer``, given the first of each stream."""
    process = np.full(len(first) + 1, -1, np.int64)  # index -1 (no opposite) reads the last
    for stream, opening in opened.items():
        process[stream] = id_ = seen.add(opening.zid, opening.role, table, first[stream])
        seen.versions[id_] = opening.version
    streams = table["stream"]
    return table | {"process": process[streams], "peer": process[opposite[streams]]}


def _parse_batches(data: Bytes, batches: Columns, notes: Notes) -> Columns:
    """Return the messages in batches, each with the ``stream`` and ``process`` of its batch."""
    parsed = zenoh_messages.parse_batches(data, batches["at"], batches["end"])
    unreadable = parsed["code"] == UNREADABLE
    notes.add_where(unreadable, "batches of Zenoh that cannot be read to their end")
    return parsed | {name: batches[name][parsed["batch"]] for name in ("stream", "process")}


def _count_segments(content: tcp.StreamContent, table: Columns, at: Array) -> Array:
    """Return how many segments carried the content up to each offset, with fractions."""
    parts = content.parts
    segment = parts["segment"]
    share = table["parts"][segment] * parts["size"] / np.maximum(table["wire"][segment], 1)
    offsets = np.append(parts["at"], parts["at"][-1:] + parts["size"][-1:])
    sums = np.append(0.0, np.cumsum(share))[: len(offsets)]
    return np.interp(at, offsets, sums) if len(offsets) else np.zeros(len(at))


def _tcp_segments(content: tcp.StreamContent, table: Columns, chosen: Array) -> Columns:
    """Return segments of Zenoh's sessions that complete no message, such as retransmissions."""
    empty = np.flatnonzero(np.isin(table["stream"], chosen) & (table["wire"] == 0))
    rows = np.append(empty, content.retransmitted)
    flags, sizes = table["flags"][rows], {"bytes": table["wire"][rows]}
    is_control = flags & (tcp.SYN | tcp.FIN | tcp.RST) > 0
    kind = np.where(is_control, _CONTROL, _ACK)
    kind[len(empty) :] = _RETRANSMISSION
    closes = flags & (tcp.FIN | tcp.RST) > 0
    return message_table(table, rows, TCP, kind, frames=table["parts"][rows], ends=closes, **sizes)


def _add_fragments(
    data: Bytes, parsed: Columns, messages: Columns, opposite: Array, seen: _Roster
) -> list[Columns]:
    """Return all messages, also from fragments; collect the endpoints that they declare."""
    tables, sources = [messages], [(data, parsed)]
    if fragments := _complete_fragments(data, parsed, messages, seen.notes):
        content, inner, *tables = _reassemble(data, parsed, messages, fragments, seen.notes)
        sources.append((content, inner))
    declares = (take_rows(rows, np.isin(rows["code"], _ENDPOINT_CODES)) for _, rows in sources)
    declared = concat(*declares)
    _, first = factorize(declared["stream"], declared["code"], declared["number"])
    ends = zip(*(declared[name][first].tolist() for name in ("stream", "process")), strict=True)
    named = set[tuple[int, int, bytes]]()
    for (source, inner), table in zip(sources, tables, strict=True):
        for row in np.flatnonzero(np.isin(inner["code"], (_TOKEN, _KEY_EXPRESSION))).tolist():
            stream, process = (int(inner[name][row]) for name in ("stream", "process"))
            if inner["code"][row] == _TOKEN:
                seen.token_counts.setdefault(process, 0)
            text = ROS_TOKEN_PATTERN.search(source[inner["at"][row] : inner["end"][row]].tobytes())
            if text:
                seen.ros_tokens.append((int(table["frame"][row]), process, text))
                named.add((stream, process, text[0]))
    counts = Counter(ends), Counter((stream, process) for stream, process, _ in named)
    for maxima, count in zip((seen.endpoint_counts, seen.token_counts), counts, strict=True):
        for (_, process), declarations in count.items():
            maxima[process] = max(maxima.get(process, 0), declarations)
    _name_samples([*zip(sources, tables, strict=True)], opposite, seen)
    return tables


def _name_samples(
    parts: list[tuple[tuple[Bytes, Columns], Columns]], opposite: Array, seen: _Roster
) -> None:
    """Set the keys of samples, the sequence numbers of rmw_zenoh, and those of link states."""
    texts = dict[tuple[int, int], bytes]()
    for (data, parsed), _ in parts:
        for row, scope, suffix in zenoh_messages.key_expressions(data, parsed, _KEY_EXPRESSION):
            stream = int(parsed["stream"][row])
            texts[stream, int(parsed["number"][row])] = texts.get((stream, scope), b"") + suffix
    for (data, parsed), table in parts:
        # The number of link states is how many addresses in them are on loopback.
        for row in np.flatnonzero(parsed["code"] == _LINK_STATES).tolist():
            told = data[parsed["at"][row] : parsed["end"][row]].tobytes()
            table["number"][row] = len({*_LOOPBACK.findall(told)})
        for row, scope, suffix in zenoh_messages.key_expressions(data, parsed, _PUSH):
            stream = int(parsed["stream"][row])
            # The number is one that this side declared, or the other one.
            stream = stream if parsed["head"][row] & MORE_FLAG else int(opposite[stream])
            if key := texts.get((stream, scope), b"") + suffix:
                table["writer"][row] = seen.keys.id_of(key) + 1
            begin, end = int(parsed["at"][row]), int(parsed["end"][row])
            end = min(end, begin + len(suffix) + _MAX_ATTACHMENT_OFFSET)
            if found := _ATTACHMENT.search(data[begin:end].tobytes()):
                number, nanoseconds = (int.from_bytes(part, "little") for part in found.groups())
                table["number"][row] = number & 0x7FFFFFFF
                sender = (int(table[name][row]) for name in ("process", "frame", "source"))
                seen.time_stamps.append((*sender, nanoseconds // 10**9))


def _complete_fragments(
    data: Bytes, parsed: Columns, messages: Columns, notes: Notes
) -> list[list[int]]:
    """Return the rows of fragments, one list for each message of which all were captured.

    In ``holes`` of messages, mark those before which the sender broke off another one.
    """
    pending: dict[tuple[int, int, bytes], list[int]] = {}
    complete, lacking, last = [], 0, dict[tuple[int, int, bytes], int]()
    for row in np.flatnonzero(parsed["code"] == CODES["transport"][FRAGMENT]).tolist():
        head, at, begin = (int(parsed[name][row]) for name in ("head", "at", "number"))
        # The sequence number, of 7 bits a byte, ends with a byte below 128; extensions follow.
        extension, number = at + 1, int(data[at + 1]) & 0x7F
        while extension < begin and data[extension] > 0x7F:
            extension += 1
            number |= (int(data[extension]) & 0x7F) << 7 * (extension - at - 1)
        qos = data[extension + 1 : min(extension + 3, begin)].tobytes()
        is_qos = len(qos) == 2 and qos[0] & 0x7F == _QOS_EXTENSION
        key = int(parsed["stream"][row]), head & _RELIABLE_FLAG, qos[1:] if is_qos else b""
        if pending.get(key) and number != last[key] + 1:
            # Only an empty batch is between them: the capture lacks nothing.
            messages["holes"][row] = at == int(parsed["end"][pending.pop(key)[-1]]) + 4
            lacking += 1
        pending.setdefault(key, []).append(row)
        last[key] = number
        if not head & MORE_FLAG:
            complete.append(pending.pop(key))
    if lacking + len(pending):
        notes["Zenoh messages lack fragments"] += lacking + len(pending)
    return complete


def _reassemble(
    data: Bytes, parsed: Columns, messages: Columns, fragments: list[list[int]], notes: Notes
) -> tuple[Bytes, Columns, Columns, Columns]:
    """Return reassembled bytes, their messages parsed, and tables of outer and inner messages."""
    owner = np.repeat(np.arange(len(fragments)), [len(rows) for rows in fragments])
    rows = np.concatenate(fragments).astype(np.int64)
    size = parsed["end"][rows] - parsed["number"][rows]
    chunks = zip(parsed["number"][rows].tolist(), parsed["end"][rows].tolist(), strict=True)
    content = join_padded(*(data[begin:end] for begin, end in chunks))
    length = np.bincount(owner, size).astype(np.int64)
    end = np.cumsum(length)
    inner = zenoh_messages.parse_batches(content, end - length, end)
    notes.add_where(inner["code"] == UNREADABLE, "Zenoh messages in fragments that cannot be read")
    batch = inner["batch"]
    last = np.array([rows[-1] for rows in fragments], np.int64)[batch]
    ratio = size / np.maximum(messages["bytes"][rows], 1)
    frames = np.bincount(owner, messages["frames"][rows] * ratio)
    outer = messages | {name: messages[name].copy() for name in ("bytes", "frames")}
    outer["frames"][rows] *= 1 - ratio
    outer["bytes"][rows] -= size
    inner_size = inner["end"] - inner["at"]
    new = take_rows(messages, last) | {
        "kind": inner["code"].astype(np.uint16),
        "submessage": inner["code"],
        "bytes": inner_size.astype(np.int32),
        "frames": (frames[batch] * inner_size / np.maximum(length[batch], 1)).astype(np.float32),
    }
    inner |= {name: parsed[name][last] for name in ("stream", "process")}
    return content, inner, outer, new


def _udp_sessions(data: Bytes, datagrams: Columns, notes: Notes) -> tuple[Columns, Openings, Array]:
    """Return datagrams of sessions with their ``stream``; openings; opposites of streams."""
    datagrams = datagrams | {"end": datagrams["at"] + datagrams["size"]}
    sender, receiver = ip.sender_and_receiver_sockets(datagrams)
    opening = np.flatnonzero(zenoh_messages.opens_session(data, datagrams["at"], datagrams["size"]))
    opening = opening[_is_readable_batch(data, take_rows(datagrams, opening))]
    ports = datagrams["from_port"], datagrams["to_port"]
    at_port = (ports[0] == zenoh_messages.ZENOH_PORT) | (ports[1] == zenoh_messages.ZENOH_PORT)
    ends = np.concatenate([sender[opening], receiver[opening]])
    rows = np.flatnonzero(at_port | np.isin(receiver, ends))
    table, sender, receiver = take_rows(datagrams, rows), sender[rows], receiver[rows]
    stream, first = factorize(sender, receiver)
    pairs = list(zip(sender[first].tolist(), receiver[first].tolist(), strict=True))
    number_of = {pair: number for number, pair in enumerate(pairs)}
    reverse = np.array([number_of.get((b, a), -1) for a, b in pairs], np.int64)
    opened: Openings = {}
    for row, session in zenoh_messages.session_openings(data, table["at"], table["end"]).items():
        opened.setdefault(int(stream[row]), session)
    is_zenoh = np.zeros(len(pairs) + 1, bool)  # index -1 (no opposite) reads the last
    is_zenoh[[*opened]] = True
    is_zenoh = is_zenoh[:-1] | is_zenoh[reverse]
    readable = np.bincount(stream, _is_readable_batch(data, table), len(pairs))
    is_zenoh |= readable >= _MIN_READABLE_SHARE * np.bincount(stream, minlength=len(pairs))
    kept = is_zenoh[stream]
    text = "UDP datagrams at Zenoh's ports were not read: they are not Zenoh, or are "
    notes.add_where(~kept, f"{text}encrypted or compressed")
    turn, sides = cumcount(stream), reverse.tolist()
    for number in range(len(pairs)):
        if special := zenoh_messages.unreadable_feature(number, sides, opened):
            rest = (stream == number) & (turn >= zenoh_messages.OPENING_BATCHES)
            notes[f"bytes of Zenoh sessions with {special}"] += int(table["wire"][rest].sum())
            kept &= ~rest
    return take_rows(table | {"stream": stream}, kept), opened, reverse


def _is_readable_batch(data: Bytes, datagrams: Columns) -> Array:
    """Return which datagrams are readable batches."""
    messages = zenoh_messages.parse_batches(data, datagrams["at"], datagrams["end"])
    readable = datagrams["size"] > 0
    readable[messages["batch"][messages["code"] == zenoh_messages.UNREADABLE]] = False
    return readable
