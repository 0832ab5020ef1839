"""What Fast DDS sends with a Discovery Server, as measured and as its source says.

Clients announce themselves and their endpoints to the server alone, which passes them on to those
whose endpoints match. So it filters: among robots with names of their own nothing of what is sent
grows with pairs, and a wired server costs less than simple discovery from two hosts on.
Where everything matches, the server sends each of :math:`N` clients the endpoints of all others:
its downlink grows with :math:`N^2`, as the SEDP of simple discovery does, and what is not
acknowledged in time is sent again. Clients still exchange liveliness and the Heartbeats of users
without it. If all of ten endpoints a process match, one server is still cheaper with two processes
a host, and two servers cost more than simple discovery in small fleets; with a hundred, a wired
server costs more in small fleets, and the other two do up to a hundred hosts. One topic that all
share, as that of the graph of ROS 2, makes the server tell everybody of everybody, but not of their
other endpoints. In the steady state there is one announcement each way in 3 s a client, and nothing
between clients.

A server that is wired to the access point costs each message one hop. On a robot, each
message costs two, but for those of its own host; the server is on a host of the first group.
Two servers know nothing of each other: each is told everything, and passes on everything.
"""

from dataclasses import replace

from discostorm.messages import AWAY, HOPS, Message
from discostorm.protocols.as_built import as_built

DISCOVERY_SERVER = as_built("Fast DDS Discovery Server", "mitigations")
TWO_DISCOVERY_SERVERS = as_built("Fast DDS Discovery Server, two", "mitigations")


def _on_a_robot(message: Message) -> Message:
    """Return a row of a wired server as it is if the server is on one of the robots."""
    if message.hops == HOPS:
        return message
    return replace(message, unit=AWAY[message.unit], hops=HOPS)


DISCOVERY_SERVER_ON_A_ROBOT = replace(
    DISCOVERY_SERVER,
    name="Fast DDS Discovery Server, on a robot",
    messages=tuple(map(_on_a_robot, DISCOVERY_SERVER.messages)),
)
