"""Restart a Discovery Server together with its whole fleet, with and without a backup file (-b).

The fleet runs for a while; then the power fails: all programs are killed at once, and only the
server's files remain. All start again at once, and tcpdump sees it. Needs what `make lab-releases`
needs. Usage: backup_restarts.py [RELEASE ...]; rows go to the book's
`data/measured/backup_restarts.csv`.
"""

from __future__ import annotations

import csv
import json
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from lab_data import BOOK
from run_grid import BUILD, RUN_COMMAND, run_lab_program
from run_releases import existing_roots, list_runs

import discostorm as ds

RELEASES = ("fast_dds-2.9.1", "fast_dds-2.14.6", "fast_dds-3.6.2")
HOSTS, PROCESSES, ENDPOINTS, RUNS = 6, 2, 10, 3
SECONDS_BEFORE_POWER_FAILURE, SECONDS_AFTERWARDS = (
    8.0,
    12.0,
)  # s that the fleet runs before the power fails, and afterwards
TABLE = BOOK / "backup_restarts.csv"


def job_of(release: str, root: dict[str, Any], backup: bool) -> dict[str, Any]:
    """Return the run of a fleet with its server, which works in a folder that outlives it."""
    point = {
        "release": release,
        "hosts": HOSTS,
        "processes": PROCESSES,
        "endpoints": ENDPOINTS,
        "names": "unique",
        "types": "one",
        "server": "server",
        "use": "restart",
        "seconds": SECONDS_AFTERWARDS,
        "runs": 1,
    }
    (job,) = list_runs([{name: str(value) for name, value in point.items()}], {release: root})
    ((host, command),) = job["servers"]
    folder = BUILD / "backup_restarts" / release
    shell = f"cd {folder} && exec {' '.join(command)}{' -b' * backup}"
    return job | {"servers": [(host, ["sh", "-c", shell])], "folder": str(folder)}


def run_until_killed(job: dict[str, Any], out: Path, seconds: float | None = None) -> bool:
    """Run a job; return whether it reached its end before all its programs were killed."""
    program = subprocess.Popen([*RUN_COMMAND, json.dumps(job | {"out": str(out)})])
    try:
        return program.wait(seconds) == 0
    except subprocess.TimeoutExpired:
        return False
    finally:
        program.kill()
        program.wait()


def restart_rows(release: str, root: dict[str, Any], backup: bool) -> Iterator[dict[str, Any]]:
    """Yield a row for each restart: the airtime after it, on the paper's channel."""
    job = job_of(release, root, backup)
    for number in range(1, RUNS + 1):
        shutil.rmtree(job["folder"], ignore_errors=True)
        Path(job["folder"]).mkdir(parents=True)
        out = BUILD / "backup_restarts" / "run"
        run_until_killed(job, out, SECONDS_BEFORE_POWER_FAILURE)
        if not run_until_killed(job, out):
            raise SystemExit(f"{release}: a restart failed; see above")
        stored = json.loads(out.with_suffix(".json").read_text())
        seen = ds.read_capture(out.with_suffix(".pcap"))
        messages = seen.messages()
        yield {
            "release": release,
            "backup": int(backup),
            "run": number,
            "seconds": SECONDS_AFTERWARDS,
            "idle": stored["idle"],
            "frames": int(messages["frames"].sum()),
            "acknacks": int(messages["submessage"].eq("ACKNACK").sum()),
            "airtime_s": round(float(seen.airtime().sum()), 3),
        }


def main() -> int:
    roots, missing = existing_roots(set(sys.argv[1:] or RELEASES))
    for sentence in missing:
        print(sentence, file=sys.stderr)
    rows: list[dict[str, Any]] = []
    for release, root in roots.items():
        for backup in (False, True):
            for row in restart_rows(release, root, backup):
                print(row, flush=True)
                rows.append(row)
    with TABLE.open("w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, list(rows[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    return 1 if missing else 0


if __name__ == "__main__":
    run_lab_program(main)
