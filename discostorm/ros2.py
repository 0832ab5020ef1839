"""What ROS 2 itself makes for each process and node, from tables of ``data/fleets/``."""

from functools import cache

from discostorm import _checks
from discostorm.data import read_data


def parameter_service_endpoints() -> int:
    """Return how many endpoints the parameter services of a node have [1]."""
    return sum(int(row["endpoints"]) for row in read_data("fleets/parameter_services.csv"))


def shared_endpoints(nodes: float = 0.0) -> float:
    """Return how many endpoints of a ROS 2 process match one in every other, whatever its names.

    Those of topics whose names no ROS 2 namespace changes: a writer and a reader of
    ``ros_discovery_info`` for each process, and of ``/parameter_events`` for each of its nodes
    (``fleets/shared_topics.csv``, with sources). It is assumed that ``/tf`` and the like are
    remapped into the namespace, and that nobody subscribes to ``/rosout``.

    Parameters
    ----------
    nodes : float, optional
        Nodes in the process [1]; 0 if left out, as of one that rclcpp did not make.

    Returns
    -------
    float
        How many [1].

    Examples
    --------
    >>> from discostorm.ros2 import shared_endpoints
    >>> shared_endpoints(), shared_endpoints(nodes=13)
    (2.0, 28.0)
    """
    per = {"process": 1.0, "node": _checks.number("nodes", nodes, 0, _checks.MOST)}
    rows = read_data("fleets/shared_topics.csv")
    return sum(per[row["per"]] * int(row["endpoints"]) for row in rows)


def likely_nodes(endpoints: float) -> float:
    """Return how many nodes a process of so many endpoints has if nobody says: as ready-made ones.

    At least one where the endpoints are enough for its parameter services, else none; more in the
    ratio of all processes of ``fleets/robots.csv`` that have nodes.

    Parameters
    ----------
    endpoints : float
        Endpoints of the process [1].

    Returns
    -------
    float
        How many [1].

    Examples
    --------
    >>> likely_nodes(10), likely_nodes(20), round(likely_nodes(678))
    (0.0, 1.0, 24)
    """
    given = _checks.number("endpoints", endpoints, 0, _checks.MOST)
    if given < parameter_service_endpoints():
        return 0.0
    return max(1.0, given / endpoints_of_a_node())


@cache
def endpoints_of_a_node() -> float:
    """Return how many endpoints the processes of ready-made robots have for each node [1]."""
    rows = [row for row in read_data("fleets/robots.csv") if int(row["nodes"])]
    return sum(int(row["endpoints"]) for row in rows) / sum(int(row["nodes"]) for row in rows)


def usually_shared(endpoints: float, nodes: float | None = None) -> float:
    """Return how many of a process's endpoints are those of `shared_endpoints` [1].

    Where its nodes are not known they are the likely ones; it never shares more than it has.
    """
    many = likely_nodes(endpoints) if nodes is None else nodes
    return min(shared_endpoints(many), endpoints)


def check_nodes(name: str, nodes: float, endpoints: float) -> None:
    """Raise a ValueError unless a process of so many endpoints can have so many nodes."""
    each = parameter_service_endpoints()
    if nodes * each > endpoints:
        raise ValueError(
            f"{name} must be at most {endpoints / each:g} for processes of {endpoints:g} "
            f"endpoints, as the parameter services of a node have {each}; got {nodes:g}"
        )
