"""Start times of hosts, given or drawn at random."""

from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from inspect import signature
from typing import Any, Protocol, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from discostorm import _checks


class Distribution(Protocol):
    """A distribution of start times, such as one of `scipy.stats`."""

    def rvs(self, *, size: int, random_state: np.random.Generator) -> Any:
        """Draw a number of start times."""


#: One start time for all hosts [s], one per host, or a distribution or function to draw from.
Start: TypeAlias = ArrayLike | Distribution | Callable[[np.random.Generator, int], ArrayLike]


def uniform_start(within: float) -> Callable[[np.random.Generator, int], NDArray[np.float64]]:
    """Return a rule that draws each host's start uniformly from 0 to ``within`` [s]."""
    return _UniformStart(_checks.number("within", within, 0))


@dataclass(frozen=True)
class _UniformStart:
    within: float

    def __call__(self, rng: np.random.Generator, hosts: int) -> NDArray[np.float64]:
        return rng.uniform(0.0, self.within, hosts)

    def __str__(self) -> str:
        return f"at random within {_checks.format_exact(self.within)} s, each time equally likely"


def describe_start(start: Any) -> float | list[float] | str:
    """Describe the given start times: numbers, or text if the times are drawn."""
    if not hasattr(start, "rvs") and not callable(start):
        number_or_list: float | list[float] = np.asarray(start, dtype=np.float64).tolist()
        return number_or_list
    if hasattr(start, "dist"):  # a distribution of SciPy, with its parameters
        given = [*map(repr, start.args), *(f"{key}={value!r}" for key, value in start.kwds.items())]
        return f"scipy.stats.{start.dist.name}({', '.join(given)})"
    if "__str__" in vars(type(start)):
        return str(start)
    named = start if hasattr(start, "__qualname__") else type(start)
    return f"{named.__module__}.{named.__qualname__}"


def start_times(start: Start, hosts: int, rng: np.random.Generator) -> NDArray[np.float64]:
    """Return the start time of each host [s]; see `discostorm.simulate`."""
    if hasattr(start, "rvs"):
        drawn = start.rvs(size=hosts, random_state=rng)
    elif callable(start):
        try:
            with suppress(ValueError):  # some compiled functions have no signature
                signature(start).bind(rng, hosts)
        except TypeError as error:
            raise TypeError(
                "start must be a function of a numpy.random.Generator and a number of hosts; "
                f"got one that does not take these: {error}"
            ) from error
        drawn = start(rng, hosts)
    else:
        drawn = start
    found = _checks.numbers("start", drawn, 0, _checks.MAX_SECONDS)
    if np.ndim(found) and np.shape(found) != (hosts,):
        rule = f"start must give one time for each of the {hosts} hosts"
        raise ValueError(f"{rule}; got {np.shape(found)}")
    return np.broadcast_to(np.asarray(found, dtype=np.float64), (hosts,))
