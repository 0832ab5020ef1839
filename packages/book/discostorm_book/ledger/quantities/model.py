"""Quantities of the paper's model: what a swarm sends, the airtime it takes, how many fit."""

import math
from collections.abc import Iterable
from dataclasses import replace

import sympy as sp

from discostorm import notation as nt
from discostorm.fleet import Fleet
from discostorm.messages import Message, Protocol
from discostorm.model import message_costs, utilization
from discostorm.protocols import DDS, ZENOH
from discostorm.saturation import saturation_hosts
from discostorm.uncertainty import parameter_ranges, saturation_bounds
from discostorm.wifi import PAPER

_CONTROL = {"DDS": ("Heartbeat_message", "ACKNACK_message"), "Zenoh": ("KeepAlive_message",)}
_MORE_HOSTS = sp.Symbol("x", positive=True)


def _chosen(protocol: Protocol, names: Iterable[str]) -> list[Message]:
    """Return the messages meant by phases, casts, messages (``SEDP_message``), or all."""
    called = {
        message: {"all", message.phase, message.cast, message.name + "_message"}
        for message in protocol.messages
    }
    for message, own in called.items():
        if message.name + "_message" in _CONTROL[protocol.name]:
            own.add("control")
    known = set().union(*called.values())
    if unknown := set(names) - known:
        raise ValueError(
            f"name must be one of {', '.join(sorted(known))} for {protocol.name}; "
            f"got {min(unknown)!r}"
        )
    return [message for message, own in called.items() if own & set(names)]


def load(protocol: Protocol, *names: str) -> sp.Expr:
    """Return the messages of all hosts that the names mean."""
    return sp.factor(sp.Add(*(message.load() for message in _chosen(protocol, names))))


def host_load(protocol: Protocol, *names: str) -> sp.Expr:
    """Return the messages of one host, of the phases or messages named."""
    return sp.factor(load(protocol, *names) / nt.N_H)


def host_load_degree(protocol: Protocol, variable: str, *names: str) -> int:
    """Return the degree of the messages of one host in one of N_H, N_P, N_E."""
    return int(sp.degree(host_load(protocol, *names), nt.NOTATION[variable].symbol))


def load_difference(one: Protocol, name: str, other: Protocol, other_name: str) -> sp.Expr:
    """Return how many more messages one protocol sends than another."""
    return sp.simplify(load(one, name) - load(other, other_name))


def control_saved() -> sp.Expr:
    """Return the part of DDS's control messages that Zenoh does without."""
    return 1 - sp.simplify(load(ZENOH, "control") / load(DDS, "control"))


def growth_factor(protocol: Protocol) -> sp.Expr:
    """Return what one more host multiplies U by, in the limit of many hosts."""
    # Of two polynomials of the same degree, the leading coefficients are what remains.
    u = sp.Poly(protocol.utilization(), nt.N_H)
    return sp.cancel(u.shift(1).LC() / u.LC())


def messages_per_link(protocol: Protocol, *names: str) -> sp.Expr:
    """Return the messages for each pair of processes, both directions taken together."""
    links = nt.N_H * (nt.N_H - 1) * nt.N_P**2 / 2
    return sp.simplify(load(protocol, *names) / links)


def messages_per_direction(protocol: Protocol, *names: str) -> sp.Expr:
    """Return the messages that one process sends to one other."""
    return messages_per_link(protocol, *names) / 2


def airtime(
    protocol: Protocol, name: str, hosts: float, processes: float, endpoints: float
) -> float:
    """Return the airtime of the messages that a name means [s]."""
    meant = {message.name for message in _chosen(protocol, [name])}
    return math.fsum(
        row["uplink_s"] + row["downlink_s"]
        for row in message_costs(protocol, Fleet.swarm(hosts, processes, endpoints))
        if row["message"] in meant
    )


def share(protocol: Protocol, name: str, hosts: float, processes: float, endpoints: float) -> float:
    """Return the share of all airtime that the messages take that a name means."""
    at = (hosts, processes, endpoints)
    return airtime(protocol, name, *at) / float(utilization(protocol, *at))


def share_of_phase(
    protocol: Protocol, name: str, phase: str, hosts: float, processes: float, endpoints: float
) -> float:
    """Return the share of a phase's airtime that a message takes."""
    at = (hosts, processes, endpoints)
    return airtime(protocol, name, *at) / airtime(protocol, phase, *at)


def control_share(protocol: Protocol, hosts: float, processes: float, endpoints: float) -> float:
    """Return the share of all airtime that the control messages take."""
    return share(protocol, "control", hosts, processes, endpoints)


def overhead_share(protocol: Protocol, hosts: float, processes: float, endpoints: float) -> float:
    """Return the share of the airtime that is fixed overhead, not bits."""
    bits = replace(
        PAPER,
        unicast=replace(PAPER.unicast, overhead=0.0),
        multicast=replace(PAPER.multicast, overhead=0.0),
    )
    at = (hosts, processes, endpoints)
    return float(1 - utilization(protocol, *at, wifi=bits) / utilization(protocol, *at))


def largest_swarm(protocol: Protocol, processes: float, endpoints: float) -> int:
    """Return the largest whole number of hosts that stays below 100%."""
    return int(sp.ceiling(saturation_hosts(protocol, processes, endpoints))) - 1


def gap(hosts: float, processes: float, endpoints: float) -> float:
    """Return how much less airtime Zenoh takes than DDS, relative to DDS."""
    zenoh = utilization(ZENOH, hosts, processes, endpoints)
    return float(1 - zenoh / utilization(DDS, hosts, processes, endpoints))


def gap_of_phases(hosts: float, processes: float, endpoints: float) -> float:
    """Return how much less airtime Declaration takes than SEDP, relative to SEDP."""
    at = (hosts, processes, endpoints)
    return 1 - airtime(ZENOH, "Declaration", *at) / airtime(DDS, "SEDP", *at)


def gap_limit() -> float:
    """Return the gap between DDS and Zenoh in the limit of many endpoints."""
    # Both are linear in N_E, so the ratio of the slopes is what remains.
    ratio = sp.cancel(ZENOH.utilization().diff(nt.N_E) / DDS.utilization().diff(nt.N_E))
    return 1 - float(ratio.subs({**DDS.values(), **ZENOH.values(), **PAPER.values()}))


def gap_from_control(hosts: float, processes: float, endpoints: float) -> float:
    """Return the part of the gap between SEDP and Declaration that control messages make."""
    at = (hosts, processes, endpoints)
    endpoint_part = airtime(DDS, "SEDP_message", *at) - airtime(ZENOH, "Declare_message", *at)
    whole = airtime(DDS, "SEDP", *at) - airtime(ZENOH, "Declaration", *at)
    return 1 - endpoint_part / whole


def scouting_above_spdp(first: float, last: float, processes: float, endpoints: float) -> int:
    """Return for how many swarm sizes from first to last Scouting costs more than SPDP."""
    return sum(
        airtime(ZENOH, "Scouting", hosts, processes, endpoints)
        > airtime(DDS, "SPDP", hosts, processes, endpoints)
        for hosts in range(int(first), int(last) + 1)
    )


def growth_exponent(
    protocol: Protocol,
    name: str,
    hosts: float,
    hosts_to: float,
    processes: float,
    processes_to: float,
    endpoints: float,
    endpoints_to: float,
) -> float:
    """Return the power of hosts, or else of processes, by which an airtime grows."""
    before = airtime(protocol, name, hosts, processes, endpoints)
    after = airtime(protocol, name, hosts_to, processes_to, endpoints_to)
    times = hosts_to / hosts if hosts_to != hosts else processes_to / processes
    return math.log(after / before) / math.log(times)


def split_ratio(protocol: Protocol, hosts: float, processes: float, in_all: float) -> float:
    """Return how many times the airtime of one process it takes to split it into several."""
    split = airtime(protocol, "all", hosts, processes, in_all / processes)
    return split / airtime(protocol, "all", hosts, 1, in_all)


def saved_by_composing(protocol: Protocol, hosts: float, processes: float, in_all: float) -> float:
    """Return the part of the airtime of several processes that one with all endpoints saves."""
    return 1 - 1 / split_ratio(protocol, hosts, processes, in_all)


def part_of_increase(
    protocol: Protocol, name: str, hosts: float, processes: float, in_all: float
) -> float:
    """Return what some messages add, of all that is added when a process is split."""

    def added(name: str) -> float:
        split = airtime(protocol, name, hosts, processes, in_all / processes)
        return split - airtime(protocol, name, hosts, 1, in_all)

    return added(name) / added("all")


def hosts_gained(protocol: Protocol, processes: float, in_all: float) -> int:
    """Return how many more whole hosts fit when several processes become one."""
    split = largest_swarm(protocol, processes, in_all / processes)
    return largest_swarm(protocol, 1, in_all) - split


def kinds_over(transport: str, protocol: Protocol, name: str) -> int:
    """Return how many kinds of the messages that a name means go over a transport."""
    return sum(message.transport == transport for message in _chosen(protocol, [name]))


def header_slope(protocol: Protocol) -> float:
    """Return the sign of the change of U with the header bytes: 1, 0 or -1."""
    slope = sp.factor(protocol.utilization().diff(nt.H_UDP).subs(nt.N_H, 1 + _MORE_HOSTS))
    return float(sp.sign(slope))


def repeated_utilization(
    protocol: Protocol, hosts: float, processes: float, endpoints: float
) -> float:
    """Return the utilization by the messages that the paper calls periodic."""
    # With the answers to what is periodic.
    periodic = {"DDS": ["SPDP"], "Zenoh": ["Scouting", "KeepAlive_message"]}
    return sum(
        airtime(protocol, name, hosts, processes, endpoints) for name in periodic[protocol.name]
    )


def saturation_spread(protocol: Protocol, processes: float, endpoints: float) -> float:
    """Return by how many hosts the ranges of all parameters can move the saturation point."""
    least, most = saturation_bounds(protocol, processes, endpoints)
    return float(most - least)


def saturation_spread_by_payloads(protocol: Protocol, processes: float, endpoints: float) -> float:
    """Return by how many hosts Table II's ranges alone can move the saturation point."""
    values = {**protocol.values(), **PAPER.values()}
    payloads = {message.payload_symbol for message in protocol.messages}
    fixed = {
        symbol: (values[symbol], values[symbol])
        for symbol in parameter_ranges(protocol)
        if symbol not in payloads
    }
    least, most = saturation_bounds(protocol, processes, endpoints, ranges=fixed)
    return float(most - least)
