"""Summarize the diagnosis of captures with and without faults: findings and times.

Writes `lab/data/faults.csv`, how often each fault led to which findings, and `fault_times.csv`,
when each host had discovered all others by the capture and by its log of matches.
"""

import argparse
import csv
import json
from collections import Counter
from pathlib import Path
from typing import Any

from failure_log import read_log
from lab_data import DATA, write_table
from run_grid import BUILD, GRIDS

import discostorm as ds

#: Faults in which all processes discover each other at once.
TIMED_FAULTS = ("healthy", "late joiner", "crash")


def fault_and_product(path: Path) -> tuple[str, str]:
    """Return fault and product of a capture."""
    job = json.loads(path.with_name(path.name.removesuffix(".pcap.gz") + ".json").read_text())
    if "ill" in job:
        return job["ill"], job["product"]
    return "healthy, of other sizes", f"{job['product']}-{job['variant']}"


def findings_by_fault(paths: list[Path]) -> list[dict[str, Any]]:
    """Return a row for each fault, product and set of findings."""
    runs: Counter[tuple[str, str]] = Counter()
    found: dict[tuple[str, str], Counter[str]] = {}
    for path in paths:
        what = fault_and_product(path)
        runs[what] += 1
        kinds = [finding.kind for finding in ds.read_capture(path).diagnosis().findings]
        found.setdefault(what, Counter())["; ".join(kinds) or "nothing"] += 1
    return [
        {
            "staged": fault,
            "product": product,
            "runs": runs[fault, product],
            "found": kinds,
            "in": count,
        }
        for (fault, product), kinds_of in sorted(found.items())
        for kinds, count in kinds_of.most_common()
    ]


def discovery_times(path: Path) -> list[dict[str, Any]]:
    """Return when each host had discovered all expected hosts, by its log and by the capture."""
    out = path.with_name(path.name.removesuffix(".pcap.gz"))
    job = json.loads(out.with_suffix(".json").read_text())
    capture = ds.read_capture(path)
    knows: Any = capture.diagnosis().hosts()["knows_all_s"].to_dict()
    logs = {name: read_log(out, name) for name in job["programs"] if name.isdigit()}
    number = {event.whom: name for name, log in logs.items() for event in log if event.what == "me"}
    rows = []
    for name, log in logs.items():
        first: dict[tuple[str, str], float] = {}
        for event in log:
            if event.what.startswith("matched"):
                whom = number.get(event.whom, event.whom), event.what[-1]
                if whom[0] == name:
                    continue
                first.setdefault(whom, event.time + job["clock"] - capture.start)
        others = [other for other in logs if other != name]
        if len(first) < 2 * len(others):
            continue  # discovery was never complete
        rows.append(
            {
                "staged": job["ill"],
                "product": job["product"],
                "run": job["run"],
                "host": name,
                "log_s": f"{max(first.values()):.3f}",
                "capture_s": f"{knows[f'10.77.0.{name}']:.3f}",
            }
        )
    return rows


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=Path, default=DATA, help="folder of tables")
    given = parser.parse_args()
    sick = sorted((BUILD / "ills").glob("*.pcap.gz"))
    well = sorted((BUILD / "ills_healthy").glob("*.pcap.gz"))
    write_table(given.out / "faults.csv", findings_by_fault([*sick, *well]))
    with (GRIDS / "faults.csv").open(newline="") as file:
        watched = {
            (row["ill"], row["product"]) for row in csv.DictReader(file) if row["endpoints"] == "0"
        }
    timed: list[Path] = [
        path
        for path in sick
        if fault_and_product(path)[0] in TIMED_FAULTS and fault_and_product(path) in watched
    ]
    write_table(
        given.out / "fault_times.csv", [row for path in timed for row in discovery_times(path)]
    )


if __name__ == "__main__":
    main()
