"""What a plan would change."""

import math

import numpy as np
import pandas as pd
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter

from discostorm import words
from discostorm.figures.looks import WIDTH, style
from discostorm.messages import PAPER_WINDOW
from discostorm.palette import lights

#: Colors of what is not changed, and of a change after which the fleet fits, or does not.
CHANGE = lights("change")

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
        fits = np.where(taken < 1, CHANGE["fits"], CHANGE["overloaded"])
        colors = np.where(unchanged, CHANGE["none"], fits)
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
