"""Reproduce published measurements of discovery traffic, and count as their authors did.

`grids/literature.csv` lists the reproduced setups, `literature_endpoints.csv` the endpoints of
their programs. Rows of `lab/data/literature.csv`: message kinds of a run, and the packets that the
authors would have counted. The book's `data/measured/staged.csv` combines all runs.
"""

import argparse
import csv
import hashlib
import json
import os
import re
from collections.abc import Iterator
from pathlib import Path
from statistics import median
from typing import Any

import numpy as np
from lab_data import BOOK, DATA, write_table
from run_grid import (
    BUILD,
    CONFIGURATIONS,
    GRIDS,
    PACKAGES,
    PRODUCTS,
    compress_capture,
    installed_version,
    run_in_parallel,
    run_lab_program,
)

import discostorm as ds
from discostorm.data import read_data
from discostorm_book.published_numbers import HEADERS_IN_CAPTURES

COLUMNS = (
    *("staging", "run", "product", "variant", "version", "hosts", "processes", "spacing_s"),
    *("from_s", "seconds"),
    *(
        "start_skew_s",
        "endpoints_created_s",
        "last_s",
        "command",
        "kernel",
        "sha256",
        "kind",
        "count",
        "bytes",
    ),
)
#: Entities that rclcpp creates for a node and rmw for a participant: names, types, roles.
PARAMETER_SERVICES = (
    *("describe_parameters", "get_parameter_types", "get_parameters"),
    *("list_parameters", "set_parameters", "set_parameters_atomically"),
)
PARAMETER_EVENTS_TOPIC = ("parameter_events", "rcl_interfaces/msg/ParameterEvent")
GRAPH_TOPIC = ("ros_discovery_info", "rmw_dds_common/msg/ParticipantEntitiesInfo")
#: Reader ids by which the documentation's script filters packets, copied from there. Some are
#: writers: of SEDP's topics, publications and subscriptions, SPDP and liveliness.
FILTERED_READER_IDS = (
    *(0x2C2, 0x2C7, 0x3C2, 0x3C7, 0x4C2, 0x4C7),
    *(0x100C2, 0x100C7, 0x200C2, 0x200C7, 0x201C3, 0x201C4),
)
#: Maximum delay of one of fifty programs, which a shell starts without a clock [s].
MAX_START_DELAY = 3.0
#: Kinds of endpoint announcements; the last one completes a discovery.
ANNOUNCEMENT_KINDS = ("SEDP", "Declare", "Declare key expression")


def endpoints_of_ros_entity(role: str, name: str, kind: str) -> Iterator[tuple[str, str, str]]:
    """Yield the DDS endpoints of a ROS 2 writer, reader, service or client."""
    package, sort, base = kind.split("/")
    if role in ("writer", "reader"):
        yield role[0], f"rt/{name}", f"{package}::{sort}::dds_::{base}_"
        return
    request, reply = ("r", "w") if role == "service" else ("w", "r")
    yield request, f"rq/{name}Request", f"{package}::{sort}::dds_::{base}_Request_"
    yield reply, f"rr/{name}Reply", f"{package}::{sort}::dds_::{base}_Response_"


def endpoints_of_program(program: str) -> list[tuple[str, str, str]]:
    """Return role, topic and type of all endpoints of a program, in order of creation."""
    found = [
        *endpoints_of_ros_entity("writer", *GRAPH_TOPIC),
        *endpoints_of_ros_entity("reader", *GRAPH_TOPIC),
    ]
    with (GRIDS / "literature_endpoints.csv").open(newline="") as file:
        rows = [row for row in csv.DictReader(file) if row["program"] == program]
    if not rows:
        raise ValueError(f"program {program}: not in literature_endpoints.csv")
    for row in rows:
        name = row["name"]
        if row["what"] != "node":
            found += endpoints_of_ros_entity(row["what"], name, row["type"])
            continue
        found += [
            *endpoints_of_ros_entity("writer", "rosout", "rcl_interfaces/msg/Log"),
            *endpoints_of_ros_entity("writer", *PARAMETER_EVENTS_TOPIC),
        ]
        for service in PARAMETER_SERVICES:
            base = "".join(word.title() for word in service.split("_"))
            found += endpoints_of_ros_entity(
                "service", f"{name}/{service}", f"rcl_interfaces/srv/{base}"
            )
        found += endpoints_of_ros_entity("reader", *PARAMETER_EVENTS_TOPIC)
    return found


def endpoints_argument(program: str, node: str) -> str:
    """Return a program's endpoints in the argument format of the lab's programs.

    Programs joined by plus signs form one bridge, which has each key once for writers and once for
    readers; "bot" has one key for all.
    """
    if program == "bot":
        return "w bot/** -,r bot/** -"
    parts = program.split("+")
    every = [one for part in parts for one in endpoints_of_program(part)]
    if len(parts) > 1:
        every = list(dict.fromkeys(every))
    return ",".join(" ".join(one).replace("NODE", node) for one in every)


def list_runs(grid: Path) -> list[dict[str, Any]]:
    """Return all runs: run 1 of every setup, then run 2."""
    with grid.open(newline="") as file:
        stagings = list(csv.DictReader(file))
    versions = {product: installed_version(product) for product in PACKAGES}
    found = []
    for number in range(1, max(int(staging["runs"]) for staging in stagings) + 1):
        for staging in stagings:
            if number > int(staging["runs"]):
                continue
            product, variant = staging["product"], staging["variant"]
            known: dict[tuple[str, str], Any] = {k: (*v, []) for k, v in PRODUCTS.items()}
            known |= CONFIGURATIONS
            command, env, servers = known[
                "zenoh_peer" if product == "zenoh" else product,
                "default" if variant == "warm" else variant,
            ]
            after, warm = float(staging["after_s"]), variant == "warm"
            programs = []
            hosts = staging["programs"].split(" / ")
            for host, names in enumerate(hosts, 1):
                every = [
                    name
                    for name, _, many in (part.partition("*") for part in names.split())
                    for _ in range(int(many or 1))
                ]
                for process, name in enumerate(every, 1):
                    later = 0.0 if warm or host == 1 else after
                    programs.append(
                        {
                            "host": host,
                            "process": process,
                            "endpoints": endpoints_argument(name, f"{name}_{process}"),
                            "after": later + (process - 1) * float(staging["spacing_s"]),
                            "variant": "default" if host == 1 and warm else variant,
                        }
                    )
            if servers:  # the hosts of the programs, as in the documentation's script
                command_of = [word.replace("10.77.0.101", "127.0.0.1") for word in servers[0][1]]
                servers = [(1, command_of)]
                env = {"ROS_DISCOVERY_SERVER": "127.0.0.1:11811"}
            found.append(
                staging
                | {
                    "name": f"{staging['staging']}-r{number}",
                    "version": versions[product],
                    "kernel": os.uname().release,
                    "command": command,
                    "env": env,
                    "servers": servers,
                    "hosts": len(hosts),
                    "processes": len(programs),
                    "names": "listed",
                    "programs": programs,
                    "run": number,
                    "from": after,
                    "seconds": float(staging["seconds"]),
                    "tap": 1 if len(hosts) == 1 else None,
                    "late": MAX_START_DELAY,
                }
            )
    return found


def counts_like_authors(stored: dict[str, Any], capture: Path) -> Iterator[dict[str, Any]]:
    """Yield kind, count and bytes [B] of the messages that the authors would have counted."""
    found = ds.read_capture(capture)
    messages = found.messages()
    time = messages["time"] + (found.start - stored["start"]) - stored["from"]
    inside = messages[(time >= 0) & (time < stored["seconds"] - stored["from"])]
    last = time[inside.index][inside["kind"].isin(ANNOUNCEMENT_KINDS)].max()
    if stored["counted"] == "readers":
        some = inside[(inside["protocol"] == "RTPS") & inside["reader"].isin(FILTERED_READER_IDS)]
    else:
        of = ds.PROTOCOLS["Zenoh peer" if stored["product"] == "zenoh" else "Cyclone DDS"]
        kinds = {m.kind for m in of.messages if m.phase in stored["counted"].split()}
        kinds |= {m.kind for m in ds.PROTOCOLS["Fast DDS"].messages} & {"SPDP", "SEDP"}
        some = inside[inside["kind"].isin(kinds) & (time[inside.index] <= last)]
    stored["last"] = last
    for kind, group in some.groupby("kind", observed=True):
        yield {"kind": kind, "count": len(group), "bytes": int(group["bytes"].sum())}
    data = some[some["kind"].isin(("SPDP", "SEDP"))]
    for kind, part in (("packets", some), ("packets of data", data)):
        whole = inside[inside["frame"].isin(part["frame"])]
        each = whole.groupby("frame").agg({"bytes": "sum", "transport": "first"})
        octets = each["bytes"] + each["transport"].map(HEADERS_IN_CAPTURES).astype(int)
        if len(each):
            yield {"kind": kind, "count": len(each), "bytes": int(octets.sum())}


def count_rows(captures: Path, todo: list[dict[str, Any]]) -> Iterator[dict[str, Any]]:
    """Yield the rows of the table."""
    for job in sorted(todo, key=lambda job: (job["staging"], job["run"])):
        capture = captures / f"{job['name']}.pcap.gz"
        stored = json.loads((captures / f"{job['name']}.json").read_text())
        kinds = list(counts_like_authors(stored, capture))
        begun = [stored["start"] + one["after"] for one in stored["programs"]]
        pairs = list(zip(stored["times"], begun, strict=True))
        head = {
            **{name: stored[name] for name in COLUMNS[:8]},
            "from_s": f"{stored['from']:g}",
            "seconds": f"{stored['seconds']:g}",
            "start_skew_s": f"{max(one['begin'] - when for one, when in pairs):.4f}",
            "endpoints_created_s": f"{max(one['endpoints'] - when for one, when in pairs):.4f}",
            "last_s": f"{stored['last']:.3f}" if np.isfinite(stored["last"]) else "",
            "command": f"{Path(stored['command'][-1]).name} {stored['seconds']:g} HOST PROCESS "
            f"ENDPOINTS listed {stored['variant']}",
            "kernel": stored["kernel"].partition("-")[0],
            "sha256": hashlib.sha256(capture.read_bytes()).hexdigest(),
        }
        for kind in kinds:
            yield head | kind


def summary_rows(runs: list[dict[str, str]], grid: Path) -> Iterator[dict[str, Any]]:
    """Yield a row for each setup and kind: median, minimum and maximum of the runs."""
    with grid.open(newline="") as file:
        titles = {row["staging"]: row["title"] for row in csv.DictReader(file)}
    groups: dict[tuple[str, str], list[dict[str, str]]] = {}
    for each in runs:
        groups.setdefault((each["staging"], each["kind"]), []).append(each)
    for (staging, kind), some in groups.items():
        row = {"staging": staging, "kind": kind, "runs": len(some)}
        row |= {name: some[0][name] for name in ("product", "variant", "version", "processes")}
        for name, end in (("count", ""), ("bytes", "_bytes")):
            values = [float(each[name]) for each in some]
            row |= {name: median(values), f"least{end}": min(values)}
            row[f"most{end}"] = max(values)
        last = [float(each["last_s"]) for each in some if each["last_s"]]
        yield row | {"last_s": f"{median(last):.6g}" if last else "", "title": titles[staging]}


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--captures", type=Path, default=BUILD / "published")
    parser.add_argument("--out", type=Path, default=DATA / "literature.csv")
    parser.add_argument("--only", default="", help="pattern of stagings, in whole")
    given = parser.parse_args()
    given.captures.mkdir(parents=True, exist_ok=True)
    todo = [
        job
        for job in list_runs(GRIDS / "literature.csv")
        if not given.only or re.fullmatch(given.only, job["staging"])
    ]
    there = [job for job in todo if (given.captures / f"{job['name']}.pcap.gz").exists()]
    print(f"{len(there)} of {len(todo)} runs are in {given.captures} already", flush=True)
    # Run one setup at a time: most have more processes than the machine can spare.
    failed = run_in_parallel(
        [job for job in todo if job not in there], given.captures, 1, 0.0, finish=compress_capture
    )
    if failed:
        return 1
    write_table(given.out, count_rows(given.captures, todo), COLUMNS)
    folder = BOOK if given.out == DATA / "literature.csv" else given.out.parent
    write_table(
        folder / "staged.csv", summary_rows(read_data(str(given.out)), GRIDS / "literature.csv")
    )
    return 0


if __name__ == "__main__":
    run_lab_program(main)
