"""Kill servers, routers and robots of real middleware, and log the consequences.

Each run is its own process tree, as in run_grid.py: when this program ends, for whatever reason,
the kernel ends all others. Existing runs are not repeated. See README.md.
"""

import argparse
import json
import os
import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from math import inf
from pathlib import Path
from typing import Any

from failure_log import evaluate, read_log
from lab_data import BOOK, write_table
from run_grid import (
    BUILD,
    IN_NEW_NAMESPACES,
    MEASURE,
    PROGRAMS,
    PYTHON,
    installed_version,
    run_in_parallel,
    run_lab_program,
)

from discostorm.protocols.defaults import defaults

STAGE = [*IN_NEW_NAMESPACES, str(MEASURE / "failure_run.py")]
COLUMNS = ["configuration", "event", "run", "phase", "who", "quantity"]
COLUMNS += ["since_s", "watched_s", "seconds"]
RUNS = 5
# Number of runs where runs end differently.
MORE_RUNS = {("Fast DDS Discovery Server", "server restarts"): 25}
SPACING = 1.0  # s between the starts of runs
MAX_PARALLEL_HOSTS = 70  # maximum number of hosts over all runs, which mostly wait

ROBOTS = range(1, 6)
FIRST_SERVER_HOST, SECOND_SERVER_HOST = 8, 9  # hosts of servers that run on no robot
MAX_PROCESS_NUMBER = 9  # largest number of a process

FAST_DDS = str(BUILD / "bin" / "watch_fast_dds")
CYCLONE_DDS = str(BUILD / "bin" / "watch_cyclone_dds")
ZENOH = (str(PYTHON), str(PROGRAMS / "watch_zenoh.py"))

#: A command with its environment.
Program = tuple[list[str], dict[str, str]]


def ip_address(host: int) -> str:
    return f"10.77.0.{host}"


def fast_dds_client(*servers: int) -> Callable[[int], Program]:
    addresses = ";".join(f"{ip_address(host)}:11811" for host in servers)
    env = {"ROS_DISCOVERY_SERVER": addresses} if servers else {}
    return lambda number: ([FAST_DDS, str(number)], env)


def fast_discovery_server(number: int, host: int) -> Program:
    return (["fast-discovery-server", "-p", "11811", "-i", str(number), "-l", ip_address(host)], {})


def fast_discovery_server_with_backup(number: int, host: int) -> Program:
    """Return a server that stores its state in a file in its working folder, the host's memory."""
    command, env = fast_discovery_server(number, host)
    return (["sh", "-c", f"cd /dev/shm && exec {' '.join(command)} -b"], env)


def cyclone_dds_process(number: int) -> Program:
    return ([CYCLONE_DDS, str(number)], {})


def zenoh_session(**settings: Any) -> Callable[[int], Program]:
    """Return the program of a Zenoh session with settings that differ from the shipped ones."""
    named = {name.replace("__", "/"): value for name, value in settings.items()}
    text = json.dumps(named, sort_keys=True)
    return lambda number: ([*ZENOH, str(number), str(MAX_PROCESS_NUMBER), text], {})


def zenoh_router(*others: int, **settings: Any) -> Program:
    own: dict[str, Any] = {"mode": "router", "listen__endpoints": ["tcp/0.0.0.0:7447"]}
    if others:
        own["connect__endpoints"] = [f"tcp/{ip_address(host)}:7447" for host in others]
    return zenoh_session(**own, **settings)(0)


# Settings of rmw_zenoh that differ from Zenoh's defaults and matter here, without the IPv6 address
# on which routers listen.
RMW_ZENOH_DEFAULTS = defaults("rmw_zenoh")
RMW_BOTH = {
    "scouting__multicast__enabled": False,
    "transport__link__tx__lease": int(1000 * RMW_ZENOH_DEFAULTS["lease"]),
    "transport__link__tx__keep_alive": int(RMW_ZENOH_DEFAULTS["keep_alives"]),
}
RMW_SESSION = zenoh_session(
    mode="peer",
    connect__endpoints=["tcp/127.0.0.1:7447"],
    listen__endpoints=["tcp/127.0.0.1:0"],
    scouting__gossip__target={"router": ["router", "peer"], "peer": ["router"]},
    **RMW_BOTH,
)


def rmw_zenoh_router(*others: int) -> Program:
    return zenoh_router(*others, routing__router__peers_failover_brokering=False, **RMW_BOTH)


@dataclass(frozen=True)
class Configuration:
    """A discovery configuration: programs of clients and servers, and the lease.

    `client` returns the program of a process by its number, `servers` holds the programs of server
    hosts, `lease` is the lease [s].
    """

    product: str
    client: Callable[[int], Program]
    servers: dict[int, Program]
    lease: float
    what: str
    events: tuple[str, ...]


ROBOT_EVENTS = ("robot killed", "robot cut off")
SERVER_EVENTS = ("server killed", "server cut off", "server restarts")
#: Duration of a server's outage, and start of a process after the outage begins [s].
OUTAGES = {3: 1.0, 10: 3.0, 25: 3.0, 50: 3.0}
#: Suffix of outages in which an existing process restarts; in others, a late joiner starts.
ROBOT_RESTARTS = ", robot restarts"
OUTAGE_EVENTS = (
    *(f"outage of {seconds} s" for seconds in OUTAGES),
    f"outage of 10 s{ROBOT_RESTARTS}",
)
SECONDS_AFTER_OUTAGE = 60.0  # s of observation after the server's return: three leases
CONFIGURATIONS = {
    "Fast DDS": Configuration(
        *("fast_dds", fast_dds_client(), {}, defaults("Fast DDS")["lease"]),
        "no server, as shipped",
        ROBOT_EVENTS,
    ),
    "Cyclone DDS": Configuration(
        *("cyclone_dds_0.10", cyclone_dds_process, {}, defaults("Cyclone DDS")["lease"]),
        "no server, as shipped",
        ROBOT_EVENTS,
    ),
    "Zenoh peer": Configuration(
        *("zenoh_peer", zenoh_session(), {}, defaults("Zenoh")["lease"]),
        "no router, as shipped",
        ROBOT_EVENTS,
    ),
    "Fast DDS Discovery Server": Configuration(
        *(
            "fast_dds",
            fast_dds_client(FIRST_SERVER_HOST),
            {FIRST_SERVER_HOST: fast_discovery_server(0, FIRST_SERVER_HOST)},
        ),
        defaults("Fast DDS")["lease"],
        "a server on a host of its own",
        (*SERVER_EVENTS, "server and robot killed", *ROBOT_EVENTS),
    ),
    "Fast DDS Discovery Server, two": Configuration(
        "fast_dds",
        fast_dds_client(FIRST_SERVER_HOST, SECOND_SERVER_HOST),
        {
            FIRST_SERVER_HOST: fast_discovery_server(0, FIRST_SERVER_HOST),
            SECOND_SERVER_HOST: fast_discovery_server(1, SECOND_SERVER_HOST),
        },
        defaults("Fast DDS")["lease"],
        "two servers on hosts of their own, both known to all clients",
        (*SERVER_EVENTS, "both servers killed", *ROBOT_EVENTS),
    ),
    "Zenoh router": Configuration(
        "zenoh_peer",
        zenoh_session(
            mode="client", connect__endpoints=[f"tcp/{ip_address(FIRST_SERVER_HOST)}:7447"]
        ),
        {FIRST_SERVER_HOST: zenoh_router()},
        defaults("Zenoh")["lease"],
        "clients of a router on a host of its own",
        (*SERVER_EVENTS, *ROBOT_EVENTS),
    ),
    "Zenoh router per host": Configuration(
        *("zenoh_peer", RMW_SESSION),
        {host: rmw_zenoh_router(*(other for other in ROBOTS if other != host)) for host in ROBOTS},
        RMW_ZENOH_DEFAULTS["lease"],
        "a router on each robot with the settings of rmw_zenoh, each told of all others",
        ("server killed", "server restarts", *ROBOT_EVENTS),
    ),
    "Zenoh router per host, one hub": Configuration(
        *("zenoh_peer", RMW_SESSION),
        {host: rmw_zenoh_router(*[1] * (host != 1)) for host in ROBOTS},
        RMW_ZENOH_DEFAULTS["lease"],
        "the same, but each told of that of robot 1 alone",
        ("server killed", "server restarts", "robot cut off"),
    ),
}


#: Configurations for outages: the same server without and with a state file.
CONFIGURATIONS_WITH_OUTAGES = {
    "Fast DDS Discovery Server": CONFIGURATIONS["Fast DDS Discovery Server"],
    "Fast DDS Discovery Server, backup": Configuration(
        *(
            "fast_dds",
            fast_dds_client(FIRST_SERVER_HOST),
            {FIRST_SERVER_HOST: fast_discovery_server_with_backup(0, FIRST_SERVER_HOST)},
        ),
        defaults("Fast DDS")["lease"],
        "a server on a host of its own that keeps what it knows in a file (-b)",
        OUTAGE_EVENTS,
    ),
}


def timed_action(at: float, do: str, what: object = "", phase: str = "") -> dict[str, Any]:
    return {"at": at, "do": do, "what": what} | ({"phase": phase} if phase else {})


def programs_groups_and_steps(name: str, event: str) -> dict[str, Any]:
    """Return programs, groups and steps of a run.

    Processes 1 to 3 start first, each on the robot of its number; 4 joins before the failure, 5
    after it. If routers run on robots, robot 1's router fails; 7 is a second process there from the
    start, and 8 joins there after the failure. 6 is the restarted process of robot 3.
    """
    it = (CONFIGURATIONS | CONFIGURATIONS_WITH_OUTAGES)[name]
    host = {number: number for number in ROBOTS} | {6: 3}
    groups = {"survivors": [1, 2, 3, 4], "early": [4], "newcomer": [5]}
    if set(it.servers) == set(ROBOTS) and event.startswith("server"):
        host |= {7: 1, 8: 1}
        groups |= {"survivors": [2, 3, 4], "orphans": [1, 7], "beside": [8]}
    victims = list(it.servers) if event == "both servers killed" else list(it.servers)[:1]
    steps = [timed_action(0.0, "start", f"server{place}") for place in it.servers]
    steps += [timed_action(1.0, "start", str(number)) for number in (1, 2, 3, 7) if number in host]
    steps += [timed_action(10.0, "start", "4", "well")]
    if event in OUTAGE_EVENTS:
        seconds = int(event.split()[2])
        gone, (server,) = 20.0, it.servers
        if event.endswith(ROBOT_RESTARTS):
            groups = {"survivors": [1, 2, 4], "early": [4], "dead": [3], "newcomer": [6]}
            steps += [timed_action(gone + 0.5, "kill", "3")]
        comes = str(groups["newcomer"][0])
        steps += [
            timed_action(gone, "kill", f"server{server}", "death"),
            timed_action(gone + OUTAGES[seconds], "start", comes, "newcomer"),
            timed_action(gone + seconds, "start", f"server{server}", "return"),
            timed_action(gone + seconds + SECONDS_AFTER_OUTAGE, "end", phase="end"),
        ]
    elif event in ROBOT_EVENTS:
        groups |= {"survivors": [1, 2, 4], "dead": [3], "returned": [3]}
        back = 35.0 + 1.5 * it.lease
        if event == "robot killed":
            groups["returned"] = [6]
            steps += [
                timed_action(20.0, "kill", "3", "death"),
                timed_action(back, "start", "6", "return"),
            ]
        else:
            steps += [
                timed_action(20.0, "cut", 3, "death"),
                timed_action(back, "join", 3, "return"),
            ]
        steps += [
            timed_action(25.0, "start", "5", "newcomer"),
            timed_action(back + 30.0, "end", phase="end"),
        ]
    elif event == "server and robot killed":
        groups = {"survivors": [1, 2, 4], "early": [4], "dead": [3]}
        steps += [
            timed_action(20.0, "kill", f"server{victims[0]}"),
            timed_action(25.0, "kill", "3", "death"),
        ]
        steps += [timed_action(40.0 + 1.5 * it.lease, "end", phase="end")]
    else:
        # The late joiner starts, and the observation ends, after every lease has expired.
        new, back, end = 30.0 + it.lease, 55.0 + it.lease, 90.0 + it.lease
        if event == "server restarts":
            new, back, end = 35.0, 23.0, 70.0 + it.lease
        do, undo = ("cut", "join") if event == "server cut off" else ("kill", "start")
        names: list[Any] = victims if do == "cut" else [f"server{place}" for place in victims]
        steps += [
            timed_action(20.0, do, names[0], "death"),
            *(timed_action(20.0, do, one) for one in names[1:]),
        ]
        steps += [timed_action(new, "start", "5", "newcomer")]
        steps += [timed_action(new, "start", str(number)) for number in groups.get("beside", [])]
        steps += [timed_action(back, undo, one) for one in names[:-1]]
        returned = "" if event == "server restarts" else "return"
        steps += [
            timed_action(back, undo, names[-1], returned),
            timed_action(end, "end", phase="end"),
        ]
    steps.sort(key=lambda one: float(one["at"]))
    used = {one["what"] for one in steps if one["do"] == "start"}
    programs = {f"server{place}": (place, program) for place, program in it.servers.items()}
    for number, place in host.items():
        if str(number) in used:
            programs[str(number)] = (place, it.client(number))
    places = sorted({place for place, _ in programs.values()})
    return {
        "configuration": name,
        "event": event,
        "places": places,
        "programs": {
            program: {"host": place, "command": command, "env": env}
            for program, (place, (command, env)) in programs.items()
        },
        "groups": {who: [str(number) for number in them] for who, them in groups.items()},
        "steps": steps,
    }


def count_runs(name: str, event: str) -> int:
    return MORE_RUNS.get((name, event), RUNS)


def configurations_and_events(outages: bool) -> list[tuple[str, str]]:
    """Return configurations and their events: failures, or outages of servers."""
    if outages:
        return [(name, event) for name in CONFIGURATIONS_WITH_OUTAGES for event in OUTAGE_EVENTS]
    return [(name, event) for name, it in CONFIGURATIONS.items() for event in it.events]


def list_runs(runs: int | None, only: list[str], outages: bool = False) -> Iterator[dict[str, Any]]:
    """Yield all runs, longest first: run 1 of every configuration and event, then run 2."""
    stagings = [
        programs_groups_and_steps(name, event)
        for name, event in configurations_and_events(outages)
        if not only or name in only
    ]
    stagings.sort(key=lambda job: -float(job["steps"][-1]["at"]))
    for number in range(1, (runs or max(RUNS, *MORE_RUNS.values())) + 1):
        for job in stagings:
            if number > (runs or count_runs(job["configuration"], job["event"])):
                continue
            name = f"{job['configuration']}-{job['event']}-r{number}".lower()
            name = name.replace(", ", "-").replace(" ", "-")
            # run_grid.py computes the load of a run from these numbers.
            size = {"hosts": len(job["places"]), "processes": 1}
            yield job | size | {"name": name, "run": number, "trial": False}


def short_runs() -> Iterator[dict[str, Any]]:
    """Yield two shortened runs, to test that everything works, also on a busy machine."""
    hurry = {"0": 0.0, "1": 0.2, "10": 2.0, "20": 4.0, "23": 4.5, "35": 6.0, "end": 9.0}
    for name in ("Fast DDS Discovery Server", "Zenoh router"):
        (job,) = (one for one in list_runs(1, [name]) if one["event"] == "server restarts")
        for one in job["steps"]:
            one["at"] = hurry["end" if one["do"] == "end" else f"{one['at']:.0f}"]
        yield job | {"trial": True}


def evaluate_finished_run(out: Path) -> str:
    """Evaluate a run; return a line about it."""
    job = json.loads(out.with_suffix(".json").read_text())
    logs = [read_log(out, name) for name in job["programs"] if name.isdigit()]
    heard = sum(event.what == "heard" for log in logs for event in log)
    found = {
        f"{row['who']} {row['quantity']}": f"{row['seconds']:.1f} s"
        for row in evaluate(out, job)
        if row["phase"] == "death" and row["seconds"] < inf
    }
    return f"{heard} samples; " + ", ".join(f"{what} {text}" for what, text in found.items())


def write_runs(folder: Path, todo: list[dict[str, Any]], table: Path, outages: bool) -> None:
    """Write the results of all runs, a row for each quantity."""
    order = configurations_and_events(outages)
    rows = []
    for job in sorted(
        todo, key=lambda job: (order.index((job["configuration"], job["event"])), job["run"])
    ):
        for row in evaluate(folder / job["name"], job):
            times = {"since_s": f"{row['since_s']:.0f}", "watched_s": f"{row['watched_s']:.0f}"}
            times["seconds"] = f"{row['seconds']:.2f}"
            rows.append({name: job.get(name) for name in COLUMNS} | row | times)
    write_table(table, rows)


def write_configurations(table: Path) -> None:
    """Write the configurations: versions, commands and settings."""
    rows = []
    for name, it in CONFIGURATIONS.items():
        place = next(iter(it.servers), 0)
        # Use the settings of the second process, because the first of several may differ.
        server = it.servers.get(2, it.servers.get(place, ([], {})))
        rows.append(
            {
                "configuration": name,
                "product": it.product,
                "version": installed_version(it.product),
                "what": it.what,
                "lease_s": f"{it.lease:g}",
                "client": command_as_typed(it.client(1)).replace(" 1", " NUMBER", 1),
                "server": command_as_typed(server),
                "kernel": os.uname().release,
            }
        )
    write_table(table, rows)


def command_as_typed(program: Program) -> str:
    """Return a command as typed, without folders of this machine."""
    command, env = program
    words = [f"{name}={value}" for name, value in env.items()]
    return " ".join(words + [Path(word).name if word.startswith("/") else word for word in command])


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--runs", type=int, help=f"runs of each staging, not {RUNS} or more")
    parser.add_argument("--only", action="append", default=[], metavar="ARRANGEMENT")
    parser.add_argument("--short", action="store_true", help="two stagings in 15 s, no table")
    parser.add_argument("--outages", action="store_true", help="a server is away for a while")
    parser.add_argument("--out", type=Path, default=BUILD / "deaths", help="folder for the logs")
    parser.add_argument("--crowd", type=int, default=MAX_PARALLEL_HOSTS, help="hosts at a time")
    given = parser.parse_args()
    known = CONFIGURATIONS_WITH_OUTAGES if given.outages else CONFIGURATIONS
    if unknown := set(given.only) - set(known):
        parser.error(f"--only {min(unknown)}: not one of {', '.join(known)}")
    if given.runs is not None and given.runs < 1:
        parser.error(f"--runs must be at least 1; got {given.runs}")
    if not (BUILD / ".ready").exists():
        print("The lab is not set up: run it by make deaths", file=sys.stderr)
        return 1
    out: Path = given.out / "short" if given.short else given.out
    out.mkdir(parents=True, exist_ok=True)
    todo = list(short_runs() if given.short else list_runs(given.runs, given.only, given.outages))
    there = [job for job in todo if (out / job["name"]).with_suffix(".json").exists()]
    if given.short:
        there = []
    if there:
        print(f"{len(there)} of {len(todo)} runs are in {out} already", flush=True)
    left = [job for job in todo if job not in there]
    spacing = 0.1 if given.short else SPACING
    if run_in_parallel(left, out, given.crowd, spacing, STAGE, evaluate_finished_run):
        return 1
    if not given.short:
        # Incomplete tables do not belong into the package.
        whole = given.runs is None and not given.only
        folder = BOOK if whole else out
        table = "outages" if given.outages else "deaths"
        write_runs(out, todo, folder / f"{table}.csv", given.outages)
        if not given.outages:
            write_configurations(folder / "configurations.csv")
    return 0


if __name__ == "__main__":
    run_lab_program(main)
