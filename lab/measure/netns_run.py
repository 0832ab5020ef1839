"""One run of the lab in its own namespaces: hosts, a bridge between them, and tcpdump.

run_grid.py starts this script as the first process of new PID, mount and network namespaces. When
this process ends, for whatever reason, the kernel ends all others in there and removes the
networks. So there is nothing to clean up after a failure, Ctrl-C or a kill.
"""

import contextlib
import json
import os
import re
import resource
import shlex
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import IO, Any

START_DELAY = 0.5  # s from readiness of all processes to their start
CAPTURE_TAIL = 2.0  # s that tcpdump continues, to write packets that the kernel buffers
SERVER_HEAD_START = 1.0  # s by which servers start before all others
MAX_START_DELAY = (
    0.2  # s; a process that starts later after the agreed time spoils a run without `late`
)
MIN_IDLE_SHARE = 0.2  # share of the startup window in which the processor must be idle
STARTUP_WINDOW = 12.0  # s of the startup window
BEFORE_END = 0.3  # s before the end of the window, when all processes must still run
EXTRA_WAIT = 30.0  # s beyond its time after which a program is abandoned
# Drop variables that configure middleware on the user's machine; tests need the mark.
CLEAN_ENVIRONMENT = {
    name: os.environ[name] for name in ("PATH", "DISCOSTORM_MARK") if name in os.environ
}
LOGGED_TIME = re.compile(r"^(ready|begin|participant|endpoints|end) ([0-9.]+)$", re.MULTILINE)


def run_command(command: str, inside: int | None = None) -> None:
    """Run a command, optionally in the namespaces of process `inside`; exit if it fails."""
    words = shlex.split(command)
    if inside is not None:
        words = ["nsenter", f"--target={inside}", "--net", "--mount", *words]
    done = subprocess.run(words, capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(f"{' '.join(words)}: {done.stderr.strip() or done.returncode}")


def disable_ipv6(inside: int | None = None) -> None:
    """Disable IPv6, so that only the middleware and ARP send packets."""
    for which in ("all", "default"):
        run_command(f"sysctl -q -w net.ipv6.conf.{which}.disable_ipv6=1", inside)


def create_namespaces(number: int) -> int:
    """The process id that holds the namespaces of a new host, with a separate /dev/shm."""
    # Fast DDS 3.2 and later treats hosts with equal machine-id as one host.
    own = f"echo {number:032x} > /dev/shm/.id && mount --bind /dev/shm/.id /etc/machine-id"
    shell = f"mount -t tmpfs shm /dev/shm && {{ [ ! -e /etc/machine-id ] || {{ {own}; }}; }}"
    shell += " && echo ready && exec sleep infinity"
    holder = subprocess.Popen(
        ["unshare", "--net", "--mount", "sh", "-c", shell],
        stdout=subprocess.PIPE,
        text=True,
    )
    assert holder.stdout is not None
    if holder.stdout.readline() != "ready\n":
        raise SystemExit(f"host {number}: no namespaces of its own (is this root?)")
    disable_ipv6(holder.pid)
    return holder.pid


def raise_interface(inside: int, number: int) -> None:
    """Give eth0 of a host its address and the default route."""
    run_command(f"ip address add 10.77.0.{number}/24 brd + dev eth0", inside)
    run_command("ip link set lo up", inside)
    run_command("ip link set eth0 up", inside)
    run_command("ip route add default dev eth0", inside)


def build_host(number: int) -> int:
    """Create a host's namespaces with eth0 and /dev/shm; return the process id of their holder."""
    pid, port = create_namespaces(number), f"port{number}"
    run_command(f"ip link add {port} type veth peer name eth0 netns {pid}")
    run_command(f"ip link set {port} master br0 up")
    run_command(f"ip link set eth0 address 02:00:00:00:00:{number:02x}", pid)
    raise_interface(pid, number)
    # Disable offloading, which would show frames longer than Ethernet allows.
    for end, where in ((port, None), ("eth0", pid)):
        run_command(f"ethtool -K {end} tso off gso off gro off tx off rx off", where)
    return pid


def build_bridge() -> None:
    """Create the bridge that connects all hosts, and its loopback interface."""
    disable_ipv6()
    run_command("ip link set lo up")
    run_command("ip link add br0 type bridge stp_state 0 mcast_snooping 0 forward_delay 0")
    run_command("ip link set br0 address 02:00:00:00:01:00 up")


def begin_capture(
    out: Path, buffer: int, inside: int | None = None, interface: str = "", only: str = ""
) -> subprocess.Popen[bytes]:
    """Start tcpdump with a buffer [KiB], and return when it captures.

    Inside a host, it captures one interface or all, with a filter or without.
    """
    capture, report = out.with_suffix(".pcap"), out.with_suffix(".tcpdump")
    interface = interface or ("any" if inside else "br0")
    flags = shlex.split(f"-i {interface} -n -s 0 -B {buffer} -Z root")
    where = ["nsenter", f"--target={inside}", "--net"] if inside else []
    with report.open("w") as stderr:
        dump = subprocess.Popen(
            [*where, "tcpdump", *flags, "-w", capture, *([only] * bool(only))], stderr=stderr
        )
    for _ in range(500):
        if "listening on" in report.read_text():
            return dump
        time.sleep(0.01)
    raise SystemExit(f"tcpdump does not listen: {report.read_text()}")


def end_capture(out: Path, dump: subprocess.Popen[bytes]) -> None:
    """End the capture; fail if packets are missing."""
    report = out.with_suffix(".tcpdump")
    dump.send_signal(signal.SIGINT)
    dump.wait()
    text = report.read_text()
    if "\n0 packets dropped by kernel" not in text:
        raise SystemExit(f"tcpdump has lost packets: {text}")
    report.unlink()


def start_server(
    out: Path, inside: int, number: int, command: list[str]
) -> tuple[int, subprocess.Popen[str]]:
    """Start a server or router in a host's namespaces; return its number and process."""
    words = ["nsenter", f"--target={inside}", "--net", "--mount", *command]
    with out.with_suffix(f".{number}.log").open("w") as log:
        server = subprocess.Popen(
            words,
            stdin=subprocess.DEVNULL,
            stdout=log,
            stderr=log,
            text=True,
            env=CLEAN_ENVIRONMENT,
        )
    return number, server


def processor_times() -> tuple[int, int]:
    """Return idle time and total time of all processors so far [ticks].

    Processes of the lowest priority count as idle, because they yield at once.
    """
    with Path("/proc/stat").open() as file:
        user, nice, system, idle, *others = map(int, file.readline().split()[1:8])
    return idle + nice + others[0], user + nice + system + idle + sum(others)


def busy_time_of_others() -> tuple[int, int]:
    """Return the time that other programs used, and total time, of all processors [ticks].

    All processes in this namespace belong to the run. The kernel's work for packets counts for
    nobody.
    """
    with Path("/proc/stat").open() as file:
        user, nice, system, *others = map(int, file.readline().split()[1:9])
    own = 0
    for path in Path("/proc").glob("[0-9]*/stat"):
        with contextlib.suppress(OSError):
            own += sum(map(int, path.read_text().rpartition(")")[2].split()[11:13]))
    steal = others[-1]
    return user + nice + system + steal - own, user + nice + system + sum(others)


def idle_since(before: tuple[int, int]) -> float:
    """Return the idle share of the processors since an earlier measurement [1]."""
    (idle, total), (idle_now, total_now) = before, processor_times()
    return round((idle_now - idle) / max(total_now - total, 1), 3)


def programs_of(job: dict[str, Any]) -> list[dict[str, Any]]:
    """Return the programs of a job. Fields: host, process, endpoints, names, variant, start [s].

    A job may list its programs with their differences, such as run time (`seconds`) or a restart
    (`again`); otherwise all programs are equal and start at once.
    """
    alike = {"endpoints": job.get("endpoints"), "names": job["names"]}
    alike |= {"variant": job["variant"], "after": 0.0}
    some = job.get("programs") or [
        {"host": host, "process": process}
        for host in range(1, job["hosts"] + 1)
        for process in range(1, job["processes"] + 1)
    ]
    return [alike | one for one in some]


def main() -> None:
    job = json.loads(sys.argv[1])
    out = Path(job["out"])
    hosts = job["hosts"]
    program_name = Path(job["command"][-1]).name
    build_bridge()
    # Servers run on one of the hosts, or on a wired host of their own.
    hosts = max(hosts, *(one["host"] for one in programs_of(job)))
    numbers = sorted({*range(1, hosts + 1), *(number for number, _ in job["servers"])})
    built = {number: build_host(number) for number in numbers}

    dump = begin_capture(out, 131072 if job.get("tap") else 32768, built.get(job.get("tap")))
    served = [
        start_server(out, built[number], number, command) for number, command in job["servers"]
    ]
    time.sleep(SERVER_HEAD_START if served else 0)

    running: list[tuple[subprocess.Popen[str], IO[str]]] = []
    programs = programs_of(job)
    for one in programs:
        host, process = one["host"], one["process"]
        command = [
            *("nsenter", f"--target={built[host]}", "--net", "--mount", *job["command"]),
            str(one.get("seconds", job["seconds"] - one["after"])),
            *(str(host), str(process), str(one["endpoints"])),
            *(one["names"], one["variant"]),
        ]
        again = ".again" * one.get("again", False)
        log = out.with_suffix(f".{host}.{process}{again}.log").open("w+")
        program = subprocess.Popen(
            command,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=log,
            text=True,
            env=CLEAN_ENVIRONMENT | job["env"],
        )
        running.append((program, log))
    for program, _ in running:
        assert program.stdout is not None
        program.stdout.readline()  # "ready", or nothing if the program failed: see below
    start = round(time.time() + START_DELAY, 1)
    times = []
    for (program, _), one in zip(running, programs, strict=True):
        assert program.stdin is not None
        with contextlib.suppress(BrokenPipeError):
            program.stdin.write(f"{start + one['after']}\n")
            program.stdin.flush()
    before, others = processor_times(), busy_time_of_others()
    end = start + min(STARTUP_WINDOW, job["seconds"])
    time.sleep(max(0.0, end - BEFORE_END - time.time()))
    taken, passed = (now - then for now, then in zip(busy_time_of_others(), others, strict=True))
    others_took = round(max(taken, 0) / max(passed, 1), 3)
    time.sleep(max(0.0, end - time.time()))
    idle = idle_since(before)
    if idle < job.get("idle_needed", MIN_IDLE_SHARE):
        raise SystemExit(f"the processor was idle for {idle:.0%}: machine too busy")
    for (program, errors), one in zip(running, programs, strict=True):
        begin = start + one["after"]
        try:
            lines, _ = program.communicate(timeout=job["seconds"] + EXTRA_WAIT)
        except subprocess.TimeoutExpired:
            raise SystemExit(f"{program_name} does not end") from None
        with errors:
            if program.returncode:
                errors.seek(0)
                raise SystemExit(f"{program_name} ended with {program.returncode}: {errors.read()}")
            errors.write(
                "".join(line for line in lines.splitlines(True) if not LOGGED_TIME.match(line))
            )
        times.append({what: float(when) for what, when in LOGGED_TIME.findall(lines)})
        late = job.get("late", MAX_START_DELAY)
        if "begin" not in times[-1] or not 0 <= times[-1]["begin"] - begin < late:
            raise SystemExit(f"a process began at {times[-1]}, not at {begin}: machine too busy")
    time.sleep(job.get("tail", CAPTURE_TAIL))
    for number, server in served:
        if server.poll() is not None:
            raise SystemExit(f"the server on host {number} ended with {server.returncode}")
    end_capture(out, dump)
    spent = resource.getrusage(resource.RUSAGE_CHILDREN)
    job |= {"start": start, "times": times, "idle": idle, "others": others_took}
    job |= {"cpu_s": round(spent.ru_utime + spent.ru_stime, 3)}
    out.with_suffix(".json").write_text(json.dumps(job, indent=1, sort_keys=True) + "\n")
    for path in out.parent.glob(f"{out.name}.*.log"):
        if not path.stat().st_size:
            path.unlink()


if __name__ == "__main__":
    main()
