"""Packets in the bytes of a file: pcap and pcapng, to the place of every packet."""

import struct
from array import array
from dataclasses import dataclass, replace

import numpy as np

from discostorm_capture._bytes import (
    Array,
    Bytes,
    Columns,
    Places,
    number,
    numbers,
    stack,
    take,
    view,
)

#: The first four bytes of a pcap file, as they stand there: byte order, nanoseconds of a tick, and
#: the length of a packet's header (the last two are of a patched libpcap).
PCAP = {
    b"\xa1\xb2\xc3\xd4": (">", 1000, 16),
    b"\xd4\xc3\xb2\xa1": ("<", 1000, 16),
    b"\xa1\xb2\x3c\x4d": (">", 1, 16),
    b"\x4d\x3c\xb2\xa1": ("<", 1, 16),
    b"\xa1\xb2\xcd\x34": (">", 1000, 24),
    b"\x34\xcd\xb2\xa1": ("<", 1000, 24),
}
PCAPNG = b"\x0a\x0d\x0d\x0a"
#: The byte order of a section of pcapng, by what stands behind its length.
_ORDERS = {b"\x1a\x2b\x3c\x4d": ">", b"\x4d\x3c\x2b\x1a": "<"}
#: Block types: packets with all, without time, of an old kind; interfaces; sections.
_ENHANCED, _SIMPLE, _OLD, _INTERFACE, _SECTION = 6, 3, 2, 1, 0x0A0D0D0A
#: Of each kind of block the bytes around its packet; of any other the least that it has.
_AROUND, _LEAST = {_ENHANCED: 32, _SIMPLE: 16, _OLD: 32}, 12
#: Options of an interface: the end, ticks of its clock, seconds to add.
_END, _RESOLUTION, _OFFSET = 0, 9, 14
#: Longest packet that libpcap writes [B]; USB and the like have longer ones.
MOST = 262_144
SECOND = 1_000_000_000


class CaptureError(ValueError):
    """A file that cannot be read as a capture; the message says which, where and why."""


@dataclass(frozen=True)
class Packets:
    """All packets of a file.

    Parameters
    ----------
    name : str
        What the file is called.
    data : numpy.ndarray
        The bytes of the file, expanded, and padding.
    table : dict
        One row a packet: ``at``, its first byte; ``size``, the bytes of it in the file;
        ``length``, its bytes on the wire; ``time`` [ns]; ``interface``.
    links : tuple of int
        Link type of each interface.
    """

    name: str
    data: Bytes
    table: Columns
    links: tuple[int, ...]


def packets_of(name: str, data: Bytes, size: int) -> Packets:
    """Return the packets in so many bytes, behind which there is padding.

    Raises
    ------
    CaptureError
        If they are broken or end inside of a packet.
    """
    magic = data[:4].tobytes()
    found = _pcap(name, data, size, *PCAP[magic]) if magic in PCAP else _pcapng(name, data, size)
    if len(too_long := np.flatnonzero(found.table["size"] > MOST)):
        where = int(too_long[0])
        raise CaptureError(
            f"{name}: byte {int(found.table['at'][where])}: packet {where + 1} is broken: it has "
            f"{int(found.table['size'][where])} bytes; there are at most {MOST}"
        )
    return found


def _pcap(name: str, data: Bytes, size: int, order: str, tick: int, header: int) -> Packets:
    if size < 24:
        raise CaptureError(f"{name}: byte {size}: it ends inside of its header")
    source, read = view(data), struct.Struct(order + "I").unpack_from
    (link,) = read(source, 20)
    at, places = 24, array("q")
    while at + header <= size:
        places.append(at)
        at += header + read(source, at + 8)[0]
    # Behind its last packet a file has nothing.
    if at != size:
        whole = len(places) - (len(places) > 0 and at > size)
        where = places[whole] if whole < len(places) else at
        raise CaptureError(
            f"{name}: byte {where}: packet {whole + 1} is cut or broken; the first "
            f"{where} bytes of the file hold {whole} whole packets; to keep these: "
            f"head -c {where} FILE > WHOLE"
        )
    place = np.array(places, np.int64)
    head = numbers(data, place, order + "u4", 4)
    seconds, fraction, held, sent = head.T.astype(np.int64, order="C")
    table: Columns = {
        "at": place + header,
        "size": held,
        "length": sent,
        "time": seconds * SECOND + fraction * tick,
        "interface": np.zeros(len(place), np.int64),
    }
    # The upper bits of the link type tell of check sequences.
    return Packets(name, data, table, (link & 0xFFFF,))


@dataclass(frozen=True)
class _Interface:
    """What a pcapng file says of an interface: link type, longest packet kept, clock."""

    link: int
    snaplen: int
    resolution: int = 6
    offset: int = 0


def _nanoseconds(ticks: Array, resolution: int) -> Array:
    """Return the time of the ticks of a clock [ns]; its resolution is as the file says it."""
    power = resolution & 0x7F
    if resolution & 0x80:
        return (ticks / 2.0**power * 1e9).clip(0, 2**62).astype(np.int64)
    if power <= 9:
        return (ticks * np.uint64(10 ** (9 - power))).astype(np.int64)
    return (ticks // np.uint64(10 ** min(power - 9, 19))).astype(np.int64)


def _pcapng(name: str, data: Bytes, size: int) -> Packets:
    order = _order(name, data, 0)
    source, read = view(data), struct.Struct(order + "II").unpack_from
    interfaces: list[_Interface] = []
    #: Of each section, how many interfaces there are before it.
    before: list[int] = []
    #: Of each kind of packet, where its blocks start, and in which section each is.
    blocks = {kind: (array("q"), array("q")) for kind in _AROUND}
    at = 0
    while at + _LEAST <= size:
        kind, length = read(source, at)
        if kind == _SECTION and _order(name, data, at) != order:
            raise CaptureError(
                f"{name}: byte {at}: a section in another byte order than the first one; "
                "editcap, which comes with Wireshark, writes the file anew in one order"
            )
        if length < _LEAST or length % 4 or at + length > size:
            break
        if kind == _SECTION:
            before.append(len(interfaces))
        elif kind == _INTERFACE:
            interfaces.append(_interface(name, source, at, length, order))
        elif kind in _AROUND:
            if length < _AROUND[kind]:
                raise CaptureError(f"{name}: byte {at}: a packet's block has {length} bytes")
            places, sections = blocks[kind]
            places.append(at)
            sections.append(len(before) - 1)
        at += length
    first = np.array([*before, len(interfaces)], np.int64)
    tables = []
    for kind, (places, sections) in blocks.items():
        section = np.array(sections, np.int64)
        ranges = first[section], first[section + 1]
        tables.append(
            _packets(name, data, kind, np.array(places, np.int64), order, interfaces, ranges)
        )
    table = stack(tables)
    # What is wrong with a packet before this place is said first.
    if at < size:
        raise CaptureError(
            f"{name}: byte {at}: a block of {read(source, at)[1]} bytes is cut or broken; the "
            f"first {at} bytes of the file hold whole ones"
        )
    table = take(table, np.argsort(table["at"], kind="stable"))
    return Packets(name, data, table, tuple(interface.link for interface in interfaces))


def _order(name: str, data: Bytes, at: int) -> str:
    """Return the byte order of the section that starts at a place."""
    order = _ORDERS.get(data[at + 8 : at + 12].tobytes())
    if order is None:
        raise CaptureError(f"{name}: byte {at}: a section without a byte order")
    return order


def _interface(name: str, source: memoryview, at: int, length: int, order: str) -> _Interface:
    if length < 20:
        raise CaptureError(f"{name}: byte {at}: an interface's block has {length} bytes")
    link, _, snaplen = struct.unpack_from(order + "HHI", source, at + 8)
    found = _Interface(link, snaplen)
    option, end = at + 16, at + length - 4
    while option + 4 <= end:
        code, size = struct.unpack_from(order + "HH", source, option)
        value = option + 4
        if code == _END or value + size > end:
            break
        if code == _RESOLUTION and size == 1:
            found = replace(found, resolution=source[value])
        elif code == _OFFSET and size == 8:
            (offset,) = struct.unpack_from(order + "q", source, value)
            found = replace(found, offset=max(-(2**32), min(offset, 2**32)))
        option = value + (size + 3 & ~3)
    return found


def _packets(
    name: str,
    data: Bytes,
    kind: int,
    at: Places,
    order: str,
    interfaces: list[_Interface],
    ranges: tuple[Array, Array],
) -> Columns:
    """Return the packets in blocks of a kind.

    ``ranges`` says of each block which interfaces its section has: from the first number to
    before the second one.
    """
    first, behind = ranges
    room = number(data, at + 4, order + "u4").astype(np.int64) - _AROUND[kind]
    interface = first
    if kind != _SIMPLE:
        which = number(data, at + 8, order + ("u4" if kind == _ENHANCED else "u2"))
        interface = first + which
    if len(missing := np.flatnonzero(interface >= behind)):
        where = int(at[missing[0]])
        raise CaptureError(f"{name}: byte {where}: a packet of an interface that is not there")
    time = np.zeros(len(at), np.int64)
    if kind == _SIMPLE:
        length = number(data, at + 8, order + "u4").astype(np.int64)
        size = np.minimum(length, room)
        most = np.array([known.snaplen or 2**32 for known in interfaces], np.int64)
        size = np.minimum(size, most[interface])
    else:
        high, low, size, length = numbers(data, at + 12, order + "u4", 4).T.astype(np.int64)
        ticks = high.astype(np.uint64) << np.uint64(32) | low.astype(np.uint64)
        # A file may have as many interfaces as packets, but not as many kinds of clocks.
        kinds = np.array([known.resolution for known in interfaces], np.int64)[interface]
        for resolution in np.unique(kinds).tolist():
            mine = kinds == resolution
            time[mine] = _nanoseconds(ticks[mine], resolution)
        offsets = np.array([known.offset for known in interfaces], np.int64)
        time += offsets[interface] * SECOND
    if len(broken := np.flatnonzero(size > room)):
        where = int(at[broken[0]])
        raise CaptureError(f"{name}: byte {where}: a packet is longer than its block")
    return {
        "at": at + (12 if kind == _SIMPLE else 28),
        "size": size,
        "length": length,
        "time": time,
        "interface": interface,
    }
