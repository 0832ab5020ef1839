"""Every arrangement of every product that was measured, for the same fleet and channel."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from discostorm import words
from discostorm.fleet import Fleet
from discostorm.model import burst, utilization
from discostorm.planner.known import is_built
from discostorm.protocols import PROTOCOLS
from discostorm.timeline import drained
from discostorm.wifi import Wifi


@dataclass(frozen=True)
class Arrangement:
    """What a measured arrangement of a product would take.

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
    """

    name: str
    utilization: float
    start: float
    steady: float

    def to_dict(self) -> dict[str, Any]:
        """Return all of it as what JSON can hold; a start that never ends is None."""
        return {
            "protocol": self.name,
            "utilization": self.utilization,
            "fits": words.fits(self.utilization),
            "start_s": self.start if math.isfinite(self.start) else None,
            "steady": self.steady,
        }


def compared(fleet: Fleet, wifi: Wifi, window: float) -> tuple[Arrangement, ...]:
    """Return what every measured arrangement would take, that of the shortest start first.

    Without what a product sends on a network that it takes for wired: on Wi-Fi it does not.
    """
    wired = [table.wired for table in PROTOCOLS.values()]
    found = []
    for name, table in PROTOCOLS.items():
        if is_built(table) and table not in wired:
            taken, steady = (
                float(utilization(table, fleet, wifi=wifi, window=span))
                for span in (window, math.inf)
            )
            start = float(drained(float(burst(table, fleet, wifi=wifi)), steady))
            found.append(Arrangement(name, taken, start, steady))
    return tuple(sorted(found, key=lambda one: (one.start, one.steady)))


def table_in_words(all_of_them: tuple[Arrangement, ...], width: int) -> list[str]:
    """Return a row each, in columns of equal width; a sentence each where these are too wide."""
    rows = [("", "startup takes", "then repeats take")]
    rows += [
        (
            one.name,
            words.duration(one.start) if math.isfinite(one.start) else "never done",
            words.percent(one.steady),
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
