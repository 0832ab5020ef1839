"""Figures for dark pages: drawn with the palette's dark colors, each color of each figure."""

import re
import runpy
from collections.abc import Iterator

import nbformat
import pytest
from support import ROOT

from discostorm.palette import PALETTE
from discostorm_book.show import PHONE_KEY

_extension = runpy.run_path(str(ROOT / "book/_ext/dark.py"))
dark_color, dark_picture = _extension["dark_color"], _extension["dark_picture"]


def pictures() -> Iterator[str]:
    for path in sorted((ROOT / "notebooks").glob("*.ipynb")):
        for cell in nbformat.read(path, as_version=4).cells:
            for output in cell.get("outputs", ()):
                if svg := output.get("data", {}).get("image/svg+xml"):
                    yield svg
                    phone = output["metadata"].get("image/svg+xml", {}).get(PHONE_KEY)
                    yield from [phone] if phone else []


def test_each_color_of_each_figure_has_a_dark_one() -> None:
    drawn = list(pictures())
    assert len(drawn) > 80
    light = {color for svg in drawn for color in re.findall(r"#[0-9a-fA-F]{6}\b", svg)}
    for color in light:
        assert re.fullmatch("#[0-9a-f]{6}", dark_color(color))
    # Letters name no color: they are black, or else light.
    assert all(re.search(r"<svg\b[^>]*\sfill=", dark_picture(svg)) for svg in drawn)


def test_a_color_has_one_dark_one() -> None:
    of_figures = [color for color in PALETTE.values() if color.group != "page"]
    pairs = {(color.light, color.dark) for color in of_figures}
    assert len(pairs) == len({light for light, _ in pairs})


@pytest.mark.parametrize(
    ("light", "dark"),
    [
        ("#0072b2", "#42b5f5"),  # of the palette
        ("#ffffff", "#15181b"),  # the page
        ("#808080", "#797c7f"),  # halfway between letters and page
        ("#7fb8d8", "#2c6788"),  # half of DDS, half of the page
    ],
)
def test_a_dark_color_by_hand(light: str, dark: str) -> None:
    wanted, found = (
        [int(color[at : at + 2], 16) for at in (1, 3, 5)] for color in (dark, dark_color(light))
    )
    assert wanted == pytest.approx(found, abs=1)


def test_a_color_from_elsewhere_is_refused() -> None:
    with pytest.raises(ValueError, match="#12ff34: no color of the palette, nor one mixed"):
        dark_color("#12ff34")
