"""Uncertainty of results: bounds, sensitivities and samples over the parameters' ranges.

Parameters are all that utilization depends on besides the counts of hosts, processes and
endpoints: payloads, headers, rates and overheads. The ranges of payloads come with the protocol's
messages, those of the others from ``data/paper/parameter_ranges.csv``. ``ranges`` replaces them:
symbol or its name to (low, high), in bytes, seconds or bit/s.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import cache
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
import sympy as sp
from numpy.typing import ArrayLike, NDArray

from discostorm import _checks, notation as nt
from discostorm._numeric import Value, evaluate
from discostorm.data import read_data
from discostorm.fleet import Fleet, as_fleet
from discostorm.lookup import AnyProtocol, as_protocol
from discostorm.messages import Message, Payload, Protocol, header_bytes
from discostorm.model import resolve_symbols, utilization_at
from discostorm.saturation import saturation_hosts
from discostorm.wifi import PAPER, Link, Wifi

if TYPE_CHECKING:
    import pandas as pd

Range = tuple[float, float]
#: Ranges that a caller gives; a key is a symbol or its name.
GivenRanges = Mapping[Any, Range]
#: A value of each parameter.
Values = dict[sp.Symbol, float]
Samples = dict[sp.Symbol, NDArray[np.float64]]

#: Maximum number of samples: each parameter then fills 800 MB.
MAX_SAMPLES = 10**8

_SENSITIVITY_COLUMNS = (
    *("parameter", "value", "low", "high", "slope", "elasticity", "hosts_at_low", "hosts_at_high"),
)
_SI_UNITS = {"µs": Fraction(1, 10**6), "Mbit/s": Fraction(10**6), "B": Fraction(1)}


class Bounds(NamedTuple):
    """Minimum and maximum of a quantity."""

    low: Value
    high: Value


@cache
def _assumed_ranges() -> dict[sp.Symbol, Range]:
    """Return the range of each parameter in SI units: the sum of the ranges of its parts."""
    # Fractions, as a range must end exactly at the paper's value.
    ends = {f"H_{name}": [Fraction(size)] * 2 for name, size in header_bytes().items()}
    for row in read_data("paper/parameter_ranges.csv"):
        sums = ends.get(row["parameter"], [Fraction(0)] * 2)
        parts = (Fraction(row[end]) * _SI_UNITS[row["unit"]] for end in ("low", "high"))
        ends[row["parameter"]] = [a + b for a, b in zip(sums, parts, strict=True)]
    symbols = {name: quantity.symbol for name, quantity in nt.NOTATION.items()}
    return {symbols[name]: (float(low), float(high)) for name, (low, high) in ends.items()}


def parameter_ranges(
    protocol: AnyProtocol, given: GivenRanges | None = None
) -> dict[sp.Symbol, Range]:
    """Return the range of every parameter that a protocol's utilization depends on.

    Symbols map to (low, high) in bytes, seconds or bit/s. ``given`` replaces assumed ranges.
    """
    protocol = as_protocol(protocol)
    ranges = {m.payload_symbol: (m.payload.low, m.payload.high) for m in protocol.messages}
    used = protocol.utilization().free_symbols
    ranges |= {symbol: ends for symbol, ends in _assumed_ranges().items() if symbol in used}
    for symbol, ends in resolve_symbols("ranges", {} if given is None else given, ranges).items():
        try:
            low, high = ends
        except (TypeError, ValueError):
            raise ValueError(f"{symbol} must have a range (low, high); got {ends!r}") from None
        rate = symbol in (nt.R_UNI, nt.R_MULTI)
        low = _checks.number(f"low end of {symbol}", low, 0, exclusive_min=rate)
        ranges[symbol] = low, _checks.number(f"high end of {symbol}", high, low)
    return ranges


@cache
def derivative_signs(protocol: AnyProtocol, phase: str | None = None) -> dict[sp.Symbol, int]:
    """Return the sign of the derivative of utilization by each parameter: 1 or -1.

    Counts are never negative, so utilization is monotone for every fleet if the cost of each unit
    is monotone. Raise a ValueError if a cost is not monotone.
    """
    protocol = as_protocol(protocol)
    costs = list(protocol.costs(phase).values())
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


def _extreme_parameters(
    protocol: AnyProtocol, phase: str | None, given: GivenRanges | None
) -> tuple[Values, Values]:
    """Return the parameters' values for minimal utilization, and for maximal utilization."""
    signs = derivative_signs(protocol, phase)
    ends = {
        symbol: (high, low) if signs.get(symbol) == -1 else (low, high)
        for symbol, (low, high) in parameter_ranges(protocol, given).items()
    }
    low, high = ({symbol: pair[index] for symbol, pair in ends.items()} for index in (0, 1))
    return low, high


def bounds(
    protocol: AnyProtocol,
    hosts: ArrayLike | Fleet,
    processes: ArrayLike | None = None,
    endpoints: ArrayLike | None = None,
    *,
    phase: str | None = None,
    ranges: GivenRanges | None = None,
) -> Bounds:
    """Return the minimum and maximum utilization with every parameter in its range.

    Utilization is monotone in each parameter (`derivative_signs`), so both are at ends of ranges.

    Parameters
    ----------
    protocol, hosts, processes, endpoints, phase
        As for `discostorm.utilization`.
    ranges : mapping, optional
        Ranges that replace the assumed ones; see `parameter_ranges`.

    Returns
    -------
    Bounds
        ``low`` and ``high`` [1], each of the shape the arguments broadcast to.

    Examples
    --------
    >>> import discostorm as ds
    >>> low, high = ds.uncertainty.bounds(ds.DDS, hosts=7, processes=2, endpoints=10)
    >>> low < ds.utilization(ds.DDS, 7, 2, 10) < high
    True
    """
    fleet = as_fleet(hosts, processes, endpoints)
    corners = _extreme_parameters(protocol, phase, ranges)
    return Bounds(*(utilization_at(corner, protocol, fleet, phase) for corner in corners))


def saturation_bounds(
    protocol: AnyProtocol,
    processes: ArrayLike,
    endpoints: ArrayLike,
    *,
    limit: ArrayLike = 1.0,
    ranges: GivenRanges | None = None,
) -> Bounds:
    """Return the minimum and maximum of `saturation_hosts`: every parameter in its range [1]."""
    protocol = as_protocol(protocol)
    # Saturation needs the fewest hosts where utilization is maximal.
    corners = reversed(_extreme_parameters(protocol, None, ranges))
    return Bounds(*(_saturation_at(protocol, processes, endpoints, limit, at) for at in corners))


def _saturation_at(
    protocol: Protocol, processes: ArrayLike, endpoints: ArrayLike, limit: ArrayLike, values: Values
) -> Value:
    """Return `saturation_hosts` at other values of the parameters."""

    def resized(message: Message) -> Message:
        # A longer header is added to the payload: only their sum is on the air.
        header = values[nt.NOTATION[f"H_{message.transport}"].symbol]
        longer = header - header_bytes()[message.transport]
        size = values[message.payload_symbol] + longer
        return replace(message, payload=Payload(size, size, size, message.payload.source))

    at = PAPER.values() | values
    links = Link(at[nt.R_UNI], at[nt.O_UNI]), Link(at[nt.R_MULTI], at[nt.O_MULTI])
    table = replace(protocol, messages=tuple(map(resized, protocol.messages)))
    return saturation_hosts(table, processes, endpoints, Wifi(PAPER.name, *links), limit)


def sensitivity(
    protocol: AnyProtocol,
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
    protocol, processes, endpoints, limit
        As for `discostorm.saturation_hosts`, but one number each.
    values : mapping, optional
        Where to take the derivatives: symbol or its name to value, in bytes, seconds or
        bit/s; the paper's value for the parameters left out.
    ranges : mapping, optional
        Ranges that replace the assumed ones; see `parameter_ranges`.

    Returns
    -------
    pandas.DataFrame
        One row per parameter, the one that can move the saturation point most first, with
        columns value, low and high [B, s or bit/s], slope [hosts per unit of the
        parameter], elasticity [1], and hosts_at_low and hosts_at_high [1], the saturation point
        with this parameter alone at the ends of its range.

    Examples
    --------
    >>> import discostorm as ds
    >>> ds.uncertainty.sensitivity(ds.DDS, processes=2, endpoints=10).index[0]
    'O_uni'
    """
    import pandas as pd  # here, as it would double the time of importing discostorm

    _checks.require_scalars((("processes", processes), ("endpoints", endpoints), ("limit", limit)))
    protocol = as_protocol(protocol)
    ends = parameter_ranges(protocol, ranges)
    usual = protocol.values() | PAPER.values()
    usual |= resolve_symbols("values", {} if values is None else values, ends)
    at = {name: _checks.number(str(name), usual[name], *pair) for name, pair in ends.items()}
    swarm = (processes, endpoints)
    hosts = _saturation_at(protocol, *swarm, limit, at)
    here = at | {nt.N_H: hosts, nt.N_P: float(processes), nt.N_E: float(endpoints)}
    total = protocol.utilization()
    growth = evaluate(total.diff(nt.N_H), here)
    rows = []
    for name, (low, high) in ends.items():
        slope = -evaluate(total.diff(name), here) / growth
        cases = (at | {name: end} for end in (low, high))
        at_low, at_high = (_saturation_at(protocol, *swarm, limit, case) for case in cases)
        elasticity = slope * at[name] / hosts
        rows.append((name.name, at[name], low, high, slope, elasticity, at_low, at_high))
    table = pd.DataFrame(rows, columns=_SENSITIVITY_COLUMNS).set_index("parameter")
    swing = (table["hosts_at_high"] - table["hosts_at_low"]).abs()
    return table.loc[swing.sort_values(ascending=False, kind="stable").index]


def sample(
    protocol: AnyProtocol,
    *,
    size: int = 1_000_000,
    seed: int = 2026,
    ranges: GivenRanges | None = None,
) -> Samples:
    """Draw every parameter from its range, uniformly and independently.

    From symbol to ``size`` samples, from 1 to 1e8, in bytes, seconds or bit/s: what a function of
    `discostorm.lambdify` in these symbols takes. The same seed, the same samples.
    """
    (drawn,) = sample_together([protocol], size=size, seed=seed, ranges=[ranges])
    return drawn


def sample_together(
    protocols: Sequence[AnyProtocol],
    *,
    size: int = 1_000_000,
    seed: int = 2026,
    ranges: Sequence[GivenRanges | None] | None = None,
) -> tuple[Samples, ...]:
    """Draw the parameters of several protocols that share a channel, each with its ``ranges``.

    Parameters with the same name and range are drawn once for all; see `sample`.
    """
    _checks.integer("size", size, 1, MAX_SAMPLES)
    _checks.integer("seed", seed, 0)
    generator = np.random.default_rng(int(seed))
    tables = [*map(as_protocol, _checks.tuple_of("protocols", protocols, object))]
    drawn: dict[tuple[sp.Symbol, Range], NDArray[np.float64]] = {}
    samples = []
    for protocol, given in zip(tables, ranges or [None] * len(tables), strict=True):
        own = parameter_ranges(protocol, given)
        for symbol, (low, high) in own.items():
            if (symbol, (low, high)) not in drawn:
                drawn[symbol, (low, high)] = generator.uniform(low, high, int(size))
        samples.append({symbol: drawn[symbol, ends] for symbol, ends in own.items()})
    return tuple(samples)
