"""Figure of the chapter on what to change first: which configuration admits how many robots."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
import pandas as pd
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from discostorm import measured
from discostorm.fleet import Fleet, HostGroup
from discostorm.model import utilization
from discostorm.protocols import MEASURED, PROTOCOLS
from discostorm_book.figures import servers
from discostorm_book.figures.drawing import drawn, name_rows_without_ticks, write_text

_MANY = np.arange(1.0, 200)  # hosts


def configurations_data(robots: Mapping[str, HostGroup]) -> pd.DataFrame:
    """Return how many robots fit within one second by configuration, and what else can fail."""
    shown = {*servers.instead_of().values(), *measured.configurations()}

    def fit(name: str, robot: HostGroup) -> int:
        taken = utilization(PROTOCOLS[name], Fleet((replace(robot, hosts=_MANY),)))
        return int(np.sum(np.asarray(taken) < 1))

    data = pd.DataFrame(
        {"configuration": name, "what else fails": servers.consequence_of(name)}
        | {f"{robot} that fit": fit(name, one) for robot, one in robots.items()}
        for name in PROTOCOLS
        if name in shown
    )
    by = [f"{robot} that fit" for robot in robots]
    return data.sort_values(by, ascending=False, kind="stable").reset_index(drop=True)


def configurations(robots: Mapping[str, HostGroup]) -> Figure:
    """Draw how many robots fit with each configuration, one panel per robot."""
    data = configurations_data(robots)
    shown = [servers.NAMED.get(name, name) for name in data["configuration"]]
    title = "Which configuration admits most depends on the robot"
    with drawn(1.5 + 0.2 * len(data), title) as figure:
        panels = figure.subplots(1, len(robots), sharey=True, squeeze=False)[0]
        for axis, robot in zip(panels, robots, strict=True):
            many = data[f"{robot} that fit"]
            for y, (fit, what) in enumerate(zip(many, data["what else fails"], strict=True)):
                axis.plot([0, fit], [y, y], color="0.8", linewidth=1, zorder=1)
                axis.plot(fit, y, ms=7, **servers.consequence_style(what))
                write_text(axis, f"{fit}", (fit, y), (7, 0), va="center")
            axis.set(xlim=(-0.3, 1.25 * many.max()), xlabel=f"{robot} that fit")
            axis.xaxis.set_major_locator(MaxNLocator(4, integer=True))
            axis.spines["left"].set_visible(False)
            name_rows_without_ticks(axis, labelsize=8.5)
        names = [f"{name}, as shipped" if name in MEASURED else name for name in shown]
        panels[0].set_yticks(range(len(data)), names)
        panels[0].invert_yaxis()
        servers.consequence_legend(figure, "If its server or router fails, so does", 6)
    return figure
