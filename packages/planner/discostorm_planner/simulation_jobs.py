"""Simulation jobs: several runs of a fleet, combined into one discovery time."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import islice
from statistics import median
from threading import Event
from typing import TYPE_CHECKING

import numpy as np
from numpy.random import SeedSequence
from numpy.typing import ArrayLike

from discostorm.fleet import Fleet
from discostorm_planner.changes import Setting
from discostorm_planner.discovery_time import MIN_PAIRS, RUNS, DiscoveryTime
from discostorm_planner.service_reply_wait import required_reply_wait

if TYPE_CHECKING:
    from discostorm_simulation.run import Setup

#: Time without progress after which a run ends, as a multiple of the longest message period [1].
MAX_IDLE_PERIODS = 20.0
#: Default target of the discovery time, and minimum simulated time after the last start [s].
WITHIN_S = 60.0
#: Number of runs if one run is long, estimated time from which a run is long [s], random seed.
RUNS_IF_LONG, LONG_RUN_S, SEED = 3, 1.0, 0
#: Maximum estimated computing time [s] and memory [MB] of a run.
MAX_RUN_SECONDS, MAX_RUN_MEGABYTES = 40.0, 500.0
#: Maximum number of processes of a fleet for which runs are set up and estimated [1].
MAX_SIMULATED_PROCESSES = 3000
#: Maximum memory of a long run, as a multiple of its estimate [1].
_MEMORY_GROWTH = 7.0
#: Share of the pairs of processes for which plans also state the time [1].
MOST_PAIRS_SHARE = 0.95
#: Prefixes of the causes of losses: at the robots, at the access point, on the air.
_LOSS_CAUSE_PREFIXES = ("host_", "ap_", "on_air")
#: Fields of a simulated radio that are times; `Job.slowed_by` stretches them.
_RADIO_TIME_FIELDS = (
    *("slot", "sifs", "aifs", "timeout", "eifs_extra", "ack", "block_ack", "bar", "addba"),
    *("basic_ack", "preamble", "symbol", "grid"),
)
TOO_LARGE = "the simulation would take too much time or memory"
#: Callback for progress: receives the finished and the total work, both estimated [s].
Progress = Callable[[float, float], None]


@dataclass(frozen=True)
class Job:
    """Runs of one setup that differ in their seeds only."""

    setup: Setup
    runs: int
    seconds: float
    megabytes: float

    @property
    def cost_s(self) -> float:
        """Estimated computing time of all runs [s]."""
        return self.runs * self.seconds

    @property
    def first_runs(self) -> int:
        """Number of runs after which it is decided whether there are more [1]."""
        return 1 if self.cost_s > LONG_RUN_S else self.runs

    @property
    def first_cost_s(self) -> float:
        """Estimated computing time of the first runs [s]."""
        return self.first_runs * self.seconds

    def slowed_by(self, times: float) -> Job:
        """Return the job on a channel where each frame and each wait takes ``times`` as long."""
        radio, kinds = self.setup.radio.copy(), self.setup.kinds_of_cells.copy()
        for records, names in ((radio, _RADIO_TIME_FIELDS), (kinds, ("time_up", "time_down"))):
            for name in names:
                records[name] = np.round(times * records[name])
        return replace(self, setup=replace(self.setup, radio=radio, kinds_of_cells=kinds))


@dataclass
class WorkMeter:
    """The finished and the total work of all jobs, to display progress."""

    progress: Progress | None
    total: float = 0.0
    done: float = 0.0

    def add(self, cost_s: float) -> None:
        """Add finished work [s], and report the progress."""
        self.done += cost_s
        if self.progress:
            self.progress(self.done, self.total)


def simulated_fleet(fleet: Fleet) -> tuple[Fleet, tuple[tuple[str, float, float], ...]]:
    """Return the fleet with whole numbers of endpoints, and the groups whose mean was rounded."""
    groups = tuple(group.with_integer_endpoints() for group in fleet.groups)
    pairs = zip(fleet.names, fleet.groups, groups, strict=True)
    means = ((name, float(own.endpoints), float(whole.endpoints)) for name, own, whole in pairs)
    rounded = tuple(row for row in means if not math.isclose(*row[1:], rel_tol=1e-9))
    return replace(fleet, groups=groups), rounded


def prepare_job(
    setting: Setting, until: float, window: float = 0.0, start: ArrayLike = 0.0
) -> Job | str:
    """Return the simulation job of a setting, or why the setting cannot be simulated.

    Its fleet is `simulated_fleet`. Hosts start at random within ``window`` [s], or at the times
    ``start`` [s].
    """
    if setting.fleet.processes() > MAX_SIMULATED_PROCESSES:
        return TOO_LARGE
    try:
        from discostorm_simulation import NoRecovery
        from discostorm_simulation.run import Scenario, set_up
        from discostorm_simulation.starts import uniform_start
    except ImportError as error:
        return str(error)
    scenario = Scenario(
        simulated_fleet(setting.fleet)[0],
        setting.protocol,
        setting.full_ampdu_wifi,
        until=until,
        give_up=MAX_IDLE_PERIODS * max(1.0, until / WITHIN_S),
        start=uniform_start(window) if window else start,
    )
    try:
        try:
            setup = set_up(scenario)
        except NoRecovery:
            setup = set_up(replace(scenario, recovery=False))
        seconds, megabytes = setup.estimate()
    except (ValueError, TypeError, MemoryError, OverflowError) as error:
        return str(error)
    if seconds > MAX_RUN_SECONDS or megabytes > MAX_RUN_MEGABYTES:
        return TOO_LARGE
    return Job(setup, RUNS_IF_LONG if seconds > LONG_RUN_S else RUNS, seconds, megabytes)


def simulate_jobs(
    jobs: Sequence[Job], work: WorkMeter
) -> Iterator[tuple[int, DiscoveryTime | str]]:
    """Simulate jobs in threads; yield each job's index, and its time or why it is unknown.

    A long job whose first run ends with less than `MIN_PAIRS` of the pairs has no other runs.
    """
    from discostorm_simulation._memory import available_megabytes
    from discostorm_simulation.run import run_in_threads

    if not jobs:
        return
    room = available_megabytes() / max(_MEMORY_GROWTH * max(job.megabytes for job in jobs), 1.0)
    workers = max(1, min(os.cpu_count() or 1, int(min(room, 1e6))))
    # The seeds of `discostorm.simulate(..., runs=runs, seed=SEED)`; each run spawns from its own.
    calls = [
        [partial(_run_summary, job.setup, seed) for seed in SeedSequence(SEED).spawn(job.runs)]
        for job in jobs
    ]
    runs: list[list[tuple[float, ...] | None]] = [[] for _ in jobs]
    left = dict(enumerate(jobs))
    for ends in ([job.first_runs for job in jobs], [job.runs for job in jobs]):
        todo = [call for place in left for call in calls[place][len(runs[place]) : ends[place]]]
        summaries = run_in_threads(todo, workers)
        for place, job in list(left.items()):
            own = runs[place]
            for summary in islice(summaries, ends[place] - len(own)):
                work.add(job.seconds)
                own.append(summary)
            first = own[0]
            promising = first and (math.isfinite(first[0]) or not first[2] < MIN_PAIRS)
            if len(own) == job.runs or not promising:
                del left[place]
                done = [run for run in own if run is not None]
                yield place, _combine_runs(job.setup, done) if len(done) == len(own) else TOO_LARGE
                work.add((job.runs - len(own)) * job.seconds)


def _run_summary(setup: Setup, seed: SeedSequence, stop: Event) -> tuple[float, ...] | None:
    """Simulate one run; return its time, leases, pairs and losses; None if out of memory."""
    from discostorm_simulation.run import simulate_run

    try:
        run = simulate_run(setup, seed, stop)
    except MemoryError:
        return None
    expected, pairs = max(run.counts["expected"], 1), run.pair_times
    lost = [
        sum(count for cause, count in run.counts.items() if cause.startswith(where)) / expected
        for where in _LOSS_CAUSE_PREFIXES
    ]
    if not pairs.size:
        return run.drain_time, 0.0, math.nan, math.inf, math.inf, run.lost, *lost
    done = float(np.isfinite(pairs).mean())
    most = float(pairs[math.ceil(MOST_PAIRS_SHARE * pairs.size) - 1])
    expired, wait = run.counts["expired"] / pairs.size, required_reply_wait(pairs)
    return run.convergence_time, expired, done, most, wait, run.lost, *lost


def _combine_runs(setup: Setup, runs: list[tuple[float, ...]]) -> DiscoveryTime | str:
    """Combine the results of runs into one discovery time, or say why it is unknown."""
    times, expired, pairs, most_pairs_s, waits, *shares = zip(*sorted(runs), strict=True)
    lost, *lost_by_place = map(median, shares)
    scenario = setup.scenario
    if math.isinf(median(times)) and not scenario.recovery:
        return f"repairs are not simulated with {scenario.protocol.name}"
    done = tuple(sorted(share for share in pairs if share == share))
    return DiscoveryTime(
        times=times,
        pairs_done=done,
        most_pairs_s=median(most_pairs_s),
        lost=lost,
        lost_by_place=tuple(lost_by_place),
        expired_per_pair=expired,
        simulated_seconds=scenario.until,
        repaired=scenario.recovery,
        reply_wait=max(waits),
    )
