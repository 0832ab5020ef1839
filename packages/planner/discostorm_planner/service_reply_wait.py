"""Services that are called while nodes start: how long a server must wait for its client.

A client asks once it knows the server; the server answers once it knows the client's reply reader.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

#: How long a server waits by default [s] (max_blocking_time; ros2/rmw_fastrtps#704), the share of
#: its answers that are to arrive [1], and how many times of a run stand for all [1].
MAX_BLOCKING_TIME, REQUIRED_REPLY_SHARE, _MAX_SAMPLED_TIMES = 0.1, 0.99, 500


def lost_reply_share(pair_times: ArrayLike, wait: float = MAX_BLOCKING_TIME) -> float:
    """Return which share of replies servers drop that wait so long [s] for the reply reader.

    Of clients that ask as soon as they know the server; see `required_reply_wait`.
    """
    waits = _reply_waits(pair_times)
    return float(np.mean(waits > wait)) if waits.size else 1.0


def required_reply_wait(pair_times: ArrayLike, share: float = REQUIRED_REPLY_SHARE) -> float:
    """Return how long servers must wait for a share of their answers to arrive [s].

    `pair_times` are those of `discostorm.simulate`. Both directions of a pair count as independent,
    and a client asks as soon as it knows the server, so real servers wait less. Infinity: more
    pairs than that are never complete.
    """
    waits = _reply_waits(pair_times)
    return float(np.quantile(waits, share, method="higher")) if waits.size else np.inf


def _reply_waits(pair_times: ArrayLike) -> NDArray[np.float64]:
    """Return how much later a server knows its client than the client knows it [s]."""
    waits = [np.zeros(0)]
    for run in np.atleast_2d(pair_times):
        known = np.quantile(run, np.linspace(0, 1, _MAX_SAMPLED_TIMES), method="higher")
        waits.append(np.maximum(known[:, None] - known[np.isfinite(known)], 0.0).ravel())
    return np.concatenate(waits)
