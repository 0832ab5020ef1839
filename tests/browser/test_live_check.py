"""Compare the engine with numba and in Chromium, in an eighth of `make live-check`'s settings."""

import importlib
import subprocess
import sys

import pytest
from support import ROOT

pytestmark = pytest.mark.book

compare_wasm_with_python = importlib.import_module("compare_wasm_with_python")


@pytest.mark.usefixtures("options")
def test_the_engine_is_its_source_and_the_same_in_chromium() -> None:
    program = ROOT / "scripts" / "generate" / "compare_wasm_with_python.py"
    count = compare_wasm_with_python.MANY_SETTINGS // 8
    done = subprocess.run(
        [sys.executable, program, "--settings", str(count)],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    assert f"settings {count}, same {count}," in done.stdout
