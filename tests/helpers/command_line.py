"""Run the command line in tests, and read its output."""

import csv
import io
import json
import os
import subprocess
import sys
from typing import Any

from click.testing import CliRunner, Result

from discostorm.cli import main
from discostorm.data import data_path

#: A fleet file; tests/conftest.py copies the file into a test's folder.
NAV2 = data_path("fleets/nav2_laptop.toml").read_text(encoding="utf-8")
SWARM_OPTIONS = ["--hosts", "7", "--processes", "2", "--endpoints", "10"]


def run(*arguments: str, **given: Any) -> Result:
    """Run a command; ``|`` separates words in an argument."""
    words = [word for argument in arguments for word in argument.split("|")]
    runner = CliRunner(env={"COLUMNS": "79"})
    return runner.invoke(main, words, prog_name="discostorm", **given)


def shell(command: str, **env: str) -> subprocess.CompletedProcess[str]:
    program = f"{sys.executable} -m discostorm"
    return subprocess.run(
        ["bash", "-c", command.replace("discostorm", program)],
        capture_output=True, encoding="utf-8", errors="replace", check=False,
        env=os.environ | env,
    )  # fmt: skip


def read_json(result: Result) -> Any:
    assert result.exit_code == 0, result.output
    return json.loads(result.stdout)


def read_csv(result: Result) -> list[dict[str, str]]:
    assert result.exit_code == 0, result.output
    return list(csv.DictReader(io.StringIO(result.stdout)))
