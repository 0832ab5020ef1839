"""Figures of the burst on the air: frames, drain times, queues."""

from collections.abc import Sequence
from itertools import product

import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle

from discostorm.figures import COLORS, WIDTH, headline, style
from discostorm.palette import lights

_NEUTRAL = lights("neutral")
_SERIES = lights("series")
_STATE = lights("state")
_CAUSES = {
    "ap_full": ("access point's queue full", _SERIES["vermilion"]),
    "host_age": ("waited too long at the host", _SERIES["orange"]),
    "host_full": ("host's queue full", _SERIES["blue"]),
    "on_air": ("multicast, collided", _SERIES["purple"]),
}


def frames(events: pd.DataFrame, until: float = 6e-3) -> Figure:
    """Draw the first transmissions of a small burst: a lane a station.

    Parameters
    ----------
    events : pandas.DataFrame
        Transmissions: start_s, end_s, station, outcome.
    until : float
        How much of it [s].
    """
    looks = {"success": (_STATE["ok"], ""), "collision": (_STATE["bad"], "////")}
    lanes = ["access point", *sorted(set(events["station"]) - {"access point"}, reverse=True)]
    arrived = events[(events["station"] != "access point") & (events["outcome"] == "success")]
    with style():
        figure = Figure(figsize=(WIDTH, 2.8))
        axis = figure.subplots()
        for lane, station in enumerate(lanes):
            own = events[events["station"] == station]
            begin = arrived["end_s"].min() if station == "access point" else 0.0
            end = min(own["end_s"].max(), until)
            axis.plot([begin * 1e3, end * 1e3], [lane, lane], color="0.75", lw=6, zorder=1)
            for outcome, (color, hatch) in looks.items():
                sent = own[(own["outcome"] == outcome) & (own["start_s"] < until)]
                lasts = sent["end_s"] - sent["start_s"]
                axis.broken_barh(
                    list(zip(sent["start_s"] * 1e3, lasts * 1e3, strict=True)),
                    (lane - 0.32, 0.64),
                    facecolors=color,
                    edgecolor="white",
                    linewidth=0.2,
                    hatch=hatch,
                    zorder=2,
                    label=outcome if lane == 0 else None,
                )
        axis.plot([], [], color="0.75", lw=6, label="waits with frames to send")
        axis.set(yticks=range(len(lanes)), yticklabels=lanes, xlabel="time after startup [ms]")
        axis.set_xlim(0, until * 1e3)
        axis.grid(axis="y", visible=False)
        figure.legend(*axis.get_legend_handles_labels(), loc="outside lower center", ncols=3)
        headline(figure, "All robots collide first; then their frames take turns")
    return figure


def steps(events: pd.DataFrame, times: Sequence[float] = (6e-3, 12e-3)) -> Figure:
    """Draw the queues of a small burst over time, and who has heard of whom at some times.

    Parameters
    ----------
    events : pandas.DataFrame
        Transmissions: start_s, end_s, station, message, outcome, from, to, and frames waiting.
    times : sequence of float
        When the endpoint announcements that have arrived are counted, beside at the end [s].
    """
    names = {f"waiting_{name.replace(' ', '_')}": name for name in set(events["station"])}
    robots = sorted(set(names.values()) - {"access point"})
    arrived = events.query(
        "station == 'access point' and message == 'SEDP' and outcome == 'success'"
    )
    every = len(arrived) // len(robots) // (len(robots) - 1)
    last = events["end_s"].max()
    with style():
        figure = Figure(figsize=(WIDTH, 3.7))
        grid = figure.add_gridspec(2, len(times) + 1, height_ratios=(3, 2))
        axis = figure.add_subplot(grid[0, :])
        after = events.groupby("start_s").last()
        for (waiting, name), line in zip(sorted(names.items()), ("-", "-", "--", ":"), strict=True):
            shared = name == "access point"
            axis.step(
                after["end_s"] * 1e3, after[waiting], line, where="post",
                color=_NEUTRAL["charcoal"] if shared else COLORS["DDS"],
                label=None if shared else name.replace("host", "robot"),
            )  # fmt: skip
            if shared:
                at = after.iloc[after[waiting].argmax()]
                axis.annotate(
                    name, (at["end_s"] * 1e3, at[waiting]), (0, 3), textcoords="offset points",
                    ha="center", color=_NEUTRAL["charcoal"], fontsize=9,
                )  # fmt: skip
        axis.set(xlabel="time after startup [ms]", ylabel="frames waiting", xlim=(0, last * 1e3))
        axis.set_ylim(0, 1.25 * after["waiting_access_point"].max())
        axis.legend(loc="upper left")
        for column, time in enumerate((*times, last)):
            known = pd.crosstab(*(arrived[arrived["end_s"] <= time][end] for end in ("to", "from")))
            share = 100 * known.reindex(index=robots, columns=robots, fill_value=0) // every
            panel = figure.add_subplot(grid[1, column])
            _known(panel, share)
            panel.set_title(f"after {time * 1e3:.0f} ms", loc="left", fontsize=9)
        headline(figure, "The burst moves from the robots' queues into the access point's")
    return figure


def _known(axis: Axes, share: pd.DataFrame) -> None:
    """Draw who has heard how much of whom: a cell fills from below."""
    count = len(share)
    for reader, writer in product(range(count), repeat=2):
        if reader == writer:
            text = "\N{EN DASH}"
        else:
            part = int(share.to_numpy()[reader, writer])
            text = f"{part}"
            box = Rectangle(
                (writer, reader + 1), 1, -part / 100, color=COLORS["DDS"], alpha=0.35, lw=0
            )
            axis.add_patch(box)
        axis.text(writer + 0.5, reader + 0.5, text, ha="center", va="center", fontsize=9)
    ticks = [f"{number + 1}" for number in range(count)]
    places = [number + 0.5 for number in range(count)]
    axis.set(xlim=(0, count), ylim=(count, 0), xlabel="of robot", ylabel="robot knows [%]")
    axis.set_xticks(places, ticks)
    axis.set_yticks(places, ticks)
    axis.tick_params(length=0)
    axis.grid(visible=False)


def drain(rows: pd.DataFrame) -> Figure:
    """Draw simulated drain times by the formula's airtime, and those of ns-3.

    Parameters
    ----------
    rows : pandas.DataFrame
        `discostorm_book.sweeps.drains`.
    """
    with style():
        figure = Figure(figsize=(WIDTH, 3.2))
        axis = figure.subplots()
        for protocol, mpdus in product(("DDS", "Zenoh"), (1, 64)):
            part = rows[(rows["protocol"] == protocol) & (rows["mpdus"] == mpdus)]
            color, line = COLORS[protocol], "-" if mpdus == 1 else "--"
            axis.plot(part["hosts"], part["ratio"], line, color=color)
            axis.plot(part["hosts"], part["ratio_ns3"], "o", color=color, ms=4, mfc="w")
            last = part.iloc[-1]
            above = last["ratio"] > rows.query("mpdus == @mpdus and hosts == 30")["ratio"].mean()
            axis.annotate(
                f"{protocol}{', aggregated' if mpdus > 1 else ''}",
                (last["hosts"], last["ratio"]),
                xytext=(5, 2 if above else -6),
                textcoords="offset points",
                va="center",
                color=color,
                fontsize=9,
            )
        axis.plot([], [], "o", color="0.3", ms=4, mfc="w", label="ns-3")
        axis.plot([1, 30], [1, 1], color="0.3", lw=1)
        axis.text(2, 1.01, "as long as the formula says", fontsize=9, color="0.3", va="bottom")
        axis.set(
            xlabel="hosts",
            ylabel="drain time / formula",
            ylim=(0.8, 1.65),
            xlim=(1, 42),
            xticks=range(5, 31, 5),
        )
        axis.legend(loc="upper right")
        headline(figure, "The formula is close without aggregation, optimistic with it")
    return figure


def waiting(rows: pd.DataFrame, hosts: int, limit: int = 500) -> Figure:
    """Draw how many frames wait at the hosts and at the access point over time.

    Parameters
    ----------
    rows : pandas.DataFrame
        The sweep ``waiting``.
    hosts : int
        The fleet to draw.
    limit : int
        What the access point's queue holds.
    """
    own = rows[(rows["hosts"] == hosts) & (rows["time_s"] > 0)]
    full = own.loc[own["at_access_point"] >= limit, "time_s"].iloc[0]
    with style():
        figure = Figure(figsize=(WIDTH, 2.8))
        axis = figure.subplots()
        looks = (
            ("at_hosts", f"at the {hosts} robots", COLORS["DDS"], 0.16, (8, 8)),
            ("at_access_point", "at the access point", _NEUTRAL["charcoal"], 0.19, (0, -14)),
        )
        for column, name, color, where, offset in looks:
            axis.plot(own["time_s"], own[column], color=color)
            at = own[own["time_s"] >= where].iloc[0]
            axis.annotate(
                name,
                (at["time_s"], at[column]),
                xytext=offset,
                textcoords="offset points",
                color=color,
                fontsize=9,
            )
        axis.axhline(limit, color="0.3", lw=1, ls=":")
        axis.plot(full, limit, "o", color=_NEUTRAL["charcoal"], ms=6, zorder=3)
        axis.annotate(
            f"full after {full:.2f} s",
            (full, limit),
            xytext=(0, 8),
            textcoords="offset points",
            fontsize=9,
            color=_NEUTRAL["charcoal"],
        )
        axis.set(xlabel="time after startup [s]", ylabel="frames waiting", xlim=(0, None))
        axis.set_ylim(0, None)
        headline(figure, "The access point cannot empty its queue fast enough")
    return figure


def _areas(axis: Axes, rows: pd.DataFrame) -> None:
    axis.stackplot(
        rows["hosts"],
        [rows[cause] for cause in _CAUSES],
        colors=[color for _, color in _CAUSES.values()],
        labels=[name for name, _ in _CAUSES.values()],
    )


def causes(rows: pd.DataFrame) -> Figure:
    """Draw the part of a burst that is lost against the hosts, by cause, alone and aggregated.

    Parameters
    ----------
    rows : pandas.DataFrame
        The sweep ``queues``, of one protocol, up to 30 hosts.
    """
    with style():
        figure = Figure(figsize=(WIDTH, 3.2))
        panels = figure.subplots(1, 2, sharey=True)
        for axis, mpdus in zip(panels, (1, 64), strict=True):
            _areas(axis, rows[rows["mpdus"] == mpdus])
            axis.set(xlabel="hosts", ylim=(0, 1), xlim=(2, 30), xticks=range(5, 31, 5))
            axis.set_title("one message per frame" if mpdus == 1 else "aggregated", loc="left")
        panels[0].set_ylabel("deliveries lost [%]")
        panels[0].yaxis.set_major_formatter("{x:.0%}")
        figure.legend(*panels[0].get_legend_handles_labels(), loc="outside lower center", ncols=2)
        headline(figure, "The access point loses first, then the hosts' own queues")
    return figure
