"""Evaluate the logs of a run with a failure: events and their durations.

A log has a line for each event: monotonic time [s], event, process. Processes are identified by
number; a middleware's own name of a process (in its line "me") is translated.

Quantities [s], from the start of a phase; infinite if the event did not happen in the phase:

found      until each process was matched with each other one and had received a sample from it
silence    longest time in which a process received nothing from a process known to it
unmatched  until the first process lost the match with a living process
settled    until all processes stayed matched and received from each other, to the end
noticed    until the last process had dropped the failed process
ghost      time for which a late joiner was matched with the failed process
"""

import math
import re
from collections import defaultdict
from collections.abc import Iterable
from dataclasses import dataclass
from itertools import pairwise, permutations, product
from pathlib import Path
from typing import Any

MAX_GAP = 2.0  # s, ten samples: a longer silence is a gap

LOG_LINE = re.compile(r"^(\d+\.\d{3}) ((?:un)?matched [rw]|\w+) (.*)\n", re.MULTILINE)
Pair = tuple[str, str]


@dataclass(frozen=True)
class Event:
    """A line of a log."""

    time: float
    what: str
    whom: str


def read_log(out: Path, name: str) -> list[Event]:
    """Return the events of a log; skip truncated lines and the middleware's own output."""
    text = out.with_suffix(f".{name}.log").read_text(errors="replace")
    return [Event(float(time), what, whom) for time, what, whom in LOG_LINE.findall(text)]


class Run:
    """Observations of each process about each other process in a run."""

    def __init__(self, out: Path, job: dict[str, Any]) -> None:
        #: Start of each phase.
        self.at: dict[str, float] = {}
        for event, step in zip(read_log(out, "stage"), job["steps"], strict=True):
            assert (event.what, event.whom) == (step["do"], str(step["what"]))
            if "phase" in step:
                self.at[step["phase"]] = event.time
        logs = {name: read_log(out, name) for name in job["programs"] if name.isdigit()}
        number = {
            event.whom: name for name, log in logs.items() for event in log if event.what == "me"
        }
        self.heard: dict[Pair, list[float]] = defaultdict(list)
        #: Times at which a writer (w) or reader (r) was matched with another process, or unmatched.
        self.matched: dict[tuple[str, str, str], list[tuple[float, bool]]] = defaultdict(list)
        for name, log in logs.items():
            for event in log:
                whom = number.get(event.whom, event.whom)
                if event.what == "heard":
                    self.heard[name, whom].append(event.time)
                elif event.what[:-2] in ("matched", "unmatched"):
                    side, now = event.what[-1], event.what.startswith("matched")
                    self.matched[name, whom, side].append((event.time, now))

    def changes(self, pair: Pair, begin: float, end: float) -> list[tuple[str, float, bool]]:
        """Return side, time and new state of each match that changed."""
        return [
            (side, time, now)
            for side in "wr"
            for time, now in self.matched[*pair, side]
            if begin <= time < end
        ]

    def is_matched(self, pair: Pair, side: str, when: float) -> bool:
        """Return whether a process was matched with another one at a time."""
        states = [now for time, now in self.matched[*pair, side] if time <= when]
        return bool(states) and states[-1]

    def found(self, pairs: list[Pair], begin: float, end: float) -> float:
        """Return how long all pairs took to be matched and to receive samples [s]."""
        last = begin
        for pair in pairs:
            for side in "wr":
                if not self.is_matched(pair, side, begin):
                    changes = self.changes(pair, begin, end)
                    came = [time for one, time, now in changes if one == side and now]
                    last = max(last, min(came, default=math.inf))
            if not any(begin - MAX_GAP <= time < begin for time in self.heard[pair]):
                heard = [time for time in self.heard[pair] if begin <= time < end]
                last = max(last, min(heard, default=math.inf))
        return last - begin

    def silence(self, pairs: list[Pair], begin: float, end: float) -> float:
        """Return the longest time for which a process of these pairs received nothing [s]."""
        longest = 0.0
        for pair in pairs:
            before = [time for time in self.heard[pair] if time < begin][-1:]
            times = [*before, *(time for time in self.heard[pair] if begin <= time < end)]
            if not times or end - times[-1] > MAX_GAP:
                return math.inf
            longest = max([longest, *(after - time for time, after in pairwise(times))])
        return longest

    def unmatched(self, pairs: list[Pair], begin: float, end: float) -> float:
        """Return when the first match of these pairs was removed [s]; infinity if none was."""
        lost = [
            time for pair in pairs for _, time, now in self.changes(pair, begin, end) if not now
        ]
        return min(lost, default=math.inf) - begin

    def settled(self, pairs: list[Pair], begin: float, end: float) -> float:
        """Return when matches and samples of all pairs became steady [s]; infinity if never."""
        since = begin
        for pair in pairs:
            if not all(self.is_matched(pair, side, end) for side in "wr"):
                return math.inf
            since = max([since, *(time for _, time, _ in self.changes(pair, begin, end))])
            times = [begin, *(time for time in self.heard[pair] if begin <= time < end)]
            if end - times[-1] > MAX_GAP:
                return math.inf
            gaps = [after for time, after in pairwise(times) if after - time > MAX_GAP]
            since = max([since, *gaps])
        return since - begin

    def noticed(self, pairs: list[Pair], begin: float, end: float) -> float:
        """Return when the last match of these pairs was removed [s]; infinity if one is left."""
        if any(self.is_matched(pair, side, end) for pair in pairs for side in "wr"):
            return math.inf
        changes = [time for pair in pairs for _, time, _ in self.changes(pair, begin, end)]
        return max(changes, default=begin) - begin

    def ghost(self, pairs: list[Pair], begin: float, end: float) -> float:
        """Return the longest time of a match with a failed process that came back [s]."""
        longest = 0.0
        for pair in pairs:
            came: dict[str, float] = {}
            for side, time, now in self.changes(pair, begin, end):
                if now:
                    came[side] = time
                elif side in came:
                    longest = max(longest, time - came.pop(side))
            if came:
                return math.inf
        return longest


def ordered_pairs(first: Iterable[str], second: Iterable[str]) -> list[Pair]:
    """Return all pairs of a first and a second process, in both orders."""
    there = list(product(first, second))
    return there + [(other, one) for one, other in there]


def was_discovery_complete(out: Path, job: dict[str, Any]) -> bool:
    """Return whether discovery was complete before the failure; otherwise the run is useless."""
    run, groups = Run(out, job), job["groups"]
    names = {name for who in ("survivors", "orphans", "dead") for name in groups.get(who, [])}
    settled = run.settled([*permutations(sorted(names), 2)], run.at["well"], run.at["death"])
    return settled < math.inf


def evaluate(out: Path, job: dict[str, Any]) -> list[dict[str, Any]]:
    """Return a row for each phase, group and quantity of a run.

    Phases: well, death, newcomer (a late joiner after the failure), return (of what had failed).
    Groups: `survivors`, whose own router, if any, works; `orphans`, whose own router failed;
    `dead`; `newcomer`; and `returned`.
    """
    run = Run(out, job)
    at = run.at
    groups: dict[str, list[str]] = defaultdict(list, job["groups"])
    survivors, orphans, dead = groups["survivors"], groups["orphans"], groups["dead"]
    early = groups["early"]  # Late joiners of the phase "well" count as survivors afterwards.
    first = [name for name in survivors + orphans + dead if name not in early]
    rows: list[dict[str, Any]] = []

    def add(phase: str, subject: str, pairs: Iterable[Pair], end: str, *quantities: str) -> None:
        head = {"phase": phase, "who": subject}
        times = {"since_s": at[phase] - at["death"], "watched_s": at[end] - at[phase]}
        window = (list(pairs), at[phase], at[end])
        rows.extend(
            head | {"quantity": quantity} | times | {"seconds": getattr(run, quantity)(*window)}
            for quantity in quantities
        )

    back = "return" if "return" in at else "end"
    add("well", "newcomer", ordered_pairs(early, first), "death", "found")
    among = [*permutations(survivors, 2)]
    add("death", "survivors", among, back, "silence", "unmatched", "settled")
    if orphans:
        among = [*permutations(orphans, 2)]
        add("death", "orphans", among, back, "silence", "unmatched", "settled")
        across = ordered_pairs(orphans, survivors)
        add("death", "orphans and survivors", across, back, "silence", "unmatched", "settled")
    if dead:
        add("death", "dead", product(survivors, dead), back, "noticed")
    newcomers = {"newcomer": groups["newcomer"], "newcomer beside orphans": groups["beside"]}
    for who, names in newcomers.items():
        if names:
            add("newcomer", who, ordered_pairs(names, survivors), back, "found", "silence")
            if orphans:
                across = ordered_pairs(names, orphans)
                add("newcomer", f"{who}, and orphans", across, back, "found")
            if dead:
                add("newcomer", who, product(names, dead), back, "ghost")
    if "return" in at:
        add("return", "survivors", permutations(survivors, 2), "end", "found")
        everybody = survivors + orphans
        if came := [name for names in newcomers.values() for name in names]:
            add("return", "newcomer", ordered_pairs(came, everybody), "end", "found")
        if orphans:
            add("return", "orphans", ordered_pairs(orphans, survivors), "end", "found")
        if returned := groups["returned"]:
            add("return", "returned", ordered_pairs(returned, everybody + came), "end", "found")
    return rows
