"""Findings about samples: streams that fill a channel, copies, bursts, and lost fragments."""

from collections import Counter
from collections.abc import Iterator

import numpy as np

from discostorm import wording
from discostorm_capture.diagnosis import losses
from discostorm_capture.diagnosis.evidence import Evidence
from discostorm_capture.diagnosis.finding import LIMITS, Finding
from discostorm_capture.diagnosis.observations import SAMPLE_KINDS, Observations
from discostorm_capture.endpoints import ros_topic
from discostorm_capture.sentences import join_names, say


def repeated_multicast(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts that send user samples by multicast, and many of them again by unicast."""
    obs, lossy = evidence.obs, dict[str, tuple[int, int]]()
    data = obs.isin("kind", "User data") & obs["multicast"]
    asks = obs.isin("kind", "User ACKNACK") & (obs["missing"] > 0)
    asks |= obs.isin("submessage", "NACK_FRAG")
    for host in obs.messages["sender"][data].unique():
        to_all = int((data & obs.isin("sender", host)).sum())
        again = int((asks & obs.isin("receiver", host)).sum())
        if again >= max(LIMITS.min_messages, LIMITS.min_repaired_share * to_all):
            lossy[str(host)] = to_all, again
    hosts = sorted(lossy, key=lossy.__getitem__, reverse=True)
    if hosts:
        flows = obs.rows_by(data, obs.sender_index, obs["writer"])
        process, writer = max(flows, key=lambda key: obs["bytes"][flows[key]].sum())
        ends = evidence.endpoints
        topics = ends["topic"][ends["index"].eq(process) & ends["entity"].eq(writer)].dropna()
        said = [say("data by multicast", host, *lossy[host]) for host in hosts]
        said += [f"most bytes are of {ros_topic(topic)}" for topic in topics[:1]]
        yield Finding("data by multicast", tuple(hosts), "; ".join(said))


def data_fills_channel(evidence: Evidence) -> Iterator[Finding]:
    """Yield the host with the largest stream, if samples by multicast or unicast fill a channel."""
    obs, ends, sender = evidence.obs, evidence.endpoints, evidence.obs.messages["sender"].cat
    seconds = obs["airtime_s"] * obs["user"] * ~obs.isin("submessage", "ACKNACK")
    lossy = {host for one in repeated_multicast(evidence) for host in one.hosts}
    # A link that loses or delays frames may be slower than the channel.
    lost = [one for one in losses.frame_loss(evidence) if one.about == "fleet"]
    lost = [one for one in lost if one.kind not in losses.CROWDED]
    late = [one for one in losses.late_deliveries(evidence) if one.kind not in losses.CROWDED]
    slow = lost or late
    limit = LIMITS.max_multicast_use if slow else 1.0
    kinds = {"stream by multicast": LIMITS.max_multicast_use}
    kinds |= {"stream on a slow link" if slow else "much data": limit}
    for (kind, limit), cast in zip(kinds.items(), (True, False), strict=True):
        rows = (seconds > 0) & (obs["multicast"] == cast)
        fills = seconds[rows].sum() >= limit * max(obs.end, LIMITS.timeout)
        if not (rows.any() and (fills or slow)):
            continue
        flows = obs.rows_by(rows, sender.codes.to_numpy(), obs.sender_index, obs["writer"])
        ranked = sorted(((seconds[of].sum(), key) for key, of in flows.items()), reverse=True)
        # Robots of a kind send streams of a kind.
        keys = [key for airtime, key in ranked if 2 * airtime >= ranked[0][0]]
        together = np.concatenate([flows[key] for key in keys])
        octets = int(obs["bytes"][together].sum())
        # A link that is slow at times may carry less than the paper's channel.
        slows = slow and not cast and 2 * octets >= obs["bytes"].sum()
        if not (fills or (slows and 8 * octets >= LIMITS.slow_stream_rate * obs.end)):
            continue
        own = {key[1:] for key in keys}
        sent = [pair in own for pair in zip(ends["index"], ends["entity"], strict=True)]
        topic = ends["topic"][np.array(sent, bool)]
        by = dict.fromkeys(str(sender.categories[key[0]]) for key in keys)
        hosts = tuple(host for host in by if host not in obs.server_hosts) or (*by,)
        reads = ends["topic"].isin(topic) & ends["writer"].eq(other=False)
        readers = ends["host"][reads & ~ends["host"].isin(hosts)].unique()
        airtimes = seconds[together].sum(), seconds[rows].sum()
        shares = [wording.percent(one / obs.end) for one in airtimes]
        lasts = len(np.unique(obs.time[flows[keys[0]]].astype(np.int64)))
        most = not slow or cast or slows or 2 * airtimes[0] >= airtimes[1]
        if lasts >= LIMITS.min_stream_seconds and not lossy & {*hosts} and most:
            signs = [one.evidence for one in slow]
            named = [*topic.map(ros_topic)] or ["the largest stream"]
            to = f" to {join_names(readers)}" if len(readers) else ""
            text = say(kind, hosts, named, *shares, to, *signs)
            parts = obs["frames"][flows[keys[0]]]
            split = 2 * parts[parts >= LIMITS.min_datagram_parts].sum() >= parts.sum()
            split &= obs.is_rtps[keys[0][1]]
            if split and lost and not cast:
                text += say("datagram parts", int(np.ceil(parts.max())))
                kind = "stream in parts"
            yield Finding(kind, hosts, text)


def copies_to_other_addresses(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts that announce several addresses, if many samples are copied to them."""
    obs = evidence.obs
    data = obs.isin("kind", *SAMPLE_KINDS) & ~obs["multicast"]
    all_bytes = int(obs["bytes"][data].sum())
    for host, processes in obs.processes_by_host(range(len(obs.processes))).items():
        announced = dict.fromkeys(" ".join(obs.processes["announces"].iloc[processes]).split())
        others = [one for one in announced if one != host]
        rows = data & obs.isin("receiver", *others)
        octets, own = int(obs["bytes"][rows].sum()), data & obs.isin("receiver", host)
        fast = 8 * octets >= LIMITS.slow_stream_rate * max(obs.end, LIMITS.timeout)
        if fast and octets >= LIMITS.min_copied_share * all_bytes and own.any():
            senders = obs.messages["sender"][rows].unique()
            share = wording.percent(octets / all_bytes)
            yield Finding.of("copies", (host,), others, senders, rows.sum(), share)


def broken_off_samples(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts on whose Zenoh sessions the sender breaks off large samples again and again."""
    obs, ends = evidence.obs, evidence.endpoints
    routers = {*obs.hosts_of(sorted(obs.servers))}
    breaks = obs.messages[obs.isin("kind", "Fragment") & obs["holes"]]
    for pair, rows in breaks.groupby(["sender", "receiver"], observed=True)["time"]:
        if rows.astype(np.int64).nunique() >= LIMITS.min_stream_seconds:
            sender, receiver = map(str, pair)
            # The slow link is rarely that of the router.
            host = receiver if sender in routers and receiver not in routers else sender
            own = ends["host"].eq(sender) & ends["writer"].eq(other=True)
            named = ends["topic"][own].map(ros_topic).unique()
            text = say("breaks off", sender, len(rows), receiver)
            text += f"; it publishes {join_names(named)}" if len(named) else ""
            yield Finding("breaks off", (host,), text)


def busy_topics(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts that send a topic far more often than other robots, or very many requests."""
    obs, ends = evidence.obs, evidence.endpoints
    read = ends[ends["writer"].eq(other=False)]
    ends = ends[ends["writer"].eq(other=True) & ~ends["topic"].astype(str).str.endswith("/rosout")]
    sends = obs.isin("kind", *SAMPLE_KINDS) & (obs["writer"] > 0)
    rows = obs.rows_by(sends, obs.sender_index, obs["writer"])
    keys = zip(ends["index"], ends["entity"], strict=True)
    counts = [len(np.unique(obs.seq[rows[key]])) if key in rows else 0 for key in keys]
    ends = ends.assign(rate=np.array(counts) / max(obs.end, LIMITS.timeout))
    alike = ends["topic"].astype(str).str.replace(r"\d+", "#", regex=True)
    for (_, name), group in ends.groupby([ends["scope"], alike]):
        ranked = group.sort_values("rate")
        process, host, topic, rate = ranked[["index", "host", "topic", "rate"]].iloc[-1]
        usual, calls = ranked["rate"].iloc[:-1].max(), str(name).startswith("rq/")
        if (calls or rate >= LIMITS.min_rate_ratio * usual > 0) and rate >= LIMITS.log_rate:
            own = read["topic"].eq(topic) & read["index"].eq(process)
            kind = "many calls" if calls else "feeds itself" if own.any() else "busy topic"
            yield Finding.of(kind, (host,), ros_topic(topic), rate, usual)


def pausing_processes(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts that pause again and again, but then confirm at once all that they were sent."""
    obs, times = evidence.obs, evidence.min_answer_times.items()
    acks, lacks = obs.isin("submessage", "ACKNACK"), obs["missing"] > 0
    beats = obs.isin("submessage", "HEARTBEAT") & ~obs["multicast"] & obs["holes"]
    for host in sorted({to for (_, to), time in times if time < LIMITS.max_read_delay}):
        own = obs.isin("sender", host)
        sent = np.unique(obs.time[own])
        long = np.flatnonzero(np.diff(sent) > LIMITS.min_hang)
        pause = sent[long], sent[long + 1]
        after = pause[1], pause[1] + LIMITS.max_burst_pause
        # A best-effort reader never answers.
        reads = obs.rows_by(own & acks, obs.receiver_index, obs["writer"])
        rows = obs.rows_by(beats & obs.isin("receiver", host), obs.sender_index, obs["writer"])
        to_it = np.sort(np.concatenate([[], *(rows[one] for one in rows if one in reads)]))
        spans = (
            (to_it.astype(int), pause),
            (own & acks & ~lacks, after),
            (own & acks & lacks, after),
        )
        asked, good, bad = (
            np.diff(np.searchsorted(obs.time[of], at), axis=0)[0] for of, at in spans
        )
        late = (asked >= LIMITS.min_unanswered) & (good > 0) & (bad == 0)
        if late.sum() >= LIMITS.min_calls:
            longest = np.subtract(*pause[::-1])[late].max()
            counts = late.sum(), LIMITS.min_hang, longest, asked[late].sum()
            yield Finding.of("pauses", (host,), *counts)


def bursts_of_samples(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts whose writers all pause most of the time, and then send several samples each."""
    obs, sender = evidence.obs, evidence.obs.messages["sender"].cat
    data = obs.isin("kind", *SAMPLE_KINDS) & (obs["writer"] > 0)
    for (of,), rows in obs.rows_by(data, sender.codes.to_numpy()).items():
        host, times = str(sender.categories[of]), np.unique(obs.time[rows])
        long = np.flatnonzero(np.diff(times) > LIMITS.min_stall)
        begins, pauses = times[np.append(0, long + 1)], np.diff(times)[long]
        if len(long) < LIMITS.min_bursts or pauses.sum() < np.ptp(times) / 2:
            continue
        # A topic whose period is as long as the pauses has one sample in each burst.
        burst = np.searchsorted(begins, obs.time[rows], side="right")
        keys = zip(burst, obs.sender_index[rows], obs["writer"][rows], obs.seq[rows], strict=True)
        sizes = Counter(key[:3] for key in {*keys})
        several = {key[0] for key, count in sizes.items() if count > 1}
        others = obs.time[data & ~obs.isin("sender", host)]
        on = np.diff(np.searchsorted(others, (times[long], times[long + 1])), axis=0)[0] > 0
        alike = len({key[1:] for key in sizes}) > 1 and on.mean() >= LIMITS.min_steady_share
        if alike and len(several) >= LIMITS.min_steady_share * len(begins):
            yield Finding.of("bursts", (host,), len(long), pauses.min(), pauses.max())


def fragment_loss(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts that lose fragments of large samples, but no small samples."""
    obs = evidence.obs
    lacking, at = obs.event_tuples("incomplete"), str(obs.vantage_host)
    whole = obs.messages["frame"][obs.isin("receiver", at) & (obs["frames"] > 1)].nunique()
    flows = Counter(row[1:3] for row in lacking if row[2] == at)
    # A capture from the receiver lacks what did not get there.
    if flows.total() > max(whole, LIMITS.min_messages):
        pairs = [f"{count:,} from {of} to {to}" for (of, to), count in flows.most_common()]
        yield Finding("most samples in parts", (at,), say("lack fragments", flows.total(), pairs))
    asks = obs.isin("submessage", "NACK_FRAG") & ~obs["multicast"]
    asked = Counter(obs.messages["sender"][asks].astype(str))
    hosts = sorted(of for of, count in asked.items() if count >= LIMITS.min_fragment_requests)
    kinds = {one.kind for one in losses.frame_loss(evidence)}
    text = [f"{host} ({wording.count_noun(asked[host], 'time')})" for host in hosts]
    # What a capture from the receiver contains has reached it; its end may cut a datagram.
    few = flows.total() <= (1 - LIMITS.min_share_of_one_host) * asked[at]
    if hosts == [obs.vantage_host] and kinds <= {"some loss"} and few:
        yield Finding.of("full buffers", hosts, text)
    elif hosts and not kinds:
        repaired = all(_confirms_promptly(obs, host) for host in hosts)
        yield Finding.of("repaired bursts" if repaired else "burst loss", hosts, text)


def _confirms_promptly(obs: Observations, host: str) -> bool:
    """Return whether a host soon confirms most samples that it gets in fragments."""
    parts = obs.isin("submessage", "DATA_FRAG") & obs.isin("receiver", host)
    acks, waits = obs.isin("submessage", "ACKNACK") & obs.isin("sender", host), list[float]()
    asks = obs.rows_by(acks, obs.receiver_index, obs["writer"])
    samples = obs.rows_by(parts, obs.sender_index, obs["writer"], obs.seq)
    for (*writer, number), (first, *_) in samples.items():
        own = asks.get((*writer,), np.array([], np.int64))
        confirms = obs.time[own[(obs.seq[own] > number) & (own > first)]]
        waits.append(confirms.min(initial=np.inf) - obs.time[first])
    prompt = np.array(waits) <= LIMITS.max_repair_time
    return bool(len(waits) and prompt.mean() >= LIMITS.min_share_of_one_host)
