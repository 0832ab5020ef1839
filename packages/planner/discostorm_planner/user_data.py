"""User data beside discovery: whether they fit, then and meanwhile, and what startup loses."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from discostorm import words
from discostorm.messages import DATA, PAPER_WINDOW
from discostorm.model import utilization
from discostorm.timeline import drained
from discostorm_planner.aggregation_range import (
    Span,
    Verdict,
    burst_of,
    repeated,
    span_of,
    startup,
)
from discostorm_planner.changes import Setting

_FITS: dict[Verdict, str] = {"fits": "fit", "may fit": "may fit", "does not fit": "do not fit"}


@dataclass(frozen=True)
class Beside:
    """What a fleet's data take of the channel, alone and together with discovery.

    Parameters
    ----------
    data : Span
        What the data take of the channel [1].
    after : Span
        The same and what discovery repeats [1]: whether the data fit once discovery is over.
    during : Span
        The same and all discovery of the plan's window [1]: whether they fit during startup.
    startup, alone : Span
        How long startup keeps the channel busy [s] if all data are sent from its begin on, and
        without them; infinity if it never ends. So long data wait at most, if no queue overflows.
        Robots send only to those that they have discovered, so that it is less.
    """

    data: Span
    after: Span
    during: Span
    startup: Span
    alone: Span

    def to_dict(self) -> dict[str, Any]:
        """Return it as what JSON can hold: infinity is None."""
        return {
            "utilization": self.data.to_dict(),
            "with_steady_discovery": self.after.to_dict(),
            "fits_after_startup": self.after.verdict,
            "with_discovery": self.during.to_dict(),
            "fits_during_startup": self.during.verdict,
            "startup": self.startup.to_dict(),
            "startup_without": self.alone.to_dict(),
        }

    def sentences(self, window: float) -> Iterator[str]:
        """Yield in words whether the data fit, once discovery is over and until then."""
        yield (
            f"Your data need {words.percents(*self.data.ends)} of the channel. With the periodic "
            f"traffic of discovery, that is {words.percents(*self.after.ends)}, so your data "
            f"{_FITS[self.after.verdict]} once discovery is complete."
        )
        if math.isfinite(window):
            low, high = (end * window for end in self.during.ends)
            time = "second" if window == PAPER_WINDOW else words.duration(window)
            yield (
                f"During startup, your data {_FITS[self.during.verdict]}: discovery and data "
                f"together need {words.durations(low, high)} of airtime in the first {time}."
            )
        if words.fits(self.after.full):
            yield (
                "If robots send all data from the beginning, startup keeps the channel busy for "
                f"{words.durations(*self.startup.ends)} instead of "
                f"{words.durations(*self.alone.ends)}, and no data wait longer. Real robots wait "
                "less, because they send only to robots that they have discovered. `discostorm "
                "simulate` shows when discovery is complete, and how late the data are."
            )
        else:
            yield (
                "The channel never has room for all data beside discovery. Send fewer samples, or "
                "send them to fewer hosts."
            )


def beside(setting: Setting, window: float) -> Beside | None:
    """Return what the data of a setting's fleet take, None if there are none."""
    if not setting.fleet.has_data:
        return None
    full, single = (
        float(utilization(setting.protocol, setting.fleet, wifi=wifi, phase=DATA))
        for wifi in (setting.full, setting.wifi)
    )
    data = Span(full, None, single)
    burst, after = burst_of(setting), _sum(data, repeated(setting))
    return Beside(
        data,
        after,
        _sum(data, span_of(setting, window)),
        Span(
            float(drained(burst.full, after.full)), None, float(drained(burst.single, after.single))
        ),
        startup(setting),
    )


def _sum(data: Span, discovery: Span) -> Span:
    """Return both; the data were not simulated."""
    return Span(data.full + discovery.full, None, data.single + discovery.single)
