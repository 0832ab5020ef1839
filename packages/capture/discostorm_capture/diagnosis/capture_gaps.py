"""What a capture itself lacks: a startup before it began, samples, hosts, confirmations."""

from __future__ import annotations

from collections.abc import Collection

import numpy as np

from discostorm_capture._types import Array
from discostorm_capture.diagnosis.observations import HANDSHAKE, HEARTBEAT, SEDP, Observations
from discostorm_capture.diagnosis.pairs import acknowledgements, endpoint_announcements

#: What a process announces so long after its first message is not of its startup [s].
STARTUP_TIME = 1.0
#: So many answers to a host tell that it spoke.
MIN_ANSWERS = 3


def processes_before_capture(obs: Observations) -> set[int]:
    """Return the processes that had announced their endpoints before the capture began."""
    # Others confirm samples that the capture lacks, and did not begin with the first one. What a
    # process announces long after its first message, not from sample 1 on, is of no startup.
    startup = {
        key
        for key, rows in endpoint_announcements(obs).items()
        if obs.seq[rows].min() == 1 or obs.time[rows[0]] - obs.first_last[0][key[0]] < STARTUP_TIME
    }
    unseen = {
        subject
        for (_, subject, writer), rows in acknowledgements(obs).items()
        if obs.seq[rows[0]] > 1 and (subject, writer) not in startup
    }
    # Others know these, and they send nothing of a startup: Heartbeats or acknowledgements of
    # endpoints, an acknowledgement of nothing yet, or a handshake.
    starts = obs.isin("kind", SEDP, HEARTBEAT, HANDSHAKE)
    starts |= obs.isin("submessage", "ACKNACK") & (obs.seq <= 1)
    settled = obs.senders(~obs["multicast"] & obs.isin("protocol", "RTPS")) - obs.senders(starts)
    return unseen | settled


def missing_samples(obs: Observations, late: Collection[int]) -> dict[tuple[str, str], int]:
    """Return, by host and who confirms, how many samples were confirmed that the capture lacks."""
    gaps = obs.isin("submessage", "GAP") & (obs.sender_index >= 0)
    jumped = obs.rows_by(gaps, obs.sender_index, obs["writer"])
    sent = endpoint_announcements(obs)
    found: dict[tuple[str, str], int] = {}
    for (observer, subject, writer), acks in acknowledgements(obs).items():
        if subject in late or (subject, writer) in jumped:
            continue
        rows, lacks = sent.get((subject, writer), acks[:0]), obs.seq[acks]
        if lacks.min() > 1 and not len(rows):
            continue
        # A Discovery Server sends each sample only to those that it concerns.
        told = np.isin(obs.receiver_index[rows], (observer, -1)) | obs.is_server[subject]
        mine = obs.seq[rows[told]]
        missing = int(lacks.max()) - 1 - len(np.unique(mine[mine < lacks.max()]))
        if missing > 0:
            ends = str(obs.process_host[subject]), str(obs.process_host[observer])
            found[ends] = max(found.get(ends, 0), missing)
    return found


def zenoh_replies(obs: Observations) -> Array:
    """Return which messages show that their sender heard their receiver before."""
    first = obs.isin("submessage", "InitSyn") | obs.isin("kind", "Scout", "Hello", "Join")
    found: Array = obs.isin("protocol", "Zenoh") & ~obs["multicast"] & ~first
    return found


def silent_hosts(obs: Observations) -> dict[str, int]:
    """Return the hosts of which the capture shows nothing, with how many answers they got."""
    answers = obs.isin("submessage", "ACKNACK") & (obs.seq > 1)
    answers |= obs.uses_keys
    answers |= zenoh_replies(obs) & (obs.sender_index >= 0)
    # Who speaks from one address may announce another one, as of Docker's bridge.
    spoke = {*obs.host_first_last, *obs.process_host, *obs.announced_addresses}
    counts = obs.messages["receiver"][answers & ~obs["multicast"]].astype(str).value_counts()
    counts = counts[counts >= MIN_ANSWERS]
    return {str(host): int(count) for host, count in counts.items() if host not in spoke}


def hosts_without_known_process(obs: Observations) -> set[str]:
    """Return the hosts that speak in sessions of Zenoh, none of whose processes are known."""
    sessions = obs.isin("protocol", "Zenoh") & ~obs["multicast"] & (obs.sender_index < 0)
    return {str(host) for host in obs.messages["sender"][sessions].unique()} - {*obs.process_host}
