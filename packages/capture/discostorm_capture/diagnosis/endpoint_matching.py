"""Findings about endpoints of one topic that do not match, and about early service requests."""

from collections import defaultdict
from collections.abc import Iterator
from dataclasses import fields
from fnmatch import fnmatchcase
from itertools import product

import numpy as np
import pandas as pd

from discostorm import wording
from discostorm_capture._types import Array
from discostorm_capture.diagnosis.evidence import Evidence
from discostorm_capture.diagnosis.finding import Finding
from discostorm_capture.diagnosis.observations import ACKNACK, SEDP, Observations
from discostorm_capture.endpoints import RANKED_QOS, TIME_QOS, Endpoint, ros_topic, ros_type
from discostorm_capture.sentences import listing, say

#: How long a service of rmw_fastrtps waits for the reader of its reply [s] (max_blocking_time;
#: ros2/rmw_fastrtps#704).
MAX_BLOCKING_TIME = 0.1
#: Process, entity id and number of the announcement, by service, "rq" or "rr", and if it writes.
ServiceEndpoints = dict[tuple[str, str, bool], list[tuple[int, int, int]]]
#: The policy that separates endpoints on purpose, for example the robots of two teams.
PARTITION_POLICY = "PARTITION_QOS_POLICY"
#: What is done with a service by its server and by its client, by the prefix of its requests.
ROLES = {"rq/": ("offered", "called")}
#: Maximum number of mismatches described in a finding.
MAX_TOPICS = 3


def qos_mismatches(writer: Endpoint, reader: Endpoint) -> dict[str, tuple[str, str]]:
    """Return incompatible policies by ROS 2's name, with the offered and the requested value.

    Rules are those of DDS 1.4, 2.2.3; names are those of ROS 2's QoS events (ros2/rmw,
    rmw/qos_policy_kind.h).
    """
    found = {}
    for policy, order in RANKED_QOS.items():
        offers, asks = (getattr(one, policy.lower()) for one in (writer, reader))
        if order.index(offers) < order.index(asks):
            found[policy] = (offers, asks)
    for policy, field in TIME_QOS.items():
        longest, limit = getattr(writer, field), getattr(reader, field)
        if longest > limit:
            found[policy] = (_format_duration(longest), _format_duration(limit))
    if writer.ownership != reader.ownership:
        found["OWNERSHIP"] = (writer.ownership, reader.ownership)
    if writer.representations[0] not in reader.representations:
        ends = (writer.representations[:1], reader.representations)
        found["DATA_REPRESENTATION"] = (listing(ends[0]), listing(ends[1]))
    if not any(
        fnmatchcase(one, other) or fnmatchcase(other, one)
        for one, other in product(writer.partitions, reader.partitions)
    ):
        found["PARTITION"] = (listing([*writer.partitions]), listing([*reader.partitions]))
    return {f"{policy}_QOS_POLICY": both for policy, both in found.items()}


def mismatched_topics(evidence: Evidence) -> Iterator[Finding]:
    """Yield topics on which a writer and a reader have incompatible QoS, types or transports."""
    found: dict[str, dict[str, set[str]]] = defaultdict(dict)
    for _, group in evidence.endpoints.groupby(["scope", "topic"], sort=False):
        ends, name = _hosts_by_endpoint(group), ros_topic(group["topic"].iloc[0])
        is_rtps = evidence.scopes[group["scope"].iloc[0]].protocol == "RTPS"
        writers, readers = ([one for one in ends if one.writer is way] for way in (True, False))
        for writer, reader in product(writers, readers):
            hosts = {*ends[writer], *ends[reader]}
            at = [listing(ends[w]) for w in (writer, reader)]
            if (writer.type, writer.type_hash) != (reader.type, reader.type_hash):
                if text := _type_difference(writer, reader, *at):
                    found["types differ"].setdefault(f"{name}: {text}", set()).update(hosts)
            elif {writer.transport, reader.transport} == {"UDP", "TCP"}:
                text = say("transports", at[0], writer.transport, at[1], reader.transport)
                found["transports differ"].setdefault(f"{name}: {text}", set()).update(hosts)
            # With Zenoh every writer matches every reader of its topic and type.
            elif is_rtps and (policies := qos_mismatches(writer, reader)):
                # Partitions separate on purpose; they are a fault if a reader has no writer.
                apart = (PARTITION_POLICY in qos_mismatches(one, reader) for one in writers)
                if [*policies] == [PARTITION_POLICY] and not all(apart):
                    continue
                text = "; ".join(
                    say("policy", *at, offered or "none", asked or "none", policy)
                    for policy, (offered, asked) in policies.items()
                )
                found["QoS differs"].setdefault(f"{name}: {text}", set()).update(hosts)
    for kind, texts in found.items():
        more = f" (and {len(texts) - MAX_TOPICS} more)" if len(texts) > MAX_TOPICS else ""
        text = "; ".join([*texts][:MAX_TOPICS]) + more
        yield Finding(kind, tuple(sorted(set().union(*texts.values()))), text)


def topic_name_mismatches(evidence: Evidence) -> Iterator[Finding]:
    """Yield topics with only writers whose readers use the same name in another namespace."""
    if evidence.obs.endpoints["topic"].isna().any() or evidence.incomplete_pairs:
        return  # unknown endpoints may match
    for _, rows in evidence.endpoints.groupby("scope"):
        only = rows.groupby("topic").filter(lambda group: {*group["writer"]} != {True, False})
        only = only[~only["topic"].str.startswith("rr/")]  # a service has its requests, too
        ends = only.drop_duplicates(["topic", "type"])
        for _, both in ends.groupby([ends["topic"].str.split("/").str[-1], "type"]):
            if len(both) == 2 and {*both["writer"]} == {True, False}:
                verbs = ROLES.get(both["topic"].iloc[0][:3], ("read", "written"))
                named = zip(both["topic"].map(ros_topic), both["writer"], both["host"], strict=True)
                text = [f"{topic} is {verbs[writes]} by {host}" for topic, writes, host in named]
                yield Finding("topic names", tuple(both["host"].unique()), f"{listing(text)} only")


def unknown_qos(evidence: Evidence) -> Iterator[Finding]:
    """Yield how many endpoints have unreadable announcements."""
    unreadable = evidence.obs.endpoints["topic"].isna()
    if count := int(unreadable.sum()):
        of = f"the announcements of {count} of {len(unreadable)} endpoints"
        yield Finding("QoS unknown", (), f"{of} are cut or cannot be read")


def _hosts_by_endpoint(group: pd.DataFrame) -> dict[Endpoint, list[str]]:
    """Return the hosts of identical endpoints of a topic, by endpoint."""
    ends: dict[Endpoint, list[str]] = {}
    names = [field.name for field in fields(Endpoint)]
    for host, *values in group[["host", *names]].itertuples(index=False, name=None):
        same = ends.setdefault(Endpoint(*values), [])
        if host not in same:
            same.append(host)
    return ends


def _type_difference(writer: Endpoint, reader: Endpoint, at_writer: str, at_reader: str) -> str:
    """Return how two types differ; "" if a process does not announce its type's hash."""
    own, other = ros_type(writer.type), ros_type(reader.type)
    if writer.type != reader.type:
        return say("types", at_writer, own, at_reader, other)
    hashes = writer.type_hash[:16], reader.type_hash[:16]
    return say("type hashes", at_writer, at_reader, own, *hashes) if all(hashes) else ""


def _format_duration(seconds: float) -> str:
    return "no limit" if seconds == float("inf") else f"{seconds:g} s"


def early_requests(evidence: Evidence) -> Iterator[Finding]:
    """Yield services that never replied because they discovered the reply's reader too late."""
    obs, texts, lost, hosts = evidence.obs, list[str](), 0, dict[str, None]()
    data = obs.isin("kind", "User data")
    sends = {*zip(obs.sender_index[data].tolist(), obs["writer"][data].tolist(), strict=True)}
    ends = _endpoints_by_service(evidence)
    for service in sorted({service for service, *_ in ends}):
        asking, readers, writers = (
            ends.get((service, *role), []) for role in (("rq", True), ("rr", False), ("rr", True))
        )
        for (client, _, number), (server, replies, _) in product(readers, writers):
            # With several clients in a process, it is unknown which one reads which reply.
            asks = [entity for process, entity, _ in asking if process == client]
            names = obs.hosts_of((client, server))
            if len(names) < 2 or len(asks) != 1 or (client, asks[0]) not in sends:
                continue
            announced = _confirmed_announcement_time(obs, client, server, number)
            requests = _first_sample_times(obs, client, server, asks[0])
            early = requests[requests < announced - MAX_BLOCKING_TIME]
            later = requests[len(early) :].min(initial=np.inf)
            times = _first_sample_times(obs, server, client, replies)
            missing = len(early) - int(np.sum((times >= early.min(initial=0)) & (times < later)))
            if missing > 0:
                text = say("early request", service, *names, early[0], announced - early[0])
                texts, lost, hosts = [*texts, text], lost + missing, hosts | dict.fromkeys(names)
    if texts:
        got = wording.count_noun(lost, "request")
        yield Finding("early requests", tuple(hosts), f"{listing(texts)}; {got} got no reply")


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
    times = obs.time[sent & _messages_between(obs, process, to) & ~obs["ends"]]
    acks = obs.isin("kind", ACKNACK) & obs.isin("entity", "subscriptions") & (obs.seq > number)
    confirmed = obs.time[acks & _messages_between(obs, to, process)].min(initial=np.inf)
    return float(times[times <= confirmed].max(initial=0.0))


def _first_sample_times(obs: Observations, process: int, to: int, writer: int) -> Array:
    """Return when a process first sent each sample of a user writer to another one [s]."""
    data = obs.isin("submessage", "DATA", "DATA_FRAG") & (obs["writer"] == writer)
    rows = np.flatnonzero(data & _messages_between(obs, process, to))
    _, first = np.unique(obs.seq[rows], return_index=True)
    return np.asarray(obs.time[rows[first]])


def _messages_between(obs: Observations, process: int, to: int) -> Array:
    """Return which messages a process sent to another one, or by multicast."""
    there: Array = np.isin(obs.receiver_index, (to, -1)) & (obs.sender_index == process)
    there &= obs.isin("receiver", obs.process_host[to]) | obs["multicast"]
    return there
