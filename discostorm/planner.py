"""What discovery costs a fleet, what dominates, and what would help, alone and combined.

Every remedy is a changed fleet, protocol or Wi-Fi that goes through the same `utilization`;
no formula is stated here. For which protocols a kind of remedy works, what it costs otherwise,
how hard it is, what fails when and whether all robots still find each other is data:
``data/vendors/remedies.csv`` and ``efforts.csv``; what to paste is `discostorm.snippets`.
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import cache
from itertools import combinations
from typing import TYPE_CHECKING, Any, Literal

from discostorm import _checks, staggered, words
from discostorm.data import read_data
from discostorm.fleet import COUNTS, LEAST, Fleet, HostGroup, as_fleet
from discostorm.messages import PAPER_WINDOW, Message, Protocol, Schedule, Unit
from discostorm.protocols import ARRANGED, DDS, MEASURED, PROTOCOLS, ZENOH
from discostorm.protocols.defaults import defaults
from discostorm.scalability import message_costs, unit_costs, utilization, without_each
from discostorm.snippets import Snippet, snippets
from discostorm.wifi import PAPER, Radio, Wifi

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.figure import Figure

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
#: Remedies that are told in words, combinations that are kept, and tables that are combined.
_TOLD, _KEPT, _TABLES = 3, 5, 3
#: Most remedies in a combination.
_TOGETHER = 3


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
        What is changed: a kind of ``data/vendors/remedies.csv``, or "combination".
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
        The utilization without it [1], by a table and on a channel of the same kind.
    utilization : float
        What it leads to [1]: of all parts on one channel; on several, of the fullest.
    window : float
        The seconds that are averaged [s]; infinity for the steady state.
    note : str
        What is compared, or left out of the number; empty if there is nothing to say.
    efforts : tuple of str
        How hard its changes are, by names of ``data/vendors/efforts.csv``.
    fails : str
        What fails when.
    steps : tuple of str
        The kinds of its changes: one, but for a combination.
    spread : float
        Within how long hosts should start so that the channel can carry what is left [s]:
        `discostorm.staggered.window`.
    """

    kind: str
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
    efforts: tuple[str, ...] = ()
    fails: str = ""
    steps: tuple[str, ...] = ()
    spread: float = 0.0

    @property
    def saved(self) -> float:
        """What it saves as a part of what there was before [1]; negative if it costs more.

        Where nothing was sent before it is 0, whatever is sent then.
        """
        return 1 - self.utilization / self.before if self.before else 0.0

    @property
    def now_fits(self) -> bool:
        """Whether it fits with it and did not without."""
        return words.fits(self.utilization) and not words.fits(self.before)

    @property
    def rank(self) -> int:
        """How hard the hardest of its changes is, from 1 on [1]."""
        return max((int(_efforts()[name]["rank"]) for name in self.efforts), default=0)

    @property
    def snippets(self) -> tuple[Snippet, ...]:
        """What to paste."""
        standard = " ".join(self.wifi.name.split()[:3])
        names = (self.protocol.name, product(self.protocol), family(self.protocol), standard)
        known = [name for name in names if name]
        return tuple(piece for kind in self.steps for piece in snippets(kind, *known))

    def sentence(self) -> str:
        """Return what it brings, in words."""
        before, after = (_amount(value, self.window) for value in (self.before, self.utilization))
        s = "" if self._plural else "s"
        if self.kind == "staggered start":
            brings = f"within {words.duration(self.spread)} takes the same {before} of airtime"
        elif self.utilization and not self.before:
            brings = f"add{s} {after}, where nothing was sent before"
        elif abs(self.saved) < _NOTHING:
            brings = f"change{s} less than {_NOTHING:.1%}"
        elif self.saved < 0:
            brings = f"add{s} {words.percent(-self.saved)}: {before} becomes {after}"
        else:
            # What is left may be less than what numbers tell apart from all.
            most = math.nextafter(1, 0) if self.utilization else 1.0
            brings = f"cut{s} {before} to {after} ({words.percent(min(self.saved, most))})"
        return f"{self.what} {brings}{'; ' * bool(self.note)}{self.note}"

    @property
    def _plural(self) -> bool:
        """Whether the change is told in the plural: several of them, or things without article."""
        first = self.what.split()[0]
        one = first in ("a", "another", "the") or first.endswith("ing")
        return self.kind == "combination" or not one

    def caution(self) -> str:
        """Return what it takes, what to mind and what fails when, in words."""
        efforts = list(dict.fromkeys(_efforts()[name]["what"] for name in self.efforts))
        fails = f"; {self.fails}" * bool(self.fails)
        later = ""
        if self.kind == "combination" and not words.fits(self.utilization):
            later = f" It still does not fit: start within {words.duration(self.spread)}."
        return f"It takes {words.listed(efforts)}. Mind: {self.price}{fails}.{later}"

    def to_dict(self) -> dict[str, Any]:
        """Return all of it as what JSON can hold."""
        return {
            "kind": self.kind,
            "steps": list(self.steps),
            "what": self.what,
            "effort": self.rank,
            "efforts": [_efforts()[name]["what"] for name in self.efforts],
            "price": self.price,
            "fails": self.fails,
            "note": self.note,
            "all_find_each_other": self.whole,
            "fleets": [_groups(fleet) for fleet in self.fleets],
            "protocol": self.protocol.name,
            "wifi": self.wifi.name,
            "before": self.before,
            "utilization": self.utilization,
            "saved": self.saved,
            "fits": words.fits(self.utilization),
            "start_within_s": self.spread,
            "paste": [
                {"where": piece.where, "version": piece.version, "text": piece.text}
                for piece in self.snippets
            ],
        }


@cache
def _efforts() -> dict[str, dict[str, str]]:
    return {row["effort"]: row for row in read_data("vendors/efforts.csv")}


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
        What could be changed, one thing each: what makes it fit first, that which is easiest
        before all; then what saves most. Those after which not all hosts find each other
        stand behind all others.
    combinations : tuple of Remedy
        The best of two or three of them together, in the same order; none that does without
        one of its changes as well.
    left_out : tuple of str
        What does not apply or could not be changed, and why.
    """

    fleet: Fleet
    protocol: Protocol
    wifi: Wifi
    window: float
    utilization: float
    shares: tuple[Share, ...]
    remedies: tuple[Remedy, ...]
    combinations: tuple[Remedy, ...]
    left_out: tuple[str, ...]

    def of_kind(self, kind: str) -> tuple[Share, ...]:
        """Return the shares of one kind: message, phase or group; the largest first."""
        return tuple(share for share in self.shares if share.kind == kind)

    def to_frame(self) -> pd.DataFrame:
        """Return the remedies in their order, then the combinations.

        Returns
        -------
        pandas.DataFrame
            One row each, indexed by what it is, with columns kind, before and utilization
            [1], saved [1], fits (whether it is less than the window), start_within_s [s],
            effort [1], from 1 on, all_find_each_other, price, fails and note.
        """
        import pandas as pd

        columns = ("kind", "before", "utilization", "saved", "fits", "start_within_s", "effort")
        columns += ("all_find_each_other", "price", "fails", "note")  # type: ignore[assignment]
        rows = [found.to_dict() for found in (*self.remedies, *self.combinations)]
        index = pd.Index([row["what"] for row in rows], name="remedy")
        return pd.DataFrame({name: [row[name] for row in rows] for name in columns}, index)

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
            "remedies": [remedy.to_dict() for remedy in self.remedies],
            "combinations": [remedy.to_dict() for remedy in self.combinations],
            "left_out": list(self.left_out),
        }

    def to_json(self) -> str:
        """Return all of it as JSON."""
        return json.dumps(self.to_dict(), indent=2, ensure_ascii=False)

    def picture_data(self) -> pd.DataFrame:
        """Return what `picture` draws: one row a bar, with its protocol and utilization [1].

        Where a remedy is compared with another table or channel than the plan's, the bar before
        it is that of the fleet as it is by that.
        """
        import pandas as pd

        bars = [("as it is", self.protocol.name, self.utilization)]
        shown: list[tuple[str, str, float]] = []
        for found in self.remedies:
            if found.kind == "staggered start":
                continue
            by = ""
            if found.before != self.utilization:
                on_air = found.kind in _AIR
                base = str(product(found.protocol))
                by = ", by the standard's timing" if on_air else f", as {base} was measured"
                of = self.protocol.name if on_air else base
                bars.append((f"as it is{by}", of, found.before))
            shown.append((found.what + by, found.protocol.name, found.utilization))
        bars = [*dict.fromkeys(bars), *shown]
        return pd.DataFrame(bars, columns=["bar", "protocol", "utilization"])

    def picture(self) -> Figure:
        """Draw what each remedy leads to, beside what there is and the whole channel."""
        from discostorm import figures

        return figures.remedies(self.picture_data())

    @property
    def best(self) -> Remedy | None:
        """The best combination: one that fits with less effort than any remedy alone.

        Or, where none fits alone, the first; None if there is nothing to combine.
        """
        alone = min((r.rank for r in self.remedies if r.now_fits and r.whole), default=math.inf)
        first = next(iter(self.combinations), None)
        needed = first is not None and not words.fits(self.utilization)
        if first is None or not needed or (alone < math.inf and not first.rank < alone):
            return None
        return first

    def told(self) -> dict[str, tuple[Remedy, ...]]:
        """Return what is told in words, by titles: the best of each kind, the best together."""
        helps = [r for r in self.remedies if r.saved >= _NOTHING]
        useful = [r for r in helps if r.whole and "research" not in r.efforts]
        kept = [r for i, r in enumerate(useful) if r.kind not in {o.kind for o in useful[:i]}]
        split = [r for r in helps if not r.whole]
        found = {
            "What would help most, alone:": tuple(kept[:_TOLD]),
            "Best together:": (self.best,) if self.best else (),
            "One after the other:": tuple(r for r in self.remedies if r.kind == "staggered start"),
            "What would help, but not all hosts would find each other any more:": tuple(split[:1]),
        }
        return {title: remedies for title, remedies in found.items() if remedies}

    def advice(self) -> str:
        """Return what it costs, what dominates and what would help, in words."""
        told = self.told()
        lines = [*self._cost_in_words(), "", "What dominates:", *self._shares_in_words()]
        if "What would help most, alone:" not in told:
            lines += ["", "Nothing that was tried helps."]
        for title, remedies in told.items():
            lines += ["", title, *self._ranked(remedies)]
        rest = len(self.remedies) + len(self.combinations) - sum(map(len, told.values()))
        others = f"{rest} other{'s' * (rest != 1)}"
        lines += ["", f"{others}, what was left out and what to paste: in the table and JSON."]
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
        timed = [r.before for r in self.remedies if r.kind in _AIR]
        before = next((value for value in timed if value != self.utilization), None)
        if before is not None:
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
    def _ranked(remedies: Sequence[Remedy]) -> Iterator[str]:
        """Yield remedies with their places, effort, price and what fails."""
        for place, remedy in enumerate(remedies, start=1):
            fits = "; that fits" * remedy.now_fits
            yield f"{place:2}. {words.capitalized(remedy.sentence())}{fits}."
            yield f"    {remedy.caution()}"


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
    'a Discovery Server cuts 5.74 s to 0.25 s (96%); both as Fast DDS was measured'
    >>> [found.sentence() for found in plan.remedies if found.kind == "processes"]
    ['composing 8 processes into 1 cuts 1.38 s to 0.11 s (92%)']
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

    costs_of: dict[tuple[int, Protocol, Wifi], float] = {}

    def cost(members: Fleet, table: Protocol = protocol, channel: Wifi = wifi) -> float:
        # By identity, as to compare fleets of many groups takes longer than to count.
        key = (id(members), table, channel)
        if key not in costs_of:
            costs_of[key] = float(utilization(table, members, wifi=channel, window=window))
        return costs_of[key]

    base = _Setting(fleet, protocol, wifi)
    found = tuple(_changes(base, own, " (assumed)" if guessed else ""))
    counted: dict[int, dict[Unit, float]] = {}

    def roughly(setting: _Setting) -> float:
        """As `cost`, but for the order in which numbers are added up: units are counted once."""
        units = counted.setdefault(id(setting.fleet), {})
        prices = unit_costs(setting.protocol, setting.wifi, float(window))
        for unit in prices:
            if unit not in units:
                units[unit] = float(unit.count(setting.fleet))
        return sum(price * units[unit] for unit, price in prices.items())

    def remedy(steps: Sequence[_Change]) -> Remedy:
        """Return what these changes lead to together."""
        old, new = base.before(steps), base.after(steps)
        parts = next((step.parts for step in steps if step.parts), (new.fleet,))
        costs = [cost(part, new.protocol, new.wifi) for part in parts]
        spreads = [staggered.window(new.protocol, part, wifi=new.wifi) for part in parts]
        of_all: Callable[[Iterable[float]], float] = sum
        if any(step.kind == "channels" for step in steps):
            of_all = max
        rows = [_known(kind, new.protocol) for step in steps for kind in step.steps]
        note = steps[0].note
        if len(steps) > 1:
            notes = [step.by for step in steps if step.by]
            note = "; ".join(dict.fromkeys(notes))
        before = cost(old.fleet, old.protocol, old.wifi)
        if steps[0].kind == "middleware" and len(steps) == 1:
            note = _sessions(
                protocol, new.protocol, before, costs[0], lambda t: cost(fleet, t), float(window)
            )
        return Remedy(
            steps[0].kind if len(steps) == 1 else "combination",
            words.listed([step.what for step in steps]),
            "; ".join(dict.fromkeys(row["price"] for row in rows)),
            all(row["all_find_each_other"] == "yes" for row in rows),
            parts,
            new.protocol,
            new.wifi,
            before,
            of_all(costs),
            float(window),
            note,
            tuple(row["effort"] for row in rows),
            "; ".join(dict.fromkeys(row["fails"] for row in rows if row["fails"])),
            tuple(kind for step in steps for kind in step.steps),
            of_all(spreads),
        )

    singles = {step: remedy([step]) for step in found if isinstance(step, _Change)}
    alone = [r for step, r in singles.items() if len(step.steps) == 1]
    return Plan(
        fleet,
        protocol,
        wifi,
        float(window),
        (before := cost(fleet)),
        tuple(_shares(fleet, protocol, wifi, float(window), before)),
        tuple(sorted(alone, key=_order)),
        tuple(sorted(map(remedy, _together(base, singles, roughly)), key=_order)),
        (*(reason for reason in found if isinstance(reason, str)), *_inapplicable(protocol)),
    )


def _order(remedy: Remedy) -> tuple[Any, ...]:
    """Return by what remedies are sorted; see `Plan`."""
    effort = (remedy.rank, len(remedy.steps)) if remedy.now_fits else (0, 0)
    research = "research" in remedy.efforts
    return not remedy.whole, research, not remedy.now_fits, effort, -remedy.saved


@dataclass(frozen=True)
class _Setting:
    """A fleet, its middleware and its channel."""

    fleet: Fleet
    protocol: Protocol
    wifi: Wifi
    #: The fleet with some changes, made once.
    fleets: dict[tuple[_Change, ...], Fleet] = field(default_factory=dict, compare=False)

    def after(self, steps: Sequence[_Change]) -> _Setting:
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
        return _Setting(self.fleets[changing], protocol, wifi)

    def before(self, steps: Sequence[_Change]) -> _Setting:
        """Return what these changes are compared with: tables and channels of the same kind."""
        protocol = next((step.base for step in steps if step.base), self.protocol)
        wifi = self.wifi
        if any(step.radio for step in steps):
            assert wifi.radio is not None
            wifi = replace(wifi.radio.wifi(), name=wifi.name)
        return _Setting(self.fleet, protocol, wifi)


@dataclass(frozen=True, eq=False)
class _Change:
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
_SLOTS = ("endpoints", "processes", "table", "radio", "multicast rate", "aggregation")
_AIR = ("radio", "multicast rate", "aggregation")


def _together(
    base: _Setting, singles: dict[_Change, Remedy], cost: Callable[[_Setting], float]
) -> list[tuple[_Change, ...]]:
    """Return the best sets of two or three changes; each is needed for what its set saves.

    All sets are tried, but with no more than the best few tables.
    """
    usable = [c for c, r in singles.items() if c.slot in _SLOTS and "research" not in r.efforts]
    tables = sorted((c for c in usable if c.slot == "table"), key=lambda c: -singles[c].saved)
    usable = [c for c in usable if c.slot != "table" or c in tables[:_TABLES]]
    usable.sort(key=lambda change: _SLOTS.index(change.slot))
    after: dict[tuple[_Change, ...], float] = {}
    found: list[tuple[Any, tuple[_Change, ...]]] = []
    for many in range(1, _TOGETHER + 1):
        for steps in combinations(usable, many):
            if len({step.slot for step in steps}) < many:
                continue
            if sum(len(step.steps) for step in steps) > _TOGETHER:
                continue
            after[steps] = taken = cost(base.after(steps))
            before = cost(base.before(steps))
            saved = 1 - taken / before if before else 0.0
            less = (tuple(s for s in steps if s is not left) for left in steps)
            needed = all(taken < (1 - _NOTHING) * after.get(fewer, before) for fewer in less)
            if saved < _NOTHING or not needed or sum(len(s.steps) for s in steps) < 2:
                continue
            fits = words.fits(taken) and not words.fits(before)
            rank = max(singles[step].rank for step in steps) if fits else 0
            found.append(((not fits, rank, many if fits else 0, -saved), steps))
    return [steps for _, steps in sorted(found, key=lambda item: item[0])[:_KEPT]]


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


def _changes(base: _Setting, nodes: Sequence[float], assumed: str) -> Iterator[_Change | str]:
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
    row = _row("domains", family(protocol))
    for parts in PARTS:
        # A host that is alone on its channel has nobody to find: no remedy but a surrender.
        if 2 * parts > hosts:
            yield f"splitting into {parts} parts: not every part would have two hosts"
            continue
        pieces = split(fleet, parts)
        yield _Change("channels", f"splitting onto {parts} channels", "parts", parts=pieces)
        if row is not None and row["works"] == "computed":
            yield _Change("domains", f"splitting into {parts} domains", "parts", parts=pieces)
    yield _Change(
        "staggered start", "starting one after the other", "time", note=_simulated(protocol)
    )


def _other_tables(protocol: Protocol) -> Iterator[_Change | str]:
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
        by = "" if before == protocol or arranged else f"both as {before.name} was measured"
        change = _Change(
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
        yield _Change("announcements", "calmer announcements", "table", table=calm)
    elif family(protocol) == "DDS":
        yield f"calmer announcements: what {protocol.name} repeats is not of a product as built"
    if family(protocol) == "Zenoh":
        first = protocol.messages[0]
        rest = tuple(m for m in protocol.messages if m.phase != first.phase)
        if rest and first.kind == "Scout":
            yield _Change("peers", "static peers", "table", table=replace(protocol, messages=rest))
        else:
            yield f"static peers: {protocol.name} sends no Scouts whose place they could take"
    hybrid = PROTOCOLS.get("hybrid")
    if hybrid is not None and family(protocol) is not None:
        yield _Change("hybrid", "the hybrid discovery", "table", table=hybrid)
    # On Wi-Fi nobody gets what a product sends where it takes the network for wired.
    wired = [table.wired for table in PROTOCOLS.values()]
    arrangements = ARRANGED | {row["table"] for row in _arrangements()}
    for table in PROTOCOLS.values():
        if table == protocol or table in wired or table.name in arrangements:
            continue
        if family(table) is not None and _alike(table, protocol):
            yield _Change("middleware", f"switching to {table.name}", "table", table=table)


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
    papers = any(_of_paper(message) for message in other.messages) or not other.repeats
    return built[0] == built[1] and (built[0] or (one.repeats == other.repeats and papers))


def _row(kind: str, of: str | None) -> dict[str, str] | None:
    """Return what the data say of a kind of remedy for a family, None if they do not."""
    rows = [row for row in read_data("vendors/remedies.csv") if row["kind"] == kind]
    found = [row for row in rows if row["family"] == of]
    return next(iter(found + [row for row in rows if row["family"] == "any"]), None)


def _known(kind: str, protocol: Protocol) -> dict[str, str]:
    row = _row(kind, family(protocol))
    assert row is not None, kind
    return row


def _simulated(protocol: Protocol) -> str:
    """Return what the simulator says of small robots that start one after the other."""
    own = family(protocol)
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
    robot = starts["rule"]
    return (
        "but queues lose less of it: simulated by the paper's tables, robots of "
        f"{robot['processes']} processes with {robot['endpoints']} endpoints all know each other, "
        f"{words.listed(gains)}"
    )


def _inapplicable(protocol: Protocol) -> Iterator[str]:
    """Yield what does not work with a protocol, and what is not known to."""
    own, built = family(protocol), product(protocol)
    rows = read_data("vendors/remedies.csv")
    unknown = []
    for kind in dict.fromkeys(row["kind"] for row in rows):
        row = _row(kind, own)
        of_kind = [found for found in rows if found["kind"] == kind]
        if row is None and own is None:
            unknown.append(of_kind[0]["title"])
        elif row is None:
            others = words.listed([found["family"] for found in of_kind])
            yield f"{of_kind[0]['title']}: there is none in {own}, but in {others}"
        elif row["works"] == "no":
            yield f"{row['title']}: {row['why']}"
        elif built and row["table"] in PROTOCOLS and row["base"]:
            of = product(PROTOCOLS[row["base"]])
            if of != built:
                yield f"{row['title']}: of {of} alone"
    if unknown:
        known = [f"{r['first_message']} ({r['family']})" for r in read_data("vendors/families.csv")]
        yield (
            f"{words.listed(unknown)}: not known for {protocol.name}, as the first message of its "
            f"table is neither {' nor '.join(known)}"
        )


def _composed(fleet: Fleet) -> Fleet:
    """Return a fleet of the same endpoints in one process a host."""
    groups = (
        replace(
            group,
            processes=1,
            endpoints=group.processes * group.endpoints,
            nodes=None if group.nodes is None else group.processes * group.nodes,
        )
        for group in fleet.groups
    )
    return Fleet(tuple(groups), fleet.matching)


def _other_fleets(fleet: Fleet, nodes: Sequence[float], assumed: str) -> Iterator[_Change | str]:
    many = [group for group in fleet.groups if group.processes > 1]
    if many:
        which = "the processes of each host"
        if len(many) == 1:
            of = _of(many[0]) if len(fleet.groups) > 1 else ""
            which = f"{many[0].processes:,.10g} processes{of}"
        what = f"composing {which} into 1"
        try:
            _composed(fleet)
        except ValueError as error:
            yield f"{what}: {error}"
        else:
            yield _Change("processes", what, "processes", fleet=_composed)
    else:
        yield "composing: each host has one process already"
    each = parameter_service_endpoints()
    if not any(nodes):
        yield f"parameter services: no process has any (those of a node are {each} endpoints)"
        return

    def fewer(whole: Fleet) -> Fleet:
        groups = (
            replace(group, endpoints=group.endpoints - each * own, nodes=0)
            for group, own in zip(whole.groups, nodes, strict=True)
        )
        return Fleet(tuple(groups), whole.matching)

    counts = " and ".join(f"{own:.3g}" for own in dict.fromkeys(nodes))
    noun = "node" if set(nodes) == {1} else "nodes"
    what = f"leaving out the parameter services of {counts} {noun} a process{assumed}"
    yield _Change("endpoints", what, "endpoints", fleet=fewer)


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


def _other_radios(radio: Radio, by: str) -> Iterator[_Change | str]:
    if radio.basic_rate < MULTICAST_RATE:
        what = (
            f"sending multicast at {MULTICAST_RATE / 1e6:g} instead of "
            f"{radio.basic_rate / 1e6:g} Mbit/s"
        )

        def faster(old: Radio) -> Radio:
            return replace(old, multicast_rate=MULTICAST_RATE, name=None)

        yield _Change("multicast rate", what, "multicast rate", radio=faster, note=by, by=by)
    for changes in RADIOS:
        other = _another(radio, changes)
        if other.rate > radio.rate:
            yield _Change(
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
        yield _Change("aggregation", what, "aggregation", radio=aggregated, note=by, by=by)


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
