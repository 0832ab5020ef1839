"""Helpers for the tests of all packages: paths, and skips of tests whose tools are missing."""

import os
import shutil
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, NoReturn

import pytest

ROOT = Path(__file__).parents[2]
HELPERS = ROOT / "tests" / "helpers"
REFERENCE = ROOT / "tests" / "reference"
BUILD = ROOT / "_build"
TOC = ROOT / "_toc.yml"


def newest_modification_time(paths: Iterator[Path]) -> float:
    """Return the modification time of the newest file."""
    return max(path.stat().st_mtime for path in paths if path.is_file())


def book_sources() -> Iterator[Path]:
    """Yield the source files of the book."""
    yield from (ROOT / name for name in ("_config.yml", "_toc.yml", "CITATION.cff", "Makefile"))
    yield from (ROOT / "notebooks").glob("*.ipynb")
    for folder in ("book", "discostorm", "packages"):
        yield from (p for p in (ROOT / folder).rglob("*.*") if "__pycache__" not in p.parts)


def skip_or_fail(message: str) -> NoReturn:
    """Skip a test; fail if no test may be skipped."""
    if os.environ.get("DISCOSTORM_SKIP_NOTHING") == "1":
        pytest.fail(message)
    pytest.skip(message)


def unshare_command(*namespaces: str) -> list[str]:
    """Return the prefix of a command that runs in new namespaces."""
    start = ["unshare", *namespaces, *([] if os.geteuid() == 0 else ["--map-root-user"])]
    if shutil.which("unshare") is None or subprocess.run([*start, "true"], check=False).returncode:
        skip_or_fail(f"this needs leave for {' '.join(start)}")
    return start


@contextmanager
def restored_notebooks(folder: Path) -> Iterator[None]:
    """Restore the content and modification time of a folder's notebooks afterwards."""
    before = {path: (path.read_bytes(), path.stat()) for path in folder.glob("*.ipynb")}
    try:
        yield
    finally:
        for path, (content, status) in before.items():
            if path.read_bytes() != content:
                path.write_bytes(content)
                os.utime(path, ns=(status.st_atime_ns, status.st_mtime_ns))


def is_running(process: int) -> bool:
    """Return whether a process is running; a zombie counts as ended."""
    try:
        stat = Path(f"/proc/{process}/stat").read_text(encoding="utf-8")
    except OSError:
        return False
    return stat.rpartition(")")[2].split()[0] not in "ZX"


def transmission_table(found: Any) -> Any:
    """Return the first transmissions of the first run of a simulation, one row each."""
    import pandas as pd

    sent, hosts = found.transmissions, int(found.settings["hosts"])
    # Negative kinds are requests and agreements, not messages.
    others = ["block ACK agreement", "block ACK request"]
    names = [*(message.name for message in found.protocol.messages), *others]
    stations = [*(f"host {number + 1}" for number in range(hosts)), "access point"]
    return pd.DataFrame(
        {
            "start_s": sent["start"] * 1e-7,
            "end_s": sent["end"] * 1e-7,
            "station": [stations[number] for number in sent["station"]],
            "message": [names[kind] for kind in sent["kind"]],
            "frames": sent["frames"],
            "outcome": [("success", "collision", "error")[one] for one in sent["outcome"]],
        }
    )


def check_first_sentence(summary: str, cause: str, evidence: str, action: str) -> None:
    """Check that the first sentence of a diagnosis has a cause, and evidence and action follow."""
    first, rest = summary.split(f": {cause}", 1)
    assert first.startswith(("Discovery is not healthy", "Discovery is neither healthy nor"))
    assert "complete and settled" not in first
    assert evidence in rest
    assert action in rest
