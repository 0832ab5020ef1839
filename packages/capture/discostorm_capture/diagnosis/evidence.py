"""The evidence that the rules of a diagnosis share: observations, and what follows from them."""

from dataclasses import replace

import numpy as np

from discostorm_capture.diagnosis import capture_gaps
from discostorm_capture.diagnosis.finding import LIMITS
from discostorm_capture.diagnosis.lifetimes import lifetimes, restart_chains
from discostorm_capture.diagnosis.observations import Observations
from discostorm_capture.diagnosis.pairs import Pair, answered_samples, find_scopes, min_answer_times


class Evidence:
    """Observations and everything that several rules derive from them."""

    def __init__(self, obs: Observations) -> None:
        self.obs = obs
        #: The processes that had announced their endpoints before the capture began.
        self.early_processes = capture_gaps.processes_before_capture(obs)
        #: Number of confirmed samples that the capture lacks, by sending and receiving host.
        self.missing_samples = capture_gaps.missing_samples(obs, self.early_processes)
        #: Hosts of which the capture has no message, with the number of answers sent to them.
        self.silent_hosts = capture_gaps.silent_hosts(obs)
        self.answered_samples = tuple(answered_samples(obs))
        self.min_answer_times = min_answer_times(obs, self.answered_samples)
        self.lifetimes = lifetimes(obs)
        #: Processes that said goodbye before a missing answer of theirs would count.
        self.brief_processes = {
            process
            for process, life in enumerate(self.lifetimes)
            if life.ending == "left" and life.last - life.first < LIMITS.timeout
        }
        self.restart_chains = restart_chains(obs, self.lifetimes)
        self.replaced_processes = {one for chain in self.restart_chains for one in chain[:-1]}
        self.scopes = tuple(
            replace(scope, pairs=tuple(map(self._with_unknown_time, scope.pairs)))
            for scope in find_scopes(obs)
        )
        #: Readable endpoints with the index and host of their process and the number of its scope.
        index = obs.processes.index.get_indexer(obs.endpoints["process"].array)
        ends = obs.endpoints.assign(index=index)[index >= 0].dropna(subset="topic")
        scopes = {one: number for number, of in enumerate(self.scopes) for one in of.members}
        hosts = obs.process_host[ends["index"]]
        self.endpoints = ends.assign(host=hosts, scope=ends["index"].map(scopes))
        self.all_pairs = [pair for scope in self.scopes for pair in scope.pairs]
        #: Pairs that were present together for long enough to complete; those of them that never
        #: did; and those that started shortly before the capture ended.
        self.expected_pairs, self.incomplete_pairs, self.pending_pairs = [], [], []
        for pair in self.all_pairs:
            stop, begin = self._common_lifetime(pair)
            if pair.complete_at != np.inf:
                self.expected_pairs.append(pair)
            elif stop - begin >= LIMITS.timeout:
                self.expected_pairs.append(pair)
                self.incomplete_pairs.append(pair)
            elif stop == obs.end and begin <= stop:
                self.pending_pairs.append(pair)
        #: When each of the expected pairs completed, if the capture shows it [s].
        times = [pair.complete_at for pair in self.expected_pairs]
        self.completion_times = [time for time in times if not np.isnan(time)]
        #: Processes that were replaced by another one, or left before they had to know any other.
        every, expected = (
            {process for pair in pairs for process in pair.processes}
            for pairs in (self.all_pairs, self.expected_pairs)
        )
        self.gone_processes = self.replaced_processes | every - expected

    def _with_unknown_time(self, pair: Pair) -> Pair:
        """Return a pair, with an unknown time if it completed before the capture began."""
        if pair.subject in self.early_processes and not pair.n_announced and pair.complete_at > 0:
            return replace(pair, complete_at=np.nan)
        return pair

    def _common_lifetime(self, pair: Pair) -> tuple[float, float]:
        """Return the end and begin of the time in which two processes were both present [s]."""
        stop, begin = self.obs.end, -np.inf
        for process in pair.processes:
            lifetime = self.lifetimes[process]
            ended = lifetime.ending or process in self.replaced_processes
            stop = min(stop, lifetime.last + (0.0 if ended else LIMITS.max_pause))
            begin = max(begin, lifetime.first)
        return stop, begin
