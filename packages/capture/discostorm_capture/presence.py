"""Which hosts are present while a network is watched: silent, mute, refusing, returning hosts."""

from collections import Counter, deque
from dataclasses import dataclass, field

import pandas as pd

from discostorm import wording
from discostorm_capture.diagnosis.finding import LIMITS, Finding
from discostorm_capture.diagnosis.observations import event_tuples
from discostorm_capture.sentences import join_names, say

#: Kinds of refusal events, the kind of event with ports that DDS addresses, and ports of Zenoh.
REFUSAL_KINDS, PORT_ADDRESSED, ZENOH_PORTS = ("unreachable", "refused"), "asked", (7446, 7447)
#: Maximum number of hosts, those heard last, and of changes that are kept.
MAX_HOSTS, MAX_CHANGES = 1024, 1000


@dataclass
class Activity:
    """When a host sends, or answers another one; times in seconds since 1970."""

    first: float
    last: float
    #: The longest pause between two messages, except outages [s].
    longest_pause: float = LIMITS.min_pause
    is_silent: bool = False
    #: When the host was last asked for an answer, last requested again, and last said goodbye.
    asked_at: float = 0.0
    rerequested_at: float = 0.0
    last_goodbye: float = 0.0
    products: str = ""
    messages: int = 0
    payload: int = 0

    @property
    def silence_limit(self) -> float:
        """The pause after which the host counts as silent [s]; infinite at first."""
        limit = 3 * self.longest_pause - LIMITS.renewal_period
        limit = min(LIMITS.silence_factor * self.longest_pause, limit)
        return limit if self.last - self.first >= LIMITS.baseline_time else float("inf")

    def record_message(self, time: float) -> float:
        """Record a message; return the duration of the outage that it ends [s], or 0."""
        pause, limit = time - self.last, self.silence_limit
        # A pause just above the limit is normal for this host; a longer one is an outage.
        self.longest_pause = max(self.longest_pause, pause if pause < 2 * limit else 0.0)
        outage = pause if self.is_silent or pause > limit else 0.0
        self.last, self.is_silent = time, False
        return outage


@dataclass
class Presence:
    """The activity of all hosts of a network, their refusals, and changes."""

    #: By address, in the order of their last messages.
    hosts: dict[str, Activity] = field(default_factory=dict)
    #: By the host that answers and the host that receives the answer.
    answers: dict[tuple[str, str], Activity] = field(default_factory=dict)
    #: By host and port: when it refused, and whom.
    refusals: dict[tuple[str, int], list[tuple[float, str]]] = field(default_factory=dict)
    #: When which host joined, left, fell silent or came back.
    changes: deque[tuple[float, str]] = field(default_factory=lambda: deque(maxlen=MAX_CHANGES))
    #: Kind and hosts of reported findings, except silent hosts.
    reported: set[tuple[str, tuple[str, ...]]] = field(default_factory=set)
    #: The time of the newest message.
    now: float = float("inf")

    def add_messages(self, rows: pd.DataFrame, begin: float) -> None:
        """Record new messages; `begin` is when watching began."""
        kind, unicast = rows["kind"].astype(str), ~rows["multicast"]
        again = (kind == "TCP retransmission") | ((kind == "ACKNACK") & (rows["missing"] > 0))
        answers = (rows["submessage"] == "ACKNACK") | (rows["transport"] == "TCP")
        answers &= unicast & (kind != "TCP retransmission")
        goodbye = (rows["ends"] & (kind == "SPDP")) | (kind == "Close")
        ends = (rows[end].astype(str) for end in ("sender", "receiver"))
        # Acknowledgements need no answer.
        wants = unicast & (rows["submessage"] != "ACKNACK")
        columns = (*ends, rows["time"], wants, again, answers, goodbye, rows["bytes"])
        for host, other, time, calls, asks, confirms, leaves, size in zip(*columns, strict=True):
            step, self.now = time - self.now, time
            if step > LIMITS.min_clock_step:
                for activity in (*self.hosts.values(), *self.answers.values()):
                    activity.last += step
            if host not in self.hosts and time - begin > LIMITS.baseline_time:
                self.changes.append((time, f"{host} joined"))
            activity = self.hosts[host] = self.hosts.pop(host, Activity(time, time))
            if outage := activity.record_message(time):
                self.changes.append((time, f"{host} came back after {wording.duration(outage)}"))
            activity.messages, activity.payload = activity.messages + 1, activity.payload + size
            activity.rerequested_at = time if asks else activity.rerequested_at
            if calls and (other, host) in self.answers:
                self.answers[other, host].asked_at = time
            if confirms:
                self.answers.setdefault((host, other), Activity(time, time)).record_message(time)
            activity.last_goodbye = time if leaves else activity.last_goodbye
        if len(self.hosts) > MAX_HOSTS:
            self.hosts = dict([*self.hosts.items()][-MAX_HOSTS:])
            kept = {*self.hosts}
            self.answers = {ends: one for ends, one in self.answers.items() if {*ends} <= kept}

    def add_refusals(self, events: pd.DataFrame, start: float) -> None:
        """Replace all refusals by those in `events`, whose times count from `start`."""
        rows = event_tuples(events.sort_values("time"))
        asked = {row[1:4] for row in rows if row[0] == PORT_ADDRESSED}
        ports = Counter(ends[:2] for ends in asked)
        self.refusals.clear()
        for kind, caller, host, port, since in rows:
            known = (caller, host, port) in asked or port in ZENOH_PORTS
            if kind in REFUSAL_KINDS and known and ports[caller, host] < LIMITS.port_search:
                times = self.refusals.setdefault((host, port), [])
                if not times or start + since - times[-1][0] > LIMITS.merge_time:
                    times.append((start + since, caller))
        if rows and not self.hosts:
            self.now = start + rows[-1][-1]

    def findings(self) -> list[Finding]:
        """Return findings on hosts that are silent, stopped answering, or refuse packets."""
        findings, now = list[Finding](), self.now
        for (host, port), times in self.refusals.items():
            callers = [caller for time, caller in times if now - time <= LIMITS.recent]
            if len(callers) > 1:
                text = say("refuses to", host, port, sorted({*callers}))
                findings.append(Finding("refuses", (host,), text))
        for host, activity in self.hosts.items():
            answers = [answer for (of, _), answer in self.answers.items() if of == host]
            last = max((answer.last for answer in answers), default=now)
            was_silent = activity.is_silent
            said_goodbye = activity.last_goodbye > activity.last - LIMITS.merge_time
            if said_goodbye and now - activity.last > LIMITS.goodbye_timeout:
                activity.is_silent, change = True, (activity.last, f"{host} left with a goodbye")
            elif now - activity.last > activity.silence_limit:
                text = say("silent", host, now - activity.last, activity.longest_pause)
                findings.append(Finding("silent", (host,), text))
                activity.is_silent, change = True, (now, f"{host} fell silent: {text}")
            elif now - activity.last <= activity.longest_pause and any(
                one.last == last and now - last > one.silence_limit < 2 * (one.asked_at - last)
                for one in answers
            ):
                findings.append(Finding.of("answers no more", (host,), now - last))
            if activity.is_silent and not was_silent:
                self.changes.append(change)
        others = {(one.kind, one.hosts): one.evidence for one in findings if one.kind != "silent"}
        self.changes.extend((now, others[key]) for key in others if key not in self.reported)
        # Refusals stay reported, though their packets may no longer be kept.
        self.reported = {*others, *(key for key in self.reported if key[0] == "refuses")}
        return findings

    def summary(self, begin: float) -> str:
        """Summarize how many hosts are present, and which of them request messages again."""
        there = {host: activity for host, activity in self.hosts.items() if not activity.is_silent}
        text = (
            f"Robots were already running when we began: {wording.count_noun(len(there), 'host')}"
        )
        if self.now - begin < (first := LIMITS.baseline_time):
            return f"{text} so far. We first learn for {first:.0f} s how often each one sends."
        since = self.now - LIMITS.recent
        again = [host for host, activity in there.items() if activity.rerequested_at >= since]
        also = f"{join_names(again)} requested messages again" if again else "none asks for repeats"
        # Of a host that was heard too briefly, no one knows how often it sends.
        rare = [of for of, one in there.items() if one.silence_limit > self.now - one.last > first]
        now = f"nothing came lately from {join_names(rare)}" if rare else "no host is silent"
        return f"{text}, {now}, and {also}."
