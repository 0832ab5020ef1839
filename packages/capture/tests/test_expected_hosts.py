"""Hosts that are expected, and missing in a capture."""

import json
import tomllib
from pathlib import Path
from typing import Any

import handmade_captures as handmade
import pytest
from click.testing import CliRunner
from support import REFERENCE, ROOT

import discostorm as ds
from discostorm.cli.main import main
from discostorm.wording import join_words
from discostorm_capture.live_capture import PacketStream, Watch

HEALTHY = handmade.CAPTURES / "fast_dds.pcap.xz"
HOSTS = ("10.77.0.1", "10.77.0.2", "10.77.0.3")


def findings(expected: int | tuple[str, ...] | None) -> list[tuple[str, tuple[str, ...]]]:
    diagnosis = ds.read_capture(HEALTHY).diagnosis(expected)
    return [(finding.kind, finding.hosts) for finding in diagnosis.findings]


@pytest.mark.parametrize("expected", [None, 1, 3, HOSTS, HOSTS[1:]])
def test_who_is_there_is_not_missing(expected: int | tuple[str, ...] | None) -> None:
    assert findings(expected) == []


@pytest.mark.parametrize("absent", [("10.77.0.9",), ("10.77.0.7", "10.77.0.8"), ("fd00::1",)])
def test_missing_hosts_are_named(absent: tuple[str, ...]) -> None:
    assert findings((*HOSTS, *absent)) == [("missing", absent)]


def test_with_a_number_the_present_ones_are_named() -> None:
    (finding,) = ds.read_capture(HEALTHY).diagnosis(5).findings
    assert finding.kind == "too few hosts"
    assert finding.evidence == (
        "the capture shows 3 of 5 expected hosts (10.77.0.1, 10.77.0.2 and 10.77.0.3)"
    )


@pytest.mark.parametrize(
    ("expected", "message"),
    [
        (0, "expected must be a whole number of at least 1"),
        (("10.0.0.256",), "IP addresses such as 10.0.0.5; got '10.0.0.256'"),
        (("10.0.0.5", "10.0.0.5"), "must have distinct addresses; got '10.0.0.5' twice"),
    ],
)
def test_what_cannot_be_expected_is_refused(expected: int | tuple[str], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        ds.read_capture(HEALTHY).diagnosis(expected)


def test_one_text_is_no_list_of_addresses() -> None:
    with pytest.raises(TypeError, match=r"expected must be a tuple of str; got '10.0.0.5'"):
        ds.read_capture(HEALTHY).diagnosis("10.0.0.5")


def test_missing_hosts_come_first() -> None:
    path = Path(__file__).with_name("captures") / "qos_cyclone_dds.pcap.xz"
    diagnosis = ds.read_capture(path).diagnosis(("10.77.0.1", "10.77.0.5"))
    assert diagnosis.findings[0].kind == "missing"
    assert diagnosis.summary().startswith(
        "Discovery is not healthy: 10.77.0.5 is expected but missing"
    )


#: Real fleets of which hosts were not switched on, were elsewhere, or had fallen silent before.
STAGED = tomllib.loads((ROOT / "lab" / "grids" / "fault_missing_hosts.toml").read_text())
WITHHELD = {name: fleet for name, fleet in STAGED.items() if "absent" in fleet}


@pytest.mark.parametrize("name", WITHHELD)
def test_in_real_fleets_the_missing_hosts_are_named(name: str, tmp_path: Path) -> None:
    absent, count = WITHHELD[name]["absent"], WITHHELD[name].get("hosts", 3)
    path = Path(__file__).with_name("captures") / f"missing_{name}.pcap.xz"
    addresses = [f"10.77.0.{host}" for host in range(1, count + 1)]
    named = run("--expect", ",".join(addresses), path=path)
    missing = [one for one in named["findings"] if one["kind"].startswith("missing")]
    assert [one["hosts"] for one in missing] == [absent]
    # A host that sent other packets is on.
    assert ("on and connected to the Wi-Fi" in missing[0]["advice"]) == (name != "localhost_only")
    assert str(named["summary"]).startswith("Discovery is not healthy: " + join_words(absent))
    # A number or a fleet has no addresses: those that are there are named, or who else is on.
    fleet = tmp_path / "fleet.toml"
    fleet.write_text(f"[[groups]]\nhosts = {count}\nprocesses = 1\nendpoints = 2\n")
    there = join_words([one for one in addresses if one not in absent])
    for expected in (str(count), str(fleet)):
        first = run("--expect", expected, path=path)["findings"][0]
        said = f"the capture shows {count - len(absent)} of {count} expected hosts ({there})"
        own = first["evidence"].split(", not counting 10.77.0.101")[0]  # a server or router
        if name == "localhost_only":
            assert (first["kind"], first["hosts"]) == ("missing, but on", absent)
        else:
            assert (first["kind"], own) == ("too few hosts", said)
    assert not {"missing", "too few hosts"} & {
        one["kind"] for one in run("--expect", str(count - len(absent)), path=path)["findings"]
    }


def test_a_missing_host_that_asks_for_an_address_in_vain_is_told_with_it() -> None:
    """The router of 10.77.0.3 connects to an old address; without --expect it may be any host."""
    capture = ds.read_capture(Path(__file__).with_name("captures") / "router_moved.pcap.xz")
    (event,) = capture.diagnosis().findings
    assert (event.kind, event.about, event.hosts) == ("wrong server", "event", ("10.77.0.3",))
    assert "10.77.0.3 announced nothing, but sent 6 ARP requests for 10.77.0.200" in event.evidence
    first = capture.diagnosis(HOSTS).findings[0]
    assert (first.kind, first.hosts) == ("missing, wrong address", ("10.77.0.3",))
    assert "10.77.0.3 asked for 10.77.0.200 by ARP, and got no answer" in first.evidence
    assert first.advice.startswith(
        "On 10.77.0.3, correct the address of the server, router or peer"
    )


@pytest.mark.parametrize(
    ("name", "expected", "kind", "evidence", "action"),
    [
        (
            "isolated_laptop",
            ("10.77.0.1", "10.77.0.2", "10.77.0.3"),
            "missing, isolated",
            "again and again in vain, but exchanged packets with 10.77.0.102",
            "Turn off client isolation",
        ),
        (
            "uses_docker_interface",
            ("10.77.0.1", "10.77.0.2"),
            "missing, other interface",
            "172.17.0.1 seems to be another address of 10.77.0.2",
            "Run `ip address` on 10.77.0.2, and name the interface",
        ),
        (
            "multicast_blocked_expected",  # 10.77.0.4 sent nothing at all to the recording host
            ("10.77.0.2", "10.77.0.3", "10.77.0.4"),
            "missing, no multicast",
            "10.77.0.2 and 10.77.0.3 sent other packets, so they are on the network",
            "Run `ros2 multicast receive` on a host that was found",
        ),
    ],
)
def test_the_recording_host_shows_why_others_are_missing(
    name: str, expected: tuple[str, ...], kind: str, evidence: str, action: str
) -> None:
    capture = ds.read_capture(Path(__file__).with_name("captures") / f"{name}.pcap.xz")
    first, *others = capture.diagnosis(expected).wrong
    assert (first.kind, others[1:]) == (kind, [])
    assert evidence in first.evidence
    assert first.advice.startswith(action)


def test_a_number_of_hosts_that_is_not_met_names_the_address_that_is_sought_in_vain() -> None:
    path = Path(__file__).with_name("captures") / "peer_at_an_old_address.pcap.xz"
    first = ds.read_capture(path).diagnosis(4).findings[0]
    assert (first.kind, first.hosts) == ("too few hosts, wrong address", ("10.77.0.101",))
    assert "10.77.0.101 for 10.77.0.33" in first.evidence
    assert "10.77.0.3 sent packets of other programs, but announced nothing" in first.evidence
    assert first.advice.startswith("On 10.77.0.101, correct the address")


def test_a_client_of_another_router_may_be_out_of_sight() -> None:
    capture = ds.read_capture(Path(__file__).with_name("captures") / "healthy_router_mesh.pcap.xz")
    found = capture.diagnosis(("10.77.0.1", "10.77.0.101"))
    assert found.healthy
    (limit,) = (one for one in found.findings if one.kind == "maybe missing")
    assert limit.hosts == ("10.77.0.101",)


def test_what_is_wrong_with_a_missing_host_comes_before_general_checks() -> None:
    """Nothing listens on the host that should be the router: its system refuses connections."""
    path = REFERENCE / "captures" / "ills" / "server_never_there-zenoh-router.pcap.xz"
    first, second = ds.read_capture(path).diagnosis(("10.77.0.101",)).wrong
    assert (first.kind, first.hosts) == ("server down", ("10.77.0.101",))
    assert second.kind.startswith("missing")
    assert "10.77.0.101" in second.hosts


def run(*arguments: str, path: Path = HEALTHY) -> dict[str, Any]:
    result = CliRunner().invoke(main, ["capture", str(path), "--json", *arguments])
    assert result.exit_code == 0, result.output
    answer: dict[str, Any] = json.loads(result.stdout)["diagnosis"]
    return answer


def test_a_number_a_list_and_a_fleet_file_say_who_is_expected(tmp_path: Path) -> None:
    fleet = tmp_path / "fleet.toml"
    fleet.write_text("[[groups]]\nhosts = 4\nprocesses = 2\nendpoints = 10\n")
    for arguments in (
        ("--expect", "4"),
        ("--expect", "10.77.0.1,10.77.0.9"),
        ("--expect", str(fleet)),
        ("--fleet", str(fleet)),
    ):
        assert run(*arguments)["healthy"] is False, arguments
    assert run("--expect", "3")["healthy"] is True


def test_a_bad_list_is_refused() -> None:
    result = CliRunner().invoke(main, ["capture", str(HEALTHY), "--expect", "10.0.0.5,robot"])
    assert result.exit_code == 2
    assert "must be a number of hosts, or a list of IP addresses" in result.output


def test_watch_names_the_missing_ones() -> None:
    packets, watch = PacketStream("test"), Watch(expected=(*HOSTS, "10.77.0.9"))
    content = handmade.pcap(handmade.packets("fast_dds"))
    for time, packet in packets.feed(content):
        watch.add_packet(time, packet)
    watch.count_and_diagnose(packets.header)
    assert watch.diagnosis is not None
    assert watch.diagnosis.findings[0].hosts == ("10.77.0.9",)


def test_what_other_packets_show_stands_above_the_number_of_missing_hosts() -> None:
    found = ds.read_capture(
        Path(__file__).with_name("captures") / "no_multicast_at_one_robot.pcap.xz"
    ).diagnosis(4)
    assert [one.kind for one in found.wrong] == ["alone, but connected", "too few hosts"]
    assert "ros2 multicast receive" in found.wrong[0].advice


def test_a_missing_host_of_a_fleet_with_zenoh_is_told_to_look_at_its_router() -> None:
    hosts = tuple(f"10.77.0.{number}" for number in range(1, 5))
    seen = ds.read_capture(Path(__file__).with_name("captures") / "router_not_linked.pcap.xz")
    (found,) = seen.diagnosis(hosts).wrong
    assert (found.kind, found.hosts) == ("missing, no session", ("10.77.0.4",))
    assert "names the router of the others in connect/endpoints" in found.advice


def test_several_hosts_whose_multicast_never_arrives_are_told_of_it() -> None:
    hosts = tuple(f"10.77.0.{number}" for number in range(1, 5))
    path = Path(__file__).with_name("captures") / "no_multicast_from_others.pcap.xz"
    (found,) = ds.read_capture(path).diagnosis(hosts).wrong
    assert (found.kind, found.hosts) == ("missing, no multicast", hosts[2:])
    assert "ros2 multicast receive" in found.advice


def test_the_only_other_hosts_are_taken_for_the_missing_ones() -> None:
    path = Path(__file__).with_name("captures") / "wired_and_wifi_apart.pcap.xz"
    (found,) = ds.read_capture(path).diagnosis(4).wrong
    assert (found.kind, found.hosts) == ("missing, no multicast", ("10.77.0.1", "10.77.0.2"))
    assert "10.77.0.1 and 10.77.0.2, the only other hosts there" in found.evidence
    assert [one.kind for one in ds.read_capture(path).diagnosis(5).wrong] == ["too few hosts"]


def test_robots_of_others_in_the_domain_are_more_hosts_than_expected() -> None:
    path = Path(__file__).with_name("captures") / "two_robots_in_one_domain.pcap.xz"
    found = ds.read_capture(path).diagnosis(1)
    assert (found.wrong[0].kind, found.healthy) == ("too many hosts", False)
    assert found.wrong[0].evidence.startswith("the capture shows ")
    assert "hosts in this domain, of 1 expected; " in found.wrong[0].evidence
    assert found.wrong[0].advice.startswith("Give your robots a ROS_DOMAIN_ID that no other team")
    assert "too many hosts" not in {one.kind for one in ds.read_capture(path).diagnosis(9).findings}
