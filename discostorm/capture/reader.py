"""From a file to the table of its messages."""

from collections import Counter
from dataclasses import dataclass
from os import PathLike
from typing import Any, BinaryIO

import numpy as np

from discostorm.capture import files
from discostorm.capture._bytes import Array, Columns, Numbers, codes, stack
from discostorm.capture.gathered import RTPS, Gathered, Process
from discostorm.capture.zenoh_reader import read_zenoh

#: Packets read at a time, so that what is computed on the way stays small.
_AT_A_TIME = 1 << 15
#: What is seen twice is seen within this time [ns]: on several interfaces, or up and down.
_TWICE = 1_000_000_000
WAYS = ("", "up", "down")


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


def read(path: str | PathLike[str] | BinaryIO) -> Reading:
    """Return what a file tells; see `discostorm.read_capture`."""
    packets = files.read(path)
    gathered = Gathered(packets)
    size = len(packets.table["at"])
    for begin in range(0, size, _AT_A_TIME):
        gathered.packets_of(begin, min(begin + _AT_A_TIME, size))
    gathered.fragments()
    if (count := len(gathered.domains)) > 1:
        which = ", ".join(map(str, sorted(gathered.domains)))
        gathered.notes[
            f"domains of RTPS ({which}): only processes of the same one find each other, which "
            "the fleet does not know"
        ] = count
    copies = _copies(gathered, size)
    read_zenoh(gathered, copies)
    cut = int(np.count_nonzero(packets.table["size"] < packets.table["length"]))
    time = packets.table["time"]
    parts = [*gathered.rows, _no_rows()]
    gathered.rows = []
    rows = stack([_complete(parts.pop(0)) for _ in range(len(parts))])
    rows["copy"] = copies[rows["frame"]]
    order = np.argsort(rows["frame"], kind="stable")
    for name in list(rows):
        rows[name] = rows[name][order]
    processes = _processes(gathered, rows)
    return Reading(
        packets.name, rows, time, gathered.addresses, processes, gathered.notes, size, cut
    )


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


def _copies(gathered: Gathered, size: int) -> Array:
    """Return of each frame whether it shows what another one showed before."""
    copies = np.zeros(size, bool)
    if not gathered.sights:
        return copies
    sights = stack(gathered.sights)
    gathered.sights = []
    keys = ("source", "target", "from_port", "to_port", "id", "wire", "check", "tail")
    code, _ = codes(*(sights[key] for key in keys))
    many = np.flatnonzero(np.bincount(code)[code] > 1)
    order = many[np.lexsort((sights["frame"][many], code[many]))]
    group, view, frame = code[order], sights["view"][order], sights["frame"][order]
    time, retry = gathered.packets.table["time"][frame], sights["retry"][order]
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
        gathered.notes[
            "packets seen again, on another interface or way; they are not compared"
        ] += count
    return copies


def _processes(gathered: Gathered, rows: Columns) -> list[Process]:
    """Return the processes in the order in which they appeared; rows get their places there."""
    prefixes = list(gathered.prefixes.known)
    for which, process in gathered.processes.items():
        if process.protocol == RTPS:
            process.name = prefixes[which].hex()
    nobody = gathered.prefixes.known.get(bytes(12), -1)
    gathered.processes.pop(nobody, None)
    order = sorted(gathered.processes, key=lambda which: (gathered.processes[which].since, which))
    # Numbers of RTPS are from 0 on, those of Zenoh from -2 down.
    least = min([*order, -1])
    most = max([*order, len(prefixes) - 1, -1])
    place = np.full(most - least + 1, -1, np.int32)
    for index, which in enumerate(order):
        place[which - least] = index
    found = [gathered.processes[which] for which in order]
    # Somebody who is only spoken to is not known otherwise.
    for name in ("process", "peer"):
        rows[name] = place[rows[name] - least]
    return found
