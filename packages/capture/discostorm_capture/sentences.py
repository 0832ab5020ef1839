"""Sentences of ``data/written/sentences.csv``, and lists of names in them."""

from collections.abc import Sequence
from functools import cache
from typing import Any

import numpy as np

from discostorm import wording
from discostorm.data import read_data
from discostorm_capture._types import Array

#: Maximum number of names in a text; if there are more, it has the number of the rest.
MAX_NAMES = 6


@cache
def _sentences() -> dict[str, str]:
    return {row["key"]: row["text"] for row in read_data("written/sentences.csv", __package__)}


def say(key: str, *values: Any) -> str:
    """Return a sentence with values in its gaps; lists are joined."""
    single = (one if np.ndim(one) == 0 else listing([*map(str, one)]) for one in values)
    return _sentences()[key].format(*single)


def listing(names: Sequence[str] | Array) -> str:
    """Join names by commas; if there are many, only the first ones and the number of the rest."""
    if len(names) > MAX_NAMES:
        names = [*names[: MAX_NAMES - 1], f"{len(names) - MAX_NAMES + 1} more"]
    return wording.join_words([*names])
