"""Compare the counts of units with hosts and processes named one by one."""

import itertools
from typing import NamedTuple

import numpy as np
import pytest

import discostorm as ds
from discostorm.messages.units import UNITS, Hosts, Unit


class Process(NamedTuple):
    """A process with its place, and its endpoints: all, and those that match in every other."""

    group: int
    host: int
    number: int
    endpoints: float
    matched: float
    own_types: int


#: Hosts, processes, endpoints, shared endpoints and own types of each group, and what matches of
#: the rest.
Groups = tuple[tuple[int, int, int, int, int], ...]
FLEETS: list[tuple[Groups, float]] = [
    (((3, 2, 4, 0, 0),), 0.0),
    (((3, 2, 4, 0, 3),), 0.0),
    (((2, 3, 6, 2, 4), (3, 1, 5, 0, 0), (1, 2, 4, 4, 1)), 0.0),
    (((1, 2, 4, 0, 2), (4, 2, 6, 2, 6)), 0.5),
]


def processes_of(groups: Groups, matching: float) -> list[Process]:
    host = itertools.count()
    return [
        Process(index, here, number, endpoints, shared + (endpoints - shared) * matching, types)
        for index, (hosts, processes, endpoints, shared, types) in enumerate(groups)
        for here in itertools.islice(host, hosts)
        for number in range(processes)
    ]


def count_of_process(unit: Unit, one: Process, everyone: list[Process]) -> float:
    """Return how many counted things a process holds."""
    first_of_group = min(other.host for other in everyone if other.group == one.group)
    return {
        "process": 1,
        "endpoint": one.endpoints,
        "matched endpoint": one.matched,
        "unmatched endpoint": one.endpoints - one.matched,
        "unknown type": len(
            {
                (other.group, other.number, number)
                for other in everyone
                if (other.group, other.number) != (one.group, one.number)
                for number in range(other.own_types)
            }
        ),
        "matched writer": one.matched / 2,
        "matched endpoint of others": sum(o.matched for o in everyone if o is not one),
        "listed endpoint": sum(range(1, int(one.endpoints) + 1)),  # a longer list each time
        "endpoint of a kind of host": one.endpoints * (one.host == first_of_group),
        "matched endpoint of a host": one.matched * (one.number == 0),
        "host": one.number == 0,
        "fleet": one is everyone[0],
    }[unit.what]


def receivers(unit: Unit, one: Process, everyone: list[Process]) -> int:
    away = [other for other in everyone if other.host != one.host]
    return {
        "all": 1,
        "other process": len(everyone) - 1,
        "remote process": len(away),
        "other host": len({other.host for other in away}),
        "server": int(one.host > 0),
    }[unit.to]


def factor(unit: Unit, everyone: list[Process]) -> int:
    hosts = len({one.host for one in everyone})
    match = int(any(one.matched for one in everyone))
    return {
        None: 1,
        "third process": len(everyone) - 2,
        "third host": hosts - 2,
        "match": match,
        "matched process": (len(everyone) - 1) * match,
        "link": len([*itertools.permutations(range(hosts - 1), 2)]),  # of the other hosts
    }[unit.factor]


@pytest.mark.parametrize(("groups", "matching"), FLEETS)
@pytest.mark.parametrize("name", UNITS)
def test_every_unit_is_counted_as_if_each_process_were_asked(
    name: str, groups: Groups, matching: float
) -> None:
    unit, everyone = UNITS[name], processes_of(groups, matching)
    each = [
        count_of_process(unit, one, everyone) * receivers(unit, one, everyone) for one in everyone
    ]
    expected = sum(each) * factor(unit, everyone)
    members = tuple(
        ds.HostGroup(*counts[:3], shared=counts[3], own_types=counts[4]) for counts in groups
    )
    assert unit.count(ds.Fleet(members, matching)) == expected

    # The simulator's way: what each process sends, to all or to each receiver elsewhere.
    rows = [(index, *counts) for index, counts in enumerate(groups) for _ in range(counts[0])]
    group, _, processes, endpoints, shared, types = np.array(rows).T
    hosts = Hosts(processes, endpoints, group, matching, shared.astype(float), types.astype(float))
    sent, to = unit.units_per_process(hosts), unit.receiver_mask(hosts)
    if to is not None:
        elsewhere = hosts.host_of[:, None] != hosts.host_of
        assert not (unit.to == "server" and sent[hosts.host_of == 0].any())
        sent = sent * (elsewhere * to).sum(axis=1)
    assert sent.sum() == expected


@pytest.mark.parametrize("matching", [0.0, 1.0])
@pytest.mark.parametrize("name", UNITS)
def test_unlike_processes_count_like_their_list(name: str, matching: float) -> None:
    """A group of unlike processes, and a table of hosts with each process by itself."""
    unit, sizes = UNITS[name], ((2, 3), (1, 6))
    endpoints = [each for _ in range(3) for count, each in sizes for _ in range(count)]
    endpoints += [4, 4] * 2
    places = [(0, host, number) for host in range(3) for number in range(3)]
    places += [(1, host, number) for host in (3, 4) for number in range(2)]
    everyone = [
        Process(*place, each, 2 + (each - 2) * matching, 0)
        for place, each in zip(places, endpoints, strict=True)
    ]
    if name.startswith("matched endpoint of a host"):
        # A router tells for all processes of its host: of their mean.
        means = {h: [p.matched for p in everyone if p.host == h] for h in range(5)}
        everyone = [p._replace(matched=sum(means[p.host]) / len(means[p.host])) for p in everyone]
    each = [
        count_of_process(unit, one, everyone) * receivers(unit, one, everyone) for one in everyone
    ]
    expected = sum(each) * factor(unit, everyone)
    unlike = tuple(ds.Process(*size) for size in sizes)
    fleet = ds.Fleet((ds.HostGroup(3, unlike, shared=2), ds.HostGroup(2, 2, 4, shared=2)), matching)
    assert unit.count(fleet) == pytest.approx(expected, rel=1e-12)
    hosts = Hosts(
        np.array([3, 3, 3, 2, 2]),
        np.array(endpoints),
        np.array([0, 0, 0, 1, 1]),
        matching,
        np.full(5, 2.0),
    )
    sent, to = unit.units_per_process(hosts), unit.receiver_mask(hosts)
    if to is not None:
        sent = sent * ((hosts.host_of[:, None] != hosts.host_of) * to).sum(axis=1)
    assert sent.sum() == pytest.approx(expected, rel=1e-12)
