"""Test the command line on odd terminals and full disks, with pipes and odd arguments."""

import json
import math
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest
from click.testing import CliRunner
from command_line import NAV2, SWARM_OPTIONS, run, shell
from support import ROOT

import discostorm as ds
from discostorm.cli import main, output
from discostorm.data import read_data
from discostorm.lookup import as_protocol
from discostorm.ros2_endpoints import likely_shared
from discostorm.wifi.radio import radio_named

LONE = "no one to discover"


pytestmark = pytest.mark.usefixtures("folder")


def test_tables_of_a_few_rows_need_no_pandas() -> None:
    commands = [
        ["utilization", *SWARM_OPTIONS],
        ["breakdown", *SWARM_OPTIONS, "--json"],
        ["saturation", "--processes", "2", "--endpoints", "10", "--csv"],
        ["robots", "--csv"],
    ]
    code = (
        "import sys; from discostorm.cli import main\n"
        f"for command in {commands!r}: main(command, standalone_mode=False)\n"
        "unused = {'pandas', 'matplotlib', 'numpy.f2py', 'IPython', 'sympy.physics.units'}\n"
        "sys.exit(' '.join(unused & set(sys.modules)))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.stderr.strip() == ""


@pytest.mark.parametrize("command", ["utilization", "breakdown", "saturation"])
def test_a_fleet_is_given_in_one_way_everywhere(command: str) -> None:
    named, placed, piped = (
        run(command, "--fleet", "fleet.toml"),
        run(command, "fleet.toml"),
        run(command, "-", input=NAV2),
    )
    assert named.exit_code == piped.exit_code == 0, named.output + piped.output
    assert named.stdout == placed.stdout
    assert piped.stdout.splitlines()[-1].split()[-1] == placed.stdout.splitlines()[-1].split()[-1]
    both = run(command, "fleet.toml", "--fleet", "fleet.toml")
    assert both.exit_code == 2
    assert "give one fleet; got" in both.stderr
    wrong = run(command, "-", input="[[groups]]\nhosts = 0\n")
    assert wrong.exit_code == 2
    assert "standard input: group 1" in wrong.stderr


def test_other_hosts_are_read_from_standard_input() -> None:
    arguments = ["saturation", "--processes", "2", "--endpoints", "10", "--limit", "40", "--beside"]
    assert run(*arguments, "-", input=NAV2).stdout == run(*arguments, "fleet.toml").stdout


@pytest.mark.parametrize("name", list(ds.PROTOCOLS))
def test_every_protocol_is_given_in_any_case_of_letters(name: str) -> None:
    table = as_protocol(name)  # of the newest release, also where a server forwards
    fleet = ds.Fleet((ds.HostGroup(7, 2, 10, shared=likely_shared(10)),))
    for written in (name, name.lower(), name.upper()):
        result = run("utilization", *SWARM_OPTIONS, "--protocol", written, "--json")
        (row,) = json.loads(result.stdout)
        assert row["protocol"] == table.name
        assert row["utilization"] == ds.utilization(table, fleet)


@pytest.mark.parametrize(
    ("name", "what"),
    [
        ("mesh", "a mesh"),
        ("802.11s 20 MHz 1x1", "a mesh"),
        ("ad hoc", "an ad hoc network"),
        ("adhoc", "an ad hoc network"),
        ("several access points", "several access points on one channel"),
        ("Roaming", "roaming"),
    ],
)
def test_networks_that_are_not_covered_are_refused_with_the_reason(name: str, what: str) -> None:
    found = run("breakdown", "fleet.toml", "--wifi", name)
    assert found.exit_code == 2
    said = " ".join(found.stderr.split())
    assert f"{what} is not covered" in said or f"{what} are not covered" in said
    assert "one access point in infrastructure mode" in said
    (row,) = (row for row in read_data("wifi/uncovered_networks.csv") if row["what"] == what)
    assert row["why"] in said
    limits = (ROOT / "book" / "limits.md").read_text(encoding="utf-8")
    told = what[0].upper() + what[1:]
    assert f"| {told} | {row['direction']} | {row['why']} |" in limits


@pytest.mark.parametrize("command", ["utilization", "breakdown", "saturation"])
def test_every_answer_names_the_kind_of_network(command: str) -> None:
    said = run(command, "fleet.toml").stdout
    assert "paper (802.11n), one access point in infrastructure mode." in " ".join(said.split())


@pytest.mark.parametrize(
    "radio",
    [
        ds.Radio("802.11a"),
        ds.Radio("802.11n", streams=2, band=2.4e9, mcs=3, multicast_rate=1e6),
        ds.Radio("802.11n", guard_interval=0.8e-6, aifsn=3, mpdus=64, start_spacing=0.25e-6),
        ds.Radio("802.11ax", width=160e6, streams=4, guard_interval=3.2e-6, multicast_rate=12e6),
        *(wifi.radio for wifi in ds.WIFI.values()),
    ],
    ids=lambda radio: radio.wifi().name,
)
def test_a_radio_is_found_by_the_name_it_gives_itself(radio: ds.Radio) -> None:
    name = radio.wifi().name
    for written in (name, name.lower(), name.upper().replace("Μ", "µ")):
        assert radio_named(written).wifi() == radio.wifi()


def test_a_channel_is_named_in_any_case_of_letters() -> None:
    for name in ("802.11ac 80 MHz 2x2", "paper", "list"):
        found = run("utilization", *SWARM_OPTIONS, "--wifi", name)
        assert found.exit_code == 0
        assert run("utilization", *SWARM_OPTIONS, "--wifi", name.upper()).stdout == found.stdout


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("wlan", "must be like '802.11ac 80 MHz 2x2'"),
        ("802.11n 20 MHz 2x3", "'2x3' cannot be in .* the name must be like"),
        ("802.11n 20 MHz 2x2, turbo", "'turbo' cannot be in"),
        ("802.11n 20 MHz 2x2, MCS 3, MCS 4", "'MCS 4' cannot be in"),
        ("802.11n 20 MHz 2x2, multicast x Mbit/s", "'multicast x Mbit/s' cannot be in"),
        ("802.11n 80 MHz 2x2", "width must be"),
        ("802.11n 20 MHz 2x2, A-MPDU 65", "mpdus must be a whole number .* at most 64"),
    ],
)
def test_a_wrong_name_of_a_radio_is_refused(name: str, text: str) -> None:
    with pytest.raises(ValueError, match=text):
        radio_named(name)
    result = run("utilization", *SWARM_OPTIONS, "--wifi", name)
    assert result.exit_code == 2
    assert ". '--wifi list' lists channels and radios" in result.stderr


def test_a_lone_robot_is_told_that_it_has_nobody_to_find(folder: Path) -> None:
    alone = NAV2[: NAV2.rindex("[[groups]]")].replace("hosts = 10", "hosts = 1")
    (folder / "alone.toml").write_text(alone, encoding="utf-8")
    lone = ["--hosts", "1", "--processes", "2", "--endpoints", "10"]
    for words in (
        *(["utilization", *lone], ["utilization", "alone.toml"], ["breakdown", "alone.toml"]),
        ["breakdown", *lone],
    ):
        assert LONE in run(*words).stdout
        assert LONE not in run(*words, "--json").stdout
    assert LONE not in run("utilization", *SWARM_OPTIONS).stdout


def test_a_table_fits_the_terminal(monkeypatch: pytest.MonkeyPatch) -> None:
    rows = [{"id": 1, "statement": "words " * 30}]
    for columns in (60, 120):
        monkeypatch.setenv("COLUMNS", str(columns))
        lines = output.align_columns(
            rows, [output.Column("id"), output.Column("statement")]
        ).splitlines()
        assert columns - 12 < max(map(len, lines)) < columns


@pytest.mark.parametrize(("columns", "lines"), [(80, 3), (60, 6), (40, 6)])
def test_a_table_too_wide_for_the_terminal_is_a_list(columns: int, lines: int) -> None:
    words = ["saturation", "--processes", "2", "--endpoints", "10", "--protocol", "DDS"]
    done = CliRunner(env={"COLUMNS": str(columns)}).invoke(main, words).stdout
    table = done.split("\n\n")[0].splitlines()
    assert len(table) == lines
    assert max(map(len, table)) <= columns
    assert ("saturated at hosts  7.16" in done) == (columns < 80)


def test_a_dumb_terminal_gets_no_progress(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True)
    monkeypatch.setenv("TERM", "dumb")
    with output.show_slow_task("planning"):
        pass
    assert capsys.readouterr().err == ""


# What goes wrong


def test_exit_codes_are_told() -> None:
    words = " ".join(run("--help").output.split())
    assert "Exit codes: 0 success, 1 interrupted or output not written, 2 invalid usage" in words


def test_a_full_disk_is_told_without_a_traceback() -> None:
    done = shell(f"discostorm utilization {' '.join(SWARM_OPTIONS)} > /dev/full")
    assert done.returncode == 1
    assert done.stderr == "Error: the output could not be written: No space left on device\n"


def test_a_closed_standard_output_is_told() -> None:
    done = shell("discostorm breakdown fleet.toml >&-")
    assert done.returncode == 1
    assert done.stderr == "Error: the output could not be written: Bad file descriptor\n"


def test_closed_standard_input_and_error_do_no_harm() -> None:
    done = shell("discostorm breakdown - <&-")
    assert (done.returncode, "standard input (-) is closed" in done.stderr) == (2, True)
    done = shell("discostorm utilization fleet.toml 2>&-")
    assert (done.returncode, "robots" in done.stdout or "fleet.toml" in done.stdout) == (0, True)


def test_ctrl_c_while_it_loads_leaves_no_traceback() -> None:
    code = (
        "import sys, discostorm.__main__\n"
        "slow = {'numpy', 'sympy', 'click'} & set(sys.modules)\n"
        "assert not slow, slow\n"
        "class Interrupt:\n"
        "    def find_spec(name, *_):\n"
        "        if name == 'sympy': raise KeyboardInterrupt\n"
        "sys.meta_path.insert(0, Interrupt)\n"
        "sys.argv = ['discostorm', 'saturation', '--processes', '2', '--endpoints', '10']\n"
        "discostorm.__main__.main()"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr.strip(), done.stdout) == (1, "Aborted!", "")
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    assert project["scripts"] == {"discostorm": "discostorm.__main__:main"}


def test_times_that_did_not_come_are_empty_in_csv(capsys: pytest.CaptureFixture[str]) -> None:
    output.print_table([{"run": 0, "convergence_time_s": math.inf}], output.Output(False, True))
    assert capsys.readouterr().out == "run,convergence_time_s\n0,\n"


def test_a_closed_pipe_blames_nothing(folder: Path) -> None:
    done = shell("discostorm figures --out out | head -n 1; exit ${PIPESTATUS[0]}")
    assert done.returncode == 1
    assert done.stdout.startswith("[ 1/12] out")
    assert done.stderr.strip() == ""
    assert not list((folder / "out").glob(".*"))


def test_control_characters_of_a_name_are_shown_escaped(folder: Path) -> None:
    name = "\\u001b[2J\\u0007"
    (folder / "odd.toml").write_text(NAV2.replace("robots", name), encoding="utf-8")
    advice = run("saturation", "odd.toml")
    assert advice.exit_code == 0
    assert "\x1b" not in advice.stdout
    assert "\\x1b[2J\\x07" in advice.stdout
    wrong = NAV2.replace("robots", name).replace("hosts = 10", "hosts = 0")
    (folder / "odd.toml").write_text(wrong, encoding="utf-8")
    refused = run("saturation", "odd.toml")
    assert refused.exit_code == 2
    assert "\x1b" not in refused.stderr
    assert "\\x1b[2J" in refused.stderr


@pytest.mark.parametrize(
    "content",
    ["groups = " + "[" * 5000 + "]" * 5000, ".".join("a" * 1000) + " = 1", "a = " + "9" * 5000],
    ids=["brackets", "dotted keys", "digits"],
)
def test_a_fleet_file_beyond_all_measure_is_refused(folder: Path, content: str) -> None:
    (folder / "odd.toml").write_text(content)
    result = run("breakdown", "odd.toml")
    assert result.exit_code == 2
    assert "odd.toml" in result.stderr
    assert "Traceback" not in result.output
    assert len(result.stderr) < 200
