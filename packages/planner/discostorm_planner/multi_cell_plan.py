"""Plan a fleet with several access points: its discovery time, and the airtime of each cell."""

from __future__ import annotations

from dataclasses import replace

from discostorm import wording
from discostorm.fleet import Fleet
from discostorm.lookup import AnyProtocol
from discostorm.wifi import PAPER
from discostorm_planner.aggregation_range import combine
from discostorm_planner.answer_text import phrase
from discostorm_planner.plan import plan
from discostorm_planner.result import Plan


def plan_cells(fleet: Fleet, protocol: AnyProtocol, within: float | None = None) -> Plan:
    """Plan a fleet with cells: `Plan.discovery` simulates all cells on one clock.

    Everything else describes the cell where discovery needs most airtime, with the changes of hosts
    and middleware. `Plan.startup` and `Plan.steady_range` are the maxima over all cells.
    """
    seen = {
        cell: plan(of, protocol, cell.wifi, within=within) for cell, of in fleet.by_cell().items()
    }
    busiest = max(seen.values(), key=lambda one: one.utilization_range.full)
    cells = (replace(cell, wifi=one._setting.full_ampdu_wifi) for cell, one in seen.items())
    whole = replace(fleet, cells=tuple(cells))

    def restore_cells(changed: Fleet) -> Fleet:
        pairs = zip(changed.groups, fleet.groups, strict=True)
        groups = (replace(group, cell=own.cell, wired=own.wired) for group, own in pairs)
        return replace(whole, groups=tuple(groups))

    remedies, combinations, staggered = (
        tuple(
            replace(remedy, fleets=(restore_cells(remedy.fleets[0]),))
            for remedy in some
            if remedy.wifi == busiest.wifi and remedy.all_discover
        )
        for some in (busiest.remedies, busiest.combinations, busiest.staggered)
    )
    names: dict[str, list[str]] = {}
    for cell, one in seen.items():
        names.setdefault(phrase(one.wifi.name), []).append(f'"{cell.name}"')
    told = [f"{wifi} in {wording.join_words(own)}" for wifi, own in names.items()]
    return replace(
        busiest,
        fleet=whole,
        wifi=replace(PAPER, name=wording.join_words(told)),
        startup=combine(max, [one.startup for one in seen.values()]),
        steady_range=combine(max, [one.steady_range for one in seen.values()]),
        remedies=remedies,
        combinations=combinations,
        staggered=staggered,
        data=None,
        ampdu_frames=1,
        cells=tuple((cell.name, one.utilization_range) for cell, one in seen.items()),
    )
