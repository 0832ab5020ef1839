"""Test all packages' commands: machine-readable output, and messages for wrong input."""

import lzma
import math
import re
import shlex
from dataclasses import replace
from pathlib import Path

import click
import pytest
from click.testing import CliRunner
from command_line import NAV2, SWARM_OPTIONS, read_csv, read_json, run
from support import REFERENCE, ROOT

import discostorm as ds
from discostorm import drain_times, wording
from discostorm.cli import main
from discostorm.cli.options import LINK_OPTIONS
from discostorm.data import data_path
from discostorm.protocols import protocols_in_order
from discostorm.wording import TCPDUMP
from discostorm_book import show
from discostorm_book.ledger.claims import VERDICTS, ledger

#: Two robots in place of ten, as plans of large fleets take long.
FEW = NAV2.replace("hosts = 10", "hosts = 2")
#: The names of all protocols, in the calculator's order.
OFFERED = [protocol.name for protocol in protocols_in_order()]


@pytest.fixture(autouse=True)
def folder(folder: Path) -> Path:
    """Add a capture, and the output of ROS 2 commands."""
    packed = data_path("captures/cyclone_dds_010.pcap.xz", "discostorm_capture")
    told = REFERENCE / "ros2" / "one_robot.txt"
    (folder / "ros2.txt").write_text(told.read_text(encoding="utf-8"), encoding="utf-8")
    (folder / "discovery.pcap").write_bytes(lzma.decompress(packed.read_bytes()))
    return folder


def test_all_commands_count_what_ros_2_shares_in_a_fleet_file() -> None:
    server = "--protocol|Fast DDS Discovery Server"
    planned = read_json(run("plan|fleet.toml|--json", server))["utilization"]
    (row,) = read_json(run("utilization|fleet.toml|--json", server))
    assert row["utilization"] == pytest.approx(planned, rel=1e-12)
    messages = read_json(run("breakdown|fleet.toml|--json", server))
    told = math.fsum(message["uplink_s"] + message["downlink_s"] for message in messages)
    assert told == pytest.approx(planned, rel=1e-12)
    robots, _ = read_json(run("saturation|fleet.toml|--json", server))
    assert (robots["fit"] >= 10) == (planned < 1)
    # What a file says of its nodes gives way to an option.
    fewer = read_json(run("plan|fleet.toml|--json|--nodes|1,1", server))["utilization"]
    assert fewer < planned


def test_simulate_tells_the_drain_time_where_recovery_is_not_modeled() -> None:
    table = ds.PROTOCOLS["Fast DDS Discovery Server, on a robot"]
    command = f"simulate|fleet.toml|--protocol|{table.name}|--runs|2"
    told = run(command)
    assert told.exit_code == 0
    drain = wording.duration(float(drain_times.drain_time(table, ds.Fleet.from_toml("fleet.toml"))))
    assert told.stdout.startswith(f"Drain time: startup keeps the channel busy for {drain} if")
    assert f"Note: We do not simulate recovery with {table.name}" in told.stderr
    assert told.stdout.count("not simulated") == 2
    assert read_json(run(command, "--json"))["settings"]["recovery"] is False
    assert {row["convergence_time_s"] for row in read_csv(run(command, "--csv"))} == {""}


def test_simulate_says_first_when_all_know_each_other() -> None:
    told = run("simulate|fleet.toml|--runs|2|--json")
    times = read_json(told)["convergence_time"]
    said = wording.time_range(min(times), max(times))
    first = run("simulate|fleet.toml|--runs|2").stdout.splitlines()[0]
    assert first == f"Your robots have discovered each other after {said} (2 runs)."
    never = run("simulate|fleet.toml|--runs|2|--until|0.001").stdout.splitlines()[0]
    assert never == "Not all robots discover each other within 0.001 s (2 runs)."


def test_simulate_takes_every_ready_made_robot() -> None:
    """Some have a mean that is no whole number of endpoints."""
    told = run("simulate|--robot|px4|--hosts|2|--runs|1|--until|1")
    assert told.exit_code == 0
    assert told.stderr == ""
    told = run("simulate|--hosts|2|--processes|2|--endpoints|9.25|--runs|1|--until|1")
    assert "has 9.25 endpoints on average; we simulate 9." in told.stderr


def test_ros_all_needs_a_command_that_compares_protocols() -> None:
    told = run("capture|any.pcap|--ros|all|--against|fastdds")
    assert told.exit_code == 2
    assert "--ros all needs a command that compares protocols" in told.stderr


def test_plan(folder: Path) -> None:
    (folder / "fleet.toml").write_text(FEW, encoding="utf-8")
    fleet = ds.Fleet.from_toml(folder / "fleet.toml")
    robots, laptop = fleet.groups
    told = replace(robots, nodes=13, shared=28), replace(laptop, nodes=2, shared=6)
    expected = ds.plan(replace(fleet, groups=told), ds.ZENOH)
    arguments = ("plan", "fleet.toml", "--protocol|zenoh", "--nodes|13,2")
    hints = "`--why` explains the answer. `--all` lists all changes that we tried."
    assert run(*arguments).output == f"{expected.advice()}\n{hints}\n"
    assert read_json(run(*arguments, "--json")) == expected.to_dict()
    rows = read_csv(run(*arguments, "--csv"))
    assert [row["remedy"] for row in rows] == list(expected.to_frame().index)
    assert [float(row["saved"]) for row in rows] == expected.to_frame()["saved"].tolist()
    usual = ds.plan(fleet, "Fast DDS")
    assert run("plan", "fleet.toml").output == f"{usual.advice()}\n{hints}\n"
    told = read_json(run("plan|fleet.toml|--json|--nodes|7"))["fleet"]
    assert [group["shared"] for group in told] == [16, 16]
    told = read_json(run("plan|fleet.toml|--json|--shared|90"))["fleet"]
    assert [group["shared"] for group in told] == [90, 90]
    refused = run("plan|fleet.toml|--shared|91")  # as where the file says it
    assert refused.exit_code == 2
    assert "group 'laptop': shared must be" in refused.output
    assert "at most 90; got 91" in refused.output


def test_claims() -> None:
    expected = ledger()
    result = run("claims", "--csv")
    assert result.stderr == ""
    rows = read_csv(result)
    assert [int(row["id"]) for row in rows] == list(expected.index)
    assert [row["verdict"] for row in rows] == list(expected["verdict"])
    ours = {row["statement"]: row["ours"] for row in rows}
    seven = ours["DDS saturates at approximately 7 hosts."]
    assert float(seven) == ds.saturation_hosts(ds.DDS, 2, 10)
    assert ours["SPDP load of all hosts, up and down."] == "N_H*N_P"
    assert ours["Hosts on one channel contend for airtime."] == ""
    holds, fails = (VERDICTS[outcome]["verdict"] for outcome in ("holds", "fails"))
    some = read_json(run("claims", f"--verdict|{fails}", "--json"))
    assert {row["id"]: row["ours"] for row in some}[1] == 1.0
    assert [row["id"] for row in some] == list(expected.index[expected["verdict"] == fails])
    human = run("claims", f"--verdict|{fails}").output
    counts = expected["verdict"].value_counts()
    assert f"{len(expected)} claims: {counts[holds]} {holds}" in human
    assert max(map(len, human.splitlines())) <= 79


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (
            "plan",
            "give --hosts, --processes and --endpoints, --fleet FILE, or --robot NAME",
        ),
        ("plan|", "path must name a TOML file; got ''"),
        ("plan|fleet.toml|--nodes|many", "'--nodes': must be one or more comma-separated numbers"),
        ("plan|fleet.toml|--nodes|8", "fleet.toml: group 'laptop': nodes must be at most 7.5"),
        ("plan|fleet.toml|--nodes|1,2,3", "fleet.toml: nodes must be one number, or one per group"),
        ("plan|fleet.toml|--protocol|mqtt", "'mqtt' is not a known name. 'list' lists all"),
        ("claims|--verdict|wrong", "'wrong' is not one of"),
    ],
)
def test_wrong_input_ends_with_2_and_says_what_is_allowed(arguments: str, message: str) -> None:
    result = run(arguments)
    assert result.exit_code == 2, result.output
    assert message in result.stderr
    assert result.stdout == ""
    assert "Traceback" not in result.output


def every_command() -> dict[str, click.Command]:
    assert isinstance(main, click.Group)
    context = click.Context(main)
    found = {name: main.get_command(context, name) for name in main.list_commands(context)}
    return {name: command for name, command in found.items() if command is not None}


def test_there_are_eleven_commands() -> None:
    assert sorted(every_command()) == [
        "breakdown", "capture", "claims", "figures", "fleet", "plan", "robots", "saturation",
        "simulate", "utilization", "watch",
    ]  # fmt: skip


@pytest.mark.parametrize("name", ["", *sorted({*every_command()} - {"watch"})])
def test_help_has_examples_that_run(name: str, folder: Path) -> None:
    result = run(*filter(None, [name]), "--help")
    assert result.exit_code == 0
    assert "Example" in result.output
    text = result.output.replace("\\\n", "").replace("> claims.csv", "")
    text = text.replace("--processes 3 > fleet.toml", "--processes 2")
    for many in ("turtlebot4 --hosts 12", "--hosts 12 --processes 2"):  # these take long
        text = text.replace(many, many.replace("12", "2"))
    Path("fleet.toml").write_text(FEW, encoding="utf-8")
    examples = [line for line in text.splitlines() if line.startswith("    discostorm ")]
    assert examples
    runner = CliRunner()
    for example in examples:
        done = runner.invoke(main, shlex.split(example)[1:])
        assert done.exit_code == 0, f"{example}: {done.output}"
    assert folder.is_dir()


def test_whoever_is_told_how_to_record_loses_nothing() -> None:
    # Whatever is written: no filter, or the one that keeps fragments, Zenoh's TCP and IPv6.
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    texts = {"README": readme, "help": every_command()["capture"].help or ""}
    whole = TCPDUMP.partition("{file}")[2]
    for name, text in texts.items():
        found = re.findall(r"tcpdump -i \S+ -s 0 -w \S+( '[^']*'| *)", text)
        assert len(found) == text.count("tcpdump -i") > 0, name
        assert set(map(str.rstrip, found)) <= {"", whole}, name
    assert texts["help"].count(whole) == 2


@pytest.mark.parametrize(
    ("listing", "names"),
    [
        ("saturation|--wifi|list", ["paper", *ds.WIFI]),
        ("saturation|--protocol|list", [*OFFERED, "all", "paper"]),
        ("simulate|--protocol|list", [*OFFERED, "all", "paper"]),
        ("capture|--against|list", OFFERED),
    ],
)
def test_names_are_listed_whatever_else_is_missing(listing: str, names: list[str]) -> None:
    assert [line.partition(" (")[0] for line in run(listing).output.splitlines()] == names


def test_help_describes_every_option() -> None:
    for command in every_command().values():
        for parameter in command.params:
            if isinstance(parameter, click.Option):
                assert parameter.help, f"{command.name} {parameter.name}"
        names = {parameter.name for parameter in command.params}
        # A table that is shown anew each second has metrics instead.
        told = {"port", "text_file"} if command.name == "watch" else {"as_json", "as_csv"}
        assert told <= names
        # What is simulated needs a radio, which a rate and an overhead of one's own have not.
        every = {"multicast_rate"} if command.name == "simulate" else set(LINK_OPTIONS)
        assert names & set(LINK_OPTIONS) in (set(), every)


def test_the_books_shell_shows_command_output_and_exit_code() -> None:
    command = f"discostorm utilization {' '.join(SWARM_OPTIONS)} --protocol dds"
    shown = show.shell(command, "discostorm plan x.toml").data
    assert shown.startswith(f"```text\n$ {command}\nprotocol  hosts")
    assert shown.endswith("Error: x.toml: No such file or directory\n[exit code 2]\n```")
    long = show.shell("discostorm utilization --hosts 0 --processes 1 --endpoints 1").data
    assert "got 0.0" in " ".join(long.split())
    assert max(map(len, long.splitlines())) <= 79
    assert "more lines" in show.shell("discostorm --help", lines=1).data
    with pytest.raises(ValueError, match="commands must start with discostorm; got 'ls'"):
        show.shell("ls")


def test_simulate_says_what_plan_says() -> None:
    """Radios aggregate in both, and the runs have the same seeds."""
    options = ("--hosts", "6", "--processes", "2", "--endpoints", "20")
    options += ("--wifi", "802.11ac 80 MHz", "--json")
    planned = read_json(run("plan", *options))["discovery"]["today"]
    found = read_json(run("simulate", *options, "--runs", "2", "--until", "60"))
    assert sorted(found["convergence_time"]) == pytest.approx(sorted(planned["times_s"]))
