"""Test wired hosts, whose own hop takes no airtime."""

import itertools
import pickle

import numpy as np
import pytest

import discostorm as ds
from discostorm.messages import HOPS, Message
from discostorm.model import burst, utilization_without_each_group

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
            assert message.per_unit * message.wireless_unit(hop).count(fleet) == count, (
                message.name,
                hop,
            )
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


def test_wired_groups_of_fleet_files() -> None:
    text = b"[[groups]]\nhosts = 1\nprocesses = 1\nendpoints = 0\nwired = true\n"
    fleet = ds.Fleet.from_bytes(text, "a.toml")
    assert fleet.groups == (ds.HostGroup(1, 1, 0, wired=True),)
    assert fleet.groups != ds.Fleet.swarm(1, 1, 0).groups
    assert pickle.loads(pickle.dumps(fleet)) == fleet
    assert "wired=True" in repr(fleet)
    assert fleet.to_dicts()[0]["wired"] is True
    assert "wired" not in ds.Fleet.swarm(1, 1, 0).to_dicts()[0]
    with pytest.raises(ValueError, match=r"a\.toml: group 1: wired must be true or false; got 1"):
        ds.Fleet.from_bytes(text.replace(b"true", b"1"), "a.toml")
    with pytest.raises(TypeError, match="wired"):
        ds.HostGroup(1, 1, 0, wired=1)  # type: ignore[arg-type]


def test_arrays_of_wired_fleets() -> None:
    hosts = np.array([2.0, 5.0])
    fleet = ds.Fleet((ds.HostGroup(hosts, 2, 10), WIRED))
    each = [ds.utilization(ds.ZENOH, ds.Fleet((ds.HostGroup(n, 2, 10), WIRED))) for n in hosts]
    assert ds.utilization(ds.ZENOH, fleet) == pytest.approx(each)


@pytest.mark.parametrize("table", ds.PROTOCOLS.values(), ids=list(ds.PROTOCOLS))
@pytest.mark.parametrize("wired", [False, True])
@pytest.mark.parametrize("hosts", [1, 3])
def test_one_host_and_fleets_without_wireless_hosts_have_answers(
    table: ds.Protocol, wired: bool, hosts: int
) -> None:
    fleet = ds.Fleet((ds.HostGroup(hosts, 2, 10, shared=2, wired=wired),))
    used = ds.utilization(table, fleet)
    rows = ds.breakdown(table, fleet)
    assert rows["uplink_s"].sum() + rows["downlink_s"].sum() == pytest.approx(used)
    low, high = ds.bounds(table, fleet)
    assert low <= used * (1 + 1e-12) <= high * (1 + 1e-9)
    assert ds.drain_time(table, fleet) >= burst(table, fleet)
    assert ds.utilization(table, fleet, phase="data") == 0
    full = ds.saturation_hosts(table, fleet=fleet)
    if wired:
        assert used == ds.drain_time(table, fleet) == 0
        assert full == float("inf")
    else:
        assert full >= 1


def test_a_wired_server_sends_over_the_air_to_wireless_processes_alone() -> None:
    """Six processes of ten endpoints on the air, one of forty on the wire; all of them match."""
    fleet = ds.Fleet((ds.HostGroup(3, 2, 10), ds.HostGroup(1, 1, 40, wired=True)), matching=1)
    unit = ds.Unit("matched endpoint", "other process")
    row = next(m for m in ds.PROTOCOLS["Fast DDS Discovery Server"].messages if m.unit == unit)
    assert len(row.hops) == 1
    assert row.wireless_unit(row.hops[0]).count(fleet) == 6 * (6 * 10 + 40 - 10)


def test_without_each_group_the_rest_are_counted_with_their_wires() -> None:
    groups = (ROBOTS, WIRED, ds.HostGroup(2, 2, 6, "arms"))
    for table in (ds.DDS, ds.PROTOCOLS["Fast DDS"]):
        expected = [
            ds.utilization(table, ds.Fleet(groups[:index] + groups[index + 1 :]))
            for index in range(len(groups))
        ]
        assert utilization_without_each_group(table, ds.Fleet(groups)) == pytest.approx(
            expected, rel=1e-12
        )
    assert utilization_without_each_group(ds.DDS, ds.Fleet((ROBOTS,))) == [0.0]
