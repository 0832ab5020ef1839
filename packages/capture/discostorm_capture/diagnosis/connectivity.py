"""Findings about connectivity: which host receives nothing from which, or never tries, and why."""

from collections import Counter
from collections.abc import Iterator
from dataclasses import replace
from ipaddress import ip_address, ip_network

import numpy as np

from discostorm import wording
from discostorm_capture._types import Array
from discostorm_capture.diagnosis.evidence import Evidence
from discostorm_capture.diagnosis.finding import LIMITS, Finding
from discostorm_capture.diagnosis.observations import HEARTBEAT, MULTICAST_KINDS, SEDP, Observations
from discostorm_capture.diagnosis.pairs import DiscoveryScope, server_clients
from discostorm_capture.diagnosis.reachability import Reachability, reachability
from discostorm_capture.sentences import join_names, join_seconds, say

#: Docker's default network (Docker documentation, bridge network driver).
DOCKER_NETWORK = ip_network("172.17.0.0/16")


def unreachable_hosts(evidence: Evidence) -> Iterator[Finding]:
    """Yield why hosts of a scope receive nothing from each other."""
    for scope in evidence.scopes:
        scope = replace(scope, members=tuple({*scope.members} - evidence.brief_processes))
        reach = reachability(evidence.obs, scope, evidence.missing_samples)
        if len(reach.hosts) < 2:
            yield from _lone_host(evidence, scope, reach)
        elif (reach.receives & reach.observable).any():
            yield from _hosts_without_answers(evidence.obs, reach)
            yield from _hosts_without_unicast(evidence.obs, reach)
        elif reach.observable.any():
            yield from _no_answers(evidence.obs, scope, reach)


def multicast_ends(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts whose announcements by multicast end, though one of them goes on by unicast."""
    obs, ended, goes_on = evidence.obs, dict[str, float](), list[str]()
    calls = obs.isin("kind", "SPDP") & obs["multicast"]
    for host in {*obs.host_first_last} - {obs.vantage_host}:
        by_it = obs.isin("sender", host)
        times, spoke = (np.unique(obs.time[of]) for of in (calls & by_it, by_it))
        pause = max(LIMITS.max_pause, LIMITS.min_pause_ratio * np.diff(times).max(initial=0.0))
        if len(times) >= LIMITS.min_calls and times[-1] + pause < obs.end:
            ended[host] = float(times[-1])
            # While a host is away, it does not announce itself either.
            later = spoke[spoke >= times[-1]]
            if np.ptp(later) - np.diff(later).max(initial=0.0) > pause:
                goes_on.append(host)
    hosts = {*obs.messages["sender"][calls].astype(str)} - {str(obs.vantage_host)}
    if goes_on and len(hosts) > 1 and hosts == {*ended}:
        at = max(ended.values()), sorted(goes_on)
        yield Finding.of("multicast ends", sorted(ended), *at)


def no_unicast_received(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts where only some processes confirm unicast, or where a server's clients do not."""
    obs = evidence.obs
    directed = (obs.sender_index >= 0) & (obs.receiver_index >= 0) & ~obs["multicast"]
    acks = directed & obs.isin("submessage", "ACKNACK")
    confirming = obs.senders(acks & ((obs.seq > 1) | (obs["missing"] > 0)))
    asks = directed & obs.isin("submessage", "DATA", "HEARTBEAT") & (obs.seq > 0)
    tried = np.bincount(obs.receiver_index[asks], minlength=len(obs.processes))
    deaf = {one for one in obs.senders(acks) - confirming if tried[one] >= LIMITS.min_unanswered}
    deaf -= {one for one in deaf if np.ptp(obs.first_last, axis=0)[one] < LIMITS.timeout}
    for host, processes in obs.processes_by_host(sorted(deaf)).items():
        if host in obs.hosts_of(confirming):
            ports = sorted({row[3] for row in obs.event_tuples("asked") if row[2] == host})
            count = wording.count_noun(len(processes), "process", "es")
            yield Finding.of("closed ports", (host,), count, sum(tried[processes]), ports)
        elif {*processes} <= server_clients(obs) - evidence.early_processes:
            yield Finding.of("unicast firewall", (host,), sum(tried[processes]))


def no_user_data(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts that confirm endpoints, but no user samples sent to them, or that send none."""
    obs, texts, links = evidence.obs, dict[str, str](), set[tuple[str, str]]()
    confirms = obs.isin("submessage", "ACKNACK") & ((obs.seq > 1) | (obs["missing"] > 0))
    asks, data = obs.isin("kind", "User ACKNACK"), obs.isin("kind", "User data") & ~obs["multicast"]
    good = {*obs.messages["sender"][confirms & ~asks]} - {*obs.messages["sender"][confirms & asks]}
    for host in sorted(good):
        sent = data & obs.isin("receiver", host)
        wants = obs.time[asks & obs.isin("sender", host)]
        lasted = obs.time[sent].max(initial=-np.inf) - wants.min(initial=np.inf)
        if sent.sum() >= LIMITS.min_unanswered and lasted >= LIMITS.timeout:
            texts[host] = f"{sent.sum()} samples, which it requested {len(wants)} times"
            links |= obs.links_of(obs.messages[sent])
        wanted = obs.time[asks & obs.isin("receiver", host)]
        often = len(wanted) >= LIMITS.min_messages and np.ptp(wanted) >= LIMITS.timeout
        if often and not (obs.isin("entity", "user") & obs.isin("sender", host)).any():
            yield Finding.of("data kept in", (host,), len(wanted))
    # With client isolation, hosts confirm nothing at all to each other.
    if len(texts) > 1 and not {ends[::-1] for ends in links} & obs.links_of(obs.messages[confirms]):
        yield Finding.of("client isolation", texts, [f"{h} ({text})" for h, text in texts.items()])
        return
    for host, text in texts.items():
        yield Finding.of("no data", (host,), text)


def stopped_confirming(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts that keep sending, but from some time on confirm nothing to others."""
    obs, hosts = evidence.obs, [*evidence.obs.host_first_last]
    named, writers = ~obs["multicast"] & (obs.sender_index >= 0), obs["writer"]
    acks = named & obs.isin("submessage", "ACKNACK") & (obs.receiver_index >= 0)
    beats = named & obs.isin("submessage", "HEARTBEAT")
    by, to = (obs.indices_among(end, hosts) for end in ("sender", "receiver"))
    answered = obs.rows_by(acks, by, to)
    confirmed = obs.rows_by(acks, by, obs.receiver_index, writers)
    # Times of unanswered Heartbeats, by host that should confirm and host that sent them.
    asks: dict[tuple[int, ...], list[float]] = {}
    for key, rows in obs.rows_by(beats, to, obs.sender_index, writers).items():
        if key in confirmed and (pair := (key[0], int(by[rows[0]]))) in answered:
            lacks = obs.seq[rows] >= obs.seq[confirmed[key]].max()
            late = obs.time[rows] > obs.time[answered[pair]].max()
            asks.setdefault(pair, []).extend(obs.time[rows[lacks & late]].tolist())
    texts: dict[tuple[int, ...], str] = {}
    for ends, times in asks.items():
        last, (host, asker) = obs.time[answered[ends]].max(), (hosts[one] for one in ends)
        enough = len(times) >= LIMITS.min_heartbeats and np.ptp(times) >= 2 * LIMITS.timeout
        if enough and obs.host_first_last[host][1] - last >= LIMITS.max_pause:
            texts[ends] = f"{asker} ({len(times)} sent after {last:.1f} s)"
    said = join_seconds((hosts[index], text) for (index, _), text in texts.items())
    clauses = {host: f"{host} acknowledges none from {of}" for host, of in said.items()}
    partly = {ends[0] for ends in asks if ends not in texts}
    mute = [*dict.fromkeys(ends[0] for ends in texts if ends[0] not in partly)]
    if len(mute) > 1 and {*mute} == {index for index, _ in asks}:
        mutes = tuple(hosts[index] for index in mute)
        yield Finding("unicast dropped", mutes, say("confirm no more", "; ".join(clauses.values())))
        return
    for host in (hosts[index] for index in mute):
        yield Finding("answers no more", (host,), say("confirms no more", host, said[host]))
    if single := {pair: text for pair, text in texts.items() if pair[0] not in mute}:
        which = tuple(dict.fromkeys(hosts[index] for index, _ in single))
        mutual = {*single} == {pair[::-1] for pair in single}
        kind = "pairs apart" if mutual else "one direction of pairs"
        yield Finding(kind, which, say("confirm no more", "; ".join(clauses[one] for one in which)))


def no_tcp_connection(evidence: Evidence) -> Iterator[Finding]:
    """Yield Zenoh hosts that others found by UDP, or know as peers, but cannot reach by TCP."""
    obs = evidence.obs
    apart = {obs.hosts_of(pair.processes) for pair in evidence.incomplete_pairs}
    found = obs.links_of(obs.messages[obs.isin("kind", "Hello") & ~obs["multicast"]])
    failed = Counter(row[1:3] for row in obs.event_tuples("unanswered", "refused"))
    # Skip callers that got no Hello: only a Hello has the port.
    vain = {pair: count for pair, count in failed.items() if pair in apart and pair[::-1] in found}
    # Peers with fixed addresses send no Hello.
    peers = {*obs.process_host[~obs.is_rtps & ~obs.is_server]}
    spoke = obs.links_of(obs.messages[obs.isin("protocol", "Zenoh")])
    calls = Counter(row[1:3] for row in obs.event_tuples("unanswered") if {*row[1:3]} <= peers)
    lost = {of: n for of, n in calls.items() if n + calls[of[::-1]] >= LIMITS.min_calls}
    vain |= {of: n for of, n in lost.items() if not {of, of[::-1]} & spoke}
    if vain:
        said = [f"from {a} to {b} ({wording.count_noun(n, 'time')})" for (a, b), n in vain.items()]
        yield Finding.of("no TCP", [*dict.fromkeys(called for _, called in vain)], said)


def unreachable_locators(evidence: Evidence) -> Iterator[Finding]:
    """Yield Zenoh hosts that others first call in vain at further addresses that they announce."""
    obs, vain = evidence.obs, dict[str, str]()
    links, failed = obs.event_tuples("connection", "exchange"), obs.event_tuples("unanswered")
    for host, processes in obs.processes_by_host(np.flatnonzero(~obs.is_rtps).tolist()).items():
        announced = {*" ".join(obs.processes["announces"].iloc[processes]).split()}
        calls = {row[2]: row[4] for row in failed if row[2] in {host, *announced}}
        linked = min([row[4] for row in links if host in row[1:3]], default=np.inf)
        if calls and host not in calls and linked > min(calls.values()) + LIMITS.min_wait:
            vain[host] = f"{host} ({join_names(sorted(calls))})"
    if vain:
        yield Finding.of("unreachable locators", vain, [*vain.values()])


def rejecting_firewalls(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts whose firewall rejects packets of others, as its ICMP replies say."""
    rejected = Counter(row[2] for row in evidence.obs.event_tuples("prohibited"))
    for host, count in rejected.items():
        if count >= LIMITS.min_calls:
            yield Finding.of("rejects", (host,), count)


def _lone_host(evidence: Evidence, scope: DiscoveryScope, reach: Reachability) -> Iterator[Finding]:
    obs = evidence.obs
    others = len(obs.host_first_last) > 1 or scope.pairs or evidence.silent_hosts
    if not reach.hosts or len({*scope.hosts} - obs.server_hosts) != 1 or others:
        return
    (host,) = reach.hosts
    first, last = obs.host_first_last[host]
    if last - first >= LIMITS.timeout:
        count = int((obs.isin("sender", host) & obs["multicast"]).sum())
        text = say("alone", host, count, last - first)
        other = obs.events("other traffic").query("receiver == @host")["sender"].astype(str)
        near = obs.subnet_neighbors(host, sorted({*other}))
        kind = "alone, but connected" if near else "alone"
        yield Finding(kind, (host,), text + (say("others are on", near) if near else ""))


def _no_answers(obs: Observations, scope: DiscoveryScope, reach: Reachability) -> Iterator[Finding]:
    """Yield why no announcement is answered, such as different subnets or filtered multicast."""
    hosts, others = reach.hosts, obs.recording.packets_without_messages
    count = int((obs.isin("kind", *MULTICAST_KINDS) & obs["multicast"]).sum())
    text = f"{join_names(hosts)} announced themselves {count} times by multicast"
    subnets = obs.subnet_numbers(hosts, 16).tolist()
    ((largest, size),) = Counter(subnets).most_common(1)
    if size < len(hosts):
        pairs = zip(hosts, subnets, strict=True)
        outside = tuple(host for host, one in pairs if one != largest or size == 1)
        yield _other_subnet(obs, outside, say("other subnet", hosts))
        if size <= len(hosts) // 2 + 1:
            return  # different subnets explain the missing answers
    links = obs.links_of(obs.messages)
    links = {pair for pair in links if pair[::-1] in links} | obs.links_of(obs.events("connection"))
    unicast = sorted(pair for pair in links if {*pair} <= {*hosts})
    if unicast:
        kind = "multicast filtered"
        text += f", and none answered, while {join_names(unicast[0])} exchange unicast"
    elif asked := {pair: len(t) for pair, t in obs.unanswered_arp.items() if {*pair} <= {*hosts}}:
        kind, again = "client isolation", "again and again "
        each = Counter(one for one, _ in asked)
        heard = {*each.values()} == {len(hosts) - 1}
        # Hosts that hear each other all ask, unless their broadcasts are dropped on the way.
        if heard and len(each) == 1 < len(hosts) - 1:
            kind = "unicast or ARP dropped"
        if max(asked.values()) < LIMITS.min_unanswered:  # the capture probably lost the answers
            kind, again = "capture lost part", ""
        counts = join_names([f"{one} for {other}: {n}" for (one, other), n in asked.items()])
        text += say("asks by ARP", again, counts, ", so they heard each other" * heard)
        if not again:
            text += " and no unicast, as if a third host had recorded it"
    elif settled := obs.hosts_of(sorted(obs.senders(obs.isin("kind", SEDP, HEARTBEAT)))):
        kind = "capture lost part"
        text += say("settled", settled)
    elif obs.isin("kind", *MULTICAST_KINDS).all() and not any(others.values()):
        kind = "nobody hears, or filter"
        text += ", but the capture contains nothing else, not even an answer"
    elif scope.protocol == "Zenoh" and (obs.seq[obs.isin("kind", "Scout")] == 1).all():
        kind, text = "no router", say("no router", hosts, count)
    else:
        kind = "nobody hears"
        text += ", and none was ever answered"
    yield Finding(kind, hosts, text)


def _hosts_without_answers(obs: Observations, reach: Reachability) -> Iterator[Finding]:
    """Yield hosts that receive from no other host, or reach none; then single pairs."""
    hosts, pairs = np.array(reach.hosts, object), reach.observable
    deaf = pairs & ~reach.receives
    if (outside := _outside_largest_subnet(obs, reach)).any():
        text = say("answers in one subnet", [*hosts[outside], *hosts[~outside]])
        if idle := obs.subnet_neighbors(hosts[~outside][0], sorted(_idle_addresses(obs))):
            text += say("idle address", idle)
            yield Finding("interface apart", tuple(hosts[outside]), text)
        else:
            yield _other_subnet(obs, tuple(hosts[outside]), text)
        deaf &= (outside[:, None] == outside) & reach.receives.any(axis=1)
    several = pairs.sum(axis=1) > 1
    if obs.vantage_host in reach.hosts:  # the others have only one pair in the capture
        heard = reach.receives[:, reach.hosts.index(obs.vantage_host)]
        several |= pairs.any(axis=1) & (heard.sum() > 1)
    hears_none, unheard = ((deaf.sum(axis) == pairs.sum(axis)) & deaf.any(axis) for axis in (1, 0))
    for index in np.flatnonzero(hears_none & unheard & several):
        text = f"{hosts[index]} announces itself, but answers no other host and gets no answer"
        first = {host: obs.host_first_last[host][0] for host in hosts}
        stopped = first.pop(hosts[index]) - max(first.values()) >= LIMITS.timeout
        kind = "multicast stopped" if stopped else "cut off"
        text += say("multicast stopped") * stopped
        scouts = obs.seq[obs.isin("kind", "Scout") & obs.isin("sender", hosts[index])]
        if scouts.size and (scouts == 1).all():
            kind, text = "no router", say("no router", [hosts[index]], len(scouts))
        yield Finding(kind, (hosts[index],), f"{text}{_describe_arp_replies(obs, hosts[index])}")
        deaf[index, :] = deaf[:, index] = False
    for index in np.flatnonzero(hears_none & several & deaf.any(axis=1)):
        # Skip a host that misses only one other, if that one reaches no host.
        if unheard[deaf[index]].any() and deaf[index].sum() == 1:
            continue
        own = " ".join(obs.processes["announces"][obs.process_host == hosts[index]]).split()
        more = [one for one in obs.subnet_neighbors(hosts[index], own) if one != hosts[index]]
        if more:
            yield Finding.of("overlapping networks", (hosts[index],), more)
            deaf[index, :] = False
            continue
        sent = int(obs.isin("receiver", hosts[index]).sum())
        subnets = obs.subnet_numbers(hosts, 16)
        others = hosts[subnets != subnets[index]]
        if len(others) == len(hosts) - 1:
            text = say("answers in one subnet", [hosts[index], *others])
            yield _other_subnet(obs, (hosts[index],), text)
            deaf[index, :] = False
            continue
        arrives = _describe_arp_replies(obs, hosts[index])
        arrives += say("arrives") * (obs.vantage_host == hosts[index])
        text = f"announces itself{f', and others sent it {sent} messages' if sent else ''}"
        text += f", but it never answered any{arrives}"
        kind = "firewall" if arrives else "firewall or network"
        yield Finding(kind, (hosts[index],), f"{hosts[index]} {text}")
        deaf[index, :] = False
    for index in np.flatnonzero(unheard & several & deaf.any(axis=0)):
        text = f"none ever answered {hosts[index]}"
        if answered := join_names(hosts[reach.multicast_ok[index]]):
            text = f"{hosts[index]} answered {answered}, but never got an answer back"
        yield Finding("one direction", (hosts[index],), text)
        deaf[:, index] = False
    yield from _groups_without_multicast(obs, reach, deaf)
    yield from _single_pair_findings(reach, deaf, "never answered")


def _groups_without_multicast(
    obs: Observations, reach: Reachability, deaf: Array
) -> Iterator[Finding]:
    """Yield two groups of hosts between which only unicast passes; take these pairs out."""
    hosts = np.array(reach.hosts, object)
    group = ~deaf[0]
    apart = group[:, None] != group
    if (deaf != apart & reach.observable).any() or min(group.sum(), (~group).sum()) < 2:
        return
    links = obs.links_of(obs.events("other traffic", "connection"))
    both = sorted(pair for pair in links if pair[::-1] in links and {*pair} <= {*reach.hosts})
    across = [pair for pair in both if len({*pair} & {*hosts[group]}) == 1]
    if across:
        groups = "; ".join(join_names(hosts[of]) for of in (group, ~group))
        yield Finding(
            "multicast filtered", tuple(hosts[group]), say("multicast in groups", groups, across[0])
        )
        deaf[:] = False


def _other_subnet(obs: Observations, hosts: tuple[str, ...], text: str) -> Finding:
    """Return a finding about hosts in another subnet, or in the default network of Docker."""
    own, others = {*obs.events("own address")["sender"].astype(str)}, {*obs.host_first_last}
    near = sorted(one for one in own - others if obs.subnet_neighbors(one, others))
    if {*hosts} <= own and near:
        return Finding("wrong own interface", hosts, text + say("wrong own interface", near))
    # The first address of that network is the one of the host.
    first = {host.endswith(".0.1") for host in hosts}
    if len(first) > 1 or any(ip_address(host) not in DOCKER_NETWORK for host in hosts):
        return Finding("other subnet", hosts, text)
    return Finding("Docker interface" if first == {True} else "container network", hosts, text)


def _single_pair_findings(reach: Reachability, matrix: Array, what: str) -> Iterator[Finding]:
    both = matrix & matrix.T
    for kind, mask in (("pairs apart", both), ("one direction of pairs", matrix & ~both)):
        pairs = [(reach.hosts[row], reach.hosts[column]) for row, column in np.argwhere(mask)]
        if pairs:
            mutual = kind == "pairs apart"
            ends = join_seconds({(min(pair), max(pair)) for pair in pairs} if mutual else pairs)
            end = ", nor vice versa" * mutual
            said = [f"{one} {what} {of}{end}" for one, of in ends.items()]
            if mutual and len(pairs) == 2:
                said = [f"{pairs[0][0]} and {pairs[0][1]} {what.replace('gets', 'get')} each other"]
            text = join_names(said, "; ")
            yield Finding(kind, tuple(dict.fromkeys(one for one, _ in pairs)), text)


def _describe_arp_replies(obs: Observations, host: str) -> str:
    """Return a clause that a host answers ARP; "" if it does not."""
    count = int((obs.events("ARP reply")["sender"] == host).sum())
    return f"; it answered {count} ARP requests, so frames do reach it" if count else ""


def _idle_addresses(obs: Observations) -> set[str]:
    """Return the addresses that exchange packets with known hosts, but send no messages."""
    links = obs.links_of(obs.events("other traffic", "connection", "exchange"))
    known = {*obs.host_first_last}
    return {one for one, to in links if to in known and (to, one) in links} - known


def _outside_largest_subnet(obs: Observations, reach: Reachability) -> Array:
    """Return which hosts are outside the largest subnet, if none receives across subnets."""
    for bits in (16, 24):
        subnet = Observations.subnet_numbers(reach.hosts, bits)
        within = reach.observable & (subnet[:, None] == subnet)
        across = reach.observable & ~within
        heard_within = not within.any() or (reach.receives & within).any()
        if across.any() and not (reach.receives & across).any() and heard_within:
            sizes = Counter(subnet.tolist())
            idle = Counter(Observations.subnet_numbers(sorted(_idle_addresses(obs)), bits).tolist())
            return np.asarray(subnet != max(sizes, key=lambda one: (sizes[one], idle[one])))
    return np.zeros(len(reach.hosts), bool)


def _hosts_without_unicast(obs: Observations, reach: Reachability) -> Iterator[Finding]:
    """Yield hosts that receive announcements, but no unicast."""
    hosts, tried = np.array(reach.hosts, object), reach.unicast_tried & reach.observable
    apart = reach.multicast_ok & tried & ~reach.unicast_ok
    if not apart.any() or obs.recording.recorded_time < LIMITS.timeout:
        return
    if (apart == apart.T).all():
        kept = apart.any(axis=1)
        good = reach.unicast_ok & reach.observable
        if not good[np.ix_(kept, kept)].any():
            pairs = wording.count_noun(int(apart.sum()) // 2, "pair")
            text = say("no unicast confirmed", hosts[kept], pairs)
            served = join_names(hosts[~kept & good[:, kept].all(axis=1)])
            if served:
                text += f", while {served} exchanges unicast with all of them"
                yield Finding("client isolation", tuple(hosts[kept]), text)
                return
            if kept.sum() > 2 or len(hosts) == 2:
                yield Finding("unicast dropped", tuple(hosts[kept]), text)
                return
            yield from _single_pair_findings(reach, apart, "gets nothing by unicast from")
            return
        groups = np.unique(good[np.ix_(kept, kept)] | np.eye(int(kept.sum()), dtype=bool), axis=0)
        if (groups.sum(axis=0) == 1).all() and 1 < groups.sum(axis=1).min() < kept.sum():
            text = say("unicast in groups", "; ".join(join_names(hosts[kept][of]) for of in groups))
            yield Finding("unicast dropped", tuple(hosts[kept]), text)
            return
    several = reach.observable.sum(axis=1) > 1
    for index in np.flatnonzero(several & tried.any(axis=1) & (apart == tried).all(axis=1)):
        yield Finding("unicast firewall", (hosts[index],), say("one way announced", hosts[index]))
        apart[index] = False
    for index in np.flatnonzero(several & apart.any(axis=0) & (apart == tried).all(axis=0)):
        yield Finding("one direction", (hosts[index],), say("one way", hosts[index]))
        apart[:, index] = False
    yield from _single_pair_findings(reach, apart, "gets nothing by unicast from")
