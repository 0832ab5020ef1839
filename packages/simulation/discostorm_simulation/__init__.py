"""Simulate discovery frame by frame: contention, queues, losses, recovery.

The simulation checks the closed form: it models an 802.11 cell whose hosts contend for the
channel, or several cells, see `simulate`.
"""

from __future__ import annotations

import os
import sys
from functools import partial
from typing import TYPE_CHECKING, Any, Literal, TypeAlias

import click
import numpy as np
from numpy.typing import ArrayLike, NDArray

from discostorm import _checks, wording
from discostorm.fleet import Fleet
from discostorm.lookup import AnyProtocol, AnyWifi, as_protocol, as_wifi
from discostorm.wifi import PAPER
from discostorm_simulation._memory import available_megabytes
from discostorm_simulation.propagation import MAX_DECIBELS, THRESHOLD, disc, powers
from discostorm_simulation.result import NoRecovery, Run, Simulation
from discostorm_simulation.starts import Start, describe_start

if TYPE_CHECKING:
    from discostorm_simulation.run import Setup

__all__ = ["NoRecovery", "Simulation", "disc", "powers", "simulate"]

#: Default queue limits: frames [1] and seconds [s]. None stands for no limit.
Queue: TypeAlias = tuple[float | None, float | None] | NDArray[Any]

#: Threshold [s]: a longer simulation prints its estimated duration first, and its progress.
_ESTIMATE_FROM_S, _PROGRESS_FROM_S = 60.0, 1.0


def simulate(
    fleet: Fleet,
    protocol: AnyProtocol,
    wifi: AnyWifi = PAPER,
    *,
    queue: Queue | None = (500, 0.5),
    start: Start = 0.0,
    loss: ArrayLike = 0.0,
    recovery: bool = True,
    runs: int = 1,
    seed: int = 0,
    until: float = 120.0,
    give_up: float | None = None,
    eifs: bool = False,
    block_ack: Literal["negotiate", "established"] = "negotiate",
    power: ArrayLike | None = None,
    threshold: tuple[float, float] = THRESHOLD,
) -> Simulation:
    """Simulate the discovery of a fleet on Wi-Fi, frame by frame.

    Hosts send frames to the access point by unicast; the access point queues and forwards them,
    multicast once at the basic rate. Stations contend by EDCA, best effort (802.11a and g: DCF).
    They try a frame at most 7 times or, with aggregation, until it arrives or expires. Frames cross
    the wire, between cells and to and from wired hosts, without delay or loss.

    Parameters
    ----------
    fleet : Fleet
        At least two hosts, with integer counts; its groups' data are sent alongside discovery.
    protocol : Protocol or str
        Messages with schedules, answers and a lease; for recovery also roles and timers.
    wifi : Wifi, Radio or str, optional
        A channel with a radio, such as "802.11ac 80 MHz"; the paper's if left out. Of a fleet with
        cells, `Cell.wifi` is taken instead.
    queue : tuple of (float, float), optional
        Limits of each queue: frames [1] and seconds [s], as in ns-3; infinity or None: no limit.
    start : float, array or distribution, optional
        Start of the hosts [s], from 0 to 1e6: one time, one time per host, a distribution with
        ``rvs`` (`scipy.stats`), or a function of a `numpy.random.Generator` and a host count.
    loss : float or array, optional
        Frame error rate between a host and the access point [1], in both directions, at least 0
        and below 1; an array has one rate per host.
    recovery : bool, optional
        Whether messages trigger answers and the middleware recovers lost messages. Without
        recovery, hosts follow their schedules, and only Wi-Fi retries.
    runs : int, optional
        Number of independent runs [1], which run in parallel threads.
    seed : int, optional
        Random seed [1], at least 0: the same arguments give the same bits.
    until : float, optional
        Simulated time after the last start [s] with recovery or user data; above 0, at most 1e6.
    give_up : float, optional
        A run ends as never complete after this many of the longest periods without progress [1].
    eifs : bool, optional
        Whether stations wait EIFS after a collision, as after a damaged frame; not in ns-3.
    block_ack : {"negotiate", "established"}, optional
        With aggregation: whether stations send ADDBA frames first, as after power-on, or not.
    power : array of shape (hosts + 1, hosts + 1), optional
        Received power [dB] at [sender, receiver] for the capture effect, the access point last;
        see `discostorm_simulation.powers`.
    threshold : tuple of (float, float), optional
        Power of a captured frame above the sum of all overlapping frames [dB], at least 0: for
        unicast data, and for the basic rate. In ns-3, with two antennas: 18 and 1.

    Returns
    -------
    Simulation
        Drain time, losses, convergence time and more, one value per run.

    Raises
    ------
    ImportError
        If wasmtime is missing.
    ValueError, TypeError
        If an argument cannot be simulated (`NoRecovery`), or a run exceeds the free memory.

    References
    ----------
    IEEE Std 802.11-2020, 10.3, 10.23.2, 10.25; OMG DDSI-RTPS 2.5, 8.4; RFC 6298.

    Examples
    --------
    >>> import discostorm as ds
    >>> found = ds.simulate(ds.Fleet.swarm(3, 2, 10), "DDS", recovery=False, runs=3)
    >>> bool((found.drain_time > ds.utilization(ds.DDS, 3, 2, 10) / 2).all())
    True
    """
    _checks.instance("fleet", fleet, Fleet)
    if fleet.cells and wifi is not PAPER:
        got = _checks.short_repr(wifi)
        raise ValueError(f"wifi must be left out, as each cell names its own channel; got {got}")
    protocol, wifi = as_protocol(protocol), as_wifi(wifi)
    _checks.integer("runs", runs, 1)
    _checks.integer("seed", seed, 0)
    _checks.number("until", until, 0, _checks.MAX_SECONDS, exclusive_min=True)
    _checks.number("give_up", 1 if give_up is None else give_up, 0, exclusive_min=True)
    _checks.choice("block_ack", block_ack, ("negotiate", "established"))

    from discostorm_simulation.run import Scenario, set_up
    from discostorm_simulation.user_data import add_user_data_rows

    scenario = Scenario(
        fleet,
        protocol,
        wifi,
        queue=_queue_limits(queue),
        start=start,
        loss=loss,
        recovery=_checks.boolean("recovery", recovery),
        until=float(until),
        give_up=np.inf if give_up is None else float(give_up),
        eifs=_checks.boolean("eifs", eifs),
        block_ack=block_ack,
        power=power,
        threshold=_capture_thresholds(threshold),
    )
    setup = set_up(scenario)
    settings = {
        "hosts": setup.hosts.processes.size,
        "queue_frames": scenario.queue[0],
        "queue_s": scenario.queue[1],
        "start": describe_start(start),
        "loss": np.asarray(loss, dtype=np.float64).tolist(),
        "recovery": scenario.recovery,
        "runs": int(runs),
        "seed": int(seed),
        "until_s": scenario.until,
        "eifs": scenario.eifs,
        "block_ack": block_ack,
    }
    settings |= {} if give_up is None else {"give_up": scenario.give_up}
    if power is not None:
        settings |= {"power_dB": np.asarray(power).tolist(), "threshold_dB": [*scenario.threshold]}
    found = _simulate_in_threads(setup, np.random.SeedSequence(int(seed)).spawn(int(runs)))
    return Simulation.of_runs(fleet, add_user_data_rows(protocol, fleet), wifi, settings, found)


def _check_pair(name: str, value: Any, what: str) -> tuple[Any, Any]:
    """Return the two elements of a tuple argument; refuse any other value."""
    given = value.tolist() if isinstance(value, np.ndarray) else value
    if not (isinstance(given, (tuple, list)) and len(given) == 2):
        raise TypeError(f"{name} must be {what}; got {_checks.short_repr(value)}")
    return given[0], given[1]


def _queue_limits(queue: Queue | None) -> tuple[float, float]:
    """Return the limits of a queue: frames [1] and seconds [s], infinity for no limit."""
    given = (None, None) if queue is None else queue
    two = _check_pair("queue", given, "None or a tuple of frames and seconds")
    frames, seconds = (np.inf if value is None else value for value in two)
    _checks.integer("queue[0]", frames, 1, allow_inf=True)
    return float(frames), _checks.number("queue[1]", seconds, 0, exclusive_min=True, allow_inf=True)


def _capture_thresholds(threshold: Any) -> tuple[float, float]:
    """Return the capture thresholds [dB]: for unicast data, and for the basic rate."""
    told = "a tuple of two numbers, of data and of the basic rate"
    data, basic = _check_pair("threshold", threshold, told)
    data = _checks.number("threshold[0]", data, 0, MAX_DECIBELS)
    return data, _checks.number("threshold[1]", basic, 0, MAX_DECIBELS)


def _simulate_in_threads(setup: Setup, seeds: list[np.random.SeedSequence]) -> list[Run]:
    """Simulate all runs in parallel threads; refuse runs that do not fit into memory."""
    from discostorm_simulation.engine import MAX_MEGABYTES
    from discostorm_simulation.run import run_in_threads, simulate_run

    seconds, megabytes = setup.estimate()
    free = available_megabytes()
    if megabytes > min(free, MAX_MEGABYTES):
        raise ValueError(
            f"fleet must be smaller to be simulated here: a run needs about {megabytes:.0f} MB, "
            f"but the simulator can use at most {MAX_MEGABYTES:.0f} MB of the {free:.0f} MB "
            f"available; got {setup.hosts.host_of.size} processes"
        )
    if seconds * len(seeds) > _ESTIMATE_FROM_S and sys.stderr is not None:
        about = f"of about {seconds / 60:.1f} min and {megabytes:.0f} MB each"
        click.echo(f"discostorm: {wording.count_noun(len(seeds), 'run')} {about}", err=True)
    hidden = sys.stderr is None or seconds * len(seeds) < _PROGRESS_FROM_S
    workers = max(1, min(os.cpu_count() or 1, len(seeds), int(free / max(megabytes, 1.0))))
    runs = run_in_threads([partial(simulate_run, setup, seed) for seed in seeds], workers)
    with click.progressbar(
        runs, length=len(seeds), label="simulating", file=sys.stderr, hidden=hidden
    ) as shown:
        return list(shown)
