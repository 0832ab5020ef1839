"""Endpoints of one topic that cannot match: read from SEDP, and told by the diagnosis.

captures/qos_cyclone_dds.pcap.xz was staged: two hosts with Cyclone DDS 11.0.1 (its Python
package), six topics; on /tf a reliable writer serves a best-effort reader, the others differ.
"""

import lzma
import struct
from dataclasses import replace
from pathlib import Path

import handmade_captures as handmade
import numpy as np
import pandas as pd
import pytest

import discostorm as ds
from discostorm_capture import endpoints
from discostorm_capture.diagnosis.topics import qos_mismatches
from discostorm_capture.endpoints import Endpoint, parse_endpoint, ros_topic

STAGED = Path(__file__).with_name("captures") / "qos_cyclone_dds.pcap.xz"


def test_qos_and_types_that_differ_are_told_topic_by_topic() -> None:
    diagnosis = ds.read_capture(STAGED).diagnosis()
    assert (diagnosis.complete, diagnosis.healthy) == (True, False)
    found = {finding.kind: finding for finding in diagnosis.findings}
    assert {*found} == {"types differ", "QoS differs"}
    assert found["types differ"].evidence == (
        "/cmd_vel: the writer on 10.77.0.1 has the type std_msgs/msg/String, but the reader "
        "on 10.77.0.2 has std_msgs/msg/Int32"
    )
    assert found["QoS differs"].evidence == (
        "/scan: the writer on 10.77.0.1 offers 'best effort', but the reader on 10.77.0.2 asks for "
        "'reliable' (RELIABILITY_QOS_POLICY); /map: the writer on 10.77.0.1 offers 'volatile', but "
        "the reader on 10.77.0.2 asks for 'transient local' (DURABILITY_QOS_POLICY); /odom: the "
        "writer on 10.77.0.1 offers '0.2 s', but the reader on 10.77.0.2 asks for '0.1 s' "
        "(DEADLINE_QOS_POLICY); and 1 more"
    )
    assert "Discovery is not healthy: the writer and reader of a topic have different types" in (
        diagnosis.summary()
    )
    # What to change depends on the policy.
    advice = found["QoS differs"].advice
    assert "Make the publisher transient local (as for a map that is sent once), or" in advice
    assert "Make the publisher reliable, or the subscription best effort." in advice
    assert "order" not in advice


def test_dds_matches_two_definitions_of_a_type_by_its_name() -> None:
    capture = ds.read_capture(STAGED)
    ends = capture._endpoints
    rows = ends["topic"] == "rt/cmd_vel"
    hashes = ends["writer"].map({True: "RIHS01_ab12", False: "RIHS01_9c3f"}).where(rows, "")
    ends = ends.assign(type=ends["type"].where(~rows, "std_msgs::msg::dds_::String_"))
    found = replace(capture, _endpoints=ends.assign(type_hash=hashes)).diagnosis().findings
    assert [finding.kind for finding in found] == ["definitions differ", "QoS differs"]
    assert "so no samples arrive" not in found[0].summary


def test_endpoints_have_what_they_announced() -> None:
    endpoints = ds.read_capture(STAGED).endpoints().set_index(["topic", "writer"])
    assert len(endpoints) == 12
    assert endpoints["partitions"]["rt/part"].to_dict() == {True: ("robot1",), False: ("robot2",)}
    assert endpoints["deadline"]["rt/odom"].to_dict() == pytest.approx(
        {True: 0.2, False: 0.1}, abs=1e-9
    )
    assert endpoints["reliability"]["rt/tf"].to_dict() == {True: "reliable", False: "best effort"}


def test_a_cut_announcement_is_unknown_and_never_healthy(tmp_path: Path) -> None:
    path = tmp_path / "cut.pcap"
    packets = handmade.packets("cyclone_healthy")
    path.write_bytes(handmade.pcap(packets))
    assert ds.read_capture(path).diagnosis().healthy is True
    cut = [(time, data[:200] if len(data) > 300 else data, size) for time, data, size in packets]
    path.write_bytes(handmade.pcap(cut))
    capture = ds.read_capture(path)
    assert capture.endpoints()["topic"].isna().any()
    diagnosis = capture.diagnosis()
    assert diagnosis.healthy is None
    assert "QoS unknown" in {finding.kind for finding in diagnosis.findings}
    assert "healthy" not in diagnosis.summary()
    assert "endpoints are truncated or unreadable. Record whole packets" in diagnosis.summary()


def test_the_staged_capture_is_whole() -> None:
    assert lzma.decompress(STAGED.read_bytes())[:4] == b"\xd4\xc3\xb2\xa1"


WRITER = Endpoint(True, "rt/scan", "T", "reliable")
READER = Endpoint(False, "rt/scan", "T", "best effort")


@pytest.mark.parametrize(
    ("writer", "reader", "policies"),
    [
        ({}, {}, []),
        ({}, {"reliability": "reliable"}, []),
        ({"reliability": "best effort"}, {"reliability": "reliable"}, ["RELIABILITY"]),
        ({"durability": "transient local"}, {}, []),
        ({}, {"durability": "transient local"}, ["DURABILITY"]),
        ({"deadline": 1.0}, {"deadline": 1.0}, []),
        ({"deadline": 2.0}, {"deadline": 1.0}, ["DEADLINE"]),
        ({}, {"deadline": 1.0}, ["DEADLINE"]),
        ({}, {"liveliness": "manual by topic"}, ["LIVELINESS"]),
        ({"lease": 2.0}, {"lease": 1.0}, ["LIVELINESS_LEASE_DURATION"]),
        ({"ownership": "exclusive"}, {}, ["OWNERSHIP"]),
        ({"partitions": ("a", "b")}, {"partitions": ("b",)}, []),
        ({"partitions": ("robot1",)}, {"partitions": ("robot*",)}, []),
        ({"partitions": ("robot1",)}, {}, ["PARTITION"]),
    ],
)
def test_a_writer_must_offer_what_a_reader_asks_for(
    writer: dict[str, object], reader: dict[str, object], policies: list[str]
) -> None:
    offers, asks = (
        Endpoint(**(vars(end) | changes)) for end, changes in ((WRITER, writer), (READER, reader))
    )
    assert [*qos_mismatches(offers, asks)] == [f"{policy}_QOS_POLICY" for policy in policies]


def test_tokens_of_rmw_zenoh_name_topics_and_types() -> None:
    """Staged with Zenoh 1.10.2: a router on 10.77.0.1, and tokens as rmw_zenoh declares them."""
    capture = ds.read_capture(Path(__file__).with_name("captures") / "zenoh_types.pcap.xz")
    found = capture.endpoints()
    assert found["topic"].tolist() == ["/chatter", "/scan", "/chatter", "/scan"]
    assert found["writer"].tolist() == [True, True, False, False]
    assert found["reliability"].tolist() == ["reliable", "best effort", "reliable", "reliable"]
    hosts = capture.processes()["host"][found["process"]].tolist()
    assert hosts == ["10.77.0.2", "10.77.0.2", "10.77.0.3", "10.77.0.3"]
    (first,) = capture.diagnosis().wrong  # Zenoh passes data whatever QoS says
    assert first.kind == "types differ"
    assert first.evidence == (
        "/chatter: the writer on 10.77.0.2 has the type std_msgs/msg/String, but the reader "
        "on 10.77.0.3 has std_msgs/msg/Int32"
    )


@pytest.mark.parametrize(
    ("token", "topic", "durability"),
    [
        ("/0/a1/0/10/MP/%/%/n/%fleet%map/m::msg::dds_::M_/RIHS01_ab/:1:,1:,:,:,,", "/fleet/map", 1),
        ("/7/a1/0/10/MS/%/%/n/%map/m::msg::dds_::M_/RIHS01_ab/::,1:,:,:,,", "/map (domain 7)", 0),
    ],
)
def test_a_token_names_domain_namespace_and_durability(
    token: str, topic: str, durability: int
) -> None:
    match = endpoints.ROS_TOKEN_PATTERN.match(b"@ros2_lv" + token.encode())
    assert match
    endpoint = endpoints.endpoint_of_ros_token(match)
    assert (endpoint.topic, endpoint.writer) == (topic, "/MP/" in token)
    assert endpoint.durability == endpoints.DURABILITIES[durability]


def test_topics_have_their_names_in_ros() -> None:
    assert ros_topic("rt/robot1/scan") == "/robot1/scan"
    assert ros_topic("rq/map_server/get_mapRequest") == "/map_server/get_map (service)"
    assert ros_topic("my_topic") == "my_topic"


def test_partitions_part_on_purpose_unless_a_reader_has_no_writer_left() -> None:
    capture = ds.read_capture(STAGED)
    # Where the reader has one of its own, as each team of robots has.
    (row,) = capture.endpoints().query("topic == 'rt/part' and writer").to_dict("records")
    own = pd.DataFrame([row | {"entity": 0, "partitions": ("robot2",)}])
    both = replace(capture, _endpoints=pd.concat([capture.endpoints(), own]))
    for each, told in ((capture, True), (both, False)):
        (finding,) = (one for one in each.diagnosis().findings if one.kind == "QoS differs")
        assert finding.evidence.endswith("; and 1 more") == told


def test_an_announcement_with_an_unknown_reliability_is_unreadable() -> None:
    def octets(reliability: int) -> np.ndarray:
        topic = struct.pack("<HHI4s", 0x05, 8, 4, b"a/b\0")
        kind = struct.pack("<HHI4s", 0x07, 8, 4, b"T_\0\0")
        qos = struct.pack("<HHIII", 0x1A, 12, reliability, 0, 0)
        return np.frombuffer(topic + kind + qos + struct.pack("<HH", 1, 0), np.uint8)

    read = [parse_endpoint(octets(n), 0, len(octets(n)), True, 0x103) for n in range(4)]
    assert [one and one.reliability for one in read] == [None, "best effort", "reliable", None]
