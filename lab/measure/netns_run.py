"""One run of the lab on a stage of its own: hosts, a bridge between them, and tcpdump on it.

Called by run_grid.py as the first process of fresh PID, mount and network namespaces. Whatever ends
this process ends every other one in there and takes the networks away, so there is nothing to
clean up: not after a failure, not after Ctrl-C, not after a kill.
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

LEAD = 0.5  # s from the word that all are ready to their start
TAIL = 2.0  # s that tcpdump runs on, for what the kernel holds back
SERVING = 1.0  # s that servers have before anybody else runs
LATE = 0.2  # s after the agreed time; what begins later spoils a run that does not allow for it
IDLE = 0.2  # share of the start-up window that the processor has to be idle
BUSY = 12.0  # s of the start-up window
BEFORE_END = 0.3  # s before the end of the window, when all processes are still there
PATIENCE = 30.0  # s beyond its time before a program is given up
# Nothing of what configures middleware on the user's machine; the mark is of the tests.
CLEAN = {name: os.environ[name] for name in ("PATH", "DISCOSTORM_MARK") if name in os.environ}
TIME = re.compile(r"^(ready|begin|participant|endpoints|end) ([0-9.]+)$", re.MULTILINE)


def say(command: str, inside: int | None = None) -> None:
    """Run a command, in the namespaces of the process `inside` if given; fail loudly."""
    words = shlex.split(command)
    if inside is not None:
        words = ["nsenter", f"--target={inside}", "--net", "--mount", *words]
    done = subprocess.run(words, capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(f"{' '.join(words)}: {done.stderr.strip() or done.returncode}")


def quiet(inside: int | None = None) -> None:
    """No IPv6, so that nothing but the middleware talks (but ARP)."""
    for which in ("all", "default"):
        say(f"sysctl -q -w net.ipv6.conf.{which}.disable_ipv6=1", inside)


def build_host(number: int) -> int:
    """A host: network and mount namespaces with eth0 and an own /dev/shm; its holder's PID."""
    # Fast DDS 3.2 and later takes those with the same machine-id for one host.
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
    pid, port = holder.pid, f"port{number}"
    quiet(pid)
    say(f"ip link add {port} type veth peer name eth0 netns {pid}")
    say(f"ip link set {port} master br0 up")
    say(f"ip link set eth0 address 02:00:00:00:00:{number:02x}", pid)
    say(f"ip address add 10.77.0.{number}/24 brd + dev eth0", pid)
    say("ip link set lo up", pid)
    say("ip link set eth0 up", pid)
    say("ip route add default dev eth0", pid)
    # What one end would leave to the hardware, the other would see in sizes of no Ethernet.
    for end, where in ((port, None), ("eth0", pid)):
        say(f"ethtool -K {end} tso off gso off gro off tx off rx off", where)
    return pid


def build_bridge() -> None:
    """The one network of all hosts, with loopback beside it."""
    quiet()
    say("ip link set lo up")
    say("ip link add br0 type bridge stp_state 0 mcast_snooping 0 forward_delay 0")
    say("ip link set br0 address 02:00:00:00:01:00 up")


def begin_capture(
    out: Path, buffer: int, inside: int | None = None, interface: str = "", only: str = ""
) -> subprocess.Popen[bytes]:
    """Begin to capture what crosses the bridge, with a buffer of so many KiB; once it listens.

    Inside of a host: what is on any of its interfaces, or on one; all of it, or by a filter.
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


def serve(
    out: Path, inside: int, number: int, command: list[str]
) -> tuple[int, subprocess.Popen[str]]:
    """Begin what serves the others, in a host's namespaces; its number and process."""
    words = ["nsenter", f"--target={inside}", "--net", "--mount", *command]
    with out.with_suffix(f".{number}.log").open("w") as log:
        server = subprocess.Popen(
            words, stdin=subprocess.DEVNULL, stdout=log, stderr=log, text=True, env=CLEAN
        )
    return number, server


def processor() -> tuple[int, int]:
    """Return the time that no process of the lab wanted, and all time, of all processors so far.

    What others run at the lowest priority counts as idle: it makes way at once.
    """
    with Path("/proc/stat").open() as file:
        user, nice, system, idle, *others = map(int, file.readline().split()[1:8])
    return idle + nice + others[0], user + nice + system + idle + sum(others)


def taken_by_others() -> tuple[int, int]:
    """Return the time that others than this stage took, and all time, of all processors so far.

    All processes that are here are of this stage. What the kernel does for packets counts for
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
    """Return the share of the time since then that no process of the lab wanted [1]."""
    (idle, total), (idle_now, total_now) = before, processor()
    return round((idle_now - idle) / max(total_now - total, 1), 3)


def programs_of(job: dict[str, Any]) -> list[dict[str, Any]]:
    """Return host, process, endpoints, names and variant of each program, and when it begins [s].

    A job may list its programs, each with what differs, also for how long it runs (`seconds`), and
    whether it is one that starts `again`; else they are alike and begin at once.
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
    # What serves the others runs on one of the hosts, or on one of its own behind them.
    hosts = max(hosts, *(one["host"] for one in programs_of(job)))
    numbers = sorted({*range(1, hosts + 1), *(number for number, _ in job["servers"])})
    built = {number: build_host(number) for number in numbers}

    dump = begin_capture(out, 131072 if job.get("tap") else 32768, built.get(job.get("tap")))
    served = [serve(out, built[number], number, command) for number, command in job["servers"]]
    time.sleep(SERVING if served else 0)

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
            env=CLEAN | job["env"],
        )
        running.append((program, log))
    for program, _ in running:
        assert program.stdout is not None
        program.stdout.readline()  # "ready", or nothing from one that failed: see below
    start = round(time.time() + LEAD, 1)
    times = []
    for (program, _), one in zip(running, programs, strict=True):
        assert program.stdin is not None
        with contextlib.suppress(BrokenPipeError):
            program.stdin.write(f"{start + one['after']}\n")
            program.stdin.flush()
    before, others = processor(), taken_by_others()
    end = start + min(BUSY, job["seconds"])
    time.sleep(max(0.0, end - BEFORE_END - time.time()))
    taken, passed = (now - then for now, then in zip(taken_by_others(), others, strict=True))
    others_took = round(max(taken, 0) / max(passed, 1), 3)
    time.sleep(max(0.0, end - time.time()))
    idle = idle_since(before)
    if idle < job.get("idle_needed", IDLE):
        raise SystemExit(f"the processor was idle for {idle:.0%}: machine too busy")
    for (program, errors), one in zip(running, programs, strict=True):
        begin = start + one["after"]
        try:
            lines, _ = program.communicate(timeout=job["seconds"] + PATIENCE)
        except subprocess.TimeoutExpired:
            raise SystemExit(f"{program_name} does not end") from None
        with errors:
            if program.returncode:
                errors.seek(0)
                raise SystemExit(f"{program_name} ended with {program.returncode}: {errors.read()}")
            errors.write("".join(line for line in lines.splitlines(True) if not TIME.match(line)))
        times.append({what: float(when) for what, when in TIME.findall(lines)})
        late = job.get("late", LATE)
        if "begin" not in times[-1] or not 0 <= times[-1]["begin"] - begin < late:
            raise SystemExit(f"a process began at {times[-1]}, not at {begin}: machine too busy")
    time.sleep(job.get("tail", TAIL))
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
