"""What could be changed: each remedy as a changed fleet, table or channel, to be computed.

For which protocols a kind of remedy works, what it costs otherwise, how hard it is, what fails
when and whether all robots still find each other is data: ``data/vendors/remedies.csv``. The
planner says what each change brings, alone and combined.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import cache
from typing import Any

from discostorm import _checks, words
from discostorm.data import read_data
from discostorm.fleet import Fleet, HostGroup, check_nodes
from discostorm.messages import Message, Protocol, Schedule
from discostorm.protocols import ARRANGED, DDS, PROTOCOLS, ZENOH
from discostorm.robots import likely_nodes, parameter_service_endpoints, shared_endpoints
from discostorm.wifi import PAPER, Radio, Wifi

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


def family(protocol: Protocol) -> str | None:
    """Return of which family of ``data/vendors/families.csv`` a table is.

    That is told by its first message, of an arrangement of servers, routers or peers by the
    product. None if it is of none, as a table of your own may be.

    Examples
    --------
    >>> import discostorm as ds
    >>> family(ds.DDS), family(ds.PROTOCOLS["Zenoh peer"])
    ('DDS', 'Zenoh')
    """
    for row in _arrangements():
        if row["table"] == protocol.name:
            return row["family"]
    first = PROTOCOLS.get(protocol.name, protocol).messages[0].name
    for row in read_data("vendors/families.csv"):
        if row["first_message"] == first:
            return row["family"]
    return None


@cache
def _arrangements() -> tuple[dict[str, str], ...]:
    """Return the remedies that put the table of another arrangement in place of a product's."""
    return tuple(row for row in read_data("vendors/remedies.csv") if row["table"] and row["base"])


def product(protocol: Protocol) -> str | None:
    """Return of which product a table as built is, as ``data/vendors/products.csv`` says."""
    name = next((row["base"] for row in _arrangements() if row["table"] == protocol.name), None)
    for row in read_data("vendors/products.csv"):
        if row["protocol"] == (name or protocol.name):
            return row["defaults"]
    return None


@dataclass(frozen=True)
class Setting:
    """A fleet, its middleware and its channel."""

    fleet: Fleet
    protocol: Protocol
    wifi: Wifi
    #: The fleet with some changes, made once.
    fleets: dict[tuple[Change, ...], Fleet] = field(default_factory=dict, compare=False)

    def after(self, steps: Sequence[Change]) -> Setting:
        """Return it with all of these changes."""
        protocol, radio = self.protocol, self.wifi.radio
        changing = tuple(step for step in steps if step.fleet)
        if changing not in self.fleets:
            fleet = self.fleet
            for step in changing:
                assert step.fleet is not None
                fleet = step.fleet(fleet)
            self.fleets[changing] = fleet
        for step in steps:
            protocol = step.table or protocol
            if step.radio:
                assert radio is not None
                radio = step.radio(radio)
        wifi = self.wifi if radio in (None, self.wifi.radio) else radio.wifi()
        return Setting(self.fleets[changing], protocol, wifi)

    def before(self, steps: Sequence[Change]) -> Setting:
        """Return what these changes are compared with: tables and channels of the same kind."""
        protocol = next((step.base for step in steps if step.base), self.protocol)
        wifi = self.wifi
        if any(step.radio for step in steps):
            assert wifi.radio is not None
            wifi = replace(wifi.radio.wifi(), name=wifi.name)
        return Setting(self.fleet, protocol, wifi)


@dataclass(frozen=True, eq=False)
class Change:
    """A change to compute; of one ``slot`` a combination has one at most."""

    kind: str
    what: str
    slot: str
    fleet: Callable[[Fleet], Fleet] | None = None
    parts: tuple[Fleet, ...] = ()
    table: Protocol | None = None
    #: The table without the change, if another than the plan's.
    base: Protocol | None = None
    radio: Callable[[Radio], Radio] | None = None
    #: What is to be said of the change alone, and what in a combination, too.
    note: str = ""
    by: str = ""
    steps: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "steps", self.steps or (self.kind,))


#: In this order changes are applied and told: whatever one radio is exchanged for, multicast rate
#: and aggregation are those that were asked for.
SLOTS = ("endpoints", "processes", "table", "radio", "multicast rate", "aggregation")
AIR = ("radio", "multicast rate", "aggregation")


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


def changes_of(base: Setting, nodes: Sequence[float], assumed: str) -> Iterator[Change | str]:
    """Yield each change, or why there is none."""
    fleet, protocol, wifi = base.fleet, base.protocol, base.wifi
    yield from _other_fleets(fleet, nodes, assumed)
    yield from _other_tables(protocol)
    radio = _radio(wifi)
    if isinstance(radio, str):
        yield f"another radio, multicast rate and aggregation: {radio}"
    else:
        timed = replace(radio.wifi(), name=wifi.name) != wifi
        yield from _other_radios(radio, "both by the standard's timing" if timed else "")
    hosts = sum(group.hosts for group in fleet.groups)
    row = row_of("domains", family(protocol))
    for parts in PARTS:
        # A host that is alone on its channel has nobody to find: no remedy but a surrender.
        if 2 * parts > hosts:
            yield f"splitting into {parts} parts: not every part would have two hosts"
            continue
        pieces = split(fleet, parts)
        yield Change("channels", f"splitting onto {parts} channels", "parts", parts=pieces)
        if row is not None and row["works"] == "computed":
            yield Change("domains", f"splitting into {parts} domains", "parts", parts=pieces)
    yield Change(
        "staggered start", "starting one after the other", "time", note=_staggered(protocol)
    )


def _other_tables(protocol: Protocol) -> Iterator[Change | str]:
    """Yield other tables: of another arrangement, with calmer announcements, of other middleware.

    What has the paper's counts is compared with tables as built by the product's table as built.
    """
    own, built = product(protocol), product(protocol) is not None
    arranged = protocol.name in {row["table"] for row in _arrangements()}
    for row in _arrangements():
        table, before = PROTOCOLS.get(row["table"]), PROTOCOLS[row["base"]]
        if table is None or table == protocol:
            continue
        other = built and product(before) != own
        if row["family"] != family(protocol) and not other:
            continue
        by = (
            ""
            if before == protocol or arranged
            else f"both as {before.name.replace(', ', ' with ')} was measured"
        )
        change = Change(
            row["kind"],
            f"{'switching to ' + str(product(before)) + ' with ' if other else ''}{row['title']}",
            "table",
            table=table,
            base=None if arranged or other else before,
            note=by if not other else "",
            by=by if not other else "",
            steps=("middleware", row["kind"]) if other else (row["kind"],),
        )
        yield change
    calm = _calmer(protocol)
    if calm is not None:
        yield Change("announcements", "calmer announcements", "table", table=calm)
    elif family(protocol) == "DDS":
        of = list(dict.fromkeys(row["protocol"] for row in read_data("vendors/announcements.csv")))
        yield f"calmer announcements: known for the tables of {words.listed(of)} alone"
    if family(protocol) == "Zenoh":
        listed = _listed(protocol)
        if listed is not None:
            yield Change("peers", "static peers", "table", table=listed)
        else:
            yield f"static peers: {protocol.name} sends no Scouts whose place they could take"
    hybrid = PROTOCOLS.get("hybrid")
    if hybrid is not None and family(protocol) is not None:
        yield Change("hybrid", "the hybrid discovery", "table", table=hybrid)
    # On Wi-Fi nobody gets what a product sends where it takes the network for wired.
    wired = [table.wired for table in PROTOCOLS.values()]
    arrangements = ARRANGED | {row["table"] for row in _arrangements()}
    for table in PROTOCOLS.values():
        if table == protocol or table in wired or table.name in arrangements:
            continue
        if family(table) is not None and _alike(table, protocol):
            yield Change("middleware", f"switching to {table.name}", "table", table=table)


def _listed(table: Protocol) -> Protocol | None:
    """Return a table of Zenoh peers that have a list of others instead of Scouts, if it may.

    What belongs to a connection is counted once for each two processes, as the one of them dials
    that has the other on its list; peers that find each other by Scouts both may.
    """
    first = table.messages[0]
    rest = tuple(message for message in table.messages if message.phase != first.phase)
    if not rest or first.kind != "Scout":
        return None
    dialed = [m.per_unit for m in rest if m.kind == "Init" and m.name == "InitSyn"]
    once = 0.5 / dialed[0] if dialed else 1.0
    linked = ("Init", "Open", "KeepAlive", "TCP control")
    messages = (
        replace(m, per_unit=m.per_unit * once)
        if dialed and (m.kind in linked or m.answers == "KeepAlive")
        else m
        for m in rest
    )
    return replace(table, messages=tuple(messages))


def _calmer(table: Protocol) -> Protocol | None:
    """Return a table with the announcements of ``data/vendors/announcements.csv``, if it may."""
    name = product(table)
    rows = {
        r["message"]: r for r in read_data("vendors/announcements.csv") if r["protocol"] == name
    }
    calm = tuple(
        replace(
            message,
            schedule=Schedule(
                tuple(float(t) for t in row["starts_s"].split()), float(row["period_s"])
            ),
        )
        if (row := rows.get(message.name)) and message.schedule.per_second
        else message
        for message in table.messages
    )
    if calm == table.messages:
        return None
    return replace(table, messages=calm, lease=max(float(row["lease_s"]) for row in rows.values()))


def _alike(one: Protocol, other: Protocol) -> bool:
    """Return whether two tables count alike: as the paper, with periods, or as products do."""
    built = [product(table) is not None for table in (one, other)]
    papers = any(of_paper(message) for message in other.messages) or not other.repeats
    return built[0] == built[1] and (built[0] or (one.repeats == other.repeats and papers))


def row_of(kind: str, of: str | None) -> dict[str, str] | None:
    """Return what the data say of a kind of remedy for a family, None if they do not."""
    rows = [row for row in read_data("vendors/remedies.csv") if row["kind"] == kind]
    found = [row for row in rows if row["family"] == of]
    return next(iter(found + [row for row in rows if row["family"] == "any"]), None)


def known(kind: str, protocol: Protocol) -> dict[str, str]:
    """Return what the data say of a kind of remedy for a protocol.

    Of switching to an arrangement what holds for any: what a family counts is of its peers.
    """
    arranged = kind == "middleware" and any(r["table"] == protocol.name for r in _arrangements())
    row = row_of(kind, None if arranged else family(protocol))
    assert row is not None, kind
    return row


@cache
def _simulated() -> dict[tuple[str, int], dict[tuple[str, str], float]]:
    """Return how long small robots take to all know each other, as simulated on 802.11n [s].

    By table of the paper and number of hosts, then by how they start and frames in an A-MPDU.
    """
    found: dict[tuple[str, int], dict[tuple[str, str], float]] = {}
    for row in read_data("simulated/staggered.csv"):
        if row["radio"] == "n":
            starts = found.setdefault((row["protocol"], int(row["hosts"])), {})
            starts[row["start"], row["mpdus"]] = float(row["convergence_time_s"])
    return dict(sorted(found.items()))


def _small_robots() -> str:
    """Return what was simulated: each run has robots of one kind."""
    kinds = {(r["processes"], r["endpoints"]) for r in read_data("simulated/staggered.csv")}
    ((processes, endpoints),) = kinds
    return f"robots of {processes} processes with {endpoints} endpoints all know each other"


def _staggered(protocol: Protocol) -> str:
    """Return what the simulator says of small robots that start one after the other."""
    own = family(protocol)
    gains = []
    for name in [own] if own else ["DDS", "Zenoh"]:
        for (_, hosts), times in [row for row in _simulated().items() if row[0][0] == name][-2:]:
            rule, together = (times[start, "1"] for start in ("rule", "together"))
            gains.append(f"{hosts} with {name} in {rule:.0f} s instead of {together:.0f} s")
    return (
        f"but queues lose less of it: simulated by the paper's tables, {_small_robots()}, "
        f"{words.listed(gains)} (medians)"
    )


def _aggregated() -> str:
    """Return what the simulator says of aggregation, if small robots start together."""
    most = max(hosts for _, hosts in _simulated())
    gains = []
    for name in ("DDS", "Zenoh"):
        one, many = (_simulated()[name, most]["together", mpdus] for mpdus in ("1", str(MPDUS)))
        gains.append(f"in {many:.0f} s instead of {one:.0f} s with {name}")
    return (
        f"simulated by the paper's tables, {most} {_small_robots()} {words.listed(gains)} (medians)"
    )


def inapplicable(protocol: Protocol) -> Iterator[str]:
    """Yield what does not work with a protocol, and what is not known to."""
    own, built = family(protocol), product(protocol)
    rows = read_data("vendors/remedies.csv")
    unknown = []
    for kind in dict.fromkeys(row["kind"] for row in rows):
        row = row_of(kind, own)
        of_kind = [found for found in rows if found["kind"] == kind]
        if row is None and own is None:
            unknown.append(of_kind[0]["title"])
        elif row is None:
            others = words.listed([found["family"] for found in of_kind])
            yield f"{of_kind[0]['title']}: for {others} alone"
        elif row["works"] == "no":
            yield f"{row['title']}: {row['why']}"
        elif built and row["table"] in PROTOCOLS and row["base"]:
            of = product(PROTOCOLS[row["base"]])
            if of != built:
                yield f"{row['title']}: measured with {of} alone"
    if unknown:
        known = [f"{r['first_message']} ({r['family']})" for r in read_data("vendors/families.csv")]
        yield (
            f"{words.listed(unknown)}: not known for {protocol.name}, as the first message of its "
            f"table is neither {' nor '.join(known)}"
        )


def composed(fleet: Fleet) -> Fleet:
    """Return a fleet of the same endpoints in one process a host."""
    groups = (
        replace(
            group,
            processes=1,
            endpoints=group.processes * group.endpoints,
            shared=group.processes * group.shared,
            nodes=None if group.nodes is None else group.processes * group.nodes,
        )
        for group in fleet.groups
    )
    return Fleet(tuple(groups), fleet.matching)


def _other_fleets(fleet: Fleet, nodes: Sequence[float], assumed: str) -> Iterator[Change | str]:
    many = [group for group in fleet.groups if group.processes > 1]
    if many:
        which = "the processes of each host"
        if len(many) == 1:
            of = of_group(many[0]) if len(fleet.groups) > 1 else ""
            which = f"{many[0].processes:,.10g} processes{of}"
        what = f"composing {which} into 1"
        try:
            composed(fleet)
        except ValueError as error:
            yield f"{what}: {error}"
        else:
            yield Change("processes", what, "processes", fleet=composed)
    else:
        yield "composing: each host has one process already"
    each = parameter_service_endpoints()
    if not any(nodes):
        yield f"parameter services: no process has any (those of a node are {each} endpoints)"
        return

    def fewer(whole: Fleet) -> Fleet:
        groups = (
            _with(group, endpoints=group.endpoints - each * own, nodes=0)
            for group, own in zip(whole.groups, nodes, strict=True)
        )
        return Fleet(tuple(groups), whole.matching)

    counts = " and ".join(f"{own:.3g}" for own in dict.fromkeys(nodes))
    noun = "node" if set(nodes) == {1} else "nodes"
    what = f"leaving out the parameter services of {counts} {noun} a process{assumed}"
    yield Change("endpoints", what, "endpoints", fleet=fewer)


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


def _other_radios(radio: Radio, by: str) -> Iterator[Change | str]:
    if radio.basic_rate < MULTICAST_RATE:
        what = (
            f"sending multicast at {MULTICAST_RATE / 1e6:g} instead of "
            f"{radio.basic_rate / 1e6:g} Mbit/s"
        )

        def faster(old: Radio) -> Radio:
            return replace(old, multicast_rate=MULTICAST_RATE, name=None)

        yield Change("multicast rate", what, "multicast rate", radio=faster, note=by, by=by)
    for changes in RADIOS:
        other = _another(radio, changes)
        if other.rate > radio.rate:
            yield Change(
                "radio",
                f"another radio ({other.wifi().name})",
                "radio",
                radio=lambda old, changes=changes: _another(old, changes),  # type: ignore[misc]
                note=_compared(radio, other, by),
                by=by,
            )
    most = _most_mpdus(radio.standard)
    if most == 1:
        yield f"aggregation: {radio.standard} has none"
    elif radio.mpdus < MPDUS:

        def aggregated(old: Radio) -> Radio:
            return replace(old, mpdus=min(MPDUS, _most_mpdus(old.standard)), name=None)

        what = f"aggregating up to {MPDUS} frames"
        note = f"{by}{'; ' * bool(by)}{_aggregated()}"
        yield Change("aggregation", what, "aggregation", radio=aggregated, note=note, by=by)


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


def of_paper(message: Message) -> bool:
    """Return whether a message is one of the paper's tables."""
    return any(message in table.messages for table in (DDS, ZENOH))


def of_ros2(
    fleet: Fleet, nodes: float | Sequence[float] | None, shared: float | None = None
) -> Fleet:
    """Return a fleet whose processes have the endpoints that all of ROS 2 shares, or so many.

    Where neither `nodes` nor a group says how many nodes a process has, they are the likely ones.
    """
    own = nodes_of(fleet, nodes)
    groups = []
    for group, told in zip(fleet.groups, own, strict=True):
        unknown = nodes is None and group.nodes is None
        least = shared_endpoints(likely_nodes(group.endpoints) if unknown else told)
        groups.append(_with(group, shared=max(group.shared, least) if shared is None else shared))
    return replace(fleet, groups=tuple(groups))


def _with(group: HostGroup, **counts: Any) -> HostGroup:
    """Return a group with other counts, of which no more endpoints are shared than it has."""
    counts = {"endpoints": group.endpoints, "shared": group.shared} | counts
    return replace(group, **counts | {"shared": min(counts["shared"], counts["endpoints"])})


def of_group(group: HostGroup) -> str:
    """Return whose something is, if the group has a name."""
    return f" of {group.name}" if group.name else ""


def nodes_of(fleet: Fleet, nodes: float | Sequence[float] | None) -> tuple[float, ...]:
    """Return the nodes with parameter services in a process of each group."""
    many = len(fleet.groups)
    if nodes is None:
        own = [
            float(group.endpoints >= parameter_service_endpoints())
            if group.nodes is None
            else group.nodes
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
        check_nodes(f"nodes{of_group(group)}", count, group.endpoints)
    return tuple(own)
