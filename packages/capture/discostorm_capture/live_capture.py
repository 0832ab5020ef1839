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
from discostorm_capture._types import Array
from discostorm_capture.capture import Capture
from discostorm_capture.diagnosis.diagnose import Diagnosis
from discostorm_capture.diagnosis.finding import Finding, to_sentence
from discostorm_capture.diagnosis.observations import ExpectedHosts
from discostorm_capture.pcap import MAX_PACKET_BYTES, PCAP_MAGICS, CaptureError
from discostorm_capture.presence import Presence
from discostorm_capture.read import read_capture

#: So many bytes of packets are kept, the newest ones, and diagnosed.
MAX_KEPT_BYTES = 8 << 20
#: So many packets are read to tell who speaks: few, so that it is told soon.
MAX_PRESENCE_PACKETS = 2000
#: A finding is certain when so many diagnoses in a row make it.
CERTAIN_COUNT = 2


class PacketStream:
    """The packets of a stream in pcap's format, which are taken from its bytes as they come."""

    def __init__(self, name: str) -> None:
        self.name, self.header, self._rest = name, b"", b""
        self._order, self._size, self._tick = "<", 16, 1000

    def packets_completed_by(self, data: bytes) -> Iterator[tuple[float, bytes]]:
        """Yield the time of each packet that is whole now [s], and its bytes with their header."""
        self._rest += data
        if not self.header:
            if len(self._rest) < 24:
                return
            if (magic := self._rest[:4]) not in PCAP_MAGICS:
                said = f"{self.name}: no pcap: it starts with {magic.hex(' ')}; pipe what "
                raise CaptureError(f"{said}`tcpdump -U -w -` or `dumpcap -P -w -` write")
            self._order, self._tick, self._size = PCAP_MAGICS[magic]
            self.header, self._rest = self._rest[:24], self._rest[24:]
        at = 0
        while at + self._size <= len(self._rest):
            second, part, size = struct.unpack_from(self._order + "III", self._rest, at)
            if size > MAX_PACKET_BYTES:
                said = f"a packet of {size} bytes; there are at most {MAX_PACKET_BYTES}"
                raise CaptureError(f"{self.name}: {said}")
            end = at + self._size + size
            if end > len(self._rest):
                break
            yield second + part * self._tick * 1e-9, self._rest[at:end]
            at = end
        self._rest = self._rest[at:]

    @property
    def error_if_ended(self) -> str:
        """What is wrong if the stream ends now; empty if nothing."""
        if not self.header:
            return f"{self.name}: it ended before a packet came; is the program before it running?"
        return f"{self.name}: it ended inside of a packet" if self._rest else ""


class Watch:
    """What is known of a capture so far; airtime is that on a channel."""

    def __init__(
        self, wifi: Wifi = PAPER, kept: int = MAX_KEPT_BYTES, expected: ExpectedHosts = None
    ) -> None:
        self.wifi, self.max_kept_bytes, self.expected = wifi, kept, expected
        #: The newest packets and their bytes; how many of them are new since the last diagnosis,
        #: and their bytes; how many of the new ones `presence` has taken in.
        self.kept_packets: deque[tuple[float, bytes]] = deque()
        self.kept_bytes = self.n_new = self.new_bytes = self.new_in_presence = 0
        #: Since the begin: packets; messages and their payload [B] by kind; airtime [s].
        self.packets = 0
        self.messages: Counter[str] = Counter()
        self.payload: Counter[str] = Counter()
        self.airtime = 0.0
        #: Of the last diagnosis: messages a second by kind; airtime of a second, now and at peak.
        self.rates: dict[str, float] = {}
        self.airtime_now = self.airtime_peak = 0.0
        self.diagnosis: Diagnosis | None = None
        #: Who is there, and what is wrong with that now.
        self.presence, self.host_findings = Presence(), list[Finding]()
        #: Findings that are certain, with when they became so [s since the begin].
        self.certain_findings: dict[tuple[str, tuple[str, ...]], tuple[float, Finding]] = {}
        #: When the first and the newest packet came [s since 1970].
        self.begin = self.end = 0.0
        self._last_second = (-1, 0.0)
        self._diagnosis_counts: dict[tuple[str, tuple[str, ...]], int] = {}

    def add_packet(self, time: float, packet: bytes) -> None:
        """Keep a packet; drop the oldest ones if there are too many."""
        if not self.packets:
            self.begin = self.end = time
        self.packets += 1
        self.kept_packets.append((time, packet))
        self.kept_bytes += len(packet)
        self.n_new += 1
        self.new_bytes += len(packet)
        while self.kept_bytes > self.max_kept_bytes and len(self.kept_packets) > self.n_new:
            self.kept_bytes -= len(self.kept_packets.popleft()[1])

    @property
    def must_count_now(self) -> bool:
        """Whether what is new has to be counted before more can be kept."""
        return self.new_bytes >= self.max_kept_bytes // 2

    def update_presence(self, header: bytes, idle: float = 0.0) -> bool:
        """Take in who speaks, or that nothing came [s]; return whether others are absent now."""
        before = {(one.kind, one.hosts) for one in self.host_findings}
        if self.n_new > self.new_in_presence:
            self._read_kept_packets(header, MAX_PRESENCE_PACKETS)
        elif self.kept_packets:
            self.presence.now = self.kept_packets[-1][0] + idle
            self.host_findings = self.presence.findings()
        return {(one.kind, one.hosts) for one in self.host_findings} != before

    def _read_kept_packets(self, header: bytes, packets: int = sys.maxsize) -> tuple[Capture, Any]:
        """Return the newest packets, and the new messages, whose senders it takes in."""
        newest = [
            packet for _, packet in islice(reversed(self.kept_packets), max(packets, self.n_new))
        ]
        capture = read_capture(io.BytesIO(b"".join([header, *reversed(newest)])))
        old = len(newest) - self.n_new
        rows = capture.messages().assign(airtime=capture.airtime(self.wifi))
        rows = rows[(rows["frame"] > old) & ~rows["copy"]]
        rows["time"] += capture.start
        self.presence.add_messages(rows[rows["frame"] > old + self.new_in_presence], self.begin)
        self.presence.add_refusals(capture._network_events, capture.start)
        self.new_in_presence, self.host_findings = self.n_new, self.presence.findings()
        return capture, rows

    def count_and_diagnose(self, header: bytes) -> None:
        """Count what is new, and diagnose what is kept."""
        if not self.n_new:
            self.rates, self.airtime_now = {}, 0.0
            if self.diagnosis is not None:
                self._update_findings(self.diagnosis)
            return
        capture, rows = self._read_kept_packets(header)
        old = len(self.kept_packets) - self.n_new
        newest = max(time for time, _ in list(self.kept_packets)[old:])
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
        self.n_new = self.new_bytes = self.new_in_presence = 0
        self._update_findings(capture.diagnosis(self.expected))
        del capture, rows
        # Tables leave free memory that glibc keeps, more from time to time.
        with suppress(AttributeError, OSError, TypeError):
            ctypes.CDLL(None).malloc_trim(0)

    def summary(self) -> str:
        """Return how discovery is, and if its start is not in view, whether all hosts are there."""
        if self.host_findings:
            first = self.host_findings[0]
            return " ".join(map(to_sentence, (first.summary, first.evidence, first.advice)))
        diagnosis = self.diagnosis
        if diagnosis is None or diagnosis.wrong or diagnosis.complete is not None:
            return "" if diagnosis is None else diagnosis.summary()
        late = any(one.kind == "capture began late" for one in diagnosis.findings)
        return self.presence.summary(self.begin) if late else diagnosis.summary()

    def _count_airtime(self, second: Array, airtime: Array) -> None:
        """Add airtime to the seconds in which it was; the last one may go on."""
        self.airtime += float(airtime.sum())
        if not len(second):
            self.airtime_now = 0.0
            return
        seconds, which = np.unique(second, return_inverse=True)
        spent = np.bincount(which, airtime)
        if self._last_second[0] == seconds[0]:
            spent[0] += self._last_second[1]
        self.airtime_peak = max(self.airtime_peak, float(spent.max()))
        self.airtime_now = (
            float(spent[-2]) if len(spent) > 1 else max(self._last_second[1], float(spent[0]))
        )
        self._last_second = int(seconds[-1]), float(spent[-1])

    def _update_findings(self, diagnosis: Diagnosis) -> None:
        """Keep the findings that two diagnoses in a row make, and who is absent."""
        self.diagnosis = diagnosis
        found = {(one.kind, one.hosts): one for one in (*self.host_findings, *diagnosis.findings)}
        self._diagnosis_counts = {
            key: self._diagnosis_counts.get(key, 0)
            + (CERTAIN_COUNT if one in self.host_findings else 1)
            for key, one in found.items()
        }
        elapsed = self.end - self.begin
        self.certain_findings = {
            key: (self.certain_findings.get(key, (elapsed, one))[0], one)
            for key, one in found.items()
            if self._diagnosis_counts[key] >= CERTAIN_COUNT
        }
