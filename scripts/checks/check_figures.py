"""Find words of a figure that cover other words, a curve, a dot or a reference line.

`run_notebooks.py` measures each figure of a notebook as a page shows it, and as a phone does.
"""

from collections.abc import Iterator
from itertools import combinations
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from matplotlib.lines import STEP_LOOKUP_MAP  # type: ignore[attr-defined]
from matplotlib.path import Path as Curve
from matplotlib.text import Text
from matplotlib.transforms import Bbox

from discostorm_book import show

#: Share of the size of letters that is white above and below them.
_WHITE = 0.1
_NOTHING = ("None", "none", " ", "", None)


def texts_with_boxes(figure: Figure) -> Iterator[tuple[str, Bbox]]:
    """Yield titles, labels, shown numbers of axes, and legends, with their boxes [px]."""
    texts = list(figure.texts)
    for axes in figure.axes:
        texts += [child for child in axes.get_children() if isinstance(child, Text)]
        for axis in (axes.xaxis, axes.yaxis) if axes.axison else ():
            low, high = sorted(axis.get_view_interval())
            ticks = [*axis.get_major_ticks(), *axis.get_minor_ticks()]
            texts += [axis.label, *(t.label1 for t in ticks if low <= t.get_loc() <= high)]
    for text in texts:
        if text.get_visible() and text.get_text().strip():
            white = _WHITE * float(text.get_fontsize()) * figure.dpi / 72
            # The box of an annotation without its arrow.
            yield repr(text.get_text()), Text.get_window_extent(text).padded(0, -white)
    for legend in [*figure.legends, *(axes.get_legend() for axes in figure.axes)]:
        if legend:
            yield "a legend", legend.get_window_extent()


def marks_of_panel(axes: Axes) -> Iterator[tuple[str, Curve, float]]:
    """Yield the lines and dots of a panel in pixels, with half of their width."""
    pixel = axes.figure.dpi / 72
    for line in axes.lines:
        x, y = STEP_LOOKUP_MAP[line.get_drawstyle()](*np.asarray(line.get_xydata()).T)
        points = line.get_transform().transform(np.column_stack([x, y]))
        if line.get_linestyle() not in _NOTHING:
            yield "a line", Curve(points), line.get_linewidth() * pixel / 2
        if line.get_marker() not in _NOTHING:
            for point in points[np.isfinite(points).all(axis=1)]:
                yield "a dot", Curve([point, point]), line.get_markersize() * pixel / 2
    for lines in axes.collections:
        if isinstance(lines, LineCollection):
            for path in lines.get_paths():
                half = float(np.max(lines.get_linewidth())) * pixel / 2
                yield "a line", lines.get_transform().transform_path(path), half


def find_collisions(figure: Figure) -> list[str]:
    """Return the words of a figure that cover something or leave the figure, with the reason."""
    FigureCanvasAgg(figure).draw()  # type: ignore[no-untyped-call]
    words, edge = list(texts_with_boxes(figure)), figure.bbox.padded(1)
    found = [f"{a} and {b}" for (a, one), (b, two) in combinations(words, 2) if one.overlaps(two)]
    found += [f"{a} and the edge" for a, box in words if edge.count_contains(box.corners()) < 4]
    for axes in figure.axes:
        for name, curve, half in marks_of_panel(axes):
            drawn = curve.cleaned(remove_nans=True)
            for text, box in words:
                shared = Bbox.intersection(box.padded(half), axes.bbox.padded(half))
                if shared and drawn.intersects_bbox(shared, filled=False):
                    found.append(f"{text} and {name}")
    return list(dict.fromkeys(found))


def record_collisions(file: Path) -> None:
    """Let each figure that this process prints in a notebook add its collisions to a file."""
    shown: Any = show
    printed = shown.print_figure

    def measured(figure: Figure, *options: Any, **others: Any) -> Any:
        picture = printed(figure, *options, **others)
        canvas, engine = figure.canvas, figure.get_layout_engine()
        # A second layout would change the next printed figure.
        figure.set_layout_engine("none")
        found = [f"{figure.get_suptitle()}: {words}\n" for words in find_collisions(figure)]
        figure.set_layout_engine(engine)
        figure.set_canvas(canvas)
        with file.open("a", encoding="utf-8") as noted:
            noted.writelines(found)
        return picture

    shown.print_figure = measured
