"""Fleets from what ``ros2 node list``, ``ros2 node info`` and ``ros2 topic list -v`` print.

``data/fleets/ros2_formats.csv`` has the formats, with the source code that prints them, and says
whether one was ever tried on a live system; ``ros2_entities.csv`` has the endpoints of each entry.
"""

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field

from discostorm import _checks
from discostorm.data import read_data
from discostorm.fleet import Fleet, HostGroup
from discostorm.ros2 import parameter_service_endpoints, shared_endpoints, usually_shared

#: What each node of rclcpp or rclpy has beside its parameter services: a publisher of /rosout, a
#: publisher and a subscription of /parameter_events (``rviz_endpoints.csv``).
_BESIDE_SERVICES = 3
#: What a text may hold beside the answers: prompts, warnings, and nothing.
_PASSED_OVER = re.compile(r"\s*$|[$#>]|WARNING: Be aware|There are \d+ nodes in the graph")
#: Of `ros2 node info`: an entry, and what is no topic but part of an action or hidden.
_ENTRY, _HIDDEN = re.compile(r"    (/\S*): \S"), re.compile(r"/_")
#: Of `ros2 topic list -v`.
_TOPIC = re.compile(r" \* (/\S*) \[.*\] (\d+) (publisher|subscriber)s?$")
_SERVICE = "describe_parameters"


@dataclass(frozen=True)
class Seen:
    """What a text of ROS 2 tells.

    Parameters
    ----------
    nodes : dict
        By the full name of each node its endpoints [1], None if only the list names it.
    services : set of str
        Nodes with parameter services.
    topics : dict
        By "publisher" and "subscriber" the endpoints of each topic [1].
    commands : list of str
        Whose text it is.
    """

    nodes: dict[str, int | None] = field(default_factory=dict)
    services: set[str] = field(default_factory=set)
    topics: dict[tuple[str, str], int] = field(default_factory=dict)
    commands: list[str] = field(default_factory=list)


def read_text(text: str, name: str) -> Seen:
    """Read what ``ros2 node list``, ``ros2 node info`` and ``ros2 topic list -v`` printed.

    Parameters
    ----------
    text : str
        One or several answers, one after the other in any order; lines that begin with ``$`` or
        ``#`` are passed over.
    name : str
        What messages call it.

    Returns
    -------
    Seen
        Nodes and topics, without hidden ones.

    Raises
    ------
    ValueError
        If a line is none of these formats; the message has its number.
    """
    formats = {
        row["command"]: re.compile(row["line"]) for row in read_data("fleets/ros2_formats.csv")
    }
    endpoints = {
        row["section"]: int(row["endpoints"]) for row in read_data("fleets/ros2_entities.csv")
    }
    seen, node, section = Seen(), "", ""
    for number, line in enumerate(text.removeprefix("\ufeff").splitlines(), start=1):
        kind = next((key for key, form in formats.items() if form.fullmatch(line.rstrip())), "")
        entry, topic = _ENTRY.match(line), _TOPIC.match(line.rstrip())
        if kind == "ros2 node list":
            node, section = line.strip(), ""
            seen.nodes.setdefault(node, None)
        elif kind == "ros2 node info" and node:
            section = line.strip(" :\r\n")
            seen.nodes[node] = seen.nodes[node] or 0
        elif entry and node and section:
            if not _HIDDEN.search(entry[1]):
                seen.nodes[node] = (seen.nodes[node] or 0) + endpoints[section]
                if section == "Service Servers" and entry[1].endswith(f"/{_SERVICE}"):
                    seen.services.add(node)
        elif kind == "ros2 topic list -v":
            node = section = ""
        elif topic and not node:
            seen.topics[topic[1], topic[3]] = int(topic[2])
        elif not _PASSED_OVER.match(line):
            raise ValueError(f"{name}, line {number}: {_what_is_wrong(line)}")
        if (
            found := kind or ("ros2 topic list -v" if topic else "")
        ) and found not in seen.commands:
            seen.commands.append(found)
    for hidden in [one for one in seen.nodes if _HIDDEN.search(one)]:
        del seen.nodes[hidden]
    if not seen.nodes and not seen.topics:
        raise ValueError(
            f"{name} must hold the text of {_commands()}; it names no node and no topic"
        )
    return seen


def _commands() -> str:
    return " or ".join(f"`{row['command']}`" for row in read_data("fleets/ros2_formats.csv"))


def _what_is_wrong(line: str) -> str:
    if line.strip() == "Services:":
        return (
            "'Services:' is how `ros2 node info` printed in ROS 2 Crystal and Dashing, which tell "
            "neither clients nor actions. Run it in ROS 2 Eloquent or later"
        )
    told = ", ".join(
        f"`{row['command']}` ({row['releases']})" for row in read_data("fleets/ros2_formats.csv")
    )
    return (
        f"{_checks.short(line.strip())} is not how any of these prints: {told}. "
        "Give their text alone, without other commands"
    )


def fleet_of(
    seen: Seen, hosts: float | None = None, processes: float | None = None
) -> tuple[Fleet, list[str]]:
    """Return the fleet that a text tells of, and notes on what it does not tell.

    Parameters
    ----------
    seen : Seen
        What `read_text` returned.
    hosts : float, optional
        All nodes are those of one robot, and there are so many [1]; if left out, namespaces that
        have nodes of the same names are a robot each.
    processes : float, optional
        Processes on each robot [1]; if left out, each node has one of its own.

    Returns
    -------
    Fleet
        Robots of equal counts in one group.
    list of str
        What was assumed.

    Raises
    ------
    ValueError
        If there are more processes than nodes.
    """
    notes = list(_untold(seen))
    if not seen.nodes:
        robots = {"": _of_topics(seen)}
    else:
        robots = {
            name: (
                len(nodes),
                sum(_endpoints(seen, node) for node in nodes),
                sum(seen.nodes[node] is None or node in seen.services for node in nodes),
            )
            for name, nodes in _robots(seen.nodes, hosts is not None).items()
        }
    if len(robots) > 1:
        spaces = len([name for name in robots if name])
        notes.append(
            f"Namespaces with nodes of the same names are taken for {spaces} robots. "
            "If all nodes are one robot's, say how many robots there are with --hosts"
        )
    elif hosts is None:
        notes.append("All nodes are taken for one robot's. --hosts says how many robots there are")
    if processes is None:
        notes.append(
            "ROS 2 does not tell which nodes share a process: each is counted as one of its own, "
            "which is the most. --processes says how many there are on each robot"
        )
    groups: dict[tuple[float, float, float], list[str]] = {}
    for name, (nodes, endpoints, with_services) in robots.items():
        many = float(nodes) if processes is None else processes
        if many > nodes:
            raise ValueError(
                f"--processes must be at most the {nodes} nodes of a robot; got {many:g}"
            )
        # What each participant has beside its nodes.
        each = endpoints / many + shared_endpoints(0)
        groups.setdefault((many, each, with_services / many), []).append(name)
    rest = "robots" if len(robots) == 1 else "others"
    made = [
        _group([name or rest for name in names], hosts, *counts) for counts, names in groups.items()
    ]
    return Fleet(tuple(made)), notes


def _group(
    names: list[str], hosts: float | None, processes: float, endpoints: float, nodes: float
) -> HostGroup:
    many = len(names) if hosts is None else hosts
    name = names[0] if len(names) == 1 else f"{names[0]} to {names[-1]}"
    shared = usually_shared(endpoints, nodes)
    return HostGroup(many, processes, endpoints, name, nodes, shared)


def _endpoints(seen: Seen, node: str) -> int:
    told = seen.nodes[node]
    return parameter_service_endpoints() + _BESIDE_SERVICES if told is None else told


def _robots(nodes: Iterable[str], together: bool) -> dict[str, list[str]]:
    """Return nodes by robot; those of none stand under the empty name, unless all are together."""
    split = {node: node.strip("/").partition("/") for node in nodes}
    spaces: dict[str, set[str]] = {}
    for first, _, rest in split.values():
        if rest:
            spaces.setdefault(first, set()).add(rest)
    alike = {
        one
        for one, names in spaces.items()
        if any(names & others for other, others in spaces.items() if other != one)
    }
    found: dict[str, list[str]] = {}
    for node, (first, _, rest) in split.items():
        own = first if rest and first in alike and not together else ""
        found.setdefault(own, []).append(node)
    return found


def _of_topics(seen: Seen) -> tuple[int, int, int]:
    """Return nodes, endpoints and nodes with services where only topics are told."""
    # Every node of rclcpp and rclpy publishes /rosout.
    nodes = max(1, seen.topics.get(("/rosout", "publisher"), 0))
    return nodes, sum(seen.topics.values()) + nodes * parameter_service_endpoints(), nodes


def _untold(seen: Seen) -> Iterator[str]:
    if not seen.nodes:
        yield (
            "The topics alone name no node: there are as many as publish /rosout, each with its "
            "parameter services. Other services and actions are not counted"
        )
    listed = [node for node, endpoints in seen.nodes.items() if endpoints is None]
    if listed:
        least = parameter_service_endpoints() + _BESIDE_SERVICES
        yield (
            f"{len(listed)} of {len(seen.nodes)} nodes have no `ros2 node info`: each is counted "
            f"with {least} endpoints, the least that a node has"
        )
    if seen.nodes and len(listed) < len(seen.nodes):
        yield (
            "`ros2 node info` names a topic once, however many publishers or subscriptions a node "
            "has of it"
        )


def tried(seen: Seen) -> str:
    """Return which formats were read, and which of them nobody tried on a live system."""
    rows = [row for row in read_data("fleets/ros2_formats.csv") if row["command"] in seen.commands]
    named = ", ".join(f"`{row['command']}` ({row['releases']})" for row in rows)
    never = [f"`{row['command']}`" for row in rows if row["tried"] == "no"]
    if not never:
        return f"Read: {named}"
    return (
        f"Read: {named}. Never tried on a live system: {', '.join(never)}; the format is that of "
        "ros2cli's source code"
    )
