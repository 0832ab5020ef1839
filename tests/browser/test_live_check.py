"""Compare the engine in a thousand settings with numba, and in Chromium."""

import importlib
import subprocess
import sys

import pytest
from support import ROOT

pytestmark = pytest.mark.book

compare_wasm_with_python = importlib.import_module("compare_wasm_with_python")


@pytest.mark.usefixtures("options")
def test_the_engine_is_its_source_and_the_same_in_chromium() -> None:
    done = subprocess.run(
        [sys.executable, ROOT / "scripts" / "generate" / "compare_wasm_with_python.py"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    many = compare_wasm_with_python.MANY_SETTINGS
    assert f"settings {many}, same {many}," in done.stdout
