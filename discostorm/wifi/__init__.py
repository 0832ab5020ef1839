"""What the air costs: channels, the airtime of a frame, aggregation, the standard's radios."""

from discostorm.wifi.aggregation import Aggregation
from discostorm.wifi.channel import (
    BITS_PER_BYTE,
    MULTICAST,
    UNICAST,
    Cast,
    Link,
    Model,
    OfdmSymbols,
    aggregated_airtime,
    airtime,
    bits_airtime,
    data_time,
    downlink_airtime,
    uplink_airtime,
)
from discostorm.wifi.radio import PAPER, WIFI, Radio, Wifi

__all__ = [
    "BITS_PER_BYTE",
    "MULTICAST",
    "PAPER",
    "UNICAST",
    "WIFI",
    "Aggregation",
    "Cast",
    "Link",
    "Model",
    "OfdmSymbols",
    "Radio",
    "Wifi",
    "aggregated_airtime",
    "airtime",
    "bits_airtime",
    "data_time",
    "downlink_airtime",
    "uplink_airtime",
]
