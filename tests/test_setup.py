"""The set-up: its versions are one and the same everywhere, its errors say what to do."""

import os
import re
import shutil
import subprocess
import sys
import tomllib
from itertools import chain
from pathlib import Path

import pytest
import yaml

ROOT = Path(__file__).parents[1]
sys.path.insert(0, str(ROOT / "scripts"))

from write_environment import environment  # noqa: E402

pytestmark = pytest.mark.book

LOCK = (ROOT / "requirements.lock").read_text(encoding="utf-8")


def test_environment_yml_is_made_from_the_lock() -> None:
    assert (ROOT / "environment.yml").read_text(encoding="utf-8") == environment(LOCK)


def test_environment_yml_has_the_versions_of_the_lock() -> None:
    """The same comparison, without the code that made the file."""
    with (ROOT / "environment.yml").open(encoding="utf-8") as file:
        pip = yaml.safe_load(file)["dependencies"][-1]["pip"]
    assert pip[-1] == "-e ."
    locked = re.findall(r"^([\w.-]+==[^\s;]+)(?: ; (.+?))? \\$", LOCK, flags=re.MULTILINE)
    assert pip[:-1] == [f"{pin} ; {marker}" if marker else pin for pin, marker in locked]


def test_the_lock_has_every_dependency_and_a_hash_for_each() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    for requirement in chain(
        project["project"]["dependencies"], *project["dependency-groups"].values()
    ):
        name, _, version = re.sub(">=.+", "", requirement).partition("==")
        pin = re.search(rf"^{name}==(\S+)", LOCK, flags=re.MULTILINE)
        assert pin, f"{name} is not in requirements.lock: run make lock"
        assert version in ("", pin[1])
    assert len(re.findall(r"^\S", LOCK, flags=re.MULTILINE)) == len(
        re.findall(
            r"\\\n    --hash=sha256:[0-9a-f]{64}(?: \\\n    --hash=\S+)*$", LOCK, re.MULTILINE
        )
    )


def fake(path: Path, script: str) -> None:
    path.write_text(f"#!/bin/sh\n{script}\n")
    path.chmod(0o755)


OLD = 'case "$*" in *version_info*) exit 1;; --version) echo "Python 3.9.2";; esac'
NO_VENV = 'case "$*" in *ensurepip*) exit 1;; esac'


@pytest.mark.parametrize(
    ("python", "message"),
    [
        (None, r"there is no fake: install Python 3\.11 or newer .*python3-venv\), or uv"),
        (OLD, r"Python 3\.9\.2 is too old: install Python 3\.11 or newer .*, or install uv"),
        (NO_VENV, r"fake has no venv module: install it .*python3-venv\), or uv"),
    ],
    ids=["none", "old", "no venv"],
)
def test_set_up_says_what_to_install(tmp_path: Path, python: str | None, message: str) -> None:
    tools = tmp_path / "bin"
    tools.mkdir()
    for tool in ("sh", "rm", "touch"):  # and no uv
        (tools / tool).symlink_to(shutil.which(tool) or tool)
    if python is not None:
        fake(tools / "fake", python)
    done = subprocess.run(
        ["sh", ROOT / "scripts" / "setup.sh"],
        cwd=tmp_path,
        env={"PATH": str(tools), "PYTHON": "fake"},
        text=True,
        capture_output=True,
        check=False,
    )
    assert done.returncode == 1
    assert re.search(message, done.stderr)
    assert not (tmp_path / ".venv").exists()


def make(folder: Path, *arguments: str) -> str:
    env = {name: value for name, value in os.environ.items() if not name.startswith("M")}
    done = subprocess.run(
        ["make", *arguments], cwd=folder, env=env, text=True, capture_output=True, check=True
    )
    return done.stdout


def test_help_lists_every_target() -> None:
    targets = re.findall(r"^make ([a-z-]+) ", make(ROOT), flags=re.MULTILINE)
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
