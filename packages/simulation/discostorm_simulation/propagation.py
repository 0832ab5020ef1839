"""Positions of hosts, and the power with which stations receive each other."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from discostorm import _checks

#: Capture thresholds [dB]: 802.11n's sensitivity for 64-QAM 5/6 (-64 dBm) and BPSK 1/2 (-82 dBm),
#: less noise of -101 + 15 dBm (IEEE Std 802.11-2020, 17.3.10.2 and Table 19-23).
THRESHOLD = (22.0, 4.0)
#: Maximum distance of a power from 0 dB [dB].
MAX_DECIBELS = 300.0
#: Golden angle: the angle between successive seeds of a sunflower [rad].
_GOLDEN_ANGLE = np.pi * (3 - np.sqrt(5))


def disc(hosts: int) -> NDArray[np.float64]:
    """Return positions of hosts spread evenly over a disc around the access point [radii].

    As a sunflower's seeds (H. Vogel, Mathematical Biosciences 44, 1979, 179-189).
    """
    _checks.integer("hosts", hosts, 1)
    number = np.arange(int(hosts))
    radius, angle = np.sqrt((number + 0.5) / hosts), number * _GOLDEN_ANGLE
    return np.stack([radius * np.cos(angle), radius * np.sin(angle)], axis=1)


def powers(places: ArrayLike, exponent: float = 3.0) -> NDArray[np.float64]:
    """Return the received power at [sender, receiver] [dB]: access point last, 0 at distance 1.

    `places` has a row for each host [any unit]; the access point is at (0, 0). `exponent` is the
    path loss exponent, from 0 to 10: 2 in free space, 3 is the default of ns-3.

    >>> from discostorm_simulation import powers
    >>> powers([(1, 0), (0, 10)])[:, 2]  # from both hosts to the access point
    array([  0., -30.,   0.])
    """
    given = np.asarray(_checks.numbers("places", places, -1e9, 1e9))
    _checks.number("exponent", exponent, 0, 10)
    if given.ndim != 2 or given.shape[1] != 2:
        raise ValueError(f"places must be of shape (hosts, 2); got {given.shape}")
    stations = np.concatenate([given, np.zeros((1, 2))])
    distance = np.hypot(*(stations[:, None] - stations).transpose(2, 0, 1))
    np.fill_diagonal(distance, 1.0)
    if not distance.all():
        raise ValueError("places must be distinct and not the access point (0, 0)")
    return np.asarray(0 - 10 * exponent * np.log10(distance))
