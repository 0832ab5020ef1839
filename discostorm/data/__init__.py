"""Data files of the packages; every row of each table names its source."""

import csv
from functools import cache
from importlib.util import find_spec
from pathlib import Path


@cache
def _data_folder(package: str) -> Path:
    # Not importlib.resources, which takes a tenth of the time of importing sympy.
    spec = find_spec(package)
    if spec is None or spec.origin is None:
        raise ModuleNotFoundError(f"no package {package!r} here", name=package)
    return Path(spec.origin).parent / "data"


def data_path(name: str, package: str = "discostorm") -> Path:
    """Return the path of a package's data file, such as ``fleets/nav2_laptop.toml``."""
    return _data_folder(package) / name


@cache
def read_data(name: str, package: str = "discostorm") -> list[dict[str, str]]:
    """Return the rows of a package's table, such as ``paper/table2.csv``."""
    text = data_path(name, package).read_text(encoding="utf-8")
    names, *rows = csv.reader(text.splitlines())
    return [dict(zip(names, row, strict=True)) for row in rows]
