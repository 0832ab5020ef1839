"""Read fleets from the output of ``ros2 node list``, ``ros2 node info`` and ``ros2 topic list -v``.

``data/fleets/ros2_formats.csv`` lists the formats with the source code that prints them, and
whether we tried them on a live system. ``ros2_entities.csv`` lists the endpoints of each entry.
"""

import re
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field

from discostorm import _checks
from discostorm.data import read_data
from discostorm.fleet import Fleet, HostGroup
from discostorm.ros2_endpoints import likely_shared, parameter_service_endpoints, shared_endpoints

#: Endpoints of a node of rclcpp or rclpy without its parameter services: a publisher of /rosout, a
#: publisher and a subscription of /parameter_events (``rviz_endpoints.csv``).
_ENDPOINTS_WITHOUT_SERVICES = 3
#: Lines to ignore: prompts, warnings, and empty lines.
_IGNORED_LINE = re.compile(r"\s*$|[$#>]|WARNING: Be aware|There are \d+ nodes in the graph")
#: Patterns of `ros2 node info`: an entry, and names of actions or hidden topics to skip.
_ENTRY_LINE, _HIDDEN_NAME = re.compile(r"    (/\S*): \S"), re.compile(r"/_")
#: Patterns of `ros2 topic list -v`.
_TOPIC_LINE = re.compile(r" \* (/\S*) \[.*\] (\d+) (publisher|subscriber)s?$")
_PARAMETER_SERVICE = "describe_parameters"


@dataclass(frozen=True)
class Ros2Graph:
    """Nodes and topics in a text that ROS 2 printed."""

    #: Endpoints of each node by its full name [1]; None if only ``ros2 node list`` names the node.
    nodes: dict[str, int | None] = field(default_factory=dict)
    #: Nodes with parameter services.
    services: set[str] = field(default_factory=set)
    #: Endpoints by topic, and by "publisher" or "subscriber" [1].
    topics: dict[tuple[str, str], int] = field(default_factory=dict)
    #: Commands that printed the text.
    commands: list[str] = field(default_factory=list)


def parse_ros2_output(text: str, name: str) -> Ros2Graph:
    """Parse the output of ROS 2 commands, in any order, without hidden nodes and topics.

    Lines that begin with ``$`` or ``#`` are ignored. For a line in no known format, raise a
    ValueError with the ``name`` of the text and the line number.
    """
    formats = {
        row["command"]: re.compile(row["line"]) for row in read_data("fleets/ros2_formats.csv")
    }
    endpoints = {
        row["section"]: int(row["endpoints"]) for row in read_data("fleets/ros2_entities.csv")
    }
    graph, node, section = Ros2Graph(), "", ""
    for number, line in enumerate(text.removeprefix("\ufeff").splitlines(), start=1):
        kind = next((key for key, form in formats.items() if form.fullmatch(line.rstrip())), "")
        entry, topic = _ENTRY_LINE.match(line), _TOPIC_LINE.match(line.rstrip())
        if kind == "ros2 node list":
            node, section = line.strip(), ""
            graph.nodes.setdefault(node, None)
        elif kind == "ros2 node info" and node:
            section = line.strip(" :\r\n")
            graph.nodes[node] = graph.nodes[node] or 0
        elif entry and node and section:
            if not _HIDDEN_NAME.search(entry[1]):
                graph.nodes[node] = (graph.nodes[node] or 0) + endpoints[section]
                if section == "Service Servers" and entry[1].endswith(f"/{_PARAMETER_SERVICE}"):
                    graph.services.add(node)
        elif kind == "ros2 topic list -v":
            node = section = ""
        elif topic and not node:
            graph.topics[topic[1], topic[3]] = int(topic[2])
        elif not _IGNORED_LINE.match(line):
            raise ValueError(f"{name}, line {number}: {_format_error(line)}")
        command = kind or ("ros2 topic list -v" if topic else "")
        if command and command not in graph.commands:
            graph.commands.append(command)
    for hidden in [name for name in graph.nodes if _HIDDEN_NAME.search(name)]:
        del graph.nodes[hidden]
    if not graph.nodes and not graph.topics:
        commands = " or ".join(f"`{command}`" for command in formats)
        raise ValueError(f"{name} must hold the output of {commands}; it names no node or topic")
    return graph


def _format_error(line: str) -> str:
    if line.strip() == "Services:":
        return (
            "`ros2 node info` in ROS 2 Crystal and Dashing prints 'Services:', but neither clients "
            "nor actions. Run it in ROS 2 Eloquent or later"
        )
    return (
        f"{_checks.short_repr(line.strip())} is not the output of any of these commands: "
        f"{_describe(read_data('fleets/ros2_formats.csv'))}. "
        "Give only the output of these commands"
    )


def _describe(formats: Iterable[dict[str, str]]) -> str:
    return ", ".join(f"`{row['command']}` ({row['releases']})" for row in formats)


def fleet_from_graph(
    graph: Ros2Graph, hosts: float | None = None, processes: float | None = None
) -> tuple[Fleet, list[str]]:
    """Return the fleet that a text describes, and notes on the assumptions about missing facts.

    With ``hosts``, each of this many hosts runs all nodes. By default, each namespace is a robot if
    another namespace has equal node names. ``processes`` is the number on each host: at most, and
    by default, one per node.
    """
    notes = list(_uncertainty_notes(graph))
    robots = {"": _count_from_topics(graph)}
    if graph.nodes:
        counts = {n: _min_endpoints() if e is None else e for n, e in graph.nodes.items()}
        served = {n for n, e in graph.nodes.items() if e is None or n in graph.services}
        robots = {
            name: (len(nodes), sum(counts[node] for node in nodes), len(served.intersection(nodes)))
            for name, nodes in _nodes_of_robots(graph.nodes, hosts is not None).items()
        }
    if len(robots) > 1:
        spaces = len([name for name in robots if name])
        notes.append(
            f"{spaces} namespaces have the same node names, so we count {spaces} robots. "
            "If all nodes belong to one robot, set the number of such robots with --hosts"
        )
    elif hosts is None:
        notes.append("We count all nodes as one robot. To set the number of robots, use --hosts")
    if processes is None:
        notes.append(
            "ROS 2 does not say which nodes share a process, so we count one process per node, the "
            "maximum. To set the number of processes on each robot, use --processes"
        )
    groups: dict[tuple[float, float, float], list[str]] = {}
    for name, (nodes, endpoints, with_services) in robots.items():
        many = float(nodes) if processes is None else processes
        if many > nodes:
            raise ValueError(f"--processes must be at most {nodes}, the node count; got {many:g}")
        # Endpoints that each participant has in addition to its nodes.
        each = endpoints / many + shared_endpoints(0)
        rest = "robots" if len(robots) == 1 else "others"
        groups.setdefault((many, each, with_services / many), []).append(name or rest)
    made = []
    for (many, each, own), names in groups.items():
        count = len(names) if hosts is None else hosts
        name = names[0] if len(names) == 1 else f"{names[0]} to {names[-1]}"
        made.append(HostGroup(count, many, each, name, own, likely_shared(each, own)))
    return Fleet(tuple(made)), notes


def _min_endpoints() -> int:
    """Return the fewest endpoints of a node."""
    return parameter_service_endpoints() + _ENDPOINTS_WITHOUT_SERVICES


def _nodes_of_robots(nodes: Iterable[str], together: bool) -> dict[str, list[str]]:
    """Group nodes by robot namespace, "" for no robot; if ``together``, all under ""."""
    split = {node: node.strip("/").partition("/") for node in nodes}
    uses = Counter(rest for _, _, rest in split.values())
    namespaces = {first for first, _, rest in split.values() if rest and uses[rest] > 1}
    robots: dict[str, list[str]] = {}
    for node, (first, _, rest) in split.items():
        robot = first if rest and first in namespaces and not together else ""
        robots.setdefault(robot, []).append(node)
    return robots


def _count_from_topics(graph: Ros2Graph) -> tuple[int, int, int]:
    """Count nodes, endpoints and nodes with services in a text that lists only topics."""
    # Every node of rclcpp and rclpy publishes /rosout.
    nodes = max(1, graph.topics.get(("/rosout", "publisher"), 0))
    return nodes, sum(graph.topics.values()) + nodes * parameter_service_endpoints(), nodes


def _uncertainty_notes(graph: Ros2Graph) -> Iterator[str]:
    if not graph.nodes:
        yield (
            "A list of topics names no nodes, so we count a node for each publisher of /rosout, "
            "with parameter services. We count no other services and actions"
        )
    listed = [node for node, endpoints in graph.nodes.items() if endpoints is None]
    if listed:
        yield (
            f"{len(listed)} of {len(graph.nodes)} nodes have no `ros2 node info`, so we count "
            f"{_min_endpoints()} endpoints for each, the fewest that a node has"
        )
    if graph.nodes and len(listed) < len(graph.nodes):
        yield (
            "`ros2 node info` lists a topic only once, however many publishers or subscriptions a "
            "node has for it"
        )


def describe_formats(graph: Ros2Graph) -> str:
    """Name the formats of the text; mark formats that were never tried on a live system."""
    rows = [row for row in read_data("fleets/ros2_formats.csv") if row["command"] in graph.commands]
    told, never = f"Formats: {_describe(rows)}", [r["command"] for r in rows if r["tried"] == "no"]
    if never:
        told += f". Never tried on a live system: {', '.join(f'`{command}`' for command in never)}"
        told += "; we know their format only from the source code of ros2cli"
    return told
