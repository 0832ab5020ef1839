"""A remedy: a change, or several combined, with its gain and its trade-offs."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from discostorm import wording
from discostorm.files import json_ready
from discostorm.fleet import Fleet
from discostorm.messages import Protocol
from discostorm.snippets import Snippet, snippets
from discostorm.wifi import Wifi
from discostorm_planner import remedy_rules
from discostorm_planner.aggregation_range import AggregationRange, ChannelFit
from discostorm_planner.remedy_rules import MIN_SAVING, is_gerund


@dataclass(frozen=True)
class Remedy:
    """A change of a fleet, its middleware or its channel, with its gain.

    Parameters
    ----------
    kind : str
        Name of a row of ``data/vendors/remedies.csv``, or "combination".
    what : str
        The change, as words that can start a sentence.
    trade_offs, failure_mode : str
        Disadvantages of the change, and a failure that it makes possible, if any.
    all_discover : bool
        Whether all hosts still discover each other.
    fleets : tuple of Fleet
        The changed fleet, or the parts of a split fleet.
    protocol : Protocol
        The middleware after the change.
    wifi : Wifi
        The channel after the change.
    range_before, range_after : AggregationRange
        Utilization without and with the change [1], on comparable tables and channels. Parts of a
        fleet on one channel add up; on several channels, the fullest counts.
    steady_range : AggregationRange
        Share of the channel that periodic traffic takes after the change [1].
    window : float
        Averaging time of the utilization [s]; infinity for the steady state.
    start_window : float
        Shortest window for staggered starts that the channel can carry [s]; infinity if periodic
        traffic fills it.
    note : str
        What was compared or left out; may be empty.
    efforts : tuple of str
        Efforts of the change, named in ``data/vendors/efforts.csv``.
    steps : tuple of str
        Kinds of the change: one, or several for a combination.
    best_case : bool
        Whether part of the gain needs the best case, such as full exchanges.
    """

    kind: str
    what: str
    trade_offs: str
    failure_mode: str
    all_discover: bool
    fleets: tuple[Fleet, ...]
    protocol: Protocol
    wifi: Wifi
    range_before: AggregationRange
    range_after: AggregationRange
    steady_range: AggregationRange
    window: float
    start_window: float
    note: str
    efforts: tuple[str, ...]
    steps: tuple[str, ...]
    best_case: bool

    @property
    def before(self) -> float:
        """Utilization without the remedy [1], with one frame in each exchange."""
        return self.range_before.single

    @property
    def utilization(self) -> float:
        """Utilization with the remedy [1], with one frame in each exchange."""
        return self.range_after.single

    @property
    def steady(self) -> float:
        """Share of the channel that periodic traffic takes with the remedy [1]."""
        return self.steady_range.single

    @property
    def verdict(self) -> ChannelFit:
        """Whether the fleet fits with the remedy: at both ends of the range, at one, or at none."""
        return self.range_after.verdict

    @property
    def now_fits(self) -> bool:
        """Whether the fleet certainly fits with the remedy, but not certainly without."""
        return self.verdict == "fits" and self.range_before.verdict != "fits"

    @property
    def may_now_fit(self) -> bool:
        """Whether the fleet possibly fits with the remedy and certainly did not fit without."""
        return self.verdict == "may fit" and self.range_before.verdict == "does not fit"

    @property
    def saved(self) -> float:
        """Saved share of the utilization before [1]; negative if the remedy costs more."""
        return 1 - self.utilization / self.before if self.before else 0.0

    @property
    def effort_rank(self) -> int:
        """Rank of the most expensive effort [1]; 1 is the least expensive."""
        return max((int(remedy_rules.efforts()[name]["rank"]) for name in self.efforts), default=0)

    @property
    def snippets(self) -> tuple[Snippet, ...]:
        """Configuration to copy."""
        radio, protocol = self.wifi.radio, self.protocol
        names = [remedy_rules.product_of(protocol), protocol.family]
        names += [f"{protocol.family} peers"] * (protocol.basis != "mitigated")
        if radio is not None:
            names.append(f"{radio.standard} {radio.width / 1e6:g} MHz")
            names.append(f"{radio.carrier / 1e9:g} GHz {radio.width / 1e6:g} MHz")
        targets = [name for name in names if name]
        return tuple(piece for kind in self.steps for piece in snippets(kind, *targets))

    def sentence(self) -> str:
        """State the saving, whether the fleet fits then, and the basis of the comparison."""
        fits = ""
        if self.now_fits:
            sure = not (self.best_case or self.wifi.aggregation is not None)
            fits = "the fleet then fits" if sure else "the fleet would then fit"
        elif self.may_now_fit:
            fits = "the fleet may then fit"
        return wording.join_sentences(f"{self.what} {self.gain_clause()}", fits, self.note)

    def gain_clause(self, subject: str = "") -> str:
        """State the saving, as words that follow the remedy's name, or that of another subject."""
        before = wording.airtime_text(self.before, self.window)
        after = wording.airtime_text(self.utilization, self.window)
        before = before.removesuffix(" of the time")  # as `after` ends with it
        article = self.what.split()[0] in ("a", "an", "another", "the") or is_gerund(self.what)
        s = "s" if subject or (article and self.kind != "combination") else ""
        if self.kind == "staggered start":
            over = f" over at least {wording.duration(self.start_window)}"
            return f"{subject}spreads the same airtime" + over * math.isfinite(self.start_window)
        if self.utilization and not self.before:
            return f"{subject}add{s} {after}; nothing was sent before"
        if abs(self.saved) < MIN_SAVING:
            return f"{subject}change{s} the airtime by less than {MIN_SAVING:.1%}"
        # With aggregation, the seconds depend on how many frames wait.
        differs = self.range_before.differs or self.range_after.differs
        if self.saved < 0:
            ends = "" if differs else f" (from {before} to {after})"
            return f"{subject}raise{s} the airtime by {wording.percent(-self.saved)}{ends}"
        # Never write 100% while any airtime is left.
        nearly = self.saved >= 0.995 and self.utilization > 0
        share = "more than 99%" if nearly else wording.percent(self.saved)
        gain = f"the airtime by {share}"
        if before != after and not differs:
            gain = "the airtime from " * bool(subject) + f"{before} to {after} ({share})"
        return f"{subject}cut{s} {gain}" + " if A-MPDUs are full" * self.best_case

    def caution(self) -> str:
        """State the remedy's effort, its trade-offs and its failure mode."""
        effort = remedy_rules.describe_efforts(self.efforts)
        trade_offs = "; ".join(filter(None, (self.trade_offs, self.failure_mode)))
        rest = ""
        low, high = self.steady_range.bounds
        if not wording.below_capacity(high):
            may = wording.below_capacity(low)
            never = "may never fit" if may else "never fits"
            share = f"up to {wording.percent(high)}" if may else wording.percent(low)
            rest = f" Periodic traffic still needs {share} of the channel, so the fleet {never}."
        elif self.kind == "combination" and self.verdict == "does not fit":
            rest = f" Spread the starts over {wording.duration(self.start_window)}."
        return f"Effort: {effort}. Trade-off{'s' * ('; ' in trade_offs)}: {trade_offs}.{rest}"

    def to_dict(self) -> dict[str, Any]:
        """Return a dict for JSON."""
        return {
            "kind": self.kind,
            "steps": list(self.steps),
            "what": self.what,
            "effort": self.effort_rank,
            "efforts": [remedy_rules.efforts()[name]["what"] for name in self.efforts],
            "price": self.trade_offs,
            "fails": self.failure_mode,
            "note": self.note,
            "all_find_each_other": self.all_discover,
            "fleets": [fleet.to_dicts() for fleet in self.fleets],
            "protocol": self.protocol.name,
            "wifi": self.wifi.name,
            "before": self.before,
            "utilization": self.utilization,
            "saved": self.saved,
            "best_case": self.best_case,
            "fits": self.verdict == "fits",
            "verdict": self.verdict,
            "range": self.range_after.to_dict(),
            "steady": self.steady,
            "start_within_s": json_ready(self.start_window),
            "paste": [piece.to_dict() for piece in self.snippets],
        }
