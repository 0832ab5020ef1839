"""Tables as built beside what the lab counted, message by message, and where they are off."""

from collections.abc import Hashable, Iterable
from functools import cache
from typing import Any, cast as typed

import numpy as np
import pandas as pd
import sympy as sp

from discostorm.data import read_data
from discostorm.fleet import Fleet
from discostorm.measured import configurations, products
from discostorm.messages import HOPS, Message, Protocol, Schedule, Transport, header_bytes
from discostorm.protocols import PROTOCOLS
from discostorm.wifi import PAPER, Cast, Wifi, downlink_airtime, uplink_airtime
from discostorm_book.lab_counts import WINDOWS, Point, points


def times(schedule: Schedule, window: str) -> float:
    """Return how many times of a schedule are in a window."""
    begin, end = (float(np.asarray(schedule.sent(time))) for time in WINDOWS[window])
    return end - begin * (window != "startup")


def expected(message: Message, fleet: Fleet, window: str) -> float:
    """Return how many of a message a fleet sends in a window [1]."""
    return float(message.load(fleet)) * times(message.schedule, window)


def transport_of(kind: str, zenoh: bool) -> Transport:
    """Return what carries a kind of message that was counted."""
    return "TCP" if zenoh and kind not in ("Scout", "Hello", "Join") else "UDP"


@cache
def _charged(transport: Transport, cast: Cast, hop: str, wifi: Wifi) -> tuple[float, float]:
    """Return what a frame takes with its headers, and each byte of payload [s]."""
    length, headers = sp.Symbol("S"), header_bytes()[transport]
    on = {
        "up": uplink_airtime(length, wifi.model),
        "down": downlink_airtime(length, cast, wifi.model),
        "none": sp.Integer(0),
    }
    both = on["up"] + on["down"] if not hop else on[hop]
    empty, one = (float(both.subs(wifi.values() | {length: headers + n})) for n in (0, 1))
    return empty, one - empty


def airtime_counted(point: Point, window: str, zenoh: bool, wifi: Wifi = PAPER) -> Any:
    """Return the airtime of all that was counted in a window, a number a run [s].

    Where airtime grows with the length of frames by as much each byte, as on the paper's channel,
    the sums of frames and bytes are all it takes.
    """
    taken = np.zeros(len(point.ready))
    for (when, kind, about, cast, hop), runs in point.runs.items():
        if when == window and not about:
            frame, byte = _charged(transport_of(kind, zenoh), typed(Cast, cast), hop, wifi)
            taken += frame * runs[:, 1] + byte * runs[:, 2]
    return taken


def airtime_expected(protocol: Protocol, fleet: Fleet, window: str, wifi: Wifi = PAPER) -> float:
    """Return the airtime of what a table says of a window, as `airtime_counted` takes it [s]."""
    taken = 0.0
    for message in protocol.messages:
        frame, byte = _charged(message.transport, message.cast, _only_hop(message), wifi)
        count = expected(message, fleet, window)
        taken += count * (frame * message.frames + byte * message.payload.nominal)
    return taken


def held(protocol: Protocol, shared: bool = False) -> pd.DataFrame:
    """Hold a table as built against the medians of all points of the grid.

    Parameters
    ----------
    protocol : Protocol
        Of a name in ``data/vendors/products.csv`` or ``configurations.csv``.
    shared : bool, optional
        Against those with one shared topic beside unique ones; see `points`.

    Returns
    -------
    pandas.DataFrame
        A row for each ``point``, ``use``, ``window``, ``phase`` and ``kind``, and one for each
        phase, of which kind is "all"; of what takes one hop alone rows of their own, of which
        kind is "SPDP, up" or "all, down": what was ``measured``, the median of the runs, ``least``
        and ``most``, what the table has ``expected`` [1], the same of bytes with ``_bytes`` behind
        the name [B], and the ``error`` of messages and the ``error_bytes`` [1], of the median.

    Raises
    ------
    ValueError
        If nothing was measured for such a table.
    """
    rows = []
    for point in points(protocol.name, shared):
        for window in WINDOWS:
            for phase in protocol.phases:
                mine = protocol.of_phase(phase)
                kinds = list(dict.fromkeys((m.kind, _only_hop(m)) for m in mine))
                parts = [(f"{kind}, {hop}" if hop else kind, [(kind, hop)]) for kind, hop in kinds]
                only = {hop: [one for one in kinds if one[1] == hop] for hop in HOPS}
                parts.extend((f"all, {hop}", some) for hop, some in only.items() if some)
                for name, members in [*parts, ("all", kinds)]:
                    row = _row(mine, point, window, members)
                    if row["measured"] or row["expected"]:
                        head = {"point": point.name, "use": point.use, "window": window}
                        rows.append(head | {"phase": phase, "kind": name} | row)
    table = pd.DataFrame(rows)
    for end in ("", "_bytes"):
        some = table[f"measured{end}"].where(table[f"measured{end}"] > 0)
        table[f"error{end}"] = table[f"expected{end}"] / some - 1
    return table


def _only_hop(message: Message) -> str:
    """Return the hop that a message takes, "" if it takes both."""
    return message.hops[0] if len(message.hops) == 1 else ""


def _row(
    messages: Iterable[Message], point: Point, window: str, kinds: list[tuple[str, str]]
) -> dict[str, float]:
    """Return what was counted of some kinds with their hops, and what is expected of them."""
    keys = [
        (window, kind, "", cast, hop) for kind, hop in kinds for cast in ("multicast", "unicast")
    ]
    seen = [point.runs[key] for key in keys if key in point.runs]
    runs = np.sum(seen, axis=0) if seen else np.zeros((1, 3))
    count = size = 0.0
    for message in messages:
        if (message.kind, _only_hop(message)) in kinds:
            number = expected(message, point.fleet, window)
            count += number * (message.frames > 0)  # a part of another message is none itself
            size += number * message.payload.nominal
    return {
        "measured": float(np.median(runs[:, 0])),
        "least": float(runs[:, 0].min()),
        "most": float(runs[:, 0].max()),
        "expected": count,
        "measured_bytes": float(np.median(runs[:, 2])),
        "least_bytes": float(runs[:, 2].min()),
        "most_bytes": float(runs[:, 2].max()),
        "expected_bytes": size,
    }


#: How far a table may be from the median of the runs [1]: of a phase, and of a kind of message. Of
#: what is arranged otherwise than as shipped, with fewer runs a point: of a phase alone.
WITHIN_PHASE, WITHIN_KIND = 0.05, 0.10
WITHIN_MITIGATED = 0.10


def misses(protocol: Protocol, use: str = "test") -> list[dict[str, str]]:
    """Return where a table as built is off by more than it should be, on one half of the grid.

    Returns
    -------
    list of dict
        ``protocol``, ``point``, ``window``, ``phase``, ``kind`` ("all" of a phase), ``quantity``
        (messages or bytes), ``error`` [1], and ``reason``, one of ``data/measured/reasons.csv``.
    """
    table = held(protocol)
    arranged = protocol.name in configurations()
    found = []
    for row in table[table["use"] == use].to_dict("records"):
        for quantity, end in (("messages", ""), ("bytes", "_bytes")):
            measured, count = row[f"measured{end}"], row[f"expected{end}"]
            of_phase = row["kind"].startswith("all")
            if arranged and not of_phase:
                continue
            limit = WITHIN_MITIGATED if arranged else WITHIN_PHASE if of_phase else WITHIN_KIND
            if abs(count - measured) > limit * measured:
                error = f"{count / measured - 1:+.3f}" if measured else "none"
                head = {name: row[name] for name in ("point", "window", "phase", "kind")}
                reason = _reason(protocol.name, row, count, row[f"least{end}"], row[f"most{end}"])
                tail = {"quantity": quantity, "error": error, "reason": reason}
                found.append({"protocol": protocol.name} | head | tail)
    return found


def _reason(
    protocol: str, row: dict[Hashable, Any], count: float, least: float, most: float
) -> str:
    """Return why a table may be off: what the runs of a point, its size and the source say."""
    hosts, processes, _ = row["point"].split("x")
    everyone = int(hosts) * int(processes)
    if least <= count <= most:
        return "scatter"
    cause = _cause(protocol, row["phase"])
    if cause is not None and (everyone > 2 or cause["of_one_pair"] == "yes"):
        return cause["reason"]
    if everyone == 2:
        return "one pair"
    return "crowd" if everyone >= 6 else "form"


def _cause(protocol: str, phase: str) -> dict[str, str] | None:
    """Return what decides a phase of a product, where its source says so."""
    run = (products() | configurations())[protocol]
    for row in read_data("measured/causes.csv", "discostorm_book"):
        of_run = row["product"] == run["product"] and row["variant"] in ("", run["variant"])
        if of_run and row["phase"] == phase:
            return row
    return None


def held_hybrid(alike: bool = False) -> pd.DataFrame:
    """Hold a table of the hybrid discovery against what its speakers sent in the lab.

    Parameters
    ----------
    alike : bool, optional
        Whether all hosts ran the same software.

    Returns
    -------
    pandas.DataFrame
        A row for each ``hosts``, ``processes``, ``endpoints``, ``window`` and ``phase`` of the runs
        without losses: ``runs``, the median number of ``frames`` and of ``bytes`` [B], what the
        table has ``expected`` and ``expected_bytes``, and the relative ``error`` and
        ``error_bytes`` of the table [1].
    """
    protocol = PROTOCOLS["hybrid, alike" if alike else "hybrid"]
    software = "alike" if alike else "unlike"
    runs = pd.DataFrame(read_data("measured/hybrid.csv", "discostorm_book"))
    runs = runs[(runs["scenario"] == "no losses") & (runs["software"] == software)]
    counted = ["hosts", "processes", "endpoints", "frames", "bytes"]
    runs = runs.astype(dict.fromkeys(counted, float))
    kinds = {"Sets": "Announce", "Digests": "Digest", "Heartbeats": "Heartbeat"}
    rows = []
    for key, point in runs.groupby(["hosts", "processes", "endpoints", "window"], sort=True):
        fleet, window = Fleet.swarm(*key[:3]), str(key[3])
        for phase, kind in kinds.items():
            seen = point[point["kind"] == kind]
            messages = protocol.of_phase(phase)
            sent = [expected(message, fleet, window) for message in messages]
            row = {
                **dict(zip(("hosts", "processes", "endpoints", "window"), key, strict=True)),
                "phase": phase,
                "runs": len(seen),
                "frames": seen["frames"].median(),
                "expected": sum(n for n, m in zip(sent, messages, strict=True) if m.frames),
                "bytes": seen["bytes"].median(),
                "expected_bytes": sum(
                    n * m.payload.nominal for n, m in zip(sent, messages, strict=True)
                ),
            }
            if row["frames"] or row["expected"]:
                rows.append(row)
    table = pd.DataFrame(rows)
    for measured, said, error in (
        ("frames", "expected", "error"),
        ("bytes", "expected_bytes", "error_bytes"),
    ):
        table[error] = table[said] / table[measured].where(table[measured] > 0) - 1
    return table
