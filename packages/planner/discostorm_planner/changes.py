"""A fleet with its middleware and channel, and changes of them that can be combined."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

from discostorm.fleet import Fleet
from discostorm.messages import Protocol
from discostorm.wifi import Radio, Wifi
from discostorm.wifi.radio import most_mpdus

#: Changes are applied in this order: whichever radio replaces another, the multicast rate and the
#: aggregation are those that were asked for.
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
        """The channel of full A-MPDUs; the same channel where nothing aggregates."""
        radio = self.wifi.radio
        if self.ampdu_frames == 1 or radio is None:
            return self.wifi
        return replace(radio, mpdus=min(self.ampdu_frames, most_mpdus(radio.standard))).wifi()

    def with_changes(self, steps: Sequence[Change]) -> Setting:
        """Apply all of these changes."""
        fleet, protocol, radio = self.fleet, self.protocol, self.wifi.radio
        for step in steps:
            fleet = step.fleet(fleet) if step.fleet else fleet
            protocol = step.table or protocol
            if step.radio:
                assert radio is not None
                radio = step.radio(radio)
        wifi = self.wifi if radio in (None, self.wifi.radio) else radio.wifi()
        return replace(self, fleet=fleet, protocol=protocol, wifi=wifi)

    def baseline_of(self, steps: Sequence[Change]) -> Setting:
        """Return the baseline of these changes: a table and a channel of the same kind."""
        protocol = next((step.base for step in steps if step.base), self.protocol)
        wifi = self.wifi
        if any(step.radio for step in steps):
            assert wifi.radio is not None
            wifi = replace(wifi.radio.wifi(), name=wifi.name)
        return replace(self, protocol=protocol, wifi=wifi)


@dataclass(frozen=True, eq=False)
class Change:
    """A change to compute; a combination has at most one change of each ``slot``."""

    kind: str
    what: str
    slot: str
    fleet: Callable[[Fleet], Fleet] | None = None
    parts: tuple[Fleet, ...] = ()
    table: Protocol | None = None
    #: The table to compare with, if not the plan's.
    base: Protocol | None = None
    radio: Callable[[Radio], Radio] | None = None
    #: A note on the change alone, and its part that holds in a combination, too.
    note: str = ""
    basis_note: str = ""
    steps: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "steps", self.steps or (self.kind,))
