"""One row of a protocol's table: a message, its payload, and the airtime of its frames."""

from dataclasses import dataclass, replace
from functools import cache
from typing import Literal, get_args

import sympy as sp

from discostorm import _checks, notation as nt
from discostorm._numeric import int_if_integral
from discostorm.data import read_data
from discostorm.fleet import PAPER_SWARM, Count, Fleet
from discostorm.messages.schedule import ONCE, Schedule
from discostorm.messages.units import Unit, WirelessEnd
from discostorm.wifi import Cast, Model, bits_airtime, downlink_airtime, uplink_airtime

#: Minimum number of messages per unit, and minimum part of a frame [1].
_MIN_PER_UNIT = 1e-9

Transport = Literal["UDP", "TCP"]

#: The purpose of a message; see `Message`.
Role = Literal["announcement", "data", "heartbeat", "acknowledgement", "other"]

#: "up" leads from a host to the access point, "down" from the access point to a host.
Hop = Literal["up", "down"]
HOPS: tuple[Hop, ...] = ("up", "down")


@dataclass(frozen=True, repr=False)
class Payload:
    """Payload size of a message: nominal value, range and where they come from.

    Parameters
    ----------
    nominal, low, high : float
        The size to compute with, and its range [B], from 0 to 1e9; an end is nominal if left out.
    source : str, optional
        Where the numbers come from, such as "my capture of Hello"; errors name it.
    """

    nominal: float
    low: float = None  # type: ignore[assignment]  # a number once it is checked
    high: float = None  # type: ignore[assignment]
    source: str = ""

    def __post_init__(self) -> None:
        source = _checks.shorten_name(str(self.source))
        with _checks.prefix_errors(f"payload ({source})" if self.source else ""):
            most = _checks.MAX_BYTES
            low, high = (self.nominal if end is None else end for end in (self.low, self.high))
            low = _checks.number("nominal" if self.low is None else "low", low, 0, most)
            high = _checks.number("nominal" if self.high is None else "high", high, low, most)
            nominal = _checks.number("nominal", self.nominal, low, high)
        for name, value in (("nominal", nominal), ("low", low), ("high", high)):
            object.__setattr__(self, name, value)

    def __repr__(self) -> str:
        ends = f", from {self.low:g} to {self.high:g} B" if self.low != self.high else ""
        source = f", {self.source}" if self.source else ""
        return _checks.shorten_repr(f"Payload({self.nominal:g} B{ends}{source})")


@dataclass(frozen=True, repr=False)
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
    payload : Payload or float
        Size without headers [B].
    unit : Unit
        What it is counted by.
    per_unit : float
        Messages for each unit [1], from 1e-9 to 1e9, each time that the schedule names.
    schedule : Schedule, optional
        When they are sent; once, at startup, if left out.
    hops : tuple of {"up", "down"}, optional
        Which hops take the air; both if left out. A peer that is wired to the access point sends
        ``("down",)`` and receives ``("up",)``.
    answers : str, optional
        The message on whose arrival it is sent. None, or one that is not in the table, if it is
        sent by the clock. Counts and airtime do not depend on it, the simulator does.
    frames : float, optional
        Mean number of frames per message [1], from 1e-9 to 1e9: less than 1 if several messages
        share one; 0 if it is always inside the frame of another row, and costs only its bits.
    kind : str, optional
        What a capture calls it; its name if left out. Several rows may be of one kind.
    role : {"announcement", "data", "heartbeat", "acknowledgement", "other"}, optional
        What it is for, which the simulator needs. An announcement introduces a process or a host,
        or answers one that does. Data are endpoint announcements. A heartbeat asks a process which
        data have arrived, until all have; an acknowledgement answers it. None if unknown.
    informs : bool, optional
        Whether its receiver then has discovered the sender; announcements alone if left out.
    inside : str, optional
        The message in whose frames it is, if `frames` is 0; for the simulator, where more than one
        message of its phase has frames.
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
    role: Role | None = None
    informs: bool | None = None
    inside: str | None = None

    def __post_init__(self) -> None:
        _checks.unwrap_0d_arrays(self)
        if not isinstance(self.payload, Payload):
            with _checks.prefix_errors(f"payload of {_checks.shorten_name(str(self.name))}"):
                object.__setattr__(self, "payload", Payload(self.payload))
        if not self.kind:
            object.__setattr__(self, "kind", self.name)
        if self.informs is None:
            object.__setattr__(self, "informs", self.role == "announcement")
        for name, kind in _FIELD_TYPES.items():
            if not (name in ("answers", "inside") and getattr(self, name) is None):
                _checks.instance(name, getattr(self, name), kind)
        _checks.choice("cast", self.cast, get_args(Cast))
        _checks.choice("transport", self.transport, get_args(Transport))
        if self.role is not None:
            _checks.choice("role", self.role, get_args(Role), ", or None")
        _checks.number("per_unit", self.per_unit, _MIN_PER_UNIT, _checks.MAX_COUNT)
        if _checks.number("frames", self.frames, 0, _checks.MAX_COUNT) != 0:
            _checks.number("frames", self.frames, _MIN_PER_UNIT, _checks.MAX_COUNT)
        object.__setattr__(self, "hops", _checks.tuple_of("hops", self.hops, str))
        if not (len(set(self.hops)) == len(self.hops) and set(self.hops) <= set(HOPS)):
            raise ValueError(f"hops must be 'up', 'down' or both, each once; got {self.hops}")
        if self.inside is not None and self.frames:
            raise ValueError(f"inside must be None if frames is above 0; got {self.inside!r}")

    def __repr__(self) -> str:
        return _checks.shorten_repr(
            f"Message({self.name!r}, {self.cast}, {self.transport}, {self.payload.nominal:g} B, "
            f"{self.per_unit:g} per {self.unit.name}, {self.schedule})"
        )

    @property
    def payload_symbol(self) -> sp.Symbol:
        """The symbol of the payload size [B]."""
        return nt.payload_symbol(self.name)

    @property
    def frame_symbolic(self) -> sp.Expr:
        """The mean frame length [B] in symbols; the payload alone inside another frame."""
        if self.frames == 0:
            return self.payload_symbol
        return self.payload_symbol / int_if_integral(self.frames) + HEADER_SYMBOLS[self.transport]

    @property
    def frame_bytes(self) -> float:
        """The nominal frame length [B], of `frame_symbolic`."""
        if self.frames == 0:
            return self.payload.nominal
        return self.payload.nominal / self.frames + header_bytes()[self.transport]

    def load(self, fleet: Fleet = PAPER_SWARM) -> Count:
        """Return the number of messages of a fleet at each time of the schedule."""
        _checks.instance("fleet", fleet, Fleet)
        return self.per_unit * self.unit.count(fleet)

    def counted_by(self, by_hop: bool = False) -> list[tuple[Unit, tuple[Hop, ...]]]:
        """Return the unit and all hops or, ``by_hop``, the unit of wireless hosts for each hop."""
        if not by_hop:
            return [(self.unit, self.hops)]
        return [(self.wireless_unit(hop), (hop,)) for hop in self.hops]

    def wireless_unit(self, hop: Hop) -> Unit:
        """Return the unit that counts only the messages that take airtime on a hop.

        The other end of a message with one hop is a wired server. A message that the server passes
        on takes airtime on its way to the receiver, which answers it.
        """
        end: WirelessEnd = "sender"
        if len(self.hops) == 1:
            end = "receiver" if self.unit.to == "other process" else "sender"
        elif hop == "down":
            end = "receiver" if self.cast == "unicast" and self.unit.to_each else "any"
        return replace(self.unit, wireless=end)

    def airtime_up(self, model: Model = "linear") -> sp.Expr:
        """Return the airtime of one message up to the access point [s]."""
        return self.airtime_of("up", model)

    def airtime_down(self, model: Model = "linear") -> sp.Expr:
        """Return the airtime of one message down from the access point [s]."""
        return self.airtime_of("down", model)

    def airtime_of(self, hop: Hop, model: Model = "linear") -> sp.Expr:
        """Return the airtime of one message on a hop [s], for its share of the frames."""
        _checks.choice("model", model, get_args(Model))
        part = int_if_integral(self.frames or 1.0)
        return part * hop_airtime(hop, self.cast, self.frames > 0, self.frame_symbolic, model)


_TEXTS: dict[str, type] = dict.fromkeys(("name", "phase", "kind", "answers", "inside"), str)
_FIELD_TYPES = _TEXTS | {"payload": Payload, "unit": Unit, "schedule": Schedule, "informs": bool}


@cache
def hop_airtime(hop: Hop, cast: Cast, own_frame: bool, octets: sp.Expr, model: Model) -> sp.Expr:
    """Return the airtime of a frame on a hop, or of octets inside of another frame [s]."""
    if not own_frame:
        return bits_airtime(octets, "unicast" if hop == "up" else cast)
    return uplink_airtime(octets, model) if hop == "up" else downlink_airtime(octets, cast, model)


HEADER_SYMBOLS: dict[Transport, sp.Symbol] = {"UDP": nt.H_UDP, "TCP": nt.H_TCP}


@cache
def header_bytes() -> dict[str, int]:
    """Add up the header bytes of each transport from their parts [B]."""
    parts = read_data("paper/headers.csv")
    return {
        transport: sum(int(part["bytes"]) for part in parts if transport in part["transports"])
        for transport in HEADER_SYMBOLS
    }
