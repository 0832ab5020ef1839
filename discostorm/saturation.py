"""Saturation: at how many hosts utilization reaches a limit, in numbers and in symbols."""

import math
from functools import cache
from typing import Any

import numpy as np
import sympy as sp
from numpy.typing import ArrayLike

from discostorm import _checks, notation as nt
from discostorm._numeric import Polynomial, Value
from discostorm.fleet import PAPER_SWARM, Fleet, as_fleet, reject_symbols_and_cells, symbolic_group
from discostorm.lookup import AnyProtocol, AnyWifi, as_protocol
from discostorm.messages import PAPER_WINDOW
from discostorm.model import unit_costs, weighted_polynomial, weighted_sum
from discostorm.wifi import PAPER, Model


def saturation_hosts(
    protocol: AnyProtocol,
    processes: ArrayLike | None = None,
    endpoints: ArrayLike | None = None,
    wifi: AnyWifi = PAPER,
    limit: ArrayLike = 1.0,
    fleet: Fleet | None = None,
    group: int | str = 0,
    window: ArrayLike = PAPER_WINDOW,
) -> Value:
    """Return the number of identical hosts at which utilization reaches a limit.

    The largest number that stays below the limit is one less than this, rounded up. A ValueError
    says if the limit is below the utilization of a single host, or nothing sent grows with hosts.

    Parameters
    ----------
    protocol, processes, endpoints, wifi
        As for `utilization`.
    limit : array_like, optional
        Utilization to reach [1], at least that with a single such host and at most 1e100.
    fleet : Fleet, optional
        Instead of `processes` and `endpoints`: a fleet, such as robots and a laptop; a group grows.
    group : int or str, optional
        The group of the fleet that grows, by its index from 0 on [1] or its name; the first if left
        out. Its number of hosts does not matter.
    window : array_like, optional
        As for `utilization` [s].

    Returns
    -------
    float or ndarray
        Hosts [1], a real number of at least 1; infinity where any number of hosts fits: if wired
        hosts add nothing, or nothing is periodic and the window is infinite, as with `DDS`.

    Examples
    --------
    >>> import discostorm as ds
    >>> round(ds.saturation_hosts(ds.DDS, processes=2, endpoints=10), 4)
    7.1554
    """
    protocol = as_protocol(protocol)
    others, index = _fleet_and_growing_group(processes, endpoints, fleet, group)
    costs = unit_costs(protocol, wifi, window, by_hop=others.has_wired)
    single = weighted_sum(costs, others.with_hosts(index, 1), window)
    top = _checks.numbers("limit", limit, 0, _checks.MAX_UTILIZATION, exclusive_min=True)
    arrays = others.non_scalars() if fleet else {"processes": processes, "endpoints": endpoints}
    shape = _checks.broadcast_shape(**arrays, window=window, limit=top)
    too_low = np.less(top, single)
    if too_low.any():
        mask, tops, needed = np.broadcast_arrays(too_low, top, single)
        raise ValueError(
            f"limit must be at least the utilization of a single host"
            f"{' beside the fleet' if len(others.groups) > 1 else ''} with {protocol.name}, "
            f"{float(needed[mask][0])!r}; got {float(tops[mask][0])!r}"
        )
    total = weighted_polynomial(costs, others.with_hosts(index, Polynomial((1.0, 1.0))))
    if others.groups[index].wired and not isinstance(total, Polynomial):
        total = Polynomial((0.0,))
    if not isinstance(total, Polynomial):
        raise ValueError(f"utilization must grow with hosts; that of {protocol.name} does not")
    hosts = 1 + _polynomial_root(total.coefficients[1:], top - single)
    # Rounding could give a little less than one host at the lowest limit allowed, and a channel
    # that hosts do not fill has no root.
    hosts = np.where(np.isnan(hosts), math.inf, np.maximum(hosts, 1.0))
    return np.array(np.broadcast_to(hosts, shape)) if shape else float(hosts)


def _fleet_and_growing_group(
    processes: ArrayLike | None, endpoints: ArrayLike | None, fleet: Fleet | None, group: int | str
) -> tuple[Fleet, int]:
    """Return the fleet with the growing group, and the index of the group."""
    if fleet is None:
        fleet = Fleet.swarm(1, processes, endpoints)
        reject_symbols_and_cells(fleet)
        return fleet, 0
    _checks.instance("fleet", fleet, Fleet)
    fleet = as_fleet(fleet, processes, endpoints).without_data()
    if isinstance(group, str):
        _checks.choice("group", group, fleet.names)
        return fleet, fleet.names.index(group)
    _checks.integer("group", group, 0, len(fleet.groups) - 1)
    return fleet, int(group)


def _polynomial_root(factors: tuple[Value, ...], rest: Value) -> Value:
    """Return the root x of f1 x + f2 x^2 + ... = rest, for these factors f."""
    first, second, *higher = (*factors, 0.0, 0.0)
    with np.errstate(all="ignore"):
        if not any(np.any(factor) for factor in higher):
            return np.divide(2 * rest, first + np.sqrt(first**2 + 4 * second * rest))
        low, high = np.zeros(np.shape(rest)), np.ones(np.shape(rest))
        while (too_low := _evaluate_polynomial(factors, high) < rest).any():
            high = np.where(too_low, 2 * high, high)
        for _ in range(_HALVINGS):
            middle = (low + high) / 2
            over = _evaluate_polynomial(factors, middle) >= rest
            low, high = np.where(over, low, middle), np.where(over, middle, high)
    return high


def _evaluate_polynomial(factors: tuple[Value, ...], x: Value) -> Any:
    return sum(factor * x**power for power, factor in enumerate(factors, start=1))


#: Until the bracket is smaller than the last digit of a float64.
_HALVINGS = 56
_MUST_GROW = "utilization must grow with hosts, at most as their square to be solved in symbols"


def solve_hosts(utilization: sp.Expr) -> sp.Expr:
    r"""Return the N_H at which a utilization, given in symbols, reaches U_limit.

    Utilization is quadratic in :math:`x = N_H - 1`: :math:`a x^2 + b x + c = U_{limit}`,
    with a, b and c at least 0. Its root is written as

    .. math:: N_H = 1 + \frac{2 (U_{limit} - c)}{b + \sqrt{b^2 + 4 a (U_{limit} - c)}}

    which is the usual formula, in the form that does not cancel in floating point. A ValueError
    says if utilization grows faster than that, or not at all.
    """
    return _hosts_at_limit(*_coefficients(utilization))


def _coefficients(utilization: sp.Expr) -> tuple[sp.Expr, ...]:
    """Return the coefficients of the square, first and zeroth power of N_H - 1."""
    more = sp.Symbol("x", positive=True)
    polynomial = utilization.subs(nt.N_H, 1 + more)
    if polynomial.diff(more, 3) != 0:
        raise ValueError(_MUST_GROW)
    # Derivatives avoid expanding a sum over all pairs of groups.
    derivatives = {degree: polynomial.diff(more, degree).subs(more, 0) for degree in (2, 1, 0)}
    return tuple(value / sp.factorial(degree) for degree, value in derivatives.items())


def _hosts_at_limit(a: sp.Expr, b: sp.Expr, c: sp.Expr) -> sp.Expr:
    """Return the N_H of `solve_hosts` for these coefficients."""
    if a == 0 and b == 0:
        raise ValueError(_MUST_GROW)
    rest = nt.U_LIMIT - c
    return 1 + 2 * rest / (b + sp.sqrt(b**2 + 4 * a * rest))


@cache
def saturation(
    protocol: AnyProtocol,
    model: Model = "linear",
    other_groups: int = 0,
    window: sp.Expr | float = PAPER_WINDOW,
) -> sp.Expr:
    """Return the N_H at which utilization reaches U_limit, in symbols; see `solve_hosts`.

    `other_groups` is the number of further groups (N_H1, N_P1, N_E1 and so on) on the channel.
    """
    protocol = as_protocol(protocol)
    others = (symbolic_group(index) for index in range(1, other_groups + 1))
    fleet = Fleet((*PAPER_SWARM.groups, *others))
    # Solve with one symbol for the cost of each unit, because costs have many terms.
    costs = protocol.costs(None, model, window)
    symbols = {sp.Dummy(positive=True): unit for unit, cost in costs.items() if cost != 0}
    total = sp.Add(*(symbol * unit.count(fleet) for symbol, unit in symbols.items()))
    values = {symbol: costs[unit] for symbol, unit in symbols.items()}
    return _hosts_at_limit(*(coefficient.xreplace(values) for coefficient in _coefficients(total)))
