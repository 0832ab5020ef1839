"""Compare the simulator of the pages with Python's: `make live-check`.

Random settings (tables, fleets of several groups and cells, matching and shared endpoints, channels
with and without aggregation, queues, frame errors, starts in turn) run in Python and in headless
Chromium, from a file, with the network off. All arrays must agree bit for bit at a run's start and
end, and at its end also with numba's machine code. First, the inner loop is compiled anew, and its
bytes are compared if the tool versions are those of the committed file.
"""

import argparse
import csv
import hashlib
import json
import multiprocessing
import os
import platform
import random
import re
import shutil
import sys
import tempfile
import time
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import compile_wasm
import numpy as np

sys.path.append(str(Path(__file__).parents[1]))

from headless_firefox import AnswerServer, ask_firefox
from write_wasm_files import CHANNELS_BY_NAME, ENGINE_JS, ENGINE_WASM, schedule_data

import discostorm as ds
from discostorm.host_group import Process
from discostorm_simulation import cell_setup, state as st
from discostorm_simulation.engine import run_to_end
from discostorm_simulation.run import Scenario, Setup, result_of, set_up
from discostorm_simulation.starts import uniform_start

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

ROOT = Path(__file__).parents[2]
SIMULATING_PAGE = ROOT / "tests" / "helpers" / "live.html"
#: Table that the book's page on checks reads.
RESULTS_FILE = ROOT / "packages/book/discostorm_book/data/simulated" / "live.csv"

#: The setting of a run, in the form that pages use.
Setting = dict[str, Any]

#: Numbers of compared settings in `make test` and in `make live-check`.
FEW_SETTINGS, MANY_SETTINGS = 50, 1000

#: Maximum processor time of a run in a browser, as a multiple of Python's on the same machine, by
#: number of the paper's robots; and number of runs to average. Short runs have fixed costs, too.
MAX_TIME_RATIOS, TIMED_RUNS = {12: 6.0, 25: 3.0}, 20


def _group(rng: random.Random, hosts: int) -> Setting:
    endpoints = rng.choice((0, 1, 3, 7, 10, 12))
    shared = rng.choice((0, 0, 1, 2.5, endpoints))
    group = {"hosts": hosts, "processes": rng.randint(1, 3), "endpoints": endpoints}
    return group | {"shared": min(shared, endpoints)}


def random_settings(count: int, seed: int) -> Iterator[Setting]:
    """Yield random settings that use every table and channel in turn."""
    rng = random.Random(seed)
    names, channels = list(ds.PROTOCOLS), list(CHANNELS_BY_NAME)
    whole = {
        name for name in names if "refused" not in schedule_data(ds.PROTOCOLS[name], recovery=True)
    }
    for number in range(count):
        sizes = [rng.randint(1, 4) for _ in range(rng.choice((1, 1, 2, 3)))]
        if sum(sizes) < 2:
            sizes = [rng.choice((2, 3, 5, 9))]
        hosts = sum(sizes)
        gap = rng.choice((0.003, 0.1, 0.7))
        setting: Setting = {
            "table": names[number % len(names)],
            "radio": channels[number // len(names) % len(channels)],
            # Rarely allow settings that the simulator refuses.
            "recovery": rng.random() < (0.7 if names[number % len(names)] in whole else 0.03),
            "fleet": {
                "groups": [_group(rng, size) for size in sizes],
                "matching": rng.choice((0, 0, 1, rng.random())),
            },
            "queue": rng.choice(([500, 0.5], [500, 0.5], None, [40, 0.1], [9, None], [None, 0.02])),
            "start": rng.choice(
                (
                    0,
                    [host * gap for host in range(hosts)],
                    [rng.uniform(0, 2) for _ in range(hosts)],
                )
            ),
            "loss": rng.choice((0, 0, 0.03, [rng.uniform(0, 0.3) for _ in range(hosts)])),
            "until": rng.choice((0.3, 3.0, 12.5)),
            "eifs": rng.random() < 0.3,
            "block_ack": rng.choice(("negotiate", "established")),
            "seed": rng.choice((0, 7, rng.getrandbits(31), rng.getrandbits(53))),
            "run": rng.randint(0, 3),
        }
        if rng.random() < 0.3:  # pages take factors; Python takes decibels
            decibels = [[rng.uniform(-90, -40) for _ in range(hosts + 1)] for _ in range(hosts + 1)]
            setting |= {"decibels": decibels, "power": cell_setup.from_decibels(decibels).tolist()}
        if rng.random() < 0.1 and "power" not in setting:
            setting["fleet"]["groups"][0]["wired"] = True
        more = random.Random(seed + number)
        if more.random() < 0.3:
            setting |= {"within": more.choice((0.5, 3.0))}
        if more.random() < 0.5:
            setting |= {"giveUp": more.choice((0.01, 0.5))}
        groups = setting["fleet"]["groups"]
        if more.random() < 0.3:  # processes of unlike size
            own = groups[-1]
            own["endpoints"] = [more.randint(1, 9) for _ in range(own["processes"])]
            own["shared"] = min(own["shared"], *own["endpoints"])
        if more.random() < 0.5 and "power" not in setting:
            for number, group in enumerate(group for group in groups if not group.get("wired")):
                group["cell"] = number
        yield setting


def _host_group(group: Setting) -> ds.HostGroup:
    """Return a host group from a page's setting; endpoints are a number or a list per process."""
    counts, sizes = dict(group), group["endpoints"]
    if isinstance(sizes, list):
        counts |= {"processes": tuple(Process(1, each) for each in sizes), "endpoints": None}
    return ds.HostGroup(**counts | {"cell": str(group["cell"])} if "cell" in group else counts)


def _setup(setting: Setting) -> Setup:
    """Return the Python set-up for a page's setting."""
    queue = setting.get("queue", [500, 0.5]) or [None, None]
    frames, seconds = (np.inf if limit is None else limit for limit in queue)
    groups = tuple(map(_host_group, setting["fleet"]["groups"]))
    wifi = CHANNELS_BY_NAME[setting["radio"]]
    cells = tuple(ds.Cell(group.cell, wifi) for group in groups if group.cell)
    scenario = Scenario(
        ds.Fleet(groups, setting["fleet"].get("matching", 0.0), cells=cells),
        ds.PROTOCOLS[setting["table"]],
        wifi,
        queue=(frames, seconds),
        start=uniform_start(setting["within"]) if "within" in setting else setting.get("start", 0),
        loss=setting.get("loss", 0),
        recovery=setting.get("recovery", True),
        until=setting.get("until", 120.0),
        give_up=setting.get("giveUp", np.inf),
        eifs=setting.get("eifs", False),
        block_ack=setting.get("block_ack", "negotiate"),
        power=setting.get("decibels"),
    )
    return set_up(scenario)


def _array_digests(cell: Any) -> dict[str, str]:
    return {
        name: hashlib.sha256(np.ascontiguousarray(array).tobytes()).hexdigest()[:16]
        for name, array in zip(cell._fields, cell, strict=True)
    }


def _seed(setting: Setting) -> np.random.SeedSequence:
    return np.random.SeedSequence(setting.get("seed", 0), spawn_key=(setting.get("run", 0),))


def _latest_end(setup: Setup, starts: Any) -> int:
    """Return when a run ends at the latest [ticks]."""
    return min(cell_setup.to_ticks(float(starts.max()) + setup.until), int(st.NEVER) - 1)


def run_in_python(setting: Setting) -> dict[str, Any]:
    """Return Python's result for a setting, with digests of all arrays at start and end."""
    try:
        setup = _setup(setting)
    except ValueError as error:
        return {"refused": str(error)}

    cell, starts = setup.cell(_seed(setting))
    found: dict[str, Any] = {"start": _array_digests(cell)}
    missing = cell.pairs["missing"].copy()
    cell = run_to_end(cell, _latest_end(setup, starts), setup.reserve)
    found["end"] = _array_digests(cell)
    run = result_of(setup, starts, missing, cell)
    found["result"] = {
        "drained": run.drain_time,
        "converged": run.convergence_time,
        "lost": run.lost,
        "expected": run.counts["expected"],
        "arrived": run.counts["arrived"],
        "busy": run.busy_time,
    }
    if (times := run.pair_times).size:
        found["result"] |= {
            "done": float(np.isfinite(times).mean()),
            "most": float(times[int(np.ceil(0.95 * times.size)) - 1]),
            "expired": run.counts["expired"] / times.size,
        }
    return found


def names_of_differences(here: dict[str, Any], there: dict[str, Any]) -> list[str]:
    """Return the names of the arrays and results that differ between two engines."""
    if "refused" in here or "refused" in there:
        return [] if here.keys() == there.keys() else ["refused"]
    return [
        f"{part} {name}"
        for part in ("start", "end", "result")
        for name, value in here[part].items()
        if there[part][name] != value
    ]


@contextmanager
def offline_page(browser: "Browser") -> "Iterator[Page]":
    """Open the page that simulates, as a file and with the network off."""
    with browser.new_context(offline=True) as context:
        page = context.new_page()
        page.goto(SIMULATING_PAGE.as_uri())
        yield page


def run_in_page(page: "Page", given: list[Setting], steps: int = 5000) -> list[dict[str, Any]]:
    """Return the page's results for settings, simulated in steps of a given size."""
    found: list[dict[str, Any]] = page.evaluate(
        "([settings, steps]) => compare(settings, steps)", [given, steps]
    )
    return found


def paper_swarm_setting(hosts: int) -> Setting:
    """Return the setting of the paper's robots."""
    groups = [{"hosts": hosts, "processes": 2, "endpoints": 10}]
    return {"table": "DDS", "radio": ds.PAPER.name, "fleet": {"groups": groups}}


def measure_run_times(browser: "Browser", page: "Page") -> dict[int, float]:
    """Measure the mean processor time of a run by number of the paper's robots [ms]."""
    session = browser.new_browser_cdp_session()

    def spent() -> float:
        every = session.send("SystemInfo.getProcessInfo")["processInfo"]
        return float(sum(one["cpuTime"] for one in every if one["type"] == "renderer"))

    found = {}
    for hosts in MAX_TIME_RATIOS:
        runs = [paper_swarm_setting(hosts)] * TIMED_RUNS
        run_in_page(page, runs, 10**7)  # lets the browser optimize its code
        before = spent()
        run_in_page(page, runs, 10**7)
        found[hosts] = (spent() - before) / TIMED_RUNS * 1e3
    return found


def python_run_time(hosts: int) -> float:
    """Measure the mean processor time of a run in Python [ms]."""
    before = time.thread_time()
    for _ in range(TIMED_RUNS):
        run_in_python(paper_swarm_setting(hosts))
    return (time.thread_time() - before) / TIMED_RUNS * 1e3


@dataclass(frozen=True)
class BrowserResults:
    """A browser's results for settings, and its measured run times [ms]."""

    browser: str
    settings: list[dict[str, Any]]
    times: dict[int, float]


def run_in_chromium(settings: list[Setting]) -> BrowserResults:
    """Run settings in headless Chromium, with the network off."""
    from playwright.sync_api import sync_playwright

    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(
            executable_path=shutil.which("chromium"),
            args=["--no-sandbox", "--disable-dev-shm-usage", "--disable-background-networking"],
        )
        with offline_page(browser) as page:
            found = []
            for first in range(0, len(settings), 50):
                found += run_in_page(page, settings[first : first + 50])
            took = measure_run_times(browser, page)
        name = f"Chromium {browser.version.split('.')[0]}"
        browser.close()
    return BrowserResults(name, found, took)


def run_in_firefox(program: str, settings: list[Setting]) -> BrowserResults:
    """Run settings in headless Firefox; its page fetches the settings and posts the results."""
    script = f"const ASKED = {json.dumps(settings)};"
    with (
        AnswerServer(script) as server,
        tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile,
    ):
        address = f"{SIMULATING_PAGE.as_uri()}#{server.server_port}"
        # The page fetches its settings, then posts the results.
        answer = ask_firefox(program, Path(profile), address, server, requests=2)
    name = re.search(r"Firefox/\d+", answer["browser"])
    assert name is not None, answer["browser"]
    for one in answer["settings"]:  # JSON has no infinity
        found = one.get("result", {})
        found.update({key: np.inf for key, value in found.items() if value is None})
    return BrowserResults(name[0].replace("/", " "), answer["settings"], {})


def compare_engine_bytes(cache: Path) -> str:
    """Compile the engine anew and compare its bytes; return a report, keep numba's code."""
    if compile_wasm.find_linker() is None:
        return "no wasm-ld here: the committed engine is compared by its results alone"
    kept, versions = (
        ENGINE_JS.read_text(encoding="utf-8").splitlines()[1],
        compile_wasm.tool_versions(),
    )
    if not kept.endswith(f"sources {compile_wasm.sources_digest()}"):
        raise SystemExit("discostorm: the engine is of other sources: make live")
    if compile_wasm.compile_webassembly(cache) == ENGINE_WASM.read_bytes():
        return f"engine: the same bytes with {versions}"
    if f" {versions};" in kept:
        raise SystemExit("discostorm: the engine has other bytes with the same versions: make live")
    return f"engine: of other versions than here, {kept[3:]}; its results are compared instead"


def compare_with_numba(
    cache: Path, settings: list[Setting], here: list[dict[str, Any]]
) -> list[str]:
    """Return the differences between the engine and its source compiled by numba."""
    # As in `compile_wasm`, whose machine code is in the cache unless the bytes were not checked.
    os.environ |= compile_wasm.GENERIC_PROCESSOR | {"NUMBA_CACHE_DIR": str(cache)}
    from discostorm_simulation.kernels import decorators

    decorators.inlined = decorators.not_inlined
    from discostorm_simulation.kernels.advance import advance

    loop: Any = advance
    wrong = []
    for setting, found in zip(settings, here, strict=True):
        if "refused" in found:
            continue
        setup = _setup(setting)
        cell, starts = setup.cell(_seed(setting))
        until = _latest_end(setup, starts)
        while (state := loop(cell, until, setup.reserve, 10**7)) != st.OVER:
            cell = _with_doubled_arrays(cell) if state == st.MEMORY else cell
        there = _array_digests(cell)
        differing = [name for name, digest in found["end"].items() if there[name] != digest]
        if differing:
            wrong.append(f"{', '.join(differing)} differ from numba's in {setting}")
    return wrong


def _with_doubled_arrays(cell: st.CellState) -> st.CellState:
    """Return a copy of a cell with twice the space for waiting frames and events."""
    pool, events = (np.concatenate([old, np.zeros_like(old)]) for old in (cell.pool, cell.events))
    size = cell.pool.size
    pool["next"][size:] = np.arange(size + 1, 2 * size + 1)
    pool["next"][-1] = cell.state["free"][0]
    cell.state["free"] = size
    cell.state["spare"] += size
    return cell._replace(pool=pool, events=events)


def report_comparison(
    settings: list[Setting], here: list[dict[str, Any]], there: BrowserResults
) -> tuple[dict[str, Any], list[str]]:
    """Return the report of a comparison, and its errors."""
    pairs = zip(map(names_of_differences, here, there.settings), settings, strict=True)
    wrong = [f"{', '.join(names)} differ in {setting}" for names, setting in pairs if names]
    ratios = {hosts: took / python_run_time(hosts) for hosts, took in there.times.items()}
    summary = {
        "browser": there.browser,
        "machine": platform.machine(),
        "settings": len(settings),
        "same": len(settings) - len(wrong),
        "refused": sum("refused" in one for one in here),
        "arrays": len(st.CellState._fields),
        **{f"robots_{hosts}_ms": round(took) for hosts, took in there.times.items()},
    }
    return summary, wrong + [
        f"{hosts} robots take {ratio:.1f} times as long as in Python"
        for hosts, ratio in ratios.items()
        if ratio > MAX_TIME_RATIOS[hosts]
    ]


def main() -> None:
    """Compare bytes, results and speed."""
    parser = argparse.ArgumentParser(prog="make live-check", description=main.__doc__)
    parser.add_argument(
        "--settings", type=int, default=MANY_SETTINGS, help="how many random settings"
    )
    parser.add_argument("--seed", type=int, default=1, help="random seed of the settings")
    parser.add_argument("--no-bytes", action="store_true", help="do not compile the engine anew")
    parser.add_argument("--firefox", help="the program, if it is to be tried, too")
    parser.add_argument("--write", action="store_true", help=f"write {RESULTS_FILE.name}")
    given = parser.parse_args()
    settings = list(random_settings(given.settings, given.seed))
    # numba compiles for a minute, so it gets a separate process.
    with (
        tempfile.TemporaryDirectory() as name,
        ProcessPoolExecutor(1, multiprocessing.get_context("spawn")) as numba,
    ):
        report = None if given.no_bytes else numba.submit(compare_engine_bytes, Path(name))
        here = [run_in_python(setting) for setting in settings]
        compared = numba.submit(compare_with_numba, Path(name), settings, here)
        answers = [run_in_chromium(settings)]
        if given.firefox:
            answers.append(run_in_firefox(given.firefox, settings))
        if report:
            print(report.result(), flush=True)
        if beside := compared.result():
            raise SystemExit(
                "\n".join(["discostorm: the engine differs from its source", *beside[:5]])
            )
    print(f"engine: as numba's in {len(settings)} settings", flush=True)
    rows, wrong = [], []
    for there in answers:
        summary, found = report_comparison(settings, here, there)
        print(", ".join(f"{name} {value}" for name, value in summary.items()), *found[:5], sep="\n")
        rows.append(summary | {"source": f"make live-check, seed {given.seed}"})
        wrong += found
    if wrong:
        raise SystemExit(f"discostorm: {len(wrong)} of these are not as they should be")
    if given.write:
        with RESULTS_FILE.open("w", newline="", encoding="utf-8") as file:
            writer = csv.DictWriter(file, list(rows[0]), lineterminator="\n")
            writer.writeheader()
            writer.writerows(rows)


if __name__ == "__main__":
    main()
