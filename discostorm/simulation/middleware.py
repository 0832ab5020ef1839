"""How a middleware recovers: what each message of its table is for, its timers and its lease."""

import numpy as np

from discostorm.data import read_data
from discostorm.messages import ENDPOINT_PAIR, PAIR, PROCESS, Message, Protocol
from discostorm.simulation import cell as _cell
from discostorm.simulation.cell import Records
from discostorm.simulation.traffic import ticks

#: Timer of TCP before the first round trip [s] (RFC 6298, 2.1).
RTO_FIRST = 1.0
#: Least and most of the timer [s] (Linux: TCP_RTO_MIN, TCP_RTO_MAX in include/net/tcp.h).
RTO_LEAST, RTO_MOST = 0.2, 120.0
#: Whose timers a table has that names none: by the transport of its endpoints.
FAMILY = {"UDP": "Fast DDS", "TCP": "Zenoh"}


def _defaults(product: str) -> dict[str, float]:
    rows = read_data("vendors/middleware_defaults.csv")
    return {row["quantity"]: float(row["value"]) for row in rows if row["product"] == product}


def clock_only(protocol: Protocol) -> Protocol:
    """Return the table without what is sent on arrival of something or on discovery."""
    rows = tuple(
        message for message in protocol.messages if _trigger(protocol, message) == _cell.CLOCK
    )
    return Protocol(protocol.name, rows)


def _announcements(protocol: Protocol) -> list[Message]:
    return [m for m in protocol.messages if m.unit == PROCESS and m.answers is None]


def _phases(protocol: Protocol) -> set[str]:
    return {message.phase for message in _announcements(protocol)}


def _trigger(protocol: Protocol, message: Message) -> int:
    """Return when a message is sent: by the clock, in answer to each, or on discovery."""
    phases = _phases(protocol)
    if message.answers is None:
        once = message.schedule.period == np.inf
        sent_by_clock = message.unit == PROCESS or message.phase in phases or not once
        return _cell.CLOCK if sent_by_clock else _cell.DISCOVERY
    answered = protocol.message(message.answers)
    if message.phase in phases:
        # With a schedule of its own it is for those that were not known.
        same = message.schedule == answered.schedule
        return _cell.ANSWER if same else _cell.DISCOVERY
    return _cell.DISCOVERY if answered.phase in phases else _cell.ANSWER


def _informs(protocol: Protocol) -> set[str]:
    """Return the messages from which a process learns of another."""
    informing = set()
    for message in protocol.messages:
        if _trigger(protocol, message) == _cell.DISCOVERY and message.answers is not None:
            answered = protocol.message(message.answers)
            if answered.unit == PROCESS:  # all of the phase announce the same
                informing |= {m.name for m in protocol.messages if m.phase == answered.phase}
            else:
                informing.add(answered.name)
    if not informing:
        informing = {message.name for message in _announcements(protocol)}
    # Who sends on a connection has one.
    return informing | {m.name for m in _data(protocol) if m.transport == "TCP"}


def _data(protocol: Protocol) -> list[Message]:
    return [message for message in protocol.messages if message.unit == ENDPOINT_PAIR]


def _heartbeat(protocol: Protocol) -> tuple[Message, Message] | None:
    """Return the Heartbeat of the endpoints' announcements, and what acknowledges."""
    phases = {message.phase for message in _data(protocol) if message.transport == "UDP"}
    for acknack in protocol.messages:
        if acknack.answers is not None and acknack.unit == PAIR and acknack.phase in phases:
            heartbeat = protocol.message(acknack.answers)
            if heartbeat.phase in phases and heartbeat.unit == PAIR:
                return heartbeat, acknack
    return None


def fill_kinds(protocol: Protocol, kinds: Records) -> None:
    """Say of each row of the table what it is for and when it is sent."""
    names = [message.name for message in protocol.messages]
    pair = _heartbeat(protocol)
    before = 0
    for record, message in zip(kinds, protocol.messages, strict=True):
        record["trigger"] = _trigger(protocol, message)
        record["informs"] = message.name in _informs(protocol)
        record["tcp"] = message.transport == "TCP"
        record["answers"] = -1
        if message.answers is not None:
            answered = protocol.message(message.answers)
            record["answers"] = names.index(answered.name)
            times = answered.per_unit if answered.unit == message.unit else 1
            record["each_answer"] = max(1, round(message.per_unit / times))
            starts = message.schedule.starts
            if record["trigger"] == _cell.DISCOVERY and len(starts) > 1:
                record["gap_number"] = len(starts) - 1
                record["gap_first"] = ticks(starts[1] - starts[0])
        if message.unit == ENDPOINT_PAIR:
            record["role"] = _cell.DATA
            record["before"] = before
            before += int(message.per_unit)
        elif pair is not None and message.name == pair[0].name:
            record["role"] = _cell.HEARTBEAT
        elif pair is not None and message.name == pair[1].name:
            record["role"] = _cell.ACKNACK


def repair_record(protocol: Protocol) -> Records:
    """Return the timers of a middleware; see `FAMILY`."""
    data = _data(protocol)
    transport = data[0].transport if data else "UDP"
    product = protocol.name.rpartition("periods of ")[2]
    vendor = _defaults(product) or _defaults(FAMILY[transport])
    names = [message.name for message in protocol.messages]
    pair = _heartbeat(protocol)
    record = np.zeros(1, _cell.REPAIRS)
    seconds = {
        "lease": protocol.lease,
        "rto_first": RTO_FIRST,
        "rto_least": RTO_LEAST,
        "rto_most": RTO_MOST,
    }
    if all(message.schedule.period == np.inf for message in _announcements(protocol)):
        period = vendor.get("announcement_period", vendor.get("scout_first", 0.0))
        seconds["announce_first"] = period
        seconds["announce_most"] = vendor.get("scout_most", period)
    if pair is not None:
        period = vendor.get("heartbeat_period", vendor.get("heartbeat_first", 1.0))
        seconds["heartbeat_first"] = period
        seconds["heartbeat_most"] = vendor.get("heartbeat_most", period)
        record["heartbeat"], record["acknack"] = (names.index(m.name) for m in pair)
        record["topics"] = int(pair[0].per_unit)
    for name, value in seconds.items():
        record[name] = ticks(value)
    record["items"] = sum(int(message.per_unit) for message in data)
    return record
