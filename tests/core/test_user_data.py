"""Test user data: frames counted by hand, fleet files, airtime, and the lab's captures."""

from dataclasses import replace
from math import ceil
from typing import Any

import numpy as np
import pytest
from user_data_by_hand import CYCLONE, FAST, HEADERS, ZENOH, fleet, read, sample

import discostorm as ds
from discostorm.data import read_data
from discostorm.flows import Flow, flow, topics
from discostorm.messages import user_data_protocol
from discostorm.messages.user_data import acknowledgement_frames, frames, framing

# ---------------------------------------------------------------- frames, counted by hand


def test_a_short_sample_is_one_datagram() -> None:
    """RTPS 20, INFO_TS 12, DATA 24, encapsulation 4 and 100 octets, after UDP's 8."""
    assert dict(frames(sample(100), framing(CYCLONE))) == {8 + 20 + 12 + 24 + 4 + 100: 1}
    # A HEARTBEAT of 32 with it, and an answer of 20, INFO_DST 16 and ACKNACK 28.
    assert dict(frames(sample(100, True), framing(CYCLONE))) == {168 + 32: 1}
    assert acknowledgement_frames(sample(100, True), framing(CYCLONE)) == (1, 8 + 20 + 16 + 28)
    assert acknowledgement_frames(sample(100), framing(CYCLONE))[0] == 0


def test_cyclone_dds_puts_ten_fragments_in_a_datagram_and_ip_splits_it() -> None:
    """100,004 octets are 7 datagrams of 13,440 and one of 5,924, each with 8 + 20 + 36."""
    found = frames(sample(100_000), framing(CYCLONE))
    sizes = [13_440 + 64] * 7 + [5_924 + 64]
    sizes[0] += 12  # INFO_TS
    assert sum(found.values()) == sum(ceil(size / 1480) for size in sizes) == 75
    assert sum(size * many for size, many in found.items()) == sum(sizes)
    assert found[1480] == 7 * 9 + 4


def test_fast_dds_fills_datagrams_of_64_kb() -> None:
    """100,004 octets are 65,356 and 34,648, each after UDP's 8, 108 and 36."""
    found = frames(sample(100_000), framing(FAST))
    sizes = [65_356 + 152, 34_648 + 152]
    assert sum(found.values()) == sum(ceil(size / 1480) for size in sizes) == 69
    assert sum(size * many for size, many in found.items()) == sum(sizes)


def test_zenoh_fills_segments() -> None:
    """2 of the length, 40, 5, 4 and 6,000 octets make 5 segments of at most 1448, with 32 each."""
    found = frames(sample(6_000), framing(ZENOH))
    assert dict(found) == {1480: 4, 6_051 - 4 * 1448 + 32: 1}
    assert acknowledgement_frames(sample(6_000), framing(ZENOH)) == (3, 32)


@pytest.mark.parametrize("product", [CYCLONE, FAST, ZENOH])
@pytest.mark.parametrize("octets", [0, 1, 1344, 1345, 1428, 65_000, 65_400, 1e6])
def test_nothing_of_a_sample_is_left_out_and_no_frame_is_too_long(
    product: str, octets: float
) -> None:
    found = frames(sample(octets), framing(product))
    assert max(found) <= 1480
    assert min(found) > 0
    assert min(found.values()) > 0
    assert sum(size * many for size, many in found.items()) >= octets + 4
    more = frames(sample(octets + 1), framing(product))
    assert sum(more.values()) >= sum(found.values())


# ---------------------------------------------------------------- airtime


def by_hand(flow: Flow, product: str, ups: float, downs: float) -> float:
    """Return the airtime of a topic on the paper's channel in a second, frame by frame."""
    link = ds.PAPER.unicast
    total = 0.0
    many, size = acknowledgement_frames(flow, framing(product))
    own = [(many, size, downs, ups)] if many else []
    own += [(n, length, ups, downs) for length, n in frames(flow, framing(product)).items()]
    for number, data, up, down in own:
        total += number * (up + down) * (8 * (HEADERS + data) / link.rate + link.overhead)
    return flow.rate * total


@pytest.mark.parametrize("name", ["Cyclone DDS", "Fast DDS", "Zenoh peer", "DDS", "Zenoh"])
@pytest.mark.parametrize("octets", [100, 6_000, 100_000])
@pytest.mark.parametrize("reliable", [False, True])
def test_airtime_is_that_of_each_frame_on_each_hop(
    name: str, octets: float, reliable: bool
) -> None:
    protocol = ds.PROTOCOLS[name]
    product = protocol.product or {"DDS": FAST, "Zenoh": ZENOH}[name]
    for to, ups, downs in (("all others", 6, 6), ("one host", 3, 3), ("wired host", 3, 0)):
        own = sample(octets, reliable, to)
        found = ds.utilization(protocol, fleet(own), phase="data")
        assert found == pytest.approx(by_hand(own, product, ups, downs), rel=1e-12)


def test_wired_hosts_take_the_air_on_one_hop() -> None:
    desk = ds.HostGroup(1, 1, 5, "desk", wired=True, data=(sample(100),))
    group = ds.HostGroup(3, 2, 10, "robots", data=(sample(100),))
    taken = ds.utilization(ds.PROTOCOLS[CYCLONE], ds.Fleet((group, desk)), phase="data")
    # Three robots send to two others and the desk; the desk to three robots.
    expected = by_hand(sample(100), CYCLONE, 9, 6) + by_hand(sample(100), CYCLONE, 0, 3)
    assert taken == pytest.approx(expected, rel=1e-12)
    to_wire = ds.HostGroup(1, 1, 5, "desk", wired=True, data=(sample(100, to="wired host"),))
    only = ds.Fleet((ds.HostGroup(3, 2, 10), to_wire))
    assert ds.utilization(ds.DDS, only, phase="data") == 0


def test_discovery_is_counted_alone_and_no_data_take_nothing() -> None:
    own = sample(100)
    for name in ("DDS", "Fast DDS", "Zenoh peer"):
        protocol = ds.PROTOCOLS[name]
        assert ds.utilization(protocol, fleet(own)) == ds.utilization(protocol, fleet())
        assert ds.utilization(protocol, fleet(), phase="data") == 0
        assert ds.utilization(protocol, fleet(own, hosts=1), phase="data") == 0
    none = ds.utilization(ds.DDS, [3, 4], 2, 10, phase="data")
    assert none.tolist() == [0.0, 0.0]
    assert none.dtype == np.float64


def test_data_are_the_same_in_every_window() -> None:
    own = [ds.utilization(ds.DDS, fleet(sample(100)), phase="data", window=w) for w in (1, 20)]
    assert own[0] == pytest.approx(own[1], rel=1e-12)
    endless = ds.utilization(ds.DDS, fleet(sample(100)), phase="data", window=float("inf"))
    assert endless == pytest.approx(own[0], rel=1e-12)


def test_topics_of_several_groups_are_rows_of_their_own() -> None:
    desk = ds.HostGroup(1, 1, 5, "desk", data=(flow("scan", "all others"),))
    table = user_data_protocol(ds.DDS, fleet(flow("scan", "one host"), desk=desk))
    assert table is not None
    names = [message.name for message in table.messages]
    assert names == [
        "scan of robots, full frames",
        "scan of robots, last frames",
        "scan of desk, full frames",
        "scan of desk, last frames",
    ]


def test_an_unknown_product_sends_data_as_its_family_does() -> None:
    own = replace(ds.PROTOCOLS["Zenoh peer"], product="another")
    found = [ds.utilization(p, fleet(sample(9)), phase="data") for p in (own, ds.ZENOH)]
    assert found[0] == found[1]


@pytest.mark.parametrize("name", ["Fast DDS", "Cyclone DDS", "Zenoh peer"])
def test_the_longest_sample_can_be_counted(name: str) -> None:
    own = fleet(Flow("own", "all others", rate=1e6, bytes=1e8, reliable=True))
    assert np.isfinite(ds.utilization(ds.PROTOCOLS[name], own, phase="data"))
    seldom = fleet(Flow("own", "all others", rate=1e-6, bytes=0, reliable=True))
    assert 0 < ds.utilization(ds.PROTOCOLS[name], seldom, phase="data") < 1e-6


def test_a_protocol_of_no_family_leaves_data_to_dds() -> None:
    found = [
        ds.utilization(ds.PROTOCOLS[n], fleet(sample(9)), phase="data") for n in ("hybrid", "DDS")
    ]
    assert found[0] == found[1]


# ---------------------------------------------------------------- fleets and their files


def test_a_fleet_file_lists_topics() -> None:
    found = read(
        """
[[groups.data]]
topic = "scan"
to = "wired host"

[[groups.data]]
topic = "arm"
to = "all others"
rate = 100
bytes = 64
reliable = true
"""
    )
    assert found.groups[0].data == (
        Flow("scan", "wired host", 5, 1500, False),
        Flow("arm", "all others", 100, 64, True),
    )
    assert found.has_data
    assert not read("").has_data
    told = found.to_dicts()[0]["data"][0]
    assert told == {
        "topic": "scan",
        "to": "wired host",
        "rate": 5.0,
        "bytes": 1500.0,
        "reliable": False,
    }
    assert repr(found.groups[0]).endswith("data=<scan, arm>)")
    group = replace(found.groups[0], data=())
    assert eval(repr(group), {"HostGroup": ds.HostGroup}) == group


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ('topic = "scan"', "data 1 (scan): to is missing; it must be 'one host' or 'wired host'"),
        ('to = "one host"', "data 1: topic is missing; it must be a text"),
        (
            'topic = "scan"\nto = "all"',
            "'wired host' or 'all others' or 'multicast'",
        ),
        ('topic = "scam"\nto = "one host"', "rate is missing; only these topics may omit it: scan"),
        ('topic = "scam"\nto = "one host"', "Did you mean 'scan'?"),
        ('topic = "scan"\nto = "one host"\nhz = 5', "unknown key hz = 5"),
        ('topic = "scan"\nto = "one host"\nrate = 0', "rate must be a finite number of at least"),
        ('topic = "scan"\nto = "one host"\nrate = true', "rate must be"),
        ('topic = "scan"\nto = "one host"\nbytes = -1', "bytes must be"),
        ('topic = "scan"\nto = "one host"\nreliable = 1', "reliable must be true or false; got 1"),
        ('topic = 5\nto = "one host"', "topic must be a str; got 5"),
    ],
)
def test_a_wrong_topic_says_where_and_what(text: str, told: str) -> None:
    with pytest.raises(ValueError, match=r"^fleet.toml: group 1 \(robots\): data 1") as error:
        read(f"[[groups.data]]\n{text}\n")
    assert told in str(error.value)


def test_data_are_a_list_of_topics_that_differ() -> None:
    with pytest.raises(ValueError, match=r"data must be tables \[\[groups.data\]\]; got 'scan'"):
        read('data = "scan"')
    with pytest.raises(ValueError, match="data must have distinct topics; got 'own' twice"):
        fleet(sample(1), sample(2))
    wrong: Any = ("scan",)
    with pytest.raises(TypeError, match=r"data\[0\] must be a Flow"):
        fleet(*wrong)
    with pytest.raises(ValueError, match="hosts must be one number if data are given"):
        ds.HostGroup([1, 2], 1, 1, data=(sample(1),))


def aligned_octets(parts: list[tuple[int, int]]) -> int:
    """Return the octets of values of so many octets that begin at multiples of so many."""
    place = 0
    for octets, grid in parts:
        place = -(-place // grid) * grid + octets
    return place


def text(value: str) -> list[tuple[int, int]]:
    return [(4, 4), (len(value) + 1, 1)]


STAMP = [(4, 4), (4, 4)]
POSE = [(7 * 8, 8)]
POINT = [
    part
    for name in ("x", "y", "z", "intensity", "ring", "time")
    for part in (*text(name), (4, 4), (1, 1), (4, 4))
]
FIELDS = {
    "scan": [*STAMP, *text("base_scan"), (7 * 4, 4), (4, 4), (360 * 4, 4), (4, 4)],
    "odometry": [
        *(*STAMP, *text("odom"), *text("base_footprint")),
        *(*POSE, (36 * 8, 8), (6 * 8, 8), (36 * 8, 8)),
    ],
    "tf": [(4, 4), *STAMP, *text("map"), *text("odom"), *POSE],
    "camera": [
        *(*STAMP, *text("oakd_rgb_camera_optical_frame"), (8, 4)),
        *(*text("bgr8"), (1, 1), (4, 4), (4, 4), (250 * 250 * 3, 1)),
    ],
    "point cloud": [
        *(*STAMP, *text("velodyne"), (8, 4), (4, 4), *POINT),
        *((1, 1), (8, 4), (4, 4), (30_000 * 22, 1), (1, 1)),
    ],
    "map": [*STAMP, *text("map"), *STAMP, (4, 4), (8, 4), *POSE, (4, 4), (384 * 384, 1)],
}


def test_ready_made_topics_are_as_long_as_their_fields() -> None:
    found = {name: topic["bytes"] for name, topic in topics().items()}
    assert found == {name: aligned_octets(fields) for name, fields in FIELDS.items()}
    assert all(row["source"].startswith("type: ros2/") for row in read_data("fleets/topics.csv"))


def test_samples_to_a_wired_host_go_up_and_their_answers_down() -> None:
    table = user_data_protocol(ds.DDS, fleet(sample(100_000, True, "wired host")))
    assert table is not None
    hops = {message.name.rpartition(", ")[2]: message.hops for message in table.messages}
    assert hops == {"full frames": ("up",), "last frames": ("up",), "answers": ("down",)}
