"""What a plan would change."""

import math
from textwrap import wrap

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import FuncFormatter, NullLocator
from matplotlib.transforms import blended_transform_factory
from numpy.typing import NDArray

from discostorm import wording
from discostorm.figures.style import WIDTH, headline, style
from discostorm.messages import PAPER_WINDOW
from discostorm.palette import light_colors

#: Colors of what is not changed, and of a change after which the fleet fits, or does not.
CHANGE = light_colors("change")
#: What the legend calls them.
_LEGEND = {"none": "today", "fits": "after the change: fits", "overloaded": "does not fit"}
#: Letters of a name in a line, inches of a line, and height of a row in inches.
_LETTERS, _ROW = 44, 0.215


def remedies(changes: pd.DataFrame, window: float = PAPER_WINDOW, title: str = "") -> Figure:
    """Draw what each change makes of a fleet as a dumbbell, in a group for each baseline.

    A gray dot is the fleet before the change, by the same model and on the same kind of channel.
    A blue dot is the fleet after it, dark if it fits. Dots are seconds of airtime, and a line marks
    the window. In the steady state they are shares of the channel, and the line marks all of it.
    The axis is logarithmic unless something needs no airtime.

    Parameters
    ----------
    changes : pandas.DataFrame
        One row each, with columns baseline, change and utilization [1]. A row whose change is empty
        is the baseline itself.
    window : float, optional
        The seconds that are averaged [s]; infinity for the steady state.
    title : str, optional
        What the figure shows.

    Returns
    -------
    matplotlib.figure.Figure
    """
    groups = [rows for _, rows in changes.groupby("baseline", sort=False)]
    names = ["\n".join(wrap(name, _LETTERS)) for group in groups for name in group["change"]]
    # A name of two lines needs more room: half a row for each line more, above and below.
    more = np.array([0.3 * name.count("\n") for name in names])
    places = np.arange(len(names)) + 2 * more.cumsum() - more
    with style():
        figure = Figure(figsize=(WIDTH, 1.3 + _ROW * (places[-1] + 1)))
        axis = figure.subplots()
        low, high = changes["utilization"].min(), changes["utilization"].max()
        if low > 0:
            axis.set_xscale("log")
            axis.set_xlim(min(0.5, low) / 3, 3 * max(1.0, high))
        else:
            axis.set_xlim(0, 1.2 * max(1.0, high))
        ends = np.cumsum([len(group) for group in groups])
        for group, of_group in zip(groups, np.split(places, ends), strict=False):
            _group(axis, group, of_group, window)
        axis.set_ylim(places[-1] + 0.6, -0.8)
        axis.set_yticks(places, names)
        axis.tick_params(axis="y", length=0, labelsize=8.5)
        axis.spines["left"].set_visible(False)
        axis.grid(visible=False, axis="y")
        steady = math.isinf(window)
        axis.xaxis.set_minor_locator(NullLocator())
        axis.xaxis.set_major_formatter(
            FuncFormatter(lambda x, _: wording.percent(x) if steady else f"{x * window:,g}")
        )
        axis.set_xlabel("share of the channel [%]" if steady else "airtime [s]")
        line = "the whole channel" if steady else f"{window:,g} s"
        axis.text(1, 1.0, line, ha="center", va="bottom", transform=axis.get_xaxis_transform())
        axis.text(1.02, 1.0, "after", va="bottom", fontsize=9, transform=axis.transAxes)
        headline(figure, title)
        marks = [
            Line2D([], [], marker="o", linestyle="", color=CHANGE[key], label=label)
            for key, label in _LEGEND.items()
        ]
        figure.legend(handles=marks, loc="outside lower center", ncols=len(marks), columnspacing=1)
    return figure


def _group(axis: Axes, group: pd.DataFrame, places: NDArray[np.float64], window: float) -> None:
    """Draw one baseline and what is compared with it, in its rows."""
    (before, *after) = group["utilization"]
    left = blended_transform_factory(axis.figure.transSubfigure, axis.transData)
    taken = _remedy_label(before, window)
    head = axis.text(
        0.01, places[0], f"{group['baseline'].iloc[0]}: {taken} today",
        va="center", fontsize=9, fontweight="bold", transform=left,
    )  # fmt: skip
    head.set_in_layout(False)  # else the panel would never begin farther left than at first
    # Not beside the dots, where numbers would cover the line.
    right = axis.get_yaxis_transform()
    for row, part in zip(places[1:], after, strict=True):
        color = CHANGE["fits" if wording.below_capacity(part) else "overloaded"]
        axis.plot([1, 1], [row - 0.5, row + 0.5], color="black", linewidth=1, zorder=1)
        axis.plot([before, part], [row, row], color=CHANGE["overloaded"], linewidth=2, zorder=2)
        axis.plot(before, row, "o", color=CHANGE["none"], zorder=3)
        axis.plot(part, row, "o", color=color, zorder=4)
        axis.text(1.02, row, _remedy_label(part, window), va="center", fontsize=9, transform=right)


def _remedy_label(part: float, window: float) -> str:
    return wording.percent(part) if math.isinf(window) else wording.duration(part * window)
