"""Plot a capture: messages over time, and the share of the channel that they take."""

import matplotlib as mpl
import numpy as np
import pandas as pd
from matplotlib.figure import Figure
from matplotlib.ticker import PercentFormatter

from discostorm.data import data_path
from discostorm.palette import light_colors

#: Number of intervals, maximum number of kinds with a color of their own, size [inches].
_N_INTERVALS, _MAX_KINDS, _FIGURE_INCHES = 60, 7, (5.6, 4.8)
#: Time grows along the axis with this power, so that the startup is not squeezed.
_TIME_POWER = 1.5
#: Fixed colors of the kinds that the paper counts, colors of other kinds, and color of the rest.
_PAPER_KIND_COLORS = light_colors("shade")
_OTHER_KIND_COLORS = tuple(light_colors("captured other").values())
_REST_COLOR = light_colors("neutral")["silver"]


def plot_messages_and_airtime(rows: pd.DataFrame, channel: str) -> Figure:
    """Plot messages (at least one) over time, stacked by kind, and their airtime on a channel."""
    time = rows["time"].to_numpy() - rows["time"].min()
    span = max(time.max(), 1e-3)
    # Intervals grow with time, so that they have the same width on the stretched axis.
    edges = span * np.linspace(0, 1, _N_INTERVALS + 1) ** _TIME_POWER
    part = (time / span) ** (1 / _TIME_POWER)
    which = np.minimum((part * _N_INTERVALS).astype(np.int64), _N_INTERVALS - 1)
    width = np.diff(edges)
    # The kinds with the most airtime; ties are broken by name.
    total = rows.groupby("kind", observed=True)["airtime_s"].sum()
    shown = sorted(total.index, key=lambda kind: (-total[kind], kind))[:_MAX_KINDS]
    kinds = rows["kind"].astype(str).to_numpy()
    others = (kind for kind in sorted(shown) if kind not in _PAPER_KIND_COLORS)
    colors = dict(zip(others, _OTHER_KIND_COLORS, strict=False)) | _PAPER_KIND_COLORS
    parts = [(kind, colors[kind], kinds == kind) for kind in shown]
    if len(total) > len(shown):
        parts.append((f"{len(total) - len(shown)} others", _REST_COLOR, ~np.isin(kinds, shown)))
    with mpl.rc_context(fname=data_path("discostorm.mplstyle")):
        figure = Figure(figsize=_FIGURE_INCHES, layout="constrained")
        above, below = figure.subplots(2, 1, sharex=True)
        airtime = rows["airtime_s"].to_numpy()
        for axis, weight in ((above, np.ones(len(time))), (below, airtime / width[which])):
            bottom = np.zeros(_N_INTERVALS)
            for kind, color, mask in parts:
                height = np.bincount(which[mask], weight[mask], _N_INTERVALS)
                bars = np.array([edges[:-1], height, width, bottom])[:, height > 0]
                axis.bar(*bars, align="edge", color=color, label=kind)
                bottom += height
        above.set_ylabel("messages in an interval")
        below.set_ylabel("airtime [% of the channel]")
        below.yaxis.set_major_formatter(PercentFormatter(1, symbol=None))
        if below.get_ylim()[1] > 0.9:
            below.axhline(1, color="black", linewidth=1)
        below.set_xlabel(f"time [s], its start stretched; airtime on {channel}")
        powers = (lambda x: np.abs(x) ** (1 / _TIME_POWER), lambda x: np.abs(x) ** _TIME_POWER)
        below.set_xscale("function", functions=powers)
        below.set_xlim(0, span)
        marks = [digit * 10.0**power for power in range(-5, 7) for digit in (1, 2, 5)]
        marks = [0, *(mark for mark in marks if span / 30 <= mark <= span)]
        below.set_xticks(marks, [f"{mark:g}" for mark in marks])
        above.legend(ncols=2, fontsize="small")
    return figure
