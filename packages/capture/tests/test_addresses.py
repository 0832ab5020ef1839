"""Addresses and ids that two hosts share, and hosts without a common middleware.

The captures were staged with Cyclone DDS 11.0.1 and Zenoh 1.10.2 (their Python packages) on hosts
10.77.0.1 to 10.77.0.3 behind one bridge.
"""

from pathlib import Path

import pytest

import discostorm as ds
from discostorm_capture.diagnosis import Diagnosis


def diagnosis(name: str) -> Diagnosis:
    return ds.read_capture(Path(__file__).with_name("captures") / f"{name}.pcap.xz").diagnosis()


@pytest.mark.parametrize(
    ("name", "hosts", "evidence"),
    [
        (
            "duplicate_address",
            ("10.77.0.2",),
            "10.77.0.2 belongs to the MAC addresses 02:70:e3:74:4c:e8 and d2:40:a8:8f:03:84, as "
            "ARP says",
        ),
        (
            "duplicate_zenoh_id",
            ("10.77.0.2", "10.77.0.1"),
            "the Zenoh id a1b2 speaks from 10.77.0.2 and 10.77.0.1",
        ),
        (
            "different_middleware",
            ("10.77.0.3",),
            "10.77.0.1 and 10.77.0.2 speak DDS, 10.77.0.3 speaks Zenoh",
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
    assert kinds == ["duplicate id"]
