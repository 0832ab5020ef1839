"""The model: utilization is the sum over units of what each costs times how many there are.

`unit_costs` says what each unit adds to the airtime (paper, equation 11), a fleet how many of it
there are (equations 1 to 10), and `utilization` is the sum of their products (equation 12).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import cache, lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np
import sympy as sp
from numpy.typing import ArrayLike

from discostorm import _checks, notation as nt
from discostorm._arguments import as_fleet, reject_symbols
from discostorm._numeric import (
    Value,
    compiled,
    evaluate,
    evaluate_each,
    shortened,
)
from discostorm.fleet import (
    COUNTS,
    SWARM,
    Fleet,
)
from discostorm.messages import (
    DATA,
    HOPS,
    PAPER_WINDOW,
    Hop,
    Message,
    OnAir,
    Protocol,
    Schedule,
    Unit,
    checked_window,
    data_table,
    hop_airtime,
)
from discostorm.wifi import PAPER, Cast, Wifi

if TYPE_CHECKING:
    import pandas as pd

#: What costs are counted by: units, or those of them that take the air on a hop.
Counted = Unit | OnAir

#: Length of a frame [B].
_OCTETS = sp.Symbol("S", positive=True)


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
        One of the protocol's phases; all of them if left out. "data" is none of them: it is what
        the fleet sends besides (`HostGroup.data`), framed as the protocol's product does.
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

    Three robots that send each other their scans:

    >>> robots = ds.HostGroup(3, 2, 10, data=(ds.flows.flow("scan", "all others"),))
    >>> round(ds.utilization(ds.DDS, ds.Fleet((robots,)), phase="data"), 4)
    0.0274
    """
    fleet = as_fleet(hosts, processes, endpoints)
    if phase == DATA:
        table = data_table(protocol, fleet)
        if table is None:
            shape = _checks.shape(**fleet.arrays(), window=window)
            return np.zeros(shape) if shape else 0.0
        return total_of(unit_costs(table, wifi, window, None, fleet.has_wired), fleet, window)
    return total_of(unit_costs(protocol, wifi, window, phase, fleet.has_wired), fleet, window)


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
    >>> from discostorm.model import burst
    >>> burst(ds.DDS, 7, 2, 10) == ds.utilization(ds.DDS, 7, 2, 10)
    True
    >>> burst(ds.DDS, ds.Fleet.swarm(7, 2, 10)) == burst(ds.DDS, 7, 2, 10)
    True
    """
    _check(protocol, wifi)
    fleet = as_fleet(hosts, processes, endpoints)
    costs = _costs(protocol, wifi, None, lambda schedule: schedule.extra, fleet.has_wired)
    return total_of(costs, fleet)


def total_of(
    costs: Mapping[Counted, Value], fleet: Fleet, window: ArrayLike = PAPER_WINDOW
) -> Value:
    """Return the sum over units of cost times count, in the shape of the fleet and the window."""
    shape = _checks.shape(**fleet.arrays(), window=window)
    unlike = len(fleet.groups) > 1 or fleet.has_wired
    total = sum_over_units(costs, fleet) if unlike else _of_swarm(costs, fleet)
    if not shape:
        return float(total)
    return total if np.shape(total) == shape else np.array(np.broadcast_to(total, shape))


def sum_over_units(costs: Mapping[Counted, Value], fleet: Fleet) -> Any:
    """Return the sum over units of cost times count: a number, array, or `Polynomial`."""
    with np.errstate(under="ignore"):
        return sum(cost * unit.count(fleet) for unit, cost in costs.items())


def _of_swarm(costs: Mapping[Counted, Value], fleet: Fleet) -> Any:
    """Return the same sum for one group, by a function in which nothing is computed twice."""
    (group,) = fleet.groups
    function = _swarm_function(tuple(costs), fleet.matching, group.shared != 0)
    with np.errstate(under="ignore"):
        return function(*group.counts(), group.shared, *costs.values())


@cache
def _swarm_function(
    units: tuple[Counted, ...], matching: float, shares: bool
) -> Callable[..., Any]:
    """Return a function of the counts of a swarm, what is shared and the cost of each unit."""
    shared = sp.Symbol("N_S", nonnegative=True)
    swarm = Fleet((replace(SWARM.groups[0], shared=shared if shares else 0.0),), matching)
    costs = sp.symbols(f"c:{len(units)}", positive=True)
    total = sp.Add(*(cost * unit.count(swarm) for cost, unit in zip(costs, units, strict=True)))
    return compiled((*swarm.counts(), shared, *costs), shortened(total))


def unit_costs(
    protocol: Protocol,
    wifi: Wifi = PAPER,
    window: ArrayLike = PAPER_WINDOW,
    phase: str | None = None,
    by_hop: bool = False,
) -> dict[Counted, Value]:
    """Return what each unit of a protocol adds to an average second of the window [s].

    Those of each hop apart, ``by_hop``, for fleets with wired hosts.
    """
    _check(protocol, wifi)
    protocol.of_phase(phase)  # raises if there is none
    seconds = checked_window(window)
    if isinstance(seconds, float):
        return dict(_mean_costs(protocol, wifi, phase, seconds, by_hop))
    return _costs(protocol, wifi, phase, lambda schedule: schedule.mean(seconds), by_hop)


@lru_cache(maxsize=4096)
def _mean_costs(
    protocol: Protocol, wifi: Wifi, phase: str | None, window: float, by_hop: bool
) -> dict[Counted, Value]:
    return _costs(protocol, wifi, phase, lambda schedule: schedule.mean(window), by_hop)


def _costs(
    protocol: Protocol,
    wifi: Wifi,
    phase: str | None,
    times: Callable[[Schedule], Value],
    by_hop: bool = False,
) -> dict[Counted, Value]:
    """Return the airtime of what is sent for each unit, each message so many times [s]."""
    costs: dict[Counted, Value] = {} if by_hop else dict.fromkeys(protocol.units(phase), 0.0)
    for message in protocol.of_phase(phase):
        airtime = sum(_hop_seconds(message, hop, wifi) for hop in message.hops)
        if airtime == math.inf and wifi.aggregation is not None:
            raise ValueError(
                f"most_bytes of the channel's aggregation must hold every frame of "
                f"{protocol.name}; got {wifi.aggregation.most_bytes!r}"
            )
        sent = message.per_unit * times(message.schedule)
        if not by_hop:
            costs[message.unit] = costs[message.unit] + sent * airtime
            continue
        for hop in message.hops:
            counted = message.on_air(hop)
            costs[counted] = costs.get(counted, 0.0) + sent * _hop_seconds(message, hop, wifi)
    return costs


def _check(protocol: Protocol, wifi: Wifi) -> None:
    _checks.instance("protocol", protocol, Protocol)
    _checks.instance("wifi", wifi, Wifi)


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
    symbolic: Mapping[Any, sp.Expr] = (
        protocol.costs_by_hop(phase)
        if fleet.has_wired
        else {unit: protocol.cost(unit, phase) for unit in protocol.units(phase)}
    )
    costs = evaluate_each(list(symbolic.values()), at)
    return total_of(dict(zip(symbolic, costs, strict=True)), fleet)


def without_each(
    protocol: Protocol, fleet: Fleet, wifi: Wifi = PAPER, window: float = PAPER_WINDOW
) -> list[float]:
    """Return the utilization of a fleet of numbers without each of its groups in turn [1]."""
    costs = unit_costs(protocol, wifi, window, by_hop=fleet.has_wired)
    rests = []
    for index in range(len(fleet.groups)):
        groups = fleet.groups[:index] + fleet.groups[index + 1 :]
        rests.append(float(total_of(costs, replace(fleet, groups=groups))) if groups else 0.0)
    return rests


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
        If an argument is NaN, infinite or out of range, or a message of hosts or processes that
        are no whole numbers would be sent less than never.
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
    rows = []
    for message in protocol.messages:
        count = float(message.load(fleet)) + 0.0  # also where it is -0.0
        if count < 0:
            counts = "; ".join(f"{g.hosts:g} and {g.processes:g}" for g in fleet.groups)
            raise ValueError(
                f"hosts and processes must be whole numbers here, as of {message.name} there would "
                f"be {count:.4g} messages ({message.unit.name}); got {counts}"
            )
        load = float(count * message.schedule.mean(window))
        up, down = (load * (hop in message.hops) for hop in HOPS)
        if fleet.has_wired:
            sent = message.per_unit * message.schedule.mean(window)
            up, down = (
                float(sent * message.on_air(hop).count(fleet)) if hop in message.hops else 0.0
                for hop in HOPS
            )
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
