"""The folder of ``plan --write``: what each host gets, written whole or not at all."""

import os
import re
import shlex
import subprocess
from dataclasses import replace
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import pytest
from click.testing import CliRunner

import discostorm as ds
from discostorm import files
from discostorm.cli import main
from discostorm.data import read_data
from discostorm.host_configuration_files import groups_by_host_name
from discostorm.snippets import snippets
from discostorm_planner.configuration_folder import texts_by_path

FLEET = """
ros = "humble"
domain = 5
[[groups]]
name = "robots"
robot = "turtlebot4"
hosts = 3
[[groups]]
name = "laptop"
hosts = 1
processes = 2
endpoints = 90
[addresses]
server = "192.168.1.9"
robot1 = "192.168.1.31"
robot2 = "192.168.1.32"
"""
CYCLONE = ("--protocol", "Cyclone DDS", "--paste", "peers")


def written(tmp_path: Path, *options: str, fleet: str = FLEET) -> Path:
    """Return the folder that the command writes."""
    (tmp_path / "fleet.toml").write_text(fleet)
    folder = tmp_path / "out"
    done = run("plan", str(tmp_path / "fleet.toml"), *options, "--write", str(folder))
    assert done.exit_code == 0, done.output
    assert " first\n" in done.stdout
    return folder


def run(*arguments: str) -> Any:
    return CliRunner().invoke(main, list(arguments))


def test_each_host_gets_addresses_domain_and_units_for_a_discovery_server(tmp_path: Path) -> None:
    folder = written(tmp_path, "--paste", "discovery server")
    assert {path.name for path in folder.iterdir()} == {
        *("README.md", "server", "robot1", "robot2", "robot3", "laptop1", "by_hand"),
    }
    for host in ("robot1", "robot2", "robot3", "laptop1"):
        variables = (folder / host / "etc" / "ros2_discovery.env").read_text()
        assert 'ROS_DISCOVERY_SERVER="192.168.1.9:11811"' in variables
        assert 'ROS_DOMAIN_ID="5"' in variables
    for tools in ("super_client.sh", "super_client.xml"):
        assert "192.168.1.9" in (folder / "by_hand" / f"fast_dds_{tools}").read_text()
    unit = (folder / "server/etc/systemd/system/fast-dds-server.service").read_text()
    assert "/opt/ros/humble/setup.bash && exec fastdds discovery -i 0 -l 192.168.1.9 -p 118" in unit
    text = (folder / "README.md").read_text()
    for name, address in (("server", "192.168.1.9"), ("robot2", "192.168.1.32")):
        assert f"| `{name}` | {address} |" in text
    assert re.findall("- `(.*)`", text) == ["ADDRESS_OF_robot3", "ADDRESS_OF_laptop1"]
    assert "22 processes with 928 endpoints in all" in text
    assert "{" not in text.replace("{print", "")
    assert "192.168.1.10" not in "".join(p.read_text() for p in folder.rglob("*") if p.is_file())


@pytest.mark.parametrize("address", ["192.168.1.21", "192.168.1.10", "192.168.1.11"])
@pytest.mark.parametrize(
    ("protocol", "change"), [("Fast DDS", "two discovery servers"), ("Zenoh", "star of routers")]
)
def test_addresses_may_be_those_of_the_samples(address: str, protocol: str, change: str) -> None:
    given = (("server", address), ("server1", address), ("server2", "192.168.1.20"))
    fleet = replace(ds.Fleet.swarm(3, 2, 10), addresses=given)
    said = "\n".join(texts(change, protocol, fleet).values())
    servers = {"Fast DDS": f'"{address}:11811;192.168.1.20:11811"', "Zenoh": f"tcp/{address}:7447"}
    assert servers[protocol] in said


def test_cyclone_dds_lists_every_host_and_has_an_index_for_each_process(tmp_path: Path) -> None:
    folder = written(tmp_path, *CYCLONE)
    names = "{https://cdds.io/config}"
    for host in ("robot1", "laptop1"):
        tree = ElementTree.parse(folder / host / "etc" / "cyclonedds.xml")
        peers = [peer.get("Address") for peer in tree.iter(f"{names}Peer")]
        unknown = ["ADDRESS_OF_robot3", "ADDRESS_OF_laptop1"]
        assert peers == ["192.168.1.31", "192.168.1.32", *unknown]
        (most,) = tree.iter(f"{names}MaxAutoParticipantIndex")
        assert most.text == "22"
        variables = (folder / host / "etc" / "ros2_discovery.env").read_text()
        assert 'CYCLONEDDS_URI="file:///etc/cyclonedds.xml"' in variables
        assert "ROS_STATIC_PEERS" not in variables  # in place of the file, not beside it
    assert "ROS_STATIC_PEERS" in (folder / "by_hand" / "ros_static_peers.sh").read_text()


def texts(kind: str, protocol: str, fleet: ds.Fleet) -> dict[str, str]:
    plan = ds.plan(fleet, ds.PROTOCOLS[protocol])
    return texts_by_path(fleet, plan.find_change(kind), plan.within)


def test_zenoh_hosts_dial_the_hosts_before_them() -> None:
    fleet = ds.Fleet.swarm(3, 2, 10)
    of = texts("peers", "Zenoh peer, tokens", fleet)
    dialed = [
        re.findall(r"tcp/(ADDRESS_OF_\w+):7447", of[f"robot{n}/etc/zenoh_session.json5"])
        for n in (1, 2, 3)
    ]
    assert dialed == [[], ["ADDRESS_OF_robot1"], ["ADDRESS_OF_robot1", "ADDRESS_OF_robot2"]]
    assert not re.search(r"^ *,", of["robot1/etc/zenoh_session.json5"], re.M)
    of = texts("router on each host", "Zenoh peer, tokens", fleet)
    assert "endpoints: []" in of["robot1/etc/zenoh_router.json5"]
    unit = of["robot2/etc/systemd/system/zenoh-router.service"]
    assert "Environment=ZENOH_ROUTER_CONFIG_URI=/etc/zenoh_router.json5\n" in unit
    assert "exec ros2 run rmw_zenoh_cpp rmw_zenohd'" in unit
    assert "ROUTER" not in of["robot2/etc/ros2_discovery.env"]
    of = texts("router", "Zenoh peer, tokens", fleet)
    assert "server/etc/zenoh_router.json5" in of
    assert (
        'connect: { endpoints: ["tcp/ADDRESS_OF_server:7447"] }'
        in (of["robot3/etc/zenoh_session.json5"])
    )


def test_two_servers_and_a_server_on_a_robot_have_their_own_addresses() -> None:
    fleet = ds.Fleet.swarm(3, 2, 10)
    of = texts("two discovery servers", "Fast DDS", fleet)
    for number in (1, 2):
        unit = of[f"server{number}/etc/systemd/system/fast-dds-server.service"]
        assert f"fastdds discovery -i {number - 1} -l ADDRESS_OF_server{number} -p" in unit
    both = "ADDRESS_OF_server1:11811;ADDRESS_OF_server2:11811"
    assert both in of["robot1/etc/ros2_discovery.env"]
    of = texts("discovery server on a robot", "Fast DDS", fleet)
    assert "-l ADDRESS_OF_robot1 " in of["robot1/etc/systemd/system/fast-dds-server.service"]
    assert not any("fast-dds-server" in path for path in of if not path.startswith("robot1/"))


def test_a_staggered_start_waits_within_the_window_of_the_plan() -> None:
    fleet = ds.Fleet.swarm(12, 2, 10)
    of = texts("staggered start", "Fast DDS", replace(fleet, within=10))
    assert "\nWINDOW=5\n" in of["robot12/etc/staggered_start.sh"]
    unit = of["robot12/etc/systemd/system/robot.service.d/discovery.conf"]
    assert "ExecStartPre=/bin/bash /etc/staggered_start.sh\nTimeoutStartSec=95\n" in unit
    # Every path after the slash is one of the folder's.
    readme = of["README.md"]
    assert "systemctl cat robot | grep staggered" in readme
    assert "We assume that the service `robot` starts ROS 2" in readme


def test_what_the_readme_says_to_run_are_lines_of_a_shell(tmp_path: Path) -> None:
    folder = written(tmp_path, "--paste", "discovery server")
    text = (folder / "README.md").read_text()
    blocks = re.findall(r"```\n(.*?)```", text, re.S)
    commands = [b for b in blocks if re.match("scp|ssh|sudo|ss |for|systemctl", b)]
    assert len(commands) >= 6
    for block in commands:
        subprocess.run(["bash", "-n"], input=block, text=True, check=True)
    # Going back removes exactly what copying brought.
    for host in ("server", "robot1"):
        (section,) = re.findall(rf"## On [^\n]*`{host}`.*?(?=\n## |\Z)", text, re.S)
        (removed,) = re.findall(r"for file in (.*); do", section)
        there = {
            f"/{p.relative_to(folder / host)}" for p in (folder / host).rglob("*") if p.is_file()
        }
        assert set(shlex.split(removed)) == there


@pytest.mark.skipif(not Path("/proc/self/environ").exists(), reason="needs /proc")
def test_the_check_prints_what_the_readme_says(tmp_path: Path) -> None:
    folder = written(tmp_path, "--paste", "discovery server")
    text = (folder / "README.md").read_text()
    (command,) = re.findall(r"```\nsudo (grep .*)\n```", text)
    (expected,) = re.findall(r"prints:\n\n```\n(ROS.*?)```", text, re.S)
    # As a service or a shell would run it: with the variables of the file.
    file = folder / "robot1" / "etc" / "ros2_discovery.env"
    shell = f"set -a; . {file}; set +a; exec sleep 60"
    with subprocess.Popen(["bash", "-c", shell]) as running:
        try:
            while Path(f"/proc/{running.pid}/comm").read_text() != "sleep\n":
                pass
            own = command.replace("/proc/[0-9]*/", f"/proc/{running.pid}/")
            said = subprocess.run(["bash", "-c", own], capture_output=True, text=True, check=True)
        finally:
            running.kill()
    assert said.stdout == expected


def test_a_folder_is_written_whole_or_not_at_all(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = written(tmp_path, "--paste", "discovery server")
    options = ("plan", str(tmp_path / "fleet.toml"), *CYCLONE, "--write", str(folder))
    refused = run(*options)
    assert refused.exit_code == 2
    assert f"--write: {folder / 'README.md'} exists; choose another folder" in refused.stderr
    assert not (folder / "robot1" / "etc" / "cyclonedds.xml").exists()
    (folder / "mine.txt").write_text("mine")
    before = {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()}

    def full(self: Path, *_: Any, **__: Any) -> None:
        raise OSError(28, os.strerror(28), str(self))

    with monkeypatch.context() as patch:
        patch.setattr(Path, "write_text", full)
        assert run(*options, "--force").exit_code == 2
    assert {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()} == before
    renames, original = [], Path.rename

    def rename(self: Path, target: Path) -> None:
        renames.append(target)
        if len(renames) == 2:
            raise OSError(28, os.strerror(28), str(self))
        original(self, target)

    with monkeypatch.context() as patch:
        patch.setattr(Path, "rename", rename)
        assert run(*options, "--force").exit_code == 2
    assert {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()} == before
    assert run(*options, "--force").exit_code == 0
    assert (folder / "robot1" / "etc" / "cyclonedds.xml").exists()
    assert (folder / "mine.txt").read_text() == "mine"
    assert {path.name for path in tmp_path.iterdir()} == {"fleet.toml", "out"}


def test_a_folder_that_cannot_be_is_refused_in_a_sentence(tmp_path: Path) -> None:
    file = tmp_path / "fleet.toml"
    file.write_text(FLEET)
    paste = ("plan", str(file), "--paste", "discovery server")
    said = run(*paste, "--write", str(file))
    assert said.exit_code == 2
    assert said.stderr.endswith("must be a folder, or not exist; it is a file\n")
    said = run(*paste, "--write", str(tmp_path / "no" / "out"))
    assert "no must be a folder, to hold out; make it first" in said.stderr
    assert "--force needs --write" in run(*paste, "--force").stderr
    both = run(*paste, "--write", str(tmp_path / "out"), "--protocol", "all")
    assert "--write needs one --protocol" in both.stderr
    file.write_text(FLEET.replace("robot2 =", "robots2 ="))
    said = run(*paste, "--write", str(tmp_path / "out"))
    assert "addresses must name hosts; got 'robots2'. Did you mean 'robot2'?" in said.stderr
    said = run("plan", str(file), "--paste", "processes", "--write", str(tmp_path / "out"))
    assert said.exit_code == 2
    assert [path.name for path in tmp_path.iterdir()] == ["fleet.toml"]


def test_the_first_change_that_suffices_is_written(tmp_path: Path) -> None:
    out = tmp_path / "out"
    fleet = ("plan", "--hosts", "12", "--processes", "2", "--endpoints", "10", "--write", str(out))
    works = run(*fleet)
    assert (works.exit_code, out.exists()) == (0, False)
    assert "Your startup already works, so nothing needs changing" in works.stdout
    done = run(*fleet, "--within", "5")
    given = ds.Fleet((ds.HostGroup(12, 2, 10, shared=2),))
    plan = ds.plan(given, ds.PROTOCOLS["Fast DDS 3.6"], within=5)
    first = next(c for c in plan.discovery.sufficient if c.remedy.snippets)
    assert done.exit_code == 0, done.output
    assert first.remedy.what.lower() in (out / "README.md").read_text().splitlines()[0].lower()


def test_a_pasted_launch_file_has_a_line_for_each_node_of_each_group(tmp_path: Path) -> None:
    file = tmp_path / "fleet.toml"
    file.write_text(FLEET)
    said = run("plan", str(file), "--paste", "processes")
    files = said.stdout.split('# Group "robots": 3 hosts, each with 22 processes')[1].split(
        '# Group "laptop": 1 host'
    )
    (robots, laptop) = (
        [line for line in text.splitlines() if "ComposableNode(package" in line] for text in files
    )
    assert (len(robots), len(laptop)) == (25, 2)  # nodes if they are known, else processes
    assert 'package="PACKAGE25", plugin="PLUGIN25", name="NAME25"' in robots[-1]
    assert said.stdout.count("# Fill in PACKAGE, PLUGIN and NAME of each node") == 2
    for text in files:
        compile("#" + text, "robot.launch.py", "exec")


def test_pasted_addresses_are_those_of_the_fleet_file(tmp_path: Path) -> None:
    file = tmp_path / "fleet.toml"
    file.write_text(FLEET)
    said = run("plan", str(file), "--paste", "discovery server")
    assert "192.168.1.9:11811" in said.stdout
    assert "192.168.1.10" not in said.stdout
    assert "ADDRESS_OF" not in said.stdout + said.stderr
    said = run("plan", str(file), *CYCLONE)
    for address in ("192.168.1.31", "192.168.1.32", "ADDRESS_OF_robot3", "ADDRESS_OF_laptop1"):
        assert f'<Peer Address="{address}"/>' in said.stdout
    assert "Fill in each ADDRESS_OF_..." in said.stderr


def test_hosts_are_named_by_their_groups() -> None:
    groups = (ds.HostGroup(2, 1, 1, "Big carts"), ds.HostGroup(1, 1, 1), ds.HostGroup(1, 1, 1, "ä"))
    names = ["big_cart1", "big_cart2", "robot1", "robot2"]
    assert [*groups_by_host_name(ds.Fleet(groups))] == names
    with pytest.raises(ValueError, match="hosts must be at most 1,000; got 1,001"):
        groups_by_host_name(ds.Fleet.swarm(1001, 1, 1))


def test_links_in_a_folder_are_not_written_through(tmp_path: Path) -> None:
    kept, folder = tmp_path / "kept", tmp_path / "out"
    kept.write_text("kept")
    folder.mkdir()
    (folder / "a").symlink_to(kept)
    with pytest.raises(ValueError, match="exists"):
        files.write_folder(folder, {"a": "new"})
    files.write_folder(folder, {"a": "new"}, replace=True)
    assert (kept.read_text(), (folder / "a").read_text()) == ("kept", "new")


def test_each_change_says_what_to_do_how_to_check_and_how_to_go_back() -> None:
    fleet = ds.Fleet((ds.HostGroup(6, 3, 20, "robots", nodes=1), ds.HostGroup(1, 2, 30, "laptop")))
    seen = set()
    for name in ("Fast DDS", "Cyclone DDS", "Zenoh peer, tokens"):
        plan = ds.plan(fleet, ds.PROTOCOLS[name])
        for remedy in (*plan.remedies, *plan.combinations):
            if not remedy.snippets or remedy.steps in seen:
                continue
            seen.add(remedy.steps)
            of = texts_by_path(fleet, remedy, plan.within)
            readme = of["README.md"]
            for word in ("\nCheck:", "print", "\nGo back:"):
                assert word in readme, (remedy.what, word)
            assert ("## Copy" in readme) == any("/etc/" in path for path in of)
            for path in of:
                if path.startswith("by_hand/"):
                    assert path.removeprefix("by_hand/") in readme
            for block in re.findall(r"```\n(.*?)```", readme, re.S):
                if re.match("scp|ssh|sudo|ss |for|systemctl|iw|pgrep|ros2", block):
                    subprocess.run(["bash", "-n"], input=block, text=True, check=True)
    kinds = {step for steps in seen for step in steps}
    assert {"processes", "endpoints", "domains", "channels", "radio", "static endpoints"} <= kinds


def test_each_part_has_a_domain_of_its_own_and_its_hosts_are_named() -> None:
    fleet = ds.Fleet((ds.HostGroup(4, 2, 10, "robots"), ds.HostGroup(2, 1, 10, "laptops")))
    for domain, first in ((None, 1), (5, 5), (232, 230)):
        of = texts("domains", "Fast DDS", replace(fleet, domain=domain))
        assert set(of) == {"README.md", "by_hand/ros_domain.sh"}
        lines = of["by_hand/ros_domain.sh"].split("documentation\n")[1].splitlines()
        assert lines == [
            *("# Part 1: robot1 and robot4", f"export ROS_DOMAIN_ID={first}"),
            *("# Part 2: robot2 and laptop1", f"export ROS_DOMAIN_ID={first + 1}"),
            *("# Part 3: robot3 and laptop2", f"export ROS_DOMAIN_ID={first + 2}"),
        ]
    said = run(
        "plan", "--hosts", "2000", "--processes", "2", "--endpoints", "9", "--paste", "domains"
    )
    assert "# Part 1: 667 hosts\nexport ROS_DOMAIN_ID=1\n" in said.stdout


def test_each_pasted_piece_says_for_which_version_it_is() -> None:
    for piece in {row["file"] for row in read_data("vendors/snippets.csv")}:
        rows = [row for row in read_data("vendors/snippets.csv") if row["file"] == piece]
        for found in (p for row in rows for p in snippets(row["kind"], row["for"])):
            if found.file == piece:
                assert re.search(r"\d", found.version)
                first = found.text.splitlines()[0]
                known = f"({'tested with ' * found.run_here}{found.version})"
                assert re.match(rf"(# |// |<!-- ){re.escape(f'{found.where} {known}')}", first)
