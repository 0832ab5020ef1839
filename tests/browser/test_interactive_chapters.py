"""Chapters to touch: blocks of airtime, failures, three robots, and dials with their bars."""

import re
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager
from itertools import chain
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from playwright.sync_api import Browser, BrowserContext, Page, ViewportSize, expect
from support import ROOT
from test_interactive_figures import data, opened
from test_pages import AXE, BARRIERS, DESKTOP, show

import discostorm as ds
from discostorm.data import read_data
from discostorm.notation import NOTATION
from discostorm_book import enumeration, failure_runs
from discostorm_book.figures import paper_part, servers
from discostorm_book.show import payload_meaning

BLOCK_LIMITS, FAILURES, NETWORK = "02_message_to_airtime", "14_servers", "01_who_tells_whom"
#: Chapters with dials and bars.
CHOSEN = [
    "05_nav2",
    "08_any_wifi",
    "09_mixed_fleets",
    "10_products",
    "15_hybrid",
    "15b_what_to_change",
]
SMALLEST: ViewportSize = {"width": 360, "height": 780}
SWARMS = [(7, 2, 10), (8, 2, 10), (1, 1, 0), (20, 5, 40), (3, 4, 0), (12, 1, 25)]


def stored(name: str, page: str) -> Any:
    return data(name, ROOT / "notebooks" / f"{page}.ipynb")


def seconds(value: float) -> str:
    return f"{value:.3f} s" if value < 10 else f"{value:.1f} s"


# ---- without a browser ----


@pytest.mark.parametrize("swarm", SWARMS)
def test_blocks_are_the_breakdown_of_the_package(swarm: tuple[int, int, int]) -> None:
    sizes = dict(zip(("N_H", "N_P", "N_E"), swarm, strict=True))
    for protocol in stored("blocks", BLOCK_LIMITS)["protocols"]:
        table = ds.PROTOCOLS[protocol["name"]]
        parts, total = ds.breakdown(table, *swarm), 0.0
        for message in protocol["messages"]:
            number = np.prod(
                [(sizes.get(name, 0) - less) ** power for name, less, power in message["count"]]
            )
            row = parts.loc[message["name"]]
            assert number == row["uplink_messages"]
            for way, column in (("up", "uplink_s"), ("down", "downlink_s")):
                airtime = number * sum(message[way]["seconds"])
                assert airtime == pytest.approx(row[column], rel=1e-9)
                total += airtime
        assert total == pytest.approx(float(ds.utilization(table, *swarm)), rel=1e-9)


def test_symbols_are_those_of_the_notation() -> None:
    blocks = stored("blocks", BLOCK_LIMITS)
    known = {name: quantity.meaning for name, quantity in NOTATION.items()}
    known |= {
        message.payload_symbol.name: payload_meaning(table, message)
        for table in (ds.DDS, ds.ZENOH)
        for message in table.messages
    }
    factors = {"B": 1, "µs": 1e-6, "Mbit/s": 1e6}
    values = ds.DDS.values() | ds.ZENOH.values() | ds.PAPER.values()
    by_name = {str(symbol): float(value) for symbol, value in values.items()}
    used = {"N_H", "N_P", "N_E"}
    for protocol in blocks["protocols"]:
        for message in protocol["messages"]:
            used |= {message["header"], message["payload"]}
            used |= {message[way][of] for way in ("up", "down") for of in ("rate", "overhead")}
    assert set(blocks["symbols"]) == used
    for name, (meaning, value) in blocks["symbols"].items():
        assert meaning == known[name]
        if value:
            number, unit = value.split()
            assert float(number) * factors[unit] == pytest.approx(by_name[name], rel=1e-5)


def test_the_stored_blocks_add_up_to_utilization() -> None:
    drawn = paper_part.airtime_blocks_data(7, 2, 10)
    totals = (drawn["overhead_s"] + drawn["bits_s"]).groupby(drawn["protocol"]).sum()
    for name in ("DDS", "Zenoh"):
        assert totals[name] == pytest.approx(float(ds.utilization(ds.PROTOCOLS[name], 7, 2, 10)))


def rows_of(name: str, event: str) -> list[dict[str, str]]:
    """Return the measured rows of an event, from both tables."""
    every = [
        *read_data("measured/deaths.csv", "discostorm_book"),
        *read_data("measured/outages.csv", "discostorm_book"),
    ]
    return [row for row in every if (row["configuration"], row["event"]) == (name, event)]


def pairs_apart(name: str, event: str, run: int, time: float) -> set[tuple[str, str]]:
    """Return who did not all hear each other at a time, straight from the measured rows."""
    rows = {
        (row["phase"], row["who"], row["quantity"]): (float(row["seconds"]), float(row["since_s"]))
        for row in rows_of(name, event)
        if row["run"] == str(run)
    }

    def at(*key: str) -> float:
        took, since = rows.get(key, (np.inf, 0.0))
        return since + took

    found = set()
    groups = {
        "survivors": ("survivors", "survivors", "survivors"),
        "orphans": ("orphans", "orphans", "orphans"),
        "orphans and survivors": ("orphans", "survivors", "orphans"),
    }
    for who, (one, other, returned) in groups.items():
        lost = at("death", who, "unmatched")
        again = min(at("death", who, "settled"), at("return", returned, "found"))
        if lost <= time < again:
            found.add((one, other))
    late = {
        "newcomer": ("newcomer", "survivors"),
        "newcomer, and orphans": ("newcomer", "orphans"),
        "newcomer beside orphans": ("beside", "survivors"),
        "newcomer beside orphans, and orphans": ("beside", "orphans"),
    }
    for who, pair in late.items():
        if ("newcomer", who, "found") in rows:
            begin = rows["newcomer", who, "found"][1]
            again = min(at("newcomer", who, "found"), at("return", "newcomer", "found"))
            if begin <= time < again:
                found.add(pair)
    return found


def drawn_apart(case: Any, staging: Any, run: int, time: float) -> set[tuple[str, str]]:
    return {
        (one, other)
        for (one, other, _), span in zip(case["relations"], staging["runs"][run], strict=True)
        if span and span[0] <= time < (np.inf if span[1] is None else span[1])
    }


def cases() -> Iterator[tuple[str, Any, Any]]:
    for name, case in zip(failure_runs.CONFIGURATIONS, stored("failures", FAILURES), strict=True):
        for staging in case["stagings"]:
            yield name, case, staging


def test_each_run_shows_what_was_measured_at_all_times() -> None:
    looked = 0
    for name, case, staging in cases():
        rows = rows_of(name, staging["event"])
        assert len(staging["runs"]) == len({row["run"] for row in rows})
        last = max(float(row["since_s"]) + float(row["watched_s"]) for row in rows)
        assert staging["end"] == last
        for run, spans in enumerate(staging["runs"]):
            changes = {time for span in spans if span for time in span if time is not None}
            for time in (-1.0, *(t + d for t in changes for d in (-0.015, 0.015)), last):
                looked += 1
                measured = pairs_apart(name, staging["event"], run + 1, time)
                assert drawn_apart(case, staging, run, time) == measured
    assert looked > 400


def test_some_late_joiners_are_never_found() -> None:
    server = "Fast DDS Discovery Server"
    never = {
        (name, staging["event"]): sum(late is not None and late[1] is None for _, late in runs)
        for name, _, staging in cases()
        if name == server and (runs := staging["runs"])
    }
    assert never[server, "server restarts"] == 4
    assert never[server, "outage of 3 s"] == 5
    assert never[server, "outage of 25 s"] == 0


def test_the_medians_of_the_runs_are_those_of_the_stored_figure() -> None:
    lanes = servers.contact_after_failures_data().set_index(["configuration", "event", "who"])[
        "connected_from_s"
    ]
    who = {
        ("survivors", "survivors"): "robots that knew each other",
        ("newcomer", "survivors"): "late joiner",
    }
    for name, case, staging in cases():
        if staging["event"] != "server killed":
            continue
        for place, (one, other, _) in enumerate(case["relations"]):
            label = who.get((one, other))
            if label:
                spans = [run[place] for run in staging["runs"]]
                ends = np.median([span[1] if span else 0.0 for span in spans])
                assert ends == pytest.approx(lanes[name, "server killed", label], abs=0.006)


@pytest.mark.parametrize("name", CHOSEN)
def test_dials_have_a_value_for_each_setting(name: str) -> None:
    chosen = stored("choose", name)
    settings = int(np.prod([len(dial["values"]) for dial in chosen["dials"]]))
    assert settings > 10
    for bar in chosen["bars"]:
        assert len(bar["values"]) == settings
        known = [value for value in bar["values"] if value is not None]
        assert len(set(known)) > 1
        assert min(known) < chosen["most"]
    for dial in chosen["dials"]:
        assert dial["start"] < len(dial["values"])


def test_nav2_bars_are_the_utilization_of_the_package() -> None:
    chosen = stored("choose", "05_nav2")
    robots, parts = ([int(value) for value in dial["values"]] for dial in chosen["dials"])
    for bar in chosen["bars"]:
        needs = [
            float(ds.utilization(ds.PROTOCOLS[bar["name"]], n, k, 678 / k))
            for n in robots
            for k in parts
        ]
        assert bar["values"] == pytest.approx(needs, rel=5e-3)


def test_the_network_sends_what_the_equations_count() -> None:
    for protocol in stored("network", NETWORK)["protocols"]:
        loads = {
            m.name: float(m.load(ds.Fleet.swarm(3, 2, 2)))
            for m in ds.PROTOCOLS[protocol["name"]].messages
        }
        kinds = [kind["name"] for kind in protocol["kinds"]]
        sent = [kinds[message[0]] for message in protocol["messages"]]
        assert {kind: sent.count(kind) for kind in kinds} == loads
        assert {*kinds} <= {*chain(*enumeration._KINDS_BY_PHASE.values())}
        for kind, sender, receiver, about in protocol["messages"]:
            assert (receiver is None) == (kinds[kind] in ("SPDP", "Scout"))
            assert receiver is None or receiver // 2 != sender // 2  # on another robot
            assert bool(about) == ("{about}" in protocol["kinds"][kind]["says"])


# ---- in a browser ----


@pytest.fixture
def context(browser: Browser) -> Iterator[BrowserContext]:
    with browser.new_context(viewport=DESKTOP, color_scheme="light", offline=True) as context:
        yield context


def put(tab: Page, swarm: tuple[int, int, int]) -> None:
    labels = ("Hosts", "Processes of a host", "Endpoints of a process")
    for label, value in zip(labels, swarm, strict=True):
        tab.get_by_label(label).fill(str(value))


@pytest.mark.book
def test_blocks_and_terms_are_as_large_as_the_package_says(
    context: BrowserContext, book: Path
) -> None:
    tab = opened(context, book, BLOCK_LIMITS)
    told = tab.locator("#fig-blocks .line-told")
    assert told.get_attribute("role") == "status"
    expect(told).to_contain_text("7 robots with 2 processes of 10 endpoints need")
    for swarm in SWARMS:
        put(tab, swarm)
        needs = {p.name: float(ds.utilization(p, *swarm)) for p in (ds.DDS, ds.ZENOH)}
        text = f"{seconds(needs['DDS'])} with DDS and {seconds(needs['Zenoh'])} with Zenoh."
        expect(told).to_contain_text(text)
        fit = [name for name, need in needs.items() if need <= 1]
        verdict = {0: "Neither fits", 1: f"Only {''.join(fit)} fits", 2: "Both fit"}[len(fit)]
        expect(told).to_contain_text(f"{verdict} within one second.")
        second = tab.locator(".blocks-line").evaluate("line => parseFloat(line.style.bottom)")
        stacks = tab.locator(".blocks-stack").all()
        for protocol, stack in zip((ds.DDS, ds.ZENOH), stacks, strict=True):
            rows = ds.breakdown(protocol, *swarm)[["uplink_s", "downlink_s"]].to_numpy().ravel()
            parts = stack.locator(".blocks-block").evaluate_all(
                "blocks => blocks.map(({style}) => [style.bottom, style.height].map(parseFloat))"
            )
            assert [high / second for _, high in parts] == pytest.approx(list(rows), abs=1e-4)
            below = [0.0, *np.cumsum(rows)[:-1]]
            assert [low / second for low, _ in parts] == pytest.approx(below, abs=1e-4)
            assert sum(rows) * second < 100.01  # all of it is on the picture, and the line
        assert second < 100
    put(tab, (8, 2, 10))
    tab.get_by_label("Zenoh", exact=True).check()
    rows = ds.breakdown(ds.ZENOH, 8, 2, 10)
    for name, row in rows.iterrows():
        term = tab.locator(".blocks-terms button", has_text=re.compile(f"^{name} "))
        airtime = row["uplink_s"] + row["downlink_s"]
        once = 1e6 * row["uplink_s"] / row["uplink_messages"]
        expect(term).to_contain_text(seconds(airtime))
        term.focus()
        tab.keyboard.press("Enter")
        expect(term).to_have_attribute("aria-pressed", "true")
        worked = tab.locator(".blocks-worked")
        expect(worked).to_contain_text(f"= {row['uplink_messages']:,.0f} × (")
        expect(worked).to_contain_text(f"{once:.0f} µs up")
        expect(worked).to_contain_text(f"= {seconds(airtime)}")


@pytest.mark.book
def test_each_symbol_explains_itself(context: BrowserContext, book: Path) -> None:
    tab = opened(context, book, BLOCK_LIMITS)
    put(tab, (9, 3, 12))
    tip = tab.locator(".blocks-tip")
    now = {"N_H": "9", "N_P": "3", "N_E": "12"}
    symbols = stored("blocks", BLOCK_LIMITS)["symbols"]
    seen = set()
    for protocol in ("DDS", "Zenoh"):
        tab.get_by_label(protocol, exact=True).check()
        for term in tab.locator(".blocks-terms button").all():
            term.click()
            tab.mouse.move(0, 0)  # or a symbol that appears below it would explain itself
            for button in tab.locator(".blocks-symbol").all():
                name = button.get_attribute("data-symbol") or ""
                seen.add(name)
                meaning, value = symbols[name]
                text = f"{name.replace('_', '')}: {meaning}. Now {value or now[name]}."
                button.focus()
                expect(tip).to_have_text(text)
                assert button.text_content() == text  # its name, for a screen reader
    assert seen == set(symbols)
    tab.locator(".blocks-symbol").last.hover()
    expect(tip).to_contain_text("R_uni".replace("_", ""))
    tab.locator(".blocks-block").nth(1).dispatch_event("click")
    expect(tab.locator(".blocks-term b")).to_have_text("SPDP")


def kill_page(context: BrowserContext, book: Path, motion: str) -> Page:
    tab = context.new_page()
    tab.emulate_media(reduced_motion="reduce" if motion == "reduce" else "no-preference")
    tab.goto((book / "notebooks" / f"{FAILURES}.html").as_uri())
    return tab


@pytest.mark.book
def test_who_hears_whom_is_said_as_it_was_measured(context: BrowserContext, book: Path) -> None:
    tab = kill_page(context, book, "reduce")
    told, clock = tab.locator(".line-told"), tab.get_by_label("Time since the failure")
    expect(told).to_have_text("Before the failure. All running robots hear each other.")
    looked = 0
    for name, case, staging in cases():
        tab.get_by_label(case["title"], exact=True).check()
        place = case["stagings"].index(staging)
        tab.get_by_label("Outage:").select_option(index=place)
        for run in (0, len(staging["runs"]) - 1):
            tab.get_by_label("Run of the lab").fill(str(run + 1))
            changes = [t for span in staging["runs"][run] if span for t in span if t is not None]
            around = [round(time, 1) + step for time in changes for step in (-0.1, 0.2)]
            for time in {0.1, staging["end"], *around}:
                shown = f"{max(time, -5):.1f}"
                clock.fill(shown)
                pairs = pairs_apart(name, staging["event"], run + 1, float(shown))
                names = [text for one, other, text in case["relations"] if (one, other) in pairs]
                text = told.inner_text()
                if not names:
                    said = "All running robots hear each other."
                    assert text.endswith(said), (name, run, time, text)
                else:
                    deaf = text.partition("Not hearing each other: ")[2].removesuffix(".")
                    assert [one.lower() for one in deaf.split("; ")] == [x.lower() for x in names]
                solid = tab.locator(".failures-link.failures-not").count()
                assert (solid > 0) == bool(names)
                looked += 1
    assert looked > 80


@pytest.mark.book
def test_events_say_what_never_came_back(context: BrowserContext, book: Path) -> None:
    tab = kill_page(context, book, "reduce")
    tab.get_by_label("Outage:").select_option(label="3 s; late joiner starts at 15 s")
    run = tab.get_by_label("Run of the lab")
    assert run.get_attribute("max") == "25"
    never = 0
    for number in range(1, 26):
        run.fill(str(number))
        found = tab.locator(".failures-events").inner_text()
        never += "have not heard each other in 55 s" in found
    assert never == 4
    whole = tab.locator(".failures-whole")
    expect(whole).to_contain_text("hear each other in 21 of 25 runs, 1.0 to 1.2 s after the start.")
    expect(whole).to_contain_text("Robots 1 to 4: not disturbed in 25 of 25 runs.")
    tab.get_by_label("central Zenoh router").check()
    expect(whole).to_contain_text("again in 5 of 5 runs, 2.1 to 2.2 s after the router is back.")


@pytest.mark.book
def test_the_button_kills_and_the_clock_runs(context: BrowserContext, book: Path) -> None:
    tab = kill_page(context, book, "")
    tab.clock.install()
    tab.goto((book / "notebooks" / f"{FAILURES}.html").as_uri())
    clock = tab.get_by_label("Time since the failure")
    tab.get_by_role("button", name="Kill the server").click()
    tab.clock.run_for(5000)
    assert 15 < float(clock.input_value()) < 30
    expect(tab.locator(".failures-server.failures-down")).to_have_count(1)
    tab.get_by_role("button", name="Pause").click()
    stood = clock.input_value()
    tab.clock.run_for(2000)
    assert clock.input_value() == stood
    tab.get_by_role("button", name="Continue").click()
    tab.clock.run_for(20000)
    assert float(clock.input_value()) == 90
    expect(tab.locator(".failures-server.failures-down")).to_have_count(0)
    tab.get_by_role("button", name="Start again").click()
    expect(tab.get_by_role("button", name="Kill the server")).to_be_visible()


@pytest.mark.book
def test_without_motion_the_reader_goes_from_event_to_event(
    context: BrowserContext, book: Path
) -> None:
    tab = kill_page(context, book, "reduce")
    clock = tab.get_by_label("Time since the failure")
    tab.get_by_role("button", name="Kill the server").press("Enter")
    tab.wait_for_timeout(300)
    assert float(clock.input_value()) == 0
    times = [0.0]
    step = tab.get_by_role("button", name="Next event")
    while step.is_enabled():
        step.press("Enter")
        times.append(float(clock.input_value()))
    assert times == [0.0, 30.0, 55.0, 56.6]
    expect(tab.locator(".failures-now")).to_contain_text("Late joiner and robots 1 to 4 hear")


@pytest.mark.book
@pytest.mark.parametrize("name", [BLOCK_LIMITS, FAILURES])
def test_on_paper_and_without_scripts_the_still_stands(
    browser: Browser, context: BrowserContext, book: Path, name: str
) -> None:
    figure = {BLOCK_LIMITS: "#fig-blocks", FAILURES: "#fig-deaths"}[name]
    tab = opened(context, book, name)
    image, added = tab.locator(f"{figure} img"), tab.locator(f"{figure} .line-controls")
    expect(added).to_be_visible()
    expect(image).to_be_hidden()
    if name == FAILURES:
        fold = tab.get_by_role("button", name="Show all cases in one figure")
        fold.click()
        expect(image).to_be_visible()
        tab.get_by_role("button", name="Hide the figure of all cases").click()
        expect(image).to_be_hidden()
    tab.emulate_media(media="print")
    expect(image).to_be_visible()
    expect(added).to_be_hidden()
    with browser.new_context(java_script_enabled=False) as without:
        plain = opened(without, book, name)
        expect(plain.locator(f"{figure} img")).to_be_visible()
        expect(plain.locator(".line-controls")).to_have_count(0)


@pytest.mark.book
@pytest.mark.parametrize("name", [BLOCK_LIMITS, FAILURES])
def test_nothing_serious_keeps_anyone_out(
    open_tab: Callable[..., AbstractContextManager[Page]], book: Path, name: str
) -> None:
    address = (book / "notebooks" / f"{name}.html").as_uri()
    with open_tab(address, DESKTOP, reduced_motion="reduce") as tab:
        tab.evaluate(AXE)
        barriers = BARRIERS.replace("document,", "document.querySelector('.line-controls'),")
        for scheme, size in (("light", SMALLEST), ("dark", DESKTOP)):
            show(tab, scheme, size)  # type: ignore[arg-type]
            if name == FAILURES:  # the most there is to see
                tab.get_by_label("Zenoh router on each robot").check()
                tab.get_by_label("Time since the failure").fill("75")
            assert tab.evaluate(barriers, {}) == []
            assert tab.evaluate("document.documentElement.scrollWidth") == size["width"]


@pytest.mark.book
def test_the_network_is_clicked_through(context: BrowserContext, book: Path) -> None:
    tab = opened(context, book, NETWORK)
    told = tab.locator(".choose .line-told")
    expect(told).to_have_text(
        "Message 1 of 150: robot 1, process 1 announces itself to all processes on the other "
        "robots (SPDP)."
    )
    assert tab.locator(".network-head").count() == 1 + 4  # up, and down to all who hear it
    tab.get_by_role("button", name="Back").is_disabled()
    step = tab.get_by_role("button", name="Next message")
    for _ in range(6):
        step.press("Enter")
    expect(told).to_contain_text("Message 7 of 150: robot 2, process 1 announces its endpoint 1")
    assert tab.locator(".network-head").count() == 1 + 1
    expect(tab.locator(".network-counts")).to_contain_text("SPDP 6")
    tab.get_by_label("Message:").fill("150")
    expect(step).to_be_disabled()
    expect(tab.locator(".network-counts")).to_contain_text("SEDP 48")
    tab.get_by_label("Protocol:").select_option(label="Zenoh")
    expect(told).to_contain_text("Message 1 of 126: ")


@pytest.mark.book
@pytest.mark.parametrize("name", ["05_nav2", "15b_what_to_change"])
def test_dials_and_boxes_set_the_bars(context: BrowserContext, book: Path, name: str) -> None:
    tab = opened(context, book, name)
    chosen, box = stored("choose", name), tab.locator(".choose")
    places = [dial["start"] for dial in chosen["dials"]]
    for i, dial in enumerate(chosen["dials"]):
        places[i] = len(dial["values"]) - 1
        control = box.get_by_label(dial["label"])
        control.check() if dial["values"] == ["no", "yes"] else control.fill(str(places[i]))
        place = int(np.ravel_multi_index(places, [len(d["values"]) for d in chosen["dials"]]))
        for bar, row in zip(chosen["bars"], box.locator(".choose-bar").all(), strict=True):
            expect(row).to_contain_text(bar["name"])
            value, most = bar["values"][place], chosen["most"]
            shown = float(row.locator(".choose-value").inner_text().split()[0].replace(",", ""))
            assert shown == pytest.approx(value, rel=0.06)
            wide = row.locator(".choose-fill").evaluate("fill => parseFloat(fill.style.width)")
            assert wide == pytest.approx(100 * min(1, value / most), abs=0.1)


@pytest.mark.book
@pytest.mark.parametrize("name", [NETWORK, "05_nav2"])
def test_what_is_chosen_keeps_no_one_out_and_stays_off_paper(
    open_tab: Callable[..., AbstractContextManager[Page]], book: Path, name: str
) -> None:
    address = (book / "notebooks" / f"{name}.html").as_uri()
    with open_tab(address, DESKTOP, reduced_motion="reduce") as tab:
        tab.evaluate(AXE)
        barriers = BARRIERS.replace("document,", "document.querySelector('.choose'),")
        for scheme, size in (("light", SMALLEST), ("dark", DESKTOP)):
            show(tab, scheme, size)  # type: ignore[arg-type]
            assert tab.evaluate(barriers, {}) == []
            assert tab.evaluate("document.documentElement.scrollWidth") == size["width"]
        tab.emulate_media(media="print")
        expect(tab.locator(".choose")).to_be_hidden()
