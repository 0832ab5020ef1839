"""Test the lab's programs: grid, requirements, and clean-up."""

import csv
import gzip
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time
import uuid
from collections import Counter
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest
from support import ROOT, skip_or_fail

LAB = ROOT / "lab"

import run_grid as lab  # noqa: E402

pytestmark = pytest.mark.book


def points(use: str) -> list[tuple[int, int, int, str]]:
    with (lab.GRIDS / "grid.csv").open(newline="") as file:
        return [
            (int(row["hosts"]), int(row["processes"]), int(row["endpoints"]), row["names"])
            for row in csv.DictReader(file)
            if use in ("all", row["use"])
        ]


def test_the_grid_has_what_was_asked_for_and_no_point_twice() -> None:
    every = points("all")
    assert len(every) == len(set(every)) >= 12
    assert {names for *_, names in every} == {"matching", "unique"}
    assert not set(points("fit")) & set(points("test"))
    assert all(endpoints % 2 == 0 for _, _, endpoints, _ in every)  # half of them write


@pytest.mark.parametrize("use", ["fit", "test"])
def test_each_half_of_the_grid_can_tell_the_units_apart(use: str) -> None:
    """Processes, ordered pairs, endpoints and remote processes, and matched endpoints."""
    rows = []
    for hosts, processes, endpoints, names in points(use):
        everyone, pairs = hosts * processes, hosts * (hosts - 1) * processes**2
        matched = pairs * endpoints if names == "matching" else 0
        rows.append([everyone, pairs, pairs * endpoints, matched, everyone * pairs])
    scaled = np.array(rows) / np.max(rows, axis=0)
    assert np.linalg.cond(scaled) < 100


def test_names_of_runs_are_unique_and_files_can_be_made_of_them() -> None:
    versions = dict.fromkeys(lab.PACKAGES, "1")
    names = [job["name"] for job in lab.list_runs(lab.GRIDS / "grid.csv", [], False, versions)]
    with (lab.GRIDS / "grid.csv").open(newline="") as file:
        runs = sum(int(row["runs"]) for row in csv.DictReader(file))
    assert len(names) == len(set(names)) == runs * len(lab.PRODUCTS)
    assert all(re.fullmatch(r"[a-z0-9_-]+", name) for name in names)  # with_suffix needs no dot


def test_every_configuration_has_six_points_and_three_runs_of_each() -> None:
    versions = dict.fromkeys(lab.PACKAGES, "1")
    jobs = lab.list_runs(lab.GRIDS / "mitigations.csv", [], False, versions)
    names = [job["name"] for job in jobs]
    assert len(names) == len(set(names))
    assert {(job["product"], job["variant"]) for job in jobs} == set(lab.CONFIGURATIONS)
    for key in lab.CONFIGURATIONS:
        mine = [job for job in jobs if (job["product"], job["variant"]) == key]
        runs = Counter(job["name"].rpartition("-")[0] for job in mine)
        # Of static peers no table is fitted: all points are held against that of other peers.
        assert len(runs) >= (5 if key == ("zenoh_peer", "peers") else 6)
        assert min(runs.values()) >= 3


def test_the_lock_of_the_lab_has_a_hash_for_each_version() -> None:
    lock = (LAB / "requirements.lock").read_text(encoding="utf-8")
    pins = re.findall(r"^([\w-]+)==\S+.*\\\n(?:    --hash=sha256:[0-9a-f]{64}.*\n?)+", lock, re.M)
    assert len(pins) == len(re.findall(r"^\S", lock, re.M))
    assert {"cyclonedds", "eclipse-zenoh"} <= set(pins)


def check(tmp_path: Path, *programs: str) -> subprocess.CompletedProcess[str]:
    """Run check.sh where only these programs are."""
    for program in programs:
        (tmp_path / program).write_text("#!/bin/sh\nexec echo 1000\n")
        (tmp_path / program).chmod(0o755)
    return subprocess.run(
        ["/bin/sh", "lab/check.sh"],
        cwd=ROOT,
        env={"PATH": str(tmp_path)},
        capture_output=True,
        text=True,
        check=False,
    )


def test_what_is_missing_is_said_with_the_packages_to_install(tmp_path: Path) -> None:
    made = check(tmp_path, "ip", "unshare")
    assert made.returncode == 1
    assert re.search(r"missing:.* tcpdump", made.stderr)
    assert " ip " not in made.stderr.splitlines()[0]
    assert re.search(r"apt-get install .*tcpdump", made.stderr)


def unready() -> str:
    """Return why the lab cannot run here, or nothing."""
    if os.geteuid() != 0:
        return "the lab needs root"
    if subprocess.run(
        ["sh", "lab/check.sh"], cwd=ROOT, capture_output=True, check=False
    ).returncode:
        return "the lab's programs are not installed: see lab/check.sh"
    if not (lab.BUILD / ".ready").exists():
        return "the lab is not set up: run make lab GRID=short"
    return ""


def ready() -> None:
    """Skip where the lab cannot run."""
    if why := unready():
        skip_or_fail(why)


def marked_processes(mark: str) -> list[int]:
    """Return the processes, in whatever namespaces, that inherited the mark."""
    found = []
    for folder in Path("/proc").glob("[0-9]*"):
        try:
            if mark.encode() in (folder / "environ").read_bytes():
                found.append(int(folder.name))
        except OSError:  # it has just ended
            continue
    return found


def wait_until(true: object, seconds: float = 120.0) -> bool:
    assert callable(true)
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        if true():
            return True
        time.sleep(0.05)
    return False


def start_program(program: str, mark: str, *arguments: object) -> subprocess.Popen[str]:
    """Start a program of the lab; what it begins inherits the mark."""
    return subprocess.Popen(
        [sys.executable, str(LAB / program), *map(str, arguments)],
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        env=os.environ | {"DISCOSTORM_MARK": mark},
    )


def begin(out: Path, mark: str, seconds: int, *only: str) -> subprocess.Popen[str]:
    """Run the lab on one point of two hosts, for all products or some."""
    grid = out.with_suffix(".csv")
    heading = "hosts,processes,endpoints,names,use,runs,seconds"
    grid.write_text(f"{heading}\n2,1,4,matching,test,1,{seconds}\n")
    some = [f"--only={name}" for name in only]
    return start_program(
        *("measure/run_grid.py", mark, "--grid", grid, "--out", out, "--spacing", 0.2, "--busy"),
        *some,
    )


@pytest.mark.parametrize("how", [signal.SIGINT, signal.SIGTERM, signal.SIGKILL])
def test_nothing_is_left_after_an_end_before_time(tmp_path: Path, how: signal.Signals) -> None:
    """Ctrl-C, kill, and even kill -9, in the middle of captures."""
    ready()
    mark = uuid.uuid4().hex
    made = begin(out := tmp_path / "out", mark, 60)
    # Two stages at least, each with tcpdump and programs of two hosts.
    assert wait_until(
        lambda: len(list(out.glob("*.pcap"))) > 1 and len(marked_processes(mark)) > 14
    )
    made.send_signal(how)
    made.communicate(timeout=120)
    assert wait_until(lambda: not marked_processes(mark)), "processes of the lab are still there"
    if how != signal.SIGKILL:
        assert made.returncode == 128 + how
        assert not list(out.iterdir()), "half a capture was left"


def test_a_program_that_fails_ends_its_run_and_says_why(tmp_path: Path) -> None:
    ready()
    broken = tmp_path / "broken"
    broken.write_text("#!/bin/sh\necho 'no such domain' >&2\nexit 3\n")
    broken.chmod(0o755)
    mark = uuid.uuid4().hex
    job = {"command": [str(broken)], "hosts": 2, "processes": 1, "endpoints": 2, "names": "unique"}
    job |= {"variant": "default", "seconds": 5.0, "env": {}, "out": str(tmp_path / "out")}
    job |= {"servers": [], "idle_needed": 0.0}
    made = subprocess.run(
        [*lab.RUN_COMMAND, json.dumps(job)],
        capture_output=True,
        text=True,
        check=False,
        env=os.environ | {"DISCOSTORM_MARK": mark},
        timeout=60,
    )
    assert made.returncode == 1
    assert "ended with 3: no such domain" in made.stderr
    assert wait_until(lambda: not marked_processes(mark))


@dataclass(frozen=True)
class Done:
    """Results of programs of the lab that ran in parallel."""

    folder: Path
    ended: dict[str, tuple[int, str]]  # exit code and what it said, by program
    left: list[int]  # processes
    links: tuple[str, str]  # before and after


@pytest.fixture(scope="module")
def done(tmp_path_factory: pytest.TempPathFactory) -> Done:
    """Run the proposal's speakers, a short lab of all products, and a longer one of one product.

    The latter two only where the lab is set up, which the speakers do not need.
    """
    folder, mark, before = tmp_path_factory.mktemp("lab"), uuid.uuid4().hex, links()
    made = {"hybrid": hybrid(folder, mark, 12)}
    if not unready():
        made["short"] = begin(folder / "short", mark, 4)
        made["long"] = begin(folder / "long", mark, 14, "fast_dds-default")
    said = {name: program.communicate(timeout=300)[0] for name, program in made.items()}
    ended = {name: (program.returncode, said[name]) for name, program in made.items()}
    return Done(folder, ended, marked_processes(mark), (before, links()))


def links() -> str:
    return subprocess.run(["ip", "link"], capture_output=True, text=True, check=True).stdout


def test_nothing_is_left_after_the_lab(done: Done) -> None:
    assert not done.left
    before, after = done.links
    assert after == before


def test_a_short_lab_captures_every_product(done: Done) -> None:
    """For real: two hosts, and each product's processes find each other."""
    ready()
    code, said = done.ended["short"]
    assert code == 0, said
    for product, variant in lab.PRODUCTS:
        [capture] = (done.folder / "short").glob(f"{product.replace('.', '')}-{variant}-*.pcap.gz")
        told = json.loads(capture.with_suffix("").with_suffix(".json").read_text())
        assert told["version"]
        assert len(told["times"]) == 2
        hosts = talk(capture)
        assert hosts >= {("10.77.0.1", "10.77.0.2"), ("10.77.0.2", "10.77.0.1")}, capture
        assert {who for who, _ in hosts} == {"10.77.0.1", "10.77.0.2"}


def test_captures_are_counted_in_windows(done: Done, tmp_path: Path) -> None:
    """Of a run of 14 s the start-up is counted, and of the steady window nothing."""
    ready()
    code, said = done.ended["long"]
    assert code == 0, said
    command = [sys.executable, str(lab.MEASURE / "count_messages.py"), str(done.folder / "long")]
    command += ["--out", str(tmp_path / "tables")]
    subprocess.run(command, check=True, capture_output=True)
    with (tmp_path / "tables" / "runs.csv").open(newline="") as file:
        [run] = csv.DictReader(file)
    assert (run["product"], run["hosts"], run["command"].split()[:2]) == (
        "fast_dds",
        "2",
        ["fast_dds", "14"],
    )
    with (tmp_path / "tables" / "counts.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert {row["window"] for row in rows} == {"startup"}
    announced = [row for row in rows if row["kind"] == "SPDP" and row["multicast"] == "1"]
    # At once, five times 0.1 s apart, at 3.5, 6.5, 9.5 s, and for the other: 10 for each of two.
    assert [row["messages"] for row in announced] == ["20"]


def talk(capture: Path) -> set[tuple[str, str]]:
    """Return who sends IP packets to whom, as tcpdump reads them."""
    tcpdump = shutil.which("tcpdump")
    assert tcpdump
    plain = capture.with_suffix("")
    with gzip.open(capture) as packed:
        plain.write_bytes(packed.read())
    read = subprocess.run(
        [tcpdump, "-n", "-t", "-r", plain, "udp or tcp"], capture_output=True, text=True, check=True
    )
    pattern = re.compile(r"^IP (\d+\.\d+\.\d+\.\d+)\S* > (\d+\.\d+\.\d+\.\d+)", re.M)
    return set(pattern.findall(read.stdout))


def hybrid(tmp_path: Path, mark: str, seconds: int) -> subprocess.Popen[str]:
    """Run three speakers of the hybrid discovery: no vendor's software is in it."""
    tools = ("ethtool", "ip", "nsenter", "setpriv", "sysctl", "tcpdump", "unshare")
    if os.geteuid() != 0 or not all(map(shutil.which, tools)):
        skip_or_fail("the lab needs root and what lab/check.sh says")
    heading = "hosts,processes,endpoints,software,scenario,runs,seconds"
    grid = tmp_path / "grid.csv"
    grid.write_text(f"{heading}\n3,2,10,unlike,no losses,1,{seconds}\n")
    where = ("--captures", tmp_path / "out", "--out", tmp_path / "hybrid.csv")
    return start_program("proposed_discovery/run.py", mark, "--grid", grid, *where)


def test_speakers_of_the_hybrid_discovery_find_each_other(done: Done) -> None:
    code, said = done.ended["hybrid"]
    assert code == 0, said
    with (done.folder / "hybrid.csv").open(newline="") as file:
        rows = {row["kind"]: row for row in csv.DictReader(file)}
    assert int(rows["Announce"]["frames"]) == 3
    assert int(rows["Heartbeat"]["frames"]) >= 9
    assert float(rows["Announce"]["converged_s"]) < 1


def test_no_speaker_is_left_after_a_kill(tmp_path: Path) -> None:
    mark = uuid.uuid4().hex
    made = hybrid(tmp_path, mark, 60)
    # Three holders of namespaces, three speakers, tcpdump, the stage.
    assert wait_until(lambda: len(marked_processes(mark)) > 7)
    made.kill()
    made.communicate(timeout=120)
    assert wait_until(lambda: not marked_processes(mark)), "speakers are still there"
