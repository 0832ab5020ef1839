"""Test bounds, sensitivities and samples against independent statements."""

import dataclasses
import itertools
import json
import math
import subprocess
import sys
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings, strategies as st

import discostorm as ds
from discostorm import notation as nt, uncertainty
from discostorm.data import read_data
from discostorm.saturation import saturation

PROTOCOLS = [ds.DDS, ds.ZENOH]
both = pytest.mark.parametrize("protocol", PROTOCOLS, ids=lambda protocol: protocol.name)


def utilization_with_values(
    protocol: ds.Protocol,
    values: dict[sp.Symbol, float],
    hosts: int,
    processes: int,
    endpoints: int,
) -> float:
    """Evaluate utilization in plain sympy, away from the code under test."""
    counts = {nt.N_H: hosts, nt.N_P: processes, nt.N_E: endpoints}
    return float(protocol.utilization().subs(counts | values))


# The ranges


@both
def test_every_parameter_has_a_range_that_holds_its_paper_value(protocol: ds.Protocol) -> None:
    ranges = uncertainty.parameter_ranges(protocol)
    assert ranges.keys() == protocol.utilization().free_symbols - {nt.N_H, nt.N_P, nt.N_E}
    values = protocol.values() | ds.PAPER.values()
    for symbol, (low, high) in ranges.items():
        assert low <= values[symbol] <= high, symbol


def test_the_data_file_adds_up_to_802_11_timing() -> None:
    ranges = uncertainty.parameter_ranges(ds.DDS) | uncertainty.parameter_ranges(ds.ZENOH)
    wait, backoff, ack = (34, 16 + 3 * 9), (0, 7.5 * 9), (20 + 2 * 4, 20 + 6 * 4)
    low = wait[0] + backoff[0] + 36 + 16 + ack[0]
    high = wait[1] + backoff[1] + 40 + 16 + ack[1] + 4.4
    assert ranges[nt.O_UNI] == pytest.approx((low * 1e-6, high * 1e-6), rel=1e-14)
    low, high = wait[0] + backoff[0] + 20, wait[1] + backoff[1] + 20 + 8
    assert ranges[nt.O_MULTI] == pytest.approx((low * 1e-6, high * 1e-6), rel=1e-14)
    assert ranges[nt.H_UDP] == (64, 64 + 2 + 16)
    assert ranges[nt.H_TCP] == (76, 76 + 2 + 16 + 12)
    assert ranges[nt.R_UNI] == (65e6, 144.4e6)  # exact: the paper's value is an end


def test_every_part_in_the_data_file_is_a_range() -> None:
    for row in read_data("paper/parameter_ranges.csv"):
        assert float(row["low"]) <= float(row["high"])


def test_padding_never_exceeds_what_the_data_file_allows() -> None:
    """SERVICE, tail and padding against whole symbols, for every frame length."""
    rows = {
        row["parameter"]: float(row["high"])
        for row in read_data("paper/parameter_ranges.csv")
        if row["part"].startswith("SERVICE")
    }
    for name, bits_a_symbol in {"O_uni": 260, "O_multi": 24}.items():
        for length in range(1, 2305):
            symbols = -(-(16 + 8 * length + 6) // bits_a_symbol)
            extra = 4 * symbols - 4 * 8 * length / bits_a_symbol
            assert 0 <= extra <= rows[name]


def test_ranges_can_be_replaced_by_name_or_symbol() -> None:
    for key in ("R_uni", nt.R_UNI):
        ranges = uncertainty.parameter_ranges(ds.DDS, given={key: (1e6, 2e6)})
        assert ranges[nt.R_UNI] == (1e6, 2e6)


def test_tables_may_have_messages_of_one_name_and_different_sizes() -> None:
    spdp, *others = ds.DDS.messages
    payload = dataclasses.replace(spdp.payload, nominal=900, high=1000)
    other = ds.Protocol("other", (dataclasses.replace(spdp, payload=payload), *others))
    ours, theirs = uncertainty.sample_together([ds.DDS, other], size=100)
    assert ours[spdp.payload_symbol].max() <= 400 < theirs[spdp.payload_symbol].max()
    for name in ours.keys() - {spdp.payload_symbol}:
        assert ours[name] is theirs[name]
    for table in (ds.DDS, other):
        low, high = uncertainty.bounds(table, 7, 2, 10)
        assert low < ds.utilization(table, 7, 2, 10) < high


# Monotone, hence bounded


@both
@pytest.mark.parametrize("phase", [None, 0, 1])
def test_directions_are_the_signs_of_exact_derivatives(
    protocol: ds.Protocol, phase: int | None
) -> None:
    name = None if phase is None else protocol.phases[phase]
    more = sp.Symbol("x", nonnegative=True)
    total = protocol.utilization(name).subs(nt.N_H, 1 + more)
    for symbol, sign in uncertainty.derivative_signs(protocol, name).items():
        assert sp.expand(sign * total.diff(symbol)).is_nonnegative, symbol
        assert sign == (-1 if symbol in (nt.R_UNI, nt.R_MULTI) else 1)


def test_a_model_that_is_not_monotone_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    odd = ds.Protocol("odd", ds.DDS.messages)
    monkeypatch.setattr(ds.Protocol, "costs", lambda *_: {ds.PAIR: nt.O_UNI**2 - nt.O_UNI})
    with pytest.raises(ValueError, match="utilization of odd is not monotone in O_uni"):
        uncertainty.bounds(odd, 7, 2, 10)


@both
def test_bounds_are_the_extremes_over_all_corners(protocol: ds.Protocol) -> None:
    ranges = uncertainty.parameter_ranges(protocol)
    counts = {nt.N_H: 7, nt.N_P: 2, nt.N_E: 10}
    total = ds.lambdify(list(ranges), protocol.utilization().subs(counts))
    corners = np.asarray(total(*np.array(list(itertools.product(*ranges.values()))).T))
    low, high = uncertainty.bounds(protocol, 7, 2, 10)
    # The same sums in another order.
    assert (low, high) == pytest.approx((corners.min(), corners.max()), rel=1e-13)


@both
@settings(deadline=None, max_examples=25)
@given(data=st.data())
def test_any_parameters_in_their_ranges_stay_within_the_bounds(
    protocol: ds.Protocol, data: st.DataObject
) -> None:
    values = {
        symbol: data.draw(st.floats(low, high))
        for symbol, (low, high) in uncertainty.parameter_ranges(protocol).items()
    }
    hosts, processes, endpoints = (data.draw(st.integers(1, 50)) for _ in range(3))
    low, high = uncertainty.bounds(protocol, hosts, processes, endpoints)
    inside = utilization_with_values(protocol, values, hosts, processes, endpoints)
    assert low * (1 - 1e-12) <= inside <= high * (1 + 1e-12)


@both
def test_phases_bound_the_total_and_shapes_broadcast(protocol: ds.Protocol) -> None:
    hosts = np.arange(1, 13)[:, None]
    total = uncertainty.bounds(protocol, hosts, [1, 2], 10)
    phases = [uncertainty.bounds(protocol, hosts, [1, 2], 10, phase=p) for p in protocol.phases]
    assert np.shape(total.low) == np.shape(total.high) == (12, 2)
    for end in range(2):
        np.testing.assert_allclose(total[end], phases[0][end] + phases[1][end], rtol=1e-13)


@both
def test_a_range_of_one_value_gives_the_paper_value(protocol: ds.Protocol) -> None:
    values = protocol.values() | ds.PAPER.values()
    point = {name: (value, value) for name, value in values.items()}
    exact = ds.utilization(protocol, 7, 2, 10)
    assert uncertainty.bounds(protocol, 7, 2, 10, ranges=point) == pytest.approx((exact, exact))
    hosts = ds.saturation_hosts(protocol, 2, 10)
    assert uncertainty.saturation_bounds(protocol, 2, 10, ranges=point) == pytest.approx(
        (hosts, hosts)
    )


@both
def test_bounds_of_a_fleet_of_like_groups_are_those_of_the_swarm(protocol: ds.Protocol) -> None:
    fleet = ds.Fleet((ds.HostGroup(3, 2, 10), ds.HostGroup(4, 2, 10)))
    assert uncertainty.bounds(protocol, fleet) == pytest.approx(
        uncertainty.bounds(protocol, 7, 2, 10), rel=1e-13
    )


@both
def test_saturation_bounds_are_where_the_utilization_bounds_reach_the_limit(
    protocol: ds.Protocol,
) -> None:
    fewest, most = uncertainty.saturation_bounds(protocol, 2, [10, 100], limit=0.8)
    _, high = uncertainty.bounds(protocol, fewest, 2, [10, 100])
    low, _ = uncertainty.bounds(protocol, most, 2, [10, 100])
    np.testing.assert_allclose(np.concatenate([high, low]), 0.8, rtol=1e-12)


@both
def test_each_limit_is_held_against_its_own_swarm(protocol: ds.Protocol) -> None:
    """A limit too low for many processes is fine beside few."""
    processes, limits = [1, 1000], [0.01, 10]
    together = uncertainty.saturation_bounds(protocol, processes, 10, limit=limits)
    for i in range(2):
        alone = uncertainty.saturation_bounds(protocol, processes[i], 10, limit=limits[i])
        assert (np.asarray(together)[:, i] == alone).all()
    with pytest.raises(ValueError, match=r"limit must be at least .* got 0\.01$"):
        uncertainty.saturation_bounds(protocol, processes, 10, limit=[10, 0.01])


# Sensitivity


@both
def test_slopes_are_finite_differences_of_the_closed_form(protocol: ds.Protocol) -> None:
    table = uncertainty.sensitivity(protocol, 2, 10)
    values = protocol.values() | ds.PAPER.values()
    closed = ds.lambdify([nt.N_P, nt.N_E, nt.U_LIMIT, *values], saturation(protocol))
    hosts = ds.saturation_hosts(protocol, 2, 10)
    for symbol, value in values.items():
        step = 1e-4 * value
        moved = values | {symbol: np.array([value - step, value + step])}
        below, above = np.asarray(closed(2, 10, 1, *moved.values()))
        row = table.loc[symbol.name]
        # A step of 1e-4 leaves 1e-8 of the third order, and 1e-7 of rounding.
        assert row["slope"] == pytest.approx((above - below) / (2 * step), rel=1e-6)
        assert row["elasticity"] == pytest.approx(row["slope"] * value / hosts, rel=1e-12)


@both
def test_elasticities_of_bytes_cancel_those_of_rates(protocol: ds.Protocol) -> None:
    """Bytes matter only as bytes by rate, so twice both changes nothing."""
    table = uncertainty.sensitivity(protocol, 2, 10)["elasticity"]
    sizes = [name for name in table.index if name.startswith(("s_", "H_"))]
    assert table[sizes].sum() == pytest.approx(-table[["R_uni", "R_multi"]].sum(), rel=1e-12)


@both
def test_swings_lie_in_the_saturation_bounds_and_come_sorted(protocol: ds.Protocol) -> None:
    table = uncertainty.sensitivity(protocol, 2, 10)
    low, high = uncertainty.saturation_bounds(protocol, 2, 10)
    ends = table[["hosts_at_low", "hosts_at_high"]]
    assert low <= np.min(ends.to_numpy()) <= np.max(ends.to_numpy()) <= high
    swings = (ends["hosts_at_high"] - ends["hosts_at_low"]).abs()
    assert swings.is_monotonic_decreasing
    assert table.index[0] == "O_uni"


def test_sensitivity_elsewhere_than_at_the_paper_values() -> None:
    table = uncertainty.sensitivity(ds.DDS, 2, 10, values={nt.R_UNI: 65e6})
    assert table.loc["R_uni", "value"] == 65e6
    elsewhere = table["elasticity"].to_dict()
    here = uncertainty.sensitivity(ds.DDS, 2, 10)["elasticity"].to_dict()
    assert elsewhere["R_uni"] > here["R_uni"]


# Samples


@both
def test_samples_stay_in_the_bounds_and_spread_as_the_slopes_say(protocol: ds.Protocol) -> None:
    ranges = uncertainty.parameter_ranges(protocol)
    drawn = uncertainty.sample(protocol, size=100_000)
    total = ds.lambdify([nt.N_H, nt.N_P, nt.N_E, *drawn], protocol.utilization())
    sampled = np.asarray(total(7, 2, 10, *drawn.values()))
    low, high = uncertainty.bounds(protocol, 7, 2, 10)
    assert low <= sampled.min() <= sampled.max() <= high

    closed = ds.lambdify([nt.N_P, nt.N_E, nt.U_LIMIT, *drawn], saturation(protocol))
    hosts = np.asarray(closed(2, 10, 1, *drawn.values()))
    middle = {name: sum(ends) / 2 for name, ends in ranges.items()}
    table = uncertainty.sensitivity(protocol, 2, 10, values=middle)
    first_order = np.sqrt(((table["slope"] * (table["high"] - table["low"])) ** 2).sum() / 12)
    # 5%: the second order, above all of the overhead, which varies by a third.
    assert hosts.std() == pytest.approx(first_order, rel=0.05)


def test_the_seed_decides_the_samples() -> None:
    first, again, other = (
        uncertainty.sample(ds.DDS, size=10, seed=seed)[nt.O_UNI] for seed in (1, 1, 2)
    )
    np.testing.assert_array_equal(first, again)
    assert not np.array_equal(first, other)


def test_a_million_samples_and_the_seed_2026_unless_told_otherwise() -> None:
    as_is = uncertainty.sample(ds.DDS)[nt.O_UNI]
    assert as_is.shape == (10**6,)
    np.testing.assert_array_equal(as_is, uncertainty.sample(ds.DDS, seed=2026)[nt.O_UNI])


def test_the_ends_of_what_size_and_seed_may_be_are_allowed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(uncertainty, "MAX_SAMPLES", 3)  # instead of gigabytes
    for size in (1, 3):
        assert uncertainty.sample(ds.DDS, size=size, seed=0)[nt.O_UNI].shape == (size,)
    with pytest.raises(ValueError, match=r"size must be .* at most 3; got 4"):
        uncertainty.sample(ds.DDS, size=4)


def test_protocols_share_the_draws_of_the_channel() -> None:
    dds, zenoh = uncertainty.sample_together(PROTOCOLS, size=10)
    assert dds.keys() == uncertainty.parameter_ranges(ds.DDS).keys()
    assert zenoh.keys() == uncertainty.parameter_ranges(ds.ZENOH).keys()
    assert all(dds[name] is zenoh[name] for name in dds.keys() & zenoh.keys())
    assert nt.R_UNI in dds.keys() & zenoh.keys()


MEASURED = """
import json, re, resource, sys, time
import discostorm as ds
from discostorm.notation import N_E, N_H, N_P
from discostorm.uncertainty import sample
start = time.process_time()  # of this process alone: other tests run beside it
drawn = sample(ds.DDS, size=10**6)
utilization = ds.lambdify([N_H, N_P, N_E, *drawn], ds.DDS.utilization())(7, 2, 10, *drawn.values())
seconds = time.process_time() - start
if sys.platform == "linux":  # the peak that getrusage tells is that of whoever forked, too
    memory = 1024 * int(re.search(r"VmHWM:\\s+(\\d+)", open("/proc/self/status").read())[1])
else:
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
print(json.dumps({"size": utilization.size, "seconds": seconds, "memory": memory}))
"""


@pytest.mark.skipif(sys.platform == "win32", reason="has no module resource")
def test_a_million_samples_take_under_two_seconds_and_one_gibibyte() -> None:
    done = subprocess.run(
        [sys.executable, "-c", MEASURED], capture_output=True, text=True, check=True
    )
    measured = json.loads(done.stdout)
    assert measured["size"] == 10**6
    assert measured["seconds"] < 2
    assert measured["memory"] < 2**30


# Bad input


@pytest.mark.parametrize(
    ("error", "text", "call"),
    [
        (ValueError, r"ranges must name .*R_uni.*; got 'R'", {"ranges": {"R": (1, 2)}}),
        (ValueError, r"ranges must name .*; got 's_Scout'", {"ranges": {"s_Scout": (1, 2)}}),
        (
            ValueError,
            r"low end of R_uni must be a finite number above 0; got 0",
            {"ranges": {"R_uni": (0, 1)}},
        ),
        (
            ValueError,
            r"high end of O_uni must be .* of at least 0.0002; got 0.0001",
            {"ranges": {"O_uni": (2e-4, 1e-4)}},
        ),
        (
            ValueError,
            r"high end of s_SEDP must be .* of at least 1; got inf",
            {"ranges": {"s_SEDP": (1, math.inf)}},
        ),
        (
            ValueError,
            r"s_SEDP must have a range \(low, high\); got 400",
            {"ranges": {"s_SEDP": 400}},
        ),
        (TypeError, r"ranges must be a Mapping; got 0", {"ranges": 0}),
        (
            TypeError,
            r"low end of s_SEDP must be a finite number of at least 0.*'a'",
            {"ranges": {"s_SEDP": ("a", "b")}},
        ),
    ],
)
def test_bad_ranges_are_named_by_every_function(
    error: type[Exception], text: str, call: dict[str, Any]
) -> None:
    functions: list[tuple[Callable[..., object], tuple[Any, ...]]] = [
        (uncertainty.bounds, (ds.DDS, 7, 2, 10)),
        (uncertainty.saturation_bounds, (ds.DDS, 2, 10)),
        (uncertainty.sensitivity, (ds.DDS, 2, 10)),
        (uncertainty.sample, (ds.DDS,)),
    ]
    for function, args in functions:
        with pytest.raises(error, match=text):
            function(*args, **call)


def test_bad_counts_and_limits_are_named() -> None:
    with pytest.raises(ValueError, match=r"hosts must be .* at least 1.*; got 0"):
        uncertainty.bounds(ds.DDS, 0, 2, 10)
    with pytest.raises(ValueError, match=r"phase must be 'SPDP' or 'SEDP'.*; got 'Scouting'"):
        uncertainty.bounds(ds.DDS, 7, 2, 10, phase="Scouting")
    with pytest.raises(TypeError, match=r"protocol must be .*Protocol.*; got 3"):
        uncertainty.sample(3)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match=r"broadcast together; got processes \(2,\), endpoints"):
        uncertainty.saturation_bounds(ds.DDS, [1, 2], [1, 2, 3])
    with pytest.raises(ValueError, match=r"processes must be .* at least 1.*; got 0"):
        uncertainty.saturation_bounds(ds.DDS, 0, 10)
    with pytest.raises(
        ValueError, match=r"limit must be at least .* single host with DDS, 0\.00\d+.*1e-09"
    ):
        uncertainty.saturation_bounds(ds.DDS, 2, 10, limit=1e-9)
    with pytest.raises(ValueError, match=r"limit must be at least .*; got 0\.001$"):
        uncertainty.saturation_bounds(ds.DDS, 2, 10, limit=[1, 0.001, 0.002])
    for zero in (uncertainty.saturation_bounds, uncertainty.sensitivity):
        with pytest.raises(ValueError, match=r"limit must be a finite number above 0.*; got 0$"):
            zero(ds.DDS, 2, 10, limit=0)
    with pytest.raises(TypeError, match=r"endpoints must be one number, not an array"):
        uncertainty.sensitivity(ds.DDS, 2, [10, 20])  # type: ignore[arg-type]
    with pytest.raises(ValueError, match=r"R_uni must be .* at least 6.5e\+07.*; got 1000000\.0"):
        uncertainty.sensitivity(ds.DDS, 2, 10, values={"R_uni": 1e6})
    with pytest.raises(ValueError, match=r"values must name .*; got 'R'"):
        uncertainty.sensitivity(ds.DDS, 2, 10, values={"R": 1e6})


@pytest.mark.parametrize(
    ("error", "text", "call"),
    [
        (
            ValueError,
            r"size must be a whole number of at least 1 and at most 1e\+08; got 0",
            {"size": 0},
        ),
        (ValueError, r"size must be .*; got 1000000000", {"size": 10**9}),
        (ValueError, r"size must be .*; got 2.5", {"size": 2.5}),
        (TypeError, r"size must be a whole number .*; got True", {"size": True}),
        (ValueError, r"seed must be a whole number of at least 0; got -1", {"seed": -1}),
        (TypeError, r"seed must be a whole number of at least 0; got 'x'", {"seed": "x"}),
    ],
)
def test_bad_size_and_seed_are_named(
    error: type[Exception], text: str, call: dict[str, Any]
) -> None:
    with pytest.raises(error, match=text):
        uncertainty.sample(ds.DDS, **call)
