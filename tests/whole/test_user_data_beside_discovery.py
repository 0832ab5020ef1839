"""Test user data beside discovery: the lab's captures, plans, commands and simulations."""

import json
from typing import Any

import lab_data
import numpy as np
import pytest
from click.testing import CliRunner
from user_data_by_hand import CYCLONE, FAST, FILE, HEADERS, ZENOH, fleet, read, sample

import discostorm as ds
from discostorm.cli import main
from discostorm.flows import Flow, flow
from discostorm.messages import user_data_protocol
from discostorm.messages.user_data import acknowledgement_frames, frames, framing
from discostorm.model import burst
from discostorm.wifi.radio import aggregation_bounds
from discostorm_simulation.result import CAUSES

# ---------------------------------------------------------------- what the lab saw


def on_the_wire(use: str) -> dict[tuple[str, int, bool], dict[str, tuple[float, float]]]:
    """Return packets and bytes of a sample by direction, as captured for one of two uses."""
    names = {"fast_dds": FAST, "cyclone_dds": CYCLONE, "zenoh_peer": ZENOH}
    found: dict[tuple[str, int, bool], dict[str, tuple[float, float]]] = {}
    for row in lab_data.read_lab_table("user_data.csv"):
        if row["use"] != use:
            continue
        key = (names[row["product"]], int(row["bytes"]), row["reliability"] == "reliable")
        samples = int(row["samples"])
        each = (int(row["packets"]) / samples, int(row["ip_bytes"]) / samples)
        found.setdefault(key, {})[row["direction"]] = each
    return found


def test_the_lab_ran_each_product_with_each_size() -> None:
    """All sizes and rates of those that test the framing differ from those it is partly from."""
    assert len(on_the_wire("fit")) == 3 * 4 * 2
    assert len(on_the_wire("test")) == 3 * 5 * 2
    rows = lab_data.read_lab_table("user_data.csv")
    sizes, rates = ({(r["use"], r[name]) for r in rows} for name in ("bytes", "hz"))
    for found in (sizes, rates):
        fit, test = ({value for use, value in found if use == which} for which in ("fit", "test"))
        assert not fit & test
        assert len(test) == 5


@pytest.mark.parametrize(
    ("point", "seen"), [*on_the_wire("fit").items(), *on_the_wire("test").items()], ids=str
)
def test_bytes_of_a_sample_are_those_of_captures(
    point: tuple[str, int, bool], seen: dict[str, tuple[float, float]]
) -> None:
    product, octets, reliable = point
    own = sample(octets, reliable)
    counted = frames(own, framing(product))
    packets, ip_bytes = seen["to reader"]
    # IP's header of 20 is in the captures. Within 5%; a Heartbeat may go in a datagram of its own.
    assert sum((20 + size) * n for size, n in counted.items()) == pytest.approx(ip_bytes, rel=0.05)
    if (product, octets, reliable) != (FAST, 300, True):  # it put two samples into some datagrams
        assert sum(counted.values()) == pytest.approx(packets, rel=0.05)


def test_bytes_of_both_directions_are_those_of_captures_that_nothing_is_taken_from() -> None:
    """Within 5%, but where Cyclone DDS answers fewer short samples than at 10 Hz."""
    off = {}
    for (product, octets, reliable), seen in on_the_wire("test").items():
        own = sample(octets, reliable)
        many, size = acknowledgement_frames(own, framing(product))
        expected = sum((20 + n) * count for n, count in frames(own, framing(product)).items())
        expected += many * (20 + size)
        error = expected / sum(octets_ for _, octets_ in seen.values()) - 1
        if abs(error) > 0.05:
            off[product, octets, reliable] = round(error, 2)
    assert off == {(CYCLONE, 300, True): 0.21, (CYCLONE, 1100, True): 0.07}
    for octets in (300, 1100, 3_000, 20_000):
        assert on_the_wire("test")[CYCLONE, octets, True]["to writer"][0] < 0.1


def test_answers_of_dds_are_those_of_captures() -> None:
    for (product, octets, reliable), seen in on_the_wire("fit").items():
        if product == ZENOH:  # TCP's depend on how fast segments come
            continue
        many, size = acknowledgement_frames(sample(octets, reliable), framing(product))
        packets, ip_bytes = seen.get("to writer", (0, 0))
        # Fast DDS answers more often than each tenth sample if these are several frames long.
        assert packets == pytest.approx(many, abs=0.2001)
        assert ip_bytes == pytest.approx((20 + size) * packets, rel=0.05)


# ---------------------------------------------------------------- planner and commands

FILE_WITH_DATA = """
[[groups.data]]
topic = "scan"
to = "wired host"

[[groups.data]]
topic = "tf"
to = "all others"
rate = {rate}
"""


@pytest.mark.parametrize("channel", ["paper", "802.11ac 80 MHz 2x2"])
def test_a_plan_tells_data_discovery_and_their_sum(channel: str) -> None:
    wifi = ds.PAPER if channel == "paper" else ds.WIFI[channel]
    own, protocol = read(FILE_WITH_DATA.format(rate=50)), ds.PROTOCOLS["Fast DDS"]
    plan, alone = (ds.plan(one, protocol, wifi) for one in (own, own.without_data()))
    assert plan.data is not None
    assert alone.data is None
    assert "data" not in alone.to_dict()
    assert plan.utilization == alone.utilization
    for name, end in zip(("full", "single"), aggregation_bounds(wifi), strict=True):
        data = ds.utilization(protocol, own, wifi=end, phase="data")
        assert getattr(plan.data.data, name) == data
        steady = ds.utilization(protocol, own, wifi=end, window=float("inf"))
        assert getattr(plan.data.with_periodic, name) == pytest.approx(data + steady, rel=1e-12)
        whole = ds.utilization(protocol, own, wifi=end)
        assert getattr(plan.data.with_discovery, name) == pytest.approx(data + whole, rel=1e-12)
        drain = burst(protocol, own, wifi=end) / (1 - steady - data)
        assert getattr(plan.data.drain_time_with_data, name) == pytest.approx(drain, rel=1e-12)
    assert plan.data.drain_time_alone == alone.startup
    told = plan.to_dict()["data"]
    assert told["fits_after_startup"] == "fits"
    assert told["startup"]["one_frame"] > told["startup_without"]["one_frame"]
    json.loads(plan.to_json())


def test_a_plan_says_in_words_whether_data_fit() -> None:
    protocol = ds.PROTOCOLS["Fast DDS"]
    said = " ".join(ds.plan(read(FILE_WITH_DATA.format(rate=50)), protocol).why().split())
    assert "So your data fits once discovery is complete." in said
    assert "If robots sent all data from the beginning, startup would keep the channel busy" in said
    said = " ".join(ds.plan(read(FILE_WITH_DATA.format(rate=2000)), protocol).why().split())
    assert "So your data does not fit once discovery is complete." in said
    assert "The channel can never carry discovery and all your data." in said
    never = ds.plan(read(FILE_WITH_DATA.format(rate=2000)), protocol).to_dict()["data"]
    assert never["startup"]["one_frame"] is None
    steady = ds.plan(read(FILE_WITH_DATA.format(rate=50)), protocol, window=float("inf"))
    assert "During startup" not in steady.why()


def run(*arguments: str, text: str) -> str:
    found = CliRunner().invoke(main, arguments, input=text)
    assert found.exit_code == 0, found.output
    return found.stdout


def test_commands_have_columns_for_data_where_there_are_some() -> None:
    text = FILE + FILE_WITH_DATA.format(rate=50)
    rows = json.loads(run("utilization", "-", "--protocol", "all", "--json", text=text))
    assert len(rows) > 5
    for row in rows:
        data = ds.utilization(ds.PROTOCOLS[row["protocol"]], read(text[len(FILE) :]), phase="data")
        assert row["data_utilization"] == pytest.approx(data)
        assert row["total_utilization"] == pytest.approx(data + row["utilization"])
    assert "both" in run("utilization", "-", text=text)
    (row,) = json.loads(run("utilization", "-", "--json", text=FILE))
    assert "data_utilization" not in row
    assert "our data need" in run("plan", "-", "--why", text=text)
    assert "our data need" not in run("plan", "-", "--why", text=FILE)
    assert json.loads(run("plan", "-", "--json", text=text))["data"]["fits_after_startup"] == "fits"


def test_a_wrong_topic_ends_a_command_with_2() -> None:
    text = FILE + '[[groups.data]]\ntopic = "scan"\n'
    found = CliRunner().invoke(main, ["plan", "-"], input=text)
    assert found.exit_code == 2
    assert "group 1 (robots): data 1 (scan): to is missing" in found.stderr


# ---------------------------------------------------------------- the simulator

RUNS: dict[str, Any] = {"runs": 3, "until": 20.0}


def test_data_on_an_empty_channel_arrive_at_once() -> None:
    """A robot's samples take as long as its frames and the wait for the channel, up and down."""
    small = ds.HostGroup(2, 1, 1, "robots", data=(sample(1000, to="all others"),))
    found = ds.simulate(ds.Fleet((small,)), ds.PROTOCOLS[CYCLONE], ds.PAPER, **RUNS)
    (own,) = found.data.values()
    assert found.protocol.messages[-1].phase == "data"
    (message,) = [m for m in found.protocol.messages if m.phase == "data"]
    least = 2 * 8 * message.frame_bytes / ds.PAPER.unicast.rate
    assert (own["arrived"] <= own["frames"]).all()
    seen = own["delay_median_s"][own["arrived"] > 0]
    assert ((seen > least) & (seen < 0.01)).all()


@pytest.mark.parametrize("name", ["Fast DDS", "Cyclone DDS", "Zenoh peer"])
def test_data_are_sent_beside_discovery_and_counted_by_topic(name: str) -> None:
    protocol = ds.PROTOCOLS[name]
    own = ds.Fleet(
        (
            ds.HostGroup(
                4, 2, 20, "robots", data=(flow("scan", "wired host"), sample(9_000, True))
            ),
            ds.HostGroup(1, 1, 20, "desk", data=(sample(50, to="one host"),)),
        )
    )
    beside, alone = (ds.simulate(f, protocol, ds.PAPER, **RUNS) for f in (own, own.without_data()))
    assert set(beside.data) == {"scan of robots", "own of robots", "own of desk"}
    assert not alone.data
    assert alone.protocol == protocol
    for topic in beside.data.values():
        assert topic["frames"].sum() > 0
        assert (topic["arrived"] <= topic["frames"]).all()
        seen = topic["arrived"] > 0
        late = [topic[f"delay_{which}_s"] for which in ("median", "95", "most")]
        assert (late[0] <= late[1])[seen].all()
        assert (late[1] <= late[2])[seen].all()
        assert (np.isfinite(late[2]) == seen).all()
    # Each of four robots sends its scans, two frames each, from its start to the end.
    scans = beside.data["scan of robots"]["frames"]
    spent = np.maximum(beside.convergence_time, beside.drain_time)
    spent = np.where(np.isfinite(spent), spent, RUNS["until"])
    assert scans == pytest.approx(4 * 5 * 2 * spent, abs=4 * 2 + 1)
    again = ds.simulate(own, protocol, ds.PAPER, **RUNS)
    assert again == beside
    json.loads(beside.to_json())
    assert beside.airtime.shape[1] == len(beside.protocol.messages) + 1


@pytest.mark.parametrize("name", ["Fast DDS", "Cyclone DDS", "Zenoh peer"])
def test_discovery_is_complete_later_beside_data_that_fill_the_channel(name: str) -> None:
    """Of data that leave room that is not sure: what is lost waits for timers of seconds."""
    heavy = Flow("camera", "wired host", rate=60, bytes=20_000, reliable=False)
    own = ds.Fleet((ds.HostGroup(4, 2, 20, "robots", data=(heavy,)),))
    assert ds.utilization(ds.PROTOCOLS[name], own, phase="data") > 0.8
    beside, alone = (
        ds.simulate(f, ds.PROTOCOLS[name], ds.PAPER, **RUNS | {"runs": 5})
        for f in (own, own.without_data())
    )
    assert np.median(beside.convergence_time) > np.median(alone.convergence_time)


def test_data_that_do_not_fit_are_late_and_lost() -> None:
    robots = ds.HostGroup(3, 1, 5, data=(Flow("own", "all others", 200, 20_000, False),))
    found = ds.simulate(ds.Fleet((robots,)), ds.PROTOCOLS[FAST], ds.PAPER, start=[0, 0, 5], **RUNS)
    (own,) = found.data.values()
    assert (own["arrived"] < 0.9 * own["frames"]).all()
    # Frames wait half a second at the host at most, and at the access point.
    assert (own["delay_95_s"] > 0.05).all()
    assert (own["delay_most_s"] < 1.2).all()


@pytest.mark.parametrize("name", ["DDS", "Fast DDS", "Zenoh peer", "Zenoh router"])
def test_without_recovery_data_are_sent_from_the_start_to_the_end(name: str) -> None:
    """Samples are counted, what becomes of their frames adds up, and a burst is sent once."""
    protocol = ds.PROTOCOLS[name]
    own = fleet(sample(9_000, True), Flow("scan", "wired host", 5, 1500, False), hosts=4)
    settings: dict[str, Any] = {"recovery": False, "runs": 3, "until": 6.0, "start": [0, 0, 1, 2]}
    found = ds.simulate(own, protocol, ds.PAPER, **settings)
    table = user_data_protocol(protocol, own)
    assert table is not None
    counts = dict.fromkeys(found.data, 0.0)
    for row in table.messages:
        if not row.name.endswith("answers"):
            counts[row.name.partition(",")[0]] += row.frames
    # The run ends this long after the last host's start.
    lasting = 8 + 8 + 7 + 6
    for topic, rate, receivers in (("own of robots", 10, 3), ("scan of robots", 5, 1)):
        seen = found.data[topic]
        expected = counts[topic] * rate * receivers * lasting
        assert seen["frames"] == pytest.approx(expected, abs=4 * counts[topic] * receivers)
        ended = seen["arrived"] + sum(seen[cause] for cause in CAUSES)
        assert (ended <= seen["frames"]).all()
        assert (ended >= seen["frames"] - 600).all()  # what is in queues at the end
    alone = ds.simulate(own.without_data(), protocol, ds.PAPER, **settings)
    if name in ("DDS", "Zenoh"):  # nothing of the table comes again
        assert (found.counts["expected"] == alone.counts["expected"]).all()
    assert np.median(found.drain_time) > np.median(alone.drain_time)
    assert ds.simulate(own, protocol, ds.PAPER, **settings) == found


def test_without_recovery_samples_are_answered_as_they_are_counted() -> None:
    """Reliable samples of Cyclone DDS, and those of Zenoh over TCP: on the air as by the sum."""
    wifi = ds.Radio("802.11n", streams=2).wifi()
    for name, own in (("Cyclone DDS", sample(100, True)), ("Zenoh peer", sample(5_000))):
        protocol = ds.PROTOCOLS[name]
        small = ds.Fleet((ds.HostGroup(2, 1, 1, "robots", data=(own,)),))
        found = ds.simulate(small, protocol, wifi, recovery=False, runs=2, until=20.0, queue=None)
        rows = [m.name for m in found.protocol.messages]
        sums = found.airtime[:, :-1, :2].mean(axis=0).sum(axis=1) / 20
        share = dict(zip(rows, sums, strict=True))
        assert sum(share[n] for n in rows if n.endswith(", answers")) > 0
        mine = sum(share[n] for n in rows if " of robots, " in n)
        table = user_data_protocol(protocol, small)
        assert table is not None
        radio = wifi.radio
        assert radio is not None
        waits = (radio.aifs + radio.cw_min / 2 * radio.slot) * sum(
            m.load(small) * m.frames * len(m.hops) / m.schedule.period for m in table.messages
        )
        counted = ds.utilization(protocol, small, wifi=wifi, phase="data") - float(waits)
        assert mine == pytest.approx(counted, rel=0.05)


def test_a_multicast_sample_goes_up_once_and_down_once() -> None:
    own = fleet(sample(100, to="multicast"), hosts=5)
    up, down = ds.PAPER.unicast, ds.PAPER.multicast
    (size,) = frames(sample(100), framing(FAST))
    bits = 8 * (HEADERS + size)
    each = bits / up.rate + up.overhead + bits / down.rate + down.overhead
    assert ds.utilization(ds.DDS, own, phase="data") == pytest.approx(5 * 10 * each, rel=1e-12)
    for recovery in (True, False):
        # Discovery ends the run.
        found = ds.simulate(own, ds.DDS, ds.PAPER, recovery=recovery, runs=3, until=5.0)
        ((name, seen),) = found.data.items()
        assert name == "own of robots"
        assert (seen["frames"] % 4 == 0).all()
        assert (seen["frames"] - seen["arrived"] <= seen["frames"] / 4).all()
        if not recovery:
            assert (seen["frames"] == 5 * 50 * 4).all()
            assert (seen["arrived"] + sum(seen[cause] for cause in CAUSES) <= 1000).all()
            assert seen["on_air"].sum() > 0


def test_a_multicast_sample_is_a_copy_for_each_over_tcp_and_is_not_acknowledged() -> None:
    for name in ("Zenoh", "Zenoh peer"):
        multicast, each = (
            ds.utilization(ds.PROTOCOLS[name], fleet(sample(100, to=to)), phase="data")
            for to in ("multicast", "all others")
        )
        assert multicast == each
    with pytest.raises(ValueError, match="reliable must be false with multicast"):
        sample(100, True, "multicast")


def test_commands_simulate_data_without_recovery() -> None:
    text = FILE + FILE_WITH_DATA.format(rate=10)
    for options in (("--no-recovery",), ("--protocol", "Fast DDS Discovery Server, on a robot")):
        said = " ".join(
            run("simulate", "-", "--runs", "2", "--until", "3", *options, text=text).split()
        )
        assert "with your data, and ends after" in said
        assert "Data until the end of the run (medians of all runs):" in said


def test_simulate_tells_both_and_how_late_data_are() -> None:
    text = FILE + FILE_WITH_DATA.format(rate=10)
    said = run("simulate", "-", "--runs", "2", "--until", "10", text=text)
    assert "without data" in said
    assert "scan of robots" in said
    assert "median delay" in said
    told = json.loads(run("simulate", "-", "--runs", "1", "--until", "10", "--json", text=text))
    assert told["data"].keys() == {"scan of robots", "tf of robots"}
    assert len(told["without_data"]["convergence_time"]) == 1
    assert "data" not in told["without_data"]
