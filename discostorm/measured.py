"""What the lab counted of real middleware, beside what the tables as built expect."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Hashable, Iterable
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from discostorm import _checks
from discostorm.data import read_data
from discostorm.fleet import Fleet, HostGroup
from discostorm.messages import HOPS, Message, Protocol, Schedule
from discostorm.protocols import DDS, PROTOCOLS, ZENOH

if TYPE_CHECKING:
    import pandas as pd

#: The windows that were counted, from when to when after the start [s].
WINDOWS = {"startup": (0.0, 12.0), "steady": (12.0, 36.0)}

#: Endpoints of a process that are on the one topic of all, where the others are not [1].
SHARED = 2

#: Messages, frames and bytes where none was seen.
NONE = (0.0, 0.0, 0.0)

#: Window, kind, what it is about ("" for all), cast, and its only hop ("" if it takes both).
Key = tuple[str, str, str, str, str]


@dataclass(frozen=True)
class Point:
    """A point of the grid, as all runs of one product and variant saw it.

    Parameters
    ----------
    name : str
        Hosts, processes and endpoints, and whether names match (m), are unique (u), or one topic
        is shared beside unique ones (s).
    use : str
        The half of the grid: "fit" or "test".
    fleet : Fleet
        Its hosts.
    runs : dict
        By window, kind, what it is about, cast and hop: messages [1], frames [1] and bytes of
        payload [B], a row a run.
    ready : numpy.ndarray
        When the last process of each run had made its endpoints [s].
    """

    name: str
    use: str
    fleet: Fleet
    runs: dict[Key, NDArray[np.float64]]
    ready: NDArray[np.float64]

    def median(self, key: Key) -> NDArray[np.float64]:
        """Return the medians of messages, frames and bytes; zeros if none was seen."""
        return np.median(self.runs[key], axis=0) if key in self.runs else np.zeros(3)


@cache
def products() -> dict[str, dict[str, str]]:
    """Return the rows of ``data/vendors/products.csv`` by the name of the table."""
    return {row["protocol"]: row for row in read_data("vendors/products.csv")}


@cache
def arrangements() -> dict[str, dict[str, str]]:
    """Return the rows of ``data/vendors/arrangements.csv`` by the name of the table."""
    return {row["protocol"]: row for row in read_data("vendors/arrangements.csv")}


@cache
def _counts(kind: str) -> dict[str, dict[Key, tuple[float, ...]]]:
    counts: dict[str, dict[Key, tuple[float, ...]]] = defaultdict(dict)
    for row in read_data(f"measured/{kind}counts.csv"):
        messages, frames, octets = map(float, (row["messages"], row["frames"], row["bytes"]))
        cast = "multicast" if row["multicast"] == "1" else "unicast"
        of_run = counts[row["run"]]
        for about in {row["about"], ""}:
            key = (row["window"], row["kind"], about, cast, row.get("hops", ""))
            known = of_run.get(key, NONE)
            of_run[key] = (known[0] + messages, known[1] + frames, known[2] + octets)
    return counts


@cache
def points(name: str, shared: bool = False) -> tuple[Point, ...]:
    """Return the points of the grid that a table is held against, with at least two hosts.

    Parameters
    ----------
    name : str
        Of a table of ``data/vendors/products.csv`` or ``arrangements.csv``.
    shared : bool, optional
        Instead of these, the points of ``lab/shared.csv``, where the first writer and the first
        reader of each process are on one topic of all, and the others on topics of their own.

    Returns
    -------
    tuple of Point
        In the order of the grid. For a table of a network that is taken for wired, those with
        three processes or more, as two send otherwise.

    Raises
    ------
    ValueError
        If there is no such table.
    """
    known = products() | arrangements()
    _checks.choice("name", name, list(known))
    row, kind = known[name], "mitigation_" if name in arrangements() else ""
    kind = "shared_" if shared else kind
    return points_of(row["product"], row["variant"], int(row["least_processes"]), kind)


def points_of(
    product: str, variant: str, least: int = 2, kind: str = "mitigation_"
) -> tuple[Point, ...]:
    """Return the points of a product and variant that have at least so many processes [1].

    With the kind left out: of an arrangement of ``lab/mitigations.csv``, with a table or without.
    """
    of_point: dict[tuple[str, ...], dict[str, float]] = defaultdict(dict)
    for run in read_data(f"measured/{kind}runs.csv"):
        if (run["product"], run["variant"]) == (product, variant):
            columns = ("hosts", "processes", "endpoints", "names", "use")
            of_point[tuple(run[column] for column in columns)][run["run"]] = float(run["made_s"])
    found = []
    counts = _counts(kind)
    for (hosts, processes, endpoints, names, use), runs in of_point.items():
        if int(hosts) < 2 or int(hosts) * int(processes) < least:
            continue
        same = SHARED if names == "shared" else 0
        host = HostGroup(int(hosts), int(processes), int(endpoints), shared=same)
        found.append(
            Point(
                f"{hosts}x{processes}x{endpoints}{names[0]}",
                use,
                Fleet((host,), matching=float(names == "matching")),
                {
                    key: np.array([counts[run].get(key, NONE) for run in runs])
                    for key in sorted({key for run in runs for key in counts[run]})
                },
                np.array(list(runs.values())),
            )
        )
    return tuple(found)


def payloads(name: str, kind: str) -> list[float]:
    """Return the mean payload of a kind of message in the start-up window of each point [B]."""
    found = []
    for point in points(name):
        keys = (("startup", kind, "", cast, "") for cast in ("multicast", "unicast"))
        messages, _, octets = np.sum([point.median(key) for key in keys], axis=0)
        if messages:
            found.append(float(octets / messages))
    return found


def times(schedule: Schedule, window: str) -> float:
    """Return how many times of a schedule are in a window."""
    begin, end = (float(np.asarray(schedule.sent(time))) for time in WINDOWS[window])
    return end - begin * (window != "startup")


def expected(message: Message, fleet: Fleet, window: str) -> float:
    """Return how many of a message a fleet sends in a window [1]."""
    return float(message.load(fleet)) * times(message.schedule, window)


def held(protocol: Protocol, shared: bool = False) -> pd.DataFrame:
    """Hold a table as built against the medians of all points of the grid.

    Parameters
    ----------
    protocol : Protocol
        Of a name in ``data/vendors/products.csv`` or ``arrangements.csv``.
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
    import pandas as pd

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
WITHIN_ARRANGED = 0.10


def misses(protocol: Protocol, use: str = "test") -> list[dict[str, str]]:
    """Return where a table as built is off by more than it should be, on one half of the grid.

    Returns
    -------
    list of dict
        ``protocol``, ``point``, ``window``, ``phase``, ``kind`` ("all" of a phase), ``quantity``
        (messages or bytes), ``error`` [1], and ``reason``, one of ``data/measured/reasons.csv``.
    """
    table = held(protocol)
    arranged = protocol.name in arrangements()
    found = []
    for row in table[table["use"] == use].to_dict("records"):
        for quantity, end in (("messages", ""), ("bytes", "_bytes")):
            measured, count = row[f"measured{end}"], row[f"expected{end}"]
            of_phase = row["kind"].startswith("all")
            if arranged and not of_phase:
                continue
            limit = WITHIN_ARRANGED if arranged else WITHIN_PHASE if of_phase else WITHIN_KIND
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
    if row["phase"] == "TCP" and protocol in arrangements():
        return "acknowledgements"
    if row["phase"] in ("Session", "KeepAlive", "TCP"):
        return "connections"
    if everyone == 2:
        return "one pair"
    causes = _CAUSES.get(protocol.partition(" ")[0], {})
    return causes.get(row["phase"]) or ("crowd" if everyone >= 6 else "form")


#: By the first word of a table and by phase: where the source of a product says what decides.
_CAUSES = {
    "Cyclone": {
        "SPDP": "answers",
        "SEDP": "shared",
        **dict.fromkeys(("Liveliness", "Type lookup", "User"), "repeats"),
    },
    "static": {"SPDP": "known"},
    "Zenoh": {"Gossip": "news"},
}


#: What Wireshark counts of a packet beside the payload [B]: of Ethernet, IPv4, and UDP or TCP with
#: its timestamps.
AROUND = {"UDP": 14 + 20 + 8, "TCP": 14 + 20 + 20 + 12}


@cache
def staged() -> pd.DataFrame:
    """Return what the lab counted when it staged what others published.

    Returns
    -------
    pandas.DataFrame
        A row for each ``staging`` of ``lab/published.csv`` and each ``kind`` of message, and one of
        the ``packets`` that its authors would have counted: ``product``, ``variant`` and
        ``version``, the number of ``processes`` and of ``runs`` [1], the median ``count`` [1] with
        ``least`` and ``most``, the same of ``bytes``, for packets with the headers that Wireshark
        counts [B], and the median of ``last_s``, when the last endpoint was told of [s], NaN if
        that was not seen.
    """
    import pandas as pd

    table = pd.DataFrame(read_data("measured/published.csv"))
    for name in ("processes", "count", "bytes", "last_s"):
        table[name] = pd.to_numeric(table[name])
    rows = []
    for (staging, kind), runs in table.groupby(["staging", "kind"], sort=False):
        row = {"staging": staging, "kind": kind, "runs": len(runs)}
        row |= {name: runs[name].iloc[0] for name in ("product", "variant", "version", "processes")}
        for name, end in (("count", ""), ("bytes", "_bytes")):
            row[name] = float(runs[name].median())
            row[f"least{end}"], row[f"most{end}"] = float(runs[name].min()), float(runs[name].max())
        rows.append(row | {"last_s": float(runs["last_s"].median())})
    return pd.DataFrame(rows).set_index(["staging", "kind"])


def published() -> pd.DataFrame:
    """Return what others published of discovery traffic, beside the model and our measurements.

    Returns
    -------
    pandas.DataFrame
        A row for each number of ``data/vendors/published.csv``, indexed by its ``id``, with all
        its columns, and what the paper's table and that of a product ``as_built``, Fast DDS or
        Zenoh peer, expect of the phases that were counted, in the window: messages [1], or bytes
        with the headers that Wireshark counts [B], each message in a packet of its own; and what
        was ``measured`` in the first of the stagings that the row names, the median of its runs,
        with ``least`` and ``most``. NaN where no number was published, no table can say, or
        nothing was staged.

    References
    ----------
    Paper, Table II and equations (1) to (10); ``data/vendors/published.csv``.
    """
    import pandas as pd

    lab, rows = staged(), []
    for row in read_data("vendors/published.csv"):
        wire = "Zenoh" if row["product"].startswith("Zenoh") else "DDS"
        of_paper, built = (ZENOH, "Zenoh peer") if wire == "Zenoh" else (DDS, "Fast DDS")
        counts = {
            "number": float(row["number"] or "nan"),
            "paper": _as_counted(of_paper, row),
            "as_built": _as_counted(PROTOCOLS[built], row),
        }
        staging = row["staged"].partition(" ")[0]
        end = "_bytes" if row["quantity"] == "bytes" else ""
        columns = (row["quantity"].replace("packets", "count"), f"least{end}", f"most{end}")
        for name, column in zip(("measured", "least", "most"), columns, strict=True):
            counts[name] = float(lab[column][staging, "packets"])
        rows.append({name: text for name, text in row.items() if name != "number"} | counts)
    return pd.DataFrame(rows).set_index("id")


def _as_counted(protocol: Protocol, row: dict[str, str]) -> float:
    """Return what a table expects of the messages that somebody counted."""
    if not row["fleet"]:
        return float("nan")
    # Endpoints may be a mean over the processes of a host, such as 98/3.
    counts = (map(Fraction, group.split("x")) for group in row["fleet"].split())
    groups = tuple(HostGroup(int(hosts), int(some), float(each)) for hosts, some, each in counts)
    fleet, window = Fleet(groups, matching=1.0), float(row["window_s"])
    counted = row["counted"].split()
    return sum(
        float(message.load(fleet))
        * float(np.asarray(message.schedule.sent(window)))
        * (message.payload.nominal + AROUND[message.transport] if row["quantity"] == "bytes" else 1)
        for message in protocol.messages
        if message.phase in counted
    )


#: What tells the rows of ``data/measured/deaths.csv`` apart, but for the runs.
_OF_DEATHS = ("arrangement", "event", "phase", "who", "quantity")


@cache
def _seconds() -> dict[tuple[str, ...], list[dict[str, str]]]:
    found: dict[tuple[str, ...], list[dict[str, str]]] = defaultdict(list)
    for row in read_data("measured/deaths.csv"):
        found[tuple(row[name] for name in _OF_DEATHS)].append(row)
    return dict(found)


def death_times(
    arrangement: str, event: str, phase: str, who: str, quantity: str
) -> NDArray[np.float64]:
    """Return how long something took in each run after a server, router or robot had died [s].

    Parameters
    ----------
    arrangement : str
        Of ``data/measured/arrangements.csv``, such as "Zenoh router".
    event, phase, who, quantity : str
        What died, when it was looked at, whom it is about and what was measured, as
        ``data/measured/README.md`` has them.

    Returns
    -------
    numpy.ndarray
        A time a run [s]; infinite if it did not happen while it was watched.

    Raises
    ------
    ValueError
        If that was not measured.
    """
    key = (arrangement, event, phase, who, quantity)
    if key not in _seconds():
        for position, name in enumerate(_OF_DEATHS):
            known = {other[position] for other in _seconds() if other[:position] == key[:position]}
            _checks.choice(name, key[position], sorted(known))
    return np.array([float(row["seconds"]) for row in _seconds()[key]])


def deaths() -> pd.DataFrame:
    """Return what the lab saw when servers, routers and robots died, all runs taken together.

    Returns
    -------
    pandas.DataFrame
        A row for each ``arrangement``, ``event``, ``phase``, ``who`` and ``quantity``: how long
        after the death the phase begins, ``since_s``, and how long it was watched, ``watched_s``
        [s]; the number of ``runs`` and of those in which it ``happened`` [1]; ``median_s``,
        ``least_s`` and ``most_s`` of all runs [s], infinite where it did not happen.

    Notes
    -----
    What each quantity is, says ``data/measured/README.md``.
    """
    import pandas as pd

    rows = []
    for key, runs in _seconds().items():
        seconds = np.array([float(row["seconds"]) for row in runs])
        rows.append(
            dict(zip(_OF_DEATHS, key, strict=True))
            | {
                "since_s": float(runs[0]["since_s"]),
                "watched_s": float(runs[0]["watched_s"]),
                "runs": len(runs),
                "happened": int(np.isfinite(seconds).sum()),
                "median_s": float(np.median(seconds)),
                "least_s": float(seconds.min()),
                "most_s": float(seconds.max()),
            }
        )
    return pd.DataFrame(rows)


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
    import pandas as pd

    protocol = PROTOCOLS["hybrid, alike" if alike else "hybrid"]
    software = "alike" if alike else "unlike"
    runs = pd.DataFrame(read_data("measured/hybrid.csv"))
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
