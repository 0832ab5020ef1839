"""What every rule of the diagnosis reads: the observations, and what follows from them."""

from __future__ import annotations

from dataclasses import replace
from itertools import chain

import numpy as np

from discostorm_capture.diagnosis import capture_gaps
from discostorm_capture.diagnosis.lifetimes import lifetimes, restarts
from discostorm_capture.diagnosis.observations import Observations
from discostorm_capture.diagnosis.pairs import Pair, asked_samples, least_answer_times, scopes
from discostorm_capture.diagnosis.reachability import PATIENCE, RARE


class Evidence:
    """What a capture shows, each part computed once."""

    def __init__(self, obs: Observations) -> None:
        self.obs = obs
        #: The processes that had announced their endpoints before the capture began.
        self.began_late = capture_gaps.processes_before_capture(obs)
        #: How many samples of a host another one confirmed that the capture lacks.
        self.missing_samples = capture_gaps.missing_samples(obs, self.began_late)
        #: The hosts of which the capture shows nothing, with how many answers they got.
        self.silent_hosts = capture_gaps.silent_hosts(obs)
        self.asked = tuple(asked_samples(obs))
        self.least_answer_times = least_answer_times(obs, self.asked)
        self.lifetimes = lifetimes(obs)
        self.restarts = restarts(obs, self.lifetimes)
        self.scopes = tuple(
            replace(scope, pairs=tuple(map(self._without_unseen_time, scope.pairs)))
            for scope in scopes(obs)
        )
        self.all_pairs = [pair for scope in self.scopes for pair in scope.pairs]
        #: The pairs that were there together for so long that they ought to be complete; those
        #: that never completed; and those that began soon before the capture ends.
        self.pairs, self.incomplete, self.pending = [], [], []
        for pair in self.all_pairs:
            stop, begin = self._common_lifetime(pair)
            if pair.complete != np.inf:
                self.pairs.append(pair)
            elif stop - begin >= PATIENCE:
                self.pairs.append(pair)
                self.incomplete.append(pair)
            elif stop == obs.end and begin <= stop:
                self.pending.append(pair)
        #: When each of the pairs was complete, where the capture shows it [s].
        self.completions = [one.complete for one in self.pairs if not np.isnan(one.complete)]
        #: The processes that another one replaced, or that left before they knew any other one.
        ends = ({(p.subject, p.observer) for p in pairs} for pairs in (self.all_pairs, self.pairs))
        every, some = ({*chain.from_iterable(pairs)} for pairs in ends)
        self.gone = {process for one in self.restarts for process in one[:-1]} | every - some

    def _without_unseen_time(self, pair: Pair) -> Pair:
        """Return a pair, without a time if it completed before the capture began."""
        untold = pair.subject in self.began_late and not pair.sent and pair.complete > 0
        return replace(pair, complete=np.nan) if untold else pair

    def _common_lifetime(self, pair: Pair) -> tuple[float, float]:
        """Return until when and since when two processes were there together [s]."""
        replaced = {process for one in self.restarts for process in one[:-1]}
        stop, begin = self.obs.end, -np.inf
        for process in (pair.subject, pair.observer):
            lifetime = self.lifetimes[process]
            ended = lifetime.end or process in replaced
            stop = min(stop, lifetime.last + (0.0 if ended else RARE))
            begin = max(begin, lifetime.first)
        return stop, begin
