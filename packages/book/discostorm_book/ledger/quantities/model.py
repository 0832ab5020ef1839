"""Quantities of the paper's model; ``in_all`` are the endpoints of all processes of a host."""

import math
from collections.abc import Callable, Iterable
from dataclasses import replace
from typing import Any

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
#: Messages that the paper calls periodic, with their answers.
_PERIODIC = {"DDS": ["SPDP"], "Zenoh": ["Scouting", "KeepAlive_message"]}


def _messages_named(protocol: Protocol, *names: str) -> list[Message]:
    """Return the messages of phases, casts, one message (``SEDP_message``), control, or all."""
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
    return sp.factor(sp.Add(*(message.load() for message in _messages_named(protocol, *names))))


def airtime(protocol: Protocol, name: str, *swarm: float) -> float:
    """Return the airtime of the messages that a name means [s]."""
    chosen = {message.name for message in _messages_named(protocol, name)}
    return math.fsum(
        row["uplink_s"] + row["downlink_s"]
        for row in message_costs(protocol, Fleet.swarm(*swarm))
        if row["message"] in chosen
    )


def overhead_share(protocol: Protocol, *swarm: float) -> float:
    """Return the share of the airtime that is fixed overhead, not bits."""
    unicast, multicast = (replace(link, overhead=0.0) for link in (PAPER.unicast, PAPER.multicast))
    bits = replace(PAPER, unicast=unicast, multicast=multicast)
    fleet = Fleet.swarm(*swarm)
    return float(1 - utilization(protocol, fleet, wifi=bits) / utilization(protocol, fleet))


def gap_from_control(*swarm: float) -> float:
    """Return the part of the gap between SEDP and Declaration that control messages make."""
    of_endpoints = airtime(DDS, "SEDP_message", *swarm) - airtime(ZENOH, "Declare_message", *swarm)
    whole = airtime(DDS, "SEDP", *swarm) - airtime(ZENOH, "Declaration", *swarm)
    return 1 - of_endpoints / whole


def growth_exponent(protocol: Protocol, name: str, *from_to: float) -> float:
    """Return the exponent of an airtime's growth with hosts or, if these are equal, processes."""
    before, after = from_to[::2], from_to[1::2]
    ratio = airtime(protocol, name, *after) / airtime(protocol, name, *before)
    varied = 0 if before[0] != after[0] else 1
    return math.log(ratio) / math.log(after[varied] / before[varied])


def split_ratio(protocol: Protocol, hosts: float, processes: float, in_all: float) -> float:
    """Return the airtime of several processes relative to one with all their endpoints."""
    split = airtime(protocol, "all", hosts, processes, in_all / processes)
    return split / airtime(protocol, "all", hosts, 1, in_all)


def part_of_increase(
    protocol: Protocol, name: str, hosts: float, processes: float, in_all: float
) -> float:
    """Return the share of some messages in the airtime that splitting a process adds."""
    some, every = (
        airtime(protocol, each, hosts, processes, in_all / processes)
        - airtime(protocol, each, hosts, 1, in_all)
        for each in (name, "all")
    )
    return some / every


def growth_factor(protocol: Protocol) -> sp.Expr:
    """Return the factor by which one more host multiplies U, in the limit of many hosts."""
    # In the limit, only the ratio of the leading coefficients of both polynomials remains.
    u = sp.Poly(protocol.utilization(), nt.N_H)
    return sp.cancel(u.shift(1).LC() / u.LC())


def gap_limit() -> float:
    """Return the share of DDS's utilization that Zenoh saves, in the limit of many endpoints."""
    # Both are linear in N_E, so in the limit only the ratio of the slopes remains.
    ratio = sp.cancel(ZENOH.utilization().diff(nt.N_E) / DDS.utilization().diff(nt.N_E))
    return 1 - float(ratio.subs({**DDS.values(), **ZENOH.values(), **PAPER.values()}))


def header_slope(protocol: Protocol) -> float:
    """Return the sign of the change of U with the header bytes, for two hosts or more."""
    more = 1 + sp.Symbol("x", positive=True)
    slope = sp.factor(protocol.utilization().diff(nt.H_UDP).subs(nt.N_H, more))
    return float(sp.sign(slope))


def saturation_spread(protocol: Protocol, *robot: float, fixed: Iterable[sp.Symbol] = ()) -> float:
    """Return the width of the saturation point's range over the parameters' ranges [hosts]."""
    values = {**protocol.values(), **PAPER.values()}
    ranges = {symbol: (values[symbol], values[symbol]) for symbol in fixed}
    low, high = saturation_bounds(protocol, *robot, ranges=ranges)
    return float(high - low)


def host_load(protocol: Protocol, *names: str) -> sp.Expr:
    """Return the messages of one host that the names mean."""
    return sp.factor(load(protocol, *names) / nt.N_H)


def messages_per_link(protocol: Protocol, *names: str) -> sp.Expr:
    """Return the messages for each pair of processes, both directions taken together."""
    return sp.simplify(load(protocol, *names) / (nt.N_H * (nt.N_H - 1) * nt.N_P**2 / 2))


def largest_swarm(*robot: Any) -> int:
    """Return the largest whole number of hosts that stays below 100%."""
    return int(sp.ceiling(saturation_hosts(*robot))) - 1


#: Quantities of one expression each; ``data/paper/quantities.csv`` has words for them.
FORMULAS: dict[str, Callable[..., Any]] = {
    "host_load_degree": lambda protocol, variable, *names: int(
        sp.degree(host_load(protocol, *names), nt.NOTATION[variable].symbol)
    ),
    "control_saved": lambda: 1 - sp.simplify(load(ZENOH, "control") / load(DDS, "control")),
    "messages_per_direction": lambda *messages: messages_per_link(*messages) / 2,
    "share": lambda protocol, name, *swarm: (
        airtime(protocol, name, *swarm) / float(utilization(protocol, Fleet.swarm(*swarm)))
    ),
    "share_of_phase": lambda protocol, name, phase, *swarm: (
        airtime(protocol, name, *swarm) / airtime(protocol, phase, *swarm)
    ),
    "gap": lambda *swarm: float(
        1 - utilization(ZENOH, Fleet.swarm(*swarm)) / utilization(DDS, Fleet.swarm(*swarm))
    ),
    "gap_of_phases": lambda *swarm: (
        1 - airtime(ZENOH, "Declaration", *swarm) / airtime(DDS, "SEDP", *swarm)
    ),
    "scouting_above_spdp": lambda first, last, *robot: sum(
        airtime(ZENOH, "Scouting", hosts, *robot) > airtime(DDS, "SPDP", hosts, *robot)
        for hosts in range(first, last + 1)
    ),
    "saved_by_composing": lambda *split: 1 - 1 / split_ratio(*split),
    "hosts_gained": lambda protocol, processes, in_all: (
        largest_swarm(protocol, 1, in_all) - largest_swarm(protocol, processes, in_all / processes)
    ),
    "kinds_over": lambda transport, *messages: sum(
        message.transport == transport for message in _messages_named(*messages)
    ),
    "repeated_utilization": lambda protocol, *swarm: sum(
        airtime(protocol, name, *swarm) for name in _PERIODIC[protocol.name]
    ),
    "saturation_spread_by_payloads": lambda protocol, *robot: saturation_spread(
        protocol,
        *robot,
        fixed=parameter_ranges(protocol).keys() - {m.payload_symbol for m in protocol.messages},
    ),
}
