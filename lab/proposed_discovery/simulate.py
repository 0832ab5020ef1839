"""Simulate the hybrid discovery and store one row per run.

The book's `data/simulated/hybrid.csv` tests the goals. `hybrid_lab.csv` holds simulations of the
lab's runs with losses, and of runs without losses up to the first heartbeats.

We tuned times, shares and rules with seeds below 300. A first round with seeds from 300 on is not
stored: one run of the 20 robots (no goal) took long, so we changed a rule: a repair that needs only
one part always contains the sender's own part.
"""

import argparse
import csv
import sys
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np
from joblib import Parallel, delayed
from numpy.typing import NDArray
from tqdm import tqdm

import discostorm as ds
from discostorm.data import data_path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from proposed_discovery.simulation import Choice, Crash, simulate_proposed_discovery
from proposed_discovery.speaker import Speakers

SIMULATED = data_path("simulated", "discostorm_book")
TABLE, LAB_TABLE = SIMULATED / "hybrid.csv", SIMULATED / "hybrid_lab.csv"
COLUMNS = (
    *("scenario", "seed", "converged_s", "airtime_s", "airtime_converged_s", "busiest_second_s"),
    *("mistaken", "gone_s", "announces", "digests", "repairs", "pulls", "heartbeats"),
    *("collisions", "dropped"),
)
LAB_COLUMNS = ("scenario", "software", "hosts", "seed", "converged_s", "airtime_s")
#: Scenarios of the lab, without failures of settled hosts.
LAB_SCENARIOS = ("losses", "newcomer", "half killed at 0.25 s")
FIRST_SEED = 300
#: Start of late joiners, and time at which hosts of a settled fleet fail [s].
EVENT_TIME = 1.0
#: Start and end of the separation of the halves [s]: long enough for all hosts to drop the other
#: half, with the first heartbeat after a lease.
SEPARATION = (1.0, 36.0)
#: Window in which hosts start one by one [s].
START_WINDOW = 100.0


def knows_most(speakers: Speakers, rng: np.random.Generator) -> Any:
    """Choose the hosts that hold the most sets."""
    held = np.bitwise_count(speakers.held).sum(axis=1)
    return np.argsort(-(held + rng.random(held.size)))[: held.size // 2]


def speaks_most(speakers: Speakers, rng: np.random.Generator) -> Any:
    """Choose the hosts that have sent the most messages, pulls and repairs included."""
    return np.argsort(-(speakers.sent + rng.random(speakers.hosts)))[: speakers.hosts // 2]


def repairs_next(speakers: Speakers, _: np.random.Generator) -> Any:
    """Choose the hosts whose digest or repair is due next."""
    return np.argsort(speakers.due[1:3].min(axis=0))[: speakers.hosts // 2]


def random_start_times(hosts: int, seed: int) -> NDArray[np.float64]:
    """Draw random start times; the last host starts at the end of the window [s]."""
    times = np.random.default_rng([seed, hosts]).random(hosts) * START_WINDOW
    times[times.argmax()] = START_WINDOW
    return times


def choose_first_hosts(count: int) -> Choice:
    """Return a function that chooses the first hosts."""
    return lambda *_: np.arange(count)


ADVERSARIES = (knows_most, speaks_most, repairs_next)


def scenarios() -> dict[str, dict[str, Any]]:
    """Return the arguments of a simulation, and its fleet, for each scenario by name."""
    settled, halves = np.full(100, -100.0), np.arange(100) % 2
    ends = {"until": 6, "enough": 1.5}
    newcomer = settled.copy()
    newcomer[99] = EVENT_TIME
    mass = settled.copy()
    mass[50:] = EVENT_TIME
    healed = {"start": settled, "part": halves, "apart": SEPARATION, "until": 60, "enough": 1.5}
    found: dict[str, dict[str, Any]] = {
        "alike": {"alike": True} | ends,
        "unlike": ends,
        "newcomer, alike": {"alike": True, "start": newcomer} | ends,
        "newcomer": {"start": newcomer} | ends,
        "halves, alike": {"alike": True, "start": settled, "part": halves} | ends,
        "halves": {"start": settled, "part": halves} | ends,
    }
    for name, alike in (("", False), (", alike", True)):
        found[f"50 join 50{name}"] = {"alike": alike, "start": mass, "until": 20, "enough": 1.5}
        found[f"halves after a lease{name}"] = {"alike": alike} | healed
    for hosts in (25, 50, 100, 200):
        found[f"{hosts} start within {START_WINDOW:g} s"] = {
            "fleet": (hosts, 2, 10),
            "start": random_start_times,
            "until": START_WINDOW + 20,
            "enough": 1.5,
        }
    for adversary in ADVERSARIES:
        for time in (0.5, 1.0, 1.5):
            name = f"50 die at {time} s, {adversary.__name__}"
            found[name] = {"crash": Crash(time, adversary), "until": 12, "enough": 1.5}
    for count in (1, 50):
        found[f"{count} of a settled fleet die"] = {
            "start": settled,
            "crash": Crash(EVENT_TIME, choose_first_hosts(count)),
            "until": 36,
        }
    found["steady for 1000 s"] = {"start": settled, "until": 1000}
    found["1000, alike"] = {"fleet": (1000, 2, 10), "alike": True, "until": 60, "enough": 0.5}
    found["1000"] = {"fleet": (1000, 2, 10), "until": 60, "enough": 0.5}
    for fade in (0.1, 0.5):
        found[f"unlike, fades of {fade} s"] = {"fade": fade, "until": 20, "enough": 1.5}
    found["unlike, queues of 20"] = {"queue": (20, 0.5), "until": 8, "enough": 1.5}
    found["20 robots of 678 endpoints"] = {"fleet": (20, 1, 678), "until": 60, "enough": 1.5}
    return found


def max_runs_of_scenario(name: str) -> int:
    """Return the maximum number of runs of a scenario: 100 if the scenario has a goal."""
    few = {f"{hosts} start within {START_WINDOW:g} s": 10 for hosts in (25, 50, 200)}
    return (few | {"1000, alike": 25}).get(name, 100)


def simulate_scenario(name: str, seed: int) -> dict[str, Any]:
    """Simulate one run and return its row."""
    settings = dict(scenarios()[name])
    fleet = ds.Fleet.swarm(*settings.pop("fleet", (100, 2, 10)))
    if callable(settings.get("start")):
        settings["start"] = settings["start"](int(fleet.hosts()), seed)
    found = simulate_proposed_discovery(fleet, ds.PAPER, seed=seed, **settings)
    frames = found.frames
    return {
        "scenario": name,
        "seed": seed,
        "converged_s": f"{found.convergence_time:.4f}",
        "airtime_s": f"{found.airtime:.5f}",
        "airtime_converged_s": f"{found.airtime_converged:.5f}",
        "busiest_second_s": f"{found.busiest_second:.5f}",
        "mistaken": found.mistaken,
        "gone_s": f"{found.gone:.3f}",
        "announces": frames.get("Announce", 0),
        "digests": frames.get("Digest", 0),
        "repairs": frames.get("Repair", 0),
        "pulls": frames.get("Pull", 0) + frames.get("Data", 0),
        "heartbeats": frames.get("Heartbeat", 0),
        "collisions": found.collisions,
        "dropped": found.dropped,
    }


def write_table(path: Path, columns: tuple[str, ...], rows: Iterable[dict[str, Any]]) -> None:
    """Write a table atomically."""
    path.parent.mkdir(parents=True, exist_ok=True)
    fresh = path.with_suffix(".part")
    with fresh.open("w", newline="", encoding="utf-8") as file:
        table = csv.DictWriter(file, columns, lineterminator="\n")
        table.writeheader()
        table.writerows(rows)
    fresh.replace(path)


def sort_rows(rows: dict[tuple[str, int], dict[str, Any]]) -> list[dict[str, Any]]:
    """Return the rows of the known scenarios, in their order and by seed."""
    return [
        rows[key] for name in scenarios() for key in sorted(key for key in rows if key[0] == name)
    ]


def lab_runs() -> list[tuple[str, str, int, int]]:
    """Return scenario, software, hosts and seed of the runs that the book compares with the lab."""
    with (Path(__file__).with_name("grid.csv")).open(newline="") as file:
        rows = [row for row in csv.DictReader(file) if row["scenario"] in LAB_SCENARIOS]
    staged = [(row["scenario"], row["software"], int(row["hosts"])) for row in rows]
    quiet = [("no losses", "unlike", hosts, seed) for hosts in (7, 100) for seed in range(6)]
    return quiet + [(*point, seed) for point in staged for seed in range(1000, 1030)]


def simulate_lab_run(scenario: str, software: str, hosts: int, seed: int) -> dict[str, Any]:
    """Simulate a run of the lab; first heartbeats come 1.5 s after an announcement."""
    given: dict[str, Any] = {"until": 8, "enough": 1}
    since = 0.0
    if scenario == "no losses":
        given = {"loss": (0, 0), "until": 1.4}
    elif scenario == "newcomer":
        given["start"], since = np.full(hosts, -100.0), EVENT_TIME
        given["start"][-1] = EVENT_TIME
    elif scenario.startswith("half killed"):
        given["crash"] = Crash(0.25, choose_first_hosts(hosts // 2))
    fleet, alike = ds.Fleet.swarm(hosts, 2, 10), software == "alike"
    found = simulate_proposed_discovery(fleet, ds.PAPER, alike=alike, seed=seed, **given)
    values = (scenario, software, hosts, seed)
    times = (f"{found.convergence_time - since:.6f}", f"{found.airtime:.8f}")
    return dict(zip(LAB_COLUMNS, (*values, *times), strict=True))


def main() -> int:
    """Simulate the missing runs and write the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seeds", type=int, default=100, help="most runs of a scenario")
    parser.add_argument("--jobs", type=int, default=-1, help="processes side by side")
    parser.add_argument("--only", action="append", default=[], help="a scenario, by name")
    parser.add_argument("--out", type=Path, default=TABLE)
    parser.add_argument("--lab-out", type=Path, default=LAB_TABLE)
    given = parser.parse_args()
    names = list(scenarios())
    if unknown := set(given.only) - set(names):
        parser.error(f"--only {', '.join(sorted(unknown))}: not one of {', '.join(names)}")
    rows: dict[tuple[str, int], dict[str, Any]] = {}
    if given.out.exists():
        with given.out.open(newline="", encoding="utf-8") as file:
            rows = {(line["scenario"], int(line["seed"])): line for line in csv.DictReader(file)}
    todo = [
        (name, seed)
        for name in given.only or names
        for seed in range(FIRST_SEED, FIRST_SEED + min(given.seeds, max_runs_of_scenario(name)))
        if (name, seed) not in rows
    ]
    jobs = Parallel(n_jobs=given.jobs, return_as="generator_unordered")
    for line in tqdm(
        jobs(delayed(simulate_scenario)(*one) for one in todo), total=len(todo), unit="run"
    ):
        rows[line["scenario"], int(line["seed"])] = line
        write_table(given.out, COLUMNS, sort_rows(rows))  # keep finished rows after Ctrl-C
    write_table(given.out, COLUMNS, sort_rows(rows))
    beside = Parallel(n_jobs=given.jobs)(delayed(simulate_lab_run)(*one) for one in lab_runs())
    write_table(given.lab_out, LAB_COLUMNS, beside)
    return 0


if __name__ == "__main__":
    sys.exit(main())
