"""The engine: instructions of runs, interrupts, and growth of memory."""

import subprocess
import sys

import numpy as np
import pytest
import wasmtime

import discostorm as ds
from discostorm_simulation.cell_setup import to_ticks
from discostorm_simulation.engine import LoadedCell, run_to_end
from discostorm_simulation.initial_state import POOL_ENTRIES
from discostorm_simulation.run import Scenario, Setup, set_up

END = to_ticks(120.0)


def setup_of(hosts: int, processes: int, endpoints: int) -> Setup:
    return set_up(Scenario(ds.Fleet.swarm(hosts, processes, endpoints), ds.DDS, ds.PAPER))


#: Instructions of whole runs [millions]. Load does not change them; a few percent more fail.
MILLIONS = {(12, 2, 10): 85.6, (25, 2, 10): 812.3, (8, 1, 678): 832.8}


@pytest.mark.parametrize(("fleet", "millions"), MILLIONS.items())
def test_runs_take_no_more_instructions_than_they_did(
    fleet: tuple[int, int, int], millions: float
) -> None:
    setup, limit = setup_of(*fleet), round(1.05e6 * millions)
    loaded = LoadedCell(setup.cell(np.random.SeedSequence(0))[0], limit)
    assert loaded.advance(END, setup.reserve, 10**9)
    assert limit - loaded.store.get_fuel() > 0.9e6 * millions


def test_a_run_without_instructions_left_ends() -> None:
    setup = setup_of(12, 2, 10)
    loaded = LoadedCell(setup.cell(np.random.SeedSequence(0))[0], 10**6)
    with pytest.raises(wasmtime.Trap, match="fuel"):
        loaded.advance(END, setup.reserve, 10**9)


def test_shares_and_memory_change_nothing() -> None:
    setup = setup_of(12, 2, 10)
    loaded = LoadedCell(setup.cell(np.random.SeedSequence(0))[0])
    while not loaded.advance(END, setup.reserve, 137):
        pass
    assert loaded.cell.pool.size > POOL_ENTRIES
    whole = run_to_end(setup.cell(np.random.SeedSequence(0))[0], END, setup.reserve)
    for name, array in whole._asdict().items():
        assert array.tobytes() == getattr(loaded.cell, name).tobytes(), name


#: Runs that take minutes and announce their start; then the processor time until Ctrl-C ends them.
ENDLESS = """
import threading, time, signal, os
import discostorm as ds
from discostorm_simulation import run
fleet = ds.Fleet.swarm(150, 2, 10)
began = []
def interrupt():
    began.append(time.process_time())
    os.kill(os.getpid(), signal.SIGINT)
signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell's background ignores it
timer = threading.Timer(0.3, interrupt)
def simulate_run(*arguments, original=run.simulate_run):
    if not timer.ident:
        timer.start()
    return original(*arguments)
run.simulate_run = simulate_run
try:
    ds.simulate(fleet, ds.DDS, ds.PAPER, runs={runs})
except KeyboardInterrupt:
    print(time.process_time() - began[0])
"""


@pytest.mark.skipif(sys.platform == "win32", reason="sends itself a signal")
@pytest.mark.parametrize("runs", [1, 2])
def test_ctrl_c_ends_a_run_soon(runs: int) -> None:
    code = ENDLESS.format(runs=runs)
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    # Without an interrupt, the run takes minutes; we measured 0.1 s for each thread.
    assert float(run.stdout) < 1, run.stderr
