"""Radios from the standard's own parameters: 802.11a, g, n, ac, ax and be."""

import re
from collections.abc import Hashable, Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from math import isclose
from types import MappingProxyType
from typing import Any

import sympy as sp

from discostorm import _checks
from discostorm.data import read_data
from discostorm.wifi.aggregation import Aggregation
from discostorm.wifi.channel import PAPER_LINKS, Link, Padding, Wifi, data_time

_MICRO = 10**6
_MEGA = 10**6
_GIGA = 10**9
#: Units in which people speak of a radio: those in which it is given, and the power of ten between.
_SHOWN = {"": ("", 0), "GHz": ("Hz", 9), "MHz": ("Hz", 6), "Mbit/s": ("bit/s", 6), "µs": ("s", -6)}
_RESPONSE_RATES = (6, 12, 24)

Row = dict[str, str]

#: What of a `Radio` is no number.
_WORDS = ("standard", "name")


@dataclass(frozen=True)
class Radio:
    r"""A radio by the parameters of the standard; what is left out the standard decides.

    `dataclasses.replace` changes one thing, `wifi` gives the channel of the closed form. All
    that follows from the parameters is a property in SI units. There is no RTS, and in 2.4 GHz
    no protection for 802.11b stations. An HE or EHT PPDU is counted without packet extension
    and without the extra symbol that LDPC needs now and then: of a single exchange a lower
    bound, but not of stations that count down together.

    Parameters
    ----------
    standard : {"802.11a", "802.11g", "802.11n", "802.11ac", "802.11ax", "802.11be"}
        With 802.11n in HT-mixed format, 802.11ax in HE SU format, and 802.11be in EHT MU
        format to a single user.
    band : float, optional
        2.4e9, 5e9 or 6e9 [Hz]; if left out the highest one that the standard has here.
    width : float, optional
        Width of the channel [Hz].
    streams : int, optional
        Spatial streams [1], at most 4.
    mcs : int, optional
        Modulation and coding of a stream [1], from 0 (HT-MCS 15 is ``mcs=7`` with two
        streams; in 802.11a and g, 0 to 7 are 6 to 54 Mbit/s). If left out the fastest.
    guard_interval : float, optional
        Guard interval [s]; if left out the shortest.
    multicast_rate : float, optional
        Basic rate of multicast frames [bit/s]: 6e6, 12e6, 24e6, and in 2.4 GHz 1e6 and
        2e6 (DSSS with the long preamble). If left out the lowest.
    aifsn : int, optional
        Slots after SIFS before the back-off [1], from 2 (DIFS) to 15; EDCA has 3 for best
        effort.
    mpdus : int, optional
        Most frames in an A-MPDU [1], from 1 (no aggregation) to what the standard allows:
        64, with 802.11ax 256, with 802.11be 1024.
    start_spacing : float, optional
        Least time between the starts of two MPDUs of an A-MPDU [s] that the receiver asks
        for: 0, 0.25e-6, 0.5e-6, 1e-6, 2e-6, 4e-6, 8e-6 or 16e-6. If left out 0, no demand.
    name : str, optional
        What to call it; if left out standard, width, streams, and what is unusual.

    Raises
    ------
    ValueError
        If the standard has no such combination; names parameter, value and what it has.
    TypeError
        If an argument is not a number, or the name not text.

    References
    ----------
    IEEE Std 802.11-2020, clauses 9, 10, 15 to 19 and 21; IEEE Std 802.11ax-2021, clause
    27; IEEE Std 802.11be-2024, clause 36; each number with its clause in the package's
    ``data/wifi/*.csv``.

    Examples
    --------
    >>> import discostorm as ds
    >>> radio = ds.Radio("802.11n", streams=2)
    >>> round(radio.rate / 1e6, 1), round(radio.wifi().unicast.overhead * 1e6, 1)
    (144.4, 185.5)
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
        _checks.plain_numbers(self)
        others = {key: value for key, value in vars(self).items() if key not in _WORDS}
        _checks.one_each(others.items())
        for key, value in others.items():
            if value is not None and not isinstance(value, Hashable):  # to be looked up
                _checks.one(key, value, "a number")
        _parts(self)  # raises if the standard has no such combination

    @property
    def slot(self) -> float:
        """Duration of a slot [s]."""
        return float(_parts(self).slot / _MICRO)

    @property
    def sifs(self) -> float:
        """Short interframe space [s]."""
        return float(_parts(self).sifs / _MICRO)

    @property
    def aifs(self) -> float:
        """Wait before the back-off [s]: SIFS and AIFSN slots, which are DIFS if AIFSN is 2."""
        return float(_parts(self).aifs / _MICRO)

    @property
    def cw_min(self) -> int:
        """Least contention window [slots]: the back-off is drawn from 0 to this."""
        return int(_parts(self).timing["cw_min"])

    @property
    def cw_max(self) -> int:
        """Greatest contention window [slots]."""
        return int(_parts(self).timing["cw_max"])

    @property
    def preamble(self) -> float:
        """Everything of a unicast PPDU before its data [s]."""
        return float(_parts(self).preamble / _MICRO)

    @property
    def multicast_preamble(self) -> float:
        """Everything of a multicast PPDU before its data [s]."""
        return float(Fraction(_parts(self).basic["preamble_us"]) / _MICRO)

    @property
    def signal_extension(self) -> float:
        """Silence that counts to each OFDM PPDU in 2.4 GHz [s]; multicast at DSSS has none."""
        return float(_parts(self).extension / _MICRO)

    @property
    def rate(self) -> float:
        """Data rate of unicast frames [bit/s]."""
        parts = _parts(self)
        return float(parts.bits_exact / parts.symbol * _MEGA)

    @property
    def basic_rate(self) -> float:
        """Data rate of multicast frames [bit/s]."""
        return float(_parts(self).basic["rate_Mbit_s"]) * _MEGA

    @property
    def padding(self) -> Padding:
        """How a unicast frame fills symbols."""
        parts = _parts(self)
        return Padding(
            int(parts.bits_exact),
            float(parts.symbol / _MICRO),
            float(parts.grid / _MICRO),
            parts.added,
        )

    @property
    def multicast_padding(self) -> Padding:
        """How a multicast frame fills symbols."""
        basic = _parts(self).basic
        symbol = float(Fraction(basic["symbol_us"]) / _MICRO)
        return Padding(int(basic["bits_per_symbol"]), symbol, symbol, int(basic["added_bits"]))

    @property
    def ack(self) -> float:
        """Duration of an acknowledgement with its preamble [s]."""
        return float(_response("ACK", _parts(self).response_rate) / _MICRO)

    @property
    def block_ack(self) -> float:
        """Duration of a block acknowledgement with its preamble [s]."""
        return float(_block_ack(_parts(self), int(self.mpdus)) / _MICRO)

    @property
    def most_bytes(self) -> int:
        """Longest A-MPDU [B] that the standard and the longest PPDU allow; 0 without any."""
        parts = _parts(self)
        if not parts.limits:
            return 0
        # What of the longest PPDU is left for data, in whole symbols.
        whole = (
            (Fraction(parts.limits["most_us"]) - parts.preamble)
            // parts.grid
            * parts.grid
            // parts.symbol
        )
        fits = int(whole * int(parts.bits_exact) - parts.added) // 8
        return min(int(parts.limits["most_bytes"]), fits)

    @property
    def least_subframe(self) -> int:
        """Least length of an A-MPDU subframe [B] that keeps the start spacing."""
        octets = Fraction(self.start_spacing).limit_denominator(10**9) * Fraction(self.rate) / 8
        word = 4  # subframes and empty delimiters are multiples of 4 octets
        return -(-octets // word) * word

    def wifi(self) -> Wifi:
        r"""Return the channel of the closed form.

        The overhead of a unicast frame is :math:`\text{AIFS} + \frac{CW_{min}}{2}
        \text{slot} + \text{preamble} + \text{SIFS} + \text{ACK}`; of a multicast frame the
        first three. The back-off is the mean of a single station that never collides.

        Returns
        -------
        Wifi
            With padding on both links, and with aggregation if `mpdus` is above 1.
        """
        parts = _parts(self)
        # Microseconds as fractions, so that the sums are exact.
        waiting = parts.aifs + Fraction(parts.timing["cw_min"]) / 2 * parts.slot
        answered = waiting + parts.preamble + parts.extension + parts.sifs + parts.extension
        extended = parts.extension * (parts.basic["extended"] == "yes")
        unicast = Link(
            rate=self.rate,
            overhead=float((answered + _response("ACK", parts.response_rate)) / _MICRO),
            padding=self.padding,
        )
        multicast = Link(
            rate=self.basic_rate,
            overhead=float((waiting + Fraction(parts.basic["preamble_us"]) + extended) / _MICRO),
            padding=self.multicast_padding,
        )
        aggregation = None
        if self.mpdus > 1:
            aggregation = Aggregation(
                mpdus=int(self.mpdus),
                most_bytes=self.most_bytes,
                overhead=float((answered + _block_ack(parts, int(self.mpdus))) / _MICRO),
                least_bytes=self.least_subframe,
            )
        return Wifi(self.name or parts.usual_name, unicast, multicast, aggregation, self)


@dataclass(frozen=True)
class _Parts:
    """What the standard says of a radio; times in microseconds, exact."""

    timing: Row
    basic: Row
    limits: Row | None
    slot: Fraction
    sifs: Fraction
    aifs: Fraction
    extension: Fraction
    preamble: Fraction
    symbol: Fraction
    grid: Fraction
    bits_exact: Fraction
    added: int
    response_rate: int
    usual_name: str


@cache
def _parts(radio: Radio) -> _Parts:
    """Return what the standard says of a radio, or refuse what it does not have."""
    standard = radio.standard
    known = [row["standard"] for row in read_data("wifi/standards.csv")]
    if standard not in known:
        raise ValueError(
            f"standard must be {', '.join(known[:-1])} or {known[-1]}; got {standard!r}"
        )
    (own,) = _rows("standards", standard=standard)

    bands = own["bands_GHz"].split()
    in_band = [(float(b) * _GIGA, _rows("bands", band_GHz=b)[0]) for b in bands]
    hertz, timing = (
        in_band[-1] if radio.band is None else _choose("band", radio.band, in_band, standard, "GHz")
    )
    ghz = timing["band_GHz"]
    widths = [
        (float(row["width_MHz"]) * _MEGA, row)
        for row in _rows("widths", standard=standard, bands_GHz=ghz)
    ]
    _, width = _choose("width", radio.width, widths, standard, "MHz")
    mhz = width["width_MHz"]
    counts = [(float(n), own) for n in range(1, int(own["streams_most"]) + 1)]
    streams = int(_choose("streams", radio.streams, counts, standard)[0])

    exceptions = {
        int(row["mcs"]): row
        for row in _rows("mcs_exceptions", standard=standard, width_MHz=mhz, streams=streams)
    }
    codings = [
        (float(row["mcs"]), row)
        for row in _rows("mcs", standards=standard)
        if exceptions.get(int(row["mcs"]), {}).get("encoders") != "0"
    ]
    where = f"{standard} at {mhz} MHz with {streams} spatial stream{'s'[: streams > 1]}"
    index, coding = codings[-1] if radio.mcs is None else _choose("mcs", radio.mcs, codings, where)
    guards = [
        (float(row["guard_interval_us"]) / _MICRO, row)
        for row in _rows("symbols", standard=standard)
    ]
    shortest = min(guard for guard, _ in guards)
    wanted = shortest if radio.guard_interval is None else radio.guard_interval
    guard_interval, symbols = _choose("guard_interval", wanted, guards, standard, "µs")
    basics = [
        (float(row["rate_Mbit_s"]) * _MEGA, row) for row in _rows("basic_rates", bands_GHz=ghz)
    ]
    basic_rate, basic = (
        basics[0]
        if radio.multicast_rate is None
        else _choose("multicast_rate", radio.multicast_rate, basics, f"{ghz} GHz", "Mbit/s")
    )
    _checks.whole("aifsn", radio.aifsn, 2, 15)
    limits = _rows("ampdu", standard=standard)
    most = int(limits[0]["most_mpdus"]) if limits else 1
    _checks.whole("mpdus", radio.mpdus, 1, most, f" for {standard}")
    spacings = [(float(row["us"]) / _MICRO, row) for row in read_data("wifi/start_spacings.csv")]
    _choose("start_spacing", radio.start_spacing, spacings, "an A-MPDU", "µs")

    slot, sifs = Fraction(timing["slot_us"]), Fraction(timing["sifs_us"])
    training_fields = streams + streams % 2 * (streams > 1)
    # A symbol holds whole bits. From 802.11ax on the product may not be whole, and the rates
    # in the standard's tables are those before rounding down (27.5).
    coded = int(width["data_subcarriers"]) * int(coding["coded_bits"]) * streams
    product = coded * Fraction(coding["coding_rate"])
    encoders = _encoders(own, int(product), exceptions.get(int(index)))
    ldpc = bool(own["bcc_most_MHz"]) and (
        int(mhz) > int(own["bcc_most_MHz"]) or index > int(own["bcc_most_mcs"])
    )
    unusual = (
        f", {ghz} GHz" if hertz != in_band[-1][0] else "",
        f", MCS {index:g}" if index != codings[-1][0] else "",
        f", {guard_interval * _MICRO:g} µs" if guard_interval > shortest else "",
        f", multicast {basic_rate / _MEGA:g} Mbit/s" if basic_rate != basics[0][0] else "",
        f", AIFSN {radio.aifsn:g}" if radio.aifsn != 2 else "",
        f", A-MPDU {radio.mpdus:g}" if radio.mpdus > 1 else "",
        f", start spacing {radio.start_spacing * _MICRO:g} µs" if radio.start_spacing else "",
    )
    return _Parts(
        timing=timing,
        basic=basic,
        limits=limits[0] if limits else None,
        slot=slot,
        sifs=sifs,
        aifs=sifs + int(radio.aifsn) * slot,
        extension=Fraction(timing["signal_extension_us"]),
        preamble=_preamble(standard, training_fields, Fraction(symbols["ltf_us"])),
        symbol=Fraction(symbols["symbol_us"]),
        grid=Fraction(symbols["grid_us"]),
        bits_exact=product,
        added=int(own["service_bits"]) + (0 if ldpc else encoders * int(own["tail_bits"])),
        response_rate=max(r for r in _RESPONSE_RATES if r <= int(coding["reference_Mbit_s"])),
        usual_name=f"{standard} {mhz} MHz {streams}x{streams}" + "".join(unusual),
    )


#: What may follow standard, width and streams in the name of a radio, in which unit of SI.
_UNUSUAL: tuple[tuple[str, str, float | Fraction], ...] = (
    (r"(\S+) GHz", "band", _GIGA),
    (r"MCS (\d+)", "mcs", 1),
    (r"(\S+) µs", "guard_interval", Fraction(1, _MICRO)),
    (r"multicast (\S+) Mbit/s", "multicast_rate", _MEGA),
    (r"AIFSN (\d+)", "aifsn", 1),
    (r"A-MPDU (\d+)", "mpdus", 1),
    (r"start spacing (\S+) µs", "start_spacing", Fraction(1, _MICRO)),
)


def radio_named(name: str) -> Radio:
    """Return the radio that gives itself this name, such as "802.11n 20 MHz 2x2, A-MPDU 64".

    It may be in any case of letters.

    Raises
    ------
    ValueError
        If the name is not made like that, or the standard has no such combination.
    """
    usual, *unusual = re.split(r", *", name.strip())
    made = re.fullmatch(r"(802\.11\w+) (\d+) MHz (\d)x\3", usual, re.IGNORECASE)
    if not made:
        raise ValueError(
            "the name of a radio must be like '802.11ac 80 MHz 2x2' or "
            f"'802.11n 20 MHz 2x2, A-MPDU 64'; got {name!r}"
        )
    given: dict[str, Any] = {"width": float(made[2]) * _MEGA, "streams": int(made[3])}
    for part in unusual:
        for pattern, field, unit in _UNUSUAL:
            found = re.fullmatch(pattern, part, re.IGNORECASE)
            if found and field not in given:
                try:
                    value = Fraction(found[1]) * Fraction(unit)
                except (ValueError, ZeroDivisionError):
                    continue
                given[field] = int(value) if unit == 1 else float(value)
                break
        else:
            raise ValueError(f"{part!r} is not what the name of a radio may have, or twice there")
    return Radio(made[1].lower(), **given)


def _rows(name: str, **wanted: object) -> list[Row]:
    """Return the rows of a Wi-Fi data file that have the wanted values."""
    return [
        row
        for row in read_data(f"wifi/{name}.csv")
        if all(str(value) in row[column].split() for column, value in wanted.items())
    ]


def _choose(
    name: str, value: Any, rows: Iterable[tuple[float, Row]], where: str, unit: str = ""
) -> tuple[float, Row]:
    """Return the row of the value, or refuse the value with those that there are.

    Parameters are in SI units; a refusal is in those in which people speak of them.
    """
    rows = list(rows)
    given = _checks.number(name, value, 0)
    for allowed, row in rows:
        if isclose(given, allowed, rel_tol=1e-9):
            return allowed, row
    si, power = _SHOWN[unit]
    one = 10.0**power
    known = [_checks.exactly(round(allowed / one, 9)) for allowed, _ in rows]
    listed = " or ".join(filter(None, (", ".join(known[:-1]), known[-1])))
    got = f"{given / one:.12g} {unit}" if unit else repr(value)
    if unit and not any(1e-3 < given / allowed < 1e3 for allowed, _ in rows):
        got = f"{value!r} {si}; {name} is in {si}, such as {known[0]}e{power}"
    raise ValueError(f"{name} must be {listed}{' ' * bool(unit)}{unit} for {where}; got {got}")


def _preamble(standard: str, training_fields: int, ltf: Fraction) -> Fraction:
    """Return the duration of everything before the data [us]."""
    times = {"PPDU": 1, "training field": training_fields}
    parts = _rows("preambles", standard=standard)
    fixed = sum(Fraction(part["us"]) * times[part["once_per"]] for part in parts)
    return fixed + training_fields * ltf


def _response(frame: str, rate: int) -> Fraction:
    """Return the duration of a control frame at a rate [Mbit/s] of clause 17 [us]."""
    (octets,) = (int(row["bytes"]) for row in read_data("wifi/frames.csv") if row["name"] == frame)
    (row,) = _rows("basic_rates", rate_Mbit_s=rate)
    bits, added = int(row["bits_per_symbol"]), int(row["added_bits"])
    data = data_time(*map(sp.Integer, (octets, bits, added, 1, int(row["symbol_us"]))))
    return Fraction(row["preamble_us"]) + Fraction(int(data))


def _block_ack(parts: _Parts, mpdus: int) -> Fraction:
    """Return the duration of a block acknowledgement whose bitmap has room for the MPDUs [us]."""
    bitmaps = [
        int(row["name"].removeprefix("BlockAck "))
        for row in read_data("wifi/frames.csv")
        if row["name"].startswith("BlockAck ")
    ]
    room = min(bitmap for bitmap in bitmaps if bitmap >= mpdus)
    return _response(f"BlockAck {room}", parts.response_rate)


def _encoders(standard_row: Row, bits: int, exception: Row | None) -> int:
    """Return the number of convolutional encoders; each adds its tail."""
    if exception:
        return int(exception["encoders"])
    most = standard_row["bits_per_encoder"]
    return -(-bits // int(most)) if most else 1


def _named(*radios: Radio) -> Mapping[str, Wifi]:
    return MappingProxyType({wifi.name: wifi for wifi in (radio.wifi() for radio in radios)})


#: Channels to choose from by name, such as ``WIFI["802.11ax 80 MHz 2x2"]``.
WIFI = _named(
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

#: The paper's channel: IEEE 802.11n, 2x2 MIMO, MCS 7 a stream (paper, Sec. IV-A and IV-B). Its
#: rates and overheads are as printed; its radio is the one whose rates these are.
PAPER = Wifi(
    "paper (802.11n)",
    PAPER_LINKS["unicast"],
    PAPER_LINKS["multicast"],
    radio=Radio("802.11n", band=5e9, streams=2, mcs=7, guard_interval=0.4e-6, multicast_rate=6e6),
)
