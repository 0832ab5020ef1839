"""What the air costs: rates, per-frame overhead, airtime of one frame (paper, Sec. IV)."""

from dataclasses import dataclass
from typing import Literal

import sympy as sp

from discostorm import _checks, notation as nt

Cast = Literal["multicast", "unicast"]

BITS_PER_BYTE = 8


@dataclass(frozen=True)
class Link:
    """How frames of one kind, multicast or unicast, go over the air.

    Parameters
    ----------
    rate : float
        Data rate [bit/s], above 0.
    overhead : float
        Airtime that each frame costs whatever its length [s], at least 0: waiting,
        preamble, acknowledgement.
    """

    rate: float
    overhead: float

    def __post_init__(self) -> None:
        _checks.number("rate", self.rate, 0, above=True)
        _checks.number("overhead", self.overhead, 0)


@dataclass(frozen=True)
class Wifi:
    """A Wi-Fi channel in infrastructure mode.

    Parameters
    ----------
    name : str
        What to call it in tables and figures.
    unicast : Link
        Frames to one receiver; also every frame from a host up to the access point.
    multicast : Link
        Multicast frames from the access point down to all hosts.
    """

    name: str
    unicast: Link
    multicast: Link

    def values(self) -> dict[sp.Symbol, float]:
        """Return the value of each symbol of the notation that this channel sets."""
        return {
            nt.R_UNI: self.unicast.rate,
            nt.O_UNI: self.unicast.overhead,
            nt.R_MULTI: self.multicast.rate,
            nt.O_MULTI: self.multicast.overhead,
        }


#: The paper's channel: IEEE 802.11n, 2x2 MIMO, MCS 7 a stream (paper, Sec. IV-A and IV-B).
PAPER = Wifi(
    "paper (802.11n)",
    unicast=Link(rate=144.4e6, overhead=180e-6),
    multicast=Link(rate=6e6, overhead=120e-6),
)


def airtime(frame_bytes: sp.Expr, rate: sp.Expr, overhead: sp.Expr) -> sp.Expr:
    r"""Return the airtime of one frame in seconds: paper, equation (11) with :math:`L = 1`.

    .. math:: \mathcal{T} = \frac{8 S}{R} + O
    """
    return BITS_PER_BYTE * frame_bytes / rate + overhead


def uplink_airtime(frame_bytes: sp.Expr) -> sp.Expr:
    """Return the airtime from a host to the access point: always unicast."""
    return airtime(frame_bytes, nt.R_UNI, nt.O_UNI)


def downlink_airtime(frame_bytes: sp.Expr, cast: Cast) -> sp.Expr:
    """Return the airtime from the access point to one host, or once to all of them."""
    if cast == "multicast":
        return airtime(frame_bytes, nt.R_MULTI, nt.O_MULTI)
    return airtime(frame_bytes, nt.R_UNI, nt.O_UNI)
