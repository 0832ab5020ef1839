"""The rounds of the hybrid discovery: one speaker a host, packed sets, coded repair.

What it sends without losses is a table, `discostorm.protocols.hybrid`; what it does about losses,
deaths and newcomers is here, frame by frame on the same contended medium (see `channel`).

A host's *set* is what its processes and endpoints are; hosts are numbered by their addresses.
Each speaker keeps which sets it holds and which it knows to exist, and acts by five clocks:

- ANNOUNCE: its own set, by multicast, after a random time that grows with the number of hosts
  heard of (timer reconsideration). Who has heard a description equal to its own sends the hash.
- DIGEST: what it holds, lacks and has given up, by multicast, once nothing new has come for a
  while, unless others have asked for as much, or have shown the same.
- REPAIR: the exclusive-or of a random choice of the sets that others have asked for and that it
  holds; it stops when it has heard as many as the neediest lacks.
- BEAT: a heartbeat with a hash of what it holds, and of whom it has heard of late.
- PULL: a newcomer asks the first settled host it hears for all sets, by unicast.

The hash of a set is taken to be without collisions, and a version never changes in a run.
"""

from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from discostorm import _checks
from discostorm.data import read_data
from discostorm.fleet import Fleet
from discostorm.messages import header_bytes
from discostorm.simulation.channel import Channel, Frame, timing_of
from discostorm.simulation.traffic import hosts_of
from discostorm.wifi import Wifi

Bits = NDArray[np.uint64]
Indices = NDArray[np.int64]
Bools = NDArray[np.bool_]
#: Takes the speakers and a generator, returns who dies.
Choice = Callable[["Speakers", np.random.Generator], Indices]

ANNOUNCE, DIGEST, REPAIR, BEAT = range(4)
_NEVER = np.inf
_WORD = 64
_ONE = np.uint64(1)
_PLACES = np.arange(_WORD, dtype=np.uint64)


@cache
def parameters() -> dict[str, float]:
    """Return the protocol's sizes [B], times [s] and counts by name, from its data file."""
    return {row["quantity"]: float(row["value"]) for row in read_data("hybrid/parameters.csv")}


@dataclass(frozen=True)
class HybridRun:
    """What one run found.

    Parameters
    ----------
    convergence_time : float
        Since when all living hosts that have started hold all sets of each other, for the last
        time, from 0 on [s]; infinity if at the end they do not.
    complete : ndarray
        Since when each host holds all sets of the living [s]; infinity if it does not.
    airtime : float
        Of all transmissions, by equation (11) [s].
    airtime_converged : float
        The same of those that began before the convergence time [s].
    busiest_second : float
        Most airtime that began within any second [s].
    frames : dict of str to int
        Frames offered by kind [1].
    mistaken : int
        How often a living host was given up [1].
    gone : float
        When the last survivor gave up the last dead host [s]; infinity if one has not.
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


@dataclass(eq=False)
class Speakers:
    """All speakers of a run: who holds what. Row h is host h; bits are hosts, 64 to a word."""

    hosts: int
    start: NDArray[np.float64]
    own: Bits = field(init=False)
    held: Bits = field(init=False)
    known: Bits = field(init=False)
    gone: Bits = field(init=False)
    wanted: Bits = field(init=False)
    asked: Bits = field(init=False)
    need: Indices = field(init=False)
    asked_for: Indices = field(init=False)
    basis: Bits = field(init=False)
    heard: NDArray[np.float64] = field(init=False)
    direct: NDArray[np.float64] = field(init=False)
    due: NDArray[np.float64] = field(init=False)
    wait: NDArray[np.float64] = field(init=False)
    pulled: NDArray[np.float64] = field(init=False)
    seen_equal: Bools = field(init=False)
    seen_description: Bools = field(init=False)
    alive: Bools = field(init=False)
    sent: Indices = field(init=False)
    announced: NDArray[np.float64] = field(init=False)
    denied: NDArray[np.float64] = field(init=False)
    repeats: NDArray[np.float64] = field(init=False)

    def __post_init__(self) -> None:
        count, words = self.hosts, -(-self.hosts // _WORD)
        self.own = np.zeros((count, words), np.uint64)
        index = np.arange(count)
        self.own[index, index // _WORD] = _ONE << (index % _WORD).astype(np.uint64)
        self.held, self.known = self.own.copy(), self.own.copy()
        for name in ("gone", "wanted", "asked"):
            setattr(self, name, np.zeros((count, words), np.uint64))
        for name in ("need", "asked_for"):
            setattr(self, name, np.zeros((count, words), np.int64))
        self.basis = np.zeros((count, words, _WORD), np.uint64)
        # When each was heard last, by itself or in what another says of late; and by itself.
        self.heard = np.full((count, count), -np.inf)
        self.direct = np.full((count, count), -np.inf)
        self.due = np.full((4, count), _NEVER)
        self.wait = np.full(count, parameters()["retry"])
        self.pulled = np.full(count, -np.inf)
        self.seen_equal = np.zeros(count, bool)
        self.seen_description = np.zeros(count, bool)
        self.alive = np.ones(count, bool)
        self.sent = np.zeros(count, np.int64)
        self.announced = np.full(count, -np.inf)
        # How many have shown that they do not know it; not a number once somebody does.
        self.denied = np.zeros(count)
        self.repeats = np.zeros(count)

    def learn(self, who: Indices, word: int, mask: np.uint64) -> Bools:
        """Let hosts receive the exclusive-or of the sets in a mask; return to whom it was news.

        What a host cannot resolve yet stays as an equation, in reduced echelon form.
        """
        value = mask & ~self.held[who, word]
        rows = self.basis[who, word]
        chosen = ((value[:, None] >> _PLACES) & _ONE).astype(bool)
        value ^= np.bitwise_xor.reduce(np.where(chosen, rows, np.uint64(0)), axis=1)
        news = value != 0
        if news.any():
            value, rows, some = value[news], rows[news], who[news]
            low = value & (~value + _ONE)
            place = np.bitwise_count(low - _ONE).astype(np.int64)
            hit = ((rows >> place[:, None].astype(np.uint64)) & _ONE).astype(bool)
            rows ^= np.where(hit, value[:, None], np.uint64(0))
            rows[np.arange(some.size), place] = value
            solved = (rows != 0) & ((rows & (rows - _ONE)) == 0)
            new = np.bitwise_or.reduce(np.where(solved, rows, np.uint64(0)), axis=1)
            rows[solved] = 0
            self.basis[some, word] = rows
            self.held[some, word] |= new
            self.known[some, word] |= new
        found: Bools = news
        return found

    def lacks(self, who: Any) -> Bits:
        """Return which sets hosts lack that they know to exist."""
        found: Bits = self.known[who] & ~self.held[who] & ~self.gone[who]
        return found


def bits_of(hosts: NDArray[Any], words: int) -> Bits:
    """Return the words in which the bits of these hosts are set."""
    found = np.zeros(words, np.uint64)
    for host in hosts:
        found[int(host) // _WORD] |= _ONE << np.uint64(int(host) % _WORD)
    return found


@dataclass(frozen=True)
class Sizes:
    """Octets of the frames of a fleet on the air, with the headers of UDP and below."""

    whole: Indices
    hashed: Indices
    headers: int

    def coded(self, sets: Indices, many: int) -> int:
        """Return the octets of so many repairs in a frame, each as long as the longest set."""
        value = parameters()
        above = self.headers + value["header"]
        return int(above + many * (sets.max() - above + value["coded"]))

    def together(self, sets: Indices) -> int:
        """Return how many repairs share a frame."""
        one = self.coded(sets, 1) - self.coded(sets, 0)
        return max(1, int(parameters()["packed"] // one))

    def digest(self, hosts: int) -> int:
        """Return the octets of a digest of so many hosts."""
        value = parameters()
        return int(np.ceil(self.headers + value["header"] + value["listed"] * hosts))

    def heartbeat(self, hosts: int) -> int:
        """Return the octets of a heartbeat that tells of so many hosts."""
        value = parameters()
        return int(np.ceil(self.headers + value["header"] + value["claimed"] * hosts))


def sizes_of(fleet: Fleet) -> Sizes:
    """Return the octets of each host's set, with its endpoints or with their hash."""
    value, hosts, headers = parameters(), hosts_of(fleet), header_bytes()["UDP"]
    base = headers + value["header"] + value["process"] * hosts.processes
    whole = base + value["endpoint"] * hosts.processes * hosts.endpoints
    most = headers + value["datagram"]
    if whole.max() > most:
        raise ValueError(
            f"fleet must have sets of at most {value['datagram']:g} B to simulate, so that one is "
            f"a frame; got {whole.max() - headers:g} B"
        )
    return Sizes(
        np.ceil(whole).astype(np.int64),
        np.ceil(base + value["software"]).astype(np.int64),
        headers,
    )


@dataclass(frozen=True)
class Death:
    """Who dies when: a time [s] and a choice, which may read all that the speakers hold."""

    time: float
    choose: Choice


def hybrid_run(
    fleet: Fleet,
    wifi: Wifi,
    *,
    alike: bool = False,
    loss: tuple[float, float] = (0.2, 0.01),
    fade: float = 0.0,
    queue: tuple[float, float] = (500, 0.5),
    start: Any = 0.0,
    part: Any = 0,
    death: Death | None = None,
    until: float = 10.0,
    enough: float = np.inf,
    seed: int = 0,
) -> HybridRun:
    """Simulate one run of the hybrid discovery on one Wi-Fi cell.

    Parameters
    ----------
    fleet : Fleet
        At least two hosts; the set of each must fit one datagram.
    wifi : Wifi
        A channel with a radio, without aggregation.
    alike : bool, optional
        Whether all hosts run the same software, so that all descriptions have one hash; else
        no two have.
    loss : tuple of (float, float), optional
        Part of the multicast frames that each host misses, and of the unicast hops that fail for
        good, after all attempts of Wi-Fi [1].
    fade : float, optional
        If above 0, a host misses all multicasts in fades of this mean length [s], exponential,
        which take the part of the time that `loss` says, instead of each frame on its own.
    queue : tuple of (float, float), optional
        Frames [1] and seconds that each queue holds.
    start : float or array, optional
        When each host starts [s]; those that start before 0 have settled, and hold the sets of
        all settled hosts of their part.
    part : int or array, optional
        Which settled hosts have met before the run; from 0 on all hear each other.
    death : Death, optional
        Hosts that die.
    until : float, optional
        When the run ends [s].
    enough : float, optional
        If all hold all sets, the run ends so long after anybody learned anything [s].
    seed : int, optional
        Of the random numbers.

    Returns
    -------
    HybridRun
        Times, airtime and counts.

    Raises
    ------
    ValueError
        If an argument is out of range, or the fleet or channel cannot be simulated.
    TypeError
        If an argument is of another kind.

    Examples
    --------
    >>> import discostorm as ds
    >>> found = hybrid_run(ds.Fleet.swarm(7, 2, 10), ds.PAPER, loss=(0, 0))
    >>> found.convergence_time < 1, found.mistaken
    (True, 0)
    """
    _checks.instance("fleet", fleet, Fleet)
    _checks.instance("wifi", wifi, Wifi)
    multicast = _checks.number("loss[0]", loss[0], 0, 1)
    unicast = _checks.number("loss[1]", loss[1], 0, 1)
    _checks.number("fade", fade, 0)
    _checks.number("until", until, 0, above=True)
    if wifi.aggregation is not None:
        raise ValueError(f"wifi must be without aggregation here; got {wifi.name!r}")
    sizes = sizes_of(fleet)
    count = sizes.whole.size
    starts = np.broadcast_to(np.asarray(start, np.float64), (count,)).copy()
    rng = np.random.default_rng(np.random.SeedSequence(seed))
    channel = Channel(timing_of(wifi), count, unicast, queue, rng)
    speakers = Speakers(count, starts)
    _settle(speakers, np.broadcast_to(np.asarray(part), (count,)), rng)
    run = _Run(speakers, channel, sizes, rng, alike, multicast, fade, death)
    run.begin()
    run.go(until, enough)
    return run.result()


def _settle(speakers: Speakers, part: NDArray[Any], rng: np.random.Generator) -> None:
    """Let those that have started before the run know their part; the others announce."""
    value, settled = parameters(), speakers.start < 0
    words = speakers.held.shape[1]
    for number in np.unique(part[settled]):
        members = np.flatnonzero(settled & (part == number))
        bits = bits_of(members, words)
        speakers.held[members] = bits
        speakers.known[members] = bits
        for array in (speakers.heard, speakers.direct):
            array[np.ix_(members, members)] = 0.0
    period = beat_period(np.bitwise_count(speakers.known).sum(axis=1))
    speakers.due[BEAT, settled] = (rng.random(speakers.hosts) * period)[settled]
    young = ~settled
    speakers.due[ANNOUNCE, young] = (
        speakers.start + rng.random(speakers.hosts) * value["first_window"]
    )[young]
    speakers.seen_description[settled] = True


def beat_period(known: Any) -> Any:
    """Return the time between two heartbeats of a host that knows so many [s]."""
    return parameters()["heartbeat"] * np.maximum(1.0, np.asarray(known) / 100)


@dataclass(eq=False)
class _Run:
    """A run in progress."""

    speakers: Speakers
    channel: Channel
    sizes: Sizes
    rng: np.random.Generator
    alike: bool
    multicast_loss: float
    fade: float
    death: Death | None
    now: float = 0.0
    frames: Counter[str] = field(default_factory=Counter)
    mistaken: int = 0
    gone_at: float = 0.0
    changed: float = 0.0

    def begin(self) -> None:
        speakers, hosts = self.speakers, self.speakers.hosts
        self.value = parameters()
        self.words = speakers.held.shape[1]
        self.part_of_window = self.rng.random(hosts)
        young = speakers.start >= 0
        speakers.due[ANNOUNCE, young] = (
            speakers.start + self.part_of_window * self.value["first_window"]
        )[young]
        # Announcements come ever more slowly, until one in twice its airtime over their share.
        longest = (self.sizes.hashed if self.alike else self.sizes.whole).max()
        self.quiet = self.value["quiet"] * self.spacing(int(longest), "announce_share")
        self.faded = self.rng.random(hosts) < self.multicast_loss
        self.toggle = np.zeros(hosts)
        if self.fade:
            self.toggle = self.rng.exponential(self._fade_means())
        self.dead: Indices = np.zeros(0, np.int64)
        self.complete = np.full(hosts, _NEVER)
        self.incomplete = np.ones(hosts, bool)
        self.count_living()

    def _fade_means(self) -> NDArray[np.float64]:
        clear = self.fade * (1 - self.multicast_loss) / max(self.multicast_loss, 1e-9)
        return np.where(self.faded, self.fade, clear)

    # ------------------------------------------------------------ the clock

    def go(self, until: float, enough: float) -> None:
        """Go from one event to the next."""
        speakers, channel = self.speakers, self.channel
        death = self.death.time if self.death else _NEVER
        starts = sorted(set(speakers.start[speakers.start > 0].tolist()))
        while True:
            flat = int(speakers.due.argmin())
            kind, host = divmod(flat, speakers.hosts)
            timer = float(speakers.due[kind, host])
            sending = channel.next_time()
            begun = starts[0] if starts else _NEVER
            time = min(timer, sending, death, begun)
            settled = time > self.changed + enough and not self.incomplete[self.there].any()
            if time > until or settled:
                return
            self.now = time
            if time == begun:
                starts.pop(0)
                self.count_living()
            elif time == death:
                death = _NEVER
                self.kill()
            elif timer <= sending:
                speakers.due[kind, host] = _NEVER
                self.act(kind, host)
            else:
                frame = channel.transmit()
                if frame is not None:
                    self.now = channel.idle
                    self.arrive(frame)

    def kill(self) -> None:
        assert self.death is not None
        self.dead = np.asarray(self.death.choose(self.speakers, self.rng), np.int64)
        self.speakers.alive[self.dead] = False
        self.speakers.due[:, self.dead] = _NEVER
        self.channel.silence(self.dead)
        self.count_living()

    def count_living(self) -> None:
        """Note who is there, and who holds the sets of all these."""
        speakers = self.speakers
        self.there = speakers.alive & (speakers.start <= self.now)
        self.target = bits_of(np.flatnonzero(self.there), self.words)
        self.check(np.arange(speakers.hosts))

    def check(self, who: Indices) -> None:
        """Note who is complete now."""
        speakers = self.speakers
        missing = (self.target & ~speakers.held[who]).any(axis=1) | ~self.there[who]
        done = ~missing & self.incomplete[who]
        self.complete[who[done]] = self.now
        self.complete[who[missing]] = _NEVER
        self.changed = self.now
        self.incomplete[who] = missing

    # ------------------------------------------------------------ the clocks of a speaker

    def act(self, kind: int, host: int) -> None:
        if self.channel.queues[host]:  # its last frame is still waiting for the channel
            self.speakers.due[kind, host] = self.now + self.quiet * (0.5 + self.rng.random())
            return
        (self.announce, self.digest, self.repair, self.beat)[kind](host)

    def send(self, kind: str, host: int, octets: int, content: Any, to: int | None = None) -> None:
        self.frames[kind] += 1
        self.speakers.sent[host] += 1
        settled = self.now - self.speakers.start[host] >= self.value["settled"]
        held = int(np.bitwise_count(self.speakers.held[host]).sum())
        frame = Frame(kind, host, octets, (settled, held, content), to)
        self.channel.offer(host, frame, self.now)

    def both_hops(self, octets: int) -> float:
        """Return the airtime of a multicast, up to the access point and down to all [s]."""
        timing = self.channel.timing
        return timing.cost(octets, False) + timing.cost(octets, True)

    def spacing(self, octets: int, share: str, least: float | None = None) -> float:
        """Return the mean time between multicasts of this size that take a share [s]."""
        least = self.value["least_spacing"] if least is None else least
        return max(least, self.both_hops(octets) / self.value[share])

    def known_to(self, who: Any) -> Any:
        return np.bitwise_count(self.speakers.known[who]).sum(axis=-1)

    def announce(self, host: int) -> None:
        speakers, value = self.speakers, self.value
        whole = not (self.alike and speakers.seen_description[host])
        octets = int((self.sizes.whole if whole else self.sizes.hashed)[host])
        spacing = self.spacing(octets, "announce_share")
        window = max(value["first_window"], spacing * int(self.known_to(host)))
        wanted = speakers.start[host] + self.part_of_window[host] * window
        if wanted > self.now:  # more hosts have been heard of since the time was drawn
            speakers.due[ANNOUNCE, host] = wanted
            return
        self.send("Announce", host, octets, whole)
        speakers.announced[host], speakers.denied[host] = self.now, 0
        speakers.due[BEAT, host] = self.now + beat_period(self.known_to(host)) * (
            0.5 + self.rng.random() / 2
        )
        if speakers.due[DIGEST, host] == _NEVER:
            self.soon(np.array([host]))

    def soon(self, who: Indices) -> None:
        """Let hosts send a digest once nothing new has come for a while."""
        spread = self.digest_spread(who)
        lacking = self.speakers.lacks(who).any(axis=1)
        spread = np.where(lacking, spread / 2, spread)
        delay = self.quiet + self.rng.random(who.size) * spread
        self.speakers.due[DIGEST, who] = self.now + delay

    def digest_spread(self, who: Indices) -> NDArray[np.float64]:
        """Return the time in which all hosts together may send a digest each [s]."""
        known = self.known_to(who)
        spread: NDArray[np.float64] = known * self.spacing(
            self.sizes.digest(int(known.max())), "digest_share", 0
        )
        return spread

    def digest(self, host: int) -> None:
        speakers = self.speakers
        lacks = speakers.lacks(host)
        many = np.bitwise_count(lacks).astype(np.int64)
        if not lacks.any() and speakers.seen_equal[host]:
            return
        asked = ((lacks & ~speakers.asked[host]) == 0) & (many <= speakers.asked_for[host])
        covered = bool(lacks.any() and asked.all())
        speakers.asked[host], speakers.asked_for[host] = 0, 0
        if not covered:
            content = (speakers.held[host].copy(), lacks.copy(), speakers.gone[host].copy())
            self.send("Digest", host, self.sizes.digest(int(self.known_to(host))), content)
        if lacks.any():
            wait = max(speakers.wait[host], float(self.digest_spread(np.array([host]))[0]))
            speakers.due[DIGEST, host] = self.now + wait * (1 + self.rng.random())
            speakers.wait[host] = min(2 * speakers.wait[host], self.value["retry_most"])
        else:
            speakers.seen_equal[host] = True

    def repair_delay(self, who: Indices) -> NDArray[np.float64]:
        sets = self.sizes.hashed if self.alike else self.sizes.whole
        octets = self.sizes.coded(sets, self.sizes.together(sets))
        spread = self.known_to(who) * self.spacing(octets, "share")
        delay: NDArray[np.float64] = self.rng.random(who.size) * spread
        return delay

    def repair(self, host: int) -> None:
        speakers = self.speakers
        able = speakers.wanted[host] & speakers.held[host]
        open_ = (speakers.need[host] > 0) & (able != 0)
        if not open_.any():
            speakers.need[host], speakers.wanted[host] = 0, 0
            return
        word = int(np.where(open_, speakers.need[host], -1).argmax())
        among = np.flatnonzero((able[word] >> _PLACES) & _ONE) + _WORD * word
        sets = (self.sizes.hashed if self.alike else self.sizes.whole)[among]
        room = self.sizes.together(sets)
        masks = [able[word]]
        if among.size > 1:
            masks = []
            while len(masks) < min(room, int(speakers.need[host, word])):
                mask = able[word] & np.uint64(self.rng.integers(2**64, dtype=np.uint64))
                if mask:
                    masks.append(mask)
        self.send("Repair", host, self.sizes.coded(sets, len(masks)), (word, masks))
        speakers.need[host, word] -= len(masks)
        if (speakers.need[host] > 0).any():
            speakers.due[REPAIR, host] = self.now + self.repair_delay(np.array([host]))[0]

    def beat(self, host: int) -> None:
        speakers = self.speakers
        period = float(beat_period(self.known_to(host)))
        speakers.due[BEAT, host] = self.now + period
        self.give_up(host, period)
        recent = speakers.direct[host] > self.now - period
        recent[host] = True
        content = (speakers.held[host].copy(), np.flatnonzero(recent))
        self.send("Heartbeat", host, self.sizes.heartbeat(int(self.known_to(host))), content)

    def give_up(self, host: int, period: float) -> None:
        """Drop the sets of those of whom nobody has said for a lease that he heard them."""
        speakers = self.speakers
        lease = self.value["lease"] * period / self.value["heartbeat"]
        never = speakers.heard[host] == -np.inf  # who was only told of counts from now on
        speakers.heard[host, never] = self.now
        late = speakers.heard[host] < self.now - lease
        late[host] = False
        lost = bits_of(np.flatnonzero(late), self.words) & speakers.known[host]
        if not lost.any():
            return
        for array in (speakers.held, speakers.known, speakers.wanted):
            array[host] &= ~lost
        speakers.gone[host] |= lost
        speakers.basis[host, lost != 0] = 0
        self.mistaken += int(
            np.bitwise_count(lost & bits_of(np.flatnonzero(speakers.alive), self.words)).sum()
        )
        dead = bits_of(self.dead, self.words)
        living = np.flatnonzero(self.there)
        if self.dead.size and not (speakers.known[living] & dead).any():
            self.gone_at = self.now
        self.check(np.array([host]))

    # ------------------------------------------------------------ what arrives

    def receivers(self, frame: Frame) -> Indices:
        """Return who hears a frame."""
        speakers = self.speakers
        there = self.there.copy()
        if frame.to is not None:
            return np.array([frame.to] if there[frame.to] else [], np.int64)
        there[frame.sender] = False
        if self.fade:
            while (late := self.toggle < self.now).any():
                self.faded ^= late
                self.toggle += np.where(late, self.rng.exponential(self._fade_means()), 0)
            return np.flatnonzero(there & ~self.faded)
        return np.flatnonzero(there & (self.rng.random(speakers.hosts) >= self.multicast_loss))

    def arrive(self, frame: Frame) -> None:
        who = self.receivers(frame)
        if not who.size:
            return
        speakers, sender = self.speakers, frame.sender
        settled, count, content = frame.content
        speakers.heard[who, sender] = self.now
        speakers.direct[who, sender] = self.now
        own = speakers.own[sender]
        if frame.kind == "Announce":
            back = (speakers.gone[who] & own).any(axis=1)
            speakers.gone[who[back]] &= ~own
            new = ~(speakers.known[who] & own).any(axis=1)
            if content:
                speakers.seen_description[who] = True
            self.take(who, sender // _WORD, own[sender // _WORD], new)
        elif frame.kind == "Repair":
            word, masks = content
            for mask in masks:
                fresh = (mask & ~speakers.known[who, word] & ~speakers.gone[who, word]) != 0
                useful = (mask & speakers.wanted[who, word]) != 0
                speakers.known[who, word] |= mask & ~speakers.gone[who, word]
                speakers.need[who[useful], word] -= 1
                self.take(who, word, mask, fresh)
        elif frame.kind == "Data":
            for word in range(self.words):
                for place in np.flatnonzero((content[word] >> _PLACES) & _ONE):
                    bit = _ONE << np.uint64(place)
                    self.take(who, word, bit, np.ones(who.size, bool))
        elif frame.kind == "Pull":
            self.serve(int(who[0]), sender, content)
        elif frame.kind == "Digest":
            self.compare(who, content)
        else:
            self.hear_beat(who, content)
        if settled:
            self.pull(who, sender, count)

    def take(self, who: Indices, word: int, mask: np.uint64, fresh: Bools) -> None:
        """Let hosts have a set, or an equation of several."""
        speakers = self.speakers
        news = speakers.learn(who, word, mask) | fresh
        if not news.any():
            return
        some = who[news]
        speakers.seen_equal[some] = False
        speakers.wait[some] = self.value["retry"]
        self.soon(some)
        self.check(some)

    def compare(self, who: Indices, content: tuple[Bits, Bits, Bits]) -> None:
        """Let hosts read a digest: what it has that they lack, and what it lacks."""
        speakers = self.speakers
        held, lacks, gone = content
        there = (held | lacks) & ~speakers.gone[who]
        fresh = (there & ~speakers.known[who]).any(axis=1)
        speakers.known[who] |= there
        speakers.asked[who] |= ~held
        missing = np.bitwise_count(lacks).astype(np.int64)
        speakers.asked_for[who] = np.maximum(speakers.asked_for[who], missing)
        equal = (speakers.held[who] == held).all(axis=1) & (speakers.known[who] == held).all(axis=1)
        speakers.seen_equal[who[equal]] = True
        self.hear_of_oneself(who, held)
        wants = speakers.held[who] & ~held & ~gone
        many = np.bitwise_count(wants).astype(np.int64)
        many += np.where(many > 1, int(self.value["surplus"]), 0)
        speakers.need[who] = np.maximum(speakers.need[who], many)
        speakers.wanted[who] |= wants
        start = who[wants.any(axis=1) & (speakers.due[REPAIR, who] == _NEVER)]
        if start.size:
            speakers.due[REPAIR, start] = self.now + self.repair_delay(start)
        if fresh.any():
            some = who[fresh]
            speakers.seen_equal[some] = False
            speakers.wait[some] = self.value["retry"]
            self.soon(some)
        forgotten = who[(speakers.own[who] & gone).any(axis=1)]
        speakers.due[ANNOUNCE, forgotten] = self.now

    def hear_beat(self, who: Indices, content: tuple[Bits, Indices]) -> None:
        speakers = self.speakers
        held, recent = content
        block = np.ix_(who, recent)
        speakers.heard[block] = np.maximum(speakers.heard[block], self.now)
        self.hear_of_oneself(who, bits_of(recent, self.words))
        unlike = (speakers.held[who] != held).any(axis=1)
        idle = unlike & (speakers.due[DIGEST, who] == _NEVER)
        if idle.any():
            speakers.seen_equal[who[idle]] = False
            self.soon(who[idle])

    def hear_of_oneself(self, who: Indices, listed: Bits) -> None:
        """Let hosts announce themselves again that several do not know, and nobody does."""
        speakers, value = self.speakers, self.value
        known = (speakers.own[who] & listed).any(axis=1)
        late = self.now - speakers.announced[who] > self.quiet * 2 ** speakers.repeats[who]
        speakers.denied[who[late & ~known]] += 1
        speakers.denied[who[known]] = np.nan
        again = who[late & (speakers.denied[who] >= value["denials"])]
        speakers.repeats[again] += speakers.due[ANNOUNCE, again] == _NEVER
        speakers.due[ANNOUNCE, again] = self.now + self.rng.random(again.size) * self.quiet

    def pull(self, who: Indices, sender: int, count: int) -> None:
        """Let newcomers ask a settled host for all that they lack."""
        speakers, value = self.speakers, self.value
        young = self.now - speakers.start[who] < value["settled"]
        young &= self.now - speakers.pulled[who] > value["retry"]
        for host in who[young]:
            if count - int(np.bitwise_count(speakers.held[host]).sum()) > value["pull_from"]:
                speakers.pulled[host] = self.now
                octets = self.sizes.digest(int(self.known_to(host)))
                at_once = self.now + self.rng.random() * self.quiet
                if speakers.due[ANNOUNCE, host] < _NEVER:  # the fleet is there: no need to spread
                    speakers.due[ANNOUNCE, host] = min(at_once, speakers.due[ANNOUNCE, host])
                    self.part_of_window[host] = 0.0
                self.send("Pull", int(host), octets, speakers.held[host].copy(), sender)
                speakers.due[DIGEST, host] = self.now + 2 * value["retry"]

    def serve(self, host: int, to: int, held: Bits) -> None:
        """Send a newcomer what it lacks, several sets in a datagram."""
        lacked = self.speakers.held[host] & ~held
        whole = (self.sizes.hashed if self.alike else self.sizes.whole) - self.sizes.headers
        packed, octets = np.zeros(self.words, np.uint64), 0
        sets = [
            (word, int(place))
            for word in range(self.words)
            for place in np.flatnonzero((lacked[word] >> _PLACES) & _ONE)
        ]
        for word, place in sets:
            size = int(whole[_WORD * word + place])
            if octets + size > self.value["datagram"]:
                self.send("Data", host, octets + self.sizes.headers, packed, to)
                packed, octets = np.zeros(self.words, np.uint64), 0
            packed[word] |= _ONE << np.uint64(place)
            octets += size
        if octets:
            self.send("Data", host, octets + self.sizes.headers, packed, to)

    # ------------------------------------------------------------ the end

    def result(self) -> HybridRun:
        speakers, channel = self.speakers, self.channel
        living = np.flatnonzero(speakers.alive & (speakers.start <= self.now))
        begins = np.array([row[0] for row in channel.log])
        costs = np.array([row[1] for row in channel.log])
        total = np.concatenate([[0.0], np.cumsum(costs)])
        ends = np.searchsorted(begins, begins + 1.0)
        worst = float((total[ends] - total[: begins.size]).max(initial=0.0))
        done = self.complete[living]
        given_up = self.gone_at if self.gone_at else _NEVER
        return HybridRun(
            convergence_time=float(done.max()),
            complete=self.complete,
            airtime=float(costs.sum()),
            airtime_converged=float(costs[begins < done.max()].sum()),
            busiest_second=worst,
            frames=dict(sorted(self.frames.items())),
            mistaken=self.mistaken,
            gone=given_up if self.dead.size else 0.0,
            collisions=channel.collisions,
            dropped=channel.dropped,
        )
