"""The same fleet and channel with every measured configuration of every product."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

from discostorm import wording
from discostorm.model import utilization
from discostorm.protocols import PROTOCOLS
from discostorm_planner.aggregation_range import (
    AggregationRange,
    drain_time_range,
    finite_or_none,
    steady_range,
)
from discostorm_planner.changes import Setting
from discostorm_planner.remedy_rules import is_measured


@dataclass(frozen=True)
class ConfigurationLoad:
    """The load of a fleet with one measured configuration of a product."""

    #: Name of its table.
    name: str
    #: Share of the plan's window, with one frame in each exchange [1].
    utilization: float
    #: Drain time [s]; infinity if the channel never catches up.
    startup: AggregationRange
    #: Share of the channel that periodic traffic takes [1].
    steady_range: AggregationRange

    def to_dict(self) -> dict[str, Any]:
        """Return a dict for JSON, with None for a startup that never ends."""
        return {
            "protocol": self.name,
            "utilization": self.utilization,
            "fits": wording.below_capacity(self.utilization),
            "start_s": finite_or_none(self.startup.single),
            "steady": self.steady_range.single,
            "startup": self.startup.to_dict(),
        }


def compare_configurations(setting: Setting, window: float) -> tuple[ConfigurationLoad, ...]:
    """Compute every measured configuration, the one with the shortest startup first.

    Tables that products use only on wired networks are left out.
    """
    wired = {table.wired.key for table in PROTOCOLS.values() if table.wired}
    rows = []
    for name, table in PROTOCOLS.items():
        if is_measured(table) and table.key not in wired:
            configured = replace(setting, protocol=table)
            taken = utilization(table, setting.fleet, wifi=setting.wifi, window=window)
            startup = drain_time_range(configured)
            rows.append(ConfigurationLoad(name, float(taken), startup, steady_range(configured)))
    rows.sort(key=lambda r: (r.startup.single, r.startup.full, r.steady_range.single))
    return tuple(rows)
