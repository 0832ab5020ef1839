"""Plans of other protocols and configurations: which changes, with which numbers and reasons."""

import json
import math
from csv import DictReader
from dataclasses import replace

import pytest
from click.testing import CliRunner
from planner_by_hand import (
    FIG3,
    MITIGATION_ROWS,
    NAV2,
    NAV2_WITH_NODES,
    PAPER,
    RADIO,
    ROBOTS,
    groups_as_toml,
    remedy,
)

import discostorm as ds
from discostorm.cli import main
from discostorm.data import read_data
from discostorm.protocols import MEASURED, MITIGATED
from discostorm.protocols.measured_tables import product_releases
from discostorm.robots import robots as robots_by_name
from discostorm_planner import protocol_changes as table_module, remedy_rules
from discostorm_planner.answer_text import phrase
from discostorm_planner.changes import Change
from discostorm_planner.protocol_changes import protocol_changes
from discostorm_planner.result import simulate_protocols

pytestmark = pytest.mark.usefixtures("few_runs")
DISTRIBUTIONS = read_data("vendors/ros.csv")


def test_domains_are_offered_only_where_they_keep_participants_apart() -> None:
    for name, protocol in ds.PROTOCOLS.items():
        plan = ds.plan(NAV2, protocol)
        if protocol.family is None:
            continue
        zenoh = name.startswith("Zenoh")
        assert protocol.family == ("Zenoh" if zenoh else "DDS")
        offered = any(r.kind == "domains" for r in plan.remedies)
        assert offered == (not zenoh and protocol.basis != "mitigated")
        assert any(
            r.startswith("splitting into domains: in Zenoh") for r in plan.not_applicable
        ) == (zenoh)
        arranged = [r for r in plan.not_applicable if r.startswith("splitting into domains with ")]
        assert bool(arranged) == (not zenoh and not offered)
        # tests/lab/test_snippets.py runs two domains at one server.
        if "Server" in name:
            assert "of all domains to each other" in arranged[0]
        assert "splitting across 2 channels" in {r.what for r in plan.remedies}


def test_of_an_unknown_table_it_is_said_that_nothing_is_known() -> None:
    own = ds.Protocol("own", ds.DDS.messages)
    plan = ds.plan(NAV2, own)
    assert "domains" not in {found.kind for found in plan.remedies}
    (said,) = (reason for reason in plan.not_applicable if "not known for own" in reason)
    assert said.endswith("whose family is neither DDS nor Zenoh")
    for title in ("splitting into domains", "Discovery Server", "router", "static peers"):
        assert title in said
    # The messages of such a table may lack roles.
    unknown = replace(ds.ZENOH, messages=tuple(replace(m, role=None) for m in ds.ZENOH.messages))
    left_out = ds.plan(NAV2, unknown).not_applicable
    assert "static peers: not known for Zenoh, whose messages have no roles" in left_out


@pytest.mark.parametrize("name", ds.PROTOCOLS)
def test_a_name_decides_nothing(name: str) -> None:
    """Every number and text of a plan equals that of the same table under another name."""
    mine = replace(ds.PROTOCOLS[name], name="(mine)")
    fleet = ds.Fleet((replace(ROBOTS, hosts=2), NAV2_WITH_NODES.groups[1]))
    for wifi, window in ((ds.PAPER, 1.0), (RADIO, math.inf)):
        plans = [ds.plan(fleet, table, wifi, window=window) for table in (ds.PROTOCOLS[name], mine)]
        usual, renamed = (
            [json.dumps(plan.to_dict(simulate=False)), " ".join(plan.why().split())]
            for plan in plans
        )
        told = zip(renamed, (name, phrase(name)), strict=True)
        assert [text.replace("(mine)", own) for text, own in told] == usual


@pytest.mark.parametrize("name", [n for n, p in ds.PROTOCOLS.items() if p.family])
def test_each_kind_of_remedy_is_computed_or_left_out_with_a_reason(name: str) -> None:
    table = ds.PROTOCOLS[name]
    plan = ds.plan(ds.Fleet.swarm(6, 3, 50), table)
    offered = {found.kind for found in plan.remedies if len(found.steps) == 1}
    switched = {found.kind for found in plan.remedies} - offered
    reasons = "\n".join(plan.not_applicable)
    rows = read_data("vendors/remedies.csv")
    for kind in {row["kind"] for row in rows}:
        of_kind = [row for row in rows if row["kind"] == kind]
        own = [row for row in of_kind if row["family"] in ("any", table.family)]
        if own and own[0]["table"] and own[0]["table"] not in set(ds.PROTOCOLS) - {name}:
            continue  # not measured yet, or already in use
        told = any(
            f"{row['title']}{after}" in reasons
            for row in own or of_kind
            for after in (": ", " with ")
        )
        assert (kind in offered) != told or kind in switched, kind
    assert "Not computed" not in plan.why()
    assert not hasattr(plan, "not_computed")


def test_every_row_of_the_remedies_has_what_it_needs() -> None:
    rows = read_data("vendors/remedies.csv")
    assert len({(row["kind"], row["family"]) for row in rows}) == len(rows)
    families = {row["family"] for row in read_data("vendors/families.csv")}
    assert {row["family"] for row in rows} == families | {"any"}
    efforts = {
        row["effort"]: int(row["rank"])
        for row in read_data("vendors/efforts.csv", "discostorm_planner")
    }
    assert sorted(efforts.values()) == list(range(1, len(efforts) + 1))
    for row in rows:
        assert row["works"] in ("computed", "no")
        assert row["all_find_each_other"] in ("yes", "no")
        assert row["gain"] in (("counted", "best case") if row["works"] == "computed" else ("",))
        assert all(row[column] for column in ("title", "why", "source"))
        assert bool(row["price"]) == bool(row["effort"]) == (row["works"] == "computed")
        assert not row["effort"] or row["effort"] in efforts
        assert not row["base"] or row["base"] in MEASURED
        arranged = row["family"] == "DDS" and row["table"] in MITIGATED
        assert bool(row["in_domains"]) == arranged
        assert len(f"{row['price']}; {row['fails']}") <= 150, row["title"]
    torn = {row["kind"] for row in rows if row["all_find_each_other"] == "no"}
    assert torn == {"channels", "domains"}
    pasted = {row["kind"] for row in read_data("vendors/snippets.csv")}
    assert pasted == {row["kind"] for row in rows} - {"hybrid", "release"}


def openings(fleet: ds.Fleet, sides: int) -> float:
    """Return the airtime of four KeepAlive-sized messages per session and dialing side."""
    processes = [host for host, own in enumerate(groups_as_toml(fleet)) for _ in own]
    pairs = sum(here < there for here in processes for there in processes)
    return sides * pairs * 4 * 2 * PAPER["unicast"](84)


def test_switching_to_zenoh_says_what_its_count_leaves_out() -> None:
    plan = ds.plan(FIG3, ds.DDS)
    zenoh = remedy(plan, "middleware")
    gap = plan.utilization - zenoh.utilization
    one, both = openings(FIG3, 1), openings(FIG3, 2)
    assert gap < one < both, "what is left out is larger than the gap"
    assert zenoh.note.endswith(
        f"adds {one:.2f} s if one side dials, {both:.2f} s if both do. "
        f"The protocols differ by {gap:.2f} s, so either may need less"
    )
    assert "we assume peers that scout by multicast" in zenoh.trade_offs
    assert "does not count the tokens of rmw_zenoh" in zenoh.trade_offs
    # The gap is the same in the other direction.
    assert remedy(ds.plan(FIG3, ds.ZENOH), "middleware").note == zenoh.note
    # With large processes, session openings are few.
    nav2 = remedy(ds.plan(NAV2, ds.DDS), "middleware")
    assert openings(NAV2, 2) < nav2.before - nav2.utilization
    assert f"{openings(NAV2, 2):.2f} s if both do" in nav2.note
    assert nav2.note.endswith("more than the sessions need")
    # A lone process opens no session, and an infinite window averages the setup away.
    assert remedy(ds.plan(ds.Fleet.swarm(1, 2, 5), ds.DDS), "middleware").note == ""
    for_ever = ds.plan(FIG3, ds.PROTOCOLS["DDS, periods of Fast DDS"], window=math.inf)
    assert {found.note for found in for_ever.remedies if found.kind == "middleware"} == {""}


def test_tables_are_compared_with_those_that_count_alike() -> None:
    paper = {"DDS", "Zenoh"}
    products = {name for name, table in ds.PROTOCOLS.items() if remedy_rules.product_of(table)}
    assert {"Fast DDS", "Cyclone DDS", "Zenoh peer"} <= products
    products -= MITIGATED
    for name, table in ds.PROTOCOLS.items():
        # A mitigated table can be reverted, but is no middleware to switch to.
        others = (
            products
            if name in MITIGATED
            else next(
                group
                for group in (paper, products, set(ds.PROTOCOLS) - paper - products - MITIGATED)
                if name in group
            )
        )
        switched = [r.protocol for r in ds.plan(FIG3, table).remedies if r.kind == "middleware"]
        # On Wi-Fi, a user cannot switch to a wired table or a proposal.
        never = {name, "hybrid", "hybrid, alike", *(row["table"] for row in MITIGATION_ROWS)}
        never |= {table.wired.name for table in ds.PROTOCOLS.values() if table.wired}
        never.add("Zenoh peer")  # ROS 2's own variant has tokens
        # Of a product with releases, a user switches to what the robots' distribution ships.
        ships = [row for row in DISTRIBUTIONS if row["protocol"] == name] or DISTRIBUTIONS
        ros = [row["ros"] for row in ships if row["long_term"] == "yes"][-1]
        shipped = {row["protocol"] for row in DISTRIBUTIONS if row["ros"] == ros}
        if table.basis == "measured" or name in MITIGATED:
            never |= {"Fast DDS", *(row["protocol"] for row in DISTRIBUTIONS)} - shipped
        # Another release of the same product is no other middleware.
        alike = remedy_rules.product_of(table)
        own = {one for one in others if remedy_rules.product_of(ds.PROTOCOLS[one]) == alike}
        never |= own if table.basis == "measured" else set()
        expected = set() if name.startswith("hybrid") else others - never
        assert {other.name for other in switched} == expected
        assert all(ds.PROTOCOLS[other.name] == other for other in switched)
    # DDS tables have no sessions to open.
    plan = ds.plan(FIG3, ds.PROTOCOLS["DDS, periods of Fast DDS"])
    notes = {r.protocol.name: r.note for r in plan.remedies if r.kind == "middleware"}
    assert notes["DDS, periods of Cyclone DDS"] == ""
    assert "opens sessions" in notes["Zenoh, periods of Zenoh peer"]
    # Measured tables count the sessions themselves.
    plan = ds.plan(FIG3, ds.PROTOCOLS["Fast DDS"])
    assert {r.note for r in plan.remedies if r.kind == "middleware"} == {""}


def test_a_table_of_ones_own_may_switch_to_both() -> None:
    own = ds.Protocol("own", ds.DDS.messages[:2])
    plan = ds.plan(FIG3, own)
    assert [r.protocol.name for r in plan.remedies if r.kind == "middleware"] == ["Zenoh", "DDS"]
    assert "raises" in remedy(plan, "middleware", 1).sentence()


def test_a_table_that_is_not_there_is_not_offered_and_one_that_is_there_is(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    name = "Fast DDS Discovery Server"
    fast_dds, others = ds.PROTOCOLS["Fast DDS"], dict(ds.PROTOCOLS)
    others.pop(name, None)
    for module in (remedy_rules, table_module):
        monkeypatch.setattr(module, "PROTOCOLS", others)
    assert "discovery server" not in {r.kind for r in ds.plan(NAV2, fast_dds).remedies}
    server = replace(fast_dds, name=name, messages=fast_dds.messages[:3], key=name)
    for module in (remedy_rules, table_module):
        monkeypatch.setattr(module, "PROTOCOLS", others | {name: server})
    found = remedy(ds.plan(NAV2, fast_dds), "discovery server")
    assert (found.protocol, found.note) == (server, "")
    assert found.utilization == ds.utilization(server, NAV2)
    assert found.failure_mode.startswith("late joiners stay undiscovered while the server is down")
    assert {s.file for s in found.snippets} >= {"fast_dds_server.sh", "fast_dds_client.sh"}
    # The paper's DDS is compared with the configuration by the product's measured table.
    papers = remedy(ds.plan(NAV2, ds.DDS), "discovery server")
    assert papers.before == ds.utilization(fast_dds, NAV2)
    assert papers.note == "both values use the measured model of Fast DDS"
    # For another product, this is a switch as well.
    bare = ds.Wifi("own", ds.PAPER.unicast, ds.PAPER.multicast)
    cyclone = ds.plan(NAV2, ds.PROTOCOLS["Cyclone DDS"], bare)
    switched = remedy(cyclone, "discovery server")
    assert switched.steps == ("middleware", "discovery server")
    assert not any("Discovery Server" in reason for reason in cyclone.not_applicable)
    assert all("discovery server" not in r.steps or len(r.steps) > 2 for r in cyclone.combinations)
    # With this server table, the product's default is not among the server configurations.
    served = ds.plan(NAV2, replace(server, basis="mitigated"))
    assert server.family == "DDS"
    assert remedy_rules.product_of(server) == "Fast DDS"
    assert "Fast DDS 3.6" in {r.protocol.name for r in served.remedies if r.kind == "middleware"}


def test_whoever_switches_gets_the_release_of_the_distribution() -> None:
    def changes(protocol: str, ros: str | None = None) -> dict[str, Change]:
        found = protocol_changes(ds.PROTOCOLS[protocol], ros)
        return {change.what: change for change in found if isinstance(change, Change)}

    server = "switching to Fast DDS with a Discovery Server"
    fleet = ds.Fleet((replace(ROBOTS, hosts=4),))
    filtering = ds.utilization(ds.PROTOCOLS["Fast DDS Discovery Server"], fleet)
    for ros, release, forwards in (
        (None, "Fast DDS 3.6", True),
        ("lyrical", "Fast DDS 3.6", True),
        ("kilted", "Fast DDS 3.6", False),  # ships 3.2.5, whose servers filter
        ("jazzy", "Fast DDS 2.14", False),
    ):
        of = changes("Zenoh peer, tokens", ros)
        assert f"switching to {release}" in of
        assert "switching to Fast DDS" not in of
        table = of[server].table
        assert table is not None
        assert (ds.utilization(table, fleet) > filtering) == forwards
        assert ("forwards everything, as in Fast DDS 3.6" in of[server].note) == forwards
        assert (f"{server} on a robot" in of) == (not forwards)
    # Of a release's own table: as its distribution has it, else the newest that ships it.
    for ros, forwards in ((None, True), ("kilted", False)):
        table = changes("Fast DDS 3.6", ros)["a Discovery Server"].table
        assert table is not None
        assert (ds.utilization(table, fleet) > filtering) == forwards
    assert "switching to Cyclone DDS" in changes("Fast DDS 2.14")
    assert "switching to Cyclone DDS 11" in changes("Fast DDS 3.6")
    assert "switching to Cyclone DDS" in changes("Fast DDS 3.6", "kilted")


def test_the_option_ros_decides_what_others_switch_to() -> None:
    def offered(*ros: str) -> list[str]:
        fleet = ("plan", "--hosts", "4", "--processes", "2", "--endpoints", "10")
        told = (
            CliRunner().invoke(main, [*fleet, "--protocol", "rmw_zenoh_cpp", *ros, "--csv"]).stdout
        )
        return [row["remedy"] for row in DictReader(told.splitlines())]

    assert "switching to Fast DDS 3.6" in offered()
    assert "switching to Fast DDS 2.14" in offered("--ros", "jazzy")


@pytest.mark.parametrize("name", ["Fast DDS", "Cyclone DDS", "Zenoh peer, tokens"])
def test_every_measured_configuration_of_every_product_is_a_change_that_can_be_had_alone(
    name: str,
) -> None:
    (robot,) = (host for kind, host in robots_by_name().items() if kind == "TurtleBot 4 with Nav2")
    wifi = ds.Radio("802.11ac", streams=2, width=80e6, mpdus=64).wifi()
    plan = ds.plan(ds.Fleet((replace(robot, hosts=12),)), ds.PROTOCOLS[name], wifi)
    offered = {found.protocol.name: found for found in plan.remedies}
    tables = {row["table"] for row in MITIGATION_ROWS}
    if name == "Zenoh peer, tokens":  # of Lyrical, whose servers forward everything
        tables -= {"Fast DDS Discovery Server, on a robot"}
    assert tables <= set(offered)
    router = offered["Zenoh router"]
    if name != "Zenoh peer, tokens":
        assert router.steps == ("middleware", "router")
        assert router.efforts == ("switch", "server")
        assert router.effort_rank == 8
        server = offered["Fast DDS Discovery Server"]
        assert router.range_after is not None
        assert server.range_after is not None
        assert router.range_after.full < server.range_after.full
        # No change makes the fleet fit, so the largest saving comes first.
        first = offered["Zenoh router per host"]
        assert first in [r for r in plan.remedies if r.all_discover][:3]
        assert first.efforts == ("switch", "servers")
        assert first.range_after is not None
        assert first.range_after.full < 2 < router.range_after.full


def test_configurations_are_compared_in_one_table() -> None:
    plan = ds.plan(NAV2_WITH_NODES, ds.PROTOCOLS["Fast DDS"])
    large = ds.plan(ds.Fleet.swarm(200, 20, 100), ds.PROTOCOLS["Fast DDS"])
    simulate_protocols([plan, large])  # without changes, which take longest
    rows = {row.name: row for row in plan.configurations}
    wired = {table.wired.name for table in ds.PROTOCOLS.values() if table.wired}
    assert set(rows) == {*MEASURED, *MITIGATED, *product_releases()} - wired
    assert rows["Fast DDS"].utilization == plan.utilization
    assert [row.startup.single for row in plan.configurations] == sorted(
        row.startup.single for row in rows.values()
    )
    for name, row in rows.items():
        steady = ds.utilization(ds.PROTOCOLS[name], NAV2_WITH_NODES, window=math.inf)
        assert row.steady_range.single == steady
        start = ds.drain_time(ds.PROTOCOLS[name], NAV2_WITH_NODES)
        assert row.startup.single == pytest.approx(start)
        assert f"  {name} " in plan.why()
    told = plan.to_dict(simulate=False)["configurations"]
    assert [row["protocol"] for row in told] == list(rows)
    # A startup that never ends is reported as such; JSON has no infinity.
    assert "never done" in large.why()
    assert None in {row["start_s"] for row in large.to_dict(simulate=False)["configurations"]}


def test_calmer_announcements_are_those_of_the_snippet() -> None:
    for name, period in (("Fast DDS", 15), ("Cyclone DDS", 30)):
        table = ds.PROTOCOLS[name]
        found = remedy(ds.plan(NAV2, table, window=float("inf")), "announcements")
        assert found.protocol.lease == 100
        assert found.protocol.message("SPDP").schedule.period == period
        assert found.protocol.messages != table.messages
        assert found.saved > 0.5
        (piece,) = found.snippets
        assert f"{period}" in piece.text
        assert "100" in piece.text


def test_static_peers_of_zenoh_leave_out_scouting_alone() -> None:
    table = ds.PROTOCOLS["Zenoh peer"]
    plan = ds.plan(NAV2, table)
    found = remedy(plan, "peers")
    gone = {m.name for m in table.messages} - {m.name for m in found.protocol.messages}
    assert gone == {m.name for m in table.of_phase("Scouting")}
    assert found.utilization == ds.utilization(found.protocol, plan.fleet)


def test_what_the_fleet_says_is_shared_is_counted_and_nothing_is_added() -> None:
    """A ROS 2 participant has 2 always-matching endpoints, and each node 2 more."""
    server = ds.PROTOCOLS["Fast DDS Discovery Server"]
    plan = ds.plan(NAV2_WITH_NODES)
    assert plan.fleet is NAV2_WITH_NODES
    assert [group["shared"] for group in plan.to_dict(simulate=False)["fleet"]] == [28, 6]
    found = remedy(plan, "discovery server")
    assert found.utilization == ds.utilization(server, NAV2_WITH_NODES) > 2
    assert not found.now_fits
    # Programs without ROS 2 have no always-matching endpoints, so a server suffices.
    without = remedy(ds.plan(NAV2), "discovery server")
    assert without.now_fits
    assert without.utilization == ds.utilization(server, NAV2) < 1
    # The paper's tables have no topic names.
    assert plan.utilization == ds.utilization(ds.DDS, NAV2)
    # Composing keeps always-matching endpoints; removing services keeps at most all endpoints.
    small = ds.plan(ds.Fleet((ds.HostGroup(4, 3, 14, nodes=1, shared=4),)))
    (composed,) = remedy(small, "processes").fleets
    (fewer,) = remedy(small, "endpoints").fleets
    assert [fleet.groups[0].shared for fleet in (composed, fewer)] == [12, 2]


@pytest.mark.parametrize("name", ["DDS", "Zenoh", "Fast DDS", "Cyclone DDS", "Zenoh peer"])
def test_every_remedy_that_can_be_done_says_what_to_paste(name: str) -> None:
    plan = ds.plan(ds.Fleet.swarm(6, 3, 50), ds.PROTOCOLS[name])
    for found in (*plan.remedies, *plan.combinations):
        by_hand = found.kind in ("hybrid", "release")
        if by_hand or (found.kind == "middleware" and found.protocol == ds.DDS):
            assert not found.snippets
            continue
        assert found.snippets, found.what
    for found in plan.remedies:
        if found.kind == "radio":
            (piece,) = found.snippets
            width = found.wifi.radio.width / 1e6 if found.wifi.radio else 0
            assert f"{width:.0f}mhz" in piece.file


def test_peers_of_zenoh_are_pasted_what_is_counted_and_routers_are_not() -> None:
    plan = ds.plan(ds.Fleet((ds.HostGroup(12, 2, 30, shared=4),)), ds.PROTOCOLS["Fast DDS"])
    files = {
        r.protocol.name: {piece.file for piece in r.snippets}
        for r in (*plan.remedies, *plan.combinations)
        if "middleware" in r.steps
    }
    assert "zenoh_session.json5" in files["Zenoh peer, tokens"]
    routed = [found for name, found in files.items() if name.startswith("Zenoh router")]
    assert routed
    assert all("zenoh_session.json5" not in found for found in routed)


#: Efforts of each kind of change: a setting, a file, other hardware, rebuilt nodes.
EFFORTS = {
    "aggregation": ("radio",),
    "discovery server": ("server",),
    "discovery server on a robot": ("server",),
    "endpoints": ("build",),
    "hybrid": ("research",),
    "middleware": ("switch",),
    "multicast endpoint data": ("file",),
    "multicast rate": ("setting",),
    "peers": ("file",),
    "processes": ("build",),
    "radio": ("radio",),
    "staggered start": ("setting",),
    "static endpoints": ("build",),
    "two discovery servers": ("servers",),
}


def test_each_change_has_its_effort() -> None:
    plan = ds.plan(ds.Fleet.swarm(3, 8, 20))
    assert {r.kind: r.efforts for r in plan.remedies if len(r.steps) == 1} == EFFORTS
