"""Schedules: a message is sent once, at listed times, or periodically."""

from dataclasses import dataclass
from typing import Any

import numpy as np
import sympy as sp
from numpy.typing import ArrayLike, NDArray

from discostorm import _checks, wording
from discostorm._numeric import Value, int_if_integral

#: The window that the paper divides by [s] (Sec. IV-B).
PAPER_WINDOW = 1.0

#: A time that misses an instant by less than this counts as that instant [periods].
_ROUNDING = 1e-9

#: Maximum number of periods that `Schedule.times` lists.
_MAX_ROUNDS = 1e8


def checked_window(window: sp.Expr | ArrayLike) -> Any:
    """Return a window [s]: an expression unchanged, or numbers above zero."""
    if isinstance(window, sp.Expr) and window.free_symbols:
        return window
    window_s = np.inf if window is sp.oo else window
    return _checks.numbers("window", window_s, _checks.MIN_SECONDS, allow_inf=True)


@dataclass(frozen=True)
class Schedule:
    """Send times of a message: some times after the start, and then one per period.

    Parameters
    ----------
    starts : tuple of float
        Times after the start [s], at least 0 and in order; the first no later than the
        period, and no two further apart.
    period : float
        Time between two later ones [s], at least 1e-9; infinity if none comes later.

    Examples
    --------
    >>> Schedule((0, 1, 3, 7), period=8).sent([0, 6.9, 15, 24])
    array([1., 3., 5., 6.])
    """

    starts: tuple[float, ...]
    period: float = np.inf

    def __post_init__(self) -> None:
        if not np.iterable(self.starts):
            got = _checks.short_repr(self.starts)
            raise TypeError(f"starts must be a tuple of times in seconds; got {got}")
        given = tuple(self.starts)
        starts = tuple(_checks.number("starts", time, 0, _checks.MAX_SECONDS) for time in given)
        if not starts:
            raise ValueError("starts must hold at least one time in seconds; got none")
        object.__setattr__(self, "starts", starts)
        period = _checks.number("period", self.period, _checks.MIN_SECONDS, allow_inf=True)
        object.__setattr__(self, "period", period)
        gaps = np.diff((0.0, *self.starts))
        if np.any(gaps < 0) or np.any(gaps > self.period):
            rule = "sorted, with gaps (from zero on) of at most the period of"
            raise ValueError(f"starts must be {rule} {self.period:g} s; got {given}")

    def __str__(self) -> str:
        """Return the schedule in words: "at 0 and 0.1 s, then every 8 s"."""
        times = wording.join_words([f"{time:g}" for time in self.starts])
        if self.period < np.inf:
            return f"at {times} s, then every {self.period:g} s"
        return f"at {times} s" if len(self.starts) > 1 else f"once, at {times} s"

    @property
    def per_second(self) -> float:
        """The messages of a second in the long run [1/s]."""
        return 1 / self.period

    @property
    def burst_count(self) -> float:
        r"""The messages of startup beyond the periodic ones [1].

        With K times at startup, the last at :math:`t_K`, and period P, the number sent until t is
        at most :math:`K - t_K / P + t / P`. The part that does not grow with t is the burst.
        """
        return len(self.starts) - self.starts[-1] / self.period

    def mean(self, window: Any) -> Any:
        """Return the maximum of messages per second of the window [1/s]; see `burst_count`."""
        window_s = checked_window(window)
        if isinstance(window_s, float):
            return int_if_integral(self.burst_count / window_s + self.per_second)
        return int_if_integral(self.burst_count) / window_s + int_if_integral(self.per_second)

    def sent(self, time: ArrayLike) -> Value:
        """Return the number of messages from 0 up to and including a time [s]."""
        time_s = np.asarray(_checks.numbers("time", time, 0))
        with np.errstate(under="ignore"):
            later = time_s * (1 + _ROUNDING)
            rounds = np.floor((time_s - self.starts[-1]) / self.period + _ROUNDING)
        count = np.searchsorted(self.starts, later, side="right").astype(float)
        count += np.maximum(rounds, 0)
        return count if count.ndim else count.item()

    def times(self, until: float, since: float = 0.0) -> NDArray[np.float64]:
        """Return the times from `since` up to `until` at which the message is sent [s]."""
        last = self.starts[-1]
        since = _checks.number("since", since, 0)
        most = max(last, since) + _MAX_ROUNDS * self.period
        until = _checks.number("until", until, 0, most)
        before = max(0, int((since - last) / self.period - _ROUNDING))
        rounds = max(0, int((until - last) / self.period + _ROUNDING))
        later = last + self.period * np.arange(before + 1, rounds + 1) if rounds else np.empty(0)
        times = np.concatenate([np.array(self.starts, dtype=float), later])
        return times[(times >= since) & (times <= until * (1 + _ROUNDING))]


#: Sent at the start and never again.
ONCE = Schedule((0.0,))
