"""Rearrange a figure for a phone: as narrow as its screen, panels one below the other."""

import math
from itertools import pairwise
from textwrap import wrap
from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.gridspec import GridSpec
from matplotlib.legend import Legend
from matplotlib.text import Annotation, Text

from discostorm.figures.style import style

#: Inches: at this width letters of 9 points are 10 px high on a screen of 360 px.
PHONE_WIDTH = 4.45
#: Inches of a figure around its panels: title, labels of the axis, legend.
_MARGINS = 1.1
#: Share of the width beyond which names of rows are broken, fewest and most letters of a line, and
#: inches of a line of small letters and between two names.
_MAX_NAME_SHARE, _LINE_LETTERS, _LINE, _NAME_GAP = 0.3, (15, 26), 0.145, 0.07
#: Share of a panel beyond which a legend moves below the figure.
_MAX_LEGEND_SHARE = 0.52
#: Inches between long words in a panel and the edge.
_EDGE_GAP = 0.05
#: Most lines of a title.
_MAX_TITLE_LINES = 4


def adapt_for_phone(figure: Figure) -> Figure:
    """Make a figure as narrow as a phone, in place, and return it; the drawing in panels stays."""
    width, height = figure.get_size_inches()
    with style():
        figure.set_size_inches(min(width, PHONE_WIDTH), height + _stack_panels(figure, height))
        figure.draw_without_rendering()
        for text in (text for axis in figure.axes for text in axis.texts):
            # Long words in a panel would take its room.
            if text.get_window_extent().width >= 0.5 * figure.bbox.width:
                text.set_in_layout(False)
        for legend in [*figure.legends, *(axis.get_legend() for axis in figure.axes)]:
            if legend:
                _fold_legend(figure, legend)
        for axis in figure.axes:
            _wrap_row_names(figure, axis)
        _wrap_titles(figure)
        _pull_texts_inside(figure)
    return figure


def _stack_panels(figure: Figure, height: float) -> float:
    """Put panels one below the other; return by how much the figure grows [inch]."""
    placed = [(axis, axis.get_subplotspec()) for axis in figure.axes]
    panels = [axis for axis, place in placed if place is not None]
    grid = next((place.get_gridspec() for _, place in placed if place is not None), None)
    if grid is None or grid.ncols == 1 or len(panels) == grid.nrows * grid.ncols > 3:
        return 0.0
    heights = [axis.get_position().height for axis in panels]
    rows = GridSpec(len(panels), 1, figure, height_ratios=heights)
    for row, axis in enumerate(panels):
        axis.set_subplotspec(rows[row])
        axis.tick_params(which="both", labelleft=True)
        alike = [p for p in panels[:row] if axis.get_shared_y_axes().joined(axis, p)]
        if alike and not axis.get_ylabel():
            axis.set_ylabel(alike[0].get_ylabel())
    return (height - _MARGINS) * (len(panels) / grid.nrows - 1)


def _fold_legend(figure: Figure, legend: Legend) -> None:
    """Give a legend as few columns as fit, below the figure if it would fill its panel."""
    boxes = [text.get_window_extent() for text in legend.get_texts()]
    columns, axis = len({round(box.x0) for box in boxes}), legend.axes
    inside = axis is not None and legend not in figure.legends
    box = legend.get_window_extent()
    room = axis.bbox.width if inside and axis else figure.bbox.width
    if box.width <= (_MAX_LEGEND_SHARE if inside else 1) * room:
        return
    # The widest entry, with its mark.
    widest = max(box.width for box in boxes) + 3 * max(box.height for box in boxes)
    handles = [handle for handle in legend.legend_handles if handle]
    labels = [text.get_text() for text in legend.get_texts()]
    legend.remove()
    look: dict[str, Any] = {"title": legend.get_title().get_text() or None, "columnspacing": 1}
    look["ncols"] = max(1, min(columns + inside, int(figure.bbox.width / widest)))
    figure.legend(handles, labels, loc="outside lower center", **look)
    figure.draw_without_rendering()


def _wrap_row_names(figure: Figure, axis: Axes) -> None:
    """Break long names of rows into lines, and make room for these."""
    names = [tick.label1 for tick in axis.yaxis.get_major_ticks()]
    texts = [" ".join(name.get_text().split()) for name in names]
    widest = max((name.get_window_extent().width for name in names), default=0) / figure.dpi
    width, height = figure.get_size_inches()
    if not axis.axison or widest <= _MAX_NAME_SHARE * width:
        return
    shortest, longest = _LINE_LETTERS
    letters = min(max(shortest, 4 + math.ceil(max(map(len, texts)) / 2)), longest)
    broken = [wrap(text, letters) for text in texts]
    rows = sorted(zip(axis.get_yticks(), map(len, broken), strict=True))
    axis.set_yticks(axis.get_yticks(), ["\n".join(lines) for lines in broken])
    low, high = sorted(axis.get_ylim())
    # Between two rows there is half of each.
    needed = (high - low) * max(
        ((one + other) / 2 * _LINE + _NAME_GAP) / (b - a) for (a, one), (b, other) in pairwise(rows)
    )
    shares = [other.get_position().height for other in figure.axes]
    share = axis.get_position().height
    if (missing := needed - share * height) > 0:
        # The panels share the growth of the figure.
        figure.set_size_inches(width, height + missing * sum(shares) / share)
    figure.draw_without_rendering()


def _wrap_titles(figure: Figure) -> None:
    """Break titles and names of axes that run off the figure."""
    texts = [*figure.texts, *(axis.xaxis.label for axis in figure.axes)]
    for axis in figure.axes:  # their titles
        children = [text for text in axis.get_children() if isinstance(text, Text)]
        texts += [text for text in children if text not in axis.texts]
    for lines in range(2, _MAX_TITLE_LINES + 1):
        boxes = [text.get_window_extent() for text in texts]
        wide = [box.x0 < 0 or box.x1 > figure.bbox.width for box in boxes]
        too_long = [text for text, is_wide in zip(texts, wide, strict=True) if is_wide]
        for text in too_long:
            whole = " ".join(text.get_text().split())
            text.set_text("\n".join(wrap(whole, len(whole) // lines + 4)))
        if too_long:
            figure.draw_without_rendering()


def _pull_texts_inside(figure: Figure) -> None:
    """Move texts that overlap the row names of a panel or leave the figure."""
    for axis in figure.axes:
        ends = [text for text in axis.texts if text.get_horizontalalignment() == "right"]
        over = axis.bbox.x0 - min((text.get_window_extent().x0 for text in ends), default=math.inf)
        if over > 0 and axis.get_xscale() == "log":
            low, high = axis.get_xlim()
            axis.set_xlim(low * (low / high) ** (1.3 * over / axis.bbox.width), high)
        for text in axis.texts:
            # The layout makes room for the other texts.
            over = text.get_window_extent().x1 + _EDGE_GAP * figure.dpi - figure.bbox.width
            if over > 0 and not text.get_in_layout() and isinstance(text, Annotation):
                right, up = text.xyann
                text.xyann = (right - 72 * over / figure.dpi, up)
