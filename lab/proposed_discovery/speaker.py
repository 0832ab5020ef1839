"""The rules of the hybrid discovery: timers, messages and reactions of a speaker.

`simulation` lets all speakers of a fleet follow these rules on a simulated medium; `wire` lets one
process follow them over UDP.

A host's *set* describes its processes and endpoints, in one part per datagram; hosts are numbered
by their addresses. Each speaker stores the parts that it holds and the parts that it knows to
exist, and acts on four timers:

- ANNOUNCE: multicast the own set after a random delay that grows with the number of known hosts
  (timer reconsideration). Instead of a description equal to a received one, send its hash.
- DIGEST: multicast the held, missing and dropped parts, after the own announcement and a quiet
  period, unless other hosts have requested or shown the same.
- REPAIR: multicast the exclusive-or of random held parts that other hosts have requested; include
  the own part if a single repair is enough. Stop after as many repairs as the neediest host lacks.
- BEAT: multicast a heartbeat with a hash of the held parts, and the recently received hosts.

After the first announcements, a late joiner requests all sets from a settled host by unicast. If
many hosts start together, these requests would fill the channel, so late joiners leave the sets to
digests and repairs. A speaker postpones digests and repairs if discovery has used its share of the
channel in the last second. A dropped host is restored by a message from that host, or by a
heartbeat that lists it.
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from discostorm.data import read_data
from discostorm.fleet import Fleet
from discostorm.messages import header_bytes
from discostorm_simulation.cell_setup import host_table
from proposed_discovery.channel import Timing

Bits = NDArray[np.uint64]
Indices = NDArray[np.int64]
Bools = NDArray[np.bool_]

ANNOUNCE, DIGEST, REPAIR, HEARTBEAT = range(4)
NEVER = np.inf
WORD_BITS = 64
ONE = np.uint64(1)
BIT_INDICES = np.arange(WORD_BITS, dtype=np.uint64)
#: Number of bins for the airtime of the last second.
AIRTIME_BINS = 10


@cache
def parameters() -> dict[str, float]:
    """Return the protocol's sizes [B], times [s] and counts by name, from its data file."""
    return {row["quantity"]: float(row["value"]) for row in read_data("hybrid/parameters.csv")}


@dataclass(eq=False)
class Speakers:
    """State of the speakers; row h belongs to host h.

    A bit stands for one part of one host's set, with 64 hosts per word: first the words for part 0
    of all hosts, then those for part 1, and so on.
    """

    hosts: int
    start: NDArray[np.float64]
    parts: Indices
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
    young: NDArray[np.float64] = field(init=False)
    due: NDArray[np.float64] = field(init=False)
    wait: NDArray[np.float64] = field(init=False)
    pulled: NDArray[np.float64] = field(init=False)
    met: Bools = field(init=False)
    seen_equal: Bools = field(init=False)
    seen_description: Bools = field(init=False)
    alive: Bools = field(init=False)
    sent: Indices = field(init=False)
    part: Indices = field(init=False)
    announced: NDArray[np.float64] = field(init=False)
    denied: NDArray[np.float64] = field(init=False)
    repeats: NDArray[np.float64] = field(init=False)
    air: NDArray[np.float64] = field(init=False)

    def __post_init__(self) -> None:
        count = self.hosts
        self.blocks = -(-count // WORD_BITS)
        words = self.blocks * int(self.parts.max())
        self.own = np.zeros((count, words), np.uint64)
        index = np.arange(count)
        for part in range(int(self.parts.max())):
            some = index[self.parts > part]
            place = ONE << (some % WORD_BITS).astype(np.uint64)
            self.own[some, part * self.blocks + some // WORD_BITS] = place
        self.held, self.known = self.own.copy(), self.own.copy()
        for name in ("gone", "wanted", "asked"):
            setattr(self, name, np.zeros((count, words), np.uint64))
        for name in ("need", "asked_for"):
            setattr(self, name, np.zeros((count, words), np.int64))
        self.basis = np.zeros((count, words, WORD_BITS), np.uint64)
        # Time of the last sign of life: from the host or from another's heartbeat (``heard``), from
        # the host itself (``direct``), and from the host before it had settled (``young``).
        for name in ("heard", "direct", "young"):
            setattr(self, name, np.full((count, count), -np.inf))
        self.due = np.full((4, count), NEVER)
        self.wait = np.full(count, parameters()["retry"])
        self.pulled = np.full(count, -np.inf)
        # Whether the host has received from a settled host while it was young.
        self.met = np.zeros(count, bool)
        self.seen_equal = np.zeros(count, bool)
        self.seen_description = np.zeros(count, bool)
        self.alive = np.ones(count, bool)
        self.sent = np.zeros(count, np.int64)
        # Part of the host's own set that it announces next.
        self.part = np.zeros(count, np.int64)
        self.announced = np.full(count, -np.inf)
        # Number of digests and heartbeats without this host; NaN after one with this host.
        self.denied = np.zeros((2, count))
        self.repeats = np.zeros(count)
        # Airtime received and sent, by tenths of the last second.
        self.air = np.zeros((count, AIRTIME_BINS))

    def bits_of_parts(self, hosts: Any) -> Bits:
        """Return words with the bits of all parts of these hosts."""
        found: Bits = np.bitwise_or.reduce(self.own[hosts], axis=0)
        return found

    def hosts_in(self, bits: Bits) -> Bits:
        """Return words with one bit per host that has any part in ``bits``."""
        parts = bits.reshape(*bits.shape[:-1], -1, self.blocks)
        found: Bits = np.bitwise_or.reduce(parts, axis=-2)
        return found

    def receive_combination(self, hosts: Indices, word: int, mask: np.uint64) -> Bools:
        """Let hosts receive the exclusive-or of the parts in a mask; return whether it was new.

        Unresolved combinations stay as equations, in reduced row echelon form.
        """
        value = mask & ~self.held[hosts, word]
        rows = self.basis[hosts, word]
        chosen = ((value[:, None] >> BIT_INDICES) & ONE).astype(bool)
        value ^= np.bitwise_xor.reduce(np.where(chosen, rows, np.uint64(0)), axis=1)
        news = value != 0
        if news.any():
            value, rows, some = value[news], rows[news], hosts[news]
            low = value & (~value + ONE)
            place = np.bitwise_count(low - ONE).astype(np.int64)
            hit = ((rows >> place[:, None].astype(np.uint64)) & ONE).astype(bool)
            rows ^= np.where(hit, value[:, None], np.uint64(0))
            rows[np.arange(some.size), place] = value
            solved = (rows != 0) & ((rows & (rows - ONE)) == 0)
            new = np.bitwise_or.reduce(np.where(solved, rows, np.uint64(0)), axis=1)
            rows[solved] = 0
            self.basis[some, word] = rows
            self.held[some, word] |= new
            self.known[some, word] |= new
        found: Bools = news
        return found

    def missing_parts(self, hosts: Any) -> Bits:
        """Return the parts that hosts know to exist but do not hold."""
        found: Bits = self.known[hosts] & ~self.held[hosts] & ~self.gone[hosts]
        return found


@dataclass(frozen=True)
class FrameSizes:
    """Frame sizes of a fleet [octets], with the headers of UDP and the layers below.

    ``whole`` has a row per host and a column per part, 0 for missing parts; ``hashed`` is the size
    of a set with a hash in place of its endpoints.
    """

    whole: Indices
    hashed: Indices
    headers: int

    def repair_octets(self, sets: Indices, count: int) -> int:
        """Return the octets of a frame with some repairs, each as long as the longest part."""
        value = parameters()
        above = self.headers + value["header"]
        return int(above + count * (sets.max() - above + value["coded"]))

    def max_repairs_per_frame(self, sets: Indices) -> int:
        """Return the number of repairs that fit into one frame."""
        one = self.repair_octets(sets, 1) - self.repair_octets(sets, 0)
        return max(1, int(parameters()["packed"] // one))

    def digest_octets(self, parts: int) -> int:
        """Return the octets of a digest with that many parts."""
        value = parameters()
        return int(np.ceil(self.headers + value["header"] + value["listed"] * parts))

    def heartbeat_octets(self, hosts: int) -> int:
        """Return the octets of a heartbeat with that many hosts."""
        value = parameters()
        return int(np.ceil(self.headers + value["header"] + np.ceil(value["claimed"] * hosts)))


def frame_sizes_of_fleet(fleet: Fleet) -> FrameSizes:
    """Return the frame sizes of a fleet; refuse a fleet whose digest exceeds a datagram."""
    value, hosts, headers = parameters(), host_table(fleet), header_bytes()["UDP"]
    processes = value["process"] * hosts.processes
    endpoints = np.bincount(hosts.host_of, hosts.endpoints_per_process, hosts.processes.size)
    set_octets = np.ceil(processes + value["endpoint"] * endpoints)
    room = int(value["datagram"] - value["header"])
    parts = np.maximum(1, np.ceil(set_octets / room)).astype(np.int64)
    base = headers + value["header"]
    number = np.arange(parts.max())
    whole = np.where(
        number < parts[:, None],
        base + np.clip(set_octets[:, None] - room * number, 0, room),
        0,
    )
    listed = value["listed"] * parts.size * parts.max()
    if listed > room:
        raise ValueError(
            f"fleet must be one whose digest is at most {value['datagram']:g} B, so that it is a "
            f"frame; {parts.size} hosts with sets of up to {parts.max()} datagrams take "
            f"{listed + value['header']:g} B"
        )
    hashed = np.ceil(base + processes + value["software"])
    if hashed.max() > headers + value["datagram"]:
        raise ValueError(
            f"fleet must have at most {(room - value['software']) // value['process']:g} processes "
            f"a host, so that a set without its endpoints is a frame; got {hosts.processes.max()}"
        )
    return FrameSizes(whole.astype(np.int64), hashed.astype(np.int64)[:, None], headers)


def heartbeat_period(known: Any) -> Any:
    """Return the interval between heartbeats of a host that knows a number of hosts [s]."""
    return parameters()["heartbeat"] * np.maximum(1.0, np.asarray(known) / 100)


@dataclass(frozen=True)
class Message:
    """A speaker's message to one host or to all, with the fields of every header."""

    kind: str
    sender: int
    octets: int
    settled: bool
    holds: int
    content: Any
    to: int | None = None


@dataclass(eq=False)
class Rules:
    """The rules for all speakers of a fleet, or for one speaker, whose rows alone change.

    Parameters
    ----------
    speakers : Speakers
        State and timers of the speakers.
    sizes : Sizes
        Frame sizes.
    timing : Timing
        Times of the channel, for delays that are multiples of airtimes.
    rng : numpy.random.Generator
        Generator of random times and choices.
    alike : bool
        Whether all hosts run the same software.
    send : callable
        Function that sends a message.
    busy : callable
        Function that returns whether a host's last message still waits for the channel.
    changed : callable
        Function that is called with the hosts whose held parts have changed.
    now : float, optional
        Current time [s]; callers set the time before `run_timer` and `receive_message`.
    """

    speakers: Speakers
    sizes: FrameSizes
    timing: Timing
    rng: np.random.Generator
    alike: bool
    send: Callable[[Message], None]
    busy: Callable[[int], bool]
    changed: Callable[[Indices], None]
    now: float = 0.0

    def __post_init__(self) -> None:
        speakers = self.speakers
        self.value = parameters()
        self.sets = self.sizes.hashed if self.alike else self.sizes.whole
        self.part_of_window = self.rng.random(speakers.hosts)
        young = speakers.start >= 0
        first = speakers.start + self.part_of_window * self.value["first_window"]
        speakers.due[ANNOUNCE, young] = first[young]
        # The longest gap between announcements is twice their airtime divided by their share.
        self.quiet = self.value["quiet"] * self.multicast_spacing(
            int(self.sets.max()), "announce_share"
        )
        self.bin = 0

    # ------------------------------------------------------------ airtimes and delays

    def both_hops(self, octets: int) -> float:
        """Return the airtime of a multicast on uplink and downlink [s]."""
        return self.timing.cost(octets, False) + self.timing.cost(octets, True)

    def multicast_spacing(self, octets: int, share: str, minimum: float | None = None) -> float:
        """Return the mean time between multicasts of this size at an airtime share [s]."""
        minimum = self.value["least_spacing"] if minimum is None else minimum
        return max(minimum, self.both_hops(octets) / self.value[share])

    def count_known_hosts(self, hosts: Any) -> Any:
        """Return the number of hosts that some hosts know to exist."""
        return np.bitwise_count(self.speakers.hosts_in(self.speakers.known[hosts])).sum(axis=-1)

    def address_list_length(self, hosts: Any) -> Any:
        """Return the length of a list of known and dropped hosts, by address."""
        speakers = self.speakers
        words = speakers.hosts_in(speakers.known[hosts] | speakers.gone[hosts])
        bits = np.unpackbits(words.view(np.uint8), axis=-1, bitorder="little")
        return bits.shape[-1] - bits[..., ::-1].argmax(axis=-1)

    def count_digest_parts(self, hosts: Any) -> Any:
        """Return the number of parts in a digest: all possible parts of the listed addresses."""
        return self.address_list_length(hosts) * (
            self.speakers.own.shape[1] // self.speakers.blocks
        )

    def add_airtime(self, hosts: Any, octets: int) -> None:
        """Add the airtime of a multicast to the hosts' bins."""
        number = max(self.bin, int(self.now * AIRTIME_BINS))
        past = np.arange(max(self.bin, number - AIRTIME_BINS) + 1, number + 1) % AIRTIME_BINS
        self.speakers.air[:, past] = 0
        self.bin = number
        self.speakers.air[hosts, number % AIRTIME_BINS] += self.both_hops(octets)

    def has_used_airtime(self, host: int) -> bool:
        """Return whether a host received the maximum airtime of discovery in the last second."""
        self.add_airtime([], 0)
        return bool(self.speakers.air[host].sum() > self.value["ceiling"])

    # ------------------------------------------------------------ timers of a speaker

    def run_timer(self, kind: int, host: int) -> None:
        """Run the action of a timer that is due, or postpone it on a busy channel."""
        due, one = self.speakers.due, np.array([host])
        due[kind, host] = NEVER
        if self.busy(host):
            due[kind, host] = self.now + self.quiet * (0.5 + self.rng.random())
        elif kind == DIGEST and self.has_used_airtime(host):
            spread = max(self.quiet, float(self.digest_window(one)[0]))
            due[kind, host] = self.now + self.quiet / 2 + self.rng.random() * spread
        elif kind == REPAIR and self.has_used_airtime(host):
            due[kind, host] = self.now + self.repair_delay(one)[0]
        else:
            (self.announce_next_part, self.send_digest, self.send_repairs, self.send_heartbeat)[
                kind
            ](host)

    def send_message(
        self, kind: str, host: int, octets: int, content: Any, to: int | None = None
    ) -> None:
        """Send a message."""
        speakers = self.speakers
        speakers.sent[host] += 1
        if to is None:
            self.add_airtime([host], octets)
        settled = bool(self.now - speakers.start[host] >= self.value["settled"])
        holds = int(np.bitwise_count(speakers.hosts_in(speakers.held[host])).sum())
        self.send(Message(kind, host, octets, settled, holds, content, to))

    def announce_next_part(self, host: int) -> None:
        """Announce the next part of the own set, or wait longer if more hosts are known now."""
        speakers, value = self.speakers, self.value
        part = int(speakers.part[host])
        whole = part > 0 or not (self.alike and speakers.seen_description[host])
        sizes = self.sizes.whole if whole else self.sizes.hashed
        octets = int(sizes[host, part])
        parts = int((sizes[host] > 0).sum())
        spacing = self.multicast_spacing(octets, "announce_share")
        many = int(self.count_known_hosts(host))
        if speakers.met[host]:  # settled hosts do not announce
            many = 1 + self.late_joiners_received(host)
        window = max(value["first_window"], spacing * parts * many)
        wanted = speakers.start[host] + (part + self.part_of_window[host]) / parts * window
        if wanted > self.now:  # more hosts became known since the draw
            speakers.due[ANNOUNCE, host] = wanted
            return
        self.send_message("Announce", host, octets, (part, whole))
        if part + 1 < parts:
            speakers.part[host] += 1
            speakers.due[ANNOUNCE, host] = self.now + spacing
            return
        speakers.part[host] = 0
        speakers.announced[host], speakers.denied[:, host] = self.now, 0
        speakers.due[HEARTBEAT, host] = self.now + heartbeat_period(
            self.count_known_hosts(host)
        ) * (0.5 + self.rng.random() / 2)
        if speakers.due[DIGEST, host] == NEVER:
            self.schedule_digest(np.array([host]))

    def schedule_digest(self, hosts: Indices) -> None:
        """Schedule a digest of announced hosts for a quiet moment without news."""
        speakers = self.speakers
        hosts = hosts[speakers.due[ANNOUNCE, hosts] == NEVER]
        if not hosts.size:
            return
        spread = self.digest_window(hosts)
        lacking = speakers.missing_parts(hosts).any(axis=1)
        spread = np.where(lacking, spread / 2, spread)
        # Other hosts may have started at the same time and still announce themselves.
        earliest = speakers.start[hosts] + self.value["first_window"]
        earliest += np.where(speakers.met[hosts], 2 * self.value["retry"], 0)
        begin = np.maximum(self.now + self.quiet, earliest)
        speakers.due[DIGEST, hosts] = begin + self.rng.random(hosts.size) * spread

    def digest_window(self, hosts: Indices) -> NDArray[np.float64]:
        """Return the window in which every host sends one digest [s]."""
        octets = self.sizes.digest_octets(int(self.count_digest_parts(hosts).max()))
        spread: NDArray[np.float64] = self.count_known_hosts(hosts) * self.multicast_spacing(
            octets, "digest_share", 0
        )
        return spread

    def send_digest(self, host: int) -> None:
        """Send a digest of held and missing parts, unless other hosts' digests cover it."""
        speakers = self.speakers
        lacks = speakers.missing_parts(host)
        many = np.bitwise_count(lacks).astype(np.int64)
        if not lacks.any() and speakers.seen_equal[host]:
            return
        asked = ((lacks & ~speakers.asked[host]) == 0) & (many <= speakers.asked_for[host])
        covered = bool(lacks.any() and asked.all())
        speakers.asked[host], speakers.asked_for[host] = 0, 0
        if not covered:
            content = (speakers.held[host].copy(), lacks.copy(), speakers.gone[host].copy())
            self.send_message(
                "Digest",
                host,
                self.sizes.digest_octets(int(self.count_digest_parts(host))),
                content,
            )
        if lacks.any():
            wait = max(speakers.wait[host], float(self.digest_window(np.array([host]))[0]))
            speakers.due[DIGEST, host] = self.now + wait * (1 + self.rng.random())
            speakers.wait[host] = min(2 * speakers.wait[host], self.value["retry_most"])
        else:
            speakers.seen_equal[host] = True

    def repair_delay(self, hosts: Indices) -> NDArray[np.float64]:
        """Draw the delay of hosts before a repair [s]."""
        octets = self.sizes.repair_octets(self.sets, self.sizes.max_repairs_per_frame(self.sets))
        spread = self.count_known_hosts(hosts) * self.multicast_spacing(octets, "share")
        delay: NDArray[np.float64] = self.rng.random(hosts.size) * spread
        return delay

    def send_repairs(self, host: int) -> None:
        """Send combinations of the most needed parts, unless other hosts have sent enough."""
        speakers = self.speakers
        able = speakers.wanted[host] & speakers.held[host]
        open_ = (speakers.need[host] > 0) & (able != 0)
        if not open_.any():
            speakers.need[host], speakers.wanted[host] = 0, 0
            return
        word = int(np.where(open_, speakers.need[host], -1).argmax())
        sets = self.part_sizes(word, able[word])
        room = self.sizes.max_repairs_per_frame(sets)
        masks = [able[word]]
        if sets.size > 1:
            masks = []
            while len(masks) < min(room, int(speakers.need[host, word])):
                mask = able[word] & np.uint64(self.rng.integers(2**64, dtype=np.uint64))
                if mask:
                    masks.append(mask)
            if speakers.need[host, word] == 1:  # possibly no other host holds this host's own part
                masks[0] |= able[word] & speakers.own[host, word]
        self.send_message("Repair", host, self.sizes.repair_octets(sets, len(masks)), (word, masks))
        speakers.need[host, word] -= len(masks)
        if (speakers.need[host] > 0).any():
            speakers.due[REPAIR, host] = self.now + self.repair_delay(np.array([host]))[0]

    def part_sizes(self, word: int, mask: np.uint64) -> Indices:
        """Return the sizes of the parts that a mask selects in a word [B]."""
        part, block = divmod(word, self.speakers.blocks)
        among = np.flatnonzero((mask >> BIT_INDICES) & ONE) + WORD_BITS * block
        found: Indices = self.sets[among, part]
        return found

    def send_heartbeat(self, host: int) -> None:
        """Send a heartbeat with the hash of held parts and the recently received hosts."""
        speakers = self.speakers
        period = float(heartbeat_period(self.count_known_hosts(host)))
        speakers.due[HEARTBEAT, host] = self.now + period
        self.drop_silent_hosts(host, period)
        recent = speakers.direct[host] > self.now - period
        recent[host] = True
        content = (speakers.held[host].copy(), np.flatnonzero(recent))
        self.send_message(
            "Heartbeat",
            host,
            self.sizes.heartbeat_octets(int(self.address_list_length(host))),
            content,
        )

    def drop_silent_hosts(self, host: int, period: float) -> None:
        """Drop the sets of hosts that no host has received from for a lease."""
        speakers = self.speakers
        lease = self.value["lease"] * period / self.value["heartbeat"]
        never = speakers.heard[host] == -np.inf  # a host known only from others counts from now on
        speakers.heard[host, never] = self.now
        late = speakers.heard[host] < self.now - lease
        late[host] = False
        lost = speakers.bits_of_parts(late) & speakers.known[host]
        if not lost.any():
            return
        for array in (speakers.held, speakers.known, speakers.wanted):
            array[host] &= ~lost
        speakers.gone[host] |= lost
        speakers.basis[host, lost != 0] = 0
        self.changed(np.array([host]))

    # ------------------------------------------------------------ received messages

    def receive_message(self, hosts: Indices, message: Message) -> None:
        """Let hosts receive a message."""
        speakers, sender, content = self.speakers, message.sender, message.content
        speakers.heard[hosts, sender] = self.now
        speakers.direct[hosts, sender] = self.now
        if message.kind == "Announce" and not message.settled:
            speakers.young[hosts, sender] = self.now
        if message.to is None:
            self.add_airtime(hosts, message.octets)
        self.restore_hosts(hosts, speakers.own[sender])
        if message.kind == "Announce":
            self.receive_announcement(hosts, sender, *content)
        elif message.kind == "Repair":
            word, masks = content
            for mask in masks:
                fresh = (mask & ~speakers.known[hosts, word] & ~speakers.gone[hosts, word]) != 0
                useful = (mask & speakers.wanted[hosts, word]) != 0
                speakers.known[hosts, word] |= mask & ~speakers.gone[hosts, word]
                speakers.need[hosts[useful], word] -= 1
                self.receive_part(hosts, word, mask, fresh)
        elif message.kind == "Data":
            for word in np.flatnonzero(content):
                for place in np.flatnonzero((content[word] >> BIT_INDICES) & ONE):
                    bit = ONE << np.uint64(place)
                    self.receive_part(hosts, int(word), bit, np.ones(hosts.size, bool))
        elif message.kind == "Pull":
            self.send_missing_sets(int(hosts[0]), sender, content)
        elif message.kind == "Digest":
            self.receive_digest(hosts, content)
        else:
            self.receive_heartbeat(hosts, content)
        if message.settled:
            self.request_missing_sets(hosts, sender, message.holds)

    def receive_announcement(self, hosts: Indices, sender: int, part: int, whole: bool) -> None:
        """Receive a part of an announced set, and note that its other parts exist."""
        speakers, own = self.speakers, self.speakers.own[sender]
        if whole:
            speakers.seen_description[hosts] = True
        if self.alike and part:  # this part equals the receiver's own
            return
        word = part * speakers.blocks + sender // WORD_BITS
        new = (own & ~speakers.known[hosts]).any(axis=1)
        speakers.known[hosts] |= own
        self.receive_part(hosts, word, own[word], new)

    def restore_hosts(self, hosts: Indices, bits: Bits) -> None:
        """Let hosts restore dropped hosts that are alive."""
        speakers = self.speakers
        some = hosts[(speakers.gone[hosts] & bits).any(axis=1)]
        if not some.size:
            return
        speakers.known[some] |= speakers.gone[some] & bits
        speakers.gone[some] &= ~bits
        speakers.seen_equal[some] = False
        self.schedule_digest(some)

    def receive_part(self, hosts: Indices, word: int, mask: np.uint64, fresh: Bools) -> None:
        """Receive a part, or an equation of several parts."""
        speakers = self.speakers
        news = speakers.receive_combination(hosts, word, mask) | fresh
        if not news.any():
            return
        some = hosts[news]
        speakers.seen_equal[some] = False
        speakers.wait[some] = self.value["retry"]
        self.schedule_digest(some)
        self.changed(some)

    def receive_digest(self, hosts: Indices, content: tuple[Bits, Bits, Bits]) -> None:
        """Receive a digest: note its parts, and schedule repairs of its missing parts."""
        speakers = self.speakers
        held, lacks, gone = content
        there = (held | lacks) & ~speakers.gone[hosts]
        fresh = (there & ~speakers.known[hosts]).any(axis=1)
        speakers.known[hosts] |= there
        speakers.asked[hosts] |= ~held
        missing = np.bitwise_count(lacks).astype(np.int64)
        speakers.asked_for[hosts] = np.maximum(speakers.asked_for[hosts], missing)
        equal = (speakers.held[hosts] == held).all(axis=1) & (speakers.known[hosts] == held).all(
            axis=1
        )
        speakers.seen_equal[hosts[equal]] = True
        self.announce_if_unlisted(hosts, held, speakers.denied[0])
        wants = speakers.held[hosts] & ~held & ~gone
        # A part that will be announced soon needs no repair.
        pending = speakers.due[ANNOUNCE, hosts] < NEVER
        wants &= ~np.where(pending[:, None], speakers.own[hosts], np.uint64(0))
        many = np.bitwise_count(wants).astype(np.int64)
        many += np.where(many > 1, int(self.value["surplus"]), 0)
        speakers.need[hosts] = np.maximum(speakers.need[hosts], many)
        speakers.wanted[hosts] |= wants
        start = hosts[wants.any(axis=1) & (speakers.due[REPAIR, hosts] == NEVER)]
        if start.size:
            speakers.due[REPAIR, start] = self.now + self.repair_delay(start)
        if fresh.any():
            some = hosts[fresh]
            speakers.seen_equal[some] = False
            speakers.wait[some] = self.value["retry"]
            self.schedule_digest(some)

    def receive_heartbeat(self, hosts: Indices, content: tuple[Bits, Indices]) -> None:
        """Receive a heartbeat: refresh leases, and send a digest if the hashes differ."""
        speakers = self.speakers
        held, recent = content
        block = np.ix_(hosts, recent)
        speakers.heard[block] = np.maximum(speakers.heard[block], self.now)
        claimed = speakers.bits_of_parts(recent)
        self.restore_hosts(hosts, claimed)
        self.announce_if_unlisted(hosts, claimed, speakers.denied[1])
        unlike = (speakers.held[hosts] != held).any(axis=1)
        idle = unlike & (speakers.due[DIGEST, hosts] == NEVER)
        if idle.any():
            speakers.seen_equal[hosts[idle]] = False
            self.schedule_digest(hosts[idle])

    def announce_if_unlisted(
        self, hosts: Indices, listed: Bits, denied: NDArray[np.float64]
    ) -> None:
        """Let hosts announce again if several messages, and no message since, leave them out.

        Digests and heartbeats are counted separately: digests list hosts whose sets are held,
        heartbeats list received hosts, perhaps without their sets.
        """
        speakers, value = self.speakers, self.value
        known = (speakers.own[hosts] & listed).any(axis=1)
        late = self.now - speakers.announced[hosts] > self.quiet * 2 ** speakers.repeats[hosts]
        late &= speakers.due[ANNOUNCE, hosts] == NEVER
        denied[hosts[late & ~known]] += 1
        denied[hosts[known]] = np.nan
        again = hosts[late & (denied[hosts] >= value["denials"])]
        speakers.repeats[again] += 1
        speakers.due[ANNOUNCE, again] = self.now + self.rng.random(again.size) * self.quiet

    def request_missing_sets(self, hosts: Indices, sender: int, count: int) -> None:
        """Let late joiners request all missing sets from a settled host."""
        speakers, value = self.speakers, self.value
        age = self.now - speakers.start[hosts]
        young = age < value["settled"]
        speakers.met[hosts[young]] = True
        asking = young & (age > value["first_window"]) & (speakers.pulled[hosts] < NEVER)
        for host in hosts[asking]:
            held = int(np.bitwise_count(speakers.hosts_in(speakers.held[host])).sum())
            if count - held <= value["pull_from"]:
                continue
            airtime_of_sets, late_joiners_received = (
                self.airtime_of_sets(host, count - held),
                self.late_joiners_received(host),
            )
            first = speakers.pulled[host] == -np.inf
            if (
                first
                and late_joiners_received
                and (late_joiners_received + 1) * airtime_of_sets > value["pull_share"]
            ):
                speakers.pulled[host] = NEVER  # repairs bring the sets to all
            elif self.now - speakers.pulled[host] > max(value["retry"], 2 * airtime_of_sets):
                speakers.pulled[host] = self.now
                octets = self.sizes.digest_octets(int(self.count_digest_parts(host)))
                at_once = self.now + self.rng.random() * self.quiet
                if speakers.due[ANNOUNCE, host] < NEVER:  # no need to spread announcements
                    speakers.due[ANNOUNCE, host] = min(at_once, speakers.due[ANNOUNCE, host])
                    self.part_of_window[host] = -np.inf
                self.send_message("Pull", int(host), octets, speakers.held[host].copy(), sender)
                speakers.due[DIGEST, host] = self.now + 2 * value["retry"]

    def late_joiners_received(self, host: int) -> int:
        """Return the number of other late joiners from which a host has recently received."""
        young = self.speakers.young[host] > self.now - self.value["lately"]
        return int(young.sum())

    def airtime_of_sets(self, host: int, count: int) -> float:
        """Return the airtime of some sets by unicast, on both hops [s]."""
        room = self.value["datagram"]
        frames = np.ceil(count * (self.sets[host].sum() - self.sizes.headers) / room)
        return float(2 * frames * self.timing.cost(int(room + self.sizes.headers), False))

    def send_missing_sets(self, host: int, to: int, held: Bits) -> None:
        """Send a late joiner its missing sets, several sets per datagram."""
        speakers, headers = self.speakers, self.sizes.headers
        lacked = speakers.held[host] & ~held
        packed, octets = np.zeros(lacked.size, np.uint64), 0
        for word in np.flatnonzero(lacked):
            places = np.flatnonzero((lacked[word] >> BIT_INDICES) & ONE)
            for place, size in zip(places, self.part_sizes(int(word), lacked[word]), strict=True):
                if octets + size - headers > self.value["datagram"]:
                    self.send_message("Data", host, octets + headers, packed, to)
                    packed, octets = np.zeros(lacked.size, np.uint64), 0
                packed[word] |= ONE << np.uint64(place)
                octets += int(size) - headers
        if octets:
            self.send_message("Data", host, octets + headers, packed, to)
