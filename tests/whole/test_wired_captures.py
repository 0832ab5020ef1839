"""Wired hosts in plans and captures."""

import json
import lzma
from functools import cache
from pathlib import Path

import pytest
from click.testing import CliRunner
from support import REFERENCE

import discostorm as ds
from discostorm.cli import main
from discostorm_capture import Capture

ROBOTS = ds.HostGroup(3, 2, 10, "robots", shared=2)
LAPTOP = ds.HostGroup(2, 1, 4, "laptop", shared=1)
WIRED = ds.HostGroup(2, 1, 4, "laptop", shared=1, wired=True)


def test_a_plan_counts_wired_hosts() -> None:
    plan = ds.plan(ds.Fleet((ROBOTS, WIRED)), ds.DDS, ds.PAPER)
    assert plan.utilization == ds.utilization(ds.DDS, ds.Fleet((ROBOTS, WIRED)))
    assert plan.utilization < ds.plan(ds.Fleet((ROBOTS, LAPTOP)), ds.DDS, ds.PAPER).utilization


# ---------------------------------------------------------------- captures

CAPTURES = REFERENCE / "captures"
SERVER = "10.77.0.101"


@cache
def captured(name: str) -> Capture:
    return ds.read_capture(CAPTURES / f"{name}.pcap.xz")


@pytest.mark.parametrize(
    ("name", "table", "processes"),
    [
        ("fast_dds_server", "Fast DDS Discovery Server", 2),
        ("fast_dds_server_matching", "Fast DDS Discovery Server", 1),
        ("zenoh_router", "Zenoh router", 2),
    ],
)
def test_a_wired_server_is_no_robot_and_counts_agree(name: str, table: str, processes: int) -> None:
    capture = captured(name)
    assert list(capture.processes()["server"]).count(True) == 1
    assert capture.servers() == (SERVER,)
    assert capture.vantage_host() is None
    assert capture.fleet() == ds.Fleet.swarm(3, processes, 10)
    assert not any("announcement" in note for note in capture.notes)
    rows = capture.compare(ds.PROTOCOLS[table])
    counted = rows.loc[rows["units"].notna(), ["expected", "unicast", "multicast"]].sum()
    assert counted["unicast"] + counted["multicast"] == pytest.approx(counted["expected"], rel=0.1)


@pytest.mark.parametrize(
    ("old", "new"), [(b"DS\0_EPROSIMA", b"DX\0_EPROSIMA"), (b"\0SERVER\0", b"\0SIMPLE\0")]
)
def test_a_discovery_server_is_known_by_its_type_or_its_prefix(
    old: bytes, new: bytes, tmp_path: Path
) -> None:
    raw = lzma.decompress((CAPTURES / "fast_dds_server.pcap.xz").read_bytes())
    assert old in raw
    path = tmp_path / "a.pcap"
    path.write_bytes(raw.replace(old, new))
    assert ds.read_capture(path).servers() == (SERVER,)
    path.write_bytes(
        raw.replace(old, new).replace(b"\0SERVER\0", b"\0SIMPLE\0").replace(b"DS\0_E", b"DX\0_E")
    )
    assert ds.read_capture(path).servers() == ()


def test_the_view_of_one_client_is_not_that_of_its_server(tmp_path: Path) -> None:
    raw = lzma.decompress((CAPTURES / "fast_dds_server_matching.pcap.xz").read_bytes())
    parts, at = [raw[:24]], 24
    while at < len(raw):
        size = int.from_bytes(raw[at + 8 : at + 12], "little")
        packet = raw[at : at + 16 + size]
        if bytes([10, 77, 0, 1]) in (packet[42:46], packet[46:50]):
            parts.append(packet)
        at += 16 + size
    path = tmp_path / "a.pcap"
    path.write_bytes(b"".join(parts))
    capture = ds.read_capture(path)
    assert capture.vantage_host() == "10.77.0.1"
    assert capture.fleet() == ds.Fleet.swarm(3, 1, 10)


def test_one_hop_is_charged_to_a_wired_host() -> None:
    capture = captured("fast_dds_server")
    table = ds.PROTOCOLS["Fast DDS Discovery Server"]
    both = capture.airtime(wired=())
    assert capture.airtime().to_numpy() == pytest.approx(both.to_numpy() / 2)
    assert capture.airtime(wired=(SERVER,)).equals(capture.airtime())
    # What the model says of the same fleet, over what was captured.
    seconds = capture.compare(table)["airtime_s"].sum()
    window = capture.duration
    model = ds.utilization(table, capture.fleet(), window=window) * window
    assert seconds == pytest.approx(model, rel=0.15)


def test_a_server_on_a_robot_comes_first() -> None:
    capture = captured("fast_dds_server")
    fleet = capture.fleet(wired=())
    assert [group.hosts for group in fleet.groups] == [1, 3]
    table = ds.PROTOCOLS["Fast DDS Discovery Server, on a robot"]
    rows = capture.compare(table, wired=())
    total = rows["unicast"].sum() + rows["multicast"].sum()
    assert total == pytest.approx(rows["expected"].sum(), rel=0.1)


def test_other_hosts_that_are_wired() -> None:
    capture = captured("fast_dds_server")
    fleet = capture.fleet(wired=(SERVER, "10.77.0.2"))
    assert [(group.hosts, group.wired) for group in fleet.groups] == [(1, True), (2, False)]
    # From wire to wire nothing takes the air.
    rows = capture.messages()
    inside = rows[["sender", "receiver"]].isin([SERVER, "10.77.0.2"]).all(axis=1)
    seconds = capture.airtime(wired=(SERVER, "10.77.0.2"))
    assert (seconds[inside] == 0).all()
    assert (seconds[~inside] > 0).all()
    with pytest.raises(ValueError, match=r"wired must list addresses .* got '10\.0\.0\.9'"):
        capture.fleet(wired=("10.0.0.9",))
    with pytest.raises(TypeError, match="wired must be"):
        capture.airtime(wired=SERVER)


def test_zenoh_over_udp_is_counted_as_over_tcp() -> None:
    capture = captured("zenoh_udp")
    assert capture.notes == ()
    rows = capture.messages()
    udp = rows[rows["transport"] == "UDP"]
    # 2179 datagrams, of which 12 are in 156 fragments of IP; counted without this reader.
    assert udp["bytes"].sum() == 829_397
    assert udp["frames"].sum() == pytest.approx(2323)
    assert capture.fleet() == ds.Fleet.swarm(2, 2, 400)
    table = capture.compare(ds.PROTOCOLS["Zenoh peer, tokens"])
    for kind in ("Declare", "Declare key expression", "Declare final", "Scout", "Hello"):
        assert table.loc[kind, ["unicast", "multicast"]].sum() == table.loc[kind, "expected"], kind


def test_the_command_line_names_who_is_wired() -> None:
    def run(*options: str) -> str:
        file = str(CAPTURES / "fast_dds_server.pcap.xz")
        table = ["--against", "Fast DDS Discovery Server"]
        result = CliRunner().invoke(main, ["capture", file, *table, *options])
        assert result.exit_code == 0, result.output
        return result.output

    shown = run()
    assert "hosts: 3 with 2 processes of 10 endpoints each\n" in shown
    assert f"Note: We count {SERVER} as wired, because only servers or routers" in shown
    assert "only unicast from" not in shown
    assert "endpoints each, wired" in run("--wired", SERVER, "--wired", "10.77.0.3")
    told = json.loads(run("--json"))
    assert told["wired"] == [SERVER]
    none = json.loads(run("--json", "--wired", "none"))
    assert none["wired"] == []
    sums = [sum(row["airtime_s"] for row in answer["messages"]) for answer in (told, none)]
    assert sums[1] == pytest.approx(2 * sums[0])
    file = str(CAPTURES / "fast_dds_server.pcap.xz")
    wrong = CliRunner().invoke(main, ["capture", file, "--wired", "none", "--wired", SERVER])
    assert wrong.exit_code == 2
    assert "'none' must stand alone" in wrong.output
