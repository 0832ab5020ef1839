"""Ranges of utilization, airtime and drain time on a radio that aggregates frames.

Radios since 802.11n send the frames that wait for one receiver in one exchange. Their number
depends on the load, so the formulas are evaluated twice: with full A-MPDUs, and with one frame in
each exchange.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Literal

from discostorm import wording
from discostorm.drain_times import burst_drain_time
from discostorm.files import json_ready

#: Whether a load fits on the channel; see `AggregationRange.verdict`.
ChannelFit = Literal["fits", "may fit", "does not fit"]


@dataclass(frozen=True)
class AggregationRange:
    """A quantity computed with full A-MPDUs, and with one frame in each exchange."""

    full: float
    single: float

    @property
    def bounds(self) -> tuple[float, float]:
        """The smaller and the larger value: long frames can need more airtime in full A-MPDUs."""
        return min(self.full, self.single), max(self.full, self.single)

    @property
    def verdict(self) -> ChannelFit:
        """Whether this share of a channel fits: at both ends, at the better one, or at neither."""
        low, high = self.bounds
        if wording.below_capacity(high):
            return "fits"
        return "may fit" if wording.below_capacity(low) else "does not fit"

    @property
    def differs(self) -> bool:
        """Whether the two values differ."""
        return self.full != self.single

    def to_dict(self) -> dict[str, float | None]:
        """Return a dict for JSON, with infinity as None."""
        return {"full_ampdus": json_ready(self.full), "one_frame": json_ready(self.single)}


def combine(
    join: Callable[[Sequence[float]], float], ranges: Sequence[AggregationRange]
) -> AggregationRange:
    """Combine ranges at each end, for example by their sum."""
    return AggregationRange(join([r.full for r in ranges]), join([r.single for r in ranges]))


def drain_time_range(burst: AggregationRange, steady: AggregationRange) -> AggregationRange:
    """Return the drain time of a burst [s] alongside periodic traffic [1]; infinity if never."""
    full = burst_drain_time(burst.full, steady.full)
    single = burst_drain_time(burst.single, steady.single)
    return AggregationRange(float(full), float(single))
