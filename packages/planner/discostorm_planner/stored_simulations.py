"""Startups that were simulated beforehand: ``data/simulated/ready.csv`` and ``staggered.csv``.

``ready.csv`` has ready-made robots on two radios that aggregate: how long the burst took, and when
discovery was complete where queues overflow. ``staggered.csv`` has small robots that start together
or one after the other.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cache, lru_cache
from typing import get_args

import numpy as np

from discostorm import words
from discostorm.data import read_data
from discostorm.fleet import Fleet, HostGroup
from discostorm.messages import Family, Protocol
from discostorm.model import burst
from discostorm.protocols import PROTOCOLS
from discostorm.robots import laptop, robots
from discostorm.wifi import WIFI, Wifi
from discostorm.wifi.radio import both_ends

#: Names of the radios in ``ready.csv`` (``scripts/sweeps/sweep_setting.py``).
_RADIOS = {"n": "802.11n 20 MHz 2x2", "ac": "802.11ac 80 MHz 2x2"}
#: A process counts as simulated if it differs by less than half an endpoint, and by at most this
#: part of its endpoints in what is shared [1].
ENDPOINTS_TOLERANCE, SHARED_TOLERANCE = 0.5, 0.05
#: Decimals of ratios, which the calculator has, too.
_DECIMALS = 4


@dataclass(frozen=True)
class ConvergenceTime:
    """When discovery was complete in simulations with queues that overflow.

    Parameters
    ----------
    low, high : float
        Lower and upper quartile of the runs [s]; infinity: not within `until`. Between simulated
        numbers of robots: that of the next smaller number, and that of the next larger one.
    until : float
        How long the runs were [s].
    hosts : tuple of int
        The simulated numbers of robots: one, or two.
    runs : int
        Runs of each.
    """

    low: float
    high: float
    until: float
    hosts: tuple[int, ...]
    runs: int

    def to_dict(self) -> dict[str, object]:
        """Return what JSON can hold: infinity is None."""
        low, high = (None if np.isinf(end) else end for end in (self.low, self.high))
        return {
            "low": low,
            "high": high,
            "simulated_s": self.until,
            "simulated_hosts": list(self.hosts),
            "runs": self.runs,
        }


@lru_cache(maxsize=4096)
def interpolation_weight(protocol: Protocol, fleet: Fleet, wifi: Wifi) -> float | None:
    """Return how far the burst is from full A-MPDUs (0) to single frames (1), as simulated.

    None if it was not simulated. Between two numbers of robots, interpolate how much longer than
    with full A-MPDUs the bursts took.
    """
    rows = _rows(protocol, fleet, wifi, recovery=False)
    if not rows:
        return None
    hosts = float(fleet.hosts() - _laptops(fleet))
    ratio = float(np.interp(hosts, list(rows), list(map(_burst_ratio, rows.values()))))
    full, single = (float(burst(protocol, fleet, wifi=end)) for end in both_ends(wifi))
    return (ratio - 1) * full / (single - full)


def convergence_time(protocol: Protocol, fleet: Fleet, wifi: Wifi) -> ConvergenceTime | None:
    """Return when discovery is complete, None if that was not simulated."""
    rows = _rows(protocol, fleet, wifi, recovery=True)
    if not rows:
        return None
    # If the largest simulated fleet never converged, larger ones never do.
    hosts = min(float(fleet.hosts() - _laptops(fleet)), max(rows))
    below, above = max(n for n in rows if n <= hosts), min(n for n in rows if n >= hosts)
    return ConvergenceTime(
        float(rows[below]["convergence_time_s_q25"]),
        float(rows[above]["convergence_time_s_q75"]),
        float(rows[below]["until_s"]),
        tuple(sorted({below, above})),
        int(rows[below]["runs"]),
    )


def radio_key(wifi: Wifi) -> str | None:
    """Return what ``ready.csv`` calls a channel that aggregates, None if it was not simulated."""
    full = both_ends(wifi)[0]
    return next((key for key, name in _RADIOS.items() if both_ends(WIFI[name])[0] == full), None)


def ready_made_startups() -> dict[tuple[str, str, str, str], dict[str, list[list[float]]]]:
    """Return all of ``ready.csv`` by radio, table, robot and laptops.

    ``bursts`` are rows of robots [1] and how much longer the burst took than with full A-MPDUs [1],
    ``known`` of robots and both quartiles of the convergence time [s].
    """
    startups: dict[tuple[str, str, str, str], dict[str, list[list[float]]]] = {}
    for (radio, table, robot, laptops, recovery), rows in _ready_csv().items():
        entry = startups.setdefault((radio, table, robot, laptops), {"bursts": [], "known": []})
        for hosts, row in rows.items():
            if recovery == "0":
                entry["bursts"].append([hosts, _burst_ratio(row)])
            else:
                quartiles = (row[f"convergence_time_s_{end}"] for end in ("q25", "q75"))
                entry["known"].append([hosts, *map(float, quartiles)])
    return startups


@cache
def _ready_csv() -> dict[tuple[str, ...], dict[int, dict[str, str]]]:
    """Return the rows by radio, table, robot, laptops and recovery, then by hosts."""
    keyed: dict[tuple[str, ...], dict[int, dict[str, str]]] = {}
    for row in read_data("simulated/ready.csv", "discostorm_planner"):
        key = tuple(row[name] for name in ("radio", "protocol", "robot", "laptops", "recovery"))
        keyed.setdefault(key, {})[int(row["hosts"])] = row
    return keyed


def _rows(
    protocol: Protocol, fleet: Fleet, wifi: Wifi, recovery: bool
) -> dict[int, dict[str, str]]:
    """Return the rows of such a fleet by hosts; none if it is smaller or larger than all."""
    laptops = _laptops(fleet)
    own = [group for group in fleet.groups if not (laptops and _as_simulated(group, laptop()))]
    if len(own) != 1 or fleet.matching or wifi.radio is None:
        return {}
    robot = next((name for name, host in robots().items() if _as_simulated(own[0], host)), "")
    key = (radio_key(wifi) or "", protocol.key or "", robot, str(laptops), str(int(recovery)))
    rows = _ready_csv().get(key, {})
    if not rows or own[0].hosts < min(rows):
        return {}
    never = recovery and rows[max(rows)]["convergence_time_s_q25"] == "inf"
    return rows if own[0].hosts <= max(rows) or never else {}


def _laptops(fleet: Fleet) -> int:
    """Return the laptops of a fleet of robots: one, if that is its second group."""
    groups = [group for group in fleet.groups if _as_simulated(group, laptop())]
    return int(len(fleet.groups) == 2 and any(group.hosts == 1 for group in groups))


def _as_simulated(group: HostGroup, simulated: HostGroup) -> bool:
    """Whether hosts are like those that were simulated, however many they are."""
    return bool(
        group.processes == simulated.processes
        and abs(group.endpoints - simulated.endpoints) < ENDPOINTS_TOLERANCE
        and abs(group.shared - simulated.shared) <= SHARED_TOLERANCE * simulated.endpoints
        and not group.wired
    )


def _burst_ratio(row: dict[str, str]) -> float:
    """Return how much longer a simulated burst took than with full A-MPDUs [1]."""
    names = ("radio", "protocol", "robot", "laptops", "hosts", "endpoints")
    return round(
        float(row["drain_time_s"]) / _full_burst(*(row[name] for name in names)), _DECIMALS
    )


@cache
def _full_burst(
    radio: str, table: str, robot: str, laptops: str, hosts: str, endpoints: str
) -> float:
    """Return the burst of a row with full A-MPDUs [s]."""
    own = replace(robots()[robot], hosts=int(hosts), endpoints=int(endpoints))
    fleet = Fleet((own, laptop()) if laptops == "1" else (own,))
    return float(burst(PROTOCOLS[table], fleet, wifi=both_ends(WIFI[_RADIOS[radio]])[0]))


@cache
def _staggered_csv() -> dict[tuple[str, int], dict[tuple[str, str], float]]:
    """Return convergence times on 802.11n [s], by table and hosts, then by start and MPDUs."""
    times: dict[tuple[str, int], dict[tuple[str, str], float]] = {}
    for row in read_data("simulated/staggered.csv", "discostorm_planner"):
        if row["radio"] == "n":
            starts = times.setdefault((row["protocol"], int(row["hosts"])), {})
            starts[row["start"], row["mpdus"]] = float(row["convergence_time_s"])
    return dict(sorted(times.items()))


def _small_robots() -> str:
    rows = read_data("simulated/staggered.csv", "discostorm_planner")
    ((processes, endpoints),) = {(row["processes"], row["endpoints"]) for row in rows}
    return f"robots of {processes} processes with {endpoints} endpoints each"


def staggered_note(protocol: Protocol) -> str:
    """Say how much earlier small robots converge if they start one after the other."""
    gains = []
    for family in [protocol.family] if protocol.family else get_args(Family):
        by_hosts = {hosts: row for (name, hosts), row in _staggered_csv().items() if name == family}
        for hosts, times in list(by_hosts.items())[-2:]:
            rule, together = times["rule", "1"], times["together", "1"]
            gains.append(
                f"{hosts} robots with {family} needed {rule:.0f} s instead of {together:.0f} s"
            )
    return (
        "queues then lose less: when we simulated the paper model's startup of "
        f"{_small_robots()}, {words.join_words(gains)} (medians)"
    )


def aggregation_note(mpdus: int) -> str:
    """Say how much earlier small robots converge if their radios aggregate."""
    hosts = max(hosts for _, hosts in _staggered_csv())
    gains = []
    for family in get_args(Family):
        times = _staggered_csv()[family, hosts]
        single, full = times["together", "1"], times["together", str(mpdus)]
        gains.append(f"{full:.0f} s instead of {single:.0f} s with {family}")
    return (
        f"when we simulated the paper model's startup of {hosts} {_small_robots()}, they needed "
        f"{words.join_words(gains)} (medians)"
    )
