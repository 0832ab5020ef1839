"""Diagnose packets while they are captured, in a bounded amount of memory."""

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
from discostorm_capture.sentences import say

#: Maximum size of the newest packets, which are kept and diagnosed [B].
MAX_KEPT_BYTES = 8 << 20
#: Maximum number of packets that an update of host presence reads, so that it is fast.
MAX_PRESENCE_PACKETS = 2000
#: Number of diagnoses in a row after which a finding is certain.
CERTAIN_COUNT = 2


class PacketStream:
    """Splits the bytes of a pcap stream into packets as they arrive."""

    def __init__(self, name: str) -> None:
        self.name, self.header, self._rest = name, b"", b""
        self._order, self._size, self._tick = "<", 16, 1000

    def feed(self, data: bytes) -> Iterator[tuple[float, bytes]]:
        """Yield time [s] and bytes, with header, of each packet that these bytes complete."""
        self._rest += data
        if not self.header:
            if len(self._rest) < 24:
                return
            if (magic := self._rest[:4]) not in PCAP_MAGICS:
                raise CaptureError(say("no pcap", self.name, magic.hex(" ")))
            self._order, self._tick, self._size = PCAP_MAGICS[magic]
            self.header, self._rest = self._rest[:24], self._rest[24:]
        at = 0
        while at + self._size <= len(self._rest):
            second, part, size = struct.unpack_from(self._order + "III", self._rest, at)
            if size > MAX_PACKET_BYTES:
                raise CaptureError(say("packet too large", self.name, size, MAX_PACKET_BYTES))
            end = at + self._size + size
            if end > len(self._rest):
                break
            yield second + part * self._tick * 1e-9, self._rest[at:end]
            at = end
        self._rest = self._rest[at:]

    @property
    def error_if_ended(self) -> str:
        """The error message if the stream ends now; "" if that is no error."""
        if not self.header:
            return f"{self.name}: ended before any packet arrived; is its source running?"
        return f"{self.name}: ended in the middle of a packet" if self._rest else ""


class Watch:
    """Counts, airtime on a channel, diagnosis and present hosts of a running capture."""

    def __init__(
        self, wifi: Wifi = PAPER, max_bytes: int = MAX_KEPT_BYTES, expected: ExpectedHosts = None
    ) -> None:
        self.wifi, self.max_bytes, self.expected = wifi, max_bytes, expected
        #: The newest packets and their size; number and size of those that are new since the last
        #: diagnosis; how many of the new ones `presence` has processed.
        self.kept_packets: deque[tuple[float, bytes]] = deque()
        self.kept_bytes = self.n_new = self.new_bytes = self.new_in_presence = 0
        #: Totals: packets; messages and their payload [B] by kind; airtime [s].
        self.packets = 0
        self.messages: Counter[str] = Counter()
        self.payload: Counter[str] = Counter()
        self.airtime = 0.0
        #: Messages per second by kind at the last diagnosis; airtime per second, now and at peak.
        self.rates: dict[str, float] = {}
        self.airtime_now = self.airtime_peak = 0.0
        self.diagnosis: Diagnosis | None = None
        #: Which hosts are present, and current findings about them.
        self.presence, self.host_findings = Presence(), list[Finding]()
        #: Certain findings, and when they became certain [s since the first packet].
        self.certain_findings: dict[tuple[str, tuple[str, ...]], tuple[float, Finding]] = {}
        #: Time of the first and of the newest packet [s since 1970].
        self.begin = self.end = 0.0
        self._last_second = (-1, 0.0)
        self._diagnosis_counts: dict[tuple[str, tuple[str, ...]], int] = {}

    def add_packet(self, time: float, packet: bytes) -> None:
        """Keep a packet; drop the oldest ones if they exceed `max_bytes`."""
        if not self.packets:
            self.begin = self.end = time
        self.packets += 1
        self.kept_packets.append((time, packet))
        self.kept_bytes += len(packet)
        self.n_new += 1
        self.new_bytes += len(packet)
        while self.kept_bytes > self.max_bytes and len(self.kept_packets) > self.n_new:
            self.kept_bytes -= len(self.kept_packets.popleft()[1])

    @property
    def must_count_now(self) -> bool:
        """Whether the new packets have to be counted before more can be kept."""
        return self.new_bytes >= self.max_bytes // 2

    def update_presence(self, header: bytes, idle: float = 0.0) -> bool:
        """Update presence, `idle` s after the last packet; return whether findings changed."""
        before = {(one.kind, one.hosts) for one in self.host_findings}
        if self.n_new > self.new_in_presence:
            self._read_kept_packets(header, MAX_PRESENCE_PACKETS)
        elif self.kept_packets:
            self.presence.now = self.kept_packets[-1][0] + idle
            self.host_findings = self.presence.findings()
        return {(one.kind, one.hosts) for one in self.host_findings} != before

    def _read_kept_packets(self, header: bytes, packets: int = sys.maxsize) -> tuple[Capture, Any]:
        """Read the newest packets into a capture; return it, and its new messages."""
        newest = [*islice(reversed(self.kept_packets), max(packets, self.n_new))][::-1]
        content = b"".join([header, *(packet for _, packet in newest)])
        capture = read_capture(io.BytesIO(content))
        old = len(newest) - self.n_new
        rows = capture.messages().assign(airtime=capture.airtime(self.wifi))
        rows = rows[(rows["frame"] > old) & ~rows["copy"]]
        rows["time"] += capture.start
        self.presence.add_messages(rows[rows["frame"] > old + self.new_in_presence], self.begin)
        self.presence.add_refusals(capture._network_events, capture.start)
        self.new_in_presence, self.host_findings = self.n_new, self.presence.findings()
        return capture, rows

    def count_and_diagnose(self, header: bytes) -> None:
        """Count the new packets, and diagnose all kept ones."""
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
        # Without this, glibc keeps ever more memory that freed tables leave.
        with suppress(AttributeError, OSError, TypeError):
            ctypes.CDLL(None).malloc_trim(0)

    def summary(self) -> str:
        """Return the state of discovery, or of the hosts if its startup was not captured."""
        if self.host_findings:
            first = self.host_findings[0]
            return " ".join(map(to_sentence, (first.summary, first.evidence, first.advice)))
        diagnosis = self.diagnosis
        if diagnosis is None or diagnosis.wrong or diagnosis.complete is not None:
            return "" if diagnosis is None else diagnosis.summary()
        late = any(one.kind == "capture began late" for one in diagnosis.findings)
        return self.presence.summary(self.begin) if late else diagnosis.summary()

    def _count_airtime(self, second: Array, airtime: Array) -> None:
        """Add airtime to the seconds in which it was spent; the last one may continue."""
        self.airtime += float(airtime.sum())
        if not len(second):
            self.airtime_now = 0.0
            return
        seconds, which = np.unique(second, return_inverse=True)
        spent = np.bincount(which, airtime)
        if self._last_second[0] == seconds[0]:
            spent[0] += self._last_second[1]
        self.airtime_peak = max(self.airtime_peak, float(spent.max()))
        now = spent[-2] if len(spent) > 1 else max(self._last_second[1], spent[0])
        self.airtime_now = float(now)
        self._last_second = int(seconds[-1]), float(spent[-1])

    def _update_findings(self, diagnosis: Diagnosis) -> None:
        """Keep findings of `CERTAIN_COUNT` diagnoses in a row, and those about presence."""
        self.diagnosis = diagnosis
        found = {(one.kind, one.hosts): one for one in (*self.host_findings, *diagnosis.findings)}
        new = {key: CERTAIN_COUNT if one in self.host_findings else 1 for key, one in found.items()}
        old = self._diagnosis_counts
        self._diagnosis_counts = {key: old.get(key, 0) + count for key, count in new.items()}
        elapsed = self.end - self.begin
        self.certain_findings = {
            key: (self.certain_findings.get(key, (elapsed, one))[0], one)
            for key, one in found.items()
            if self._diagnosis_counts[key] >= CERTAIN_COUNT
        }
