"""Running notebooks in place: the same bytes every time, and errors that can be found."""

import os
import subprocess
import sys
from pathlib import Path

import nbformat
import pytest
from nbformat import v4
from support import ROOT, restored_notebooks, unshare_command

pytestmark = pytest.mark.book

SCRIPT = ROOT / "scripts/book/run_notebooks.py"


def write(path: Path, *sources: str) -> None:
    cells = [v4.new_markdown_cell("# Title")] + [v4.new_code_cell(source) for source in sources]
    nbformat.write(v4.new_notebook(cells=cells), path)


def run(path: Path, *sources: str) -> "subprocess.CompletedProcess[str]":
    write(path, *sources)
    return again(path)


def again(path: Path) -> "subprocess.CompletedProcess[str]":
    return command(sys.executable, SCRIPT, path, "--report", path.parent / "report")


def changed(folder: Path) -> str:
    return (folder / "report" / "changed_cells.csv").read_text(encoding="utf-8")


def command(*words: str | Path) -> "subprocess.CompletedProcess[str]":
    return subprocess.run(words, text=True, capture_output=True, check=False)


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
    assert changed(tmp_path) == "notebook,cells\ngood.ipynb,2 3\n"
    assert again(path).returncode == 0
    assert path.read_bytes() == once
    assert changed(tmp_path) == "notebook,cells\ngood.ipynb,\n"


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


def test_nothing_on_standard_error_gets_into_a_notebook(tmp_path: Path) -> None:
    path = tmp_path / "loud.ipynb"
    source = "import warnings; warnings.warn('a word')"
    done = run(path, "1", source)
    assert done.returncode == 1
    assert "loud.ipynb, cell 3, wrote to standard error:" in done.stderr
    assert "a word" in done.stderr
    assert "a word" not in path.read_text().replace(source, "")


def test_words_on_a_line_are_found_on_the_page_and_on_the_phone(tmp_path: Path) -> None:
    path = tmp_path / "figures.ipynb"
    setup = "from discostorm_book import show; show.setup(); from matplotlib.figure import Figure"
    drawn = (
        f"figure = Figure(figsize=(8, 3)); figure.suptitle('At {x}'); axes = figure.subplots()\n"
        f"axes.plot([0, 1], [1, 0]); axes.text({x}, 0.5, 'many words', ha='center')\nfigure"
        for x in (0.2, 0.38, 0.5)
    )
    done = run(path, "sorted(name for name in globals() if name[0] != '_')", setup, *drawn)
    assert done.returncode == 1
    _, *said = done.stderr.rstrip().splitlines()
    words = "'many words' and a line"
    assert said == [f"At {x}: {words}" for x in (0.38, 0.5, 0.5)] + ["", "1 of 1 notebooks failed"]
    assert "figures.ipynb has figures whose words cover something:" in done.stderr
    # It is written, to be looked at, and what measures leaves no names to its cells.
    _, names, _, *shown = nbformat.read(path, as_version=4).cells
    text = names.outputs[0].data["text/plain"]
    assert text == "['In', 'Out', 'exit', 'get_ipython', 'open', 'quit']"
    assert all("image/svg+xml" in cell.outputs[0].data for cell in shown)


def test_a_home_that_cannot_be_written_changes_no_notebook(tmp_path: Path) -> None:
    """As for accounts without a home; Matplotlib and IPython would keep their things there."""
    for name in ("scripts", "Makefile", "pyproject.toml", "requirements.lock"):
        (tmp_path / name).symlink_to(ROOT / name)
    (tmp_path / ".venv").symlink_to(Path(sys.prefix))
    (tmp_path / "notebooks").mkdir()
    path = tmp_path / "notebooks" / "one.ipynb"
    write(path, "import matplotlib.pyplot as plt\nplt.rcParams['figure.dpi']")
    taken = ("MPLCONFIGDIR", "IPYTHONDIR", "MAKEFLAGS", "MAKELEVEL")
    env = {name: value for name, value in os.environ.items() if name not in taken}
    done = subprocess.run(
        ["make", "notebooks", "--assume-old=.venv/.ready"],
        cwd=tmp_path,
        env=env | {"HOME": "/dev/null/home"},
        text=True,
        capture_output=True,
        check=False,
    )
    assert (done.returncode, done.stderr) == (0, "")
    assert [len(cell.outputs) for cell in nbformat.read(path, as_version=4).cells[1:]] == [1]


def test_tests_leave_notebooks_alone(tmp_path: Path) -> None:
    """Or one that came out otherwise would be found to be so by the first of two tests only."""
    one, two = tmp_path / "one.ipynb", tmp_path / "two.ipynb"
    for path in (one, two):
        path.write_text("as it is")
    then = one.stat().st_mtime_ns
    with restored_notebooks(tmp_path):
        one.write_text("otherwise")
        os.utime(one, ns=(then + 10**9, then + 10**9))
    assert [path.read_text() for path in (one, two)] == ["as it is"] * 2
    assert one.stat().st_mtime_ns == then  # so that the book, which is newer, is not made again


def test_without_loopback_it_is_said_at_once() -> None:
    script = ROOT / "scripts" / "check_loopback.py"
    done = command(*unshare_command("--net"), "timeout", "20", sys.executable, script)
    assert done.returncode == 1
    assert "127.0.0.1 does not answer ([Errno 101] Network is unreachable)" in done.stderr
    assert "ip link set lo up" in done.stderr


def test_notebooks_need_no_network_not_even_loopback(tmp_path: Path) -> None:
    path = tmp_path / "good.ipynb"
    write(path, "1")
    long = tmp_path / ("long" * 30)  # too long for a socket
    long.mkdir()
    words = [*unshare_command("--net"), "env", f"TMPDIR={long}", sys.executable, SCRIPT, path]
    done = command(*words)
    assert (done.returncode, done.stderr) == (0, "")


def test_a_full_disk_leaves_the_notebook_as_it_was(tmp_path: Path) -> None:
    path = tmp_path / "big.ipynb"
    write(path, "'x' * 30_000")
    small = f"""
        mount -t tmpfs -o size=16k small {tmp_path}/small
        cd {tmp_path}/small && cp ../big.ipynb . && {sys.executable} {SCRIPT} big.ipynb
        echo $?; ls; cmp big.ipynb ../big.ipynb && echo the same
    """
    (tmp_path / "small").mkdir()
    done = command(*unshare_command("--mount"), "sh", "-c", small)
    assert "big.ipynb: OSError: [Errno 28] No space left on device" in done.stderr
    assert done.stdout.splitlines()[1:] == ["1", "big.ipynb", "the same"]
