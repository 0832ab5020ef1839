"""Test chapters in a browser: the line of Fig. 3, and a guess before the answer."""

import json
import re
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager
from pathlib import Path
from typing import Any, Literal

import numpy as np
import pytest
from compare_facts import paragraphs, read_cells
from playwright.sync_api import Browser, BrowserContext, Locator, Page, ViewportSize, expect
from support import ROOT
from test_pages import AXE, BARRIERS, DESKTOP, PHONE, show

import discostorm as ds
from discostorm import drain_times, figures
from discostorm.protocols import timed_paper_tables
from discostorm_book import interactive
from discostorm_book.facts import first_mismatch
from discostorm_book.figures import startup_queue

STATIC = ROOT / "book" / "_static"
FIG3, QUEUE = "04_processes", "07_what_100_percent_means"


def data(name: str, path: Path) -> Any:
    """Return the stored data of a chapter's script, or nothing."""
    pattern = rf'<script type="application/json" id="{name}-data">(.*?)</script>'
    outputs = [out for cell in read_cells(path) for out in cell.get("outputs", [])]
    stored = ("".join(out.get("data", {}).get("text/html", "")) for out in outputs)
    found = [match[1] for html in stored if (match := re.search(pattern, html))]
    assert len(found) < 2
    return json.loads(found[0]) if found else None


def with_announcement_period(period: float) -> ds.Protocol:
    """Return Fast DDS's timers with another period of announcements."""
    return startup_queue.with_period(timed_paper_tables.timed_by_product()["Fast DDS"], period)


NOTEBOOKS = sorted((ROOT / "notebooks").glob("*.ipynb"))
GUESSES = {path.stem: asked for path in NOTEBOOKS if (asked := data("guess", path))}
#: In which each is looked at.
THEMES: list[tuple[Literal["light", "dark"], ViewportSize]]
THEMES = [("light", PHONE), ("dark", DESKTOP)]
#: A chapter whose guess is tried in full.
FIRST_GUESS = "03_hosts"
each_guess = pytest.mark.parametrize("name", GUESSES)


def in_short(name: str) -> tuple[str, dict[str, float]]:
    """Return the paragraph that the guess is about, and its facts."""
    pieces = paragraphs(read_cells(ROOT / "notebooks" / f"{name}.ipynb"))
    (found,) = (one for one in pieces if one.text.startswith("**In short.**") and one.values)
    return found.text, dict(found.values or {})


# ---- without a browser ----


def test_each_chapter_but_a_summary_and_the_appendix_asks_for_a_guess() -> None:
    chapters = [path.stem for path in NOTEBOOKS if "01" < path.stem < "16"]
    assert [*GUESSES] == [name for name in chapters if not name.startswith("06")]


@each_guess
def test_in_short_answers_what_is_asked(name: str) -> None:
    asked = GUESSES[name]
    text, values = in_short(name)
    shown = f"{asked['answer']:.{asked['places']}f}"
    scale = 100 if asked["unit"] == "%" else 1
    assert re.search(rf"(?<![\d.,]){re.escape(shown)}(?![\d]|\.\d)", text)
    slack = asked["step"] / 2 / scale
    assert any(abs(value - asked["answer"] / scale) <= slack for value in values.values())


def test_a_question_states_no_other_numbers_and_can_be_answered() -> None:
    reach = {"minimum": 1.0, "maximum": 10.0, "step": 0.1, "unit": "times"}
    assert first_mismatch("8 instead of 4?", {"many": 8, "few": 4}) is None
    with pytest.raises(ValueError, match="disagree"):
        interactive.ask_guess("9 instead of 4?", 4.6, given={"many": 8, "few": 4}, **reach)
    with pytest.raises(ValueError, match="between 1 and 10"):
        interactive.ask_guess("How many?", 12, **reach)


def test_no_data_ends_the_element_that_holds_it() -> None:
    html = interactive.embed_data("some", {"text": "</script>"}, "a.js", "b.css").data
    assert html.count("</script>") == 2
    assert html.splitlines()[1:] == [
        '<script src="../_static/a.js"></script>',
        '<link rel="stylesheet" href="../_static/b.css">',
    ]


def test_the_line_has_the_utilization_of_the_package() -> None:
    line = data("line", ROOT / "notebooks" / f"{FIG3}.ipynb")
    assert [one["name"] for one in line["protocols"]] == ["DDS", "Zenoh"]
    for one in line["protocols"]:
        for endpoints in range(4, 101, 7):
            for processes in range(1, 11):
                each = endpoints / processes
                stated = ds.utilization(
                    ds.PROTOCOLS[one["name"]], figures.FIG3_HOSTS, processes, each
                )
                summed = sum(c * processes**i * each**j for i, j, c in one["terms"])
                assert summed == pytest.approx(float(stated), rel=1e-9)


def test_the_queue_has_the_airtime_of_the_package() -> None:
    queue = data("queue", ROOT / "notebooks" / f"{QUEUE}.ipynb")
    time = np.array([0.0, 0.1, 0.49, 0.5, 3.5, 9.6])
    for endpoints in (0, 10, 40):
        for period, steady in queue["periods"]:
            table = with_announcement_period(period)
            sent = np.zeros_like(time)
            for one in queue["rounds"]:
                schedule = ds.Schedule(tuple(one["starts"]), period if one["repeats"] else np.inf)
                none, each = one["airtime"]
                sent += (none + each * endpoints) * np.asarray(schedule.sent(time))
            assert sent == pytest.approx(
                drain_times.demand(table, time, 30, 2, endpoints), rel=1e-9
            )
            stays = ds.utilization(table, 30, 2, endpoints, window=np.inf)
            assert steady == pytest.approx(float(stays), rel=1e-9)


def test_the_queue_that_is_drawn_clears_when_it_is_said_to() -> None:
    swarm = {"processes": 2, "endpoints": 10}
    for hosts in (7, 30):
        drawn = startup_queue.queue_over_time_data(with_announcement_period(3), hosts, swarm)
        clear = drain_times.first_idle(with_announcement_period(3), hosts, **swarm)
        before = drawn["time_s"].between(0.6, clear - 0.1)
        assert (drawn["waiting_s"][before] > 0).all()
        after = drawn["time_s"].between(clear, clear + 0.1)
        assert drawn["waiting_s"][after].min() == pytest.approx(0, abs=0.05)


def test_scripts_are_short_and_know_no_numbers_of_the_model() -> None:
    chapters = [f"chapters/{path.name}" for path in (STATIC / "chapters").glob("*.js")]
    assert "chapters/line.js" in chapters
    for file, most in [("guess.js", 150), *((name, 300) for name in chapters)]:
        text = (STATIC / file).read_text(encoding="utf-8")
        assert len(text.splitlines()) <= most
        assert "import " not in text
        assert not re.search(r"https?://(?!www\.w3\.org/2000/svg)", text)


# ---- in a browser ----


@pytest.fixture
def context(browser: Browser) -> Iterator[BrowserContext]:
    with browser.new_context(viewport=DESKTOP, color_scheme="light", offline=True) as context:
        yield context


def opened(context: BrowserContext, book: Path, name: str, anchor: str = "") -> Page:
    tab = context.new_page()
    tab.goto((book / "notebooks" / f"{name}.html").as_uri() + anchor)
    return tab


def answer(tab: Page) -> Locator:
    return tab.locator(".bd-article p", has_text=re.compile(r"^In short\."))


def shown_utilizations(endpoints: int, processes: int) -> list[str]:
    """Return the utilizations in the text on the line: with this split, and in one process."""

    def takes(name: str, n: int) -> str:
        share = ds.utilization(ds.PROTOCOLS[name], figures.FIG3_HOSTS, n, endpoints / n)
        return f"{float(share):.1%}"

    now, one = ({name: takes(name, n) for name in ("DDS", "Zenoh")} for n in (processes, 1))
    return [
        f"need {now['DDS']} of a second with DDS and {now['Zenoh']} with Zenoh.",
        f"In 1 process they need {one['DDS']} with DDS and {one['Zenoh']} with Zenoh.",
    ]


@pytest.mark.book
def test_sliders_and_keyboard_move_the_line_and_it_is_said(
    context: BrowserContext, book: Path
) -> None:
    tab = opened(context, book, FIG3)
    told = tab.locator(".line-told")
    assert told.get_attribute("role") == "status"
    for text in shown_utilizations(40, 8):
        expect(told).to_contain_text(text)
    expect(told).to_contain_text("in 8 processes of 5,")
    endpoints = tab.get_by_label("Endpoints of a robot, M")
    endpoints.focus()
    tab.keyboard.press("ArrowRight")
    for text in shown_utilizations(41, 8):
        expect(told).to_contain_text(text)
    expect(told).to_contain_text("5.1 endpoints on average")
    tab.get_by_label("Processes they are split into").fill("1")
    expect(told).to_contain_text(shown_utilizations(41, 1)[0])
    expect(told).not_to_contain_text("In 1 process they")
    for end in (4, 100):
        endpoints.fill(str(end))
        for processes in range(1, 11):
            tab.get_by_label("Processes they are split into").fill(str(processes))
            expect(told).to_contain_text(shown_utilizations(end, processes)[0])


@pytest.mark.book
@pytest.mark.parametrize("size", [DESKTOP, PHONE], ids=["desktop", "phone"])
def test_the_line_is_dragged_to_where_the_pointer_is(
    context: BrowserContext, book: Path, size: Any
) -> None:
    tab = opened(context, book, FIG3)
    tab.set_viewport_size(size)
    image = tab.locator("#fig-paper-3 img")
    image.scroll_into_view_if_needed()
    picture = tab.locator(".line-picture")
    expect(picture).to_be_visible()
    tab.wait_for_timeout(200)  # both have their size
    assert picture.bounding_box() == pytest.approx(image.bounding_box(), abs=1)
    line = data("line", ROOT / "notebooks" / f"{FIG3}.ipynb")
    shown = line["narrow"] if size == PHONE else line
    panel, box = shown["panels"][0], image.bounding_box()
    assert box is not None

    def place(processes: float, each: float) -> tuple[float, float]:
        spots = []
        for value, lim, part in (
            (processes, panel["xlim"], panel["x"]),
            (each, panel["ylim"], panel["y"]),
        ):
            share = (value - lim[0]) / (lim[1] - lim[0])
            spots.append(part[0] + share * (part[1] - part[0]))
        return box["x"] + spots[0] * box["width"], box["y"] + spots[1] * box["height"]

    tab.mouse.move(*place(4, 10))
    tab.mouse.down()
    tab.mouse.move(*place(5, 12), steps=4)
    tab.mouse.up()
    tab.mouse.move(*place(9, 30))  # let go, it stays
    told = tab.locator(".line-told")
    found = re.search(r"with (\d+) endpoints each, in (\d+) processes", told.inner_text())
    assert found is not None
    endpoints, processes = map(int, found.groups())
    assert endpoints == pytest.approx(60, abs=2)
    assert processes == 5
    expect(told).to_contain_text(shown_utilizations(endpoints, processes)[0])
    dot = tab.locator("circle.line-dot").first.bounding_box()
    assert dot is not None
    x, y = place(5, endpoints / 5)
    assert (dot["x"] + dot["width"] / 2, dot["y"] + dot["height"] / 2) == pytest.approx(
        (x, y), abs=1.5
    )


@pytest.mark.book
def test_the_queue_clears_when_the_package_says(context: BrowserContext, book: Path) -> None:
    tab = opened(context, book, QUEUE)
    told = tab.locator(".line-told")
    endpoints = tab.get_by_label("Burst: endpoints of a process")
    period = tab.get_by_label("Period of announcements")
    for many, seconds in ((10, 3), (0, 3), (40, 3), (10, 10), (40, 2), (5, 4)):
        endpoints.fill(str(many))
        period.fill(str(seconds))
        clear = drain_times.first_idle(with_announcement_period(seconds), 30, 2, many)
        expect(told).to_contain_text(f"clears after {clear:.1f} s.")
        expect(told).to_contain_text(f"{many} endpoints each, announcing every {seconds} s")
        assert tab.locator(".line-end").is_visible() == (clear <= 120)
    period.focus()
    for _ in range(3):
        tab.keyboard.press("ArrowLeft")
    assert period.get_attribute("aria-valuetext") == "1 s"
    expect(told).to_contain_text("never clears, because periodic traffic alone needs 1.46 s")
    expect(tab.locator(".line-end")).to_be_hidden()


@pytest.mark.book
@pytest.mark.parametrize("name", [*GUESSES][1::4])
def test_in_short_stays_folded_until_the_guess(
    context: BrowserContext, book: Path, name: str
) -> None:
    asked = GUESSES[name]
    tab = opened(context, book, name)
    expect(answer(tab)).to_be_hidden()
    form = tab.get_by_role("form", name="Guess first")
    expect(form).to_contain_text(asked["question"])
    slider = form.get_by_role("slider", name="Your guess")
    slider.focus()
    tab.keyboard.press("End")
    assert slider.get_attribute("aria-valuetext") in form.inner_text().replace("\n", " ")
    tab.keyboard.press("Enter")
    expect(answer(tab)).to_be_visible()
    expect(answer(tab)).to_be_focused()
    sign = "%" if asked["unit"] == "%" else f"\u00a0{asked['unit']}"
    places = asked["places"]
    expect(form.get_by_role("status")).to_have_text(
        f"You guessed {asked['most']:.{places}f}{sign}. It is {asked['answer']:.{places}f}{sign}."
    )
    expect(slider).to_be_disabled()
    tab.reload()  # it is asked once
    expect(answer(tab)).to_be_visible()
    expect(form).to_have_count(0)
    mine = "Object.keys(localStorage).filter((key) => key.startsWith('guess'))"
    assert tab.evaluate(mine) == []  # it is kept in this tab alone
    assert tab.evaluate("document.cookie") == ""
    assert tab.evaluate("Object.keys(sessionStorage).some((key) => key.startsWith('guess'))")


@pytest.mark.book
def test_a_guess_can_be_skipped_and_left(context: BrowserContext, book: Path) -> None:
    name = FIRST_GUESS
    tab = opened(context, book, name)
    tab.get_by_role("button", name="Skip").click()
    expect(answer(tab)).to_be_visible()
    expect(answer(tab)).to_be_focused()
    expect(tab.locator(".guess")).to_have_count(0)
    again = opened(context, book, name)  # another tab keeps nothing of it
    expect(answer(again)).to_be_hidden()
    again.evaluate("location.hash = 'paper-fig-2'")
    expect(answer(again)).to_be_visible()
    expect(opened(context, book, name, "#paper-fig-2").locator(".guess")).to_have_count(0)


@pytest.mark.book
def test_on_paper_and_without_scripts_all_is_open(
    browser: Browser, context: BrowserContext, book: Path
) -> None:
    for name in (FIRST_GUESS, "05_nav2", FIG3):
        tab = opened(context, book, name)
        added = tab.locator(".guess, .line-controls, .line-picture")
        assert added.count() > 0
        tab.emulate_media(media="print")
        expect(answer(tab)).to_be_visible()
        for one in added.all():
            expect(one).to_be_hidden()
        tab.close()
        with browser.new_context(java_script_enabled=False) as without:
            plain = opened(without, book, name)
            expect(answer(plain)).to_be_visible()
            expect(plain.locator(".guess, .line-controls, .line-picture")).to_have_count(0)


@pytest.mark.book
@pytest.mark.parametrize("name", [FIG3, FIRST_GUESS, QUEUE])
def test_nothing_serious_keeps_anyone_out(
    open_tab: Callable[..., AbstractContextManager[Page]], book: Path, name: str
) -> None:
    address = (book / "notebooks" / f"{name}.html").as_uri()
    with open_tab(address, DESKTOP, reduced_motion="reduce") as tab:
        tab.evaluate(AXE)
        # The whole page, with the question asked, is looked at in test_pages.py.
        barriers = BARRIERS.replace(
            "document,", "document.querySelector('.guess, .line-controls'),"
        )
        assert barriers != BARRIERS
        for scheme, size in THEMES:
            show(tab, scheme, size)
            assert tab.evaluate(barriers, {}) == []
            assert tab.evaluate("document.documentElement.scrollWidth") == size["width"]
            if tab.get_by_role("button", name="Guess").count():
                tab.get_by_role("button", name="Guess").click()
