"""Findings about the use of topics: shared by robots, unknown to tools, written in vain."""

from collections.abc import Iterator
from itertools import combinations

import numpy as np

from discostorm.data import read_data
from discostorm_capture.diagnosis.evidence import Evidence
from discostorm_capture.diagnosis.finding import LIMITS, Finding
from discostorm_capture.diagnosis.observations import SEDP
from discostorm_capture.endpoints import ros_topic, ros_type
from discostorm_capture.sentences import listing, say

#: Topics that each node of ROS 2 writes, and the topic on which processes list their nodes.
NODE_TOPICS, GRAPH_TOPIC = ("rt/rosout", "rt/parameter_events"), "ros_discovery_info"
#: Whether topics of a type are "written" or "read" on a robot, or written by a "single" host.
_TYPES = read_data("diagnosis/robot_types.csv", "discostorm_capture")
#: The finding if several hosts write a topic, by its use.
WRITTEN_ONCE = {"read": "several commanders", "single": "several clocks"}
USE_ON_ROBOTS = {row["type"]: row["robot"] for row in _TYPES}


def robots_with_same_topics(evidence: Evidence) -> Iterator[Finding]:
    """Yield robots that write their sensors, or read their commands, under the same names."""
    ends = evidence.endpoints
    ends = ends.assign(use=ends["type"].map(ros_type).map(USE_ON_ROBOTS))
    pairs = zip(ends["topic"], ends["use"], strict=True)
    ends["what"] = [f"{ros_topic(topic)} is {use} by " for topic, use in pairs]
    wrote = ends[ends["writer"].eq(other=True)].groupby(["use", "scope", "topic"])
    ends = ends[ends["use"].eq("written") == ends["writer"].astype(bool)]
    ends = ends[ends["use"].isin(["written", "read"])]
    ends = ends[ends["host"].isin(ends["host"][ends["use"].eq("written")])]
    for _, of_scope in ends.groupby("scope"):
        hosts = of_scope.groupby("what", sort=False)["host"].unique()
        shared = hosts[hosts.map(len) > 1]
        if len(shared) >= LIMITS.min_shared_topics:
            text = listing([f"{what}{listing(by)}" for what, by in shared.items()])
            kind = "robots share topics" if " is read by " in text else "sources share topics"
            yield Finding(kind, tuple(sorted({*np.hstack([*shared])})), text)
    for (use, _, topic), rows in wrote:
        if use in WRITTEN_ONCE and len(by := rows["host"].unique()) > 1:
            text = f"{ros_topic(str(topic))} is written by {listing(by)}"
            yield Finding(WRITTEN_ONCE[use], tuple(by), text)


def services(evidence: Evidence) -> Iterator[Finding]:
    """Yield services with several servers, or whose client runs another DDS than the server."""
    ends = evidence.endpoints[evidence.endpoints["topic"].astype(str).str.startswith("rq/")]
    product = evidence.obs.processes["product"].to_numpy(object)[ends["index"]]
    for (_, topic), rows in ends.assign(product=product).groupby(["scope", "topic"]):
        client, name = rows["writer"].eq(other=True), ros_topic(str(topic))
        hosts, callers = (rows["host"][role].unique() for role in (~client, client))
        if len(hosts) > 1 and len(callers):
            yield Finding("several servers", tuple(hosts), say("several servers", name, hosts))
        known = rows["product"].isin(["Fast DDS", "Cyclone DDS"])
        foreign = rows[client & known & ~rows["product"].isin(rows["product"][~client])]
        if len(foreign) and known[~client].any():
            own, other = (rows["product"][one].unique() for one in (~client, foreign.index))
            text = say("other service", name, hosts, own, foreign["host"].unique(), other)
            yield Finding("services differ", (*hosts, *foreign["host"].unique()), text)


def older_distributions(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts where a process of ROS 2 announces no type hashes, as others do."""
    for _, ends in evidence.endpoints.groupby("scope"):
        ends = ends[ends["index"].isin(ends["index"][ends["topic"].eq(GRAPH_TOPIC)])]
        newer = ends[ends["type_hash"] != ""]
        older = ends[~ends["index"].isin(newer["index"]) & ends["topic"].str.startswith("rt/")]
        if len(newer) and len(older):
            hosts = tuple(older["host"].unique())
            text = say("older distribution", newer["host"].unique(), hosts)
            yield Finding("different distributions", hosts, text)


def uninformed_clients(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts to whose clients a server or router announces no endpoint, but to others."""
    obs = evidence.obs
    sent = obs.isin("kind", SEDP) | obs.isin("submessage", "DeclareSubscriber", "Push")
    sent &= np.isin(obs.sender_index, [*obs.servers])
    told = {*obs.receiver_index[sent].tolist()} - {-1}
    pairs = [pair for pair in evidence.expected_pairs if np.isfinite(pair.complete_at)]
    known = {of.subject for of in pairs if of.n_announced and of.observer in obs.servers}
    known = {one for one in known if np.ptp(obs.first_last, axis=0)[one] >= LIMITS.timeout}
    idle = known - told - evidence.early_processes
    # A node that shares no topic with others is no tool, which has only those of each node.
    uses = evidence.endpoints["host"][~evidence.endpoints["topic"].isin(NODE_TOPICS)]
    for host, own in obs.processes_by_host(sorted(idle)).items() if told else ():
        if host not in {*obs.hosts_of(told), *uses}:
            kind = "told nothing" if obs.is_rtps[own[0]] else "router tells nothing"
            yield Finding(kind, (host,), say(kind, host, obs.hosts_of(sorted(told))))


def processes_without_time(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts with a process that left before it met its readers, or any other process."""
    obs, ends, texts = evidence.obs, evidence.endpoints, dict[str, str]()
    wrote = obs.senders(obs.isin("kind", "User data"))
    met = obs.senders((obs.receiver_index >= 0) & ~obs["multicast"])
    for process in sorted(evidence.brief_processes - wrote):
        life, host = evidence.lifetimes[process], obs.process_host[process]
        own = ends["index"].eq(process) & ends["writer"].eq(other=True)
        topics = {*ends["topic"][own & ends["topic"].str.startswith("rt/")]} - {*NODE_TOPICS}
        read = ends[ends["topic"].isin(topics) & ends["writer"].eq(other=False)]
        readers = sorted({*read["host"]} - {host})
        earlier = (obs.first_last[0] < life.first) & (obs.process_host != host)
        if readers or (process not in met and earlier.any()):
            what = f"sent no sample to {listing(readers)}" if readers else "met no other process"
            texts.setdefault(host, say("left early", host, life.last - life.first, what))
    if texts:
        yield Finding("left early", tuple(texts), "; ".join(texts.values()))


def looping_bridges(evidence: Evidence) -> Iterator[Finding]:
    """Yield pairs of hosts that repeat in DDS what comes by Zenoh, and hear each other's DDS."""
    obs, ends = evidence.obs, evidence.endpoints
    both = ends.groupby(["index", "topic"])["writer"].nunique() > 1
    data, pushed = obs.isin("kind", "User data") & ~obs["multicast"], obs.isin("kind", "Push")
    counts = dict[str, tuple[int, int]]()
    for host, own in obs.processes_by_host(both[both].index.unique("index")).items():
        repeated = len(np.unique(obs.seq[data & np.isin(obs.sender_index, own)]))
        came = int((pushed & obs.isin("receiver", host)).sum())
        few, many = sorted((came, repeated))
        if few >= LIMITS.min_repeated and many <= LIMITS.max_repeat_ratio * few:
            counts[host] = came, repeated
    links = obs.links_of(obs.messages[data])
    for pair in combinations(counts, 2):
        if {pair, pair[::-1]} <= links:
            text = [say("bridged", of, *counts[of]) for of in pair]
            yield Finding("bridges in a loop", pair, f"{listing(text)}, also to each other")
