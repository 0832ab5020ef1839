"""Build storm.cc, run its scenarios in ns-3 and write their tables; README.md tells of them."""

import argparse
import concurrent.futures
import csv
import dataclasses
import hashlib
import json
import os
import statistics
import subprocess
import sys
from collections import defaultdict
from collections.abc import Iterable, Iterator
from pathlib import Path

from tqdm import tqdm

import discostorm as ds
from discostorm.messages import ENDPOINT_PAIR

HERE = Path(__file__).parent
ROOT = HERE.parents[1]
BUILD = ROOT / "build" / "ns3"
NS3 = BUILD / "packages" / "ns3"
CACHE = BUILD / "results"
TABLES = ROOT / "discostorm" / "data" / "measured"
VERSION = "3.44"
PROGRAM = BUILD / "storm"
PROTOCOLS = {protocol.name: protocol for protocol in (ds.DDS, ds.ZENOH)}

#: Libraries of ns-3 that the program or another of them needs.
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

#: ns-3's default queue, and Linux's in order of magnitude: frames and seconds.
QUEUE = (500, 0.5)


@dataclasses.dataclass(frozen=True)
class Burst:
    """One run of a burst; its fields are the options and columns that README.md explains."""

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

    def options(self) -> list[str]:
        """Return the program's options."""
        named = "hosts processes order ampdu request aifsn queue_frames queue_s window_s loss seed"
        return [
            f"--messages={messages(self.protocol, self.endpoints)}",
            *(f"--{name}={getattr(self, name)}" for name in named.split()),
        ]


@dataclasses.dataclass(frozen=True)
class Saturation:
    """One run of stations that always have a frame for the access point."""

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


Run = Burst | Saturation


def messages(protocol: str, endpoints: int) -> str:
    """Return a protocol's table as the program reads it."""
    rows = []
    for message in PROTOCOLS[protocol].messages:
        count = message.per_unit * (endpoints if message.unit is ENDPOINT_PAIR else 1)
        rows.append(f"{message.name}:{message.cast}:{message.frame_bytes:g}:{count:g}")
    return ",".join(rows)


def command(run: Run) -> str:
    """Return the command that repeats a run."""
    default = type(run)()
    options = " ".join(
        f"--{field.name} {getattr(run, field.name)}"
        for field in dataclasses.fields(run)
        if getattr(run, field.name) != getattr(default, field.name)
    )
    return f'make ns3 ARGS="{type(run).__name__.lower()} {options}"'


def say(text: str) -> None:
    """Print, also before the compiler and other programs do."""
    print(text, flush=True)  # noqa: T201


def build() -> None:
    """Compile the program if its source changed since."""
    source = HERE / "storm.cc"
    mark = BUILD / "storm.sha256"
    digest = hashlib.sha256(source.read_bytes()).hexdigest()
    if PROGRAM.exists() and mark.exists() and mark.read_text() == digest:
        return
    say("Compiling storm.cc (once) ...")
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


def storm(options: Iterable[str]) -> str:
    """Run the program and return what it prints."""
    done = subprocess.run([str(PROGRAM), *options], capture_output=True, text=True, check=False)
    if done.returncode:
        sys.exit(f"discostorm: storm {' '.join(options)}: {done.stderr.strip()}")
    return done.stdout


def result(run: Run) -> dict[str, float]:
    """Return the result of a run, from the cache if it ran before with the same program."""
    key = hashlib.sha256("\n".join([(BUILD / "storm.sha256").read_text(), *run.options()]).encode())
    cached = CACHE / f"{key.hexdigest()}.json"
    if not cached.exists():
        text = storm(run.options())
        part = cached.with_suffix(f".{os.getpid()}")
        part.write_text(text)
        part.rename(cached)
    values: dict[str, float] = json.loads(cached.read_text())
    return values


def bursts() -> Iterator[Burst]:
    """Yield all runs of bursts, the most wanted first."""
    every = (2, 3, 4, 5, 6, 7, 8, 10, 12)
    both = [(name, ampdu) for name in PROTOCOLS for ampdu in (0, 65535)]
    frames, seconds = QUEUE
    queues: tuple[tuple[str, tuple[int, ...], dict[str, float]], ...] = (
        ("no limit", every, {}),
        ("queue", every, {"queue_frames": frames, "queue_s": seconds}),
        ("short queue", (2, 4, 6, 8, 12), {"queue_frames": 100, "queue_s": seconds}),
    )
    for scenario, hosts, options in queues:
        for count in hosts:
            for name, ampdu in both:
                for seed in range(1, (20 if count <= 4 else 10) + 1):
                    yield Burst(
                        scenario,
                        name,
                        count,
                        ampdu=ampdu,
                        seed=seed,
                        **options,  # type: ignore[arg-type]
                    )
    for count in (4, 8, 12):
        for window in (0.5, 1.0, 2.0, 5.0):
            for name, ampdu in both:
                for seed in range(1, 11):
                    yield Burst(
                        "staggered",
                        name,
                        count,
                        ampdu=ampdu,
                        queue_frames=frames,
                        queue_s=seconds,
                        window_s=window,
                        seed=seed,
                    )
    for count in (3, 5, 8):
        for loss in (0.05, 0.2):
            for limits in ((0, 0.0), QUEUE):
                for name, ampdu in both:
                    for seed in range(1, 11):
                        yield Burst(
                            "errors",
                            name,
                            count,
                            ampdu=ampdu,
                            queue_frames=limits[0],
                            queue_s=limits[1],
                            loss=loss,
                            seed=seed,
                        )
    others: tuple[tuple[str, dict[str, int | str]], ...] = (
        ("other order", {"order": "messages"}),
        ("no request", {"request": 0}),
        ("AIFSN 2", {"aifsn": 2}),
        ("one process", {"processes": 1}),
        ("four processes", {"processes": 4, "endpoints": 4}),
    )
    for scenario, other in others:
        for count in (3, 6):
            for limits in ((0, 0.0), QUEUE):
                for ampdu in (0, 65535):
                    for seed in range(1, 11):
                        yield Burst(
                            scenario,
                            "DDS",
                            count,
                            ampdu=ampdu,
                            queue_frames=limits[0],
                            queue_s=limits[1],
                            seed=seed,
                            **other,  # type: ignore[arg-type]
                        )


def saturations() -> Iterator[Saturation]:
    """Yield all runs in saturation."""
    for frame, aifsn in ((464, 3), (464, 2), (1538, 3)):
        for stations in (1, 2, 5, 10, 20, 30, 50):
            for seed in range(1, 11):
                yield Saturation(stations, frame, aifsn, seed=seed)


def frames() -> Iterator[dict[str, object]]:
    """Yield airtime of single frames and of A-MPDUs, read from the trace of one sender."""
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
                    rows = [line.split(",") for line in storm(options).splitlines()[:-1]]
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
                            "ns3": VERSION,
                            "command": f"build/ns3/storm {' '.join(options)}",
                        }


def write(name: str, rows: list[dict[str, object]]) -> None:
    """Write one table."""
    TABLES.mkdir(parents=True, exist_ok=True)
    path = TABLES / name
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, list(rows[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    say(f"{path.relative_to(ROOT)}: {len(rows)} rows")


def table(runs: list[Run], results: dict[Run, dict[str, float]]) -> list[dict[str, object]]:
    """Return a row for each run that has a result; CPU time is not repeatable and left out."""
    rows: list[dict[str, object]] = []
    for run in runs:
        if run in results:
            values = {name: value for name, value in results[run].items() if name != "cpu_s"}
            row = dataclasses.asdict(run) | values
            rows.append(row | {"ns3": VERSION, "command": command(run)})
    return rows


def times(runs: Iterable[Burst], results: dict[Run, dict[str, float]]) -> list[dict[str, object]]:
    """Return the median CPU time of the bursts without limits of queue."""
    groups = defaultdict(list)
    for run in runs:
        if run in results and run.scenario == "no limit":
            groups[run.protocol, run.hosts, run.ampdu].append(results[run]["cpu_s"])
    return [
        {"protocol": key[0], "hosts": key[1], "ampdu": key[2], "runs": len(group)}
        | {"cpu_s": f"{statistics.median(group):.3g}", "ns3": VERSION}
        for key, group in sorted(groups.items())
    ]


def sweep(jobs: int, only: str | None) -> None:
    """Run what is not cached and write the tables of all that is."""
    CACHE.mkdir(parents=True, exist_ok=True)
    burst_runs, saturation_runs = list(bursts()), list(saturations())
    wanted: list[Run] = [*burst_runs[: len(burst_runs) // 2], *saturation_runs]
    wanted += burst_runs[len(burst_runs) // 2 :]
    if only:
        wanted = [run for run in wanted if only == getattr(run, "scenario", "saturation")]
    results: dict[Run, dict[str, float]] = {}
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        pending = {pool.submit(result, run): run for run in wanted}
        try:
            for done in tqdm(concurrent.futures.as_completed(pending), "ns-3", len(pending)):
                results[pending[done]] = done.result()
        except (KeyboardInterrupt, SystemExit):
            pool.shutdown(cancel_futures=True)
            raise
    if only:
        return
    write("ns3_frames.csv", list(frames()))
    write("ns3_bursts.csv", table([*burst_runs], results))
    write("ns3_saturation.csv", table([*saturation_runs], results))
    write("ns3_times.csv", times(burst_runs, results))


def add_options(parser: argparse.ArgumentParser, kind: type[Run]) -> None:
    """Give a parser an option for each field of a run."""
    for field in dataclasses.fields(kind):
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
    kinds = parser.add_subparsers(dest="kind")
    every = kinds.add_parser("sweep", help="all scenarios and their tables (the default)")
    for one in (parser, every):
        one.add_argument("--jobs", type=int, default=2, help="runs side by side, default: 2")
        one.add_argument("--only", help="one scenario; writes no tables")
    add_options(kinds.add_parser("burst", help="one burst, not cached, with its CPU time"), Burst)
    add_options(kinds.add_parser("saturation", help="one run in saturation"), Saturation)
    arguments = vars(parser.parse_args())
    kind = arguments.pop("kind")
    build()
    if kind in (None, "sweep"):
        sweep(arguments["jobs"], arguments["only"])
        return
    del arguments["jobs"], arguments["only"]
    run = Burst(**arguments) if kind == "burst" else Saturation(**arguments)
    say(storm(run.options()).rstrip())


if __name__ == "__main__":
    main()
