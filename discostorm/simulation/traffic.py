"""From fleet, protocol and channel to the arrays that a run reads and changes."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from discostorm import _checks
from discostorm.fleet import COUNTS, Fleet, is_symbolic
from discostorm.messages import ENDPOINT_PAIR, PAIR, PROCESS, Message, Protocol
from discostorm.simulation import cell as _cell
from discostorm.simulation.cell import Cell, Records
from discostorm.wifi import Padding, Radio, Wifi
from discostorm.wifi.channel import TICK

#: Retransmissions end with this attempt: dot11ShortRetryLimit (IEEE Std 802.11-2020, C.3).
ATTEMPTS = 7
#: From the begin of an OFDM frame until the receiver knows it [s]: aRxPHYStartDelay (17.4.4).
RX_START_DELAY = 20e-6
#: How many frames a block acknowledgement looks back at least (10.25).
WINDOW = 64
#: A block acknowledgement request has 24 octets, which take as long as 32 at 24 Mbit/s.
_UNITS = (PROCESS, PAIR, ENDPOINT_PAIR)
_MOST_PROCESSES = 2**_cell.PROCESS_BITS
_MOST_ENDPOINTS = 2**_cell.ITEM_BITS
_MOST_MESSAGES = 2**_cell.KIND_BITS
#: Rows of the records of queue lengths, of transmissions, and of frames that wait at first.
_SAMPLES, _LOG, _POOL = 512, 4096, 4096


def ticks(seconds: float) -> int:
    """Return a time in whole ticks."""
    return int(_cell.NEVER) if np.isinf(seconds) else round(seconds / TICK)


@dataclass(frozen=True)
class Hosts:
    """The fleet host by host: processes on each, and endpoints of each of its processes."""

    processes: NDArray[np.int64]
    endpoints: NDArray[np.int64]

    @property
    def first(self) -> NDArray[np.int64]:
        """The number of the first process of each host."""
        return np.cumsum(self.processes) - self.processes

    @property
    def host_of(self) -> NDArray[np.int64]:
        """The host of each process."""
        return np.repeat(np.arange(self.processes.size), self.processes)


def hosts_of(fleet: Fleet) -> Hosts:
    """Return the hosts of a fleet; refuse one that is not made of whole numbers."""
    rows = []
    for index, group in enumerate(fleet.groups):
        for count, value in zip(COUNTS, group.counts(), strict=True):
            name = f"groups[{index}].{count}"
            if is_symbolic(value):
                raise TypeError(f"fleet: {name} must be a number to simulate; got {value}")
            most = {"endpoints": _MOST_ENDPOINTS}.get(count, _MOST_PROCESSES)
            _checks.whole(f"fleet: {name}", value, 0, most)
        rows.append([int(value) for value in group.counts()])
    numbers, processes, endpoints = np.array(rows, dtype=np.int64).T
    if numbers.sum() < 2:
        raise ValueError(f"fleet must have at least 2 hosts to simulate; got {numbers.sum()}")
    if (numbers * processes).sum() > _MOST_PROCESSES:
        raise ValueError(
            f"fleet must have at most {_MOST_PROCESSES} processes to simulate; "
            f"got {(numbers * processes).sum()}"
        )
    return Hosts(np.repeat(processes, numbers), np.repeat(endpoints, numbers))


def radio_record(wifi: Wifi, queue: tuple[float, float], eifs: bool) -> Records:
    """Return the radio of a channel as the inner loops take it."""
    radio = wifi.radio
    if radio is None:
        raise ValueError(
            "wifi must have a radio to simulate, as those of ds.Radio(...).wifi(), ds.WIFI and "
            f"ds.PAPER have; got {wifi.name!r}"
        )
    padding = wifi.unicast.padding or radio.padding
    extension = radio.signal_extension
    aggregation = wifi.aggregation
    basic = Radio(radio.standard, band=radio.band, mcs=0).ack
    seconds = {
        "slot": radio.slot,
        "sifs": radio.sifs,
        "aifs": radio.aifs,
        "timeout": radio.sifs + radio.slot + RX_START_DELAY,
        "heard": (radio.sifs + basic + extension) * eifs,
        "ack": radio.ack + extension,
        "block_ack": radio.block_ack + extension,
        # A request has 24 octets, which take as many symbols as a block acknowledgement of 32.
        "request": radio.block_ack + extension,
        "preamble": radio.preamble + extension,
        "symbol": padding.symbol,
        "grid": padding.grid,
        "lifetime": queue[1],
    }
    whole = {
        "cw_min": radio.cw_min,
        "cw_max": radio.cw_max,
        "attempts": ATTEMPTS,
        # Stations without QoS count down at the end of idle slots only.
        "edca": radio.standard not in ("802.11a", "802.11g"),
        "bits": padding.bits,
        "added": padding.added,
        "mpdus": aggregation.mpdus if aggregation else 1,
        "most_bytes": aggregation.most_bytes if aggregation else 0,
        "least_subframe": aggregation.least_bytes if aggregation else 0,
        "window": max(WINDOW, aggregation.mpdus) if aggregation else 1,
        "queue": _cell.NEVER if np.isinf(queue[0]) else int(queue[0]),
    }
    record = np.zeros(1, _cell.RADIO)
    for name, value in (whole | {name: ticks(value) for name, value in seconds.items()}).items():
        record[name] = value
    return record


def _ppdu_ticks(octets: int, padding: Padding, preamble: int) -> int:
    symbols = -(-(padding.added + 8 * octets) // padding.bits)
    grid = ticks(padding.grid)
    return preamble + -(-symbols * ticks(padding.symbol) // grid) * grid


def kind_records(protocol: Protocol, wifi: Wifi) -> Records:
    """Return the rows of a protocol's table; refuse what cannot be simulated."""
    radio = wifi.radio
    assert radio is not None
    if len(protocol.messages) > _MOST_MESSAGES:
        raise ValueError(f"protocol must have at most {_MOST_MESSAGES} messages to simulate")
    fast = wifi.unicast.padding or radio.padding
    slow = wifi.multicast.padding or radio.multicast_padding
    waiting = radio.aifs + radio.cw_min / 2 * radio.slot
    slow_preamble = ticks(radio.wifi().multicast.overhead - waiting)
    fast_preamble = ticks(radio.preamble + radio.signal_extension)
    records = np.zeros(len(protocol.messages), _cell.KIND)
    for record, message in zip(records, protocol.messages, strict=True):
        _refuse(protocol, message)
        # Under a block acknowledgement each frame has a QoS Control field.
        octets = round(message.frame_bytes) + 2 * (wifi.aggregation is not None)
        multicast = message.cast == "multicast"
        record["octets"] = octets
        record["multicast"] = multicast
        record["to_all"] = message.unit == PROCESS
        record["up"] = "up" in message.hops
        record["down"] = "down" in message.hops
        record["per"] = message.per_unit
        record["each_endpoint"] = message.unit == ENDPOINT_PAIR
        record["time_up"] = _ppdu_ticks(octets, fast, fast_preamble)
        record["time_down"] = (
            _ppdu_ticks(octets, slow, slow_preamble) if multicast else record["time_up"]
        )
    return records


def _refuse(protocol: Protocol, message: Message) -> None:
    where = f"protocol {protocol.name!r}, message {message.name!r}"
    if message.unit not in _UNITS:
        known = ", ".join(repr(unit.name) for unit in _UNITS)
        raise ValueError(f"{where}: unit must be one of {known}; got {message.unit.name!r}")
    if (message.cast == "multicast") != (message.unit == PROCESS) and len(message.hops) > 1:
        raise ValueError(
            f"{where}: cast must be 'multicast' for what is counted by process and 'unicast' for "
            f"what is counted by pairs of them; got {message.cast!r}"
        )
    if message.per_unit % 1:
        raise ValueError(f"{where}: per_unit must be a whole number; got {message.per_unit!r}")


@dataclass(frozen=True)
class Bursts:
    """What a host sends by the clock: sets of messages, and when each is sent after the start."""

    messages: tuple[tuple[int, ...], ...]
    period: tuple[float, ...]
    times: tuple[tuple[float, int], ...]


def bursts_of(protocol: Protocol) -> Bursts:
    """Return what a host sends by the clock alone: messages due at the same time go together."""
    at: dict[tuple[float, float], list[int]] = {}
    for row, message in enumerate(protocol.messages):
        schedule = message.schedule
        for time in schedule.starts:
            at.setdefault((time, 0.0), []).append(row)
        if np.isfinite(schedule.period):
            first = schedule.starts[-1] + schedule.period
            at.setdefault((first, schedule.period), []).append(row)
    sets: dict[tuple[tuple[int, ...], float], int] = {}
    times = []
    for (time, period), rows in sorted(at.items()):
        number = sets.setdefault((tuple(rows), period), len(sets))
        times.append((time, number))
    return Bursts(
        tuple(rows for rows, _ in sets), tuple(period for _, period in sets), tuple(times)
    )


def new_cell(
    hosts: Hosts,
    kinds: Records,
    bursts: Bursts,
    radio: Records,
    starts: NDArray[np.float64],
    loss: NDArray[np.float64],
    seed: np.random.SeedSequence,
    repairs: Records | None = None,
) -> Cell:
    """Return a cell at the start of a run."""
    count, rows = hosts.processes.size, kinds.size
    stations = np.zeros(count + 1, _cell.STATION)
    for name in ("head", "tail", "to_head", "to_tail", "behind"):
        stations[name] = -1
    stations["processes"][:count] = hosts.processes
    stations["endpoints"][:count] = hosts.endpoints
    stations["first"][:count] = hosts.first
    stations["loss"][:count] = loss
    processes = np.zeros(hosts.host_of.size, _cell.PROCESS)
    processes["host"] = hosts.host_of
    processes["endpoints"] = hosts.endpoints[hosts.host_of]

    processes["start"] = [ticks(starts[host]) for host in hosts.host_of]
    pairs, has = _pairs(hosts, repairs)

    now = np.zeros(1, _cell.NOW)
    now["base"] = radio["slot"]
    now["idle"] = -1
    now["stray_time"] = _cell.NEVER
    now["step"] = ticks(1e-3)
    now["spare"] = _POOL
    now["hosts"], now["links"], now["kinds"] = count, count - 1, rows
    now["per_receiver"] = radio["mpdus"] > 1
    # xorshift must not begin at zero.
    now["random"] = (seed.generate_state(1, np.uint64) | np.uint64(1)).view(np.int64)
    pool = np.zeros(_POOL, _cell.ENTRY)
    pool["next"] = np.arange(1, _POOL + 1)

    sets = np.zeros((max(1, len(bursts.messages)), rows + 1), np.int64)
    for number, messages in enumerate(bursts.messages):
        sets[number, list(messages)] = 1
        sets[number, rows] = ticks(bursts.period[number]) if bursts.period[number] else 0
    due = [
        (ticks(start + time), int(_cell.SEND) | host | (number << _cell.PROCESS_BITS))
        for host, start in enumerate(starts)
        for time, number in bursts.times
    ]
    if repairs is not None:
        due += _first_events(processes, repairs)
        now["repairs"] = 1
        now["pairs"] = hosts.host_of.size**2 - (hosts.processes**2).sum()
    due.sort()  # a sorted list is a heap
    now["events"] = len(due)
    now["coming"] = count * sum(bursts.period[number] == 0 for _, number in bursts.times)
    events = np.zeros(2 * len(due) + 1024, _cell.EVENT)
    events["time"][: len(due)] = [time for time, _ in due]
    events["what"][: len(due)] = [what for _, what in due]
    wheel = 1 << int(2 * radio["cw_max"][0] + 1).bit_length()
    mpdus = int(radio["mpdus"][0])
    return Cell(
        radio=radio,
        now=now,
        stations=stations,
        window=np.zeros((count + 1, mpdus), _cell.HELD),
        wheel=np.full(wheel, -1, np.int64),
        strays=np.zeros(count + 1, _cell.STRAY),
        senders=np.zeros(max(count + 1, mpdus), _cell.SENDER),
        pool=pool,
        events=events,
        kinds=kinds,
        batches=sets,
        processes=processes,
        repairs=np.zeros(1, _cell.REPAIRS) if repairs is None else repairs,
        pairs=pairs,
        has=has,
        airtime=np.zeros((rows + 1, 3), np.int64),
        samples=np.zeros(_SAMPLES, _cell.SAMPLE),
        log=np.zeros(_LOG, _cell.SENT),
    )


def _pairs(hosts: Hosts, repairs: Records | None) -> tuple[Records, NDArray[np.int64]]:
    """Return what each process holds of each other at the start: nothing."""
    if repairs is None:
        return np.zeros((1, 1), _cell.OF_PAIR), np.zeros((1, 1, 1), np.int64)
    count = hosts.host_of.size
    items = repairs["items"][0] * hosts.endpoints[hosts.host_of]
    pairs = np.zeros((count, count), _cell.OF_PAIR)
    pairs["missing"] = items
    return pairs, np.zeros((count, count, 1 + int(items.max()) // 64), np.int64)


def _first_events(processes: Records, repairs: Records) -> list[tuple[int, int]]:
    """Return the first announcements that no table names, and the first looks at leases."""
    due = []
    for process, start in enumerate(processes["start"]):
        if first := repairs["announce_first"][0]:
            processes["announce"][process] = first
            due.append((int(start + first), int(_cell.ANNOUNCE) | process))
        if (lease := repairs["lease"][0]) < _cell.NEVER:
            due.append((int(start + lease), int(_cell.EXPIRE) | process))
    return due


def grown(cell: Cell) -> Cell:
    """Return a cell with twice the memory for frames and events."""
    size = cell.pool.size
    pool = np.zeros(2 * size, _cell.ENTRY)
    pool[:size] = cell.pool
    pool["next"][size:] = np.arange(size + 1, 2 * size + 1)
    pool["next"][-1] = cell.now["free"][0]
    cell.now["free"] = size
    cell.now["spare"] += size
    events = np.zeros(2 * cell.events.size, _cell.EVENT)
    events[: cell.events.size] = cell.events
    return cell._replace(pool=pool, events=events)


def delays(start: Any, hosts: int, rng: np.random.Generator) -> NDArray[np.float64]:
    """Return when each host starts [s]; see `discostorm.simulate`."""
    if hasattr(start, "rvs"):
        drawn = start.rvs(size=hosts, random_state=rng)
    elif callable(start):
        drawn = start(rng, hosts)
    else:
        drawn = start
    found = _checks.numbers("start", drawn, 0)
    if np.ndim(found) and np.shape(found) != (hosts,):
        raise ValueError(
            f"start must give one time for each of the {hosts} hosts; got {np.shape(found)}"
        )
    return np.broadcast_to(np.asarray(found, dtype=np.float64), (hosts,))
