"""Check what is published on an index: source archive, wheel, the page, and the page's examples.

The examples run in a new environment that holds the wheel, and what the wheel asks for.
"""

import argparse
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
from importlib.metadata import Distribution, PathDistribution, distribution
from pathlib import Path

from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

ROOT = Path(__file__).parents[2]
#: Pages whose examples must run.
PAGES = ("PYPI.md", "README.md")
LICENSES = ("LICENSE", "LICENSE-CC-BY-4.0.txt")


def needed(package: Distribution, extras: set[str]) -> set[str]:
    """Return the names of the distributions that one needs, and all that these need."""
    found: set[str] = set()
    todo = [(package, frozenset(extras))]
    seen = set()
    while todo:
        package, wanted = todo.pop()
        for requirement in map(Requirement, package.requires or []):
            if requirement.marker and not any(
                requirement.marker.evaluate({"extra": extra}) for extra in {"", *wanted}
            ):
                continue
            name = canonicalize_name(requirement.name)
            key = name, frozenset(requirement.extras)
            if key not in seen:
                seen.add(key)
                found.add(name)
                todo.append((distribution(name), key[1]))
    return found


def fill(folder: Path, wheel: Path, *extras: str) -> None:
    """Link into a folder what the wheel needs with these extras, and nothing else."""
    (info,) = wheel.glob("discostorm-*.dist-info")
    for name in needed(PathDistribution(info), set(extras)):
        for file in distribution(name).files or []:
            top = file.parts[0]
            if top not in ("..", "__pycache__") and not (folder / top).exists():
                (folder / top).symlink_to(Path(str(distribution(name).locate_file(top))))


def commands(page: str) -> Iterator[tuple[str, str]]:
    """Yield each command of a page's console blocks, and the output that the page shows."""
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
        said = f"{done.stdout}{done.stderr}".strip()
        raise SystemExit(f"check_dist: {shlex.join(map(str, command))} failed:\n{said}")
    return done.stdout


def _build(target: str, source: Path, folder: Path) -> Path:
    build = (sys.executable, "-m", "hatchling", "build", "--target", target, "--directory", folder)
    _run(*build, cwd=source)
    (built,) = folder.glob("*.whl" if target == "wheel" else "*.tar.gz")
    return built


def _sha256(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()


def build(folder: Path) -> list[Path]:
    """Build source archive and wheel; out of the archive comes the same wheel."""
    archive = _build("sdist", ROOT, folder)
    wheel = _build("wheel", ROOT, folder)
    with tempfile.TemporaryDirectory() as elsewhere:
        with tarfile.open(archive) as files:
            files.extractall(elsewhere, filter="data")
        (source,) = Path(elsewhere).iterdir()
        again = _build("wheel", source, Path(elsewhere, "dist"))
        if _sha256(again) != _sha256(wheel):
            raise SystemExit("check_dist: the wheel of the source archive is another")
    with zipfile.ZipFile(wheel) as files:
        names = {name.rpartition("/")[2] for name in files.namelist() if "/licenses/" in name}
    if names != set(LICENSES):
        raise SystemExit(f"check_dist: the wheel must hold {LICENSES}; got {sorted(names)}")
    return [archive, wheel]


def environment(folder: Path, wheel: Path) -> Path:
    """Install the wheel into a new environment, beside what it needs; return its programs."""
    _run(sys.executable, "-m", "venv", folder)
    programs = folder / ("Scripts" if os.name == "nt" else "bin")
    python = programs / "python"
    options = ("--quiet", "--disable-pip-version-check", "--no-index", "--no-deps")
    _run(python, "-m", "pip", "install", *options, wheel)
    where = "import sysconfig; print(sysconfig.get_path('purelib'))"
    site = Path(_run(python, "-c", where).strip())
    fill(site, site)
    _run(python, "-m", "pip", "--disable-pip-version-check", "check")
    return programs


def examples(page: Path, programs: Path) -> int:
    """Run a page's examples in the environment, in an empty folder; return how many there are."""
    text = page.read_text(encoding="utf-8")
    tried = len(doctest.DocTestParser().get_examples(text))
    run = (
        "import doctest, sys; "
        "sys.exit(doctest.testfile(sys.argv[1], module_relative=False, encoding='utf-8').failed)"
    )
    with tempfile.TemporaryDirectory() as folder:
        where = Path(folder)
        _run(programs / "python", "-I", "-c", run, page, cwd=where)
        for command, shown in commands(text):
            tried += 1
            program, *arguments = shlex.split(command)
            found = _run(programs / program, *arguments, cwd=where, more={"PYTHONUTF8": "1"})
            if found != shown:
                raise SystemExit(f"check_dist: {page.name} shows another output of: {command}")
    return tried


def main() -> None:
    """Build, check, install and try."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--tools", type=Path, required=True, help="folder of twine and others")
    parser.add_argument("--out", type=Path, default=ROOT / "build" / "dist")
    given = parser.parse_args()
    shutil.rmtree(given.out, ignore_errors=True)
    given.out.mkdir(parents=True)
    built = build(given.out)
    tools = {"PYTHONPATH": str(given.tools)}
    _run(sys.executable, "-m", "twine", "check", "--strict", *built, more=tools)
    _run(sys.executable, "-m", "check_wheel_contents", built[1], more=tools)
    validate = "from cffconvert.cli.cli import cli; cli()"
    _run(sys.executable, "-c", validate, "--validate", "-i", "CITATION.cff", more=tools)
    with tempfile.TemporaryDirectory() as folder:
        programs = environment(Path(folder, "env"), built[1])
        tried = {name: examples(ROOT / name, programs) for name in PAGES}
    for file in built:
        print(f"{_sha256(file)}  {file.name}  {file.stat().st_size / 1e6:.1f} MB")
    print("Checked, with " + ", ".join(f"{count} examples of {n}" for n, count in tried.items()))


if __name__ == "__main__":
    main()
