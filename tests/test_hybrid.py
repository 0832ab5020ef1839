"""The hybrid discovery: its goals against stored runs, its table against the rounds."""

import sys
import zlib
from pathlib import Path

import numpy as np
import pytest

import discostorm as ds
from discostorm.data import read_data
from discostorm.messages import PROCESS
from discostorm.simulation.channel import Channel, Frame, timing_of
from discostorm.simulation.hybrid import Speakers, hybrid_run, parameters

SCRIPTS = Path(__file__).parents[1] / "scripts"
HYBRID, ALIKE = ds.PROTOCOLS["hybrid"], ds.PROTOCOLS["hybrid, alike"]
STORED = read_data("simulated/hybrid.csv")
#: Goals of the proposal that stored runs miss, each with what they show; see the chapter.
MISSED = {
    ("no second of that is fuller, in any run", "unlike"),
}


def found(goal: dict[str, str]) -> float:
    """Return what the given share of the runs stays within."""
    values = np.sort(
        [
            float(row[goal["column"]]) - float(goal["since_s"])
            for row in STORED
            if row["scenario"] == goal["scenario"]
            or (goal["scenario"] == "50 die" and row["scenario"].startswith("50 die"))
        ]
    )
    return float(values[int(np.ceil(float(goal["share_of_runs"]) * values.size)) - 1])


@pytest.mark.parametrize("goal", read_data("hybrid/goals.csv"), ids=lambda goal: goal["goal"])
def test_goals_are_met_in_the_stored_runs(goal):
    if (goal["goal"], goal["scenario"]) in MISSED:
        assert found(goal) > float(goal["most"]), "met by now: no longer among the missed"
    else:
        assert found(goal) <= float(goal["most"])


def test_stored_runs_have_seeds_that_were_not_used_to_tune():
    seeds = {}
    for row in STORED:
        seeds.setdefault(row["scenario"], []).append(int(row["seed"]))
    for scenario, used in seeds.items():
        assert used == list(range(100, 100 + len(used))), scenario
    # What takes long to simulate was simulated less often; the chapter says how often.
    assert len(seeds["alike"]) == len(seeds["unlike"]) == len(seeds["newcomer"]) == 100
    assert sum(len(used) for name, used in seeds.items() if name.startswith("50 die")) > 300


@pytest.mark.parametrize(
    "scenario", ["alike", "unlike", "newcomer", "halves", "50 die at 1.0 s, speaks_most"]
)
def test_stored_runs_come_out_again(scenario, monkeypatch):
    monkeypatch.syspath_prepend(str(SCRIPTS))
    import simulate_hybrid

    assert Path(sys.modules["simulate_hybrid"].__file__).parent == SCRIPTS
    stored = {
        (row["scenario"], row["seed"]): {key: str(value) for key, value in row.items()}
        for row in STORED
    }
    for seed in (100, 120):
        again = {key: str(value) for key, value in simulate_hybrid.row(scenario, seed).items()}
        assert again == stored[scenario, str(seed)]


def test_airtime_without_losses_is_what_was_promised():
    # Of the swarm of Fig. 2, in its first second, with what heartbeats take of it.
    assert ds.utilization(HYBRID, 7, 2, 10) <= 0.010
    assert ds.utilization(HYBRID, 100, 2, 10) <= 0.13


@pytest.mark.parametrize(("table", "alike"), [(HYBRID, False), (ALIKE, True)])
@pytest.mark.parametrize(("hosts", "more"), [(7, 2.0), (100, 1.1)])
def test_rounds_without_losses_send_what_the_table_says(table, alike, hosts, more):
    # Few hosts announce themselves so far apart that some show what they hold too early, and are
    # told what they would have heard anyway: the chapter says how much that costs.
    fleet = ds.Fleet.swarm(hosts, 2, 10)
    # The first heartbeats come 1.5 s after an announcement.
    window = 1.4
    phases = ("Sets", "Digests")
    said = sum(ds.utilization(table, hosts, 2, 10, phase=phase) for phase in phases)
    sent = []
    for seed in range(6):
        run = hybrid_run(fleet, ds.PAPER, alike=alike, loss=(0, 0), until=window, seed=seed)
        assert run.convergence_time < window
        sent.append(run.airtime)
    assert said * (1 - 1e-6) <= np.mean(sent) <= more * said


def test_load_counted_by_hand():
    # 3 hosts of 2 processes of 10 endpoints; rows without a frame of their own cost bytes alone.
    fleet = ds.Fleet.swarm(3, 2, 10)
    value = parameters()
    octets = 64 + value["header"] + 2 * value["process"] + 20 * value["endpoint"]
    one = 8 * octets / 144.4e6 + 180e-6 + 8 * octets / 6e6 + 120e-6
    table = ds.utilization(HYBRID, fleet, None, None, phase="Sets")
    assert table == pytest.approx(3 * one, rel=1e-6)


def test_frames_grow_with_hosts_alone():
    twice, once = (
        sum(
            float(row.load(ds.Fleet.swarm(hosts, 2, 10)))
            for row in HYBRID.messages
            if row.frames == 1 and row.unit.name == "host"
        )
        for hosts in (200, 100)
    )
    assert twice == 2 * once


def test_endpoints_are_as_short_as_the_table_says():
    # Names as ROS 2 writes them, entity id, kind and QoS, deflated together.
    types = [
        *("geometry_msgs/msg/Twist", "nav_msgs/msg/Odometry", "nav_msgs/msg/OccupancyGrid"),
        *("nav_msgs/msg/Path", "sensor_msgs/msg/LaserScan", "sensor_msgs/msg/Imu"),
        *("sensor_msgs/msg/Image", "tf2_msgs/msg/TFMessage", "std_msgs/msg/String"),
        *("rcl_interfaces/msg/Log", "diagnostic_msgs/msg/DiagnosticArray"),
        *("geometry_msgs/msg/PoseStamped", "sensor_msgs/msg/BatteryState"),
    ]
    topics = [
        *("cmd_vel", "odom", "map", "plan", "scan", "imu", "camera/image_raw", "tf"),
        *("tf_static", "rosout", "parameter_events", "diagnostics", "goal_pose"),
        *("battery_state", "joint_states", "local_costmap/costmap"),
    ]
    for seed in range(5):
        rng = np.random.default_rng(seed)
        told = b"".join(
            number.to_bytes(4, "big")
            + bytes([int(rng.choice([0, 1, 17]))])
            + f"robot_{seed:02}/{rng.choice(topics)}\0{rng.choice(types)}\0".encode()
            for number in range(20)
        )
        assert len(zlib.compress(told, 9)) / 20 <= parameters()["endpoint"]


def test_equations_are_resolved_like_by_gauss():
    # Random exclusive-ors of 40 unknown sets: held are those that any elimination finds.
    rng = np.random.default_rng(5)
    speakers = Speakers(64, np.zeros(64))
    masks = [int(rng.integers(1, 2**40)) << 1 for _ in range(25)] + [1 << place for place in (3, 7)]
    span: list[int] = []
    for mask in masks:
        speakers.learn(np.array([0]), 0, np.uint64(mask))
        value = mask & ~1
        for row in span:
            value = min(value, value ^ row)
        if value:
            span = sorted([*span, value], reverse=True)
        expected = {place for place in range(1, 64) if _reduced(span, 1 << place) == 0}
        held = int(speakers.held[0, 0])
        assert {place for place in range(1, 64) if held >> place & 1} == expected


def _reduced(span: list[int], value: int) -> int:
    for row in span:
        value = min(value, value ^ row)
    return value


def test_medium_agrees_with_the_frame_by_frame_engine():
    # 20 hosts that each have ten frames to the group at once: how long until all are through.
    hosts, frames = 20, 10
    message = ds.Message(
        "Frame", "All", "multicast", "UDP", ds.Payload(200, 200, 200, "test"), PROCESS, frames
    )
    other = ds.simulate(
        ds.Fleet.swarm(hosts, 1, 0),
        ds.Protocol("test", (message,)),
        ds.PAPER,
        queue=None,
        recovery=False,
        runs=20,
    )
    ends, collisions = [], []
    for seed in range(20):
        channel = Channel(
            timing_of(ds.PAPER), hosts, 0.0, (np.inf, np.inf), np.random.default_rng(seed)
        )
        for host in range(hosts):
            for _ in range(frames):
                channel.offer(host, Frame("Frame", host, 264, None), 0.0)
        while channel.next_time() < np.inf:
            channel.transmit()
        ends.append(channel.idle)
        collisions.append(channel.collisions)
    # Means of 20 runs scatter by 1 %; post-backoff, which only the engine has, adds as much.
    assert np.mean(ends) == pytest.approx(np.mean(other.drain_time), rel=0.03)
    assert np.mean(collisions) == pytest.approx(np.mean(other.counts["collisions"]), rel=0.1)


def test_same_seed_same_run():
    fleet = ds.Fleet.swarm(20, 2, 10)
    one, two = (hybrid_run(fleet, ds.PAPER, seed=3, until=4) for _ in range(2))
    assert one.convergence_time == two.convergence_time
    assert one.frames == two.frames
    assert one.airtime == two.airtime


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ({"loss": (1.2, 0)}, r"loss\[0\] must be"),
        ({"until": 0}, "until must be"),
        ({"wifi": ds.Wifi("own", ds.PAPER.unicast, ds.PAPER.multicast)}, "must have a radio"),
        ({"wifi": ds.Radio("802.11n", mpdus=8).wifi()}, "without aggregation"),
        ({"fleet": ds.Fleet.swarm(3, 1, 678)}, "at most 1400 B"),
    ],
)
def test_bad_input_is_refused(arguments, words):
    given = {"fleet": ds.Fleet.swarm(3, 1, 4), "wifi": ds.PAPER} | arguments
    with pytest.raises(ValueError, match=words):
        hybrid_run(given.pop("fleet"), given.pop("wifi"), **given)
