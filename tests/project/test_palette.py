"""One palette: figures, pages, calculator and ledger have their colors from one file."""

import itertools
import re
import runpy
from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray
from support import ROOT

import discostorm as ds
from discostorm import figures
from discostorm.palette import PALETTE, Color, light_colors

_script = runpy.run_path(str(ROOT / "scripts/generate/write_palette.py"))
STYLE_SHEET_FILE, style_sheet_text = _script["STYLE_SHEET_FILE"], _script["style_sheet_text"]

#: What those see who lack one kind of cones (Machado, Oliveira and Fernandes, 2009), linear RGB.
EYES = {
    "all cones": ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
    "protanopia": (
        (0.152286, 1.052583, -0.204868),
        (0.114503, 0.786281, 0.099216),
        (-0.003882, -0.048116, 1.051998),
    ),
    "deuteranopia": (
        (0.367322, 0.860646, -0.227968),
        (0.280085, 0.672501, 0.047413),
        (-0.011820, 0.042940, 0.968881),
    ),
    "tritanopia": (
        (1.255528, -0.076749, -0.178779),
        (-0.078411, 0.930809, 0.147602),
        (0.004733, 0.691367, 0.303900),
    ),
}
OWNERS = [color for color in PALETTE.values() if color.group in ("family", "product", "basis")]


def linear(color: str) -> NDArray[np.float64]:
    """Return red, green and blue as linear light."""
    parts = np.array([int(color[at : at + 2], 16) / 255 for at in (1, 3, 5)])
    return np.where(parts <= 0.04045, parts / 12.92, ((parts + 0.055) / 1.055) ** 2.4)


def luminance(color: str) -> float:
    return float(linear(color) @ (0.2126, 0.7152, 0.0722))


def lab(light: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return linear light as L*a*b* of CIE."""
    to_xyz = ((0.4124, 0.3576, 0.1805), (0.2126, 0.7152, 0.0722), (0.0193, 0.1192, 0.9505))
    x, y, z = np.array(to_xyz) @ light.clip(0, 1) / (0.9505, 1, 1.089)
    x, y, z = (np.cbrt(t) if t > 0.008856 else 7.787 * t + 16 / 116 for t in (x, y, z))
    return np.array([116 * y - 16, 500 * (x - y), 200 * (y - z)])


def distance(one: Color, other: Color, eyes: str, ground: str) -> float:
    seen = [lab(np.array(EYES[eyes]) @ linear(getattr(of, ground))) for of in (one, other)]
    return float(np.linalg.norm(seen[0] - seen[1]))


@pytest.mark.parametrize("ground", ["light", "dark"])
@pytest.mark.parametrize("eyes", EYES)
def test_families_and_products_are_told_apart_by_all_eyes(eyes: str, ground: str) -> None:
    for one, other in itertools.combinations(OWNERS, 2):
        assert distance(one, other, eyes, ground) > 10, (one, other)


@pytest.mark.parametrize("ground", ["light", "dark"])
@pytest.mark.parametrize("eyes", EYES)
def test_messages_and_series_are_told_apart_by_all_eyes(eyes: str, ground: str) -> None:
    sets = [{message.name for message in of.messages} for of in (ds.DDS, ds.ZENOH)]
    sets = [
        [one for one in PALETTE.values() if one.group == "shade" and one.key in of] for of in sets
    ]
    sets += [[one for one in PALETTE.values() if one.group == "series"]]
    assert [len(of) for of in sets] == [4, 4, 5]
    for of in sets:
        for one, other in itertools.combinations(of, 2):
            assert distance(one, other, eyes, ground) > 10, (one, other)


@pytest.mark.parametrize("ground", ["light", "dark"])
def test_what_is_no_product_has_no_product_s_color(ground: str) -> None:
    series = [one for one in PALETTE.values() if one.group in ("series", "captured other")]
    for one, owner in itertools.product(series, OWNERS):
        assert distance(one, owner, "all cones", ground) > 10, (one, owner)


@pytest.mark.parametrize("ground", ["light", "dark"])
def test_what_pages_write_in_color_can_be_read(ground: str) -> None:
    below = luminance(getattr(PALETTE["page", "ground"], ground))

    def contrast(one: Color) -> float:
        parts = sorted((luminance(getattr(one, ground)), below))
        return (parts[1] + 0.05) / (parts[0] + 0.05)

    letters = [one for one in PALETTE.values() if one.group in ("verdict", "state")]
    letters += [PALETTE["page", key] for key in ("accent", "accent strong", "text", "muted")]
    assert [one.key for one in letters if contrast(one) < 4.5] == []
    # Lines and bars; figures on light ground have Okabe and Ito's colors, thick or with an edge.
    assert [one.key for one in OWNERS if contrast(one) < (2.2 if ground == "light" else 3)] == []
    shades = [one for one in PALETTE.values() if one.group == "shade"]
    assert [one.key for one in shades if contrast(one) < (1.8 if ground == "light" else 3)] == []


def test_every_color_is_one() -> None:
    for color in PALETTE.values():
        assert re.fullmatch("#[0-9A-F]{6}", color.light), color
        assert re.fullmatch("#[0-9A-F]{6}", color.dark), color
    assert len({color.property for color in PALETTE.values()}) == len(PALETTE)


def test_the_style_sheet_of_the_pages_is_the_palette() -> None:
    assert STYLE_SHEET_FILE.read_text(encoding="utf-8") == style_sheet_text(), "run `make palette`"


def test_no_other_file_has_colors_of_its_own() -> None:
    files = [
        *(ROOT / "discostorm").rglob("*.py"),
        *(ROOT / "packages").glob("*/discostorm_*/**/*.py"),
        *(ROOT / "discostorm/data").glob("*.mplstyle"),
        *(ROOT / "book").glob("*.md"),
        *(ROOT / "book/_static").glob("*.[cj]s*"),
        *(ROOT / "book/_static/landing").glob("*"),
        *(ROOT / "book/_static/calculator").glob("*.[cj]s*"),
    ]
    assert len(files) > 100
    found = [
        f"{file.relative_to(ROOT)}: {color}"
        for file in files
        if file != STYLE_SHEET_FILE
        for color in re.findall(r"#[0-9A-Fa-f]{6}\b", file.read_text(encoding="utf-8"))
    ]
    # The example in the docstrings of `palette`.
    assert [one for one in found if not one.startswith("discostorm/palette.py")] == []


def test_style_sheets_and_scripts_ask_for_colors_that_there_are() -> None:
    there = set(re.findall(r"--ds-[\w-]+", style_sheet_text()))
    groups = "|".join({color.group.replace(" ", "-") for color in PALETTE.values()})
    for file in (ROOT / "book/_static").rglob("*.[cj]s*"):
        if file.suffix in (".css", ".js"):
            asked = set(re.findall(rf"--ds-(?:{groups})-[\w-]+", file.read_text(encoding="utf-8")))
            assert asked <= there, file


def test_the_logo_and_the_pdf_have_the_colors_of_the_palette() -> None:
    logo = (ROOT / "book/_static/logo.svg").read_text(encoding="utf-8")
    assert set(re.findall("#[0-9A-F]{6}", logo)) <= set(light_colors("family").values())
    config = (ROOT / "_config.yml").read_text(encoding="utf-8")
    asked = re.findall(r"(\w+)Color=\{RGB\}\{(\d+),(\d+),(\d+)\}", config)
    page = light_colors("page")
    for what, *parts in asked:
        wanted = page["text"] if what == "Title" else page["accent"]
        assert "#" + "".join(f"{int(part):02X}" for part in parts) == wanted
    assert len(asked) == 3


def test_rows_that_are_to_be_the_same_are() -> None:
    family = light_colors("family")
    assert (light_colors("shade")["SEDP"], light_colors("shade")["Declare"]) == tuple(
        family.values()
    )
    assert light_colors("page")["accent"] == family["DDS"]


def test_a_table_has_the_color_of_its_product_whatever_its_name() -> None:
    for name, protocol in ds.PROTOCOLS.items():
        renamed = replace(protocol, name="mine")
        assert figures.color_of(renamed) == figures.color_of(protocol) == figures.COLORS[name]
        said = [(group, getattr(protocol, group)) for group in ("product", "family", "basis")]
        assert figures.COLORS[name] == next(PALETTE[key].light for key in said if key in PALETTE)


def test_tables_of_no_product_have_neutral_colors_in_order() -> None:
    made_up = ds.Protocol("mine", ds.DDS.messages)
    colors = [
        one.key for one in figures.protocol_colors([made_up, ds.DDS, made_up, made_up, made_up])
    ]
    assert colors == ["gray", "DDS", "charcoal", "silver", "gray"]
    assert figures.css_color_property(made_up) == "--ds-neutral-gray"
    assert figures.css_color_property(ds.PROTOCOLS["Zenoh router"]) == "--ds-product-rmw-zenoh"
