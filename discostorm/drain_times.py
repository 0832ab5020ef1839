"""Startup over time: messages sent once or periodically, and how long the channel stays busy.

The paper divides the airtime of a startup burst by one second. The tables of products say when
each message is sent, so that burst and steady state come apart. Assumes: all processes start at
time 0, nothing is lost, repeated or collides, the channel carries waiting frames without a gap,
and answers are sent at the time of what they answer. So times are lower bounds:
losses, collisions and queues prolong them.
"""

from collections.abc import Iterable
from dataclasses import replace
from typing import Any

import numpy as np
import sympy as sp
from numpy.typing import ArrayLike, NDArray

from discostorm import _checks
from discostorm._numeric import Value, evaluate
from discostorm.fleet import COUNTS, Fleet, as_fleet
from discostorm.lookup import AnyProtocol, AnyWifi, as_protocol
from discostorm.messages import ONCE, PAPER_WINDOW, Message, Protocol, Schedule
from discostorm.model import burst, utilization
from discostorm.wifi import PAPER

#: Airtime of a burst [s], and the utilization of the steady state [1].
BURST, STEADY = sp.symbols("B rho", nonnegative=True)

#: When the channel has drained the backlog of the burst [s].
DRAIN_TIME = sp.Piecewise((BURST / (1 - STEADY), STEADY < 1), (sp.oo, True))

#: Relative rounding error of a time [1].
_ROUNDING = 1e-9

#: Maximum number of times of a message that `first_idle` tries.
_MAX_TIMES = 1e6


def burst_drain_time(extra: ArrayLike, steady: ArrayLike) -> Value:
    """Return `drain_time` from bursts [s] and steady states [1].

    A steady state of 1 fills the channel, which then never goes idle: infinity, even without burst.
    """
    burst_s = _checks.numbers("extra", extra, 0, _checks.MAX_UTILIZATION)
    steady_part = _checks.numbers("steady", steady, 0, _checks.MAX_UTILIZATION)
    with np.errstate(divide="ignore", invalid="ignore"):  # NumPy computes both branches
        return evaluate(DRAIN_TIME, {BURST: np.asarray(burst_s), STEADY: np.asarray(steady_part)})


def drain_time(
    protocol: AnyProtocol,
    hosts: ArrayLike | Fleet,
    processes: ArrayLike | None = None,
    endpoints: ArrayLike | None = None,
    wifi: AnyWifi = PAPER,
) -> Value:
    r"""Return when the channel has drained the startup backlog, without losses or collisions.

    .. math:: t = \frac{B}{1 - \rho}

    B is the airtime of the burst, :math:`\rho` the utilization of the steady state. It is an upper
    bound of `first_idle`, which sends each periodic message at its own instant. Discovery can
    complete sooner: queues that overflow drop frames, and a dropped frame needs no airtime.

    Parameters
    ----------
    protocol, hosts, processes, endpoints, wifi
        As for `discostorm.utilization`.

    Returns
    -------
    float or ndarray
        Time after startup [s]; infinity where the steady state fills the channel.

    Examples
    --------
    >>> import discostorm as ds
    >>> ds.drain_time("DDS, periods of Fast DDS", [3, 12, 60], 2, 10).round(2)
    array([0.22, 4.7 ,  inf])
    """
    swarm = (hosts, processes, endpoints, wifi)
    return burst_drain_time(burst(protocol, *swarm), utilization(protocol, *swarm, window=np.inf))


def demand(
    protocol: AnyProtocol,
    time: ArrayLike,
    hosts: ArrayLike,
    processes: ArrayLike,
    endpoints: ArrayLike,
    wifi: AnyWifi = PAPER,
) -> Value:
    """Return the airtime of all messages from startup up to and including a time [s].

    Of the shape to which the arguments broadcast. The channel has carried at most `time` of it.
    """
    time_s = _checks.numbers("time", time, 0)
    swarm = as_fleet(hosts, processes, endpoints)
    _checks.broadcast_shape(time=time_s, **swarm.non_scalars())
    total: Value = 0.0
    for schedule, each in _airtime_per_send(as_protocol(protocol), swarm, None, None, wifi).items():
        total = total + each * schedule.sent(time_s)
    return total


def _airtime_per_send(protocol: Protocol, *swarm: Any) -> dict[Schedule, Value]:
    """Return, for each schedule, the airtime of all its messages at one send time [s]."""
    together: dict[Schedule, tuple[Message, ...]] = {}
    for message in protocol.messages:
        once = replace(message, schedule=ONCE, answers=None)
        together[message.schedule] = (*together.get(message.schedule, ()), once)
    tables = {schedule: Protocol(protocol.name, rows) for schedule, rows in together.items()}
    return {schedule: utilization(table, *swarm) for schedule, table in tables.items()}


def first_idle(
    protocol: AnyProtocol, hosts: float, processes: float, endpoints: float, wifi: AnyWifi = PAPER
) -> float:
    """Return when the channel goes idle for the first time after startup, for one swarm [s].

    Zero if nothing is sent at time 0, infinity if periodic traffic fills the channel. A ValueError
    says if the channel is so nearly full that a million times would have to be tried.
    """
    _checks.require_scalars(zip(COUNTS, (hosts, processes, endpoints), strict=True))
    bound = float(drain_time(protocol, hosts, processes, endpoints, wifi))
    if bound == np.inf:
        return np.inf
    protocol = as_protocol(protocol)
    rounds = _airtime_per_send(protocol, hosts, processes, endpoints, wifi)
    # After the last start time, the demand is at least B + rho t minus the messages of one round.
    # The channel cannot go idle before this lower bound meets t.
    last = max(schedule.starts[-1] for schedule in rounds)
    round_s = sum(float(each) for schedule, each in rounds.items() if schedule.period < np.inf)
    steady = sum(float(each) * schedule.per_second for schedule, each in rounds.items())
    busy = max(last, (bound - round_s / (1 - steady)) * (1 - _ROUNDING))
    early = _send_times(rounds, 0.0, min(last, bound))
    if not early.size or early[0] > 0:
        return 0.0
    at = (hosts, processes, endpoints, wifi)
    if bound <= last:
        return _first_idle_before(early, np.inf, protocol, *at)
    if (bound - busy) / min(schedule.period for schedule in rounds) > _MAX_TIMES:
        raise ValueError(
            "hosts, processes and endpoints must be fewer for an exact drain time: the channel "
            f"is so full that more than {_MAX_TIMES:g} times are possible; got {hosts:g}, "
            f"{processes:g} and {endpoints:g}. `drain_time` gives an upper bound"
        )
    idle = _first_idle_before(early, -np.inf, protocol, *at)
    if idle < np.inf:
        return idle
    times = np.union1d([busy], _send_times(rounds, busy, bound))
    return _first_idle_before(times, np.inf, protocol, *at)


def _send_times(schedules: Iterable[Schedule], since: float, until: float) -> NDArray[np.float64]:
    """Return all times of these schedules, in order [s]."""
    return np.unique(np.concatenate([schedule.times(until, since) for schedule in schedules]))


def _first_idle_before(
    times: NDArray[np.float64], end: float, protocol: Protocol, *swarm: Any
) -> float:
    """Return the first of these times after which the channel goes idle before the next one [s]."""
    carried = np.asarray(demand(protocol, times, *swarm))
    gaps = carried[carried <= np.append(times[1:], end)]
    return float(gaps[0]) if gaps.size else np.inf


#: The results of `outlook`, from best to worst.
OUTLOOKS = ("within a second at best", "slow at best", "leases at risk", "never catches up")


def outlook(
    protocol: AnyProtocol, hosts: float, processes: float, endpoints: float, wifi: AnyWifi = PAPER
) -> str:
    """Return in words how the startup of one swarm ends, without losses or collisions.

    "within a second at best" if the burst drains in the paper's one second; "slow at best" if it
    drains within the lease; "leases at risk" if it takes longer, so that peers may time out and the
    burst be repeated; "never catches up" if the steady state fills the channel.
    """
    _checks.require_scalars(zip(COUNTS, (hosts, processes, endpoints), strict=True))
    time = drain_time(protocol, hosts, processes, endpoints, wifi)
    limits = (PAPER_WINDOW, as_protocol(protocol).lease, np.inf)
    return OUTLOOKS[int(np.searchsorted(limits, time))] if time < np.inf else OUTLOOKS[-1]
