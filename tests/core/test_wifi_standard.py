"""Test airtime by the standard: rates, padding, overhead, and refused combinations."""

import csv
import itertools
import math
import re
from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
import sympy as sp

import discostorm as ds
from discostorm import _numeric, notation as nt, wifi as wf
from discostorm._numeric import evaluate
from discostorm.data import data_path, read_data
from discostorm.saturation import saturation
from discostorm.wifi.radio import aggregation_bounds

Key = tuple[str, int, int, int, int]

LENGTHS = np.arange(1, 2305)

# SERVICE field and tails [bit], per (standard, MHz, streams, MCS): a tail of 6 bits for each
# encoder, of which fast channels have more; none with LDPC.
ADDED = {
    ("802.11a", 20, 1, 7): 16 + 6,
    ("802.11n", 20, 2, 7): 16 + 6,
    ("802.11n", 40, 4, 7): 16 + 2 * 6,
    ("802.11ac", 160, 1, 9): 16 + 2 * 6,
    ("802.11ac", 80, 4, 9): 16 + 3 * 6,
    ("802.11ac", 160, 4, 7): 16 + 6 * 6,
    ("802.11ax", 20, 1, 9): 16 + 6,
    ("802.11ax", 20, 1, 10): 16,
    ("802.11ax", 40, 1, 0): 16,
}

# Data rates [Mbit/s] as the standard's own tables print them, per (standard, MHz, streams,
# guard interval in us), in order of MCS; None where the MCS is not valid.
PRINTED: dict[tuple[str, int, int, float], list[float | None]] = {
    ("802.11a", 20, 1, 0.8): [6, 9, 12, 18, 24, 36, 48, 54],
    ("802.11g", 20, 1, 0.8): [6, 9, 12, 18, 24, 36, 48, 54],
    ("802.11n", 20, 1, 0.8): [6.5, 13, 19.5, 26, 39, 52, 58.5, 65],
    ("802.11n", 20, 2, 0.4): [14.4, 28.9, 43.3, 57.8, 86.7, 115.6, 130, 144.4],
    ("802.11n", 40, 1, 0.4): [15, 30, 45, 60, 90, 120, 135, 150],
    ("802.11n", 40, 4, 0.8): [54, 108, 162, 216, 324, 432, 486, 540],
    ("802.11ac", 20, 1, 0.8): [6.5, 13, 19.5, 26, 39, 52, 58.5, 65, 78, None],
    ("802.11ac", 20, 3, 0.4): [21.7, 43.3, 65, 86.7, 130, 173.3, 195, 216.7, 260, 288.9],
    ("802.11ac", 80, 2, 0.4): [65, 130, 195, 260, 390, 520, 585, 650, 780, 866.7],
    ("802.11ac", 80, 3, 0.8): [87.8, 175.5, 263.3, 351, 526.5, 702, None, 877.5, 1053, 1170],
    ("802.11ac", 160, 1, 0.4): [65, 130, 195, 260, 390, 520, 585, 650, 780, 866.7],
    ("802.11ax", 20, 1, 0.8): [
        8.6, 17.2, 25.8, 34.4, 51.6, 68.8, 77.4, 86, 103.2, 114.7, 129, 143.4,
    ],
    ("802.11ax", 80, 2, 0.8): [
        72.1, 144.1, 216.2, 288.2, 432.4, 576.5, 648.5, 720.6, 864.7, 960.8, 1080.9, 1201,
    ],
    ("802.11ax", 160, 2, 3.2): [
        122.5, 245, 367.5, 490, 735, 980, 1102.5, 1225, 1470, 1633.3, 1837.5, 2041.7,
    ],
}  # fmt: skip

WIDTHS = {
    "802.11a": [20],
    "802.11g": [20],
    "802.11n": [20, 40],
    "802.11ac": [20, 40, 80, 160],
    "802.11ax": [20, 40, 80, 160],
}
GUARDS = {
    "802.11a": [8],
    "802.11g": [8],
    "802.11n": [4, 8],
    "802.11ac": [4, 8],
    "802.11ax": [8, 16, 32],
}
MCS = {"802.11a": 8, "802.11g": 8, "802.11n": 8, "802.11ac": 10, "802.11ax": 12}


def every_channel() -> Iterator[tuple[Key, ds.Wifi]]:
    for standard, widths in WIDTHS.items():
        streams = [1] if standard in ("802.11a", "802.11g") else [1, 2, 3, 4]
        for width, n, guard, mcs in itertools.product(
            widths, streams, GUARDS[standard], range(MCS[standard])
        ):
            try:
                channel = ds.Radio(
                    standard,
                    width=width * 1e6,
                    streams=n,
                    guard_interval=guard * 1e-7,
                    mcs=mcs,
                ).wifi()
            except ValueError:
                continue
            yield (standard, width, n, guard, mcs), channel


CHANNELS = dict(every_channel())


def ticks_of_data(octets: Any, bits: int, added: int, symbol: int, grid: int) -> Any:
    """Whole tenths of a microsecond, by integer arithmetic alone."""
    symbols = -(-(added + 8 * octets) // bits)
    return grid * -(-(symbols * symbol) // grid)


def test_every_valid_combination_is_there_and_no_other() -> None:
    valid_vht = 4 * 4 * 10 - 5
    assert len(CHANNELS) == 8 + 8 + 2 * 4 * 2 * 8 + 2 * valid_vht + 4 * 4 * 3 * 12


@pytest.mark.parametrize(("key", "printed"), PRINTED.items())
def test_rates_are_those_printed_in_the_standard(
    key: tuple[str, int, int, float], printed: list[float | None]
) -> None:
    standard, width, streams, guard = key
    for mcs, rate in enumerate(printed):
        channel = CHANNELS.get((standard, width, streams, round(guard * 10), mcs))
        if rate is None:
            assert channel is None
        else:
            # The tables print a tenth.
            assert channel is not None
            assert channel.unicast.rate / 1e6 == pytest.approx(rate, abs=0.0501)


@pytest.mark.parametrize(("key", "added"), ADDED.items())
def test_each_encoder_adds_its_tail(key: tuple[str, int, int, int], added: int) -> None:
    standard, width, streams, mcs = key
    channel = ds.Radio(standard, width=width * 1e6, streams=streams, mcs=mcs).wifi()
    assert padding_of(channel.unicast).added == added


def test_the_channels_to_choose_from_are_what_their_names_say() -> None:
    assert list(ds.WIFI) == [
        "802.11a 20 MHz 1x1",
        "802.11g 20 MHz 1x1",
        "802.11n 20 MHz 2x2",
        "802.11n 20 MHz 2x2, 2.4 GHz",
        "802.11n 40 MHz 2x2",
        "802.11ac 80 MHz 2x2",
        "802.11ax 20 MHz 2x2, 2.4 GHz",
        "802.11ax 80 MHz 2x2",
        "802.11ax 160 MHz 2x2",
        "802.11be 80 MHz 2x2",
        "802.11be 320 MHz 2x2",
    ]
    for name, channel in ds.WIFI.items():
        assert channel.name == name
        slow = name.startswith("802.11g") or name.endswith("2.4 GHz")
        assert channel.multicast.rate == (1e6 if slow else 6e6)


def test_a_name_says_what_is_unusual() -> None:
    assert ds.Radio("802.11n", mpdus=2).wifi().name == "802.11n 20 MHz 1x1, A-MPDU 2"
    assert ds.Radio("802.11n", aifsn=15).wifi().name == "802.11n 20 MHz 1x1, AIFSN 15"
    slow = ds.Radio("802.11n", guard_interval=8e-7, multicast_rate=12e6).wifi()
    assert slow.name == "802.11n 20 MHz 1x1, 0.8 µs, multicast 12 Mbit/s"


def test_the_rates_of_the_paper() -> None:
    assert ds.WIFI["802.11n 20 MHz 2x2"].unicast.rate == pytest.approx(144.4e6, rel=4e-4)
    assert ds.WIFI["802.11n 20 MHz 2x2"].multicast.rate == 6e6


def padding_of(link: ds.Link) -> ds.OfdmSymbols:
    assert link.padding is not None
    return link.padding


def padded_duration(rows: list[tuple[float, int, int, float, float]], octets: Any) -> Any:
    """Evaluate the package's own expression as the public functions do."""
    size = sp.Symbol("size", positive=True)
    symbols = (nt.O_UNI, nt.N_DBPS_UNI, nt.N_ADD_UNI, nt.K_UNI, nt.T_GRID_UNI)
    function = _numeric.lambdify([size, *symbols], wf.uplink_airtime(size, "padded"))
    return function(octets, *(np.array(rows)[:, i, None] for i in range(len(symbols))))


def test_every_rate_and_length_agrees_with_integer_arithmetic() -> None:
    links = [channel.unicast for channel in CHANNELS.values()] + [
        ds.Radio("802.11g", multicast_rate=rate).wifi().multicast
        for rate in (1e6, 2e6, 6e6, 12e6, 24e6)
    ]
    rows, exact = [], []
    for link in links:
        p = padding_of(link)
        rows.append((link.overhead, p.bits, p.added, p.per_grid, p.grid))
        tenths = ticks_of_data(LENGTHS, p.bits, p.added, round(p.symbol * 1e7), round(p.grid * 1e7))
        exact.append(tenths * 1e-7)
    got = padded_duration(rows, LENGTHS) - np.array(rows)[:, :1]
    # A symbol too many or too few is at least 1 us.
    np.testing.assert_allclose(got, exact, rtol=0, atol=1e-12)


def test_no_length_is_rounded_wrong_inside_the_whole_utilization() -> None:
    # Here the expression is long, and common terms are taken out of it.
    protocol = ds.DDS
    for channel in (ds.WIFI["802.11n 20 MHz 2x2"], CHANNELS["802.11n", 20, 1, 8, 0]):
        up, down = channel.unicast, channel.multicast
        expression = protocol.utilization(model="padded")
        given: dict[sp.Symbol, Any] = {nt.N_H: 3.0, nt.N_P: 2.0, nt.N_E: 10.0}
        given |= protocol.values() | channel.values()
        for message in protocol.messages:
            given[message.payload_symbol] = LENGTHS.astype(float)
        got = evaluate(expression, given)

        def airtime(link: ds.Link, octets: Any) -> Any:
            p = padding_of(link)
            tenths = ticks_of_data(
                octets, p.bits, p.added, round(p.symbol * 1e7), round(p.grid * 1e7)
            )
            return link.overhead + tenths * 1e-7

        octets = LENGTHS + 64
        pairs = 3 * 2 * 2**2
        expected = 3 * 2 * (airtime(up, octets) + airtime(down, octets))
        expected = expected + pairs * (10 + 4) * 2 * airtime(up, octets)
        np.testing.assert_allclose(got, expected, rtol=1e-12)


@pytest.mark.parametrize("protocol", [ds.DDS, ds.ZENOH])
@pytest.mark.parametrize("name", ds.WIFI)
def test_utilization_breakdown_and_saturation_agree(protocol: ds.Protocol, name: str) -> None:
    channel = ds.WIFI[name]
    table = ds.breakdown(protocol, 7, 2, 10, channel)
    total = table["uplink_s"].sum() + table["downlink_s"].sum()
    assert ds.utilization(protocol, 7, 2, 10, channel) == pytest.approx(total, rel=1e-12)
    hosts = ds.saturation_hosts(protocol, 2, 10, channel)
    assert ds.utilization(protocol, hosts, 2, 10, channel) == pytest.approx(1, rel=1e-12)


def test_overheads_by_hand_in_microseconds() -> None:
    def overheads(*args: Any, **kwargs: Any) -> list[float]:
        channel = ds.Radio(*args, **kwargs).wifi()
        return [round(link.overhead * 1e6, 6) for link in (channel.unicast, channel.multicast)]

    waiting = 16 + 2 * 9 + 7.5 * 9
    assert overheads("802.11a") == [waiting + 20 + 16 + 28, waiting + 20]
    assert overheads("802.11n") == [waiting + 36 + 16 + 28, waiting + 20]
    assert overheads("802.11n", streams=2) == [waiting + 40 + 16 + 28, waiting + 20]
    assert overheads("802.11n", streams=3) == overheads("802.11n", streams=4)
    assert overheads("802.11n", streams=2, aifsn=3)[0] == waiting + 9 + 40 + 16 + 28
    assert overheads("802.11ac", streams=2)[0] == waiting + 44 + 16 + 28
    assert overheads("802.11ax", streams=2)[0] == waiting + 36 + 2 * 7.2 + 16 + 28
    assert overheads("802.11ax", guard_interval=3.2e-6)[0] == waiting + 36 + 16 + 16 + 28
    # Slow frames are acknowledged slowly: at 12 and at 6 Mbit/s.
    assert overheads("802.11a", mcs=3)[0] == waiting + 20 + 16 + 32
    assert overheads("802.11n", mcs=0)[0] == waiting + 36 + 16 + 44
    # 2.4 GHz: shorter SIFS, 6 us of signal extension after each OFDM PPDU.
    waiting = 10 + 2 * 9 + 7.5 * 9
    assert overheads("802.11g") == [waiting + 20 + 6 + 10 + 28 + 6, waiting + 192]
    assert overheads("802.11g", multicast_rate=6e6)[1] == waiting + 20 + 6


@pytest.mark.parametrize(
    ("kwargs", "text"),
    [
        (
            {"standard": "802.11b"},
            r"^standard must be 802.11a, 802.11g, .*, 802.11ax or 802.11be; got '802.11b'$",
        ),
        ({"standard": "802.11ac", "band": 2.4e9}, "band must be 5 GHz for 802.11ac; got 2.4 GHz"),
        ({"standard": "802.11n", "width": 80e6}, "width must be 20 or 40 MHz for 802.11n; got 80"),
        (
            {"standard": "802.11ac", "width": 80},
            "width must be 20, 40, 80 or 160 MHz for 802.11ac; got 80 Hz; width is in Hz, "
            "such as 20e6$",
        ),
        ({"standard": "802.11n", "streams": 5}, "streams must be 1, 2, 3 or 4 for 802.11n; got 5"),
        ({"standard": "802.11a", "streams": 2}, "streams must be 1 for 802.11a; got 2"),
        ({"standard": "802.11n", "mcs": 15}, "mcs must be 0, 1, 2, 3, 4, 5, 6 or 7 for 802.11n at"),
        (
            {"standard": "802.11ac", "mcs": 9, "streams": 2},
            "7 or 8 for 802.11ac at 20 MHz with 2 spatial streams; got 9",
        ),
        ({"standard": "802.11ac", "mcs": 9}, "802.11ac at 20 MHz with 1 spatial stream; got 9"),
        (
            {"standard": "802.11ac", "mcs": 6, "streams": 3, "width": 80e6},
            "5, 7, 8 or 9 for 802.11ac at 80 MHz with 3 spatial streams; got 6",
        ),
        ({"standard": "802.11ax", "guard_interval": 4e-7}, "guard_interval must be 0.8, .* 0.4 µs"),
        (
            {"standard": "802.11n", "multicast_rate": 1e6},
            "multicast_rate must be 6, 12 or 24 Mbit/s for 5 GHz; got 1 Mbit/s$",
        ),
        ({"standard": "802.11n", "aifsn": 1}, "aifsn must be a whole number .* got 1"),
        ({"standard": "802.11n", "aifsn": 16}, "aifsn must be a whole number .* 15; got 16"),
        ({"standard": "802.11n", "aifsn": 2.5}, "aifsn must be a whole number .* got 2.5"),
        ({"standard": "802.11n", "mpdus": 0}, "mpdus must be a whole .* of at least 1.*; got 0"),
        ({"standard": "802.11n", "mpdus": 65}, "mpdus must be .* at most 64 for 802.11n; got 65"),
        ({"standard": "802.11a", "mpdus": 2}, "mpdus must be .* at most 1 for 802.11a; got 2"),
        ({"standard": "802.11n", "width": float("nan")}, "width must be a finite .* got nan"),
    ],
)  # fmt: skip
def test_combinations_that_the_standard_lacks_are_refused(
    kwargs: dict[str, Any], text: str
) -> None:
    with pytest.raises(ValueError, match=text):
        ds.Radio(**kwargs).wifi()


def test_text_is_refused() -> None:
    with pytest.raises(TypeError, match=r"mcs must be a finite number .* got '7'"):
        ds.Radio("802.11n", mcs="7").wifi()  # type: ignore[arg-type]


def test_padding_adds_service_field_and_tail() -> None:
    assert ds.OfdmSymbols(24, 4e-6, 4e-6).added == 16 + 6


def test_a_rate_that_is_not_that_of_its_symbols_is_refused() -> None:
    link = ds.WIFI["802.11n 20 MHz 2x2"].unicast
    with pytest.raises(ValueError, match=r"rate must be 520 bits per 3\.6e-06 s .* 1000000"):
        replace(link, rate=1e6)
    padding = ds.OfdmSymbols(24, 4e-6, 4e-6)
    assert ds.Link(6.2e6, 0, padding).rate == 6.2e6  # 24.8 bits, rounded down
    with pytest.raises(ValueError, match="rate must be 24 bits"):
        ds.Link(6.25e6, 0, padding)


def test_symbols_of_a_short_guard_interval_fill_the_grid_exactly() -> None:
    padding = ds.OfdmSymbols(520, 3.6e-6, 4e-6)
    for tens in range(1, 5000):
        assert padding.per_grid * 10 * tens == 9 * tens


def test_a_channel_that_pads_only_one_link_is_refused() -> None:
    plain, full = ds.Link(6e6, 1e-4), ds.Link(6e6, 1e-4, ds.OfdmSymbols(24, 4e-6, 4e-6))
    for pair in ((plain, full), (full, plain)):
        with pytest.raises(ValueError, match="unicast and multicast must both have padding"):
            ds.Wifi("mixed", *pair)
    with pytest.raises(ValueError, match="aggregation must be None"):
        ds.Wifi("bad", plain, plain, ds.Aggregation(2, 65535, 1e-4))


@pytest.mark.parametrize(
    ("args", "text"),
    [
        ((0, 4e-6, 4e-6), "bits must be a whole number of at least 1.*; got 0"),
        ((24.5, 4e-6, 4e-6), "bits must be a whole number.*; got 24.5"),
        ((24, 4e-6, 4e-6, -1), "added must be a whole number of at least 0.*; got -1"),
        ((24, 3.65e-6, 4e-6), "symbol must be a multiple of 1e-7; got 3.65e-06"),
        ((24, 4e-6, 4.05e-6), "grid must be a multiple of 1e-7"),
        ((8, 2.7e-6, 1e-6), "symbol must equal the grid of 1e-06 s, or 0.9 of it; got 2.7"),
    ],
)
def test_padding_refuses(args: tuple[Any, ...], text: str) -> None:
    with pytest.raises(ValueError, match=text):
        ds.OfdmSymbols(*args)


def test_the_paper_is_as_it_was() -> None:
    assert ds.PAPER.model == "linear"
    assert set(ds.PAPER.values()) == {nt.R_UNI, nt.O_UNI, nt.R_MULTI, nt.O_MULTI}
    for protocol in (ds.DDS, ds.ZENOH):
        for expression in (protocol.utilization(), saturation(protocol)):
            assert not expression.atoms(sp.ceiling, sp.floor, sp.Min)
    assert ds.saturation_hosts(ds.DDS, 2, 10) == pytest.approx(7.1554, abs=5e-5)


def test_padding_costs_and_a_finer_symbol_costs_less() -> None:
    # In the limit of one bit a symbol and no added bits the padded airtime is the linear.
    size = sp.Symbol("size", positive=True)
    nothing = {nt.N_DBPS_UNI: 1, nt.N_ADD_UNI: 0, nt.K_UNI: 1, nt.T_GRID_UNI: sp.Rational(1, 10**6)}
    exact = wf.uplink_airtime(size, "padded").subs(nothing)
    linear = wf.uplink_airtime(size).subs(nt.R_UNI, 10**6)
    for octets in (1, 17, 464):
        assert (exact - linear).subs(size, octets) == 0


def test_symbols_have_names_that_javascript_takes() -> None:
    symbols = set()
    models: tuple[wf.Model, ...] = ("padded", "aggregated")
    for protocol, model in itertools.product((ds.DDS, ds.ZENOH), models):
        symbols |= protocol.utilization(model=model).free_symbols
        assert "Math.ceil" in sp.jscode(protocol.utilization(model=model))
    assert all(symbol.name.isidentifier() for symbol in symbols)
    assert {s.name for s in symbols if not s.name.startswith("s_")} <= nt.NOTATION.keys()


def test_every_row_of_the_wifi_data_names_its_source() -> None:
    found = list(data_path("wifi").iterdir())
    assert len(found) >= 10
    for file in found:
        for row in csv.DictReader(file.read_text(encoding="utf-8").splitlines()):
            assert None not in [*row, *row.values()], (file.name, row)
            assert row["source"].startswith("IEEE Std 802.11"), (file.name, row)


def test_durations_are_exact_sums() -> None:
    # 185.5 us is not a sum of floats here: the nearest float to the exact number.
    overhead = ds.WIFI["802.11n 20 MHz 2x2"].unicast.overhead
    assert overhead == float(Fraction(1855, 10**7))


def test_a_channel_knows_its_radio_and_is_shown_without() -> None:
    radio = ds.Radio("802.11ac", width=40e6, streams=2, aifsn=3, name="mine")
    wifi = radio.wifi()
    assert wifi.radio == radio
    assert "Radio" not in repr(wifi)
    assert replace(wifi, radio=None) == wifi
    assert replace(radio, mpdus=8, name=None).wifi() == (
        ds.Radio("802.11ac", width=40e6, streams=2, aifsn=3, mpdus=8).wifi()
    )


def test_the_parts_of_a_radio_add_up_to_its_overheads() -> None:
    for wifi in ds.WIFI.values():
        radio = wifi.radio
        assert radio is not None
        waiting = radio.aifs + radio.cw_min / 2 * radio.slot
        assert radio.aifs == pytest.approx(radio.sifs + radio.aifsn * radio.slot, rel=1e-12)
        end = radio.signal_extension
        answered = waiting + radio.preamble + end + radio.sifs + radio.ack + end
        assert wifi.unicast.overhead == pytest.approx(answered, rel=1e-12)
        dsss = radio.basic_rate < 6e6
        sent = waiting + radio.multicast_preamble + end * (not dsss)
        assert wifi.multicast.overhead == pytest.approx(sent, rel=1e-12)


def test_the_papers_radio_has_the_papers_rates() -> None:
    radio = ds.PAPER.radio
    assert radio is not None
    # The paper prints one decimal of 144.44... Mbit/s.
    assert radio.rate == pytest.approx(ds.PAPER.unicast.rate, rel=5e-4)
    assert radio.basic_rate == ds.PAPER.multicast.rate


@pytest.mark.parametrize(
    ("width", "streams", "mcs", "rate"),
    [(20, 1, 0, 8.6), (20, 1, 13, 172.1), (80, 2, 13, 1441.2), (320, 1, 13, 2882.4)],
)
def test_rates_of_802_11be_as_published(width: int, streams: int, mcs: int, rate: float) -> None:
    radio = ds.Radio("802.11be", width=width * 1e6, streams=streams, mcs=mcs)
    assert radio.rate / 1e6 == pytest.approx(rate, abs=0.05)  # printed with one decimal
    # Convolutional codes up to 20 MHz and MCS 9; LDPC has no tail.
    assert radio.padding.added == 16 + 6 * (width == 20 and mcs <= 9)


def test_a_standard_is_rows_of_data_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    def with_trial(name: str) -> list[dict[str, str]]:
        rows = read_data(name)
        like = [row for row in rows if "802.11be" in " ".join(row.values())]
        key = "standards" if name == "wifi/mcs.csv" else "standard"
        copies = [row | {key: "802.11zz"} for row in like if key in row]
        if name == "wifi/widths.csv":
            last = copies[-1]
            copies.append(last | {"width_MHz": "640", "data_subcarriers": "7840"})
        return [*rows, *copies]

    monkeypatch.setattr("discostorm.wifi.standard.read_data", with_trial)
    trial = ds.Radio("802.11zz", width=640e6, mcs=13, mpdus=1024)
    assert trial.rate == pytest.approx(2 * ds.Radio("802.11be", width=320e6).rate, rel=1e-12)
    assert trial.padding.added == 16
    assert trial.wifi().name == "802.11zz 640 MHz 1x1, A-MPDU 1024"


def test_block_acknowledgements_have_room_for_all_that_they_acknowledge() -> None:
    def block_ack(mpdus: int) -> float:
        return round(ds.Radio("802.11be", mpdus=mpdus).block_ack * 1e6, 6)

    # At 24 Mbit/s, 96 bits a symbol of 4 us, after 20 us of preamble, with 22 bits added.
    by_hand = {
        mpdus: 20 + 4 * math.ceil((22 + 8 * octets) / 96)
        for mpdus, octets in {64: 32, 65: 56, 256: 56, 257: 88, 512: 88, 513: 152}.items()
    }
    assert {mpdus: block_ack(mpdus) for mpdus in by_hand} == by_hand


@pytest.mark.parametrize(
    ("spacing", "got"),
    [
        (3e-6, "got 3 µs"),
        (1e-9, "got 0.001 µs"),
        (4, "got 4 s; start_spacing is in s, such as 0.25e-6"),
    ],
)
def test_a_start_spacing_that_the_standard_lacks_is_refused(spacing: float, got: str) -> None:
    allowed = "start_spacing must be 0, 0.25, 0.5, 1, 2, 4, 8 or 16 µs for an A-MPDU; "
    with pytest.raises(ValueError, match=f"^{re.escape(allowed + got)}$"):
        ds.Radio("802.11ax", start_spacing=spacing)


def test_a_start_spacing_makes_short_frames_as_long_as_it_lasts() -> None:
    radio = ds.Radio("802.11n", streams=2, mpdus=64, start_spacing=8e-6)
    # 144.4 Mbit/s for 8 us are 144.4 octets: 148 in whole words.
    assert radio.least_subframe == 148
    spaced, free = (
        ds.utilization(ds.DDS, 7, 2, 10, wifi=one.wifi())
        for one in (radio, replace(radio, start_spacing=0.0))
    )
    assert spaced > free
    assert replace(radio, start_spacing=0.0).least_subframe == 0
    long = wf.uplink_airtime(sp.Integer(1000), "aggregated")
    values = {radio.wifi(): 0.0, replace(radio, start_spacing=0.0).wifi(): 0.0}
    for wifi in values:
        values[wifi] = float(evaluate(long, wifi.values()))
    assert len(set(values.values())) == 1  # a long frame takes longer than the spacing anyway


def test_control_frames_are_as_long_as_their_fields() -> None:
    """Frame Control, Duration, addresses and FCS; a block acknowledgement has a bit per MPDU."""
    octets = {row["name"]: int(row["bytes"]) for row in read_data("wifi/frames.csv")}
    assert octets.pop("ACK") == 2 + 2 + 6 + 4
    for bitmap in (64, 256, 512, 1024):
        fields = 2 + 2 + 6 + 6 + 2 + 2 + bitmap // 8 + 4
        assert octets.pop(f"BlockAck {bitmap}") == fields
    assert octets == {"QoS Control": 2, "MPDU delimiter": 4, "A-MPDU padding": 4}


@pytest.mark.parametrize(
    ("band", "slot", "sifs", "extension"), [(2.4e9, 9, 10, 6), (5e9, 9, 16, 0), (6e9, 9, 16, 0)]
)
def test_timing_of_bands(band: float, slot: int, sifs: int, extension: int) -> None:
    radio = ds.Radio("802.11be", band=band)
    times = (radio.slot, radio.sifs, radio.signal_extension, radio.aifs)
    assert times == pytest.approx([t * 1e-6 for t in (slot, sifs, extension, sifs + 2 * slot)])
    # Each retransmission doubles the window: 16 slots, 32 and so on up to 1024.
    assert (radio.cw_min, radio.cw_max) == (2**4 - 1, 2**10 - 1)


def test_a_radio_that_says_how_it_aggregates_is_taken_at_its_word() -> None:
    for mpdus, frames in ((1, 64), (16, 16)):
        full, single = aggregation_bounds(
            ds.Radio("802.11ac", streams=2, width=80e6, mpdus=mpdus).wifi()
        )
        assert full.aggregation is not None
        assert (full.aggregation.mpdus, single.aggregation) == (frames, None)
