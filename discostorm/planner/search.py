"""The search: what each change brings, alone and combined."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from itertools import combinations
from typing import Any, Literal

from discostorm import _checks, words
from discostorm.fleet import COUNTS, LEAST, Fleet, as_fleet
from discostorm.messages import PAPER_WINDOW, Protocol, Unit
from discostorm.model import burst, message_costs, unit_costs, utilization, without_each
from discostorm.planner.changes import SLOTS, Change, Setting
from discostorm.planner.fleets import fleet_changes, nodes_of, of_group, of_ros2, part_changes
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


def plan(
    fleet: Fleet,
    protocol: Protocol = DDS,
    wifi: Wifi = PAPER,
    *,
    nodes: float | Sequence[float] | None = None,
    window: float = PAPER_WINDOW,
    shared: float | None = None,
) -> Plan:
    """Return what discovery costs a fleet, what dominates, and what would help.

    Each remedy changes one thing and leaves the rest; to combine them, plan again with
    what a `Remedy` holds. Composing keeps the endpoints. Endpoints are counted as DDS does.
    Processes are taken for those of ROS 2: some of their endpoints match in all others, whatever
    namespaces there are, and a server introduces each two processes; see `shared`.

    Parameters
    ----------
    fleet : Fleet
        Who is on the channel: numbers, with whole hosts.
    protocol : Protocol, optional
        One of `PROTOCOLS`, or a table of your own. The paper's tables are compared with each
        other, and so are those with periods.
    wifi : Wifi, optional
        The channel; the paper's if left out. What is changed is its radio (`Wifi.radio`), with
        all that the standard says. On the paper's channel both sides of such a comparison have
        the standard's timing; a channel that is not that of a radio is not changed.
    nodes : float or sequence of float, optional
        Nodes with parameter services in each process [1], at least 0; a sequence has one
        number for each group. Leaving the services out saves 12 endpoints a node. If left
        out, those of the groups; where these have none, one node for each process with at
        least that many endpoints.
    window : float, optional
        The seconds that are averaged [s], above 0; the paper's one if left out, infinity for
        the steady state.
    shared : float, optional
        Endpoints of each process that match one in every other [1], 0 for programs without
        ROS 2. If left out, at least those that ROS 2 makes for a process and for each of its nodes,
        `discostorm.robots.shared_endpoints`; more where a group says so, never more than a process
        has. Without a number of nodes it has as many as ready-made robots have for its endpoints,
        `discostorm.robots.likely_nodes`. Only tables of what products send depend on it.

    Returns
    -------
    Plan
        With text (`Plan.advice`), table, picture and JSON.

    Raises
    ------
    ValueError
        If a count or the window is out of range, hosts are not whole, or there are fewer
        endpoints than the parameter services of `nodes` have.
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
    'composing 8 processes into 1 cuts 1.38 s to 0.11 s (92%)'
    >>> [found.sentence() for found in plan.remedies if found.kind == "discovery server"]
    ['a Discovery Server cuts 6.16 s to 1.92 s (69%); both as Fast DDS was measured']
    """
    _checks.instance("fleet", fleet, Fleet)
    _checks.instance("protocol", protocol, Protocol)
    _checks.instance("wifi", wifi, Wifi)
    _checks.one_each([("window", window)])
    as_fleet(fleet, None, None)  # raises if there are symbols
    for group in fleet.groups:
        _checks.one_each(zip(COUNTS, group.counts(), strict=True))
        _checks.whole(f"hosts{of_group(group)}", group.hosts, LEAST["hosts"])
    own = nodes_of(fleet, nodes)
    if shared is not None:
        shared = _checks.number("shared", shared, 0, _checks.MOST)
    fleet = of_ros2(fleet, nodes, shared)
    guessed = nodes is None and any(group.nodes is None for group in fleet.groups)

    costs = Costs(window)
    base = Setting(fleet, protocol, wifi)
    found = tuple(changes_of(base, own, " (assumed)" if guessed else ""))
    singles = {step: _remedy(base, [step], costs) for step in found if isinstance(step, Change)}
    steady = costs.repeated(base)
    late = [step for step in singles if step.slot == "time" and not words.fits(steady)]
    never = [
        f"{singles.pop(step).what}: what is repeated takes {words.percent(steady)} of the channel "
        "by itself, so that no window is long enough"
        for step in late
    ]
    alone = [r for step, r in singles.items() if len(step.steps) == 1]
    together = [_remedy(base, steps, costs) for steps in _together(base, singles, costs.roughly)]
    reasons = [reason for reason in found if isinstance(reason, str)]
    taken = costs.of(base)
    return Plan(
        fleet=fleet,
        protocol=protocol,
        wifi=wifi,
        window=float(window),
        utilization=taken,
        steady=steady,
        shares=tuple(_shares(base, float(window), taken)),
        remedies=tuple(sorted(alone, key=_order)),
        combinations=tuple(sorted(together, key=_order)),
        left_out=(*never, *reasons, *inapplicable(protocol)),
    )


@dataclass(frozen=True)
class Costs:
    """What settings take of a window [s], each counted once.

    Fleets are told apart by identity, as to compare those of many groups takes longer than to
    count; whoever counts keeps them.
    """

    window: float
    _taken: dict[tuple[int, Protocol, Wifi], float] = field(default_factory=dict)
    _units: dict[int, dict[Unit, float]] = field(default_factory=dict)

    def of(self, setting: Setting) -> float:
        """Return the utilization [1]."""
        fleet, protocol, wifi = setting.fleet, setting.protocol, setting.wifi
        key = (id(fleet), protocol, wifi)
        if key not in self._taken:
            self._taken[key] = float(utilization(protocol, fleet, wifi=wifi, window=self.window))
        return self._taken[key]

    def roughly(self, setting: Setting) -> float:
        """As `of`, but for the order in which numbers are added up: units are counted once."""
        units = self._units.setdefault(id(setting.fleet), {})
        prices = unit_costs(setting.protocol, setting.wifi, float(self.window))
        for unit in prices:
            if unit not in units:
                units[unit] = float(unit.count(setting.fleet))
        return float(sum(price * units[unit] for unit, price in prices.items()))

    @staticmethod
    def repeated(setting: Setting) -> float:
        """Return what is repeated takes of the channel [1]."""
        if not setting.protocol.repeats:
            return 0.0
        return float(
            utilization(setting.protocol, setting.fleet, wifi=setting.wifi, window=math.inf)
        )


def _remedy(base: Setting, steps: Sequence[Change], costs: Costs) -> Remedy:
    """Return what these changes lead to together."""
    old, new = base.before(steps), base.after(steps)
    parts = next((step.parts for step in steps if step.parts), (new.fleet,))
    settings = [Setting(part, new.protocol, new.wifi) for part in parts]
    taken = [costs.of(setting) for setting in settings]
    starts = [float(burst(new.protocol, part, wifi=new.wifi)) for part in parts]
    steadies = [costs.repeated(setting) for setting in settings]
    of_all: Callable[[Iterable[float]], float] = sum
    if any(step.kind == "channels" for step in steps):
        of_all = max
    # Things first: "leaving out services and a server" would leave out both.
    told = sorted(steps, key=lambda step: is_doing(step.what))
    rows = [known(kind, new.protocol) for step in told for kind in step.steps]
    before = costs.of(old)
    if len(steps) > 1:
        note = "; ".join(dict.fromkeys(step.by for step in steps if step.by))
    elif steps[0].kind == "middleware":
        note = sessions_note(
            base.protocol,
            new.protocol,
            before,
            taken[0],
            lambda table: costs.of(Setting(base.fleet, table, base.wifi)),
            float(costs.window),
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
        window=float(costs.window),
        note=note,
        efforts=tuple(row["effort"] for row in rows),
        fails="; ".join(dict.fromkeys(row["fails"] for row in rows if row["fails"])),
        steps=tuple(kind for step in steps for kind in step.steps),
        spread=float(drained(of_all(starts), of_all(steadies))),
        steady=of_all(steadies),
        best_case=any(row["gain"] == "best case" for row in rows),
    )


def changes_of(base: Setting, nodes: Sequence[float], assumed: str) -> Iterator[Change | str]:
    """Yield each change, or why there is none."""
    yield from fleet_changes(base.fleet, nodes, assumed)
    yield from table_changes(base.protocol)
    yield from radio_changes(base.wifi)
    yield from part_changes(base.fleet, base.protocol)
    yield Change(
        "staggered start",
        "starting one after the other",
        "time",
        note=simulated_stagger(base.protocol),
    )


def _order(remedy: Remedy) -> tuple[Any, ...]:
    """Return by what remedies are sorted; see `Plan`."""
    effort = (remedy.rank, len(remedy.steps)) if remedy.now_fits else (0, 0)
    research = "research" in remedy.efforts
    fits = remedy.now_fits
    return not remedy.whole, research, not fits, remedy.best_case, effort, -remedy.saved


def _together(
    base: Setting, singles: dict[Change, Remedy], cost: Callable[[Setting], float]
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
            after[steps] = taken = cost(base.after(steps))
            before = cost(base.before(steps))
            saved = 1 - taken / before if before else 0.0
            less = (tuple(s for s in steps if s is not left) for left in steps)
            needed = all(taken < (1 - NOTHING) * after.get(fewer, before) for fewer in less)
            if saved < NOTHING or not needed or sum(len(s.steps) for s in steps) < 2:
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
