"""Findings about services: requests that came before the reader for their reply was announced."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product

import numpy as np

from discostorm import wording
from discostorm_capture._bytes import Array
from discostorm_capture.diagnosis.evidence import Evidence
from discostorm_capture.diagnosis.finding import Finding, listed
from discostorm_capture.diagnosis.observations import ACKNACK, DATA, Observations

#: So long a server of rmw_fastrtps waits for the reader of its reply [s] (max_blocking_time;
#: ros2/rmw_fastrtps#704).
MAX_BLOCKING_TIME = 0.1


def early_requests(evidence: Evidence) -> Iterator[Finding]:
    """Yield the services whose server knew the reader for the reply too late, and never replied."""
    obs, texts, lost, hosts = evidence.obs, list[str](), 0, dict[str, None]()
    data = obs.isin("kind", "User data")
    sends = {*zip(obs.sender_index[data].tolist(), obs["writer"][data].tolist(), strict=True)}
    ends = _ends(obs)
    for service in sorted({service for service, *_ in ends}):
        asking, readers, writers = (
            ends.get((service, *role), []) for role in (("rq", True), ("rr", False), ("rr", True))
        )
        for (client, _, number), (server, replies, _) in product(readers, writers):
            # Which of several clients of a process reads which reply is not announced.
            asks = [entity for process, entity, _ in asking if process == client]
            names = obs.hosts_of((client, server))
            if len(names) < 2 or len(asks) != 1 or (client, asks[0]) not in sends:
                continue
            told = _announced_at(obs, client, server, number)
            requests = _first_sent(obs, client, server, asks[0])
            early = requests[requests < told - MAX_BLOCKING_TIME]
            later = requests[len(early) :].min(initial=np.inf)
            times = _first_sent(obs, server, client, replies)
            missing = len(early) - int(np.sum((times >= early.min(initial=0)) & (times < later)))
            if missing > 0:
                said = f"/{service} (service): {names[0]} asked {names[1]} after {early[0]:.1f} s, "
                said += f"and announced to it the reader of the reply {told - early[0]:.1f} s later"
                texts, lost, hosts = [*texts, said], lost + missing, hosts | dict.fromkeys(names)
    if texts:
        got = wording.count_noun(lost, "request")
        yield Finding("early requests", tuple(hosts), f"{listed(texts)}; {got} got no reply")


def _ends(obs: Observations) -> dict[tuple[str, str, bool], list[tuple[int, int, int]]]:
    """Return process, id and announcement of endpoints, by service, rq or rr, and if they write."""
    ends = obs.endpoints.dropna(subset="topic")
    index = {str(name): process for process, name in enumerate(obs.processes.index)}
    columns = (ends[of].tolist() for of in ("process", "entity", "number", "topic", "writer"))
    found: dict[tuple[str, str, bool], list[tuple[int, int, int]]] = {}
    for process, entity, number, topic, writer in zip(*columns, strict=True):
        prefix, _, name = topic.partition("/")
        if process in index and prefix in ("rq", "rr"):
            name = name.removesuffix("Request").removesuffix("Reply")
            found.setdefault((name, prefix, writer), []).append((index[process], entity, number))
    return found


def _announced_at(obs: Observations, process: int, to: int, number: int) -> float:
    """Return when the announcement that another process confirmed was sent; 0 if never."""
    sent = obs.isin("kind", DATA) & obs.isin("entity", "subscriptions") & (obs.number == number)
    times = obs.time[sent & _is_from(obs, process, to) & ~obs["ends"]]
    acks = obs.isin("kind", ACKNACK) & obs.isin("entity", "subscriptions") & (obs.number > number)
    confirmed = obs.time[acks & _is_from(obs, to, process)].min(initial=np.inf)
    return float(times[times <= confirmed].max(initial=0.0))


def _first_sent(obs: Observations, process: int, to: int, writer: int) -> Array:
    """Return when a process sent each sample of a user's writer to another one at first [s]."""
    data = obs.isin("submessage", "DATA", "DATA_FRAG") & (obs["writer"] == writer)
    rows = np.flatnonzero(data & _is_from(obs, process, to))
    _, first = np.unique(obs.number[rows], return_index=True)
    times: Array = obs.time[rows[first]]
    return times


def _is_from(obs: Observations, process: int, to: int) -> Array:
    """Return which messages a process sent to another one, or to all."""
    there: Array = np.isin(obs.receiver_index, (to, -1)) & (obs.sender_index == process)
    there &= obs.isin("receiver", obs.process_host[to]) | obs["multicast"]
    return there
