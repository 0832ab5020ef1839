"""Measure startups of real middleware on an emulated Wi-Fi cell, one run at a time (see README.md).

    measure_air.py [--grid GRID] [--out FOLDER] [--only RELEASE] [--minutes MINUTES] [--once]

Each run is stored as soon as it ends in `runs.csv` of FOLDER, `lab/data/air`. Each row says whether
the run can be trusted. Stored runs are not repeated, except untrusted ones.
"""

import argparse
import gzip
import hashlib
import json
import math
import os
import sys
import time
from collections import Counter
from pathlib import Path
from typing import Any

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent / "measure"), str(HERE.parent / "releases")]

from build_bench import (  # noqa: E402
    BENCH,
    SLOW_EDP_ANSWERS,
    MissingError,
    build_cell,
    build_program,
    build_slow_edp_answers,
    refuse_unsuitable_machine,
    root_description,
)
from make_roots import releases  # noqa: E402
from run_grid import GRIDS, IN_NEW_NAMESPACES, LAB, SPDP_ONLY, run_in_parallel, run_lab_program  # noqa: E402
from run_releases import read_table_if_present, write_atomically  # noqa: E402

import discostorm as ds  # noqa: E402

STAGE = [*IN_NEW_NAMESPACES, str(HERE / "run_cell.py")]
CAPTURES = BENCH / "captures"
#: Columns of a point in the grid, which with the number of the run identify a run.
POINT_COLUMNS = (
    *("release", "edp_answers", "hosts", "processes", "endpoints"),
    *("standard", "ampdu", "queue_frames", "sender", "server", "start"),
)
KEY_COLUMNS = (*POINT_COLUMNS, "number")
LOSSES = ("host_full", "host_age", "host_retry", "ap_full", "ap_age", "ap_retry", "on_air")
#: Message kinds with separate columns.
MESSAGE_KINDS = ("SPDP", "SEDP", "Heartbeat", "ACKNACK")
RUN_COLUMNS = (
    *KEY_COLUMNS,
    *("factor", "seconds", "trusted", "why_not", "known", "t50_s", "t95_s", "t100_s", "ran_s"),
    *("unicast", "multicast", "expected", "arrived", *LOSSES, "waiting", *MESSAGE_KINDS, "other"),
    *("ppdus", "mpdus", "retries", "collisions", "busy_s", "up_s", "down_s", "multicast_s"),
    *("lag_95_s", "lag_max_s", "late_s", "made_s", "tap_dropped", "socket_dropped"),
    *("participants_dropped", "wall_s", "kernel", "command", "sha256"),
)
MAX_ATTEMPTS = 2
#: Limits of a trusted run, in seconds of the slow clock or packets.
TRUST_LIMITS = {
    "lag_95_s": (0.005, "ns-3 was late by {:.4f} s"),
    "late_s": (0.1, "a process began {:.2f} s late"),
    "made_s": (0.1, "a process took {:.2f} s to make its endpoints"),
    "tap_dropped": (0, "TAPs dropped {:.0f} packets"),
    "socket_dropped": (0, "sockets dropped {:.0f} packets"),
    # Pairs from before a reboot count among the learned, but not among the pairs.
    "known": (1, "the robots did not know each other before the reboot"),
}


def reasons_for_distrust(result: dict[str, Any]) -> list[str]:
    """Return the reasons why a run is not trusted; none for a trusted run."""
    return [
        text.format(float(result[name]))
        for name, (limit, text) in TRUST_LIMITS.items()
        if float(result[name]) > limit
    ]


def time_until_share_known(learned: list[float], pairs: int, share: float) -> float | str:
    """Return when a share of all pairs of process and endpoint was known [s]; empty if never."""
    number = -(-pairs * share // 1)
    return round(learned[int(number) - 1], 4) if len(learned) >= number else ""


def run_key(row: dict[str, Any]) -> tuple[str, ...]:
    """The values that identify a run."""
    return tuple(str(row[column]) for column in KEY_COLUMNS)


def list_runs(points: list[dict[str, str]]) -> tuple[list[dict[str, Any]], list[str]]:
    """All runs, first run 1 of every point, then run 2; and a sentence for each missing release."""
    programs: dict[str, Path] = {}
    missing: dict[str, str] = {}
    layers = {row["release"]: row["rmw"] for row in releases()}
    found = []
    for number in range(1, max(int(point["runs"]) for point in points) + 1):
        for point in points:
            release, slow = point["release"], point["edp_answers"] == "slow"
            if number > int(point["runs"]):
                continue
            try:
                if slow and release != SLOW_EDP_ANSWERS:
                    raise MissingError(f"edp_answers=slow is of {SLOW_EDP_ANSWERS} alone")
                preload = [str(build_slow_edp_answers())] if slow else []
                program = programs.get(release) or build_program(release)
            except MissingError as why:
                missing[f"{release} {point['edp_answers']}"] = str(why)
                continue
            programs[release] = program
            job: dict[str, Any] = {name: point[name] for name in POINT_COLUMNS} | {"number": number}
            job |= {name: int(point[name]) for name in ("hosts", "processes", "endpoints", "ampdu")}
            job |= {"factor": float(point["factor"]), "seconds": float(point["seconds"])}
            job |= {"name": "-".join(part for part in run_key(job) if part).replace(".", "_")}
            job |= {"command": [str(program)], "preload": preload, "kernel": os.uname().release}
            # Cyclone DDS chooses this itself on Wi-Fi, but does not take a TAP for Wi-Fi.
            job["env"] = {"CYCLONEDDS_URI": SPDP_ONLY} if "cyclone" in release else {}
            job["env"] |= {"RMW": layers[release]}
            if job["server"]:
                # Before 3.5.0, clients learn only of endpoints on their own topics.
                at = f"10.77.0.{job['hosts'] + 1 if job['server'] == 'wired' else 1}"
                job["env"] |= {"ROS_DISCOVERY_SERVER": f"{at}:11811", "AIR_MATCHING": "1"}
                words = ["-i", "0", "-l", at, "-p", "11811"]
                job["server_command"] = [*root_description(release)["server"], *words]
            found.append(job)
    return found, list(missing.values())


def messages_by_kind(capture: Path) -> Counter[str]:
    """Return the number of messages of each kind that hosts sent."""
    counts = ds.read_capture(capture).messages().groupby("kind", observed=True).size().to_dict()
    kinds = Counter({kind: int(counts.get(kind, 0)) for kind in MESSAGE_KINDS})
    kinds["other"] = int(sum(counts.values())) - kinds.total()
    return kinds


def row_of_run(out: Path) -> dict[str, Any]:
    """The row of a run, whose capture is then compressed."""
    capture = out.with_suffix(".pcap")
    result = json.loads(out.with_suffix(".json").read_text())
    octets = capture.read_bytes()
    row = {name: value for name, value in result.items() if name in RUN_COLUMNS}
    row = {name: round(v, 6) if isinstance(v, float) else v for name, v in row.items()}
    row |= messages_by_kind(capture)
    learned, pairs = result["learned"], result["pairs"]
    row["known"] = round(len(learned) / pairs, 4)
    row |= {
        f"t{part}_s": time_until_share_known(learned, pairs, part / 100) for part in (50, 95, 100)
    }
    why = reasons_for_distrust(result | {"known": row["known"]})
    row |= {"trusted": int(not why), "why_not": "; ".join(why)}
    row["command"] = f"{Path(result['command'][-1]).name} HOST PROCESS {result['endpoints']} TOTAL"
    row["sha256"] = hashlib.sha256(octets).hexdigest()
    capture.with_suffix(".pcap.gz").write_bytes(gzip.compress(octets, 6, mtime=0))
    capture.unlink()
    return row


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--grid", type=Path, default=GRIDS / "air.csv")
    parser.add_argument("--out", type=Path, default=LAB / "data" / "air", metavar="FOLDER")
    parser.add_argument("--only", action="append", default=[], metavar="RELEASE")
    parser.add_argument("--minutes", type=float, help="begin no run after so many minutes")
    parser.add_argument("--once", action="store_true", help="repeat no untrusted run")
    given = parser.parse_args()
    points = read_table_if_present(given.grid)
    if not points:
        parser.error(f"--grid {given.grid}: there is no point in it")
    names = {point["release"] for point in points}
    if unknown := set(given.only) - names:
        parser.error(f"--only {', '.join(sorted(unknown))}: not one of {', '.join(sorted(names))}")
    try:
        refuse_unsuitable_machine()
        build_cell()
    except MissingError as why:
        parser.exit(1, f"discostorm: {why}\n")
    todo, missing = list_runs(
        [point for point in points if point["release"] in (given.only or names)]
    )
    for sentence in missing:
        print(f"discostorm: {sentence}", file=sys.stderr)
    CAPTURES.mkdir(parents=True, exist_ok=True)
    runs: list[dict[str, Any]] = list(read_table_if_present(given.out / "runs.csv"))

    def count_and_store(out: Path) -> str:
        """Store a run in place of an untrusted one; return a line about it."""
        row = row_of_run(out)
        runs[:] = sorted([old for old in runs if run_key(old) != run_key(row)] + [row], key=run_key)
        write_atomically(given.out / "runs.csv", runs, RUN_COLUMNS)
        trust = f" NOT TRUSTED: {row['why_not']}" if row["why_not"] else ""
        return (
            f"{row['known']:.0%} known, t100 {row['t100_s'] or 'never'}, {row['wall_s']} s{trust}"
        )

    failed, end = 0, time.monotonic() + 60 * (given.minutes or math.inf)
    for _ in range(1 if given.once else MAX_ATTEMPTS):
        there = {run_key(row) for row in runs if given.once or str(row["trusted"]) == "1"}
        left = [job for job in todo if run_key(job) not in there]
        print(f"{len(todo) - len(left)} of {len(todo)} runs are in {given.out}", flush=True)
        # Runs are sequential, because each needs the whole machine.
        for batch in [[job] for job in left] if given.minutes else [left] * bool(left):
            if time.monotonic() < end:
                failed += run_in_parallel(batch, CAPTURES, 0, 0.0, STAGE, count_and_store)
    untrusted = sum(str(row["trusted"]) != "1" for row in runs)
    if untrusted:
        print(f"{untrusted} runs are not trusted, and run again by the next call", file=sys.stderr)
    return 1 if failed or (missing and not todo) else 0


if __name__ == "__main__":
    run_lab_program(main)
