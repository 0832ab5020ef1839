"""One startup of real middleware on an emulated Wi-Fi cell, in namespaces of its own.

measure_air.py starts this script as the first process of new PID, mount and network namespaces.
When this process ends, for whatever reason, the kernel ends all others in there and removes
the networks with their TAPs.

All clocks of the middleware and of ns-3 go `factor` times slower, from one instant on. Times in
the results are those of the slow clock, since the start of discovery.
"""

import contextlib
import json
import os
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from pathlib import Path
from typing import IO, Any

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent / "measure")]

from build_bench import BENCH  # noqa: E402
from netns_run import create_namespaces, disable_ipv6, raise_interface, run_command  # noqa: E402

MAX_AMPDU_BYTES = 65535  # bytes
START_DELAY = 0.5  # s of the real clock from readiness of all processes to the start
#: Bytes in flight, in a file system in memory that all hosts see and that ends with the run.
MEMORY = BENCH / "memory"
IN_FLIGHT = MEMORY / "in_flight"
TIME_AFTER_DISCOVERY = 0.2  # s of the slow clock after the last process knows all endpoints
EXTRA_WAIT = 30.0  # s of the real clock, beyond what the slow clock explains
SERVER_HEAD_START = 1.0  # s of the slow clock by which a server starts before all others
REBOOT_TIME = 3.0  # s of the slow clock from the kill of a robot's processes to their restart


class SlowClock:
    """The clock of slow_clock.c, which all slowed processes share."""

    def __init__(self, factor: float):
        self.factor = factor
        self.monotonic = time.clock_gettime_ns(time.CLOCK_MONOTONIC)
        self.realtime = time.time_ns()

    def now(self) -> float:
        """The slow clock's time [s]."""
        epoch = self.realtime * 1e-9
        return epoch + (time.time() - epoch) / self.factor

    def environment(self) -> dict[str, str]:
        """Return the environment that sets speed and start of the clock of slow_clock.c."""
        return {
            "SLOW_CLOCK_FACTOR": str(self.factor),
            "SLOW_CLOCK_MONOTONIC": str(self.monotonic),
            "SLOW_CLOCK_REALTIME": str(self.realtime),
        }


class Program:
    """A program whose lines are read as they come."""

    def __init__(self, command: list[str], environment: dict[str, str], errors: IO[str]):
        self.process = subprocess.Popen(
            command,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=errors,
            text=True,
            env=environment,
        )
        self.lines: list[list[str]] = []
        threading.Thread(target=self._read, daemon=True).start()

    def _read(self) -> None:
        """Collect lines until the program closes its output."""
        assert self.process.stdout is not None
        for line in self.process.stdout:
            self.lines.append(line.split(maxsplit=1))

    def text_after(self, word: str) -> str | None:
        """Return the rest of a line after its first word; None if it was not written."""
        for first, *rest in list(self.lines):
            if first == word:
                return rest[0].strip() if rest else ""
        return None

    def write_line(self, text: str) -> None:
        """Write a line to the program's input."""
        assert self.process.stdin is not None
        with contextlib.suppress(BrokenPipeError):
            self.process.stdin.write(text + "\n")
            self.process.stdin.flush()

    def close_input(self) -> None:
        """Close the program's input."""
        assert self.process.stdin is not None
        with contextlib.suppress(BrokenPipeError):
            self.process.stdin.close()


def wait_for(condition: Callable[[], bool], seconds: float, what: str) -> None:
    """Wait for a condition; exit with a sentence if it does not come true in time."""
    end = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > end:
            raise SystemExit(f"{what}: not within {seconds:.0f} s")
        time.sleep(0.02)


def mac_address_of_station(number: int) -> str:
    """The address that ns-3 gives a station, and so its TAP."""
    return f"00:00:00:00:00:{number:02x}"


def number_of_stations(job: dict[str, Any]) -> int:
    """Return the number of robots, and of one wired host if the server is not on a robot."""
    return int(job["hosts"]) + int(job["server"] == "wired")


def build_station(number: int, stations: int) -> int:
    """Move a TAP into new namespaces of a host; return the process id of their holder."""
    pid = create_namespaces(number)
    run_command(f"ip link set tap{number} netns {pid}")
    run_command(f"ip link set tap{number} name eth0", pid)
    # The station's queue may overflow; the TAP's queue must not.
    address = mac_address_of_station(number)
    run_command(f"ip link set eth0 address {address} txqueuelen 20000", pid)
    raise_interface(pid, number)
    for other in range(1, stations + 1):  # no ARP, which the simulator does not have either
        if other != number:
            neighbor = f"10.77.0.{other} lladdr {mac_address_of_station(other)}"
            run_command(f"ip neigh replace {neighbor} nud permanent dev eth0", pid)
    return pid


def drops_by_kernel(holders: dict[int, int]) -> dict[str, int]:
    """Return the number of packets that TAPs and sockets of all hosts have dropped."""
    found = {"tap_dropped": 0, "socket_dropped": 0}
    for pid in holders.values():
        inside = ["nsenter", f"--target={pid}", "--net"]
        link = subprocess.check_output([*inside, "ip", "-s", "-j", "link", "show", "dev", "eth0"])
        found["tap_dropped"] += json.loads(link)[0]["stats64"]["tx"]["dropped"]
        snmp = Path(f"/proc/{pid}/net/snmp").read_text().splitlines()
        names, values = (line.split() for line in snmp if line.startswith("Udp:"))
        found["socket_dropped"] += int(dict(zip(names, values, strict=True))["RcvbufErrors"])
    return found


def start_cell(job: dict[str, Any], out: Path, clock: SlowClock, clean: dict[str, str]) -> Program:
    """Create TAPs and start ns-3, which opens them."""
    disable_ipv6()
    run_command("ip link set lo up")
    MEMORY.mkdir(exist_ok=True)
    run_command(f"mount -t tmpfs air {MEMORY}")
    for number in range(1, number_of_stations(job) + 1):
        run_command(f"ip tuntap add tap{number} mode tap")
        run_command(f"ip link set tap{number} address {mac_address_of_station(number)} up")
    options = {
        "hosts": job["hosts"],
        "wired": int(job["server"] == "wired"),
        "standard": job["standard"],
        "ampdu": MAX_AMPDU_BYTES * int(job["ampdu"]),
        "queue_frames": job["queue_frames"],
        "seed": job["number"],
        "pcap": out.with_suffix(".pcap"),
        "in_flight": IN_FLIGHT,
    }
    slow = {"LD_PRELOAD": str(BENCH / "slow_clock.so")} | clock.environment()
    cell = Program(
        # ns-3 is late on a busy machine without a real-time priority.
        ["chrt", "--rr", "1", str(BENCH / "cell"), *(f"--{k}={v}" for k, v in options.items())],
        clean | slow,
        out.with_suffix(".cell.log").open("w"),
    )
    wait_for(lambda: cell.text_after("open") is not None, EXTRA_WAIT, "ns-3 opens its TAPs")
    return cell


def start_process(
    job: dict[str, Any], out: Path, holder: int, words: tuple[int, ...], slow: dict[str, str]
) -> Program:
    """Start a process of the middleware inside a host."""
    preloads = [str(BENCH / "slow_clock.so")]
    if job["sender"] == "waits":
        preloads.append(str(BENCH / "sender_waits.so"))
    preloads += job["preload"]
    environment = slow | job["env"]
    environment |= {"LD_PRELOAD": " ".join(preloads)}
    environment |= {"AIR_IN_FLIGHT": str(IN_FLIGHT), "AIR_HOST": str(words[0])}
    inside = ["nsenter", f"--target={holder}", "--net", "--mount", "nice", "-n", "-8"]
    return Program(
        [*inside, *job["command"], *map(str, words)],
        environment,
        out.with_suffix(f".{words[0]}.{words[1]}.log").open("w"),
    )


def start_server(job: dict[str, Any], out: Path, holder: int, slow: dict[str, str]) -> Program:
    """Start a Discovery Server on a host."""
    environment = slow | {"LD_PRELOAD": str(BENCH / "slow_clock.so"), "RMW": job["env"]["RMW"]}
    inside = ["nsenter", f"--target={holder}", "--net", "--mount", "nice", "-n", "-8"]
    return Program(
        [*inside, *job["server_command"]], environment, out.with_suffix(".server.log").open("w")
    )


def times_of_line(programs: list[Program], word: str) -> list[float]:
    """Return when each program has written a line [s]."""
    return [float(text) for one in programs if (text := one.text_after(word)) is not None]


def endpoint_discovery_times(programs: list[Program]) -> list[float]:
    """Return when each program learned of each endpoint of others [s]."""
    wait_for(
        lambda: all(one.text_after("learned") is not None for one in programs),
        EXTRA_WAIT,
        "processes end",
    )
    return [float(text) for one in programs for text in (one.text_after("learned") or "").split()]


def wait_for_discovery(
    programs: list[Program], clock: SlowClock, end: float, after: float = TIME_AFTER_DISCOVERY
) -> float:
    """Wait until all programs know all endpoints, and ``after`` more; return the time [s]."""
    complete_at = None
    while (now := clock.now()) < min(end, (complete_at or end) + after):
        if complete_at is None and len(times_of_line(programs, "complete")) == len(programs):
            complete_at = now
        if dead := [one for one in programs if one.process.poll() is not None]:
            raise SystemExit(f"{len(dead)} processes ended with {dead[0].process.returncode}")
        time.sleep(0.02)
    return now


def run_discovery(job: dict[str, Any], out: Path) -> dict[str, Any]:
    """Start the cell and all processes, wait until discovery is complete; return the results."""
    begun, clock = time.monotonic(), SlowClock(float(job["factor"]))
    clean = {"PATH": os.environ["PATH"]}
    cell = start_cell(job, out, clock, clean)
    hosts, processes = job["hosts"], job["processes"]
    stations = number_of_stations(job)
    holders = {number: build_station(number, stations) for number in range(1, stations + 1)}
    patience = EXTRA_WAIT + 3 * clock.factor
    wait_for(lambda: cell.text_after("associated") is not None, patience, "all stations associate")
    total = (hosts * processes - 1) * job["endpoints"]
    slow = clean | clock.environment()
    words = [(host, number) for host in range(1, hosts + 1) for number in range(1, processes + 1)]
    if job["start"] == "reboot":  # the last robot's processes, once more
        words += words[-processes:]
    everyone = [
        start_process(job, out, holders[one[0]], (*one, job["endpoints"], total), slow)
        for one in words
    ]
    programs, rebooted = everyone[: hosts * processes], everyone[hosts * processes :]
    wait_for(
        lambda: all(one.text_after("ready") for one in everyone),
        EXTRA_WAIT,
        "all processes are ready",
    )
    if job["server"]:
        start_server(job, out, holders[stations if job["server"] == "wired" else 1], slow)
        time.sleep(SERVER_HEAD_START * clock.factor)
    before = drops_by_kernel(holders)
    cell.write_line("begin")
    wait_for(lambda: cell.text_after("begun") is not None, patience, "ns-3 begins to count")
    start = clock.now() + START_DELAY / clock.factor
    window = float(job["start"]) if job["start"] not in ("", "reboot") else 0.0
    starts = [start + window * (host - 1) / hosts for host, _ in words]
    for one, at in zip(programs, starts, strict=False):
        one.write_line(f"{at:.6f}")
    ended = wait_for_discovery(programs, clock, max(starts) + job["seconds"])
    pairs = total * len(programs)
    if rebooted:
        for one in programs[-processes:]:
            one.process.kill()
        programs = programs[:-processes]
        start = ended + REBOOT_TIME
        starts[-processes:] = [start] * processes
        for one in rebooted:
            one.write_line(f"{start:.6f}")
        wait_for(lambda: clock.now() > start, patience, "the restart")
        # The other programs report at the end only, so the run lasts for its whole time.
        ended = wait_for_discovery(rebooted, clock, start + job["seconds"], job["seconds"])
        programs += rebooted
        pairs = processes * total + (hosts - 1) * processes * processes * job["endpoints"]
    dropped = {name: now - before[name] for name, now in drops_by_kernel(holders).items()}
    cell.write_line("stop")
    wait_for(lambda: cell.text_after("counts") is not None, patience, "ns-3 reports its counts")
    for one in programs:
        one.close_input()
    begins = times_of_line(everyone, "begin")
    return {
        "pairs": pairs,
        "learned": sorted(at - start for at in endpoint_discovery_times(programs) if at > start),
        "ran_s": round(ended - start, 3),
        "late_s": max(at - due for at, due in zip(begins, starts, strict=True)),
        "made_s": max(
            (
                made - at
                for made, at in zip(times_of_line(everyone, "endpoints"), starts, strict=False)
            ),
            default=float(job["seconds"]),
        ),
        "participants_dropped": sum(
            words[0] == "dropped" for one in programs for words in list(one.lines)
        ),
        "wall_s": round(time.monotonic() - begun, 1),
        **dropped,
        **json.loads(cell.text_after("counts") or ""),
    }


def main() -> None:
    job = json.loads(sys.argv[1])
    out = Path(job["out"])
    result = run_discovery(job, out)
    out.with_suffix(".json").write_text(json.dumps(job | result, indent=1, sort_keys=True) + "\n")
    for path in out.parent.glob(f"{out.name}.*.log"):
        if not path.stat().st_size:
            path.unlink()


if __name__ == "__main__":
    main()
