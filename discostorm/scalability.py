"""Utilization, its breakdown by message, and saturation: symbolic, then numeric."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

import numpy as np
import sympy as sp
from numpy.typing import ArrayLike

from discostorm import _checks, notation as nt
from discostorm._numeric import Value, evaluate
from discostorm.fleet import (
    COUNTS,
    SWARM,
    Count,
    Fleet,
    HostGroup,
    is_symbolic,
    symbolic_group,
)
from discostorm.messages import HOPS, PAPER_WINDOW, Protocol
from discostorm.wifi import PAPER, Model, Wifi

if TYPE_CHECKING:
    import pandas as pd


def as_fleet(
    hosts: ArrayLike | Fleet, processes: ArrayLike | None, endpoints: ArrayLike | None
) -> Fleet:
    """Return the fleet that the arguments of `utilization` and `breakdown` describe."""
    given = {"processes": processes, "endpoints": endpoints}
    if isinstance(hosts, Fleet):
        for name, value in given.items():
            if value is not None:
                raise TypeError(f"{name} must be left out when hosts is a Fleet; got {value!r}")
        fleet = hosts
    else:
        for name, value in given.items():
            if value is None:
                raise TypeError(f"{name} must be given unless hosts is a Fleet; got None")
        fleet = Fleet.swarm(hosts, processes, endpoints)
    for name, count in _named_counts(fleet):
        _reject_symbols(name, count)
    return fleet


def _named_counts(fleet: Fleet) -> list[tuple[str, Count]]:
    return list(zip(COUNTS * len(fleet.groups), fleet.counts(), strict=True))


def _reject_symbols(name: str, count: Count) -> None:
    if is_symbolic(count):
        raise TypeError(
            f"{name} must be a number here, not an expression; got {count}. "
            "In symbols: Protocol.utilization"
        )


@cache
def _utilization(
    protocol: Protocol, phase: str | None, groups: int, model: Model, window: sp.Expr | float
) -> sp.Expr:
    return protocol.utilization(phase, Fleet.symbolic(groups), model, window)


@cache
def _burst(protocol: Protocol, model: Model) -> sp.Expr:
    return protocol.burst(model=model)


def _over(window: ArrayLike) -> tuple[sp.Expr | float, dict[sp.Symbol, Value]]:
    """Return a window for an expression, the paper's as a number; and what it stands for."""
    span = np.asarray(window)
    longest = span == np.inf if span.dtype.kind == "f" else np.False_
    given = _checks.numbers(
        "window", np.where(longest, 1.0, span) if longest.any() else window, 0, above=True
    )
    if longest.any():
        return nt.W, {nt.W: np.where(longest, np.inf, given)}
    if isinstance(given, float) and given == PAPER_WINDOW:
        return PAPER_WINDOW, {}
    return nt.W, {nt.W: given}


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
        The seconds that are averaged [s], above 0; infinity for the steady state.

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

    Of Fast DDS, averaged over its lease of 20 seconds, and in the long run:

    >>> fast_dds = ds.PROTOCOLS["Fast DDS"]
    >>> ds.utilization(fast_dds, 22, 2, 10, window=[20, float("inf")]).round(3)
    array([1.011, 0.263])
    """
    _checks.instance("protocol", protocol, Protocol)
    _checks.instance("wifi", wifi, Wifi)
    protocol.of_phase(phase)  # raises if there is none
    fleet = as_fleet(hosts, processes, endpoints)
    span, given = _over(window)
    expression = _utilization(protocol, phase, len(fleet.groups), wifi.model, span)
    counts = zip(Fleet.symbolic(len(fleet.groups)).counts(), fleet.counts(), strict=True)
    return evaluate(expression, dict(counts) | given | protocol.values() | wifi.values())


def burst(
    protocol: Protocol,
    hosts: ArrayLike,
    processes: ArrayLike,
    endpoints: ArrayLike,
    wifi: Wifi = PAPER,
) -> Value:
    """Return the airtime of what the start sends beyond the steady state.

    Parameters
    ----------
    protocol, hosts, processes, endpoints, wifi
        As for `utilization`, but a swarm.

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
    """
    _checks.instance("protocol", protocol, Protocol)
    _checks.instance("wifi", wifi, Wifi)
    fleet = as_fleet(hosts, processes, endpoints)
    counts = dict(zip(SWARM.counts(), fleet.counts(), strict=True))
    return evaluate(_burst(protocol, wifi.model), counts | protocol.values() | wifi.values())


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
    more = sp.Symbol("x", positive=True)
    quadratic = utilization.subs(nt.N_H, 1 + more)
    # By derivatives: to collect the powers would expand a sum over all pairs of groups.
    a, b, c = (
        quadratic.diff(more, degree).subs(more, 0) / sp.factorial(degree) for degree in (2, 1, 0)
    )
    if quadratic.diff(more, 3) != 0 or (a == 0 and b == 0):
        raise ValueError("utilization must grow with hosts, linearly or as their square")
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
    return solve_hosts(protocol.utilization(fleet=fleet, model=model, window=window))


def saturation_hosts(
    protocol: Protocol,
    processes: ArrayLike,
    endpoints: ArrayLike,
    wifi: Wifi = PAPER,
    limit: ArrayLike = 1.0,
    beside: Fleet | None = None,
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
        Utilization to reach [1], at least that of a single such host and at most 1e100.
    beside : Fleet, optional
        Other hosts that share the channel, such as an operator's laptop; they are not
        counted in the result. None if left out.
    window : array_like, optional
        The seconds over which utilization is averaged [s], above 0; the paper's one if left
        out, infinity for the steady state.

    Returns
    -------
    float or ndarray
        Hosts [1], a real number of at least 1; infinity where nothing is repeated and the
        window is infinite.

    Raises
    ------
    ValueError
        If an argument is NaN, infinite or out of range, or the shapes do not broadcast.
    TypeError
        If an argument is not made of real numbers, or `protocol` or `wifi` is not one.

    References
    ----------
    Paper, Sec. IV-C; the closed form is `saturation`.

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
    host = HostGroup(1, processes, endpoints)
    if beside is not None:
        _checks.instance("beside", beside, Fleet)
    others = beside.groups if beside else ()
    span, over = _over(window)
    if beside is None:
        _checks.shape(processes=processes, endpoints=endpoints, window=window)
    single = utilization(protocol, Fleet((host, *others)), wifi=wifi, window=window)
    most = _checks.numbers("limit", limit, 0, _checks.MOST_UTILIZATION, above=True)
    shapes = {"processes": processes, "endpoints": endpoints, "window": window}
    _checks.shape(**(shapes if beside is None else {"utilization": single}), limit=most)
    short = np.less(most, single)
    if short.any():
        low, needed = _checks.first_where(short, most, single)
        raise ValueError(
            f"limit must be at least the utilization of a single host"
            f"{' beside the fleet' if beside else ''} with {protocol.name}, {needed!r}; got {low!r}"
        )
    given = {nt.N_P: host.processes, nt.N_E: host.endpoints, nt.U_LIMIT: most} | over
    for index, group in enumerate(others, start=1):
        given |= zip(symbolic_group(index).counts(), group.counts(), strict=True)
    closed_form = saturation(protocol, wifi.model, len(others), span)
    with np.errstate(divide="ignore"):
        hosts = evaluate(closed_form, given | protocol.values() | wifi.values())
    # At the least limit allowed, rounding could give a little less than one host.
    return max(hosts, 1.0) if isinstance(hosts, float) else np.maximum(hosts, 1.0)


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
        The seconds that are averaged [s], above 0; the paper's one if left out, infinity
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

    _checks.instance("protocol", protocol, Protocol)
    _checks.instance("wifi", wifi, Wifi)
    fleet = as_fleet(hosts, processes, endpoints)
    _checks.one_each(_named_counts(fleet))
    _checks.one_each([("window", window)])
    span = PAPER_WINDOW if _over(window)[0] == PAPER_WINDOW else window
    values = protocol.values() | wifi.values()
    rows = []
    for message in protocol.messages:
        load = float(message.load(fleet) * message.schedule.mean(span))
        up, down = (load * (hop in message.hops) for hop in HOPS)
        rows.append(
            {
                "message": message.name,
                "phase": message.phase,
                "cast": message.cast,
                "frame_bytes": message.frame_bytes,
                "uplink_messages": up,
                "uplink_s": up * evaluate(message.airtime_up(wifi.model), values),
                "downlink_s": down * evaluate(message.airtime_down(wifi.model), values),
            }
        )
    return pd.DataFrame(rows).set_index("message")
