"""Compare the engine in a thousand settings with numba, and in Chromium."""

import importlib
import subprocess
import sys

import pytest
from support import ROOT

pytestmark = pytest.mark.book

check_wasm = importlib.import_module("check_wasm")


@pytest.mark.usefixtures("options")
def test_the_engine_is_its_source_and_the_same_in_chromium() -> None:
    done = subprocess.run(
        [sys.executable, ROOT / "scripts" / "generate" / "check_wasm.py"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    assert f"settings {check_wasm.MANY}, same {check_wasm.MANY}," in done.stdout
