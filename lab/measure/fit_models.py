"""Fit the measured models to the lab's counts: the core's `data/measured/as_built.csv`.

`data/vendors/as_built.csv` lists a product's messages with receivers and schedule. This program
fits the missing numbers per unit, the sizes and the frames per message to one half of the points:
those marked with `fit` in `runs.csv` and `beyond_runs.csv`. It does the same for `mitigations.csv`.
"""

import argparse
from collections import defaultdict
from collections.abc import Hashable, Iterator, Mapping
from dataclasses import dataclass
from itertools import combinations
from pathlib import Path
from statistics import median
from typing import Any

import numpy as np
from lab_data import BOOK, CORE, read_lab_table, write_table
from numpy.typing import NDArray
from release_points import release_of, release_points

from discostorm.messages import UNITS, Protocol
from discostorm.protocols import PROTOCOLS
from discostorm.protocols.measured_tables import (
    configurations,
    measured_table,
    message_rows,
    product_releases,
    products,
    schedule_from_row,
)
from discostorm_book.comparison import (
    MAX_KIND_ERROR,
    MAX_MITIGATED_ERROR,
    MAX_PHASE_ERROR,
    compare_with_runs,
    count_scheduled_times,
)
from discostorm_book.lab_counts import WINDOWS, GridPoint, grid_points

COLUMNS = (
    *("protocol", "message", "per_unit", "payload_B", "low_B", "high_B"),
    *("frames", "fewest_frames", "most_frames"),
)
MISS_COLUMNS = ("protocol", "point", "window", "phase", "kind", "quantity", "error", "reason")
#: Tables of each family.
FAMILIES = {"as_built": products, "mitigations": configurations, "releases": product_releases}
#: Stored digits; the fits are not more accurate.
DIGITS = 4
#: Minimum share of a kind that must remain without its periodic part to fit a size.
MIN_SHARE_FOR_SIZE = 0.25
#: Tables whose links are TCP streams between routers: the kinds on these streams, and the bytes of
#: a full TCP segment with Linux's timestamps [B].
TABLES_WITH_STREAMS = ("Zenoh router per host", "Zenoh router per host, star")
STREAMED_KINDS = ("OAM", "Frame", "Declare", "Declare key expression")
SEGMENT_BYTES = 1448
#: The same minimum share where other points fit the sizes of the kind's other rows.
MIN_SHARE_BESIDE_OTHER_FITS = 0.1

Row = dict[str, str]


@dataclass(frozen=True)
class MessageSizes:
    """Payload of a message [B] and its frames [1]: median of the points, minimum, maximum."""

    payload: tuple[float, float, float]
    frames: tuple[float, float, float]

    @property
    def mean(self) -> tuple[float, float]:
        """Frames and payload of a message, in the order of a point's counts."""
        return self.frames[0], self.payload[0]


def fit_least_absolute_deviations(
    terms: NDArray[np.float64], wanted: NDArray[np.float64]
) -> list[float]:
    """Return the non-negative factors that minimize the sum of absolute deviations from ``wanted``.

    The optimum fits as many rows exactly as there are positive factors, so all such choices are
    tried.
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


def fit_messages_per_unit(rows: list[Row], points: list[GridPoint]) -> list[float]:
    """Return the number of messages per unit of each row: given by its table, or fitted."""
    key = count_key_of_row(rows[0])
    given = np.array([float(row["per_unit"] or 0) for row in rows])
    free = [index for index, row in enumerate(rows) if not row["per_unit"]]
    if free:
        terms, wanted = [], []
        for point in points:
            for window in WINDOWS:
                if number := point.median((window, *key))[0]:
                    each = (
                        np.array([count_sent_messages(row, point, window) for row in rows]) / number
                    )
                    terms.append(each[free])
                    wanted.append(1 - each @ given)
        given[free] = fit_least_absolute_deviations(np.array(terms), np.array(wanted))
    return [float(number) for number in given]


def count_key_of_row(row: Row) -> tuple[str, str, str, str]:
    """Return the key of a row's counts: kind, subject, delivery and hop."""
    return row["kind"], row["about"], row["cast"], row.get("hops", "")


def count_sent_messages(row: Row, point: GridPoint, window: str) -> float:
    """Return how often a row is sent in a window if each unit sends one message."""
    return float(UNITS[row["unit"]].count(point.fleet)) * count_scheduled_times(
        schedule_from_row(row), window
    )


def fit_sizes(rows: list[Row], numbers: list[float], points: list[GridPoint]) -> list[MessageSizes]:
    """Return the sizes of the rows of one kind.

    Periodic rows get the sizes of the steady window. The other rows get the sizes of the startup
    window after the periodic rows are subtracted.
    """
    key = count_key_of_row(rows[0])
    repeated = [bool(row["period_s"]) for row in rows]
    steady = sizes_from_counts([point.median(("steady", *key)) for point in points])
    left = []
    for point in points:
        counted = point.median(("startup", *key))
        if not any(count_sent_messages(row, point, "startup") for row in rows):
            continue  # a kind that this swarm sends only by accident
        if steady is not None:
            again = sum(
                number * count_sent_messages(row, point, "startup")
                for row, number, repeats in zip(rows, numbers, repeated, strict=True)
                if repeats
            )
            if counted[0] - again < MIN_SHARE_FOR_SIZE * counted[0]:
                continue
            counted = counted - again * np.array([1, steady.frames[0], steady.payload[0]])
        left.append(counted)
    starting = sizes_from_counts(left) or steady
    assert starting is not None, key
    return [steady if repeats and steady else starting for repeats in repeated]


def fit_sizes_row_by_row(
    rows: list[Row], numbers: list[float], points: list[GridPoint]
) -> list[MessageSizes]:
    """Return the sizes of the rows of one kind, one row at a time.

    A row is fitted at the points and windows where no other unknown row is sent, after the known
    rows are subtracted. Rows that never occur alone share one size.
    """
    key = count_key_of_row(rows[0])
    known: dict[int, MessageSizes] = {}

    def remaining_sizes(unknown: list[int]) -> MessageSizes | None:
        """Fit the sizes of ``unknown`` rows at the points where no other unknown row is sent."""
        others = [index for index in range(len(rows)) if index not in (*known, *unknown)]
        counts = []
        for point in points:
            for window in WINDOWS:
                many = [
                    n * count_sent_messages(row, point, window)
                    for n, row in zip(numbers, rows, strict=True)
                ]
                counted = point.median((window, *key))
                if any(many[index] for index in others) or not any(many[i] for i in unknown):
                    continue
                rest = counted - sum(
                    many[index] * np.array([1, *known[index].mean]) for index in known
                )
                if rest[0] > 0 and rest[0] >= MIN_SHARE_BESIDE_OTHER_FITS * counted[0]:
                    counts.append(rest)
        return sizes_from_counts(counts)

    while len(known) < len(rows):
        unknown = [index for index in range(len(rows)) if index not in known]
        for index in unknown:
            if (alone := remaining_sizes([index])) is not None:
                known[index] = alone
                break
        else:
            # Rows too rare to separate get a common size.
            together = remaining_sizes(unknown) or next(iter(known.values()))
            known |= dict.fromkeys(unknown, together)
    return [known[index] for index in range(len(rows))]


def frames_on_streams(
    frame: Row, rows: list[tuple[Row, float, MessageSizes]], points: list[GridPoint]
) -> dict[str, tuple[float, float, float]]:
    """Return the frames per message on one hop of a link between routers, by message.

    Waiting messages enter the stream together and fill TCP segments. Each batch starts with a
    transport Frame and ends with a partial segment. So all messages count full segments, and the
    partial segments belong to the Frames.
    """
    mine = [entry for entry in rows if entry[0].get("hops", "") == frame.get("hops", "")]
    kinds = {row["kind"] for row, _, _ in mine if row["kind"] in STREAMED_KINDS}
    parts = []
    for point in points:
        keys = {kind: ("startup", kind, "", "unicast", frame.get("hops", "")) for kind in kinds}
        counted = {kind: point.median(key) for kind, key in keys.items()}
        rest = sum(frames - octets / SEGMENT_BYTES for _, frames, octets in counted.values())
        parts.append(float(rest / counted["Frame"][0]))
    full = {
        row["message"]: (
            size.payload[0] / SEGMENT_BYTES,
            size.payload[1] / SEGMENT_BYTES,
            size.payload[2] / SEGMENT_BYTES,
        )
        for row, _, size in mine
        if row["kind"] in kinds
    }
    own = (median(parts), min(parts), max(parts))
    frames = {row["message"]: own for row, _, _ in mine if row["kind"] == "Frame"}
    return full | frames


def fit_piggybacked_rows(
    carriers: list[Row],
    piggybacked: list[Row],
    numbers: list[float],
    frames: MessageSizes,
    points: list[GridPoint],
) -> tuple[list[float], list[MessageSizes]]:
    """Return the numbers of rows inside other messages, and the sizes of all rows of a kind.

    The steady window gives the octets of a message and of each row inside. A factor reduces the
    rows inside during startup, when lists are not complete yet.
    """
    key = count_key_of_row(carriers[0])

    def sum_of(rows: list[Row], point: GridPoint, window: str) -> float:
        many = dict(zip((row["message"] for row in carriers), numbers, strict=True))
        each = (
            many[row["inside"] or row["message"]] * count_sent_messages(row, point, window)
            for row in rows
        )
        return sum(each)

    def octets(point: GridPoint, window: str) -> float:
        return float(point.median((window, *key))[2])

    steady = [
        [sum_of(rows, point, "steady") for rows in (carriers, piggybacked)] for point in points
    ]
    sizes = np.array([octets(point, "steady") for point in points])
    around, part = fit_least_absolute_deviations(
        np.array(steady) / sizes[:, None], np.ones(len(points))
    )
    at_start = [row for row in piggybacked if not row["period_s"]]
    again = [row for row in piggybacked if row["period_s"]]
    terms, wanted = [], []
    for point in points:
        whole = octets(point, "startup")
        rest = around * sum_of(carriers, point, "startup") + part * sum_of(again, point, "startup")
        terms.append([part * sum_of(at_start, point, "startup") / whole])
        wanted.append(1 - rest / whole)
    (factor,) = fit_least_absolute_deviations(np.array(terms), np.array(wanted))
    many = dict(zip((row["message"] for row in carriers), numbers, strict=True))
    counts = [many[row["inside"]] * (1 if row["period_s"] else factor) for row in piggybacked]
    return counts, [MessageSizes((around,) * 3, frames.frames)] * len(carriers) + [
        MessageSizes((part,) * 3, (0.0,) * 3)
    ] * len(piggybacked)


def sizes_from_counts(counts: list[NDArray[np.float64]]) -> MessageSizes | None:
    """Return the sizes of a message from its counts; None if no point counted the message."""
    parts = [count[1:] / count[0] for count in counts if count[0] > 0]
    if not parts:
        return None
    frames, payload = (
        (median(values), min(values), max(values)) for values in zip(*parts, strict=True)
    )
    return MessageSizes(payload, frames)


def rows_of_family(family: str) -> Iterator[Row]:
    """Yield the rows of the table of a family."""
    for name, table in FAMILIES[family]().items():
        seen = [point for point in points_of_table(name, table) if point.use == "fit"]
        yield from fitted_rows(name, table, seen)


def points_of_table(name: str, table: Mapping[str, str]) -> tuple[GridPoint, ...]:
    """Return the swarms that were measured for a table."""
    if table.get("release") and name in product_releases():
        return release_points(release_of(table))
    return grid_points(name) + grid_points(name, "beyond")


def fitted_rows(name: str, table: Mapping[str, str], points: list[GridPoint]) -> Iterator[Row]:
    """Yield the rows of a table that these points give."""
    kinds: dict[tuple[str, ...], list[Row]] = defaultdict(list)
    for row in message_rows(table):
        kinds[count_key_of_row(row)].append(row)
    done: list[tuple[Row, float, MessageSizes]] = []
    for rows in kinds.values():
        least = max(int(row["fit_from"]) for row in rows)
        enough = [point for point in points if point.fleet.processes() >= least]
        own = [row for row in rows if not row.get("inside")]
        numbers = fit_messages_per_unit(own, enough)
        found = (fit_sizes if table["basis"] == "measured" else fit_sizes_row_by_row)(
            own, numbers, enough
        )
        inside = [row for row in rows if row.get("inside")]
        if inside:
            more, found = fit_piggybacked_rows(own, inside, numbers, found[0], enough)
            numbers += more
        done += zip(own + inside, numbers, found, strict=True)
    frames: dict[str, tuple[float, float, float]] = {}
    if name in TABLES_WITH_STREAMS:
        for row, _, _ in done:
            if row["kind"] == "Frame":
                frames |= frames_on_streams(row, done, points)
    for row, number, size in done:
        part = frames.get(row["message"], size.frames)
        values = [f"{value:.{DIGITS}g}" for value in (number, *size.payload, *part)]
        yield dict(zip(COLUMNS, (name, row["message"], *values), strict=True))


def model_errors(protocol: Protocol, use: str = "test") -> list[dict[str, str]]:
    """Return where a measured model exceeds its allowed error, on one half of the grid.

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
            limit = (
                MAX_MITIGATED_ERROR if arranged else MAX_PHASE_ERROR if of_phase else MAX_KIND_ERROR
            )
            if abs(count - measured) > limit * measured:
                error = f"{count / measured - 1:+.3f}" if measured else "none"
                head = {name: row[name] for name in ("point", "window", "phase", "kind")}
                reason = _reason(protocol.name, row, count, row[f"least{end}"], row[f"most{end}"])
                tail = {"quantity": quantity, "error": error, "reason": reason}
                found.append({"protocol": protocol.name} | head | tail)
    return found


def _reason(
    protocol: str, row: dict[Hashable, Any], count: float, minimum: float, maximum: float
) -> str:
    """Return why a model may be off: by the runs of a point, its size, or the product's source."""
    hosts, processes, _ = row["point"].split("x")
    everyone = int(hosts) * int(processes)
    if minimum <= count <= maximum:
        return "scatter"
    cause = _cause(protocol, row["phase"])
    if cause is not None and (everyone > 2 or cause["of_one_pair"] == "yes"):
        return cause["reason"]
    if everyone == 2:
        return "one pair"
    return "crowd" if everyone >= 6 else "form"


def _cause(protocol: str, phase: str) -> dict[str, str] | None:
    """Return the cause of a phase's deviation, if the product's source states one."""
    run = (products() | configurations())[protocol]
    for row in read_lab_table("causes.csv"):
        of_run = row["product"] == run["product"] and row["variant"] in ("", run["variant"])
        if of_run and row["phase"] == phase:
            return row
    return None


def main() -> None:
    """Write the models, or the deviations of the stored models."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=Path, help="folder, instead of those of the packages")
    parser.add_argument("--misses", action="store_true", help="what the models as they are miss")
    given = parser.parse_args()
    for family in FAMILIES:
        if not given.misses:
            write_table((given.out or CORE) / f"{family}.csv", rows_of_family(family), COLUMNS)
            continue
        if family == "releases":
            continue
        tables = [PROTOCOLS.get(name) or measured_table(name) for name in FAMILIES[family]()]
        missed = [row for table in tables for row in model_errors(table)]
        name = "misses" if family == "as_built" else "mitigation_misses"
        write_table((given.out or BOOK) / f"{name}.csv", missed, MISS_COLUMNS)


if __name__ == "__main__":
    main()
