"""One run with a fault, in its own namespaces: hosts, programs, and timed faults.

faults.py starts this script as the first process of new namespaces, so every process of the run
ends with this one. The capture is on the bridge or on one host. Firewall rules of a host drop
incoming packets after the capture. The standard output of each program is its log.
"""

import json
import re
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

from failure_log import read_log
from netns_run import (
    CAPTURE_TAIL,
    CLEAN_ENVIRONMENT,
    begin_capture,
    build_bridge,
    build_host,
    end_capture,
    run_command,
)

END_SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGKILL)
LEAD_TIME = 1.0  # s from the first program's start to time 0 of the steps


class Stage:
    """Hosts, programs and capture of a run."""

    def __init__(self, job: dict[str, Any]) -> None:
        self.job, self.out = job, Path(job["out"])
        build_bridge()
        self.processes_holding = {number: build_host(number) for number in job["places"]}
        self.running: dict[str, subprocess.Popen[str]] = {}
        self.killed: set[str] = set()
        self.dump: subprocess.Popen[bytes] | None = None

    def start(self, name: str) -> None:
        """Start a program in a host, or beside the bridge (host 0); tell the time if it waits."""
        program = self.job["programs"][name]
        holder = self.processes_holding.get(program["host"])
        inside = () if holder is None else ("nsenter", f"--target={holder}", "--net", "--mount")
        with (
            self.out.with_suffix(f".{name}.log").open("a") as log,
            self.out.with_suffix(f".{name}.err").open("a") as errors,
        ):
            self.running[name] = subprocess.Popen(
                [*inside, *program["command"]],
                stdin=subprocess.PIPE if program["waits"] else subprocess.DEVNULL,
                stdout=log,
                stderr=errors,
                env=CLEAN_ENVIRONMENT | program["env"],
                text=True,
            )
        if program["waits"]:
            clock_input = self.running[name].stdin
            assert clock_input is not None
            clock_input.write(f"{time.time()}\n")
            clock_input.close()
        self.killed.discard(name)

    def kill(self, name: str) -> None:
        """Kill a program."""
        self.running[name].kill()
        self.running[name].wait()
        self.killed.add(name)

    def capture(self, where: dict[str, Any]) -> None:
        """Start a capture on the bridge or in a host, with or without a filter."""
        inside = self.processes_holding.get(where.get("host"))
        interface = where.get("interface", "eth0") if inside else ""
        self.dump = begin_capture(self.out, 32768, inside, interface, where.get("filter", ""))

    def rules(self, step: dict[str, Any]) -> None:
        """Drop incoming packets of some hosts by nft rules."""
        lines = "\n".join(step["drop"])
        chain = f"type filter hook input priority 0;\n{lines}\n"
        text = f"table inet ill {{ chain input {{ {chain}}}\n}}\n"
        for host in step["hosts"]:
            command = [
                "nsenter",
                f"--target={self.processes_holding[host]}",
                "--net",
                "nft",
                "-f",
                "-",
            ]
            done = subprocess.run(
                command, input=f"flush ruleset\n{text}", capture_output=True, text=True
            )
            if done.returncode:
                raise SystemExit(f"nft: {done.stderr.strip()}")

    def run(self, step: dict[str, Any]) -> None:
        """Run commands in a host, or beside the bridge; PID2 is the holder of host 2."""
        for command in step["commands"]:
            for number, pid in self.processes_holding.items():
                command = re.sub(rf"\bPID{number}\b", str(pid), command)
            run_command(command, self.processes_holding.get(step.get("host")))

    def signal(self, step: dict[str, Any]) -> None:
        """Send a signal to a program."""
        self.running[step["name"]].send_signal(step["signal"])
        if step["signal"] in END_SIGNALS:
            self.killed.add(step["name"])

    def cut(self, host: int) -> None:
        """Take a host's link down."""
        run_command(f"ip link set port{host} down")

    def join(self, host: int) -> None:
        """Bring a host's link up again."""
        run_command(f"ip link set port{host} up")

    def end(self, _: object) -> None:
        """End the capture."""
        time.sleep(CAPTURE_TAIL)
        if self.dump is not None:
            end_capture(self.out, self.dump)

    def check(self) -> None:
        """Fail if a program has ended unexpectedly."""
        for name, program in self.running.items():
            if name not in self.killed and program.poll() is not None:
                errors = self.out.with_suffix(f".{name}.err").read_text().strip()
                raise SystemExit(f"{name} ended with {program.returncode}: {errors}")


def main() -> None:
    job: dict[str, Any] = json.loads(sys.argv[1])
    out = Path(job["out"])
    for path in out.parent.glob(f"{out.name}.*"):  # files of an unfinished run
        path.unlink()
    stage = Stage(job)
    begin = time.monotonic() + LEAD_TIME
    job["clock"] = time.time() - time.monotonic()
    done = []
    for step in job["steps"]:
        time.sleep(max(0.0, begin + step["at"] - time.monotonic()))
        done.append([time.time(), step["do"]])
        if step["do"] != "end":
            stage.check()
        getattr(stage, step["do"])(step["what"])
    for name in filter(str.isdigit, stage.running):
        if not job["programs"][name]["waits"] and not job.get("may_be_late"):
            late = [event for event in read_log(out, name) if event.what == "late"]
            if late:
                raise SystemExit(f"{name} was late {len(late)} times: machine too busy")
    job["done"] = done
    out.with_suffix(".json").write_text(json.dumps(job, indent=1, sort_keys=True) + "\n")
    for path in out.parent.glob(f"{out.name}.*.err"):
        if not path.stat().st_size:
            path.unlink()


main()
