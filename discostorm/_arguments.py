"""What callers pass in for a fleet: numbers, arrays, or a `Fleet`."""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from discostorm import _checks
from discostorm.fleet import COUNTS, Fleet, is_symbolic


def as_fleet(
    hosts: ArrayLike | Fleet, processes: ArrayLike | None, endpoints: ArrayLike | None
) -> Fleet:
    """Return the fleet that the arguments of `utilization` and `breakdown` describe."""
    given = {"processes": processes, "endpoints": endpoints}
    if isinstance(hosts, Fleet):
        for name, value in given.items():
            if value is not None:
                raise TypeError(
                    f"{name} must be left out when hosts is a Fleet; got {_checks.short(value)}"
                )
        fleet = hosts
    else:
        for name, value in given.items():
            if value is None:
                raise TypeError(f"{name} must be given unless hosts is a Fleet; got None")
        fleet = Fleet.swarm(*map(_kept, (hosts, processes, endpoints)))
    reject_symbols(fleet)
    return fleet


def _kept(value: Any) -> Any:
    """Return an array that `HostGroup` need not copy, as the fleet does not outlive the call."""
    if not isinstance(value, np.ndarray) or not value.ndim:
        return value
    view = value.view()
    view.flags.writeable = False
    return view


def reject_symbols(fleet: Fleet) -> None:
    """Raise a TypeError if the fleet is in symbols."""
    for group in () if fleet._of_numbers else fleet.groups:
        for name, count in zip(COUNTS, group.counts(), strict=True):
            if is_symbolic(count):
                raise TypeError(
                    f"{name} must be a number here, not an expression; got {count}. "
                    "In symbols: Protocol.utilization"
                )
