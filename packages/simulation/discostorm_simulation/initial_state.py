"""Build the arrays of a run at its start."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from discostorm_simulation import state as st
from discostorm_simulation.cell_setup import to_ticks
from discostorm_simulation.starts import start_times
from discostorm_simulation.state import CellState, Records

if TYPE_CHECKING:
    from discostorm_simulation.run import Setup

#: Value of `CellState.power` if all stations receive each other equally well.
EQUAL_POWERS = np.zeros((1, 1))
#: Number of records: queue samples, logged transmissions, and initial pool of waiting frames.
QUEUE_SAMPLES, LOG_ROWS, POOL_ENTRIES = 512, 4096, 4096


def build_cell(setup: Setup, seed: np.random.SeedSequence) -> tuple[CellState, NDArray[np.float64]]:
    """Build the cell of a run; return the cell and the start time of each host [s]."""
    for_start, for_run, for_parts, for_phases = seed.spawn(4)
    hosts, radio, kinds, repairs = setup.hosts, setup.radio, setup.kinds, setup.repairs
    count, rows = hosts.processes.size, kinds.size
    cells = max(radio.size - 1, 1)
    mpdus, every = int(radio["mpdus"].max()), count + cells
    starts = start_times(setup.scenario.start, count, np.random.default_rng(for_start))
    stations = np.zeros(every, st.STATION)
    for name in ("head", "tail", "to_head", "to_tail"):
        stations[name] = -1
    stations["processes"][:count] = hosts.processes
    stations["first"][:count] = hosts.first
    stations["loss"][:count] = setup.loss
    host_of = np.append(hosts.host_of, [count] * (setup.server > 0)).astype(np.int64)
    processes = np.zeros(host_of.size, st.PROCESS)
    processes["host"], begin = host_of, np.append(starts, 0.0)
    processes["start"] = [to_ticks(begin[host]) for host in host_of]
    speaking = np.isin(np.arange(host_of.size), [*hosts.first, setup.server])
    processes["mute"] = kinds["to_host"].any() & ~speaking
    part = _initial_fractions(setup, for_parts)
    pairs, received = _initial_pairs(setup, part)
    bursts = np.zeros((max(1, len(setup.bursts.rows_by_burst)), rows + 1), np.int64)
    for number, messages in enumerate(setup.bursts.rows_by_burst):
        bursts[number, list(messages)] = 1
        bursts[number, rows] = to_ticks(setup.bursts.periods[number])
    due = _first_events(setup, starts, processes, for_phases)
    events = np.zeros(2 * len(due) + 1024, st.EVENT)
    events[: len(due)] = due
    pool = np.zeros(POOL_ENTRIES, st.ENTRY)
    pool["next"] = np.arange(1, POOL_ENTRIES + 1)

    wheel = 1 << int(2 * radio["cw_max"].max() + 1).bit_length()
    channels = _initial_channels(setup, cells)
    state = np.zeros(1, st.STATE)
    for name in set(st.CHANNEL.fields or ()) & set(st.STATE.fields or ()) - {"hosts"}:
        state[name] = channels[name][0]
    state["cells"], state["step"], state["spare"] = cells, to_ticks(1e-3), POOL_ENTRIES
    state["hosts"], state["links"], state["kinds"] = count, count - 1, rows
    state["unlike"] = setup.power.size > 1
    state["stamp"] = setup.user_data.stamp if setup.user_data else 0
    # The xorshift generator must not start at zero.
    state["random"] = (for_run.generate_state(1, np.uint64) | np.uint64(1)).view(np.int64)
    once = sum(setup.bursts.periods[burst] == 0 for _, burst in setup.bursts.sends)
    state["events"], state["coming"] = len(due), count * once
    if repairs is not None:
        state["repairs"], state["pairs"] = 1, pairs_to_complete(setup, processes, pairs).sum()
        if np.isfinite(setup.patience):
            state["progress"], state["patience"] = to_ticks(starts.max()), to_ticks(setup.patience)

    topics = int(kinds["user"].max())
    pulled = repairs is not None and repairs["nack_response_delay"] > 0
    items = (*pairs.shape, int(pairs["missing"].max()))
    cell = CellState(
        radio=radio,
        state=state,
        channels=channels,
        cell_of=np.append(setup.cell_of, np.arange(cells)),
        stations=stations,
        window=np.zeros((every, mpdus), st.WINDOW),
        ordered=np.full((count, int(radio["window"].max())), -1, np.int64),
        wheel=np.full((cells, wheel), -1, np.int32),
        behind=np.full(every, -1, np.int32),
        deferred=np.zeros((cells, every), st.DEFERRED),
        senders=np.zeros(max(every, mpdus), st.SENDER),
        pool=pool,
        block_acks=np.zeros((count, 2), st.BLOCK_ACK),
        addba=np.zeros(every, st.ADDBA),
        events=events,
        kinds=setup.kinds_of_cells,
        bursts=bursts,
        processes=processes,
        each=setup.shares.each,
        to_all=setup.shares.to_all,
        part=part,
        receivers_before=setup.shares.receivers_before,
        power=setup.power,
        repairs=np.zeros(1, st.REPAIRS) if repairs is None else repairs,
        pairs=pairs,
        received_bitmap=received,
        came_after=np.zeros(items if pulled else (1, 1, 1), np.int32),
        delays=np.zeros((topics, st.COUNTED) if topics else (1, 1), np.int64),
        airtime=np.zeros((rows + 1, 3), np.int64),
        queue_samples=np.zeros(QUEUE_SAMPLES, st.QUEUE_SAMPLE),
        log=np.zeros(LOG_ROWS, st.TRANSMISSION),
    )
    return cell, starts


def _initial_channels(setup: Setup, cells: int) -> Records:
    """Return the channel of each cell at the start of a run."""
    radio = setup.radio[-cells:]
    channels = np.zeros(cells, st.CHANNEL)
    channels["base"], channels["idle"] = radio["slot"], -1
    channels["deferred_time"], channels["next"] = st.NEVER, st.NEVER
    channels["per_receiver"] = radio["mpdus"] > 1
    channels["cold"] = channels["per_receiver"] * (setup.scenario.block_ack == "negotiate")
    channels["hosts"] = np.bincount(setup.cell_of, minlength=cells)
    return channels


def _initial_fractions(setup: Setup, seed: np.random.SeedSequence) -> NDArray[np.float64]:
    """Draw the fraction of a message that each process starts with, at [process, row]."""
    # Multiples of 2^-20 keep sums with whole numbers exact.
    part = np.random.default_rng(seed).integers(2**20, size=setup.shares.each.shape) / 2**20
    for burst in setup.user_data.bursts if setup.user_data else ():
        rows = [row for row in setup.bursts.rows_by_burst[burst] if setup.kinds["user"][row]]
        # All rows of a sample share one fraction, so that a short sample goes to one host.
        part[:, rows] = part[:, rows[:1]]
    return part


def _initial_pairs(setup: Setup, part: NDArray[np.float64]) -> tuple[Records, NDArray[np.int64]]:
    """Return the initial records of pairs of processes, with no announcement received."""
    if setup.repairs is None:
        return np.zeros((1, 1), st.PAIR), np.zeros((1, 1, 1), np.int64)
    shares, host, first = setup.shares, setup.hosts.host_of, setup.hosts.first
    if setup.server:
        host, first = np.append(host, first.size), np.append(first, setup.server)
    pairs = np.zeros((host.size, host.size), st.PAIR)
    remote = host[:, None] != host
    for row in np.flatnonzero(setup.kinds["role"] == st.DATA):
        leg, before = setup.kinds["leg"][row], shares.receivers_before[shares.sets[row]]
        taking = np.diff(before) * remote
        wanted, begin = shares.each[:, row, None], part[:, row, None]
        if leg == st.FROM_SERVER:
            wanted = shares.each[:, row] * (np.arange(host.size) == setup.server)[:, None]
        elif leg == st.PASSED_ON and not setup.kinds["to_host"][row]:
            taking = np.diff(before) * ~np.eye(host.size, dtype=bool)
        own = np.diff(np.append(before[first], before[-1]))[host]
        rank = before[:-1] - own[:, None] * (host >= host[:, None])  # at [writer, reader]
        sent = np.floor((rank + 1) * wanted + begin) - np.floor(rank * wanted + begin)
        pairs["missing"] += (sent * taking).astype(np.int64).T
    words = 1 + int(pairs["missing"].max()) // 64
    return pairs, np.zeros((host.size, host.size, words), np.int64)


def pairs_to_complete(setup: Setup, processes: Records, pairs: Records) -> NDArray[np.bool_]:
    """Return at [reader, writer] which pairs must be complete for discovery to be over."""
    host, server = processes["host"], np.arange(processes.size) == setup.server
    wanted = host[:, None] != host
    if setup.server:
        wanted = ((pairs["missing"] > 0) | server[:, None]) & ~server
    return np.asarray(wanted & (processes["mute"] == 0)[:, None])


def _first_events(
    setup: Setup, starts: NDArray[np.float64], processes: Records, seed: np.random.SeedSequence
) -> list[tuple[int, int]]:
    """Return a heap of the first events: bursts, user data and, with recovery, timers."""
    due = [
        (to_ticks(start + time), int(st.SEND) | host | (burst << st.PROCESS_BITS))
        for host, start in enumerate(starts)
        for time, burst in setup.bursts.sends
    ]
    if setup.repairs is not None:
        (initial,), (lease,) = setup.repairs["announce_interval_initial"], setup.repairs["lease"]
        processes["announce"] = initial
        for process, start in enumerate(processes["start"].tolist()):
            if initial:  # announcements without a schedule in the table
                due.append((start + int(initial), int(st.ANNOUNCE) | process))
            if lease < st.NEVER:
                due.append((start + int(lease), int(st.LEASE_CHECK) | process))
    if setup.user_data is not None:
        due += setup.user_data.first_events(setup.hosts, starts, np.random.default_rng(seed))
    return sorted(due)  # a sorted list is a heap
