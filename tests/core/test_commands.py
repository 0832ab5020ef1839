"""The command line: what it prints can be read back, and what is wrong is answered in words."""

import csv
import io
import json
import lzma
import math
import os
import re
import shlex
import subprocess
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import click
import pytest
from click.testing import CliRunner, Result
from support import REFERENCE, ROOT

import discostorm as ds
from discostorm import figures, timeline, words
from discostorm.cli import main, output
from discostorm.cli.options import LINK_OPTIONS
from discostorm.data import data_path
from discostorm.protocols import offered
from discostorm.words import RECORD
from discostorm_book import notebook
from discostorm_book.ledger.claims import VERDICTS, ledger

NAV2 = data_path("fleets/nav2_laptop.toml").read_text(encoding="utf-8")

SWARM = "--hosts 7 --processes 2 --endpoints 10"

#: The names of all protocols, in the calculator's order.
OFFERED = [protocol.name for protocol in offered()]


def run(*arguments: str) -> Result:
    words = [word for argument in arguments for word in argument.split("|")]
    return CliRunner(env={"COLUMNS": "79"}).invoke(main, words, prog_name="discostorm")


def swarm(command: str, *more: str) -> Result:
    return run(command, SWARM.replace(" ", "|"), *more)


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "fleet.toml").write_text(NAV2, encoding="utf-8")
    packed = data_path("captures/cyclone_dds_010.pcap.xz", "discostorm_capture")
    told = REFERENCE / "ros2" / "one_robot.txt"
    (tmp_path / "ros2.txt").write_text(told.read_text(encoding="utf-8"), encoding="utf-8")
    (tmp_path / "discovery.pcap").write_bytes(lzma.decompress(packed.read_bytes()))
    return tmp_path


def read_json(result: Result) -> Any:
    assert result.exit_code == 0, result.output
    return json.loads(result.stdout)


def read_csv(result: Result) -> list[dict[str, str]]:
    assert result.exit_code == 0, result.output
    return list(csv.DictReader(io.StringIO(result.stdout)))


def test_utilization_for_people() -> None:
    result = swarm("utilization", "--protocol|paper")
    assert result.exit_code == 0
    heading, rule, dds, zenoh, _, channel = result.output.splitlines()
    assert channel == "Channel: paper (802.11n), one access point, infrastructure."
    assert heading.split() == [
        "protocol", "hosts", "processes", "endpoints", "utilization", "fits",
    ]  # fmt: skip
    assert set(rule) == {"-"}
    assert dds.split() == ["DDS", "7", "2", "10", "95.4%", "yes"]
    assert zenoh.split() == ["Zenoh", "7", "2", "10", "83.1%", "yes"]


def test_utilization_for_machines() -> None:
    arguments = ("utilization", "--hosts|3,9", "--processes|2", "--endpoints|10")
    arguments += ("--protocol|paper",)
    rows = read_json(run(*arguments, "--json"))
    assert [(row["protocol"], row["hosts"]) for row in rows] == [
        ("DDS", 3), ("DDS", 9), ("Zenoh", 3), ("Zenoh", 9),
    ]  # fmt: skip
    protocols = {"DDS": ds.DDS, "Zenoh": ds.ZENOH}
    for row in rows:
        expected = ds.utilization(protocols[row["protocol"]], row["hosts"], 2, 10)
        assert row["utilization"] == expected
        assert row["fits"] is (expected < 1)
    table = read_csv(run(*arguments, "--csv"))
    assert [float(row["utilization"]) for row in table] == [row["utilization"] for row in rows]


def test_utilization_of_a_fleet_file(folder: Path) -> None:
    fleet = ds.Fleet.from_toml(folder / "fleet.toml")
    (row,) = read_json(run("utilization", "--fleet|fleet.toml", "--protocol|zenoh", "--json"))
    assert row["fleet"] == "fleet.toml"
    assert row["utilization"] == ds.utilization(ds.ZENOH, fleet)


def test_a_table_has_aligned_columns_and_breaks_long_words_at_the_end(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv("COLUMNS", "200")
    monkeypatch.setattr(output, "_width", lambda: 79)
    words = "claims " * 12
    table = [
        {"short": "a", "count": 1234.0, "long_text": "x"},
        {"short": "bcd", "count": 5.0, "long_text": words},
    ]
    assert output.aligned(table, {}, {"short": "id"}).splitlines() == [
        "id   count  long text",
        "-" * 74,
        "a    1,234  x",
        "bcd      5  claims claims claims claims claims claims claims claims claims",
        "            claims claims claims",
    ]
    fitting = [{"text": "x" * 39 + " " + "y" * 39}]
    assert len(output.aligned(fitting, {}, {}).splitlines()) == 3
    wide = [{"wide": "w" * 70, "text": "0123456789 123456789"}]
    assert len(output.aligned(wide, {}, {}).splitlines()) == 3
    wider = [{"wide": "w" * 70, "text": "0123456789 1234567890"}]
    assert len(output.aligned(wider, {}, {}).splitlines()) == 4


def test_json_is_indented_and_csv_ends_with_its_last_line(folder: Path) -> None:
    (folder / "läufer.toml").write_text(NAV2, encoding="utf-8")
    arguments = ("utilization", "--fleet|läufer.toml", "--protocol|dds")
    assert run(*arguments, "--json").output.splitlines()[1:4] == [
        "  {",
        '    "protocol": "DDS",',
        '    "fleet": "läufer.toml",',
    ]
    heading, *rows = run(*arguments, "--csv").output.split("\n")
    assert heading == "protocol,fleet,utilization,fits"
    assert [row[:4] for row in rows] == ["DDS,", ""]


def test_breakdown() -> None:
    (first, *_), table = (
        read_json(swarm("breakdown", "--protocol|dds", "--json")),
        read_csv(swarm("breakdown", "--protocol|both", "--csv")),
    )
    expected = ds.breakdown(ds.DDS, 7, 2, 10)
    assert first["message"] == "SPDP"
    assert first["uplink_s"] == expected.loc["SPDP", "uplink_s"]
    assert [row["message"] for row in table[:4]] == list(expected.index)
    assert [float(row["downlink_s"]) for row in table[:4]] == expected["downlink_s"].tolist()
    for protocol in ("DDS", "Zenoh"):
        rows = [row for row in table if row["protocol"] == protocol]
        whole = sum(float(row["uplink_s"]) + float(row["downlink_s"]) for row in rows)
        for row in rows:
            part = float(row["uplink_s"]) + float(row["downlink_s"])
            assert math.isclose(float(row["share"]), part / whole, rel_tol=1e-12)
    assert (
        list(table[0])
        == list(first)
        == ["protocol", "message", *expected.columns, "payload_bytes", "share"]
    )
    human = swarm("breakdown", "--protocol|paper").output
    assert "phase" not in human
    assert "frame [B]" in human
    assert "1,680" in human
    assert max(map(len, human.splitlines())) <= 79
    assert run("breakdown", "--fleet|fleet.toml", "--csv").exit_code == 0


def test_saturation() -> None:
    arguments = ("saturation", "--processes|2", "--endpoints|10", "--protocol|paper")
    dds, zenoh = read_json(run(*arguments, "--json"))
    assert dds["hosts"] == ds.saturation_hosts(ds.DDS, 2, 10)
    assert (dds["fit"], zenoh["fit"]) == (7, 7)
    assert "7.16" in run(*arguments).output
    (half,) = read_csv(run(*arguments[:3], "--limit|0.5", "--protocol|dds", "--csv"))
    assert float(half["hosts"]) == ds.saturation_hosts(ds.DDS, 2, 10, limit=0.5)
    beside, _ = read_json(run(*arguments, "--beside|fleet.toml", "--limit|40", "--json"))
    others = ds.Fleet.from_toml("fleet.toml").groups
    both = ds.Fleet((ds.HostGroup(1, 2, 10), *others))
    assert beside["hosts"] == ds.saturation_hosts(ds.DDS, limit=40, fleet=both)


def test_saturation_of_each_group_of_a_fleet() -> None:
    fleet = ds.Fleet.from_toml("fleet.toml")
    found = read_json(run("saturation|fleet.toml|--limit|999|--protocol|dds|--json"))
    assert [row["group"] for row in found] == ["robots", "laptop"]
    for row, group in zip(found, fleet.groups, strict=True):
        assert (row["processes"], row["endpoints"]) == (group.processes, group.endpoints)
        assert row["hosts"] == ds.saturation_hosts(ds.DDS, limit=999, fleet=fleet, group=group.name)
    beside = run("saturation|fleet.toml|--limit|999|--protocol|dds|--json|--beside|fleet.toml")
    for row, more in zip(found, read_json(beside), strict=True):
        assert more["hosts"] < row["hosts"]
    human = run("saturation|fleet.toml|--protocol|paper").output
    assert max(map(len, human.splitlines())) <= 79


ROBOTS = "[[groups]]\nhosts = 11\nprocesses = 1\nendpoints = 678\n"
LAPTOP = "[[groups]]\nname = 'laptop'\nhosts = 2\nprocesses = 3\nendpoints = 90\n"


@pytest.mark.parametrize("protocol", ["Fast DDS", "Fast DDS Discovery Server"])
@pytest.mark.parametrize(
    "content",
    [
        ROBOTS + "shared = 28",
        "matching = 1\n" + ROBOTS,
        "matching = 0.1\n" + ROBOTS + "shared = 28\n" + LAPTOP,
        ROBOTS + "nodes = 13\n" + LAPTOP,
    ],
)
def test_as_many_hosts_fit_as_utilization_says(content: str, protocol: str, folder: Path) -> None:
    def utilization(fleet: ds.Fleet, index: int, hosts: int) -> float:
        groups = list(fleet.groups)
        groups[index] = replace(groups[index], hosts=hosts)
        return float(ds.utilization(ds.PROTOCOLS[protocol], replace(fleet, groups=tuple(groups))))

    (folder / "own.toml").write_text(content)
    fleet = ds.Fleet.from_toml("own.toml")
    # Of a limit above what a single host of each group takes.
    limit = 3 * max(utilization(fleet, index, 1) for index in range(len(fleet.groups)))
    limit = max(limit, 0.2)
    arguments = ("saturation|own.toml|--json", f"--limit|{limit}", f"--protocol|{protocol}")
    for index, row in enumerate(read_json(run(*arguments))):
        assert row["fit"] >= 1
        assert utilization(fleet, index, row["fit"]) < limit
        assert utilization(fleet, index, row["fit"] + 1) >= limit


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


def test_matching_is_one_number_for_all_on_the_channel(folder: Path) -> None:
    (folder / "own.toml").write_text("matching = 1\n" + ROBOTS)
    refused = run("saturation|own.toml|--beside|fleet.toml")
    assert refused.exit_code == 2
    assert "matching must be the same in FLEET and --beside; got 1 and 0" in refused.stderr


def test_simulate_tells_the_drain_time_where_recovery_is_not_modeled() -> None:
    table = ds.PROTOCOLS["Fast DDS Discovery Server"]
    command = f"simulate|fleet.toml|--protocol|{table.name}|--runs|2"
    told = run(command)
    assert told.exit_code == 0
    drain = words.duration(float(timeline.drain_time(table, ds.Fleet.from_toml("fleet.toml"))))
    assert told.stdout.startswith(f"Drain time: startup keeps the channel busy for {drain} if")
    assert "Note: recovery is not simulated with Fast DDS Discovery Server" in told.stderr
    assert told.stdout.count("not simulated") == 2
    assert read_json(run(command, "--json"))["settings"]["recovery"] is False
    assert {row["convergence_time_s"] for row in read_csv(run(command, "--csv"))} == {""}


def test_simulate_says_first_when_all_know_each_other() -> None:
    told = run("simulate|fleet.toml|--runs|2|--json")
    times = read_json(told)["convergence_time"]
    said = words.durations(min(times), max(times))
    first = run("simulate|fleet.toml|--runs|2").stdout.splitlines()[0]
    assert first == f"Your robots know each other after {said} (2 runs)."
    never = run("simulate|fleet.toml|--runs|2|--until|0.001").stdout.splitlines()[0]
    assert never == "Your robots do not all know each other within 0.001 s (2 runs)."


def test_simulate_takes_every_ready_made_robot() -> None:
    """Some have a mean that is no whole number of endpoints."""
    told = run("simulate|--robot|px4|--hosts|2|--runs|1|--until|1")
    assert told.exit_code == 0
    assert "Note: 45.5 endpoints of each process" in told.stderr


def test_saturation_of_less_than_one_host() -> None:
    arguments = ("saturation", "--processes|1200", "--endpoints|0")
    paper = (*arguments, "--protocol|paper")
    dds, zenoh = read_json(run(*paper, "--json"))
    assert (dds["hosts"], dds["fit"]) == (None, 0)
    assert (zenoh["hosts"], zenoh["fit"]) == (ds.saturation_hosts(ds.ZENOH, 1200, 0), 1)
    assert [row["hosts"] == "" for row in read_csv(run(*paper, "--csv"))] == [True, False]
    assert re.search(r"DDS .* less than 1 +0$", run(*paper).output, re.MULTILINE)
    crowded = run(*arguments, "--beside|fleet.toml", "--protocol|zenoh", "--json")
    assert [row["fit"] for row in read_json(crowded)] == [0]


def test_what_is_below_the_whole_is_not_printed_as_the_whole() -> None:
    below = run("utilization|--hosts|7.1543|--processes|2|--endpoints|10|--protocol|dds")
    assert re.search(r" <100\.0%  yes$", below.output, re.MULTILINE)
    above = run("utilization|--hosts|7.1554|--processes|2|--endpoints|10|--protocol|dds")
    assert re.search(r" 100\.0%  no$", above.output, re.MULTILINE)


def test_counts_are_printed_with_all_their_digits() -> None:
    table = run("utilization|--hosts|1234567|--processes|1|--endpoints|0|--protocol|dds").output
    assert " 1,234,567 " in table


def test_plan(folder: Path) -> None:
    fleet = ds.Fleet.from_toml(folder / "fleet.toml")
    robots, laptop = fleet.groups
    told = replace(robots, nodes=13, shared=28), replace(laptop, nodes=2, shared=6)
    expected = ds.plan(replace(fleet, groups=told), ds.ZENOH)
    arguments = ("plan", "fleet.toml", "--protocol|zenoh", "--nodes|13,2")
    assert run(*arguments).output == expected.advice() + "\n"
    assert read_json(run(*arguments, "--json")) == expected.to_dict()
    rows = read_csv(run(*arguments, "--csv"))
    assert [row["remedy"] for row in rows] == list(expected.to_frame().index)
    assert [float(row["saved"]) for row in rows] == expected.to_frame()["saved"].tolist()
    usual = ds.plan(fleet, ds.PROTOCOLS["Fast DDS"])
    assert run("plan", "fleet.toml").output == usual.advice() + "\n"
    told = read_json(run("plan|fleet.toml|--json|--nodes|7"))["fleet"]
    assert [group["shared"] for group in told] == [16, 16]
    told = read_json(run("plan|fleet.toml|--json|--shared|90"))["fleet"]
    assert [group["shared"] for group in told] == [90, 90]
    refused = run("plan|fleet.toml|--shared|91")  # as where the file says it
    assert refused.exit_code == 2
    assert "group 'laptop': shared must be" in refused.output
    assert "at most 90; got 91" in refused.output


def test_figures_shows_progress_and_lists_what_it_wrote(folder: Path) -> None:
    result = run("figures", "--out|deep/out", "--json")
    paths = json.loads(result.stdout)
    assert len(paths) == 12
    assert {(folder / row["path"]).is_file() for row in paths} == {True}
    assert result.stderr.splitlines()[0].startswith("[ 1/12] deep/out")


def test_figures_refuses_a_file_as_the_folder(folder: Path) -> None:
    (folder / "file").write_text("")
    wrong = run("figures", "--out|file")
    assert wrong.exit_code == 2
    assert "--out must be a folder to write to; got 'file'" in wrong.output


def test_figures_counts_what_it_wrote(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(figures, "save_all", lambda folder: iter([folder / "a", folder / "b"]))
    monkeypatch.setattr(figures, "files_of_all", lambda: 2)
    lines = "[1/2] out/a\n[2/2] out/b\n"
    people = run("figures", "--out|out")
    assert (people.stdout, people.stderr) == (lines, "")
    machines = run("figures", "--out|out", "--csv")
    assert (machines.stdout, machines.stderr) == ("path\nout/a\nout/b\n", lines)


def test_what_takes_its_time_is_said_on_a_terminal_and_wiped_out(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True)
    with output.working("planning"):
        assert capsys.readouterr() == ("", "planning ...")
    assert capsys.readouterr() == ("", "\r            \r")


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


@pytest.mark.parametrize("name", ["paper", *ds.WIFI])
def test_every_preset_can_be_chosen(name: str) -> None:
    rows = read_json(swarm("utilization", f"--wifi|{name}", "--protocol|dds", "--json"))
    wifi = ds.PAPER if name == "paper" else ds.WIFI[name]
    assert rows[0]["utilization"] == ds.utilization(ds.DDS, 7, 2, 10, wifi=wifi)


def test_rates_and_overheads_replace_the_papers() -> None:
    result = swarm(
        "utilization",
        "--unicast-rate|300|--unicast-overhead|150|--multicast-rate|12|--multicast-overhead|100",
        "--protocol|dds",
        "--json",
    )
    # Divided and multiplied in another order.
    own = ds.Wifi("own", ds.Link(300e6, 150e-6), ds.Link(12e6, 100e-6))
    expected = ds.utilization(ds.DDS, 7, 2, 10, wifi=own)
    assert read_json(result)[0]["utilization"] == pytest.approx(expected, rel=1e-14)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ("utilization|--hosts|7", "--processes, --endpoints must be given, or --fleet FILE"),
        ("utilization|--hosts|a|--processes|1|--endpoints|1", "'--hosts': must be a number"),
        (
            "utilization|--hosts|0|--processes|1|--endpoints|1",
            "hosts must be a finite number of at least 1 and at most 1e+09; got 0.0",
        ),
        ("utilization|--hosts|1|--processes|x|--endpoints|1", "'x' is not a valid float"),
        ("utilization|--hosts|nan|--processes|1|--endpoints|1", "hosts must be"),
        ("utilization|--fleet|fleet.toml|--hosts|3", "--fleet goes without --hosts"),
        ("utilization|--fleet|none.toml", "none.toml: No such file or directory"),
        ("utilization|--fleet|fleet.toml|--json|--csv", "--json and --csv exclude each other"),
        (
            "utilization|--fleet|fleet.toml|--wifi|wlan",
            "--wifi must be 'paper' or a radio; '--wifi list'",
        ),
        (
            "utilization|--fleet|fleet.toml|--wifi|802.11a 20 MHz 1x1|--unicast-rate|5",
            "--unicast-rate goes with --wifi paper alone; got --wifi '802.11a 20 MHz 1x1'",
        ),
        (
            "utilization|--fleet|fleet.toml|--multicast-rate|-1.5",
            "multicast rate must be a finite number of at least 1 and at most 1e+15 bit/s; got",
        ),
        (
            "utilization|--fleet|fleet.toml|--unicast-overhead|-2",
            "unicast overhead must be a finite number of at least 0 and at most 1e+06 s; got -2 µs",
        ),
        ("breakdown|--hosts|1,2|--processes|1|--endpoints|1", "--hosts must be one number here"),
        ("saturation|--processes|2", "--endpoints must be given, or --fleet FILE"),
        ("saturation|--endpoints|10", "--processes must be given, or --fleet FILE"),
        (
            "saturation|fleet.toml|--endpoints|10",
            "--fleet goes without --processes, --endpoints and --robot",
        ),
        (
            "saturation|--processes|2|--endpoints|10|--limit|0",
            "limit must be a finite number above 0",
        ),
        (
            "plan",
            "--hosts, --processes, --endpoints must be given, or --fleet FILE, or --robot NAME",
        ),
        ("saturation|--processes|2|--endpoints|10|--beside|", "path must name a TOML file; got ''"),
        ("plan|", "path must name a TOML file; got ''"),
        ("plan|fleet.toml|--nodes|many", "'--nodes': must be a number"),
        ("plan|fleet.toml|--nodes|8", "fleet.toml: group 'laptop': nodes must be at most 7.5"),
        ("plan|fleet.toml|--nodes|1,2,3", "fleet.toml: nodes must be one number, or one for each"),
        ("plan|fleet.toml|--protocol|mqtt", "'mqtt' is no product or table. 'list' lists all"),
        ("figures", "Missing option '--out'"),
        ("figures|--out|", "--out must name a folder; got ''"),
        ("claims|--verdict|wrong", "'wrong' is not one of"),
        ("storm", "No such command 'storm'"),
    ],
)
def test_wrong_input_ends_with_2_and_says_what_is_allowed(arguments: str, message: str) -> None:
    result = run(arguments)
    assert result.exit_code == 2, result.output
    assert message in result.stderr
    assert result.stdout == ""
    assert "Traceback" not in result.output


@pytest.mark.parametrize("command", ["plan|bad.toml", "utilization|--fleet|bad.toml"])
@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        (
            "hosts = 10",
            "hosts = -3",
            "bad.toml: group 1 (robots): hosts must be a finite number of at least 1 and at "
            "most 1e+09; got -3",
        ),
        ("endpoints = 90", "endpoints = 'x'", "group 2 (laptop): endpoints must be a finite"),
        ("hosts = 1 ", "host = 1", "group 2 (laptop): key must be hosts or processes"),
        ("[[groups]]", "[[groups", "bad.toml must be a TOML file"),
    ],
)
def test_a_wrong_fleet_file_is_answered_with_file_key_value_and_range(
    folder: Path, command: str, old: str, new: str, message: str
) -> None:
    content = NAV2.replace("hosts = 1\n", "hosts = 1 \n")
    assert old in content
    (folder / "bad.toml").write_text(content.replace(old, new), encoding="utf-8")
    result = run(command)
    assert result.exit_code == 2
    assert message in result.stderr
    assert result.stdout == ""


def every_command() -> dict[str, click.Command]:
    assert isinstance(main, click.Group)
    context = click.Context(main)
    found = {name: main.get_command(context, name) for name in main.list_commands(context)}
    return {name: command for name, command in found.items() if command is not None}


def test_help_loads_no_command() -> None:
    code = "import sys; from discostorm.cli import main; main(['--help'], standalone_mode=False); "
    code += "assert not {'numpy', 'sympy', 'discostorm_planner.cli.plan'} & set(sys.modules)"
    subprocess.run([sys.executable, "-c", code], check=True, capture_output=True)


def test_there_are_eleven_commands() -> None:
    assert sorted(every_command()) == [
        "breakdown", "capture", "claims", "figures", "fleet", "plan", "robots", "saturation",
        "simulate", "utilization", "watch",
    ]  # fmt: skip


# What is watched is an interface of one's own, or what another program captures.
@pytest.mark.parametrize("name", ["", *sorted({*every_command()} - {"watch"})])
def test_help_has_examples_that_run(name: str, folder: Path) -> None:
    result = run(*filter(None, [name]), "--help")
    assert result.exit_code == 0
    assert "Example" in result.output
    text = result.output.replace("\\\n", "").replace("> claims.csv", "")
    text = text.replace("--processes 3 > fleet.toml", "--processes 2")
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
    whole = RECORD.partition("{file}")[2]
    for name, text in texts.items():
        found = re.findall(r"tcpdump -i \S+ -s 0 -w \S+( '[^']*'| *)", text)
        assert len(found) == text.count("tcpdump -i") > 0, name
        assert set(map(str.rstrip, found)) <= {"", whole}, name
    assert texts["help"].count(whole) == 2


@pytest.mark.parametrize(
    ("command", "option", "default"),
    [
        ("utilization", "--protocol", "Fast DDS"),
        ("utilization", "--wifi", "paper"),
        ("saturation", "--limit", "1.0"),
        ("plan", "--protocol", "Fast DDS"),
    ],
)
def test_help_tells_defaults(command: str, option: str, default: str) -> None:
    words = " ".join(run(command, "--help").output.split())
    told = words.split(f" {option} ")[-1].split(" --")[0]
    assert told.endswith(f"[default: {default}]")


def test_help_says_where_several_hosts_are_allowed() -> None:
    assert "--hosts N[,N...]" in run("utilization", "--help").output
    assert "--hosts N " in run("breakdown", "--help").output


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


def test_the_installed_script_is_the_command() -> None:
    """So is the module, which the tests of test_cli_manners.py run."""
    program = [str(Path(sys.executable).with_name("discostorm"))]
    env = os.environ | {"COLUMNS": "79"}
    done = subprocess.run(
        [*program, "utilization", *SWARM.split(), "--csv"],
        text=True, capture_output=True, check=False, env=env,
    )  # fmt: skip
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout == swarm("utilization", "--csv").stdout
    wrong = subprocess.run(
        [*program, "plan", "x.toml"], text=True, capture_output=True, check=False
    )
    assert wrong.returncode == 2
    assert wrong.stderr == "Error: x.toml: No such file or directory\n"


def test_version() -> None:
    assert run("--version").output == f"discostorm {ds.__version__}\n"


def test_the_books_shell_shows_command_output_and_exit_code() -> None:
    command = f"discostorm utilization {SWARM} --protocol dds"
    shown = notebook.shell(command, "discostorm plan x.toml").data
    assert shown.startswith(f"```text\n$ {command}\nprotocol  hosts")
    assert shown.endswith("Error: x.toml: No such file or directory\n[exit code 2]\n```")
    long = notebook.shell("discostorm utilization --hosts 0 --processes 1 --endpoints 1").data
    assert "got 0.0" in " ".join(long.split())
    assert max(map(len, long.splitlines())) <= 79
    assert "more lines" in notebook.shell("discostorm --help", lines=1).data
    with pytest.raises(ValueError, match="commands must start with discostorm; got 'ls'"):
        notebook.shell("ls")


@pytest.mark.parametrize(
    ("shown", "value", "text"),
    [
        (output.plain, 9_999_999_999.0, "9,999,999,999"),
        (output.plain, 1e10, "1e+10"),
        (output.percent, 0.9994, "99.9%"),
        (output.percent, 0.9995, "<100.0%"),
        (output.percent, 1.0, "100.0%"),
        (output.percent, 999_999.5, "99,999,950.0%"),
        (output.percent, 1e6, "1e+08%"),
        (output.percent, 1.5e6, "1.5e+08%"),
        (output.seconds, 9.0, "9.000000"),
        (output.seconds, 999_999.5, "999,999.5"),
        (output.seconds, 1e6, "1e+06"),
    ],
)
def test_numbers_for_people(shown: Callable[[float], str], value: float, text: str) -> None:
    assert shown(value) == text


def test_a_channel_that_is_just_full_does_not_fit_a_host_more() -> None:
    # The 3312 bits of an SPDP frame take half a second, up and down.
    rate = "0.006624"
    full = ("--processes|1", "--endpoints|0", f"--unicast-rate|{rate}", f"--multicast-rate|{rate}")
    full += ("--unicast-overhead|0", "--multicast-overhead|0", "--protocol|dds", "--json")
    (taken,) = read_json(run("utilization", "--hosts|1", *full))
    assert (taken["utilization"], taken["fits"]) == (1, False)
    (most,) = read_json(run("saturation", *full))
    assert (most["hosts"], most["fit"]) == (1, 0)


def test_huge_numbers_are_printed_with_their_power_of_ten() -> None:
    used = run("utilization|--hosts|1e9|--processes|1e9|--endpoints|0|--protocol|dds")
    assert re.search(r" \d(\.\d+)?e\+\d\d%  no$", used.stdout, re.MULTILINE)
    costs = run("breakdown|--hosts|1e9|--processes|1e9|--endpoints|0|--protocol|dds")
    assert not re.search(r"\d{7}", costs.stdout)
    assert costs.exit_code == 0
