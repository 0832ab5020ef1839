"""The wheel: every module works with what it asks for, or says which extra has the rest."""

import os
import re
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest
from support import ROOT

pytestmark = pytest.mark.book


from check_dist import fill  # noqa: E402

#: Imports each named module and prints it with the error, if there is one.
IMPORT = """
import importlib, sys
sys.path += sys.argv[1:3]
for name in sys.argv[3:]:
    try:
        importlib.import_module(name)
    except ImportError as error:
        print(name, error, sep=": ")
"""


#: Runs the code cells of a notebook.
RUN = """
import json, sys
sys.path += sys.argv[1:3]
from IPython.core.interactiveshell import InteractiveShell
shell = InteractiveShell.instance()
with open(sys.argv[3], encoding="utf-8") as file:
    cells = json.load(file)["cells"]
for cell in cells:
    if cell["cell_type"] == "code":
        shell.run_cell("".join(cell["source"])).raise_error()
"""


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Build the wheel and return the folder that it is installed into."""
    folder = tmp_path_factory.mktemp("wheel")
    build = [sys.executable, "-m", "hatchling", "build", "--target", "wheel", "--directory", folder]
    subprocess.run(build, cwd=ROOT, check=True, capture_output=True)
    (file,) = folder.glob("*.whl")
    with zipfile.ZipFile(file) as archive:
        archive.extractall(folder / "site")  # all that an installer does for pure Python
    return folder / "site"


def fresh(folder: Path, wheel: Path, *extras: str) -> dict[str, str]:
    """Import all modules of the wheel beside what it needs alone; return the errors by module."""
    fill(folder, wheel, *extras)
    modules = sorted(
        ".".join(path.relative_to(wheel).with_suffix("").parts).removesuffix(".__init__")
        for path in (wheel / "discostorm").rglob("*.py")
    )
    assert "discostorm_book.notebook" in modules
    modules.remove("discostorm.__main__")
    # Without the site-packages of this Python.
    command = [sys.executable, "-I", "-S", "-c", IMPORT, wheel, folder, *modules]
    done = subprocess.run(command, cwd=folder, text=True, capture_output=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")
    return dict(line.split(": ", 1) for line in done.stdout.splitlines())


def test_a_module_without_its_extra_says_which(tmp_path: Path, wheel: Path) -> None:
    errors = fresh(tmp_path, wheel)
    books = {error for module, error in errors.items() if module.startswith("discostorm_book")}
    assert len(books) == 1, "one error, whichever of its modules is imported"
    for module, error in errors.items():
        extra = "book" if module.startswith("discostorm_book") else "simulation"
        assert re.search(rf"pip install 'discostorm\[{extra}\]'", error), f"{module}: {error}"


def test_with_its_extras_every_module_works(tmp_path: Path, wheel: Path) -> None:
    assert fresh(tmp_path, wheel, "book", "simulation") == {}


# The command line, captures, what the lab counted, and the prototype.
@pytest.mark.parametrize("name", ["21_command_line", "00_captures", "10_products", "15_hybrid"])
def test_a_downloaded_chapter_needs_the_extra_alone(tmp_path: Path, wheel: Path, name: str) -> None:
    fill(tmp_path, wheel, "book")
    copy = tmp_path / "downloads" / f"{name}.ipynb"
    copy.parent.mkdir()
    copy.write_bytes((ROOT / "notebooks" / f"{name}.ipynb").read_bytes())
    command = [sys.executable, "-I", "-S", "-c", RUN, wheel, tmp_path, copy]
    environment = os.environ | {"MPLBACKEND": "agg", "IPYTHONDIR": str(tmp_path / "ipython")}
    done = subprocess.run(
        command, cwd=copy.parent, env=environment, text=True, capture_output=True, check=False
    )
    assert done.returncode == 0, done.stdout[-2000:] + done.stderr
    assert [*copy.parent.iterdir()] == [copy]
