"""Startups simulated beforehand: ``data/simulated/ready.csv`` and ``staggered.csv``.

``ready.csv`` has the duration of the burst of robot presets on two radios that aggregate,
``staggered.csv`` has small robots that start together or in turn.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cache, lru_cache
from typing import get_args

import numpy as np

from discostorm import wording
from discostorm.data import read_data
from discostorm.fleet import Fleet, HostGroup
from discostorm.messages import Family, Protocol
from discostorm.model import burst
from discostorm.protocols import PROTOCOLS
from discostorm.robots import laptop, robots
from discostorm.wifi import WIFI, Wifi
from discostorm.wifi.radio import aggregation_bounds

#: Names of the radios in ``ready.csv`` (``scripts/sweeps/sweep_setting.py``).
_RADIOS = {"n": "802.11n 20 MHz 2x2", "ac": "802.11ac 80 MHz 2x2"}
#: Tolerance for simulated processes [1]: half an endpoint, and this share for always-matching ones.
ENDPOINTS_TOLERANCE, SHARED_TOLERANCE = 0.5, 0.05
#: Decimals of ratios, the same as in the calculator.
_DECIMALS = 4


@lru_cache(maxsize=4096)
def interpolation_weight(protocol: Protocol, fleet: Fleet, wifi: Wifi) -> float | None:
    """Return the simulated burst's position between full A-MPDUs (0) and single frames (1).

    None if the fleet was not simulated. Between two simulated fleet sizes, interpolate the burst's
    duration relative to full A-MPDUs.
    """
    rows = _rows(protocol, fleet, wifi)
    if not rows:
        return None
    hosts = float(fleet.hosts() - _laptops(fleet))
    ratio = float(np.interp(hosts, list(rows), list(map(_burst_ratio, rows.values()))))
    full, single = (float(burst(protocol, fleet, wifi=end)) for end in aggregation_bounds(wifi))
    return (ratio - 1) * full / (single - full)


def radio_key(wifi: Wifi) -> str | None:
    """Return a channel's name in ``ready.csv``; None if the channel was not simulated."""
    full = aggregation_bounds(wifi)[0]
    return next(
        (key for key, name in _RADIOS.items() if aggregation_bounds(WIFI[name])[0] == full), None
    )


def ready_made_bursts() -> dict[tuple[str, ...], list[list[float]]]:
    """Return the simulated bursts by radio, table, robot and laptops.

    Rows: robots [1], burst's duration relative to full A-MPDUs [1].
    """
    return {
        key: [[hosts, _burst_ratio(row)] for hosts, row in rows.items()]
        for key, rows in _ready_csv().items()
    }


@cache
def _ready_csv() -> dict[tuple[str, ...], dict[int, dict[str, str]]]:
    """Read the runs of ``ready.csv`` without losses by radio, table, robot, laptops, and hosts."""
    keyed: dict[tuple[str, ...], dict[int, dict[str, str]]] = {}
    for row in read_data("simulated/ready.csv", "discostorm_planner"):
        key = tuple(row[name] for name in ("radio", "protocol", "robot", "laptops"))
        if row["recovery"] == "0":
            keyed.setdefault(key, {})[int(row["hosts"])] = row
    return keyed


def _rows(protocol: Protocol, fleet: Fleet, wifi: Wifi) -> dict[int, dict[str, str]]:
    """Return the stored rows of similar fleets by hosts; none outside the simulated sizes."""
    laptops = _laptops(fleet)
    own = [group for group in fleet.groups if not (laptops and _is_like_simulated(group, laptop()))]
    if len(own) != 1 or fleet.matching or wifi.radio is None:
        return {}
    robot = next((name for name, host in robots().items() if _is_like_simulated(own[0], host)), "")
    key = (radio_key(wifi) or "", protocol.key or "", robot, str(laptops))
    rows = _ready_csv().get(key, {})
    return rows if rows and min(rows) <= own[0].hosts <= max(rows) else {}


def _laptops(fleet: Fleet) -> int:
    """Return the number of laptops beside the robots: 1 if the second group is one laptop."""
    groups = [group for group in fleet.groups if _is_like_simulated(group, laptop())]
    return int(len(fleet.groups) == 2 and any(group.hosts == 1 for group in groups))


def _is_like_simulated(group: HostGroup, simulated: HostGroup) -> bool:
    """Return whether the hosts match the simulated hosts, whatever their number."""
    return bool(
        group.processes == simulated.processes
        and abs(group.endpoints - simulated.endpoints) < ENDPOINTS_TOLERANCE
        and abs(group.shared - simulated.shared) <= SHARED_TOLERANCE * simulated.endpoints
        and not group.wired
    )


def _burst_ratio(row: dict[str, str]) -> float:
    """Return a simulated burst's duration as a multiple of its duration with full A-MPDUs [1]."""
    names = ("radio", "protocol", "robot", "laptops", "hosts", "endpoints")
    return round(
        float(row["drain_time_s"]) / _full_burst(*(row[name] for name in names)), _DECIMALS
    )


@cache
def _full_burst(
    radio: str, table: str, robot: str, laptops: str, hosts: str, endpoints: str
) -> float:
    """Compute the burst of a row with full A-MPDUs [s]."""
    own = replace(robots()[robot], hosts=int(hosts), endpoints=int(endpoints))
    fleet = Fleet((own, laptop()) if laptops == "1" else (own,))
    return float(burst(PROTOCOLS[table], fleet, wifi=aggregation_bounds(WIFI[_RADIOS[radio]])[0]))


@cache
def _staggered_csv() -> dict[tuple[str, int], dict[tuple[str, str], float]]:
    """Read convergence times on 802.11n [s], by table and hosts, then by start and MPDUs."""
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
    """State how much earlier small robots converge if they start one after the other."""
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
        f"{_small_robots()}, {wording.join_words(gains)} (medians)"
    )


def aggregation_note(mpdus: int) -> str:
    """State how much earlier small robots converge if their radios aggregate."""
    hosts = max(hosts for _, hosts in _staggered_csv())
    gains = []
    for family in get_args(Family):
        times = _staggered_csv()[family, hosts]
        single, full = times["together", "1"], times["together", str(mpdus)]
        gains.append(f"{full:.0f} s instead of {single:.0f} s with {family}")
    return (
        f"when we simulated the paper model's startup of {hosts} {_small_robots()}, they needed "
        f"{wording.join_words(gains)} (medians)"
    )
