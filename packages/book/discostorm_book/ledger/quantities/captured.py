"""Quantities of the lab's captures: messages of products, relative to the paper's counts."""

from collections.abc import Callable
from statistics import median
from typing import Any

import numpy as np

from discostorm.protocols import ZENOH
from discostorm_book import lab_counts
from discostorm_book.lab_counts import WINDOWS, paper_protocol_of_product


def _startup_keys(point: lab_counts.GridPoint) -> list[lab_counts.CountKey]:
    """Return the keys of the startup counts, each message once."""
    return [key for key in point.runs if key[0] == "startup" and not key[2]]


def _messages_and_frames(point: lab_counts.GridPoint) -> list[float]:
    """Return the messages and the frames of a start."""
    counts = [point.median(key)[:2] for key in _startup_keys(point)]
    return [float(sum(column)) for column in zip(*counts, strict=True)]


def sent_for_counted(product: str, message: str) -> float:
    """Return the messages sent for each one that the paper counts, in the median swarm."""
    return median(lab_counts.sent_over_counted(product, message))


def matching_ratio(product: str) -> float:
    """Return the ratio of startup messages, matching over unique names, in the median swarm."""
    sent = {point.name: _messages_and_frames(point)[0] for point in lab_counts.grid_points(product)}
    swarms = [name[:-1] for name in sent if name[-1] == "m" and f"{name[:-1]}u" in sent]
    return median(sent[f"{swarm}m"] / sent[f"{swarm}u"] for swarm in swarms)


def run_scatter(product: str) -> float:
    """Return the largest ratio of messages between two runs of the same swarm."""
    ratios = []
    for point in lab_counts.grid_points(product):
        runs = np.sum([point.runs[key][:, 0] for key in _startup_keys(point)], axis=0)
        ratios.append(float(runs.max() / runs.min()))
    return max(ratios)


def sessions_per_pair(product: str) -> float:
    """Return the sessions opened for each pair of processes, in the median swarm."""
    opened = ("startup", "Open", "OpenSyn", "unicast", "")
    ordered = ZENOH.message("Hello").unit
    return median(
        2 * float(point.median(opened)[0]) / float(ordered.count(point.fleet))
        for point in lab_counts.grid_points(product)
    )


def repeats(product: str, message: str) -> float:
    """Return how often a process repeats a multicast in the steady state, in the lowest swarm."""
    counted = paper_protocol_of_product(product).message(message)
    key = ("steady", counted.kind, "", "multicast", "")
    return min(
        float(point.median(key)[0]) / float(counted.load(point.fleet))
        for point in lab_counts.grid_points(product)
    )


#: Quantities of the median swarm; `sent_spread` is the largest ratio relative to the smallest.
FORMULAS: dict[str, Callable[..., Any]] = {
    "sent_spread": lambda *message: (
        max(lab_counts.sent_over_counted(*message)) / min(lab_counts.sent_over_counted(*message))
    ),
    "sent_ratio": lambda product, message, *other: (
        sent_for_counted(product, message) / sent_for_counted(*other)
    ),
    "messages_per_frame": lambda product: median(
        messages / frames
        for messages, frames in map(_messages_and_frames, lab_counts.grid_points(product))
    ),
    # Half the range of the mean payload of the swarms, relative to the median swarm.
    "captured_payload_spread": lambda product, message: (
        float(np.ptp(sizes := lab_counts.mean_payloads(product, message))) / 2 / median(sizes)
    ),
    # The time between two such messages of a process [s].
    "period": lambda *message: -float(np.subtract(*WINDOWS["steady"])) / repeats(*message),
}
