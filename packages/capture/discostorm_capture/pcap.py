"""The packets of pcap and pcapng files and streams, plain or compressed."""

import lzma
import struct
import zlib
from array import array
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from functools import partial
from itertools import chain
from os import PathLike
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np

from discostorm import _checks
from discostorm_capture._types import PADDING, Bytes, Columns
from discostorm_capture.sentences import say

#: By the first four bytes of a pcap file: byte order, clock tick [ns] and size of packet headers
#: [B]. Headers of 24 bytes come from a patched libpcap.
PCAP_MAGICS = {
    struct.pack(order + "I", magic): (order, tick, header)
    for order in "<>"
    for magic, tick, header in ((0xA1B2C3D4, 1000, 16), (0xA1B23C4D, 1, 16), (0xA1B2CD34, 1000, 24))
}
PCAPNG_MAGIC = b"\x0a\x0d\x0d\x0a"
#: The byte order of a pcapng section, by its byte-order magic.
_BYTE_ORDERS = {b"\x1a\x2b\x3c\x4d": ">", b"\x4d\x3c\x2b\x1a": "<"}
#: Types of pcapng blocks.
_ENHANCED_PACKET, _SIMPLE_PACKET, _OBSOLETE_PACKET = 6, 3, 2
_INTERFACE_BLOCK, _SECTION_BLOCK = 1, 0x0A0D0D0A
#: Bytes of a packet block besides the packet, and of the shortest block.
_BLOCK_OVERHEAD = {_ENHANCED_PACKET: 32, _SIMPLE_PACKET: 16, _OBSOLETE_PACKET: 32}
_MIN_BLOCK_BYTES = 12
#: Options of an interface block: end of options, clock resolution, seconds to add to times.
_OPT_END, _OPT_TSRESOL, _OPT_TSOFFSET = 0, 9, 14
#: The longest packet that libpcap writes for networks [B].
MAX_PACKET_BYTES = 262_144
NS_PER_SECOND = 1_000_000_000
#: First bytes of compressed files: formats that are decompressed here, then those that are not.
GZIP_MAGIC, XZ_MAGIC = b"\x1f\x8b", b"\xfd7zXZ\0"
UNSUPPORTED_COMPRESSION = {
    "bzip2": b"BZh", "zstd": b"\x28\xb5\x2f\xfd", "lz4": b"\x04\x22\x4d\x18", "lzip": b"LZIP",
    "zip": b"PK\x03\x04", "7z": b"7z\xbc\xaf\x27\x1c", "compress": b"\x1f\x9d",
}  # fmt: skip
#: A compressed file may expand to this many bytes, plus a multiple of its own size.
BASE_EXPANSION_LIMIT, MAX_EXPANSION_RATIO = 1 << 26, 250
_CHUNK_BYTES = 1 << 22
_PACKET_COLUMNS = ("at", "size", "length", "time", "interface")


class CaptureError(ValueError):
    """A file cannot be read as a capture; the message says which, where and why."""


@dataclass(frozen=True)
class Packets:
    """All packets of a file."""

    name: str
    #: The decompressed bytes of the file, and padding.
    data: Bytes
    #: One row per packet: ``at``, the offset of its first byte; ``size``, its bytes in the file;
    #: ``length``, its bytes on the wire; ``time`` [ns]; ``interface``, an index.
    table: Columns
    #: The link type of each interface.
    link_types: tuple[int, ...]


def parse_packets(name: str, data: Bytes, size: int) -> Packets:
    """Return the packets in the first `size` bytes of padded data."""
    magic = data[:4].tobytes()
    rows = array("q")
    if magic in PCAP_MAGICS:
        links = _parse_pcap(name, data, size, rows, *PCAP_MAGICS[magic])
    else:
        links = _parse_pcapng(name, data, size, rows)
    columns = np.array(rows, np.int64).reshape(-1, len(_PACKET_COLUMNS)).T.copy()
    table: Columns = dict(zip(_PACKET_COLUMNS, columns, strict=True))
    if len(too_long := np.flatnonzero(table["size"] > MAX_PACKET_BYTES)):
        at, held = (table[column][too_long[0]] for column in ("at", "size"))
        raise CaptureError(say("long packet", name, at, too_long[0] + 1, held, MAX_PACKET_BYTES))
    return Packets(name, data, table, links)


def _parse_pcap(
    name: str, data: Bytes, size: int, rows: "array[int]", order: str, tick: int, header: int
) -> tuple[int, ...]:
    """Append the packets of a pcap file to `rows`; return its link type."""
    if size < 24:
        raise CaptureError(f"{name}: byte {size}: it ends inside its header")
    source, read = data.data, struct.Struct(order + "4I").unpack_from
    at = 24
    while at + header <= size:
        seconds, fraction, held, sent = read(source, at)
        after = at + header + held
        if after > size:
            break
        rows.extend((at + header, held, sent, seconds * NS_PER_SECOND + fraction * tick, 0))
        at = after
    if at != size:
        complete = len(rows) // len(_PACKET_COLUMNS)
        raise CaptureError(say("cut packet", name, at, complete + 1, complete))
    # Drop the upper bits of the field: they describe check sequences.
    (link,) = struct.unpack_from(order + "I", source, 20)
    return (link & 0xFFFF,)


@dataclass(frozen=True)
class _Interface:
    """Link type, maximum packet size and clock of an interface of a pcapng file."""

    link: int
    snaplen: int
    resolution: int = 6
    offset: int = 0


def _parse_pcapng(name: str, data: Bytes, size: int, rows: "array[int]") -> tuple[int, ...]:
    """Append the packets of a pcapng file to `rows`; return the link types of its interfaces."""
    order = _section_byte_order(name, data, 0)
    source, read = data.data, struct.Struct(order + "II").unpack_from
    interfaces: list[_Interface] = []
    section_start = at = 0  # section_start: the index of the section's first interface
    while at + _MIN_BLOCK_BYTES <= size:
        kind, length = read(source, at)
        if kind == _SECTION_BLOCK and _section_byte_order(name, data, at) != order:
            raise CaptureError(say("two byte orders", name, at))
        if length < _MIN_BLOCK_BYTES or length % 4 or at + length > size:
            break
        if kind == _SECTION_BLOCK:
            section_start = len(interfaces)
        elif kind == _INTERFACE_BLOCK:
            interfaces.append(_parse_interface(name, source, at, length, order))
        elif kind in _BLOCK_OVERHEAD:
            if length < _BLOCK_OVERHEAD[kind]:
                raise CaptureError(f"{name}: byte {at}: packet block: only {length} bytes")
            try:
                packet = _parse_packet(source, at, kind, order, interfaces, section_start)
            except IndexError:
                text = f"{name}: byte {at}: a packet of an undefined interface"
                raise CaptureError(text) from None
            if packet[1] > length - _BLOCK_OVERHEAD[kind]:
                raise CaptureError(f"{name}: byte {at}: a packet is longer than its block")
            rows.extend(packet)
        at += length
    if at < size:
        raise CaptureError(say("cut block", name, at, read(source, at)[1]))
    return tuple(interface.link for interface in interfaces)


def _section_byte_order(name: str, data: Bytes, at: int) -> str:
    """Return the byte order of the section that starts at an offset."""
    order = _BYTE_ORDERS.get(data[at + 8 : at + 12].tobytes())
    if order is None:
        raise CaptureError(f"{name}: byte {at}: a section without a byte order")
    return order


def _parse_interface(name: str, source: memoryview, at: int, length: int, order: str) -> _Interface:
    """Return the interface that a block describes."""
    if length < 20:
        raise CaptureError(f"{name}: byte {at}: interface block: only {length} bytes")
    interface = _Interface(*struct.unpack_from(order + "H2xI", source, at + 8))
    option, end = at + 16, at + length - 4
    while option + 4 <= end:
        code, size = struct.unpack_from(order + "HH", source, option)
        value = option + 4
        if code == _OPT_END or value + size > end:
            break
        if code == _OPT_TSRESOL and size == 1:
            interface = replace(interface, resolution=source[value])
        elif code == _OPT_TSOFFSET and size == 8:
            (offset,) = struct.unpack_from(order + "q", source, value)
            interface = replace(interface, offset=max(-(2**32), min(offset, 2**32)))
        option = value + (size + 3 & ~3)
    return interface


def _parse_packet(
    source: memoryview, at: int, kind: int, order: str, interfaces: list[_Interface], first: int
) -> tuple[int, int, int, int, int]:
    """Return a packet's `_PACKET_COLUMNS`; raise IndexError if its interface is not described."""
    if kind == _SIMPLE_PACKET:
        length, sent = struct.unpack_from(order + "II", source, at + 4)
        held = min(sent, length - _BLOCK_OVERHEAD[kind], interfaces[first].snaplen or 2**32)
        return at + 12, held, sent, 0, first
    fields = "5I" if kind == _ENHANCED_PACKET else "H2x4I"
    index, high, low, held, sent = struct.unpack_from(order + fields, source, at + 8)
    clock = interfaces[first + index]
    ticks_per_second = (2 if clock.resolution & 0x80 else 10) ** (clock.resolution & 0x7F)
    time = min((high << 32 | low) * NS_PER_SECOND // ticks_per_second, 2**62)
    time += clock.offset * NS_PER_SECOND
    return at + 28, held, sent, time, first + index


def read_packets(path: str | PathLike[str] | BinaryIO) -> Packets:
    """Return the packets of a file or stream, read to its end."""
    if not isinstance(path, (str, PathLike)) and hasattr(path, "read"):
        name = str(getattr(path, "name", "stream"))
        return _read_stream("standard input" if name == "<stdin>" else name, path)
    name = _checks.path("path", path, "a capture")
    if Path(name).is_dir():
        raise CaptureError(f"{name}: it must be a file")
    with Path(name).open("rb") as file:
        return _read_stream(name, file)


def _read_stream(name: str, file: BinaryIO) -> Packets:
    start = file.read(_CHUNK_BYTES)
    if not isinstance(start, bytes):
        raise TypeError(f"path must be a file opened in binary mode; got {file!r}")
    chunks = chain([start], iter(partial(file.read, _CHUNK_BYTES), b""))
    parts: Iterable[bytes] = chunks
    if start.startswith((GZIP_MAGIC, XZ_MAGIC)):
        parts = _decompress_capture(name, chunks, start.startswith(GZIP_MAGIC))
    else:
        _require_capture(start, f"{name}: byte 0: ")
    # A bytearray grows in place, so that memory holds a large file only once.
    content = bytearray()
    for part in parts:
        content += part
    size = len(content)
    content += bytes(PADDING)
    return parse_packets(name, np.frombuffer(content, np.uint8), size)


def _require_capture(start: bytes, where: str) -> None:
    """Raise an error unless these are the first bytes of a capture."""
    if start[:4] in PCAP_MAGICS or start[:4] == PCAPNG_MAGIC:
        return
    for program, magic in UNSUPPORTED_COMPRESSION.items():
        if start.startswith(magic):
            raise CaptureError(say("other compression", where, program))
    found = f"it starts with {start[:4].hex(' ')}" if start else "it is empty"
    raise CaptureError(say("no capture", where, found))


def _decompress_capture(name: str, chunks: Iterator[bytes], gzip: bool) -> Iterator[bytes]:
    """Yield the decompressed bytes of a gzip or xz file, which must be a capture."""
    held = size = 0

    def fetch() -> bytes:
        nonlocal held
        held += len(chunk := next(chunks, b""))
        return chunk

    try:
        for part in filter(None, _decompress_chunks(fetch, gzip)):
            if not size:
                _require_capture(part, f"{name}: byte 0 of what it expands to: ")
            size += len(part)
            if size > (most := BASE_EXPANSION_LIMIT + MAX_EXPANSION_RATIO * held):
                raise CaptureError(say("too large", name, held, most))
            yield part
    except (zlib.error, lzma.LZMAError, EOFError) as error:
        raise CaptureError(f"{name}: byte {held}: compressed data: {error}") from error
    if not size:
        _require_capture(b"", f"{name}: byte 0 of what it expands to: ")


def _decompress_chunks(fetch: Callable[[], bytes], gzip: bool) -> Iterator[bytes]:
    """Yield the decompressed bytes of one or more concatenated gzip or xz files."""
    rest = fetch()
    while rest:
        expand: Any  # the two decompressors share the methods used here, but no type
        if gzip:
            expand = zlib.decompressobj(wbits=31)
        else:
            expand = lzma.LZMADecompressor(lzma.FORMAT_XZ, memlimit=1 << 28)
        while True:
            yield expand.decompress(rest, _CHUNK_BYTES)
            if expand.eof:
                break
            rest = expand.unconsumed_tail if gzip else b""
            if not rest and (gzip or expand.needs_input):
                rest = fetch()
                if not rest:
                    raise EOFError("ends too early; copy the file again")
        # Both formats allow zeros between and after files.
        rest = expand.unused_data.lstrip(b"\0") or fetch().lstrip(b"\0")
