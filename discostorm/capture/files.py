"""Files of packets: pcap and pcapng, plain or compressed, to the place of every packet."""

import lzma
import mmap
import signal
import struct
import zlib
from collections.abc import Iterator
from dataclasses import dataclass, replace
from io import BytesIO
from itertools import pairwise
from os import PathLike, fstat
from pathlib import Path
from stat import S_ISREG
from typing import Any, BinaryIO

import numpy as np

from discostorm import _checks
from discostorm.capture._bytes import (
    PAD,
    Array,
    Bytes,
    Columns,
    Places,
    buffer,
    number,
    numbers,
    stack,
    take,
    view,
)
from discostorm.capture._chain import Layout, follow, one_by_one

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
#: With what else a file may start: what is expanded here, and what is not.
GZIP, XZ = b"\x1f\x8b", b"\xfd7zXZ\0"
COMPRESSED = {
    "bzip2": b"BZh",
    "zstd": b"\x28\xb5\x2f\xfd",
    "lz4": b"\x04\x22\x4d\x18",
    "zip": b"PK\x03\x04",
    "7z": b"7z\xbc\xaf\x27\x1c",
    "lzip": b"LZIP",
    "compress": b"\x1f\x9d",
}
#: Longest packet that libpcap writes [B]; USB and the like have longer ones.
MOST = 262_144
#: A file may expand to this much [B], and to so many times its own size more.
EXPANDED, TIMES = 1 << 26, 250
_CHUNK = 1 << 22
#: From this size on a file is mapped into memory where that is safe; smaller ones are copied [B].
_LARGE = 1 << 24


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


def read(path: str | PathLike[str] | BinaryIO) -> Packets:
    """Return the packets of a file, or of a stream, which is read to its end.

    Raises
    ------
    OSError
        If the file cannot be opened.
    CaptureError
        If it is no capture, is broken or ends inside of a packet.
    """
    if not isinstance(path, (str, PathLike)) and hasattr(path, "read"):
        name = str(getattr(path, "name", "stream"))
        return _packets_of("standard input" if name == "<stdin>" else name, path, None)
    name = _checks.path("path", path, "a capture")
    if Path(name).is_dir():
        raise CaptureError(f"{name}: it must be a file")
    with Path(name).open("rb") as file:
        found = fstat(file.fileno())
        # What is no file, such as a pipe, is a stream.
        return _packets_of(name, file, found.st_size if S_ISREG(found.st_mode) else None)


def _packets_of(name: str, file: BinaryIO, size: int | None) -> Packets:
    """Return the packets of a file of a size, or of a stream that tells none."""
    start = file.read(6)
    if not isinstance(start, bytes):
        raise TypeError(f"path must be a file opened in binary mode; got {file!r}")
    gzip = start[:2] == GZIP
    if gzip or start == XZ:
        if size is None:
            start += file.read()
            file, size = BytesIO(start), len(start)
        file.seek(0)
        data, size = _expanded(name, file, gzip, size)
    else:
        _known(start, f"{name}: byte 0: ")
        data, size = _whole(name, file, start, size)
    magic = data[:4].tobytes()
    if magic in PCAP:
        return _pcap(name, data, size, *PCAP[magic])
    return _pcapng(name, data, size)


def _known(start: bytes, where: str) -> None:
    """Raise an error unless these are the first bytes of a capture."""
    if start[:4] in PCAP or start[:4] == PCAPNG:
        return
    for program, magic in COMPRESSED.items():
        if start.startswith(magic):
            raise CaptureError(
                f"{where}compressed by {program}: expand it first (gz and xz are read as they are)"
            )
    found = f"it starts with {start[:4].hex(' ')}" if start else "it is empty"
    raise CaptureError(f"{where}neither a pcap nor a pcapng file; {found}")


def _whole(name: str, file: BinaryIO, start: bytes, size: int | None) -> tuple[Bytes, int]:
    """Return all bytes of a file that starts with these, and how many there are."""
    if size is None:
        return _joined([start, *iter(lambda: file.read(_CHUNK), b"")])
    if (mapped := _mapped(file, size)) is not None:
        return mapped, size
    data = buffer(size)
    data[: len(start)] = np.frombuffer(start, np.uint8)
    got = len(start) + file.readinto(data[len(start) : size].data)  # type: ignore[attr-defined]
    if got != size:
        raise CaptureError(f"{name}: byte {got}: it ends while it is read")
    return data, size


def _mapped(file: BinaryIO, size: int) -> Bytes | None:
    """Return the bytes of a large file as they lie in memory already, None if it is not safe.

    Whoever would make it shorter has to wait until it is read, for at most 45 s.
    """
    # What is read of the padding must be of the file's last page, where zeros follow.
    if size < _LARGE or -size % mmap.PAGESIZE < PAD:
        return None
    try:
        import fcntl

        # What tells that somebody waits is to be a signal that does nothing.
        fcntl.fcntl(file, fcntl.F_SETSIG, signal.SIGURG)
        fcntl.fcntl(file, fcntl.F_SETLEASE, fcntl.F_RDLCK)
        data = np.frombuffer(mmap.mmap(file.fileno(), size, access=mmap.ACCESS_READ), np.uint8)
    except (ImportError, AttributeError, OSError, ValueError):
        # Not on Linux, somebody else's, or being written.
        return None
    return np.lib.stride_tricks.as_strided(data, (size + PAD,), writeable=False)


def _joined(parts: list[bytes]) -> tuple[Bytes, int]:
    """Return the bytes of all parts, which are taken away, and how many there are."""
    size = sum(map(len, parts))
    data, at = buffer(size), 0
    for index, part in enumerate(parts):
        data[at : at + len(part)] = np.frombuffer(part, np.uint8)
        at += len(part)
        parts[index] = b""  # so that it is not held twice
    return data, size


def _expanded(name: str, file: BinaryIO, gzip: bool, held: int) -> tuple[Bytes, int]:
    """Return what a gzip or xz file of a size expands to, and the size of that."""
    most = EXPANDED + TIMES * held
    parts: list[bytes] = []
    size = 0
    try:
        for part in filter(None, _parts(file, gzip)):
            if not size:
                _known(part, f"{name}: byte 0 of what it expands to: ")
            parts.append(part)
            size += len(part)
            if size > most:
                raise CaptureError(
                    f"{name}: byte {file.tell()}: it expands to more than {most} bytes; expand it "
                    "first if it is to be trusted"
                )
    except (zlib.error, lzma.LZMAError, EOFError) as error:
        raise CaptureError(f"{name}: byte {file.tell()}: compressed data: {error}") from error
    if not size:
        _known(b"", f"{name}: byte 0 of what it expands to: ")
    return _joined(parts)


def _parts(file: BinaryIO, gzip: bool) -> Iterator[bytes]:
    """Yield what a file expands to piece by piece; it may be several compressed ones in a row."""
    rest = file.read(_CHUNK)
    while rest:
        expand: Any  # both have what is needed here, by other types
        if gzip:
            expand = zlib.decompressobj(wbits=31)
        else:
            expand = lzma.LZMADecompressor(lzma.FORMAT_XZ, memlimit=1 << 28)
        while True:
            yield expand.decompress(rest, _CHUNK)
            if expand.eof:
                break
            rest = expand.unconsumed_tail if gzip else b""
            if not rest and (gzip or expand.needs_input):
                rest = file.read(_CHUNK)
                if not rest:
                    raise EOFError("it ends too early")
        # Both formats allow zeros to follow.
        rest = expand.unused_data.lstrip(b"\0") or file.read(_CHUNK).lstrip(b"\0")


def _pcap(name: str, data: Bytes, size: int, order: str, tick: int, header: int) -> Packets:
    if size < 24:
        raise CaptureError(f"{name}: byte {size}: it ends inside of its header")
    (link,) = struct.unpack_from(order + "I", view(data), 20)

    def alike(places: Places) -> Array:
        _, fraction, held, sent = numbers(data, places, order + "u4", 4).T
        good: Array = (fraction < 1_000_000_000 // tick) & (held > 0)
        good &= (held <= sent) & (sent <= MOST)
        return good

    place, at = follow(data, size, 24, Layout(order, header, 8, header), alike)
    # Behind its last packet a file has nothing.
    if at != size:
        whole = len(place) - (len(place) > 0 and at > size)
        where = place[whole] if whole < len(place) else at
        raise CaptureError(
            f"{name}: byte {where}: packet {whole + 1} is cut or broken; the first "
            f"{where} bytes of the file hold {whole} whole packets"
        )
    head = numbers(data, place, order + "u4", 4)
    seconds, fraction, held, sent = head.T.astype(np.int64, order="C")
    table: Columns = {
        "at": place + header,
        "size": held,
        "length": sent,
        "time": seconds * 1_000_000_000 + fraction * tick,
        "interface": np.zeros(len(place), np.int64),
    }
    _plausible(name, table)
    # The upper bits tell of check sequences.
    return Packets(name, data, table, (link & 0xFFFF,))


def _plausible(name: str, table: Columns) -> None:
    if len(too_long := np.flatnonzero(table["size"] > MOST)):
        where = int(too_long[0])
        raise CaptureError(
            f"{name}: byte {int(table['at'][where])}: packet {where + 1} is broken: it has "
            f"{int(table['size'][where])} bytes; there are at most {MOST}"
        )


#: Block types: packets with all, without time, of an old kind; interfaces; sections.
_ENHANCED, _SIMPLE, _OLD, _INTERFACE, _SECTION = 6, 3, 2, 1, 0x0A0D0D0A
#: Of each kind of block the bytes around its packet.
_AROUND = {_ENHANCED: 32, _SIMPLE: 16, _OLD: 32}
#: Options of an interface: the end, ticks of its clock, seconds to add.
_END, _RESOLUTION, _OFFSET = 0, 9, 14


@dataclass(frozen=True)
class _Interface:
    link: int
    snaplen: int
    resolution: int = 6
    offset: int = 0

    def nanoseconds(self, ticks: Array) -> Array:
        """Return the time of its clock's ticks [ns]."""
        power = self.resolution & 0x7F
        if self.resolution & 0x80:
            since = (ticks / 2.0**power * 1e9).clip(0, 2**62).astype(np.int64)
        elif power <= 9:
            since = (ticks * np.uint64(10 ** (9 - power))).astype(np.int64)
        else:
            since = (ticks // np.uint64(10 ** min(power - 9, 19))).astype(np.int64)
        return since + np.int64(self.offset) * np.int64(1_000_000_000)


def _pcapng(name: str, data: Bytes, size: int) -> Packets:
    interfaces: list[_Interface] = []
    tables: list[Columns] = []
    at = 0
    while at < size:
        order = {b"\x1a\x2b\x3c\x4d": ">", b"\x4d\x3c\x2b\x1a": "<"}.get(
            data[at + 8 : at + 12].tobytes(), ""
        )
        if not order:
            raise CaptureError(f"{name}: byte {at}: a section without a byte order")
        at = _sections(name, data, size, at, order, interfaces, tables)
    if not tables:
        empty = np.zeros(0, np.int64)
        tables = [dict.fromkeys(("at", "size", "length", "time", "interface"), empty)]
    table = stack(tables)
    if len(tables) > 1:
        table = take(table, np.argsort(table["at"], kind="stable"))
    _plausible(name, table)
    return Packets(name, data, table, tuple(interface.link for interface in interfaces))


def _sections(
    name: str,
    data: Bytes,
    size: int,
    at: int,
    order: str,
    interfaces: list[_Interface],
    tables: list[Columns],
) -> int:
    """Read the sections of one byte order from a place on; return where those of another start.

    Their interfaces, and tables of their packets, are added to what is there.
    """
    layout = Layout(order, 12, 4, 0)

    def alike(places: Places) -> Array:
        length = layout.lengths(data, places)
        good: Array = (number(data, places, order + "u4") == _ENHANCED) & (places + length <= size)
        # The length stands at the end, too.
        back = np.where(good & (length >= _AROUND[_ENHANCED]), places + length - 4, places)
        good &= number(data, back, order + "u4") == length
        return good

    # Files that change the order again and again are not worth the search.
    place, end = (one_by_one if at else follow)(data, size, at, layout, alike)
    kind, length = number(data, place, order + "u4"), layout.lengths(data, place)
    begins = np.flatnonzero(kind == _SECTION)
    magic = number(data, place[begins] + 8, "=u4")
    others = begins[magic != magic[:1]]
    broken = np.flatnonzero((length & 3 > 0) | (place + length > size))
    last = min([len(place), *others[:1].tolist(), *broken[:1].tolist()])
    for begin, stop in pairwise([*begins[begins < last].tolist(), last]):
        mine = slice(begin, stop)
        tables += _section(name, data, place[mine], kind[mine], length[mine], order, interfaces)
    if last in others:
        return int(place[last])
    if last < len(place):
        end = int(place[last])
    if end < size:
        (found,) = number(data, np.array([end + 4]), order + "u4")
        raise CaptureError(
            f"{name}: byte {end}: a block of {found} bytes is cut or broken; the first {end} "
            "bytes of the file hold whole ones"
        )
    return size


def _section(
    name: str,
    data: Bytes,
    place: Places,
    kind: Array,
    length: Places,
    order: str,
    interfaces: list[_Interface],
) -> list[Columns]:
    """Return the packets of a section, whose blocks are given; add its interfaces."""
    first = len(interfaces)
    source = view(data)
    described = np.flatnonzero(kind == _INTERFACE)
    interfaces += [
        _interface(name, source, at, size, order)
        for at, size in zip(place[described].tolist(), length[described].tolist(), strict=True)
    ]
    tables = []
    for which, around in _AROUND.items():
        mine = kind == which
        if len(short := np.flatnonzero(mine & (length < around))):
            where, found = place[short[0]], length[short[0]]
            raise CaptureError(f"{name}: byte {where}: a packet's block has {found} bytes")
        if mine.any():
            tables.append(
                _packets(name, data, which, place[mine], order, interfaces[first:], first)
            )
    return tables


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
    here: list[_Interface],
    first: int,
) -> Columns:
    """Return the packets in blocks of a kind; ``first`` interfaces are of earlier sections."""
    room = number(data, at + 4, order + "u4").astype(np.int64) - _AROUND[kind]
    if kind == _SIMPLE:
        interface = np.zeros(len(at), np.int64)
    else:
        interface = number(data, at + 8, order + ("u4" if kind == _ENHANCED else "u2"))
        interface = interface.astype(np.int64)
    if interface.max() >= len(here):
        where = int(at[interface >= len(here)][0])
        raise CaptureError(f"{name}: byte {where}: a packet of an interface that is not there")
    if kind == _SIMPLE:
        length = number(data, at + 8, order + "u4").astype(np.int64)
        size = np.minimum(length, room)
        if here[0].snaplen:
            size = np.minimum(size, here[0].snaplen)
        time = np.zeros(len(at), np.int64)
    else:
        high, low = (number(data, at + place, order + "u4").astype(np.uint64) for place in (12, 16))
        size, length = (
            number(data, at + place, order + "u4").astype(np.int64) for place in (20, 24)
        )
        ticks = (high << np.uint64(32)) | low
        time = np.zeros(len(at), np.int64)
        for index in np.unique(interface):
            mine = interface == index
            time[mine] = here[index].nanoseconds(ticks[mine])
    if len(broken := np.flatnonzero(size > room)):
        where = int(at[broken[0]])
        raise CaptureError(f"{name}: byte {where}: a packet is longer than its block")
    return {
        "at": at + (12 if kind == _SIMPLE else 28),
        "size": size,
        "length": length,
        "time": time,
        "interface": interface + first,
    }
