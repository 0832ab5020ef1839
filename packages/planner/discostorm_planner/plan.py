"""Plan a fleet: compute each change alone, and combine the best changes."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import combinations
from typing import Any, Literal

from discostorm import _checks, wording
from discostorm.fleet import COUNTS, MIN_COUNTS, Fleet, as_fleet
from discostorm.lookup import AnyProtocol, AnyWifi, as_protocol, as_wifi
from discostorm.messages import PAPER_WINDOW
from discostorm.model import message_costs, utilization_without_each_group
from discostorm.prediction_error import error_band
from discostorm.protocols import DDS
from discostorm.wifi import PAPER
from discostorm.wifi.radio import aggregation_bounds
from discostorm_planner import further_loads
from discostorm_planner.aggregation_range import combine, drain_time_range
from discostorm_planner.change_simulation import MAX_TARGET_S
from discostorm_planner.changes import SLOTS, Change, Setting
from discostorm_planner.fleet_changes import fleet_changes, group_suffix, split_changes
from discostorm_planner.protocol_changes import protocol_changes, session_setup_note
from discostorm_planner.radio_changes import radio_changes
from discostorm_planner.remedy import Remedy
from discostorm_planner.remedy_rules import MIN_SAVING, inapplicable_remedies, is_gerund, rule_for
from discostorm_planner.result import Plan, Share
from discostorm_planner.simulation_jobs import WITHIN_S

#: Maximum number of groups: the time to compute their shares grows with the square.
MAX_GROUPS = 1000
#: Maximum numbers of combinations in a plan, of tables to combine, and of steps in a combination.
_MAX_COMBINATIONS, _MAX_COMBINED_TABLES, _MAX_STEPS = 5, 3, 3
#: The change of the start times, which can be added to others.
STAGGERED_START = Change("staggered start", "starting one after the other", "time")


def plan(
    fleet: Fleet,
    protocol: AnyProtocol = DDS,
    wifi: AnyWifi = PAPER,
    *,
    window: float = PAPER_WINDOW,
    within: float | None = None,
) -> Plan:
    """Compute what discovery costs a fleet, what dominates, and what would help.

    Each remedy changes one thing and leaves the rest. To combine changes yourself, plan again with
    the fleet, protocol and wifi of a `Remedy`.

    Parameters
    ----------
    fleet : Fleet
        At most 1,000 groups of whole hosts and processes. Fleet files and robots share endpoints
        that ROS 2 shares; `Fleet.swarm` and a `HostGroup` of plain numbers share none. Leaving out
        parameter services saves 12 endpoints a node; without `HostGroup.nodes`, each process with
        at least 12 endpoints is assumed to have one node.
    protocol : Protocol or str, optional
        One of `PROTOCOLS`, its name, or a table of your own. Its `family`, `product`, `basis` and
        `key` decide which remedies there are, never its name.
    wifi : Wifi, Radio or str, optional
        The channel; the paper's if left out. Changes of its radio (`Wifi.radio`) are compared by
        the standard's timing, also on the paper's channel. From 802.11n on radios aggregate: the
        formulas are evaluated at two ends: full A-MPDUs (64 frames, or the limit of the radio) and
        one frame in each exchange. Airtime savings assume one frame in each exchange. `PAPER` does
        not aggregate.
    window : float, optional
        Averaging time of the explanations [s], above 0; infinity for the steady state.
    within : float, optional
        Target of the discovery time [s], above 0 and at most 600; `Fleet.within`, else 60, if left
        out. A startup works if nine of ten simulated runs complete within it.

    Returns
    -------
    Plan
        With text (`Plan.advice`), tables and JSON. The first use of text, JSON or
        `Plan.discovery` simulates the fleet.

    Raises
    ------
    ValueError
        If a count, the number of groups or the window is out of range, or hosts or processes are
        not whole.
    TypeError
        If the fleet holds arrays or symbols, or an argument has another type.

    References
    ----------
    ``data/fleets/parameter_services.csv`` and ``data/vendors/remedies.csv``, with their sources.

    Examples
    --------
    >>> import discostorm as ds
    >>> small = ds.plan(ds.Fleet.swarm(3, 2, 10), ds.PROTOCOLS["Fast DDS"], within=10)
    >>> small.discovery.works, small.discovery.today.median < 10
    (True, True)
    >>> plan = ds.plan(ds.Fleet.swarm(hosts=3, processes=8, endpoints=5), ds.DDS)
    >>> plan.remedies[0].sentence().partition(". ")[0]
    'a Discovery Server cuts 7.77 s to 0.25 s (97%)'
    >>> [found.sentence() for found in plan.remedies if found.kind == "processes"]
    ['composing 8 processes into 1 cuts 1.38 s to 0.11 s (92%). The fleet then fits']
    """
    _checks.instance("fleet", fleet, Fleet)
    protocol, wifi = as_protocol(protocol), as_wifi(wifi)
    seconds = _checks.number("window", window, _checks.MIN_SECONDS, allow_inf=True)
    given = next((time for time in (within, fleet.within) if time is not None), WITHIN_S)
    target = _checks.number("within", given, 0, MAX_TARGET_S, exclusive_min=True)
    if fleet.cells:
        raise ValueError(
            "fleet must have no cells, as the explanations cover one access point; use "
            "discostorm_planner.multi_cell_plan.plan_cells or the command plan"
        )
    as_fleet(fleet, None, None)  # raises if there are symbols
    if len(fleet.groups) > MAX_GROUPS:
        raise ValueError(
            f"a plan takes at most {MAX_GROUPS:,} groups; got {len(fleet.groups):,}. Put "
            "identical hosts into one group"
        )
    for group in fleet.groups:
        _checks.require_scalars(zip(COUNTS, group.counts(), strict=True))
        for name in ("hosts", "processes"):
            _checks.integer(f"{name}{group_suffix(group)}", getattr(group, name), MIN_COUNTS[name])

    full, single = aggregation_bounds(wifi)
    ampdu_frames = full.aggregation.mpdus if full != single and full.aggregation else 1
    base = Setting(fleet, protocol, single, ampdu_frames)
    changes = tuple(candidate_changes(base))
    remedies = {
        step: _compute_remedy(base, [step], seconds) for step in changes if isinstance(step, Change)
    }
    staggered = tuple(_with_staggered_start(base, remedies, seconds))
    steady, reasons = base.steady_range, [reason for reason in changes if isinstance(reason, str)]
    if not wording.below_capacity(steady.full):
        needs = f"the periodic traffic alone needs {wording.percent(steady.full)} of the channel"
        del remedies[STAGGERED_START]
        reasons.insert(0, f"{STAGGERED_START.what}: {needs}, so no window is long enough")
    best_sets = _best_sets(base, remedies, seconds)
    combined = [_compute_remedy(base, steps, seconds) for steps in best_sets]
    captured, key = protocol.captured, protocol.key
    return Plan(
        fleet=fleet,
        protocol=protocol,
        wifi=single,
        window=seconds,
        utilization_range=base.utilization_range(seconds),
        steady_range=steady,
        startup=base.drain_time_range,
        shares=tuple(_airtime_shares(base, seconds)),
        remedies=tuple(sorted(remedies.values(), key=_remedy_sort_key)),
        combinations=tuple(sorted(combined, key=_remedy_sort_key)),
        staggered=staggered,
        not_applicable=(*reasons, *inapplicable_remedies(protocol)),
        configurations=further_loads.compare_configurations(base, seconds),
        reboot=further_loads.reboot_airtime(base),
        band=error_band(key, fleet, captured) if key and captured else None,
        data=further_loads.user_data_load(base, seconds),
        within=target,
        ampdu_frames=ampdu_frames,
    )


def candidate_changes(base: Setting) -> Iterator[Change | str]:
    """Yield each change to try, or the reason why a change does not apply. Add new changes here."""
    yield from fleet_changes(base.fleet)
    yield from protocol_changes(base.protocol, base.fleet.ros)
    yield from radio_changes(base.wifi)
    yield from split_changes(base.fleet, base.protocol)
    yield STAGGERED_START


def _compute_remedy(base: Setting, steps: Sequence[Change], window: float) -> Remedy:
    """Return the remedy that makes these changes together, with utilization before and after."""
    old, new = base.baseline_of(steps), base.with_changes(steps)
    fleets = next((step.parts for step in steps if step.parts), (new.fleet,))
    join = max if any(step.kind == "channels" for step in steps) else math.fsum
    parts = [replace(new, fleet=fleet) for fleet in fleets]
    before = old.utilization_range(window)
    after = combine(join, [part.utilization_range(window) for part in parts])
    steady = combine(join, [part.steady_range for part in parts])
    burst = combine(join, [part.burst_range for part in parts])
    # Nouns first: "leaving out services and a server" would read as leaving out both.
    named = sorted(steps, key=lambda step: is_gerund(step.what))
    rows = [rule_for(kind, new.protocol) for step in named for kind in step.kinds]
    note = steps[0].note
    if len(steps) > 1:
        note = wording.join_sentences(*dict.fromkeys(s.combined_note for s in steps))
    elif steps[0].kind == "middleware":
        note = session_setup_note(base, new.protocol, before.single, after.single, window)
    return Remedy(
        kind=steps[0].kind if len(steps) == 1 else "combination",
        what=wording.join_words([step.what for step in named]),
        trade_offs="; ".join(dict.fromkeys(row["price"] for row in rows)),
        failure_mode="; ".join(dict.fromkeys(row["fails"] for row in rows if row["fails"])),
        all_discover=all(row["all_find_each_other"] == "yes" for row in rows),
        fleets=fleets,
        protocol=new.protocol,
        wifi=new.wifi,
        range_before=before,
        range_after=after,
        steady_range=steady,
        window=window,
        start_window=drain_time_range(burst, steady).bounds[0],
        note=note,
        efforts=tuple(row["effort"] for row in rows),
        steps=tuple(kind for step in steps for kind in step.kinds),
        best_case=any(row["gain"] == "best case" for row in rows),
    )


def _remedy_sort_key(remedy: Remedy) -> tuple[Any, ...]:
    """Return the sort key of a remedy; see `Plan`."""
    fits, research = remedy.now_fits, "research" in remedy.efforts
    effort = (remedy.effort_rank, len(remedy.steps)) if fits else (0, 0)
    return not remedy.all_discover, research, not fits, remedy.best_case, effort, -remedy.saved


def _best_sets(
    base: Setting, remedies: dict[Change, Remedy], window: float
) -> list[tuple[Change, ...]]:
    """Return the best sets of two or three changes that all contribute, from the best tables."""
    usable = [c for c, r in remedies.items() if c.slot in SLOTS and "research" not in r.efforts]
    tables = sorted((c for c in usable if c.slot == "table"), key=lambda c: -remedies[c].saved)
    usable = [c for c in usable if c.slot != "table" or c in tables[:_MAX_COMBINED_TABLES]]
    usable.sort(key=lambda change: SLOTS.index(change.slot))
    best_case = {change for change in usable if remedies[change].best_case}
    after: dict[tuple[Change, ...], float] = {}
    ranked: list[tuple[Any, tuple[Change, ...]]] = []
    for count in range(1, _MAX_STEPS + 1):
        for steps in combinations(usable, count):
            if len({step.slot for step in steps}) < count:
                continue
            if sum(len(step.kinds) for step in steps) > _MAX_STEPS:
                continue
            after[steps] = taken = base.with_changes(steps).utilization(window)
            before = base.baseline_of(steps).utilization(window)
            saved = 1 - taken / before if before else 0.0
            subsets = (tuple(s for s in steps if s is not left) for left in steps)
            needed = all(taken < (1 - MIN_SAVING) * after.get(subset, before) for subset in subsets)
            if saved < MIN_SAVING or not needed or count < 2:
                continue
            fits = wording.below_capacity(taken) and not wording.below_capacity(before)
            effort = (max(remedies[step].effort_rank for step in steps), count) if fits else (0, 0)
            ranked.append(((not fits, not best_case.isdisjoint(steps), effort, -saved), steps))
    return [steps for _, steps in sorted(ranked, key=lambda item: item[0])[:_MAX_COMBINATIONS]]


def _with_staggered_start(
    base: Setting, remedies: dict[Change, Remedy], window: float
) -> Iterator[Remedy]:
    """Yield each change without a prototype, if a staggered start can be added, with one."""
    for change, remedy in remedies.items():
        usable = change.slot in SLOTS and "research" not in remedy.efforts
        if usable and math.isfinite(remedy.start_window):
            yield _compute_remedy(base, [change, STAGGERED_START], window)


def _airtime_shares(base: Setting, window: float) -> Iterator[Share]:
    """Yield the airtime share of each message, phase and group, the largest of each kind first."""
    fleet, protocol, wifi = base.fleet, base.protocol, base.wifi
    total = base.utilization(window)
    costs = message_costs(protocol, fleet, wifi, window)
    rests = utilization_without_each_group(protocol, fleet, wifi, window)
    parts: dict[Literal["message", "phase", "group"], list[tuple[str, float]]] = {
        "message": [(row["message"], row["uplink_s"] + row["downlink_s"]) for row in costs],
        "phase": [(phase, base.utilization(window, phase)) for phase in protocol.phases],
        "group": [(name, total - rest) for name, rest in zip(fleet.names, rests, strict=True)],
    }
    for kind, taken_by_name in parts.items():
        for name, taken in sorted(taken_by_name, key=lambda item: -item[1]):
            yield Share(kind, name, taken, taken / total if total else 0.0)
