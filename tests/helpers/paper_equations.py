"""The paper's equations, written by hand with exact fractions, as an independent test oracle.

This module imports nothing from the package, on purpose.
"""

from fractions import Fraction

R_UNI = Fraction("144.4e6")
R_MULTI = Fraction("6e6")
O_UNI = Fraction("180e-6")
O_MULTI = Fraction("120e-6")


def unicast(frame: int) -> Fraction:
    """Return the airtime of a unicast frame on uplink and downlink: equation (11), twice."""
    return 2 * (8 * frame / R_UNI + O_UNI)


def multicast(frame: int) -> Fraction:
    """Return the airtime of a multicast frame: unicast uplink, multicast downlink."""
    return 8 * frame / R_UNI + O_UNI + 8 * frame / R_MULTI + O_MULTI


def messages(n_h: int, n_p: int, n_e: int) -> dict[tuple[str, str], int]:
    """Return the message counts of equations (1) to (10), by phase, for one host and for all."""
    remote = (n_h - 1) * n_p
    return {
        ("SPDP", "host"): n_p,
        ("SPDP", "all"): n_h * n_p,
        ("SEDP", "host"): n_p * remote * n_e + 4 * n_p * remote,
        ("SEDP", "all"): n_h * (n_h - 1) * n_p**2 * (n_e + 4),
        ("Scouting", "host"): n_p + (n_h - 1) * n_p**2,
        ("Scouting", "all"): n_h * n_p + n_h * (n_h - 1) * n_p**2,
        ("Declaration", "host"): (n_h - 1) * n_p**2 * n_e + 2 * (n_h - 1) * n_p**2,
        ("Declaration", "all"): n_h * (n_h - 1) * n_p**2 * (n_e + 2),
    }


def utilization(
    protocol: str, h: int | Fraction, p: int | Fraction, e: int | Fraction
) -> dict[str, Fraction]:
    """Return the utilization of each phase: equation (12) with (2), (5), (7) and (10)."""
    h, p, e = Fraction(h), Fraction(p), Fraction(e)
    pairs = h * (h - 1) * p**2
    if protocol == "DDS":
        return {
            "SPDP": h * p * multicast(414),
            "SEDP": pairs * (e * unicast(464) + 2 * unicast(116) + 2 * unicast(114)),
        }
    return {
        "Scouting": h * p * multicast(80) + pairs * unicast(144),
        "Declaration": pairs * (e * unicast(176) + 2 * unicast(84)),
    }


def total(protocol: str, h: int | Fraction, p: int | Fraction, e: int | Fraction) -> float:
    """Return the utilization of all phases, rounded once."""
    return float(sum(utilization(protocol, h, p, e).values()))
