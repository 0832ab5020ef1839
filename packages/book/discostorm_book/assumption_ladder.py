"""The ladder of assumptions: how many robots fit under each set of them."""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import product

from discostorm import drain_times, figures, wording
from discostorm.data import read_data
from discostorm.messages import PAPER_WINDOW
from discostorm.protocols import PROTOCOLS
from discostorm.saturation import saturation_hosts
from discostorm.wifi import PAPER, Radio

#: Maximum number of runs of a setting; if they do not decide how many robots fit, it has a range.
MAX_RUNS = 400
#: Frames of an A-MPDU.
MPDUS = 64
_ROBOT = figures.FIG2_PROCESSES, figures.FIG2_ENDPOINTS


@dataclass(frozen=True)
class Assumption:
    """An assumption that replaces one of the paper's, and the assumptions that it needs."""

    key: str
    name: str
    why: str
    kind: str
    needs: tuple[str, ...]


@dataclass(frozen=True)
class FleetLimit:
    """The number of robots that fit under some of the assumptions."""

    switches: frozenset[str]
    protocol: str
    #: The largest whole number of robots that fits.
    fit: int
    #: How long startup may take [s]: until every message is carried or, where queues overflow,
    #: until discovery is complete in the median run.
    within: float
    #: Robots at which the channel is full [1]; NaN for a simulation, which has whole robots.
    full: float = math.nan
    #: Smallest and largest whole number of robots that the runs allow.
    fits: tuple[int, int] = (0, 0)
    #: The result of the simulated runs, in words.
    runs: str = ""

    @property
    def shown(self) -> str:
        """The number of robots, or its range."""
        low, high = self.fits
        return f"{self.fit}" if low == high else f"{low} to {high}"


ASSUMPTIONS = tuple(
    Assumption(row["key"], row["name"], row["why"], row["kind"], tuple(row["needs"].split()))
    for row in read_data("simulated/switches.csv", "discostorm_book")
)

#: The paper's table, the same with the periods of a product, and the measured table.
TABLES = {
    "DDS": ("DDS", "DDS, periods of Fast DDS", "Fast DDS"),
    "Zenoh": ("Zenoh", "Zenoh, periods of Zenoh peer", "Zenoh peer"),
}


def fleet_limits() -> Iterator[FleetLimit]:
    """Yield the robots that fit for each combination of the switches, the paper's first."""
    for protocol, on in product(TABLES, _combinations()):
        table = PROTOCOLS[TABLES[protocol][len(on & {"periods", "as built"})]]
        mpdus = MPDUS if "aggregation" in on else 1
        wifi = Radio("802.11n", streams=2, mpdus=mpdus).wifi() if "timing" in on else PAPER
        within = table.lease if "periods" in on else PAPER_WINDOW
        hosts = float(saturation_hosts(table, *_ROBOT, wifi=wifi, window=within))
        fit = wording.last_integer_below(hosts)
        if "periods" in on and "as built" not in on:
            # Use the exact time: gaps between messages leave the channel idle before its bound.
            while drain_times.first_idle(table, fit + 1, *_ROBOT, wifi=wifi) <= within:
                fit += 1
        yield FleetLimit(on, protocol, fit, within, hosts, (fit, fit))
    yield from _simulated_rungs()


#: Switches that are on in a step of the sweeps.
_STEPS = {
    "contention": {"timing", "contention"},
    "queues": {"timing", "contention", "queues"},
    "in turn": {"timing", "contention", "queues", "staggered"},
}


def _simulated_rungs() -> Iterator[FleetLimit]:
    for row in read_data("simulated/ladder.csv", "discostorm_book"):
        lease = PROTOCOLS[TABLES[row["protocol"]][1]].lease
        limit = PAPER_WINDOW if row["step"] == "contention" else lease
        if row["step"] in _STEPS and float(row["limit_s"]) == limit:
            on = _STEPS[row["step"]] | ({"aggregation"} if int(row["mpdus"]) > 1 else set())
            fits = int(row["hosts_low"]), int(row["hosts_high"])
            name, hosts, runs = row["protocol"], int(row["hosts"]), _result_in_words(row)
            yield FleetLimit(frozenset(on), name, hosts, limit, fits=fits, runs=runs)


def _result_in_words(row: dict[str, str]) -> str:
    """Return the result of the runs of a step of the ladder in words."""
    parts = []
    for more, value, runs in ((0, "value", "runs"), (1, "one_more", "one_more_runs")):
        median, low, high = (float(row[f"{value}{end}_s"]) for end in ("", "_low", "_high"))
        parts.append(
            f"with {int(row['hosts']) + more} robots the median of {int(row[runs]):,} runs is "
            f"{median:.3g} s ({low:.3g} to {high:.3g} s)"
        )
    would = "would not" if row["hosts_low"] == row["hosts_high"] else "might"
    return (
        f"{wording.capitalized(parts[0])}, {parts[1]}. Time allowed: {row['limit_s']} s; "
        f"more runs {would} change the number."
    )


def _combinations() -> Iterator[frozenset[str]]:
    """Yield the combinations of computed switches; each switch comes with those that it needs."""
    switches = [switch for switch in ASSUMPTIONS if switch.kind != "simulated"]
    for chosen in product((False, True), repeat=len(switches)):
        on = frozenset(switch.key for switch, yes in zip(switches, chosen, strict=True) if yes)
        if all(set(switch.needs) <= on for switch in switches if switch.key in on):
            yield on
