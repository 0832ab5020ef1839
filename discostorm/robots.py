"""Ready-made robots: their processes and endpoints, from ``data/fleets/robots.csv``."""

from discostorm.data import read_data
from discostorm.fleet import HostGroup, robot_group
from discostorm.ros2 import (
    endpoints_of_a_node as endpoints_of_a_node,
    likely_nodes as likely_nodes,
    parameter_service_endpoints as parameter_service_endpoints,
    robot_aliases,
    robot_parts,
    shared_endpoints as shared_endpoints,
)

aliases, robot = robot_aliases, robot_group


def robots() -> dict[str, HostGroup]:
    """Return a group of one host for each ready-made robot, by its name."""
    return {name: robot_group(name) for name in robot_parts()}


def laptop() -> HostGroup:
    """Return an operator's laptop: RViz with the panel of Nav2 (``fleets/rviz_endpoints.csv``)."""
    parts = read_data("fleets/rviz_endpoints.csv")
    endpoints = sum(int(part["how_many"]) * int(part["endpoints_each"]) for part in parts)
    nodes = sum(int(part["how_many"]) for part in parts if "rclcpp node" in part["part"])
    return HostGroup(1, 1, endpoints, "laptop", nodes, shared_endpoints(nodes))
