"""Utilization, its breakdown by message, and saturation: symbolic, then numeric."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import cache, lru_cache, partial
from typing import TYPE_CHECKING, Any

import numpy as np
import sympy as sp
from numpy.typing import ArrayLike

from discostorm import _checks, notation as nt
from discostorm._numeric import (
    Polynomial,
    Program,
    Value,
    coefficients,
    compiled,
    evaluate,
    evaluate_each,
    in_blocks,
    program,
)
from discostorm.fleet import (
    COUNTS,
    LEAST,
    SWARM,
    Fleet,
    HostGroup,
    as_fleet,
    reject_symbols,
    symbolic_group,
)
from discostorm.messages import (
    HOPS,
    PAPER_WINDOW,
    Hop,
    Message,
    Protocol,
    Unit,
    hop_airtime,
)
from discostorm.wifi import PAPER, Cast, Model, Wifi

if TYPE_CHECKING:
    import pandas as pd


def _seconds(window: ArrayLike) -> Value:
    """Return the window [s] as float64, of which infinity is the longest."""
    return _checks.numbers("window", window, _checks.LEAST_SECONDS, endless=True)


#: What is counted, and the airtime that each adds to an average second [s].
Costs = dict[Unit, Value]


def _costs(protocol: Protocol, phase: str | None, wifi: Wifi, window: Value) -> Costs:
    """Return what each unit costs: all that utilization takes from the symbols."""
    units = protocol.units(phase)
    if isinstance(window, float):
        return dict(zip(units, _prices(protocol, phase, wifi, window), strict=True))
    values = protocol.values() | wifi.values() | {nt.W: window}
    return {unit: evaluate(protocol.cost(unit, phase, wifi.model, nt.W), values) for unit in units}


#: Length of a frame [B].
_OCTETS = sp.Symbol("S", positive=True)


def _hop_seconds(message: Message, hop: Hop, wifi: Wifi) -> float:
    """Return the airtime of a message's part of a frame on a hop [s]."""
    once = _frame_seconds(hop, message.cast, message.frames > 0, message.frame_bytes, wifi)
    return float(message.frames or 1.0) * once


@lru_cache(maxsize=4096)
def _frame_seconds(hop: Hop, cast: Cast, framed: bool, octets: float, wifi: Wifi) -> float:
    """Return the airtime of a frame, or of octets inside of another frame, on a hop [s].

    The function of the length is the same for all messages of a kind, and so compiled once.
    """
    expression = hop_airtime(hop, cast, framed, _OCTETS, wifi.model)
    with np.errstate(divide="ignore"):
        return float(evaluate(expression, wifi.values() | {_OCTETS: octets}))


@lru_cache(maxsize=4096)
def _prices(
    protocol: Protocol, phase: str | None, wifi: Wifi, window: float | None
) -> tuple[float, ...]:
    """Return what each unit adds to an average second of the window, or to the burst [s]."""
    prices = dict.fromkeys(protocol.units(phase), 0.0)
    for message in protocol.of_phase(phase):
        schedule = message.schedule
        times = schedule.extra if window is None else schedule.mean(window)
        once = sum(_hop_seconds(message, hop, wifi) for hop in message.hops)
        prices[message.unit] += message.per_unit * times * once
    if wifi.aggregation is not None and math.inf in prices.values():
        raise ValueError(
            f"most_bytes of the channel's aggregation must hold every frame of {protocol.name}; "
            f"got {wifi.aggregation.most_bytes!r}"
        )
    return tuple(prices.values())


def unit_costs(
    protocol: Protocol, wifi: Wifi = PAPER, window: float = PAPER_WINDOW
) -> dict[Unit, float]:
    """Return what each unit of a protocol adds to an average second of the window [s]."""
    return dict(zip(protocol.units(), _prices(protocol, None, wifi, window), strict=True))


def _in_symbols(units: tuple[Unit, ...], matching: float) -> tuple[tuple[sp.Symbol, ...], sp.Expr]:
    """Return a symbol for the cost of each unit, and with them the utilization of a swarm."""
    swarm = replace(SWARM, matching=matching)
    costs = sp.symbols(f"c:{len(units)}", positive=True)
    return costs, sp.Add(
        *(cost * unit.count(swarm) for unit, cost in zip(units, costs, strict=True))
    )


@cache
def _swarm(units: tuple[Unit, ...], matching: float) -> Program:
    """Return utilization of a swarm as a function of its counts, then of the cost of each unit."""
    costs, total = _in_symbols(units, matching)
    # What the units have in common is multiplied with once.
    shared, (total,) = sp.cse([sp.factor_terms(total)])
    for symbol, part in reversed(shared):
        total = sp.collect(total, symbol).subs(symbol, part)
    return program((*SWARM.counts(), *costs), total)


@cache
def _full_swarm(units: tuple[Unit, ...], matching: float) -> Callable[..., Value]:
    """Return the N_H of `saturation` as a function of N_P, N_E, U_limit and these costs."""
    costs, total = _in_symbols(units, matching)
    return compiled((nt.N_P, nt.N_E, nt.U_LIMIT, *costs), solve_hosts(total))


def _added_up(costs: Costs, fleet: Fleet) -> Any:
    """Return the utilization of a fleet: its units are counted, whatever its counts are."""
    return sum(cost * unit.count(fleet) for unit, cost in costs.items())


def _of_fleet(costs: Costs, fleet: Fleet, shape: tuple[int, ...]) -> Value:
    if len(fleet.groups) == 1 and not _shared_counts(costs, fleet.groups[0]):
        counts = dict(zip(COUNTS, fleet.counts(), strict=True))
        return _of_swarms(costs, counts, shape, fleet.matching)
    with np.errstate(under="ignore"):
        total: Value = _added_up(costs, fleet)
    return np.array(np.broadcast_to(total, shape)) if shape else total


def _shared_counts(costs: Costs, group: HostGroup) -> bool:
    """Return whether it matters to these units that endpoints of the group match everywhere."""
    return bool(group.shared) and any(map(_of_names, costs))


@cache
def _of_names(unit: Unit) -> bool:
    """Return whether how many there are of a unit depends on what matches."""
    swarm = Fleet((replace(SWARM.groups[0], shared=sp.Symbol("N_S")),))
    return bool(unit.count(swarm) != unit.count(SWARM))


def depends_on_names(protocol: Protocol) -> bool:
    """Return whether what a protocol sends depends on which endpoints match."""
    return any(map(_of_names, protocol.units()))


def _of_swarms(
    costs: Costs, arguments: dict[str, Any], shape: tuple[int, ...], matching: float = 0.0
) -> Value:
    """Return the utilization of swarms, whose counts are checked where they are needed.

    Arrays are read once and not copied, as a fleet has to.
    """
    allowed = {name: (least, _checks.MOST) for name, least in LEAST.items()}
    given = {
        name: _checks.real(name, value, _checks.wanted(*allowed[name]))
        if np.ndim(value)
        else _checks.numbers(name, value, *allowed[name])
        for name, value in arguments.items()
    }
    swarm = _swarm(tuple(costs), matching)
    if not shape:
        return swarm.of_numbers(*map(float, (*given.values(), *costs.values())))
    spare: list[Any] = []

    def block(out: Any, hosts: Any, processes: Any, endpoints: Any, *prices: Value) -> None:
        checked = (
            count if isinstance(count, float) else _checks.within(name, count, *allowed[name])
            for name, count in zip(given, (hosts, processes, endpoints), strict=True)
        )
        swarm.into(out, spare, *checked, *prices)

    return in_blocks(block, (*given.values(), *costs.values()), shape)


def utilization(
    protocol: Protocol,
    hosts: ArrayLike | Fleet,
    processes: ArrayLike | None = None,
    endpoints: ArrayLike | None = None,
    wifi: Wifi = PAPER,
    phase: str | None = None,
    window: ArrayLike = PAPER_WINDOW,
) -> Value:
    r"""Return the fraction of channel time that discovery takes of the first seconds.

    .. math:: U = \frac{1}{W} \sum_\phi \left[\mathcal{T}(L^{up}_\phi, R^{up}_\phi)
        + \mathcal{T}(L^{down}_\phi, R^{down}_\phi)\right]

    The window W is the paper's second if left out. What is repeated with a period counts
    with its rate, so that for a window between two of its instants it is an upper bound.

    Parameters
    ----------
    protocol : Protocol
        One of `PROTOCOLS`, such as `DDS` or `ZENOH`, or a table of your own.
    hosts : array_like or Fleet
        Hosts in the network [1], from 1 to 1e9; or a `Fleet` of unlike hosts, in which
        case `processes` and `endpoints` are left out.
    processes : array_like
        Processes on each host [1], from 1 to 1e9.
    endpoints : array_like
        Endpoints of each process [1], from 0 to 1e9.
    wifi : Wifi, optional
        The channel; the paper's if left out.
    phase : str, optional
        One of the protocol's phases; all of them if left out.
    window : array_like, optional
        The seconds that are averaged [s], at least 1e-9; infinity for the steady state.

    Returns
    -------
    float or ndarray
        Utilization [1]; 1 is a saturated channel, and larger values are seconds of
        airtime. Of the shape the arguments broadcast to; a float for scalars.

    Raises
    ------
    ValueError
        If an argument is NaN, infinite or out of range, the shapes do not broadcast, or
        the protocol has no such phase.
    TypeError
        If an argument is not made of real numbers, or `protocol` or `wifi` is not one.

    References
    ----------
    Paper, equations (11) and (12).

    Examples
    --------
    >>> import discostorm as ds
    >>> round(ds.utilization(ds.DDS, hosts=7, processes=2, endpoints=10), 5)
    0.95391
    >>> ds.utilization(ds.ZENOH, [7, 8], 2, 10).round(5)
    array([0.83057, 1.10632])

    With the periods of Fast DDS, averaged over its lease of 20 seconds, and in the long run:

    >>> fast_dds = ds.PROTOCOLS["DDS, periods of Fast DDS"]
    >>> ds.utilization(fast_dds, 22, 2, 10, window=[20, float("inf")]).round(3)
    array([1.011, 0.263])
    """
    _checks.instance("protocol", protocol, Protocol)
    _checks.instance("wifi", wifi, Wifi)
    protocol.of_phase(phase)  # raises if there is none
    seconds = _seconds(window)
    costs = _costs(protocol, phase, wifi, seconds)
    arguments = {"hosts": hosts, "processes": processes, "endpoints": endpoints}
    if all(isinstance(value, (np.ndarray, float, int)) for value in arguments.values()):
        return _of_swarms(costs, arguments, _checks.shape(**arguments, window=seconds))
    fleet = as_fleet(hosts, processes, endpoints)
    return _of_fleet(costs, fleet, _checks.shape(**fleet.arrays(), window=seconds))


def by_symbol(
    argument: str, given: Mapping[Any, Any], known: Mapping[sp.Symbol, object]
) -> dict[sp.Symbol, Any]:
    """Return what is given for symbols, or their names, if all of these are known."""
    _checks.instance(argument, given, Mapping)
    symbols = {symbol.name: symbol for symbol in known}
    for name in given:
        if str(name) not in symbols:
            raise ValueError(f"{argument} must name {', '.join(symbols)}; got {str(name)!r}")
    return {symbols[str(name)]: value for name, value in given.items()}


def utilization_at(
    values: Mapping[Any, float], protocol: Protocol, fleet: Fleet, phase: str | None = None
) -> Value:
    """Return the utilization of a fleet with other values of the parameters than the paper's.

    Parameters
    ----------
    values : mapping
        Symbol or its name to value, in bytes, seconds or bit/s; the paper's value for the
        parameters left out.
    protocol : Protocol
        `DDS`, `ZENOH`, or a table of your own.
    fleet : Fleet
        Its counts are numbers or arrays.
    phase : str, optional
        One of the protocol's phases; all of them if left out.

    Returns
    -------
    float or ndarray
        Utilization [1], of the shape to which the fleet's counts broadcast.

    Raises
    ------
    ValueError
        If a name is unknown, a value is out of range, or the protocol has no such phase.
    TypeError
        If an argument is not of its kind, or a value not one real number.
    """
    _checks.instance("protocol", protocol, Protocol)
    _checks.instance("fleet", fleet, Fleet)
    reject_symbols(fleet)
    usual = protocol.values() | PAPER.values()
    at = usual | {
        symbol: _checks.number(symbol.name, value, 0, above=symbol in (nt.R_UNI, nt.R_MULTI))
        for symbol, value in by_symbol("values", values, usual).items()
    }
    units = protocol.units(phase)
    costs = evaluate_each([protocol.cost(unit, phase) for unit in units], at)
    return _of_fleet(dict(zip(units, costs, strict=True)), fleet, _checks.shape(**fleet.arrays()))


def burst(
    protocol: Protocol,
    hosts: ArrayLike | Fleet,
    processes: ArrayLike | None = None,
    endpoints: ArrayLike | None = None,
    wifi: Wifi = PAPER,
) -> Value:
    """Return the airtime of what the start sends beyond the steady state.

    Parameters
    ----------
    protocol, hosts, processes, endpoints, wifi
        As for `utilization`: a swarm, or a `Fleet` of unlike hosts.

    Returns
    -------
    float or ndarray
        Airtime [s]; with the paper's tables the utilization of their one second.

    Raises
    ------
    ValueError
        If an argument is NaN, infinite or out of range, or the shapes do not broadcast.
    TypeError
        If an argument is not made of real numbers, or `protocol` or `wifi` is not one.

    References
    ----------
    Paper, equations (11) and (12); `Protocol.burst`.

    Examples
    --------
    >>> import discostorm as ds
    >>> from discostorm.scalability import burst
    >>> burst(ds.DDS, 7, 2, 10) == ds.utilization(ds.DDS, 7, 2, 10)
    True
    >>> burst(ds.DDS, ds.Fleet.swarm(7, 2, 10)) == burst(ds.DDS, 7, 2, 10)
    True
    """
    _checks.instance("protocol", protocol, Protocol)
    _checks.instance("wifi", wifi, Wifi)
    fleet = as_fleet(hosts, processes, endpoints)
    costs: Costs = dict(zip(protocol.units(), _prices(protocol, None, wifi, None), strict=True))
    return _of_fleet(costs, fleet, _checks.shape(**fleet.arrays()))


def solve_hosts(utilization: sp.Expr) -> sp.Expr:
    r"""Return the N_H at which a utilization, given in symbols, reaches U_limit.

    Utilization is quadratic in :math:`x = N_H - 1`: :math:`a x^2 + b x + c = U_{limit}`,
    with a, b and c at least 0. Its root is written as

    .. math:: N_H = 1 + \frac{2 (U_{limit} - c)}{b + \sqrt{b^2 + 4 a (U_{limit} - c)}}

    which is the usual formula, in the form that does not cancel in floating point. Where
    messages are sent because of a third process there is :math:`d x^3` as well, and the cubic
    is solved for :math:`1 / x`, of which all terms have one sign:

    .. math:: x = \frac{r}{b / 3 + 2 \sqrt{p} \cos(\arccos(k) / 3)}, \quad
        p = \frac{a r}{3} + \frac{b^2}{9}, \quad
        k = \frac{b^3 / 27 + a b r / 6 + d r^2 / 2}{p^{3/2}}, \quad r = U_{limit} - c

    with the hyperbolic functions where k is above 1.

    Raises
    ------
    ValueError
        If the utilization grows faster than that, or not at all.
    """
    return _solved(*_powers(utilization))


def _powers(utilization: sp.Expr) -> tuple[sp.Expr, ...]:
    """Return what multiplies the cube, square, first and zeroth power of N_H - 1."""
    more = sp.Symbol("x", positive=True)
    polynomial = utilization.subs(nt.N_H, 1 + more)
    if polynomial.diff(more, 4) != 0:
        raise ValueError(_GROWS)
    # By derivatives: to collect the powers would expand a sum over all pairs of groups.
    return tuple(
        polynomial.diff(more, degree).subs(more, 0) / sp.factorial(degree)
        for degree in (3, 2, 1, 0)
    )


def _solved(third: sp.Expr, a: sp.Expr, b: sp.Expr, c: sp.Expr) -> sp.Expr:
    """Return the N_H of `solve_hosts` for these factors of the powers of N_H - 1."""
    if third == 0 and a == 0 and b == 0:
        raise ValueError(_GROWS)
    if third == 0:
        return _root(a, b, nt.U_LIMIT - c, sp.sqrt)
    return _cubic_root(third, a, b, nt.U_LIMIT - c, sp)


_GROWS = "utilization must grow with hosts, at most as their cube"


def _root(a: Any, b: Any, rest: Any, sqrt: Callable[[Any], Any]) -> Any:
    """Return the hosts that take the ``rest`` of the channel; see `solve_hosts`."""
    return 1 + 2 * rest / (b + sqrt(b**2 + 4 * a * rest))


def _cubic_root(third: Any, a: Any, b: Any, rest: Any, of: Any) -> Any:
    """Return the hosts that take the ``rest``, of which a part grows with their cube.

    See `solve_hosts`; ``of`` is the module whose functions to take, sympy or NumPy.
    """
    least, most, arccos, arccosh = (
        (np.minimum, np.maximum, np.arccos, np.arccosh)
        if of is np
        # Which of two long expressions is the larger one is not to be proven.
        else (
            partial(sp.Min, evaluate=False),
            partial(sp.Max, evaluate=False),
            sp.acos,
            sp.acosh,
        )
    )
    p = a * rest / 3 + b**2 / 9
    k = (b**3 / 27 + a * b * rest / 6 + third * rest**2 / 2) / (p * of.sqrt(p))
    # One of the two factors is 1.
    part = of.cos(arccos(least(k, 1)) / 3) * of.cosh(arccosh(most(k, 1)) / 3)
    return 1 + rest / (b / 3 + 2 * of.sqrt(p) * part)


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


def saturation_hosts(
    protocol: Protocol,
    processes: ArrayLike,
    endpoints: ArrayLike,
    wifi: Wifi = PAPER,
    limit: ArrayLike = 1.0,
    beside: Fleet | None = None,
    window: ArrayLike = PAPER_WINDOW,
    shared: float = 0.0,
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
        Utilization to reach [1], at least that of a single such host and at most 1e100.
    beside : Fleet, optional
        Other hosts that share the channel, such as an operator's laptop; they are not
        counted in the result. None if left out.
    window : array_like, optional
        The seconds over which utilization is averaged [s], at least 1e-9; the paper's one if left
        out, infinity for the steady state.
    shared : float, optional
        Endpoints of each process that match one in every other process [1]; see `HostGroup`. How
        many of the others match is that of the fleet beside.

    Returns
    -------
    float or ndarray
        Hosts [1], a real number of at least 1; infinity where nothing is repeated and the
        window is infinite, as with `DDS` and `ZENOH`: their steady state sends nothing, and any
        number of hosts fits it.

    Raises
    ------
    ValueError
        If an argument is NaN, infinite or out of range, or the shapes do not broadcast.
    TypeError
        If an argument is not made of real numbers, or `protocol` or `wifi` is not one.

    References
    ----------
    Paper, Sec. IV-C; the closed form is `saturation`. Without one, where messages grow faster than
    the cube of the hosts, the root is found by Newton's method.

    Examples
    --------
    >>> import discostorm as ds
    >>> round(ds.saturation_hosts(ds.DDS, processes=2, endpoints=10), 4)
    7.1554

    How many of them beside a laptop that runs one process of 90 endpoints:

    >>> laptop = ds.Fleet.swarm(hosts=1, processes=1, endpoints=90)
    >>> round(ds.saturation_hosts(ds.DDS, processes=2, endpoints=10, beside=laptop), 4)
    5.3365
    """
    _checks.instance("protocol", protocol, Protocol)
    _checks.instance("wifi", wifi, Wifi)
    host = HostGroup(1, processes, endpoints, shared=shared)
    if beside is not None:
        _checks.instance("beside", beside, Fleet)
    others = beside.groups if beside else ()
    fleet = Fleet((host, *others), beside.matching if beside else 0.0)
    reject_symbols(fleet)
    seconds = _seconds(window)
    single = utilization(protocol, fleet, wifi=wifi, window=seconds)
    most = _checks.numbers("limit", limit, 0, _checks.MOST_UTILIZATION, above=True)
    shapes = {"processes": processes, "endpoints": endpoints, "window": window}
    shape = _checks.shape(**(shapes if beside is None else {"utilization": single}), limit=most)
    short = np.less(most, single)
    if short.any():
        low, needed = _checks.first_where(short, most, single)
        raise ValueError(
            f"limit must be at least the utilization of a single host"
            f"{' beside the fleet' if beside else ''} with {protocol.name}, {needed!r}; got {low!r}"
        )
    costs = _costs(protocol, None, wifi, seconds)
    if beside is not None or _shared_counts(costs, host) or _steep(tuple(costs)):
        found = _hosts(lambda: _beside(costs, fleet, most - single))
    else:
        found = _hosts(lambda: _alone(costs, host, most, shape))
    return np.array(np.broadcast_to(found, shape)) if shape else float(found)


def hosts_of_group(
    protocol: Protocol, fleet: Fleet, index: int = 0, wifi: Wifi = PAPER, limit: float = 1.0
) -> float | None:
    """Return at how many hosts of one of its groups a fleet of numbers reaches a limit.

    None if one host of them is too many. The group keeps its place, which matters where a server
    is on a host of the first one, and the fleet what matches in it.
    """
    most = _checks.number("limit", limit, 0, _checks.MOST_UTILIZATION, above=True)
    groups = list(fleet.groups)
    groups[index] = replace(groups[index], hosts=1)
    fleet = replace(fleet, groups=tuple(groups))
    single = float(utilization(protocol, fleet, wifi=wifi))
    if single > most:
        return None
    (host, *others), costs = groups, _costs(protocol, None, wifi, PAPER_WINDOW)
    if others or fleet.matching or _shared_counts(costs, host):
        return float(_hosts(lambda: _beside(costs, fleet, most - single, index)))
    return float(saturation_hosts(protocol, host.processes, host.endpoints, wifi, limit=most))


def _hosts(found: Callable[[], Value]) -> Any:
    """Return how many hosts are found, at least one; infinity if they do not fill the channel."""
    try:
        with np.errstate(divide="ignore", invalid="ignore", under="ignore"):
            hosts = found()
    except ZeroDivisionError:
        hosts = math.inf
    # At the least limit allowed, rounding could give a little less than one host, and a
    # channel that hosts do not fill would have any number.
    return np.where(np.isnan(hosts), math.inf, np.maximum(hosts, 1.0))


def _alone(costs: Costs, host: HostGroup, most: Value, shape: tuple[int, ...]) -> Value:
    """Return how many such hosts use the channel up to a limit."""
    function = _full_swarm(tuple(costs), 0.0)
    values = (host.processes, host.endpoints, most, *costs.values())
    if not shape:
        return function(*values)

    def block(out: Any, *values: Value) -> None:
        out[...] = function(*values)

    return in_blocks(block, values, shape)


def _beside(costs: Costs, fleet: Fleet, rest: Value, index: int = 0) -> Value:
    """Return how many hosts like that of one group take the rest; see `solve_hosts`."""
    groups = list(fleet.groups)
    groups[index] = replace(groups[index], hosts=Polynomial((1.0, 1.0)))
    total = _added_up(costs, replace(fleet, groups=tuple(groups)))
    _, b, a, third, *faster = (*coefficients(total), 0.0, 0.0, 0.0)
    if any(map(np.any, faster)):
        found: Value = _by_newton((b, a, third, *faster), rest)
    elif np.any(third):
        found = _cubic_root(third, a, b, rest, np)
    else:
        found = _root(a, b, rest, np.sqrt)
    return found


@cache
def _steep(units: tuple[Unit, ...]) -> bool:
    """Return whether one of the units grows faster than the cube of the hosts."""
    swarm = Fleet((replace(HostGroup(1, 1, 1), hosts=Polynomial((1.0, 1.0))),))
    return any(any(coefficients(unit.count(swarm))[4:]) for unit in units)


def _by_newton(powers: tuple[Value, ...], rest: Value) -> Value:
    """Return the hosts that take the ``rest`` where that has no closed form worth its name.

    ``powers`` are the factors of the first, second and further powers of the further hosts. From a
    number that is too large, at which each power alone takes the rest at most, each step is down
    and none too far, as the sum bends upwards.
    """
    more: Any = np.inf
    for n, part in enumerate(powers, start=1):
        more = np.minimum(more, np.power(rest / np.asarray(part), 1 / n))
    for _ in range(_STEPS):
        taken, slope = -rest, 0.0
        for n, part in enumerate(powers, start=1):
            taken = taken + part * more**n
            slope = slope + n * part * more ** (n - 1)
        more = more - taken / slope
    hosts: Value = 1 + more
    return hosts


#: Four powers take four times the rest at most at first; then few steps reach the last digit.
_STEPS = 12


#: Groups that are left out at once: all at once would fill the memory for many.
_AT_ONCE = 256


def without_each(
    protocol: Protocol, fleet: Fleet, wifi: Wifi = PAPER, window: float = PAPER_WINDOW
) -> list[float]:
    """Return the utilization of a fleet of numbers without each of its groups in turn [1]."""
    costs = _costs(protocol, None, wifi, window)
    many = len(fleet.groups)
    parts = (range(start, min(start + _AT_ONCE, many)) for start in range(0, many, _AT_ONCE))
    return [rest for part in parts for rest in _added_up(costs, fleet.without(part)).tolist()]


def breakdown(
    protocol: Protocol,
    hosts: float | Fleet,
    processes: float | None = None,
    endpoints: float | None = None,
    wifi: Wifi = PAPER,
    window: float = PAPER_WINDOW,
) -> pd.DataFrame:
    """Return what each message of a protocol costs in an average second of the first ones.

    Parameters
    ----------
    protocol, hosts, processes, endpoints, wifi
        As for `utilization`, but one swarm or fleet: numbers, not arrays.
    window : float, optional
        The seconds that are averaged [s], at least 1e-9; the paper's one if left out, infinity
        for the steady state.

    Returns
    -------
    pandas.DataFrame
        One row a message, indexed by its name, with columns phase, cast,
        frame_bytes [B], uplink_messages [1], uplink_s [s] and downlink_s [s].

    Raises
    ------
    ValueError
        If an argument is NaN, infinite or out of range.
    TypeError
        If an argument is not one real number, or `protocol` or `wifi` is not one.

    References
    ----------
    Paper, Table II and equations (1) to (12).

    Examples
    --------
    >>> import discostorm as ds
    >>> table = ds.breakdown(ds.DDS, hosts=7, processes=2, endpoints=10)
    >>> table["uplink_messages"].to_dict()
    {'SPDP': 14.0, 'SEDP': 1680.0, 'Heartbeat': 336.0, 'ACKNACK': 336.0}
    """
    import pandas as pd  # here, as it would double the time of importing discostorm

    fleet = as_fleet(hosts, processes, endpoints)
    return pd.DataFrame(message_costs(protocol, fleet, wifi, window)).set_index("message")


def message_costs(
    protocol: Protocol, fleet: Fleet, wifi: Wifi = PAPER, window: float = PAPER_WINDOW
) -> list[dict[str, Any]]:
    """Return the rows of `breakdown`, from the name of the message on."""
    _checks.instance("protocol", protocol, Protocol)
    _checks.instance("wifi", wifi, Wifi)
    for group in fleet.groups:
        _checks.one_each(zip(COUNTS, group.counts(), strict=True))
    _checks.one_each([("window", window)])
    seconds = _seconds(window)
    rows = []
    for message in protocol.messages:
        load = float(message.load(fleet) * message.schedule.mean(seconds))
        up, down = (load * (hop in message.hops) for hop in HOPS)
        rows.append(
            {
                "message": message.name,
                "phase": message.phase,
                "cast": message.cast,
                "frame_bytes": message.frame_bytes,
                "uplink_messages": up,
                "uplink_s": up * _hop_seconds(message, "up", wifi),
                "downlink_s": down * _hop_seconds(message, "down", wifi),
            }
        )
    return rows
