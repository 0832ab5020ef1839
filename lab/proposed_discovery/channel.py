"""A shared medium for frames of any protocol: contention, queues and losses.

The rules and numbers are those of `discostorm_simulation.channel_access` (IEEE Std 802.11-2020,
10.3 and 10.23.2), without aggregation. That engine is compiled for message tables; this medium
carries frames that a protocol creates while it runs. It is slower and simpler: each step counts the
slots of all waiting stations, an idle host keeps no back-off, and a collided station contends from
AIFS on (there: after its timeout for the acknowledgement).
"""

from collections import deque
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from discostorm.wifi import Radio, Wifi
from discostorm_simulation.cell_setup import MAX_ATTEMPTS, RX_START_DELAY

#: Headers [B] are already part of a frame's size.
UP, DOWN = 0, 1


@dataclass(frozen=True)
class Timing:
    """Timing of a radio on the medium [s], and the airtime of its links."""

    slot: float
    aifs: float
    sifs: float
    ack: float
    timeout: float
    cw_min: int
    cw_max: int
    edca: int
    data: tuple[tuple[float, int, int, float, float], ...]
    airtime: tuple[tuple[float, float], ...]

    def duration(self, octets: int, multicast: bool) -> float:
        """Return the duration of a PPDU [s]."""
        preamble, bits, added, symbol, grid = self.data[multicast]
        symbols = -(-(added + 8 * octets) // bits)
        return preamble + -(-round(symbols * symbol * 1e7) // round(grid * 1e7)) * grid

    def cost(self, octets: int, multicast: bool) -> float:
        """Return a frame's airtime by the paper's equation (11), with the link's overhead [s]."""
        rate, overhead = self.airtime[multicast]
        return 8 * octets / rate + overhead


def timing_of(wifi: Wifi) -> Timing:
    """Return the timing of a channel; refuse a channel without a radio."""
    radio: Radio | None = wifi.radio
    if radio is None:
        raise ValueError(
            "wifi must have a radio to simulate, as those of ds.Radio(...).wifi(), ds.WIFI and "
            f"ds.PAPER have; got {wifi.name!r}"
        )
    fast = wifi.unicast.padding or radio.padding
    slow = wifi.multicast.padding or radio.multicast_padding
    waiting = radio.aifs + radio.cw_min / 2 * radio.slot
    preambles = (
        radio.preamble + radio.signal_extension,
        radio.wifi().multicast.overhead - waiting,
    )
    return Timing(
        slot=radio.slot,
        aifs=radio.aifs,
        sifs=radio.sifs,
        ack=radio.ack + radio.signal_extension,
        timeout=radio.sifs + radio.slot + RX_START_DELAY,
        cw_min=radio.cw_min,
        cw_max=radio.cw_max,
        edca=int(radio.standard not in ("802.11a", "802.11g")),
        data=tuple(
            (preamble, padding.bits, padding.added, padding.symbol, padding.grid)
            for preamble, padding in zip(preambles, (fast, slow), strict=True)
        ),
        airtime=tuple((link.rate, link.overhead) for link in (wifi.unicast, wifi.multicast)),
    )


@dataclass(eq=False, slots=True)
class Frame:
    """A queued frame. Fields: source, destination (None: all), octets and content."""

    kind: str
    sender: int
    octets: int
    content: Any
    to: int | None = None
    came: float = 0.0
    tries: int = 0
    doomed: bool = False


@dataclass(eq=False)
class Channel:
    """The medium with hosts 0 to ``hosts`` - 1 and their access point, station ``hosts``.

    Parameters
    ----------
    timing : Timing
        Times of the radio.
    hosts : int
        Number of hosts [1].
    unicast_loss : float
        Share of unicast frames that are lost in spite of all retries [1]; the retries take their
        airtime.
    queue : tuple of (float, float)
        Limits of each queue: frames [1] and seconds [s].
    rng : numpy.random.Generator
        Draws back-offs and losses.
    """

    timing: Timing
    hosts: int
    unicast_loss: float
    queue: tuple[float, float]
    rng: np.random.Generator
    base: float = field(default=0.0, init=False)
    idle: float = field(default=-1.0, init=False)
    waiting: dict[int, int] = field(default_factory=dict, init=False)
    queues: list[deque[Frame]] = field(init=False)
    failures: NDArray[np.int64] = field(init=False)
    dead: NDArray[np.bool_] = field(init=False)
    #: Transmissions: start [s], airtime [s] and message kind.
    log: list[tuple[float, float, str, int]] = field(default_factory=list, init=False)
    collisions: int = field(default=0, init=False)
    dropped: int = field(default=0, init=False)

    def __post_init__(self) -> None:
        self.queues = [deque() for _ in range(self.hosts + 1)]
        self.failures = np.zeros(self.hosts + 1, np.int64)
        self.dead = np.zeros(self.hosts + 1, bool)

    def enqueue_or_drop(self, station: int, frame: Frame, time: float) -> None:
        """Enqueue a frame, or drop it if the queue is full; start contention if needed."""
        queue = self.queues[station]
        if len(queue) >= self.queue[0]:
            self.dropped += 1
            return
        frame.came, frame.tries = time, 0
        to_one = station < self.hosts or frame.to is not None
        frame.doomed = to_one and bool(self.rng.random() < self.unicast_loss)
        queue.append(frame)
        if station not in self.waiting:
            if time <= self.idle:
                slots = self._draw(station)
            elif time < self.base:
                slots = 0
            else:
                slots = int((time - self.base) / self.timing.slot) + 1
            self.waiting[station] = slots

    def discard_queues(self, hosts: NDArray[np.int64]) -> None:
        """Discard all queued frames of failed hosts."""
        self.dead[hosts] = True
        for host in hosts:
            self.queues[host].clear()
            self.waiting.pop(int(host), None)

    def next_time(self) -> float:
        """Return the time of the next transmission."""
        if not self.waiting:
            return float("inf")
        return self.base + min(self.waiting.values()) * self.timing.slot

    def transmit(self) -> Frame | None:
        """Transmit the next frames; return a frame that has arrived at its last hop, or None."""
        first = min(self.waiting.values())
        time = self.base + first * self.timing.slot
        senders = [station for station, slots in self.waiting.items() if slots == first]
        for station in senders:
            del self.waiting[station]
        for station in self.waiting:
            self.waiting[station] -= first + self.timing.edca
        senders = [station for station in senders if self._drop_expired(station, time)]
        if not senders:
            self.base = time
            return None
        ends = []
        for station in senders:
            frame = self.queues[station][0]
            multicast = self._to_all(station, frame)
            ends.append(time + self.timing.duration(frame.octets, multicast))
            # The hop of a host, or the access point's hop.
            hop = DOWN if station == self.hosts else UP
            self.log.append((time, self.timing.cost(frame.octets, multicast), frame.kind, hop))
        if len(senders) > 1:
            self.collisions += 1
            self.idle = max(ends)
            self.base = self.idle + self.timing.aifs
            for station in senders:
                if self._to_all(station, self.queues[station][0]):
                    self.queues[station].popleft()
                    self.failures[station] = 0
                    self._contend_again(station)
                else:
                    self._count_failure(station)
            return None
        (station,) = senders
        frame = self.queues[station][0]
        to_all = self._to_all(station, frame)
        self.idle = ends[0] + (0.0 if to_all else self.timing.sifs + self.timing.ack)
        self.base = self.idle + self.timing.aifs
        gone = frame.to is not None and station == self.hosts and bool(self.dead[frame.to])
        if not to_all and (frame.doomed or gone):
            self.idle = ends[0]
            self.base = ends[0] + self.timing.timeout + self.timing.aifs
            self._count_failure(station)
            return None
        self.queues[station].popleft()
        self.failures[station] = 0
        self._contend_again(station)
        if station < self.hosts:
            self.enqueue_or_drop(self.hosts, frame, self.idle)
            return None
        return frame

    def _to_all(self, station: int, frame: Frame) -> bool:
        return station == self.hosts and frame.to is None

    def _drop_expired(self, station: int, time: float) -> bool:
        """Drop a station's expired frames; return whether a frame is left."""
        queue = self.queues[station]
        while queue and time - queue[0].came > self.queue[1]:
            queue.popleft()
            self.dropped += 1
        return bool(queue)

    def _draw(self, station: int) -> int:
        doubled = (self.timing.cw_min + 1) << int(self.failures[station])
        return int(self.rng.integers(min(doubled, self.timing.cw_max + 1)))

    def _contend_again(self, station: int) -> None:
        if self.queues[station]:
            self.waiting[station] = self._draw(station)

    def _count_failure(self, station: int) -> None:
        """Count a failed attempt of a station; drop the frame after its last attempt."""
        frame = self.queues[station][0]
        frame.tries += 1
        self.failures[station] += 1
        if frame.tries >= MAX_ATTEMPTS:
            self.queues[station].popleft()
            self.failures[station] = 0
            self.dropped += 1
        self._contend_again(station)
