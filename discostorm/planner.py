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
from dataclasses import dataclass, replace
from functools import cache
from itertools import combinations
from typing import TYPE_CHECKING, Any, Literal

from discostorm import _checks, measured, words
from discostorm.data import read_data
from discostorm.fleet import COUNTS, LEAST, Fleet, as_fleet
from discostorm.messages import PAPER_WINDOW, Protocol, Unit
from discostorm.protocols import ARRANGED, DDS, MEASURED, ZENOH
from discostorm.protocols.defaults import defaults
from discostorm.remedies import (
    AIR,
    SLOTS,
    Change,
    Setting,
    changes_of,
    family,
    inapplicable,
    known,
    nodes_of,
    of_group,
    of_paper,
    of_ros2,
    product,
)
from discostorm.scalability import burst, message_costs, unit_costs, utilization, without_each
from discostorm.snippets import Snippet, snippets
from discostorm.timeline import drained
from discostorm.wifi import PAPER, Wifi

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.figure import Figure


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
        `discostorm.staggered.window`; infinity where what is repeated fills the channel.
    steady : float
        What is repeated then takes of the channel [1].
    best_case : bool
        Whether a part of the gain is that of the best case, as that of exchanges that are all full.
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
    steady: float = 0.0
    best_case: bool = False

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
            brings = (
                f"takes the same {before} of airtime, over {words.duration(self.spread)} at least"
            )
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
            brings += " at best" * self.best_case
        return f"{self.what} {brings}{'; ' * bool(self.note)}{self.note}"

    @property
    def _plural(self) -> bool:
        """Whether the change is told in the plural: several of them, or things without article."""
        first = self.what.split()[0]
        one = first in ("a", "another", "the") or _is_doing(self.what)
        return self.kind == "combination" or not one

    def caution(self) -> str:
        """Return what it takes, what to mind and what fails when, in words."""
        efforts = list(dict.fromkeys(_efforts()[name]["what"] for name in self.efforts))
        fails = f"; {self.fails}" * bool(self.fails)
        later = ""
        if not words.fits(self.steady):
            later = f" What is repeated still takes {words.percent(self.steady)}: no start fits."
        elif self.kind == "combination" and not words.fits(self.utilization):
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
            "fleets": [fleet.described() for fleet in self.fleets],
            "protocol": self.protocol.name,
            "wifi": self.wifi.name,
            "before": self.before,
            "utilization": self.utilization,
            "saved": self.saved,
            "best_case": self.best_case,
            "fits": words.fits(self.utilization),
            "steady": self.steady,
            "start_within_s": self.spread if math.isfinite(self.spread) else None,
            "paste": [
                {"where": piece.where, "version": piece.version, "text": piece.text}
                for piece in self.snippets
            ],
        }


def _is_doing(what: str) -> bool:
    """Return whether a change is told as what is done, not as a thing."""
    return what.split()[0].endswith("ing")


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
    steady : float
        What is repeated takes of the channel [1]; if that is 1 or more, no start fits, however
        slow it is.
    shares : tuple of Share
        Messages, phases and groups, each kind with the largest first.
    remedies : tuple of Remedy
        What could be changed, one thing each: what makes it fit first, that which is easiest
        before all; then what saves most. In both parts those of which the gain is that of the best
        case stand behind, then what is a prototype. Those after which not all hosts find each other
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
    steady: float
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
            [1], saved [1], best_case (whether that is the gain of the best case), fits (whether it
            is less than the window), start_within_s [s], effort [1], from 1 on,
            all_find_each_other, price, fails and note.
        """
        import pandas as pd

        columns = [
            *("kind", "before", "utilization", "saved", "best_case", "fits", "start_within_s"),
            *("effort", "all_find_each_other", "price", "fails", "note"),
        ]
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
            "fleet": self.fleet.described(),
            "steady": self.steady,
            "steady_fits": words.fits(self.steady),
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
                on_air = found.kind in AIR
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

        return figures.remedies(self.picture_data(), self.window)

    @property
    def best(self) -> Remedy | None:
        """The best combination: one that fits with less effort than any remedy alone.

        Or, where none fits alone, the first; None if there is nothing to combine. What fits in the
        best case alone is nothing beside what fits by the count.
        """
        first = next(iter(self.combinations), None)
        sure = first is not None and first.now_fits and not first.best_case
        fitting = (r for r in self.remedies if r.now_fits and r.whole)
        alone = min((r.rank for r in fitting if not (sure and r.best_case)), default=math.inf)
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
            "What might help, in the best case:": tuple(r for r in kept[_TOLD:] if r.best_case),
            "Best together:": (self.best,) if self.best else (),
            "One after the other:": tuple(r for r in self.remedies if r.kind == "staggered start"),
            "What would help, but not all hosts would find each other any more:": tuple(split[:1]),
        }
        return {title: remedies for title, remedies in found.items() if remedies}

    def advice(self) -> str:
        """Return what it costs, what dominates and what would help, in words."""
        told = self.told()
        lines = [*self._cost_in_words(), "", "What dominates:", *self._shares_in_words()]
        if self.fleet.hosts() == 1:  # what saves airtime saves what nobody needs
            return "\n".join(map(words.wrapped, (*lines, "", words.ALONE)))
        if "What would help most, alone:" not in told:
            lines += ["", "Nothing that was tried helps."]
        for title, remedies in told.items():
            lines += ["", title, *self._ranked(remedies)]
        rest = len(self.remedies) + len(self.combinations) - sum(map(len, told.values()))
        others = f"{rest} other{'s' * (rest != 1)}"
        lines += ["", f"In the JSON: {others}, what was left out and what to paste."]
        return "\n".join(map(words.wrapped, lines))

    def __str__(self) -> str:
        return self.advice()

    def _cost_in_words(self) -> Iterator[str]:
        hosts = sum(group.hosts for group in self.fleet.groups)
        takes = _amount(self.utilization, self.window)
        if not words.fits(self.steady) and math.isfinite(self.window):
            yield (
                f"What is repeated does not fit: it takes {words.percent(self.steady)} of the "
                "channel by itself, so that no start fits, however slow it is."
            )
        fit = "so it fits" if words.fits(self.utilization) else "so it does not fit"
        yield (
            f"{self.protocol.name} discovery of {words.many(hosts, 'host')} with "
            f"{words.many(self.fleet.processes(), 'process', 'es')} takes {takes}"
            f"{' of airtime' * math.isfinite(self.window)}. Channel: {self.wifi.name}."
        )
        if math.isinf(self.window):
            share = words.charged(self.utilization, "of the channel", "the channel has")
            yield f"That is {share} in the steady state, {fit}."
        elif self.window == PAPER_WINDOW:
            share = words.charged(self.utilization, "of it", "it holds")
            yield f"All charged to one second, that is {share}, {fit}."
        else:
            share = words.charged(self.utilization, "of them", "they hold")
            yield f"All charged to the first {self.window:g} s, that is {share}, {fit}."
        exchanges = "an exchange of its own"
        if self.wifi.aggregation is not None:
            exchanges = f"an exchange of {self.wifi.aggregation.mpdus} like it, as far as they fit"
        yield (f"Counted with nothing lost, no collisions and each unicast message in {exchanges}.")
        if self.protocol.name in MEASURED | ARRANGED:
            sizes = (hosts, self.fleet.processes())
            most = measured.largest(self.protocol.name)
            beyond = any(own > seen for own, seen in zip(sizes, most, strict=True))
            yield (
                f"The table of {self.protocol.name} is what was measured of the product in a lab, "
                f"in swarms of up to {words.many(most[0], 'host')} and "
                f"{words.many(most[1], 'process', 'es')} that began all at once"
                f"{', so that this fleet is extrapolated' * beyond}; here "
                f"{words.percent(self.fleet.matched() / (self.fleet.endpoints() or 1))} of the "
                "endpoints match in every process."
            )
        if self.protocol.repeats:
            papers = [message.name for message in self.protocol.messages if of_paper(message)]
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
        timed = [r.before for r in self.remedies if r.kind in AIR]
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
            fits = f"; that {'would fit' if remedy.best_case else 'fits'}" * remedy.now_fits
            yield f"{place:2}. {words.capitalized(remedy.sentence())}{fits}."
            yield f"    {remedy.caution()}"


def plan(
    fleet: Fleet,
    protocol: Protocol = DDS,
    wifi: Wifi = PAPER,
    *,
    nodes: float | Sequence[float] | None = None,
    window: float = PAPER_WINDOW,
    shared: float | None = None,
) -> Plan:
    """Return what discovery costs a fleet, what dominates, and what would help.

    Each remedy changes one thing and leaves the rest; to combine them, plan again with
    what a `Remedy` holds. Composing keeps the endpoints. Endpoints are counted as DDS does.
    Processes are taken for those of ROS 2: some of their endpoints match in all others, whatever
    namespaces there are, and a server introduces each two processes; see `shared`.

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
    shared : float, optional
        Endpoints of each process that match one in every other [1], 0 for programs without
        ROS 2. If left out, at least those that ROS 2 makes for a process and for each of its nodes,
        `discostorm.robots.shared_endpoints`; more where a group says so, never more than a process
        has. Without a number of nodes it has as many as ready-made robots have for its endpoints,
        `discostorm.robots.likely_nodes`. Only tables of what products send depend on it.

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
    >>> [found.sentence() for found in plan.remedies if found.kind == "discovery server"]
    ['a Discovery Server cuts 6.16 s to 1.92 s (69%); both as Fast DDS was measured']
    """
    _checks.instance("fleet", fleet, Fleet)
    _checks.instance("protocol", protocol, Protocol)
    _checks.instance("wifi", wifi, Wifi)
    _checks.one_each([("window", window)])
    as_fleet(fleet, None, None)  # raises if there are symbols
    for group in fleet.groups:
        _checks.one_each(zip(COUNTS, group.counts(), strict=True))
        _checks.whole(f"hosts{of_group(group)}", group.hosts, LEAST["hosts"])
    own = nodes_of(fleet, nodes)
    if shared is not None:
        shared = _checks.number("shared", shared, 0, _checks.MOST)
    fleet = of_ros2(fleet, nodes, shared)
    guessed = nodes is None and any(group.nodes is None for group in fleet.groups)

    costs_of: dict[tuple[int, Protocol, Wifi], float] = {}

    def cost(members: Fleet, table: Protocol = protocol, channel: Wifi = wifi) -> float:
        # By identity, as to compare fleets of many groups takes longer than to count.
        key = (id(members), table, channel)
        if key not in costs_of:
            costs_of[key] = float(utilization(table, members, wifi=channel, window=window))
        return costs_of[key]

    def repeated(members: Fleet, table: Protocol = protocol, channel: Wifi = wifi) -> float:
        if not table.repeats:
            return 0.0
        return float(utilization(table, members, wifi=channel, window=math.inf))

    base = Setting(fleet, protocol, wifi)
    found = tuple(changes_of(base, own, " (assumed)" if guessed else ""))
    counted: dict[int, dict[Unit, float]] = {}

    def roughly(setting: Setting) -> float:
        """As `cost`, but for the order in which numbers are added up: units are counted once."""
        units = counted.setdefault(id(setting.fleet), {})
        prices = unit_costs(setting.protocol, setting.wifi, float(window))
        for unit in prices:
            if unit not in units:
                units[unit] = float(unit.count(setting.fleet))
        return sum(price * units[unit] for unit, price in prices.items())

    def remedy(steps: Sequence[Change]) -> Remedy:
        """Return what these changes lead to together."""
        old, new = base.before(steps), base.after(steps)
        parts = next((step.parts for step in steps if step.parts), (new.fleet,))
        costs = [cost(part, new.protocol, new.wifi) for part in parts]
        starts = [float(burst(new.protocol, part, wifi=new.wifi)) for part in parts]
        steadies = [repeated(part, new.protocol, new.wifi) for part in parts]
        of_all: Callable[[Iterable[float]], float] = sum
        if any(step.kind == "channels" for step in steps):
            of_all = max
        # Things first: "leaving out services and a server" would leave out both.
        told = sorted(steps, key=lambda step: _is_doing(step.what))
        rows = [known(kind, new.protocol) for step in told for kind in step.steps]
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
            words.listed([step.what for step in told]),
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
            float(drained(of_all(starts), of_all(steadies))),
            of_all(steadies),
            any(row["gain"] == "best case" for row in rows),
        )

    singles = {step: remedy([step]) for step in found if isinstance(step, Change)}
    steady = repeated(fleet)
    late = [step for step in singles if step.slot == "time" and not words.fits(steady)]
    never = [
        f"{singles.pop(step).what}: what is repeated takes {words.percent(steady)} of the channel "
        "by itself, so that no window is long enough"
        for step in late
    ]
    alone = [r for step, r in singles.items() if len(step.steps) == 1]
    return Plan(
        fleet,
        protocol,
        wifi,
        float(window),
        (before := cost(fleet)),
        steady,
        tuple(_shares(fleet, protocol, wifi, float(window), before)),
        tuple(sorted(alone, key=_order)),
        tuple(sorted(map(remedy, _together(base, singles, roughly)), key=_order)),
        (*never, *(r for r in found if isinstance(r, str)), *inapplicable(protocol)),
    )


def _order(remedy: Remedy) -> tuple[Any, ...]:
    """Return by what remedies are sorted; see `Plan`."""
    effort = (remedy.rank, len(remedy.steps)) if remedy.now_fits else (0, 0)
    research = "research" in remedy.efforts
    fits = remedy.now_fits
    return not remedy.whole, research, not fits, remedy.best_case, effort, -remedy.saved


def _together(
    base: Setting, singles: dict[Change, Remedy], cost: Callable[[Setting], float]
) -> list[tuple[Change, ...]]:
    """Return the best sets of two or three changes; each is needed for what its set saves.

    All sets are tried, but with no more than the best few tables.
    """
    usable = [c for c, r in singles.items() if c.slot in SLOTS and "research" not in r.efforts]
    tables = sorted((c for c in usable if c.slot == "table"), key=lambda c: -singles[c].saved)
    usable = [c for c in usable if c.slot != "table" or c in tables[:_TABLES]]
    usable.sort(key=lambda change: SLOTS.index(change.slot))
    unsure = {change for change in usable if singles[change].best_case}
    after: dict[tuple[Change, ...], float] = {}
    found: list[tuple[Any, tuple[Change, ...]]] = []
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
            order = (not fits, not unsure.isdisjoint(steps), rank, many if fits else 0, -saved)
            found.append((order, steps))
    return [steps for _, steps in sorted(found, key=lambda item: item[0])[:_KEPT]]


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


def _amount(utilization: float, window: float) -> str:
    """Return the airtime of the window in seconds, in the steady state the share of the time."""
    if math.isinf(window):
        return words.percent(utilization) + " of the time"
    return words.duration(utilization * window)
