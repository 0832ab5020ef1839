"""No page of the book breaks a serious or critical rule of axe-core, light and dark."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page
from test_browser import DESKTOP, FACTS, PAGES

#: axe-core by Deque Systems, MPL-2.0, as npm has it.
AXE = Path(__file__).parent / "vendor" / "axe-core-4.14.1.min.js"

RUN = """() => axe.run(document, {resultTypes: ["violations"]})
    .then(({violations}) => violations
        .filter(({impact}) => ["serious", "critical"].includes(impact))
        .flatMap(({id, impact, nodes}) => nodes.map(({html, target, failureSummary}) =>
            `${impact} ${id}: ${target.join(" ")} ${html.slice(0, 160)} ${failureSummary}`)))"""


@pytest.fixture(scope="module")
def tab(browser: Browser) -> Iterator[Page]:
    """Return a tab in which a page has axe-core with it."""
    with browser.new_context(viewport=DESKTOP, reduced_motion="reduce", bypass_csp=True) as context:
        context.add_init_script(path=AXE)
        yield context.new_page()


@pytest.mark.parametrize("page", [*PAGES, "search"])
def test_nothing_serious_keeps_anyone_out(tab: Page, book: Path, page: str) -> None:
    found: dict[str, list[str]] = {}
    tab.emulate_media(color_scheme="light")
    tab.goto(f"{book.as_uri()}/{page}.html")
    tab.evaluate("for (const folded of document.querySelectorAll('details')) folded.open = true")
    for theme in ("light", "dark"):
        tab.emulate_media(color_scheme=theme)
        assert tab.evaluate(FACTS)["theme"] == theme  # waits until the page rests
        found[theme] = tab.evaluate(RUN)
    assert found == {"light": [], "dark": []}


def test_a_fault_is_found(tab: Page) -> None:
    tab.set_content("<html lang='en'><title>x</title><main><h1>x</h1><button></button></main>")
    tab.add_script_tag(path=AXE)
    assert [line.split(":")[0] for line in tab.evaluate(RUN)] == ["critical button-name"]
