"""User data: whether they fit with discovery, and by how much they prolong startup."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from discostorm.messages import DATA
from discostorm.model import utilization
from discostorm.timeline import drained
from discostorm_planner.aggregation_range import (
    AggregationRange,
    burst_range,
    combine,
    drain_time_range,
    steady_range,
    utilization_range,
)
from discostorm_planner.changes import Setting


@dataclass(frozen=True)
class UserDataLoad:
    """The share of the channel that a fleet's data take, without and with discovery.

    Parameters
    ----------
    data : AggregationRange
        Share of the data [1].
    after : AggregationRange
        Data and periodic traffic [1]: whether the data fit once discovery is complete.
    during : AggregationRange
        Data and all discovery of the plan's window [1]: whether the data fit during startup.
    startup, alone : AggregationRange
        Drain time with all data from the beginning, and without data [s]; infinity if it never
        ends. An upper bound, because robots send only to those that they have discovered. If no
        queue overflows, no data wait longer.
    """

    data: AggregationRange
    after: AggregationRange
    during: AggregationRange
    startup: AggregationRange
    alone: AggregationRange

    def to_dict(self) -> dict[str, Any]:
        """Return what JSON can hold: infinity is None."""
        return {
            "utilization": self.data.to_dict(),
            "with_steady_discovery": self.after.to_dict(),
            "fits_after_startup": self.after.verdict,
            "with_discovery": self.during.to_dict(),
            "fits_during_startup": self.during.verdict,
            "startup": self.startup.to_dict(),
            "startup_without": self.alone.to_dict(),
        }


def user_data_load(setting: Setting, window: float) -> UserDataLoad | None:
    """Compute the load of the data of a setting's fleet, None if it sends none."""
    if not setting.fleet.has_data:
        return None
    full, single = (
        float(utilization(setting.protocol, setting.fleet, wifi=wifi, phase=DATA))
        for wifi in (setting.full_wifi, setting.wifi)
    )
    data = AggregationRange(full, None, single)  # data were not simulated
    burst, after = burst_range(setting), combine(sum, [data, steady_range(setting)])
    return UserDataLoad(
        data,
        after,
        combine(sum, [data, utilization_range(setting, window)]),
        AggregationRange(
            float(drained(burst.full, after.full)), None, float(drained(burst.single, after.single))
        ),
        drain_time_range(setting),
    )
