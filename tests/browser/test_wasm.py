"""The simulator of the pages: made from today's sources, and the same as Python's, bit for bit."""

import gzip
import importlib
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest
from playwright.sync_api import Browser, Page
from support import ROOT

import discostorm as ds
from discostorm.data import data_path
from discostorm_simulation import cell_setup, initial_state
from discostorm_simulation.engine import run_to_end
from discostorm_simulation.run import Scenario, set_up

pytestmark = pytest.mark.book

LIVE = ROOT / "book" / "_static" / "live"

compare_wasm_with_python = importlib.import_module("compare_wasm_with_python")
compile_wasm = importlib.import_module("compile_wasm")
write_wasm_files = importlib.import_module("write_wasm_files")

#: Runs a setting in the worker and returns what came of it.
IN_WORKER = """async ([setting, options]) => {
    const shares = [];
    const each = (share) => shares.push({ ...share, rows: [...share.rows] });
    const { found } = Live.run(setting, { ...options, each });
    return { shares, result: await found.catch((error) => ({ error: error.message })), shares };
}"""


@pytest.fixture(scope="module")
def page(browser: Browser) -> Iterator[Page]:
    with compare_wasm_with_python.offline_page(browser) as page:
        errors: list[str] = []
        page.on("pageerror", lambda error: errors.append(str(error)))
        yield page
    assert not errors


def test_tables_are_fresh() -> None:
    assert (
        write_wasm_files.TABLES_JS.read_text(encoding="utf-8") == write_wasm_files.tables_text()
    ), "make live"
    changed = write_wasm_files.CHANGED_TABLES_JS.read_text(encoding="utf-8")
    assert changed == write_wasm_files.changed_tables_text(), "make live"


def test_the_engine_was_compiled_from_these_sources() -> None:
    head = write_wasm_files.ENGINE_JS.read_text(encoding="utf-8").splitlines()[1]
    assert head.endswith(f"sources {compile_wasm.sources_digest()}"), "make live"
    engine = write_wasm_files.ENGINE_WASM.read_bytes()
    assert write_wasm_files.ENGINE_JS.read_text(encoding="utf-8") == write_wasm_files.engine_text(
        engine
    )


def test_the_engine_was_compiled_with_the_locked_versions() -> None:
    lock = (ROOT / "requirements.lock").read_text(encoding="utf-8")
    numba, llvmlite = (
        re.search(rf"^{name}==(\S+)", lock, re.M)[1]  # type: ignore[index]
        for name in ("numba", "llvmlite")
    )
    head = write_wasm_files.ENGINE_JS.read_text(encoding="utf-8").splitlines()[1]
    assert f"numba {numba}, llvmlite {llvmlite}, lld {compile_wasm.LLD_RELEASE};" in head, (
        "make live"
    )


@pytest.mark.parametrize("steps", [5000, 137])
def test_random_settings_are_the_same_in_a_browser(page: Page, steps: int) -> None:
    """Half of them each; how many steps a share has must not matter."""
    every = list(
        compare_wasm_with_python.random_settings(compare_wasm_with_python.FEW_SETTINGS, seed=20)
    )
    given = every[::2] if steps == 137 else every[1::2]
    here = [compare_wasm_with_python.run_in_python(setting) for setting in given]
    there = compare_wasm_with_python.run_in_page(page, given, steps)
    for setting, *both in zip(given, here, there, strict=True):
        assert compare_wasm_with_python.names_of_differences(*both) == [], setting
    assert sum("refused" not in one for one in here) > len(given) / 2


def test_another_seed_is_seen(page: Page) -> None:
    setting = compare_wasm_with_python.paper_swarm_setting(3)
    (there,) = compare_wasm_with_python.run_in_page(page, [setting | {"seed": 1}])
    differing = compare_wasm_with_python.names_of_differences(
        compare_wasm_with_python.run_in_python(setting), there
    )
    assert {"start state", "start part", "end log"} <= set(differing)


def test_memory_grows_as_pythons_does(page: Page) -> None:
    setting = compare_wasm_with_python.paper_swarm_setting(9) | {
        "queue": None,
        "recovery": False,
        "table": "Zenoh router",
    }
    setup = compare_wasm_with_python._setup(setting)
    cell, _ = setup.cell(np.random.SeedSequence(0, spawn_key=(0,)))
    grown = run_to_end(cell, cell_setup.to_ticks(1e9), setup.reserve)
    assert grown.pool.size > initial_state.POOL_ENTRIES
    (there,) = compare_wasm_with_python.run_in_page(page, [setting])
    assert (
        compare_wasm_with_python.names_of_differences(
            compare_wasm_with_python.run_in_python(setting), there
        )
        == []
    )


def test_every_table_and_channel_is_tried() -> None:
    many = list(
        compare_wasm_with_python.random_settings(compare_wasm_with_python.MANY_SETTINGS, seed=1)
    )
    tried = {(setting["table"], setting["radio"]) for setting in many}
    assert tried == {
        (table, radio) for table in ds.PROTOCOLS for radio in write_wasm_files.CHANNELS_BY_NAME
    }


def test_pages_said_the_same_in_every_browser_that_was_tried() -> None:
    rows = pd.read_csv(data_path("simulated/pages.csv", "discostorm_book"))
    assert len(rows) >= 8
    assert rows["browsers"].str.fullmatch(r"Chromium \d+; Firefox \d+").all()
    assert (rows["same"] == rows["texts"]).all()
    assert (rows["texts"] > 0).all()
    assert (rows["errors"] == 0).all()
    for page in rows["page"]:
        assert any((ROOT / f"{page}{suffix}").exists() for suffix in (".md", ".ipynb"))


# ---- in the worker ----


def test_the_worker_tells_of_each_share_and_what_was_sent(page: Page) -> None:
    setting = compare_wasm_with_python.paper_swarm_setting(4)
    told = page.evaluate(IN_WORKER, [setting, {"steps": 100, "looks": 3, "log": True}])
    fleet = ds.Fleet.swarm(4, 2, 10)
    setup = set_up(Scenario(fleet, ds.DDS, ds.PAPER))
    cell, _ = setup.cell(np.random.SeedSequence(0, spawn_key=(0,)))
    cell = cell._replace(log=np.zeros(100_000, cell.log.dtype))
    cell = run_to_end(cell, cell_setup.to_ticks(120.0), setup.reserve)
    sent = cell.log[: cell.state["logged"][0]]
    rows = np.concatenate([share["rows"] for share in told["shares"]]).reshape(-1, 6)
    np.testing.assert_array_equal(rows, np.array(sent.tolist(), dtype=float))
    assert len(told["shares"]) > 3
    for share in told["shares"][:-1]:
        assert len(share["states"]) == 3
        assert share["states"][-1]["rows"] == len(share["rows"]) / 6
        assert share["states"][-1]["time"] == share["time"]
    *parts, last = told["shares"]
    assert not any(part["over"] for part in parts)
    assert last["done"] == 1
    assert last["complete"]
    (first,) = ds.simulate(fleet, ds.DDS, ds.PAPER).convergence_time
    assert told["result"]["converged"] == first


def test_a_run_ends_with_discovery_if_no_more_is_wanted(page: Page) -> None:
    setting = compare_wasm_with_python.paper_swarm_setting(4) | {
        "table": "DDS, periods of Fast DDS"
    }
    told = page.evaluate(IN_WORKER, [setting, {"steps": 300, "until": "complete"}])
    last = told["shares"][-1]
    assert last["complete"]
    # The last exchange ends a little after the time at which it began.
    assert last["time"] <= told["result"]["converged"] < last["time"] + 0.01
    assert not told["shares"][-2]["complete"]


def test_a_run_can_be_stopped_and_another_begun(page: Page) -> None:
    found = page.evaluate(
        """async (settings) => {
            let first;
            const shares = await new Promise((done) => {
                const seen = [];
                const each = (share) => done(seen.push(share));
                first = Live.run(settings[0], { steps: 100, each });
            });
            first.stop();
            const stopped = await first.found;
            const second = Live.run(settings[1]); // stops itself the one before
            const third = Live.run(settings[1]);
            return [stopped, await second.found, (await third.found).converged > 0];
        }""",
        [
            compare_wasm_with_python.paper_swarm_setting(60),
            compare_wasm_with_python.paper_swarm_setting(3),
        ],
    )
    assert found == [None, None, True]


@pytest.mark.parametrize(
    ("changed", "said"),
    [
        (
            {"fleet": {"groups": [{"hosts": 9000, "processes": 2, "endpoints": 10}]}},
            "needs more than 1000 MB of memory. Choose fewer robots",
        ),
        (
            {"table": "Fast DDS Discovery Server, on a robot"},
            "recovery must be False for the protocol 'Fast DDS Discovery Server, on a robot'",
        ),
        (
            {"fleet": {"groups": [{"hosts": 1, "processes": 2, "endpoints": 10}]}},
            "fleet must have at least 2 hosts to simulate; got 1",
        ),
    ],
)
def test_what_cannot_be_simulated_is_refused_and_the_next_run_works(
    page: Page, changed: dict[str, Any], said: str
) -> None:
    told = page.evaluate(IN_WORKER, [compare_wasm_with_python.paper_swarm_setting(3) | changed, {}])
    assert said in told["result"]["error"]
    assert (
        page.evaluate(IN_WORKER, [compare_wasm_with_python.paper_swarm_setting(3), {}])["result"][
            "converged"
        ]
        > 0
    )


# ---- size ----


def test_engine_and_tables_weigh_little() -> None:
    weights = {path.name: len(gzip.compress(path.read_bytes(), 9)) for path in LIVE.glob("*.js")}
    assert {"engine.js", "tables.js", "live.js"} <= weights.keys()
    assert sum(weights.values()) <= 64_000


def test_all_that_lives_on_pages_weighs_little() -> None:
    static = LIVE.parent
    files = [path for name in ("live", "landing", "chapters") for path in (static / name).iterdir()]
    files += [static / "guess.js"]
    calculator = ("simulate", "discovery_time", "changed_tables")
    files += [static / "calculator" / f"{name}.js" for name in calculator]
    assert sum(len(gzip.compress(path.read_bytes(), 9)) for path in files) <= 150_000


@pytest.mark.parametrize("path", sorted(LIVE.glob("*.js")), ids=lambda path: path.name)
def test_scripts_are_short(path: Path) -> None:
    lines = path.read_text(encoding="utf-8").splitlines()
    assert len(lines) <= 300 or lines[0].endswith("do not edit.")
