"""Shared parts of the chapters' figures: text at marks, row names, ticks, legends."""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.axis import Axis
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter

from discostorm.figures import WIDTH, headline, style

#: Numbers as they are, without powers of ten.
PLAIN_NUMBERS = FuncFormatter(lambda value, _: f"{value:,g}")
#: Options of Matplotlib.
Style = dict[str, Any]
#: The look of a reference line, such as a lease.
LIMIT_LINE: Style = {"color": "gray", "linewidth": 0.8}


@contextmanager
def book_figure(height: float, title: str = "") -> Iterator[Figure]:
    """Give an empty figure as wide as the text, to draw on in the book's style."""
    with style():
        figure = Figure(figsize=(WIDTH, height))
        yield figure
        if title:
            headline(figure, title)


def write_text(
    axis: Axes, text: str, at: tuple[float, float], offset: tuple[float, float], **look: Any
) -> None:
    """Write small words beside a point of a panel; the offset is in points of type."""
    axis.annotate(text, at, offset, textcoords="offset points", **{"fontsize": 9, **look})


def letter_color(color: str) -> list[float]:
    """Return the darker tone of a color that thin letters on white need."""
    return [0.65 * part for part in to_rgb(color)]


def letters_on(ground: Any) -> str:
    """Return the one of black and white that contrasts more with a ground (WCAG 2.2)."""
    return "black" if np.array(to_rgb(ground)) ** 2.2 @ [0.2126, 0.7152, 0.0722] > 0.18 else "white"


def name_rows_without_ticks(axis: Axes, ys: Any = None, names: Any = None, **look: Any) -> None:
    """Name the rows of a panel, if names are given, without ticks and lines."""
    if ys is not None:
        axis.set_yticks(ys, names)
    axis.grid(axis="y", visible=False)
    axis.tick_params(axis="y", length=0, **look)


def name_cells(axis: Axes, columns: Sequence[Any], rows: Sequence[Any]) -> None:
    """Name the columns and rows of a panel of cells, without ticks and lines."""
    axis.set_xticks(np.arange(len(columns)) + 0.5, columns)
    axis.set_yticks(np.arange(len(rows)) + 0.5, rows)
    axis.tick_params(length=0)
    axis.grid(visible=False)


def set_ticks(along: Axis, values: Sequence[float]) -> None:
    """Put ticks at some values of an axis, and none between them."""
    along.set_ticks(values, [f"{value:,g}" for value in values])
    along.set_ticks([], minor=True)


def legend_below(figure: Figure, handles: Sequence[Artist], columns: int, **options: Any) -> None:
    """Put a legend below the panels of a figure."""
    figure.legend(handles=handles, loc="outside lower center", ncols=columns, **options)
