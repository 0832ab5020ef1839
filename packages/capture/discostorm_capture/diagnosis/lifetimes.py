"""When each process sent its first and last message, how it ended, and which replaced which."""

from dataclasses import dataclass

import numpy as np

from discostorm_capture.diagnosis.finding import LIMITS
from discostorm_capture.diagnosis.observations import Observations
from discostorm_capture.diagnosis.pairs import CLIENT_KINDS

#: Kinds of network events by which a host requests a connection.
CONNECTION_ATTEMPTS = ("connection", "half", "refused", "unanswered")


@dataclass(frozen=True)
class Lifetime:
    """When a process sent its first and last message [s], and how it ended."""

    first: float
    last: float
    #: "left" after a goodbye, "silent" without one, "" if it continues or that is unknown.
    ending: str


def lifetimes(obs: Observations) -> list[Lifetime]:
    """Return the lifetime of each process."""
    closed = _process_ends(obs)
    # A process that only uses a server on its own host announces nothing in the capture.
    announced = obs.senders(obs.isin("kind", "SPDP", *CLIENT_KINDS))
    # A host out of range does not acknowledge segments.
    vanished = {receiver: time for _, _, receiver, _, time in obs.event_tuples("vanished")}
    result = []
    for process, (first, last) in enumerate(zip(*obs.first_last, strict=True)):
        rtps = obs.is_rtps[process]
        when, end = closed.get(process, (np.inf, ""))
        if not end or last - when >= LIMITS.late_delivery:
            away = vanished.get(obs.process_host[process], -np.inf) > last - LIMITS.late_delivery
            enough = LIMITS.steady_silence if away else LIMITS.zenoh_silence
            enough = LIMITS.rtps_silence if rtps else enough
            silent = _is_silent(obs, process, enough) and _others_still_send(obs, process, last)
            end = "silent" if silent and (process in announced or not rtps) else ""
        result.append(Lifetime(first, last, end))
    return result


def _is_silent(obs: Observations, process: int, enough: float) -> bool:
    """Return whether a process sent nothing at the end, for much longer than it paused before."""
    times = obs.time[obs.sender_index == process]
    pause = float(np.diff(times).max(initial=0.0))
    last = times[-1] if len(times) else -np.inf
    return bool(obs.end - last > max(LIMITS.min_pause_ratio * pause, enough))


def _others_still_send(obs: Observations, process: int, since: float) -> bool:
    """Return whether other hosts sent messages well after a time."""
    others = ~obs.isin("sender", obs.process_host[process])
    return bool((obs.time[others] > since + LIMITS.min_time_of_others).any())


def _process_ends(obs: Observations) -> dict[int, tuple[float, str]]:
    """Return when and how processes end: by a goodbye, or when a TCP connection is closed."""
    closed: dict[int, tuple[float, str]] = {}
    sender, receiver = obs.sender_index, obs.receiver_index
    calls = obs.events(*CONNECTION_ATTEMPTS)
    closing = obs["ends"] & obs.isin("protocol", "TCP") & (sender >= 0) & (receiver >= 0)
    ends = np.minimum(sender, receiver), np.maximum(sender, receiver)
    for rows in obs.rows_by(closing, *ends).values():
        process, when = int(sender[rows[0]]), float(obs.time[rows[0]])
        host = obs.process_host[process]
        # The process that closes first has ended, unless its host opens connections afterwards.
        restarted = (obs.process_host == host) & (obs.first_last[0] > when)
        called = (calls["sender"] == host) & (calls["time"] > when)
        if (restarted.any() or not called.any()) and _others_still_send(obs, process, when):
            closed[process] = when, "silent"
    goodbye = (obs["ends"] & obs.isin("kind", "SPDP")) | obs.isin("kind", "Close")
    for row in np.flatnonzero(goodbye & (sender >= 0)).tolist():
        closed[int(sender[row])] = float(obs.time[row]), "left"
    return closed


def restart_chains(obs: Observations, lifetimes: list[Lifetime]) -> list[list[int]]:
    """Return chains of processes on a host, each of which began after the previous one ended."""
    chains: list[list[int]] = []
    product = obs.processes["product"].to_numpy(object)
    for processes in obs.processes_by_host(range(len(lifetimes))).values():
        spoke = [process for process in processes if np.isfinite(lifetimes[process].first)]
        spoke.sort(key=lambda process: lifetimes[process].first)
        ended = [one for one in spoke if lifetimes[one].ending == "silent" or _stopped(obs, one)]
        for process in spoke:
            began, name = lifetimes[process].first, product[process]
            before = [one for one in ended if lifetimes[one].last < began and product[one] == name]
            if before:
                last = max(before, key=lambda other: lifetimes[other].last)
                ended.remove(last)
                chain = next((one for one in chains if one[-1] == last), [last])
                chains += [chain] * (len(chain) == 1)
                chain.append(process)
    return chains


def _stopped(obs: Observations, process: int) -> bool:
    """Return whether a process that paused for at most 1 s before is now silent."""
    times = obs.time[obs.sender_index == process]
    steady = len(times) >= LIMITS.min_steady_messages and np.diff(times).max() <= 1.0
    steady = steady and times[-1] - times[0] >= 1.5
    return bool(steady and _is_silent(obs, process, LIMITS.steady_silence))
