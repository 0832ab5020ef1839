"""Discovery traffic of ROS 2 middlewares on Wi-Fi: the model of the paper, executable.

A wrong argument raises a ValueError if it is NaN, infinite, out of range, unknown or of a wrong
shape, and a TypeError if it is of another kind. Both name parameter, value and what is allowed.
"""

import ast
from functools import cache
from importlib import import_module
from pathlib import Path
from typing import Any

__version__ = "0.4.0"


@cache
def _package_of_name() -> dict[str, tuple[str, str]]:
    """Return the module and the name there of each public name, as __init__.pyi lists them."""
    stub = ast.parse(Path(__file__).with_suffix(".pyi").read_text(encoding="utf-8"))
    imports = [node for node in stub.body if isinstance(node, ast.ImportFrom)]
    return {
        alias.asname or alias.name: (node.module or "", alias.name)
        for node in imports
        for alias in node.names
    }


__all__ = [
    name for name, (module, _) in _package_of_name().items() if module.partition(".")[0] == __name__
]


class _UnknownAttribute(str):
    """A name that the package lacks; finds the nearest valid name only when the error is shown."""

    def __str__(self) -> str:
        from discostorm._names import did_you_mean

        like = did_you_mean(self, _package_of_name())
        return f"module {__name__!r} has no attribute {self[:]!r}{like}"


# Names are loaded on first use. So the command line answers Ctrl-C before NumPy and SymPy are
# loaded, and the core works alone.
def __getattr__(name: str) -> Any:
    if name not in _package_of_name():
        # An error with a name; without one, Python would add a second suggestion.
        raise AttributeError(_UnknownAttribute(name), name=name)
    module, attribute = _package_of_name()[name]
    if module == __name__:
        value = import_module(f"{module}.{attribute}")
    else:
        try:
            value = getattr(import_module(module), attribute)
        except ModuleNotFoundError as error:
            package = module.partition(".")[0]
            if error.name != package:
                raise
            extra = package.removeprefix("discostorm_")
            raise ImportError(
                f"discostorm.{name} needs {package}; to get it: pip install 'discostorm[{extra}]'",
                name=package,
            ) from error
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted(_package_of_name())
