"""Airtime of counted messages, and the airtime that a measured model expects."""

from functools import cache
from typing import Any, cast as typed

import numpy as np
import sympy as sp

from discostorm.fleet import Fleet
from discostorm.messages import Protocol, Transport, header_bytes
from discostorm.wifi import PAPER, Cast, Wifi, downlink_airtime, uplink_airtime
from discostorm_book.comparison import expected_count, single_hop
from discostorm_book.lab_counts import GridPoint


def transport_of(kind: str, zenoh: bool) -> Transport:
    """Return the transport of a counted message kind."""
    return "TCP" if zenoh and kind not in ("Scout", "Hello", "Join") else "UDP"


@cache
def _airtime_of_frame_and_byte(
    transport: Transport, cast: Cast, hop: str, wifi: Wifi
) -> tuple[float, float]:
    """Return the airtime of an empty frame with its headers, and of each byte of payload [s]."""
    length, headers = sp.Symbol("S"), header_bytes()[transport]
    on = {
        "up": uplink_airtime(length, wifi.model),
        "down": downlink_airtime(length, cast, wifi.model),
        "none": sp.Integer(0),
    }
    both = on["up"] + on["down"] if not hop else on[hop]
    empty, one = (float(both.subs(wifi.values() | {length: headers + n})) for n in (0, 1))
    return empty, one - empty


def airtime_counted(point: GridPoint, window: str, zenoh: bool, wifi: Wifi = PAPER) -> Any:
    """Return the airtime of all counted messages of a window, one value per run [s].

    Sums of frames and bytes suffice if each byte adds the same airtime, as on the paper's channel.
    """
    taken = np.zeros(len(point.ready))
    for (when, kind, about, cast, hop), runs in point.runs.items():
        if when == window and not about:
            frame, byte = _airtime_of_frame_and_byte(
                transport_of(kind, zenoh), typed(Cast, cast), hop, wifi
            )
            taken += frame * runs[:, 1] + byte * runs[:, 2]
    return taken


def airtime_expected(protocol: Protocol, fleet: Fleet, window: str, wifi: Wifi = PAPER) -> float:
    """Return the airtime that a model expects in a window [s], comparable to `airtime_counted`."""
    taken = 0.0
    for message in protocol.messages:
        frame, byte = _airtime_of_frame_and_byte(
            message.transport, message.cast, single_hop(message), wifi
        )
        count = expected_count(message, fleet, window)
        taken += count * (frame * message.frames + byte * message.payload.nominal)
    return taken
