"""Charts of any table of messages: airtime and receivers."""

from collections.abc import Mapping, Sequence
from itertools import count

import pandas as pd
from matplotlib.figure import Figure
from matplotlib.patches import Patch
from matplotlib.ticker import PercentFormatter

from discostorm._numeric import evaluate
from discostorm.figures import MESSAGE_COLORS, PAPER_PROTOCOLS, color_of
from discostorm.fleet import Fleet
from discostorm.messages import Protocol
from discostorm.wifi import PAPER
from discostorm_book.figures.drawing import book_figure, legend_below


def frame_airtime_data(protocols: Sequence[Protocol] = PAPER_PROTOCOLS) -> pd.DataFrame:
    """Return the cost of one frame of each message on the paper's channel, up and down [s]."""
    rows = []
    for protocol in protocols:
        values = protocol.values() | PAPER.values()
        for message in protocol.messages:
            down = PAPER.multicast if message.cast == "multicast" else PAPER.unicast
            for direction, link, expression in (
                ("up", PAPER.unicast, message.airtime_up()),
                ("down", down, message.airtime_down()),
            ):
                bits = evaluate(expression, values) - link.overhead
                rows.append((protocol.name, message.name, direction, link.overhead, bits))
    return pd.DataFrame(rows, columns=["protocol", "message", "direction", "overhead_s", "bits_s"])


def frame_airtime() -> Figure:
    """Draw the uplink and downlink airtime of one frame of each message, as overhead and bits."""
    data = frame_airtime_data()
    color = {protocol.name: color_of(protocol) for protocol in PAPER_PROTOCOLS}
    overhead, bits = 1e6 * data["overhead_s"], 1e6 * data["bits_s"]
    whole = overhead + bits
    with book_figure(3.8, "Overhead costs more than bits, except in SPDP down") as figure:
        axis = figure.subplots()
        names, colors = data["message"] + " " + data["direction"], data["protocol"].map(color)
        axis.barh(names, overhead, color=colors, alpha=0.35)
        axis.barh(names, bits, left=overhead, color=colors)
        for row, micro in enumerate(whole):
            axis.text(micro + 6, row, f"{micro:.0f}", va="center", fontsize=8)
        for name, shade in color.items():
            middle = data.index[data["protocol"] == name].to_numpy().mean()
            axis.text(450, middle, name, color=shade, weight="bold", va="center")
        axis.invert_yaxis()
        axis.grid(visible=False, axis="y")
        axis.set(xlim=(0, 1.08 * whole.max()), xlabel="airtime of one frame [µs]")
        axis.set_ylabel("message and direction")
        fixed = Patch(color="gray", alpha=0.35, label="fixed overhead")
        axis.legend(handles=[fixed, Patch(color="gray", label="its bits")], loc="lower right")
    return figure


def who_tells_whom(protocol: Protocol) -> Figure:
    """Draw the frames that one process of three sends: time runs down, one number per frame."""
    swarm, color = Fleet.swarm(3, 1, 2), color_of(protocol)
    lines = {"host 1": 0.0, "access point": 1.4, "host 2": 2.8, "host 3": 4.2}
    sender, access_point, *others = places = list(lines.values())
    row, numbers = 0.0, count(1)
    height = sum(1.35 if message.cast == "multicast" else 2.35 for message in protocol.messages)
    title = f"{protocol.name}: unicast crosses the channel twice for each receiver"
    with book_figure(0.75 + 0.27 * height, title) as figure:
        axis = figure.subplots()
        for message in protocol.messages:
            multicast = message.cast == "multicast"
            sent = int(message.per_unit * message.unit.count(swarm)) // 3
            to_whom = "to all" if multicast else f"{sent // 2} to each"
            first = row
            for receivers in [others] if multicast else [[place] for place in others]:
                axis.plot(receivers, [row] * len(receivers), "o", color=color, ms=5)
                hops = {"up": (sender, access_point), "down": (access_point, receivers[-1])}
                for hop, (start, end) in hops.items():
                    arrow = {"arrowstyle": "-|>", "color": color, "shrinkA": 0, "shrinkB": 2}
                    axis.annotate("", (end, row), (start, row), arrowprops=arrow)
                    text = f"{next(numbers)} {hop}"
                    axis.text(start + 0.6, row - 0.12, text, ha="center", fontsize=8)
                row += 1
            middle = (first + row - 1) / 2
            axis.text(-0.25, middle, f"{message.name}\n{to_whom}", ha="right", va="center")
            row += 0.35
        axis.vlines(places, -0.8, row - 0.6, "0.6", lw=1, zorder=0)
        for name, place in lines.items():
            axis.text(place, -1.0, name, ha="center", va="bottom")
        axis.set(xlim=(-1.6, 4.7), ylim=(row - 0.5, -1.5))
        axis.set_axis_off()
    return figure


def message_bars_data(swarms: Mapping[str, pd.DataFrame], *, share: bool = False) -> pd.DataFrame:
    """Return the data of `message_bars`: a row per swarm and message, in the order of the bars."""
    parts = {name: rows["uplink_s"] + rows["downlink_s"] for name, rows in swarms.items()}
    if share:
        parts = {swarm: part / part.sum() for swarm, part in parts.items()}
    data = pd.concat(parts, names=["swarm", "message"])
    return data.rename("share" if share else "utilization").reset_index()


def message_bars(
    swarms: Mapping[str, pd.DataFrame], *, share: bool = False, title: str = ""
) -> Figure:
    """Draw the utilization or share of each message of a breakdown: one bar per swarm."""
    data = message_bars_data(swarms, share=share)
    others = (f"C{number}" for number in count())
    colors = {name: MESSAGE_COLORS.get(name) or next(others) for name in data["message"].unique()}
    with book_figure(1.5 + 0.29 * len(swarms), title) as figure:
        axis = figure.subplots()
        for label in swarms:
            lengths = data[data["swarm"] == label].set_index("message").iloc[:, -1]
            for name, start in (lengths.cumsum() - lengths).items():
                axis.barh(label, lengths[str(name)], left=start, color=colors[name])
        legend_below(figure, [Patch(color=color, label=name) for name, color in colors.items()], 4)
        axis.invert_yaxis()
        axis.grid(visible=False, axis="y")
        axis.xaxis.set_major_formatter(PercentFormatter(1))
        axis.set_ylabel("swarm")
        if share:
            axis.set(xlim=(0, 1), xlabel="share of the airtime [%]")
        else:
            axis.axvline(1, color="black", linewidth=1)
            axis.set_xlabel("channel utilization [%]")
    return figure
