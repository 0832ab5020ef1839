"""Endpoints that ROS 2 itself creates in each process and node, from ``data/fleets/``."""

from functools import cache

from discostorm import _checks
from discostorm.data import read_data


def parameter_service_endpoints() -> int:
    """Return the endpoints of a node's parameter services [1]."""
    return sum(int(row["endpoints"]) for row in read_data("fleets/parameter_services.csv"))


def shared_endpoints(nodes: float = 0.0) -> float:
    """Return the endpoints of a ROS 2 process that match one in every other process [1].

    Endpoints on topics whose names no ROS 2 namespace changes (``fleets/shared_topics.csv``). It
    assumes that ``/tf`` and the like are remapped into the namespace, and that no host subscribes
    to ``/rosout``. A process that rclcpp did not make has 0 nodes.
    """
    per = {"process": 1.0, "node": _checks.number("nodes", nodes, 0, _checks.MAX_COUNT)}
    rows = read_data("fleets/shared_topics.csv")
    return sum(per[row["per"]] * int(row["endpoints"]) for row in rows)


def likely_nodes(endpoints: float) -> float:
    """Return the likely number of nodes in a process with that many endpoints [1].

    0 if the endpoints do not suffice for the parameter services of one node, else at least one,
    and in the ratio of the processes of ``fleets/robots.csv`` that have nodes.
    """
    given = _checks.number("endpoints", endpoints, 0, _checks.MAX_COUNT)
    if given < parameter_service_endpoints():
        return 0.0
    return max(1.0, given / endpoints_per_node())


@cache
def endpoints_per_node() -> float:
    """Return the endpoints per node in the processes of ready-made robots [1]."""
    rows = [row for row in read_data("fleets/robots.csv") if int(row["nodes"])]
    return sum(int(row["endpoints"]) for row in rows) / sum(int(row["nodes"]) for row in rows)


def likely_shared(endpoints: float, nodes: float | None = None) -> float:
    """Return `shared_endpoints` of a process, for its likely nodes if they are unknown [1]."""
    nodes = likely_nodes(endpoints) if nodes is None else nodes
    return min(shared_endpoints(nodes), endpoints)
