"""Findings about what is sent: losses, storms, servers that do not answer."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from discostorm import words
from discostorm_capture._bytes import Array
from discostorm_capture.diagnosis.finding import Finding, listed
from discostorm_capture.diagnosis.observations import DATA, Seen
from discostorm_capture.diagnosis.pairs import groups
from discostorm_capture.diagnosis.scopes import PORT, clients

#: From so many on and this share [1], frames that are asked for or sent again tell of loss, from
#: the last share on of heavy loss; of samples fewer are noticed than of segments. The lab's healthy
#: runs had at most 1 sample and 2 segments, those with 5 % of loss less than the heavy shares.
SAMPLES, SEGMENTS = (2, 0.001, 0.016), (3, 0.015, 0.13)
#: So long a sample may wait before it is read [s]; and for so long after the start of a process or
#: host, when it has most to do, so long. Segments do not count that soon: TCP repeats them at once.
READ, START, READ_AT_START = 0.02, 1.5, 0.25
#: A storm lasts if endpoints are told again in more than this share of the last seconds [1], of a
#: capture of at least so long [s].
STILL, LONG = 0.5, 12.0
#: So often who is asked must not answer.
TIMES = 3


def losses(seen: Seen) -> tuple[tuple[int, int], tuple[int, int]]:
    """Return how many frames were lost on their way, and of how many: with samples, with segments.

    A sample is lost if the capture shows it, and whom it was for asks for it later on. What was
    sent before the other side spoke of it is none, nor is what it may not have read yet.
    """
    samples = seen.of("submessage", "DATA", "DATA_FRAG") & (seen.number > 0)
    samples &= (seen.process >= 0) & ~seen.of("kind", "SPDP")
    writer = seen.rows["writer"].to_numpy(np.int64)
    frame = seen.rows["frame"].to_numpy(np.int64)
    answers = seen.of("submessage", "ACKNACK") & (seen.process >= 0) & (seen.peer >= 0)
    asking: dict[tuple[int, int], dict[int, Array]] = {}
    size = len(seen.processes)
    for both, which, rows in groups(answers, seen.peer * size + seen.process, writer):
        asking.setdefault((both // size, which), {})[both % size] = rows
    lost, sent = 0, 0
    for process, which, rows in groups(samples, seen.process, writer):
        for peer, asks in asking.get((process, which), {}).items():
            mine = rows[(seen.peer[rows] < 0) | (seen.peer[rows] == peer)]
            mine = mine[seen.time[mine] > seen.time[asks[0]]]
            sent += len(np.unique(frame[mine]))
            lacks = asks[seen.missing[asks] > 0]
            began = float(seen.life[0][[process, peer]].max())
            if len(lacks) and len(mine):
                lost += len(_lost(seen, mine, lacks, frame, began))
    tcp = seen.of("transport", "TCP") & (seen.time > _begun(seen) + START)
    repeated = int((tcp & seen.of("kind", "TCP retransmission")).sum())
    segments = len(np.unique(frame[tcp & ~seen.of("protocol", "TCP")]))
    return (lost, sent), (repeated, segments + repeated)


def _begun(seen: Seen) -> Array:
    """Return when both ends of each message had begun to speak [s]."""
    found = np.zeros(len(seen.rows))
    for column in ("sender", "receiver"):
        words = seen.rows[column].cat
        first = [seen.host_life.get(str(host), (0.0, 0.0))[0] for host in words.categories]
        found = np.maximum(found, np.array(first or [0.0])[words.codes.to_numpy()])
    return found


def _lost(seen: Seen, sent: Array, lacks: Array, frame: Array, began: float) -> set[int]:
    """Return the frames of samples that are asked for later."""
    order = np.lexsort((seen.time[sent], seen.number[sent]))
    sent = sent[order]
    # By number and time, as one key: of each number the last one before it was asked for.
    span = float(seen.time.max()) + 1.0
    keys = seen.number[sent] * span + seen.time[sent]
    place = np.searchsorted(keys, seen.number[lacks] * span + seen.time[lacks], side="right") - 1
    last = sent[np.maximum(place, 0)]
    same = (place >= 0) & (seen.number[last] == seen.number[lacks])
    wait = np.where(seen.time[lacks] > began + START, READ, READ_AT_START)
    later = same & (seen.time[lacks] - seen.time[last] > wait)
    lost = set(frame[last[later]].tolist())
    # What else an answer asks for is sent again.
    asked = np.sort(seen.time[lacks])
    first, again = sent[:-1], sent[1:]
    before = np.searchsorted(asked, seen.time[again], side="right") - 1
    wait = np.where(seen.time[again] > began + START, READ, READ_AT_START)
    between = asked[np.maximum(before, 0)] - seen.time[first] > wait
    between &= (before >= 0) & (seen.number[first] == seen.number[again])
    return lost | set(frame[first[between]].tolist())


def loss(seen: Seen) -> Iterator[Finding]:
    """Yield that frames are lost, and about how many."""
    samples, segments = losses(seen)
    both = ((samples, SAMPLES), (segments, SEGMENTS))
    told = [lost >= least and lost >= some * all_ for (lost, all_), (least, some, _) in both]
    if not any(told):
        return
    heavy = any(lost >= least and lost > many * all_ for (lost, all_), (least, _, many) in both)
    again, sent = samples[0] + segments[0], samples[1] + segments[1]
    share = f"{again / sent:.1%}" if again / sent < 0.1 else f"{again / sent:.0%}"
    yield Finding(
        "heavy loss" if heavy else "loss",
        (),
        f"{again} of {sent} frames with samples or segments that the capture shows were asked for "
        f"or sent again, so at least {share} were lost",
    )


def storm(seen: Seen) -> Iterator[Finding]:
    """Yield that endpoints are still told and told again when the capture ends."""
    data = np.flatnonzero(seen.of("kind", DATA) & ~seen.rows["ends"].to_numpy(bool))
    if not len(data) or seen.duration < LONG:
        return
    begin, end = float(seen.time[data[0]]), float(seen.time.max())
    if end - begin < LONG:
        return
    last = seen.time[data] > begin + (end - begin) * 2 / 3
    bins = np.unique(seen.time[data][last].astype(np.int64))
    share = len(bins) / max((end - begin) / 3, 1.0)
    if share < STILL:
        return
    first = seen.time[data] <= begin + (end - begin) / 3
    yield Finding(
        "storm",
        (),
        f"{int(last.sum())} messages announced endpoints in the last {(end - begin) / 3:.0f} s, "
        f"and {int(first.sum())} in the first {(end - begin) / 3:.0f} s",
    )


def servers(seen: Seen) -> Iterator[Finding]:
    """Yield servers and routers that do not answer who asks for them."""
    end = float(
        max(seen.time.max(initial=0.0), seen.asides["time"].max() if len(seen.asides) else 0)
    )
    down: dict[str, list[str]] = {}
    _discovery_servers(seen, end, down)
    _routers(seen, down)
    if not down and not len(seen.rows):
        _nobody_there(seen, down)
    for host, said in down.items():
        yield Finding("server down", (host,), f"{host}: {'; '.join(said)}")


def _discovery_servers(seen: Seen, end: float, down: dict[str, list[str]]) -> None:
    """Add the servers that clients of Fast DDS call in vain."""
    served = clients(seen)
    if not served:
        return
    calls = seen.of("kind", "SPDP", "SPDP Heartbeat", "SPDP ACKNACK") & ~seen.multicast
    calls &= np.isin(seen.process, [*served])
    asides = seen.asides
    for host in map(str, seen.rows["receiver"][calls].unique()):
        mine = calls & (seen.rows["receiver"] == host).to_numpy()
        speaks = seen.time[(seen.rows["sender"] == host).to_numpy()]
        last = float(speaks.max(initial=-np.inf))
        later = mine & (seen.time > last)
        asking = seen.rows["sender"][later].nunique()
        # Who is served calls seldom; a call in vain is repeated.
        since = float(seen.time[later].min()) if later.any() else end
        if int(later.sum()) < 5 * TIMES or end - since < 3.0:
            continue
        said = [f"{words.many(asking, 'host')} sent it {int(later.sum())} messages without answer"]
        said.append("it never spoke" if np.isinf(last) else f"it spoke last after {last:.1f} s")
        if count := int(((asides["kind"] == "unreachable") & (asides["receiver"] == host)).sum()):
            said.append(f"{count} times its host said that no process has the port (ICMP)")
        down[host] = said


def _routers(seen: Seen, down: dict[str, list[str]]) -> None:
    """Add the routers of Zenoh that refuse connections, or do not answer."""
    asides = seen.asides
    serving = set(seen.host[seen.processes["server"].to_numpy(bool)])
    peers = set(seen.host) - serving
    asked = asides[(asides["port"] == PORT).to_numpy()]
    for host in map(str, asked["receiver"].unique()):
        mine = asked[(asked["receiver"] == host).to_numpy()]
        kind = mine["kind"].astype(str)
        failed = mine[kind.isin(["refused", "unanswered"])]
        taken = (
            mine["time"][kind == "connection"].max() if (kind == "connection").any() else -np.inf
        )
        failed = failed[failed["time"] > taken]
        if len(failed) < TIMES or host in peers:
            continue
        how = failed["kind"].astype(str).value_counts()
        told = listed([f"{count} {name}" for name, count in how.items()])
        callers = words.many(failed["sender"].nunique(), "host")
        said = [f"connections to port {PORT} by {callers}: {told}"]
        if np.isfinite(taken):
            said.append(f"the last one was accepted after {taken:.1f} s")
        down[host] = said


def _nobody_there(seen: Seen, down: dict[str, list[str]]) -> None:
    """Add addresses that hosts ask for by ARP, and nobody has; nothing else was captured."""
    asides = seen.asides
    requests = asides[(asides["kind"] == "ARP request").to_numpy()]
    replies = set(asides["sender"][(asides["kind"] == "ARP reply").to_numpy()].astype(str))
    spoken = set(requests["sender"].astype(str))
    for host in map(str, requests["receiver"].unique()):
        mine = requests[(requests["receiver"] == host).to_numpy()]
        if len(mine) >= TIMES and host not in replies | spoken:
            asking = words.many(mine["sender"].nunique(), "host")
            down[host] = [
                f"{asking} asked {len(mine)} times by ARP for this address, and no answer came"
            ]
