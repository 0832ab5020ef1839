"""Zenoh with routers, and Cyclone DDS with peers or multicast: counts that hold exactly."""

import numpy as np
import pytest

import discostorm as ds
from discostorm.data import read_data
from discostorm.protocols.defaults import defaults
from discostorm_book import comparison, lab_counts

ROUTER, PER_HOST, PEERS, MULTICAST = NAMES = (
    "Zenoh router",
    "Zenoh router per host",
    "Cyclone DDS peers",
    "Cyclone DDS multicast SEDP",
)
each_table = pytest.mark.parametrize("name", NAMES)


def counts_of_kind(
    point: lab_counts.GridPoint,
    window: str,
    kind: str,
    about: str = "",
    hop: str = "",
    cast: str = "",
) -> set[float]:
    """Return the counts of a kind in the runs of a point."""
    total = np.zeros(1)
    for one in [cast] if cast else ["unicast", "multicast"]:
        for way in [hop] if hop else ["", "up", "down"]:
            runs = point.runs.get((window, kind, about, one, way))
            total = total + (0 if runs is None else runs[:, 0])
    return set(total.tolist())


def shape(point: lab_counts.GridPoint) -> tuple[int, int, int, bool]:
    (group,) = point.fleet.groups
    return int(group.hosts), int(group.processes), int(group.endpoints), bool(point.fleet.matching)


@each_table
def test_each_was_run_at_six_points_or_more_of_each_half(name: str) -> None:
    shapes = [(point.use, shape(point)) for point in lab_counts.grid_points(name)]
    assert len([use for use, _ in shapes if use == "fit"]) >= 6
    assert len([use for use, _ in shapes if use == "test"]) >= 6
    assert {matching for _, (*_, matching) in shapes} == {True, False}


def test_a_central_router_filters_subscribers_and_tells_everybody_every_token() -> None:
    for point in lab_counts.grid_points(ROUTER):
        hosts, processes, endpoints, matching = shape(point)
        everyone = hosts * processes
        tokens = everyone * (endpoints + 1)
        for hop, whose in (("up", 1), ("down", everyone)):
            assert counts_of_kind(point, "startup", "Declare", "DeclareToken", hop) == {
                tokens * whose
            }
        half = everyone * endpoints / 2
        assert counts_of_kind(point, "startup", "Declare", "DeclareSubscriber", "up") == {half}
        told = half if matching else 0
        assert counts_of_kind(point, "startup", "Declare", "DeclareSubscriber", "down") == {told}
        assert counts_of_kind(point, "startup", "Declare final") == {everyone + half}


def test_routers_tell_all_others_of_everything_and_of_what_matches_once() -> None:
    for point in lab_counts.grid_points(PER_HOST):
        hosts, processes, endpoints, matching = shape(point)
        others = hosts * (hosts - 1)
        tokens = others * processes * (endpoints + 1)
        assert point.median(("startup", "Declare", "DeclareToken", "unicast", ""))[0] == tokens
        of_host = endpoints / 2 * (1 if matching else processes)
        subscribers = point.median(("startup", "Declare", "DeclareSubscriber", "unicast", ""))[0]
        assert subscribers == others * of_host


def test_a_link_is_kept_alive_every_thirty_seconds() -> None:
    value = defaults("rmw_zenoh")
    period = value["lease"] / value["keep_alives"]
    for name, links in ((ROUTER, "process"), (PER_HOST, "host pair")):
        (table, *_) = [m for m in ds.PROTOCOLS[name].messages if m.kind == "KeepAlive"]
        assert table.schedule.period == period
        for point in lab_counts.grid_points(name):
            hosts, processes, *_ = shape(point)
            each_way = 2 * hosts * processes if links == "process" else hosts * (hosts - 1)
            (sent,) = counts_of_kind(point, "steady", "KeepAlive")
            assert sent == each_way


def test_gossip_of_routers_grows_as_the_fourth_power_of_hosts() -> None:
    """From few hosts, which it was fitted to, to sixteen, which it was not."""
    table = ds.PROTOCOLS[PER_HOST]
    gossip = {
        shape(point)[0]: point.median(("startup", "OAM", "", "unicast", ""))[0]
        for point in lab_counts.grid_points(PER_HOST)
    }
    assert np.log2(gossip[16] / gossip[8]) == pytest.approx(4, abs=0.3)
    for hosts, counted in gossip.items():
        fleet = ds.Fleet.swarm(hosts, 1, 2)
        told = sum(comparison.expected_count(m, fleet, "startup") for m in table.of_phase("Gossip"))
        assert told == pytest.approx(counted, rel=0.25), hosts
    # By hand, of three routers: 6 ends of links, 2 hear of each, of which each tells one other.
    (flood,) = [m for m in table.messages if m.name == "OAM passed on"]
    assert flood.load(ds.Fleet.swarm(3, 5, 7)) == pytest.approx(12 * flood.per_unit)


def test_peers_are_announced_to_on_every_port_and_closed_ones_answer() -> None:
    ports = defaults("Cyclone DDS")["max_participant_index"]
    for point in lab_counts.grid_points(PEERS):
        hosts, processes, *_ = shape(point)
        peers = hosts * processes * (hosts - 1)
        assert counts_of_kind(point, "steady", "SPDP") == {3 * ports * peers}
        assert counts_of_kind(point, "startup", "SPDP", cast="multicast") == {0}
        refused = 6 * hosts * (hosts - 1)
        assert counts_of_kind(point, "startup", "ICMP unreachable") == {2 * refused}
        assert counts_of_kind(point, "steady", "ICMP unreachable") == {3 * refused}
    (row,) = [m for m in ds.PROTOCOLS[PEERS].messages if m.name == "SPDP"]
    assert row.per_unit == ports


def test_sedp_goes_to_the_group_where_that_is_allowed() -> None:
    for point in lab_counts.grid_points(MULTICAST):
        assert point.median(("startup", "SEDP", "", "multicast", ""))[0] > 0
    for point in lab_counts.grid_points(PEERS):
        assert not [key for key in point.runs if key[3] == "multicast"]


@each_table
def test_a_table_says_the_same_of_a_fleet_of_one_group_or_of_two_like_ones(name: str) -> None:
    halves = ds.Fleet((ds.HostGroup(2, 2, 10), ds.HostGroup(3, 2, 10)), matching=0.5)
    whole = ds.Fleet((ds.HostGroup(5, 2, 10),), matching=0.5)
    for window in (1.0, np.inf):
        one, other = (ds.utilization(ds.PROTOCOLS[name], f, window=window) for f in (whole, halves))
        assert one == pytest.approx(other, rel=1e-12)


def test_what_a_wired_router_sends_and_receives_takes_one_hop() -> None:
    table = ds.PROTOCOLS[ROUTER]
    assert {message.hops for message in table.messages} == {("up",), ("down",)}
    assert {m.hops for m in ds.PROTOCOLS[PER_HOST].messages} == {("up", "down")}


def test_saturation_of_a_fourth_power_is_where_utilization_is_one() -> None:
    """Without a closed form; held against the roots of the polynomial, found by NumPy."""
    table = ds.PROTOCOLS[PER_HOST]
    hosts = np.arange(1.0, 6.0)
    used = ds.utilization(table, hosts, 2, 10)
    powers = np.polynomial.Polynomial.fit(hosts, used, 4).convert()
    roots = (powers - 1).roots()
    (wanted,) = roots[np.isreal(roots) & (roots.real > 1)].real
    assert ds.saturation_hosts(table, 2, 10) == pytest.approx(wanted, rel=1e-6)
    laptops = ds.HostGroup(2, 1, 90)
    mixed = ds.Fleet((ds.HostGroup(1, 2, 10), laptops), matching=0.5)
    full = ds.saturation_hosts(table, fleet=mixed)
    both = ds.Fleet((ds.HostGroup(full, 2, 10), laptops), matching=0.5)
    assert ds.utilization(table, both) == pytest.approx(1, rel=1e-12)


def test_peers_of_cyclone_dds_have_as_many_ports_as_the_remedy_says() -> None:
    ports = ds.PROTOCOLS[PEERS].message("SPDP").per_unit
    (price,) = (row["price"] for row in read_data("vendors/remedies.csv") if row["table"] == PEERS)
    assert f"goes to {ports:g} ports of every address" in price
