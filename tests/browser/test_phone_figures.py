"""Figures for phones, files to save, and how to cite a figure: as drawn and as on the page."""

import json
import re
from collections.abc import Callable, Iterator
from itertools import pairwise
from pathlib import Path

import pytest
from matplotlib.figure import Figure
from playwright.sync_api import Browser, Page
from support import ROOT
from test_pages import PAGE_TEXT, PAGES

import discostorm as ds
from discostorm import figures
from discostorm_book import phone_figures
from discostorm_book.figures import any_wifi, change, paper_part, proposal, servers
from discostorm_book.show import PHONE_KEY

pictures = __import__("pictures")

NOTEBOOKS = sorted((ROOT / "notebooks").glob("*.ipynb"))
#: Pixels of a phone's screen, and of letters of 9 points that can be read on it.
SCREEN, LETTERS = 360, 10


def panels(figure: Figure) -> list[tuple[float, float]]:
    """Return where the panels of a figure begin: from the left and from below."""
    with figures.style():
        figure.draw_without_rendering()
    places = [axis.get_position() for axis in figure.axes]
    return [(round(box.x0, 2), round(box.y0, 3)) for box in places]


def test_panels_come_one_below_the_other_and_nothing_runs_off() -> None:
    drawn = any_wifi.saturation_by_aggregation()
    (left, right), wide = panels(drawn), drawn.get_size_inches()[0]
    assert left[1] == right[1]
    narrow = phone_figures.adapt_for_phone(drawn)
    assert narrow is drawn
    assert narrow.get_size_inches()[0] == phone_figures.PHONE_WIDTH < wide
    above, below = panels(narrow)
    assert above[0] == pytest.approx(below[0], abs=0.02)
    assert above[1] > below[1]
    assert narrow.axes[1].get_ylabel() == narrow.axes[0].get_ylabel() != ""
    for text in (narrow._suptitle, *narrow.axes[0].texts):  # type: ignore[attr-defined]
        box = text.get_window_extent()
        assert 0 <= box.x0 < box.x1 <= narrow.bbox.width + 1


#: Drawings with words at the right ends of curves and bars.
WORDY: dict[str, Callable[[], Figure]] = {
    "fig2": figures.fig2,
    "fig3": figures.fig3,
    "fig4": figures.fig4,
    "ladder": proposal.airtime_steps,
    "servers": servers.robots_by_configuration,
}


@pytest.mark.parametrize("name", WORDY)
def test_words_at_the_ends_of_curves_are_whole_on_a_phone(name: str) -> None:
    narrow = phone_figures.adapt_for_phone(WORDY[name]())
    with figures.style():
        narrow.draw_without_rendering()
    for text in (text for axis in narrow.axes for text in axis.texts):
        box = text.get_window_extent()
        assert -1 <= box.x0 < box.x1 <= narrow.bbox.width + 1, text.get_text()


def test_a_legend_that_would_hide_its_panel_goes_below() -> None:
    narrow = phone_figures.adapt_for_phone(paper_part.frame_parts())
    assert narrow.axes[0].get_legend() is None
    (legend,) = narrow.legends
    assert legend.get_window_extent().y1 < narrow.axes[0].bbox.y0


def test_long_names_of_rows_are_broken_and_have_room() -> None:
    plan = ds.plan(ds.Fleet.swarm(3, 8, 5))
    narrow = phone_figures.adapt_for_phone(change.times_by_change(plan, "Some title"))
    names = [tick.label1 for tick in narrow.axes[0].yaxis.get_major_ticks()]
    assert any("\n" in name.get_text() for name in names)
    boxes = [name.get_window_extent() for name in names if name.get_text()]
    assert all(box.x0 >= -1 for box in boxes)
    boxes.sort(key=lambda box: box.y0)
    assert all(a.y1 <= b.y0 for a, b in pairwise(boxes))


def drawn_in_notebooks() -> Iterator[tuple[str, str]]:
    """Yield the name of each figure that code draws, and its picture for phones."""
    for path in NOTEBOOKS:
        for cell in json.loads(path.read_text(encoding="utf-8"))["cells"]:
            name = cell["metadata"].get("mystnb", {}).get("figure", {}).get("name")
            if name and not "".join(cell["source"]).startswith("show.drawing("):
                (beside,) = (o["metadata"] for o in cell["outputs"] if "image/svg+xml" in o["data"])
                yield name, beside["image/svg+xml"][PHONE_KEY]


DRAWN = dict(drawn_in_notebooks())


def test_every_figure_has_a_picture_for_phones_whose_letters_can_be_read() -> None:
    assert len(DRAWN) > 30
    for name, svg in DRAWN.items():
        width = float(re.findall(r'width="(\d+)"', pictures._size(svg))[0])
        assert width * LETTERS / 12 <= SCREEN, name


def test_a_picture_says_how_large_it_is() -> None:
    assert pictures._size('<svg height="72pt" width="36pt">') == 'width="48" height="96"'
    assert pictures._size('<svg width="36" height="7.4">') == 'width="36" height="7"'
    with pytest.raises(ValueError, match="says not how large"):
        pictures._size("<svg>")


@pytest.fixture(scope="module")
def phone(browser: Browser) -> Iterator[Page]:
    with browser.new_page(viewport={"width": SCREEN, "height": 800}) as tab:
        yield tab


#: Returns what is drawn of each figure, and the names of those that scroll.
SHOWN = """() => {
    const images = [...document.querySelectorAll(".bd-article figure img")];
    const boxes = [...document.querySelectorAll(".ds-figure")];
    return [
        images.map((image) => decodeURI(image.currentSrc).split("/").at(-1)),
        boxes.filter((box) => box.scrollWidth > box.clientWidth + 1).length,
        images.every((image) => image.hasAttribute("width") && image.hasAttribute("height")),
    ];
}"""


@pytest.mark.book
@pytest.mark.parametrize("page", PAGES)
def test_no_figure_scrolls_on_a_phone(phone: Page, book: Path, page: str) -> None:
    phone.goto((book / f"{page}.html").as_uri())
    phone.evaluate(PAGE_TEXT)
    files, scroll, sized = phone.evaluate(SHOWN)
    assert scroll == 0
    assert sized
    shown = {file.removesuffix("-narrow.svg") for file in files if "-narrow" in file}
    kept = {name for name in DRAWN if f'id="{name}"' in phone.content()}
    # A page in Markdown draws its figures when it is built.
    drawn = {"book/index": "fig-landing", "book/reuse": "fig-own-protocol"}
    assert shown == kept or drawn.get(page) in shown


@pytest.mark.book
def test_a_figure_is_saved_and_cited_from_a_file(browser: Browser, book: Path) -> None:
    with browser.new_page() as tab:
        tab.goto((book / "notebooks/03_hosts.html").as_uri())
        tools = tab.locator("#fig-paper-2 .ds-tools")
        for kind, start in (("PNG", b"\x89PNG"), ("SVG", b"<?xml")):
            with tab.expect_download() as saved:
                tools.get_by_text(kind, exact=True).click()
            assert saved.value.suggested_filename == f"fig-paper-2.{kind.lower()}"
            assert Path(saved.value.path()).read_bytes().startswith(start)
        cited = tools.locator("details > p")
        assert not cited.is_visible()
        tools.get_by_text("Cite this figure").click()
        text = cited.inner_text()
        for part in ("Fig. 2", "More hosts", ds.__version__, "03_hosts.html#fig-paper-2", "CC BY"):
            assert part in text
        assert "<" not in text


@pytest.mark.book
def test_a_figure_can_be_saved_and_cited_without_scripts(browser: Browser, book: Path) -> None:
    with browser.new_context(java_script_enabled=False) as context:
        tab = context.new_page()
        tab.goto((book / "notebooks/03_hosts.html").as_uri())
        tools = tab.locator("#fig-paper-2 .ds-tools")
        address = tools.locator("a").get_attribute("href")
        assert address
        assert (book / "notebooks" / address).resolve().is_file()
        assert not tools.get_by_text("PNG", exact=True).is_visible()
        tools.get_by_text("Cite this figure").click()
        assert tools.locator("details > p").is_visible()
