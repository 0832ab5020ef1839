"""The tables of the sweeps, and the settings of each table."""

import csv
from collections.abc import Callable, Iterable
from dataclasses import asdict, replace
from typing import Any

from sweep_setting import ALL, BUILT, PAPER, SweepSetting, table_path


def combinations(base: SweepSetting, **options: Iterable[Any]) -> list[SweepSetting]:
    """Return the settings of all combinations; the first option varies slowest."""
    settings = [base]
    for name, values in options.items():
        settings = [replace(one, **{name: value}) for one in settings for value in values]
    return settings


ALONE = SweepSetting("DDS", 2, queue_frames=0, queue_s=0.0)
HEALED = SweepSetting("DDS", 2, recovery=1)
ONCE = SweepSetting("DDS", 2, runs=10)
#: Equal to the bursts of ns-3 with which these are compared.
BESIDE = replace(ONCE, runs=100, agreements="in place")
#: Staggered starts are compared with each other, which needs medians of many runs.
SPREAD = replace(HEALED, until_s=600.0, runs=100)


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
        ALONE, protocol=PAPER, mpdus=(1, 64), hosts=(*range(2, 13), 15, 20, 25, 30)
    ),
    "queues": lambda: combinations(
        ONCE, protocol=PAPER, mpdus=(1, 64), hosts=(*range(2, 13), 14, 16, 20, 25, 30, 40, 50)
    ),
    # Many runs, because losses vary by many percentage points between runs.
    "rates": lambda: combinations(
        replace(ONCE, runs=100),
        protocol=PAPER,
        radio=("n", "ax"),
        mpdus=(1, 64),
        hosts=(5, 7, 10),
    ),
    # The settings of ns-3.
    "beside_ns3": lambda: (
        combinations(
            BESIDE,
            protocol=PAPER,
            mpdus=(1, 64),
            hosts=(2, 3, 4, 5, 6, 7, 8, 10, 12),
        )
        + combinations(
            BESIDE,
            protocol=PAPER,
            mpdus=(1, 64),
            hosts=(3, 6),
            loss=(0.05, 0.2),
        )
        + combinations(
            replace(BESIDE, queue_frames=100),
            protocol=PAPER,
            mpdus=(1, 64),
            hosts=(4, 8, 12),
        )
    ),
    "built": lambda: (
        combinations(replace(ALONE, runs=10), protocol=BUILT, hosts=(5, 10, 20, 30))
        + combinations(ONCE, protocol=BUILT, hosts=(5, 10, 20, 30))
    ),
    "convergence": lambda: combinations(
        replace(HEALED, runs=10),
        protocol=ALL,
        loss=(0.0, 0.1, 0.3),
        hosts=(2, 4, 6, 8, 10, 12, 14, 16, 20, 24),
    ),
    "staggered": lambda: (
        combinations(
            replace(SPREAD, start="random"),
            protocol=PAPER,
            hosts=(5, 10, 15, 20),
            window_s=(0.5, 1.0, 2.0, 4.0, 7.0, 10.0, 15.0, 20.0, 30.0, 45.0),
        )
        + combinations(
            SPREAD,
            protocol=PAPER,
            hosts=(5, 10, 15, 20),
            start=("together", "rule", "in turn"),
            radio=("n", "ax"),
            mpdus=(1, 64),
        )
    ),
    "fits": lambda: with_stored_runs(
        combinations(ALONE, protocol=PAPER, mpdus=(1, 64), hosts=range(2, 31))
        + combinations(
            replace(HEALED, until_s=30.0),
            protocol=PAPER,
            mpdus=(1, 64),
            start=("together", "rule", "in turn"),
            hosts=range(2, 31),
        )
        # With aggregation and a staggered start, more hosts fit.
        + combinations(
            replace(HEALED, until_s=30.0, mpdus=64),
            protocol=PAPER,
            start=("rule", "in turn"),
            hosts=range(31, 41),
        )
    ),
}


def table_settings(name: str) -> list[SweepSetting]:
    """Return the settings of a table, each once, in order."""
    return sorted(set(SWEEPS[name]()), key=lambda one: tuple(asdict(one).values()))
