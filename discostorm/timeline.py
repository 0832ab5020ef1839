r"""What 100% means: which messages are sent once, which for ever, and how long a start takes.

The paper divides the airtime of a start-up burst by one second. Here every message has a
`Schedule`, and a `Product` (a middleware with its default periods and leases) is a table of
messages with their schedules. It gives message tables again, of the burst, of the traffic
that stays, or of a window of any length, so that loads and airtimes come from the one model.

Assumptions: all processes start at time 0, nothing is lost or sent again, and the channel
carries without a gap whatever waits. Answers are sent at the time of what they answer.
"""

from dataclasses import dataclass, replace
from functools import cache
from typing import Any

import numpy as np
import sympy as sp
from numpy.typing import ArrayLike, NDArray

from discostorm import _checks, notation as nt
from discostorm._numeric import Value, evaluate
from discostorm.data import read_data
from discostorm.fleet import COUNTS, HostGroup
from discostorm.messages import PAIR, Message, Payload, Protocol
from discostorm.protocols import DDS, ZENOH
from discostorm.scalability import solve_hosts, utilization
from discostorm.wifi import PAPER, Model, Wifi

#: A message counts as sent at a time that misses its instant by rounding alone [periods].
_ROUNDING = 1e-9

#: One divided by the window [1/s]: unlike the window itself, it is finite for all time.
_SHARE = sp.Symbol("share_W", nonnegative=True)

#: The window that the paper divides by [s] (Sec. IV-B).
PAPER_WINDOW = 1.0

#: Airtime of a burst [s], and the utilization of the traffic that stays [1].
BURST, STEADY = sp.symbols("B rho", nonnegative=True)

#: By when the channel has caught up with the burst [s].
DRAIN = sp.Piecewise((BURST / (1 - STEADY), STEADY < 1), (sp.oo, True))


@dataclass(frozen=True)
class Schedule:
    """When a message is sent: at some times after the start, and then with a period.

    Parameters
    ----------
    starts : tuple of float
        Times after the start [s], at least 0 and in order; the first no later than the
        period, and no two further apart.
    period : float
        Time between two later ones [s], above 0; infinity if none comes later.

    Raises
    ------
    ValueError
        If a time or the period is out of range, or the times are not in order.
    TypeError
        If the starts are not several times, or one is not a number.

    Examples
    --------
    >>> Schedule((0, 1, 3, 7), period=8).sent([0, 6.9, 15, 24])
    array([1., 3., 5., 6.])
    """

    starts: tuple[float, ...]
    period: float = np.inf

    def __post_init__(self) -> None:
        if not np.iterable(self.starts):
            raise TypeError(f"starts must be a tuple of times in seconds; got {self.starts!r}")
        object.__setattr__(self, "starts", tuple(self.starts))
        if not self.starts:
            raise ValueError("starts must hold at least one time in seconds; got none")
        for time in self.starts:
            _checks.number("starts", time, 0)
        if self.period != np.inf:
            _checks.number("period", self.period, 0, above=True)
        gaps = np.diff((0.0, *self.starts))
        if np.any(gaps < 0) or np.any(gaps > self.period):
            raise ValueError(
                "starts must be times in order, from zero on no further apart than the period "
                f"of {self.period:g} s; got {self.starts}"
            )

    def __str__(self) -> str:
        """Return the schedule in words.

        Examples
        --------
        >>> print(Schedule((0, 0.1), 8))
        at 0 and 0.1 s, then every 8 s
        """
        times = [f"{time:g}" for time in self.starts]
        before = ", ".join(times[:-1]) + " and " if len(times) > 1 else ""
        if self.period == np.inf:
            return f"at {before}{times[-1]} s" if len(times) > 1 else f"once, at {times[-1]} s"
        return f"at {before}{times[-1]} s, then every {self.period:g} s"

    @property
    def per_second(self) -> float:
        """How many are sent a second in the long run [1/s]."""
        return 1 / self.period

    @property
    def extra(self) -> float:
        r"""How many the start sends beyond those of the period [1].

        With K times at the start, the last at :math:`t_K`, and period P, the number sent
        until t is at most :math:`K - t_K / P + t / P`. The part that does not grow is
        the extra; the bound is met each time the message has just been sent with its period.
        """
        return len(self.starts) - self.starts[-1] / self.period

    def sent(self, time: ArrayLike) -> Value:
        """Return how many are sent from 0 up to and including a time.

        Parameters
        ----------
        time : array_like
            Time after the start [s], at least 0.

        Returns
        -------
        float or ndarray
            How many [1].

        Raises
        ------
        ValueError
            If a time is NaN, infinite or negative.
        TypeError
            If it is not made of real numbers.
        """
        now = np.asarray(_checks.numbers("time", time, 0))
        count = np.searchsorted(self.starts, now * (1 + _ROUNDING), side="right").astype(float)
        rounds = np.floor((now - self.starts[-1]) / self.period + _ROUNDING)
        count += np.maximum(rounds, 0)
        return count if count.ndim else count.item()

    def times(self, until: float) -> NDArray[np.float64]:
        """Return the times up to `until` at which the message is sent [s]."""
        last = self.starts[-1]
        rounds = max(0, int((until - last) / self.period + _ROUNDING))
        later = last + self.period * np.arange(1, rounds + 1) if rounds else np.empty(0)
        times = np.concatenate([np.array(self.starts, dtype=float), later])
        return times[times <= until * (1 + _ROUNDING)]


#: Sent at the start and never again.
ONCE = Schedule((0.0,))


@dataclass(frozen=True)
class Timed:
    """A message and when it is sent; `per_unit` of the message are sent at each time."""

    message: Message
    schedule: Schedule

    def __post_init__(self) -> None:
        _checks.instance("message", self.message, Message)
        _checks.instance("schedule", self.schedule, Schedule)


@dataclass(frozen=True)
class Product:
    """A middleware: its messages, each with its schedule, and its lease.

    Parameters
    ----------
    name : str
        What to call it in tables and figures.
    lease : float
        How long a silent peer counts as alive [s], above 0.
    rows : tuple of Timed
        Its messages; some must be sent more at the start than later, some with a period.

    Raises
    ------
    ValueError
        If the lease is out of range, or such messages are missing.
    TypeError
        If the lease is not a number, or `rows` hold anything else.
    """

    name: str
    lease: float
    rows: tuple[Timed, ...]

    def __post_init__(self) -> None:
        _checks.number("lease", self.lease, 0, above=True)
        object.__setattr__(self, "rows", _checks.members("rows", self.rows, Timed))
        for what, some in {
            "more at the start than later": any(row.schedule.extra for row in self.rows),
            "with a finite period": any(row.schedule.per_second for row in self.rows),
        }.items():
            if not some:
                raise ValueError(f"rows must hold a message that is sent {what}; got none")

    def over(self, window: float) -> Protocol:
        r"""Return the messages of an average second of the first `window` seconds.

        For each unit :math:`x / W + 1 / P` are sent: the extra of the start divided by the
        window, and the rate of the period. The utilization of this table is

        .. math:: U_W = \frac{B}{W} + \rho

        with the airtime B of the `burst` and the utilization :math:`\rho` of the `steady`
        traffic. It is 1 when the window is just as long as the start-up lasts, see
        `drain_time`; in the paper the window is one second.

        Parameters
        ----------
        window : float
            Length of the window [s], above 0; infinity for the traffic that stays.

        Returns
        -------
        Protocol
            A table whose counts are a second's.

        Raises
        ------
        ValueError
            If `window` is NaN, zero or negative.
        TypeError
            If it is not a real number.

        Examples
        --------
        >>> round(utilization(FAST_DDS.over(20), hosts=22, processes=2, endpoints=10), 3)
        1.011
        """
        if window != np.inf:
            window = _checks.number("window", window, 0, above=True)
        return self._table(
            f"{self.name} over {window} s",
            {row: row.schedule.extra * (1 / window) + row.schedule.per_second for row in self.rows},
        )

    def burst(self) -> Protocol:
        """Return what the start sends beyond the traffic that stays.

        The utilization of this table is the burst's airtime in seconds. Messages that are
        only sent with their period are not in it.
        """
        return self._table(f"{self.name} burst", {row: row.schedule.extra for row in self.rows})

    def steady(self) -> Protocol:
        """Return the messages of a second long after the start."""
        return self.over(np.inf)

    def _table(self, name: str, times: dict[Timed, Any]) -> Protocol:
        return Protocol(
            name,
            tuple(
                replace(row.message, per_unit=row.message.per_unit * count)
                for row, count in times.items()
                if count != 0
            ),
        )


def drain_time(
    product: Product,
    hosts: ArrayLike,
    processes: ArrayLike,
    endpoints: ArrayLike,
    wifi: Wifi = PAPER,
) -> Value:
    r"""Return by when the channel has caught up with the start.

    .. math:: t = \frac{B}{1 - \rho}

    B is the airtime of the burst, :math:`\rho` the utilization of the traffic that stays.
    It is a bound: `first_idle` tells when the channel really has, with each repeated message
    sent at its own instant, and is never later.

    Parameters
    ----------
    product : Product
        `FAST_DDS`, `CYCLONE_DDS`, `ZENOH_PEER`, or a table of your own.
    hosts : array_like
        Hosts in the network [1], from 1 to 1e9.
    processes : array_like
        Processes on each host [1], from 1 to 1e9.
    endpoints : array_like
        Endpoints of each process [1], from 0 to 1e9.
    wifi : Wifi, optional
        The channel; the paper's if left out.

    Returns
    -------
    float or ndarray
        Time after the start [s]; infinity where the traffic that stays fills the channel.

    Raises
    ------
    ValueError
        If an argument is NaN, infinite or out of range, or the shapes do not broadcast.
    TypeError
        If an argument is not made of real numbers, or `product` is not one.

    References
    ----------
    Airtime: paper, equations (11) and (12). Periods: ``data/vendors/middleware_defaults.csv``.

    Examples
    --------
    >>> from discostorm import timeline
    >>> timeline.drain_time(timeline.FAST_DDS, [3, 12, 60], 2, 10).round(2)
    array([0.22, 4.7 ,  inf])
    """
    _checks.instance("product", product, Product)
    burst = np.asarray(utilization(product.burst(), hosts, processes, endpoints, wifi))
    steady = np.asarray(utilization(product.steady(), hosts, processes, endpoints, wifi))
    with np.errstate(divide="ignore"):  # NumPy computes both branches
        return evaluate(DRAIN, {BURST: burst, STEADY: steady})


@cache
def _critical(product: Product, model: Model) -> sp.Expr:
    tables = (product.burst(), product.steady())
    burst, steady = (table.utilization(model=model) for table in tables)
    return solve_hosts(burst * _SHARE + steady)


def critical_hosts(
    product: Product,
    processes: ArrayLike,
    endpoints: ArrayLike,
    window: ArrayLike = np.inf,
    wifi: Wifi = PAPER,
) -> Value:
    r"""Return the number of hosts whose start-up lasts just as long as a window.

    It solves :math:`B / W + \rho = 1` for :math:`N_H`. With the lease as window, a larger
    swarm cannot be sure to finish before peers that had no turn count as lost; with an
    infinite one, the traffic that stays fills the channel.

    Parameters
    ----------
    product, processes, endpoints, wifi
        As for `drain_time`.
    window : array_like, optional
        Length of the window W [s], above 0; infinity if left out.

    Returns
    -------
    float or ndarray
        Hosts [1], a real number of at least 1.

    Raises
    ------
    ValueError
        If an argument is NaN or out of range, or a single host already fills the window.
    TypeError
        If an argument is not made of real numbers, or `product` is not one.

    References
    ----------
    As for `drain_time`; the closed form is `discostorm.scalability.solve_hosts`.

    Examples
    --------
    >>> from discostorm import timeline
    >>> round(timeline.critical_hosts(timeline.FAST_DDS, 2, 10, window=20), 2)
    21.88
    """
    alone = drain_time(product, 1, processes, endpoints, wifi)
    if np.any(np.isinf(alone)):
        raise ValueError(
            f"processes and endpoints must be so few that the traffic of a single host with "
            f"{product.name} does not fill the channel for ever"
        )
    share = _per_second(window)
    _checks.shape(processes=processes, endpoints=endpoints, window=share)
    short = np.greater(np.multiply(alone, share), 1)
    if short.any():
        needed, given_window = _checks.first_where(short, alone, window)
        raise ValueError(
            "window must be at least as long as the start of a single host, "
            f"{needed:g} s; got {given_window:g}"
        )
    swarm = HostGroup(1, processes, endpoints)
    given = {nt.N_P: swarm.processes, nt.N_E: swarm.endpoints, nt.U_LIMIT: 1.0, _SHARE: share}
    values = product.burst().values() | product.steady().values() | wifi.values()
    return evaluate(_critical(product, wifi.model), given | values)


def _per_second(window: ArrayLike) -> Value:
    """Return one divided by a window [1/s], which is zero if it is infinite."""
    longest = np.asarray(window) == np.inf
    finite = np.where(longest, 1.0, window) if longest.any() else window
    return np.where(longest, 0.0, 1 / np.asarray(_checks.numbers("window", finite, 0, above=True)))


def demand(
    product: Product,
    time: ArrayLike,
    hosts: ArrayLike,
    processes: ArrayLike,
    endpoints: ArrayLike,
    wifi: Wifi = PAPER,
) -> Value:
    """Return the airtime of all that is sent from the start up to a time.

    Parameters
    ----------
    product, hosts, processes, endpoints, wifi
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
        If an argument is not made of real numbers, or `product` is not one.

    References
    ----------
    As for `drain_time`.

    Examples
    --------
    >>> from discostorm import timeline
    >>> timeline.demand(timeline.FAST_DDS, [0, 3.4, 3.5], 3, 2, 10).round(4)
    array([0.1495, 0.2245, 0.2395])
    """
    _checks.instance("product", product, Product)
    _checks.shape(time=time, hosts=hosts, processes=processes, endpoints=endpoints)
    together: dict[Schedule, tuple[Message, ...]] = {}
    for row in product.rows:
        together[row.schedule] = (*together.get(row.schedule, ()), row.message)
    total: Value = 0.0
    for schedule, messages in together.items():
        each = utilization(Protocol(product.name, messages), hosts, processes, endpoints, wifi)
        total = total + each * schedule.sent(time)
    return total


def first_idle(
    product: Product,
    hosts: float,
    processes: float,
    endpoints: float,
    wifi: Wifi = PAPER,
) -> float:
    """Return when the channel falls silent for the first time after the start.

    Parameters
    ----------
    product, hosts, processes, endpoints, wifi
        As for `drain_time`, but one swarm: numbers, not arrays.

    Returns
    -------
    float
        Time after the start [s]; zero if nothing is sent at once, infinity if the traffic
        that stays fills the channel.

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
    >>> from discostorm import timeline
    >>> round(timeline.first_idle(timeline.FAST_DDS, 12, 2, 10), 2)
    4.61
    """
    _checks.one_each(zip(COUNTS, (hosts, processes, endpoints), strict=True))
    bound = drain_time(product, hosts, processes, endpoints, wifi)
    if bound == np.inf:
        return np.inf
    times = np.unique(np.concatenate([row.schedule.times(float(bound)) for row in product.rows]))
    if not times.size or times[0] > 0:
        return 0.0
    carried = np.asarray(demand(product, times, hosts, processes, endpoints, wifi))
    following = np.append(times[1:], np.inf)
    return float(carried[np.argmax(carried <= following)])


#: What `outlook` says, from best to worst.
OUTLOOKS = ("within a second", "starts slowly", "leases at risk", "never recovers")


def outlook(
    product: Product,
    hosts: float,
    processes: float,
    endpoints: float,
    wifi: Wifi = PAPER,
) -> str:
    """Return in words how the start of a swarm ends.

    Parameters
    ----------
    product, hosts, processes, endpoints, wifi
        As for `drain_time`, but one swarm: numbers, not arrays.

    Returns
    -------
    str
        "within a second" if the burst is carried in the paper's one second; "starts slowly"
        if it is carried within the lease; "leases at risk" if it takes longer, so that
        peers may be dropped and the burst be sent again before it was carried; "never
        recovers" if the traffic that stays fills the channel.

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
    >>> from discostorm import timeline
    >>> timeline.outlook(timeline.ZENOH_PEER, 12, 2, 10)
    'starts slowly'
    """
    _checks.one_each(zip(COUNTS, (hosts, processes, endpoints), strict=True))
    time = drain_time(product, hosts, processes, endpoints, wifi)
    limits = (PAPER_WINDOW, product.lease, np.inf)
    return OUTLOOKS[int(np.searchsorted(limits, time))] if time < np.inf else OUTLOOKS[-1]


def defaults(product: str) -> dict[str, float]:
    """Return a product's default periods, leases, counts and sizes by the name of the quantity.

    Parameters
    ----------
    product : str
        "Fast DDS", "Cyclone DDS" or "Zenoh".

    Returns
    -------
    dict
        Values in seconds, bytes or 1; the data file ``middleware_defaults.csv`` tells the
        unit, meaning and source of each.

    Raises
    ------
    ValueError
        If there is no such product.

    Examples
    --------
    >>> defaults("Zenoh")["lease"]
    10.0
    """
    rows = read_data("vendors/middleware_defaults.csv")
    known = dict.fromkeys(row["product"] for row in rows)
    if product not in known:
        names = " or ".join(repr(name) for name in known)
        raise ValueError(f"product must be {names}; got {product!r}")
    return {row["quantity"]: float(row["value"]) for row in rows if row["product"] == product}


def _message(protocol: Protocol, name: str, /, **changes: Any) -> Message:
    (message,) = (message for message in protocol.messages if message.name == name)
    return replace(message, **changes)


#: The SEDP phase: without losses, each message of the paper's table is sent once.
_SEDP = tuple(Timed(message, ONCE) for message in DDS.of_phase("SEDP"))


def _fast_dds() -> Product:
    value = defaults("Fast DDS")
    quick = int(value["initial_announcements"])
    starts = tuple(n * value["initial_period"] for n in range(quick + 1))
    announcement = Schedule(starts, value["announcement_period"])
    copy = _message(
        DDS,
        "SPDP",
        name="UnicastSPDP",
        cast="unicast",
        unit=PAIR,
        per_unit=value["unicast_copies"],
    )
    return Product(
        "Fast DDS",
        value["lease"],
        (Timed(_message(DDS, "SPDP"), announcement), Timed(copy, announcement), *_SEDP),
    )


def _cyclone_dds() -> Product:
    value = defaults("Cyclone DDS")
    lease = value["lease"]
    announcement = Schedule(
        (0.0, value["second_announcement"]),
        min(value["spdp_interval"], lease - value["spdp_margin"]),
    )
    replies = range(int(value["directed_replies"]))
    alive = Schedule((0.0,), lease - value["liveliness_margin"])
    size = value["liveliness_payload"]
    assertion = Message(
        "Liveliness",
        "Liveliness",
        "unicast",
        "UDP",
        Payload(size, size, size, "data/vendors/middleware_defaults.csv, liveliness_payload"),
        PAIR,
        1,
    )
    return Product(
        "Cyclone DDS",
        lease,
        (
            Timed(_message(DDS, "SPDP"), announcement),
            Timed(
                _message(DDS, "SPDP", name="DirectedSPDP", cast="unicast", unit=PAIR),
                Schedule(tuple(n * value["directed_period"] for n in replies)),
            ),
            *_SEDP,
            Timed(assertion, alive),
            Timed(
                _message(DDS, "ACKNACK", name="LivelinessACK", phase="Liveliness", per_unit=1),
                alive,
            ),
        ),
    )


def _zenoh() -> Product:
    value = defaults("Zenoh")
    gap = value["scout_first"]
    starts = [0.0]
    while gap < value["scout_most"]:
        starts.append(starts[-1] + gap)
        gap *= value["scout_factor"]
    scouting = Schedule(tuple(starts), value["scout_most"])
    keep_alive = value["lease"] / value["keep_alives"]
    return Product(
        "Zenoh",
        value["lease"],
        (
            Timed(_message(ZENOH, "Scout"), scouting),
            Timed(_message(ZENOH, "Hello", per_unit=value["hellos"]), scouting),
            Timed(_message(ZENOH, "Declare"), ONCE),
            # One each way, the first after a period of silence.
            Timed(_message(ZENOH, "KeepAlive", per_unit=1), Schedule((keep_alive,), keep_alive)),
        ),
    )


FAST_DDS = _fast_dds()
#: Fast DDS if it announced itself by multicast alone, as the paper counts SPDP.
FAST_DDS_MULTICAST = Product(
    "Fast DDS, multicast only",
    FAST_DDS.lease,
    tuple(row for row in FAST_DDS.rows if row.message.name != "UnicastSPDP"),
)
CYCLONE_DDS = _cyclone_dds()
ZENOH_PEER = _zenoh()

#: The three products with their defaults.
PRODUCTS = (FAST_DDS, CYCLONE_DDS, ZENOH_PEER)
