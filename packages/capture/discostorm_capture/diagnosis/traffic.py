"""Findings about traffic: losses, storms, servers that do not answer."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from discostorm import words
from discostorm_capture._bytes import Array
from discostorm_capture.diagnosis.evidence import Evidence
from discostorm_capture.diagnosis.finding import Finding, listed
from discostorm_capture.diagnosis.observations import ACKNACK, DATA, HEARTBEAT, Observations
from discostorm_capture.diagnosis.scopes import clients

#: Thresholds for loss of samples and segments: the fewest frames that count, their share, and the
#: share of heavy loss [1]. The lab's healthy runs had at most 1 sample and 2 segments, those with
#: 5 % of loss less than the heavy shares.
SAMPLES, SEGMENTS = (2, 0.001, 0.016), (3, 0.015, 0.13)
#: So long a sample may wait before it is read [s]; and in the first seconds of a process or host,
#: in which segments do not count: TCP repeats them at once.
READ, STARTUP, READ_AT_STARTUP = 0.02, 1.5, 0.25
#: A storm lasts if endpoints are announced again in more than this share of the seconds of the last
#: third [1], of a capture of at least so long [s].
STILL, MIN_STORM = 0.5, 12.0
#: Messages of discovery that are repeated so often in each of the last seconds [1/s] are a flood;
#: without one, the products repeat them at most once in 100 ms (lab/data, steady state).
FLOOD_RATE, FLOOD_TIME = 20, 3
REPEATED = (DATA, HEARTBEAT, ACKNACK, "Gap", "SPDP", "SPDP Heartbeat", "SPDP ACKNACK")
#: A server is down after so many calls in vain, or so many messages within this time [s].
CALLS, MESSAGES, WAIT = 3, 15, 3.0
#: The port of Zenoh's routers.
PORT = 7447


def losses(obs: Observations) -> tuple[tuple[int, int], tuple[int, int]]:
    """Return how many frames were lost on their way, and of how many: with samples, with segments.

    A sample is lost if its receiver, having spoken before, asks for it once it had time to read it.
    """
    sender, receiver, frame = obs.sender_index, obs.receiver_index, obs["frame"]
    sends = obs.isin("submessage", "DATA", "DATA_FRAG") & (obs.number > 0) & (sender >= 0)
    sent_by = obs.groups(sends & ~obs.isin("kind", "SPDP"), sender, obs["writer"])
    answers = obs.isin("submessage", "ACKNACK") & (sender >= 0) & (receiver >= 0)
    lost, sent = 0, 0
    for (subject, writer, observer), asks in obs.groups(
        answers, receiver, obs["writer"], sender
    ).items():
        rows = sent_by.get((subject, writer), asks[:0])
        rows = rows[np.isin(receiver[rows], (observer, -1)) & (obs.time[rows] > obs.time[asks[0]])]
        sent += len(np.unique(frame[rows]))
        lacks = asks[obs["missing"][asks] > 0]
        if len(lacks) and len(rows):
            begin = obs.first_last[0][[subject, observer]].max()
            lost += len(_lost_frames(obs, rows, lacks, begin + STARTUP))
    began, ended = _both_spoke(obs)
    # Who has ended acknowledges nothing more.
    tcp = obs.isin("transport", "TCP") & (obs.time > began + STARTUP) & (obs.time < ended)
    repeated = int((tcp & obs.isin("kind", "TCP retransmission")).sum())
    segments = len(np.unique(frame[tcp & ~obs.isin("protocol", "TCP")]))
    return (lost, sent), (repeated, segments + repeated)


def _both_spoke(obs: Observations) -> tuple[Array, Array]:
    """Return when both ends of each message had begun, and when the first one ended [s]."""
    hosts = [*obs.host_first_last]
    first = np.array([*(first for first, _ in obs.host_first_last.values()), 0.0])
    last = np.array([*(last for _, last in obs.host_first_last.values()), np.inf])
    ends = [obs.index(end, hosts) for end in ("sender", "receiver")]
    return np.maximum(*(first[end] for end in ends)), np.minimum(*(last[end] for end in ends))


def _lost_frames(obs: Observations, sent: Array, lacks: Array, startup: float) -> set[int]:
    """Return the frames of samples that are asked for later."""
    sent = sent[np.lexsort((obs.time[sent], obs.number[sent]))]
    number, time, frame = obs.number[sent], obs.time[sent], obs["frame"][sent]

    # By number and time, as one key: of each number the last one before it was asked for.
    key = obs.end + 1.0
    lacking = obs.number[lacks] * key + obs.time[lacks]
    asked = np.searchsorted(number * key + time, lacking, side="right")
    last = np.maximum(asked - 1, 0)
    later = (asked > 0) & (number[last] == obs.number[lacks])
    later &= obs.time[lacks] - time[last] > _reading(obs.time[lacks], startup)
    # What else an answer asks for is sent again.
    asks = np.append(-np.inf, np.sort(obs.time[lacks]))
    before = asks[np.searchsorted(asks, time[1:], side="right") - 1]
    between = before - time[:-1] > _reading(time[1:], startup)
    between &= number[:-1] == number[1:]
    return {*frame[last[later]].tolist(), *frame[:-1][between].tolist()}


def _reading(time: Array, startup: float) -> Array:
    """Return how long a sample may wait before it is read, by when it is asked for [s]."""
    return np.where(time > startup, READ, READ_AT_STARTUP)


def loss(evidence: Evidence) -> Iterator[Finding]:
    """Yield that frames are lost, and about how many."""
    both = losses(evidence.obs)
    counts = list(zip(both, (SAMPLES, SEGMENTS), strict=True))
    if not any(
        lost >= few and _interval(lost, sent)[0] >= some for (lost, sent), (few, some, _) in counts
    ):
        return
    heavy = any(lost >= few and lost > many * sent for (lost, sent), (few, _, many) in counts)
    again, sent = np.sum(both, axis=0).tolist()
    share, low, high = (words.percent(one) for one in (again / sent, *_interval(again, sent)))
    said = f"{again} of {sent} frames with samples or segments that the capture shows were asked "
    said += f"for or sent again, so about {share} were lost ({low} to {high} with 95% confidence), "
    said += "or the answers to them"
    yield Finding("heavy loss" if heavy else "loss", (), said)


def _interval(count: int, total: int) -> tuple[float, float]:
    """Return Wilson's interval of a share, with 95% confidence."""
    if not total:
        return 0.0, 1.0
    share, z = count / total, 1.96
    middle, norm = share + z**2 / (2 * total), 1 + z**2 / total
    half = z * (share * (1 - share) / total + (z / (2 * total)) ** 2) ** 0.5
    return (middle - half) / norm, (middle + half) / norm


def storm(evidence: Evidence) -> Iterator[Finding]:
    """Yield that endpoints are still announced again and again when the capture ends."""
    obs = evidence.obs
    times = obs.time[obs.isin("kind", DATA) & ~obs["ends"]]
    third = (obs.end - times.min(initial=obs.end)) / 3
    if third * 3 < MIN_STORM:
        return
    last = times[times > times[0] + 2 * third]
    if len(np.unique(last.astype(np.int64))) < STILL * third:
        return
    first = times[times <= times[0] + third]
    said = f"{len(last)} messages announced endpoints in the last {third:.0f} s, and {len(first)} "
    yield Finding("storm", (), f"{said}in the first {third:.0f} s")


def flood(evidence: Evidence) -> Iterator[Finding]:
    """Yield who repeats messages of discovery without end, though all endpoints are known."""
    obs = evidence.obs
    complete = [pair.complete for pair in evidence.pairs if not np.isnan(pair.complete)]
    begin = obs.end - FLOOD_TIME
    if not complete or max(complete) + STARTUP > begin:
        return
    rows = (obs.time > begin) & obs.isin("kind", *REPEATED) & ~obs["multicast"]
    hosts = [*obs.messages["receiver"].cat.categories]
    keys = (obs.sender_index, obs.index("receiver", hosts), obs["writer"], obs["reader"])
    floods: dict[tuple[str, str, str], list[int]] = {}
    for group in obs.groups(rows, *keys).values():
        seconds = np.bincount((obs.time[group] - begin).astype(np.int64), minlength=FLOOD_TIME)
        if seconds[:FLOOD_TIME].min() >= FLOOD_RATE:
            first = obs.messages.iloc[group[0]]
            what = (str(first["sender"]), str(first["receiver"]), str(first["kind"]))
            floods.setdefault(what, []).append(len(group))
    if not floods:
        return
    count = sum(sum(counts) for counts in floods.values())
    said = listed([f"{one} to {other} ({kind})" for one, other, kind in floods])
    yield Finding(
        "flood",
        tuple(dict.fromkeys(sender for sender, *_ in floods)),
        f"{count / FLOOD_TIME:,.0f} messages a second in the last {FLOOD_TIME} s, although all "
        f"endpoints are known since {max(complete):.1f} s: {said}",
    )


def server_down(evidence: Evidence) -> Iterator[Finding]:
    """Yield the servers and routers that do not answer."""
    obs = evidence.obs
    down = dict(_discovery_servers(obs)) | dict(_routers(obs))
    if not down and obs.messages.empty:
        down = dict(_absent_hosts(obs))
    for host, said in down.items():
        yield Finding("server down", (host,), f"{host}: {'; '.join(said)}")


def _discovery_servers(obs: Observations) -> Iterator[tuple[str, list[str]]]:
    """Yield the servers that clients of Fast DDS call in vain."""
    end = max(obs.end, obs.network_events["time"].max() if len(obs.network_events) else 0.0)
    calls = obs.isin("kind", "SPDP", "SPDP Heartbeat", "SPDP ACKNACK") & ~obs["multicast"]
    calls &= np.isin(obs.sender_index, [*clients(obs)])
    for host in map(str, obs.messages["receiver"][calls].unique()):
        last = obs.host_first_last.get(host, (0.0, -np.inf))[1]
        later = calls & obs.isin("receiver", host) & (obs.time > last)
        count = int(later.sum())
        # A process that is served calls seldom; a call in vain is repeated.
        if count < MESSAGES or end - obs.time[later].min() < WAIT:
            continue
        asking = words.count_noun(obs.messages["sender"][later].nunique(), "host")
        spoke = "it never spoke" if np.isinf(last) else f"it spoke last after {last:.1f} s"
        said = [f"{asking} sent it {count} messages without answer", spoke]
        if refused := int((obs.events("unreachable")["receiver"] == host).sum()):
            said.append(f"{refused} times its host said that no process has the port (ICMP)")
        yield host, said


def _routers(obs: Observations) -> Iterator[tuple[str, list[str]]]:
    """Yield the routers of Zenoh that refuse connections, or do not answer."""
    peers = {*obs.process_host} - {*obs.process_host[obs.is_server]}
    calls = obs.network_events[(obs.network_events["port"] == PORT).to_numpy()]
    for host, mine in calls.groupby("receiver", sort=False, observed=True):
        taken = mine["time"][mine["kind"] == "connection"].max()  # NaN if none was
        failed = mine[mine["kind"].isin(["refused", "unanswered"]) & ~(mine["time"] <= taken)]
        if len(failed) < CALLS or host in peers:
            continue
        how = failed["kind"].astype(str).value_counts()
        told = listed([f"{count} {name}" for name, count in how.items()])
        callers = words.count_noun(failed["sender"].nunique(), "host")
        said = [f"connections to port {PORT} by {callers}: {told}"]
        if np.isfinite(taken):
            said.append(f"the last one was accepted after {taken:.1f} s")
        yield str(host), said


def _absent_hosts(obs: Observations) -> Iterator[tuple[str, list[str]]]:
    """Yield the addresses that hosts ask for by ARP, and no host has."""
    requests = obs.events("ARP request")
    answered = {*obs.events("ARP reply")["sender"], *requests["sender"]}
    for host, mine in requests.groupby("receiver", sort=False, observed=True):
        if len(mine) >= CALLS and host not in answered:
            asking = words.count_noun(mine["sender"].nunique(), "host")
            said = f"{asking} asked {len(mine)} times by ARP for this address, and no answer came"
            yield str(host), [said]
