"""Plugins of ROS 2's tools: a check and report of ``ros2 doctor``, and ``ros2 discostorm``.

They were never run in ROS 2. The classes follow ros2cli 0.36.1 (ros2doctor/api/__init__.py and
ros2cli/command/__init__.py), of which the tests have stubs.
"""

import argparse
import io
import os
import time
from collections import Counter
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

from discostorm import wording
from discostorm.cli.main import main
from discostorm.cli.output import BadInput
from discostorm_capture.capture import Capture
from discostorm_capture.cli.watch import open_pcap, read_chunks
from discostorm_capture.live_capture import PacketStream
from discostorm_capture.pcap import CaptureError
from discostorm_capture.read import read_capture
from discostorm_capture.rtps import DOMAIN_GAIN, PORT_BASE
from discostorm_capture.sentences import say

#: How long the network is recorded [s].
RECORDING_TIME = 10.0
#: How many ports Fast DDS tries for a process on a host (mutation_tries).
MUTATION_TRIES = 100
#: The first port of a process, relative to the first one of its domain (DDSI-RTPS 2.5, 9.6.1.1),
#: and the first ephemeral port of Linux.
FIRST_PROCESS_PORT, FIRST_EPHEMERAL_PORT = 10, 32768
PROC = Path("/proc")


@cache
def run_checks() -> dict[str, list[str]]:
    """Return the problems found by each check. The network is recorded only once."""
    found = {"UDP buffers": [*_udp_drops()], "processes on this host": [*_crowded_domains()]}
    try:
        capture = record_all_interfaces()
    except (BadInput, CaptureError) as error:
        return found | {"traffic": [f"not checked: {error}"]}
    wrong = [f"{one.summary}: {one.evidence}. {one.advice}" for one in capture.diagnosis().wrong]
    return found | {"settings of this shell": [*_mismatched_settings(capture)], "traffic": wrong}


def record_all_interfaces() -> Capture:
    """Capture on all interfaces for `RECORDING_TIME`."""
    packets, kept = PacketStream("any interface"), list[bytes]()
    with open_pcap("any") as source:
        end = time.monotonic() + RECORDING_TIME
        for data in read_chunks(source):
            kept += [packet for _, packet in packets.feed(data)]
            if time.monotonic() > end:
                break
    return read_capture(io.BytesIO(packets.header + b"".join(kept)))


def _mismatched_settings(capture: Capture) -> Iterator[str]:
    """Yield the settings of this shell that keep it from discovering the captured processes."""
    shown = capture.processes()
    hosts, spoken, domains = ({*map(str, shown[of])} for of in ("host", "protocol", "domain"))
    defaults = {"ROS_DOMAIN_ID": "0", "RMW_IMPLEMENTATION": "rmw_fastrtps_cpp"}
    settings = defaults | {name: value for name, value in os.environ.items() if value}
    peers = list(filter(None, settings.get("ROS_STATIC_PEERS", "").split(";")))
    local = ["OFF"] if peers else ["OFF", "LOCALHOST"]
    for name, values in (("ROS_AUTOMATIC_DISCOVERY_RANGE", local), ("ROS_LOCALHOST_ONLY", ["1"])):
        if (value := settings.get(name)) in values and hosts:
            yield f"{name} is {value}, but {wording.count_noun(len(hosts), 'host')} can be heard"
    if silent := [peer for peer in peers if peer not in hosts]:
        yield f"ROS_STATIC_PEERS lists {wording.join_words(silent)}, but no process speaks there"
    middleware, domain = settings["RMW_IMPLEMENTATION"], settings["ROS_DOMAIN_ID"]
    if spoken and ("Zenoh" if "zenoh" in middleware else "RTPS") not in spoken:
        others = wording.join_words(sorted(spoken)).replace("RTPS", "DDS")
        yield f"RMW_IMPLEMENTATION is {middleware} here, but other hosts speak only {others}"
    if (known := sorted(domains - {"-1"})) and domain not in known:
        yield f"ROS_DOMAIN_ID is {domain} here, but other hosts use {wording.join_words(known)}"


def _udp_sockets() -> Iterator[tuple[int, int]]:
    """Yield the port of each UDP socket, and how many datagrams it dropped."""
    for table in (PROC / "net").glob("udp*"):
        for row in map(str.split, table.read_text().splitlines()[1:]):
            yield int(row[1].rpartition(":")[2], 16), int(row[-1])


def _udp_drops() -> Iterator[str]:
    """Yield how many datagrams sockets dropped, and the sizes of buffers, if any did."""
    if drops := sum(count for _, count in _udp_sockets()):
        files = sorted((PROC / "sys/net/core").glob("rmem_*"))
        sizes = [f"net.core.{file.name} is {file.read_text().strip()} B" for file in files]
        text = f"sockets dropped {wording.count_noun(drops, 'datagram')}, mostly for lack of room"
        yield "; ".join([text, *sizes, "raise these limits"])


def _crowded_domains() -> Iterator[str]:
    """Yield domains with more processes on this host than Fast DDS tries ports."""
    ports = {port for port, _ in _udp_sockets() if PORT_BASE <= port < FIRST_EPHEMERAL_PORT}
    places = [divmod(port - PORT_BASE, DOMAIN_GAIN) for port in ports if port % 2 == 0]
    for domain, count in Counter(of for of, at in places if at >= FIRST_PROCESS_PORT).items():
        if count > MUTATION_TRIES:
            yield say("crowded domain", count, domain, MUTATION_TRIES)


class Discovery:
    """Check and report of ``ros2 doctor``: settings, buffers, processes, and 10 s of traffic."""

    def category(self) -> str:
        """Return the name that check and report share."""
        return "discovery"

    def check(self) -> Any:
        """Return a result with one warning for each problem."""
        from ros2doctor.api import Result
        from ros2doctor.api.format import doctor_warn

        result = Result()
        for name, texts in run_checks().items():
            for text in texts:
                doctor_warn(f"{name}: {text}")
                result.add_warning()
        return result

    def report(self) -> Any:
        """Return a report of all checks and the problems found."""
        from ros2doctor.api import Report

        report = Report("DISCOVERY")
        for name, texts in run_checks().items():
            report.add_to_report(name, "; ".join(texts) or "nothing is wrong")
        return report


class DiscostormCommand:
    """Diagnose discovery, and compute its airtime."""

    NAME, EXTENSION_POINT_VERSION = None, "0.1"

    def add_arguments(self, parser: Any, cli_name: str, *, argv: Any = None) -> None:  # noqa: ARG002
        """Accept the arguments of `discostorm`."""
        parser.add_argument("words", nargs=argparse.REMAINDER, help="as discostorm takes them")

    def main(self, *, parser: Any, args: Any) -> None:  # noqa: ARG002
        """Run `discostorm` with the given arguments."""
        main(args.words or ["--help"], prog_name="ros2 discostorm")
