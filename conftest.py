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
HELD_LOCKS: list[IO[str]] = []


def pytest_sessionstart() -> None:
    """Do not run beside a campaign of the lab, whose cores have to be idle."""
    try:
        import fcntl  # Windows has none, and no lab
    except ImportError:
        return
    file = Path(__file__).parent / "build" / "lab.lock"
    with contextlib.suppress(OSError):  # where nothing can be written, no campaign runs
        file.parent.mkdir(exist_ok=True)
        HELD_LOCKS.append(lock := file.open("a"))
        try:
            fcntl.flock(lock, fcntl.LOCK_SH | fcntl.LOCK_NB)
        except BlockingIOError:
            pytest.exit("a campaign of the lab is running: run the tests when it has ended", 1)
        os.environ["DISCOSTORM_LAB_LOCK"] = "tests"


def pytest_unconfigure() -> None:
    """Let campaigns of the lab begin again."""
    for lock in HELD_LOCKS:
        lock.close()


#: Files whose tests take longest; they begin first, so that no process has them left at the end.
SLOWEST_TESTS = (
    "browser/test_live_check.py",
    "browser/test_calculator.py",
    "lab/test_snippets.py",
    "lab/test_lab_programs.py",
    "tests/test_plan_output.py",
    "tests/test_plan_of_protocols.py",
    "tests/test_aggregation_range.py",
    "tests/test_discovery.py",
    "capture/tests/test_watch.py",
    "capture/tests/test_reading.py",
    "tests/test_plan_text.py",
    "whole/test_diagnosis_of_lab_runs.py",
)
#: Its pages take a few seconds each, so they end at about the same time in all processes.
PAGE_TESTS = "browser/test_pages.py"


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Put what takes longest first, and pages last."""

    def rank(item: pytest.Item) -> int:
        path = item.path.as_posix()
        order = (n for n, name in enumerate(SLOWEST_TESTS) if path.endswith(name))
        return next(order, len(SLOWEST_TESTS) + path.endswith(PAGE_TESTS))

    items.sort(key=rank)


class ByFileOrPage(LoadScopeScheduling):
    """Keep in one process the tests of a file, and of browser/test_pages.py those of a page."""

    def _split_scope(self, nodeid: str) -> str:
        file, _, test = nodeid.partition("::")
        if file.endswith(("test_links.py", "test_chapters.py")):
            return "links"  # both look at all pages, which are parsed once
        if not file.endswith(PAGE_TESTS):
            return file
        page = test.partition("[")[2].removesuffix("]")
        return f"page {page.removesuffix('-http').removesuffix('-file')}"


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config: pytest.Config, log: Producer) -> ByFileOrPage:
    config.option.loadscopereorder = False  # not by the number of tests
    return ByFileOrPage(config, log)
