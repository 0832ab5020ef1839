"""Compare loads and utilizations with the paper, for arguments of all forms."""

from dataclasses import replace
from fractions import Fraction

import numpy as np
import pandas as pd
import paper_equations as paper
import pytest
import sympy as sp
from hypothesis import given, strategies as st
from numpy.typing import ArrayLike

import discostorm as ds
from discostorm import _numeric, notation
from discostorm.notation import N_E, N_H, N_P
from discostorm.saturation import saturation

PROTOCOLS = [ds.DDS, ds.ZENOH]
each_protocol = pytest.mark.parametrize("protocol", PROTOCOLS, ids=lambda protocol: protocol.name)

#: Some ten rounded operations of 1.1e-16 each, with room.
ROUNDING = 1e-12

hosts_counts = st.integers(1, 10_000)
processes_counts = st.integers(1, 1_000)
endpoints_counts = st.integers(0, 10_000)


# The paper's numbers


@pytest.mark.parametrize(
    ("protocol", "swarm", "expected"),
    [
        (ds.DDS, (7, 2, 10), 0.95391),
        (ds.DDS, (8, 2, 10), 1.26954),
        (ds.DDS, (3, 8, 5), 1.38344),
        (ds.DDS, (3, 1, 678), 1.68520),
        (ds.ZENOH, (7, 2, 10), 0.83057),
        (ds.ZENOH, (8, 2, 10), 1.10632),
    ],
)
def test_utilization_of_the_papers_examples(
    protocol: ds.Protocol, swarm: tuple[int, int, int], expected: float
) -> None:
    assert ds.utilization(protocol, *swarm) == pytest.approx(expected, abs=5e-6)  # five decimals


@pytest.mark.parametrize(("protocol", "expected"), [(ds.DDS, 7.1554), (ds.ZENOH, 7.6310)])
def test_saturation_of_the_papers_swarm(protocol: ds.Protocol, expected: float) -> None:
    assert ds.saturation_hosts(protocol, 2, 10) == pytest.approx(expected, abs=5e-5)


# Equations (1) to (10), written out as the paper prints them

i = sp.Symbol("i", integer=True)
spdp_host = N_P
sedp_host = N_P * ((N_H - 1) * N_P) * N_E
dds_control_host = 4 * N_P * ((N_H - 1) * N_P)
scouting_host = N_P + (N_H - 1) * N_P**2
declare_host = (N_H - 1) * N_P**2 * N_E
zenoh_control_host = 2 * (N_H - 1) * N_P**2


@pytest.mark.parametrize(
    ("protocol", "phase", "of_one_host", "of_all"),
    [
        (ds.DDS, "SPDP", spdp_host, N_H * N_P),
        (ds.DDS, "SEDP", sedp_host + dds_control_host, N_H * (N_H - 1) * N_P**2 * (N_E + 4)),
        (ds.ZENOH, "Scouting", scouting_host, N_H * N_P + N_H * (N_H - 1) * N_P**2),
        (
            ds.ZENOH,
            "Declaration",
            declare_host + zenoh_control_host,
            N_H * (N_H - 1) * N_P**2 * (N_E + 2),
        ),
    ],
    ids=["1-2", "3-5", "6-7", "8-10"],
)
def test_load_is_the_papers_equation(
    protocol: ds.Protocol, phase: str, of_one_host: sp.Expr, of_all: sp.Expr
) -> None:
    load = protocol.load(phase)
    assert sp.expand(load - of_all) == 0
    assert sp.expand(load - sp.Sum(of_one_host, (i, 1, N_H)).doit()) == 0


@pytest.mark.parametrize(
    ("protocol", "message", "of_one_host"),
    [
        (ds.DDS, "SPDP", spdp_host),
        (ds.DDS, "SEDP", sedp_host),
        (ds.DDS, "Heartbeat", dds_control_host / 2),
        (ds.DDS, "ACKNACK", dds_control_host / 2),
        (ds.ZENOH, "Scout", N_P),
        (ds.ZENOH, "Hello", (N_H - 1) * N_P**2),
        (ds.ZENOH, "Declare", declare_host),
        (ds.ZENOH, "KeepAlive", zenoh_control_host),
    ],
)
def test_each_message_is_counted_as_in_the_paper(
    protocol: ds.Protocol, message: str, of_one_host: sp.Expr
) -> None:
    (row,) = (row for row in protocol.messages if row.name == message)
    assert sp.expand(row.load() - N_H * of_one_host) == 0


@each_protocol
def test_only_the_advertisement_is_multicast(protocol: ds.Protocol) -> None:
    assert [row.cast for row in protocol.messages] == ["multicast"] + ["unicast"] * 3


# Equations (11) and (12)


@each_protocol
@given(hosts_counts, processes_counts, endpoints_counts)
def test_utilization_is_the_exact_value(protocol: ds.Protocol, h: int, p: int, e: int) -> None:
    exact = paper.utilization(protocol.name, h, p, e)
    for phase, value in exact.items():
        assert ds.utilization(protocol, h, p, e, phase=phase) == pytest.approx(
            float(value), rel=ROUNDING
        )
    assert ds.utilization(protocol, h, p, e) == pytest.approx(
        paper.total(protocol.name, h, p, e), rel=ROUNDING
    )


@each_protocol
@given(
    st.fractions(1, 100, max_denominator=10**6),
    st.fractions(1, 10**6, max_denominator=64),
    st.fractions(0, 10**6, max_denominator=64),
)
def test_no_digits_are_lost_close_to_one_host(
    protocol: ds.Protocol, h: Fraction, p: Fraction, e: Fraction
) -> None:
    h, p, e = (Fraction(float(value)) for value in (h, p, e))  # exactly what the package gets
    assert ds.utilization(protocol, float(h), float(p), float(e)) == pytest.approx(
        paper.total(protocol.name, h, p, e), rel=ROUNDING
    )


@each_protocol
def test_symbolic_utilization_is_exact_for_rational_values(protocol: ds.Protocol) -> None:
    values = {
        symbol: sp.Rational(str(value))
        for symbol, value in (protocol.values() | ds.PAPER.values()).items()
    }
    swarm = {N_H: sp.Integer(7), N_P: sp.Integer(2), N_E: sp.Integer(10)}
    exact = protocol.utilization().subs(values).subs(swarm)
    assert exact == sum(map(sp.Rational, paper.utilization(protocol.name, 7, 2, 10).values()))


@each_protocol
def test_degrees(protocol: ds.Protocol) -> None:
    u = sp.expand(protocol.utilization())
    assert [sp.degree(u, symbol) for symbol in (N_H, N_P, N_E)] == [2, 2, 1]


# Properties


@each_protocol
@given(hosts_counts, processes_counts, endpoints_counts)
def test_more_of_anything_never_costs_less(protocol: ds.Protocol, h: int, p: int, e: int) -> None:
    here = ds.utilization(protocol, h, p, e)
    assert ds.utilization(protocol, h + 1, p, e) > here
    assert ds.utilization(protocol, h, p + 1, e) > here
    assert ds.utilization(protocol, h, p, e + 1) >= here


@each_protocol
@given(hosts_counts, hosts_counts, endpoints_counts)
def test_only_the_number_of_remote_processes_counts(
    protocol: ds.Protocol, h: int, p: int, e: int
) -> None:
    """Two hosts of p processes each: swapping the hosts changes nothing."""
    one, other = ds.HostGroup(h, p, e), ds.HostGroup(p, h, e)
    assert ds.utilization(protocol, ds.Fleet((one, other))) == pytest.approx(
        ds.utilization(protocol, ds.Fleet((other, one))), rel=ROUNDING
    )


@each_protocol
@given(processes_counts, endpoints_counts)
def test_one_host_only_advertises_itself(protocol: ds.Protocol, p: int, e: int) -> None:
    first, *_ = protocol.messages
    table = ds.breakdown(protocol, 1, p, e)
    assert table["uplink_messages"].to_dict() == {
        message.name: p if message is first else 0 for message in protocol.messages
    }
    assert ds.utilization(protocol, 1, p, e) == pytest.approx(
        p * float(paper.multicast(int(first.frame_bytes))), rel=ROUNDING
    )


@each_protocol
@given(hosts_counts, processes_counts)
def test_without_endpoints_only_control_remains(protocol: ds.Protocol, h: int, p: int) -> None:
    table = ds.breakdown(protocol, h, p, 0)
    name = "SEDP" if protocol is ds.DDS else "Declare"
    assert list(table.loc[name, ["uplink_messages", "uplink_s", "downlink_s"]]) == [0, 0, 0]


@each_protocol
@given(hosts_counts, processes_counts, endpoints_counts)
def test_phases_and_breakdown_sum_to_the_whole(
    protocol: ds.Protocol, h: int, p: int, e: int
) -> None:
    whole = ds.utilization(protocol, h, p, e)
    phases = {phase: ds.utilization(protocol, h, p, e, phase=phase) for phase in protocol.phases}
    assert sum(phases.values()) == pytest.approx(whole, rel=ROUNDING)
    table = ds.breakdown(protocol, h, p, e)
    airtime = table["uplink_s"] + table["downlink_s"]
    assert airtime.sum() == pytest.approx(whole, rel=ROUNDING)
    for phase, value in airtime.groupby(table["phase"]).sum().items():
        assert value == pytest.approx(phases[str(phase)], rel=ROUNDING)


@each_protocol
def test_breakdown_has_the_promised_columns(protocol: ds.Protocol) -> None:
    table = ds.breakdown(protocol, 7, 2, 10)
    assert table.index.tolist() == [message.name for message in protocol.messages]
    assert table.columns.tolist() == [
        "phase",
        "cast",
        "frame_bytes",
        "uplink_messages",
        "uplink_s",
        "downlink_s",
    ]


# Saturation


@each_protocol
@given(st.integers(1, 100), st.integers(0, 1000), st.floats(1, 1e6))
def test_saturation_is_the_inverse_of_utilization(
    protocol: ds.Protocol, p: int, e: int, limit: float
) -> None:
    hosts = ds.saturation_hosts(protocol, p, e, limit=limit)
    # U has degree 2 in the hosts, which doubles their relative rounding.
    assert ds.utilization(protocol, hosts, p, e) == pytest.approx(limit, rel=10 * ROUNDING)


@each_protocol
def test_saturation_is_a_root_of_the_symbolic_utilization(protocol: ds.Protocol) -> None:
    values = {
        symbol: sp.Rational(str(value))
        for symbol, value in (protocol.values() | ds.PAPER.values()).items()
    } | {N_P: 2, N_E: 10, sp.Symbol("U_limit", positive=True): 1}
    at = saturation(protocol).subs(values)
    assert sp.simplify(protocol.utilization().subs(values).subs(N_H, at) - 1) == 0


@each_protocol
def test_a_limit_that_one_host_just_meets_saturates_at_one_host(protocol: ds.Protocol) -> None:
    limit = ds.utilization(protocol, 1, 3, 10)
    assert ds.saturation_hosts(protocol, 3, 10, limit=limit) == pytest.approx(1, abs=ROUNDING)


def test_saturation_broadcasts() -> None:
    result = ds.saturation_hosts(ds.DDS, [[1], [2]], 10, limit=[0.5, 1.0, 2.0])
    assert isinstance(result, np.ndarray)
    assert result.shape == (2, 3)
    assert result[1, 1] == ds.saturation_hosts(ds.DDS, 2, 10)


# Fleets


@each_protocol
@given(st.lists(hosts_counts, min_size=2, max_size=4), processes_counts, endpoints_counts)
def test_a_swarm_split_into_groups_stays_the_same(
    protocol: ds.Protocol, parts: list[int], p: int, e: int
) -> None:
    fleet = ds.Fleet(tuple(ds.HostGroup(part, p, e) for part in parts))
    for phase in (None, *protocol.phases):
        assert ds.utilization(protocol, fleet, phase=phase) == pytest.approx(
            ds.utilization(protocol, sum(parts), p, e, phase=phase), rel=ROUNDING
        )


@each_protocol
def test_a_fleet_of_one_group_is_a_swarm(protocol: ds.Protocol) -> None:
    fleet = ds.Fleet.swarm(7, 2, 10)
    assert ds.utilization(protocol, fleet) == ds.utilization(protocol, 7, 2, 10)
    pd.testing.assert_frame_equal(ds.breakdown(protocol, fleet), ds.breakdown(protocol, 7, 2, 10))


@given(
    st.lists(
        st.tuples(st.integers(1, 5), st.integers(1, 4), st.integers(0, 9)), min_size=1, max_size=4
    )
)
def test_a_fleet_counts_what_enumeration_counts(groups: list[tuple[int, int, int]]) -> None:
    fleet = ds.Fleet(tuple(ds.HostGroup(*group) for group in groups))
    hosts = [(p, e) for h, p, e in groups for _ in range(h)]
    ordered = [(a, b) for i, a in enumerate(hosts) for j, b in enumerate(hosts) if i != j]
    assert ds.PROCESS.count(fleet) == sum(p for p, _ in hosts)
    assert ds.PAIR.count(fleet) == sum(a[0] * b[0] for a, b in ordered)
    assert ds.ENDPOINT_PAIR.count(fleet) == sum(a[0] * a[1] * b[0] for a, b in ordered)


# What the arguments may look like


@pytest.mark.parametrize("phase", [None, "SPDP", "SEDP"])
@pytest.mark.parametrize(
    ("hosts", "processes", "endpoints", "shape"),
    [
        ([1, 2, 3], 2, 10, (3,)),
        (3, 2, [0, 10, 20, 30], (4,)),  # SPDP does not depend on the endpoints
        ([[1], [2]], [1, 2, 3], 10, (2, 3)),
        (np.ones((2, 1, 1)), np.ones((3, 1)), np.ones(4), (2, 3, 4)),
        ([7], 2, 10, (1,)),
        ([], 2, 10, (0,)),
        (np.ones((0, 3)), 2, 10, (0, 3)),
    ],
)
def test_arrays_broadcast(
    hosts: ArrayLike,
    processes: ArrayLike,
    endpoints: ArrayLike,
    shape: tuple[int, ...],
    phase: str | None,
) -> None:
    result = ds.utilization(ds.DDS, hosts, processes, endpoints, phase=phase)
    assert isinstance(result, np.ndarray)
    assert result.dtype == np.float64
    assert result.shape == shape
    full = np.broadcast_arrays(hosts, processes, endpoints)
    for index in np.ndindex(shape):
        h, p, e = (array[index] for array in full)
        assert result[index] == ds.utilization(ds.DDS, h, p, e, phase=phase)


@pytest.mark.parametrize("seven", [7, 7.0, np.int8(7), np.array(7), Fraction(7), sp.Integer(7)])
def test_scalars_give_a_float(seven: float) -> None:
    for phase in (None, "SPDP"):
        assert type(ds.utilization(ds.DDS, seven, 2, 10, phase=phase)) is float
    assert ds.utilization(ds.DDS, seven, 2, 10) == ds.utilization(ds.DDS, 7, 2, 10)
    assert type(ds.saturation_hosts(ds.DDS, 2, 10)) is float


@pytest.mark.parametrize("width", ["i1", "i2", "i4", "i8", "u1", "u2", "u4", "u8", "f4", "f8", "O"])
def test_integers_of_any_width_do_not_overflow(width: str) -> None:
    counts = np.array([100, 127], width)
    expected = [paper.total("DDS", n, n, n) for n in (100, 127)]
    result = ds.utilization(ds.DDS, counts, counts, counts)
    np.testing.assert_allclose(result, expected, rtol=ROUNDING)
    function = ds.lambdify([N_H, N_P, N_E], ds.DDS.load())
    np.testing.assert_array_equal(
        function(counts, counts, counts), [n * n + n**3 * (n - 1) * (n + 4) for n in (100, 127)]
    )


def test_large_python_integers_do_not_overflow() -> None:
    n = 10**9
    assert ds.utilization(ds.DDS, n, n, n) == pytest.approx(
        paper.total("DDS", n, n, n), rel=ROUNDING
    )
    assert ds.lambdify([N_H], N_H**2)(10**30) == pytest.approx(1e60, rel=ROUNDING)


def test_arguments_stay_as_they_were() -> None:
    hosts = np.array([1.0, 2.0, 3.0])
    ds.utilization(ds.DDS, hosts, 2, 10)
    assert hosts.tolist() == [1, 2, 3]


@pytest.mark.parametrize(
    "shape",
    [
        (65_539,),
        (16_385, 3),
        (3, 32_769),
    ],
)
def test_many_swarms_give_what_each_alone_gives(shape: tuple[int, ...]) -> None:
    hosts = np.linspace(1, 50, int(np.prod(shape))).reshape(shape)
    column = np.linspace(1, 9, shape[0]).reshape(-1, *[1] * (len(shape) - 1))
    result = ds.utilization(ds.DDS, hosts, column, 10)
    assert isinstance(result, np.ndarray)
    assert result.shape == shape
    # Vector instructions may round the last bit otherwise than scalar ones.
    for index in [(0,) * len(shape), tuple(n // 2 for n in shape), tuple(n - 1 for n in shape)]:
        one = ds.utilization(ds.DDS, hosts[index], column[index[0]].item(), 10)
        assert result[index] == pytest.approx(one, rel=ROUNDING)
    for row in (0, -1):
        alone = ds.utilization(ds.DDS, hosts[row], column[row], 10)
        np.testing.assert_allclose(result[row], alone, rtol=ROUNDING)


def test_lambdify_takes_names_and_keeps_the_shape() -> None:
    x, y = sp.symbols("x y")
    function = ds.lambdify([x, y], x**2)
    assert function(3, y=1) == 9.0
    np.testing.assert_array_equal(function([1, 2], [[0], [0]]), [[1, 4], [1, 4]])
    np.testing.assert_array_equal(ds.lambdify([x], sp.Integer(2))([1, 2]), [2, 2])
    assert function.__doc__ == "Return x**2 as a NumPy function of x, y."


@each_protocol
def test_lambdified_symbolic_utilization_is_the_numeric_one(protocol: ds.Protocol) -> None:
    """The symbolic form, with the parameters filled in by hand, is what utilization computes."""
    expression = protocol.utilization().subs(protocol.values() | ds.PAPER.values())
    function = ds.lambdify([N_H, N_P, N_E], expression)
    hosts = np.arange(1, 51)
    np.testing.assert_allclose(
        function(hosts, 2, 10), ds.utilization(protocol, hosts, 2, 10), rtol=ROUNDING
    )


def test_what_may_be_zero_is_not_taken_for_positive() -> None:
    symbols = {value for value in vars(notation).values() if isinstance(value, sp.Symbol)}
    assert len(symbols) > 20
    assert all(symbol.is_nonnegative for symbol in symbols)
    assert {symbol.name for symbol in symbols if not symbol.is_positive} == {
        *("N_E", "O_uni", "O_multi", "O_agg", "N_add_uni", "N_add_multi", "A_least"),
    }


def test_only_what_is_rounded_is_hidden() -> None:
    whole = sp.ceiling(N_H / 3)
    hidden, parts = _numeric.hide_rounded(N_H**2 + whole)
    ((symbol, part),) = parts.items()
    assert part == whole
    assert hidden == N_H**2 + symbol


def test_what_grows_linearly_is_solved() -> None:
    announced = ds.Protocol("announced", ds.DDS.messages[:1])
    hosts = ds.saturation_hosts(announced, 2, 10)
    assert ds.utilization(announced, hosts, 2, 10) == pytest.approx(1, rel=1e-12)


def with_unit(unit: ds.Unit) -> ds.Protocol:
    return ds.Protocol("own", (replace(ds.DDS.messages[0], unit=unit),))


def test_what_does_not_grow_is_not_solved() -> None:
    own = with_unit(ds.Unit("fleet"))
    assert ds.utilization(own, 3, 2, 10) > 0
    with pytest.raises(ValueError, match="utilization must grow with hosts"):
        ds.saturation_hosts(own, 2, 10, limit=100)


@pytest.mark.parametrize(
    "unit",
    [
        ds.Unit("host", "other host", "link"),
        ds.Unit("process", "remote process", "third process"),
        ds.Unit("matched endpoint of others", "server"),
    ],
    ids=str,
)
def test_what_grows_faster_than_the_square_is_solved_in_numbers_only(unit: ds.Unit) -> None:
    own = with_unit(unit)
    fleet = ds.Fleet((ds.HostGroup(1, 2, 10), ds.HostGroup(3, 1, 90)), matching=0.5)
    for limit in (1, 100, 1e9):
        hosts = ds.saturation_hosts(own, limit=limit, fleet=fleet)
        grown = replace(fleet, groups=(replace(fleet.groups[0], hosts=hosts), fleet.groups[1]))
        assert ds.utilization(own, grown) == pytest.approx(limit, rel=1e-12)


def test_what_grows_as_the_fourth_power_is_not_solved_in_symbols() -> None:
    own = with_unit(ds.Unit("host", "other host", "link"))
    hosts = ds.saturation_hosts(own, 2, 10, limit=[1, 100])
    assert ds.utilization(own, hosts, 2, 10) == pytest.approx([1, 100], rel=1e-12)
    with pytest.raises(ValueError, match="utilization must grow with hosts, at most as"):
        saturation(own)
