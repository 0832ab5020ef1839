"""The ladder: how many hosts fit as assumptions are added, and how certain that is."""

import math
import sys
from collections.abc import Iterator
from dataclasses import asdict, dataclass, replace
from itertools import product
from typing import Any

from sweep_setting import MANY_RUNS, MAX_RUNS, PAPER_TABLES, SweepSetting, cached_result

#: Steps of the ladder: assumptions in words, and as options of the settings.
CONTENTION_ASSUMED = "hosts contend and collide; queues without limit, nothing is repaired"
QUEUES_ASSUMED = "queues of 500 frames and 0.5 s; the middleware repairs what is lost"
LADDER: list[tuple[str, str, dict[str, object]]] = [
    ("contention", CONTENTION_ASSUMED, {"recovery": 0, "start": "together"}),
    ("queues", QUEUES_ASSUMED, {"recovery": 1, "start": "together"}),
    ("staggered", f"{QUEUES_ASSUMED}; random starts, see window", {"recovery": 1, "start": "rule"}),
    (
        "in turn",
        f"{QUEUES_ASSUMED}; starts in turn, see in_turn",
        {"recovery": 1, "start": "in turn"},
    ),
]
#: Criteria: column and limit [s], without and with recovery.
CRITERIA = {0: [("drain_time_s", 1.0)], 1: [("convergence_time_s", s) for s in (10.0, 20.0)]}


@dataclass(frozen=True)
class LadderStep:
    """The number of hosts that fit under a set of assumptions, and the simulated runs."""

    protocol: str
    step: str
    assumed: str
    #: Column that is compared with the limit [s].
    column: str
    limit: float
    #: Settings with their results, in the order of hosts.
    rows: list[dict[str, Any]]

    @property
    def first_row_beyond_limit(self) -> int:
        """Index of the first row whose median exceeds the limit."""
        good = [float(row[self.column]) <= self.limit for row in self.rows]
        assert False in good, "the sweep must go on until they do not fit"
        return good.index(False)

    def interval_end(self, rank: int, end: str) -> float:
        """Return the low or high end of the median's interval in a row; NaN if there is none."""
        return float(self.rows[rank].get(f"{self.column}_{end}") or "nan")

    def undecided_rows(self) -> list[dict[str, Any]]:
        """Return the rows that need more runs to decide how many hosts fit."""
        found = []
        fewest, most = self.range_of_limit()
        for place in range(most + 2):
            low, high = self.interval_end(place, "low"), self.interval_end(place, "high")
            near = math.isnan(low) and place >= fewest
            if math.isnan(low):  # too few runs: take the quartiles
                low, high = (float(self.rows[place][f"{self.column}_{q}"]) for q in ("q25", "q75"))
            if near or low <= self.limit < high:
                found.append(self.rows[place])
        return [row for row in found if int(row["runs"]) < MAX_RUNS]

    def range_of_limit(self) -> tuple[int, int]:
        """Return the indices of the smallest and the largest host count that may be the limit."""
        low, high = self.first_row_beyond_limit - 1, self.first_row_beyond_limit
        while self.interval_end(low, "high") > self.limit:
            low -= 1
        while self.interval_end(high, "low") <= self.limit:
            high += 1
        return low, high - 1


def ladder_steps(rows: list[dict[str, Any]]) -> Iterator[LadderStep]:
    """Yield the steps of the ladder."""
    for protocol, (step, assumed, options), mpdus in product(PAPER_TABLES, LADDER, (1, 64)):
        wanted = options | {"protocol": protocol, "mpdus": mpdus}
        of_step = [row for row in rows if all(row[k] == v for k, v in wanted.items())]
        of_step.sort(key=lambda row: int(row["hosts"]))
        words = assumed + (", frames aggregated" if mpdus > 1 else "")
        for column, limit in CRITERIA[int(str(options["recovery"]))]:
            yield LadderStep(protocol, step, words, column, limit, of_step)


def settings_with_enough_runs(settings: list[SweepSetting]) -> list[SweepSetting]:
    """Return settings with enough runs to decide how many hosts fit; see `MAX_RUNS`."""
    while True:
        rows = [asdict(one) | cached_result(one) | {"setting": one} for one in settings]
        more = {row["setting"] for step in ladder_steps(rows) for row in step.undecided_rows()}
        if not more:
            return settings
        again = {one: replace(one, runs=max(MANY_RUNS, 4 * one.runs)) for one in more}
        for one in sorted(again.values(), key=lambda one: (one.runs, one.hosts)):
            sys.stderr.write(f"{one}\n")
            cached_result(one)
        settings = [again.get(one, one) for one in settings]


def ladder_rows(rows: list[dict[str, Any]]) -> list[dict[str, object]]:
    """Return the number of hosts that fit at each step of the ladder.

    A host count fits if the median run meets the criterion, for this and all smaller counts.
    """
    found: list[dict[str, object]] = []
    for step in ladder_steps(rows):
        fits, (low, high) = step.first_row_beyond_limit, step.range_of_limit()
        last, beyond = step.rows[fits - 1], step.rows[fits]
        found.append(
            {
                "protocol": step.protocol,
                "step": step.step,
                "mpdus": last["mpdus"],
                "criterion": step.column,
                "limit_s": f"{step.limit:g}",
                "processes": last["processes"],
                "endpoints": last["endpoints"],
                "hosts": last["hosts"],
                "hosts_low": step.rows[low]["hosts"],
                "hosts_high": step.rows[high]["hosts"],
                "runs": last["runs"],
                "value_s": last[step.column],
                "value_low_s": last[f"{step.column}_low"],
                "value_high_s": last[f"{step.column}_high"],
                "one_more_runs": beyond["runs"],
                "one_more_s": beyond[step.column],
                "one_more_low_s": beyond[f"{step.column}_low"],
                "one_more_high_s": beyond[f"{step.column}_high"],
                "assumed": step.assumed,
                "source": "data/simulated/fits.csv",
            }
        )
    return found
