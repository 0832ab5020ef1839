"""Findings about packets that vanish although their receiver is there: by size, or all of TCP's."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import chain

import numpy as np

from discostorm_capture.diagnosis.evidence import Evidence
from discostorm_capture.diagnosis.finding import Finding, listed
from discostorm_capture.diagnosis.observations import Observations
from discostorm_capture.diagnosis.traffic import SEGMENTS, WAIT, asked_samples, lost_frames

#: The headers of IPv4 and of TCP or UDP; the fragments of larger datagrams; the smallest packet
#: that a smaller MTU drops, as every network of IPv4 passes 576 bytes (RFC 791) [B].
TCP_HEADERS, UDP_HEADERS, ETHERNET, MIN_LARGE = 40, 28, 1500, 577


def undelivered(evidence: Evidence) -> Iterator[Finding]:
    """Yield that only large packets vanish between hosts, or all segments of TCP."""
    obs, large = evidence.obs, {}
    for pair, (arrived, lost) in _sizes(obs).items():
        if len(lost) >= SEGMENTS[0] and min(lost) > max(max(arrived, default=0), MIN_LARGE):
            large[pair] = max(arrived, default=0), min(lost), len(lost)
    if large:
        passed, least, counts = zip(*large.values(), strict=True)
        said = f"{listed([f'{one} to {other}' for one, other in large])}: packets of up to "
        said += f"{max(passed):,} bytes arrive, and none of {min(least):,} bytes and more "
        said += f"({sum(counts)} of them were asked for or sent again)"
        yield Finding("large packets", tuple(dict.fromkeys(chain(*large))), said)
    deaf: dict[tuple[str, str], str] = {}
    for _, sender, receiver, payload, time in obs.event_rows("vanished"):
        later = (obs.time > time) & (obs.time < time + WAIT)
        # Who is out of range or restarts does not speak meanwhile.
        if (sender, receiver) not in large and (later & obs.isin("sender", receiver)).any():
            said = f"{sender} to {receiver} ({payload} bytes, first sent after {time:.1f} s)"
            deaf.setdefault((sender, receiver), said)
    if deaf:
        ends = list(dict.fromkeys(chain(*deaf)))
        common = [host for host in ends if all(host in pair for pair in deaf)]
        said = "segments of TCP were sent again and again, and never acknowledged: "
        yield Finding("unacknowledged", tuple(common or ends), said + listed([*deaf.values()]))


def _sizes(obs: Observations) -> dict[tuple[str, ...], tuple[list[int], list[int]]]:
    """Return the sizes of packets from host to host that arrived, and that vanished [B]."""
    found: dict[tuple[str, ...], tuple[list[int], list[int]]] = {}
    for kind, sender, receiver, payload, _ in obs.event_rows("arrived", "vanished"):
        lost = kind == "vanished"
        sizes = found.setdefault((sender, receiver), ([], []))
        # One that vanished was sent so often at least.
        sizes[lost].extend([payload + TCP_HEADERS] * (SEGMENTS[0] if lost else 1))
    size = np.bincount(obs["frame"], obs["bytes"]).astype(np.int64)
    size = np.minimum(size + UDP_HEADERS, ETHERNET)
    for subject, observer, rows, asks in asked_samples(obs):
        sizes = found.setdefault(obs.hosts_of((subject, observer)), ([], []))
        number, time = obs.number[rows], obs.time[rows]
        # A sample is confirmed by the first answer that goes on after it; the smallest packet that
        # had carried it until then may be the one that arrived.
        confirms = np.searchsorted(np.maximum.accumulate(obs.number[asks]), number, side="right")
        before = time < np.append(obs.time[asks], -np.inf)[confirms]
        # If it or the answer before lacks something, the writer may have given the sample up.
        before &= np.append(obs["missing"][asks] == 0, False)[confirms]
        last = asks[np.maximum(confirms - 1, 0)]
        before &= (obs["missing"][last] == 0) | (obs.time[last] < time)
        samples, which = np.unique(number[before], return_inverse=True)
        smallest = np.full(len(samples), ETHERNET)
        np.minimum.at(smallest, which, size[obs["frame"][rows][before]])
        sizes[0].extend(smallest.tolist())
        sizes[1].extend(size[[*lost_frames(obs, subject, observer, rows, asks)]].tolist())
    return found
