"""Figures of Part II, what the paper's result means."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
import pandas as pd
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter
from numpy.typing import NDArray

from discostorm import figures, timeline
from discostorm.figures import WIDTH, color_of, headline, style
from discostorm.fleet import Fleet, HostGroup
from discostorm.messages import Protocol
from discostorm.model import utilization

_LINES = ("--", "-", "-.")
_PLAIN = FuncFormatter(lambda value, _: f"{value:g}")
_TIME = np.geomspace(0.05, 200, 700)  # s after startup
_HOSTS = np.linspace(2, 55, 531)
_WHOLE = np.arange(2, 56, 3)
_QUEUE_TIME = np.arange(0, 120.01, 0.05)  # s after startup
#: Airtime up to which the queue is drawn [s].
QUEUE_MOST = 80
#: Most of the steady state that is drawn.
_MOST = 1.5
_LIMITS = {1: "a second", 10: "lease of 10 s", 20: "lease of 20 s"}


def start_data(
    products: Sequence[Protocol], fleets: Sequence[int], swarm: Mapping[str, Any]
) -> pd.DataFrame:
    """Return what is requested by some times after startup, and when the channel goes idle [s]."""
    curves = [
        pd.DataFrame(
            {"hosts": hosts, "what": "requested", "time_s": _TIME}
            | {
                f"{product.name} [s]": timeline.demand(product, _TIME, hosts, **swarm)
                for product in products
            }
        )
        for hosts in fleets
    ]
    idle = pd.DataFrame(
        {"hosts": hosts, "what": "idle"}
        | {
            f"{product.name} [s]": timeline.first_idle(product, hosts, **swarm)
            for product in products
        }
        for hosts in fleets
    )
    return pd.concat([*curves, idle])


def start(products: Sequence[Protocol], fleets: Sequence[int], swarm: Mapping[str, Any]) -> Figure:
    """Draw the airtime that fleets request, and what the channel can carry: a panel a fleet."""
    data = start_data(products, fleets, swarm)
    with style():
        figure = Figure(figsize=(WIDTH, 4.1))
        headline(figure, "7 robots drain in about a second, 30 outlast their leases")
        panels = figure.subplots(2, 2, sharex=True, sharey=True)
        for axis, hosts in zip(panels.flat, fleets, strict=True):
            rows = data[data["hosts"] == hosts]
            curves, idle = rows[rows["what"] == "requested"], rows[rows["what"] == "idle"]
            axis.plot(_TIME, _TIME, color="black", linewidth=1.5)
            for product, line in zip(products, _LINES, strict=True):
                look: dict[str, Any] = {"color": color_of(product)}
                name = f"{product.name} [s]"
                axis.plot(_TIME, curves[name], line, label=product.name, **look)
                axis.plot(idle[name], idle[name], "o", zorder=3, **look)
            for limit in _LIMITS:
                axis.axvline(limit, color="gray", linewidth=0.8, linestyle=":")
            axis.loglog()
            axis.minorticks_off()
            axis.set(xlim=(0.05, 200), ylim=(0.02, 500))
            axis.set_title(f"{hosts} robots", loc="left")
            if axis is panels[0, 0]:
                axis.annotate(
                    "carried\nat most", (30, 30), (-7, 4), textcoords="offset points", ha="right",
                    fontsize=9,
                )  # fmt: skip
            for along in (axis.xaxis, axis.yaxis):
                along.set_major_formatter(_PLAIN)
        for axis in panels[:, 0]:
            axis.set_ylabel("airtime [s]")
        for axis in panels[-1]:
            axis.set_xlabel("time after startup [s]")
        named = panels[0, 0].get_legend_handles_labels()
        figure.legend(*named, loc="outside lower center", ncols=3)
    return figure


def announced_every(protocol: Protocol, period: float) -> Protocol:
    """Return a table whose repeated messages have another period [s]; starts stay the same."""
    messages = (
        replace(m, schedule=replace(m.schedule, period=period))
        if np.isfinite(m.schedule.period)
        else m
        for m in protocol.messages
    )
    return replace(protocol, messages=tuple(messages))


def queue_data(protocol: Protocol, hosts: int, swarm: Mapping[str, Any]) -> pd.DataFrame:
    """Return the airtime that waits, by the time after startup [s]."""
    ahead = np.asarray(timeline.demand(protocol, _QUEUE_TIME, hosts, **swarm)) - _QUEUE_TIME
    # An idle channel saves nothing for later.
    lowest = np.minimum(0, np.minimum.accumulate(ahead))
    return pd.DataFrame({"time_s": _QUEUE_TIME, "waiting_s": ahead - lowest})


def queue(protocol: Protocol, hosts: int, swarm: Mapping[str, Any]) -> Figure:
    """Draw the queue of a startup over time, when it clears, and the lease."""
    data = queue_data(protocol, hosts, swarm)
    idle = timeline.first_idle(protocol, hosts, **swarm)
    color = color_of(protocol)
    with style():
        figure = Figure(figsize=(WIDTH, 2.6))
        axis = figure.subplots()
        axis.plot(data["time_s"], data["waiting_s"], color=color)
        axis.plot(idle, 0, "o", color=color, clip_on=False, zorder=3)
        axis.annotate(f"clear after {idle:.0f} s", (idle, 0), (4, 8), textcoords="offset points")
        axis.axvline(protocol.lease, color="gray", linewidth=0.8, linestyle=":")
        axis.annotate(
            f"lease of {protocol.lease:g} s", (protocol.lease, QUEUE_MOST), (4, -12),
            textcoords="offset points",
        )  # fmt: skip
        axis.set(xlim=(0, _QUEUE_TIME[-1]), ylim=(0, QUEUE_MOST))
        headline(figure, f"The queue of {hosts} robots outlasts the lease")
        axis.set_xlabel("time after startup [s]")
        axis.set_ylabel("airtime waiting [s]")
    return figure


def drain_data(products: Sequence[Protocol], swarm: Mapping[str, Any]) -> pd.DataFrame:
    """Return the bound of the drain time [s], the steady state, and exact drain times [s]."""
    bounds = [
        pd.DataFrame(
            {
                "product": product.name,
                "hosts": _HOSTS,
                "at_most_s": timeline.drain_time(product, _HOSTS, **swarm),
                "steady state": utilization(product, _HOSTS, **swarm, window=np.inf),
            }
        )
        for product in products
    ]
    exact = [
        pd.DataFrame(
            {
                "product": product.name,
                "hosts": _WHOLE,
                "idle_after_s": [timeline.first_idle(product, int(n), **swarm) for n in _WHOLE],
            }
        )
        for product in products
    ]
    return pd.concat([*bounds, *exact])


def drain(products: Sequence[Protocol], swarm: Mapping[str, Any]) -> Figure:
    """Draw the drain time and the steady state against the number of hosts."""
    data = drain_data(products, swarm)
    with style():
        figure = Figure(figsize=(WIDTH, 4.3))
        headline(figure, "Leases end long before periodic traffic fills the channel")
        above, below = figure.subplots(2, 1, sharex=True)
        for product, line in zip(products, _LINES, strict=True):
            rows = data[data["product"] == product.name]
            color = color_of(product)
            bound, exact = rows[rows["steady state"].notna()], rows[rows["idle_after_s"].notna()]
            lasts = bound["at_most_s"].replace(np.inf, np.nan)
            above.plot(bound["hosts"], lasts, line, color=color)
            above.plot(
                exact["hosts"], exact["idle_after_s"], "o", color=color, fillstyle="none", ms=4
            )
            below.plot(bound["hosts"], bound["steady state"], line, color=color)
            end = bound[bound["steady state"] < _MOST].iloc[-1]
            first = product is products[-1]  # the others have room at the right
            below.annotate(
                product.name, (end["hosts"], end["steady state"]), (-7 if first else 5, -3),
                textcoords="offset points", color=color, ha="right" if first else "left",
                va="center", fontsize=9, annotation_clip=False,
            )  # fmt: skip
        for limit, text in _LIMITS.items():
            above.axhline(limit, color="gray", linewidth=0.8)
            above.text(
                55, limit, text, ha="right", va="top" if limit == 10 else "bottom", fontsize=9
            )
        below.axhline(1, color="gray", linewidth=0.8)
        above.set(yscale="log", ylim=(0.05, 1000), xlim=(0, 56), ylabel="drain time [s]")
        above.yaxis.set_major_formatter(_PLAIN)
        below.set(ylim=(0, _MOST), ylabel="steady-state utilization [%]", xlabel="hosts $N_H$")
        below.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:.0%}"))
    return figure


_LABELS = {"alone": "-", "beside one laptop": "--"}


def _beside(
    laptop: HostGroup, small: tuple[int, int]
) -> dict[tuple[str, str], float | NDArray[Any]]:
    """Return utilization by 1 to 8 small robots, alone and beside a laptop."""
    count = figures.steps(1, 8)
    return {
        (protocol.name, label): utilization(protocol, Fleet((HostGroup(count, *small), *others)))
        for protocol in figures.PAPER_PROTOCOLS
        for label, others in zip(_LABELS, ((), (laptop,)), strict=True)
    }


def fleets_data(large: pd.DataFrame, laptop: HostGroup, small: tuple[int, int]) -> pd.DataFrame:
    """Return the airtime of large fleets by part, and the utilization of small robots."""
    bars = large.drop(columns="total [s]").melt(
        ["protocol", "fleet"], var_name="part", value_name="utilization"
    )
    lines = [
        pd.DataFrame(
            {
                "protocol": protocol,
                "fleet": f"small robots {label}",
                "small_robots": figures.steps(1, 8),
                "utilization": values,
            }
        )
        for (protocol, label), values in _beside(laptop, small).items()
    ]
    return pd.concat([bars, *lines])


def fleets(large: pd.DataFrame, laptop: HostGroup, small: tuple[int, int]) -> Figure:
    """Draw the airtime of large fleets by part, and small robots alone and beside a laptop.

    Parameters
    ----------
    large : pandas.DataFrame
        Columns protocol, fleet, ``robot-robot [s]``, ``robot-laptop [s]`` and ``total [s]``.
    laptop : HostGroup
        What stands beside the small robots.
    small : tuple of int
        Processes, and endpoints of each, of a small robot.
    """
    with style():
        figure = Figure(figsize=(WIDTH, 3.3))
        bars, lines = figure.subplots(1, 2, width_ratios=(1, 1.5))
        order = large.iloc[::-1].reset_index(drop=True)
        places = order.index + (order["protocol"] == "DDS") * 0.5
        shades = [figures.COLORS[protocol] for protocol in order["protocol"]]
        left = np.zeros(len(order))
        for part, alpha in {"robot-robot [s]": 0.45, "robot-laptop [s]": 1}.items():
            bars.barh(places, order[part], left=left, height=0.7, color=shades, alpha=alpha)
            left += order[part]
        bars.set_yticks(places, order["fleet"])
        bars.set_xlabel("airtime [s]")
        bars.set_xlim(0, 1.3 * order["total [s]"].max())
        for place, total, protocol in zip(
            places, order["total [s]"], order["protocol"], strict=True
        ):
            bars.text(total, place, f" {protocol} {total:.1f}", va="center")
        bars.grid(axis="y", visible=False)
        for (protocol, label), values in _beside(laptop, small).items():
            color = figures.COLORS[protocol]
            hosts = figures.steps(1, 8)
            lines.plot(hosts, values, _LABELS[label], color=color)
            full = np.interp(1, np.asarray(values), hosts)
            first = protocol == "DDS"  # it is left of the other
            lines.annotate(
                f"{full:.1f}", (full, 1), (-4, 4) if first else (4, -4),
                textcoords="offset points", ha="right" if first else "left",
                va="bottom" if first else "top", color=color, fontsize=9,
            )  # fmt: skip
            lines.annotate(
                f"{protocol}{'' if label == 'alone' else ', laptop'}", (8, np.asarray(values)[-1]),
                (4, 0), textcoords="offset points", va="center", color=color, fontsize=9,
            )  # fmt: skip
        lines.axhline(1, color="black", linewidth=1)
        lines.yaxis.set_major_formatter("{x:.0%}")
        lines.set(xlabel="small robots", ylabel="channel utilization [%]", xlim=(1, 8), ylim=(0, 2))
        figures.headline(figure, "A laptop costs more than half as much as a robot")
    return figure
