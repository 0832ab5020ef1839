"""A protocol: its table of messages, and the load and utilization that follow from it."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Literal, get_args

import numpy as np
import sympy as sp

from discostorm import _checks
from discostorm._numeric import plain
from discostorm.fleet import SWARM, Fleet
from discostorm.messages.message import HEADER_SYMBOLS, Message, header_bytes
from discostorm.messages.schedule import PAPER_WINDOW, Schedule, checked_window
from discostorm.messages.units import OnAir, Unit
from discostorm.wifi import Model

#: The kin of a protocol: which remedies work for it, and how it repairs what is lost.
Family = Literal["DDS", "Zenoh"]

#: Where the counts of a table are from: the paper; the paper, with the times of a product; a
#: product, measured as shipped; a product, measured as arranged against the storm; a proposal.
Basis = Literal["paper", "timed", "measured", "mitigated", "proposal"]


@dataclass(frozen=True)
class Timers:
    """When a middleware sends again what its table does not repeat; the simulator needs them.

    Parameters
    ----------
    announce_interval_initial, announce_interval_max : float, optional
        Time from an announcement to the next [s], doubled each time up to the most, if the table
        has announcements at the start alone. 0, as if left out: they are not repeated.
    heartbeat_period_initial, heartbeat_period_max : float, optional
        Time from a heartbeat to the next [s] while data are not acknowledged, doubled each time up
        to the most; 1 if left out.

    Raises
    ------
    ValueError
        If a time is out of range, or a first one above its most.
    TypeError
        If one is not a number.

    Examples
    --------
    >>> import discostorm as ds
    >>> ds.ZENOH.timers.announce_interval_max
    8.0
    """

    announce_interval_initial: float = 0.0
    announce_interval_max: float = 0.0
    heartbeat_period_initial: float = 1.0
    heartbeat_period_max: float = 1.0

    def __post_init__(self) -> None:
        _checks.plain_numbers(self)
        for interval, above in (("announce_interval", False), ("heartbeat_period", True)):
            first, most = f"{interval}_initial", f"{interval}_max"
            _checks.number(most, getattr(self, most), 0, _checks.MOST_SECONDS, above=above)
            _checks.number(first, getattr(self, first), 0, getattr(self, most), above=above)


@dataclass(frozen=True)
class Protocol:
    """A discovery protocol: a name, its table of messages, its lease and whose it is.

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
    family : {"DDS", "Zenoh"}, optional
        The kin of the protocol, which decides on remedies; None if it is of neither.
    product : str, optional
        The product whose defaults it has, such as "Fast DDS"; None if it is no product's.
    basis : {"paper", "timed", "measured", "mitigated", "proposal"}, optional
        Where its counts are from: the paper; the paper, with the times of a product; a product,
        measured as shipped; the same, arranged against the storm; a proposal. None of your own.
    timers : Timers, optional
        When it sends again what the table does not repeat; needed to simulate recovery.
    captured : tuple of int, optional
        The most hosts, processes of all and endpoints of a process that it was measured with [1];
        not always of the same run. None if it was not fitted to captures.
    key : str, optional
        What data files call it: simulations, prediction errors, remedies. None for a table of your
        own, and for a copy whose messages or timers you change.

    Raises
    ------
    ValueError
        If there is no message, two have the same name, the lease is out of range, or `family` or
        `basis` is none of the above.
    TypeError
        If a name is not text, one is not a Message, the lease not a number, or `timers` not
        Timers.
    """

    name: str
    messages: tuple[Message, ...]
    lease: float = np.inf
    wired: "Protocol | None" = None
    family: Family | None = None
    product: str | None = None
    basis: Basis | None = None
    timers: Timers | None = None
    captured: tuple[int, int, int] | None = None
    key: str | None = None

    def __post_init__(self) -> None:
        _checks.instance("name", self.name, str)
        if not self.name.strip():
            raise ValueError(f"name must be a text that is not blank; got {self.name!r}")
        if self.wired is not None:
            _checks.instance("wired", self.wired, Protocol)
        for name, known in (("family", Family), ("basis", Basis)):
            if getattr(self, name) is not None:
                _checks.choice(name, getattr(self, name), get_args(known), ", or None")
        for name, kind in (("product", str), ("timers", Timers), ("key", str)):
            if getattr(self, name) is not None:
                _checks.instance(name, getattr(self, name), kind)
        if self.captured is not None:
            object.__setattr__(self, "captured", _checks.members("captured", self.captured, int))
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
        span = checked_window(window)
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
        span = checked_window(window)
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

    def costs_by_hop(
        self,
        phase: str | None = None,
        model: Model = "linear",
        window: sp.Expr | float = PAPER_WINDOW,
    ) -> dict[OnAir, sp.Expr]:
        """Return `cost` of each hop apart, for fleets with wired hosts [s]."""
        span = checked_window(window)
        return self._by_hop(phase, model, lambda schedule: schedule.mean(span))

    def _by_hop(
        self, phase: str | None, model: Model, times: Callable[[Schedule], Any]
    ) -> dict[OnAir, sp.Expr]:
        costs: dict[OnAir, sp.Expr] = {}
        for message in self.of_phase(phase):
            sent = message.per_unit * times(message.schedule)
            for hop in message.hops:
                counted = message.on_air(hop)
                costs[counted] = costs.get(counted, 0) + sent * message.airtime_of(hop, model)
        return costs

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
        span = checked_window(window)
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
        if fleet.has_wired:
            by_hop = self._by_hop(phase, model, times)
            return sp.Add(*(on_air.count(fleet) * cost for on_air, cost in by_hop.items()))
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
            HEADER_SYMBOLS[message.transport]: float(headers[message.transport])
            for message in self.messages
        }
