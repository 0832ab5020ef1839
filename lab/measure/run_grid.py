"""Run the lab's grid: real middleware in network namespaces, captured (see README.md).

Each run is its own process tree, started by `unshare --kill-child`: when this program ends, for
whatever reason, the kernel ends the run. Existing runs are not repeated.
"""

import argparse
import csv
import gzip
import json
import os
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import IO, Any, NoReturn

LAB = Path(__file__).resolve().parents[1]
MEASURE, PROGRAMS, GRIDS = LAB / "measure", LAB / "programs", LAB / "grids"
BUILD = LAB.parent / "build" / "lab"
PYTHON = BUILD / "venv" / "bin" / "python"
#: Lock file: exclusive for a campaign, shared by tests. The variable says that tests hold it.
LOCK_FILE, LOCK_VARIABLE = BUILD.parent / "lab.lock", "DISCOSTORM_LAB_LOCK"
SPDP_ONLY = "<General><AllowMulticast>spdp</AllowMulticast></General>"

# Debian package or PyPI distribution whose version is the product's version.
PACKAGES = {
    "fast_dds": "libfastrtps-dev",
    "cyclone_dds_0.10": "cyclonedds-dev",
    "cyclone_dds_11": "cyclonedds",
    "zenoh": "eclipse_zenoh",
    "zenoh_peer": "eclipse_zenoh",
}
# Program and environment by product and variant. "default" is the shipped configuration.
FAST_DDS = [str(BUILD / "bin" / "fast_dds")]
CYCLONE_DDS = [str(BUILD / "bin" / "cyclone_dds")]
CYCLONE_DDS_11 = [str(PYTHON), str(PROGRAMS / "cyclone_dds.py")]
ZENOH = [str(PYTHON), str(PROGRAMS / "zenoh_peer.py")]
PRODUCTS: dict[tuple[str, str], tuple[list[str], dict[str, str]]] = {
    ("fast_dds", "default"): (FAST_DDS, {}),
    ("fast_dds", "udp"): (FAST_DDS, {}),
    ("cyclone_dds_0.10", "default"): (CYCLONE_DDS, {}),
    ("cyclone_dds_0.10", "spdp"): (CYCLONE_DDS, {"CYCLONEDDS_URI": SPDP_ONLY}),
    ("cyclone_dds_11", "default"): (CYCLONE_DDS_11, {}),
    ("cyclone_dds_11", "spdp"): (CYCLONE_DDS_11, {"CYCLONEDDS_URI": SPDP_ONLY}),
    ("zenoh_peer", "default"): (ZENOH, {}),
    ("zenoh_peer", "tokens"): (ZENOH, {}),
}
# Configurations: program, environment, and server programs by host (0: on every host). HOST stands
# for the host's number. Hosts 101 and 102 are outside the fleet, wired to the access point.
ZENOH_ROUTER = [str(PYTHON), str(PROGRAMS / "zenoh_router.py"), "HOST"]
# PEERS stands for all hosts. Without an index, 0.10 sends to fixed ports but does not listen there.
CYCLONE_PEERS = (
    "<General><AllowMulticast>false</AllowMulticast></General><Discovery>"
    "<ParticipantIndex>auto</ParticipantIndex><Peers>PEERS</Peers></Discovery>"
)
CYCLONE_MULTICAST = "<General><AllowMulticast>true</AllowMulticast></General>"
DISCOVERY_SERVER = "/usr/bin/fast-discovery-server"
CONFIGURATIONS: dict[
    tuple[str, str], tuple[list[str], dict[str, str], list[tuple[int, list[str]]]]
] = {
    ("fast_dds", "composed"): (FAST_DDS, {}, []),
    **{
        ("fast_dds", name): (
            FAST_DDS,
            {"ROS_DISCOVERY_SERVER": ";".join(f"10.77.0.{host}:11811" for host in hosts)},
            [
                (host, [DISCOVERY_SERVER, "-i", str(index), "-l", f"10.77.0.{host}", "-p", "11811"])
                for index, host in enumerate(hosts)
            ],
        )
        for name, hosts in {"server": [101], "server_robot": [1], "servers": [101, 102]}.items()
    },
    ("fast_dds", "static"): (FAST_DDS, {}, []),
    ("cyclone_dds_0.10", "multicast"): (CYCLONE_DDS, {"CYCLONEDDS_URI": CYCLONE_MULTICAST}, []),
    ("cyclone_dds_0.10", "peers"): (CYCLONE_DDS, {"CYCLONEDDS_URI": CYCLONE_PEERS}, []),
    ("zenoh_peer", "peers"): (ZENOH, {}, []),
    ("zenoh", "router"): (ZENOH, {}, [(101, ZENOH_ROUTER)]),
    ("zenoh", "router_per_host"): (ZENOH, {}, [(0, ZENOH_ROUTER)]),
    ("zenoh", "star"): (ZENOH, {}, [(101, ZENOH_ROUTER), (0, [*ZENOH_ROUTER, "star"])]),
}
# DDS Security: keystore.sh creates a governance file for each protection.
KEYSTORE = BUILD / "keystore"
SECURITY = {"secure": "ros2", "secure_discovery": "discovery"}
SECURED_PRODUCTS: dict[
    tuple[str, str], tuple[list[str], dict[str, str], list[tuple[int, list[str]]]]
] = {
    (product, variant): (command, {name: f"{scheme}{KEYSTORE}/{file}_{governance}.xml"}, [])
    for product, command, name, scheme, file in (
        ("fast_dds", FAST_DDS, "FASTRTPS_DEFAULT_PROFILES_FILE", "", "fast_dds"),
        ("cyclone_dds_0.10", CYCLONE_DDS, "CYCLONEDDS_URI", "file://", "cyclone_dds"),
    )
    for variant, governance in SECURITY.items()
}
#: Kill the run even if this program ended before setpriv requested the signal.
IN_NEW_NAMESPACES = [
    "setpriv",
    "--pdeathsig",
    "KILL",
    "sh",
    "-c",
    '[ "$PPID" = "$0" ] && exec "$@"',
]
IN_NEW_NAMESPACES += [
    str(os.getpid()),
    "unshare",
    "--fork",
    "--pid",
    "--kill-child",
    "--mount-proc",
    "--net",
]
IN_NEW_NAMESPACES += [sys.executable]
RUN_COMMAND = [*IN_NEW_NAMESPACES, str(MEASURE / "netns_run.py")]

SECONDS_BETWEEN_STARTS = 4.0  # s between the starts of runs, so that their storms do not overlap
MAX_PARALLEL_PROCESSES = 40  # maximum number of processes over all runs
MAX_ATTEMPTS = 3


def installed_version(product: str) -> str:
    package = PACKAGES[product]
    if package.endswith("-dev"):
        query = ["dpkg-query", "--show", "--showformat=${Version}", package]
        return subprocess.run(query, capture_output=True, text=True, check=True).stdout
    [found] = BUILD.glob(f"venv/lib/python*/site-packages/{package}-*.dist-info")
    return found.name.removeprefix(f"{package}-").removesuffix(".dist-info")


def runs_of_point(point: dict[str, str]) -> dict[tuple[str, str], Any]:
    """Return the runs of a point: every product as shipped, or the configuration that it names."""
    shipped: dict[tuple[str, str], Any] = {key: (*of, []) for key, of in PRODUCTS.items()}
    if "configuration" not in point:
        return shipped
    product, _, variant = point["configuration"].partition("-")
    return {(product, variant): (shipped | CONFIGURATIONS | SECURED_PRODUCTS)[product, variant]}


def list_runs(
    grid: Path,
    only: list[str],
    trace: bool,
    versions: dict[str, str],
) -> list[dict[str, Any]]:
    """Return all runs: run 1 of every point, then run 2."""
    with grid.open(newline="") as file:
        points = list(csv.DictReader(file))
    found = []
    for run in range(1, max(int(point["runs"]) for point in points) + 1):
        for point in points:
            if run > int(point["runs"]):
                continue
            for (product, variant), (command, env, servers) in runs_of_point(point).items():
                if only and f"{product}-{variant}" not in only:
                    continue
                hosts, processes, endpoints = (
                    int(point[name]) for name in ("hosts", "processes", "endpoints")
                )
                peers = "".join(f"<Peer Address='10.77.0.{host}'/>" for host in range(1, hosts + 1))
                if trace and product == "zenoh_peer":
                    env = env | {"RUST_LOG": "zenoh_transport=trace,zenoh=trace"}
                found.append(
                    {
                        "name": f"{product.replace('.', '')}-{variant}-h{hosts}p{processes}"
                        f"e{endpoints}-{point['names']}-r{run}",
                        "product": product,
                        "variant": variant,
                        "version": versions[product],
                        "kernel": os.uname().release,
                        "command": command,
                        "env": {key: told.replace("PEERS", peers) for key, told in env.items()},
                        "servers": [
                            (host, [word.replace("HOST", str(host)) for word in words])
                            for number, words in servers
                            for host in ([number] if number else range(1, hosts + 1))
                        ],
                        "mitigated": "configuration" in point,
                        "hosts": hosts,
                        "processes": processes,
                        "endpoints": endpoints,
                        "names": point["names"],
                        "use": point["use"],
                        "run": run,
                        "seconds": float(point["seconds"]),
                    }
                )
    return found


def compress_capture(out: Path) -> str:
    """Compress the capture of a successful run; return a line about it."""
    pcap, packed = out.with_suffix(".pcap"), out.with_suffix(".pcap.gz")
    size = pcap.stat().st_size
    with (
        pcap.open("rb") as raw,
        packed.open("wb") as file,
        gzip.GzipFile(filename="", mode="wb", fileobj=file, mtime=0) as zipped,
    ):
        shutil.copyfileobj(raw, zipped)
    pcap.unlink()
    job = json.loads(out.with_suffix(".json").read_text())
    return f"{size:>9,} bytes captured, {job['cpu_s']:5.2f} s of CPU"


def remove_files(out: Path) -> None:
    """Remove the files of a failed run."""
    for path in out.parent.glob(f"{out.name}.*"):
        path.unlink()


def count_processes(job: dict[str, Any]) -> int:
    """Return the number of processes of a run."""
    return int(job["hosts"] * job["processes"])


def run_in_parallel(
    todo: list[dict[str, Any]],
    folder: Path,
    crowd: int,
    spacing: float,
    stage_of: list[str] = RUN_COMMAND,
    finish: Callable[[Path], str] = compress_capture,
    weight: Callable[[dict[str, Any]], int] = count_processes,
) -> int:
    """Run all jobs, in parallel up to a total load; return the number of failures."""
    running: dict[subprocess.Popen[str], dict[str, Any]] = {}
    waiting, failed, done, total = list(todo), 0, 0, len(todo)
    begun, next_start = time.monotonic(), 0.0
    try:
        while waiting or running:
            for stage in [stage for stage in running if stage.poll() is not None]:
                job = running.pop(stage)
                _, error = stage.communicate()
                out = folder / job["name"]
                if stage.returncode == 0:
                    done += 1
                    news = finish(out)
                else:
                    remove_files(out)
                    news = f"tried again later: {error.strip()}"
                    if job["tries"] < MAX_ATTEMPTS:
                        waiting.append(job)
                    else:
                        done, failed = done + 1, failed + 1
                        news = f"FAILED {MAX_ATTEMPTS} times: {error.strip()}"
                left = (time.monotonic() - begun) / max(done, 1) * (total - done) / 60
                print(f"[{done}/{total}] {job['name']}: {news}; {left:.0f} min left", flush=True)
            here = sum(map(weight, running.values()))
            if waiting and time.monotonic() >= next_start:
                job = waiting[0]
                if not running or here + weight(job) <= crowd:
                    waiting.pop(0)
                    job["tries"] = job.get("tries", 0) + 1
                    arguments = json.dumps(job | {"out": str(folder / job["name"])})
                    stage = subprocess.Popen(
                        [*stage_of, arguments],
                        stderr=subprocess.PIPE,
                        text=True,
                        start_new_session=True,
                    )
                    running[stage] = job
                    next_start = time.monotonic() + spacing
            time.sleep(0.1)
    finally:
        for stage in running:  # the end of this process ends the whole run
            stage.kill()
            stage.wait()
        for job in running.values():
            remove_files(folder / job["name"])
    return failed


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--grid", type=Path, default=GRIDS / "grid.csv", help="table of points")
    parser.add_argument("--runs", type=int, default=5, help="runs a point")
    parser.add_argument(
        "--seconds", type=float, default=36.0, help="from the start to the end of a run"
    )
    parser.add_argument("--only", action="append", default=[], metavar="PRODUCT-VARIANT")
    parser.add_argument(
        "--out", type=Path, default=BUILD / "captures", help="folder for the captures"
    )
    parser.add_argument("--trace", action="store_true", help="keep Zenoh's trace logs")
    parser.add_argument(
        "--crowd", type=int, default=MAX_PARALLEL_PROCESSES, help="processes at a time"
    )
    parser.add_argument(
        "--spacing", type=float, default=SECONDS_BETWEEN_STARTS, help="s between two starts"
    )
    parser.add_argument(
        "--busy", action="store_true", help="keep runs of a busy machine, to try the programs"
    )
    given = parser.parse_args()
    known = {
        f"{product}-{variant}" for product, variant in PRODUCTS | CONFIGURATIONS | SECURED_PRODUCTS
    }
    if unknown := set(given.only) - known:
        parser.error(f"--only {', '.join(sorted(unknown))}: not one of {', '.join(sorted(known))}")
    if not (BUILD / ".ready").exists():
        print("The lab is not set up: run it by make lab", file=sys.stderr)
        return 1
    given.out.mkdir(parents=True, exist_ok=True)
    versions = {product: installed_version(product) for product in PACKAGES}
    todo = list_runs(given.grid, given.only, given.trace, versions)
    if given.busy:
        todo = [job | {"idle_needed": 0.0, "late": 5.0} for job in todo]
    there = [job for job in todo if (given.out / job["name"]).with_suffix(".pcap.gz").exists()]
    if there:
        print(f"{len(there)} of {len(todo)} runs are in {given.out} already", flush=True)
    return (
        1
        if run_in_parallel(
            [job for job in todo if job not in there], given.out, given.crowd, given.spacing
        )
        else 0
    )


def lock_machine() -> IO[str] | None:
    """Lock the machine for this campaign; return None if a campaign or tests hold the lock.

    Child programs of a campaign or of tests (see the root's conftest.py) inherit the lock.
    """
    import fcntl  # local import: Windows has no fcntl, but reads tables

    LOCK_FILE.parent.mkdir(parents=True, exist_ok=True)
    lock = LOCK_FILE.open("a")
    if LOCK_VARIABLE not in os.environ:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            return None
        os.environ[LOCK_VARIABLE] = "campaign"
    return lock


def run_lab_program(main: Callable[[], int]) -> NoReturn:
    """Run a program of the lab; Ctrl-C and SIGTERM also end its child processes."""
    signal.signal(signal.SIGINT, signal.default_int_handler)  # also in the background
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))
    if (lock := lock_machine()) is None:
        print(
            "discostorm: another campaign of the lab, or tests, are running here: "
            "run this again when they have ended",
            file=sys.stderr,
        )
        sys.exit(1)
    try:
        with lock:
            sys.exit(main())
    except KeyboardInterrupt:
        sys.exit(130)


if __name__ == "__main__":
    run_lab_program(main)
