"""Fit the tables as built to what the lab counted: `discostorm/data/measured/as_built.csv`.

`data/vendors/as_built.csv` says which messages a product sends, for what and when. What it does
not say, how many for each unit, is fitted here, as are sizes and parts of frames, to one half of
the points: those that `runs.csv` marks with `fit`.
"""

import argparse
import csv
import sys
from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations
from pathlib import Path
from statistics import median

import numpy as np
from numpy.typing import NDArray

from discostorm.data import data_path, read_data
from discostorm.measured import WINDOWS, Point, misses, points, products, times
from discostorm.messages import UNITS
from discostorm.protocols import PROTOCOLS
from discostorm.protocols.as_built import as_built, schedule

COLUMNS = (
    *("protocol", "message", "per_unit", "payload_B", "low_B", "high_B"),
    *("frames", "fewest_frames", "most_frames"),
)
MISSES = ("protocol", "point", "window", "phase", "kind", "quantity", "error", "reason")
#: Digits that are kept: the fits are no better than this.
DIGITS = 4
#: What is left of a kind without what is repeated must be this part of it to tell its size.
LEAST_PART = 0.25

Row = dict[str, str]


@dataclass(frozen=True)
class Sizes:
    """Payload of a message [B] and its part of frames [1]: median of the points, least, most."""

    payload: tuple[float, float, float]
    frames: tuple[float, float, float]


def least_deviations(terms: NDArray[np.float64], wanted: NDArray[np.float64]) -> list[float]:
    """Return the factors, none negative, whose sums deviate least from what is wanted, in all.

    The least sum of absolute deviations is met exactly at as many rows as there are factors,
    some of which may be zero; all choices are tried.
    """
    best, factors = np.inf, np.zeros(terms.shape[1])
    for many in range(1, terms.shape[1] + 1):
        for columns in combinations(range(terms.shape[1]), many):
            for rows in combinations(range(len(wanted)), many):
                part = terms[np.ix_(rows, columns)]
                if abs(np.linalg.det(part)) < 1e-9:
                    continue
                some = np.linalg.solve(part, wanted[list(rows)])
                if some.min() < 0:
                    continue
                trial = np.zeros(terms.shape[1])
                trial[list(columns)] = some
                deviation = float(np.abs(terms @ trial - wanted).sum())
                if deviation < best * (1 - 1e-12):
                    best, factors = deviation, trial
    return [float(f"{factor:.{DIGITS}g}") for factor in factors]


def fit(rows: list[Row], seen: list[Point]) -> list[float]:
    """Return how many of each row are sent for each unit: as its table says, or fitted."""
    key = (rows[0]["kind"], rows[0]["about"], rows[0]["cast"])
    given = np.array([float(row["per_unit"] or 0) for row in rows])
    free = [index for index, row in enumerate(rows) if not row["per_unit"]]
    if free:
        terms, wanted = [], []
        for point in seen:
            for window in WINDOWS:
                if number := point.median((window, *key))[0]:
                    each = np.array([sent(row, point, window) for row in rows]) / number
                    terms.append(each[free])
                    wanted.append(1 - each @ given)
        given[free] = least_deviations(np.array(terms), np.array(wanted))
    return [float(number) for number in given]


def sent(row: Row, point: Point, window: str) -> float:
    """Return how often something is sent in a window if it is once for each unit."""
    return float(UNITS[row["unit"]].count(point.fleet)) * times(schedule(row), window)


def sizes(rows: list[Row], numbers: list[float], seen: list[Point]) -> list[Sizes]:
    """Return the sizes of the rows of one kind.

    What is repeated has those of the steady window, the others those of what is left of the
    start without it.
    """
    key = (rows[0]["kind"], rows[0]["about"], rows[0]["cast"])
    repeated = [bool(row["period_s"]) for row in rows]
    steady = part_of([point.median(("steady", *key)) for point in seen])
    left = []
    for point in seen:
        counted = point.median(("startup", *key))
        if steady is not None:
            again = sum(
                number * sent(row, point, "startup")
                for row, number, repeats in zip(rows, numbers, repeated, strict=True)
                if repeats
            )
            if counted[0] - again < LEAST_PART * counted[0]:
                continue
            counted = counted - again * np.array([1, steady.frames[0], steady.payload[0]])
        left.append(counted)
    starting = part_of(left) or steady
    assert starting is not None, key
    return [steady if repeats and steady else starting for repeats in repeated]


def part_of(counts: list[NDArray[np.float64]]) -> Sizes | None:
    """Return the sizes of a message that was counted at some points, None if at none."""
    parts = [count[1:] / count[0] for count in counts if count[0] > 0]
    if not parts:
        return None
    frames, payload = (
        (median(values), min(values), max(values)) for values in zip(*parts, strict=True)
    )
    return Sizes(payload, frames)


def fitted() -> Iterator[list[str]]:
    """Yield the rows of the table."""
    for name in products():
        seen = [point for point in points(name) if point.use == "fit"]
        kinds: dict[tuple[str, ...], list[Row]] = defaultdict(list)
        for row in read_data("vendors/as_built.csv"):
            if row["protocol"] == name:
                kinds[row["kind"], row["about"], row["cast"]].append(row)
        for rows in kinds.values():
            least = max(int(row["fit_from"]) for row in rows)
            enough = [point for point in seen if point.fleet.processes() >= least]
            numbers = fit(rows, enough)
            for row, number, size in zip(rows, numbers, sizes(rows, numbers, enough), strict=True):
                values = (number, *size.payload, *size.frames)
                yield [name, row["message"], *(f"{value:.{DIGITS}g}" for value in values)]


def missed() -> list[list[str]]:
    """Return the rows of the table of exceptions."""
    tables = [PROTOCOLS.get(name) or as_built(name) for name in products()]
    return [list(row.values()) for table in tables for row in misses(table)]


def write(path: Path, columns: Sequence[str], rows: list[list[str]]) -> None:
    """Write a table."""
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(columns)
        writer.writerows(rows)
    print(f"{path}: {len(rows)} rows", file=sys.stderr)


def main() -> None:
    """Write the table, or with it as it is what it misses."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=Path, default=data_path("measured"), help="folder")
    parser.add_argument("--misses", action="store_true", help="what the tables as they are miss")
    told = parser.parse_args()
    if told.misses:
        write(told.out / "misses.csv", MISSES, missed())
    else:
        write(told.out / "as_built.csv", COLUMNS, list(fitted()))


if __name__ == "__main__":
    main()
