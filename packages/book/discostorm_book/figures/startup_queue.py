"""Figures of Part II, what the paper's result means."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
import pandas as pd
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter

from discostorm.drain_times import demand, drain_time, first_idle
from discostorm.figures import COLORS, PAPER_PROTOCOLS, color_of, smooth_steps
from discostorm.fleet import Fleet, HostGroup
from discostorm.messages import Protocol
from discostorm.model import utilization
from discostorm_book.figures import drawing
from discostorm_book.figures.drawing import Style, book_figure, write_text

_LINE_STYLES = ("--", "-", "-.")
_TIMES_S = np.geomspace(0.05, 200, 700)  # s after startup
_HOST_COUNTS = np.linspace(2, 55, 531)
_INTEGER_HOSTS = np.arange(2, 56, 3)
_QUEUE_TIMES_S = np.arange(0, 120.01, 0.05)  # s after startup
#: Upper ends of the axes: airtime that waits [s], and utilization in the steady state [1].
_QUEUE_MAX, _STEADY_MAX = 80, 1.5
_TIME_LIMITS = {1: "a second", 10: "lease of 10 s", 20: "lease of 20 s"}


def airtime_demand_data(
    products: Sequence[Protocol], fleets: Sequence[int], swarm: Mapping[str, Any]
) -> pd.DataFrame:
    """Return the airtime requested up to each time, and when the channel goes idle [s]."""
    requested, idle = [], []
    for hosts in fleets:
        columns = {"hosts": hosts, "what": "requested", "time_s": _TIMES_S}
        columns |= {f"{p.name} [s]": demand(p, _TIMES_S, hosts, **swarm) for p in products}
        requested.append(pd.DataFrame(columns))
        times = {f"{p.name} [s]": first_idle(p, hosts, **swarm) for p in products}
        idle.append({"hosts": hosts, "what": "idle"} | times)
    return pd.concat([*requested, pd.DataFrame(idle)])


def airtime_demand(
    products: Sequence[Protocol], fleets: Sequence[int], swarm: Mapping[str, Any]
) -> Figure:
    """Draw the airtime that fleets request, and the channel's capacity: one panel per fleet."""
    data = airtime_demand_data(products, fleets, swarm)
    with book_figure(3.2, "7 robots drain in about a second, 30 outlast their leases") as figure:
        panels = figure.subplots(1, len(fleets), sharey=True)
        for axis, hosts in zip(panels, fleets, strict=True):
            rows = data[data["hosts"] == hosts]
            curves, idle = rows[rows["what"] == "requested"], rows[rows["what"] == "idle"]
            axis.plot(_TIMES_S, _TIMES_S, color="black", linewidth=1.5)
            for product, line in zip(products, _LINE_STYLES, strict=True):
                name, color = f"{product.name} [s]", color_of(product)
                axis.plot(_TIMES_S, curves[name], line, label=product.name, color=color)
                axis.plot(idle[name], idle[name], "o", zorder=3, color=color)
            for limit in _TIME_LIMITS:
                axis.axvline(limit, linestyle=":", **drawing.LIMIT_LINE)
            axis.loglog()
            axis.set(xlim=(0.05, 200), ylim=(0.02, 500), xlabel="time after startup [s]")
            axis.set_title(f"{hosts} robots", loc="left")
            drawing.set_ticks(axis.xaxis, [0.1, *_TIME_LIMITS, 100])
            drawing.set_ticks(axis.yaxis, [0.1, 1, 10, 100])
        write_text(panels[0], "carried\nat most", (3.2, 20), (0, 0), ha="center")
        panels[0].set_ylabel("airtime [s]")
        drawing.legend_below(figure, panels[0].get_legend_handles_labels()[0], 3)
    return figure


def with_period(protocol: Protocol, period: float) -> Protocol:
    """Return a table whose repeated messages have another period [s]; starts stay the same."""
    messages = (
        replace(m, schedule=replace(m.schedule, period=period))
        if np.isfinite(m.schedule.period)
        else m
        for m in protocol.messages
    )
    return replace(protocol, messages=tuple(messages))


def queue_over_time_data(protocol: Protocol, hosts: int, swarm: Mapping[str, Any]) -> pd.DataFrame:
    """Return the airtime that waits, by the time after startup [s]."""
    ahead = np.asarray(demand(protocol, _QUEUE_TIMES_S, hosts, **swarm)) - _QUEUE_TIMES_S
    # An idle channel saves nothing for later.
    lowest = np.minimum(0, np.minimum.accumulate(ahead))
    return pd.DataFrame({"time_s": _QUEUE_TIMES_S, "waiting_s": ahead - lowest})


def queue_over_time(protocol: Protocol, hosts: int, swarm: Mapping[str, Any]) -> Figure:
    """Draw the queue of a startup over time, when it clears, and the lease."""
    data = queue_over_time_data(protocol, hosts, swarm)
    idle, lease = first_idle(protocol, hosts, **swarm), protocol.lease
    color = color_of(protocol)
    with book_figure(2.6, f"The queue of {hosts} robots outlasts the lease") as figure:
        axis = figure.subplots()
        axis.plot(data["time_s"], data["waiting_s"], color=color)
        axis.plot(idle, 0, "o", color=color, clip_on=False, zorder=3)
        write_text(axis, f"clear after {idle:.0f} s", (idle, 0), (4, 8), fontsize=10)
        axis.axvline(lease, linestyle=":", **drawing.LIMIT_LINE)
        write_text(axis, f"lease of {lease:g} s", (lease, _QUEUE_MAX), (4, -12), fontsize=10)
        axis.set(xlim=(0, _QUEUE_TIMES_S[-1]), ylim=(0, _QUEUE_MAX))
        axis.set(xlabel="time after startup [s]", ylabel="airtime waiting [s]")
    return figure


def drain_times_data(products: Sequence[Protocol], swarm: Mapping[str, Any]) -> pd.DataFrame:
    """Return the bound of the drain time [s], the steady state, and exact drain times [s]."""
    bounds, exact = [], []
    for product in products:
        columns: Style = {"product": product.name, "hosts": _HOST_COUNTS}
        columns["at_most_s"] = drain_time(product, _HOST_COUNTS, **swarm)
        columns["steady state"] = utilization(product, _HOST_COUNTS, **swarm, window=np.inf)
        bounds.append(pd.DataFrame(columns))
        idle = [first_idle(product, int(hosts), **swarm) for hosts in _INTEGER_HOSTS]
        columns = {"product": product.name, "hosts": _INTEGER_HOSTS, "idle_after_s": idle}
        exact.append(pd.DataFrame(columns))
    return pd.concat([*bounds, *exact])


def drain_times(products: Sequence[Protocol], swarm: Mapping[str, Any]) -> Figure:
    """Draw the drain time and the steady state against the number of hosts."""
    data = drain_times_data(products, swarm).replace(np.inf, np.nan)
    title = "Leases run out long before periodic traffic fills the channel"
    with book_figure(4.3, title) as figure:
        above, below = figure.subplots(2, 1, sharex=True)
        for product, line in zip(products, _LINE_STYLES, strict=True):
            rows, color = data[data["product"] == product.name], color_of(product)
            bound, exact = rows[rows["steady state"].notna()], rows[rows["idle_after_s"].notna()]
            above.plot(bound["hosts"], bound["at_most_s"], line, color=color)
            above.plot(exact["hosts"], exact["idle_after_s"], "o", color=color, mfc="none", ms=4)
            below.plot(bound["hosts"], bound["steady state"], line, color=color)
            end = bound[bound["steady state"] < _STEADY_MAX].iloc[-1]
            # Only the last has room at the left.
            across, side = (-12, "right") if product is products[-1] else (5, "left")
            look: Style = {"color": drawing.letter_color(color), "ha": side, "va": "center"}
            at = (end["hosts"], end["steady state"])
            write_text(below, product.name, at, (across, -3), annotation_clip=False, **look)
        for time, text in _TIME_LIMITS.items():
            above.axhline(time, **drawing.LIMIT_LINE)
            above.text(55, time, text, ha="right", va="top" if time == 10 else "bottom", fontsize=9)
        below.axhline(1, **drawing.LIMIT_LINE)
        above.set(yscale="log", ylim=(0.05, 1000), xlim=(0, 56), ylabel="drain time [s]")
        above.yaxis.set_major_formatter(drawing.PLAIN_NUMBERS)
        below.set(xlabel="hosts $N_H$", ylabel="steady-state utilization [%]")
        below.set_ylim(0, _STEADY_MAX)
        below.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:.0%}"))
    return figure


_SMALL_HOSTS = smooth_steps(1, 8)


def fleet_airtimes_data(
    large: pd.DataFrame, laptop: HostGroup, small: tuple[int, int]
) -> pd.DataFrame:
    """Return the airtime of large fleets by part, and the utilization of small robots."""
    parts = large.drop(columns="total [s]")
    bars = parts.melt(["protocol", "fleet"], var_name="part", value_name="utilization")
    group = HostGroup(_SMALL_HOSTS, *small)
    lines = [
        pd.DataFrame(
            {"protocol": protocol.name, "fleet": f"small robots {company}"}
            | {"small_robots": _SMALL_HOSTS, "utilization": utilization(protocol, Fleet(groups))}
        )
        for protocol in PAPER_PROTOCOLS
        for company, groups in {"alone": (group,), "beside one laptop": (group, laptop)}.items()
    ]
    return pd.concat([bars, *lines])


def fleet_airtimes(large: pd.DataFrame, laptop: HostGroup, small: tuple[int, int]) -> Figure:
    """Draw airtime per kind of pair, and utilization of small robots with and without a laptop."""
    with book_figure(3.3, "A laptop costs more than half as much as a Nav2 robot") as figure:
        bars, lines = figure.subplots(1, 2, width_ratios=(1, 1.5))
        order = large.iloc[::-1].reset_index(drop=True)
        ys = order.index + (order["protocol"] == "DDS") * 0.5
        shades, left = [COLORS[protocol] for protocol in order["protocol"]], np.zeros(len(order))
        for part, alpha in {"robot-robot [s]": 0.45, "robot-laptop [s]": 1}.items():
            bars.barh(ys, order[part], left=left, height=0.7, color=shades, alpha=alpha)
            left += order[part]
        for y, total, protocol in zip(ys, order["total [s]"], order["protocol"], strict=True):
            bars.text(total, y, f" {protocol} {total:.1f} s", va="center")
        bars.set_yticks(ys, order["fleet"])
        bars.set_xlabel("airtime [s]")
        bars.set_xlim(0, 1.45 * order["total [s]"].max())
        bars.grid(axis="y", visible=False)
        data = fleet_airtimes_data(large, laptop, small).dropna(subset="small_robots")
        for (protocol, fleet), rows in data.groupby(["protocol", "fleet"], sort=False):
            alone, used = fleet == "small robots alone", rows["utilization"].to_numpy()
            color = COLORS[str(protocol)]
            lines.plot(_SMALL_HOSTS, used, "-" if alone else "--", color=color)
            full = np.interp(1, used, _SMALL_HOSTS)
            lines.plot(full, 1, "D", color=color, mec="white", ms=6, zorder=3)
            name = f"{protocol}{'' if alone else ', laptop'}: {full:.1f}"
            write_text(lines, name, (8, used[-1]), (4, 0), va="center", color=color)
        lines.axhline(1, color="black", linewidth=1)
        lines.yaxis.set_major_formatter("{x:.0%}")
        lines.set(xlabel="small robots", ylabel="channel utilization [%]", xlim=(1, 8), ylim=(0, 2))
    return figure
