"""Figures 2 to 4 of the paper: functions that return a matplotlib Figure, and the data they draw.

`save_all` writes them as SVG, PDF and PNG, with CSV: the command ``discostorm figures``. `style`
holds the look that all figures share.
"""

import io
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from matplotlib.ticker import MultipleLocator, PercentFormatter
from numpy.typing import NDArray

from discostorm.figures.style import (
    COLORS as COLORS,
    DASHES,
    MESSAGE_COLORS as MESSAGE_COLORS,
    STYLE_SHEETS as STYLE_SHEETS,
    WIDTH as WIDTH,
    color_of as color_of,
    css_color_property as css_color_property,
    headline as headline,
    protocol_colors as protocol_colors,
    style as style,
)
from discostorm.files import atomic_write
from discostorm.lookup import AnyWifi
from discostorm.messages import Protocol
from discostorm.model import utilization
from discostorm.protocols import DDS, ZENOH
from discostorm.saturation import saturation_hosts
from discostorm.wifi import PAPER

#: The protocols that the paper draws.
PAPER_PROTOCOLS = (DDS, ZENOH)

# The paper's parameters of each figure: Fig. 2, 3 and 4 captions and Sec. IV-C.
FIG2_PROCESSES, FIG2_ENDPOINTS = 2, 10
FIG3_HOSTS, FIG3_ENDPOINTS_IN_ALL = 3, 40
FIG4_PROCESSES, FIG4_ENDPOINTS = 1, 678


def smooth_steps(first: int, last: int, per_one: int = 10) -> NDArray[np.float64]:
    """Return every integer from first to last, with steps between them for a smooth curve."""
    return np.arange(per_one * first, per_one * last + 1) / per_one


def phases_data(
    hosts: NDArray[np.float64], processes: float, endpoints: float, wifi: AnyWifi = PAPER
) -> pd.DataFrame:
    """Return the utilization of each protocol's phases, and its total, against hosts."""
    return pd.concat(
        pd.DataFrame(
            {
                "protocol": protocol.name,
                "phase": phase or "total",
                "hosts": hosts,
                "utilization": utilization(protocol, hosts, processes, endpoints, wifi, phase),
            }
        )
        for protocol in PAPER_PROTOCOLS
        for phase in (*protocol.phases, None)
    ).reset_index(drop=True)


def fig2_data(
    processes: float = FIG2_PROCESSES,
    endpoints: float = FIG2_ENDPOINTS,
    hosts: int = 12,
    wifi: AnyWifi = PAPER,
) -> pd.DataFrame:
    """Return the data of `fig2`: utilization of each phase, up to a number of hosts."""
    return phases_data(smooth_steps(1, hosts), processes, endpoints, wifi)


def fig3_data() -> pd.DataFrame:
    """Return the data of Fig. 3: utilization against processes and endpoints.

    Rows of ``part`` "surface" form a grid; those of "trajectory" have 40 endpoints on a host.
    """
    grid = np.meshgrid(np.arange(1, 11), np.arange(0, 41, 2))
    processes = smooth_steps(1, 10)
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
    return phases_data(smooth_steps(1, 5, per_one=50), FIG4_PROCESSES, FIG4_ENDPOINTS)


#: The side of its curve on which a protocol's text stands: alignments, and the offset in points.
_LABEL_SIDES = (("right", "bottom", (-9, 5)), ("left", "top", (9, -5)))


def _label(
    axis: Axes, text: str, point: Any, offset: tuple[float, float], color: Any, **look: Any
) -> None:
    axis.annotate(text, point, offset, textcoords="offset points", color=color, **look)


def _phase_color(protocol: Protocol) -> tuple[float, ...]:
    """Return the color of a protocol's phases."""
    return tuple(0.45 * part for part in to_rgb(color_of(protocol)))


def _format_percent_axis(axis: Axes, maximum: float) -> None:
    axis.axhline(1, color="black", linewidth=1)
    axis.set_ylim(0, maximum)
    axis.yaxis.set_major_formatter(PercentFormatter(1))
    axis.set_ylabel("channel utilization [%]")


def _draw_phases(axis: Axes, data: pd.DataFrame, *robot: Any) -> None:
    """Draw each phase, thin and on top, and the total against hosts; mark where that is 100%."""
    for protocol, (ha, va, offset) in zip(PAPER_PROTOCOLS, _LABEL_SIDES, strict=True):
        color, dark = color_of(protocol), _phase_color(protocol)
        rows = data[data["protocol"] == protocol.name]
        total = rows[rows["phase"] == "total"]
        axis.plot(total["hosts"], total["utilization"], DASHES["total"], color=color, linewidth=3)
        for phase in protocol.phases:
            part = rows[rows["phase"] == phase]
            axis.plot(part["hosts"], part["utilization"], DASHES[phase], color=dark, linewidth=1.2)
        integers = total[total["hosts"] % 1 == 0]
        axis.plot(integers["hosts"], integers["utilization"], "o", color=color, markersize=6)
        hosts = saturation_hosts(protocol, *robot)
        axis.plot(hosts, 1, "D", color=color, markeredgecolor="white", markersize=8, zorder=3)
        text = f"full at\n{hosts:.2f} robots"
        _label(axis, text, (hosts, 1), offset, color, ha=ha, va=va, fontsize=9)
    axis.set_xlim(data["hosts"].min(), data["hosts"].max())
    axis.xaxis.set_major_locator(MultipleLocator(1))
    axis.set_xlabel("hosts $N_H$")


def _label_totals(axis: Axes, data: pd.DataFrame, maximum: float) -> None:
    """Label each total and its largest phase where the curve of the total leaves the panel."""
    for protocol, (ha, _, (across, _)) in zip(PAPER_PROTOCOLS, _LABEL_SIDES, strict=True):
        rows = data[(data["protocol"] == protocol.name) & (data["utilization"] <= 0.97 * maximum)]
        # The phase of the endpoints comes last, and is right of the total.
        curve = rows[rows["phase"] == ("total" if ha == "right" else protocol.phases[-1])]
        end = tuple(curve.iloc[-1][["hosts", "utilization"]])
        look: dict[str, Any] = {"ha": ha, "fontsize": 9, "annotation_clip": False}
        color = color_of(protocol)
        _label(axis, protocol.name, end, (across, 0), color, va="center", weight="bold", **look)
        text, shift = f"dashed:\n{protocol.phases[-1]}", 28 if ha == "right" else 0
        _label(axis, text, end, (across - shift, -6), _phase_color(protocol), va="top", **look)


def _label_phases(axis: Axes, data: pd.DataFrame, heights: tuple[float, float]) -> None:
    """Name each protocol's first phase at the end of its curve, raised by a height in points."""
    last = data[data["hosts"] == data["hosts"].max()].set_index("phase")
    for protocol, height in zip(PAPER_PROTOCOLS, heights, strict=True):
        phase = protocol.phases[0]
        end = (last["hosts"][phase], last["utilization"][phase])
        _label(axis, phase, end, (4, height), _phase_color(protocol), va="center", fontsize=9)


def _utilization_by_hosts(
    data: pd.DataFrame,
    robot: tuple[Any, ...],
    maximum: float,
    heights: tuple[float, float],
    name: str = "",
) -> Figure:
    """Draw utilization against hosts, up to a maximum; ``robot``: processes, endpoints, channel."""
    with style():
        figure = Figure(figsize=(WIDTH, 3.9))
        axis = figure.subplots()
        _draw_phases(axis, data, *robot)
        _format_percent_axis(axis, maximum)
        _label_totals(axis, data, maximum)
        _label_phases(axis, data, heights)
        dds, zenoh = (saturation_hosts(each, *robot) for each in PAPER_PROTOCOLS)
        axis.set_title(f"{name}$N_P = {robot[0]:g}$, $N_E = {robot[1]:g}$")
        headline(figure, f"{dds:.2f} robots with DDS and {zenoh:.2f} with Zenoh fill a second")
    return figure


def fig2(
    processes: float = FIG2_PROCESSES,
    endpoints: float = FIG2_ENDPOINTS,
    hosts: int = 12,
    wifi: AnyWifi = PAPER,
) -> Figure:
    """Draw utilization against hosts: Fig. 2, or other robots, more hosts, another channel."""
    data = fig2_data(processes, endpoints, hosts, wifi)
    return _utilization_by_hosts(data, (processes, endpoints, wifi), 2, (0, 0))


def fig3() -> Figure:
    """Draw Fig. 3: utilization against processes and endpoints (N_H = 3).

    Above maps with lines of equal utilization, and the robots with 40 endpoints on a host; below
    only these robots. The paper draws surfaces in three dimensions.
    """
    data = fig3_data()
    parts = dict(list(data.groupby(["part", "protocol"], sort=False)))
    with style():
        figure = Figure(figsize=(WIDTH, 5.0))
        grid = figure.add_gridspec(2, 2, height_ratios=(1, 0.85))
        left = figure.add_subplot(grid[0, 0], ylabel="endpoints of each $N_E$")
        right = figure.add_subplot(grid[0, 1], sharey=left)
        for axis, protocol in zip((left, right), PAPER_PROTOCOLS, strict=True):
            surface, line = parts["surface", protocol.name], parts["trajectory", protocol.name]
            _draw_map(axis, surface, line, color_of(protocol))
            axis.set_title(protocol.name)
        right.tick_params(labelleft=False)
        axis = figure.add_subplot(grid[1, :])
        for protocol in PAPER_PROTOCOLS:
            color, line = color_of(protocol), parts["trajectory", protocol.name]
            axis.plot(line["processes"], line["utilization"], color=color)
            even = line[line["processes"].isin(even_process_counts())]
            axis.plot(even["processes"], even["utilization"], "o", color=color)
            end = tuple(line.iloc[-1][["processes", "utilization"]])
            _label(axis, protocol.name, end, (4, 0), color, va="center")
        for protocol, (ha, va, offset) in zip(PAPER_PROTOCOLS, _LABEL_SIDES, strict=True):
            line = parts["trajectory", protocol.name]
            full = float(np.interp(1, line["utilization"], line["processes"]))
            text, color = f"full at {full:.1f} processes", color_of(protocol)
            _label(axis, text, (full, 1), offset, color, ha=ha, va=va, fontsize=9)
        _format_percent_axis(axis, 2)
        axis.set_xlim(0.7, 11)
        axis.xaxis.set_major_locator(MultipleLocator(1))
        endpoints = f"$N_P N_E = {FIG3_ENDPOINTS_IN_ALL}$ endpoints"
        axis.set_xlabel(f"processes on a host $N_P$, with {endpoints}")
        headline(figure, f"The same {FIG3_ENDPOINTS_IN_ALL} endpoints cost more in more processes")
    return figure


def _draw_map(axis: Axes, surface: pd.DataFrame, line: pd.DataFrame, color: str) -> None:
    """Draw lines of equal utilization, a thick one for a full channel, and the dashed line."""
    grid = surface.pivot_table(index="endpoints", columns="processes", values="utilization")
    levels = [0.25, 0.5, 1, 2]
    look: dict[str, Any] = {"levels": levels, "colors": color}
    look |= {"linewidths": [2.6 if level == 1 else 1 for level in levels]}
    lines = axis.contour(grid.columns, grid.index, grid.to_numpy(), **look)
    # Each label stands where the dashed line does not cross its curve: the first low in the map.
    points = []
    for path, height in zip(lines.get_paths(), [5, 18, 18, 18], strict=True):
        vertices = np.asarray(path.vertices)
        points.append(tuple(vertices[np.abs(vertices[:, 1] - height).argmin()]))
    for text in axis.clabel(lines, fmt=lambda level: f"{level:.0%}", fontsize=8, manual=points):
        text.set_bbox({"facecolor": "white", "edgecolor": "none", "pad": 0.5})
    label = f"{FIG3_ENDPOINTS_IN_ALL} endpoints in all"
    axis.plot(line["processes"], line["endpoints"], "--", color="black", label=label, zorder=1)
    axis.legend(loc="upper right", fontsize=8)
    axis.xaxis.set_major_locator(MultipleLocator(3, 1))
    axis.set_xlabel("processes on a host $N_P$")


def even_process_counts() -> list[int]:
    """Return the numbers of processes that share the 40 endpoints of Fig. 3 evenly."""
    return [n for n in range(1, 11) if FIG3_ENDPOINTS_IN_ALL % n == 0]


def fig4() -> Figure:
    """Draw Fig. 4: utilization of the Nav2 scenario against hosts (N_P = 1, N_E = 678)."""
    robot = FIG4_PROCESSES, FIG4_ENDPOINTS
    return _utilization_by_hosts(fig4_data(), robot, 4, (-4, 8), "Nav2: ")


#: The paper's figures: functions of their data, and functions that draw them.
FIGURES: dict[str, tuple[Callable[[], pd.DataFrame], Callable[[], Figure]]] = {
    "fig2": (fig2_data, fig2),
    "fig3": (fig3_data, fig3),
    "fig4": (fig4_data, fig4),
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
        path, content = folder / f"{name}.{kind}", io.BytesIO()
        with style():
            # With an engine, even "none", each file would first be drawn once more.
            mpl.rcParams["figure.constrained_layout.use"] = False
            figure.set_layout_engine(None)
            figure.savefig(content, dpi=200, metadata=metadata, format=kind)
        atomic_write(path, content.getvalue())
        yield path


#: Names of the files that `save_all` writes, in this order.
FILES = tuple(f"{name}.{kind}" for name in FIGURES for kind in (*_METADATA, "csv"))


def save_all(folder: Path) -> Iterator[Path]:
    """Write Figs. 2-4 and their data into a folder, made if missing; yield each path."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, (data, draw) in FIGURES.items():
        yield from save(draw(), folder, name)
        path = folder / f"{name}.csv"
        atomic_write(path, data().to_csv(index=False, lineterminator="\n").encode())
        yield path
