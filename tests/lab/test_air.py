"""The emulated cell: stored runs say whether they are trusted, and agree with the simulator."""

import csv
import io
import os
import signal
import statistics
import subprocess
import sys
from collections import defaultdict
from pathlib import Path

import build_bench
import compare
import lab_data
import measure_air
import pytest
from test_lab_programs import wait_until

import discostorm as ds
from discostorm.data import read_data
from discostorm.protocols.measured_tables import products
from discostorm_planner.remedy_rules import simulation_caution

ROOT = Path(__file__).resolve().parents[2]
RUNS = lab_data.read_lab_table("air/runs.csv")
POINTS = read_data("measured/air.csv", "discostorm_book")
TRUSTED = [row for row in RUNS if row["trusted"] == "1"]
#: Points at which all robots start at once, without a server, on 802.11n.
USUAL = [p for p in POINTS if (p["server"], p["start"], p["standard"]) == ("", "", "n")]


def test_each_run_says_why_it_is_not_trusted() -> None:
    for row in RUNS:
        why = measure_air.reasons_for_distrust(row)
        assert row["why_not"] == "; ".join(why)
        assert row["trusted"] == str(int(not why))


@pytest.mark.parametrize(
    ("name", "value", "why"),
    [
        ("lag_95_s", 0.02, "ns-3 was late by 0.0200 s"),
        ("made_s", 0.5, "a process took 0.50 s to make its endpoints"),
        ("socket_dropped", 3, "sockets dropped 3 packets"),
        ("known", 1.03, "the robots did not know each other before the reboot"),
    ],
)
def test_a_late_or_lossy_run_is_not_trusted(name: str, value: float, why: str) -> None:
    assert not measure_air.reasons_for_distrust(TRUSTED[0])
    assert measure_air.reasons_for_distrust(TRUSTED[0] | {name: value}) == [why]


def test_receptions_of_a_run_add_up() -> None:
    for row in RUNS:
        fates = (*measure_air.LOSSES, "arrived", "waiting")
        assert sum(int(row[name]) for name in fates) == int(row["expected"])
        times = [float(row[f"t{part}_s"] or "inf") for part in (50, 95, 100)]
        assert times == sorted(times)
        assert (float(row["known"]) == 1) == bool(row["t100_s"])


def test_each_run_is_of_a_point_of_the_grid() -> None:
    with (ROOT / "lab" / "grids" / "air.csv").open(newline="") as file:
        grid = [
            tuple(row[name] for name in measure_air.POINT_COLUMNS) for row in csv.DictReader(file)
        ]
    assert len(set(grid)) == len(grid)
    assert {tuple(row[name] for name in measure_air.POINT_COLUMNS) for row in RUNS} <= set(grid)


def test_the_comparison_has_the_trusted_runs_only() -> None:
    for point in POINTS:
        of_point = [
            row for row in RUNS if all(row[n] == point[n] for n in measure_air.POINT_COLUMNS)
        ]
        for name, value in compare.measured_medians(of_point).items():
            assert point[name] == str(value), (point, name)
    assert sum(int(point["runs"]) for point in POINTS) == len(TRUSTED)


def test_quantiles_of_the_times_at_which_pairs_knew_each_other() -> None:
    times = [0.1, 0.2, 0.3, 0.4]
    assert measure_air.time_until_share_known(times, 4, 0.5) == 0.2
    assert measure_air.time_until_share_known(times, 4, 1.0) == 0.4
    assert measure_air.time_until_share_known(times, 5, 1.0) == ""


def test_what_is_missing_is_a_sentence_with_the_remedy(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(os, "geteuid", lambda: 1000)
    with pytest.raises(build_bench.MissingError, match="run it as root"):
        build_bench.refuse_unsuitable_machine()
    monkeypatch.setattr(os, "geteuid", lambda: 0)
    monkeypatch.setattr(build_bench, "NS3", tmp_path)
    if Path("/dev/net/tun").exists():
        with pytest.raises(build_bench.MissingError, match="make build/ns3/"):
            build_bench.refuse_unsuitable_machine()
    monkeypatch.setattr(build_bench, "ROOTS", tmp_path)
    with pytest.raises(build_bench.MissingError, match="make lab-roots makes it"):
        build_bench.build_program("fast_dds-2.6.12")


def why_the_bench_cannot_run() -> str:
    """The sentence that the bench itself would say, or nothing."""
    try:
        build_bench.refuse_unsuitable_machine()
        with (ROOT / "lab" / "grids" / "air_short.csv").open(newline="") as file:
            for row in csv.DictReader(file):
                build_bench.build_program(row["release"])
    except build_bench.MissingError as why:
        return str(why)
    return ""


def processes_of_the_bench(mark: str) -> list[int]:
    """Processes, in whatever namespaces, that were started for a mark."""
    found = []
    for folder in Path("/proc").glob("[0-9]*"):
        try:
            if mark.encode() in (folder / "cmdline").read_bytes():
                found.append(int(folder.name))
        except OSError:  # it has just ended
            continue
    return found


@pytest.mark.thorough
def test_the_short_grid_runs_and_an_interrupted_run_leaves_nothing_behind(tmp_path: Path) -> None:
    if why := why_the_bench_cannot_run():
        pytest.skip(f"make air GRID=short was not run: {why}")
    command = [sys.executable, str(ROOT / "lab" / "air" / "measure_air.py"), "--once"]
    command += ["--grid", str(ROOT / "lab" / "grids" / "air_short.csv"), "--out", str(tmp_path)]
    mark = str(build_bench.BENCH / "cell")
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT) as campaign:
        assert wait_until(lambda: processes_of_the_bench(mark))
        campaign.send_signal(signal.SIGINT)
        assert campaign.wait(120) == 130
    assert wait_until(lambda: not processes_of_the_bench(mark))
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    runs = list(csv.DictReader(io.StringIO((tmp_path / "runs.csv").read_text())))
    assert len(runs) == 3
    assert all(float(row["known"]) == 1 for row in runs)
    again = subprocess.run(command, capture_output=True, text=True, check=False)
    assert "3 of 3 runs are in" in again.stdout


def test_the_simulator_agrees_as_the_chapter_says() -> None:
    agree, apart = defaultdict(list), defaultdict(list)
    for point in USUAL:
        if point["sender"] == "waits" and not point["edp_answers"] and point["runs"] != "0":
            simulated, seconds = float(point["simulated_t95_s"]), float(point["seconds"])
            ratio = float(point["t95_s"] or "inf") / simulated
            # Of two that are not complete while we watch, neither is the longer.
            both_never = not point["t95_s"] and simulated > seconds
            agree[point["release"]].append(both_never or 1 / 1.3 <= ratio <= 1.3)
            if point["t95_s"]:
                apart[point["release"]].append(max(ratio, 1 / ratio))
    shipped = ("fast_dds-2.6.12", "fast_dds-2.14.6", "fast_dds-3.6.2")
    for releases, points, agreeing, typical in (
        (agree, 50, 39, 1.08),
        (shipped, 36, 32, 1.07),
        (["fast_dds-2.9.1"], 7, 5, 1.26),
        (["cyclone_dds-0.10.5"], 7, 2, 2.58),
    ):
        told = [one for release in releases for one in agree[release]]
        assert (len(told), sum(told)) == (points, agreeing)
        found = statistics.median(one for release in releases for one in apart[release])
        assert found == pytest.approx(typical, abs=0.01)


def time(text: str) -> float:
    return float(text or "inf")


def test_the_planner_has_the_least_and_the_most_of_these_ratios() -> None:
    told = read_data("measured/air_ratios.csv", "discostorm_planner")
    of = {
        (table, server)
        for p in POINTS
        if p["server"] != "robot"
        for table, server in ((p["protocol"], ""), (compare.TABLES[p["release"]], p["server"]))
    }
    assert len(of) == 10
    assert sorted((row["protocol"], row["server"]) for row in told) == sorted(of)
    for row in told:
        own = [p for p in POINTS if p["sender"] == "waits" and p["protocol"] == row["protocol"]]
        if row["server"]:
            own = [p for p in POINTS if p["server"] == row["server"]]
            own = [p for p in own if compare.TABLES[p["release"]] == row["protocol"]]
        own = [point for point in own if point["simulated_t95_s"] and not point["start"]]
        own = [p for p in own if max(map(time, (p["t95_s"], p["simulated_t95_s"]))) > 1.5]
        pairs = [(float(p["t95_s"] or p["seconds"]), float(p["simulated_t95_s"])) for p in own]
        ratios = [real / simulated for real, simulated in pairs]
        # A run that was not complete took longer than that.
        found = [r for r, p in zip(ratios, own, strict=True) if p["t95_s"] or r > 1]
        assert int(row["points"]) == len(own)
        assert [float(row["low"]), float(row["high"])] == pytest.approx(
            [min(found), max(found)], abs=0.005
        )


@pytest.mark.parametrize("name", ["Fast DDS", "Fast DDS 2.6"])
def test_a_release_that_collapses_does_so_in_the_simulation(name: str) -> None:
    same = {"protocol": name, "hosts": "8", "ampdu": "0", "sender": "waits", "edp_answers": ""}
    [point] = [p for p in USUAL if all(p[key] == value for key, value in same.items())]
    assert point["finished"] == "0"
    assert float(point["simulated_t95_s"]) > float(point["seconds"])
    assert not simulation_caution(ds.PROTOCOLS[name])


def test_the_caution_for_cyclone_dds_tells_what_was_measured() -> None:
    own = [p for p in USUAL if (p["protocol"], p["sender"]) == ("Cyclone DDS", "waits")]
    assert {point["release"] for point in own} == {"cyclone_dds-0.10.5"}
    alone = [point for point in own if point["ampdu"] == "0"]
    ratios = [float(p["t95_s"]) / float(p["simulated_t95_s"]) for p in alone if p["t95_s"]]
    (late,) = (point for point in alone if not point["t95_s"])
    told = simulation_caution(ds.PROTOCOLS["Cyclone DDS"])
    assert told.startswith("in an emulated Wi-Fi cell without frame aggregation, real Cyclone DDS")
    assert f" 0.10.5 took {min(ratios):.1f} to {max(ratios):.1f} times as long as in our" in told
    done = f"{float(late['known']):.0%} of discovery after {float(late['seconds']):.0f} s"
    assert told.endswith(f"and {late['hosts']} robots had completed only {done}")
    (row,) = (
        row
        for row in read_data("measured/air_ratios.csv", "discostorm_planner")
        if row["protocol"] == "Cyclone DDS"
    )
    for name in ("Cyclone DDS, wired", "Cyclone DDS, version 11", "Cyclone DDS, version 11, wired"):
        said = products()[name]["caution"]
        assert "was not measured in an emulated Wi-Fi cell" in said
        assert said.endswith(
            f"took up to {float(row['high']):.1f} times as long as in our simulation"
        )
    for name in ("Cyclone DDS peers", "Cyclone DDS multicast SEDP"):
        assert simulation_caution(ds.PROTOCOLS[name]) == told
    assert not simulation_caution(ds.PROTOCOLS["DDS, periods of Cyclone DDS"])


def test_the_simulated_server_agrees_with_real_ones() -> None:
    """Also where answers without delay keep a server's clients from discovering each other."""
    served = [p for p in POINTS if p["server"] == "wired"]
    (late,) = (p for p in served if not p["t95_s"])
    assert (late["release"], late["ampdu"], late["simulated_t95_s"]) == ("fast_dds-2.9.1", "0", "")
    humble = [p for p in served if p["release"] == "fast_dds-2.6.12"]
    assert [p["finished"] for p in humble] == ["1"] * 3
    newer = [p for p in served if p["release"] in ("fast_dds-2.14.6", "fast_dds-3.6.2")]
    assert len(newer) == 6
    for point in newer:
        assert 1 / 1.3 < float(point["t95_s"]) / float(point["simulated_t95_s"]) < 1.3
        assert abs(float(point["lost"]) - float(point["simulated_lost"])) < 0.11


def test_the_ledger_tells_which_releases_completed_with_eight_hosts() -> None:
    remarks = {
        row["key"]: row["remark"] for row in read_data("paper/claims.csv", "discostorm_book")
    }
    for key in ("connectivity-collapses", "retransmission-converges"):
        assert "real Fast DDS in the release" in remarks[key]
    done = {
        (point["release"], point["ampdu"]): point["finished"] == point["runs"]
        for point in USUAL
        if (point["hosts"], point["sender"], point["edp_answers"]) == ("8", "waits", "")
    }
    assert not done["fast_dds-2.6.12", "0"]
    for release in ("fast_dds-2.14.6", "fast_dds-3.6.2"):
        assert done[release, "0"]
        assert done[release, "1"]


def test_one_constant_decides_whether_eight_robots_finish() -> None:
    [shipped, slow] = [
        [row for row in TRUSTED if row["edp_answers"] == answers] for answers in ("", "slow")
    ]
    same = {"release": "fast_dds-2.6.12", "hosts": "8", "ampdu": "0"}
    same |= {"sender": "waits", "server": ""}
    of_eight = [
        [row["t100_s"] for row in rows if all(row[n] == v for n, v in same.items())]
        for rows in (shipped, slow)
    ]
    assert of_eight[0] == [""] * len(of_eight[0])
    assert all(float(time) < 6 for time in of_eight[1])


def test_the_captures_for_upstream_are_as_the_readme_says_and_can_be_read() -> None:
    text = (ROOT / "lab" / "air" / "README.md").read_text(encoding="utf-8")
    paths = sorted((ROOT / "lab" / "air" / "captures").glob("*.xz"))
    shipped, slow = (ds.read_capture(path) for path in paths)
    assert "slow" in slow.path
    assert all(path.stat().st_size < 1e6 for path in paths)
    assert f"hold {shipped.packets:,} and {slow.packets:,} packets" in text
    assert shipped.fleet().hosts() == slow.fleet().hosts() == 5
    runs = {
        answers: [
            float(row["ran_s"])
            for row in TRUSTED
            if (row["hosts"], row["edp_answers"], row["ampdu"]) == ("5", answers, "0")
            and (row["release"], row["sender"]) == ("fast_dds-2.6.12", "waits")
        ]
        for answers in ("", "slow")
    }
    # Both were recorded until every process knew every endpoint.
    assert min(runs[""]) - 0.3 < shipped.duration < max(runs[""])
    assert min(runs["slow"]) - 0.3 < slow.duration < max(runs["slow"])
