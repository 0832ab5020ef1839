"""The picture that a link to the book shows: a swarm half way through its storm."""

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from discostorm import figures, words
from discostorm._numeric import evaluate
from discostorm.messages import Protocol
from discostorm.palette import lights
from discostorm.saturation import saturation_hosts
from discostorm.wifi import PAPER
from discostorm_book.enumeration import Endpoint, Process, Sent, walk

_NEUTRAL = lights("neutral")


def preview(protocol: Protocol, size: tuple[int, int]) -> Figure:
    """Draw the picture of a link to the book, of that width and height [px]."""
    hosts = words.whole_below(float(saturation_hosts(protocol, *_SWARM)))
    sent, used = _carried(protocol, hosts, *_SWARM)
    last = len(sent) // 2
    with figures.style():
        figure = Figure(figsize=(size[0] / 100, size[1] / 100), dpi=100)
        figure.set_layout_engine("none")
        figure.text(0.06, 0.78, "Discovery Storm", fontsize=44, weight="bold", va="center")
        figure.text(
            0.06,
            0.53,
            "How many ROS 2 robots fit\non a Wi-Fi channel before\ntheir search for each other\n"
            "fills the channel?",
            fontsize=24,
            va="center",
            linespacing=1.4,
        )
        _draw(figure.add_axes((0.55, 0.2, 0.42, 0.76)), protocol, sent, last, hosts, scale=2.4)
        _bar(figure.add_axes((0.06, 0.1, 0.88, 0.06)), protocol, float(used[last]))
        figure.text(
            0.06, 0.22, f"{hosts} robots, {words.duration(used[last])} of one second", fontsize=18
        )
    return figure


#: Processes and endpoints of the paper's Fig. 2.
_SWARM = (figures.FIG2_PROCESSES, figures.FIG2_ENDPOINTS)


def _carried(protocol: Protocol, *swarm: int) -> tuple[list[Sent], NDArray[np.float64]]:
    """Return the messages in their order, and the airtime used after each [s]."""
    hosts, processes, endpoints = swarm
    walked = walk(protocol.name, [[endpoints] * processes] * hosts)
    sent = [message for message in walked if message.hop == "up"]
    values = protocol.values() | PAPER.values()
    cost = {
        m.name: sum(float(evaluate(hop(), values)) for hop in (m.airtime_up, m.airtime_down))
        for m in protocol.messages
    }
    return sent, np.cumsum([cost[message.kind] for message in sent])


def _where(hosts: int) -> list[tuple[float, float]]:
    angles = [2 * np.pi * index / hosts + np.pi / 2 for index in range(hosts)]
    return [(float(np.cos(angle)), float(np.sin(angle))) for angle in angles]


def _draw(
    axes: Axes, protocol: Protocol, sent: list[Sent], last: int, hosts: int, scale: float = 1
) -> None:
    color = figures.color_of(protocol)
    places = _where(hosts)
    for age, one in enumerate(reversed(sent[max(0, last - 11) : last + 1])):
        ends = [one.sender.host]
        ends += [one.receiver.host] if isinstance(one.receiver, Process) else range(1, hosts + 1)
        for end in ends:
            x, y = places[end - 1]
            axes.plot((0, x), (0, y), color=color, alpha=0.9 - 0.07 * age, lw=1.4 * scale, zorder=1)
    told, whole = _heard(sent[: last + 1], hosts), _heard(sent, hosts)
    ring: dict[str, Any] = {"marker": "o", "mec": _NEUTRAL["gray"], "mew": scale, "ms": 13 * scale}
    for host, (x, y) in enumerate(places):
        share = told[host] / whole[host] if whole[host] else 1.0
        axes.plot(x, y, color="white", zorder=2, **ring)
        axes.plot(x, y, "o", color=color, ms=13 * scale * share**0.5, mew=0, zorder=3)
    axes.plot(0, 0, "s", color=_NEUTRAL["charcoal"], ms=12 * scale, zorder=4)
    axes.text(0, 0, "AP", color="white", ha="center", va="center", fontsize=7 * scale, zorder=5)
    axes.set(xlim=(-1.25, 1.25), ylim=(-1.25, 1.25), aspect="equal")
    axes.axis("off")


def _heard(sent: list[Sent], hosts: int) -> list[int]:
    """Return how many endpoints each host has been told of."""
    told = [0] * hosts
    for one in sent:
        if isinstance(one.about, Endpoint) and isinstance(one.receiver, Process):
            told[one.receiver.host - 1] += 1
    return told


def _bar(axes: Axes, protocol: Protocol, used: float) -> None:
    axes.barh(0, 1, color="white", edgecolor=_NEUTRAL["gray"])
    axes.barh(0, min(used, 1), color=figures.color_of(protocol))
    axes.set(xlim=(0, 1), yticks=[], xticks=[])
    axes.spines[:].set_visible(False)
