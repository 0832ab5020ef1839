"""Paths of the lab's tables, with functions to read and write them.

A table that a package reads lies in that package; the others lie in `lab/data/`.
"""

import csv
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from discostorm.data import data_path, read_data

DATA = Path(__file__).resolve().parents[1] / "data"
CORE = data_path("measured")
PLANNER = data_path("measured", "discostorm_planner")
BOOK = data_path("measured", "discostorm_book")


def read_lab_table(name: str) -> list[dict[str, str]]:
    """Return the rows of a table of `lab/data/`, such as "faults.csv"."""
    return read_data(str(DATA / name))


def write_table(path: Path, rows: Iterable[Mapping[str, Any]], columns: Iterable[str] = ()) -> None:
    """Write a table with these columns, or with the columns of its first row."""
    rows = list(rows)
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.open("w", newline="", encoding="utf-8") as file:
        heading = list(columns) or list(rows[0])
        table = csv.DictWriter(file, heading, lineterminator="\n", extrasaction="ignore")
        table.writeheader()
        table.writerows(rows)
    print(f"{len(rows)} rows in {path}")
