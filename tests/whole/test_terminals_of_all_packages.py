"""Test the command lines of all packages on odd terminals and full disks, with pipes."""

import json
from pathlib import Path

import pytest
from command_line import NAV2, SWARM_OPTIONS, run, shell

import discostorm as ds
from discostorm.wifi.radio import radio_named

pytestmark = pytest.mark.usefixtures("folder")


def test_what_the_planner_advises_can_be_given_back() -> None:
    fleet = ds.Fleet.from_toml("fleet.toml")
    for wifi in ("802.11n 20 MHz 2x2", "802.11ac 80 MHz 2x2, AIFSN 3"):
        advised = ds.plan(fleet, wifi=radio_named(wifi).wifi()).remedies
        for remedy in advised:
            if remedy.kind in ("radio", "multicast rate"):
                given = ["--wifi", remedy.wifi.name, "--protocol", "dds", "--json"]
                (row,) = json.loads(run("utilization", "fleet.toml", *given).stdout)
                assert remedy.range_after is not None
                assert row["utilization"] == remedy.range_after.single
                assert row["utilization_full_ampdus"] == remedy.range_after.full
    rate = ["--wifi", "802.11n 20 MHz 2x2", "--multicast-rate", "24", "--json"]
    rate += ["--protocol", "dds"]
    expected = ds.Radio("802.11n", streams=2, multicast_rate=24e6).wifi()
    assert json.loads(run("utilization", *SWARM_OPTIONS, *rate).stdout)[0][
        "utilization"
    ] == ds.utilization(ds.DDS, 7, 2, 10, wifi=expected)


def test_standard_input_has_one_name() -> None:
    odd = "[[groups]]\nhosts = 2.5\nprocesses = 1\nendpoints = 100\n"
    half = run("plan", "-", input=odd)
    assert half.stderr.startswith("Error: standard input: hosts must be a whole number")
    assert "standard input" in run("utilization", "-", input=NAV2).stdout
    twice = run("saturation", "-", "--beside", "-", input=NAV2)
    assert (twice.exit_code, "cannot both be -, standard input" in twice.stderr) == (2, True)


@pytest.mark.parametrize("name", ["x.gif", "x", ".png"])
def test_a_picture_is_of_the_formats_that_help_names(name: str) -> None:
    done = run("capture", "fleet.toml", "--picture", name)
    assert done.exit_code == 2
    assert f"'--picture': must end in .svg, .pdf or .png; got {name!r}" in done.stderr


def test_what_a_terminal_cannot_show_is_escaped(folder: Path) -> None:
    name = "\u30ed\u30dc"
    small = NAV2.replace("robots", name).replace("hosts = 10", "hosts = 2")
    assert small.count("hosts = 2") == 1
    (folder / "kana.toml").write_text(small, encoding="utf-8")
    env = {"PYTHONIOENCODING": "latin-1", "PYTHONUTF8": "0"}
    people = shell("discostorm plan kana.toml", **env)
    assert (people.returncode, people.stderr) == (0, "")
    assert r"\u30ed\u30dc" in people.stdout
    machines = shell("discostorm plan kana.toml --json", **env)
    names = [group["name"] for group in json.loads(machines.stdout)["fleet"]]
    assert names == [name, "laptop"]
