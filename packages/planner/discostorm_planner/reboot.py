"""The airtime of one robot that reboots."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from discostorm.data import read_data
from discostorm.messages import Protocol
from discostorm_planner.aggregation_range import burst_range
from discostorm_planner.changes import Setting


@dataclass(frozen=True)
class Reboot:
    """What the reboot of one robot adds to the air.

    Parameters
    ----------
    group : str
        The kind of robot; the most expensive of several groups.
    low, high : float
        Airtime of the reboot [s]: from the smallest measured factor of a common startup and full
        A-MPDUs to the largest factor and one frame in each exchange.
    share : float
        Share of all pairs of processes that this robot takes part in [1].
    source : str
        File of the measured factors.
    """

    group: str
    low: float
    high: float
    share: float
    source: str = "data/measured/restarts.csv"

    def to_dict(self) -> dict[str, Any]:
        """Return what JSON can hold."""
        return {
            "group": self.group,
            "low_s": self.low,
            "high_s": self.high,
            "share": self.share,
            "source": self.source,
        }


def reboot(setting: Setting) -> Reboot | None:
    """Compute the reboot of one robot; None where no restart of its product was measured.

    Each pair of processes takes its share of a common startup. A process that restarts within the
    lease, and a host that joins, took `low` to `high` times the share of their pairs
    (``data/measured/restarts.csv``). A robot that reboots is one of both.
    """
    factors, fleet = restart_factors(setting.protocol), setting.fleet
    processes = float(fleet.processes())
    local_pairs = sum(float(group.hosts) * float(group.processes) ** 2 for group in fleet.groups)
    # Ordered pairs with a process on another host.
    robot_pairs = {
        name: 2 * float(group.processes) * (processes - float(group.processes))
        for name, group in zip(fleet.names, fleet.groups, strict=True)
        if not group.wired
    }
    if factors is None or not robot_pairs or processes**2 <= local_pairs:
        return None
    group = max(robot_pairs, key=lambda name: robot_pairs[name])
    share = robot_pairs[group] / (processes**2 - local_pairs)
    low, high = burst_range(setting).ends
    return Reboot(group, low * share * factors[0], high * share * factors[1], share)


def restart_factors(protocol: Protocol) -> tuple[float, float] | None:
    """Return the smallest and the largest factor that restarts and joins took; None if unmeasured.

    A factor is a multiple of what the pairs that take part have in a common startup [1].
    """
    rows = [
        row
        for row in read_data("measured/restarts.csv", "discostorm_planner")
        if row["protocol"] == protocol.key
    ]
    if not rows:
        return None
    return min(float(row["low"]) for row in rows), max(float(row["high"]) for row in rows)
