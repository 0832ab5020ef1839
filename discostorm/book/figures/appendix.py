"""Figures of the appendix: how sure the numbers are."""

from collections.abc import Sequence

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from discostorm import uncertainty
from discostorm.figures import WIDTH, color_of, style
from discostorm.messages import Protocol
from discostorm.saturation import saturation_hosts

#: What all parameters at their best or worst ends are called.
TOGETHER = "all together"
_KINDS = {"O": "overhead", "R": "rate", "H": "headers", "s": "payload"}
_LINKS = {"uni": "unicast", "multi": "multicast"}


def parameter_name(symbol: str) -> str:
    """Return what a parameter is called, as "unicast overhead" for ``O_uni``.

    Examples
    --------
    >>> parameter_name("O_uni"), parameter_name("s_SEDP")
    ('unicast overhead', 'SEDP payload')
    """
    kind, _, of = symbol.partition("_")
    return f"{_LINKS.get(of, of)} {_KINDS[kind]}"


def tornado_data(protocols: Sequence[Protocol], processes: int, endpoints: int) -> pd.DataFrame:
    """Return the saturation points at both ends of each parameter's range, and of all together."""
    tables = []
    for protocol in protocols:
        ends = uncertainty.sensitivity(protocol, processes, endpoints)
        low, high = uncertainty.saturation_bounds(protocol, processes, endpoints)
        at = np.sort(ends[["hosts_at_low", "hosts_at_high"]].to_numpy(), axis=1)
        tables.append(
            pd.DataFrame(
                {
                    "protocol": protocol.name,
                    "parameter": [TOGETHER, *map(parameter_name, ends.index)],
                    "fewest_hosts": [low, *at[:, 0]],
                    "paper_hosts": saturation_hosts(protocol, processes, endpoints),
                    "most_hosts": [high, *at[:, 1]],
                }
            )
        )
    return pd.concat(tables)


def tornado(
    protocols: Sequence[Protocol], processes: int, endpoints: int, shown: int = 5
) -> Figure:
    """Draw how far each parameter alone moves the saturation point: a panel a protocol.

    Parameters
    ----------
    protocols : sequence of Protocol
        The paper's.
    processes, endpoints : int
        Of each host, of each process.
    shown : int
        So many parameters, those that move it most.
    """
    data = tornado_data(protocols, processes, endpoints)
    with style():
        figure = Figure(figsize=(WIDTH, 2.6 * len(protocols)))
        panels = figure.subplots(len(protocols), 1, sharex=True)
        for axis, protocol in zip(np.atleast_1d(panels), protocols, strict=True):
            rows = data[data["protocol"] == protocol.name].head(shown + 1)
            _bars(axis, rows, color_of(protocol))
            paper = rows["paper_hosts"].iloc[0]
            axis.set_title(f"{protocol.name}: {paper:.2f} robots by the paper's values", loc="left")
        axis.set_xlabel("robots at which the channel is full")
        axis.set_xlim(data["fewest_hosts"].min() - 0.6, data["most_hosts"].max() + 0.6)
        figure.suptitle("The unicast overhead alone moves the result by two robots")
    return figure


def _bars(axis: Axes, rows: pd.DataFrame, color: str) -> None:
    """Draw a bar a row from the fewest to the most hosts, with both numbers at its ends."""
    places = np.arange(len(rows))[::-1]
    for place, row in zip(places, rows.itertuples(), strict=True):
        together = row.parameter == TOGETHER
        axis.plot(
            [row.fewest_hosts, row.most_hosts],
            [place, place],
            color="0.35" if together else color,
            linewidth=7,
            solid_capstyle="butt",
        )
        for end, align, gap in ((row.fewest_hosts, "right", -0.06), (row.most_hosts, "left", 0.06)):
            axis.text(end + gap, place, f"{end:.2f}", ha=align, va="center", fontsize=9)
    axis.axvline(rows["paper_hosts"].iloc[0], color="black", linewidth=1, zorder=3)
    axis.set_yticks(places, rows["parameter"])
    axis.set_ylim(-0.6, len(rows) - 0.4)
    axis.grid(axis="y", visible=False)
    axis.tick_params(axis="y", length=0)
