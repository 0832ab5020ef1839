"""Ready-made robots: their processes and endpoints, from ``data/fleets/robots.csv``."""

from discostorm._names import Catalog
from discostorm.data import read_data
from discostorm.host_group import HostGroup, count_and_mean_endpoints, even_sizes
from discostorm.ros2_endpoints import (
    endpoints_per_node as endpoints_per_node,
    likely_nodes as likely_nodes,
    parameter_service_endpoints as parameter_service_endpoints,
    shared_endpoints as shared_endpoints,
)


def robots() -> dict[str, HostGroup]:
    """Return a group of one host for each ready-made robot, by its name."""
    return {name: robot(name) for name in _parts()}


def robot(name: str) -> HostGroup:
    """Return a group of one ready-made robot or "laptop" by its name, in any spelling of it."""
    if str(name).casefold() == "laptop":
        return laptop()
    parts = _parts().find(name)
    counts = ((int(part["processes"]), int(part["endpoints"])) for part in parts)
    sizes = tuple(size for count in counts for size in even_sizes(*count))
    nodes = sum(int(part["nodes"]) for part in parts) / count_and_mean_endpoints(sizes)[0]
    shared = shared_endpoints(nodes)
    return HostGroup(1, sizes, name=parts[0]["robot"], nodes=nodes, shared=shared)


def laptop() -> HostGroup:
    """Return an operator's laptop: RViz with the panel of Nav2 (``fleets/rviz_endpoints.csv``)."""
    parts = read_data("fleets/rviz_endpoints.csv")
    endpoints = sum(int(part["how_many"]) * int(part["endpoints_each"]) for part in parts)
    nodes = sum(int(part["how_many"]) for part in parts if "rclcpp node" in part["part"])
    return HostGroup(1, 1, endpoints, "laptop", nodes, shared_endpoints(nodes))


def aliases() -> dict[str, str]:
    """Return the names of robots by other names that people use (``fleets/aliases.csv``)."""
    return {row["alias"]: row["robot"] for row in read_data("fleets/aliases.csv")}


def _parts() -> Catalog[list[dict[str, str]]]:
    """Return the rows of ``fleets/robots.csv`` for each ready-made robot, by name or alias."""
    parts: dict[str, list[dict[str, str]]] = {}
    for row in read_data("fleets/robots.csv"):
        parts.setdefault(row["robot"], []).append(row)
    return Catalog("robot", parts, aliases())
