"""The airtime of an aggregated exchange against integer arithmetic, and its limits."""

from typing import Any

import numpy as np
import pytest
import sympy as sp

import discostorm as ds
from discostorm import _numeric, notation as nt, wifi as wf
from discostorm.wifi import aggregation


def parts(channel: ds.Wifi) -> tuple[ds.OfdmSymbols, ds.Aggregation]:
    assert channel.unicast.padding is not None
    assert channel.aggregation is not None
    return channel.unicast.padding, channel.aggregation


def by_hand(channel: ds.Wifi, octets: int) -> tuple[int, float]:
    """Return the seconds of one frame among its like, octet by octet in whole numbers."""
    padding, rule = parts(channel)
    frame = octets + 2
    subframe = 4 + frame + -frame % 4
    frames = min(rule.mpdus, rule.most_bytes // subframe)
    symbols = -(-(padding.added + 8 * frames * subframe) // padding.bits)
    symbol, grid = round(padding.symbol * 1e7), round(padding.grid * 1e7)
    tenths = grid * -(-(symbols * symbol) // grid)
    return frames, (rule.overhead + tenths * 1e-7) / frames


CHANNELS = [
    ds.Radio(standard, width=width, streams=streams, mcs=mcs, mpdus=mpdus).wifi()
    for standard, width in (("802.11n", 20e6), ("802.11ac", 80e6), ("802.11ax", 80e6))
    for streams, mcs in ((1, 0), (2, 7), (2, None))
    for mpdus in (2, 3, 16, 64)
]


@pytest.mark.parametrize("channel", CHANNELS, ids=lambda channel: channel.name)
def test_every_length_agrees_with_integer_arithmetic(channel: ds.Wifi) -> None:
    size = sp.Symbol("size", positive=True)
    values: dict[sp.Symbol, Any] = dict(channel.values())
    lengths = np.arange(1, 2305)
    airtime = _numeric.evaluate(
        wf.uplink_airtime(size, "aggregated"), values | {size: lengths.astype(float)}
    )
    frames = _numeric.evaluate(aggregation.mpdus(size), values | {size: lengths.astype(float)})
    expected = [by_hand(channel, int(n)) for n in lengths]
    np.testing.assert_array_equal(frames, [n for n, _ in expected])
    np.testing.assert_allclose(airtime, [t for _, t in expected], rtol=1e-12)


@pytest.mark.parametrize("channel", CHANNELS, ids=lambda channel: channel.name)
def test_no_exchange_passes_the_limits(channel: ds.Wifi) -> None:
    padding, rule = parts(channel)
    for octets in range(1, 2305):
        frames, each = by_hand(channel, octets)
        assert 1 <= frames <= 64
        data = each * frames - rule.overhead
        # Without waiting and block acknowledgement: at most 5.484 ms with its preamble.
        assert data + 36e-6 <= 5484e-6 + 1e-12
        if channel.name.startswith("802.11n"):
            assert frames * (4 + octets + 2) <= 65535
    assert rule.most_bytes * 8 + padding.added <= 5484e-6 * channel.unicast.rate


def test_slow_frames_are_bounded_by_time_and_fast_ones_by_number() -> None:
    slow = ds.Radio("802.11n", mcs=0, guard_interval=0.8e-6, mpdus=64).wifi()
    fast = ds.Radio("802.11n", streams=2, mpdus=64).wifi()
    assert by_hand(slow, 464)[0] == 9
    assert by_hand(fast, 464)[0] == 64
    assert parts(fast)[1].most_bytes == 65535


def test_the_block_acknowledgement_takes_a_symbol_more_than_the_ack() -> None:
    channel = ds.Radio("802.11n", streams=2, mpdus=2).wifi()
    extra = parts(channel)[1].overhead - channel.unicast.overhead
    assert extra == pytest.approx(4e-6, abs=1e-12)


def test_multicast_down_is_not_aggregated() -> None:
    plain = ds.Radio("802.11n", streams=2).wifi()
    many = ds.Radio("802.11n", streams=2, mpdus=64).wifi()
    before, after = (
        ds.breakdown(ds.DDS, 7, 2, 10, wifi)[["uplink_s", "downlink_s"]].to_numpy()
        for wifi in (plain, many)
    )
    spdp = 0
    assert after[spdp, 1] == before[spdp, 1]
    assert after[spdp, 0] < before[spdp, 0] / 4
    assert (after[:, 0] < before[:, 0]).all()


@pytest.mark.parametrize("protocol", [ds.DDS, ds.ZENOH])
def test_more_frames_together_never_cost_more_by_more_than_padding(protocol: ds.Protocol) -> None:
    hosts = [
        ds.saturation_hosts(protocol, 2, 10, ds.Radio("802.11n", streams=2, mpdus=n).wifi())
        for n in (1, 2, 4, 8, 16, 32, 64)
    ]
    assert hosts == sorted(hosts)
    for n, at in zip((2, 64), (hosts[1], hosts[-1]), strict=True):
        channel = ds.Radio("802.11n", streams=2, mpdus=n).wifi()
        assert ds.utilization(protocol, at, 2, 10, channel) == pytest.approx(1, rel=1e-12)


@pytest.mark.parametrize(
    ("args", "text"),
    [
        ((0, 65535, 1e-4), "mpdus must be a whole number of at least 1.*; got 0"),
        ((2.5, 65535, 1e-4), "mpdus must be a whole number.*; got 2.5"),
        ((2, 99.5, 1e-4), "most_bytes must be a whole number.*; got 99.5"),
        ((2, 0, 1e-4), "most_bytes must be a whole number of at least 1.*; got 0"),
        ((2, 65535, -1e-4), "overhead must be a finite number of at least 0.*; got -0.0001"),
    ],
)
def test_aggregation_refuses(args: tuple[Any, ...], text: str) -> None:
    with pytest.raises(ValueError, match=text):
        ds.Aggregation(*args)


def test_symbols_are_in_the_notation() -> None:
    size = sp.Symbol("size", positive=True)
    used = wf.aggregated_airtime(size).free_symbols - {size}
    assert used <= {quantity.symbol for quantity in nt.NOTATION.values()}
