"""The airtime that one robot needs to reboot."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from discostorm.data import read_data
from discostorm.messages import Protocol
from discostorm_planner.aggregation_range import burst_range
from discostorm_planner.changes import Setting


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
    #: File of the measured factors.
    source: str = "data/measured/restarts.csv"

    def to_dict(self) -> dict[str, Any]:
        """Return a dict for JSON."""
        return {
            "group": self.group,
            "low_s": self.low,
            "high_s": self.high,
            "share": self.share,
            "source": self.source,
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
    if factors is None or not robot_pairs or processes**2 <= local_pairs:
        return None
    group = max(robot_pairs, key=lambda name: robot_pairs[name])
    share = robot_pairs[group] / (processes**2 - local_pairs)
    low, high = burst_range(setting).bounds
    return RebootAirtime(group, low * share * factors[0], high * share * factors[1], share)


def restart_factors(protocol: Protocol) -> tuple[float, float] | None:
    """Return the smallest and the largest factor of restarts and joins; None if not measured.

    A factor is the airtime as a multiple of the same pairs' airtime in a common startup [1].
    """
    rows = read_data("measured/restarts.csv", "discostorm_planner")
    rows = [row for row in rows if row["protocol"] == protocol.key]
    if not rows:
        return None
    return min(float(row["low"]) for row in rows), max(float(row["high"]) for row in rows)
