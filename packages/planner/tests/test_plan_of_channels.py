"""Plans of other radios, and of channels without a radio."""

from dataclasses import replace
from pathlib import Path

import pytest
from click.testing import CliRunner
from planner_by_hand import CHANNEL_KINDS, FIG3, MITIGATION_ROWS, NAV2, RADIO, approx, remedy

import discostorm as ds
from discostorm.cli import main
from discostorm.messages import PROCESS
from discostorm_planner.aggregation_range import AggregationRange
from discostorm_planner.radio_changes import FASTER_MULTICAST_RATE, MAX_MPDUS

pytestmark = pytest.mark.usefixtures("few_runs")


def test_on_a_preset_the_channel_changes_in_all_that_its_standard_says() -> None:
    assert (FASTER_MULTICAST_RATE, MAX_MPDUS) == (24e6, 64)
    plan = ds.plan(NAV2, ds.DDS, RADIO)
    expected = {
        "multicast rate": ds.Radio(
            "802.11n", streams=2, multicast_rate=FASTER_MULTICAST_RATE
        ).wifi(),
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
        assert "timing of the 802.11 standard" not in found.sentence()
    assert [reason.split(":")[0] for reason in plan.not_applicable] == [
        "composing",
        "a longer announcement interval",
        "another ROS release",
        "aggregation",
        "a central router",
        "a router on each host",
        "a router on each host plus a wired router",
    ]
    assert "a router on each host: for Zenoh only" in plan.not_applicable


def test_another_radio_keeps_what_was_chosen_beside_it() -> None:
    base = ds.Radio("802.11n", streams=2, multicast_rate=12e6, aifsn=3, mpdus=16).wifi()
    radios = [found for found in ds.plan(NAV2, ds.DDS, base).remedies if found.kind == "radio"]
    assert len(radios) == 3
    for found in radios:
        radio = found.wifi.radio
        assert radio is not None
        # The plan's channel has single frames; the range reaches the chosen number of MPDUs.
        assert (radio.multicast_rate, radio.aifsn, radio.mpdus) == (12e6, 3, 1)
        full = replace(radio, mpdus=16).wifi()
        assert found.range_after is not None
        assert found.range_after.full == ds.utilization(ds.DDS, NAV2, wifi=full)
    # Plans leave out radios that are not faster.
    wide = ds.plan(FIG3, wifi=ds.Radio("802.11ac", width=40e6, streams=2).wifi())
    named = {found.wifi.name for found in wide.remedies if found.kind == "radio"}
    assert named == {"802.11ac 80 MHz 2x2", "802.11ax 160 MHz 2x2"}
    # 1 Mbit/s exists only in the 2.4 GHz band.
    slow = ds.Radio("802.11n", band=2.4e9, multicast_rate=1e6).wifi()
    assert {f.kind for f in ds.plan(NAV2, ds.DDS, slow).remedies} >= {"radio", "multicast rate"}


def test_a_channel_changed_by_hand_is_compared_with_no_radio() -> None:
    preset = ds.WIFI["802.11n 20 MHz 2x2"]
    changed = (
        replace(preset, unicast=replace(preset.unicast, overhead=1e-4)),
        replace(ds.PAPER, multicast=ds.Link(24e6, 120e-6)),
    )
    for wifi in changed:
        plan = ds.plan(NAV2, ds.DDS, wifi)
        assert not CHANNEL_KINDS & {found.kind for found in plan.remedies}
        assert any(
            "changed by hand and no longer matches its Radio" in r for r in plan.not_applicable
        )
    own = ds.plan(NAV2, ds.DDS, ds.Wifi("own", ds.PAPER.unicast, ds.PAPER.multicast))
    assert not CHANNEL_KINDS & {found.kind for found in own.remedies}
    (why,) = (reason for reason in own.not_applicable if reason.startswith("another radio"))
    assert "has rates and overheads but no Radio" in why
    # Another name does not change the plan.
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
                alike = CHANNEL_KINDS - {"aggregation"}  # the preset already aggregates
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


FASTEST = ds.Radio("802.11ax", width=160e6, streams=2, multicast_rate=24e6, mpdus=64).wifi()


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
    assert kinds - {row["kind"] for row in MITIGATION_ROWS} == usual | {"staggered start", "hybrid"}
    # Possibly no change helps.
    own = ds.Protocol("own", (replace(ds.ZENOH.messages[0], name="Hi"),))
    advice = ds.plan(ds.Fleet.swarm(2, 1, 5), own, FASTEST).why()
    assert "Changes" not in advice
    assert "What would" not in advice


def test_a_channel_that_is_just_full_does_not_fit() -> None:
    # A frame of 1024 bits at 2048 bit/s on uplink and downlink takes exactly one second.
    payload = ds.Payload(64, 64, 64, "made up")
    message = ds.Message("m", "p", "multicast", "UDP", payload, PROCESS, 1)
    wifi = ds.Wifi("made up", ds.Link(2048, 0), ds.Link(2048, 0))
    plan = ds.plan(ds.Fleet.swarm(1, 1, 0), ds.Protocol("own", (message,)), wifi)
    assert plan.utilization == 1
    assert plan.to_dict(simulate=False)["fits"] is False
    assert "Utilization in the first second: 100%, so discovery does not fit." in plan.why()
    small = ds.plan(FIG3)
    composed = remedy(small, "processes")
    assert composed.utilization < 1
    fits = [found.utilization < 1 for found in (*small.remedies, *small.combinations)]
    assert {True, False} == set(fits)
    assert small.to_frame()["fits"].tolist() == fits
    just_full, twice = (AggregationRange(value, value) for value in (1.0, 2.0))
    found = (replace(composed, range_after=just_full),)
    full = replace(plan, fleet=FIG3, utilization_range=twice, remedies=found, combinations=())
    assert full.to_frame()["fits"].tolist() == [False]
    assert full.to_dict(simulate=False)["remedies"][0]["fits"] is False
    assert "fleet then" not in full.remedies[0].sentence()
    assert "fleet then fits" in composed.sentence()


def test_fleets_without_radios_need_no_airtime(tmp_path: Path) -> None:
    wired = ds.Fleet((ds.HostGroup(3, 2, 10, wired=True),))
    plan = ds.plan(wired, ds.PROTOCOLS["Fast DDS"])
    assert plan.utilization == 0
    assert plan.reboot is None
    assert plan.why() == plan.advice() == "All hosts are wired; discovery needs no airtime."
    assert plan.sections() == {}
    file = tmp_path / "wired.toml"
    for hosts, printed in ((1, ("--csv",)), (4, ())):
        file.write_text(
            f"[[groups]]\nhosts = {hosts}\nprocesses = 2\nendpoints = 10\nwired = true\n"
        )
        done = CliRunner().invoke(main, ["plan", str(file)])
        assert done.output == "All hosts are wired; discovery needs no airtime.\n"
        done = CliRunner().invoke(main, ["plan", str(file), "--protocol", "all", *printed])
        assert done.exit_code == 0, done.output
        assert printed or done.output == "All hosts are wired; discovery needs no airtime.\n"


def test_periodic_traffic_that_full_exchanges_carry_leaves_a_window_to_start_in() -> None:
    fleet, table = ds.Fleet.swarm(22, 4, 10), ds.PROTOCOLS["Fast DDS"]
    plan = ds.plan(fleet, table, RADIO)
    assert plan.steady_range.full < 1 < plan.steady_range.single
    assert remedy(plan, "staggered start").steps == ("staggered start",)
    full = ds.plan(replace(fleet, groups=(ds.HostGroup(60, 4, 10),)), table, RADIO)
    assert full.steady_range.full > 1
    assert "staggered start" not in {found.kind for found in full.remedies}
