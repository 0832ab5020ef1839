"""What every rule of the diagnosis reads: the observations, and what follows from them."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from discostorm_capture.diagnosis import gaps
from discostorm_capture.diagnosis.lifetimes import Lifetime, lifetimes, restarts
from discostorm_capture.diagnosis.observations import Observations
from discostorm_capture.diagnosis.pairs import Pair
from discostorm_capture.diagnosis.reachability import PATIENCE, RARE
from discostorm_capture.diagnosis.scopes import DiscoveryScope, scopes


@dataclass(frozen=True)
class Evidence:
    """What a capture shows, each part computed once."""

    obs: Observations

    @cached_property
    def began_late(self) -> set[int]:
        """The processes that had announced their endpoints before the capture began."""
        return gaps.began_late(self.obs)

    @cached_property
    def missing_samples(self) -> dict[tuple[str, str], int]:
        """How many samples of a host another one confirmed that the capture lacks."""
        return gaps.missing_samples(self.obs, self.began_late)

    @cached_property
    def silent_hosts(self) -> dict[str, int]:
        """The hosts of which the capture shows nothing, with how many answers they got."""
        return gaps.silent_hosts(self.obs)

    @cached_property
    def lifetimes(self) -> list[Lifetime]:
        """The lifetime of each process."""
        return lifetimes(self.obs)

    @cached_property
    def restarts(self) -> dict[str, list[int]]:
        """By host, the processes that follow each other."""
        return restarts(self.obs, self.lifetimes)

    @cached_property
    def scopes(self) -> tuple[DiscoveryScope, ...]:
        """Who ought to know whom; pairs have no time if it is from before the capture."""
        return tuple(
            replace(scope, pairs=tuple(map(self._as_shown, scope.pairs)))
            for scope in scopes(self.obs)
        )

    def _as_shown(self, pair: Pair) -> Pair:
        untold = pair.subject in self.began_late and not pair.sent and pair.complete > 0
        return replace(pair, complete=np.nan) if untold else pair

    @cached_property
    def all_pairs(self) -> list[Pair]:
        """The pairs of all scopes."""
        return [pair for scope in self.scopes for pair in scope.pairs]

    @cached_property
    def pairs(self) -> list[Pair]:
        """The pairs that were there together for so long that they ought to be complete."""
        return [
            pair
            for pair in self.all_pairs
            if pair.complete != np.inf or np.subtract(*self._together(pair)) >= PATIENCE
        ]

    @cached_property
    def incomplete(self) -> list[Pair]:
        """Those of the pairs that never completed."""
        return [pair for pair in self.pairs if pair.complete == np.inf]

    @cached_property
    def pending(self) -> list[Pair]:
        """The pairs that are not complete when the capture ends, soon after they began."""
        found = []
        for pair in self.all_pairs:
            stop, begin = self._together(pair)
            if pair.complete == np.inf and stop == self.obs.end and 0 <= stop - begin < PATIENCE:
                found.append(pair)
        return found

    def _together(self, pair: Pair) -> tuple[float, float]:
        """Return until when and since when two processes were there together [s]."""
        replaced = {process for chain in self.restarts.values() for process in chain[:-1]}
        stop, begin = self.obs.end, -np.inf
        for process in (pair.subject, pair.observer):
            lifetime = self.lifetimes[process]
            ended = lifetime.end or process in replaced
            stop = min(stop, lifetime.last + (0.0 if ended else RARE))
            begin = max(begin, lifetime.first)
        return stop, begin
