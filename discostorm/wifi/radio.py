"""Wi-Fi channels from the standard's own parameters: 802.11a, g, n, ac and ax."""

from collections.abc import Iterable, Mapping
from fractions import Fraction
from math import isclose
from types import MappingProxyType
from typing import Any

import sympy as sp

from discostorm import _checks
from discostorm.data import read_data
from discostorm.wifi.aggregation import Aggregation
from discostorm.wifi.channel import Link, Padding, Wifi, data_time

_MICRO = 10**6
_MEGA = 10**6
_GIGA = 10**9
_RESPONSE_RATES = (6, 12, 24)

Row = dict[str, str]


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
    """Return the row of the value, or refuse the value with those that there are."""
    rows = list(rows)
    given = _checks.number(name, value, 0)
    for allowed, row in rows:
        if isclose(given, allowed, rel_tol=1e-9):
            return allowed, row
    known = [f"{allowed:g}" for allowed, _ in rows]
    listed = " or ".join(filter(None, (", ".join(known[:-1]), known[-1])))
    raise ValueError(f"{name} must be {listed}{unit} for {where}; got {value!r}")


def _preamble(standard: str, training_fields: int, he_ltf: Fraction) -> Fraction:
    """Return the duration of everything before the data [us]."""
    times = {"PPDU": 1, "training field": training_fields}
    parts = _rows("preambles", standard=standard)
    fixed = sum(Fraction(part["us"]) * times[part["once_per"]] for part in parts)
    return fixed + training_fields * he_ltf


def _response(frame: str, rate: int) -> Fraction:
    """Return the duration of a control frame at a rate [Mbit/s] of clause 17 [us]."""
    (octets,) = (int(row["bytes"]) for row in read_data("wifi/frames.csv") if row["name"] == frame)
    (row,) = _rows("basic_rates", rate_Mbit_s=rate)
    bits, added = int(row["bits_per_symbol"]), int(row["added_bits"])
    data = data_time(*map(sp.Integer, (octets, bits, added, 1, int(row["symbol_us"]))))
    return Fraction(row["preamble_us"]) + Fraction(int(data))


def _encoders(standard_row: Row, bits: int, exceptions: list[Row]) -> int:
    """Return the number of convolutional encoders; each adds its tail."""
    if exceptions:
        return int(exceptions[0]["encoders"])
    most = standard_row["bits_per_encoder"]
    return -(-bits // int(most)) if most else 1


def wifi_preset(
    standard: str,
    *,
    band: float | None = None,
    width: float = 20e6,
    streams: int = 1,
    mcs: int | None = None,
    guard_interval: float | None = None,
    multicast_rate: float | None = None,
    aifsn: int = 2,
    mpdus: int = 1,
    name: str | None = None,
) -> Wifi:
    r"""Return a Wi-Fi channel built from the parameters of the standard.

    The overhead of a unicast frame is :math:`\text{AIFS} + \frac{CW_{min}}{2} \text{slot}
    + \text{preamble} + \text{SIFS} + \text{ACK}`; of a multicast frame the first three.
    The back-off is that of an idle channel without collisions; there is no RTS, and in
    2.4 GHz no protection for 802.11b stations. An HE PPDU is counted without packet
    extension and without the extra symbol that LDPC needs now and then: for a single exchange
    a lower bound, but not for stations that count down together.

    Parameters
    ----------
    standard : {"802.11a", "802.11g", "802.11n", "802.11ac", "802.11ax"}
        With 802.11n in HT-mixed format and 802.11ax in HE SU format.
    band : float, optional
        2.4e9 or 5e9 [Hz]; if left out the highest one that the standard has here.
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
        Most frames in an A-MPDU [1], from 1 (no aggregation) to 64.
    name : str, optional
        What to call it; if left out standard, width, streams, and what is unusual.

    Returns
    -------
    Wifi
        With padding on both links.

    Raises
    ------
    ValueError
        If the standard has no such combination; names parameter, value and what it has.
    TypeError
        If an argument is not a number.

    References
    ----------
    IEEE Std 802.11-2020, clauses 9, 10, 15 to 19 and 21; IEEE Std 802.11ax-2021, clause
    27; each number with its clause in the package's ``data/wifi/*.csv``.

    Examples
    --------
    >>> import discostorm as ds
    >>> wifi = ds.wifi_preset("802.11n", streams=2)
    >>> round(wifi.unicast.rate / 1e6, 1), round(wifi.unicast.overhead * 1e6, 1)
    (144.4, 185.5)
    """
    made_from = {
        "standard": standard,
        "band": band,
        "width": width,
        "streams": streams,
        "mcs": mcs,
        "guard_interval": guard_interval,
        "multicast_rate": multicast_rate,
        "aifsn": aifsn,
        "mpdus": mpdus,
    }
    known = [row["standard"] for row in read_data("wifi/standards.csv")]
    if standard not in known:
        raise ValueError(
            f"standard must be {', '.join(known[:-1])} or {known[-1]}; got {standard!r}"
        )
    (own,) = _rows("standards", standard=standard)

    bands = own["bands_GHz"].split()
    in_band = [(float(b) * _GIGA, _rows("bands", band_GHz=b)[0]) for b in bands]
    hertz, timing = in_band[-1] if band is None else _choose("band", band, in_band, standard, " Hz")
    ghz = timing["band_GHz"]
    widths = [(float(row["width_MHz"]) * _MEGA, row) for row in _rows("widths", standard=standard)]
    width, width_row = _choose("width", width, widths, standard, " Hz")
    mhz = width_row["width_MHz"]
    counts = [(float(n), own) for n in range(1, int(own["streams_most"]) + 1)]
    streams = int(_choose("streams", streams, counts, standard)[0])

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
    index, coding = codings[-1] if mcs is None else _choose("mcs", mcs, codings, where)
    guards = [
        (float(row["guard_interval_us"]) / _MICRO, row)
        for row in _rows("symbols", standard=standard)
    ]
    shortest = min(guard for guard, _ in guards)
    wanted = shortest if guard_interval is None else guard_interval
    guard_interval, symbols = _choose("guard_interval", wanted, guards, standard, " s")
    basics = [
        (float(row["rate_Mbit_s"]) * _MEGA, row) for row in _rows("basic_rates", bands_GHz=ghz)
    ]
    basic_rate, basic = (
        basics[0]
        if multicast_rate is None
        else _choose("multicast_rate", multicast_rate, basics, f"{ghz} GHz", " bit/s")
    )
    if _checks.number("aifsn", aifsn, 2, 15) % 1:
        raise ValueError(
            f"aifsn must be a whole number of at least 2 and at most 15; got {aifsn!r}"
        )
    limits = _rows("ampdu", standard=standard)
    most = int(limits[0]["most_mpdus"]) if limits else 1
    if _checks.number("mpdus", mpdus, 1) > most or mpdus % 1:
        raise ValueError(
            f"mpdus must be a whole number of at least 1 and at most {most} for {standard}; "
            f"got {mpdus!r}"
        )

    # Microseconds as fractions, so that the sums are exact.
    sifs, extension = Fraction(timing["sifs_us"]), Fraction(timing["signal_extension_us"])
    slot = Fraction(timing["slot_us"])
    waiting = sifs + aifsn * slot + Fraction(timing["cw_min"]) / 2 * slot
    training_fields = streams + (streams == 3)
    preamble = _preamble(standard, training_fields, Fraction(symbols["he_ltf_us"]))
    ppdu = waiting + preamble + extension
    rate = max(r for r in _RESPONSE_RATES if r <= int(coding["reference_Mbit_s"]))
    answered = ppdu + sifs + extension

    # A symbol holds whole bits. In 802.11ax the product may not be whole, and the rates in
    # the standard's tables are those before rounding down (27.5).
    coded = int(width_row["data_subcarriers"]) * int(coding["coded_bits"]) * streams
    product = coded * Fraction(coding["coding_rate"])
    bits = int(product)
    encoders = _encoders(own, bits, [exceptions[int(index)]] if int(index) in exceptions else [])
    ldpc = standard == "802.11ax" and (int(mhz) > 20 or index > 9)
    tail = 0 if ldpc else encoders * int(own["tail_bits"])
    symbol, grid = Fraction(symbols["symbol_us"]), Fraction(symbols["grid_us"])
    added = int(own["service_bits"]) + tail
    unicast = Link(
        rate=float(product / symbol * _MEGA),
        overhead=float((answered + _response("ACK", rate)) / _MICRO),
        padding=Padding(bits, float(symbol / _MICRO), float(grid / _MICRO), added),
    )
    multicast = Link(
        rate=basic_rate,
        overhead=float(
            (waiting + Fraction(basic["preamble_us"]) + extension * (basic["extended"] == "yes"))
            / _MICRO
        ),
        padding=Padding(
            int(basic["bits_per_symbol"]),
            float(Fraction(basic["symbol_us"]) / _MICRO),
            float(Fraction(basic["symbol_us"]) / _MICRO),
            int(basic["added_bits"]),
        ),
    )
    aggregation = None
    if mpdus > 1:
        whole = (Fraction(limits[0]["most_us"]) - preamble) // grid * grid // symbol
        aggregation = Aggregation(
            mpdus=int(mpdus),
            most_bytes=min(int(limits[0]["most_bytes"]), int(whole * bits - added) // 8),
            overhead=float((answered + _response("BlockAck", rate)) / _MICRO),
        )
    unusual = (
        ", 2.4 GHz" if hertz != in_band[-1][0] else "",
        f", MCS {index:g}" if index != codings[-1][0] else "",
        f", {guard_interval * _MICRO:g} µs" if guard_interval > shortest else "",
        f", multicast {basic_rate / _MEGA:g} Mbit/s" if basic_rate != basics[0][0] else "",
        f", AIFSN {aifsn:g}" if aifsn != 2 else "",
        f", A-MPDU {mpdus:g}" if mpdus > 1 else "",
    )
    usual = f"{standard} {mhz} MHz {streams}x{streams}"
    full_name = name or usual + "".join(unusual)
    return Wifi(full_name, unicast, multicast, aggregation, tuple(made_from.items()))


def variant(wifi: Wifi, **changes: Any) -> Wifi | None:
    """Return a channel of `wifi_preset` with some of its arguments changed.

    None if the channel is not as `wifi_preset` made it.

    Raises
    ------
    ValueError
        If the standard has no such combination.
    TypeError
        If `wifi_preset` has no such argument.
    """
    made_from = dict(wifi.made_from)
    if not made_from or wifi_preset(**made_from, name=wifi.name) != wifi:
        return None
    return wifi_preset(**(made_from | changes))


def _named(*presets: Wifi) -> Mapping[str, Wifi]:
    return MappingProxyType({preset.name: preset for preset in presets})


#: Channels to choose from by name, such as ``WIFI["802.11ax 80 MHz 2x2"]``.
WIFI = _named(
    wifi_preset("802.11a"),
    wifi_preset("802.11g"),
    wifi_preset("802.11n", streams=2),
    wifi_preset("802.11n", streams=2, band=2.4e9),
    wifi_preset("802.11n", streams=2, width=40e6),
    wifi_preset("802.11ac", streams=2, width=80e6),
    wifi_preset("802.11ax", streams=2, band=2.4e9),
    wifi_preset("802.11ax", streams=2, width=80e6),
    wifi_preset("802.11ax", streams=2, width=160e6),
)
