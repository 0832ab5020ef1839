"""Ills of three sets whose authors had not read the rules: each capture shows one, and the answer.

The captures are the first seconds of those that lab/measure/unlisted_faults.py makes. Hosts are
10.77.0.1 to 10.77.0.4, servers and routers 10.77.0.101.
"""

import tomllib
from dataclasses import replace
from pathlib import Path

import pytest

import discostorm as ds
from discostorm.data import data_path, read_data
from discostorm_capture.diagnosis.diagnose import RULES

STAGED = Path(__file__).with_name("captures")
SOURCES = Path(ds.read_capture.__code__.co_filename).parent


@pytest.mark.parametrize(
    ("name", "cause", "evidence", "action"),
    [
        (
            "base_behind_the_computer",
            "a server announces 10.78.0.3, but the other hosts have no route to this address",
            "other hosts announced a process at this address, and 10.78.0.2 is in the same",
            "Add a route to the network of 10.78.0.3",
        ),
        (
            "left_over_server",
            "10.77.0.3 uses a different discovery method than the other hosts",
            "On 10.77.0.1 and 10.77.0.2, discovery uses only multicast",
            "the same ROS_DISCOVERY_SERVER (or Zenoh router, or peers in CYCLONEDDS_URI)",
        ),
        (
            "humble_beside_jazzy",
            "10.77.0.3 runs a ROS 2 distribution older than Iron, and other hosts run Iron",
            "10.77.0.1 and 10.77.0.2 announced type hashes",
            "Run the same ROS 2 distribution on all hosts",
        ),
        (
            "power_save",
            "10.77.0.3 receives packets only in bursts, like a radio in power-saving mode",
            "bursts, one every 1.00 s, although others asked it",
            "Turn off power saving on 10.77.0.3",
        ),
        (
            "tcp_for_data_on_one",
            "the writer and reader of a topic use different transports",
            "/beat: the writer (on",
            "Set the same transports",
        ),
        (
            "bridges_in_a_loop",
            "10.77.0.1 and 10.77.0.2 run bridges between DDS and Zenoh that also hear each other",
            "they also sent these samples to each other",
            "keep DDS within each host",
        ),
        (
            "docker_overlaps",
            "another network on 10.77.0.3, such as Docker's, overlaps",
            "10.77.0.3 announces the addresses 10.77.0.3 and 10.77.0.126",
            "give Docker a different network",
        ),
        (
            "no_way_back",
            "connection attempts from 10.78.0.3 reach the server or router, but the replies",
            "10.78.0.3 tried 3 times to connect to port 7447 on 10.77.0.101",
            "add a route back to the network of 10.78.0.3",
        ),
        (
            "isolation_with_server",
            "the access point isolates its clients",
            "10.77.0.1 (60 samples, which it requested 172 times)",
            "Turn off client isolation (AP isolation)",
        ),
        (
            "data_kept_in",
            "10.77.0.3 sends no data, because a firewall there lets out only discovery traffic",
            "ther hosts asked 10.77.0.3",
            "rules on outgoing packets",
        ),
        (
            "static_on_one",
            "10.77.0.3 differs from the other hosts in static endpoint discovery",
            "10.77.0.3 read endpoints from a file (static discovery)",
            "On 10.77.0.3, turn off static endpoint discovery",
        ),
        (
            "client_for_each_call",
            "a process on 10.77.0.2 keeps creating and deleting endpoints",
            "endpoints of /set_mode (service), and withdrew",
            "create its clients, publishers and subscriptions once",
        ),
        (
            "clock_steps_back",
            "the clock on 10.77.0.3 was set back while nodes were running",
            "t 10.6 s, the timestamps in samples from 10.77.0.3 jumped back by 30.0 s",
            "let chrony slew it",
        ),
        (
            "images_by_multicast",
            "10.77.0.1 sends data by multicast, and much of it is lost",
            "others requested lost ones",
            "set AllowMulticast to spdp",
        ),
        (
            "connects_to_routers_only",
            "10.77.0.1, 10.77.0.2 and 10.77.0.3 look only for a Zenoh router, and none answers",
            "by multicast for a router, but not for peers",
            "Or make peers connect without a router",
        ),
        (
            "expired_certificate",
            "connections to the router on 10.77.0.101 end before a session begins",
            "from 10.77.0.1 to port 7447",
            "Check the dates, the name and the issuer of the certificate",
        ),
        (
            "server_crashes_again_and_again",
            "a process on 10.77.0.101 keeps restarting",
            "a server on 10.77.0.101 began numbering its participants from 1 again",
            "Check the log of the process that keeps restarting on 10.77.0.101",
        ),
        (
            "service_across_vendors",
            "the server and client of a service run different DDS implementations",
            "server on 10.77.0.1 runs Fast DDS, but the client on 10.77.0.2 runs Cyclone DDS",
            "Set the same RMW_IMPLEMENTATION on all hosts",
        ),
        (
            "cyclone_beside_server",
            "10.77.0.3 runs a DDS implementation that cannot use a Discovery Server",
            "n 10.77.0.3, discovery uses multicast",
            "ROS_DISCOVERY_SERVER works only with Fast DDS",
        ),
        (
            "no_micro_ros_agent",
            "10.77.0.1 refuses packets",
            "to port 8888 (micro-ROS agent) on 10.77.0.1",
            "Start the server, router or agent on 10.77.0.1",
        ),
        (
            "router_hangs",
            "the router on 10.77.0.101 has hung",
            "10.77.0.101 sent nothing but TCP acknowledgments from 8.4 s on",
            "Restart the router at 10.77.0.101",
        ),
        (
            "fragments_fill_memory",
            "10.77.0.2 gets only parts of large datagrams",
            "10.77.0.2 reported by ICMP that parts of datagrams did not arrive",
            "run `sysctl net.ipv4.ipfrag_time=3 net.ipv4.ipfrag_high_thresh",
        ),
        (
            "slow_session_closed",
            "Zenoh sessions of 10.77.0.2 stall",
            "10.77.0.2 opened",
            "Send less to 10.77.0.2",
        ),
        (
            "bridges_of_three_topics",
            "10.77.0.101 and 10.77.0.1 run bridges between DDS and Zenoh that also hear each",
            "they also sent these samples to each other",
            "Connect 10.77.0.101 and 10.77.0.1 only through the bridges",
        ),
        (
            "broadcasts_fill_the_air",
            "frames are lost or late while programs other than ROS 2 on 10.77.0.2, 10.77.0.3,",
            "Programs other than ROS 2 send 0.3 Mbit/s to 255.255.255.255",
            "for MAVROS, set gcs_url to udp://",
        ),
        (
            "small_receive_buffer",
            "10.77.0.101 loses parts of large samples on arrival, because bursts overflow its",
            "requested parts of large samples again, although the capture, recorded there",
            "raise net.core.rmem_max",
        ),
    ],
)
def test_the_first_sentence_has_the_cause_and_the_action_follows(
    name: str, cause: str, evidence: str, action: str
) -> None:
    said = ds.read_capture(STAGED / f"{name}.pcap.xz").diagnosis().summary()
    assert "not healthy" in said or "neither healthy" in said
    assert 0 < said.index(cause) < said.index(evidence) < said.index(action)


@pytest.mark.parametrize(
    ("name", "headline", "action"),
    [
        (
            "two_robots_in_one_domain",
            "10.77.0.1 and 10.77.0.2 use the same topic names",
            "give each its own namespace",
        ),
        (
            "tools_are_no_super_client",
            "10.77.0.3 shares no topics with the other hosts",
            "make them super clients",
        ),
        (
            "command_line_tool_is_client",
            "10.77.0.101 uses no topics of its own, so the Discovery Server announces the topics",
            "make them super clients",
        ),
        (
            "laptop_behind_router",
            "10.78.0.5, in a different subnet, exchanges packets with the other hosts, but no",
            "discover each other by unicast",
        ),
        (
            "published_once",
            "A process on 10.77.0.2 exited before any reader could get its samples",
            "wait for matching readers",
        ),
        (
            "launched_twice",
            "10.77.0.1 and 10.77.0.2 send commands on the same topic",
            "look for a launch file that runs twice",
        ),
        (
            "router_denies_one",
            "10.77.0.3 gets no data, because either no other host uses its topics, or the router's",
            "key expressions the router's access_control allows",
        ),
        (
            "namespace_on_one",
            "10.77.0.3 gets no data, because either no other host uses its topics, or the router's",
            "compare the namespace in the Zenoh configuration",
        ),
        (
            "bridge_beside_rmw_zenoh",
            "10.77.0.3 gets no data, because it does not use rmw_zenoh, unlike the other hosts, so",
            "Set the same RMW_IMPLEMENTATION on all hosts",
        ),
        (
            "router_keeps_a_topic",
            "10.77.0.2 gets none of the samples of a topic, although its Zenoh router receives",
            "look for access_control, low_pass_filter and downsampling",
        ),
        (
            "two_servers_of_a_service",
            "10.77.0.2 and 10.77.0.1 offer the same service",
            "stop the other server",
        ),
        (
            "two_clocks",
            "10.77.0.1 and 10.77.0.2 each publish simulation time",
            "Stop all but one of the simulations",
        ),
        (
            "bag_beside_robot",
            "10.77.0.1 and 10.77.0.2 publish the same topics",
            "is playing a recording (`ros2 bag play`) or running a simulation, stop that",
        ),
        (
            "service_in_namespace",
            "A topic or service has different names at its two ends",
            "At both ends, compare the names",
        ),
        (
            "lease_never_ends",
            "A process on 10.77.0.2 went silent without a goodbye, and its lease never expires",
            "Set a finite leaseDuration",
        ),
        (
            "images_lose_a_fragment",
            "Large samples are incomplete",
            "Send less over this link",
        ),
    ],
)
def test_what_may_be_on_purpose_stands_above_a_healthy_fleet(
    name: str, headline: str, action: str
) -> None:
    found = ds.read_capture(STAGED / f"{name}.pcap.xz").diagnosis()
    assert found.healthy
    assert found.summary().startswith(headline)
    assert action in found.summary()


def test_a_host_that_shares_no_topic_but_has_its_own_is_no_tool() -> None:
    seen = ds.read_capture(STAGED / "tools_are_no_super_client.pcap.xz")
    ends = seen.endpoints()
    ends["topic"] = ends["topic"].replace("rt/rosout", "rt/logs")
    assert replace(seen, _endpoints=ends).diagnosis().findings == ()


def test_one_topic_in_common_makes_no_two_robots() -> None:
    seen = ds.read_capture(STAGED / "two_robots_in_one_domain.pcap.xz")
    ends = seen.endpoints()
    ends = ends[ends["topic"].ne("rt/cmd_vel") & ends["topic"].ne("rt/scan")]
    assert replace(seen, _endpoints=ends).diagnosis().findings == ()


@pytest.mark.parametrize("role", ["server", "client"])
def test_one_server_of_a_service_is_no_finding(role: str) -> None:
    seen = ds.read_capture(STAGED / "two_servers_of_a_service.pcap.xz")
    ends, plain = seen.endpoints(), replace(seen, _endpoints=seen.endpoints()[:0])
    last = ends[ends["topic"].str.startswith("rq/") & ends["writer"].eq(role == "client")].index[-1]
    found = replace(seen, _endpoints=ends.drop(last)).diagnosis().findings
    assert found == plain.diagnosis().findings == ()


def test_a_host_that_scouts_by_ipv4_and_speaks_ipv6_is_one_host() -> None:
    found = ds.read_capture(STAGED / "healthy_dual_stack.pcap.xz").diagnosis()
    assert found.healthy
    assert [*found.hosts().index] == ["10.77.0.2", "10.77.0.1", "10.77.0.3"]


def test_every_threshold_sentence_and_rule_is_used() -> None:
    source = "\n".join(path.read_text(encoding="utf-8") for path in SOURCES.rglob("*.py"))
    limits = read_data("diagnosis/thresholds.csv", "discostorm_capture")
    path = data_path("written/sentences.toml", "discostorm_capture")
    sentences = tomllib.loads(path.read_text(encoding="utf-8"))
    rules = [name.partition(".")[2] for names in RULES.values() for name in names]
    names = [f"LIMITS.{row['name']}" for row in limits]
    names += [f'"{key}"' for key in sentences] + [f"def {rule}(" for rule in rules]
    assert [name for name in names if name not in source] == []
