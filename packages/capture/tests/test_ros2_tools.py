"""What ROS 2's tools get: tested against stubs of ros2cli, as ROS 2 is not here."""

import argparse
import io
import lzma
import re
import sys
import tomllib
from collections.abc import Iterator
from contextlib import contextmanager
from importlib import import_module
from pathlib import Path
from types import ModuleType, SimpleNamespace
from xml.etree import ElementTree

import pytest
from handmade_captures import CAPTURES
from support import REFERENCE, ROOT

from discostorm.cli.output import BadInput
from discostorm_capture import read_capture, ros2_tools

PACKAGE = ROOT / "packages" / "capture"
#: A port of a process in domain 0, two for each process.
FIRST_PORT = 7410
HEADER = "  sl  local_address rem_address   st tx_queue rx_queue inode ref pointer drops\n"


class Result:
    """As ros2doctor.api.Result."""

    def __init__(self) -> None:
        self.error = self.warning = 0

    def add_warning(self) -> None:
        self.warning += 1


class Report:
    """As ros2doctor.api.Report."""

    def __init__(self, name: str) -> None:
        self.name = name
        self.items: list[tuple[str, str]] = []

    def add_to_report(self, item_name: str, item_info: str) -> None:
        self.items.append((item_name, item_info))


@pytest.fixture
def said(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Stubs of ros2doctor, whose warnings it lists."""
    warnings: list[str] = []
    modules = {name: ModuleType(name) for name in ("ros2doctor", "ros2doctor.api")}
    vars(modules["ros2doctor.api"]).update(Result=Result, Report=Report)
    modules["ros2doctor.api.format"] = ModuleType("ros2doctor.api.format")
    vars(modules["ros2doctor.api.format"]).update(doctor_warn=warnings.append)
    for name, module in modules.items():
        monkeypatch.setitem(sys.modules, name, module)
    return warnings


@pytest.fixture(autouse=True)
def host(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A healthy host in a healthy fleet of three others, with settings that fit it."""
    (tmp_path / "net").mkdir()
    (tmp_path / "sys/net/core").mkdir(parents=True)
    for name in ("rmem_default", "rmem_max"):
        (tmp_path / "sys/net/core" / name).write_text("212992\n")
    monkeypatch.setattr(ros2_tools, "PROC", tmp_path)
    monkeypatch.setattr(ros2_tools, "RECORDING_TIME", 0.0)
    for name in [name for name in ros2_tools.os.environ if re.match("ROS_|RMW_", name)]:
        monkeypatch.delenv(name)
    record(monkeypatch, CAPTURES / "fast_dds.pcap.xz")
    ros2_tools.run_checks.cache_clear()
    return tmp_path


def record(monkeypatch: pytest.MonkeyPatch, path: Path) -> None:
    """Let the tools record what a file holds."""

    @contextmanager
    def pcap_of(interface: str) -> Iterator[io.BytesIO]:
        assert interface == "any"
        yield io.BytesIO(lzma.decompress(path.read_bytes()))

    monkeypatch.setattr(ros2_tools, "open_pcap", pcap_of)
    monkeypatch.setattr(ros2_tools, "read_chunks", lambda source: [source.read()])


def sockets(host: Path, *ports_and_drops: tuple[int, int]) -> None:
    """Write ``/proc/net/udp`` of a host."""
    rows = (
        f" 1: 00000000:{port:04X} 00000000:0000 07 0:0 0 2 0 {drops}\n"
        for port, drops in ports_and_drops
    )
    (host / "net" / "udp").write_text(HEADER + "".join(rows))


def warnings_of_check(said: list[str]) -> list[str]:
    ros2_tools.run_checks.cache_clear()
    result = ros2_tools.Discovery().check()
    assert (result.error, result.warning) == (0, len(said))
    return said


def test_a_healthy_host_gives_no_warning_and_a_report(host: Path, said: list[str]) -> None:
    sockets(host, (FIRST_PORT, 0), (7400, 0), (40000, 0))
    assert warnings_of_check(said) == []
    report = ros2_tools.Discovery().report()
    assert report.name == "DISCOVERY"
    assert report.items == [
        (what, "nothing is wrong")
        for what in (
            *("UDP buffers", "processes on this host", "settings of this shell", "traffic"),
        )
    ]


@pytest.mark.parametrize(
    ("settings", "warning"),
    [
        (
            {"ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST"},
            "ROS_AUTOMATIC_DISCOVERY_RANGE is LOCALHOST, but 3 hosts can be heard",
        ),
        (
            {"ROS_AUTOMATIC_DISCOVERY_RANGE": "OFF", "ROS_STATIC_PEERS": "10.77.0.1"},
            "ROS_AUTOMATIC_DISCOVERY_RANGE is OFF, but 3 hosts can be heard",
        ),
        ({"ROS_LOCALHOST_ONLY": "1"}, "ROS_LOCALHOST_ONLY is 1, but 3 hosts can be heard"),
        (
            {"ROS_STATIC_PEERS": "10.77.0.1;10.77.0.9"},
            "ROS_STATIC_PEERS lists 10.77.0.9, but no process speaks there",
        ),
        (
            {"RMW_IMPLEMENTATION": "rmw_zenoh_cpp"},
            "RMW_IMPLEMENTATION is rmw_zenoh_cpp here, but other hosts speak only DDS",
        ),
        ({"ROS_DOMAIN_ID": "7"}, "ROS_DOMAIN_ID is 7 here, but other hosts use 0"),
    ],
)
def test_a_setting_unlike_the_network_is_told(
    said: list[str],
    monkeypatch: pytest.MonkeyPatch,
    settings: dict[str, str],
    warning: str,
) -> None:
    for name, value in settings.items():
        monkeypatch.setenv(name, value)
    assert warnings_of_check(said) == [f"settings of this shell: {warning}"]


@pytest.mark.parametrize(
    "settings",
    [
        {"ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST", "ROS_STATIC_PEERS": "10.77.0.1"},
        {"RMW_IMPLEMENTATION": "rmw_cyclonedds_cpp", "ROS_DOMAIN_ID": "0"},
        {"ROS_AUTOMATIC_DISCOVERY_RANGE": "SUBNET", "ROS_DOMAIN_ID": ""},
    ],
)
def test_a_setting_that_fits_is_not_told(
    said: list[str], monkeypatch: pytest.MonkeyPatch, settings: dict[str, str]
) -> None:
    for name, value in settings.items():
        monkeypatch.setenv(name, value)
    assert warnings_of_check(said) == []


def test_sockets_that_drop_are_told_with_the_buffers(host: Path, said: list[str]) -> None:
    sockets(host, (FIRST_PORT, 3), (FIRST_PORT + 1, 4))
    (warning,) = warnings_of_check(said)
    assert warning.startswith("UDP buffers: sockets dropped 7 datagrams")
    assert "net.core.rmem_default is 212992 B; net.core.rmem_max is 212992 B" in warning


@pytest.mark.parametrize(("processes", "is_told"), [(100, False), (101, True)])
def test_more_than_a_hundred_processes_of_a_domain_are_told(
    host: Path, said: list[str], processes: int, is_told: bool
) -> None:
    sockets(host, *((FIRST_PORT + number, 0) for number in range(2 * processes)))
    text = (
        "processes on this host: 101 processes in domain 0, in which Fast DDS tries only 100 ports"
    )
    assert warnings_of_check(said) == [f"{text} (mutation_tries)"] * is_told


def test_what_the_traffic_shows_is_told_as_the_diagnosis_tells_it(
    said: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    path = REFERENCE / "captures" / "ills" / "firewall_on_one_host-cyclone_dds_0_10.pcap.xz"
    record(monkeypatch, path)
    (finding,) = read_capture(path).diagnosis().wrong
    (warning,) = warnings_of_check(said)
    assert warning == f"traffic: {finding.summary}: {finding.evidence}. {finding.advice}"


def test_without_the_right_to_capture_it_says_so_and_checks_the_rest(
    host: Path, said: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(_: str) -> None:
        raise BadInput("tcpdump cannot capture on any: run it with sudo")

    monkeypatch.setattr(ros2_tools, "open_pcap", refuse)
    sockets(host, (FIRST_PORT, 1))
    drops, traffic = warnings_of_check(said)
    assert drops.startswith("UDP buffers: sockets dropped 1 datagram, ")
    assert traffic == "traffic: not checked: tcpdump cannot capture on any: run it with sudo"


def test_the_command_passes_its_words_on(capsys: pytest.CaptureFixture[str]) -> None:
    command, parser = ros2_tools.DiscostormCommand(), argparse.ArgumentParser()
    command.add_arguments(parser, "ros2 discostorm", argv=[])
    with pytest.raises(SystemExit) as ended:
        command.main(parser=parser, args=parser.parse_args(["robots", "--json"]))
    assert (ended.value.code, capsys.readouterr().out[0]) == (0, "[")
    with pytest.raises(SystemExit) as ended:
        command.main(parser=parser, args=SimpleNamespace(words=[]))
    assert ended.value.code == 0
    assert "Usage: ros2 discostorm" in capsys.readouterr().out


def test_the_entry_points_name_what_is_there_and_colcon_finds_the_package() -> None:
    project = tomllib.loads((PACKAGE / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    for group in ("ros2doctor.checks", "ros2doctor.report", "ros2cli.command"):
        for target in project["entry-points"][group].values():
            module, _, name = target.partition(":")
            assert hasattr(import_module(module), name)
    package = ElementTree.parse(PACKAGE / "package.xml").getroot()
    assert package.findtext("name") == project["name"].replace("-", "_")
    assert project["version"].startswith(package.findtext("version", ""))
    assert package.findtext("export/build_type") == "ament_python"
