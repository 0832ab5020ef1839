"""Figures 2 to 4 of the paper: their data as tables, and functions that draw them."""

from typing import Any

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from matplotlib.ticker import MultipleLocator, PercentFormatter
from numpy.typing import NDArray

from discostorm.figures.looks import STYLES, WIDTH, color_of, style
from discostorm.model import utilization
from discostorm.protocols import DDS, ZENOH
from discostorm.saturation import saturation_hosts

#: What the paper draws.
PAPER_PROTOCOLS = (DDS, ZENOH)

# The paper's parameters of each figure: Fig. 2, 3 and 4 captions and Sec. IV-C.
FIG2_PROCESSES, FIG2_ENDPOINTS = 2, 10
FIG3_HOSTS, FIG3_ENDPOINTS_IN_ALL = 3, 40
FIG4_PROCESSES, FIG4_ENDPOINTS = 1, 678


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
        color = color_of(protocol)
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
        (part, name): rows for (part, name), rows in data.groupby(["part", "protocol"], sort=False)
    }
    with style():
        figure = Figure(figsize=(WIDTH, 5.8))
        # Placed by hand: the layout engine leaves a third of the room around a cube empty.
        figure.set_layout_engine("none")
        for left, protocol in zip((0.0, 0.5), PAPER_PROTOCOLS, strict=True):
            axis = figure.add_axes(
                (left + 0.055, 0.48, 0.44, 0.52), projection="3d", computed_zorder=False
            )
            surface, line = of["surface", protocol.name], of["trajectory", protocol.name]
            _surface(axis, surface, line, color_of(protocol))
            axis.set_title(protocol.name, y=0.97)
        axis = figure.add_axes((0.13, 0.09, 0.85, 0.36))
        for protocol in PAPER_PROTOCOLS:
            color, line = color_of(protocol), of["trajectory", protocol.name]
            axis.plot(line["processes"], line["utilization"], color=color, label=protocol.name)
            whole = line[line["processes"].isin(whole_divisions())]
            axis.plot(whole["processes"], whole["utilization"], "o", color=color)
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
