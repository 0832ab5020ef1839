"""Generate the book's calculator: sympy formulas and data, printed as JavaScript."""

from discostorm_planner.calculator.model_text import HEADER, model_js

__all__ = ["HEADER", "model_js"]
