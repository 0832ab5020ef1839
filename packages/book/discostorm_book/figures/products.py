"""Figures of what products send, beside what the paper counts."""

from collections.abc import Sequence

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Patch
from matplotlib.ticker import FuncFormatter, MaxNLocator, PercentFormatter

from discostorm.figures import COLORS, WIDTH, headline, style
from discostorm_book import comparison, products

_PLAIN = FuncFormatter(lambda value, _: f"{value:g}")
_PAPER = "0.4"
_WINDOWS = {"startup": "startup", "steady": "steady state"}
_FAR = {"small robots": "", "Nav2 robots": ", extrapolated"}
#: The shade of each purpose of messages; what has no equation is hatched.
_SHADES = {"presence": 1.0, "endpoints": 0.6, "control": 0.3, products.NO_EQUATION: 0.0}
#: Height of a row, and what is around the rows of a panel [inch].
_ROW, _AROUND = 0.23, 0.9


def startup(name: str) -> Figure:
    """Draw what a product sent in the startup of three robots: paper, measured, measured model."""
    rows = products.startup(name).iloc[::-1].reset_index(drop=True)
    with style():
        figure = Figure(figsize=(WIDTH, _AROUND + 0.3 + _ROW * len(rows)))
        panels = figure.subplots(1, 2, sharey=True)
        for axis, end, what in zip(
            panels, ("", "_bytes"), ("messages", "payload [B]"), strict=True
        ):
            middle, least, most = (rows[f"{side}{end}"] for side in ("measured", "least", "most"))
            axis.errorbar(
                middle,
                rows.index,
                xerr=(middle - least, most - middle),
                fmt="o",
                markersize=8,
                color=COLORS[name],
                label="measured",
            )
            axis.plot(
                rows[f"expected{end}"], rows.index, "x", color="black", ms=5, zorder=4,
                label="measured model",
            )  # fmt: skip
            axis.plot(
                rows[f"paper{end}"], rows.index, "D", mfc="none", ms=8, zorder=3, color=_PAPER,
                label="paper",
            )  # fmt: skip
            axis.set_xscale("log")
            axis.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:,.0f}"))
            axis.set_xlabel(what)
            axis.grid(axis="y", visible=False)
        panels[0].set_yticks(rows.index, rows["kind"])
        ratio = (rows["measured"] / rows["paper"]).dropna()
        first = int(ratio.argmax())
        kind = rows["kind"][rows["paper"].notna()].iloc[first]
        headline(
            figure, f"{name}: {kind} is sent {ratio.iloc[first]:.0f} times as often as counted"
        )
        handles, labels = panels[0].get_legend_handles_labels()
        figure.legend(handles, labels, loc="outside lower center", ncols=3)
    return figure


def _grouped(names: Sequence[str]) -> tuple[list[float], list[tuple[float, str]]]:
    """Return the place of each row from the top, and the place and name of each group above it."""
    places, heads, place = [], [], 0.0
    for number, name in enumerate(names):
        if not number or name != names[number - 1]:
            heads.append((place, name))
            place += 1
        places.append(place)
        place += 1
    return places, heads


def counts() -> Figure:
    """Draw how often the paper's messages are sent, and how long they are: a row a message."""
    data = products.counts()
    places, heads = _grouped(data["product"].tolist())
    right = data["as_counted"] == 1
    with style():
        figure = Figure(figsize=(WIDTH, _AROUND + 0.2 + 0.2 * (len(places) + len(heads))))
        sent, size = figure.subplots(1, 2, sharey=True)
        sent.axvline(1, color=_PAPER, lw=1)
        for place, row in zip(places, data.to_dict("records"), strict=True):
            color = COLORS[row["product"]]
            for axis, end in ((sent, ""), (size, "_B")):
                axis.plot([row[f"min{end}"], row[f"max{end}"]], [place] * 2, color=color, lw=2)
                axis.plot(row[f"median{end}"], place, "o", color=color, ms=6)
            said = [row["paper_low_B"], row["paper_high_B"]]
            size.plot(said, [place] * 2, color="0.8", lw=9, solid_capstyle="butt", zorder=1)
            size.plot(row["paper_B"], place, "|", color=_PAPER, ms=9, mew=1.5, zorder=1.5)
        sent.set_yticks(places, data["message"])
        sent.set_yticks([place for place, _ in heads], [name for _, name in heads], minor=True)
        for label in sent.get_yticklabels(minor=True):
            label.set(color=COLORS[label.get_text()], weight="bold")
        sent.set_ylim(places[-1] + 0.6, -0.6)
        sent.set(xscale="log", xlim=(0.35, 250), xlabel="sent for each one that the paper counts")
        size.set(xscale="log", xlim=(2, 900), xlabel="payload [B]")
        for axis in (sent, size):
            axis.xaxis.set_major_formatter(_PLAIN)
            axis.grid(axis="y", visible=False)
            axis.tick_params(axis="y", which="both", length=0)
        sent.set_xticks([0.5, 1, 2, 5, 10, 30, 100])
        size.set_xticks([3, 10, 30, 100, 300])
        for axis in (sent, size):
            axis.set_xticks([], minor=True)
        (only,) = data[right].to_dict("records")
        headline(figure, f"One count of {len(data)} holds: {only['message']} of {only['product']}")
    return figure


def counts_data() -> pd.DataFrame:
    """Return what `counts` draws."""
    return products.counts()


def airtime_data(swarms: dict[str, tuple[int, int, int]]) -> pd.DataFrame:
    """Return the airtime of a startup by purpose [s]: a row a swarm and table."""
    return pd.concat(
        {swarm: products.airtime(*counts) for swarm, counts in swarms.items()},
        names=["swarm", "model"],
    ).reset_index()


def airtime(swarms: dict[str, tuple[int, int, int]]) -> Figure:
    """Draw the airtime of a startup by purpose, by the paper and by the measured models.

    Parameters
    ----------
    swarms : dict
        Hosts, processes and endpoints of each, by what it is called: a panel each.
    """
    with style():
        figure = Figure(figsize=(WIDTH, 0.9 + 1.4 * len(swarms)))
        panels, longest = figure.subplots(len(swarms), 1, sharex=True), 0.0
        for axis, (swarm, sizes) in zip(panels, swarms.items(), strict=True):
            data = products.airtime(*sizes)
            longest = max(longest, 1.12 * data.sum(axis=1).max())
            _stack(axis, data)
            axis.set_title(f"{swarm}: {_against_paper(data)}", loc="left", size=9)
            axis.axvline(1, color="black", lw=1)
            axis.set_xlim(0, longest)
            axis.set_ylim(len(data) - 0.5, -0.95)
            axis.text(1.02, -0.72, "one second", va="center", size=9)
        panels[-1].set_xlabel("airtime of startup [s]")
        shades = [
            Patch(facecolor=str(1 - shade * 0.75), label=purpose, ec="0.4", lw=0.6)
            if shade
            else Patch(facecolor="white", hatch="/////", ec="0.4", label=purpose, lw=0.6)
            for purpose, shade in _SHADES.items()
        ]
        figure.legend(handles=shades, loc="outside lower center", ncols=4)
    return figure


def _stack(axis: Axes, data: pd.DataFrame) -> None:
    names = [f"paper, {name}" if name in products.PAPERS else name for name in data.index]
    left = np.zeros(len(data))
    for purpose, shade in _SHADES.items():
        for place, (name, length) in enumerate(data[purpose].items()):
            color = COLORS[str(name)]
            if not length:
                continue
            bar = {"left": left[place], "height": 0.68, "edgecolor": color, "linewidth": 0.6}
            if shade:
                axis.barh(place, length, **bar, facecolor=color, alpha=shade)
            else:
                axis.barh(place, length, **bar, facecolor="white", hatch="/////")
        left += data[purpose].to_numpy()
    for place, total in enumerate(left):
        axis.text(
            total + 0.03, place, f"{total:.2f} s", va="center", size=9,
            bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.5},
        )  # fmt: skip
    axis.set_yticks(range(len(data)), names)
    axis.grid(axis="y", visible=False)
    axis.tick_params(axis="y", length=0)


def _against_paper(data: pd.DataFrame) -> str:
    """Return whether all products need more airtime than the paper counts for them, or less."""
    total = data.sum(axis=1)
    more = {total[name] > total[products.paper_of(name).name] for name in products.SHIPPED}
    need = {(True,): "more", (False,): "less"}.get(tuple(more), "more or less")
    return f"{need} than the paper counts"


def saturation() -> Figure:
    """Draw the hosts that fill a second, by the paper and by the measured models."""
    data = products.saturation()
    papers = data.loc[list(products.PAPERS)]
    models = data.drop(index=list(products.PAPERS))
    places = np.arange(len(models))
    for name in products.SHIPPED:  # as the title says
        of_paper = papers.loc[products.paper_of(name).name]
        assert models["small robots"][name] < of_paper["small robots"]
    with style():
        figure = Figure(figsize=(WIDTH, _AROUND + 0.6 + _ROW * len(models)))
        panels = figure.subplots(1, 2, sharey=True)
        for axis, column in zip(panels, ("small robots", "Nav2 robots"), strict=True):
            most = data[column].max()
            sides = dict(zip(papers[column].sort_values().index, ("right", "left"), strict=True))
            for paper, side in sides.items():
                hosts, color = papers[column][paper], COLORS[str(paper)]
                axis.axvline(hosts, color=color, lw=1.2, ls="--", zorder=0)
                said = f" {paper} {hosts:.1f} "
                axis.text(hosts, -0.85, said, ha=side, va="center", color=color, size=8)
            for place, (model, hosts) in enumerate(models[column].items()):
                axis.plot(hosts, place, "o", color=COLORS[str(model)], ms=7)
                axis.text(
                    hosts + 0.05 * most, place, f"{hosts:.1f}", va="center", size=9,
                    bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.5},
                )  # fmt: skip
            axis.set(xlim=(0, 1.35 * most), ylim=(len(models) - 0.5, -1.3))
            axis.set_title(f"{column}{_FAR[column]}", loc="left", size=8.5)
            axis.set_xlabel("robots that fill one second")
            axis.xaxis.set_major_locator(MaxNLocator(4, integer=True))
            axis.grid(axis="y", visible=False)
            axis.tick_params(axis="y", length=0)
        panels[0].text(
            -0.03, -0.85, "paper", ha="right", va="center", size=9,
            transform=panels[0].get_yaxis_transform(),
        )  # fmt: skip
        headline(figure, "Fewer small robots fill one second than the paper counts")
        panels[0].set_yticks(places, models.index)
    return figure


def errors() -> Figure:
    """Draw by how much each measured model is off, phase by phase: startup and steady state."""
    data, limit, far = products.errors(), comparison.WITHIN_PHASE, 0.5
    held = products.within().set_index(["window", "model"])
    with style():
        figure = Figure(figsize=(WIDTH, _AROUND + 0.3 + 0.34 * len(products.MODELS)))
        panels = figure.subplots(1, 2, sharey=True)
        for axis, (window, title) in zip(panels, _WINDOWS.items(), strict=True):
            axis.axvspan(-limit, limit, color="0.88", zorder=0)
            for place, name in enumerate(products.MODELS):
                rows = data[(data["model"] == name) & (data["window"] == window)]
                off = rows["error"].dropna().clip(-far, far).sort_values()
                spread = 0.3 * np.sin(2.4 * np.arange(len(off)))  # so that dots do not hide others
                axis.plot(off, place + spread, "o", color=COLORS[name], ms=3.5, alpha=0.6, mew=0)
                right, all_of = held.loc[(window, name), ["phases, messages", "phases"]]
                axis.text(
                    1.02, place, f"{right} of {all_of}", va="center", size=8,
                    transform=axis.get_yaxis_transform(),
                )  # fmt: skip
            axis.set(xlim=(-far - 0.03, far + 0.03), ylim=(len(products.MODELS) - 0.5, -0.5))
            axis.set_title(title, loc="left", size=9)
            axis.xaxis.set_major_formatter(PercentFormatter(1, symbol=None))
            axis.set_xlabel("error of a phase [%]")
            axis.grid(axis="y", visible=False)
            axis.tick_params(axis="y", length=0)
        panels[0].set_yticks(range(len(products.MODELS)), products.MODELS)
        headline(figure, "DDS is exact in the steady state; startups scatter")
    return figure
