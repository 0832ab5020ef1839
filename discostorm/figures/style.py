"""The looks of every figure: one color a product, one line style a phase, one style sheet."""

from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from itertools import cycle
from pathlib import Path
from typing import Any

import matplotlib as mpl
from cycler import cycler
from matplotlib.figure import Figure

from discostorm.data import data_path
from discostorm.messages import Protocol
from discostorm.palette import PALETTE, Color, lights
from discostorm.protocols import PROTOCOLS

#: One line style a phase.
STYLES = {
    "total": "-",
    "SPDP": ":",
    "Scouting": ":",
    "SEDP": "--",
    "Declaration": "--",
}
#: One shade of its family's color a message of the paper.
MESSAGE_COLORS = lights("shade")
#: Inches: the text's width in print; on a page letters are then a little smaller than the text's.
WIDTH = 6.3
#: Style sheets of every figure, as `matplotlib.style.use` takes them.
SHEETS: tuple[Path, dict[Any, Any]] = (
    data_path("discostorm.mplstyle"),
    {"axes.prop_cycle": cycler(color=lights("series").values())},
)


@contextmanager
def style() -> Iterator[None]:
    """Draw with the looks of the book inside a ``with`` block."""
    path, series = SHEETS
    with mpl.rc_context(series, path):
        yield


def headline(figure: Figure, text: str) -> None:
    """Say above a figure what it shows."""
    figure.suptitle(text, x=0.01, ha="left", fontsize=10, fontweight="bold")


def palette_of(protocols: Iterable[Protocol]) -> list[Color]:
    """Return a row of the palette for each table: of its product, else its family, else its basis.

    Tables that say none of these, such as those of your own, have neutral colors in order.
    """
    neutral = cycle(color for color in PALETTE.values() if color.group == "neutral")
    return [_own(protocol) or next(neutral) for protocol in protocols]


def color_of(protocol: Protocol) -> str:
    """Return the color of a table in figures: that of its product, else of its family."""
    return palette_of([protocol])[0].light


def property_of(protocol: Protocol) -> str:
    """Return the same on pages: a custom property of ``palette.css``, for light and dark."""
    return palette_of([protocol])[0].property


def _own(protocol: Protocol) -> Color | None:
    said = (("product", protocol.product), ("family", protocol.family), ("basis", protocol.basis))
    for group, key in said:
        if key is not None and (group, key) in PALETTE:
            return PALETTE[group, key]
    return None


#: The colors of `PROTOCOLS` by their names; of any other table, see `color_of`.
COLORS = {
    protocol.name: color.light
    for protocol, color in zip(PROTOCOLS.values(), palette_of(PROTOCOLS.values()), strict=True)
}
