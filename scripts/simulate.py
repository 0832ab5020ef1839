"""Simulate the sweeps that the chapters read, and write their tables to data/simulated/.

Every row is one setting: its options, then medians and quartiles over its runs. What has been
simulated is kept in build/simulate, by setting and by the sources of the simulator, so that what
is interrupted goes on where it stopped, and what has not changed is not done again.
"""

import argparse
import csv
import json
import math
import re
import sys
from collections.abc import Callable, Iterable, Iterator
from dataclasses import asdict, dataclass, replace
from fractions import Fraction
from hashlib import sha256
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
from numpy.typing import NDArray

import discostorm as ds
from discostorm import staggered
from discostorm.book import air, trace
from discostorm.book.ladder import MOST_RUNS
from discostorm.data import data_path
from discostorm.messages import Protocol, Schedule
from discostorm.robots import laptop, robots
from discostorm.simulation import disc, powers
from discostorm.simulation._compile import sources
from discostorm.simulation.places import THRESHOLD
from discostorm.simulation.result import CAUSES
from discostorm.simulation.run import finish, set_up
from discostorm.simulation.traffic import ticks

ROOT = Path(__file__).parents[1]
CACHE = ROOT / "build" / "simulate"
TABLES = ROOT / "discostorm" / "data" / "simulated"

PAPER = ("DDS", "Zenoh")
#: What the products send.
BUILT = ("Fast DDS", "Cyclone DDS", "Zenoh peer")
#: The paper's counts, also with what the products repeat, and theirs.
ALL = (
    *PAPER,
    "DDS, periods of Fast DDS",
    "DDS, periods of Cyclone DDS",
    "Zenoh, periods of Zenoh peer",
    *BUILT,
)
SEED = 2026
#: From so many runs on a row with recovery, or without limits of the queues, has an interval of the
#: median, too; and how sure that is: so that two of them hold together at 95 % at least, dependent
#: or not (Bonferroni), and so does their ratio.
MANY, SURE = 100, Fraction("0.975")
#: A number of hosts is decided if the interval of the median with so many ends within the limit,
#: and that with one more begins beyond it: then more runs would not change it. Settings that this
#: asks for have `MANY` runs, and four times as many until it is decided or they have `MOST`; then
#: the number has the range of those that may be right.
MOST = MOST_RUNS
SOURCE = {"source": f"ds.simulate, seed {SEED}"}


@dataclass(frozen=True)
class Setting:
    """One row: what is simulated, how often."""

    protocol: str
    hosts: int
    processes: int = 2
    endpoints: int = 10
    #: "n": 802.11n as in the paper, two streams; "ax": 802.11ax at 80 MHz, two streams.
    radio: str = "n"
    mpdus: int = 1
    #: Frames and seconds of the queues; 0 for no limit.
    queue_frames: int = 500
    queue_s: float = 0.5
    loss: float = 0.0
    #: How the hosts start: "together", "random" within ``window_s``, "rule": random within the
    #: window of `staggered.window`, "in turn": `staggered.in_turn`.
    start: str = "together"
    window_s: float = 0.0
    recovery: int = 0
    until_s: float = 120.0
    runs: int = 20
    #: Of block acknowledgements, as `ds.simulate` takes it; matters with aggregation only.
    agreements: str = "cold"

    @property
    def wifi(self) -> ds.Wifi:
        """The channel."""
        standard, width = {"n": ("802.11n", 20e6), "ax": ("802.11ax", 80e6)}[self.radio]
        return ds.Radio(standard, streams=2, width=width, aifsn=3, mpdus=self.mpdus).wifi()

    @property
    def swarm(self) -> tuple[ds.Protocol, int, int, int, ds.Wifi]:
        """What the rules of `staggered` take."""
        protocol = ds.PROTOCOLS[self.protocol]
        return protocol, self.hosts, self.processes, self.endpoints, self.wifi

    @property
    def delays(self) -> Any:
        """When the hosts start, as `ds.simulate` takes it."""
        if self.start == "together":
            return 0.0
        if self.start == "in turn":
            return staggered.in_turn(*self.swarm)
        return staggered.at_random(self.window)

    @property
    def window(self) -> float:
        """By when the last host has begun [s]."""
        if self.start == "in turn":
            return float(self.delays[-1])
        return staggered.window(*self.swarm) if self.start == "rule" else self.window_s

    @property
    def fleet(self) -> ds.Fleet:
        """Who is on the channel."""
        return ds.Fleet.swarm(self.hosts, self.processes, self.endpoints)

    @property
    def table(self) -> Protocol:
        """What they send."""
        return ds.PROTOCOLS[self.protocol]

    def run(self) -> dict[str, object]:
        """Return the row's results."""
        queue = (self.queue_frames or np.inf, self.queue_s or np.inf)
        found = ds.simulate(
            self.fleet,
            self.table,
            self.wifi,
            queue=queue,
            start=self.delays,
            loss=self.loss,
            recovery=bool(self.recovery),
            runs=self.runs,
            seed=SEED,
            until=self.until_s,
            agreements=self.agreements,  # type: ignore[arg-type]
        )
        expected = found.counts["expected"].sum()
        row: dict[str, object] = {"begun_s": rounded(self.window)}
        row |= spread("drain_time_s", found.drain_time)
        row |= spread("lost", found.lost)
        row |= spread("convergence_time_s", found.convergence_time)
        if self.runs >= MANY and self.recovery:
            row |= interval("convergence_time_s", found.convergence_time)
        elif self.runs >= MANY and not self.queue_frames:
            row |= interval("drain_time_s", found.drain_time)
        row |= {name: rounded(found.counts[name].sum() / expected) for name in CAUSES}
        row["converged"] = int(np.isfinite(found.convergence_time).sum())
        row["expired"] = rounded(found.counts["expired"].mean())
        row["collided"] = rounded(found.counts["collided"].sum() / found.counts["ppdus"].sum())
        return row


@dataclass(frozen=True)
class Ready(Setting):
    """Ready-made robots with what ROS 2 shares, on a radio of `discostorm.WIFI`, for plans.

    Without recovery: the burst that `discostorm.model.burst` counts, all of it there at the start.
    """

    robot: str = ""
    #: Beside the robots.
    laptops: int = 0

    @property
    def wifi(self) -> ds.Wifi:
        """The channel."""
        radio = ds.WIFI[READY_RADIOS[self.radio]].radio
        assert radio is not None
        return replace(radio, mpdus=self.mpdus).wifi()

    @property
    def fleet(self) -> ds.Fleet:
        """Who is on the channel: processes have whole endpoints here."""
        own = replace(robots()[self.robot], hosts=self.hosts, endpoints=self.endpoints)
        return ds.Fleet((own, *(replace(laptop(), hosts=n) for n in [self.laptops] if n)))

    @property
    def table(self) -> Protocol:
        """What they send."""
        table = super().table
        return table if self.recovery else at_once(table)

    def run(self) -> dict[str, object]:
        """Return the row's results: what plans take of them."""
        row = super().run()
        return {name: row[name] for name in READY_COLUMNS}


def at_once(table: Protocol) -> Protocol:
    """Return a table of the same burst as another's, which sends all of it at the start."""
    messages = (
        replace(m, schedule=Schedule((0.0,)), answers=None, per_unit=m.per_unit * m.schedule.extra)
        for m in table.messages
        if m.schedule.extra > 0
    )
    return Protocol(table.name, tuple(messages))


def rounded(value: float) -> str:
    """Return a number with six digits, as it stands in a table."""
    return f"{value:.6g}"


def spread(name: str, values: NDArray[np.float64]) -> dict[str, object]:
    """Return median and quartiles; of values that are infinite the next whole run's."""
    quantiles = np.quantile(values, [0.5, 0.25, 0.75], method="higher")
    names = (name, f"{name}_q25", f"{name}_q75")
    return {key: rounded(float(value)) for key, value in zip(names, quantiles, strict=True)}


def interval(name: str, values: NDArray[np.float64]) -> dict[str, object]:
    """Return an interval of the median that is sure whatever the distribution: two of the values.

    The number of values below the median is binomial, with one half.
    """
    runs, skipped = len(values), 0
    ways = below = 1  # in whole numbers, which for thousands of runs no float can hold
    while 2 * (below + (ways := ways * (runs - skipped) // (skipped + 1))) <= 2**runs * (1 - SURE):
        skipped += 1
        below += ways
    ascending = np.sort(values)
    low, high = float(ascending[skipped]), float(ascending[runs - 1 - skipped])
    return {f"{name}_low": rounded(low), f"{name}_high": rounded(high)}


def each(base: Setting, **options: Iterable[Any]) -> list[Setting]:
    """Return the settings of all combinations, the first option slowest."""
    settings = [base]
    for name, values in options.items():
        settings = [replace(one, **{name: value}) for one in settings for value in values]
    return settings


ALONE = Setting("DDS", 2, queue_frames=0, queue_s=0.0)
HEALED = Setting("DDS", 2, recovery=1)
ONCE = Setting("DDS", 2, runs=10)
#: As in the bursts of ns-3 that these are compared with.
BESIDE = replace(ONCE, runs=100, agreements="in place")
#: Starts are compared with each other, so that medians of few runs do not do.
SPREAD = replace(HEALED, until_s=600.0, runs=100)


def with_runs(settings: list[Setting]) -> list[Setting]:
    """Return settings with as many runs as their stored table has, if it has them."""
    names = ["protocol", "hosts", "mpdus", "recovery", "start"]
    path = TABLES / "fits.csv"
    with path.open(encoding="utf-8") as file:
        runs = {tuple(row[name] for name in names): row["runs"] for row in csv.DictReader(file)}
    keys = [tuple(str(getattr(one, name)) for name in names) for one in settings]
    return [
        replace(one, runs=int(runs.get(key, one.runs)))
        for one, key in zip(settings, keys, strict=True)
    ]


#: Radios of ready-made robots, by what the column ``radio`` calls them.
READY_RADIOS = {"n": "802.11n 20 MHz 2x2", "ac": "802.11ac 80 MHz 2x2"}
#: What plans compare: as measured and as arranged, but for what Wi-Fi never sees, and static
#: endpoints, whose announcements of a large robot are longer than a datagram can be.
READY_TABLES = tuple(
    name
    for name, table in ds.PROTOCOLS.items()
    if table.basis in ("measured", "arranged")
    and table not in [other.wired for other in ds.PROTOCOLS.values()]
    and name != "static endpoints"
)
#: What of their results is kept.
READY_COLUMNS = (
    *("drain_time_s", "lost", "converged", "convergence_time_s"),
    *("convergence_time_s_q25", "convergence_time_s_q75"),
)
#: A run of so many of these takes up to a minute: more than a few only alone, on one radio.
MANY_PROCESSES, FEW_HOSTS, MOST_PROCESSES = 20, 4, 12
READY_HOSTS = (2, 4, 8, 12, 16)
#: With more it takes long, and small fleets show whether large ones can.
ENOUGH = {"Zenoh peer": 8, "of many processes": FEW_HOSTS}


def ready(tables: Iterable[str], options: dict[str, Any]) -> list[Setting]:
    """Return the settings of all ready-made robots, alone and beside a laptop."""
    return [
        Ready(
            table,
            hosts,
            int(robot.processes),
            round(robot.endpoints),
            radio,
            mpdus=64,
            robot=name,
            laptops=laptops,
            **options,
        )
        for table in tables
        for name, robot in robots().items()
        for hosts in READY_HOSTS
        for radio in READY_RADIOS
        for laptops in (0, 1)
        if robot.processes < MANY_PROCESSES
        or hosts <= FEW_HOSTS
        or (hosts <= MOST_PROCESSES and radio == "ac" and not laptops)
    ]


#: The tables.
SWEEPS: dict[str, Callable[[], list[Setting]]] = {
    "drain": lambda: each(
        ALONE, protocol=PAPER, mpdus=(1, 64), hosts=(*range(2, 13), 15, 20, 25, 30)
    ),
    "queues": lambda: each(
        ONCE, protocol=PAPER, mpdus=(1, 64), hosts=(*range(2, 13), 14, 16, 20, 25, 30, 40, 50)
    ),
    # Many runs, as single ones differ by many points in what is lost.
    "rates": lambda: each(
        replace(ONCE, runs=100),
        protocol=PAPER,
        radio=("n", "ax"),
        mpdus=(1, 64),
        hosts=(5, 7, 10),
    ),
    # What ns-3 was given, too.
    "beside_ns3": lambda: (
        each(
            BESIDE,
            protocol=PAPER,
            mpdus=(1, 64),
            hosts=(2, 3, 4, 5, 6, 7, 8, 10, 12),
        )
        + each(
            BESIDE,
            protocol=PAPER,
            mpdus=(1, 64),
            hosts=(3, 6),
            loss=(0.05, 0.2),
        )
        + each(
            replace(BESIDE, queue_frames=100),
            protocol=PAPER,
            mpdus=(1, 64),
            hosts=(4, 8, 12),
        )
    ),
    "built": lambda: (
        each(replace(ALONE, runs=10), protocol=BUILT, hosts=(5, 10, 20, 30))
        + each(ONCE, protocol=BUILT, hosts=(5, 10, 20, 30))
    ),
    "convergence": lambda: each(
        replace(HEALED, runs=10),
        protocol=ALL,
        loss=(0.0, 0.1, 0.3),
        hosts=(2, 4, 6, 8, 10, 12, 14, 16, 20, 24),
    ),
    "staggered": lambda: (
        each(
            replace(SPREAD, start="random"),
            protocol=PAPER,
            hosts=(5, 10, 15, 20),
            window_s=(0.5, 1.0, 2.0, 4.0, 7.0, 10.0, 15.0, 20.0, 30.0, 45.0),
        )
        + each(
            SPREAD,
            protocol=PAPER,
            hosts=(5, 10, 15, 20),
            start=("together", "rule", "in turn"),
            radio=("n", "ax"),
            mpdus=(1, 64),
        )
    ),
    "fits": lambda: with_runs(
        each(ALONE, protocol=PAPER, mpdus=(1, 64), hosts=range(2, 31))
        + each(
            replace(HEALED, until_s=30.0),
            protocol=PAPER,
            mpdus=(1, 64),
            start=("together", "rule", "in turn"),
            hosts=range(2, 31),
        )
        # With aggregation and a staggered start more fit.
        + each(
            replace(HEALED, until_s=30.0, mpdus=64),
            protocol=PAPER,
            start=("rule", "in turn"),
            hosts=range(31, 41),
        )
    ),
    # What plans and calculator look up: the burst by itself, and by when all is known.
    "ready": lambda: (
        ready((*PAPER, *READY_TABLES), {"queue_frames": 0, "queue_s": 0.0, "runs": 1})
        + ready(BUILT, {"recovery": 1, "until_s": 60.0, "runs": 5})
    ),
}


def path_of(setting: Setting) -> Path:
    """Return where the result of a setting is kept."""
    of_setting = (asdict(setting), ds.PROTOCOLS[setting.protocol], setting.wifi, setting.window)
    own = (setting.fleet, setting.table) if isinstance(setting, Ready) else ()
    text = repr((of_setting, SEED, sources(), *own))
    table = re.sub(r" at 0x[0-9a-f]+", "", text)  # functions
    return CACHE / f"{sha256(table.encode()).hexdigest()[:24]}.json"


def result(setting: Setting) -> dict[str, object]:
    """Return the result of a setting, from the cache if it is there."""
    path = path_of(setting)
    if not path.exists():
        row = setting.run()
        CACHE.mkdir(parents=True, exist_ok=True)
        # In one step: what is interrupted leaves nothing half-written.
        path.with_suffix(".part").write_text(json.dumps(row), encoding="utf-8")
        path.with_suffix(".part").replace(path)
    loaded: dict[str, object] = json.loads(path.read_text(encoding="utf-8"))
    return loaded


def settings_of(name: str) -> list[Setting]:
    """Return the settings of a table, each once, in order."""
    return sorted(set(SWEEPS[name]()), key=lambda one: tuple(asdict(one).values()))


def write(name: str, rows: list[dict[str, object]]) -> None:
    """Write one table."""
    TABLES.mkdir(parents=True, exist_ok=True)
    path = TABLES / f"{name}.csv"
    columns: list[str] = []
    for row in rows:  # those of many runs have more columns
        for before, column in zip(["", *row], row, strict=False):
            if column not in columns:
                columns.insert(columns.index(before) + 1 if before else 0, column)
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, columns, lineterminator="\n", restval="")
        writer.writeheader()
        writer.writerows(rows)
    sys.stderr.write(f"{path.relative_to(ROOT)}: {len(rows)} rows\n")


def main() -> None:
    """Simulate what is missing and write the tables."""
    from tqdm import tqdm

    parser = argparse.ArgumentParser(prog="make simulate", description=__doc__)
    parser.add_argument(
        "--only", choices=[*SWEEPS, "air", "user_data"], help="one table; default: all"
    )
    only = parser.parse_args().only
    wanted = {name: settings_of(name) for name in SWEEPS if only in (None, name)}
    todo = {one for settings in wanted.values() for one in settings if not path_of(one).exists()}

    # The short ones first.
    def size(one: Setting) -> tuple[int, int, str]:
        return one.hosts * one.processes, one.hosts, repr(one)

    for setting in tqdm(sorted(todo, key=size), "settings"):
        result(setting)
    if "fits" in wanted:
        wanted["fits"] = decided(wanted["fits"])
    for name, settings in wanted.items():
        write(name, [asdict(one) | result(one) | SOURCE for one in settings])
    if only in (None, "drain"):
        write("events", [row | SOURCE for row in events()])
        write("saturation", [row | SOURCE for row in saturation()])
    if only in (None, "air"):
        write("air", records(air.start()))
    if only in (None, "user_data"):
        write("user_data", [row | SOURCE for row in user_data()])
    if only in (None, "queues"):
        write("hosts", [row | SOURCE for row in by_host()])
        write("heard", [row | SOURCE for row in heard()])
        write("waiting", [row | SOURCE for row in waiting()])
    if only in (None, "fits"):
        write("ladder", ladder([asdict(one) | result(one) for one in wanted["fits"]]))


def events() -> list[dict[str, object]]:
    """Return every transmission of one small burst: three robots, one process each."""
    assert trace.SEED == SEED
    return records(trace.table(trace.SMALL))


def records(table: pd.DataFrame) -> list[dict[str, object]]:
    """Return the rows of a table."""
    return [{str(name): value for name, value in row.items()} for row in table.to_dict("records")]


#: Of stations that always have something to send: how many, runs, and seconds of each.
STATIONS, TRIES, LASTING = (1, 2, 5, 10, 20, 30, 50), 20, 2.0


def saturation(stations: Iterable[int] = STATIONS) -> list[dict[str, object]]:
    """Return what arrives when so many stations always have something to send.

    By the rules of the standard, and by those of Bianchi's chain, which knows no timeout for
    acknowledgements and gives up no frame.
    """
    sedp = replace(ds.DDS.message("SEDP"), hops=("up",), answers=None)
    rows: list[dict[str, object]] = []
    for count, rules in product(stations, ("standard", "Bianchi")):
        starts = np.zeros(count + 1)
        starts[-1] = 1e4  # is there only to be sent to
        what = set_up(
            ds.Fleet.swarm(count + 1, 1, max(16_000 // count**2, 100)),
            ds.Protocol("saturation", (sedp,)),
            Setting("DDS", 2).wifi,
            (np.inf, np.inf),
            starts,
            0.0,
            recovery=False,
            until=1e5,
            eifs=False,
        )
        if rules == "Bianchi":
            what.radio["timeout"], what.radio["attempts"] = 0, 10**6
        arrived = []
        for seed in np.random.SeedSequence(SEED).spawn(TRIES):
            cell = finish(what.cell(seed)[0], ticks(LASTING), what.reserve)
            assert (cell.stations["length"][:count] > 0).all(), "some had nothing left to send"
            arrived.append(int(cell.now["arrived"][0]) / LASTING)
        row: dict[str, object] = {"stations": count, "rules": rules, "duration_s": LASTING}
        rows.append(row | {"runs": TRIES} | spread("frames_per_s", np.array(arrived)))
    return rows


def by_host() -> list[dict[str, object]]:
    """Return what each host loses: of eight robots, and with one that has more to tell."""
    robots = ds.HostGroup(7, 2, 10, name="robot")
    fleets = {
        "alike": ds.Fleet((replace(robots, hosts=8),)),
        "with a laptop": ds.Fleet((robots, ds.HostGroup(1, 2, 60, name="laptop"))),
    }
    rows: list[dict[str, object]] = []
    for name, fleet in fleets.items():
        found = ds.simulate(
            fleet, ds.DDS, Setting("DDS", 8).wifi, recovery=False, runs=40, seed=SEED
        )
        hosts = [group for group in fleet.groups for _ in range(int(group.hosts))]
        for number, group in enumerate(hosts):
            row = {"fleet": name, "host": number + 1, "kind": group.name}
            row |= {"processes": int(group.processes), "endpoints": int(group.endpoints)}
            rows.append(row | spread("lost", found.lost_by_host[:, number]))
    return rows


def waiting(hosts: Iterable[int] = (7, 12)) -> list[dict[str, object]]:
    """Return how many frames wait at all hosts and at the access point over time, in one burst."""
    rows: list[dict[str, object]] = []
    for count in hosts:
        fleet = ds.Fleet.swarm(count, 2, 10)
        found = ds.simulate(fleet, ds.DDS, Setting("DDS", count).wifi, recovery=False, seed=SEED)
        for time, at_hosts, at_access_point in found.queues[0]:
            row: dict[str, object] = {"protocol": "DDS", "hosts": count, "time_s": rounded(time)}
            rows.append(row | {"at_hosts": int(at_hosts), "at_access_point": int(at_access_point)})
    return rows


def user_data(runs: int = 20) -> list[dict[str, object]]:
    """Return when discovery is complete alone and beside data, and how late the data are then."""
    fleet = ds.Fleet.from_toml(data_path("fleets/small_data.toml"))
    rows: list[dict[str, object]] = []
    for name in ("Fast DDS", "Cyclone DDS", "Zenoh peer"):
        alone, beside = (
            ds.simulate(one, ds.PROTOCOLS[name], ds.PAPER, runs=runs, seed=SEED)
            for one in (fleet.without_data(), fleet)
        )
        for topic, own in beside.data.items():
            row: dict[str, object] = {"protocol": name, "topic": topic, "runs": runs}
            row |= spread("convergence_alone_s", alone.convergence_time)
            row |= spread("convergence_s", beside.convergence_time)
            row |= {"arrived": rounded(float((own["arrived"] / own["frames"]).mean()))}
            for column in ("delay_median_s", "delay_95_s", "delay_most_s"):
                row |= {column: rounded(float(np.median(own[column])))}
            rows.append(row)
    return rows


#: How stations are heard: alike, or at the distances of a disc by receivers of which a frame must
#: exceed what overlaps it by so much [dB]: the standard's, those of ns-3 (lab/ns3/README.md), and
#: ones that receive whatever is strongest.
HEARD = {"alike": None, "standard": THRESHOLD, "ns-3": (18.7, 1.0), "strongest": (0.0, 0.0)}


def heard(hosts: Iterable[int] = (3, 5, 7, 10)) -> list[dict[str, object]]:
    """Return bursts of hosts that are heard alike, and at the unlike distances of a disc."""
    queues = ((500, 0.5), (0, 0.0))
    settings = each(BESIDE, protocol=PAPER, mpdus=(1, 64), hosts=hosts)
    rows: list[dict[str, object]] = []
    for one, (frames, seconds), (where, threshold) in product(settings, queues, HEARD.items()):
        protocol = ds.PROTOCOLS[one.protocol]
        unlike: dict[str, Any] = {}
        if threshold:
            unlike = {"power": powers(disc(one.hosts)), "threshold": threshold}
        fleet = ds.Fleet.swarm(one.hosts, one.processes, one.endpoints)
        found = ds.simulate(
            fleet,
            protocol,
            one.wifi,
            queue=(frames or np.inf, seconds or np.inf),
            recovery=False,
            runs=one.runs,
            seed=SEED,
            agreements="in place",
            **unlike,
        )
        multicast = sum(
            float(message.load(fleet))
            for message in protocol.messages
            if message.cast == "multicast"
        )
        names = ("protocol", "hosts", "processes", "endpoints", "mpdus", "agreements", "runs")
        row = {name: getattr(one, name) for name in names}
        row |= {"queue_frames": frames, "queue_s": seconds, "heard": where}
        row |= spread("drain_time_s", found.drain_time) | spread("lost", found.lost)
        on_air = found.counts["on_air"].mean() / (multicast * (one.hosts - 1))
        rows.append(row | {"multicast_lost": rounded(float(on_air))})
    return rows


#: Steps of the ladder: what is assumed, in words and as options of the settings.
CONTEND = "hosts contend and collide; queues without limit, nothing is repaired"
QUEUES = "queues of 500 frames and 0.5 s; the middleware repairs what is lost"
LADDER: list[tuple[str, str, dict[str, object]]] = [
    ("contention", CONTEND, {"recovery": 0, "start": "together"}),
    ("queues", QUEUES, {"recovery": 1, "start": "together"}),
    ("staggered", f"{QUEUES}; random starts, see window", {"recovery": 1, "start": "rule"}),
    ("in turn", f"{QUEUES}; starts in turn, see in_turn", {"recovery": 1, "start": "in turn"}),
]
#: Within how long [s] what has to be over.
CRITERIA = {0: [("drain_time_s", 1.0)], 1: [("convergence_time_s", s) for s in (10.0, 20.0)]}


@dataclass(frozen=True)
class Step:
    """How many hosts fit under some assumptions, and of how many runs that is known."""

    protocol: str
    step: str
    assumed: str
    #: What is compared with the limit [s].
    column: str
    limit: float
    #: Settings with their results, by hosts.
    rows: list[dict[str, Any]]

    @property
    def fits(self) -> int:
        """Place of the first row whose median is beyond the limit."""
        good = [float(row[self.column]) <= self.limit for row in self.rows]
        assert False in good, "the sweep must go on until they do not fit"
        return good.index(False)

    def end(self, place: int, which: str) -> float:
        """Return the low or high end of the median's interval; not a number if there is none."""
        return float(self.rows[place].get(f"{self.column}_{which}") or "nan")

    def open(self) -> list[dict[str, Any]]:
        """Return the rows that need more runs before the number of hosts is decided."""
        found = []
        fewest, most = self.range()
        for place in range(most + 2):
            low, high = self.end(place, "low"), self.end(place, "high")
            near = math.isnan(low) and place >= fewest
            if math.isnan(low):  # too few runs: the middle half of them instead
                low, high = (float(self.rows[place][f"{self.column}_{q}"]) for q in ("q25", "q75"))
            if near or low <= self.limit < high:
                found.append(self.rows[place])
        return [row for row in found if int(row["runs"]) < MOST]

    def range(self) -> tuple[int, int]:
        """Return the places of the fewest and of the most hosts that may be what fits."""
        low, high = self.fits - 1, self.fits
        while self.end(low, "high") > self.limit:
            low -= 1
        while self.end(high, "low") <= self.limit:
            high += 1
        return low, high - 1


def steps(rows: list[dict[str, Any]]) -> Iterator[Step]:
    """Yield the steps of the ladder."""
    for protocol, (step, assumed, options), mpdus in product(PAPER, LADDER, (1, 64)):
        wanted = options | {"protocol": protocol, "mpdus": mpdus}
        of_step = [row for row in rows if all(row[k] == v for k, v in wanted.items())]
        of_step.sort(key=lambda row: int(row["hosts"]))
        words = assumed + (", frames aggregated" if mpdus > 1 else "")
        for column, limit in CRITERIA[int(str(options["recovery"]))]:
            yield Step(protocol, step, words, column, limit, of_step)


def decided(settings: list[Setting]) -> list[Setting]:
    """Return settings with as many runs as it takes to decide how many hosts fit; see `MOST`."""
    while True:
        rows = [asdict(one) | result(one) | {"setting": one} for one in settings]
        more = {row["setting"] for step in steps(rows) for row in step.open()}
        if not more:
            return settings
        again = {one: replace(one, runs=max(MANY, 4 * one.runs)) for one in more}
        for one in sorted(again.values(), key=lambda one: (one.runs, one.hosts)):
            sys.stderr.write(f"{one}\n")
            result(one)
        settings = [again.get(one, one) for one in settings]


def ladder(rows: list[dict[str, Any]]) -> list[dict[str, object]]:
    """Return how many hosts fit, step by step of the assumptions.

    That is the largest number with which the median run meets the criterion, as do all below.
    """
    found: list[dict[str, object]] = []
    for step in steps(rows):
        fits, (low, high) = step.fits, step.range()
        last, beyond = step.rows[fits - 1], step.rows[fits]
        found.append(
            {
                "protocol": step.protocol,
                "step": step.step,
                "mpdus": last["mpdus"],
                "criterion": step.column,
                "limit_s": f"{step.limit:g}",
                "processes": last["processes"],
                "endpoints": last["endpoints"],
                "hosts": last["hosts"],
                "hosts_low": step.rows[low]["hosts"],
                "hosts_high": step.rows[high]["hosts"],
                "runs": last["runs"],
                "value_s": last[step.column],
                "value_low_s": last[f"{step.column}_low"],
                "value_high_s": last[f"{step.column}_high"],
                "one_more_runs": beyond["runs"],
                "one_more_s": beyond[step.column],
                "one_more_low_s": beyond[f"{step.column}_low"],
                "one_more_high_s": beyond[f"{step.column}_high"],
                "assumed": step.assumed,
                "source": "data/simulated/fits.csv",
            }
        )
    return found


if __name__ == "__main__":
    main()
