"""A remedy: a change, or several combined, with its gain and its trade-offs."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from discostorm.fleet import Fleet
from discostorm.messages import Protocol
from discostorm.snippets import Snippet, snippets
from discostorm.wifi import Wifi
from discostorm_planner import plan_text
from discostorm_planner.aggregation_range import AggregationRange, Verdict, finite_or_none
from discostorm_planner.remedy_rules import efforts, software


@dataclass(frozen=True)
class Remedy:
    """A change of a fleet, its middleware or its channel, and by how much it helps.

    Parameters
    ----------
    kind : str
        A kind of ``data/vendors/remedies.csv``, or "combination".
    what : str
        The change, in words that a sentence can start with.
    trade_offs : str
        Its disadvantages.
    failure_mode : str
        What fails, and when; empty if nothing does.
    all_discover : bool
        Whether all hosts still discover each other.
    fleets : tuple of Fleet
        The changed fleet; of a split fleet its parts.
    protocol : Protocol
        The middleware.
    wifi : Wifi
        The channel.
    range_before, range_after : AggregationRange
        Utilization without and with it [1], with a table and on a channel of the same kind; of
        parts on one channel their sum, on several channels the fullest.
    steady_range : AggregationRange
        Share of the channel that periodic traffic takes with it [1].
    basis : str
        Which value of these ranges counts, before and after: "simulated" or "one frame in each
        exchange"; empty where the ends do not differ.
    window : float
        Seconds that are averaged [s]; infinity for the steady state.
    start_window : float
        Within how long hosts should start so that the channel can carry their startup [s]:
        `discostorm_planner.staggered.window`; infinity where periodic traffic fills the channel.
    note : str
        What is compared, or left out; may be empty.
    efforts : tuple of str
        Efforts of its changes, named in ``data/vendors/efforts.csv``.
    steps : tuple of str
        Kinds of its changes: one, or several of a combination.
    best_case : bool
        Whether a part of the gain needs the best case, such as full exchanges.
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
    basis: str
    window: float
    start_window: float
    note: str
    efforts: tuple[str, ...]
    steps: tuple[str, ...]
    best_case: bool

    @property
    def before(self) -> float:
        """The utilization without it [1]."""
        return self._value(self.range_before)

    @property
    def utilization(self) -> float:
        """The utilization with it [1]."""
        return self._value(self.range_after)

    @property
    def steady(self) -> float:
        """The share of the channel that periodic traffic takes with it [1]."""
        return self._value(self.steady_range)

    def _value(self, numbers: AggregationRange) -> float:
        return numbers.value if self.basis == "simulated" else numbers.single

    @property
    def verdict(self) -> Verdict:
        """Whether the fleet fits with it: at both ends of the range, at the better one, or not."""
        return self.range_after.verdict

    @property
    def now_fits(self) -> bool:
        """Whether the fleet surely fits with it and did not without."""
        return self.verdict == "fits" and self.range_before.verdict != "fits"

    @property
    def may_now_fit(self) -> bool:
        """Whether the fleet may fit with it, but surely did not without."""
        return self.verdict == "may fit" and self.range_before.verdict == "does not fit"

    @property
    def saved(self) -> float:
        """Saved share of the utilization before [1]; negative if it costs more, 0 if that was 0."""
        return 1 - self.utilization / self.before if self.before else 0.0

    @property
    def rank(self) -> int:
        """Rank of the hardest effort, from 1 on [1]."""
        return max((int(efforts()[name]["rank"]) for name in self.efforts), default=0)

    @property
    def snippets(self) -> tuple[Snippet, ...]:
        """The configuration to copy."""
        radio, protocol = self.wifi.radio, self.protocol
        names = [software(protocol), protocol.family]
        if protocol.basis != "mitigated":
            names.append(f"{protocol.family} peers")
        if radio is not None:
            names.append(f"{radio.standard} {radio.width / 1e6:g} MHz")
            names.append(f"{radio.carrier / 1e9:g} GHz {radio.width / 1e6:g} MHz")
        targets = [name for name in names if name]
        return tuple(piece for kind in self.steps for piece in snippets(kind, *targets))

    def sentence(self) -> str:
        """Say what it saves, whether the fleet fits then, and what is compared."""
        return plan_text.remedy_sentence(self)

    def brings(self) -> str:
        """Say what it saves, in words that follow its name."""
        return plan_text.remedy_gain(self)

    def caution(self) -> str:
        """Say its effort, its trade-offs and what fails when."""
        return plan_text.remedy_caution(self)

    def to_dict(self) -> dict[str, Any]:
        """Return what JSON can hold."""
        return {
            "kind": self.kind,
            "steps": list(self.steps),
            "what": self.what,
            "effort": self.rank,
            "efforts": [efforts()[name]["what"] for name in self.efforts],
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
            "basis": self.basis,
            "range": self.range_after.to_dict(),
            "steady": self.steady,
            "start_within_s": finite_or_none(self.start_window),
            "paste": [piece.to_dict() for piece in self.snippets],
        }
