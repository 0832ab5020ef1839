"""Any figure again for a phone: as narrow as its screen, panels one below the other."""

import math
from itertools import pairwise
from textwrap import wrap

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.gridspec import GridSpec
from matplotlib.legend import Legend
from matplotlib.text import Text
from matplotlib.transforms import ScaledTranslation

from discostorm.figures.looks import style

#: Inches: at this width letters of 9 points are 10 px high on a screen of 360 px.
NARROW = 4.45
#: Inches of a figure that are not panels: title, labels of the axis, legend.
_AROUND = 1.1
#: Share of the width beyond which names of rows are broken, letters that always stay on their line,
#: and inches of a line of small letters and of what parts two names.
_NAMES, _LETTERS, _LINE, _GAP = 0.3, 15, 0.145, 0.07
#: Share of a panel beyond which a legend is no longer in it but below the figure.
_LEGEND = 0.52
#: Inches that words in a panel keep off the edge.
_EDGE = 0.05
#: Most lines of a title.
_LINES = 4


def narrowed(figure: Figure) -> Figure:
    """Make a figure that was drawn for a page as narrow as a phone, and return it.

    Panels that stood beside each other come one below the other, unless they are a grid that
    shares both axes. Titles, names of rows and legends are broken where they are too long. What is
    drawn in the panels stays as it is.
    """
    width, height = figure.get_size_inches()
    with style():
        figure.set_size_inches(min(width, NARROW), height + _stack(figure, height))
        figure.draw_without_rendering()
        for text in (text for axis in figure.axes for text in axis.texts):
            # Long words in a panel would take its room.
            text.set_in_layout(text.get_window_extent().width < 0.5 * figure.bbox.width)
        legends = [*figure.legends, *(axis.legend_ for axis in figure.axes)]
        for legend in filter(None, legends):
            _fold(figure, legend)
        for axis in figure.axes:
            _name_rows(figure, axis)
        _wrap(figure)
        _pull_in(figure)
    return figure


def _stack(figure: Figure, height: float) -> float:
    """Put panels one below the other; return how much higher that is [inch]."""
    placed = [(axis, axis.get_subplotspec()) for axis in figure.axes]
    panels = [axis for axis, place in placed if place is not None]
    grid = next((place.get_gridspec() for _, place in placed if place is not None), None)
    if grid is None or grid.ncols == 1 or len(panels) == grid.nrows * grid.ncols > 3:
        return 0.0
    rows = GridSpec(
        len(panels), 1, figure, height_ratios=[axis.get_position().height for axis in panels]
    )
    for row, axis in enumerate(panels):
        axis.set_subplotspec(rows[row])
        axis.tick_params(labelleft=True)
        alike = [p for p in panels[:row] if axis.get_shared_y_axes().joined(axis, p)]
        if alike and not axis.get_ylabel():
            axis.set_ylabel(alike[0].get_ylabel())
    return (height - _AROUND) * (len(panels) / grid.nrows - 1)


def _fold(figure: Figure, legend: Legend) -> None:
    """Give a legend as few columns as fit, below the figure if it would fill its panel."""
    box, axis = legend.get_window_extent(), legend.axes
    outside = legend in figure.legends or axis is None
    # A place of its own, beside the panel, is measured in widths of that.
    moved = not outside and legend._bbox_to_anchor is not None  # type: ignore[attr-defined]
    if not outside and axis is not None:
        moved |= box.width > _LEGEND * axis.bbox.width and legend._ncols == 1  # type: ignore[attr-defined]
    if not moved and box.x0 >= 0 and box.x1 <= figure.bbox.width:
        return
    columns = legend._ncols + moved  # type: ignore[attr-defined]
    while columns > 1 and columns * _column(legend) > figure.bbox.width:
        columns -= 1
    handles = [handle for handle in legend.legend_handles if handle]
    labels = [text.get_text() for text in legend.get_texts()]
    title = legend.get_title().get_text() or None
    above = outside and legend._loc == 9  # type: ignore[attr-defined]
    legend.remove()
    for other in figure.legends if moved else []:  # both would be in the same place
        handles = [*filter(None, other.legend_handles), *handles]
        labels = [*(text.get_text() for text in other.get_texts()), *labels]
        other.remove()
    figure.legend(
        handles, labels, title=title, ncols=columns, columnspacing=1,
        loc="outside upper center" if above else "outside lower center",
    )  # fmt: skip
    figure.draw_without_rendering()


def _column(legend: Legend) -> float:
    """Return the width of the widest entry of a legend, with its mark [px]."""
    boxes = [text.get_window_extent() for text in legend.get_texts()]
    return float(max(box.width for box in boxes) + 3 * max(box.height for box in boxes))


def _name_rows(figure: Figure, axis: Axes) -> None:
    """Break long names of rows into two lines, and make room for these."""
    ticks = axis.yaxis.get_major_ticks()
    texts = [" ".join(tick.label1.get_text().split()) for tick in ticks]
    widest = max((t.label1.get_window_extent().width for t in ticks), default=0) / figure.dpi
    width, height = figure.get_size_inches()
    if not axis.axison or widest <= _NAMES * width:
        return
    letters = max(_LETTERS, 1 + math.ceil(max(map(len, texts)) / 2))
    broken = ["\n".join(wrap(text, letters)) for text in texts]
    places = sorted(axis.get_yticks())
    axis.set_yticks(axis.get_yticks(), broken)
    lines = 1 + max(text.count("\n") for text in broken)
    least = min((b - a for a, b in pairwise(places)), default=1)
    low, high = sorted(axis.get_ylim())
    needed = (high - low) / least * (lines * _LINE + _GAP)
    shares = [other.get_position().height for other in figure.axes]
    share = axis.get_position().height
    if (missing := needed - share * height) > 0:
        # What a figure grows by is shared by its panels.
        figure.set_size_inches(width, height + missing * sum(shares) / share)
    figure.draw_without_rendering()


def _wrap(figure: Figure) -> None:
    """Break titles and names of axes that run off the figure."""
    texts: list[Text] = [text for text in (figure._suptitle,) if text]  # type: ignore[attr-defined]
    for axis in figure.axes:
        texts += [axis.title, axis._left_title, axis.xaxis.label]  # type: ignore[attr-defined]
    for lines in range(2, _LINES + 1):
        too_long = [
            text for text in texts
            if (box := text.get_window_extent()).x0 < 0 or box.x1 > figure.bbox.width
        ]  # fmt: skip
        for text in too_long:
            whole = " ".join(text.get_text().split())
            text.set_text("\n".join(wrap(whole, len(whole) // lines + 4)))
        if too_long:
            figure.draw_without_rendering()


def _pull_in(figure: Figure) -> None:
    """Keep words that stand in a panel off its names of rows, and on the figure."""
    for axis in figure.axes:
        ends = [text for text in axis.texts if text.get_horizontalalignment() == "right"]
        over = axis.bbox.x0 - min((text.get_window_extent().x0 for text in ends), default=math.inf)
        if over > 0 and axis.get_xscale() == "log":
            low, high = axis.get_xlim()
            axis.set_xlim(low * (low / high) ** (1.3 * over / axis.bbox.width), high)
        for text in axis.texts:
            over = text.get_window_extent().x1 - figure.bbox.width + _EDGE * figure.dpi
            if over > 0:
                back = ScaledTranslation(-over / figure.dpi, 0, figure.dpi_scale_trans)
                text.set_transform(text.get_transform() + back)
                text.set_in_layout(False)
