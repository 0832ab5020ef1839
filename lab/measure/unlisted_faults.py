"""Capture faults that the diagnosis has no rule for, and score its findings.

`grids/unlisted_faults.toml` says what is staged, and what is true. Each run is its own process
tree, as in faults.py.
"""

import argparse
import json
import sys
import tomllib
from pathlib import Path
from typing import Any

from faults import (
    SPACING,
    STAGE,
    Job,
    compress_capture,
    process_command,
    server_command,
    timed_action,
)
from lab_data import BOOK, write_table
from run_grid import BUILD, GRIDS, PROGRAMS, PYTHON, ZENOH_ROUTER, run_in_parallel, run_lab_program

import discostorm as ds
from discostorm.data import read_data

CROWD = 14  # processes at a time
TABLE = GRIDS / "unlisted_faults.toml"
PROFILES = "FASTRTPS_DEFAULT_PROFILES_FILE"
#: Programs by the word that a command of the table begins with.
PROGRAMS_BY_WORD = {
    "DATA": [str(PYTHON), str(PROGRAMS / "user_data_process.py")],
    "NODE": [str(PYTHON), str(PROGRAMS / "node_cyclone_dds.py")],
    "NODE_FAST": [str(BUILD / "bin" / "node_fast_dds")],
    "NODE_ZENOH": [str(PYTHON), str(PROGRAMS / "node_zenoh.py")],
    "ROUTER": ZENOH_ROUTER[:-1],
    "LINK": [str(PYTHON), str(PROGRAMS / "link.py")],
    "PEER": [str(PYTHON), str(PROGRAMS / "watch_zenoh.py")],
    "TRAFFIC": [str(PYTHON), str(PROGRAMS / "other_traffic.py")],
}
#: Command that watches a fleet which already runs, and when it starts [s].
WATCH = [str(Path(sys.executable).with_name("discostorm")), "watch", "-i", "br0", "--follow-fleet"]
WATCH_FROM = 6.0
#: Table of the findings, by version of the rules.
SCORES = BOOK / "unlisted_faults.csv"
SOURCE = {"source": "lab/measure/unlisted_faults.py"}
FIRST = 1.5  # s, when programs start
#: What an ill has if its table does not say it.
DEFAULTS: Job = {"set": 1, "hosts": 3, "processes": 1, "endpoints": 0, "seconds": 20, "capture": {}}


def filled(value: Any) -> Any:
    """Return a value of the table with the addresses and programs that its texts name."""
    if isinstance(value, str):
        return value.replace("LAB", str(BUILD)).replace("HOST", "10.77.0.")
    if isinstance(value, list):
        words = PROGRAMS_BY_WORD.get(value[0]) if value and isinstance(value[0], str) else None
        return [*words, *value[1:]] if words else [filled(one) for one in value]
    if isinstance(value, dict):
        return {key: filled(one) for key, one in value.items()}
    return value


def environment(given: dict[str, str], path: Path) -> dict[str, str]:
    """Return the environment of a program; XML of Fast DDS goes into a file."""
    env = dict(given)
    if (xml := given.get(PROFILES, "")).startswith("<"):
        path.write_text(f'<?xml version="1.0"?>\n{xml}\n')
        env[PROFILES] = str(path)
    return env


def program_of(fault: Job, host: int, number: int) -> Job:
    """Return the program of a host, with the settings of this host in the table."""
    own = fault | fault.get("host", {}).get(str(host), {})
    listed = str(own["endpoints"])
    found = process_command(own | {"endpoints": 2 if " " in listed else listed}, host, number)
    if " " in listed:
        found["command"][-3] = listed
    if "settings" in own:
        found["command"][-1] = json.dumps(own["settings"])
    if "command" in own:
        found |= {"command": own["command"], "waits": False}
    return found | {"env": found["env"] | fault.get("env", {}) | own.get("env", {})}


def programs(fault: Job, out: Path) -> dict[str, Job]:
    """Return the programs of an ill by name: those of each host, and further ones."""
    found = {}
    for host in range(1, fault["hosts"] + 1):
        for number in range(1, fault["processes"] + 1):
            name = f"{host}" if number == 1 else f"{host}.{number}"
            found[name] = program_of(fault, host, number)
    if "-" in fault["product"]:
        found["server"] = server_command(fault)
    for name, more in fault.get("more", {}).items():
        found[name] = {"waits": False, "env": {}} | more
    if fault.get("watched"):
        seconds = str(fault["seconds"] - WATCH_FROM)
        found["watch"] = {"waits": False, "env": {}, "host": 0, "at": WATCH_FROM}
        found["watch"]["command"] = [*WATCH, "--seconds", seconds]
    for name, one in found.items():
        one["env"] = environment(one["env"], out.with_name(f"profile-{out.name}-{name}.xml"))
    return found


def table(path: Path = TABLE) -> dict[str, Job]:
    """Return the staged faults and their true causes, by name."""
    return {name: DEFAULTS | fault for name, fault in tomllib.loads(path.read_text()).items()}


def jobs(only: list[str], out: Path, path: Path = TABLE) -> list[Job]:
    """Return all runs of the table, or those of some ills."""
    found = []
    for name, given in table(path).items():
        if only and name not in only:
            continue
        fault: Job = {"ill": name, "name": name} | filled(given)
        running = programs(fault, out / name)
        end = float(fault["seconds"])
        steps = [timed_action(*one) for one in fault.get("steps", [])]
        steps.append(timed_action(fault.get("capture_at", 0.1), "capture", fault["capture"]))
        starts = fault.get("starts", {})
        for name_of, one in running.items():
            at = starts.get(name_of, one.get("at", 0.2 if name_of == "server" else FIRST))
            steps += [timed_action(at, "start", name_of)] if at < end else []
        steps.append(timed_action(end, "end"))
        places = {one["host"] for one in running.values() if one["host"]} | {
            *fault.get("places", [])
        }
        steps = sorted(steps, key=lambda one: float(one["at"]))
        found.append(
            fault | {"programs": running, "steps": steps, "places": sorted(places), "run": 1}
        )
    return found


def answer(path: Path, fault: Job) -> tuple[str, str]:
    """Return the cause and the first action that the diagnosis names first."""
    found = ds.read_capture(path).diagnosis(fault.get("expect"))
    # The order of the first sentence: what is wrong, then events with a headline.
    headlines = [one for one in found.findings if one.role == "headline"]
    first = [*found.wrong, *headlines, *found.findings][:1]
    return (first[0].kind, first[0].remedy or "none") if first else ("nothing", "none")


def answers(folder: Path, rules: str, number: int, only: list[str]) -> list[dict[str, Any]]:
    """Return the true cause of each capture, the first finding, and whether it is right."""
    rows = []
    for name, fault in table().items():
        path = folder / f"{name}.pcap.gz"
        chosen = number == fault["set"] and (not only or name in only)
        if chosen and path.exists():
            cause, action = answer(path, fault)
            case = {"set": number, "ill": name, "product": fault["product"]}
            case["healthy"] = int(name.startswith("healthy"))  # some ills are invisible
            good = (cause in fault["causes"]) + (action in fault["actions"])
            said = {"rules": rules, "cause": cause, "action": action, "right": int(good == 2)}
            rows.append(case | said | {"true": fault["true"]} | SOURCE)
            print(("WRONG", "partly", "right")[good], name, f"{cause} ({action})", sep=": ")
    print(f"{sum(row['right'] for row in rows)} of {len(rows)} right")
    return rows


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--only", action="append", default=[], metavar="ILL")
    parser.add_argument("--table", type=Path, default=TABLE, help="what to stage")
    parser.add_argument("--out", type=Path, default=BUILD / "unlisted_ills")
    parser.add_argument("--crowd", type=int, default=CROWD, help="processes at a time")
    parser.add_argument("--rules", help="score captures, and keep that under this name")
    parser.add_argument("--set", type=int, default=1, help="which set to score")
    given = parser.parse_args()
    if given.rules is None:
        given.out.mkdir(parents=True, exist_ok=True)
        todo = jobs(given.only, given.out, given.table)
        todo = [job for job in todo if not (given.out / f"{job['name']}.pcap.gz").exists()]
        return (
            1
            if run_in_parallel(todo, given.out, given.crowd, SPACING, STAGE, compress_capture)
            else 0
        )
    kept = read_data(str(SCORES)) if SCORES.exists() else []
    new = answers(given.out, given.rules, given.set, given.only)
    scored = {(row["rules"], row["ill"]) for row in new}
    write_table(SCORES, [*(row for row in kept if (row["rules"], row["ill"]) not in scored), *new])
    return 0


if __name__ == "__main__":
    run_lab_program(main)
