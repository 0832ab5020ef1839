"""Checks of what a user passes in: the error names parameter, value and allowed range."""

import reprlib
import sys
from collections.abc import Iterable, Sequence
from numbers import Real
from os import PathLike, fspath
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

#: Largest count taken: far beyond any fleet, and its powers still fit a float64.
MOST = 1e9
#: Rates [bit/s], sizes [B] and times [s] taken: far beyond any radio, and what is computed
#: from them is finite.
LEAST_RATE, MOST_RATE = 1.0, 1e15
MOST_BYTES = 1e9
LEAST_SECONDS, MOST_SECONDS = 1e-9, 1e6
#: Largest utilization to solve for: its powers still fit a float64.
MOST_UTILIZATION = 1e100
#: Longest name or path that a message repeats as it is [characters].
_LONGEST = 200


def short(value: Any) -> str:
    """Return what was given in a line that can be read, however long or deeply nested it is."""
    return " ".join(reprlib.repr(value).split())


def brief(text: str) -> str:
    """Return a name or a path as it is, or without its middle if it is too long for a message."""
    return text if len(text) <= _LONGEST else f"{text[: _LONGEST // 2]}...{text[-20:]}"


def wanted(
    low: float,
    high: float = np.inf,
    above: bool = False,
    below: bool = False,
    endless: bool = False,
    what: str = "a finite number",
) -> str:
    """Return in words which numbers are allowed."""
    start = f" above {exactly(low)}" if above else f" of at least {exactly(low)}"
    end = f" and below {exactly(high)}" if below else f" and at most {exactly(high)}"
    text = f"{what}{'' if np.isinf(low) else start}{'' if np.isinf(high) else end}"
    return f"{text}, or infinity" if endless else text


def exactly(value: float) -> str:
    """Return a number as short as it can be, with all its digits."""
    text = f"{value:g}"
    return text if float(text) == value else f"{value:.15g}"


def real(name: str, value: ArrayLike, allowed: str, *, one: bool = False) -> NDArray[Any]:
    """Return ``value`` as an array of real numbers; whoever calls it checks their range.

    Errors do not speak of arrays where there can be but one number.

    Raises
    ------
    TypeError
        If it is not made of real numbers, or has labels that NumPy would drop.
    ValueError
        If the rows differ in length, or a number is beyond all floats.
    """
    any_of = allowed if one else f"{allowed}, or an array of them"
    inner = value if isinstance(value, (list, tuple)) else ()
    if set(map(type, inner)) <= {int, float}:
        inner = ()
    for part in (value, *inner):
        if np.ma.is_masked(part):
            raise TypeError(f"{name} must be {any_of} without masked elements")
        if hasattr(part, "to_numpy"):
            # As in pandas and xarray: by position, values of different labels would meet.
            raise TypeError(
                f"{name} must be {any_of}; got a value of type {type(part).__name__}, whose "
                "labels, if it has any, would be lost: give its .to_numpy()"
            )
    try:
        given = np.asarray(value)
    except ValueError as error:
        raise ValueError(f"{name} must be {any_of}; got {short(value)}") from error
    except Exception as error:  # whatever a type of others raises, such as xarray.Dataset
        raise TypeError(f"{name} must be {any_of}; got {short(value)}") from error
    if given.dtype.kind in "iuf":
        return given
    if given.dtype.kind != "O" or not all(
        isinstance(item, Real) and not isinstance(item, bool) for item in given.flat
    ):
        raise TypeError(f"{name} must be {any_of}; got {short(value)}")
    try:
        given.astype(np.float64)
    except OverflowError as error:  # an integer beyond all floats
        raise ValueError(f"{name} must be {allowed}; got {short(value)}") from error
    return given


def within(
    name: str,
    given: NDArray[Any],
    low: float,
    high: float = np.inf,
    *,
    above: bool = False,
    below: bool = False,
    endless: bool = False,
) -> NDArray[np.float64]:
    """Return real numbers as float64 if every element is finite and within the range.

    If it is ``endless``, infinity is taken as well.

    Raises
    ------
    ValueError
        If an element is NaN, infinite or out of range.
    """
    array = given.astype(np.float64, copy=False)
    if array.size:
        # As array.min() and max(), which take longer to get there.
        least, most = np.minimum.reduce(array, axis=None), np.maximum.reduce(array, axis=None)
        # A comparison with NaN is false, so both tests are put the positive way round.
        if not (
            (least > low if above else least >= low)
            and (most < high if below else most <= high)
            and (endless or most < np.inf)
        ):
            good = (endless | np.isfinite(array)) & (array > low if above else array >= low)
            good &= array < high if below else array <= high
            bad = short(given[~good].item(0))
            allowed = wanted(low, high, above, below, endless)
            raise ValueError(f"{name} must be {allowed}; got {bad}")
    return array


def numbers(
    name: str,
    value: ArrayLike,
    low: float,
    high: float = np.inf,
    *,
    above: bool = False,
    below: bool = False,
    endless: bool = False,
) -> float | NDArray[np.float64]:
    """Return ``value`` as float64 if every element is finite and within the range.

    A scalar or 0-d array gives a float, which Python computes with faster. ``above`` and
    ``below`` exclude the ends. If it is ``endless``, infinity is taken as well.

    Raises
    ------
    TypeError
        If it is not made of real numbers.
    ValueError
        If an element is NaN, infinite or out of range, or the rows differ in length.
    """
    # Most calls give plain numbers that are right.
    if (
        isinstance(value, (float, int))
        and not isinstance(value, bool)
        and (value > low if above else value >= low)
        and value <= min(high, sys.float_info.max)
        and not (below and value == high)
    ):
        return float(value)
    given = real(name, value, wanted(low, high, above, below, endless))
    array = within(name, given, low, high, above=above, below=below, endless=endless)
    return array if array.ndim else array.item()


def number(
    name: str,
    value: Any,
    low: float,
    high: float = np.inf,
    *,
    above: bool = False,
    endless: bool = False,
) -> float:
    """Return ``value`` as a float if it is one number within the range; see `numbers`."""
    if isinstance(value, (float, int)) and not isinstance(value, bool):
        return float(numbers(name, value, low, high, above=above, endless=endless))
    given = one(name, value, wanted(low, high, above, endless=endless))
    return float(within(name, given, low, high, above=above, endless=endless))


def whole(
    name: str,
    value: Any,
    low: float,
    high: float = np.inf,
    note: str = "",
    *,
    endless: bool = False,
) -> None:
    """Raise an error unless ``value`` is one whole number in the range; see `number`."""
    allowed = wanted(low, high, endless=endless, what="a whole number") + note
    given = one(name, value, allowed).astype(np.float64).item()
    if not (low <= given <= high and (given % 1 == 0 or (endless and given == np.inf))):
        raise ValueError(f"{name} must be {allowed}; got {short(value)}")


def one(name: str, value: Any, allowed: str) -> NDArray[Any]:
    """Return ``value`` as an array without dimensions; see `real`."""
    given = real(name, value, allowed, one=True)
    if given.ndim:
        one_each([(name, value)])
    return given


def one_each(named: Iterable[tuple[str, Any]]) -> None:
    """Raise a TypeError if a value is an array; see `number` for the numbers themselves."""
    for name, value in named:
        if _lengths(name, value):
            raise TypeError(f"{name} must be one number, not an array; got {short(value)}")


def _lengths(name: str, value: Any) -> tuple[int, ...]:
    """Return the shape of a value; that rows differ in length is no error of NumPy's."""
    try:
        return np.shape(value)
    except ValueError as error:
        allowed = "a number, or an array whose rows are of one length"
        raise ValueError(f"{name} must be {allowed}; got {short(value)}") from error
    except Exception as error:  # as in `real`
        raise TypeError(f"{name} must be a number, or an array; got {short(value)}") from error


def plain_numbers(owner: Any) -> None:
    """Put plain numbers in the place of a dataclass's arrays without dimensions.

    They are as good as numbers but for being hashed.
    """
    for name, value in vars(owner).items():
        if isinstance(value, np.ndarray) and not value.ndim and not np.ma.is_masked(value):
            object.__setattr__(owner, name, value.item())


def shape(**given: Any) -> tuple[int, ...]:
    """Return the shape to which the named numbers and arrays broadcast.

    Raises
    ------
    ValueError
        If they do not; the message names each with its shape.
    """
    shapes = {
        name: _lengths(name, value) for name, value in given.items() if not isinstance(value, float)
    }
    if not shapes:
        return ()
    try:
        return np.broadcast_shapes(*shapes.values())
    except ValueError:
        named = ", ".join(f"{name} {shape}" for name, shape in shapes.items() if shape)
        raise ValueError(
            f"the arguments must have shapes that broadcast to one; got {named}"
        ) from None


def first_where(bad: ArrayLike, *values: ArrayLike) -> tuple[float, ...]:
    """Return what the values hold at the first place that is bad; all shapes broadcast."""
    place, *held = np.broadcast_arrays(bad, *values)
    return tuple(float(value[place].item(0)) for value in held)


def path(name: str, value: Any, what: str) -> str:
    """Return ``value`` as text if it is a path that is not empty."""
    if not isinstance(value, (str, PathLike)) or not isinstance(fspath(value), str):
        raise TypeError(f"{name} must be the path of {what}, as text; got {short(value)}")
    if not fspath(value):
        raise ValueError(f"{name} must name {what}; got ''")
    if "\0" in str(fspath(value)):
        raise ValueError(f"{name} must name {what}, without a NUL; got {short(value)}")
    return str(fspath(value))


def instance(name: str, value: Any, kind: type) -> None:
    """Raise a TypeError unless ``value`` is of that kind."""
    if not isinstance(value, kind):
        article = "an" if kind.__name__[0] in "AEIO" else "a"
        raise TypeError(f"{name} must be {article} {kind.__name__}; got {short(value)}")


def boolean(name: str, value: Any) -> bool:
    """Return ``value`` as a bool if it is one, of Python or NumPy."""
    if isinstance(value, np.bool_):
        return bool(value)
    instance(name, value, bool)
    return bool(value)


def members(name: str, values: Any, kind: type) -> tuple[Any, ...]:
    """Return ``values`` as a tuple if it holds at least one, and only such of that kind."""
    if isinstance(values, str) or not np.iterable(values):
        raise TypeError(f"{name} must be a tuple of {kind.__name__}; got {short(values)}")
    found = tuple(values)
    if not found:
        raise ValueError(f"{name} must hold at least one {kind.__name__}; got none")
    for index, value in enumerate(found):
        instance(f"{name}[{index}]", value, kind)
    return found


def choice(name: str, value: Any, allowed: Sequence[str], note: str = "") -> None:
    """Raise a ValueError unless ``value`` is one of the allowed words."""
    if not isinstance(value, str) or value not in allowed:
        known = " or ".join(repr(word) for word in allowed)
        raise ValueError(f"{name} must be {known}{note}; got {short(value)}")
