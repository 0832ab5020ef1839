"""Events that explain why discovery fails: ARP, ICMP errors, TCP connections, lost segments."""

from collections import defaultdict
from typing import Any

import numpy as np

from discostorm_capture import ip, link_layer, tcp
from discostorm_capture._arrays import IdTable, concat, factorize, numbers_at, take_rows
from discostorm_capture._types import Array, Bytes, Columns

#: Kinds of events. Instead of a port, ARP and MAC have the sender's MAC address, "to MAC" has the
#: receiver's, and segments that arrived or vanished their payload size [B], time stamps their
#: seconds, other traffic its bytes, jitter and full windows their milliseconds, and incomplete
#: datagrams the size of a fragment [B].
EVENT_KINDS = (
    *("ARP request", "ARP reply", "unreachable"),
    *("connection", "refused", "unanswered", "half", "exchange", "arrived", "vanished", "asked"),
    *("time stamp", "parts missing", "other traffic", "MAC", "prohibited"),
    *("jitter", "incomplete", "unknown name", "to MAC", "full window"),
    "own address",
)
_ARP_REQUEST, _ARP_REPLY, _UNREACHABLE, _CONNECTION, _REFUSED, _UNANSWERED = range(6)
_HALF_OPEN, _EXCHANGE, _ARRIVED, _VANISHED, _PORT_ADDRESSED = range(6, 11)
_TIME_STAMP, _PARTS, _OTHER, _MAC, _PROHIBITED = range(11, 16)
_JITTER, _INCOMPLETE, _NO_NAME, _TO_MAC, _FULL_WINDOW, _OWN_ADDRESS = range(16, 22)
_ARP_BYTES, _DESTINATION_UNREACHABLE, _REASSEMBLY_TIMEOUT = 28, 3, 0x0B01
_ECHO_REPLY, _ECHO_REQUEST = 0, 8
#: ICMP codes of a firewall that rejects a packet: network, host or communication (RFC 1812).
_PROHIBITED_CODES = (9, 10, 13)
#: A segment has vanished after this many transmissions without an acknowledgement.
_MIN_TRANSMISSIONS = 3
_DNS_PORT, _DNS_HEADER_BYTES = 53, 12
#: The delays of a stream, and of pings, are compared if there are so many.
_MIN_DELAYS, _MIN_ECHOES = 50, 10


def _event_table(kind: Array | int, **columns: Array) -> Columns:
    """Return a table of events."""
    return {"kind": np.full(len(columns["frame"]), kind)} | columns


def arp_events(data: Bytes, packets: Columns, addresses: IdTable) -> Columns:
    """Return ARP requests and replies (RFC 826)."""
    packets = take_rows(packets, packets["ethertype"] == link_layer.ARP)
    packets = take_rows(packets, packets["end"] - packets["at"] >= _ARP_BYTES)
    at = packets["at"]
    mac = numbers_at(data, at + 8, ">u4").astype(np.int64) << 16 | numbers_at(data, at + 12, ">u2")
    return _event_table(
        np.where(numbers_at(data, at + 6, ">u2") == 1, _ARP_REQUEST, _ARP_REPLY),
        frame=packets["frame"],
        source=addresses.ids_of(data, at + 14, 4),
        target=addresses.ids_of(data, at + 24, 4),
        port=mac,
    )


def icmp_unreachable_events(data: Bytes, packets: Columns, addresses: IdTable) -> Columns:
    """Return hosts and ports that ICMP reports as unreachable or lacking fragments (RFC 792)."""
    long = packets["end"] - packets["at"] >= 36
    packets = take_rows(packets, (packets["protocol"] == ip.ICMP) & long & (packets["offset"] == 0))
    lacks = numbers_at(data, packets["at"], ">u2") == _REASSEMBLY_TIMEOUT
    chosen = lacks | (data[packets["at"]] == _DESTINATION_UNREACHABLE)
    packets = take_rows(packets | {"lacks": lacks}, chosen)
    inner = packets["at"] + 8
    port_at = inner + (data[inner] & 15).astype(np.int64) * 4 + 2
    inside = port_at + 2 <= packets["end"]
    packets, port_at = take_rows(packets, inside), port_at[inside]
    kind = np.where(data[packets["at"] + 17] == ip.TCP, _REFUSED, _UNREACHABLE)
    kind = np.where(np.isin(data[packets["at"] + 1], _PROHIBITED_CODES), _PROHIBITED, kind)
    return _event_table(
        np.where(packets["lacks"], _PARTS, kind),
        frame=packets["frame"],
        source=packets["target"],  # the sender of the rejected datagram gets the ICMP message
        target=addresses.ids_of(data, packets["at"] + 8 + 16, 4),
        port=numbers_at(data, port_at, ">u2").astype(np.int64),
    )


def connection_events(streams: tcp.Streams) -> Columns:
    """Return TCP connections: one event per attempt, by its outcome, and those open before."""
    table, first, reverse = streams.segments, streams.first_segment, streams.opposite
    flags = table["flags"]
    syn, ack, rst = (flags & bit > 0 for bit in (tcp.SYN, tcp.ACK, tcp.RST))
    answers, acknowledges, resets = (
        np.bincount(table["stream"][mask], minlength=len(first)) > 0
        for mask in (syn & ack, ack & ~syn, rst)
    )
    asks = np.flatnonzero((flags[first] & (tcp.SYN | tcp.ACK)) == tcp.SYN)
    is_open = (flags[first] & (tcp.SYN | tcp.RST)) == 0
    is_open &= is_open[reverse] & (reverse != np.arange(len(first)))
    back = reverse[asks]
    captured = back != asks
    answered = answers[back] & captured
    cases = [answered & acknowledges[asks], answered, resets[back] & captured]
    kind = np.select(cases, [_CONNECTION, _HALF_OPEN, _REFUSED], _UNANSWERED)
    calls = _events_of_rows(kind, table, first[asks])
    return concat(calls, _events_of_rows(_EXCHANGE, table, first[is_open]))


def arrived_and_vanished_segments(streams: tcp.Streams) -> Columns:
    """Return each stream's largest arrived segment, and every vanished one."""
    table = streams.segments
    wire, stream = table["wire"], table["stream"]
    there = np.flatnonzero(table["arrived"] & (wire > 0) & (streams.opposite[stream] != stream))
    there = there[np.lexsort((-wire[there], stream[there]))]
    largest = there[np.diff(stream[there], prepend=-1) != 0]
    lost = np.flatnonzero(~table["arrived"] & (wire > 0))
    code, first = factorize(stream[lost], table["position"][lost])
    often = lost[first[np.bincount(code, minlength=len(first)) >= _MIN_TRANSMISSIONS]]
    kinds = (_ARRIVED, largest), (_VANISHED, often)
    tables = (_events_of_rows(kind, table, rows) | {"port": wire[rows]} for kind, rows in kinds)
    return concat(*tables)


def full_windows(streams: tcp.Streams, since: Array) -> Columns:
    """Return one event for each time in which a sender of segments takes no data (RFC 9293)."""
    table = streams.segments
    full = (table["window"] == 0) & (table["flags"] & (tcp.SYN | tcp.FIN | tcp.RST) == 0)
    changes = np.diff(full, prepend=False) | (np.diff(table["stream"], prepend=-1) != 0)
    rows = np.flatnonzero(full)
    _, first, count = np.unique(np.cumsum(changes)[rows], return_index=True, return_counts=True)
    time, last = since[table["frame"][rows]], first + count - 1
    lasts = (1e3 * (time[last] - time[first])).astype(np.int64)
    return _events_of_rows(_FULL_WINDOW, table, rows[first]) | {"port": lasts}


def acknowledgement_jitter(streams: tcp.Streams, since: Array) -> Columns:
    """Return one event for each stream of many segments: by how much their delays differ [ms]."""
    delays = [of for of in tcp.acknowledgement_delays(streams, since) if len(of[1]) >= _MIN_DELAYS]
    return _jitter(streams.segments, delays)


def echo_jitter(data: Bytes, packets: Columns, since: Array) -> Columns:
    """Return the events of `acknowledgement_jitter` for ICMP echoes (`ping`), by pair of hosts."""
    packets = take_rows(packets, (packets["protocol"] == ip.ICMP) & (packets["offset"] == 0))
    ends = (packets[name].tolist() for name in ("source", "target"))
    number = numbers_at(data, packets["at"] + 4, ">u4").tolist()
    asked = dict[tuple[int, ...], int]()
    delays = defaultdict[tuple[int, int], dict[int, float]](dict)
    time = since[packets["frame"]]
    for row, (source, target, one) in enumerate(zip(*ends, number, strict=True)):
        if data[packets["at"][row]] == _ECHO_REQUEST:
            asked[source, target, one] = row
        elif (sent := asked.pop((target, source, one), -1)) >= 0:
            delays[target, source][sent] = time[row] - time[sent]
    often = [(min(of), [*of.values()]) for of in delays.values() if len(of) >= _MIN_ECHOES]
    return _jitter(packets | {"to_port": packets["frame"]}, often)


def _jitter(table: Columns, delays: list[tuple[int, Any]]) -> Columns:
    """Return one event for each row of a table, given delays [s]: by how much these differ [ms].

    That is the 90 % less the 10 % quantile, which a long but steady path does not raise.
    """
    rows = np.array([row for row, _ in delays], np.int64)
    jitter = [1e3 * np.diff(np.quantile(of, (0.1, 0.9))).item() for _, of in delays]
    return _events_of_rows(_JITTER, table, rows) | {"port": np.array(jitter, np.int64)}


def addressed_ports(datagrams: Columns) -> Columns:
    """Return one event for each sender, receiver and destination port of datagrams."""
    _, first = factorize(datagrams["source"], datagrams["target"], datagrams["to_port"])
    return _events_of_rows(_PORT_ADDRESSED, datagrams, first)


def time_stamps(datagrams: Columns, rows: Array, seconds: Array) -> Columns:
    """Return one event for each sender and time stamp of datagrams."""
    _, first = factorize(datagrams["source"][rows], seconds)
    return _events_of_rows(_TIME_STAMP, datagrams, rows[first]) | {"port": seconds[first]}


def other_traffic(packets: Columns, frames: Array) -> Columns:
    """Return one event for each flow of datagrams or segments without a message in `frames`."""
    names = ("source", "target", "from_port", "to_port")
    code, first = factorize(*(packets[name] for name in names))
    used = np.bincount(code[np.isin(packets["frame"], frames)], minlength=len(first)) > 0
    return _flows(packets, code, first[~used])


def icmp_echoes(data: Bytes, packets: Columns) -> Columns:
    """Return one event of other traffic for each sender and receiver of ICMP echoes (`ping`)."""
    packets = take_rows(packets, (packets["protocol"] == ip.ICMP) & (packets["offset"] == 0))
    packets = take_rows(packets, np.isin(data[packets["at"]], (_ECHO_REPLY, _ECHO_REQUEST)))
    return _flows(packets, *factorize(packets["source"], packets["target"]))


def mac_addresses(packets: Columns) -> Columns:
    """Return two events for each IPv4 sender and MAC address, the first and the last packet.

    And one for each pair of sender and receiver, and MAC address to which the packets go.
    """
    packets = take_rows(packets, (packets["mac"] > 0) & (packets["ethertype"] == link_layer.IPV4))
    code, first = factorize(packets["source"], packets["mac"])
    last = np.full(len(first), -1)
    np.maximum.at(last, code, np.arange(len(code)))
    rows = np.concatenate([first, last])
    own = _events_of_rows(_MAC, packets, rows) | {"port": packets["mac"][rows]}
    _, first = factorize(packets["source"], packets["target"], packets["to_mac"])
    to = _events_of_rows(_TO_MAC, packets, first) | {"port": packets["to_mac"][first]}
    return concat(own, to)


def own_addresses(packets: Columns) -> Columns:
    """Return one event for each address from which the recording host sends, and no other host."""
    sent = packets["direction"] == link_layer.OUTGOING
    came = ~sent & (packets["source"] != packets["target"])  # a router sends on what came
    source, first = np.unique(packets["source"][sent], return_index=True)
    rows = np.flatnonzero(sent)[first[~np.isin(source, packets["source"][came])]]
    columns = {name: packets[name][rows] for name in ("frame", "source", "target")}
    return _event_table(_OWN_ADDRESS, **columns, port=np.zeros(len(rows), np.int64))


def incomplete_datagrams(fragments: Columns, rows: Array) -> Columns:
    """Return one event for each datagram that lacks fragments, given one fragment of each."""
    columns = {name: fragments[name][rows] for name in ("frame", "source", "target")}
    return _event_table(_INCOMPLETE, **columns, port=fragments["wire"][rows])


def unknown_names(data: Bytes, datagrams: Columns) -> Columns:
    """Return one event for each reply of DNS that a name does not exist (RFC 1035, RCODE 3)."""
    flags = numbers_at(data, datagrams["at"] + 2, ">u2")
    replies = (datagrams["from_port"] == _DNS_PORT) & (datagrams["size"] >= _DNS_HEADER_BYTES)
    chosen = replies & (flags & 0x800F == 0x8003)
    return _events_of_rows(_NO_NAME, datagrams, np.flatnonzero(chosen))


def two_way_exchanges(datagrams: Columns) -> Columns:
    """Return the pairs of sockets with datagrams both ways, one event per direction."""
    sender, receiver = ip.sender_and_receiver_sockets(datagrams)
    _, first = factorize(sender, receiver)
    first = first[datagrams["source"][first] != datagrams["target"][first]]
    pairs = list(zip(sender[first].tolist(), receiver[first].tolist(), strict=True))
    back = {(receiver, sender) for sender, receiver in pairs}
    both = np.array([pair in back for pair in pairs], bool)
    return _events_of_rows(_EXCHANGE, datagrams, first[both])


def _flows(packets: Columns, code: Array, first: Array) -> Columns:
    """Return one event for each flow, given the first packets, with the flow's bytes."""
    octets = np.bincount(code, packets["wire"]).astype(np.int64)
    flows = {name: packets[name][first] for name in ("frame", "source", "target")}
    return _event_table(_OTHER, **flows, port=octets[code[first]])


def _events_of_rows(kind: Array | int, table: Columns, rows: Array) -> Columns:
    """Return events of a kind at the chosen rows of a table of packets."""
    columns = {name: table[name][rows] for name in ("frame", "source", "target")}
    return _event_table(kind, **columns, port=table["to_port"][rows])
