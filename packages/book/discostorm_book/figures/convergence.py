"""Figures of convergence: who completes discovery, and what starting in turn changes."""

from collections.abc import Mapping, Sequence

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.colors import LinearSegmentedColormap, LogNorm, to_hex, to_rgb
from matplotlib.figure import Figure
from matplotlib.patches import Patch, Rectangle

from discostorm.figures import COLORS, WIDTH, headline, style
from discostorm.palette import lights

_SERIES = lights("series")
_STATE = lights("state")


def _tint(color: str, share: float) -> str:
    """Return a color mixed with white, of which its own part is a share."""
    red, green, blue = (1 - share * (1 - part) for part in to_rgb(color))
    return to_hex((red, green, blue))


_BLUE = _SERIES["blue"]
_SECONDS = LinearSegmentedColormap.from_list(
    "seconds", [_tint(_BLUE, 0.1), _tint(_BLUE, 0.35), _BLUE]
)
_SOME = _tint(_STATE["bad"], 0.2)


def _seconds(value: float) -> str:
    if value < 0.095:
        return "<0.1"
    return f"{value:.1f}" if value < 9.95 else f"{value:.0f}"


def grid(rows: pd.DataFrame, names: Mapping[str, str], losses: Sequence[float]) -> Figure:
    """Draw the median time to convergence as a grid of robots and middleware.

    Parameters
    ----------
    rows : pandas.DataFrame
        The sweep ``convergence``.
    names : mapping
        What each protocol is called, in order from above.
    losses : sequence of float
        Frame error rates, a panel each.
    """
    hosts = sorted(rows["hosts"].unique())
    norm = LogNorm(0.1, 120)
    with style():
        figure = Figure(figsize=(WIDTH, 0.9 + len(losses) * (0.4 + 0.205 * len(names))))
        panels = figure.subplots(len(losses), 1, squeeze=False)[:, 0]
        for axis, loss in zip(panels, losses, strict=True):
            part = rows[rows["loss"] == loss].set_index(["protocol", "hosts"])
            for line, protocol in enumerate(names):
                for column, count in enumerate(hosts):
                    _cell(axis, column, line, part.loc[(protocol, count)], norm)
            axis.set(xlim=(0, len(hosts)), ylim=(len(names), 0))
            axis.set_xticks(np.arange(len(hosts)) + 0.5, [str(count) for count in hosts])
            axis.set_yticks(np.arange(len(names)) + 0.5, list(names.values()))
            axis.tick_params(length=0)
            axis.grid(visible=False)
            axis.spines[:].set_visible(False)
            axis.set_title(
                f"{loss:.0%} frame errors" if loss else "no frame errors", loc="left", fontsize=9.5
            )
        panels[-1].set_xlabel("robots")
        figure.legend(
            handles=[
                Patch(facecolor=_SECONDS(norm(10)), label="median [s]"),
                Patch(facecolor=_SOME, label="runs of ten that finished"),
                Patch(facecolor=_STATE["bad"], label="no run finished"),
            ],
            loc="outside lower center",
            ncols=3,
        )
        headline(figure, "Ten robots take seconds; a few more never finish")
    return figure


def _cell(axis: Axes, column: int, line: int, row: pd.Series, norm: LogNorm) -> None:
    """Draw the result of one setting."""
    seconds, converged = row["convergence_time_s"], int(row["converged"])
    if np.isfinite(seconds):
        shade, text = _SECONDS(norm(seconds)), _seconds(seconds)
        color = "white" if norm(seconds) > 0.8 else "black"
    elif converged:
        shade, text, color = _SOME, f"{converged}/10", "black"
    else:
        shade, text, color = _STATE["bad"], "never", "white"
    axis.add_patch(Rectangle((column, line), 1, 1, facecolor=shade, edgecolor="white", lw=1.5))
    size = 7.5 if text == "never" else 8.5
    axis.text(column + 0.5, line + 0.52, text, ha="center", va="center", color=color, fontsize=size)


#: Where runs are drawn that did not converge: above two minutes, in powers of ten.
NEVER = 2.4


def quartiles(rows: pd.DataFrame, names: Sequence[str]) -> Figure:
    """Draw the middle half of the runs by robots, a panel a middleware.

    Times are drawn as powers of ten on a linear axis, so that pages can draw over them.

    Parameters
    ----------
    rows : pandas.DataFrame
        The sweep ``convergence``, of one frame error rate.
    names : sequence of str
        Which protocols.
    """
    columns = [f"convergence_time_s{end}" for end in ("_q25", "", "_q75")]
    with style():
        figure = Figure(figsize=(WIDTH, 2.8))
        panels = figure.subplots(1, len(names), sharey=True)
        for axis, name in zip(panels, names, strict=True):
            own = rows[rows["protocol"] == name].sort_values("hosts")
            places = np.arange(len(own))
            low, middle, high = (
                np.minimum(np.log10(own[column].to_numpy()), NEVER) for column in columns
            )
            color = COLORS[name]
            axis.vlines(places, low, high, color=color, lw=9, alpha=0.35)
            axis.plot(places, middle, "_", color=color, ms=8, mew=2.5)
            axis.axhline(np.log10(120), color=_STATE["bad"], lw=1)
            if axis is panels[-1]:
                at = (0, np.log10(120))
                axis.annotate("two minutes", at, (0, -3), textcoords="offset points", va="top")
            axis.set(xlabel="robots", xlim=(-0.7, len(own) - 0.3), ylim=(-1.7, NEVER + 0.25))
            # Every second one: all would touch.
            axis.set_xticks(places[1::2], [str(count) for count in own["hosts"][1::2]])
            axis.set_title(name, loc="left", fontsize=9.5)
        ticks = [-1, 0, 1, 2]
        panels[0].set_yticks([*ticks, NEVER], [*(f"{10.0**tick:g}" for tick in ticks), "never"])
        panels[0].set_ylabel("time until converged [s]")
        headline(figure, "Above some fleet size, most runs never finish")
    return figure


def windows(random: pd.DataFrame, rule: pd.DataFrame) -> Figure:
    """Draw the time to convergence against the window from which robots draw their starts.

    Parameters
    ----------
    random : pandas.DataFrame
        Rows of the sweep ``staggered`` with random starts.
    rule : pandas.DataFrame
        Rows with the rule's window, in ``rule_s``.
    """
    with style():
        figure = Figure(figsize=(WIDTH, 3.1))
        panels = figure.subplots(1, 2, sharey=True)
        for axis, protocol in zip(panels, ("DDS", "Zenoh"), strict=True):
            of_one = random[random["protocol"] == protocol]
            fleets = sorted(set(of_one["hosts"]))
            for hosts, share in zip(fleets, np.linspace(0.55, 1, len(fleets)), strict=True):
                color = _tint(COLORS[protocol], share)
                rows = of_one[of_one["hosts"] == hosts].sort_values("window_s")
                axis.plot(rows["window_s"], rows["convergence_time_s"], "-o", color=color, ms=3)
                axis.fill_between(
                    rows["window_s"],
                    rows["convergence_time_s_low"],
                    rows["convergence_time_s_high"],
                    color=color,
                    alpha=0.25,
                    lw=0,
                )
                star = rule[(rule["protocol"] == protocol) & (rule["hosts"] == hosts)]
                axis.plot(
                    star["rule_s"],
                    star["convergence_time_s"],
                    "*",
                    color=color,
                    ms=11,
                    mec="black",
                    mew=0.6,
                )
                axis.annotate(
                    f"{hosts} robots",
                    (0.36, rows["convergence_time_s"].iloc[0]),
                    xytext=(0, 0),
                    textcoords="offset points",
                    ha="right",
                    va="center",
                    color=COLORS[protocol],  # a tint is too pale to read
                    fontsize=9,
                )
            ticks = [0.5, 1, 2, 5, 10, 20, 45]
            axis.set(xscale="log", yscale="log", xlim=(0.05, 55), xlabel="window of the starts [s]")
            axis.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
            axis.set_yticks([1, 2, 5, 10, 20, 50], ["1", "2", "5", "10", "20", "50"])
            axis.minorticks_off()
            axis.set_title(protocol, loc="left")
        panels[0].set_ylabel("time until converged [s]")
        panels[1].plot([], [], "*", color="0.6", ms=11, mec="black", label="the rule of thumb")
        panels[1].legend(loc="lower right")
        headline(figure, "The rule's window lies where too short and too long hurt little")
    return figure


def changes(shown: pd.DataFrame) -> Figure:
    """Draw what each change does to the time to convergence: dots with their intervals.

    Parameters
    ----------
    shown : pandas.DataFrame
        Indexed by the change; columns named by protocol, and with ``_low`` and ``_high``.
    """
    with style():
        figure = Figure(figsize=(WIDTH, 3.1))
        axis = figure.subplots()
        places = np.arange(len(shown))
        for shift, protocol in ((-0.19, "DDS"), (0.19, "Zenoh")):
            color = COLORS[protocol]
            low, high = shown[f"{protocol}_low"], shown[f"{protocol}_high"]
            axis.hlines(places + shift, low, high, color=color, lw=2, alpha=0.6)
            axis.plot(shown[protocol], places + shift, "o", color=color, ms=6)
            for place, value, end in zip(places + shift, shown[protocol], high, strict=True):
                axis.annotate(
                    f"{value:.0f}" + (f" {protocol}" if place < 0.5 else ""),
                    (end, place),
                    xytext=(6, 0),
                    textcoords="offset points",
                    va="center",
                    color=color,
                    fontsize=8.5,
                )
        axis.set(yticks=places, yticklabels=list(shown.index), xlabel="time until converged [s]")
        axis.set_xlim(0, 1.2 * shown.to_numpy().max())
        axis.invert_yaxis()
        axis.grid(axis="y", visible=False)
        headline(figure, "Starting in turn helps Zenoh most; aggregation helps DDS")
    return figure
