"""Tables of a diagnosis: hosts, pairs that never completed, and a timeline of messages."""

import numpy as np
import pandas as pd

from discostorm_capture.diagnosis.evidence import Evidence

#: The timeline ends after this multiple of the completion time [1], and not before this time [s].
TIMELINE_FACTOR, MIN_TIMELINE_TIME = 1.25, 2.0
#: The shortest time step, used if the timeline has too many rows [s].
MIN_STEP = 1e-3
TIMELINE_COLUMNS = ("time_s", "host", "receiver", "multicast", "kind", "ends", "messages", "bytes")


def host_table(evidence: Evidence) -> pd.DataFrame:
    """Return one row per host; see `Diagnosis.hosts`."""
    obs = evidence.obs
    times = {host: first for host, (first, _) in obs.host_first_last.items()}
    first = pd.Series(times, dtype=float)
    by_host = obs.processes.assign(first=obs.first_last[0]).groupby("host", sort=False)
    table = by_host.agg(
        products=("product", lambda products: ", ".join(dict.fromkeys(products))),
        processes=("product", "size"),
        endpoints=("endpoints", "sum"),
        announced_s=("first", "min"),
    )
    # Add hosts that only announce themselves.
    looking = {*obs.messages["sender"][obs.isin("kind", "Scout", "SPDP")].astype(str)}
    idle = [host for host in first.index if host in looking and host not in table.index]
    table = table.reindex([*table.index, *idle]).rename_axis("host")
    # Without any process the column would be numeric.
    empty = {"products": "", "processes": 0, "endpoints": 0}
    table = table.astype({"products": object}).fillna(empty)
    table = table.astype({"processes": int, "endpoints": int})
    table["announced_s"] = table["announced_s"].replace(np.inf, np.nan).fillna(first)
    complete = [pair.complete_at for pair in evidence.all_pairs]
    for column, end in (("knows_all_s", "observer"), ("known_s", "subject")):
        ends = [obs.process_host[getattr(pair, end)] for pair in evidence.all_pairs]
        table[column] = pd.Series(complete, dtype=float).groupby(ends).max()
    if len({*table.index, *first.index}) > 1:
        table.loc[idle, "knows_all_s"] = np.inf  # they opened no session
    for column, end in (("sent", "sender"), ("received", "receiver")):
        sums = obs.messages.groupby(end, observed=True)["bytes"].agg(["size", "sum"])
        sums = sums.reindex(table.index, fill_value=0).astype(np.int64)
        table[column], table[f"{column}_bytes"] = sums["size"], sums["sum"]
    return table


def incomplete_pair_table(evidence: Evidence) -> pd.DataFrame:
    """Return the pairs that never completed; see `Diagnosis.incomplete`."""
    host, name = evidence.obs.process_host, evidence.obs.processes.index
    rows = [
        (*host[[*ends]], *name[[*ends]], pair.first_contact, pair.n_announced)
        for pair in evidence.incomplete_pairs
        for ends in [pair.processes]
    ]
    return pd.DataFrame(rows, columns=["of", "by", "of_process", "by_process", "heard_s", "sent"])


def timeline_table(evidence: Evidence, complete_at: float, most: int) -> pd.DataFrame:
    """Return the messages over time; see `Diagnosis.timeline`."""
    rows = evidence.obs.messages
    until = evidence.obs.end
    if np.isfinite(complete_at):
        until = min(until, max(MIN_TIMELINE_TIME, TIMELINE_FACTOR * complete_at))
        rows = rows[rows["time"] <= until]
    step, keys = 0.0, ["time", "sender", "receiver", "kind", "multicast", "ends"]
    groups = rows.groupby(keys, observed=True, sort=False)
    while groups.ngroups > most and step <= until:
        step = 2 * step or MIN_STEP
        steps = (rows["time"] // step).rename("step")
        groups = rows.groupby([steps, "sender", "kind", "ends"], observed=True, sort=False)
    sums = {"time_s": ("time", "first"), "messages": ("bytes", "size"), "bytes": ("bytes", "sum")}
    table = groups.agg(**sums).reset_index().rename(columns={"sender": "host"})
    for column in ("host", "kind", "receiver", "multicast"):
        table[column] = table[column].astype(object) if column in table else None
    table = table.sort_values("time_s", kind="stable").iloc[:most][[*TIMELINE_COLUMNS]]
    left_out = len(rows) - int(table["messages"].sum())
    table.attrs = {"until_s": until, "step_s": step, "left_out": left_out}
    return table
