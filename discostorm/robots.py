"""Ready-made robots: what runs on them, added up from ``data/fleets/robots.csv``."""

from discostorm import _checks, _names
from discostorm.data import read_data
from discostorm.fleet import HostGroup
from discostorm.ros2 import (
    endpoints_of_a_node as endpoints_of_a_node,
    likely_nodes as likely_nodes,
    parameter_service_endpoints as parameter_service_endpoints,
    shared_endpoints as shared_endpoints,
)


def robots() -> dict[str, HostGroup]:
    """Return a group of one host for each ready-made robot, by its name.

    Its endpoints are the mean over its processes, which suffices to count pairs.
    """
    return {
        name: _host(name, [row for row in read_data("fleets/robots.csv") if row["robot"] == name])
        for name in dict.fromkeys(row["robot"] for row in read_data("fleets/robots.csv"))
    }


def aliases() -> dict[str, str]:
    """Return the names of robots by other names that people use (``fleets/aliases.csv``)."""
    return {row["alias"]: row["robot"] for row in read_data("fleets/aliases.csv")}


def robot(name: str) -> HostGroup:
    """Return a group of one ready-made robot, such as `robot("turtlebot4")`; see `_names.key`."""
    groups = robots()
    full_name = _names.meant(name, groups, aliases())
    if full_name is None:
        like = _names.did_you_mean(name, (*groups, *aliases()))
        raise ValueError(
            f"robot must be the name of a ready-made one; got {_checks.shorten_name(name)!r}{like}"
        )
    return groups[full_name]


def laptop() -> HostGroup:
    """Return an operator's laptop: RViz with the panel of Nav2 (``fleets/rviz_endpoints.csv``)."""
    parts = read_data("fleets/rviz_endpoints.csv")
    endpoints = sum(int(part["how_many"]) * int(part["endpoints_each"]) for part in parts)
    nodes = sum(int(part["how_many"]) for part in parts if "rclcpp node" in part["part"])
    return HostGroup(1, 1, endpoints, "laptop", nodes, shared_endpoints(nodes))


def _host(name: str, parts: list[dict[str, str]]) -> HostGroup:
    processes, endpoints, nodes = (
        float(sum(int(part[count]) for part in parts))
        for count in ("processes", "endpoints", "nodes")
    )
    nodes /= processes
    return HostGroup(1, processes, endpoints / processes, name, nodes, shared_endpoints(nodes))
