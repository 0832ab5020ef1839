"""Processes of a simulation end with the one that started them, however that ends."""

import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

#: Two runs that write who they are and then take for ever, started as a simulation starts them.
PROGRAM = """
import os, time
from pathlib import Path
from types import SimpleNamespace
from discostorm import simulation
from discostorm_simulation import _workers, run

def endless(folder, seed):
    (Path(folder.name) / str(os.getpid())).touch()
    time.sleep(600)

_workers.cpu_count = lambda: 2
run.compiled = lambda: None
run.one_run = endless
setup = SimpleNamespace(name={folder!r}, estimate=lambda: (10.0, 1.0))
simulation._all_runs(setup, [0, 1])
"""


def running(process: int) -> bool:
    """Return whether a process runs; one that ended may wait for its parent as a zombie."""
    try:
        stat = Path(f"/proc/{process}/stat").read_text(encoding="utf-8")
    except OSError:
        return False
    return stat.rpartition(")")[2].split()[0] not in "ZX"


def wait_for(what: str, holds: Callable[[], bool], seconds: float = 60.0) -> None:
    end = time.monotonic() + seconds
    while not holds():
        assert time.monotonic() < end, what
        time.sleep(0.05)


@pytest.mark.skipif(not Path("/proc/self/stat").exists(), reason="looks at /proc")
@pytest.mark.parametrize("how", [signal.SIGTERM, signal.SIGKILL])
def test_processes_end_with_the_one_that_started_them(how: signal.Signals, tmp_path: Path) -> None:
    program = PROGRAM.format(folder=str(tmp_path))
    with subprocess.Popen([sys.executable, "-c", program], stderr=subprocess.DEVNULL) as parent:
        wait_for("both start", lambda: len(list(tmp_path.iterdir())) == 2)
        processes = [int(path.name) for path in tmp_path.iterdir()]
        assert parent.pid not in processes
        assert all(map(running, processes))
        parent.send_signal(how)
        assert parent.wait(10) == -how
    # They look twice a second; without it they are there for 10 minutes.
    wait_for("the processes end", lambda: not any(map(running, processes)), 20)
