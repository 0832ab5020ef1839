"""Staggered start: start times of hosts that keep the channel from filling."""

import numpy as np
from numpy.typing import NDArray

from discostorm import _checks
from discostorm.drain_times import drain_time
from discostorm.fleet import Fleet
from discostorm.messages import Protocol
from discostorm.model import burst
from discostorm.wifi import PAPER, Wifi


def start_window(
    protocol: Protocol,
    hosts: float | Fleet,
    processes: float | None = None,
    endpoints: float | None = None,
    wifi: Wifi = PAPER,
) -> float:
    """Return the window for random starts by the rule of thumb: the drain time of a common start.

    Parameters
    ----------
    protocol, hosts, processes, endpoints, wifi
        As for `discostorm.utilization`, but no arrays.

    Returns
    -------
    float
        The drain time [s]; infinity if periodic traffic alone fills the channel.

    Examples
    --------
    >>> import discostorm as ds
    >>> from discostorm_planner import staggered_start
    >>> round(staggered_start.start_window(ds.DDS, 10, 2, 10), 1)
    2.0
    """
    found = drain_time(protocol, hosts, processes, endpoints, wifi)
    given = {"hosts": hosts, "processes": processes, "endpoints": endpoints}
    _checks.require_scalars((hosts.non_scalars() if isinstance(hosts, Fleet) else given).items())
    return float(found)


def start_times_in_turn(
    protocol: Protocol, hosts: int, processes: float, endpoints: float, wifi: Wifi = PAPER
) -> NDArray[np.float64]:
    """Return a start time for each host [s]: when the earlier hosts' airtime has passed.

    Parameters
    ----------
    protocol, hosts, processes, endpoints, wifi
        As for `discostorm.utilization`, but no arrays; an integer of at most a million hosts.

    Returns
    -------
    ndarray of shape (hosts,)
        In ascending order [s].

    References
    ----------
    The idea is that of SPRED ("Mitigating DDS Discovery Bursts in ROS 2 Multi-Robot System",
    thesis, DGIST, 2026, scholar.dgist.ac.kr, 20.500.11750/59728), as its abstract describes it.

    Examples
    --------
    >>> import discostorm as ds
    >>> from discostorm_planner import staggered_start
    >>> staggered_start.start_times_in_turn(ds.DDS, 4, 2, 10).round(2)
    array([0.  , 0.  , 0.05, 0.14])
    """
    _checks.integer("hosts", hosts, 1, 1e6)
    _checks.require_scalars([("processes", processes), ("endpoints", endpoints)])
    return np.append(0.0, burst(protocol, np.arange(1.0, hosts), processes, endpoints, wifi))
