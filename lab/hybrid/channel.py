"""One medium for frames of any kind: contention, queues and losses, one transmission a step.

The rules and numbers are those of `discostorm_simulation.channel_access` (IEEE Std 802.11-2020,
10.3 and 10.23.2), without aggregation. That engine is compiled for tables of messages; this one
carries what a protocol decides while it runs, and is meant for few frames: it counts back-off slots
of those that wait, a host that has nothing to send has no back-off, and who collided contends
from AIFS on as all others do (there after its timeout for the acknowledgement).
"""

from collections import deque
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from discostorm.wifi import Radio, Wifi
from discostorm_simulation.cell_setup import ATTEMPTS, RX_START_DELAY

#: Headers that a payload gets on the air [B] come with the frame's size.
UP, DOWN = 0, 1


@dataclass(frozen=True)
class Timing:
    """What the medium needs to know of a radio [s], and of its links."""

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
        """Return how long a PPDU takes."""
        preamble, bits, added, symbol, grid = self.data[multicast]
        symbols = -(-(added + 8 * octets) // bits)
        return preamble + -(-round(symbols * symbol * 1e7) // round(grid * 1e7)) * grid

    def cost(self, octets: int, multicast: bool) -> float:
        """Return the airtime of a frame by equation (11) of the paper, with the link's overhead."""
        rate, overhead = self.airtime[multicast]
        return 8 * octets / rate + overhead


def timing_of(wifi: Wifi) -> Timing:
    """Return the timing of a channel; refuse one without a radio."""
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
    """A frame on its way: who made it, for whom (none: for all), its octets and content."""

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
    """Hosts 0 to ``hosts`` - 1 and their access point, which is station ``hosts``.

    Parameters
    ----------
    timing : Timing
        Of the radio.
    hosts : int
        How many there are [1].
    unicast_loss : float
        Part of the frames to one station that do not arrive, whatever the attempts [1]: all of
        them are made and take their time.
    queue : tuple of (float, float)
        Frames [1] and seconds that each queue holds.
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
    #: Start [s], airtime [s] and kind of each transmission.
    log: list[tuple[float, float, str, int]] = field(default_factory=list, init=False)
    collisions: int = field(default=0, init=False)
    dropped: int = field(default=0, init=False)

    def __post_init__(self) -> None:
        self.queues = [deque() for _ in range(self.hosts + 1)]
        self.failures = np.zeros(self.hosts + 1, np.int64)
        self.dead = np.zeros(self.hosts + 1, bool)

    def offer(self, station: int, frame: Frame, time: float) -> None:
        """Put a frame into a queue, or drop it if that is full; contend if need be."""
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

    def silence(self, hosts: NDArray[np.int64]) -> None:
        """Let hosts die with all that they have not sent."""
        self.dead[hosts] = True
        for host in hosts:
            self.queues[host].clear()
            self.waiting.pop(int(host), None)

    def next_time(self) -> float:
        """Return when somebody sends next."""
        if not self.waiting:
            return float("inf")
        return self.base + min(self.waiting.values()) * self.timing.slot

    def transmit(self) -> Frame | None:
        """Let those send whose turn it is; return what arrived at its last hop, if anything."""
        first = min(self.waiting.values())
        time = self.base + first * self.timing.slot
        senders = [station for station, slots in self.waiting.items() if slots == first]
        for station in senders:
            del self.waiting[station]
        for station in self.waiting:
            self.waiting[station] -= first + self.timing.edca
        senders = [station for station in senders if self._fresh(station, time)]
        if not senders:
            self.base = time
            return None
        ends = []
        for station in senders:
            frame = self.queues[station][0]
            multicast = self._to_all(station, frame)
            ends.append(time + self.timing.duration(frame.octets, multicast))
            # A host's hop or the access point's.
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
                    self._again(station)
                else:
                    self._fail(station)
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
            self._fail(station)
            return None
        self.queues[station].popleft()
        self.failures[station] = 0
        self._again(station)
        if station < self.hosts:
            self.offer(self.hosts, frame, self.idle)
            return None
        return frame

    def _to_all(self, station: int, frame: Frame) -> bool:
        return station == self.hosts and frame.to is None

    def _fresh(self, station: int, time: float) -> bool:
        """Throw out what is too old; return whether anything is left."""
        queue = self.queues[station]
        while queue and time - queue[0].came > self.queue[1]:
            queue.popleft()
            self.dropped += 1
        return bool(queue)

    def _draw(self, station: int) -> int:
        doubled = (self.timing.cw_min + 1) << int(self.failures[station])
        return int(self.rng.integers(min(doubled, self.timing.cw_max + 1)))

    def _again(self, station: int) -> None:
        if self.queues[station]:
            self.waiting[station] = self._draw(station)

    def _fail(self, station: int) -> None:
        """Note that nothing came back; after all attempts the frame is lost."""
        frame = self.queues[station][0]
        frame.tries += 1
        self.failures[station] += 1
        if frame.tries >= ATTEMPTS:
            self.queues[station].popleft()
            self.failures[station] = 0
            self.dropped += 1
        self._again(station)
