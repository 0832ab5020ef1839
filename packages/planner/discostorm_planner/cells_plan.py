"""The plan of a fleet with several access points: its discovery time, and each cell's airtime."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

from discostorm import wording
from discostorm.fleet import Fleet
from discostorm.lookup import as_wifi
from discostorm.messages import PAPER_WINDOW, Protocol
from discostorm.wifi import PAPER, Wifi
from discostorm.wifi.radio import aggregation_bounds
from discostorm_planner import answer_text
from discostorm_planner.aggregation_range import (
    AggregationRange,
    combine,
    drain_time_range,
    steady_range,
    utilization_range,
)
from discostorm_planner.changes import Setting
from discostorm_planner.discovery import Discovery, simulate_changes

_WIRED = "the simulation has no wired hosts beside several access points"


@dataclass(frozen=True)
class CellsPlan:
    """Whether the startup of a fleet with cells works, and what each cell carries.

    `startup` and `steady_range` are those of the cell where they are largest, `cells` has the
    share of the first second that discovery takes in each cell [1]. `wifi` names all channels.
    """

    fleet: Fleet
    protocol: Protocol
    within: float
    wifi: Wifi
    startup: AggregationRange
    steady_range: AggregationRange
    cells: dict[str, AggregationRange]
    discovery: Discovery
    data: None = None

    def advice(self, width: int = 79) -> str:
        """Return the answer for people, in lines of at most ``width`` letters."""
        return answer_text.cells_answer(self, width)

    def to_dict(self) -> dict[str, Any]:
        """Return what JSON can hold."""
        found = self.discovery.to_dict()
        del found["changes"]
        rows = {name: used.to_dict() for name, used in self.cells.items()}
        return {"protocol": self.protocol.name, "cells": rows, "discovery": found}


def plan_cells(fleet: Fleet, protocol: Protocol, within: float) -> CellsPlan:
    """Simulate a fleet with cells, and compute each cell's airtime; changes are not compared."""
    bases, full = {}, []
    names: dict[str, list[str]] = {}
    for cell, seen in fleet.by_cell().items():
        most, single = aggregation_bounds(as_wifi(cell.wifi))
        mpdus = most.aggregation.mpdus if most != single and most.aggregation else 1
        bases[cell.name] = Setting(seen, protocol, single, mpdus)
        full.append(replace(cell, wifi=most))
        names.setdefault(single.name, []).append(cell.name)
    told = [f"{wording.join_words(own)}: {wifi}" for wifi, own in names.items()]
    discovery = Discovery(within, None, _WIRED)
    if not fleet.has_wired:
        whole = Setting(replace(fleet, cells=tuple(full)), protocol, PAPER)
        discovery = simulate_changes(whole, (), (), within)
    return CellsPlan(
        fleet=fleet,
        protocol=protocol,
        within=within,
        wifi=replace(PAPER, name=", ".join(told)),
        startup=combine(max, [drain_time_range(base) for base in bases.values()]),
        steady_range=combine(max, [steady_range(base) for base in bases.values()]),
        cells={name: utilization_range(base, PAPER_WINDOW) for name, base in bases.items()},
        discovery=discovery,
    )
