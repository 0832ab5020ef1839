"""User data alongside discovery: rows of the table, send times of hosts, and delays.

A host sends periodic samples to each process whose endpoints it has discovered. Samples by
multicast, to a wired host or without recovery begin at the host's own start. Lost samples are not
resent. A sample for one other host is spread over all other hosts if it has as many frames; a
shorter sample goes to a single host.
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from discostorm.fleet import Fleet
from discostorm.messages import DATA, Hosts, Message, Protocol, user_data_protocol
from discostorm.wifi.channel import TICK
from discostorm_simulation import state as st
from discostorm_simulation.cell_setup import BurstSchedule, to_ticks
from discostorm_simulation.result import CAUSES
from discostorm_simulation.state import CellState, Records

#: Minimum resolution of delays [s]: a frame carries its sample's time as a multiple of this.
_STAMP = 1e-4
#: Quantiles of the reported delays, by name.
QUANTILES = {"delay_median_s": 0.5, "delay_95_s": 0.95, "delay_most_s": 1.0}


@dataclass(frozen=True)
class UserData:
    """User data: indices of bursts, periods [s], host groups, and resolution of delays [ticks]."""

    bursts: tuple[int, ...]
    periods: tuple[float, ...]
    groups: tuple[int, ...]
    stamp: int

    def first_events(
        self, hosts: Hosts, starts: NDArray[np.float64], chance: np.random.Generator
    ) -> list[tuple[int, int]]:
        """Draw the first sample time of each host, uniform within the first period."""
        return [
            (to_ticks(starts[host] + chance.uniform(0, period)), int(st.SEND) | int(host) | place)
            for number, period, group in zip(self.bursts, self.periods, self.groups, strict=True)
            for place in [number << st.PROCESS_BITS]
            for host in np.flatnonzero(hosts.group_of[hosts.first] == group)
        ]


def add_user_data_rows(protocol: Protocol, fleet: Fleet) -> Protocol:
    """Add the rows of a fleet's data to the table; the receiver of a sample answers it."""
    table = user_data_protocol(protocol, fleet)
    if table is None:
        return protocol
    rows: list[Message] = []
    for row in table.messages:
        if _is_answer(row) and row.unit.to_each:
            unit = replace(row.unit, group=None)
            row = replace(row, unit=unit, answers=rows[-1].name, schedule=rows[-1].schedule)
        rows.append(row)
    return replace(protocol, messages=(*protocol.messages, *rows))


def _is_answer(row: Message) -> bool:
    return row.name.endswith(", answers")


def topics_of_rows(protocol: Protocol) -> tuple[tuple[str, bool], ...]:
    """Return the topic of each row with measured delays, and whether the row ends a sample."""
    names = [_topic(row) for row in protocol.messages if row.phase == DATA and not _is_answer(row)]
    return tuple((name, name not in names[n + 1 :]) for n, name in enumerate(names))


def _topic(row: Message) -> str:
    return row.name.rpartition(", ")[0]


def add_user_data_bursts(
    protocol: Protocol, bursts: BurstSchedule, kinds: Records, lifetime: float, until: float
) -> tuple[BurstSchedule, UserData | None]:
    """Add the bursts of user data; number the rows with measured delays in ``kinds``."""
    names = [row.name for row in protocol.messages]
    topics: dict[str, list[int]] = {}
    counted = 0
    for place, row in enumerate(protocol.messages):
        if row.phase != DATA:
            continue
        if not _is_answer(row):
            counted += 1
            kinds["user"][place] = counted
        if row.answers is None:
            topics.setdefault(_topic(row), []).append(place)
        else:
            kinds["trigger"][place] = st.ANSWER
            kinds["answers"][place] = names.index(row.answers)
    if not topics:
        return bursts, None
    messages = tuple(map(tuple, topics.values()))
    firsts = [protocol.messages[rows[0]] for rows in messages]
    periods = tuple(row.schedule.period for row in firsts)
    groups = tuple(row.unit.group or 0 for row in firsts)
    # The stamps must distinguish delays up to twice a queue's lifetime and a margin.
    stamp = to_ticks(max(_STAMP, min(2 * lifetime + 1.0, until) / st.ITEMS))
    both = BurstSchedule(bursts.rows_by_burst + messages, bursts.periods + periods, bursts.sends)
    own = tuple(range(len(bursts.rows_by_burst), len(both.rows_by_burst)))
    return both, UserData(own, periods, groups, stamp)


def user_data_results(
    topics: tuple[tuple[str, bool], ...], cell: CellState, stamp: int
) -> dict[str, dict[str, float]]:
    """Count frames sent, arrived and lost for each topic, and compute the delays of its samples."""
    found: dict[str, dict[str, float]] = {}
    for (topic, ends), counts in zip(topics, cell.delays, strict=True):
        own = found.setdefault(topic, dict.fromkeys(("frames", "arrived", *CAUSES), 0.0))
        late, lost = counts[: st.SENT_FRAMES], counts[st.LOSSES :]
        own["frames"] += float(counts[st.SENT_FRAMES])
        own["arrived"] += float(late.sum())
        for cause, times in zip(CAUSES, lost, strict=True):
            own[cause] += float(times)
        if ends:
            many = np.cumsum(late)
            for name, part in QUANTILES.items():
                place = int(np.searchsorted(many, part * many[-1])) if many[-1] else -1
                own[name] = place * stamp * TICK if place >= 0 else float("nan")
    return found
