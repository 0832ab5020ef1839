"""Ready-made robots: their processes and endpoints, from ``data/fleets/robots.csv``."""

from discostorm.fleet import HostGroup, laptop as laptop, robot_group
from discostorm.ros2_endpoints import (
    endpoints_per_node as endpoints_per_node,
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
