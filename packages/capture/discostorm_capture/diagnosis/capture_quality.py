"""Findings about the capture itself: encryption, late begin, gaps, vantage host, clock, end."""

from collections import Counter
from collections.abc import Iterator
from ipaddress import ip_address
from itertools import permutations

import numpy as np

from discostorm import wording
from discostorm_capture.diagnosis.evidence import Evidence
from discostorm_capture.diagnosis.finding import LIMITS, Finding
from discostorm_capture.diagnosis.observations import ENCRYPTED, HEARTBEAT, Observations
from discostorm_capture.sentences import say

#: Maximum number of clock steps that are reported.
MAX_CLOCK_STEPS = 3


def encrypted_announcements(evidence: Evidence) -> Iterator[Finding]:
    """Report that announcements are encrypted, and how many pairs of processes exchanged keys."""
    obs = evidence.obs
    unknown = obs.processes["endpoints"].to_numpy() == 0
    hidden = obs.isin("kind", ENCRYPTED) & (obs.sender_index >= 0)
    hosts = obs.hosts_of(one for one in sorted(obs.senders(hidden)) if unknown[one])
    if hosts:
        ought, keys = (
            sum(len(obs.hosts_of(pair)) > 1 for pair in pairs)
            for pairs in (permutations(obs.secured_processes, 2), obs.key_exchanges)
        )
        yield Finding.of("encrypted", hosts, int(hidden.sum()), keys, ought)


def capture_began_late(evidence: Evidence) -> Iterator[Finding]:
    """Report that processes or sessions had started before the capture."""
    obs, late = evidence.obs, evidence.early_processes
    count = int((obs.is_rtps & np.isfinite(obs.first_last[0])).sum())
    zenoh = obs.isin("protocol", "Zenoh") & obs.isin("transport", "TCP")
    unknown = zenoh & (obs.sender_index < 0)
    if late and len(late) * 2 >= count:
        text = say("began late", len(late), count, sorted(obs.hosts_of(late)))
        yield Finding("capture began late", (), text)
    elif unknown.sum() > 0.5 * zenoh.sum() and not (unknown & obs.isin("kind", "Init")).any():
        first = sorted(obs.messages["sender"][unknown].astype(str).unique())
        yield Finding("capture began late", (), say("open before", first))


def incomplete_capture(evidence: Evidence) -> Iterator[Finding]:
    """Report that the capture lacks samples, hosts or packets."""
    text = list(evidence.obs.recording.gaps)
    missing: dict[str, int] = {}
    for (subject, _), count in evidence.missing_samples.items():
        missing[subject] = max(missing.get(subject, 0), count)
    if missing:
        samples = wording.count_noun(sum(missing.values()), "sample")
        text.append(say("lacks samples", samples, sorted(missing)))
    text += [say("lacks host", count, host) for host, count in evidence.silent_hosts.items()]
    if text:
        hosts = sorted({*missing, *evidence.silent_hosts})
        yield from _incomplete_samples(evidence.obs)
        yield Finding("capture lost part", tuple(hosts), "; ".join(text))


def _incomplete_samples(obs: Observations) -> Iterator[Finding]:
    """Report that IP datagrams lack fragments, and whether most of them are multicast."""
    flows = Counter(row[1:3] for row in obs.event_tuples("incomplete"))
    if (count := flows.total()) < LIMITS.min_messages:
        return
    (sender, receiver), most = flows.most_common(1)[0]
    pairs = [f"{number:,} from {of} to {to}" for (of, to), number in flows.most_common()]
    text = say("lack fragments", count, pairs)
    alone = most >= LIMITS.min_share_of_one_host * count
    if alone and ip_address(receiver).is_multicast:
        yield Finding("multicast in parts", (sender,), text)
    else:
        yield Finding("samples in parts", (), text)


def single_vantage_host(evidence: Evidence) -> Iterator[Finding]:
    """Report that the capture has the unicast of only one host."""
    obs = evidence.obs
    if host := obs.vantage_host:
        text = f"all captured unicast is to or from {host}"
        arp = obs.links_of(obs.events("ARP request"))
        near = {one for pair in arp if host in pair for one in pair} - {host}
        # Those that started earlier have asked before.
        near &= {*obs.host_first_last} - {*obs.hosts_of(evidence.early_processes)}
        # ARP requests are broadcast, so the capture would have them.
        begins = [obs.host_first_last[one][0] for one in sorted(near)]
        own = obs.host_first_last.get(host, (np.inf,))[0]
        if len(near) > 1 and min(begins) > own + LIMITS.timeout and np.ptp(begins) < 1:
            yield Finding.of("deaf at first", (host,), own, min(begins))
        elif len(near) > 1 and not any({*pair} <= near for pair in arp):
            text += say("no ARP between", sorted(near))
            calls = (obs.isin("kind", "SPDP", "Scout") & obs["multicast"]).any()
            yield Finding("multicast of one host" if calls else "peers of one host", (host,), text)
            return
        yield Finding("view of one host", (host,), text)


def clock_steps(evidence: Evidence) -> Iterator[Finding]:
    """Yield the steps of the capture's clock."""
    for frame, step in evidence.obs.recording.clock_steps[:MAX_CLOCK_STEPS]:
        text = say("clock step", frame, abs(step), "back" if step < 0 else "ahead")
        yield Finding("clock back" if step < 0 else "clock on", (), text)


def capture_ended_early(evidence: Evidence) -> Iterator[Finding]:
    """Report that the capture ended while pairs were still discovering each other."""
    if pending := evidence.pending_pairs:
        hosts = evidence.obs.hosts_of(pair.observer for pair in pending)
        pairs = wording.count_noun(len(pending), "pair")
        yield Finding.of("capture ended early", hosts, pairs, LIMITS.timeout)


def missing_confirmations(evidence: Evidence) -> Iterator[Finding]:
    """Report that the capture lacks confirmations: all writers waiting for one stopped asking."""
    obs, lacking = evidence.obs, evidence.incomplete_pairs
    for pair in lacking:
        beats = obs.isin("kind", HEARTBEAT) & (obs.sender_index == pair.subject)
        beats &= obs["multicast"] | obs.isin("receiver", obs.process_host[pair.observer])
        times = obs.time[beats & np.isin(obs.receiver_index, (pair.observer, -1))]
        end = obs.first_last[1][[*pair.processes]].min()
        pause = float(np.diff(times).max(initial=0.0))
        least = LIMITS.min_repeat if pause else LIMITS.max_repeat
        enough = max(LIMITS.repeat_factor * pause, least)
        if not pair.n_announced or not len(times) or end - times[-1] <= enough:
            return
    if hosts := evidence.obs.hosts_of(pair.observer for pair in lacking):
        yield Finding("capture lost part", hosts, say("asks no more", hosts))
