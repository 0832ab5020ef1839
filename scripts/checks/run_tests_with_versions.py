"""Run the package's tests with the oldest or the newest versions of its requirements.

The versions are installed into build/. The test tools come from requirements.lock.
"""

import argparse
import os
import subprocess
import sys
import tomllib
from pathlib import Path

ROOT = Path(__file__).parents[2]


def pinned_requirements(age: str) -> list[str]:
    """Return the requirements of pyproject.toml, at their lower bounds or without bounds."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    bounds = [requirement.split(">=") for requirement in project["dependencies"]]
    return [f"{name}=={bound}" if age == "oldest" else name for name, bound in bounds]


def main() -> int:
    """Install the versions, print them, and run the tests."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("age", choices=["oldest", "newest"])
    age = parser.parse_args().age
    folder = ROOT / "build" / age
    wanted = pinned_requirements(age)
    print(f"Installing {', '.join(wanted)} ...", flush=True)
    install = ["sh", ROOT / "scripts" / "install.sh", folder, *wanted]
    if subprocess.run(install, cwd=ROOT, check=False).returncode:
        print(
            "run_tests_with_versions: could not install these; is there a network?", file=sys.stderr
        )
        return 1
    environment = os.environ | {"PYTHONPATH": str(folder)}
    names = [requirement.partition("==")[0] for requirement in wanted]
    show = f"from importlib.metadata import version\nfor n in {names}: print(n, version(n))"
    subprocess.run([sys.executable, "-c", show], env=environment, check=True)
    tests = [sys.executable, "-m", "pytest", "-q", "-n", "2", "-m", "not (book or locked)"]
    if age == "oldest":
        # Old requirements use functions that their newer dependencies have deprecated.
        tests += ["-W", "ignore::DeprecationWarning"]
    tests += ["tests/core", "discostorm"]
    return subprocess.run(tests, cwd=ROOT, env=environment, check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
