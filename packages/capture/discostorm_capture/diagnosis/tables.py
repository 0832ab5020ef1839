"""Tables of a diagnosis: hosts, the pairs that never completed, and what was sent when."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

import numpy as np

from discostorm_capture.diagnosis.lifecycle import Life
from discostorm_capture.diagnosis.observations import Seen
from discostorm_capture.diagnosis.pairs import Pair
from discostorm_capture.diagnosis.reachability import PATIENCE, RARE
from discostorm_capture.diagnosis.scopes import Team

if TYPE_CHECKING:
    import pandas as pd

#: The end of a startup is shown with so much of what follows it, and at least so long [s].
AFTER, SHOWN = 1.25, 2.0
#: What is too much to tell apart is put together in steps of at least this [s].
_STEP = 1e-3
TIMELINE = (
    "time_s", "host", "receiver", "multicast", "kind", "ends", "messages", "bytes"
)  # fmt: skip
COLUMNS = ("products", "processes", "endpoints", "announced_s", "knows_all_s", "known_s")


def due(seen: Seen, pair: Pair, alive: list[Life], gone: set[int]) -> bool:
    """Return whether two processes were there together for so long that they ought to be done."""
    if np.isnan(pair.complete) or pair.complete < np.inf:
        return True
    begin, stop, _ = _together(seen, pair, alive, gone)
    return stop - begin >= PATIENCE


def pending(seen: Seen, pair: Pair, alive: list[Life], gone: set[int]) -> bool:
    """Return whether two processes are not done when the capture ends, soon after they began."""
    begin, stop, end = _together(seen, pair, alive, gone)
    return pair.complete == np.inf and stop == end and 0 <= end - begin < PATIENCE


def _together(
    seen: Seen, pair: Pair, alive: list[Life], gone: set[int]
) -> tuple[float, float, float]:
    """Return from when to when two processes were there together, and when the capture ends [s]."""
    end = float(seen.time.max(initial=0.0))
    both = (pair.of, pair.by)
    stops = [alive[one].last + (0.0 if alive[one].end or one in gone else RARE) for one in both]
    return max(alive[one].first for one in both), min(end, *stops), end


def hosts(seen: Seen, teams: Iterable[Team], alive: list[Life]) -> pd.DataFrame:
    """Return a row for each host; see `Diagnosis.hosts`."""
    import pandas as pd

    pairs = [pair for team in teams for pair in team.pairs]
    table = seen.processes
    names = [host for host in dict.fromkeys([*seen.host, *seen.host_life]) if host]
    spoken = set(seen.host) | {
        str(host) for host in seen.rows["sender"][seen.of("kind", "Scout", "SPDP")].unique()
    }
    rows = []
    for name in names:
        if name not in spoken:
            continue
        mine = np.flatnonzero(seen.host == name)
        firsts = [alive[one].first for one in mine if np.isfinite(alive[one].first)]
        own, others = (
            [pair.complete for pair in pairs if seen.host[getattr(pair, end)] == name]
            for end in ("by", "of")
        )
        first = min(firsts, default=seen.host_life.get(name, (np.nan, 0.0))[0])
        knows = _latest(own)
        if np.isnan(knows) and not len(mine) and len(names) > 1:
            knows = np.inf  # it looks for others, and no session of it was opened
        rows.append(
            {
                "host": name,
                "products": ", ".join(dict.fromkeys(table["product"].iloc[mine])),
                "processes": len(mine),
                "endpoints": int(table["endpoints"].iloc[mine].sum()),
                "announced_s": first,
                "knows_all_s": knows,
                "known_s": _latest(others),
            }
        )
    found = pd.DataFrame(rows, columns=["host", *COLUMNS]).set_index("host")
    for column, end in (("sent", "sender"), ("received", "receiver")):
        counts = seen.rows.groupby(end, observed=True)["bytes"].agg(["size", "sum"])
        found[column] = counts["size"].reindex(found.index).fillna(0).astype(np.int64)
        found[f"{column}_bytes"] = counts["sum"].reindex(found.index).fillna(0).astype(np.int64)
    return found


def _latest(times: list[float]) -> float:
    """Return the latest of times: infinite if one never came, NaN if none is known."""
    known = [time for time in times if not np.isnan(time)]
    return max(known) if known else np.nan


def incomplete(seen: Seen, pairs: Iterable[Pair]) -> pd.DataFrame:
    """Return the pairs that never completed; see `Diagnosis.incomplete`."""
    import pandas as pd

    names = seen.processes.index.to_numpy(object)
    rows = [
        {
            "of": str(seen.host[pair.of]),
            "by": str(seen.host[pair.by]),
            "of_process": names[pair.of],
            "by_process": names[pair.by],
            "heard_s": pair.heard,
            "sent": pair.sent,
        }
        for pair in pairs
    ]
    return pd.DataFrame(rows, columns=["of", "by", "of_process", "by_process", "heard_s", "sent"])


def timeline(
    rows: pd.DataFrame, complete_at: float, most: int
) -> tuple[pd.DataFrame, dict[str, float]]:
    """Return what was sent when, and what is said of it all; see `Diagnosis.timeline`."""
    until = float(rows["time"].max()) if len(rows) else 0.0
    if np.isfinite(complete_at):
        until = min(until, max(SHOWN, AFTER * complete_at))
        rows = rows[rows["time"] <= until]
    step, keys = 0.0, ["time", "sender", "receiver", "kind", "multicast", "ends"]
    groups = rows.groupby(keys, observed=True, sort=False)
    if groups.ngroups > most:
        # Who is spoken to is then left out: everybody speaks to everybody.
        keys = ["sender", "kind", "ends"]
        who = rows.groupby(keys, observed=True).ngroup().to_numpy()
        bins = (rows["time"].to_numpy() / _STEP).astype(np.int64)
        step = _STEP
        found = np.unique(np.column_stack([bins, who]), axis=0)
        while len(found) > most and found[:, 0].any():
            found[:, 0] //= 2
            found, step = np.unique(found, axis=0), 2 * step
        bins = bins // round(step / _STEP)
        groups = rows.assign(at=bins).groupby(["at", *keys], observed=True, sort=False)
    each = {"time_s": ("time", "first"), "messages": ("bytes", "size"), "bytes": ("bytes", "sum")}
    table = groups.agg(**each).reset_index().rename(columns={"sender": "host"})
    for column in ("receiver", "multicast"):
        table[column] = table[column].astype(object) if column in table else None
    for column in ("host", "kind"):
        table[column] = table[column].astype(object)
    table = table.sort_values("time_s", kind="stable").iloc[:most][[*TIMELINE]]
    left = len(rows) - int(table["messages"].sum())
    return table, {"until_s": until, "step_s": step, "left_out": left}
