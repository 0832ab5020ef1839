"""A discovery of our own: one speaker a host, sets packed in multicasts, coded repair.

A proposal, not a product. The tables hold what is sent without losses; what is done about losses,
deaths and newcomers are the rules of its prototype, in the lab, with the same sizes and times.
What a frame holds has rows of its own, which have no part of a frame: they cost their
bytes alone. Heartbeats are as often as rows say up to 100 hosts; of more hosts the period of
each grows, so that beyond the table is an upper bound. A set is one frame: of those that take
several datagrams the number of frames is a lower bound.
"""

from discostorm.data import read_data
from discostorm.messages import (
    ENDPOINT,
    FLEET,
    HOST,
    HOST_PAIR,
    KIND_ENDPOINT,
    ONCE,
    PROCESS,
    Message,
    Payload,
    Protocol,
    Role,
    Schedule,
    Timers,
    Unit,
)

_ROWS = {row["quantity"]: row for row in read_data("hybrid/parameters.csv")}
_VALUE = {name: float(row["value"]) for name, row in _ROWS.items()}
_BEATS = Schedule((_VALUE["heartbeat"],), _VALUE["heartbeat"])
#: Who misses a set learns so from a Heartbeat, and has it sent again.
_TIMERS = Timers(_VALUE["heartbeat"], _VALUE["heartbeat"])


def _row(
    name: str,
    phase: str,
    quantity: str,
    unit: Unit,
    *,
    schedule: Schedule = ONCE,
    answers: str | None = None,
    inside: str | None = None,
    per_unit: float = 1,
    role: Role = "other",
) -> Message:
    """Return a row of which the data file says the size; with a frame, or inside another's."""
    size, source = _VALUE[quantity], f"data/hybrid/parameters.csv, {quantity}"
    return Message(
        name,
        phase,
        "multicast",
        "UDP",
        Payload(size, size, size, source),
        unit,
        per_unit,
        schedule,
        answers=answers,
        frames=0.0 if inside else 1.0,
        inside=inside,
        role=role,
    )


def _told(name: str, quantity: str, unit: Unit) -> Message:
    """Return a row of what a set tells of, which the set announces."""
    return _row(name, "Sets", quantity, unit, role="announcement", inside="Announce")


_SETS = (
    _row("Announce", "Sets", "header", HOST, role="announcement"),
    _told("Process", "process", PROCESS),
)
_REST = (
    # Of all hosts that are about to show what they hold, the first does; the others hear it.
    _row("Digest", "Digests", "header", FLEET, answers="Announce"),
    _row("Listed", "Digests", "listed", HOST, answers="Announce", inside="Digest"),
    _row("Heartbeat", "Heartbeats", "header", HOST, schedule=_BEATS),
    _row("Claimed", "Heartbeats", "claimed", HOST_PAIR, schedule=_BEATS, inside="Heartbeat"),
)

#: No two hosts run the same software.
HYBRID = Protocol(
    "hybrid",
    (*_SETS, _told("Endpoint", "endpoint", ENDPOINT), *_REST),
    lease=_VALUE["lease"],
    key="hybrid",
    basis="proposal",
    timers=_TIMERS,
)

#: The hosts of a group run the same software: one tells its description, the others its hash.
HYBRID_ALIKE = Protocol(
    "hybrid, alike",
    (
        *_SETS,
        _told("Software", "software", HOST),
        _told("Endpoint", "endpoint", KIND_ENDPOINT),
        *_REST,
    ),
    lease=_VALUE["lease"],
    key="hybrid, alike",
    basis="proposal",
    timers=_TIMERS,
)
