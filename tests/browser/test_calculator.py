"""The calculator page: it says what the package says, refuses what it refuses, and is quick."""

import contextlib
import csv
import functools
import gzip
import io
import json
import math
import random
import re
import shlex
import statistics
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any
from urllib.parse import parse_qsl, urlsplit

import numpy as np
import pytest
import simulated_once
import sympy as sp
from click.testing import CliRunner, Result
from playwright.sync_api import Browser, Page, expect
from support import HELPERS, ROOT
from test_pages import AXE, BARRIERS

import discostorm as ds
from discostorm import drain_times, prediction_error, wording
from discostorm.cli import main
from discostorm.cli.calculator_link import calculator_link
from discostorm.data import data_path, read_data
from discostorm.fleet import COUNTS
from discostorm.robots import laptop, robots
from discostorm_planner import answer_text, simulation_jobs
from discostorm_planner.calculator import HEADER, inputs, model_js, offered_changes
from discostorm_planner.calculator.offered_changes import name_by_release
from discostorm_planner.changes import Setting
from discostorm_planner.further_loads import RebootAirtime, reboot_airtime
from discostorm_planner.multi_cell_plan import plan_cells
from discostorm_planner.result import simulate_protocols

pytestmark = pytest.mark.book

DRIVER = (HELPERS / "calculator.js").read_text(encoding="utf-8")
OWN = ("unicast_rate", "unicast_overhead", "multicast_rate", "multicast_overhead")

MODEL_JS = ROOT / "book" / "_static" / "calculator" / "model.js"
PROTOCOLS = ds.PROTOCOLS

PARTS = [row for row in read_data("fleets/robots.csv") if row["nodes"] != "0"]
ENDPOINTS_OF_A_NODE = sum(int(row["endpoints"]) for row in PARTS) / sum(
    int(row["nodes"]) for row in PARTS
)

CHANNELS = {"paper": ds.PAPER, **ds.WIFI}


def test_formulas_are_fresh() -> None:
    kept = MODEL_JS.read_text(encoding="utf-8")
    if not kept.startswith(HEADER.format(sp.__version__)):
        pytest.skip(f"sympy {sp.__version__} may order the same sums otherwise")
    assert kept == model_js(), "make calculator"


def test_formulas_were_written_by_the_locked_sympy() -> None:
    lock = (ROOT / "requirements.lock").read_text(encoding="utf-8")
    (locked,) = (
        line.split("==")[1].split()[0] for line in lock.splitlines() if line.startswith("sympy==")
    )
    kept = MODEL_JS.read_text(encoding="utf-8")
    assert kept.startswith(HEADER.format(locked))


# ---- what the package says of a setting ----


def channel(entries: dict[str, str]) -> ds.Wifi:
    if entries["wifi"] != "own":
        return CHANNELS[entries["wifi"]]
    uni, uni_overhead, multi, multi_overhead = (float(entries[name]) for name in OWN)
    return ds.Wifi(
        "own", ds.Link(uni * 1e6, uni_overhead * 1e-6), ds.Link(multi * 1e6, multi_overhead * 1e-6)
    )


def beside(entries: dict[str, str]) -> ds.Fleet | None:
    if entries["beside"] == "none":
        return None
    if entries["beside"] == "laptop":
        counts = (float(entries["beside_hosts"]), *laptop().counts()[1:])
    else:
        counts = tuple(float(entries[f"beside_{name}"]) for name in COUNTS)
    operators = laptop().nodes if entries["beside"] == "laptop" else None
    return ds.Fleet((of_ros2(counts, operators),), float(entries["matching"]))


def of_ros2(counts: Sequence[float], nodes: float | None) -> ds.HostGroup:
    """A group with what ROS 2 shares: two endpoints of a process and two of a node, if it has.

    If nobody says how many nodes it has, it has one for as many endpoints as ready-made ones have.
    """
    endpoints = counts[2]
    likely = max(1, endpoints / ENDPOINTS_OF_A_NODE) if endpoints >= 12 else 0
    shared = 2 + 2 * (likely if nodes is None else nodes)
    return ds.HostGroup(*counts, nodes=nodes, shared=min(endpoints, shared))


def fleet_of(entries: dict[str, str], hosts: float | None = None) -> ds.Fleet:
    ready = robots().get(entries["robot"])
    counts = [hosts or float(entries["hosts"])]
    counts += [float(entries[name]) for name in ("processes", "endpoints")]
    group, others = of_ros2(counts, ready.nodes if ready else None), beside(entries)
    return ds.Fleet((group, *(others.groups if others else ())), float(entries["matching"]))


WINDOWS: dict[str, Callable[[ds.Protocol], float]] = {
    "second": lambda _: 1.0,
    "lease": lambda protocol: protocol.lease,
    "ever": lambda _: math.inf,
}


def full_ampdus(wifi: ds.Wifi) -> ds.Wifi | None:
    """Return the channel with 64 frames in an exchange, of each radio from 802.11n on."""
    if wifi.radio is None or wifi == ds.PAPER or wifi.radio.standard in ("802.11a", "802.11g"):
        return None
    return replace(wifi.radio, mpdus=64).wifi()


def compared(entries: dict[str, str], name: str, wifi: ds.Wifi) -> dict[str, float]:
    """Return how long a start takes and how many hosts fit with a table on a channel."""
    protocol, fleet, one = PROTOCOLS[name], fleet_of(entries), fleet_of(entries, 1)
    numbers = {f"{name} drain": float(drain_times.drain_time(protocol, fleet, wifi=wifi))}
    if protocol.repeats:
        numbers[f"{name} steady"] = float(
            ds.utilization(protocol, fleet, wifi=wifi, window=math.inf)
        )
    for window, length in WINDOWS.items():
        seconds = length(protocol)
        if window == "lease" and seconds == math.inf:
            continue
        full = math.nan
        if ds.utilization(protocol, one, wifi=wifi, window=seconds) <= 1:
            full = float(ds.saturation_hosts(protocol, wifi=wifi, fleet=one, window=seconds))
        numbers[f"{name} saturation {window}"] = full
    return numbers


def expected(entries: dict[str, str], names: Iterable[str] = PROTOCOLS) -> dict[str, float]:
    """Return the numbers that the page should show for these entries, but the remedies'.

    Of the middleware chosen, and how many hosts fit and how long a start takes with each of some;
    where that differs also with full A-MPDUs.
    """
    fleet, wifi = fleet_of(entries), channel(entries)
    numbers: dict[str, float] = {}
    for name in names:
        single = compared(entries, name, wifi)
        numbers |= single
        full = full_ampdus(wifi)
        best = compared(entries, name, full) if full else {}
        for of, value in best.items():
            if value != single[of] and not (math.isnan(value) and math.isnan(single[of])):
                numbers[f"{of} full"] = value
    front = entries["middleware"]
    protocol = PROTOCOLS[front]
    numbers[f"{front} utilization"] = float(ds.utilization(protocol, fleet, wifi=wifi))
    for message, row in ds.breakdown(protocol, fleet, wifi=wifi).iterrows():
        sent = protocol.message(str(message))
        # What a wired host sends is not on the way up, but sent.
        count = sent.per_unit * sent.schedule.mean(1.0) * float(sent.unit.count(fleet))
        assert row["uplink_messages"] == pytest.approx(count if "up" in sent.hops else 0)
        numbers[f"{front} {message} messages"] = count
        numbers[f"{front} {message} airtime"] = row["uplink_s"] + row["downlink_s"]
    again = reboot_of(entries)
    if again is not None:
        numbers |= {f"{front} reboot low": again.low, f"{front} reboot high": again.high}
    return numbers


def reboot_of(entries: dict[str, str]) -> RebootAirtime | None:
    wifi = channel(entries)
    mpdus = 64 if full_ampdus(wifi) else 1
    return reboot_airtime(Setting(fleet_of(entries), PROTOCOLS[entries["middleware"]], wifi, mpdus))


def random_settings(many: int) -> list[dict[str, str]]:
    """Return entries that go through all channels and far beyond any fleet."""
    chance = random.Random(20)

    def some(low: float, high: float, zero: bool = False, whole: bool = False) -> str:
        if zero and chance.random() < 0.1:
            return "0"
        kind = chance.random()
        if kind < 0.5:
            return str(chance.randint(math.ceil(low), min(50, int(high))))
        value = math.exp(chance.uniform(math.log(max(low, 1e-3)), math.log(high)))
        return repr(
            value if kind < 0.75 and not whole else float(max(math.ceil(low), round(value)))
        )

    names = [*CHANNELS, "own", "own"]
    neighbors = [chance.choice(("none", "laptop", "own")) for _ in range(many)]
    return [
        {
            "robot": "own",
            "middleware": chance.choice(list(PROTOCOLS)),
            "hosts": some(1, 1e9 if number % 5 == 0 else 100, whole=True),
            "processes": some(1, 1e9 if number % 7 == 0 else 20, whole=True),
            "endpoints": some(0, 1e9 if number % 7 == 0 else 1000, zero=True),
            "beside": neighbors[number],
            # Where all match, Python solves for hosts only beside a fleet that says so.
            "matching": "0" if neighbors[number] == "none" else chance.choice("01"),
            "beside_hosts": some(1, 100, whole=True),
            "beside_processes": some(1, 20, whole=True),
            "beside_endpoints": some(0, 1000, zero=True),
            "wifi": names[number % len(names)],
            "unicast_rate": some(0.1, 1e4),
            "unicast_overhead": some(0, 1e3, zero=True),
            "multicast_rate": some(0.1, 1e3),
            "multicast_overhead": some(0, 1e3, zero=True),
        }
        for number in range(many)
    ]


# ---- the page ----


@pytest.fixture(scope="module")
def address(book: Path) -> str:
    return (book / "book" / "calculator.html").as_uri()


@pytest.fixture(scope="module")
def opened(browser: Browser, address: str) -> Iterator[tuple[Page, list[str]]]:
    """Return the page as opened from the file system, and what goes wrong on it."""
    errors: list[str] = []
    with browser.new_context(reduced_motion="reduce", accept_downloads=True) as context:
        page = context.new_page()
        page.on("pageerror", lambda error: errors.append(str(error)))
        page.on("console", lambda line: errors.append(line.text) if line.type == "error" else None)
        page.add_init_script(DRIVER)
        page.goto(address)
        yield page, errors


@pytest.fixture
def tab(opened: tuple[Page, list[str]]) -> Iterator[Page]:
    """Return the page as it starts, but unfolded; nothing may go wrong on it."""
    page, errors = opened
    page.set_viewport_size({"width": 1280, "height": 800})
    page.get_by_role("button", name="Reset").click()
    page.locator("#calc-behind").evaluate("e => e.open = true")
    page.evaluate("document.activeElement.blur()")
    yield page
    assert not errors


def link(tab: Page) -> str:
    """Return the address of the answer that is shown, once the tab has it."""
    wanted: str = tab.locator("#calc-link").evaluate("e => e.href")
    tab.wait_for_url(wanted)
    return wanted


def shown(tab: Page) -> dict[str, float]:
    return without_simulated(tab.evaluate("calculatorTest.shown()"))


def without_simulated(numbers: dict[str, str]) -> dict[str, float]:
    return {name: float(value) for name, value in numbers.items() if not is_simulated(name)}


def is_simulated(name: str) -> bool:
    return name.startswith("simulated ")


def put(tab: Page, entries: dict[str, str]) -> None:
    tab.evaluate("entries => calculatorTest.fill(entries)", entries)


ROBOT = robots()[inputs.DEFAULT_ROBOT]
START = {
    "robot": ROBOT.name,
    "middleware": inputs.DEFAULT_MIDDLEWARE,
    "hosts": "5",
    "processes": f"{ROBOT.processes:g}",
    "endpoints": f"{ROBOT.endpoints:g}",
    "beside": "laptop",
    "beside_hosts": "1",
    "matching": "0",
    "wifi": "paper",
    "within": "60",
    "cells": "1",
    "cable": "0",
    "security": "0",
    "start": "together",
}
#: The swarm of Fig. 2 at its largest.
PAPER = {
    **START,
    "robot": "The paper's swarm",
    "middleware": "DDS",
    "hosts": "7",
    "processes": "2",
    "endpoints": "10",
    "beside": "none",
}
FEW = {"robot": "own", "processes": "1", "endpoints": "4"}


def same(numbers: dict[str, float]) -> Any:
    return pytest.approx(numbers, rel=1e-9, abs=0, nan_ok=True)


def test_says_what_python_says(tab: Page) -> None:
    settings = random_settings(300)
    answers = tab.evaluate("settings => calculatorTest.run(settings)", settings)
    models = {channel(entries).model for entries in settings}
    assert models == {"linear", "padded"}
    kinds = set()
    for number, (entries, answer) in enumerate(zip(settings, answers, strict=True)):
        shown = without_simulated(answer["shown"])
        if number % 5:  # each channel in turn, and what is chosen alone, for the sake of time
            wanted = expected(entries, [entries["middleware"]])
            assert {name: shown[name] for name in wanted} == same(wanted), entries
            continue
        wanted = expected(entries)
        assert shown == same(wanted), entries
        kinds.add(
            (math.isnan(wanted["DDS saturation second"]), wanted["Fast DDS drain"] == math.inf)
        )
    # All that can happen: one host fits into the second or does not, and drains or never does.
    assert len(kinds) == 4


def test_answers_within_50_ms(tab: Page) -> None:
    # Processor time of the page, as other tests keep the machine busy: script, layout and painting.
    session = tab.context.new_cdp_session(tab)
    session.send("Performance.enable", {"timeDomain": "threadTicks"})

    def busy() -> float:
        metrics = session.send("Performance.getMetrics")["metrics"]
        return next(float(of["value"]) for of in metrics if of["name"] == "TaskDuration")

    took = []
    for hosts in (8, 9, 30, 400, 5, 1, 2, 3, 1e9, 12, 15):
        began = busy()
        tab.evaluate("hosts => calculatorTest.untilPainted(hosts)", str(hosts))
        took.append(busy() - began)
    session.detach()
    assert 0 < statistics.median(took) < 0.05


@pytest.mark.parametrize(
    ("entries", "beyond"),
    [
        ({**START, "middleware": "Fast DDS"}, True),  # 678 endpoints
        ({**PAPER, "middleware": "Fast DDS"}, True),  # 14 processes
        ({**PAPER, "middleware": "Fast DDS", "hosts": "6"}, False),
        ({**PAPER, "middleware": "Fast DDS", "hosts": "6", "beside": "laptop"}, True),
        ({**PAPER, "hosts": "100"}, False),  # the paper's table was fitted to nothing
    ],
)
def test_says_where_a_products_table_is_extrapolated(
    tab: Page, entries: dict[str, str], beyond: bool
) -> None:
    put(tab, entries)
    hosts, processes, _ = PROTOCOLS["Fast DDS"].captured or (0, 0, 0)
    told = f"captures of up to {hosts} hosts and {processes} processes with up to 60 endpoints each"
    said = tab.locator("#calc-numbers").inner_text().replace("\u00a0", " ")
    assert (told in said) == (entries["middleware"] == "Fast DDS")
    assert ("numbers are extrapolated" in said) == beyond


#: Beside few robots; they have more processes.
OTHERS = {"beside_hosts": "2", "beside_processes": "9", "beside_endpoints": "30"}
#: Within the measured range, up to twice, beyond it, with many endpoints, and nothing held out.
BANDS = [
    {**PAPER, "hosts": "6"},
    {**PAPER, "hosts": "8"},
    {**PAPER, "hosts": "80"},
    START,
    {**START, "hosts": "2", "beside": "none"},
    {**PAPER, "hosts": "6", "beside": "laptop"},
    {**START, "hosts": "50", "endpoints": "1e6"},
    {**PAPER, "hosts": "5", "wifi": "802.11ac 80 MHz 2x2"},
    {**PAPER, "hosts": "3", "matching": "1", "beside": "own", **OTHERS},
]


@pytest.mark.parametrize("entries", BANDS)
@pytest.mark.parametrize("middleware", ["Fast DDS", "Cyclone DDS", "Zenoh peer", "Zenoh router"])
def test_says_the_error_band_and_the_reboot_of_the_plan(
    tab: Page, entries: dict[str, str], middleware: str
) -> None:
    entries = {**entries, "robot": "own", "middleware": middleware}
    put(tab, entries)
    said = tab.locator("#calc-numbers").inner_text().replace("\u00a0", " ")
    table, fleet = PROTOCOLS[middleware], fleet_of(entries)
    assert table.captured is not None
    band = prediction_error.error_band(middleware, fleet, table.captured)
    assert band is not None
    assert band.sentence() in said
    again = reboot_of(entries)
    assert (again is None) == (middleware not in ("Fast DDS", "Cyclone DDS"))
    if again is None:
        assert "reboots" not in said
        return
    own = again.group == fleet.names[0]
    who = "robot" if own else "laptop" if entries["beside"] == "laptop" else "other"
    (took,) = re.findall(rf"One {who} reboots: (.*) of airtime\.", said)
    plans = wording.time_range(again.low, again.high)
    assert took.split()[-1] == plans.split()[-1]  # the page rounds to two digits
    numbers = [[float(n) for n in re.findall(r"[\d.]+", text)] for text in (took, plans)]
    assert numbers[0] == pytest.approx(numbers[1], rel=0.1)
    exactly = shown(tab)
    assert exactly[f"{middleware} reboot low"] == pytest.approx(again.low, rel=1e-9)
    assert exactly[f"{middleware} reboot high"] == pytest.approx(again.high, rel=1e-9)


def test_the_bands_meet_all_cases() -> None:
    kinds = set()
    for entries in BANDS:
        fleet = fleet_of({**entries, "robot": "own"})
        band = prediction_error.error_band("Fast DDS", fleet, PROTOCOLS["Fast DDS"].captured or ())
        assert band is not None
        kinds.add((band.up_to, band.beyond))
    assert kinds >= {(1.0, False), (2.0, False), (2.0, True), (math.inf, False), (math.inf, True)}


@pytest.mark.parametrize(
    ("hosts", "words"),
    [("60", "minutes"), ("600", "hours"), ("1e4", "days"), ("1e9", "years")],
)
def test_times_are_told_in_peoples_units(tab: Page, hosts: str, words: str) -> None:
    put(tab, {**START, "middleware": "DDS", "hosts": hosts})
    expect(tab.locator("#calc-reason")).to_contain_text(f"\u00a0{words} (drain time)")
    assert "349" not in tab.locator("#calc-reason").inner_text()


def test_the_planner_tries_what_the_page_says_beside_its_own() -> None:
    page = (ROOT / "book" / "calculator.md").read_text(encoding="utf-8")
    (command,) = re.findall(r"`discostorm (plan fleet.toml[^`]*)`", page)
    command = command.replace("fleet.toml", str(data_path("fleets/nav2_laptop.toml")))
    said = CliRunner().invoke(main, [*shlex.split(command), "--json"])
    assert said.exit_code == 0, said.output
    plan = json.loads(said.output)
    kinds = {remedy["kind"] for remedy in plan["remedies"]}
    assert {"announcements", "channels", "domains"} <= kinds
    assert {len(set(found["steps"])) for found in plan["combinations"]} <= {2, 3}
    assert plan["combinations"]
    peers = ds.plan(ds.Fleet.swarm(10, 1, 678), PROTOCOLS["Zenoh peer"]).remedies
    assert "peers" in {remedy.kind for remedy in peers}


def test_a_robot_brings_its_numbers_and_where_they_are_from(tab: Page) -> None:
    for name, robot in robots().items():
        tab.get_by_label("Type of robot").select_option(name)
        expect(tab.locator("#calc-processes")).to_have_value(f"{robot.processes:g}")
        expect(tab.locator("#calc-endpoints")).to_have_value(f"{robot.endpoints:.6g}")
        expect(tab.locator("#calc-robot-list li")).not_to_have_count(0)
    tab.locator("#calc-processes").fill("3")
    expect(tab.get_by_label("Type of robot")).to_have_value("own")
    expect(tab.locator("#calc-robot-parts")).to_be_hidden()


def test_all_fields_have_labels(tab: Page) -> None:
    put(tab, {"wifi": "own", "beside": "own"})
    fields = tab.locator("#calc-form").locator("input, select")
    for name in ("Robots", "Access point", "Rate, unicast [Mbit/s]", "Processes per computer"):
        expect(tab.get_by_label(name, exact=True)).to_be_visible()
    unlabelled = fields.evaluate_all("all => all.filter(e => !e.labels.length).length")
    assert unlabelled == 0
    for group in ("Robots", "Other computers", "Middleware and Wi-Fi"):
        expect(tab.get_by_role("group", name=group)).to_be_visible()
    expect(tab.get_by_role("img", name="Your robots are a point on each curve")).to_be_visible()


def test_the_keyboard_is_enough(tab: Page) -> None:
    def go_to(name: str) -> None:
        for _ in range(90):  # the contents of the book come first
            tab.keyboard.press("Tab")
            if tab.evaluate("document.activeElement.name || document.activeElement.id") == name:
                return
        pytest.fail(f"Tab does not lead to {name}")

    go_to("hosts")
    tab.keyboard.press("ControlOrMeta+a")
    tab.keyboard.type("12")
    go_to("endpoints")
    tab.keyboard.press("ControlOrMeta+a")
    tab.keyboard.type("40.5")
    go_to("wifi")
    tab.keyboard.press("ArrowDown")
    tab.keyboard.press("ArrowDown")
    wifi = tab.locator("#calc-channel").input_value()
    assert wifi == next(iter(ds.WIFI))
    entries = {**START, "hosts": "12", "robot": "own", "endpoints": "40.5", "wifi": wifi}
    assert shown(tab) == same(expected(entries))
    go_to("calc-csv")
    with tab.expect_download() as download:
        tab.keyboard.press("Enter")
    assert download.value.suggested_filename == "discovery.csv"
    go_to("calc-reset")
    tab.keyboard.press("Enter")
    assert shown(tab) == same(expected(START))


BAD = [
    ("hosts", "0", "Robots must be a whole number of at least 1 and at most 1,000,000,000; "),
    ("hosts", "7.5", "Robots must be a whole number"),
    ("hosts", "-3", "of at least 1"),
    ("hosts", "1e10", "at most 1,000,000,000; got “1e10”."),
    ("hosts", "ten", "got “ten”."),
    ("hosts", "", "the field is empty"),
    ("hosts", "1,5", "got “1,5”."),
    ("hosts", "1,0000", "got “1,0000”."),
    ("hosts", "NaN", "got “NaN”."),
    ("hosts", "Infinity", "got “Infinity”."),
    ("hosts", "0x10", "got “0x10”."),
    ("hosts", "<b>7</b>", "got “<b>7</b>”."),
    ("processes", "0", "Processes per robot must be a whole number of at least 1"),
    ("endpoints", "-1", "Endpoints per process must be a number of at least 0"),
    ("beside_hosts", "0.5", "Computers must be a whole number of at least 1"),
    ("unicast_rate", "0", "Rate, unicast must be a number of Mbit/s above 0; got “0”."),
    ("unicast_rate", "1e400", "above 0; got “1e400”."),
    ("unicast_overhead", "-1", "must be a number of µs of at least 0; got “-1”."),
    ("multicast_rate", "-6", "above 0"),
    ("multicast_overhead", "x", "of at least 0; got “x”."),
]


@pytest.mark.parametrize(("name", "text", "words"), BAD)
def test_bad_input_is_refused_next_to_its_field(
    tab: Page, name: str, text: str, words: str
) -> None:
    put(tab, {"wifi": "own" if name in OWN else "paper"})
    before, url = shown(tab), link(tab)
    stale = tab.get_by_text("Fix the highlighted field.")
    expect(stale).to_be_hidden()
    field = tab.locator(f"#calc-{name}")
    good = field.input_value()
    error = tab.locator(f"#calc-{name}-error")
    expect(error).to_be_empty()
    field.fill(text)
    expect(error).to_contain_text(words)
    expect(error).to_have_attribute("role", "alert")
    expect(field).to_have_attribute("aria-invalid", "true")
    assert f"calc-{name}-error" in (field.get_attribute("aria-describedby") or "")
    expect(stale).to_be_visible()
    expect(tab.locator("#calc-answer")).to_have_css("filter", "grayscale(1)")
    assert shown(tab) == same(before)  # the last good answer
    assert link(tab) == url
    field.fill(good)
    expect(error).to_be_empty()
    expect(field).not_to_have_attribute("aria-invalid", "true")
    expect(stale).to_be_hidden()
    expect(tab.locator("#calc-answer")).to_have_css("filter", "none")


@pytest.mark.parametrize(
    ("name", "text"),
    [
        (name, text)
        for name, text, _ in BAD
        if text not in {"", "ten", "1,5", "1,0000", "7.5", "0x10", "<b>7</b>", "x"}
    ],
)
def test_python_refuses_the_same(name: str, text: str) -> None:
    own = {f"beside_{count}": "1" for count in COUNTS}
    entries = {**START, **own, **dict.fromkeys(OWN, "1"), "wifi": "own", name: text}
    with pytest.raises(ValueError, match="must be a finite number"):
        expected(entries)


@pytest.mark.parametrize(
    ("name", "text", "meant"),
    [
        ("hosts", "1", "1"),
        ("hosts", "1e9", "1e9"),
        ("hosts", " 2.0 ", "2"),
        ("hosts", "+3", "3"),
        ("hosts", "1,000", "1000"),
        ("hosts", "1 000 000", "1e6"),
        ("endpoints", "1,234.5", "1234.5"),
        ("endpoints", "0", "0"),
        ("endpoints", ".5", ".5"),
        ("unicast_rate", "1e-3", "1e-3"),
        ("unicast_overhead", "0", "0"),
    ],
)
def test_numbers_may_be_written_as_people_do(tab: Page, name: str, text: str, meant: str) -> None:
    own = dict(zip(OWN, ("144.4", "180", "6", "120"), strict=True))
    entries = {**START, **own, "robot": "own", "wifi": "own", name: text}
    put(tab, entries)
    expect(tab.locator(".calc-error:not(:empty)")).to_have_count(0)
    assert shown(tab) == same(expected({**entries, name: meant}))


# ---- on a radio that aggregates ----


RANGES = [
    {**START, "robot": "own", "endpoints": "300"},
    {**START, "matching": "1"},
    {**START, "wifi": "802.11ax 80 MHz 2x2"},
    {**START, "hosts": "40", "middleware": "Zenoh router"},
    {**START, "hosts": "2", "robot": "own", "processes": "1", "endpoints": "10"},
    START,
    {**START, "hosts": "4", "beside": "none"},
    {**START, "hosts": "16", "beside": "none", "middleware": "Zenoh peer"},
    {**START, "middleware": "Fast DDS Discovery Server"},
    {**START, "robot": "own", "wifi": "802.11n 20 MHz 2x2"},  # the same numbers
]


@pytest.mark.parametrize("entries", RANGES)
def test_one_answer_of_a_radio_is_the_planners(tab: Page, entries: dict[str, str]) -> None:
    ac = "802.11ac 80 MHz 2x2"
    entries = {**entries, "wifi": ac if entries["wifi"] == "paper" else entries["wifi"]}
    put(tab, entries)
    plan = ds.plan(fleet_of(entries), PROTOCOLS[entries["middleware"]], channel(entries))
    with tab.expect_download() as download:
        tab.get_by_role("button", name="CSV").click()
    text = download.value.path().read_text(encoding="utf-8")
    told = {
        (row["quantity"], row["of"]): float(row["value"])
        for row in csv.DictReader(io.StringIO(text))
        if row["protocol"] == entries["middleware"] and row["unit"] in ("s", "1")
    }
    assert told["drain time", ""] == pytest.approx(plan.startup.single, rel=1e-9)
    assert told["drain time", "full A-MPDUs"] == pytest.approx(plan.startup.full, rel=1e-9)
    assert told["utilization", "full A-MPDUs"] == pytest.approx(
        plan.utilization_range.full, rel=1e-9
    )
    both = {plan.utilization_range.full < 1, plan.utilization_range.single < 1}
    verdict = {1: "fits" if both == {True} else "does not fit", 2: "may fit"}[len(both)]
    assert plan.verdict == verdict


def test_the_ranges_meet_all_cases() -> None:
    kinds = set()
    for entries in RANGES:
        wifi = entries["wifi"].replace("paper", "802.11ac 80 MHz 2x2")
        plan = ds.plan(fleet_of(entries), PROTOCOLS[entries["middleware"]], ds.WIFI[wifi])
        kinds.add(plan.verdict)
    assert kinds == {"fits", "may fit", "does not fit"}


#: Saved links, which open with the same entries.
LINKS = [
    "wifi=paper&hosts=7&middleware=DDS",
    "wifi=802.11ac+80+MHz+2x2&middleware=Zenoh+peer",
    "wifi=802.11a+20+MHz+1x1&beside=none",
    "wifi=802.11n+20+MHz+2x2%2C+2.4+GHz&matching=1",
    "wifi=802.11be+320+MHz+2x2&robot=Manipulator+with+MoveIt&hosts=4",
    "robot=own&processes=3&endpoints=40&beside=own&beside_hosts=2&beside_processes=1"
    "&beside_endpoints=9&wifi=802.11ac+80+MHz+2x2",
    "wifi=own&unicast_rate=100&unicast_overhead=150&multicast_rate=12&multicast_overhead=90",
]


@pytest.mark.parametrize("saved", LINKS)
def test_a_saved_link_opens_with_its_entries(tab: Page, address: str, saved: str) -> None:
    tab.goto(f"{address}#{saved}")
    expect(tab.locator(".calc-error:not(:empty)")).to_have_count(0)
    for name, value in parse_qsl(saved):
        expect(tab.locator(f"#calc-form [name={name}]")).to_have_value(value)


# ---- the address ----


@pytest.mark.parametrize(
    ("name", "wired", "wanted"),
    [
        ("fast_dds_server", [], {"middleware": "Fast DDS Discovery Server", "beside": "none"}),
        ("ills/client_isolation_but_for_one-cyclone_dds_0_10", ["10.77.0.1"], {"hosts": "3"}),
        ("ills/two_domains-fast_dds", [], {"middleware": "Fast DDS", "processes": "1"}),
    ],
)
def test_the_link_of_a_capture_opens_with_its_fleet(
    tab: Page, address: str, tmp_path: Path, name: str, wired: list[str], wanted: dict[str, str]
) -> None:
    file, written = ROOT / "tests/reference/captures" / f"{name}.pcap.xz", tmp_path / "fleet.toml"
    options = [part for host in wired for part in ("--wired", host)]
    command = ["capture", str(file), "--write-fleet", str(written), *options]
    told = json.loads(CliRunner().invoke(main, [*command, "--json"]).stdout)
    printed = CliRunner().invoke(main, command).stdout
    assert f"In the calculator: {told['calculator']}" in printed.splitlines()
    assert ("cable=1" in told["calculator"]) == bool(wired)
    page, _, entries = told["calculator"].partition("#")
    assert address.endswith(page)
    tab.goto(f"{address}#{entries}")
    expect(tab.locator(".calc-error:not(:empty)")).to_have_count(0)
    for field, value in (dict(parse_qsl(entries)) | wanted).items():
        expect(tab.locator(f"#calc-form [name={field}]")).to_have_value(value)
    fleet = ds.Fleet.from_toml(written)
    (robots_,) = [group for group in fleet.groups if not group.wired]
    shown_counts = [float(tab.locator(f"#calc-{of}").input_value()) for of in COUNTS]
    assert shown_counts == list(robots_.counts())


def test_the_address_keeps_the_answer(tab: Page) -> None:
    put(tab, {"middleware": "Zenoh peer", "hosts": "12", "beside": "own"})
    tab.get_by_label("Access point", exact=True).select_option("802.11n 20 MHz 2x2")
    preset = link(tab)
    numbers = shown(tab)
    tab.get_by_label("Access point", exact=True).select_option("own")
    tab.get_by_label("Rate, multicast [Mbit/s]", exact=True).fill("24")
    own_numbers = shown(tab)
    for url, wanted in ((link(tab), own_numbers), (preset, numbers)):
        with tab.context.new_page() as other:
            other.add_init_script(DRIVER)
            other.goto(url)
            assert shown(other) == same(wanted)
            expect(other.get_by_label("Middleware", exact=True)).to_have_value("Zenoh peer")
            assert other.url == url
    assert numbers != own_numbers


def test_the_link_is_copied_and_says_so(tab: Page) -> None:
    tab.context.grant_permissions(["clipboard-read", "clipboard-write"])
    anchor = tab.locator("#calc-link")
    wanted = link(tab)
    anchor.click()
    expect(anchor).to_have_text("Copied")
    assert tab.evaluate("navigator.clipboard.readText()") == wanted
    expect(tab.locator("#calc-said")).to_have_text("Copied to the clipboard.")
    put(tab, {**SMALL, "hosts": "3"})
    simulated(tab)
    paste = tab.locator(".calc-paste")
    paste.first.locator("summary").click()
    first = paste.first.get_by_role("button").first
    first.click()
    expect(first).to_have_text("Copied")
    copied = tab.evaluate("navigator.clipboard.readText()")
    assert copied == paste.first.locator("pre").first.text_content()


def test_another_address_in_the_same_tab(tab: Page) -> None:
    tab.evaluate("location.hash = '#hosts=3&wifi=802.11a+20+MHz+1x1'")
    expect(tab.get_by_label("Robots", exact=True)).to_have_value("3")
    entries = {**START, "hosts": "3", "wifi": "802.11a 20 MHz 1x1"}
    expect(tab.locator("#calc-answer")).to_contain_text("3\u00a0robots")
    assert shown(tab) == same(expected(entries))
    tab.evaluate("location.hash = '#how-to-read-the-answer'")  # no state: nothing changes
    assert shown(tab) == same(expected(entries))
    tab.evaluate("location.hash = '#robot=One+bare+node&processes=2'")
    expect(tab.get_by_label("Type of robot")).to_have_value("own")


def test_nonsense_in_the_address_is_refused_in_words(tab: Page, address: str) -> None:
    tab.goto(address + "#hosts=lots&middleware=Pigeon&wifi=%3Cscript%3E&processes=3&x=y&%E0%A4%A")
    expect(tab.locator("#calc-hosts-error")).to_contain_text("got “lots”")
    expect(tab.locator("#calc-middleware-error")).to_contain_text("“Pigeon”, which is not in")
    expect(tab.locator("#calc-channel-error")).to_contain_text("“<script>”, which is not in")
    assert shown(tab) == same(expected(START))
    tab.get_by_label("Robots", exact=True).fill("7")
    tab.get_by_label("Middleware", exact=True).select_option("DDS")
    assert shown(tab) == same(
        expected({**START, "hosts": "7", "middleware": "DDS", "robot": "own", "processes": "3"})
    )
    tab.get_by_label("Access point", exact=True).select_option("802.11a 20 MHz 1x1")
    expect(tab.locator("#calc-channel-error")).to_be_empty()


# ---- simulated in the browser ----

#: Small robots, whose runs are short.
SMALL = {**START, **FEW, "processes": "2", "endpoints": "10", "beside": "none"}
#: Fleets that work, that need longer, that never finish, and that lose without repairs; the last
#: ones only work if a change is joined with a staggered start, or with nothing that the page tries.
SIMULATED: list[dict[str, str]] = [
    START,
    {**SMALL, "hosts": "12"},
    {**SMALL, "hosts": "12", "within": "4"},
    {**SMALL, "hosts": "20", "middleware": "Cyclone DDS", "wifi": "802.11ac 80 MHz 2x2"},
    {**SMALL, "hosts": "8", "middleware": "Zenoh peer, tokens"},
    {**START, "hosts": "8", "middleware": "Fast DDS 2.6", "wifi": "802.11n 20 MHz 2x2"},
    {**START, "hosts": "6", "middleware": "Fast DDS Discovery Server, on a robot"},
    {**SMALL, "hosts": "9", "middleware": "DDS"},
    {
        **SMALL,
        "hosts": "6",
        "endpoints": "42.1818",
        "matching": "1",
        "beside": "laptop",
        "middleware": "Zenoh router",
    },
    {**START, **FEW, "hosts": "30", "beside": "none", "middleware": "Zenoh", "within": "2.4"},
    {**START, **FEW, "hosts": "30", "beside": "none", "within": "2.3"},
    {**START, **FEW, "hosts": "30", "beside": "none", "within": "2"},
]
#: Of many processes, of which no change alone is enough.
CROWDED = {
    **SMALL,
    "hosts": "28",
    "processes": "6",
    "endpoints": "15",
    "wifi": "802.11n 20 MHz 2x2",
}


def simulated(tab: Page) -> dict[str, float]:
    """Wait for the simulated answer and return its numbers."""
    expect(tab.locator("#calc-progress")).to_be_hidden(timeout=600_000)  # on a busy machine
    numbers = tab.evaluate("calculatorTest.shown()")
    return {name: float(value) for name, value in numbers.items() if is_simulated(name)}


def words(text: str) -> str:
    return text.replace("\u00a0", " ")


@pytest.fixture(autouse=True)
def _equal_runs_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """A plan and the command's answer have the same runs."""
    monkeypatch.setattr(simulation_jobs, "_run_summary", simulated_once.summary)


@functools.cache
def plan_of(number: int) -> ds.Plan:
    """Return the plan of one of the fleets; its simulations take longer than all else here."""
    entries = SIMULATED[number]
    protocol, within = PROTOCOLS[entries["middleware"]], float(entries["within"])
    return as_on_page(ds.plan(fleet_of(entries), protocol, channel(entries), within=within))


def as_on_page(plan: ds.Plan) -> ds.Plan:
    """The page tries no sets of changes but those with a staggered start."""
    return replace(plan, combinations=())


@pytest.mark.parametrize("number", range(len(SIMULATED)))
def test_answer_and_verdict_are_the_plans(tab: Page, number: int) -> None:
    entries, plan = SIMULATED[number], plan_of(number)
    put(tab, entries)
    check_answer(tab, simulated(tab), plan)
    check_verdict(tab, entries, plan)


def test_changes_joined_with_a_staggered_start_are_tried_where_none_suffices(tab: Page) -> None:
    numbers = range(len(SIMULATED) - 3, len(SIMULATED))
    first, joined, none = (plan_of(number).discovery for number in numbers)
    assert {one.remedy.kind for one in first.sufficient} == {"combination"}
    (switched,) = joined.sufficient  # after those that need no other middleware
    assert {"middleware", "staggered start"} < set(switched.remedy.steps)
    assert not none.sufficient
    for number, told in zip(numbers, (0, 0, 1), strict=True):
        put(tab, SIMULATED[number])
        simulated(tab)
        said = tab.locator("#calc-possible").inner_text()
        assert said.count(answer_text.SENTENCES["several at once"]) == told
    put(tab, {**SIMULATED[-2], "start": "turn"})
    simulated(tab)
    assert "staggered start" not in str(tab.evaluate("calculatorTest.changes()"))


@pytest.mark.thorough
def test_the_best_change_of_many_processes_is_joined_with_a_staggered_start(tab: Page) -> None:
    put(tab, CROWDED)
    numbers = simulated(tab)
    fleet, protocol = fleet_of(CROWDED), PROTOCOLS[CROWDED["middleware"]]
    plan = as_on_page(ds.plan(fleet, protocol, channel(CROWDED)))
    check_answer(tab, numbers, plan)
    (first,) = plan.discovery.sufficient
    assert first.name == "processes + staggered start"
    expect(tab.locator("#calc-remedies li").first).to_contain_text("Composing 6 processes into ")


def check_answer(tab: Page, numbers: dict[str, float], plan: ds.Plan) -> None:
    protocol, found = plan.protocol, plan.discovery
    today = found.today
    assert today is not None
    assert numbers["simulated median"] == today.median
    assert numbers["simulated nine"] == today.nine_of_ten
    assert numbers["simulated most pairs"] == today.most_pairs_s
    after = [
        (f"simulated {' and '.join(one.remedy.steps)} of {table_of(one.remedy, protocol)}", one)
        for one in found.helpful
    ]
    # Radios that start one after the other have one name.
    assert sorted(tab.evaluate("calculatorTest.changes()")) == sorted(
        [table_name(name, protocol), one.time.median] for name, one in after if one.time
    )
    assert advice(tab) == advised(plan)
    lines = {line.partition(": ")[0].partition(". ")[2]: line for line in advised(plan)}
    for item in tab.locator("#calc-remedies li").all():
        what = words(item.inner_text()).partition(": ")[0]
        (one,) = (c for c in found.helpful if in_page_words(answer_text.describe_change(c)) == what)
        assert what in lines
        texts = [piece.text for piece in one.remedy.snippets]
        if one.start_window:
            window = f"WINDOW={one.start_window:.0f}"
            texts = [re.sub(r"(?m)^WINDOW=\d+$", window, text) for text in texts]
        expect(item.locator("pre")).to_have_text(texts)


def advice(tab: Page) -> list[str]:
    return [words(line) for line in tab.evaluate("calculatorTest.advice()")]


def advised(plan: ds.Plan) -> list[str]:
    """Return the advice of a plan, as far as the page has it in the same place."""
    blocks = answer_text._change_blocks(plan, answer_text.MAX_SHOWN_CHANGES, all_changes=False)
    lines = [in_page_words(line.partition(". Effort: ")[0]) for block in blocks for line in block]
    may_help = answer_text.SENTENCES["possible"].partition("{")[0]
    return [line for line in lines if not line.startswith(may_help)]


def in_page_words(line: str) -> str:
    of = r"(parameter services of) .* process( \(assumed\))?"
    line = re.sub(of, r"\1 the robots' nodes", line)
    line = line.replace(" hosts on this channel", " robots on this channel")
    line = line.replace("with 1 other host", "with 1 laptop")
    return wording.capitalized(line).replace(" -> ", " → ")


def table_of(remedy: ds.Remedy, protocol: ds.Protocol) -> str:
    """The page names tables of servers that forward everything by their change."""
    forwards = remedy.protocol.key is None and "discovery server" in " ".join(remedy.steps)
    what = remedy.what.removesuffix(" and starting one after the other")
    return f"{protocol.name}, {what}" if forwards else name_by_release(remedy.protocol)


def table_name(name: str, protocol: ds.Protocol) -> str:
    """The page names tables without a key by their change."""
    steps, _, table = name.partition(" of ")
    if steps.startswith("simulated announcements"):
        return f"{steps} of {protocol.name}, a longer announcement interval"
    peers = steps.startswith("simulated peers") and table.startswith("Zenoh")
    return f"{name}, static peers" if peers else name


def check_verdict(tab: Page, entries: dict[str, str], plan: ds.Plan) -> None:
    title, *lines = answer_text._verdict_lines(plan)
    said = [words(text) for text in tab.locator("#calc-answer .calc-line").all_inner_texts()]
    assert said == lines
    fleet = answer_text.describe_fleet(plan)
    own = f"{entries['hosts']} robots" + (" and 1 laptop" if entries["beside"] == "laptop" else "")
    assert words(tab.locator("#calc-answer strong").inner_text()) == title.replace(fleet, own)
    grade = tab.locator("#calc-answer").get_attribute("data-severity")
    assert (grade == "0") == title.startswith("Yes")
    assert (grade in ("2", "3")) == title.startswith(("No:", "No,"))


# ---- access points, security, and how robots start: the page's own fleet file says the same ----


def command(tab: Page, folder: Path) -> Result:
    """Run the command that the page shows on the file that it shows."""
    (folder / "fleet.toml").write_text(str(tab.locator("#calc-toml").text_content()))
    program, *arguments = shlex.split(str(tab.locator("#calc-command").text_content()))
    assert program == "discostorm"
    with contextlib.chdir(folder):
        return CliRunner().invoke(main, arguments)


def check_command(tab: Page, entries: dict[str, str], folder: Path) -> str:
    """Check that the command says all that the page says of its fleet; return what it says."""
    result = command(tab, folder)
    said = " ".join(result.output.split())
    assert result.exit_code == 0, said
    fleet = ds.Fleet.from_toml(folder / "fleet.toml")
    theirs = answer_text.describe_fleet(SimpleNamespace(fleet=fleet))  # type: ignore[arg-type]
    own = f"{entries['hosts']} robots" + (" and 1 laptop" if entries["beside"] == "laptop" else "")
    told = [tab.locator("#calc-answer strong"), *tab.locator("#calc-answer .calc-line").all()]
    for line in told:
        assert words(line.inner_text()).replace(own, theirs) in said
    return said


#: Spread evenly or not, with a laptop at the first access point, and lost where queues overflow.
SPREAD: list[dict[str, str]] = [
    {**SMALL, "hosts": "7", "cells": "2", "wifi": "802.11n 20 MHz 2x2"},
    {**SMALL, "hosts": "9", "cells": "3", "beside": "laptop", "middleware": "Zenoh router"},
    {**SMALL, "hosts": "24", "cells": "4", "middleware": "Cyclone DDS", "within": "5"},
]


@pytest.mark.parametrize("entries", SPREAD)
def test_several_access_points_have_the_commands_answer(
    tab: Page, tmp_path: Path, entries: dict[str, str]
) -> None:
    put(tab, entries)
    numbers = simulated(tab)
    said = check_command(tab, entries, tmp_path)
    sure = words(tab.locator("#calc-sure").inner_text())
    assert answer_text.SENTENCES["assumed of cells"] in said
    assert answer_text.SENTENCES["assumed of cells"] in sure
    expect(tab.locator("#calc-cell-list li")).to_have_count(int(entries["cells"]))
    for line in tab.locator("#calc-cell-list li").all_inner_texts():
        assert f"- {words(line)}" in said
    check_cell_by_cell(tab, entries, numbers, ds.Fleet.from_toml(tmp_path / "fleet.toml"))
    for name in ("cells", "hosts"):
        assert f"{name}={entries[name]}" in link(tab)


def check_cell_by_cell(
    tab: Page, entries: dict[str, str], numbers: dict[str, float], fleet: ds.Fleet
) -> None:
    """Compare a fleet whose airtime is counted cell by cell with its plan."""
    protocol, within = PROTOCOLS[entries["middleware"]], float(entries["within"])
    if fleet.cells:
        plan = plan_cells(fleet, protocol, within)
    else:
        plan = ds.plan(fleet, protocol, channel(entries), within=within)
    assert plan.discovery.today is not None
    assert numbers["simulated median"] == plan.discovery.today.median
    assert advice(tab) == advised(as_on_page(plan))
    # What is of one access point, without wired hosts, is not there.
    for hidden in ("#calc-behind:not([hidden])", "#calc-csv:enabled"):
        expect(tab.locator(hidden)).to_have_count(0)


#: Beside one access point, and beside two with a robot that reboots.
WIRED: list[dict[str, str]] = [
    {**SMALL, "hosts": "7", "beside": "laptop", "cable": "1"},
    {**SMALL, "hosts": "9", "beside": "laptop", "cable": "1", "cells": "2", "start": "reboot"},
]


@pytest.mark.parametrize("entries", WIRED)
def test_wired_computers_have_the_commands_answer(
    tab: Page, tmp_path: Path, entries: dict[str, str]
) -> None:
    put(tab, entries)
    numbers = simulated(tab)
    check_command(tab, entries, tmp_path)
    fleet = ds.Fleet.from_toml(tmp_path / "fleet.toml")
    assert [group.wired for group in fleet.groups] == [False] * int(entries["cells"]) + [True]
    check_cell_by_cell(tab, entries, numbers, fleet)
    assert "cable=1" in link(tab)


def test_more_access_points_than_robots_are_refused(tab: Page) -> None:
    put(tab, {**SMALL, "hosts": "3", "cells": "4"})
    expect(tab.locator("#calc-cells-error")).to_contain_text("at most as many as robots; got 4")
    put(tab, {**SMALL, "hosts": "4", "cells": "4"})
    expect(tab.locator("#calc-cells-error")).to_be_empty()


def test_security_is_refused_with_the_commands_sentence(tab: Page, tmp_path: Path) -> None:
    put(tab, {**SMALL, "hosts": "3", "security": "1"})
    result = command(tab, tmp_path)
    assert result.exit_code != 0
    told = [tab.locator("#calc-answer strong"), *tab.locator("#calc-answer .calc-line").all()]
    said = " ".join(line.inner_text() for line in told)
    assert "DDS Security (SROS2) is not counted. In startups that we captured" in said
    assert said.removesuffix(".") in " ".join(result.output.split())
    assert "security=1" in link(tab)
    expect(tab.locator("#calc-progress")).to_be_hidden()
    assert not [name for name in tab.evaluate("calculatorTest.shown()") if is_simulated(name)]


@pytest.mark.parametrize("hosts", ["6", "60"])  # known to all, and never complete before
def test_a_reboot_has_the_commands_sentence(tab: Page, tmp_path: Path, hosts: str) -> None:
    entries = {**SMALL, "hosts": hosts, "start": "reboot"}
    put(tab, entries)
    numbers = simulated(tab)
    fleet, middleware = fleet_of(entries), PROTOCOLS[entries["middleware"]]
    plan = ds.plan(fleet, middleware, channel(entries))
    simulate_protocols([plan])
    assert plan.discovery.today is not None
    assert numbers["simulated median"] == plan.discovery.today.median
    title = words(tab.locator("#calc-answer strong").inner_text())
    if plan.late_join is None:
        assert title == answer_text.SENTENCES["no reboot"]
        assert math.isinf(plan.discovery.today.times[-1])
        return
    assert numbers["simulated late median"] == plan.late_join.median
    assert title.startswith("If one robot reboots, all others have rediscovered it ")
    check_command(tab, entries, tmp_path)
    assert answer_text.SENTENCES["other start"] in tab.locator("#calc-sure").inner_text()


@pytest.mark.parametrize("middleware", ["Fast DDS 3.6", "Zenoh peer"])
def test_one_after_the_other_is_the_plans_change(tab: Page, middleware: str) -> None:
    entries = {**SMALL, "hosts": "10", "start": "turn", "middleware": middleware}
    put(tab, entries)
    numbers = simulated(tab)
    plan = ds.plan(fleet_of(entries), PROTOCOLS[middleware], channel(entries))
    staggered = tuple(r for r in plan.remedies if r.kind == "staggered start")
    (change,) = replace(plan, remedies=staggered, combinations=()).discovery.changes
    assert change.time is not None
    assert numbers["simulated median"] == change.time.median
    assert numbers["simulated nine"] == change.time.nine_of_ten
    within = f"at random times within {change.start_window:g}"
    assert within in words(tab.locator("#calc-answer").inner_text())


def test_periodic_traffic_that_fills_the_channel_leaves_no_time_to_start(tab: Page) -> None:
    put(tab, {**SMALL, "hosts": "400", "start": "turn", "middleware": "DDS, periods of Fast DDS"})
    answer = tab.locator("#calc-answer")
    expect(answer).to_contain_text("Not simulated: periodic traffic alone fills the channel.")


@pytest.mark.parametrize("robot", [name for name, one in robots().items() if one.process_sizes])
def test_a_ready_made_robot_is_simulated_with_its_processes(
    tab: Page, tmp_path: Path, robot: str
) -> None:
    tab.get_by_label("Type of robot").select_option(robot)
    entries = {"hosts": "2", "beside": "none"}
    put(tab, entries)
    numbers = simulated(tab)
    check_command(tab, entries, tmp_path)
    told = json.loads(
        CliRunner().invoke(main, ["plan", "--robot", robot, "--hosts", "2", "--json"]).output
    )
    assert told["discovery"]["today"]["median_s"] == numbers["simulated median"]


def test_the_link_of_a_fleet_with_cells_opens_with_its_access_points(
    tab: Page, address: str
) -> None:
    wifi = "802.11ac 80 MHz 2x2"
    groups = [ds.HostGroup(4, 2, 10, cell=name) for name in ("hall", "yard")]
    cells = tuple(ds.Cell(name, wifi) for name in ("hall", "yard"))
    found = calculator_link(ds.Fleet((*groups, ds.HostGroup(1, 1, 90, cell="yard")), cells=cells))
    assert found is not None
    assert found.notes == ("the calculator spreads robots evenly over access points of one kind",)
    page, _, entries = found.address.partition("#")
    assert address.endswith(page)
    tab.goto(f"{address}#{entries}")
    expect(tab.locator(".calc-error:not(:empty)")).to_have_count(0)
    wanted = {"hosts": "8", "processes": "2", "cells": "2", "beside_hosts": "1", "wifi": wifi}
    for field, value in wanted.items():
        expect(tab.locator(f"#calc-form [name={field}]")).to_have_value(value)


def test_the_fleets_meet_all_verdicts() -> None:
    plans = [plan_of(n) for n in range(len(SIMULATED))]
    begin = {answer_text._verdict_lines(plan)[0].split()[0] for plan in plans}
    assert begin == {"Yes,", "Not", "No,", "No:"}
    assert any(plan.discovery.hosts_in_time for plan in plans)


def test_the_sentences_are_the_plans(tab: Page) -> None:
    kept = tab.evaluate("DISCOSTORM.sentences")
    assert kept == answer_text.SENTENCES


def test_every_access_point_and_middleware_can_be_simulated(tab: Page) -> None:
    put(tab, {**SMALL, "hosts": "2"})
    simulated(tab)  # loads the simulator
    tables, radios = tab.evaluate(
        "Live.load().then(({ tables, radios }) => [tables, radios].map(Object.keys))"
    )
    assert set(tables) == set(offered_changes.all_tables())
    for wifi in CHANNELS.values():
        after = offered_changes.channels_after_changes(wifi)
        assert {each.name for each in (full_ampdus(wifi) or wifi, *after)} <= set(radios)


@pytest.mark.parametrize(
    ("changed", "said"),
    [
        ({"hosts": "90000"}, "Not simulated: the simulation would take too much time or memory."),
        ({"hosts": "1e9", "processes": "1e9"}, "Not simulated: the simulation would take too"),
        ({"wifi": "own"}, "Not simulated: rates and overheads of your own can be counted"),
        ({"hosts": "1"}, "A single host has no one to discover"),
    ],
)
def test_what_cannot_be_simulated_is_said(tab: Page, changed: dict[str, str], said: str) -> None:
    put(tab, {**SMALL, **changed})
    expect(tab.locator("#calc-answer")).to_contain_text(said)
    put(tab, {**SMALL, "hosts": "2"})  # what was said is of other entries
    simulated(tab)
    expect(tab.locator("#calc-answer")).to_contain_text("Yes, this startup works: 2 robots")


def test_typing_never_waits_and_an_old_simulation_is_dropped(tab: Page) -> None:
    put(tab, {**START, "hosts": "40", "middleware": "Zenoh peer"})
    answer = tab.locator("#calc-answer")
    expect(answer).to_have_attribute("data-severity", "waiting")
    expect(answer).to_contain_text("Simulating whether discovery is complete within 60")
    expect(answer).to_contain_text("If nothing is lost, startup keeps the channel busy for ")
    tab.wait_for_function("document.getElementById('calc-progress').value > 0")
    tab.get_by_label("Robots", exact=True).fill("3")
    expect(answer).to_contain_text("3\u00a0robots")
    expect(answer).to_have_attribute("data-severity", "waiting")
    put(tab, {**SMALL, "hosts": "3"})
    numbers = simulated(tab)
    entries = {**SMALL, "hosts": "3"}
    plan = ds.plan(fleet_of(entries), PROTOCOLS[entries["middleware"]], channel(entries))
    assert plan.discovery.today is not None
    assert numbers["simulated median"] == plan.discovery.today.median


def test_a_simulation_can_be_stopped_by_keyboard(tab: Page) -> None:
    put(tab, {**START, "hosts": "40", "middleware": "Zenoh peer"})
    button = tab.locator("#calc-simulate")
    expect(tab.locator("#calc-progress")).to_be_visible()
    button.focus()
    tab.keyboard.press("Enter")
    expect(button).to_have_text("Simulate")
    expect(button).to_be_focused()
    expect(tab.locator("#calc-answer")).to_contain_text("you stopped the simulation")
    expect(tab.locator("#calc-progress")).to_be_hidden()
    tab.keyboard.press("Enter")
    expect(button).to_have_text("Stop")
    tab.get_by_label("Robots", exact=True).fill("lots")
    expect(tab.locator("#calc-hosts-error")).not_to_be_empty()
    put(tab, {**SMALL, "hosts": "2"})
    assert simulated(tab)["simulated median"] < math.inf
    expect(button).to_be_hidden()


def test_a_change_is_applied_and_undone(tab: Page) -> None:
    put(tab, {**SMALL, "hosts": "12"})
    today = simulated(tab)["simulated median"]
    after = simulated(tab)[f"simulated processes of {inputs.DEFAULT_MIDDLEWARE}"]
    tab.get_by_role("button", name="Apply: composing").click()
    assert simulated(tab)["simulated median"] == after
    answer = tab.locator("#calc-answer")
    expect(answer).to_be_focused()
    expect(answer).to_contain_text("With this change: composing 2")
    with tab.context.new_page() as other:
        other.add_init_script(DRIVER)
        other.goto(link(tab))
        assert simulated(other)["simulated median"] == after
    tab.get_by_role("button", name="Undo").click()
    assert simulated(tab)["simulated median"] == today
    assert "with=" not in link(tab)
    # What a field can say goes into the field; no field has a server of this release's clients.
    put(tab, {**SMALL, "hosts": "12", "middleware": "Fast DDS 2.14"})
    simulated(tab)
    tab.get_by_role("button", name="Apply: a Discovery Server", exact=True).click()
    expect(answer).to_contain_text("With this change: a Discovery Server")
    put(tab, {**SMALL, "hosts": "12", "middleware": "Zenoh"})
    simulated(tab)
    tab.get_by_role("button", name="Apply: a central router", exact=True).click()
    expect(tab.get_by_label("Middleware", exact=True)).to_have_value("Zenoh router")
    expect(answer).not_to_contain_text("With this change")


def test_one_startup_is_drawn_and_saved(tab: Page) -> None:
    entries = {**SMALL, "hosts": "8", "endpoints": "6"}
    put(tab, entries)
    simulated(tab)
    fleet = fleet_of(entries)
    run = ds.simulate(fleet, PROTOCOLS[inputs.DEFAULT_MIDDLEWARE], until=60, seed=0)
    lanes = tab.get_by_role("img", name="One simulated startup of 8 hosts")
    label = lanes.get_attribute("aria-label") or ""
    assert f"complete after {float(run.convergence_time[0]):.2g}" in words(label)
    before = lanes.evaluate("e => e.toDataURL()")
    tab.locator("#calc-remedies [data-apply]").first.click()
    simulated(tab)
    assert lanes.evaluate("e => e.toDataURL()") != before
    with tab.expect_download() as saved:
        tab.get_by_role("button", name="Save picture").click()
    assert saved.value.path().read_bytes().startswith(b"\x89PNG")
    put(tab, {**SMALL, **FEW, "hosts": "41"})
    # Too many to tell lanes apart; a busy machine takes long.
    expect(tab.locator("#calc-lanes")).to_be_hidden(timeout=600_000)


def test_a_release_chooses_the_table(tab: Page, address: str) -> None:
    release, middleware = (
        tab.get_by_label(name, exact=True) for name in ("ROS 2 release", "Middleware")
    )
    expect(release).to_have_value(inputs.DEFAULT_ROS)
    for row in read_data("vendors/ros.csv"):
        middleware.select_option(row["product"])
        release.select_option(row["ros"])
        expect(middleware).to_have_value(row["protocol"])
    middleware.select_option("Fast DDS 2.6")
    expect(release).to_have_value("none")  # the release before ships another one
    middleware.select_option("Zenoh router")
    expect(release).to_be_disabled()
    tab.goto(f"{address}#ros=jazzy")
    expect(middleware).to_have_value("Fast DDS 2.14")


def test_the_changes_are_those_of_the_release() -> None:
    """Kilted ships the same table as Lyrical, but other servers, and Cyclone DDS before 11."""
    found: Any = offered_changes.table_changes_by_release(PROTOCOLS["Fast DDS 3.6"])
    assert found.keys() == {"any", "kilted"}
    for ros, cyclone in (("any", "Cyclone DDS 11"), ("kilted", "Cyclone DDS")):
        fleet = ds.Fleet((of_ros2((3, 2, 20), None),), ros=ros if ros != "any" else None)
        plan = ds.plan(fleet, PROTOCOLS["Fast DDS 3.6"])
        whats = {row[1] for row in found[ros]}
        assert f"switching to {cyclone}" in whats
        assert whats <= {remedy.what for remedy in plan.remedies}
        (server,) = (row for row in found[ros] if row[0] == "discovery server")
        assert ("forwards everything" in server[2]) == (ros == "any")


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_nothing_serious_keeps_anyone_out_of_the_simulated_answer(tab: Page, scheme: str) -> None:
    put(tab, {**SMALL, "hosts": "2"})
    simulated(tab)
    tab.locator("#calc-others-tried > summary").click()
    tab.evaluate(AXE)
    tab.set_viewport_size({"width": 390, "height": 844})
    tab.evaluate("theme => { document.documentElement.dataset.theme = theme }", scheme)
    tab.wait_for_timeout(300)  # colors fade over
    assert tab.evaluate(BARRIERS, {}) == []
    assert tab.evaluate("document.documentElement.scrollWidth") == 390
    tab.evaluate("document.documentElement.dataset.theme = 'light'")


@pytest.mark.parametrize(
    "name", ["simulate", "discovery_time", "time_words", "fleet_file", "cell_airtime"]
)
def test_scripts_that_simulate_are_short(name: str) -> None:
    script = ROOT / "book" / "_static" / "calculator" / f"{name}.js"
    assert len(script.read_text(encoding="utf-8").splitlines()) <= 300


# ---- the numbers as a file ----


@pytest.mark.parametrize("wifi", ["paper", "802.11n 20 MHz 2x2"])
def test_csv_holds_the_numbers(tab: Page, wifi: str) -> None:
    entries = {**START, "hosts": "7", "wifi": wifi}
    put(tab, entries)
    with tab.expect_download() as download:
        tab.get_by_role("button", name="CSV").click()
    text = download.value.path().read_text(encoding="utf-8")
    rows = list(csv.DictReader(io.StringIO(text)))
    assert list(rows[0]) == ["protocol", "quantity", "of", "hosts", "value", "unit"]
    assert {row["quantity"]: row["of"] for row in rows}["channel"] == CHANNELS[wifi].name
    inputs = {row["of"]: float(row["value"]) for row in rows if row["quantity"] == "input"}
    rate = CHANNELS[wifi].unicast.rate
    assert {"N_H": 7, "N_H1": 1, "N_E": ROBOT.endpoints, "R_uni": rate}.items() <= inputs.items()
    fleet = fleet_of(entries)
    for name, protocol in PROTOCOLS.items():
        own = [row for row in rows if row["protocol"] == name]
        table = ds.breakdown(protocol, fleet, wifi=CHANNELS[wifi])
        for quantity, column in {
            "uplink messages": "uplink_messages",
            "uplink airtime": "uplink_s",
            "downlink airtime": "downlink_s",
        }.items():
            found = {row["of"]: float(row["value"]) for row in own if row["quantity"] == quantity}
            assert found == same(table[column].to_dict())
        values = {row["quantity"]: row["value"] for row in own if not row["of"]}
        used = float(ds.utilization(protocol, fleet, wifi=CHANNELS[wifi]))
        assert float(values["utilization"]) == pytest.approx(used, rel=1e-9)
    curve = [row for row in rows if row["quantity"] == "curve" and row["protocol"] == "Fast DDS"]
    hosts = [float(row["hosts"]) for row in curve]
    assert len(hosts) > 100
    assert min(hosts) == 1
    assert max(hosts) > 7
    there = ds.utilization(
        PROTOCOLS["Fast DDS"],
        ds.Fleet((replace(fleet.groups[0], hosts=np.array(hosts)), fleet.groups[1])),
        wifi=CHANNELS[wifi],
    )
    assert [float(row["value"]) for row in curve] == pytest.approx(list(there), rel=1e-9)


# ---- looks and weight ----


def test_what_is_behind_the_answer_is_folded_at_first(browser: Browser, address: str) -> None:
    with browser.new_context(reduced_motion="reduce") as context:
        page = context.new_page()
        page.goto(address)
        for inside in ("#calc-reason", "#calc-all", "#calc-plot"):
            expect(page.locator(inside)).not_to_be_visible()
        page.locator("#calc-behind > summary").click()
        expect(page.get_by_text("(drain time)")).to_be_visible()
        expect(page.locator("#calc-plot canvas")).to_be_visible()


def test_the_plot_follows_light_and_dark(tab: Page) -> None:
    pictures = []
    for theme in ("light", "dark", "light"):
        tab.evaluate("theme => { document.documentElement.dataset.theme = theme }", theme)
        tab.evaluate("() => new Promise(requestAnimationFrame)")
        pictures.append(tab.evaluate("document.querySelector('#calc-plot canvas').toDataURL()"))
    assert pictures[0] == pictures[2] != pictures[1]


def test_the_curves_tell_what_is_pointed_at(tab: Page) -> None:
    tip = tab.locator(".calc-tip")
    expect(tip).to_be_hidden()
    tab.locator("#calc-plot .u-over").hover(position={"x": 200, "y": 100})
    expect(tip).to_contain_text("robot")
    expect(tip).to_contain_text("Fast DDS: ")


#: Counts what uPlot writes at the marks of its axes.
MARKS = """() => {
    const told = [];
    const write = CanvasRenderingContext2D.prototype.fillText;
    CanvasRenderingContext2D.prototype.fillText = function (text, ...rest) {
        told.push(text);
        return write.call(this, text, ...rest);
    };
    return new Promise((done) => {
        calculatorTest.fill({});
        requestAnimationFrame(() => {
            CanvasRenderingContext2D.prototype.fillText = write;
            done(told);
        });
    });
}"""


@pytest.mark.parametrize("most", ["1e3", "1e6", "1e9"])
def test_the_axes_are_labelled_up_to_the_largest_numbers(tab: Page, most: str) -> None:
    put(tab, {"robot": "own", "hosts": most, "processes": most, "endpoints": most})
    told = tab.evaluate(MARKS)
    times = [text for text in told if text.endswith((" y", " d", " h", " min", " s"))]
    assert 3 <= len(times) <= 7
    assert times[-1].endswith(" y")
    largest = {"1e3": "1,000", "1e6": "10⁶", "1e9": "10⁹"}[most]
    assert largest in told


@pytest.mark.parametrize("hosts", ["7", "1000", "1e9", "lots"])
def test_fits_a_phone(tab: Page, hosts: str) -> None:
    tab.set_viewport_size({"width": 390, "height": 800})
    put(tab, {"wifi": "own", "beside": "own"})
    tab.get_by_label("Robots", exact=True).fill(hosts)
    tab.evaluate("() => new Promise(requestAnimationFrame)")
    assert tab.evaluate("document.documentElement.scrollWidth") == 390
    plot = tab.locator("#calc-plot canvas").bounding_box()
    assert plot is not None
    assert 300 < plot["width"] < 390


@pytest.mark.parametrize(("width", "height"), [(390, 800), (1280, 800)])
def test_the_answer_stays_in_sight_while_one_changes_things(
    tab: Page, width: int, height: int
) -> None:
    tab.set_viewport_size({"width": width, "height": height})
    for name in ("hosts", "beside_hosts", "channel"):
        field = tab.locator(f"#calc-{name}")
        field.evaluate("e => e.scrollIntoView({block: 'center', behavior: 'instant'})")
        tab.evaluate("() => new Promise(requestAnimationFrame)")
        answer, entry = (
            tab.locator(where).bounding_box() for where in ("#calc-answer", f"#calc-{name}")
        )
        assert answer is not None
        assert entry is not None
        assert answer["y"] >= 0
        assert answer["y"] + answer["height"] <= height / 2
        if width < 1000:
            assert entry["y"] >= answer["y"] + answer["height"]  # not under it


def test_without_scripts_it_says_so(browser: Browser, address: str) -> None:
    with browser.new_context(java_script_enabled=False) as context:
        page = context.new_page()
        page.goto(address)
        note = page.locator("noscript > .calc-note")  # Playwright's texts leave noscript out
        expect(note).to_be_visible()
        expect(note).to_contain_text("The calculator needs JavaScript")
        expect(page.locator("#calc-tool")).to_be_hidden()


def test_page_weighs_little(browser: Browser, server: str, book: Path) -> None:
    def files(name: str) -> dict[str, int]:
        loaded: set[str] = set()
        with browser.new_context() as context:
            page = context.new_page()
            page.on("requestfinished", lambda request: loaded.add(request.url))
            page.goto(f"{server}book/{name}.html")
            page.wait_for_load_state("networkidle")
        paths = [urlsplit(url).path for url in loaded if url.startswith(server)]
        return {path: (book / path[1:]).stat().st_size for path in paths}

    carried = files("paper_map")
    own = {path: size for path, size in files("calculator").items() if path not in carried}
    names = {Path(path).name for path in own}
    assert {"calculator.html", "calculator.js", "model.js", "uPlot.iife.min.js"} <= names
    assert not [path for path in carried if "calculator" in path]  # no other page pays for it
    # The simulator comes after the first answer, and has its own limits.
    simulator = [path for path in own if "/live/" in path or path.endswith("/changed_tables.js")]
    assert sum(size for path, size in own.items() if path not in simulator) <= 450_000
    more = MODEL_JS.parent / "changed_tables.js"
    assert len(gzip.compress(more.read_bytes(), 9)) <= 4_200
