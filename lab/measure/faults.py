"""Capture fleets of real middleware with one fault each.

Each run is its own process tree, as in run_grid.py. `grids/faults.csv` lists the faults;
`fault_findings.py` writes the diagnosis of the captures.
"""

import argparse
import csv
import gzip
import json
import struct
import sys
from pathlib import Path
from typing import Any

from failures import CYCLONE_DDS as WATCH_CYCLONE, FAST_DDS as WATCH_FAST, ZENOH as WATCH_ZENOH
from run_grid import (
    BUILD,
    CYCLONE_DDS,
    DISCOVERY_SERVER,
    FAST_DDS,
    GRIDS,
    IN_NEW_NAMESPACES,
    MEASURE,
    ZENOH,
    ZENOH_ROUTER,
    run_in_parallel,
    run_lab_program,
)

STAGE = [*IN_NEW_NAMESPACES, str(MEASURE / "fault_run.py")]
SPACING, MAX_PARALLEL_PROCESSES = 1.0, 24
SERVER = 101  # host of the server or router
MAX_PROCESS_NUMBER = 9
ACCEPT_LOOPBACK = "iif lo accept"
MATCH_UNICAST = "ip daddr != 224.0.0.0/4"
MATCH_UDP_AND_TCP = "meta l4proto { udp, tcp }"
#: A firewall that blocks incoming packets, except those of connections opened from inside.
FIREWALL = [ACCEPT_LOOPBACK, "meta l4proto udp drop", "tcp flags & (syn | ack) == syn drop"]
Step = dict[str, Any]
Job = dict[str, Any]


def ip_address(host: int) -> str:
    return f"10.77.0.{host}"


def timed_action(at: float, do: str, what: Any = None) -> Step:
    return {"at": at, "do": do, "what": what}


def drop_packets_step(at: float, hosts: list[int], *lines: str) -> Step:
    return timed_action(at, "rules", {"hosts": hosts, "drop": [ACCEPT_LOOPBACK, *lines]})


def drop_randomly(percent: int) -> str:
    return f"{MATCH_UDP_AND_TCP} numgen random mod 100 < {percent} drop"


def process_command(job: Job, host: int, number: int) -> dict[str, Any]:
    """Return the program of a process: a program that logs matches, or one with endpoints."""
    product, _, configuration = job["product"].partition("-")
    env: dict[str, str] = {}
    endpoints, seconds = int(job["endpoints"]), float(job["seconds"])
    fast = product == "fast_dds"
    if fast and configuration == "server":
        env["ROS_DISCOVERY_SERVER"] = f"{ip_address(SERVER)}:11811"
    if product.startswith("cyclone") and job["ill"] != "healthy":
        # As on Wi-Fi, where Cyclone DDS multicasts only participant announcements.
        env["CYCLONEDDS_URI"] = "<General><AllowMulticast>spdp</AllowMulticast></General>"
    if job["ill"] == "two domains" and host % 2 == 0:
        env |= {"ROS_DOMAIN_ID": "7"} if fast else {}
        if not fast:
            env["CYCLONEDDS_URI"] += "<Discovery><ExternalDomainId>7</ExternalDomainId></Discovery>"
    if job["ill"] == "wrong interface" and host == 2 and not fast:
        env["CYCLONEDDS_URI"] = (
            "<General><AllowMulticast>spdp</AllowMulticast>"
            "<ExternalNetworkAddress>172.17.0.1</ExternalNetworkAddress></General>"
        )
    if endpoints:
        command = {"fast_dds": FAST_DDS, "cyclone_dds_0.10": CYCLONE_DDS}.get(product, ZENOH)
        variant = "tokens" if command is ZENOH else "udp"
        arguments = [
            f"{seconds + 60:g}",
            str(host),
            str(number),
            str(endpoints),
            "matching",
            variant,
        ]
        return {"host": host, "command": [*command, *arguments], "env": env, "waits": True}
    settings: dict[str, Any] = {}
    if product == "zenoh":
        settings = {"mode": "client", "connect/endpoints": [f"tcp/{ip_address(SERVER)}:7447"]}
    zenoh = [*WATCH_ZENOH, str(host), str(MAX_PROCESS_NUMBER), json.dumps(settings)]
    commands = {
        "fast_dds": [WATCH_FAST, str(host)],
        "cyclone_dds_0.10": [WATCH_CYCLONE, str(host)],
    }
    return {"host": host, "command": commands.get(product, zenoh), "env": env, "waits": False}


def server_command(job: Job) -> dict[str, Any]:
    """Return the program of the server or router."""
    command = [word.replace("HOST", str(SERVER)) for word in ZENOH_ROUTER]
    if job["product"].startswith("fast"):
        command = [DISCOVERY_SERVER, "-i", "0", "-l", ip_address(SERVER), "-p", "11811"]
    return {"host": SERVER, "command": command, "env": {}, "waits": False}


#: Faults that exist from the start: affected hosts and firewall rules, by name.
def firewall_rules(fault: str, hosts: list[int]) -> list[Step]:
    others = [host for host in hosts if host != 2]
    from_second, from_all = f"ip saddr {ip_address(2)}", "ip saddr 10.77.0.0/24"
    known: dict[str, list[Step]] = {
        "multicast filtered": [drop_packets_step(0, hosts, "ip daddr 224.0.0.0/4 drop")],
        "firewall on one host": [drop_packets_step(0, [2], *FIREWALL[1:])],
        "firewall on all hosts": [drop_packets_step(0, hosts, *FIREWALL[1:])],
        "loss of 5 %": [drop_packets_step(0, hosts, drop_randomly(5))],
        "loss of 20 %": [drop_packets_step(0, hosts, drop_randomly(20))],
        "one direction of a host": [drop_packets_step(0, others, f"{from_second} drop")],
        "one direction of a pair": [
            drop_packets_step(0, [3], f"{from_second} {MATCH_UDP_AND_TCP} drop")
        ],
        "client isolation": [drop_packets_step(0, hosts, f"{from_all} {MATCH_UNICAST} drop")],
        "client isolation but for one": [
            drop_packets_step(0, hosts[1:], f"ip saddr != {ip_address(1)} {MATCH_UNICAST} drop")
        ],
        "storm without end": [
            drop_packets_step(
                0, hosts, f"{MATCH_UDP_AND_TCP} limit rate over 25/second burst 5 packets drop"
            )
        ],
        "other subnet": [
            timed_action(
                0,
                "run",
                {
                    "host": 2,
                    "commands": [
                        "ip address flush dev eth0",
                        "ip address add 10.78.0.2/24 brd + dev eth0",
                        "ip route add 224.0.0.0/4 dev eth0",
                    ],
                },
            ),
            *(
                timed_action(
                    0,
                    "run",
                    {
                        "host": host,
                        "commands": ["ip route del default", "ip route add 224.0.0.0/4 dev eth0"],
                    },
                )
                for host in others
            ),
        ],
    }
    return known.get(fault, [])


def programs_and_steps(job: Job) -> Job:
    """Return programs and steps of a run."""
    fault, hosts = job["ill"], list(range(1, int(job["hosts"]) + 1))
    end = float(job["seconds"])
    served = "-" in job["product"]
    programs = {
        f"{host}" if number == 1 else f"{host}.{number}": process_command(job, host, number)
        for host in hosts
        for number in range(1, int(job["processes"]) + 1)
    }
    seen_by = int(job.get("seen_by") or 0)
    if fault == "view of one robot":
        seen_by = 2
    where: dict[str, Any] = {"host": seen_by} if seen_by else {}
    if fault == "capture filter":
        where["filter"] = "udp port 7446" if "zenoh" in job["product"] else "udp port 7400"
    begin = 12.0 if fault == "capture began late" else 0.1
    steps = [*firewall_rules(fault, hosts), timed_action(begin, "capture", where)]
    if served:
        programs["server"] = server_command(job)
        if fault != "server never there":
            steps.append(timed_action(0.2, "start", "server"))
    first = 1.5
    steps += [timed_action(first, "start", name) for name in programs if name != "server"]
    if fault == "wrong interface" and job["product"].startswith("fast"):
        # The host starts with an address that it loses later.
        steps += [
            timed_action(
                0,
                "run",
                {
                    "host": 2,
                    "commands": [
                        "ip address flush dev eth0",
                        "ip address add 172.17.0.2/24 brd + dev eth0",
                        "ip route add default dev eth0",
                    ],
                },
            ),
            timed_action(
                first + 0.3,
                "run",
                {
                    "host": 2,
                    "commands": [
                        "ip address flush dev eth0",
                        f"ip address add {ip_address(2)}/24 brd + dev eth0",
                        "ip route add default dev eth0",
                    ],
                },
            ),
        ]
    if fault == "late joiner":
        steps = [one for one in steps if one["what"] != str(hosts[-1])]
        steps += [timed_action(14.0, "start", str(hosts[-1]))]
    if fault in ("crash", "restart"):
        steps += [timed_action(10.0, "kill", "2")]
    if fault == "restart":
        steps += [timed_action(13.0, "start", "2")]
    if fault == "crash loop":
        for at in range(5, int(end), 3):
            steps += [timed_action(at, "kill", "2"), timed_action(at + 0.5, "start", "2")]
    if fault == "leases expire":
        away = 25.0 if job["product"].startswith("fast") else 14.0
        for number in range(3):
            gone = 7.0 + number * (away + 4.0)
            steps += [timed_action(gone, "cut", 2), timed_action(gone + away, "join", 2)]
    if fault == "server dies":
        steps += [timed_action(10.0, "kill", "server")]
    steps = [one for one in steps if one["at"] < end] + [timed_action(end, "end")]
    places = sorted({one["host"] for one in programs.values()})
    return {
        "programs": programs,
        "steps": sorted(steps, key=lambda one: float(one["at"])),
        "places": places,
    }


def list_runs(grid: Path, only: list[str], runs: int | None) -> list[Job]:
    """Yield all runs: run 1 of every fault and product, then run 2."""
    with grid.open(newline="") as file:
        rows = list(csv.DictReader(file))
    found = []
    for number in range(1, (runs or max(int(row["runs"]) for row in rows)) + 1):
        for row in rows:
            if number > (runs or int(row["runs"])) or (only and row["ill"] not in only):
                continue
            name = "".join(
                c if c.isalnum() or c == "-" else "_" for c in f"{row['ill']}-{row['product']}"
            )
            if row.get("seen_by"):
                name += f"-by{row['seen_by']}-h{row['hosts']}"
            name = f"{name}-r{number}"
            size = {"hosts": int(row["hosts"]), "processes": int(row["processes"])}
            found.append(row | programs_and_steps(row) | size | {"name": name, "run": number})
    return found


def compress_capture(out: Path) -> str:
    """Compress the capture of a successful run; shift its clock if the clock is the fault."""
    job = json.loads(out.with_suffix(".json").read_text())
    pcap = out.with_suffix(".pcap")
    content = bytearray(pcap.read_bytes())
    shift = {"clock set back": -30, "clock set forward": 3600}.get(job["ill"], 0)
    at, first = 24, None
    while shift and at + 16 <= len(content):
        second, _, size = struct.unpack_from("<III", content, at)
        first = second if first is None else first
        if second >= first + 6:
            struct.pack_into("<I", content, at, second + shift)
        at += 16 + size
    with out.with_suffix(".pcap.gz").open("wb") as file:
        file.write(gzip.compress(bytes(content), mtime=0))
    pcap.unlink()
    return f"{len(content):>9,} bytes captured"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--grid", type=Path, default=GRIDS / "faults.csv", help="what to stage")
    parser.add_argument("--runs", type=int, help="runs of each staging, not those of the table")
    parser.add_argument("--only", action="append", default=[], metavar="ILL")
    parser.add_argument("--out", type=Path, default=BUILD / "ills", help="folder for the captures")
    parser.add_argument(
        "--crowd", type=int, default=MAX_PARALLEL_PROCESSES, help="processes at a time"
    )
    given = parser.parse_args()
    if not (BUILD / ".ready").exists():
        print("The lab is not set up: run it by make ills", file=sys.stderr)
        return 1
    given.out.mkdir(parents=True, exist_ok=True)
    todo = list_runs(given.grid, given.only, given.runs)
    left = [job for job in todo if not (given.out / job["name"]).with_suffix(".pcap.gz").exists()]
    print(f"{len(todo) - len(left)} of {len(todo)} runs are in {given.out} already", flush=True)
    return (
        1 if run_in_parallel(left, given.out, given.crowd, SPACING, STAGE, compress_capture) else 0
    )


if __name__ == "__main__":
    run_lab_program(main)
