"""Numbers at many places of a long array of bytes at once."""

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

Bytes = NDArray[np.uint8]
Places = NDArray[np.int64]
Array = NDArray[Any]
#: A table: columns of the same length by name.
Columns = dict[str, Array]

#: Zeros behind the last byte of a `Buffer`: as much may be read there without a look at the end.
PAD = 64


def buffer(size: int) -> Bytes:
    """Return an array of zeros for that many bytes, and the padding behind them."""
    return np.zeros(size + PAD, np.uint8)


def view(data: Bytes) -> memoryview:
    """Return the bytes for what takes them one by one."""
    return memoryview(data)  # type: ignore[arg-type]


def number(data: Bytes, at: Places, dtype: str) -> Array:
    """Return the numbers of that dtype, such as ``">u2"``, which start at the given places."""
    width = np.dtype(dtype).itemsize
    # Element i of this view starts at byte i; nothing is copied but what is asked for.
    numbers: Array = np.ndarray((len(data) - width + 1,), dtype, data, 0, (1,))
    found: Array = numbers[at]
    return found


def numbers(data: Bytes, at: Places, dtype: str, count: int) -> Array:
    """Return so many numbers in a row from each place on, a row of them a place."""
    width = count * np.dtype(dtype).itemsize
    # To fetch them together takes as long as to fetch one.
    rows: Array = np.ndarray((len(data) - width + 1,), f"V{width}", data, 0, (1,))[at]
    return rows.view(dtype).reshape(-1, count)


def take(table: Columns, chosen: Any) -> Columns:
    """Return the chosen rows of a table."""
    return {name: column[chosen] for name, column in table.items()}


def stack(tables: list[Columns]) -> Columns:
    """Return the rows of all tables, one after the other; there is at least one table."""
    if len(tables) == 1:
        return tables[0]
    return {name: np.concatenate([table[name] for table in tables]) for name in tables[0]}


def codes(*keys: Array) -> tuple[NDArray[np.int64], Array]:
    """Return a number for each different combination of keys, and where each is found first."""
    import pandas as pd

    # Pandas wants the machine's own byte order.
    native = [np.ascontiguousarray(key, key.dtype.newbyteorder("=")) for key in keys]
    code = pd.factorize(native[0])[0].astype(np.int64)
    for key in native[1:]:
        other, values = pd.factorize(key)
        code = pd.factorize(code * (len(values) + 1) + other)[0].astype(np.int64)
    first = np.full(int(code.max()) + 1 if len(code) else 0, -1, np.int64)
    # The last that is written stays, so from the end.
    first[code[::-1]] = np.arange(len(code) - 1, -1, -1)
    return code, first


def times_before(code: Array) -> Array:
    """Return how many times each number stands before its place."""
    order = np.argsort(code, kind="stable")
    begins = np.flatnonzero(np.diff(code[order], prepend=-1))
    before = np.empty(len(code), np.int64)
    before[order] = np.arange(len(code)) - np.repeat(begins, np.diff(begins, append=len(code)))
    return before


@dataclass(frozen=True)
class Numbers:
    """A number for each of several byte strings, such as addresses, from 0 on."""

    known: dict[bytes, int] = field(default_factory=dict)

    def of(self, data: Bytes, at: Places, octets: int) -> NDArray[np.int32]:
        """Return the numbers of the strings of so many bytes, a multiple of 4, at the places."""
        keys = [number(data, at + place, "=u8") for place in range(0, octets - 7, 8)]
        if octets % 8:
            keys.append(number(data, at + octets - 4, "=u4"))
        code, first = codes(*keys)
        found = [
            self.known.setdefault(data[place : place + octets].tobytes(), len(self.known))
            for place in at[first].tolist()
        ]
        return np.array(found, np.int32)[code]
