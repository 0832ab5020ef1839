"""From sympy to NumPy: the one place where an expression becomes a function."""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, partial, reduce
from itertools import product, repeat, zip_longest
from operator import mul
from typing import Any

import numpy as np
import sympy as sp
from numpy.typing import ArrayLike, NDArray
from sympy.printing.numpy import NumPyPrinter

from discostorm import _checks

Value = float | NDArray[np.float64]

#: Elements computed at a time: intermediate results stay in the cache, and are as large as
#: they must be for NumPy to write the next one in their place (256 KiB).
_BLOCK = 32_768


def plain(number: float) -> float:
    """Return a number as int if it is whole, so that expressions show no floats without need."""
    return int(number) if float(number).is_integer() else number


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
    function = compiled(tuple(given), expression)
    if not shape:
        return float(_real(function(*given.values()), expression))

    def block(out: NDArray[np.float64], *values: Value) -> None:
        out[...] = _real(function(*values), expression)

    return in_blocks(block, tuple(given.values()), shape)


def evaluate_each(
    expressions: Sequence[sp.Expr], given: Mapping[sp.Symbol, float]
) -> tuple[float, ...]:
    """Return the values of several expressions for numbers, compiled as one."""
    values: Any = compiled(tuple(given), sp.Tuple(*expressions))(*given.values())
    return tuple(map(float, values))


def in_blocks(
    function: Callable[..., None], values: Sequence[Value], shape: tuple[int, ...]
) -> NDArray[np.float64]:
    """Return the result that ``function`` writes, block by block.

    It is called with a block of the result, which has this shape, and the same block of each
    of the values, which broadcast to it.
    """
    result = np.empty(shape)
    rows = max(1, _BLOCK // max(1, math.prod(shape[1:])))
    # What is too small for a float is zero, also where NumPy is told to raise an error.
    with np.errstate(under="ignore"):
        for start in range(0, shape[0], rows):
            block = slice(start, start + rows)
            function(
                result[block],
                *(
                    value[block]
                    if isinstance(value, np.ndarray) and value.ndim == len(shape) and len(value) > 1
                    else value
                    for value in values
                ),
            )
    return result


@dataclass(frozen=True)
class Program:
    """An expression as sums and products of two, in an order: the same of numbers and of arrays.

    Parameters
    ----------
    leaves : tuple of callable
        What is neither: functions of the arguments.
    steps : tuple of (bool, int, int, int)
        Whether to multiply, what with what, and where the result goes: places of the leaves,
        then of intermediate results.
    places : int
        Number of places.
    """

    leaves: tuple[Callable[..., Value], ...]
    steps: tuple[tuple[bool, int, int, int], ...]
    places: int

    def of_numbers(self, *values: float) -> float:
        """Return the value for numbers."""
        held = [leaf(*values) for leaf in self.leaves]
        held += [0.0] * (self.places - len(held))
        for times, one, another, place in self.steps:
            held[place] = held[one] * held[another] if times else held[one] + held[another]
        return float(held[self.steps[-1][-1]])

    def into(self, out: NDArray[np.float64], spare: list[Any], *values: Value) -> None:
        """Write the value for arrays, in place; ``spare`` holds the room for the next block."""
        held: list[Any] = [leaf(*values) for leaf in self.leaves]
        if not spare or spare[0].shape != out.shape:
            spare[:] = (np.empty_like(out) for _ in range(self.places - len(held)))
        held += spare
        held[self.steps[-1][-1]] = out
        for times, one, another, place in self.steps:
            (np.multiply if times else np.add)(held[one], held[another], out=held[place])


def program(symbols: tuple[sp.Symbol, ...], expression: sp.Expr) -> Program:
    """Return an expression of these symbols as a program."""
    leaves: dict[sp.Expr, int] = {}
    for part in (parts := sp.preorder_traversal(expression)):
        if not isinstance(part, (sp.Add, sp.Mul)):
            leaves.setdefault(part, len(leaves))
            parts.skip()
    steps: list[tuple[bool, int, int, int]] = []
    free: list[int] = []
    places = len(leaves)

    def place_of(part: sp.Expr) -> int:
        nonlocal places
        if part in leaves:
            return leaves[part]
        # What is computed goes first: its place can take the result.
        first, *others = sorted(part.args, key=lambda arg: arg in leaves)
        result = place_of(first)
        for other in others:
            operand = place_of(other)
            computed = [place for place in (result, operand) if place >= len(leaves)]
            target = computed.pop(0) if computed else free.pop() if free else places
            places = max(places, target + 1)
            steps.append((isinstance(part, sp.Mul), result, operand, target))
            free.extend(computed)
            result = target
        return result

    if place_of(expression) < len(leaves):  # a leaf itself: times one
        return program(symbols, sp.Mul(expression, 1, evaluate=False))
    return Program(tuple(_leaf(symbols, leaf) for leaf in leaves), tuple(steps), places)


def _leaf(symbols: tuple[sp.Symbol, ...], leaf: sp.Expr) -> Callable[..., Value]:
    if leaf in symbols:
        return partial(_argument, symbols.index(leaf))
    return compiled(symbols, leaf)


def _argument(index: int, *values: Value) -> Value:
    return values[index]


def _real(value: Value, expression: sp.Expr) -> Value:
    if np.iscomplexobj(value):
        raise ValueError(f"expression must be real; {expression} is not")
    return value


@dataclass(frozen=True)
class Polynomial:
    """A polynomial in one unknown: adds and multiplies like a number, without cancellation.

    Parameters
    ----------
    coefficients : tuple of float or ndarray
        That of the constant first.
    """

    coefficients: tuple[Value, ...]

    #: Tells NumPy's arrays to leave arithmetic with it to the methods below.
    __array_ufunc__ = None

    def __add__(self, other: Any) -> "Polynomial":
        pairs = zip_longest(self.coefficients, coefficients(other), fillvalue=0.0)
        return Polynomial(tuple(one + another for one, another in pairs))

    def __sub__(self, other: Any) -> "Polynomial":
        return self + Polynomial(coefficients(other)) * -1.0

    def __rsub__(self, other: Any) -> "Polynomial":
        return Polynomial(coefficients(other)) - self

    def __mul__(self, other: Any) -> "Polynomial":
        others = coefficients(other)
        products: list[Value] = [0.0] * (len(self.coefficients) + len(others) - 1)
        for (i, one), (j, another) in product(enumerate(self.coefficients), enumerate(others)):
            products[i + j] = products[i + j] + one * another
        return Polynomial(tuple(products))

    def __truediv__(self, other: Any) -> "Polynomial":
        return Polynomial(tuple(one / other for one in self.coefficients))

    def __pow__(self, exponent: int) -> "Polynomial":
        return reduce(mul, repeat(self, exponent), Polynomial((1.0,)))

    __radd__ = __add__
    __rmul__ = __mul__


def coefficients(value: Any) -> tuple[Value, ...]:
    """Return those of a polynomial, or of a constant."""
    return value.coefficients if isinstance(value, Polynomial) else (value,)
