"""What discovery costs a fleet, what dominates, and what would help, alone and combined."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from itertools import combinations
from typing import Any, Literal

from discostorm import _checks, words
from discostorm._arguments import as_fleet
from discostorm._renamed import renamed
from discostorm.fleet import COUNTS, LEAST, Fleet
from discostorm.messages import PAPER_WINDOW, Protocol
from discostorm.model import burst, message_costs, utilization, without_each
from discostorm.planner.arrangements import compared
from discostorm.planner.changes import SLOTS, Change, Setting
from discostorm.planner.fleets import fleet_changes, of_group, part_changes
from discostorm.planner.known import inapplicable, known, simulated_stagger
from discostorm.planner.radios import radio_changes
from discostorm.planner.remedy import NOTHING, Remedy, is_doing
from discostorm.planner.result import Plan, Share
from discostorm.planner.tables import sessions_note, table_changes
from discostorm.protocols import DDS
from discostorm.timeline import drained
from discostorm.wifi import PAPER, Wifi

#: Combinations that are kept, tables that are combined, and most remedies in a combination.
_KEPT, _TABLES, _TOGETHER = 5, 3, 3


@renamed(
    nodes="HostGroup.nodes or `nodes` of a fleet file",
    shared="HostGroup.shared or `shared` of a fleet file",
)
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
        the standard's timing; a channel that is not that of a radio is not changed.
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
    >>> plan.remedies[0].sentence()
    'a Discovery Server cuts 5.74 s to 0.25 s (96%); both as Fast DDS was measured'
    >>> [found.sentence() for found in plan.remedies if found.kind == "processes"]
    ['composing 8 processes into 1 cuts 1.38 s to 0.11 s (92%)']
    """
    _checks.instance("fleet", fleet, Fleet)
    _checks.instance("protocol", protocol, Protocol)
    _checks.instance("wifi", wifi, Wifi)
    span = _checks.number("window", window, _checks.LEAST_SECONDS, endless=True)
    as_fleet(fleet, None, None)  # raises if there are symbols
    for group in fleet.groups:
        _checks.one_each(zip(COUNTS, group.counts(), strict=True))
        _checks.whole(f"hosts{of_group(group)}", group.hosts, LEAST["hosts"])

    base = Setting(fleet, protocol, wifi)
    found = tuple(changes_of(base))
    singles = {step: _remedy(base, [step], span) for step in found if isinstance(step, Change)}
    steady = _repeated(base)
    late = [step for step in singles if step.slot == "time" and not words.fits(steady)]
    never = [
        f"{singles.pop(step).what}: what is repeated takes {words.percent(steady)} of the channel "
        "by itself, so that no window is long enough"
        for step in late
    ]
    together = [_remedy(base, steps, span) for steps in _together(base, singles, span)]
    reasons = [reason for reason in found if isinstance(reason, str)]
    taken = _taken(base, span)
    return Plan(
        fleet=fleet,
        protocol=protocol,
        wifi=wifi,
        window=span,
        utilization=taken,
        steady=steady,
        shares=tuple(_shares(base, span, taken)),
        remedies=tuple(sorted(singles.values(), key=_order)),
        combinations=tuple(sorted(together, key=_order)),
        left_out=(*never, *reasons, *inapplicable(protocol)),
        arrangements=compared(fleet, wifi, span),
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
    """Return the utilization of a setting [1]."""
    fleet, protocol, wifi = setting.fleet, setting.protocol, setting.wifi
    return float(utilization(protocol, fleet, wifi=wifi, window=window))


def _repeated(setting: Setting) -> float:
    """Return what is repeated takes of the channel [1]."""
    return _taken(setting, math.inf) if setting.protocol.repeats else 0.0


def _remedy(base: Setting, steps: Sequence[Change], window: float) -> Remedy:
    """Return what these changes lead to together."""
    old, new = base.before(steps), base.after(steps)
    parts = next((step.parts for step in steps if step.parts), (new.fleet,))
    settings = [Setting(part, new.protocol, new.wifi) for part in parts]
    taken = [_taken(setting, window) for setting in settings]
    starts = [float(burst(new.protocol, part, wifi=new.wifi)) for part in parts]
    steadies = [_repeated(setting) for setting in settings]
    of_all = max if any(step.kind == "channels" for step in steps) else sum
    # Things first: "leaving out services and a server" would leave out both.
    told = sorted(steps, key=lambda step: is_doing(step.what))
    rows = [known(kind, new.protocol) for step in told for kind in step.steps]
    before = _taken(old, window)
    if len(steps) > 1:
        note = "; ".join(dict.fromkeys(step.by for step in steps if step.by))
    elif steps[0].kind == "middleware":
        note = sessions_note(
            base.protocol,
            new.protocol,
            before,
            taken[0],
            lambda table: _taken(Setting(base.fleet, table, base.wifi), window),
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
        utilization=of_all(taken),
        window=window,
        note=note,
        efforts=tuple(row["effort"] for row in rows),
        fails="; ".join(dict.fromkeys(row["fails"] for row in rows if row["fails"])),
        steps=tuple(kind for step in steps for kind in step.steps),
        spread=float(drained(of_all(starts), of_all(steadies))),
        steady=of_all(steadies),
        best_case=any(row["gain"] == "best case" for row in rows),
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
