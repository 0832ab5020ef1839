"""Fleets of unlike hosts: counts, saturation, reading from a file, errors."""

import pickle
import re
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from random import Random
from typing import Any

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings, strategies as st

import discostorm as ds
from discostorm.data import data_path, read_data
from discostorm.messages import ENDPOINT_PAIR, PAIR, PROCESS
from discostorm.notation import N_E, N_H, N_P
from discostorm.robots import laptop, likely_nodes, robots
from discostorm.saturation import saturation

#: Hosts, processes and endpoints of each group.
Groups = Sequence[tuple[Any, Any, Any]]

PROTOCOLS = (ds.DDS, ds.ZENOH)

#: Neither text nor a group, nor a fleet.
WRONG: Any = 5
WRONG_FLEET: Any = 3
protocols = st.sampled_from(PROTOCOLS)
more_groups = st.lists(
    st.tuples(st.integers(1, 30), st.integers(1, 20), st.integers(0, 700)), min_size=1, max_size=3
)


def fleet_of(counts: Groups) -> ds.Fleet:
    return ds.Fleet(tuple(ds.HostGroup(*group) for group in counts))


def ids(protocol: ds.Protocol) -> str:
    return protocol.name


@given(protocols, more_groups)
@settings(max_examples=40, deadline=None)
def test_utilization_of_a_fleet_is_its_breakdown_added_up(
    protocol: ds.Protocol, counts: Groups
) -> None:
    fleet = fleet_of(counts)
    total = ds.breakdown(protocol, fleet)[["uplink_s", "downlink_s"]].to_numpy().sum()
    # Another order of the same sums.
    assert ds.utilization(protocol, fleet) == pytest.approx(total, rel=1e-12)


@given(protocols, more_groups, st.randoms())
@settings(max_examples=40, deadline=None)
def test_the_order_of_groups_and_how_like_hosts_are_grouped_do_not_matter(
    protocol: ds.Protocol, counts: Groups, random: Random
) -> None:
    expected = ds.utilization(protocol, fleet_of(counts))
    shuffled = random.sample(counts, len(counts))
    split = [
        part
        for hosts, processes, endpoints in shuffled
        for part in ([(1, processes, endpoints)] if hosts > 1 else [])
        + [(max(hosts - 1, 1), processes, endpoints)]
    ]
    for other in (shuffled, split):
        assert ds.utilization(protocol, fleet_of(other)) == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize("protocol", PROTOCOLS, ids=ids)
def test_one_group_is_the_papers_swarm_and_two_like_groups_are_one(protocol: ds.Protocol) -> None:
    h1, h2 = sp.symbols("h1 h2", positive=True)
    assert ds.Fleet.symbolic(1) == ds.Fleet.swarm(N_H, N_P, N_E)
    two = ds.Fleet((ds.HostGroup(h1, N_P, N_E), ds.HostGroup(h2, N_P, N_E)))
    for phase in (*protocol.phases, None):
        one = protocol.utilization(phase).subs(N_H, h1 + h2)
        assert sp.expand(protocol.utilization(phase, two) - one) == 0


def test_units_of_a_fleet_in_symbols() -> None:
    fleet = ds.Fleet.symbolic(2)
    h1, p1, e1, h2, p2, e2 = fleet.counts()
    across = h1 * p1 * h2 * p2
    within = [h * (h - 1) * p**2 for h, p in ((h1, p1), (h2, p2))]
    expected = {
        PROCESS: h1 * p1 + h2 * p2,
        PAIR: sum(within) + 2 * across,
        ENDPOINT_PAIR: within[0] * e1 + within[1] * e2 + across * (e1 + e2),
    }
    for unit, count in expected.items():
        assert sp.expand(unit.count(fleet) - count) == 0


def test_arrays_as_counts_broadcast_like_numpy() -> None:
    robots = np.arange(1, 6, dtype=np.int16)
    laptop = ds.HostGroup(1, 1, [[0], [90]])
    fleet = ds.Fleet((ds.HostGroup(robots, 1, 678), laptop))
    found = np.asarray(ds.utilization(ds.DDS, fleet))
    assert found.shape == (2, 5)
    for row, endpoints in enumerate((0, 90)):
        for column, hosts in enumerate(robots):
            one = ds.utilization(ds.DDS, fleet_of([(hosts, 1, 678), (1, 1, endpoints)]))
            assert found[row, column] == pytest.approx(one, rel=1e-14)


def test_symbols_may_stand_for_some_of_the_counts() -> None:
    fleet = ds.Fleet((ds.HostGroup(N_H, 1, 678), ds.HostGroup(1, 1, 90)))
    load = ds.DDS.messages[1].load(fleet)
    assert sp.expand(load - (678 * N_H * (N_H - 1) + 678 * N_H + 90 * N_H)) == 0
    with pytest.raises(TypeError, match="hosts must be a number here, not an expression; got N_H"):
        ds.utilization(ds.DDS, fleet)


@given(protocols, st.integers(1, 20), st.integers(0, 700), more_groups, st.floats(0, 50))
@settings(max_examples=40, deadline=None)
def test_saturation_beside_a_fleet_is_where_utilization_meets_the_limit(
    protocol: ds.Protocol, processes: int, endpoints: int, counts: Groups, spare: float
) -> None:
    host = (1, processes, endpoints)
    limit = ds.utilization(protocol, fleet_of([host, *counts])) + spare
    fleet = fleet_of([host, *counts])
    hosts = ds.saturation_hosts(protocol, limit=limit, fleet=fleet)
    assert hosts >= 1
    full = fleet_of([(hosts, processes, endpoints), *counts])
    # Rounding of the root, then of a sum over the groups.
    assert ds.utilization(protocol, full) == pytest.approx(limit, rel=1e-11)


@pytest.mark.parametrize("protocol", PROTOCOLS, ids=ids)
def test_saturation_beside_like_hosts_counts_the_rest_of_the_swarm(protocol: ds.Protocol) -> None:
    swarm = ds.saturation_hosts(protocol, 2, 10)
    fleet = fleet_of([(1, 2, 10), (3, 2, 10)])
    rest = ds.saturation_hosts(protocol, fleet=fleet)
    assert rest == pytest.approx(swarm - 3, rel=1e-13)
    assert saturation(protocol).free_symbols >= {N_P, N_E}


def test_a_byte_order_mark_is_passed_over(tmp_path: Path) -> None:
    file = tmp_path / "fleet.toml"
    file.write_text("[[groups]]\nhosts = 1\nprocesses = 2\nendpoints = 3\n", encoding="utf-8-sig")
    assert ds.Fleet.from_toml(file).groups == (ds.HostGroup(1, 2, 3, shared=2),)


def test_saturation_beside_a_fleet_broadcasts_and_names_what_is_wrong() -> None:
    laptop = ds.HostGroup(1, 1, [[0], [90]], name="laptop")
    fleet = ds.Fleet((ds.HostGroup(1, 1, [10, 100, 678], name="robots"), laptop))
    found = np.asarray(ds.saturation_hosts(ds.DDS, fleet=fleet))
    assert found.shape == (2, 3)
    assert (found[0] > found[1]).all()
    assert (found == ds.saturation_hosts(ds.DDS, fleet=fleet, group="robots")).all()
    assert (found != ds.saturation_hosts(ds.DDS, fleet=fleet, group=1)).all()
    with pytest.raises(TypeError, match="fleet must be a Fleet; got 3"):
        ds.saturation_hosts(ds.DDS, fleet=WRONG_FLEET)
    with pytest.raises(ValueError, match="group must be 'robots' or 'laptop'; got 'robot'"):
        ds.saturation_hosts(ds.DDS, fleet=fleet, group="robot")
    with pytest.raises(ValueError, match=r"group must be a whole number .* at most 1; got 2"):
        ds.saturation_hosts(ds.DDS, fleet=fleet, group=2)
    with pytest.raises(TypeError, match="processes must be left out when hosts is a Fleet; got 2"):
        ds.saturation_hosts(ds.DDS, 2, fleet=fleet)
    with pytest.raises(
        ValueError, match=r"limit .* single host beside the fleet with DDS, 3\.\d+; got 1\.0"
    ):
        ds.saturation_hosts(ds.DDS, fleet=fleet_of([(1, 1, 678), (3, 1, 678)]))
    with pytest.raises(
        ValueError, match=r"broadcast.*groups\[1\].endpoints \(2, 1\), limit \(3, 3\)"
    ):
        ds.saturation_hosts(ds.DDS, fleet=fleet, limit=np.ones((3, 3)))
    with pytest.raises(TypeError, match=r"endpoints must be a number here, not an"):
        ds.saturation_hosts(ds.DDS, fleet=fleet_of([(1, 1, 10), (1, 1, N_E)]))


def test_repr_reads_well_and_makes_the_same_group() -> None:
    group = ds.HostGroup(10, 1.5, 678, name="robots")
    assert repr(group) == "HostGroup(hosts=10, processes=1.5, endpoints=678, name='robots')"
    assert eval(repr(group), {"HostGroup": ds.HostGroup}) == group
    assert (
        repr(ds.HostGroup(1e9, 1, N_E)) == "HostGroup(hosts=1000000000, processes=1, endpoints=N_E)"
    )
    assert len(repr(ds.HostGroup(np.arange(1, 10**6), 1, 1))) < 120


@pytest.mark.parametrize(
    ("make", "error", "message"),
    [
        (lambda: ds.HostGroup(0, 1, 1), ValueError, "hosts must be .* at least 1 .* got 0$"),
        (lambda: ds.HostGroup(1, -2, 1), ValueError, "processes must be .* at least 1 .* got -2$"),
        (lambda: ds.HostGroup(1, 1, -1), ValueError, "endpoints must be .* at least 0 .* got -1$"),
        (lambda: ds.HostGroup(1e10, 1, 1), ValueError, r"hosts must be .* at most 1e\+09; got 1"),
        (lambda: ds.HostGroup(1, 1, np.nan), ValueError, "endpoints must be .*; got nan"),
        (lambda: ds.HostGroup("ten", 1, 1), TypeError, "hosts must be .*; got 'ten'"),
        (lambda: ds.HostGroup(True, 1, 1), TypeError, "hosts must be .*; got True"),
        (lambda: ds.HostGroup(1, 1, 1, name=WRONG), TypeError, "name must be a str; got 5"),
        (
            lambda: ds.HostGroup([1, 2], [1, 2, 3], 1),
            ValueError,
            r"broadcast .*hosts \(2,\), processes \(3,\)",
        ),
        (lambda: ds.Fleet(()), ValueError, "groups must hold at least one HostGroup; got none"),
        (lambda: ds.Fleet((WRONG,)), TypeError, r"groups\[0\] must be a HostGroup; got 5"),
        (
            lambda: ds.Fleet(tuple(ds.HostGroup(1, 1, 1, name) for name in "aabb")),
            ValueError,
            "groups must have distinct names; got 'a' twice",
        ),
        (
            lambda: ds.Fleet((ds.HostGroup([1, 2], 1, 1), ds.HostGroup(1, 1, [1, 2, 3]))),
            ValueError,
            r"groups\[0\]\.hosts \(2,\), groups\[1\]\.endpoints \(3,\)",
        ),
    ],
)
def test_wrong_groups_are_named_with_parameter_value_and_range(
    make: Callable[[], object], error: type[Exception], message: str
) -> None:
    with pytest.raises(error, match=message):
        make()


def test_a_fleet_is_read_from_toml(tmp_path: Path) -> None:
    path = tmp_path / "fleet.toml"
    path.write_text(
        """
        # A comment.
        [[groups]]
        name = "Roboter äöü"
        hosts = 10
        processes = 1
        endpoints = 678

        [[groups]]
        hosts = 1
        processes = 2
        endpoints = 90.5
        """,
        encoding="utf-8",
    )
    # Each group shares what ROS 2 makes for a process and for the likely number of its nodes.
    robots = ds.HostGroup(10, 1, 678, name="Roboter äöü", shared=2 + 2 * likely_nodes(678))
    expected = ds.Fleet((robots, ds.HostGroup(1, 2, 90.5, shared=2 + 2 * likely_nodes(90.5))))
    assert ds.Fleet.from_toml(path) == ds.Fleet.from_toml(str(path)) == expected


def test_the_fleet_of_the_example_has_the_parts_that_its_sources_add_up_to() -> None:
    fleet = ds.Fleet.from_toml(data_path("fleets/nav2_laptop.toml"))
    parts = read_data("fleets/rviz_endpoints.csv")
    endpoints = sum(int(part["how_many"]) * int(part["endpoints_each"]) for part in parts)
    (nodes,) = (int(part["how_many"]) for part in parts if "parameter services" in part["part"])
    nav2 = sum(int(row["how_many"]) for row in read_data("fleets/nav2_nodes.csv"))
    assert fleet.groups == (
        ds.HostGroup(10, 1, 678, name="robots", nodes=nav2, shared=2 + 2 * nav2),
        ds.HostGroup(1, 1, endpoints, name="laptop", nodes=nodes, shared=2 + 2 * nodes),
    )


def test_ready_made_robots_are_the_sum_of_their_parts() -> None:
    rows = read_data("fleets/robots.csv")
    assert {row["kind"] for row in rows} == {"printed", "counted", "estimated"}
    for name, robot in robots().items():
        parts = [row for row in rows if row["robot"] == name]
        many = sum(int(part["processes"]) for part in parts)
        assert (robot.hosts, robot.processes, robot.name) == (1, many, name)
        assert robot.nodes is not None
        # What each process has, on the mean, adds up to whole numbers.
        for mean, count in ((robot.endpoints, "endpoints"), (robot.nodes, "nodes")):
            assert mean * many == pytest.approx(sum(int(part[count]) for part in parts), rel=1e-12)
    assert robots()["Nav2 in one process"].endpoints == 678
    composed = sum(int(row["how_many"]) for row in read_data("fleets/nav2_nodes.csv"))
    assert robots()["Nav2 in one process"].nodes == composed
    assert laptop() == ds.HostGroup(1, 1, 90, name="laptop", nodes=2, shared=2 + 2 * 2)
    named = ds.Fleet.from_bytes(b"[[groups]]\nhosts = 1\nrobot = 'Laptop'", "fleet.toml")
    assert named.groups == (laptop(),)
    assert robots()["Nav2 in one process"].shared == 2 + 2 * composed


def test_a_group_of_a_file_may_be_ready_made_robots(tmp_path: Path) -> None:
    path = tmp_path / "fleet.toml"
    path.write_text(
        'within = 20\n[[groups]]\nrobot = "turtlebot4"\nhosts = 12\n'
        '[[groups]]\nrobot = "nav2"\nname = "carts"\nhosts = 2\nwired = true\n'
    )
    fleet = ds.Fleet.from_toml(path)
    turtlebot, nav2 = robots()["TurtleBot 4 with Nav2"], robots()["Nav2 in one process"]
    assert fleet.groups == (
        replace(turtlebot, hosts=12),
        replace(nav2, hosts=2, name="carts", wired=True),
    )
    assert fleet.within == 20
    assert "within=20" in repr(fleet)


def test_processes_of_a_file_may_be_unlike(tmp_path: Path) -> None:
    path = tmp_path / "fleet.toml"
    sizes = "".join(
        f"[[groups.processes]]\ncount = {count}\nendpoints = {endpoints}\n"
        for count, endpoints in ((1, 71), (2, 0))
    )
    path.write_text("[[groups]]\nhosts = 3\n" + sizes)
    fleet = ds.Fleet.from_toml(path)
    unlike = (ds.Process(1, 71), ds.Process(2, 0))
    # A process without endpoints shares none.
    assert fleet == ds.Fleet((ds.HostGroup(3, unlike),))
    (group,) = fleet.groups
    assert (group.processes, group.endpoints, group.shared) == (3, 71 / 3, 0)
    assert eval(repr(group), {"HostGroup": ds.HostGroup, "Process": ds.Process}) == group
    assert pickle.loads(pickle.dumps(group)) == group != ds.HostGroup(3, 3, 71 / 3)
    assert replace(group, hosts=4).process_sizes == unlike
    assert replace(group, endpoints=5).process_sizes == ()
    assert fleet.to_dicts()[0]["process_sizes"] == [
        {"count": 1, "endpoints": 71},
        {"count": 2, "endpoints": 0},
    ]
    with pytest.raises(ValueError, match="endpoints must be left out where processes lists"):
        ds.HostGroup(3, unlike, 10)
    with pytest.raises(ValueError, match=r"shared must be .* at most 0; got 1"):
        ds.HostGroup(3, unlike, shared=1)
    with pytest.raises(
        TypeError, match=r"endpoints must be .*, or set by a tuple of Process; got None"
    ):
        ds.HostGroup(3, 2)


def test_processes_of_ready_made_robots_have_whole_endpoints() -> None:
    for robot in robots().values():
        assert robot.process_sizes
        assert sum(size.count for size in robot.process_sizes) == robot.processes
    sizes = robots()["TurtleBot 4 with Nav2"].process_sizes
    nav2, drivers = (5, 64), (6, 63)
    assert [(size.count, size.endpoints) for size in sizes] == [nav2, drivers, (10, 21), (1, 20)]


def test_what_is_shared_may_stand_in_the_file(tmp_path: Path) -> None:
    path = tmp_path / "fleet.toml"
    path.write_text("[[groups]]\nhosts = 2\nprocesses = 1\nendpoints = 50\nshared = 4\n")
    fleet = ds.Fleet.from_toml(path)
    (group,) = fleet.groups
    assert group == ds.HostGroup(2, 1, 50, shared=4) != ds.HostGroup(2, 1, 50)
    assert pickle.loads(pickle.dumps(group)) == group
    assert repr(group) == "HostGroup(hosts=2, processes=1, endpoints=50, shared=4)"
    # Of 50 endpoints 4 match by themselves, and of the others the fleet's part.
    matched = ds.Unit("matched endpoint")
    assert matched.count(fleet) == 2 * 4
    assert matched.count(ds.Fleet(fleet.groups, matching=0.5)) == 2 * (4 + 46 / 2)
    table = ds.PROTOCOLS["Fast DDS Discovery Server"]
    full = ds.saturation_hosts(table, fleet=fleet)
    whole = replace(group, hosts=full)
    assert ds.utilization(table, ds.Fleet((whole,))) == pytest.approx(1, rel=1e-9)
    assert full < ds.saturation_hosts(table, 1, 50)
    for wrong, allowed in (("51", "at most 50; got 51"), ("true", "got True")):
        path.write_text(path.read_text().replace("shared = 4", f"shared = {wrong}"))
        with pytest.raises(ValueError, match=f"group 1: shared must be .*{allowed}"):
            ds.Fleet.from_toml(path)
        path.write_text(path.read_text().replace(f"shared = {wrong}", "shared = 4"))


def test_nodes_may_stand_in_the_file(tmp_path: Path) -> None:
    path = tmp_path / "fleet.toml"
    path.write_text("[[groups]]\nhosts = 2\nprocesses = 1\nendpoints = 50\nnodes = 3\n")
    (group,) = ds.Fleet.from_toml(path).groups
    of_ros2 = ds.HostGroup(2, 1, 50, nodes=3, shared=8)
    assert group == of_ros2 != ds.HostGroup(2, 1, 50)
    for told, shared in [("shared = 0", 0), ("shared = 20", 20)]:
        path.write_text(f"[[groups]]\nhosts = 2\nprocesses = 1\nendpoints = 50\nnodes = 3\n{told}")
        assert ds.Fleet.from_toml(path).groups == (replace(of_ros2, shared=shared),)
    path.write_text("[[groups]]\nhosts = 2\nprocesses = 1\nendpoints = 1\nnodes = 0\n")
    assert ds.Fleet.from_toml(path).groups[0].shared == 1  # never more than there are
    path.write_text("[[groups]]\nhosts = 2\nprocesses = 1\nendpoints = 50\nnodes = 3\n")
    assert pickle.loads(pickle.dumps(group)) == group
    assert repr(group) == "HostGroup(hosts=2, processes=1, endpoints=50, nodes=3, shared=8)"
    path.write_text(path.read_text().replace("nodes = 3", "nodes = true"))
    with pytest.raises(ValueError, match=r"group 1: nodes must be a finite number .*; got True"):
        ds.Fleet.from_toml(path)
    with pytest.raises(ValueError, match=r"nodes must be a finite number of at least 0.*; got -1"):
        ds.HostGroup(2, 1, 50, nodes=-1)


SIZES = "[[groups]]\nhosts = 1\n[[groups.processes]]\n"
GOOD = "hosts = 1\nprocesses = 1\nendpoints = 1\n"


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ("", r"at least one \[\[groups\]\] table; got None"),
        ("groups = []", r"at least one \[\[groups\]\] table; got \[\]"),
        ("groups = 3", r"at least one \[\[groups\]\] table; got 3"),
        ("groups = [3]", "group 1: it must be a table with hosts, processes, endpoints; got 3"),
        ("[groups]\n" + GOOD, r"at least one \[\[groups\]\] table; got {'endpoints': 1"),
        ("[[groups]\n", "is not valid TOML: .*line 1"),
        (
            "[[groups]]\n" + GOOD + "[[group]]\n" + GOOD,
            "unknown key group = .*. Did you mean 'groups'",
        ),
        (
            "[[groups]]\n" + GOOD + "hosst = 3",
            "group 1: unknown key hosst = 3. Did you mean 'hosts'",
        ),
        ("[[groups]]\n" + GOOD + "zebra = 3", "key zebra = 3. Valid keys are in `discostorm plan"),
        (
            "[[groups]]\nname = 'a'\n" + GOOD.replace("hosts = 1", ""),
            r"group 1 \(a\): hosts is missing; it must be .* at least 1 and at most 1e\+09",
        ),
        (
            "[[groups]]\n" + GOOD + "[[groups]]\nname = 'b'\n" + GOOD.replace("ts = 1", "ts = 0"),
            r"group 2 \(b\): hosts must be a finite number of at least 1 .*; got 0",
        ),
        (
            "[[groups]]\nrobot = 'tb4'\n" + GOOD,
            "processes must be left out, as robot sets it; got 1",
        ),
        ("[[groups]]\nrobot = 'tb4'", "group 1: hosts is missing; it must be a finite number"),
        ("[[groups]]\ndomain = 1", "unknown key domain = 1. Write domain above the groups"),
        ("hosts = 1", r"unknown key hosts = 1. Write hosts below \[\[groups\]\]"),
        ("[groups]\nhosts = 1", r"Write \[\[groups\]\] in two brackets"),
        ("[[groups]]\nhosts = 1\nrobot = 'turtelbot'", "Did you mean 'TurtleBot 4"),
        ("[[groups]]\n" + GOOD + "security = true", ". Write security above the groups"),
        ("[[groups]]\nhosts = 1\nrobot = 4", "robot must be the name of a ready-made robot; got 4"),
        (SIZES + "count = 0\nendpoints = 1", "processes 1: count must be .* at least 1 .*; got 0"),
        (
            SIZES + "count = 2\nendpoints = 0.5",
            "processes 1: endpoints must be a whole .*; got 0.5",
        ),
        (SIZES + "endpoints = 1", "group 1: processes 1: count is missing"),
        (SIZES + "count = 1\nendpoint = 1", "unknown key endpoint = 1. Did you"),
        ("within = 0\n[[groups]]\n" + GOOD, "within must be .* above 0; got 0"),
        ("within = '9'\n[[groups]]\n" + GOOD, "within must be .*; got '9'"),
        ("[[groups]]\n" + GOOD.replace("= 1", "= 'x'"), "hosts must be .* at least 1 .*; got 'x'"),
        ("[[groups]]\n" + GOOD.replace("= 1", "= [1]"), r"hosts must be .*; got \[1\]"),
        ("[[groups]]\n" + GOOD.replace("= 1", "= true"), "hosts must be .*; got True"),
        ("[[groups]]\n" + GOOD.replace("s = 1", "s = nan"), "hosts must be .*; got nan"),
        ("[[groups]]\n" + GOOD.replace("s = 1", "s = 1e99"), r"at most 1e\+09; got 1e\+99"),
        ("[[groups]]\nname = 5\n" + GOOD, r"group 1 \(5\): name must be a str; got 5"),
        (
            ("[[groups]]\nname = 'c'\n" + GOOD) * 2,
            "groups must have distinct names; got 'c' twice",
        ),
    ],
)
def test_a_wrong_fleet_file_is_answered_with_file_key_value_and_range(
    tmp_path: Path, content: str, message: str
) -> None:
    path = tmp_path / "fleet.toml"
    path.write_text(content, encoding="utf-8")
    with pytest.raises(ValueError, match=rf"fleet\.toml.*{message}"):
        ds.Fleet.from_toml(path)


def test_a_fleet_file_that_is_no_text_or_not_there_is_named(tmp_path: Path) -> None:
    path = tmp_path / "fleet.toml"
    path.write_bytes(b"\xff\xfe")
    with pytest.raises(ValueError, match=r"fleet\.toml is not valid TOML: .*utf-8"):
        ds.Fleet.from_toml(path)
    with pytest.raises(FileNotFoundError, match=r"none\.toml"):
        ds.Fleet.from_toml(tmp_path / "none.toml")


def test_of_many_counts_only_the_ends_are_shown() -> None:
    six, seven = (repr(ds.HostGroup(np.arange(1.0, many + 1), 1, 1)) for many in (6, 7))
    assert "hosts=[1., 2., 3., 4., 5., 6.]" in six
    assert "hosts=[1., 2., ..., 6., 7.]" in seven


def test_symbols_of_a_fleet_are_counts() -> None:
    for group in ds.Fleet.symbolic(2).groups:
        assert all(count.is_nonnegative for count in group.counts())


def test_a_group_keeps_its_counts_when_the_array_it_was_given_changes() -> None:
    hosts = np.array([1.0, 2.0])
    group = ds.HostGroup(hosts, 1, 1)
    hosts[0] = -5
    assert group.hosts.tolist() == [1, 2]
    with pytest.raises(ValueError, match="read-only"):
        group.hosts[0] = -5


def test_a_fleet_with_dds_security_is_refused_with_what_it_took_where_it_was_measured() -> None:
    swarm = b"[[groups]]\nhosts = 2\nprocesses = 1\nendpoints = 4\n"
    plain = ds.Fleet.from_bytes(swarm, "fleet.toml")
    assert ds.Fleet.from_bytes(b"security = false\n" + swarm, "fleet.toml") == plain
    with pytest.raises(ValueError, match=r"fleet\.toml: security must be false") as refused:
        ds.Fleet.from_bytes(b"security = true\n" + swarm, "fleet.toml")
    for product in ("Fast DDS", "Cyclone DDS"):
        rows = [r for r in read_data("measured/security.csv") if r["product"] == product]
        times = [float(row["secured_s"]) / float(row["without_s"]) for row in rows]
        assert f"{min(times):.1f} to {max(times):.1f} with {product}" in str(refused.value)
        (target,) = re.findall(rf"(\d+) with {product}", str(refused.value).split("within = ")[1])
        assert int(target) <= 60 / max(times) < int(target) + 1


@pytest.mark.parametrize("address", ["192.168.1.300", "1.2.3", "10.0.0", "...", "-x", "a b", "::g"])
def test_an_address_that_is_none_is_refused(address: str) -> None:
    text = '[[groups]]\nhosts = 2\nprocesses = 1\nendpoints = 5\n[addresses]\nserver = "{}"\n'
    told = r"addresses\.server must be an IP address, with four numbers of at most 255, or a host "
    with pytest.raises(ValueError, match=f"{told}name; got '{re.escape(address)}'"):
        ds.Fleet.from_bytes(text.format(address).encode(), "fleet.toml")
    for good in ("192.168.1.30", "fe80::1", "robot-1.local", "robot_1", "3com"):
        assert ds.Fleet.from_bytes(text.format(good).encode(), "f").addresses == (("server", good),)


def test_a_radio_in_the_wrong_place_or_misspelt_says_where_and_which() -> None:
    group = b"[[groups]]\nhosts = 2\nprocesses = 1\nendpoints = 5\n"
    place = r"unknown key wifi = '802\.11ac'\. Write wifi below \[\[cells\]\], or give --wifi to "
    place += "the command"
    with pytest.raises(ValueError, match=f"{place}; '--wifi list' lists radios"):
        ds.Fleet.from_bytes(b'wifi = "802.11ac"\n' + group, "fleet.toml")
    cells = b'[[cells]]\nname = "hall"\nwifi = "802.11ac 90"\n'
    with pytest.raises(ValueError, match=r"be 'paper', .* mean '802\.11ac 80 MHz 2x2'\?"):
        ds.Fleet.from_bytes(cells + group + b'cell = "hall"\n', "fleet.toml")
    with pytest.raises(ValueError, match=r"got 'ac'\. Did you mean '802\.11ac 80 MHz 2x2'\?"):
        ds.lookup.as_wifi("ac")
