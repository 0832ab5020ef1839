"""Every page of the book as a browser shows it: over http and straight from the file system.

Each page is visited from the file system, and one of each kind over http; what was seen there is
what the tests look at. Its tests run in one process, see conftest.py.
"""

import csv
import functools
import hashlib
import io
import json
import re
import tarfile
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal
from urllib.parse import unquote, urlsplit

import numpy as np
import pytest
import yaml
from PIL import Image, ImageColor
from playwright.sync_api import Browser, Page, ViewportSize
from support import HELPERS, REFERENCE, ROOT

from discostorm import figures
from discostorm.palette import PALETTE

pytestmark = pytest.mark.book

TOC = ROOT / "_toc.yml"

PHONE: ViewportSize = {"width": 390, "height": 800}
DESKTOP: ViewportSize = {"width": 1280, "height": 800}

#: Waits until a page has come to rest.
PAGE_TEXT = (HELPERS / "page_text.js").read_text(encoding="utf-8")
#: Returns what is to be seen on it.
FACTS = (HELPERS / "page_facts.js").read_text(encoding="utf-8")

#: axe-core by Deque Systems, MPL-2.0, as npm has it.
AXE = (REFERENCE / "vendor" / "axe-core-4.14.1.min.js").read_text(encoding="utf-8")
#: What is serious or critical. Without preload it fetches nothing itself, and with noHtml it
#: writes out no element, such as the whole page, that is all right.
BARRIERS = """(rules) => {
    axe.configure({ noHtml: true });
    const html = (target) => document.querySelector(target)?.outerHTML.slice(0, 160);
    return axe
        .run(document, {resultTypes: ["violations"], preload: false, ...rules})
        .then(({violations}) => violations
            .filter(({impact}) => ["serious", "critical"].includes(impact))
            .flatMap(({id, impact, nodes}) => nodes.map(({target, failureSummary}) =>
                `${impact} ${id}: ${target.join(" ")} ${html(target[0])} ${failureSummary}`)));
}"""
#: Returns how much of the height of the article is code that is not folded.
CODE_SHARE = """() => {
    const article = document.querySelector(".bd-article");
    if (!article) return 0;
    const height = (element) => element.getBoundingClientRect().height;
    const code = [...article.querySelectorAll(".cell_input")]
        .filter((element) => element.checkVisibility());
    const sum = code.map(height).reduce((sum, one) => sum + one, 0);
    return sum / height(article);
}"""
#: Unfolds what is folded.
OPEN = "document.querySelectorAll('details').forEach((details) => { details.open = true })"
#: Leaves one text of each look, as axe-core judges every element for itself, and three formulas.
#: Links, buttons and heads of tables keep theirs, by which they are named.
ONE_OF_EACH_LOOK = """() => {
    const texts = ":is(p, span, td, li, strong, em):not(a *, button *, summary *, label *, th *)";
    const grounds = new Map([[null, ""]]);
    const ground = (element) => {
        if (!grounds.has(element)) {
            const own = getComputedStyle(element).backgroundColor;
            grounds.set(element, own + ground(element.parentElement));
        }
        return grounds.get(element);
    };
    const seen = new Set();
    const again = []; // taken out at the end, as each change has the page styled anew
    for (const element of document.querySelectorAll(`.bd-article ${texts}`)) {
        const own = [...element.childNodes].filter((node) => node.nodeType === Node.TEXT_NODE);
        if (!own.some((node) => node.data.trim())) continue;
        const { color, fontSize, fontWeight, opacity } = getComputedStyle(element);
        const look = [color, fontSize, fontWeight, opacity, ground(element)];
        const key = [...look, element.querySelector("a") !== null].join();
        const whole = element.matches("pre *") && element.childElementCount === 0;
        if (seen.has(key)) again.push(...(whole ? [element] : own));
        seen.add(key);
    }
    again.push(...[...document.querySelectorAll("mjx-container")].slice(3));
    again.forEach((node) => node.remove());
}"""
#: Waits until the page is as wide, and in the color scheme, as it is told.
FOLLOWED = """async ({ theme, width }) => {
    while (innerWidth !== width || document.documentElement.dataset.theme !== theme)
        await new Promise(requestAnimationFrame);
}"""
#: Returns where the results of a search on the first screen lead and what is marked in them.
RESULTS = """() => [...document.querySelectorAll("#search-results li")]
    .filter((item) => {
        const box = item.getBoundingClientRect();
        return item.checkVisibility() && box.height > 0 && box.bottom <= innerHeight;
    })
    .map((item) => [
        item.querySelector("a").getAttribute("href"),
        [...item.querySelectorAll("mark")].map((mark) => mark.innerText),
    ])"""
COLORS = {"runOnly": ["color-contrast", "link-in-text-block"]}


def toc_files(part: Any) -> Iterator[str]:
    """Yield the pages of the table of contents, without their suffix."""
    if isinstance(part, list):
        for item in part:
            yield from toc_files(item)
    elif isinstance(part, dict):
        yield from (part[key] for key in ("root", "file") if key in part)
        yield from toc_files([part[key] for key in part.keys() & {"parts", "chapters", "sections"}])


STATIC = ROOT / "book" / "_static"
with (STATIC / "vendored.csv").open(encoding="utf-8", newline="") as _file:
    VENDORED = list(csv.DictReader(_file))

PAGES = sorted(toc_files(yaml.safe_load(TOC.read_text(encoding="utf-8"))))


@dataclass
class Visit:
    """Requests and errors of a page."""

    base: str
    requests: list[str] = field(default_factory=list)
    errors: list[str] = field(default_factory=list)
    phone: dict[str, Any] = field(default_factory=dict)  # in light mode
    desktop: dict[str, Any] = field(default_factory=dict)  # in dark mode
    barriers: dict[str, list[str]] = field(default_factory=dict)  # by color scheme
    code_share: float = 0.0  # as the page comes, on a desktop


def listen(tab: Page, visits: list[Visit]) -> None:
    """Record the requests and errors of a tab in the last of the visits."""

    def wrong(what: str) -> None:
        visits[-1].errors.append(what)

    tab.on("request", lambda request: visits[-1].requests.append(request.url))
    tab.on("requestfailed", lambda request: wrong(f"failed: {request.url}"))
    tab.on("pageerror", lambda error: wrong(f"uncaught: {error}"))
    tab.on(
        "response",
        lambda answer: wrong(f"{answer.status}: {answer.url}") if answer.status >= 400 else None,
    )
    tab.on("console", lambda line: wrong(f"console: {line.text}") if line.type == "error" else None)


def show(tab: Page, theme: Literal["light", "dark"], size: ViewportSize) -> None:
    """Show the page in another color scheme and size, and wait until it has followed."""
    tab.emulate_media(color_scheme=theme)
    tab.set_viewport_size(size)
    tab.evaluate(FOLLOWED, {"theme": theme, "width": size["width"]})
    tab.evaluate(PAGE_TEXT)


def look(tab: Page, visit: Visit, page: str) -> None:
    """Visit a page as on a phone in light mode; if from a file, first as on a desktop in dark mode.

    Once is enough for that, and for axe-core: how a page came does not change what it looks like.
    """
    if not visit.base.startswith("file:"):
        tab.goto(f"{visit.base}{page}.html")
        tab.evaluate(PAGE_TEXT)
        visit.phone = tab.evaluate(FACTS)
        return
    tab.emulate_media(color_scheme="dark")
    tab.set_viewport_size(DESKTOP)
    tab.goto(f"{visit.base}{page}.html")
    tab.evaluate(PAGE_TEXT)
    visit.code_share = tab.evaluate(CODE_SHARE)
    tab.evaluate(OPEN)
    tab.evaluate(PAGE_TEXT)
    visit.desktop = tab.evaluate(FACTS)
    show(tab, "light", PHONE)
    visit.phone = tab.evaluate(FACTS)
    tab.evaluate(AXE)
    tab.evaluate(ONE_OF_EACH_LOOK)
    visit.barriers["light"] = tab.evaluate(BARRIERS, COLORS)  # the others see no colors
    show(tab, "dark", DESKTOP)
    visit.barriers["dark"] = tab.evaluate(BARRIERS, {})


Visitor = Callable[[str, str], Visit]


@pytest.fixture(scope="module")
def visitor(browser: Browser, book: Path, server: str) -> Iterator[Visitor]:
    """Return a function that visits a page by http or file, once.

    All pages come in the same tab, so that Chromium compiles their scripts once.
    """
    bases = {"http": server, "file": book.as_uri() + "/"}
    with browser.new_context(
        viewport=PHONE,
        color_scheme="light",
        reduced_motion="reduce",  # else colors are caught halfway from light to dark
    ) as context:
        tabs = {by: context.new_page() for by in bases}
        visits: dict[str, list[Visit]] = {by: [] for by in bases}
        for by, tab in tabs.items():
            listen(tab, visits[by])

        @functools.cache
        def visitor(page: str, by: str) -> Visit:
            visits[by].append(Visit(bases[by]))
            look(tabs[by], visits[by][-1], page)
            return visits[by][-1]

        yield visitor


@pytest.fixture(scope="module")
def desk(browser: Browser) -> Iterator[tuple[Page, list[Visit]]]:
    """Return a desktop tab, the same for all tests, and its visits."""
    with browser.new_page(viewport=DESKTOP, reduced_motion="reduce") as tab:
        visits: list[Visit] = []
        listen(tab, visits)
        yield tab, visits


@pytest.fixture
def visit(visitor: Visitor, page: str, by: str) -> Visit:
    return visitor(page, by)


every_page = pytest.mark.parametrize("page", [*PAGES, "search"])
both_ways = pytest.mark.parametrize("by", ["http", "file"])
#: Of those that come by http, too, one of each kind: all are the same files with the same scripts.
KINDS = ("book/index", "book/calculator", "notebooks/03_hosts", "notebooks/16_ledger", "search")
EACH = [*((page, "file") for page in [*PAGES, "search"]), *((page, "http") for page in KINDS)]
each_visit = pytest.mark.parametrize(("page", "by"), EACH)
each_chapter = pytest.mark.parametrize(
    ("page", "by"), [(page, by) for page, by in EACH if page != "search"]
)


@each_visit
def test_nothing_is_requested_from_elsewhere(visit: Visit) -> None:
    elsewhere = [
        url for url in visit.requests if not url.startswith((visit.base, "data:", "blob:"))
    ]
    assert not elsewhere
    assert len(visit.requests) > 10  # else nobody listened


@each_visit
def test_nothing_goes_wrong(visit: Visit) -> None:
    assert not visit.errors


def source(page: str) -> tuple[str, set[str]]:
    """Return the prose of a page as written and the names of the figures it should show."""
    notebook = ROOT / f"{page}.ipynb"
    if not notebook.exists():
        text = (ROOT / f"{page}.md").read_text(encoding="utf-8")
        return text, set(re.findall(r"name: (fig-[\w-]+)", text))
    cells = json.loads(notebook.read_text(encoding="utf-8"))["cells"]
    prose = "\n".join("".join(c["source"]) for c in cells if c["cell_type"] == "markdown")
    figures = (cell["metadata"].get("mystnb", {}).get("figure", {}).get("name") for cell in cells)
    return prose, set(filter(None, figures)) | set(re.findall(r"name: (fig-[\w-]+)", prose))


@each_chapter
def test_mathematics_is_rendered(visit: Visit, page: str) -> None:
    prose, _ = source(page)
    if re.search(r"\$\S[^$`]*\$", prose):
        assert visit.phone["formulas"] > 0
    assert not visit.phone["broken_formulas"]
    assert not visit.phone["raw_tex"]


@every_page
def test_formulas_and_the_letters_of_figures_can_be_read_on_a_phone(
    visitor: Visitor, page: str
) -> None:
    phone = visitor(page, "file").phone
    assert not phone["formulas_that_scroll"]
    assert min(phone["letters_of_figures"], default=10) > 9.5


@each_chapter
def test_figures_are_there_and_described(visit: Visit, page: str) -> None:
    _, expected = source(page)
    assert expected <= set(visit.phone["figures"])
    assert not visit.phone["images_not_loaded"]
    assert not visit.phone["images_without_alt"]


@each_visit
def test_the_page_fits_a_phone(visit: Visit) -> None:
    assert visit.phone["width"] == PHONE["width"]
    assert not visit.phone["clipped"]
    assert not visit.phone["not_focusable"]


@every_page
def test_the_page_fits_a_desktop(visitor: Visitor, page: str) -> None:
    visit = visitor(page, "file")
    assert visit.desktop["width"] == DESKTOP["width"]
    assert not visit.desktop["clipped"]
    assert not visit.desktop["code_that_scrolls"]


@every_page
def test_there_is_a_dark_mode(visitor: Visitor, page: str) -> None:
    visit = visitor(page, "file")
    assert (visit.phone["theme"], visit.desktop["theme"]) == ("light", "dark")
    assert not visit.desktop["images_on_dark"]


def test_figures_in_dark_mode_are_no_slabs_and_have_the_dark_colors(
    desk: tuple[Page, list[Visit]], book: Path
) -> None:
    chapter = next(page for page in PAGES if page.endswith("_hosts"))
    pixels = {}
    tab, visits = desk
    visits.append(Visit(book.as_uri() + "/"))
    tab.goto(f"{visits[-1].base}{chapter}.html")
    themes: tuple[Literal["light", "dark"], ...] = ("light", "dark")
    for theme in themes:
        show(tab, theme, DESKTOP)
        picture = tab.locator("#fig-paper-2 img").screenshot()
        pixels[theme] = Image.open(io.BytesIO(picture)).convert("RGB")
        ground = tab.evaluate("getComputedStyle(document.body).backgroundColor")
        corner = pixels[theme].getpixel((2, 2))
        assert corner == tuple(map(int, re.findall(r"\d+", ground)))
    for name in ("DDS", "Zenoh"):
        drawn = ImageColor.getrgb(figures.COLORS[name])
        before, after = (np.asarray(pixels[theme]) for theme in ("light", "dark"))
        shown = after[(before == drawn).all(axis=2)].astype(int)
        assert len(shown)
        # A browser may round a channel of a scaled picture.
        assert np.abs(shown - ImageColor.getrgb(PALETTE["family", name].dark)).max() <= 1


@every_page
def test_nothing_serious_keeps_anyone_out(visitor: Visitor, page: str) -> None:
    assert visitor(page, "file").barriers == {"dark": [], "light": []}


@pytest.mark.parametrize("rules", [{}, COLORS], ids=["all", "colors"])
def test_a_barrier_is_found(browser: Browser, rules: dict[str, list[str]]) -> None:
    faint = "<p style='color: #aaa; background: white'>faint</p>"
    with browser.new_page() as tab:
        tab.set_content(
            f"<html lang='en'><title>x</title><main><h1>x</h1><button></button>{faint}</main>"
        )
        tab.evaluate(AXE)
        found = [line.split(":")[0] for line in tab.evaluate(BARRIERS, rules)]
    assert found == [*([] if rules else ["critical button-name"]), "serious color-contrast"]


@every_page
def test_links_within_the_book_lead_somewhere(visitor: Visitor, page: str, book: Path) -> None:
    visit = visitor(page, "file")
    paths = {unquote(urlsplit(link).path) for link in visit.phone["links"]}
    assert paths
    assert not [path for path in paths if not Path(path).is_file()]
    assert not [path for path in paths if not Path(path).is_relative_to(book)]


@both_ways
def test_the_front_door_opens(browser: Browser, book: Path, server: str, by: str) -> None:
    with browser.new_context() as context:
        tab = context.new_page()
        tab.goto((server if by == "http" else book.as_uri() + "/") + "index.html")
        tab.wait_for_url("**/book/index.html")


@both_ways
@pytest.mark.parametrize(
    ("query", "found"),
    [
        ("how many robots", "book/index.html#how-many-robots-fit"),
        ("staggered start", "12_convergence.html"),
        ("discovery server", "14_servers.html"),
        ("wifi multicast", "08_any_wifi.html#multicast-rate-and-band-change-little"),
        ("zenoh router", "14_servers.html"),
        ("CycloneDDS peers", "14_servers.html"),
        ("lease", "07_what_100_percent_means.html"),
        ("saturation_hosts", "notebooks/"),
    ],
)
def test_search_shows_on_the_first_screen(
    desk: tuple[Page, list[Visit]], book: Path, server: str, by: str, query: str, found: str
) -> None:
    tab, visits = desk
    visits.append(visit := Visit(server if by == "http" else book.as_uri() + "/"))
    tab.goto(f"{visit.base}search.html?q={query}")
    tab.locator("#search-results li").first.wait_for()
    results = tab.evaluate(RESULTS)
    tab.evaluate(PAGE_TEXT)
    assert not visit.errors
    assert [marked for href, marked in results if found in href and marked]


def test_search_reads_what_pages_show_and_not_what_python_calls_it(book: Path) -> None:
    text = (book / "_static" / "search" / "sections.js").read_text(encoding="utf-8")
    sections = json.loads(text.removeprefix("window.SECTIONS = ").rstrip(";\n"))
    assert {section["url"].split("#")[0] for section in sections} == {f"{p}.html" for p in PAGES}
    # Python's names of what is shown are left out, what is shown is not.
    assert not [s["url"] for s in sections if re.search(r"<(Figure|[\w.]+ object)", s["text"])]
    answer = re.compile(r"The answer\. |In short\. ")
    answered = {s["url"].split(".html")[0] for s in sections if answer.search(s["text"])}
    assert answered == {page for page in PAGES if (ROOT / f"{page}.ipynb").exists()}


def test_search_for_what_is_not_there_says_so(desk: tuple[Page, list[Visit]], book: Path) -> None:
    tab, visits = desk
    visits.append(Visit(book.as_uri() + "/"))
    tab.goto(f"{visits[-1].base}search.html?q=xyzzy")
    assert "Nothing found for “xyzzy”" in tab.locator("#search-count").inner_text()


@every_page
def test_every_page_leads_to_installation_and_source(visitor: Visitor, page: str) -> None:
    links = visitor(page, "file").phone["links"]
    assert [link for link in links if link.endswith("#install")]
    assert [link for link in links if link.endswith("-source.tar.xz")]


def test_the_source_that_is_served_is_all_of_it(book: Path) -> None:
    (path,) = book.glob("*-source.tar.xz")
    with tarfile.open(path) as archive:
        held = {name.split("/", 1)[1]: archive.getmember(name) for name in archive.getnames()}
    assert {"README.md", "Makefile", "discostorm/__init__.py", ".ci/run"} <= held.keys()
    assert held[".ci/run"].mode == 0o755
    assert not [name for name in held if name.startswith((".git/", ".venv", "_build", "build/"))]


@pytest.mark.parametrize("row", VENDORED, ids=lambda row: row["file"])
def test_what_comes_from_elsewhere_is_as_it_came(row: dict[str, str]) -> None:
    content = (STATIC / row["file"]).read_bytes()
    assert hashlib.sha256(content).hexdigest() == row["sha256"]
    assert (STATIC / row["license_file"]).is_file()


def test_every_page_is_in_the_contents(book: Path) -> None:
    built = {path.relative_to(book).with_suffix("").as_posix() for path in book.rglob("*.html")}
    built = {page for page in built if not page.startswith("_static")}
    assert built == {*PAGES, "search", "index"}
