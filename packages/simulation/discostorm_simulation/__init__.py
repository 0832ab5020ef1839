"""The burst on the air, frame by frame: contention, queues, losses, recovery.

A second opinion of the closed form: one 802.11 cell whose hosts contend for the channel, see
`simulate`.
"""

from __future__ import annotations

import os
import sys
from concurrent.futures import ThreadPoolExecutor, wait
from threading import Event
from typing import TYPE_CHECKING, Any, Literal, TypeAlias

import click
import numpy as np
from numpy.typing import ArrayLike, NDArray

from discostorm import _checks, words
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

#: From how long a simulation takes on it says so before, and shows how far it is [s].
_SAID, _SHOWN = 60.0, 1.0


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
    block_ack: Literal["negotiate", "established"] = "negotiate",
    power: ArrayLike | None = None,
    threshold: tuple[float, float] = THRESHOLD,
) -> Simulation:
    """Simulate the discovery of a fleet on one Wi-Fi cell, frame by frame.

    Frames go up to the access point as unicast, wait there and go down again, multicast once at
    the basic rate. Stations contend by EDCA, best effort (802.11a and g: by DCF), at most 7 times;
    with aggregation until a frame arrives or is too old.

    Parameters
    ----------
    fleet : Fleet
        At least two hosts, and whole numbers; its groups' data are sent beside discovery.
    protocol : Protocol
        Its messages, schedules, answers and lease; for recovery also roles and timers.
    wifi : Wifi
        A channel with a radio, such as `discostorm.PAPER` or ``Radio(...).wifi()``.
    queue : tuple of (float, float), optional
        Frames [1] and seconds that each queue holds, as in ns-3; infinity or None for no limit.
    start : float, array or distribution, optional
        When hosts start [s], from 0 to 1e6: one time, one a host, an object with ``rvs`` (of
        `scipy.stats`), or a function of a `numpy.random.Generator` and a number of hosts.
    loss : float or array, optional
        Part of the data frames with errors between a host and the access point [1], up and down
        alike, at least 0 and below 1; an array has one a host.
    recovery : bool, optional
        Whether messages answer messages and the middleware repairs losses, not through servers
        or routers. If not, hosts send what their schedules say, and only Wi-Fi repeats.
    runs : int, optional
        Independent runs [1], which go side by side in threads.
    seed : int, optional
        Of the random numbers [1], at least 0: the same arguments give the same bits.
    until : float, optional
        With recovery or user data, when to end [s] after the last start, above 0, at most 1e6.
    eifs : bool, optional
        Whether those who hear a collision wait EIFS, as after a frame with errors; not in ns-3.
    block_ack : {"negotiate", "established"}, optional
        With aggregation: whether ADDBA frames come first, as after power-on, or came before.
    power : array of shape (hosts + 1, hosts + 1), optional
        For the capture effect: how strongly stations hear each other [dB], at [sender, receiver],
        the access point last, see `discostorm_simulation.powers`.
    threshold : tuple of (float, float), optional
        By how much a frame's power must exceed the sum of all that overlap it [dB], at least 0:
        unicast data, and what is sent at the basic rate; in ns-3, with two antennas, 18 and 1.

    Returns
    -------
    Simulation
        Drain time, losses, convergence time and more, one value a run.

    Raises
    ------
    ImportError
        If wasmtime is missing.
    ValueError, TypeError
        If an argument cannot be simulated (`NoRecovery`), or a run needs more memory than there is.

    References
    ----------
    IEEE Std 802.11-2020, 10.3, 10.23.2, 10.25; OMG DDSI-RTPS 2.5, 8.4; RFC 6298.

    Examples
    --------
    >>> import discostorm as ds
    >>> found = ds.simulate(ds.Fleet.swarm(3, 2, 10), ds.DDS, ds.PAPER, recovery=False, runs=3)
    >>> bool((found.drain_time > ds.utilization(ds.DDS, 3, 2, 10) / 2).all())
    True
    """
    _checks.instance("fleet", fleet, Fleet)
    _checks.instance("protocol", protocol, Protocol)
    _checks.instance("wifi", wifi, Wifi)
    _checks.integer("runs", runs, 1)
    _checks.integer("seed", seed, 0)
    _checks.number("until", until, 0, _checks.MAX_SECONDS, exclusive_min=True)
    _checks.choice("block_ack", block_ack, ("negotiate", "established"))

    from discostorm_simulation.run import Scenario, set_up
    from discostorm_simulation.user_data import with_user_data

    scenario = Scenario(
        fleet,
        protocol,
        wifi,
        queue=_queue(queue),
        start=start,
        loss=loss,
        recovery=_checks.boolean("recovery", recovery),
        until=float(until),
        eifs=_checks.boolean("eifs", eifs),
        block_ack=block_ack,
        power=power,
        threshold=_threshold(threshold),
    )
    setup = set_up(scenario)
    settings = {
        "hosts": setup.hosts.processes.size,
        "queue_frames": scenario.queue[0],
        "queue_s": scenario.queue[1],
        "start": told(start),
        "loss": np.asarray(loss, dtype=np.float64).tolist(),
        "recovery": scenario.recovery,
        "runs": int(runs),
        "seed": int(seed),
        "until_s": scenario.until,
        "eifs": scenario.eifs,
        "block_ack": block_ack,
    }
    if power is not None:
        settings |= {"power_dB": np.asarray(power).tolist(), "threshold_dB": [*scenario.threshold]}
    found = _all_runs(setup, np.random.SeedSequence(int(seed)).spawn(int(runs)))
    return Simulation.of_runs(fleet, with_user_data(protocol, fleet), wifi, settings, found)


def _two(name: str, value: Any, what: str) -> tuple[Any, Any]:
    """Return both parts of an argument that is a tuple of two."""
    given = value.tolist() if isinstance(value, np.ndarray) else value
    if not (isinstance(given, (tuple, list)) and len(given) == 2):
        raise TypeError(f"{name} must be {what}; got {_checks.short_repr(value)}")
    return given[0], given[1]


def _queue(queue: Queue | None) -> tuple[float, float]:
    """Return frames and seconds of a queue; infinity for no limit."""
    given = (None, None) if queue is None else queue
    two = _two("queue", given, "None or a tuple of frames and seconds")
    frames, seconds = (np.inf if value is None else value for value in two)
    _checks.integer("queue[0]", frames, 1, allow_inf=True)
    return float(frames), _checks.number("queue[1]", seconds, 0, exclusive_min=True, allow_inf=True)


def _threshold(threshold: Any) -> tuple[float, float]:
    """Return by how much a frame must exceed what overlaps it, at the top and at the basic rate."""
    two = _two("threshold", threshold, "a tuple of two numbers, of data and of the basic rate")
    data, basic = (
        _checks.number(f"threshold[{n}]", one, 0, MOST_DECIBELS) for n, one in enumerate(two)
    )
    return data, basic


def _all_runs(setup: Setup, seeds: list[np.random.SeedSequence]) -> list[Run]:
    """Return what runs find that go side by side; refuse what does not fit the memory."""
    from discostorm_simulation.engine import MOST_MEGABYTES
    from discostorm_simulation.run import one_run

    seconds, megabytes = setup.estimate()
    free = available()
    if megabytes > min(free, MOST_MEGABYTES):
        raise ValueError(
            f"fleet must be smaller to be simulated here: a run needs about {megabytes:.0f} MB, of "
            f"{MOST_MEGABYTES:.0f} MB that the simulator can use, and {free:.0f} MB are available; "
            f"got {setup.hosts.host_of.size} processes"
        )
    if seconds * len(seeds) > _SAID and sys.stderr is not None:
        about = f"of about {seconds / 60:.1f} min and {megabytes:.0f} MB each"
        click.echo(f"discostorm: {words.count_noun(len(seeds), 'run')} {about}", err=True)
    if len(seeds) == 1:
        return [one_run(setup, seeds[0])]
    stop, found = Event(), []
    hidden = sys.stderr is None or seconds * len(seeds) < _SHOWN
    progress = click.progressbar(
        length=len(seeds), label="simulating", file=sys.stderr, hidden=hidden
    )
    workers = max(1, min(os.cpu_count() or 1, len(seeds), int(free / max(megabytes, 1.0))))
    with ThreadPoolExecutor(workers) as threads, progress as bar:
        futures = [threads.submit(one_run, setup, seed, stop) for seed in seeds]
        try:
            for future in futures:
                # Not for good, as Windows does not interrupt that.
                while not future.done():
                    wait([future], 0.2)
                found.append(future.result())
                bar.update(1)
        except BaseException:
            stop.set()
            threads.shutdown(cancel_futures=True)
            raise
    return found
