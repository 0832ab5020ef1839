"""Measure a restart of one process and the join of one host, relative to a common startup.

These are runs of run_grid.py with more programs. All processes start together. Much later, the last
process of the last host ends without a goodbye and restarts within its lease. After that, one more
host starts all of its processes. `count_messages.py --kind restart_` counts the messages.
"""

import argparse
from pathlib import Path
from typing import Any

from run_grid import (
    BUILD,
    GRIDS,
    MAX_PARALLEL_PROCESSES,
    PACKAGES,
    installed_version,
    list_runs,
    run_in_parallel,
    run_lab_program,
)

#: Times at which the process ends, restarts, and one more host joins [s].
PROCESS_ENDS_AT, PROCESS_RESTARTS_AT, HOST_JOINS_AT = 36.0, 38.0, 62.0
#: Counted window of each event [s]: as long as the startup window.
WINDOWS = {
    "restart": (PROCESS_RESTARTS_AT, PROCESS_RESTARTS_AT + 12),
    "join": (HOST_JOINS_AT, HOST_JOINS_AT + 12),
}


def with_restart(job: dict[str, Any]) -> dict[str, Any]:
    """Return a run in which one process restarts and one more host joins."""
    hosts, processes = job["hosts"], job["processes"]
    programs: list[dict[str, Any]] = [
        {"host": host, "process": process, "after": 0.0}
        for host in range(1, hosts + 1)
        for process in range(1, processes + 1)
    ]
    last = programs[-1]
    programs.append(last | {"after": PROCESS_RESTARTS_AT, "again": True})
    last["seconds"] = PROCESS_ENDS_AT
    programs += [
        {"host": hosts + 1, "process": process, "after": HOST_JOINS_AT}
        for process in range(1, processes + 1)
    ]
    more = {"programs": programs, "windows": WINDOWS}
    return job | more | {"seconds": max(end for _, end in WINDOWS.values())}


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--grid", type=Path, default=GRIDS / "restarts.csv", help="table of points")
    parser.add_argument("--out", type=Path, default=BUILD / "restarts", help="for the captures")
    parser.add_argument(
        "--crowd", type=int, default=MAX_PARALLEL_PROCESSES, help="processes at a time"
    )
    given = parser.parse_args()
    given.out.mkdir(parents=True, exist_ok=True)
    versions = {product: installed_version(product) for product in PACKAGES}
    todo = map(with_restart, list_runs(given.grid, [], False, versions))
    left = [job for job in todo if not (given.out / job["name"]).with_suffix(".pcap.gz").exists()]
    return 1 if run_in_parallel(left, given.out, given.crowd, 4.0) else 0


if __name__ == "__main__":
    run_lab_program(main)
