"""Quantities from other evidence: sources, an enumeration, simulations and measurements."""

from collections import Counter
from collections.abc import Callable, Iterator
from itertools import product as combinations
from statistics import mean, median
from typing import Any

import numpy as np

from discostorm.data import read_data
from discostorm.fleet import Fleet, HostGroup
from discostorm.messages import Protocol
from discostorm.model import message_costs, utilization
from discostorm.protocols import MEASURED, PROTOCOLS
from discostorm.protocols.defaults import defaults
from discostorm.saturation import saturation_hosts
from discostorm.wifi import PAPER, Wifi
from discostorm_book import enumeration, lab_counts
from discostorm_book.assumption_ladder import TABLES
from discostorm_book.enumeration import SentMessage
from discostorm_book.lab_counts import failure_times
from discostorm_book.sweeps import sweep_channel

#: Efforts of remedies that need neither new programs nor other software.
_CONFIGURATION = {"setting", "file"}


def payloads_measured(protocol: Protocol) -> float:
    """Return the share of messages whose median payload in a product is in the paper's range."""
    products = [n for n in MEASURED if n in PROTOCOLS and PROTOCOLS[n].family == protocol.name]
    right = [
        any(
            each.payload.low <= median(sizes) <= each.payload.high
            for product in products
            if (sizes := lab_counts.mean_payloads(product, each.name))
        )
        for each in protocol.messages
    ]
    return sum(right) / len(right)


def startup_airtime_ratio(configuration: str, hosts: float, processes: float) -> float:
    """Return the startup airtime of a configuration relative to the product as shipped."""
    rows = read_data("vendors/configuration_risks.csv", "discostorm_book")
    (instead_of,) = (row["instead_of"] for row in rows if row["protocol"] == configuration)
    ratios = []
    for matching in (0.0, 1.0):
        fleet = Fleet((HostGroup(hosts, processes, 10),), matching)
        with_it, without = (
            sum(costs["uplink_s"] + costs["downlink_s"] for costs in message_costs(table, fleet))
            for table in (PROTOCOLS[configuration], PROTOCOLS[instead_of])
        )
        ratios.append(float(with_it) / float(without))
    return max(ratios)


def _stored_sweep_rows(table: str, **wanted: str | float) -> list[dict[str, str]]:
    """Return the rows of a stored sweep with these values; raise an error if there are none."""
    cells = {key: each if isinstance(each, str) else f"{each:g}" for key, each in wanted.items()}
    every = read_data(f"simulated/{table}.csv", "discostorm_book")
    rows = [row for row in every if cells.items() <= row.items()]
    if not rows:
        raise ValueError(f"simulated/{table}.csv has no row with {cells}")
    return rows


def _simulated_burst(
    protocol: Protocol, hosts: float, mpdus: float
) -> tuple[dict[str, str], Fleet]:
    """Return the row of a simulated burst without limits of the queues, and its fleet."""
    (row,) = _stored_sweep_rows("drain", protocol=protocol.name, hosts=hosts, mpdus=mpdus)
    return row, Fleet.swarm(*(float(row[name]) for name in ("hosts", "processes", "endpoints")))


def burst_excess(protocol: Protocol, hosts: float, mpdus: float) -> float:
    """Return by which share a simulated burst on 802.11n exceeds the airtime of the formula."""
    return burst_over_model(protocol, hosts, mpdus, sweep_channel(int(mpdus))) - 1


def drained_over_saturation(protocol: Protocol, mpdus: float) -> float:
    """Return the largest fleet that drains within a second, relative to the saturation point."""
    robot = {"processes": 2, "endpoints": 10}
    rows = _stored_sweep_rows("drain", protocol=protocol.name, **robot, mpdus=mpdus)
    hosts = max(int(row["hosts"]) for row in rows if float(row["drain_time_s"]) <= 1)
    return hosts / float(saturation_hosts(protocol, 2, 10))


def multicast_lost(protocol: Protocol, hosts: float) -> float:
    """Return the share of multicast receptions that a simulated burst loses to collisions."""
    row, fleet = _simulated_burst(protocol, hosts, 1)
    receptions = {"multicast": 0.0, "unicast": 0.0}
    for message in protocol.messages:
        receivers = hosts - 1 if message.cast == "multicast" else 1
        receptions[message.cast] += float(message.load(fleet)) * receivers
    return float(row["on_air"]) * sum(receptions.values()) / receptions["multicast"]


def burst_over_model(protocol: Protocol, hosts: float, mpdus: float, wifi: Wifi = PAPER) -> float:
    """Return the duration of a simulated burst relative to U, on the paper's channel."""
    row, fleet = _simulated_burst(protocol, hosts, mpdus)
    return float(row["drain_time_s"]) / float(utilization(protocol, fleet, wifi=wifi))


def gained_by_delays(protocol: Protocol, mpdus: float) -> int:
    """Return the robots that random delays add for sure, with a lease and limited queues."""
    limit = PROTOCOLS[TABLES[protocol.name][1]].lease
    (late,), (at_once,) = (
        _stored_sweep_rows("ladder", protocol=protocol.name, step=step, mpdus=mpdus, limit_s=limit)
        for step in ("staggered", "queues")
    )
    return int(late["hosts_low"]) - int(at_once["hosts_high"])


def enumerated_down_for_up(protocol: Protocol, phase: str, *swarm: int) -> float:
    """Return the enumerated downlink messages of a phase for each uplink message."""
    hops = Counter(sent.hop for sent in _sent(protocol, *swarm) if sent.phase == phase)
    return hops["down"] / hops["up"]


def enumeration_agrees(protocol: Protocol, *largest: int) -> float:
    """Return the share of swarms, up to the largest, in which enumeration and formula agree."""
    hosts, processes, endpoints = largest
    swarms = combinations(range(1, hosts + 1), range(1, processes + 1), range(endpoints + 1))
    agree = [
        sum(sent.hop == "up" for sent in _sent(protocol, *swarm))
        == sum(float(message.load(Fleet.swarm(*swarm))) for message in protocol.messages)
        for swarm in swarms
    ]
    return sum(agree) / len(agree)


def enumerated_spread(protocol: Protocol, kind: str, *largest: int) -> float:
    """Return the ratio of the most to the fewest messages of a kind that host 1 sends."""
    hosts, processes, endpoints = largest
    each = [
        sum(
            (sent.sender.host, sent.kind, sent.hop) == (1, kind, "up")
            for sent in _sent(protocol, n_hosts, processes, n_endpoints)
        )
        for n_hosts, n_endpoints in combinations(range(2, hosts + 1), range(endpoints + 1))
    ]
    return max(each) / min(each)


def enumeration_ratio(protocol: Protocol, *swarm: int) -> float:
    """Return the airtime of all enumerated messages, one by one, relative to U."""
    each = {
        (row["message"], hop): row[f"{hop}link_s"] / row["uplink_messages"]
        for row in message_costs(protocol, Fleet.swarm(*swarm))
        for hop in ("up", "down")
    }
    one_by_one = sum(each[sent.kind, sent.hop] for sent in _sent(protocol, *swarm))
    return float(one_by_one / utilization(protocol, Fleet.swarm(*swarm)))


def _sent(protocol: Protocol, hosts: int, processes: int, endpoints: int) -> Iterator[SentMessage]:
    return enumeration.enumerate_messages(protocol.name, [[endpoints] * processes] * hosts)


#: Quantities of one expression each; ``data/paper/quantities.csv`` has words for them.
FORMULAS: dict[str, Callable[..., Any]] = {
    # "Zenoh" is the name of one of the paper's protocols, too.
    "default": lambda product, name: defaults(str(getattr(product, "name", product)))[name],
    "remedies_by_configuration": lambda: mean(
        row["effort"] in _CONFIGURATION
        for row in read_data("vendors/remedies.csv")
        if row["effort"]
    ),
    "runs_found": lambda configuration, event: float(
        np.isfinite(failure_times(configuration, event, "newcomer", "newcomer", "found")).mean()
    ),
    "runs_undisturbed": lambda configuration, event, who: float(
        (failure_times(configuration, event, "death", who, "settled") == 0).mean()
    ),
    # The smallest saving in fleets of ``first`` to ``last`` hosts.
    "least_saved": lambda configuration, first, last, processes: (
        1 - max(startup_airtime_ratio(configuration, n, processes) for n in range(first, last + 1))
    ),
    "burst_saved": lambda *burst: -burst_excess(*burst),
    "collided": lambda *burst: float(_simulated_burst(*burst)[0]["collided"]),
    # The same for hosts at different distances, by the receivers that are in range.
    "multicast_lost_on_a_disc": lambda protocol, hosts, receivers: float(
        _stored_sweep_rows(
            "heard", protocol=protocol.name, hosts=hosts, mpdus=1, queue_frames=0, heard=receivers
        )[0]["multicast_lost"]
    ),
    # The least of the paper's counts with the timers of products; no frame errors.
    "runs_converged": lambda hosts: min(
        int(row["converged"]) / int(row["runs"])
        for row in _stored_sweep_rows("convergence", hosts=hosts, loss="0.0")
        if "periods" in row["protocol"]
    ),
}
