"""Quantities of the lab's captures: what products sent, beside what the paper counts."""

from statistics import median

import numpy as np

from discostorm.messages import Message, Protocol
from discostorm.protocols import DDS, PROTOCOLS, ZENOH
from discostorm_book import lab_counts


def sent_for_counted(product: str, message: str) -> float:
    """Return how many of a message a start has for one that the paper counts: the median swarm."""
    return median(_sent(product, message))


def sent_spread(product: str, message: str) -> float:
    """Return how many times the least of that, over the measured swarms, the most is."""
    each = _sent(product, message)
    return max(each) / min(each)


def sent_ratio(product: str, message: str, other: str, other_message: str) -> float:
    """Return how many of one product's message there are for one of another's, in the median."""
    return sent_for_counted(product, message) / sent_for_counted(other, other_message)


def matching_ratio(product: str) -> float:
    """Return how many times the messages a start has if names match instead of being unique.

    The median over the swarms that were captured both ways.
    """
    of_names: dict[str, dict[str, float]] = {"m": {}, "u": {}}
    for point in lab_counts.points(product):
        if point.name[-1] in of_names:
            of_names[point.name[-1]][point.name[:-1]] = _all_of(point)[0]
    both = of_names["m"].keys() & of_names["u"].keys()
    return median(of_names["m"][swarm] / of_names["u"][swarm] for swarm in both)


def run_scatter(product: str) -> float:
    """Return how many times the messages of another run of the same swarm a start can have."""
    ratios = []
    for point in lab_counts.points(product):
        runs = np.sum([point.runs[key][:, 0] for key in _keys(point)], axis=0)
        ratios.append(float(runs.max() / runs.min()))
    return max(ratios)


def messages_per_frame(product: str) -> float:
    """Return how many messages share a frame at the start: the median swarm."""
    starts = map(_all_of, lab_counts.points(product))
    return median(messages / frames for messages, frames in starts)


def sessions_per_pair(product: str) -> float:
    """Return how many sessions a start opens for each two processes: the median swarm."""
    opened = ("startup", "Open", "OpenSyn", "unicast", "")
    ordered = ZENOH.message("Hello").unit
    return median(
        2 * float(point.median(opened)[0]) / float(ordered.count(point.fleet))
        for point in lab_counts.points(product)
    )


def repeats(product: str, message: str) -> float:
    """Return how often a process multicasts a message in the 24 s of the steady state.

    The least of all measured swarms.
    """
    counted = _paper(product).message(message)
    key = ("steady", counted.kind, "", "multicast", "")
    return min(
        float(point.median(key)[0]) / _counted(counted, point)
        for point in lab_counts.points(product)
    )


def _paper(product: str) -> Protocol:
    """Return the paper's messages for a product."""
    return DDS if PROTOCOLS[product].family == "DDS" else ZENOH


def _counted(message: Message, point: lab_counts.Point) -> float:
    """Return how many of a message the paper counts in a swarm."""
    return float(message.per_unit) * float(message.unit.count(point.fleet))


def _sent(product: str, message: str) -> list[float]:
    """Return, for each swarm with such messages, how many were sent for one of the paper's."""
    counted = _paper(product).message(message)
    each = []
    for point in lab_counts.points(product):
        keys = [("startup", counted.kind, "", cast, "") for cast in ("unicast", "multicast")]
        if units := _counted(counted, point):
            each.append(sum(float(point.median(key)[0]) for key in keys) / units)
    return each


def _keys(point: lab_counts.Point) -> list[lab_counts.Key]:
    """Return what was counted at the start, each message once."""
    return [key for key in point.runs if key[0] == "startup" and not key[2]]


def _all_of(point: lab_counts.Point) -> tuple[float, float]:
    """Return the messages and the frames of a start."""
    counts = [point.median(key) for key in _keys(point)]
    return sum(float(count[0]) for count in counts), sum(float(count[1]) for count in counts)
