"""Services that are called while nodes start: how long a server must wait for its client.

A client asks once it knows the server; the server answers once it knows the client's reply reader.
"""

import numpy as np
from numpy.typing import ArrayLike

#: How long a server waits by default [s] (max_blocking_time; ros2/rmw_fastrtps#704), the share of
#: its answers that are to arrive [1], and how many times of a run stand for all [1].
DEFAULT_WAIT, SAFE, _TIMES = 0.1, 0.99, 500


def unmatched_share(pair_times: ArrayLike, time: float) -> float:
    """Return the probability that a request at a time [s] comes before its reply reader matches."""
    return float(np.mean(np.asarray(pair_times) > time))


def safe_wait(pair_times: ArrayLike, share: float = SAFE) -> float:
    """Return how long servers must wait for a share of their answers to arrive [s].

    `pair_times` are those of `discostorm.simulate`. Both directions of a pair count as independent,
    and a client asks as soon as it knows the server, so real servers wait less. Infinity: more
    pairs than that are never complete.
    """
    waits = []
    for run in np.atleast_2d(pair_times):
        known = np.quantile(run, np.linspace(0, 1, _TIMES), method="higher")
        waits.append(np.maximum(known[:, None] - known[np.isfinite(known)], 0.0).ravel())
    every = np.concatenate(waits)
    return float(np.quantile(every, share, method="higher")) if every.size else np.inf
