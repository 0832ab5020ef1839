"""How sure the numbers are: bounds, sensitivities and samples over the parameters' ranges.

A parameter is whatever utilization depends on besides the counts of hosts, processes and
endpoints: payloads, headers, rates and overheads. The ranges of payloads come with the
protocol's messages, those of the others from ``data/paper/parameter_ranges.csv``.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import cache
from numbers import Integral
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
import sympy as sp
from numpy.typing import ArrayLike, NDArray

from discostorm import _checks, notation as nt
from discostorm._arguments import as_fleet
from discostorm._numeric import Value, evaluate
from discostorm.data import read_data
from discostorm.fleet import Fleet
from discostorm.messages import Message, Payload, Protocol, header_bytes
from discostorm.model import by_symbol, utilization_at
from discostorm.saturation import saturation_hosts
from discostorm.wifi import PAPER, Link, Wifi

if TYPE_CHECKING:
    import pandas as pd

Range = tuple[float, float]
Ranges = dict[sp.Symbol, Range]
#: Ranges that a caller gives; a key is a symbol or its name.
GivenRanges = Mapping[Any, Range]

#: Most samples taken at once: each parameter then fills 800 MB.
MOST_SAMPLES = 10**8

_SI = {"µs": Fraction(1, 10**6), "Mbit/s": Fraction(10**6), "B": Fraction(1)}


class Bounds(NamedTuple):
    """Least and greatest value that a quantity can take."""

    low: Value
    high: Value


@cache
def _assumed() -> Ranges:
    """Return the ranges of the data file in SI units, each the sum of its parts."""
    # Fractions, as a range must end exactly where the paper's value stands.
    ends = {f"H_{name}": [Fraction(size)] * 2 for name, size in header_bytes().items()}
    for row in read_data("paper/parameter_ranges.csv"):
        low, high = ends.get(row["parameter"], [Fraction(0)] * 2)
        scale = _SI[row["unit"]]
        ends[row["parameter"]] = [
            low + Fraction(row["low"]) * scale,
            high + Fraction(row["high"]) * scale,
        ]
    return {
        nt.NOTATION[name].symbol: (float(low), float(high)) for name, (low, high) in ends.items()
    }


def parameter_ranges(protocol: Protocol, given: GivenRanges | None = None) -> Ranges:
    """Return the range of every parameter that a protocol's utilization depends on.

    Parameters
    ----------
    protocol : Protocol
        One of `PROTOCOLS`, or a table of your own.
    given : mapping, optional
        Ranges that replace the assumed ones: symbol or its name to (low, high), in
        bytes, seconds or bit/s.

    Returns
    -------
    dict
        Symbol to (low, high) in bytes, seconds or bit/s.

    Raises
    ------
    ValueError
        If a name is unknown, or a range is not one.
    TypeError
        If an end of a range is not a real number, or the protocol is not one.

    References
    ----------
    Paper, Table II; ``data/paper/parameter_ranges.csv``.

    Examples
    --------
    >>> import discostorm as ds
    >>> ds.uncertainty.parameter_ranges(ds.DDS)[ds.notation.R_UNI]
    (65000000.0, 144400000.0)
    """
    _checks.instance("protocol", protocol, Protocol)
    found: Ranges = {
        message.payload_symbol: (message.payload.low, message.payload.high)
        for message in protocol.messages
    }
    used = protocol.utilization().free_symbols
    found |= {name: ends for name, ends in _assumed().items() if name in used}
    for name, ends in by_symbol("ranges", {} if given is None else given, found).items():
        try:
            low, high = ends
        except (TypeError, ValueError):
            raise ValueError(f"{name} must have a range (low, high); got {ends!r}") from None
        rate = name in (nt.R_UNI, nt.R_MULTI)
        low = _checks.number(f"low end of {name}", low, 0, above=rate)
        found[name] = low, _checks.number(f"high end of {name}", high, low)
    return found


@cache
def directions(protocol: Protocol, phase: str | None = None) -> dict[sp.Symbol, int]:
    """Return the sign of the derivative of utilization by each parameter: 1 or -1.

    Utilization is a sum of counts, which are never negative, times the airtime that each
    counted unit costs. So it is enough that each of these costs is monotone, whatever
    the fleet: the signs hold for all values of all symbols.

    Raises
    ------
    ValueError
        If the protocol has no such phase, or utilization is not monotone in a parameter.
    """
    costs = [protocol.cost(message.unit, phase) for message in protocol.of_phase(phase)]
    signs = {}
    for symbol in sorted(sp.Add(*costs).free_symbols, key=str):
        slopes = [sp.expand(cost.diff(symbol)) for cost in costs]
        if all(slope.is_nonnegative for slope in slopes):
            signs[symbol] = 1
        elif all(slope.is_nonpositive for slope in slopes):
            signs[symbol] = -1
        else:
            raise ValueError(f"utilization of {protocol.name} is not monotone in {symbol}")
    return signs


def _corners(
    protocol: Protocol, phase: str | None, given: GivenRanges | None
) -> tuple[dict[sp.Symbol, float], dict[sp.Symbol, float]]:
    """Return the parameters at which utilization is least, and greatest."""
    ends = parameter_ranges(protocol, given=given)
    signs = directions(protocol, phase)
    least, greatest = {}, {}
    for name, (low, high) in ends.items():
        falls = signs.get(name) == -1
        least[name], greatest[name] = (high, low) if falls else (low, high)
    return least, greatest


def bounds(
    protocol: Protocol,
    hosts: ArrayLike | Fleet,
    processes: ArrayLike | None = None,
    endpoints: ArrayLike | None = None,
    *,
    phase: str | None = None,
    ranges: GivenRanges | None = None,
) -> Bounds:
    """Return the least and greatest utilization with every parameter in its range.

    As utilization is monotone in each parameter (`directions`), it is least and greatest
    at two known corners of the box of ranges: the bounds are attained.

    Parameters
    ----------
    protocol : Protocol
        `DDS`, `ZENOH`, or a table of your own.
    hosts, processes, endpoints : array_like, or a Fleet alone
        How many there are [1], as for `discostorm.utilization`.
    phase : str, optional
        One of the protocol's phases; all of them if left out.
    ranges : mapping, optional
        Ranges that replace the assumed ones; see `parameter_ranges`.

    Returns
    -------
    Bounds
        ``low`` and ``high`` [1], each of the shape the arguments broadcast to.

    Raises
    ------
    ValueError
        If an argument is NaN, infinite or out of range, a name is unknown, or the shapes
        do not broadcast.
    TypeError
        If an argument is not made of real numbers, or `protocol` is not one.

    References
    ----------
    Paper, Table II and equation (12); ``data/paper/parameter_ranges.csv``.

    Examples
    --------
    >>> import discostorm as ds
    >>> low, high = ds.uncertainty.bounds(ds.DDS, hosts=7, processes=2, endpoints=10)
    >>> low < ds.utilization(ds.DDS, 7, 2, 10) < high
    True
    """
    fleet = as_fleet(hosts, processes, endpoints)
    least, greatest = _corners(protocol, phase, ranges)
    return Bounds(
        utilization_at(least, protocol, fleet, phase),
        utilization_at(greatest, protocol, fleet, phase),
    )


def saturation_bounds(
    protocol: Protocol,
    processes: ArrayLike,
    endpoints: ArrayLike,
    *,
    limit: ArrayLike = 1.0,
    ranges: GivenRanges | None = None,
) -> Bounds:
    """Return the fewest and most hosts at which utilization can reach a limit.

    Utilization grows with the hosts, so the saturation point is least where utilization
    is greatest.

    Parameters
    ----------
    protocol, processes, endpoints, limit
        As for `discostorm.saturation_hosts`.
    ranges : mapping, optional
        Ranges that replace the assumed ones; see `parameter_ranges`.

    Returns
    -------
    Bounds
        ``low`` and ``high`` [1], real numbers of hosts.

    Raises
    ------
    ValueError
        If an argument is NaN, infinite or out of range, a name is unknown, or the shapes
        do not broadcast.
    TypeError
        If an argument is not made of real numbers, or `protocol` is not one.

    Examples
    --------
    >>> import discostorm as ds
    >>> low, high = ds.uncertainty.saturation_bounds(ds.DDS, processes=2, endpoints=10)
    >>> low < ds.saturation_hosts(ds.DDS, 2, 10) < high
    True
    """
    least, greatest = _corners(protocol, None, ranges)
    return Bounds(
        _saturation(protocol, processes, endpoints, limit, greatest),
        _saturation(protocol, processes, endpoints, limit, least),
    )


def _saturation(
    protocol: Protocol,
    processes: ArrayLike,
    endpoints: ArrayLike,
    limit: ArrayLike,
    values: Mapping[sp.Symbol, float],
) -> Value:
    """Return `saturation_hosts` at other values of the parameters."""
    messages = tuple(_resized(message, values) for message in protocol.messages)
    at = PAPER.values() | dict(values)
    unicast, multicast = Link(at[nt.R_UNI], at[nt.O_UNI]), Link(at[nt.R_MULTI], at[nt.O_MULTI])
    wifi = Wifi(PAPER.name, unicast, multicast)
    return saturation_hosts(replace(protocol, messages=messages), processes, endpoints, wifi, limit)


def _resized(message: Message, values: Mapping[sp.Symbol, float]) -> Message:
    """Return a message with other values of payload and header."""
    # What a header is longer is added to the payload: only their sum is on the air.
    header = nt.NOTATION[f"H_{message.transport}"].symbol
    longer = values[header] - header_bytes()[message.transport]
    size = values[message.payload_symbol] + longer
    return replace(message, payload=Payload(size, size, size, message.payload.source))


def sensitivity(
    protocol: Protocol,
    processes: float,
    endpoints: float,
    *,
    limit: float = 1.0,
    values: Mapping[Any, float] | None = None,
    ranges: GivenRanges | None = None,
) -> pd.DataFrame:
    r"""Return how the saturation point depends on each parameter.

    At the saturation point :math:`U(N_H, p) = U_{limit}` whatever the parameter p, so

    .. math:: \frac{dN_H}{dp} =
        -\frac{\partial U / \partial p}{\partial U / \partial N_H},
        \qquad e_p = \frac{p}{N_H} \frac{dN_H}{dp}

    Parameters
    ----------
    protocol : Protocol
        `DDS`, `ZENOH`, or a table of your own.
    processes : float
        Processes on each host [1], from 1 to 1e9.
    endpoints : float
        Endpoints of each process [1], from 0 to 1e9.
    limit : float, optional
        Utilization to reach [1], at least that of a single host.
    values : mapping, optional
        Where to take the derivatives: symbol or its name to value, in bytes, seconds or
        bit/s; the paper's value for the parameters left out.
    ranges : mapping, optional
        Ranges that replace the assumed ones; see `parameter_ranges`.

    Returns
    -------
    pandas.DataFrame
        One row a parameter, the one that can move the saturation point most first, with
        columns value, low and high [B, s or bit/s], slope [hosts per unit of the
        parameter], elasticity [1] (percent more hosts for one percent more of it), and
        hosts_at_low and hosts_at_high [1], the saturation point with this parameter alone
        at the ends of its range.

    Raises
    ------
    ValueError
        If an argument is NaN, infinite or out of range, or a name is unknown.
    TypeError
        If an argument is not one real number, or `protocol` is not one.

    Examples
    --------
    >>> import discostorm as ds
    >>> ds.uncertainty.sensitivity(ds.DDS, processes=2, endpoints=10).index[0]
    'O_uni'
    """
    import pandas as pd  # here, as it would double the time of importing discostorm

    _checks.one_each((("processes", processes), ("endpoints", endpoints), ("limit", limit)))
    ends = parameter_ranges(protocol, given=ranges)
    usual = protocol.values() | PAPER.values()
    given = by_symbol("values", {} if values is None else values, ends)
    at = {
        name: _checks.number(str(name), given.get(name, usual[name]), low, high)
        for name, (low, high) in ends.items()
    }
    hosts = _saturation(protocol, processes, endpoints, limit, at)
    here = at | {nt.N_H: hosts, nt.N_P: float(processes), nt.N_E: float(endpoints)}
    total = protocol.utilization()
    growth = evaluate(total.diff(nt.N_H), here)
    rows = []
    for name, (low, high) in ends.items():
        slope = -evaluate(total.diff(name), here) / growth
        at_low, at_high = (
            _saturation(protocol, processes, endpoints, limit, at | {name: end})
            for end in (low, high)
        )
        rows.append(
            {
                "parameter": name.name,
                "value": at[name],
                "low": low,
                "high": high,
                "slope": slope,
                "elasticity": slope * at[name] / hosts,
                "hosts_at_low": at_low,
                "hosts_at_high": at_high,
            }
        )
    table = pd.DataFrame(rows).set_index("parameter")
    swing = (table["hosts_at_high"] - table["hosts_at_low"]).abs()
    return table.loc[swing.sort_values(ascending=False, kind="stable").index]


def sample(
    protocol: Protocol,
    *,
    size: int = 1_000_000,
    seed: int = 2026,
    ranges: GivenRanges | None = None,
) -> dict[sp.Symbol, NDArray[np.float64]]:
    """Draw every parameter from its range, uniformly and independently.

    Parameters
    ----------
    protocol : Protocol
        One of `PROTOCOLS`, or a table of your own.
    size : int, optional
        Number of samples, from 1 to 1e8.
    seed : int, optional
        Seed of NumPy's default generator, at least 0: the same seed, the same samples.
    ranges : mapping, optional
        Ranges that replace the assumed ones; see `parameter_ranges`.

    Returns
    -------
    dict
        Symbol to samples in bytes, seconds or bit/s: what a function that
        `discostorm.lambdify` made of an expression in these symbols takes.

    Raises
    ------
    ValueError
        If `size` or `seed` is out of range, or a name is unknown.
    TypeError
        If `size` or `seed` is not an integer, or the protocol is not one.

    Examples
    --------
    >>> import discostorm as ds
    >>> from discostorm.notation import N_E, N_H, N_P
    >>> drawn = ds.uncertainty.sample(ds.DDS, size=1000)
    >>> u = ds.lambdify([N_H, N_P, N_E, *drawn], ds.DDS.utilization())
    >>> u(7, 2, 10, *drawn.values()).shape
    (1000,)
    """
    _checks.instance("protocol", protocol, Protocol)
    (drawn,) = sample_together([protocol], size=size, seed=seed, ranges=[ranges])
    return drawn


def sample_together(
    protocols: Sequence[Protocol],
    *,
    size: int = 1_000_000,
    seed: int = 2026,
    ranges: Sequence[GivenRanges | None] | None = None,
) -> tuple[dict[sp.Symbol, NDArray[np.float64]], ...]:
    """Draw the parameters of several protocols that share a channel.

    What they share is drawn once: the parameters of the channel, and payloads of the same
    name and range. Messages of the same name whose ranges differ are drawn apart.

    Parameters
    ----------
    protocols : sequence of Protocol
        At least one.
    size, seed
        As for `sample`.
    ranges : sequence of mapping, optional
        For each protocol the ranges that replace the assumed ones, or None.

    Returns
    -------
    tuple of dict
        For each protocol what `sample` returns.

    Raises
    ------
    ValueError
        If `size` or `seed` is out of range, or a name is unknown.
    TypeError
        If `size` or `seed` is not an integer, or a protocol is not one.
    """
    size = _whole("size", size, 1, MOST_SAMPLES)
    generator = np.random.default_rng(_whole("seed", seed, 0))
    tables = _checks.members("protocols", protocols, Protocol)
    drawn: dict[tuple[sp.Symbol, Range], NDArray[np.float64]] = {}
    samples = []
    for protocol, given in zip(tables, ranges or [None] * len(tables), strict=True):
        own = parameter_ranges(protocol, given=given)
        for name, (low, high) in own.items():
            if (name, (low, high)) not in drawn:
                drawn[name, (low, high)] = generator.uniform(low, high, size)
        samples.append({name: drawn[name, ends] for name, ends in own.items()})
    return tuple(samples)


def _whole(name: str, value: object, low: int, high: int | None = None) -> int:
    allowed = f"an integer of at least {low}" + (f" and at most {high}" if high else "")
    # A duration is an integer to NumPy.
    if not isinstance(value, Integral) or isinstance(value, (bool, np.timedelta64)):
        raise TypeError(f"{name} must be {allowed}; got {value!r}")
    number = int(value)
    if number < low or (high is not None and number > high):
        raise ValueError(f"{name} must be {allowed}; got {number}")
    return number
