"""Diagnose a capture: whether discovery is healthy, complete and settled, and if not, why."""

import tomllib
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from functools import cached_property
from importlib import import_module
from typing import Any

import numpy as np
import pandas as pd

from discostorm import _checks, wording
from discostorm.data import data_path
from discostorm.files import json_ready
from discostorm_capture.diagnosis import groups, losses, topics
from discostorm_capture.diagnosis.evidence import Evidence
from discostorm_capture.diagnosis.finding import LIMITS, Finding, finding_kinds, to_sentence
from discostorm_capture.diagnosis.observations import SEDP, Observations
from discostorm_capture.dissection import json_rows
from discostorm_capture.sentences import join_names, say

RULES = tomllib.loads(data_path("diagnosis/rules.toml", "discostorm_capture").read_text("utf-8"))
#: Maximum number of rows of a timeline in JSON; if there are more, the shortest time step [s].
MAX_TIMELINE_ROWS, MIN_STEP = 2000, 1e-3
TIMELINE_COLUMNS = ["time_s", "host", "receiver", "multicast", "kind", "ends", "messages", "bytes"]
#: Kinds of messages that announce endpoints or open sessions.
STARTUP_KINDS = (SEDP, "Declare", "Init", "Open")
#: Findings that leave open whether discovery is healthy: QoS or some pairs of hosts are not shown.
UNDECIDED_KINDS = ("encrypted", "QoS unknown", "peers of one host", "multicast of one host")


def run_rules(group: str, evidence: Evidence) -> list[Finding]:
    """Return the findings of a group of rules in ``data/diagnosis/rules.toml``."""
    names = [name.split(".") for name in RULES[group]]
    rules = [getattr(import_module(f"{__package__}.{of}"), rule) for of, rule in names]
    return [finding for rule in rules for finding in rule(evidence)]


@dataclass(frozen=True)
class Diagnosis:
    """The state of discovery in a capture, as `Capture.diagnosis` returns it.

    Parameters
    ----------
    findings : tuple of Finding
        What is wrong with the fleet, most important first; events; limits of the capture.
    complete : bool or None
        Whether all processes know the others that they should; None if the capture cannot show it.
    over : bool or None
        Whether announcements had ended when the capture did; None if it shows no discovery.
    complete_at : float
        When the last pair completed, since the earliest packet and without clock steps [s];
        infinite if one never did, NaN if unknown.
    pairs : int
        Number of ordered pairs of processes on different hosts that should be complete.
    """

    findings: tuple[Finding, ...]
    complete: bool | None
    over: bool | None
    complete_at: float
    pairs: int
    _evidence: Evidence = field(compare=False, repr=False)

    @property
    def wrong(self) -> tuple[Finding, ...]:
        """What is wrong with the fleet; empty if the capture shows nothing."""
        return tuple(finding for finding in self.findings if finding.about == "fleet")

    @property
    def healthy(self) -> bool | None:
        """Whether nothing is wrong; None if the capture shows too little of discovery or QoS."""
        if self.wrong or self.complete is False:
            return False
        return None if any(one.kind in UNDECIDED_KINDS for one in self.findings) else self.complete

    @cached_property
    def _hosts(self) -> pd.DataFrame:
        """One row per host; see `hosts`."""
        evidence, obs = self._evidence, self._evidence.obs
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
        # Set the type: without any process, the column would be numeric.
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

    def hosts(self) -> pd.DataFrame:
        """Return one row per host.

        By ``host``, its address: ``products``; numbers of ``processes`` and ``endpoints``;
        ``announced_s``, when it sent its first message, ``knows_all_s``, when it knew all others,
        and ``known_s``, when all others knew it [s], infinite if never, NaN if unknown; numbers of
        ``sent`` and ``received`` messages; ``sent_bytes`` and ``received_bytes`` [B].
        """
        return self._hosts.copy()

    def incomplete(self) -> pd.DataFrame:
        """Return the pairs of processes that never completed.

        One row per pair: the host ``of`` the process to discover, the host ``by`` which it should
        be known, ``of_process`` and ``by_process``; ``heard_s``, when the latter first sent the
        former a message [s], infinite if never; the number of endpoints ``sent`` to it.
        """
        host, name = self._evidence.obs.process_host, self._evidence.obs.processes.index
        ends = [([*pair.processes], pair) for pair in self._evidence.incomplete_pairs]
        rows = [(*host[of], *name[of], one.first_contact, one.n_announced) for of, one in ends]
        columns = ["of", "by", "of_process", "by_process", "heard_s", "sent"]
        return pd.DataFrame(rows, columns=columns)

    def timeline(self, most: int = MAX_TIMELINE_ROWS) -> pd.DataFrame:
        """Return messages over time, until 1.25 times `complete_at`, and for at least 2 s.

        Each row has the messages of one ``kind`` in a packet: ``time_s`` [s]; ``host``, the sender;
        ``receiver``; ``multicast``; ``ends``, whether they are of a shutdown; numbers of
        ``messages`` and ``bytes``. If that takes more than `most` rows, a row has all messages of a
        host in a time step, the shortest possible, and ``receiver`` and ``multicast`` are None. The
        ``attrs`` are ``until_s``, the end [s], ``step_s``, the time step [s] or 0, and
        ``left_out``, the number of messages for which there were still too many rows.
        """
        _checks.integer("most", most, 1)
        rows, until = self._evidence.obs.messages, self._evidence.obs.end
        if np.isfinite(self.complete_at):
            shown = LIMITS.timeline_factor * self.complete_at
            until = min(until, max(LIMITS.min_timeline_time, shown))
            rows = rows[rows["time"] <= until]
        step, keys = 0.0, ["time", "sender", "receiver", "kind", "multicast", "ends"]
        groups = rows.groupby(keys, observed=True, sort=False)
        while groups.ngroups > most and step <= until:
            step = 2 * step or MIN_STEP
            steps = (rows["time"] // step).rename("step")
            groups = rows.groupby([steps, "sender", "kind", "ends"], observed=True, sort=False)
        sums = {
            "time_s": ("time", "first"),
            "messages": ("bytes", "size"),
            "bytes": ("bytes", "sum"),
        }
        table = groups.agg(**sums).reset_index().rename(columns={"sender": "host"})
        for column in ("host", "kind", "receiver", "multicast"):
            table[column] = table[column].astype(object) if column in table else None
        table = table.sort_values("time_s", kind="stable").iloc[:most][TIMELINE_COLUMNS]
        left_out = len(rows) - int(table["messages"].sum())
        table.attrs = {"until_s": until, "step_s": step, "left_out": left_out}
        return table

    def summary(self) -> str:
        """Return an event, the state of discovery, its cause and remedy, and if more is wrong."""
        happened = [one for one in self.findings if one.role == "headline"]
        limits = [one for one in self.findings if one.about == "capture" and one.role != "note"]
        if self.complete is not None and len(self._hosts) > 1:
            limits = [one for one in limits if one.kind in UNDECIDED_KINDS]
        reported = [*self.wrong, *happened, *limits]
        happened += [one for one in limits if one.kind == UNDECIDED_KINDS[-1]]
        headline = happened[0].summary if happened and not self.wrong else ""
        sentences = [to_sentence(headline), self._describe_state()]
        if reported:
            sentences += [to_sentence(reported[0].evidence), to_sentence(reported[0].advice)]
        elif self.complete is None:
            sentences.append(say("record", wording.TCPDUMP.format(file="discovery.pcap")))
        if (found := len(self.wrong)) > 1:
            sentences.append("Another finding follows." if found < 3 else "Other findings follow.")
        return " ".join(filter(None, sentences))

    def _describe_state(self) -> str:
        """Return a sentence on the state of discovery."""
        hosts, obs = self._hosts, self._evidence.obs
        gone = self._evidence.gone_processes if self.complete else set[int]()
        left = {*obs.hosts_of(gone)} - {*obs.hosts_of({*range(len(obs.processes))} - gone)}
        count = wording.count_noun(int(hosts["processes"].sum()) - len(gone), "process", "es")
        count += f" on {wording.count_noun(len(hosts) - len(left), 'host')}"
        seen = f", counting only pairs that include {obs.vantage_host}" if obs.vantage_host else ""
        if self.wrong:
            # Where a finding concerns pairs, do not call discovery complete.
            good = self.complete and not any(one.role for one in self.wrong)
            state = "complete, but not healthy" if good else "not healthy"
            state = "neither healthy nor complete" if self.complete is False else state
            return f"Discovery is {state}: {self.wrong[0].summary}."
        if self.complete is False:
            lacking = f"{len(self._evidence.incomplete_pairs)} of {self.pairs} pairs of processes"
            return f"Discovery is not complete: {lacking} have not discovered each other fully."
        if self.complete is None:
            if not len(self._hosts):
                return "The capture shows no DDS or Zenoh discovery."
            return f"The capture does not show whether discovery is complete ({count})."
        state = "complete and settled" if self.over else "complete, but announcements continue"
        if self.healthy:
            state = "healthy, " + state if self.over else "healthy and " + state
        time = self.complete_at
        when = f" within {time:.{1 if time >= 1 else 2}f} s" if time >= 0.01 else " within 10 ms"
        when = when if np.isfinite(time) else ""
        if any(one.kind == UNDECIDED_KINDS[-1] for one in self.findings):
            seen = f"Only pairs that include {obs.vantage_host}"
            return f"{seen} discovered each other{when and f', all{when}'} ({count})."
        mark = ":" if self.over else "."
        return f"Discovery is {state}{mark} {count} discovered each other{when}{seen}."

    def to_dict(self) -> dict[str, Any]:
        """Return all results as JSON can hold them; infinite and unknown times are null."""
        timeline = self.timeline()
        return {
            "summary": self.summary(),
            "healthy": self.healthy,
            "complete": self.complete,
            "over": self.over,
            "complete_s": json_ready(self.complete_at),
            "pairs": self.pairs,
            "findings": [finding.to_dict() for finding in self.findings],
            "hosts": json_rows(self._hosts.reset_index()),
            "incomplete": json_rows(self.incomplete()),
            "timeline": timeline.attrs | {"rows": json_rows(timeline)},
        }


def diagnose(obs: Observations) -> Diagnosis:
    """Return the diagnosis of a capture, given its observations."""
    evidence = Evidence(obs)
    causes, events, limits = (run_rules(group, evidence) for group in ("cause", "event", "limit"))
    causes += [one for one in events if one.about == "fleet"]
    roots = [one for one in causes if one.role == "explains"]
    hosts = {host for one in roots for host in one.hosts}
    others = [one for one in _unreplaced(causes, causes) if one not in roots]
    causes = roots + [c for c in others if not {*c.hosts} & hosts or len({*c.hosts} - hosts) > 1]
    lossy = _unreplaced(losses.frame_loss(evidence), [*causes, *events])
    if obs.recording.truncated_share > LIMITS.max_truncated_share:
        causes, lossy = list(groups.different_domains(evidence)), []
    causes = _unreplaced(causes, lossy) or list(unexplained_pairs(evidence, "not authenticated"))
    lossy = lossy or ([] if causes else list(losses.multicast_loss(evidence)))
    if not (causes or lossy or limits):
        causes = list(unexplained_pairs(evidence, "incomplete"))
    others = _unreplaced(run_rules("other", evidence), [*causes, *events])
    others = [one for one in others if not one.hosts or {*one.hosts} - hosts]
    findings = _unreplaced([*causes, *lossy, *others], [*lossy, *others])
    absent = {host for one in findings if one.role == "missing" for host in one.hosts}
    findings.sort(key=lambda one: [*finding_kinds()].index(one.kind))
    # First what is wrong with the missing hosts, such as a server that was not started there.
    findings.sort(key=lambda one: one.role == "missing" or not {*one.hosts} & absent)
    wrong = [one for one in findings if one.about == "fleet"]
    limits += [one for one in findings if one.about == "capture"]
    limits = [*_unreplaced(limits, wrong), *topics.unknown_qos(evidence)]
    happened = _unreplaced([*events, *others, *lossy], [*wrong, *events, *limits])
    happened = [one for one in happened if one.about == "event"]
    happened = [one for one in happened if one.kind != "absent" or not wrong]
    announced = obs.time[obs.isin("kind", *STARTUP_KINDS) & ~obs["ends"]]
    quiet = obs.recording.recorded_time - announced.max(initial=0.0)
    over = obs.end > 0 and quiet > LIMITS.min_quiet_time
    return Diagnosis(
        findings=(*wrong, *happened, *limits),
        complete=_is_complete(evidence, bool(wrong), {one.kind for one in limits}),
        over=bool(over) if len(announced) or evidence.expected_pairs else None,
        complete_at=max(evidence.completion_times, default=np.nan),
        pairs=len(evidence.expected_pairs),
        _evidence=evidence,
    )


def _unreplaced(findings: Iterable[Finding], by: list[Finding]) -> list[Finding]:
    """Return the findings that none of the others replaces.

    A finding about one host replaces only those about it, or about all.
    """
    kinds = [(kind, {*one.hosts}) for one in by for kind in one.replaces]
    return [
        one
        for one in findings
        if not any(
            one.kind == kind and (len(hosts) != 1 or not one.hosts or hosts & {*one.hosts})
            for kind, hosts in kinds
        )
    ]


def _is_complete(evidence: Evidence, wrong: bool, limits: set[str]) -> bool | None:
    """Return whether all pairs are complete; None if the capture cannot show it."""
    lacking = bool(evidence.incomplete_pairs)
    if not evidence.completion_times:
        return None
    if not wrong:
        lost = {"capture began late", "capture ended early"} & limits
        if lost or (lacking and "capture lost part" in limits):
            return None
        obs = evidence.obs
        sessions = obs.isin("protocol", "Zenoh") & ~obs["multicast"] & (obs.sender_index < 0)
        unknown = {*obs.messages["sender"][sessions].astype(str)} - {*obs.process_host}
        if evidence.silent_hosts or unknown:
            return None
    return not lacking


def unexplained_pairs(evidence: Evidence, kind: str) -> Iterator[Finding]:
    """Yield incomplete pairs, those with DDS Security or all, for which there is no other cause."""
    obs, pairs = evidence.obs, evidence.incomplete_pairs
    if kind == "not authenticated":
        pairs = [pair for pair in pairs if {*pair.processes} & obs.secured_processes]
    ends = dict.fromkeys(" and ".join(obs.hosts_of(sorted(pair.processes))) for pair in pairs)
    if pairs:
        hosts = obs.hosts_of(process for pair in pairs for process in pair.processes)
        counts = len(pairs), len(evidence.expected_pairs)
        text = say(kind, hosts, *counts, join_names([*ends], "; "))
        apart = {frozenset(obs.hosts_of(pair.processes)) for pair in pairs}
        secured = sorted({*hosts, *obs.hosts_of(sorted(obs.secured_processes))})
        groups = {tuple(one for one in secured if {one, host} not in apart) for host in secured}
        if kind == "not authenticated" and sum(map(len, groups)) == len(secured):
            text += say("certificates", join_names([*map(join_names, sorted(groups))], "; "))
        yield Finding(kind, hosts, text)
