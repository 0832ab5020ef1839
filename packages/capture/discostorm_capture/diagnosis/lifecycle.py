"""Findings about processes that started late, fell silent, restarted or were forgotten."""

from collections import Counter
from collections.abc import Iterable, Iterator

import numpy as np

from discostorm_capture._types import Array
from discostorm_capture.diagnosis.evidence import Evidence
from discostorm_capture.diagnosis.finding import LIMITS, Finding
from discostorm_capture.diagnosis.losses import find_losses
from discostorm_capture.diagnosis.observations import Observations, event_tuples
from discostorm_capture.diagnosis.pairs import first_of_each_burst
from discostorm_capture.endpoints import ros_topic
from discostorm_capture.sentences import join_names, say


def _format_times(times: Iterable[float]) -> str:
    return join_names([*dict.fromkeys(f"{time:.1f} s" for time in times)])


def restarted_processes(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts whose processes restarted, once or in a loop."""
    obs, again, host_of = evidence.obs, dict[str, str](), evidence.obs.process_host
    first, last = obs.first_last
    for host in dict.fromkeys(host_of[chain[0]] for chain in evidence.restart_chains):
        chains = [chain for chain in evidence.restart_chains if host_of[chain[0]] == host]
        starts = sorted(first[new] for chain in chains for new in chain[1:])
        times = _format_times(starts)
        which = "processes" if len(starts) > 1 else "a process"
        ends = {evidence.endings[old] for chain in chains for old in chain[:-1]}
        how = "said goodbye" if ends == {"left"} else "gone silent"
        again[host] = f"on {host}, {which} began at {times}, after the previous one had {how}"
        if ends == {"left"}:
            continue
        if max(map(len, chains)) >= LIMITS.min_loop_starts:
            yield Finding("crash loop", (host,), again.pop(host))
        elif off := _was_off(obs, host, last[chains[0][-2]], first[chains[0][-1]]):
            again.pop(host)
            yield off
    for server in sorted(obs.servers):
        beats = obs.isin("kind", "SPDP Heartbeat") & (obs.sender_index == server)
        fell = np.diff(obs.seq[beats], prepend=0) < 0
        starts = first_of_each_burst(obs.time[beats][fell])
        if len(starts) >= LIMITS.min_loop_starts - 1:
            text = say("server restarts", *(hosts := obs.hosts_of([server])), _format_times(starts))
            yield Finding("crash loop", hosts, text)
    # Skip processes that received no messages: they have a different problem.
    met = sorted({*obs.receiver_index.tolist()} - {-1})
    left = [one for one in met if evidence.endings[one] == "left"]
    for host, ended in obs.processes_by_host(left).items():
        begins, ends = np.array(sorted(zip(first[ended], last[ended], strict=True))).T
        gaps, in_turn = np.diff(begins), (ends[:-1] < begins[1:]).all()
        many = len(gaps) >= LIMITS.min_regular_gaps
        regular = in_turn and many and gaps.max() <= LIMITS.max_gap_ratio * np.median(gaps)
        # Or several run at a time, as those of parallel loops do.
        brief = (ends - begins).max() <= LIMITS.max_startup_pause
        brief &= len(ended) >= LIMITS.min_repeats and np.ptp(begins) >= LIMITS.min_storm_time
        if regular or brief:
            again.pop(host, None)
            text = say("said goodbye often", host, len(ended), np.median(gaps))
            yield Finding("command loop", (host,), text)
    if again:  # one finding, because the whole fleet may have been restarted
        yield Finding("restart", tuple(again), "; ".join(again.values()))


def _was_off(obs: Observations, host: str, stop: float, start: float) -> Finding | None:
    """Return a finding if a host sent and refused nothing for a while after a process ended."""
    # Its system speaks before its processes do.
    answers = [row[4] for row in obs.event_tuples("unreachable", "refused") if row[2] == host]
    asks = [row[4] for row in obs.event_tuples("ARP request", "ARP reply") if row[1] == host]
    by_it = obs.time[obs.isin("sender", host)].tolist()
    # It may answer for a moment while it goes down.
    down = stop + LIMITS.late_delivery
    back = min([time for time in (*answers, *asks, *by_it) if time > down], default=start)
    sent = obs.time[obs.isin("receiver", host)]
    vain = int(((sent > down) & (sent < back)).sum())
    if vain < LIMITS.min_messages or back - stop < LIMITS.timeout:
        return None
    return Finding.of("host restarted", (host,), stop, back, vain)


def restarted_with_same_id(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts with a process whose writers all begin to number their samples anew."""
    obs, begins = evidence.obs, dict[int, list[tuple[int, float]]]()
    beats = obs.isin("kind", "User Heartbeat") & (obs.sender_index >= 0)
    rows = obs.rows_by(beats, obs.sender_index, obs["writer"], obs.receiver_index)
    for (process, writer, _), of in rows.items():
        fell = of[1:][(obs.seq[of[:-1]] >= LIMITS.min_steady_messages) & (obs.seq[of[1:]] <= 1)]
        if len(fell):
            begins.setdefault(process, []).append((writer, float(obs.time[fell[0]])))
    for process, found in begins.items():
        writers, times = zip(*found, strict=True)
        count = len({*writers})
        if count > 1 and np.ptp(times) <= LIMITS.max_startup_pause:
            yield Finding.of("same id again", obs.hosts_of([process]), count, min(times))


def slower_processes(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts with a process whose samples all get rarer than at first."""
    obs = evidence.obs
    samples = obs["user"].astype(bool) & ~obs.isin("submessage", "ACKNACK", "HEARTBEAT")
    samples &= obs["writer"] > 0
    by_writer: dict[int, dict[int, Array]] = {}
    for (process, writer), of in obs.rows_by(samples, obs.sender_index, obs["writer"]).items():
        new = np.unique(obs.seq[of], return_index=True)[1]  # once for all readers
        by_writer.setdefault(process, {})[writer] = obs.time[of[new]]
    steady = [one for one in {*by_writer} - {-1, *obs.servers} if not evidence.endings[one]]
    for process in steady:
        begin, end = (times[process] for times in obs.first_last)
        begin += LIMITS.startup_time
        third = (min(end, obs.end) - begin) / 3
        away = np.diff(obs.time[obs.sender_index == process]).max(initial=0.0) > LIMITS.timeout
        if third < LIMITS.timeout or away:
            continue
        flows = by_writer[process].values()
        at = begin, begin + third, end - third, end
        counts = [np.searchsorted(np.sort(times), at) for times in flows]
        rates = np.array([(b - a, d - c) for a, b, c, d in counts]).reshape(-1, 2)
        rates = rates[rates[:, 0] >= LIMITS.min_messages]
        slower = rates[:, 0] >= LIMITS.min_pause_ratio * np.maximum(rates[:, 1], 1)
        if len(rates) and slower.all() and (rates[:, 1] > 0).all():
            before, after = rates.sum(axis=0) / third
            ends = evidence.endpoints[evidence.endpoints["index"] == process]
            ends = ends[ends["entity"].isin([*by_writer[process]])]
            topics = sorted(ros_topic(of) for of in {*ends["topic"]} if "/" in of)
            named = f" (on {join_names(topics)})" if topics else ""
            values = obs.hosts_of([process]), before, third, after, named
            lacks = obs.isin("submessage", "NACK_FRAG") | (obs["missing"] > 0)
            asks = Counter(obs.sender_index[lacks & (obs.receiver_index == process)].tolist())
            ((reader, count),) = asks.most_common(1) or [(process, 0)]
            if count >= LIMITS.min_repeats and obs.first_last[0][reader] > begin:
                who, since = obs.process_host[reader], obs.first_last[0][reader]
                yield Finding(
                    "slow reader", values[0], say("slow reader", *values, who, since, count)
                )
            else:
                yield Finding.of("slows down", *values)


def piling_processes(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts on which participants of DDS keep starting, and none of them ends."""
    obs, begins = evidence.obs, evidence.obs.first_last[0]
    alive = np.flatnonzero(obs.is_rtps & (evidence.endings == "") & np.isfinite(begins)).tolist()
    for host, processes in obs.processes_by_host(alive).items():
        starts = begins[[one for one in processes if one not in evidence.early_processes]]
        thirds = np.linspace(starts.min(initial=obs.end), obs.end, 4)
        counts = np.histogram(starts, thirds)[0] if thirds[0] < obs.end else np.zeros(3)
        if counts.min() >= LIMITS.min_calls and np.ptp(starts) >= LIMITS.min_storm_time:
            yield Finding.of("processes pile up", (host,), len(starts), np.ptp(starts))


def paused_servers(evidence: Evidence) -> Iterator[Finding]:
    """Yield servers that answered nothing for a while, and Zenoh routers with TCP ACKs only."""
    obs = evidence.obs
    for host in obs.hosts_of(sorted(obs.servers)):
        by_it = obs.isin("sender", host)
        spoke, answered = obs.time[by_it], {*obs.messages["receiver"][by_it].astype(str)}
        asked = obs.time[obs.isin("receiver", host) & obs.isin("sender", *answered)]
        gap = np.searchsorted(spoke, asked)
        before, after = np.append(-np.inf, spoke)[gap], np.append(spoke, np.inf)[gap]
        vain = np.minimum(asked - before, after - asked) > LIMITS.max_transit
        vain &= np.isfinite(after - before)
        vain &= gap == np.bincount(gap[vain], minlength=1).argmax()
        if vain.sum() >= LIMITS.min_unanswered_messages:
            times = before[vain][0], after[vain][0]
            yield Finding.of("server away", (host,), *times, vain.sum())


def hanging_processes(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts whose only Zenoh process sends nothing, while its system acknowledges TCP."""
    obs = evidence.obs
    zenoh = np.flatnonzero(~obs.is_rtps).tolist()
    for host, (process, *more) in obs.processes_by_host(zenoh).items():
        by_it, serves = obs.isin("sender", host), process in obs.servers
        said = obs.time[by_it & obs.isin("protocol", "Zenoh")]
        steady = len(said) >= LIMITS.min_steady_messages and np.ptp(said) >= LIMITS.timeout
        if more or not steady:
            continue
        # The lease of a router may be long, so that KeepAlives to it need no answer for long.
        wants = obs.isin("receiver", host) & ~(obs.isin("kind", "KeepAlive") & serves)
        count = (obs.time[wants & ~obs.isin("protocol", "TCP")] > said[-1]).sum()
        usual = max(LIMITS.max_pause, LIMITS.repeat_factor * np.diff(said).max())
        if obs.time[by_it].max() - said[-1] > usual and count >= LIMITS.min_unanswered_messages:
            kind = "hangs" if serves else "process hangs"
            yield Finding(kind, (host,), say("hangs", host, said[-1], count))


def unread_sessions(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts where a program long reads nothing from a Zenoh session."""
    obs, texts = evidence.obs, dict[str, list[str]]()
    full = obs.events("full window")
    full = full[full["frame"].isin(obs["frame"])]  # not those of SSH or a download
    for _, host, sender, milliseconds, begin in event_tuples(full):
        if milliseconds >= 1e3 * LIMITS.min_wait:
            text = say("reads nothing", host, sender, begin, begin + milliseconds / 1e3)
            texts.setdefault(host, []).append(text)
    for host, said in texts.items():
        yield Finding("reads nothing", (host,), "; ".join(said))


def absent_hosts(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts that sent nothing for a while, although others kept sending to them."""
    obs, (first, last) = evidence.obs, evidence.obs.first_last
    for host in filter(lambda one: one not in obs.server_hosts, obs.host_first_last):
        spoke = np.unique(obs.time[obs.isin("sender", host)])
        if len(spoke) < LIMITS.min_steady_messages:
            continue
        pauses = np.diff(spoke)
        begin, end = spoke[pauses.argmax()], spoke[pauses.argmax() + 1]
        asks = obs.time[obs.isin("receiver", host) & ~obs.isin("submessage", "ACKNACK")]
        count = int(((asks > begin + LIMITS.max_transit) & (asks < end)).sum())
        stays = (obs.process_host == host) & (first < begin) & (last > end)
        enough = max(LIMITS.max_pause, LIMITS.min_pause_ratio * np.sort(pauses)[-2])
        if end - begin > enough and count >= LIMITS.min_unanswered_messages and stays.any():
            yield Finding.of("away", (host,), begin, end, count)


def outages(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts that sent nothing at times, if nearly all lost frames fall into these times."""
    obs, begins = evidence.obs, evidence.obs.first_last[0]
    away_hosts: dict[str, list[str]] = {}
    *_, lost = find_losses(evidence)
    for host in obs.host_first_last if len(lost) else ():
        spoke = np.unique(obs.time[obs.isin("sender", host)])
        begin, end = spoke[:-1], spoke[1:]
        usual = np.quantile(end - begin, LIMITS.min_steady_share) if len(begin) else np.inf
        asks = obs.time[obs.isin("receiver", host) & ~obs.isin("submessage", "ACKNACK")]
        # What was sent meanwhile is sent again when the host is back.
        asked, vain = (
            np.subtract(*(np.searchsorted(np.sort(times), at) for at in (until, begin)))
            for times, until in ((asks, end), (lost, end + LIMITS.late_delivery))
        )
        away = (end - begin > max(LIMITS.min_hang, LIMITS.min_outage_ratio * usual)) & (vain > 0)
        away &= begin > begins[obs.process_host == host].min(initial=np.inf) + LIMITS.startup_time
        away &= asked >= LIMITS.min_calls
        if vain[away].sum() >= max(LIMITS.min_calls, LIMITS.min_share_of_one_host * len(lost)):
            spans = zip(begin[away], end[away], asked[away], strict=True)
            away_hosts[host] = [say("outage", *span) for span in spans]
    text = "; ".join(f"{of} sent nothing {join_names(spans)}" for of, spans in away_hosts.items())
    if away_hosts:
        kind = "outages" if len(away_hosts) == 1 else "network outage"
        yield Finding(kind, tuple(away_hosts), say("outages", text))


def ended_processes(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts with crashed processes, then those with processes that said goodbye."""
    obs, last = evidence.obs, evidence.obs.first_last[1]
    # A server that others call in vain is reported as down instead.
    called = {row[2] for row in obs.event_tuples("refused", "unanswered")}
    vanished = {row[2]: row[4] for row in obs.event_tuples("vanished")}
    for end in ("silent", "left"):
        ends = np.flatnonzero(evidence.endings == end).tolist()
        for host, processes in obs.processes_by_host(ends).items():
            again = evidence.replaced_processes if end == "silent" else set()
            dead = [one for one in processes if one not in again]
            when = max(last[dead], default=np.nan)
            if end == "left":
                yield Finding("left", (host,), f"{host} said goodbye at {when:.1f} s")
            elif dead and not (obs.is_server & (obs.is_rtps | (host in called)))[dead].any():
                yield _describe_crash(evidence, host, dead, when, vanished.get(host, -np.inf))
            elif dead and (last[sorted(obs.servers - {*dead})] > when + LIMITS.timeout).any():
                text = say("crash", host, when, obs.recording.recorded_time)
                yield Finding("server lost", (host,), text)


def _describe_crash(
    evidence: Evidence, host: str, dead: list[int], when: float, vanished: float
) -> Finding:
    """Return whether processes crashed, or their host is gone since their last message."""
    obs = evidence.obs
    text = say("crash", host, when, obs.recording.recorded_time)
    # When the system of the host last answered, such as to a ping.
    on = obs.network_events["time"][obs.network_events["sender"] == host].max()
    endless = np.isinf(obs.processes["lease"].to_numpy()[dead]).any()
    since = when - LIMITS.late_delivery
    # The system of a process that crashes closes its connections, and refuses later messages.
    ends = obs["ends"] & obs.isin("sender", host) & (obs.time >= since)
    gone = vanished > since and not ends.any()
    later = obs.isin("receiver", host) & (obs.time > when + LIMITS.late_delivery)
    there = any(row[2] == host for row in obs.event_tuples("unreachable", "refused"))
    there |= obs.host_first_last[host][1] > when
    if obs.is_rtps[dead[0]] and later.sum() >= LIMITS.min_messages and not there:
        if on > when + LIMITS.timeout:
            said = say("host is on", host, when, later.sum(), on)
            return Finding("process hangs", (host,), said)
        text, gone = text + say("no ICMP", host, later.sum()), True
    kind = "endless lease" if endless else "crash"
    together = int((obs.first_last[1][dead] > when - 1).sum())
    if together > 1 and not gone and on > when + LIMITS.timeout and not endless:
        kind, text = "ended together", text + say("ended together", together, host, on)
    return Finding("out of range" if gone else kind, (host,), text)


def reopened_sessions(evidence: Evidence) -> Iterator[Finding]:
    """Yield Zenoh hosts that open a session with the same process again and again."""
    obs = evidence.obs
    ends = obs.sender_index, obs.receiver_index
    opened = obs.isin("submessage", "OpenAck") & (np.minimum(*ends) >= 0)
    for pair, rows in obs.rows_by(opened, np.minimum(*ends), np.maximum(*ends)).items():
        if len(rows) >= LIMITS.min_loop_starts:
            times = obs.time[rows]
            hosts = obs.hosts_of(sorted(pair, key=lambda one: obs.is_server[one]))
            text = say("opened sessions", hosts[0], len(rows), hosts[-1], times[0], times[-1])
            again = obs.isin("kind", "TCP retransmission") & obs.isin("sender", *hosts)
            kind = "sessions break" if again.sum() < LIMITS.min_repeats else "sessions stall"
            yield Finding(kind, hosts[:1], text)


def late_joiners(evidence: Evidence) -> Iterator[Finding]:
    """Yield the hosts of a scope that started after a pause of ``min_late_start`` or longer."""
    obs, begins = evidence.obs, evidence.obs.first_last[0]
    again = {process for chain in evidence.restart_chains for process in chain[1:]}
    for scope in evidence.scopes:
        members = sorted({*scope.members} - again - evidence.early_processes)
        members = sorted(filter(lambda one: np.isfinite(begins[one]), members), key=begins.item)
        hosts = obs.processes_by_host(members)
        starts = [begins[processes[0]] for processes in hosts.values()]
        gaps = np.diff(starts, prepend=[0.0] if evidence.early_processes else starts[:1])
        for first, gap, processes in zip(starts, gaps, hosts.values(), strict=True):
            late = {member for member in members if begins[member] >= first}
            # Skip hosts if the capture cannot show whether others learned their endpoints.
            learned = [pair.complete_at for pair in scope.pairs if pair.subject == processes[0]]
            if gap < LIMITS.min_late_start or (learned and np.isnan(learned).all()):
                continue
            sent = any(pair.n_announced for pair in scope.pairs if pair.subject in late)
            if evidence.early_processes and not sent:
                continue  # captured late, but their endpoints were announced before the capture
            who = obs.hosts_of(member for member in members if member in late)
            times = [pair.complete_at for pair in scope.pairs if {*pair.processes} & late]
            last = max(times, default=np.inf)
            delay = f"{last - first:.1f} s" if last - first >= 0.05 else "less than 0.1 s"
            then = f", and discovery was complete {delay} later"
            when = f"at {first:.1f} s" if len(who) == 1 else f"from {first:.1f} s on"
            yield Finding.of("late joiner", who, when, then if last < np.inf else "")
            break


def expired_leases(evidence: Evidence) -> Iterator[Finding]:
    """Yield the hosts most often rediscovered after an expired lease."""
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
    kind = "leases expire" if len(when) >= LIMITS.min_lease_expiries else "forgotten"
    leases = evidence.obs.processes.query("host in @hosts")["lease"]
    lease = f"; the lease is {leases.min():g} s" if np.isfinite(leases.min()) else ""
    text = say("rediscovered", hosts, _format_times(when), lease)
    servers = evidence.obs.hosts_of(
        sorted(evidence.obs.servers & {*np.flatnonzero(evidence.obs.is_rtps)})
    )
    # A host that recorded, and never paused for as long as its lease, did not time out.
    obs, own = evidence.obs, evidence.obs.vantage_host
    spoke = np.diff(obs.time[obs.isin("sender", str(own))]).max(initial=0.0) < leases.min()
    alone = own and spoke and {*hosts} == {own, *servers}
    if kind == "forgotten" and servers and (alone or {*hosts} >= {*obs.process_host}):
        kind, hosts = "server restarted", servers
    yield Finding(kind, hosts, text)
