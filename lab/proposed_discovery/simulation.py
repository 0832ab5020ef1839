"""Simulate the hybrid discovery: one speaker per host, packed sets, coded repair.

Without losses, `discostorm.protocols.proposal` describes the traffic as a table. The rules in
`speaker` handle losses, failures and late joiners. Here, all speakers of a fleet follow these
rules, frame by frame on a contended medium (see `channel`).

Hashes of sets are assumed to have no collisions, and a set never changes during a run.
"""

from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from discostorm import _checks
from discostorm.fleet import Fleet
from discostorm.wifi import Wifi
from discostorm_simulation import _queue_limits
from proposed_discovery.channel import Channel, Frame, timing_of
from proposed_discovery.speaker import (
    HEARTBEAT,
    NEVER,
    FrameSizes,
    Indices,
    Message,
    Rules,
    Speakers,
    frame_sizes_of_fleet,
    heartbeat_period,
)

#: A function of the speakers and a random generator that returns the failing hosts.
Choice = Callable[["Speakers", np.random.Generator], Indices]


@dataclass(frozen=True)
class HybridRun:
    """Result of one run.

    Parameters
    ----------
    convergence_time : float
        Time from which on all living, started hosts hold all sets of each other [s]; infinity if
        they do not at the end.
    complete : ndarray
        Time from which on each host holds the sets of all living hosts [s]; infinity if never.
    airtime : float
        Airtime of all transmissions, by equation (11) [s].
    airtime_converged : float
        Airtime of the transmissions that began before the convergence time [s].
    busiest_second : float
        Maximum airtime of transmissions that began within one second [s].
    frames : dict of str to int
        Offered frames by message kind [1].
    mistaken : int
        Number of times that a living host was dropped [1].
    gone : float
        Time at which the last survivor dropped the last failed host [s]; infinity if never.
    collisions, dropped : int
        Collisions on the medium; frames that a queue or the medium lost for good [1].
    """

    convergence_time: float
    complete: NDArray[np.float64]
    airtime: float
    airtime_converged: float
    busiest_second: float
    frames: dict[str, int]
    mistaken: int
    gone: float
    collisions: int
    dropped: int


@dataclass(frozen=True)
class Crash:
    """A failure: its time [s], at least 0, and a choice that may read the state of all speakers.

    The choice returns indices of hosts, from 0 on, and leaves at least one host alive.
    """

    time: float
    choose: Choice


def simulate_proposed_discovery(
    fleet: Fleet,
    wifi: Wifi,
    *,
    alike: bool = False,
    loss: tuple[float, float] = (0.2, 0.01),
    fade: float = 0.0,
    queue: tuple[float, float] | None = (500, 0.5),
    start: Any = 0.0,
    part: Any = 0,
    apart: tuple[float, float] | None = None,
    crash: Crash | None = None,
    until: float = 10.0,
    enough: float = np.inf,
    seed: int = 0,
) -> HybridRun:
    """Simulate one run of the hybrid discovery on one Wi-Fi cell.

    Parameters
    ----------
    fleet : Fleet
        At least two hosts; a digest of all their sets must fit into one datagram.
    wifi : Wifi
        A channel with a radio, without aggregation.
    alike : bool, optional
        Whether all hosts run the same software, so that all descriptions have the same hash;
        otherwise all hashes differ.
    loss : tuple of (float, float), optional
        Share of multicast frames that each host misses, and share of unicast hops that fail after
        all retries of Wi-Fi [1]; 0 to 1.
    fade : float, optional
        Mean length of fades [s], at least 0. If positive, a host misses all multicasts during
        exponentially distributed fades, which take the share `loss` of the time; otherwise losses
        are independent.
    queue : tuple of (float, float), optional
        Limits of each queue: frames [1] and seconds [s], as for `discostorm.simulate`.
    start : float or array, optional
        Start of each host [s]; at least one host starts before the end. Hosts that start before 0
        are settled: they hold the sets of all settled hosts of their part.
    part : int or array, optional
        Number of each settled host's part, at least 0: hosts of a part have met before the run.
        From time 0 on, all hosts receive from each other.
    apart : tuple of (float, float), optional
        Start and end of a separation [s], at least 0: all settled hosts have met before the run,
        and in this time each receives only from its part.
    crash : Crash, optional
        Failing hosts.
    until : float, optional
        End of the run [s], above 0.
    enough : float, optional
        Time without news after which a converged run ends early [s]; at least 0, or infinity.
    seed : int, optional
        Random seed [1], at least 0.

    Returns
    -------
    HybridRun
        Times, airtime and counts.

    Raises
    ------
    ValueError
        If an argument is out of range, or the fleet or channel cannot be simulated.
    TypeError
        If an argument has the wrong type.

    Examples
    --------
    >>> import discostorm as ds
    >>> found = simulate_proposed_discovery(ds.Fleet.swarm(7, 2, 10), ds.PAPER, loss=(0, 0))
    >>> found.convergence_time < 1, found.mistaken
    (True, 0)
    """
    _checks.instance("fleet", fleet, Fleet)
    _checks.instance("wifi", wifi, Wifi)
    alike = _checks.boolean("alike", alike)
    if not isinstance(loss, (tuple, list)) or len(loss) != 2:
        raise TypeError(f"loss must be a tuple of two parts, multicast and unicast; got {loss!r}")
    multicast = _checks.number("loss[0]", loss[0], 0, 1)
    unicast = _checks.number("loss[1]", loss[1], 0, 1)
    _checks.number("fade", fade, 0)
    _checks.number("until", until, 0, exclusive_min=True)
    if not np.array_equal(enough, np.inf):
        _checks.number("enough", enough, 0)
    _checks.integer("seed", seed, 0)
    if crash is not None:
        _checks.instance("crash", crash, Crash)
        _checks.number("crash.time", crash.time, 0)
        if not callable(crash.choose):
            raise TypeError(f"crash.choose must be a function; got {crash.choose!r}")
    if apart is not None:
        if not isinstance(apart, (tuple, list)) or len(apart) != 2:
            raise TypeError(f"apart must be None or a tuple of two times; got {apart!r}")
        begin = _checks.number("apart[0]", apart[0], 0)
        _checks.number("apart[1]", apart[1], begin)
    if wifi.aggregation is not None:
        raise ValueError(f"wifi must be without aggregation here; got {wifi.name!r}")
    sizes = frame_sizes_of_fleet(fleet)
    count = len(sizes.whole)
    most = _checks.MAX_SECONDS
    starts = _one_per_host("start", _checks.numbers("start", start, -most, most), count)
    if starts.min() > until:
        raise ValueError(f"start must be by until, {until:g} s, for a host; got {starts.min():g}")
    parted = _one_per_host("part", _checks.numbers("part", part, 0), count)
    if (parted % 1).any():
        raise ValueError(f"part must be a whole number; got {parted[parted % 1 > 0][0]:g}")
    rng = np.random.default_rng(np.random.SeedSequence(int(seed)))
    channel = Channel(timing_of(wifi), count, unicast, _queue_limits(queue), rng)
    parts = np.ones(count, np.int64) if alike else (sizes.whole > 0).sum(axis=1)
    speakers = Speakers(count, starts, parts)
    run = _RunState(speakers, channel, sizes, rng, alike, multicast, fade, crash, parted, apart)
    run.fill_settled_hosts(parted if apart is None else 0 * parted)
    run.run_events(until, enough)
    return run.result()


def _one_per_host(name: str, value: ArrayLike, count: int) -> NDArray[np.float64]:
    """Return one number per host; refuse arrays of another size."""
    if np.shape(value) not in ((), (count,)):
        raise ValueError(
            f"{name} must be one number, or one for each of {count} hosts; "
            f"got shape {np.shape(value)}"
        )
    return np.broadcast_to(value, (count,)).astype(np.float64)


@dataclass(eq=False)
class _RunState:
    """A run in progress."""

    speakers: Speakers
    channel: Channel
    sizes: FrameSizes
    rng: np.random.Generator
    alike: bool
    multicast_loss: float
    fade: float
    crash: Crash | None
    part: NDArray[np.float64]
    apart: tuple[float, float] | None
    frames: Counter[str] = field(default_factory=Counter)
    mistaken: int = 0
    gone_at: float = np.inf
    last_change: float = 0.0

    def __post_init__(self) -> None:
        speakers, hosts = self.speakers, self.speakers.hosts
        self.rules = Rules(
            speakers,
            self.sizes,
            self.channel.timing,
            self.rng,
            self.alike,
            self.send,
            lambda host: bool(self.channel.queues[host]),
            self.record_changes,
        )
        self.faded = self.rng.random(hosts) < self.multicast_loss
        self.toggle = np.zeros(hosts)
        if self.fade:
            self.toggle = self.rng.exponential(self._fade_means())
        self.dead: Indices = np.zeros(0, np.int64)
        self.complete = np.full(hosts, NEVER)
        self.incomplete = np.ones(hosts, bool)
        self.given_up = speakers.gone.copy()

    def fill_settled_hosts(self, part: NDArray[Any]) -> None:
        """Give hosts that started before the run the sets of their part."""
        speakers, settled = self.speakers, self.speakers.start < 0
        for number in np.unique(part[settled]):
            members = np.flatnonzero(settled & (part == number))
            bits = speakers.bits_of_parts(members)
            speakers.held[members] = bits
            speakers.known[members] = bits
            for array in (speakers.heard, speakers.direct):
                array[np.ix_(members, members)] = 0.0
        period = heartbeat_period(self.rules.count_known_hosts(np.arange(speakers.hosts)))
        speakers.due[HEARTBEAT, settled] = (self.rng.random(speakers.hosts) * period)[settled]
        speakers.seen_description[settled] = True
        self.update_present_hosts()

    def _fade_means(self) -> NDArray[np.float64]:
        clear = self.fade * (1 - self.multicast_loss) / max(self.multicast_loss, 1e-9)
        return np.where(self.faded, self.fade, clear)

    def run_events(self, until: float, enough: float) -> None:
        """Simulate from event to event until the end of the run."""
        speakers, channel, rules = self.speakers, self.channel, self.rules
        crash = self.crash.time if self.crash else NEVER
        starts = sorted(set(speakers.start[speakers.start > 0].tolist()))
        while True:
            kind, host = divmod(int(speakers.due.argmin()), speakers.hosts)
            timer = float(speakers.due[kind, host])
            sending = channel.next_time()
            begun = starts[0] if starts else NEVER
            time = min(timer, sending, crash, begun)
            since = max([self.last_change, *starts[-1:], *(self.apart or ())])
            settled = time > since + enough and not self.incomplete[self.there].any()
            if time > until or settled:
                return
            rules.now = time
            if time == begun:
                starts.pop(0)
                self.update_present_hosts()
            elif time == crash:
                crash = NEVER
                self.crash_hosts()
            elif timer <= sending:
                rules.run_timer(kind, host)
            else:
                frame = channel.transmit()
                if frame is not None:
                    rules.now = channel.idle
                    receivers = self.receivers_of_frame(frame)
                    if receivers.size:
                        rules.receive_message(receivers, frame.content)

    def crash_hosts(self) -> None:
        assert self.crash is not None
        hosts = self.speakers.hosts
        chosen = np.asarray(self.crash.choose(self.speakers, self.rng))
        if not chosen.size:
            return
        if chosen.dtype.kind not in "iu" or chosen.min() < 0 or chosen.max() >= hosts:
            raise ValueError(
                f"crash.choose must return numbers of hosts, 0 to {hosts - 1}; got {chosen!r}"
            )
        if np.unique(chosen).size == hosts:
            raise ValueError("crash.choose must leave one host alive")
        self.dead = chosen.astype(np.int64).reshape(-1)
        self.speakers.alive[self.dead] = False
        self.speakers.due[:, self.dead] = NEVER
        self.channel.discard_queues(self.dead)
        self.update_present_hosts()

    def update_present_hosts(self) -> None:
        """Update the set of living hosts, and which hosts hold all their sets."""
        speakers = self.speakers
        self.there = speakers.alive & (speakers.start <= self.rules.now)
        self.target = speakers.bits_of_parts(self.there)
        self.record_changes(np.arange(speakers.hosts))

    def send(self, message: Message) -> None:
        """Put a speaker's message into its queue."""
        self.frames[message.kind] += 1
        frame = Frame(message.kind, message.sender, message.octets, message, message.to)
        self.channel.enqueue_or_drop(message.sender, frame, self.rules.now)

    def record_changes(self, hosts: Indices) -> None:
        """Record hosts that have become complete, and hosts that others have dropped."""
        speakers, now = self.speakers, self.rules.now
        missing = (self.target & ~speakers.held[hosts]).any(axis=1) | ~self.there[hosts]
        done = ~missing & self.incomplete[hosts]
        self.complete[hosts[done]] = now
        self.complete[hosts[missing]] = NEVER
        self.last_change = now
        self.incomplete[hosts] = missing
        lost = speakers.gone[hosts] & ~self.given_up[hosts] & speakers.bits_of_parts(speakers.alive)
        self.mistaken += int(np.bitwise_count(speakers.hosts_in(lost)).sum())
        self.given_up[hosts] = speakers.gone[hosts]
        if self.dead.size:
            there = (speakers.known[self.there] & speakers.bits_of_parts(self.dead)).any()
            self.gone_at = NEVER if there else min(self.gone_at, now)

    def receivers_of_frame(self, frame: Frame) -> Indices:
        """Return the receiving hosts of a frame."""
        speakers = self.speakers
        there = self.there.copy()
        if frame.to is not None:
            return np.array([frame.to] if there[frame.to] else [], np.int64)
        there[frame.sender] = False
        if self.apart and self.apart[0] <= self.rules.now < self.apart[1]:
            there &= self.part == self.part[frame.sender]
        if self.fade:
            while (late := self.toggle < self.rules.now).any():
                self.faded ^= late
                self.toggle += np.where(late, self.rng.exponential(self._fade_means()), 0)
            return np.flatnonzero(there & ~self.faded)
        return np.flatnonzero(there & (self.rng.random(speakers.hosts) >= self.multicast_loss))

    def result(self) -> HybridRun:
        speakers, channel = self.speakers, self.channel
        living = np.flatnonzero(speakers.alive & (speakers.start <= self.rules.now))
        begins = np.array([row[0] for row in channel.log])
        costs = np.array([row[1] for row in channel.log])
        total = np.concatenate([[0.0], np.cumsum(costs)])
        ends = np.searchsorted(begins, begins + 1.0)
        worst = float((total[ends] - total[: begins.size]).max(initial=0.0))
        done = self.complete[living]
        return HybridRun(
            convergence_time=float(done.max()),
            complete=self.complete,
            airtime=float(costs.sum()),
            airtime_converged=float(costs[begins < done.max()].sum()),
            busiest_second=worst,
            frames=dict(sorted(self.frames.items())),
            mistaken=self.mistaken,
            gone=self.gone_at if self.dead.size else 0.0,
            collisions=channel.collisions,
            dropped=channel.dropped,
        )
