"""Figures of the burst on the air: frames, drain times, queues."""

from collections.abc import Sequence
from itertools import product

import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle

from discostorm.figures import COLORS
from discostorm.palette import light_colors
from discostorm_book.figures.drawing import Style, book_figure, legend_below, name_cells, write_text

_CHARCOAL = light_colors("neutral")["charcoal"]
#: Causes of loss in the sweep ``queues``, and their colors.
_CAUSES = {
    "ap_full": ("access point's queue full", "wine"),
    "host_age": ("waited too long at the host", "olive"),
    "host_full": ("host's queue full", "slate"),
    "on_air": ("multicast, collided", "brown"),
}


def first_transmissions(events: pd.DataFrame, end_s: float = 6e-3) -> Figure:
    """Draw the first transmissions of the sweep ``events``, up to a time [s], by station."""
    looks = {"success": ("ok", ""), "collision": ("bad", "////")}
    lanes = ["access point", *sorted(set(events["station"]) - {"access point"}, reverse=True)]
    arrived = events[(events["station"] != "access point") & (events["outcome"] == "success")]
    with book_figure(2.8, "All robots collide first; then their frames take turns") as figure:
        axis = figure.subplots()
        for lane, station in enumerate(lanes):
            own = events[events["station"] == station]
            begin = arrived["end_s"].min() if station == "access point" else 0.0
            end = min(own["end_s"].max(), end_s)
            axis.plot([begin * 1e3, end * 1e3], [lane, lane], color="0.75", lw=6, zorder=1)
            for outcome, (state, hatch) in looks.items():
                sent = own[(own["outcome"] == outcome) & (own["start_s"] < end_s)]
                spans = 1e3 * sent[["start_s"]].assign(width=sent["end_s"] - sent["start_s"])
                look: Style = {"facecolors": light_colors("state")[state], "hatch": hatch}
                look |= {"edgecolor": "white", "linewidth": 0.2, "zorder": 2}
                label = outcome if lane == 0 else None
                axis.broken_barh(spans.to_numpy(), (lane - 0.32, 0.64), label=label, **look)
        axis.plot([], [], color="0.75", lw=6, label="waits with frames to send")
        axis.set(yticks=range(len(lanes)), yticklabels=lanes, xlabel="time after startup [ms]")
        axis.set_xlim(0, end_s * 1e3)
        axis.grid(axis="y", visible=False)
        legend_below(figure, axis.get_legend_handles_labels()[0], 3)
    return figure


def queues_and_discovery(events: pd.DataFrame, times: Sequence[float] = (6e-3, 12e-3)) -> Figure:
    """Draw the queues of the sweep ``events`` over time, and who knows whom at some times [s]."""
    names = {f"waiting_{name.replace(' ', '_')}": name for name in set(events["station"])}
    robots = sorted(set(names.values()) - {"access point"})
    announced = "station == 'access point' and message == 'SEDP' and outcome == 'success'"
    arrived = events.query(announced)
    every = len(arrived) // len(robots) // (len(robots) - 1)
    last = events["end_s"].max()
    after = events.groupby("start_s").last()
    title = "The burst moves from the robots' queues into the access point's"
    with book_figure(3.7, title) as figure:
        grid = figure.add_gridspec(2, len(times) + 1, height_ratios=(3, 2))
        axis = figure.add_subplot(grid[0, :])
        for (waiting, name), line in zip(sorted(names.items()), ("-", "-", "--", ":"), strict=True):
            robot = name != "access point"
            color = COLORS["DDS"] if robot else _CHARCOAL
            label = name.replace("host", "robot") if robot else None
            look: Style = {"where": "post", "color": color, "label": label}
            axis.step(after["end_s"] * 1e3, after[waiting], line, **look)
            if not robot:
                peak = after.iloc[after[waiting].argmax()]
                at = (peak["end_s"] * 1e3, peak[waiting])
                write_text(axis, name, at, (0, 3), ha="center", color=color)
        axis.set(xlabel="time after startup [ms]", ylabel="frames waiting", xlim=(0, last * 1e3))
        axis.set_ylim(0, 1.25 * after["waiting_access_point"].max())
        axis.legend(loc="upper left")
        for column, time in enumerate((*times, last)):
            known = pd.crosstab(*(arrived[arrived["end_s"] <= time][end] for end in ("to", "from")))
            share = 100 * known.reindex(index=robots, columns=robots, fill_value=0) // every
            panel = figure.add_subplot(grid[1, column])
            _draw_knowledge(panel, share)
            panel.set_title(f"after {time * 1e3:.0f} ms", loc="left", fontsize=9)
    return figure


def _draw_knowledge(axis: Axes, share: pd.DataFrame) -> None:
    """Draw the share of announcements that each robot has received from each other robot."""
    count = len(share)
    for reader, writer in product(range(count), repeat=2):
        text = "\N{EN DASH}"
        if reader != writer:
            part = int(share.to_numpy()[reader, writer])
            text = f"{part}"
            look: Style = {"color": COLORS["DDS"], "alpha": 0.35, "lw": 0}
            axis.add_patch(Rectangle((writer, reader + 1), 1, -part / 100, **look))
        axis.text(writer + 0.5, reader + 0.5, text, ha="center", va="center", fontsize=9)
    axis.set(xlim=(0, count), ylim=(count, 0), xlabel="of robot", ylabel="robot knows [%]")
    name_cells(axis, range(1, count + 1), range(1, count + 1))


def drain_time_ratios(rows: pd.DataFrame) -> Figure:
    """Draw `sweeps.drain_times` of the simulation and of ns-3 relative to the formula's time."""
    with book_figure(3.2, "The formula is close without aggregation, optimistic with it") as figure:
        axis = figure.subplots()
        for protocol, mpdus in product(("DDS", "Zenoh"), (1, 64)):
            part = rows[(rows["protocol"] == protocol) & (rows["mpdus"] == mpdus)]
            color, line = COLORS[protocol], "-" if mpdus == 1 else "--"
            axis.plot(part["hosts"], part["ratio"], line, color=color)
            axis.plot(part["hosts"], part["ratio_ns3"], "o", color=color, ms=4, mfc="w")
            hosts, end = part[["hosts", "ratio"]].iloc[-1]
            above = end > rows.query("mpdus == @mpdus and hosts == 30")["ratio"].mean()
            name = f"{protocol}{', aggregated' if mpdus > 1 else ''}"
            write_text(axis, name, (hosts, end), (5, 2 if above else -6), va="center", color=color)
        axis.plot([], [], "o", color="0.3", ms=4, mfc="w", label="ns-3")
        axis.plot([1, 30], [1, 1], color="0.3", lw=1)
        axis.text(2, 1.01, "as long as the formula says", fontsize=9, color="0.3", va="bottom")
        axis.set(xlabel="hosts", xlim=(1, 42), xticks=range(5, 31, 5))
        axis.set(ylabel="drain time / formula", ylim=(0.8, 1.65))
        axis.legend(loc="upper right")
    return figure


def waiting_frames(rows: pd.DataFrame, hosts: int, limit: int = 500) -> Figure:
    """Draw how many frames of a fleet wait over time; the access point's queue has a limit."""
    own = rows[(rows["hosts"] == hosts) & (rows["time_s"] > 0)]
    full = own.loc[own["at_access_point"] >= limit, "time_s"].iloc[0]
    with book_figure(2.8, "The access point cannot empty its queue fast enough") as figure:
        axis = figure.subplots()
        for column, name, color, time, offset in (
            ("at_hosts", f"at the {hosts} robots", COLORS["DDS"], 0.16, (8, 8)),
            ("at_access_point", "at the access point", _CHARCOAL, 0.19, (0, -14)),
        ):
            axis.plot(own["time_s"], own[column], color=color)
            at = own[own["time_s"] >= time][["time_s", column]].iloc[0]
            write_text(axis, name, tuple(at), offset, color=color)
        axis.axhline(limit, color="0.3", lw=1, ls=":")
        write_text(axis, "its limit", (own["time_s"].max(), limit), (0, 3), ha="right")
        axis.plot(full, limit, "o", color=_CHARCOAL, ms=6, zorder=3)
        write_text(axis, f"full after {full:.2f} s", (full, limit), (0, 8), color=_CHARCOAL)
        axis.set(xlabel="time after startup [s]", ylabel="frames waiting", xlim=(0, None))
        axis.set_ylim(0, None)
    return figure


def loss_causes(rows: pd.DataFrame) -> Figure:
    """Draw which share of a protocol's burst is lost by hosts and cause, alone and aggregated."""
    labels, colors = zip(*_CAUSES.values(), strict=True)
    shades = [light_colors("series")[color] for color in colors]
    with book_figure(3.2, "The access point loses first, then the hosts' own queues") as figure:
        panels = figure.subplots(1, 2, sharey=True)
        for axis, mpdus in zip(panels, (1, 64), strict=True):
            own = rows[rows["mpdus"] == mpdus]
            axis.stackplot(own["hosts"], own[list(_CAUSES)].T, colors=shades, labels=labels)
            axis.set(xlabel="hosts", ylim=(0, 1), xlim=(2, 30), xticks=range(5, 31, 5))
            axis.set_title("one message per frame" if mpdus == 1 else "aggregated", loc="left")
        panels[0].set_ylabel("deliveries lost [%]")
        panels[0].yaxis.set_major_formatter("{x:.0%}")
        legend_below(figure, panels[0].get_legend_handles_labels()[0], 2)
    return figure
