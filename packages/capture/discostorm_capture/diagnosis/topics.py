"""Findings about topics: shared by robots, unknown to tools, endpoints that do not match."""

import re
from collections import defaultdict
from collections.abc import Iterator
from dataclasses import fields
from fnmatch import fnmatchcase
from itertools import combinations, product
from typing import Any

import numpy as np

from discostorm.data import read_data
from discostorm_capture.diagnosis.evidence import Evidence
from discostorm_capture.diagnosis.finding import LIMITS, Finding
from discostorm_capture.diagnosis.observations import SAMPLE_KINDS, SEDP
from discostorm_capture.diagnosis.pairs import server_clients
from discostorm_capture.endpoints import RANKED_QOS, TIME_QOS, Endpoint, ros_topic, ros_type
from discostorm_capture.sentences import join_names, say

#: Topics that each node of ROS 2 writes, and the topic on which processes list their nodes.
NODE_TOPICS, GRAPH_TOPIC = ("rt/rosout", "rt/parameter_events"), "ros_discovery_info"
#: Topics that different processes of one host write.
SHARED_TOPICS = (GRAPH_TOPIC, *(f"/{name}" for name in ("rosout", "parameter_events", "tf")))
SHARED_TOPICS += ("/tf_static", "/diagnostics")
#: Whether topics of a type are "published" or "read" on a robot, or published by a "single" host.
_TOPIC_TYPES = read_data("diagnosis/robot_types.csv", "discostorm_capture")
#: The finding if several hosts write a topic, by its use.
FINDINGS_BY_USE = {"read": "several commanders", "single": "several clocks", "map": "several maps"}
VERBS = {"published": "publish", "read": "subscribe to"}
USE_ON_ROBOTS = {row["type"]: row["robot"] for row in _TOPIC_TYPES}
#: The policy that separates endpoints on purpose, for example the robots of two teams.
PARTITION_POLICY = "PARTITION_QOS_POLICY"
#: The type hash in the keys of rmw_zenoh in Humble, which has none (rmw_zenoh_cpp of Humble).
NO_HASH = "TypeHashNotSupported"
#: Maximum number of mismatches described in a finding.
MAX_TOPICS = 3


def robots_with_same_topics(evidence: Evidence) -> Iterator[Finding]:
    """Yield robots that write their sensors, or read their commands, under the same names."""
    of_all, expected = evidence.endpoints, evidence.obs.expected_hosts
    ends = of_all.assign(use=of_all["type"].map(ros_type).map(USE_ON_ROBOTS))
    pairs = zip(ends["topic"], ends["use"].map(VERBS), strict=True)
    ends["what"] = [f"{verb} {ros_topic(topic)}" for topic, verb in pairs]
    wrote = ends[ends["writer"].eq(other=True)].groupby(["use", "scope", "topic"])
    ends = ends[ends["use"].eq("published") == ends["writer"].astype(bool)]
    ends = ends[ends["use"].isin(["published", "read"])]
    ends = ends[ends["host"].isin(ends["host"][ends["use"].eq("published")])]
    for scope, of_scope in ends.groupby("scope"):
        hosts = of_scope.groupby("what", sort=False)["host"].unique()
        shared = hosts[hosts.map(len) > 1]
        if len(shared) >= LIMITS.min_shared_topics:
            text = join_names([f"{join_names(by)} {what}" for what, by in shared.items()], "; ")
            kind = "robots share topics" if VERBS["read"] in text else "sources share topics"
            present = {*of_all["host"][of_all["scope"].eq(scope)]} - evidence.obs.server_hosts
            if isinstance(expected, int) and len(present) > expected:
                kind, text = "too many hosts", say("too many hosts", len(present), expected, text)
            yield Finding(kind, tuple(sorted({*np.hstack([*shared])})), text)
    for (use, _, topic), rows in wrote:
        begins, ends_at = (times[rows["index"]] for times in evidence.obs.first_last)
        at_once = begins.max() < ends_at.min() and rows["ownership"].ne("exclusive").any()
        if use in FINDINGS_BY_USE and len(by := rows["host"].unique()) > 1 and at_once:
            text = f"{join_names(by)} publish {ros_topic(str(topic))}"
            yield Finding(FINDINGS_BY_USE[use], tuple(by), text)


def duplicate_launch(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts on which two processes have the same endpoints at one time, unlike others."""
    obs, own = evidence.obs, evidence.endpoints
    own = own[~own["topic"].map(ros_topic).isin(SHARED_TOPICS)]
    alike: dict[tuple[Any, ...], list[int]] = {}
    for process, rows in own.groupby("index"):
        ends = frozenset(zip(rows["topic"], rows["writer"], strict=True))
        if len(ends) > LIMITS.min_shared_topics and any(writer for _, writer in ends):
            key = *rows[["host", "scope"]].iloc[0], ends
            alike.setdefault(key, []).append(int(str(process)))
    found = dict[str, Finding]()
    for (host, _, ends), processes in alike.items():
        begins, ends_at = (times[processes] for times in obs.first_last)
        if len(processes) > 1 and begins.max() < ends_at.min():
            names = sorted({ros_topic(topic) for topic, writer in ends if writer})
            found[host] = Finding.of("runs twice", (host,), len(ends), names)
    if 2 * len(found) <= own["host"].nunique():  # on most hosts, it is meant
        yield from found.values()


def different_distributions(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts where a process of ROS 2 announces no type hashes, as others do."""
    for _, ends in evidence.endpoints.groupby("scope"):
        ends = ends[ends["index"].isin(ends["index"][ends["topic"].eq(GRAPH_TOPIC)])]
        newer = ends[ends["type_hash"] != ""]
        older = ends[~ends["index"].isin(newer["index"]) & ends["topic"].str.startswith("rt/")]
        if len(newer) and len(older):
            hosts = (rows["host"].unique() for rows in (older, newer))
            yield Finding.of("different distributions", *hosts)


def uninformed_clients(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts whose clients get no endpoints from a server or router that serves others."""
    obs = evidence.obs
    sent = obs.isin("kind", SEDP) | obs.isin("submessage", "DeclareSubscriber", "Push")
    told = {*obs.receiver_index[sent & np.isin(obs.sender_index, [*obs.servers])].tolist()} - {-1}
    pairs = [pair for pair in evidence.expected_pairs if np.isfinite(pair.complete_at)]
    known = {of.subject for of in pairs if of.n_announced and of.observer in obs.servers}
    known = {one for one in known if np.ptp(obs.first_last, axis=0)[one] >= LIMITS.timeout}
    idle = known - told - evidence.early_processes
    # Skip nodes with topics of their own, which may match none; tools have only every node's.
    ends = evidence.endpoints[~evidence.endpoints["topic"].isin([*NODE_TOPICS, GRAPH_TOPIC])]
    uses, at = {*ends["host"]}, obs.vantage_host
    if not uses:  # all that the server told this host, which recorded it
        tools = [one for one in sorted(known & server_clients(obs)) if obs.process_host[one] == at]
        yield from (Finding.of("tool is client", obs.hosts_of([one])) for one in tools[:1])
    for host, own in obs.processes_by_host(sorted(idle)).items() if told else ():
        if host not in uses.union(obs.hosts_of(told)):
            others = [one for one in obs.hosts_of(sorted(told)) if one in uses]
            kind = "different keys" if others else "router tells nothing"
            kind = "told nothing" if obs.is_rtps[own[0]] else kind
            yield Finding.of(kind, (host,), others or obs.hosts_of(sorted(told)))


def short_lived_processes(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts with a process that left before it met its readers, or any other process."""
    obs, ends, texts = evidence.obs, evidence.endpoints, dict[str, str]()
    wrote = obs.senders(obs.isin("kind", *SAMPLE_KINDS))
    met = obs.senders((obs.receiver_index >= 0) & ~obs["multicast"])
    for process in sorted(evidence.brief_processes - wrote):
        host, (first, last) = obs.process_host[process], np.transpose(obs.first_last)[process]
        own = ends["index"].eq(process) & ends["writer"].eq(other=True)
        topics = {*ends["topic"][own & ends["topic"].str.startswith("rt/")]} - {*NODE_TOPICS}
        read = ends[ends["topic"].isin(topics) & ends["writer"].eq(other=False)]
        readers = sorted({*read["host"]} - {host})
        earlier = (obs.first_last[0] < first) & (obs.process_host != host)
        if readers or (process not in met and earlier.any()):
            what = f"sent a sample to {join_names(readers)}" if readers else "found any peers"
            texts.setdefault(host, say("left early", host, last - first, what))
    if texts:
        yield Finding("left early", tuple(texts), "; ".join(texts.values()))


def stopped_topics(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts with a writer that sent samples regularly and stopped, but was not deleted."""
    obs, ends = evidence.obs, evidence.endpoints
    commands = ends["type"].map(ros_type).map(USE_ON_ROBOTS).eq("read")  # these end on purpose
    ends = ends[ends["writer"].eq(other=True) & ~commands]
    named = ends[~ends["topic"].isin(NODE_TOPICS)].set_index(["index", "entity"])["topic"]
    named = named[named.astype(str).str.match("rt/|/").to_numpy(bool)]
    reads = evidence.endpoints[evidence.endpoints["writer"].eq(other=False)]
    readers = reads.groupby("topic")["host"].unique()
    withdrawn = obs["ends"] | obs.isin("submessage", "UndeclareSubscriber", "UndeclareToken")
    goodbyes, last = obs.time[withdrawn], np.full(len(obs.processes) + 1, -np.inf)
    spoken = ~obs.isin("protocol", "TCP")  # a system acknowledges also for a process that hangs
    np.maximum.at(last, obs.sender_index[spoken], obs.time[spoken])
    sends = obs.isin("kind", *SAMPLE_KINDS) & (obs.sender_index >= 0)
    for key, rows in obs.rows_by(sends, obs.sender_index, obs["writer"]).items():
        _, first = np.unique(obs.seq[rows], return_index=True)
        times = np.sort(obs.time[rows[first]])
        gaps = np.diff(times)
        if len(times) < LIMITS.min_steady_messages or key not in named.index:
            continue
        steady = (gaps < LIMITS.max_gap_ratio * np.median(gaps)).mean() >= LIMITS.min_steady_share
        # The readers, or their processes, may have left, too.
        host, pause = str(obs.process_host[key[0]]), gaps.max() + LIMITS.max_transit
        to = obs.messages["receiver"].iloc[rows].unique()
        there = np.isin(obs.process_host, [host, *to, *readers.get(named[[key]].iloc[0], ())])
        ended = (np.abs(goodbyes - times[-1]) < pause).any() or (
            evidence.endings[there] != ""
        ).any()
        silence = last[:-1][there & np.isfinite(last[:-1])].min() - times[-1]
        enough = max(LIMITS.steady_silence, LIMITS.min_pause_ratio * gaps.max())
        # If no topic goes on, the whole fleet stopped, as on purpose.
        others = obs.time[sends].max() > times[-1] + pause
        if steady and not ended and silence > enough and others:
            values = len(times), ros_topic(str(named[[key]].iloc[0])), times[0], times[-1], silence
            yield Finding.of("topic stops", (host,), *values)


def missing_publishers(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts that alone do not publish a topic of a sensor, as the other robots do."""
    obs, ends, sends = evidence.obs, evidence.endpoints, evidence.obs.isin("kind", *SAMPLE_KINDS)
    sent = obs.rows_by(sends, obs.sender_index, obs["writer"])
    ends = ends[ends["type"].map(ros_type).map(USE_ON_ROBOTS).eq("published")]
    keys = zip(ends["index"], ends["entity"], strict=True)
    # Where a session of Zenoh is older than the capture, samples do not show their topic.
    sends = np.array([key in sent or (key[0], 0) in sent for key in keys], bool)
    used = ends["writer"].astype(bool) & sends
    alike = ends["topic"].astype(str).str.replace(r"\d+", "#", regex=True)
    for _, group in ends.groupby([ends["scope"], alike]):
        published = sorted({*group["topic"][used]})
        for topic in sorted({*group["topic"]} - {*published}) if len(published) > 1 else ():
            rows, robot = group[group["topic"].eq(topic)], re.match(r"\D*\d+/", topic)
            own = used & ends["topic"].str.startswith(robot[0] if robot else "-")
            own &= ends["topic"].str.partition(" ")[2].eq(topic.partition(" ")[2])  # its domain
            hosts = ends["host"][own].unique()
            readers = rows["host"][rows["writer"].eq(other=False)].unique()
            lasts = obs.first_last[0][rows["index"]].max() < obs.end - LIMITS.timeout
            known = not evidence.incomplete_pairs and obs.sees_unicast(*hosts, *readers)
            if known and lasts and len(hosts) == 1 and len(readers):
                key = "silent publisher" if rows["writer"].any() else "no publisher"
                text = say(key, ros_topic(topic), readers, [*map(ros_topic, published)])
                yield Finding("no publisher", tuple(hosts), text)


def missed_samples(evidence: Evidence) -> Iterator[Finding]:
    """Yield readers that started after the last sample of a writer, and get none that it keeps."""
    obs, begins = evidence.obs, evidence.obs.first_last[0]
    texts: dict[tuple[str, str], dict[str, None]] = {}
    ends = evidence.endpoints[obs.is_rtps[evidence.endpoints["index"]]]
    volatile, writes = ends["durability"].eq("volatile"), ends["writer"].eq(other=True)
    kept, late = ends[writes & ~volatile], ends.assign(volatile=volatile)[~writes]
    pairs = kept.merge(late, on=["scope", "topic", "type"], suffixes=("", "_by"))
    names = ["topic", "index", "entity", "host", "index_by", "host_by", "volatile", "lifespan"]
    for topic, process, writer, host, reader, by, takes_no_old, lifespan in pairs[names].to_numpy():
        begin = begins[reader]
        if host == by or begin >= obs.end - LIMITS.timeout:
            continue
        last = obs.first_sample_times(process, writer).max(initial=-np.inf)
        kind, at = ("missed samples", by) if takes_no_old else ("expired samples", host)
        if last < begin and (
            last > -np.inf if takes_no_old else begins[process] + lifespan < begin
        ):
            text = say(kind, ros_topic(topic), host, last, by, begin, lifespan)
            texts.setdefault((kind, at), {})[text] = None
    for (kind, at), said in texts.items():
        yield Finding(kind, (at,), "; ".join(said))


def log_flood(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts with a process that logs very often."""
    obs, logs = evidence.obs, evidence.endpoints
    logs = logs[logs["topic"].isin(["rt/rosout", "/rosout"]) & logs["writer"].eq(other=True)]
    for process, writer, host in logs[["index", "entity", "host"]].itertuples(index=False):
        times = np.sort(obs.first_sample_times(process, writer))
        seconds = np.unique(times.astype(np.int64), return_counts=True)[1]
        if (seconds >= LIMITS.log_rate).sum() >= LIMITS.min_stream_seconds:
            yield Finding.of("log flood", (host,), seconds.max())


def missing_clock(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts that read simulation time, which no host publishes."""
    clocks = evidence.endpoints[evidence.endpoints["topic"].eq("rt/clock")]
    if len(clocks) and not clocks["writer"].any() and not evidence.incomplete_pairs:
        yield Finding.of("no clock", tuple(clocks["host"].unique()))


def looping_bridges(evidence: Evidence) -> Iterator[Finding]:
    """Yield pairs of hosts that repeat in DDS what comes by Zenoh, and hear each other's DDS."""
    obs, ends = evidence.obs, evidence.endpoints
    both = ends.groupby(["index", "topic"])["writer"].agg("nunique") > 1
    data, pushed = obs.isin("kind", "User data") & ~obs["multicast"], obs.isin("kind", "Push")
    counts = dict[str, tuple[int, int]]()
    for host, own in obs.processes_by_host(both[both].index.unique("index")).items():
        sent = data & np.isin(obs.sender_index, own)
        repeated = len(obs.rows_by(sent, obs.sender_index, obs["writer"], obs.seq))
        came = int((pushed & obs.isin("receiver", host)).sum())
        few, many = sorted((came, repeated))
        if few >= LIMITS.min_repeated and many <= LIMITS.max_repeat_ratio * few:
            counts[host] = came, repeated
    links = obs.links_of(obs.messages[data])
    for pair in combinations(counts, 2):
        if {pair, pair[::-1]} <= links:
            text = join_names([say("bridged", of, *counts[of]) for of in pair], "; ")
            text += "; they also sent these samples to each other"
            yield Finding("bridges in a loop", pair, text)


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
        found["DATA_REPRESENTATION"] = writer.representations[0], join_names(reader.representations)
    pairs = product(writer.partitions, reader.partitions)
    if not any(fnmatchcase(*pair) or fnmatchcase(*pair[::-1]) for pair in pairs):
        found["PARTITION"] = (join_names([*writer.partitions]), join_names([*reader.partitions]))
    return {f"{policy}_QOS_POLICY": both for policy, both in found.items()}


def mismatched_topics(evidence: Evidence) -> Iterator[Finding]:
    """Yield topics on which a writer and a reader have incompatible QoS, types or transports."""
    found: dict[str, dict[str, set[str]]] = defaultdict(dict)
    columns = ["host", *(field.name for field in fields(Endpoint))]
    for _, group in evidence.endpoints.groupby(["scope", "topic"], sort=False):
        ends: dict[Endpoint, dict[str, None]] = defaultdict(dict)  # hosts in order, by endpoint
        for host, *values in group[columns].itertuples(index=False, name=None):
            ends[Endpoint(*values)][host] = None
        name = ros_topic(group["topic"].iloc[0])
        is_rtps = evidence.scopes[group["scope"].iloc[0]].protocol == "RTPS"
        writers, readers = ([one for one in ends if one.writer is way] for way in (True, False))
        for writer, reader in product(writers, readers):
            at, kind, text = [join_names([*ends[of]]) for of in (writer, reader)], "QoS differs", ""
            if (writer.type, writer.type_hash) != (reader.type, reader.type_hash):
                types = [ros_type(one.type) for one in (writer, reader)]
                hashes = writer.type_hash[:16], reader.type_hash[:16]
                # DDS matches types by name.
                kind = "definitions differ" if is_rtps else "hashes differ"
                if NO_HASH in (writer.type_hash, reader.type_hash):
                    kind = "no hashes"
                if writer.type != reader.type:
                    kind, text = "types differ", say("types", at[0], types[0], at[1], types[1])
                elif all(hashes):  # a process need not announce its type's hash
                    text = say("type hashes", *at, types[0], *hashes)
            elif {writer.transport, reader.transport} == {"UDP", "TCP"}:
                kind = "transports differ"
                text = say("transports", at[0], writer.transport, at[1], reader.transport)
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
            if text:
                hosts = found[kind].setdefault(f"{name}: {text}", set())
                older = [one for one in (writer, reader) if one.type_hash == NO_HASH]
                hosts.update(*(ends[one] for one in (older or (writer, reader))))
    for kind, texts in found.items():
        more = f"; and {len(texts) - MAX_TOPICS} more" if len(texts) > MAX_TOPICS else ""
        text = "; ".join([*texts][:MAX_TOPICS]) + more
        hosts = set[str]().union(*texts.values())
        behind = sorted(hosts & evidence.obs.server_hosts)
        if behind and kind in ("types differ", "hashes differ", "no hashes"):
            text += say("behind router", behind)
        if kind in ("transports differ", "no hashes"):  # of one host, on all these topics
            hosts = hosts.intersection(*texts.values()) or hosts
        if kind == "no hashes" and hosts <= evidence.obs.server_hosts:
            kind = "no hashes behind"
        yield Finding(kind, tuple(sorted(hosts)), text)


def topic_name_mismatches(evidence: Evidence) -> Iterator[Finding]:
    """Yield topics with only writers whose readers use the same name in another namespace."""
    if evidence.obs.endpoints["topic"].isna().any() or evidence.incomplete_pairs:
        return  # unknown endpoints may match
    for _, rows in evidence.endpoints.groupby("scope"):
        only = rows.groupby("topic").filter(lambda group: {*group["writer"]} != {True, False})
        only = only[~only["topic"].str.startswith("rr/")]  # the requests stand for the service
        ends = only.drop_duplicates(["topic", "type"])
        for _, both in ends.groupby([ends["topic"].str.split("/").str[-1], "type"]):
            # A program without a namespace may be meant for several robots that have one.
            rows_of = [both[both["writer"].eq(way)] for way in (True, False)]
            plain = any(len(of) == 1 and of["topic"].iloc[0].count("/") == 1 for of in rows_of)
            if min(map(len, rows_of)) and (len(both) == 2 or plain):
                is_service = both["topic"].iloc[0].startswith("rq/")
                sides = ("server", "client") if is_service else ("subscriber", "publisher")
                named = zip(both["topic"].map(ros_topic), both["writer"], both["host"], strict=True)
                text = [f"{of} has only a {sides[use]} (on {host})" for of, use, host in named]
                yield Finding("topic names", (*both["host"].unique(),), join_names(text, "; "))


def native_names(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts whose DDS topics lack the prefix of ROS 2 that topics of the same name have."""
    ends = evidence.endpoints[evidence.obs.is_rtps[evidence.endpoints["index"]]]
    others: dict[tuple[Any, ...], set[str]] = defaultdict(set)
    for scope, topic, writer, host in ends[["scope", "topic", "writer", "host"]].to_numpy(object):
        others[scope, topic, writer].add(host)
    found: dict[str, dict[str, set[str]]] = defaultdict(dict)
    for (scope, topic, writer), hosts in others.items():
        for host in hosts if (scope, f"rt/{topic}", not writer) in others else ():
            found[host][topic] = others[scope, f"rt/{topic}", not writer]
    for host, names in found.items():
        yield Finding.of("native names", (host,), [*names], sorted(set().union(*names.values())))


def silent_routers(evidence: Evidence) -> Iterator[Finding]:
    """Yield Zenoh routers that tell nothing: other routers, or clients that share topics."""
    obs, ends = evidence.obs, evidence.endpoints[~evidence.obs.is_rtps[evidence.endpoints["index"]]]
    wrote = {*ends["topic"][ends["writer"].eq(other=True)]}
    reads = ends[ends["writer"].eq(other=False) & ~ends["topic"].isin(wrote)]
    reads = reads[reads["type"].map(ros_type).map(USE_ON_ROBOTS).eq("published")]
    declares = obs.isin("kind", "Declare") | obs.isin("submessage", "Push")
    told, heard = (
        {*np.unique(of[declares]).tolist()} for of in (obs.sender_index, obs.receiver_index)
    )
    routers = [one for one in sorted(obs.servers & heard - told) if not obs.is_rtps[one]]
    lasts = [one for one in routers if obs.end - obs.first_last[0][one] >= LIMITS.timeout]
    clients = ends[obs.processes["product"].eq("Zenoh client").to_numpy()[ends["index"]]]
    pairs = clients.groupby("topic")[["host", "writer"]].nunique().gt(1).all(axis=1)
    if pairs.any() and not obs.servers & told:
        names = [*map(ros_topic, pairs.index[pairs])]
        for host in obs.hosts_of(lasts):
            yield Finding.of("router forwards nothing", (host,), names)
    if len(reads) and len(obs.servers & told) > 1:
        names = sorted({*reads["topic"].map(ros_topic)})
        for host in obs.hosts_of(lasts):
            yield Finding.of("silent router", (host,), names, reads["host"].unique())


def unknown_qos(evidence: Evidence) -> Iterator[Finding]:
    """Yield how many endpoints have unreadable announcements."""
    unreadable = evidence.obs.endpoints["topic"].isna()
    if count := int(unreadable.sum()):
        yield Finding.of("QoS unknown", (), count, len(unreadable))


def _format_duration(seconds: float) -> str:
    return "no limit" if seconds == float("inf") else f"{seconds:g} s"
