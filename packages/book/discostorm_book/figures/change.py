"""Figure of the chapter on what to change first: which configuration admits how many robots."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
import pandas as pd
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import MaxNLocator

from discostorm import measured
from discostorm.data import read_data
from discostorm.figures import WIDTH, headline, style
from discostorm.fleet import Fleet, HostGroup
from discostorm.model import utilization
from discostorm.palette import lights
from discostorm.protocols import MEASURED, PROTOCOLS
from discostorm_book.figures.servers import BREAKS, breaks

_MANY = np.arange(1.0, 200)  # hosts


def configurations_data(robots: Mapping[str, HostGroup]) -> pd.DataFrame:
    """Return how many robots fit within one second by configuration, and what else can fail.

    Parameters
    ----------
    robots : mapping
        One host of each robot, by what the figure calls it.
    """
    shipped = {
        row["instead_of"] for row in read_data("vendors/configuration_risks.csv", "discostorm_book")
    }
    shown = [name for name in PROTOCOLS if name in shipped or name in measured.configurations()]

    def fit(name: str, robot: HostGroup) -> int:
        taken = utilization(PROTOCOLS[name], Fleet((replace(robot, hosts=_MANY),)))
        return int(np.sum(np.asarray(taken) < 1))

    data = pd.DataFrame(
        {"configuration": name, "what else fails": breaks(name)}
        | {f"{robot} that fit": fit(name, one) for robot, one in robots.items()}
        for name in shown
    )
    by = [f"{robot} that fit" for robot in robots]
    return data.sort_values(by, ascending=False, kind="stable").reset_index(drop=True)


def configurations(robots: Mapping[str, HostGroup]) -> Figure:
    """Draw how many robots fit with each configuration, one panel per robot.

    Parameters
    ----------
    robots : mapping
        One host of each robot, by what the figure calls it.
    """
    data = configurations_data(robots)
    colors = lights("series")
    with style():
        figure = Figure(figsize=(WIDTH, 1.5 + 0.2 * len(data)))
        panels = figure.subplots(1, len(robots), sharey=True, squeeze=False)[0]
        for axis, robot in zip(panels, robots, strict=True):
            many = data[f"{robot} that fit"]
            for place, (fit, what) in enumerate(zip(many, data["what else fails"], strict=True)):
                color, mark = BREAKS[what]
                axis.plot([0, fit], [place, place], color="0.8", linewidth=1, zorder=1)
                axis.plot(fit, place, marker=mark, color=colors[color], markersize=7, mew=0)
                axis.annotate(
                    f"{fit}", (fit, place), (7, 0), textcoords="offset points", va="center",
                    fontsize=9,
                )  # fmt: skip
            axis.set(xlim=(-0.3, 1.25 * many.max()), xlabel=f"{robot} that fit")
            axis.xaxis.set_major_locator(MaxNLocator(4, integer=True))
            axis.grid(visible=False, axis="y")
            axis.spines["left"].set_visible(False)
            axis.tick_params(axis="y", length=0, labelsize=8.5)
        names = [
            f"{name}, as shipped" if name in MEASURED else name for name in data["configuration"]
        ]
        panels[0].set_yticks(range(len(data)), names)
        panels[0].invert_yaxis()
        headline(figure, "Which configuration admits most depends on the robot")
        marks = [
            Line2D([], [], marker=mark, linestyle="", color=colors[color], mew=0, label=what)
            for what, (color, mark) in BREAKS.items()
        ]
        figure.legend(
            handles=marks, title="If its server or router fails, so does", ncols=2,
            loc="outside lower center",
        )  # fmt: skip
    return figure
