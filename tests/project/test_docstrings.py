"""Test that public docstrings state all parameters, units, results and errors."""

import importlib
import inspect
import pkgutil
import re
import subprocess
import sys
from collections.abc import Callable
from dataclasses import is_dataclass
from typing import Any

import pytest

import discostorm as ds

PACKAGES = [
    importlib.import_module(name)
    for name in (
        "discostorm",
        *(f"discostorm_{x}" for x in ("simulation", "planner", "capture", "book")),
    )
]
#: Every module of the packages, also in folders; __main__ would run the command.
MODULES = [
    importlib.import_module(module.name)
    for package in PACKAGES
    for module in pkgutil.walk_packages(package.__path__, f"{package.__name__}.")
    if module.name.rpartition(".")[2] != "__main__"
]
#: What a user of any package calls: all of `ds`, also what other packages add to it.
PUBLIC: list[Callable[..., object]] = [
    value
    for name in dir(ds)
    if callable(value := getattr(ds, name)) and value is not ds.CaptureError
]
FUNCTIONS = [value for value in PUBLIC if inspect.isfunction(value)]

METHODS: list[Callable[..., object]] = [ds.Protocol.load, ds.Protocol.utilization]


def sections(of: Callable[..., object]) -> dict[str, str]:
    """Return the text of each section of a numpydoc docstring by its title."""
    parts = re.split(r"^(\w[\w ]*)\n-{3,}$", inspect.getdoc(of) or "", flags=re.MULTILINE)
    return dict(zip(parts[1::2], parts[2::2], strict=True))


def described_parameters(text: str) -> dict[str, tuple[str, str]]:
    """Return type and description of each parameter; ``a, b : float`` describes both."""
    entries = re.findall(r"^(\S.*?)(?: : (.*))?\n((?:    .*\n?|\n)+)", text, flags=re.MULTILINE)
    return {
        name.lstrip("*"): (kind, description)
        for names, kind, description in entries
        for name in names.split(", ")
    }


def name_of(value: object) -> str:
    return getattr(value, "__qualname__", repr(value))


@pytest.mark.parametrize("of", [*PUBLIC, *METHODS], ids=name_of)
def test_every_parameter_is_described_and_every_number_has_a_unit(
    of: Callable[..., object],
) -> None:
    found = described_parameters(sections(of)["Parameters"])
    assert list(found) == [name for name in inspect.signature(of).parameters if name != "self"]
    for name, (kind, description) in found.items():
        if re.search(r"\bfloat|\barray|\bint\b", kind):
            assert re.search(r"\[.+?\]", description), f"{name} has no unit in brackets"


#: What else, in any module of any package, tells of its parameters must tell of all of them.
TELLING: list[Callable[..., object]] = [
    value
    for module in MODULES
    for name, value in vars(module).items()
    if not name.startswith("_")
    and getattr(value, "__module__", "") == module.__name__
    and (inspect.isfunction(value) or inspect.isclass(value))
    and value not in PUBLIC
    and "Parameters" in sections(value)
]


def test_what_tells_of_parameters_tells_of_each() -> None:
    assert TELLING
    for of in TELLING:
        told = set(described_parameters(sections(of)["Parameters"]))
        taken = {name for name in inspect.signature(of).parameters if not name.startswith("_")}
        assert told == taken, name_of(of)


@pytest.mark.parametrize("of", [*FUNCTIONS, *METHODS], ids=name_of)
def test_what_is_returned(of: Callable[..., object]) -> None:
    assert sections(of)["Returns"].strip()


def test_what_all_raise_is_said_once() -> None:
    assert {"ValueError", "TypeError"} <= set(re.findall(r"\w+Error", ds.__doc__ or ""))


@pytest.mark.parametrize("of", FUNCTIONS, ids=name_of)
def test_functions_show_an_example(of: Callable[..., object]) -> None:
    assert ">>> " in sections(of)["Examples"]


#: Modules of the package that `import discostorm as ds` does not offer.
INNER = {
    *("__main__", "cells", "cli", "fleet_file", "files", "lookup", "palette"),
    *("host_configuration_files", "host_group", "ros2_endpoints", "ros_releases", "wording"),
}


def test_what_is_public() -> None:
    assert {"CaptureError", "figures", "plan", "utilization"} < set(dir(ds))
    assert set(dir(ds)) - set(ds.__all__) == {
        *("Capture", "CaptureError", "read_capture"),
        *("Plan", "Remedy", "Share", "plan", "Simulation", "simulate"),
    }
    modules = {module.name for module in pkgutil.iter_modules(ds.__path__)}
    public = {name for name in modules - INNER if not name.startswith("_")}
    assert public == {name for name in dir(ds) if inspect.ismodule(getattr(ds, name))}
    with pytest.raises(AttributeError, match="nothing"):
        ds.nothing  # noqa: B018


def test_modules_in_folders_are_found() -> None:
    names = {module.__name__ for module in MODULES}
    assert {"discostorm.fleet", "discostorm.wifi", "discostorm.wifi.aggregation"} < names


def test_all_that_is_public_is_there_whatever_was_imported_before() -> None:
    """Also each module, if it is the first that is asked for; other packages stay loaded."""
    code = """
import inspect, sys
import discostorm
assert not {"numpy", "sympy", "click"} & set(sys.modules)
found = {name: getattr(discostorm, name) for name in discostorm.__all__}
for name in filter(lambda name: inspect.ismodule(found[name]), found):
    for loaded in [each for each in sys.modules if each.partition(".")[0] == "discostorm"]:
        del sys.modules[loaded]
    import discostorm
    assert getattr(discostorm, name).__name__ == f"discostorm.{name}"
"""
    subprocess.run([sys.executable, "-c", code], check=True)


def test_every_dataclass_is_frozen() -> None:
    """Of the core and of what a user gets; elsewhere, while a file is read, some are filled."""
    core = [module for module in MODULES if module.__name__.startswith("discostorm.")]
    classes: set[Any] = {
        value for module in core for value in vars(module).values() if is_dataclass(value)
    }
    classes = {value for value in classes if value.__module__.startswith("discostorm")}
    classes |= {value for value in PUBLIC if inspect.isclass(value) and is_dataclass(value)}
    assert len(classes) > 10
    assert [value for value in classes if not value.__dataclass_params__.frozen] == []
