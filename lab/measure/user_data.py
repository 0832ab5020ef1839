r"""Measure bytes and frames of user data on the wire: one writer, one reader, a few samples.

    unshare --net --mount --pid --fork --mount-proc build/lab/venv/bin/python \
        lab/measure/user_data.py build/lab/bin/fast_dds_data [test] > rows.csv

This needs root, tcpdump and a venv with the middleware of `requirements.lock`; a row takes ten
seconds. Each run counts IP packets between the two hosts from the first to the last sample, without
discovery: multicast, and Fast DDS's discovery ports (Cyclone DDS uses the same ports for both).
TCP packets without payload get separate rows. Runs on a busy machine are discarded.
"""

import csv
import struct
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

from netns_run import (
    CAPTURE_TAIL,
    MIN_IDLE_SHARE,
    begin_capture,
    build_bridge,
    build_host,
    end_capture,
    idle_since,
    processor_times,
)

PROGRAM = Path(__file__).parents[1] / "programs" / "user_data_process.py"
FAST_DDS = Path(sys.argv[1]).resolve()
#: Sample sizes [B], rates [Hz] and numbers of samples: for the fit and for the test of the framing.
SIZES = {
    "fit": [(size, 10, 10) for size in (100, 1400, 6000, 100_000)],
    "test": [(300, 50, 100), (1100, 30, 60), (3_000, 20, 40), (20_000, 15, 30), (150_000, 4, 12)],
}
GRID_PART = sys.argv[2] if len(sys.argv) > 2 else "fit"
#: Columns: product, bytes of a sample, rate [Hz], samples, reliability.
POINTS = [
    (product, *size, how)
    for product in ("fast_dds", "cyclone_dds", "zenoh_peer")
    for size in SIZES[GRID_PART]
    for how in ("best-effort", "reliable")
]
COLUMNS = (
    *("product", "bytes", "hz", "samples", "reliability", "use"),
    *("direction", "packets", "ip_bytes"),
)
ETHERNET, UDP, TCP = 14, 17, 6


def read_ip_packets(path: Path) -> Iterator[tuple[float, bytes]]:
    """Yield time and IP packet of each record of an Ethernet capture."""
    content = path.read_bytes()
    place = 24
    while place < len(content):
        seconds, micro, kept, _ = struct.unpack_from("<IIII", content, place)
        frame = content[place + 16 : place + 16 + kept]
        place += 16 + kept
        if frame[12:14] == b"\x08\x00":
            total = struct.unpack_from(">H", frame, 16)[0]
            yield seconds + micro / 1e6, frame[ETHERNET : ETHERNET + total]


def count_by_direction(path: Path, begin: float, end: float, ports: bool) -> dict[str, list[int]]:
    """Return packets and bytes by direction; count TCP packets without payload separately."""
    found: dict[str, list[int]] = {}
    discovery: set[tuple[bytes, bytes]] = set()
    for moment, packet in read_ip_packets(path):
        header, protocol, target = 4 * (packet[0] & 15), packet[9], packet[16:20]
        flags = struct.unpack_from(">H", packet, 6)[0]
        if not begin <= moment <= end or target[0] >= 224 or target[3] == 255:
            continue
        first, key = not flags & 0x1FFF, (packet[12:16], packet[4:6])
        if protocol == UDP and first:
            port = struct.unpack_from(">H", packet, header + 2)[0]
            if ports and port % 2 == 0:  # discovery ports: 7410 + 2 n
                if flags & 0x2000:  # more fragments follow
                    discovery.add(key)
                continue
        if protocol == UDP and not first and key in discovery:
            continue
        name = "to reader" if target[3] == 2 else "to writer"
        if protocol == TCP:
            offset = 4 * (packet[header + 12] >> 4)
            if len(packet) == header + offset:
                name += ", TCP ACK"
        row = found.setdefault(name, [0, 0])
        row[0] += 1
        row[1] += len(packet)
    return found


def main() -> None:
    build_bridge()
    hosts = [build_host(number) for number in (1, 2)]
    rows = csv.writer(sys.stdout)
    rows.writerow(COLUMNS)
    for product, size, rate, samples, how in POINTS:
        with tempfile.TemporaryDirectory() as folder:
            out = Path(folder) / "run"
            dump = begin_capture(out, 32768)
            before = processor_times()
            running, times = [], []
            for host, role in zip(hosts, ("write", "read"), strict=True):
                program = [FAST_DDS] if product == "fast_dds" else [sys.executable, PROGRAM]
                command = [*program, product, role, size, rate, samples, how]
                inside = ["nsenter", f"--target={host}", "--net", "--mount"]
                running.append(
                    subprocess.Popen(
                        [*inside, *map(str, command)], stdout=subprocess.PIPE, text=True
                    )
                )
            for _ in range(2):
                line = running[0].stdout.readline()  # type: ignore[union-attr]
                times.append(float(line.split()[1]))
            begin, end = times
            if (idle := idle_since(before)) < MIN_IDLE_SHARE:
                raise SystemExit(f"{product}: the processor was idle for {idle:.0%}")
            time.sleep(CAPTURE_TAIL)
            for process in running:
                process.kill()
                process.wait()
            end_capture(out, dump)
            for name, (number, octets) in sorted(
                count_by_direction(
                    out.with_suffix(".pcap"), begin, end, product == "fast_dds"
                ).items()
            ):
                rows.writerow([product, size, rate, samples, how, GRID_PART, name, number, octets])
        sys.stdout.flush()


if __name__ == "__main__":
    main()
