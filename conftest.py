"""What all tests share: the same examples in every run, and which run in one process."""

import contextlib
import os
from pathlib import Path
from typing import IO

import pytest
from hypothesis import settings
from xdist.remote import Producer
from xdist.scheduler import LoadScopeScheduling

settings.register_profile("same", derandomize=True, database=None, deadline=None)
settings.load_profile("same")


#: Kept open until the tests end.
LOCKED: list[IO[str]] = []


def pytest_sessionstart() -> None:
    """Do not run beside a campaign of the lab, whose cores have to be idle."""
    try:
        import fcntl  # Windows has none, and no lab
    except ImportError:
        return
    file = Path(__file__).parent / "build" / "lab.lock"
    with contextlib.suppress(OSError):  # where nothing can be written, no campaign runs
        file.parent.mkdir(exist_ok=True)
        LOCKED.append(lock := file.open("a"))
        try:
            fcntl.flock(lock, fcntl.LOCK_SH | fcntl.LOCK_NB)
        except BlockingIOError:
            pytest.exit("a campaign of the lab is running: run the tests when it has ended", 1)
        os.environ["DISCOSTORM_LAB_LOCK"] = "tests"


def pytest_unconfigure() -> None:
    """Let campaigns of the lab begin again."""
    for lock in LOCKED:
        lock.close()


class ByFileOrPage(LoadScopeScheduling):
    """Keep in one process the tests of a file, of simulation, and of browser/test_pages.py a page.

    Simulation comes first, as it has most tests, and pages last, as they take a few seconds each:
    so all processes end at about the same time.
    """

    def _split_scope(self, nodeid: str) -> str:
        file, _, test = nodeid.partition("::")
        simulating = ("landing_picture", "hybrid", "landing", "wasm", "recovery", "frame_trace")
        if "simulat" in nodeid or file.endswith(tuple(f"test_{name}.py" for name in simulating)):
            return "simulation"  # compiled by one of the processes, and not by each
        if file.endswith(("test_links.py", "test_chapters.py")):
            return "links"  # both look at all pages, which are parsed once
        if not file.endswith("browser/test_pages.py"):
            return file
        page = test.partition("[")[2].removesuffix("]")
        return f"page {page.removesuffix('-http').removesuffix('-file')}"

    def schedule(self) -> None:
        first = self.collection is None
        super().schedule()
        if first:
            for scope in [scope for scope in self.workqueue if scope.startswith("page ")]:
                self.workqueue.move_to_end(scope)


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config: pytest.Config, log: Producer) -> ByFileOrPage:
    return ByFileOrPage(config, log)
