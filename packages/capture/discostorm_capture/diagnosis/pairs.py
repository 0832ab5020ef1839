"""Pairs of processes that should discover each other, on two hosts, and when they did."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import permutations

import numpy as np

from discostorm_capture._types import Array
from discostorm_capture.diagnosis.finding import LIMITS
from discostorm_capture.diagnosis.observations import ACKNACK, HEARTBEAT, SEDP, Observations

#: Kinds of messages that only Discovery Servers and their clients send: their SPDP is reliable.
CLIENT_KINDS = ("SPDP Heartbeat", "SPDP ACKNACK", "SPDP Gap")
#: Added to the domain for each domain tag, because tags separate scopes; larger than any domain.
TAG_OFFSET = 1000
#: Sending and answering process, rows of a writer's samples, and rows of the answers.
Exchange = tuple[int, int, Array, Array]


@dataclass(frozen=True)
class Pair:
    """What one process, the observer, has discovered of another one, the subject."""

    #: Indices of the processes.
    subject: int
    observer: int
    #: When the observer, having heard of the subject, first sent it a message [s]; inf if never.
    first_contact: float
    #: When the observer knew all endpoints of the subject [s]; inf if never, NaN if unknown.
    complete_at: float
    #: Number of endpoints that the subject announced to the observer.
    n_announced: int
    #: When the observer, which had confirmed endpoints, started discovery over [s].
    rediscovered_at: tuple[float, ...] = ()

    @property
    def processes(self) -> tuple[int, int]:
        """The subject and the observer."""
        return self.subject, self.observer


def first_contacts(obs: Observations) -> Array:
    """Return when each process (row) first sent a message to each other one (column) [s]."""
    # The last row and column are for messages that do not name both processes.
    first = np.full((len(obs.processes) + 1,) * 2, np.inf)
    np.minimum.at(first, (obs.sender_index, obs.receiver_index), obs.time)
    return first[:-1, :-1]


def acknowledgements(obs: Observations) -> dict[tuple[int, ...], Array]:
    """Return rows of SEDP ACKNACKs by their sender, receiver and the receiver's writer."""
    acks = obs.isin("kind", ACKNACK) & (obs.sender_index >= 0) & (obs.receiver_index >= 0)
    return obs.rows_by(acks, obs.sender_index, obs.receiver_index, obs["writer"])


def endpoint_announcements(obs: Observations) -> dict[tuple[int, ...], Array]:
    """Return rows of endpoint announcements, by process and writer."""
    data = obs.isin("kind", SEDP) & (obs.sender_index >= 0) & (obs.seq > 0)
    return obs.rows_by(data, obs.sender_index, obs["writer"])


def first_of_each_burst(times: Iterable[float]) -> list[float]:
    """Return the first time of each burst; bursts are a startup pause or more apart."""
    apart: list[float] = []
    for time in sorted(times):
        if not apart or time - apart[-1] > LIMITS.max_startup_pause:
            apart.append(float(time))
    return apart


def _startup_samples(obs: Observations) -> dict[int, dict[int, tuple[Array, int]]]:
    """Return announcement rows and the last sequence number of startup, by process and writer."""
    spoken = (obs.sender_index >= 0) & obs.isin("kind", SEDP, HEARTBEAT)
    sent = endpoint_announcements(obs)
    writers: dict[int, dict[int, tuple[Array, int]]] = {}
    for key, chosen in obs.rows_by(spoken, obs.sender_index, obs["writer"]).items():
        rows = sent.get(key, chosen[:0])
        last = int(obs.seq[chosen].max(initial=0))
        if len(rows):
            # Samples just before the end of the capture could not be confirmed in time.
            early = rows[obs.time[rows] < obs.end - LIMITS.max_transit]
            numbers, first = np.unique(obs.seq[early if len(early) else rows], return_index=True)
            times = obs.time[early if len(early) else rows][first]
            order = np.argsort(times, kind="stable")
            breaks = np.flatnonzero(np.diff(times[order]) > LIMITS.max_startup_pause)
            last = int(numbers[order[: breaks[0] + 1 if len(breaks) else None]].max())
        if last:
            writers.setdefault(key[0], {})[key[1]] = rows, last
    return writers


def rtps_pairs(obs: Observations, wanted: list[tuple[int, int]]) -> list[Pair]:
    """Return the pairs of RTPS processes, with when each observer knew its subject's endpoints."""
    contact, spoke = first_contacts(obs), _links_without_processes(obs)
    # Who announced endpoints to whom: a process, else a host, or "" for multicast.
    told = np.flatnonzero(obs.isin("kind", SEDP, HEARTBEAT))
    hosts = np.where(obs["multicast"], "", obs.messages["receiver"].astype(str))[told].tolist()
    index = (one[told].tolist() for one in (obs.sender_index, obs.receiver_index))
    receivers = {(of, host if to < 0 else to) for of, to, host in zip(*index, hosts, strict=True)}
    writers, acks = _startup_samples(obs), acknowledgements(obs)
    skips = obs.isin("submessage", "GAP") & obs.is_server[obs.sender_index] & (obs.seq > 0)
    skips = obs.rows_by(skips, obs.receiver_index, obs.sender_index, obs["writer"])
    pairs = []
    for subject, observer in wanted:
        first, back = contact[observer, subject], contact[subject, observer]
        ends = str(obs.process_host[subject]), str(obs.process_host[observer])
        complete, sent, forgotten = first, 0, set[float]()
        if complete == np.inf and ends[::-1] in spoke:
            complete = np.nan  # the observer discovered the subject, if at all, before the capture
        announced = writers.get(subject, {})
        untold = not receivers & {(subject, observer), (subject, ends[1]), (subject, "")}
        if announced and untold and obs.end - max(first, back) > LIMITS.max_startup_pause:
            complete = np.nan  # they exchange all but announcements, which came before the capture
        if {subject, observer} & obs.secured_processes and not announced:
            # Announcements are encrypted, and only processes with keys receive them.
            complete = np.nan if (subject, observer) in obs.key_exchanges else np.inf
        elif not announced and not np.isnan(complete):
            # The subject has nothing to announce, provided that it discovered the observer.
            complete = np.nan if ends in spoke and np.isinf(back) else max(complete, back)
        for writer, (rows, last) in announced.items():
            confirms = acks.get((observer, subject, writer), rows[:0])
            forgotten |= set(_acknowledgement_restarts(obs, confirms).tolist())
            delivered = rows[np.isin(obs.receiver_index[rows], (observer, -1))]
            sent += len(np.unique(obs.seq[delivered[~obs["ends"][delivered]]]))
            # A server answers a client's last request by skipping what does not concern it.
            answers = np.sort(np.append(confirms, skips.get((observer, subject, writer), rows[:0])))
            full = obs.time[answers[obs.seq[answers] > last]]
            if not len(full):
                complete = np.nan if np.isnan(complete) else np.inf
                continue
            # Confirmed samples that the capture lacks were announced before it began.
            before = delivered[(obs.seq[delivered] <= last) & (obs.time[delivered] <= full[0])]
            complete = max(complete, obs.time[before].max(initial=0.0))
        anew = tuple(first_of_each_burst(forgotten))
        pairs.append(Pair(subject, observer, first, float(complete), sent, anew))
    return pairs


def _links_without_processes(obs: Observations) -> set[tuple[str, str]]:
    """Return pairs of hosts with unicast messages that do not name both processes."""
    anonymous = (obs.sender_index < 0) | (obs.receiver_index < 0)
    return obs.links_of(obs.messages[anonymous & ~obs["multicast"] & ~obs.isin("kind", "Hello")])


def _acknowledgement_restarts(obs: Observations, confirms: Array) -> Array:
    """Return when acknowledgements start over, after samples had been confirmed [s]."""
    times, got = obs.time[confirms], np.flatnonzero(obs.seq[confirms] > 1)
    if not len(got):
        return times[:0]
    again = got[0] + np.flatnonzero(obs.seq[confirms[got[0] :]] <= 1)
    before = times[got[np.searchsorted(got, again) - 1]]
    return np.asarray(times[again][times[again] - before > LIMITS.max_transit])


def zenoh_pairs(obs: Observations, wanted: list[tuple[int, int]]) -> list[Pair]:
    """Return the pairs of Zenoh processes: when they had a session and all declarations."""
    named = (obs.sender_index >= 0) & (obs.receiver_index >= 0)
    opened, declared = (
        obs.rows_by(named & mask, obs.sender_index, obs.receiver_index)
        for mask in (obs.isin("submessage", "OpenAck"), obs.isin("kind", "Declare"))
    )
    contact = first_contacts(obs)
    # Times stay unknown for sessions that began before the capture: these cannot be read.
    spoke = _links_without_processes(obs) | obs.links_of(obs.events("exchange"))
    pairs = []
    nothing = np.zeros(0, np.int64)
    for there in wanted:
        back = there[::-1]
        acks = np.sort(obs.time[np.append(opened.get(there, nothing), opened.get(back, nothing))])
        declarations = declared.get(there, nothing)
        times = obs.time[declarations]
        lost = (obs["missing"][declarations] > 0) & (obs.end - times > LIMITS.max_transit)
        complete = np.inf
        if len(acks):
            later = np.flatnonzero(np.diff(times) > LIMITS.max_startup_pause)
            startup = slice(later[0] + 1 if len(later) else None)
            complete = max(acks[0], np.where(lost, np.inf, times)[startup].max(initial=0.0))
        elif np.isfinite([contact[there], contact[back]]).all() or obs.hosts_of(there) in spoke:
            complete = np.nan
        anew = tuple(first_of_each_burst(acks)[1:])
        pairs.append(Pair(*there, contact[back], float(complete), len(times), anew))
    return pairs


@dataclass(frozen=True)
class DiscoveryScope:
    """Processes that should discover each other: a domain of RTPS, or all of Zenoh."""

    #: "RTPS" or "Zenoh".
    protocol: str
    #: Their hosts, and hosts that only announce.
    hosts: tuple[str, ...]
    #: Their indices among the processes.
    members: tuple[int, ...]
    #: The pairs on different hosts that should discover each other.
    pairs: tuple[Pair, ...]


def server_clients(obs: Observations) -> set[int]:
    """Return the RTPS processes that use a Discovery Server."""
    return obs.senders(obs.isin("kind", *CLIENT_KINDS)) - obs.servers


def scouting_hosts(obs: Observations) -> tuple[str, ...]:
    """Return the hosts that search for Zenoh processes by multicast."""
    rows = obs.messages[obs.isin("kind", "Scout") & obs["multicast"]]
    return tuple(map(str, rows["sender"].unique()))


def rtps_scopes(obs: Observations) -> Iterator[DiscoveryScope]:
    """Yield one scope for each domain of RTPS."""
    rtps = np.flatnonzero(obs.is_rtps)
    domain = obs.processes["domain"].to_numpy(np.int64) + TAG_OFFSET * obs.domain_tag
    known = np.unique(domain[rtps][domain[rtps] >= 0])
    if len(known) == 1:
        domain[rtps] = known[0]
    served, serves, contact = server_clients(obs), obs.is_server, first_contacts(obs)

    def ought_to_discover(subject: int, observer: int) -> bool:
        """Return whether a process of RTPS should discover another one directly."""
        if {subject, observer} & served or serves[subject] or serves[observer]:
            # Clients discover each other only through servers, and servers know their clients.
            between = bool(serves[subject] != serves[observer])
            spoke = np.isfinite([contact[subject, observer], contact[observer, subject]])
            return between and bool(spoke.any())
        return True

    for number in np.unique(domain[rtps]).tolist():
        members = tuple(rtps[domain[rtps] == number].tolist())
        wanted = [pair for pair in _observable_pairs(obs, members) if ought_to_discover(*pair)]
        pairs = tuple(rtps_pairs(obs, wanted))
        yield DiscoveryScope("RTPS", obs.hosts_of(members), members, pairs)


def zenoh_scope(obs: Observations) -> Iterator[DiscoveryScope]:
    """Yield the scope of Zenoh, if any process or host speaks it."""
    members = tuple(np.flatnonzero((obs.processes["protocol"] == "Zenoh").to_numpy()).tolist())
    scouts = scouting_hosts(obs)
    hosts = tuple(dict.fromkeys((*obs.hosts_of(members), *scouts)))
    if not hosts:
        return
    calls_router = obs.is_server | (obs.processes["product"] == "Zenoh client").to_numpy()
    links = set(zip(obs.sender_index.tolist(), obs.receiver_index.tolist(), strict=True))
    wanted = [
        pair
        for pair in _observable_pairs(obs, members)
        if pair in links
        or pair[::-1] in links
        or (not calls_router[[*pair]].any() and {*obs.hosts_of(pair)} <= {*scouts})
    ]
    yield DiscoveryScope("Zenoh", hosts, members, tuple(zenoh_pairs(obs, wanted)))


def _observable_pairs(obs: Observations, members: tuple[int, ...]) -> Iterator[tuple[int, int]]:
    """Yield ordered pairs of processes on different hosts whose unicast the capture shows."""
    for pair in permutations(members, 2):
        hosts = obs.hosts_of(pair)
        if len(hosts) == 2 and obs.sees_unicast(*hosts):
            yield pair


def answered_samples(obs: Observations) -> Iterator[Exchange]:
    """Yield the samples and answers of each writer and each process of another host."""
    sender, receiver = obs.sender_index, obs.receiver_index
    sends = obs.isin("submessage", "DATA", "DATA_FRAG") & (obs.seq > 0) & (sender >= 0)
    sent_by = obs.rows_by(sends & ~obs.isin("kind", "SPDP"), sender, obs["writer"])
    answers = obs.isin("submessage", "ACKNACK") & (sender >= 0) & (receiver >= 0)
    keys = (receiver, obs["writer"], sender)
    for (subject, writer, observer), asks in obs.rows_by(answers, *keys).items():
        if obs.process_host[subject] == obs.process_host[observer]:
            continue  # between two addresses of one host
        rows = sent_by.get((subject, writer), asks[:0])
        yield subject, observer, rows[np.isin(receiver[rows], (observer, -1))], asks


def min_answer_times(obs: Observations, asked: Iterable[Exchange]) -> dict[tuple[str, ...], float]:
    """Return the shortest time to an answer, by host of the writer and of the reader [s]."""
    least: dict[tuple[str, ...], float] = {}
    tells = obs.isin("submessage", "HEARTBEAT", "DATA", "DATA_FRAG") & (obs.seq > 0)
    announced = obs.rows_by(tells & (obs.sender_index >= 0), obs.sender_index, obs["writer"])
    for subject, observer, _, asks in asked:
        rows, known = announced.get((subject, int(obs["writer"][asks[0]]))), obs.seq[asks] - 1
        known += obs["missing"][asks]  # the number of samples that the reader knew of
        if rows is not None:
            at = np.searchsorted(np.maximum.accumulate(obs.seq[rows]), known)
            times = obs.time[asks] - np.append(obs.time[rows], -np.inf)[at]
            ends = obs.hosts_of((subject, observer))
            least[ends] = times[known > 0].min(initial=least.get(ends, np.inf))
    return least
