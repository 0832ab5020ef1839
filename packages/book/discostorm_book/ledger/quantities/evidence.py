"""Quantities found beside the model: read in sources, counted, simulated and measured."""

from collections import Counter
from collections.abc import Iterator
from itertools import product as combinations
from statistics import median

import numpy as np

from discostorm.data import read_data
from discostorm.fleet import Fleet, HostGroup
from discostorm.messages import Protocol
from discostorm.model import message_costs, utilization
from discostorm.protocols import MEASURED, PROTOCOLS
from discostorm.protocols.defaults import defaults
from discostorm.saturation import saturation_hosts
from discostorm.wifi import Radio
from discostorm_book import enumeration, lab_counts

#: Efforts of remedies that need neither new programs nor other software.
_CONFIGURATION = {"setting", "file"}


def default(product: str, quantity: str) -> float:
    """Return a product's default."""
    return defaults(product)[quantity]


def payloads_measured(protocol: Protocol) -> float:
    """Return which part of the messages had, in captures, a payload in the paper's range.

    Of the products that speak the protocol, at least one; its median of all points of the lab.
    """
    within = set()
    for name, table in PROTOCOLS.items():
        if name in MEASURED and table.messages[0].kind == protocol.messages[0].name:
            for message in protocol.messages:
                sizes = lab_counts.payloads(name, message.name)
                if sizes and message.payload.low <= median(sizes) <= message.payload.high:
                    within.add(message.name)
    return len(within) / len(protocol.messages)


def start_saved(configuration: str, hosts: float) -> float:
    """Return which part of the start's airtime an configuration saves, with any names the least.

    Of that of the product without it, as both tables were measured, on the paper's channel: for
    so many hosts of 2 processes with 10 endpoints, which match nobody or all.
    """
    rows = read_data("vendors/configuration_risks.csv", "discostorm_book")
    (instead_of,) = (row["instead_of"] for row in rows if row["protocol"] == configuration)
    saved = []
    for matching in (0.0, 1.0):
        fleet = Fleet((HostGroup(hosts, 2, 10),), matching)
        with_it, without = (
            sum(costs["uplink_s"] + costs["downlink_s"] for costs in message_costs(table, fleet))
            for table in (PROTOCOLS[configuration], PROTOCOLS[instead_of])
        )
        saved.append(1 - float(with_it) / float(without))
    return min(saved)


def remedies_by_configuration() -> float:
    """Return which part of the planner's remedies is a setting or a file of configuration."""
    efforts = [row["effort"] for row in read_data("vendors/remedies.csv") if row["effort"]]
    return sum(effort in _CONFIGURATION for effort in efforts) / len(efforts)


def runs_found(configuration: str, event: str) -> float:
    """Return the part of the runs in which a newcomer found the living before the dead was back."""
    times = lab_counts.death_times(configuration, event, "newcomer", "newcomer", "found")
    return float(np.isfinite(times).mean())


def runs_undisturbed(configuration: str, event: str, who: str) -> float:
    """Return the part of the runs in which these lost no match and heard each other all along."""
    times = lab_counts.death_times(configuration, event, "death", who, "settled")
    return float((times == 0).mean())


def _simulated(table: str, **wanted: str | float) -> list[dict[str, str]]:
    """Return the rows of a sweep of ``data/simulated`` with these values, at least one."""
    named = {
        name: value if isinstance(value, str) else f"{value:g}" for name, value in wanted.items()
    }
    rows = [
        row
        for row in read_data(f"simulated/{table}.csv", "discostorm_book")
        if named.items() <= row.items()
    ]
    if not rows:
        raise ValueError(f"simulated/{table}.csv has no row with {named}")
    return rows


def burst_excess(protocol: Protocol, hosts: float, mpdus: float) -> float:
    """Return how much longer a simulated burst takes than the closed form's airtime.

    Without limits of the queues; the paper's small robots, on 802.11n as its channel has it.
    """
    (row,) = _simulated("drain", protocol=protocol.name, hosts=hosts, mpdus=mpdus)
    wifi = Radio("802.11n", streams=2, aifsn=3, mpdus=int(mpdus)).wifi()
    counts = {name: float(row[name]) for name in ("hosts", "processes", "endpoints")}
    closed = utilization(protocol, Fleet.swarm(**counts), wifi=wifi)
    return float(row["drain_time_s"]) / float(closed) - 1


def burst_over_model(protocol: Protocol, hosts: float, mpdus: float) -> float:
    """Return how long a simulated burst takes, relative to the paper's U."""
    (row,) = _simulated("drain", protocol=protocol.name, hosts=hosts, mpdus=mpdus)
    counts = {name: float(row[name]) for name in ("hosts", "processes", "endpoints")}
    return float(row["drain_time_s"]) / float(utilization(protocol, Fleet.swarm(**counts)))


def collided(protocol: Protocol, hosts: float, mpdus: float) -> float:
    """Return which part of the transmissions of a simulated burst collides."""
    (row,) = _simulated("drain", protocol=protocol.name, hosts=hosts, mpdus=mpdus)
    return float(row["collided"])


def drained_over_saturation(protocol: Protocol, mpdus: float) -> float:
    """Return the most hosts whose simulated burst is over in a second, relative to saturation."""
    rows = _simulated("drain", protocol=protocol.name, processes=2, endpoints=10, mpdus=mpdus)
    most = max(int(row["hosts"]) for row in rows if float(row["drain_time_s"]) <= 1)
    return most / float(saturation_hosts(protocol, 2, 10))


def multicast_lost(protocol: Protocol, hosts: float) -> float:
    """Return which part of the receptions of multicast a simulated burst loses to collisions."""
    (row,) = _simulated("drain", protocol=protocol.name, hosts=hosts, mpdus=1)
    fleet = Fleet.swarm(*(float(row[name]) for name in ("hosts", "processes", "endpoints")))
    receptions = {True: 0.0, False: 0.0}
    for message in protocol.messages:
        multicast = message.cast == "multicast"
        receptions[multicast] += float(message.load(fleet)) * (hosts - 1 if multicast else 1)
    return float(row["on_air"]) * sum(receptions.values()) / receptions[True]


def multicast_lost_on_a_disc(protocol: Protocol, hosts: float, receivers: str) -> float:
    """Return the same part of hosts at unlike distances, by whose receivers hear them."""
    (row,) = _simulated(
        "heard", protocol=protocol.name, hosts=hosts, mpdus=1, queue_frames=0, heard=receivers
    )
    return float(row["multicast_lost"])


def runs_converged(hosts: float) -> float:
    """Return the part of the simulated runs in which everybody knew everybody in two minutes.

    The least of the paper's counts with the periods of products; no frame errors.
    """
    rows = _simulated("convergence", hosts=hosts, loss="0.0")
    return min(
        int(row["converged"]) / int(row["runs"]) for row in rows if "periods" in row["protocol"]
    )


def enumerated_down_for_up(
    protocol: Protocol, phase: str, hosts: float, processes: float, endpoints: float
) -> float:
    """Return how many messages of a phase go down for each that goes up, by enumeration."""
    hops = Counter(
        sent.hop for sent in _walk(protocol, hosts, processes, endpoints) if sent.phase == phase
    )
    return hops["down"] / hops["up"]


def enumeration_agrees(
    protocol: Protocol, hosts: float, processes: float, endpoints: float
) -> float:
    """Return in which part of all swarms up to this one the enumeration counts the load."""
    swarms = list(combinations(_upto(1, hosts), _upto(1, processes), _upto(0, endpoints)))
    agree = [
        sum(sent.hop == "up" for sent in _walk(protocol, *swarm))
        == sum(float(message.load(Fleet.swarm(*swarm))) for message in protocol.messages)
        for swarm in swarms
    ]
    return sum(agree) / len(agree)


def enumerated_spread(
    protocol: Protocol, kind: str, hosts: float, processes: float, endpoints: float
) -> float:
    """Return how many times the least of a host's messages the most is, by enumeration.

    Over the swarms of 2 to so many hosts and of 0 to so many endpoints, with so many processes.
    """
    each = [
        sum(
            (sent.sender.host, sent.kind, sent.hop) == (1, kind, "up")
            for sent in _walk(protocol, many, processes, each_has)
        )
        for many, each_has in combinations(_upto(2, hosts), _upto(0, endpoints))
    ]
    return max(each) / min(each)


def _upto(first: int, last: float) -> range:
    return range(first, int(last) + 1)


def enumeration_ratio(
    protocol: Protocol, hosts: float, processes: float, endpoints: float
) -> float:
    """Return the airtime of all enumerated messages, one by one, relative to U."""
    each = {
        (row["message"], hop): row[f"{hop}link_s"] / row["uplink_messages"]
        for row in message_costs(protocol, Fleet.swarm(hosts, processes, endpoints))
        for hop in ("up", "down")
    }
    at = (hosts, processes, endpoints)
    one_by_one = sum(each[sent.kind, sent.hop] for sent in _walk(protocol, *at))
    return float(one_by_one / utilization(protocol, *at))


def _walk(
    protocol: Protocol, hosts: float, processes: float, endpoints: float
) -> Iterator[enumeration.Sent]:
    return enumeration.walk(protocol.name, [[int(endpoints)] * int(processes)] * int(hosts))
