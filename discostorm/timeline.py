r"""What 100% means: which messages are sent once, which for ever, and how long a start takes.

The paper divides the airtime of a start-up burst by one second. The tables of products say
of each message when it is sent, and how long their lease is; so the burst and the steady
state come apart, and any window can take the place of the second.

Assumptions: all processes start at time 0, nothing is lost or sent again, nobody collides, and
the channel carries without a gap whatever waits. Answers are sent at the time of what they
answer. So times are those of a start at its best, as far as losses, collisions and queues are
concerned; the book's page "What the model leaves out" lists what else errs, and which way.
"""

from collections.abc import Iterable
from dataclasses import replace
from typing import Any

import numpy as np
import sympy as sp
from numpy.typing import ArrayLike, NDArray

from discostorm import _checks
from discostorm._numeric import Value, evaluate
from discostorm.fleet import COUNTS, Fleet
from discostorm.messages import ONCE, PAPER_WINDOW, Message, Protocol, Schedule
from discostorm.model import burst, utilization
from discostorm.wifi import PAPER, Wifi

#: Airtime of a burst [s], and the utilization of the steady state [1].
BURST, STEADY = sp.symbols("B rho", nonnegative=True)

#: By when the channel has caught up with the burst [s].
DRAIN = sp.Piecewise((BURST / (1 - STEADY), STEADY < 1), (sp.oo, True))

#: What rounding may make of a time [1].
_ROUNDING = 1e-9

#: Most times of a message that `first_idle` looks at.
_MOST_TIMES = 1e6


def drained(extra: ArrayLike, steady: ArrayLike) -> Value:
    """Return `DRAIN` of bursts [s] beside steady states [1]; see `drain_time`.

    A steady state of 1 fills the channel, which is then never silent: infinity, also of no burst.
    """
    burst_s = _checks.numbers("extra", extra, 0, _checks.MOST_UTILIZATION)
    steady_part = _checks.numbers("steady", steady, 0, _checks.MOST_UTILIZATION)
    with np.errstate(divide="ignore", invalid="ignore"):  # NumPy computes both branches
        return evaluate(DRAIN, {BURST: np.asarray(burst_s), STEADY: np.asarray(steady_part)})


def drain_time(
    protocol: Protocol,
    hosts: ArrayLike | Fleet,
    processes: ArrayLike | None = None,
    endpoints: ArrayLike | None = None,
    wifi: Wifi = PAPER,
) -> Value:
    r"""Return by when the channel has caught up with the start, without losses or collisions.

    .. math:: t = \frac{B}{1 - \rho}

    B is the airtime of the burst, :math:`\rho` the utilization of the steady state.
    It is a bound: `first_idle` tells when the channel really has, with each repeated message
    sent at its own instant, and is never later.

    Parameters
    ----------
    protocol : Protocol
        One of `PROTOCOLS`, or a table of your own.
    hosts : array_like or Fleet
        Hosts in the network [1], from 1 to 1e9; or a `Fleet` of unlike hosts, in which
        case `processes` and `endpoints` are left out.
    processes : array_like
        Processes on each host [1], from 1 to 1e9.
    endpoints : array_like
        Endpoints of each process [1], from 0 to 1e9.
    wifi : Wifi, optional
        The channel; the paper's if left out.

    Returns
    -------
    float or ndarray
        Time after the start [s]; infinity where the steady state fills the channel.

    Raises
    ------
    ValueError
        If an argument is NaN, infinite or out of range, or the shapes do not broadcast.
    TypeError
        If an argument is not made of real numbers, or `protocol` is not one.

    References
    ----------
    Airtime: paper, equations (11) and (12). Periods: the tables of `PROTOCOLS`.

    Examples
    --------
    >>> import discostorm as ds
    >>> from discostorm import timeline
    >>> timeline.drain_time(ds.PROTOCOLS["DDS, periods of Fast DDS"], [3, 12, 60], 2, 10).round(2)
    array([0.22, 4.7 ,  inf])
    """
    _checks.instance("protocol", protocol, Protocol)
    swarm = (hosts, processes, endpoints, wifi)
    return drained(burst(protocol, *swarm), utilization(protocol, *swarm, window=np.inf))


def demand(
    protocol: Protocol,
    time: ArrayLike,
    hosts: ArrayLike,
    processes: ArrayLike,
    endpoints: ArrayLike,
    wifi: Wifi = PAPER,
) -> Value:
    """Return the airtime of all that is sent from the start up to a time.

    Parameters
    ----------
    protocol, hosts, processes, endpoints, wifi
        As for `drain_time`.
    time : array_like
        Time after the start [s], at least 0; what is sent just then counts.

    Returns
    -------
    float or ndarray
        Airtime [s], of the shape that the arguments broadcast to. The channel has carried
        at most `time` seconds of it.

    Raises
    ------
    ValueError
        If an argument is NaN, infinite or out of range, or the shapes do not broadcast.
    TypeError
        If an argument is not made of real numbers, or `protocol` is not one.

    References
    ----------
    As for `drain_time`.

    Examples
    --------
    >>> import discostorm as ds
    >>> from discostorm import timeline
    >>> timeline.demand(ds.PROTOCOLS["DDS, periods of Fast DDS"], [0, 3.4, 3.5], 3, 2, 10).round(4)
    array([0.1495, 0.2245, 0.2395])
    """
    _checks.instance("protocol", protocol, Protocol)
    _checks.shape(time=time, hosts=hosts, processes=processes, endpoints=endpoints)
    total: Value = 0.0
    for schedule, each in _rounds(protocol, hosts, processes, endpoints, wifi).items():
        total = total + each * schedule.sent(time)
    return total


def _rounds(protocol: Protocol, *swarm: Any) -> dict[Schedule, Value]:
    """Return for each schedule the airtime of all that is sent by it at one of its times [s]."""
    together: dict[Schedule, tuple[Message, ...]] = {}
    for message in protocol.messages:
        once = replace(message, schedule=ONCE, answers=None)
        together[message.schedule] = (*together.get(message.schedule, ()), once)
    return {
        schedule: utilization(Protocol(protocol.name, messages), *swarm)
        for schedule, messages in together.items()
    }


def first_idle(
    protocol: Protocol,
    hosts: float,
    processes: float,
    endpoints: float,
    wifi: Wifi = PAPER,
) -> float:
    """Return when the channel falls silent for the first time after the start.

    Parameters
    ----------
    protocol, hosts, processes, endpoints, wifi
        As for `drain_time`, but one swarm: numbers, not arrays.

    Returns
    -------
    float
        Time after the start [s]; zero if nothing is sent at once, infinity if the traffic
        that stays fills the channel.

    Raises
    ------
    ValueError
        If an argument is NaN, infinite or out of range, or the traffic that stays fills the
        channel so nearly that a million times would have to be looked at.
    TypeError
        If an argument is not one real number.

    References
    ----------
    As for `drain_time`.

    Examples
    --------
    >>> import discostorm as ds
    >>> from discostorm import timeline
    >>> round(timeline.first_idle(ds.PROTOCOLS["DDS, periods of Fast DDS"], 12, 2, 10), 2)
    4.61
    """
    _checks.one_each(zip(COUNTS, (hosts, processes, endpoints), strict=True))
    bound = float(drain_time(protocol, hosts, processes, endpoints, wifi))
    if bound == np.inf:
        return np.inf
    rounds = _rounds(protocol, hosts, processes, endpoints, wifi)
    # Behind the last of all starts what is sent is at most one round behind the line that bounds
    # it, so that the channel cannot be idle before the line of a round less says so.
    last = max(schedule.starts[-1] for schedule in rounds)
    round_s = sum(float(each) for schedule, each in rounds.items() if schedule.period < np.inf)
    steady = sum(float(each) * schedule.per_second for schedule, each in rounds.items())
    busy = max(last, (bound - round_s / (1 - steady)) * (1 - _ROUNDING))
    early = _times(rounds, 0.0, min(last, bound))
    if not early.size or early[0] > 0:
        return 0.0
    at = (hosts, processes, endpoints, wifi)
    if bound <= last:
        return _first_gap(early, np.inf, protocol, *at)
    if (bound - busy) / min(schedule.period for schedule in rounds) > _MOST_TIMES:
        raise ValueError(
            "hosts, processes and endpoints must be fewer to say when the channel falls silent: it "
            f"is so full that this may be at any of more than {_MOST_TIMES:g} times; got "
            f"{hosts:g}, {processes:g} and {endpoints:g}. `drain_time` says by when it is"
        )
    found = _first_gap(early, -np.inf, protocol, *at)
    if found < np.inf:
        return found
    return _first_gap(np.union1d([busy], _times(rounds, busy, bound)), np.inf, protocol, *at)


def _times(schedules: Iterable[Schedule], since: float, until: float) -> NDArray[np.float64]:
    """Return all times at which anything is sent, in order [s]."""
    return np.unique(np.concatenate([one.times(until, since) for one in schedules]))


def _first_gap(times: NDArray[np.float64], end: float, protocol: Protocol, *swarm: Any) -> float:
    """Return when all is carried first before the next of the times, or the end; else infinity."""
    carried = np.asarray(demand(protocol, times, *swarm))
    gaps = carried[carried <= np.append(times[1:], end)]
    return float(gaps[0]) if gaps.size else np.inf


#: What `outlook` says, from best to worst: of a start without losses, collisions or full queues.
OUTLOOKS = ("within a second at best", "slow at best", "leases at risk", "never catches up")


def outlook(
    protocol: Protocol,
    hosts: float,
    processes: float,
    endpoints: float,
    wifi: Wifi = PAPER,
) -> str:
    """Return in words how the start of a swarm ends, without losses or collisions.

    Parameters
    ----------
    protocol, hosts, processes, endpoints, wifi
        As for `drain_time`, but one swarm: numbers, not arrays.

    Returns
    -------
    str
        "within a second at best" if the burst is carried in the paper's one second if nothing
        is lost; "slow at best" if it then is carried within the lease; "leases at risk" if it
        takes longer even so, and peers may be dropped and the burst be sent again before it
        was carried; "never catches up" if the steady state fills the channel.

    Raises
    ------
    ValueError
        If an argument is NaN, infinite or out of range.
    TypeError
        If an argument is not one real number.

    References
    ----------
    As for `drain_time`.

    Examples
    --------
    >>> import discostorm as ds
    >>> from discostorm import timeline
    >>> timeline.outlook(ds.PROTOCOLS["Zenoh, periods of Zenoh peer"], 12, 2, 10)
    'slow at best'
    """
    _checks.one_each(zip(COUNTS, (hosts, processes, endpoints), strict=True))
    time = drain_time(protocol, hosts, processes, endpoints, wifi)
    limits = (PAPER_WINDOW, protocol.lease, np.inf)
    return OUTLOOKS[int(np.searchsorted(limits, time))] if time < np.inf else OUTLOOKS[-1]
