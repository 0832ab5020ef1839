"""From fleet, protocol and channel to the arrays that a run reads and changes.

Who sends and receives a message its `discostorm.messages.Unit` declares. Of a fraction x to each
receiver a process sends floor((i + 1) x + u) - floor(i x + u) to the i-th, with u between 0 and 1
drawn once a run for each process and row: each gets x in the mean, and a whole x in every run.
"""

from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from discostorm import _checks
from discostorm.fleet import COUNTS, LEAST, Fleet, is_symbolic
from discostorm.messages import Hosts, Message, Protocol
from discostorm.wifi import OfdmSymbols, Radio, Wifi
from discostorm.wifi.channel import TICK
from discostorm_simulation import state as st
from discostorm_simulation.state import Records

#: Retransmissions end with this attempt: dot11ShortRetryLimit (IEEE Std 802.11-2020, C.3).
ATTEMPTS = 7
#: From the begin of an OFDM frame until the receiver knows it [s]: aRxPHYStartDelay (17.4.4).
RX_START_DELAY = 20e-6
#: How many frames a block acknowledgement looks back at least (10.25).
WINDOW = 64
#: From an acknowledgement of 14 octets to an action frame of 37 at 6 Mbit/s [s]: eight symbols.
LONGER_ACTION = 8 * 4e-6
#: Longest PSDU of 802.11n (19.4.4) and longest packet of IPv4 (RFC 791) [B].
_MOST_OCTETS = 65_535
_MOST_PROCESSES, _MOST_ENDPOINTS = 2**st.PROCESS_BITS, 2**st.ITEM_BITS
_MOST_MESSAGES = 2**st.KIND_BITS


def ticks(seconds: float) -> int:
    """Return a time in whole ticks; what is too long to count them never comes."""
    never = int(st.NEVER)
    found = float(seconds) / TICK  # as NumPy's floats may raise an error where this is 0
    return never if found >= never else round(found)


def hosts_of(fleet: Fleet) -> Hosts:
    """Return the hosts of a fleet; refuse one that is not made of whole numbers."""
    fleet.reject_wired("a simulation")
    rows = []
    for index, group in enumerate(fleet.groups):
        for count, value in zip(COUNTS, group.counts(), strict=True):
            name = f"groups[{index}].{count}" + f" of {group.name}" * bool(group.name)
            if is_symbolic(value):
                raise TypeError(f"fleet: {name} must be a number to simulate; got {value}")
            most = {"endpoints": _MOST_ENDPOINTS}.get(count, _MOST_PROCESSES)
            _checks.integer(f"fleet: {name}", value, LEAST[count], most)
        rows.append([int(value) for value in group.counts()])
    numbers, processes, endpoints = np.array(rows, dtype=np.int64).T
    if numbers.sum() < 2:
        raise ValueError(f"fleet must have at least 2 hosts to simulate; got {numbers.sum()}")
    if (total := (numbers * processes).sum()) > _MOST_PROCESSES:
        raise ValueError(
            f"fleet must have at most {_MOST_PROCESSES} processes to simulate; got {total}"
        )
    return Hosts(
        np.repeat(processes, numbers),
        np.repeat(endpoints, numbers),
        np.repeat(np.arange(numbers.size), numbers),
        fleet.matching,
        np.repeat([float(group.shared) for group in fleet.groups], numbers),
    )


def radio_record(
    wifi: Wifi, queue: tuple[float, float], eifs: bool, threshold: tuple[float, float]
) -> Records:
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
        "eifs_extra": (radio.sifs + basic + extension) * eifs,
        "ack": radio.ack + extension,
        "block_ack": radio.block_ack + extension,
        # A request has 24 octets, which take as many symbols as a block acknowledgement of 32.
        "bar": radio.block_ack + extension,
        "addba": basic + LONGER_ACTION + extension,
        "basic_ack": basic + extension,
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
        "max_bytes": aggregation.most_bytes if aggregation else 0,
        "min_subframe": aggregation.least_bytes if aggregation else 0,
        "window": max(WINDOW, aggregation.mpdus) if aggregation else 1,
        "queue": int(min(queue[0], int(st.NEVER))),
    }
    record = np.zeros(1, st.RADIO)
    for name, value in (whole | {name: ticks(value) for name, value in seconds.items()}).items():
        record[name] = value
    record["capture_threshold"], record["capture_threshold_basic"] = from_decibels(threshold)
    return record


def from_decibels(values: ArrayLike) -> NDArray[np.float64]:
    """Return factors of decibels."""
    return np.asarray(10 ** (np.asarray(values, dtype=np.float64) / 10))


def _ppdu_ticks(octets: int, padding: OfdmSymbols, preamble: int) -> int:
    symbols = -(-(padding.added + 8 * octets) // padding.bits)
    grid = ticks(padding.grid)
    return preamble + -(-symbols * ticks(padding.symbol) // grid) * grid


def paddings(wifi: Wifi) -> tuple[tuple[OfdmSymbols, int], tuple[OfdmSymbols, int]]:
    """Return padding and preamble [ticks] of frames to one receiver, and of those to all."""
    radio = wifi.radio
    assert radio is not None
    waiting = radio.aifs + radio.cw_min / 2 * radio.slot
    fast = ticks(radio.preamble + radio.signal_extension)
    slow = ticks(radio.wifi().multicast.overhead - waiting)
    return (
        (wifi.unicast.padding or radio.padding, fast),
        (wifi.multicast.padding or radio.multicast_padding, slow),
    )


@dataclass(frozen=True)
class Shares:
    """How many of each message each process sends, and to whom; see `cell.CellState`."""

    each: NDArray[np.float64]
    to_all: NDArray[np.float64]
    receivers_before: NDArray[np.int64]
    sets: NDArray[np.int64]

    def most(self) -> NDArray[np.int64]:
        """Return how many of each message a process sends at most, at once, to one or to all."""
        return np.asarray(np.ceil(np.maximum(self.each, self.to_all).max(axis=0)), np.int64)


def shares_of(protocol: Protocol, hosts: Hosts, spread: Collection[int] = ()) -> Shares:
    """Return what each process sends to whom; rows of ``spread`` go to all processes of a host."""
    everyone = tuple(hosts.every)
    sets = {everyone: 0}
    remote = hosts.every.size - hosts.processes[hosts.host_of]
    shape = (hosts.every.size, len(protocol.messages))
    each, to_all, of_row = np.zeros(shape), np.zeros(shape), np.zeros(shape[1], np.int64)
    for row, message in enumerate(protocol.messages):
        unit = message.unit
        sent = unit.senders(hosts) * (message.per_unit * message.frames)
        taking = unit.receivers(hosts)
        if row in spread:
            taking, sent = hosts.every, sent * (hosts.processes.size - 1) / remote
        if taking is None:
            to_all[:, row] = sent
            each[:, row] = sent / remote
            continue
        each[:, row] = sent
        own = np.bincount(hosts.host_of, taking, hosts.processes.size)[hosts.host_of]
        to_all[:, row] = sent * (taking.sum() - own) * (message.cast == "multicast")
        of_row[row] = sets.setdefault(tuple(taking), len(sets))
    before = np.zeros((len(sets), hosts.every.size + 1), np.int64)
    before[:, 1:] = np.cumsum(list(sets), axis=1)
    return Shares(each, to_all, before, of_row)


def where(protocol: Protocol, message: Message) -> str:
    """Return how errors name a message."""
    return f"protocol {protocol.name!r}, message {message.name!r}"


def carrier_of(protocol: Protocol, message: Message) -> int:
    """Return the row in whose frames a message without any is: the only one it may be in."""
    framed = [m for m in protocol.messages if m.frames]
    outer = [m for m in framed if message.inside in (None, m.name) and m.phase == message.phase]
    if len(outer) != 1:
        raise ValueError(
            f"{where(protocol, message)}: inside must be the one message of the phase "
            f"{message.phase!r} in whose frames it is, to be simulated; "
            f"got {message.inside!r} of {[m.name for m in outer]}"
        )
    return protocol.messages.index(outer[0])


def _inside(protocol: Protocol, hosts: Hosts) -> NDArray[np.float64]:
    """Return the octets in each frame of a message that rows without frames put inside it."""
    shares = shares_of(protocol, hosts)
    octets = np.zeros(len(protocol.messages))
    for message in protocol.messages:
        if message.frames:
            continue
        carrier = carrier_of(protocol, message)
        alone = Protocol("inside", (replace(message, frames=1.0, inside=None),))
        sent = _sent(shares_of(alone, hosts), hosts, 0)
        octets[carrier] += message.payload.nominal * sent / max(_sent(shares, hosts, carrier), 1.0)
    return octets


def _sent(shares: Shares, hosts: Hosts, row: int) -> float:
    """Return how many frames of a row the fleet sends [1]."""
    to_all = shares.to_all[:, row].sum()
    if to_all:
        return float(to_all)
    taking = np.diff(shares.receivers_before[shares.sets[row]])
    own = np.bincount(hosts.host_of, taking, hosts.processes.size)[hosts.host_of]
    return float((shares.each[:, row] * (taking.sum() - own)).sum())


def kind_records(
    protocol: Protocol, wifi: Wifi, hosts: Hosts, spread: Collection[int] = ()
) -> Records:
    """Return the rows of a protocol's table; refuse what cannot be simulated."""
    if len(protocol.messages) > _MOST_MESSAGES:
        raise ValueError(
            f"protocol must have at most {_MOST_MESSAGES} messages to simulate; "
            f"got {len(protocol.messages)}"
        )
    fast, slow = paddings(wifi)
    shares, inside = shares_of(protocol, hosts, spread), _inside(protocol, hosts)
    records = np.zeros(len(protocol.messages), st.KIND)
    records["set"] = shares.sets
    records["whole"] = ((shares.each % 1 == 0) & (shares.to_all % 1 == 0)).all(axis=0)
    for row, (record, message) in enumerate(zip(records, protocol.messages, strict=True)):
        multicast, paired = message.cast == "multicast", message.unit.to_each
        if len(message.hops) > 1 and not (multicast or paired):
            raise ValueError(
                f"{where(protocol, message)}: cast must be 'multicast', or hops only one of them, "
                f"for what is counted by {message.unit.name!r}, which has no receivers; "
                f"got {message.cast!r}"
            )
        # Under a block acknowledgement each frame has a QoS Control field.
        octets = round(message.frame_bytes + inside[row]) + 2 * (wifi.aggregation is not None)
        if octets > _MOST_OCTETS:
            raise ValueError(
                f"{where(protocol, message)}: its frames must have at most {_MOST_OCTETS} B with "
                f"headers to be simulated; got {octets}"
            )
        record["octets"] = octets
        record["multicast"] = multicast
        record["to_all"] = multicast or not paired
        record["up"] = "up" in message.hops
        record["down"] = "down" in message.hops
        record["time_up"] = _ppdu_ticks(octets, *fast)
        record["time_down"] = _ppdu_ticks(octets, *slow) if multicast else record["time_up"]
    return records


@dataclass(frozen=True)
class Bursts:
    """What a host sends by the clock: sets of messages, and when each is sent after the start."""

    messages: tuple[tuple[int, ...], ...]
    period: tuple[float, ...]
    times: tuple[tuple[float, int], ...]


def bursts_of(protocol: Protocol, rows: Sequence[int]) -> Bursts:
    """Return what a host sends by the clock alone, as ``rows`` of the run's table."""
    at: dict[tuple[float, float], list[int]] = {}
    for row, message in zip(rows, protocol.messages, strict=True):
        schedule = message.schedule
        for time in schedule.starts:
            at.setdefault((time, 0.0), []).append(row)
        if np.isfinite(schedule.period):
            first = schedule.starts[-1] + schedule.period
            at.setdefault((first, schedule.period), []).append(row)
            if schedule.period < TICK:
                raise ValueError(
                    f"{where(protocol, message)}: period must be at least {TICK:g} s to be "
                    f"simulated; got {schedule.period:g}"
                )
    sets: dict[tuple[tuple[int, ...], float], int] = {}
    times = [
        (time, sets.setdefault((tuple(together), period), len(sets)))
        for (time, period), together in sorted(at.items())
    ]
    messages, periods = zip(*sets, strict=True) if sets else ((), ())
    return Bursts(messages, periods, tuple(times))
