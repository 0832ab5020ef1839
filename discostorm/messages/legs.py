"""The leg of each message: between two processes, or to, from and through a wired server.

A message with one hop goes to the server or comes from it. Messages that a server sends to each
other process or host are passed on; their answers go back to it.
"""

from typing import Literal, cast

from discostorm.messages.message import HOPS, Message
from discostorm.messages.protocol import Protocol
from discostorm.messages.schedule import ONCE
from discostorm.messages.units import PAIR, UNITS

Leg = Literal["direct", "to server", "from server", "passed on", "back"]

#: The unit of a message to every port that a process may use on each other host.
HOST_BY_HOST = UNITS["process and other host"]


def announcements(protocol: Protocol) -> list[Message]:
    """Return the scheduled messages that reach undiscovered processes or a wired server."""
    announcing = (m for m in protocol.messages if m.role == "announcement")
    by_clock = [m for m in announcing if not m.answers and m.frames]
    to_all = [m for m in by_clock if m.cast == "multicast"]
    to_each = (PAIR, HOST_BY_HOST)
    announced = [m for m in by_clock if m.hops == ("up",) or (m.unit in to_each and m.hops == HOPS)]
    return to_all or announced or _connecting_messages(protocol)


def _connecting_messages(protocol: Protocol) -> list[Message]:
    """Return the messages with which hosts connect at once to configured peers."""
    wanted = ("other", "TCP", ONCE, None)
    found = [m for m in protocol.messages if (m.role, m.transport, m.schedule, m.answers) == wanted]
    return [message for message in found if message.hops != ("down",)]


def has_server(protocol: Protocol) -> bool:
    """Return whether processes discover each other through a wired server."""
    return any(message.hops == ("up",) for message in announcements(protocol))


def has_router_per_host(protocol: Protocol) -> bool:
    """Return whether one process of each host, its router, discovers others for the whole host."""
    return any(message.unit.what == "host" for message in _connecting_messages(protocol))


def legs(protocol: Protocol) -> dict[str, Leg]:
    """Return the leg of each message, by the name of the message."""
    kept = vars(protocol)  # hashing a table would take longer
    if "_legs" not in kept:
        found: dict[str, Leg] = {message.name: "direct" for message in protocol.messages}
        served = protocol.messages if has_server(protocol) else ()
        for message in (m for m in served if m.hops == ("down",)):
            passing = message.unit.to in ("other process", "other host")
            found[message.name] = "passed on" if passing else "from server"
        for message in (m for m in served if m.hops == ("up",)):
            back = found.get(message.answers or "") == "passed on"
            found[message.name] = "back" if back else "to server"
        kept["_legs"] = found
    return cast(dict[str, Leg], kept["_legs"])


def rows_to_every_port(protocol: Protocol) -> list[int]:
    """Return the rows that announce a process to every port of the listed hosts."""
    to_hosts = [message for message in announcements(protocol) if message.unit == HOST_BY_HOST]
    return [row for row, message in enumerate(protocol.messages) if message in to_hosts]


def shares_frames(message: Message) -> bool:
    """Return whether a message shares frames with others, so that it needs less than one."""
    return message.frames < 1 and message.per_unit * message.frames < 1


def introduces_sender(protocol: Protocol, message: Message) -> bool:
    """Return whether a message, or another one in the same frames, introduces its sender."""
    leg = legs(protocol)[message.name]
    beside = [m for m in protocol.messages if m.informs and m.per_unit * m.frames < 1]
    shares = any((m.phase, legs(protocol)[m.name]) == (message.phase, leg) for m in beside)
    return message.informs or (shares and leg in ("to server", "from server"))


def answered_message(protocol: Protocol, message: Message) -> Message:
    """Return the message that another one answers, or one that is always sent in its place."""
    answered = protocol.message(message.answers or "")
    if legs(protocol)[message.name] != "back" or not shares_frames(answered):
        return answered
    passed = [m for m in protocol.messages if legs(protocol)[m.name] == "passed on"]
    data = [m for m in passed if m.role == "data"]
    return max(data, key=lambda m: m.per_unit * m.frames, default=answered)
