"""Measure releases of the middleware, one run at a time (see README.md).

    run_releases.py [--grid GRID] [--out FOLDER] [--captures FOLDER] [--only RELEASE] [--once]

Each run is counted as soon as it ends, and stored in FOLDER, `lab/data/releases`: its settings in
`runs.csv`, its counts in `counts.csv`. Stored runs are not repeated, except marked ones: their
cores were not idle, or their processes started late. Marked runs are repeated at the end, twice.
"""

import argparse
import csv
import gzip
import json
import os
import re
import sys
from collections import Counter
from pathlib import Path
from typing import Any

from count_messages import HOP_COLUMNS, TIME_DIGITS, count_rows, run_row
from run_grid import (
    BUILD,
    GRIDS,
    LAB,
    SPDP_ONLY,
    compress_capture,
    remove_files,
    run_in_parallel,
    run_lab_program,
)

ROOTS = BUILD / "releases"
TABLE = LAB / "releases" / "releases.csv"
#: Columns that identify a run.
KEY_COLUMNS = ("release", "hosts", "processes", "endpoints", "names", "types", "server", "number")
RUN_COLUMNS = (
    *(
        "run",
        *KEY_COLUMNS[:-1],
        "use",
        "number",
        "seconds",
        "wire",
        "matched",
        "expected",
        "last_match_s",
    ),
    *("start_skew_s", "endpoints_created_s", "others", "idle", "again"),
    *("kernel", "command", "environment", "sha256"),
)
CAPTURE_TAIL = 1.0  # s that tcpdump continues
#: Maximum share of the processors that other programs may use in the window.
MAX_SHARE_OF_OTHERS = 0.1
#: Minimum idle share of the window: with less, processes wait for each other.
MIN_IDLE_SHARE = 0.3
MAX_START_DELAY = 0.1  # s after the start at which the last process may start
MAX_ATTEMPTS = 3
#: A separate host, wired to the access point, as in `run_grid.py`.
SERVER_HOST = 101
#: RTPS vendors, by their id in each header.
VENDORS = {b"\x01\x0f": "eProsima", b"\x01\x10": "Eclipse Cyclone DDS"}


def read_table_if_present(path: Path) -> list[dict[str, str]]:
    """Return the rows of a table; none if the file is missing."""
    if not path.exists():
        return []
    with path.open(newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def write_atomically(path: Path, rows: list[dict[str, Any]], columns: tuple[str, ...]) -> None:
    """Write a table atomically."""
    path.parent.mkdir(parents=True, exist_ok=True)
    new = path.with_suffix(".new")
    with new.open("w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, columns, lineterminator="\n", extrasaction="ignore")
        writer.writeheader()
        writer.writerows(rows)
    new.replace(path)


def run_key(row: dict[str, Any]) -> tuple[str, ...]:
    """Return the values that identify a run."""
    return tuple(str(row[column]) for column in KEY_COLUMNS)


def list_runs(
    points: list[dict[str, str]], roots: dict[str, dict[str, Any]]
) -> list[dict[str, Any]]:
    """Return all runs of releases that have a root: run 1 of every point, then run 2."""
    releases = {f"{row['product']}-{row['version']}": row for row in read_table_if_present(TABLE)}
    found = []
    for number in range(1, max((int(point["runs"]) for point in points), default=0) + 1):
        for point in points:
            if number > int(point["runs"]) or point["release"] not in roots:
                continue
            release, root = releases[point["release"]], roots[point["release"]]
            hosts, server, env = int(point["hosts"]), point["server"], {}
            served: list[tuple[int, list[str]]] = []
            if release["rmw"]:
                env["RMW"] = release["rmw"]
            if release["product"] == "cyclone_dds":
                env["CYCLONEDDS_URI"] = SPDP_ONLY  # the default of Cyclone DDS on Wi-Fi
            if server == "server":
                at = f"10.77.0.{SERVER_HOST}"
                env["ROS_DISCOVERY_SERVER"] = f"{at}:11811"
                served = [(SERVER_HOST, [*root["server"], "-i", "0", "-l", at, "-p", "11811"])]
            elif server == "router_per_host":
                words = root["server"]
                served = [
                    (host, [word.replace("HOST", str(host)) for word in words])
                    for host in range(1, hosts + 1)
                ]
            shape = f"h{hosts}p{point['processes']}e{point['endpoints']}"
            named = (point["release"].replace(".", "_"), server, shape, point["names"])
            seconds = float(point["seconds"])
            found.append(
                {
                    "name": "-".join(
                        part for part in (*named, point["types"], f"r{number}") if part
                    ),
                    "release": point["release"],
                    "product": release["product"],
                    "version": release["version"],
                    "kernel": os.uname().release,
                    "command": root["command"],
                    "env": env,
                    "servers": served,
                    "hosts": hosts,
                    "processes": int(point["processes"]),
                    "endpoints": int(point["endpoints"]),
                    "names": point["names"],
                    "types": point["types"],
                    "server": server,
                    # Zenoh's program takes its link in place of types, which do not matter.
                    "variant": server if release["product"] == "zenoh" else point["types"],
                    "use": point["use"],
                    "run": number,
                    "number": number,
                    "seconds": seconds,
                    "tail": CAPTURE_TAIL,
                    "windows": {"startup": [-10.0, seconds]},
                    "idle_needed": 0.0,
                }
            )
    return found


def versions_in_packets(octets: bytes) -> str:
    """Return the versions in packets: of RTPS, of the vendor, and of the product."""
    headers = Counter(re.findall(rb"RTPS([\x01\x02].)(\x01[\x00-\x7f])", octets, re.DOTALL))
    if not headers:
        return ""
    (protocol, vendor), _ = headers.most_common(1)[0]
    said = [f"RTPS {protocol[0]}.{protocol[1]}", VENDORS.get(vendor, vendor.hex(".")) or ""]
    # eProsima's parameter 0x8000 has four octets; Cyclone DDS has text that contains the version.
    product = Counter(re.findall(rb"\x00\x80\x04\x00([\x01-\x09].{2}\x00)", octets, re.DOTALL))
    named = Counter(re.findall(rb"/(\d+\.\d+\.\d+)/Linux", octets))
    if vendor == b"\x01\x0f" and product:
        said.append(".".join(str(octet) for octet in product.most_common(1)[0][0][:3]))
    elif named:
        said.append(named.most_common(1)[0][0].decode())
    return ", ".join(said)


def read_matches(out: Path) -> dict[str, Any]:
    """Return the matches in the logs of a run's processes, and remove the logs."""
    logs = sorted(out.parent.glob(f"{out.name}.*.log"))
    said = re.findall(r"^matched (\d+) (\d+) ([\d.]+)$", "".join(map(Path.read_text, logs)), re.M)
    for log in logs:
        log.unlink()
    if not said:
        return {"matched": "", "last_match_s": ""}
    last = max(float(at) for *_, at in said)
    total = sum(int(writers) + int(readers) for writers, readers, _ in said)
    return {"matched": total, "last_match_s": f"{last:.3f}"}


def count_expected_matches(stored: dict[str, Any]) -> int:
    """Return the number of matches if all endpoints of each topic are matched."""
    everyone = stored["hosts"] * stored["processes"]
    return everyone**2 * stored["endpoints"] if stored["names"] == "matching" else 0


def rows_of_run(out: Path, notes: Counter[str]) -> tuple[dict[str, Any], list[dict[str, Any]]]:
    """Return the row of a captured and compressed run, and the rows of its counts."""
    capture = out.with_suffix(".pcap.gz")
    stored = json.loads(out.with_suffix(".json").read_text())
    row = run_row("", capture, stored)
    row["run"] = row["sha256"][:TIME_DIGITS]
    row |= {name: stored[name] for name in (*KEY_COLUMNS, "use", "others")}
    row |= {"expected": count_expected_matches(stored)} | read_matches(out)
    if row["matched"] == "":
        row["expected"] = ""
    with gzip.open(capture) as packed:
        row["wire"] = versions_in_packets(packed.read())
    busy = stored["others"] > MAX_SHARE_OF_OTHERS or stored["idle"] < MIN_IDLE_SHARE
    row["again"] = int(busy or float(row["start_skew_s"]) > MAX_START_DELAY)
    return row, list(count_rows(row["run"], capture, stored, notes))


def existing_roots(names: set[str]) -> tuple[dict[str, dict[str, Any]], list[str]]:
    """Return the roots of releases, and a sentence for each release without a root."""
    found, missing = {}, []
    for name in sorted(names):
        made = ROOTS / name / "made.json"
        if made.exists():
            found[name] = json.loads(made.read_text())
        else:
            missing.append(f"{name} has no root: make lab-roots makes it, or says what is missing")
    return found, missing


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--grid", type=Path, default=GRIDS / "releases.csv")
    parser.add_argument("--out", type=Path, default=LAB / "data" / "releases", metavar="FOLDER")
    parser.add_argument("--captures", type=Path, default=BUILD / "releases_captures")
    parser.add_argument("--only", action="append", default=[], metavar="RELEASE")
    parser.add_argument(
        "--once", action="store_true", help="repeat nothing; a marked run is no failure"
    )
    given = parser.parse_args()
    points = read_table_if_present(given.grid)
    if not points:
        parser.error(f"--grid {given.grid}: there is no point in it")
    names = {point["release"] for point in points}
    if unknown := set(given.only) - names:
        parser.error(f"--only {', '.join(sorted(unknown))}: not one of {', '.join(sorted(names))}")
    roots, missing = existing_roots(names & set(given.only or names))
    for sentence in missing:
        print(sentence, file=sys.stderr)
    given.captures.mkdir(parents=True, exist_ok=True)
    runs: list[dict[str, Any]] = list(read_table_if_present(given.out / "runs.csv"))
    counts: list[dict[str, Any]] = list(read_table_if_present(given.out / "counts.csv"))
    todo = list_runs(points, roots)
    notes: Counter[str] = Counter()

    def count_and_store(out: Path) -> str:
        """Count a run and store it, in place of a marked run; return a line about it."""
        news = compress_capture(out)
        try:
            row, rows = rows_of_run(out, notes)
        except SystemExit as why:
            remove_files(out)
            return f"is run again: {why}"
        runs[:] = [old for old in runs if run_key(old) != run_key(row)] + [row]
        stored = {one["run"] for one in runs}
        counts[:] = [one for one in counts if one["run"] in stored] + rows
        write_atomically(given.out / "counts.csv", counts, HOP_COLUMNS)
        write_atomically(given.out / "runs.csv", runs, RUN_COLUMNS)
        matched = f", {row['matched']} of {row['expected']} matches" * (row["matched"] != "")
        mark = ", has to be repeated" * row["again"]
        return f"{news}{matched}, idle {row['idle']:.0%}, others {row['others']:.0%}{mark}"

    failed = 0
    for _ in range(1 if given.once else MAX_ATTEMPTS):
        there = {run_key(row) for row in runs if given.once or str(row["again"]) == "0"}
        left = [job for job in todo if run_key(job) not in there]
        print(f"{len(todo) - len(left)} of {len(todo)} runs are in {given.out}", flush=True)
        if not left:
            break
        # Runs are sequential, because each needs the whole machine.
        failed = run_in_parallel(left, given.captures, crowd=0, spacing=0.0, finish=count_and_store)
    for note, many in notes.most_common():
        print(f"  in {many}: {note}", file=sys.stderr)
    marked = sum(str(row["again"]) != "0" for row in runs)
    if marked:
        print(f"{marked} runs are marked, and run again by the next call", file=sys.stderr)
    return 1 if failed or missing or (marked and not given.once) else 0


if __name__ == "__main__":
    run_lab_program(main)
