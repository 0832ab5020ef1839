"""Compare the bench's trusted runs with the simulator, point by point (see README.md).

    compare.py [--runs FILE] [--out FILE] [--simulated NUMBER]

FILE, by default the book's `measured/air.csv`, gets a row per point: the median of the trusted
runs, and that of as many simulations as `--simulated` says. These have the messages that the bench
causes, and hosts that start within the time in which its processes made their endpoints. Times are
empty if at least half of the runs did not get there; in the simulator, those of more than
`SIMULATED_SECONDS` are.
"""

import argparse
import statistics
import sys
from collections import defaultdict
from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent / "measure")]

from measure_air import LOSSES, POINT_COLUMNS  # noqa: E402
from run_releases import read_table_if_present, write_atomically  # noqa: E402

import discostorm as ds  # noqa: E402
from discostorm.lookup import with_timers_of  # noqa: E402

ROOT = HERE.parents[1]
RUNS = ROOT / "lab" / "data" / "air" / "runs.csv"
OUT = ROOT / "packages" / "book" / "discostorm_book" / "data" / "measured" / "air.csv"
#: Measured over simulated times, which `plan` quotes.
RATIOS = ROOT / "packages/planner/discostorm_planner/data/measured/air_ratios.csv"
#: The table of messages of each release that is simulated, on Wi-Fi.
TABLES = {
    "fast_dds-2.6.12": "Fast DDS 2.6",
    "fast_dds-2.9.1": "Fast DDS",
    "fast_dds-2.14.6": "Fast DDS 2.14",
    "fast_dds-3.6.2": "Fast DDS 3.6",
    "cyclone_dds-0.10.5": "Cyclone DDS",
}
#: Messages of the tables that the bench does not cause: its processes have no endpoints of ROS of
#: their own, and make all endpoints before they start, so that SEDP comes in one go.
NOT_ON_THE_BENCH = {
    "Heartbeat of data",
    "Heartbeat for others",
    "ACKNACK of data",
    "ACKNACK for others",
    "ROS discovery info",
    "ROS Heartbeat",
    "ROS Heartbeat for others",
    "ROS ACKNACK",
    "ROS ACKNACK for others",
}
#: The tables of a Discovery Server by its place; its clients share all topics on the bench.
SERVERS = {
    "wired": "Fast DDS Discovery Server",
    "robot": "Fast DDS Discovery Server, on a robot",
}
#: Startups that take no longer, measured and simulated, say nothing about factors [s].
SHORT_STARTUP = 1.5
#: When the simulated robot reboots, long after the others are complete [s].
REBOOT_AT = 40.0
#: Writers of SEDP of a process, and octets of UDP in a fragment of a packet [B].
SEDP_WRITERS, FRAGMENT_BYTES = 2, 1472
SIMULATED_SECONDS = 60.0  # s that are simulated
PAIR_PERCENTAGES = (50, 95, 100)  # shares of the pairs that know each other [%]
COLUMNS = (
    *("protocol", *POINT_COLUMNS, "runs", "untrusted", "seconds", "finished"),
    *(f"t{part}_s" for part in PAIR_PERCENTAGES),
    *("t100_min_s", "t100_max_s", "known", "receptions", "lost", "made_s"),
    *(f"simulated_t{part}_s" for part in PAIR_PERCENTAGES),
    *("simulated_min_s", "simulated_max_s", "simulated_finished", "simulated_receptions"),
    "simulated_lost",
)


def finite_or_empty(value: float) -> str:
    """Return a time for the table; empty if it exceeds the simulated time."""
    return f"{value:.3f}" if value <= SIMULATED_SECONDS else ""


def lost_share(counts: Mapping[str, Any]) -> float:
    """Return the share of lost receptions, without frames that still wait [1]."""
    lost = sum(int(counts[name]) for name in LOSSES)
    return lost / (lost + int(counts["arrived"]))


def measured_medians(rows: list[dict[str, str]]) -> dict[str, Any]:
    """Return the medians of the trusted runs of a point."""
    trusted = [row for row in rows if row["trusted"] == "1"]
    found: dict[str, Any] = {"runs": len(trusted), "untrusted": len(rows) - len(trusted)}
    if not trusted:
        return found
    for part in PAIR_PERCENTAGES:
        times = [float(row[f"t{part}_s"] or "inf") for row in trusted]
        found[f"t{part}_s"] = finite_or_empty(statistics.median(times))
    found |= {"t100_min_s": finite_or_empty(min(times)), "t100_max_s": finite_or_empty(max(times))}
    sent = [int(row["expected"]) for row in trusted]
    known = [float(row["known"]) for row in trusted]
    return found | {
        "seconds": max(float(row["seconds"]) for row in trusted),
        "finished": sum(time < float("inf") for time in times),
        "known": f"{statistics.median(known):.3f}",
        "receptions": round(statistics.median(sent)),
        "lost": f"{statistics.median(map(lost_share, trusted)):.3f}",
        "made_s": f"{statistics.median(float(row['made_s']) for row in trusted):.3f}",
    }


def protocol_on_the_bench(protocol: ds.Protocol, endpoints: int) -> ds.Protocol:
    """Return the table without messages that the bench does not send, with full SEDP datagrams."""
    rows = [row for row in protocol.messages if row.name not in NOT_ON_THE_BENCH]
    for place, row in enumerate(rows):
        if row.role == "data":
            # All endpoints exist before, so that all samples of a writer share a datagram.
            fragments = -(-endpoints / SEDP_WRITERS * row.payload.nominal // FRAGMENT_BYTES)
            rows[place] = replace(row, frames=fragments * SEDP_WRITERS / endpoints)
    return replace(protocol, messages=tuple(rows))


def simulated_medians(row: dict[str, str], runs: int) -> dict[str, Any]:
    """Return the medians of simulations of a point."""
    ampdu = int(row["ampdu"])
    hosts, processes, endpoints = (int(row[n]) for n in ("hosts", "processes", "endpoints"))
    protocol, shared = protocol_on_the_bench(ds.PROTOCOLS[TABLES[row["release"]]], endpoints), 0
    starts = np.zeros(hosts)
    if row["server"]:
        protocol, shared = with_timers_of(ds.PROTOCOLS[SERVERS["wired"]], protocol), endpoints
    if row["start"] == "reboot":
        starts[-1] = REBOOT_AT
    elif row["start"]:
        starts = float(row["start"]) * np.arange(hosts) / hosts
    # The cell of cell.cc, as `tests/simulation` compares it with ns-3.
    standard, width = {"n": ("802.11n", 20e6), "ac": ("802.11ac", 80e6)}[row["standard"]]
    radio = ds.Radio(standard, width=width, streams=2, aifsn=3, mpdus=64 if ampdu else 1)
    result = ds.simulate(
        ds.Fleet((ds.HostGroup(hosts, processes, endpoints, shared=shared),)),
        protocol,
        radio.wifi(),
        runs=runs,
        queue=(int(row["queue_frames"]), 0.5),
        start=lambda rng, count: starts + rng.uniform(0.0, float(row["made_s"]), count),
        until=SIMULATED_SECONDS,
    )
    pairs = result.pair_times
    if row["start"] == "reboot":  # the others wait for it
        pairs = pairs[:, -2 * processes * processes * (hosts - 1) :] - REBOOT_AT
    found = {}
    for part in PAIR_PERCENTAGES:
        times = pairs[:, -(-pairs.shape[1] * part // 100) - 1]
        found[f"simulated_t{part}_s"] = finite_or_empty(float(np.median(times)))
    counts = [{name: values[run] for name, values in result.counts.items()} for run in range(runs)]
    lost = statistics.median(map(lost_share, counts))
    return found | {
        "simulated_min_s": finite_or_empty(float(times.min())),
        "simulated_max_s": finite_or_empty(float(times.max())),
        "simulated_finished": f"{np.mean(times <= SIMULATED_SECONDS):.2f}",
        "simulated_receptions": round(float(np.median(result.counts["expected"]))),
        "simulated_lost": f"{lost:.3f}",
    }


def measured_over_simulated_ranges(rows: list[dict[str, Any]]) -> Iterator[dict[str, Any]]:
    """Return the range of measured over simulated times until 95% of the pairs are complete.

    A server has a row for all of its clients, and one for those of each release. Short startups
    are left out: a single repeat decides them, which says nothing about longer ones.
    """
    tables = defaultdict(list)
    for row in rows:
        simulated = float(row.get("simulated_t95_s") or "inf")
        longer = max(simulated, float(row.get("t95_s") or "inf")) > SHORT_STARTUP
        if row["sender"] == "waits" and simulated < float("inf") and longer and not row["start"]:
            tables[row["protocol"], ""].append(row)
            if row["server"]:
                tables[TABLES[row["release"]], row["server"]].append(row)
    for (name, server), own in tables.items():
        # A run that was not complete in time took at least as long as it was watched.
        took = [float(row.get("t95_s") or row["seconds"]) for row in own]
        pairs = zip(took, (float(row["simulated_t95_s"]) for row in own), own, strict=True)
        found = [
            real / simulated
            for real, simulated, row in pairs
            if row.get("t95_s") or simulated < real
        ]
        if found:
            hosts = max(int(row["hosts"]) for row in own)
            row = {"protocol": name, "server": server, "points": len(own), "hosts": hosts}
            row |= {"seconds": f"{max(float(each['seconds']) for each in own):g}"}
            row |= {"low": f"{min(found):.2f}", "high": f"{max(found):.2f}"}
            yield row | {"source": "measured/air.csv, by lab/air/compare.py"}


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--runs", type=Path, default=RUNS)
    parser.add_argument("--out", type=Path, default=OUT)
    parser.add_argument("--simulated", type=int, default=20, metavar="NUMBER")
    given = parser.parse_args()
    points: dict[tuple[str, ...], list[dict[str, str]]] = defaultdict(list)
    for run in read_table_if_present(given.runs):
        points[tuple(run[name] for name in POINT_COLUMNS)].append(run)
    rows = []
    for point, runs in sorted(points.items()):
        row: dict[str, Any] = dict(zip(POINT_COLUMNS, point, strict=True))
        table = SERVERS.get(row["server"]) or TABLES.get(row["release"], "")
        row |= {"protocol": table}
        row |= measured_medians(runs)
        # The simulator does not repair losses of a server on a robot.
        if table and row["runs"] and not row["edp_answers"] and row["server"] != "robot":
            row |= simulated_medians(row, given.simulated)
        rows.append(row)
        print(*(f"{name}={row.get(name, '')}" for name in COLUMNS if row.get(name, "") != ""))
    write_atomically(given.out, rows, COLUMNS)
    write_atomically(
        RATIOS,
        list(measured_over_simulated_ranges(rows)),
        ("protocol", "server", "points", "hosts", "seconds", "low", "high", "source"),
    )
    return 0


if __name__ == "__main__":
    sys.exit(main())
