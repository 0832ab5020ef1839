"""A link that opens the book's calculator with the numbers of a fleet."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from urllib.parse import urlencode

import discostorm as ds
from discostorm.fleet import COUNTS
from discostorm.lookup import as_wifi

#: The calculator in the book.
CALCULATOR_PAGE = "book/calculator.html"


@dataclass(frozen=True)
class CalculatorLink:
    """A link, and notes on the parts of the fleet that the calculator leaves out."""

    address: str
    middleware: str | None
    notes: tuple[str, ...]


def calculator_link(fleet: ds.Fleet, middleware: str | None = None) -> CalculatorLink | None:
    """Return the link for a fleet, with its largest group as the robots; None if all are wired."""
    notes = []
    groups = [group for group in fleet.groups if not group.wired]
    wired = [group for group in fleet.groups if group.wired and group.endpoints]
    if not groups:
        return None
    if fleet.cells:
        groups = _merge_equal_groups(groups)
        notes.append("the calculator spreads robots evenly over access points of one kind")
    robots, *others = sorted(groups, key=lambda g: -g.hosts)
    if wired and others:
        notes.append("the calculator leaves out the wired hosts beside others")
    others = others or wired
    entries = {"robot": "own", **_total_and_means([robots]), "beside": "own" if others else "none"}
    if others:
        entries |= {f"beside_{name}": value for name, value in _total_and_means(others).items()}
        entries["cable"] = str(int(others is wired))
    if len(others) > 1:
        notes.append(f"the means of {len(others)} groups stand beside the largest one")
    if middleware is not None:
        entries["middleware"] = middleware
    first = as_wifi(fleet.cells[0].wifi).name if fleet.cells else "paper"
    if fleet.cells:
        entries["cells"] = str(len(fleet.cells))
    entries["wifi"] = first if first in ds.WIFI else "paper"
    entries["matching"] = str(int(fleet.matching >= 0.5))
    return CalculatorLink(f"{CALCULATOR_PAGE}#{urlencode(entries)}", middleware, tuple(notes))


def _merge_equal_groups(groups: Sequence[ds.HostGroup]) -> list[ds.HostGroup]:
    """Merge the groups whose hosts have equal numbers of processes and endpoints."""
    alike: dict[tuple[object, ...], ds.HostGroup] = {}
    for group in groups:
        key = group.counts()[1:]
        hosts = group.hosts + (alike[key].hosts if key in alike else 0)
        alike[key] = replace(group, hosts=hosts)
    return list(alike.values())


def _total_and_means(groups: Sequence[ds.HostGroup]) -> dict[str, str]:
    """Return the hosts, and the means of processes per host and endpoints per process."""
    hosts = sum(group.hosts for group in groups)
    processes = sum(group.hosts * group.processes for group in groups)
    endpoints = sum(group.hosts * group.processes * group.endpoints for group in groups)
    means = (hosts, processes / hosts, endpoints / processes if processes else 0)
    return {name: f"{value:.6g}" for name, value in zip(COUNTS, means, strict=True)}
