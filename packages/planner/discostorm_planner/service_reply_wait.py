"""Service calls while nodes start: how long a server must wait for the client's reply reader.

A client sends its request once it has discovered the server. The server can reply only after it has
discovered the client's reply reader.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

#: Default waiting time of a server [s] (max_blocking_time; ros2/rmw_fastrtps#704), share of replies
#: that should arrive [1], and number of times sampled from a run [1].
MAX_BLOCKING_TIME, REQUIRED_REPLY_SHARE, _MAX_SAMPLED_TIMES = 0.1, 0.99, 500


def lost_reply_share(pair_times: ArrayLike, wait: float = MAX_BLOCKING_TIME) -> float:
    """Return the share of replies that servers drop after waiting ``wait`` seconds [1].

    Clients call as soon as they have discovered the server; see `required_reply_wait`.
    """
    waits = _reply_waits(pair_times)
    return float(np.mean(waits > wait)) if waits.size else 1.0


def required_reply_wait(pair_times: ArrayLike, share: float = REQUIRED_REPLY_SHARE) -> float:
    """Return how long servers must wait so that a given share of replies arrives [s].

    `pair_times` come from `discostorm.simulate`. We treat both directions of a pair as independent,
    and let clients call as soon as they have discovered the server, so real servers wait less. The
    result is infinity if too many pairs never complete.
    """
    waits = _reply_waits(pair_times)
    return float(np.quantile(waits, share, method="higher")) if waits.size else np.inf


def _reply_waits(pair_times: ArrayLike) -> NDArray[np.float64]:
    """Return how long after its client discovered it a server discovers the client [s]."""
    waits = [np.zeros(0)]
    for run in np.atleast_2d(pair_times):
        known = np.quantile(run, np.linspace(0, 1, _MAX_SAMPLED_TIMES), method="higher")
        waits.append(np.maximum(known[:, None] - known[np.isfinite(known)], 0.0).ravel())
    return np.concatenate(waits)
