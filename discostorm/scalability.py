"""Utilization, its breakdown by message, and saturation: symbolic, then numeric."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

import numpy as np
import sympy as sp
from numpy.typing import ArrayLike

from discostorm import _checks, notation as nt
from discostorm._numeric import Value, evaluate
from discostorm.fleet import Fleet, HostGroup
from discostorm.messages import Protocol
from discostorm.wifi import PAPER, Wifi

if TYPE_CHECKING:
    import pandas as pd


def as_fleet(
    hosts: ArrayLike | Fleet, processes: ArrayLike | None, endpoints: ArrayLike | None
) -> Fleet:
    """Return the fleet that the arguments of `utilization` and `breakdown` describe."""
    if isinstance(hosts, Fleet):
        if processes is not None or endpoints is not None:
            raise TypeError("processes and endpoints must be left out when hosts is a Fleet")
        return hosts
    if processes is None or endpoints is None:
        raise TypeError("processes and endpoints must be given unless hosts is a Fleet")
    return Fleet.swarm(hosts, processes, endpoints)


@cache
def _utilization(protocol: Protocol, phase: str | None, groups: int) -> sp.Expr:
    return protocol.utilization(phase, Fleet.symbolic(groups))


def utilization(
    protocol: Protocol,
    hosts: ArrayLike | Fleet,
    processes: ArrayLike | None = None,
    endpoints: ArrayLike | None = None,
    wifi: Wifi = PAPER,
    phase: str | None = None,
) -> Value:
    r"""Return the fraction of one second of channel time that discovery takes.

    .. math:: U = \sum_\phi \left[\mathcal{T}(L^{up}_\phi, R^{up}_\phi)
        + \mathcal{T}(L^{down}_\phi, R^{down}_\phi)\right] / 1\,\mathrm{s}

    Parameters
    ----------
    protocol : Protocol
        `DDS`, `ZENOH`, or a table of your own.
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
        If an argument is not made of real numbers.

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
    """
    fleet = as_fleet(hosts, processes, endpoints)
    expression = _utilization(protocol, phase, len(fleet.groups))
    counts = zip(Fleet.symbolic(len(fleet.groups)).counts(), fleet.counts(), strict=True)
    return evaluate(expression, dict(counts) | protocol.values() | wifi.values())


@cache
def saturation(protocol: Protocol) -> sp.Expr:
    r"""Return the N_H at which utilization reaches U_limit, in symbols.

    Utilization is quadratic in :math:`x = N_H - 1`: :math:`a x^2 + b x + c = U_{limit}`,
    with a, b and c at least 0. Its root is written as

    .. math:: N_H = 1 + \frac{2 (U_{limit} - c)}{b + \sqrt{b^2 + 4 a (U_{limit} - c)}}

    which is the usual formula, in the form that does not cancel in floating point.
    """
    more = sp.Symbol("x", positive=True)
    quadratic = sp.Poly(protocol.utilization().subs(nt.N_H, 1 + more), more)
    a, b, c = (quadratic.coeff_monomial(more**degree) for degree in (2, 1, 0))
    rest = nt.U_LIMIT - c
    return 1 + 2 * rest / (b + sp.sqrt(b**2 + 4 * a * rest))


def saturation_hosts(
    protocol: Protocol,
    processes: ArrayLike,
    endpoints: ArrayLike,
    wifi: Wifi = PAPER,
    limit: ArrayLike = 1.0,
) -> Value:
    """Return the number of hosts at which utilization reaches a limit.

    The largest swarm that stays below the limit has one host less than this, rounded up.

    Parameters
    ----------
    protocol : Protocol
        `DDS`, `ZENOH`, or a table of your own.
    processes : array_like
        Processes on each host [1], from 1 to 1e9.
    endpoints : array_like
        Endpoints of each process [1], from 0 to 1e9.
    wifi : Wifi, optional
        The channel; the paper's if left out.
    limit : array_like, optional
        Utilization to reach [1], at least that of a single host.

    Returns
    -------
    float or ndarray
        Hosts [1], a real number of at least 1.

    Raises
    ------
    ValueError
        If an argument is NaN, infinite or out of range, or the shapes do not broadcast.
    TypeError
        If an argument is not made of real numbers.

    References
    ----------
    Paper, Sec. IV-C; the closed form is `saturation`.

    Examples
    --------
    >>> import discostorm as ds
    >>> round(ds.saturation_hosts(ds.DDS, processes=2, endpoints=10), 4)
    7.1554
    """
    swarm = HostGroup(1, processes, endpoints)
    given = {
        nt.N_P: swarm.processes,
        nt.N_E: swarm.endpoints,
        nt.U_LIMIT: _checks.numbers("limit", limit, 0, above=True),
    }
    hosts = evaluate(saturation(protocol), given | protocol.values() | wifi.values())
    if not np.all(np.greater_equal(hosts, 1)):
        one = utilization(protocol, 1, processes, endpoints, wifi)
        raise ValueError(
            f"limit must be at least the utilization of a single host, {np.max(one):g}; "
            f"got {np.min(limit):g}"
        )
    return hosts


def breakdown(
    protocol: Protocol,
    hosts: float | Fleet,
    processes: float | None = None,
    endpoints: float | None = None,
    wifi: Wifi = PAPER,
) -> pd.DataFrame:
    """Return what each message of a protocol costs.

    Parameters
    ----------
    protocol, hosts, processes, endpoints, wifi
        As for `utilization`, but one swarm or fleet: numbers, not arrays.

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
        If an argument is not one real number.

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
    for name, value in zip(("hosts", "processes", "endpoints") * len(fleet.groups), fleet.counts()):
        _checks.number(name, value, 0)
    values = protocol.values() | wifi.values()
    rows = []
    for message in protocol.messages:
        load = float(message.load(fleet))
        rows.append(
            {
                "message": message.name,
                "phase": message.phase,
                "cast": message.cast,
                "frame_bytes": message.frame_bytes,
                "uplink_messages": load,
                "uplink_s": load * evaluate(message.airtime_up(), values),
                "downlink_s": load * evaluate(message.airtime_down(), values),
            }
        )
    return pd.DataFrame(rows).set_index("message")
