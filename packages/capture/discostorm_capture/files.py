"""Files of packets, plain or compressed, and streams: read whole, to the bytes of a capture."""

import lzma
import zlib
from collections.abc import Callable, Iterable, Iterator
from functools import partial
from itertools import chain
from os import PathLike
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np

from discostorm import _checks
from discostorm_capture._bytes import PAD
from discostorm_capture.pcap import PCAP, PCAPNG, CaptureError, Packets, packets_of

#: With what else a file may start: what is expanded here, and what is not.
GZIP, XZ = b"\x1f\x8b", b"\xfd7zXZ\0"
COMPRESSED = {
    "bzip2": b"BZh", "zstd": b"\x28\xb5\x2f\xfd", "lz4": b"\x04\x22\x4d\x18", "lzip": b"LZIP",
    "zip": b"PK\x03\x04", "7z": b"7z\xbc\xaf\x27\x1c", "compress": b"\x1f\x9d",
}  # fmt: skip
#: A file may expand to this much [B], and to so many times its own size more.
EXPANDED, TIMES = 1 << 26, 250
_CHUNK = 1 << 22


def read(path: str | PathLike[str] | BinaryIO) -> Packets:
    """Return the packets of a file, or of a stream, which is read to its end."""
    if not isinstance(path, (str, PathLike)) and hasattr(path, "read"):
        name = str(getattr(path, "name", "stream"))
        return _read("standard input" if name == "<stdin>" else name, path)
    name = _checks.path("path", path, "a capture")
    if Path(name).is_dir():
        raise CaptureError(f"{name}: it must be a file")
    with Path(name).open("rb") as file:
        return _read(name, file)


def _read(name: str, file: BinaryIO) -> Packets:
    start = file.read(_CHUNK)
    if not isinstance(start, bytes):
        raise TypeError(f"path must be a file opened in binary mode; got {file!r}")
    chunks = chain([start], iter(partial(file.read, _CHUNK), b""))
    parts: Iterable[bytes] = chunks
    if start.startswith((GZIP, XZ)):
        parts = _decompressed(name, chunks, start.startswith(GZIP))
    else:
        _require_capture(start, f"{name}: byte 0: ")
    # An array of bytes grows where it is, so that a large file is held once.
    content = bytearray()
    for part in parts:
        content += part
    size = len(content)
    content += bytes(PAD)
    return packets_of(name, np.frombuffer(content, np.uint8), size)


def _require_capture(start: bytes, where: str) -> None:
    """Raise an error unless these are the first bytes of a capture."""
    if start[:4] in PCAP or start[:4] == PCAPNG:
        return
    for program, magic in COMPRESSED.items():
        if start.startswith(magic):
            said = f"{where}compressed by {program}: expand it first "
            raise CaptureError(f"{said}(gz and xz are read as they are)")
    found = f"it starts with {start[:4].hex(' ')}" if start else "it is empty"
    said = f"{where}neither a pcap nor a pcapng file; {found}"
    raise CaptureError(f"{said}; record one with tcpdump -w FILE")


def _decompressed(name: str, chunks: Iterator[bytes], gzip: bool) -> Iterator[bytes]:
    """Yield the expanded bytes of a gzip or xz file, which must be a capture."""
    held = size = 0

    def fetch() -> bytes:
        nonlocal held
        held += len(chunk := next(chunks, b""))
        return chunk

    try:
        for part in filter(None, _decompress_parts(fetch, gzip)):
            if not size:
                _require_capture(part, f"{name}: byte 0 of what it expands to: ")
            size += len(part)
            if size > (most := EXPANDED + TIMES * held):
                raise CaptureError(
                    f"{name}: byte {held}: it expands to more than {most} bytes; expand it first "
                    "if it is to be trusted"
                )
            yield part
    except (zlib.error, lzma.LZMAError, EOFError) as error:
        raise CaptureError(f"{name}: byte {held}: compressed data: {error}") from error
    if not size:
        _require_capture(b"", f"{name}: byte 0 of what it expands to: ")


def _decompress_parts(fetch: Callable[[], bytes], gzip: bool) -> Iterator[bytes]:
    """Yield the expanded bytes of one or several compressed files in a row."""
    rest = fetch()
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
                rest = fetch()
                if not rest:
                    raise EOFError("it ends too early; copy the file again")
        # Both formats allow zeros to follow.
        rest = expand.unused_data.lstrip(b"\0") or fetch().lstrip(b"\0")
