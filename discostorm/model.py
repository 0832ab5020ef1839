"""The model: utilization is the sum over units of cost times count.

`unit_costs` is the airtime of each unit (paper, equation 11). A fleet counts the units (equations 1
to 10). `utilization` is the sum of the products (equation 12).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import cache, lru_cache, partial
from operator import attrgetter, methodcaller
from typing import TYPE_CHECKING, Any

import numpy as np
import sympy as sp
from numpy.typing import ArrayLike

from discostorm import _checks, notation as nt
from discostorm._numeric import Value, compile_function, evaluate, factor_out_common
from discostorm.fleet import COUNTS, PAPER_SWARM, Fleet, as_fleet, reject_symbols_and_cells
from discostorm.lookup import AnyProtocol, AnyWifi, as_protocol, as_wifi
from discostorm.messages import (
    DATA,
    HOPS,
    PAPER_WINDOW,
    Hop,
    Message,
    Protocol,
    Unit,
    checked_window,
    hop_airtime,
    user_data_protocol,
)
from discostorm.wifi import PAPER, Cast, Wifi

if TYPE_CHECKING:
    import pandas as pd

#: Length of a frame [B].
_FRAME_BYTES = sp.Symbol("S", positive=True)


def utilization(
    protocol: AnyProtocol,
    hosts: ArrayLike | Fleet,
    processes: ArrayLike | None = None,
    endpoints: ArrayLike | None = None,
    wifi: AnyWifi = PAPER,
    phase: str | None = None,
    window: ArrayLike = PAPER_WINDOW,
) -> Value:
    r"""Return the fraction of channel time that discovery needs in the first seconds.

    .. math:: U = \sum_u c_u(W) \, n_u

    The airtime :math:`c_u` that each unit adds to an average second of the window W, uplink and
    downlink, times the number :math:`n_u` of these units in the fleet. Periodic traffic counts
    with its rate, which is an upper bound for a window between two of its instants.

    Parameters
    ----------
    protocol : Protocol or str
        One of `PROTOCOLS`, its name such as "fastdds" or "rmw_zenoh_cpp", or a table of your own.
    hosts : array_like or Fleet
        Hosts in the network [1], from 1 to 1e9; or a `Fleet` of different hosts, in which
        case `processes` and `endpoints` are left out.
    processes : array_like
        Processes on each host [1], from 1 to 1e9.
    endpoints : array_like
        Endpoints of each process [1], from 0 to 1e9.
    wifi : Wifi, Radio or str, optional
        The channel, or a name such as "802.11ac 80 MHz"; the paper's if left out.
    phase : str, optional
        One of the protocol's phases; all of them if left out. "data" is not one of them: it is
        the fleet's user data (`HostGroup.data`), framed as the protocol's product does.
    window : array_like, optional
        Seconds to average [s], at least 1e-9; the paper's one if left out; infinity: steady state.

    Returns
    -------
    float or ndarray
        Utilization [1]; 1 is a saturated channel, and larger values are seconds of
        airtime. Of the shape the arguments broadcast to; a float for scalars.

    Examples
    --------
    >>> import discostorm as ds
    >>> ds.utilization(ds.ZENOH, [7, 8], 2, 10).round(5)
    array([0.83057, 1.10632])
    >>> round(ds.utilization("Fast DDS", 7, 2, 10, wifi="802.11ac 80 MHz"), 2)
    2.54
    """
    fleet = as_fleet(hosts, processes, endpoints)
    table: Protocol | None = as_protocol(protocol)
    if table and phase == DATA:
        table, phase = user_data_protocol(table, fleet), None
    channel, window_s = as_wifi(wifi), checked_window(window)
    costs = unit_costs(table, channel, window_s, phase, by_hop=fleet.has_wired) if table else {}
    return weighted_sum(costs, fleet, window_s)


def cell_utilization(
    protocol: AnyProtocol, fleet: Fleet, phase: str | None = None, window: ArrayLike = PAPER_WINDOW
) -> dict[str, Value]:
    """Return the `utilization` of each cell of a fleet with several access points.

    A message to another cell takes the uplink only, and a message from another cell takes the
    downlink only, as if the hosts there were wired. Each access point sends every multicast down
    once, even if the sender is the only host of the cell.

    Parameters
    ----------
    protocol
        As for `utilization`.
    fleet : Fleet
        With `Fleet.cells`, each of which names its channel.
    phase, window
        As for `utilization`.

    Returns
    -------
    dict of str to float or ndarray
        Utilization [1] by the name of the cell.

    Examples
    --------
    >>> import discostorm as ds
    >>> cells = (ds.Cell("hall", "802.11ac 80 MHz", channel=36), ds.Cell("yard", "802.11n 20 MHz"))
    >>> groups = (ds.HostGroup(6, 2, 10, cell="hall"), ds.HostGroup(2, 2, 10, cell="yard"))
    >>> needed = ds.cell_utilization("DDS", ds.Fleet(groups, cells=cells))
    >>> {name: round(share, 2) for name, share in needed.items()}
    {'hall': 0.94, 'yard': 0.34}
    """
    _checks.instance("fleet", fleet, Fleet)
    if not fleet.cells:
        raise ValueError("fleet must have cells (without any, use utilization); got none")
    return {
        cell.name: utilization(protocol, seen, wifi=cell.wifi, phase=phase, window=window)
        for cell, seen in fleet.by_cell().items()
    }


def burst(
    protocol: AnyProtocol,
    hosts: ArrayLike | Fleet,
    processes: ArrayLike | None = None,
    endpoints: ArrayLike | None = None,
    wifi: AnyWifi = PAPER,
) -> Value:
    """Return the airtime that startup needs beyond the steady state.

    Parameters
    ----------
    protocol, hosts, processes, endpoints, wifi
        As for `utilization`.

    Returns
    -------
    float or ndarray
        Airtime [s]. For the paper model, it equals the utilization: the window is one second.

    Examples
    --------
    >>> import discostorm as ds
    >>> ds.burst(ds.DDS, 7, 2, 10) == ds.utilization(ds.DDS, 7, 2, 10)
    True
    """
    fleet = as_fleet(hosts, processes, endpoints)
    seconds, burst_count = partial(_hop_seconds, wifi=as_wifi(wifi)), attrgetter("burst_count")
    costs = as_protocol(protocol).sum_by_unit(seconds, burst_count, by_hop=fleet.has_wired)
    return weighted_sum(costs, fleet)


def unit_costs(
    protocol: AnyProtocol,
    wifi: AnyWifi = PAPER,
    window: ArrayLike = PAPER_WINDOW,
    phase: str | None = None,
    by_hop: bool = False,
) -> dict[Unit, Value]:
    """Return the airtime that each unit adds to an average second of the window [s].

    ``by_hop`` separates uplink and downlink, which fleets with wired hosts need.
    """
    protocol, wifi = as_protocol(protocol), as_wifi(wifi)
    protocol.of_phase(phase)  # raises if the protocol has no such phase
    window_s = checked_window(window)
    if isinstance(window_s, float):
        return dict(_cached_costs(protocol, wifi, phase, window_s, by_hop))
    return _mean_costs(protocol, wifi, phase, window_s, by_hop)


def _mean_costs(
    protocol: Protocol, wifi: Wifi, phase: str | None, window: Value, by_hop: bool
) -> dict[Unit, Value]:
    times = methodcaller("mean", window)
    return protocol.sum_by_unit(partial(_hop_seconds, wifi=wifi), times, phase, by_hop)


_cached_costs = lru_cache(maxsize=4096)(_mean_costs)


def _hop_seconds(message: Message, hop: Hop, wifi: Wifi) -> float:
    """Return the airtime of one message on a hop [s], for its share of the frames."""
    seconds = _frame_seconds(hop, message.cast, message.frames > 0, message.frame_bytes, wifi)
    if seconds == math.inf and wifi.aggregation is not None:
        raise ValueError(
            f"most_bytes of the channel's aggregation must hold every frame of {message.name}; "
            f"got {wifi.aggregation.most_bytes!r}"
        )
    return float(message.frames or 1.0) * seconds


@lru_cache(maxsize=4096)
def _frame_seconds(hop: Hop, cast: Cast, own_frame: bool, octets: float, wifi: Wifi) -> float:
    """Return the airtime of a frame on a hop, or of octets inside of another frame [s]."""
    expression = hop_airtime(hop, cast, own_frame, _FRAME_BYTES, wifi.model)
    with np.errstate(divide="ignore"):
        return float(evaluate(expression, wifi.values() | {_FRAME_BYTES: octets}))


def weighted_sum(
    costs: Mapping[Unit, Value], fleet: Fleet, window: ArrayLike = PAPER_WINDOW
) -> Value:
    """Return the sum over units of cost times count, in the shape of the fleet and the window."""
    shape = _checks.broadcast_shape(**fleet.non_scalars(), window=window)
    if len(fleet.groups) > 1 or fleet.has_wired:
        total = weighted_polynomial(costs, fleet)
    else:
        (group,) = fleet.groups
        extras = (group.shared, group.own_types)
        has = (group.shared != 0, group.own_types != 0)
        function = _swarm_function(tuple(costs), fleet.matching, has)
        with np.errstate(under="ignore"):
            total = function(*group.counts(), *extras, *costs.values())
    if not shape:
        return float(total)
    return total if np.shape(total) == shape else np.array(np.broadcast_to(total, shape), float)


def weighted_polynomial(costs: Mapping[Unit, Value], fleet: Fleet) -> Any:
    """Return the sum of `weighted_sum` without a check: a number, array or `Polynomial`."""
    with np.errstate(under="ignore"):
        return sum(cost * unit.count(fleet) for unit, cost in costs.items())


@cache
def _swarm_function(
    units: tuple[Unit, ...], matching: float, has: tuple[bool, bool]
) -> Callable[..., Any]:
    """Return the weighted sum of units as a function of counts, shared, unknown types, costs."""
    extras = sp.symbols("N_S N_T", nonnegative=True)
    shared, unknown = (symbol if yes else 0.0 for symbol, yes in zip(extras, has, strict=True))
    swarm = Fleet((replace(PAPER_SWARM.groups[0], shared=shared, own_types=unknown),), matching)
    costs = sp.symbols(f"c:{len(units)}", positive=True)
    total = sp.Add(*(cost * unit.count(swarm) for cost, unit in zip(costs, units, strict=True)))
    return compile_function((*swarm.counts(), *extras, *costs), factor_out_common(total))


def resolve_symbols(
    argument: str, given: Mapping[Any, Any], valid: Mapping[sp.Symbol, object]
) -> dict[sp.Symbol, Any]:
    """Return the given values by symbol; an error names a symbol that is not valid."""
    _checks.instance(argument, given, Mapping)
    symbols = {symbol.name: symbol for symbol in valid}
    for name in given:
        if str(name) not in symbols:
            raise ValueError(f"{argument} must name {', '.join(symbols)}; got {str(name)!r}")
    return {symbols[str(name)]: value for name, value in given.items()}


def utilization_at(
    values: Mapping[Any, float], protocol: AnyProtocol, fleet: Fleet, phase: str | None = None
) -> Value:
    """Return `utilization` with other values of the parameters than the paper's.

    ``values`` maps symbols or their names to values, in bytes, seconds or bit/s.
    """
    protocol = as_protocol(protocol)
    _checks.instance("fleet", fleet, Fleet)
    reject_symbols_and_cells(fleet)
    at = protocol.values() | PAPER.values()
    for symbol, value in resolve_symbols("values", values, at).items():
        is_rate = symbol in (nt.R_UNI, nt.R_MULTI)
        at[symbol] = _checks.number(symbol.name, value, 0, exclusive_min=is_rate)
    symbolic = protocol.costs(phase, by_hop=fleet.has_wired)
    costs: Any = compile_function(tuple(at), sp.Tuple(*symbolic.values()))(*at.values())
    return weighted_sum(dict(zip(symbolic, map(float, costs), strict=True)), fleet)


def utilization_without_each_group(
    protocol: AnyProtocol, fleet: Fleet, wifi: AnyWifi = PAPER, window: float = PAPER_WINDOW
) -> list[float]:
    """Return for each group the utilization that the fleet would have without the group [1]."""
    costs = unit_costs(protocol, wifi, window, by_hop=fleet.has_wired)
    rests = (fleet.groups[:index] + fleet.groups[index + 1 :] for index in range(len(fleet.groups)))
    fleets = (replace(fleet, groups=rest) if rest else None for rest in rests)
    return [float(weighted_sum(costs, each)) if each else 0.0 for each in fleets]


def breakdown(
    protocol: AnyProtocol,
    hosts: float | Fleet,
    processes: float | None = None,
    endpoints: float | None = None,
    wifi: AnyWifi = PAPER,
    window: float = PAPER_WINDOW,
) -> pd.DataFrame:
    """Return the cost of each message of a protocol in an average second of the window.

    A ValueError says if fractional hosts or processes would send a negative number of messages.

    Parameters
    ----------
    protocol, hosts, processes, endpoints, wifi, window
        As for `utilization`, but one swarm or fleet and one window: numbers, not arrays.

    Returns
    -------
    pandas.DataFrame
        One row per message, indexed by its name, with columns phase, cast,
        frame_bytes [B], uplink_messages [1], uplink_s [s] and downlink_s [s].

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
    protocol: AnyProtocol, fleet: Fleet, wifi: AnyWifi = PAPER, window: float = PAPER_WINDOW
) -> list[dict[str, Any]]:
    """Return the rows of `breakdown` as dictionaries whose first key is the message's name."""
    protocol, wifi = as_protocol(protocol), as_wifi(wifi)
    for group in fleet.groups:
        _checks.require_scalars(zip(COUNTS, group.counts(), strict=True))
    _checks.require_scalars([("window", window)])
    rows = []
    for message in protocol.messages:
        count = float(message.load(fleet)) + 0.0  # also where it is -0.0
        if count < 0:
            counts = "; ".join(f"{g.hosts:g} and {g.processes:g}" for g in fleet.groups)
            raise ValueError(
                f"hosts and processes must be whole numbers here: these give {count:.4g} "
                f"{message.name} messages ({message.unit.name}); got {counts}"
            )
        sent = dict.fromkeys(HOPS, 0.0)
        for unit, hops in message.counted_by(by_hop=fleet.has_wired):
            load = message.per_unit * unit.count(fleet) * message.schedule.mean(window)
            sent |= dict.fromkeys(hops, float(load) + 0.0)
        rows.append(
            {
                "message": message.name,
                "phase": message.phase,
                "cast": message.cast,
                "frame_bytes": message.frame_bytes,
                "uplink_messages": sent["up"],
                "uplink_s": sent["up"] * _hop_seconds(message, "up", wifi),
                "downlink_s": sent["down"] * _hop_seconds(message, "down", wifi),
            }
        )
    return rows
