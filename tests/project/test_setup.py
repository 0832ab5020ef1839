"""Test the set-up: the same versions everywhere, and errors with instructions."""

import os
import re
import shutil
import subprocess
import sys
import tomllib
from collections.abc import Mapping
from itertools import chain
from pathlib import Path

import pytest
import yaml
from support import ROOT, unshare_command
from write_environment import environment_text

pytestmark = pytest.mark.book

LOCK_FILE = (ROOT / "requirements.lock").read_text(encoding="utf-8")


def test_environment_yml_is_made_from_the_lock() -> None:
    assert (ROOT / "environment.yml").read_text(encoding="utf-8") == environment_text(LOCK_FILE)


def test_environment_yml_has_the_versions_of_the_lock() -> None:
    """The same comparison, without the code that made the file."""
    with (ROOT / "environment.yml").open(encoding="utf-8") as file:
        pip = yaml.safe_load(file)["dependencies"][-1]["pip"]
    own = [
        path.parent.relative_to(ROOT).as_posix() for path in ROOT.glob("packages/*/pyproject.toml")
    ]
    assert pip[-len(own) - 1 :] == [f"-e {path}" for path in (".", *sorted(own))]
    locked = re.findall(r"^([\w.-]+==[^\s;]+)(?: ; (.+?))? \\$", LOCK_FILE, flags=re.MULTILINE)
    assert pip[: -len(own) - 1] == [
        f"{pin} ; {marker}" if marker else pin for pin, marker in locked
    ]


def test_the_lock_has_every_dependency_and_a_hash_for_each() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    for requirement in chain(
        project["project"]["dependencies"], *project["dependency-groups"].values()
    ):
        name, _, version = re.sub(">=.+", "", requirement).partition("==")
        pin = re.search(rf"^{name}==(\S+)", LOCK_FILE, flags=re.MULTILINE)
        assert pin, f"{name} is not in requirements.lock: run make lock"
        assert version in ("", pin[1])
    assert len(re.findall(r"^\S", LOCK_FILE, flags=re.MULTILINE)) == len(
        re.findall(
            r"\\\n    --hash=sha256:[0-9a-f]{64}(?: \\\n    --hash=\S+)*$", LOCK_FILE, re.MULTILINE
        )
    )


def fake(path: Path, script: str) -> None:
    path.write_text(f"#!/bin/sh\n{script}\n")
    path.chmod(0o755)


def set_up(
    folder: Path, tools: Mapping[str, str], **env: str
) -> "subprocess.CompletedProcess[str]":
    """Run the set-up in a folder, with no tools but the machine's plain ones and these fakes."""
    plain = folder / "tools"
    plain.mkdir()
    for tool in ("awk", "chmod", "mkdir", "rm", "sh", "touch"):  # and no uv
        (plain / tool).symlink_to(shutil.which(tool) or tool)
    fake(plain / "df", "echo; echo disk 99999999 0 99999999 0% /")
    for name, script in tools.items():
        fake(plain / name, script)
    return subprocess.run(
        ["sh", ROOT / "scripts" / "setup.sh"],
        cwd=folder,
        env={"PATH": str(plain), "PYTHON": "fake"} | env,
        text=True,
        capture_output=True,
        check=False,
    )


OLD = 'case "$*" in *version_info*) exit 1;; --version) echo "Python 3.9.2";; esac'
NO_VENV = 'case "$*" in *ensurepip*) exit 1;; esac'


@pytest.mark.parametrize(
    ("tools", "message"),
    [
        ({}, r"there is no fake: install Python 3\.11 or newer .*python3-venv\), or uv"),
        ({"fake": OLD}, r"Python 3\.9\.2 is too old: install Python 3\.11 or .*, or install uv"),
        ({"fake": NO_VENV}, r"fake has no venv module: install it .*python3-venv\), or uv"),
    ],
    ids=["none", "old", "no venv"],
)
def test_set_up_says_what_to_install(
    tmp_path: Path, tools: Mapping[str, str], message: str
) -> None:
    done = set_up(tmp_path, tools)
    assert done.returncode == 1
    assert re.search(message, done.stderr)
    assert not (tmp_path / ".venv").exists()


def test_pip_is_not_tried_where_its_programs_would_not_start(tmp_path: Path) -> None:
    folder = tmp_path / "my $HOME"
    folder.mkdir()
    done = set_up(folder, {"fake": ""})
    assert done.returncode == 1
    assert done.stderr.startswith("discostorm: programs that pip installs do not start in a folder")
    assert f"as {folder}: rename it, or install uv\n" in done.stderr
    plain = tmp_path / "my home"
    plain.mkdir()
    assert "rename it" not in set_up(plain, {"fake": ""}).stderr


#: A uv that makes a Python which does nothing; as the real one, it stops where it can write no
#: cache or cannot look for Pythons. What it does for the command `pip` follows.
UV = """
case "$1" in
    cache) echo "$HOME/uv"; exit;;
    python) echo "$HOME/python"; exit;;
esac
[ "$UV_NO_CACHE" ] || [ -d "$HOME/uv" ] || { echo no cache >&2; exit 2; }
[ "$UV_PYTHON_INSTALL_DIR" ] || [ -d "$HOME" ] || { echo no Pythons >&2; exit 2; }
case "$1" in
    venv) mkdir -p .venv/bin; echo "#!/bin/sh" >.venv/bin/python; chmod +x .venv/bin/python;;
    pip) """


@pytest.mark.parametrize(
    ("words", "meaning"),
    [
        ("failed to copy: No space left on device (os error 28)", "; the disk is full"),
        ("ERROR: [Errno 28] Kein Speicherplatz", "the disk is full"),
        ("dns error: failed to lookup address information", "is there a network?"),
        ("Temporary failure in name resolution", "is there a network?"),
        ("Hash mismatch for numpy==2.4.6", "why stands above"),
    ],
)
def test_set_up_passes_on_the_words_of_its_tools(tmp_path: Path, words: str, meaning: str) -> None:
    done = set_up(tmp_path, {"uv": f'{UV} echo "{words}" >&2; exit 2;;\nesac'}, HOME=str(tmp_path))
    assert done.returncode == 1
    said, told = done.stderr.splitlines()
    assert said == words
    assert told.startswith("discostorm: could not install requirements.lock")
    assert ("network" in told, "full" in told) == ("network" in meaning, "full" in meaning)
    assert meaning.strip("; ") in told
    assert not (tmp_path / ".venv" / ".ready").exists()


def test_uv_needs_no_home(tmp_path: Path) -> None:
    done = set_up(tmp_path, {"uv": f"{UV} ;;\nesac"}, HOME="/dev/null/home")
    assert (done.returncode, done.stderr) == (0, "")
    assert (tmp_path / ".venv" / ".ready").exists()


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ("size=64m", r"\.venv takes about \d+ MB, but the disk of .* has 6\d MB left"),
        ("ro", "cannot write into .*"),
    ],
)
def test_set_up_looks_at_the_disk_first(tmp_path: Path, options: str, message: str) -> None:
    small = f"mount -t tmpfs -o {options} small . && cd {tmp_path} && sh {ROOT}/scripts/setup.sh"
    done = subprocess.run(
        [*unshare_command("--mount"), "sh", "-c", small],
        cwd=tmp_path,
        text=True,
        capture_output=True,
        check=False,
    )
    assert done.returncode == 1
    assert re.fullmatch(f"discostorm: {message}", done.stderr.strip())
    assert done.stdout == ""


def test_set_up_asks_for_the_room_that_it_takes() -> None:
    """Without the compiled modules, which only pip writes, half of it at least."""
    found = re.search(r"^room=(\d+)$", (ROOT / "scripts" / "setup.sh").read_text(), re.MULTILINE)
    assert found
    du = subprocess.run(["du", "-sm", sys.prefix], text=True, capture_output=True, check=True)
    assert int(found[1]) / 2 < int(du.stdout.split()[0]) <= int(found[1])


def test_the_editable_install_is_found_in_any_folder_under_any_locale(tmp_path: Path) -> None:
    """Python before 3.13 reads .pth files in the locale's encoding."""
    folder = tmp_path / "ordñer"
    (folder / "discostorm").mkdir(parents=True)
    licenses = ("LICENSE", "LICENSE-CC-BY-4.0.txt")
    for name in ("pyproject.toml", "PYPI.md", *licenses, "discostorm/__init__.py"):
        shutil.copy(ROOT / name, folder / name)
    (folder / "discostorm" / "__init__.py").write_text("__version__ = '1'\nhere = 'new'\n")
    script = """
import subprocess, sys, sysconfig, zipfile
from hatchling.build import build_editable
zipfile.ZipFile(build_editable(".")).extractall("site")
# Without the .pth files of this environment, in which discostorm is the one that tests run in.
use = "import site, sys; sys.path += sys.argv[1:]; site.addsitedir(sys.argv[1])"
use += "; import discostorm; print(discostorm.here)"
packages = sysconfig.get_path("purelib")
subprocess.run([sys.executable, "-S", "-c", use, sys.argv[1], packages], cwd="/", check=True)
"""
    done = subprocess.run(
        [sys.executable, "-c", script, folder / "site"],
        cwd=folder,
        env={"LC_ALL": "C", "PATH": os.environ["PATH"]},
        text=True,
        capture_output=True,
        check=False,
    )
    assert (done.stderr, done.stdout) == ("", "new\n")


@pytest.mark.parametrize("out", ["it's", 'a "b" c', "cost$5$$", "`id`", "a;b", "back\\slash"])
def test_figures_go_to_a_folder_of_any_name(tmp_path: Path, out: str) -> None:
    shutil.copy(ROOT / "Makefile", tmp_path)
    (tmp_path / ".venv" / "bin").mkdir(parents=True)
    fake(tmp_path / ".venv" / "bin" / "discostorm", """printf '%s\\n' "$@" """)
    fake(tmp_path / ".venv" / "bin" / "python", "true")  # it looks for collisions
    (tmp_path / ".venv" / ".ready").touch()
    given = ["figures", "--assume-old=.venv/.ready"]
    assert make(tmp_path, *given, f"OUT={out}").splitlines() == ["figures", "--out", out]
    assert make(tmp_path, *given, OUT=out).splitlines() == ["figures", "--out", out]
    assert make(tmp_path, *given).splitlines() == ["figures", "--out", "build/figures"]


def make(folder: Path, *arguments: str, **more: str) -> str:
    env = {name: value for name, value in os.environ.items() if not name.startswith("M")} | more
    done = subprocess.run(
        ["make", *arguments], cwd=folder, env=env, text=True, capture_output=True, check=True
    )
    return done.stdout


def test_a_public_forge_runs_what_ci_runs_on_the_versions_that_are_promised() -> None:
    jobs = yaml.safe_load((ROOT / ".github/workflows/ci.yml").read_text(encoding="utf-8"))["jobs"]
    assert jobs["everything"]["steps"][-1] == {"run": ".ci/run"}
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    promised = [kind.rpartition(" ")[2] for kind in project["classifiers"] if ":: 3." in kind]
    assert jobs["package"]["strategy"]["matrix"]["python"] == promised
    assert project["requires-python"] == f">={promised[0]}"


def test_help_lists_every_target() -> None:
    targets = re.findall(r"^make ([a-z0-9-]+) ", make(ROOT), flags=re.MULTILINE)
    phony = re.search(r"^\.PHONY: (.+)$", (ROOT / "Makefile").read_text(), flags=re.MULTILINE)
    assert phony
    assert targets == phony[1].split()


def test_set_up_happens_once_and_again_for_another_lock(tmp_path: Path) -> None:
    (tmp_path / "scripts").mkdir()
    for name in ("Makefile", "pyproject.toml", "requirements.lock", "scripts/setup.sh"):
        shutil.copy(ROOT / name, tmp_path / name)
        os.utime(tmp_path / name, (1, 1))
    assert "setup.sh" in make(tmp_path, "--dry-run", "lint")
    ready = tmp_path / ".venv" / ".ready"
    ready.parent.mkdir()
    ready.touch()
    assert "setup.sh" not in make(tmp_path, "--dry-run", "lint")
    os.utime(ready, (0, 0))
    assert "setup.sh" in make(tmp_path, "--dry-run", "lint")
