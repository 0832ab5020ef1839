"""A protocol: its table of messages, and the load and utilization that follow from it."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from html import escape
from operator import methodcaller
from typing import TYPE_CHECKING, Any, Literal, TypeVar, get_args

import numpy as np
import sympy as sp

from discostorm import _checks
from discostorm._numeric import int_if_integral
from discostorm.fleet import PAPER_SWARM, Fleet
from discostorm.messages.message import HEADER_SYMBOLS, Hop, Message, header_bytes
from discostorm.messages.schedule import PAPER_WINDOW, Schedule, checked_window
from discostorm.messages.units import Unit
from discostorm.wifi import Model

if TYPE_CHECKING:
    import pandas as pd

#: A protocol's family decides which remedies work, and how the protocol recovers losses.
Family = Literal["DDS", "Zenoh"]

CostT = TypeVar("CostT", float, Any)

#: The source of a table's counts: the paper; the paper with a product's timers; a product measured
#: as shipped; a product measured in a configuration that sends less; a proposal.
Basis = Literal["paper", "timed", "measured", "mitigated", "proposal"]


@dataclass(frozen=True, repr=False)
class Timers:
    """A middleware's timers for messages without a schedule; the simulator needs them.

    An interval [s] is the time from an announcement to the next, doubled each time up to the
    maximum, if the table has announcements at startup alone; 0 if they are not repeated. A period
    [s] is the same for heartbeats while data are not acknowledged. A writer waits for
    ``nack_response_delay`` [s] before it answers a request, a reader for
    ``heartbeat_response_delay`` [s] before it answers a heartbeat. With a
    ``preemptive_acknack_delay`` [s] data are sent on request alone, if no server passes them on,
    and readers ask for heartbeats that have not come by then, each time
    ``preemptive_acknack_factor`` times later: 1 or 2. With a
    ``send_buffer`` [B] a repeated sample brings a heartbeat to all readers whenever the sums of
    all octets sent, one for each sample, exceed it; 0: never.
    """

    announce_interval_initial: float = 0.0
    announce_interval_max: float = 0.0
    heartbeat_period_initial: float = 1.0
    heartbeat_period_max: float = 1.0
    nack_response_delay: float = 0.0
    heartbeat_response_delay: float = 0.0
    preemptive_acknack_delay: float = 0.0
    preemptive_acknack_factor: float = 2.0
    send_buffer: float = 0.0

    def __post_init__(self) -> None:
        _checks.unwrap_0d_arrays(self)
        for interval, above in (("announce_interval", False), ("heartbeat_period", True)):
            most = _checks.MAX_SECONDS
            for name in (f"{interval}_max", f"{interval}_initial"):
                most = _checks.number(name, getattr(self, name), 0, most, exclusive_min=above)
        for name in ("nack_response", "heartbeat_response", "preemptive_acknack"):
            _checks.number(f"{name}_delay", getattr(self, f"{name}_delay"), 0, _checks.MAX_SECONDS)

    def __repr__(self) -> str:
        given = (f"{k}={v:g}" for k, v in vars(self).items() if v != getattr(Timers, k))
        return _checks.shorten_repr(f"Timers({', '.join(given)})")


@dataclass(frozen=True, repr=False)
class Protocol:
    """A discovery protocol: a name, its table of messages, its lease and its product.

    Parameters
    ----------
    name : str
        What to call it in tables and figures.
    messages : tuple of Message
        At least one; their names differ.
    lease : float, optional
        How long a silent peer counts as alive [s], above 0; indefinitely if left out.
    wired : Protocol, optional
        The table of the same product on a network that it takes for wired, if it differs. A
        capture is compared with that one if it shows so.
    family : {"DDS", "Zenoh"}, optional
        Decides which remedies work; None if it is of neither.
    product : str, optional
        The product whose defaults it has, such as "Fast DDS".
    basis : {"paper", "timed", "measured", "mitigated", "proposal"}, optional
        Where its counts are from; None for a table of your own.
    timers : Timers, optional
        Needed to simulate recovery.
    captured : tuple of int, optional
        The most hosts, processes in all and endpoints of a process that it was measured with [1],
        not always in the same run. None if it was not fitted to captures.
    key : str, optional
        The name of this table in data files: simulations, prediction errors, remedies. None for a
        table of your own, and for a copy whose messages or timers you change.
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
        _checks.nonblank("name", self.name)
        kinds = {"wired": Protocol, "product": str, "timers": Timers, "key": str}
        for name, kind in kinds.items():
            if getattr(self, name) is not None:
                _checks.instance(name, getattr(self, name), kind)
        for name, words in (("family", Family), ("basis", Basis)):
            if getattr(self, name) is not None:
                _checks.choice(name, getattr(self, name), get_args(words), ", or None")
        if self.captured is not None:
            object.__setattr__(self, "captured", _checks.tuple_of("captured", self.captured, int))
        _checks.unwrap_0d_arrays(self)
        _checks.number("lease", self.lease, 0, exclusive_min=True, allow_inf=True)
        object.__setattr__(self, "messages", _checks.tuple_of("messages", self.messages, Message))
        _checks.distinct("messages", [message.name for message in self.messages])

    def __repr__(self) -> str:
        lease = "" if self.lease == np.inf else f", a lease of {self.lease:g} s"
        count = f"{len(self.messages)} messages of {len(self.phases)} phases{lease}"
        return _checks.shorten_repr(f"<Protocol {self.name!r}: {count}>")

    def _repr_html_(self) -> str:
        return f"<p>{escape(repr(self))}</p>{self.table().to_html(index=False)}"

    def table(self) -> "pd.DataFrame":
        """Return a row for each message: name, phase, delivery, number, times, and payload [B]."""
        import pandas as pd  # here, as it would double the time of importing discostorm

        names = ("message", "phase", "cast", "over", "how many", "when", "payload [B]")
        rows = []
        for m in self.messages:
            number, when = f"{m.per_unit:g} per {m.unit.name}", str(m.schedule)
            rows.append((m.name, m.phase, m.cast, m.transport, number, when, m.payload.nominal))
        return pd.DataFrame(rows, columns=names)

    @property
    def phases(self) -> tuple[str, ...]:
        """The names of the phases, in order."""
        return tuple(dict.fromkeys(message.phase for message in self.messages))

    def of_phase(self, phase: str | None = None) -> tuple[Message, ...]:
        """Return the messages of a phase, or all of them."""
        if phase is not None:
            _checks.choice("phase", phase, self.phases, f" for {self.name}, or None")
        return tuple(message for message in self.messages if phase in (None, message.phase))

    @property
    def repeats(self) -> bool:
        """Whether a message has a period."""
        return any(message.schedule.per_second for message in self.messages)

    def message(self, name: str) -> Message:
        """Return the message of that name."""
        _checks.choice("name", name, [message.name for message in self.messages])
        return next(message for message in self.messages if message.name == name)

    def units(self, phase: str | None = None) -> tuple[Unit, ...]:
        """Return the units that count the messages of a phase, or of all phases."""
        return tuple(dict.fromkeys(message.unit for message in self.of_phase(phase)))

    def load(self, phase: str | None = None, window: sp.Expr | float = PAPER_WINDOW) -> sp.Expr:
        """Return the number of messages in an average second of the window; each goes up and down.

        Parameters
        ----------
        phase, window
            As for `utilization`.

        Returns
        -------
        sympy.Expr
            In ``N_H``, ``N_P`` and ``N_E``; paper, equations (2), (5), (7) and (10).
        """
        window_s = checked_window(window)
        return sp.factor(sum(m.schedule.mean(window_s) * m.load() for m in self.of_phase(phase)))

    def utilization(
        self,
        phase: str | None = None,
        fleet: Fleet = PAPER_SWARM,
        model: Model = "linear",
        window: sp.Expr | float = PAPER_WINDOW,
    ) -> sp.Expr:
        r"""Return the fraction of channel time that discovery needs in the first seconds.

        .. math:: U_\Phi = \sum_{\phi \in \Phi} \left(\frac{x_\phi}{W} + \frac{1}{P_\phi}\right)
            L_\phi (\mathcal{T}^{up}_\phi + \mathcal{T}^{down}_\phi)

        `Schedule.burst_count` is the x of a message with period P. Messages of the paper are sent
        once, in a window W of one second: :math:`x / W + 1 / P = 1`.

        Parameters
        ----------
        phase : str, optional
            One of `phases`; all of them if left out.
        fleet : Fleet, optional
            The paper's swarm if left out.
        model : {"linear", "padded", "aggregated"}, optional
            How a frame becomes airtime; the `model` of a `Wifi`.
        window : float or sympy.Expr, optional
            Seconds to average [s], at least 1e-9; the paper's one if left out; infinity: steady.

        Returns
        -------
        sympy.Expr
            In all symbols of the notation; paper, equation (12).
        """
        return self._total(phase, fleet, model, methodcaller("mean", checked_window(window)))

    def burst(
        self, phase: str | None = None, fleet: Fleet = PAPER_SWARM, model: Model = "linear"
    ) -> sp.Expr:
        """Return the airtime [s] that startup needs beyond the steady state; see `utilization`."""
        return self._total(phase, fleet, model, lambda s: int_if_integral(s.burst_count))

    def costs(
        self,
        phase: str | None = None,
        model: Model = "linear",
        window: sp.Expr | float = PAPER_WINDOW,
        by_hop: bool = False,
    ) -> dict[Unit, sp.Expr]:
        """Return the airtime that each unit adds to an average second, up and down [s].

        With ``by_hop``, for wired hosts, each hop has units of its own.
        """
        times = methodcaller("mean", checked_window(window))
        return self.sum_by_unit(lambda m, hop: m.airtime_of(hop, model), times, phase, by_hop)

    def sum_by_unit(
        self,
        airtime: Callable[[Message, Hop], CostT],
        times: Callable[[Schedule], Any],
        phase: str | None = None,
        by_hop: bool = False,
    ) -> dict[Unit, CostT]:
        """Return the airtime that the messages need for each unit [s].

        ``airtime`` is that of a message on a hop, ``times`` how often a schedule sends it.
        """
        costs: dict[Unit, CostT] = {}
        for message in self.of_phase(phase):
            sent = message.per_unit * times(message.schedule)
            for unit, hops in message.counted_by(by_hop):
                costs[unit] = costs.get(unit, 0) + sent * sum(airtime(message, hop) for hop in hops)
        return costs

    def _total(
        self, phase: str | None, fleet: Fleet, model: Model, times: Callable[[Schedule], Any]
    ) -> sp.Expr:
        _checks.instance("fleet", fleet, Fleet)
        fleet.reject_cells()
        costs: Mapping[Unit, sp.Expr] = self.sum_by_unit(
            lambda m, hop: m.airtime_of(hop, model), times, phase, fleet.has_wired
        )
        return sp.Add(*(unit.count(fleet) * cost for unit, cost in costs.items()))

    def values(self) -> dict[sp.Symbol, float]:
        """Return the nominal value of each payload and header symbol [B]."""
        payloads = {message.payload_symbol: message.payload.nominal for message in self.messages}
        headers = header_bytes()
        used = (message.transport for message in self.messages)
        return payloads | {HEADER_SYMBOLS[over]: float(headers[over]) for over in used}
