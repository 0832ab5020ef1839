"""The symbols of the paper, each with its meaning, unit and source."""

import re
from dataclasses import dataclass
from functools import partial

import sympy as sp


@dataclass(frozen=True)
class Quantity:
    """One row of the notation table."""

    symbol: sp.Symbol
    meaning: str
    unit: str
    source: str


NOTATION: dict[str, Quantity] = {}


def _define(name: str, meaning: str, unit: str, source: str, *, zero: bool = False) -> sp.Symbol:
    symbol = sp.Symbol(name, nonnegative=True) if zero else sp.Symbol(name, positive=True)
    NOTATION[name] = Quantity(symbol, meaning, unit, source)
    return symbol


_nonnegative = partial(_define, zero=True)

N_H = _define("N_H", "hosts in the network, one per robot", "1", "paper, Sec. III-A")
N_P = _define("N_P", "processes on a host", "1", "paper, Sec. III-A")
N_E = _nonnegative("N_E", "endpoints of a process", "1", "paper, Sec. III-A")

H_UDP = _define("H_UDP", "header bytes of a UDP message", "B", "paper, Sec. IV-A")
H_TCP = _define("H_TCP", "header bytes of a TCP message", "B", "paper, Sec. IV-A")

R_UNI = _define("R_uni", "data rate of unicast frames", "bit/s", "paper, Sec. IV-A")
R_MULTI = _define("R_multi", "data rate of multicast frames", "bit/s", "paper, Sec. IV-A")
O_UNI = _nonnegative("O_uni", "fixed airtime of a unicast frame", "s", "paper, Sec. IV-B")
O_MULTI = _nonnegative("O_multi", "fixed airtime of a multicast frame", "s", "paper, Sec. IV-B")

_TXTIME = "IEEE Std 802.11-2020, 17.4.3, 19.4.3 and 21.4.3"
N_DBPS_UNI = _define("N_DBPS_uni", "data bits in a symbol, unicast", "bit", _TXTIME)
N_DBPS_MULTI = _define("N_DBPS_multi", "data bits in a symbol, multicast", "bit", _TXTIME)
_ADDED = "bits added to a {} frame (SERVICE, tail)"
N_ADD_UNI = _nonnegative("N_add_uni", _ADDED.format("unicast"), "bit", _TXTIME)
N_ADD_MULTI = _nonnegative("N_add_multi", _ADDED.format("multicast"), "bit", _TXTIME)
T_GRID_UNI = _define("t_grid_uni", "what a unicast frame is rounded up to", "s", _TXTIME)
T_GRID_MULTI = _define("t_grid_multi", "what a multicast frame is rounded up to", "s", _TXTIME)
_SYMBOL_TIME = "symbol time as a part of what a {} frame is rounded up to"
K_UNI = _define("k_uni", _SYMBOL_TIME.format("unicast"), "1", _TXTIME)
K_MULTI = _define("k_multi", _SYMBOL_TIME.format("multicast"), "1", _TXTIME)

N_AGG = _define("n_agg", "most frames in an A-MPDU", "1", "IEEE Std 802.11-2020, 10.25")
A_MAX = _define("A_most", "longest A-MPDU", "B", "IEEE Std 802.11-2020, 9.7 and 10.12")
A_MIN = _nonnegative("A_least", "least subframe of an A-MPDU", "B", "IEEE Std 802.11-2020, 10.12.3")
O_AGG = _nonnegative("O_agg", "fixed airtime of an A-MPDU", "s", "IEEE Std 802.11-2020, 9.3.1.8")

W = _define("W", "window over which utilization is averaged", "s", "paper, Sec. IV-B: 1 s")
U_LIMIT = _define("U_limit", "utilization called saturated (1 is 100%)", "1", "paper, Sec. IV-C")


def payload_symbol(message: str) -> sp.Symbol:
    """Return the symbol of a message's payload size, in bytes: ``s_`` and its name.

    The name has no spaces or commas, because the symbol becomes a name in other languages.
    """
    return sp.Symbol("s_" + re.sub(r"\W", "", message), positive=True)
