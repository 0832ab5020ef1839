"""Runs: what is to be simulated, made once; one run, from its start to its end."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from discostorm import _checks
from discostorm.fleet import Fleet
from discostorm.messages import Hosts, Protocol
from discostorm.wifi import Wifi
from discostorm.wifi.channel import TICK
from discostorm_simulation import state as _cell
from discostorm_simulation.cell_setup import (
    ALIKE,
    Bursts,
    Shares,
    bursts_of,
    from_decibels,
    grown,
    hosts_of,
    kind_records,
    new_cell,
    radio_record,
    shares_of,
    ticks,
)
from discostorm_simulation.engine import MEMORY, OVER, advance
from discostorm_simulation.frame_exchange import PARTS
from discostorm_simulation.middleware import (
    check_items,
    check_ports,
    check_table,
    clock_only,
    fill_kinds,
    repair_record,
    spread,
)
from discostorm_simulation.propagation import MOST_DECIBELS, THRESHOLD
from discostorm_simulation.result import CAUSES, COUNTS, Run
from discostorm_simulation.starts import Start, delays
from discostorm_simulation.state import Cell, Records
from discostorm_simulation.user_data import (
    UserData,
    found_of,
    topics_of,
    user_data_of,
    with_user_data,
)

#: Steps of a run between two looks at Python.
_SHARE = 5_000_000
#: Time that a transmission takes to simulate, and transmissions for each frame and hop: about.
_PER_TRANSMISSION, _ATTEMPTS = 1e-7, 2.0


@dataclass(frozen=True)
class Setup:
    """What is to be simulated; runs differ only in their seed."""

    hosts: Hosts
    kinds: Records
    shares: Shares
    bursts: Bursts
    radio: Records
    repairs: Records | None
    queue: tuple[float, float]
    start: Start
    loss: NDArray[np.float64]
    until: float
    spread: float
    cold: bool
    #: Received power at [sender, receiver], in any unit; `ALIKE` if all are heard alike.
    power: NDArray[np.float64]
    user_data: UserData | None = None
    #: Of each row of `Cell.delays` the topic, and whether its frames are the last of a sample.
    topics: tuple[tuple[str, bool], ...] = ()

    def cell(self, seed: np.random.SeedSequence) -> tuple[Cell, NDArray[np.float64]]:
        """Return a cell at the start of a run, and when each host starts [s]."""
        for_start, for_run, for_parts, for_phases = seed.spawn(4)
        count = self.hosts.processes.size
        starts = delays(self.start, count, np.random.default_rng(for_start))
        first: list[tuple[int, int]] = []
        if self.user_data is not None:
            first = self.user_data.first_events(
                self.hosts, starts, np.random.default_rng(for_phases)
            )
        cell = new_cell(
            self.hosts,
            self.kinds.copy(),
            self.shares,
            self.bursts,
            self.radio,
            starts,
            self.loss,
            for_run,
            for_parts,
            self.repairs,
            self.cold,
            self.power,
            first,
            self.user_data.stamp if self.user_data else 0,
        )
        for number in self.user_data.bursts if self.user_data else ():
            every = self.bursts.messages[number]
            first_row, *rows = [row for row in every if self.kinds["user"][row]]
            # So that all rows of a sample of few frames go to the same of several hosts.
            cell.part[:, rows] = cell.part[:, [first_row]]
        return cell, starts

    @property
    def reserve(self) -> int:
        """How many frames and events one step adds at most."""
        count, each = self.hosts.host_of.size, self.shares.most()
        most = int(self.hosts.processes.max()) * count
        # All hosts may give up a frame at once for which what came after it has waited.
        least = 1024 + self.hosts.processes.size * int(self.radio["window"][0])
        if self.repairs is None:
            one_hop = ~((self.kinds["up"] > 0) & (self.kinds["down"] > 0))
            own = (self.kinds["user"] > 0) | (self.kinds["trigger"] == _cell.ANSWER)
            return least + int((each * (one_hop | own)).sum()) * most
        return least + 2 * most * (int(each.sum()) + 4 + int(self.kinds["gap_number"].sum()))

    def estimate(self) -> tuple[float, float]:
        """Return about how long a run takes [s], and how much memory [MB]."""
        count = self.hosts.host_of.size
        alone = self.kinds["to_all"] > 0
        remote = count - self.hosts.processes.mean()
        of_row = np.where(alone, self.shares.to_all.sum(axis=0), 0.0)
        of_row += np.where(alone, 0.0, remote * self.shares.each.sum(axis=0))
        frames = float(of_row.sum())
        # What is sent again and again, while others start and until it is given up.
        lasts = self.repairs is not None or self.user_data is not None
        span = self.spread + (self.until if lasts else 0.0)
        again = span * sum(
            float(of_row[list(rows)].sum()) / period
            for rows, period in zip(self.bursts.messages, self.bursts.period, strict=True)
            if period
        )
        if self.repairs is not None and (
            period := float(self.repairs["announce_interval_max"][0]) * TICK
        ):
            again += span * float(of_row[alone if alone.any() else 0].sum()) / period
        looks = 0.0
        if self.repairs is not None:  # at leases, of each process for each other
            looks = count**2 * span / (float(self.repairs["lease"][0]) * TICK)
        held = min(frames, self.queue[0] * (1 + self.hosts.processes.size))
        carried = frames if self.repairs is not None else min(frames, 4 * held)
        seconds = (2 * (carried + again) * _ATTEMPTS + looks) * _PER_TRANSMISSION
        items = self.shares.each[:, self.kinds["role"] == _cell.DATA].sum(axis=1).max()
        pairs = 0 if self.repairs is None else count**2 * (96 + items // 8)
        each = _cell.ENTRY.itemsize + _cell.EVENT.itemsize
        return seconds, (pairs + held * _cell.ENTRY.itemsize + self.reserve * each) / 1e6


def set_up(
    fleet: Fleet,
    protocol: Protocol,
    wifi: Wifi,
    queue: tuple[float, float],
    start: Start,
    loss: ArrayLike,
    recovery: bool,
    until: float,
    eifs: bool,
    cold: bool = False,
    power: ArrayLike | None = None,
    threshold: tuple[float, float] = THRESHOLD,
) -> Setup:
    """Check what `discostorm.simulate` was given and return what a run needs."""
    hosts = hosts_of(fleet)
    count = hosts.processes.size
    errors = np.asarray(_checks.numbers("loss", loss, 0, 1, below=True))
    if errors.ndim and errors.shape != (count,):
        raise ValueError(
            f"loss must be one number, or one for each of the {count} hosts; got {errors.shape}"
        )
    heard = ALIKE
    if power is not None:
        heard = np.asarray(_checks.numbers("power", power, -MOST_DECIBELS, MOST_DECIBELS))
        if heard.shape != (count + 1, count + 1):
            raise ValueError(
                f"power must be of shape {(count + 1, count + 1)}, for the {count} hosts and the "
                f"access point; got {heard.shape}"
            )
        heard = from_decibels(heard)
    radio = radio_record(wifi, queue, eifs, threshold)
    discovery, protocol = protocol, with_user_data(protocol, fleet)
    ports = spread(protocol) if recovery else ()
    kinds, shares = kind_records(protocol, wifi, hosts, ports), shares_of(protocol, hosts, ports)
    repairs, table = None, discovery
    if recovery:
        check_table(protocol)
        check_ports(protocol, shares)
        fill_kinds(protocol, kinds)
        check_items(protocol, kinds, shares)
        repairs, table = repair_record(protocol), clock_only(discovery)
    names = [message.name for message in protocol.messages]
    rows = [names.index(message.name) for message in table.messages]
    bursts = bursts_of(table)
    bursts = Bursts(
        tuple(tuple(rows[row] for row in burst) for burst in bursts.messages),
        bursts.period,
        bursts.times,
    )
    bursts, user_data = user_data_of(protocol, bursts, kinds, float(queue[1]), until)
    # Refuses a bad one before all runs.
    starts = delays(start, count, np.random.default_rng(0))
    return Setup(
        hosts,
        kinds,
        shares,
        bursts,
        radio,
        repairs,
        queue,
        start,
        np.broadcast_to(errors, count),
        until if recovery or user_data is not None else np.inf,
        float(np.ptp(starts)),
        cold,
        heard,
        user_data,
        topics_of(protocol),
    )


def compiled() -> None:
    """Compile the inner loops, or load them from disk, unless that is done."""
    cell = new_cell(
        Hosts(np.ones(2, np.int64), np.zeros(2, np.int64)),
        np.zeros(1, _cell.KIND),
        Shares(
            np.zeros((2, 1)), np.zeros((2, 1)), np.zeros((1, 3), np.int64), np.zeros(1, np.int64)
        ),
        Bursts((), (), ()),
        np.zeros(1, _cell.RADIO),
        np.zeros(2),
        np.zeros(2),
        np.random.SeedSequence(0),
        np.random.SeedSequence(0),
    )
    advance(cell, 0, 0, 0)


def finish(cell: Cell, until: int, reserve: int = 1024) -> Cell:
    """Return the cell at the end of its run."""
    while True:
        state = advance(cell, until, reserve, _SHARE)
        if state == OVER:
            return cell
        if state == MEMORY:
            cell = grown(cell)


def one_run(setup: Setup, seed: np.random.SeedSequence) -> Run:
    """Return what one run finds."""
    cell, starts = setup.cell(seed)
    until = min(ticks(float(starts.max()) + setup.until), int(_cell.NEVER) - 1)
    cell = finish(cell, until, setup.reserve)
    now = cell.now[0]
    counts = {name: int(now[name]) for name in COUNTS if name != "waiting"}
    lost = sum(counts[cause] for cause in CAUSES)
    counts["waiting"] = counts["expected"] - counts["arrived"] - lost
    drained = float(now["drained"] * TICK) if now["open"] == 0 and now["coming"] == 0 else np.inf
    if setup.repairs is None:
        converged = drained if counts["arrived"] == counts["expected"] else np.inf
        pair_times = np.empty(0)
    else:
        converged = float(now["converged"] * TICK) if now["converged"] else np.inf
        remote = setup.hosts.host_of[:, None] != setup.hosts.host_of
        done = cell.pairs["done"][remote]
        pair_times = np.sort(np.where(done > 0, done * TICK, np.inf))
    hosts = cell.stations[: now["hosts"]]
    samples = cell.samples[: now["samples"]]
    return Run(
        starts,
        drained,
        lost / counts["expected"] if counts["expected"] else 0.0,
        hosts["missed"] / np.maximum(hosts["sought"], 1),
        converged,
        float(now["busy"] * TICK),
        counts,
        np.asarray(cell.airtime * (TICK / PARTS), dtype=np.float64),
        np.stack([samples["time"] * TICK, samples["hosts"], samples["access_point"]], axis=1),
        pair_times,
        cell.log[: now["logged"]],
        {} if setup.user_data is None else found_of(setup.topics, cell, setup.user_data.stamp),
    )
