"""Quantities of one frame: bytes, rate and overhead, in the paper and by the standards."""

from collections.abc import Callable
from typing import Any

import sympy as sp

from discostorm.data import read_data
from discostorm.fleet import Fleet
from discostorm.messages import Message, Protocol, header_bytes
from discostorm.model import utilization
from discostorm.protocols import DDS, ZENOH
from discostorm.wifi import PAPER, Radio, airtime as airtime_of_frame

#: 802.11n, two streams in 5 GHz.
_CHANNEL_11N = Radio("802.11n", streams=2).wifi()


def _message(name: str) -> Message:
    (message,) = (m for p in (DDS, ZENOH) for m in p.messages if m.name == name)
    return message


def timestamps_bytes() -> float:
    """Return the length of the timestamps option of a TCP message [B]."""
    (row,) = (row for row in read_data("paper/parameter_ranges.csv") if "timestamps" in row["part"])
    return float(row["high"])


def payload_spread(message: str) -> float:
    """Return half the payload range of a message relative to its nominal value."""
    payload = _message(message).payload
    return (payload.high - payload.low) / 2 / payload.nominal


def multicast_cost(message: str) -> float:
    """Return the airtime of a frame as multicast downlink, relative to unicast."""
    up, down = _message(message).airtime_up(), _message(message).airtime_down()
    values = {**DDS.values(), **ZENOH.values(), **PAPER.values()}
    return float(down.subs(values) / up.subs(values))


def ht_rate_of_streams(mcs: float, streams: float, width: float = 20) -> float:
    """Return the fastest 802.11n rate with an MCS for each stream, and a width in MHz [bit/s]."""
    radio = Radio("802.11n", streams=int(streams), width=width * 1e6, mcs=int(mcs))
    return radio.wifi().unicast.rate


def overhead_with_backoff(cast: str) -> float:
    """Return the overhead of a frame from 802.11n timing [s]."""
    return (_CHANNEL_11N.multicast if cast == "multicast" else _CHANNEL_11N.unicast).overhead


def overhead_without_backoff(cast: str) -> float:
    """Return the overhead of a frame without the back-off, which the paper does not name [s]."""
    (band,) = (row for row in read_data("wifi/bands.csv") if row["band_GHz"] == "5")
    return overhead_with_backoff(cast) - float(band["cw_min"]) / 2 * float(band["slot_us"]) * 1e-6


def standard_bound(protocol: Protocol, *swarm: float) -> float:
    """Return U with 802.11n timing, a frame at a time, relative to U with the paper's."""
    fleet = Fleet.swarm(*swarm)
    return float(utilization(protocol, fleet, wifi=_CHANNEL_11N) / utilization(protocol, fleet))


#: Quantities of one expression each; ``data/paper/quantities.csv`` has words for them.
FORMULAS: dict[str, Callable[..., Any]] = {
    "header": lambda transport: header_bytes()[transport],
    "frame_bytes": lambda message: _message(message).frame_bytes,
    "bits_per_byte": lambda: int(airtime_of_frame(sp.Integer(1), sp.Integer(1), sp.Integer(0))),
    "ht_rate": lambda mcs: ht_rate_of_streams(mcs % 8, 1 + mcs // 8),
    # The paper rounds 144.44 to 144.4, so a rate that is higher by less is the same rate.
    "ht_rates_above": lambda streams, width: sum(
        ht_rate_of_streams(mcs, streams, width) > PAPER.unicast.rate * 1.001 for mcs in range(8)
    ),
    "lowest_basic_rate": lambda band: Radio("802.11n", band=band * 1e9).wifi().multicast.rate,
}
