"""Read a capture: from the packets of a file to datagrams and streams, messages and tables."""

from collections.abc import Sequence
from os import PathLike
from typing import Any, BinaryIO

import numpy as np

from discostorm_capture import (
    ip,
    link_layer,
    network_events,
    pcap,
    rtps,
    tcp,
    transport,
    zenoh,
    zenoh_messages,
)
from discostorm_capture._arrays import concat, take_rows
from discostorm_capture._types import Array, Columns, DataFrame, Notes
from discostorm_capture.capture import Capture
from discostorm_capture.dissection import PROTOCOLS, Dissection, Process, Recording, categorical
from discostorm_capture.endpoints import Endpoint
from discostorm_capture.sentences import say
from discostorm_capture.transport import IpContent

NANOSECOND = 1e-9
#: Minimum steps between packets that count as a clock set back, and as set forward [ns].
_MIN_STEP_BACK, _MIN_STEP_FORWARD = 1_000_000_000, 30_000_000_000
_DIRECTIONS = ("", "up", "down")
#: Notes on packets that were sent and are not in the file.
_GAP_NOTES = (transport.MISSING_FRAGMENTS_NOTE, tcp.GAPS_NOTE)


def read_capture(path: str | PathLike[str] | BinaryIO) -> Capture:
    """Read a capture of discovery traffic.

    Parameters
    ----------
    path : str, path-like or binary file
        pcap or pcapng, also as gz or xz, of Ethernet, Linux's "any" interface, loopback, raw IP or
        802.11, also with VLAN or PPPoE. A pipe, or an open file such as ``sys.stdin.buffer``, is
        read to its end.

    Returns
    -------
    Capture
        The messages of RTPS (version 2) and Zenoh (versions 8 and 9 on the wire) in it.

    Raises
    ------
    OSError
        If the file cannot be opened.
    CaptureError
        A ValueError, if it is no capture, is broken or ends inside of a packet.
    TypeError
        If `path` is neither a path nor a file opened in binary mode.

    Examples
    --------
    >>> import discostorm as ds
    >>> from discostorm.data import data_path
    >>> capture = ds.read_capture(data_path("captures/fast_dds.pcap.xz", "discostorm_capture"))
    >>> capture.fleet()
    Fleet(groups=(HostGroup(hosts=3, processes=2, endpoints=10),))
    >>> capture.compare(ds.DDS).loc["SEDP", "expected"]
    np.float64(240.0)
    """
    packets, notes = pcap.read_packets(path), Notes()
    time = packets.table["time"]
    carried = transport.parse_transport(packets, notes)
    duplicates = transport.find_duplicate_frames(carried, time, notes)
    streams = tcp.split_streams(take_rows(carried.segments, ~duplicates[carried.segments["frame"]]))
    # The first packet need not be the earliest: clocks are set back, and files are merged.
    start = int(time.min()) if len(time) else 0
    since = (time - start) * NANOSECOND
    dissections, events = _dissect_all(carried, streams, duplicates, since, notes)
    messages, processes = _combine_dissections(dissections)
    messages["copy"] = duplicates[messages["frame"]]
    first, last = since[[0, -1]].tolist() if len(since) else (0.0, 0.0)
    step = np.diff(time)
    jumps = np.flatnonzero((step < -_MIN_STEP_BACK) | (step > _MIN_STEP_FORWARD)).tolist()
    steps = tuple((frame + 2, step[frame] * NANOSECOND) for frame in jumps)
    truncated = int(np.count_nonzero(packets.table["size"] < packets.table["length"]))
    cut = {"packets were cut when they were captured (snaplen)": truncated} if truncated else {}
    cut |= {note: count for note, count in notes.items() if note in _GAP_NOTES}
    table = _message_table(messages, since, carried, [process.name for process in processes])
    copies = table["copy"][table["multicast"]]
    frames, udp = messages["frames"].astype(np.float64), messages["udp"]
    parts = {"UDP": frames[udp], "TCP": frames[~udp]}
    without = {name: carried.packets[name] - round(float(of.sum())) for name, of in parts.items()}
    recording = Recording(
        truncated / max(len(time), 1),
        steps,
        first_packet_time=first,
        recorded_time=last - first - sum(step for _, step in steps),
        packets_without_messages=carried.packets | without,
        # A single one may be cut by the end of the capture.
        gaps=tuple(f"{count} {gap}" for gap, count in cut.items() if count > 1),
        duplicate_multicast_share=float(copies.mean()) if len(table) else 0.0,
    )
    addresses = ip.format_addresses(carried.addresses)
    return Capture(
        packets.name,
        len(time),
        start=start * NANOSECOND,
        duration=float(since.max(initial=0.0)),
        notes=_note_sentences(truncated, len(time), notes, processes, table),
        _messages=table,
        _processes=_process_table(processes, since, addresses),
        _network_events=_event_table(events, since, addresses),
        _endpoints=_endpoint_table(dissections),
        _recording=recording,
    )


def _dissect_all(
    carried: IpContent, streams: tcp.Streams, copies: Array, since: Array, notes: Notes
) -> tuple[list[Dissection], Columns]:
    """Return the messages and processes of each protocol, and network events."""
    data, datagrams, segments = carried.data, carried.datagrams, carried.segments
    is_rtps = rtps.is_rtps(data, datagrams["at"]) & (datagrams["size"] >= 4)
    transport.note_encrypted_datagrams(data, take_rows(datagrams, ~is_rtps), notes)
    messages = take_rows(datagrams, is_rtps)
    scouts, others = zenoh.split_scouting(carried, take_rows(datagrams, ~is_rtps))
    over_tcp = rtps.is_rtps_over_tcp(data, segments["at"]) & (segments["size"] >= 4)
    notes.add_where(over_tcp, "TCP segments with RTPS over TCP")
    dissections = [
        rtps.dissect_rtps(data, carried.addresses, messages, notes),
        zenoh.dissect_zenoh(carried, scouts, others, streams, notes),
    ]
    frames = np.concatenate([part.messages["frame"] for part in dissections])
    stamps = dissections[1].time_stamps
    both = datagrams, segments
    return dissections, concat(
        carried.network_events,
        network_events.two_way_exchanges(others),
        network_events.unknown_names(data, others),
        network_events.time_stamps(messages, *rtps.source_times(data, messages)),
        network_events.time_stamps(stamps, np.arange(len(stamps["frame"])), stamps["to_port"]),
        network_events.connection_events(streams),
        network_events.arrived_and_vanished_segments(streams),
        network_events.full_windows(streams, since),
        network_events.acknowledgement_jitter(streams, since),
        *map(network_events.addressed_ports, (messages, scouts)),
        *(network_events.other_traffic(of, frames) for of in both),
        *(network_events.mac_addresses(take_rows(of, ~copies[of["frame"]])) for of in both),
    )


def _combine_dissections(dissections: list[Dissection]) -> tuple[Columns, list[Process]]:
    """Return all messages by frame, and the processes to which their indices refer."""
    processes = sorted(
        (process.first_frame, number, index, process)
        for number, part in enumerate(dissections)
        for index, process in part.processes.items()
    )
    tables = []
    for number, part in enumerate(dissections):
        size = 1 + max(int(part.messages[name].max(initial=-1)) for name in ("process", "peer"))
        # Processes that are only receivers get -1, from the last element.
        positions = np.full(size + 1, -1, np.int32)
        for position, (_, of, index, _) in enumerate(processes):
            if of == number and index < size:
                positions[index] = position
        ends = {name: positions[part.messages[name]] for name in ("process", "peer")}
        tables.append(part.messages | ends)
    messages = concat(*tables)
    order = np.argsort(messages["frame"], kind="stable")
    return take_rows(messages, order), [process for *_, process in processes]


def _message_table(
    messages: Columns, since: Array, carried: IpContent, processes: list[str]
) -> DataFrame:
    """Return the messages as `Capture.messages` describes them; ``since`` has times by frame."""
    import pandas as pd

    addresses = ip.format_addresses(carried.addresses)
    protocol = messages["protocol"]
    kinds = rtps.message_kinds(), zenoh_messages.MESSAGE_KINDS, zenoh.TCP_KINDS
    submessages = rtps.SUBMESSAGE_NAMES, zenoh_messages.MESSAGE_NAMES, zenoh.TCP_KINDS
    is_rtps = protocol == PROTOCOLS.index("RTPS")
    entity = np.where(is_rtps, messages["entity"], len(rtps.ENTITY_NAMES))
    named = {
        "time": since[messages["frame"]],
        "frame": messages["frame"].astype(np.int64) + 1,
        "protocol": categorical(protocol, PROTOCOLS),
        "kind": _names_by_protocol(protocol, messages["kind"], kinds),
        "multicast": ip.is_multicast(carried.addresses)[messages["target"]],
        "bytes": messages["bytes"],
        "sender": categorical(messages["source"], addresses),
        "receiver": categorical(messages["target"], addresses),
        "way": categorical(messages["direction"] % link_layer.OUTGOING, _DIRECTIONS),
        "process": categorical(messages["process"], [*processes, ""]),
        "peer": categorical(messages["peer"], [*processes, ""]),
        "submessage": _names_by_protocol(protocol, messages["submessage"], submessages),
        "entity": categorical(entity, [*rtps.ENTITY_NAMES, ""]),
    }
    same = ("reader", "writer", "number", "missing", "size", "ends", "holes", "copy")
    named |= {name: messages[name] for name in same}
    named["transport"] = categorical(messages["udp"].astype(np.int64), ("TCP", "UDP"))
    return pd.DataFrame(named | {"frames": messages["frames"]})


def _names_by_protocol(protocol: Array, numbers: Array, names: Sequence[Sequence[str]]) -> Any:
    """Return a categorical of names, given numbers that start from 0 for each protocol."""
    first = np.cumsum([0, *map(len, names[:-1])])
    return categorical(first[protocol] + numbers, [name for part in names for name in part])


def _event_table(events: Columns, since: Array, addresses: list[str]) -> DataFrame:
    """Return the network events with names instead of numbers."""
    import pandas as pd

    table = {
        "time": since[events["frame"]],
        "frame": events["frame"] + 1,
        "kind": categorical(events["kind"], network_events.EVENT_KINDS),
        "sender": categorical(events["source"], addresses),
        "receiver": categorical(events["target"], addresses),
    }
    return pd.DataFrame(table | {"port": events["port"]})


def _endpoint_table(dissections: list[Dissection]) -> DataFrame:
    """Return the endpoints as `Capture.endpoints` describes them."""
    import pandas as pd

    names = ["process", "entity", "number", *Endpoint.__dataclass_fields__]
    rows = [
        {"process": process, "entity": entity, "number": number} | (vars(end) if end else {})
        for part in dissections
        for (process, entity), (number, end) in part.endpoints.items()
    ]
    return pd.DataFrame(rows, columns=names)


def _process_table(processes: list[Process], since: Array, addresses: list[str]) -> DataFrame:
    """Return the processes as `Capture.processes` describes them."""
    import pandas as pd

    names = [*addresses, ""]
    times = [since[p.first_frame] if p.first_frame >= 0 else np.nan for p in processes]
    announced = [" ".join(names[a] for a in p.announced_addresses) for p in processes]
    table = {
        "protocol": [PROTOCOLS[p.protocol] for p in processes],
        "product": [p.product for p in processes],
        "host": [names[p.host] for p in processes],
        "endpoints": [p.endpoints for p in processes],
        "time": times,
        "server": np.array([p.is_server for p in processes], bool),
        "domain": np.array([p.domain for p in processes], np.int64),
        "announces": announced,
        "lease": np.array([p.lease for p in processes], np.float64),
        "tag": [p.domain_tag for p in processes],
        "version": np.array([p.version for p in processes], np.int64),
        "static": np.array([p.static for p in processes], bool),
        "secured": np.array([p.has_credentials for p in processes], bool),
        "half": np.array([p.is_half for p in processes], bool),
    }
    index = pd.Index([p.name for p in processes], name="process", dtype=object)
    return pd.DataFrame(table, index=index)


def _note_sentences(
    truncated: int, packets: int, counts: Notes, processes: list[Process], messages: DataFrame
) -> tuple[str, ...]:
    """Return notes on unreadable and uncounted packets."""
    encrypted = int((messages["kind"] == "Encrypted").sum())
    silent = sum(not process.announced_anything and not process.is_server for process in processes)
    some = any(process.endpoints and not process.counts_publishers for process in processes)
    notes = {
        say("cut packets", truncated, packets): truncated,
        **{f"{count} {note}": count for note, count in counts.items()},
        say("encrypted messages", encrypted): encrypted,
        say("silent processes", silent, len(processes)): silent,
        say("no publishers"): some,
    }
    return tuple(note for note, count in notes.items() if count)
