"""A capture as a picture: messages over time, and what they take of the channel."""

from __future__ import annotations

from typing import TYPE_CHECKING

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import PercentFormatter

from discostorm.data import data_path

if TYPE_CHECKING:
    import pandas as pd

#: Intervals in the picture, kinds with a colour of their own, inches.
_INTERVALS, _KINDS, _SIZE = 60, 7, (5.6, 4.8)
#: Okabe and Ito's colours, which the colour-blind tell apart: the same in every picture for what
#: the paper counts, in order for other kinds, and grey for the rest.
_COLORS = {
    "SPDP": "#0072B2",
    "SEDP": "#E69F00",
    "Heartbeat": "#56B4E9",
    "ACKNACK": "#D55E00",
    "Scout": "#0072B2",
    "Declare": "#E69F00",
    "Hello": "#56B4E9",
    "KeepAlive": "#D55E00",
}
_OTHERS = ("#009E73", "#CC79A7", "#332288", "#F0E442", "#000000", "#882255", "#44AA99")
_REST = "#999999"


def draw(rows: pd.DataFrame, channel: str) -> Figure:
    """Draw messages over time, stacked by kind, and their airtime a second of a channel.

    Parameters
    ----------
    rows : pandas.DataFrame
        Messages with ``time``, ``kind`` and ``airtime_s``; at least one.
    channel : str
        What the channel is called.
    """
    time = rows["time"].to_numpy()
    edges = np.linspace(time.min(), max(time.max(), time.min() + 1e-3), _INTERVALS + 1)
    width = edges[1] - edges[0]
    which = np.clip(((time - edges[0]) / width).astype(np.int64), 0, _INTERVALS - 1)
    # Those that take the most airtime; of the same, the first by name.
    total = rows.groupby("kind", observed=True)["airtime_s"].sum()
    shown = sorted(total.index, key=lambda kind: (-total[kind], kind))[:_KINDS]
    kinds = rows["kind"].astype(str).to_numpy()
    own = dict(zip((kind for kind in sorted(shown) if kind not in _COLORS), _OTHERS, strict=False))
    colors = own | _COLORS
    parts = [(kind, colors[kind], kinds == kind) for kind in shown]
    if len(total) > len(shown):
        parts.append((f"{len(total) - len(shown)} others", _REST, ~np.isin(kinds, shown)))
    with mpl.rc_context(fname=data_path("discostorm.mplstyle")):
        figure = Figure(figsize=_SIZE, layout="constrained")
        above, below = figure.subplots(2, 1, sharex=True)
        airtime = rows["airtime_s"].to_numpy()
        for axis, weight in ((above, np.ones(len(time))), (below, airtime / width)):
            bottom = np.zeros(_INTERVALS)
            for kind, color, mine in parts:
                height = np.bincount(which[mine], weight[mine], _INTERVALS)
                some = height > 0
                place = edges[:-1][some], height[some], width, bottom[some]
                axis.bar(*place, align="edge", color=color, label=kind)
                bottom += height
        above.set_ylabel(f"messages in {width:.3g} s")
        below.set_ylabel("airtime [% of the channel]")
        below.yaxis.set_major_formatter(PercentFormatter(1, symbol=None))
        if below.get_ylim()[1] > 0.9:
            below.axhline(1, color="black", linewidth=1)
        below.set_xlabel(f"time [s]; airtime as on the channel {channel}")
        above.legend(ncols=2, fontsize="small")
    return figure
