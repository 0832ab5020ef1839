"""Findings about hosts: duplicate addresses and ids, protocols, missing and dozing hosts."""

from collections import Counter
from collections.abc import Iterator, Sequence
from ipaddress import ip_address
from itertools import chain, product
from statistics import median_high

import numpy as np

from discostorm import _checks, wording
from discostorm_capture._types import Array
from discostorm_capture.diagnosis.evidence import Evidence
from discostorm_capture.diagnosis.finding import LIMITS, Finding
from discostorm_capture.diagnosis.losses import frame_loss
from discostorm_capture.diagnosis.observations import ExpectedHosts, Observations
from discostorm_capture.sentences import join_names, say
from discostorm_capture.zenoh_messages import ZENOH_PORT


def duplicate_address(evidence: Evidence) -> Iterator[Finding]:
    """Yield IP addresses that two MAC addresses use at the same time."""
    obs = evidence.obs
    arp = obs.events("ARP request", "ARP reply", "MAC")
    seen = arp.groupby(["sender", "port"], observed=True)["frame"].agg(["count", "min", "max"])
    seen = seen[seen["count"] >= LIMITS.min_arp_packets]
    for address, macs in seen.groupby(level=0, observed=True):
        # One MAC after the other is no conflict: a host came back with another address.
        at_once = macs["min"].max() < macs["max"].min()
        # Nor are two MACs of one host: Linux answers on each interface for all its addresses.
        own = arp["sender"][arp["port"].isin(macs.index.get_level_values("port"))]
        at_once &= own.nunique() < 2
        if len(macs) > 1 and at_once and str(address) != "0.0.0.0":
            names = [_format_mac(mac) for mac in macs.index.get_level_values("port")]
            text = say("duplicate address", address, names)
            rows = arp[arp["sender"].eq(address) & arp["kind"].eq("MAC")].groupby("port")["frame"]
            ends = [obs.senders(np.isin(obs["frame"], frames)) for _, frames in rows]
            # Processes of one host send from both of its interfaces.
            apart = sum(map(bool, ends)) > 1 and not set.intersection(*ends)
            kind = "same address" if apart else "duplicate address"
            yield Finding(kind, (str(address),), text + say("own processes") * apart)


def taken_addresses(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts for whose addresses a foreign MAC address answers, besides their own."""
    arp = evidence.obs.events("ARP request", "ARP reply")
    arp = arp[arp["sender"].isin([*evidence.obs.host_first_last])]
    if not np.isfinite(evidence.completion_times).any():
        return  # an access point that keeps its clients apart may answer for them
    macs = arp.groupby("sender", observed=True)["port"].agg(set)
    for mac in arp["port"].unique():
        taken = [str(host) for host, of in macs.items() if mac in of and len(of) == 2]
        owners = [macs[host] - {mac} for host in taken]
        # Those of one host with several interfaces are not distinct.
        own = [sum(of & claimed != set() for claimed in macs) for of in owners]
        if len(taken) > 1 and len(set().union(*owners)) == len(taken) and set(own) == {1}:
            yield Finding.of("taken addresses", taken, _format_mac(int(mac)))


def moved_hosts(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts with a new address for which others still look at the old one."""
    obs = evidence.obs
    seen = obs.events("ARP request", "ARP reply", "MAC").query("sender != '0.0.0.0'")
    spans = [
        table.groupby([name, "sender"], observed=True)["time"].agg(["min", "max"])
        for table, name in ((seen, "port"), (obs.messages[obs.sender_index >= 0], "process"))
    ]
    found = dict[str, Finding]()
    for _, times in chain(*(span.groupby(level=0, observed=True) for span in spans)):
        if len(times) != 2:
            continue  # a router has many addresses
        (old, new), span = (str(host) for _, host in times["min"].sort_values().index), times
        begin = span["min"].max()
        asked = [t for (_, to), all_ in obs.unanswered_arp.items() if to == old for t in all_]
        sent = obs.time[obs.isin("receiver", old)]
        late = sum(time > begin for time in asked) + int((sent > begin).sum())
        if span["max"].min() < begin and late >= LIMITS.min_requests:
            found.setdefault(old, Finding.of("new address", (old,), new, begin, late))
    yield from found.values()


def wrong_address_announced(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts that announce only addresses from which they do not send."""
    obs = evidence.obs
    complete = [pair for pair in evidence.all_pairs if np.isfinite(pair.complete_at)]
    working = {pair.observer for pair in complete if pair.n_announced}
    announcing = obs.senders(obs.isin("kind", "SPDP", "Scout") & obs["multicast"])
    wrong: dict[str, dict[str, str]] = {}
    for member in (member for scope in evidence.scopes for member in scope.members):
        announced = tuple(dict.fromkeys(obs.processes["announces"].iloc[member].split()))
        senders = obs.messages["sender"][obs.sender_index == member].astype(str)
        host = "".join(senders[-1:])
        # Skip hosts that send from IPv6 addresses: announced ones are not parsed.
        elsewhere = host and host not in announced and ":" not in host
        if announced and member not in working and elsewhere:
            # A process that multicasts is in this network: NAT and containers drop multicast.
            kind = "wrong interface" if member in announcing else "other address"
            if all(address.startswith("127.") for address in announced):
                kind = "loopback"
            count = int(obs.isin("receiver", *announced).sum())
            answers = f", to which others sent {count} messages" if count else ""
            text = f"{host} announces itself as {join_names(announced)}{answers}"
            wrong.setdefault(kind, {})[host] = text
        elif (
            host and announced and member not in working and (other := _address_in_fleet(obs, host))
        ):
            text = say("other interface", other, host, announced)
            wrong.setdefault("other interface", {}).update({other: text, host: text})
    for kind, texts in wrong.items():
        yield Finding(kind, tuple(texts), "; ".join(dict.fromkeys(texts.values())))


def _address_in_fleet(obs: Observations, host: str) -> str:
    """Return the address of a host in the network of all others, if it sends from another one."""
    arp, others = obs.events("ARP request", "ARP reply"), [*{*obs.host_first_last} - {host}]
    macs = arp["port"][arp["sender"].eq(host)]
    same = {*arp["sender"][arp["port"].isin(macs)].astype(str)} - {host, *others}
    if ":" in host or obs.subnet_neighbors(host, others):
        return ""
    return next((one for one in sorted(same) if obs.subnet_neighbors(one, others) == others), "")


def loopback_only(evidence: Evidence) -> Iterator[Finding]:
    """Yield the host that recorded, if its DDS processes or Zenoh router use only loopback."""
    obs = evidence.obs
    local = np.array([ip_address(host).is_loopback for host in obs.process_host], bool)
    links = obs.links_of(obs.events("exchange", "connection", "other traffic"))
    links |= obs.links_of(obs.messages[~obs["multicast"]])
    pairs = [{*pair} for pair in links if not any(ip_address(end).is_loopback for end in pair)]
    common = set.intersection(*pairs) if pairs else set()
    if len(common) == 2:  # only two hosts exchange packets, of which one may announce itself
        common -= {*obs.process_host[~local]}
    # Nodes of rmw_zenoh reach their router by loopback, and the router reaches other hosts.
    kinds = {"loopback only": obs.is_rtps, "router alone": ~obs.is_rtps & obs.is_server}
    for kind, chosen in kinds.items():
        count = int((local & chosen).sum())
        # DDS may stay on a host whose bridge speaks Zenoh with the others.
        if count and 0 < len(common) < 3 and not common & {*obs.process_host[~local]}:
            # Of two hosts that exchange packets, either may have recorded them.
            hosts = sorted(common) if len(common) == 1 else sorted({*obs.process_host[local]})
            yield Finding.of(kind, hosts, count)


def duplicate_mac(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts that share a MAC address, if one lacks a pair, or frames are lost."""
    obs = evidence.obs
    lacking = {*obs.hosts_of(one for pair in evidence.incomplete_pairs for one in pair.processes)}
    # Skip one host with several addresses: it announces all of them.
    own = [{*text.split()} for text in obs.processes["announces"]]
    for mac, hosts in obs.hosts_by_mac.items():
        # Behind a repeater, hosts share an address and work.
        ill = lacking & hosts or any(one.about == "fleet" for one in frame_loss(evidence))
        if ill and not any(hosts <= one for one in own):
            yield Finding.of("duplicate MAC", sorted(hosts), _format_mac(mac))


def wrong_mac(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts to which another one sends packets under a MAC address that is not theirs."""
    obs, own, used = evidence.obs, dict[str, set[int]](), dict[tuple[str, ...], set[int]]()
    for _, host, _, mac, _ in obs.event_tuples("ARP request", "ARP reply", "MAC"):
        own.setdefault(host, set()).add(mac)
    for _, sender, receiver, mac, _ in obs.event_tuples("to MAC"):
        used.setdefault((sender, receiver), set()).add(mac)
    ends = {obs.hosts_of(pair.processes) for pair in evidence.incomplete_pairs}
    for sender, receiver in sorted(ends | {pair[::-1] for pair in ends}):
        macs, theirs = used.get((sender, receiver), set()), own.get(receiver, set())
        # A host in another subnet gets its packets from a gateway.
        if macs and theirs and not macs & theirs and obs.subnet_neighbors(sender, [receiver]):
            names = ([*map(_format_mac, sorted(of))] for of in (macs, theirs))
            text = say("wrong MAC", receiver, sender, *names)
            yield Finding("wrong MAC", (sender,), text)


def no_arp_answer(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts that multicast, but neither answer ARP requests nor get answers to theirs."""
    obs = evidence.obs
    asked, speakers = obs.unanswered_arp, {*obs.host_first_last}
    quiet = speakers - {sender for sender, to in obs.links_of(obs.messages) if to in speakers}
    texts: dict[str, list[str]] = {}
    answered = {*obs.events("ARP reply")["receiver"].astype(str)}
    asked = {} if quiet == speakers and len(speakers) > 2 else asked  # not the fault of one host
    for (asker, target), times in asked.items():
        host = target if target in speakers else asker
        lasts = len(times) > 2 and np.ptp(times) >= LIMITS.timeout
        lasts &= target in speakers or asker not in answered
        if lasts and host in quiet and (target, asker) not in asked:
            text = f"{asker} sent {len(times)} ARP requests for {target} and got no answer"
            texts.setdefault(host, []).append(text)
    for host, unanswered in texts.items():
        yield Finding.of("wrong route", (host,), "; ".join(unanswered))


def duplicate_process_id(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts with IPv4 addresses of one subnet that use the same process id at one time."""
    # Skip IPv6 (several addresses per host) and servers (the same number gives the same id).
    obs, servers = evidence.obs, np.append(evidence.obs.is_server, True)
    mine = obs.messages[~servers[obs.sender_index]]
    spoke = mine.groupby(["process", "sender"], observed=True)["time"].agg(["min", "max"])
    for name, times in spoke.groupby(level=0, observed=True):
        times = times[[ip_address(host).version == 4 for _, host in times.index]]
        hosts = [str(host) for _, host in times.index]
        subnets = {*obs.subnet_numbers(hosts)}
        if {*hosts} <= {*obs.processes["announces"][str(name)].split()}:
            continue  # one host with several interfaces
        if len(hosts) > 1 and len(subnets) == 1 and times["min"].max() < times["max"].min():
            kind, text = "duplicate id", say("duplicate id", hosts, name)
            closes = obs.messages[obs.isin("kind", "Close") & obs.isin("receiver", *hosts)]
            if len(closes) >= LIMITS.min_calls:  # by who has a session with the other
                kind = "processes with one id"
                text += say("closes again", closes["sender"].unique(), len(closes))
            yield Finding(kind, tuple(hosts), text)


def different_middleware(evidence: Evidence) -> Iterator[Finding]:
    """Report that some hosts speak only DDS and others only Zenoh."""
    speakers: dict[str, set[str]] = {"RTPS": set(), "Zenoh": set()}
    for scope in evidence.scopes:
        speakers[scope.protocol] |= {*scope.hosts}
    # A router without endpoints says nothing about nodes of DDS on its host.
    obs = evidence.obs
    nodes = ~obs.is_rtps & (~obs.is_server | (obs.processes["endpoints"].to_numpy() > 0))
    speakers["Zenoh"] -= speakers["RTPS"] - {*obs.process_host[nodes]}
    calls = obs.event_tuples("connection", "half", "refused", "unanswered")
    # Skip port scanners, which call this port among others.
    ports = Counter(ends[:2] for ends in {row[1:4] for row in calls})
    called = {row[1:3] for row in calls if row[3] == ZENOH_PORT}
    speakers["Zenoh"] |= {ends[0] for ends in called if ports[ends] < LIMITS.port_search}
    dds, zenoh = (sorted(hosts) for hosts in speakers.values())
    if dds and zenoh and not {*dds} & {*zenoh}:
        verbs = ["speaks" if len(hosts) == 1 else "speak" for hosts in (dds, zenoh)]
        few = dds if len(dds) <= len(zenoh) else zenoh
        yield Finding.of("different middleware", few, dds, verbs[0], zenoh, verbs[1])


def different_settings(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts with DDS Security, or without full discovery, if others of their scope differ."""
    obs = evidence.obs
    secured = np.append(obs.processes["secured"].to_numpy(bool), False)
    mixed = (obs.sender_index >= 0) & (obs.receiver_index >= 0)
    # Those without it keep asking those with it, which answer by announcements alone.
    mixed &= secured[obs.sender_index] & ~secured[obs.receiver_index] & ~obs.isin("kind", "SPDP")
    kinds = {"static": "static discovery", "half": "half", "secured": "different security"}
    for scope, (setting, kind) in product(evidence.scopes, kinds.items()):
        given = obs.processes.iloc[[*scope.members]]
        on, off = (sorted({*given["host"][given[setting] == way]}) for way in (True, False))
        # Security is no obstacle if hosts with and without it exchange messages.
        if on and off and not (setting == "secured" and mixed.any()):
            yield Finding.of(kind, on if len(on) <= len(off) else off, on, off)


def different_clocks(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts whose clock differs, by the time stamps of their new samples."""
    clocks, obs = dict[str, float](), evidence.obs
    if obs.recording.clock_steps:
        return  # the recorder's own clock was set, or files were merged
    for host, rows in obs.events("time stamp").groupby("sender", observed=True):
        ahead = (rows["port"] - rows["time"]).to_numpy()
        late = np.flatnonzero(ahead >= ahead.max() - LIMITS.max_age_difference)[-1] + 1
        old = ahead[late:][ahead[late:] >= ahead[late:].max(initial=0) - LIMITS.max_age_difference]
        back = float(ahead.max() - old.max(initial=0))
        if len(old) >= LIMITS.min_new_samples and back >= LIMITS.min_clock_difference:
            step = wording.duration(back), rows["time"].iloc[late]
            yield Finding.of("clock steps", (str(host),), *step)
        # Only the newest time stamps count: retransmitted samples carry an old one.
        elif (ahead >= ahead.max() - LIMITS.max_age_difference).sum() >= LIMITS.min_new_samples:
            clocks[str(host)] = ahead.max()
    usual = median_high(clocks.values()) if clocks else 0.0
    apart = {host: one - usual for host, one in clocks.items()}
    apart = {host: one for host, one in apart.items() if abs(one) >= LIMITS.min_clock_difference}
    if apart:  # without a majority, each clock may be the wrong one
        hosts = tuple(sorted(clocks if 2 * len(apart) >= len(clocks) else apart))
        ways = {host: "behind the" if one < 0 else "ahead of the" for host, one in apart.items()}
        said = [f"{h}'s clock is {wording.duration(abs(apart[h]))} {ways[h]} others" for h in ways]
        yield Finding.of("clock differs", hosts, said)


def isolated_hosts(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts that ask by ARP in vain for a host, though all of them reach a third one."""
    obs = evidence.obs
    talks: dict[str, set[str]] = {}
    for one, other in obs.links_of(obs.events("other traffic", "connection", "exchange")):
        talks.setdefault(one, set()).add(other)
        talks.setdefault(other, set()).add(one)
    vain: dict[str, dict[str, int]] = {}
    for (asker, target), times in obs.unanswered_arp.items():
        often = len(times) >= LIMITS.min_unanswered and np.ptp(times) >= LIMITS.timeout
        if often and talks.get(asker, set()) & talks.get(target, set()):
            vain.setdefault(target, {})[asker] = len(times)
    texts, hosts = list[str](), dict[str, None]()
    for target, asks in vain.items():
        common = sorted(set.intersection(*(talks[one] for one in (target, *asks))))
        if len(asks) > 1 and common:
            counts = join_names([f"{of}: {count}" for of, count in asks.items()])
            texts.append(say("isolated", target, counts, common))
            hosts |= dict.fromkeys((target, *asks))
    if texts:
        rest = wording.count_noun(len(texts) - 1, "other host")
        more = f"; likewise for {rest}" if len(texts) > 1 else ""
        yield Finding("client isolation", tuple(hosts), texts[0] + more)


def addresses_without_arp_reply(evidence: Evidence) -> Iterator[Finding]:
    """Yield addresses that hosts request by ARP: servers, if the capture has no messages."""
    obs = evidence.obs
    arp = obs.events("ARP request", "ARP reply")["sender"]
    there = {*obs.host_first_last, *arp, *obs.announced_addresses}
    requests: dict[str, dict[str, int]] = {}
    for (asker, target), times in obs.unanswered_arp.items():
        # Others may call it, for example by SSH.
        calls = obs.events("ARP request", "connection").query("sender == @asker")
        idle = asker not in obs.host_first_last and calls["receiver"].eq(target).all()
        often = len(times) >= LIMITS.min_requests and np.ptp(times) >= LIMITS.timeout
        used = obs.subnet_neighbors(asker, obs.hosts_of(sorted(obs.servers)))
        if idle and often and used and target not in there:
            yield Finding.of("wrong server", (asker,), len(times), target, used)
        known = asker in obs.host_first_last or obs.messages.empty
        if known and target not in there and np.ptp(times) >= LIMITS.timeout:
            requests.setdefault(target, {})[asker] = len(times)
    for target, counts in requests.items():
        kind, text = "server off" if obs.messages.empty else "absent", ""
        if target in obs.process_host and not obs.subnet_neighbors(target, counts):
            kind, text = "no route", "; other hosts announced a process at this address"
            if near := obs.subnet_neighbors(target, sorted(obs.announced_addresses)):
                text += say("same network", near, "is" if len(near) == 1 else "are")
        asks = join_names([f"{of} sent {times}" for of, times in counts.items()])
        yield Finding(kind, (target,), f"ARP requests for {target} got no answer ({asks}){text}")


def hosts_of_other_subnets(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts without messages that exchange packets with several hosts from another subnet."""
    obs, known = evidence.obs, evidence.obs.host_first_last
    links = obs.links_of(obs.events("other traffic", "connection"))
    partners: dict[str, list[str]] = {}
    for one, other in sorted(links):
        private = ip_address(one).is_private and not ip_address(one).is_loopback
        if private and other in known and one not in known and (other, one) in links:
            partners.setdefault(one, []).append(other)
    for host, others in partners.items():
        if len(others) > 1 and not obs.subnet_neighbors(host, [*known]):
            yield Finding.of("outsider", (host,), others)


def parse_expected_hosts(expected: int | Sequence[str] | None) -> ExpectedHosts:
    """Return the expected number of hosts, or their addresses in the form that captures use.

    Raises a ValueError for an invalid or repeated address, and a TypeError for a single string.
    """
    if expected is None:
        return None
    if isinstance(expected, int):
        _checks.integer("expected", expected, 1, _checks.MAX_COUNT)
        return expected
    addresses = []
    for text in _checks.tuple_of("expected", expected, str):
        try:
            addresses.append(str(ip_address(text.strip())))
        except ValueError:
            raise ValueError(say("expected", _checks.shorten_name(text))) from None
    _checks.distinct("expected", addresses, "addresses")
    return tuple(addresses)


def missing_expected_hosts(evidence: Evidence) -> Iterator[Finding]:
    """Yield expected hosts that announced nothing."""
    obs, expected = evidence.obs, evidence.obs.expected_hosts
    present = {str(host) for scope in evidence.scopes for host in scope.hosts}
    there = {*obs.network_events["sender"].astype(str)}
    if isinstance(expected, int):
        seen = sorted(present - obs.server_hosts)
        if len(seen) >= expected:
            return
        text = f"the capture shows {len(seen)} of {expected} expected hosts"
        text += f" ({join_names(seen)})" if seen else ""
        if apart := present & obs.server_hosts:
            text += f", not counting {join_names(sorted(apart))}, which seems to be a server"
        often = [(*of, len(times)) for of, times in obs.unanswered_arp.items() if of[0] in seen]
        sought = [of[:2] for of in often if of[1] not in there and of[2] >= LIMITS.min_unanswered]
        mute = obs.subnet_neighbors(seen[0], sorted(there - present)) if seen else []
        if sought:
            text += say("seeks nobody", [f"{by} for {of}" for by, of in sought])
            text += say("mute", mute) if mute else ""
            callers = tuple(dict.fromkeys(by for by, _ in sought))
            yield Finding("too few hosts, wrong address", callers, text)
            return
        if len(mute) != expected - len(seen):
            yield Finding("too few hosts", (), text)
            return
        expected = (*seen, *mute)  # the only hosts that can be the missing ones
    if absent := tuple(host for host in expected or () if host not in present):
        routers = {*obs.hosts_of(obs.servers)} - {obs.vantage_host}
        if obs.vantage_host and routers and not obs.is_rtps.any():
            yield Finding.of("maybe missing", absent, obs.vantage_host, sorted(routers))
            return
        silent = [host for host in absent if obs.network_events["sender"].eq(host).any()]
        text = f"{len(absent)} of {len(expected or ())} expected hosts announced nothing: "
        text += join_names(absent)
        text += ", the only other hosts there" if isinstance(obs.expected_hosts, int) else ""
        if silent:
            they = "it is" if len(silent) == 1 else "they are"
            text += f"; {join_names(silent)} sent other packets, so {they} on the network"
        vain = [pair for pair in obs.unanswered_arp if pair[0] in silent and pair[1] not in there]
        if asks := [f"{by} asked for {of}" for by, of in vain]:
            text += f"; {join_names(asks)} by ARP, and got no answer"
        on = "missing, but on" if obs.is_rtps.any() or not present else "missing, no session"
        kind = "missing" if len(silent) < len(absent) else on
        if present and not any(":" in of or obs.subnet_neighbors(of, present) for of in absent):
            kind = "missing, other subnet"
        if found := _seen_by_recorder(obs, present, absent, silent):
            kind, text = found[0], text + found[1]
        own = obs.network_events.groupby("sender", observed=True)["time"].min()[silent].min()
        late = obs.time.min(initial=np.inf) + LIMITS.min_wait < own < obs.end - LIMITS.timeout
        if kind == on and late:
            text += f", but it sent its first packet only at {own:.1f} s"
            kind = "missing, late network"
        names = Counter(row[2] for row in obs.event_tuples("unknown name") if row[2] in silent)
        if names.total() >= LIMITS.min_calls:
            replies = [f"{host} ({count} times)" for host, count in names.items()]
            text += f"; DNS replied to {join_names(replies)} that a name does not exist"
            kind = "missing, unknown name"
        yield Finding("missing, wrong address" if asks else kind, absent, text)


def _seen_by_recorder(
    obs: Observations, present: set[str], absent: tuple[str, ...], silent: list[str]
) -> tuple[str, str] | None:
    """Return a kind and a clause if the recording host's unicast shows why hosts are missing."""
    pairs = obs.links_of(obs.events("exchange", "connection"))
    reached = {b for a, b in pairs if {a} == present and obs.subnet_neighbors(a, [b])}
    in_vain = {(a, b) for a in present for b in absent} <= {*obs.unanswered_arp}
    if len(absent) > 1 and not silent and in_vain and reached:
        return "missing, isolated", say("reaches", sorted(present), sorted(reached))
    sent = obs.links_of(obs.events("other traffic"))
    groups = {one for one, to in sent if ip_address(to).is_multicast}
    most = len(silent) == len(absent) or len(present) == 1
    if len(silent) > 1 and most and not groups & {*silent} and obs.is_rtps.any():
        return "missing, no multicast", ""
    others = [host for host in sorted(present) if not obs.subnet_neighbors(host, absent)]
    alone = len(absent) == len(silent) == len(others) == 1
    if alone and pairs and all(absent[0] in pair for pair in pairs):
        return "missing, other interface", say("other address", *absent, *others)
    return None


def _format_mac(number: int) -> str:
    return ":".join(f"{octet:02x}" for octet in int(number).to_bytes(6, "big"))


def power_saving(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts that confirm samples in evenly spaced bursts, although writers ask more often."""
    obs, confirmed, beats = evidence.obs, dict[str, list[float]](), dict[str, list[float]]()
    beat = obs.isin("submessage", "HEARTBEAT") & ~obs["multicast"]
    asked_by = obs.rows_by(beat, obs.sender_index, obs["writer"])
    for subject, observer, rows, asks in evidence.answered_samples:
        host = obs.process_host[observer]
        news = asks[np.diff(np.maximum.accumulate(obs.seq[asks]), prepend=1) > 0]
        # Most samples of other writers need no confirmation.
        if len(rows) and len(news) >= LIMITS.min_bursts:
            confirmed.setdefault(host, []).extend(obs.time[news].tolist())
            own = asked_by.get((subject, int(obs["writer"][rows[0]])), rows[:0])
            beats.setdefault(host, []).extend(
                obs.time[own[obs.isin("receiver", host)[own]]].tolist()
            )
    for host, times in confirmed.items():
        bursts = _burst_times(np.array(times))
        gaps = np.diff(bursts)
        if len(gaps) < LIMITS.min_bursts or (period := float(np.median(gaps))) < LIMITS.min_sleep:
            continue
        steady = (np.abs(gaps - period) < 0.1 * period).mean() >= LIMITS.min_steady_share
        asked = np.array(beats[host])
        asked = _burst_times(asked[(asked >= bursts[0]) & (asked <= bursts[-1])])
        if steady and len(asked) > 2 * len(bursts):
            yield Finding.of("power saving", (host,), len(bursts), period, len(asked))


def held_back_packets(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts that pause again and again, and then send all samples of the pause at once."""
    obs = evidence.obs
    for (process,), rows in obs.rows_by(obs["user"].astype(bool), obs.sender_index).items():
        sent = np.unique(obs.time[rows])
        if process < 0 or len(sent) < LIMITS.min_messages:
            continue
        pauses, rate = np.diff(sent), len(sent) / np.ptp(sent)
        usual = float(np.median([*np.diff(_burst_times(sent)), np.inf]))
        long = np.flatnonzero(pauses > max(LIMITS.max_transit, LIMITS.min_pause_ratio * usual))
        after = sent[long + 1] + LIMITS.max_burst_pause
        burst = np.searchsorted(sent, after) - long - 1
        long = long[burst >= np.maximum(LIMITS.min_messages, pauses[long] * rate / 2)]
        if len(long) >= LIMITS.min_calls:
            spans = pauses[long]
            yield Finding.of(
                "held back", obs.hosts_of([process]), len(long), spans.min(), spans.max()
            )


def _burst_times(times: Array) -> Array:
    """Return the first time of each burst [s]."""
    times = np.unique(times)
    return np.asarray(times[np.diff(times, prepend=-np.inf) > LIMITS.max_burst_pause])
