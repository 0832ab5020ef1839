"""Fleets from ROS 2's output, compared with counts by hand; other texts are refused."""

import json
import re
from pathlib import Path

import pytest
from click.testing import CliRunner, Result
from support import REFERENCE

import discostorm as ds
from discostorm.cli import main
from discostorm.data import read_data
from discostorm_planner.ros2_output import fleet_from_graph, parse_ros2_output

TEXTS = REFERENCE / "ros2"

#: Endpoints by hand: 6 parameter services of 2, /rosout, a publisher and a subscription of
#: /parameter_events. The driver adds two publishers, a subscription and a service; the navigator
#: adds a publisher, a subscription, a client and an action.
NODE = 6 * 2 + 1 + 2
DRIVER, NAVIGATOR = NODE + 3 + 2, NODE + 2 + 2 + 8


def text(name: str) -> str:
    return (TEXTS / f"{name}.txt").read_text(encoding="utf-8")


def run(*words: str, **given: str) -> Result:
    return CliRunner().invoke(main, ["fleet", "--from", *words], **given)  # type: ignore[arg-type]


def test_nodes_of_one_robot_are_counted() -> None:
    seen = parse_ros2_output(text("one_robot"), "x")
    assert seen.nodes == {"/driver": DRIVER, "/navigator": NAVIGATOR}
    assert seen.services == {"/driver", "/navigator"}
    fleet, notes = fleet_from_graph(seen, hosts=12)
    (group,) = fleet.groups
    # Each node runs in a separate process, which has two more endpoints.
    assert group.counts() == (12, 2, (DRIVER + NAVIGATOR) / 2 + 2)
    assert (group.nodes, group.shared) == (1, 4)
    assert any("which nodes share a process" in note for note in notes)
    composed, notes = fleet_from_graph(seen, hosts=12, processes=1)
    assert composed.groups[0].counts() == (12, 1, DRIVER + NAVIGATOR + 2)
    assert composed.groups[0].nodes == 2
    assert not any("which nodes share a process" in note for note in notes)


def test_namespaces_with_the_same_nodes_are_robots() -> None:
    seen = parse_ros2_output(text("two_robots"), "x")
    fleet, notes = fleet_from_graph(seen)
    robots, rest = fleet.groups
    assert (robots.name, robots.hosts, robots.processes) == ("robot_1 to robot_2", 2, 2)
    assert rest.counts() == (1, 1, NODE + 8 + 2)
    assert any("have the same node names, so we count 2 robots" in note for note in notes)
    together, _ = fleet_from_graph(seen, hosts=1)
    assert [group.processes for group in together.groups] == [5]


def test_namespaces_of_one_robot_are_no_robots() -> None:
    costmaps = "/global_costmap/global_costmap\n/local_costmap/local_costmap\n/amcl\n"
    (group,) = fleet_from_graph(parse_ros2_output(costmaps, "x"))[0].groups
    assert group.counts() == (1, 3, NODE + 2)


def test_a_list_alone_counts_what_every_node_has() -> None:
    fleet, notes = fleet_from_graph(parse_ros2_output("/a\n/b\n", "x"))
    assert fleet.groups[0].counts() == (1, 2, NODE + 2)
    assert any("2 of 2 nodes have no `ros2 node info`" in note for note in notes)


def test_topics_alone_have_as_many_nodes_as_publish_rosout() -> None:
    seen = parse_ros2_output(text("topics"), "x")
    fleet, notes = fleet_from_graph(seen)
    # 7 publishers and 4 subscriptions, and 6 parameter services for each of two nodes.
    assert fleet.groups[0].counts() == (1, 2, (7 + 4 + 2 * 12) / 2 + 2)
    assert any("A list of topics names no nodes" in note for note in notes)


def test_hidden_parts_of_actions_are_not_counted_twice() -> None:
    assert parse_ros2_output(text("hidden"), "x").nodes == {"/navigator": NODE + 8}


def test_the_file_can_be_planned_and_says_what_was_never_tried(tmp_path: Path) -> None:
    done = run(str(TEXTS / "two_robots.txt"), "--hosts", "3")
    assert done.exit_code == 0, done.output
    said = " ".join(line.removeprefix("# ") for line in done.stdout.splitlines())
    for command in ("ros2 node list", "ros2 node info"):
        (row,) = (row for row in read_data("fleets/ros2_formats.csv") if row["command"] == command)
        assert row["tried"] == "no"
        assert f"`{command}` ({row['releases']})" in said
    assert "Never tried on a live system: `ros2 node list`, `ros2 node info`;" in said
    file = tmp_path / "fleet.toml"
    file.write_text(done.stdout, encoding="utf-8")
    read = ds.Fleet.from_toml(file)
    assert read == fleet_from_graph(parse_ros2_output(text("two_robots"), "x"), hosts=3)[0]
    answer = json.loads(run(str(TEXTS / "two_robots.txt"), "--hosts", "3", "--json").stdout)
    assert answer["groups"] == read.to_dicts()
    assert answer["notes"][0].startswith("Formats: ")


def test_standard_input_is_read() -> None:
    assert run("-", input=text("one_robot")).stdout == run(str(TEXTS / "one_robot.txt")).stdout


def test_every_format_has_a_text() -> None:
    seen = [set(parse_ros2_output(text(name), "x").commands) for name in ("two_robots", "topics")]
    assert set.union(*seen) == {row["command"] for row in read_data("fleets/ros2_formats.csv")}
    readme = (TEXTS / "README.md").read_text(encoding="utf-8")
    assert {path.name for path in TEXTS.glob("*.txt")} == set(re.findall(r"`(\w+\.txt)`", readme))


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ("", "standard input must hold the output of `ros2 node list` or"),
        ("hello\n", "standard input, line 1: 'hello' is not the output of any of these commands: "),
        ("/a\n  Subscribers:\n    nonsense\n", "standard input, line 3: 'nonsense' is not"),
        ("    /odom: nav_msgs/msg/Odometry\n", "standard input, line 1: "),
        (text("dashing"), "line 6: `ros2 node info` in ROS 2 Crystal"),
        ("The daemon is not running\n", "standard input, line 1: "),
    ],
)
def test_another_text_is_refused_with_its_line(given: str, message: str) -> None:
    done = run("-", input=given)
    assert done.exit_code == 2
    assert message in " ".join(done.stderr.split())
    assert done.stdout == ""


def test_bad_files_and_counts_are_refused(tmp_path: Path) -> None:
    odd = tmp_path / "odd.txt"
    odd.write_bytes(b"\xff\xfe/\x00a\x00")
    for words, message in (
        ([str(odd)], "odd.txt must be text in UTF-8"),
        ([str(tmp_path / "none.txt")], "No such file"),
        (
            [str(TEXTS / "one_robot.txt"), "--processes", "3"],
            "must be at most 2, the node count; got 3",
        ),
        ([str(TEXTS / "one_robot.txt"), "--hosts", "0"], "hosts must be a finite number"),
    ):
        done = run(*words)
        assert (done.exit_code, done.stdout) == (2, "")
        assert message in done.stderr
