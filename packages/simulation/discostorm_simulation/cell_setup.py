"""Turn fleet, protocol and channel into the arrays that a run reads and changes.

`discostorm.messages.Unit` declares the senders and receivers of a message. If a process sends a
fraction x of a message to each receiver, receiver i gets floor((i + 1) x + u) - floor(i x + u)
messages. Each run draws u from 0 to 1 for each process and row, so the mean is x.
"""

from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace
from itertools import chain

import numpy as np
from numpy.typing import ArrayLike, NDArray

from discostorm import _checks
from discostorm.fleet import COUNTS, MIN_COUNTS, Fleet, Process, is_symbolic
from discostorm.messages import Hosts, Message, Protocol
from discostorm.wifi import OfdmSymbols, Radio, Wifi
from discostorm.wifi.channel import TICK
from discostorm_simulation import state as st
from discostorm_simulation.state import Records

#: Maximum number of transmissions of a frame: dot11ShortRetryLimit (IEEE Std 802.11-2020, C.3).
MAX_ATTEMPTS = 7
#: Time from the start of an OFDM frame to its detection [s]: aRxPHYStartDelay (17.4.4).
RX_START_DELAY = 20e-6
#: Minimum length of the block acknowledgement window [frames] (10.25).
BLOCK_ACK_WINDOW = 64
#: Extra airtime of an action frame (37 octets) over an ACK (14 octets) at 6 Mbit/s [s]: 8 symbols.
EXTRA_ADDBA_TIME = 8 * 4e-6
#: Maximum PSDU length of 802.11n (19.4.4), and maximum packet length of IPv4 (RFC 791) [B].
_MAX_OCTETS = 65_535
_MAX_PROCESSES, _MAX_ENDPOINTS = 2**st.PROCESS_BITS, 2**st.ITEM_BITS
_MAX_MESSAGES = 2**st.KIND_BITS


def to_ticks(seconds: float) -> int:
    """Convert seconds to whole ticks; a time beyond the range of ticks becomes NEVER."""
    never = int(st.NEVER)
    found = float(seconds) / TICK  # dividing a NumPy float may raise an error
    return never if found >= never else round(found)


def host_table(fleet: Fleet) -> Hosts:
    """Return the table of a fleet's hosts; refuse counts that are not integers."""
    rows = []
    for index, group in enumerate(fleet.groups):
        for count, value in zip(COUNTS, group.counts(), strict=True):
            name = f"groups[{index}].{count}" + f' of "{group.name}"' * bool(group.name)
            if is_symbolic(value):
                raise TypeError(f"fleet: {name} must be a number to simulate; got {value}")
            most = _MAX_ENDPOINTS if count == "endpoints" else _MAX_PROCESSES
            sizes = group.process_sizes if count == "endpoints" else ()
            for number in [size.endpoints for size in sizes] or [value]:
                _checks.integer(f"fleet: {name}", number, MIN_COUNTS[count], most)
        rows.append([int(group.hosts), int(group.processes)])
    numbers, processes = np.array(rows, dtype=np.int64).T
    if numbers.sum() < 2:
        raise ValueError(f"fleet must have at least 2 hosts to simulate; got {numbers.sum()}")
    if (total := (numbers * processes).sum()) > _MAX_PROCESSES:
        most = f"{_MAX_PROCESSES} processes"
        raise ValueError(f"fleet must have at most {most} to simulate; got {total}")
    endpoints: list[int] = []
    for group in fleet.groups:
        sizes = group.process_sizes or (Process(group.processes, group.endpoints),)
        own = chain(*([int(size.endpoints)] * int(size.count) for size in sizes))
        endpoints += [*own] * int(group.hosts)
    return Hosts(
        np.repeat(processes, numbers),
        np.array(endpoints, dtype=np.int64),
        np.repeat(np.arange(numbers.size), numbers),
        fleet.matching,
        np.repeat([float(group.shared) for group in fleet.groups], numbers),
        np.repeat([float(group.own_types) for group in fleet.groups], numbers),
    )


def radio_record(
    wifi: Wifi, queue: tuple[float, float], eifs: bool, threshold: tuple[float, float]
) -> Records:
    """Return a channel's radio and queue limits as a record for the engine."""
    radio = wifi.radio
    if radio is None:
        such = "as ds.Radio(...).wifi(), ds.WIFI and ds.PAPER do"
        raise ValueError(f"wifi must have a radio to be simulated, {such}; got {wifi.name!r}")
    padding = wifi.unicast.padding or radio.padding
    extension = radio.signal_extension
    aggregation = wifi.aggregation
    basic = Radio(radio.standard, band=radio.band, mcs=0).ack
    seconds = {name: getattr(radio, name) for name in ("slot", "sifs", "aifs")}
    seconds |= {name: getattr(radio, name) + extension for name in ("ack", "block_ack", "preamble")}
    seconds |= {
        "timeout": radio.sifs + radio.slot + RX_START_DELAY,
        "eifs_extra": (radio.sifs + basic + extension) * eifs,
        # A BlockAckReq has 24 octets: as many symbols as a block acknowledgement of 32 octets.
        "bar": radio.block_ack + extension,
        "addba": basic + EXTRA_ADDBA_TIME + extension,
        "basic_ack": basic + extension,
        "symbol": padding.symbol,
        "grid": padding.grid,
        "lifetime": queue[1],
    }
    whole = {
        "cw_min": radio.cw_min,
        "cw_max": radio.cw_max,
        "attempts": MAX_ATTEMPTS,
        # Stations without QoS count back-off slots only at the end of an idle slot.
        "edca": radio.standard not in ("802.11a", "802.11g"),
        "bits": padding.bits,
        "added": padding.added,
        "mpdus": aggregation.mpdus if aggregation else 1,
        "max_bytes": aggregation.most_bytes if aggregation else 0,
        "min_subframe": aggregation.least_bytes if aggregation else 0,
        "window": max(BLOCK_ACK_WINDOW, aggregation.mpdus) if aggregation else 1,
        "queue": int(min(queue[0], int(st.NEVER))),
    }
    record = np.zeros(1, st.RADIO)
    for name, value in (whole | {name: to_ticks(value) for name, value in seconds.items()}).items():
        record[name] = value
    record["capture_threshold"], record["capture_threshold_basic"] = from_decibels(threshold)
    return record


def wire_record() -> Records:
    """Return the wire of wired hosts as a radio: nobody contends, and a frame takes a few ticks."""
    wire = np.ones(1, st.RADIO)
    wire["cw_min"] = wire["cw_max"] = 0
    wire["attempts"] = wire["queue"] = wire["lifetime"] = st.NEVER
    return wire


def from_decibels(values: ArrayLike) -> NDArray[np.float64]:
    """Convert decibels to factors."""
    return np.asarray(10 ** (np.asarray(values, dtype=np.float64) / 10))


def _ppdu_ticks(octets: int, padding: OfdmSymbols, preamble: int) -> int:
    symbols = -(-(padding.added + 8 * octets) // padding.bits)
    grid = to_ticks(padding.grid)
    return preamble + -(-symbols * to_ticks(padding.symbol) // grid) * grid


def symbols_and_preambles(wifi: Wifi) -> tuple[tuple[OfdmSymbols, int], tuple[OfdmSymbols, int]]:
    """Return padding and preamble [ticks] of unicast frames, then of multicast frames."""
    radio = wifi.radio
    assert radio is not None
    waiting = radio.aifs + radio.cw_min / 2 * radio.slot
    fast = to_ticks(radio.preamble + radio.signal_extension)
    slow = to_ticks(radio.wifi().multicast.overhead - waiting)
    multicast = wifi.multicast.padding or radio.multicast_padding
    return (wifi.unicast.padding or radio.padding, fast), (multicast, slow)


@dataclass(frozen=True)
class MessageCounts:
    """Messages per process and receiver, for each row of the table; see `state.CellState`."""

    each: NDArray[np.float64]
    to_all: NDArray[np.float64]
    receivers_before: NDArray[np.int64]
    sets: NDArray[np.int64]


def message_counts(
    protocol: Protocol, hosts: Hosts, per_port: Collection[int] = ()
) -> MessageCounts:
    """Count each process's messages; ``per_port`` rows go to every process of a host."""
    everyone = tuple(hosts.ones)
    sets = {everyone: 0}
    remote = hosts.ones.size - hosts.processes[hosts.host_of]
    shape = (hosts.ones.size, len(protocol.messages))
    each, to_all, of_row = np.zeros(shape), np.zeros(shape), np.zeros(shape[1], np.int64)
    for row, message in enumerate(protocol.messages):
        unit = message.unit
        sent = unit.units_per_process(hosts) * (message.per_unit * message.frames)
        taking = unit.receiver_mask(hosts)
        if row in per_port:
            taking, sent = hosts.ones, sent * (hosts.processes.size - 1) / remote
        if taking is None:
            to_all[:, row] = sent
            each[:, row] = sent / remote
            continue
        each[:, row] = sent
        own = np.bincount(hosts.host_of, taking, hosts.processes.size)[hosts.host_of]
        to_all[:, row] = sent * (taking.sum() - own) * (message.cast == "multicast")
        of_row[row] = sets.setdefault(tuple(taking), len(sets))
    before = np.zeros((len(sets), hosts.ones.size + 1), np.int64)
    before[:, 1:] = np.cumsum(list(sets), axis=1)
    return MessageCounts(each, to_all, before, of_row)


def label(protocol: Protocol, message: Message) -> str:
    """Name a message for an error text."""
    return f"protocol {protocol.name!r}, message {message.name!r}"


def carrier_row(protocol: Protocol, message: Message) -> int:
    """Return the only row that can carry a message without frames; refuse several such rows."""
    framed = [m for m in protocol.messages if m.frames]
    outer = [m for m in framed if message.inside in (None, m.name) and m.phase == message.phase]
    if len(outer) != 1:
        got = f"{message.inside!r} of {[m.name for m in outer]}"
        rule = f"inside must name the one message of phase {message.phase!r} whose frames carry it"
        raise ValueError(f"{label(protocol, message)}: to simulate it, {rule}; got {got}")
    return protocol.messages.index(outer[0])


def _piggybacked_octets(protocol: Protocol, hosts: Hosts) -> NDArray[np.float64]:
    """Return the octets that messages without frames add to each frame of their carrier rows."""
    shares = message_counts(protocol, hosts)
    octets = np.zeros(len(protocol.messages))
    for message in protocol.messages:
        if message.frames:
            continue
        carrier = carrier_row(protocol, message)
        alone = Protocol("inside", (replace(message, frames=1.0, inside=None),))
        sent = _total_frames(message_counts(alone, hosts), hosts, 0)
        carriers = max(_total_frames(shares, hosts, carrier), 1.0)
        octets[carrier] += message.payload.nominal * sent / carriers
    return octets


def _total_frames(shares: MessageCounts, hosts: Hosts, row: int) -> float:
    """Return the number of frames of a row that the whole fleet sends [1]."""
    to_all = shares.to_all[:, row].sum()
    if to_all:
        return float(to_all)
    taking = np.diff(shares.receivers_before[shares.sets[row]])
    own = np.bincount(hosts.host_of, taking, hosts.processes.size)[hosts.host_of]
    return float((shares.each[:, row] * (taking.sum() - own)).sum())


def kind_records(
    protocol: Protocol, wifi: Wifi, hosts: Hosts, per_port: Collection[int] = ()
) -> Records:
    """Return the message rows as records for the engine; refuse a row that cannot be simulated."""
    if (got := len(protocol.messages)) > _MAX_MESSAGES:
        most = f"{_MAX_MESSAGES} messages"
        raise ValueError(f"protocol must have at most {most} to simulate; got {got}")
    fast, slow = symbols_and_preambles(wifi)
    shares, inside = message_counts(protocol, hosts, per_port), _piggybacked_octets(protocol, hosts)
    records = np.zeros(len(protocol.messages), st.KIND)
    records["set"] = shares.sets
    records["whole"] = ((shares.each % 1 == 0) & (shares.to_all % 1 == 0)).all(axis=0)
    for row, (record, message) in enumerate(zip(records, protocol.messages, strict=True)):
        multicast, paired = message.cast == "multicast", message.unit.to_each
        if len(message.hops) > 1 and not (multicast or paired):
            rule = "cast must be 'multicast', or hops have one entry, if it is counted by"
            unit = f"{message.unit.name!r}, which has no receivers"
            raise ValueError(f"{label(protocol, message)}: {rule} {unit}; got {message.cast!r}")
        # With block acknowledgements, each frame has a QoS Control field of 2 octets.
        octets = round(message.frame_bytes + inside[row]) + 2 * (wifi.aggregation is not None)
        if octets > _MAX_OCTETS:
            rule = f"its frames must have at most {_MAX_OCTETS} B with headers to be simulated"
            raise ValueError(f"{label(protocol, message)}: {rule}; got {octets}")
        record["octets"] = octets
        record["multicast"], record["to_all"] = multicast, multicast or not paired
        record["up"], record["down"] = "up" in message.hops, "down" in message.hops
        record["time_up"] = _ppdu_ticks(octets, *fast)
        record["time_down"] = _ppdu_ticks(octets, *slow) if multicast else record["time_up"]
    return records


def repeat_kind_records(first_cell: Records, others: Sequence[Records], wired: bool) -> Records:
    """Return the rows once for each cell, with that cell's octets and airtimes of frames."""
    rows = np.tile(first_cell, 1 + len(others) + wired)
    for name in ("octets", "time_up", "time_down"):
        own = np.concatenate([own[name] for own in (first_cell, *others)])
        rows[name][: own.size], rows[name][own.size :] = own, 1
    return rows


def cells_of_hosts(fleet: Fleet) -> NDArray[np.int64]:
    """Return the index of the cell of each host, 0 without cells; wired hosts have the last."""
    names = [cell.name for cell in fleet.cells] or [""]
    cells = [len(names) if group.wired else names.index(group.cell) for group in fleet.groups]
    return np.repeat(cells, [int(group.hosts) for group in fleet.groups])


@dataclass(frozen=True)
class BurstSchedule:
    """A host's bursts: rows, periods [s], and sends (time after the start [s], burst)."""

    rows_by_burst: tuple[tuple[int, ...], ...]
    periods: tuple[float, ...]
    sends: tuple[tuple[float, int], ...]


def bursts_of(protocol: Protocol, rows: Sequence[int]) -> BurstSchedule:
    """Return the scheduled bursts of a protocol; ``rows`` are its rows in the run's table."""
    at: dict[tuple[float, float], list[int]] = {}
    for row, message in zip(rows, protocol.messages, strict=True):
        schedule = message.schedule
        for time in schedule.starts:
            at.setdefault((time, 0.0), []).append(row)
        if np.isfinite(schedule.period):
            first = schedule.starts[-1] + schedule.period
            at.setdefault((first, schedule.period), []).append(row)
            if schedule.period < TICK:
                rule = f"period must be at least {TICK:g} s to be simulated"
                raise ValueError(f"{label(protocol, message)}: {rule}; got {schedule.period:g}")
    sets: dict[tuple[tuple[int, ...], float], int] = {}
    sends = [
        (time, sets.setdefault((tuple(together), period), len(sets)))
        for (time, period), together in sorted(at.items())
    ]
    rows_by_burst, periods = zip(*sets, strict=True) if sets else ((), ())
    return BurstSchedule(rows_by_burst, periods, tuple(sends))
