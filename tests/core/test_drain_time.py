"""Bursts, periods and leases: against counting by hand, a queue, and the source code's numbers."""

import csv
import math
from collections.abc import Callable
from dataclasses import replace
from itertools import pairwise
from typing import Any, cast

import numpy as np
import pytest
import sympy as sp
from paper_equations import multicast, unicast

import discostorm as ds
from discostorm import drain_times
from discostorm.data import data_path
from discostorm.messages import ONCE, PROCESS, Message, Payload, Protocol, Schedule
from discostorm.model import burst
from discostorm.protocols.defaults import defaults

FAST_DDS, CYCLONE_DDS, ZENOH_PEER = PRODUCTS = tuple(
    ds.PROTOCOLS[name]
    for name in (
        "DDS, periods of Fast DDS",
        "DDS, periods of Cyclone DDS",
        "Zenoh, periods of Zenoh peer",
    )
)
#: Fast DDS if it announced itself by multicast alone, as the paper counts SPDP.
MULTICAST_ONLY = replace(
    FAST_DDS,
    name="Fast DDS, multicast only",
    messages=tuple(m for m in FAST_DDS.messages if m.name != "UnicastSPDP"),
)
ALL = (*PRODUCTS, MULTICAST_ONLY)
Swarm = tuple[int, int, int]
SWARMS: list[Swarm] = [(3, 2, 10), (7, 2, 10), (12, 2, 10), (30, 2, 10), (4, 1, 678), (2, 5, 0)]


def instants(product: str, name: str, until: float) -> list[float]:
    """Return when a message is sent, written down by hand from the products' documentation."""
    second = [float(n) for n in range(int(until) + 1)]
    known: dict[tuple[str, str], list[float]] = {
        ("DDS, periods of Fast DDS", "SPDP"): [0, 0.1, 0.2, 0.3, 0.4]
        + [0.5 + 3 * n for n in second],
        ("DDS, periods of Fast DDS", "UnicastSPDP"): [0, 0.1, 0.2, 0.3, 0.4]
        + [0.5 + 3 * n for n in second],
        ("DDS, periods of Cyclone DDS", "SPDP"): [0] + [0.1 + 8 * n for n in second],
        ("DDS, periods of Cyclone DDS", "DirectedSPDP"): [0, 1, 2, 3],
        ("DDS, periods of Cyclone DDS", "Liveliness"): [8 * n for n in second],
        ("DDS, periods of Cyclone DDS", "LivelinessACK"): [8 * n for n in second],
        ("Zenoh, periods of Zenoh peer", "Scout"): [0, 1, 3] + [7 + 8 * n for n in second],
        ("Zenoh, periods of Zenoh peer", "Hello"): [0, 1, 3] + [7 + 8 * n for n in second],
        ("Zenoh, periods of Zenoh peer", "KeepAlive"): [2.5 * (n + 1) for n in second],
    }
    return known.get((product, name), [0])


def events(
    product: str, hosts: int, processes: int, endpoints: int, until: float
) -> list[tuple[float, float]]:
    """Return (instant, airtime) of all that is sent; shares no code with the package."""
    everyone = hosts * processes
    pairs = everyone * (everyone - processes)
    costs = {
        "SPDP": (multicast(414), everyone),
        "UnicastSPDP": (unicast(414), pairs),
        "DirectedSPDP": (unicast(414), pairs),
        "SEDP": (unicast(464), pairs * endpoints),
        "Heartbeat": (unicast(116), pairs * 2),
        "ACKNACK": (unicast(114), pairs * 2),
        "Liveliness": (unicast(180), pairs),
        "LivelinessACK": (unicast(114), pairs),
        "Scout": (multicast(80), everyone),
        "Hello": (unicast(144), pairs),
        "Declare": (unicast(176), pairs * endpoints),
        "KeepAlive": (unicast(84), pairs),
    }
    names = {
        "DDS, periods of Fast DDS": ["SPDP", "UnicastSPDP", "SEDP", "Heartbeat", "ACKNACK"],
        "DDS, periods of Cyclone DDS": [
            *["SPDP", "DirectedSPDP", "SEDP", "Heartbeat", "ACKNACK"],
            *["Liveliness", "LivelinessACK"],
        ],
        "Zenoh, periods of Zenoh peer": ["Scout", "Hello", "Declare", "KeepAlive"],
    }[product]
    return sorted(
        (time, float(math.prod(costs[name])))
        for name in names
        for time in instants(product, name, until)
        if time <= until + 1e-9
    )


@pytest.mark.parametrize("product", PRODUCTS, ids=lambda product: product.name)
@pytest.mark.parametrize("swarm", SWARMS)
def test_demand_is_the_sum_of_all_that_is_sent(product: Protocol, swarm: Swarm) -> None:
    times = [0, 0.05, 0.1, 0.3, 0.5, 1, 2.5, 3.49, 3.5, 8, 8.1, 15, 23, 60]
    expected = [sum(cost for _, cost in events(product.name, *swarm, time)) for time in times]
    # Both add up a few dozen terms in float64, in another order.
    np.testing.assert_allclose(drain_times.demand(product, times, *swarm), expected, rtol=1e-12)


@pytest.mark.parametrize("product", PRODUCTS, ids=lambda product: product.name)
@pytest.mark.parametrize("swarm", SWARMS)
def test_first_idle_is_that_of_a_queue_served_without_a_gap(
    product: Protocol, swarm: Swarm
) -> None:
    free = 0.0
    for time, cost in events(product.name, *swarm, 200):
        if time > free + 1e-12:
            break
        free += cost
    assert drain_times.first_idle(product, *swarm) == pytest.approx(free, rel=1e-9)


@pytest.mark.parametrize("product", ALL, ids=lambda product: product.name)
@pytest.mark.parametrize("swarm", SWARMS)
def test_drain_time_is_a_bound_and_met_by_the_line_it_comes_from(
    product: Protocol, swarm: Swarm
) -> None:
    bound = drain_times.drain_time(product, *swarm)
    extra = burst(product, *swarm)
    steady = ds.utilization(product, *swarm, window=np.inf)
    assert extra + steady * bound == pytest.approx(bound, rel=1e-12)
    assert drain_times.first_idle(product, *swarm) <= bound * (1 + 1e-12)
    # The line of burst and steady traffic is above the steps everywhere.
    times = np.linspace(0, 100, 4001)
    steps = drain_times.demand(product, times, *swarm)
    assert np.all(steps <= (extra + steady * times) * (1 + 1e-9))


@pytest.mark.parametrize("product", ALL, ids=lambda product: product.name)
@pytest.mark.parametrize("window", [1, 3, 10, 20, 1e4])
def test_critical_swarm_needs_just_the_window(product: Protocol, window: float) -> None:
    hosts = ds.saturation_hosts(product, 2, 10, window=window)
    assert drain_times.drain_time(product, hosts, 2, 10) == pytest.approx(window, rel=1e-9)
    assert ds.utilization(product, hosts, 2, 10, window=window) == pytest.approx(1, rel=1e-9)


@pytest.mark.parametrize("name", ds.WIFI)
def test_critical_swarm_on_any_channel(name: str) -> None:
    wifi = ds.WIFI[name]
    for product in PRODUCTS:
        hosts = ds.saturation_hosts(product, 2, 10, wifi, window=product.lease)
        lasts = drain_times.drain_time(product, hosts, 2, 10, wifi)
        assert lasts == pytest.approx(product.lease, rel=1e-9)


def test_windows_may_be_an_array() -> None:
    hosts = ds.saturation_hosts(CYCLONE_DDS, 2, 10, window=[1, 10, np.inf])
    each = [ds.saturation_hosts(CYCLONE_DDS, 2, 10, window=window) for window in (1, 10, np.inf)]
    np.testing.assert_array_equal(hosts, each)


@pytest.mark.parametrize("product", ALL, ids=lambda product: product.name)
def test_beyond_the_last_critical_swarm_the_channel_never_recovers(product: Protocol) -> None:
    most = float(ds.saturation_hosts(product, 2, 10, window=np.inf))
    below, above = math.floor(most), math.ceil(most)
    assert ds.utilization(product, below, 2, 10, window=np.inf) < 1
    assert ds.utilization(product, above, 2, 10, window=np.inf) > 1
    np.testing.assert_array_equal(
        np.isinf(drain_times.drain_time(product, [below, above], 2, 10)), [False, True]
    )
    assert drain_times.first_idle(product, above, 2, 10) == np.inf
    assert drain_times.outlook(product, below, 2, 10) == "leases at risk"
    assert drain_times.outlook(product, above, 2, 10) == "never catches up"


@pytest.mark.parametrize("product", PRODUCTS, ids=lambda product: product.name)
def test_outlook_changes_at_the_paper_second_and_at_the_lease(product: Protocol) -> None:
    for window, before, after in [
        (1, "within a second at best", "slow at best"),
        (product.lease, "slow at best", "leases at risk"),
    ]:
        hosts = float(ds.saturation_hosts(product, 2, 10, window=window))
        assert drain_times.outlook(product, hosts * 0.999, 2, 10) == before
        assert drain_times.outlook(product, hosts * 1.001, 2, 10) == after


def test_one_message_of_each_is_the_paper_however_long_its_period() -> None:
    age = Schedule((0,), 1e15)
    rows = tuple(replace(message, schedule=age) for message in ds.DDS.messages)
    paper = Protocol("paper", rows, 20)
    assert sp.simplify(paper.burst() - ds.DDS.utilization()) == 0
    # What stays is about 1e-15 of the channel.
    assert drain_times.drain_time(paper, 7, 2, 10) == pytest.approx(
        ds.utilization(ds.DDS, 7, 2, 10), rel=1e-12
    )
    assert ds.saturation_hosts(paper, 2, 10) == pytest.approx(
        ds.saturation_hosts(ds.DDS, 2, 10), rel=1e-12
    )


def test_extra_and_rate_of_schedules_worked_out_by_hand() -> None:
    fast, cyclone, scout = (product.messages[0].schedule for product in PRODUCTS)
    assert fast.burst_count == pytest.approx(6 - 0.5 / 3)
    assert fast.per_second == pytest.approx(1 / 3)
    assert cyclone.burst_count == pytest.approx(2 - 0.1 / 8)
    assert scout.starts == (0, 1, 3, 7)
    assert scout.burst_count == pytest.approx(4 - 7 / 8)
    keep_alive = ZENOH_PEER.messages[-1].schedule
    assert (keep_alive.burst_count, keep_alive.period) == (0, 2.5)
    assert (ONCE.burst_count, ONCE.per_second) == (1, 0)


@pytest.mark.parametrize("product", ALL, ids=lambda product: product.name)
def test_sent_counts_the_times(product: Protocol) -> None:
    for row in product.messages:
        times = row.schedule.times(50)
        assert all(a <= b for a, b in pairwise(times))
        # At its own instants a message counts as sent, whatever the rounding.
        np.testing.assert_array_equal(row.schedule.sent(times), np.arange(1, len(times) + 1))


def test_sent_keeps_the_shape() -> None:
    assert isinstance(ONCE.sent(3), float)
    assert np.shape(ONCE.sent([[0, 1], [2, 3]])) == (2, 2)
    assert isinstance(drain_times.drain_time(FAST_DDS, 3, 2, 10), float)
    assert np.shape(drain_times.drain_time(FAST_DDS, [[3], [4]], [1, 2], 10)) == (2, 2)


def test_leases_and_periods_are_those_of_the_data_file() -> None:
    assert [product.lease for product in PRODUCTS] == [20, 10, 10]
    assert [
        sorted({row.schedule.period for row in product.messages} - {np.inf}) for product in PRODUCTS
    ] == [[3], [8], [2.5, 8]]


def test_every_default_names_where_it_comes_from() -> None:
    path = data_path("vendors/middleware_defaults.csv")
    rows = list(csv.DictReader(path.read_text(encoding="utf-8").splitlines()))
    assert len({(row["product"], row["quantity"]) for row in rows}) == len(rows) > 20
    for row in rows:
        assert all(value for column, value in row.items() if column != "timers"), row
        assert float(row["value"]) > 0 or (row["value"], row["unit"]) == ("0", "1")
        assert row["unit"] in ("s", "1", "B")
        if row["source"].startswith("https"):
            assert len(row["commit"]) == 40
            for part in ("repository", "commit", "path"):
                assert row[part] in row["source"]


@pytest.mark.parametrize(
    ("call", "error", "text"),
    [
        (lambda: Schedule(()), ValueError, "starts must hold at least one time"),
        (
            lambda: Schedule(cast(Any, 0)),
            TypeError,
            "starts must be a tuple of times in seconds; got 0",
        ),
        (lambda: Schedule((-1,)), ValueError, "starts must be a finite number of at least 0"),
        (lambda: Schedule((0, 2, 1)), ValueError, r"starts must be sorted.*got \(0, 2, 1"),
        (lambda: Schedule((0, 9), 8), ValueError, "of at most the period of 8 s"),
        (
            lambda: Schedule((0,), 0),
            ValueError,
            "period must be a finite number of at least 1e-09.*got 0",
        ),
        (lambda: Schedule((0,), math.nan), ValueError, "period must be.*got nan"),
        (lambda: ONCE.sent(-1), ValueError, "time must be a finite number of at least 0; got -1"),
        (
            lambda: Protocol("x", ds.DDS.messages, 0),
            ValueError,
            "lease must be a finite number above 0, or infinity; got 0",
        ),
        (
            lambda: ds.utilization(FAST_DDS, 3, 2, 10, window=0),
            ValueError,
            "window must be a finite number of at least 1e-09.*; got 0",
        ),
        (
            lambda: FAST_DDS.utilization(window=cast(float, "1")),
            TypeError,
            "window must be a finite number of at least 1e-09.*'1'",
        ),
        (lambda: defaults("OpenDDS"), ValueError, "product must be 'Fast DDS' or.*Open"),
        (
            lambda: drain_times.drain_time(FAST_DDS, 0, 2, 10),
            ValueError,
            "hosts must be a finite number of at least 1 and at most 1e[+]09; got 0",
        ),
        (
            lambda: ds.saturation_hosts(FAST_DDS, 2, 10, window=0),
            ValueError,
            "window must be a finite number of at least 1e-09.*got 0",
        ),
        (
            lambda: ds.saturation_hosts(FAST_DDS, 2, 10, window=[1, 1e-3]),
            ValueError,
            "utilization of a single host with DDS, periods of Fast DDS, 10.*; got 1",
        ),
        (
            lambda: drain_times.first_idle(FAST_DDS, cast(float, [3, 4]), 2, 10),
            TypeError,
            "hosts must be one number, not an array",
        ),
        (
            lambda: ds.saturation_hosts(FAST_DDS, [1, 100, 2], 10, window=[1e-4, 20, 2e-4]),
            ValueError,
            "utilization of a single host with DDS, periods of Fast DDS, 5.*; got 1",
        ),
        (
            lambda: ds.saturation_hosts(FAST_DDS, 1e5, 10, window=np.inf),
            ValueError,
            "utilization of a single host with DDS, periods of Fast DDS, .*; got 1",
        ),
        (
            lambda: ds.saturation_hosts(FAST_DDS, [1, 2], 10, window=[1, 2, 3]),
            ValueError,
            r"broadcast.*processes \(2,\), window \(3,\)",
        ),
        (
            lambda: ds.saturation_hosts(FAST_DDS, 2, 10, window=cast(float, "20")),
            TypeError,
            "window must be a finite number of at least 1e-09.*'20'",
        ),
        (
            lambda: ds.saturation_hosts(FAST_DDS, 2, 10, window=-math.inf),
            ValueError,
            "window must be a finite number of at least 1e-09, or infinity; got -inf",
        ),
        (lambda: Schedule((20,), 8), ValueError, "starts must be sorted, with gaps .from zero on"),
        (
            lambda: replace(ds.DDS.messages[0], schedule=cast(Any, 0)),
            TypeError,
            "schedule must be a Schedule; got 0",
        ),
        (
            lambda: replace(ds.DDS.messages[0], hops=cast(Any, ("up", "up"))),
            ValueError,
            r"hops must be 'up', 'down' or both, each once; got \('up', 'up'\)",
        ),
        (
            lambda: drain_times.outlook(FAST_DDS, 3, -2, 10),
            ValueError,
            "processes must be a finite number of at least 1 and at most.*-2",
        ),
        (
            lambda: drain_times.demand(FAST_DDS, [1, 2, 3], [3, 4], 2, 10),
            ValueError,
            r"broadcast.*time \(3,\), .*hosts \(2,\)",
        ),
    ],
)
def test_errors_name_parameter_value_and_range(
    call: Callable[[], object], error: type[Exception], text: str
) -> None:
    with pytest.raises(error, match=text):
        call()


@pytest.mark.parametrize(
    ("steady", "time"), [(0, 2), (sp.S.Half, 4), (1, sp.oo), (sp.Rational(3, 2), sp.oo)]
)
def test_drain_time_in_symbols(steady: sp.Expr, time: sp.Expr) -> None:
    assert drain_times.DRAIN_TIME.subs({drain_times.BURST: 2, drain_times.STEADY: steady}) == time


def test_traffic_that_just_fills_the_channel_is_never_drained() -> None:
    # A frame of 1024 bits at 2048 bit/s, up and down: exactly a second in every second.
    message = Message("m", "p", "multicast", "UDP", Payload(64, 64, 64, "made up"), PROCESS, 1)
    product = Protocol("made up", (replace(message, schedule=Schedule((0,), 1)),), 1)
    wifi = ds.Wifi("made up", ds.Link(2048, 0), ds.Link(2048, 0))
    assert drain_times.drain_time(product, 1, 1, 0, wifi) == math.inf
    assert drain_times.drain_time(product, [1, 1], 1, 0, wifi).tolist() == [math.inf, math.inf]


@pytest.mark.parametrize(
    ("schedule", "words"),
    [
        (Schedule((0.5,)), "once, at 0.5 s"),
        (Schedule((0, 2)), "at 0 and 2 s"),
        (Schedule((0, 1, 3)), "at 0, 1 and 3 s"),
        (Schedule((0.5,), 8), "at 0.5 s, then every 8 s"),
        (Schedule((0, 1, 3), 8), "at 0, 1 and 3 s, then every 8 s"),
    ],
)
def test_a_schedule_in_words(schedule: Schedule, words: str) -> None:
    assert str(schedule) == words


@pytest.mark.parametrize(
    ("until", "times"),
    [
        (0, [0]),
        (0.5, [0]),
        (3, [0, 1, 3]),
        (10.9, [0, 1, 3]),
        (11, [0, 1, 3, 11]),
        (19, [0, 1, 3, 11, 19]),
    ],
)
def test_times_up_to_a_moment(until: float, times: list[float]) -> None:
    schedule = Schedule((0, 1, 3), 8)
    assert schedule.times(until).tolist() == times
    assert schedule.sent(until) == len(times)


def test_rows_may_be_given_in_any_order_of_things() -> None:
    again = replace(FAST_DDS, messages=cast(Any, iter(FAST_DDS.messages)))
    assert again == FAST_DDS
    assert hash(again) == hash(FAST_DDS)


def test_a_channel_is_idle_at_once_if_nothing_is_sent_at_zero() -> None:
    message = ds.DDS.messages[0]
    for starts in ((1,), (8,)):
        late = Protocol("late", (replace(message, schedule=Schedule(starts, 8.5)),), 10)
        assert drain_times.first_idle(late, 3, 2, 10) == 0
    soon = Protocol("soon", (replace(message, schedule=Schedule((0.5,), 8.5)),), 10)
    assert drain_times.drain_time(soon, 1000, 2, 10) > 0.5
    assert drain_times.first_idle(soon, 1000, 2, 10) == 0


def test_the_window_of_a_single_host_is_the_least() -> None:
    alone = drain_times.drain_time(FAST_DDS, 1, 2, 10)
    # A window longer by rounding alone.
    least = alone * (1 + 1e-12)
    assert ds.saturation_hosts(FAST_DDS, 2, 10, window=least) == pytest.approx(1, abs=1e-9)
    few = ds.saturation_hosts(FAST_DDS, 2, 10, window=[least, 1.5 * float(alone)])
    assert np.all(few < 2)


def test_starts_may_be_a_list() -> None:
    schedule = Schedule(cast(Any, [0, 1]))
    assert schedule == Schedule((0, 1))
    assert hash(schedule) == hash(Schedule((0, 1)))


def test_starts_may_coincide_and_be_a_period_apart() -> None:
    assert Schedule((0, 0, 8), 8).sent(8) == 3


def test_fast_dds_by_multicast_alone_sends_what_the_paper_counts() -> None:
    assert [m.name for m in MULTICAST_ONLY.messages] == [m.name for m in ds.DDS.messages]


def test_tables_without_periods_have_a_burst_and_no_steady_state() -> None:
    assert ds.utilization(ds.DDS, 7, 2, 10, window=math.inf) == 0
    found = ds.saturation_hosts(ds.DDS, 2, 10, window=[1, math.inf])
    np.testing.assert_array_equal(found, [ds.saturation_hosts(ds.DDS, 2, 10), math.inf])
    assert drain_times.drain_time(ds.DDS, 7, 2, 10) == ds.utilization(ds.DDS, 7, 2, 10)
    assert ds.utilization(ds.DDS, 7, 2, 10, window=4) == pytest.approx(
        ds.utilization(ds.DDS, 7, 2, 10) / 4, rel=1e-15
    )


def test_a_hop_that_is_wired_takes_no_air() -> None:
    wired = {
        hops: Protocol("wired", tuple(replace(m, hops=hops) for m in ds.DDS.messages))
        for hops in (("up",), ("down",))
    }
    up, down = (ds.utilization(protocol, 7, 2, 10) for protocol in wired.values())
    assert up + down == pytest.approx(ds.utilization(ds.DDS, 7, 2, 10), rel=1e-14)
    costs = ds.breakdown(ds.DDS, 7, 2, 10)
    assert up == pytest.approx(costs["uplink_s"].sum(), rel=1e-14)
    assert down == pytest.approx(costs["downlink_s"].sum(), rel=1e-14)
    assert ds.breakdown(wired["down",], 7, 2, 10)["uplink_s"].sum() == 0
