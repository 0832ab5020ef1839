"""What it takes when one robot of a fleet reboots."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import Any

from discostorm.data import read_data
from discostorm.messages import Protocol
from discostorm_planner.aggregation_range import burst_of
from discostorm_planner.changes import Setting
from discostorm_planner.remedy_rules import known_as


@dataclass(frozen=True)
class Reboot:
    """What a robot that reboots adds to the air.

    Parameters
    ----------
    group : str
        The kind of robot: of several groups the one whose robots take most.
    low, high : float
        Airtime of its reboot [s]: from the least that was measured, beside a start of all, to the
        most, and from full A-MPDUs to one frame in each exchange.
    share : float
        The part of all pairs of processes that this robot takes part in [1].
    source : str
        Where the measured range stands.
    """

    group: str
    low: float
    high: float
    share: float
    source: str

    def to_dict(self) -> dict[str, Any]:
        """Return it as what JSON can hold."""
        names = {"low": "low_s", "high": "high_s"}
        return {names.get(name, name): value for name, value in asdict(self).items()}


def reboot(base: Setting) -> Reboot | None:
    """Return what the reboot of one robot takes; None where no restart of its product was measured.

    A start of all takes so much for each pair of processes. A process that restarts within the
    lease, and a host that joins, took `low` to `high` times what their own pairs take in it
    (``data/measured/restarts.csv``); a robot that reboots is one or the other.
    """
    measured = factors(base.protocol)
    fleet = base.fleet
    everyone = float(fleet.processes())
    own = sum(float(group.hosts) * float(group.processes) ** 2 for group in fleet.groups)
    if measured is None or everyone**2 <= own:
        return None
    found = {
        name: 2 * float(group.processes) * (everyone - float(group.processes))
        for name, group in zip(fleet.names, fleet.groups, strict=True)
        if not group.wired
    }
    group = max(found, key=lambda name: found[name])
    share = found[group] / (everyone**2 - own)
    least, most = burst_of(base).ends
    low, high = measured
    return Reboot(
        group, least * share * low, most * share * high, share, "data/measured/restarts.csv"
    )


def factors(protocol: Protocol) -> tuple[float, float] | None:
    """Return the least and the most that restarts and joins took [1]; None if none was measured.

    As multiples of what the pairs of processes that take part in it have of a start of all.
    """
    of = known_as(protocol)
    rows = [
        row
        for row in read_data("measured/restarts.csv", "discostorm_planner")
        if of and row["protocol"] == of.name
    ]
    if not rows:
        return None
    return min(float(row["low"]) for row in rows), max(float(row["high"]) for row in rows)
