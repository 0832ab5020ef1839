"""The data files of the package; every row of each table names its source."""

import csv
from functools import cache
from pathlib import Path


def data_path(name: str) -> Path:
    """Return where a data file of the package is, such as ``fleets/nav2_laptop.toml``."""
    # Not importlib.resources, which takes a tenth of the time of importing sympy.
    return Path(__file__).parent / name


@cache
def read_data(name: str) -> list[dict[str, str]]:
    """Return the rows of a table of the package, such as ``paper/table2.csv``."""
    names, *rows = csv.reader(data_path(name).read_text(encoding="utf-8").splitlines())
    return [dict(zip(names, row, strict=True)) for row in rows]
