"""How a middleware recovers: when each message of its table is sent, its timers and its lease.

When a message is sent follows from its role, from what it answers and from its schedule.
"""

import numpy as np

from discostorm import _checks
from discostorm.messages import HOPS, HOST, PAIR, UNITS, Message, Protocol, Role
from discostorm.wifi.channel import TICK
from discostorm_simulation import state as st
from discostorm_simulation.cell_setup import Shares, ticks, where
from discostorm_simulation.result import NoRecovery
from discostorm_simulation.state import Records

#: Timer of TCP before the first round trip (RFC 6298, 2.1), its least and its most (Linux:
#: TCP_RTO_MIN, TCP_RTO_MAX in include/net/tcp.h) [s].
RTO = {"rto_first": 1.0, "rto_min": 0.2, "rto_max": 120.0}
#: What a process sends to a host for each port that a process there may have.
HOST_BY_HOST = UNITS["process and other host"]
#: What a message is to the inner loops; announcements they tell by what they inform of.
_ROLES = {"data": st.DATA, "heartbeat": st.HEARTBEAT, "acknowledgement": st.ACKNACK}


def add_recovery(protocol: Protocol, kinds: Records, shares: Shares) -> Records:
    """Say in the rows of a table how a middleware recovers, and return its timers."""
    _check_table(protocol)
    _check_repair(protocol)
    _check_ports(protocol, shares)
    _fill_kinds(protocol, kinds)
    _check_circles(protocol, kinds)
    for row in np.flatnonzero(kinds["role"] == st.DATA):
        if (most := shares.each[:, row].max()) > 2**st.ITEM_BITS:
            raise ValueError(
                f"{where(protocol, protocol.messages[row])}: a process must send at most "
                f"{2**st.ITEM_BITS} to each other to be simulated with recovery; got {most:g}"
            )
    return _repair_record(protocol)


def _check_table(protocol: Protocol) -> None:
    """Refuse a table that does not say all that recovery takes."""
    without = [message.name for message in protocol.messages if message.role is None]
    if without:
        why = f"its message {without[0]!r} has no role; give each message of the table one, see "
        raise NoRecovery(protocol.name, why + "discostorm.messages.Message")
    if protocol.timers is None:
        why = "it has no timers; give it some, such as discostorm.DDS.timers or "
        raise NoRecovery(protocol.name, why + "discostorm.messages.Timers()")
    if not _announcements(protocol):
        why = "its processes announce themselves to servers or routers, not to each other, and who "
        raise NoRecovery(protocol.name, why + "learns what from these, and when, is not simulated")
    names = [message.name for message in protocol.messages]
    for message in protocol.messages:
        if message.answers is not None:
            told = f"{where(protocol, message)}: answers"
            _checks.choice(told, message.answers, names, ", or None")


def _check_repair(protocol: Protocol) -> None:
    """Refuse data that are not for each process, and heartbeats without one that answers."""
    for message in _of_role(protocol, "data"):
        if not message.unit.to_each:
            raise ValueError(
                f"{where(protocol, message)}: unit must have receivers for what has the role "
                f"'data' to be simulated with recovery; got {message.unit.name!r}"
            )
    asking, answering = (_of_role(protocol, role) for role in ("heartbeat", "acknowledgement"))
    if len(asking) > 1 or [m.name for m in asking] != [m.answers for m in answering]:
        told = ", ".join(f"{m.name!r} ({m.role})" for m in (*asking, *answering))
        raise ValueError(
            f"protocol {protocol.name!r}: of the roles heartbeat and acknowledgement it must have "
            f"none, or one message each, the second of which answers the first; got {told}"
        )


def _of_role(protocol: Protocol, role: Role) -> list[Message]:
    return [message for message in protocol.messages if message.role == role]


def _announcements(protocol: Protocol) -> list[Message]:
    """Return what the clock sends to unknown processes, to all or else to each; not to servers."""
    by_clock = [m for m in _of_role(protocol, "announcement") if m.answers is None and m.frames]
    to_all = [m for m in by_clock if m.cast == "multicast"]
    to_each = (PAIR, HOST_BY_HOST)
    return to_all or [m for m in by_clock if m.unit in to_each and m.hops == HOPS]


def spread(protocol: Protocol) -> list[int]:
    """Return the rows with which processes announce themselves to all ports of listed hosts."""
    to_hosts = [message for message in _announcements(protocol) if message.unit == HOST_BY_HOST]
    return [row for row, message in enumerate(protocol.messages) if message in to_hosts]


def _check_ports(protocol: Protocol, shares: Shares) -> None:
    """Refuse more processes on a host than are announced to it: these would not be found."""
    for row in spread(protocol):
        if (least := shares.each[:, row].min()) < 1:
            message = protocol.messages[row]
            raise ValueError(
                f"{where(protocol, message)}: hosts must have at most {message.per_unit:g} "
                "processes on average, as many as have a port, to be simulated with recovery; "
                f"got {message.per_unit / least:g}"
            )


def clock_only(protocol: Protocol) -> Protocol:
    """Return the table without what is sent on arrival of something or on discovery."""
    rows = tuple(row for row in protocol.messages if _trigger(protocol, row) == st.CLOCK)
    return Protocol(protocol.name, rows)


def _trigger(protocol: Protocol, message: Message) -> int:
    """Return when a message is sent: by the clock, in answer to each, or on discovery."""
    announcing, own = message.role == "announcement", message.schedule
    if message.role in ("data", "heartbeat"):
        return st.DISCOVERY
    if message.answers is None:
        by_clock = announcing or not message.unit.to_each or own.period != np.inf
        return st.CLOCK if by_clock else st.DISCOVERY
    answered = protocol.message(message.answers)
    if not announcing:
        return st.DISCOVERY if answered.role == "announcement" else st.ANSWER
    # With a schedule of its own it is for those that were not known.
    other = answered.schedule
    alike = set(own.starts) <= set(other.starts) and own.period in (other.period, np.inf)
    return st.ANSWER if alike else st.DISCOVERY


def _fill_kinds(protocol: Protocol, kinds: Records) -> None:
    """Say of each row of the table what it is for and when it is sent."""
    names = [message.name for message in protocol.messages]
    announcements = _announcements(protocol)
    for record, message in zip(kinds, protocol.messages, strict=True):
        record["role"] = _ROLES.get(str(message.role), st.OTHER)
        record["trigger"] = _trigger(protocol, message)
        record["to_unknown"] = message in announcements
        record["informs"] = message.informs
        record["of_host"] = message.unit == HOST
        record["tcp"] = message.transport == "TCP"
        record["answers"] = -1
        if message.answers is not None:
            answered = protocol.message(message.answers)
            record["answers"] = names.index(message.answers)
            own, times = message.schedule, answered.schedule
            if message.role == "announcement" and own != times:
                record["when"] = st.LATER if own.starts[0] > times.starts[0] else st.FIRST
            # Half-way to the second time, as queues delay what is sent at first.
            second = (*times.starts, times.starts[-1] + times.period)[1]
            record["since"] = ticks((times.starts[0] + second) / 2)
            if record["trigger"] == st.DISCOVERY and len(own.starts) > 1:
                record["gap_number"] = len(own.starts) - 1
                record["gap_first"] = ticks(own.starts[1] - own.starts[0])


def _check_circles(protocol: Protocol, kinds: Records) -> None:
    """Refuse answers that lead back to what they answer."""
    names = [message.name for message in protocol.messages]
    for row in range(kinds.size):
        chain = [row]
        while kinds["trigger"][row] == st.ANSWER:
            row = kinds["answers"][row]
            if row in chain:
                raise ValueError(
                    f"{where(protocol, protocol.messages[row])}: answers must not lead back to "
                    f"itself; got {' answers '.join(names[n] for n in [*chain, row])}"
                )
            chain.append(row)


def _repair_record(protocol: Protocol) -> Records:
    """Return the timers of a middleware."""
    if protocol.lease < TICK:
        raise ValueError(
            f"protocol {protocol.name!r}: lease must be at least {TICK:g} s to be simulated; "
            f"got {protocol.lease:g}"
        )
    timers = protocol.timers
    assert timers is not None  # see `_check_table`
    seconds = RTO | {"lease": protocol.lease}
    taken = []
    if all(message.schedule.period == np.inf for message in _announcements(protocol)):
        taken += ["announce_interval_initial", "announce_interval_max"]
    record = np.zeros(1, st.REPAIRS)
    names = [message.name for message in protocol.messages]
    for heartbeat in _of_role(protocol, "heartbeat"):
        (acknowledgement,) = _of_role(protocol, "acknowledgement")
        taken += ["heartbeat_period_initial", "heartbeat_period_max"]
        record["heartbeat"] = names.index(heartbeat.name)
        record["acknack"] = names.index(acknowledgement.name)
        record["topics"] = max(1, round(heartbeat.per_unit * heartbeat.frames))
    for name, value in (seconds | {name: getattr(timers, name) for name in taken}).items():
        record[name] = ticks(value)
    return record
