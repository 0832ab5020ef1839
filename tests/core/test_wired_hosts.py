"""Wired hosts take the air on no hop of their own, and all else is as it was."""

import itertools
import json
import lzma
import pickle
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner
from support import REFERENCE

import discostorm as ds
from discostorm.cli import main
from discostorm.messages import HOPS, Message
from discostorm.model import burst
from discostorm_capture import Capture

ROBOTS = ds.HostGroup(3, 2, 10, "robots", shared=2)
LAPTOP = ds.HostGroup(2, 1, 4, "laptop", shared=1)
WIRED = ds.HostGroup(2, 1, 4, "laptop", shared=1, wired=True)


def by_hand(message: Message, fleet: ds.Fleet, hop: str) -> float:
    """Return how many messages of the paper's units take the air on a hop, host by host."""
    hosts = [
        (group.processes, group.endpoints, group.wired)
        for group in fleet.groups
        for _ in range(int(group.hosts))
    ]
    each = {"process": lambda host: host[0], "endpoint": lambda host: host[0] * host[1]}
    sent = 0.0
    for own in range(len(hosts)):
        many = message.per_unit * each[message.unit.what](hosts[own])
        if message.unit.to == "all":
            heard = not hosts[own][2] if hop == "up" else not all(host[2] for host in hosts)
            sent += many * heard
            continue
        for other in set(range(len(hosts))) - {own}:
            wired = hosts[own if hop == "up" else other][2]
            sent += many * hosts[other][0] * (not wired)
    return sent


@pytest.mark.parametrize("name", ["DDS", "Zenoh"])
@pytest.mark.parametrize(
    "fleet",
    [
        ds.Fleet((ROBOTS, WIRED)),
        ds.Fleet((WIRED, ROBOTS)),
        ds.Fleet((WIRED,)),
        ds.Fleet((ds.HostGroup(1, 3, 7), WIRED, ds.HostGroup(2, 1, 0, wired=True))),
    ],
)
def test_hops_of_wired_hosts_by_hand(name: str, fleet: ds.Fleet) -> None:
    table = ds.PROTOCOLS[name]
    seconds = 0.0
    for message in table.messages:
        for hop in HOPS:
            count = by_hand(message, fleet, hop)
            assert message.per_unit * message.on_air(hop).count(fleet) == count, (message.name, hop)
            airtime = message.airtime_of(hop).subs(table.values() | ds.PAPER.values())
            seconds += count * float(airtime)
    assert ds.utilization(table, fleet) == pytest.approx(seconds)
    assert burst(table, fleet) == pytest.approx(seconds)
    rows = ds.breakdown(table, fleet)
    assert rows["uplink_s"].sum() + rows["downlink_s"].sum() == pytest.approx(seconds)
    least, greatest = ds.bounds(table, fleet)
    assert least <= seconds <= greatest
    assert float(
        table.utilization(fleet=fleet).subs(table.values() | ds.PAPER.values())
    ) == pytest.approx(seconds)


def test_half_of_what_a_wired_host_sends_by_unicast_is_saved() -> None:
    wireless, wired = (
        ds.Fleet((ds.HostGroup(1, 1, 10), ds.HostGroup(1, 1, 10, wired=of))) for of in (False, True)
    )
    phase = "SEDP"
    assert ds.utilization(ds.DDS, wired, phase=phase) == pytest.approx(
        ds.utilization(ds.DDS, wireless, phase=phase) / 2
    )


@pytest.mark.parametrize("name", list(ds.PROTOCOLS))
def test_every_table_costs_less_the_more_hosts_are_wired(name: str) -> None:
    table = ds.PROTOCOLS[name]
    for matching in (0.0, 1.0):
        some = [
            ds.utilization(table, ds.Fleet(groups, matching))
            for groups in ((ROBOTS, LAPTOP), (ROBOTS, WIRED))
        ]
        assert 0 < some[1] < some[0]
        on_wires = [ds.HostGroup(*group.counts(), wired=True) for group in (ROBOTS, LAPTOP)]
        assert ds.utilization(table, ds.Fleet(tuple(on_wires), matching)) == 0


def test_of_a_server_s_table_a_wired_client_is_not_on_the_air() -> None:
    table = ds.PROTOCOLS["Fast DDS Discovery Server"]
    beside = ds.utilization(
        table, ds.Fleet((ds.HostGroup(3, 2, 10), ds.HostGroup(2, 2, 10, wired=True)))
    )
    # Nothing matches: the server tells the robots nothing of it.
    assert beside == pytest.approx(ds.utilization(table, ds.Fleet.swarm(3, 2, 10)))
    # Everything matches: robots are told of its endpoints, it is told nothing over the air.
    alike = ds.Fleet((ds.HostGroup(3, 2, 10), ds.HostGroup(2, 2, 10, wired=True)), 1)
    alone, all_ = (ds.utilization(table, ds.Fleet.swarm(hosts, 2, 10)) for hosts in (3, 5))
    matched = ds.utilization(table, ds.Fleet(ds.Fleet.swarm(5, 2, 10).groups, 1))
    assert alone < ds.utilization(table, alike) < matched
    assert all_ < matched


def test_saturation_beside_wired_hosts() -> None:
    for groups, group in itertools.product([(ROBOTS, WIRED), (WIRED, ROBOTS)], ["robots"]):
        fleet = ds.Fleet(groups)
        hosts = ds.saturation_hosts(ds.DDS, fleet=fleet, group=group)
        grown = tuple(
            ds.HostGroup(hosts, 2, 10, "robots") if one.name == group else one for one in groups
        )
        assert ds.utilization(ds.DDS, ds.Fleet(grown)) == pytest.approx(1)
        more = ds.saturation_hosts(ds.DDS, fleet=ds.Fleet((ROBOTS, LAPTOP)), group=group)
        assert hosts > more


def test_a_plan_counts_wired_hosts() -> None:
    plan = ds.plan(ds.Fleet((ROBOTS, WIRED)), ds.DDS, ds.PAPER)
    assert plan.utilization == ds.utilization(ds.DDS, ds.Fleet((ROBOTS, WIRED)))
    assert plan.utilization < ds.plan(ds.Fleet((ROBOTS, LAPTOP)), ds.DDS, ds.PAPER).utilization


def test_the_simulator_refuses_wired_hosts_by_name() -> None:
    with pytest.raises(
        ValueError, match=r"wired must be False for a simulation.* got True for lapt"
    ):
        ds.simulate(ds.Fleet((ROBOTS, WIRED)), ds.DDS, ds.PAPER, recovery=False)


def test_wired_groups_of_fleet_files() -> None:
    text = b"[[groups]]\nhosts = 1\nprocesses = 1\nendpoints = 0\nwired = true\n"
    fleet = ds.Fleet.from_bytes(text, "a.toml")
    assert fleet.groups == (ds.HostGroup(1, 1, 0, wired=True),)
    assert fleet.groups != ds.Fleet.swarm(1, 1, 0).groups
    assert pickle.loads(pickle.dumps(fleet)) == fleet
    assert "wired=True" in repr(fleet)
    assert fleet.described()[0]["wired"] is True
    assert "wired" not in ds.Fleet.swarm(1, 1, 0).described()[0]
    with pytest.raises(ValueError, match=r"a\.toml: group 1: wired must be true or false; got 1"):
        ds.Fleet.from_bytes(text.replace(b"true", b"1"), "a.toml")
    with pytest.raises(TypeError, match="wired"):
        ds.HostGroup(1, 1, 0, wired=1)  # type: ignore[arg-type]


def test_arrays_of_wired_fleets() -> None:
    hosts = np.array([2.0, 5.0])
    fleet = ds.Fleet((ds.HostGroup(hosts, 2, 10), WIRED))
    each = [ds.utilization(ds.ZENOH, ds.Fleet((ds.HostGroup(n, 2, 10), WIRED))) for n in hosts]
    assert ds.utilization(ds.ZENOH, fleet) == pytest.approx(each)


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
    assert capture.serving() == (SERVER,)
    assert capture.view() is None
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
    assert ds.read_capture(path).serving() == (SERVER,)
    path.write_bytes(
        raw.replace(old, new).replace(b"\0SERVER\0", b"\0SIMPLE\0").replace(b"DS\0_E", b"DX\0_E")
    )
    assert ds.read_capture(path).serving() == ()


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
    assert capture.view() == "10.77.0.1"
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
    with pytest.raises(ValueError, match=r"wired must have addresses .* got '10\.0\.0\.9'"):
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
    assert f"Note: {SERVER}: nothing but servers or routers, taken for wired" in shown
    assert "seen from" not in shown
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
    assert "none must be the only one" in wrong.output
