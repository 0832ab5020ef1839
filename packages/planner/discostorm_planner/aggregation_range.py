"""Between which values an answer lies on a radio that aggregates, and what was simulated of it.

A radio from 802.11n on puts what waits for one receiver into one exchange. How full these are
depends on what waits; the two ends, full A-MPDUs and one frame in each exchange, are formulas.
Between them is what ``data/simulated/ready.csv`` has of ready-made robots.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cache, lru_cache
from typing import Literal

import numpy as np

from discostorm import words
from discostorm.data import read_data
from discostorm.fleet import Fleet, HostGroup
from discostorm.messages import Protocol
from discostorm.model import burst, utilization
from discostorm.protocols import PROTOCOLS
from discostorm.robots import laptop, robots
from discostorm.timeline import drained
from discostorm.wifi import WIFI, Wifi
from discostorm.wifi.radio import both_ends
from discostorm_planner.changes import Setting
from discostorm_planner.remedy_rules import same

#: Whether something fits; see `Span.verdict`.
Verdict = Literal["fits", "may fit", "does not fit"]

#: What the table calls its radios (``scripts/sweeps/sweep_setting.py``).
_RADIOS = {"n": "802.11n 20 MHz 2x2", "ac": "802.11ac 80 MHz 2x2"}
#: So large a part of a process's endpoints may be shared more or less than was simulated [1], and
#: so many endpoints fewer or more is a process of whole ones.
SHARED, WHOLE = 0.05, 0.5
#: Ratios are taken to so many decimals, as the calculator has them.
_DIGITS = 4


@dataclass(frozen=True)
class Span:
    """A number of a channel that aggregates: at its ends and, where it is known, between them.

    Parameters
    ----------
    full : float
        With full A-MPDUs.
    simulated : float or None
        As full as they were in simulations of the burst; None if there are none.
    single : float
        With one frame in each exchange.
    """

    full: float
    simulated: float | None
    single: float

    @property
    def known(self) -> float:
        """What gains are computed with: the simulated value, else that of single frames."""
        return self.single if self.simulated is None else self.simulated

    @property
    def ends(self) -> tuple[float, float]:
        """The smaller and the larger end: frames too long to share one gain nothing when full."""
        return min(self.full, self.single), max(self.full, self.single)

    @property
    def verdict(self) -> Verdict:
        """Whether that much of a channel fits: even the most of it, or the least, or neither."""
        least, most = self.ends
        if words.fits(most):
            return "fits"
        return "may fit" if words.fits(least) else "does not fit"

    @property
    def ranges(self) -> bool:
        """Whether its ends differ."""
        return self.full != self.single

    def to_dict(self) -> dict[str, float | None]:
        """Return it as what JSON can hold: infinity is None."""
        ends = {"full_ampdus": self.full, "simulated": self.simulated, "one_frame": self.single}
        return {
            name: None if value is None or np.isinf(value) else value
            for name, value in ends.items()
        }


def together(spans: Sequence[Span], of_all: str = "sum") -> Span:
    """Return the sum of some numbers, or the largest; simulated only where each is."""

    def joined(numbers: Iterable[float]) -> float:
        return max(numbers) if of_all == "max" else math.fsum(numbers)

    middle = [span.simulated for span in spans if span.simulated is not None]
    return Span(
        joined(span.full for span in spans),
        joined(middle) if len(middle) == len(spans) else None,
        joined(span.single for span in spans),
    )


@dataclass(frozen=True)
class Known:
    """After how long all robots know each other, as simulated with queues that overflow.

    Parameters
    ----------
    low, high : float
        The lower and the upper quartile of the runs [s]; infinity: not within `until`. Between
        numbers of robots that were simulated: of the next smaller and of the next larger one.
    until : float
        How long the runs were [s].
    hosts : tuple of int
        With how many robots that was: one number, or two.
    runs : int
        How many runs each.
    """

    low: float
    high: float
    until: float
    hosts: tuple[int, ...]
    runs: int

    def sentence(self) -> str:
        """Return it in words."""
        most, limit = self.hosts[-1], words.duration(self.until)
        how = (
            f"quartiles of {self.runs} simulated runs with "
            f"{words.listed([f'{n:,}' for n in self.hosts])} robots, overflowing queues "
            "and recovery"
        )
        if np.isinf(self.low):
            return f"Your robots do not all know each other within {limit} ({how})."
        if np.isinf(self.high):
            return (
                f"Your robots know each other after {words.duration(self.low)} at the earliest "
                f"({how}; {most:,} robots did not within {limit})."
            )
        return f"Your robots know each other after {words.durations(self.low, self.high)} ({how})."

    def to_dict(self) -> dict[str, object]:
        """Return it as what JSON can hold: infinity is None."""
        low, high = (None if np.isinf(end) else end for end in (self.low, self.high))
        return {
            "low": low,
            "high": high,
            "simulated_s": self.until,
            "simulated_hosts": list(self.hosts),
            "runs": self.runs,
        }


def span_of(setting: Setting, window: float) -> Span:
    """Return the utilization of a setting [1]."""
    full, single = _ends(setting, window)
    return Span(full, _between(setting, full, single), single)


def burst_of(setting: Setting) -> Span:
    """Return the airtime of a setting's burst [s]."""
    full, single = (
        float(burst(setting.protocol, setting.fleet, wifi=wifi))
        for wifi in (setting.full, setting.wifi)
    )
    return Span(full, _between(setting, full, single), single)


def repeated(setting: Setting) -> Span:
    """Return what is repeated takes of the channel [1]."""
    return span_of(setting, np.inf) if setting.protocol.repeats else Span(0.0, None, 0.0)


def startup(setting: Setting) -> Span:
    """Return how long the channel needs for a start without losses and collisions [s]."""
    start, later = burst_of(setting), repeated(setting)
    full, single = (
        float(drained(start.full, later.full)),
        float(drained(start.single, later.single)),
    )
    if start.simulated is None:
        return Span(full, None, single)
    return Span(full, float(drained(start.simulated, later.simulated or 0.0)), single)


def _ends(setting: Setting, window: float) -> tuple[float, float]:
    """Return the utilization of a setting with full A-MPDUs and with single frames [1]."""
    single, full = (
        float(utilization(setting.protocol, setting.fleet, wifi=wifi, window=window))
        for wifi in (setting.wifi, setting.full)
    )
    return full, single


def _between(setting: Setting, full: float, single: float) -> float | None:
    """Return what lies between two ends as far as the simulated burst, None if there is none."""
    part = fullness(setting.protocol, setting.fleet, setting.full)
    return None if part is None else full + part * (single - full)


@lru_cache(maxsize=4096)
def fullness(protocol: Protocol, fleet: Fleet, wifi: Wifi) -> float | None:
    """Return how far the simulated burst is from full A-MPDUs to single frames [1].

    None if it was not simulated. Between two numbers of robots it is how much longer than with
    full A-MPDUs both took that is interpolated.
    """
    rows = _rows(protocol, fleet, wifi, recovery=False)
    if not rows:
        return None
    hosts = float(fleet.hosts() - _laptops(fleet))
    ratios = [round(_ratio(row), _DIGITS) for row in rows.values()]
    ratio = float(np.interp(hosts, list(rows), ratios))
    full, single = (float(burst(protocol, fleet, wifi=end)) for end in both_ends(wifi))
    return (ratio - 1) * full / (single - full)


def known_after(protocol: Protocol, fleet: Fleet, wifi: Wifi) -> Known | None:
    """Return after how long all robots know each other, None where that was not simulated."""
    rows = _rows(protocol, fleet, wifi, recovery=True)
    if not rows:
        return None
    # With more robots than so many that never do, they never do either.
    hosts = min(float(fleet.hosts() - _laptops(fleet)), max(rows))
    below, above = max(n for n in rows if n <= hosts), min(n for n in rows if n >= hosts)
    return Known(
        float(rows[below]["convergence_time_s_q25"]),
        float(rows[above]["convergence_time_s_q75"]),
        float(rows[below]["until_s"]),
        tuple(sorted({below, above})),
        int(rows[below]["runs"]),
    )


@cache
def _all_rows() -> dict[tuple[str, ...], dict[int, dict[str, str]]]:
    """Return the rows by radio, table, robot, laptops and recovery, then by hosts."""
    found: dict[tuple[str, ...], dict[int, dict[str, str]]] = {}
    for row in read_data("simulated/ready.csv", "discostorm_planner"):
        key = tuple(row[name] for name in ("radio", "protocol", "robot", "laptops", "recovery"))
        found.setdefault(key, {})[int(row["hosts"])] = row
    return found


def _rows(
    protocol: Protocol, fleet: Fleet, wifi: Wifi, recovery: bool
) -> dict[int, dict[str, str]]:
    """Return the rows of such a fleet by robots, none where it has fewer or more than all."""
    laptops = _laptops(fleet)
    own = [group for group in fleet.groups if not (laptops and _same(group, laptop()))]
    if len(own) != 1 or own[0].wired or fleet.matching or wifi.radio is None:
        return {}
    radio = radio_of(wifi)
    robot = next((name for name, one in robots().items() if _same(own[0], one)), None)
    table = next((one for one in PROTOCOLS.values() if same(one, protocol)), None)
    if radio is None or robot is None or table is None:
        return {}
    key = (radio, table.name, robot, str(laptops), str(int(recovery)))
    rows = _all_rows().get(key, {})
    if not rows or own[0].hosts < min(rows):
        return {}
    never = recovery and rows[max(rows)]["convergence_time_s_q25"] == "inf"
    return rows if own[0].hosts <= max(rows) or never else {}


def radio_of(wifi: Wifi) -> str | None:
    """Return what the table calls a channel that aggregates, None if it was not simulated."""
    full = both_ends(wifi)[0]
    return next((key for key, name in _RADIOS.items() if both_ends(WIFI[name])[0] == full), None)


def stored() -> dict[tuple[str, str, str, str], dict[str, list[list[float]]]]:
    """Return all that was simulated, by radio, table, robot and laptops beside.

    ``bursts`` are rows of robots [1] and how much longer than with full A-MPDUs the burst took [1],
    ``known`` of robots and both quartiles of the time until all know each other [s].
    """
    found: dict[tuple[str, str, str, str], dict[str, list[list[float]]]] = {}
    for (radio, table, robot, laptops, recovery), rows in _all_rows().items():
        entry = found.setdefault((radio, table, robot, laptops), {"bursts": [], "known": []})
        for hosts, row in rows.items():
            if recovery == "0":
                entry["bursts"].append([hosts, round(_ratio(row), _DIGITS)])
            else:
                quartiles = (row[f"convergence_time_s_{end}"] for end in ("q25", "q75"))
                entry["known"].append([hosts, *map(float, quartiles)])
    return found


def _laptops(fleet: Fleet) -> int:
    """Return how many laptops are beside the robots: one, if that is the other group."""
    others = [group for group in fleet.groups if _same(group, laptop()) and group.hosts == 1]
    return 1 if len(fleet.groups) == 2 and others else 0


def _same(group: HostGroup, other: HostGroup) -> bool:
    """Return whether hosts are as those that were simulated, but for how many they are."""
    return bool(
        group.processes == other.processes
        and abs(group.endpoints - other.endpoints) < WHOLE
        and abs(group.shared - other.shared) <= SHARED * other.endpoints
        and not group.wired
    )


@cache
def _burst_of(key: tuple[str, ...]) -> float:
    """Return the burst of a row with full A-MPDUs [s]."""
    radio, name, robot, laptops, hosts, endpoints = key
    own = replace(robots()[robot], hosts=int(hosts), endpoints=int(endpoints))
    beside: Iterable[HostGroup] = [laptop()] if laptops == "1" else []
    fleet = Fleet((own, *beside))
    return float(burst(PROTOCOLS[name], fleet, wifi=both_ends(WIFI[_RADIOS[radio]])[0]))


def _ratio(row: dict[str, str]) -> float:
    """Return how much longer than with full A-MPDUs a simulated burst took [1]."""
    names = ("radio", "protocol", "robot", "laptops", "hosts", "endpoints")
    return float(row["drain_time_s"]) / _burst_of(tuple(row[name] for name in names))
