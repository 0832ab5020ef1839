"""Figures of the messages of products, compared with the paper's counts."""

from collections.abc import Mapping

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Patch
from matplotlib.ticker import FuncFormatter, MaxNLocator, PercentFormatter

from discostorm.figures import COLORS
from discostorm_book import comparison, lab_counts, products
from discostorm_book.figures import drawing
from discostorm_book.figures.drawing import Style, book_figure, write_text

_PAPER_GRAY = "0.4"
#: The shade of each purpose of messages in a bar; messages without an equation are hatched.
_PURPOSE_SHADES = {"presence": 1.0, "endpoints": 0.6, "control": 0.3, products.NO_EQUATION: 0.0}
#: Height of a row, and of the margins around the rows of a panel [inch].
_ROW, _AROUND = 0.23, 0.9


def startup_messages(name: str) -> Figure:
    """Draw a product's messages in the startup of three robots: paper, measured, measured model."""
    rows = products.startup_counts(name).iloc[::-1].reset_index(drop=True)
    counted = rows[rows["paper"].notna()]
    ratio = counted["measured"] / counted["paper"]
    often = f"{counted['kind'].iloc[ratio.argmax()]} is sent {ratio.max():.0f} times"
    title = f"{name}: {often} as often as counted"
    with book_figure(_AROUND + 0.3 + _ROW * len(rows), title) as figure:
        panels = figure.subplots(1, 2, sharey=True)
        whats = {"": "messages", "_bytes": "payload [B]"}
        for axis, (end, what) in zip(panels, whats.items(), strict=True):
            middle, low, high = (rows[f"{side}{end}"] for side in ("measured", "least", "most"))
            look: Style = {"fmt": "o", "ms": 8, "color": COLORS[name], "label": "measured"}
            axis.errorbar(middle, rows.index, xerr=(middle - low, high - middle), **look)
            look = {"color": "black", "mew": 0, "ms": 6, "label": "measured model"}
            axis.plot(rows[f"expected{end}"], rows.index, "X", zorder=4, **look)
            look = {"mfc": "none", "ms": 8, "zorder": 3, "color": _PAPER_GRAY, "label": "paper"}
            axis.plot(rows[f"paper{end}"], rows.index, "D", **look)
            axis.set(xscale="log", xlabel=what)
            axis.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:,.0f}"))
            axis.grid(axis="y", visible=False)
        panels[0].set_yticks(rows.index, rows["kind"])
        drawing.legend_below(figure, panels[0].get_legend_handles_labels()[0], 3)
    return figure


def message_counts() -> Figure:
    """Draw how often the paper's messages are sent, and how long they are: one row per message."""
    data = products.sent_per_counted_message()
    heads: dict[int, str] = {}  # of the groups
    ys: list[int] = []  # of the rows
    for name, rows in data.groupby("product", sort=False):
        heads[len(heads) + len(ys)] = str(name)
        ys += [len(heads) + len(ys) + row for row in range(len(rows))]
    (only,) = data[data["as_counted"] == 1].to_dict("records")
    title = f"One count of {len(data)} holds: {only['message']} of {only['product']}"
    with book_figure(_AROUND + 0.2 + 0.2 * (len(ys) + len(heads)), title) as figure:
        sent, size = figure.subplots(1, 2, sharey=True)
        sent.axvline(1, color=_PAPER_GRAY, lw=1)
        for y, row in zip(ys, data.to_dict("records"), strict=True):
            color = COLORS[row["product"]]
            for axis, end in ((sent, ""), (size, "_B")):
                axis.plot([row[f"min{end}"], row[f"max{end}"]], [y] * 2, color=color, lw=2)
                axis.plot(row[f"median{end}"], y, "o", color=color, ms=6)
            stated = [row["paper_low_B"], row["paper_high_B"]]
            size.plot(stated, [y] * 2, color="0.8", lw=9, solid_capstyle="butt", zorder=1)
            size.plot(row["paper_B"], y, "|", color=_PAPER_GRAY, ms=9, mew=1.5, zorder=1.5)
        sent.set_yticks(ys, data["message"])
        sent.set_yticks(list(heads), heads.values(), minor=True)
        sent.set_ylim(ys[-1] + 0.6, -0.6)
        sent.set(xscale="log", xlim=(0.35, 250), xlabel="sent for each one that the paper counts")
        size.set(xscale="log", xlim=(2, 900), xlabel="payload [B]")
        drawing.set_ticks(sent.xaxis, [0.5, 1, 2, 5, 10, 30, 100])
        drawing.set_ticks(size.xaxis, [3, 10, 30, 100, 300])
        for axis in (sent, size):
            drawing.name_rows_without_ticks(axis)
            axis.tick_params(axis="y", which="minor", length=0)
            for tick, name in zip(axis.yaxis.get_minor_ticks(), heads.values(), strict=True):
                tick.label1.set(color=drawing.letter_color(COLORS[name]), weight="bold")
    return figure


def startup_airtime_data(swarms: Mapping[str, tuple[int, int, int]]) -> pd.DataFrame:
    """Return the airtime of a startup by purpose [s]: one row per swarm and table."""
    tables = {swarm: products.airtime_by_purpose(*sizes) for swarm, sizes in swarms.items()}
    return pd.concat(tables, names=["swarm", "model"]).reset_index()


def startup_airtime(swarms: Mapping[str, tuple[int, int, int]]) -> Figure:
    """Draw `startup_airtime_data`, by the paper and by the measured models: one panel per swarm."""
    with book_figure(0.9 + 1.4 * len(swarms)) as figure:
        panels, longest = figure.subplots(len(swarms), 1, sharex=True), 0.0
        for axis, (swarm, sizes) in zip(panels, swarms.items(), strict=True):
            data = products.airtime_by_purpose(*sizes)
            longest = max(longest, 1.12 * data.sum(axis=1).max())
            _draw_stacked_bars(axis, data)
            axis.set_title(f"{swarm}: {_more_or_less_than_paper(data)}", loc="left", size=9)
            axis.axvline(1, color="black", lw=1)
            axis.set(xlim=(0, longest), ylim=(len(data) - 0.5, -0.95))
            axis.text(1.02, -0.72, "one second", va="center", size=9)
        panels[-1].set_xlabel("airtime of startup [s]")
        shades = [
            Patch(ec="0.4", lw=0.6, label=purpose, **_bar_style(str(1 - shade * 0.75), shade > 0))
            for purpose, shade in _PURPOSE_SHADES.items()
        ]
        drawing.legend_below(figure, shades, 4)
    return figure


def _bar_style(color: str, filled: bool) -> Style:
    return {"facecolor": color} if filled else {"facecolor": "white", "hatch": "/////"}


def _draw_stacked_bars(axis: Axes, data: pd.DataFrame) -> None:
    """Draw the airtime of each table as a bar of its purposes, with the sum at its end."""
    left = np.zeros(len(data))
    for purpose, shade in _PURPOSE_SHADES.items():
        for y, (name, length) in enumerate(data[purpose].items()):
            look: Style = {"left": left[y], "height": 0.68, "linewidth": 0.6}
            look |= _bar_style(COLORS[str(name)], shade > 0) | {"alpha": shade or None}
            if length:
                axis.barh(y, length, edgecolor=COLORS[str(name)], **look)
        left += data[purpose].to_numpy()
    for y, total in enumerate(left):
        start = 1 if 0.7 < total < 1 else total  # a number may not cover the line of one second
        axis.text(start + 0.03, y, f"{total:.2f} s", va="center", size=9)
    names = [f"paper, {name}" if name in products.PAPER_TABLES else name for name in data.index]
    drawing.name_rows_without_ticks(axis, range(len(data)), names)


def _more_or_less_than_paper(data: pd.DataFrame) -> str:
    """Return a title: all products need more airtime than the paper counts, or less."""
    total = data.sum(axis=1)
    more = {
        total[name] > total[lab_counts.paper_protocol_of_product(name).name]
        for name in products.SHIPPED
    }
    need = {(True,): "more", (False,): "less"}.get(tuple(more), "more or less")
    return f"{need} than the paper counts"


def saturation_points() -> Figure:
    """Draw the number of hosts at saturation, by the paper and by the measured models."""
    data = products.saturation_points()
    papers = data.loc[list(products.PAPER_TABLES)]
    models = data.drop(index=list(products.PAPER_TABLES))
    for name in products.SHIPPED:  # as the title says
        of_paper = papers.loc[lab_counts.paper_protocol_of_product(name).name]
        assert models["small robots"][name] < of_paper["small robots"]
    title = "Fewer small robots fill one second than the paper counts"
    with book_figure(_AROUND + 0.6 + _ROW * len(models), title) as figure:
        panels = figure.subplots(1, 2, sharey=True)
        for axis, column in zip(panels, ("small robots", "Nav2 robots"), strict=True):
            most = data[column].max()
            sorted_papers = papers[column].sort_values()
            for (paper, hosts), side in zip(sorted_papers.items(), ("right", "left"), strict=True):
                color = COLORS[str(paper)]
                axis.axvline(hosts, color=color, lw=1.2, ls="--", zorder=0)
                across = -5 if side == "right" else 5
                look: Style = {"ha": side, "va": "center", "color": color, "fontsize": 8}
                write_text(axis, f"{paper} {hosts:.1f}", (hosts, -0.85), (across, 0), **look)
            for y, (model, hosts) in enumerate(models[column].items()):
                axis.plot(hosts, y, "o", color=COLORS[str(model)], ms=7)
                before = sorted_papers.between(hosts + 0.03 * most, hosts + 0.22 * most).any()
                across, side = (-7, "right") if before else (7, "left")
                write_text(axis, f"{hosts:.1f}", (hosts, y), (across, 0), ha=side, va="center")
            axis.set(xlim=(0, 1.35 * most), ylim=(len(models) - 0.5, -1.3))
            beyond = ", extrapolated" if column == "Nav2 robots" else ""
            axis.set_title(f"{column}{beyond}", loc="left", size=8.5)
            axis.set_xlabel("robots that fill one second")
            axis.xaxis.set_major_locator(MaxNLocator(4, integer=True))
            drawing.name_rows_without_ticks(axis)
        look = {"ha": "right", "va": "center", "size": 9}
        across = panels[0].get_yaxis_transform()
        panels[0].text(-0.03, -0.85, "paper", transform=across, **look)
        panels[0].set_yticks(range(len(models)), models.index)
    return figure


def model_errors() -> Figure:
    """Draw by how much each measured model is off, phase by phase: startup and steady state."""
    data, limit, far = products.held_out_errors(), comparison.MAX_PHASE_ERROR, 0.5
    held = products.count_within_limits().set_index(["window", "model"])
    height = _AROUND + 0.3 + 0.34 * len(products.MODELS)
    with book_figure(height, "DDS is exact in the steady state; startups scatter") as figure:
        panels = figure.subplots(1, 2, sharey=True)
        windows = {"startup": "startup", "steady": "steady state"}
        for axis, (window, title) in zip(panels, windows.items(), strict=True):
            axis.axvspan(-limit, limit, color="0.88", zorder=0)
            for y, name in enumerate(products.MODELS):
                rows = data[(data["model"] == name) & (data["window"] == window)]
                off = rows["error"].dropna().clip(-far, far).sort_values()
                spread = 0.3 * np.sin(2.4 * np.arange(len(off)))  # so that dots do not hide others
                axis.plot(off, y + spread, "o", color=COLORS[name], ms=3.5, alpha=0.6, mew=0)
                right, all_of = held.loc[(window, name), ["phases, messages", "phases"]]
                look = {"va": "center", "size": 8, "transform": axis.get_yaxis_transform()}
                axis.text(1.02, y, f"{right} of {all_of}", **look)
            axis.set(xlim=(-far - 0.03, far + 0.03), ylim=(len(products.MODELS) - 0.5, -0.5))
            axis.set_title(title, loc="left", size=9)
            axis.xaxis.set_major_formatter(PercentFormatter(1, symbol=None))
            axis.set_xlabel("error of a phase [%]")
            drawing.name_rows_without_ticks(axis)
        panels[0].set_yticks(range(len(products.MODELS)), products.MODELS)
    return figure
