"""Types that all readers share: arrays, offsets, tables and notes."""

from collections import Counter
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from pandas import DataFrame as DataFrame
else:
    DataFrame = Any  # pandas is imported where it is used, so that the command line starts fast
Array = NDArray[Any]
Bytes = NDArray[np.uint8]
#: Offsets into bytes, one per row of a table.
Offsets = NDArray[np.int64]
#: A table: columns of the same length, by name.
Columns = dict[str, Array]
#: Zeros after the last byte of a buffer, so that headers are read without a check for the end.
PADDING = 64


class Notes(Counter[str]):
    """What could not be read or counted, and how often."""

    def add_where(self, mask: Array, text: str) -> None:
        """Count the true values of a mask under a text, if there are any."""
        if count := int(np.count_nonzero(mask)):
            self[text] += count
