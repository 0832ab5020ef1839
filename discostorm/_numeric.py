"""From sympy to NumPy: the one place where an expression becomes a function."""

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


def plain(number: Any) -> Any:
    """Return a float as int if it is whole, so that expressions show no floats without need."""
    return int(number) if isinstance(number, float) and number.is_integer() else number


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


def shortened(expression: sp.Expr) -> sp.Expr:
    """Return an expression in which what its terms have in common is multiplied with once."""
    shared, (total,) = sp.cse([sp.factor_terms(expression)])
    for symbol, part in reversed(shared):
        total = sp.collect(total, symbol).subs(symbol, part)
    return total


@cache
def compiled(symbols: tuple[sp.Symbol, ...], expression: sp.Basic) -> Callable[..., Value]:
    """Return a function of the symbols, in order, that checks nothing."""
    # The names that NumPy holds when it is imported: modules="numpy" would import the rest of it,
    # f2py and the tests included, and SciPy's functions would be preferred if it is there.
    names = vars(np) | {"I": 1j}
    settings = {"fully_qualified_modules": False, "inline": True, "allow_unknown_functions": True}
    function: Callable[..., Value] = sp.lambdify(
        symbols, expression, modules=[names], printer=NumPyPrinter(settings), cse=share
    )
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
    # What is too small for a float is zero, also where NumPy is told to raise an error.
    with np.errstate(under="ignore"):
        found = _real(compiled(tuple(given), expression)(*given.values()), expression)
    return np.array(np.broadcast_to(found, shape)) if shape else float(found)


def evaluate_each(
    expressions: Sequence[sp.Expr], given: Mapping[sp.Symbol, float]
) -> tuple[float, ...]:
    """Return the values of several expressions for numbers, compiled as one."""
    values: Any = compiled(tuple(given), sp.Tuple(*expressions))(*given.values())
    return tuple(map(float, values))


def _real(value: Value, expression: sp.Expr) -> Value:
    if np.iscomplexobj(value):
        raise ValueError(f"expression must be real; {expression} is not")
    return value


@dataclass(frozen=True)
class Polynomial:
    """A polynomial in one unknown: adds and multiplies like a number, without cancellation.

    Parameters
    ----------
    powers : tuple of float or ndarray
        The factors of its powers, that of the constant first.
    """

    powers: tuple[Value, ...]

    #: Tells NumPy's arrays to leave arithmetic with it to the methods below.
    __array_ufunc__ = None

    def __add__(self, other: Any) -> "Polynomial":
        pairs = zip_longest(self.powers, powers(other), fillvalue=0.0)
        return Polynomial(tuple(one + another for one, another in pairs))

    def __sub__(self, other: Any) -> "Polynomial":
        return self + Polynomial(powers(other)) * -1.0

    def __mul__(self, other: Any) -> "Polynomial":
        others = powers(other)
        products: list[Value] = [0.0] * (len(self.powers) + len(others) - 1)
        for (i, one), (j, another) in product(enumerate(self.powers), enumerate(others)):
            products[i + j] = products[i + j] + one * another
        return Polynomial(tuple(products))

    __radd__ = __add__
    __rmul__ = __mul__


def powers(value: Any) -> tuple[Value, ...]:
    """Return the factors of the powers of a polynomial, or of a constant."""
    return value.powers if isinstance(value, Polynomial) else (value,)
