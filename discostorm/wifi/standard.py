"""A radio's parameters and exact times, from the standard's tables in ``data/wifi/``."""

from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from math import isclose
from typing import Any

import sympy as sp

from discostorm import _checks, wording
from discostorm.data import read_data
from discostorm.wifi.airtime import data_time

MICRO = 10**6
MEGA = 10**6
GIGA = 10**9
#: For each unit of messages, the parameter's SI unit and the power of ten between both.
_UNITS = {"": ("", 0), "GHz": ("Hz", 9), "MHz": ("Hz", 6), "Mbit/s": ("bit/s", 6), "µs": ("s", -6)}
_RESPONSE_RATES = (6, 12, 24)

Row = dict[str, str]


@dataclass(frozen=True)
class StandardParameters:
    """The standard's parameters of a radio; times in microseconds, exact."""

    timing: Row
    basic: Row
    ampdu_limits: Row | None
    slot: Fraction
    sifs: Fraction
    aifs: Fraction
    signal_extension: Fraction
    preamble: Fraction
    symbol: Fraction
    grid: Fraction
    bits_exact: Fraction
    added: int
    ack: Fraction
    block_ack: Fraction
    usual_name: str


@cache
def standard_parameters(
    standard: str,
    band: float | None,
    width: float,
    streams: int,
    mcs: int | None,
    guard_interval: float | None,
    multicast_rate: float | None,
    aifsn: int,
    mpdus: int,
    start_spacing: float,
) -> StandardParameters:
    """Look up the parts of a `Radio`, or refuse a combination that the standard lacks."""
    standards = [row["standard"] for row in read_data("wifi/standards.csv")]
    if standard not in standards:
        known = wording.join_words(standards, "or")
        raise ValueError(f"standard must be {known}; got {standard!r}")
    (own,) = _rows("standards", standard=standard)

    bands = [_rows("bands", band_GHz=band)[0] for band in own["bands_GHz"].split()]
    in_band = _rows_in_si_units(bands, "band_GHz", GIGA)
    hertz, timing = (
        in_band[-1] if band is None else _row_of_value("band", band, in_band, standard, "GHz")
    )
    ghz = timing["band_GHz"]
    widths = _rows_in_si_units(_rows("widths", standard=standard, bands_GHz=ghz), "width_MHz", MEGA)
    _, channel = _row_of_value("width", width, widths, standard, "MHz")
    mhz = channel["width_MHz"]
    counts = [(float(n), own) for n in range(1, int(own["streams_most"]) + 1)]
    streams = int(_row_of_value("streams", streams, counts, standard)[0])

    unusual_rows = _rows("mcs_exceptions", standard=standard, width_MHz=mhz, streams=streams)
    exceptions = {row["mcs"]: row for row in unusual_rows}
    rows = _rows("mcs", standards=standard)
    codings = _rows_in_si_units(
        [row for row in rows if exceptions.get(row["mcs"], {}).get("encoders") != "0"], "mcs"
    )
    where = f"{standard} at {mhz} MHz with {wording.count_noun(streams, 'spatial stream')}"
    index, coding = codings[-1] if mcs is None else _row_of_value("mcs", mcs, codings, where)
    guards = _rows_in_si_units(_rows("symbols", standard=standard), "guard_interval_us", 1 / MICRO)
    shortest = min(guard for guard, _ in guards)
    wanted = shortest if guard_interval is None else guard_interval
    guard, symbols = _row_of_value("guard_interval", wanted, guards, standard, "µs")
    basics = _rows_in_si_units(_rows("basic_rates", bands_GHz=ghz), "rate_Mbit_s", MEGA)
    wanted = basics[0][0] if multicast_rate is None else multicast_rate
    basic_rate, basic = _row_of_value("multicast_rate", wanted, basics, f"{ghz} GHz", "Mbit/s")
    _checks.integer("aifsn", aifsn, 2, 15)
    limits = _rows("ampdu", standard=standard)
    most = int(limits[0]["most_mpdus"]) if limits else 1
    _checks.integer("mpdus", mpdus, 1, most, f" for {standard}")
    spacings = _rows_in_si_units(read_data("wifi/start_spacings.csv"), "us", 1 / MICRO)
    _row_of_value("start_spacing", start_spacing, spacings, "an A-MPDU", "µs")

    slot, sifs = Fraction(timing["slot_us"]), Fraction(timing["sifs_us"])
    training_fields = streams + streams % 2 if streams > 1 else 1
    # A symbol holds whole bits. From 802.11ax on the product may not be whole, and the rates
    # in the standard's tables are those before rounding down (27.5).
    coded = int(channel["data_subcarriers"]) * int(coding["coded_bits"]) * streams
    product = coded * Fraction(coding["coding_rate"])
    # Each convolutional encoder adds its tail.
    encoders = -(-int(product) // int(own["bits_per_encoder"])) if own["bits_per_encoder"] else 1
    if coding["mcs"] in exceptions:
        encoders = int(exceptions[coding["mcs"]]["encoders"])
    ldpc = bool(own["bcc_most_MHz"]) and (
        int(mhz) > int(own["bcc_most_MHz"]) or index > int(own["bcc_most_mcs"])
    )
    unusual = (
        f", {ghz} GHz" if hertz != in_band[-1][0] else "",
        f", MCS {index:g}" if index != codings[-1][0] else "",
        f", {guard * MICRO:g} µs" if guard > shortest else "",
        f", multicast {basic_rate / MEGA:g} Mbit/s" if basic_rate != basics[0][0] else "",
        f", AIFSN {aifsn:g}" if aifsn != 2 else "",
        f", A-MPDU {mpdus:g}" if mpdus > 1 else "",
        f", start spacing {start_spacing * MICRO:g} µs" if start_spacing else "",
    )
    response_rate = max(r for r in _RESPONSE_RATES if r <= int(coding["reference_Mbit_s"]))
    return StandardParameters(
        timing=timing,
        basic=basic,
        ampdu_limits=limits[0] if limits else None,
        slot=slot,
        sifs=sifs,
        aifs=sifs + int(aifsn) * slot,
        signal_extension=Fraction(timing["signal_extension_us"]),
        preamble=_preamble_duration(standard, training_fields, Fraction(symbols["ltf_us"])),
        symbol=Fraction(symbols["symbol_us"]),
        grid=Fraction(symbols["grid_us"]),
        bits_exact=product,
        added=int(own["service_bits"]) + (0 if ldpc else encoders * int(own["tail_bits"])),
        ack=_control_response_duration("ACK", response_rate),
        block_ack=_block_ack_duration(response_rate, int(mpdus)),
        usual_name=f"{standard} {mhz} MHz {streams}x{streams}" + "".join(unusual),
    )


def _rows_in_si_units(rows: Iterable[Row], column: str, si: float = 1.0) -> list[tuple[float, Row]]:
    """Return rows with the value of a column in SI units."""
    return [(float(row[column]) * si, row) for row in rows]


def _rows(name: str, **values: object) -> list[Row]:
    """Return the rows of a Wi-Fi data file that have these values."""
    return [
        row
        for row in read_data(f"wifi/{name}.csv")
        if all(str(value) in row[column].split() for column, value in values.items())
    ]


def _row_of_value(
    name: str, value: Any, rows: Iterable[tuple[float, Row]], where: str, unit: str = ""
) -> tuple[float, Row]:
    """Return the row of a value in SI units; the error of an unknown value lists all values."""
    rows = list(rows)
    given = _checks.number(name, value, 0)
    for allowed, row in rows:
        if isclose(given, allowed, rel_tol=1e-9):
            return allowed, row
    si, power = _UNITS[unit]
    one = 10.0**power
    choices = [_checks.format_exact(round(allowed / one, 9)) for allowed, _ in rows]
    shown = f" {unit}" if unit else ""
    got = f"{given / one:.12g}{shown}" if unit else repr(value)
    # A value that is off by a factor of 1000 was given in another unit; zero cannot show it.
    nonzero = [(allowed, text) for (allowed, _), text in zip(rows, choices, strict=True) if allowed]
    if unit and not any(1e-3 < given / allowed < 1e3 for allowed, _ in nonzero):
        got = f"{value!r} {si}; {name} is in {si}, such as {nonzero[0][1]}e{power}"
    allowed_text = wording.join_words(choices, "or") + shown
    raise ValueError(f"{name} must be {allowed_text} for {where}; got {got}")


def _preamble_duration(standard: str, training_fields: int, ltf: Fraction) -> Fraction:
    """Return the duration of a PPDU before its data [us]."""
    times = {"PPDU": 1, "training field": training_fields}
    parts = _rows("preambles", standard=standard)
    fixed = sum(Fraction(part["us"]) * times[part["once_per"]] for part in parts)
    return fixed + training_fields * ltf


def _control_response_duration(frame: str, rate: int) -> Fraction:
    """Return the duration of a control frame at a rate [Mbit/s] of clause 17 [us]."""
    (octets,) = (int(row["bytes"]) for row in read_data("wifi/frames.csv") if row["name"] == frame)
    (row,) = _rows("basic_rates", rate_Mbit_s=rate)
    bits, added = int(row["bits_per_symbol"]), int(row["added_bits"])
    data = data_time(*map(sp.Integer, (octets, bits, added, 1, int(row["symbol_us"]))))
    return Fraction(row["preamble_us"]) + Fraction(int(data))


def _block_ack_duration(response_rate: int, mpdus: int) -> Fraction:
    """Return the duration of a block acknowledgement with a bit for each MPDU [us]."""
    names = (row["name"].split() for row in read_data("wifi/frames.csv"))
    room = min(int(name[1]) for name in names if name[0] == "BlockAck" and int(name[1]) >= mpdus)
    return _control_response_duration(f"BlockAck {room}", response_rate)
