"""What could be changed of a fleet: its processes, endpoints, channels and domains."""

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

from discostorm import _checks
from discostorm.fleet import Fleet, HostGroup
from discostorm.messages import Protocol
from discostorm.ros2 import parameter_service_endpoints
from discostorm_planner.changes import Change
from discostorm_planner.remedy_rules import configuration_of, row_of

#: Parts that a fleet is split into.
PARTS = (2, 3)


def fleet_changes(fleet: Fleet) -> Iterator[Change | str]:
    """Yield fewer processes and endpoints, or why there are none."""
    many = [group for group in fleet.groups if group.processes > 1]
    if many:
        which = "the processes of each host"
        if len(many) == 1:
            of = of_group(many[0]) if len(fleet.groups) > 1 else ""
            which = f"{many[0].processes:,.10g} processes{of}"
        what = f"composing {which} into 1"
        try:
            composed(fleet)
        except ValueError as error:
            yield f"{what}: {error}"
        else:
            yield Change("processes", what, "processes", fleet=composed)
    else:
        yield "composing: each host has one process already"
    each = parameter_service_endpoints()
    # Where nobody says how many nodes a process has, one is assumed if it has the endpoints.
    nodes = [
        float(group.endpoints >= each) if group.nodes is None else group.nodes
        for group in fleet.groups
    ]
    assumed = " (assumed)" if any(group.nodes is None for group in fleet.groups) else ""
    if not any(nodes):
        yield f"parameter services: no process has any (those of a node are {each} endpoints)"
        return

    def fewer(whole: Fleet) -> Fleet:
        groups = (
            _with(group, endpoints=group.endpoints - each * own, nodes=0)
            for group, own in zip(whole.groups, nodes, strict=True)
        )
        return Fleet(tuple(groups), whole.matching)

    counts = " and ".join(f"{own:.3g}" for own in dict.fromkeys(nodes))
    noun = "node" if set(nodes) == {1} else "nodes"
    what = f"leaving out the parameter services of {counts} {noun} a process{assumed}"
    yield Change("endpoints", what, "endpoints", fleet=fewer)


def part_changes(fleet: Fleet, protocol: Protocol) -> Iterator[Change | str]:
    """Yield parts of it on channels of their own or in domains, or why there are none."""
    hosts = sum(group.hosts for group in fleet.groups)
    row = row_of("domains", protocol.family)
    arranged = configuration_of(protocol)
    works = row is not None and row["works"] == "computed"
    if row is not None and works and arranged is not None:
        # The standard keeps apart who finds each other by announcements, and nobody else.
        works = False
        yield f"{row['title']} with {arranged['title']}: {arranged['in_domains']}"
    for parts in PARTS:
        # A host that is alone on its channel has nobody to find: no remedy but a surrender.
        if 2 * parts > hosts:
            yield f"splitting into {parts} parts: not every part would have two hosts"
            continue
        pieces = split(fleet, parts)
        yield Change("channels", f"splitting onto {parts} channels", "parts", parts=pieces)
        if works:
            yield Change("domains", f"splitting into {parts} domains", "parts", parts=pieces)


def composed(fleet: Fleet) -> Fleet:
    """Return a fleet of the same endpoints in one process a host."""
    groups = (
        replace(
            group,
            processes=1,
            endpoints=group.processes * group.endpoints,
            shared=group.processes * group.shared,
            nodes=None if group.nodes is None else group.processes * group.nodes,
        )
        for group in fleet.groups
    )
    return Fleet(tuple(groups), fleet.matching)


def split(fleet: Fleet, parts: int) -> tuple[Fleet, ...]:
    """Return parts of a fleet as equal as whole hosts allow: they are dealt out in turn.

    Raises
    ------
    ValueError
        If there are fewer hosts than parts.
    """
    hosts = int(sum(group.hosts for group in fleet.groups))
    _checks.number("parts", parts, 1, hosts)
    dealt: list[list[HostGroup]] = [[] for _ in range(parts)]
    before = 0
    for group in fleet.groups:
        for part, groups in enumerate(dealt):
            own = len(range((part - before) % parts, int(group.hosts), parts))
            if own:
                groups.append(replace(group, hosts=own))
        before += int(group.hosts)
    return tuple(Fleet(tuple(groups), fleet.matching) for groups in dealt)


def _with(group: HostGroup, **counts: Any) -> HostGroup:
    """Return a group with other counts, of which no more endpoints are shared than it has."""
    counts = {"endpoints": group.endpoints, "shared": group.shared} | counts
    return replace(group, **counts | {"shared": min(counts["shared"], counts["endpoints"])})


def of_group(group: HostGroup) -> str:
    """Return whose something is, if the group has a name."""
    return f" of {group.name}" if group.name else ""
