"""Messages of Zenoh, over TCP and UDP, from datagrams and connections that were gathered."""

from collections import Counter
from typing import Any

import numpy as np

from discostorm_capture import ip, network_events, tcp, zenoh, zenoh_datagrams, zenoh_streams
from discostorm_capture._bytes import PAD, Array, Bytes, Columns, codes, stack, take
from discostorm_capture.dissector import TCP, ZENOH, Gathered, KnownProcess

#: Segments of Zenoh's connections that carry no message of their own.
TCP_KINDS = ("TCP ACK", "TCP control", "TCP retransmission")
_ACK, _CONTROL, _AGAIN = range(3)
HTTPS = 443


def read_zenoh(gathered: Gathered, copies: Array) -> None:
    """Read the datagrams and streams of Zenoh."""
    known: dict[bytes, int] = {}
    if gathered.datagrams:
        rest = [_but_scouting(gathered, *part, known) for part in gathered.datagrams]
        gathered.datagrams = []
        gathered.asides += [network_events.exchanges(found) for _, found in rest]
        _read_datagrams(gathered, rest, known)
    if gathered.segments:
        parts, gathered.segments = gathered.segments, []
        streams = tcp.streams([take(part, ~copies[part["frame"]]) for part in parts])
        del parts
        gathered.asides.append(network_events.connections(streams))
        _read_streams(gathered, streams, known)


def _process(gathered: Gathered, known: dict[bytes, int], zid: bytes, role: int) -> int:
    """Return the number of a process of Zenoh; numbers of both protocols differ."""
    which = known.setdefault(zid, -2 - len(known))
    role_name = ("router", "peer", "client", "")[role & 3]
    serves = role & 3 == 0
    # As Zenoh writes it.
    name = f"{int.from_bytes(zid, 'little'):x}"
    process = KnownProcess(ZENOH, name, f"Zenoh {role_name}".strip())
    gathered.processes.setdefault(which, process).serves |= serves
    return which


def _zenoh_saw(gathered: Gathered, which: int, source: int, frame: int) -> None:
    process = gathered.processes[which]
    if process.since < 0 or frame < process.since:
        process.since = frame
    if process.host < 0 or gathered.is_loopback(process.host):
        process.host = source


def _but_scouting(
    gathered: Gathered, data: Bytes, found: Columns, known: dict[bytes, int]
) -> tuple[Bytes, Columns]:
    """Read scouting; return the other datagrams."""
    group = ip.multicast(gathered.addresses)[found["target"]]
    to_all = group | (found["to_port"] == zenoh.SCOUTING_PORT)
    code, identity = zenoh.scouting(data, found["at"], found["size"], to_all)
    is_scouting = code != zenoh.UNREADABLE
    rows = np.flatnonzero(is_scouting)
    process = np.full(len(rows), -1, np.int64)
    seen: dict[tuple[bytes, int], int] = {}
    for index in np.flatnonzero(identity["length"][rows] > 0).tolist():
        row = rows[index]
        place, length = int(identity["at"][row]), int(identity["length"][row])
        zid, source = data[place : place + length].tobytes(), int(found["source"][row])
        if (zid, source) not in seen:
            # A Scout does not say what sends it.
            is_hello = zenoh.NAMES[code[row]] == "Hello"
            role = int(data[place - 1]) & 3 if is_hello else 3
            seen[zid, source] = _process(gathered, known, zid, role)
            _zenoh_saw(gathered, seen[zid, source], source, int(found["frame"][row]))
        process[index] = seen[zid, source]
    gathered.rows.append(
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
    return data, take(found, ~is_scouting)


def _read_datagrams(
    gathered: Gathered, parts: list[tuple[Bytes, Columns]], known: dict[bytes, int]
) -> None:
    """Read sessions over UDP, each datagram being a batch."""
    data, table, opened, reverse = zenoh_datagrams.sessions(parts, gathered.notes)
    process = np.full(len(reverse) + 1, -1, np.int64)  # the last one: there is no such stream
    for of, session in opened.items():
        row = int(np.argmax(table["stream"] == of))
        process[of] = _process(gathered, known, session.zid, session.role)
        _zenoh_saw(gathered, int(process[of]), int(table["source"][row]), int(table["frame"][row]))
    found = _parsed(gathered, data, table["at"], table["end"])
    batch, size = found["batch"], found["end"] - found["at"]
    stream = table["stream"][batch]
    rows = {
        "frame": table["frame"][batch],
        "protocol": np.full(len(batch), ZENOH, np.uint8),
        "kind": found["code"],
        "submessage": found["code"],
        "bytes": size,
        "process": process[stream],
        "peer": process[reverse[stream]],
        "source": table["source"][batch],
        "target": table["target"][batch],
        "way": table["way"][batch],
        "udp": np.ones(len(batch), bool),
        "frames": table["parts"][batch] * size / np.maximum(table["wire"][batch], 1),
    }
    _add_messages(gathered, data, found, rows, stream, process)


def _read_streams(gathered: Gathered, streams: tcp.Streams, known: dict[bytes, int]) -> None:
    """Read sessions over TCP."""
    data = gathered.packets.data
    _note_tls(gathered, data, streams)
    chosen = zenoh_streams.chosen(data, streams)
    if len(others := zenoh_streams.undecided(streams, chosen)):
        begun = list(zenoh_streams.openings(tcp.content(data, streams, others)))
        chosen = np.union1d(chosen, [*begun, *streams.reverse[begun]]).astype(np.int64)
    if not len(chosen):
        return
    content = tcp.content(data, streams, chosen)
    opened = zenoh_streams.openings(content)
    table = streams.table
    process = np.full(len(streams.first), -1, np.int64)
    for of, session in opened.items():
        row = streams.first[of]
        process[of] = _process(gathered, known, session.zid, session.role)
        _zenoh_saw(gathered, int(process[of]), int(table["source"][row]), int(table["frame"][row]))
    batches = zenoh_streams.batches(content, streams, opened, gathered.notes)
    found = _parsed(gathered, content.data, batches["at"], batches["end"])
    stream = batches["stream"][found["batch"]]
    rows = _message_rows(content, streams, found, stream, process)
    _add_messages(gathered, content.data, found, rows, stream, process)
    _other_segments(gathered, content, streams, chosen, process)


def _parsed(gathered: Gathered, data: Bytes, at: Array, end: Array) -> Columns:
    """Return the messages in batches; note those that cannot be read."""
    found = zenoh.parse(data, at, end)
    if unreadable := int(np.count_nonzero(found["code"] == zenoh.UNREADABLE)):
        gathered.notes["batches of Zenoh that cannot be read to their end"] += unreadable
    return found


def _add_messages(
    gathered: Gathered, data: Bytes, found: Columns, rows: Columns, stream: Array, process: Array
) -> None:
    """Add the messages in batches, those that fragments of Zenoh make, and what they declare."""
    gathered.rows.append(rows)
    names = _endpoint_names(data, found, stream)
    made, members = zenoh_streams.put_together(data, found, stream, gathered.notes)
    if made:
        joined, inner, last = _from_fragments(gathered, made, members, found, rows)
        names |= _endpoint_names(joined, inner, stream[last])
    declared = _declarations(data, found, stream, names)
    if made:
        declared = stack([declared, _declarations(joined, inner, stream[last], names)])
    _count_endpoints(gathered, declared, process)


def _message_rows(
    content: tcp.Content, streams: tcp.Streams, found: Columns, stream: Array, process: Array
) -> Columns:
    """Return the rows of messages in batches, each with its part of the segments' costs."""
    table, first = streams.table, streams.first[stream]
    # The length in front of a batch goes with its first message.
    begin = found["at"] - 2 * (np.diff(found["batch"], prepend=-1) != 0)
    cost = _cost(content, table)
    piece = np.searchsorted(content.pieces["at"], found["end"] - 1, side="right") - 1
    done = content.pieces["done"][piece] if len(piece) else piece
    return {
        "frame": table["frame"][done],
        "protocol": np.full(len(done), ZENOH, np.uint8),
        "kind": found["code"],
        "submessage": found["code"],
        "bytes": found["end"] - begin,
        "frames": cost(found["end"]) - cost(begin),
        "way": table["way"][done],
        **_ends(table, first, process[stream], process[streams.reverse[stream]]),
    }


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
    gathered: Gathered,
    made: list[bytes],
    members: list[list[int]],
    found: Columns,
    rows: Columns,
) -> tuple[Bytes, Columns, Array]:
    """Add the rows of messages that fragments make; the bytes of fragments go to them.

    Return the bytes of these messages, the messages as `zenoh.parse` does, and the row of the
    fragment that completed each.
    """
    length = np.array([len(part) for part in made], np.int64)
    end = np.cumsum(length)
    joined = np.frombuffer(b"".join(made) + bytes(PAD), np.uint8)
    inner = zenoh.parse(joined, end - length, end)
    if unreadable := int(np.count_nonzero(inner["code"] == zenoh.UNREADABLE)):
        gathered.notes["Zenoh messages in fragments that cannot be read"] += unreadable
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
    new = take(rows, last) | {
        "kind": inner["code"],
        "submessage": inner["code"],
        "bytes": size,
        "frames": share[batch] * size / np.maximum(length[batch], 1),
    }
    gathered.rows.append(new)
    return joined, inner, last


_TOKEN, _KEY_EXPRESSION = map(zenoh.NAMES.index, ("DeclareToken", "DeclareKeyExpr"))
#: What is counted as an endpoint; a token is if it names one.
_DECLARED = [*map(zenoh.NAMES.index, ("DeclareSubscriber", "DeclareQueryable")), _TOKEN]


def _endpoint_names(data: Bytes, found: Columns, stream: Array) -> set[tuple[int, int]]:
    """Return the key expressions of endpoints of rmw_zenoh, each by its stream and number."""
    chosen = np.flatnonzero(found["code"] == _KEY_EXPRESSION)
    columns = stream[chosen], *(found[key][chosen] for key in ("number", "at", "end"))
    return {
        (of, number)
        for of, number, begin, stop in zip(*(c.tolist() for c in columns), strict=True)
        if _is_ros_endpoint(data[begin:stop].tobytes())
    }


def _declarations(
    data: Bytes, found: Columns, stream: Array, names: set[tuple[int, int]]
) -> Columns:
    """Return what messages declare: ``code``, ``number``, ``stream``, and ``ros``.

    The last says whether a token is of an endpoint of rmw_zenoh, by its text or by its name.
    """
    chosen = np.flatnonzero(np.isin(found["code"], _DECLARED))
    code, at, end = (found[key][chosen] for key in ("code", "at", "end"))
    columns = code, at, end, stream[chosen], zenoh.scopes(data, at, end)
    ros = [
        kind == _TOKEN and ((of, scope) in names or _is_ros_endpoint(data[begin:stop].tobytes()))
        for kind, begin, stop, of, scope in zip(*(c.tolist() for c in columns), strict=True)
    ]
    number = found["number"][chosen]
    return {"code": code, "number": number, "stream": stream[chosen], "ros": np.array(ros, bool)}


def _count_endpoints(gathered: Gathered, declared: Columns, process: Array) -> None:
    """Keep how many endpoints each process declares: what is not a token, and tokens.

    A process declares to each other one; what it declares is the most that it does to one.
    """
    _, first = codes(declared["stream"], declared["code"], declared["number"])
    declared = take(declared, first)
    token = declared["code"] == _TOKEN
    for index, count in Counter(declared["stream"][~token].tolist()).items():
        _declared(gathered, int(process[index]), count, tokens=False)
    tokens = take(declared, token)
    for index in np.unique(tokens["stream"]).tolist():
        count = int(tokens["ros"][tokens["stream"] == index].sum())
        _declared(gathered, int(process[index]), count, tokens=True)


def _is_ros_endpoint(text: bytes) -> bool:
    """Return whether a token is of an endpoint: publisher, subscription, service or client."""
    return b"@ros2_lv/" in text and any(
        kind in text for kind in (b"/MP/", b"/MS/", b"/SS/", b"/SC/")
    )


def _declared(gathered: Gathered, which: int, count: int, tokens: bool) -> None:
    process = gathered.processes.get(which)
    if process is None or process.serves:
        return  # a router passes on what others declare
    process.announced = True
    if tokens:
        process.tokens = max(process.tokens, count)
    elif count > len(process.endpoints):
        process.endpoints = set(range(count))


def _other_segments(
    gathered: Gathered, content: tcp.Content, streams: tcp.Streams, chosen: Array, process: Array
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
    gathered.rows.append(
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


def _note_tls(gathered: Gathered, data: Bytes, streams: tcp.Streams) -> None:
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
        gathered.notes["TCP connections with TLS, which is encrypted"] += count
