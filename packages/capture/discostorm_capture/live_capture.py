"""A capture while it is made: packets as they come, in a bounded amount of memory."""

from __future__ import annotations

import ctypes
import io
import struct
import sys
from collections import Counter, deque
from collections.abc import Iterator
from contextlib import suppress
from itertools import islice
from typing import Any

import numpy as np

from discostorm.wifi import PAPER, Wifi
from discostorm_capture._arrays import Array
from discostorm_capture.capture import Capture
from discostorm_capture.diagnosis.diagnose import Diagnosis
from discostorm_capture.diagnosis.finding import Finding, sentence
from discostorm_capture.diagnosis.observations import Expected
from discostorm_capture.pcap import MOST, PCAP, CaptureError
from discostorm_capture.presence import Presence
from discostorm_capture.read import read_capture

#: So many bytes of packets are kept, the newest ones, and diagnosed.
KEPT = 8 << 20
#: So many packets are read to tell who speaks: few, so that it is told soon.
LISTENED = 2000
#: A finding is certain when so many diagnoses in a row make it.
CERTAIN = 2


class PacketStream:
    """The packets of a stream in pcap's format, which are taken from its bytes as they come."""

    def __init__(self, name: str) -> None:
        self.name, self.header, self._rest = name, b"", b""
        self._order, self._size, self._tick = "<", 16, 1000

    def of(self, data: bytes) -> Iterator[tuple[float, bytes]]:
        """Yield the time of each packet that is whole now [s], and its bytes with their header."""
        self._rest += data
        if not self.header:
            if len(self._rest) < 24:
                return
            if (magic := self._rest[:4]) not in PCAP:
                said = f"{self.name}: no pcap: it starts with {magic.hex(' ')}; pipe what "
                raise CaptureError(f"{said}`tcpdump -U -w -` or `dumpcap -P -w -` write")
            self._order, self._tick, self._size = PCAP[magic]
            self.header, self._rest = self._rest[:24], self._rest[24:]
        at = 0
        while at + self._size <= len(self._rest):
            second, part, size = struct.unpack_from(self._order + "III", self._rest, at)
            if size > MOST:
                said = f"a packet of {size} bytes; there are at most {MOST}"
                raise CaptureError(f"{self.name}: {said}")
            end = at + self._size + size
            if end > len(self._rest):
                break
            yield second + part * self._tick * 1e-9, self._rest[at:end]
            at = end
        self._rest = self._rest[at:]

    @property
    def cut(self) -> str:
        """What is wrong if the stream ends now; empty if nothing."""
        if not self.header:
            return f"{self.name}: it ended before a packet came; is the program before it running?"
        return f"{self.name}: it ended inside of a packet" if self._rest else ""


class Watch:
    """What is known of a capture so far; airtime is that on a channel."""

    def __init__(self, wifi: Wifi = PAPER, kept: int = KEPT, expected: Expected = None) -> None:
        self.wifi, self.kept, self.expected = wifi, kept, expected
        #: The newest packets and their bytes; how many of them are new since the last diagnosis,
        #: and their bytes; how many of the new ones `presence` has taken in.
        self.ring: deque[tuple[float, bytes]] = deque()
        self.size = self.new = self.new_size = self.heard = 0
        #: Since the begin: packets; messages and their payload [B] by kind; airtime [s].
        self.packets = 0
        self.messages: Counter[str] = Counter()
        self.payload: Counter[str] = Counter()
        self.airtime = 0.0
        #: Of the last diagnosis: messages a second by kind; airtime of a second, now and at peak.
        self.rates: dict[str, float] = {}
        self.now = self.peak = 0.0
        self.diagnosis: Diagnosis | None = None
        #: Who is there, and what is wrong with that now.
        self.presence, self.absences = Presence(), list[Finding]()
        #: Findings that are certain, with when they became so [s since the begin].
        self.certain: dict[tuple[str, tuple[str, ...]], tuple[float, Finding]] = {}
        #: When the first and the newest packet came [s since 1970].
        self.begin = self.end = 0.0
        self._second = (-1, 0.0)
        self._diagnoses: dict[tuple[str, tuple[str, ...]], int] = {}

    def add(self, time: float, packet: bytes) -> None:
        """Keep a packet; drop the oldest ones if there are too many."""
        if not self.packets:
            self.begin = self.end = time
        self.packets += 1
        self.ring.append((time, packet))
        self.size += len(packet)
        self.new += 1
        self.new_size += len(packet)
        while self.size > self.kept and len(self.ring) > self.new:
            self.size -= len(self.ring.popleft()[1])

    @property
    def full(self) -> bool:
        """Whether what is new has to be counted before more can be kept."""
        return self.new_size >= self.kept // 2

    def listen(self, header: bytes, idle: float = 0.0) -> bool:
        """Take in who speaks, or that nothing came [s]; return whether others are absent now."""
        before = {(one.kind, one.hosts) for one in self.absences}
        if self.new > self.heard:
            self._read(header, LISTENED)
        elif self.ring:
            self.presence.now = self.ring[-1][0] + idle
            self.absences = self.presence.findings()
        return {(one.kind, one.hosts) for one in self.absences} != before

    def _read(self, header: bytes, packets: int = sys.maxsize) -> tuple[Capture, Any]:
        """Return the newest packets, and the new messages, whose senders it takes in."""
        newest = [packet for _, packet in islice(reversed(self.ring), max(packets, self.new))]
        capture = read_capture(io.BytesIO(b"".join([header, *reversed(newest)])))
        old = len(newest) - self.new
        rows = capture.messages().assign(airtime=capture.airtime(self.wifi))
        rows = rows[(rows["frame"] > old) & ~rows["copy"]]
        rows["time"] += capture.start
        self.presence.add_messages(rows[rows["frame"] > old + self.heard], self.begin)
        self.presence.add_refusals(capture._network_events, capture.start)
        self.heard, self.absences = self.new, self.presence.findings()
        return capture, rows

    def count_and_diagnose(self, header: bytes) -> None:
        """Count what is new, and diagnose what is kept."""
        if not self.new:
            self.rates, self.now = {}, 0.0
            if self.diagnosis is not None:
                self._diagnose(self.diagnosis)
            return
        capture, rows = self._read(header)
        old = len(self.ring) - self.new
        newest = max(time for time, _ in list(self.ring)[old:])
        seconds = max(newest - (self.end if old else self.begin), 1.0)
        self.end = max(self.end, newest)
        kinds = rows.groupby("kind", observed=True)["bytes"].agg(["size", "sum"])
        self.messages.update(dict(zip(kinds.index, kinds["size"].tolist(), strict=True)))
        self.payload.update(dict(zip(kinds.index, kinds["sum"].astype(int).tolist(), strict=True)))
        self.rates = {str(kind): int(count) / seconds for kind, count in kinds["size"].items()}
        self._count_airtime(rows["time"].to_numpy(np.int64), rows["airtime"].to_numpy())
        products = capture.processes().groupby("host")["product"].unique().map(", ".join)
        for address, host in self.presence.hosts.items():
            host.products = products.get(address, host.products)
        self.new = self.new_size = self.heard = 0
        self._diagnose(capture.diagnosis(self.expected))
        del capture, rows
        # Tables leave free memory that glibc keeps, more from time to time.
        with suppress(AttributeError, OSError, TypeError):
            ctypes.CDLL(None).malloc_trim(0)

    def summary(self) -> str:
        """Return how discovery is, and if its start is not in view, whether all hosts are there."""
        if self.absences:
            first = self.absences[0]
            return " ".join(map(sentence, (first.summary, first.evidence, first.advice)))
        diagnosis = self.diagnosis
        if diagnosis is None or diagnosis.wrong or diagnosis.complete is not None:
            return "" if diagnosis is None else diagnosis.summary()
        late = any(one.kind == "capture began late" for one in diagnosis.findings)
        return self.presence.summary(self.begin) if late else diagnosis.summary()

    def _count_airtime(self, second: Array, airtime: Array) -> None:
        """Add airtime to the seconds in which it was; the last one may go on."""
        self.airtime += float(airtime.sum())
        if not len(second):
            self.now = 0.0
            return
        seconds, which = np.unique(second, return_inverse=True)
        spent = np.bincount(which, airtime)
        if self._second[0] == seconds[0]:
            spent[0] += self._second[1]
        self.peak = max(self.peak, float(spent.max()))
        self.now = float(spent[-2]) if len(spent) > 1 else max(self._second[1], float(spent[0]))
        self._second = int(seconds[-1]), float(spent[-1])

    def _diagnose(self, diagnosis: Diagnosis) -> None:
        """Keep the findings that two diagnoses in a row make, and who is absent."""
        self.diagnosis = diagnosis
        found = {(one.kind, one.hosts): one for one in (*self.absences, *diagnosis.findings)}
        self._diagnoses = {
            key: self._diagnoses.get(key, 0) + (CERTAIN if one in self.absences else 1)
            for key, one in found.items()
        }
        elapsed = self.end - self.begin
        self.certain = {
            key: (self.certain.get(key, (elapsed, one))[0], one)
            for key, one in found.items()
            if self._diagnoses[key] >= CERTAIN
        }
