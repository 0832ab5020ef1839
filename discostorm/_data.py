"""The data files of the package; every row of each names its source."""

import csv
from functools import cache
from pathlib import Path

# Not importlib.resources, which takes a tenth of the time of importing sympy.
_FOLDER = Path(__file__).parent / "data"


@cache
def read_data(name: str) -> list[dict[str, str]]:
    """Return the rows of a data file of the package; every row names its source."""
    text = (_FOLDER / name).read_text(encoding="utf-8")
    return list(csv.DictReader(text.splitlines()))
