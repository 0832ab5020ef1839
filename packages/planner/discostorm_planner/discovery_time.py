"""The discovery time of one fleet, in several simulated runs."""

from __future__ import annotations

import math
from dataclasses import dataclass
from statistics import median
from typing import Any

from discostorm.files import json_ready

#: Usual number of runs of a fleet [1].
RUNS = 10
#: Keys of the sentences on losses at the robots, at the access point, and on the air.
_LOSS_KEYS = ("robots lose", "access point loses", "air loses")
#: Expired leases per pair from which they count as a cause of slow discovery [1].
MIN_EXPIRED_PER_PAIR = 0.05
#: Minimum relative gain of time that is worth mentioning [1].
MIN_RELATIVE_GAIN = 0.2
#: Minimum share of completed pairs for which an insufficient change is named [1].
MIN_PAIRS = 0.5


@dataclass(frozen=True)
class DiscoveryTime:
    """When discovery is complete, in several simulated runs of one fleet."""

    #: Time of each run until every process knows every endpoint that it should, ascending [s];
    #: infinity if the run ended earlier. Without repairs, the time until the channel goes idle.
    times: tuple[float, ...]
    #: Share of the pairs of processes that had completed discovery at the end of a run, ascending
    #: [1].
    pairs_done: tuple[float, ...]
    #: Median time until 95% of the pairs had completed discovery [s].
    most_pairs_s: float
    #: Median share of lost frames [1].
    lost: float
    #: Median shares of frames lost in the robots' queues, in the access point's queue, and on the
    #: air [1].
    lost_by_place: tuple[float, ...]
    #: Expired leases of running processes per pair of processes, for each run [1]; in the order of
    #: ``times``.
    expired_per_pair: tuple[float, ...]
    #: Maximum simulated time after the last start [s].
    simulated_seconds: float
    #: Whether the simulation repaired losses as the middleware does.
    repaired: bool
    #: How long servers must wait for their clients' reply readers, in the slowest run [s].
    reply_wait: float = math.inf

    @property
    def median(self) -> float:
        """Discovery time of the median run [s]."""
        return median(self.times)

    @property
    def median_interval(self) -> tuple[float, float]:
        """Confidence interval of the median [s]: 2nd to 9th of ten runs (98%), or all of fewer."""
        cut = int(len(self.times) >= RUNS)
        return self.times[cut], self.times[-1 - cut]

    @property
    def nine_of_ten(self) -> float:
        """Time within which nine of ten runs complete discovery [s]."""
        return self.times[math.ceil(0.9 * len(self.times)) - 1]

    @property
    def nine_of_ten_unexpired(self) -> float:
        """Time within which nine of ten runs complete discovery without an expired lease [s]."""
        runs = zip(self.times, self.expired_per_pair, strict=True)
        good = sorted(math.inf if expired else time for time, expired in runs)
        return good[math.ceil(0.9 * len(good)) - 1]

    @property
    def rank(self) -> tuple[float, ...]:
        """Sort key: the shortest median first; without a median, the most completed pairs first."""
        return self.median, self.nine_of_ten, -median(self.pairs_done or (0.0,))

    @property
    def is_lower_bound(self) -> bool:
        """Whether repairs, which were not simulated, would prolong discovery."""
        return not self.repaired and self.lost > 0

    def works(self, within: float) -> bool:
        """Return whether nine of ten runs complete within a time [s] without expired leases."""
        return self.nine_of_ten_unexpired <= within and not self.is_lower_bound

    @property
    def expired_lease_runs(self) -> int:
        """Number of complete runs in which a lease of a running process expires [1]."""
        runs = zip(self.times, self.expired_per_pair, strict=True)
        return sum(time < math.inf and expired > 0 for time, expired in runs)

    def is_shorter_than(self, other: DiscoveryTime) -> bool:
        """Return whether the median is `MIN_RELATIVE_GAIN` shorter and the intervals are disjoint.

        If neither completes, the one with more completed pairs counts as shorter.
        """
        if math.isinf(self.median):
            known = self.pairs_done and other.pairs_done and math.isinf(other.median)
            return bool(known and self.pairs_done[0] > other.pairs_done[-1])
        low, clearly = other.median_interval[0], (1 - MIN_RELATIVE_GAIN) * other.median
        return math.isinf(low) or (self.median_interval[1] < low and self.median < clearly)

    def slowdown_causes(self, steady: float) -> list[str]:
        """Return what delays or prevents the end of startup, as keys of sentences."""
        if steady >= 1:
            return ["periodic traffic fills"]
        most = max(self.lost_by_place)
        losses = [_LOSS_KEYS[self.lost_by_place.index(most)]] if most else []
        forgetful = not self.expired_lease_runs and median(self.expired_per_pair)
        return losses + ["leases end"] * (forgetful > MIN_EXPIRED_PER_PAIR)

    def to_dict(self) -> dict[str, Any]:
        """Return a dict for JSON, with infinity as None."""
        low, high = self.median_interval
        found = {
            "median_s": self.median,
            "low_s": low,
            "high_s": high,
            "nine_of_ten_s": self.nine_of_ten,
            "most_pairs_s": self.most_pairs_s,
            "times_s": self.times,
            "pairs_done": self.pairs_done,
            "lost": self.lost,
            "expired_for_each_pair": median(self.expired_per_pair),
            "runs_with_expired_leases": self.expired_lease_runs,
            "simulated_s": self.simulated_seconds,
            "repairs_simulated": self.repaired,
        }
        return dict(json_ready(found))
