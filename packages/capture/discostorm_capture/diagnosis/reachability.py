"""Which host receives announcements and unicast from which."""

from collections.abc import Collection
from dataclasses import dataclass

import numpy as np

from discostorm_capture._types import Array
from discostorm_capture.diagnosis.finding import LIMITS
from discostorm_capture.diagnosis.observations import HANDSHAKE, Observations
from discostorm_capture.diagnosis.pairs import DiscoveryScope, scouting_hosts, server_clients


@dataclass(frozen=True)
class Reachability:
    """Which host (row) receives messages from which (column)."""

    hosts: tuple[str, ...]
    #: Whether the capture would show messages from row to column.
    observable: Array
    #: Whether the row's host answered an announcement of the column's.
    multicast_ok: Array
    #: Whether the row's host confirmed a unicast message of the column's.
    unicast_ok: Array
    #: Whether the column's host sent the row's a unicast message that requires a confirmation.
    unicast_tried: Array

    @property
    def receives(self) -> Array:
        """Whether the row's host receives any message from the column's."""
        return np.asarray(self.multicast_ok | self.unicast_ok)


def reachability(
    obs: Observations, scope: DiscoveryScope, unobservable: Collection[tuple[str, str]]
) -> Reachability:
    """Return the reachability of a scope's hosts; pairs in `unobservable` do not count."""
    announced = obs.senders(obs.isin("kind", "SPDP") & obs["multicast"]) - server_clients(obs)
    hosts = obs.hosts_of(member for member in scope.members if member in announced)
    hosts = scouting_hosts(obs) if scope.protocol == "Zenoh" else hosts
    observable, *heard = np.zeros((4, len(hosts), len(hosts)), bool)
    # After its last goodbye, a host is not there.
    gone = obs["ends"] & obs.isin("kind", "SPDP", "Close")
    left = {host: obs.time[gone & obs.isin("sender", host)].max(initial=-np.inf) for host in hosts}
    for row, column in np.ndindex(observable.shape):
        # Both hosts must be present for long enough, and their unicast captured.
        pair = hosts[row], hosts[column]
        begin = max(obs.host_first_last[host][0] for host in pair)
        ends = [obs.host_first_last[host][1] for host in pair]
        waits = [
            LIMITS.max_pause * (left[host] < end) for host, end in zip(pair, ends, strict=True)
        ]
        stop = min(obs.end, *(end + wait for end, wait in zip(ends, waits, strict=True)))
        if row != column and pair not in unobservable and stop - begin >= LIMITS.timeout:
            observable[row, column] = obs.sees_unicast(*pair)
    reach = Reachability(hosts, observable, *heard)
    (_fill_rtps if scope.protocol == "RTPS" else _fill_zenoh)(obs, reach)
    return reach


def _set_cells(matrix: Array, rows: Array, columns: Array, mask: Array | bool = True) -> None:
    """Set the cells that a mask selects, where both indices are known."""
    mask = (rows >= 0) & (columns >= 0) & mask
    matrix[rows[mask], columns[mask]] = True


def _fill_rtps(obs: Observations, reach: Reachability) -> None:
    sender, receiver = (obs.indices_among(end, reach.hosts) for end in ("sender", "receiver"))
    index = {address: index for index, address in enumerate(reach.hosts)}
    # The last element is for messages that do not name a process.
    host = np.array([*(index.get(address, -1) for address in obs.process_host), -1])
    by, of = host[obs.sender_index], host[obs.receiver_index]
    _set_cells(reach.multicast_ok, by, of)
    # Unicast that names no receiver answers an announcement, which gave the address.
    plain = (obs.sender_index >= 0) & (obs.receiver_index < 0) & ~obs["multicast"]
    _set_cells(reach.multicast_ok, sender, receiver, plain)
    # Keys confirm unicast, too: each step of the handshake before them answers the previous one.
    confirms = obs.isin("submessage", "ACKNACK") & ((obs.seq > 1) | (obs["missing"] > 0))
    confirms |= obs.uses_keys
    _set_cells(reach.unicast_ok, by, of, confirms)
    # Skip handshakes, which may fail for other reasons, and empty Heartbeats, which get no answer.
    asks = obs.isin("submessage", "HEARTBEAT", "DATA") & ~obs.isin("kind", "SPDP", HANDSHAKE)
    asks &= obs["user"] == 0  # a best-effort reader answers nothing
    _set_cells(reach.unicast_tried, receiver, sender, asks & ~obs["multicast"] & (obs.seq > 0))
    # Expect no confirmations between hosts with and without DDS Security.
    secured_hosts = obs.hosts_of(obs.secured_processes)
    secured = np.array([address in secured_hosts for address in reach.hosts], bool)
    reach.unicast_tried[secured[:, None] != secured] = False


def zenoh_replies(obs: Observations) -> Array:
    """Return which Zenoh messages show that their sender received something from their receiver."""
    first = obs.isin("submessage", "InitSyn") | obs.isin("kind", "Scout", "Hello", "Join")
    return np.asarray(obs.isin("protocol", "Zenoh") & ~obs["multicast"] & ~first)


def _fill_zenoh(obs: Observations, reach: Reachability) -> None:
    sender, receiver = (obs.indices_among(end, reach.hosts) for end in ("sender", "receiver"))
    hello = obs.isin("kind", "Hello") & ~obs["multicast"]
    _set_cells(reach.multicast_ok, sender, receiver, hello)
    _set_cells(reach.unicast_tried, receiver, sender, hello)
    _set_cells(reach.unicast_ok, sender, receiver, zenoh_replies(obs))
    answered = ("connection", "half", "refused")
    for kind, caller, called, *_ in obs.event_tuples(*answered, "unanswered", "exchange"):
        if {caller, called} <= {*reach.hosts}:
            one, other = reach.hosts.index(caller), reach.hosts.index(called)
            reach.unicast_ok[other, one] |= kind in answered
            reach.unicast_tried[other, one] |= kind in (*answered, "unanswered")
            # A connection that was open before the capture had been accepted, too.
            reach.unicast_ok[one, other] |= kind in ("connection", "exchange")
