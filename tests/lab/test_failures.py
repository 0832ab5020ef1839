"""Test the failures of the lab: evaluated logs, and the table of staged failures."""

import os
import signal
import subprocess
import sys
import uuid
from collections import Counter
from math import inf
from pathlib import Path
from typing import Any

import failure_log
import failures as lab
import numpy as np
import pytest
from test_lab_programs import marked_processes, ready, wait_until

from discostorm.data import read_data
from discostorm_book import lab_counts

ROWS = read_data("measured/deaths.csv", "discostorm_book")
OUTAGES = read_data("measured/outages.csv", "discostorm_book")


def step(at: float, do: str, what: str, phase: str = "") -> dict[str, Any]:
    return {"at": at, "do": do, "what": what} | ({"phase": phase} if phase else {})


def write_logs(folder: Path, steps: list[dict[str, Any]], logs: dict[str, list[str]]) -> Path:
    """Write the logs of a run; the stage begins at 100 s of the clock."""
    out = folder / "run"
    stage = [f"{100 + one['at']:.3f} {one['do']} {one['what']}" for one in steps]
    for name, lines in (logs | {"stage": stage}).items():
        text = "".join(
            f"{line}\n" for line in sorted(lines, key=lambda line: float(line.split()[0]))
        )
        out.with_suffix(f".{name}.log").write_text(text)
    return out


def beats(whom: str, begin: float, end: float) -> list[str]:
    """Lines of one who hears another one five times a second."""
    return [f"{time:.3f} heard {whom}" for time in np.arange(begin, end, 0.2)]


def matches(whom: str, when: float, change: str = "matched") -> list[str]:
    return [f"{when:.3f} {change} w {whom}", f"{when + 0.1:.3f} {change} r {whom}"]


def found(out: Path, job: dict[str, Any]) -> dict[tuple[str, str, str], float]:
    return {
        (row["phase"], row["who"], row["quantity"]): round(row["seconds"], 3)
        for row in failure_log.evaluate(out, job)
    }


def test_a_log_is_read_line_by_line(tmp_path: Path) -> None:
    """Also where a middleware prints by itself, and a kill has cut the last line."""
    text = (
        "1.000 me 0a\nServer up\n\x1b[2m2026 WARN x\n1.250 matched w 0b\n1.500 unmatched r 0b\n2.0"
    )
    (tmp_path / "run.1.log").write_text(text)
    assert failure_log.read_log(tmp_path / "run", "1") == [
        failure_log.Event(1.0, "me", "0a"),
        failure_log.Event(1.25, "matched w", "0b"),
        failure_log.Event(1.5, "unmatched r", "0b"),
    ]


def server_dies(tmp_path: Path, *, silent: float) -> tuple[Path, dict[str, Any]]:
    """1 hears nothing of 2 for a while; 3 comes late, and is found when the server is back."""
    job = {
        "programs": dict.fromkeys(["server8", "1", "2", "3"]),
        "groups": {"survivors": ["1", "2"], "early": ["2"], "newcomer": ["3"]},
        "steps": [
            step(10, "start", "2", "well"),
            step(20, "kill", "server8", "death"),
            step(40, "start", "3", "newcomer"),
            step(60, "start", "server8", "return"),
            step(80, "end", "", "end"),
        ],
    }
    logs = {
        "1": [
            "101.000 me aa",
            *matches("bb", 110.5),
            *beats("2", 111, 125),
            *beats("2", 125 + silent, 180),
            *matches("cc", 162),
            *beats("3", 162.5, 180),
        ],
        "2": [
            "110.100 me bb",
            *matches("aa", 110.6),
            *beats("1", 111, 180),
            *matches("cc", 163),
            *beats("3", 163.4, 180),
        ],
        "3": [
            "140.500 me cc",
            *matches("aa", 142),
            *matches("bb", 162),
            *beats("1", 162.2, 180),
            *beats("2", 162.2, 180),
        ],
    }
    return write_logs(tmp_path, job["steps"], logs), job


def test_who_goes_on_and_when_a_newcomer_is_found(tmp_path: Path) -> None:
    out, job = server_dies(tmp_path, silent=0.6)
    assert failure_log.was_discovery_complete(out, job)
    seconds = found(out, job)
    assert seconds["well", "newcomer", "found"] == 1  # both heard since 111
    assert seconds["death", "survivors", "silence"] == 0.8
    assert seconds["death", "survivors", "unmatched"] == inf
    assert seconds["death", "survivors", "settled"] == 0
    assert seconds["newcomer", "newcomer", "found"] == inf
    assert seconds["return", "newcomer", "found"] == 3.4  # 2 hears 3 last
    assert seconds["return", "survivors", "found"] == 0


def test_a_long_silence_is_told_from_a_loss_for_good(tmp_path: Path) -> None:
    seconds = found(*server_dies(tmp_path, silent=10))
    assert seconds["death", "survivors", "silence"] == 10.2
    assert seconds["death", "survivors", "settled"] == 15  # from 120 to 135
    seconds = found(*server_dies(tmp_path, silent=40))
    assert seconds["death", "survivors", "silence"] == inf
    assert seconds["death", "survivors", "settled"] == inf
    assert seconds["return", "survivors", "found"] == 5  # heard again at 165


def robot_dies(tmp_path: Path, *, given_up: float) -> tuple[Path, dict[str, Any]]:
    """1 and 2 give 3 up one after the other; 4 comes in between and is told of it."""
    job = {
        "programs": dict.fromkeys(["1", "2", "3", "4"]),
        "groups": {"survivors": ["1", "2"], "early": ["2"], "dead": ["3"], "newcomer": ["4"]},
        "steps": [
            step(10, "start", "2", "well"),
            step(20, "kill", "3", "death"),
            step(25, "start", "4", "newcomer"),
            step(60, "end", "", "end"),
        ],
    }
    pairs = {"1": "23", "2": "13", "3": "12"}
    logs = {
        me: [f"101.000 me {me * 4}"]
        + [line for it in others for line in matches(it * 4, 110.5) + beats(it, 111, 120)]
        + [
            line
            for it in others
            for line in (beats(it, 120, 160) if it != "3" and me != "3" else [])
        ]
        for me, others in pairs.items()
    }
    logs["1"] += matches("3333", 130, "unmatched")
    logs["2"] += matches("3333", 120 + given_up, "unmatched") if given_up < 40 else []
    logs["4"] = ["125.000 me 4444", *matches("3333", 126)]
    logs["4"] += matches("3333", 131, "unmatched") if given_up < 40 else []
    return write_logs(tmp_path, job["steps"], logs), job


def test_when_the_dead_is_given_up(tmp_path: Path) -> None:
    seconds = found(*robot_dies(tmp_path, given_up=20))
    assert seconds["death", "dead", "noticed"] == 20.1  # the reader of 2 is the last
    assert seconds["newcomer", "newcomer", "ghost"] == 5
    assert seconds["death", "survivors", "settled"] == 0
    seconds = found(*robot_dies(tmp_path, given_up=50))
    assert seconds["death", "dead", "noticed"] == inf
    assert seconds["newcomer", "newcomer", "ghost"] == inf


def test_a_run_in_which_not_all_was_well_is_known(tmp_path: Path) -> None:
    out, job = server_dies(tmp_path, silent=0.6)
    log = out.with_suffix(".1.log")
    log.write_text(log.read_text().replace("matched r bb", "matched r dd"))
    assert not failure_log.was_discovery_complete(out, job)


def test_every_staging_is_in_the_table_as_often_as_it_is_to_be_run() -> None:
    staged = {(name, event) for name, it in lab.CONFIGURATIONS.items() for event in it.events}
    runs = {(row["configuration"], row["event"], row["run"]) for row in ROWS}
    assert Counter(run[:2] for run in runs) == {one: lab.count_runs(*one) for one in staged}
    assert len(staged) == 30
    keys = Counter(tuple(row[name] for name in lab.COLUMNS[:6]) for row in ROWS)
    assert set(keys.values()) == {1}


def test_every_outage_is_in_its_table_five_times() -> None:
    runs = {(row["configuration"], row["event"], row["run"]) for row in OUTAGES}
    assert Counter(run[:2] for run in runs) == dict.fromkeys(
        lab.configurations_and_events(outages=True), lab.RUNS
    )
    table = lab_counts.failure_summary("outages").set_index(["phase", "who", "quantity"])
    assert int(table["runs"].sum()) == len(OUTAGES)
    back = table.loc[("return", "newcomer", "found")]
    # Each is away for as long as its name says, and is watched for longer than a lease after it.
    assert {f"{since:.0f} s" for since in back["since_s"]} == {
        " ".join(event.split(",")[0].split()[2:]) for event in back["event"]
    }
    assert (back["watched_s"] > 20).all()
    # While it is away nobody new is found, and nobody loses another one.
    assert (table.loc[("newcomer", "newcomer", "found"), "happened"] == 0).all()
    assert (table.loc[("death", "survivors", "settled"), "most_s"] == 0).all()


def outages(configuration: str) -> dict[str, tuple[int, int]]:
    """Return in how many of how many runs a process was found once the server was back."""
    table = lab_counts.failure_summary("outages")
    table = table[(table["phase"] == "return") & (table["who"] == "newcomer")]
    rows = table[table["configuration"] == configuration].itertuples()
    return {row.event: (row.happened, row.runs) for row in rows}


def test_a_short_outage_is_worse_than_a_long_one_and_a_backup_cures_it() -> None:
    plain = outages("Fast DDS Discovery Server")
    for seconds in lab.OUTAGES:
        found, runs = plain[f"outage of {seconds} s"]
        assert found == runs if seconds > 20 else found < runs / 2  # 20 s: the lease
    with_backup = outages("Fast DDS Discovery Server, backup")
    assert all(found == runs for found, runs in with_backup.values())


def test_what_is_watched_is_watched_for_longer_than_the_lease() -> None:
    leases = {
        row["configuration"]: float(row["lease_s"])
        for row in read_data("measured/configurations.csv", "discostorm_book")
    }
    assert leases == {name: it.lease for name, it in lab.CONFIGURATIONS.items()}
    for row in ROWS:
        if row["phase"] == "death":
            assert float(row["watched_s"]) > leases[row["configuration"]]
        seconds = float(row["seconds"])
        assert 0 <= seconds < float(row["watched_s"]) + 1 or seconds == inf


def test_the_table_is_what_the_file_says() -> None:
    table = lab_counts.failure_summary().set_index(
        ["configuration", "event", "phase", "who", "quantity"]
    )
    key = ("Zenoh router", "robot cut off", "death", "dead", "noticed")
    by_hand = sorted(
        float(row["seconds"])
        for row in ROWS
        if key == tuple(row[name] for name in table.index.names)
    )
    assert len(by_hand) == 5
    row = table.loc[key]
    assert (row["least_s"], row["median_s"], row["most_s"]) == (by_hand[0], by_hand[2], by_hand[4])
    assert (row["runs"], row["happened"]) == (5, 5)
    never = ("Zenoh router", "server killed", "newcomer", "newcomer", "found")
    assert (table.loc[never, "happened"], table.loc[never, "median_s"]) == (0, inf)
    assert int(table["runs"].sum()) == len(ROWS)


def test_what_was_not_measured_is_refused() -> None:
    with pytest.raises(ValueError, match=r"event must be .*'robot killed'.*; got 'sunset'"):
        lab_counts.failure_times("Fast DDS", "sunset", "death", "dead", "noticed")
    with pytest.raises(ValueError, match="quantity must be 'noticed'; got 'found'"):
        lab_counts.failure_times("Fast DDS", "robot killed", "death", "dead", "found")


def test_nobody_who_lives_loses_another_one_where_there_is_no_server() -> None:
    for name in ("Fast DDS", "Cyclone DDS", "Zenoh peer"):
        for event in ("robot killed", "robot cut off"):
            assert (
                lab_counts.failure_times(name, event, "death", "survivors", "unmatched") == inf
            ).all()


def test_what_ran_is_said_with_its_settings() -> None:
    rows = {
        row["configuration"]: row
        for row in read_data("measured/configurations.csv", "discostorm_book")
    }
    assert (
        "ROS_DISCOVERY_SERVER=10.77.0.8:11811;10.77.0.9:11811"
        in rows["Fast DDS Discovery Server, two"]["client"]
    )
    assert '"transport/link/tx/lease": 60000' in rows["Zenoh router per host"]["server"]
    assert not any(
        "/work" in text or "/home" in text for row in rows.values() for text in row.values()
    )


@pytest.mark.book
def test_nothing_is_left_after_ctrl_c(tmp_path: Path) -> None:
    """For real, in the middle of two stagings."""
    ready()
    mark = uuid.uuid4().hex
    made = subprocess.Popen(
        [sys.executable, str(lab.MEASURE / "failures.py"), "--short", "--out", str(tmp_path)],
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        env=os.environ | {"DISCOSTORM_MARK": mark},
    )
    # Two stages, each with a server and three clients at least.
    assert wait_until(lambda: len(marked_processes(mark)) > 9)
    made.send_signal(signal.SIGINT)
    made.communicate(timeout=120)
    assert wait_until(lambda: not marked_processes(mark)), "processes of the lab are still there"
    assert made.returncode == 130
    assert not [path for path in tmp_path.rglob("*") if path.is_file()], "half a run was left"


def test_what_remedies_say_of_deaths_was_measured() -> None:
    fails = {row["kind"]: row["fails"] for row in read_data("vendors/remedies.csv")}
    table = lab_counts.failure_summary().set_index(
        ["configuration", "event", "phase", "who", "quantity"]
    )
    again = ("Fast DDS Discovery Server", "server restarts", "newcomer", "newcomer", "found")
    assert table.loc[again, "happened"] < table.loc[again, "runs"]
    assert "and after short outages" in fails["discovery server"]
    plain = outages("Fast DDS Discovery Server")
    short = [found for event, found in plain.items() if float(event.split()[2]) <= 10]
    assert short
    assert all(found < runs / 2 for found, runs in short)
    for kind, name, who in (
        ("router", "Zenoh router", "survivors"),
        ("router on each host", "Zenoh router per host", "orphans"),
    ):
        back = table.loc[(name, "server killed", "return", who, "found"), "median_s"]
        assert f"until {back:.1f} s after the router is back" in fails[kind]
