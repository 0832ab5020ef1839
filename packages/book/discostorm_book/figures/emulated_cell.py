"""Figure of the chapter on the emulated cell: measured and simulated discovery times."""

import numpy as np
import pandas as pd
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from discostorm.data import data_path
from discostorm.figures import COLORS
from discostorm_book.figures.drawing import Style, book_figure, legend_below, set_ticks, write_text

#: Position of a time that was not reached [s].
NEVER_AT = 60.0
#: Factor between the measured and the simulated time that counts as agreement.
MARGIN = 1.3
_MARKERS = dict(zip(("2.6.12", "2.9.1", "2.14.6", "3.6.2", "0.10.5"), "os^DX", strict=True))


def read_points(usual: bool = True) -> pd.DataFrame:
    """Read `measured/air.csv`, usual startups or all others; a time not reached is infinite."""
    points = pd.read_csv(data_path("measured/air.csv", "discostorm_book"))
    texts = points.select_dtypes(exclude="number").columns
    points[texts] = points[texts].fillna("")
    is_usual = (points[["server", "start"]] == "").all(axis=1) & (points["standard"] == "n")
    return points[is_usual == usual].fillna(np.inf)


def agreement(points: pd.DataFrame, title: str) -> Figure:
    """Draw the time until 95% of the pairs know each other at each point, by the simulated time."""
    with book_figure(4.3, title) as figure:
        axis = figure.subplots()
        ends = np.array([0.03, 70])
        axis.plot(ends, ends, color="gray", lw=0.8)
        axis.fill_between(ends, ends / MARGIN, ends * MARGIN, color="gray", alpha=0.2, lw=0)
        axis.axhline(NEVER_AT, color="gray", ls=":", lw=0.8)
        handles = {}
        for _, point in points.replace(np.inf, NEVER_AT).iterrows():
            name, version = str(point["release"]).split("-")
            color = COLORS[str(point["protocol"])]
            look: Style = {"color": color, "marker": _MARKERS[version], "ms": 6, "ls": "none"}
            filled: Style = {"markerfacecolor": "none" if point["ampdu"] else color}
            axis.plot(point["simulated_t95_s"], point["t95_s"], **look, **filled)
            product = {"fast_dds": "Fast DDS", "cyclone_dds": "Cyclone DDS"}[name]
            handles[version] = Line2D([], [], **look, label=f"{product} {version}")
        axis.set(xscale="log", yscale="log", xlim=ends, ylim=(0.03, 90))
        axis.set(xlabel="simulated [s]", ylabel="measured [s]")
        ticks = (0.1, 0.3, 1, 3, 10, 30)
        axis.set_yticks([*ticks, NEVER_AT], [*map(str, ticks), "never"])
        axis.set_yticks([], minor=True)
        set_ticks(axis.xaxis, ticks)
        write_text(axis, "equal", (27, 27), (4, -10), color="dimgray")
        axis.spines[["top", "right"]].set_visible(False)
        legend_below(figure, list(handles.values()), 3)
    return figure
