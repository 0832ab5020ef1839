"""Saturation: at how many hosts utilization reaches a limit, in numbers and in symbols."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np
import sympy as sp
from numpy.typing import ArrayLike

from discostorm import _checks, notation as nt
from discostorm._arguments import as_fleet, reject_symbols
from discostorm._numeric import Polynomial, Value
from discostorm.fleet import SWARM, Count, Fleet, symbolic_group
from discostorm.messages import PAPER_WINDOW, Protocol
from discostorm.model import sum_over_units, total_of, unit_costs
from discostorm.wifi import PAPER, Model, Wifi


def saturation_hosts(
    protocol: Protocol,
    processes: ArrayLike | None = None,
    endpoints: ArrayLike | None = None,
    wifi: Wifi = PAPER,
    limit: ArrayLike = 1.0,
    fleet: Fleet | None = None,
    group: int | str = 0,
    window: ArrayLike = PAPER_WINDOW,
) -> Value:
    """Return the number of like hosts at which utilization reaches a limit.

    The largest number that stays below the limit is one less than this, rounded up.

    Parameters
    ----------
    protocol : Protocol
        One of `PROTOCOLS`, such as `DDS` or `ZENOH`, or a table of your own.
    processes : array_like
        Processes on each host [1], from 1 to 1e9.
    endpoints : array_like
        Endpoints of each process [1], from 0 to 1e9.
    wifi : Wifi, optional
        The channel; the paper's if left out.
    limit : array_like, optional
        Utilization to reach [1], at least that with a single such host and at most 1e100.
    fleet : Fleet, optional
        In place of `processes` and `endpoints`: a fleet of which one group grows beside the
        others, such as robots beside an operator's laptop.
    group : int or str, optional
        The group of the fleet whose hosts are counted, by its place from 0 on [1] or its name; the
        first if left out. How many hosts it has does not matter.
    window : array_like, optional
        The seconds over which utilization is averaged [s], at least 1e-9; the paper's one if left
        out, infinity for the steady state.

    Returns
    -------
    float or ndarray
        Hosts [1], a real number of at least 1; infinity where nothing is repeated and the
        window is infinite, as with `DDS` and `ZENOH`: their steady state sends nothing, and any
        number of hosts fits it.

    Raises
    ------
    ValueError
        If an argument is NaN, infinite or out of range, the shapes do not broadcast, the fleet
        has no such group, or nothing that is sent grows with its hosts.
    TypeError
        If an argument is not made of real numbers, or `protocol`, `wifi` or `fleet` is not one.

    References
    ----------
    Paper, Sec. IV-C. Utilization is a polynomial of the hosts, whose powers come from those of the
    units' counts. `saturation` is its root in symbols; where messages grow faster than the square
    of the hosts the root is found by bisection.

    Examples
    --------
    >>> import discostorm as ds
    >>> round(ds.saturation_hosts(ds.DDS, processes=2, endpoints=10), 4)
    7.1554

    How many of them beside a laptop that runs one process of 90 endpoints:

    >>> fleet = ds.Fleet((ds.HostGroup(1, 2, 10), ds.HostGroup(1, 1, 90)))
    >>> round(ds.saturation_hosts(ds.DDS, fleet=fleet), 4)
    5.3365
    """
    members, index = _growing(processes, endpoints, fleet, group)
    costs = unit_costs(protocol, wifi, window, by_hop=members.has_wired)
    single = total_of(costs, _with_hosts(members, index, 1), window)
    most = _checks.numbers("limit", limit, 0, _checks.MOST_UTILIZATION, above=True)
    arrays = members.arrays() if fleet else {"processes": processes, "endpoints": endpoints}
    shape = _checks.shape(**arrays, window=window, limit=most)
    short = np.less(most, single)
    if short.any():
        low, needed = _checks.first_where(short, most, single)
        raise ValueError(
            f"limit must be at least the utilization of a single host"
            f"{' beside the fleet' if len(members.groups) > 1 else ''} with {protocol.name}, "
            f"{needed!r}; got {low!r}"
        )
    total = sum_over_units(costs, _with_hosts(members, index, Polynomial((1.0, 1.0))))
    if not isinstance(total, Polynomial):
        raise ValueError(f"utilization must grow with hosts; that of {protocol.name} does not")
    hosts = 1 + _root(total.powers[1:], most - single)
    # At the least limit allowed, rounding could give a little less than one host, and a
    # channel that hosts do not fill would have any number.
    found = np.where(np.isnan(hosts), math.inf, np.maximum(hosts, 1.0))
    return np.array(np.broadcast_to(found, shape)) if shape else float(found)


def _growing(
    processes: ArrayLike | None, endpoints: ArrayLike | None, fleet: Fleet | None, group: int | str
) -> tuple[Fleet, int]:
    """Return the fleet of which a group grows, and the place of the group."""
    if fleet is None:
        members = Fleet.swarm(1, processes, endpoints)
        reject_symbols(members)
        return members, 0
    _checks.instance("fleet", fleet, Fleet)
    members = as_fleet(fleet, processes, endpoints)
    if isinstance(group, str):
        _checks.choice("group", group, members.names)
        return members, members.names.index(group)
    _checks.whole("group", group, 0, len(members.groups) - 1)
    return members, int(group)


def _with_hosts(fleet: Fleet, index: int, hosts: Count) -> Fleet:
    groups = list(fleet.groups)
    groups[index] = replace(groups[index], hosts=hosts)
    return replace(fleet, groups=tuple(groups))


def _root(factors: tuple[Value, ...], rest: Value) -> Value:
    """Return where a polynomial with these factors of its powers, from the first on, is `rest`."""
    first, second, *higher = (*factors, 0.0)
    with np.errstate(all="ignore"):
        if not any(np.any(factor) for factor in higher):
            return np.divide(2 * rest, first + np.sqrt(first**2 + 4 * second * rest))
        low, high = np.zeros(np.shape(rest)), np.ones(np.shape(rest))
        while (short := _polynomial(factors, high) < rest).any():
            high = np.where(short, 2 * high, high)
        for _ in range(_HALVINGS):
            middle = (low + high) / 2
            over = _polynomial(factors, middle) >= rest
            low, high = np.where(over, low, middle), np.where(over, middle, high)
    return high


def _polynomial(factors: tuple[Value, ...], x: Value) -> Any:
    return sum(factor * x**power for power, factor in enumerate(factors, start=1))


#: Until what is left of the bracket is less than the last digit of a float64.
_HALVINGS = 56
_GROWS = "utilization must grow with hosts, at most as their square to be solved in symbols"


def solve_hosts(utilization: sp.Expr) -> sp.Expr:
    r"""Return the N_H at which a utilization, given in symbols, reaches U_limit.

    Utilization is quadratic in :math:`x = N_H - 1`: :math:`a x^2 + b x + c = U_{limit}`,
    with a, b and c at least 0. Its root is written as

    .. math:: N_H = 1 + \frac{2 (U_{limit} - c)}{b + \sqrt{b^2 + 4 a (U_{limit} - c)}}

    which is the usual formula, in the form that does not cancel in floating point.

    Raises
    ------
    ValueError
        If the utilization grows faster than that, or not at all.
    """
    return _solved(*_powers(utilization))


def _powers(utilization: sp.Expr) -> tuple[sp.Expr, ...]:
    """Return what multiplies the square, first and zeroth power of N_H - 1."""
    more = sp.Symbol("x", positive=True)
    polynomial = utilization.subs(nt.N_H, 1 + more)
    if polynomial.diff(more, 3) != 0:
        raise ValueError(_GROWS)
    # By derivatives: to collect the powers would expand a sum over all pairs of groups.
    return tuple(
        polynomial.diff(more, degree).subs(more, 0) / sp.factorial(degree) for degree in (2, 1, 0)
    )


def _solved(a: sp.Expr, b: sp.Expr, c: sp.Expr) -> sp.Expr:
    """Return the N_H of `solve_hosts` for these factors of the powers of N_H - 1."""
    if a == 0 and b == 0:
        raise ValueError(_GROWS)
    rest = nt.U_LIMIT - c
    return 1 + 2 * rest / (b + sp.sqrt(b**2 + 4 * a * rest))


@cache
def saturation(
    protocol: Protocol,
    model: Model = "linear",
    groups_beside: int = 0,
    window: sp.Expr | float = PAPER_WINDOW,
) -> sp.Expr:
    """Return the N_H at which utilization reaches U_limit, in symbols; see `solve_hosts`.

    With `groups_beside`, N_H like hosts share the channel with that many groups of
    other hosts (N_H1, N_P1, N_E1 and so on).
    """
    beside = (symbolic_group(index) for index in range(1, groups_beside + 1))
    fleet = Fleet((*SWARM.groups, *beside))
    # Solved with a symbol for what each unit costs, which is many terms.
    costs = {unit: protocol.cost(unit, None, model, window) for unit in protocol.units()}
    some = {sp.Dummy(positive=True): unit for unit, cost in costs.items() if cost != 0}
    total = sp.Add(*(symbol * unit.count(fleet) for symbol, unit in some.items()))
    known = {symbol: costs[unit] for symbol, unit in some.items()}
    return _solved(*(power.xreplace(known) for power in _powers(total)))
