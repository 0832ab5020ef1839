"""Checks of what a user passes in: the error names parameter, value and allowed range."""

from numbers import Real
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

#: Largest count taken: far beyond any fleet, and its powers still fit a float64.
MOST = 1e9


def _allowed(low: float, high: float, above: bool) -> str:
    start = f"above {low:g}" if above else f"of at least {low:g}"
    end = "" if np.isinf(high) else f" and at most {high:g}"
    return f"a finite number {start}{end}"


def numbers(
    name: str, value: ArrayLike, low: float, high: float = np.inf, *, above: bool = False
) -> float | NDArray[np.float64]:
    """Return ``value`` as float64 if every element is finite and within the range.

    A scalar or 0-d array gives a float, which NumPy handles faster. ``above`` excludes
    the lower end.

    Raises
    ------
    TypeError
        If it is not made of real numbers.
    ValueError
        If an element is NaN, infinite or out of range.
    """
    allowed = _allowed(low, high, above)
    try:
        given = np.asarray(value)
    except ValueError as error:
        raise ValueError(f"{name} must be {allowed}, or an array of them; got {value!r}") from error
    if given.dtype.kind not in "iuf" and not (
        given.dtype.kind == "O"
        and all(isinstance(item, Real) and not isinstance(item, bool) for item in given.flat)
    ):
        raise TypeError(f"{name} must be {allowed}, or an array of them; got {value!r}")
    array = given.astype(np.float64, copy=False)
    if array.size:
        least, most = array.min(), array.max()
        # A comparison with NaN is false, so both tests are put the positive way round.
        if not ((least > low if above else least >= low) and most <= high and most < np.inf):
            good = np.isfinite(array) & (array <= high) & (array > low if above else array >= low)
            raise ValueError(f"{name} must be {allowed}; got {array[~good].flat[0]:g}")
    return array if array.ndim else array.item()


def number(name: str, value: Any, low: float, high: float = np.inf, *, above: bool = False) -> float:
    """Return ``value`` as a float if it is one number within the range; see `numbers`."""
    checked = numbers(name, value, low, high, above=above)
    if not isinstance(checked, float):
        raise TypeError(f"{name} must be one number, not an array; got {value!r}")
    return checked


def shape(**given: tuple[int, ...]) -> tuple[int, ...]:
    """Return the shape to which the named shapes broadcast.

    Raises
    ------
    ValueError
        If they do not; the message names each with its shape.
    """
    try:
        return np.broadcast_shapes(*given.values())
    except ValueError:
        shapes = ", ".join(f"{name} {shape}" for name, shape in given.items() if shape)
        raise ValueError(f"the shapes do not broadcast to one: {shapes}") from None
