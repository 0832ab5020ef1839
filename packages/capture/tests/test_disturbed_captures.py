"""Captures that begin late, or show one direction or address family only.

Each is one of the stored captures, changed. The diagnosis names the cause, or nothing.
"""

import io
import struct
from collections.abc import Callable
from pathlib import Path

import handmade_captures as handmade
import pytest
from support import REFERENCE

import discostorm as ds
from discostorm_capture.diagnosis.diagnose import Diagnosis
from discostorm_capture.live_capture import PacketStream

ILLS, STAGED = REFERENCE / "captures" / "ills", Path(__file__).with_name("captures")
SECOND = 10**9
#: A packet: its time [ns], and what follows the link's header.
Datagram = tuple[int, bytes]


def datagrams(name: str, folder: Path = ILLS) -> list[Datagram]:
    """Return the IPv4 packets of a stored capture, of Ethernet or Linux's "any" interface."""
    raw = handmade.lzma.decompress((folder / f"{name}.pcap.xz").read_bytes())
    skipped = {1: 14, 276: 20}[struct.unpack_from("<I", raw, 20)[0]]
    found = [
        (round(time * SECOND), packet[16 + skipped :])
        for time, packet in PacketStream("x").feed(raw)
    ]
    return [(time - found[0][0], ip) for time, ip in found if ip[0] >> 4 == 4]


def diagnosed(found: list[Datagram]) -> Diagnosis:
    packets = [(time, ip, len(ip)) for time, ip in sorted(found)]
    return ds.read_capture(io.BytesIO(handmade.pcap(packets, link=101))).diagnosis()


def from_or_to(ip: bytes, host: int) -> bool:
    return host in (ip[15], ip[19]) or ip[16] >= 224


def is_from(ip: bytes, host: int) -> bool:
    return ip[15] == host


def began_late(name: str, seconds: int = 5) -> list[Datagram]:
    return [one for one in datagrams(name) if one[0] > seconds * SECOND]


def sent_by_the_first_host() -> list[Datagram]:
    return [one for one in datagrams("healthy-fast_dds-server") if is_from(one[1], 1)]


def only_multicast() -> list[Datagram]:
    return [one for one in datagrams("cyclone_healthy", handmade.CAPTURES) if one[1][16] >= 224]


@pytest.mark.parametrize(
    ("found", "kinds"),
    [
        (lambda: began_late("late_joiner-cyclone_dds_0_10"), []),
        (lambda: began_late("restart-cyclone_dds_0_10"), ["restart", "capture began late"]),
        (sent_by_the_first_host, ["capture lost part"]),
        (only_multicast, ["capture lost part"]),
    ],
    ids=["joiner", "restart", "one direction", "multicast"],
)
def test_a_healthy_fleet_stays_healthy(
    found: Callable[[], list[Datagram]], kinds: list[str]
) -> None:
    diagnosis = diagnosed(found())
    assert diagnosis.wrong == ()
    assert [one.kind for one in diagnosis.findings] == kinds


def relaunched() -> list[Datagram]:
    """Return a startup of two processes a host, and the same with new ids 16 s later."""
    found = [one for one in datagrams("fast_dds", handmade.CAPTURES) if one[0] < 15 * SECOND]
    ids = {ip[36:40] for _, ip in found if ip[28:32] == b"RTPS"}
    new = []
    for time, ip in found:
        for id_ in ids:
            ip = ip.replace(id_, id_[:3] + bytes([id_[3] ^ 0xFF]))
        new.append((time + 16 * SECOND, ip))
    return found + new


def test_a_fleet_that_is_started_anew_is_one_restart_and_no_crash_loop() -> None:
    diagnosis = diagnosed(relaunched())
    (finding,) = diagnosis.findings
    assert (finding.kind, len(finding.hosts)) == ("restart", 3)
    assert "on 10.77.0.1, processes began at 16.0 s, after the " in finding.evidence
    assert "6 processes on 3 hosts discovered each other" in diagnosis.summary()


def on_another_rmw() -> list[Datagram]:
    """Return two hosts with DDS, and a third one whose Zenoh finds no router."""
    found = [one for one in datagrams("fast_dds", handmade.CAPTURES) if one[0] < 12 * SECOND]
    found = [one for one in found if 3 not in (one[1][15], one[1][19])]
    calls = datagrams("server_never_there-zenoh-router")
    return found + [one for one in calls if 3 in (one[1][15], one[1][19])]


def in_two_domains() -> list[Datagram]:
    """Return a router and two hosts with tokens of rmw_zenoh, one of which is in domain 7."""
    found = datagrams("zenoh_types", STAGED)
    (session,) = {
        ip.split(b"@ros2_lv/0/")[1][:32]
        for _, ip in found
        if is_from(ip, 3) and b"@ros2_lv/0/" in ip
    }
    ends = b"@ros2_lv/0/" + session, b"@ros2_lv/7/" + session
    return [(time, ip.replace(*ends)) for time, ip in found]


def out_of_reach() -> list[Datagram]:
    """Return a fleet of Zenoh whose second robot leaves after 0.3 s; its router asks on."""
    found, asked = [], set[bytes]()
    for time, ip in datagrams("healthy-zenoh-router"):
        if not (time > 0.3 * SECOND and 2 in (ip[15], ip[19])):
            found.append((time, ip))
        elif ip[19] == 2 and len(ip) > 52 and ip[24:28] not in asked:  # no bare ACK
            asked.add(ip[24:28])
            for n in range(6):  # each time with another IP id
                again = ip[:4] + bytes([ip[4] ^ n]) + ip[5:]
                found.append((time + round(0.2 * (2**n - 1) * SECOND), again))
    return found


def with_ipv6() -> list[Datagram]:
    return [
        (time, handmade.ipv6(ip)) for time, ip in datagrams("firewall_on_one_host-cyclone_dds_0_10")
    ]


def leases_seen_at_the_first_host() -> list[Datagram]:
    return [one for one in datagrams("leases_expire-cyclone_dds_0_10") if from_or_to(one[1], 1)]


@pytest.mark.parametrize(
    ("found", "kind", "hosts"),
    [
        (on_another_rmw, "different middleware", ["10.77.0.3"]),
        (in_two_domains, "two domains", ["10.77.0.2", "10.77.0.3"]),
        (out_of_reach, "out of range", ["10.77.0.2"]),
        (with_ipv6, "firewall or network", ["fe80::a4d:2"]),
        (leases_seen_at_the_first_host, "leases expire", ["10.77.0.2"]),
    ],
)
def test_the_first_finding_is_the_cause(
    found: Callable[[], list[Datagram]], kind: str, hosts: list[str]
) -> None:
    first = diagnosed(found()).findings[0]
    assert (first.kind, [*first.hosts]) == (kind, hosts)


@pytest.mark.parametrize(
    ("name", "hosts"),
    [("missing_zenoh_peers", {1}), ("missing_fell_silent_zenoh", {1}), ("slow_session_closed", {})],
)
def test_a_host_that_is_seen_on_loopback_only_did_not_crash(name: str, hosts: set[int]) -> None:
    """Some packets, or all, go over loopback, as in a capture of all interfaces of a host."""

    def looped(ip: bytes) -> bytes:
        ends = (ip[12:16], ip[16:20])
        chosen = [end[0] == 10 and (end[3] in hosts or not hosts) for end in ends]
        return (
            ip[:12]
            + b"".join(
                b"\x7f\0\0\1" if change else end for end, change in zip(ends, chosen, strict=True)
            )
            + ip[20:]
        )

    found = diagnosed([(time, looped(ip)) for time, ip in datagrams(name, STAGED)])
    assert not {"crash", "out of range"} & {one.kind for one in found.findings}
