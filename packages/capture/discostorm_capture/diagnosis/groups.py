"""Findings about how hosts search for each other: domains, groups, peers and ports."""

from collections import Counter, defaultdict
from collections.abc import Iterator
from itertools import chain, combinations, permutations

import numpy as np

from discostorm_capture.diagnosis.evidence import Evidence
from discostorm_capture.diagnosis.finding import LIMITS, Finding
from discostorm_capture.diagnosis.observations import MULTICAST_KINDS, Observations
from discostorm_capture.diagnosis.pairs import DiscoveryScope, server_clients
from discostorm_capture.sentences import join_names, join_seconds, say


def different_domains(evidence: Evidence) -> Iterator[Finding]:
    """Report that hosts are in different domains, or a process is in another one than its host."""
    obs, known = evidence.obs, evidence.obs.processes.query("domain >= 0 and host != ''")
    names = known["domain"].astype(str) + known["tag"].map(lambda tag: tag and f" (tag {tag!r})")
    for _, table in known.groupby("protocol"):
        members = table.groupby(names)["host"].unique()
        hosts = tuple(chain.from_iterable(members))
        said = [
            f"domain {domain} contains {join_names(found)}" for domain, found in members.items()
        ]
        if len(members) > 1 and len(hosts) == len({*hosts}):
            # Two teams sharing a network have several hosts each. Of two hosts, none is in the
            # default domain, or no packets go between them, as with a Zenoh router for each.
            apart = [_is_by_domain(obs, _connected_groups(obs, one)) for one in evidence.scopes]
            least = 2 if "0" not in members or any(apart) else 3
            teams = min(map(len, members)) >= least
            yield Finding("two fleets" if teams else "two domains", hosts, join_names(said, "; "))
        single = members[names[table.index].value_counts()[members.index] == 1]
        for (host,) in single:
            if any(host in other and len(other) > 1 for other in members):
                yield Finding("process alone", (host,), join_names(said, "; "))


def refused_announcements(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts that send each other announcements only to ports that all of them refuse."""
    hosts = tuple(sorted(evidence.obs.hosts_refused_by_all))
    if hosts:
        ports = [row[3] for row in evidence.obs.event_tuples("asked") if row[2] in hosts]
        yield Finding.of("no index", hosts, min(ports), max(ports))


def no_free_participant_index(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts with as many processes as ports at which Cyclone DDS searches for them."""
    obs, ports = evidence.obs, _searched_ports(evidence.obs)
    refused = {row[3] for row in obs.event_tuples("unreachable")}
    cyclone = np.flatnonzero(obs.processes["product"].eq("Cyclone DDS"))
    running = [one for one in cyclone.tolist() if not evidence.endings[one]]
    for host, processes in obs.processes_by_host(running).items():
        found = ports.get(host, set())
        # A refused port shows that others searched for processes there.
        if len(refused & found) >= LIMITS.min_unanswered and len(processes) >= len(found) - 1:
            counts = len(processes), len(found), min(found), max(found)
            yield Finding.of("no free index", (host,), *counts)


def processes_beyond_searched_ports(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts with processes of Cyclone DDS that no other host finds, as their ports are used.

    Only a capture that includes the loopback interface shows these processes.
    """
    obs, ports = evidence.obs, _searched_ports(evidence.obs)
    cyclone, met = obs.processes["product"].eq("Cyclone DDS"), np.isfinite(obs.first_last[0])
    for host, found in ports.items():
        here = cyclone & (obs.process_host == host)
        local = int((here & ~met).sum())
        if local and (here & met).sum() >= len(found):
            counts = local, int(here.sum()), min(found), max(found)
            yield Finding.of("too few indices", (host,), *counts)


def same_host_numbers(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts that Fast DDS takes for one machine, so that they do not use the network."""
    obs, hosts, numbers = evidence.obs, dict[str, None](), set[str]()
    fast = obs.processes["product"].eq("Fast DDS").to_numpy()
    number = obs.processes.index.astype(str).str[4:8]  # after the vendor's (DDSI-RTPS, 8.2.4)
    for pair in evidence.incomplete_pairs:
        one, other = pair.processes
        if not (fast[one] and fast[other] and number[one] == number[other]):
            continue
        sent = [obs.messages_between(*of) for of in permutations(pair.processes)]
        if not any((of & ~obs["multicast"]).any() for of in sent):
            hosts.update(dict.fromkeys(obs.hosts_of(pair.processes)))
            numbers.add(number[one])
    if hosts:
        yield Finding.of("same host number", hosts, sorted(numbers))


def initial_peers_end_too_early(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts with more processes than ports at which Fast DDS searches for its peers."""
    obs, ports = evidence.obs, _searched_ports(evidence.obs)
    if (obs.isin("kind", "SPDP") & obs["multicast"]).any():
        return
    fast = np.flatnonzero(obs.processes["product"].eq("Fast DDS")).tolist()
    counts = {host: len(of) for host, of in obs.processes_by_host(fast).items()}
    # A host with few processes is called at all ports of the search, and answers at some.
    searched = [ports[host] for host, count in counts.items() if count < len(ports.get(host, ()))]
    most = max(searched, key=len, default=set())
    many = {host: count for host, count in counts.items() if count > len(most)}
    if many and len(most) >= LIMITS.port_search:
        text = [f"{count} processes on {host}" for host, count in many.items()]
        yield Finding.of("too few peer ports", [*many], text, min(most), max(most))


def _searched_ports(obs: Observations) -> dict[str, set[int]]:
    """Return the ports at which others search for processes, by host."""
    ports: dict[str, set[int]] = {}
    for _, caller, host, port, _ in obs.event_tuples("asked"):
        if caller != host and port % 2 == 0:  # odd ones are for user data
            ports.setdefault(host, set()).add(port)
    return ports


def separate_groups(evidence: Evidence) -> Iterator[Finding]:
    """Report that hosts of a scope form groups without any message from one to another."""
    obs, parts = evidence.obs, [_connected_groups(evidence.obs, one) for one in evidence.scopes]
    parts = [groups for groups in parts if len(groups) > 1 and not _is_by_domain(obs, groups)]
    found = [_explain_separation(obs, of) for of in parts] or [*_hosts_never_addressed(evidence)]
    yield from found or _multicast_beside_peers(evidence)


def _multicast_beside_peers(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts that only multicast, and refuse the ports at which others look for a peer."""
    obs, looking = evidence.obs, _multicast_targets(evidence.obs)
    asked, refused = ({row[1:4] for row in obs.event_tuples(k)} for k in ("asked", "unreachable"))
    apart: dict[str, dict[str, None]] = {}
    for pair in evidence.incomplete_pairs:
        for caller, host in permutations(obs.hosts_of(pair.processes), 2):
            tried = {row for row in asked if row[:2] == (caller, host)}
            if host in looking and caller not in looking and tried and tried <= refused:
                apart.setdefault(host, {})[caller] = None
    for host, callers in apart.items():
        text = say("peers and multicast", host, [*callers])
        yield Finding("different discovery", (host,), text)


def _hosts_never_addressed(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts without multicast to which another host sends nothing after they started."""
    obs, texts = evidence.obs, dict[str, str]()
    looking, served = _multicast_targets(obs), server_clients(obs) | obs.servers
    heard = {*obs.messages["receiver"].astype(str)}
    sent = obs.messages.groupby(["sender", "receiver"], observed=True)["time"].max().to_dict()
    for pair in evidence.incomplete_pairs:
        ends = obs.hosts_of(pair.processes)
        apart = {*pair.processes} & served or {*ends} & {*looking}
        # Two hosts that hear nothing may both list a third one.
        if apart or not obs.is_rtps[pair.subject] or heard.isdisjoint(ends):
            continue
        begin, late = max((obs.host_first_last.get(host, (0.0,))[0], host) for host in ends)
        last = max(sent.get(ends, -np.inf), sent.get(ends[::-1], -np.inf))
        if last < begin:
            texts[late] = say("sends nothing to", late, begin, ends[ends[0] == late])
    if texts:
        yield Finding("separate peers", tuple(texts), "; ".join(texts.values()))


def uninformed_peers(evidence: Evidence) -> Iterator[Finding]:
    """Yield Zenoh peers that only have a session with a router, which declares nothing to them."""
    obs = evidence.obs
    opened, declares = obs.isin("submessage", "OpenAck"), obs.isin("kind", "Declare")
    routers_of, links = dict[str, tuple[str, ...]](), obs.isin("submessage", "OAM (network)")
    peers, hidden = np.flatnonzero(obs.processes["product"].eq("Zenoh peer")).tolist(), False
    by_host = obs.processes_by_host(peers)
    for peer in peers:
        to_it = obs.receiver_index == peer
        others, declared = obs.senders(to_it), (to_it & declares).any()
        # Peers on loopback, beside those on its own host, of which the router tells.
        beside = len(by_host[obs.process_host[peer]]) - 1
        hides = obs.seq[to_it & links].max(initial=0) > beside
        lasts = obs.recording.recorded_time - obs.first_last[0][peer] >= LIMITS.timeout
        seen = (to_it & opened).any() and lasts
        if seen and others <= obs.servers and (hides or not declared):
            hidden |= hides
            routers_of[obs.process_host[peer]] = obs.hosts_of(others)
    hosts, routers = [*routers_of], sorted({*chain(*routers_of.values())})
    calls = Counter(row[1:3] for row in obs.event_tuples("unanswered") if {*row[1:3]} <= {*hosts})
    asked = {pair: len(times) for pair, times in obs.unanswered_arp.items() if {*pair} <= {*hosts}}
    often = max(calls.total(), *asked.values(), 0) >= LIMITS.min_unanswered
    calls.update(asked)
    if often and len({*map(frozenset, calls)}) == len(hosts) * (len(hosts) - 1) // 2:
        counts = join_names([f"{one} for {other}: {n}" for (one, other), n in calls.items()])
        text = f"{join_names(hosts)} have sessions only with {join_names(routers)}"
        text += f", and sent each other connection or ARP requests ({counts}), but got no answer"
        yield Finding("client isolation", tuple(hosts), text)
    elif len(hosts) > 1 or hidden:  # so there are other nodes
        yield Finding.of("peers at a router", hosts, routers)
    else:
        yield from (Finding.of("peer at a router", [host], routers) for host in hosts)


def _connected_groups(obs: Observations, scope: DiscoveryScope) -> list[set[str]]:
    """Return sets of hosts linked by unicast or a common multicast group, largest first."""
    # A Hello is no link: clients of a Zenoh router answer a Scout, but accept no session.
    rows = obs.isin("protocol", scope.protocol) & ~obs["multicast"] & ~obs.isin("kind", "Hello")
    calls = obs.events("connection", "half", "refused", "unanswered", "exchange")
    # Ports below 1024 belong to other programs, such as NTP and SSH (RFC 6335).
    other = {pair[::-1] for pair in obs.links_of(calls[calls["port"] < 1024])}
    links = obs.links_of(calls[calls["port"] >= 1024]) - other
    links |= obs.links_of(obs.messages[rows])
    targets = _multicast_targets(obs)
    links |= {pair for pair in combinations(targets, 2) if targets[pair[0]] & targets[pair[1]]}
    times = {host: obs.host_first_last[host] for host in scope.hosts if host in obs.host_first_last}
    hosts = {host for host, (first, last) in times.items() if last - first >= LIMITS.timeout}
    groups = [{host} for host in hosts.union(*links)]
    for pair in links:
        met = [group for group in groups if group & {*pair}]
        groups = [group for group in groups if group not in met] + [set[str]().union(*met)]
    groups = [group for group in groups if group & hosts - obs.server_hosts]
    return sorted(groups, key=lambda group: (-len(group & hosts), sorted(group)))


def _is_by_domain(obs: Observations, groups: list[set[str]]) -> bool:
    """Return whether there are several groups, in different domains."""
    known = obs.processes.query("domain >= 0")
    domains = [{*known["domain"][known["host"].isin(group)]} for group in groups]
    return len(groups) > 1 and all(domains) and sum(map(len, domains)) == len(set().union(*domains))


def _multicast_targets(obs: Observations) -> dict[str, set[tuple[str, int]]]:
    """Return the multicast groups and ports to which each announcing host sends."""
    looks = obs.links_of(obs.messages[obs.isin("kind", *MULTICAST_KINDS) & obs["multicast"]])
    asked = [row[1:4] for row in obs.event_tuples("asked")]
    targets: dict[str, set[tuple[str, int]]] = defaultdict(set)
    for host, group in looks:
        ports = [port for *ends, port in asked if ends == [host, group]] or [0]
        targets[host].update((group, port) for port in ports)
    return targets


def _explain_separation(obs: Observations, groups: list[set[str]]) -> Finding:
    targets = _multicast_targets(obs)
    servers = obs.messages["sender"][np.isin(obs.sender_index, [*obs.servers])]
    rest = set().union(*groups[1:])
    few = tuple(sorted(rest - {*servers} or rest))  # in a fleet of routers, each host is a server
    text = say("groups apart", "; ".join(join_names(sorted(group)) for group in groups))
    looking, served = ([group for group in groups if group & {*of}] for of in (targets, servers))
    if len(looking) > 1:
        sends = [(f"{to}, port {port},", host) for host in targets for to, port in targets[host]]
        texts = [f"multicast to {to} comes from {of}" for to, of in join_seconds(sends).items()]
        return Finding("other group", few, "; ".join(texts))
    if looking and served and looking[0] not in served:
        text = say("discovery by group", sorted(looking[0]), sorted(served[0] - looking[0]))
        seen = obs.processes["product"][np.isin(obs.process_host, [*looking[0]])]
        ignores = len(seen) and not seen.str.contains("Fast DDS|Zenoh").any()
        return Finding("no server there" if ignores else "different discovery", few, text)
    own, theirs = (sorted(group & {*servers}) for group in (rest, groups[0]))
    if own and theirs and {*few} - {*own}:
        text += say("other servers", few, own, theirs)
        hello = obs.links_of(obs.messages[obs.isin("kind", "Hello")])
        text += "".join(say("found by scouting", to, of) for of, to in sorted(hello) if of in own)
    return Finding("different servers" if len(served) > 1 else "separate peers", few, text)
