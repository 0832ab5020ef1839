"""What messages cost, and whom they reach: of any table of messages."""

from collections.abc import Mapping, Sequence
from itertools import count

import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import FancyArrowPatch, FancyBboxPatch, Patch, Polygon
from matplotlib.ticker import PercentFormatter

from discostorm._numeric import evaluate
from discostorm.figures.looks import MESSAGE_COLORS, WIDTH, color_of, style
from discostorm.figures.paper import PAPER_PROTOCOLS
from discostorm.fleet import Fleet
from discostorm.messages import Message, Protocol
from discostorm.wifi import PAPER


def airtime_data(protocols: Sequence[Protocol] = PAPER_PROTOCOLS) -> pd.DataFrame:
    """Return what one frame of each message costs, up and down: overhead and bits [s].

    On the paper's channel. A row a message and direction, with columns protocol, message,
    direction, overhead_s (independent of the length of the frame) and bits_s (proportional
    to it).
    """
    rows = []
    for protocol in protocols:
        values = protocol.values() | PAPER.values()
        for message in protocol.messages:
            down = PAPER.multicast if message.cast == "multicast" else PAPER.unicast
            for direction, link, expression in (
                ("up", PAPER.unicast, message.airtime_up()),
                ("down", down, message.airtime_down()),
            ):
                rows.append(
                    {
                        "protocol": protocol.name,
                        "message": message.name,
                        "direction": direction,
                        "overhead_s": link.overhead,
                        "bits_s": evaluate(expression, values) - link.overhead,
                    }
                )
    return pd.DataFrame(rows)


def airtime() -> Figure:
    """Draw what one frame of each message costs, up and down, as overhead and bits."""
    data = airtime_data()
    color = {protocol.name: color_of(protocol) for protocol in PAPER_PROTOCOLS}
    with style():
        figure = Figure(figsize=(WIDTH, 4.6))
        axis = figure.subplots()
        names = data["message"] + " " + data["direction"]
        overhead, bits = 1e6 * data["overhead_s"], 1e6 * data["bits_s"]
        colors = data["protocol"].map(color)
        axis.barh(names, overhead, color=colors, alpha=0.35)
        axis.barh(names, bits, left=overhead, color=colors)
        for row, micro in enumerate(overhead + bits):
            axis.text(micro + 6, row, f"{micro:.0f}", va="center", fontsize=8)
        axis.invert_yaxis()
        axis.grid(visible=False, axis="y")
        axis.set_xlim(0, 1.08 * (overhead + bits).max())
        axis.set_xlabel("airtime of one frame [µs]")
        axis.legend(
            handles=[
                Patch(color="gray", alpha=0.35, label="fixed overhead"),
                Patch(color="gray", label="its bits"),
            ],
            loc="lower right",
        )
        axis.set_ylabel("message and direction")
    return figure


def who_tells_whom(protocol: Protocol) -> Figure:
    """Draw the way of each message of a protocol: from one process to whom, by the access point.

    Three hosts of two processes with two endpoints each; one process sends. How many messages
    go to whom is read off the protocol's table.
    """
    swarm = Fleet.swarm(3, 2, 2)
    with style():
        rows = -(-len(protocol.messages) // 2)
        figure = Figure(figsize=(WIDTH, 1.95 * rows))
        panels = figure.subplots(rows, 2, squeeze=False)
        for axis, message in zip(panels.flat, protocol.messages, strict=False):
            sent = message.per_unit * message.unit.count(swarm) / 6
            _way(axis, message, int(sent), color_of(protocol))
        for axis in panels.flat:
            axis.set_axis_off()
    return figure


def _way(axis: Axes, message: Message, sent: int, color: str) -> None:
    """Draw the hosts, the access point, and one message on its way up and down."""
    gray = "0.45"
    multicast = message.cast == "multicast"
    processes = [(2.2 * host + 0.75 * number, 0.0) for host in range(3) for number in range(2)]
    point, sender, others = (2.575, 2.3), processes[0], processes[2:]
    for host in range(3):
        axis.add_patch(
            FancyBboxPatch(
                (2.2 * host - 0.3, -0.75),
                1.35,
                1.15,
                boxstyle="round,pad=0.06",
                facecolor="0.95",
                edgecolor=gray,
            )
        )
        name = f"host {host + 1}"
        axis.text(2.2 * host + 0.375, -0.55, name, ha="center", va="center", fontsize=9)
    if multicast:
        fan = Polygon([point, (1.6, 0.35), (5.75, 0.35)], color=color, alpha=0.18, linewidth=0)
        axis.add_patch(fan)
    ways = [(sender, point), *((point, other) for other in others)]
    for start, end in ways[: 1 if multicast else None]:
        axis.add_patch(
            FancyArrowPatch(
                start, end, arrowstyle="-|>", mutation_scale=11, color=color, lw=1.6, shrinkA=7,
                shrinkB=9,
            )
        )  # fmt: skip
    axis.plot(*zip(*processes, strict=True), "o", color="white", mec=gray, ms=9, zorder=3)
    axis.plot(*sender, "o", color=color, mec="black", ms=9, zorder=4)
    axis.plot(*point, "s", color="white", mec="black", ms=13, zorder=4)
    axis.text(point[0] + 0.35, point[1], "access point", va="center", fontsize=9)
    to_whom = "to all at once" if multicast else f"{sent // 4} to each remote process"
    axis.set_title(f"{message.name}\n{to_whom}", fontsize=10)
    axis.set(xlim=(-0.5, 5.95), ylim=(-0.95, 2.75), aspect="equal")


def bars_data(swarms: Mapping[str, pd.DataFrame], *, share: bool = False) -> pd.DataFrame:
    """Return the data of `bars`: a row a swarm and message, from the left of a bar to its right.

    The column ``utilization``, or ``share``, is as long as the message's part of the bar.
    """
    parts = {
        swarm: messages["uplink_s"] + messages["downlink_s"] for swarm, messages in swarms.items()
    }
    if share:
        parts = {swarm: part / part.sum() for swarm, part in parts.items()}
    data = pd.concat(parts, names=["swarm", "message"])
    return data.rename("share" if share else "utilization").reset_index()


def bars(swarms: Mapping[str, pd.DataFrame], *, share: bool = False) -> Figure:
    """Draw what each message adds to utilization: one stacked bar a swarm.

    Parameters
    ----------
    swarms : mapping of str to pandas.DataFrame
        A label and what `discostorm.breakdown` returns, a bar each, from the top down.
    share : bool, optional
        Whether to draw the share in the total instead of utilization.

    Returns
    -------
    matplotlib.figure.Figure
    """
    with style():
        figure = Figure(figsize=(WIDTH, 1.6 + 0.36 * len(swarms)))
        axis = figure.subplots()
        data = bars_data(swarms, share=share)
        others = (f"C{number}" for number in count(2))  # after those of SEDP and Declare
        colors = {
            name: MESSAGE_COLORS.get(name) or next(others)
            for name in dict.fromkeys(data["message"])
        }
        for label in swarms:
            part = data[data["swarm"] == label]
            lengths = part.set_index("message").iloc[:, -1]
            starts = lengths.cumsum() - lengths
            for name in lengths.index:
                axis.barh(label, lengths[name], left=starts[name], color=colors[name])
        handles = [Patch(color=color, label=name) for name, color in colors.items()]
        figure.legend(handles=handles, loc="outside upper center", ncols=4)
        axis.invert_yaxis()
        axis.grid(visible=False, axis="y")
        axis.xaxis.set_major_formatter(PercentFormatter(1))
        if share:
            axis.set_xlim(0, 1)
            axis.set_xlabel("share of the airtime [%]")
        else:
            axis.axvline(1, color="black", linewidth=1)
            axis.set_xlabel("channel utilization [%]")
        axis.set_ylabel("swarm")
    return figure
