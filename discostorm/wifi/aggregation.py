"""Frame aggregation: many frames to one receiver in one A-MPDU, acknowledged at once."""

from dataclasses import dataclass

import sympy as sp

from discostorm import _checks, notation as nt
from discostorm.data import read_data

_BYTES = {row["name"]: int(row["bytes"]) for row in read_data("wifi/frames.csv")}


@dataclass(frozen=True)
class Aggregation:
    """How frames to one receiver are put into one exchange.

    Parameters
    ----------
    mpdus : int
        Most frames (MPDUs) in an exchange [1], at least 1.
    most_bytes : int
        Longest A-MPDU [B] that the standard and the longest PPDU allow, at least 1. A
        frame that does not fit in cannot be sent.
    overhead : float
        Airtime that each exchange costs whatever its length [s], at least 0: waiting,
        preamble, block acknowledgement.
    least_bytes : int, optional
        Least length of a subframe [B], at least 0: so long that receivers which need time
        between the starts of two frames have it.
    """

    mpdus: int
    most_bytes: int
    overhead: float
    least_bytes: int = 0

    def __post_init__(self) -> None:
        _checks.plain_numbers(self)
        _checks.whole("mpdus", self.mpdus, 1, _checks.MOST)
        _checks.whole("most_bytes", self.most_bytes, 1, _checks.MOST_BYTES)
        _checks.number("overhead", self.overhead, 0, _checks.MOST_SECONDS)
        _checks.whole("least_bytes", self.least_bytes, 0, _checks.MOST_BYTES)


def subframe_bytes(frame_bytes: sp.Expr) -> sp.Expr:
    r"""Return the length of an A-MPDU subframe [B] that carries a frame of that length.

    Under a block acknowledgement the frame has a QoS Control field of 2 octets, which the
    paper's frames lack. A delimiter of 4 octets goes before it, and padding after it up
    to a multiple of 4:

    .. math:: A = \max\left(A_{least}, 4 + 4 \left\lceil\frac{S + 2}{4}\right\rceil\right)

    Empty delimiters make up what a short frame lacks of the least length.

    The last subframe of an HT PPDU may leave its padding out; here, as in VHT and HE
    PPDUs, it does not.

    References
    ----------
    IEEE Std 802.11-2020, 9.2.4.5, 9.7.1 and 10.12.3 (minimum MPDU start spacing).
    """
    padding = _BYTES["A-MPDU padding"]
    frame = frame_bytes + _BYTES["QoS Control"]
    return sp.Max(nt.A_LEAST, _BYTES["MPDU delimiter"] + padding * sp.ceiling(frame / padding))


def mpdus(frame_bytes: sp.Expr) -> sp.Expr:
    r"""Return how many frames of that length [B] an exchange carries when it is full.

    .. math:: n = \min\left(n_{agg}, \left\lfloor\frac{A_{most}}{A}\right\rfloor\right)

    References
    ----------
    IEEE Std 802.11-2020, 10.25 (block acknowledgement window), 9.7 and 10.12 (length).
    """
    return sp.Min(nt.N_AGG, sp.floor(nt.A_MOST / subframe_bytes(frame_bytes)))
