"""Findings about lost frames: how many, of which hosts, and what fills their links."""

from collections import Counter
from collections.abc import Iterator
from ipaddress import ip_address
from itertools import chain
from typing import Any

import numpy as np

from discostorm import wording
from discostorm_capture._types import Array
from discostorm_capture.diagnosis.evidence import Evidence
from discostorm_capture.diagnosis.finding import LIMITS, Finding
from discostorm_capture.diagnosis.observations import Observations
from discostorm_capture.endpoints import ros_topic
from discostorm_capture.sentences import join_names, say

#: Thresholds for loss of samples and of segments: minimum number of lost frames, minimum share, and
#: share of heavy loss [1]. Healthy runs of the lab lost at most 1 sample and 2 segments; runs with
#: 5 % loss stayed below the heavy shares. Two losses in a short capture may be chance.
SAMPLE_LOSS, SEGMENT_LOSS = (3, 0.001, 0.016), (3, 0.015, 0.13)
ENDS = ("sender", "receiver")
#: Findings that other programs fill a link, or other devices.
CROWDED = ("crowded link", "crowded by a device", "crowded by broadcast")


def find_losses(evidence: Evidence) -> tuple[tuple[int, int], tuple[int, int], Any, Any, Array]:
    """Return the lost and the total number of frames, first for samples, then for segments.

    Then return the numbers of lost and of all frames by sending or receiving host, and the times of
    the lost ones [s]. A sample counts as lost if an active receiver requests it after having had
    time to process it.
    """
    obs, lost, sent, ends, total = evidence.obs, list[int](), 0, Counter[str](), Counter[str]()
    frame = obs["frame"]
    for subject, observer, rows, asks in evidence.answered_samples:
        count = len(np.unique(frame[rows[obs.time[rows] > obs.time[asks[0]]]]))
        frames = lost_sample_frames(evidence, subject, observer, rows, asks)
        sent, lost = sent + count, [*lost, *frames]
        ends.update(dict.fromkeys(obs.hosts_of((subject, observer)), len(frames)))
        total.update(dict.fromkeys(obs.hosts_of((subject, observer)), count))
    hosts = [obs.indices_among(end, [*obs.host_first_last]) for end in ENDS]
    first, last = np.array([*obs.host_first_last.values(), (0.0, np.inf)]).T
    # Leave out segments from or to a host that has ended: it acknowledges nothing.
    tcp = (obs.time > first[hosts].max(axis=0) + LIMITS.startup_time) & obs.isin("transport", "TCP")
    tcp &= obs.time < last[hosts].min(axis=0)
    again = obs.messages[tcp & obs.isin("kind", "TCP retransmission")]
    when = np.append(obs.time[np.isin(frame, lost)], again["time"])
    ends.update(chain(again["sender"].astype(str), again["receiver"].astype(str)))
    each = obs.messages[tcp & ~obs.isin("protocol", "TCP")].drop_duplicates("frame")
    total.update(chain(*(rows[end].astype(str) for rows in (each, again) for end in ENDS)))
    return (len(lost), sent), (len(again), len(each) + len(again)), ends, +total, when


def lost_sample_frames(
    evidence: Evidence, subject: int, observer: int, sent: Array, answers: Array
) -> set[int]:
    """Return the frames of samples that the receiver requested after the usual answer time."""
    obs = evidence.obs
    delay = evidence.min_answer_times.get(obs.hosts_of((subject, observer)), 0.0)
    delay = delay if LIMITS.max_read_delay < delay < np.inf else 0.0
    # After a lease expired, the reader requests samples that it had confirmed: these are not lost.
    before = np.maximum.accumulate(np.append(0, obs.seq[answers]))[:-1]
    lacks = answers[(obs["missing"][answers] > 0) & (obs.seq[answers] >= before)]
    sent = sent[obs.time[sent] > obs.time[answers[0]]]
    if not (len(lacks) and len(sent)):
        return set()
    startup = obs.first_last[0][[subject, observer]].max() + LIMITS.startup_time
    sent = sent[np.lexsort((obs.time[sent], obs.seq[sent]))]
    number, time, frame = obs.seq[sent], obs.time[sent], obs["frame"][sent]
    # Combine number and time into one sorted key, to find the last transmission before a request.
    key = obs.end + 1.0
    lacking = obs.seq[lacks] * key + obs.time[lacks] - delay
    asked = np.searchsorted(number * key + time, lacking, side="right")
    last = np.maximum(asked - 1, 0)
    later = (asked > 0) & (number[last] == obs.seq[lacks])
    waited = obs.time[lacks] - time[last] > _max_read_delay(obs.time[lacks], startup) + delay
    # A hole is a loss, unless the sender is a server, which sends clients only what concerns them.
    later &= waited | (obs["holes"][lacks] & ~obs.is_server[subject])
    # Other samples of a request are lost if they are sent again.
    asks = np.append(-np.inf, np.sort(obs.time[lacks]))
    before = asks[np.searchsorted(asks, time[1:], side="right") - 1]
    between = before - time[:-1] > _max_read_delay(time[1:], startup) + delay
    between &= number[:-1] == number[1:]
    return {*frame[last[later]].tolist(), *frame[:-1][between].tolist()}


def _max_read_delay(time: Array, startup: float) -> Array:
    """Return the maximum time until a sample is processed, by when it is requested [s]."""
    return np.asarray(np.where(time > startup, LIMITS.max_read_delay, LIMITS.startup_read_delay))


def frame_loss(evidence: Evidence) -> Iterator[Finding]:
    """Report that frames are lost, and an estimate of their share."""
    *both, ends, total, when = find_losses(evidence)
    limits = zip(both, (SAMPLE_LOSS, SEGMENT_LOSS), strict=True)
    counts = [(*count, *limit) for count, limit in limits if count[0] >= limit[0]]
    signs = [_wilson_ci(lost, sent)[0] >= some for lost, sent, _, some, _ in counts]
    often = [(lost, total[of]) for of, lost in ends.items() if lost >= LIMITS.min_repeats]
    signs += [_wilson_ci(*count)[0] >= LIMITS.min_weak_share for count in often]
    if not any(signs):
        return
    heavy = any(lost > many * sent for lost, sent, *_, many in counts)
    again, sent = np.sum(both, axis=0).tolist()
    share, low, high = (wording.percent(one) for one in (again / sent, *_wilson_ci(again, sent)))
    text = say("loss", when.min(), when.max(), again, sent, share, low, high)
    least = LIMITS.min_share_of_one_host * again
    # A server, or the host that recorded, has a part in all frames.
    apart = {of for of in total if total[of] < LIMITS.min_share_of_one_host * sent}
    hosts = [of for of, count in ends.items() if count >= least and of in apart]
    host = min(hosts, key=total.__getitem__, default="")
    most = ends[host]
    shares = {of: ends[of] / total[of] for of in sorted(apart)}
    if host:
        text += f"; {wording.percent(most / again)} of the resent frames were to or from {host}"
        own, full = shares[host], evidence.channel_use >= LIMITS.max_channel_use
        if most >= LIMITS.min_repeats and own >= LIMITS.min_weak_share and not full:
            text += f" (about {wording.percent(own)} of its {total[host]:,} frames)"
            yield _crowded_link(evidence.obs, text) or Finding("weak link", (host,), text)
            return
    # Little loss is normal on Wi-Fi, unless it delays discovery.
    normal = _wilson_ci(again, sent)[0] <= LIMITS.max_healthy_loss
    normal &= not [*evidence.incomplete_pairs, *multicast_loss(evidence)]
    kind = "some loss" if normal else "heavy loss" if heavy else "loss"
    if beyond := one_way_loss(evidence):
        yield Finding("loss one way", beyond, say("one way loss", text, beyond))
        return
    worst = max(shares.values(), default=0.0)
    # A host that talks with one of the worst has about half its share.
    weak = tuple(of for of, share in shares.items() if share > 0.75 * worst)
    good = [of for of, share in shares.items() if share <= worst / 2]
    each = join_names([f"{of} ({wording.percent(share)})" for of, share in shares.items()])
    if worst >= LIMITS.min_weak_share and kind != "some loss":
        vantage, servers = evidence.obs.vantage_host, evidence.obs.hosts_of(evidence.obs.servers)
        many, own = len(shares) >= LIMITS.min_channel_hosts, vantage and vantage not in servers
        alike = min(shares.values()) >= max(LIMITS.min_weak_share, worst / 2)
        text += f"; share of frames lost per host: {each}" if many else ""
        if many and alike and own:  # the link of the host that recorded may be the common cause
            yield Finding("weak link", (str(vantage),), text)
            return
        if len(good) > 1 and len(weak) + len(good) == len(shares):
            yield Finding("weak link", weak, text)
            return
        kind = "channel loss" if many and alike and not heavy else kind
    obs, span = evidence.obs, max(np.ptp(when), LIMITS.timeout)
    meanwhile = (obs.time >= when.min()) & (obs.time <= when.max()) & (obs["user"] == 0)
    own = float(obs["airtime_s"][meanwhile].sum()) / span
    if kind in ("loss", "heavy loss", "channel loss") and own >= LIMITS.max_channel_use:
        kind, text = "discovery fills channel", say("discovery airtime", wording.percent(own), text)
    loss = Finding(kind, (), text)
    broken = len(evidence.obs.events("incomplete")) >= LIMITS.min_repeats
    crowded = _crowded_link(evidence.obs, text)
    # Little loss is a sign, too, if the host that loses frames is the one that sends so much.
    serious = loss.about == "fleet" or broken or (crowded and crowded.hosts == (host,))
    yield (serious and crowded) or loss


def one_way_loss(evidence: Evidence) -> tuple[str, ...]:
    """Return hosts, several, that miss many samples while nearly none of theirs is lost."""
    lost, sent = (dict[str, Counter[str]]((way, Counter()) for way in ENDS) for _ in range(2))
    for subject, observer, rows, asks in evidence.answered_samples:
        count = len(lost_sample_frames(evidence, subject, observer, rows, asks))
        for way, process in zip(ENDS, (subject, observer), strict=True):
            (host,) = evidence.obs.hosts_of([process])
            lost[way][host] += count
            sent[way][host] += int((evidence.obs.time[rows] > evidence.obs.time[asks[0]]).sum())
    (by, to), (all_by, all_to) = lost.values(), sent.values()
    hosts = tuple(
        host
        for host, count in sorted(to.items())
        if count >= max(LIMITS.min_repeats, LIMITS.min_one_way_loss * all_to[host])
        and by[host] <= LIMITS.max_healthy_loss * all_by[host]
    )
    most = sum(to[host] for host in hosts) >= LIMITS.min_share_of_one_host * to.total()
    return hosts if most and len(hosts) > 1 else ()


def late_deliveries(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts to which packets are under way for long at times, if few frames are lost."""
    late = evidence.obs.events("jitter")
    late = late[late["port"] >= 1e3 * LIMITS.min_jitter]
    if len(late) and all(one.about == "event" for one in frame_loss(evidence)):
        worst = late.groupby(["sender", "receiver"], observed=True)["port"].max()
        pairs = [(str(by), str(to)) for by, to in worst.index]
        flows = [f"from {by} to {to}" for by, to in pairs]
        text = say("late delivery", flows, worst.min())
        to_all = {to for _, to in pairs}
        # The link of one host may delay what goes both ways.
        hosts = tuple(sorted(to_all.intersection(*pairs) or to_all))
        kind = "late delivery" if len(hosts) == 1 else "late deliveries"
        yield _crowded_link(evidence.obs, text) or Finding(kind, hosts, text)


def skipped_samples(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts that get only part of the samples of a topic of rmw_zenoh, by their numbers."""
    obs, known = evidence.obs, evidence.endpoints
    known = known[~obs.is_rtps[known["index"]]]
    topics = dict(zip(known["entity"], known["topic"], strict=True))
    texts: dict[tuple[str, ...], list[str]] = {}
    pushed = obs.isin("kind", "Push") & (obs.seq > 0) & (obs["writer"] > 0)
    keys = obs.sender_index, obs.receiver_index, obs["writer"]
    for (sender, receiver, writer), rows in obs.rows_by(pushed, *keys).items():
        numbers = np.unique(obs.seq[rows])
        count = int(np.ptp(numbers)) + 1
        often = (np.diff(numbers) > 1).sum() >= LIMITS.min_calls
        few = count - len(numbers) > LIMITS.min_repaired_share * count
        # A gap of the capture is a gap in the numbers, too.
        if few and often and min(sender, receiver) >= 0 and not obs.recording.gaps:
            what = f"{len(numbers):,} of {count:,} of {ros_topic(topics.get(writer, 'a topic'))}"
            texts.setdefault(obs.hosts_of((sender, receiver)), []).append(what)
    for ends, said in texts.items():
        yield Finding.of("samples skipped", ends[-1:], ends[0], said)


def withheld_samples(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts that get no sample of a topic, although the samples reach their Zenoh router."""
    obs, begins, known = evidence.obs, evidence.obs.first_last[0], evidence.endpoints
    known = known[~obs.is_rtps[known["index"]]]
    names = known[["topic", "type", "type_hash"]].astype(str).to_numpy().tolist()
    known = known.assign(name=[" ".join(name) for name in names])
    # A router's samples do not show which of several publishers of a topic sent them.
    topics = dict(zip(known["entity"], known["name"], strict=True))
    topic, named = obs.messages["writer"].map(topics).factorize()
    pushed = obs.isin("kind", "Push") & (topic >= 0) & (not obs.recording.gaps)
    got = obs.rows_by(pushed, obs.receiver_index, topic)
    links = {*zip(obs.sender_index[pushed], obs.receiver_index[pushed], strict=True)}
    texts: dict[str, list[str]] = {}
    for (router, number), rows in got.items():
        ends = known[known["name"].eq(str(named[number]))] if router in obs.servers else known[:0]
        # Skip publishers, which get their own samples at once, and other routers.
        others = {*ends["index"]} - {*ends["index"][ends["writer"].eq(other=True)]} - obs.servers
        reads = ends[ends["index"].isin(others)]
        for reader, host, read in reads[["index", "host", "topic"]].to_numpy():
            count = int((obs.time[rows] > begins[reader] + LIMITS.startup_time).sum())
            served = (router, reader) in links and not evidence.endings[reader]
            if served and count >= LIMITS.min_calls and (reader, number) not in got:
                at = obs.process_host[router]
                texts.setdefault(host, []).append(
                    say("samples withheld", count, ros_topic(read), at)
                )
    for host, said in texts.items():
        yield Finding("samples withheld", (host,), join_names(said, "; "))


def _crowded_link(obs: Observations, text: str) -> Finding | None:
    """Return a finding if other programs of one host send most bytes, or broadcast many."""
    sent = obs.events("other traffic")
    flows, total = sent.groupby("sender", observed=True)["port"].sum(), obs["bytes"].sum()
    octets, total = int(flows.max()) if len(flows) else 0, flows.sum() + total
    if not octets or octets < LIMITS.min_other_share * total:
        hosts, _, said = _broadcasts(obs)
        return Finding(CROWDED[2], hosts, f"{said}; {text}") if hosts else None
    host = str(flows.idxmax())
    rate = f"{8e-6 * octets / max(obs.end, LIMITS.timeout):.2g} Mbit/s"
    own = obs.events("other traffic").query("sender == @host")
    to = str(own.groupby("receiver", observed=True)["port"].sum().idxmax())
    to_all = ip_address(to).is_multicast or to.endswith(".255")
    text = f"{say('crowded link', host, rate, to + ' (to all hosts)' * to_all)}; {text}"
    if host not in obs.host_first_last and not to_all:  # a download, perhaps from another network
        host = host if obs.subnet_neighbors(host, [*obs.host_first_last]) else to
    return Finding(CROWDED[host not in obs.host_first_last], (host,), text)


def _broadcasts(obs: Observations) -> tuple[tuple[str, ...], float, str]:
    """Return which hosts' other programs broadcast much, how much [bit/s], and a clause, or 0."""
    sent = obs.events("other traffic")
    cast = sent[sent["receiver"].astype(str).str.endswith(".255")]
    octets, total = cast["port"].sum(), sent["port"].sum() + obs["bytes"].sum()
    if octets < LIMITS.min_broadcast_share * total or cast.empty:
        return (), 0.0, ""
    rate = 8 * octets / max(obs.end, LIMITS.timeout)
    text = say("broadcasts", f"{1e-6 * rate:.2g} Mbit/s", cast["receiver"].unique())
    return tuple(map(str, cast["sender"].unique())), rate, text


def much_broadcast(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts on which other programs broadcast much, although few frames are lost."""
    hosts, rate, text = _broadcasts(evidence.obs)
    if rate >= LIMITS.min_broadcast_rate:
        yield Finding("much broadcast", hosts, text)


def multicast_loss(evidence: Evidence) -> Iterator[Finding]:
    """Report that processes answered later announcements of others, but not the first ones."""
    obs, count, late = evidence.obs, 0, dict[tuple[str, str], list[str]]()
    announced = obs.isin("kind", "SPDP") & obs["multicast"]
    for pair in evidence.expected_pairs:
        ends, met = [*pair.processes], pair.first_contact
        begin = obs.first_last[0][ends].max()
        if begin + LIMITS.min_wait < met < np.inf and not {*ends} & evidence.early_processes:
            calls = obs.time[announced & (obs.sender_index == pair.subject)]
            if ((calls > begin) & (calls < met - LIMITS.max_transit)).any():
                heard, by = obs.process_host[ends]
                late.setdefault((by, f"{met - begin:.1f}"), []).append(heard)
                count += 1
    if count >= LIMITS.min_calls:
        said = [f"{by} heard {join_names(of)} after {time} s" for (by, time), of in late.items()]
        yield Finding("multicast lossy", (), f"announcements came late: {join_names(said, '; ')}")


def _wilson_ci(count: int, total: int) -> tuple[float, float]:
    """Return the Wilson interval of a share, with 95% confidence."""
    share, z = count / total, 1.96
    middle, norm = share + z**2 / (2 * total), 1 + z**2 / total
    half = z * (share * (1 - share) / total + (z / (2 * total)) ** 2) ** 0.5
    return (middle - half) / norm, (middle + half) / norm
