"""Loads beside that of a startup: user data, each measured configuration, one robot's reboot."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

from discostorm import wording
from discostorm.data import read_data
from discostorm.files import json_ready
from discostorm.messages import DATA, PAPER_WINDOW, Protocol
from discostorm.protocols import PROTOCOLS
from discostorm_planner.aggregation_range import AggregationRange, combine, drain_time_range
from discostorm_planner.changes import Setting
from discostorm_planner.remedy_rules import is_measured


@dataclass(frozen=True)
class UserDataLoad:
    """Load of a fleet's user data, without and with discovery."""

    #: Share of the channel for the data alone [1].
    data: AggregationRange
    #: Share for data and periodic traffic [1]: decides whether the data fit after discovery.
    with_periodic: AggregationRange
    #: Share for data and all discovery in the plan's window [1]: whether startup fits.
    with_discovery: AggregationRange
    #: Drain time with data from the beginning, and without data [s]; infinity if the channel
    #: never drains. An upper bound, because robots send data only to discovered processes.
    #: Without queue overflows, no sample waits longer.
    drain_time_with_data: AggregationRange
    drain_time_alone: AggregationRange

    def to_dict(self) -> dict[str, Any]:
        """Return a dict for JSON, with infinity as None."""
        return {
            "utilization": self.data.to_dict(),
            "with_steady_discovery": self.with_periodic.to_dict(),
            "fits_after_startup": self.with_periodic.verdict,
            "with_discovery": self.with_discovery.to_dict(),
            "fits_during_startup": self.with_discovery.verdict,
            "startup": self.drain_time_with_data.to_dict(),
            "startup_without": self.drain_time_alone.to_dict(),
        }


def user_data_load(setting: Setting, window: float) -> UserDataLoad | None:
    """Compute the load of a fleet's user data; None if the fleet sends no data."""
    if not setting.fleet.has_data:
        return None
    data = setting.utilization_range(PAPER_WINDOW, DATA)
    after = combine(sum, [data, setting.steady_range])
    return UserDataLoad(
        data=data,
        with_periodic=after,
        with_discovery=combine(sum, [data, setting.utilization_range(window)]),
        drain_time_with_data=drain_time_range(setting.burst_range, after),
        drain_time_alone=setting.drain_time_range,
    )


@dataclass(frozen=True)
class ConfigurationLoad:
    """The load of a fleet with one measured configuration of a product."""

    #: Name of its table.
    name: str
    #: Share of the plan's window, with one frame in each exchange [1].
    utilization: float
    #: Drain time [s]; infinity if the channel never catches up.
    startup: AggregationRange
    #: Share of the channel that periodic traffic takes [1].
    steady_range: AggregationRange

    def to_dict(self) -> dict[str, Any]:
        """Return a dict for JSON, with None for a startup that never ends."""
        return {
            "protocol": self.name,
            "utilization": self.utilization,
            "fits": wording.below_capacity(self.utilization),
            "start_s": json_ready(self.startup.single),
            "steady": self.steady_range.single,
            "startup": self.startup.to_dict(),
        }


def compare_configurations(setting: Setting, window: float) -> tuple[ConfigurationLoad, ...]:
    """Compute every measured configuration, the one with the shortest startup first.

    Tables that products use only on wired networks are left out.
    """
    wired = {table.wired.key for table in PROTOCOLS.values() if table.wired}
    rows = [
        ConfigurationLoad(name, own.utilization(window), own.drain_time_range, own.steady_range)
        for name, table in PROTOCOLS.items()
        if is_measured(table) and table.key not in wired
        for own in (replace(setting, protocol=table),)
    ]
    rows.sort(key=lambda r: (r.startup.single, r.startup.full, r.steady_range.single))
    return tuple(rows)


@dataclass(frozen=True)
class RebootAirtime:
    """Airtime that the reboot of one robot adds."""

    #: Name of the robot's group: the group with the most expensive reboot.
    group: str
    #: Bounds of the airtime [s]: the smallest measured factor with full A-MPDUs, and the largest
    #: measured factor with one frame per exchange.
    low: float
    high: float
    #: Share of the fleet's pairs of processes that include a process of this robot [1].
    share: float

    def to_dict(self) -> dict[str, Any]:
        """Return a dict for JSON."""
        return {
            "group": self.group,
            "low_s": self.low,
            "high_s": self.high,
            "share": self.share,
            "source": "data/measured/restarts.csv",
        }


def reboot_airtime(setting: Setting) -> RebootAirtime | None:
    """Compute the reboot of one robot; None if no restart of its product was measured.

    In a common startup, each pair of processes takes an equal share of the airtime. We measured how
    many times this share the pairs took when a process restarted within its lease, and when a host
    joined (`low` to `high` in ``data/measured/restarts.csv``). A reboot is one of these two events.
    """
    factors, fleet = restart_factors(setting.protocol), setting.fleet
    processes = float(fleet.processes())
    local_pairs = sum(float(group.hosts) * float(group.processes) ** 2 for group in fleet.groups)
    # Ordered pairs of processes on different hosts.
    robot_pairs = {
        name: 2 * float(group.processes) * (processes - float(group.processes))
        for name, group in zip(fleet.names, fleet.groups, strict=True)
        if not group.wired
    }
    if not factors or not robot_pairs or processes**2 <= local_pairs:
        return None
    group = max(robot_pairs, key=lambda name: robot_pairs[name])
    share = robot_pairs[group] / (processes**2 - local_pairs)
    low, high = setting.burst_range.bounds
    return RebootAirtime(group, low * share * min(factors), high * share * max(factors), share)


def restart_factors(protocol: Protocol) -> list[float]:
    """Return the smallest and the largest factor of restarts and joins; empty if not measured.

    A factor is the airtime of the pairs concerned, relative to theirs in a common startup [1].
    """
    rows = read_data("measured/restarts.csv", "discostorm_planner")
    ends = [float(r[end]) for r in rows if r["protocol"] == protocol.key for end in ("low", "high")]
    return [min(ends), max(ends)] if ends else []
