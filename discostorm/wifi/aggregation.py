"""Frame aggregation: many frames to one receiver in one A-MPDU, acknowledged at once."""

from dataclasses import dataclass

import sympy as sp

from discostorm import _checks, notation as nt
from discostorm.data import read_data

_BYTES = {row["name"]: int(row["bytes"]) for row in read_data("wifi/frames.csv")}


@dataclass(frozen=True)
class Aggregation:
    """Limits and overhead of A-MPDUs, in which frames to one receiver share an exchange.

    Parameters
    ----------
    mpdus : int
        Maximum number of frames (MPDUs) in an exchange [1], at least 1.
    most_bytes : int
        Maximum A-MPDU length [B], at least 1. A longer frame cannot be sent.
    overhead : float
        Fixed airtime of an exchange [s], at least 0: waiting, preamble, block acknowledgement.
    least_bytes : int, optional
        Minimum length of a subframe [B], at least 0, for the receiver's Minimum MPDU Start Spacing.
    """

    mpdus: int
    most_bytes: int
    overhead: float
    least_bytes: int = 0

    def __post_init__(self) -> None:
        _checks.unwrap_0d_arrays(self)
        _checks.integer("mpdus", self.mpdus, 1, _checks.MAX_COUNT)
        _checks.integer("most_bytes", self.most_bytes, 1, _checks.MAX_BYTES)
        _checks.number("overhead", self.overhead, 0, _checks.MAX_SECONDS)
        _checks.integer("least_bytes", self.least_bytes, 0, _checks.MAX_BYTES)


def subframe_bytes(frame_bytes: sp.Expr) -> sp.Expr:
    r"""Return the length of an A-MPDU subframe [B] that carries a frame of that length.

    .. math:: A = \max\left(A_{least}, 4 + 4 \left\lceil\frac{S + 2}{4}\right\rceil\right)

    A delimiter of 4 octets precedes the frame, which has a QoS Control field of 2 octets that the
    paper's frames lack; padding follows it, also in the last subframe, as in VHT and HE PPDUs.
    Empty delimiters extend it to the minimum (IEEE Std 802.11-2020, 9.2.4.5, 9.7.1 and 10.12.3).
    """
    padding = _BYTES["A-MPDU padding"]
    frame = frame_bytes + _BYTES["QoS Control"]
    return sp.Max(nt.A_MIN, _BYTES["MPDU delimiter"] + padding * sp.ceiling(frame / padding))


def mpdus(frame_bytes: sp.Expr) -> sp.Expr:
    r"""Return the number of frames of that length [B] in a full exchange.

    .. math:: n = \min\left(n_{agg}, \left\lfloor\frac{A_{most}}{A}\right\rfloor\right)
    """
    return sp.Min(nt.N_AGG, sp.floor(nt.A_MAX / subframe_bytes(frame_bytes)))
