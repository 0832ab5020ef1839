"""One row of a protocol's table: a message, its payload and what its frames take of the air."""

from dataclasses import dataclass
from functools import cache
from typing import Literal, get_args

import sympy as sp

from discostorm import _checks, notation as nt
from discostorm._numeric import plain
from discostorm.data import read_data
from discostorm.fleet import SWARM, Count, Fleet
from discostorm.messages.schedule import ONCE, Schedule
from discostorm.messages.units import End, OnAir, Unit
from discostorm.wifi import Cast, Model, bits_airtime, downlink_airtime, uplink_airtime

#: Fewest messages for each unit [1].
LEAST_PER_UNIT = 1e-9

Transport = Literal["UDP", "TCP"]

#: What a message is for; see `Message`.
Role = Literal["announcement", "data", "heartbeat", "acknowledgement", "other"]

#: From a host to the access point, and from there on.
Hop = Literal["up", "down"]
HOPS: tuple[Hop, ...] = ("up", "down")


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
    role : {"announcement", "data", "heartbeat", "acknowledgement", "other"}, optional
        What it is for. An announcement tells of a process or a host, or answers what does. Data
        tell of endpoints, each time for the first time. The heartbeat asks a process which of the
        data have arrived, and is repeated until all have; the acknowledgement answers it.
        Whatever else is sent, such as liveliness, is other. None if it is not known: counts and
        airtime do not need it, the simulator needs it for recovery.
    informs : bool, optional
        Whether who receives it knows its sender from then on; if left out, announcements alone do.
    inside : str, optional
        The message in whose frames it is, if `frames` is 0. The simulator needs it where more than
        one message of its phase has frames.

    Raises
    ------
    ValueError
        If `cast`, `transport`, `per_unit`, `hops`, `frames` or `role` is none of the above.
    TypeError
        If a name is not text, `payload` not a Payload, `unit` not a Unit, `schedule` not
        a Schedule, or `informs` neither True nor False.
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
        if self.role is not None:
            _checks.choice("role", self.role, get_args(Role), ", or None")
        if self.informs is None:
            object.__setattr__(self, "informs", self.role == "announcement")
        _checks.instance("informs", self.informs, bool)
        if self.inside is not None:
            _checks.instance("inside", self.inside, str)
            if self.frames:
                raise ValueError(
                    f"inside must be None where frames is above 0; got {self.inside!r}"
                )

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
        return self.payload_symbol / plain(self.frames) + HEADER_SYMBOLS[self.transport]

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

    def on_air(self, hop: Hop) -> OnAir:
        """Return those of its unit whose messages take the air on a hop if some hosts are wired.

        Of a row on one hop, the other end is wired already: of a server. What it sends of one
        process to another takes the air to the other one, and is answered by that one.
        """
        end: End = "holder"
        if len(self.hops) == 1:
            end = "receiver" if self.unit.to == "other process" else "holder"
        elif hop == "down":
            end = "receiver" if self.cast == "unicast" and self.unit.to_each else "any"
        return OnAir(self.unit, end)

    def airtime_up(self, model: Model = "linear") -> sp.Expr:
        """Return the airtime of its part of a frame up to the access point [s]."""
        return self.airtime_of("up", model)

    def airtime_down(self, model: Model = "linear") -> sp.Expr:
        """Return the airtime of its part of a frame down from the access point [s]."""
        return self.airtime_of("down", model)

    def airtime(self, model: Model = "linear") -> sp.Expr:
        """Return the airtime of its part of a frame on all of its hops [s]."""
        return sp.Add(*(self.airtime_of(hop, model) for hop in self.hops))

    def airtime_of(self, hop: Hop, model: Model = "linear") -> sp.Expr:
        """Return the airtime of its part of a frame on a hop [s]."""
        _checks.choice("model", model, get_args(Model))
        part = plain(self.frames or 1.0)
        return part * hop_airtime(hop, self.cast, self.frames > 0, self.frame_symbolic, model)


HEADER_SYMBOLS: dict[Transport, sp.Symbol] = {"UDP": nt.H_UDP, "TCP": nt.H_TCP}


@cache
def header_bytes() -> dict[str, int]:
    """Return the header bytes of each transport, added up from their parts [B]."""
    parts = read_data("paper/headers.csv")
    return {
        transport: sum(int(part["bytes"]) for part in parts if transport in part["transports"])
        for transport in HEADER_SYMBOLS
    }
