"""User data: whether they fit alongside discovery, and how much they prolong startup."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from discostorm.messages import DATA
from discostorm.model import utilization
from discostorm_planner.aggregation_range import (
    AggregationRange,
    burst_range,
    combine,
    drain_time_range,
    drained_range,
    steady_range,
    utilization_range,
)
from discostorm_planner.changes import Setting


@dataclass(frozen=True)
class UserDataLoad:
    """Load of a fleet's user data, without and with discovery."""

    #: Share of the channel for the data alone [1].
    data: AggregationRange
    #: Share for data and periodic traffic [1]: decides whether the data fit after discovery.
    with_periodic: AggregationRange
    #: Share for data and all discovery in the plan's window [1]: decides about startup.
    with_discovery: AggregationRange
    #: Drain time with data from the beginning, and without data [s]; infinity if the channel
    #: never drains. An upper bound, because robots send data only to discovered processes.
    #: Without queue overflows, no sample waits longer.
    drain_time_with_data: AggregationRange
    drain_time_alone: AggregationRange

    def to_dict(self) -> dict[str, Any]:
        """Return a dict for JSON, with infinity as None."""
        return {
            "utilization": self.data.to_dict(),
            "with_steady_discovery": self.with_periodic.to_dict(),
            "fits_after_startup": self.with_periodic.verdict,
            "with_discovery": self.with_discovery.to_dict(),
            "fits_during_startup": self.with_discovery.verdict,
            "startup": self.drain_time_with_data.to_dict(),
            "startup_without": self.drain_time_alone.to_dict(),
        }


def user_data_load(setting: Setting, window: float) -> UserDataLoad | None:
    """Compute the load of a fleet's user data; None if the fleet sends no data."""
    if not setting.fleet.has_data:
        return None
    full, single = (
        float(utilization(setting.protocol, setting.fleet, wifi=wifi, phase=DATA))
        for wifi in (setting.full_ampdu_wifi, setting.wifi)
    )
    data = AggregationRange(full, single)
    burst, after = burst_range(setting), combine(sum, [data, steady_range(setting)])
    during = combine(sum, [data, utilization_range(setting, window)])
    return UserDataLoad(data, after, during, drained_range(burst, after), drain_time_range(setting))
