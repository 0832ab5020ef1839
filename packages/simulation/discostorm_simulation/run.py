"""Runs: what is to be simulated, made once; one run, from its start to its end."""

from dataclasses import dataclass
from threading import Event

import numpy as np
from numpy.typing import ArrayLike, NDArray

from discostorm import _checks
from discostorm.fleet import Fleet
from discostorm.messages import Hosts, Protocol
from discostorm.wifi import Wifi
from discostorm.wifi.channel import TICK
from discostorm_simulation import cell_setup, middleware, state as st, user_data
from discostorm_simulation.cell_setup import Bursts, Shares, ticks
from discostorm_simulation.engine import finish
from discostorm_simulation.initial_state import ALIKE, new_cell
from discostorm_simulation.propagation import MOST_DECIBELS, THRESHOLD
from discostorm_simulation.result import CAUSES, COUNTS, Run
from discostorm_simulation.starts import Start, delays
from discostorm_simulation.state import Records

#: Time that a transmission takes to simulate, and transmissions for each frame and hop: about.
_PER_TRANSMISSION, _ATTEMPTS = 1e-7, 2.0


@dataclass(frozen=True)
class Scenario:
    """What is simulated: the arguments of `discostorm.simulate` but for runs and seed."""

    fleet: Fleet
    protocol: Protocol
    wifi: Wifi
    queue: tuple[float, float] = (500, 0.5)
    start: Start = 0.0
    loss: ArrayLike = 0.0
    recovery: bool = True
    until: float = 120.0
    eifs: bool = False
    block_ack: str = "negotiate"
    power: ArrayLike | None = None
    threshold: tuple[float, float] = THRESHOLD


@dataclass(frozen=True)
class Setup:
    """What the runs of a scenario share; they differ only in their seed."""

    scenario: Scenario
    hosts: Hosts
    kinds: Records
    shares: Shares
    bursts: Bursts
    radio: Records
    repairs: Records | None
    loss: NDArray[np.float64]
    #: Received power at [sender, receiver], in any unit; `ALIKE` if all are heard alike.
    power: NDArray[np.float64]
    user_data: user_data.UserData | None
    #: Of each row of `CellState.delays` the topic, and whether its frames are the last of a sample.
    topics: tuple[tuple[str, bool], ...]

    cell = new_cell

    @property
    def until(self) -> float:
        """When a run ends at last, after the last start [s]: infinity if with its burst."""
        lasts = self.scenario.recovery or self.user_data is not None
        return self.scenario.until if lasts else np.inf

    @property
    def reserve(self) -> int:
        """How many frames and events one step adds at most."""
        count, each = self.hosts.host_of.size, self.shares.most()
        most = int(self.hosts.processes.max()) * count
        # All hosts may give up a frame at once for which what came after it has waited.
        least = 1024 + self.hosts.processes.size * int(self.radio["window"][0])
        if self.repairs is None:
            one_hop = ~((self.kinds["up"] > 0) & (self.kinds["down"] > 0))
            own = (self.kinds["user"] > 0) | (self.kinds["trigger"] == st.ANSWER)
            return least + int((each * (one_hop | own)).sum()) * most
        return least + 2 * most * (int(each.sum()) + 4 + int(self.kinds["gap_number"].sum()))

    def estimate(self) -> tuple[float, float]:
        """Return about how long a run takes [s], and how much memory [MB]."""
        count = self.hosts.host_of.size
        to_all = self.kinds["to_all"] > 0
        remote = count - self.hosts.processes.mean()
        one_by_one = remote * self.shares.each.sum(axis=0)
        of_row = np.where(to_all, self.shares.to_all.sum(axis=0), one_by_one)
        frames = float(of_row.sum())
        # What is sent again and again, while others start and until the end.
        starts = delays(self.scenario.start, self.hosts.processes.size, np.random.default_rng(0))
        span = float(np.ptp(starts)) + (self.until if np.isfinite(self.until) else 0.0)
        again = span * sum(
            float(of_row[list(rows)].sum()) / period
            for rows, period in zip(self.bursts.messages, self.bursts.period, strict=True)
            if period
        )
        looks = pairs = 0.0
        held = min(frames, self.scenario.queue[0] * (1 + self.hosts.processes.size))
        carried = min(frames, 4 * held)
        if self.repairs is not None:
            carried = frames
            if period := float(self.repairs["announce_interval_max"][0]) * TICK:
                again += span * float(of_row[to_all if to_all.any() else 0].sum()) / period
            # At leases, of each process for each other.
            looks = count**2 * span / (float(self.repairs["lease"][0]) * TICK)
            items = self.shares.each[:, self.kinds["role"] == st.DATA].sum(axis=1).max()
            pairs = count**2 * (st.PAIR.itemsize + items // 8)
        seconds = (2 * (carried + again) * _ATTEMPTS + looks) * _PER_TRANSMISSION
        each = st.ENTRY.itemsize + st.EVENT.itemsize
        return seconds, (pairs + held * st.ENTRY.itemsize + self.reserve * each) / 1e6


def set_up(scenario: Scenario) -> Setup:
    """Check a scenario and return what its runs share."""
    discovery, wifi = scenario.protocol, scenario.wifi
    hosts = cell_setup.hosts_of(scenario.fleet)
    count = hosts.processes.size
    errors = np.asarray(_checks.numbers("loss", scenario.loss, 0, 1, exclusive_max=True))
    if errors.ndim and errors.shape != (count,):
        raise ValueError(
            f"loss must be one number, or one for each of the {count} hosts; got {errors.shape}"
        )
    radio = cell_setup.radio_record(wifi, scenario.queue, scenario.eifs, scenario.threshold)
    protocol = user_data.with_user_data(discovery, scenario.fleet)
    ports = middleware.spread(protocol) if scenario.recovery else ()
    kinds = cell_setup.kind_records(protocol, wifi, hosts, ports)
    shares = cell_setup.shares_of(protocol, hosts, ports)
    repairs, table = None, discovery
    if scenario.recovery:
        repairs = middleware.add_recovery(protocol, kinds, shares)
        table = middleware.clock_only(discovery)
    names = [message.name for message in protocol.messages]
    clock = cell_setup.bursts_of(table, [names.index(message.name) for message in table.messages])
    lasting = scenario.queue[1], scenario.until
    bursts, data = user_data.user_data_of(protocol, clock, kinds, *lasting)
    delays(scenario.start, count, np.random.default_rng(0))  # refuses a bad one before all runs
    return Setup(
        scenario=scenario,
        hosts=hosts,
        kinds=kinds,
        shares=shares,
        bursts=bursts,
        radio=radio,
        repairs=repairs,
        loss=np.broadcast_to(errors, count),
        power=_power(scenario.power, count),
        user_data=data,
        topics=user_data.topics_of(protocol),
    )


def _power(decibels: ArrayLike | None, hosts: int) -> NDArray[np.float64]:
    """Return how strongly stations hear each other, as a factor."""
    if decibels is None:
        return ALIKE
    power = np.asarray(_checks.numbers("power", decibels, -MOST_DECIBELS, MOST_DECIBELS))
    if power.shape != (hosts + 1, hosts + 1):
        raise ValueError(
            f"power must be of shape {(hosts + 1, hosts + 1)}, for the {hosts} hosts and the "
            f"access point; got {power.shape}"
        )
    return cell_setup.from_decibels(power)


def one_run(setup: Setup, seed: np.random.SeedSequence, stop: Event | None = None) -> Run:
    """Return what one run finds; raise `Stopped` soon after the event is set."""
    cell, starts = setup.cell(seed)
    until = min(ticks(float(starts.max()) + setup.until), int(st.NEVER) - 1)
    cell = finish(cell, until, setup.reserve, stop)
    state = cell.state[0]
    counts = {name: int(state[name]) for name in COUNTS if name != "waiting"}
    lost = sum(counts[cause] for cause in CAUSES)
    counts["waiting"] = counts["expected"] - counts["arrived"] - lost
    through = state["open"] == 0 and state["coming"] == 0
    drained = float(state["drained"] * TICK) if through else np.inf
    if setup.repairs is None:
        converged = drained if counts["arrived"] == counts["expected"] else np.inf
        pair_times = np.empty(0)
    else:
        converged = float(state["converged"] * TICK) if state["converged"] else np.inf
        remote = setup.hosts.host_of[:, None] != setup.hosts.host_of
        done = cell.pairs["completed_at"][remote]
        pair_times = np.sort(np.where(done > 0, done * TICK, np.inf))
    hosts = cell.stations[: state["hosts"]]
    samples = cell.queue_samples[: state["samples"]]
    own = setup.user_data
    data = {} if own is None else user_data.found_of(setup.topics, cell, own.stamp)
    return Run(
        starts,
        drained,
        lost / counts["expected"] if counts["expected"] else 0.0,
        hosts["missed"] / np.maximum(hosts["sought"], 1),
        converged,
        float(state["busy"] * TICK),
        counts,
        np.asarray(cell.airtime * (TICK / st.PARTS), dtype=np.float64),
        np.stack([samples["time"] * TICK, samples["hosts"], samples["access_point"]], axis=1),
        pair_times,
        cell.log[: state["logged"]].copy(),
        data,
    )
