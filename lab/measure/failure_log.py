"""From the logs of a run of the deaths to what happened, and for how long.

A log has a line for each event: a monotonic time [s], what, and whom. Processes are told apart by
number; what a middleware calls a process (in its line "me") is translated.

Quantities, all in seconds from the begin of a phase, infinite if it did not happen in it:

found      until each had been matched with each other one and had heard it
silence    longest time that one heard nothing of another one, once it had heard it
unmatched  until the first lost another one, who lives
settled    until all were matched with each other and heard each other, to the end
noticed    until the last of the others had given up the dead
ghost      for how long a newcomer was matched with the dead
"""

import math
import re
from collections import defaultdict
from collections.abc import Iterable
from dataclasses import dataclass
from itertools import pairwise, permutations, product
from pathlib import Path
from typing import Any

HEARD = 2.0  # s, ten samples: who hears nothing of another one for longer has a gap

LINE = re.compile(r"^(\d+\.\d{3}) ((?:un)?matched [rw]|\w+) (.*)\n", re.MULTILINE)
Pair = tuple[str, str]


@dataclass(frozen=True)
class Event:
    """A line of a log."""

    time: float
    what: str
    whom: str


def read_log(out: Path, name: str) -> list[Event]:
    """Return the events of a log; what a middleware says by itself, or a cut line, is none."""
    text = out.with_suffix(f".{name}.log").read_text(errors="replace")
    return [Event(float(time), what, whom) for time, what, whom in LINE.findall(text)]


class Run:
    """What each process of a run saw of each other one."""

    def __init__(self, out: Path, job: dict[str, Any]) -> None:
        #: When each phase began.
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
        #: When one was matched with another one (w as a writer, r as a reader), or no longer.
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
        """Return side and time of each change, and whether they are matched from then on."""
        return [
            (side, time, now)
            for side in "wr"
            for time, now in self.matched[*pair, side]
            if begin <= time < end
        ]

    def is_matched(self, pair: Pair, side: str, when: float) -> bool:
        """Return whether one was matched with the other at a time."""
        states = [now for time, now in self.matched[*pair, side] if time <= when]
        return bool(states) and states[-1]

    def found(self, pairs: list[Pair], begin: float, end: float) -> float:
        last = begin
        for pair in pairs:
            for side in "wr":
                if not self.is_matched(pair, side, begin):
                    changes = self.changes(pair, begin, end)
                    came = [time for one, time, now in changes if one == side and now]
                    last = max(last, min(came, default=math.inf))
            if not any(begin - HEARD <= time < begin for time in self.heard[pair]):
                heard = [time for time in self.heard[pair] if begin <= time < end]
                last = max(last, min(heard, default=math.inf))
        return last - begin

    def silence(self, pairs: list[Pair], begin: float, end: float) -> float:
        longest = 0.0
        for pair in pairs:
            before = [time for time in self.heard[pair] if time < begin][-1:]
            times = [*before, *(time for time in self.heard[pair] if begin <= time < end)]
            if not times or end - times[-1] > HEARD:
                return math.inf
            longest = max([longest, *(after - time for time, after in pairwise(times))])
        return longest

    def unmatched(self, pairs: list[Pair], begin: float, end: float) -> float:
        lost = [
            time for pair in pairs for _, time, now in self.changes(pair, begin, end) if not now
        ]
        return min(lost, default=math.inf) - begin

    def settled(self, pairs: list[Pair], begin: float, end: float) -> float:
        since = begin
        for pair in pairs:
            if not all(self.is_matched(pair, side, end) for side in "wr"):
                return math.inf
            since = max([since, *(time for _, time, _ in self.changes(pair, begin, end))])
            times = [begin, *(time for time in self.heard[pair] if begin <= time < end)]
            if end - times[-1] > HEARD:
                return math.inf
            gaps = [after for time, after in pairwise(times) if after - time > HEARD]
            since = max([since, *gaps])
        return since - begin

    def noticed(self, pairs: list[Pair], begin: float, end: float) -> float:
        if any(self.is_matched(pair, side, end) for pair in pairs for side in "wr"):
            return math.inf
        changes = [time for pair in pairs for _, time, _ in self.changes(pair, begin, end)]
        return max(changes, default=begin) - begin

    def ghost(self, pairs: list[Pair], begin: float, end: float) -> float:
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


def both_ways(ones: Iterable[str], others: Iterable[str]) -> list[Pair]:
    """Return the pairs of one of these and one of those, in either order."""
    there = list(product(ones, others))
    return there + [(other, one) for one, other in there]


def all_well(out: Path, job: dict[str, Any]) -> bool:
    """Return whether everybody knew everybody before the death; else a run says nothing of it."""
    run, groups = Run(out, job), job["groups"]
    names = {name for who in ("survivors", "orphans", "dead") for name in groups.get(who, [])}
    settled = run.settled([*permutations(sorted(names), 2)], run.at["well"], run.at["death"])
    return settled < math.inf


def evaluate(out: Path, job: dict[str, Any]) -> list[dict[str, Any]]:
    """Return a row for each phase, group and quantity of a run.

    The phases: well, death, newcomer (comes after the death), return (of who or what had died).
    The groups: `survivors`, who live, and whose own router, if they have one, does; `orphans`, who
    live, but whose own router died; `dead`; `newcomer`; and `returned`.
    """
    run = Run(out, job)
    at = run.at
    groups: dict[str, list[str]] = defaultdict(list, job["groups"])
    survivors, orphans, dead = groups["survivors"], groups["orphans"], groups["dead"]
    early = groups["early"]  # newcomers while all is well, and survivors afterwards
    first = [name for name in survivors + orphans + dead if name not in early]
    rows: list[dict[str, Any]] = []

    def add(phase: str, who: str, pairs: Iterable[Pair], end: str, *quantities: str) -> None:
        head = {"phase": phase, "who": who}
        times = {"since_s": at[phase] - at["death"], "watched_s": at[end] - at[phase]}
        window = (list(pairs), at[phase], at[end])
        rows.extend(
            head | {"quantity": quantity} | times | {"seconds": getattr(run, quantity)(*window)}
            for quantity in quantities
        )

    back = "return" if "return" in at else "end"
    add("well", "newcomer", both_ways(early, first), "death", "found")
    among = [*permutations(survivors, 2)]
    add("death", "survivors", among, back, "silence", "unmatched", "settled")
    if orphans:
        among = [*permutations(orphans, 2)]
        add("death", "orphans", among, back, "silence", "unmatched", "settled")
        across = both_ways(orphans, survivors)
        add("death", "orphans and survivors", across, back, "silence", "unmatched", "settled")
    if dead:
        add("death", "dead", product(survivors, dead), back, "noticed")
    newcomers = {"newcomer": groups["newcomer"], "newcomer beside orphans": groups["beside"]}
    for who, names in newcomers.items():
        if names:
            add("newcomer", who, both_ways(names, survivors), back, "found", "silence")
            if orphans:
                across = both_ways(names, orphans)
                add("newcomer", f"{who}, and orphans", across, back, "found")
            if dead:
                add("newcomer", who, product(names, dead), back, "ghost")
    if "return" in at:
        add("return", "survivors", permutations(survivors, 2), "end", "found")
        everybody = survivors + orphans
        if came := [name for names in newcomers.values() for name in names]:
            add("return", "newcomer", both_ways(came, everybody), "end", "found")
        if orphans:
            add("return", "orphans", both_ways(orphans, survivors), "end", "found")
        if returned := groups["returned"]:
            add("return", "returned", both_ways(returned, everybody + came), "end", "found")
    return rows
