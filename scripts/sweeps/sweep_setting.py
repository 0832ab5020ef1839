"""A setting of a sweep: its options, its run, and its cached result."""

import json
import re
from dataclasses import asdict, dataclass
from fractions import Fraction
from hashlib import sha256
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import discostorm as ds
from discostorm.data import data_path
from discostorm.messages import Protocol
from discostorm_book.assumption_ladder import MAX_RUNS as MAX_RUNS
from discostorm_planner import staggered_start
from discostorm_simulation import starts
from discostorm_simulation.result import CAUSES

ROOT = Path(__file__).parents[2]
CACHE = ROOT / "build" / "simulate"


def table_path(name: str) -> Path:
    """Return the path of a sweep's table."""
    return ROOT / f"packages/book/discostorm_book/data/simulated/{name}.csv"


PAPER_TABLES = ("DDS", "Zenoh")
#: Tables of the products' measured traffic.
MEASURED_TABLES = ("Fast DDS", "Cyclone DDS", "Zenoh peer")
#: Tables of the paper, of the paper with the products' timers, and of the products.
ALL_TABLES = (
    *PAPER_TABLES,
    "DDS, periods of Fast DDS",
    "DDS, periods of Cyclone DDS",
    "Zenoh, periods of Zenoh peer",
    *("Fast DDS 3.6", "Cyclone DDS", "Zenoh peer"),
)
SEED = 2026
#: Number of runs from which a row has a confidence interval of the median (rows with recovery or
#: without queue limits), and the interval's confidence: two such intervals, or their ratio, hold
#: together with at least 95 % (Bonferroni).
MANY_RUNS, CONFIDENCE = 100, Fraction("0.975")
# A host count is decided if its interval ends within the limit and the interval of the next count
# starts beyond it. Undecided settings get `MANY_RUNS` runs, then four times as many, up to
# `MAX_RUNS`; the count then has a range.

#: Digest of the simulator: results of another engine must not be reused.
ENGINE_DIGEST = sha256(data_path("engine.wasm", "discostorm_simulation").read_bytes()).hexdigest()
SOURCE = {"source": f"ds.simulate, seed {SEED}"}


@dataclass(frozen=True)
class SweepSetting:
    """One row: a simulation and its number of runs."""

    protocol: str
    hosts: int
    processes: int = 2
    endpoints: int = 10
    #: "n": 802.11n as in the paper, two streams; "ax": 802.11ax at 80 MHz, two streams.
    radio: str = "n"
    mpdus: int = 1
    #: Limits of the queues: frames [1] and seconds [s]; 0 for no limit.
    queue_frames: int = 500
    queue_s: float = 0.5
    loss: float = 0.0
    #: Starts of the hosts: "together", "random" within ``window_s``, "rule" (random within
    #: `staggered_start.start_window`), or "in turn" (`staggered_start.start_times_in_turn`).
    start: str = "together"
    window_s: float = 0.0
    recovery: int = 0
    until_s: float = 120.0
    runs: int = 20
    #: Block acknowledgement agreements: "cold" (negotiated after the start) or "in place".
    agreements: str = "cold"

    @property
    def wifi(self) -> ds.Wifi:
        """The channel."""
        standard, width = {"n": ("802.11n", 20e6), "ax": ("802.11ax", 80e6)}[self.radio]
        return ds.Radio(standard, streams=2, width=width, aifsn=3, mpdus=self.mpdus).wifi()

    @property
    def swarm(self) -> tuple[ds.Protocol, int, int, int, ds.Wifi]:
        """Arguments of the functions of `staggered`."""
        protocol = ds.PROTOCOLS[self.protocol]
        return protocol, self.hosts, self.processes, self.endpoints, self.wifi

    @property
    def start_times(self) -> Any:
        """Starts of the hosts, as an argument for `ds.simulate`."""
        if self.start == "together":
            return 0.0
        if self.start == "in turn":
            return staggered_start.start_times_in_turn(*self.swarm)
        return starts.uniform_start(self.window)

    @property
    def window(self) -> float:
        """Start of the last host [s]."""
        if self.start == "in turn":
            return float(self.start_times[-1])
        return staggered_start.start_window(*self.swarm) if self.start == "rule" else self.window_s

    @property
    def fleet(self) -> ds.Fleet:
        """Hosts on the channel."""
        return ds.Fleet.swarm(self.hosts, self.processes, self.endpoints)

    @property
    def table(self) -> Protocol:
        """Table of the hosts' messages."""
        return ds.PROTOCOLS[self.protocol]

    def run(self) -> dict[str, object]:
        """Simulate the setting and return the row's results."""
        queue = (self.queue_frames or np.inf, self.queue_s or np.inf)
        found = ds.simulate(
            self.fleet,
            self.table,
            self.wifi,
            queue=queue,
            start=self.start_times,
            loss=self.loss,
            recovery=bool(self.recovery),
            runs=self.runs,
            seed=SEED,
            until=self.until_s,
            block_ack="negotiate" if self.agreements == "cold" else "established",
        )
        expected = found.counts["expected"].sum()
        row: dict[str, object] = {"begun_s": round_six_digits(self.window)}
        row |= median_and_quartiles("drain_time_s", found.drain_time)
        row |= median_and_quartiles("lost", found.lost)
        row |= median_and_quartiles("convergence_time_s", found.convergence_time)
        if self.runs >= MANY_RUNS and self.recovery:
            row |= median_interval("convergence_time_s", found.convergence_time)
        elif self.runs >= MANY_RUNS and not self.queue_frames:
            row |= median_interval("drain_time_s", found.drain_time)
        row |= {name: round_six_digits(found.counts[name].sum() / expected) for name in CAUSES}
        row["converged"] = int(np.isfinite(found.convergence_time).sum())
        row["expired"] = round_six_digits(found.counts["expired"].mean())
        row["collided"] = round_six_digits(
            found.counts["collided"].sum() / found.counts["ppdus"].sum()
        )
        return row


def round_six_digits(value: float) -> str:
    """Return a number rounded to six significant digits, for tables."""
    return f"{value:.6g}"


def median_and_quartiles(name: str, values: NDArray[np.float64]) -> dict[str, object]:
    """Return median and quartiles; each is one of the values, so that infinity stays."""
    quantiles = np.quantile(values, [0.5, 0.25, 0.75], method="higher")
    names = (name, f"{name}_q25", f"{name}_q75")
    return {
        key: round_six_digits(float(value)) for key, value in zip(names, quantiles, strict=True)
    }


def median_interval(name: str, values: NDArray[np.float64]) -> dict[str, object]:
    """Return a distribution-free confidence interval of the median, as two of the values.

    The number of values below the median has a binomial distribution with probability one half.
    """
    runs, skipped = len(values), 0
    ways = below = 1  # integers, because no float can hold these counts for thousands of runs
    while 2 * (below + (ways := ways * (runs - skipped) // (skipped + 1))) <= 2**runs * (
        1 - CONFIDENCE
    ):
        skipped += 1
        below += ways
    ascending = np.sort(values)
    low, high = float(ascending[skipped]), float(ascending[runs - 1 - skipped])
    return {f"{name}_low": round_six_digits(low), f"{name}_high": round_six_digits(high)}


def cache_path(setting: SweepSetting) -> Path:
    """Return the path of a setting's cached result."""
    of_setting = (asdict(setting), ds.PROTOCOLS[setting.protocol], setting.wifi, setting.window)
    text = repr((of_setting, SEED, ENGINE_DIGEST))
    table = re.sub(r" at 0x[0-9a-f]+", "", text)  # addresses of functions
    return CACHE / f"{sha256(table.encode()).hexdigest()[:24]}.json"


def cached_result(setting: SweepSetting) -> dict[str, object]:
    """Return the result of a setting, from the cache if possible."""
    path = cache_path(setting)
    if not path.exists():
        row = setting.run()
        CACHE.mkdir(parents=True, exist_ok=True)
        # Rename a complete file, so that an interruption leaves nothing half-written.
        path.with_suffix(".part").write_text(json.dumps(row), encoding="utf-8")
        path.with_suffix(".part").replace(path)
    loaded: dict[str, object] = json.loads(path.read_text(encoding="utf-8"))
    return loaded
