"""Figures for dark pages: each color of a picture that was drawn on white becomes its dark one."""

import re
from functools import cache

import numpy as np
from numpy.typing import NDArray

from discostorm.palette import PALETTE

_COLOR = re.compile(r"#[0-9A-Fa-f]{6}\b")
#: Of red, green and blue: how far a mixture is off, as its parts are rounded [1].
_ROUNDED = 0.8


def _parts(color: str) -> NDArray[np.float64]:
    return np.array([int(color[at : at + 2], 16) for at in (1, 3, 5)], dtype=float)


#: What letters and the page itself have on dark ground.
_TEXT, _GROUND = (PALETTE["page", key].dark for key in ("text", "ground"))
#: Of what is drawn: dark colors by light ones. Grays between black and white are mixed.
_DARK = {c.light: c.dark for c in PALETTE.values() if c.group != "page"} | {
    "#000000": _TEXT,
    "#FFFFFF": _GROUND,
}
#: What is mixed with black or white: colors, and black itself.
_MIXED = ["#000000", *(light for light in _DARK if len(set(_parts(light))) > 1)]


@cache
def dark_color(light: str) -> str:
    """Return what a color, or its mixture with black or white, is on dark ground.

    Raises
    ------
    ValueError
        If the palette has neither the color nor one that it is mixed from.
    """
    if light.upper() in _DARK:
        return _DARK[light.upper()].lower()
    wanted = _parts(light)
    mixtures: list[tuple[float, str, str]] = []
    for one in _MIXED:
        for end in ("#FFFFFF", "#000000") if one != "#000000" else ("#FFFFFF",):
            way = _parts(end) - _parts(one)
            share = float(np.clip((wanted - _parts(one)) @ way / (way @ way), 0, 1))
            error = float(np.abs(_parts(one) + share * way - wanted).max())
            if error < _ROUNDED:
                mixtures.append((share, one, end))
    if not mixtures:
        raise ValueError(f"{light}: no color of the palette, nor one mixed with black or white")
    share, one, end = mixtures[0]  # near white there may be several
    mixed = (1 - share) * _parts(_DARK[one]) + share * _parts(_DARK[end])
    return "#" + "".join(f"{round(part):02x}" for part in mixed)


def dark_picture(svg: str) -> str:
    """Return a picture as it is drawn on dark ground; what names no color is as letters are."""
    recolored = _COLOR.sub(lambda found: dark_color(found[0]), svg)
    if re.search(r"<svg\b[^>]*\sfill=", recolored):
        return recolored
    return recolored.replace("<svg ", f'<svg fill="{_TEXT.lower()}" ', 1)
