"""Quantities that decide claims: of the paper's model, of one frame, of other evidence."""

from collections.abc import Callable
from types import FunctionType
from typing import Any

from discostorm_book.ledger.quantities import captured, evidence, frames, model

#: All quantities by their names, with the two that the core itself computes.
QUANTITIES: dict[str, Callable[..., Any]] = {}
for module in (captured, evidence, frames, model):
    for name, function in (vars(module) | module.FORMULAS).items():
        if isinstance(function, FunctionType) and not name.startswith("_"):
            function.__name__ = name  # a lambda has none
            QUANTITIES[name] = function
