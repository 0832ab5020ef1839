"""Test the layout: fixed sidebar, heads and lines, and the parts that print leaves out."""

from pathlib import Path
from typing import Any

import pytest
from docutils import nodes
from playwright.sync_api import Browser
from test_pages import PAGE_TEXT, PAGES

printed = __import__("printed")
whole = __import__("whole")

DESK, PHONE = (1440, 900), (360, 800)
#: Returns which of some elements are in sight, with nothing over them.
SEEN = """(selector) => [...document.querySelectorAll(selector)].map((element) => {
    const { left, top, width, height } = element.getBoundingClientRect();
    const found = document.elementFromPoint(left + width / 2, top + height / 2);
    return element === found || element.contains(found);
})"""
#: Returns by how much hints at sideways scrolling reach into what scrolls [px].
COVERED_HINTS = """[...document.querySelectorAll(".ds-scroll-hint")].map((hint) => {
    const after = hint.nextElementSibling;
    const box = after.matches(".ds-wider") ? after : after.querySelector(".ds-wider");
    return hint.getBoundingClientRect().bottom - box.getBoundingClientRect().top;
})"""
#: Sums up by how much what is seen moves while a page comes.
MOVED = """
    window.moved = 0;
    new PerformanceObserver((list) => {
        for (const entry of list.getEntries()) window.moved += entry.value;
    }).observe({ type: "layout-shift", buffered: true });
"""


#: Chapters of text, code, equations and figures. (Scripts fill the calculator, and formulas the
#: tables of the notation, so that these move.)
MIXED = [page for page in PAGES if page.split("/")[-1][:2] in {"01", "03", "05", "12", "14"}]


@pytest.mark.book
@pytest.mark.parametrize("size", [DESK, PHONE], ids=["desk", "phone"])
def test_pages_hardly_move_while_they_come(
    browser: Browser, options: dict[str, Any], book: Path, size: tuple[int, int]
) -> None:
    moved = {}
    # A browser that has shown nothing yet, and so has no font.
    cold = browser.browser_type.launch(**options)
    with cold, cold.new_page(viewport={"width": size[0], "height": size[1]}) as page:
        page.add_init_script(MOVED)
        for name in MIXED:
            page.goto((book / f"{name}.html").as_uri())
            page.evaluate(PAGE_TEXT)
            moved[name] = page.evaluate("window.moved")
    # What Google's "Core Web Vitals" call good is 0.1.
    assert {name: by for name, by in moved.items() if by >= 0.1} == {}


#: As many as a reader gets through at a sitting.
MOST_SCREENS = 10
CHAPTERS = [page for page in PAGES if "01" <= page.split("/")[-1][:2] <= "15"]


@pytest.mark.book
def test_a_chapter_has_ten_screens_at_most(browser: Browser, book: Path) -> None:
    assert len(CHAPTERS) == 17
    screens = {}
    with browser.new_page(viewport={"width": DESK[0], "height": DESK[1]}) as page:
        for name in CHAPTERS:
            page.goto((book / f"{name}.html").as_uri())
            page.evaluate(PAGE_TEXT)
            screens[name] = page.evaluate("document.documentElement.scrollHeight") / DESK[1]
    assert {name: long for name, long in screens.items() if long > MOST_SCREENS} == {}


@pytest.mark.book
def test_search_the_first_links_and_the_page_itself_are_in_sight(
    browser: Browser, book: Path
) -> None:
    with browser.new_page(viewport={"width": DESK[0], "height": DESK[1]}) as page:
        for name in PAGES:
            page.goto((book / f"{name}.html").as_uri())
            page.evaluate(PAGE_TEXT)
            first = ".bd-sidebar-primary .bd-sidenav__home-link + ul a"
            assert page.evaluate(SEEN, ".bd-sidebar-primary .search-button-field") == [True]
            assert page.evaluate(SEEN, first) == [True] * 4, name
            if name != "book/index":
                assert page.evaluate(SEEN, ".bd-sidebar-primary .active > a.current") == [True], (
                    name
                )


@pytest.mark.book
def test_nothing_is_seen_above_the_head_of_the_ledger(browser: Browser, book: Path) -> None:
    with browser.new_page(viewport={"width": DESK[0], "height": DESK[1]}) as page:
        page.goto((book / "notebooks/16_ledger.html").as_uri())
        page.evaluate(PAGE_TEXT)
        page.evaluate(
            "document.querySelector('.tag_ledger tbody tr:nth-child(9)').scrollIntoView()"
        )
        page.mouse.wheel(0, 120)
        head = page.locator(".tag_ledger thead th").nth(3)
        # From above the bar to below the cell's own upper edge, without a gap.
        top, bottom, height = head.evaluate(
            "(cell) => [getComputedStyle(cell, '::before'), cell].flatMap((of) =>"
            " of === cell ? [cell.clientHeight] : [parseFloat(of.top), parseFloat(of.bottom)])"
        )
        assert top < -50
        assert bottom < height
        # Scrolling takes its time.
        page.wait_for_function(
            "(cell) => 40 < cell.getBoundingClientRect().y && cell.getBoundingClientRect().y < 56",
            arg=head.element_handle(),
        )


@pytest.mark.book
def test_one_switch_for_all_code_on_a_phone_too(browser: Browser, book: Path) -> None:
    with browser.new_page(viewport={"width": PHONE[0], "height": PHONE[1]}) as page:
        page.goto((book / "notebooks/03_hosts.html").as_uri())
        folded = page.locator("div.cell.tag_hide-input > details.hide.above-input")
        assert not folded.first.is_visible()
        page.get_by_role("button", name="All code").click()
        assert folded.first.locator("pre").is_visible()


@pytest.mark.book
@pytest.mark.parametrize("name", ["03_hosts", "15b_what_to_change"])
def test_hints_stand_above_what_scrolls_also_in_folds(
    browser: Browser, book: Path, name: str
) -> None:
    with browser.new_page(viewport={"width": PHONE[0], "height": PHONE[1]}) as page:
        page.goto((book / f"notebooks/{name}.html").as_uri())
        page.evaluate(PAGE_TEXT)
        page.evaluate("for (const fold of document.querySelectorAll('details')) fold.open = true")
        page.locator("details.hide .ds-scroll-hint").first.wait_for()
        covered = page.evaluate(COVERED_HINTS)
    assert covered
    assert max(covered) < 1


def test_a_number_stays_with_its_unit() -> None:
    paragraph = nodes.paragraph("", "In 2.4 s, 1,024 kB over 10 hosts; 5 such sets of Fig. 2.")
    whole._keep(paragraph[0])
    kept = [part.astext() for part in paragraph if isinstance(part, nodes.inline)]
    assert kept == ["2.4 s", "1,024 kB", "Fig. 2"]


def cell(*shown: nodes.Node, mode: str = "all") -> nodes.container:
    source = nodes.container("", nodes.literal_block("", "code"), nb_element="cell_code_source")
    output = nodes.container("", *shown, nb_element="cell_code_output")
    return nodes.container("", source, output, nb_element="cell_code", hide_mode=mode, classes=[])


def test_the_print_leaves_out_tables_in_folds_but_no_figure_and_nothing_announced() -> None:
    folded, drawn, announced = (
        cell(nodes.paragraph("", text)) for text in ("folded", "drawn", "announced")
    )
    drawn.children[1] += nodes.figure("", nodes.image())
    code = cell(nodes.paragraph("", "open"), mode="input")
    chapter = nodes.section(
        "",
        folded,
        nodes.paragraph("", "Text."),
        drawn,
        code,
        nodes.paragraph("", "See:"),
        announced,
    )
    printed._leave_out_what_is_folded(chapter)
    said = chapter.astext()
    assert "folded" not in said
    assert "code" not in said
    for kept in ("drawn", "open", "announced"):
        assert kept in said
