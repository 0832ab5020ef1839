"""Running notebooks in place: the same bytes every time, and errors that can be found."""

import subprocess
import sys
from pathlib import Path

import nbformat
import pytest
from nbformat import v4

pytestmark = pytest.mark.book

SCRIPT = Path(__file__).parents[1] / "scripts" / "run_notebooks.py"


def run(path: Path, *sources: str) -> "subprocess.CompletedProcess[str]":
    cells = [v4.new_markdown_cell("# Title")] + [v4.new_code_cell(source) for source in sources]
    nbformat.write(v4.new_notebook(cells=cells), path)
    return again(path)


def again(path: Path) -> "subprocess.CompletedProcess[str]":
    return subprocess.run(
        [sys.executable, SCRIPT, path], text=True, capture_output=True, check=False
    )


def test_a_notebook_comes_out_the_same(tmp_path: Path) -> None:
    path = tmp_path / "good.ipynb"
    slowly = "import time\nfor n in range(3):\n    print(n, flush=True)\n    time.sleep(0.3)"
    first = run(path, slowly, "6 * 7")
    assert (first.returncode, first.stderr) == (0, "")
    assert first.stdout.startswith("[1/1] good.ipynb ")
    once = path.read_bytes()
    _, printed, result = nbformat.read(path, as_version=4).cells
    assert [output.text for output in printed.outputs] == ["0\n1\n2\n"]
    assert result.outputs[0].data["text/plain"] == "42"
    assert again(path).returncode == 0
    assert path.read_bytes() == once


def test_an_error_names_notebook_and_cell_and_leaves_the_file(tmp_path: Path) -> None:
    path = tmp_path / "bad.ipynb"
    done = run(path, "1", "assert 1 == 2, 'no claim'", "3")
    assert done.returncode == 1
    assert "bad.ipynb FAILED" in done.stdout
    assert "bad.ipynb, cell 3:" in done.stderr
    assert "no claim" in done.stderr
    assert all(not cell.get("outputs") for cell in nbformat.read(path, as_version=4).cells)


def test_a_missing_notebook_is_named(tmp_path: Path) -> None:
    done = again(tmp_path / "none.ipynb")
    assert done.returncode == 2
    assert "none.ipynb" in done.stderr
