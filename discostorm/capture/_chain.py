"""Records of which each tells where the next one starts, followed from many places at once."""

import struct
from array import array
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from discostorm.capture._bytes import Array, Bytes, Places, number, view

#: From so many places of a file records are followed, each looked for in so many bytes.
_PLACES, _WINDOW = 256, 2048
#: So many in a row must look like records for the first of them to be tried.
_IN_A_ROW = 3
#: Smaller files [B] are followed record by record: that takes milliseconds.
_SMALL = 1 << 20


@dataclass(frozen=True)
class Layout:
    """How a record tells where the next one starts.

    Parameters
    ----------
    order : str
        Byte order, ``<`` or ``>``.
    least : int
        The bytes that each record has at least [B].
    at : int
        Where in it its length stands, a number of four bytes [B].
    beside : int
        What the length leaves out [B].
    """

    order: str
    least: int
    at: int
    beside: int

    def lengths(self, data: Bytes, places: Places) -> Places:
        """Return the lengths of the records at the places [B]."""
        found: Places = number(data, places + self.at, self.order + "u4").astype(np.int64)
        return found + self.beside


def follow(
    data: Bytes, size: int, first: int, layout: Layout, alike: Callable[[Places], Array]
) -> tuple[Places, int]:
    """Return where the records of a file start, and where they end.

    They end where there is no room for another one, or at one that is shorter than it can be.

    Parameters
    ----------
    data : numpy.ndarray
        The bytes of the file, and padding.
    size : int
        How many bytes there are.
    first : int
        Where the first record starts.
    layout : Layout
        How a record tells where the next one starts.
    alike : callable
        Says whether a record may start at the places given. An error costs time and nothing
        else: what is found from a place counts if the records before it lead there.
    """
    found: list[Places] = []
    at = first
    if size - first > _SMALL:
        begins = _likely(data, size, first, layout, alike)
        for begin, records, end in _from_all(data, size, begins, layout):
            if at < begin:
                part, at = _up_to(begin, data, size, at, layout)
                found.append(part)
            if at == begin:
                found.append(records)
                at = end
    part, at = _up_to(size, data, size, at, layout)
    return np.concatenate([*found, part]), at


def _likely(
    data: Bytes, size: int, first: int, layout: Layout, alike: Callable[[Places], Array]
) -> Places:
    """Return places spread over the file where a record is likely to start."""
    span = (size - first) // _PLACES
    windows = first + span * np.arange(_PLACES)[:, None] + np.arange(min(_WINDOW, span))
    places = windows.ravel()
    starts = places
    for _ in range(_IN_A_ROW):
        inside = places + layout.least <= size
        places, starts = places[inside], starts[inside]
        good = alike(places)
        places, starts = places[good], starts[good]
        places = places + layout.lengths(data, places)
    # The first one in each window.
    _, chosen = np.unique((starts - first) // span, return_index=True)
    return starts[chosen]


def _from_all(
    data: Bytes, size: int, begins: Places, layout: Layout
) -> Iterator[tuple[int, Places, int]]:
    """Yield for each of the places the records from there up to the next one, and their end."""
    which = np.arange(len(begins), dtype=np.int16)
    at = begins
    stop = np.minimum(np.append(begins[1:], size)[: len(begins)], size - layout.least + 1)
    ends = begins.copy()
    steps = [(which[:0], at[:0])]
    while len(at):
        length = layout.lengths(data, at)
        after = at + length
        good = length >= layout.least
        if not good.all():
            which, at, after = which[good], at[good], after[good]
        steps.append((which, at))
        ends[which] = after
        more = after < stop[which]
        if more.all():
            at = after
        else:
            which, at = which[more], after[more]
    which, at = (np.concatenate(parts) for parts in zip(*steps, strict=True))
    order = np.argsort(which, kind="stable")
    at, edges = at[order], np.searchsorted(which[order], np.arange(len(begins) + 1))
    for index, (begin, end) in enumerate(zip(begins.tolist(), ends.tolist(), strict=True)):
        yield begin, at[edges[index] : edges[index + 1]], end


def one_by_one(
    data: Bytes, size: int, first: int, layout: Layout, _: Callable[[Places], Array]
) -> tuple[Places, int]:
    """Return the same as `follow`, without a search for places to begin at."""
    return _up_to(size, data, size, first, layout)


def _up_to(stop: int, data: Bytes, size: int, at: int, layout: Layout) -> tuple[Places, int]:
    """Return the records that start before ``stop``, and where they end."""
    read = struct.Struct(layout.order + "I").unpack_from
    source, places = view(data), array("q")
    stop = min(stop, size - layout.least + 1)
    where, beside, least = layout.at, layout.beside, layout.least
    while at < stop:
        length = read(source, at + where)[0] + beside
        if length < least:
            break
        places.append(at)
        at += length
    return np.array(places, np.int64), at
