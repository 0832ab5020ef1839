"""The ledger of the paper's claims: what each says, what decides it, and the verdict.

The claims stand in ``data/paper/claims.csv``. A claim carries a *test*, such as
``saturation_hosts DDS 2 10 ≈ 7``: a quantity of this module with its arguments, a
relation, and the value that the paper gives. Some carry a *weaker* test as well, what
remains of the same sentence when the first fails. Verdicts are computed from the tests.

Where the paper has a soft word instead of a number, the test has the word:
``control_share DDS 7 2 10 is significant``. What we read into it stands in
``data/paper/soft_words.csv``, once for each word, and holds for every claim.

A remark may hold a quantity, ``{share DDS unicast 7 2 10|.1%}``, which is filled in.
"""

import math
import operator
import re
from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import cache
from statistics import median
from typing import TYPE_CHECKING, Any, Literal, TypeVar

import sympy as sp

from discostorm import measured, notation as nt, words
from discostorm.data import read_data
from discostorm.fleet import Fleet, HostGroup
from discostorm.messages import Message, Protocol, header_bytes
from discostorm.paper import enumeration
from discostorm.protocols import DDS, MEASURED, PROTOCOLS, ZENOH
from discostorm.protocols.defaults import defaults, products
from discostorm.scalability import message_costs, saturation_hosts, utilization
from discostorm.uncertainty import parameter_ranges, saturation_bounds
from discostorm.wifi import PAPER, Radio, airtime as airtime_of_frame

if TYPE_CHECKING:
    import pandas as pd

Verdict = Literal["reproduced", "qualified", "contradicted", "not checkable"]

VERDICTS: dict[Verdict, str] = {
    "reproduced": "holds as worded",
    "qualified": "holds with the qualification given",
    "contradicted": "does not hold by the paper's own equations",
    "not checkable": "the paper gives nothing to compute it from",
}

_PROTOCOLS = {"DDS": DDS, "Zenoh": ZENOH}
_CONTROL = {"DDS": ("Heartbeat_message", "ACKNACK_message"), "Zenoh": ("KeepAlive_message",)}
_MORE_HOSTS = sp.Symbol("x", positive=True)
_SYMBOLS = {name: quantity.symbol for name, quantity in nt.NOTATION.items()}


# ---------------------------------------------------------------- quantities

#: What a test may compute, by its name.
QUANTITIES: dict[str, Callable[..., Any]] = {}

Quantity = TypeVar("Quantity", bound=Callable[..., Any])


def _quantity(function: Quantity) -> Quantity:
    """Let tests compute it by its name."""
    QUANTITIES[function.__name__] = function
    return function


for _function in (saturation_hosts, utilization):
    _quantity(_function)


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


@_quantity
def load(protocol: Protocol, *names: str) -> sp.Expr:
    """Return the messages of all hosts that the names mean."""
    return sp.factor(sp.Add(*(message.load() for message in _chosen(protocol, names))))


@_quantity
def host_load(protocol: Protocol, *names: str) -> sp.Expr:
    """Return the messages of one host, of the phases or messages named."""
    return sp.factor(load(protocol, *names) / nt.N_H)


@_quantity
def host_load_degree(protocol: Protocol, variable: str, *names: str) -> int:
    """Return the degree of the messages of one host in one of N_H, N_P, N_E."""
    return int(sp.degree(host_load(protocol, *names), _SYMBOLS[variable]))


@_quantity
def load_difference(one: Protocol, name: str, other: Protocol, other_name: str) -> sp.Expr:
    """Return how many more messages one protocol sends than another."""
    return sp.simplify(load(one, name) - load(other, other_name))


@_quantity
def control_saved() -> sp.Expr:
    """Return the part of DDS's control messages that Zenoh does without."""
    return 1 - sp.simplify(load(ZENOH, "control") / load(DDS, "control"))


@_quantity
def load_variables(protocol: Protocol) -> int:
    """Return how many variables the load depends on."""
    return len(protocol.load().free_symbols)


@_quantity
def host_load_variables(protocol: Protocol, *names: str) -> int:
    """Return how many variables the load of one host depends on."""
    return len(host_load(protocol, *names).free_symbols)


@_quantity
def growth_factor(protocol: Protocol) -> sp.Expr:
    """Return what one more host multiplies U by, in the limit of many hosts."""
    # Of two polynomials of the same degree, the leading coefficients are what remains.
    u = sp.Poly(protocol.utilization(), nt.N_H)
    return sp.cancel(u.shift(1).LC() / u.LC())


@_quantity
def messages_per_link(protocol: Protocol, *names: str) -> sp.Expr:
    """Return the messages for each pair of processes, both directions taken together."""
    links = nt.N_H * (nt.N_H - 1) * nt.N_P**2 / 2
    return sp.simplify(load(protocol, *names) / links)


@_quantity
def messages_per_direction(protocol: Protocol, *names: str) -> sp.Expr:
    """Return the messages that one process sends to one other."""
    return messages_per_link(protocol, *names) / 2


@_quantity
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


@_quantity
def share(protocol: Protocol, name: str, hosts: float, processes: float, endpoints: float) -> float:
    """Return the share of all airtime that the messages take that a name means."""
    at = (hosts, processes, endpoints)
    return airtime(protocol, name, *at) / float(utilization(protocol, *at))


@_quantity
def share_of_phase(
    protocol: Protocol, name: str, phase: str, hosts: float, processes: float, endpoints: float
) -> float:
    """Return the share of a phase's airtime that a message takes."""
    at = (hosts, processes, endpoints)
    return airtime(protocol, name, *at) / airtime(protocol, phase, *at)


@_quantity
def control_share(protocol: Protocol, hosts: float, processes: float, endpoints: float) -> float:
    """Return the share of all airtime that the control messages take."""
    return share(protocol, "control", hosts, processes, endpoints)


@_quantity
def overhead_share(protocol: Protocol, hosts: float, processes: float, endpoints: float) -> float:
    """Return the share of the airtime that is fixed overhead, not bits."""
    u = protocol.utilization()
    values = {**protocol.values(), **PAPER.values()}
    values |= {nt.N_H: hosts, nt.N_P: processes, nt.N_E: endpoints}
    fixed = u.subs({nt.R_UNI: sp.oo, nt.R_MULTI: sp.oo})
    return float(fixed.subs(values) / u.subs(values))


@_quantity
def largest_swarm(protocol: Protocol, processes: float, endpoints: float) -> int:
    """Return the largest whole number of hosts that stays below 100%."""
    return int(sp.ceiling(saturation_hosts(protocol, processes, endpoints))) - 1


@_quantity
def gap(hosts: float, processes: float, endpoints: float) -> float:
    """Return how much less airtime Zenoh takes than DDS, relative to DDS."""
    zenoh = utilization(ZENOH, hosts, processes, endpoints)
    return float(1 - zenoh / utilization(DDS, hosts, processes, endpoints))


@_quantity
def gap_of_phases(hosts: float, processes: float, endpoints: float) -> float:
    """Return how much less airtime Declaration takes than SEDP, relative to SEDP."""
    at = (hosts, processes, endpoints)
    return 1 - airtime(ZENOH, "Declaration", *at) / airtime(DDS, "SEDP", *at)


@_quantity
def gap_limit() -> float:
    """Return the gap between DDS and Zenoh in the limit of many endpoints."""
    # Both are linear in N_E, so the ratio of the slopes is what remains.
    ratio = sp.cancel(ZENOH.utilization().diff(nt.N_E) / DDS.utilization().diff(nt.N_E))
    return 1 - float(ratio.subs({**DDS.values(), **ZENOH.values(), **PAPER.values()}))


@_quantity
def gap_from_control(hosts: float, processes: float, endpoints: float) -> float:
    """Return the part of the gap between SEDP and Declaration that control messages make."""
    at = (hosts, processes, endpoints)
    endpoint_part = airtime(DDS, "SEDP_message", *at) - airtime(ZENOH, "Declare_message", *at)
    whole = airtime(DDS, "SEDP", *at) - airtime(ZENOH, "Declaration", *at)
    return 1 - endpoint_part / whole


@_quantity
def scouting_above_spdp(first: float, last: float, processes: float, endpoints: float) -> int:
    """Return for how many swarm sizes from first to last Scouting costs more than SPDP."""
    return sum(
        airtime(ZENOH, "Scouting", hosts, processes, endpoints)
        > airtime(DDS, "SPDP", hosts, processes, endpoints)
        for hosts in range(int(first), int(last) + 1)
    )


@_quantity
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


@_quantity
def split_ratio(protocol: Protocol, hosts: float, processes: float, in_all: float) -> float:
    """Return how many times the airtime of one process it takes to split it into several."""
    split = airtime(protocol, "all", hosts, processes, in_all / processes)
    return split / airtime(protocol, "all", hosts, 1, in_all)


@_quantity
def saved_by_composing(protocol: Protocol, hosts: float, processes: float, in_all: float) -> float:
    """Return the part of the airtime of several processes that one with all endpoints saves."""
    return 1 - 1 / split_ratio(protocol, hosts, processes, in_all)


@_quantity
def part_of_increase(
    protocol: Protocol, name: str, hosts: float, processes: float, in_all: float
) -> float:
    """Return what some messages add, of all that is added when a process is split."""

    def added(name: str) -> float:
        split = airtime(protocol, name, hosts, processes, in_all / processes)
        return split - airtime(protocol, name, hosts, 1, in_all)

    return added(name) / added("all")


@_quantity
def hosts_gained(protocol: Protocol, processes: float, in_all: float) -> int:
    """Return how many more whole hosts fit when several processes become one."""
    split = largest_swarm(protocol, processes, in_all / processes)
    return largest_swarm(protocol, 1, in_all) - split


@_quantity
def kinds_over(transport: str, protocol: Protocol, name: str) -> int:
    """Return how many kinds of the messages that a name means go over a transport."""
    return sum(message.transport == transport for message in _chosen(protocol, [name]))


@_quantity
def default(product: str | Protocol, quantity: str) -> float:
    """Return a product's default; its name has _ for a space."""
    named = {name.replace(" ", "_"): name for name in products()}
    asked = product if isinstance(product, str) else product.name
    if asked not in named:
        raise ValueError(f"product must be one of {', '.join(named)}; got {asked!r}")
    return defaults(named[asked])[quantity]


@_quantity
def timestamps_bytes() -> float:
    """Return what the timestamps option adds to the headers of a TCP message [B]."""
    (row,) = (row for row in read_data("paper/parameter_ranges.csv") if "timestamps" in row["part"])
    return float(row["high"])


def _message(name: str) -> Message:
    (found,) = (m for p in _PROTOCOLS.values() for m in p.messages if m.name == name)
    return found


@_quantity
def frame_bytes(message: str) -> float:
    """Return the frame length of a message: payload and headers [B]."""
    return _message(message).frame_bytes


@_quantity
def payload_spread(message: str) -> float:
    """Return half the payload range of a message relative to its nominal value."""
    payload = _message(message).payload
    return (payload.high - payload.low) / 2 / payload.nominal


@_quantity
def payloads_measured(protocol: Protocol) -> float:
    """Return which part of the messages had, in captures, a payload in the paper's range.

    Of the products that speak the protocol, at least one; its median of all points of the lab.
    """
    within = set()
    for name, table in PROTOCOLS.items():
        if name in MEASURED and table.messages[0].kind == protocol.messages[0].name:
            for message in protocol.messages:
                sizes = measured.payloads(name, message.name)
                if sizes and message.payload.low <= median(sizes) <= message.payload.high:
                    within.add(message.name)
    return len(within) / len(protocol.messages)


@_quantity
def start_saved(arrangement: str, hosts: float) -> float:
    """Return which part of the start's airtime an arrangement saves, with any names the least.

    Of that of the product without it, as both tables were measured, on the paper's channel: for
    so many hosts of 2 processes with 10 endpoints, which match nobody or all. Names have _ for a
    space.
    """
    name = arrangement.replace("_", " ")
    (row,) = (r for r in read_data("vendors/arrangement_risks.csv") if r["protocol"] == name)
    saved = []
    for matching in (0.0, 1.0):
        fleet = Fleet((HostGroup(hosts, 2, 10),), matching)
        with_it, without = (
            utilization(PROTOCOLS[table], fleet) for table in (name, row["instead_of"])
        )
        saved.append(1 - float(with_it) / float(without))
    return min(saved)


def _death_times(arrangement: str, event: str, *what: str) -> list[float]:
    """Return the times of the runs of a staging whose name has _ for a space [s]."""
    names = (name.replace("_", " ") for name in (arrangement, event, *what))
    return [float(time) for time in measured.death_times(*names)]


@_quantity
def runs_found(arrangement: str, event: str) -> float:
    """Return the part of the runs in which a newcomer found the living before the dead was back."""
    times = _death_times(arrangement, event, "newcomer", "newcomer", "found")
    return sum(map(math.isfinite, times)) / len(times)


@_quantity
def runs_undisturbed(arrangement: str, event: str, who: str) -> float:
    """Return the part of the runs in which these lost no match and heard each other all along."""
    times = _death_times(arrangement, event, "death", who, "settled")
    return times.count(0) / len(times)


def _simulated(table: str, **wanted: object) -> list[dict[str, str]]:
    """Return the rows of a sweep of ``data/simulated`` with these values, at least one."""
    named = {
        name: f"{value:g}" if isinstance(value, float) else value for name, value in wanted.items()
    }
    rows = [row for row in read_data(f"simulated/{table}.csv") if named.items() <= row.items()]
    if not rows:
        raise ValueError(f"simulated/{table}.csv has no row with {named}")
    return rows


@_quantity
def burst_excess(protocol: Protocol, hosts: float, mpdus: float) -> float:
    """Return how much longer a simulated burst takes than the closed form's airtime.

    Without limits of the queues; the paper's small robots, on 802.11n as its channel has it.
    """
    (row,) = _simulated("drain", protocol=protocol.name, hosts=hosts, mpdus=mpdus)
    wifi = Radio("802.11n", streams=2, aifsn=3, mpdus=int(mpdus)).wifi()
    counts = {name: float(row[name]) for name in ("hosts", "processes", "endpoints")}
    closed = utilization(protocol, Fleet.swarm(**counts), wifi=wifi)
    return float(row["drain_time_s"]) / float(closed) - 1


@_quantity
def multicast_lost(protocol: Protocol, hosts: float) -> float:
    """Return which part of the receptions of multicast a simulated burst loses to collisions."""
    (row,) = _simulated("drain", protocol=protocol.name, hosts=hosts, mpdus=1.0)
    fleet = Fleet.swarm(*(float(row[name]) for name in ("hosts", "processes", "endpoints")))
    receptions = {True: 0.0, False: 0.0}
    for message in protocol.messages:
        multicast = message.cast == "multicast"
        receptions[multicast] += float(message.load(fleet)) * (hosts - 1 if multicast else 1)
    return float(row["on_air"]) * sum(receptions.values()) / receptions[True]


@_quantity
def runs_converged(hosts: float) -> float:
    """Return the part of the simulated runs in which everybody knew everybody in two minutes.

    The least of the paper's counts with the periods of products; no frame errors.
    """
    rows = _simulated("convergence", hosts=hosts, loss="0.0")
    return min(
        int(row["converged"]) / int(row["runs"]) for row in rows if "periods" in row["protocol"]
    )


@_quantity
def header(transport: str) -> int:
    """Return the header bytes of a transport, from their parts [B]."""
    return header_bytes()[transport]


@_quantity
def header_slope(protocol: Protocol) -> float:
    """Return the sign of the change of U with the header bytes: 1, 0 or -1."""
    slope = sp.factor(protocol.utilization().diff(nt.H_UDP).subs(nt.N_H, 1 + _MORE_HOSTS))
    return float(sp.sign(slope))


@_quantity
def bits_per_byte() -> int:
    """Return the factor between bytes and bits in the airtime of a frame."""
    return int(airtime_of_frame(sp.Integer(1), sp.Integer(1), sp.Integer(0)))


@_quantity
def repeated_utilization(
    protocol: Protocol, hosts: float, processes: float, endpoints: float
) -> float:
    """Return the utilization by the messages that the paper calls periodic."""
    # With the answers to what is periodic.
    periodic = {"DDS": ["SPDP"], "Zenoh": ["Scouting", "KeepAlive_message"]}
    return sum(
        airtime(protocol, name, hosts, processes, endpoints) for name in periodic[protocol.name]
    )


@_quantity
def enumerated_down_for_up(
    protocol: Protocol, phase: str, hosts: float, processes: float, endpoints: float
) -> float:
    """Return how many messages of a phase go down for each that goes up, by enumeration."""
    hops = Counter(
        sent.hop for sent in _walk(protocol, hosts, processes, endpoints) if sent.phase == phase
    )
    return hops["down"] / hops["up"]


@_quantity
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


@_quantity
def ht_rate(mcs: float) -> float:
    """Return the fastest rate of an MCS of 802.11n in 20 MHz [bit/s], by its own index."""
    return ht_rate_of_streams(mcs % 8, 1 + mcs // 8)


@_quantity
def ht_rate_of_streams(mcs: float, streams: float) -> float:
    """Return the fastest rate in 20 MHz with an MCS of each of some streams [bit/s]."""
    return Radio("802.11n", streams=int(streams), mcs=int(mcs)).wifi().unicast.rate


@_quantity
def ht_rates_above(streams: float, width: float) -> int:
    """Return how many rates with some streams and a width in MHz exceed the paper's."""
    # The paper's 144.4 stands for 144.44: what exceeds it by less is the same rate.
    threshold = PAPER.unicast.rate * 1.001
    return sum(
        Radio("802.11n", streams=int(streams), width=width * 1e6, mcs=mcs).wifi().unicast.rate
        > threshold
        for mcs in range(8)
    )


@_quantity
def lowest_basic_rate(band: float) -> float:
    """Return the lowest basic rate of 802.11n in a band in GHz [bit/s]."""
    return Radio("802.11n", band=band * 1e9).wifi().multicast.rate


@_quantity
def overhead_with_backoff(cast: str) -> float:
    """Return the overhead of a frame from 802.11n timing, two streams in 5 GHz [s]."""
    wifi = Radio("802.11n", streams=2).wifi()
    return (wifi.multicast if cast == "multicast" else wifi.unicast).overhead


@_quantity
def overhead_of_named_intervals(cast: str) -> float:
    """Return that overhead without the back-off, which the paper does not name [s]."""
    (band,) = (row for row in read_data("wifi/bands.csv") if row["band_GHz"] == "5")
    return overhead_with_backoff(cast) - float(band["cw_min"]) / 2 * float(band["slot_us"]) * 1e-6


@_quantity
def aggregation_bound(
    protocol: Protocol, hosts: float, processes: float, endpoints: float
) -> float:
    """Return U with full A-MPDUs of 802.11n relative to U with a frame at a time."""
    aggregated, single = (
        utilization(
            protocol,
            hosts,
            processes,
            endpoints,
            Radio("802.11n", streams=2, mpdus=mpdus).wifi(),
        )
        for mpdus in (64, 1)
    )
    return float(aggregated / single)


@_quantity
def standard_bound(protocol: Protocol, hosts: float, processes: float, endpoints: float) -> float:
    """Return U with 802.11n timing, a frame at a time, relative to U with the paper's."""
    exact = utilization(protocol, hosts, processes, endpoints, Radio("802.11n", streams=2).wifi())
    return float(exact / utilization(protocol, hosts, processes, endpoints))


@_quantity
def saturation_spread(protocol: Protocol, processes: float, endpoints: float) -> float:
    """Return by how many hosts the ranges of all parameters can move the saturation point."""
    least, most = saturation_bounds(protocol, processes, endpoints)
    return float(most - least)


@_quantity
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


@_quantity
def multicast_cost(message: str) -> float:
    """Return the airtime of a frame as multicast downlink, relative to unicast."""
    up, down = _message(message).airtime_up(), _message(message).airtime_down()
    values = {**DDS.values(), **ZENOH.values(), **PAPER.values()}
    return float(down.subs(values) / up.subs(values))


# ------------------------------------------------------------------- verdicts

_RELATIONS: dict[str, Callable[[Any, Any], bool]] = {
    "=": lambda ours, paper: bool(sp.cancel(ours - paper).is_zero),
    "<": operator.lt,
    "≤": operator.le,
    ">": operator.gt,
    "≥": operator.ge,
}
_TEST = re.compile(
    r"(?P<quantity>\w+)(?P<arguments>.*) "
    r"((?P<relation>[=≈<≤>≥]) (?P<paper>.+?)( ± (?P<tolerance>.+))?"
    r"|is (?P<negated>not )?(?P<word>[\w-]+))"
)
_OPPOSITE = {"<": "≥", "≤": ">", ">": "≤", "≥": "<"}
_IN_WORDS = {
    "=": "",
    "≈": "about ",
    "<": "less than ",
    "≤": "at most ",
    ">": "more than ",
    "≥": "at least ",
}
_FILLED = re.compile(r"\{(?P<quantity>[^|}]+)\|(?P<spec>[^}]+)\}")


def _argument(word: str) -> Any:
    if word in _PROTOCOLS:
        return _PROTOCOLS[word]
    try:
        return float(word)
    except ValueError:
        return word


def _printed(text: str) -> Any:
    """Return a value of the paper: a number, or an expression in its symbols."""
    try:
        return float(text)
    except ValueError:
        return sp.sympify(text, locals=_SYMBOLS)


@cache
def _value(quantity: str) -> Any:
    name, *arguments = quantity.split()
    if name not in QUANTITIES:
        raise ValueError(f"quantity must be one of {', '.join(QUANTITIES)}; got {name!r}")
    return QUANTITIES[name](*map(_argument, arguments))


@cache
def _quantity_words(quantity: str) -> dict[str, str]:
    """Return what a quantity, or which default, is called, its unit, and how it is known."""
    name, *arguments = quantity.split()
    called = f"{name} {arguments[-1]}" if name == "default" else name
    (row,) = (row for row in read_data("paper/quantities.csv") if row["quantity"] == called)
    return row


def _named(argument: str) -> str:
    """Return an argument of a quantity as a reader knows it."""
    if argument in _SYMBOLS:
        return f"${sp.latex(_SYMBOLS[argument])}$"
    if argument in {"all", "control", "multicast"}:
        return f"{argument} messages"
    return argument.removesuffix("_message").replace("_", " ")


def _singular(text: str) -> str:
    """Return a text in which one thing is not many of them."""
    return re.sub(
        r"\b1 (process(?=es\b)|(?:variable|message|bit|host|kind|frame)(?=s\b))e?s", r"1 \1", text
    )


def _told(value: Any, unit: str) -> str:
    """Return a value in its unit, to three digits; an expression as LaTeX."""
    if unit == "expression" or not sp.sympify(value).is_number:
        return f"${sp.latex(sp.factor(value))}$"
    number = float(value)
    if unit == "switch":
        return "on" if number else "off"
    if unit == "saving" and number < 0:
        return f"none, it takes {1 - number:.3g} times as much"
    factor, suffix = {
        "percent": (100, "%"),
        "saving": (100, "%"),
        "second": (1, " s") if number >= 10 else (100, "%"),
        "bytes": (1, " B"),
        "rate": (1e-6, " Mbit/s"),
        "time": (1e6, " µs"),
    }.get(unit, (1, ""))
    digits = 4 if unit == "rate" else 3
    scaled = float(f"{factor * number:.{digits}g}")
    return f"{scaled:,.10g}{suffix}"


def _swarm(counts: list[str]) -> str:
    """Return hosts, processes and endpoints in words; nothing if these are not they."""
    try:
        hosts, processes, endpoints = map(float, counts)
    except ValueError:
        return ""
    return (
        f"{words.many(hosts, 'host')} of {words.many(processes, 'process', 'es')} "
        f"with {words.many(endpoints, 'endpoint')}"
    )


@dataclass(frozen=True)
class SoftWord:
    """A word that a number can test, and the one threshold that we read into it."""

    word: str
    forms: str
    relation: str
    threshold: float
    reading: str


@cache
def soft_words() -> dict[str, SoftWord]:
    """Return the soft words of the paper, each with what we read into it."""
    return {
        row["word"]: SoftWord(
            row["word"], row["forms"], row["relation"], float(row["threshold"]), row["reading"]
        )
        for row in read_data("paper/soft_words.csv")
    }


def _soft_word(word: str) -> SoftWord:
    if word not in soft_words():
        raise ValueError(f"word must be one of {', '.join(soft_words())}; got {word!r}")
    return soft_words()[word]


@dataclass(frozen=True)
class Criterion:
    """What decides a claim: a quantity of this module, a relation, and the paper's value.

    The value may be a soft word instead, ``is marginal`` or ``is not dominant``, and
    ``≈ 7`` without a tolerance is about 7, as far as the word "approximately" goes.
    """

    text: str

    def _part(self, name: str) -> str:
        match = _TEST.fullmatch(self.text)
        if match is None:
            raise ValueError(
                "test must read 'quantity arguments relation value' or 'quantity arguments is "
                f"word'; got {self.text!r}"
            )
        return match[name] or ""

    @property
    def word(self) -> SoftWord | None:
        """The soft word that it reads, if any."""
        if self._part("relation") == "≈" and not self._part("tolerance"):
            return _soft_word("approximately")
        return _soft_word(self._part("word")) if self._part("word") else None

    @property
    def paper(self) -> str:
        """The paper's value, with the relation to it."""
        if self._part("word"):
            word = _soft_word(self._part("word"))
            relation = _OPPOSITE[word.relation] if self._part("negated") else word.relation
            return f"{self._part('negated')}{word.word}: {relation} {word.threshold:g}"
        return self.text[self.text.index(f" {self._part('relation')} ") + 1 :]

    @property
    def quantity(self) -> str:
        """The quantity with its arguments."""
        return self._part("quantity") + self._part("arguments")

    def in_words(self) -> str:
        """Return what the test asks and what was found, as Markdown.

        Examples
        --------
        >>> Criterion("control_saved is significant").in_words()
        'at least 10% of the control messages of DDS saved by Zenoh: 50%'
        """
        _, *arguments = self.quantity.split()
        row = _quantity_words(self.quantity)
        word = self.word
        relation = self._part("relation") or (word.relation if word else "")
        if self._part("negated"):
            relation = _OPPOSITE[relation]
        paper = self._part("paper") or (f"{word.threshold:g}" if word else "")
        limit = _told(sp.sympify(paper, locals=_SYMBOLS), row["unit"])
        if tolerance := self._part("tolerance"):
            limit += f" ± {_told(sp.sympify(tolerance), row['unit'])}"
        said = row["words"].format(
            *map(_named, arguments),
            limit=_IN_WORDS[relation] + limit,
            names=" and ".join(
                _named(each) for each in arguments if each not in {*_PROTOCOLS, *_SYMBOLS}
            ),
            swarm=_swarm(arguments[-3:]),
        )
        found = _told(self.ours(), row["unit"])
        same = found == limit and found.startswith("$")
        return f"{_singular(said)}: {'the same' if same else found}"

    @property
    def provenance(self) -> str:
        """How the quantity is known: computed, read in sources, simulated or measured."""
        return _quantity_words(self.quantity)["provenance"]

    def ours(self) -> Any:
        """Return the quantity as computed by the package: a number or an expression."""
        return _value(self.quantity)

    def holds(self) -> bool:
        """Return whether the relation between our value and the paper's holds."""
        ours = self.ours()
        if self._part("word"):
            word = _soft_word(self._part("word"))
            found = _RELATIONS[word.relation](ours, word.threshold)
            return bool(found) is not bool(self._part("negated"))
        paper = _printed(self._part("paper"))
        if self._part("relation") == "≈":
            about = _soft_word("approximately").threshold * abs(paper)
            return bool(abs(ours - paper) <= float(self._part("tolerance") or about))
        return bool(_RELATIONS[self._part("relation")](ours, paper))


@dataclass(frozen=True)
class Claim:
    """A checkable statement of the paper, in our words.

    Parameters
    ----------
    id : int
        Its number in the ledger, in the order of the paper.
    where : str
        Section, equation, table or figure of the paper.
    section : str
        Section of the ledger chapter in which it is decided.
    statement : str
        What it says.
    test : Criterion or None
        What decides it; None if nothing in the paper does.
    weaker_test : Criterion or None
        What is left of the same sentence if `test` fails.
    remark : str
        The qualification, how it is contradicted, or why it cannot be checked.
    link : str
        Label in the book where the quantity is derived.
    """

    id: int
    where: str
    section: str
    statement: str
    test: Criterion | None
    weaker_test: Criterion | None
    remark: str
    link: str

    @property
    def reading(self) -> str:
        """What we read into the soft words of the statement; empty if it has none."""
        tests = [test for test in (self.test, self.weaker_test) if test]
        words = dict.fromkeys(test.word for test in tests if test.word)
        return "; ".join(f"we read {word.word}: {word.reading}" for word in words)

    @property
    def provenance(self) -> str:
        """How the quantities of its tests are known; empty if it has none."""
        tests = [test for test in (self.test, self.weaker_test) if test]
        return ", ".join(dict.fromkeys(test.provenance for test in tests))

    def verdict(self) -> Verdict:
        """Return the verdict, computed from the tests."""
        if self.test is None:
            return "not checkable"
        if self.test.holds():
            return "reproduced"
        if self.weaker_test is not None and self.weaker_test.holds():
            return "qualified"
        return "contradicted"


@cache
def claims() -> tuple[Claim, ...]:
    """Return all claims, in the order of the paper."""

    def test(text: str) -> Criterion | None:
        return Criterion(text) if text else None

    return tuple(
        Claim(
            int(row["id"]),
            row["where"],
            row["section"],
            row["statement"],
            test(row["test"]),
            test(row["weaker_test"]),
            _FILLED.sub(_fill, row["remark"]),
            row["link"],
        )
        for row in read_data("paper/claims.csv")
    )


def _fill(found: re.Match[str]) -> str:
    """Return a quantity within a remark as text; the format ``µs`` is for seconds."""
    value, spec = float(_value(found["quantity"])), found["spec"]
    return f"{value * 1e6:.0f} µs" if spec == "µs" else format(value, spec)


def ledger() -> "pd.DataFrame":
    """Return the ledger: one row a claim, with the paper's value, ours and the verdict.

    Returns
    -------
    pandas.DataFrame
        Indexed by id, with columns where, section, statement, reading, quantity, paper, ours,
        verdict, provenance, remark and link.
    """
    import pandas as pd

    return pd.DataFrame(map(row, claims())).set_index("id")


def row(claim: Claim) -> dict[str, Any]:
    """Return the row of a claim in `ledger`, its id included."""
    return {
        "id": claim.id,
        "where": claim.where,
        "section": claim.section,
        "statement": claim.statement,
        "reading": claim.reading,
        "quantity": claim.test.quantity if claim.test else "",
        "paper": claim.test.paper if claim.test else "",
        "ours": claim.test.ours() if claim.test else "",
        "verdict": claim.verdict(),
        "provenance": claim.provenance,
        "remark": claim.remark,
        "link": claim.link,
    }


def shown(value: Any) -> str:
    """Return a quantity as a reader wants it: numbers to four digits."""
    found = exact(value)
    return found if isinstance(found, str) else f"{found:.4g}"


def exact(value: Any) -> float | str:
    """Return a quantity as a machine wants it: a number with all its digits, or as text."""
    if isinstance(value, str):
        return value
    return float(value) if sp.sympify(value).is_number else str(value)


def report(section: str) -> str:
    """Return what decides each claim of a section of the ledger, and the verdict, in words.

    Raises
    ------
    ValueError
        If there is no such section.
    """
    chosen = [claim for claim in claims() if claim.section == section]
    if not chosen:
        known = ", ".join(dict.fromkeys(claim.section for claim in claims()))
        raise ValueError(f"section must be one of {known}; got {section!r}")
    lines = []
    for claim in chosen:
        lines.append(f"{claim.id}. {claim.where}: {claim.statement}")
        if claim.reading:
            lines.append(f"   {claim.reading}")
        for test, kind in ((claim.test, "the paper"), (claim.weaker_test, "weaker")):
            if test:
                lines.append(f"   {test.quantity} is {shown(test.ours())}; {kind}: {test.paper}")
        lines.append(f"   -> {claim.verdict()}")
    return "\n".join(lines)


def verdict_counts() -> "pd.DataFrame":
    """Return how many claims got each verdict: one row a verdict, with its meaning."""
    import pandas as pd

    counts = Counter(claim.verdict() for claim in claims())
    return pd.DataFrame(
        [(verdict, counts[verdict], meaning) for verdict, meaning in VERDICTS.items()],
        columns=["verdict", "claims", "it means"],
    ).set_index("verdict")
