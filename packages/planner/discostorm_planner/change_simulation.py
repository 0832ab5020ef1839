"""Simulate the discovery time of a fleet, unchanged and after each change, with fixed seeds."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from discostorm.messages import Protocol
from discostorm_planner import remedy_rules
from discostorm_planner.changes import Setting
from discostorm_planner.discovery_time import RUNS, DiscoveryTime
from discostorm_planner.fleet_changes import compose
from discostorm_planner.remedy import Remedy
from discostorm_planner.simulation_jobs import (
    RUNS_IF_LONG,
    SEED,
    TOO_LARGE,
    WITHIN_S,
    Job,
    Progress,
    WorkMeter,
    prepare_job,
    simulate_jobs,
    simulated_fleet,
)

#: Maximum target [s], and maximum estimated computing time of the first runs of all changes [s].
MAX_TARGET_S, MAX_COST_S = 600.0, 30.0
#: Maximum numbers of single changes and of combinations that are simulated.
MAX_CHANGES, MAX_COMBINATIONS = 9, 3
#: Kinds of changes that are simulated even if they save no airtime.
ALWAYS_SIMULATED = ("staggered start", "discovery server")
#: Efforts that need another middleware on every robot, and those that need any other software.
MIDDLEWARE_EFFORTS = frozenset({"upgrade", "switch", "research"})
SOFTWARE_EFFORTS = MIDDLEWARE_EFFORTS | {"build"}
#: Maximum share of lost frames at which a time without repairs is still a useful bound [1].
MAX_BOUND_LOSS = 0.5
#: Share of lost frames above which a product's ``caution`` applies: repairs decide the time [1].
CAUTION_LOSS = 0.1


@dataclass(frozen=True)
class SimulatedChange:
    """A change with its discovery time, or why there is none."""

    #: Name of the change for ``--paste``.
    name: str
    remedy: Remedy
    time: DiscoveryTime | None = None
    #: Why the change was not simulated; empty if it was.
    reason: str = ""
    #: Seconds within which hosts start at random; 0 if all start together [s].
    start_window: float = 0.0
    #: Why simulations of the changed product may be wrong; empty if nothing is known.
    caution: str = ""
    #: Maximum ratio of times measured on an emulated cell to simulated ones, at least 1 [1].
    slowest: float = 1.0
    #: The smallest variant of the change that still suffices, if there is a smaller one.
    smallest: SimulatedChange | None = None

    def suffices(self, within: float) -> bool:
        """Return whether the startup then works, even if reality is as slow as we measured."""
        trusted = self.remedy.all_discover and not self.is_cautious
        return bool(trusted and self.time and self.time.works(within / self.slowest))

    @property
    def is_cautious(self) -> bool:
        """Whether so many messages are lost that simulations of the product may be wrong."""
        return bool(self.caution and self.time and self.time.lost > CAUTION_LOSS)

    def sort_key(self, within: float) -> tuple[Any, ...]:
        """Return the sort key: sufficient changes first, those with the least effort on top."""
        assert self.time is not None
        level = math.isinf(self.time.median) - self.suffices(within) - self.time.works(within)
        other = not SOFTWARE_EFFORTS.isdisjoint(self.remedy.efforts)
        ranks = (level, other, self.remedy.effort_rank, self.time.rank)
        return not self.remedy.all_discover, *ranks

    def to_dict(self, within: float, today: DiscoveryTime | None) -> dict[str, Any]:
        """Return a dict for JSON."""
        time = self.time
        return {
            "name": self.name,
            "what": self.remedy.what,
            "effort": self.remedy.effort_rank,
            "start_within_s": self.start_window or None,
            "suffices": self.suffices(within),
            "helps": bool(time and today and time.is_shorter_than(today)),
            "time": time.to_dict() if time else None,
            "not_simulated": self.reason or None,
            "enough": self.smallest.to_dict(within, today) if self.smallest else None,
        }


@dataclass(frozen=True)
class DiscoveryResult:
    """The simulated discovery time of a fleet, and of the fleet after each change."""

    #: The target [s].
    within: float
    #: Discovery time of the unchanged fleet.
    today: DiscoveryTime | None
    #: Why the unchanged fleet was not simulated; empty if it was.
    reason: str = ""
    #: The changes that were tried, the best advice first.
    changes: tuple[SimulatedChange, ...] = ()
    #: Groups whose mean number of endpoints was changed: name, mean, simulated mean.
    rounded: tuple[tuple[str, float, float], ...] = ()
    #: Whether all runs were done, and none was interrupted.
    complete: bool = True
    #: Why simulations of the product may be wrong, if many messages are lost; else empty.
    caution: str = ""
    #: Maximum ratio of times measured on an emulated cell to simulated ones [1].
    slowest: float = 1.0
    #: Largest number of hosts of one group with which the unchanged fleet meets its target:
    #: group, number, discovery time; None if unknown.
    hosts_in_time: tuple[str, int, DiscoveryTime] | None = None

    @property
    def works(self) -> bool:
        """Whether nine of ten runs meet the target without expired leases."""
        return self.today is not None and self.today.works(self.within)

    @property
    def surely_works(self) -> bool:
        """Whether the fleet works even if reality is as slow as measured, without a caution."""
        today, within = self.today, self.within / self.slowest
        return today is not None and today.works(within) and not self.caution

    @property
    def helpful(self) -> tuple[SimulatedChange, ...]:
        """The changes that shorten discovery by more than the scatter of runs, best advice first.

        If the unchanged fleet does not surely work, changes that suffice are listed, too.
        """
        today = self.today
        return tuple(
            change
            for change in self.changes
            if change.time
            and not change.time.is_lower_bound
            and change.remedy.all_discover
            and not self._is_no_better_than_part(change)
            and (
                (change.time.is_shorter_than(today) if today else change.time.median < math.inf)
                or (not self.surely_works and change.suffices(self.within))
            )
        )

    def _is_no_better_than_part(self, change: SimulatedChange) -> bool:
        """Whether a combination does not suffice, and a part of it is just as good."""
        if change.remedy.kind != "combination" or change.suffices(self.within):
            return False
        parts = (c for c in self.changes if set(c.remedy.steps) < set(change.remedy.steps))
        assert change.time is not None
        return any(part.time and part.time.rank <= change.time.rank for part in parts)

    @property
    def possibly_sufficient(self) -> tuple[SimulatedChange, ...]:
        """The changes that may suffice, although their repairs were not simulated."""
        timed = [(c, c.time) for c in self.changes if c.time and c.time.is_lower_bound]
        return tuple(c for c, t in timed if t.lost < MAX_BOUND_LOSS and t.median <= self.within)

    @property
    def sufficient(self) -> tuple[SimulatedChange, ...]:
        """The helpful changes after which the fleet works."""
        return tuple(c for c in self.helpful if c.suffices(self.within))

    @property
    def needs_no_other_software(self) -> bool:
        """Whether the fleet works, unchanged or after a change that needs no other software."""
        easy = (SOFTWARE_EFFORTS.isdisjoint(c.remedy.efforts) for c in self.sufficient)
        return self.works or any(easy)

    @property
    def is_sure(self) -> bool:
        """Whether the simulation can tell if the fleet works; without repairs it often cannot."""
        today = self.today
        unknown = today is None or (today.is_lower_bound and today.median <= self.within)
        return not unknown and self.works == self.surely_works

    def sort_key(self) -> tuple[Any, ...]:
        """Return the sort key by discovery time: lower bounds and unknown times last."""
        today = self.today
        return (False, today.is_lower_bound, today.rank) if today else (True,)

    def to_dict(self) -> dict[str, Any]:
        """Return a dict for JSON."""
        return {
            "within_s": self.within,
            "works": self.works if self.today else None,
            "sure": self.is_sure,
            "caution": self.caution or None,
            "today": self.today.to_dict() if self.today else None,
            "not_simulated": self.reason or None,
            "seed": SEED,
            "hosts_in_time": self.hosts_in_time
            and {"group": self.hosts_in_time[0], "hosts": self.hosts_in_time[1]},
            "changes": [change.to_dict(self.within, self.today) for change in self.changes],
        }


def simulate_changes(
    setting: Setting,
    remedies: Sequence[Remedy],
    combinations: Sequence[Remedy],
    within: float,
    *,
    staggered: Sequence[Remedy] = (),
    progress: Progress | None = None,
    report: Callable[[DiscoveryResult], object] | None = None,
    interruptible: bool = False,
) -> DiscoveryResult:
    """Simulate a fleet as it is, and the changes that the closed form ranks first.

    If no single change suffices, the best are simulated again with a staggered start (from
    ``staggered``); if none of these does, combinations. Equal arguments give equal results. If
    ``interruptible``, an interrupt ends the simulation with the results so far. ``report`` gets the
    answer without changes, as soon as the unchanged fleet is simulated.
    """
    job = prepare_job(setting, max(within, WITHIN_S))
    singles = [_prepare_change(setting, r, remedies, within) for r in _pick_remedies(remedies)]
    changes: list[SimulatedChange] = []
    rounded = simulated_fleet(setting.fleet)[1]
    answer = DiscoveryResult(within, None, job if isinstance(job, str) else "", rounded=rounded)
    work = _meter([job, *(own for _, own in singles)], progress)
    try:
        if isinstance(job, Job):
            work.add(0.0)
            ((_, today),) = simulate_jobs([job], work)
            answer = _add_unchanged_time(answer, setting.protocol, today)
            if report:
                report(answer)
        changes.extend(_simulate_prepared(singles, work))  # an interrupt leaves those that are done
        answer = replace(answer, changes=tuple(changes))
        kept = [r for r in staggered if MIDDLEWARE_EFFORTS.isdisjoint(r.efforts)]
        others = [r for r in staggered if r not in kept]
        best = {r.steps: r for r in reversed(combinations) if "research" not in r.efforts}
        first = [r for r in combinations if r is best.get(r.steps)][:MAX_COMBINATIONS]
        for joined in (_pick_closest(changes, kept), _pick_closest(changes, others), first):
            if not (answer.surely_works or answer.sufficient):
                jobs = [_prepare_change(setting, r, joined, within) for r in joined]
                changes.extend(_simulate_prepared(jobs, work))
                answer = replace(answer, changes=tuple(changes))
        if not answer.surely_works:
            changes = [_add_process_count(setting, c, within, work) for c in changes]
            answer = replace(answer, changes=tuple(changes))
        if answer.today and not answer.needs_no_other_software:
            answer = replace(answer, hosts_in_time=_max_hosts_in_time(setting, answer, work))
    except KeyboardInterrupt:
        if not interruptible:
            raise
        answer = replace(answer, complete=False)
    timed = sorted((c for c in changes if c.time), key=lambda c: c.sort_key(within))
    return replace(answer, changes=(*timed, *(c for c in changes if not c.time)))


def simulate_unchanged(
    settings: Sequence[Setting], within: float, *, progress: Progress | None = None
) -> list[DiscoveryResult]:
    """Simulate unchanged settings, the shortest runs first, within `MAX_COST_S`.

    An interrupt ends the simulation with the results so far.
    """
    rounded = (simulated_fleet(setting.fleet)[1] for setting in settings)
    found = [DiscoveryResult(within, None, "interrupted", (), r, complete=False) for r in rounded]
    jobs = [prepare_job(setting, max(within, WITHIN_S)) for setting in settings]
    work = _meter(jobs, progress)
    with suppress(KeyboardInterrupt):
        work.add(0.0)
        for place, time in _simulate_affordable(jobs, work):
            known = replace(found[place], reason="", complete=True)
            found[place] = _add_unchanged_time(known, settings[place].protocol, time)
    return found


def simulate_late_join(setting: Setting, today: DiscoveryTime) -> DiscoveryTime | None:
    """Simulate the discovery time of a robot that starts after all others have finished [s].

    The robot is one with the most processes. None if the others do not finish, or without repairs.
    """
    begin = math.ceil(today.times[-1]) if math.isfinite(today.times[-1]) else 0
    groups = setting.fleet.groups
    robots = [group.processes * (not group.wired) for group in groups]
    ends = np.cumsum([int(group.hosts) for group in groups])
    starts = np.zeros(ends[-1])
    starts[ends[np.argmax(robots)] - 1] = begin
    job = prepare_job(setting, today.simulated_seconds, start=starts)
    if not begin or not today.repaired or isinstance(job, str):
        return None
    ((_, found),) = simulate_jobs([job], WorkMeter(None))
    if isinstance(found, str):
        return None
    return replace(found, times=tuple(time - begin for time in found.times))


def _add_unchanged_time(
    answer: DiscoveryResult, protocol: Protocol, today: DiscoveryTime | str
) -> DiscoveryResult:
    """Add the discovery time of the unchanged fleet, with a caution if many messages are lost."""
    if isinstance(today, str):
        return replace(answer, reason=today)
    caution = remedy_rules.simulation_caution(protocol) if today.lost > CAUTION_LOSS else ""
    slowest = float(remedy_rules.time_ratios(protocol)["high"])
    return replace(answer, today=today, caution=caution, slowest=slowest)


def paste_name(remedy: Remedy, remedies: Sequence[Remedy]) -> str:
    """Return the name of a change for ``--paste``: its kinds, unless a better change has them."""
    kinds = " + ".join(step for step in remedy.steps if step != "middleware") or remedy.kind
    first = next((r for r in remedies if r.steps == remedy.steps), remedy)
    return kinds if first is remedy else remedy.what


def remedy_start_window(remedy: Remedy, within: float) -> float:
    """Return the window for random starts, in whole seconds [s]; 0 if all hosts start together."""
    if "staggered start" not in remedy.steps:
        return 0.0
    return float(max(1, math.ceil(min(remedy.start_window, within / 2))))


def _pick_remedies(remedies: Sequence[Remedy]) -> list[Remedy]:
    """Return the best remedies of each kind and product, at most `MAX_CHANGES` and all splits."""
    first: dict[str | None, Remedy] = {}
    for remedy in remedies:
        helps = remedy.saved >= remedy_rules.MIN_SAVING or remedy.kind in ALWAYS_SIMULATED
        if helps and "research" not in remedy.efforts:
            product = remedy_rules.product_of(remedy.protocol)
            first.setdefault(product if "middleware" in remedy.steps else remedy.kind, remedy)
    whole = [remedy for remedy in first.values() if remedy.all_discover]
    whole.sort(key=lambda remedy: remedy.kind != "staggered start")
    return whole[:MAX_CHANGES] + [r for r in first.values() if not r.all_discover]


def _pick_closest(changes: Sequence[SimulatedChange], staggered: Sequence[Remedy]) -> list[Remedy]:
    """Return the staggered changes whose change alone comes closest to the target in its runs."""
    ranks = {(c.remedy.steps, c.remedy.protocol): c.time.rank for c in changes if c.time}
    known = [r for r in staggered if (r.steps[:-1], r.protocol) in ranks]
    known.sort(key=lambda r: ranks[r.steps[:-1], r.protocol])
    return known[:MAX_COMBINATIONS]


def _prepare_change(
    setting: Setting, remedy: Remedy, remedies: Sequence[Remedy], within: float
) -> tuple[SimulatedChange, Job | str]:
    """Return a change with its simulation job, or with the reason why it is not simulated."""
    changed = replace(setting, protocol=remedy.protocol, wifi=remedy.wifi)
    fleets = sorted(remedy.fleets, key=lambda fleet: -float(fleet.processes()))
    parts = [replace(changed, fleet=fleet) for fleet in fleets]
    window = remedy_start_window(remedy, within)
    job = prepare_job(parts[0], max(within, WITHIN_S), window)
    if "domains" in remedy.steps and isinstance(job, Job):
        # The domains share the channel, so in each domain everything takes longer by the share of
        # the others.
        own, *others = (part.burst_range.full for part in parts)
        job = job.slowed_by(1 + sum(others) / own if own else 1.0)
    # A table that a change creates has no key. If its product is today's, its release is, too.
    table, today = remedy.protocol, setting.protocol
    with_server = remedy_rules.uses_server_of(table, today)
    made_of_today = with_server or (not table.key and table.product == today.product)
    table = today if made_of_today else table
    caution = "" if with_server else remedy_rules.simulation_caution(table)
    slowest = max(1.0, float(remedy_rules.time_ratios(table, with_server)["high"]))
    name = paste_name(remedy, remedies)
    return SimulatedChange(name, remedy, None, "", window, caution, slowest), job


def _add_process_count(
    setting: Setting, change: SimulatedChange, within: float, work: WorkMeter
) -> SimulatedChange:
    """Add the variant that composes into the most processes per host that still suffice."""
    composed = {"processes"} <= {*change.remedy.steps} <= {"processes", "staggered start"}
    if not composed or not change.suffices(within):
        return change

    def into(count: int) -> Remedy:
        what = change.remedy.what.replace(" into 1", f" into {count} or fewer")
        return replace(change.remedy, what=what, fleets=(compose(setting.fleet, count),))

    found = _bisect_largest(
        1,
        max(int(group.processes) for group in setting.fleet.groups),
        lambda count: _prepare_change(setting, into(count), [], within)[1],
        lambda time: replace(change, time=time).suffices(within),
        work,
    )
    if found is None:
        return change
    enough, time = found
    return replace(change, smallest=replace(change, remedy=into(enough), time=time))


def _max_hosts_in_time(
    setting: Setting, answer: DiscoveryResult, work: WorkMeter
) -> tuple[str, int, DiscoveryTime] | None:
    """Return how many hosts of the largest group meet the target alongside the other groups."""
    fleet, wireless = setting.fleet, [g for g in setting.fleet.groups if not g.wired]
    largest = max(wireless, key=lambda group: float(group.hosts * group.processes))
    place = fleet.groups.index(largest)

    def job(count: int) -> Job | str:
        groups = [*fleet.groups]
        groups[place] = replace(largest, hosts=count)
        smaller = replace(setting, fleet=replace(fleet, groups=tuple(groups)))
        return prepare_job(smaller, max(answer.within, WITHIN_S))

    found = _bisect_largest(
        1 if len(fleet.groups) == 1 else 0,  # no host discovers itself
        int(largest.hosts),
        job,
        lambda time: _add_unchanged_time(answer, setting.protocol, time).surely_works,
        work,
    )
    return found and (largest.name, *found)


def _bisect_largest(
    low: int,
    high: int,
    job: Callable[[int], Job | str],
    suffices: Callable[[DiscoveryTime], bool],
    work: WorkMeter,
) -> tuple[int, DiscoveryTime] | None:
    """Find the largest sufficient number between ``low`` and ``high`` by bisection, if any."""

    def time_of(count: int, runs: int) -> DiscoveryTime | None:
        own = job(count)
        if not isinstance(own, Job) or own.cost_s > MAX_COST_S:
            return None
        own = replace(own, runs=min(runs, own.runs))
        work.total += own.cost_s
        ((_, time),) = simulate_jobs([own], work)
        return time if not isinstance(time, str) and suffices(time) else None

    least = low
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (middle, high) if time_of(middle, RUNS_IF_LONG) else (low, middle)
    for count in range(low, least, -1):
        if time := time_of(count, RUNS):
            return count, time
    return None


def _meter(jobs: Sequence[Job | str], progress: Progress | None) -> WorkMeter:
    """Return a meter of the work of all jobs."""
    return WorkMeter(progress, sum(job.cost_s for job in jobs if isinstance(job, Job)))


def _simulate_prepared(
    prepared: Sequence[tuple[SimulatedChange, Job | str]], work: WorkMeter
) -> Iterator[SimulatedChange]:
    """Simulate changes; yield each that is done, or that is not simulated."""
    for place, time in _simulate_affordable([job for _, job in prepared], work):
        known = {"reason": time} if isinstance(time, str) else {"time": time}
        yield replace(prepared[place][0], **known)


def _simulate_affordable(
    jobs: Sequence[Job | str], work: WorkMeter
) -> Iterator[tuple[int, DiscoveryTime | str]]:
    """Simulate jobs, the shortest first, up to `MAX_COST_S`; yield as `simulate_jobs` does."""
    left, chosen = MAX_COST_S, dict[int, Job]()
    yield from ((place, job) for place, job in enumerate(jobs) if isinstance(job, str))
    able = [(place, job) for place, job in enumerate(jobs) if isinstance(job, Job)]
    for place, job in sorted(able, key=lambda item: item[1].first_cost_s):
        left -= job.first_cost_s
        if left < 0:
            yield place, TOO_LARGE
            work.add(job.cost_s)
        else:
            chosen[place] = job
    places = list(chosen)
    for number, time in simulate_jobs(list(chosen.values()), work):
        yield places[number], time
