"""One run with a failure, in its own namespaces: hosts, programs, and timed actions on them.

failures.py starts this script as the first process of new namespaces, so every process of the run
ends with this one. The standard output of each program is its log. The run's own log lists each
action with its time on the same monotonic clock.
"""

import json
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from failure_log import read_log, was_discovery_complete
from netns_run import (
    CLEAN_ENVIRONMENT,
    MIN_IDLE_SHARE,
    build_bridge,
    build_host,
    idle_since,
    processor_times,
    run_command,
)

LEAD_TIME = 1.0  # s from the first program's start to time 0 of the steps


def main() -> None:
    job: dict[str, Any] = json.loads(sys.argv[1])
    out = Path(job["out"])
    for path in out.parent.glob(f"{out.name}.*"):  # files of an unfinished run
        path.unlink()
    build_bridge()
    holders = {number: build_host(number) for number in job["places"]}
    running: dict[str, subprocess.Popen[bytes]] = {}
    killed: set[str] = set()

    def start(name: str) -> None:
        program = job["programs"][name]
        inside = ("nsenter", f"--target={holders[program['host']]}", "--net", "--mount")
        with (
            out.with_suffix(f".{name}.log").open("ab") as log,
            out.with_suffix(f".{name}.err").open("ab") as errors,
        ):
            running[name] = subprocess.Popen(
                [*inside, *program["command"]],
                stdin=subprocess.DEVNULL,
                stdout=log,
                stderr=errors,
                env=CLEAN_ENVIRONMENT | program["env"],
            )
        killed.discard(name)

    def kill(name: str) -> None:
        running[name].kill()
        running[name].wait()
        killed.add(name)

    do: dict[str, Callable[[Any], None]] = {
        "start": start,
        "kill": kill,
        "cut": lambda host: run_command(f"ip link set port{host} down"),
        "join": lambda host: run_command(f"ip link set port{host} up"),
        "end": lambda _: None,
    }
    with out.with_suffix(".stage.log").open("w") as log_file:
        begin, before = time.monotonic() + LEAD_TIME, processor_times()
        for step in job["steps"]:
            time.sleep(max(0.0, begin + step["at"] - time.monotonic()))
            print(f"{time.monotonic():.3f} {step['do']} {step['what']}", file=log_file)
            for name, program in running.items():
                if name not in killed and program.poll() is not None:
                    errors = out.with_suffix(f".{name}.err").read_text().strip()
                    raise SystemExit(f"{name} ended with {program.returncode}: {errors}")
            do[step["do"]](step["what"])
    job["idle"] = idle_since(before)
    if job["idle"] < MIN_IDLE_SHARE and not job["trial"]:
        raise SystemExit(f"the processor was idle for {job['idle']:.0%}: machine too busy")
    for name in () if job["trial"] else filter(str.isdigit, running):
        if late := [event for event in read_log(out, name) if event.what == "late"]:
            raise SystemExit(f"{name} was late {len(late)} times: machine too busy")
    if not was_discovery_complete(out, job):
        raise SystemExit("not all knew each other before the death")
    out.with_suffix(".json").write_text(json.dumps(job, indent=1, sort_keys=True) + "\n")


main()
