"""Quantities of the lab's captures: what products sent, relative to what the paper counts."""

from collections.abc import Callable
from statistics import median
from typing import Any

import numpy as np

from discostorm.messages import Message
from discostorm.protocols import DDS, PROTOCOLS, ZENOH
from discostorm_book import lab_counts


def _counted(product: str, message: str) -> Message:
    """Return the paper's message of this name for a product."""
    return (DDS if PROTOCOLS[product].family == "DDS" else ZENOH).message(message)


def _sent(product: str, message: str) -> list[float]:
    """Return, for each swarm with such messages, how many were sent for one of the paper's."""
    return lab_counts.startup_ratios(product, _counted(product, message))


def _startup_keys(point: lab_counts.Point) -> list[lab_counts.Key]:
    """Return what was counted at the start, each message once."""
    return [key for key in point.runs if key[0] == "startup" and not key[2]]


def _startup(point: lab_counts.Point) -> list[float]:
    """Return the messages and the frames of a start."""
    counts = [point.median(key)[:2] for key in _startup_keys(point)]
    return [float(sum(column)) for column in zip(*counts, strict=True)]


def sent_for_counted(product: str, message: str) -> float:
    """Return how many of a message a start has for one that the paper counts: the median swarm."""
    return median(_sent(product, message))


def matching_ratio(product: str) -> float:
    """Return a start's messages with matching names to those with unique ones, in the median."""
    sent = {point.name: _startup(point)[0] for point in lab_counts.points(product)}
    swarms = [name[:-1] for name in sent if name[-1] == "m" and f"{name[:-1]}u" in sent]
    return median(sent[f"{swarm}m"] / sent[f"{swarm}u"] for swarm in swarms)


def run_scatter(product: str) -> float:
    """Return the largest ratio of messages between two runs of the same swarm."""
    ratios = []
    for point in lab_counts.points(product):
        runs = np.sum([point.runs[key][:, 0] for key in _startup_keys(point)], axis=0)
        ratios.append(float(runs.max() / runs.min()))
    return max(ratios)


def sessions_per_pair(product: str) -> float:
    """Return how many sessions a start opens for each two processes: the median swarm."""
    opened = ("startup", "Open", "OpenSyn", "unicast", "")
    ordered = ZENOH.message("Hello").unit
    return median(
        2 * float(point.median(opened)[0]) / float(ordered.count(point.fleet))
        for point in lab_counts.points(product)
    )


def repeats(product: str, message: str) -> float:
    """Return how often a process multicasts a message in the steady state: the least swarm."""
    counted = _counted(product, message)
    key = ("steady", counted.kind, "", "multicast", "")
    return min(
        float(point.median(key)[0]) / float(counted.load(point.fleet))
        for point in lab_counts.points(product)
    )


#: Those of the median swarm, but for `sent_spread`: the largest ratio relative to the least.
FORMULAS: dict[str, Callable[..., Any]] = {
    "sent_spread": lambda *message: max(_sent(*message)) / min(_sent(*message)),
    "sent_ratio": lambda product, message, *other: (
        sent_for_counted(product, message) / sent_for_counted(*other)
    ),
    "messages_per_frame": lambda product: median(
        messages / frames for messages, frames in map(_startup, lab_counts.points(product))
    ),
    # Half the range of the mean payload of the swarms, relative to the median swarm.
    "captured_payload_spread": lambda product, message: (
        float(np.ptp(sizes := lab_counts.payloads(product, message))) / 2 / median(sizes)
    ),
    # The time between two such messages of a process [s].
    "period": lambda *message: (
        -float(np.subtract(*lab_counts.WINDOWS["steady"])) / repeats(*message)
    ),
}
