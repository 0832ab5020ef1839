"""Between which values an answer lies on a radio that aggregates.

A radio from 802.11n on sends the frames that wait for one receiver in one exchange. Their number
depends on the load, so the formulas have two ends: full A-MPDUs, and one frame in each exchange.
Ready-made robots were simulated between them (`stored_simulations`).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, Literal

from discostorm import wording
from discostorm.model import burst, utilization
from discostorm.timeline import drained
from discostorm.wifi import Wifi
from discostorm_planner.changes import Setting
from discostorm_planner.stored_simulations import interpolation_weight

#: Whether something fits; see `AggregationRange.verdict`.
Verdict = Literal["fits", "may fit", "does not fit"]


@dataclass(frozen=True)
class AggregationRange:
    """A number of a channel that aggregates: at both ends, and as simulated between them.

    Parameters
    ----------
    full : float
        With full A-MPDUs.
    simulated : float or None
        With A-MPDUs as full as in simulations of the burst; None if there are none.
    single : float
        With one frame in each exchange.
    """

    full: float
    simulated: float | None
    single: float

    @property
    def value(self) -> float:
        """The simulated value, else that of single frames."""
        return self.single if self.simulated is None else self.simulated

    @property
    def ends(self) -> tuple[float, float]:
        """The smaller and the larger end: frames too long to share one gain nothing when full."""
        return min(self.full, self.single), max(self.full, self.single)

    @property
    def verdict(self) -> Verdict:
        """Whether that share of a channel fits: at both ends, at the better one, or at none."""
        low, high = self.ends
        if wording.below_capacity(high):
            return "fits"
        return "may fit" if wording.below_capacity(low) else "does not fit"

    @property
    def differs(self) -> bool:
        """Whether its ends differ."""
        return self.full != self.single

    def to_dict(self) -> dict[str, float | None]:
        """Return what JSON can hold: infinity is None."""
        ends = {"full_ampdus": self.full, "simulated": self.simulated, "one_frame": self.single}
        return {name: finite_or_none(value) for name, value in ends.items()}


def finite_or_none(value: float | None) -> float | None:
    """Return a number as JSON can hold it."""
    return None if value is None or math.isinf(value) else value


def combine(
    join: Callable[[Sequence[float]], float], ranges: Sequence[AggregationRange]
) -> AggregationRange:
    """Join numbers, such as by their sum; simulated only where each of them is."""
    simulated = [part.simulated for part in ranges if part.simulated is not None]
    return AggregationRange(
        join([part.full for part in ranges]),
        join(simulated) if len(simulated) == len(ranges) else None,
        join([part.single for part in ranges]),
    )


def utilization_range(setting: Setting, window: float) -> AggregationRange:
    """Return the utilization of a setting [1]."""
    fleet, protocol = setting.fleet, setting.protocol
    return _interpolated(
        setting, lambda wifi: utilization(protocol, fleet, wifi=wifi, window=window)
    )


def burst_range(setting: Setting) -> AggregationRange:
    """Return the airtime of a setting's burst [s]."""
    return _interpolated(setting, lambda wifi: burst(setting.protocol, setting.fleet, wifi=wifi))


def steady_range(setting: Setting) -> AggregationRange:
    """Return the share of the channel that periodic traffic takes [1]."""
    if not setting.protocol.repeats:
        return AggregationRange(0.0, None, 0.0)
    return utilization_range(setting, math.inf)


def drain_time_range(setting: Setting) -> AggregationRange:
    """Return how long startup keeps the channel busy, without losses and collisions [s]."""
    start, steady, simulated = burst_range(setting), steady_range(setting), None
    if start.simulated is not None:
        simulated = float(drained(start.simulated, steady.simulated or 0.0))
    return AggregationRange(
        float(drained(start.full, steady.full)),
        simulated,
        float(drained(start.single, steady.single)),
    )


def _interpolated(setting: Setting, compute: Callable[[Wifi], Any]) -> AggregationRange:
    """Compute both ends, and interpolate between them as the burst was simulated."""
    full, single = float(compute(setting.full_wifi)), float(compute(setting.wifi))
    weight = interpolation_weight(setting.protocol, setting.fleet, setting.full_wifi)
    simulated = None if weight is None else full + weight * (single - full)
    return AggregationRange(full, simulated, single)
