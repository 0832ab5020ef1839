"""Wi-Fi: channels, the airtime of a frame, aggregation, the standard's radios."""

from discostorm.wifi.aggregation import Aggregation as Aggregation
from discostorm.wifi.airtime import (
    BITS_PER_BYTE as BITS_PER_BYTE,
    UNICAST as UNICAST,
    Cast as Cast,
    Model as Model,
    aggregated_airtime as aggregated_airtime,
    airtime as airtime,
    bits_airtime as bits_airtime,
    data_time as data_time,
    downlink_airtime as downlink_airtime,
    uplink_airtime as uplink_airtime,
)
from discostorm.wifi.channel import Link as Link, OfdmSymbols as OfdmSymbols, Wifi as Wifi
from discostorm.wifi.radio import PAPER as PAPER, WIFI as WIFI, Radio as Radio
