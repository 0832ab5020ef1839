"""The data files of the package; every row of each names its source."""

import csv
from functools import cache
from importlib.resources import files


@cache
def read_data(name: str) -> list[dict[str, str]]:
    """Return the rows of a data file of the package; every row names its source."""
    text = (files("discostorm") / "data" / name).read_text(encoding="utf-8")
    return list(csv.DictReader(text.splitlines()))
