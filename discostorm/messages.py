"""A discovery protocol is a table of messages; its load and utilization follow from it."""

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cache
from typing import Any, Literal, get_args

import numpy as np
import sympy as sp
from numpy.typing import ArrayLike, NDArray

from discostorm import _checks, notation as nt
from discostorm._numeric import Value, plain
from discostorm.data import read_data
from discostorm.fleet import SWARM, Count, Fleet, Hosts
from discostorm.wifi import Cast, Model, bits_airtime, downlink_airtime, uplink_airtime

#: Fewest messages for each unit [1].
LEAST_PER_UNIT = 1e-9

Transport = Literal["UDP", "TCP"]

#: From a host to the access point, and from there on.
Hop = Literal["up", "down"]
HOPS: tuple[Hop, ...] = ("up", "down")

#: The window that the paper divides by [s] (Sec. IV-B).
PAPER_WINDOW = 1.0

#: A message counts as sent at a time that misses its instant by rounding alone [periods].
_ROUNDING = 1e-9

#: Most periods that `Schedule.times` goes through.
_MOST_ROUNDS = 1e8


#: Takes the hosts one by one, returns a number for each of their processes.
OfProcesses = Callable[[Hosts], NDArray[Any]]


@dataclass(frozen=True)
class Unit:
    """What a message is sent once, twice or more for; a fleet says how many there are.

    Who sends and who receives matters to those who name each message, such as `simulate`.
    The sum of the senders' numbers, for pairs over the receivers on other hosts, is the count.

    Parameters
    ----------
    name : str
        What one of them is called.
    count : callable
        Takes a `Fleet`, returns how many of them it has [1].
    senders : callable, optional
        Takes `discostorm.fleet.Hosts`, returns for each process how many of them it sends for
        [1]: in all, or to each receiver.
    receivers : callable, optional
        Takes the same, returns 1 for each process that receives from each on another host, else
        0. None if it is no unit of pairs: what is sent for it is for all, or for a peer that is
        wired to the access point.
    """

    name: str
    # How a function is shown has its address in it, which is another one each time.
    count: Callable[[Fleet], Count] = field(repr=False)
    senders: OfProcesses | None = field(default=None, repr=False)
    receivers: OfProcesses | None = field(default=None, repr=False)

    def __post_init__(self) -> None:
        _checks.instance("name", self.name, str)
        if not callable(self.count):
            raise TypeError(
                f"count must take a Fleet and return how many; got {_checks.short(self.count)}"
            )
        for side in ("senders", "receivers"):
            if not (getattr(self, side) is None or callable(getattr(self, side))):
                raise TypeError(
                    f"{side} must take Hosts and return a number for each process; "
                    f"got {getattr(self, side)!r}"
                )


def _every(hosts: Hosts) -> NDArray[Any]:
    return hosts.every


def _speakers(hosts: Hosts) -> NDArray[Any]:
    return hosts.speakers


def _endpoints(hosts: Hosts) -> NDArray[Any]:
    return hosts.endpoints_of


def _others(hosts: Hosts) -> NDArray[Any]:
    return hosts.every * (hosts.every.size - 1)


def _thirds(hosts: Hosts) -> NDArray[Any]:
    return hosts.every * (hosts.every.size - 2)


def _endpoint_thirds(hosts: Hosts) -> NDArray[Any]:
    return hosts.endpoints_of * (hosts.every.size - 2)


def _matched(hosts: Hosts) -> NDArray[Any]:
    return hosts.matched_of / 2


def _unmatched(hosts: Hosts) -> NDArray[Any]:
    return hosts.endpoints_of - hosts.matched_of


def _of_kinds(hosts: Hosts) -> NDArray[Any]:
    return hosts.endpoints_of * hosts.of_first_hosts


def _once(hosts: Hosts) -> NDArray[Any]:
    return np.eye(1, hosts.every.size, dtype=np.int64).ravel()


def _endpoint_processes(hosts: Hosts) -> NDArray[Any]:
    return hosts.endpoints_of * (hosts.every.size - 1)


def _listed(hosts: Hosts) -> NDArray[Any]:
    return hosts.endpoints_of * (hosts.endpoints_of + 1) / 2


def _if_matched(hosts: Hosts) -> NDArray[Any]:
    return hosts.every * hosts.matches


def _matched_others(hosts: Hosts) -> NDArray[Any]:
    return _others(hosts) * hosts.matches


def _matched_endpoints(hosts: Hosts) -> NDArray[Any]:
    return hosts.matched_of * (hosts.every.size - 1)


def _away(hosts: Hosts) -> NDArray[Any]:
    away: NDArray[Any] = hosts.every * (hosts.host_of > 0)
    return away


def _endpoints_away(hosts: Hosts) -> NDArray[Any]:
    away: NDArray[Any] = hosts.endpoints_of * (hosts.host_of > 0)
    return away


def _matched_others_away(hosts: Hosts) -> NDArray[Any]:
    others: NDArray[Any] = _matched_others(hosts) * _away(hosts)
    return others


def _matched_endpoints_away(hosts: Hosts) -> NDArray[Any]:
    others = hosts.matched_of.sum() - hosts.matched_of
    passed: NDArray[Any] = others * _away(hosts)
    return passed


def _matched_behind(hosts: Hosts) -> NDArray[Any]:
    return hosts.speakers * hosts.matched_of


def _floods(hosts: Hosts) -> NDArray[Any]:
    others = hosts.processes.size - 1
    return hosts.speakers * (others * (others - 1))


PROCESS = Unit("process", Fleet.processes, _every)
PAIR = Unit("ordered pair of processes on different hosts", Fleet.pairs, _every, _every)
ENDPOINT_PAIR = Unit(
    "endpoint and process on another host", Fleet.endpoint_pairs, _endpoints, _every
)
ENDPOINT = Unit("endpoint", Fleet.endpoints, _endpoints)
#: For what each process sends to the group for each of the others, wherever they run.
PROCESS_PAIR = Unit("ordered pair of processes", Fleet.process_pairs, _others)
#: For what a third process occasions between two.
THIRD = Unit(
    "ordered pair of processes on different hosts and third process",
    Fleet.thirds,
    _thirds,
    _every,
)
ENDPOINT_THIRD = Unit(
    "endpoint, process on another host and third process",
    Fleet.endpoint_thirds,
    _endpoint_thirds,
    _every,
)
MATCHED_WRITER = Unit(
    "matched writer and process on another host", Fleet.matched_writers, _matched, _every
)
HOST = Unit("host", Fleet.hosts, _speakers)
HOST_PAIR = Unit("ordered pair of hosts", Fleet.host_pairs, _speakers, _speakers)
#: For what is sent once, however many hosts run the same software.
KIND_ENDPOINT = Unit("endpoint of a kind of host", Fleet.kinds_endpoints, _of_kinds)
#: For what the whole fleet sends once.
FLEET = Unit("fleet", Fleet.once, _once)
UNMATCHED = Unit(
    "unmatched endpoint and process on another host", Fleet.unmatched, _unmatched, _every
)
ENDPOINT_PROCESS = Unit("endpoint and other process", Fleet.endpoint_processes, _endpoint_processes)
#: For a list of the endpoints that are made so far, told each time that one is made.
LISTED = Unit("two endpoints of a process, or one twice", Fleet.lists, _listed)
LISTED_PAIR = Unit(
    "two endpoints of a process, or one twice, and process on another host",
    Fleet.list_pairs,
    _listed,
    _every,
)
UNMATCHED_ENDPOINT = Unit("unmatched endpoint", Fleet.unmatched_endpoints, _unmatched)
WRITER = Unit("matched writer", Fleet.writers_that_match, _matched)
#: For what routers, one a host, tell each other of what is behind them.
PROCESS_HOST = Unit("process and other host", Fleet.process_hosts, _every, _speakers)
ENDPOINT_HOST = Unit("endpoint and other host", Fleet.endpoint_hosts, _endpoints, _speakers)
UNMATCHED_HOST = Unit(
    "unmatched endpoint and other host", Fleet.unmatched_hosts, _unmatched, _speakers
)
MATCHED_HOST = Unit(
    "matched endpoint of a host and other host", Fleet.matched_hosts, _matched_behind, _speakers
)
#: For the news of a link that each router passes on to all others.
FLOOD = Unit(
    "end of a link, host that hears of it and other that it tells", Fleet.floods, _floods, _speakers
)
#: For what a server passes on from one to another, wherever they run.
MATCHED_PROCESS_PAIR = Unit(
    "ordered pair of matched processes", Fleet.matched_process_pairs, _matched_others
)
MATCHED_PAIR = Unit(
    "ordered pair of matched processes on different hosts", Fleet.matched_pairs, _if_matched, _every
)
MATCHED_ENDPOINT = Unit(
    "matched endpoint and other process", Fleet.matched_endpoints, _matched_endpoints
)
#: Of a server on a host of the first group: what is on that host takes no air on its way to it.
#: Who simulates these takes the first host, and has both ways sent by who is away.
AWAY = Unit("process away from the server", Fleet.away, _away, _once)
ENDPOINT_AWAY = Unit("endpoint away from the server", Fleet.endpoints_away, _endpoints_away, _once)
MATCHED_PROCESS_PAIR_AWAY = Unit(
    "ordered pair of matched processes, one away from the server",
    Fleet.matched_process_pairs_away,
    _matched_others_away,
    _once,
)
MATCHED_ENDPOINT_AWAY = Unit(
    "matched endpoint and other process away from the server",
    Fleet.matched_endpoints_away,
    _matched_endpoints_away,
    _once,
)

#: All of them by name.
UNITS = {
    unit.name: unit
    for unit in (
        PROCESS,
        PAIR,
        ENDPOINT_PAIR,
        ENDPOINT,
        PROCESS_PAIR,
        THIRD,
        ENDPOINT_THIRD,
        MATCHED_WRITER,
        UNMATCHED,
        HOST,
        HOST_PAIR,
        KIND_ENDPOINT,
        FLEET,
        ENDPOINT_PROCESS,
        LISTED,
        LISTED_PAIR,
        UNMATCHED_ENDPOINT,
        WRITER,
        PROCESS_HOST,
        ENDPOINT_HOST,
        UNMATCHED_HOST,
        MATCHED_HOST,
        FLOOD,
        MATCHED_PROCESS_PAIR,
        MATCHED_PAIR,
        MATCHED_ENDPOINT,
        AWAY,
        ENDPOINT_AWAY,
        MATCHED_PROCESS_PAIR_AWAY,
        MATCHED_ENDPOINT_AWAY,
    )
}


@dataclass(frozen=True)
class Payload:
    """Payload size of a message: nominal value, range and where they come from.

    Parameters
    ----------
    nominal : float
        The size to compute with [B], from `low` to `high`.
    low, high : float
        The range of sizes [B], from 0 to 1e9.
    source : str
        Where the numbers come from.

    Raises
    ------
    ValueError
        If a size is NaN, infinite or out of range.
    TypeError
        If a size is not one real number.
    """

    nominal: float
    low: float
    high: float
    source: str

    def __post_init__(self) -> None:
        low = _checks.number("low", self.low, 0, _checks.MOST_BYTES)
        high = _checks.number("high", self.high, low, _checks.MOST_BYTES)
        nominal = _checks.number("nominal", self.nominal, low, high)
        for name, value in (("nominal", nominal), ("low", low), ("high", high)):
            object.__setattr__(self, name, value)


def _window(window: sp.Expr | float) -> Any:
    """Return a window [s] in symbols, or as a number above zero."""
    if isinstance(window, sp.Expr) and window.free_symbols:
        return window
    span = np.inf if window is sp.oo else window
    return _checks.number("window", span, _checks.LEAST_SECONDS, endless=True)


@dataclass(frozen=True)
class Schedule:
    """When a message is sent: at some times after the start, and then with a period.

    Parameters
    ----------
    starts : tuple of float
        Times after the start [s], at least 0 and in order; the first no later than the
        period, and no two further apart.
    period : float
        Time between two later ones [s], at least 1e-9; infinity if none comes later.

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
            raise TypeError(
                f"starts must be a tuple of times in seconds; got {_checks.short(self.starts)}"
            )
        given = tuple(self.starts)
        starts = tuple(_checks.number("starts", time, 0, _checks.MOST_SECONDS) for time in given)
        if not starts:
            raise ValueError("starts must hold at least one time in seconds; got none")
        object.__setattr__(self, "starts", starts)
        period = _checks.number("period", self.period, _checks.LEAST_SECONDS, endless=True)
        object.__setattr__(self, "period", period)
        gaps = np.diff((0.0, *self.starts))
        if np.any(gaps < 0) or np.any(gaps > self.period):
            raise ValueError(
                "starts must be times in order, from zero on no further apart than the period "
                f"of {self.period:g} s; got {given}"
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

    def mean(self, window: Any) -> Any:
        """Return how many are sent in an average second of the first `window` seconds [1/s].

        As an upper bound, see `extra`. The window may be a sympy expression [s].
        """
        span = _window(window)
        if isinstance(span, sp.Expr):
            return plain(self.extra) / span + plain(self.per_second)
        return plain(self.extra / span + self.per_second)

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
        with np.errstate(under="ignore"):
            later = now * (1 + _ROUNDING)
            rounds = np.floor((now - self.starts[-1]) / self.period + _ROUNDING)
        count = np.searchsorted(self.starts, later, side="right").astype(float)
        count += np.maximum(rounds, 0)
        return count if count.ndim else count.item()

    def times(self, until: float) -> NDArray[np.float64]:
        """Return the times up to `until` at which the message is sent [s]."""
        last = self.starts[-1]
        until = _checks.number("until", until, 0, last + _MOST_ROUNDS * self.period)
        rounds = max(0, int((until - last) / self.period + _ROUNDING))
        later = last + self.period * np.arange(1, rounds + 1) if rounds else np.empty(0)
        times = np.concatenate([np.array(self.starts, dtype=float), later])
        return times[times <= until * (1 + _ROUNDING)]


#: Sent at the start and never again.
ONCE = Schedule((0.0,))


@cache
def hop_airtime(hop: Hop, cast: Cast, framed: bool, octets: sp.Expr, model: Model) -> sp.Expr:
    """Return the airtime of a frame, or of octets inside of another frame, on a hop [s]."""
    if not framed:
        return bits_airtime(octets, "unicast" if hop == "up" else cast)
    return uplink_airtime(octets, model) if hop == "up" else downlink_airtime(octets, cast, model)


@dataclass(frozen=True)
class Message:
    """One row of a protocol's table.

    Parameters
    ----------
    name : str
        A field term, also the subscript of its payload symbol.
    phase : str
        The discovery phase it belongs to.
    cast : {"multicast", "unicast"}
        How the access point passes it on.
    transport : {"UDP", "TCP"}
        Decides the header bytes.
    payload : Payload
        Size without headers.
    unit : Unit
        What it is counted by.
    per_unit : float
        How many are sent for each unit [1], from 1e-9 to 1e9, each time the schedule names.
    schedule : Schedule, optional
        When they are sent; once, at the start, if left out.
    hops : tuple of {"up", "down"}, optional
        Which hops take the air; both if left out. A peer that is wired to the access
        point sends ``("down",)`` and receives ``("up",)``.
    answers : str, optional
        The message on whose arrival it is sent. None, or one that is not in the table, if
        the clock says so. Counts and airtime do not depend on it; what happens when does.
    frames : float, optional
        Its part of frames in the mean [1], from 1e-9 to 1e9: 1 if it has one of its own, less if
        several messages share one. Headers and channel access count with this part. 0 if it is
        always inside the frame of another row, and costs the air its bits alone.
    kind : str, optional
        What a capture calls it; its name if left out. Several rows may be of one kind.

    Raises
    ------
    ValueError
        If `cast`, `transport`, `per_unit`, `hops` or `frames` is none of the above.
    TypeError
        If a name is not text, `payload` not a Payload, `unit` not a Unit, or `schedule` not
        a Schedule.
    """

    name: str
    phase: str
    cast: Cast
    transport: Transport
    payload: Payload
    unit: Unit
    per_unit: float
    schedule: Schedule = ONCE
    hops: tuple[Hop, ...] = HOPS
    answers: str | None = None
    frames: float = 1.0
    kind: str = ""

    def __post_init__(self) -> None:
        for name in ("name", "phase", "kind"):
            _checks.instance(name, getattr(self, name), str)
        object.__setattr__(self, "kind", self.kind or self.name)
        _checks.plain_numbers(self)
        if _checks.number("frames", self.frames, 0, _checks.MOST) != 0:
            _checks.number("frames", self.frames, LEAST_PER_UNIT, _checks.MOST)
        _checks.choice("cast", self.cast, get_args(Cast))
        _checks.choice("transport", self.transport, get_args(Transport))
        _checks.instance("payload", self.payload, Payload)
        _checks.instance("unit", self.unit, Unit)
        _checks.number("per_unit", self.per_unit, LEAST_PER_UNIT, _checks.MOST)
        _checks.instance("schedule", self.schedule, Schedule)
        object.__setattr__(self, "hops", _checks.members("hops", self.hops, str))
        if not (0 < len(set(self.hops)) == len(self.hops) and set(self.hops) <= set(HOPS)):
            raise ValueError(f"hops must be 'up', 'down' or both, each once; got {self.hops}")
        if self.answers is not None:
            _checks.instance("answers", self.answers, str)

    @property
    def payload_symbol(self) -> sp.Symbol:
        """The symbol of its payload size [B]."""
        return nt.payload_symbol(self.name)

    @property
    def frame_symbolic(self) -> sp.Expr:
        """Its frame length [B] in symbols: payload and headers (paper, Sec. IV-A).

        Of messages that share frames, the mean length of these; of one inside the frame of
        another row, its payload.
        """
        if self.frames == 0:
            return self.payload_symbol
        return self.payload_symbol / plain(self.frames) + _HEADER_SYMBOLS[self.transport]

    @property
    def frame_bytes(self) -> float:
        """Its nominal frame length [B], as `frame_symbolic` has it."""
        if self.frames == 0:
            return self.payload.nominal
        return self.payload.nominal / self.frames + header_bytes()[self.transport]

    def load(self, fleet: Fleet = SWARM) -> Count:
        """Return how many are sent each time that the schedule names."""
        _checks.instance("fleet", fleet, Fleet)
        return self.per_unit * self.unit.count(fleet)

    def airtime_up(self, model: Model = "linear") -> sp.Expr:
        """Return the airtime of its part of a frame up to the access point [s]."""
        return self._airtime("up", model)

    def airtime_down(self, model: Model = "linear") -> sp.Expr:
        """Return the airtime of its part of a frame down from the access point [s]."""
        return self._airtime("down", model)

    def airtime(self, model: Model = "linear") -> sp.Expr:
        """Return the airtime of its part of a frame on all of its hops [s]."""
        return sp.Add(*(self._airtime(hop, model) for hop in self.hops))

    def _airtime(self, hop: Hop, model: Model) -> sp.Expr:
        _checks.choice("model", model, get_args(Model))
        part = plain(self.frames or 1.0)
        return part * hop_airtime(hop, self.cast, self.frames > 0, self.frame_symbolic, model)


_HEADER_SYMBOLS: dict[Transport, sp.Symbol] = {"UDP": nt.H_UDP, "TCP": nt.H_TCP}


@cache
def header_bytes() -> dict[str, int]:
    """Return the header bytes of each transport, added up from their parts [B]."""
    parts = read_data("paper/headers.csv")
    return {
        transport: sum(int(part["bytes"]) for part in parts if transport in part["transports"])
        for transport in _HEADER_SYMBOLS
    }


@dataclass(frozen=True)
class Protocol:
    """A discovery protocol: a name, its table of messages and its lease.

    Parameters
    ----------
    name : str
        What to call it in tables and figures.
    messages : tuple of Message
        At least one; their names differ.
    lease : float, optional
        How long a silent peer counts as alive [s], above 0; for ever if left out.
    wired : Protocol, optional
        The table of the same product on a network that it takes for wired, if it sends otherwise
        there. A capture is held against that one if it shows so.

    Raises
    ------
    ValueError
        If there is no message, two have the same name, or the lease is out of range.
    TypeError
        If the name is not text, one is not a Message, or the lease not a number.
    """

    name: str
    messages: tuple[Message, ...]
    lease: float = np.inf
    wired: "Protocol | None" = None

    def __post_init__(self) -> None:
        _checks.instance("name", self.name, str)
        if not self.name.strip():
            raise ValueError(f"name must be a text that is not blank; got {self.name!r}")
        if self.wired is not None:
            _checks.instance("wired", self.wired, Protocol)
        _checks.plain_numbers(self)
        _checks.number("lease", self.lease, 0, above=True, endless=True)
        object.__setattr__(self, "messages", _checks.members("messages", self.messages, Message))
        names = [message.name for message in self.messages]
        if len(set(names)) < len(names):
            raise ValueError(f"messages must have names that differ; got {', '.join(names)}")

    @property
    def phases(self) -> tuple[str, ...]:
        """The names of its phases, in order."""
        return tuple(dict.fromkeys(message.phase for message in self.messages))

    def of_phase(self, phase: str | None = None) -> tuple[Message, ...]:
        """Return the messages of a phase, or all of them.

        Raises
        ------
        ValueError
            If the protocol has no such phase.
        """
        if phase is not None:
            _checks.choice("phase", phase, self.phases, f" for {self.name}, or None")
        return tuple(message for message in self.messages if phase in (None, message.phase))

    @property
    def repeats(self) -> bool:
        """Whether it sends anything with a period."""
        return any(message.schedule.per_second for message in self.messages)

    def message(self, name: str) -> Message:
        """Return the message of that name.

        Raises
        ------
        ValueError
            If the protocol has no such message.
        """
        _checks.choice("name", name, [message.name for message in self.messages])
        return next(message for message in self.messages if message.name == name)

    def load(self, phase: str | None = None, window: sp.Expr | float = PAPER_WINDOW) -> sp.Expr:
        r"""Return the number of messages of an average second of the first ones.

        Each goes up and down again, unless its row says otherwise.

        Parameters
        ----------
        phase : str, optional
            One of `phases`; all of them if left out.
        window : float or sympy.Expr, optional
            How many seconds are averaged [s], at least 1e-9; the paper's one if left out.

        Returns
        -------
        sympy.Expr
            In ``N_H``, ``N_P`` and ``N_E``; paper, equations (2), (5), (7) and (10).

        Raises
        ------
        ValueError
            If the protocol has no such phase, or the window is out of range.

        Examples
        --------
        >>> import discostorm as ds
        >>> ds.DDS.load("SPDP")
        N_H*N_P
        """
        span = _window(window)
        return sp.factor(
            sum(message.schedule.mean(span) * message.load() for message in self.of_phase(phase))
        )

    def cost(
        self,
        unit: Unit,
        phase: str | None = None,
        model: Model = "linear",
        window: sp.Expr | float = PAPER_WINDOW,
    ) -> sp.Expr:
        """Return the airtime that each `unit` adds to an average second, up and down [s]."""
        span = _window(window)
        return self._cost(unit, phase, model, lambda schedule: schedule.mean(span))

    def _cost(
        self, unit: Unit, phase: str | None, model: Model, times: Callable[[Schedule], Any]
    ) -> sp.Expr:
        _checks.instance("unit", unit, Unit)
        return sp.Add(
            *(
                message.per_unit * times(message.schedule) * message.airtime(model)
                for message in self.of_phase(phase)
                if message.unit == unit
            )
        )

    def units(self, phase: str | None = None) -> tuple[Unit, ...]:
        """Return what the messages of a phase, or all, are counted by."""
        return tuple(dict.fromkeys(message.unit for message in self.of_phase(phase)))

    def utilization(
        self,
        phase: str | None = None,
        fleet: Fleet = SWARM,
        model: Model = "linear",
        window: sp.Expr | float = PAPER_WINDOW,
    ) -> sp.Expr:
        r"""Return the fraction of channel time that discovery takes of the first seconds.

        .. math:: U_\Phi = \sum_{\phi \in \Phi} \left(\frac{x_\phi}{W} + \frac{1}{P_\phi}\right)
            L_\phi (\mathcal{T}^{up}_\phi + \mathcal{T}^{down}_\phi)

        A message that is sent K times at the start, the last time at :math:`t_K`, and then
        with period P counts :math:`x = K - t_K / P` times besides its period. The paper's
        messages are sent once, in a window W of one second: :math:`x / W + 1 / P = 1`.

        Parameters
        ----------
        phase : str, optional
            One of `phases`; all of them if left out.
        fleet : Fleet, optional
            The paper's swarm if left out.
        model : {"linear", "padded", "aggregated"}, optional
            How a frame becomes airtime; the `model` of a `Wifi`.
        window : float or sympy.Expr, optional
            The seconds that are averaged [s], at least 1e-9; the paper's one if left out, infinity
            for the steady state.

        Returns
        -------
        sympy.Expr
            In all symbols of the notation; paper, equation (12).

        Raises
        ------
        ValueError
            If the protocol has no such phase, the window is out of range, or there is no
            such model.
        TypeError
            If `fleet` is not a Fleet, or the window not a number.
        """
        span = _window(window)
        return self._utilization(phase, fleet, model, lambda schedule: schedule.mean(span))

    def burst(
        self, phase: str | None = None, fleet: Fleet = SWARM, model: Model = "linear"
    ) -> sp.Expr:
        """Return the airtime [s] of what the start sends beyond the steady state.

        Messages that are only sent with their period are not in it. The parameters are
        those of `utilization`.
        """
        return self._utilization(phase, fleet, model, lambda schedule: plain(schedule.extra))

    def _utilization(
        self, phase: str | None, fleet: Fleet, model: Model, times: Callable[[Schedule], Any]
    ) -> sp.Expr:
        _checks.instance("fleet", fleet, Fleet)
        return sp.Add(
            *(
                unit.count(fleet) * self._cost(unit, phase, model, times)
                for unit in self.units(phase)
            )
        )

    def values(self) -> dict[sp.Symbol, float]:
        """Return the nominal value of each payload and header symbol [B]."""
        payloads = {message.payload_symbol: message.payload.nominal for message in self.messages}
        headers = header_bytes()
        return payloads | {
            _HEADER_SYMBOLS[message.transport]: float(headers[message.transport])
            for message in self.messages
        }
