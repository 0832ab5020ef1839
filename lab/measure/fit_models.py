"""Fit the measured models to what the lab counted: the core's `data/measured/as_built.csv`.

`data/vendors/as_built.csv` says which messages a product sends, for what and when. What it does
not say, how many for each unit, is fitted here, as are sizes and parts of frames, to one half of
the points: those that `runs.csv` and `beyond_runs.csv` mark with `fit`. So are those of
`mitigations.csv`.
"""

import argparse
from collections import defaultdict
from collections.abc import Hashable, Iterator
from dataclasses import dataclass
from itertools import combinations
from pathlib import Path
from statistics import median
from typing import Any

import numpy as np
from lab_data import BOOK, CORE, read, write
from numpy.typing import NDArray

from discostorm.data import read_data
from discostorm.measured import configurations, products
from discostorm.messages import UNITS, Protocol
from discostorm.protocols import PROTOCOLS
from discostorm.protocols.as_built import ROWS, as_built, schedule
from discostorm_book.comparison import (
    WITHIN_KIND,
    WITHIN_MITIGATED,
    WITHIN_PHASE,
    compare_with_runs,
    times,
)
from discostorm_book.lab_counts import WINDOWS, Point, beyond, points

COLUMNS = (
    *("protocol", "message", "per_unit", "payload_B", "low_B", "high_B"),
    *("frames", "fewest_frames", "most_frames"),
)
MISSES = ("protocol", "point", "window", "phase", "kind", "quantity", "error", "reason")
#: The names of the tables of a family.
NAMES = {"as_built": products, "mitigations": configurations}
#: Digits that are kept: the fits are no better than this.
DIGITS = 4
#: What is left of a kind without what is repeated must be this part of it to tell its size.
LEAST_PART = 0.25
#: Tables whose links are streams between routers: what is sent on them, and the bytes of a segment
#: of TCP that is full, with the timestamps of Linux [B].
STREAMS = ("Zenoh router per host", "Zenoh router per host, star")
STREAMED = ("OAM", "Frame", "Declare", "Declare key expression")
SEGMENT = 1448
#: The same where the sizes of what else is of a kind are those of other points.
LEAST_REST = 0.1

Row = dict[str, str]


@dataclass(frozen=True)
class Sizes:
    """Payload of a message [B] and its part of frames [1]: median of the points, least, most."""

    payload: tuple[float, float, float]
    frames: tuple[float, float, float]

    @property
    def mean(self) -> tuple[float, float]:
        """Part of frames and payload, as the columns of a point's counts have them."""
        return self.frames[0], self.payload[0]


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
    key = kind_of(rows[0])
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


def kind_of(row: Row) -> tuple[str, str, str, str]:
    """Return what a row is counted under: kind, what it is about, cast and hop."""
    return row["kind"], row["about"], row["cast"], row.get("hops", "")


def sent(row: Row, point: Point, window: str) -> float:
    """Return how often something is sent in a window if it is once for each unit."""
    return float(UNITS[row["unit"]].count(point.fleet)) * times(schedule(row), window)


def sizes(rows: list[Row], numbers: list[float], seen: list[Point]) -> list[Sizes]:
    """Return the sizes of the rows of one kind.

    What is repeated has those of the steady window, the others those of what is left of the
    start without it.
    """
    key = kind_of(rows[0])
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


def sizes_apart(rows: list[Row], numbers: list[float], seen: list[Point]) -> list[Sizes]:
    """Return the sizes of the rows of one kind.

    A row has those of the points and windows at which it alone is sent of the rows whose sizes are
    not known yet, less what is. Rows that are never alone share theirs.
    """
    key = kind_of(rows[0])
    known: dict[int, Sizes] = {}

    def left(unknown: list[int]) -> Sizes | None:
        """Return the sizes of what is left at the points that have no others but these."""
        others = [index for index in range(len(rows)) if index not in (*known, *unknown)]
        counts = []
        for point in seen:
            for window in WINDOWS:
                many = [n * sent(row, point, window) for n, row in zip(numbers, rows, strict=True)]
                counted = point.median((window, *key))
                if any(many[index] for index in others) or not any(many[i] for i in unknown):
                    continue
                rest = counted - sum(
                    many[index] * np.array([1, *known[index].mean]) for index in known
                )
                if rest[0] > 0 and rest[0] >= LEAST_REST * counted[0]:
                    counts.append(rest)
        return part_of(counts)

    while len(known) < len(rows):
        unknown = [index for index in range(len(rows)) if index not in known]
        for index in unknown:
            if (alone := left([index])) is not None:
                known[index] = alone
                break
        else:
            # What is too few to be told apart has the sizes of the rest.
            together = left(unknown) or next(iter(known.values()))
            known |= dict.fromkeys(unknown, together)
    return [known[index] for index in range(len(rows))]


def streamed(
    frame: Row, rows: list[tuple[Row, float, Sizes]], seen: list[Point]
) -> dict[str, tuple[float, float, float]]:
    """Return the parts of frames of what one hop of a link between routers carries, by message.

    What waits is written into the stream together: it fills segments, and each batch, which a Frame
    of transport begins, ends with one that is not full. So all fill full segments, and Frames have
    the rest.
    """
    mine = [entry for entry in rows if entry[0].get("hops", "") == frame.get("hops", "")]
    kinds = {row["kind"] for row, _, _ in mine if row["kind"] in STREAMED}
    parts = []
    for point in seen:
        keys = {kind: ("startup", kind, "", "unicast", frame.get("hops", "")) for kind in kinds}
        counted = {kind: point.median(key) for kind, key in keys.items()}
        rest = sum(frames - octets / SEGMENT for _, frames, octets in counted.values())
        parts.append(float(rest / counted["Frame"][0]))
    full = {
        row["message"]: (
            size.payload[0] / SEGMENT,
            size.payload[1] / SEGMENT,
            size.payload[2] / SEGMENT,
        )
        for row, _, size in mine
        if row["kind"] in kinds
    }
    own = (median(parts), min(parts), max(parts))
    frames = {row["message"]: own for row, _, _ in mine if row["kind"] == "Frame"}
    return full | frames


def listed(
    own: list[Row], inside: list[Row], numbers: list[float], frames: Sizes, seen: list[Point]
) -> tuple[list[float], list[Sizes]]:
    """Return how many rows inside of others there are for each unit, and all sizes of a kind.

    The steady window tells what a message has without and for what is inside; what the start
    lacks of lists that are not complete yet is a factor.
    """
    key = kind_of(own[0])

    def sum_of(rows: list[Row], point: Point, window: str) -> float:
        many = dict(zip((row["message"] for row in own), numbers, strict=True))
        each = (many[row["inside"] or row["message"]] * sent(row, point, window) for row in rows)
        return sum(each)

    def octets(point: Point, window: str) -> float:
        return float(point.median((window, *key))[2])

    steady = [[sum_of(rows, point, "steady") for rows in (own, inside)] for point in seen]
    sizes = np.array([octets(point, "steady") for point in seen])
    around, part = least_deviations(np.array(steady) / sizes[:, None], np.ones(len(seen)))
    at_start = [row for row in inside if not row["period_s"]]
    again = [row for row in inside if row["period_s"]]
    terms, wanted = [], []
    for point in seen:
        whole = octets(point, "startup")
        rest = around * sum_of(own, point, "startup") + part * sum_of(again, point, "startup")
        terms.append([part * sum_of(at_start, point, "startup") / whole])
        wanted.append(1 - rest / whole)
    (factor,) = least_deviations(np.array(terms), np.array(wanted))
    many = dict(zip((row["message"] for row in own), numbers, strict=True))
    counts = [many[row["inside"]] * (1 if row["period_s"] else factor) for row in inside]
    return counts, [Sizes((around,) * 3, frames.frames)] * len(own) + [
        Sizes((part,) * 3, (0.0,) * 3)
    ] * len(inside)


def part_of(counts: list[NDArray[np.float64]]) -> Sizes | None:
    """Return the sizes of a message that was counted at some points, None if at none."""
    parts = [count[1:] / count[0] for count in counts if count[0] > 0]
    if not parts:
        return None
    frames, payload = (
        (median(values), min(values), max(values)) for values in zip(*parts, strict=True)
    )
    return Sizes(payload, frames)


def fitted(family: str) -> Iterator[Row]:
    """Yield the rows of the table of a family."""
    for name in NAMES[family]():
        seen = [point for point in points(name) + beyond(name) if point.use == "fit"]
        kinds: dict[tuple[str, ...], list[Row]] = defaultdict(list)
        for row in read_data(f"vendors/{family}.csv"):
            if row["protocol"] == name:
                kinds[kind_of(row)].append(row)
        done: list[tuple[Row, float, Sizes]] = []
        for rows in kinds.values():
            least = max(int(row["fit_from"]) for row in rows)
            enough = [point for point in seen if point.fleet.processes() >= least]
            own = [row for row in rows if not row.get("inside")]
            numbers = fit(own, enough)
            found = (sizes if family == "as_built" else sizes_apart)(own, numbers, enough)
            inside = [row for row in rows if row.get("inside")]
            if inside:
                more, found = listed(own, inside, numbers, found[0], enough)
                numbers += more
            done += zip(own + inside, numbers, found, strict=True)
        frames: dict[str, tuple[float, float, float]] = {}
        if name in STREAMS:
            for row, _, _ in done:
                if row["kind"] == "Frame":
                    frames |= streamed(row, done, seen)
        for row, number, size in done:
            part = frames.get(row["message"], size.frames)
            values = [f"{value:.{DIGITS}g}" for value in (number, *size.payload, *part)]
            yield dict(zip(COLUMNS, (name, row["message"], *values), strict=True))


def misses(protocol: Protocol, use: str = "test") -> list[dict[str, str]]:
    """Return where a table as built is off by more than it should be, on one half of the grid.

    Returns
    -------
    list of dict
        ``protocol``, ``point``, ``window``, ``phase``, ``kind`` ("all" of a phase), ``quantity``
        (messages or bytes), ``error`` [1], and ``reason``, one of ``data/measured/reasons.csv``.
    """
    table = compare_with_runs(protocol)
    arranged = protocol.name in configurations()
    found = []
    for row in table[table["use"] == use].to_dict("records"):
        for quantity, end in (("messages", ""), ("bytes", "_bytes")):
            measured, count = row[f"measured{end}"], row[f"expected{end}"]
            of_phase = row["kind"].startswith("all")
            if arranged and not of_phase:
                continue
            limit = WITHIN_MITIGATED if arranged else WITHIN_PHASE if of_phase else WITHIN_KIND
            if abs(count - measured) > limit * measured:
                error = f"{count / measured - 1:+.3f}" if measured else "none"
                head = {name: row[name] for name in ("point", "window", "phase", "kind")}
                reason = _reason(protocol.name, row, count, row[f"least{end}"], row[f"most{end}"])
                tail = {"quantity": quantity, "error": error, "reason": reason}
                found.append({"protocol": protocol.name} | head | tail)
    return found


def _reason(
    protocol: str, row: dict[Hashable, Any], count: float, least: float, most: float
) -> str:
    """Return why a table may be off: what the runs of a point, its size and the source say."""
    hosts, processes, _ = row["point"].split("x")
    everyone = int(hosts) * int(processes)
    if least <= count <= most:
        return "scatter"
    cause = _cause(protocol, row["phase"])
    if cause is not None and (everyone > 2 or cause["of_one_pair"] == "yes"):
        return cause["reason"]
    if everyone == 2:
        return "one pair"
    return "crowd" if everyone >= 6 else "form"


def _cause(protocol: str, phase: str) -> dict[str, str] | None:
    """Return what decides a phase of a product, where its source says so."""
    run = (products() | configurations())[protocol]
    for row in read("causes.csv"):
        of_run = row["product"] == run["product"] and row["variant"] in ("", run["variant"])
        if of_run and row["phase"] == phase:
            return row
    return None


def main() -> None:
    """Write the models, or what the models as they are miss."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=Path, help="folder, instead of those of the packages")
    parser.add_argument("--misses", action="store_true", help="what the models as they are miss")
    given = parser.parse_args()
    for family in ROWS.values():
        if not given.misses:
            write((given.out or CORE) / f"{family}.csv", fitted(family), COLUMNS)
            continue
        tables = [PROTOCOLS.get(name) or as_built(name) for name in NAMES[family]()]
        missed = [row for table in tables for row in misses(table)]
        name = "misses" if family == "as_built" else "mitigation_misses"
        write((given.out or BOOK) / f"{name}.csv", missed, MISSES)


if __name__ == "__main__":
    main()
