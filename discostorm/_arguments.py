"""What callers pass in for a fleet: numbers, arrays, or a `Fleet`."""

from numpy.typing import ArrayLike

from discostorm import _checks
from discostorm.fleet import COUNTS, Fleet, is_symbolic


def as_fleet(
    hosts: ArrayLike | Fleet, processes: ArrayLike | None, endpoints: ArrayLike | None
) -> Fleet:
    """Return the fleet that the arguments of `utilization` and `breakdown` describe."""
    for name, value in {"processes": processes, "endpoints": endpoints}.items():
        if isinstance(hosts, Fleet) and value is not None:
            raise TypeError(
                f"{name} must be left out when hosts is a Fleet; got {_checks.short_repr(value)}"
            )
        if not isinstance(hosts, Fleet) and value is None:
            raise TypeError(f"{name} must be given unless hosts is a Fleet; got None")
    fleet = hosts if isinstance(hosts, Fleet) else Fleet.swarm(hosts, processes, endpoints)
    reject_symbols(fleet)
    return fleet


def reject_symbols(fleet: Fleet) -> None:
    """Raise a TypeError if the fleet is in symbols."""
    for group in fleet.groups:
        for name, count in zip(COUNTS, group.counts(), strict=True):
            if is_symbolic(count):
                raise TypeError(
                    f"{name} must be a number here, not an expression; got {count}. "
                    "In symbols: Protocol.utilization"
                )
