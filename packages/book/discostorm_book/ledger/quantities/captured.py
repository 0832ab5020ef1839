"""Quantities of the lab's captures: what products sent, relative to what the paper counts."""

from statistics import median

import numpy as np

from discostorm.messages import Message
from discostorm.protocols import DDS, PROTOCOLS, ZENOH
from discostorm_book import lab_counts


def sent_for_counted(product: str, message: str) -> float:
    """Return how many of a message a start has for one that the paper counts: the median swarm."""
    return median(_sent(product, message))


def sent_spread(product: str, message: str) -> float:
    """Return the largest of that ratio over the measured swarms, relative to the least."""
    return max(_sent(product, message)) / min(_sent(product, message))


def sent_ratio(product: str, message: str, other: str, other_message: str) -> float:
    """Return how many of one product's message there are for one of another's, in the median."""
    return sent_for_counted(product, message) / sent_for_counted(other, other_message)


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


def messages_per_frame(product: str) -> float:
    """Return how many messages share a frame at the start: the median swarm."""
    starts = map(_startup, lab_counts.points(product))
    return median(messages / frames for messages, frames in starts)


def captured_payload_spread(product: str, message: str) -> float:
    """Return half the range of the mean payload of the swarms, relative to the median swarm."""
    sizes = lab_counts.payloads(product, message)
    return (max(sizes) - min(sizes)) / 2 / median(sizes)


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


def period(product: str, message: str) -> float:
    """Return the time between two such messages of a process [s]."""
    begin, end = lab_counts.WINDOWS["steady"]
    return (end - begin) / repeats(product, message)


def _counted(product: str, message: str) -> Message:
    """Return the paper's message of this name for a product."""
    return (DDS if PROTOCOLS[product].family == "DDS" else ZENOH).message(message)


def _sent(product: str, message: str) -> list[float]:
    """Return, for each swarm with such messages, how many were sent for one of the paper's."""
    return lab_counts.startup_ratios(product, _counted(product, message))


def _startup_keys(point: lab_counts.Point) -> list[lab_counts.Key]:
    """Return what was counted at the start, each message once."""
    return [key for key in point.runs if key[0] == "startup" and not key[2]]


def _startup(point: lab_counts.Point) -> tuple[float, float]:
    """Return the messages and the frames of a start."""
    counts = [point.median(key) for key in _startup_keys(point)]
    return sum(float(count[0]) for count in counts), sum(float(count[1]) for count in counts)
