"""What products really send, as measured and as their source says.

`data/vendors/as_built.csv` says of each message what it is sent for and when, and where that
stands in the source; `data/measured/as_built.csv` how many, and how large, where only measuring
tells. `lab/measure/fit_models.py` writes it. What they send when arranged otherwise than shipped,
against the storm, is in files of the same columns, `mitigations.csv`. Which tables there are, and
whose they are, say `products.csv` and `configurations.csv`: a row there and its messages are all
that another product takes.

Discovery Server of Fast DDS
----------------------------
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

Static endpoints of Fast DDS
----------------------------
Static endpoint discovery (an XML file that every process has) does away with SEDP, its Heartbeats
and ACKNACKs. Participants announce themselves as ever, and each announcement lists the endpoints
that its process has: 8 unicasts a pair in 24 s stay, and grow longer with each endpoint.
Each endpoint that is made is announced to all at once, so that a start is quadratic in endpoints:
processes with many of them pay more for their lists than for SEDP. It filters nothing: names that
match nobody cost the same.

Measured with 2 to 84 endpoints a process. Two things are less sure than the rest: how many of the
announcements of new endpoints go to each other process as well, none to all of them within the runs
of one point, as that is whether it was known before; and an announcement that no longer fits into
one frame, from some 17 endpoints on, counts as one, so that the airtime of the others' headers is
left out. Fast DDS 2.9.1 crashes unless it holds a lock (`lab/programs/fast_dds.cpp`).

Cyclone DDS with other settings
-------------------------------
With a list of peers and no multicast, each process announces itself to each peer on as many ports
as `MaxAutoParticipantIndex` says, 9 by default, as it cannot know which of them are in use; and
hosts answer what comes to one that is not. With multicast for SEDP, Cyclone's choice on wires,
endpoints and what repeats are told once to all, over Wi-Fi at the rate of multicast.

Routers of Zenoh
----------------
All as rmw_zenoh sets them. With one router, wired to the access point, each process has one link,
and a subscriber is told to those alone who publish to it. Liveliness tokens, one for each node and
endpoint, are told to everybody: what goes down grows with pairs of processes, whatever names there
are.

With a router on each host, all linked, processes of a host meet on its loopback, and what crosses
the air is counted by pairs of hosts; every declaration goes to every other router, whether it is of
use there or not. What the routers tell each other of their links grows as the fourth power of the
hosts: each of two ends of each link tells its neighbors, and each of these tells its own. But it
waits for each other and is written into the stream together. So segments that are full grow as
the fourth power, at 31 of these messages each, and those that are not as the third: what a router
is told by each of two others.

In a star, where the router of each host is linked with one that is wired to the access point, that
one tells each of all others once. Messages grow with pairs of hosts, and frames with hosts and full
segments.
"""

from collections.abc import Mapping
from dataclasses import replace
from typing import Any, cast as typed

import numpy as np

from discostorm.data import read_data
from discostorm.messages import (
    AWAY,
    HOPS,
    UNITS,
    Basis,
    Family,
    Hop,
    Message,
    Payload,
    Protocol,
    Role,
    Schedule,
    Transport,
)
from discostorm.protocols.defaults import defaults, timers
from discostorm.wifi import Cast

#: The files that say which tables there are, and by the basis of a table that of its messages.
KNOWN = ("products", "configurations")
ROWS = {"measured": "as_built", "mitigated": "mitigations"}
#: Of a row that is not fitted yet.
_NOTHING = {"per_unit": "0"}

#: What is counted where the server is on a robot: its own host reaches it without the air.


def schedule(row: Mapping[str, str]) -> Schedule:
    """Return when a message of the table is sent."""
    starts = tuple(float(time) for time in row["starts_s"].split())
    return Schedule(starts, float(row["period_s"] or np.inf))


def described() -> dict[str, dict[str, str]]:
    """Return what the files say of each table, by its name."""
    return {row["protocol"]: row for name in KNOWN for row in read_data(f"vendors/{name}.csv")}


def as_built(name: str) -> Protocol:
    """Return the table of a name in ``data/vendors/products.csv`` or ``configurations.csv``.

    A row of which nothing was measured is left out.
    """
    told = described()[name]
    if told.get("on_robot_of"):
        wired = as_built(told["on_robot_of"])
        return replace(
            wired,
            name=name,
            messages=tuple(map(_on_a_robot, wired.messages)),
            captured=_captured(told),
        )
    file = ROWS[told["basis"]]
    measured = {
        row["message"]: row for row in read_data(f"measured/{file}.csv") if row["protocol"] == name
    }
    rows = {
        row["message"]: row | measured[row["message"]]
        for row in read_data(f"vendors/{file}.csv")
        if row["protocol"] == name and float(measured.get(row["message"], _NOTHING)["per_unit"])
    }
    return Protocol(
        name,
        tuple(_message(row, rows, file) for row in rows.values()),
        lease=defaults(told["defaults"])["lease"],
        wired=as_built(told["wired"]) if told["wired"] else None,
        family=typed(Family, told["family"]),
        product=told["defaults"],
        basis=typed(Basis, told["basis"]),
        timers=timers(told["defaults"]),
        captured=_captured(told),
    )


def _captured(told: Mapping[str, str]) -> tuple[int, int, int]:
    """Return the most hosts, processes of all and endpoints of one that was measured [1]."""
    return int(told["max_hosts"]), int(told["max_processes"]), int(told["max_endpoints"])


def _on_a_robot(message: Message) -> Message:
    """Return a row of a wired server as it is if the server is on one of the robots."""
    if message.hops == HOPS:
        return message
    return replace(message, unit=AWAY[message.unit], hops=HOPS)


def hops(row: Mapping[str, str]) -> tuple[Hop, ...]:
    """Return the hops of a message of the table: both, but where one end is wired."""
    return tuple(hop for hop in HOPS if row.get("hops") in ("", None, hop))


def _message(row: dict[str, str], known: Mapping[str, Any], file: str) -> Message:
    source = f"{row['source']}; size: measured (discostorm/data/measured/{file}.csv)"
    nominal, low, high = (float(row[column]) for column in ("payload_B", "low_B", "high_B"))
    return Message(
        row["message"],
        row["phase"],
        typed(Cast, row["cast"]),
        typed(Transport, row["transport"]),
        Payload(nominal, low, high, source),
        UNITS[row["unit"]],
        float(row["per_unit"]),
        schedule(row),
        hops(row),
        answers=row["answers"] if row["answers"] in known else None,
        frames=float(row["frames"]),
        kind=row["kind"],
        role=typed(Role, row["role"]),
        informs=row["informs"] == "yes",
        inside=row.get("inside") or None,
    )
