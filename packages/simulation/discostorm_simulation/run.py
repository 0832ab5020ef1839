"""Scenarios, their shared set-up, and single runs."""

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor, wait
from dataclasses import dataclass
from threading import Event
from typing import TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from discostorm import _checks
from discostorm.fleet import Fleet
from discostorm.lookup import as_wifi
from discostorm.messages import Hosts, Protocol, legs
from discostorm.wifi import Wifi
from discostorm.wifi.channel import TICK
from discostorm_simulation import cell_setup, middleware, state as st, user_data
from discostorm_simulation.cell_setup import BurstSchedule, MessageCounts, to_ticks
from discostorm_simulation.engine import run_to_end
from discostorm_simulation.initial_state import EQUAL_POWERS, build_cell
from discostorm_simulation.propagation import MAX_DECIBELS, THRESHOLD
from discostorm_simulation.result import CAUSES, COUNTS, Run
from discostorm_simulation.starts import Start, start_times
from discostorm_simulation.state import Records

Result = TypeVar("Result")

#: Estimates: computing time of a transmission [s], and transmissions per frame and hop [1].
_PER_TRANSMISSION, _ATTEMPTS = 1e-7, 2.0


@dataclass(frozen=True)
class Scenario:
    """A scenario: the arguments of `discostorm.simulate` except runs and seed."""

    fleet: Fleet
    protocol: Protocol
    wifi: Wifi
    queue: tuple[float, float] = (500, 0.5)
    start: Start = 0.0
    loss: ArrayLike = 0.0
    recovery: bool = True
    until: float = 120.0
    give_up: float = np.inf
    eifs: bool = False
    block_ack: str = "negotiate"
    power: ArrayLike | None = None
    threshold: tuple[float, float] = THRESHOLD


@dataclass(frozen=True)
class Setup:
    """Arrays that all runs of a scenario share; runs differ only in their seed."""

    scenario: Scenario
    hosts: Hosts
    kinds: Records
    shares: MessageCounts
    bursts: BurstSchedule
    #: Radio of the channel; with several cells: the first cell's radio, then every cell's.
    radio: Records
    #: The cell of each host; `kinds` once per cell, with its octets and times.
    cell_of: st.Ints
    kinds_of_cells: Records
    repairs: Records | None
    loss: NDArray[np.float64]
    #: Received power at [sender, receiver], in any unit; `EQUAL_POWERS` if all powers are equal.
    power: NDArray[np.float64]
    user_data: user_data.UserData | None
    #: Topic of each row of `CellState.delays`, and whether its frames end a sample.
    topics: tuple[tuple[str, bool], ...]

    cell = build_cell

    @property
    def server(self) -> int:
        """The index of the wired server, which is the last process; 0 if there is none."""
        return 0 if self.repairs is None else int(self.repairs["server"][0])

    @property
    def patience(self) -> float:
        """How long a run may go without discovery progress before it ends [s]."""
        if self.repairs is None or not np.isfinite(self.scenario.give_up):
            return np.inf
        names = ["announce_interval_max", "heartbeat_period_max"]
        names += ["rto_max"] * bool((self.kinds["tcp"] * (self.kinds["role"] == st.DATA)).any())
        longest = max(float(self.repairs[name][0]) * TICK for name in names)
        return float(self.scenario.give_up * max([longest, *self.bursts.periods]))

    @property
    def until(self) -> float:
        """Maximum simulated time after the last start [s]; infinity: a run ends with its burst."""
        lasts = self.scenario.recovery or self.user_data is not None
        return self.scenario.until if lasts else np.inf

    @property
    def reserve(self) -> int:
        """Maximum number of frames and events that one step adds."""
        count = len(self.shares.each)
        each = np.ceil(np.maximum(self.shares.each, self.shares.to_all).max(axis=0)).astype(int)
        most = int(self.hosts.processes.max()) * count
        # A dropped frame may release all frames that waited behind it, at every host at once.
        least = 1024 + self.hosts.processes.size * int(self.radio["window"].max())
        least *= self.radio.size  # a frame may go on to each cell
        if self.repairs is None:
            one_hop = ~((self.kinds["up"] > 0) & (self.kinds["down"] > 0))
            own = (self.kinds["user"] > 0) | (self.kinds["trigger"] == st.ANSWER)
            return least + int((each * (one_hop | own)).sum()) * most
        return least + 2 * most * (int(each.sum()) + 4 + int(self.kinds["gap_number"].sum()))

    def estimate(self) -> tuple[float, float]:
        """Estimate the computing time [s] and the memory [MB] of a run."""
        count = self.hosts.host_of.size
        to_all = self.kinds["to_all"] > 0
        remote = count - self.hosts.processes.mean()
        one_by_one = remote * self.shares.each.sum(axis=0)
        of_row = np.where(to_all, self.shares.to_all.sum(axis=0), one_by_one)
        frames = float(of_row.sum())
        # Periodic traffic, between the first start and the end of the run.
        hosts = self.hosts.processes.size
        starts = start_times(self.scenario.start, hosts, np.random.default_rng(0))
        span = float(np.ptp(starts)) + (self.until if np.isfinite(self.until) else 0.0)
        again = span * sum(
            float(of_row[list(rows)].sum()) / period
            for rows, period in zip(self.bursts.rows_by_burst, self.bursts.periods, strict=True)
            if period
        )
        looks = pairs = 0.0
        held = min(frames, self.scenario.queue[0] * (1 + hosts))
        carried = min(frames, 4 * held)
        if self.repairs is not None:
            carried = frames
            if period := float(self.repairs["announce_interval_max"][0]) * TICK:
                again += span * float(of_row[to_all if to_all.any() else 0].sum()) / period
            # Lease checks: once per lease for each ordered pair of processes.
            looks = count**2 * span / (float(self.repairs["lease"][0]) * TICK)
            items = self.shares.each[:, self.kinds["role"] == st.DATA].sum(axis=1).max()
            numbers = 4 * items if self.repairs["nack_response_delay"][0] else 0
            pairs = count**2 * (st.PAIR.itemsize + items // 8 + numbers)
        seconds = (2 * (carried + again) * _ATTEMPTS + looks) * _PER_TRANSMISSION
        each = st.ENTRY.itemsize + st.EVENT.itemsize
        return seconds, (pairs + held * st.ENTRY.itemsize + self.reserve * each) / 1e6


def set_up(scenario: Scenario) -> Setup:
    """Check a scenario, and prepare the arrays that its runs share."""
    discovery = scenario.protocol
    hosts = cell_setup.host_table(scenario.fleet)
    count = hosts.processes.size
    errors = np.asarray(_checks.numbers("loss", scenario.loss, 0, 1, exclusive_max=True))
    if errors.ndim and errors.shape != (count,):
        rule = f"loss must be one number, or one for each of the {count} hosts"
        raise ValueError(f"{rule}; got {errors.shape}")
    channels = [as_wifi(cell.wifi) for cell in scenario.fleet.cells] or [scenario.wifi]
    if scenario.power is not None and (scenario.fleet.cells or scenario.fleet.has_wired):
        raise ValueError("power must be left out with cells or wired hosts: it covers one cell")
    how = scenario.queue, scenario.eifs, scenario.threshold
    radios = [cell_setup.radio_record(wifi, *how) for wifi in channels]
    radios += [cell_setup.wire_record()] * scenario.fleet.has_wired
    radio = np.concatenate([*radios[:1], *radios] if len(radios) > 1 else radios)
    protocol = user_data.add_user_data_rows(discovery, scenario.fleet)
    ports = legs.rows_to_every_port(protocol) if scenario.recovery else ()
    kinds, *others = [cell_setup.kind_records(protocol, wifi, hosts, ports) for wifi in channels]
    shares = cell_setup.message_counts(protocol, hosts, ports)
    repairs, table = None, discovery
    if scenario.recovery:
        if legs.has_server(protocol):
            shares = middleware.add_server_counts(protocol, shares, hosts)
        repairs = middleware.add_recovery(protocol, kinds, shares)
        repairs["server"] = shares.each.shape[0] - 1 if legs.has_server(protocol) else 0
        table = middleware.scheduled_messages(discovery)
    names = [message.name for message in protocol.messages]
    clock = cell_setup.bursts_of(table, [names.index(message.name) for message in table.messages])
    lasting = scenario.queue[1], scenario.until
    bursts, data = user_data.add_user_data_bursts(protocol, clock, kinds, *lasting)
    start_times(scenario.start, count, np.random.default_rng(0))  # refuses a bad start early
    cell_of = cell_setup.cells_of_hosts(scenario.fleet)
    return Setup(
        scenario=scenario,
        hosts=hosts,
        kinds=kinds,
        shares=shares,
        bursts=bursts,
        radio=radio,
        cell_of=cell_of,
        kinds_of_cells=cell_setup.repeat_kind_records(kinds, others, scenario.fleet.has_wired),
        repairs=repairs,
        loss=np.where(cell_of < len(channels), errors, 0.0),
        power=_power_factors(scenario.power, count),
        user_data=data,
        topics=user_data.topics_of_rows(protocol),
    )


def _power_factors(decibels: ArrayLike | None, hosts: int) -> NDArray[np.float64]:
    """Convert received powers from decibels to factors."""
    if decibels is None:
        return EQUAL_POWERS
    power = np.asarray(_checks.numbers("power", decibels, -MAX_DECIBELS, MAX_DECIBELS))
    if power.shape != (hosts + 1, hosts + 1):
        rule = f"{(hosts + 1, hosts + 1)}, for the {hosts} hosts and the access point"
        raise ValueError(f"power must be of shape {rule}; got {power.shape}")
    return cell_setup.from_decibels(power)


def _completed_at(setup: Setup, cell: st.CellState, missing: st.Ints) -> st.Ints:
    """Return when each pair completed discovery; of pairs without data, when the server did."""
    host, mute = setup.hosts.host_of, cell.processes["mute"].any()
    learning = setup.hosts.first[host] if mute else np.arange(host.size)
    done = cell.pairs["completed_at"][learning, : host.size]
    if setup.server:
        nothing = missing[learning, : host.size] == 0
        done = np.where(nothing, cell.pairs["completed_at"][setup.server, : host.size], done)
    at_home = np.eye(host.size, dtype=bool) if setup.server and not mute else host[:, None] == host
    return np.asarray(done[~at_home])


def simulate_run(setup: Setup, seed: np.random.SeedSequence, stop: Event | None = None) -> Run:
    """Simulate one run and return its result; raise `Stopped` soon after ``stop`` is set."""
    cell, starts = setup.cell(seed)
    until = min(to_ticks(float(starts.max()) + setup.until), int(st.NEVER) - 1)
    missing = cell.pairs["missing"].copy()
    return result_of(setup, starts, missing, run_to_end(cell, until, setup.reserve, stop))


def result_of(setup: Setup, starts: st.Floats, missing: st.Ints, cell: st.CellState) -> Run:
    """Return the result of a finished cell; ``missing`` has what each pair lacked at its start."""
    state = cell.state[0]
    counts = {name: 0 if name == "waiting" else int(state[name]) for name in COUNTS}
    lost = sum(counts[cause] for cause in CAUSES)
    counts["waiting"] = counts["expected"] - counts["arrived"] - lost
    through = state["open"] == 0 and state["coming"] == 0
    drained = float(state["drained"] * TICK) if through else np.inf
    if setup.repairs is None:
        converged = drained if counts["arrived"] == counts["expected"] else np.inf
        pair_times = np.empty(0)
    else:
        converged = float(state["converged"] * TICK) if state["converged"] else np.inf
        done = _completed_at(setup, cell, missing)
        pair_times = np.sort(np.where(done > 0, done * TICK, np.inf))
    hosts = cell.stations[: state["hosts"]]
    samples = cell.queue_samples[: state["samples"]]
    own = setup.user_data
    data = {} if own is None else user_data.user_data_results(setup.topics, cell, own.stamp)
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


def run_in_threads(calls: Sequence[Callable[[Event], Result]], workers: int) -> Iterator[Result]:
    """Yield the results of calls in their order; an interrupt sets the event that they all get."""
    stop = Event()
    with ThreadPoolExecutor(workers) as threads:
        futures = [threads.submit(call, stop) for call in calls]
        try:
            for future in futures:
                # A bounded wait, because Windows cannot interrupt an unlimited one.
                while not future.done():
                    wait([future], 0.2)
                yield future.result()
        except BaseException:
            stop.set()
            threads.shutdown(cancel_futures=True)
            raise
