"""Check the published distributions: source archives, wheels, index pages and examples.

`--alone` tests each package in an environment with only its wheel and that wheel's requirements.
"""

import argparse
import csv
import doctest
import hashlib
import os
import re
import shlex
import shutil
import subprocess
import sys
import tarfile
import tempfile
import zipfile
from collections.abc import Iterator
from importlib.metadata import Distribution, distribution
from pathlib import Path

from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

ROOT = Path(__file__).parents[2]
#: Pages whose examples must run with all packages installed.
PAGES = ("PYPI.md", "README.md")
LICENSE_FILES = ("LICENSE", "LICENSE-CC-BY-4.0.txt")
#: Chapters that run as downloads, without a checkout: command line, captures, the lab's counts, and
#: the prototype.
DOWNLOADED_CHAPTERS = ("21_command_line", "00_captures", "10_products", "15_hybrid")
#: Script: run the code cells of a notebook.
_RUN = """
import json, sys
from IPython.core.interactiveshell import InteractiveShell
shell = InteractiveShell.instance()
with open(sys.argv[1], encoding="utf-8") as file:
    cells = json.load(file)["cells"]
for cell in cells:
    if cell["cell_type"] == "code":
        shell.run_cell("".join(cell["source"])).raise_error()
"""
#: Requirements of the tests themselves.
TEST_TOOLS = ("hypothesis", "pytest", "pytest-xdist")


def read_packages() -> list[dict[str, str]]:
    """Return the rows of packages/packages.csv, each package after its requirements."""
    with (ROOT / "packages/packages.csv").open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def required_distributions(package: Distribution, extras: set[str]) -> set[str]:
    """Return the distributions that a package requires, directly or indirectly."""
    names: set[str] = set()
    todo = [(package, frozenset(extras))]
    visited = set()
    while todo:
        package, wanted = todo.pop()
        for requirement in map(Requirement, package.requires or []):
            if requirement.marker and not any(
                requirement.marker.evaluate({"extra": extra}) for extra in {"", *wanted}
            ):
                continue
            name = canonicalize_name(requirement.name)
            key = name, frozenset(requirement.extras)
            if key not in visited:
                visited.add(key)
                names.add(name)
                todo.append((distribution(name), key[1]))
    return names


def link_distributions(folder: Path, names: set[str]) -> None:
    """Link distributions of this Python into a folder."""
    for name in sorted(names):
        for file in distribution(name).files or []:
            top = file.parts[0]
            if top not in ("..", "__pycache__") and not (folder / top).exists():
                (folder / top).symlink_to(Path(str(distribution(name).locate_file(top))))


def console_examples(page: str) -> Iterator[tuple[str, str]]:
    """Yield each command of a page's console blocks, with the output that the page shows."""
    for block in re.findall(r"^```console\n(.*?)^```$", page, re.M | re.S):
        for example in re.split(r"^\$ ", block, flags=re.M)[1:]:
            command, _, output = example.partition("\n")
            yield command, output


def _run(*command: str | Path, cwd: Path = ROOT, more: dict[str, str] | None = None) -> str:
    done = subprocess.run(
        command,
        cwd=cwd,
        env=os.environ | (more or {}),
        text=True,
        capture_output=True,
        encoding="utf-8",
        check=False,
    )
    if done.returncode:
        output = f"{done.stdout}{done.stderr}".strip()
        raise SystemExit(f"check_distributions: {shlex.join(map(str, command))} failed:\n{output}")
    return done.stdout


def _build(target: str, source: Path, folder: Path) -> Path:
    before = set(folder.glob("*"))
    build = (sys.executable, "-m", "hatchling", "build", "--target", target, "--directory", folder)
    _run(*build, cwd=source)
    (built,) = set(folder.glob("*")) - before
    return built


def _sha256(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()


def build_package(source: Path, folder: Path) -> list[Path]:
    """Build source archive and wheel of a package; the archive must give the same wheel."""
    folder.mkdir(parents=True, exist_ok=True)
    archive, wheel = _build("sdist", source, folder), _build("wheel", source, folder)
    with tempfile.TemporaryDirectory() as elsewhere:
        with tarfile.open(archive) as files:
            files.extractall(elsewhere, filter="data")
        (unpacked,) = Path(elsewhere).iterdir()
        again = Path(elsewhere, "dist")
        again.mkdir()
        if _sha256(_build("wheel", unpacked, again)) != _sha256(wheel):
            raise SystemExit(f"check_distributions: {archive.name} gives another wheel")
    with zipfile.ZipFile(wheel) as files:
        names = {name.rpartition("/")[2] for name in files.namelist() if "/licenses/" in name}
    if names != set(LICENSE_FILES):
        raise SystemExit(
            f"check_distributions: {wheel.name} must hold {LICENSE_FILES}; got {sorted(names)}"
        )
    return [archive, wheel]


def install_package(folder: Path, wheels: Path, wanted: str, *tools: str) -> Path:
    """Install a package from a folder of wheels into a new environment; return its bin folder.

    Third-party requirements and tools are linked from this Python.
    """
    _run(sys.executable, "-m", "venv", "--without-pip", folder)
    programs = folder / ("Scripts" if os.name == "nt" else "bin")
    where = "import sysconfig; print(sysconfig.get_path('purelib'))"
    site = Path(_run(programs / "python", "-c", where).strip())
    own = {row["name"] for row in read_packages()}
    requirement = Requirement(wanted)
    asked = required_distributions(distribution(requirement.name), set(requirement.extras)) | set(
        tools
    )
    for tool in tools:
        asked |= required_distributions(distribution(tool), set())
    link_distributions(site, asked - own)
    pip = (sys.executable, "-m", "pip", "--disable-pip-version-check")
    python = ("--python", programs / "python")
    _run(*pip, *python, "install", "--quiet", "--no-index", "--find-links", wheels, wanted)
    _run(*pip, *python, "check")
    return programs


def run_examples(page: Path, programs: Path) -> int:
    """Run a page's examples in the environment, in an empty folder; return their number."""
    text = page.read_text(encoding="utf-8")
    tried = len(doctest.DocTestParser().get_examples(text))
    run = (
        "import doctest, sys; "
        "sys.exit(doctest.testfile(sys.argv[1], module_relative=False, encoding='utf-8').failed)"
    )
    with tempfile.TemporaryDirectory() as folder:
        where = Path(folder)
        _run(programs / "python", "-I", "-c", run, page, cwd=where)
        for command, shown in console_examples(text):
            tried += 1
            program, *arguments = shlex.split(command)
            output = _run(programs / program, *arguments, cwd=where, more={"PYTHONUTF8": "1"})
            if output != shown:
                raise SystemExit(
                    f"check_distributions: {page.name} shows another output of: {command}"
                )
    return tried


def run_chapter(name: str, programs: Path) -> None:
    """Run a downloaded chapter in an empty folder; the chapter must leave no file there."""
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder, "downloads", f"{name}.ipynb")
        copy.parent.mkdir()
        copy.write_bytes((ROOT / "notebooks" / copy.name).read_bytes())
        more = {"MPLBACKEND": "agg", "IPYTHONDIR": str(Path(folder, "ipython"))}
        _run(programs / "python", "-I", "-c", _RUN, copy, cwd=copy.parent, more=more)
        if [*copy.parent.iterdir()] != [copy]:
            raise SystemExit(f"check_distributions: {name} leaves files beside it")


def run_tests_of_package_alone(row: dict[str, str], wheels: Path, folder: Path) -> None:
    """Run a package's tests in an environment with only the package's requirements."""
    programs = install_package(folder, wheels, row["name"], *TEST_TOOLS)
    tests = "tests/core" if row["folder"] == "." else f"{row['folder']}/tests"
    print(f"\nTesting {row['name']} alone ...", flush=True)
    # Only developers have numba, which the kernels import.
    kernels = f"--ignore-glob={folder}/*/kernels/*"
    options = ("-q", "-n", "2", "-p", "no:cacheprovider", "--doctest-modules")
    pytest = (programs / "python", "-m", "pytest", *options, kernels)
    if subprocess.run(
        [*pytest, tests, "--pyargs", row["import"]], cwd=ROOT, check=False
    ).returncode:
        raise SystemExit(f"check_distributions: the tests of {row['name']} fail where it is alone")


def main() -> None:
    """Build, check, install and test the packages."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--tools", type=Path, help="folder of twine and others")
    parser.add_argument("--out", type=Path, default=ROOT / "build" / "dist")
    parser.add_argument("--alone", metavar="NAME", help="test this package alone, or all")
    given = parser.parse_args()
    shutil.rmtree(given.out, ignore_errors=True)
    built = [
        file for row in read_packages() for file in build_package(ROOT / row["folder"], given.out)
    ]
    with tempfile.TemporaryDirectory() as folder:
        if given.alone:
            for row in read_packages():
                if given.alone in ("all", row["name"]):
                    run_tests_of_package_alone(row, given.out, Path(folder, row["name"]))
            return
        tools = {"PYTHONPATH": str(given.tools)}
        _run(sys.executable, "-m", "twine", "check", "--strict", *built, more=tools)
        _run(sys.executable, "-m", "check_wheel_contents", *built[1::2], more=tools)
        validate = "from cffconvert.cli.cli import cli; cli()"
        _run(sys.executable, "-c", validate, "--validate", "-i", "CITATION.cff", more=tools)
        programs = install_package(Path(folder, "env"), given.out, "discostorm[all]")
        pages = [ROOT / name for name in PAGES]
        pages += [ROOT / row["folder"] / "README.md" for row in read_packages()[1:]]
        tried = {page: run_examples(page, programs) for page in pages}
        for name in DOWNLOADED_CHAPTERS:
            run_chapter(name, programs)
    for file in built:
        print(f"{_sha256(file)}  {file.name}  {file.stat().st_size / 1e6:.1f} MB")
    counts = ", ".join(f"{n} examples of {page.relative_to(ROOT)}" for page, n in tried.items())
    print(f"Checked, with {counts}, and {len(DOWNLOADED_CHAPTERS)} downloaded chapters")


if __name__ == "__main__":
    main()
