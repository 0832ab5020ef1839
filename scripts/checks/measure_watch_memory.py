"""Measure the memory of `discostorm watch` over an hour of an artificial storm.

The storm repeats the packets of one of the book's captures, each time from new hosts, at a fixed
rate of the capture's clock and as fast as `watch` reads. Output: a line of CSV per tenth of the
time. Columns: seconds of the capture's clock, packets, discovered hosts, memory [MB].
"""

import argparse
import lzma
import resource
import struct
from collections.abc import Iterator
from pathlib import Path

from discostorm.data import data_path
from discostorm_capture.live_capture import PacketStream, Watch

#: Offset of the addresses in an Ethernet frame with IPv4; 16 bytes of packet header come before.
_SOURCE, _TARGET = 16 + 26, 16 + 30


def storm_packets(seconds: int, rate: int) -> Iterator[tuple[float, bytes]]:
    """Yield packets of a storm at a given rate; the number of sending hosts grows."""
    whole = lzma.decompress(
        data_path("captures/fast_dds.pcap.xz", "discostorm_capture").read_bytes()
    )
    found = [packet for _, packet in PacketStream("storm").feed(whole)]
    for number in range(seconds * rate):
        turn, place = divmod(number, len(found))
        packet = bytearray(found[place])
        when = number / rate
        packet[:8] = struct.pack("<II", int(when), int(when % 1 * 1e6))
        for at in (_SOURCE, _TARGET):
            if packet[at] == 10:
                packet[at + 1 : at + 3] = (turn % 65536).to_bytes(2, "big")
        yield when, bytes(packet)


def memory_used() -> float:
    """Return the memory of this process [MB]."""
    status = Path("/proc/self/status")
    if not status.exists():
        return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1000
    (line,) = [line for line in status.read_text().splitlines() if line.startswith("VmRSS")]
    return int(line.split()[1]) / 1000


def main() -> None:
    """Watch the storm, and print the memory."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=int, default=3600)
    parser.add_argument("--rate", type=int, default=500, help="packets a second")
    parser.add_argument("--every", type=int, default=5, help="seconds between two diagnoses")
    given = parser.parse_args()
    head = lzma.decompress(
        data_path("captures/fast_dds.pcap.xz", "discostorm_capture").read_bytes()
    )[:24]
    watch, shown, folded = Watch(), 0, 0.0
    print("seconds,packets,hosts,megabytes")
    for when, packet in storm_packets(given.seconds, given.rate):
        watch.add_packet(when, packet)
        if watch.must_count_now or when - folded >= given.every:
            watch.count_and_diagnose(head)
            folded = when
        if when >= shown * given.seconds / 10 + given.every:
            print(
                f"{when:.0f},{watch.packets},{len(watch.presence.hosts)},{memory_used():.0f}",
                flush=True,
            )
            shown += 1
    watch.count_and_diagnose(head)
    print(f"{given.seconds},{watch.packets},{len(watch.presence.hosts)},{memory_used():.0f}")


if __name__ == "__main__":
    main()
