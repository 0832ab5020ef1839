"""What is public tells all of its parameters, units, results and errors, and does not change."""

import importlib
import inspect
import pkgutil
import re
from collections.abc import Callable
from dataclasses import is_dataclass

import pytest

import discostorm as ds

PUBLIC: list[Callable[..., object]] = [
    value for name in ds.__all__ if callable(value := getattr(ds, name))
]
FUNCTIONS = [value for value in PUBLIC if inspect.isfunction(value)]

METHODS: list[Callable[..., object]] = [ds.Protocol.load, ds.Protocol.utilization]


def sections(of: Callable[..., object]) -> dict[str, str]:
    """Return the text of each section of a numpydoc docstring by its title."""
    parts = re.split(r"^(\w[\w ]*)\n-{3,}$", inspect.getdoc(of) or "", flags=re.MULTILINE)
    return dict(zip(parts[1::2], parts[2::2], strict=True))


def described(text: str) -> dict[str, tuple[str, str]]:
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
    found = described(sections(of)["Parameters"])
    assert list(found) == [name for name in inspect.signature(of).parameters if name != "self"]
    for name, (kind, description) in found.items():
        if re.search(r"\bfloat|\barray|\bint\b", kind):
            assert re.search(r"\[.+?\]", description), f"{name} has no unit in brackets"


@pytest.mark.parametrize("of", [*FUNCTIONS, *METHODS], ids=name_of)
def test_what_is_returned_and_raised(of: Callable[..., object]) -> None:
    found = sections(of)
    assert found["Returns"].strip()
    assert "ValueError" in found["Raises"]


@pytest.mark.parametrize("of", FUNCTIONS, ids=name_of)
def test_functions_show_an_example(of: Callable[..., object]) -> None:
    assert ">>> " in sections(of)["Examples"]


def test_what_is_public() -> None:
    assert len(ds.__all__) == len(set(ds.__all__))
    for name in ds.__all__:
        assert hasattr(ds, name)


def test_every_dataclass_is_frozen() -> None:
    modules = [
        importlib.import_module(f"discostorm.{module.name}")
        for module in pkgutil.iter_modules(ds.__path__)
        if module.name != "__main__"
    ]
    classes = {
        value for module in modules for value in vars(module).values() if is_dataclass(value)
    }
    classes = {value for value in classes if value.__module__.startswith("discostorm")}
    assert len(classes) > 10
    assert not [value for value in classes if not value.__dataclass_params__.frozen]
