"""What discovery costs a fleet, what dominates, and what would help, most first.

Every remedy is a changed fleet, protocol or Wi-Fi that goes through the same `utilization`;
no formula is stated here.
"""

from __future__ import annotations

import json
import re
import textwrap
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import chain
from typing import TYPE_CHECKING, Any, Literal

from discostorm import _checks
from discostorm.data import read_data
from discostorm.fleet import COUNTS, LEAST, Fleet, HostGroup
from discostorm.messages import Protocol
from discostorm.protocols import DDS, ZENOH
from discostorm.scalability import as_fleet, message_costs, utilization, without_each
from discostorm.wifi import PAPER, Link, Radio, Wifi

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.figure import Figure

Kind = Literal[
    "processes",
    "endpoints",
    "multicast rate",
    "radio",
    "aggregation",
    "channels",
    "domains",
    "middleware",
]

#: Parts that a fleet is split into.
PARTS = (2, 3)
#: The fastest basic rate that every OFDM station must know [bit/s] (IEEE Std 802.11-2020,
#: 17.2.2.3), and frames in an A-MPDU [1].
MULTICAST_RATE, MPDUS = 24e6, 64
#: Other radios: arguments of `Radio`.
RADIOS: tuple[dict[str, Any], ...] = (
    {"standard": "802.11n", "width": 40e6},
    {"standard": "802.11ac", "width": 80e6},
    {"standard": "802.11ax", "width": 160e6},
)
STREAMS = 2

#: Groups that are named.
_GROUPS = 5
#: Changes of less than this are not told apart [1].
_NOTHING = 0.005
#: Gains from this on are told with both times [1].
_LARGE = 0.1
#: From this on, numbers are told with their power of ten [1 or s].
HUGE = 1e6

_PRICE: dict[Kind, str] = {
    "processes": "a crash takes down all that shares the process",
    "endpoints": "parameters can no longer be read or set from outside",
    "multicast rate": "hosts too far away for this rate hear no multicast",
    "radio": "all hosts and the access point need it, and must be near enough for its rate",
    "aggregation": "computed as if exchanges were always full, so at best",
    "channels": "time on the fullest channel; hosts on different channels do not find each other",
    "domains": "the parts share the channel; hosts of different domains do not find each other",
    "middleware": "all hosts must change together",
}


@dataclass(frozen=True)
class Share:
    """How much of the airtime a message, a phase or a group of hosts takes.

    Parameters
    ----------
    kind : {"message", "phase", "group"}
        What it is.
    name : str
        What it is called.
    airtime : float
        Its airtime [s]: of a group, what it takes part in, so that without the group
        this much less would be on the air. Groups overlap; messages and phases do not.
    share : float
        The same as a part of all airtime [1].
    """

    kind: Literal["message", "phase", "group"]
    name: str
    airtime: float
    share: float


@dataclass(frozen=True)
class Remedy:
    """Something that would change what discovery costs, and by how much.

    Parameters
    ----------
    kind : str
        What is changed: processes, endpoints, multicast rate, radio, aggregation,
        channels, domains or middleware.
    what : str
        The change, in words that a sentence can start with.
    price : str
        What to mind.
    fleets : tuple of Fleet
        The changed fleet; when it is split, its parts.
    protocol : Protocol
        The middleware.
    wifi : Wifi
        The channel.
    before : float
        The utilization without it [1].
    utilization : float
        What it leads to [1]: seconds of airtime, of all parts on one channel.
    """

    kind: Kind
    what: str
    price: str
    fleets: tuple[Fleet, ...]
    protocol: Protocol
    wifi: Wifi
    before: float
    utilization: float

    @property
    def saved(self) -> float:
        """What it saves as a part of what there was before [1]; negative if it costs more."""
        return 1 - self.utilization / self.before if self.before else 0.0

    def sentence(self) -> str:
        """Return what it brings, in words."""
        if abs(self.saved) < _NOTHING:
            return f"{self.what} changes less than {_NOTHING:.1%}"
        before, after = self.before, self.utilization
        if self.saved < 0:
            return f"{self.what} adds {-self.saved:.0%}: {_time(before)} becomes {_time(after)}"
        if self.saved < _LARGE:
            return f"{self.what} cuts {self.saved:.0%}, to {_time(after)}"
        return f"{self.what} cuts {_time(before)} to {_time(after)} ({self.saved:.0%})"


@dataclass(frozen=True)
class Plan:
    """What discovery costs a fleet, what dominates, and what would help.

    Parameters
    ----------
    fleet : Fleet
        Who is on the channel.
    protocol : Protocol
        The middleware.
    wifi : Wifi
        The channel.
    utilization : float
        What discovery takes [1]: seconds of airtime, to be compared with the one second
        that each second has.
    shares : tuple of Share
        Messages, phases and groups, each kind with the largest first.
    remedies : tuple of Remedy
        What could be changed, what saves most first.
    left_out : tuple of str
        What could not be computed or changed, and why.
    """

    fleet: Fleet
    protocol: Protocol
    wifi: Wifi
    utilization: float
    shares: tuple[Share, ...]
    remedies: tuple[Remedy, ...]
    left_out: tuple[str, ...]

    def of_kind(self, kind: str) -> tuple[Share, ...]:
        """Return the shares of one kind: message, phase or group; the largest first."""
        return tuple(share for share in self.shares if share.kind == kind)

    def table(self) -> pd.DataFrame:
        """Return the remedies, what saves most first.

        Returns
        -------
        pandas.DataFrame
            One row a remedy, indexed by what it is, with columns kind, airtime_s [s] (which
            is utilization), saved [1], fits (whether it is less than one second) and price.
        """
        import pandas as pd

        return pd.DataFrame(
            {
                "remedy": [remedy.what for remedy in self.remedies],
                "kind": [remedy.kind for remedy in self.remedies],
                "airtime_s": [remedy.utilization for remedy in self.remedies],
                "saved": [remedy.saved for remedy in self.remedies],
                "fits": [remedy.utilization < 1 for remedy in self.remedies],
                "price": [remedy.price for remedy in self.remedies],
            }
        ).set_index("remedy")

    def shares_table(self) -> pd.DataFrame:
        """Return what takes the airtime: one row a message, phase and group."""
        import pandas as pd

        return pd.DataFrame(
            [(share.kind, share.name, share.airtime, share.share) for share in self.shares],
            columns=["kind", "name", "airtime_s", "share"],
        ).set_index("name")

    def to_dict(self) -> dict[str, Any]:
        """Return all of it as what JSON can hold: texts, numbers, lists and dictionaries."""
        return {
            "protocol": self.protocol.name,
            "wifi": self.wifi.name,
            "fleet": _groups(self.fleet),
            "utilization": self.utilization,
            "airtime_s": self.utilization,
            "fits": self.utilization < 1,
            "shares": [
                {
                    "kind": share.kind,
                    "name": share.name,
                    "airtime_s": share.airtime,
                    "share": share.share,
                }
                for share in self.shares
            ],
            "remedies": [
                {
                    "kind": remedy.kind,
                    "what": remedy.what,
                    "price": remedy.price,
                    "fleets": [_groups(fleet) for fleet in remedy.fleets],
                    "protocol": remedy.protocol.name,
                    "wifi": remedy.wifi.name,
                    "utilization": remedy.utilization,
                    "airtime_s": remedy.utilization,
                    "saved": remedy.saved,
                    "fits": remedy.utilization < 1,
                }
                for remedy in self.remedies
            ],
            "left_out": list(self.left_out),
        }

    def to_json(self) -> str:
        """Return all of it as JSON."""
        return json.dumps(self.to_dict(), indent=2, ensure_ascii=False)

    def picture_data(self) -> pd.DataFrame:
        """Return what `picture` draws: one row a bar, with its protocol and airtime_s [s]."""
        import pandas as pd

        bars = [("as it is", self.protocol.name, self.utilization)]
        bars += [(found.what, found.protocol.name, found.utilization) for found in self.remedies]
        return pd.DataFrame(bars, columns=["bar", "protocol", "airtime_s"])

    def picture(self) -> Figure:
        """Draw the airtime that each remedy leads to, beside what there is and one second."""
        from discostorm import figures

        return figures.remedies(self.picture_data())

    def advice(self) -> str:
        """Return what it costs, what dominates and what would help, in words."""
        hosts = sum(group.hosts for group in self.fleet.groups)
        message, phase = self.of_kind("message")[0], self.of_kind("phase")[0]
        groups = self.of_kind("group")
        fit = "so it fits" if self.utilization < 1 else "so it does not fit"
        lines = [
            f"{self.protocol.name} discovery of {_many(hosts, 'host')} with "
            f"{_many(self.fleet.processes(), 'process', 'es')} takes {_time(self.utilization)} "
            f"of airtime. Channel: {self.wifi.name}.",
            f"That is {_percent(self.utilization)} of each second, {fit}.",
            "",
            "What dominates:",
            f"- The message that takes most is {message.name}: {_part(message.share)}.",
            f"- The phase that takes most is {phase.name}: {_part(phase.share)}.",
        ]
        if len(groups) > 1:
            lines += [
                f"- The group {group.name} takes part in {_part(group.share)} of it."
                for group in groups[:_GROUPS]
            ]
        if len(groups) > _GROUPS:
            lines.append(f"- {_many(len(groups) - _GROUPS, 'further group')} less each.")
        helpful = [remedy for remedy in self.remedies if remedy.saved >= _NOTHING]
        if helpful:
            lines += ["", "What would help, most first:"]
        kinds: set[str] = set()
        for rank, remedy in enumerate(helpful, start=1):
            now_fits = "; that fits" if remedy.utilization < 1 <= self.utilization else ""
            lines.append(f"{rank:2}. {_capitalized(remedy.sentence())}{now_fits}.")
            if remedy.kind not in kinds:
                lines.append(f"    Mind: {remedy.price}.")
            kinds.add(remedy.kind)
        others = self.remedies[len(helpful) :]
        if others:
            lines += ["", "What would not help:" if helpful else "Nothing that was tried helps:"]
        lines += [f"- {_capitalized(remedy.sentence())}." for remedy in others]
        if self.left_out:
            lines += ["", "Left out:", *(f"- {reason}." for reason in self.left_out)]
        return "\n".join(map(_wrapped, lines))

    def __str__(self) -> str:
        return self.advice()


def plan(
    fleet: Fleet,
    protocol: Protocol = DDS,
    wifi: Wifi = PAPER,
    *,
    nodes: float | Sequence[float] | None = None,
) -> Plan:
    """Return what discovery costs a fleet, what dominates, and what would help.

    Each remedy changes one thing and leaves the rest; to combine them, plan again with
    what a `Remedy` holds. Composing keeps the endpoints. Endpoints are counted as DDS does.

    Parameters
    ----------
    fleet : Fleet
        Who is on the channel: numbers, with whole hosts.
    protocol : Protocol, optional
        `DDS`, `ZENOH`, or a table of your own.
    wifi : Wifi, optional
        The channel; the paper's if left out. A channel given by rates and overheads alone
        keeps its overheads when the radio is changed; one of `Radio` changes in
        all that its standard says.
    nodes : float or sequence of float, optional
        Nodes with parameter services in each process [1], at least 0; a sequence has one
        number for each group. Leaving the services out saves 12 endpoints a node. If left
        out, one node for each process with at least that many endpoints.

    Returns
    -------
    Plan
        With text (`Plan.advice`), table, picture and JSON.

    Raises
    ------
    ValueError
        If a count is out of range, hosts are not whole, or there are fewer endpoints than
        the parameter services of `nodes` have.
    TypeError
        If the fleet holds arrays or symbols, or an argument is not what it should be.

    References
    ----------
    Parameter services: rclcpp, branch humble, parameter_service.cpp (six services of two
    endpoints each, ``data/fleets/parameter_services.csv``). Composition: paper, Sec. IV-C.

    Examples
    --------
    >>> import discostorm as ds
    >>> plan = ds.plan(ds.Fleet.swarm(hosts=3, processes=8, endpoints=5), ds.DDS)
    >>> plan.remedies[0].sentence()
    'composing 8 processes into 1 cuts 1.38 s to 0.11 s (92%)'
    """
    _checks.instance("fleet", fleet, Fleet)
    _checks.instance("protocol", protocol, Protocol)
    _checks.instance("wifi", wifi, Wifi)
    as_fleet(fleet, None, None)  # raises if there are symbols
    for group in fleet.groups:
        _checks.one_each(zip(COUNTS, group.counts(), strict=True))
        _checks.whole(f"hosts{_of(group)}", group.hosts, LEAST["hosts"])
    before = float(utilization(protocol, fleet, wifi=wifi))
    remedies: list[Remedy] = []
    left_out: list[str] = []
    for found in _remedies(
        fleet, protocol, wifi, _nodes(fleet, nodes), " (assumed)" if nodes is None else ""
    ):
        if isinstance(found, str):
            left_out.append(found)
            continue
        kind, what, fleets, new_protocol, new_wifi = found
        parts = [float(utilization(new_protocol, part, wifi=new_wifi)) for part in fleets]
        after = max(parts) if kind == "channels" else sum(parts)
        remedies.append(
            Remedy(kind, what, _PRICE[kind], fleets, new_protocol, new_wifi, before, after)
        )
    return Plan(
        fleet,
        protocol,
        wifi,
        before,
        tuple(_shares(fleet, protocol, wifi, before)),
        tuple(sorted(remedies, key=lambda remedy: remedy.utilization)),
        tuple(left_out),
    )


def parameter_service_endpoints() -> int:
    """Return how many endpoints the parameter services of a node have [1]."""
    return sum(int(row["endpoints"]) for row in read_data("fleets/parameter_services.csv"))


def split(fleet: Fleet, parts: int) -> tuple[Fleet, ...]:
    """Return parts of a fleet as equal as whole hosts allow: they are dealt out in turn.

    Raises
    ------
    ValueError
        If there are fewer hosts than parts.
    """
    hosts = int(sum(group.hosts for group in fleet.groups))
    _checks.number("parts", parts, 1, hosts)
    dealt: list[list[HostGroup]] = [[] for _ in range(parts)]
    before = 0
    for group in fleet.groups:
        for part, groups in enumerate(dealt):
            own = len(range((part - before) % parts, int(group.hosts), parts))
            if own:
                groups.append(replace(group, hosts=own))
        before += int(group.hosts)
    return tuple(Fleet(tuple(groups)) for groups in dealt)


Change = tuple[Kind, str, tuple[Fleet, ...], Protocol, Wifi]


def _remedies(
    fleet: Fleet, protocol: Protocol, wifi: Wifi, nodes: Sequence[float], assumed: str
) -> Iterator[Change | str]:
    """Yield each change, or why there is none."""
    for found in chain(_other_fleets(fleet, nodes, assumed), _other_wifis(wifi)):
        if isinstance(found, str):
            yield found
            continue
        kind, what, new = found
        if isinstance(new, Fleet):
            yield kind, what, (new,), protocol, wifi
        else:
            yield kind, what, (fleet,), protocol, new
    hosts = sum(group.hosts for group in fleet.groups)
    for parts in PARTS:
        # A host that is alone on its channel has nobody to find: no remedy but a surrender.
        if 2 * parts > hosts:
            yield f"splitting into {parts} parts: not every part would have two hosts"
        else:
            pieces = split(fleet, parts)
            yield "channels", f"splitting onto {parts} channels", pieces, protocol, wifi
            yield "domains", f"splitting into {parts} domains", pieces, protocol, wifi
    for other in (DDS, ZENOH):
        if other != protocol:
            yield "middleware", f"switching to {other.name}", (fleet,), other, wifi


def _other_fleets(
    fleet: Fleet, nodes: Sequence[float], assumed: str
) -> Iterator[tuple[Kind, str, Fleet] | str]:
    many = [group for group in fleet.groups if group.processes > 1]
    if many:
        which = "the processes of each host"
        if len(many) == 1:
            of = f" of {many[0].name}" if len(fleet.groups) > 1 and many[0].name else ""
            which = f"{many[0].processes:,.10g} processes{of}"
        what = f"composing {which} into 1"
        try:
            composed = tuple(
                replace(group, processes=1, endpoints=group.processes * group.endpoints)
                for group in fleet.groups
            )
        except ValueError as error:
            yield f"{what}: {error}"
        else:
            yield "processes", what, Fleet(composed)
    each = parameter_service_endpoints()
    if any(nodes):
        fewer = (
            replace(group, endpoints=group.endpoints - each * own)
            for group, own in zip(fleet.groups, nodes, strict=True)
        )
        counts = " and ".join(f"{own:g}" for own in dict.fromkeys(nodes))
        noun = "node" if set(nodes) == {1} else "nodes"
        what = f"leaving out the parameter services of {counts} {noun} a process{assumed}"
        yield "endpoints", what, Fleet(tuple(fewer))
    else:
        yield f"parameter services: no process has any (those of a node are {each} endpoints)"


def _other_wifis(wifi: Wifi) -> Iterator[tuple[Kind, str, Wifi] | str]:
    linear = wifi.model == "linear"
    now = wifi.multicast.rate
    if now < MULTICAST_RATE:
        faster = (
            replace(wifi, multicast=Link(MULTICAST_RATE, wifi.multicast.overhead))
            if linear
            else _variant(wifi, multicast_rate=MULTICAST_RATE)
        )
        if faster is None:
            yield "multicast rate: known only of channels made by a Radio"
        else:
            rates = f"{MULTICAST_RATE / 1e6:g} instead of {now / 1e6:g} Mbit/s"
            yield "multicast rate", f"sending multicast at {rates}", faster
    for radio in RADIOS:
        preset = Radio(**radio, streams=STREAMS).wifi()
        if preset.unicast.rate <= wifi.unicast.rate:
            continue
        if linear:
            rates = f"{preset.unicast.rate / 1e6:.0f} instead of {wifi.unicast.rate / 1e6:.0f}"
            what = f"a faster radio ({preset.name}: {rates} Mbit/s)"
            link = Link(preset.unicast.rate, wifi.unicast.overhead)
            yield "radio", what, replace(wifi, unicast=link)
        else:
            kept: dict[str, Any] = {}
            if wifi.radio is not None:
                kept["aifsn"] = wifi.radio.aifsn
                if (wifi.radio.multicast_rate or 0) >= 6e6:
                    kept["multicast_rate"] = wifi.radio.multicast_rate
            if wifi.aggregation is not None:
                kept["mpdus"] = min(wifi.aggregation.mpdus, MPDUS)
            yield (
                "radio",
                f"another radio ({preset.name})",
                Radio(**radio, streams=STREAMS, **kept).wifi(),
            )
    if linear:
        yield (
            "aggregation: a channel given by rates and overheads alone does not say what it "
            "saves; take a preset"
        )
    elif wifi.aggregation is None or wifi.aggregation.mpdus < MPDUS:
        try:
            aggregated = _variant(wifi, mpdus=MPDUS)
        except ValueError as error:
            yield f"aggregation: {error}"
        else:
            if aggregated is None:
                yield "aggregation: known only of channels made by a Radio"
            else:
                yield "aggregation", f"aggregating up to {MPDUS} frames", aggregated


def _variant(wifi: Wifi, **changes: Any) -> Wifi | None:
    """Return the channel of its radio with changes; None if it is not that of its radio."""
    if wifi.radio is None or wifi.radio.wifi() != wifi:
        return None
    return replace(wifi.radio, name=None, **changes).wifi()


def _of(group: HostGroup) -> str:
    return f" of {group.name}" if group.name else ""


def _nodes(fleet: Fleet, nodes: float | Sequence[float] | None) -> tuple[float, ...]:
    """Return the nodes with parameter services in a process of each group."""
    each = parameter_service_endpoints()
    if nodes is None:
        return tuple(float(group.endpoints >= each) for group in fleet.groups)
    checked = _checks.numbers("nodes", nodes, 0)
    many = len(fleet.groups)
    own = [checked] * many if isinstance(checked, float) else checked.tolist()
    if not isinstance(checked, float) and checked.shape != (many,):
        raise ValueError(f"nodes must be one number, or one for each of {many} groups; got {nodes}")
    for group, count in zip(fleet.groups, own, strict=True):
        if count * each > group.endpoints:
            raise ValueError(
                f"nodes{_of(group)} must be at most {group.endpoints / each:g} for processes of "
                f"{group.endpoints:g} endpoints, as the parameter services of a node have "
                f"{each}; got {count:g}"
            )
    return tuple(own)


def _shares(fleet: Fleet, protocol: Protocol, wifi: Wifi, whole: float) -> Iterator[Share]:
    messages = [
        (row["message"], row["uplink_s"] + row["downlink_s"])
        for row in message_costs(protocol, fleet, wifi)
    ]
    yield from _largest("message", messages, whole)
    phases = [
        (phase, float(utilization(protocol, fleet, wifi=wifi, phase=phase)))
        for phase in protocol.phases
    ]
    yield from _largest("phase", phases, whole)
    rests = without_each(protocol, fleet, wifi)
    taking_part = [
        (name, whole - rest) for name, rest in zip(_group_names(fleet), rests, strict=True)
    ]
    yield from _largest("group", taking_part, whole)


def _largest(
    kind: Literal["message", "phase", "group"],
    airtimes: Iterable[tuple[str, float]],
    whole: float,
) -> Iterator[Share]:
    for name, airtime in sorted(airtimes, key=lambda item: -item[1]):
        yield Share(kind, name, airtime, airtime / whole if whole else 0.0)


def _group_names(fleet: Fleet) -> list[str]:
    given = {group.name for group in fleet.groups}
    names = []
    for index, group in enumerate(fleet.groups, start=1):
        name = group.name or f"group {index}"
        names.append(name if group.name or name not in given else f"{name} (unnamed)")
    return names


def _groups(fleet: Fleet) -> list[dict[str, Any]]:
    return [
        {"name": name} | dict(zip(COUNTS, map(float, group.counts()), strict=True))
        for name, group in zip(_group_names(fleet), fleet.groups, strict=True)
    ]


def _wrapped(line: str) -> str:
    """Return a line broken at 79 characters, but not between a number and its unit."""
    indent = " " * 4 * line.startswith(("- ", " ", "1"))
    glued = re.sub(r"(?<=\d) (?=m?s\b|Mbit/s)", "\u00a0", line)
    return textwrap.fill(glued, 79, subsequent_indent=indent).replace("\u00a0", " ")


def _capitalized(sentence: str) -> str:
    return sentence[0].upper() + sentence[1:]


def _part(share: float) -> str:
    return "nearly all" if 0.995 <= share < 1 else _percent(share)


def _percent(share: float) -> str:
    """Return a share to a percent, what is less than one to two digits, never 100% too early."""
    if 0.995 <= share < 1:
        return "just below 100%"
    if 0.01 <= share < HUGE or not share:
        return f"{share:,.0%}"
    return f"{100 * share:.2g}%"


def _many(count: float, noun: str, plural: str = "s") -> str:
    return f"{count:,.10g} {noun}{plural if count != 1 else ''}"


def _time(seconds: float) -> str:
    """Return a time to two digits or three, below a hundredth of a second in milliseconds."""
    if seconds < 0.01:
        return f"{1e3 * seconds:.3g} ms"
    if seconds < 10:
        return f"{seconds:.2f} s" if seconds >= 0.1 else f"{seconds:.3f} s"
    return f"{seconds:,.1f} s" if seconds < HUGE else f"{seconds:.3g} s"
