"""Measure the memory that `discostorm watch` takes over an hour of a storm that was made up.

Packets of a capture of the book come again and again, each time from other hosts, that many a
second of the capture's clock, as fast as they can be read. Prints a line of CSV for each tenth of
the time: seconds of the capture's clock, packets, hosts known, memory [MB].
"""

import argparse
import lzma
import resource
import struct
from collections.abc import Iterator
from pathlib import Path

from discostorm.data import data_path
from discostorm_capture.live import Packets, Watch

#: Where the addresses of an IPv4 packet in an Ethernet frame begin; the frame follows 16 bytes.
_SOURCE, _TARGET = 16 + 26, 16 + 30


def storm_packets(seconds: int, rate: int) -> Iterator[tuple[float, bytes]]:
    """Yield packets of a storm in which ever more hosts send, at a given rate."""
    whole = lzma.decompress(
        data_path("captures/fast_dds.pcap.xz", "discostorm_capture").read_bytes()
    )
    found = [packet for _, packet in Packets("storm").of(whole)]
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
    """Watch a storm, and print memory."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=int, default=3600)
    parser.add_argument("--rate", type=int, default=500, help="packets a second")
    parser.add_argument("--every", type=int, default=5, help="seconds between two diagnoses")
    given = parser.parse_args()
    head = lzma.decompress(
        data_path("captures/fast_dds.pcap.xz", "discostorm_capture").read_bytes()
    )[:24]
    told, shown, folded = Watch(), 0, 0.0
    print("seconds,packets,hosts,megabytes")
    for when, packet in storm_packets(given.seconds, given.rate):
        told.add(when, packet)
        if told.full or when - folded >= given.every:
            told.fold(head)
            folded = when
        if when >= shown * given.seconds / 10 + given.every:
            print(f"{when:.0f},{told.packets},{len(told.hosts)},{memory_used():.0f}", flush=True)
            shown += 1
    told.fold(head)
    print(f"{given.seconds},{told.packets},{len(told.hosts)},{memory_used():.0f}")


if __name__ == "__main__":
    main()
