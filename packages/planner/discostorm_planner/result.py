"""A plan: what discovery costs, what dominates and what would help, in words, tables and JSON."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING, Any, Literal

from discostorm import words
from discostorm.fleet import Fleet
from discostorm.measured import Band
from discostorm.messages import ENDPOINT, PAPER_WINDOW, Protocol, Unit
from discostorm.protocols import DDS, ZENOH
from discostorm.wifi import Wifi
from discostorm.wifi.radio import TOPOLOGY
from discostorm_planner.aggregation_range import Known, Span, Verdict
from discostorm_planner.configurations import Configuration, table_in_words
from discostorm_planner.reboot import Reboot
from discostorm_planner.remedy import NOTHING, Remedy
from discostorm_planner.remedy_rules import software
from discostorm_planner.user_data import Beside

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
        What discovery takes of them [1]; what is less than 1 fits. On a radio that aggregates as
        simulated or, where that is not stored, with one frame in each exchange.
    steady : float
        What is repeated takes of the channel [1], likewise; if that is 1 or more, no start fits,
        however slow it is.
    shares : tuple of Share
        Messages, phases and groups, each kind with the largest first, of single frames.
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
    configurations : tuple of Configuration
        Every measured configuration of every product, for the same fleet and channel; the one of
        the shortest start first.
    span, steady_span : Span
        What `utilization` and `steady` lie between: full A-MPDUs and one frame in each exchange;
        twice the same on a channel that does not aggregate.
    startup : Span
        How long the channel needs for the start [s], if nothing is lost: the drain time.
    known : Known or None
        After how long all robots know each other, simulated with queues that overflow and with
        recovery; None where that is not stored (``data/simulated/ready.csv``).
    reboot : Reboot or None
        What it takes when one robot reboots; None where that was not measured.
    band : Band or None
        How far a measured table was off where it was not fitted; None of other tables.
    data : Beside or None
        What the fleet's data take beside discovery, which all the rest is about alone; None if
        its groups send none.
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
    configurations: tuple[Configuration, ...]
    span: Span
    steady_span: Span
    startup: Span
    known: Known | None
    reboot: Reboot | None = None
    band: Band | None = None
    data: Beside | None = None

    @property
    def verdict(self) -> Verdict:
        """Whether it fits: with one frame in each exchange, only with fuller ones, or never."""
        return (self.span if self.span.ranges else _point(self.utilization)).verdict

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
            "fits": self.verdict == "fits",
            "verdict": self.verdict,
            "range": self.span.to_dict(),
            "startup": self.startup.to_dict(),
            "known_after_s": self.known.to_dict() if self.known else None,
            "reboot": self.reboot.to_dict() if self.reboot else None,
            "band": self.band.to_dict() if self.band else None,
            **({"data": self.data.to_dict()} if self.data else {}),
            "shares": [asdict(share) for share in self.shares],
            "remedies": [remedy.to_dict() for remedy in self.remedies],
            "combinations": [remedy.to_dict() for remedy in self.combinations],
            "left_out": list(self.left_out),
            "configurations": [found.to_dict() for found in self.configurations],
        }

    def to_json(self) -> str:
        """Return all of it as JSON."""
        return json.dumps(self.to_dict(), indent=2, ensure_ascii=False)

    def picture_data(self) -> pd.DataFrame:
        """Return what `picture` draws: one row a change, the best of each kind, and its baseline.

        Columns are baseline, change, protocol and utilization [1]. The first row of each baseline
        has no change: it is the fleet as it is, by this model and on this kind of channel.
        """
        import pandas as pd

        own = _by(self.protocol)
        rows = {(own, "", self.protocol.name): self.utilization}
        best = {found.kind: found for found in reversed(self.remedies)}
        for found in self.remedies:
            if found.kind == "staggered start" or found is not best[found.kind]:
                continue
            base, of = own, self.protocol.name
            was = found.was or _point(found.before)
            if found.wifi != self.wifi and not self.span.ranges:
                if found.before != self.utilization:
                    base = f"{self.protocol.name}, standard timing"
            elif was.single != (self.span if self.span.ranges else _point(self.utilization)).single:
                of = str(software(found.protocol))
                base = f"{of}, measured model"
            if found.basis == "simulated" and self.span.simulated is None:
                base += ", simulated"
            elif found.basis not in ("", "simulated") and self.span.simulated is not None:
                base += f", {found.basis}"
            rows.setdefault((base, "", of), found.before)
            kind = "at best" if found.best_case else "research" in found.efforts and "prototype"
            name = f"{found.what} ({kind})" if kind else found.what
            rows[base, name, found.protocol.name] = found.utilization
        frame = pd.DataFrame(
            [(*key, value) for key, value in rows.items()],
            columns=["baseline", "change", "protocol", "utilization"],
        )
        order = {base: place for place, base in enumerate(frame["baseline"].unique())}
        return frame.sort_values("baseline", key=lambda of: of.map(order), kind="stable")

    def picture(self, title: str = "") -> Figure:
        """Draw what each change leads to, beside the fleet as it is by the same model.

        Parameters
        ----------
        title : str, optional
            What the figure shows.
        """
        from discostorm_planner import figure

        return figure.remedies(self.picture_data(), self.window, title)

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
        needed = first is not None and self.verdict != "fits"
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
            "Best single changes:": tuple(kept[:_TOLD]),
            "Changes that help at best:": tuple(r for r in kept[_TOLD:] if r.best_case),
            "Best combination:": (self.best,) if self.best else (),
            "Staggered start:": tuple(r for r in self.remedies if r.kind == "staggered start"),
            "Changes after which some hosts no longer discover each other:": tuple(split[:1]),
        }
        return {title: remedies for title, remedies in found.items() if remedies}

    def numbered(self) -> tuple[Remedy, ...]:
        """Return the remedies that are told in words, in the order of their numbers from 1 on."""
        return tuple(remedy for remedies in self.told().values() for remedy in remedies)

    def advice(self, width: int = 79) -> str:
        """Return what it costs, what dominates and what would help, in lines of so many letters."""
        told = self.told()
        lines = [*self._answer_in_words(), ""] if self.fleet.hosts() > 1 else []
        if self.data:
            lines += [*self.data.sentences(self.window), ""]
        lines += [*self._cost_in_words(), "", "Largest parts of this airtime:"]
        lines += self._shares_in_words()
        if self.fleet.hosts() == 1:  # what saves airtime saves what no robot needs
            lines += ["", words.ALONE]
            return "\n".join(words.wrapped(line, width) for line in lines)
        if "Best single changes:" not in told:
            lines += ["", "No change that we tried helps."]
        place = 1
        for title, remedies in told.items():
            lines += ["", title, *self._ranked(remedies, place)]
            place += len(remedies)
        wrapped = "\n".join(words.wrapped(line, width) for line in lines)
        table = "\n".join(
            [
                "",
                words.wrapped("The same fleet with each measured configuration:", width),
                *table_in_words(self.configurations, width),
                "",
                "What this rests on:",
                *(words.wrapped(f"- {line}", width) for line in self._basis_in_words()),
            ]
        )
        rest = len(self.remedies) + len(self.combinations) - sum(map(len, told.values()))
        more = (
            "`discostorm plan --paste N` prints the configuration of change N. `--json` adds "
            f"{words.many(rest, 'change')}, why others are left out, and all configurations."
        )
        return "\n".join((wrapped, table, "", words.wrapped(more, width)))

    def __str__(self) -> str:
        return self.advice()

    def _answer_in_words(self) -> Iterator[str]:
        """Yield the answer, then what it rests on: the channel's time, how full exchanges are."""
        steady = self.steady_span
        if not words.fits(steady.full) and math.isfinite(self.window):
            yield (
                f"The periodic traffic alone needs {words.percent(steady.full)} of the channel, so "
                "the fleet never fits, however slowly it starts."
            )
            return
        low, high = self.startup.ends
        start = (
            words.durations(low, high) if math.isfinite(high) else f"{words.duration(low)} or more"
        )
        busy = f"startup keeps the channel busy for {start} if nothing is lost"
        if math.isinf(low):
            busy = "startup never ends"
        if self.known is None:
            yield (
                f"Drain time: {busy}. Until then, some robots do not see each other. Losses make "
                "startup longer."
            )
        else:
            yield f"{self.known.sentence()} {words.capitalized(busy)} (drain time)."
        if self.startup.ranges:
            middle = self.startup.simulated
            simulated = ""
            if middle is not None:
                simulated = f" The simulation needed {words.duration(middle)}."
            yield (
                "The shorter time assumes full A-MPDUs, and the longer time one message per frame."
                f"{simulated} A-MPDUs are fuller when more frames wait."
            )
        if not words.fits(steady.single) and math.isfinite(self.window):
            yield (
                "The fleet may never fit: with one message per frame, its periodic traffic alone "
                f"needs {words.percent(steady.single)} of the channel."
            )

    def _cost_in_words(self) -> Iterator[str]:
        hosts = sum(group.hosts for group in self.fleet.groups)
        ends = (self.span if self.span.ranges else _point(self.utilization)).ends
        if math.isfinite(self.window):
            low, high = (end * self.window for end in ends)
            takes = f"{words.durations(low, high)} of airtime"
        else:
            takes = f"{words.percents(*ends)} of the time"
        fit = {"fits": "so it fits", "may fit": "so it may fit"}.get(
            self.verdict, "so it does not fit"
        )
        yield (
            f"Discovery of {words.many(hosts, 'host')} with "
            f"{words.many(self.fleet.processes(), 'process', 'es')} needs {takes} with "
            f"{self.protocol.name}."
        )
        if math.isinf(self.window):
            share = _charged(ends, "of the channel", "its capacity")
            yield f"That is {share} in the steady state, {fit}."
        elif self.window == PAPER_WINDOW:
            share = _charged(ends, "of it", "its capacity")
            yield f"Charged to one second, that is {share}, {fit}."
        else:
            share = _charged(ends, "of them", "their capacity")
            yield f"Charged to the first {self.window:g} s, that is {share}, {fit}."
        if self.reboot is not None:
            robot = f" ({self.reboot.group})" if len(self.fleet.groups) > 1 else ""
            yield (
                f"When one robot{robot} reboots, discovery needs "
                f"{words.durations(self.reboot.low, self.reboot.high)} of airtime."
            )
        exchanges = "one message per frame"
        if self.span.ranges:
            exchanges = "64 messages to one per A-MPDU"
        yield (
            f"Channel: {self.wifi.name}, {TOPOLOGY}. Assumes: no losses · no collisions · "
            f"{exchanges}."
        )

    def _basis_in_words(self) -> Iterator[str]:
        """Yield how far the answer can be trusted, and how it was counted."""
        if self.known is None:
            yield (
                "Overflowing queues can make startup many times longer. `discostorm simulate` "
                "shows by how much."
            )
        if self.protocol.captured is not None:
            hosts = sum(group.hosts for group in self.fleet.groups)
            endpoints = max(group.endpoints for group in self.fleet.groups)
            matched = Unit("matched endpoint").count(self.fleet)
            sizes = (hosts, self.fleet.processes(), endpoints)
            most = self.protocol.captured
            beyond = any(own > seen for own, seen in zip(sizes, most, strict=True))
            extrapolated = " This fleet is extrapolated." if beyond else ""
            yield (
                f"The measured model of {self.protocol.name} comes from captures of up to "
                f"{words.many(most[0], 'host')} and {words.many(most[1], 'process', 'es')} with up "
                f"to {words.many(most[2], 'endpoint')} each, which started together.{extrapolated}"
            )
            if self.band is not None:
                yield self.band.sentence()
            share = words.percent(matched / (ENDPOINT.count(self.fleet) or 1))
            yield f"In this fleet, {share} of the endpoints match in every process."
        if self.protocol.repeats:
            of_paper = {*DDS.messages, *ZENOH.messages}
            papers = [m.name for m in self.protocol.messages if m in of_paper]
            if papers:
                yield (
                    f"{self.protocol.name} counts {words.listed(papers)} as the paper does. It "
                    "leaves out the messages that the product packs together or adds."
                )
            if math.isfinite(self.window):
                yield (
                    "The whole burst is charged to this time, and periodic traffic at its rate. "
                    "The result is an upper bound of the count."
                )
        timed = [r.before for r in self.remedies if r.wifi != self.wifi]
        before = next((value for value in timed if value != self.utilization), None)
        if before is not None and not self.span.ranges:
            yield (
                "Changes of the radio are compared by standard timing, with which this fleet needs "
                f"{words.airtime(before, self.window)} today."
            )

    def _shares_in_words(self) -> Iterator[str]:
        for kind in ("message", "phase"):
            largest = self.of_kind(kind)[0]
            what = "message type" if kind == "message" else kind
            yield f"- {words.capitalized(what)}: {largest.name}, {words.part(largest.share)}."
        groups = self.of_kind("group")
        if len(groups) > 1:
            for group in groups[:_GROUPS]:
                yield f"- Group {group.name}: involved in {words.part(group.share)} of it."
        if len(groups) > _GROUPS:
            rest, most = len(groups) - _GROUPS, words.part(groups[_GROUPS].share)
            if rest == 1:
                yield f"- 1 further group: involved in at most {most} of it."
            else:
                yield f"- {rest} further groups: each involved in at most {most} of it."

    @staticmethod
    def _ranked(remedies: Sequence[Remedy], first: int) -> Iterator[str]:
        """Yield remedies with their places, effort, price and what fails."""
        for place, remedy in enumerate(remedies, start=first):
            yield f"{place:2}. {words.capitalized(remedy.sentence())}."
            yield f"    {remedy.caution()}"


def _by(protocol: Protocol) -> str:
    """Return a table and its kind of model, as a baseline is called."""
    kinds = {"paper": "paper model", "timed": "timed model", "measured": "measured model"}
    kind = {**kinds, "mitigated": "measured model", "proposal": "proposal"}.get(
        protocol.basis or ""
    )
    return f"{protocol.name}, {kind}" if kind else protocol.name


def _point(value: float) -> Span:
    """Return a number without a range as one."""
    return Span(value, None, value)


def _charged(ends: tuple[float, float], to: str, capacity: str) -> str:
    """Return the load of a time in words, from one end to the other."""
    low, high = (words.charged(end, to, capacity) for end in ends)
    return low if low == high else f"{low} to {high}"
