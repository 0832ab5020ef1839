"""What discovery costs a fleet, what dominates, and what would help, alone and combined."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import combinations
from typing import Any, Literal

from discostorm import _checks, words
from discostorm._arguments import as_fleet
from discostorm.fleet import COUNTS, LEAST, Fleet
from discostorm.measured import band
from discostorm.messages import PAPER_WINDOW, Protocol
from discostorm.model import message_costs, utilization, without_each
from discostorm.protocols import DDS
from discostorm.timeline import drained
from discostorm.wifi import PAPER, Wifi
from discostorm.wifi.radio import both_ends
from discostorm_planner.aggregation_range import (
    burst_of,
    known_after,
    repeated,
    span_of,
    startup,
    together,
)
from discostorm_planner.changes import SLOTS, Change, Setting
from discostorm_planner.configurations import compared
from discostorm_planner.fleet_changes import fleet_changes, of_group, part_changes
from discostorm_planner.protocol_changes import sessions_note, table_changes
from discostorm_planner.radio_changes import radio_changes
from discostorm_planner.reboot import reboot
from discostorm_planner.remedy import NOTHING, Remedy, is_doing
from discostorm_planner.remedy_rules import inapplicable, known, known_as, simulated_stagger
from discostorm_planner.result import Plan, Share
from discostorm_planner.user_data import beside

#: Combinations that are kept, tables that are combined, and most remedies in a combination.
_KEPT, _TABLES, _TOGETHER = 5, 3, 3
#: By what gains are computed on a channel that aggregates.
_BASES = {True: "simulated", False: "one frame in each exchange"}


def plan(
    fleet: Fleet,
    protocol: Protocol = DDS,
    wifi: Wifi = PAPER,
    *,
    window: float = PAPER_WINDOW,
) -> Plan:
    """Return what discovery costs a fleet, what dominates, and what would help.

    Each remedy changes one thing and leaves the rest; to combine them, plan again with
    what a `Remedy` holds. Composing keeps the endpoints. Endpoints are counted as DDS does.

    Parameters
    ----------
    fleet : Fleet
        Who is on the channel: numbers, with whole hosts. What its processes share with all others
        and how many nodes they have is what its groups say: fleet files and ready-made robots share
        what ROS 2 does, `Fleet.swarm` and a `HostGroup` of plain numbers nothing. Leaving out
        parameter services saves 12 endpoints a node; where a group says no `HostGroup.nodes`, one
        node is assumed for each process with at least that many endpoints.
    protocol : Protocol, optional
        One of `PROTOCOLS`, or a table of your own. The paper's tables are compared with each
        other, and so are those with periods. Which remedies there are for a table depends on its
        `family`, `product` and `basis`, never on its name.
    wifi : Wifi, optional
        The channel; the paper's if left out. What is changed is its radio (`Wifi.radio`), with
        all that the standard says. On the paper's channel both sides of such a comparison have
        the standard's timing; a channel that is not that of a radio is not changed. A radio from
        802.11n on aggregates, whether its name says so or not: the answer is a range from full
        A-MPDUs (64 frames, or as many as the radio says) to one frame in each exchange, with what
        was simulated between them. Gains are those of the simulated values or, where one of both is
        not stored, of single frames, before and after alike. `PAPER` does not aggregate.
    window : float, optional
        The seconds that are averaged [s], above 0; the paper's one if left out, infinity for
        the steady state.

    Returns
    -------
    Plan
        With text (`Plan.advice`), table, picture and JSON.

    Raises
    ------
    ValueError
        If a count or the window is out of range, or hosts are not whole.
    TypeError
        If the fleet holds arrays or symbols, or an argument is not what it should be.

    References
    ----------
    Parameter services: rclcpp, branch humble, parameter_service.cpp (six services of two
    endpoints each, ``data/fleets/parameter_services.csv``). For which protocols a remedy works:
    ``data/vendors/remedies.csv``, each row with its source.

    Examples
    --------
    >>> import discostorm as ds
    >>> plan = ds.plan(ds.Fleet.swarm(hosts=3, processes=8, endpoints=5), ds.DDS)
    >>> plan.remedies[0].sentence().partition(". ")[0]
    'a Discovery Server cuts 7.77 s to 0.25 s (97%), which fits'
    >>> [found.sentence() for found in plan.remedies if found.kind == "processes"]
    ['composing 8 processes into 1 cuts 1.38 s to 0.11 s (92%), which fits']
    """
    _checks.instance("fleet", fleet, Fleet)
    _checks.instance("protocol", protocol, Protocol)
    _checks.instance("wifi", wifi, Wifi)
    span = _checks.number("window", window, _checks.LEAST_SECONDS, endless=True)
    as_fleet(fleet, None, None)  # raises if there are symbols
    for group in fleet.groups:
        _checks.one_each(zip(COUNTS, group.counts(), strict=True))
        _checks.whole(f"hosts{of_group(group)}", group.hosts, LEAST["hosts"])

    full, single = both_ends(wifi)
    mpdus = full.aggregation.mpdus if full != single and full.aggregation else 1
    base = Setting(fleet, protocol, single, mpdus)
    found = tuple(changes_of(base))
    singles = {step: _remedy(base, [step], span) for step in found if isinstance(step, Change)}
    steady, taken = repeated(base), span_of(base, span)
    late = [step for step in singles if step.slot == "time" and not words.fits(steady.full)]
    never = [
        f"{singles.pop(step).what}: the periodic traffic alone needs {words.percent(steady.full)} "
        "of the channel, so no window is long enough"
        for step in late
    ]
    together = [_remedy(base, steps, span) for steps in _together(base, singles, span)]
    reasons = [reason for reason in found if isinstance(reason, str)]
    of = known_as(protocol)
    return Plan(
        fleet=fleet,
        protocol=protocol,
        wifi=single,
        window=span,
        utilization=taken.known,
        steady=steady.known,
        shares=tuple(_shares(base, span, _taken(base, span))),
        remedies=tuple(sorted(singles.values(), key=_order)),
        combinations=tuple(sorted(together, key=_order)),
        left_out=(*never, *reasons, *inapplicable(protocol)),
        configurations=compared(base, span),
        span=taken,
        steady_span=steady,
        startup=startup(base),
        known=known_after(protocol, fleet, full) if full != single else None,
        reboot=reboot(base),
        band=band(of.name, fleet, of.captured) if of and of.captured else None,
        data=beside(base, span),
    )


def changes_of(base: Setting) -> Iterator[Change | str]:
    """Yield each change that is tried, or why there is none; another remedy begins here."""
    yield from fleet_changes(base.fleet)
    yield from table_changes(base.protocol)
    yield from radio_changes(base.wifi)
    yield from part_changes(base.fleet, base.protocol)
    yield Change(
        "staggered start",
        "starting one after the other",
        "time",
        note=simulated_stagger(base.protocol),
    )


def _taken(setting: Setting, window: float) -> float:
    """Return the utilization of a setting with single frames [1]."""
    fleet, protocol, wifi = setting.fleet, setting.protocol, setting.wifi
    return float(utilization(protocol, fleet, wifi=wifi, window=window))


def _remedy(base: Setting, steps: Sequence[Change], window: float) -> Remedy:
    """Return what these changes lead to together."""
    old, new = base.before(steps), base.after(steps)
    parts = next((step.parts for step in steps if step.parts), (new.fleet,))
    of_all = "max" if any(step.kind == "channels" for step in steps) else "sum"
    settings = [replace(new, fleet=part) for part in parts]
    was = span_of(old, window)
    spans = [span_of(setting, window) for setting in settings]
    taken, steady = together(spans, of_all), together(list(map(repeated, settings)), of_all)
    # Before and after alike: as simulated, if both are.
    simulated = was.simulated is not None and taken.simulated is not None
    before, after = (one.known if simulated else one.single for one in (was, taken))
    repeats = steady.known if simulated else steady.single
    starts = together(list(map(burst_of, settings)), of_all)
    # Things first: "leaving out services and a server" would leave out both.
    told = sorted(steps, key=lambda step: is_doing(step.what))
    rows = [known(kind, new.protocol) for step in told for kind in step.steps]
    if len(steps) > 1:
        note = words.sentences(*dict.fromkeys(step.by for step in steps if step.by))
    elif steps[0].kind == "middleware":
        note = sessions_note(
            base.protocol,
            new.protocol,
            was.single,
            taken.single,
            lambda table: _taken(replace(base, protocol=table), window),
            window,
        )
    else:
        note = steps[0].note
    return Remedy(
        kind=steps[0].kind if len(steps) == 1 else "combination",
        what=words.listed([step.what for step in told]),
        price="; ".join(dict.fromkeys(row["price"] for row in rows)),
        whole=all(row["all_find_each_other"] == "yes" for row in rows),
        fleets=parts,
        protocol=new.protocol,
        wifi=new.wifi,
        before=before,
        utilization=after,
        window=window,
        note=note,
        efforts=tuple(row["effort"] for row in rows),
        fails="; ".join(dict.fromkeys(row["fails"] for row in rows if row["fails"])),
        steps=tuple(kind for step in steps for kind in step.steps),
        spread=float(drained(starts.known if simulated else starts.single, repeats)),
        steady=repeats,
        best_case=any(row["gain"] == "best case" for row in rows),
        span=taken,
        was=was,
        basis=_BASES[simulated] if taken.ranges or was.ranges else "",
    )


def _order(remedy: Remedy) -> tuple[Any, ...]:
    """Return by what remedies are sorted; see `Plan`."""
    effort = (remedy.rank, len(remedy.steps)) if remedy.now_fits else (0, 0)
    research = "research" in remedy.efforts
    fits = remedy.now_fits
    return not remedy.whole, research, not fits, remedy.best_case, effort, -remedy.saved


def _together(
    base: Setting, singles: dict[Change, Remedy], window: float
) -> list[tuple[Change, ...]]:
    """Return the best sets of two or three changes; each is needed for what its set saves.

    All sets are tried, but with no more than the best few tables.
    """
    usable = [c for c, r in singles.items() if c.slot in SLOTS and "research" not in r.efforts]
    tables = sorted((c for c in usable if c.slot == "table"), key=lambda c: -singles[c].saved)
    usable = [c for c in usable if c.slot != "table" or c in tables[:_TABLES]]
    usable.sort(key=lambda change: SLOTS.index(change.slot))
    unsure = {change for change in usable if singles[change].best_case}
    after: dict[tuple[Change, ...], float] = {}
    found: list[tuple[Any, tuple[Change, ...]]] = []
    for many in range(1, _TOGETHER + 1):
        for steps in combinations(usable, many):
            if len({step.slot for step in steps}) < many:
                continue
            if sum(len(step.steps) for step in steps) > _TOGETHER:
                continue
            after[steps] = taken = _taken(base.after(steps), window)
            before = _taken(base.before(steps), window)
            saved = 1 - taken / before if before else 0.0
            less = (tuple(s for s in steps if s is not left) for left in steps)
            needed = all(taken < (1 - NOTHING) * after.get(fewer, before) for fewer in less)
            if saved < NOTHING or not needed or many < 2:
                continue
            fits = words.fits(taken) and not words.fits(before)
            rank = max(singles[step].rank for step in steps) if fits else 0
            order = (not fits, not unsure.isdisjoint(steps), rank, many if fits else 0, -saved)
            found.append((order, steps))
    return [steps for _, steps in sorted(found, key=lambda item: item[0])[:_KEPT]]


def _shares(base: Setting, window: float, whole: float) -> Iterator[Share]:
    """Yield what messages, phases and groups take of it all; of each the largest first."""
    fleet, protocol, wifi = base.fleet, base.protocol, base.wifi
    messages = [
        (row["message"], row["uplink_s"] + row["downlink_s"])
        for row in message_costs(protocol, fleet, wifi, window)
    ]
    yield from _largest("message", messages, whole)
    phases = [
        (phase, float(utilization(protocol, fleet, wifi=wifi, window=window, phase=phase)))
        for phase in protocol.phases
    ]
    yield from _largest("phase", phases, whole)
    rests = without_each(protocol, fleet, wifi, window)
    taking_part = [(name, whole - rest) for name, rest in zip(fleet.names, rests, strict=True)]
    yield from _largest("group", taking_part, whole)


def _largest(
    kind: Literal["message", "phase", "group"],
    parts: Iterable[tuple[str, float]],
    whole: float,
) -> Iterator[Share]:
    for name, taken in sorted(parts, key=lambda item: -item[1]):
        yield Share(kind, name, taken, taken / whole if whole else 0.0)
