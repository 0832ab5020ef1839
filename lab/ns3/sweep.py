"""Build storm.cc, run its scenarios in ns-3, and write the tables; see README.md."""

import argparse
import concurrent.futures
import csv
import dataclasses
import hashlib
import itertools
import json
import os
import statistics
import subprocess
import sys
import time
from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Any

import mixed
import numpy as np
from mixed import MixedTraffic
from tqdm import tqdm

import discostorm as ds
from discostorm.messages import ENDPOINT_PAIR
from discostorm_simulation import disc
from discostorm_simulation.engine import compile_engine
from discostorm_simulation.run import Scenario, set_up, simulate_run

HERE = Path(__file__).parent
ROOT = HERE.parents[1]
BUILD = ROOT / "build" / "ns3"
NS3 = BUILD / "packages" / "ns3"
CACHE = BUILD / "results"
#: Tables that the book reads; all others are only for tests.
BOOK, DATA = ROOT / "packages/book/discostorm_book/data/measured", ROOT / "lab" / "data"
BOOK_TABLES = ("bursts", "agreements", "capture", "mixed")
VERSION = "3.44"
PROGRAM = BUILD / "storm"
PROTOCOLS = {protocol.name: protocol for protocol in (ds.DDS, ds.ZENOH)}

#: Libraries of ns-3 that the program or its libraries need.
LIBRARIES = (
    "core",
    "network",
    "mobility",
    "propagation",
    "wifi",
    "stats",
    "antenna",
    "spectrum",
    "energy",
)

#: Number of our runs for each timed ns-3 run: a single run is too short for the clock.
OUR_RUNS_PER_NS3_RUN = 20

#: Columns that are not summed over runs.
TIME_COLUMNS = ("drain_time_s", "cpu_s")

#: Queue limits: ns-3's default, and Linux's order of magnitude: frames [1] and seconds [s].
QUEUE_LIMITS = (500, 0.5)


@dataclasses.dataclass(frozen=True)
class Burst:
    """A run of a burst; its fields are the options and columns of README.md."""

    scenario: str = "burst"
    protocol: str = "DDS"
    hosts: int = 3
    processes: int = 2
    endpoints: int = 10
    order: str = "pairs"
    ampdu: int = 0
    request: int = 1
    aifsn: int = 3
    queue_frames: int = 0
    queue_s: float = 0.0
    window_s: float = 0.0
    loss: float = 0.0
    seed: int = 1
    cold: int = 0
    radius: float = 0.0
    delays: int = 1

    def options(self) -> list[str]:
        """Return the program's options."""
        named = "hosts processes order ampdu request aifsn queue_frames queue_s window_s loss seed"
        return [
            f"--messages={message_rows(self.protocol, self.endpoints)}",
            *(f"--{name}={getattr(self, name)}" for name in named.split()),
            *(["--cold=1"] if self.cold else []),
            *([f"--places={host_positions(self.hosts, self.radius)}"] if self.radius else []),
            *([] if self.delays else ["--delays=0"]),
        ]


@dataclasses.dataclass(frozen=True)
class Saturation:
    """A run of stations that always have a frame for the access point."""

    stations: int = 1
    frame_bytes: int = 464
    aifsn: int = 3
    duration_s: float = 1.0
    seed: int = 1

    def options(self) -> list[str]:
        """Return the program's options."""
        return [
            "--traffic=saturation",
            f"--messages=saturation:unicast:{self.frame_bytes}:1",
            f"--hosts={self.stations}",
            f"--aifsn={self.aifsn}",
            f"--duration={self.duration_s}",
            f"--seed={self.seed}",
        ]


Run = Burst | Saturation | MixedTraffic


def host_positions(hosts: int, radius: float) -> str:
    """Return positions of hosts on a disc of this radius [m], in the program's input format."""
    return ",".join(f"{x:.4f}:{y:.4f}" for x, y in radius * disc(hosts))


def message_rows(protocol: str, endpoints: int) -> str:
    """Return a protocol's table in the program's input format."""
    rows = []
    for message in PROTOCOLS[protocol].messages:
        count = message.per_unit * (endpoints if message.unit is ENDPOINT_PAIR else 1)
        rows.append(f"{message.name}:{message.cast}:{message.frame_bytes:g}:{count:g}")
    return ",".join(rows)


def command_options(run: Run) -> list[str]:
    """Return the program's options for a run."""
    return run.options(message_rows) if isinstance(run, MixedTraffic) else run.options()


def source(run: Run) -> str:
    """Return the version of ns-3 and the ARGS of `make ns3` that repeat a run."""
    default = type(run)()
    options = [
        f"--{field.name} {getattr(run, field.name)}"
        for field in dataclasses.fields(run)
        if field.name != "scenario" and getattr(run, field.name) != getattr(default, field.name)
    ]
    return f"ns-3 {VERSION}: " + " ".join([type(run).__name__.lower(), *options])


def print_now(text: str) -> None:
    """Print a line before the compiler and other programs print theirs."""
    print(text, flush=True)


def compile_program() -> None:
    """Compile the program if its source has changed."""
    source = HERE / "storm.cc"
    mark = BUILD / "storm.sha256"
    digest = hashlib.sha256(source.read_bytes()).hexdigest()
    if PROGRAM.exists() and mark.exists() and mark.read_text() == digest:
        return
    print_now("Compiling storm.cc (once) ...")
    compiler = os.environ.get("CXX", "g++")
    try:
        subprocess.run(
            [compiler, "-std=c++20", "-O2", f"-I{NS3 / 'include'}", str(source), "-o", str(PROGRAM)]
            + [f"-L{NS3 / 'lib64'}", f"-Wl,-rpath,{NS3 / 'lib64'}"]
            + [f"-lns{VERSION}-{library}" for library in LIBRARIES],
            check=True,
        )
    except (OSError, subprocess.CalledProcessError) as error:
        sys.exit(f"discostorm: could not compile {source}: {error}")
    mark.write_text(digest)


def run_program(options: Iterable[str]) -> str:
    """Run the program and return its output."""
    done = subprocess.run([str(PROGRAM), *options], capture_output=True, text=True, check=False)
    if done.returncode:
        sys.exit(f"discostorm: storm {' '.join(options)}: {done.stderr.strip()}")
    return done.stdout


def cache_path(run: Run) -> Path:
    """Return the path of a run's cached result, which depends on program and options."""
    text = "\n".join([(BUILD / "storm.sha256").read_text(), *command_options(run)])
    return CACHE / f"{hashlib.sha256(text.encode()).hexdigest()}.json"


def cached_result(run: Run) -> dict[str, Any]:
    """Return the result of a run, from the cache if possible."""
    path = cache_path(run)
    if not path.exists():
        # Rename the complete file, so that an interrupted run is repeated.
        part = path.with_suffix(".part")
        part.write_text(run_program(command_options(run)))
        part.rename(path)
    values: dict[str, Any] = json.loads(path.read_text())
    return values


def burst_grid(
    scenario: str,
    hosts: Iterable[int],
    seeds: tuple[int, int],
    *,
    protocols: Iterable[str] = tuple(PROTOCOLS),
    queues: Iterable[tuple[int, float]] = ((0, 0.0),),
    windows: Iterable[float] = (0.0,),
    losses: Iterable[float] = (0.0,),
    settings: Iterable[tuple[str, object]] = (),
) -> list[Run]:
    """Return the bursts of all combinations; `settings` apply to each burst.

    With aggregation, a burst has few transmissions: runs vary more and are cheap, so `seeds` has a
    second, larger number for them.
    """
    base = dataclasses.replace(Burst(scenario), **dict(settings))  # type: ignore[arg-type]
    every = itertools.product(
        hosts, losses, windows, queues, protocols, zip((0, 65535), seeds, strict=True)
    )
    return [
        dataclasses.replace(
            base,
            hosts=count,
            loss=loss,
            window_s=window,
            queue_frames=queue[0],
            queue_s=queue[1],
            protocol=protocol,
            ampdu=ampdu,
            seed=seed,
        )
        for count, loss, window, queue, protocol, (ampdu, runs) in every
        for seed in range(1, runs + 1)
    ]


def saturated_runs(
    stations: Iterable[int], frame: int = 464, aifsn: int = 3, duration: float = 1.0
) -> list[Run]:
    """Return the saturated runs for some numbers of stations."""
    return [
        Saturation(count, frame, aifsn, duration, seed)
        for count in stations
        for seed in range(1, 11)
    ]


START_WINDOWS = (0.5, 1.0, 2.0, 5.0)

#: Runs with and without agreements before the burst, for a separate table with the same seeds.
AGREEMENTS: list[Burst] = [
    dataclasses.replace(run, cold=cold)
    for protocol, hosts, runs, queue in (
        *(("DDS", hosts, 40, QUEUE_LIMITS) for hosts in (4, 5, 6, 7, 9, 10)),
        *(("Zenoh", hosts, 40, (0, 0.0)) for hosts in (3, 5, 7, 8, 11)),
        ("Zenoh", 12, 20, (0, 0.0)),
    )
    for cold in (1, 0)
    for run in burst_grid(
        "agreements",
        (hosts,),
        (0, runs),
        protocols=[protocol],
        queues=[queue],
    )
    if isinstance(run, Burst)
]

#: Stations on a disc, for a separate table. Noise is irrelevant within this radius [m].
DISC_RADIUS = 5.0
CAPTURE: list[Run] = [
    run
    for hosts, queue, runs, delays in (
        ((3, 5, 7, 10), QUEUE_LIMITS, (20, 60), 1),
        ((3, 5, 7), (0, 0.0), (10, 20), 1),
        ((7,), QUEUE_LIMITS, (20, 0), 0),
        ((7,), (0, 0.0), (10, 0), 0),
    )
    for run in burst_grid(
        "capture",
        hosts,
        runs,
        queues=[queue],
        settings=[("radius", DISC_RADIUS), ("delays", delays)],
    )
]

#: All runs, in the order of the tables.
RUNS: list[Run] = [
    *burst_grid("unlimited", (2, 3, 4), (20, 40)),
    *burst_grid("unlimited", (5, 6, 7, 8, 10, 12), (10, 20)),
    *saturated_runs((1, 2, 5, 10, 20)),
    *burst_grid("queue", (2, 3), (20, 40), queues=[QUEUE_LIMITS]),
    *burst_grid("queue", (4, 5, 6), (40, 40), queues=[QUEUE_LIMITS]),
    *burst_grid("queue", (7, 8), (10, 100), queues=[QUEUE_LIMITS]),
    *burst_grid("staggered", (4, 8), (10, 20), queues=[QUEUE_LIMITS], windows=START_WINDOWS),
    *burst_grid("queue", (10, 12), (10, 40), queues=[QUEUE_LIMITS]),
    *saturated_runs((30, 50), duration=0.5),
    *burst_grid("errors", (3,), (10, 20), queues=[(0, 0.0), QUEUE_LIMITS], losses=(0.05, 0.2)),
    *burst_grid("errors", (6,), (10, 20), losses=(0.05, 0.2)),
    *burst_grid("errors", (6,), (10, 100), queues=[QUEUE_LIMITS], losses=(0.05, 0.2)),
    *burst_grid("short_queue", (4, 8, 12), (10, 40), queues=[(100, 0.5)]),
    *(
        run
        for scenario_of_run, *settings in (
            ("one_process", ("processes", 1)),
            ("four_processes", ("processes", 4), ("endpoints", 4)),
            ("aifsn", ("aifsn", 2)),
            ("order", ("order", "messages")),
            ("no_request", ("request", 0)),
        )
        for run in burst_grid(
            scenario_of_run,
            (4,),
            (10, 40),
            protocols=["DDS"],
            queues=[(0, 0.0), QUEUE_LIMITS],
            settings=settings,
        )
    ),
    *saturated_runs((1, 5), aifsn=2),
    *saturated_runs((1, 5), frame=1538),
    *AGREEMENTS,
    *CAPTURE,
    *mixed.RUNS,
]


def frame_airtimes() -> Iterator[dict[str, object]]:
    """Yield the airtime of single frames and of A-MPDUs, read from the trace of one sender."""
    for protocol, table in PROTOCOLS.items():
        for message in table.messages:
            for ampdu, counts in ((0, (1,)), (65535, (2, 16, 64))):
                if message.cast == "multicast" and ampdu:
                    continue
                for count in counts:
                    frame = int(message.frame_bytes)
                    options = [
                        f"--messages={message.name}:{message.cast}:{frame}:{count}",
                        *("--hosts=2", "--processes=1", "--senders=1", "--trace=1"),
                        f"--ampdu={ampdu}",
                    ]
                    rows = [line.split(",") for line in run_program(options).splitlines()[:-1]]
                    for number, row in enumerate(rows):
                        if row[4] != "data":
                            continue
                        begin, end = int(row[1]), int(row[2])
                        group = row[7] == "1"
                        answer = None if group else rows[number + 1]
                        yield {
                            "protocol": protocol,
                            "message": message.name,
                            "frame_B": frame,
                            "direction": "up" if row[3] == "0" else "down",
                            "cast": "multicast" if group else "unicast",
                            "mpdus": int(row[6]),
                            "data_ns": end - begin,
                            "sifs_ns": int(answer[1]) - end if answer else 0,
                            "answer": answer[4] if answer else "none",
                            "answer_ns": int(answer[2]) - int(answer[1]) if answer else 0,
                            "source": f"ns-3 {VERSION}: build/ns3/storm {' '.join(options)}",
                        }


def write_table(name: str, rows: list[dict[str, object]]) -> None:
    """Write a table, unless it has no rows."""
    if not rows:
        return
    path = (BOOK if name in BOOK_TABLES else DATA) / f"ns3_{name}.csv"
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, list(rows[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    print_now(f"{path.relative_to(ROOT)}: {len(rows)} rows")


def median_and_quartiles(name: str, values: list[float]) -> dict[str, float]:
    """Return median and quartiles over the runs of a setting."""
    low, middle, high = statistics.quantiles(values, n=4, method="inclusive")
    return {name: round(middle, 9), f"{name}_q25": round(low, 9), f"{name}_q75": round(high, 9)}


def setting_rows(results: dict[Run, list[dict[str, Any]]]) -> list[dict[str, object]]:
    """Return a row for each setting: its options, medians, quartiles, and summed counts."""
    rows = []
    for run, group in results.items():
        row: dict[str, object] = dataclasses.asdict(run) | {"runs": len(group)}
        del row["seed"]
        cold, places = row.pop("cold", 0), (row.pop("radius", 0.0), row.pop("delays", 1))
        if row.get("scenario") == "agreements":
            row["scenario"] = "cold" if cold else "in place"
        elif row.get("scenario") == "capture":
            row["radius_m"], row["delays"] = places
        counts = {name: sum(values[name] for values in group) for name in group[0]}
        if isinstance(run, Burst):
            row |= median_and_quartiles(
                "drain_time_s", [values["drain_time_s"] for values in group]
            )
            row |= median_and_quartiles(
                "lost", [1 - values["arrived"] / values["expected"] for values in group]
            )
        elif isinstance(run, Saturation):
            row |= median_and_quartiles(
                "frames_per_s", [values["acked"] / run.duration_s for values in group]
            )
        counts = {
            name: round(value, 9) for name, value in counts.items() if name not in TIME_COLUMNS
        }
        rows.append(row | counts | {"source": f"{source(run)} --seed 1 to {len(group)}"})
    return rows


def median_cpu_times(results: dict[Run, list[dict[str, Any]]]) -> list[dict[str, object]]:
    """Return the median CPU time of the bursts without queue limits."""
    return [
        {
            "protocol": run.protocol,
            "hosts": run.hosts,
            "ampdu": run.ampdu,
            "runs": len(group),
            "cpu_s": f"{statistics.median(values['cpu_s'] for values in group):.3g}",
            "source": f"{source(run)} --seed 1 to {len(group)}",
        }
        for run, group in results.items()
        if isinstance(run, Burst) and run.scenario == "unlimited"
    ]


def write_tables() -> None:
    """Write the tables of all runs that have a result."""
    results: defaultdict[Run, list[dict[str, Any]]] = defaultdict(list)
    for run in RUNS:
        setting = results[dataclasses.replace(run, seed=1)]
        # Seeds must be consecutive: the table names only the first and the last.
        if cache_path(run).exists() and len(setting) == run.seed - 1:
            setting.append(cached_result(run))
    complete = {run: group for run, group in results.items() if len(group) >= 10}
    write_table("frames", list(frame_airtimes()))
    files: defaultdict[str, dict[Run, list[dict[str, Any]]]] = defaultdict(dict)
    beside = {run: group for run, group in complete.items() if isinstance(run, MixedTraffic)}
    write_table("mixed", mixed.setting_rows(beside, source, median_and_quartiles))
    for run, group in complete.items():
        if isinstance(run, MixedTraffic):
            continue
        name = "saturation" if isinstance(run, Saturation) else "bursts"
        if isinstance(run, Burst) and run.scenario in ("agreements", "capture"):
            name = run.scenario
        files[name][run] = group
    for name, of_file in files.items():
        write_table(name, setting_rows(of_file))
    write_table("times", median_cpu_times(complete))


#: Bursts whose CPU time both simulators measure: Fig. 2 of the paper at its last host.
TIMED_BURSTS = [
    Burst(protocol=protocol, hosts=12, ampdu=ampdu)
    for protocol in PROTOCOLS
    for ampdu in (0, 65535)
]


def simulate_here(run: Burst) -> Callable[[int], object]:
    """Return a function that simulates the burst here from a seed, after its set-up."""
    scenario = Scenario(
        ds.Fleet.swarm(run.hosts, run.processes, run.endpoints),
        PROTOCOLS[run.protocol],
        ds.Radio("802.11n", streams=2, aifsn=run.aifsn, mpdus=64 if run.ampdu else 1).wifi(),
        queue=(float("inf"), float("inf")),
        recovery=False,
        block_ack="established",
    )
    setup = set_up(scenario)
    return lambda seed: simulate_run(setup, np.random.SeedSequence(seed))


def compare_speed(rounds: int) -> None:
    """Measure both simulators, alternating within each round."""
    compile_engine()  # compile before the first run
    rows: list[dict[str, object]] = []
    for run in TIMED_BURSTS:
        simulate = simulate_here(run)
        simulate(0)
        theirs_s, ours_s = [], []
        for seed in range(1, rounds + 1):
            answer = json.loads(run_program(dataclasses.replace(run, seed=seed).options()))
            theirs_s.append(answer["cpu_s"])
            begin = time.process_time()
            for number in range(OUR_RUNS_PER_NS3_RUN):
                simulate(OUR_RUNS_PER_NS3_RUN * seed + number)
            ours_s.append((time.process_time() - begin) / OUR_RUNS_PER_NS3_RUN)
        fastest = min(theirs_s), min(ours_s)
        rows.append(
            {
                "protocol": run.protocol,
                "hosts": run.hosts,
                "ampdu": run.ampdu,
                "rounds": rounds,
                "ns3_cpu_s": f"{fastest[0]:.3g}",
                "simulate_cpu_s": f"{fastest[1]:.3g}",
                "ratio": f"{fastest[0] / fastest[1]:.3g}",
                "source": f"ns-3 {VERSION}: time --rounds {rounds}; the fastest round of each",
            }
        )
        print_now(
            ", ".join(f"{name} {value}" for name, value in rows[-1].items() if name != "source")
        )
    write_table("speed", rows)


def estimated_cost(run: Run) -> float:
    """Estimate a run's duration, without unit: sent frames times receiving stations."""
    if isinstance(run, MixedTraffic):
        return 3000 * run.until_s
    if isinstance(run, Saturation):
        return 3000 * run.duration_s * run.stations
    frames = run.hosts * (run.hosts - 1) * run.processes**2 * (run.endpoints + 4)
    if run.queue_frames:
        # Transmissions hardly continue beyond the queue's lifetime.
        frames = min(frames, run.hosts * run.queue_frames, 3000)
    return run.hosts * frames * (0.1 if run.ampdu else 1)


def scenario_of_run(run: Run) -> str:
    """Return the name by which a run is chosen."""
    return run.scenario if isinstance(run, Burst) else type(run).__name__.lower()


def run_missing(jobs: int, only: str | None) -> None:
    """Run all missing simulations, short ones first, and write the tables."""
    wanted = [run for run in RUNS if only in (None, scenario_of_run(run))]
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        pending = [pool.submit(cached_result, run) for run in sorted(wanted, key=estimated_cost)]
        try:
            for done in tqdm(concurrent.futures.as_completed(pending), "ns-3", len(pending)):
                done.result()
        except (KeyboardInterrupt, SystemExit):
            pool.shutdown(cancel_futures=True)
            raise
    write_tables()


def add_options(parser: argparse.ArgumentParser, kind: type[Run]) -> None:
    """Add an option to a parser for each field of a run."""
    for field in dataclasses.fields(kind):
        if field.name == "scenario":
            continue
        parser.add_argument(
            f"--{field.name}",
            type=type(field.default),
            default=field.default,
            choices=list(PROTOCOLS) if field.name == "protocol" else None,
            help=f"default: {field.default}",
        )


def main() -> None:
    """Run the sweep, or one scenario."""
    parser = argparse.ArgumentParser(prog="make ns3", description=__doc__)
    kinds = parser.add_subparsers(dest="kind", required=True)
    every = kinds.add_parser("sweep", help="all scenarios and their tables (the default)")
    kinds.add_parser("tables", help="write the tables from the runs that are cached")
    both = kinds.add_parser("time", help="the CPU time of ns-3 and of ds.simulate, side by side")
    both.add_argument("--rounds", type=int, default=5, help="default: 5")
    every.add_argument("--jobs", type=int, default=2, help="runs side by side, default: 2")
    every.add_argument("--only", help="one scenario, saturation or mixed")
    add_options(kinds.add_parser("burst", help="one burst, not cached, with its CPU time"), Burst)
    add_options(kinds.add_parser("saturation", help="one run in saturation"), Saturation)
    add_options(kinds.add_parser("mixed", help="one burst beside user data"), MixedTraffic)
    arguments = vars(parser.parse_args(sys.argv[1:] or ["sweep"]))
    kind = arguments.pop("kind")
    compile_program()
    CACHE.mkdir(parents=True, exist_ok=True)
    if kind == "tables":
        write_tables()
        return
    if kind == "time":
        compare_speed(arguments["rounds"])
        return
    if kind == "sweep":
        run_missing(arguments["jobs"], arguments["only"])
        return
    run: Run = {"burst": Burst, "saturation": Saturation, "mixed": MixedTraffic}[kind](**arguments)
    print_now(run_program(command_options(run)).rstrip())


if __name__ == "__main__":
    main()
