"""Test endpoints that always match: every function takes them from the fleet."""

import math
from dataclasses import replace
from pathlib import Path

import pytest

import discostorm as ds
from discostorm.drain_times import drain_time
from discostorm.messages import UNITS
from discostorm.model import burst, utilization_without_each_group
from discostorm.robots import laptop, robots

SHARES_NOTHING = ds.Fleet.swarm(5, 2, 100)
SHARES_ROS2 = ds.Fleet((replace(SHARES_NOTHING.groups[0], shared=14),))
FLEETS = {"nothing": SHARES_NOTHING, "ROS 2": SHARES_ROS2}

each_table = pytest.mark.parametrize("protocol", ds.PROTOCOLS.values(), ids=list(ds.PROTOCOLS))


@each_table
@pytest.mark.parametrize("fleet", FLEETS.values(), ids=list(FLEETS))
def test_all_functions_count_the_same_fleet(protocol: ds.Protocol, fleet: ds.Fleet) -> None:
    used = ds.utilization(protocol, fleet)
    table = ds.breakdown(protocol, fleet)
    # Other orders of the same sums.
    assert (table["uplink_s"] + table["downlink_s"]).sum() == pytest.approx(used, rel=1e-12)
    two = ds.Fleet((replace(fleet.groups[0], hosts=2), replace(fleet.groups[0], hosts=3)))
    if UNITS["endpoint of a kind of host"] not in protocol.units():  # of which two groups have more
        assert ds.utilization(protocol, two) == pytest.approx(used, rel=1e-12)
    alone = ds.utilization(protocol, replace(two, groups=two.groups[1:]))
    assert utilization_without_each_group(protocol, two)[0] == pytest.approx(alone, rel=1e-12)
    start, steady = burst(protocol, fleet), ds.utilization(protocol, fleet, window=math.inf)
    if steady < 1:
        assert drain_time(protocol, fleet) == pytest.approx(start / (1 - steady), rel=1e-12)
    if used > 0:
        assert ds.saturation_hosts(protocol, limit=used, fleet=fleet) == pytest.approx(5, rel=1e-9)


@each_table
def test_plain_numbers_share_nothing(protocol: ds.Protocol) -> None:
    assert ds.utilization(protocol, 5, 2, 100) == ds.utilization(protocol, SHARES_NOTHING)
    assert ds.saturation_hosts(protocol, 2, 100, limit=99) == ds.saturation_hosts(
        protocol, limit=99, fleet=SHARES_NOTHING
    )
    shared = ds.utilization(protocol, SHARES_ROS2)
    if protocol.name in ("DDS", "Zenoh"):  # the paper counts no names
        assert shared == ds.utilization(protocol, SHARES_NOTHING)


def test_a_server_introduces_those_who_share_a_topic() -> None:
    server = ds.PROTOCOLS["Fast DDS Discovery Server"]
    apart, together = (ds.utilization(server, fleet) for fleet in FLEETS.values())
    assert apart == pytest.approx(0.207, abs=5e-4)
    assert together > 4 * apart


def test_files_and_ready_made_robots_share_unless_they_say_otherwise(tmp_path: Path) -> None:
    path = tmp_path / "fleet.toml"
    group = "[[groups]]\nhosts = 5\nprocesses = 2\nendpoints = 100\n"
    for told, shared in [("", 2 + 2 * 3), ("nodes = 6\n", 14), ("nodes = 0\n", 2)]:
        path.write_text(group + told)
        (found,) = ds.Fleet.from_toml(path).groups
        # Ready-made robots have a node for every 28 endpoints or so.
        assert found.shared == pytest.approx(shared, abs=0.0 if told else 1.5)
    path.write_text(group + "shared = 0\n")
    assert ds.Fleet.from_toml(path) == SHARES_NOTHING
    assert all(host.shared > 0 for host in (*robots().values(), laptop()))
