"""Findings about groups of hosts that never try to discover each other, by configuration."""

from collections.abc import Iterator
from itertools import combinations

import numpy as np

from discostorm_capture.diagnosis.evidence import Evidence
from discostorm_capture.diagnosis.finding import LIMITS, Finding
from discostorm_capture.diagnosis.observations import MULTICAST_KINDS, Observations
from discostorm_capture.diagnosis.pairs import DiscoveryScope, server_clients
from discostorm_capture.sentences import listing, say


def separate_groups(evidence: Evidence) -> Iterator[Finding]:
    """Yield that hosts of a scope form groups without any message from one to another."""
    parts = [_connected_groups(evidence.obs, scope) for scope in evidence.scopes]
    separated = [_explain_separation(evidence.obs, groups) for groups in parts if len(groups) > 1]
    yield from separated or _hosts_never_addressed(evidence)


def _hosts_never_addressed(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts without multicast to which another host sends nothing after they started."""
    obs, texts = evidence.obs, dict[str, str]()
    looking, served = _multicast_targets(obs), server_clients(obs) | obs.servers
    sent = obs.messages.groupby(["sender", "receiver"], observed=True)["time"].max().to_dict()
    for pair in evidence.incomplete_pairs:
        ends = obs.hosts_of(pair.processes)
        apart = {*pair.processes} & served or {*ends} & {*looking}
        if apart or not obs.is_rtps[pair.subject]:
            continue
        begin, late = max((obs.host_first_last.get(host, (0.0,))[0], host) for host in ends)
        last = max(sent.get(ends, -np.inf), sent.get(ends[::-1], -np.inf))
        if last < begin:
            since = f" since {last:.1f} s" if np.isfinite(last) else ""
            texts[late] = say("sends nothing to", late, begin, ends[ends[0] == late], since)
    if texts:
        yield Finding("separate peers", tuple(texts), "; ".join(texts.values()))


def uninformed_peers(evidence: Evidence) -> Iterator[Finding]:
    """Yield Zenoh peers that only have a session with a router, which declares nothing to them."""
    obs = evidence.obs
    opened, declares = obs.isin("submessage", "OpenAck"), obs.isin("kind", "Declare")
    for peer in np.flatnonzero(obs.processes["product"].eq("Zenoh peer")).tolist():
        to_it = obs.receiver_index == peer
        others, declared = obs.senders(to_it), (to_it & declares).any()
        seen = (to_it & opened).any() and obs.end - obs.first_last[0][peer] >= LIMITS.timeout
        if seen and others <= obs.servers and not declared:
            text = say("peer at a router", *(ends := obs.hosts_of([peer])), obs.hosts_of(others))
            yield Finding("peer at a router", ends, text)


def _connected_groups(obs: Observations, scope: DiscoveryScope) -> list[set[str]]:
    """Return sets of hosts linked by unicast or a common multicast group, largest first."""
    # A Hello is no link: clients of a Zenoh router answer a Scout, but accept no session.
    rows = obs.isin("protocol", scope.protocol) & ~obs["multicast"] & ~obs.isin("kind", "Hello")
    calls = obs.events("connection", "half", "refused", "unanswered", "exchange")
    links = obs.links_of(obs.messages[rows]) | obs.links_of(calls)
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


def _multicast_targets(obs: Observations) -> dict[str, set[tuple[str, int]]]:
    """Return the multicast groups and ports to which each announcing host sends."""
    looks = obs.links_of(obs.messages[obs.isin("kind", *MULTICAST_KINDS) & obs["multicast"]])
    ports: dict[tuple[str, str], set[int]] = {}
    for _, host, group, port, _ in obs.event_tuples("asked"):
        ports.setdefault((host, group), set()).add(port)
    result: dict[str, set[tuple[str, int]]] = {}
    for host, group in looks:
        own = result.setdefault(host, set())
        own.update((group, port) for port in ports.get((host, group), {0}))
    return result


def _explain_separation(obs: Observations, groups: list[set[str]]) -> Finding:
    targets = _multicast_targets(obs)
    servers = obs.messages["sender"][np.isin(obs.sender_index, [*obs.servers])]
    few = tuple(sorted(set().union(*groups[1:]) - {*servers}))
    text = say("groups apart", "; ".join(listing(sorted(group)) for group in groups))
    looking, served = ([group for group in groups if group & {*of}] for of in (targets, servers))
    if len(looking) > 1:
        sends = {host: [f"{to}, port {port}" for to, port in targets[host]] for host in targets}
        texts = [f"{host} sends to {listing(sorted(to))}" for host, to in sorted(sends.items())]
        return Finding("other group", few, "; ".join(texts))
    if looking and served:
        text = say("discovery by group", sorted(looking[0]), sorted(served[0] - looking[0]))
        seen = obs.processes["product"][np.isin(obs.process_host, [*looking[0]])]
        ignores = len(seen) and not seen.str.contains("Fast DDS|Zenoh").any()
        return Finding("no server there" if ignores else "different discovery", few, text)
    return Finding("different servers" if len(served) > 1 else "separate peers", few, text)
