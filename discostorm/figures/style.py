"""The style of every figure: colors of products, line styles of phases, one style sheet."""

from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from itertools import cycle
from pathlib import Path
from typing import Any

import matplotlib as mpl
from cycler import cycler
from matplotlib.figure import Figure

from discostorm.data import data_path
from discostorm.lookup import AnyProtocol, as_protocol
from discostorm.messages import Protocol
from discostorm.palette import PALETTE, Color, light_colors
from discostorm.protocols import PROTOCOLS

#: Line styles of phases.
DASHES = {"total": "-", "SPDP": ":", "Scouting": ":", "SEDP": "--", "Declaration": "--"}
#: Colors of the paper's messages: shades of the color of DDS or Zenoh.
MESSAGE_COLORS = light_colors("shade")
#: Inches: the text's width in print; on a page letters are then a little smaller than the text's.
WIDTH = 6.3
#: Style sheets of every figure, as `matplotlib.style.use` takes them.
STYLE_SHEETS: tuple[Path, dict[Any, Any]] = (
    data_path("discostorm.mplstyle"),
    {"axes.prop_cycle": cycler(color=light_colors("series").values())},
)


@contextmanager
def style() -> Iterator[None]:
    """Draw with the style of the book inside a ``with`` block."""
    path, series = STYLE_SHEETS
    with mpl.rc_context(series, path):
        yield


def headline(figure: Figure, text: str) -> None:
    """Write a sentence above a figure."""
    figure.suptitle(text.replace("'", "\u2019"), x=0.01, ha="left", fontsize=10, fontweight="bold")


def protocol_colors(protocols: Iterable[Protocol]) -> list[Color]:
    """Return the color of each protocol's product, family or basis; else the next neutral."""
    neutral = cycle(color for color in PALETTE.values() if color.group == "neutral")
    keys = [[(key, getattr(of, key)) for key in ("product", "family", "basis")] for of in protocols]
    own = (next((PALETTE[key] for key in of if key in PALETTE), None) for of in keys)
    return [color or next(neutral) for color in own]


def color_of(protocol: AnyProtocol) -> str:
    """Return the color of a protocol in figures, as a hex code."""
    return protocol_colors([as_protocol(protocol)])[0].light


def css_color_property(protocol: Protocol) -> str:
    """Return the custom property of ``palette.css`` for the color of a protocol."""
    return protocol_colors([protocol])[0].property


#: The colors of `PROTOCOLS` by their names.
_LIGHT = (color.light for color in protocol_colors(PROTOCOLS.values()))
COLORS = dict(zip(PROTOCOLS, _LIGHT, strict=True))
