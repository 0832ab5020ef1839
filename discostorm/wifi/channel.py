"""What a link costs: rates, per-frame overhead, airtime of one frame (paper, Sec. IV)."""

from dataclasses import dataclass
from functools import cache
from typing import Literal, get_args

import sympy as sp

from discostorm import _checks, notation as nt
from discostorm.data import read_data
from discostorm.wifi import aggregation as agg

Cast = Literal["multicast", "unicast"]

#: How a frame becomes airtime: equation (11) of the paper, the standard's rounding to whole
#: symbols, or this and aggregation.
Model = Literal["linear", "padded", "aggregated"]

BITS_PER_BYTE = 8

#: All durations of the standard are multiples of this [s]; counted in it they are exact.
TICK = 1e-7


@dataclass(frozen=True)
class OfdmSymbols:
    """How a frame fills whole symbols.

    Parameters
    ----------
    bits : int
        Data bits in a symbol [bit], N_DBPS of the standard.
    symbol : float
        Duration of a symbol with its guard interval [s], a multiple of 1e-7.
    grid : float
        What the duration of the data is rounded up to [s]: as long as the symbol or, for
        short guard intervals in HT-mixed and VHT PPDUs, a ninth longer.
    added : int, optional
        Bits sent beside the frame [bit]: 16 of the SERVICE field and a tail of 6.

    Raises
    ------
    ValueError
        If a number is out of range, not whole, or not such a multiple.
    TypeError
        If one is not a number.

    References
    ----------
    IEEE Std 802.11-2020, 17.4.3, 19.4.3 and 21.4.3; IEEE Std 802.11ax-2021, 27.4.3.
    """

    bits: int
    symbol: float
    grid: float
    added: int = 22

    def __post_init__(self) -> None:
        _checks.plain_numbers(self)
        for name, low in (("bits", 1), ("added", 0)):
            _checks.whole(name, getattr(self, name), low, _checks.MOST)
        for name in ("symbol", "grid"):
            ticks = _checks.number(name, getattr(self, name), TICK, 1) / TICK
            if abs(ticks - round(ticks)) > 1e-6:
                raise ValueError(f"{name} must be a multiple of 1e-7; got {getattr(self, name)!r}")
        # Others may lift a whole number over itself when they are multiplied.
        if self.per_grid not in (1, 0.9):
            raise ValueError(
                f"symbol must be as long as the grid of {self.grid:g} s, or 0.9 of it; "
                f"got {self.symbol!r}"
            )

    @property
    def per_grid(self) -> float:
        """Duration of a symbol as a part of the grid [1]."""
        # Through whole ticks: 3.6e-6 / 4e-6 itself need not be the float next to 0.9.
        return round(self.symbol / TICK) / round(self.grid / TICK)


@dataclass(frozen=True)
class Link:
    """How frames of one kind, multicast or unicast, go over the air.

    Parameters
    ----------
    rate : float
        Data rate [bit/s], from 1 to 1e15.
    overhead : float
        Airtime that each frame costs whatever its length [s], from 0 to 1e6: waiting,
        preamble, acknowledgement.
    padding : OfdmSymbols, optional
        How a frame fills whole symbols; if left out, its length divided by the rate is
        its airtime, as in the paper.

    Raises
    ------
    ValueError
        If a number is out of range, or the rate is not that of the padding's symbols.
    TypeError
        If one is not a number, or the padding is not a OfdmSymbols.
    """

    rate: float
    overhead: float
    padding: OfdmSymbols | None = None

    def __post_init__(self) -> None:
        _checks.plain_numbers(self)
        _checks.number("rate", self.rate, _checks.LEAST_RATE, _checks.MOST_RATE)
        _checks.number("overhead", self.overhead, 0, _checks.MOST_SECONDS)
        if self.padding is not None:
            _checks.instance("padding", self.padding, OfdmSymbols)
            bits = self.rate * self.padding.symbol
            if abs(bits - self.padding.bits) >= 1:  # the standard rounds bits down
                raise ValueError(
                    f"rate must be that of {self.padding.bits} bits in "
                    f"{self.padding.symbol:g} s with this padding; got {self.rate!r}"
                )


#: Bits per symbol, added bits, symbol as a part of the grid, grid: as `data_time` takes them.
UNICAST = (nt.N_DBPS_UNI, nt.N_ADD_UNI, nt.K_UNI, nt.T_GRID_UNI)
#: The same of multicast frames.
MULTICAST = (nt.N_DBPS_MULTI, nt.N_ADD_MULTI, nt.K_MULTI, nt.T_GRID_MULTI)


def _printed(cast: Cast) -> Link:
    """Return the rate and overhead that the paper prints for frames of one kind."""
    (row,) = (row for row in read_data("paper/rates.csv") if row["rate"] == cast)
    return Link(float(row["printed_Mbit_s"]) * 1e6, float(row["printed_overhead_us"]) / 1e6)


#: The links of the paper's channel (paper, Sec. IV-A and IV-B).
PAPER_LINKS = {"unicast": _printed("unicast"), "multicast": _printed("multicast")}


def airtime(frame_bytes: sp.Expr, rate: sp.Expr, overhead: sp.Expr) -> sp.Expr:
    r"""Return the airtime of one frame in seconds: paper, equation (11) with :math:`L = 1`.

    .. math:: \mathcal{T} = \frac{8 S}{R} + O
    """
    return BITS_PER_BYTE * frame_bytes / rate + overhead


def bits_airtime(octets: sp.Expr, cast: Cast) -> sp.Expr:
    """Return the airtime of some octets more in a frame that is sent anyway [s].

    By the rate alone: where symbols are counted, in the mean over all lengths of a frame.
    """
    return airtime(octets, nt.R_UNI if cast == "unicast" else nt.R_MULTI, sp.Integer(0))


def data_time(
    octets: sp.Expr, bits: sp.Expr, added: sp.Expr, per_grid: sp.Expr, grid: sp.Expr
) -> sp.Expr:
    r"""Return the duration of the data part of a PPDU, in the unit of ``grid``.

    .. math:: G \left\lceil k \left\lceil\frac{N_{add} + 8 S}{N_{DBPS}}\right\rceil\right\rceil

    Parameters
    ----------
    octets : sympy.Expr
        Length of the frame or of the A-MPDU [B].
    bits, added, per_grid, grid : sympy.Expr
        As `OfdmSymbols` has them. The bits per symbol stay a symbol: sympy would split the
        fraction of a number, and floating point then gets some lengths wrong.

    References
    ----------
    IEEE Std 802.11-2020, 17.4.3, 19.4.3 and 21.4.3; IEEE Std 802.11ax-2021, 27.4.3.
    """
    symbols = sp.ceiling((added + BITS_PER_BYTE * octets) / bits)
    return grid * sp.ceiling(per_grid * symbols)


def aggregated_airtime(frame_bytes: sp.Expr) -> sp.Expr:
    r"""Return the airtime of one frame among its like in a full A-MPDU [s].

    .. math:: \mathcal{T} = \frac{1}{n}\left(O_{agg} + \mathcal{D}(n A)\right)

    with n frames in subframes of A octets, see `aggregation`, and the duration of their
    data :math:`\mathcal{D}`, see `data_time`.
    """
    frames = agg.mpdus(frame_bytes)
    octets = frames * agg.subframe_bytes(frame_bytes)
    return (nt.O_AGG + data_time(octets, *UNICAST)) / frames


def uplink_airtime(frame_bytes: sp.Expr, model: Model = "linear") -> sp.Expr:
    """Return the airtime from a host to the access point: always unicast."""
    return downlink_airtime(frame_bytes, "unicast", model)


def downlink_airtime(frame_bytes: sp.Expr, cast: Cast, model: Model = "linear") -> sp.Expr:
    """Return the airtime from the access point to one host, or once to all of them."""
    _checks.choice("cast", cast, get_args(Cast))
    _checks.choice("model", model, get_args(Model))
    return _frame_airtime(frame_bytes, cast, model)


@cache
def _frame_airtime(frame_bytes: sp.Expr, cast: Cast, model: Model) -> sp.Expr:
    if cast == "unicast":
        if model == "aggregated":
            return aggregated_airtime(frame_bytes)
        if model == "padded":
            return nt.O_UNI + data_time(frame_bytes, *UNICAST)
        return airtime(frame_bytes, nt.R_UNI, nt.O_UNI)
    if model == "linear":
        return airtime(frame_bytes, nt.R_MULTI, nt.O_MULTI)
    # Nobody acknowledges a multicast frame, so it is never aggregated.
    return nt.O_MULTI + data_time(frame_bytes, *MULTICAST)
