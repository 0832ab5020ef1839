"""Compare measured models with the lab's counts, message by message."""

from collections.abc import Iterable

import numpy as np
import pandas as pd

from discostorm.data import read_data
from discostorm.fleet import Fleet
from discostorm.messages import HOPS, Message, Protocol, Schedule
from discostorm.protocols import PROTOCOLS
from discostorm_book.lab_counts import WINDOWS, GridPoint, grid_points

#: How far a model may be from the median of the runs [1]: of a phase, and of a kind of message.
#: Configurations other than as shipped have fewer runs per point; only phases are compared.
MAX_PHASE_ERROR, MAX_KIND_ERROR = 0.05, 0.10
MAX_MITIGATED_ERROR = 0.10


def count_scheduled_times(schedule: Schedule, window: str) -> float:
    """Return the number of transmissions of a schedule in a window."""
    begin, end = (float(np.asarray(schedule.sent(time))) for time in WINDOWS[window])
    return end - begin * (window != "startup")


def expected_count(message: Message, fleet: Fleet, window: str) -> float:
    """Return the expected number of a message in a window [1]."""
    return float(message.load(fleet)) * count_scheduled_times(message.schedule, window)


def single_hop(message: Message) -> str:
    """Return the hop that a message takes, "" if it takes both."""
    return message.hops[0] if len(message.hops) == 1 else ""


def compare_with_runs(protocol: Protocol, shared: bool = False) -> pd.DataFrame:
    """Compare a measured model with its runs, point by point, by ``kind`` and for "all" kinds."""
    rows = []
    for point in grid_points(protocol.name, "shared" if shared else ""):
        for window in WINDOWS:
            for phase in protocol.phases:
                messages = protocol.of_phase(phase)
                kinds = list(dict.fromkeys((m.kind, single_hop(m)) for m in messages))
                parts = {f"{kind}, {hop}" if hop else kind: [(kind, hop)] for kind, hop in kinds}
                for hop in HOPS:
                    if of_hop := [kind for kind in kinds if kind[1] == hop]:
                        parts[f"all, {hop}"] = of_hop
                for name, members in (parts | {"all": kinds}).items():
                    row = _count_messages(messages, point, window, members)
                    if row["measured"] or row["expected"]:
                        head = {"point": point.name, "use": point.use, "window": window}
                        rows.append(head | {"phase": phase, "kind": name} | row)
    table = pd.DataFrame(rows)
    for end in ("", "_bytes"):
        table[f"error{end}"] = _relative_error(table[f"expected{end}"], table[f"measured{end}"])
    return table


def _relative_error(expected: pd.Series, measured: pd.Series) -> pd.Series:
    """Return the relative error [1], NaN where nothing was measured."""
    return expected / measured.where(measured > 0) - 1


def _count_messages(
    messages: Iterable[Message], point: GridPoint, window: str, kinds: list[tuple[str, str]]
) -> dict[str, float]:
    """Return counted and expected messages and bytes of some kinds and hops."""
    keys = [
        (window, kind, "", cast, hop) for kind, hop in kinds for cast in ("multicast", "unicast")
    ]
    counts = [point.runs[key] for key in keys if key in point.runs]
    runs = np.sum(counts, axis=0) if counts else np.zeros((1, 3))
    total = size = 0.0
    for message in messages:
        if (message.kind, single_hop(message)) in kinds:
            number = expected_count(message, point.fleet, window)
            total += number * (message.frames > 0)  # a message inside another has no frame
            size += number * message.payload.nominal
    row: dict[str, float] = {}
    for end, column, computed in (("", runs[:, 0], total), ("_bytes", runs[:, 2], size)):
        row |= {f"measured{end}": float(np.median(column)), f"least{end}": float(column.min())}
        row |= {f"most{end}": float(column.max()), f"expected{end}": computed}
    return row


def compare_proposal_with_runs(alike: bool = False) -> pd.DataFrame:
    """Compare the hybrid discovery with its runs without losses, with software `alike` or not."""
    protocol = PROTOCOLS["hybrid, alike" if alike else "hybrid"]
    runs = pd.DataFrame(read_data("measured/hybrid.csv", "discostorm_book"))
    software = "alike" if alike else "unlike"
    runs = runs[(runs["scenario"] == "no losses") & (runs["software"] == software)]
    swarm = ["hosts", "processes", "endpoints"]
    runs = runs.astype(dict.fromkeys([*swarm, "frames", "bytes"], float))
    kinds = {"Sets": "Announce", "Digests": "Digest", "Heartbeats": "Heartbeat"}
    rows = []
    for key, point in runs.groupby([*swarm, "window"], sort=True):
        fleet, window = Fleet.swarm(*key[:3]), str(key[3])
        for phase, kind in kinds.items():
            counts = point[point["kind"] == kind]
            sent = [(expected_count(m, fleet, window), m) for m in protocol.of_phase(phase)]
            row = dict(zip((*swarm, "window"), key, strict=True))
            row |= {"phase": phase, "runs": len(counts), "frames": counts["frames"].median()}
            row["expected"] = sum(number for number, message in sent if message.frames)
            row["bytes"] = counts["bytes"].median()
            row["expected_bytes"] = sum(number * m.payload.nominal for number, m in sent)
            if row["frames"] or row["expected"]:
                rows.append(row)
    table = pd.DataFrame(rows)
    table["error"] = _relative_error(table["expected"], table["frames"])
    table["error_bytes"] = _relative_error(table["expected_bytes"], table["bytes"])
    return table
