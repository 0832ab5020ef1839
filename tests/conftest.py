"""Fixtures of the tests of the whole: the built book, and a browser."""

from __future__ import annotations

import functools
import os
import shutil
import subprocess
import threading
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest
from support import (
    BUILD,
    ROOT,
    TOC,
    book_sources,
    newest_modification_time,
    restored_notebooks,
    skip_or_fail,
)

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page, ViewportSize


#: Left to `make test-all`: what visits pages more than once, runs the lab's programs, makes the
#: PDF, or sets up the project anew.
THOROUGH = (
    "browser/",
    "book/test_downloads.py",
    "book/test_pdf.py",
    "book/test_run_notebooks.py",
    "book/test_prestarted_notebook_kernels.py",
    "lab/test_failures.py",
    "lab/test_lab_programs.py",
    "lab/test_snippets.py",
    "project/test_setup.py",
)
#: One visit to each page is not.
ONE_VISIT = "browser/test_pages.py"


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    folder = Path(__file__).parent
    for item in items:
        if item.path.is_relative_to(folder):
            name = item.path.relative_to(folder).as_posix()
            if name.startswith(THOROUGH) and name != ONE_VISIT:
                item.add_marker(pytest.mark.thorough)


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return the current folder of a test of the command line, which holds a fleet file."""
    from command_line import NAV2  # here, as most tests need no command line

    monkeypatch.chdir(tmp_path)
    (tmp_path / "fleet.toml").write_text(NAV2, encoding="utf-8")
    return tmp_path


@pytest.fixture(scope="session")
def built() -> Path:
    """Return the folder that `make book` writes; make it unless it is newer than its sources."""
    import fcntl  # here, as Windows has none and the package's own tests need none

    done = BUILD / ".done"
    with TOC.open() as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)  # not twice at a time, whoever else runs tests
        if not done.exists() or done.stat().st_mtime < newest_modification_time(book_sources()):
            env = {k: v for k, v in os.environ.items() if k not in {"MAKEFLAGS", "MAKELEVEL"}}
            # Or what came out otherwise would be stored, and be right when it is run again.
            with restored_notebooks(ROOT / "notebooks"):
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
    """Return the path of Chromium, and its options."""
    names = ("chromium", "chromium-browser", "google-chrome")
    found = next(filter(None, map(shutil.which, names)), None)
    if found is None:
        message = "no Chromium here; on Debian: apt-get install chromium"
        skip_or_fail(message)
    return {
        "executable_path": found,
        # As root there is no sandbox, in a container little shared memory; nothing calls home.
        "args": ["--no-sandbox", "--disable-dev-shm-usage", "--disable-background-networking"],
    }


@pytest.fixture(scope="session")
def browser(options: dict[str, Any]) -> Iterator[Browser]:
    """Return a headless Chromium, the same for all tests of a process."""
    from playwright.sync_api import expect, sync_playwright  # here: most tests need no browser

    expect.set_options(timeout=60_000)  # a busy machine shows the same page later

    with sync_playwright() as playwright:
        chromium = playwright.chromium.launch(**options)
        yield chromium
        chromium.close()


@pytest.fixture(scope="session")
def open_tab(browser: Browser) -> Callable[..., AbstractContextManager[Page]]:
    """Return a function that opens an address in a light tab, offline; no script may fail."""

    @contextmanager
    def opened(
        address: str, viewport: ViewportSize, script: str = "", **others: Any
    ) -> Iterator[Page]:
        errors: list[str] = []
        options: dict[str, Any] = {"color_scheme": "light", "offline": True} | others
        with browser.new_context(viewport=viewport, **options) as context:
            page = context.new_page()
            page.on("pageerror", lambda error: errors.append(str(error)))
            if script:
                page.add_init_script(script)
            page.goto(address)
            yield page
        assert errors == []

    return opened


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
