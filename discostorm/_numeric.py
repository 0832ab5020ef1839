"""From sympy to NumPy: the one place where an expression becomes a function."""

import math
from collections.abc import Callable, Mapping, Sequence
from functools import cache

import numpy as np
import sympy as sp
from numpy.typing import ArrayLike, NDArray

from discostorm import _checks

Value = float | NDArray[np.float64]

#: Elements computed at a time, so that the intermediate results stay in the cache.
_BLOCK = 65_536


def hide_rounded(expression: sp.Expr) -> tuple[sp.Expr, dict[sp.Symbol, sp.Expr]]:
    """Return the expression with symbols for what it rounds, and what these stand for.

    What is rounded up must stay as it is written: an expanded ratio, or one times a
    reciprocal, is off by a rounding error, which may lift a whole number over itself.
    """
    hidden: dict[sp.Expr, sp.Symbol] = {}
    parts = sp.preorder_traversal(expression)
    for part in parts:
        if isinstance(part, (sp.ceiling, sp.floor, sp.Max, sp.Min)):
            parts.skip()
            hidden.setdefault(part, sp.Symbol(f"rounded_{len(hidden)}"))
    return expression.xreplace(hidden), {symbol: part for part, symbol in hidden.items()}


def share(expression: sp.Expr) -> tuple[list[tuple[sp.Symbol, sp.Expr]], sp.Expr]:
    """Return what the expression shares or rounds, each with its symbol, and what is left."""
    rest, rounded = hide_rounded(expression)
    shared, (reduced,) = sp.cse([rest])
    return [*rounded.items(), *shared], reduced


@cache
def _compiled(symbols: tuple[sp.Symbol, ...], expression: sp.Expr) -> Callable[..., Value]:
    # modules="numpy" alone: with SciPy about, lambdify would pick other functions.
    function: Callable[..., Value] = sp.lambdify(symbols, expression, modules="numpy", cse=share)
    return function


def lambdify(symbols: Sequence[sp.Symbol], expression: sp.Expr) -> Callable[..., Value]:
    """Turn a sympy expression into a NumPy function of its symbols.

    Unlike `sympy.lambdify`, the function returns the shape its arguments broadcast to,
    also where the expression does not contain one of them, and computes in float64,
    so integer arrays of any width cannot overflow.

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

    Raises
    ------
    ValueError
        If `expression` contains other symbols, or two have the same name; from the
        function, if an argument is not finite or the shapes do not broadcast.
    TypeError
        If `symbols` or `expression` is not made by sympy; from the function, if an
        argument is missing or not made of real numbers.

    Examples
    --------
    >>> import sympy as sp
    >>> x, y = sp.symbols("x y")
    >>> f = lambdify([x, y], 2 * x)
    >>> f(3, y=1)
    6.0
    >>> f([1, 2], [[0], [0]])
    array([[2., 4.],
           [2., 4.]])
    """
    _checks.instance("expression", expression, sp.Expr)
    arguments: tuple[sp.Symbol, ...] = _checks.members("symbols", symbols, sp.Symbol)
    unknown = expression.free_symbols - set(arguments)
    if unknown:
        missing = ", ".join(sorted(symbol.name for symbol in unknown))
        raise ValueError(f"symbols must list all that expression contains; {missing} is missing")
    names = [symbol.name for symbol in arguments]
    if len(set(names)) < len(names):
        raise ValueError(f"symbols must have names that differ; got {', '.join(names)}")

    def numeric(*args: ArrayLike, **kwargs: ArrayLike) -> Value:
        given = dict(zip(names, args, strict=False)) | kwargs
        if len(args) + len(kwargs) != len(names) or given.keys() != set(names):
            by_name = f" and {', '.join(kwargs)} by name" if kwargs else ""
            raise TypeError(
                f"the function takes {', '.join(names)}; got {len(args)} in order{by_name}"
            )
        return evaluate(
            expression,
            {
                symbol: _checks.numbers(symbol.name, given[symbol.name], -np.inf, above=True)
                for symbol in arguments
            },
        )

    numeric.__doc__ = f"Return {expression} as a NumPy function of {', '.join(names)}."
    return numeric


def evaluate(expression: sp.Expr, given: Mapping[sp.Symbol, Value]) -> Value:
    """Return the value of ``expression`` for float64 arrays; of the shape they broadcast to."""
    shape = _checks.shape(**{symbol.name: value for symbol, value in given.items()})
    function = _compiled(tuple(given), expression)
    if not shape:
        return float(_real(function(*given.values()), expression))
    result = np.empty(shape)
    rows = max(1, _BLOCK // max(1, math.prod(shape[1:])))
    for start in range(0, shape[0], rows):
        block = slice(start, start + rows)
        values = (
            value[block]
            if isinstance(value, np.ndarray) and value.ndim == len(shape) and len(value) > 1
            else value
            for value in given.values()
        )
        result[block] = _real(function(*values), expression)
    return result


def _real(value: Value, expression: sp.Expr) -> Value:
    if np.iscomplexobj(value):
        raise ValueError(f"expression must be real; {expression} is not")
    return value
