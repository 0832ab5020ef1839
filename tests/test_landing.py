"""The first page in a browser that moves: the live storm, the ladder, and what links show."""

import functools
import re
import statistics
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, expect
from test_browser import AXE, BARRIERS, DESKTOP, PHONE

import discostorm as ds
from discostorm.book import ladder, storm

pytestmark = pytest.mark.book

#: Measures how long each frame's script takes [ms].
STOPWATCH = """
    window.took = [];
    const request = window.requestAnimationFrame.bind(window);
    window.requestAnimationFrame = (callback) => request((at) => {
        const start = performance.now();
        callback(at);
        window.took.push(performance.now() - start);
    });
"""


@pytest.fixture(scope="module")
def address(book: Path) -> str:
    return (book / "book" / "index.html").as_uri()


@pytest.fixture(scope="module")
def tab(browser: Browser, address: str) -> Iterator[Page]:
    errors: list[str] = []
    with browser.new_context(viewport=PHONE, color_scheme="light") as context:
        page = context.new_page()
        page.on("pageerror", lambda error: errors.append(str(error)))
        page.add_init_script(STOPWATCH)
        page.goto(address)
        yield page
    assert not errors


def choose(tab: Page, middleware: str, hosts: int, processes: int, endpoints: int) -> None:
    form = tab.locator("#storm-form")
    form.locator("[name=middleware]").select_option(middleware)
    form.locator("[name=processes]").select_option(str(processes))
    form.locator("[name=endpoints]").select_option(str(endpoints))
    form.locator("[name=hosts]").fill(str(hosts))


@pytest.mark.parametrize("swarm", [(7, 2, 10), (2, 1, 0), (12, 3, 20)])
@pytest.mark.parametrize("middleware", ["DDS", "Zenoh"])
def test_the_storm_has_the_packages_numbers(
    tab: Page, middleware: str, swarm: tuple[int, int, int]
) -> None:
    choose(tab, middleware, *swarm)
    protocol = ds.PROTOCOLS[middleware]
    many = sum(1 for _ in storm.messages(protocol, *swarm))
    used = ds.utilization(protocol, *swarm)
    told = tab.locator("#storm-sum")
    expect(told).to_contain_text(f"{many:,} messages, {used:.2f} s of airtime")
    expect(told).to_contain_text("it fits" if used < 1 else "more than the second")


def test_a_frame_leaves_time_to_spare_with_twelve_robots_on_a_phone(tab: Page) -> None:
    choose(tab, "DDS", 12, 3, 20)
    tab.locator("#storm-canvas").scroll_into_view_if_needed()
    tab.get_by_role("button", name="From the start").click()
    tab.wait_for_function("parseFloat(document.getElementById('storm-told').textContent) > 0")
    tab.evaluate("window.took.length = 0")
    tab.wait_for_function("window.took.length >= 60")
    # A sixtieth of a second is 16.7 ms; wall-clock frames depend on what else the machine does.
    assert statistics.median(tab.evaluate("window.took")) < 8


def test_the_storm_can_be_paused_and_played_by_keyboard(tab: Page) -> None:
    def told() -> str:
        return tab.locator("#storm-told").inner_text()

    choose(tab, "DDS", 7, 2, 10)
    tab.locator("#storm-pause").focus()
    tab.keyboard.press("Enter")
    expect(tab.locator("#storm-pause")).to_have_text("Play")
    before = told()
    tab.wait_for_timeout(400)
    assert told() == before
    tab.keyboard.press("Space")
    expect(tab.locator("#storm-pause")).to_have_text("Pause")
    tab.wait_for_function(
        "before => document.getElementById('storm-told').textContent !== before", arg=before
    )
    slider = tab.locator("#storm-form [name=hosts]")
    slider.focus()
    tab.keyboard.press("ArrowRight")
    expect(tab.locator("#storm-many")).to_have_text("8")


@pytest.mark.parametrize("scripts", [True, False])
def test_a_still_picture_where_nothing_may_move(
    browser: Browser, address: str, scripts: bool
) -> None:
    with browser.new_context(
        reduced_motion="reduce" if scripts else "no-preference", java_script_enabled=scripts
    ) as context:
        page = context.new_page()
        page.goto(address)
        expect(page.locator("#fig-storm")).to_be_visible()
        expect(page.locator("#storm")).to_be_hidden()


def test_where_it_moves_there_is_no_second_picture(tab: Page) -> None:
    expect(tab.locator("#storm")).to_be_visible()
    expect(tab.locator("#fig-storm")).to_be_hidden()


@functools.cache
def known() -> dict[tuple[frozenset[str], str], int]:
    return {(rung.switches, rung.protocol): rung.fit for rung in ladder.rungs()}


def test_the_ladder_tells_what_the_package_says(tab: Page) -> None:
    told = tab.locator(".ladder-told")
    expect(told).to_contain_text("as the paper counts")
    for switch in ladder.SWITCHES:
        tab.get_by_label(switch.name, exact=True).check()
        boxes = tab.locator("#ladder input:checked")
        on = frozenset(box.get_attribute("value") or "" for box in boxes.all())
        assert switch.key in on
        for protocol in ladder.TABLES:
            expect(told).to_contain_text(f"{known()[on, protocol]} with {protocol}")
        marker = tab.locator(".ladder-marker").first
        expect(marker).to_have_text(re.compile(rf"^{known()[on, 'DDS']}\s*DDS"))
    while tab.locator("#ladder input:checked").count():  # one may take others with it
        tab.locator("#ladder input:checked").first.uncheck()
    expect(told).to_contain_text("as the paper counts")


def test_nothing_serious_keeps_anyone_out_of_what_moves(tab: Page) -> None:
    tab.locator("#storm-pause").click()
    tab.evaluate(AXE)
    found = {}
    for scheme, size in (("light", PHONE), ("dark", DESKTOP)):
        tab.emulate_media(color_scheme=scheme)
        tab.set_viewport_size(size)
        tab.wait_for_function(f"document.documentElement.dataset.theme === '{scheme}'")
        tab.wait_for_timeout(300)  # colors fade over
        found[scheme] = tab.evaluate(BARRIERS, {})
        assert tab.evaluate("document.documentElement.scrollWidth") == size["width"]
    assert found == {"light": [], "dark": []}


def test_the_live_parts_weigh_little(book: Path) -> None:
    landing = sum(path.stat().st_size for path in (book / "_static" / "landing").iterdir())
    page = (book / "book" / "index.html").read_text(encoding="utf-8")
    data = re.findall(r'<script type="application/json".*?</script>', page, re.S)
    assert len(data) == 2
    assert landing + sum(map(len, data)) <= 150_000


@pytest.mark.parametrize("page", ["book/index", "book/calculator", "notebooks/01_system"])
def test_a_shared_link_shows_what_it_is(book: Path, page: str) -> None:
    text = (book / f"{page}.html").read_text(encoding="utf-8")
    told = dict(re.findall(r'<meta (?:property|name)="([\w:]+)" content="([^"]*)"', text))
    assert told["twitter:card"] == "summary_large_image"
    assert told["og:title"]
    assert 40 < len(told["og:description"]) <= 202
    picture = (book / page).parent / told["og:image"]
    assert picture.resolve().is_file()
    assert picture.read_bytes().startswith(b"\x89PNG")
