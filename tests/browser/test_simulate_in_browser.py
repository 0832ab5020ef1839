"""Ten starts of the reader's own: the same as Python's, among the stored quartiles."""

import re
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager
from pathlib import Path

import numpy as np
import pytest
from playwright.sync_api import Browser, Page, expect
from support import ROOT
from test_interactive_figures import THEMES, data
from test_pages import AXE, BARRIERS, DESKTOP, show

import discostorm as ds
from discostorm_book import interactive, sweeps
from discostorm_book.figures import convergence

CHAPTER = "12_convergence"
OWN = data("own", ROOT / "notebooks" / f"{CHAPTER}.ipynb")
NAMES = [one["name"] for one in OWN["middleware"]]


def stored_quartiles(name: str, hosts: int) -> list[float | None]:
    """Return quartiles and how many converged, as the page has them."""
    (own,) = (one["stored"] for one in OWN["middleware"] if one["name"] == name)
    (row,) = (row for row in own if row[0] == hosts)
    return list(row[1:])


def convergence_times(name: str, hosts: int, seed: int) -> list[float]:
    """Return when ten starts converge [s]."""
    found = ds.simulate(
        ds.Fleet.swarm(hosts, OWN["processes"], OWN["endpoints"]),
        ds.PROTOCOLS[name],
        sweeps.sweep_channel(),
        queue=tuple(OWN["setting"]["queue"]),
        until=OWN["setting"]["until"],
        runs=OWN["runs"],
        seed=seed,
    )
    return [float(value) for value in found.convergence_time]


# ---- without a browser ----


def test_the_page_has_the_sweeps_quartiles() -> None:
    rows = sweeps.load_sweep("convergence").query("loss == 0").set_index(["protocol", "hosts"])
    assert OWN["runs"] == 10
    assert NAMES[OWN["begin"][0]] == interactive.FIRST_OWN_START[1]
    for name in NAMES:
        assert len(set(rows.loc[name].index)) == len(rows.loc[name])
        for hosts, row in rows.loc[name].iterrows():
            *quartiles, converged = stored_quartiles(name, int(str(hosts)))
            names = [f"convergence_time_s{end}" for end in ("_q25", "", "_q75")]
            assert [np.inf if one is None else one for one in quartiles] == row[names].tolist()
            assert converged == row["converged"]


def test_the_stored_runs_are_the_simulators() -> None:
    """What the page compares with comes out again with the sweep's seed."""
    quartiles = np.quantile(
        convergence_times("Fast DDS 3.6", 6, 2026), [0.25, 0.5, 0.75], method="higher"
    )
    *kept, _ = stored_quartiles("Fast DDS 3.6", 6)
    assert np.array(kept, dtype=float) == pytest.approx(quartiles, rel=1e-5)


# ---- in a browser ----


@pytest.fixture(scope="module")
def tab(open_tab: Callable[..., AbstractContextManager[Page]], book: Path) -> Iterator[Page]:
    with open_tab((book / "notebooks" / f"{CHAPTER}.html").as_uri(), DESKTOP) as page:
        yield page


def choose(tab: Page, name: str, hosts: int) -> None:
    """Choose a setting."""
    tab.get_by_label("Middleware:").select_option(label=name)
    place = [row[0] for row in OWN["middleware"][0]["stored"]].index(hosts)
    tab.get_by_label("Robots:").fill(str(place))


@pytest.mark.book
@pytest.mark.parametrize(
    ("name", "hosts"), [("Fast DDS 3.6", 10), ("Zenoh peer", 6), ("Cyclone DDS", 12)]
)
def test_ten_dots_are_ten_runs_of_python(tab: Page, name: str, hosts: int) -> None:
    tab.reload()  # seeds begin anew
    choose(tab, name, hosts)
    told = tab.locator(".line-told")
    assert told.get_attribute("role") == "status"
    tab.get_by_role("button", name="Run ten starts").click()
    expect(told).to_contain_text("stored runs", timeout=120_000)
    expected = convergence_times(name, hosts, seed=1)
    dots = tab.locator("circle.own-dot")
    found = dots.evaluate_all("dots => dots.map((dot) => dot.dataset.seconds)")
    assert [float(value) for value in found] == expected
    # They are where the quartiles are drawn.
    panel, (width, height) = OWN["panels"][NAMES.index(name)], OWN["size"]
    drawn = dots.evaluate_all(
        "dots => dots.map((dot) => [dot.cx.baseVal.value, dot.cy.baseVal.value])"
    )
    for (x, y), seconds in zip(drawn, expected, strict=True):
        value = np.log10(seconds) if np.isfinite(seconds) else convergence.NEVER_AT
        for at, size, ends, lim, where in (
            (y, height, panel["y"], panel["ylim"], value),
            (x, width, panel["x"], panel["xlim"], hosts),
        ):
            share = (at / size - ends[0]) / (ends[1] - ends[0])
            slack = 0.41 if where == hosts else 1e-3
            assert lim[0] + share * (lim[1] - lim[0]) == pytest.approx(where, abs=slack)
    words = {10: "ten", 0: "none"}
    good = sum(map(np.isfinite, expected))
    assert (
        f"random seed 1: {words[good]} of ten starts converged within 2 minutes"
        in told.inner_text()
    )
    if good:
        middle, theirs = sorted(expected)[5], stored_quartiles(name, hosts)[1]
        assert theirs is not None
        said = re.findall(r"in a median of ([\d.]+) s", told.inner_text())
        assert [float(one) for one in said] == pytest.approx([middle, theirs], abs=0.051)


@pytest.mark.book
def test_another_press_is_another_seed(tab: Page) -> None:
    tab.reload()
    choose(tab, "Fast DDS 3.6", 4)
    told, button = tab.locator(".line-told"), tab.get_by_role("button", name="Run ten starts")
    dots = tab.locator("circle.own-dot")
    for seed in (1, 2):
        button.focus()
        tab.keyboard.press("Enter")
        expect(told).to_contain_text(f"random seed {seed}: ", timeout=30_000)
        found = dots.evaluate_all("dots => dots.map((dot) => dot.dataset.seconds)")
        assert [float(value) for value in found] == convergence_times("Fast DDS 3.6", 4, seed)


@pytest.mark.book
def test_the_runs_can_be_stopped_and_another_choice_clears_them(tab: Page) -> None:
    tab.reload()
    choose(tab, "Fast DDS 3.6", 24)
    tab.get_by_role("button", name="Run ten starts").click()
    expect(tab.get_by_role("progressbar", name="Simulating")).to_be_visible()
    tab.get_by_role("button", name="Stop").click()
    expect(tab.get_by_role("button", name="Run ten starts")).to_be_visible()
    expect(tab.get_by_role("progressbar", name="Simulating")).to_be_hidden()
    choose(tab, "Fast DDS 3.6", 2)
    expect(tab.locator("circle.own-dot")).to_have_count(0)
    tab.get_by_role("button", name="Run ten starts").click()
    expect(tab.locator("circle.own-dot")).to_have_count(10, timeout=30_000)
    choose(tab, "Zenoh peer", 2)
    expect(tab.locator("circle.own-dot")).to_have_count(0)
    assert tab.locator(".line-told").inner_text() == ""


@pytest.mark.book
def test_on_paper_and_without_scripts_the_bars_stand_alone(browser: Browser, book: Path) -> None:
    address = (book / "notebooks" / f"{CHAPTER}.html").as_uri()
    with browser.new_context(viewport=DESKTOP) as context:
        tab = context.new_page()
        tab.goto(address)
        expect(tab.locator(".line-controls")).to_be_visible()
        tab.emulate_media(media="print")
        expect(tab.locator(".line-controls")).to_be_hidden()
        expect(tab.locator("#fig-converge-own img")).to_be_visible()
    with browser.new_context(java_script_enabled=False) as context:
        tab = context.new_page()
        tab.goto(address)
        expect(tab.locator("#fig-converge-own img")).to_be_visible()
        expect(tab.locator(".line-controls")).to_have_count(0)


@pytest.mark.book
def test_nothing_serious_keeps_anyone_out(tab: Page) -> None:
    tab.reload()
    choose(tab, "Fast DDS 3.6", 4)
    tab.get_by_role("button", name="Run ten starts").click()
    expect(tab.locator(".line-told")).to_contain_text("stored runs", timeout=30_000)
    tab.emulate_media(reduced_motion="reduce")
    tab.evaluate(AXE)
    barriers = BARRIERS.replace("document,", "document.querySelector('#fig-converge-own'),")
    for scheme, size in (*THEMES, ("dark", {"width": 360, "height": 800})):
        show(tab, scheme, size)
        assert tab.evaluate(barriers, {}) == []
        assert tab.evaluate("document.documentElement.scrollWidth") == size["width"]
    show(tab, "light", DESKTOP)
