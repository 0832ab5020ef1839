"""Dissect Zenoh: its messages and processes, over UDP and TCP."""

import re
from dataclasses import dataclass, field, replace
from ipaddress import ip_address
from itertools import chain
from operator import itemgetter

import numpy as np

from discostorm_capture import ip, tcp, zenoh_messages, zenoh_tcp
from discostorm_capture._arrays import IdTable, concat, cumcount, factorize, join_padded, take_rows
from discostorm_capture._types import Array, Bytes, Columns, Notes
from discostorm_capture.dissection import TCP, ZENOH, Dissection, Process, first_seen, message_table
from discostorm_capture.endpoints import ROS_TOKEN_PATTERN, Endpoint, endpoint_of_ros_token
from discostorm_capture.transport import IpContent
from discostorm_capture.zenoh_messages import CODES, FRAGMENT, MORE_FLAG, SCOUTING_PORT, UNREADABLE

#: Kinds of TCP segments, in connections of Zenoh, that complete no message.
TCP_KINDS = ("TCP ACK", "TCP control", "TCP retransmission")
_ACK, _CONTROL, _RETRANSMISSION = range(3)
_ROUTER, _UNKNOWN_ROLE = 0, 3
_ROLES = ("router", "peer", "client")
_HELLO, _TOKEN = map(zenoh_messages.NAMES.index, ("Hello", "DeclareToken"))
_KEY_EXPRESSION = zenoh_messages.NAMES.index("DeclareKeyExpr")
#: Codes of declarations of endpoints. A DeclareToken also declares one if it names one of ROS 2.
_ENDPOINT_CODES = [*map(zenoh_messages.NAMES.index, ("DeclareSubscriber", "DeclareQueryable"))]
#: IPv4 address of a locator in a Hello: where its process listens.
_IPV4_LOCATOR = re.compile(
    rb"/((?:(?:25[0-5]|2[0-4]\d|1?\d?\d)\.){3}(?:25[0-5]|2[0-4]\d|1?\d?\d)):"
)
#: Minimum share of readable datagrams in a session without captured start [1].
_MIN_READABLE_SHARE = 0.8
#: Head of the QoS extension of a fragment, which has its priority; flag of a reliable fragment.
_QOS_EXTENSION, _RELIABLE_FLAG = 0x31, 0x20


@dataclass(frozen=True)
class _PartialDissection:
    """Messages of some packets, and what they say about processes, by id of the process."""

    messages: list[Columns]
    #: Frame, process and source address of each message with an identity; process and role in it.
    sightings: list[tuple[int, int, int]] = field(default_factory=list)
    roles: list[tuple[int, int]] = field(default_factory=list)
    #: Maximum number of endpoints, and of endpoint tokens, that it declares to one other process.
    declared_endpoints: dict[int, int] = field(default_factory=dict)
    endpoint_tokens: dict[int, int] = field(default_factory=dict)
    #: Frame, declaring process and text of each token that names an endpoint of rmw_zenoh.
    ros_tokens: list[tuple[int, int, re.Match[bytes]]] = field(default_factory=list)
    #: The longest list of addresses that one of its messages names as listening addresses.
    listening_addresses: dict[int, set[int]] = field(default_factory=dict)
    #: The version of the protocol with which it opens sessions.
    versions: dict[int, int] = field(default_factory=dict)


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
    data, zids = transport.data, IdTable()
    partials = [
        _dissect_scouting(data, scouts, zids, transport.addresses),
        _dissect_udp_sessions(data, datagrams, zids, notes),
        _dissect_tcp_sessions(data, streams, zids, notes),
    ]
    messages = concat(*(table for part in partials for table in part.messages))
    processes = _merge_processes(partials, zids, transport.addresses)
    names = {number: process.name for number, process in processes.items()}
    own, found = {*names.values()}, dict[bytes, tuple[str, Endpoint | None]]()
    domains = dict[str, int]()
    texts = [text for part in partials for text in part.ros_tokens]
    for _, declares, match in sorted(texts, key=itemgetter(0)):
        # A router forwards tokens of other processes, whose own sessions may not be captured.
        session = match["session"].decode()
        name = session if session in own else names.get(declares, "")
        domains[session] = int(match["domain"])
        found.setdefault(match[0], (name, endpoint_of_ros_token(match)))
    processes = {
        number: replace(process, domain=domains.get(process.name, -1))
        for number, process in processes.items()
    }
    ros = {(name, index): (0, end) for index, (name, end) in enumerate(found.values())}
    return Dissection(messages, processes, ros)


def _merge_processes(
    partials: list[_PartialDissection], zids: IdTable, addresses: IdTable
) -> dict[int, Process]:
    """Return the processes of all partial dissections, by id."""
    roles: dict[int, set[int]] = {}
    endpoints: dict[int, int] = {}
    tokens: dict[int, int] = {}
    for part in partials:
        for id_, role in part.roles:
            roles.setdefault(id_, set()).add(role)
        for total, maxima in ((endpoints, part.declared_endpoints), (tokens, part.endpoint_tokens)):
            for id_, count in maxima.items():
                total[id_] = max(total.get(id_, 0), count)
    sightings = [row for part in partials for row in part.sightings]
    seen = first_seen(sightings, ip.is_loopback(addresses))
    versions = {id_: one for part in partials for id_, one in part.versions.items()}
    processes = {}
    for zid, id_ in zids.ids.items():
        is_router, role = _ROUTER in roles[id_], min(roles[id_])
        declared, announced = endpoints.get(id_, 0), tokens.get(id_, 0)
        listens = partials[0].listening_addresses.get(id_, ())
        processes[id_] = Process(
            ZENOH,
            f"{int.from_bytes(zid, 'little'):x}",  # as Zenoh writes it
            "Zenoh" if role == _UNKNOWN_ROLE else f"Zenoh {_ROLES[role]}",
            *seen[id_],
            endpoints=0 if is_router else announced or declared,
            announced_anything=not is_router and id_ in {*endpoints, *tokens},
            is_server=is_router,
            counts_publishers=announced > 0,
            announced_addresses=tuple(sorted(listens)),
            version=versions.get(id_, 0),
        )
    return processes


def _dissect_scouting(
    data: Bytes, scouts: Columns, zids: IdTable, addresses: IdTable
) -> _PartialDissection:
    """Return the messages of scouting; only a Hello has the role of its sender."""
    code = scouts["code"]
    process = np.full(len(code), -1, np.int64)
    sightings, roles, listens = [], [], dict[int, set[int]]()
    for row in np.flatnonzero(scouts["zid_length"]).tolist():
        begin, length = int(scouts["zid_at"][row]), int(scouts["zid_length"][row])
        process[row] = id_ = zids.id_of(data[begin : begin + length].tobytes())
        sightings.append((int(scouts["frame"][row]), id_, int(scouts["source"][row])))
        role = int(data[begin - 1]) & 3 if code[row] == _HELLO else _UNKNOWN_ROLE
        roles.append((id_, role))
        locators = data[begin + length : scouts["at"][row] + scouts["size"][row]].tobytes()
        texts = _IPV4_LOCATOR.findall(locators) if code[row] == _HELLO else ()
        named = {addresses.id_of(ip_address(text.decode()).packed) for text in texts}
        listens[id_] = max(named, listens.get(id_, named), key=len)
    rows, sizes = np.arange(len(code)), {"bytes": scouts["wire"], "frames": scouts["parts"]}
    wanted = np.where(code == _HELLO, 0, data[scouts["at"] + 2] & 7)  # roles: 1 is a router
    sizes |= {"number": wanted}
    messages = message_table(scouts, rows, ZENOH, code, process=process, udp=True, **sizes)
    return _PartialDissection([messages], sightings, roles, listening_addresses=listens)


def _dissect_udp_sessions(
    data: Bytes, datagrams: Columns, zids: IdTable, notes: Notes
) -> _PartialDissection:
    """Return the messages of sessions over UDP, where each datagram is one batch."""
    table, opened, reverse = _split_udp_sessions(data, datagrams, notes)
    # Assign in reverse order, so that the first row of each stream remains.
    first = np.zeros(len(reverse), np.int64)
    first[table["stream"][::-1]] = np.arange(len(table["stream"]))[::-1]
    process, partial = _identify_processes(opened, table, first, zids)
    table |= _process_columns(process, reverse, table["stream"])
    parsed = _parse_batches(data, table, notes)
    batch, size = parsed["batch"], parsed["end"] - parsed["at"]
    frames = table["parts"][batch] * size / np.maximum(table["wire"][batch], 1)
    code = parsed["code"]
    messages = message_table(table, batch, ZENOH, code, bytes=size, udp=True, frames=frames)
    partial.messages.append(messages)
    return _add_fragmented_messages(data, parsed, partial, process, notes)


def _dissect_tcp_sessions(
    data: Bytes, streams: tcp.Streams, zids: IdTable, notes: Notes
) -> _PartialDissection:
    """Return the messages of sessions over TCP, and their segments without a message."""
    zenoh_tcp.note_tls_connections(data, streams, notes)
    table = streams.segments
    chosen = zenoh_tcp.zenoh_streams(data, streams)
    content = tcp.reassemble_streams(data, streams, chosen)
    opened = zenoh_tcp.stream_openings(content)
    process, partial = _identify_processes(opened, table, streams.first_segment, zids)
    table = table | _process_columns(process, streams.opposite, table["stream"])
    batches = zenoh_tcp.find_batches(content, streams, opened, notes)
    parsed = _parse_batches(content.data, batches, notes)
    # The length before a batch belongs to its first message.
    begin = parsed["at"] - 2 * (np.diff(parsed["batch"], prepend=-1) != 0)
    part = np.searchsorted(content.parts["at"], parsed["end"] - 1, side="right") - 1
    cost_end, cost_begin = (_count_segments(content, table, at) for at in (parsed["end"], begin))
    done, frames = content.parts["done"][part], cost_end - cost_begin
    sizes = {"bytes": parsed["end"] - begin, "frames": frames, "missing": ~table["arrived"][done]}
    partial.messages.append(message_table(table, done, ZENOH, parsed["code"], **sizes))
    partial = _add_fragmented_messages(content.data, parsed, partial, process, notes)
    partial.messages.append(_tcp_segments(content, table, chosen))
    return partial


def _process_columns(process: Array, opposite: Array, stream: Array) -> Columns:
    """Return the sending and receiving process of packets in streams."""
    return {"process": process[stream], "peer": process[opposite[stream]]}


def _identify_processes(
    opened: dict[int, zenoh_messages.SessionOpening], table: Columns, first: Array, zids: IdTable
) -> tuple[Array, _PartialDissection]:
    """Return the process of each stream, -1 if unknown, and what they say; -1 is appended."""
    process = np.full(len(first) + 1, -1, np.int64)
    sightings, roles, versions = [], [], dict[int, int]()
    for stream, opening in opened.items():
        row = first[stream]
        process[stream] = id_ = zids.id_of(opening.zid)
        sightings.append((int(table["frame"][row]), id_, int(table["source"][row])))
        roles.append((id_, opening.role))
        versions[id_] = opening.version
    return process, _PartialDissection([], sightings, roles, versions=versions)


def _parse_batches(data: Bytes, batches: Columns, notes: Notes) -> Columns:
    """Return the messages in batches, each with the ``stream`` of its batch."""
    parsed = zenoh_messages.parse_batches(data, batches["at"], batches["end"])
    unreadable = parsed["code"] == UNREADABLE
    notes.add_where(unreadable, "batches of Zenoh that cannot be read to their end")
    return parsed | {"stream": batches["stream"][parsed["batch"]]}


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


def _add_fragmented_messages(
    data: Bytes, parsed: Columns, partial: _PartialDissection, process: Array, notes: Notes
) -> _PartialDissection:
    """Add messages reassembled from fragments, and collect the endpoints that all declare."""
    tables, sources = partial.messages, [(data, parsed)]
    if fragments := _complete_fragments(data, parsed, notes):
        content, inner, *tables = _reassemble_messages(data, parsed, tables[0], fragments, notes)
        sources.append((content, inner))
    declares = (take_rows(rows, np.isin(rows["code"], _ENDPOINT_CODES)) for _, rows in sources)
    declared = concat(*declares)
    _, first = factorize(declared["stream"], declared["code"], declared["number"])
    texts, named = [], set[tuple[int, bytes]]()
    for (source, inner), table in zip(sources, tables, strict=True):
        for row in np.flatnonzero(np.isin(inner["code"], (_TOKEN, _KEY_EXPRESSION))).tolist():
            text = ROS_TOKEN_PATTERN.search(source[inner["at"][row] : inner["end"][row]].tobytes())
            if text:
                stream = int(inner["stream"][row])
                texts.append((int(table["frame"][row]), int(process[stream]), text))
                named.add((stream, text[0]))
    endpoints = _max_declared_to_one(process, declared["stream"][first])
    with_tokens = [process[one["stream"][one["code"] == _TOKEN]].tolist() for _, one in sources]
    tokens = dict.fromkeys(chain(*with_tokens), 0)
    tokens |= _max_declared_to_one(process, np.array([stream for stream, _ in named], np.int64))
    known = (partial.sightings, partial.roles, endpoints, tokens, texts)
    return _PartialDissection(tables, *known, versions=partial.versions)


def _complete_fragments(data: Bytes, parsed: Columns, notes: Notes) -> list[list[int]]:
    """Return the rows of fragments, one list for each message of which all were captured."""
    pending: dict[tuple[int, int, bytes], list[int]] = {}
    complete = []
    for row in np.flatnonzero(parsed["code"] == CODES["transport"][FRAGMENT]).tolist():
        head, at, begin = (int(parsed[name][row]) for name in ("head", "at", "number"))
        # The sequence number ends with a byte below 128; then extensions follow.
        extension = at + 1
        while extension < begin and data[extension] > 0x7F:
            extension += 1
        qos = data[extension + 1 : min(extension + 3, begin)].tobytes()
        is_qos = len(qos) == 2 and qos[0] & 0x7F == _QOS_EXTENSION
        key = int(parsed["stream"][row]), head & _RELIABLE_FLAG, qos[1:] if is_qos else b""
        pending.setdefault(key, []).append(row)
        if not head & MORE_FLAG:
            complete.append(pending.pop(key))
    if pending:
        notes["Zenoh messages lack fragments"] += len(pending)
    return complete


def _reassemble_messages(
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
    return content, inner | {"stream": parsed["stream"][last]}, outer, new


def _max_declared_to_one(process: Array, streams: Array) -> dict[int, int]:
    """Return the maximum number of declarations that each process sends in one stream."""
    maxima: dict[int, int] = {}
    for stream, count in zip(*np.unique(streams, return_counts=True), strict=True):
        id_ = int(process[stream])
        maxima[id_] = max(maxima.get(id_, 0), int(count))
    return maxima


def _split_udp_sessions(
    data: Bytes, datagrams: Columns, notes: Notes
) -> tuple[Columns, dict[int, zenoh_messages.SessionOpening], Array]:
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
    opened: dict[int, zenoh_messages.SessionOpening] = {}
    for row, session in zenoh_messages.session_openings(data, table["at"], table["end"]).items():
        opened.setdefault(int(stream[row]), session)
    is_zenoh = np.zeros(len(pairs) + 1, bool)  # the last element stands for no opposite
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
