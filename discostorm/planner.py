"""What discovery costs a fleet, what dominates, and what would help, most first.

Every remedy is a changed fleet, protocol or Wi-Fi that goes through the same `utilization`;
no formula is stated here. For which protocols a kind of remedy works, what it costs otherwise
and whether all robots still find each other is data: ``data/vendors/remedies.csv``.
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

from discostorm import _checks, staggered, words
from discostorm.data import read_data
from discostorm.fleet import COUNTS, LEAST, Fleet, HostGroup, as_fleet
from discostorm.messages import PAPER_WINDOW, Message, Protocol
from discostorm.protocols import ARRANGED, DDS, MEASURED, PROTOCOLS, ZENOH
from discostorm.protocols.defaults import defaults
from discostorm.scalability import message_costs, utilization, without_each
from discostorm.wifi import PAPER, Radio, Wifi

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.figure import Figure

#: What can be changed and computed; ``data/vendors/remedies.csv`` has more, without a number.
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
#: Other radios: what they change, with at least so many streams.
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


@dataclass(frozen=True)
class Share:
    """How much of the airtime a message, a phase or a group of hosts takes.

    Parameters
    ----------
    kind : {"message", "phase", "group"}
        What it is.
    name : str
        What it is called.
    utilization : float
        What it takes of the window [1]: of a group, what it takes part in, so that without
        the group this much less would be on the air. Groups overlap; messages and phases do not.
    share : float
        The same as a part of all that discovery takes [1].
    """

    kind: Literal["message", "phase", "group"]
    name: str
    utilization: float
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
    whole : bool
        Whether all hosts still find each other.
    fleets : tuple of Fleet
        The changed fleet; when it is split, its parts.
    protocol : Protocol
        The middleware.
    wifi : Wifi
        The channel.
    before : float
        The utilization without it [1], on a channel of the same kind.
    utilization : float
        What it leads to [1]: of all parts on one channel; on several, of the fullest.
    window : float
        The seconds that are averaged [s]; infinity for the steady state.
    note : str
        What is compared, or left out of the number; empty if there is nothing to say.
    """

    kind: Kind
    what: str
    price: str
    whole: bool
    fleets: tuple[Fleet, ...]
    protocol: Protocol
    wifi: Wifi
    before: float
    utilization: float
    window: float = PAPER_WINDOW
    note: str = ""

    @property
    def saved(self) -> float:
        """What it saves as a part of what there was before [1]; negative if it costs more."""
        return 1 - self.utilization / self.before if self.before else 0.0

    def sentence(self) -> str:
        """Return what it brings, in words."""
        before, after = (_amount(value, self.window) for value in (self.before, self.utilization))
        if abs(self.saved) < _NOTHING:
            brings = f"changes less than {_NOTHING:.1%}"
        elif self.saved < 0:
            brings = f"adds {words.percent(-self.saved)}: {before} becomes {after}"
        else:
            brings = f"cuts {before} to {after} ({words.percent(self.saved)})"
        return f"{self.what} {brings}{'; ' * bool(self.note)}{self.note}"


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
    window : float
        The seconds that are averaged [s]; infinity for the steady state.
    utilization : float
        What discovery takes of them [1]; what is less than 1 fits.
    shares : tuple of Share
        Messages, phases and groups, each kind with the largest first.
    remedies : tuple of Remedy
        What could be changed, what saves most first; but those after which not all hosts
        find each other stand behind all others.
    left_out : tuple of str
        What does not apply or could not be changed, and why.
    simulated : tuple of str
        What helps by the simulator: it changes when frames are sent, not how many.
    not_computed : tuple of str
        What might help and has no number yet: what it would do, and why there is none.
    """

    fleet: Fleet
    protocol: Protocol
    wifi: Wifi
    window: float
    utilization: float
    shares: tuple[Share, ...]
    remedies: tuple[Remedy, ...]
    left_out: tuple[str, ...]
    simulated: tuple[str, ...]
    not_computed: tuple[str, ...]

    def of_kind(self, kind: str) -> tuple[Share, ...]:
        """Return the shares of one kind: message, phase or group; the largest first."""
        return tuple(share for share in self.shares if share.kind == kind)

    def table(self) -> pd.DataFrame:
        """Return the remedies in their order.

        Returns
        -------
        pandas.DataFrame
            One row a remedy, indexed by what it is, with columns kind, before and utilization
            [1], saved [1], fits (whether it is less than the window), all_find_each_other,
            price and note.
        """
        import pandas as pd

        return pd.DataFrame(
            {
                "remedy": [remedy.what for remedy in self.remedies],
                "kind": [remedy.kind for remedy in self.remedies],
                "before": [remedy.before for remedy in self.remedies],
                "utilization": [remedy.utilization for remedy in self.remedies],
                "saved": [remedy.saved for remedy in self.remedies],
                "fits": [words.fits(remedy.utilization) for remedy in self.remedies],
                "all_find_each_other": [remedy.whole for remedy in self.remedies],
                "price": [remedy.price for remedy in self.remedies],
                "note": [remedy.note for remedy in self.remedies],
            }
        ).set_index("remedy")

    def shares_table(self) -> pd.DataFrame:
        """Return what takes the channel: one row a message, phase and group."""
        import pandas as pd

        return pd.DataFrame(
            [(share.kind, share.name, share.utilization, share.share) for share in self.shares],
            columns=["kind", "name", "utilization", "share"],
        ).set_index("name")

    def to_dict(self) -> dict[str, Any]:
        """Return all of it as what JSON can hold: texts, numbers, lists and dictionaries.

        The steady state has the window None, as JSON has no infinity.
        """
        return {
            "protocol": self.protocol.name,
            "wifi": self.wifi.name,
            "fleet": _groups(self.fleet),
            "window_s": self.window if math.isfinite(self.window) else None,
            "utilization": self.utilization,
            "fits": words.fits(self.utilization),
            "shares": [
                {
                    "kind": share.kind,
                    "name": share.name,
                    "utilization": share.utilization,
                    "share": share.share,
                }
                for share in self.shares
            ],
            "remedies": [
                {
                    "kind": remedy.kind,
                    "what": remedy.what,
                    "price": remedy.price,
                    "note": remedy.note,
                    "all_find_each_other": remedy.whole,
                    "fleets": [_groups(fleet) for fleet in remedy.fleets],
                    "protocol": remedy.protocol.name,
                    "wifi": remedy.wifi.name,
                    "before": remedy.before,
                    "utilization": remedy.utilization,
                    "saved": remedy.saved,
                    "fits": words.fits(remedy.utilization),
                }
                for remedy in self.remedies
            ],
            "simulated": list(self.simulated),
            "not_computed": list(self.not_computed),
            "left_out": list(self.left_out),
        }

    def to_json(self) -> str:
        """Return all of it as JSON."""
        return json.dumps(self.to_dict(), indent=2, ensure_ascii=False)

    def picture_data(self) -> pd.DataFrame:
        """Return what `picture` draws: one row a bar, with its protocol and utilization [1].

        Where a remedy is compared with another channel than the plan's, the bar before it is
        that of the fleet as it is on that channel.
        """
        import pandas as pd

        bars = [("as it is", self.protocol.name, self.utilization)]
        by_standard = [remedy for remedy in self.remedies if remedy.before != self.utilization]
        if by_standard:
            timed = "as it is, by the standard's timing"
            bars.append((timed, self.protocol.name, by_standard[0].before))
        for found in self.remedies:
            timed = ", by the standard's timing" if found in by_standard else ""
            bars.append((found.what + timed, found.protocol.name, found.utilization))
        return pd.DataFrame(bars, columns=["bar", "protocol", "utilization"])

    def picture(self) -> Figure:
        """Draw what each remedy leads to, beside what there is and the whole channel."""
        from discostorm import figures

        return figures.remedies(self.picture_data())

    def advice(self) -> str:
        """Return what it costs, what dominates and what would help, in words."""
        helps: list[Remedy] = []
        harms: list[Remedy] = []
        for remedy in self.remedies:
            (helps if remedy.saved >= _NOTHING else harms).append(remedy)
        lines = [*self._cost_in_words(), "", "What dominates:", *self._shares_in_words()]
        kept = [remedy for remedy in helps if remedy.whole]
        split = [remedy for remedy in helps if not remedy.whole]
        if kept:
            lines += ["", "What would help, most first:", *self._ranked(kept, 1)]
        if harms:
            lines += ["", "What would not help:" if helps else "Nothing that was tried helps:"]
        lines += [f"- {words.capitalized(remedy.sentence())}." for remedy in harms]
        if split:
            lines += ["", "What would help, but not all hosts would find each other any more:"]
            lines += self._ranked(split, len(kept) + 1)
        for title, reasons in (
            ("Simulated:", self.simulated),
            ("Not computed yet:", self.not_computed),
            ("Left out:", self.left_out),
        ):
            if reasons:
                lines += ["", title, *(f"- {words.capitalized(reason)}." for reason in reasons)]
        return "\n".join(map(words.wrapped, lines))

    def __str__(self) -> str:
        return self.advice()

    def _cost_in_words(self) -> Iterator[str]:
        hosts = sum(group.hosts for group in self.fleet.groups)
        takes = _amount(self.utilization, self.window)
        fit = "so it fits" if words.fits(self.utilization) else "so it does not fit"
        yield (
            f"{self.protocol.name} discovery of {words.many(hosts, 'host')} with "
            f"{words.many(self.fleet.processes(), 'process', 'es')} takes {takes}"
            f"{' of airtime' * math.isfinite(self.window)}. Channel: {self.wifi.name}."
        )
        share = words.percent(self.utilization)
        if math.isinf(self.window):
            yield f"That is {share} of the channel in the steady state, {fit}."
        elif self.window == PAPER_WINDOW:
            yield f"All charged to one second, that is {share} of it, {fit}."
        else:
            yield f"All charged to the first {self.window:g} s, that is {share} of them, {fit}."
        exchanges = "an exchange of its own"
        if self.wifi.aggregation is not None:
            exchanges = f"an exchange of {self.wifi.aggregation.mpdus} like it, as far as they fit"
        yield (f"Counted with nothing lost, no collisions and each unicast message in {exchanges}.")
        if self.protocol.name in MEASURED | ARRANGED:
            yield (
                f"The table of {self.protocol.name} is what was measured of the product in a lab, "
                "in small swarms that began all at once; of the endpoints "
                f"{words.percent(self.fleet.matching)} have names that match in all processes."
            )
        if self.protocol.repeats:
            papers = [message.name for message in self.protocol.messages if _of_paper(message)]
            if papers:
                yield (
                    f"The table of {self.protocol.name} counts {words.listed(papers)} as the paper "
                    "does; what the product packs together, adds or leaves out is not in it."
                )
            if math.isfinite(self.window):
                yield (
                    "Of what is sent more than once, all of the start is charged to this time, "
                    "and what is repeated counts with its rate: an upper bound of the count."
                )
        if any(remedy.before != self.utilization for remedy in self.remedies):
            before = next(r.before for r in self.remedies if r.before != self.utilization)
            yield (
                f"Changes of the channel are compared by the standard's timing, by which this "
                f"fleet takes {_amount(before, self.window)} as it is."
            )

    def _shares_in_words(self) -> Iterator[str]:
        for kind in ("message", "phase"):
            largest = self.of_kind(kind)[0]
            yield f"- The {kind} that takes most is {largest.name}: {words.part(largest.share)}."
        groups = self.of_kind("group")
        if len(groups) > 1:
            for group in groups[:_GROUPS]:
                yield f"- The group {group.name} takes part in {words.part(group.share)} of it."
        if len(groups) > _GROUPS:
            rest = len(groups) - _GROUPS
            yield (
                f"- {words.many(rest, 'further group')} {'take' if rest > 1 else 'takes'} part in "
                f"at most {words.part(groups[_GROUPS].share)}{' each' * (rest > 1)}."
            )

    @staticmethod
    def _ranked(remedies: Sequence[Remedy], first: int) -> Iterator[str]:
        """Yield the remedies with their places; what to mind with the first of each price."""
        told: set[str] = set()
        for rank, remedy in enumerate(remedies, start=first):
            now = words.fits(remedy.utilization) and not words.fits(remedy.before)
            yield f"{rank:2}. {words.capitalized(remedy.sentence())}{'; that fits' * now}."
            if remedy.price not in told:
                yield f"    Mind: {remedy.price}."
            told.add(remedy.price)


def family(protocol: Protocol) -> str | None:
    """Return of which family of ``data/vendors/families.csv`` a table is: by its first message.

    None if it is of none, as a table of your own may be.

    Examples
    --------
    >>> import discostorm as ds
    >>> family(ds.DDS), family(ds.PROTOCOLS["Zenoh peer"])
    ('DDS', 'Zenoh')
    """
    first = protocol.messages[0].name
    for row in read_data("vendors/families.csv"):
        if row["first_message"] == first:
            return row["family"]
    return None


def plan(
    fleet: Fleet,
    protocol: Protocol = DDS,
    wifi: Wifi = PAPER,
    *,
    nodes: float | Sequence[float] | None = None,
    window: float = PAPER_WINDOW,
) -> Plan:
    """Return what discovery costs a fleet, what dominates, and what would help.

    Each remedy changes one thing and leaves the rest; to combine them, plan again with
    what a `Remedy` holds. Composing keeps the endpoints. Endpoints are counted as DDS does.

    Parameters
    ----------
    fleet : Fleet
        Who is on the channel: numbers, with whole hosts.
    protocol : Protocol, optional
        One of `PROTOCOLS`, or a table of your own. The paper's tables are compared with each
        other, and so are those with periods.
    wifi : Wifi, optional
        The channel; the paper's if left out. What is changed is its radio (`Wifi.radio`), with
        all that the standard says. On the paper's channel both sides of such a comparison have
        the standard's timing; a channel that is not that of a radio is not changed.
    nodes : float or sequence of float, optional
        Nodes with parameter services in each process [1], at least 0; a sequence has one
        number for each group. Leaving the services out saves 12 endpoints a node. If left
        out, those of the groups; where these have none, one node for each process with at
        least that many endpoints.
    window : float, optional
        The seconds that are averaged [s], above 0; the paper's one if left out, infinity for
        the steady state.

    Returns
    -------
    Plan
        With text (`Plan.advice`), table, picture and JSON.

    Raises
    ------
    ValueError
        If a count or the window is out of range, hosts are not whole, or there are fewer
        endpoints than the parameter services of `nodes` have.
    TypeError
        If the fleet holds arrays or symbols, or an argument is not what it should be.

    References
    ----------
    Parameter services: rclcpp, branch humble, parameter_service.cpp (six services of two
    endpoints each, ``data/fleets/parameter_services.csv``). For which protocols a remedy works:
    ``data/vendors/remedies.csv``, each row with its source.

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
    _checks.one_each([("window", window)])
    as_fleet(fleet, None, None)  # raises if there are symbols
    for group in fleet.groups:
        _checks.one_each(zip(COUNTS, group.counts(), strict=True))
        _checks.whole(f"hosts{_of(group)}", group.hosts, LEAST["hosts"])
    own = _nodes(fleet, nodes)
    guessed = nodes is None and any(group.nodes is None for group in fleet.groups)

    def cost(members: Fleet, table: Protocol = protocol, channel: Wifi = wifi) -> float:
        return float(utilization(table, members, wifi=channel, window=window))

    before = cost(fleet)
    remedies: list[Remedy] = []
    left_out: list[str] = []
    for found in _changes(fleet, protocol, wifi, own, " (assumed)" if guessed else ""):
        if isinstance(found, str):
            left_out.append(found)
            continue
        parts = [cost(part, found.protocol, found.wifi) for part in found.fleets]
        after = max(parts) if found.kind == "channels" else sum(parts)
        row = _row(found.kind, family(found.protocol))
        assert row is not None, found.kind
        note = found.note
        if found.kind == "middleware":
            note = _sessions(
                protocol, found.protocol, before, after, lambda t: cost(fleet, t), window
            )
        remedies.append(
            Remedy(
                found.kind,
                found.what,
                row["price"],
                row["all_find_each_other"] == "yes",
                found.fleets,
                found.protocol,
                found.wifi,
                before if found.base == wifi else cost(fleet, protocol, found.base),
                after,
                float(window),
                note,
            )
        )
    missing, inapplicable = _without_number(protocol)
    return Plan(
        fleet,
        protocol,
        wifi,
        float(window),
        before,
        tuple(_shares(fleet, protocol, wifi, float(window), before)),
        tuple(sorted(remedies, key=lambda remedy: (not remedy.whole, -remedy.saved))),
        (*left_out, *inapplicable),
        tuple(_staggered(fleet, protocol, wifi)),
        missing,
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
    return tuple(Fleet(tuple(groups), fleet.matching) for groups in dealt)


class _Change(NamedTuple):
    """A change to compute."""

    kind: Kind
    what: str
    fleets: tuple[Fleet, ...]
    protocol: Protocol
    wifi: Wifi
    #: The channel without the change.
    base: Wifi
    note: str = ""


def _changes(
    fleet: Fleet, protocol: Protocol, wifi: Wifi, nodes: Sequence[float], assumed: str
) -> Iterator[_Change | str]:
    """Yield each change, or why there is none."""
    for changed in _other_fleets(fleet, nodes, assumed):
        if isinstance(changed, str):
            yield changed
        else:
            kind, what, members = changed
            yield _Change(kind, what, (members,), protocol, wifi, wifi)
    radio = _radio(wifi)
    if isinstance(radio, str):
        yield f"another radio, multicast rate and aggregation: {radio}"
    else:
        base = replace(radio.wifi(), name=wifi.name)
        by = "" if base == wifi else "both by the standard's timing"
        for found in _other_radios(radio, by):
            if isinstance(found, str):
                yield found
            else:
                kind, what, other, note = found
                yield _Change(kind, what, (fleet,), protocol, other.wifi(), base, note)
    hosts = sum(group.hosts for group in fleet.groups)
    row = _row("domains", family(protocol))
    for parts in PARTS:
        # A host that is alone on its channel has nobody to find: no remedy but a surrender.
        if 2 * parts > hosts:
            yield f"splitting into {parts} parts: not every part would have two hosts"
            continue
        pieces = split(fleet, parts)
        yield _Change("channels", f"splitting onto {parts} channels", pieces, protocol, wifi, wifi)
        if row is not None and row["works"] == "computed":
            what = f"splitting into {parts} domains"
            yield _Change("domains", what, pieces, protocol, wifi, wifi)
    # On Wi-Fi nobody gets what a product sends where it takes the network for wired, and a
    # proposal is no middleware to switch to.
    wired = [table.wired for table in PROTOCOLS.values()]
    for table in PROTOCOLS.values():
        if table == protocol or table in wired or family(table) is None:
            continue
        if table.name in ARRANGED:  # no middleware of its own
            continue
        if _alike(table, protocol):
            what = f"switching to {table.name}"
            yield _Change("middleware", what, (fleet,), table, wifi, wifi)


def _alike(one: Protocol, other: Protocol) -> bool:
    """Return whether two tables count alike: as the paper, with periods, or as products do."""
    measured = [table.name in MEASURED | ARRANGED for table in (one, other)]
    return one.repeats == other.repeats and measured[0] == measured[1]


def _row(kind: str, of: str | None) -> dict[str, str] | None:
    """Return what the data say of a kind of remedy for a family, None if they do not."""
    rows = [row for row in read_data("vendors/remedies.csv") if row["kind"] == kind]
    found = [row for row in rows if row["family"] == of]
    return next(iter(found + [row for row in rows if row["family"] == "any"]), None)


def _staggered(fleet: Fleet, protocol: Protocol, wifi: Wifi) -> Iterator[str]:
    """Yield what a staggered start of the fleet is, and what the simulator says of small robots."""
    own = family(protocol)
    row = _row("staggered start", own)
    assert row is not None
    gains = []
    for name in [own] if own else ["DDS", "Zenoh"]:
        found: dict[int, dict[str, dict[str, str]]] = {}
        for one in read_data("simulated/staggered.csv"):
            if (one["protocol"], one["radio"], one["mpdus"]) == (name, "n", "1"):
                found.setdefault(int(one["hosts"]), {})[one["start"]] = one
        for hosts, starts in sorted(found.items())[-2:]:
            together, rule = (
                float(starts[start]["convergence_time_s"]) for start in ("together", "rule")
            )
            gains.append(f"{hosts} with {name} in {rule:.0f} s instead of {together:.0f} s")
    robot, window = starts["rule"], staggered.window(protocol, fleet, wifi=wifi)
    yield (
        f"{row['title']}: {row['why']}; the rule of thumb for this fleet is a window of "
        f"{words.duration(window)}; small robots ({robot['processes']} processes with "
        f"{robot['endpoints']} endpoints, default queues, the paper's counts with recovery) all "
        f"know each other, {words.listed(gains)}; mind: {row['price']}"
    )


def _without_number(protocol: Protocol) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Return what has no number yet, and what does not work or is not known to."""
    own = family(protocol)
    rows = read_data("vendors/remedies.csv")
    titles = {row["kind"]: row["title"] for row in rows}
    missing, inapplicable, unknown = [], [], []
    for kind, title in titles.items():
        row = _row(kind, own)
        if row is None and own is None:
            unknown.append(title)
        elif row is None:
            others = words.listed([found["family"] for found in rows if found["kind"] == kind])
            inapplicable.append(f"{title}: there is none in {own}, but in {others}")
        elif row["works"] == "no":
            inapplicable.append(f"{title}: {row['why']}")
        elif row["works"] == "no table":
            missing.append(f"{title}: {row['why']}; no number, as {row['no_number']}")
    if unknown:
        known = [f"{r['first_message']} ({r['family']})" for r in read_data("vendors/families.csv")]
        inapplicable.append(
            f"{words.listed(unknown)}: not known for {protocol.name}, as the first message of its "
            f"table is neither {' nor '.join(known)}"
        )
    return tuple(missing), tuple(inapplicable)


def _other_fleets(
    fleet: Fleet, nodes: Sequence[float], assumed: str
) -> Iterator[tuple[Kind, str, Fleet] | str]:
    many = [group for group in fleet.groups if group.processes > 1]
    if many:
        which = "the processes of each host"
        if len(many) == 1:
            of = _of(many[0]) if len(fleet.groups) > 1 else ""
            which = f"{many[0].processes:,.10g} processes{of}"
        what = f"composing {which} into 1"
        try:
            composed = tuple(
                replace(
                    group,
                    processes=1,
                    endpoints=group.processes * group.endpoints,
                    nodes=None if group.nodes is None else group.processes * group.nodes,
                )
                for group in fleet.groups
            )
        except ValueError as error:
            yield f"{what}: {error}"
        else:
            yield "processes", what, Fleet(composed, fleet.matching)
    else:
        yield "composing: each host has one process already"
    each = parameter_service_endpoints()
    if any(nodes):
        fewer = (
            replace(group, endpoints=group.endpoints - each * own, nodes=0)
            for group, own in zip(fleet.groups, nodes, strict=True)
        )
        counts = " and ".join(f"{own:.3g}" for own in dict.fromkeys(nodes))
        noun = "node" if set(nodes) == {1} else "nodes"
        what = f"leaving out the parameter services of {counts} {noun} a process{assumed}"
        yield "endpoints", what, Fleet(tuple(fewer), fleet.matching)
    else:
        yield f"parameter services: no process has any (those of a node are {each} endpoints)"


def _radio(wifi: Wifi) -> Radio | str:
    """Return the radio whose channel it is, or why none is known."""
    if wifi.radio is None:
        return (
            "the channel has rates and overheads but no Radio, so that waiting, preambles and "
            "symbols of another one cannot be compared with it"
        )
    papers = (PAPER.unicast, PAPER.multicast, PAPER.aggregation)
    if (wifi.unicast, wifi.multicast, wifi.aggregation) == papers:
        return wifi.radio
    if replace(wifi.radio.wifi(), name=wifi.name) == wifi:
        return wifi.radio
    return (
        "the channel was changed by hand and is no longer that of its Radio, so that it cannot "
        "be compared with that of another one"
    )


def _other_radios(radio: Radio, by: str) -> Iterator[tuple[Kind, str, Radio, str] | str]:
    if radio.basic_rate < MULTICAST_RATE:
        what = (
            f"sending multicast at {MULTICAST_RATE / 1e6:g} instead of "
            f"{radio.basic_rate / 1e6:g} Mbit/s"
        )
        yield "multicast rate", what, replace(radio, multicast_rate=MULTICAST_RATE, name=None), by
    for changes in RADIOS:
        other = _another(radio, changes)
        if other.rate > radio.rate:
            what = f"another radio ({other.wifi().name})"
            yield "radio", what, other, _compared(radio, other, by)
    most = _most_mpdus(radio.standard)
    if most == 1:
        yield f"aggregation: {radio.standard} has none"
    elif radio.mpdus < MPDUS:
        yield (
            "aggregation",
            f"aggregating up to {MPDUS} frames",
            replace(radio, mpdus=MPDUS, name=None),
            by,
        )


def _another(radio: Radio, changes: dict[str, Any]) -> Radio:
    """Return another radio at its fastest, with the settings of the one there is."""
    rate = radio.multicast_rate
    return Radio(
        **changes,
        streams=max(STREAMS, int(radio.streams)),
        # DSSS rates are of 2.4 GHz alone.
        multicast_rate=rate if rate and rate >= Radio("802.11a").basic_rate else None,
        aifsn=radio.aifsn,
        mpdus=min(int(radio.mpdus), _most_mpdus(changes["standard"])),
        start_spacing=radio.start_spacing,
    )


def _most_mpdus(standard: str) -> int:
    """Return how many frames a standard allows in an A-MPDU [1]; 1 if it has none."""
    rows = (row for row in read_data("wifi/ampdu.csv") if row["standard"] == standard)
    return max((int(row["most_mpdus"]) for row in rows), default=1)


def _compared(old: Radio, new: Radio, by: str) -> str:
    """Return what another radio changes: rates, and what an exchange costs beside its data."""
    before, after = old.wifi(), new.wifi()
    rates = _instead(after.unicast.rate / 1e6, before.unicast.rate / 1e6, "Mbit/s")
    was, becomes = ((wifi.aggregation or wifi.unicast).overhead * 1e6 for wifi in (before, after))
    told = [rates, f"{_instead(becomes, was, 'µs')} of overhead an exchange"]
    if new.basic_rate != old.basic_rate:
        multicast = _instead(new.basic_rate / 1e6, old.basic_rate / 1e6, "Mbit/s")
        told.append(f"multicast at {multicast}")
    return f"instead of {before.name}{', ' * bool(by)}{by}: {words.listed(told)}"


def _instead(new: float, old: float, unit: str) -> str:
    new_text, old_text = f"{new:.0f}", f"{old:.0f}"
    return f"{new_text} {f'instead of {old_text} ' * (new_text != old_text)}{unit}"


def _sessions(
    old: Protocol,
    new: Protocol,
    before: float,
    after: float,
    cost: Callable[[Protocol], float],
    window: float,
) -> str:
    """Return what Zenoh's count leaves out beside what switching to or from it changes."""
    if (family(old) == "Zenoh") == (family(new) == "Zenoh"):
        return ""
    if any(message.kind == "Init" for table in (old, new) for message in table.messages):
        return ""  # it counts them
    one, both = (cost(_openings(sides)) for sides in (1, 2))
    if not one:
        return ""
    to_zenoh = family(new) == "Zenoh"
    more = after - before if to_zenoh else before - after
    if more >= 0:
        so = "which makes the gap larger"
    elif more + both < 0:
        so = "which does not close the gap"
    else:
        so = "so that it is not settled which of the two takes less"
    adds = [_amount(value, window) for value in (one, both)]
    return (
        f"the count leaves out that Zenoh opens sessions: {adds[0]} more if one side dials, "
        f"{adds[1]} if both do, beside a gap of {_amount(abs(more), window)}, {so}"
    )


def _openings(sides: int) -> Protocol:
    """Return what opens Zenoh's sessions if so many sides dial, each as long as a KeepAlive."""
    messages = defaults("Zenoh")["session_messages"]
    opening = replace(
        ZENOH.message("KeepAlive"),
        name="SessionOpening",
        # A session joins two processes, which are two ordered pairs.
        per_unit=sides * messages / 2,
        answers=None,
    )
    return Protocol("Zenoh's sessions", (opening,))


def _of_paper(message: Message) -> bool:
    return any(message in table.messages for table in (DDS, ZENOH))


def _of(group: HostGroup) -> str:
    return f" of {group.name}" if group.name else ""


def _nodes(fleet: Fleet, nodes: float | Sequence[float] | None) -> tuple[float, ...]:
    """Return the nodes with parameter services in a process of each group."""
    each = parameter_service_endpoints()
    many = len(fleet.groups)
    if nodes is None:
        own = [
            float(group.endpoints >= each) if group.nodes is None else group.nodes
            for group in fleet.groups
        ]
    else:
        checked = _checks.numbers("nodes", nodes, 0)
        if not isinstance(checked, float) and checked.shape != (many,):
            raise ValueError(
                f"nodes must be one number, or one for each of {many} groups; got {nodes}"
            )
        own = [checked] * many if isinstance(checked, float) else checked.tolist()
    for group, count in zip(fleet.groups, own, strict=True):
        if count * each > group.endpoints:
            raise ValueError(
                f"nodes{_of(group)} must be at most {group.endpoints / each:g} for processes of "
                f"{group.endpoints:g} endpoints, as the parameter services of a node have "
                f"{each}; got {count:g}"
            )
    return tuple(own)


def _shares(
    fleet: Fleet, protocol: Protocol, wifi: Wifi, window: float, whole: float
) -> Iterator[Share]:
    messages = [
        (row["message"], row["uplink_s"] + row["downlink_s"])
        for row in message_costs(protocol, fleet, wifi, window)
    ]
    yield from _largest("message", messages, whole)
    phases = [
        (phase, float(utilization(protocol, fleet, wifi=wifi, window=window, phase=phase)))
        for phase in protocol.phases
    ]
    yield from _largest("phase", phases, whole)
    rests = without_each(protocol, fleet, wifi, window)
    taking_part = [(name, whole - rest) for name, rest in zip(fleet.names, rests, strict=True)]
    yield from _largest("group", taking_part, whole)


def _largest(
    kind: Literal["message", "phase", "group"],
    parts: Iterable[tuple[str, float]],
    whole: float,
) -> Iterator[Share]:
    for name, taken in sorted(parts, key=lambda item: -item[1]):
        yield Share(kind, name, taken, taken / whole if whole else 0.0)


def _groups(fleet: Fleet) -> list[dict[str, Any]]:
    return [
        {"name": name} | dict(zip(COUNTS, map(float, group.counts()), strict=True))
        for name, group in zip(fleet.names, fleet.groups, strict=True)
    ]


def _amount(utilization: float, window: float) -> str:
    """Return the airtime of the window in seconds, in the steady state the share of the time."""
    if math.isinf(window):
        return words.percent(utilization) + " of the time"
    return words.duration(utilization * window)
