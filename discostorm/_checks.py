"""Checks of users' arguments: the error names parameter, value and allowed range.

They raise a TypeError for a wrong type, a ValueError for a value out of range.
"""

import reprlib
import sys
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from numbers import Real
from os import PathLike, fspath
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

#: Largest count allowed: far beyond any fleet, and its powers still fit a float64.
MAX_COUNT = 1e9
#: Rates [bit/s], sizes [B] and times [s] allowed: far beyond any radio.
MIN_RATE, MAX_RATE = 1.0, 1e15
MAX_BYTES = 1e9
MIN_SECONDS, MAX_SECONDS = 1e-9, 1e6
#: Largest utilization to solve for: its powers still fit a float64.
MAX_UTILIZATION = 1e100
#: Longest name or path that a message repeats in full [characters].
_MAX_SHOWN = 200


def short_repr(value: Any) -> str:
    """Return a short one-line representation of any value, also of long or nested ones."""
    return " ".join(reprlib.repr(value).split())


def shorten_name(text: str) -> str:
    """Return a name or a path; leave out its middle if the text is too long for a message."""
    return text if len(text) <= _MAX_SHOWN else f"{text[: _MAX_SHOWN // 2]}...{text[-20:]}"


def shorten_repr(text: str) -> str:
    """Return the representation of an object; leave out its middle if it exceeds two lines."""
    return text if len(text) <= 156 else f"{text[:116]} ... {text[-35:]}"


def format_exact(value: float) -> str:
    """Return the shortest text of a number that keeps all its digits."""
    text = f"{value:g}"
    return text if float(text) == value else f"{value:.15g}"


def describe_range(
    low: float,
    high: float = np.inf,
    exclusive_min: bool = False,
    exclusive_max: bool = False,
    allow_inf: bool = False,
    what: str = "a finite number",
) -> str:
    """Describe the allowed range in words; `exclusive_min` and `exclusive_max` exclude its ends."""
    start = f" {'above' if exclusive_min else 'of at least'} {format_exact(low)}"
    end = f" and {'below' if exclusive_max else 'at most'} {format_exact(high)}"
    text = f"{what}{'' if np.isinf(low) else start}{'' if np.isinf(high) else end}"
    return f"{text}, or infinity" if allow_inf else text


def _has_no_mask_or_labels(value: Any) -> bool:
    """Return whether a value, or any element of a list, has neither a mask nor labels."""
    if isinstance(value, (list, tuple)):
        return set(map(type, value)) <= {int, float} or all(map(_has_no_mask_or_labels, value))
    return not (isinstance(value, np.ma.MaskedArray) or hasattr(value, "to_numpy"))


def _real_array(name: str, value: ArrayLike, allowed: str) -> NDArray[Any]:
    """Return an array of real numbers of any range, or raise a TypeError."""
    if not _has_no_mask_or_labels(value):
        raise TypeError(
            f"{name} must be {allowed}; got a value of type {type(value).__name__} with labels or "
            "a mask, which would be lost: give a NumPy array"
        )
    kind: type[Exception] = TypeError
    try:
        given = np.asarray(value)
        if given.dtype.kind in "iuf" or (
            given.dtype.kind == "O"
            and all(isinstance(item, Real) and not isinstance(item, bool) for item in given.flat)
        ):
            return given
    except Exception as error:  # types of other libraries may raise any error
        kind = ValueError if isinstance(error, ValueError) else TypeError  # rows of unlike lengths
    raise kind(f"{name} must be {allowed}; got {short_repr(value)}")


def numbers(
    name: str,
    value: ArrayLike,
    low: float,
    high: float = np.inf,
    *,
    exclusive_min: bool = False,
    exclusive_max: bool = False,
    allow_inf: bool = False,
    scalar: bool = False,
) -> float | NDArray[np.float64]:
    """Return numbers in the range as float64, a single number as a float; else raise an error."""
    # A shortcut, because nearly all calls give a plain number in the range.
    if type(value) in (float, int) and (
        low < value < min(high, sys.float_info.max)  # type: ignore[operator]
        or (value == low and not exclusive_min)
    ):
        return float(value)  # type: ignore[arg-type]
    allowed = describe_range(low, high, exclusive_min, exclusive_max, allow_inf)
    if scalar:
        require_scalars([(name, value)])
    given = _real_array(name, value, allowed if scalar else f"{allowed}, or an array of them")
    try:
        array = given.astype(np.float64, copy=False)
    except OverflowError as error:  # an integer beyond all floats
        raise ValueError(f"{name} must be {allowed}; got {short_repr(value)}") from error
    good = (allow_inf | np.isfinite(array)) & (array > low if exclusive_min else array >= low)
    good &= array < high if exclusive_max else array <= high
    if not good.all():
        raise ValueError(f"{name} must be {allowed}; got {short_repr(given[~good].item(0))}")
    return array if array.ndim else array.item()


def number(name: str, value: Any, low: float, high: float = np.inf, **ends: bool) -> float:
    """Return a single number in the range as a float, or raise an error; see `numbers`."""
    return float(numbers(name, value, low, high, scalar=True, **ends))


@contextmanager
def prefix_errors(what: str) -> Iterator[None]:
    """Prefix the errors of a ``with`` block with the name of the refused object."""
    try:
        yield
    except (TypeError, ValueError) as error:
        if not what:
            raise
        kind = TypeError if isinstance(error, TypeError) else ValueError
        raise kind(f"{what}: {error}") from error


def integer(
    name: str, value: Any, low: float, high: float = np.inf, note: str = "", allow_inf: bool = False
) -> None:
    """Raise an error unless the value is one whole number in the range."""
    allowed = describe_range(low, high, allow_inf=allow_inf, what="a whole number") + note
    require_scalars([(name, value)])
    given = _real_array(name, value, allowed).item()
    if not (low <= given <= high and (given % 1 == 0 or (allow_inf and given == np.inf))):
        raise ValueError(f"{name} must be {allowed}; got {short_repr(value)}")


def require_scalars(named: Iterable[tuple[str, Any]]) -> None:
    """Raise a TypeError if a value is an array or a list."""
    for name, value in named:
        if isinstance(value, (list, tuple)) or getattr(value, "ndim", False):
            raise TypeError(f"{name} must be one number, not an array; got {short_repr(value)}")


def unwrap_0d_arrays(owner: Any) -> None:
    """Replace a dataclass's 0-d arrays by plain numbers, which can be hashed."""
    for name, value in vars(owner).items():
        if type(value) is np.ndarray and not value.ndim:
            object.__setattr__(owner, name, value.item())


def broadcast_shape(**given: Any) -> tuple[int, ...]:
    """Return the shape to which the named numbers and arrays broadcast."""
    shapes = {name: np.shape(value) for name, value in given.items() if type(value) is not float}
    try:
        return np.broadcast_shapes(*shapes.values())
    except ValueError:
        got = ", ".join(f"{name} {shape}" for name, shape in shapes.items() if shape)
        rule = "the shapes of the arguments must broadcast together"
        raise ValueError(f"{rule}; got {got}") from None


def path(name: str, value: Any, what: str) -> str:
    """Return a path as text; raise an error for an empty path or another type."""
    if not isinstance(value, (str, PathLike)) or not isinstance(text := fspath(value), str):
        raise TypeError(f"{name} must be the path of {what}, as text; got {short_repr(value)}")
    if not text or "\0" in text:
        without = ", without a NUL" * bool(text)
        raise ValueError(f"{name} must name {what}{without}; got {short_repr(value)}")
    return text


def instance(name: str, value: Any, kind: type) -> None:
    """Raise a TypeError unless the value is of that kind."""
    if not isinstance(value, kind):
        article = "an" if kind.__name__[0] in "AEIO" else "a"
        raise TypeError(f"{name} must be {article} {kind.__name__}; got {short_repr(value)}")


def nonblank(name: str, value: Any) -> None:
    """Raise an error unless the value is a text with more than blanks."""
    instance(name, value, str)
    if not value.strip():
        raise ValueError(f"{name} must be a non-blank string; got {value!r}")


def boolean(name: str, value: Any) -> bool:
    """Return a Python or NumPy bool as a Python bool; refuse other types."""
    if not isinstance(value, np.bool_):
        instance(name, value, bool)
    return bool(value)


def tuple_of(name: str, values: Any, kind: type) -> tuple[Any, ...]:
    """Return a tuple of at least one value, all of the given kind."""
    if isinstance(values, str) or not np.iterable(values):
        raise TypeError(f"{name} must be a tuple of {kind.__name__}; got {short_repr(values)}")
    items = tuple(values)
    if not items:
        raise ValueError(f"{name} must hold at least one {kind.__name__}; got none")
    for index, value in enumerate(items):
        instance(f"{name}[{index}]", value, kind)
    return items


def distinct(name: str, names: Iterable[str], what: str = "names") -> None:
    """Raise a ValueError if a name occurs twice."""
    for repeated in (each for each, times in Counter(names).items() if times > 1):
        raise ValueError(f"{name} must have distinct {what}; got {shorten_name(repeated)!r} twice")


def choice(name: str, value: Any, allowed: Sequence[str], note: str = "") -> None:
    """Raise a ValueError unless the value is one of the allowed words."""
    if not isinstance(value, str) or value not in allowed:
        words = " or ".join(map(repr, allowed))
        raise ValueError(f"{name} must be {words}{note}; got {short_repr(value)}")
