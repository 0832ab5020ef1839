"""Write environment.yml, for conda and Binder, from requirements.lock.

Conda supplies Python and pip; every other version comes from the lock.
"""

from pathlib import Path

ROOT = Path(__file__).parents[2]

ENVIRONMENT_HEAD = """\
# Made by `make lock` from requirements.lock; do not edit.
# conda env create -f environment.yml
name: discostorm
channels:
  - conda-forge
dependencies:
  - python=3.11
  - pip
  - pip:
"""


def pinned_versions(lock: str) -> list[str]:
    """Return the pins of a lock file, ``name==version`` with its marker, without hashes."""
    return [
        line.removesuffix("\\").strip()
        for line in lock.splitlines()
        if line and not line.startswith((" ", "#"))
    ]


def package_files() -> list[Path]:
    """Return the pyproject.toml files of the five packages, the core's first."""
    return [ROOT / "pyproject.toml", *sorted(ROOT.glob("packages/*/pyproject.toml"))]


def environment_text(lock: str) -> str:
    """Return the text of environment.yml for the text of a lock file."""
    # Quote the pins, because a marker contains special characters of YAML.
    own = (f"-e {path.parent.relative_to(ROOT).as_posix()}" for path in package_files())
    lines = [*pinned_versions(lock), *own]
    return ENVIRONMENT_HEAD + "".join(f'      - "{line}"\n' for line in lines)


if __name__ == "__main__":
    lock = (ROOT / "requirements.lock").read_text(encoding="utf-8")
    (ROOT / "environment.yml").write_text(environment_text(lock), encoding="utf-8")
