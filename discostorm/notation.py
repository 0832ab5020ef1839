"""The symbols of the paper: what each means, its unit, and where it is defined."""

from dataclasses import dataclass

import sympy as sp


@dataclass(frozen=True)
class Quantity:
    """One row of the notation table."""

    symbol: sp.Symbol
    meaning: str
    unit: str
    source: str


NOTATION: dict[str, Quantity] = {}


def _define(
    name: str, meaning: str, unit: str, source: str, *, zero: bool = False
) -> sp.Symbol:
    symbol = sp.Symbol(name, nonnegative=True) if zero else sp.Symbol(name, positive=True)
    NOTATION[name] = Quantity(symbol, meaning, unit, source)
    return symbol


N_H = _define("N_H", "hosts in the network, one per robot", "1", "paper, Sec. III-A")
N_P = _define("N_P", "processes on a host", "1", "paper, Sec. III-A")
N_E = _define("N_E", "endpoints of a process", "1", "paper, Sec. III-A", zero=True)

H_UDP = _define("H_UDP", "header bytes of a UDP message", "B", "paper, Sec. IV-A")
H_TCP = _define("H_TCP", "header bytes of a TCP message", "B", "paper, Sec. IV-A")

R_UNI = _define("R_uni", "data rate of unicast frames", "bit/s", "paper, Sec. IV-A")
R_MULTI = _define("R_multi", "data rate of multicast frames", "bit/s", "paper, Sec. IV-A")
O_UNI = _define("O_uni", "fixed airtime of a unicast frame", "s", "paper, Sec. IV-B", zero=True)
O_MULTI = _define(
    "O_multi", "fixed airtime of a multicast frame", "s", "paper, Sec. IV-B", zero=True
)

U_LIMIT = _define("U_limit", "utilization called saturated (1 is 100 %)", "1", "paper, Sec. IV-C")


def payload_symbol(message: str) -> sp.Symbol:
    """Return the symbol of a message's payload size, in bytes: ``s_`` and its name."""
    return sp.Symbol(f"s_{message}", positive=True)
