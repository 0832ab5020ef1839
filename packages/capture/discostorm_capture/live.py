"""A capture while it is made: packets as they come, in a bounded amount of memory."""

from __future__ import annotations

import io
import struct
from collections import Counter, deque
from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from discostorm.wifi import PAPER, Wifi
from discostorm_capture._bytes import Array
from discostorm_capture.diagnosis import Diagnosis, Finding
from discostorm_capture.pcap import MOST, PCAP, CaptureError
from discostorm_capture.read import read_capture

#: So many bytes of packets are kept, the newest ones, and diagnosed.
KEPT = 8 << 20
#: So many hosts are kept, those that were heard last.
MOST_HOSTS = 1024
#: A finding is certain when so many diagnoses in a row make it, or the only one there is.
CERTAIN = 2


class Packets:
    """The packets of a stream in pcap's format, which are taken from its bytes as they come."""

    def __init__(self, name: str) -> None:
        self.name, self.head = name, b""
        self._rest = b""
        self._order, self._header, self._tick = "<", 16, 1000

    def of(self, data: bytes) -> Iterator[tuple[float, bytes]]:
        """Yield the time of each packet that is whole now [s], and its bytes with their header.

        Raises
        ------
        CaptureError
            If it is no stream of pcap, or broken.
        """
        self._rest += data
        if not self.head:
            if len(self._rest) < 24:
                return
            magic = self._rest[:4]
            if magic not in PCAP:
                raise CaptureError(
                    f"{self.name}: no pcap: it starts with {magic.hex(' ')}; pipe what `tcpdump -U "
                    "-w -` or `dumpcap -P -w -` write"
                )
            self._order, self._tick, self._header = PCAP[magic]
            self.head, self._rest = self._rest[:24], self._rest[24:]
        at = 0
        while at + self._header <= len(self._rest):
            second, part, size = struct.unpack_from(self._order + "III", self._rest, at)
            if size > MOST:
                raise CaptureError(
                    f"{self.name}: a packet of {size} bytes; there are at most {MOST}"
                )
            end = at + self._header + size
            if end > len(self._rest):
                break
            yield second + part * self._tick * 1e-9, self._rest[at:end]
            at = end
        self._rest = self._rest[at:]

    @property
    def cut(self) -> str:
        """What is wrong if the stream ends now; empty if nothing."""
        if not self.head:
            return f"{self.name}: it ended before a packet came; is the program before it running?"
        return f"{self.name}: it ended inside of a packet" if self._rest else ""


@dataclass(frozen=True)
class Host:
    """A host as it was seen.

    Parameters
    ----------
    first, last : float
        When it was heard first and last [s since 1970].
    products : str
        What runs on it.
    sent, payload : int
        How many messages it sent [1], and their payload [B].
    """

    first: float
    last: float
    products: str = ""
    sent: int = 0
    payload: int = 0


class Watch:
    """What is known of a capture so far.

    Parameters
    ----------
    wifi : Wifi
        The channel that airtime is told for.
    kept : int
        How many bytes of packets are kept [B].
    """

    def __init__(self, wifi: Wifi = PAPER, kept: int = KEPT) -> None:
        self.wifi, self.kept = wifi, kept
        #: The newest packets and their bytes; how many of them are new since `fold`, and theirs.
        self.ring: deque[tuple[float, bytes]] = deque()
        self.size = self.new = self.new_size = 0
        #: Sums since the begin: packets; messages and their payload by kind; airtime [s].
        self.packets = 0
        self.messages: Counter[str] = Counter()
        self.payload: Counter[str] = Counter()
        self.airtime = 0.0
        #: Of the last fold, messages a second by kind; airtime of a second, now and at peak.
        self.rates: dict[str, float] = {}
        self.now = self.peak = 0.0
        self.hosts: dict[str, Host] = {}
        self.diagnosis: Diagnosis | None = None
        #: Findings that are certain, with when they became so [s since the begin].
        self.certain: dict[tuple[str, tuple[str, ...]], tuple[float, Finding]] = {}
        #: When the first and the newest packet came [s since 1970].
        self.begin = self.end = 0.0
        self._second = (-1, 0.0)
        self._seen: Counter[tuple[str, tuple[str, ...]]] = Counter()

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

    def fold(self, head: bytes) -> None:
        """Count what is new, and diagnose what is kept."""
        if not self.new:
            self.rates, self.now = {}, 0.0
            return
        content = io.BytesIO(b"".join([head, *(packet for _, packet in self.ring)]))
        capture = read_capture(content)
        rows = capture.messages()
        rows = rows.assign(airtime=capture.airtime(self.wifi).to_numpy())
        old = len(self.ring) - self.new
        mine = rows[(rows["frame"] > old).to_numpy() & ~rows["copy"].to_numpy(bool)]
        newest = max(time for time, _ in list(self.ring)[old:])
        seconds = max(newest - self.end, 1e-3) if old else max(newest - self.begin, 1.0)
        seconds = max(seconds, 1.0)
        kinds = mine.groupby("kind", observed=True)["bytes"].agg(["size", "sum"])
        for kind, count, size in kinds.itertuples():
            self.messages[str(kind)] += int(count)
            self.payload[str(kind)] += int(size)
        self.rates = {str(kind): int(count) / seconds for kind, count in kinds["size"].items()}
        self._count_airtime(
            (capture.start + mine["time"].to_numpy(np.float64)).astype(np.int64),
            mine["airtime"].to_numpy(np.float64),
        )
        self.end = max(self.end, newest)
        for host, some in mine.groupby("sender", observed=True):
            times = capture.start + some["time"].to_numpy(np.float64)
            known = self.hosts.pop(str(host), Host(float(times.min()), 0.0))
            self.hosts[str(host)] = replace(
                known,
                last=float(times.max()),
                sent=known.sent + len(some),
                payload=known.payload + int(some["bytes"].sum()),
            )
        while len(self.hosts) > MOST_HOSTS:
            del self.hosts[next(iter(self.hosts))]
        table = capture.processes()
        for host, products in table.groupby("host")["product"].unique().items():
            if str(host) in self.hosts:
                named = ", ".join(products)
                self.hosts[str(host)] = replace(self.hosts[str(host)], products=named)
        self.new = self.new_size = 0
        self._diagnose(capture.diagnosis())

    def _count_airtime(self, second: Array, airtime: Array) -> None:
        """Add airtime to the seconds in which it was; the last one may go on."""
        self.airtime += float(airtime.sum())
        if not len(second):
            self.now = 0.0
            return
        places, which = np.unique(second, return_inverse=True)
        spent = np.bincount(which, airtime)
        if self._second[0] == int(places[0]):
            spent[0] += self._second[1]
        self.peak = max(self.peak, float(spent.max()))
        whole = self._second[1] if len(spent) < 2 else float(spent[-2])
        self.now = max(whole, float(spent[-1])) if len(spent) < 2 else whole
        self._second = int(places[-1]), float(spent[-1])

    def _diagnose(self, diagnosis: Diagnosis) -> None:
        self.diagnosis = diagnosis
        found = {(one.kind, one.hosts): one for one in diagnosis.findings}
        self._seen = Counter({key: self._seen[key] + 1 for key in found})
        for key, one in found.items():
            if self._seen[key] >= CERTAIN:
                since = self.certain.get(key, (self.end - self.begin, one))[0]
                self.certain[key] = (since, one)
        for key in [key for key in self.certain if key not in found]:
            del self.certain[key]
