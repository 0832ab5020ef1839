"""Figs. 2-4: their data against formulas written here, their drawing, their files."""

import json
import re
from collections.abc import Callable

import matplotlib.pyplot as plt
import pandas as pd
import pytest
from IPython.core.pylabtools import print_figure
from matplotlib.category import StrCategoryConverter
from matplotlib.colors import to_rgba
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle
from support import ROOT

import discostorm as ds
from discostorm import figures
from discostorm_book.figures import message_cost_charts, paper_part

DRAWINGS: dict[str, Callable[[], Figure]] = {
    **{name: draw for name, (_, draw) in figures.FIGURES.items()},
    "airtime": message_cost_charts.frame_airtime,
    "bars": lambda: message_cost_charts.message_bars({"DDS": ds.breakdown(ds.DDS, 7, 2, 10)}),
    "shares": lambda: message_cost_charts.message_bars(
        {"Zenoh": ds.breakdown(ds.ZENOH, 7, 2, 10)}, share=True
    ),
}
NOTEBOOKS = ROOT / "notebooks"
#: Drawings that a notebook keeps: its name, the last line of the cell, and the same drawing.
KEPT: list[tuple[str, str, Callable[[], Figure]]] = [
    (
        "02_message_to_airtime",
        "message_cost_charts.frame_airtime()",
        message_cost_charts.frame_airtime,
    ),
    (
        "02_message_to_airtime",
        "paper_part.airtime_blocks(7, 2, 10)",
        lambda: paper_part.airtime_blocks(7, 2, 10),
    ),
    ("03_hosts", "figures.fig2()", figures.fig2),
    ("04_processes", "figures.fig3()", figures.fig3),
    (
        "04_processes",
        "message_cost_charts.message_bars("
        'line_split, title="Splitting the same endpoints costs airtime")',
        lambda: message_cost_charts.message_bars(
            line_split(), title="Splitting the same endpoints costs airtime"
        ),
    ),
    ("05_nav2", "figures.fig4()", figures.fig4),
    (
        "05_nav2",
        "message_cost_charts.message_bars(robots_compared, share=True, title=title)",
        lambda: message_cost_charts.message_bars(
            robots_compared(), share=True, title="With Nav2, nearly all airtime announces endpoints"
        ),
    ),
]


def line_split() -> dict[str, pd.DataFrame]:
    return {
        f"{protocol.name} {n} × {40 // n}": ds.breakdown(protocol, 3, n, 40 // n)
        for protocol in (ds.DDS, ds.ZENOH)
        for n in (1, 2, 4, 8)
    }


def robots_compared() -> dict[str, pd.DataFrame]:
    return {
        f"{protocol.name}, {robot}": ds.breakdown(protocol, 3, *size)
        for robot, size in {"small": (2, 10), "Nav2": (1, 678)}.items()
        for protocol in (ds.DDS, ds.ZENOH)
    }


def frame(size: int) -> float:
    """Seconds of a unicast frame of so many bytes, up and down, with the paper's numbers."""
    return 2 * (8 * size / 144.4e6 + 180e-6)


def cast(size: int) -> float:
    """Seconds of a multicast frame: up as unicast, down once at the basic rate."""
    return frame(size) / 2 + 8 * size / 6e6 + 120e-6


def test_airtime_of_frames() -> None:
    data = message_cost_charts.frame_airtime_data().set_index(["message", "direction"])
    whole = data["overhead_s"] + data["bits_s"]
    assert len(whole) == 16
    assert whole["SPDP", "up"] + whole["SPDP", "down"] == pytest.approx(cast(414), rel=1e-13)
    assert whole["Declare", "up"] == pytest.approx(frame(176) / 2, rel=1e-13)
    assert data.loc[("Scout", "down"), "overhead_s"] == 120e-6
    assert data.loc[("Scout", "up"), "overhead_s"] == 180e-6


@pytest.mark.parametrize("name", DRAWINGS)
def test_every_axis_has_a_label_with_its_unit(name: str) -> None:
    for axes in DRAWINGS[name]().axes:
        place = axes.get_subplotspec()
        for name_of_axis, axis in axes._axis_map.items():
            if name_of_axis == "x" and place and not place.is_last_row():
                continue  # axes above each other share the label of the last
            if name_of_axis == "y" and place and not place.is_first_col():
                continue  # axes beside each other that of the first
            label = axis.label.get_text()
            assert label
            categories = isinstance(axis.get_converter(), StrCategoryConverter)
            counts = re.search(r"\b(hosts|processes|endpoints)\b", label)
            assert categories or "[" in label or counts, label


@pytest.mark.parametrize("name", DRAWINGS)
def test_nothing_is_drawn_outside_the_figure(name: str) -> None:
    figure: Figure = DRAWINGS[name]()
    figure.draw_without_rendering()
    box = figure.get_tightbbox()
    width, height = figure.get_size_inches()
    # A hundredth of an inch is below what is seen.
    assert box.x0 > -0.01
    assert box.y0 > -0.01
    assert box.x1 < width + 0.01
    assert box.y1 < height + 0.01


@pytest.mark.locked
@pytest.mark.parametrize(("name", "line", "draw"), KEPT, ids=[line for _, line, _ in KEPT])
def test_drawings_are_those_that_the_notebooks_keep(
    name: str, line: str, draw: Callable[[], Figure], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Someone has looked at these: nothing in them may change unseen."""
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "0")
    cells = json.loads((NOTEBOOKS / f"{name}.ipynb").read_text(encoding="utf-8"))["cells"]
    kept = next(
        "".join(output["data"]["image/svg+xml"])
        for cell in cells
        if "".join("".join(cell["source"]).split()).endswith("".join(line.split()))
        for output in cell["outputs"]
        if "image/svg+xml" in output.get("data", {})
    )
    with figures.style():
        drawn = print_figure(draw(), "svg", bbox_inches=None)
    assert drawn == kept


@pytest.mark.parametrize("name", DRAWINGS)
def test_no_axis_has_the_unit_one(name: str) -> None:
    for axes in DRAWINGS[name]().axes:
        assert "[1]" not in axes.get_xlabel() + axes.get_ylabel()


@pytest.mark.parametrize("name", DRAWINGS)
def test_drawing_leaves_no_figure_open(name: str) -> None:
    # An open one would be shown a second time below a notebook cell.
    DRAWINGS[name]()
    assert plt.get_fignums() == []


def test_shares_fill_the_bar() -> None:
    axes = message_cost_charts.message_bars(
        {"DDS": ds.breakdown(ds.DDS, 7, 2, 10)}, share=True
    ).axes[0]
    assert sum(
        bar.get_width() for bar in axes.patches if isinstance(bar, Rectangle)
    ) == pytest.approx(1, rel=1e-12)


def test_data_of_bars_are_named_by_what_they_are() -> None:
    swarms = {"DDS": ds.breakdown(ds.DDS, 7, 2, 10)}
    assert [*message_cost_charts.message_bars_data(swarms)] == ["swarm", "message", "utilization"]
    assert [*message_cost_charts.message_bars_data(swarms, share=True)] == [
        "swarm",
        "message",
        "share",
    ]


def test_bars_of_an_unknown_message_are_drawn() -> None:
    table = ds.breakdown(ds.DDS, 7, 2, 10).rename(index={"SEDP": "Something else"})
    assert len(message_cost_charts.message_bars({"own": table}).axes[0].patches) == 4


def test_the_legend_has_the_colors_of_the_bars() -> None:
    table = ds.breakdown(ds.DDS, 7, 2, 10).rename(index={"SPDP": "Ann", "ACKNACK": "Ok"})
    swarms = {"one": table, "other way round": table[::-1], "known": ds.breakdown(ds.DDS, 3, 2, 10)}
    figure = message_cost_charts.message_bars(swarms)
    (legend,) = figure.legends
    color = {
        text.get_text(): handle.get_facecolor()  # type: ignore[attr-defined]
        for text, handle in zip(legend.get_texts(), legend.legend_handles, strict=True)
    }
    assert len(set(color.values())) == len(color) == 6
    # What is no message of the paper has the colors of series.
    assert (color["Ann"], color["Ok"]) == (to_rgba("#5B6B7A"), to_rgba("#882255"))
    bars = [bar for bar in figure.axes[0].patches if isinstance(bar, Rectangle)]
    names = [name for messages in swarms.values() for name in messages.index]
    assert [bar.get_facecolor() for bar in bars] == [color[name] for name in names]
