"""Convert SymPy expressions to NumPy functions; no other module does."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import product, zip_longest
from typing import Any

import numpy as np
import sympy as sp
from numpy.typing import ArrayLike, NDArray
from sympy.printing.numpy import NumPyPrinter

from discostorm import _checks

Value = float | NDArray[np.float64]


def int_if_integral(number: Any) -> Any:
    """Return a float with an integer value as an int, so that expressions show 2, not 2.0."""
    return int(number) if isinstance(number, float) and number.is_integer() else number


def hide_rounded(expression: sp.Expr) -> tuple[sp.Expr, dict[sp.Symbol, sp.Expr]]:
    """Replace each rounded part of an expression by a symbol; return it and the parts by symbol."""
    # Rounded parts stay as written: if they were rearranged, an error could round them up.
    hidden: dict[sp.Expr, sp.Symbol] = {}
    parts = sp.preorder_traversal(expression)
    for part in parts:
        if isinstance(part, (sp.ceiling, sp.floor, sp.Max, sp.Min)):
            parts.skip()
            hidden.setdefault(part, sp.Symbol(f"rounded_{len(hidden)}"))
    return expression.xreplace(hidden), {symbol: part for part, symbol in hidden.items()}


def cse_keep_rounding(expression: sp.Expr) -> tuple[list[tuple[sp.Symbol, sp.Expr]], sp.Expr]:
    """Return the common subexpressions of `sympy.cse`, with each rounded part in one piece."""
    rest, rounded = hide_rounded(expression)
    shared, (reduced,) = sp.cse([rest])
    return [*rounded.items(), *shared], reduced


def factor_out_common(expression: sp.Expr) -> sp.Expr:
    """Return an equal expression that multiplies by each common factor only once."""
    shared, (total,) = sp.cse([sp.factor_terms(expression)])
    for symbol, part in reversed(shared):
        total = sp.collect(total, symbol).subs(symbol, part)
    return total


@cache
def compile_function(symbols: tuple[sp.Symbol, ...], expression: sp.Basic) -> Callable[..., Value]:
    """Return a NumPy function of the symbols, in their order, without checks of arguments."""
    # The names of NumPy itself. modules="numpy" would also import f2py and the tests, and would
    # prefer SciPy's functions where SciPy is installed.
    names = vars(np) | {"I": 1j}
    settings = {"fully_qualified_modules": False, "inline": True, "allow_unknown_functions": True}
    function: Callable[..., Value] = sp.lambdify(
        symbols, expression, modules=[names], printer=NumPyPrinter(settings), cse=cse_keep_rounding
    )
    return function


def lambdify(symbols: Sequence[sp.Symbol], expression: sp.Expr) -> Callable[..., Value]:
    """Turn a sympy expression into a NumPy function of its symbols.

    Unlike that of `sympy.lambdify`, the function returns the shape to which its arguments
    broadcast, also where the expression lacks one of them, and computes in float64.

    Parameters
    ----------
    symbols : sequence of sympy.Symbol
        The arguments of the function, in order; each may also be given by its name.
        All free symbols of `expression` must be among them.
    expression : sympy.Expr
        What to compute.

    Returns
    -------
    callable
        Takes array-likes of finite numbers. Scalars give a float, arrays an ndarray.

    Examples
    --------
    >>> import sympy as sp
    >>> x, y = sp.symbols("x y")
    >>> lambdify([x, y], 2 * x)([1, 2], y=[[0], [0]])
    array([[2., 4.],
           [2., 4.]])
    """
    _checks.instance("expression", expression, sp.Expr)
    arguments: tuple[sp.Symbol, ...] = _checks.tuple_of("symbols", symbols, sp.Symbol)
    unknown = expression.free_symbols - set(arguments)
    if unknown:
        missing = ", ".join(sorted(symbol.name for symbol in unknown))
        raise ValueError(f"symbols must list every symbol in expression; {missing} is missing")
    names = [symbol.name for symbol in arguments]
    _checks.distinct("symbols", names)

    def numeric(*args: ArrayLike, **kwargs: ArrayLike) -> Value:
        given = dict(zip(names, args, strict=False)) | kwargs
        if len(args) + len(kwargs) != len(names) or given.keys() != set(names):
            by_name = f" and {', '.join(kwargs)} by name" if kwargs else ""
            got = f"{len(args)} in order{by_name}"
            raise TypeError(f"the function takes {', '.join(names)}; got {got}")
        values = {
            symbol: _checks.numbers(name, given[name], -np.inf, exclusive_min=True)
            for symbol, name in zip(arguments, names, strict=True)
        }
        return evaluate(expression, values)

    numeric.__doc__ = f"Return {expression} as a NumPy function of {', '.join(names)}."
    return numeric


def evaluate(expression: sp.Expr, given: Mapping[sp.Symbol, Value]) -> Value:
    """Return the value of an expression, of the shape to which the given arrays broadcast."""
    shape = _checks.broadcast_shape(**{symbol.name: value for symbol, value in given.items()})
    # Results too small for a float become zero, whatever errors NumPy is set to raise.
    with np.errstate(under="ignore"):
        value = compile_function(tuple(given), expression)(*given.values())
    if np.iscomplexobj(value):
        raise ValueError(f"expression must be real; {expression} is not")
    return np.array(np.broadcast_to(value, shape)) if shape else float(value)


@dataclass(frozen=True)
class Polynomial:
    """A polynomial in one unknown, by its coefficients from the constant on.

    It adds and multiplies like a number.
    """

    coefficients: tuple[Value, ...]

    #: Makes NumPy arrays use the methods below for arithmetic with polynomials.
    __array_ufunc__ = None

    def __add__(self, other: Any) -> "Polynomial":
        pairs = zip_longest(self.coefficients, _coefficients(other), fillvalue=0.0)
        return Polynomial(tuple(a + b for a, b in pairs))

    def __sub__(self, other: Any) -> "Polynomial":
        return self + Polynomial(_coefficients(other)) * -1.0

    def __mul__(self, other: Any) -> "Polynomial":
        others = _coefficients(other)
        products: list[Value] = [0.0] * (len(self.coefficients) + len(others) - 1)
        for (i, a), (j, b) in product(enumerate(self.coefficients), enumerate(others)):
            products[i + j] = products[i + j] + a * b
        return Polynomial(tuple(products))

    __radd__ = __add__
    __rmul__ = __mul__


def _coefficients(value: Any) -> tuple[Value, ...]:
    return value.coefficients if isinstance(value, Polynomial) else (value,)
