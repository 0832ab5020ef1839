"""The tables of the sweeps, and the settings of each table."""

import csv
from collections.abc import Callable, Iterable
from dataclasses import asdict, replace
from typing import Any

from sweep_setting import ALL_TABLES, MEASURED_TABLES, PAPER_TABLES, SweepSetting, table_path


def combinations(base: SweepSetting, **options: Iterable[Any]) -> list[SweepSetting]:
    """Return the settings of all combinations; the first option varies slowest."""
    settings = [base]
    for name, values in options.items():
        settings = [replace(one, **{name: value}) for one in settings for value in values]
    return settings


WITHOUT_QUEUE_LIMITS = SweepSetting("DDS", 2, queue_frames=0, queue_s=0.0)
WITH_RECOVERY = SweepSetting("DDS", 2, recovery=1)
TEN_RUNS = SweepSetting("DDS", 2, runs=10)
#: The same settings as the ns-3 bursts that these are compared with.
COMPARED_WITH_NS3 = replace(TEN_RUNS, runs=100, agreements="in place")
#: Staggered starts are compared with each other, which needs medians of many runs.
STAGGERED = replace(WITH_RECOVERY, until_s=600.0, runs=100)


def with_stored_runs(settings: list[SweepSetting]) -> list[SweepSetting]:
    """Return settings with the number of runs of their stored table, if there is one."""
    names = ["protocol", "hosts", "mpdus", "recovery", "start"]
    path = table_path("fits")
    with path.open(encoding="utf-8") as file:
        runs = {tuple(row[name] for name in names): row["runs"] for row in csv.DictReader(file)}
    keys = [tuple(str(getattr(one, name)) for name in names) for one in settings]
    return [
        replace(one, runs=int(runs.get(key, one.runs)))
        for one, key in zip(settings, keys, strict=True)
    ]


#: Settings of each table.
SWEEPS: dict[str, Callable[[], list[SweepSetting]]] = {
    "drain": lambda: combinations(
        WITHOUT_QUEUE_LIMITS,
        protocol=PAPER_TABLES,
        mpdus=(1, 64),
        hosts=(*range(2, 13), 15, 20, 25, 30),
    ),
    "queues": lambda: combinations(
        TEN_RUNS,
        protocol=PAPER_TABLES,
        mpdus=(1, 64),
        hosts=(*range(2, 13), 14, 16, 20, 25, 30, 40, 50),
    ),
    # Many runs, because losses vary by many percentage points between runs.
    "rates": lambda: combinations(
        replace(TEN_RUNS, runs=100),
        protocol=PAPER_TABLES,
        radio=("n", "ax"),
        mpdus=(1, 64),
        hosts=(5, 7, 10),
    ),
    # The settings of ns-3.
    "beside_ns3": lambda: (
        combinations(
            COMPARED_WITH_NS3,
            protocol=PAPER_TABLES,
            mpdus=(1, 64),
            hosts=(2, 3, 4, 5, 6, 7, 8, 10, 12),
        )
        + combinations(
            COMPARED_WITH_NS3,
            protocol=PAPER_TABLES,
            mpdus=(1, 64),
            hosts=(3, 6),
            loss=(0.05, 0.2),
        )
        + combinations(
            replace(COMPARED_WITH_NS3, queue_frames=100),
            protocol=PAPER_TABLES,
            mpdus=(1, 64),
            hosts=(4, 8, 12),
        )
    ),
    "built": lambda: (
        combinations(
            replace(WITHOUT_QUEUE_LIMITS, runs=10), protocol=MEASURED_TABLES, hosts=(5, 10, 20, 30)
        )
        + combinations(TEN_RUNS, protocol=MEASURED_TABLES, hosts=(5, 10, 20, 30))
    ),
    "convergence": lambda: combinations(
        replace(WITH_RECOVERY, runs=10),
        protocol=ALL_TABLES,
        loss=(0.0, 0.1, 0.3),
        hosts=(2, 4, 6, 8, 10, 12, 14, 16, 20, 24),
    ),
    "staggered": lambda: (
        combinations(
            replace(STAGGERED, start="random"),
            protocol=PAPER_TABLES,
            hosts=(5, 10, 15, 20),
            window_s=(0.5, 1.0, 2.0, 4.0, 7.0, 10.0, 15.0, 20.0, 30.0, 45.0),
        )
        + combinations(
            STAGGERED,
            protocol=PAPER_TABLES,
            hosts=(5, 10, 15, 20),
            start=("together", "rule", "in turn"),
            radio=("n", "ax"),
            mpdus=(1, 64),
        )
    ),
    "fits": lambda: with_stored_runs(
        combinations(WITHOUT_QUEUE_LIMITS, protocol=PAPER_TABLES, mpdus=(1, 64), hosts=range(2, 31))
        + combinations(
            replace(WITH_RECOVERY, until_s=30.0),
            protocol=PAPER_TABLES,
            mpdus=(1, 64),
            start=("together", "rule", "in turn"),
            hosts=range(2, 31),
        )
        # With aggregation and a staggered start, more hosts fit.
        + combinations(
            replace(WITH_RECOVERY, until_s=30.0, mpdus=64),
            protocol=PAPER_TABLES,
            start=("rule", "in turn"),
            hosts=range(31, 41),
        )
    ),
}


def table_settings(name: str) -> list[SweepSetting]:
    """Return the settings of a table, each once, in order."""
    return sorted(set(SWEEPS[name]()), key=lambda one: tuple(asdict(one).values()))
