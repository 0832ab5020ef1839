"""Quantities of the paper's model: what a swarm sends, the airtime it takes, how many fit.

A ``swarm`` is hosts, processes and endpoints; ``in_all`` are the endpoints of all processes of a
host. A ``name`` means messages: a phase, a cast, one message (``SEDP_message``), control, or all.
"""

import math
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

_CONTROL = {"Heartbeat", "ACKNACK", "KeepAlive"}
#: What the paper calls periodic, with the answers to it.
_PERIODIC = {"DDS": ["SPDP"], "Zenoh": ["Scouting", "KeepAlive_message"]}


def _chosen(protocol: Protocol, *names: str) -> list[Message]:
    """Return the messages that some names mean."""
    names_of = {
        message: {"all", message.phase, message.cast, f"{message.name}_message"}
        | ({"control"} if message.name in _CONTROL else set())
        for message in protocol.messages
    }
    choices = set().union(*names_of.values())
    if unknown := set(names) - choices:
        raise ValueError(
            f"name must be one of {', '.join(sorted(choices))} for {protocol.name}; "
            f"got {min(unknown)!r}"
        )
    return [message for message, own in names_of.items() if own & set(names)]


def load(protocol: Protocol, *names: str) -> sp.Expr:
    """Return the messages of all hosts that the names mean."""
    return sp.factor(sp.Add(*(message.load() for message in _chosen(protocol, *names))))


def host_load(protocol: Protocol, *names: str) -> sp.Expr:
    """Return the messages of one host that the names mean."""
    return sp.factor(load(protocol, *names) / nt.N_H)


def host_load_degree(protocol: Protocol, variable: str, *names: str) -> int:
    """Return the degree of the messages of one host in one of N_H, N_P, N_E."""
    return int(sp.degree(host_load(protocol, *names), nt.NOTATION[variable].symbol))


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


def airtime(protocol: Protocol, name: str, *swarm: float) -> float:
    """Return the airtime of the messages that a name means [s]."""
    chosen = {message.name for message in _chosen(protocol, name)}
    return math.fsum(
        row["uplink_s"] + row["downlink_s"]
        for row in message_costs(protocol, Fleet.swarm(*swarm))
        if row["message"] in chosen
    )


def share(protocol: Protocol, name: str, *swarm: float) -> float:
    """Return the share of all airtime that the messages take that a name means."""
    return airtime(protocol, name, *swarm) / float(utilization(protocol, Fleet.swarm(*swarm)))


def share_of_phase(protocol: Protocol, name: str, phase: str, *swarm: float) -> float:
    """Return the share of a phase's airtime that a message takes."""
    return airtime(protocol, name, *swarm) / airtime(protocol, phase, *swarm)


def overhead_share(protocol: Protocol, *swarm: float) -> float:
    """Return the share of the airtime that is fixed overhead, not bits."""
    unicast, multicast = (replace(link, overhead=0.0) for link in (PAPER.unicast, PAPER.multicast))
    bits = replace(PAPER, unicast=unicast, multicast=multicast)
    return float(
        1
        - utilization(protocol, Fleet.swarm(*swarm), wifi=bits)
        / utilization(protocol, Fleet.swarm(*swarm))
    )


def largest_swarm(protocol: Protocol, processes: float, endpoints: float) -> int:
    """Return the largest whole number of hosts that stays below 100%."""
    return int(sp.ceiling(saturation_hosts(protocol, processes, endpoints))) - 1


def gap(*swarm: float) -> float:
    """Return how much less airtime Zenoh takes than DDS, relative to DDS."""
    return float(
        1 - utilization(ZENOH, Fleet.swarm(*swarm)) / utilization(DDS, Fleet.swarm(*swarm))
    )


def gap_of_phases(*swarm: float) -> float:
    """Return how much less airtime Declaration takes than SEDP, relative to SEDP."""
    return 1 - airtime(ZENOH, "Declaration", *swarm) / airtime(DDS, "SEDP", *swarm)


def gap_limit() -> float:
    """Return the gap between DDS and Zenoh in the limit of many endpoints."""
    # Both are linear in N_E, so the ratio of the slopes is what remains.
    ratio = sp.cancel(ZENOH.utilization().diff(nt.N_E) / DDS.utilization().diff(nt.N_E))
    return 1 - float(ratio.subs({**DDS.values(), **ZENOH.values(), **PAPER.values()}))


def gap_from_control(*swarm: float) -> float:
    """Return the part of the gap between SEDP and Declaration that control messages make."""
    of_endpoints = airtime(DDS, "SEDP_message", *swarm) - airtime(ZENOH, "Declare_message", *swarm)
    whole = airtime(DDS, "SEDP", *swarm) - airtime(ZENOH, "Declaration", *swarm)
    return 1 - of_endpoints / whole


def scouting_above_spdp(first: int, last: int, processes: float, endpoints: float) -> int:
    """Return for how many swarm sizes from first to last Scouting costs more than SPDP."""
    return sum(
        airtime(ZENOH, "Scouting", hosts, processes, endpoints)
        > airtime(DDS, "SPDP", hosts, processes, endpoints)
        for hosts in range(first, last + 1)
    )


def growth_exponent(protocol: Protocol, name: str, *from_to: float) -> float:
    """Return the power of hosts, or else of processes, by which an airtime grows.

    Hosts, processes and endpoints are given in pairs, before and after: 2, 12, 2, 2, 10, 10.
    """
    before, after = from_to[::2], from_to[1::2]
    ratio = airtime(protocol, name, *after) / airtime(protocol, name, *before)
    varied = 0 if before[0] != after[0] else 1
    return math.log(ratio) / math.log(after[varied] / before[varied])


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
    some, every = (
        airtime(protocol, each, hosts, processes, in_all / processes)
        - airtime(protocol, each, hosts, 1, in_all)
        for each in (name, "all")
    )
    return some / every


def hosts_gained(protocol: Protocol, processes: float, in_all: float) -> int:
    """Return how many more whole hosts fit when several processes become one."""
    split = largest_swarm(protocol, processes, in_all / processes)
    return largest_swarm(protocol, 1, in_all) - split


def kinds_over(transport: str, protocol: Protocol, name: str) -> int:
    """Return how many kinds of the messages that a name means go over a transport."""
    return sum(message.transport == transport for message in _chosen(protocol, name))


def header_slope(protocol: Protocol) -> float:
    """Return the sign of the change of U with the header bytes, for two hosts or more."""
    more = 1 + sp.Symbol("x", positive=True)
    slope = sp.factor(protocol.utilization().diff(nt.H_UDP).subs(nt.N_H, more))
    return float(sp.sign(slope))


def repeated_utilization(protocol: Protocol, *swarm: float) -> float:
    """Return the utilization by the messages that the paper calls periodic."""
    return sum(airtime(protocol, name, *swarm) for name in _PERIODIC[protocol.name])


def saturation_spread(protocol: Protocol, processes: float, endpoints: float) -> float:
    """Return by how many hosts the ranges of all parameters can move the saturation point."""
    low, high = saturation_bounds(protocol, processes, endpoints)
    return float(high - low)


def saturation_spread_by_payloads(protocol: Protocol, processes: float, endpoints: float) -> float:
    """Return by how many hosts Table II's ranges alone can move the saturation point."""
    values = {**protocol.values(), **PAPER.values()}
    others = parameter_ranges(protocol).keys() - {m.payload_symbol for m in protocol.messages}
    fixed = {symbol: (values[symbol], values[symbol]) for symbol in others}
    low, high = saturation_bounds(protocol, processes, endpoints, ranges=fixed)
    return float(high - low)
