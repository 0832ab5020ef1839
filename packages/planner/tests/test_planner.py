"""The planner: every gain is computed a second time, from hosts and frames written out."""

import json
import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner
from hypothesis import given, settings, strategies as st
from matplotlib.figure import Figure

import discostorm as ds
from discostorm import words
from discostorm.cli import main
from discostorm.data import read_data
from discostorm.messages import PROCESS
from discostorm.model import burst as burst_of
from discostorm.protocols import MEASURED, MITIGATED
from discostorm.robots import parameter_service_endpoints, robots as robots_by_name
from discostorm_planner import protocol_changes, remedy_rules
from discostorm_planner.aggregation_range import AggregationRange
from discostorm_planner.changes import Setting
from discostorm_planner.fleet_changes import split
from discostorm_planner.radio_changes import MPDUS, MULTICAST_RATE
from discostorm_planner.reboot import reboot
from discostorm_simulation import staggered

#: Hosts, each a list with the endpoints of each of its processes.
Hosts = Sequence[Sequence[float]]

#: The paper's channel: what a frame of so many octets takes [s], in each of the two ways.
Frames = dict[str, Callable[[int], float]]
PAPER: Frames = {
    "unicast": lambda octets: 8 * octets / 144.4e6 + 180e-6,
    "multicast": lambda octets: 8 * octets / 6e6 + 120e-6,
}

#: Neither text nor a fleet.
WRONG: Any = 5
#: Not one number.
WRONG_WINDOW: Any = [1, 2]

robots = ds.HostGroup(10, 1, 678, name="robots")
laptop = ds.HostGroup(1, 1, 90, name="laptop")
NAV2 = ds.Fleet((robots, laptop))
#: The same, of which it is known what ROS 2 shares.
TOLD = ds.Fleet((replace(robots, nodes=13, shared=28), replace(laptop, nodes=2, shared=6)))
ROWS_ARRANGED = [row for row in read_data("vendors/remedies.csv") if row["table"] and row["base"]]
ARRANGED_KINDS = {row["kind"] for row in ROWS_ARRANGED}
PRODUCT_OF = {row["table"]: row["base"] for row in ROWS_ARRANGED}
CHANNEL = {"radio", "multicast rate", "aggregation"}
RADIO = ds.WIFI["802.11n 20 MHz 2x2"]
FASTEST = ds.Radio("802.11ax", width=160e6, streams=2, multicast_rate=24e6, mpdus=64).wifi()
FIG3 = ds.Fleet.swarm(3, 8, 5)
PLAN_OF_FIG3 = ds.plan(FIG3)


def written_out(fleet: ds.Fleet) -> Hosts:
    return [
        [group.endpoints] * int(group.processes)
        for group in fleet.groups
        for _ in range(int(group.hosts))
    ]


def in_symbols(octets: int, padding: ds.OfdmSymbols) -> float:
    """Whole symbols of 3.6 or 4 us and so on, on a grid, counted in tenths of a microsecond."""
    symbols = -(-(padding.added + 8 * octets) // padding.bits)
    ticks, grid = round(padding.symbol * 1e7), round(padding.grid * 1e7)
    return -(-symbols * ticks // grid) * grid * 1e-7


def frames_of(wifi: ds.Wifi) -> Frames:
    """What frames take on a channel, written out from its numbers."""

    def alone(octets: int, link: ds.Link) -> float:
        if link.padding is None:
            return 8 * octets / link.rate + link.overhead
        return link.overhead + in_symbols(octets, link.padding)

    def unicast(octets: int) -> float:
        if wifi.aggregation is None:
            return alone(octets, wifi.unicast)
        subframe = 4 + -(-(octets + 2) // 4) * 4  # a delimiter, QoS Control, padding
        many = min(wifi.aggregation.mpdus, wifi.aggregation.most_bytes // subframe)
        assert wifi.unicast.padding is not None
        data = in_symbols(many * subframe, wifi.unicast.padding)
        return (wifi.aggregation.overhead + data) / many

    return {"unicast": unicast, "multicast": lambda octets: alone(octets, wifi.multicast)}


def by_hand(hosts: Hosts, protocol: str = "DDS", frames: Frames = PAPER) -> float:
    """Airtime, from who tells whom, with the frames as Table II prints them."""

    def frame(octets: int, cast: str) -> float:
        return frames[cast](octets)

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
    # Servers are easier, and make what the product itself sends fit; then it comes first.
    (*before, first) = plan.remedies[: plan.remedies.index(composed) + 1]
    assert all(r.now_fits and r.rank < composed.rank for r in before)
    assert {r.kind for r in before} <= ARRANGED_KINDS
    assert first == composed
    assert (
        composed.sentence()
        == "composing 8 processes into 1 cuts 1.38 s to 0.11 s (92%), which fits"
    )
    assert remedy(plan, "middleware").utilization == approx(by_hand([[5] * 8] * 3, "Zenoh"))
    # The channel's changes: both sides by the standard's timing.
    now = by_hand([[5] * 8] * 3, frames=frames_of(ds.Radio("802.11n", streams=2).wifi()))
    changed = {
        "multicast rate": [ds.Radio("802.11n", streams=2, multicast_rate=24e6)],
        "aggregation": [ds.Radio("802.11n", streams=2, mpdus=64)],
        "radio": [
            ds.Radio("802.11ac", streams=2, width=80e6),
            ds.Radio("802.11n", streams=2, width=40e6),
            ds.Radio("802.11ax", streams=2, width=160e6),
        ],
    }
    for kind, radios in changed.items():
        for index, radio in enumerate(radios):
            found = remedy(plan, kind, index)
            assert found.wifi.unicast == radio.wifi().unicast
            expected = by_hand([[5] * 8] * 3, frames=frames_of(radio.wifi()))
            assert (found.before, found.utilization) == (approx(now), approx(expected))
            assert "standard timing" in found.sentence()


@pytest.mark.parametrize("protocol", [ds.DDS, ds.ZENOH], ids=lambda protocol: protocol.name)
def test_ten_nav2_robots_and_a_laptop_by_hand(protocol: ds.Protocol) -> None:
    plan = ds.plan(TOLD, protocol)
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
        split_up = {r.kind: r for r in plan.remedies if len(r.fleets) == len(parts)}
        assert split_up["channels"].utilization == approx(max(parts))
        # Zenoh peers hear each other in every domain.
        assert ("domains" in split_up) == (name == "DDS")
        if name == "DDS":
            assert split_up["domains"].utilization == approx(sum(parts))
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
        if found.kind in ("hybrid", "peers", *ARRANGED_KINDS):
            # Neither of the paper's tables: by what `utilization` says, which its own tests check.
            own, base = found.protocol, PRODUCT_OF.get(found.protocol.name, protocol.name)
            assert found.fleets == (plan.fleet,)
            assert found.utilization == ds.utilization(own, plan.fleet)
            assert found.before == ds.utilization(ds.PROTOCOLS[base], plan.fleet)
            assert found.saved == approx(1 - found.utilization / found.before)
            continue
        frames = frames_of(found.wifi)
        parts = [by_hand(written_out(f), found.protocol.name, frames) for f in found.fleets]
        expected = max(parts) if found.kind == "channels" else sum(parts)
        assert found.utilization == approx(expected)
        on_air = ds.PAPER
        if found.kind in ("radio", "multicast rate", "aggregation"):
            on_air = ds.Radio("802.11n", streams=2).wifi()
        before = by_hand(written_out(fleet), protocol.name, frames_of(on_air))
        assert found.before == approx(before)
        assert found.saved == pytest.approx(1 - expected / before, abs=1e-10)
    for whole in (True, False):
        usual = [r for r in plan.remedies if r.all_discover == whole and r.kind != "hybrid"]
        fit = [r.utilization < 1 <= r.before for r in usual]
        assert fit == sorted(fit, reverse=True)
        ranks = [r.rank for r in usual[: sum(fit)] if not r.best_case]
        assert ranks == sorted(ranks)
        for best_case in (False, True):
            rest = [r for r in usual[sum(fit) :] if r.best_case == best_case]
            assert [r.saved for r in rest] == sorted((r.saved for r in rest), reverse=True)
        # What is the best case alone stands behind what is counted, whatever it saves.
        sure = [(not r.now_fits, r.best_case) for r in usual]
        assert sure == sorted(sure)
    # What tears the fleet apart stands behind everything that does not.
    assert [r.all_discover for r in plan.remedies] == sorted(
        (r.all_discover for r in plan.remedies), reverse=True
    )
    assert {r.kind for r in plan.remedies if not r.all_discover} <= {"channels", "domains"}
    by_endpoints = [sum(sum(host) for host in written_out(f)) for f in (fleet,)]
    composed = [found for found in plan.remedies if found.kind == "processes"]
    assert bool(composed) == any(processes > 1 for _, processes, _ in counts)
    for found in composed:
        assert [sum(sum(host) for host in written_out(f)) for f in found.fleets] == by_endpoints
        assert all(len(host) == 1 for host in written_out(found.fleets[0]))


@given(fleets, st.integers(0, 4))
@settings(max_examples=40, deadline=None)
def test_a_split_fleet_has_the_same_hosts_in_parts_that_differ_by_one_at_most(
    counts: list[tuple[int, int, int]], parts: int
) -> None:
    fleet = ds.Fleet(tuple(ds.HostGroup(*group) for group in counts))
    hosts = written_out(fleet)
    if not 0 < parts <= len(hosts):
        with pytest.raises(ValueError, match=r"parts must be .* at most"):
            split(fleet, parts)
        return
    pieces = [written_out(piece) for piece in split(fleet, parts)]
    dealt = [list(host) for piece in pieces for host in piece]
    assert sorted(dealt) == sorted(map(list, hosts))
    # Dealt out from the first part on.
    sizes = [len(piece) for piece in pieces]
    assert sizes == sorted(sizes, reverse=True)
    assert sizes[0] - sizes[-1] <= 1


def test_shares_are_parts_of_the_whole() -> None:
    plan = ds.plan(NAV2, ds.DDS)
    for kind in ("message", "phase"):
        shares = plan.of_kind(kind)
        assert sum(share.utilization for share in shares) == approx(plan.utilization)
        assert sum(share.share for share in shares) == approx(1)
        assert [s.share for s in shares] == sorted((s.share for s in shares), reverse=True)
    assert plan.of_kind("message")[0].name == "SEDP"
    groups = {share.name: share.utilization for share in plan.of_kind("group")}
    whole = by_hand([[678]] * 10 + [[90]])
    assert groups["laptop"] == approx(whole - by_hand([[678]] * 10))
    assert groups["robots"] == approx(whole - by_hand([[90]]))
    (alone,) = ds.plan(FIG3).of_kind("group")
    assert (alone.name, alone.share) == ("group 1", 1)
    # Groups of the same hosts are groups all the same.
    group = ds.HostGroup(2, 1, 10)
    shares = ds.plan(ds.Fleet((group, replace(group, name="group 1"), group))).of_kind("group")
    expected = by_hand([[10]] * 6) - by_hand([[10]] * 4)
    assert [share.utilization for share in shares] == [approx(expected)] * 3
    assert {share.name for share in shares} == {"group 1 (unnamed)", "group 1", "group 3"}


def test_on_a_preset_the_channel_changes_in_all_that_its_standard_says() -> None:
    assert (MULTICAST_RATE, MPDUS) == (24e6, 64)
    plan = ds.plan(NAV2, ds.DDS, RADIO)
    expected = {
        "multicast rate": ds.Radio("802.11n", streams=2, multicast_rate=MULTICAST_RATE).wifi(),
    }
    for kind, wifi in expected.items():
        found = remedy(plan, kind)
        assert found.wifi == wifi
        assert found.utilization == approx(float(ds.utilization(ds.DDS, NAV2, wifi=wifi)))
    names = {found.wifi.name for found in plan.remedies if found.kind == "radio"}
    assert names == {"802.11n 40 MHz 2x2", "802.11ac 80 MHz 2x2", "802.11ax 160 MHz 2x2"}
    for found in plan.remedies:
        if found.kind != "radio":
            continue
        assert found.wifi == ds.WIFI[found.wifi.name]
        assert found.before == plan.utilization
        assert "802.11n 20 MHz 2x2: " in found.sentence()
        assert "standard timing" not in found.sentence()
    assert [reason.split(":")[0] for reason in plan.not_applicable] == [
        "composing",
        "a longer announcement interval",
        "aggregation",
        "a router behind the access point",
        "a router on each host",
        "a router on each host, linked with one behind the access point",
    ]
    assert "a router on each host: for Zenoh only" in plan.not_applicable


def test_another_radio_keeps_what_was_chosen_beside_it() -> None:
    base = ds.Radio("802.11n", streams=2, multicast_rate=12e6, aifsn=3, mpdus=16).wifi()
    radios = [found for found in ds.plan(NAV2, ds.DDS, base).remedies if found.kind == "radio"]
    assert len(radios) == 3
    for found in radios:
        radio = found.wifi.radio
        assert radio is not None
        # The channel is that of single frames; the range goes to as many as were chosen.
        assert (radio.multicast_rate, radio.aifsn, radio.mpdus) == (12e6, 3, 1)
        full = replace(radio, mpdus=16).wifi()
        assert found.range_after is not None
        assert found.range_after.full == ds.utilization(ds.DDS, NAV2, wifi=full)
    # Those that are not faster are passed over.
    wide = ds.plan(FIG3, wifi=ds.Radio("802.11ac", width=40e6, streams=2).wifi())
    named = {found.wifi.name for found in wide.remedies if found.kind == "radio"}
    assert named == {"802.11ac 80 MHz 2x2", "802.11ax 160 MHz 2x2"}
    # 1 Mbit/s is of the 2.4 GHz band alone.
    slow = ds.Radio("802.11n", band=2.4e9, multicast_rate=1e6).wifi()
    assert {f.kind for f in ds.plan(NAV2, ds.DDS, slow).remedies} >= {"radio", "multicast rate"}


def test_what_cannot_be_changed_is_named() -> None:
    old = ds.plan(NAV2, ds.DDS, ds.WIFI["802.11a 20 MHz 1x1"])
    assert "aggregation: 802.11a has none" in old.not_applicable
    few = ds.plan(FIG3)
    assert any("not every part would have two hosts" in reason for reason in few.not_applicable)
    assert not any(found.kind == "channels" for found in few.remedies)
    assert any(r.kind == "channels" for r in ds.plan(ds.Fleet.swarm(4, 2, 5)).remedies)
    assert any(reason.startswith("parameter services: no process") for reason in few.not_applicable)
    kinds = {found.kind for found in ds.plan(NAV2, ds.DDS, FASTEST).remedies}
    usual = {"endpoints", "channels", "domains", "middleware"}
    assert kinds - {row["kind"] for row in ROWS_ARRANGED} == usual | {"staggered start", "hybrid"}
    # It may be that nothing helps.
    own = ds.Protocol("own", (replace(ds.ZENOH.messages[0], name="Hi"),))
    advice = ds.plan(ds.Fleet.swarm(2, 1, 5), own, FASTEST).advice()
    assert "No change that we tried helps." in advice
    assert "What would" not in advice


def test_a_channel_changed_by_hand_is_compared_with_no_radio() -> None:
    preset = ds.WIFI["802.11n 20 MHz 2x2"]
    changed = (
        replace(preset, unicast=replace(preset.unicast, overhead=1e-4)),
        replace(ds.PAPER, multicast=ds.Link(24e6, 120e-6)),
    )
    for wifi in changed:
        plan = ds.plan(NAV2, ds.DDS, wifi)
        assert not CHANNEL & {found.kind for found in plan.remedies}
        assert any(
            "changed by hand and no longer matches its Radio" in r for r in plan.not_applicable
        )
    own = ds.plan(NAV2, ds.DDS, ds.Wifi("own", ds.PAPER.unicast, ds.PAPER.multicast))
    assert not CHANNEL & {found.kind for found in own.remedies}
    (why,) = (reason for reason in own.not_applicable if reason.startswith("another radio"))
    assert "has rates and overheads but no Radio" in why
    # Another name changes nothing.
    for wifi in (preset, ds.PAPER):
        named = ds.plan(NAV2, ds.DDS, replace(wifi, name="mine"))
        as_usual = ds.plan(NAV2, ds.DDS, wifi)
        assert [r.saved for r in named.remedies] == [r.saved for r in as_usual.remedies]


def test_a_radio_helps_or_harms_alike_on_both_channels_of_the_same_radio() -> None:
    """The paper's channel and the preset are the same radio, so advice has the same sign."""
    for fleet in (FIG3, NAV2):
        for protocol in (ds.DDS, ds.ZENOH):
            gains = []
            for wifi in (ds.PAPER, ds.WIFI["802.11n 20 MHz 2x2"]):
                plan = ds.plan(fleet, protocol, wifi)
                alike = CHANNEL - {"aggregation"}  # which the preset does already
                gains.append({r.what: r.saved for r in plan.remedies if r.kind in alike})
            assert gains[0] == gains[1]
            assert len(gains[0]) == 4


def test_what_another_radio_changes_is_said() -> None:
    said = remedy(ds.plan(FIG3, ds.DDS, ds.WIFI["802.11n 20 MHz 2x2"]), "radio").sentence()
    assert said.endswith(
        ". Compared with 802.11n 20 MHz 2x2: 867 instead of 144 Mbit/s and 190 instead of 186 µs "
        "of overhead per frame exchange"
    )
    slow = ds.Radio("802.11n", streams=2, band=2.4e9, multicast_rate=1e6).wifi()
    assert "multicast at 6 instead of 1 Mbit/s" in remedy(ds.plan(FIG3, wifi=slow), "radio").note
    three = ds.Radio("802.11n", streams=3).wifi()
    assert "802.11n 40 MHz 3x3" in {r.wifi.name for r in ds.plan(FIG3, wifi=three).remedies}
    many = ds.Radio("802.11ax", width=80e6, streams=2, mpdus=256).wifi()
    for found in ds.plan(FIG3, wifi=many).remedies:
        radio = found.wifi.radio
        if found.kind == "radio" and radio is not None:
            mpdus = 256 if radio.standard == "802.11ax" else 64
            full = replace(radio, mpdus=mpdus).wifi()
            assert found.range_after is not None
            assert found.range_after.full == ds.utilization(ds.DDS, FIG3, wifi=full)


@pytest.mark.parametrize("name", ["DDS", "Zenoh"])
def test_a_staggered_start_has_the_window_and_the_gain_of_the_sweeps(name: str) -> None:
    protocol = ds.PROTOCOLS[name]
    found = remedy(ds.plan(ds.Fleet.swarm(20, 2, 10), protocol), "staggered start")
    window, said = staggered.window(protocol, 20, 2, 10), found.sentence()
    assert found.start_window == window
    assert found.saved == 0
    assert f"over at least {words_of_time(window)}" in said
    rows = [
        row
        for row in read_data("simulated/staggered.csv", "discostorm_planner")
        if (row["protocol"], row["hosts"], row["radio"], row["mpdus"]) == (name, "20", "n", "1")
    ]
    times = {row["start"]: float(row["convergence_time_s"]) for row in rows}
    both = f"{times['rule']:.0f} s instead of {times['together']:.0f} s"
    assert f"20 robots with {name} needed {both}" in said
    # By more than the runs scatter: these intervals of the medians do not meet.
    ends = {row["start"]: row for row in rows}
    column = "convergence_time_s"
    assert float(ends["rule"][f"{column}_high"]) < float(ends["together"][f"{column}_low"])


def test_what_is_repeated_and_fills_the_channel_is_said_first_and_no_window_is_advised() -> None:
    fleet = ds.Fleet((ds.HostGroup(12, 25, 30), ds.HostGroup(2, 3, 200)))
    plan = ds.plan(fleet, ds.PROTOCOLS["Fast DDS"])
    assert plan.steady == ds.utilization(ds.PROTOCOLS["Fast DDS"], plan.fleet, window=math.inf) > 1
    assert plan.advice().startswith("The periodic traffic alone needs ")
    assert not any("staggered start" in found.steps for found in plan.remedies)
    (reason,) = (r for r in plan.not_applicable if r.startswith("starting one after the other"))
    assert f"alone needs {words.percent(plan.steady)} of the channel" in reason
    told = json.loads(plan.to_json())
    assert [told["steady"], told["steady_fits"]] == [plan.steady, False]
    for found, row in zip(
        (*plan.remedies, *plan.combinations), told["remedies"] + told["combinations"], strict=True
    ):
        fits = found.steady < 1
        assert (row["start_within_s"] is not None) == fits == math.isfinite(found.start_window)
        assert ("so the fleet never fits" in found.caution()) != fits
    assert {found.steady < 1 for found in plan.remedies} == {True, False}
    # What fits is told as before.
    small = ds.plan(ds.Fleet.swarm(4, 2, 10), ds.PROTOCOLS["Fast DDS"])
    found = remedy(small, "staggered start")
    start = found.before - small.steady
    assert found.start_window == pytest.approx(start / (1 - small.steady))
    assert "does not fit:" not in small.advice()


def test_domains_are_offered_only_where_they_keep_participants_apart() -> None:
    for name, protocol in ds.PROTOCOLS.items():
        plan = ds.plan(NAV2, protocol)
        if protocol.family is None:
            continue
        zenoh = name.startswith("Zenoh")
        assert protocol.family == ("Zenoh" if zenoh else "DDS")
        offered = any(r.kind == "domains" for r in plan.remedies)
        assert offered == (not zenoh and protocol.basis != "mitigated")
        assert any(
            r.startswith("splitting into domains: in Zenoh") for r in plan.not_applicable
        ) == (zenoh)
        arranged = [r for r in plan.not_applicable if r.startswith("splitting into domains with ")]
        assert bool(arranged) == (not zenoh and not offered)
        # tests/lab/test_snippets.py has two domains at one server.
        if "Server" in name:
            assert "of all domains to each other" in arranged[0]
        assert "splitting onto 2 channels" in {r.what for r in plan.remedies}


def test_of_an_unknown_table_it_is_said_that_nothing_is_known() -> None:
    own = ds.Protocol("own", ds.DDS.messages)
    plan = ds.plan(NAV2, own)
    assert "domains" not in {found.kind for found in plan.remedies}
    (said,) = (reason for reason in plan.not_applicable if "not known for own" in reason)
    assert said.endswith("whose family is neither DDS nor Zenoh")
    for title in ("splitting into domains", "Discovery Server", "router", "static peers"):
        assert title in said
    simulated = remedy(plan, "staggered start").note
    assert "robots with DDS needed" in simulated
    assert "robots with Zenoh needed" in simulated
    # Its messages may have no roles.
    unknown = replace(ds.ZENOH, messages=tuple(replace(m, role=None) for m in ds.ZENOH.messages))
    left_out = ds.plan(NAV2, unknown).not_applicable
    assert "static peers: not known for Zenoh, whose messages have no roles" in left_out


@pytest.mark.parametrize("name", ds.PROTOCOLS)
def test_a_name_decides_nothing(name: str) -> None:
    """Every number and every text of a plan is that of the same table by another name."""
    mine = replace(ds.PROTOCOLS[name], name="(mine)")
    for wifi, window in ((ds.PAPER, 1.0), (RADIO, math.inf)):
        plans = [
            ds.plan(ds.Fleet((robots, TOLD.groups[1])), table, wifi, window=window)
            for table in (ds.PROTOCOLS[name], mine)
        ]
        usual, renamed = (
            [plan.to_json(), " ".join(plan.advice().split()), plan.picture_data().to_json()]
            for plan in plans
        )
        assert [text.replace("(mine)", name) for text in renamed] == usual
        assert not plans[1].picture_data().duplicated(["baseline", "change"]).any()


@pytest.mark.parametrize("name", [n for n, p in ds.PROTOCOLS.items() if p.family])
def test_each_kind_of_remedy_is_computed_or_left_out_with_a_reason(name: str) -> None:
    table = ds.PROTOCOLS[name]
    plan = ds.plan(ds.Fleet.swarm(6, 3, 50), table)
    offered = {found.kind for found in plan.remedies if len(found.steps) == 1}
    switched = {found.kind for found in plan.remedies} - offered
    reasons = "\n".join(plan.not_applicable)
    rows = read_data("vendors/remedies.csv")
    for kind in {row["kind"] for row in rows}:
        of_kind = [row for row in rows if row["kind"] == kind]
        own = [row for row in of_kind if row["family"] in ("any", table.family)]
        if own and own[0]["table"] and own[0]["table"] not in set(ds.PROTOCOLS) - {name}:
            continue  # not measured yet, or in use already
        told = any(
            f"{row['title']}{after}" in reasons
            for row in own or of_kind
            for after in (": ", " with ")
        )
        assert (kind in offered) != told or kind in switched, kind
    assert "Not computed" not in plan.advice()
    assert not hasattr(plan, "not_computed")


def test_every_row_of_the_remedies_has_what_it_needs() -> None:
    rows = read_data("vendors/remedies.csv")
    assert len({(row["kind"], row["family"]) for row in rows}) == len(rows)
    families = {row["family"] for row in read_data("vendors/families.csv")}
    assert {row["family"] for row in rows} == families | {"any"}
    efforts = {
        row["effort"]: int(row["rank"])
        for row in read_data("vendors/efforts.csv", "discostorm_planner")
    }
    assert sorted(efforts.values()) == list(range(1, len(efforts) + 1))
    for row in rows:
        assert row["works"] in ("computed", "no")
        assert row["all_find_each_other"] in ("yes", "no")
        assert row["gain"] in (("counted", "best case") if row["works"] == "computed" else ("",))
        assert all(row[column] for column in ("title", "why", "source"))
        assert bool(row["price"]) == bool(row["effort"]) == (row["works"] == "computed")
        assert not row["effort"] or row["effort"] in efforts
        assert not row["base"] or row["base"] in MEASURED
        arranged = row["family"] == "DDS" and row["table"] in MITIGATED
        assert bool(row["in_domains"]) == arranged
        assert len(f"{row['price']}; {row['fails']}") <= 150, row["title"]
    torn = {row["kind"] for row in rows if row["all_find_each_other"] == "no"}
    assert torn == {"channels", "domains"}
    pasted = {row["kind"] for row in read_data("vendors/snippets.csv")}
    assert pasted == {row["kind"] for row in rows} - {"hybrid"}


def openings(fleet: ds.Fleet, sides: int) -> float:
    """Airtime of four messages a session, as long as a KeepAlive, for each side that dials."""
    processes = [host for host, own in enumerate(written_out(fleet)) for _ in own]
    pairs = sum(here < there for here in processes for there in processes)
    return sides * pairs * 4 * 2 * PAPER["unicast"](84)


def test_switching_to_zenoh_says_what_its_count_leaves_out() -> None:
    plan = ds.plan(FIG3, ds.DDS)
    zenoh = remedy(plan, "middleware")
    gap = plan.utilization - zenoh.utilization
    one, both = openings(FIG3, 1), openings(FIG3, 2)
    assert gap < one < both, "what is left out is larger than the gap"
    assert zenoh.note.endswith(
        f"adds {one:.2f} s if one side dials, {both:.2f} s if both do. The gap is {gap:.2f} s, "
        "so either may need less"
    )
    assert "we count peers that scout by multicast" in zenoh.trade_offs
    assert "does not count the tokens of rmw_zenoh" in zenoh.trade_offs
    # The other way round it is the same gap.
    assert remedy(ds.plan(FIG3, ds.ZENOH), "middleware").note == zenoh.note
    # Of large processes the openings are few.
    nav2 = remedy(ds.plan(NAV2, ds.DDS), "middleware")
    assert openings(NAV2, 2) < nav2.before - nav2.utilization
    assert f"{openings(NAV2, 2):.2f} s if both do" in nav2.note
    assert nav2.note.endswith("and the sessions do not close it")
    # Nobody opens a session alone, or for ever.
    assert remedy(ds.plan(ds.Fleet.swarm(1, 2, 5), ds.DDS), "middleware").note == ""
    for_ever = ds.plan(FIG3, ds.PROTOCOLS["DDS, periods of Fast DDS"], window=math.inf)
    assert {found.note for found in for_ever.remedies if found.kind == "middleware"} == {""}


def test_tables_are_compared_with_those_that_count_alike() -> None:
    paper = {"DDS", "Zenoh"}
    products = {name for name, table in ds.PROTOCOLS.items() if remedy_rules.software(table)}
    assert {"Fast DDS", "Cyclone DDS", "Zenoh peer"} <= products
    products -= MITIGATED
    for name, table in ds.PROTOCOLS.items():
        # What is arranged against the storm can be given up, but is no middleware to switch to.
        others = (
            products
            if name in MITIGATED
            else next(
                group
                for group in (paper, products, set(ds.PROTOCOLS) - paper - products - MITIGATED)
                if name in group
            )
        )
        switched = [r.protocol for r in ds.plan(FIG3, table).remedies if r.kind == "middleware"]
        # Neither a wire nor a proposal is what one can switch to on Wi-Fi.
        never = {name, "hybrid", "hybrid, alike", *(row["table"] for row in ROWS_ARRANGED)}
        never |= {table.wired.name for table in ds.PROTOCOLS.values() if table.wired}
        never.add("Zenoh peer")  # that of ROS 2 has tokens
        expected = set() if name.startswith("hybrid") else others - never
        assert {other.name for other in switched} == expected
        assert all(ds.PROTOCOLS[other.name] == other for other in switched)
    # Of two DDS tables neither opens sessions.
    plan = ds.plan(FIG3, ds.PROTOCOLS["DDS, periods of Fast DDS"])
    notes = {r.protocol.name: r.note for r in plan.remedies if r.kind == "middleware"}
    assert notes["DDS, periods of Cyclone DDS"] == ""
    assert "opens sessions" in notes["Zenoh, periods of Zenoh peer"]
    # Tables of what products send count the sessions themselves.
    plan = ds.plan(FIG3, ds.PROTOCOLS["Fast DDS"])
    assert {r.note for r in plan.remedies if r.kind == "middleware"} == {""}


@pytest.mark.parametrize("name", ds.PROTOCOLS)
@pytest.mark.parametrize("window", [0.5, 1.0, 20, float("inf")])
def test_the_window_is_that_of_utilization_and_is_named(name: str, window: float) -> None:
    table = ds.PROTOCOLS[name]
    plan = ds.plan(FIG3, table, window=window)
    assert plan.utilization == ds.utilization(table, plan.fleet, window=window)
    for found in plan.remedies:
        parts = [
            ds.utilization(found.protocol, part, wifi=found.wifi, window=window)
            for part in found.fleets
        ]
        assert found.utilization == approx(sum(parts))
        assert found.window == window
    text = " ".join(plan.advice().split())
    words = {0.5: "the first 0.5 s", 1: "one second", 20: "the first 20 s"}
    assert words.get(window, "in the steady state") in text
    seconds = json.loads(plan.to_json())["window_s"]
    assert seconds == (None if window == float("inf") else window)
    assert ("an upper bound of the count" in text) == (table.repeats and window < 1e9)
    measured = name in MEASURED | MITIGATED
    of_paper = table.family is not None
    assert ("as the paper does" in text) == (table.repeats and not measured and of_paper)
    assert (f"The measured model of {name} comes from captures" in text) == measured
    if window == 20:
        assert f"needs {words_of_time(20 * plan.utilization)} of airtime" in text


def words_of_time(seconds: float) -> str:
    if seconds < 0.1:
        return f"{1000 * seconds:.3g} ms"
    if seconds >= 100:
        return f"{seconds / 60:.1f} minutes"
    return f"{seconds:.2f} s" if seconds < 10 else f"{seconds:.1f} s"


def test_nodes_of_the_fleet_are_used_and_follow_its_changes() -> None:
    assert parameter_service_endpoints() == 12
    found = remedy(ds.plan(TOLD), "endpoints")
    assert found.what == "leaving out the parameter services of 13 and 2 nodes a process"
    (fewer,) = found.fleets
    assert [group.endpoints for group in fewer.groups] == [678 - 13 * 12, 90 - 2 * 12]
    assert [group.nodes for group in fewer.groups] == [0, 0]
    assert not any(r.kind == "endpoints" for r in ds.plan(fewer).remedies)
    # Where nobody says, one node is assumed, as soon as there are endpoints enough.
    guessed = remedy(ds.plan(NAV2), "endpoints")
    assert [group.endpoints for group in guessed.fleets[0].groups] == [666, 78]
    assert guessed.what == "leaving out the parameter services of 1 node a process (assumed)"
    assert "assumed" in remedy(ds.plan(ds.Fleet((TOLD.groups[0], laptop))), "endpoints").what
    assert "of 1 node" in remedy(ds.plan(ds.Fleet.swarm(3, 1, 12)), "endpoints").what
    split_up = ds.Fleet((ds.HostGroup(3, 4, 50, nodes=2, shared=6),))
    (composed,) = remedy(ds.plan(split_up), "processes").fleets
    assert composed.groups == (ds.HostGroup(3, 1, 200, nodes=8, shared=4 * 6),)
    nav2 = sum(int(row["how_many"]) for row in read_data("fleets/nav2_nodes.csv"))
    assert nav2 * 12 < robots.endpoints


def test_a_table_of_ones_own_may_switch_to_both() -> None:
    own = ds.Protocol("own", ds.DDS.messages[:2])
    plan = ds.plan(FIG3, own)
    assert [r.protocol.name for r in plan.remedies if r.kind == "middleware"] == ["Zenoh", "DDS"]
    assert "adds" in remedy(plan, "middleware", 1).sentence()
    assert isinstance(plan.picture(), Figure)


def test_advice_names_what_is_composed_and_its_lines_are_short() -> None:
    assert str(PLAN_OF_FIG3) == PLAN_OF_FIG3.advice()
    for width in (40, 79):
        table, *_ = PLAN_OF_FIG3.advice(width).split("What this rests on")
        assert max(map(len, table.splitlines())) <= width
    sentences = [found.sentence() for found in ds.plan(NAV2, ds.ZENOH).remedies]
    assert any("changes less than 0.5%" in sentence for sentence in sentences)
    assert any("switching to DDS adds 9%: 26.2 s becomes 28.4 s" in s for s in sentences)
    many, two = replace(robots, processes=8), replace(robots, processes=2)
    for groups, what in (
        ((many,), "composing 8 processes into 1"),
        ((two, laptop), "composing 2 processes of robots into 1"),
        ((two, replace(laptop, processes=3)), "composing the processes of each host into 1"),
    ):
        assert remedy(ds.plan(ds.Fleet(groups)), "processes").what == what


def test_table_and_json_hold_the_same_numbers() -> None:
    named = replace(TOLD.groups[0], name="Bodenläufer")
    plan = ds.plan(ds.Fleet((named, TOLD.groups[1])), ds.ZENOH)
    table = plan.to_frame()
    read = json.loads(plan.to_json())
    assert plan.to_json().splitlines()[1].startswith('  "')
    assert "Bodenläufer" in plan.to_json()
    assert read == plan.to_dict()
    assert read["utilization"] == plan.utilization
    assert read["fits"] is False
    assert [group["name"] for group in read["fleet"]] == ["Bodenläufer", "laptop"]
    assert read["left_out"] == list(plan.not_applicable) != []
    told = sum(map(len, plan.sections().values()))
    rest = len(plan.remedies) + len(plan.combinations) - told
    assert f"{rest} changes, why others are left out" in plan.advice()
    assert read["fleet"][0]["endpoints"] == 678
    entries, every = read["remedies"] + read["combinations"], plan.remedies + plan.combinations
    assert list(table.index) == [entry["what"] for entry in entries]
    columns = (
        "before",
        "utilization",
        "saved",
        "best_case",
        "note",
        "all_find_each_other",
        "fails",
    )
    for column in columns:
        assert table[column].tolist() == [entry[column] for entry in entries]
    assert table["effort"].tolist() == [found.rank for found in every]
    assert table["fits"].tolist() == [found.utilization < 1 for found in every]
    for entry, found in zip(entries, every, strict=True):
        assert entry["price"] == found.trade_offs
        assert len(entry["fleets"]) == len(found.fleets)
    shares = plan.shares_table()
    assert shares["share"].tolist() == [entry["share"] for entry in read["shares"]]


def test_no_number_has_two_names_in_json() -> None:
    """Of what has a name of its own, no two entries are always the same."""
    said = [
        json.loads(ds.plan(fleet, table, window=window).to_json())
        for fleet, window in ((TOLD, 20.0), (FIG3, 1.0))
        for table in ds.PROTOCOLS.values()
    ]
    levels = {
        "plan": said,
        "share": [share for plan in said for share in plan["shares"]],
        "remedy": [found for plan in said for found in plan["remedies"]],
    }
    for entries in levels.values():
        columns: dict[tuple[Any, ...], str] = {}
        for name in entries[0]:
            values = tuple(json.dumps(entry[name]) for entry in entries)
            assert values not in columns, (name, columns.get(values))
            columns[values] = name


def test_the_picture_has_each_remedy_beside_its_own_baseline() -> None:
    plan = ds.plan(FIG3)
    data = plan.picture_data()
    best = {found.kind: found for found in reversed(plan.remedies)}
    drawn = [found for kind, found in best.items() if kind != "staggered start"]
    assert len(drawn) < len(plan.remedies) - 1

    def by(found: ds.Remedy) -> str:
        if found.kind in CHANNEL:
            return "DDS, standard timing"
        base = PRODUCT_OF.get(found.protocol.name)
        return f"{base}, measured model" if base else "DDS, paper model"

    def name(found: ds.Remedy) -> str:
        kind = "at best" if found.best_case else "prototype" if found.kind == "hybrid" else ""
        return f"{found.what} ({kind})" if kind else found.what

    before, after = data[data["change"] == ""], data[data["change"] != ""]
    # A baseline stands first in its group, and each group is together.
    assert list(before.index) == [
        data.index[data["baseline"] == base][0] for base in before["baseline"]
    ]
    assert before["baseline"].is_unique
    assert data["baseline"].ne(data["baseline"].shift()).sum() == len(before)
    as_it_is = before.set_index("baseline")["utilization"]
    assert as_it_is["DDS, paper model"] == plan.utilization
    assert as_it_is["DDS, standard timing"] == remedy(plan, "radio").before
    told = {(row.baseline, row.change): row.utilization for row in after.itertuples()}
    assert told == {(by(found), name(found)): found.utilization for found in drawn}
    assert all(as_it_is[by(found)] == approx(found.before) for found in drawn)

    figure = plan.picture("What helps")
    (axis,) = figure.axes
    assert figure.get_suptitle() == "What helps"
    texts = [text.get_text() for text in axis.texts]
    assert {f"{base}: {words.duration(was)} today" for base, was in as_it_is.items()} <= set(texts)
    assert {words.duration(found.utilization) for found in drawn} <= set(texts)
    labels = {" ".join(label.get_text().split()) for label in axis.get_yticklabels()}
    assert labels == {"", *map(name, drawn)}
    assert "[s]" in axis.get_xlabel()
    (steady,) = ds.plan(FIG3, ds.PROTOCOLS["Fast DDS"], window=math.inf).picture().axes
    assert "[%]" in steady.get_xlabel()
    on_preset = ds.plan(FIG3, wifi=RADIO).picture_data()
    assert dict(on_preset[on_preset["change"] == ""].set_index("baseline")["utilization"]) == {
        "DDS, paper model": ds.plan(FIG3, wifi=RADIO).utilization,
    } | {
        f"{base}, measured model": ds.utilization(ds.PROTOCOLS[base], plan.fleet, wifi=RADIO)
        for base in ("Fast DDS", "Cyclone DDS")
    }


def test_planning_on_with_what_a_remedy_holds() -> None:
    plan = ds.plan(FIG3, ds.DDS)
    assert {"processes", "discovery server"} <= {found.kind for found in plan.remedies}
    for first in plan.remedies:
        (fleet,) = first.fleets
        again = ds.plan(fleet, first.protocol, first.wifi)
        # A radio that aggregates has a range, of which that of full exchanges is the better end.
        full = first.kind == "aggregation"
        assert (again.utilization_range.full if full else again.utilization) == first.utilization
        # What was done is not proposed again, but other radios and middleware are.
        kinds = {found.kind for found in again.remedies}
        assert first.kind in {"radio", "middleware", "staggered start"} or first.kind not in kinds


@pytest.mark.parametrize(
    ("arguments", "error", "message"),
    [
        ((WRONG,), TypeError, "fleet must be a Fleet; got 5"),
        ((FIG3, WRONG), TypeError, "protocol must be a Protocol; got 5"),
        ((FIG3, ds.DDS, WRONG), TypeError, "wifi must be a Wifi; got 5"),
        (
            (ds.Fleet.swarm(2.5, 1, 1),),
            ValueError,
            "hosts must be a whole number of at least 1; got 2.5",
        ),
        ((ds.Fleet.swarm([1, 2], 1, 1),), TypeError, "hosts must be one number, not an array"),
        ((ds.Fleet.symbolic(1),), TypeError, "hosts must be a number here, not an expression"),
    ],
)
def test_wrong_arguments_are_named(
    arguments: tuple[Any, ...], error: type[Exception], message: str
) -> None:
    with pytest.raises(error, match=message):
        ds.plan(*arguments)
    with pytest.raises(ValueError, match="window must be a finite number"):
        ds.plan(FIG3, window=0)
    with pytest.raises(TypeError, match="window must be one number"):
        ds.plan(FIG3, window=WRONG_WINDOW)


def test_a_channel_that_is_just_full_does_not_fit() -> None:
    # A frame of 1024 bits at 2048 bit/s, up and down: exactly a second.
    payload = ds.Payload(64, 64, 64, "made up")
    message = ds.Message("m", "p", "multicast", "UDP", payload, PROCESS, 1)
    wifi = ds.Wifi("made up", ds.Link(2048, 0), ds.Link(2048, 0))
    plan = ds.plan(ds.Fleet.swarm(1, 1, 0), ds.Protocol("own", (message,)), wifi)
    assert plan.utilization == 1
    assert plan.to_dict()["fits"] is False
    assert "Charged to one second, that is 100% of it, so it does not fit." in plan.advice()
    small = ds.plan(FIG3)
    composed = remedy(small, "processes")
    assert composed.utilization < 1
    fits = [found.utilization < 1 for found in (*small.remedies, *small.combinations)]
    assert {True, False} == set(fits)
    assert small.to_frame()["fits"].tolist() == fits
    just_full, twice = (AggregationRange(value, None, value) for value in (1.0, 2.0))
    found = (replace(composed, range_after=just_full),)
    full = replace(plan, fleet=FIG3, utilization_range=twice, remedies=found, combinations=())
    assert full.to_frame()["fits"].tolist() == [False]
    assert full.to_dict()["remedies"][0]["fits"] is False
    assert ", which fits" not in full.advice()
    assert ", which fits" in replace(full, remedies=(composed,)).advice()


def test_gains_are_told_from_what_there_was() -> None:
    plan = ds.plan(ds.Fleet.swarm(2, 1e8, 0))
    for found in plan.remedies:
        base = PRODUCT_OF.get(found.protocol.name)
        if base is not None:
            assert found.before == ds.utilization(ds.PROTOCOLS[base], plan.fleet)
            assert found.note == f"both values are of {base}'s measured model"
        elif found.kind not in CHANNEL:
            assert found.before == plan.utilization
    said = plan.remedies[0].sentence()
    assert "composing 100,000,000 processes into 1 cuts 945,000 years to" in said
    # What is left counts, however little it is of what there was.
    tiny = [found for found in plan.combinations if found.saved == 1 and found.utilization]
    assert tiny
    assert all("(just below 100%)" in found.sentence() for found in tiny)


def test_what_a_change_adds_to_nothing_is_told() -> None:
    alone, on_robot = ds.Fleet.swarm(1, 2, 5), "Fast DDS Discovery Server, on a robot"
    plan = ds.plan(alone, ds.PROTOCOLS[on_robot])
    assert plan.utilization == 0
    wired = remedy(plan, "discovery server")
    taken = ds.utilization(ds.PROTOCOLS["Fast DDS Discovery Server"], plan.fleet)
    assert wired.sentence() == (
        f"a Discovery Server adds {1000 * taken:.1f} ms; nothing was sent before"
    )
    # The other way round nothing is left.
    back = remedy(ds.plan(alone, wired.protocol), "discovery server on a robot")
    assert (back.utilization, back.saved) == (0, 1)
    assert back.sentence().endswith(f"cuts {1000 * taken:.1f} ms to no time (100%)")


def test_several_things_are_told_in_the_plural() -> None:
    plan = ds.plan(FIG3, ds.PROTOCOLS["Fast DDS"])
    said = {found.kind: found.sentence() for found in plan.remedies}
    for kind, start in {
        "discovery server": "a Discovery Server cuts ",
        "two discovery servers": "two Discovery Servers cut ",
        "static endpoints": "static endpoints cut ",
        "processes": "composing 8 processes into 1 cuts ",
        "multicast rate": "sending multicast at 24 instead of 6 Mbit/s c",
        "hybrid": "the hybrid discovery cuts ",
    }.items():
        assert said[kind].startswith(start)
    assert all(" cut " in found.sentence() for found in plan.combinations)


def test_a_fleet_that_sends_nothing_has_nothing_to_save() -> None:
    pairs = ds.Protocol("pairs", tuple(m for m in ds.DDS.messages if m.name == "Heartbeat"))
    plan = ds.plan(ds.Fleet.swarm(1, 2, 20), pairs)
    assert plan.utilization == 0
    assert {found.saved for found in plan.remedies} == {0}
    assert {share.share for share in plan.shares} == {0}
    assert "No change that we tried helps." in replace(plan, fleet=FIG3).advice()


def test_composing_into_more_endpoints_than_are_taken_is_left_out() -> None:
    plan = ds.plan(ds.Fleet.swarm(10, 1e6, 1e5))
    assert not [found for found in plan.remedies if found.kind == "processes"]
    assert plan.not_applicable[0].startswith(
        "composing 1,000,000 processes into 1: endpoints must be a finite number"
    )


def test_the_best_of_all_combinations_by_trying_them_all_by_hand() -> None:
    """On a channel of the standard, without tables: every set of two or three, written out."""
    base = ds.Radio("802.11n", streams=2)
    plan = ds.plan(TOLD, ds.DDS, base.wifi())
    hosts = {
        False: [[678]] * 10 + [[90]],
        True: [[678 - 13 * 12]] * 10 + [[90 - 2 * 12]],
    }
    radios = {
        None: base,
        "n": ds.Radio("802.11n", width=40e6, streams=2),
        "ac": ds.Radio("802.11ac", width=80e6, streams=2),
        "ax": ds.Radio("802.11ax", width=160e6, streams=2),
    }
    taken = {
        (fewer, name, fast): by_hand(
            hosts[fewer],
            "DDS",
            frames_of(replace(radio, multicast_rate=24e6 if fast else None, name=None).wifi()),
        )
        for fewer in (False, True)
        for name, radio in radios.items()
        for fast in (False, True)
    }
    many = {key: key[0] + (key[1] is not None) + key[2] for key in taken}
    assert min(taken.values()) >= 1, "nothing fits, so that what saves most comes first"
    saved = {key: 1 - value / taken[False, None, False] for key, value in taken.items()}
    best = max(saved[key] for key in taken if many[key] in (2, 3))
    # With single frames tables save more than any of these, and only the best sets are kept.
    assert best > 0.2
    assert all(found.saved > best for found in plan.combinations)
    alone = max((r for r in plan.remedies if r.kind == "endpoints"), key=lambda r: r.saved)
    assert alone.range_after is not None
    assert alone.range_after.single == approx(taken[True, None, False])
    for found in plan.combinations:
        assert 2 <= len(found.steps) <= 3
        assert found.kind == "combination"
        assert found.trade_offs.count("; ") >= 1
        # At one frame in each exchange, which all have; each may be told at another value.
        parts = [r.range_after for r in plan.remedies if r.steps[0] in found.steps]
        assert parts
        assert found.range_after is not None
        assert found.range_after.single < min(part.single for part in parts if part is not None)


def test_a_table_that_is_not_there_is_not_offered_and_one_that_is_there_is(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    name = "Fast DDS Discovery Server"
    fast_dds, others = ds.PROTOCOLS["Fast DDS"], dict(ds.PROTOCOLS)
    others.pop(name, None)
    for module in (remedy_rules, protocol_changes):
        monkeypatch.setattr(module, "PROTOCOLS", others)
    assert "discovery server" not in {r.kind for r in ds.plan(NAV2, fast_dds).remedies}
    server = replace(fast_dds, name=name, messages=fast_dds.messages[:3], key=name)
    for module in (remedy_rules, protocol_changes):
        monkeypatch.setattr(module, "PROTOCOLS", others | {name: server})
    found = remedy(ds.plan(NAV2, fast_dds), "discovery server")
    assert (found.protocol, found.note) == (server, "")
    assert found.utilization == ds.utilization(server, NAV2)
    assert found.failure_mode.startswith("late joiners stay undiscovered while it is down")
    assert {s.file for s in found.snippets} >= {"fast_dds_server.sh", "fast_dds_client.xml"}
    # The paper's DDS is compared with it by the product's own table.
    papers = remedy(ds.plan(NAV2, ds.DDS), "discovery server")
    assert papers.before == ds.utilization(fast_dds, NAV2)
    assert papers.note == "both values are of Fast DDS's measured model"
    # Of another product it is a switch as well.
    bare = ds.Wifi("own", ds.PAPER.unicast, ds.PAPER.multicast)
    cyclone = ds.plan(NAV2, ds.PROTOCOLS["Cyclone DDS"], bare)
    switched = remedy(cyclone, "discovery server")
    assert switched.steps == ("middleware", "discovery server")
    assert not any("Discovery Server" in reason for reason in cyclone.not_applicable)
    assert all("discovery server" not in r.steps or len(r.steps) > 2 for r in cyclone.combinations)
    # And with it, its product's own table is no configuration of servers.
    served = ds.plan(NAV2, server)
    assert server.family == "DDS"
    assert remedy_rules.software(server) == "Fast DDS"
    assert "Fast DDS" in {r.protocol.name for r in served.remedies if r.kind == "middleware"}


@pytest.mark.parametrize("name", ["Fast DDS", "Cyclone DDS", "Zenoh peer, tokens"])
def test_every_measured_configuration_of_every_product_is_a_change_that_can_be_had_alone(
    name: str,
) -> None:
    (robot,) = (host for kind, host in robots_by_name().items() if kind == "TurtleBot 4 with Nav2")
    wifi = ds.Radio("802.11ac", streams=2, width=80e6, mpdus=64).wifi()
    plan = ds.plan(ds.Fleet((replace(robot, hosts=12),)), ds.PROTOCOLS[name], wifi)
    offered = {found.protocol.name: found for found in plan.remedies}
    assert {row["table"] for row in ROWS_ARRANGED} <= set(offered)
    router = offered["Zenoh router"]
    if name != "Zenoh peer, tokens":
        assert router.steps == ("middleware", "router")
        assert router.efforts == ("switch", "server")
        assert router.rank == 7
        server = offered["Fast DDS Discovery Server"]
        assert router.range_after is not None
        assert server.range_after is not None
        assert router.range_after.full < server.range_after.full
        # Nothing fits, so that what saves most comes first.
        told = plan.sections()["Best single changes:"]
        first = offered["Zenoh router per host"]
        assert first in told
        assert first.efforts == ("switch", "servers")
        assert first.range_after is not None
        assert first.range_after.full < 2 < router.range_after.full


def test_configurations_are_compared_in_one_table() -> None:
    plan = ds.plan(TOLD, ds.PROTOCOLS["Fast DDS"])
    rows = {row.name: row for row in plan.configurations}
    wired = {table.wired.name for table in ds.PROTOCOLS.values() if table.wired}
    assert set(rows) == (set(MEASURED) | set(MITIGATED)) - wired
    assert rows["Fast DDS"].utilization == plan.utilization
    assert [row.startup.single for row in plan.configurations] == sorted(
        row.startup.single for row in rows.values()
    )
    for name, row in rows.items():
        steady = ds.utilization(ds.PROTOCOLS[name], TOLD, window=math.inf)
        assert row.steady_range.single == steady
        start = ds.drain_time(ds.PROTOCOLS[name], TOLD)
        assert row.startup.single == pytest.approx(start)
        assert f"  {name} " in plan.advice()
    told = json.loads(plan.to_json())["configurations"]
    assert [row["protocol"] for row in told] == list(rows)
    # A start that never ends is said so, and JSON has no infinity.
    large = ds.plan(ds.Fleet.swarm(200, 20, 100), ds.PROTOCOLS["Fast DDS"])
    assert "never done" in large.advice()
    assert None in {row["start_s"] for row in json.loads(large.to_json())["configurations"]}


def test_calmer_announcements_are_those_of_the_snippet() -> None:
    for name, period in (("Fast DDS", 15), ("Cyclone DDS", 30)):
        table = ds.PROTOCOLS[name]
        found = remedy(ds.plan(NAV2, table, window=float("inf")), "announcements")
        assert found.protocol.lease == 100
        assert found.protocol.message("SPDP").schedule.period == period
        assert found.protocol.messages != table.messages
        assert found.saved > 0.5
        (piece,) = found.snippets
        assert f"{period}" in piece.text
        assert "100" in piece.text


def test_static_peers_of_zenoh_leave_out_scouting_alone() -> None:
    table = ds.PROTOCOLS["Zenoh peer"]
    plan = ds.plan(NAV2, table)
    found = remedy(plan, "peers")
    gone = {m.name for m in table.messages} - {m.name for m in found.protocol.messages}
    assert gone == {m.name for m in table.of_phase("Scouting")}
    assert found.utilization == ds.utilization(found.protocol, plan.fleet)


def test_what_the_fleet_says_is_shared_is_counted_and_nothing_is_added() -> None:
    """A participant of ROS 2 shares 2 endpoints with every other, and each node 2 more."""
    server = ds.PROTOCOLS["Fast DDS Discovery Server"]
    plan = ds.plan(TOLD)
    assert plan.fleet is TOLD
    assert [group["shared"] for group in plan.to_dict()["fleet"]] == [28, 6]
    found = remedy(plan, "discovery server")
    assert found.utilization == ds.utilization(server, TOLD) > 2
    assert not found.now_fits
    # Programs without ROS 2 share nothing, and then a server is enough.
    without = remedy(ds.plan(NAV2), "discovery server")
    assert without.now_fits
    assert without.utilization == ds.utilization(server, NAV2) < 1
    # The paper's tables know no names.
    assert plan.utilization == ds.utilization(ds.DDS, NAV2)
    # Composing keeps what is shared, leaving out services keeps what there are endpoints for.
    small = ds.plan(ds.Fleet((ds.HostGroup(4, 3, 14, nodes=1, shared=4),)))
    (composed,) = remedy(small, "processes").fleets
    (fewer,) = remedy(small, "endpoints").fleets
    assert [fleet.groups[0].shared for fleet in (composed, fewer)] == [12, 2]


@pytest.mark.parametrize("name", ["DDS", "Zenoh", "Fast DDS", "Cyclone DDS", "Zenoh peer"])
def test_every_remedy_that_can_be_done_says_what_to_paste(name: str) -> None:
    plan = ds.plan(ds.Fleet.swarm(6, 3, 50), ds.PROTOCOLS[name])
    for found in (*plan.remedies, *plan.combinations):
        if found.kind == "hybrid" or (found.kind == "middleware" and found.protocol == ds.DDS):
            assert not found.snippets
            continue
        assert found.snippets, found.what
    for found in plan.remedies:
        if found.kind == "radio":
            (piece,) = found.snippets
            width = found.wifi.radio.width / 1e6 if found.wifi.radio else 0
            assert f"{width:.0f}mhz" in piece.file


def test_a_host_without_others_is_advised_nothing() -> None:
    for protocol in ds.PROTOCOLS.values():
        advice = ds.plan(ds.Fleet.swarm(1, 2, 10), protocol).advice()
        assert advice.endswith("no other host receives its messages.")
        assert "single changes" not in advice
        assert "single changes" in ds.plan(ds.Fleet.swarm(2, 2, 10), protocol).advice()


def test_sizes_beyond_the_captures_and_full_exchanges_are_told() -> None:
    table = ds.PROTOCOLS["Fast DDS"]
    assert table.captured is not None
    hosts, processes, endpoints = table.captured
    within = ds.plan(ds.Fleet.swarm(hosts, 1, endpoints), table).advice()
    beyond = ds.plan(ds.Fleet.swarm(hosts, 1, endpoints + 1), table).advice()
    assert f"{processes} processes with up to {endpoints} endpoints" in " ".join(within.split())
    assert "extrapolated" not in " ".join(within.split())
    assert "This fleet is extrapolated" in " ".join(beyond.split())
    aggregated = ds.Radio("802.11ac", streams=2, width=80e6, mpdus=64).wifi()
    for size, verdict in ((2, "so it fits"), (6, "so it may fit"), (40, "so it does not fit")):
        assert verdict in ds.plan(ds.Fleet.swarm(size, 2, 10), table, aggregated).advice()
    assert "so it fits" in ds.plan(ds.Fleet.swarm(2, 1, 5), table).advice()


def test_peers_of_zenoh_are_pasted_what_is_counted_and_routers_are_not() -> None:
    plan = ds.plan(ds.Fleet((ds.HostGroup(12, 2, 30, shared=4),)), ds.PROTOCOLS["Fast DDS"])
    files = {
        r.protocol.name: {piece.file for piece in r.snippets}
        for r in (*plan.remedies, *plan.combinations)
        if "middleware" in r.steps
    }
    assert "zenoh_session.json5" in files["Zenoh peer, tokens"]
    routed = [found for name, found in files.items() if name.startswith("Zenoh router")]
    assert routed
    assert all("zenoh_session.json5" not in found for found in routed)


def test_fleets_without_radios_need_no_airtime(tmp_path: Path) -> None:
    wired = ds.Fleet((ds.HostGroup(3, 2, 10, wired=True),))
    plan = ds.plan(wired, ds.PROTOCOLS["Fast DDS"])
    assert plan.utilization == 0
    assert plan.reboot is None
    assert plan.advice() == "All hosts are wired; discovery needs no airtime."
    assert plan.numbered_remedies() == ()
    file = tmp_path / "wired.toml"
    for hosts in (1, 4):
        file.write_text(
            f"[[groups]]\nhosts = {hosts}\nprocesses = 2\nendpoints = 10\nwired = true\n"
        )
        done = CliRunner().invoke(main, ["plan", str(file)])
        assert done.output == "All hosts are wired; discovery needs no airtime.\n"
        done = CliRunner().invoke(main, ["plan", str(file), "--protocol", "all", "--csv"])
        assert done.exit_code == 0, done.output
        done = CliRunner().invoke(main, ["plan", str(file), "--protocol", "all"])
        assert done.exit_code == 0, done.output
        assert "nothing" in done.output


def test_too_many_groups_are_refused_in_one_sentence() -> None:
    groups = tuple(ds.HostGroup(1, 1, endpoints) for endpoints in range(1001))
    with pytest.raises(ValueError, match=r"a plan takes at most 1,000 groups; got 1,001\. Put"):
        ds.plan(ds.Fleet(groups))


@pytest.mark.parametrize("width", [math.nan, math.inf, 0, -1, 70.5])
def test_a_width_that_is_none_is_refused(width: Any) -> None:
    with pytest.raises(ValueError, match="width must be a whole number of at least 1"):
        PLAN_OF_FIG3.advice(width)


def test_a_reboot_takes_all_pairs_of_its_robot_times_what_was_measured() -> None:
    fast_dds = ds.PROTOCOLS["Fast DDS"]
    # 3 robots of 8 processes: 24 * 16 ordered pairs, of which a robot has 8 * 16 each way.
    found = reboot(Setting(FIG3, fast_dds, ds.PAPER))
    assert found is not None
    assert found.share == pytest.approx(2 * 8 * 16 / (24 * 16))
    burst = burst_of(fast_dds, FIG3)
    # data/measured/restarts.csv: the least and the most of restarts and joins of Fast DDS.
    assert found.low == pytest.approx(burst * found.share * 1.21)
    assert found.high == pytest.approx(burst * found.share * 1.71)
    assert reboot(Setting(FIG3, ds.DDS, ds.PAPER)) is None
    assert reboot(Setting(ds.Fleet.swarm(1, 2, 10), fast_dds, ds.PAPER)) is None


#: What each kind of change asks of a user: a setting, a file, other hardware, nodes built anew.
EFFORTS = {
    "aggregation": ("radio",),
    "discovery server": ("server",),
    "discovery server on a robot": ("server",),
    "endpoints": ("build",),
    "hybrid": ("research",),
    "middleware": ("switch",),
    "multicast endpoint data": ("file",),
    "multicast rate": ("setting",),
    "peers": ("file",),
    "processes": ("build",),
    "radio": ("radio",),
    "staggered start": ("setting",),
    "static endpoints": ("build",),
    "two discovery servers": ("servers",),
}


def test_each_change_has_its_effort() -> None:
    plan = ds.plan(ds.Fleet.swarm(3, 8, 20))
    assert {r.kind: r.efforts for r in plan.remedies if len(r.steps) == 1} == EFFORTS
