"""How a middleware recovers: what each message of its table is for, its timers and its lease."""

import numpy as np

from discostorm import _checks
from discostorm.data import read_data
from discostorm.messages import (
    ENDPOINT_PAIR,
    HOPS,
    HOST,
    MATCHED_WRITER,
    PAIR,
    UNMATCHED,
    Message,
    Protocol,
)
from discostorm.simulation import cell as _cell
from discostorm.simulation.cell import Records
from discostorm.simulation.traffic import Shares, ticks
from discostorm.wifi.channel import TICK

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
    """Return what the clock sends to all, in the first phase that has such messages.

    If nothing is multicast, that is what goes to each, known or not, from the first phase on:
    nobody is known from what comes after announcements to others, such as servers or hosts.
    """
    by_clock = [m for m in protocol.messages if m.answers is None and m.frames]
    found = [m for m in by_clock if m.cast == "multicast"]
    if not found:
        first = {m.phase for m in by_clock[:1]}
        found = [m for m in by_clock if m.unit == PAIR and m.hops == HOPS and m.phase in first]
    return [m for m in found if m.phase == found[0].phase]


def check_answers(protocol: Protocol) -> None:
    """Refuse messages that answer what the table does not have."""
    names = [message.name for message in protocol.messages]
    for message in protocol.messages:
        if message.answers is not None:
            name = f"protocol {protocol.name!r}, message {message.name!r}: answers"
            _checks.choice(name, message.answers, names, ", or None")


def check_announced(protocol: Protocol) -> None:
    """Refuse to let those recover who do not announce themselves to each other."""
    if not _announcements(protocol):
        raise ValueError(
            f"recovery must be False for the protocol {protocol.name!r}: its processes announce "
            "themselves to servers, routers or listed hosts instead of to each other, and who "
            "learns what from these, and when, is not simulated"
        )


def _phases(protocol: Protocol) -> set[str]:
    return {message.phase for message in _announcements(protocol)}


def _trigger(protocol: Protocol, message: Message) -> int:
    """Return when a message is sent: by the clock, in answer to each, or on discovery."""
    phases = _phases(protocol)
    heartbeat = _heartbeat(protocol)
    if message in _data(protocol) or (heartbeat is not None and message == heartbeat[0]):
        return _cell.DISCOVERY
    if message.answers is None:
        once = message.schedule.period == np.inf
        to_all = not message.unit.to_each
        sent_by_clock = to_all or message.phase in phases or not once
        return _cell.CLOCK if sent_by_clock else _cell.DISCOVERY
    answered = protocol.message(message.answers)
    if message.phase in phases:
        # With a schedule of its own it is for those that were not known.
        return _cell.ANSWER if _at_times_of(message, answered) else _cell.DISCOVERY
    return _cell.DISCOVERY if answered.phase in phases else _cell.ANSWER


def _at_times_of(message: Message, answered: Message) -> bool:
    """Return whether a message is sent each time that another is, or some of these times."""
    own, other = message.schedule, answered.schedule
    return set(own.starts) <= set(other.starts) and own.period in (other.period, np.inf)


def _when(protocol: Protocol, message: Message) -> int:
    """Return which of the messages it answers it does: all, the later ones, or the first."""
    assert message.answers is not None
    own, other = message.schedule, protocol.message(message.answers).schedule
    if message.phase not in _phases(protocol) or own == other:
        return _cell.ALWAYS
    return _cell.LATER if own.starts[0] > other.starts[0] else _cell.FIRST


def _informs(protocol: Protocol) -> set[str]:
    """Return the messages from which a process learns of another."""
    informing = set()
    for message in protocol.messages:
        if _trigger(protocol, message) == _cell.DISCOVERY and message.answers is not None:
            answered = protocol.message(message.answers)
            if not answered.unit.to_each:  # all of the phase announce the same
                informing |= {m.name for m in protocol.messages if m.phase == answered.phase}
            else:
                informing |= {m.name for m in protocol.messages if m.kind == answered.kind}
    if not informing:
        informing = {message.name for message in _announcements(protocol)}
    # Who sends on a connection has one.
    return informing | {m.name for m in _data(protocol) if m.transport == "TCP"}


#: What is sent for each endpoint but tells nothing of it, by the last word of its kind.
_CONTROL = ("Heartbeat", "ACKNACK", "ACK", "KeepAlive", "Frame")


def _data(protocol: Protocol) -> list[Message]:
    """Return what tells of endpoints."""
    phases = _phases(protocol)
    return [
        message
        for message in protocol.messages
        if message.unit in (ENDPOINT_PAIR, UNMATCHED, MATCHED_WRITER)
        and message.frames
        and message.phase not in phases
        and not message.kind.endswith(_CONTROL)
    ]


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
    pair, data, informs = _heartbeat(protocol), _data(protocol), _informs(protocol)
    announced = _announcements(protocol)
    for record, message in zip(kinds, protocol.messages, strict=True):
        record["trigger"] = _trigger(protocol, message)
        record["to_unknown"] = message in announced
        record["informs"] = message.name in informs
        record["of_host"] = message.unit == HOST
        record["tcp"] = message.transport == "TCP"
        record["answers"] = -1
        if message.answers is not None:
            record["answers"] = names.index(message.answers)
            record["when"] = _when(protocol, message)
            answered = protocol.message(message.answers).schedule
            # Half-way to the second time, as queues delay what is sent at first.
            second = (*answered.starts, answered.starts[-1] + answered.period)[1]
            record["since"] = ticks((answered.starts[0] + second) / 2)
            starts = message.schedule.starts
            if record["trigger"] == _cell.DISCOVERY and len(starts) > 1:
                record["gap_number"] = len(starts) - 1
                record["gap_first"] = ticks(starts[1] - starts[0])
        if message in data:
            record["role"] = _cell.DATA
        elif pair is not None and message.name == pair[0].name:
            record["role"] = _cell.HEARTBEAT
        elif pair is not None and message.name == pair[1].name:
            record["role"] = _cell.ACKNACK
    for row in range(kinds.size):
        chain = [row]
        while kinds["trigger"][row] == _cell.ANSWER:
            row = kinds["answers"][row]
            if row in chain:
                raise ValueError(
                    f"protocol {protocol.name!r}, message {names[row]!r}: answers must not lead "
                    f"back to itself; got {' answers '.join(names[n] for n in [*chain, row])}"
                )
            chain.append(row)


def check_items(protocol: Protocol, kinds: Records, shares: Shares) -> None:
    """Refuse more announcements of endpoints for a process than are told apart."""
    for row in np.flatnonzero(kinds["role"] == _cell.DATA):
        if (most := shares.each[:, row].max()) > 2**_cell.ITEM_BITS:
            raise ValueError(
                f"protocol {protocol.name!r}, message {protocol.messages[row].name!r}: a process "
                f"must send at most {2**_cell.ITEM_BITS} to each other to be simulated with "
                f"recovery; got {most:g}"
            )


def repair_record(protocol: Protocol) -> Records:
    """Return the timers of a middleware; see `FAMILY`."""
    if protocol.lease < TICK:
        raise ValueError(
            f"protocol {protocol.name!r}: lease must be at least {TICK:g} s to be simulated; "
            f"got {protocol.lease:g}"
        )
    data = _data(protocol)
    transport = data[0].transport if data else "UDP"
    name = protocol.name.rpartition("periods of ")[2]
    products = {row["protocol"]: row["defaults"] for row in read_data("vendors/products.csv")}
    vendor = _defaults(products.get(name, name)) or _defaults(FAMILY[transport])
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
        record["topics"] = max(1, round(pair[0].per_unit * pair[0].frames))
    for name, value in seconds.items():
        record[name] = ticks(value)
    return record
