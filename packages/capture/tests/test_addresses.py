"""Addresses and ids that two hosts share, and hosts without a common middleware.

The captures were staged with Cyclone DDS 11.0.1 and Zenoh 1.10.2 (their Python packages) on hosts
10.77.0.1 to 10.77.0.3 behind one bridge.
"""

import io
from pathlib import Path

import handmade_captures as handmade
import pytest

import discostorm as ds
from discostorm_capture.diagnosis.diagnose import Diagnosis

STAGED = Path(__file__).with_name("captures")


def diagnosis(name: str) -> Diagnosis:
    return ds.read_capture(STAGED / f"{name}.pcap.xz").diagnosis()


@pytest.mark.parametrize(
    ("name", "hosts", "evidence"),
    [
        (
            "duplicate_address",
            ("10.77.0.2",),
            "packets from 10.77.0.2 come from more than one MAC address: 02:70:e3:74:4c:e8 and "
            "d2:40:a8:8f:03:84, whose first and last packets are of different processes",
        ),
        (
            "duplicate_zenoh_id",
            ("10.77.0.2", "10.77.0.1"),
            "10.77.0.2 and 10.77.0.1 announce the same ID, a1b2; 10.77.0.3 closed 3 of their sess"
            "ions",
        ),
        (
            "different_middleware",
            ("10.77.0.3",),
            "10.77.0.1 and 10.77.0.2 speak DDS, and 10.77.0.3 speaks Zenoh",
        ),
    ],
)
def test_the_first_finding_has_hosts_and_cause(
    name: str, hosts: tuple[str, ...], evidence: str
) -> None:
    first = diagnosis(name).findings[0]
    assert first.hosts == hosts
    assert first.evidence == evidence


@pytest.mark.parametrize(
    "name", ["duplicate_address", "duplicate_zenoh_id", "different_middleware", "qos_cyclone_dds"]
)
def test_complete_and_over_is_not_said_above_a_pair_that_cannot_work(name: str) -> None:
    assert diagnosis(name).summary().startswith("Discovery is not healthy: ")


def test_a_shared_id_is_not_taken_for_client_isolation() -> None:
    kinds = [finding.kind for finding in diagnosis("duplicate_zenoh_id").findings]
    assert kinds == ["processes with one id"]


def test_a_host_that_comes_back_with_another_mac_address_is_no_duplicate() -> None:
    packets = handmade.packets("duplicate_address", STAGED)
    other = bytes.fromhex("d240a88f0384")
    later = [(time + 100 * 10**9, *rest) for time, *rest in packets if rest[0][6:12] == other]
    first = [packet for packet in packets if other not in packet[1]]
    capture = handmade.pcap([*first, *later])
    kinds = {finding.kind for finding in ds.read_capture(io.BytesIO(capture)).diagnosis().findings}
    assert not kinds & {"duplicate address", "same address"}


def test_a_process_that_sends_from_two_mac_addresses_may_be_on_one_host() -> None:
    macs = [bytes.fromhex("02000000000" + end) for end in "23"]
    frames = handmade.packets("second_robot_same_address", STAGED)
    both = [
        (time, packet[:6] + macs[number % 2] + packet[12:], length)
        if packet[6:12] in macs and packet[12:14] == b"\x08\x00"
        else (time, packet, length)
        for number, (time, packet, length) in enumerate(frames)
    ]
    first = ds.read_capture(io.BytesIO(handmade.pcap(both))).diagnosis().findings[0]
    assert first.kind == "duplicate address"
    assert first.summary.startswith("either two hosts use the IP address 10.77.0.2, or one host")


def test_the_hub_of_a_star_of_routers_serves_and_is_no_vantage_point() -> None:
    capture = ds.read_capture(STAGED / "zenoh_star.pcap.xz")
    assert capture.servers() == ("10.77.0.1",)
    assert capture.fleet().hosts() == 3
    assert "view of one host" not in {one.kind for one in capture.diagnosis().findings}


def test_several_ipv6_addresses_of_one_host_are_no_shared_id() -> None:
    packets = handmade.packets("duplicate_zenoh_id", STAGED)
    frames = handmade.rewrap(packets, lambda ip: bytes(12) + b"\x86\xdd" + handmade.ipv6(ip))
    found = ds.read_capture(io.BytesIO(handmade.pcap(frames)))
    assert {":" in host for host in found.processes()["host"]} == {True}
    kinds = {finding.kind for finding in found.diagnosis().findings}
    assert not kinds & {"duplicate id", "processes with one id"}
