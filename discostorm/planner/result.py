"""A plan: what discovery costs, what dominates and what would help, in words, tables and JSON."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING, Any, Literal

from discostorm import words
from discostorm.fleet import Fleet
from discostorm.messages import ENDPOINT, PAPER_WINDOW, Protocol, Unit
from discostorm.planner.arrangements import Arrangement, table_in_words
from discostorm.planner.known import software
from discostorm.planner.remedy import NOTHING, Remedy
from discostorm.protocols import DDS, ZENOH
from discostorm.wifi import Wifi
from discostorm.wifi.radio import TOPOLOGY

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.figure import Figure

#: Groups that are named.
_GROUPS = 5
#: Remedies that are told in words.
_TOLD = 3


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
    arrangements : tuple of Arrangement
        Every measured arrangement of every product, for the same fleet and channel; the one of
        the shortest start first.
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
    arrangements: tuple[Arrangement, ...]

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

        columns = ["kind", "name", "utilization", "share"]
        return pd.DataFrame(map(asdict, self.shares), columns=columns).set_index("name")

    def to_dict(self) -> dict[str, Any]:
        """Return all of it as what JSON can hold: texts, numbers, lists and dictionaries.

        The steady state has the window None, as JSON has no infinity.
        """
        return {
            "protocol": self.protocol.name,
            "wifi": self.wifi.name,
            "topology": TOPOLOGY,
            "fleet": self.fleet.described(),
            "steady": self.steady,
            "steady_fits": words.fits(self.steady),
            "window_s": self.window if math.isfinite(self.window) else None,
            "utilization": self.utilization,
            "fits": words.fits(self.utilization),
            "shares": [asdict(share) for share in self.shares],
            "remedies": [remedy.to_dict() for remedy in self.remedies],
            "combinations": [remedy.to_dict() for remedy in self.combinations],
            "left_out": list(self.left_out),
            "arrangements": [found.to_dict() for found in self.arrangements],
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
                on_air = found.wifi != self.wifi
                base = str(software(found.protocol))
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
        helps = [r for r in self.remedies if r.saved >= NOTHING]
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

    def advice(self, width: int = 79) -> str:
        """Return what it costs, what dominates and what would help, in lines of so many letters."""
        told = self.told()
        lines = [*self._cost_in_words(), "", "What dominates:", *self._shares_in_words()]
        if self.fleet.hosts() == 1:  # what saves airtime saves what nobody needs
            lines += ["", words.ALONE]
            return "\n".join(words.wrapped(line, width) for line in lines)
        if "What would help most, alone:" not in told:
            lines += ["", "Nothing that was tried helps."]
        for title, remedies in told.items():
            lines += ["", title, *self._ranked(remedies)]
        wrapped = "\n".join(words.wrapped(line, width) for line in lines)
        table = "\n".join(
            [
                "",
                words.wrapped("The same fleet with every measured arrangement:", width),
                *table_in_words(self.arrangements, width),
            ]
        )
        rest = len(self.remedies) + len(self.combinations) - sum(map(len, told.values()))
        more = f"In the JSON: {words.many(rest, 'other')}, what was left out and what to paste."
        return "\n".join((wrapped, table, "", words.wrapped(more, width)))

    def __str__(self) -> str:
        return self.advice()

    def _cost_in_words(self) -> Iterator[str]:
        hosts = sum(group.hosts for group in self.fleet.groups)
        takes = words.airtime(self.utilization, self.window)
        if not words.fits(self.steady) and math.isfinite(self.window):
            yield (
                f"What is repeated does not fit: it takes {words.percent(self.steady)} of the "
                "channel by itself, so that no start fits, however slow it is."
            )
        fit = "so it does not fit"
        if words.fits(self.utilization):
            fit = "so it fits" if self.wifi.aggregation is None else "so at best it fits"
        if math.isfinite(self.window):
            takes += " of airtime"
        yield (
            f"{self.protocol.name} discovery of {words.many(hosts, 'host')} with "
            f"{words.many(self.fleet.processes(), 'process', 'es')} takes {takes}. "
            f"Channel: {self.wifi.name}, {TOPOLOGY}."
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
        yield (
            f"Counted with nothing lost, no collisions and each unicast message in {exchanges}. "
            "Queues that overflow may make it many times longer: `discostorm simulate` tries it."
        )
        if self.protocol.captured is not None:
            endpoints = max(group.endpoints for group in self.fleet.groups)
            matched = Unit("matched endpoint").count(self.fleet)
            sizes = (hosts, self.fleet.processes(), endpoints)
            most = self.protocol.captured
            beyond = any(own > seen for own, seen in zip(sizes, most, strict=True))
            extrapolated = ", so that this fleet is extrapolated" if beyond else ""
            yield (
                f"The table of {self.protocol.name} is what was measured of the product in a lab, "
                f"in swarms of up to {words.many(most[0], 'host')} and "
                f"{words.many(most[1], 'process', 'es')} of up to "
                f"{words.many(most[2], 'endpoint')} that began all at once{extrapolated}; here "
                f"{words.percent(matched / (ENDPOINT.count(self.fleet) or 1))} of the "
                "endpoints match in every process."
            )
        if self.protocol.repeats:
            of_paper = {*DDS.messages, *ZENOH.messages}
            papers = [m.name for m in self.protocol.messages if m in of_paper]
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
        timed = [r.before for r in self.remedies if r.wifi != self.wifi]
        before = next((value for value in timed if value != self.utilization), None)
        if before is not None:
            yield (
                f"Changes of the channel are compared by the standard's timing, by which this "
                f"fleet takes {words.airtime(before, self.window)} as it is."
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
            rest, most = len(groups) - _GROUPS, words.part(groups[_GROUPS].share)
            if rest == 1:
                yield f"- 1 further group takes part in at most {most}."
            else:
                yield f"- {rest} further groups take part in at most {most} each."

    @staticmethod
    def _ranked(remedies: Sequence[Remedy]) -> Iterator[str]:
        """Yield remedies with their places, effort, price and what fails."""
        for place, remedy in enumerate(remedies, start=1):
            brings = words.capitalized(remedy.sentence())
            if remedy.now_fits:
                best_case = remedy.best_case or remedy.wifi.aggregation is not None
                brings += "; that would fit" if best_case else "; that fits"
            yield f"{place:2}. {brings}."
            yield f"    {remedy.caution()}"
