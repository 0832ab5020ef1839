"""Findings about traffic: storms, unresponsive servers, vanished packets, streams of data."""

from collections import Counter
from collections.abc import Iterator
from itertools import chain

import numpy as np

from discostorm import wording
from discostorm.data import read_data
from discostorm_capture._types import Array
from discostorm_capture.diagnosis import losses
from discostorm_capture.diagnosis.evidence import Evidence
from discostorm_capture.diagnosis.finding import LIMITS, Finding
from discostorm_capture.diagnosis.observations import (
    ACKNACK,
    HEARTBEAT,
    SAMPLE_KINDS,
    SEDP,
    Observations,
)
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
    findings = [*_unresponsive_dds_servers(obs), *_other_server_numbers(obs)]
    findings += _unresponsive_routers(obs)
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


def _other_server_numbers(obs: Observations) -> Iterator[Finding]:
    """Yield clients that ask a Discovery Server only for a number that it does not have."""
    asks = obs.isin("kind", "SPDP Heartbeat", "SPDP ACKNACK") & ~obs["multicast"]
    asks &= np.isin(obs.sender_index, [*server_clients(obs)])
    serves = obs.links_of(obs.messages[np.isin(obs.sender_index, [*obs.servers])])
    hosts = {host for host, _ in serves}
    for caller, host in sorted(obs.links_of(obs.messages[asks])):
        to_it = asks & obs.isin("sender", caller) & obs.isin("receiver", host)
        if (
            host in hosts
            and to_it.sum() >= LIMITS.min_messages
            and (obs.receiver_index[to_it] < 0).all()
        ):
            yield Finding.of("server number", (caller,), host, to_it.sum())


def _unresponsive_routers(obs: Observations) -> Iterator[Finding]:
    """Yield Zenoh routers that refuse connections or do not answer."""
    peers = {*obs.process_host} - {*obs.process_host[obs.is_server]}
    arp = obs.event_tuples("ARP request", "ARP reply")
    calls = obs.event_tuples("connection", "refused", "unanswered", "unreachable")
    taken = {(host, port): time for kind, _, host, port, time in calls if kind == "connection"}
    tries = Counter(row[1:4] for row in calls if row[0] == "connection")
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
    without_session: dict[str, list[str]] = {}
    closed: dict[str, list[str]] = {}
    spoke = obs.links_of(obs.messages[obs.isin("protocol", "Zenoh")])
    opened = obs.links_of(obs.messages[obs.isin("submessage", "OpenAck")])
    for (caller, host, port), count in tries.items():
        if count < LIMITS.min_calls or {(caller, host), (host, caller)} & opened:
            continue
        text = f"{caller} opened {count} connections to port {port} on {host}, and "
        if (caller, host) in spoke and host not in {one for one, _ in spoke}:
            closed.setdefault(host, []).append(f"{count} from {caller} to port {port}")
        elif (caller, host) in spoke:
            text += "each was closed before a session began"
            kind, versions = "session refused", obs.processes["version"]
            old, new = ({*versions[obs.process_host == end]} - {0} for end in (caller, host))
            newest = max(READABLE_VERSIONS)
            if old and not old & (new or {newest}):
                ends = max(old), max(new, default=newest)
                kind, said = "different releases", "both versions" if new else "old version"
                text += say(said, *ends)
            yield Finding(kind, (caller,), text)
        elif port == ZENOH_PORT and any(other == host for _, other in spoke):
            text += "unlike the others, sent no unencrypted Zenoh messages there"
            yield Finding("wrong port", (caller,), text)
        elif port == ZENOH_PORT and obs.messages.empty:
            others = {one for one, *at in tries if at == [host, port]}
            served = sorted(one for one in others if tries[one, host, port] < LIMITS.min_calls)
            if served:
                yield Finding.of("TLS client", (caller,), host, count, served)
            else:
                without_session.setdefault(host, []).append(f"{count} from {caller} to port {port}")
    for host, texts in closed.items():
        yield Finding.of("no router behind", (host,), texts)
    for host, texts in without_session.items():
        yield Finding.of("TLS fails", (host,), texts)
    for (host, port, by_udp), rows in failed.items():
        kinds, callers, times = zip(*rows, strict=True)
        if len(rows) < LIMITS.min_calls or host in peers or np.ptp(times) < LIMITS.min_wait:
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
            last = max([time for _, of, *_, time in arp if of == host], default=-np.inf)
            last = max(last, obs.host_first_last.get(host, (0.0, last))[1])
            asked, kind = [row for row in arp if row[2] == host and row[4] > last], "server down"
            if {*kinds} == {"unanswered"} and last >= min(times) - LIMITS.max_transit:
                kind = "server firewall"  # it answered ARP just before the first call, or later
            elif {*kinds} == {"unanswered"} and len(asked) >= LIMITS.min_unanswered:
                kind = "server off"
            yield Finding(kind, (host,), text)


def vanished_packets(evidence: Evidence) -> Iterator[Finding]:
    """Yield pairs of hosts between which only large packets vanish, or TCP segments do."""
    obs, large = evidence.obs, {}
    for pair, (arrived, lost) in _packet_sizes(evidence).items():
        # Fragments that were captured at their receiver have arrived.
        whole = len(obs.events("incomplete")) and obs.vantage_host == pair[1]
        passed_size = max(max(arrived, default=0), LARGE_PACKET)
        if len(lost) >= losses.SEGMENT_LOSS[0] and min(lost) > passed_size and not whole:
            large[pair] = max(arrived, default=0), min(lost), len(lost)
    yield from _uncaptured_samples(obs)
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


def repeated_multicast(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts that send user samples by multicast, and many of them again by unicast."""
    obs, data = evidence.obs, evidence.obs.isin("kind", "User data")
    asks = obs.isin("kind", "User ACKNACK") & (obs["missing"] > 0)
    asks |= obs.isin("submessage", "NACK_FRAG")
    for host in obs.messages["sender"][data & obs["multicast"]].unique():
        to_all = int((data & obs["multicast"] & obs.isin("sender", host)).sum())
        again = int((asks & obs.isin("receiver", host)).sum())
        if again >= max(LIMITS.min_messages, LIMITS.min_repaired_share * to_all):
            yield Finding.of("data by multicast", (host,), to_all, again)


def data_fills_channel(evidence: Evidence) -> Iterator[Finding]:
    """Yield the host with the largest stream, if samples by multicast or unicast fill a channel."""
    obs, ends, sender = evidence.obs, evidence.endpoints, evidence.obs.messages["sender"].cat
    seconds = obs["airtime_s"] * obs["user"] * ~obs.isin("submessage", "ACKNACK")
    lossy = {one.hosts for one in repeated_multicast(evidence)}
    # A link that loses or delays frames may be slower than the channel.
    slow = [one for one in losses.frame_loss(evidence) if one.about == "fleet"]
    slow = slow or [*losses.late_deliveries(evidence)]
    slow = [one for one in slow if one.kind not in losses.CROWDED]
    limit = LIMITS.max_multicast_use if slow else 1.0
    kinds = {"stream by multicast": LIMITS.max_multicast_use}
    kinds |= {"stream on a slow link" if slow else "much data": limit}
    for (kind, limit), cast in zip(kinds.items(), (True, False), strict=True):
        rows = (seconds > 0) & (obs["multicast"] == cast)
        fills = seconds[rows].sum() >= limit * max(obs.end, LIMITS.timeout)
        if not (rows.any() and (fills or slow)):
            continue
        flows = obs.rows_by(rows, sender.codes.to_numpy(), obs.sender_index, obs["writer"])
        ranked = sorted(((seconds[of].sum(), key) for key, of in flows.items()), reverse=True)
        # Robots of a kind send streams of a kind.
        keys = [key for airtime, key in ranked if 2 * airtime >= ranked[0][0]]
        together = np.concatenate([flows[key] for key in keys])
        octets = int(obs["bytes"][together].sum())
        # A link that is slow at times may carry less than the paper's channel.
        slows = slow and not cast and 2 * octets >= obs["bytes"].sum()
        if not (fills or (slows and 8 * octets >= LIMITS.slow_stream_rate * obs.end)):
            continue
        own = {key[1:] for key in keys}
        sent = [pair in own for pair in zip(ends["index"], ends["entity"], strict=True)]
        topic = ends["topic"][np.array(sent, bool)]
        hosts = tuple(dict.fromkeys(str(sender.categories[key[0]]) for key in keys))
        reads = ends["topic"].isin(topic) & ends["writer"].eq(other=False)
        readers = ends["host"][reads & ~ends["host"].isin(hosts)].unique()
        airtimes = seconds[together].sum(), seconds[rows].sum()
        shares = [wording.percent(one / obs.end) for one in airtimes]
        lasts = len(np.unique(obs.time[flows[keys[0]]].astype(np.int64)))
        most = not slow or cast or slows or 2 * airtimes[0] >= airtimes[1]
        if lasts >= LIMITS.min_stream_seconds and hosts not in lossy and most:
            signs = [one.evidence for one in slow]
            named = [*topic.map(ros_topic)] or ["the largest stream"]
            to = f" to {join_names(readers)}" if len(readers) else ""
            yield Finding(kind, hosts, say(kind, hosts, named, *shares, to, *signs))


def copies_to_other_addresses(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts that announce several addresses, if many samples are copied to them."""
    obs = evidence.obs
    data = obs.isin("kind", *SAMPLE_KINDS) & ~obs["multicast"]
    all_bytes = int(obs["bytes"][data].sum())
    for host, processes in obs.processes_by_host(range(len(obs.processes))).items():
        announced = dict.fromkeys(" ".join(obs.processes["announces"].iloc[processes]).split())
        others = [one for one in announced if one != host]
        rows = data & obs.isin("receiver", *others)
        octets, own = int(obs["bytes"][rows].sum()), data & obs.isin("receiver", host)
        fast = 8 * octets >= LIMITS.slow_stream_rate * max(obs.end, LIMITS.timeout)
        if fast and octets >= LIMITS.min_copied_share * all_bytes and own.any():
            senders = obs.messages["sender"][rows].unique()
            share = wording.percent(octets / all_bytes)
            yield Finding.of("copies", (host,), others, senders, rows.sum(), share)


def busy_topics(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts that send a topic far more often than other robots, or very many requests."""
    obs, ends = evidence.obs, evidence.endpoints
    ends = ends[ends["writer"].eq(other=True) & ~ends["topic"].astype(str).str.endswith("/rosout")]
    sends = obs.isin("kind", *SAMPLE_KINDS) & (obs["writer"] > 0)
    rows = obs.rows_by(sends, obs.sender_index, obs["writer"])
    keys = zip(ends["index"], ends["entity"], strict=True)
    counts = [len(np.unique(obs.seq[rows[key]])) if key in rows else 0 for key in keys]
    ends = ends.assign(rate=np.array(counts) / max(obs.end, LIMITS.timeout))
    alike = ends["topic"].astype(str).str.replace(r"\d+", "#", regex=True)
    for (_, name), group in ends.groupby([ends["scope"], alike]):
        ranked = group.sort_values("rate")
        host, topic, rate = ranked[["host", "topic", "rate"]].iloc[-1]
        usual, calls = ranked["rate"].iloc[:-1].max(), str(name).startswith("rq/")
        if (calls or rate >= LIMITS.min_rate_ratio * usual > 0) and rate >= LIMITS.log_rate:
            kind = "many calls" if calls else "busy topic"
            yield Finding.of(kind, (host,), ros_topic(topic), rate, usual)


def pausing_processes(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts that pause again and again, but then confirm at once all that they were sent."""
    obs, times = evidence.obs, evidence.min_answer_times.items()
    acks, lacks = obs.isin("submessage", "ACKNACK"), obs["missing"] > 0
    beats = obs.isin("submessage", "HEARTBEAT") & ~obs["multicast"] & obs["holes"]
    for host in sorted({to for (_, to), time in times if time < LIMITS.max_read_delay}):
        own = obs.isin("sender", host)
        sent = np.unique(obs.time[own])
        long = np.flatnonzero(np.diff(sent) > LIMITS.min_hang)
        pause = sent[long], sent[long + 1]
        after = pause[1], pause[1] + LIMITS.max_burst_pause
        # A best-effort reader never answers.
        reads = obs.rows_by(own & acks, obs.receiver_index, obs["writer"])
        rows = obs.rows_by(beats & obs.isin("receiver", host), obs.sender_index, obs["writer"])
        to_it = np.sort(np.concatenate([[], *(rows[one] for one in rows if one in reads)]))
        spans = (
            (to_it.astype(int), pause),
            (own & acks & ~lacks, after),
            (own & acks & lacks, after),
        )
        asked, good, bad = (
            np.diff(np.searchsorted(obs.time[of], at), axis=0)[0] for of, at in spans
        )
        late = (asked >= LIMITS.min_unanswered) & (good > 0) & (bad == 0)
        if late.sum() >= LIMITS.min_calls:
            longest = np.subtract(*pause[::-1])[late].max()
            counts = late.sum(), LIMITS.min_hang, longest, asked[late].sum()
            yield Finding.of("pauses", (host,), *counts)


def bursts_of_samples(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts whose writers all pause most of the time, and then send several samples each."""
    obs, sender = evidence.obs, evidence.obs.messages["sender"].cat
    data = obs.isin("kind", *SAMPLE_KINDS) & (obs["writer"] > 0)
    for (of,), rows in obs.rows_by(data, sender.codes.to_numpy()).items():
        host, times = str(sender.categories[of]), np.unique(obs.time[rows])
        long = np.flatnonzero(np.diff(times) > LIMITS.min_stall)
        begins, pauses = times[np.append(0, long + 1)], np.diff(times)[long]
        if len(long) < LIMITS.min_bursts or pauses.sum() < np.ptp(times) / 2:
            continue
        # A topic whose period is as long as the pauses has one sample in each burst.
        burst = np.searchsorted(begins, obs.time[rows], side="right")
        keys = zip(burst, obs.sender_index[rows], obs["writer"][rows], obs.seq[rows], strict=True)
        sizes = Counter(key[:3] for key in {*keys})
        several = {key[0] for key, count in sizes.items() if count > 1}
        others = obs.time[data & ~obs.isin("sender", host)]
        on = np.diff(np.searchsorted(others, (times[long], times[long + 1])), axis=0)[0] > 0
        alike = len({key[1:] for key in sizes}) > 1 and on.mean() >= LIMITS.min_steady_share
        if alike and len(several) >= LIMITS.min_steady_share * len(begins):
            yield Finding.of("bursts", (host,), len(long), pauses.min(), pauses.max())


def fragment_loss(evidence: Evidence) -> Iterator[Finding]:
    """Yield hosts that lose fragments of large samples, but no small samples."""
    obs = evidence.obs
    lacking, at = obs.event_tuples("incomplete"), str(obs.vantage_host)
    whole = obs.messages["frame"][obs.isin("receiver", at) & (obs["frames"] > 1)].nunique()
    flows = Counter(row[1:3] for row in lacking if row[2] == at)
    # A capture from the receiver lacks what did not get there.
    if flows.total() > max(whole, LIMITS.min_messages):
        pairs = [f"{count:,} from {of} to {to}" for (of, to), count in flows.most_common()]
        yield Finding("most samples in parts", (at,), say("lack fragments", flows.total(), pairs))
    asks = obs.isin("submessage", "NACK_FRAG") & ~obs["multicast"]
    asked = Counter(obs.messages["sender"][asks].astype(str))
    hosts = sorted(of for of, count in asked.items() if count >= LIMITS.min_fragment_requests)
    kinds = {one.kind for one in losses.frame_loss(evidence)}
    text = [f"{host} ({wording.count_noun(asked[host], 'time')})" for host in hosts]
    # What a capture from the receiver contains has reached it.
    if hosts == [obs.vantage_host] and kinds <= {"some loss"} and obs.events("incomplete").empty:
        yield Finding.of("full buffers", hosts, text)
    elif hosts and not kinds:
        yield Finding.of("burst loss", hosts, text)


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
