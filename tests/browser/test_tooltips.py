"""Test previews of link targets, under the pointer and at the keyboard's focus."""

import json
import re
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Locator, Page, expect
from test_interactive_figures import THEMES
from test_pages import AXE, BARRIERS, DESKTOP, show

pytestmark = pytest.mark.book

PAGE = "notebooks/22_checks.html"
#: The links of that page to an equation and to a chapter.
EQUATION = "a.reference.internal[href$='#equation-eq-saturation']"
CHAPTER = "a.reference.internal[href*='message-to-airtime']"


@pytest.fixture(scope="module")
def index(book: Path) -> dict[str, Any]:
    text = (book / "_static" / "hover-index.js").read_text(encoding="utf-8")
    found: dict[str, Any] = json.loads(text.removeprefix("const HOVER_INDEX = ").strip().strip(";"))
    return found


@pytest.fixture
def tab(open_tab: Callable[..., AbstractContextManager[Page]], book: Path) -> Iterator[Page]:
    with open_tab((book / PAGE).as_uri(), DESKTOP) as page:
        page.wait_for_function("window.MathJax?.typesetPromise")
        yield page


def tip(tab: Page) -> Locator:
    return tab.locator("#ds-hover")


def focus(link: Locator) -> None:
    """Come to a link by the keyboard, as a browser shows a focus only then."""
    link.page.keyboard.press("Tab")
    link.focus()


def test_the_index_leads_to_places_of_the_book(book: Path, index: dict[str, Any]) -> None:
    kinds = {"tex": 0, "image": 0, "text": 0}
    pages: dict[str, str] = {}
    for address, shown in index.items():
        page, _, anchor = address.partition("#")
        text = pages.setdefault(page, (book / page).read_text(encoding="utf-8"))
        assert not anchor or f'id="{anchor}"' in text, address
        for kind in kinds:
            kinds[kind] += kind in shown
        assert "image" not in shown or (book / shown["image"]).exists(), address
    assert kinds["tex"] > 40
    assert kinds["image"] > 30
    assert sum("The question." in shown.get("text", "") for shown in index.values()) > 20
    linked = re.findall(r'class="reference internal" href="#?([^"]*equation-[^"]*)"', pages[PAGE])
    assert len(linked) >= 3


def test_the_keyboard_shows_and_escape_closes(tab: Page) -> None:
    link = tab.locator(EQUATION).first
    focus(link)
    expect(tip(tab)).to_be_visible()
    expect(tip(tab)).to_contain_text(f"Equation {link.inner_text()}")
    drawn = tip(tab).locator("mjx-container > svg > g")
    assert drawn.evaluate("(formula) => formula.getBoundingClientRect().width") > 100
    page, shown = tab.locator("mjx-container path").first, tip(tab).locator("path, use").first
    color = "(element) => getComputedStyle(element).fill"
    assert shown.evaluate(color) == page.evaluate(color)
    assert link.get_attribute("aria-describedby") == "ds-hover"
    assert tip(tab).get_attribute("role") == "tooltip"
    tab.keyboard.press("Escape")
    expect(tip(tab)).to_be_hidden()
    assert link.get_attribute("aria-describedby") is None
    expect(link).to_be_focused()


def test_the_pointer_may_go_onto_it_and_leaving_closes_it(tab: Page) -> None:
    link = tab.locator(CHAPTER).first
    link.hover()
    expect(tip(tab)).to_contain_text("The question.")
    box = tip(tab).bounding_box()
    assert box is not None
    tab.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2, steps=5)
    tab.wait_for_timeout(600)
    expect(tip(tab)).to_be_visible()
    tab.mouse.move(5, 5, steps=5)
    expect(tip(tab)).to_be_hidden()


def test_a_figure_comes_into_sight_with_its_link(tab: Page, book: Path) -> None:
    tab.goto((book / "notebooks" / "03_hosts.html").as_uri())
    tab.wait_for_function("window.MathJax?.typesetPromise")
    focus(tab.locator("a.reference.internal[href='#fig-paper-2']").first)  # far below
    expect(tip(tab).locator("img")).to_be_visible()
    expect(tip(tab)).to_be_in_viewport(ratio=1)
    assert tip(tab).locator("img").evaluate("(image) => image.naturalWidth") > 100


def test_nothing_of_it_is_printed_or_keeps_anyone_out(tab: Page) -> None:
    tab.evaluate(AXE)
    for scheme, size in THEMES:
        show(tab, scheme, size)
        focus(tab.locator(CHAPTER).first)
        expect(tip(tab)).to_be_visible()
        barriers = BARRIERS.replace("document,", "document.querySelector('#ds-hover'),")
        assert tab.evaluate(barriers, {}) == []
        box = tip(tab).bounding_box()
        assert box is not None
        assert 0 <= box["x"] <= size["width"] - box["width"]
        tab.emulate_media(media="print")
        expect(tip(tab)).to_be_hidden()
        tab.emulate_media(media="screen", color_scheme=scheme)
        tab.evaluate("document.activeElement.blur()")
