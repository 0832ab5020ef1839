"""From a file to a capture: its messages, processes and notes."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from os import PathLike
from typing import TYPE_CHECKING, Any, BinaryIO

import numpy as np

from discostorm_capture import files, ip, network_events, rtps, zenoh
from discostorm_capture._bytes import Array, Columns, codes, stack
from discostorm_capture.dissector import PROTOCOLS, RTPS, ZENOH, Gathered, KnownProcess
from discostorm_capture.result import Capture
from discostorm_capture.zenoh_reader import TCP_KINDS, read_zenoh

if TYPE_CHECKING:
    import pandas as pd

NANOSECOND = 1e-9
#: Packets read at a time, so that what is computed on the way stays small.
_AT_A_TIME = 1 << 15
#: What is seen twice is seen within this time [ns]: on several interfaces, or up and down.
_TWICE = 1_000_000_000
AGAIN = "packets seen again, on another interface or way, or mirrored; they are not compared"
#: A clock that goes back by more than the first was set, or on by the second may have been [ns].
_BACK, _ON = 1_000_000_000, 30_000_000_000
WAYS = ("", "up", "down")
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
    "number": np.int32,
    "missing": np.int16,
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


def read_capture(path: str | PathLike[str] | BinaryIO) -> Capture:
    """Read a capture of discovery traffic.

    Parameters
    ----------
    path : str, path-like or binary file
        A file of tcpdump, Wireshark or dumpcap: pcap or pcapng, also as gz or xz; of Ethernet
        (also VLAN), Linux's "any" interface, loopback, raw IP or 802.11, with or without
        radiotap, also in PPPoE. It may hold other traffic as well. A pipe, or a file that is
        open, such as ``sys.stdin.buffer``, is read to its end.

    Returns
    -------
    Capture
        The messages of RTPS (version 2) and Zenoh (versions 8 and 9 on the wire) in it.

    Raises
    ------
    OSError
        If the file cannot be opened.
    CaptureError
        If it is no capture, is broken or ends inside of a packet; the message names the
        file and the place. It is a ValueError.
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
    packets = files.read(path)
    found = Gathered(packets)
    rows = _rows(found, len(packets.table["at"]))
    processes = _processes(found, rows)
    # Clocks are set back, and files are merged.
    time = packets.table["time"]
    begin = int(time.min()) if len(time) else 0
    since = (time - begin) * NANOSECOND
    jumps, first, last = _jumps(time), *map(float, since[[0, -1]] if len(since) else (0.0, 0.0))
    addresses = ip.names(found.addresses)
    messages = _message_table(rows, since, found, addresses, [one.name for one in processes])
    return Capture(
        path=packets.name,
        packets=len(time),
        start=begin * NANOSECOND,
        duration=float(since.max()) if len(time) else 0.0,
        notes=_notes(found, processes, messages),
        _messages=messages,
        _processes=_process_table(processes, since, addresses),
        _asides=_aside_table(found, since, addresses),
        _jumps=jumps,
        _first=first,
        _last=last - first - sum(step for _, step in jumps),
        _others=_others(found, rows, len(time)),
        _lost=tuple(found.lost()),
        _cut=found.cut,
    )


def _rows(found: Gathered, size: int) -> Columns:
    """Return the messages in so many packets, in the order of the frames that completed them."""
    for begin in range(0, size, _AT_A_TIME):
        found.packets_of(begin, min(begin + _AT_A_TIME, size))
    found.fragments()
    found.note_domains()
    copies = _copies(found, size)
    read_zenoh(found, copies)
    # What is complete is taken away, so that nothing is held twice for long.
    parts, found.rows = [{}, *found.rows], []
    rows = stack([_complete(parts.pop(0)) for _ in range(len(parts))])
    rows["copy"] = copies[rows["frame"]]
    order = np.argsort(rows["frame"], kind="stable")
    for name in list(rows):
        rows[name] = rows[name][order]
    return rows


def _complete(part: Columns) -> Columns:
    """Return all columns of messages; what a part lacks is 0, of processes -1."""
    size = len(part["frame"]) if part else 0
    return {
        name: part[name].astype(kind, copy=False)
        if name in part
        else np.full(size, -1 if name in ("process", "peer") else 0, kind)
        for name, kind in _TYPES.items()
    }


def _copies(found: Gathered, size: int) -> Array:
    """Return of each frame whether it shows what another one showed before.

    That is so on another interface or way, and where a mirror port or a merged file has it twice:
    who numbers packets does not use a number again that soon (RFC 6864, 4.1).
    """
    copies = np.zeros(size, bool)
    if not found.sights:
        return copies
    sights = stack(found.sights)
    found.sights = []
    keys = ("source", "target", "from_port", "to_port", "id", "wire", "check", "tail")
    code, _ = codes(*(sights[key] for key in keys))
    many = np.flatnonzero(np.bincount(code)[code] > 1)
    order = many[np.lexsort((sights["frame"][many], code[many]))]
    group, view, frame = code[order], sights["view"][order], sights["frame"][order]
    time = found.packets.table["time"][frame]
    told = (sights["id"][order] > 0) & (sights["check"][order] > 0)
    again = (sights["retry"] > 0)[order] | told
    now, since, place = -1, 0, 0
    for which, when, where, numbered, number_ in zip(
        group.tolist(), time.tolist(), view.tolist(), again.tolist(), frame.tolist(), strict=True
    ):
        same = which == now and when - since <= _TWICE and (where != place or numbered)
        if same:
            copies[number_] = True
        else:
            now, since, place = which, when, where
    if count := int(np.count_nonzero(copies)):
        found.notes[AGAIN] += count
    return copies


def _processes(found: Gathered, rows: Columns) -> list[KnownProcess]:
    """Return the processes in the order in which they appeared; rows get their places there."""
    prefixes = list(found.prefixes.known)
    for which, process in found.processes.items():
        if process.protocol == RTPS:
            process.name = prefixes[which].hex()
            if process.serves:
                process.product += " Discovery Server"
    nobody = found.prefixes.known.get(bytes(12), -1)
    found.processes.pop(nobody, None)
    order = sorted(found.processes, key=lambda which: (found.processes[which].since, which))
    # Numbers of RTPS are from 0 on, those of Zenoh from -2 down.
    least = min([*order, -1])
    most = max([*order, len(prefixes) - 1, -1])
    place = np.full(most - least + 1, -1, np.int32)
    for index, which in enumerate(order):
        place[which - least] = index
    processes = [found.processes[which] for which in order]
    # Somebody who is only spoken to is not known otherwise.
    for name in ("process", "peer"):
        rows[name] = place[rows[name] - least]
    return processes


def _message_table(
    rows: Columns, since: Array, found: Gathered, addresses: list[str], processes: list[str]
) -> pd.DataFrame:
    """Return the messages as `Capture.messages` describes them; ``since`` is when frames came."""
    import pandas as pd

    multicast = ip.multicast(found.addresses)
    protocol = rows["protocol"]
    kinds = rtps.kind_names(), zenoh.KINDS, TCP_KINDS
    submessages = rtps.submessage_names(), zenoh.NAMES, TCP_KINDS
    entity = np.where(protocol == RTPS, rows["entity"], len(rtps.ENTITY_NAMES))
    return pd.DataFrame(
        {
            "time": since[rows["frame"]],
            "frame": rows["frame"].astype(np.int64) + 1,
            "protocol": _words(protocol, PROTOCOLS),
            "kind": _words_of_three(protocol, rows["kind"], kinds),
            "multicast": multicast[rows["target"]] if len(multicast) else rows["copy"],
            "bytes": rows["bytes"],
            "sender": _words(rows["source"], addresses),
            "receiver": _words(rows["target"], addresses),
            "way": _words(rows["way"], WAYS),
            "process": _words(rows["process"], [*processes, ""]),
            "peer": _words(rows["peer"], [*processes, ""]),
            "submessage": _words_of_three(protocol, rows["submessage"], submessages),
            "entity": _words(entity, [*rtps.ENTITY_NAMES, ""]),
            "reader": rows["reader"],
            "writer": rows["writer"],
            "number": rows["number"],
            "missing": rows["missing"],
            "size": rows["size"],
            "ends": rows["ends"],
            "copy": rows["copy"],
            "transport": _words(rows["udp"].astype(np.int64), ("TCP", "UDP")),
            "frames": rows["frames"],
        }
    )


def _jumps(time: Array) -> tuple[tuple[int, float], ...]:
    """Return where the time of packets is set back, or on by so much that a clock may have been."""
    step = np.diff(time)
    frames = np.flatnonzero((step < -_BACK) | (step > _ON))
    return tuple((frame + 2, step[frame] * NANOSECOND) for frame in frames.tolist())


def _others(found: Gathered, rows: Columns, packets: int) -> dict[str, int]:
    """Return how many packets there are without a message."""
    all_, udp = (float(part.sum()) for part in (rows["frames"], rows["frames"][rows["udp"]]))
    told = {"UDP": udp, "TCP": all_ - udp}
    arp = int(sum((rows["kind"] <= network_events.LAST_OF_ARP).sum() for rows in found.asides))
    some = {name: found.mix[name] - round(told[name]) for name in ("UDP", "TCP")}
    return {"ARP": arp, **some, "other": packets - arp - found.mix["UDP"] - found.mix["TCP"]}


def _aside_table(found: Gathered, since: Array, addresses: list[str]) -> pd.DataFrame:
    """Return what is no discovery, and tells why it fails, by time."""
    import pandas as pd

    rows = stack(found.asides or [network_events.none()])
    return pd.DataFrame(
        {
            "time": since[rows["frame"]],
            "frame": rows["frame"] + 1,
            "kind": _words(rows["kind"].astype(np.int64), network_events.KINDS),
            "sender": _words(rows["source"], addresses),
            "receiver": _words(rows["target"], addresses),
            "port": rows["port"],
        }
    )


def _words_of_three(protocol: Array, numbers: Array, names: Sequence[Sequence[str]]) -> Any:
    """Return names by their numbers, which each protocol counts from 0 on."""
    first = np.cumsum([0, *map(len, names[:-1])])
    return _words(first[protocol] + numbers, [name for some in names for name in some])


def _words(numbers: Array, names: Sequence[str]) -> Any:
    """Return names by their numbers, -1 for the last one; only those used are kept."""
    import pandas as pd

    dtype, number_of = _distinct(tuple(names))
    return pd.Categorical.from_codes(number_of[numbers], dtype=dtype).remove_unused_categories()


@lru_cache(maxsize=16)
def _distinct(names: tuple[str, ...]) -> tuple[pd.CategoricalDtype, Array]:
    """Return each name once, and which of these each is: a name may have several numbers."""
    import pandas as pd

    known = {name: index for index, name in enumerate(dict.fromkeys(names))}
    number_of = np.array([known[name] for name in names], np.int32)
    return pd.CategoricalDtype([*known]), number_of


def _process_table(
    processes: list[KnownProcess], since: Array, addresses: list[str]
) -> pd.DataFrame:
    """Return the processes as `Capture.processes` describes them."""
    import pandas as pd

    return pd.DataFrame(
        {
            "protocol": [PROTOCOLS[one.protocol] for one in processes],
            "product": [one.product for one in processes],
            "host": [addresses[one.host] if one.host >= 0 else "" for one in processes],
            "endpoints": [_endpoints(one) for one in processes],
            "time": [float(since[one.since]) if one.since >= 0 else np.nan for one in processes],
            "server": np.array([one.serves for one in processes], bool),
            "domain": np.array([one.domain for one in processes], np.int64),
            "announces": [
                " ".join(addresses[told] for told in one.told if told >= 0) for one in processes
            ],
        },
        index=pd.Index([one.name for one in processes], name="process", dtype=object),
    )


def _endpoints(process: KnownProcess) -> int:
    """Return how many endpoints a process announced, without those of discovery itself."""
    if process.protocol == ZENOH:
        return process.tokens or len(process.endpoints)
    return sum(1 for id_ in process.endpoints if not id_ & 0xC0)


def _notes(
    found: Gathered, processes: list[KnownProcess], messages: pd.DataFrame
) -> tuple[str, ...]:
    notes = []
    packets = found.packets.table
    if cut := int(np.count_nonzero(packets["size"] < packets["length"])):
        notes.append(
            f"{cut} of {len(packets['size'])} packets were cut when they were captured (snaplen): "
            "what they held is missing, counts are lower bounds"
        )
    notes += [f"{count} {what}" for what, count in found.notes.items()]
    if encrypted := int((messages["kind"] == "Encrypted").sum()):
        notes.append(
            f"{encrypted} messages of RTPS encrypted by DDS Security: of unknown kind, counted as "
            "discovery, though user data may be among them"
        )
    if silent := sum(1 for one in processes if not one.announced and not one.serves):
        notes.append(
            f"{silent} of {len(processes)} processes of which no announcement was "
            "captured: their endpoints are not known"
        )
    if any(p.protocol == ZENOH and p.endpoints and not p.tokens for p in processes):
        notes.append(
            "Zenoh does not announce publishers: its endpoints are subscribers and queryables alone"
        )
    return tuple(notes)
