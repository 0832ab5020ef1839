"""Figures of convergence: fleets that complete discovery, and the effect of starting in turn."""

from collections.abc import Mapping, Sequence

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.colors import LinearSegmentedColormap, LogNorm, to_rgb
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch, Rectangle
from matplotlib.typing import ColorType

from discostorm.figures import COLORS
from discostorm.palette import light_colors
from discostorm_book.figures import drawing
from discostorm_book.figures.drawing import Style, book_figure, write_text


def _mix_with_white(color: str, share: float) -> tuple[float, float, float]:
    """Return a mix of a color and white; the share is that of the color."""
    red, green, blue = to_rgb(color)
    return 1 - share * (1 - red), 1 - share * (1 - green), 1 - share * (1 - blue)


_TINTS = [_mix_with_white(light_colors("series")["slate"], share) for share in (0.08, 0.25, 0.5)]
_TIME_COLORS = LinearSegmentedColormap.from_list("seconds", _TINTS)
_TIME_NORM = LogNorm(0.1, 120)
_NO_RUN_COLOR = light_colors("state")["bad"]
_SOME_RUNS_COLOR = _mix_with_white(_NO_RUN_COLOR, 0.2)


def times_by_robots(
    rows: pd.DataFrame, names: Mapping[str, str], losses: Sequence[float]
) -> Figure:
    """Draw the median time to convergence by robots and middleware: one panel per loss."""
    hosts = sorted(rows["hosts"].unique())
    height = 0.9 + len(losses) * (0.4 + 0.205 * len(names))
    with book_figure(height, "Ten robots take seconds; a few more never finish") as figure:
        panels = figure.subplots(len(losses), 1, squeeze=False)[:, 0]
        for axis, loss in zip(panels, losses, strict=True):
            part = rows[rows["loss"] == loss].set_index(["protocol", "hosts"])
            for line, protocol in enumerate(names):
                for column, count in enumerate(hosts):
                    _draw_cell(axis, column, line, part.loc[(protocol, count)])
            axis.set(xlim=(0, len(hosts)), ylim=(len(names), 0))
            drawing.name_cells(axis, hosts, list(names.values()))
            axis.spines[:].set_visible(False)
            title = f"{loss:.0%} frame errors" if loss else "no frame errors"
            axis.set_title(title, loc="left", fontsize=9.5)
        panels[-1].set_xlabel("robots")
        shades: Style = {"median [s]": _TIME_COLORS(_TIME_NORM(10))}
        shades |= {"runs of ten that finished": _SOME_RUNS_COLOR, "no run finished": _NO_RUN_COLOR}
        patches = [Patch(facecolor=shade, label=label) for label, shade in shades.items()]
        drawing.legend_below(figure, patches, 3)
    return figure


def _draw_cell(axis: Axes, column: int, line: int, row: pd.Series) -> None:
    """Draw the result of one setting."""
    seconds, converged = row["convergence_time_s"], int(row["converged"])
    shade: ColorType = _NO_RUN_COLOR
    text = "never"
    if np.isfinite(seconds):
        shade, text = _TIME_COLORS(_TIME_NORM(seconds)), f"{seconds:.{int(seconds < 9.95)}f}"
        text = "<0.1" if seconds < 0.095 else text
    elif converged:
        shade, text = _SOME_RUNS_COLOR, f"{converged}/10"
    axis.add_patch(Rectangle((column, line), 1, 1, facecolor=shade, edgecolor="white", lw=1.5))
    look: Style = {"color": drawing.letters_on(shade), "fontsize": 7.5 if text == "never" else 8.5}
    axis.text(column + 0.5, line + 0.52, text, ha="center", va="center", **look)


#: Where runs that never converged are drawn, above two minutes: log10 of a time [s].
NEVER_AT = 2.4


def time_quartiles(rows: pd.DataFrame, names: Sequence[str]) -> Figure:
    """Draw the middle half of the runs of the sweep ``convergence``, one panel per middleware."""
    # Times are drawn as powers of ten on a linear axis, so that pages can draw over them.
    columns = [f"convergence_time_s{end}" for end in ("_q25", "", "_q75")]
    limit = np.log10(120)
    with book_figure(2.8, "Above some fleet size, most runs never finish") as figure:
        panels = figure.subplots(1, len(names), sharey=True)
        for axis, name in zip(panels, names, strict=True):
            own = rows[rows["protocol"] == name].sort_values("hosts")
            low, middle, high = np.minimum(np.log10(own[columns].to_numpy().T), NEVER_AT)
            axis.vlines(own["hosts"], low, high, color=COLORS[name], lw=8, alpha=0.35)
            axis.plot(own["hosts"], middle, "_", color=COLORS[name], ms=7, mew=2.5)
            axis.axhline(limit, color=_NO_RUN_COLOR, lw=1)
            axis.set(xlabel="robots", xlim=(0.6, 25.4), ylim=(-1.7, NEVER_AT + 0.25))
            axis.set_xticks(range(4, 25, 4))
            axis.set_title(name, loc="left", fontsize=9.5)
        write_text(panels[0], "two minutes", (0.6, limit), (3, -4), va="top", color=_NO_RUN_COLOR)
        panels[0].set_yticks([-1, 0, 1, 2, NEVER_AT], ["0.1", "1", "10", "100", "never"])
        panels[0].set_ylabel("time until converged [s]")
    return figure


def times_by_window(random: pd.DataFrame, rule: pd.DataFrame) -> Figure:
    """Draw the time to convergence against the window of random starts, and with the rule's."""
    time = "convergence_time_s"
    with book_figure(3.1, "The rule's window is neither too short nor too long") as figure:
        panels = figure.subplots(1, 2, sharey=True)
        for axis, protocol in zip(panels, ("DDS", "Zenoh"), strict=True):
            fleets = random[random["protocol"] == protocol].groupby("hosts")
            for (hosts, rows), share in zip(fleets, np.linspace(0.55, 1, len(fleets)), strict=True):
                color, rows = _mix_with_white(COLORS[protocol], share), rows.sort_values("window_s")
                axis.plot(rows["window_s"], rows[time], "-o", color=color, ms=3)
                span = rows[f"{time}_low"], rows[f"{time}_high"]
                axis.fill_between(rows["window_s"], *span, color=color, alpha=0.25, lw=0)
                star = rule[(rule["protocol"] == protocol) & (rule["hosts"] == hosts)]
                look: Style = {"color": color, "ms": 11, "mec": "black", "mew": 0.6}
                axis.plot(star["rule_s"], star[time], "*", **look)
                # Full color: the tints are too pale for text.
                look = {"ha": "right", "va": "center", "color": COLORS[protocol]}
                write_text(axis, f"{hosts} robots", (0.31, rows[time].iloc[0]), (0, 0), **look)
            axis.set(xscale="log", yscale="log", xlim=(0.05, 55), xlabel="window of the starts [s]")
            drawing.set_ticks(axis.xaxis, [0.5, 1, 2, 5, 10, 20, 45])
            drawing.set_ticks(axis.yaxis, [1, 2, 5, 10, 20, 50])
            axis.set_title(protocol, loc="left")
        panels[0].set_ylabel("time until converged [s]")
        look = {"marker": "*", "color": "0.6", "ms": 11, "mec": "black", "label": "rule of thumb"}
        drawing.legend_below(figure, [Line2D([], [], ls="", **look)], 1)
    return figure


def effects_of_changes(shown: pd.DataFrame) -> Figure:
    """Draw the effect of each change on the time to convergence: dots with intervals."""
    with book_figure(3.1, "Starting in turn helps Zenoh most; aggregation helps DDS") as figure:
        axis = figure.subplots()
        places = np.arange(len(shown))
        for shift, protocol in ((-0.19, "DDS"), (0.19, "Zenoh")):
            color, values = COLORS[protocol], shown[protocol]
            low, high = shown[f"{protocol}_low"], shown[f"{protocol}_high"]
            axis.hlines(places + shift, low, high, color=color, lw=2, alpha=0.6)
            axis.plot(values, places + shift, "o", color=color, ms=6)
            for place, value, *ends in zip(places + shift, values, low, high, strict=True):
                # The number stands near its dot, not at the far end of a long range.
                right = ends[1] - value <= value - ends[0]
                look: Style = {"va": "center", "ha": "left" if right else "right", "color": color}
                text = f"{value:.0f}{f' {protocol}' if place < 0.5 else ''}"
                write_text(axis, text, (ends[right], place), (6 if right else -6, 0), **look)
        axis.set(yticks=places, yticklabels=list(shown.index), xlabel="time until converged [s]")
        axis.set_xlim(0, 1.2 * shown.to_numpy().max())
        axis.invert_yaxis()
        axis.grid(axis="y", visible=False)
    return figure
