"""A discovery protocol is a table of messages; its load and utilization follow from it."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from typing import Literal, get_args

import sympy as sp

from discostorm import _checks, notation as nt
from discostorm.data import read_data
from discostorm.fleet import SWARM, Count, Fleet
from discostorm.wifi import Cast, Model, downlink_airtime, uplink_airtime

Transport = Literal["UDP", "TCP"]


@dataclass(frozen=True)
class Unit:
    """What a message is sent once, twice or more for; a fleet says how many there are.

    Parameters
    ----------
    name : str
        What one of them is called.
    count : callable
        Takes a `Fleet`, returns how many of them it has [1].
    """

    name: str
    count: Callable[[Fleet], Count]


PROCESS = Unit("process", Fleet.processes)
PAIR = Unit("ordered pair of processes on different hosts", Fleet.pairs)
ENDPOINT_PAIR = Unit("endpoint and process on another host", Fleet.endpoint_pairs)


@dataclass(frozen=True)
class Payload:
    """Payload size of a message: nominal value, range and where they come from.

    Parameters
    ----------
    nominal : float
        The size to compute with [B], from `low` to `high`.
    low, high : float
        The range of sizes [B], at least 0.
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
        _checks.number("low", self.low, 0)
        _checks.number("high", self.high, self.low)
        _checks.number("nominal", self.nominal, self.low, self.high)


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
        How many are sent for each unit [1], above 0.

    Raises
    ------
    ValueError
        If `cast`, `transport` or `per_unit` is none of the above.
    TypeError
        If `payload` is not a Payload, or `unit` not a Unit.
    """

    name: str
    phase: str
    cast: Cast
    transport: Transport
    payload: Payload
    unit: Unit
    per_unit: float

    def __post_init__(self) -> None:
        _checks.choice("cast", self.cast, get_args(Cast))
        _checks.choice("transport", self.transport, get_args(Transport))
        _checks.instance("payload", self.payload, Payload)
        _checks.instance("unit", self.unit, Unit)
        _checks.number("per_unit", self.per_unit, 0, above=True)

    @property
    def payload_symbol(self) -> sp.Symbol:
        """The symbol of its payload size [B]."""
        return nt.payload_symbol(self.name)

    @property
    def frame_symbolic(self) -> sp.Expr:
        """Its frame length [B] in symbols: payload and headers (paper, Sec. IV-A)."""
        return self.payload_symbol + _HEADER_SYMBOLS[self.transport]

    @property
    def frame_bytes(self) -> float:
        """Its nominal frame length [B]."""
        return self.payload.nominal + header_bytes()[self.transport]

    def load(self, fleet: Fleet = SWARM) -> Count:
        """Return how many are sent, up and again down."""
        _checks.instance("fleet", fleet, Fleet)
        return self.per_unit * self.unit.count(fleet)

    def airtime_up(self, model: Model = "linear") -> sp.Expr:
        """Return the airtime of one frame up to the access point [s]."""
        return uplink_airtime(self.frame_symbolic, model)

    def airtime_down(self, model: Model = "linear") -> sp.Expr:
        """Return the airtime of one frame down from the access point [s]."""
        return downlink_airtime(self.frame_symbolic, self.cast, model)


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
    """A discovery protocol: a name and its table of messages.

    Parameters
    ----------
    name : str
        What to call it in tables and figures.
    messages : tuple of Message
        At least one; their names differ.

    Raises
    ------
    ValueError
        If there is no message, or two have the same name.
    TypeError
        If one is not a Message.
    """

    name: str
    messages: tuple[Message, ...]

    def __post_init__(self) -> None:
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

    def load(self, phase: str | None = None) -> sp.Expr:
        r"""Return the number of messages that go up, which is also the number that go down.

        Parameters
        ----------
        phase : str, optional
            One of `phases`; all of them if left out.

        Returns
        -------
        sympy.Expr
            In ``N_H``, ``N_P`` and ``N_E``; paper, equations (2), (5), (7) and (10).

        Raises
        ------
        ValueError
            If the protocol has no such phase.

        Examples
        --------
        >>> import discostorm as ds
        >>> ds.DDS.load("SPDP")
        N_H*N_P
        """
        return sp.factor(sum(message.load() for message in self.of_phase(phase)))

    def cost(self, unit: Unit, phase: str | None = None, model: Model = "linear") -> sp.Expr:
        """Return the airtime that each `unit` adds, up and down [s]."""
        _checks.instance("unit", unit, Unit)
        return sp.Add(
            *(
                message.per_unit * (message.airtime_up(model) + message.airtime_down(model))
                for message in self.of_phase(phase)
                if message.unit == unit
            )
        )

    def utilization(
        self, phase: str | None = None, fleet: Fleet = SWARM, model: Model = "linear"
    ) -> sp.Expr:
        r"""Return the fraction of one second of channel time that discovery takes.

        .. math:: U_\Phi = \sum_{\phi \in \Phi} L_\phi (\mathcal{T}^{up}_\phi +
            \mathcal{T}^{down}_\phi) / 1\,\mathrm{s}

        Parameters
        ----------
        phase : str, optional
            One of `phases`; all of them if left out.
        fleet : Fleet, optional
            The paper's swarm if left out.
        model : {"linear", "padded", "aggregated"}, optional
            How a frame becomes airtime; the `model` of a `Wifi`.

        Returns
        -------
        sympy.Expr
            In all symbols of the notation; paper, equation (12).

        Raises
        ------
        ValueError
            If the protocol has no such phase, or there is no such model.
        TypeError
            If `fleet` is not a Fleet.
        """
        _checks.instance("fleet", fleet, Fleet)
        units = dict.fromkeys(message.unit for message in self.of_phase(phase))
        return sp.Add(*(unit.count(fleet) * self.cost(unit, phase, model) for unit in units))

    def values(self) -> dict[sp.Symbol, float]:
        """Return the nominal value of each payload and header symbol [B]."""
        payloads = {message.payload_symbol: message.payload.nominal for message in self.messages}
        headers = header_bytes()
        return payloads | {
            _HEADER_SYMBOLS[message.transport]: float(headers[message.transport])
            for message in self.messages
        }
