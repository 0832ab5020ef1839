"""Failures in the lab, run by run: which processes heard each other, and when."""

import re
from collections.abc import Iterator
from functools import partial
from typing import Any

import numpy as np
import pandas as pd

from discostorm import wording
from discostorm.data import read_data
from discostorm_book import lab_counts
from discostorm_book.lab_counts import failure_times

#: The name of each configuration, its victim, and the hosts with a server or router.
CONFIGURATIONS = {
    row["configuration"]: (row["name"], row["victim"], row["routers"])
    for row in read_data("vendors/short_names.csv", "discostorm_book")
    if row["victim"]
}
#: Seconds from a kill to its restart, as ``data/measured/README.md`` says.
RESTART_DELAY = 3.0
#: An event in which a process joins that was not there before.
_OUTAGE = r"outage of \d+ s"
_PAIR_ROWS = read_data("measured/pairs_observed.csv", "discostorm_book")
#: Subjects of ``data/measured/deaths.csv``: processes that knew each other, then late joiners.
_KNOWN, _LATE = ([row["who"] for row in _PAIR_ROWS if row["when"] == w] for w in ("known", "late"))


def observed_pairs(name: str) -> list[tuple[str, str, str]]:
    """Return the pairs of groups that were observed in a configuration, and their names."""
    rows = lab_counts.failure_summary()
    present = set(rows[rows["configuration"] == name]["who"])
    others = "robots 2 to 4" if "orphans" in present else "robots 1 to 4"
    return [
        (row["one"], row["other"], wording.capitalized(row["name"].format(others=others)))
        for row in _PAIR_ROWS
        if row["who"] in present
    ]


def failures_of_configuration(name: str) -> list[dict[str, Any]]:
    """Return each failure of a server or router, with each run's spans without contact [s]."""
    every = pd.concat([lab_counts.failure_summary("deaths"), lab_counts.failure_summary("outages")])
    of_name = every[every["configuration"] == name]
    return [
        _failure_of_event(name, str(event), rows)
        for event, rows in of_name.groupby("event", sort=False)
        if event in ("server killed", "server restarts") or re.fullmatch(_OUTAGE, str(event))
    ]


def _failure_of_event(name: str, event: str, rows: pd.DataFrame) -> dict[str, Any]:
    since = dict(zip(rows["phase"], rows["since_s"], strict=True))
    back = since.get("return", RESTART_DELAY)
    known = set(zip(rows["phase"], rows["who"], strict=True))
    times = partial(failure_times, name, event)

    def spans() -> Iterator[list[list[float | None] | None]]:
        for who in _KNOWN:
            if ("death", who) not in known:
                continue
            again = settled = times("death", who, "settled")
            if "return" in since and np.isinf(settled).any():
                among = "survivors" if who == "survivors" else "orphans"
                again = np.where(np.isinf(settled), back + times("return", among, "found"), settled)
            begin = np.where(settled > 0, times("death", who, "unmatched"), np.nan)
            yield [*map(_rounded_interval, begin, again)]
        for who in _LATE:
            if ("newcomer", who) not in known:
                continue
            begin = since["newcomer"]
            again = begin + times("newcomer", who, "found")
            if "return" in since:
                late = back + times("return", "newcomer", "found")
                again = np.where(np.isinf(again), late, again)
            yield [_rounded_interval(begin, end) for end in again]

    # A span for each of the `observed_pairs`; it has no end if contact never came back.
    runs = [list(run) for run in zip(*spans(), strict=True)]
    end = (rows["since_s"] + rows["watched_s"]).max()
    return {"event": event, "back": back, "joins": since["newcomer"], "end": end, "runs": runs}


def _rounded_interval(begin: float, end: float) -> list[float | None] | None:
    """Return two times to a hundredth of a second; None for an end that never came, or no span."""
    if np.isnan(begin):
        return None
    return [round(float(time), 2) if np.isfinite(time) else None for time in (begin, end)]
