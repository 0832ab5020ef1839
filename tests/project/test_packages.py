"""Test the five packages: their limits, their version, and the messages for a missing one."""

import json
import os
import re
import subprocess
import sys
import tomllib
from importlib.metadata import distribution
from itertools import chain
from pathlib import Path

import pytest
from check_distributions import link_distributions, read_packages, required_distributions
from packaging.requirements import Requirement
from support import ROOT

import discostorm
from discostorm.cli.main import COMMANDS

PACKAGES = read_packages()
each = pytest.mark.parametrize("row", PACKAGES, ids=lambda row: row["name"])


def folder_of(row: dict[str, str]) -> Path:
    return ROOT / row["folder"] / row["import"]


def project_of(row: dict[str, str]) -> dict[str, object]:
    text = (ROOT / row["folder"] / "pyproject.toml").read_text(encoding="utf-8")
    return tomllib.loads(text)["project"]


@each
def test_a_package_is_within_its_limit_of_lines(row: dict[str, str]) -> None:
    files = {p: len(p.read_bytes().splitlines()) for p in folder_of(row).rglob("*.py")}
    assert sum(files.values()) <= int(row["max_lines"])
    assert {p.name: lines for p, lines in files.items() if lines > 500} == {}


@each
def test_a_readme_lists_the_ideas_of_a_package(row: dict[str, str]) -> None:
    page = "CONTRIBUTING.md" if row["folder"] == "." else f"{row['folder']}/README.md"
    text = (ROOT / page).read_text(encoding="utf-8")
    ideas = re.findall(r"^- ", text.split("\n## Ideas\n")[1].split("\n## ")[0], re.M)
    assert 1 <= len(ideas) <= int(row["max_ideas"] or 35)


def test_all_have_one_version_and_ask_for_exactly_each_others() -> None:
    names = {row["name"] for row in PACKAGES}
    for row in PACKAGES:
        project = project_of(row)
        assert project.get("version", discostorm.__version__) == discostorm.__version__
        extras = project.get("optional-dependencies", {})
        for requirement in map(Requirement, chain(project["dependencies"], *extras.values())):
            if requirement.name in names:
                assert str(requirement.specifier) == f"=={discostorm.__version__}"


def test_what_is_installed_by_which_extra_is_what_the_command_line_says() -> None:
    for row in PACKAGES:
        points = project_of(row)["entry-points"]["discostorm.commands"]
        extra = "" if row["folder"] == "." else row["name"].removeprefix("discostorm-")
        assert {name for name, (needs, _) in COMMANDS.items() if needs == extra} == points.keys()


#: Tries every public name and every command where only the core is installed.
TRY = """
import json, sys
import discostorm as ds
said = {}
for name in json.loads(sys.argv[1]):
    try:
        getattr(ds, name)
    except ImportError as error:
        said[name] = str(error)
print(json.dumps(said))
"""


def test_the_core_alone_says_what_to_install_for_the_rest(tmp_path: Path) -> None:
    link_distributions(tmp_path, required_distributions(distribution("discostorm"), set()))
    (tmp_path / "discostorm").symlink_to(ROOT / "discostorm")
    names = ["plan", "Plan", "simulate", "read_capture", "CaptureError", "utilization"]
    command = [sys.executable, "-S", "-c", TRY, json.dumps(names)]
    environment = os.environ | {"PYTHONPATH": str(tmp_path)}
    done = subprocess.run(
        command, cwd=tmp_path, env=environment, text=True, capture_output=True, check=True
    )
    said = json.loads(done.stdout)
    assert said.keys() == set(names) - {"utilization"}
    for name, extra in (("plan", "planner"), ("simulate", "simulation"), ("Plan", "planner")):
        assert said[name] == (
            f"discostorm.{name} needs discostorm_{extra}; "
            f"to get it: pip install 'discostorm[{extra}]'"
        )
