"""Test the campaign of releases: its tables, its lock, and its answer without a root."""

import csv
import gzip
import json
import os
import re
import subprocess
import sys
import time
from collections import Counter
from pathlib import Path
from typing import Any

import make_roots
import netns_run
import pytest
import run_grid
import run_releases as lab
from support import ROOT

pytestmark = pytest.mark.book

GRID = lab.read_table_if_present(run_grid.GRIDS / "releases.csv")
RELEASES = make_roots.releases()
SIZES = {4, 6, 9, 12, 15, 20}


def points(release: str, **only: str) -> list[dict[str, str]]:
    return [
        row
        for row in GRID
        if row["release"] == release and all(row[name] == value for name, value in only.items())
    ]


def sizes(rows: list[dict[str, str]]) -> set[int]:
    return {int(row["hosts"]) * int(row["processes"]) for row in rows}


def roots() -> dict[str, dict[str, Any]]:
    return {row["release"]: {"command": ["x"], "server": ["y", "HOST"]} for row in RELEASES}


def test_each_release_says_what_it_is_made_of_with_a_checksum_and_where_it_is_from() -> None:
    assert [row["product"] for row in RELEASES].count("fast_dds") == 5
    for row in RELEASES:
        assert row["how"] in {"source", "debian", "pypi"}
        assert row["source"]
        made_of = row["made_of"].split()
        if row["how"] == "pypi":  # its hashes are in the lock
            lock = (run_grid.LAB / "requirements.lock").read_text(encoding="utf-8")
            assert f"{row['made_of']} \\\n    --hash=sha256:" in lock
            continue
        sums = row["sha256"].split()
        assert len(sums) == len(made_of)
        assert all(re.fullmatch(r"[0-9a-f]{64}", one) for one in sums)
        assert any(row["version"] in one for one in made_of)
        assert bool(row["suite"]) == (row["how"] == "debian")
        assert set(row["rmw"].split()) <= {"gid24", "hash", "described"}


def test_no_table_names_a_machine() -> None:
    text = make_roots.TABLE.read_text(encoding="utf-8")
    assert not re.search(r"https?://|(^|[ ,\"])/\w", text)


def test_all_releases_are_measured_and_no_point_twice() -> None:
    assert {row["release"] for row in GRID} == {row["release"] for row in RELEASES}
    keys = [tuple(value for name, value in row.items() if name != "use") for row in GRID]
    assert len(keys) == len(set(keys))
    assert 500 <= sum(int(row["runs"]) for row in GRID) <= 700


@pytest.mark.parametrize("release", [row["release"] for row in RELEASES])
def test_each_size_is_there_once_to_fit_and_once_to_test(release: str) -> None:
    for use in ("fit", "test"):
        rows = points(release, use=use, names="matching", types="one")
        rows = [row for row in rows if row["server"] != "server"]
        assert sizes(rows) == SIZES
        assert len(rows) == len(SIZES)
        assert len(sizes(points(release, use=use, names="unique", types="one"))) >= 3
    fit, test = (
        {tuple(row.items())[1:4] for row in points(release, use=use)} for use in ("fit", "test")
    )
    assert not fit & test


def test_servers_and_types_are_where_they_have_a_say() -> None:
    for row in RELEASES:
        of_types = {point["types"] for point in points(row["release"])}
        servers = {point["server"] for point in points(row["release"])}
        if row["product"] == "zenoh":
            assert (of_types, servers) == ({"one"}, {"router_per_host"})
        elif row["product"] == "fast_dds":
            assert servers == {"", "server"}
        if "described" in row["rmw"]:
            assert of_types == {"one", "own", "roles"}
    for row in GRID:
        assert int(row["endpoints"]) % 2 == 0
        # A topic that all share has one type.
        assert row["types"] == "one" or row["names"] == "unique"
        assert (row["runs"], row["seconds"]) in {(runs, "12") for runs in "235"}


def test_runs_have_names_of_their_own_and_are_known_by_their_rows() -> None:
    found = lab.list_runs(GRID, roots())
    assert len(found) == sum(int(row["runs"]) for row in GRID)
    names = [job["name"] for job in found]
    assert len(names) == len(set(names))
    assert all(re.fullmatch(r"[a-z0-9_-]+", name) for name in names)
    assert len({lab.run_key(job) for job in found}) == len(found)
    # The first run of each point comes before the second of any.
    numbers = [job["number"] for job in found]
    assert numbers == sorted(numbers)


def test_what_serves_is_named_in_the_environment_of_the_others() -> None:
    [client] = lab.list_runs(points("fast_dds-3.6.2", server="server")[:1], roots())[:1]
    assert client["env"] == {
        "RMW": "hash described",
        "ROS_DISCOVERY_SERVER": "10.77.0.101:11811",
    }
    [(host, words)] = client["servers"]
    assert (host, words[-4:]) == (101, ["-l", "10.77.0.101", "-p", "11811"])
    [peer] = lab.list_runs(points("zenoh-1.10.2")[:1], roots())[:1]
    assert peer["servers"] == [(1, ["y", "1"]), (2, ["y", "2"])]
    [cyclone] = lab.list_runs(points("cyclone_dds-0.10.5")[:1], roots())[:1]
    assert "spdp" in cyclone["env"]["CYCLONEDDS_URI"]


def test_expected_matches_are_those_of_everybody_with_everybody() -> None:
    told = {"hosts": 3, "processes": 2, "endpoints": 10, "names": "matching"}
    # Five writers and five readers a process, each with one of six processes.
    assert lab.count_expected_matches(told) == 6 * 6 * 10
    assert lab.count_expected_matches(told | {"names": "unique"}) == 0


def test_packets_say_which_release_sends_them() -> None:
    header = b"RTPS\x02\x03\x01\x0f"
    assert lab.versions_in_packets(header) == "RTPS 2.3, eProsima"
    assert (
        lab.versions_in_packets(2 * (header + b"\0\x80\4\0\3\6\2\0")) == "RTPS 2.3, eProsima, 3.6.2"
    )
    cyclone = b"RTPS\x02\x05\x01\x10" + b"host/0.10.5/Linux/Linux"
    assert lab.versions_in_packets(cyclone) == "RTPS 2.5, Eclipse Cyclone DDS, 0.10.5"
    assert lab.versions_in_packets(b"\x01\x04Zenoh") == ""


def test_a_table_is_whole_or_as_it_was(tmp_path: Path) -> None:
    path = tmp_path / "runs.csv"
    lab.write_atomically(path, [{"run": "a", "more": 1}], ("run",))
    with pytest.raises(ZeroDivisionError):
        lab.write_atomically(path, ({"run": 1 / 0} for _ in "1"), ("run",))  # type: ignore[arg-type]
    assert lab.read_table_if_present(path) == [{"run": "a"}]
    assert lab.read_table_if_present(tmp_path / "none.csv") == []


def test_a_release_without_a_root_is_a_sentence(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(lab, "ROOTS", tmp_path)
    found, sentences = lab.existing_roots({"fast_dds-3.6.2"})
    assert not found
    assert sentences == [
        "fast_dds-3.6.2 has no root: make lab-roots makes it, or says what is missing"
    ]
    assert lab.list_runs(GRID, found) == []


def test_a_revision_of_debian_is_the_same_release() -> None:
    assert (
        make_roots.upstream_release("2.9.1+ds-1+deb12u2")
        == "2.9.1"
        == make_roots.upstream_release("2.9.1-3")
    )
    assert make_roots.upstream_release("3.1.2+ds-1") != "3.1"
    assert make_roots.upstream_release("") == ""


@pytest.mark.skipif(not Path("/proc/stat").exists(), reason="not Linux")
def test_what_others_take_leaves_out_all_processes_that_are_here() -> None:
    """Here are all processes, so nothing is of others; but one that ends meanwhile, is."""
    for _ in range(5):
        others, total = netns_run.busy_time_of_others()
        end = time.process_time() + 0.5
        while time.process_time() < end:
            pass
        others_now, total_now = netns_run.busy_time_of_others()
        assert total_now - total >= 40  # ticks of 10 ms, of one processor at least
        if others_now - others < 40:
            return
    pytest.fail("what this process takes is counted as taken by others")


class Machine:
    """Stands in for the lab: its runs have a checksum each, and some cores are busy."""

    def __init__(self, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        self.folder, self.monkeypatch = folder, monkeypatch
        self.begun: list[str] = []
        self.told: dict[str, float] = {}
        for name in ("run_in_parallel", "compress_capture", "run_row", "count_rows"):
            monkeypatch.setattr(lab, name, getattr(self, name))
        monkeypatch.setattr(lab, "existing_roots", lambda _: (roots(), []))

    def run_in_parallel(
        self, jobs: list[dict[str, Any]], folder: Path, finish: Any, **_: float
    ) -> int:
        for job in jobs:
            self.begun.append(job["name"])
            out = folder / job["name"]
            with gzip.open(out.with_suffix(".pcap.gz"), "wb") as file:
                file.write(b"RTPS\x02\x03\x01\x0f")
            told = {"idle": 0.8, "others": 0.02} | self.told
            out.with_suffix(".json").write_text(json.dumps(job | told))
            out.with_suffix(".1.1.log").write_text("matched 3 1 0.5\n")
            out.with_suffix(".2.1.log").write_text("matched 2 4 0.25\n")
            finish(out)
        return 0

    def compress_capture(self, out: Path) -> str:
        return out.name

    def run_row(self, _: str, capture: Path, told: dict[str, Any]) -> dict[str, Any]:
        late = f"{self.told.get('late', 0):.4f}"
        checksum = f"{len(self.begun):010d}{capture.name}"
        return {"sha256": checksum, "start_skew_s": late, "idle": told["idle"]}

    def count_rows(self, name: str, *_: object) -> list[dict[str, Any]]:
        return [{"run": name, "kind": "SPDP", "messages": len(self.begun)}]

    def main(self, grid: str, *more: str) -> int:
        (self.folder / "grid.csv").write_text(grid)
        where = ("--out", self.folder / "out", "--captures", self.folder / "captures")
        words = ["run_releases.py", "--grid", self.folder / "grid.csv", *where, *more]
        self.monkeypatch.setattr("sys.argv", list(map(str, words)))
        return lab.main()

    def runs(self) -> list[dict[str, str]]:
        return lab.read_table_if_present(self.folder / "out" / "runs.csv")

    def counts(self) -> list[dict[str, str]]:
        return lab.read_table_if_present(self.folder / "out" / "counts.csv")


@pytest.fixture
def machine(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Machine:
    return Machine(tmp_path, monkeypatch)


HEAD = "release,hosts,processes,endpoints,names,types,server,use,runs,seconds\n"
TWICE = HEAD + "fast_dds-3.6.2,2,1,4,matching,one,,test,2,12\n"


def test_what_is_stored_is_not_run_again(machine: Machine) -> None:
    assert machine.main(TWICE) == 0
    first = machine.runs()
    assert [row["number"] for row in first] == ["1", "2"]
    assert {(row["matched"], row["expected"], row["last_match_s"]) for row in first} == {
        ("10", "16", "0.500")
    }
    assert machine.main(TWICE + "fast_dds-2.14.6,2,1,4,matching,one,,test,1,12\n") == 0
    assert len(machine.begun) == 3
    assert machine.runs()[:2] == first
    assert {row["run"] for row in machine.counts()} == {row["run"] for row in machine.runs()}
    assert not list((machine.folder / "captures").glob("*.log"))


@pytest.mark.parametrize("why", [{"idle": 0.2}, {"others": 0.2}, {"late": 0.15}])
def test_a_run_whose_cores_were_not_idle_is_marked_and_repeated(
    machine: Machine, why: dict[str, float]
) -> None:
    machine.told = why
    assert machine.main(TWICE, "--once") == 0
    assert len(machine.begun) == 2
    assert machine.main(TWICE) == 1
    assert len(machine.begun) == 2 + 2 * lab.MAX_ATTEMPTS
    assert [row["again"] for row in machine.runs()] == ["1", "1"]
    machine.told = {}
    assert machine.main(TWICE) == 0
    assert [row["again"] for row in machine.runs()] == ["0", "0"]
    # What was counted in the runs before is gone.
    assert [row["messages"] for row in machine.counts()] == ["9", "10"]


def source(folder: Path) -> Path:
    (folder / "src").mkdir(parents=True)
    (folder / "CMakeLists.txt").write_text("project(a)\n")
    (folder / "src" / "a.c").write_text("int a;\n")
    return folder


def test_a_checksum_is_of_what_is_built_alone(tmp_path: Path) -> None:
    one = make_roots.checksum(source(tmp_path / "one"))
    two = source(tmp_path / "two")
    (two / "README.md").write_text("more\n")
    (two / "src" / "sqlite3.c").write_text("int b;\n")
    assert make_roots.checksum(two) == one
    (two / "src" / "a.c").write_text("int b;\n")
    assert make_roots.checksum(two) != one


@pytest.mark.parametrize(
    ("sources", "sentence"),
    [
        (None, "its sources (Fast-CDR-1.0.29, Fast-DDS-2.6.12) are missing: say where they are"),
        ("empty", "there is no Fast-CDR-1.0.29 in the folder of SOURCES"),
        ("other", "Fast-CDR-1.0.29 is not what was pinned: its checksum is "),
    ],
)
def test_what_is_missing_is_said_in_a_sentence(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, sources: str | None, sentence: str
) -> None:
    monkeypatch.setattr(make_roots, "ROOTS", tmp_path / "roots")
    (tmp_path / "empty").mkdir()
    for name in ("Fast-CDR-1.0.29", "Fast-DDS-2.6.12"):
        source(tmp_path / "other" / name)
    row = next(row for row in RELEASES if row["version"] == "2.6.12")
    with pytest.raises(make_roots.MissingError, match=f"^{re.escape(sentence)}"):
        make_roots.make_root(row, tmp_path / sources if sources else None, None)
    assert not (tmp_path / "roots" / row["release"] / make_roots.DESCRIPTION_FILE).exists()


def test_an_unknown_release_is_refused_with_the_list() -> None:
    made = subprocess.run(
        [sys.executable, make_roots.__file__, "fast_dds-9.9"], capture_output=True, text=True
    )
    assert made.returncode == 2
    assert "fast_dds-9.9: not one of fast_dds-2.6.12, " in made.stderr


@pytest.fixture
def campaign(tmp_path: Path) -> Path:
    """Copy the locked files to a folder that no other test holds."""
    (tmp_path / "lab" / "measure").mkdir(parents=True)
    (tmp_path / "lab" / "measure" / "run_grid.py").write_bytes(Path(run_grid.__file__).read_bytes())
    (tmp_path / "conftest.py").write_bytes((ROOT / "conftest.py").read_bytes())
    (tmp_path / "test_one.py").write_text("def test_one():\n    pass\n")
    return tmp_path


def begun(folder: Path, *words: str) -> subprocess.CompletedProcess[str]:
    env = {name: told for name, told in os.environ.items() if name != run_grid.LOCK_VARIABLE}
    return subprocess.run(
        [sys.executable, *words], cwd=folder, env=env, capture_output=True, text=True, timeout=60
    )


def test_neither_tests_nor_another_campaign_run_beside_a_campaign(campaign: Path) -> None:
    fcntl = pytest.importorskip("fcntl")
    tests = ("-m", "pytest", "-q", "-p", "no:cacheprovider", "test_one.py")
    program = ("lab/measure/run_grid.py",)
    # Not set up there, which it says if nothing else is running.
    assert "The lab is not set up" in begun(campaign, *program).stderr
    assert begun(campaign, *tests).returncode == 0
    with (campaign / "build" / "lab.lock").open("a") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        refused = begun(campaign, *program)
        assert refused.returncode == 1
        assert "another campaign of the lab, or tests, are running here" in refused.stderr
        refused = begun(campaign, *tests)
        assert refused.returncode == 1
        assert "a campaign of the lab is running: run the tests" in refused.stdout + refused.stderr
        fcntl.flock(lock, fcntl.LOCK_SH)  # as tests
        assert "another campaign of the lab, or tests," in begun(campaign, *program).stderr
        assert begun(campaign, *tests).returncode == 0


def test_what_is_stored_belongs_together() -> None:
    """Once the campaign has been run: each run is of the grid, and each count of a run."""
    runs = lab.read_table_if_present(lab.LAB / "data" / "releases" / "runs.csv")
    counts = lab.read_table_if_present(lab.LAB / "data" / "releases" / "counts.csv")
    assert {row["run"] for row in counts} == {row["run"] for row in runs}
    assert set(Counter(map(lab.run_key, runs)).values()) <= {1}
    planned = {lab.run_key(job) for job in lab.list_runs(GRID, roots())}
    assert {lab.run_key(row) for row in runs} <= planned
    for row in runs:
        with_version = next(one for one in RELEASES if one["release"] == row["release"])
        if row["wire"].count(",") == 2:
            assert row["wire"].endswith(with_version["version"])


def test_the_short_campaign_takes_a_release_that_debian_has() -> None:
    with (run_grid.GRIDS / "releases_short.csv").open(newline="") as file:
        [row] = csv.DictReader(file)
    assert row["release"] == "fast_dds-2.9.1"
    assert float(row["seconds"]) < 10


def test_the_readme_says_what_of_the_campaign_is_stored() -> None:
    text = " ".join((lab.LAB / "data" / "README.md").read_text(encoding="utf-8").split())
    runs = lab.read_table_if_present(lab.LAB / "data" / "releases" / "runs.csv")
    planned = sum(int(row["runs"]) for row in GRID)
    stored = Counter(row["release"] for row in runs)
    assert f"Of the grid's {planned} runs {len(runs)} are stored" in text
    assert stored == Counter(row["release"] for row in GRID)
    marked = Counter(row["release"].split("-")[0] for row in runs if row["again"] == "1")
    assert marked == {"zenoh": stored["zenoh-1.10.2"], "fast_dds": 16}
    assert f"The runs of Zenoh and {marked['fast_dds']} of Fast DDS are marked" in text
    assert f"the {sum(row['server'] == 'server' for row in runs)} runs with a Discovery" in text
    assert {row["number"] for row in runs} == {"1"}
