"""Figures of Part I, the paper."""

from collections import Counter
from collections.abc import Sequence

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Patch, Rectangle

from discostorm.data import read_data
from discostorm.figures import COLORS, MESSAGE_COLORS, PAPER_PROTOCOLS
from discostorm.messages import Protocol
from discostorm.model import breakdown
from discostorm.protocols import PROTOCOLS
from discostorm_book.enumeration import EVERYONE, Process, SentMessage, enumerate_messages
from discostorm_book.figures import message_cost_charts
from discostorm_book.figures.drawing import Style, book_figure, legend_below, name_cells

#: Minimum airtime of a block that has room for its name [s].
_MIN_NAMED_AIRTIME = 0.03


def process_name(process: Process | str) -> str:
    """Return a process as host.number, both from 1."""
    return process if isinstance(process, str) else f"{process.host}.{process.number}"


def every_message_data(
    protocols: Sequence[Protocol], hosts: Sequence[Sequence[int]]
) -> pd.DataFrame:
    """Return each uplink message in the enumeration of a small swarm: one row per message."""
    return pd.DataFrame(
        {
            "protocol": protocol.name,
            "from": process_name(sent.sender),
            "to": process_name(sent.receiver),
            "message": sent.kind,
            "tells_of": str(sent.about) or "itself",
        }
        for protocol in protocols
        for sent in _uplink_messages(protocol, hosts)
    )


def every_message(protocols: Sequence[Protocol], hosts: Sequence[Sequence[int]]) -> Figure:
    """Draw each message of a small swarm as a square: rows of senders, columns of receivers."""
    with book_figure(3.7, "Nearly every message goes to one process") as figure:
        for axis, protocol in zip(figure.subplots(1, len(protocols)), protocols, strict=True):
            sent = _uplink_messages(protocol, hosts)
            _draw_squares(axis, sent)
            axis.set_title(f"{protocol.name}: {len(sent)} messages")
        handles = [handle for axis in figure.axes for handle in axis.get_legend_handles_labels()[0]]
        legend_below(figure, handles, 4, columnspacing=1)
    return figure


def _uplink_messages(protocol: Protocol, hosts: Sequence[Sequence[int]]) -> list[SentMessage]:
    return [sent for sent in enumerate_messages(protocol.name, hosts) if sent.hop == "up"]


def _draw_squares(axis: Axes, sent: list[SentMessage]) -> None:
    """Draw messages as squares, and the processes of one host on gray."""
    senders = list(dict.fromkeys(message.sender for message in sent))
    receivers = [EVERYONE, *senders]
    for row, sender in enumerate(senders):
        for column, receiver in enumerate(senders, start=1):
            if receiver.host == sender.host:
                axis.add_patch(Rectangle((column, row), 1, 1, color="0.88"))
    axis.hlines(range(len(senders) + 1), 0, len(receivers), "0.6", lw=0.6)
    axis.vlines(range(len(receivers) + 1), 0, len(senders), "0.6", lw=0.6)
    placed: Counter[tuple[Process, Process | str]] = Counter()
    for kind, number in Counter(message.kind for message in sent).items():
        places = []
        for message in (message for message in sent if message.kind == kind):
            cell = message.sender, message.receiver
            down, across = divmod(placed[cell], 3)
            column, row = receivers.index(message.receiver), senders.index(message.sender)
            places.append((column + 0.22 + 0.28 * across, row + 0.22 + 0.28 * down))
            placed[cell] += 1
        label = f"{kind} ({number})"
        axis.plot(*np.transpose(places), "s", color=MESSAGE_COLORS[kind], ms=5, mew=0, label=label)
    axis.set(xlim=(-0.02, len(receivers) + 0.02), ylim=(len(senders) + 0.02, -0.02), aspect="equal")
    axis.set(xlabel="to (host.process)", ylabel="from (host.process)")
    names = [process_name(sender) for sender in senders]
    name_cells(axis, ["all", *names], names)
    axis.spines[:].set_visible(False)


def frame_parts_data() -> pd.DataFrame:
    """Return the parts of each frame of Table II [B]: one row per message."""
    parts = pd.DataFrame(read_data("paper/headers.csv")).astype({"bytes": int})
    table = pd.DataFrame(read_data("paper/table2.csv"))
    transports = parts[parts["transports"] != "UDP TCP"].set_index("transports")["bytes"]

    def of(start: str) -> int:
        return int(parts["bytes"][parts["part"].str.startswith(start)].sum())

    columns = {
        "message": table["message"],
        "payload [B]": table["payload_B"].astype(int),
        "UDP or TCP [B]": table["transport"].map(transports),
        "IPv4 [B]": of("IPv4"),
        "LLC and SNAP [B]": of("LLC"),
        "802.11 header and check sequence [B]": of("IEEE 802.11"),
    }
    data = pd.DataFrame(columns)
    assert (data.iloc[:, 1:].sum(axis=1) == table["frame_printed_B"].astype(int)).all()
    return data


def frame_parts() -> Figure:
    """Draw each frame of Table II as a bar of its payload and headers."""
    data = frame_parts_data().set_index("message")
    protocols = {message.name: one.name for one in PAPER_PROTOCOLS for message in one.messages}
    colors = [COLORS[protocols[str(name)]] for name in data.index]
    with book_figure(3.0, "Only in SPDP and SEDP are headers a small part") as figure:
        axis = figure.subplots()
        left, handles = np.zeros(len(data)), []
        for part, share in zip(data, (1, 0.7, 0.5, 0.32, 0.16), strict=True):
            look: Style = {"left": left, "color": colors, "edgecolor": "white", "lw": 0.6}
            axis.barh(data.index, data[part], alpha=share, **look)
            handles.append(Patch(color="0.2", label=str(part).removesuffix(" [B]"), alpha=share))
            left = left + data[part].to_numpy()
        axis.invert_yaxis()
        axis.set_axisbelow(True)
        axis.grid(axis="y", visible=False)
        axis.set_xlabel("length on the air [B]")
        axis.legend(handles=handles, loc="lower right")
    return figure


def airtime_blocks_data(hosts: int, processes: int, endpoints: int) -> pd.DataFrame:
    """Return the terms of equation (12): overhead and bits of each message, up and down [s]."""
    frames = message_cost_charts.frame_airtime_data()
    counts = [
        breakdown(PROTOCOLS[name], hosts, processes, endpoints)["uplink_messages"]
        for name in frames["protocol"].unique()
    ]
    # Each goes down as often as it goes up: a multicast once for all.
    number = frames["message"].map(pd.concat(counts))
    parts = {part: number * frames[part] for part in ("overhead_s", "bits_s")}
    return frames.assign(messages=number, **parts)


def airtime_blocks(hosts: int, processes: int, endpoints: int) -> Figure:
    """Draw the terms of equation (12) as stacked blocks of airtime, with a line at one second."""
    data = airtime_blocks_data(hosts, processes, endpoints)
    with book_figure(4.2, "Announcing endpoints needs most of the airtime") as figure:
        axis, totals = figure.subplots(), []
        for place, (name, messages) in enumerate(data.groupby("protocol", sort=False)):
            color, top, left = COLORS[str(name)], 0.0, place - 0.4
            for row in messages.to_dict("records"):
                airtime = row["overhead_s"] + row["bits_s"]
                part = 0.8 * row["overhead_s"] / airtime
                axis.bar(left, airtime, part, top, align="edge", color=color, alpha=0.35)
                axis.bar(left + part, airtime, 0.8 - part, top, align="edge", color=color)
                axis.bar(left, airtime, 0.8, top, align="edge", fc="none", ec="white", lw=1)
                if airtime > _MIN_NAMED_AIRTIME:
                    text = f"{row['message']} {row['direction']}: {airtime:.3f} s"
                    axis.text(left + 0.02, top + airtime / 2, text, va="center", fontsize=8)
                top += airtime
            totals.append(f"{name}: {top:.3f} s")
        axis.axhline(1, color="black", lw=1.6)
        end = len(totals) - 0.45
        axis.text(end - 0.1, 1.01, "one second", ha="right", va="bottom", fontsize=8)
        axis.set_xticks(range(len(totals)), totals)
        axis.set(xlim=(-0.55, end), ylim=(0, 1.1), ylabel="airtime [s]")
        axis.grid(visible=False, axis="x")
    return figure
