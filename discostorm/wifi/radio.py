"""Radios from the standard's own parameters: 802.11a, g, n, ac, ax and be; presets, by name."""

import re
from collections.abc import Hashable
from contextlib import suppress
from dataclasses import dataclass, fields, replace
from fractions import Fraction
from typing import Any, TypeAlias

from discostorm import _checks, _names
from discostorm.data import read_data
from discostorm.wifi.aggregation import Aggregation
from discostorm.wifi.channel import PAPER_LINKS, Link, OfdmSymbols, Wifi
from discostorm.wifi.standard import GIGA, MEGA, MICRO, StandardParameters, standard_parameters

#: The topology of every channel.
TOPOLOGY = "one access point in infrastructure mode"

#: Maximum number of frames in an A-MPDU of two stations that aggregate by default, as all from
#: 802.11n on do: the block acknowledgement window of 802.11n and ac (``data/wifi/ampdu.csv``).
USUAL_MPDUS = 64


class _DerivedQuantities:
    """Quantities that follow from the parameters of a radio, in SI units."""

    carrier: float  #: frequency band [Hz]; by default that of the standard
    slot: float  #: duration of a slot [s]
    sifs: float  #: short interframe space [s]
    aifs: float  #: wait before the back-off [s]: SIFS and AIFSN slots; DIFS if 2
    cw_min: int  #: minimum contention window [slots]: a back-off is from 0 to this
    cw_max: int  #: maximum contention window [slots]
    preamble: float  #: duration of a unicast PPDU before its data [s]
    multicast_preamble: float  #: duration of a multicast PPDU before its data [s]
    ack: float  #: duration of an acknowledgement with its preamble [s]
    block_ack: float  #: duration of a block acknowledgement with its preamble [s]
    signal_extension: float  #: silence after each OFDM PPDU in 2.4 GHz [s]
    rate: float  #: data rate of unicast frames [bit/s]
    basic_rate: float  #: data rate of multicast frames [bit/s]


@dataclass(frozen=True, repr=False)
class Radio(_DerivedQuantities):
    """A radio, described by the standard's parameters; omitted ones get defaults.

    `wifi` gives the channel of the closed form, `carrier` to `least_subframe` follow in SI units;
    ``data/wifi/*.csv`` has the clause of each number. There is no RTS, and in 2.4 GHz no protection
    for 802.11b stations. An HE or EHT PPDU has no packet extension and no extra LDPC symbol, which
    is a lower bound for single frame exchanges, but not for stations that back off concurrently.

    Parameters
    ----------
    standard : {"802.11a", "802.11g", "802.11n", "802.11ac", "802.11ax", "802.11be"}
        Formats: 802.11n HT-mixed, 802.11ax HE SU, and 802.11be EHT MU to a single user.
    band : float, optional
        2.4e9, 5e9 or 6e9 [Hz]; the standard's highest if left out.
    width : float, optional
        Width of the channel [Hz].
    streams : int, optional
        Spatial streams [1], at most 4.
    mcs : int, optional
        Modulation and coding of a stream [1], from 0 (HT-MCS 15 is ``mcs=7`` with two streams; in
        802.11a and g, 0 to 7 are 6 to 54 Mbit/s). The fastest if left out.
    guard_interval : float, optional
        Guard interval [s]; the shortest if left out.
    multicast_rate : float, optional
        Basic rate of multicast frames [bit/s]: 6e6, 12e6, 24e6, and in 2.4 GHz 1e6 and 2e6 (DSSS
        with the long preamble). The lowest if left out.
    aifsn : int, optional
        Slots after SIFS before the back-off [1], from 2 (DIFS) to 15; EDCA has 3 for best effort.
    mpdus : int, optional
        Maximum number of frames in an A-MPDU [1], from 1 (no aggregation) to the standard's limit.
    start_spacing : float, optional
        Minimum MPDU Start Spacing in an A-MPDU [s] that the receiver asks for; 0 if left out.
    name : str, optional
        What to call it; standard, width, streams and unusual parameters if left out.
    """

    standard: str
    band: float | None = None
    width: float = 20e6
    streams: int = 1
    mcs: int | None = None
    guard_interval: float | None = None
    multicast_rate: float | None = None
    aifsn: int = 2
    mpdus: int = 1
    start_spacing: float = 0.0
    name: str | None = None

    def __post_init__(self) -> None:
        if self.name is not None:
            _checks.instance("name", self.name, str)
        _checks.instance("standard", self.standard, str)
        _checks.unwrap_0d_arrays(self)
        for key, value in self._all_parameters().items():
            if value is not None and key != "standard":
                _checks.require_scalars([(key, value)])
                if not isinstance(value, Hashable):  # the parts are looked up by this value
                    _checks.number(key, value, 0)
        parts = self._standard_parameters  # raises if the standard has no such combination
        derived = {
            "carrier": float(parts.timing["band_GHz"]) * GIGA,
            "cw_min": int(parts.timing["cw_min"]),
            "cw_max": int(parts.timing["cw_max"]),
            "multicast_preamble": float(Fraction(parts.basic["preamble_us"]) / MICRO),
            "signal_extension": float(parts.signal_extension / MICRO),
            "rate": float(parts.bits_exact / parts.symbol * MEGA),
            "basic_rate": float(parts.basic["rate_Mbit_s"]) * MEGA,
        }
        for name in ("slot", "sifs", "aifs", "preamble", "ack", "block_ack"):
            derived[name] = float(getattr(parts, name) / MICRO)
        for name, value in derived.items():
            object.__setattr__(self, name, value)

    def __repr__(self) -> str:
        own = ((f.name, getattr(self, f.name), f.default) for f in fields(self)[1:])
        given = [f", {name}={value!r}" for name, value, usual in own if value != usual]
        return _checks.shorten_repr(f"Radio({self.standard!r}{''.join(given)})")

    def _all_parameters(self) -> dict[str, Any]:
        return {f.name: getattr(self, f.name) for f in fields(self) if f.name != "name"}

    @property
    def _standard_parameters(self) -> StandardParameters:
        return standard_parameters(**self._all_parameters())

    @property
    def padding(self) -> OfdmSymbols:
        """The symbols of a unicast frame."""
        parts = self._standard_parameters
        symbol, grid = float(parts.symbol / MICRO), float(parts.grid / MICRO)
        return OfdmSymbols(int(parts.bits_exact), symbol, grid, parts.added)

    @property
    def multicast_padding(self) -> OfdmSymbols:
        """The symbols of a multicast frame."""
        basic = self._standard_parameters.basic
        symbol = float(Fraction(basic["symbol_us"]) / MICRO)
        return OfdmSymbols(int(basic["bits_per_symbol"]), symbol, symbol, int(basic["added_bits"]))

    @property
    def most_bytes(self) -> int:
        """Maximum A-MPDU length [B] by the standard and the longest PPDU; 0 without aggregation."""
        parts = self._standard_parameters
        if not parts.ampdu_limits:
            return 0
        # Whole symbols that the longest PPDU leaves for data.
        left = Fraction(parts.ampdu_limits["most_us"]) - parts.preamble
        whole = left // parts.grid * parts.grid // parts.symbol
        fits = int(whole * int(parts.bits_exact) - parts.added) // 8
        return min(int(parts.ampdu_limits["most_bytes"]), fits)

    @property
    def least_subframe(self) -> int:
        """Minimum length of an A-MPDU subframe [B] that keeps the start spacing."""
        octets = Fraction(self.start_spacing).limit_denominator(10**9) * Fraction(self.rate) / 8
        word = 4  # subframes and empty delimiters are multiples of 4 octets
        return -(-octets // word) * word

    def wifi(self) -> Wifi:
        """Return the channel of the closed form; with aggregation if `mpdus` is above 1.

        A unicast frame has as overhead AIFS, a back-off of half of CWmin slots (the mean of a
        single station), preamble, SIFS and ACK. A multicast frame lacks SIFS and ACK.
        """
        parts = self._standard_parameters
        # Microseconds as fractions, so that the sums are exact.
        waiting = parts.aifs + Fraction(parts.timing["cw_min"]) / 2 * parts.slot
        answered = waiting + parts.preamble + parts.sifs + 2 * parts.signal_extension
        extended = parts.signal_extension if parts.basic["extended"] == "yes" else 0
        to_all = waiting + Fraction(parts.basic["preamble_us"]) + extended
        unicast = Link(self.rate, float((answered + parts.ack) / MICRO), self.padding)
        multicast = Link(self.basic_rate, float(to_all / MICRO), self.multicast_padding)
        aggregation = None
        if self.mpdus > 1:
            overhead, least = float((answered + parts.block_ack) / MICRO), self.least_subframe
            aggregation = Aggregation(int(self.mpdus), self.most_bytes, overhead, least)
        return Wifi(self.name or parts.usual_name, unicast, multicast, aggregation, self)


#: Parts of a radio's name besides its standard: pattern, parameter, SI unit.
_NAME_PARTS: tuple[tuple[str, str, float | Fraction], ...] = (
    (r"([\d.]+) ?MHz", "width", MEGA),
    (r"(\d)x\1", "streams", 1),
    (r"([\d.]+) ?GHz", "band", GIGA),
    (r"MCS (\d+)", "mcs", 1),
    (r"multicast ([\d.]+) Mbit/s", "multicast_rate", MEGA),
    (r"AIFSN (\d+)", "aifsn", 1),
    (r"A-MPDU (\d+)", "mpdus", 1),
    (r"start spacing ([\d.]+) µs", "start_spacing", Fraction(1, MICRO)),
    (r"([\d.]+) µs", "guard_interval", Fraction(1, MICRO)),
)


def radio_named(name: str) -> Radio:
    """Return the radio of a name such as "802.11n 20 MHz 2x2, A-MPDU 64", in any case and order.

    Without a width or streams it has those of the first preset of its standard in `WIFI`. If
    `data/wifi/uncovered_networks.csv` has such a network, the ValueError says why.
    """
    for row in read_data("wifi/uncovered_networks.csv"):
        if re.search(rf"\b({row['names']})\b", name.replace("_", " "), re.IGNORECASE):
            raise ValueError(
                f"{row['what']} {row['verb']} not covered (answers are for {TOPOLOGY}). "
                f"{row['why']} For a rough answer, choose the radio of one access point, such as "
                f"'802.11ac 80 MHz 2x2'; got {name!r}"
            )
    like = "like '802.11ac 80 MHz 2x2' or '802.11n 20 MHz 2x2, A-MPDU 64'"
    standard = re.search(r"802\.11[a-z]+", name, re.IGNORECASE)
    if not standard:
        raise ValueError(
            f"the name of a radio must be {like}; got {_checks.shorten_name(name)!r}"
            f"{_names.did_you_mean(name, WIFI) or _names.did_you_mean(f'802.11{name}', WIFI)}"
        )
    rest = name.replace(standard[0], ",", 1)
    presets = [wifi.radio for wifi in WIFI.values() if wifi.radio]
    usual = [radio for radio in presets if radio.standard == standard[0].lower()]
    given: dict[str, Any] = {"width": usual[0].width, "streams": usual[0].streams} if usual else {}
    for pattern, key, unit in _NAME_PARTS:
        part = re.search(rf"(?<![^\s,]){pattern}(?![^\s,])", rest, re.IGNORECASE)
        with suppress(ValueError, ZeroDivisionError):
            if part:
                value = Fraction(part[1]) * Fraction(unit)
                given[key] = int(value) if unit == 1 else float(value)
                rest = rest.replace(part[0], ",", 1)
    if left := [part for part in re.split(r"\s*,\s*", rest.strip()) if part]:
        raise ValueError(
            f"{_checks.shorten_name(left[0])!r} cannot be in the name of a radio, or is "
            f"there twice; the name must be {like}{_names.did_you_mean(name, WIFI)}"
        )
    return Radio(standard[0].lower(), **given)


def most_mpdus(standard: str) -> int:
    """Return the maximum number of frames in an A-MPDU of a standard [1]; 1 if it has none."""
    rows = (row for row in read_data("wifi/ampdu.csv") if row["standard"] == standard)
    return max((int(row["most_mpdus"]) for row in rows), default=1)


def aggregation_bounds(wifi: Wifi) -> tuple[Wifi, Wifi]:
    """Return the two channels that bound a radio's aggregation: full A-MPDUs, and none.

    Radios from 802.11n on aggregate by default, but the queues decide how full their exchanges are.
    For 802.11a and g, `PAPER`, and a changed channel of a radio, it is the channel itself, twice.
    """
    radio = wifi.radio
    if radio is None or most_mpdus(radio.standard) == 1:
        return wifi, wifi
    usual = radio.wifi()
    if replace(usual, name=wifi.name) != wifi:
        return wifi, wifi
    most = min(USUAL_MPDUS, most_mpdus(radio.standard))
    mpdus = int(radio.mpdus) if radio.mpdus > 1 else most
    name = radio.name or (wifi.name if wifi.name != usual.name else None)
    full, single = (replace(radio, mpdus=n, name=name).wifi() for n in (mpdus, 1))
    return full, single


_RADIOS = (
    Radio("802.11a"),
    Radio("802.11g"),
    Radio("802.11n", streams=2),
    Radio("802.11n", streams=2, band=2.4e9),
    Radio("802.11n", streams=2, width=40e6),
    Radio("802.11ac", streams=2, width=80e6),
    Radio("802.11ax", streams=2, band=2.4e9),
    Radio("802.11ax", streams=2, width=80e6),
    Radio("802.11ax", streams=2, width=160e6),
    Radio("802.11be", streams=2, width=80e6),
    Radio("802.11be", streams=2, width=320e6),
)
#: Channels to choose from by name, such as ``WIFI["802.11ax 80 MHz 2x2"]``.
WIFI = _names.Catalog("wifi", {wifi.name: wifi for wifi in (radio.wifi() for radio in _RADIOS)})

#: The paper's channel: IEEE 802.11n, 2x2 MIMO, MCS 7 a stream (paper, Sec. IV-A and IV-B). Its
#: rates and overheads are as printed; its radio is the one whose rates these are.
PAPER = Wifi(
    "paper (802.11n)",
    PAPER_LINKS["unicast"],
    PAPER_LINKS["multicast"],
    radio=Radio("802.11n", band=5e9, streams=2, mcs=7, guard_interval=0.4e-6, multicast_rate=6e6),
)

#: A channel, a radio, or its name.
AnyWifi: TypeAlias = Wifi | Radio | str


def as_wifi(wifi: AnyWifi) -> Wifi:
    """Return a given channel, or the channel of a radio or a name: "paper", "802.11ac 80 MHz"."""
    if isinstance(wifi, str):
        if _names.normalize(wifi) == "paper":
            return PAPER
        try:
            wifi = radio_named(wifi)
        except ValueError as error:
            names = ", ".join(map(repr, ("paper", *WIFI)))
            raise ValueError(f"wifi must be {names} or another radio: {error}") from error
    if isinstance(wifi, Radio):
        return wifi.wifi()
    _checks.instance("wifi", wifi, Wifi)
    return wifi
