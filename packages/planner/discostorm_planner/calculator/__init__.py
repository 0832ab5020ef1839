"""What generates the calculator of the book: formulas of sympy, and data, as JavaScript."""

from discostorm_planner.calculator.model import HEAD, model_js

__all__ = ["HEAD", "model_js"]
