"""Sentences of ``data/written/sentences.toml``, and lists of names in them."""

import tomllib
from collections.abc import Iterable, Sequence
from itertools import groupby
from typing import Any

import numpy as np

from discostorm import wording
from discostorm.data import data_path
from discostorm_capture._types import Array

#: Maximum number of names in a text; if there are more, it has the number of the rest.
MAX_NAMES = 6
_FILE = data_path("written/sentences.toml", "discostorm_capture")
_SENTENCES: dict[str, str] = tomllib.loads(_FILE.read_text("utf-8"))


def say(key: str, *values: Any) -> str:
    """Return a sentence with values in its gaps; lists are joined."""
    single = (one if np.ndim(one) == 0 else join_names([*map(str, one)]) for one in values)
    return _SENTENCES[key].format(*single)


def join_names(names: Sequence[str] | Array, separator: str = "") -> str:
    """Join names by commas, or clauses by a separator; of many, the first and how many more."""
    if (rest := len(names) - MAX_NAMES + 1) > 1:
        names = [*names[: MAX_NAMES - 1], f"{separator and 'and '}{rest} more"]
    return separator.join(names) if separator else wording.join_words([*names])


def join_seconds(pairs: Iterable[tuple[str, str]]) -> dict[str, str]:
    """Return the second names of pairs, joined, by the first name."""
    groups = groupby(sorted(pairs), lambda pair: pair[0])
    return {one: join_names([other for _, other in group]) for one, group in groups}
