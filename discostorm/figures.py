"""Figures 2 to 4 of the paper: their data as tables, and functions that draw them.

`save_all` writes all of them as SVG, PDF and PNG, with CSV: the command ``discostorm figures``.
There are more drawings: `airtime`, of one frame of each message; and, of any protocol,
`bars`, of what each message adds to utilization, `remedies`, of what a plan would change, and
`who_tells_whom`, of the way that each message takes.
"""

import math
import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from itertools import count, cycle
from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from matplotlib.patches import FancyArrowPatch, FancyBboxPatch, Patch, Polygon
from matplotlib.ticker import FuncFormatter, MultipleLocator, PercentFormatter
from numpy.typing import NDArray

from discostorm import words
from discostorm._numeric import evaluate
from discostorm.data import data_path
from discostorm.fleet import Fleet
from discostorm.messages import PAPER_WINDOW, Message, Protocol
from discostorm.model import utilization
from discostorm.protocols import ARRANGED, DDS, PROTOCOLS, ZENOH
from discostorm.saturation import saturation_hosts
from discostorm.wifi import PAPER

#: What the paper draws.
PAPER_PROTOCOLS = (DDS, ZENOH)

#: One colour a protocol, one line style a phase, in all figures.
COLORS = dict(
    zip(
        # First those that are not variants or arrangements of others.
        sorted(PROTOCOLS, key=lambda name: (name in ARRANGED, "," in name)),
        # Okabe and Ito's palette, told apart by colour-blind readers, too.
        cycle(("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#E69F00", "#000000")),
        strict=False,
    )
)
STYLES = {
    "total": "-",
    "SPDP": ":",
    "Scouting": ":",
    "SEDP": "--",
    "Declaration": "--",
}
#: One shade of the protocol's colour a message; what tells of endpoints has the colour itself.
MESSAGE_COLORS = {
    "SPDP": "#08306B",
    "SEDP": COLORS["DDS"],
    "Heartbeat": "#6BAED6",
    "ACKNACK": "#C6DBEF",
    "Scout": "#662506",
    "Hello": "#FDAE6B",
    "Declare": COLORS["Zenoh"],
    "KeepAlive": "#FDE0C5",
}
#: Inches: at this width the letters are still legible when a phone scales the figure down.
WIDTH = 5.6

# The paper's parameters of each figure: Fig. 2, 3 and 4 captions and Sec. IV-C.
FIG2_PROCESSES, FIG2_ENDPOINTS = 2, 10
FIG3_HOSTS, FIG3_ENDPOINTS_IN_ALL = 3, 40
FIG4_PROCESSES, FIG4_ENDPOINTS = 1, 678


@contextmanager
def style() -> Iterator[None]:
    """Draw with the looks of the book inside a ``with`` block."""
    with mpl.rc_context(fname=data_path("discostorm.mplstyle")):
        yield


def steps(first: int, last: int, per_one: int = 10) -> NDArray[np.float64]:
    """Return first to last with every whole number, and steps between for a smooth curve."""
    return np.arange(per_one * first, per_one * last + 1) / per_one


def phases_data(hosts: NDArray[np.float64], processes: float, endpoints: float) -> pd.DataFrame:
    """Return the utilization of every phase and the total of both protocols, a row a value."""
    return pd.concat(
        pd.DataFrame(
            {
                "protocol": protocol.name,
                "phase": phase or "total",
                "hosts": hosts,
                "utilization": utilization(protocol, hosts, processes, endpoints, phase=phase),
            }
        )
        for protocol in PAPER_PROTOCOLS
        for phase in (*protocol.phases, None)
    ).reset_index(drop=True)


def fig2_data() -> pd.DataFrame:
    """Return the data of Fig. 2: utilization of each phase against the number of hosts."""
    return phases_data(steps(1, 12), FIG2_PROCESSES, FIG2_ENDPOINTS)


def fig3_data() -> pd.DataFrame:
    """Return the data of Fig. 3: utilization against processes and endpoints.

    The rows of ``part`` "surface" form a grid; those of "trajectory" keep the number of
    endpoints on a host at 40.
    """
    grid = np.meshgrid(np.arange(1, 11), np.arange(0, 41, 2))
    processes = steps(1, 10)
    parts = {
        "surface": (grid[0].ravel(), grid[1].ravel()),
        "trajectory": (processes, FIG3_ENDPOINTS_IN_ALL / processes),
    }
    return pd.concat(
        pd.DataFrame(
            {
                "protocol": protocol.name,
                "part": part,
                "processes": processes,
                "endpoints": endpoints,
                "utilization": utilization(protocol, FIG3_HOSTS, processes, endpoints),
            }
        )
        for protocol in PAPER_PROTOCOLS
        for part, (processes, endpoints) in parts.items()
    ).reset_index(drop=True)


def fig4_data() -> pd.DataFrame:
    """Return the data of Fig. 4: utilization of the Nav2 scenario against hosts."""
    return phases_data(steps(1, 5, per_one=50), FIG4_PROCESSES, FIG4_ENDPOINTS)


def _percent(axis: Axes, most: float) -> None:
    axis.axhline(1, color="black", linewidth=1)
    axis.set_ylim(0, most)
    axis.yaxis.set_major_formatter(PercentFormatter(1))
    axis.set_ylabel("channel utilization [%]")


def _phases(axis: Axes, data: pd.DataFrame, processes: float, endpoints: float) -> None:
    """Draw each phase and the total against hosts, and mark the saturation points.

    The total is the strongest line; the phases are thin and darker, so that one which is
    nearly all of it stays visible on top. A dot marks each whole number of hosts.
    """
    for protocol in PAPER_PROTOCOLS:
        color = COLORS[protocol.name]
        rows = data[data["protocol"] == protocol.name]
        total = rows[rows["phase"] == "total"]
        whole = total[total["hosts"] % 1 == 0]
        axis.plot(
            total["hosts"],
            total["utilization"],
            STYLES["total"],
            color=color,
            linewidth=3,
            label=f"{protocol.name} total",
        )
        for phase in protocol.phases:
            part = rows[rows["phase"] == phase]
            axis.plot(
                part["hosts"],
                part["utilization"],
                STYLES[phase],
                color=0.45 * np.array(to_rgb(color)),
                linewidth=1.2,
                label=f"{protocol.name} {phase}",
            )
        axis.plot(whole["hosts"], whole["utilization"], "o", color=color, markersize=6)
        hosts = saturation_hosts(protocol, processes, endpoints)
        axis.plot(
            hosts,
            1,
            "D",
            color=color,
            markeredgecolor="white",
            markersize=8,
            zorder=3,
            label=f"{protocol.name} saturates at {hosts:.2f}",
        )
    axis.set_xlim(data["hosts"].min(), data["hosts"].max())
    axis.xaxis.set_major_locator(MultipleLocator(1))
    axis.set_xlabel("hosts $N_H$ [1]")


def fig2() -> Figure:
    """Draw Fig. 2: utilization against hosts (N_P = 2, N_E = 10)."""
    with style():
        figure = Figure(figsize=(WIDTH, 4.2))
        axis = figure.subplots()
        _phases(axis, fig2_data(), FIG2_PROCESSES, FIG2_ENDPOINTS)
        _percent(axis, 2)
        axis.set_title(f"$N_P = {FIG2_PROCESSES}$, $N_E = {FIG2_ENDPOINTS}$")
        axis.legend(loc="upper left")
    return figure


def fig3() -> Figure:
    """Draw Fig. 3: utilization against processes and endpoints (N_H = 3).

    Above the paper's surfaces with the line of 40 endpoints on a host and, dashed, the
    height of 100%; below the same line on its own.
    """
    data = fig3_data()
    of = {
        part: {
            protocol.name: rows[rows["protocol"] == protocol.name] for protocol in PAPER_PROTOCOLS
        }
        for part, rows in data.groupby("part")
    }
    with style():
        figure = Figure(figsize=(WIDTH, 5.8))
        # Placed by hand: the layout engine leaves a third of the room around a cube empty.
        figure.set_layout_engine("none")
        for left, (name, surface) in zip((0.0, 0.5), of["surface"].items(), strict=True):
            axis = figure.add_axes(
                (left + 0.055, 0.48, 0.44, 0.52), projection="3d", computed_zorder=False
            )
            _surface(axis, surface, of["trajectory"][name], COLORS[name])
            axis.set_title(name, y=0.97)
        axis = figure.add_axes((0.13, 0.09, 0.85, 0.36))
        for name, line in of["trajectory"].items():
            axis.plot(line["processes"], line["utilization"], color=COLORS[name], label=name)
            whole = line[line["processes"].isin(whole_divisions())]
            axis.plot(whole["processes"], whole["utilization"], "o", color=COLORS[name])
        _percent(axis, 2)
        axis.xaxis.set_major_locator(MultipleLocator(1))
        axis.set_xlabel(
            f"processes on a host $N_P$ [1], with $N_P N_E = {FIG3_ENDPOINTS_IN_ALL}$ endpoints"
        )
        axis.legend(loc="upper left")
    return figure


def _surface(axis: Any, surface: pd.DataFrame, line: pd.DataFrame, color: str) -> None:
    """Draw one surface of Fig. 3 on a 3-D axis, with the trajectory on it."""
    grid = surface.pivot_table(index="endpoints", columns="processes", values="utilization")
    x, y = np.meshgrid(grid.columns, grid.index)
    percent = 100 * grid.to_numpy()
    axis.plot_surface(
        x, y, percent, color=color, alpha=0.55, linewidth=0.2, edgecolor="white", rcount=21
    )
    axis.contour(x, y, percent, levels=[100], colors="black", linestyles="--", linewidths=1)
    axis.plot(line["processes"], line["endpoints"], 100 * line["utilization"], "k", linewidth=2)
    axis.view_init(elev=24, azim=-125)
    axis.set_xlabel("processes $N_P$ [1]", labelpad=-7)
    axis.set_ylabel("endpoints $N_E$ [1]", labelpad=-7)
    axis.set_zlabel("utilization [%]", labelpad=1)
    axis.set_zlim(0, 1200)
    axis.tick_params(pad=-3, labelsize=8)
    axis.tick_params(axis="z", pad=1)
    for direction, step in ((axis.xaxis, 3), (axis.yaxis, 10), (axis.zaxis, 300)):
        direction.set_major_locator(MultipleLocator(step, 1 if step == 3 else 0))
        direction.label.set_size(9)
    axis.set_box_aspect((1, 1, 0.95), zoom=0.93)


def whole_divisions() -> list[int]:
    """Return the numbers of processes that share the 40 endpoints of Fig. 3 evenly."""
    return [n for n in range(1, 11) if FIG3_ENDPOINTS_IN_ALL % n == 0]


def fig4() -> Figure:
    """Draw Fig. 4: utilization of the Nav2 scenario (N_P = 1, N_E = 678).

    Below, on a logarithmic scale, the phases that the linear scale cannot show.
    """
    with style():
        figure = Figure(figsize=(WIDTH, 6.4))
        above, below = figure.subplots(2, 1, sharex=True)
        data = fig4_data()
        for axis in (above, below):
            _phases(axis, data, FIG4_PROCESSES, FIG4_ENDPOINTS)
        _percent(above, 4)
        _percent(below, 10)
        # With one host nothing but the first phase is sent, and zero has no logarithm.
        below.set_yscale("log", nonpositive="mask")
        below.set_ylim(bottom=1e-3)
        below.yaxis.set_major_formatter(lambda value, _: f"{100 * value:g}%")
        above.set_xlabel("")
        above.set_title(f"Nav2: $N_P = {FIG4_PROCESSES}$, $N_E = {FIG4_ENDPOINTS}$")
        above.legend(loc="upper left")
    return figure


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
    with style():
        figure = Figure(figsize=(WIDTH, 4.6))
        axis = figure.subplots()
        names = data["message"] + " " + data["direction"]
        overhead, bits = 1e6 * data["overhead_s"], 1e6 * data["bits_s"]
        colors = data["protocol"].map(COLORS)
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
            _way(axis, message, int(sent), COLORS[protocol.name])
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


#: From which utilization on `remedies` draws on a logarithmic axis [1].
_FAR = 10.0


def remedies(bars: pd.DataFrame, window: float = PAPER_WINDOW) -> Figure:
    """Draw what takes the channel as bars from the top down, each below its name.

    Bars are seconds of airtime, and a line is the time that they are charged to; in the steady
    state they are parts of the channel, and the line is all of it.

    Changes that fit are dark, others light, and what is not changed is gray. If something takes
    more than ten times the channel, the axis is logarithmic, and bars begin at the line.

    Parameters
    ----------
    bars : pandas.DataFrame
        One row a bar, with columns bar (its name) and utilization [1]; the first, and those whose
        names begin with its name, are what the others change.
    window : float, optional
        The seconds that are averaged [s]; infinity for the steady state.

    Returns
    -------
    matplotlib.figure.Figure
    """
    with style():
        figure = Figure(figsize=(WIDTH, 0.8 + 0.42 * len(bars)))
        axis = figure.subplots()
        taken = bars["utilization"].to_numpy()
        far = bool(taken.max() > _FAR)
        if far:
            axis.set_xscale("log")
            axis.set_xlim(min(0.5, taken.min()) / 3, 6 * taken.max())
        else:
            axis.set_xlim(0, 1.14 * max(1.0, taken.max()))
        start, steady = (1.0 if far else 0.0), math.isinf(window)
        places = np.arange(len(bars))
        unchanged = bars["bar"].str.startswith(bars["bar"].iloc[0])
        colors = np.where(unchanged, "#777777", np.where(taken < 1, "#0072B2", "#a9c9e3"))
        axis.barh(places, taken - start, left=start, height=0.4, color=colors)
        # Not through the names, which stand between the bars.
        axis.vlines(np.ones(len(bars)), places - 0.25, places + 0.25, color="black", linewidth=1.2)
        white = {"facecolor": "white", "edgecolor": "none", "pad": 0.8}
        left = axis.get_yaxis_transform()
        for place, name, part in zip(places, bars["bar"], taken, strict=True):
            axis.text(0.005, place - 0.42, name, va="center", fontsize=9, transform=left)
            inward = far and part < 1
            axis.annotate(
                words.percent(part) if steady else words.duration(part * window),
                (part, place), (-4 if inward else 4, 0),
                textcoords="offset points", va="center", ha="right" if inward else "left",
                fontsize=9, bbox=white,
            )  # fmt: skip
        axis.set_ylim(len(bars) - 0.6, -0.8)
        axis.set_yticks([])
        axis.set_ylabel("what is changed")
        axis.grid(visible=False, axis="y")
        axis.xaxis.set_major_formatter(
            FuncFormatter(lambda x, _: words.percent(x) if steady else f"{x * window:,g}")
        )
        axis.set_xlabel(
            "utilization by discovery [%]; the line is the whole channel"
            if steady
            else f"airtime of discovery [s]; the line is at {window:,g} s"
        )
    return figure


@dataclass(frozen=True)
class PaperFigure:
    """A figure of the paper: what it shows, its data, and how it is drawn."""

    title: str
    data: Callable[[], pd.DataFrame]
    draw: Callable[[], Figure]


FIGURES = {
    "fig2": PaperFigure("Fig. 2: utilization against hosts", fig2_data, fig2),
    "fig3": PaperFigure("Fig. 3: utilization against processes and endpoints", fig3_data, fig3),
    "fig4": PaperFigure("Fig. 4: utilization of the Nav2 scenario", fig4_data, fig4),
}

# Without these, each file would carry the time or the version that made it.
_METADATA: dict[str, dict[str, None]] = {
    "svg": {"Date": None, "Creator": None},
    "pdf": {"CreationDate": None, "Creator": None, "Producer": None},
    "png": {"Software": None},
}


def save(figure: Figure, folder: Path, name: str) -> Iterator[Path]:
    """Write a figure as SVG, PDF and PNG, the same bytes every time; yield each path."""
    if engine := figure.get_layout_engine():
        with style():
            engine.execute(figure)
    for kind, metadata in _METADATA.items():
        path = folder / f"{name}.{kind}"
        with style(), replacing(path) as beside:
            # With an engine, even "none", each file would first be drawn once more.
            mpl.rcParams["figure.constrained_layout.use"] = False
            figure.set_layout_engine(None)
            figure.savefig(beside, dpi=200, metadata=metadata, format=kind)
        yield path


@contextmanager
def replacing(path: Path) -> Iterator[Path]:
    """Give a file to write beside a path, which takes its place only if all was written."""
    beside = path.with_name(f".{path.name}.{os.getpid()}.part")
    try:
        yield beside
        beside.replace(path)
    finally:
        beside.unlink(missing_ok=True)


def files_of_all() -> int:
    """Return how many files `save_all` writes."""
    return len(FIGURES) * (len(_METADATA) + 1)


def save_all(folder: Path) -> Iterator[Path]:
    """Write Figs. 2-4 and their data into a folder, made if missing; yield each path."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, paper in FIGURES.items():
        figure = paper.draw()
        yield from save(figure, folder, name)
        path = folder / f"{name}.csv"
        with replacing(path) as beside:
            paper.data().to_csv(beside, index=False, lineterminator="\n")
        yield path
