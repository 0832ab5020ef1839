"""The picture that a link to the book shows: a swarm half way through its storm."""

from collections import Counter
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
    hosts = words.last_integer_below(float(saturation_hosts(protocol, *_SWARM)))
    sent, used = _carried(protocol, hosts, *_SWARM)
    last = len(sent) // 2
    with figures.style():
        figure = Figure(figsize=(size[0] / 100, size[1] / 100), dpi=100)
        figure.set_layout_engine("none")
        figure.text(0.06, 0.78, "Discovery Storm", fontsize=44, weight="bold", va="center")
        question = "How many ROS 2 robots fit\non a Wi-Fi channel before\n"
        question += "their search for each other\nfills the channel?"
        figure.text(0.06, 0.53, question, fontsize=24, va="center", linespacing=1.4)
        _draw_swarm(figure.add_axes((0.55, 0.2, 0.42, 0.76)), protocol, sent, last, hosts)
        bar = figure.add_axes((0.06, 0.1, 0.88, 0.06))
        bar.barh(0, 1, color="white", edgecolor=_NEUTRAL["gray"])
        bar.barh(0, min(used[last], 1), color=figures.color_of(protocol))
        bar.set(xlim=(0, 1), yticks=[], xticks=[])
        bar.spines[:].set_visible(False)
        text = f"{hosts} robots, {words.duration(used[last])} of one second"
        figure.text(0.06, 0.22, text, fontsize=18)
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


def _draw_swarm(axes: Axes, protocol: Protocol, sent: list[Sent], last: int, hosts: int) -> None:
    """Draw the latest messages as rays, and robots filled with the endpoints that they know."""
    color, scale = figures.color_of(protocol), 2.4
    angles = 2 * np.pi * np.arange(hosts) / hosts + np.pi / 2
    places = list(zip(np.cos(angles), np.sin(angles), strict=True))
    for age, message in enumerate(reversed(sent[max(0, last - 11) : last + 1])):
        to = message.receiver
        receivers = [to.host] if isinstance(to, Process) else range(1, hosts + 1)
        for x, y in (places[host - 1] for host in (message.sender.host, *receivers)):
            axes.plot((0, x), (0, y), color=color, alpha=0.9 - 0.07 * age, lw=1.4 * scale, zorder=1)
    known, whole = _known_endpoints(sent[: last + 1]), _known_endpoints(sent)
    ring: dict[str, Any] = {"marker": "o", "mec": _NEUTRAL["gray"], "mew": scale, "ms": 13 * scale}
    for host, (x, y) in enumerate(places, start=1):
        share = known[host] / whole[host] if whole[host] else 1.0
        axes.plot(x, y, color="white", zorder=2, **ring)
        axes.plot(x, y, "o", color=color, ms=13 * scale * share**0.5, mew=0, zorder=3)
    axes.plot(0, 0, "s", color=_NEUTRAL["charcoal"], ms=12 * scale, zorder=4)
    axes.text(0, 0, "AP", color="white", ha="center", va="center", fontsize=7 * scale, zorder=5)
    axes.set(xlim=(-1.25, 1.25), ylim=(-1.25, 1.25), aspect="equal")
    axes.axis("off")


def _known_endpoints(sent: list[Sent]) -> Counter[int]:
    """Return how many endpoints were announced to each host."""
    return Counter(
        message.receiver.host
        for message in sent
        if isinstance(message.about, Endpoint) and isinstance(message.receiver, Process)
    )
