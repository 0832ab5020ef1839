"""Questions in the user's words: names that people use, ready-made robots, several products."""

import csv
import io
import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner, Result

import discostorm as ds
from discostorm import robots
from discostorm.cli import main
from discostorm.data import data_path
from discostorm.ros2_endpoints import likely_shared

SWARM = ["--hosts", "3", "--processes", "2", "--endpoints", "10"]
#: Every command that takes a fleet, with what makes it quick.
COMMANDS = {
    "utilization": [],
    "breakdown": [],
    "saturation": [],
    "plan": [],
    "simulate": ["--runs", "1", "--until", "1"],
}


def run(*words: str, columns: int = 79) -> Result:
    return CliRunner(env={"COLUMNS": str(columns)}).invoke(main, list(words))


def answer(*words: str) -> Any:
    done = run(*words, "--json")
    assert done.exit_code == 0, done.output
    return json.loads(done.stdout)


def sharing_fleet(hosts: int, processes: int, endpoints: int) -> ds.Fleet:
    """Return the fleet that options describe, whose processes share the topics of ROS 2."""
    shared = likely_shared(endpoints)
    return ds.Fleet((ds.HostGroup(hosts, processes, endpoints, shared=shared),))


def test_commands_take_the_measured_fast_dds_unless_told_otherwise() -> None:
    fast, fleet = ds.PROTOCOLS["Fast DDS 3.6"], sharing_fleet(3, 2, 10)
    (row,) = answer("utilization", *SWARM)
    assert row["utilization"] == ds.utilization(fast, fleet)
    (row,) = answer("saturation", *SWARM[2:])
    assert row["hosts"] == ds.saturation_hosts(fast, fleet=fleet)
    assert {row["protocol"] for row in answer("breakdown", *SWARM)} == {"Fast DDS 3.6"}
    assert answer("plan", *SWARM)["protocol"] == "Fast DDS 3.6"
    assert answer("simulate", *SWARM, "--runs", "1", "--until", "1")["protocol"] == "Fast DDS 3.6"
    # Functions keep their own.
    assert ds.plan(ds.Fleet.swarm(3, 2, 10)).protocol == ds.DDS


def test_plans_simulations_and_captures_take_names_and_the_papers_channel() -> None:
    fleet, radio = ds.Fleet.swarm(3, 2, 10), ds.Radio("802.11ac", width=80e6, streams=2)
    fast, wifi = ds.PROTOCOLS["Fast DDS 3.6"], ds.WIFI["802.11ac 80 MHz 2x2"]
    capture = ds.read_capture(data_path("captures/fast_dds.pcap.xz", "discostorm_capture"))
    calls: list[Callable[..., Any]] = [
        lambda *given: ds.plan(fleet, *given).to_dict(),
        lambda *given: ds.simulate(fleet, *given, until=1, seed=3).to_dict(),
        lambda protocol, wifi=ds.PAPER: capture.compare(protocol, wifi=wifi).to_csv(),
        lambda _, wifi=ds.PAPER: capture.sums(wifi).to_csv(),
        lambda protocol, _=ds.PAPER: capture.compared_seconds(protocol),
    ]
    for call in calls:
        assert call("fastdds", "802.11ac 80 MHz") == call(fast, radio) == call(fast, wifi)
        assert call("fastdds") == call(fast, ds.PAPER)
    for refusing in calls[:3]:
        with pytest.raises(ValueError, match=r"got 'fastdss'\. Did you mean 'Fast DDS'"):
            refusing("fastdss")


@pytest.mark.parametrize("command", COMMANDS)
def test_several_products_are_compared_in_one_table(command: str) -> None:
    swarm = SWARM[2:] if command == "saturation" else SWARM
    several = [word for one in ("zenoh", "fastdds", "cyclonedds") for word in ("--protocol", one)]
    words = [command, *swarm, *several, *COMMANDS[command]]
    found = list(dict.fromkeys(row["protocol"] for row in answer(*words)))
    expected = ["Cyclone DDS, version 11", "Fast DDS 3.6", "Zenoh"]
    # A plan has the shortest discovery first.
    assert (sorted(found) if command == "plan" else found) == expected
    expected = found
    table = run(*words).stdout
    lines = [re.search(rf"^(protocol +)?{name}\b", table, re.MULTILINE) for name in expected]
    places = [line.start() for line in lines if line]
    assert places == sorted(places)
    assert len(places) == len(expected)
    rows = list(csv.DictReader(io.StringIO(run(*words, "--csv").stdout)))
    assert list(dict.fromkeys(row["protocol"] for row in rows)) == expected
    assert max(map(len, table.splitlines())) <= 79


def test_recovery_that_is_not_simulated_beside_others_is_told() -> None:
    words = ["simulate", *SWARM, "--runs", "1", "--until", "1"]
    served = "Fast DDS Discovery Server, on a robot"
    done = run(*words, "--protocol", "fastdds", "--protocol", served)
    assert done.exit_code == 0
    assert f"Note: We do not simulate recovery with {served}" in done.stderr
    assert served in done.stdout
    assert done.stdout.count("not simulated") == 1
    alone = run(*words, "--protocol", served)
    assert alone.stdout.startswith("Drain time: ")


@pytest.mark.parametrize("command", COMMANDS)
def test_a_robot_works_in_every_command(command: str) -> None:
    done = run(command, "--robot", "node", "--hosts", "3", *COMMANDS[command])
    assert done.exit_code == 0, done.output


def test_a_capture_is_compared_with_a_robot(tmp_path: Path) -> None:
    packed = data_path("captures/fast_dds.pcap.xz", "discostorm_capture")
    rows = answer("capture", str(packed), "--robot", "node", "--hosts", "3")["messages"]
    fleet = tmp_path / "fleet.toml"
    fleet.write_text(
        "[[groups]]\nhosts = 3\nprocesses = 1\nendpoints = 18\nnodes = 1\nshared = 4\n"
    )
    assert rows == answer("capture", str(packed), "--fleet", str(fleet))["messages"]
    refused = run("capture", str(packed), "--hosts", "3")
    assert (refused.exit_code, "--hosts needs --robot" in refused.stderr) == (2, True)


def test_a_robot_is_counted_as_in_python() -> None:
    group = robots.robot("turtlebot4")
    assert group == robots.robots()["TurtleBot 4 with Nav2"]
    rows = answer("utilization", "--robot", "turtlebot4", "--hosts", "2,12")
    for row, hosts in zip(rows, (2, 12), strict=True):
        fleet = ds.Fleet((ds.HostGroup(hosts, *group.counts()[1:], "x", shared=group.shared),))
        assert (row["robot"], row["hosts"]) == (group.name, hosts)
        assert row["utilization"] == ds.utilization(ds.PROTOCOLS["Fast DDS 3.6"], fleet)
    told = answer("plan", "--robot", "tb4", "--hosts", "2")["fleet"]
    assert [(one["name"], one["hosts"], one["shared"]) for one in told] == [
        (group.name, 2, group.shared)
    ]


def test_plan_takes_counts_as_its_sisters_do() -> None:
    fleet = sharing_fleet(12, 2, 40)
    words = ["--hosts", "12", "--processes", "2", "--endpoints", "40"]
    told = answer("plan", *words)
    assert told == ds.plan(fleet, ds.PROTOCOLS["Fast DDS 3.6"]).to_dict()
    (row,) = answer("utilization", *words)
    assert row["utilization"] == pytest.approx(told["utilization"], rel=1e-12)
