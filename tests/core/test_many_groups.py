"""Fleets of very many groups: the same answers, in time that grows with the groups."""

import time
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

import discostorm as ds
from discostorm._numeric import evaluate
from discostorm.model import utilization_without_each_group
from discostorm.saturation import saturation
from discostorm.uncertainty import bounds

PROTOCOLS = (ds.DDS, ds.ZENOH)
SERVER_ON_A_ROBOT = ds.PROTOCOLS["Fast DDS Discovery Server, on a robot"]
ROUTERS = ds.PROTOCOLS["Zenoh router per host"]


def fleet(groups: int) -> ds.Fleet:
    return ds.Fleet(
        tuple(
            ds.HostGroup(1 + index % 4, 1 + index % 3, 7 * index % 101, name=f"g{index}")
            for index in range(groups)
        )
    )


def half_wired(members: ds.Fleet) -> ds.Fleet:
    return ds.Fleet(tuple(replace(g, wired=i % 2 == 0) for i, g in enumerate(members.groups)))


@pytest.mark.parametrize("protocol", PROTOCOLS, ids=lambda protocol: protocol.name)
@pytest.mark.parametrize("wifi", [ds.PAPER, ds.WIFI["802.11ac 80 MHz 2x2"]], ids=["paper", "ac"])
def test_counted_numbers_are_those_of_the_symbols(protocol: ds.Protocol, wifi: ds.Wifi) -> None:
    few = fleet(4)
    symbols = ds.Fleet.symbolic(4).counts()
    given = dict(zip(symbols, few.counts(), strict=True)) | protocol.values() | wifi.values()
    for phase in (None, *protocol.phases):
        closed = evaluate(
            protocol.utilization(phase, ds.Fleet.symbolic(4), model=wifi.model), given
        )
        # Another order of the same sums.
        assert ds.utilization(protocol, few, wifi=wifi, phase=phase) == pytest.approx(
            closed, rel=1e-13
        )
    host = dict(zip(ds.Fleet.symbolic(1).counts()[1:], (2.0, 10.0), strict=True))
    (limit,) = (symbol for symbol in saturation(protocol).free_symbols if symbol.name == "U_limit")
    closed = evaluate(saturation(protocol, wifi.model, 4), given | host | {limit: 99.0})
    grown = ds.Fleet((ds.HostGroup(1, 2, 10), *few.groups))
    found = ds.saturation_hosts(protocol, wifi=wifi, limit=99, fleet=grown)
    assert found == pytest.approx(closed, rel=1e-13)


@pytest.mark.parametrize(
    "task",
    [
        lambda members: ds.utilization(ds.DDS, members),
        lambda members: ds.saturation_hosts(ds.ZENOH, limit=1e9, fleet=members),
        lambda members: bounds(ds.ZENOH, members),
        lambda members: ds.utilization(SERVER_ON_A_ROBOT, members),
        lambda members: ds.utilization(ROUTERS, members),
        lambda members: ds.utilization(ds.PROTOCOLS["Fast DDS"], half_wired(members)),
    ],
    ids=["utilization", "saturation", "bounds", "what matches of others", "hosts", "wired"],
)
def test_ten_times_the_groups_take_about_ten_times_as_long(
    task: Callable[[ds.Fleet], object],
) -> None:
    task(fleet(10))  # compiles, and imports what only the first call needs

    def least(groups: int) -> float:
        taken = []
        for _ in range(5):
            members = fleet(groups)  # a new one, which has counted nothing yet
            start = time.process_time()
            task(members)
            taken.append(time.process_time() - start)
        return min(taken)

    # Quadratic would be a hundred times as long.
    assert least(2000) < 40 * least(200)


def test_without_each_is_the_fleet_without_each() -> None:
    for groups in (2, 30):
        members = fleet(groups)
        rests = utilization_without_each_group(ds.DDS, members)
        assert len(rests) == groups
        for index in (0, 1, groups // 2, groups - 1):
            rest = ds.Fleet(members.groups[:index] + members.groups[index + 1 :])
            assert rests[index] == pytest.approx(ds.utilization(ds.DDS, rest), rel=1e-12)
    assert utilization_without_each_group(ds.DDS, fleet(1)) == [0]


def test_a_fleet_of_arrays_beside_many_hosts_broadcasts() -> None:
    host = ds.HostGroup(1, 2, 10)
    many = ds.Fleet((host, ds.HostGroup([1, 2, 3], 1, 90), ds.HostGroup(1, 1, [[0], [10]])))
    found = np.asarray(ds.saturation_hosts(ds.DDS, limit=9, fleet=many))
    assert found.shape == (2, 3)
    one = ds.Fleet((host, ds.HostGroup(2, 1, 90), ds.HostGroup(1, 1, 10)))
    assert found[1, 1] == ds.saturation_hosts(ds.DDS, limit=9, fleet=one)


def test_what_does_not_depend_on_a_count_still_has_its_shape() -> None:
    many = ds.Fleet((ds.HostGroup(2, 1, [1, 2, 3]), ds.HostGroup(1, 1, 1)))
    assert np.shape(ds.utilization(ds.DDS, many, phase="SPDP")) == (3,)
    announced = ds.Protocol("announced", ds.DDS.messages[:1])
    some, laptop = ds.HostGroup(1, 1, [1, 2, 3]), ds.HostGroup(1, 1, 90)
    for members in (ds.Fleet((some,)), ds.Fleet((some, laptop))):
        found = ds.saturation_hosts(announced, fleet=members)
        assert np.shape(found) == (3,)
        found += 1  # and belongs to whoever asked for it
