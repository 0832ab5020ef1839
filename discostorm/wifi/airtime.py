"""The airtime of one frame: by the paper (Sec. IV), or with whole symbols and A-MPDUs."""

from functools import cache
from typing import Literal, get_args

import sympy as sp

from discostorm import _checks, notation as nt
from discostorm.wifi import aggregation as agg

Cast = Literal["multicast", "unicast"]

#: Formula of airtime: equation (11) of the paper, with the standard's rounding to whole symbols,
#: or with both this rounding and aggregation.
Model = Literal["linear", "padded", "aggregated"]

BITS_PER_BYTE = 8

#: Arguments of `data_time`: bits per symbol, added bits, symbol over grid, grid; see `OfdmSymbols`.
UNICAST = (nt.N_DBPS_UNI, nt.N_ADD_UNI, nt.K_UNI, nt.T_GRID_UNI)
#: The same for multicast frames.
MULTICAST = (nt.N_DBPS_MULTI, nt.N_ADD_MULTI, nt.K_MULTI, nt.T_GRID_MULTI)


def airtime(frame_bytes: sp.Expr, rate: sp.Expr, overhead: sp.Expr) -> sp.Expr:
    r"""Return the airtime of one frame in seconds: paper, equation (11) with :math:`L = 1`.

    .. math:: \mathcal{T} = \frac{8 S}{R} + O
    """
    return BITS_PER_BYTE * frame_bytes / rate + overhead


def bits_airtime(octets: sp.Expr, cast: Cast) -> sp.Expr:
    """Return the airtime that further octets add to a frame, by the rate alone [s]."""
    return airtime(octets, nt.R_UNI if cast == "unicast" else nt.R_MULTI, sp.Integer(0))


def data_time(
    octets: sp.Expr, bits: sp.Expr, added: sp.Expr, per_grid: sp.Expr, grid: sp.Expr
) -> sp.Expr:
    r"""Return the duration of the data part of a PPDU, in the unit of ``grid``; see `OfdmSymbols`.

    .. math:: G \left\lceil k \left\lceil\frac{N_{add} + 8 S}{N_{DBPS}}\right\rceil\right\rceil

    The bits per symbol stay symbolic. With a number, sympy would split the fraction, and rounding
    would then get some lengths wrong.
    """
    symbols = sp.ceiling((added + BITS_PER_BYTE * octets) / bits)
    return grid * sp.ceiling(per_grid * symbols)


def aggregated_airtime(frame_bytes: sp.Expr) -> sp.Expr:
    r"""Return the airtime of one frame in a full A-MPDU of equal frames [s].

    .. math:: \mathcal{T} = \frac{1}{n}\left(O_{agg} + \mathcal{D}(n A)\right)
    """
    frames = agg.mpdus(frame_bytes)
    octets = frames * agg.subframe_bytes(frame_bytes)
    return (nt.O_AGG + data_time(octets, *UNICAST)) / frames


def uplink_airtime(frame_bytes: sp.Expr, model: Model = "linear") -> sp.Expr:
    """Return the airtime from a host to the access point [s]: always unicast."""
    return downlink_airtime(frame_bytes, "unicast", model)


def downlink_airtime(frame_bytes: sp.Expr, cast: Cast, model: Model = "linear") -> sp.Expr:
    """Return the airtime from the access point to one host, or once to all of them [s]."""
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
    # No station acknowledges a multicast frame, so it is never aggregated.
    return nt.O_MULTI + data_time(frame_bytes, *MULTICAST)
