"""A fleet with its middleware and channel, and changes of them that can be combined."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

from discostorm.fleet import Fleet
from discostorm.messages import Protocol
from discostorm.model import burst, utilization
from discostorm.wifi import Radio, Wifi
from discostorm.wifi.radio import most_mpdus
from discostorm_planner.aggregation_range import AggregationRange, drain_time_range

#: Order in which changes are applied: the multicast rate and the aggregation come after the radio,
#: so that they hold for the new radio.
SLOTS = ("endpoints", "processes", "table", "radio", "multicast rate", "aggregation")


@dataclass(frozen=True)
class Setting:
    """A fleet, its middleware, and its channel with one frame in each exchange.

    A radio that aggregates puts up to ``ampdu_frames`` frames into an exchange.
    """

    fleet: Fleet
    protocol: Protocol
    wifi: Wifi
    ampdu_frames: int = 1

    @property
    def full_ampdu_wifi(self) -> Wifi:
        """The channel with full A-MPDUs; the same channel if its radio does not aggregate."""
        radio = self.wifi.radio
        if self.ampdu_frames == 1 or radio is None:
            return self.wifi
        return replace(radio, mpdus=min(self.ampdu_frames, most_mpdus(radio.standard))).wifi()

    def utilization(self, window: float, phase: str | None = None) -> float:
        """Return the utilization, or that of a phase, with one frame in each exchange [1]."""
        return float(utilization(self.protocol, self.fleet, None, None, self.wifi, phase, window))

    def utilization_range(self, window: float, phase: str | None = None) -> AggregationRange:
        """Return the utilization of the channel in the first ``window`` seconds [1]."""
        return self._at_both_ends(lambda end: end.utilization(window, phase))

    @property
    def burst_range(self) -> AggregationRange:
        """The airtime of the startup burst [s]."""
        return self._at_both_ends(lambda e: float(burst(e.protocol, e.fleet, wifi=e.wifi)))

    @property
    def steady_range(self) -> AggregationRange:
        """The share of the channel that periodic traffic takes [1]."""
        repeats = self.protocol.repeats
        return self.utilization_range(math.inf) if repeats else AggregationRange(0.0, 0.0)

    @property
    def drain_time_range(self) -> AggregationRange:
        """How long startup keeps the channel busy, without losses and collisions [s]."""
        return drain_time_range(self.burst_range, self.steady_range)

    def _at_both_ends(self, compute: Callable[[Setting], float]) -> AggregationRange:
        return AggregationRange(compute(replace(self, wifi=self.full_ampdu_wifi)), compute(self))

    def with_changes(self, steps: Sequence[Change]) -> Setting:
        """Return the setting after these changes."""
        fleet, protocol, radio = self.fleet, self.protocol, self.wifi.radio
        for step in steps:
            fleet = step.fleet(fleet) if step.fleet else fleet
            protocol = step.table or protocol
            if radio and step.radio:
                radio = step.radio(radio)
        wifi = self.wifi if radio in (None, self.wifi.radio) else radio.wifi()
        return replace(self, fleet=fleet, protocol=protocol, wifi=wifi)

    def baseline_of(self, steps: Sequence[Change]) -> Setting:
        """Return the setting to compare these changes with: same timing, and a comparable table."""
        protocol = next((step.baseline for step in steps if step.baseline), self.protocol)
        wifi = self.wifi
        if wifi.radio and any(step.radio for step in steps):
            wifi = replace(wifi.radio.wifi(), name=wifi.name)
        return replace(self, protocol=protocol, wifi=wifi)


@dataclass(frozen=True, eq=False)
class Change:
    """A change of a fleet, a table or a radio; a combination has at most one for each ``slot``."""

    kind: str
    what: str
    slot: str
    fleet: Callable[[Fleet], Fleet] | None = None
    parts: tuple[Fleet, ...] = ()
    table: Protocol | None = None
    #: The protocol table to compare with, if not the plan's.
    baseline: Protocol | None = None
    radio: Callable[[Radio], Radio] | None = None
    #: A note on the change alone, and the part of the note that also holds in a combination.
    note: str = ""
    combined_note: str = ""
    kinds: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "note", self.note or self.combined_note)
        object.__setattr__(self, "kinds", self.kinds or (self.kind,))
