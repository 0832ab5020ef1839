"""The planner: every gain is computed a second time, from hosts and frames written out."""

import json
import subprocess
import sys
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import pytest
from hypothesis import given, settings, strategies as st
from matplotlib.figure import Figure

import discostorm as ds
from discostorm import planner
from discostorm.data import read_data
from discostorm.messages import PROCESS
from discostorm.planner import MPDUS, MULTICAST_RATE, parameter_service_endpoints, split

#: Hosts, each a list with the endpoints of each of its processes.
Hosts = Sequence[Sequence[float]]

PAPER = {"unicast": (144.4e6, 180e-6), "multicast": (6e6, 120e-6)}

#: Neither text nor a fleet.
WRONG: Any = 5

robots = ds.HostGroup(10, 1, 678, name="robots")
laptop = ds.HostGroup(1, 1, 90, name="laptop")
NAV2 = ds.Fleet((robots, laptop))
FIG3 = ds.Fleet.swarm(3, 8, 5)


def written_out(fleet: ds.Fleet) -> Hosts:
    return [
        [group.endpoints] * int(group.processes)
        for group in fleet.groups
        for _ in range(int(group.hosts))
    ]


def by_hand(
    hosts: Hosts, protocol: str = "DDS", links: dict[str, tuple[float, float]] = PAPER
) -> float:
    """Airtime, from who tells whom, with the frames as Table II prints them."""

    def frame(octets: int, cast: str) -> float:
        rate, overhead = links[cast]
        return 8 * octets / rate + overhead

    def relayed(octets: int) -> float:
        return 2 * frame(octets, "unicast")

    multicast = 414 if protocol == "DDS" else 80
    endpoint = relayed(464) if protocol == "DDS" else relayed(176)
    pair = (
        2 * relayed(116) + 2 * relayed(114) if protocol == "DDS" else relayed(144) + 2 * relayed(84)
    )
    total = 0.0
    for here, own in enumerate(hosts):
        for endpoints in own:
            total += frame(multicast, "unicast") + frame(multicast, "multicast")
            for there, others in enumerate(hosts):
                if here != there:
                    total += len(others) * (pair + endpoints * endpoint)
    return total


def remedy(plan: ds.Plan, kind: str, index: int = 0) -> ds.Remedy:
    return [found for found in plan.remedies if found.kind == kind][index]


def approx(value: Any) -> Any:
    # Sums of up to a few thousand terms in another order.
    return pytest.approx(value, rel=1e-10)


def test_the_swarm_of_fig_3_by_hand() -> None:
    plan = ds.plan(FIG3, ds.DDS)
    assert plan.utilization == approx(by_hand([[5] * 8] * 3))
    composed = remedy(plan, "processes")
    assert composed.utilization == approx(by_hand([[40]] * 3))
    assert composed == plan.remedies[0]
    assert composed.sentence() == "composing 8 processes into 1 cuts 1.38 s to 0.11 s (92%)"
    assert remedy(plan, "middleware").utilization == approx(by_hand([[5] * 8] * 3, "Zenoh"))
    faster = PAPER | {"multicast": (24e6, 120e-6)}
    assert remedy(plan, "multicast rate").utilization == approx(
        by_hand([[5] * 8] * 3, links=faster)
    )
    for radio in (found for found in plan.remedies if found.kind == "radio"):
        links = PAPER | {"unicast": (radio.wifi.unicast.rate, 180e-6)}
        assert radio.utilization == approx(by_hand([[5] * 8] * 3, links=links))
    rates = {round(r.wifi.unicast.rate / 1e6) for r in plan.remedies if r.kind == "radio"}
    assert rates == {300, 867, 2402}


@pytest.mark.parametrize("protocol", [ds.DDS, ds.ZENOH], ids=lambda protocol: protocol.name)
def test_ten_nav2_robots_and_a_laptop_by_hand(protocol: ds.Protocol) -> None:
    plan = ds.plan(NAV2, protocol, nodes=[13, 2])
    name = protocol.name
    assert plan.utilization == approx(by_hand([[678]] * 10 + [[90]], name))
    fewer = by_hand([[678 - 13 * 12]] * 10 + [[90 - 2 * 12]], name)
    assert remedy(plan, "endpoints").utilization == approx(fewer)
    # Dealt out in turn: the laptop is the eleventh host.
    halves = [by_hand([[678]] * 5 + [[90]], name), by_hand([[678]] * 5, name)]
    thirds = [
        by_hand([[678]] * 4, name),
        by_hand([[678]] * 3 + [[90]], name),
        by_hand([[678]] * 3, name),
    ]
    for parts in (halves, thirds):
        channels, domains = (
            next(r for r in plan.remedies if r.kind == kind and len(r.fleets) == len(parts))
            for kind in ("channels", "domains")
        )
        assert channels.utilization == approx(max(parts))
        assert domains.utilization == approx(sum(parts))
    assert not [found for found in plan.remedies if found.kind == "processes"]


fleets = st.lists(
    st.tuples(st.integers(1, 4), st.integers(1, 3), st.integers(0, 30)), min_size=1, max_size=3
)


@given(fleets, st.sampled_from([ds.DDS, ds.ZENOH]))
@settings(max_examples=30, deadline=None)
def test_every_gain_of_a_random_fleet_is_that_of_its_changed_fleets(
    counts: list[tuple[int, int, int]], protocol: ds.Protocol
) -> None:
    fleet = ds.Fleet(tuple(ds.HostGroup(*group) for group in counts))
    plan = ds.plan(fleet, protocol)
    assert plan.utilization == approx(by_hand(written_out(fleet), protocol.name))
    for found in plan.remedies:
        links = {
            "unicast": (found.wifi.unicast.rate, found.wifi.unicast.overhead),
            "multicast": (found.wifi.multicast.rate, found.wifi.multicast.overhead),
        }
        parts = [by_hand(written_out(f), found.protocol.name, links) for f in found.fleets]
        expected = max(parts) if found.kind == "channels" else sum(parts)
        assert found.utilization == approx(expected)
        assert found.saved == pytest.approx(1 - expected / plan.utilization, abs=1e-10)
    saved = [found.saved for found in plan.remedies]
    assert saved == sorted(saved, reverse=True)
    by_endpoints = [sum(sum(host) for host in written_out(f)) for f in (fleet,)]
    composed = [found for found in plan.remedies if found.kind == "processes"]
    assert bool(composed) == any(processes > 1 for _, processes, _ in counts)
    for found in composed:
        assert [sum(sum(host) for host in written_out(f)) for f in found.fleets] == by_endpoints
        assert all(len(host) == 1 for host in written_out(found.fleets[0]))


@given(fleets, st.integers(1, 4))
@settings(max_examples=40, deadline=None)
def test_a_split_fleet_has_the_same_hosts_in_parts_that_differ_by_one_at_most(
    counts: list[tuple[int, int, int]], parts: int
) -> None:
    fleet = ds.Fleet(tuple(ds.HostGroup(*group) for group in counts))
    hosts = written_out(fleet)
    if len(hosts) < parts:
        with pytest.raises(ValueError, match=r"parts must be .* at most"):
            split(fleet, parts)
        return
    pieces = [written_out(piece) for piece in split(fleet, parts)]
    dealt = [list(host) for piece in pieces for host in piece]
    assert sorted(dealt) == sorted(map(list, hosts))
    sizes = [len(piece) for piece in pieces]
    assert max(sizes) - min(sizes) <= 1


def test_shares_are_parts_of_the_whole() -> None:
    plan = ds.plan(NAV2, ds.DDS)
    for kind in ("message", "phase"):
        shares = plan.of_kind(kind)
        assert sum(share.airtime for share in shares) == approx(plan.utilization)
        assert sum(share.share for share in shares) == approx(1)
        assert [s.share for s in shares] == sorted((s.share for s in shares), reverse=True)
    assert plan.of_kind("message")[0].name == "SEDP"
    groups = {share.name: share.airtime for share in plan.of_kind("group")}
    whole = by_hand([[678]] * 10 + [[90]])
    assert groups["laptop"] == approx(whole - by_hand([[678]] * 10))
    assert groups["robots"] == approx(whole - by_hand([[90]]))
    (alone,) = ds.plan(FIG3).of_kind("group")
    assert (alone.name, alone.share) == ("group 1", 1)


def test_two_groups_of_the_same_hosts_are_two_groups() -> None:
    group = ds.HostGroup(2, 1, 10)
    shares = ds.plan(ds.Fleet((group, group))).of_kind("group")
    expected = by_hand([[10]] * 4) - by_hand([[10]] * 2)
    assert [share.airtime for share in shares] == [approx(expected)] * 2


def test_on_a_preset_the_channel_changes_in_all_that_its_standard_says() -> None:
    base = ds.WIFI["802.11n 20 MHz 2x2"]
    plan = ds.plan(NAV2, ds.DDS, base)
    expected = {
        "multicast rate": ds.Radio("802.11n", streams=2, multicast_rate=MULTICAST_RATE).wifi(),
        "aggregation": ds.Radio("802.11n", streams=2, mpdus=MPDUS).wifi(),
    }
    for kind, wifi in expected.items():
        found = remedy(plan, kind)
        assert found.wifi == wifi
        assert found.utilization == approx(float(ds.utilization(ds.DDS, NAV2, wifi=wifi)))
    names = {found.wifi.name for found in plan.remedies if found.kind == "radio"}
    assert names == {"802.11n 40 MHz 2x2", "802.11ac 80 MHz 2x2", "802.11ax 160 MHz 2x2"}
    for found in plan.remedies:
        if found.kind == "radio":
            assert found.wifi == ds.WIFI[found.wifi.name]
    assert plan.left_out == ()


def test_another_radio_keeps_what_was_chosen_beside_it() -> None:
    base = ds.Radio("802.11n", streams=2, multicast_rate=12e6, aifsn=3, mpdus=16).wifi()
    radios = [found.wifi for found in ds.plan(NAV2, ds.DDS, base).remedies if found.kind == "radio"]
    assert len(radios) == 3
    for wifi in radios:
        radio = wifi.radio
        assert radio is not None
        assert (radio.multicast_rate, radio.aifsn, radio.mpdus) == (12e6, 3, 16)
    # 1 Mbit/s is of the 2.4 GHz band alone.
    slow = ds.Radio("802.11n", band=2.4e9, multicast_rate=1e6).wifi()
    assert {f.kind for f in ds.plan(NAV2, ds.DDS, slow).remedies} >= {"radio", "multicast rate"}


def test_what_cannot_be_changed_is_named() -> None:
    old = ds.plan(NAV2, ds.DDS, ds.WIFI["802.11a 20 MHz 1x1"])
    assert old.left_out[0].startswith("aggregation: mpdus must be a whole number")
    preset = ds.WIFI["802.11n 20 MHz 2x2"]
    own = replace(preset, unicast=replace(preset.unicast, overhead=1e-4))
    reasons = ds.plan(NAV2, ds.DDS, own).left_out
    assert reasons == (
        "multicast rate: known only of channels made by a Radio",
        "aggregation: known only of channels made by a Radio",
    )
    few = ds.plan(FIG3).left_out
    assert any("not every part would have two hosts" in reason for reason in few)
    assert any(reason.startswith("parameter services: no process") for reason in few)
    best = ds.Radio("802.11ax", width=160e6, streams=2, multicast_rate=24e6, mpdus=64).wifi()
    kinds = {found.kind for found in ds.plan(NAV2, ds.DDS, best).remedies}
    assert kinds == {"endpoints", "channels", "domains", "middleware"}


def test_nodes_of_the_parameter_services() -> None:
    assert parameter_service_endpoints() == 12
    by_default = remedy(ds.plan(NAV2), "endpoints")
    assert [group.endpoints for group in by_default.fleets[0].groups] == [666, 78]
    assert by_default.what == "leaving out the parameter services of 1 node a process (assumed)"
    one_for_all = remedy(ds.plan(NAV2, nodes=7), "endpoints")
    assert [group.endpoints for group in one_for_all.fleets[0].groups] == [594, 6]
    assert not [r for r in ds.plan(NAV2, nodes=0).remedies if r.kind == "endpoints"]
    nav2 = sum(int(row["how_many"]) for row in read_data("fleets/nav2_nodes.csv"))
    assert nav2 * 12 < robots.endpoints


def test_a_table_of_ones_own_may_switch_to_both() -> None:
    own = ds.Protocol("own", ds.DDS.messages[:2])
    plan = ds.plan(FIG3, own)
    assert [r.protocol.name for r in plan.remedies if r.kind == "middleware"] == ["Zenoh", "DDS"]
    assert "adds" in remedy(plan, "middleware", 1).sentence()
    assert isinstance(plan.picture(), Figure)


def test_advice_says_time_beside_one_second_and_the_gains() -> None:
    text = ds.plan(FIG3, ds.DDS).advice()
    flat = " ".join(text.split())
    assert "3 hosts with 24 processes takes 1.38 s of airtime. Channel: paper (802.11n)." in flat
    assert "That is 138% of each second, so it does not fit." in flat
    assert "1. Composing 8 processes into 1 cuts 1.38 s to 0.11 s (92%); that fits." in flat
    assert "(802.11n 40 MHz 2x2: 300 instead of 144 Mbit/s) cuts 4%, to 1.32 s." in flat
    assert max(map(len, text.splitlines())) <= 79
    assert str(ds.plan(FIG3, ds.DDS)) == text
    small = ds.plan(ds.Fleet.swarm(2, 1, 5)).advice()
    assert "so it fits" in small
    assert " ms of airtime" in small
    assert "that fits" not in small
    groups = ds.plan(NAV2, ds.ZENOH).advice()
    assert "- The group laptop takes part in 11% of it." in groups
    assert "The message that takes most is Declare: nearly all." in groups
    assert "changes less than 0.5%." in groups
    assert "Switching to DDS adds 9%: 26.2 s becomes 28.4 s." in groups
    one = ds.plan(ds.Fleet.swarm(1, 1, 10)).advice()
    assert "1 host with 1 process takes" in one
    named = ds.Fleet((replace(robots, processes=2), laptop))
    assert "Composing 2 processes of robots into 1" in ds.plan(named).advice()
    several = ds.Fleet((replace(robots, processes=2), replace(laptop, processes=3)))
    assert "Composing the processes of each host into 1" in ds.plan(several).advice()


def test_table_and_json_hold_the_same_numbers() -> None:
    plan = ds.plan(NAV2, ds.ZENOH, nodes=[13, 2])
    table = plan.table()
    read = json.loads(plan.to_json())
    assert read == plan.to_dict()
    assert read["airtime_s"] == read["utilization"] == plan.utilization
    assert read["fits"] is False
    assert [group["name"] for group in read["fleet"]] == ["robots", "laptop"]
    assert read["fleet"][0]["endpoints"] == 678
    assert list(table.index) == [entry["what"] for entry in read["remedies"]]
    assert table["airtime_s"].tolist() == [entry["airtime_s"] for entry in read["remedies"]]
    assert table["saved"].tolist() == [entry["saved"] for entry in read["remedies"]]
    assert table["fits"].tolist() == [r.utilization < 1 for r in plan.remedies]
    for entry, found in zip(read["remedies"], plan.remedies, strict=True):
        assert entry["price"] == found.price
        assert len(entry["fleets"]) == len(found.fleets)
    shares = plan.shares_table()
    assert shares["share"].tolist() == [entry["share"] for entry in read["shares"]]


def test_the_picture_has_a_bar_and_a_name_for_each_remedy() -> None:
    plan = ds.plan(FIG3)
    figure = plan.picture()
    (axis,) = figure.axes
    widths = [patch.get_width() for patch in axis.patches]  # type: ignore[attr-defined]
    assert widths == approx([plan.utilization, *(r.utilization for r in plan.remedies)])
    texts = [text.get_text() for text in axis.texts]
    assert "as it is" in texts
    assert {found.what for found in plan.remedies} <= set(texts)
    assert "[s]" in axis.get_xlabel()


def test_planning_on_with_what_a_remedy_holds() -> None:
    first = ds.plan(FIG3, ds.DDS).remedies[0]
    (fleet,) = first.fleets
    again = ds.plan(fleet, first.protocol, first.wifi)
    assert again.utilization == first.utilization
    assert not [found for found in again.remedies if found.kind == "processes"]


@pytest.mark.parametrize(
    ("arguments", "error", "message"),
    [
        ((WRONG,), TypeError, "fleet must be a Fleet; got 5"),
        ((FIG3, WRONG), TypeError, "protocol must be a Protocol; got 5"),
        ((FIG3, ds.DDS, WRONG), TypeError, "wifi must be a Wifi; got 5"),
        ((ds.Fleet.swarm(2.5, 1, 1),), ValueError, "hosts must be a whole number; got 2.5"),
        ((ds.Fleet.swarm([1, 2], 1, 1),), TypeError, "hosts must be one number, not an array"),
        ((ds.Fleet.symbolic(1),), TypeError, "hosts must be a number here, not an expression"),
    ],
)
def test_wrong_arguments_are_named(
    arguments: tuple[Any, ...], error: type[Exception], message: str
) -> None:
    with pytest.raises(error, match=message):
        ds.plan(*arguments)


@pytest.mark.parametrize(
    ("nodes", "message"),
    [
        (-1, "nodes must be a finite number of at least 0, or an array of them|nodes .* got -1"),
        ([1, 2, 3], "nodes must be one number, or one for each of 2 groups; got"),
        ([[1, 2]], "nodes must be one number, or one for each of 2 groups; got"),
        (8, "nodes of laptop must be at most 7.5 for processes of 90 endpoints, .* have 12; got 8"),
        (float("nan"), "nodes must be .*; got nan"),
    ],
)
def test_wrong_nodes_are_named(nodes: Any, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        ds.plan(NAV2, nodes=nodes)


def test_importing_the_package_loads_neither_pandas_nor_matplotlib_nor_click() -> None:
    code = (
        "import sys, discostorm;"
        "print([m for m in ('pandas', 'matplotlib', 'click') if m in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", code], text=True, capture_output=True, check=True)
    assert done.stdout == "[]\n"


def test_what_fits_is_said_alike_everywhere() -> None:
    plan = ds.plan(FIG3)
    taken = [found.utilization for found in plan.remedies]
    assert 1 < plan.utilization < 2
    assert any(value < 1 for value in taken)
    assert any(1 < value < 2 for value in taken)
    said = plan.to_dict()
    assert said["fits"] is False
    assert [entry["fits"] for entry in said["remedies"]] == [value < 1 for value in taken]
    assert plan.table()["fits"].tolist() == [value < 1 for value in taken]
    assert ds.plan(ds.Fleet.swarm(2, 1, 5)).to_dict()["fits"] is True


def test_advice_names_what_takes_most_and_groups_only_if_there_are_several() -> None:
    alone = ds.plan(FIG3).advice()
    assert "The phase that takes most is SEDP:" in alone
    assert "The message that takes most is SEDP:" in alone
    assert "The group" not in alone
    assert "The group robots takes part in" in ds.plan(NAV2).advice()
    one = ds.Fleet((replace(robots, processes=8),))
    assert "Composing 8 processes into 1" in ds.plan(one).advice()


def test_json_is_indented_by_two() -> None:
    assert ds.plan(FIG3).to_json().splitlines()[1].startswith('  "')


def test_json_keeps_the_letters_of_names() -> None:
    named = ds.Fleet((replace(robots, name="Bodenläufer"),))
    assert "Bodenläufer" in ds.plan(named).to_json()


def test_radios_that_are_not_faster_are_passed_over() -> None:
    wifi = replace(ds.PAPER, unicast=ds.Link(400e6, ds.PAPER.unicast.overhead))
    radios = [found.what for found in ds.plan(FIG3, wifi=wifi).remedies if found.kind == "radio"]
    assert [any(name in what for what in radios) for name in ("11n", "11ac", "11ax")] == [
        False,
        True,
        True,
    ]


def test_hosts_are_dealt_out_from_the_first_part() -> None:
    assert [part.groups[0].hosts for part in split(ds.Fleet.swarm(3, 1, 1), 2)] == [2, 1]
    with pytest.raises(ValueError, match=r"parts must be .* at least 1 .*; got 0"):
        split(FIG3, 0)


def test_every_part_of_a_split_has_two_hosts() -> None:
    assert "splitting onto 2 channels" in {
        r.what for r in ds.plan(ds.Fleet.swarm(4, 2, 5)).remedies
    }
    assert "splitting onto 2 channels" not in {r.what for r in ds.plan(FIG3).remedies}


def test_what_is_proposed_for_the_radio() -> None:
    assert (MULTICAST_RATE, MPDUS) == (24e6, 64)


@pytest.mark.parametrize(
    ("seconds", "words"),
    [
        (0.00123, "1.23 ms"),
        (0.00999, "9.99 ms"),
        (0.01, "0.010 s"),
        (0.0456, "0.046 s"),
        (0.1, "0.10 s"),
        (9.5, "9.50 s"),
        (10, "10.0 s"),
        (10.5, "10.5 s"),
        (1234.5, "1,234.5 s"),
        (1e6, "1e+06 s"),
        (3.7028e15, "3.7e+15 s"),
    ],
)
def test_times_in_words(seconds: float, words: str) -> None:
    assert planner._time(seconds) == words


@pytest.mark.parametrize(
    ("share", "words"),
    [(0.5, "50%"), (0.994, "99%"), (0.995, "nearly all"), (1, "100%"), (0, "0%")],
)
def test_parts_in_words(share: float, words: str) -> None:
    assert planner._part(share) == words


@pytest.mark.parametrize(
    ("share", "words"),
    [
        (0.00087, "0.087%"),
        (0.01, "1%"),
        (0.994, "99%"),
        (0.995, "just below 100%"),
        (0.9969, "just below 100%"),
        (1, "100%"),
        (28.44, "2,844%"),
        (999_999.5, "99,999,950%"),
        (1e6, "1e+08%"),
        (3.7e15, "3.7e+17%"),
    ],
)
def test_percent_in_words(share: float, words: str) -> None:
    assert planner._percent(share) == words


def test_each_kind_of_remedy_is_warned_of_once() -> None:
    plan = ds.plan(FIG3)
    prices = {found.kind for found in plan.remedies if found.price}
    assert plan.advice().count("Mind: ") == len(prices)
    assert len(prices) > 1


def test_what_does_not_help_is_told_apart() -> None:
    helps, rest = ds.plan(NAV2, ds.ZENOH).advice().split("What would not help:\n")
    assert "What would help, most first:\n 1. " in helps
    assert "adds" not in helps
    assert "changes less than" not in helps
    others, _ = rest.split("\n\n")
    assert "- Switching to DDS adds 9%: 26.2 s becomes 28.4 s." in others
    assert "- Sending multicast at 24 instead of 6 Mbit/s changes less than 0.5%." in others
    assert others.count("- ") == 2
    assert "not help" not in ds.plan(FIG3).advice()


def test_nothing_may_help() -> None:
    best = ds.Radio("802.11ax", width=160e6, streams=2, multicast_rate=24e6, mpdus=64).wifi()
    advice = ds.plan(ds.Fleet.swarm(2, 1, 5), ds.ZENOH, best).advice()
    assert "Nothing that was tried helps:\n- Switching to DDS adds" in advice
    assert "What would" not in advice


def test_a_channel_that_is_just_full_does_not_fit() -> None:
    # A frame of 1024 bits at 2048 bit/s, up and down: exactly a second.
    payload = ds.Payload(64, 64, 64, "made up")
    message = ds.Message("m", "p", "multicast", "UDP", payload, PROCESS, 1)
    wifi = ds.Wifi("made up", ds.Link(2048, 0), ds.Link(2048, 0))
    plan = ds.plan(ds.Fleet.swarm(1, 1, 0), ds.Protocol("own", (message,)), wifi)
    assert plan.utilization == 1
    assert plan.to_dict()["fits"] is False
    assert "That is 100% of each second, so it does not fit." in plan.advice()
    assert "; that fits." in plan.advice()
    slow = replace(wifi, unicast=ds.Link(1024, 0))
    faster = next(r for r in ds.plan(plan.fleet, plan.protocol, slow).remedies if r.kind == "radio")
    assert 0.5 < faster.utilization < 1
    full = replace(plan, remedies=(replace(faster, utilization=1.0),))
    assert full.table()["fits"].tolist() == [False]
    assert full.to_dict()["remedies"][0]["fits"] is False
    assert "; that fits" not in replace(full, utilization=2.0).advice()


def test_gains_are_told_from_what_there_was() -> None:
    plan = ds.plan(ds.Fleet.swarm(2, 1e8, 0))
    assert {found.before for found in plan.remedies} == {plan.utilization}
    said = plan.remedies[0].sentence()
    assert "composing 100,000,000 processes into 1 cuts 2.98e+13 s to" in said


def test_a_fleet_that_sends_nothing_has_nothing_to_save() -> None:
    pairs = ds.Protocol("pairs", tuple(m for m in ds.DDS.messages if m.name == "Heartbeat"))
    plan = ds.plan(ds.Fleet.swarm(1, 2, 20), pairs)
    assert plan.utilization == 0
    assert {found.saved for found in plan.remedies} == {0}
    assert {share.share for share in plan.shares} == {0}
    assert "Nothing that was tried helps:" in plan.advice()


def test_unnamed_groups_are_told_apart_from_named_ones() -> None:
    group = ds.HostGroup(2, 1, 10)
    fleet = ds.Fleet((group, replace(group, name="group 1"), group))
    names = {share.name for share in ds.plan(fleet).of_kind("group")}
    assert names == {"group 1 (unnamed)", "group 1", "group 3"}


def test_composing_into_more_endpoints_than_are_taken_is_left_out() -> None:
    plan = ds.plan(ds.Fleet.swarm(10, 1e6, 1e5))
    assert not [found for found in plan.remedies if found.kind == "processes"]
    assert plan.left_out[0].startswith(
        "composing 1,000,000 processes into 1: endpoints must be a finite number"
    )


def test_what_was_left_out_is_told() -> None:
    plan = ds.plan(FIG3)
    assert plan.left_out
    _, told = plan.advice().split("Left out:")
    assert told.count("\n- ") == len(plan.left_out)
    assert "Left out" not in replace(plan, left_out=()).advice()


def test_a_faster_multicast_rate_is_named_in_megabits() -> None:
    (what,) = (found.what for found in ds.plan(FIG3).remedies if found.kind == "multicast rate")
    assert "24 instead of 6 Mbit/s" in what


def test_a_process_may_consist_of_parameter_services_alone() -> None:
    fleet = ds.Fleet.swarm(3, 1, parameter_service_endpoints())
    for plan in (ds.plan(fleet), ds.plan(fleet, nodes=1)):
        assert any("the parameter services of 1 node" in found.what for found in plan.remedies)
