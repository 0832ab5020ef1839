"""Count the messages in the lab's captures, and write two tables: runs and counts.

The counts are per run, window and message kind. For configurations with servers or routers, the
table also names the hops that a message would take if the hosts were on the Wi-Fi and the servers
were wired to the access point.
"""

import argparse
import hashlib
import json
import re
import sys
from collections import Counter
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np
from lab_data import write_table
from run_grid import SECURITY

import discostorm as ds
from discostorm_capture import ip, link_layer, pcap
from discostorm_capture._arrays import IdTable
from discostorm_capture._types import Notes

#: Counted windows, from the common start of all processes [s]. Servers start earlier.
WINDOWS = {"startup": (-np.inf, 12.0), "steady": (12.0, 36.0)}
RUN_COLUMNS = (
    *("run", "product", "variant", "version", "hosts", "processes", "endpoints", "names", "use"),
    *(
        "number",
        "seconds",
        "start_skew_s",
        "endpoints_created_s",
        "command",
        "environment",
        "kernel",
        "sha256",
    ),
    "idle",
)
#: With DDS Security: ordered pairs of processes on different hosts without an exchange of keys.
UNAUTHENTICATED_PAIRS = "strangers"
COUNT_COLUMNS = ("run", "window", "kind", "about", "multicast", "messages", "frames", "bytes")
#: Columns for grids of configurations, whose tables are merged; a run is named by its capture.
HOP_COLUMNS = (*COUNT_COLUMNS[:5], "hops", *COUNT_COLUMNS[5:])
TIME_DIGITS = 10
ICMP = 1
#: A host whose first packet is later than this after the start [s] had no network at the start.
MAX_FIRST_PACKET_TIME = 1.5


def natural_sort_key(path: Path) -> list[int | str]:
    """Return a key that sorts h2p1e10 behind h2p1e4."""
    return [int(part) if part.isdigit() else part for part in re.split(r"(\d+)", path.name)]


def run_row(run: int | str, capture: Path, stored: dict[str, Any]) -> dict[str, Any]:
    """Return the row of a run, without folders of this machine."""
    seconds = f"{stored['seconds']:g}"
    after = [one["after"] for one in stored.get("programs", [])] or [0.0] * len(stored["times"])
    late, made = (
        max(one[what] - begun for one, begun in zip(stored["times"], after, strict=True))
        for what in ("begin", "endpoints")
    )
    # Profiles are in a folder of the lab.
    places = re.compile(r"/\S*?(?=build/lab/)")
    shape = (seconds, "HOST", "PROCESS", stored["endpoints"], stored["names"], stored["variant"])
    return {
        "run": run,
        **{name: stored[name] for name in ("product", "variant", "version", "hosts", "processes")},
        **{name: stored[name] for name in ("endpoints", "names", "use")},
        "seconds": seconds,
        "kernel": stored["kernel"].partition("-")[0],
        "number": stored["run"],
        "start_skew_s": f"{late - stored['start']:.4f}",
        "endpoints_created_s": f"{made - stored['start']:.4f}",
        "command": " ".join(str(word) for word in (Path(stored["command"][-1]).name, *shape)),
        "environment": " ".join(
            f"{key}={places.sub('', value)}" for key, value in stored["env"].items()
        ),
        "idle": stored.get("idle", ""),
        "sha256": hashlib.sha256(capture.read_bytes()).hexdigest(),
    }


def icmp_port_unreachable(capture: Path) -> tuple[Any, Any]:
    """Return the times of ICMP "port unreachable" packets, and their bytes without the header.

    An ICMP header has 8 bytes, as a UDP header has.
    """
    packets, notes, addresses = pcap.read_packets(capture), Notes(), IdTable()
    found = link_layer.ip_and_arp_packets(packets, notes)
    found = {name: column[found["ethertype"] != link_layer.ARP] for name, column in found.items()}
    found = ip.parse_ip(packets.data, found, addresses, notes)
    which = found["protocol"] == ICMP
    time = packets.table["time"][found["frame"][which]] * 1e-9
    return time, found["wire"][which] - 8


def count_rows(
    run: int | str, capture: Path, stored: dict[str, Any], notes: Counter[str]
) -> Iterable[dict[str, Any]]:
    """Yield a row for each window and message kind; leave out windows that are not over."""
    found = ds.read_capture(capture)
    notes.update(found.notes)
    messages = found.messages()
    # Subject of the built-in RTPS entities: publications or subscriptions. For Zenoh: the exact
    # message of a kind, InitSyn or InitAck.
    rtps = messages["protocol"] == "RTPS"
    messages["about"] = messages["entity"].astype(str).where(rtps, messages["submessage"])
    behind = {f"10.77.0.{host}" for host, _ in stored.get("servers", []) if host > stored["hosts"]}
    sent, got = (messages[end].isin(behind) for end in ("sender", "receiver"))
    messages["hops"] = np.select([sent & got, sent, got], ["none", "down", "up"], "")
    time = messages["time"] + (found.start - stored["start"])
    closed, octets = icmp_port_unreachable(capture)
    first = time[time >= 0].groupby(messages["sender"]).min().max()
    if first > MAX_FIRST_PACKET_TIME and not stored.get("programs"):
        raise SystemExit(f"{capture}: a host is heard {first:.1f} s late: remove it, run it again")
    for window, (begin, end) in (WINDOWS | stored.get("windows", {})).items():
        if stored["seconds"] < end:
            continue
        inside = messages[(time >= begin) & (time < end)]
        for key, group in inside.groupby(["kind", "about", "multicast", "hops"], observed=True):
            yield {
                **dict(zip(HOP_COLUMNS, (run, window, *key), strict=False)),
                "multicast": int(key[2]),
                "messages": len(group),
                "frames": f"{group['frames'].sum():.2f}".rstrip("0").rstrip("."),
                "bytes": int(group["bytes"].sum()),
            }
        refused = (closed - stored["start"] >= begin) & (closed - stored["start"] < end)
        if many := int(np.count_nonzero(refused)):
            key = (run, window, "ICMP unreachable", "ports", 0, "", many, many)
            yield dict(zip(HOP_COLUMNS, (*key, int(octets[refused].sum())), strict=True))


def main() -> int:
    """Count all captures of a folder."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("captures", type=Path, help="folder that run_grid.py filled")
    parser.add_argument("--out", type=Path, required=True, help="folder for the tables")
    parser.add_argument("--kind", help="what the names of the tables begin with")
    given = parser.parse_args()
    captures = sorted(given.captures.glob("*.pcap.gz"), key=natural_sort_key)
    if not captures:
        parser.error(f"captures {given.captures}: no *.pcap.gz in it")
    first = (given.captures / f"{captures[0].name[:-8]}.json").read_text()
    arranged = bool(json.loads(first).get("mitigated"))
    runs, counts = [], []
    notes: Counter[str] = Counter()
    for number, capture in enumerate(captures, 1):
        run = hashlib.sha256(capture.read_bytes()).hexdigest()[:TIME_DIGITS] if arranged else number
        stored = json.loads((capture.parent / f"{capture.name[:-8]}.json").read_text())
        runs.append(run_row(run, capture, stored))
        if stored["variant"] in SECURITY:
            runs[-1][UNAUTHENTICATED_PAIRS] = len(ds.read_capture(capture).diagnosis().incomplete())
        rows = list(count_rows(run, capture, stored, notes))
        if not rows:
            print(f"{capture}: there is no message in it", file=sys.stderr)
            return 1
        counts += rows
        if sys.stderr.isatty() or number == len(captures):
            print(f"\r[{number}/{len(captures)}] {capture.name}\x1b[K", end="", file=sys.stderr)
    print(file=sys.stderr)
    for note, many in notes.most_common():
        print(f"  in {many}: {note}", file=sys.stderr)
    kind = "mitigation_" if arranged else ""
    kind = "shared_" if stored["names"] == "shared" else kind
    secured = (UNAUTHENTICATED_PAIRS,) * any(UNAUTHENTICATED_PAIRS in row for row in runs)
    kind = "security_" if secured else kind
    kind = kind if given.kind is None else given.kind
    write_table(given.out / f"{kind}runs.csv", runs, (*RUN_COLUMNS, *secured))
    write_table(given.out / f"{kind}counts.csv", counts, HOP_COLUMNS if arranged else COUNT_COLUMNS)
    return 0


if __name__ == "__main__":
    sys.exit(main())
