"""The failures that the lab reproduced, run by run: who heard whom, and when not."""

import re
from collections.abc import Iterator
from functools import partial
from typing import Any

import numpy as np
import pandas as pd

from discostorm import words
from discostorm_book import lab_counts
from discostorm_book.lab_counts import death_times

#: By configuration: its name, the victim, and who has a server or router.
ARRANGEMENTS = {
    "Fast DDS Discovery Server": ("one Discovery Server", "the server", "one"),
    "Zenoh router": ("one central Zenoh router", "the router", "one"),
    "Zenoh router per host": ("a router per robot", "robot 1's router", "each"),
    "Zenoh router per host, one hub": ("a router per robot behind one hub", "the hub", "hub"),
}
#: Seconds from a kill to its restart, as ``data/measured/README.md`` says.
RESTART = 3.0
#: An event in which a process joins that was not there before.
_OUTAGE = r"outage of \d+ s"
#: By the subject of rows of ``data/measured/deaths.csv``: two groups, or one with itself, and their
#: name. First those that knew each other, then late joiners.
_KNOWN = {
    "survivors": ("survivors", "survivors", "{others}"),
    "orphans": ("orphans", "orphans", "The two processes of robot 1"),
    "orphans and survivors": ("orphans", "survivors", "Robot 1 and {others}"),
}
_LATE_NEIGHBORS = "Late joiner on robot 1 and its neighbors"
_LATE = {
    "newcomer": ("newcomer", "survivors", "Late joiner and {others}"),
    "newcomer, and orphans": ("newcomer", "orphans", "Late joiner and robot 1"),
    "newcomer beside orphans": ("beside", "survivors", "Late joiner on robot 1 and {others}"),
    "newcomer beside orphans, and orphans": ("beside", "orphans", _LATE_NEIGHBORS),
}


def relations(name: str) -> list[tuple[str, str, str]]:
    """Return the pairs of groups that were observed in a configuration, and their names."""
    rows = lab_counts.deaths()
    present = set(rows[rows["configuration"] == name]["who"])
    others = "robots 2 to 4" if "orphans" in present else "robots 1 to 4"
    return [
        (one, other, words.capitalized(text.format(others=others)))
        for who, (one, other, text) in (_KNOWN | _LATE).items()
        if who in present
    ]


def stagings(name: str) -> list[dict[str, Any]]:
    """Return the failures of a configuration's server or router, one for each event of the lab.

    The ``runs`` have for each of the `relations`, from when to when not all of them heard each
    other [s], None for to the end, or None if they did throughout.
    """
    every = pd.concat([lab_counts.deaths("deaths"), lab_counts.deaths("outages")])
    of_name = every[every["configuration"] == name]
    return [
        _staging(name, str(event), rows)
        for event, rows in of_name.groupby("event", sort=False)
        if event in ("server killed", "server restarts") or re.fullmatch(_OUTAGE, str(event))
    ]


def _staging(name: str, event: str, rows: pd.DataFrame) -> dict[str, Any]:
    since = dict(zip(rows["phase"], rows["since_s"], strict=True))
    back = since.get("return", RESTART)
    known = set(zip(rows["phase"], rows["who"], strict=True))

    times = partial(death_times, name, event)

    def spans() -> Iterator[list[list[float | None] | None]]:
        for who in _KNOWN:
            if ("death", who) not in known:
                continue
            again = settled = times("death", who, "settled")
            if "return" in since and np.isinf(settled).any():
                among = "survivors" if who == "survivors" else "orphans"
                again = np.where(np.isinf(settled), back + times("return", among, "found"), settled)
            begin = np.where(settled > 0, times("death", who, "unmatched"), np.nan)
            yield [*map(_span, begin, again)]
        for who in _LATE:
            if ("newcomer", who) not in known:
                continue
            begin = since["newcomer"]
            again = begin + times("newcomer", who, "found")
            if "return" in since:
                late = back + times("return", "newcomer", "found")
                again = np.where(np.isinf(again), late, again)
            yield [_span(begin, end) for end in again]

    runs = [list(run) for run in zip(*spans(), strict=True)]
    end = (rows["since_s"] + rows["watched_s"]).max()
    return {"event": event, "back": back, "joins": since["newcomer"], "end": end, "runs": runs}


def _span(begin: float, end: float) -> list[float | None] | None:
    """Return two times to a hundredth of a second; None for an end that never came, or no span."""
    if np.isnan(begin):
        return None
    return [round(float(time), 2) if np.isfinite(time) else None for time in (begin, end)]
