"""The ledger of the paper's claims: what each says, what decides it, and the verdict.

The claims stand in ``data/paper/claims.csv``. A claim carries a *test*, such as
``saturation_hosts DDS 2 10 ≈ 7 ± 0.5``: a quantity of this module with its arguments, a
relation, and the value that the paper gives. Some carry a *weaker* test as well, what
remains of the claim when the first fails. Verdicts are computed from the tests.
"""

import operator
import re
from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING, Any, Literal

import sympy as sp

from discostorm import notation as nt
from discostorm.data import read_data
from discostorm.messages import Message, Protocol, header_bytes
from discostorm.paper import enumeration
from discostorm.protocols import DDS, ZENOH
from discostorm.scalability import breakdown, saturation_hosts, utilization
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


def _chosen(protocol: Protocol, names: Iterable[str]) -> list[Message]:
    """Return the messages meant by phases, casts, or messages (``SEDP_message``)."""
    called = {
        message: {message.phase, message.cast, message.name + "_message"}
        for message in protocol.messages
    }
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


def degree(protocol: Protocol, variable: str) -> int:
    """Return the degree of the utilization in one of N_H, N_P, N_E."""
    return int(sp.degree(sp.expand(protocol.utilization()), _SYMBOLS[variable]))


def host_load_degree(protocol: Protocol, variable: str, *names: str) -> int:
    """Return the degree of the messages of one host in one of N_H, N_P, N_E."""
    return int(sp.degree(host_load(protocol, *names), _SYMBOLS[variable]))


def load_degree(protocol: Protocol, variable: str, *names: str) -> int:
    """Return the degree of the messages of all hosts in one of N_H, N_P, N_E."""
    return int(sp.degree(sp.expand(load(protocol, *names)), _SYMBOLS[variable]))


def load_difference(one: Protocol, name: str, other: Protocol, other_name: str) -> sp.Expr:
    """Return how many more messages one protocol sends than another."""
    return sp.simplify(load(one, name) - load(other, other_name))


def control_ratio() -> sp.Expr:
    """Return the control messages of Zenoh relative to those of DDS."""
    return sp.simplify(load(ZENOH, *_CONTROL["Zenoh"]) / load(DDS, *_CONTROL["DDS"]))


def load_variables(protocol: Protocol) -> int:
    """Return how many variables the load depends on."""
    return len(protocol.load().free_symbols)


def host_load_variables(protocol: Protocol, *names: str) -> int:
    """Return how many variables the load of one host depends on."""
    return len(host_load(protocol, *names).free_symbols)


def growth_factor(protocol: Protocol) -> sp.Expr:
    """Return what one more host multiplies U by, in the limit of many hosts."""
    u = protocol.utilization()
    return sp.limit(sp.cancel(u.subs(nt.N_H, nt.N_H + 1) / u), nt.N_H, sp.oo)


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
    table = breakdown(protocol, hosts, processes, endpoints)
    rows = table.loc[[message.name for message in _chosen(protocol, [name])]]
    return float((rows["uplink_s"] + rows["downlink_s"]).sum())


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
    at = (hosts, processes, endpoints)
    return sum(share(protocol, name, *at) for name in _CONTROL[protocol.name])


def overhead_share(protocol: Protocol, hosts: float, processes: float, endpoints: float) -> float:
    """Return the share of the airtime that is fixed overhead, not bits."""
    u = protocol.utilization()
    values = {**protocol.values(), **PAPER.values()}
    values |= {nt.N_H: hosts, nt.N_P: processes, nt.N_E: endpoints}
    fixed = u.subs({nt.R_UNI: sp.oo, nt.R_MULTI: sp.oo})
    return float(fixed.subs(values) / u.subs(values))


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


def trajectory_degree(protocol: Protocol, *names: str) -> int:
    """Return the degree of the load in N_P when the endpoints of a host stay the same."""
    endpoints_of_host = sp.Symbol("M", positive=True)
    chosen = load(protocol, *names).subs(nt.N_E, endpoints_of_host / nt.N_P)
    return int(sp.degree(sp.expand(chosen), nt.N_P))


def load_ratio(protocol: Protocol, name: str, processes: float, fewer: float) -> float:
    """Return by how much a message's load falls when processes are composed into fewer."""
    at = load(protocol, name)
    return float(sp.simplify(at.subs(nt.N_P, processes) / at.subs(nt.N_P, fewer)))


def _message(name: str) -> Message:
    (found,) = (m for p in _PROTOCOLS.values() for m in p.messages if m.name == name)
    return found


def frame_bytes(message: str) -> float:
    """Return the frame length of a message: payload and headers [B]."""
    return _message(message).frame_bytes


def payload_spread(message: str) -> float:
    """Return half the payload range of a message relative to its nominal value."""
    payload = _message(message).payload
    return (payload.high - payload.low) / 2 / payload.nominal


def header(transport: str) -> int:
    """Return the header bytes of a transport, from their parts [B]."""
    return header_bytes()[transport]


def header_slope(protocol: Protocol) -> float:
    """Return the sign of the change of U with the header bytes: 1, 0 or -1."""
    slope = sp.factor(protocol.utilization().diff(nt.H_UDP).subs(nt.N_H, 1 + _MORE_HOSTS))
    return float(sp.sign(slope))


def bits_per_byte() -> int:
    """Return the factor between bytes and bits in the airtime of a frame."""
    return int(airtime_of_frame(sp.Integer(1), sp.Integer(1), sp.Integer(0)))


def repeated_utilization(
    protocol: Protocol, hosts: float, processes: float, endpoints: float
) -> float:
    """Return the utilization by the messages that the paper calls periodic."""
    # With the answers to what is periodic.
    periodic = {"DDS": ["SPDP"], "Zenoh": ["Scouting", "KeepAlive_message"]}
    return sum(
        airtime(protocol, name, hosts, processes, endpoints) for name in periodic[protocol.name]
    )


def enumerated_down_for_up(
    protocol: Protocol, phase: str, hosts: float, processes: float, endpoints: float
) -> float:
    """Return how many messages of a phase go down for each that goes up, by enumeration."""
    hops = Counter(
        sent.hop for sent in _walk(protocol, hosts, processes, endpoints) if sent.phase == phase
    )
    return hops["down"] / hops["up"]


def enumeration_ratio(
    protocol: Protocol, hosts: float, processes: float, endpoints: float
) -> float:
    """Return the airtime of all enumerated messages, one by one, relative to U."""
    table = breakdown(protocol, hosts, processes, endpoints)
    each = {
        (name, hop): row[f"{hop}link_s"] / row["uplink_messages"]
        for name, row in table.iterrows()
        for hop in ("up", "down")
    }
    at = (hosts, processes, endpoints)
    one_by_one = sum(each[sent.kind, sent.hop] for sent in _walk(protocol, *at))
    return float(one_by_one / utilization(protocol, *at))


def _walk(
    protocol: Protocol, hosts: float, processes: float, endpoints: float
) -> Iterator[enumeration.Sent]:
    return enumeration.walk(protocol.name, [[int(endpoints)] * int(processes)] * int(hosts))


def ht_rate(mcs: float) -> float:
    """Return the fastest rate of an MCS of 802.11n in 20 MHz [bit/s], by its own index."""
    return ht_rate_of_streams(mcs % 8, 1 + mcs // 8)


def ht_rate_of_streams(mcs: float, streams: float) -> float:
    """Return the fastest rate in 20 MHz with an MCS of each of some streams [bit/s]."""
    return Radio("802.11n", streams=int(streams), mcs=int(mcs)).wifi().unicast.rate


def ht_rates_above(streams: float, width: float) -> int:
    """Return how many rates with some streams and a width in MHz exceed the paper's."""
    # The paper's 144.4 stands for 144.44: what exceeds it by less is the same rate.
    threshold = PAPER.unicast.rate * 1.001
    return sum(
        Radio("802.11n", streams=int(streams), width=width * 1e6, mcs=mcs).wifi().unicast.rate
        > threshold
        for mcs in range(8)
    )


def lowest_basic_rate(band: float) -> float:
    """Return the lowest basic rate of 802.11n in a band in GHz [bit/s]."""
    return Radio("802.11n", band=band * 1e9).wifi().multicast.rate


def overhead_with_backoff(cast: str) -> float:
    """Return the overhead of a frame from 802.11n timing, two streams in 5 GHz [s]."""
    wifi = Radio("802.11n", streams=2).wifi()
    return (wifi.multicast if cast == "multicast" else wifi.unicast).overhead


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


def standard_bound(protocol: Protocol, hosts: float, processes: float, endpoints: float) -> float:
    """Return U with 802.11n timing, a frame at a time, relative to U with the paper's."""
    exact = utilization(protocol, hosts, processes, endpoints, Radio("802.11n", streams=2).wifi())
    return float(exact / utilization(protocol, hosts, processes, endpoints))


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


def multicast_cost(message: str) -> float:
    """Return the airtime of a frame as multicast downlink, relative to unicast."""
    up, down = _message(message).airtime_up(), _message(message).airtime_down()
    values = {**DDS.values(), **ZENOH.values(), **PAPER.values()}
    return float(down.subs(values) / up.subs(values))


# ------------------------------------------------------------------- verdicts

_RELATIONS: dict[str, Callable[[Any, Any], bool]] = {
    "=": lambda ours, paper: bool(sp.simplify(ours - paper) == 0),
    "<": operator.lt,
    "≤": operator.le,
    ">": operator.gt,
    "≥": operator.ge,
}
_TEST = re.compile(
    r"(?P<quantity>\w+)(?P<arguments>.*) (?P<relation>[=≈<≤>≥]) "
    r"(?P<paper>.+?)( ± (?P<tolerance>.+))?"
)


def _argument(word: str) -> Any:
    if word in _PROTOCOLS:
        return _PROTOCOLS[word]
    try:
        return float(word)
    except ValueError:
        return word


@cache
def _value(quantity: str) -> Any:
    name, *arguments = quantity.split()
    if name not in QUANTITIES:
        raise ValueError(f"quantity must be one of {', '.join(QUANTITIES)}; got {name!r}")
    return QUANTITIES[name](*map(_argument, arguments))


@dataclass(frozen=True)
class Test:
    """What decides a claim: a quantity of this module, a relation, and the paper's value."""

    text: str

    def _part(self, name: str) -> str:
        match = _TEST.fullmatch(self.text)
        if match is None:
            raise ValueError(
                f"test must read 'quantity arguments relation value'; got {self.text!r}"
            )
        return match[name] or ""

    @property
    def paper(self) -> str:
        """The paper's value, with the relation to it."""
        return self.text[self.text.index(f" {self._part('relation')} ") + 1 :]

    @property
    def quantity(self) -> str:
        """The quantity with its arguments."""
        return self._part("quantity") + self._part("arguments")

    def ours(self) -> Any:
        """Return the quantity as computed by the package: a number or an expression."""
        return _value(self.quantity)

    def holds(self) -> bool:
        """Return whether the relation between our value and the paper's holds."""
        paper = sp.sympify(self._part("paper"), locals=_SYMBOLS)
        ours = self.ours()
        if self._part("relation") == "≈":
            return bool(abs(ours - float(paper)) <= float(self._part("tolerance")))
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
    test : Test or None
        What decides it; None if nothing in the paper does.
    weaker_test : Test or None
        What is left of it if `test` fails.
    remark : str
        The qualification, how it is contradicted, or why it cannot be checked.
    link : str
        Label in the book where the quantity is derived.
    """

    id: int
    where: str
    section: str
    statement: str
    test: Test | None
    weaker_test: Test | None
    remark: str
    link: str

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

    def test(text: str) -> Test | None:
        return Test(text) if text else None

    return tuple(
        Claim(
            int(row["id"]),
            row["where"],
            row["section"],
            row["statement"],
            test(row["test"]),
            test(row["weaker_test"]),
            row["remark"],
            row["link"],
        )
        for row in read_data("paper/claims.csv")
    )


def ledger() -> "pd.DataFrame":
    """Return the ledger: one row a claim, with the paper's value, ours and the verdict.

    Returns
    -------
    pandas.DataFrame
        Indexed by id, with columns where, section, statement, quantity, paper, ours, verdict,
        remark and link.
    """
    import pandas as pd

    return pd.DataFrame(
        {
            "id": claim.id,
            "where": claim.where,
            "section": claim.section,
            "statement": claim.statement,
            "quantity": claim.test.quantity if claim.test else "",
            "paper": claim.test.paper if claim.test else "",
            "ours": claim.test.ours() if claim.test else "",
            "verdict": claim.verdict(),
            "remark": claim.remark,
            "link": claim.link,
        }
        for claim in claims()
    ).set_index("id")


QUANTITIES: dict[str, Callable[..., Any]] = {
    function.__name__: function
    for function in (
        airtime,
        standard_bound,
        largest_swarm,
        saturation_spread,
        saturation_spread_by_payloads,
        aggregation_bound,
        overhead_with_backoff,
        ht_rates_above,
        ht_rate_of_streams,
        ht_rate,
        enumeration_ratio,
        enumerated_down_for_up,
        bits_per_byte,
        control_ratio,
        control_share,
        degree,
        frame_bytes,
        gap,
        gap_from_control,
        gap_limit,
        gap_of_phases,
        growth_factor,
        header,
        header_slope,
        host_load,
        host_load_degree,
        host_load_variables,
        load,
        load_degree,
        load_difference,
        load_ratio,
        load_variables,
        lowest_basic_rate,
        messages_per_direction,
        messages_per_link,
        multicast_cost,
        overhead_share,
        payload_spread,
        repeated_utilization,
        saturation_hosts,
        scouting_above_spdp,
        share,
        share_of_phase,
        trajectory_degree,
        utilization,
    )
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
