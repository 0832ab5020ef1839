"""Every configuration of every product that was measured, for the same fleet and channel."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any

from discostorm import words
from discostorm.model import utilization
from discostorm.protocols import PROTOCOLS
from discostorm_planner.aggregation_range import Span, repeated, startup
from discostorm_planner.changes import Setting
from discostorm_planner.remedy_rules import is_built


@dataclass(frozen=True)
class Configuration:
    """What a measured configuration of a product would take.

    Parameters
    ----------
    name : str
        The name of its table.
    utilization : float
        What discovery takes of the plan's window [1].
    start : float
        How long the channel needs for the start [s]; infinity if it never catches up.
    steady : float
        What is repeated takes of the channel [1].
    startup, later : Span
        What `start` and `steady`, which are those of single frames, lie between.
    """

    name: str
    utilization: float
    start: float
    steady: float
    startup: Span
    later: Span

    def to_dict(self) -> dict[str, Any]:
        """Return all of it as what JSON can hold; a start that never ends is None."""
        return {
            "protocol": self.name,
            "utilization": self.utilization,
            "fits": words.fits(self.utilization),
            "start_s": self.start if math.isfinite(self.start) else None,
            "steady": self.steady,
            "startup": self.startup.to_dict(),
        }


def compared(base: Setting, window: float) -> tuple[Configuration, ...]:
    """Return what every measured configuration would take, that of the shortest start first.

    Without what a product sends on a network that it takes for wired: on Wi-Fi it does not.
    """
    wired = [table.wired for table in PROTOCOLS.values()]
    found = []
    for name, table in PROTOCOLS.items():
        if is_built(table) and table not in wired:
            setting = replace(base, protocol=table)
            start, later = startup(setting), repeated(setting)
            taken = float(utilization(table, base.fleet, wifi=base.wifi, window=window))
            found.append(Configuration(name, taken, start.single, later.single, start, later))
    return tuple(sorted(found, key=lambda one: (one.start, one.startup.full, one.steady)))


def table_in_words(all_of_them: tuple[Configuration, ...], width: int) -> list[str]:
    """Return a row each, in columns of equal width; a sentence each where these are too wide."""
    rows = [("", "startup", "steady state")]
    rows += [
        (
            one.name,
            words.durations(*one.startup.ends, never="never done"),
            words.percents(*one.later.ends),
        )
        for one in all_of_them
    ]
    widths = [max(len(row[i]) for row in rows) for i in range(3)]
    if sum(widths) + 6 > width:
        titles = rows[0]
        told = (
            f"{name}: {titles[1]} {start}, {titles[2]} {steady}" for name, start, steady in rows[1:]
        )
        return [words.wrapped(f"- {line}", width) for line in told]
    return [
        f"  {name:<{widths[0]}}  {start:>{widths[1]}}  {steady:>{widths[2]}}"
        for name, start, steady in rows
    ]
