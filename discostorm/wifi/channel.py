"""A Wi-Fi channel: rate and overhead of its unicast and multicast links, and aggregation."""

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import sympy as sp

from discostorm import _checks, notation as nt
from discostorm.data import read_data
from discostorm.wifi.aggregation import Aggregation
from discostorm.wifi.airtime import MULTICAST, UNICAST, Model

if TYPE_CHECKING:
    from discostorm.wifi.radio import Radio

#: Unit of time [s]: all durations of the standard are multiples, so that counts are exact.
TICK = 1e-7


@dataclass(frozen=True)
class OfdmSymbols:
    """The OFDM symbols that a frame fills (IEEE Std 802.11-2020, 17.4.3, 19.4.3 and 21.4.3).

    Parameters
    ----------
    bits : int
        Data bits in a symbol [bit], N_DBPS of the standard.
    symbol : float
        Duration of a symbol with its guard interval [s], a multiple of 1e-7.
    grid : float
        Unit to which the duration of the data is rounded up [s]: as long as the symbol or, for
        short guard intervals in HT-mixed and VHT PPDUs, a ninth longer.
    added : int, optional
        Bits added to the frame [bit]: 16 of the SERVICE field and a tail of 6.
    """

    bits: int
    symbol: float
    grid: float
    added: int = 22

    def __post_init__(self) -> None:
        _checks.unwrap_0d_arrays(self)
        for name, low in (("bits", 1), ("added", 0)):
            _checks.integer(name, getattr(self, name), low, _checks.MAX_COUNT)
        for name in ("symbol", "grid"):
            ticks = _checks.number(name, getattr(self, name), TICK, 1) / TICK
            if abs(ticks - round(ticks)) > 1e-6:
                raise ValueError(f"{name} must be a multiple of 1e-7; got {getattr(self, name)!r}")
        # Rounding errors could make other ratios exceed a whole number when multiplied.
        if self.per_grid not in (1, 0.9):
            raise ValueError(
                f"symbol must equal the grid of {self.grid:g} s, or 0.9 of it; got {self.symbol!r}"
            )

    @property
    def per_grid(self) -> float:
        """Duration of a symbol as a part of the grid [1]."""
        # Divide whole ticks, because 3.6e-6 / 4e-6 may differ from the float 0.9.
        return round(self.symbol / TICK) / round(self.grid / TICK)


@dataclass(frozen=True)
class Link:
    """Rate and overhead of one kind of frames, multicast or unicast.

    Parameters
    ----------
    rate : float
        Data rate [bit/s], from 1 to 1e15.
    overhead : float
        Airtime that each frame costs [s], from 0 to 1e6: waiting, preamble, acknowledgement.
    padding : OfdmSymbols, optional
        How a frame fills whole symbols; if left out, its length divided by the rate is
        its airtime, as in the paper. The rate must be that of its symbols.
    """

    rate: float
    overhead: float
    padding: OfdmSymbols | None = None

    def __post_init__(self) -> None:
        _checks.unwrap_0d_arrays(self)
        _checks.number("rate", self.rate, _checks.MIN_RATE, _checks.MAX_RATE)
        _checks.number("overhead", self.overhead, 0, _checks.MAX_SECONDS)
        if self.padding is not None:
            _checks.instance("padding", self.padding, OfdmSymbols)
            bits = self.rate * self.padding.symbol
            if abs(bits - self.padding.bits) >= 1:  # the standard rounds bits down
                rate = f"{self.padding.bits} bits per {self.padding.symbol:g} s"
                raise ValueError(f"rate must be {rate} with this padding; got {self.rate!r}")


#: The links of the paper's channel, as it prints them (paper, Sec. IV-A and IV-B).
PAPER_LINKS = {
    row["rate"]: Link(float(row["printed_Mbit_s"]) * 1e6, float(row["printed_overhead_us"]) / 1e6)
    for row in read_data("paper/rates.csv")
}


@dataclass(frozen=True, repr=False)
class Wifi:
    """A Wi-Fi channel in infrastructure mode.

    Parameters
    ----------
    name : str
        What to call it in tables and figures.
    unicast, multicast : Link
        Frames to one receiver and every frame up to the access point; multicast frames down to all.
    aggregation : Aggregation, optional
        If given, frames to one receiver share exchanges, if the links have padding; its overhead
        replaces that of the unicast link.
    radio : Radio, optional
        The radio that has these rates, with the standard's timing; None for a channel of your
        own. Channels are compared without their radios.
    """

    name: str
    unicast: Link
    multicast: Link
    aggregation: Aggregation | None = None
    radio: "Radio | None" = field(default=None, compare=False, repr=False)

    def __post_init__(self) -> None:
        _checks.instance("name", self.name, str)
        _checks.instance("unicast", self.unicast, Link)
        _checks.instance("multicast", self.multicast, Link)
        if (self.unicast.padding is None) != (self.multicast.padding is None):
            got = ", ".join(f"{name}.padding={getattr(self, name).padding}" for name in PAPER_LINKS)
            rule = "unicast and multicast must both have padding or both have none"
            raise ValueError(f"{rule}; got {got}")
        if self.aggregation is not None:
            _checks.instance("aggregation", self.aggregation, Aggregation)
            if self.unicast.padding is None:
                raise ValueError("aggregation must be None unless the links have padding")

    def __repr__(self) -> str:
        links = (
            f"{cast} {link.rate / 1e6:.4g} Mbit/s + {link.overhead * 1e6:.4g} µs"
            for cast, link in (("unicast", self.unicast), ("multicast", self.multicast))
        )
        mpdus = f", A-MPDUs of {self.aggregation.mpdus}" if self.aggregation else ""
        return _checks.shorten_repr(f"<Wifi {self.name!r}: {', '.join(links)}{mpdus}>")

    @property
    def model(self) -> Model:
        """The formula of airtime on this channel: linear, padded or aggregated."""
        if self.aggregation is not None:
            return "aggregated"
        return "linear" if self.unicast.padding is None else "padded"

    def values(self) -> dict[sp.Symbol, float]:
        """Return the value of each symbol of the notation that this channel sets."""
        values = {
            nt.R_UNI: self.unicast.rate,
            nt.O_UNI: self.unicast.overhead,
            nt.R_MULTI: self.multicast.rate,
            nt.O_MULTI: self.multicast.overhead,
        }
        for link, symbols in ((self.unicast, UNICAST), (self.multicast, MULTICAST)):
            if padding := link.padding:
                given = (padding.bits, padding.added, padding.per_grid, padding.grid)
                values |= dict(zip(symbols, map(float, given), strict=True))
        if self.aggregation is not None:
            values |= {
                nt.N_AGG: float(self.aggregation.mpdus),
                nt.A_MAX: float(self.aggregation.most_bytes),
                nt.O_AGG: self.aggregation.overhead,
                nt.A_MIN: float(self.aggregation.least_bytes),
            }
        return values
