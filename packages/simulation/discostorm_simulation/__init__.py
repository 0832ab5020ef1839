"""The burst on the air, frame by frame: contention, queues, losses, recovery.

A second opinion of the closed form: one 802.11 cell whose hosts contend for the channel, see
`simulate`. The inner loops are compiled by numba, an extra: `pip install 'discostorm[simulation]'`.
"""

from __future__ import annotations

import signal
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any, Literal, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from discostorm import _checks
from discostorm.fleet import Fleet
from discostorm.messages import Protocol
from discostorm.wifi import Wifi
from discostorm_simulation._memory import available
from discostorm_simulation.propagation import MOST_DECIBELS, THRESHOLD, disc, powers
from discostorm_simulation.result import NoRecovery, Run, Simulation
from discostorm_simulation.starts import Start, told

if TYPE_CHECKING:
    from discostorm_simulation.run import Setup

__all__ = ["NoRecovery", "Simulation", "disc", "powers", "simulate"]

#: Frames and seconds; None for no limit.
Queue: TypeAlias = tuple[float | None, float | None] | NDArray[Any]

#: What users wait for without being told how long it takes [s].
_PATIENCE = 60.0
#: Runs that take less in all go one after the other: starting processes takes longer [s].
_ALONE = 5.0


def simulate(
    fleet: Fleet,
    protocol: Protocol,
    wifi: Wifi,
    *,
    queue: Queue | None = (500, 0.5),
    start: Start = 0.0,
    loss: ArrayLike = 0.0,
    recovery: bool = True,
    runs: int = 1,
    seed: int = 0,
    until: float = 120.0,
    eifs: bool = False,
    agreements: Literal["cold", "in place"] = "cold",
    power: ArrayLike | None = None,
    threshold: tuple[float, float] = THRESHOLD,
) -> Simulation:
    """Simulate the discovery of a fleet on one Wi-Fi cell, frame by frame.

    All hosts hear each other and the access point, at equal strength unless `power` says
    otherwise. Every frame goes up to
    the access point as unicast, waits there and goes down again, multicast once at the basic
    rate without acknowledgement. Stations contend as EDCA best effort says (802.11a and g: as
    DCF says): AIFS, binary exponential back-off, acknowledgement timeout, at most 7 attempts.
    With aggregation, block acknowledgements are agreed on before; one that is missing
    is asked for, and frames are repeated until they arrive or are too old. The access point passes
    on in order what a host sends (hosts do not put in order what comes down), and sends
    next to whoever has waited longest.

    Parameters
    ----------
    fleet : Fleet
        At least two hosts; hosts, processes and endpoints must be whole numbers. Data of its groups
        (`HostGroup.data`) are sent beside discovery, as `discostorm_simulation.user_data` says;
        for the same without them simulate ``fleet.without_data()`` as well.
    protocol : Protocol
        Its messages, schedules, answers and lease; for recovery also roles and timers.
    wifi : Wifi
        A channel with a radio, such as `discostorm.PAPER` or ``Radio(...).wifi()``.
    queue : tuple of (float, float), optional
        Frames [1] and seconds that the queue of each station and of the access point holds,
        as ns-3 has them by default; infinity or None for no limit.
    start : float, array or distribution, optional
        When hosts start [s], from 0 to 1e6: one time for all, an array of one a host, an object
        with ``rvs`` (of `scipy.stats`), or a function of a `numpy.random.Generator` and
        a number of hosts that returns their times.
    loss : float or array, optional
        Part of the data frames with errors on the link between a host and the access point
        [1], up and down alike, at least 0 and below 1; an array has one a host.
    recovery : bool, optional
        Whether messages answer messages and the middleware repairs what is lost, as
        `discostorm_simulation.recovery` says; not for tables whose processes announce
        themselves to servers or routers, such as "Fast DDS Discovery Server" or "Zenoh router".
        If not, each host sends all that its
        schedules say by the clock, nothing answers discovery and nothing is repeated but by Wi-Fi.
    runs : int, optional
        Independent runs [1]. They go side by side through joblib, which
        `joblib.parallel_config` directs.
    seed : int, optional
        Of the random numbers [1], at least 0: the same arguments give the same result to the
        bit.
    until : float, optional
        With recovery, when to give up [s] after the last host's start, above 0 and at most
        1e6; without it a run ends when the burst is through or, beside data, always at this time.
    eifs : bool, optional
        Whether those who hear a collision take it for a frame with errors and wait EIFS. If
        not, as ns-3 has it, frames of equal strength hide each other's preamble.
    agreements : {"cold", "in place"}, optional
        With aggregation: whether block acknowledgements have been agreed on before the start, or
        all were just switched on, so that each sender first exchanges an ADDBA request and
        response with each receiver, as `discostorm_simulation.block_ack` says.
    power : array of shape (hosts + 1, hosts + 1), optional
        How strongly each station is heard by each other [dB], at [sender, receiver], the access
        point last, such as `discostorm_simulation.powers` gives it. Of frames that overlap, the
        one then arrives that is strong enough (capture effect), as
        `discostorm_simulation.capture_effect` says; if it is left out, none does.
    threshold : tuple of (float, float), optional
        By how much the power of a frame must exceed the sum of all that overlap it [dB], at
        least 0: unicast data, and what is sent at the basic rate. As the standard's receivers of
        64-QAM 5/6 and BPSK 1/2 need it; those of ns-3 with two antennas need 18 and 1 dB.

    Returns
    -------
    Simulation
        Drain time, losses, convergence time and more, one value a run.

    Raises
    ------
    ImportError
        If numba, joblib or tqdm is missing.
    ValueError
        If an argument is out of range, the fleet, protocol or channel cannot be simulated, or a
        run needs more memory than the machine has available.
    TypeError
        If an argument is of another kind.

    References
    ----------
    IEEE Std 802.11-2020, 10.3 and 10.23.2 (contention), 10.25 (block acknowledgement); OMG
    DDSI-RTPS 2.5, 8.4; RFC 6298. Periods: ``data/vendors/middleware_defaults.csv``.

    Examples
    --------
    >>> import discostorm as ds
    >>> swarm = ds.Fleet.swarm(3, 2, 10)
    >>> found = ds.simulate(swarm, ds.DDS, ds.PAPER, recovery=False, runs=3)
    >>> bool((found.drain_time > ds.utilization(ds.DDS, 3, 2, 10) / 2).all())
    True
    """
    for name in ("numba", "joblib", "tqdm"):
        if find_spec(name) is None:
            raise ImportError(
                f"the simulator needs {name}: pip install 'discostorm[simulation]'", name=name
            )
    _checks.instance("fleet", fleet, Fleet)
    _checks.instance("protocol", protocol, Protocol)
    _checks.instance("wifi", wifi, Wifi)
    recovery = _checks.boolean("recovery", recovery)
    eifs = _checks.boolean("eifs", eifs)
    _checks.whole("runs", runs, 1)
    _checks.whole("seed", seed, 0)
    _checks.number("until", until, 0, _checks.MOST_SECONDS, above=True)
    _checks.choice("agreements", agreements, ("cold", "in place"))
    exceeds = _threshold(threshold)

    from discostorm_simulation.run import set_up
    from discostorm_simulation.user_data import with_user_data

    setup = set_up(
        fleet,
        protocol,
        wifi,
        _queue(queue),
        start,
        loss,
        recovery,
        float(until),
        eifs,
        agreements == "cold",
        power,
        exceeds,
    )
    seeds = np.random.SeedSequence(int(seed)).spawn(int(runs))
    settings = {
        "hosts": setup.hosts.processes.size,
        "queue_frames": setup.queue[0],
        "queue_s": setup.queue[1],
        "start": told(setup.start),
        "loss": np.asarray(loss, dtype=np.float64).tolist(),
        "recovery": recovery,
        "runs": int(runs),
        "seed": int(seed),
        "until_s": float(until),
        "eifs": eifs,
        "agreements": agreements,
    }
    if power is not None:
        settings |= {"power_dB": np.asarray(power).tolist(), "threshold_dB": list(exceeds)}
    table = with_user_data(protocol, fleet)
    return Simulation.of_runs(fleet, table, wifi, settings, _all_runs(setup, seeds))


def _queue(queue: Queue | None) -> tuple[float, float]:
    """Return frames and seconds of a queue; infinity for no limit."""
    if queue is None:
        return np.inf, np.inf
    given: Any = queue.tolist() if isinstance(queue, np.ndarray) else queue
    if not (isinstance(given, (tuple, list)) and len(given) == 2):
        raise TypeError(
            f"queue must be None or a tuple of frames and seconds; got {_checks.short(queue)}"
        )
    frames, seconds = (np.inf if value is None else value for value in given)
    _checks.whole("queue[0]", frames, 1, endless=True)
    return float(frames), _checks.number("queue[1]", seconds, 0, above=True, endless=True)


def _threshold(threshold: tuple[float, float]) -> tuple[float, float]:
    """Return by how much a frame must exceed what overlaps it, at the top and at the basic rate."""
    if not (isinstance(threshold, (tuple, list)) and len(threshold) == 2):
        raise TypeError(
            "threshold must be a tuple of two numbers, of data and of the basic rate; "
            f"got {_checks.short(threshold)}"
        )
    data, basic = (
        _checks.number(f"threshold[{n}]", one, 0, MOST_DECIBELS) for n, one in enumerate(threshold)
    )
    return data, basic


def _say(text: str) -> None:
    if sys.stderr is None:  # closed
        return
    sys.stderr.write(f"discostorm: {text}\n")
    sys.stderr.flush()


def _all_runs(setup: Setup, seeds: list[np.random.SeedSequence]) -> list[Run]:
    from joblib import Parallel, delayed
    from tqdm import tqdm

    from discostorm_simulation._compile import keeps, shown
    from discostorm_simulation._workers import jobs
    from discostorm_simulation.engine import advance
    from discostorm_simulation.run import compiled, one_run

    seconds, megabytes = setup.estimate()
    free = available()
    if megabytes > free:
        raise ValueError(
            f"fleet must be smaller to be simulated here: a run needs about {megabytes:.0f} MB, "
            f"and {free:.0f} MB are available; got {setup.hosts.host_of.size} processes"
        )
    with shown(_say, keeps(advance)):
        compiled()
    if seconds * len(seeds) > _PATIENCE:
        runs = "1 run" if len(seeds) == 1 else f"{len(seeds)} runs"
        _say(f"{runs} of about {seconds / 60:.1f} min and {megabytes:.0f} MB each")
    hidden = None if seconds * len(seeds) > 1 else True
    with tqdm(total=len(seeds), desc="simulating", unit="run", disable=hidden) as bar:
        found = []
        if len(seeds) == 1 or seconds * len(seeds) < _ALONE:
            for seed in seeds:
                found.append(one_run(setup, seed))
                bar.update()
            return found
        most = int(min(free / megabytes, len(seeds)))
        side_by_side = Parallel(return_as="generator", **jobs(most))
        with _ctrl_c_ignored():
            runs = side_by_side(delayed(one_run)(setup, seed) for seed in seeds)
        for run in runs:
            found.append(run)
            bar.update()
    return found


@contextmanager
def _ctrl_c_ignored() -> Iterator[None]:
    """Ignore Ctrl-C; so do, for good, processes started meanwhile, which this one ends."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before or signal.SIG_DFL)
