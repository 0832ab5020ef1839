"""What all tests share: examples that are the same in every run, the built book, a browser."""

from __future__ import annotations

import functools
import os
import shutil
import subprocess
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn

import pytest
from hypothesis import settings
from xdist.remote import Producer
from xdist.scheduler import LoadScopeScheduling

if TYPE_CHECKING:
    from playwright.sync_api import Browser

settings.register_profile("same", derandomize=True, database=None, deadline=None)
settings.load_profile("same")

ROOT = Path(__file__).parents[1]
BUILD = ROOT / "_build"
TOC = ROOT / "_toc.yml"


def newest(paths: Iterator[Path]) -> float:
    """Return when the last of the files was changed."""
    return max(path.stat().st_mtime for path in paths if path.is_file())


def sources() -> Iterator[Path]:
    """Yield all that the book is made from."""
    yield from (ROOT / name for name in ("_config.yml", "_toc.yml", "CITATION.cff", "Makefile"))
    yield from (ROOT / "notebooks").glob("*.ipynb")
    for folder in ("book", "discostorm"):
        yield from (p for p in (ROOT / folder).rglob("*.*") if "__pycache__" not in p.parts)


class ByFileOrPage(LoadScopeScheduling):
    """Keep in one process the tests of a file, of simulation, and in test_browser.py of a page.

    Simulation comes first, as it has most tests, and pages last, as they take a few seconds each:
    so all processes end at about the same time.
    """

    def _split_scope(self, nodeid: str) -> str:
        file, _, test = nodeid.partition("::")
        simulating = ("air", "hybrid", "landing", "live", "own_starts", "recovery", "trace")
        if "simulat" in nodeid or file.endswith(tuple(f"test_{name}.py" for name in simulating)):
            return "simulation"  # compiled by one of the processes, and not by each
        if file.endswith(("test_links.py", "test_chapters.py")):
            return "links"  # both look at all pages, which are parsed once
        if not file.endswith("test_browser.py"):
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


def missing(message: str) -> NoReturn:
    """Skip a test; fail where nothing may be skipped."""
    if os.environ.get("DISCOSTORM_SKIP_NOTHING") == "1":
        pytest.fail(message)
    pytest.skip(message)


def unshare(*namespaces: str) -> list[str]:
    """Return the start of a command that runs the rest in namespaces of its own."""
    start = ["unshare", *namespaces, *([] if os.geteuid() == 0 else ["--map-root-user"])]
    if shutil.which("unshare") is None or subprocess.run([*start, "true"], check=False).returncode:
        missing(f"this needs leave for {' '.join(start)}")
    return start


@contextmanager
def left_alone(folder: Path) -> Iterator[None]:
    """Give notebooks of a folder back what they held, and when they were written, afterwards."""
    before = {path: (path.read_bytes(), path.stat()) for path in folder.glob("*.ipynb")}
    try:
        yield
    finally:
        for path, (content, status) in before.items():
            if path.read_bytes() != content:
                path.write_bytes(content)
                os.utime(path, ns=(status.st_atime_ns, status.st_mtime_ns))


@pytest.fixture(scope="session")
def built() -> Path:
    """Return the folder that `make book` writes; make it unless it is newer than its sources."""
    import fcntl  # here, as Windows has none and the package's own tests need none

    done = BUILD / ".done"
    with TOC.open() as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)  # not twice at a time, whoever else runs tests
        if not done.exists() or done.stat().st_mtime < newest(sources()):
            env = {k: v for k, v in os.environ.items() if k not in {"MAKEFLAGS", "MAKELEVEL"}}
            # Or what came out otherwise would be stored, and be right when it is run again.
            with left_alone(ROOT / "notebooks"):
                made = subprocess.run(
                    ["make", "book"], cwd=ROOT, env=env, capture_output=True, text=True, check=False
                )
            assert made.returncode == 0, f"make book failed:\n{made.stdout}{made.stderr}"
    return BUILD


@pytest.fixture(scope="session")
def book(browser: Browser, request: pytest.FixtureRequest) -> Path:  # noqa: ARG001 - see below
    """Return the folder of the book's pages; without a browser there is no need to build them."""
    built: Path = request.getfixturevalue("built")
    return built / "html"


@pytest.fixture(scope="session")
def options() -> dict[str, Any]:
    """Return which Chromium there is, and with what it is started."""
    names = ("chromium", "chromium-browser", "google-chrome")
    found = next(filter(None, map(shutil.which, names)), None)
    if found is None:
        message = "no Chromium here; on Debian: apt-get install chromium"
        missing(message)
    return {
        "executable_path": found,
        # As root there is no sandbox, in a container little shared memory; nothing calls home.
        "args": ["--no-sandbox", "--disable-dev-shm-usage", "--disable-background-networking"],
    }


@pytest.fixture(scope="session")
def browser(options: dict[str, Any]) -> Iterator[Browser]:
    """Return a headless Chromium, the same for all tests of a process."""
    from playwright.sync_api import sync_playwright  # here, as most tests need no browser

    with sync_playwright() as playwright:
        chromium = playwright.chromium.launch(**options)
        yield chromium
        chromium.close()


@pytest.fixture(scope="session")
def server(book: Path) -> Iterator[str]:
    """Serve the book on this machine; return its address."""

    class Quiet(SimpleHTTPRequestHandler):
        def log_message(self, format: str, *args: object) -> None:  # noqa: A002
            pass

    with ThreadingHTTPServer(
        ("127.0.0.1", 0), functools.partial(Quiet, directory=str(book))
    ) as http:
        thread = threading.Thread(target=http.serve_forever)
        thread.start()
        yield f"http://127.0.0.1:{http.server_port}/"
        http.shutdown()
        thread.join()
