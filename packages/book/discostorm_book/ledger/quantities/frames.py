"""Quantities of one frame: its bytes, its rate, its overhead, and what standards make of it."""

import sympy as sp

from discostorm.data import read_data
from discostorm.fleet import Fleet
from discostorm.messages import Message, Protocol, header_bytes
from discostorm.model import utilization
from discostorm.protocols import DDS, ZENOH
from discostorm.wifi import PAPER, Radio, airtime as airtime_of_frame


def header(transport: str) -> int:
    """Return the header bytes of a transport, from their parts [B]."""
    return header_bytes()[transport]


def timestamps_bytes() -> float:
    """Return what the timestamps option adds to the headers of a TCP message [B]."""
    (row,) = (row for row in read_data("paper/parameter_ranges.csv") if "timestamps" in row["part"])
    return float(row["high"])


def _message(name: str) -> Message:
    (message,) = (m for p in (DDS, ZENOH) for m in p.messages if m.name == name)
    return message


def frame_bytes(message: str) -> float:
    """Return the frame length of a message: payload and headers [B]."""
    return _message(message).frame_bytes


def payload_spread(message: str) -> float:
    """Return half the payload range of a message relative to its nominal value."""
    payload = _message(message).payload
    return (payload.high - payload.low) / 2 / payload.nominal


def multicast_cost(message: str) -> float:
    """Return the airtime of a frame as multicast downlink, relative to unicast."""
    up, down = _message(message).airtime_up(), _message(message).airtime_down()
    values = {**DDS.values(), **ZENOH.values(), **PAPER.values()}
    return float(down.subs(values) / up.subs(values))


def bits_per_byte() -> int:
    """Return the factor between bytes and bits in the airtime of a frame."""
    return int(airtime_of_frame(sp.Integer(1), sp.Integer(1), sp.Integer(0)))


def ht_rate(mcs: float) -> float:
    """Return the fastest rate of an MCS of 802.11n in 20 MHz [bit/s], by its own index."""
    return ht_rate_of_streams(mcs % 8, 1 + mcs // 8)


def ht_rate_of_streams(mcs: float, streams: float) -> float:
    """Return the fastest rate in 20 MHz with an MCS of each of some streams [bit/s]."""
    return Radio("802.11n", streams=int(streams), mcs=int(mcs)).wifi().unicast.rate


def ht_rates_above(streams: float, width: float) -> int:
    """Return how many rates with some streams and a width in MHz exceed the paper's."""
    # The paper's 144.4 stands for 144.44: what exceeds it by less is the same rate.
    threshold = PAPER.unicast.rate * 1.001
    radios = (
        Radio("802.11n", streams=int(streams), width=width * 1e6, mcs=mcs) for mcs in range(8)
    )
    return sum(radio.wifi().unicast.rate > threshold for radio in radios)


def lowest_basic_rate(band: float) -> float:
    """Return the lowest basic rate of 802.11n in a band in GHz [bit/s]."""
    return Radio("802.11n", band=band * 1e9).wifi().multicast.rate


def overhead_with_backoff(cast: str) -> float:
    """Return the overhead of a frame from 802.11n timing, two streams in 5 GHz [s]."""
    wifi = Radio("802.11n", streams=2).wifi()
    return (wifi.multicast if cast == "multicast" else wifi.unicast).overhead


def overhead_of_named_intervals(cast: str) -> float:
    """Return that overhead without the back-off, which the paper does not name [s]."""
    (band,) = (row for row in read_data("wifi/bands.csv") if row["band_GHz"] == "5")
    return overhead_with_backoff(cast) - float(band["cw_min"]) / 2 * float(band["slot_us"]) * 1e-6


def standard_bound(protocol: Protocol, *swarm: float) -> float:
    """Return U with 802.11n timing, a frame at a time, relative to U with the paper's."""
    standard = Radio("802.11n", streams=2).wifi()
    return float(
        utilization(protocol, Fleet.swarm(*swarm), wifi=standard)
        / utilization(protocol, Fleet.swarm(*swarm))
    )
