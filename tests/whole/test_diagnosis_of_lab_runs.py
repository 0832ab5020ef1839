"""The diagnosis is right about the lab's runs, its fleets can be planned, and watch stays small."""

import csv
import os
import shlex
import subprocess
import sys
from pathlib import Path

import lab_data
import numpy as np
from click.testing import CliRunner
from support import REFERENCE, ROOT

from discostorm.cli import main

#: By what was staged, what the diagnosis may say of it first; "" if what was lost cannot be seen.
FIRST = {
    "multicast filtered": ("nobody hears",),
    "firewall on all hosts": ("nobody hears",),
    "firewall on one host": ("firewall",),
    "loss of 5 %": ("loss", "nothing"),
    "loss of 20 %": ("heavy loss",),
    "one direction of a host": ("one direction",),
    "one direction of a pair": ("one direction of pairs",),
    "client isolation": ("unicast dropped",),
    "client isolation but for one": ("client isolation",),
    "two domains": ("two domains",),
    "other subnet": ("other subnet",),
    "wrong interface": ("wrong interface",),
    "capture began late": ("capture began late",),
    "capture filter": ("capture lost part", "nobody hears, or filter"),
    "view of one robot": ("view of one host",),
    "crash": ("crash",),
    "restart": ("restart",),
    "late joiner": ("late joiner",),
    "leases expire": ("leases expire",),
    "storm without end": ("storm",),
    "crash loop": ("crash loop", "restart"),
    "server never there": ("server down",),
    "server dies": ("server down",),
    "clock set back": ("clock back",),
    "clock set forward": ("clock on",),
    "healthy": ("nothing",),
    "healthy, of other sizes": ("nothing",),
}


def test_the_labs_table_has_what_is_told_of_each_staging() -> None:
    rows = lab_data.read_lab_table("faults.csv")
    wrong: dict[str, int] = {}
    for row in rows:
        first = row["found"].split("; ")[0]
        if first not in FIRST[row["staged"]]:
            wrong[row["staged"]] = wrong.get(row["staged"], 0) + int(row["in"])
    assert {row["staged"] for row in rows} == {*FIRST}
    assert wrong == {}


def test_sixty_other_healthy_runs_raise_no_alarm() -> None:
    rows = [
        row
        for row in lab_data.read_lab_table("faults.csv")
        if row["staged"].endswith("other sizes")
    ]
    assert sum(int(row["in"]) for row in rows) >= 60
    assert {row["found"] for row in rows} == {"nothing"}


def test_times_are_those_of_the_processes_own_logs() -> None:
    rows = lab_data.read_lab_table("fault_times.csv")
    apart = [abs(float(row["capture_s"]) - float(row["log_s"])) for row in rows]
    assert len(rows) >= 150
    # One Python process of Zenoh was late to write its line.
    assert sum(time > 0.05 for time in apart) <= 1
    assert np.median(apart) < 0.01


def test_the_grids_stage_each_of_them() -> None:
    with (ROOT / "lab/grids/faults.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert {row["ill"] for row in rows} == {*FIRST} - {"healthy, of other sizes"}


def test_the_fleet_that_was_seen_can_be_planned(tmp_path: Path) -> None:
    name, path = "client_isolation_but_for_one-cyclone_dds_0_10", tmp_path / "fleet.toml"
    capture = REFERENCE / "captures" / "ills" / f"{name}.pcap.xz"
    arguments = ["capture", str(capture), "--write-fleet", str(path), "--wired", "10.77.0.1"]
    result = CliRunner().invoke(main, arguments)
    assert CliRunner().invoke(main, ["plan", str(path)]).exit_code == 0
    (following,) = [line for line in result.stdout.splitlines() if line.startswith("Wrote ")]
    again = shlex.split(following.partition("Next: discostorm ")[2])
    assert again[0] == "plan"
    assert CliRunner().invoke(main, again).exit_code == 0


def test_a_storm_takes_no_more_memory_the_longer_it_lasts() -> None:
    """A few minutes from ever other hosts, of the hour that the chapter on captures tells of."""
    root = ROOT
    done = subprocess.run(
        [
            sys.executable,
            "scripts/checks/measure_watch_memory.py",
            "--seconds",
            "100",
            "--rate",
            "300",
        ],
        capture_output=True,
        text=True,
        check=True,
        cwd=root,
        env=os.environ | {"PYTHONPATH": str(root)},
    )
    rows = [list(map(int, line.split(","))) for line in done.stdout.splitlines()[1:]]
    seconds, count, _, used = zip(*rows, strict=True)
    assert (seconds[-1], count[-1]) == (100, 30_000)
    half = len(used) // 2
    # The packets that are kept fill up in the first half and a bit.
    assert max(used[half:]) < max(used[:half]) + 40
    assert max(used) < 400
