"""Kernels that start as copies: they end with what asked for them, and hide no failure."""

import os
import subprocess
import sys
import time
from pathlib import Path

import nbformat
import pytest
from nbformat import v4
from support import ROOT, is_running

pytestmark = [
    pytest.mark.book,
    pytest.mark.skipif(sys.platform != "linux", reason="elsewhere kernels start cold"),
]

SCRIPTS = ROOT / "scripts/book"
SCRIPT = SCRIPTS / "run_notebooks.py"


def write(path: Path, *sources: str) -> None:
    cells = [v4.new_code_cell(source) for source in sources]
    nbformat.write(v4.new_notebook(cells=cells), path)


def run(*paths: Path, **env: str) -> "subprocess.CompletedProcess[str]":
    return subprocess.run(
        [sys.executable, SCRIPT, *paths],
        env=os.environ | env,
        text=True,
        capture_output=True,
        check=False,
    )


def test_a_kernel_is_warm_and_otherwise_as_one_that_starts_cold(tmp_path: Path) -> None:
    path = tmp_path / "one.ipynb"
    write(
        path,
        "import os, sys\n'sympy' in sys.modules",
        "print(os.getcwd(), [p for p in sys.path if p.endswith('scripts')], os.environ['A_WORD'])",
        "import matplotlib.pyplot as plt\nplt.plot([1, 2]);",
    )
    done = run(path, A_WORD="as it is")
    assert (done.returncode, done.stderr) == (0, "")
    first, second, third = (cell.outputs[0] for cell in nbformat.read(path, 4).cells)
    assert first.data["text/plain"] == "True"
    assert second.text == f"{tmp_path} [] as it is\n"
    # What arranges the display of figures has to find a kernel when it is imported.
    assert "image/png" in third.data


def test_what_one_kernel_does_another_does_not_see(tmp_path: Path) -> None:
    one, two = tmp_path / "one.ipynb", tmp_path / "two.ipynb"
    for path in (one, two):
        write(path, "import sympy\nassert not hasattr(sympy, 'mark')\nsympy.mark = 1")
    assert run(one, two).returncode == 0


def test_a_kernel_that_dies_is_told(tmp_path: Path) -> None:
    path = tmp_path / "dies.ipynb"
    write(path, "1", "import os\nos._exit(3)")
    done = run(path)
    assert done.returncode == 1
    assert "dies.ipynb, cell 2:" in done.stderr


def test_kernels_end_with_what_runs_them(tmp_path: Path) -> None:
    path, here = tmp_path / "long.ipynb", tmp_path / "process"
    write(
        path,
        f"import os, time\nfrom pathlib import Path\nhere = Path('{here}')",
        "new = here.with_suffix('.new')\nnew.write_text(str(os.getpid()))\nnew.rename(here)",
        "time.sleep(600)",
    )
    with subprocess.Popen([sys.executable, SCRIPT, path]) as runner:
        end = time.monotonic() + 300
        while not here.exists():
            assert time.monotonic() < end, "the cell runs"
            time.sleep(0.1)
        kernel = int(here.read_text())
        assert is_running(kernel)
        runner.kill()
    end = time.monotonic() + 60
    while is_running(kernel):
        assert time.monotonic() < end, "the kernel ends"
        time.sleep(0.1)


def test_what_an_import_writes_to_standard_error_is_a_failure() -> None:
    """As it is in a cell, which no longer imports it first."""
    program = (
        "import prestarted_notebook_kernels as w, sys, types\n"
        "import importlib\n"
        "importlib.import_module = lambda name: print('a word', file=sys.stderr)\n"
        "w.import_modules()"
    )
    done = subprocess.run(
        [sys.executable, "-c", program],
        env=os.environ | {"PYTHONPATH": str(SCRIPTS)},
        text=True,
        capture_output=True,
        check=False,
    )
    assert done.returncode == 1
    assert "wrote to standard error:\na word" in done.stderr
