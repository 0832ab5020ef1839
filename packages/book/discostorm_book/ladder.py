"""The ladder of assumptions: how many robots fit under which of them, computed or simulated.

Each assumption is a switch. The closed forms know any combination of timing, frames in an exchange
and table; what only a simulation knows is there for the settings that it was run with.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import product
from typing import Literal

from discostorm import figures, words
from discostorm.data import read_data
from discostorm.messages import PAPER_WINDOW
from discostorm.protocols import PROTOCOLS
from discostorm.saturation import saturation_hosts
from discostorm.wifi import PAPER, Radio

#: How many runs a setting has at least before its number of robots may stay undecided.
MOST_RUNS = 400
#: Frames of an A-MPDU.
MPDUS = 64

PROCESSES, ENDPOINTS = figures.FIG2_PROCESSES, figures.FIG2_ENDPOINTS


@dataclass(frozen=True)
class Switch:
    """An assumption in place of the paper's.

    Parameters
    ----------
    key : str
        What it is called in a `Rung`.
    name : str
        What a reader turns on.
    why : str
        What it changes, in words.
    kind : {"computed", "simulated", "measured"}
        Where its numbers come from: "measured" ones are computed from what was counted.
    needs : tuple of str
        Keys of the switches without which it does not go.
    """

    key: str
    name: str
    why: str
    kind: Literal["computed", "simulated", "measured"] = "computed"
    needs: tuple[str, ...] = ()


@dataclass(frozen=True)
class Rung:
    """How many robots fit under some of the assumptions.

    Parameters
    ----------
    switches : frozenset of str
        Keys of those that are on.
    protocol : str
        Of which protocol: DDS or Zenoh.
    fit : int
        The largest whole number of robots that fits.
    within : float
        How long their start may take [s]: until all that is asked for is carried or, where queues
        overflow, until all know each other in the median of the runs.
    full : float
        Robots at which the channel is full [1]; of a simulation, which has whole ones, NaN.
    fits : tuple of (int, int)
        Between which whole numbers of robots it lies; of an equation it is one.
    runs : str
        In words how many runs it comes from and what they say; empty unless it is simulated.
    """

    switches: frozenset[str]
    protocol: str
    fit: int
    within: float
    full: float = math.nan
    fits: tuple[int, int] = (0, 0)
    runs: str = ""

    @property
    def shown(self) -> str:
        """The number of robots, or from which to which it may be."""
        low, high = self.fits
        return f"{self.fit}" if low == high else f"{low} to {high}"


TIMING = Switch(
    "timing",
    "Exact 802.11n timing",
    "whole symbols, preambles and waits of IEEE 802.11n instead of the paper's rate and overhead",
)
AGGREGATION = Switch(
    "aggregation",
    f"Full aggregation, {MPDUS} frames per A-MPDU",
    "the best case: every queue always holds that many frames for one receiver",
    needs=("timing",),
)
PERIODS = Switch(
    "periods",
    "The products' timers; startup may take a lease",
    "periodic traffic is counted too, and startup may take one lease instead of one second",
)
AS_BUILT = Switch(
    "as built",
    "The products' real messages",
    "the messages that we captured from Fast DDS and from Zenoh peers, instead of the paper's",
    kind="measured",
    needs=("periods",),
)

CONTENTION = Switch(
    "contention",
    "Hosts contend for the channel",
    "robots and access point back off, collide and retry, frame by frame; no queue overflows",
    kind="simulated",
    needs=("timing",),
)
QUEUES = Switch(
    "queues",
    "Queues overflow, middleware recovers",
    "queues hold 500 frames, each for at most half a second; the middleware retransmits what they "
    "lose, and startup may take one lease",
    kind="simulated",
    needs=("contention",),
)
STAGGERED = Switch(
    "staggered",
    "Robots start in turn",
    "one robot after another, each once the airtime of the bursts before it has passed",
    kind="simulated",
    needs=("queues",),
)

COMPUTED = (TIMING, AGGREGATION, PERIODS, AS_BUILT)
SIMULATED = (CONTENTION, QUEUES, STAGGERED)
SWITCHES = (*COMPUTED, *SIMULATED)

#: The paper's table, that with the periods of a product, and the product's own.
TABLES = {
    "DDS": ("DDS", "DDS, periods of Fast DDS", "Fast DDS"),
    "Zenoh": ("Zenoh", "Zenoh, periods of Zenoh peer", "Zenoh peer"),
}


def rungs() -> Iterator[Rung]:
    """Yield what is known of each combination of the switches, the paper's first."""
    for protocol, on in product(TABLES, _subsets(COMPUTED)):
        table = PROTOCOLS[TABLES[protocol][len(on & {"periods", "as built"})]]
        mpdus = MPDUS if "aggregation" in on else 1
        within = table.lease if "periods" in on else PAPER_WINDOW
        hosts = saturation_hosts(
            table,
            PROCESSES,
            ENDPOINTS,
            wifi=Radio("802.11n", streams=2, mpdus=mpdus).wifi() if "timing" in on else PAPER,
            window=within,
        )
        assert isinstance(hosts, float)
        assert math.isfinite(hosts)
        fit = words.whole_below(hosts)
        yield Rung(on, protocol, fit, within, hosts, (fit, fit))
    yield from _simulated()


#: What is on in a step of the sweeps.
_STEPS = {
    "contention": {"timing", "contention"},
    "queues": {"timing", "contention", "queues"},
    "in turn": {"timing", "contention", "queues", "staggered"},
}


def _simulated() -> Iterator[Rung]:
    for row in read_data("simulated/ladder.csv", "discostorm_book"):
        lease = PROTOCOLS[TABLES[row["protocol"]][1]].lease
        limit = PAPER_WINDOW if row["step"] == "contention" else lease
        if row["step"] in _STEPS and float(row["limit_s"]) == limit:
            on = _STEPS[row["step"]] | ({"aggregation"} if int(row["mpdus"]) > 1 else set())
            fits = int(row["hosts_low"]), int(row["hosts_high"])
            yield Rung(
                frozenset(on), row["protocol"], int(row["hosts"]), limit, fits=fits, runs=_told(row)
            )


def _told(row: dict[str, str]) -> str:
    """Return what the runs of a step of the ladder say, in words."""
    said = []
    for robots, value, runs in (
        (int(row["hosts"]), "value", "runs"),
        (int(row["hosts"]) + 1, "one_more", "one_more_runs"),
    ):
        median, low, high = (float(row[f"{value}{end}_s"]) for end in ("", "_low", "_high"))
        said.append(
            f"with {robots} robots the median of {int(row[runs]):,} runs is {median:.3g} s "
            f"({low:.3g} to {high:.3g} s)"
        )
    sure = row["hosts_low"] == row["hosts_high"]
    end = "more runs would not change the number" if sure else "more runs might change the number"
    return f"{words.capitalized(said[0])}, {said[1]}. Time allowed: {row['limit_s']} s; {end}."


def _subsets(switches: tuple[Switch, ...]) -> Iterator[frozenset[str]]:
    """Yield the combinations of switches in which each has what it needs."""
    for chosen in product((False, True), repeat=len(switches)):
        on = frozenset(one.key for one, yes in zip(switches, chosen, strict=True) if yes)
        if all(set(one.needs) <= on for one in switches if one.key in on):
            yield on
