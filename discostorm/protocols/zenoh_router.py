"""What Zenoh sends with routers, as measured and as its source says, all as rmw_zenoh sets them.

With one router, wired to the access point, each process has one link, and a subscriber is told to
those alone who publish to it. Liveliness tokens, one for each node and endpoint, are told to
everybody: what goes down grows with pairs of processes, whatever names there are.

With a router on each host, all linked, processes of a host meet on its loopback, and what crosses
the air is counted by pairs of hosts; every declaration goes to every other router, whether it is of
use there or not. What the routers tell each other of their links grows as the fourth power of the
hosts: each of two ends of each link tells its neighbors, and each of these tells its own.
"""

from discostorm.protocols.as_built import as_built

ZENOH_ROUTER = as_built("Zenoh router", "mitigations")
ZENOH_ROUTER_PER_HOST = as_built("Zenoh router per host", "mitigations")
