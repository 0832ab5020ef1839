"""What a test of a claim may compute, by its name: the public functions of these modules."""

from collections.abc import Callable
from inspect import isfunction
from types import ModuleType
from typing import Any

from discostorm.model import utilization
from discostorm.paper.quantities import found, frames, swarms
from discostorm.saturation import saturation_hosts


def _public(module: ModuleType) -> dict[str, Callable[..., Any]]:
    return {
        name: function
        for name, function in vars(module).items()
        if isfunction(function)
        and function.__module__ == module.__name__
        and not name.startswith("_")
    }


#: By their names, as ``data/paper/claims.csv`` has them.
QUANTITIES: dict[str, Callable[..., Any]] = {
    "saturation_hosts": saturation_hosts,
    "utilization": utilization,
    **_public(swarms),
    **_public(frames),
    **_public(found),
}
