"""Findings about services: two servers of one, and requests without a reply."""

from collections.abc import Iterator
from itertools import product

import numpy as np

from discostorm import wording
from discostorm_capture.diagnosis import topics
from discostorm_capture.diagnosis.evidence import Evidence
from discostorm_capture.diagnosis.finding import LIMITS, Finding
from discostorm_capture.diagnosis.observations import ACKNACK, SEDP, Observations
from discostorm_capture.endpoints import ros_topic
from discostorm_capture.sentences import join_names, say

#: Process, entity id and number of the announcement, by service, "rq" or "rr", and if it writes.
ServiceEndpoints = dict[tuple[str, str, bool], list[tuple[int, int, int]]]


def service_problems(evidence: Evidence) -> Iterator[Finding]:
    """Yield services with several servers, or whose client runs another DDS than the server."""
    obs, ends = evidence.obs, evidence.endpoints
    ends = ends[ends["topic"].astype(str).str.startswith("rq/")]
    complete = not obs.endpoints["topic"].isna().any() and not evidence.incomplete_pairs
    missing: dict[tuple[str, ...], list[str]] = {}
    product = obs.processes["product"].to_numpy(object)[ends["index"]]
    for (_, topic), rows in ends.assign(product=product).groupby(["scope", "topic"]):
        client, name = rows["writer"].eq(other=True), ros_topic(str(topic))
        hosts, callers = (rows["host"][role].unique() for role in (~client, client))
        if len(hosts) > 1 and len(callers):
            yield Finding.of("several servers", hosts, name)
        if not len(hosts) and complete:
            missing.setdefault(tuple(callers), []).append(name)
        known = rows["product"].isin(["Fast DDS", "Cyclone DDS"])
        foreign = rows[client & known & ~rows["product"].isin(rows["product"][~client])]
        if len(foreign) and known[~client].any():
            own, its = (rows["product"][one].unique() for one in (~client, foreign.index))
            callers = foreign["host"].unique()
            yield Finding.of("services differ", (*hosts, *callers), name, hosts, own, callers, its)
    renamed = " ".join(one.evidence for one in topics.topic_name_mismatches(evidence))
    for waiting, names in missing.items():
        if unknown := [name for name in names if f"{name} " not in renamed]:
            calls = obs.isin("kind", "Request") & obs.isin("sender", *waiting)  # of Zenoh
            kind = "no server" if calls.any() else "waits for server"
            yield Finding(kind, waiting, say("no server", waiting, unknown))


def silent_services(evidence: Evidence) -> Iterator[Finding]:
    """Yield servers of DDS that get requests again and again, but never reply, or only late."""
    obs, texts = evidence.obs, dict[str, list[str]]()
    ends = _endpoints_by_service(evidence)
    for service in sorted({service for service, *_ in ends}):
        asking, serving, replying = (
            ends.get((service, *role), []) for role in (("rq", True), ("rq", False), ("rr", True))
        )
        replies, asks = (
            [t for one, entity, _ in of for t in obs.first_sample_times(one, entity).tolist()]
            for of in (replying, asking)
        )
        lasts = len(asks) >= LIMITS.min_calls and np.ptp(asks) >= LIMITS.timeout
        pairs = zip(sorted(asks), sorted(replies), strict=False)
        delay = float(np.median([reply - asked for asked, reply in pairs] or [0.0]))
        # The result of an action is asked for in advance.
        slow = lasts and delay >= LIMITS.min_hang and not service.endswith("get_result")
        for host in obs.hosts_of(one for one, *_ in serving) if slow else ():
            yield Finding.of("slow service", (host,), service, delay, len(replies), len(asks))
        for host in obs.hosts_of(one for one, *_ in serving) if lasts and not replies else ():
            by = obs.hosts_of(one for one, *_ in asking)
            texts.setdefault(host, []).append(say("no reply", service, by, len(asks), host))
    for host, said in texts.items():
        yield Finding("no reply", (host,), "; ".join(said))


def silent_zenoh_services(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts whose Zenoh process replies to no request, or by errors."""
    obs = evidence.obs
    zenoh = evidence.endpoints[~obs.is_rtps[evidence.endpoints["index"]]]
    asked = zenoh["topic"].astype(str).str.startswith("rq/")
    served = zenoh[asked & ~zenoh["writer"].astype(bool)]
    for _, rows in served.groupby("index"):
        process, host = rows["index"].iloc[0], str(rows["host"].iloc[0])
        times = obs.time[obs.isin("submessage", "Request") & (obs.receiver_index == process)]
        good, bad = (
            int((obs.isin("submessage", way) & (obs.sender_index == process)).sum())
            for way in ("Response", "ResponseErr")
        )
        lasts = len(times) >= LIMITS.min_calls and np.ptp(times) >= LIMITS.timeout
        if lasts and (not good or bad >= LIMITS.min_calls):
            names = sorted({*rows["topic"].map(ros_topic)})
            yield Finding.of("no Zenoh reply", (host,), len(times), names, good, bad)


def early_requests(evidence: Evidence) -> Iterator[Finding]:
    """Yield services that never replied because they discovered the reply's reader too late."""
    obs, texts, lost, hosts = evidence.obs, list[str](), 0, dict[str, None]()
    data = obs.isin("kind", "User data")
    sends = obs.rows_by(data, obs.sender_index, obs["writer"])
    ends = _endpoints_by_service(evidence)
    for service in sorted({service for service, *_ in ends}):
        asking, readers, writers = (
            ends.get((service, *role), []) for role in (("rq", True), ("rr", False), ("rr", True))
        )
        for (client, _, number), (server, replies, _) in product(readers, writers):
            # Skip processes with several clients: it is unknown which one reads which reply.
            asks = [entity for process, entity, _ in asking if process == client]
            names = obs.hosts_of((client, server))
            if len(names) < 2 or len(asks) != 1 or (client, asks[0]) not in sends:
                continue
            announced = _confirmed_announcement_time(obs, client, server, number)
            requests = obs.first_sample_times(client, asks[0], server)
            early = requests[requests < announced - LIMITS.max_blocking_time]
            later = requests[len(early) :].min(initial=np.inf)
            times = obs.first_sample_times(server, replies, client)
            missing = len(early) - int(np.sum((times >= early.min(initial=0)) & (times < later)))
            if missing > 0:
                text = say("early request", service, *names, early[0], announced - early[0])
                texts, lost, hosts = [*texts, text], lost + missing, hosts | dict.fromkeys(names)
    if texts:
        text = f"{join_names(texts, '; ')}; {wording.count_noun(lost, 'request')} got no reply"
        yield Finding("early requests", tuple(hosts), text)


def _endpoints_by_service(evidence: Evidence) -> ServiceEndpoints:
    """Return the endpoints of services: clients write requests ("rq") and read replies ("rr")."""
    names = ("index", "entity", "number", "topic", "writer")
    columns = (evidence.endpoints[name].tolist() for name in names)
    found: dict[tuple[str, str, bool], list[tuple[int, int, int]]] = {}
    for process, entity, number, topic, writer in zip(*columns, strict=True):
        prefix, _, name = topic.partition("/")
        if prefix in ("rq", "rr"):
            name = name.removesuffix("Request").removesuffix("Reply")
            found.setdefault((name, prefix, writer), []).append((process, entity, number))
    return found


def _confirmed_announcement_time(obs: Observations, process: int, to: int, number: int) -> float:
    """Return when a reader was announced to a process that confirmed it [s]; 0 if never."""
    sent = obs.isin("kind", SEDP) & obs.isin("entity", "subscriptions") & (obs.seq == number)
    times = obs.time[sent & obs.messages_between(process, to) & ~obs["ends"]]
    acks = obs.isin("kind", ACKNACK) & obs.isin("entity", "subscriptions") & (obs.seq > number)
    confirmed = obs.time[acks & obs.messages_between(to, process)].min(initial=np.inf)
    return float(times[times <= confirmed].max(initial=0.0))
