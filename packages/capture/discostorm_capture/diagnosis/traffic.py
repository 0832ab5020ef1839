"""Findings about traffic: storms, unresponsive servers and vanished packets."""

from collections import Counter, defaultdict
from collections.abc import Iterator
from itertools import chain

import numpy as np

from discostorm import wording
from discostorm.data import read_data
from discostorm_capture._types import Array
from discostorm_capture.diagnosis import losses
from discostorm_capture.diagnosis.evidence import Evidence
from discostorm_capture.diagnosis.finding import LIMITS, Finding
from discostorm_capture.diagnosis.observations import ACKNACK, HEARTBEAT, SEDP, Observations
from discostorm_capture.diagnosis.pairs import server_clients
from discostorm_capture.endpoints import ros_topic
from discostorm_capture.sentences import join_names, say
from discostorm_capture.zenoh_messages import READABLE_VERSIONS, ZENOH_PORT

FLOOD_KINDS = (SEDP, HEARTBEAT, ACKNACK, "Gap", "SPDP", "SPDP Heartbeat", "SPDP ACKNACK")
#: Names of ROS 2 software other than DDS and Zenoh, by UDP port.
_SERVICES = read_data("vendors/service_ports.csv", "discostorm_capture")
SERVICE_PORTS = {int(row["port"]): f"{row['port']} ({row['what']})" for row in _SERVICES}
FIRST_USER_PORT = 1024
#: Headers of IPv4 with TCP and with UDP; the size of fragments; the smallest packet that an MTU can
#: drop, because every IPv4 network passes 576 bytes (RFC 791) [B].
TCP_HEADER_BYTES, UDP_HEADER_BYTES, ETHERNET_MTU, LARGE_PACKET = 40, 28, 1500, 577
#: The reason of a Close by a Zenoh router that has too many sessions, among others (zenoh-protocol,
#: transport/close.rs, reason INVALID; staged with Zenoh 1.10.2).
_CLOSE_INVALID = 2


def continuing_storm(evidence: Evidence) -> Iterator[Finding]:
    """Report that endpoints are still announced repeatedly at the end of the capture."""
    obs = evidence.obs
    times = obs.time[obs.isin("kind", SEDP) & ~obs["ends"]]
    third = (obs.end - times.min(initial=obs.end)) / 3
    if third * 3 < LIMITS.min_storm_time:
        return
    last = times[times > times[0] + 2 * third]
    if len(np.unique(last.astype(np.int64))) < LIMITS.min_storm_share * third:
        return
    ends = evidence.endpoints
    own = obs.sender_index[obs.isin("kind", SEDP) & obs["ends"] & (obs.time > last[0])]
    for process, gone in Counter(own[own >= 0].tolist()).most_common(1):
        if gone >= LIMITS.min_storm_share * len(last):
            topics = ends["topic"][ends["index"] == process].map(ros_topic).unique()
            host = obs.hosts_of([process])
            yield Finding.of("endpoints come and go", host, len(last), topics, gone)
            return
    new = obs.rows_by(obs.isin("kind", SEDP) & (obs.time >= last[0]), obs.sender_index, obs.seq)
    is_new = [key in new for key in zip(ends["index"], ends["number"], strict=True)]
    counts = ends[np.array(is_new, bool)].value_counts(["index", "topic", "writer"])
    if counts.max() >= max(LIMITS.min_repeats, LIMITS.min_storm_share * len(new)):
        process, topic, _ = counts.index[0]
        values = int(counts.max()), ros_topic(topic), third
        yield Finding.of("endpoints pile up", obs.hosts_of([process]), *values)
        return
    first = times[times <= times[0] + third]
    yield Finding.of("storm", (), len(last), third, len(first))


def network_loop(evidence: Evidence) -> Iterator[Finding]:
    """Report that most multicast packets are duplicates, as in a network with a loop."""
    if (repeated := evidence.obs.recording.duplicate_multicast_share) > LIMITS.min_loop_share:
        yield Finding.of("network loop", (), wording.percent(repeated))


def message_flood(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts that keep repeating discovery messages although all endpoints are known."""
    obs = evidence.obs
    complete, lasting = max(evidence.completion_times, default=np.inf), int(LIMITS.flood_time)
    begin = obs.end - lasting
    if complete + LIMITS.startup_time > begin:
        return
    rows = (obs.time > begin) & obs.isin("kind", *FLOOD_KINDS) & ~obs["multicast"]
    receiver = obs.messages["receiver"].cat.codes.to_numpy()
    keys = (obs.sender_index, receiver, obs["writer"], obs["reader"])
    floods = Counter[tuple[str, ...]]()
    for group in obs.rows_by(rows, *keys).values():
        seconds = np.bincount((obs.time[group] - begin).astype(np.int64), minlength=lasting)
        if seconds[:lasting].min() >= LIMITS.flood_rate:
            what = obs.messages.iloc[group[0]][["sender", "receiver", "kind"]]
            floods[tuple(map(str, what))] += len(group)
    for caller, server in _other_server_numbers(obs):  # both ask again and again
        floods = Counter({of: n for of, n in floods.items() if {*of[:2]} != {caller, server}})
    if not floods:
        return
    flows = [f"{kind} from {one} to {other}" for one, other, kind in floods]
    text = say("flood", floods.total() / lasting, lasting, complete, flows)
    senders = tuple(dict.fromkeys(sender for sender, *_ in floods))
    for host in senders:
        # If two processes share an id, the one unknown to others floods them.
        ports = {row[3] for row in obs.event_tuples("asked") if row[2] == host and row[3] % 2 == 0}
        if len(ports) > (obs.process_host == host).sum() == 1:
            text += (
                f"; others know only one process on {host}, but send to {len(ports)} of its ports"
            )
            yield Finding("processes with one id", (host,), text)
            return
    only_spdp = {kind for *_, kind in floods} == {"SPDP"}
    yield Finding("announces often" if only_spdp else "flood", senders, text)


def unresponsive_servers(evidence: Evidence) -> Iterator[Finding]:
    """Yield servers and routers that do not answer, or that refuse."""
    obs = evidence.obs
    findings = [*_unresponsive_dds_servers(obs), *_unresponsive_routers(obs)]
    twins: dict[tuple[str, ...], list[str]] = {}
    for (caller, host), count in _other_server_numbers(obs).items():
        # A server's number determines its id.
        own = np.isin(obs.sender_index, obs.sender_index[obs.isin("sender", host)])
        alike = obs.messages["sender"][own & (obs.sender_index >= 0)].unique()
        if not {*alike} <= obs.announced_addresses:
            twins.setdefault(tuple(sorted(alike)), []).append(f"{caller} ({count} times)")
        else:
            findings.append(Finding.of("server number", (caller,), host, count))
    findings += [Finding.of("same server number", hosts, of) for hosts, of in twins.items()]
    reported = {host for one in findings for host in one.hosts} | {*obs.host_first_last}
    refused, heard = obs.event_tuples("unreachable"), obs.host_first_last
    # Ports below 1024 belong to other programs, such as syslog (RFC 6335).
    calls = [row for row in refused if row[1] in heard and row[2] not in reported]
    calls = [row for row in calls if row[3] >= FIRST_USER_PORT]
    # Cyclone DDS searches for its peers at several ports, and most of them are closed.
    tried = Counter(row[1:3] for row in obs.event_tuples("asked"))
    calls = [row for row in calls if tried[row[1:3]] < LIMITS.port_search]
    calls += [row for row in refused if row[3] in SERVICE_PORTS and row not in calls]
    for host, count in Counter(row[2] for row in calls).items():
        if count >= LIMITS.min_calls:
            who, ports = ({row[at] for row in calls if row[2] == host} for at in (1, 3))
            names = [SERVICE_PORTS.get(int(port), str(port)) for port in sorted(ports)]
            findings.append(Finding.of("refuses", (host,), sorted(who), names, count))
    # Skip hosts that others answer: they did send messages, though the capture lacks them.
    yield from (one for one in findings if not {*one.hosts} & {*evidence.silent_hosts})


def _unresponsive_dds_servers(obs: Observations) -> Iterator[Finding]:
    """Yield Discovery Servers that do not answer clients of Fast DDS."""
    end = max(obs.end, obs.network_events["time"].max() if len(obs.network_events) else 0.0)
    calls = obs.isin("kind", "SPDP", "SPDP Heartbeat", "SPDP ACKNACK") & ~obs["multicast"]
    calls &= np.isin(obs.sender_index, [*server_clients(obs)])
    # A client that confirms samples was answered, though the capture may lack the answers.
    heard = obs.isin("submessage", "ACKNACK") & (obs.seq > 1) & ~obs["multicast"]
    by_server: dict[str, dict[str, Array]] = {}
    searching = obs.senders(obs.isin("kind", "SPDP") & obs["multicast"]) - server_clients(obs)
    for caller, host in sorted(obs.links_of(obs.messages[calls])):
        back = obs.isin("sender", host) & obs.isin("receiver", caller)
        there = calls & obs.isin("sender", caller) & obs.isin("receiver", host)
        there &= obs.time > obs.time[back].max(initial=-np.inf)
        by_server.setdefault(host, {})[caller] = obs.time[there]
    for host, times in by_server.items():
        # Calls that are repeated often were not answered.
        least = LIMITS.min_messages / len(times)
        often = {of: calls for of, calls in times.items() if len(calls) >= least}
        failed = [of for of, calls in often.items() if end - calls[0] >= LIMITS.min_wait]
        count = sum(len(times[caller]) for caller in failed)
        if count < LIMITS.min_messages:
            continue
        served = sorted({*times} - {*failed})
        asks = f"{count} messages from {wording.count_noun(len(failed), 'host')}"
        text = "got no answer"
        if refused := obs.events("unreachable")["receiver"].eq(host).sum():
            text += f"; {refused} ICMP replies say that no process uses the port"
        arp = obs.events("ARP request", "ARP reply")["sender"].eq(host).sum()
        asked = {row[1:4] for row in obs.event_tuples("asked") if row[2] == host}
        tried = {port for caller, _, port in asked if caller in failed}
        answers = {port for caller, _, port in asked if caller in served}
        free = sorted({*obs.hosts_of(searching)} - {*failed})
        if answers and tried - answers:
            ports = sorted(tried - answers), f"{asks} {text}", sorted(answers)
            yield Finding.of("wrong port", failed, host, *ports)
        elif not served and len(free) > len(failed):
            yield Finding.of("different discovery", failed, host, f"{asks} {text}", free)
        elif not served:
            last = obs.host_first_last.get(host, (0, -np.inf))[1]
            since = "" if np.isinf(last) else f" after {last:.1f} s"
            spoke = f"{host} sent no discovery messages{since}"
            to = f"port {join_names([*map(str, sorted(tried))])} on {host}" if tried else host
            kind = "server down"
            if arp and not refused and np.isinf(last):  # without a process, it would send ICMP
                kind, spoke = "server blocked", say("on by ARP", arp)
            yield Finding(kind, (host,), f"{asks} to {to} {text}; {spoke}")
        elif not (heard & obs.isin("sender", *failed)).any():
            yield Finding.of("unserved", failed, host, f"{count} times", served)


def _other_server_numbers(obs: Observations) -> dict[tuple[str, str], int]:
    """Return clients that ask a server only for a number that it does not have, and how often."""
    asks = obs.isin("kind", "SPDP Heartbeat", "SPDP ACKNACK") & ~obs["multicast"]
    asks &= np.isin(obs.sender_index, [*server_clients(obs)])
    serves = obs.links_of(obs.messages[np.isin(obs.sender_index, [*obs.servers])])
    found = dict[tuple[str, str], int]()
    for caller, host in sorted(obs.links_of(obs.messages[asks])):
        to_it = asks & obs.isin("sender", caller) & obs.isin("receiver", host)
        many = to_it.sum() >= LIMITS.min_messages and host in {by for by, _ in serves}
        if many and (obs.receiver_index[to_it] < 0).all():
            found[caller, host] = int(to_it.sum())
    return found


def _unresponsive_routers(obs: Observations) -> Iterator[Finding]:
    """Yield Zenoh routers that refuse connections or do not answer."""
    peers = {*obs.process_host} - {*obs.process_host[obs.is_server]}
    arp = obs.event_tuples("ARP request", "ARP reply")
    calls = obs.event_tuples("connection", "refused", "unanswered", "unreachable")
    taken = {(host, port): time for kind, _, host, port, time in calls if kind == "connection"}
    tries = defaultdict[tuple[str, str, int], list[float]](list)
    for _, caller, host, port, time in (row for row in calls if row[0] == "connection"):
        tries[caller, host, port].append(time)
    failed: dict[tuple[str, int, bool], list[tuple[str, str, float]]] = {}
    vain: dict[tuple[str, int, bool], list[tuple[str, float]]] = {}
    for kind, caller, host, port, time in calls:
        by_udp = kind == "unreachable"
        others = not by_udp and (host, port) in taken and (caller, host, port) not in tries
        if others and host not in peers and obs.host_first_last.get(host, (0.0, 0.0))[1] > time:
            vain.setdefault((host, port, kind == "refused"), []).append((caller, time))
        elif (port == ZENOH_PORT) if by_udp else time > taken.get((host, port), -np.inf):
            failed.setdefault((host, port, by_udp), []).append((kind, caller, time))
    for (host, port, is_early), rows_of in vain.items():
        if obs.host_first_last[host][1] - min(time for _, time in rows_of) > 2 * LIMITS.min_wait:
            unheard = sorted({caller for caller, _ in rows_of})
            served = sorted({one for one, *at in tries if at == [host, port]})
            how = f"{wording.count_noun(len(rows_of), 'time')} on TCP port {port}"
            kind = "called early" if is_early else "unserved"
            yield Finding.of(kind, unheard, host, how, served)
    half = Counter(row[1:4] for row in obs.event_tuples("half"))
    for (caller, host, port), count in half.items():
        if count >= LIMITS.min_calls and (caller, host, port) not in tries:
            yield Finding.of("no way back", (caller,), host, count, port)
    spoke = obs.links_of(obs.messages[obs.isin("protocol", "Zenoh")])
    yield from _unopened_sessions(obs, tries, spoke)
    for (host, port, by_udp), rows in failed.items():
        kinds, callers, times = zip(*rows, strict=True)
        # Of two peers that list each other, one may refuse.
        links = {pair for of in callers for pair in ((of, host), (host, of))}
        known = host in peers and (port != ZENOH_PORT or links & spoke)
        if known or len(rows) < LIMITS.min_calls or np.ptp(times) < LIMITS.min_wait:
            continue
        counts = Counter(kinds).most_common()
        text = join_names([f"{wording.count_noun(n, 'attempt')} {kind}" for kind, n in counts])
        who = tuple(sorted({*callers}))
        if by_udp and (host, ZENOH_PORT) in taken:
            yield Finding("wrong port", who, say("TCP instead", who, host, ZENOH_PORT, text))
        elif port != ZENOH_PORT and (host, ZENOH_PORT) in taken:
            yield Finding.of("wrong port", who, host, port, text, ZENOH_PORT)
        elif port == ZENOH_PORT:
            by = wording.count_noun(len(who), "host")
            text = f"{by} failed to connect to port {ZENOH_PORT} on {host} ({text})"
            if (host, port) in taken:
                text += f"; the last successful connection opened at {taken[host, port]:.1f} s"
            if host in peers and (used := obs.hosts_of(sorted(obs.servers))):
                yield Finding("wrong router", who, text + say("router of others", host, used))
                continue
            last = max([time for _, of, *_, time in arp if of == host], default=-np.inf)
            last = max(last, obs.host_first_last.get(host, (0.0, last))[1])
            asked, kind = [row for row in arp if row[2] == host and row[4] > last], "server down"
            if {*kinds} == {"unanswered"} and last >= min(times) - LIMITS.max_transit:
                kind = "server firewall"  # it answered ARP just before the first call, or later
            elif {*kinds} == {"unanswered"} and len(asked) >= LIMITS.min_unanswered:
                kind = "server off"
            yield Finding(kind, (host,), text)


def _unopened_sessions(
    obs: Observations, tries: dict[tuple[str, str, int], list[float]], spoke: set[tuple[str, str]]
) -> Iterator[Finding]:
    """Yield why no session began on TCP connections, given their times by caller, host and port.

    `spoke` has the pairs of hosts of which the first sent the second Zenoh messages.
    """
    opened = obs.links_of(obs.messages[obs.isin("submessage", "OpenAck")])
    began = obs.links_of(obs.messages[obs.isin("submessage", "InitSyn")])
    arrived = obs.links_of(obs.events("arrived"))
    ended: dict[tuple[str, str], list[str]] = {}
    limited: dict[str, str] = {}
    for (caller, host, port), begins in tries.items():
        few = (count := len(begins)) < LIMITS.min_calls and np.ptp(begins) < LIMITS.max_pause
        if few or {(caller, host), (host, caller)} & opened:
            continue
        calls = f"{count} from {caller} to port {port}"
        text = f"{caller} opened {count} connections to port {port} on {host}, and "
        if (caller, host) in began and host not in {one for one, _ in spoke}:
            if (host, caller) not in arrived:
                ended.setdefault(("no router behind", host), []).append(calls)
            else:
                text += "sent unencrypted Zenoh messages, to which no Zenoh came back, as from TLS"
                yield Finding("wrong port", (caller,), text)
        elif (caller, host) in began:
            text += "each was closed before a session began"
            kind, versions = "session refused", obs.processes["version"]
            old, new = ({*versions[obs.process_host == end]} - {0} for end in (caller, host))
            newest = max(READABLE_VERSIONS)
            if old and not old & (new or {newest}):
                ends = max(old), max(new, default=newest)
                kind, said = "different releases", "both versions" if new else "old version"
                text += say(said, *ends)
            closes = obs.isin("kind", "Close") & obs.isin("sender", host)
            closes &= obs.isin("receiver", caller) & (obs.seq == _CLOSE_INVALID)
            if kind == "session refused" and closes.any() and host in {*chain(*opened)}:
                limited[caller] = text
            else:
                yield Finding(kind, (caller,), text)
        elif port == ZENOH_PORT and any(other == host for _, other in spoke):
            if (caller, host) in arrived:  # else it only checks whether the port is open
                yield Finding("wrong port", (caller,), text + say("no plain Zenoh"))
        elif port == ZENOH_PORT and obs.messages.empty:
            good = sorted(
                one
                for (one, *at), of in tries.items()
                if at == [host, port] and len(of) < LIMITS.min_calls
            )
            if good:
                yield Finding.of("TLS client", (caller,), host, count, good)
            else:
                ended.setdefault(("TLS fails", host), []).append(calls)
    if limited:
        yield Finding("session limit", tuple(limited), "; ".join(limited.values()))
    for (kind, host), texts in ended.items():
        yield Finding.of(kind, (host,), texts)


def vanished_packets(evidence: Evidence) -> Iterator[Finding]:
    """Yield pairs of hosts between which only large packets vanish, or TCP segments do."""
    obs, large = evidence.obs, {}
    for pair, (arrived, lost) in _packet_sizes(evidence).items():
        # Fragments that were captured at their receiver have arrived.
        whole = len(obs.events("incomplete")) and obs.vantage_host == pair[1]
        passed_size = max(max(arrived, default=0), LARGE_PACKET)
        many = len(lost) >= losses.SEGMENT_LOSS[0] and len(arrived) > 0
        if many and min(lost) > passed_size and not whole:
            large[pair] = max(arrived), min(lost), len(lost)
    yield from _uncaptured_samples(obs)
    parts = obs.events("incomplete").query(f"port > {ETHERNET_MTU}")
    for host, sizes in parts.groupby("sender", observed=True)["port"]:
        if len(sizes) >= LIMITS.min_messages:
            yield Finding.of("jumbo frames", (str(host),), sizes.max(), len(sizes))
    if large:
        passed, least, counts = zip(*large.values(), strict=True)
        flows = [f"from {one} to {other}" for one, other in large]
        text = say("large packets", flows, max(passed), min(least), sum(counts))
        both = tuple(dict.fromkeys(chain(*large)))
        who = tuple(sorted({row[2] for row in obs.event_tuples("parts missing")} & {*both}))
        kind, text = ("reassembly", say("gives up", text, who)) if who else ("large packets", text)
        yield Finding(kind, who or both, text)
    deaf: dict[tuple[str, str], str] = {}
    for _, sender, receiver, payload, time in obs.event_tuples("vanished"):
        later = (obs.time > time) & (obs.time < time + LIMITS.min_wait)
        # Skip receivers that send nothing meanwhile: they are out of range, or restart.
        if (sender, receiver) not in large and (later & obs.isin("sender", receiver)).any():
            text = f"{sender} to {receiver} ({payload} bytes, first sent at {time:.1f} s)"
            deaf.setdefault((sender, receiver), text)
    if deaf:
        ends = list(dict.fromkeys(chain(*deaf)))
        common = [host for host in ends if all(host in pair for pair in deaf)]
        yield Finding.of("unacknowledged", common or ends, [*deaf.values()])


def _uncaptured_samples(obs: Observations) -> Iterator[Finding]:
    """Yield hosts whose user samples are requested but never captured."""
    sent = obs.rows_by(obs.isin("kind", "User data"), obs.sender_index, obs["writer"])
    asks = obs.isin("kind", "User ACKNACK") & (obs["missing"] > 0) & (obs.receiver_index >= 0)
    pairs: dict[tuple[str, ...], int] = {}
    for key, rows in obs.rows_by(asks, obs.receiver_index, obs["writer"], obs.sender_index).items():
        many = len(rows) >= LIMITS.min_calls and np.ptp(obs.time[rows]) >= LIMITS.min_wait
        ends = obs.hosts_of((key[0], key[2]))
        if many and key[:2] not in sent and len(ends) == 2:
            pairs[ends] = pairs.get(ends, 0) + len(rows)
    if pairs and not obs.recording.gaps:
        asked = [f"{to} asked {of} for samples {n} times" for (of, to), n in pairs.items()]
        ends = tuple(dict.fromkeys(chain(*pairs)))
        yield Finding("large packets", ends, say("large samples", asked))


def _packet_sizes(evidence: Evidence) -> dict[tuple[str, ...], tuple[list[int], list[int]]]:
    """Return sizes of packets that arrived and that vanished, by sending and receiving host [B]."""
    obs, sizes_by_pair = evidence.obs, dict[tuple[str, ...], tuple[list[int], list[int]]]()
    for kind, sender, receiver, payload, _ in obs.event_tuples("arrived", "vanished"):
        lost = kind == "vanished"
        sizes = sizes_by_pair.setdefault((sender, receiver), ([], []))
        # A vanished segment was sent at least this often.
        sizes[lost].extend([payload + TCP_HEADER_BYTES] * (losses.SEGMENT_LOSS[0] if lost else 1))
    size = np.bincount(obs["frame"], obs["bytes"]).astype(np.int64)
    size = np.minimum(size + UDP_HEADER_BYTES, ETHERNET_MTU)
    for subject, observer, rows, asks in evidence.answered_samples:
        ends = obs.hosts_of((subject, observer))
        sizes = sizes_by_pair.setdefault(ends, ([], []))
        number, time = obs.seq[rows], obs.time[rows]
        # The first answer with a larger number confirms a sample. The smallest packet that carried
        # the sample until then may be the one that arrived.
        confirms = np.searchsorted(np.maximum.accumulate(obs.seq[asks]), number, side="right")
        before = time < np.append(obs.time[asks], -np.inf)[confirms]
        # If this answer or the previous one requests samples, the writer may have skipped them.
        before &= np.append(obs["missing"][asks] == 0, False)[confirms]
        last = asks[np.maximum(confirms - 1, 0)]
        before &= (obs["missing"][last] == 0) | (obs.time[last] < time)
        samples, which = np.unique(number[before], return_inverse=True)
        smallest = np.full(len(samples), ETHERNET_MTU)
        np.minimum.at(smallest, which, size[obs["frame"][rows][before]])
        sizes[0].extend(smallest.tolist())
        frames = [*losses.lost_sample_frames(evidence, subject, observer, rows, asks)]
        sizes[1].extend(size[frames].tolist())
    return sizes_by_pair
