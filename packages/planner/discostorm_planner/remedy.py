"""A remedy: what is changed, what it brings and what it takes."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cache
from typing import Any

from discostorm import words
from discostorm.data import read_data
from discostorm.fleet import Fleet
from discostorm.messages import PAPER_WINDOW, Protocol
from discostorm.snippets import Snippet, snippets
from discostorm.wifi import Wifi
from discostorm_planner.aggregation_range import Span, Verdict
from discostorm_planner.remedy_rules import software

#: Changes of less than this are not told apart [1].
NOTHING = 0.005


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
        `discostorm_simulation.staggered.window`; infinity where what is repeated fills the channel.
    steady : float
        What is repeated then takes of the channel [1].
    best_case : bool
        Whether a part of the gain is that of the best case, as that of exchanges that are all full.
    span, was : Span, optional
        What `utilization` and `before` lie between on a radio that aggregates; if left out they
        have no range.
    basis : str
        By which of these values they were computed, before and after alike: "simulated" or "one
        frame in each exchange"; empty where there is no range.
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
    span: Span | None = None
    was: Span | None = None
    basis: str = ""

    @property
    def verdict(self) -> Verdict:
        """Whether it fits with it: at both ends of the range, at the better one, or at none."""
        return _verdict(self.span, self.utilization)

    @property
    def may_now_fit(self) -> bool:
        """Whether it may fit with it, but surely did not without."""
        return self.verdict == "may fit" and _verdict(self.was, self.before) == "does not fit"

    @property
    def saved(self) -> float:
        """What it saves as a part of what there was before [1]; negative if it costs more.

        Where nothing was sent before it is 0, whatever is sent then.
        """
        return 1 - self.utilization / self.before if self.before else 0.0

    @property
    def now_fits(self) -> bool:
        """Whether it surely fits with it and did not without."""
        return self.verdict == "fits" and _verdict(self.was, self.before) != "fits"

    @property
    def rank(self) -> int:
        """How hard the hardest of its changes is, from 1 on [1]."""
        return max((int(_efforts()[name]["rank"]) for name in self.efforts), default=0)

    @property
    def snippets(self) -> tuple[Snippet, ...]:
        """What to paste."""
        radio, of = self.wifi.radio, self.protocol
        names = [software(of), of.family]
        if of.basis != "mitigated":
            names.append(f"{of.family} peers")
        if radio is not None:
            names.append(f"{radio.standard} {radio.width / 1e6:g} MHz")
            names.append(f"{radio.carrier / 1e9:g} GHz {radio.width / 1e6:g} MHz")
        known = [name for name in names if name]
        return tuple(piece for kind in self.steps for piece in snippets(kind, *known))

    def sentence(self) -> str:
        """Return what it brings, whether that fits, and what is compared, in words."""
        fits = ""
        if self.now_fits:
            sure = not (self.best_case or self.wifi.aggregation is not None)
            fits = ", which fits" if sure else ", which would fit"
        elif self.may_now_fit:
            fits = ", which may fit"
        return words.sentences(f"{self.what} {self.brings()}{fits}", self.note)

    def brings(self) -> str:
        """Return what it brings, in words that follow its name."""
        before, after = (
            words.airtime(value, self.window) for value in (self.before, self.utilization)
        )
        s = "" if self._plural else "s"
        if self.kind == "staggered start":
            brings = (
                f"spreads the same {before} of airtime over at least {words.duration(self.spread)}"
            )
        elif self.utilization and not self.before:
            brings = f"add{s} {after}; nothing was sent before"
        elif abs(self.saved) < NOTHING:
            brings = f"change{s} less than {NOTHING:.1%}"
        elif self.saved < 0:
            brings = f"add{s} {words.percent(-self.saved)}: {before} becomes {after}"
        else:
            # What is left may be less than what numbers tell apart from all.
            most = math.nextafter(1, 0) if self.utilization else 1.0
            brings = f"cut{s} {before} to {after} ({words.percent(min(self.saved, most))})"
            if self.basis:
                brings += ", simulated" if self.basis == "simulated" else f", with {self.basis}"
            if self.best_case:
                brings += " at best"
        return brings

    @property
    def _plural(self) -> bool:
        """Whether the change is told in the plural: several of them, or things without article."""
        first = self.what.split()[0]
        one = first in ("a", "an", "another", "the") or is_doing(self.what)
        return self.kind == "combination" or not one

    def caution(self) -> str:
        """Return what it takes, what to mind and what fails when, in words."""
        efforts = list(dict.fromkeys(_efforts()[name]["what"] for name in self.efforts))
        mind = "; ".join(filter(None, (self.price, self.fails)))
        later = ""
        if not words.fits(self.steady):
            later = (
                f" Periodic traffic still needs {words.percent(self.steady)} of the channel, so "
                "the fleet never fits."
            )
        elif self.kind == "combination" and self.verdict == "does not fit":
            later = f" Spread the starts over {words.duration(self.spread)}."
        return f"Effort: {words.listed(efforts)}. Trade-offs: {mind}.{later}"

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
            "fits": self.verdict == "fits",
            "verdict": self.verdict,
            "basis": self.basis,
            "range": (self.span or Span(self.utilization, None, self.utilization)).to_dict(),
            "steady": self.steady,
            "start_within_s": self.spread if math.isfinite(self.spread) else None,
            "paste": [piece.to_dict() for piece in self.snippets],
        }


def _verdict(span: Span | None, value: float) -> Verdict:
    """Return whether a range fits, or a number that has none."""
    ranges = span is not None and span.ranges
    return (span if ranges and span else Span(value, None, value)).verdict


def is_doing(what: str) -> bool:
    """Return whether a change is told as what is done, not as a thing."""
    return what.split()[0].endswith("ing")


@cache
def _efforts() -> dict[str, dict[str, str]]:
    return {row["effort"]: row for row in read_data("vendors/efforts.csv", "discostorm_planner")}
