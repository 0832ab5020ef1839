"""Ills below discovery: netmask, route, NAT, MTU, black holes and wrong ports.

The captures were staged with Cyclone DDS 11.0.1 and Zenoh 1.10.2 (their Python packages) on hosts
10.77.0.1 to 10.77.0.3 behind one bridge. Its port of 10.77.0.2 or its filter had the ill.
"""

import io
import struct
from pathlib import Path

import handmade_captures as handmade
import pytest
from support import REFERENCE, check_first_sentence

import discostorm as ds
from discostorm.data import data_path
from discostorm_capture.diagnosis.diagnose import Diagnosis

STAGED = Path(__file__).with_name("captures")
HEALTHY = [
    *(
        data_path(f"captures/{name}.pcap.xz", "discostorm_capture")
        for name in ("cyclone_dds_010", "cyclone_dds_11", "cyclone_healthy", "fast_dds")
    ),
    STAGED / "zenoh_star.pcap.xz",
    *(REFERENCE / "captures").glob("*.pcap.xz"),
    *(REFERENCE / "captures" / "ills").glob("healthy-*.pcap.xz"),
]


def diagnosis(name: str) -> Diagnosis:
    return ds.read_capture(STAGED / f"{name}.pcap.xz").diagnosis()


@pytest.mark.parametrize(
    ("name", "cause", "evidence", "action"),
    [
        (
            "wrong_netmask",
            "10.77.0.2 does not answer ARP requests, because its netmask or route is wrong",
            "10.77.0.3 sent 12 ARP requests for 10.77.0.2 and got no answer",
            "On 10.77.0.2, compare `ip address`",
        ),
        (
            "wrong_gateway",
            "10.77.0.130 does not answer ARP requests, because its netmask or route is wrong",
            "10.77.0.130 sent 9 ARP requests for 10.77.0.129 and got no answer",
            "On 10.77.0.130, compare `ip address`",
        ),
        (
            "behind_nat",
            "10.77.0.3 announces an address that sends no packets",
            "10.77.0.3 announces itself as 172.17.0.2",
            "If ROS 2 runs in a container there, start the container with `docker run "
            "--network host --ipc=host`",
        ),
        (
            "smaller_mtu",  # the bridge dropped packets of more than 1,280 bytes
            "large packets between 10.77.0.2 and 10.77.0.3 vanish",
            "packets of up to 1,264 bytes arrive, but packets of 1,284 bytes or more",
            "Find the largest packet that gets through",
        ),
        (
            "zenoh_black_hole",  # after 700 bytes of TCP to each of the others
            "either a firewall or the network drops packets of open TCP connections to and from",
            "10.77.0.3 to 10.77.0.1 (57 bytes, first sent at 0.0 s)",
            "While packets vanish, `ping` the other hosts from 10.77.0.3",
        ),
        (
            "zenoh_wrong_port",
            "10.77.0.3 uses the wrong port or transport for the server or router",
            "10.77.0.3 tried port 7448 on 10.77.0.1 (4 attempts refused), but port 7447 answers",
            "On 10.77.0.3, correct the port and the transport",
        ),
    ],
)
def test_the_first_sentence_has_cause_and_hosts_and_the_action_follows(
    name: str, cause: str, evidence: str, action: str
) -> None:
    found = diagnosis(name)
    check_first_sentence(found.summary(), cause, evidence, f". {action}")
    assert len(found.wrong) == 1


def test_a_session_is_complete_when_its_declarations_are_acknowledged() -> None:
    found = diagnosis("zenoh_black_hole")
    assert found.complete is False
    lacking = set(found.incomplete()[["of", "by"]].itertuples(index=False, name=None))
    assert lacking == {("10.77.0.3", "10.77.0.1"), ("10.77.0.3", "10.77.0.2")}


@pytest.mark.parametrize("path", HEALTHY, ids=lambda path: path.name)
def test_nothing_is_wrong_with_healthy_fleets(path: Path) -> None:
    assert ds.read_capture(path).diagnosis().wrong == ()


def test_a_discovery_server_on_another_port_is_named_with_both_ports() -> None:
    def without(name: str, chosen: bool) -> list[handmade.Packet]:
        host = bytes([10, 77, 0, 3])
        found = handmade.packets(name, REFERENCE / "captures" / "ills")
        start = found[0][0]
        ports = struct.pack(">H", 11811), struct.pack(">H", 11812)
        return [
            (time - start, data.replace(*ports) if chosen else data, length)
            for time, data, length in found
            if (host in data[26:34]) == chosen
        ]

    packets = without("healthy-fast_dds-server", chosen=False)
    packets += without("server_never_there-fast_dds-server", chosen=True)
    found = ds.read_capture(io.BytesIO(handmade.pcap(sorted(packets)))).diagnosis()
    first = found.findings[0]
    assert (first.kind, first.hosts) == ("wrong port", ("10.77.0.3",))
    assert first.evidence.startswith("10.77.0.3 tried port 11812 on 10.77.0.101 (")
    assert " messages from 1 host got no answer" in first.evidence
    assert first.evidence.endswith(", but port 11811 answers there")


def segment(time: float, size: int, sequence: int, acknowledges: int, flags: int = 0x18,
            back: bool = False) -> handmade.Packet:  # fmt: skip
    ip = handmade.tcp(bytes(size), sequence, flags, back)
    ip = ip[:28] + struct.pack(">I", acknowledges) + ip[32:]
    return round(time * 1e9), bytes(12) + b"\x08\x00" + ip, len(ip) + 14


@pytest.mark.parametrize(("lost", "kinds"), [(1400, ["large packets"]), (0, [])])
def test_only_large_segments_of_tcp_vanish(lost: int, kinds: list[str]) -> None:
    packets = [
        segment(0.0, 0, 100, 0, flags=2),
        segment(0.1, 0, 500, 101, flags=0x12, back=True),
        segment(0.2, 0, 101, 501, flags=0x10),
        segment(0.3, 300, 101, 501),
        segment(0.4, 0, 501, 401, flags=0x10, back=True),
        *(segment(1.0 + 2**n * 0.2, lost, 401, 501) for n in range(4) if lost),
    ]
    found = ds.read_capture(io.BytesIO(handmade.pcap(packets))).diagnosis()
    assert [one.kind for one in found.wrong] == kinds
    if lost:
        assert "up to 340 bytes arrive, but packets of 1,440 bytes" in found.findings[0].evidence


def test_a_restart_is_the_headline_of_a_restart() -> None:
    path = REFERENCE / "captures" / "ills" / "restart-cyclone_dds_0_10.pcap.xz"
    said = ds.read_capture(path).diagnosis().summary()
    assert said.startswith(
        "A process on 10.77.0.2 stopped, and a new one started. Discovery is healthy"
    )
