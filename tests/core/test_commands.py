"""Test the commands: machine-readable output, and messages for wrong input."""

import math
import os
import re
import subprocess
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest
from click.testing import Result
from command_line import NAV2, SWARM_OPTIONS, read_csv, read_json, run

import discostorm as ds
from discostorm import figures
from discostorm.cli import output

pytestmark = pytest.mark.usefixtures("folder")


def swarm(command: str, *more: str) -> Result:
    return run(command, *SWARM_OPTIONS, *more)


def test_utilization_for_people() -> None:
    result = swarm("utilization", "--protocol|paper")
    assert result.exit_code == 0
    heading, rule, dds, zenoh, _, channel = result.output.splitlines()
    assert channel == "Channel: paper (802.11n), one access point in infrastructure mode."
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
    columns = [output.Column("short", "id"), *map(output.Column, ("count", "long_text"))]
    assert output.align_columns(table, columns).splitlines() == [
        "id   count  long text",
        "-" * 74,
        "a    1,234  x",
        "bcd      5  claims claims claims claims claims claims claims claims claims",
        "            claims claims claims",
    ]
    fitting = [{"text": "x" * 39 + " " + "y" * 39}]
    assert len(output.align_columns(fitting, [output.Column("text")]).splitlines()) == 3
    columns = [output.Column("wide"), output.Column("text")]
    wide = [{"wide": "w" * 70, "text": "0123456789 123456789"}]
    assert len(output.align_columns(wide, columns).splitlines()) == 3
    wider = [{"wide": "w" * 70, "text": "0123456789 1234567890"}]
    assert len(output.align_columns(wider, columns).splitlines()) == 4


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
        read_csv(swarm("breakdown", "--protocol|paper", "--csv")),
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


@pytest.mark.parametrize("protocol", ["Fast DDS 2.9", "Fast DDS Discovery Server"])
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
        return float(ds.utilization(protocol, replace(fleet, groups=tuple(groups))))

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


def test_matching_is_one_number_for_all_on_the_channel(folder: Path) -> None:
    (folder / "own.toml").write_text("matching = 1\n" + ROBOTS)
    refused = run("saturation|own.toml|--beside|fleet.toml")
    assert refused.exit_code == 2
    assert "matching must be the same in FLEET and --beside; got 1 and 0" in refused.stderr


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


def test_figures_refuses_a_file_as_the_folder(folder: Path) -> None:
    (folder / "file").write_text("")
    wrong = run("figures", "--out|file")
    assert wrong.exit_code == 2
    assert "--out must be a writable folder; got 'file'" in wrong.output


def test_figures_counts_what_it_wrote(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(figures, "save_all", lambda folder: iter([folder / "a", folder / "b"]))
    monkeypatch.setattr(figures, "FILES", ("a", "b"))
    lines = "[1/2] out/a\n[2/2] out/b\n"
    people = run("figures", "--out|out")
    assert (people.stdout, people.stderr) == (lines, "")
    machines = run("figures", "--out|out", "--csv")
    assert (machines.stdout, machines.stderr) == ("path\nout/a\nout/b\n", lines)


def test_what_takes_its_time_is_said_on_a_terminal_and_wiped_out(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True)
    with output.show_slow_task("planning"):
        assert capsys.readouterr() == ("", "planning ...")
    assert capsys.readouterr() == ("", "\r            \r")


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


@pytest.mark.parametrize("command", ["breakdown|bad.toml", "utilization|--fleet|bad.toml"])
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
        ("hosts = 1 ", "host = 1", "group 2 (laptop): unknown key host = 1. Did you"),
        ("[[groups]]", "[[groups", "bad.toml is not valid TOML"),
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


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ("utilization|--hosts|7", "give --processes and --endpoints, --fleet FILE"),
        (
            "utilization|--hosts|a|--processes|1|--endpoints|1",
            "'--hosts': must be one or more comma-separated numbers",
        ),
        (
            "utilization|--hosts|0|--processes|1|--endpoints|1",
            "hosts must be a finite number of at least 1 and at most 1e+09; got 0.0",
        ),
        ("utilization|--hosts|1|--processes|x|--endpoints|1", "'x' is not a valid float"),
        ("utilization|--hosts|nan|--processes|1|--endpoints|1", "hosts must be"),
        ("utilization|--fleet|fleet.toml|--hosts|3", "--fleet cannot be combined with --hosts"),
        ("utilization|--fleet|none.toml", "none.toml: No such file or directory"),
        ("utilization|--fleet|fleet.toml|--json|--csv", "use --json or --csv, not both"),
        (
            "utilization|--fleet|fleet.toml|--wifi|wlan",
            "got 'wlan'. '--wifi list' lists channels and radios",
        ),
        (
            "utilization|--fleet|fleet.toml|--wifi|802.11a 20 MHz 1x1|--unicast-rate|5",
            "--unicast-rate works only with --wifi paper; got --wifi '802.11a 20 MHz 1x1'",
        ),
        (
            "utilization|--fleet|fleet.toml|--multicast-rate|-1.5",
            "--multicast-rate in Mbit/s must be a finite number of at least 1e-06 and at most "
            "1e+09; got -1.5",
        ),
        (
            "utilization|--fleet|fleet.toml|--unicast-overhead|-2",
            "--unicast-overhead in µs must be a finite number of at least 0 and at most 1e+12; "
            "got -2",
        ),
        (
            "utilization|--fleet|fleet.toml|--wifi|802.11a 20 MHz 1x1|--multicast-rate|5",
            "--multicast-rate must be 6, 12 or 24 Mbit/s for 5 GHz; got 5 Mbit/s",
        ),
        ("breakdown|--hosts|1,2|--processes|1|--endpoints|1", "--hosts must be one number here"),
        ("saturation|--processes|2", "give --endpoints, --fleet FILE"),
        ("saturation|--endpoints|10", "give --processes, --fleet FILE"),
        (
            "saturation|fleet.toml|--endpoints|10",
            "--fleet cannot be combined with --processes, --endpoints and --robot",
        ),
        (
            "saturation|--processes|2|--endpoints|10|--limit|0",
            "limit must be a finite number above 0",
        ),
        ("saturation|--processes|2|--endpoints|10|--beside|", "path must name a TOML file; got ''"),
        ("figures", "Missing option '--out'"),
        ("figures|--out|", "--out must name a folder; got ''"),
        ("storm", "No such command 'storm'"),
    ],
)
def test_wrong_input_ends_with_2_and_says_what_is_allowed(arguments: str, message: str) -> None:
    result = run(arguments)
    assert result.exit_code == 2, result.output
    assert message in result.stderr
    assert result.stdout == ""
    assert "Traceback" not in result.output


def test_help_loads_no_command() -> None:
    code = "import sys; from discostorm.cli import main; main(['--help'], standalone_mode=False); "
    code += "assert not {'numpy', 'sympy', 'discostorm.cli.saturation'} & set(sys.modules)"
    subprocess.run([sys.executable, "-c", code], check=True, capture_output=True)


@pytest.mark.parametrize(
    ("command", "option", "default"),
    [
        ("utilization", "--protocol", "Fast DDS"),
        ("utilization", "--wifi", "paper"),
        ("saturation", "--limit", "1.0"),
        ("breakdown", "--protocol", "Fast DDS"),
    ],
)
def test_help_tells_defaults(command: str, option: str, default: str) -> None:
    words = " ".join(run(command, "--help").output.split())
    told = words.split(f" {option} ")[-1].split(" --")[0]
    assert told.endswith(f"[default: {default}]")


def test_help_says_where_several_hosts_are_allowed() -> None:
    assert "--hosts N[,N...]" in run("utilization", "--help").output
    assert "--hosts N " in run("breakdown", "--help").output


def test_the_installed_script_is_the_command() -> None:
    """So is the module, which the tests of test_cli_manners.py run."""
    program = [str(Path(sys.executable).with_name("discostorm"))]
    env = os.environ | {"COLUMNS": "79"}
    done = subprocess.run(
        [*program, "utilization", *SWARM_OPTIONS, "--csv"],
        text=True, capture_output=True, check=False, env=env,
    )  # fmt: skip
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout == swarm("utilization", "--csv").stdout
    wrong = subprocess.run(
        [*program, "breakdown", "x.toml"], text=True, capture_output=True, check=False
    )
    assert wrong.returncode == 2
    assert wrong.stderr == "Error: x.toml: No such file or directory\n"


def test_version() -> None:
    assert run("--version").output == f"discostorm {ds.__version__}\n"


@pytest.mark.parametrize(
    ("shown", "value", "text"),
    [
        (output.as_text, 9_999_999_999.0, "9,999,999,999"),
        (output.as_text, 1e10, "1e+10"),
        (output.percent, 0.9994, "99.9%"),
        (output.percent, 0.9995, "<100.0%"),
        (output.percent, 1.0, "100.0%"),
        (output.percent, 9.996, "999.6%"),
        (output.percent, 9_037.134, "904,000%"),
        (output.percent, 999_999.5, "100,000,000%"),
        (output.percent, 1e6, "1e+08%"),
        (output.percent, 1.5e6, "1.5e+08%"),
        (output.format_seconds, 9.0, "9.000000"),
        (output.format_seconds, 999_999.5, "999,999.5"),
        (output.format_seconds, 1e6, "1e+06"),
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
