"""The evidence that the rules of a diagnosis share: observations, and what follows from them."""

from collections import Counter
from collections.abc import Collection
from dataclasses import replace

import numpy as np

from discostorm_capture._types import Array
from discostorm_capture.diagnosis import pairs
from discostorm_capture.diagnosis.finding import LIMITS
from discostorm_capture.diagnosis.observations import HANDSHAKE, HEARTBEAT, SEDP, Observations
from discostorm_capture.diagnosis.reachability import zenoh_replies


class Evidence:
    """Observations and everything that several rules derive from them."""

    def __init__(self, obs: Observations) -> None:
        self.obs = obs
        #: Share of the paper's channel that all messages take.
        self.channel_use = float(obs["airtime_s"].sum() / max(obs.end, LIMITS.timeout))
        #: The processes that had announced their endpoints before the capture began.
        self.early_processes = _processes_before_capture(obs)
        #: Number of confirmed samples that the capture lacks, by sending and receiving host.
        self.missing_samples = _missing_samples(obs, self.early_processes)
        #: Hosts of which the capture has no message, with the number of answers sent to them.
        self.silent_hosts = _silent_hosts(obs)
        self.answered_samples = tuple(pairs.answered_samples(obs))
        self.min_answer_times = pairs.min_answer_times(obs, self.answered_samples)
        #: How each process ended: "left", "silent" or "".
        self.endings = _process_endings(obs)
        first, last = obs.first_last
        #: Processes that left so soon that a missing answer is no fault.
        brief = (self.endings == "left") & (last - first < LIMITS.timeout)
        self.brief_processes = {*np.flatnonzero(brief).tolist()}
        self.restart_chains = _restart_chains(obs, self.endings)
        self.replaced_processes = {one for chain in self.restart_chains for one in chain[:-1]}
        self.scopes = tuple(
            replace(scope, pairs=tuple(map(self._with_unknown_time, scope.pairs)))
            for scope in (*pairs.rtps_scopes(obs), *pairs.zenoh_scope(obs))
        )
        #: Readable endpoints with the index and host of their process and the number of its scope.
        index = obs.processes.index.get_indexer(obs.endpoints["process"].array)
        ends = obs.endpoints.assign(index=index)[index >= 0].dropna(subset="topic")
        scopes = {one: number for number, of in enumerate(self.scopes) for one in of.members}
        hosts = obs.process_host[ends["index"]]
        self.endpoints = ends.assign(host=hosts, scope=ends["index"].map(scopes))
        self.all_pairs = [pair for scope in self.scopes for pair in scope.pairs]
        #: Pairs that were present together for long enough to complete; those of them that never
        #: did; and those that started shortly before the capture ended.
        self.expected_pairs, self.incomplete_pairs, self.pending_pairs = [], [], []
        ended = self.endings != ""
        ended[[*self.replaced_processes]] = True
        last = last + np.where(ended, 0.0, LIMITS.max_pause)
        brief_hosts = Counter(obs.process_host[sorted(self.brief_processes)])
        for pair in self.all_pairs:
            begin = first[[*pair.processes]].max()
            newer = obs.process_host[max(pair.processes, key=first.item)]
            stop = min(obs.end, last[[*pair.processes]].min())
            if pair.complete_at != np.inf:
                self.expected_pairs.append(pair)
            elif stop - begin >= LIMITS.timeout:
                self.expected_pairs.append(pair)
                self.incomplete_pairs.append(pair)
            elif stop == obs.end and begin <= stop and brief_hosts[newer] < LIMITS.min_loop_starts:
                self.pending_pairs.append(pair)
        #: When each of the expected pairs completed, if the capture shows it [s].
        times = [pair.complete_at for pair in self.expected_pairs]
        self.completion_times = [time for time in times if not np.isnan(time)]
        #: Processes that were replaced by another one, or left before they had to know any other.
        in_pair, in_expected_pair = (
            {process for pair in chosen for process in pair.processes}
            for chosen in (self.all_pairs, self.expected_pairs)
        )
        self.gone_processes = self.replaced_processes | in_pair - in_expected_pair

    def _with_unknown_time(self, pair: pairs.Pair) -> pairs.Pair:
        """Return a pair, with an unknown time if it completed before the capture began."""
        if pair.subject in self.early_processes and not pair.n_announced and pair.complete_at > 0:
            return replace(pair, complete_at=np.nan)
        return pair


def _processes_before_capture(obs: Observations) -> set[int]:
    """Return the processes that had announced their endpoints before the capture began."""
    # First, processes with confirmed samples that the capture lacks, or has only later, sent to a
    # newcomer. Announcements that begin after sample 1 and long after the first message are not
    # startup.
    soon = obs.first_last[0] + LIMITS.max_startup_delay
    startup = {
        key: obs.time[rows[0]]
        for key, rows in pairs.endpoint_announcements(obs).items()
        if obs.seq[rows].min() == 1 or obs.time[rows[0]] < soon[key[0]]
    }
    unseen = {
        subject
        for (_, subject, writer), rows in pairs.acknowledgements(obs).items()
        if obs.seq[rows[0]] > 1 and obs.time[rows[0]] < startup.get((subject, writer), np.inf)
    }
    # Second, processes that exchange unicast without any startup message: no announcement,
    # Heartbeat, first acknowledgement or handshake.
    starts = obs.isin("kind", SEDP, HEARTBEAT, HANDSHAKE)
    starts |= obs.isin("submessage", "ACKNACK") & (obs.seq <= 1)
    talks = ~obs["multicast"] & obs.isin("protocol", "RTPS")
    talks &= obs.isin("receiver", *{*obs.process_host})  # not to one that refuses all
    settled = obs.senders(talks) - obs.senders(starts)
    refused = obs.hosts_refused_by_all
    # Third, processes that withdraw endpoints which they never announced.
    withdrawn, told = (obs.senders(obs.isin("kind", SEDP) & (obs["ends"] == end)) for end in (1, 0))
    unseen |= withdrawn - told
    # Fourth, processes that exchanged user data long before they announced any endpoint.
    data = _first_times(obs, (obs["user"] > 0) & ~obs["multicast"])
    for process, announced in _first_times(obs, obs.isin("kind", SEDP)).items():
        if data.get(process, np.inf) < announced - LIMITS.max_startup_delay:
            unseen.add(process)
    return unseen | {one for one in settled if obs.process_host[one] not in refused}


def _first_times(obs: Observations, mask: Array) -> dict[int, float]:
    """Return when each process sent the first of some messages [s]."""
    rows = obs.rows_by(mask & (obs.sender_index >= 0), obs.sender_index)
    return {process: float(obs.time[sent[0]]) for (process,), sent in rows.items()}


def _missing_samples(obs: Observations, late: Collection[int]) -> dict[tuple[str, str], int]:
    """Return the number of confirmed samples that the capture lacks, by sender and receiver."""
    gaps = obs.isin("submessage", "GAP") & (obs.sender_index >= 0)
    jumped = obs.rows_by(gaps, obs.sender_index, obs["writer"])
    sent = pairs.endpoint_announcements(obs)
    counts: dict[tuple[str, str], int] = {}
    for (observer, subject, writer), acks in pairs.acknowledgements(obs).items():
        if subject in late or (subject, writer) in jumped:
            continue
        rows, lacks = sent.get((subject, writer), acks[:0]), obs.seq[acks]
        if lacks.min() > 1 and not len(rows):
            continue
        # Count all samples of a Discovery Server, which sends each only to clients that need it.
        to_it = np.isin(obs.receiver_index[rows], (observer, -1)) | obs.is_server[subject]
        seqs = obs.seq[rows[to_it]]
        missing = int(lacks.max()) - 1 - len(np.unique(seqs[seqs < lacks.max()]))
        if missing > 0:
            ends = str(obs.process_host[subject]), str(obs.process_host[observer])
            counts[ends] = max(counts.get(ends, 0), missing)
    return counts


def _silent_hosts(obs: Observations) -> dict[str, int]:
    """Return hosts without captured messages, with the number of answers sent to them."""
    answers = obs.isin("submessage", "ACKNACK") & (obs.seq > 1)
    answers |= obs.uses_keys
    answers |= zenoh_replies(obs) & (obs.sender_index >= 0)
    # Add announced addresses: a host may send from another one, as with Docker's bridge.
    spoke = {*obs.host_first_last, *obs.process_host, *obs.announced_addresses}
    counts = obs.messages["receiver"][answers & ~obs["multicast"]].astype(str).value_counts()
    counts = counts[counts >= LIMITS.min_answers]
    return {str(host): int(count) for host, count in counts.items() if host not in spoke}


def _process_endings(obs: Observations) -> Array:
    """Return how each process ended: "left" (with a goodbye), "silent", or "" if it did not."""
    closed = _observed_ends(obs)
    # Skip RTPS processes without announcements: they may only use a server on their own host.
    announced = obs.senders(obs.isin("kind", "SPDP", *pairs.CLIENT_KINDS))
    # A host that acknowledges no segments is out of range: its silence counts sooner.
    vanished = {receiver: time for _, _, receiver, _, time in obs.event_tuples("vanished")}
    endings = np.full(len(obs.processes), "", object)
    for process, last in enumerate(obs.first_last[1]):
        rtps = obs.is_rtps[process]
        when, end = closed.get(process, (np.inf, ""))
        if not end or last - when >= LIMITS.late_delivery:
            away = vanished.get(obs.process_host[process], -np.inf) > last - LIMITS.late_delivery
            enough = LIMITS.steady_silence if away else LIMITS.zenoh_silence
            enough = LIMITS.rtps_silence if rtps else enough
            silent = _is_silent(obs, process, enough) and _others_still_send(obs, process, last)
            end = "silent" if silent and (process in announced or not rtps) else ""
        endings[process] = end
    return endings


def _is_silent(obs: Observations, process: int, enough: float) -> bool:
    """Return whether a process sent nothing at the end, for much longer than it paused before."""
    times = obs.time[obs.sender_index == process]
    pause = float(np.diff(times).max(initial=0.0))
    last = times[-1] if len(times) else np.inf
    return bool(obs.end - last > max(LIMITS.min_pause_ratio * pause, enough))


def _others_still_send(obs: Observations, process: int, since: float) -> bool:
    """Return whether other hosts sent messages well after a time."""
    others = ~obs.isin("sender", obs.process_host[process])
    return bool((obs.time[others] > since + LIMITS.min_time_of_others).any())


def _observed_ends(obs: Observations) -> dict[int, tuple[float, str]]:
    """Return when and how processes end: by a goodbye, or when a TCP connection is closed."""
    closed: dict[int, tuple[float, str]] = {}
    sender, receiver = obs.sender_index, obs.receiver_index
    calls = obs.events("connection", "half", "refused", "unanswered")
    closing = obs["ends"] & obs.isin("protocol", "TCP") & (sender >= 0) & (receiver >= 0)
    ends = np.minimum(sender, receiver), np.maximum(sender, receiver)
    for rows in obs.rows_by(closing, *ends).values():
        process, when = int(sender[rows[0]]), float(obs.time[rows[0]])
        host = obs.process_host[process]
        # The process that closes first has ended, unless its host opens connections afterwards.
        restarted = (obs.process_host == host) & (obs.first_last[0] > when)
        called = (calls["sender"] == host) & (calls["time"] > when)
        if (restarted.any() or not called.any()) and _others_still_send(obs, process, when):
            closed[process] = when, "silent"
    goodbye = (obs["ends"] & obs.isin("kind", "SPDP")) | obs.isin("kind", "Close")
    says = obs.isin("protocol", "Zenoh") & ~obs.isin("kind", "Hello", "Init", "Open", "Close")
    spoke = obs.links_of(obs.messages[says])
    for row in np.flatnonzero(goodbye & (sender >= 0)).tolist():
        # A router that closes a session before it is open refuses it.
        if obs.is_rtps[sender[row]] or obs.links_of(obs.messages[row : row + 1]) <= spoke:
            closed[int(sender[row])] = float(obs.time[row]), "left"
    return closed


def _restart_chains(obs: Observations, endings: Array) -> list[list[int]]:
    """Return chains of processes on a host, each of which began after the previous one ended."""
    chains: list[list[int]] = []
    product, (first, last) = obs.processes["product"].to_numpy(object), obs.first_last
    for processes in obs.processes_by_host(range(len(endings))).values():
        spoke = sorted(filter(lambda one: np.isfinite(first[one]), processes), key=first.item)
        ended = [one for one in spoke if endings[one] == "silent" or _stopped_sending(obs, one)]
        for process in spoke:
            like = [one for one in ended if product[one] == product[process]]
            before = [one for one in like if last[one] < first[process]]
            if before:
                latest = max(before, key=last.item)
                ended.remove(latest)
                chain = next((one for one in chains if one[-1] == latest), [latest])
                chains += [chain] * (len(chain) == 1)
                chain.append(process)
    return chains


def _stopped_sending(obs: Observations, process: int) -> bool:
    """Return whether a process that paused for at most 1 s before is now silent."""
    times = obs.time[obs.sender_index == process]
    steady = len(times) >= LIMITS.min_steady_messages and np.diff(times).max() <= 1.0
    steady = steady and times[-1] - times[0] >= 1.5
    return bool(steady and _is_silent(obs, process, LIMITS.steady_silence))
