"""A plan: what discovery costs, what dominates and what would help, as data, tables and JSON."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any, Literal

from discostorm import _checks, _names, wording
from discostorm.data import read_data
from discostorm.files import json_ready
from discostorm.fleet import Fleet
from discostorm.messages import Protocol
from discostorm.prediction_error import ErrorBand
from discostorm.wifi import Wifi
from discostorm.wifi.radio import TOPOLOGY
from discostorm_planner import answer_text, explanation_text
from discostorm_planner.aggregation_range import AggregationRange, ChannelFit
from discostorm_planner.change_simulation import (
    DiscoveryResult,
    paste_name,
    simulate_changes,
    simulate_late_join,
    simulate_unchanged,
)
from discostorm_planner.changes import Setting
from discostorm_planner.discovery_time import DiscoveryTime
from discostorm_planner.further_loads import ConfigurationLoad, RebootAirtime, UserDataLoad
from discostorm_planner.remedy import Remedy
from discostorm_planner.remedy_rules import MIN_SAVING
from discostorm_planner.simulation_jobs import WITHIN_S, Progress

if TYPE_CHECKING:
    import pandas as pd

#: Maximum number of changes in an explanation by airtime, and keys of discovery times in tables.
_MAX_EXPLAINED = 3
TIME_KEYS = ("median_s", "low_s", "high_s", "nine_of_ten_s", "runs_with_expired_leases")


@dataclass(frozen=True)
class Share:
    """How much of the airtime a message, a phase or a group of hosts takes.

    Parameters
    ----------
    kind : {"message", "phase", "group"}
        What the share is of.
    name : str
        Its name.
    utilization : float
        Share of the window [1]. For a group, the utilization that its absence would save. Groups
        overlap; messages and phases do not.
    share : float
        Share of the airtime of discovery [1].
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
        The hosts on the channel.
    protocol : Protocol
        The middleware.
    wifi : Wifi
        The channel, with one frame in each exchange.
    window : float
        Averaging time of the utilization [s]; infinity for the steady state.
    utilization_range, steady_range : AggregationRange
        Share of the window that discovery takes [1], and share of the channel that periodic
        traffic takes [1]; if the latter is 1 or more, no startup fits, however slow it is.
    startup : AggregationRange
        Drain time: how long startup keeps the channel busy, if nothing is lost [s].
    shares : tuple of Share
        Messages, phases and groups with one frame per exchange, the largest of each kind first.
    remedies : tuple of Remedy
        Single changes: first those that make the fleet fit, the easiest on top, then those that
        save most. In both parts, gains that need the best case come later. Prototypes come last,
        but before changes after which some hosts no longer discover each other.
    combinations : tuple of Remedy
        The best of two or three changes together, in the same order. Each needs all its changes.
    staggered : tuple of Remedy
        Changes that need no other middleware, each with a staggered start.
    not_applicable : tuple of str
        Changes that do not apply or cannot be computed, with the reason.
    configurations : tuple of ConfigurationLoad
        The same fleet with every measured configuration, the one with the shortest startup first.
    reboot : RebootAirtime or None
        Airtime of one robot that reboots; None if that was not measured.
    band : ErrorBand or None
        Prediction error of a measured table; None for other tables.
    data : UserDataLoad or None
        Load of the fleet's user data; None if it sends none. Only this field and `discovery` count
        user data.
    within : float
        Target of the discovery time [s].
    ampdu_frames : int
        Frames of a full A-MPDU [1]; 1 if nothing aggregates.
    cells : tuple of (str, AggregationRange)
        Cells by name with the share of the window that discovery takes in each [1]; empty if there
        is one access point.
    """

    fleet: Fleet
    protocol: Protocol
    wifi: Wifi
    window: float
    utilization_range: AggregationRange
    steady_range: AggregationRange
    startup: AggregationRange
    shares: tuple[Share, ...]
    remedies: tuple[Remedy, ...]
    combinations: tuple[Remedy, ...]
    staggered: tuple[Remedy, ...]
    not_applicable: tuple[str, ...]
    configurations: tuple[ConfigurationLoad, ...]
    reboot: RebootAirtime | None = None
    band: ErrorBand | None = None
    data: UserDataLoad | None = None
    within: float = WITHIN_S
    ampdu_frames: int = 1
    cells: tuple[tuple[str, AggregationRange], ...] = ()

    @cached_property
    def discovery(self) -> DiscoveryResult:
        """The discovery time today and after each change, simulated at the first use."""
        return self.simulate()

    @cached_property
    def late_join(self) -> DiscoveryTime | None:
        """Discovery time of a robot that starts after all others; None if not simulated."""
        today = None if self.all_wired or self.fleet.hosts() == 1 else self.discovery.today
        try:
            return simulate_late_join(self._setting, today) if today else None
        except KeyboardInterrupt:
            return None

    def simulate(
        self,
        progress: Progress | None = None,
        tell: Callable[[str], object] | None = None,
        *,
        interruptible: bool = False,
    ) -> DiscoveryResult:
        """Simulate `discovery`; call ``progress`` with the finished and the total work [s].

        ``tell`` gets the verdict on the unchanged fleet, before its changes are simulated.
        """

        def report(found: DiscoveryResult) -> None:
            unchanged = replace(self)
            vars(unchanged)["discovery"] = found
            if tell:
                tell(answer_text.verdict(unchanged))

        found = simulate_changes(
            *(self._setting, self.remedies, self.combinations, self.within),
            staggered=self.staggered,
            progress=progress,
            report=report,
            interruptible=interruptible,
        )
        vars(self)["discovery"] = found
        return found

    @property
    def _setting(self) -> Setting:
        return Setting(self.fleet, self.protocol, self.wifi, self.ampdu_frames)

    @property
    def utilization(self) -> float:
        """The share of the window [1], with one frame in each exchange."""
        return self.utilization_range.single

    @property
    def steady(self) -> float:
        """The share of the channel that periodic traffic takes [1], with one frame per exchange."""
        return self.steady_range.single

    @property
    def verdict(self) -> ChannelFit:
        """Whether the fleet fits: with one frame per exchange, only with full A-MPDUs, or never."""
        return self.utilization_range.verdict

    @property
    def all_wired(self) -> bool:
        """Whether all hosts are wired, so that none uses the channel."""
        return all(group.wired for group in self.fleet.groups)

    def shares_of_kind(self, kind: str) -> tuple[Share, ...]:
        """Return the shares of one kind, the largest first: message, phase or group."""
        return tuple(share for share in self.shares if share.kind == kind)

    def to_frame(self) -> pd.DataFrame:
        """Tabulate the remedies in their order, then the combinations.

        Returns
        -------
        pandas.DataFrame
            Indexed by the change, with columns kind, before and utilization [1], saved [1],
            best_case, fits, start_within_s [s], effort [1], from 1 on, all_find_each_other, price
            (its trade-offs), fails and note.
        """
        import pandas as pd

        columns = [
            *("kind", "before", "utilization", "saved", "best_case", "fits", "start_within_s"),
            *("effort", "all_find_each_other", "price", "fails", "note"),
        ]
        rows = [remedy.to_dict() for remedy in (*self.remedies, *self.combinations)]
        index = pd.Index([row["what"] for row in rows], name="remedy")
        return pd.DataFrame({name: [row[name] for row in rows] for name in columns}, index)

    def to_dict(self, *, simulate: bool = True) -> dict[str, Any]:
        """Return a dict for JSON, with None for an infinite window.

        Without simulations, `discovery` and "known_again", the times of a rebooted robot, are left
        out. For a fleet with cells, everything that describes a single cell is left out, too.
        """
        again = self.late_join.to_dict() if simulate and self.late_join else {}
        reboot = {key: again[key] for key in TIME_KEYS if again} or None
        found = {"discovery": self.discovery.to_dict(), "known_again": reboot} if simulate else {}
        if self.cells:
            rows = {name: used.to_dict() for name, used in self.cells}
            return {"protocol": self.protocol.name, "cells": rows, **found}
        return {
            "protocol": self.protocol.name,
            "wifi": self.wifi.name,
            "topology": TOPOLOGY,
            "fleet": self.fleet.to_dicts(),
            "steady": self.steady,
            "steady_fits": wording.below_capacity(self.steady),
            "window_s": json_ready(self.window),
            "utilization": self.utilization,
            "fits": self.verdict == "fits",
            "verdict": self.verdict,
            "range": self.utilization_range.to_dict(),
            "startup": self.startup.to_dict(),
            "reboot": self.reboot.to_dict() if self.reboot else None,
            "band": self.band.to_dict() if self.band else None,
            **({"data": self.data.to_dict()} if self.data else {}),
            "shares": [asdict(share) for share in self.shares],
            "remedies": [remedy.to_dict() for remedy in self.remedies],
            "combinations": [remedy.to_dict() for remedy in self.combinations],
            "left_out": list(self.not_applicable),
            "configurations": [row.to_dict() for row in self.configurations],
            **found,
        }

    def to_json(self) -> str:
        """Return `to_dict` as text."""
        return json.dumps(self.to_dict(), indent=2, ensure_ascii=False)

    def sections(self) -> dict[str, tuple[Remedy, ...]]:
        """Return the remedies that `why` explains, by the title of their section."""
        if self.all_wired or self.fleet.hosts() == 1:
            return {}
        found, of_kind = self.discovery, dict[str, Remedy]()
        for remedy in self.remedies:
            if remedy.saved >= MIN_SAVING and remedy.all_discover:
                of_kind.setdefault(remedy.kind, remedy)
        airtime = [r for r in of_kind.values() if "research" not in r.efforts][:_MAX_EXPLAINED]
        parts = [c.remedy for c in found.changes if c.time and not c.remedy.all_discover]
        sections = {
            "Changes, in the same order as above:": [change.remedy for change in found.helpful],
            "Changes by airtime, because no discovery time was simulated:": (
                [] if found.today or found.helpful else airtime
            ),
            "Changes after which some hosts no longer discover each other:": parts,
        }
        return {title: tuple(remedies) for title, remedies in sections.items() if remedies}

    def find_change(self, name: str) -> Remedy:
        """Return the best change of a kind, or the change with a given description.

        Kinds have other names, too (``data/vendors/change_names.csv``). What a plan adds to a
        description, such as ", at random times within 10 s", may stay.
        """
        remedies = (*self.remedies, *self.combinations, *self.staggered)
        named: dict[str, Remedy] = {}
        for remedy in remedies:
            named.setdefault(paste_name(remedy, remedies), remedy)
            named.setdefault(remedy.what, remedy)
        others = read_data("vendors/change_names.csv", "discostorm_planner")
        for row in others:
            if row["kind"] in named:
                named.setdefault(row["name"], named[row["kind"]])
        found = {_bare_name(key): remedy for key, remedy in reversed(named.items())}
        wanted = _bare_name(name)
        if wanted in found:
            return found[wanted]
        like = _names.did_you_mean(name, [one for one in named if "staggered" not in one])
        if wanted in {_bare_name(row[of]) for row in others for of in ("name", "kind")}:
            like = f" here: {self.protocol.name} has it already or cannot have it"
        like = like or "; `plan --all` lists them"
        raise ValueError(f"no change is named {_checks.shorten_name(name)!r}{like}")

    def advice(self, width: int = 79, *, all_changes: bool = False) -> str:
        """Say whether the startup works and what to do first, in lines of that width.

        With ``all_changes``, name all changes that were tried.
        """
        _checks.integer("width", width, 1)
        return answer_text.format_answer(self, int(width), all_changes=all_changes)

    def why(self, width: int = 79) -> str:
        """Explain drain time, airtime and its parts, changes, configurations and assumptions."""
        _checks.integer("width", width, 1)
        return explanation_text.format_explanation(self, int(width))

    def __str__(self) -> str:
        return self.advice()


def _bare_name(name: str) -> str:
    """Return a change's name in lower case, without article, plural, window and number."""
    name = re.sub(
        r"(?i), at random times within .*| or fewer\b|^(an?|another|the) ", "", name.strip()
    )
    return _names.normalize(re.sub(r"(processes\b.* into) \d+", r"\1 1", name)).removesuffix("s")


def simulate_protocols(plans: Sequence[Plan], progress: Progress | None = None) -> None:
    """Simulate the unchanged fleets of plans that share a target, without their changes."""
    settings = [plan._setting for plan in plans]
    found = simulate_unchanged(settings, plans[0].within, progress=progress)
    for plan, discovery in zip(plans, found, strict=True):
        vars(plan)["discovery"] = discovery
