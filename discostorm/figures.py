"""Figures 2 to 4 of the paper: their data as tables, and functions that draw them.

``python -m discostorm.figures FOLDER`` writes all of them as SVG, PDF and PNG, with CSV.
"""

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from importlib.resources import as_file, files
from pathlib import Path

import matplotlib as mpl
import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator, PercentFormatter
from numpy.typing import NDArray

from discostorm.dds import DDS
from discostorm.messages import Protocol
from discostorm.scalability import saturation_hosts, utilization
from discostorm.zenoh import ZENOH

PROTOCOLS = (DDS, ZENOH)

#: One colour a protocol, one line style a phase, in all figures.
COLORS = {"DDS": "#0072B2", "Zenoh": "#D55E00"}
STYLES = {
    "total": "-",
    "SPDP": ":",
    "Scouting": ":",
    "SEDP": "--",
    "Declaration": "--",
}

# The paper's parameters of each figure: Fig. 2, 3 and 4 captions and Sec. IV-C.
FIG2_PROCESSES, FIG2_ENDPOINTS = 2, 10
FIG3_HOSTS, FIG3_ENDPOINTS_IN_ALL = 3, 40
FIG4_PROCESSES, FIG4_ENDPOINTS = 1, 678


@contextmanager
def style() -> Iterator[None]:
    """Draw with the looks of the book inside a ``with`` block."""
    with (
        as_file(files("discostorm") / "data" / "discostorm.mplstyle") as path,
        mpl.rc_context(fname=path),
    ):
        yield


def steps(first: int, last: int) -> NDArray[np.float64]:
    """Return first to last in steps of a tenth: whole numbers, and smooth curves between."""
    return np.arange(10 * first, 10 * last + 1) / 10


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
        for protocol in PROTOCOLS
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
        for protocol in PROTOCOLS
        for part, (processes, endpoints) in parts.items()
    ).reset_index(drop=True)


def fig4_data() -> pd.DataFrame:
    """Return the data of Fig. 4: utilization of the Nav2 scenario against hosts."""
    return phases_data(steps(1, 5), FIG4_PROCESSES, FIG4_ENDPOINTS)


def _percent(axis: Axes, most: float) -> None:
    axis.axhline(1, color="black", linewidth=1)
    axis.set_ylim(0, most)
    axis.yaxis.set_major_formatter(PercentFormatter(1))
    axis.set_ylabel("channel utilization")


def _phases(axis: Axes, data: pd.DataFrame, processes: float, endpoints: float) -> None:
    """Draw each phase and the total against hosts, and mark the saturation points."""
    for (protocol, phase), rows in data.groupby(["protocol", "phase"], sort=False):
        axis.plot(
            rows["hosts"],
            rows["utilization"],
            STYLES[phase],
            color=COLORS[protocol],
            marker="." if phase == "total" else None,
            markevery=10,
            label=f"{protocol} {phase}",
        )
    for protocol in PROTOCOLS:
        hosts = saturation_hosts(protocol, processes, endpoints)
        axis.plot(
            hosts,
            1,
            "o",
            color=COLORS[protocol.name],
            markeredgecolor="white",
            markersize=8,
            zorder=3,
            label=f"{protocol.name} saturates at {hosts:.2f}",
        )
    axis.set_xlim(data["hosts"].min(), data["hosts"].max())
    axis.set_xlabel("hosts $N_H$ [1]")


def fig2() -> Figure:
    """Draw Fig. 2: utilization against hosts (N_P = 2, N_E = 10)."""
    with style():
        figure, axis = plt.subplots()
        _phases(axis, fig2_data(), FIG2_PROCESSES, FIG2_ENDPOINTS)
        _percent(axis, 2)
        axis.xaxis.set_major_locator(MaxNLocator(integer=True))
        axis.set_title(f"$N_P = {FIG2_PROCESSES}$, $N_E = {FIG2_ENDPOINTS}$")
        axis.legend(loc="upper left")
    return figure


def fig3() -> Figure:
    """Draw Fig. 3: utilization against processes and endpoints (N_H = 3).

    Above the paper's surfaces with the line of 40 endpoints on a host, below the same
    line on its own.
    """
    data = fig3_data()
    lines = dict([*data[data["part"] == "trajectory"].groupby("protocol")])
    surfaces = dict([*data[data["part"] == "surface"].groupby("protocol")])
    with style():
        figure = plt.figure(figsize=(6.4, 6.2))
        above, below = figure.subfigures(2, 1, height_ratios=[1, 1])
        for column, protocol in enumerate(PROTOCOLS, start=1):
            name = protocol.name
            axis = above.add_subplot(1, 2, column, projection="3d", computed_zorder=False)
            grid = surfaces[name].pivot_table(
                index="endpoints", columns="processes", values="utilization"
            )
            axis.plot_surface(
                *np.meshgrid(grid.columns, grid.index),
                100 * grid.to_numpy(),
                color=COLORS[name],
                alpha=0.55,
                linewidth=0.2,
                edgecolor="white",
                rcount=21,
                ccount=10,
            )
            line = lines[name]
            axis.plot(line["processes"], line["endpoints"], 100 * line["utilization"], "k")
            axis.view_init(elev=24, azim=-125)
            axis.set_title(name, y=0.94)
            axis.set_xlabel("processes $N_P$ [1]", labelpad=-4)
            axis.set_ylabel("endpoints $N_E$ [1]", labelpad=-4)
            axis.set_zlabel("utilization [%]", labelpad=-1)
            axis.tick_params(pad=-2, labelsize=8)
            axis.yaxis.set_major_locator(MaxNLocator(4))
            axis.set_box_aspect((1, 1, 0.85), zoom=0.86)
        axis = below.subplots()
        for name, line in lines.items():
            axis.plot(line["processes"], line["utilization"], color=COLORS[name], label=name)
            whole = line[line["processes"].isin(whole_divisions())]
            axis.plot(whole["processes"], whole["utilization"], "o", color=COLORS[name])
        _percent(axis, 2)
        axis.set_xlabel(
            f"processes on a host $N_P$ [1], with $N_P N_E = {FIG3_ENDPOINTS_IN_ALL}$ endpoints"
        )
        axis.legend(loc="upper left")
    return figure


def whole_divisions() -> list[int]:
    """Return the numbers of processes that share the 40 endpoints of Fig. 3 evenly."""
    return [n for n in range(1, 11) if FIG3_ENDPOINTS_IN_ALL % n == 0]


def fig4() -> Figure:
    """Draw Fig. 4: utilization of the Nav2 scenario (N_P = 1, N_E = 678).

    Below, on a logarithmic scale, the phases that the linear scale cannot show.
    """
    with style():
        figure, (above, below) = plt.subplots(2, 1, figsize=(6.4, 6.4), sharex=True)
        data = fig4_data()
        for axis in (above, below):
            _phases(axis, data, FIG4_PROCESSES, FIG4_ENDPOINTS)
        _percent(above, 4)
        _percent(below, 4)
        below.set_yscale("log")
        below.set_ylim(1e-3, 10)
        below.yaxis.set_major_formatter(lambda value, _: f"{100 * value:g}%")
        above.set_xlabel("")
        below.xaxis.set_major_locator(MaxNLocator(integer=True))
        above.set_title(f"Nav2: $N_P = {FIG4_PROCESSES}$, $N_E = {FIG4_ENDPOINTS}$")
        above.legend(loc="upper left")
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


def save(figure: Figure, folder: Path, name: str) -> list[Path]:
    """Write a figure as SVG, PDF and PNG, the same bytes every time; return the paths."""
    paths = [folder / f"{name}.{kind}" for kind in _METADATA]
    with style():
        for path in paths:
            figure.savefig(path, dpi=200, metadata=_METADATA[path.suffix[1:]])
    return paths


def save_all(folder: Path) -> Iterator[Path]:
    """Write Figs. 2-4 and their data into a folder, made if missing; yield each path."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, paper in FIGURES.items():
        figure = paper.draw()
        yield from save(figure, folder, name)
        plt.close(figure)
        path = folder / f"{name}.csv"
        paper.data().to_csv(path, index=False, lineterminator="\n")
        yield path


if __name__ == "__main__":
    mpl.use("Agg")
    for written in save_all(Path(sys.argv[1])):
        print(written)  # noqa: T201
