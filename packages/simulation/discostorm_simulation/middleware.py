"""Rules of the middleware's recovery: when it sends each message, its timers and its lease.

A message's role, leg (see `messages.legs`), answered message and schedule decide when.
"""

from dataclasses import replace
from typing import get_args

import numpy as np

from discostorm import _checks
from discostorm.messages import HOST, Hosts, Message, Protocol, Role, legs
from discostorm.wifi.channel import TICK
from discostorm_simulation import state as st
from discostorm_simulation.cell_setup import MessageCounts, label, to_ticks
from discostorm_simulation.result import NoRecovery
from discostorm_simulation.state import Records

#: Retransmission timeouts of TCP [s]: before the first round trip (RFC 6298, 2.1), minimum and
#: maximum (Linux: TCP_RTO_MIN, TCP_RTO_MAX in include/net/tcp.h).
RTO = {"rto_first": 1.0, "rto_min": 0.2, "rto_max": 120.0}
#: The engine's numbers of legs and roles; announcements are marked by ``informs``.
_LEGS = {leg: number for number, leg in enumerate(get_args(legs.Leg))}
_ROLES = {"data": st.DATA, "heartbeat": st.HEARTBEAT, "acknowledgement": st.ACKNACK}


def add_recovery(protocol: Protocol, kinds: Records, shares: MessageCounts) -> Records:
    """Fill in when each row is sent and how losses are recovered; return the timers."""
    _check_table(protocol)
    _check_repair(protocol)
    _check_ports(protocol, shares)
    _fill_kinds(protocol, kinds)
    if legs.has_server(protocol):
        kinds["to_all"][kinds["leg"] != st.DIRECT] = 0
        kinds["set"] = shares.sets
        kinds["whole"] = (shares.each % 1 == 0).all(axis=0) & (shares.to_all % 1 == 0).all(axis=0)
    _check_answer_cycles(protocol, kinds)
    for row in np.flatnonzero(kinds["role"] == st.DATA):
        if (most := shares.each[:, row].max()) > 2**st.ITEM_BITS:
            told = label(protocol, protocol.messages[row])
            rule = f"a process must send at most {2**st.ITEM_BITS} per receiver"
            raise ValueError(f"{told}: {rule} to be simulated with recovery; got {most:g}")
    return _repair_record(protocol)


def _check_table(protocol: Protocol) -> None:
    """Refuse a table that lacks the roles, timers or announcements that recovery needs."""
    without = [message.name for message in protocol.messages if message.role is None]
    if without:
        why = f"its message {without[0]!r} has no role; give each message of the table one, see "
        raise NoRecovery(protocol.name, why + "discostorm.messages.Message")
    if protocol.timers is None:
        why = "it has no timers; give it some, such as discostorm.DDS.timers or "
        raise NoRecovery(protocol.name, why + "discostorm.messages.Timers()")
    if not legs.announcements(protocol):
        why = "it does not say how processes find each other, or which messages go to a server on "
        raise NoRecovery(protocol.name, why + "a host")
    names = [message.name for message in protocol.messages]
    for message in protocol.messages:
        if message.answers is not None:
            told = f"{label(protocol, message)}: answers"
            _checks.choice(told, message.answers, names, ", or None")


def _check_repair(protocol: Protocol) -> None:
    """Refuse data without receivers, and Heartbeats without exactly one answering message."""
    for message in _with_role(protocol, "data"):
        if not message.unit.to_each and leg_code(protocol, message) == st.DIRECT:
            rule = "unit must have receivers to simulate the role 'data' with recovery"
            raise ValueError(f"{label(protocol, message)}: {rule}; got {message.unit.name!r}")
    asking, answering = (_with_role(protocol, role) for role in ("heartbeat", "acknowledgement"))
    names, asked = sorted(m.name for m in asking), sorted(str(m.answers) for m in answering)
    if len(asking) > 1 + 2 * legs.has_server(protocol) or names != asked:
        told = ", ".join(f"{m.name!r} ({m.role})" for m in (*asking, *answering))
        raise ValueError(
            f"protocol {protocol.name!r}: it must have one heartbeat and one "
            f"acknowledgement that answers it, or neither; got {told}"
        )


def _with_role(protocol: Protocol, role: Role) -> list[Message]:
    return [message for message in protocol.messages if message.role == role]


def leg_code(protocol: Protocol, message: Message) -> int:
    """Return the leg of a message as the engine's number."""
    return _LEGS[legs.legs(protocol)[message.name]]


def add_server_counts(protocol: Protocol, shares: MessageCounts, hosts: Hosts) -> MessageCounts:
    """Return the counts with the wired server added as the last process."""
    count, sets = hosts.ones.size, np.diff(shares.receivers_before, axis=1)
    taking = np.pad([*sets, 0 * hosts.ones, hosts.process_mask("host")], ((0, 0), (0, 1)))
    everyone, server, first = 0, len(sets), len(sets) + 1
    taking[server, count] = 1
    each, to_all = (np.pad(table, ((0, 1), (0, 0))) for table in (shares.each, shares.to_all))
    of_row = shares.sets.copy()
    for row, message in enumerate(protocol.messages):
        leg, to_hosts = leg_code(protocol, message), message.unit.to == "other host"
        if leg == st.DIRECT:
            continue
        sent = message.unit.units_per_process(hosts) * (message.per_unit * message.frames)
        if leg == st.TO_SERVER:
            sent = sent * (hosts.processes.size - 1 if to_hosts else 1)
        elif leg != st.FROM_SERVER and not to_hosts:
            sent = sent / max(count - 1, 1)
        each[:count, row], to_all[:, row] = sent, 0
        of_row[row] = server if leg == st.TO_SERVER else first if to_hosts else everyone
    before = np.pad(np.cumsum(taking, axis=1), ((0, 0), (1, 0)))
    return replace(shares, each=each, to_all=to_all, receivers_before=before, sets=of_row)


def _check_ports(protocol: Protocol, shares: MessageCounts) -> None:
    """Refuse more processes on a host than its announcements reach."""
    for row in legs.rows_to_every_port(protocol):
        if (least := shares.each[:, row].min()) < 1:
            message = protocol.messages[row]
            rule = f"hosts must have at most {message.per_unit:g} processes on average"
            got = f"to be simulated with recovery; got {message.per_unit / least:g}"
            raise ValueError(f"{label(protocol, message)}: {rule}, one for each port, {got}")


def scheduled_messages(protocol: Protocol) -> Protocol:
    """Return the table's scheduled messages, without answers and messages on discovery."""
    rows = tuple(row for row in protocol.messages if _trigger(protocol, row) == st.CLOCK)
    return Protocol(protocol.name, rows)


def _trigger(protocol: Protocol, message: Message) -> int:
    """Return what triggers a message: the clock, each answered message, or discovery."""
    announcing, leg = message.role == "announcement", leg_code(protocol, message)
    own = message.schedule
    if message.role in ("data", "heartbeat") or leg == st.PASSED_ON:
        return st.DISCOVERY
    if message in legs.announcements(protocol):
        return st.CLOCK
    # An answer to a message of the same leg is sent together with that message.
    way = leg_code(protocol, protocol.message(message.answers)) if message.answers else leg
    if leg == way != st.DIRECT and not announcing:
        return st.CLOCK if own.period != np.inf else st.DISCOVERY
    if message.answers is None:
        by_clock = announcing or not message.unit.to_each or own.period != np.inf
        return st.CLOCK if by_clock else st.DISCOVERY
    answered = protocol.message(message.answers)
    served = leg in (st.TO_SERVER, st.FROM_SERVER) or legs.has_router_per_host(protocol)
    # A message that shares only some frames of other messages triggers no answer.
    if served and answered.role == message.role == "other" and legs.shares_frames(answered):
        return st.DISCOVERY
    if not announcing:
        return st.DISCOVERY if answered.role == "announcement" else st.ANSWER
    # A schedule of its own means that the answer goes only to newly discovered processes.
    other = answered.schedule
    alike = set(own.starts) <= set(other.starts) and own.period in (other.period, np.inf)
    return st.ANSWER if alike else st.DISCOVERY


def _delay_after_discovery(protocol: Protocol, message: Message) -> float:
    """Return how long after discovery a message is sent over UDP [s]."""
    leg, begin = leg_code(protocol, message), message.schedule.starts[0]
    if message.transport == "TCP":
        return 0.0
    if leg == st.DIRECT:
        answers = message.role in ("data", "heartbeat")
        timers = protocol.timers
        pulled = timers and timers.preemptive_acknack_delay > 0
        return timers.nack_response_delay if answers and timers and not pulled else 0.0
    found = [m for m in protocol.messages if _trigger(protocol, m) == st.DISCOVERY]
    alike = [m.schedule.starts[0] for m in found if leg_code(protocol, m) == leg]
    return begin - min(alike) if message in found else 0.0


def _fill_kinds(protocol: Protocol, kinds: Records) -> None:
    """Fill the role and the trigger into each record of the table."""
    names = [message.name for message in protocol.messages]
    announced, hosts_learn = legs.announcements(protocol), legs.has_router_per_host(protocol)
    for record, message in zip(kinds, protocol.messages, strict=True):
        record["leg"] = leg_code(protocol, message)
        record["role"] = _ROLES.get(str(message.role), st.OTHER)
        if message.role == "announcement" and record["leg"] == st.PASSED_ON:
            record["role"] = st.DATA  # the server repeats it like data
        record["delay"] = to_ticks(_delay_after_discovery(protocol, message))
        record["trigger"] = _trigger(protocol, message)
        record["to_unknown"] = message in announced
        record["informs"] = legs.introduces_sender(protocol, message)
        of_host = message.unit.what == "host" if hosts_learn else message.unit == HOST
        record["of_host"] = of_host and record["leg"] != st.FROM_SERVER
        heard = hosts_learn and record["leg"] not in (st.TO_SERVER, st.BACK)
        record["to_host"] = heard and (of_host or message.unit.to == "other host")
        record["tcp"] = message.transport == "TCP"
        found = record["trigger"] == st.DISCOVERY
        if record["trigger"] == st.ANSWER:  # a message to a process that the server introduced
            found = leg_code(protocol, protocol.message(str(message.answers))) == st.PASSED_ON
        own = message.role == "other" and record["leg"] == st.DIRECT and found
        record["asked"] = own and message.name in {m.answers for m in protocol.messages}
        record["answers"] = -1
        if message.answers is not None:
            answered = protocol.message(message.answers)
            record["answers"] = names.index(legs.answered_message(protocol, message).name)
            own, times = message.schedule, answered.schedule
            if message.role == "announcement" and own != times:
                record["when"] = st.LATER if own.starts[0] > times.starts[0] else st.FIRST
            # Split half-way to the second send time, because queues delay the first one.
            second = (*times.starts, times.starts[-1] + times.period)[1]
            record["since"] = to_ticks((times.starts[0] + second) / 2)
            if record["trigger"] == st.DISCOVERY and len(own.starts) > 1:
                record["gap_number"] = len(own.starts) - 1
                record["gap_first"] = to_ticks(own.starts[1] - own.starts[0])


def _check_answer_cycles(protocol: Protocol, kinds: Records) -> None:
    """Refuse answers that lead back to the answered message."""
    names = [message.name for message in protocol.messages]
    for row in range(kinds.size):
        chain = [row]
        while kinds["trigger"][row] == st.ANSWER:
            row = kinds["answers"][row]
            if row in chain:
                told = label(protocol, protocol.messages[row])
                got = " answers ".join(names[n] for n in [*chain, row])
                raise ValueError(f"{told}: answers must not lead back to itself; got {got}")
            chain.append(row)


def _repair_record(protocol: Protocol) -> Records:
    """Return the middleware's timers as a record for the engine."""
    if protocol.lease < TICK:
        rule = f"lease must be at least {TICK:g} s to be simulated; got {protocol.lease:g}"
        raise ValueError(f"protocol {protocol.name!r}: {rule}")
    timers = protocol.timers
    assert timers is not None  # `_check_table` has refused None
    seconds = RTO | {"lease": protocol.lease}
    taken = ["nack_response_delay", "heartbeat_response_delay", "preemptive_acknack_delay"]
    if all(message.schedule.period == np.inf for message in legs.announcements(protocol)):
        taken += ["announce_interval_initial", "announce_interval_max"]
    record = np.zeros(1, st.REPAIRS)
    names = [message.name for message in protocol.messages]
    for heartbeat in _with_role(protocol, "heartbeat")[:1]:
        record["heartbeat_octets"] = round(heartbeat.payload.nominal)
        acknowledgement, *_ = _with_role(protocol, "acknowledgement")
        taken += ["heartbeat_period_initial", "heartbeat_period_max"]
        record["heartbeat"] = names.index(heartbeat.name)
        record["acknack"] = names.index(acknowledgement.name)
        record["topics"] = max(1, round(heartbeat.per_unit * heartbeat.frames))
    for name, value in (seconds | {name: getattr(timers, name) for name in taken}).items():
        record[name] = to_ticks(value)
    record["preemptive_acknack_factor"] = round(timers.preemptive_acknack_factor)
    record["send_buffer"] = round(timers.send_buffer)
    for message in _with_role(protocol, "data")[:1]:
        record["samples"] = round(st.PARTS / message.frames)
        record["data_octets"] = round(message.payload.nominal / message.frames)
    # A table that has further Heartbeats counts those that ride on first sendings.
    kinds = {role: {m.kind for m in _with_role(protocol, role)} for role in ("heartbeat", "other")}
    record["riding"] = not kinds["heartbeat"] & kinds["other"]
    return record
