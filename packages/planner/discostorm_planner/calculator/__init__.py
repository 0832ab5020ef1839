"""Generate the book's calculator: sympy formulas and data, printed as JavaScript."""

from discostorm_planner.calculator.model import HEAD, model_js

__all__ = ["HEAD", "model_js"]
