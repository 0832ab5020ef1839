"""What a capture lacks: startups before it began, samples, messages of hosts."""

from collections.abc import Collection

import numpy as np

from discostorm_capture._types import Array
from discostorm_capture.diagnosis.finding import LIMITS
from discostorm_capture.diagnosis.observations import HANDSHAKE, HEARTBEAT, SEDP, Observations
from discostorm_capture.diagnosis.pairs import acknowledgements, endpoint_announcements


def processes_before_capture(obs: Observations) -> set[int]:
    """Return the processes that had announced their endpoints before the capture began."""
    # Some processes have samples confirmed that the capture lacks. Their announcements do not count
    # as startup if they begin after sample 1, and long after the first message.
    soon = obs.first_last[0] + LIMITS.max_startup_delay
    startup = {
        key
        for key, rows in endpoint_announcements(obs).items()
        if obs.seq[rows].min() == 1 or obs.time[rows[0]] < soon[key[0]]
    }
    unseen = {
        subject
        for (_, subject, writer), rows in acknowledgements(obs).items()
        if obs.seq[rows[0]] > 1 and (subject, writer) not in startup
    }
    # Other processes are in contact with others without any message of a startup: announcements
    # and Heartbeats of endpoints, a first acknowledgement, or a handshake.
    starts = obs.isin("kind", SEDP, HEARTBEAT, HANDSHAKE)
    starts |= obs.isin("submessage", "ACKNACK") & (obs.seq <= 1)
    settled = obs.senders(~obs["multicast"] & obs.isin("protocol", "RTPS")) - obs.senders(starts)
    refused = obs.hosts_refused_by_all
    return unseen | {one for one in settled if obs.process_host[one] not in refused}


def missing_samples(obs: Observations, late: Collection[int]) -> dict[tuple[str, str], int]:
    """Return the number of confirmed samples that the capture lacks, by sender and receiver."""
    gaps = obs.isin("submessage", "GAP") & (obs.sender_index >= 0)
    jumped = obs.rows_by(gaps, obs.sender_index, obs["writer"])
    sent = endpoint_announcements(obs)
    counts: dict[tuple[str, str], int] = {}
    for (observer, subject, writer), acks in acknowledgements(obs).items():
        if subject in late or (subject, writer) in jumped:
            continue
        rows, lacks = sent.get((subject, writer), acks[:0]), obs.seq[acks]
        if lacks.min() > 1 and not len(rows):
            continue
        # A Discovery Server sends each sample only to the clients that need it.
        to_it = np.isin(obs.receiver_index[rows], (observer, -1)) | obs.is_server[subject]
        seqs = obs.seq[rows[to_it]]
        missing = int(lacks.max()) - 1 - len(np.unique(seqs[seqs < lacks.max()]))
        if missing > 0:
            ends = str(obs.process_host[subject]), str(obs.process_host[observer])
            counts[ends] = max(counts.get(ends, 0), missing)
    return counts


def zenoh_replies(obs: Observations) -> Array:
    """Return which Zenoh messages show that their sender received something from their receiver."""
    first = obs.isin("submessage", "InitSyn") | obs.isin("kind", "Scout", "Hello", "Join")
    return np.asarray(obs.isin("protocol", "Zenoh") & ~obs["multicast"] & ~first)


def silent_hosts(obs: Observations) -> dict[str, int]:
    """Return hosts without captured messages, with the number of answers sent to them."""
    answers = obs.isin("submessage", "ACKNACK") & (obs.seq > 1)
    answers |= obs.uses_keys
    answers |= zenoh_replies(obs) & (obs.sender_index >= 0)
    # A host may announce another address than it sends from, such as that of Docker's bridge.
    spoke = {*obs.host_first_last, *obs.process_host, *obs.announced_addresses}
    counts = obs.messages["receiver"][answers & ~obs["multicast"]].astype(str).value_counts()
    counts = counts[counts >= LIMITS.min_answers]
    return {str(host): int(count) for host, count in counts.items() if host not in spoke}
