"""Numbers at many offsets of bytes at once, rows of tables, and ids of distinct values."""

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from discostorm_capture._types import PADDING, Array, Bytes, Columns, Offsets


def join_padded(*parts: Any) -> Bytes:
    """Join the bytes of all parts, and add padding."""
    return np.frombuffer(b"".join([*parts, bytes(PADDING)]), np.uint8)


def numbers_at(data: Bytes, at: Offsets, dtype: str) -> Array:
    """Return the number of a dtype such as ``">u2"`` that starts at each offset."""
    width = np.dtype(dtype).itemsize
    # Element i of this array starts at byte i; only the requested elements are copied.
    overlapping: Array = np.ndarray((len(data) - width + 1,), dtype, data, 0, (1,))
    return overlapping[at]


def number_rows_at(data: Bytes, at: Offsets, dtype: str, count: int) -> Array:
    """Return `count` consecutive numbers from each offset on, as one row per offset."""
    width = count * np.dtype(dtype).itemsize
    return numbers_at(data, at, f"V{width}").view(dtype).reshape(-1, count)


def take_rows(table: Columns, rows: Any) -> Columns:
    """Return rows of a table."""
    return {name: column[rows] for name, column in table.items()}


def concat(*tables: Columns) -> Columns:
    """Return the rows of all tables, at least one, in the columns of the first."""
    return {name: np.concatenate([table[name] for table in tables]) for name in tables[0]}


def factorize(*keys: Array) -> tuple[Offsets, Offsets]:
    """Return a code for each distinct combination of keys, and the first row of each code."""
    import pandas as pd

    # Pandas wants the machine's own byte order.
    native = [np.ascontiguousarray(key, key.dtype.newbyteorder("=")) for key in keys]
    code = pd.factorize(native[0])[0].astype(np.int64)
    for key in native[1:]:
        other, values = pd.factorize(key)
        code = pd.factorize(code * (len(values) + 1) + other)[0].astype(np.int64)
    return code, np.flatnonzero(~pd.Series(code).duplicated().to_numpy())


def cumcount(code: Array) -> Offsets:
    """Return how many equal elements precede each element."""
    import pandas as pd

    return np.asarray(pd.Series(code).groupby(code).cumcount(), np.int64)


@dataclass(frozen=True)
class IdTable:
    """A number from 0 on for each distinct byte string, such as an address."""

    ids: dict[bytes, int] = field(default_factory=dict)

    def id_of(self, key: bytes) -> int:
        """Return the number of one byte string."""
        return self.ids.setdefault(key, len(self.ids))

    def ids_of(self, data: Bytes, at: Offsets, octets: int) -> NDArray[np.int32]:
        """Return the numbers of the byte strings at the offsets; ``octets`` is a multiple of 4."""
        keys = [numbers_at(data, at + offset, "=u4") for offset in range(0, octets, 4)]
        code, first = factorize(*keys)
        ids = [self.id_of(data[begin : begin + octets].tobytes()) for begin in at[first].tolist()]
        return np.array(ids, np.int32)[code]
