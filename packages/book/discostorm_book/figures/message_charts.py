"""What messages cost, and whom they reach: of any table of messages."""

from collections.abc import Mapping, Sequence
from itertools import count

import pandas as pd
from matplotlib.figure import Figure
from matplotlib.patches import Patch
from matplotlib.ticker import PercentFormatter

from discostorm._numeric import evaluate
from discostorm.figures.paper import PAPER_PROTOCOLS
from discostorm.figures.style import MESSAGE_COLORS, WIDTH, color_of, headline, style
from discostorm.fleet import Fleet
from discostorm.messages import Protocol
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
        figure = Figure(figsize=(WIDTH, 3.8))
        axis = figure.subplots()
        names = data["message"] + " " + data["direction"]
        overhead, bits = 1e6 * data["overhead_s"], 1e6 * data["bits_s"]
        colors = data["protocol"].map(color)
        axis.barh(names, overhead, color=colors, alpha=0.35)
        axis.barh(names, bits, left=overhead, color=colors)
        for row, micro in enumerate(overhead + bits):
            axis.text(micro + 6, row, f"{micro:.0f}", va="center", fontsize=8)
        for protocol in PAPER_PROTOCOLS:
            rows = data.index[data["protocol"] == protocol.name]
            axis.text(
                450, rows.to_numpy().mean(), protocol.name, color=color[protocol.name],
                weight="bold", va="center",
            )  # fmt: skip
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
        headline(figure, "Overhead costs more than bits, except in multicast down")
    return figure


def who_tells_whom(protocol: Protocol) -> Figure:
    """Draw the frames of each message of a protocol: from one process, by the access point.

    Three hosts of one process with two endpoints each; time runs down, and each frame has its
    number. How many messages go to whom is read off the protocol's table.
    """
    swarm = Fleet.swarm(3, 1, 2)
    color = color_of(protocol)
    lines = {"host 1": 0.0, "access point": 1.4, "host 2": 2.8, "host 3": 4.2}
    places = list(lines.values())
    row, frame = 0.0, 0
    with style():
        figure = Figure(figsize=(WIDTH, 0.75 + 0.27 * _rows(protocol)))
        axis = figure.subplots()
        for message in protocol.messages:
            multicast = message.cast == "multicast"
            sent = int(message.per_unit * message.unit.count(swarm)) // 3
            to_whom = "to all" if multicast else f"{sent // 2} to each"
            first = row
            for receivers in [places[2:]] if multicast else [[place] for place in places[2:]]:
                axis.plot(receivers, [row] * len(receivers), "o", color=color, ms=5)
                for hop, start, end in (
                    ("up", places[0], places[1]),
                    ("down", places[1], receivers[-1]),
                ):
                    frame += 1
                    arrow = {"arrowstyle": "-|>", "color": color, "shrinkA": 0, "shrinkB": 2}
                    axis.annotate("", (end, row), (start, row), arrowprops=arrow)
                    axis.text(start + 0.6, row - 0.12, f"{frame} {hop}", ha="center", fontsize=8)
                row += 1
            middle = (first + row - 1) / 2
            axis.text(-0.25, middle, f"{message.name}\n{to_whom}", ha="right", va="center")
            row += 0.35
        axis.vlines(places, -0.8, row - 0.6, "0.6", lw=1, zorder=0)
        for name, place in lines.items():
            axis.text(place, -1.0, name, ha="center", va="bottom")
        axis.set(xlim=(-1.6, 4.7), ylim=(row - 0.5, -1.5))
        axis.set_axis_off()
        headline(figure, f"{protocol.name}: unicast crosses the channel twice for each receiver")
    return figure


def _rows(protocol: Protocol) -> float:
    """Return how many rows of arrows there are, with the gaps between the messages."""
    return sum(1.35 if message.cast == "multicast" else 2.35 for message in protocol.messages)


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


def bars(swarms: Mapping[str, pd.DataFrame], *, share: bool = False, title: str = "") -> Figure:
    """Draw what each message adds to utilization: one stacked bar a swarm.

    Parameters
    ----------
    swarms : mapping of str to pandas.DataFrame
        A label and what `discostorm.breakdown` returns, a bar each, from the top down.
    share : bool, optional
        Whether to draw the share in the total instead of utilization.
    title : str, optional
        What the figure shows.

    Returns
    -------
    matplotlib.figure.Figure
    """
    with style():
        figure = Figure(figsize=(WIDTH, 1.5 + 0.29 * len(swarms)))
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
        figure.legend(handles=handles, loc="outside lower center", ncols=4)
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
        headline(figure, title)
    return figure
