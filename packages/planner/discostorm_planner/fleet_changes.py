"""Changes of a fleet: fewer processes or endpoints; parts on separate channels or domains."""

import re
from collections.abc import Iterator
from dataclasses import replace

from discostorm import _checks
from discostorm.data import read_data
from discostorm.fleet import Fleet, HostGroup
from discostorm.messages import Protocol
from discostorm.ros2_endpoints import parameter_service_endpoints
from discostorm_planner.changes import Change
from discostorm_planner.remedy_rules import configuration_rules, rule

#: Numbers of parts into which a fleet may be split.
PART_COUNTS = (2, 3)
#: Names of groups that are words in the singular; not abbreviations, numbers and most plurals.
_TAKES_S = re.compile(r"[a-z]([a-gi-rt-w]|[aeo]y)$")


def fleet_changes(fleet: Fleet) -> Iterator[Change | str]:
    """Yield changes to fewer processes or endpoints, or the reason why one does not apply."""
    several = [group for group in fleet.groups if group.processes > 1]
    if several:
        which = "the processes of each host"
        if len(several) == 1:
            robots = group_suffix(several[0]) * (len(fleet.groups) > 1)
            which = f"{several[0].processes:,.10g} processes{robots}"
        what = f"composing {which} into 1"
        try:
            compose(fleet)
        except ValueError as error:
            yield f"{what}: {error}"
        else:
            yield Change("processes", what, "processes", fleet=compose)
    else:
        yield "composing: each host has one process already"
    each = parameter_service_endpoints()
    # Processes with an unknown number of nodes count as one node, if their endpoints suffice.
    nodes = [
        float(group.endpoints >= each) if group.nodes is None else group.nodes
        for group in fleet.groups
    ]
    if not any(nodes):
        yield f"parameter services: no process has any (those of a node are {each} endpoints)"
        return

    def without_services(members: Fleet) -> Fleet:
        groups = []
        for group, count in zip(members.groups, nodes, strict=True):
            endpoints = group.endpoints - each * count
            shared = min(group.shared, endpoints)
            groups.append(replace(group, endpoints=endpoints, shared=shared, nodes=0))
        return replace(members, groups=tuple(groups))

    told = [f"{n:.3g}" if n == round(n) else f"about {max(1, round(n))}" for n in nodes]
    counts = " or ".join(dict.fromkeys(told))
    noun = "node" if {max(1, round(count)) for count in nodes} == {1} else "nodes"
    assumed = " (assumed)" if any(group.nodes is None for group in fleet.groups) else ""
    what = f"leaving out the parameter services of {counts} {noun} per process{assumed}"
    yield Change("endpoints", what, "endpoints", fleet=without_services)


def split_changes(fleet: Fleet, protocol: Protocol) -> Iterator[Change | str]:
    """Yield splits of a fleet over channels or domains, or the reason why one does not apply."""
    hosts = sum(group.hosts for group in fleet.groups)
    domains = rule("domains", protocol.family)
    works = domains is not None and domains["works"] == "computed"
    configuration = next((r for r in configuration_rules() if r["table"] == protocol.key), None)
    if domains is not None and works and configuration is not None:
        # By the standard, domains separate only processes that find each other by announcements.
        works = False
        yield f"{domains['title']} with {configuration['title']}: {configuration['in_domains']}"
    for count in PART_COUNTS:
        # A lone host on a channel discovers no other host, so that split is no remedy.
        if 2 * count > hosts:
            yield f"splitting into {count} parts: not every part would have two hosts"
            continue
        parts = split_hosts(fleet, count)
        yield Change("channels", f"splitting across {count} channels", "parts", parts=parts)
        if works:
            yield Change("domains", f"splitting into {count} domains", "parts", parts=parts)


def compose(fleet: Fleet, into: int = 1) -> Fleet:
    """Compose the processes of each host into ``into`` processes, unless a host has fewer."""
    groups = []
    for group in fleet.groups:
        count = min(into, group.processes)
        each = group.processes / count
        sums = {name: each * getattr(group, name) for name in ("endpoints", "shared")}
        nodes = None if group.nodes is None else each * group.nodes
        whole = group if each == 1 else replace(group, processes=count, nodes=nodes, **sums)
        groups.append(whole)
    return replace(fleet, groups=tuple(groups))


def split_hosts(fleet: Fleet, count: int) -> tuple[Fleet, ...]:
    """Distribute hosts over parts in turn; raise a ValueError if hosts are fewer than parts."""
    _checks.number("parts", count, 1, int(sum(group.hosts for group in fleet.groups)))
    parts: list[list[HostGroup]] = [[] for _ in range(count)]
    dealt = 0
    for group in fleet.groups:
        for index, part in enumerate(parts):
            hosts = len(range((index - dealt) % count, int(group.hosts), count))
            if hosts:
                part.append(replace(group, hosts=hosts))
        dealt += int(group.hosts)
    return tuple(replace(fleet, groups=tuple(part)) for part in parts)


def group_suffix(group: HostGroup) -> str:
    """Return ' of "GROUP"' for a group with a name, else an empty string."""
    return f' of "{group.name}"' if group.name else ""


def hosts_in_words(count: float, name: str) -> str:
    """Return a number of hosts of a group, in the plural if its name surely is a singular."""
    plurals = {row["robot"]: row["plural"] for row in read_data("fleets/robots.csv")}
    many = plurals.get(name, name + "s" * bool(_TAKES_S.search(name)))
    return f"{count:,.10g} {name if count == 1 else many}"
