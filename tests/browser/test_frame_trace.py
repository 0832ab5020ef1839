"""Test one startup frame by frame: in Python, in the browser, and in the chapter's words."""

import re
import statistics
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager
from decimal import ROUND_HALF_UP, Decimal
from functools import cache
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
import single_simulations
from numpy.typing import NDArray
from playwright.sync_api import Browser, Locator, Page, expect
from support import ROOT
from test_interactive_figures import THEMES, data
from test_landing import STOPWATCH
from test_pages import AXE, BARRIERS, DESKTOP, show
from test_wasm import compare_wasm_with_python

import discostorm as ds
from discostorm.data import data_path
from discostorm_book import frame_trace, sweeps
from discostorm_book.figures import burst

STATIC = ROOT / "book" / "_static"
CHAPTER = "11_burst_on_air"
NARROW = {"width": 360, "height": 800}
EXPORTED = frame_trace.page_data()["starts"]
COLUMN = {name: place for place, name in enumerate(frame_trace.COLUMNS)}
each_start = pytest.mark.parametrize(
    "number", range(len(frame_trace.TRACED_STARTS)), ids=["small", "full"]
)


@cache
def rows(number: int) -> NDArray[np.float64]:
    return single_simulations.transmission_rows(frame_trace.TRACED_STARTS[number])


def of(number: int, row: int, *names: str) -> list[int]:
    """Return columns of a row."""
    return [int(rows(number)[row, COLUMN[name]]) for name in names]


@cache
def simulated(number: int) -> ds.Simulation:
    start = frame_trace.TRACED_STARTS[number]
    fleet = ds.Fleet.swarm(start.hosts, start.processes, start.endpoints)
    given = (fleet, ds.DDS, sweeps.sweep_channel())
    return ds.simulate(*given, queue=start.queue, recovery=False, seed=frame_trace.SEED)


# ---- without a browser ----


@each_start
def test_the_trace_is_the_simulators(number: int) -> None:
    """The simulator keeps the first frames of a run; losses and receptions are of all of it."""
    found, logged = rows(number), np.array(simulated(number).transmissions.tolist(), dtype=float)
    assert len(found) >= len(logged) > 100
    np.testing.assert_array_equal(found[: len(logged), : len(frame_trace.LOG_COLUMNS)], logged)
    lost = {cause: of(number, -1, cause)[0] for cause in frame_trace.LOSS_WORDS}
    counts = simulated(number).counts
    assert lost == {cause: int(counts[cause][0]) for cause in frame_trace.LOSS_WORDS}
    assert (found[-1, len(frame_trace.COLUMNS) :] == 0).all()


@each_start
def test_each_frame_that_arrives_leaves_a_queue(number: int) -> None:
    found, hosts = rows(number), frame_trace.TRACED_STARTS[number].hosts
    waiting = found[:, len(frame_trace.COLUMNS) :]
    assert waiting.max() <= (frame_trace.TRACED_STARTS[number].queue or (100,))[0]
    good = found[:, COLUMN["outcome"]] == 0
    for row in np.flatnonzero(good[1:]) + 1:
        station, source, came, start = of(number, row, "station", "source", "came", "start")
        assert came < start
        if station < hosts:
            assert source // frame_trace.TRACED_STARTS[number].processes == station
        if found[row, COLUMN["host_age"]] == found[row - 1, COLUMN["host_age"]]:
            assert waiting[row, station] == waiting[row - 1, station] - 1


def test_the_stored_start_is_todays() -> None:
    kept = pd.read_csv(data_path("simulated/events.csv", "discostorm_book"), dtype=str).drop(
        columns="source"
    )
    pd.testing.assert_frame_equal(
        kept, pd.DataFrame(single_simulations.burst_transmissions()).astype(str)
    )


def test_the_page_and_the_still_are_of_the_same_start() -> None:
    stored = data("scrub", ROOT / "notebooks" / f"{CHAPTER}.ipynb")
    exported = frame_trace.page_data()
    assert stored["columns"] == list(exported["columns"])
    first, exported_first = stored["starts"][0], exported["starts"][0]
    assert first["setting"] == exported_first["setting"]
    assert set(stored["causes"]) == set(frame_trace.CAUSES)
    panels = burst.queues_and_discovery(sweeps.load_sweep("events")).axes
    shown = [text.get_text() for panel in panels[1:] for text in panel.texts]
    *_, last = arrived_announcements(0, len(rows(0)) - 1)
    assert shown[-9:] == ["–", "100", "100", "100", "–", "100", "100", "100", "–"]
    assert last[:2] == [2, 2]


# ---- what the page says, worked out again ----


def exchange(number: int, row: int) -> tuple[int, int]:
    """Return first and last row of those that begin with one."""
    same = np.flatnonzero(rows(number)[:, 0] == rows(number)[row, 0])
    return int(same[0]), int(same[-1])


def arrived_announcements(number: int, row: int) -> list[list[int]]:
    """Return how many endpoint announcements have arrived, at [reader][writer]."""
    start = frame_trace.TRACED_STARTS[number]
    (sedp,) = (k for k, m in enumerate(ds.DDS.messages) if m.role == "data")
    found = [[0] * start.hosts for _ in range(start.hosts)]
    for one in range(exchange(number, row)[1] + 1):
        station, kind, failed = of(number, one, "station", "kind", "outcome")
        if (station, kind, failed) == (start.hosts, sedp, 0):
            writer, reader = of(number, one, "source", "destination")
            found[reader // start.processes][writer // start.processes] += 1
    return found


def milliseconds(ticks: int) -> str:
    shown = Decimal(ticks * 1e-7 * 1e3).quantize(Decimal("0.01"), ROUND_HALF_UP)
    return f"{shown}\N{NO-BREAK SPACE}ms"


def why(number: int, row: int) -> str:
    """Return why a frame waited."""
    same = ("station", "kind", "source", "destination", "item", "came")
    begin, came, station = of(number, row, "start", "came", "station")
    before = [one for one in range(row) if of(number, one, "station")[0] == station]
    tries = []
    while before and of(number, before[-1], *same) == of(number, row, *same):
        tries.append(before.pop())
    head = max(came, of(number, before[-1], "end")[0]) if before else came
    ahead = {tuple(of(number, one, *same)) for one in before if of(number, one, "end")[0] > came}
    spans = {}
    for one in range(row):
        first, end = of(number, one, "start", "end")
        spans[first] = max(end, spans.get(first, 0))
    busy = sum(max(0, min(end, begin) - max(first, head)) for first, end in spans.items())
    tried = sum(spans[first] - first for one in tries for first in of(number, one, "start"))
    parts = [
        (
            head - came,
            f"in the queue behind {len(ahead)} frame{'s' * (len(ahead) != 1)} sent first",
        ),
        (tried, f"in {len(tries)} attempt{'s' * (len(tries) != 1)} that collided"),
        (busy - tried, "while other stations sent"),
        (begin - head - busy, "of pauses and back-off"),
    ]
    told = [f"{milliseconds(ticks)} {text}" for ticks, text in parts if ticks]
    listed = " and ".join(told) if len(told) < 3 else f"{', '.join(told[:-1])}, and {told[-1]}"
    return f"It waited {milliseconds(begin - came)}: {listed}."


# ---- in a browser ----


@pytest.mark.book
@each_start
def test_the_browsers_trace_is_pythons(browser: Browser, number: int) -> None:
    with compare_wasm_with_python.offline_page(browser) as page:
        found = page.evaluate(
            """async (setting) => {
                const rows = [];
                const each = (share) => rows.push(...share.rows);
                await Live.run(setting, { each, looks: 70, trace: true }).found;
                return rows;
            }""",
            EXPORTED[number]["setting"],
        )
    here = rows(number)
    np.testing.assert_array_equal(np.array(found).reshape(len(here), -1), here)


@pytest.fixture(scope="module")
def tab(open_tab: Callable[..., AbstractContextManager[Page]], book: Path) -> Iterator[Page]:
    with open_tab((book / "notebooks" / f"{CHAPTER}.html").as_uri(), DESKTOP, STOPWATCH) as page:
        yield page


def choose(tab: Page, number: int) -> Locator:
    """Step through a start from its beginning; return the slider."""
    tab.locator(".scrub canvas").scroll_into_view_if_needed()
    # Another choice first, so that it begins anew.
    for one in (1 - number, number):
        tab.get_by_label("Start:").select_option(label=frame_trace.TRACED_STARTS[one].label)
        frames = f", frame 1 of {len(rows(one))}"
        slider = tab.get_by_role("slider", name="Time")
        expect(slider).to_have_attribute("aria-valuetext", re.compile(frames), timeout=30_000)
    return slider


@pytest.mark.book
@each_start
def test_each_frame_says_what_it_is_and_why_it_waited(tab: Page, number: int) -> None:
    slider, start = choose(tab, number), frame_trace.TRACED_STARTS[number]
    told, count = tab.locator(".scrub .line-told"), len(rows(number))
    assert told.get_attribute("role") == "status"
    step = 5 if number == 0 else 599
    for row in {*range(0, count, step), count - 1}:
        slider.fill(str(row))
        begin, station, failed = of(number, row, "start", "station", "outcome")
        said = told.inner_text()
        assert slider.get_attribute("aria-valuetext") == (
            f"{milliseconds(begin)}, frame {row + 1} of {count}"
        )
        sender = "The access point" if station == start.hosts else f"Robot {station + 1}"
        assert said.startswith(f"{sender} sends ")
        assert why(number, row) in said
        first, last = exchange(number, row)
        assert ("It collides with " in said) == bool(failed) == (last > first)
        waiting = rows(number)[row, len(frame_trace.COLUMNS) :].astype(int)
        assert f"{waiting[0]} at robot 1" in said
        assert f"and {waiting[-1]} at the access point." in said
        lost = sum(of(number, row, *frame_trace.CAUSES))
        assert f"Receptions lost so far: {f'{lost:,} (' if lost else 'none.'}" in said
        expected = arrived_announcements(number, row)
        every = EXPORTED[number]["announcements"]
        cells = tab.locator(".scrub-known tbody td").all_inner_texts()
        assert cells == [
            "–" if reader == writer else str(100 * expected[reader][writer] // every)
            for reader in range(start.hosts)
            for writer in range(start.hosts)
        ]
        total = start.hosts * (start.hosts - 1) * every
        arrived = sum(map(sum, expected))
        assert f"that have arrived: {arrived:,} of {total:,}." in said


@pytest.mark.book
def test_keys_and_buttons_step_and_jump(tab: Page) -> None:
    slider = choose(tab, 1)
    said = tab.locator(".scrub .line-told")

    def at() -> int:
        return int(slider.input_value())

    slider.focus()
    tab.keyboard.press("ArrowRight")
    tab.keyboard.press("ArrowRight")
    assert at() == 2
    tab.keyboard.press("ArrowLeft")
    assert at() == 1
    tab.get_by_role("button", name="Next frame").click()
    assert at() == 2
    tab.get_by_role("button", name="Previous frame").focus()
    tab.keyboard.press("Enter")
    assert at() == 1
    failed = rows(1)[:, COLUMN["outcome"]] != 0
    later = failed & (rows(1)[:, 0] > rows(1)[1, 0])
    tab.get_by_role("button", name="Next collision").click()
    assert at() == int(np.flatnonzero(later)[0])
    slider.fill("0")
    full = rows(1)[:, COLUMN["ap_full"]]
    for _ in range(200):
        tab.get_by_role("button", name="Next loss").click()
        if "full and drops it" in said.inner_text():
            break
    assert at() == int(np.flatnonzero(full)[0])
    slider.focus()
    tab.keyboard.press("End")
    assert at() == len(failed) - 1
    tab.get_by_role("button", name="Next frame").click()
    assert at() == len(failed) - 1


@pytest.mark.book
def test_a_click_chooses_the_frame_that_is_there(tab: Page) -> None:
    slider = choose(tab, 0)
    canvas = tab.locator(".scrub canvas")
    canvas.scroll_into_view_if_needed()
    box = canvas.bounding_box()
    assert box is not None
    left, lane = 96, 44
    for row in (3, 10, 30, 4):
        begin, end, station = of(0, row, "start", "end", "station")
        if end > 60_000:
            continue
        slider.fill("0")  # the lanes show the first six milliseconds
        across = left + (begin + end) / 2 / 60_000 * (box["width"] - left)
        canvas.click(position={"x": across, "y": (station + 1) * lane - 11})
        assert int(slider.input_value()) == row
        expect(slider).to_be_focused()
    canvas.click(position={"x": box["width"] - 2, "y": box["height"] - 30})  # the whole start
    assert int(slider.input_value()) > 90


@pytest.mark.book
def test_a_step_leaves_time_to_spare(tab: Page) -> None:
    """Also with more robots than fit: lanes, areas and matrix are drawn within a frame."""
    slider = choose(tab, 1)
    tab.evaluate("window.took.length = 0")
    slider.focus()
    for _ in range(40):
        tab.keyboard.press("PageUp")
        tab.keyboard.press("ArrowLeft")
        tab.wait_for_timeout(20)
    took = tab.evaluate("window.took")
    assert len(took) > 20
    assert statistics.median(took) < 8


@pytest.mark.book
def test_on_paper_and_without_scripts_there_is_the_still(browser: Browser, book: Path) -> None:
    address = (book / "notebooks" / f"{CHAPTER}.html").as_uri()
    with browser.new_context(viewport=DESKTOP) as context:
        tab = context.new_page()
        tab.goto(address)
        image = tab.locator("#fig-burst-scrub img")
        expect(tab.locator(".scrub")).to_be_visible()
        expect(image).to_be_hidden()
        tab.emulate_media(media="print")
        expect(tab.locator(".scrub")).to_be_hidden()
        expect(image).to_be_visible()
    with browser.new_context(java_script_enabled=False) as context:
        tab = context.new_page()
        tab.goto(address)
        expect(tab.locator("#fig-burst-scrub img")).to_be_visible()
        expect(tab.locator(".scrub")).to_have_count(0)


@pytest.mark.book
def test_nothing_serious_keeps_anyone_out(tab: Page) -> None:
    choose(tab, 1).fill("2000")
    tab.emulate_media(reduced_motion="reduce")
    tab.evaluate(AXE)
    barriers = BARRIERS.replace("document,", "document.querySelector('.scrub'),")
    assert barriers != BARRIERS
    for scheme, size in (*THEMES, ("dark", NARROW)):
        show(tab, scheme, size)
        assert tab.evaluate(barriers, {}) == []
        assert tab.evaluate("document.documentElement.scrollWidth") == size["width"]
    show(tab, "light", DESKTOP)


def test_what_the_page_brings_along_is_small() -> None:
    names = ("trace", "lanes_of_start", "scrub")
    texts = [(STATIC / "chapters" / f"{name}.js").read_text(encoding="utf-8") for name in names]
    assert all(len(text.splitlines()) <= 300 for text in texts)
    stored = data("scrub", ROOT / "notebooks" / f"{CHAPTER}.ipynb")
    assert len(str(stored)) + sum(map(len, texts)) <= 40_000
