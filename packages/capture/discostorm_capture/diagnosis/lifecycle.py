"""Findings about processes that started late, fell silent, restarted or were forgotten."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from discostorm_capture.diagnosis.evidence import Evidence
from discostorm_capture.diagnosis.finding import Finding, listing
from discostorm_capture.diagnosis.pairs import MAX_TRANSIT, first_of_each_burst

#: A process that starts this long after the others joined late [s].
MIN_LATE_START = 5.0
#: Minimum number of starts in a crash loop, and of lease expiries that count as repeated.
MIN_LOOP_STARTS, MIN_LEASE_EXPIRIES = 4, 2
#: A server was down if this many messages in a row got no answer.
MIN_UNANSWERED_MESSAGES = 15
#: Starts of processes that leave are automatic if there are this many gaps between them, none
#: longer than this multiple of the median [1].
MIN_REGULAR_GAPS, MAX_GAP_RATIO = 5, 1.5


def restarted_processes(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts whose processes restarted, once or in a loop."""
    again, host_of = dict[str, str](), evidence.obs.process_host
    for host in dict.fromkeys(host_of[chain[0]] for chain in evidence.restart_chains):
        chains = [chain for chain in evidence.restart_chains if host_of[chain[0]] == host]
        starts = sorted(evidence.lifetimes[new].first for chain in chains for new in chain[1:])
        times = listing([*dict.fromkeys(f"{start:.1f} s" for start in starts)])
        which = "processes" if len(starts) > 1 else "a process"
        again[host] = f"{host}: {which} began at {times}, after the previous one had gone silent"
        if max(map(len, chains)) >= MIN_LOOP_STARTS:
            yield Finding("crash loop", (host,), again.pop(host))
    # Only processes that others answered: the rest has another problem.
    met = sorted({*evidence.obs.receiver_index.tolist()} - {-1})
    left = [one for one in met if evidence.lifetimes[one].ending == "left"]
    for host, ended in evidence.obs.processes_by_host(left).items():
        lives = sorted(
            (evidence.lifetimes[one] for one in ended), key=lambda life: (life.first, life.last)
        )
        gaps = np.diff([life.first for life in lives])
        in_turn = all(one.last < following.first for one, following in pairwise(lives))
        regular = len(gaps) >= MIN_REGULAR_GAPS and gaps.max() <= MAX_GAP_RATIO * np.median(gaps)
        if in_turn and regular:
            again.pop(host, None)
            text = f"{host}: {len(ended)} times, a process began and said goodbye, about every "
            yield Finding("crash loop", (host,), f"{text}{np.median(gaps):.1f} s")
    if again:  # one finding, because the whole fleet may have been restarted
        yield Finding("restart", tuple(again), "; ".join(again.values()))


def paused_servers(evidence: Evidence) -> Iterator[Finding]:
    """Yield servers that answered nothing for a while, but sent messages before and after."""
    obs = evidence.obs
    for host in obs.hosts_of(sorted(obs.servers)):
        by_it = obs.isin("sender", host)
        spoke, answered = obs.time[by_it], {*obs.messages["receiver"][by_it].astype(str)}
        asked = obs.time[obs.isin("receiver", host) & obs.isin("sender", *answered)]
        gap = np.searchsorted(spoke, asked)
        before, after = np.append(-np.inf, spoke)[gap], np.append(spoke, np.inf)[gap]
        vain = np.minimum(asked - before, after - asked) > MAX_TRANSIT
        vain &= np.isfinite(after - before)
        vain &= gap == np.bincount(gap[vain], minlength=1).argmax()
        if vain.sum() >= MIN_UNANSWERED_MESSAGES:
            text = f"{host}: silent from {before[vain][0]:.1f} s to {after[vain][0]:.1f} s, while "
            yield Finding("server away", (host,), f"{text}others sent it {vain.sum()} messages")


def ended_processes(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts with crashed processes, then those with processes that said goodbye."""
    obs, lifetimes = evidence.obs, evidence.lifetimes
    again = {process for chain in evidence.restart_chains for process in chain[:-1]}
    # A server that others call in vain is reported as down instead.
    called = {row[2] for row in obs.event_tuples("refused", "unanswered")}
    for end in ("silent", "left"):
        ends = [one for one, lifetime in enumerate(lifetimes) if lifetime.ending == end]
        for host, processes in obs.processes_by_host(ends).items():
            dead = [one for one in processes if end == "left" or one not in again]
            when = max((lifetimes[one].last for one in dead), default=np.nan)
            if end == "left":
                yield Finding("left", (host,), f"{host} said goodbye after {when:.1f} s")
            elif dead and not (obs.is_server & (obs.is_rtps | (host in called)))[dead].any():
                of = f"of a capture of {obs.quality.recorded_time:.1f} s"
                yield Finding("crash", (host,), f"{host}: last heard after {when:.1f} s, {of}")


def reopened_sessions(evidence: Evidence) -> Iterator[Finding]:
    """Yield Zenoh hosts that open a session with the same process again and again."""
    obs = evidence.obs
    ends = obs.sender_index, obs.receiver_index
    opened = obs.isin("submessage", "OpenAck") & (np.minimum(*ends) >= 0)
    for pair, rows in obs.rows_by(opened, np.minimum(*ends), np.maximum(*ends)).items():
        if len(rows) >= MIN_LOOP_STARTS:
            times = obs.time[rows]
            hosts = obs.hosts_of(sorted(pair, key=lambda one: obs.is_server[one]))
            text = f"{hosts[0]} opened {len(rows)} sessions with {hosts[-1]} from {times[0]:.1f} s "
            yield Finding("sessions break", hosts[:1], f"{text}to {times[-1]:.1f} s")


def late_joiners(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts whose first process started after all others of its scope were present."""
    obs, lifetimes = evidence.obs, evidence.lifetimes
    again = {process for chain in evidence.restart_chains for process in chain[1:]}
    for scope in evidence.scopes:
        members = sorted(set(scope.members) - again - evidence.early_processes)
        members = [member for member in members if np.isfinite(lifetimes[member].first)]
        members.sort(key=lambda member: lifetimes[member].first)
        hosts = obs.processes_by_host(members)
        starts = [lifetimes[processes[0]].first for processes in hosts.values()]
        gaps = np.diff(starts, prepend=starts[:1])
        for first, gap, processes in zip(starts, gaps, hosts.values(), strict=True):
            late = {member for member in members if lifetimes[member].first >= first}
            # Skip hosts if the capture cannot show whether others learned their endpoints.
            learned = [pair.complete_at for pair in scope.pairs if pair.subject == processes[0]]
            if gap < MIN_LATE_START or (learned and np.isnan(learned).all()):
                continue
            sent = any(pair.n_announced for pair in scope.pairs if pair.subject in late)
            if evidence.early_processes and not sent:
                continue  # captured late, but their endpoints were announced before the capture
            who = obs.hosts_of(member for member in members if member in late)
            times = [pair.complete_at for pair in scope.pairs if {*pair.processes} & late]
            last = max(times, default=np.inf)
            then = f", and discovery was complete {last - first:.1f} s later"
            text = f"{listing(who)} began after {first:.1f} s{then if last < np.inf else ''}"
            yield Finding("late joiner", who, text)
            break


def expired_leases(evidence: Evidence) -> Iterator[Finding]:
    """Yield the hosts whose leases expired at others most often, so that they were rediscovered."""
    times, pairs = dict[str, list[float]](), Counter[str]()
    for pair in evidence.all_pairs:
        for host in evidence.obs.hosts_of(pair.processes):
            times.setdefault(host, []).extend(pair.rediscovered_at)
            pairs[host] += 1
    most = max((len(expired) / pairs[host] for host, expired in times.items()), default=0.0)
    if not most:
        return
    hosts = tuple(host for host, expired in times.items() if len(expired) / pairs[host] == most)
    when = max((first_of_each_burst(times[host]) for host in hosts), key=len)
    kind = "leases expire" if len(when) >= MIN_LEASE_EXPIRIES else "forgotten"
    text = f"{listing(hosts)}: rediscovered after {listing([f'{time:.1f} s' for time in when])} by "
    leases = evidence.obs.processes.query("host in @hosts")["lease"]
    lease = f"; the lease is {leases.min():g} s" if np.isfinite(leases.min()) else ""
    yield Finding(kind, hosts, f"{text}other hosts{lease}")
