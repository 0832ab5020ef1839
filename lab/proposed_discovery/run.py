"""Run the hybrid discovery in the lab: speakers in network namespaces, captured (see README.md).

Each run has its own namespaces, as in run_grid.py. The book's `data/measured/hybrid.csv` lists each
run with the captured messages of each kind.
"""

import argparse
import contextlib
import csv
import ctypes
import json
import os
import shlex
import shutil
import signal
import socket
import struct
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent), str(HERE.parent / "measure")]

import netns_run  # noqa: E402
from netns_run import begin_capture, build_bridge, build_host, end_capture, run_command  # noqa: E402
from run_grid import BUILD, IN_NEW_NAMESPACES, run_in_parallel, run_lab_program  # noqa: E402

from proposed_discovery import wire  # noqa: E402
from proposed_discovery.speaker import parameters  # noqa: E402
from proposed_discovery.wire import PORT  # noqa: E402

STAGE = [*IN_NEW_NAMESPACES, str(HERE / "run.py"), "--play"]
MAX_HOSTS = 64  # maximum number of hosts in a cell
START_DELAY = 3.0  # s from readiness of the last speaker to the start
MAX_TIMER_DELAY = 0.1  # s; a speaker whose timer is later spoils the run
CLONE_NEWNET = 0x40000000
PACKAGES = "ethtool iproute2 nftables procps tcpdump util-linux"
#: Loss rates of the simulator's stored runs: of multicasts per host, and of all hops.
LOSS_RATES = (0.2, 0.01)
WINDOWS = {"startup": (0.0, 12.0), "steady": (12.0, 36.0)}
SETTLED_AFTER = 8.0  # s after the start, when hosts of a settled fleet fail or another host starts
GRID_COLUMNS = ("hosts", "processes", "endpoints", "software", "scenario", "runs", "seconds")
COLUMNS = (
    *GRID_COLUMNS[:5],
    *("run", "seconds", "losses", "late_s", "converged_s", "gone_s", "mistaken", "kernel"),
    *("window", "kind", "frames", "bytes"),
)
#: Scenarios: loss rates; hosts that fail, with time and manner; a host that starts later.
SCENARIOS: dict[str, dict[str, Any]] = {
    "no losses": {},
    "losses": {"loss": LOSS_RATES},
    "newcomer": {"loss": LOSS_RATES, "late": 1},
    "half killed at 0.25 s": {"loss": LOSS_RATES, "at": 0.25, "how": "kill"},
    "half killed when settled": {"loss": LOSS_RATES, "at": SETTLED_AFTER, "how": "kill"},
    "half unlinked when settled": {
        "loss": LOSS_RATES,
        "at": SETTLED_AFTER,
        "how": "link",
        "back": 36.0,
    },
}


# ---------------------------------------------------------------- a run, in its own namespaces


def add_losses(holder: int, multicast: float, hops: float) -> None:
    """Drop random multicasts to a host, and random frames on its hops."""
    drop = "numgen random mod 1000 < {:.0f} drop".format
    rules = f"""table netdev lossy {{
        chain arriving {{
            type filter hook ingress device eth0 priority 0;
            ip daddr 224.0.0.0/4 udp dport {PORT} {drop(1000 * multicast)}
            ip daddr 10.77.0.0/24 udp dport {PORT} {drop(1000 * hops)}
        }}
        chain leaving {{
            type filter hook egress device eth0 priority 0;
            udp dport {PORT} {drop(1000 * hops)}
        }}
    }}"""
    command = shlex.split(f"nsenter --target={holder} --net nft -f -")
    done = subprocess.run(command, input=rules, capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(f"nft: {done.stderr.strip()}")


def fork_speaker(host: int, holder: int, job: dict[str, Any], log: Path, zero: float) -> int:
    """Fork a speaker into a host's network namespace; return its process id."""
    pid = os.fork()
    if pid:
        return pid
    code = 1
    try:
        signal.signal(signal.SIGINT, signal.SIG_DFL)
        # Late timers on a busy machine would change the measurement, so request real-time priority.
        with contextlib.suppress(OSError):
            os.sched_setscheduler(0, os.SCHED_RR, os.sched_param(1))
        libc = ctypes.CDLL(None, use_errno=True)
        with Path(f"/proc/{holder}/ns/net").open() as namespace:
            if libc.setns(namespace.fileno(), CLONE_NEWNET):
                raise OSError(ctypes.get_errno(), "setns")
        out = os.open(log, os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
        speaker = wire.Speaker(host, job, out)
        wait = zero + job["starts"][host] - time.monotonic()
        if wait < 0:
            raise SystemExit(f"host {host} is {-wait:.2f} s late: machine too busy")
        time.sleep(wait)
        speaker.run(zero, job["seconds"])
        code = 0
    except BaseException as error:  # the fork must not return to its parent's code
        log.with_suffix(".error").write_text(f"{type(error).__name__}: {error}")
        if not isinstance(error, SystemExit):
            import traceback

            traceback.print_exc()
    finally:
        os._exit(code)


def play_run(job: dict[str, Any]) -> None:
    """Play one run, as the first process of its namespaces."""
    out, hosts = Path(job["out"]), job["hosts"]
    build_bridge()
    holders = [build_host(number) for number in range(1, hosts + 1)]
    if "loss" in job:
        for holder in holders:
            add_losses(holder, *job["loss"])
    dump = begin_capture(out, 8192)
    zero, wall = time.monotonic() + START_DELAY, time.time() + START_DELAY
    job["starts"] = [0.0] * hosts + [-1.0] * (MAX_HOSTS - hosts)
    for host in range(hosts - job.get("late", 0), hosts):
        job["starts"][host] = SETTLED_AFTER
    logs = [out.with_suffix(f".{host}.log") for host in range(hosts)]
    speakers = [fork_speaker(host, holders[host], job, logs[host], zero) for host in range(hosts)]
    half = hosts // 2
    if "at" in job:
        time.sleep(max(0.0, zero + job["at"] - time.monotonic()))
        for host in range(half):
            if job["how"] == "kill":
                os.kill(speakers[host], signal.SIGKILL)
            else:
                run_command(f"ip link set port{host + 1} down")
    if "back" in job:
        time.sleep(max(0.0, zero + job["back"] - time.monotonic()))
        for host in range(half):
            run_command(f"ip link set port{host + 1} up")
    killed = set(range(half)) if job.get("how") == "kill" else set()
    for host, pid in enumerate(speakers):
        status = os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1])
        if status != (-signal.SIGKILL if host in killed else 0):
            error = logs[host].with_suffix(".error")
            reason = error.read_text() if error.exists() else f"ended with {status}"
            raise SystemExit(f"host {host}: {reason}")
    time.sleep(netns_run.CAPTURE_TAIL)
    end_capture(out, dump)
    lines = [log.read_text().splitlines() for log in logs]
    if max_timer_delay(lines) > MAX_TIMER_DELAY:
        raise SystemExit(f"a clock rang {max_timer_delay(lines):.3f} s late: machine too busy")
    out.with_suffix(".json").write_text(json.dumps(job | {"wall": wall, "told": lines}) + "\n")
    for path in logs:
        path.unlink()


# ---------------------------------------------------------------- evaluation of a run


def datagrams(capture: Path) -> Iterator[tuple[float, bytes]]:
    """Yield time and payload of each datagram of the hybrid discovery in a capture."""
    raw = capture.read_bytes()
    magic, *_, link = struct.unpack_from("<IHHiIII", raw)
    if magic != 0xA1B2C3D4 or link != 1:
        raise SystemExit(f"{capture}: not a capture of Ethernet by tcpdump")
    at = 24
    while at < len(raw):
        seconds, micros, length, _ = struct.unpack_from("<IIII", raw, at)
        frame = raw[at + 16 : at + 16 + length]
        at += 16 + length
        if frame[12:14] == b"\x08\x00" and frame[14] == 0x45 and frame[23] == socket.IPPROTO_UDP:
            port, size = struct.unpack_from("!HH", frame, 36)
            if port == PORT:
                yield seconds + micros / 1e6, frame[42 : 34 + size]


def held_sets_over_time(logs: list[list[str]]) -> list[tuple[float, int, set[int]]]:
    """Return each change of a host's held sets: time, host, held hosts, in order of time."""
    found = []
    for host, lines in enumerate(logs):
        for line in lines:
            what, when, *more = line.split()
            if what == "holds":
                hosts = more[0].removeprefix("hosts=").split(",")
                found.append((float(when), host, {int(one) for one in hosts}))
    return sorted(found, key=lambda row: row[:2])


def max_timer_delay(logs: list[list[str]]) -> float:
    """Return the maximum delay of a speaker's timers [s]."""
    ends = (line for lines in logs for line in lines if line.startswith("end "))
    return max(float(line.rpartition("late=")[2]) for line in ends)


def evaluate_run(job: dict[str, Any]) -> dict[str, Any]:
    """Return convergence time, time until failed hosts are dropped, and false drops."""
    hosts, half = job["hosts"], job["hosts"] // 2
    ends, later = job.get("how"), SETTLED_AFTER if "late" in job else 0.0
    ended = set(range(half)) if ends else set()
    living = set(range(hosts)) - (ended if ends == "kill" else set())
    held: dict[int, set[int]] = {host: set() for host in range(hosts)}
    converged, gone, mistaken = None, None, 0
    for when, host, now in held_sets_over_time(job["told"]):
        # A host without a link is alone: it rightly drops the other hosts, and they drop it.
        alone = ended if ends == "link" and job["at"] <= when < job["back"] else set()
        mistaken += len((held[host] - now) & (living - alone)) if host not in alone else 0
        held[host] = now
        complete = all(living <= held[one] for one in living)
        converged = (when if converged is None else converged) if complete else None
        if ended and when > job["at"]:
            left = set(range(hosts)) - ended
            without = not any(held[one] & ended for one in left)
            gone = (when if gone is None else gone) if without or gone is not None else None
    begin = job.get("back", later)
    patient = bool(ended) and job["seconds"] > job["at"] + parameters()["lease"]
    return {
        "late_s": f"{max_timer_delay(job['told']):.4f}",
        "converged_s": "inf" if converged is None else f"{max(0.0, converged - begin):.4f}",
        "gone_s": f"{gone - job['at']:.3f}" if gone else "inf" if patient else "",
        "mistaken": mistaken,
    }


def rows_of_run(out: Path) -> list[dict[str, Any]]:
    """Return a row for each window and message kind of a run."""
    job = json.loads(out.with_suffix(".json").read_text())
    ends = job["seconds"]
    windows = {name: window for name, window in WINDOWS.items() if window[1] <= ends}
    if job["scenario"] != "no losses" or not windows:
        windows = {"run": (0.0, ends)}
    count: Counter[tuple[str, str]] = Counter()
    size: Counter[tuple[str, str]] = Counter()
    for when, payload in datagrams(out.with_suffix(".pcap")):
        kind = wire.KINDS[wire.HEADER.unpack_from(payload)[0] & 0x0F]
        for window, (begins, until) in windows.items():
            if begins <= when - job["wall"] < until:
                count[window, kind] += 1
                size[window, kind] += len(payload)
    head = {name: job[name] for name in (*GRID_COLUMNS[:5], "run")} | evaluate_run(job)
    head |= {"seconds": f"{job['seconds']:g}", "kernel": os.uname().release.partition("-")[0]}
    head["losses"] = "/".join(f"{part:g}" for part in job.get("loss", (0, 0)))
    return [
        head
        | {
            "window": window,
            "kind": kind,
            "frames": count[window, kind],
            "bytes": size[window, kind],
        }
        for window in windows
        for kind in wire.KINDS
    ]


# ---------------------------------------------------------------- all runs


def list_runs(grid: Path) -> list[dict[str, Any]]:
    """Return all runs of a grid: first run 1 of every point, then run 2."""
    with grid.open(newline="") as file:
        points = list(csv.DictReader(file))
    found = []
    for turn in range(1, max(int(point["runs"]) for point in points) + 1):
        for number, point in enumerate(points):
            if turn > int(point["runs"]):
                continue
            hosts, processes, endpoints = (int(point[name]) for name in GRID_COLUMNS[:3])
            scenario, software = point["scenario"], point["software"]
            name = f"hybrid-{software}-h{hosts}p{processes}e{endpoints}-{scenario}-r{turn}"
            found.append(
                {
                    "name": name.replace(" ", "_").replace(".", ""),
                    "hosts": hosts,
                    "processes": processes,
                    "endpoints": endpoints,
                    "software": software,
                    "alike": software == "alike",
                    "scenario": scenario,
                    "run": turn,
                    "seconds": float(point["seconds"]),
                    "seed": 1000 * number + turn,
                    "capacity": MAX_HOSTS,
                }
                | SCENARIOS[scenario]
            )
    return found


def write_table(path: Path, folder: Path, done: list[dict[str, Any]]) -> None:
    """Write the table of all runs."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.open("w", newline="", encoding="utf-8") as file:
        table = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        table.writeheader()
        for job in done:
            table.writerows(rows_of_run(folder / job["name"]))


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--grid", type=Path, default=HERE / "grid.csv", help="table of points")
    parser.add_argument("--captures", type=Path, default=BUILD / "hybrid")
    parser.add_argument("--out", type=Path, help="table to write")
    parser.add_argument("--side-by-side", type=int, default=2, help="runs at a time")
    parser.add_argument("--play", help=argparse.SUPPRESS)
    given = parser.parse_args()
    if given.play:
        play_run(json.loads(given.play))
        return 0
    todo = list_runs(given.grid)
    needed = ["ethtool", "ip", "nsenter", "setpriv", "sysctl", "tcpdump", "unshare"]
    needed += ["nft"] if any("loss" in job for job in todo) else []
    if missing := [name for name in needed if not shutil.which(name)]:
        print(f"discostorm: the lab is missing: {' '.join(missing)}", file=sys.stderr)
        print(f"On Debian: apt-get install {PACKAGES}", file=sys.stderr)
        return 1
    if os.geteuid():
        print("discostorm: the lab makes network namespaces: run it as root", file=sys.stderr)
        return 1
    given.captures.mkdir(parents=True, exist_ok=True)
    there = [job for job in todo if (given.captures / job["name"]).with_suffix(".json").exists()]
    if there:
        print(f"{len(there)} of {len(todo)} runs are in {given.captures} already", flush=True)
    failed = run_in_parallel(
        [job for job in todo if job not in there],
        given.captures,
        given.side_by_side,
        0.0,
        STAGE,
        lambda _: "captured",
        lambda _: 1,
    )
    if not failed and given.out:
        write_table(
            given.out,
            given.captures,
            sorted(todo, key=lambda job: (job["seed"] // 1000, job["run"])),
        )
        print(f"{len(todo)} runs: {given.out}")
    return 1 if failed else 0


if __name__ == "__main__":
    run_lab_program(main)
