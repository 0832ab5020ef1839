"""What products send, beside what the paper counts: tables of the chapters on both."""

from collections.abc import Iterable
from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np
import pandas as pd

from discostorm import measured
from discostorm.data import read_data
from discostorm.fleet import Fleet, HostGroup
from discostorm.messages import Message, Protocol
from discostorm.model import breakdown, utilization
from discostorm.protocols import DDS, PROTOCOLS, ZENOH
from discostorm.saturation import saturation_hosts
from discostorm_book import comparison, lab_counts

#: The measured model of each product as shipped, on Wi-Fi; the others are variants of these.
SHIPPED = ("Fast DDS", "Cyclone DDS", "Zenoh peer")
#: All measured models as shipped, with their variants.
MODELS = tuple(name for name in measured.products() if name in PROTOCOLS)
#: The paper's tables.
PAPERS = (DDS.name, ZENOH.name)
#: A swarm of the half that no model was fitted to, with matching names, and its fleet.
POINT, THREE = "3x2x10m", Fleet((HostGroup(3, 2, 10),), matching=1.0)
#: Processes and endpoints of each: of a small robot, and of one that runs Nav2.
SMALL, NAV2 = (2, 10), (1, 678)
#: From here on a count of the paper is taken to be wrong [1].
WITHIN = 0.1
#: What the messages that the paper counts are for.
PURPOSES = {
    "SPDP": "presence", "Scout": "presence", "Hello": "presence",
    "SEDP": "endpoints", "Declare": "endpoints",
    "Heartbeat": "control", "ACKNACK": "control", "KeepAlive": "control",
}  # fmt: skip
NO_EQUATION = "no equation"


def paper_of(name: str) -> Protocol:
    """Return the paper's messages for a product."""
    return DDS if PROTOCOLS[name].family == "DDS" else ZENOH


def runs() -> pd.DataFrame:
    """Return the measured models: table, version, what was run, and how many runs there are."""
    every = pd.DataFrame(read_data("measured/runs.csv", "discostorm_book"))
    return pd.DataFrame(
        {
            "model": name,
            "version": row["versions"],
            "what": row["what"],
            "runs": (
                (every["product"] == row["product"]) & (every["variant"] == row["variant"])
            ).sum(),
        }
        for name, row in measured.products().items()
    )


def startup(name: str) -> pd.DataFrame:
    """Return what a product sent in the startup of `THREE`, by kind, and what is expected.

    Those of `comparison.held`, with ``paper`` and ``paper_bytes``: what the paper counts, NaN where
    it counts no such message.
    """
    held = comparison.held(PROTOCOLS[name])
    rows = held[
        (held["point"] == POINT) & (held["window"] == "startup") & (held["kind"] != "all")
    ].copy()
    counted = {
        message.kind: (float(message.load(THREE)), message.payload.nominal)
        for message in paper_of(name).messages
    }
    none = (np.nan, np.nan)
    rows["paper"] = [counted.get(kind, none)[0] for kind in rows["kind"]]
    rows["paper_bytes"] = [np.prod(counted.get(kind, none)) for kind in rows["kind"]]
    return rows.reset_index(drop=True)


def counts(names: Iterable[str] = SHIPPED) -> pd.DataFrame:
    """Return how often the paper's messages are sent, and how long they are.

    Returns
    -------
    pandas.DataFrame
        A row a ``product`` and ``message``: how many a startup has for one that the paper counts,
        the ``median`` of the measured swarms, ``min`` and ``max`` [1]; the share of the swarms in
        which the paper is right to within `WITHIN`, ``as_counted`` [1]; the payload by the paper,
        ``paper_B``, ``paper_low_B`` and ``paper_high_B``, and as measured, ``median_B``, ``min_B``
        and ``max_B`` [B].
    """
    return pd.DataFrame(
        {"product": name, "message": message.name, **_sent(name, message), **_sizes(name, message)}
        for name in names
        for message in paper_of(name).messages
    )


def _sent(name: str, message: Message) -> dict[str, float]:
    each = []
    for point in lab_counts.points(name):
        keys = [("startup", message.kind, "", cast, "") for cast in ("unicast", "multicast")]
        count = sum(point.median(key)[0] for key in keys)
        if units := float(message.load(point.fleet)):
            each.append(count / units)
    low, middle, high = np.quantile(each, (0, 0.5, 1))
    right = np.mean(np.abs(np.array(each) - 1) <= WITHIN)
    return {"median": middle, "min": low, "max": high, "as_counted": float(right)}


def _sizes(name: str, message: Message) -> dict[str, float]:
    low, middle, high = np.quantile(lab_counts.payloads(name, message.name), (0, 0.5, 1))
    said = message.payload
    return {
        "paper_B": said.nominal,
        "paper_low_B": said.low,
        "paper_high_B": said.high,
        "median_B": middle,
        "min_B": low,
        "max_B": high,
    }


def unicast_share(name: str, kind: str) -> float:
    """Return which part of a kind of message goes to one process: the median startup [1]."""
    shares = []
    for point in lab_counts.points(name):
        one, group = (
            point.median(("startup", kind, "", cast, ""))[0] for cast in ("unicast", "multicast")
        )
        shares.append(one / (one + group))
    return float(np.median(shares))


def periodic(names: Iterable[str] = SHIPPED) -> pd.DataFrame:
    """Return what the measured models repeat: a row a message."""
    return pd.DataFrame(
        {
            "product": name,
            "message": message.name,
            "sent per": message.unit.name,
            "period [s]": message.schedule.period,
            "each time": message.per_unit,
            "payload [B]": message.payload.nominal,
        }
        for name in names
        for message in PROTOCOLS[name].messages
        if message.schedule.per_second
    )


def airtime(hosts: int, processes: int, endpoints: int) -> pd.DataFrame:
    """Return the airtime of a startup by purpose [s]: a row a table, the paper's before its own."""
    rows: dict[str, pd.Series] = {}
    for name in SHIPPED:
        paper = paper_of(name)
        for protocol in (paper, PROTOCOLS[name]):
            spent = breakdown(protocol, hosts, processes, endpoints)
            purposes = [PURPOSES.get(m.kind, NO_EQUATION) for m in protocol.messages]
            total = (spent["uplink_s"] + spent["downlink_s"]).groupby(purposes).sum()
            rows[protocol.name] = total
    every = pd.DataFrame(rows).T.fillna(0.0)
    return every[[*dict.fromkeys(PURPOSES.values()), NO_EQUATION]]


def airtime_of(kinds: Iterable[str], name: str, *swarm: int) -> float:
    """Return the airtime that some kinds of message of a measured model take [s].

    The swarm is hosts, processes and endpoints.
    """
    protocol, kinds = PROTOCOLS[name], set(kinds)
    hosts, processes, endpoints = swarm
    spent = breakdown(protocol, hosts, processes, endpoints)
    mine = [message.kind in kinds for message in protocol.messages]
    return float((spent["uplink_s"] + spent["downlink_s"])[mine].sum())


def saturation() -> pd.DataFrame:
    """Return at how many hosts a second is full, with the paper's and all measured models.

    Returns
    -------
    pandas.DataFrame
        A row a ``model``: the hosts at which one second is full with ``small robots``, the same
        if ``names match``, the hosts at which a lease is full, ``in a lease``, the processes on
        three hosts that fill a second in Fig. 3, ``processes``, and the ``Nav2 robots``.
    """
    of_family = {
        family: [name for name in MODELS if PROTOCOLS[name].family == family]
        for family in (DDS.family, ZENOH.family)
    }
    names = [name for paper in (DDS, ZENOH) for name in (paper.name, *of_family[paper.family])]
    return pd.DataFrame(
        {
            "model": name,
            "small robots": full_at(PROTOCOLS[name], *SMALL),
            "names match": saturation_hosts(
                PROTOCOLS[name], fleet=Fleet((HostGroup(1, *SMALL),), matching=1.0)
            ),
            "in a lease": full_at(PROTOCOLS[name], *SMALL, window=PROTOCOLS[name].lease)
            if name in MODELS
            else np.nan,
            "processes": full_processes(PROTOCOLS[name]),
            "Nav2 robots": full_at(PROTOCOLS[name], *NAV2),
        }
        for name in names
    ).set_index("model")


def full_at(protocol: Protocol, processes: int, endpoints: int, **how: Any) -> float:
    """Return the hosts at which a swarm fills the channel."""
    return float(np.asarray(saturation_hosts(protocol, processes, endpoints, **how)))


def full_processes(protocol: Protocol) -> float:
    """Return the processes on three hosts, with 40 endpoints each host, that fill a second."""
    processes = np.geomspace(1, 60, 4000)
    used = utilization(protocol, 3, processes, 40 / processes)
    return float(np.interp(1, used, processes))


def without_guesses(name: str) -> Protocol:
    """Return a measured model without what grows with third processes and has no source."""
    sourced = {
        (row["protocol"], row["message"])
        for row in read_data("vendors/as_built.csv")
        if row["per_unit"]
    }
    protocol = PROTOCOLS[name]
    kept = tuple(
        replace(message, answers=None)
        for message in protocol.messages
        if "third" not in message.unit.name or (name, message.name) in sourced
    )
    return replace(protocol, messages=kept)


def errors(whole: bool = True) -> pd.DataFrame:
    """Return by how much the measured models are off on the half that they were not fitted to.

    Parameters
    ----------
    whole : bool, optional
        Of each phase; else of each kind of message.

    Returns
    -------
    pandas.DataFrame
        A row a ``model``, point, window and phase or kind, with the ``error`` of the messages and
        ``error_bytes``, relative to the median of the runs [1], NaN where nothing was measured.
    """
    held = _held()
    rows = held[(held["use"] == "test") & ((held["kind"] == "all") == whole)]
    return rows[["model", "point", "window", "phase", "kind", "error", "error_bytes"]]


@cache
def _held() -> pd.DataFrame:
    held = {name: comparison.held(PROTOCOLS[name]) for name in MODELS}
    return pd.concat(held, names=["model"]).reset_index("model")


def misses() -> pd.DataFrame:
    """Return where the measured models are off by more than they should be, and why: all cases."""
    every = pd.DataFrame(read_data("measured/misses.csv", "discostorm_book"))
    return every[every["protocol"].isin(MODELS)]


def within() -> pd.DataFrame:
    """Return in how many cases the measured models are within their limits.

    Returns
    -------
    pandas.DataFrame
        A row a ``model`` and ``window``: the number of ``phases`` and ``kinds`` that were compared,
        and of those that are within, in messages and in bytes.
    """
    missed, rows = misses(), []
    for window in lab_counts.WINDOWS:
        for name in MODELS:
            row: dict[str, Any] = {"model": name, "window": window}
            for what, whole in (("phases", True), ("kinds", False)):
                tried = errors(whole)
                tried = tried[(tried["model"] == name) & (tried["window"] == window)]
                gone = missed[
                    (missed["protocol"] == name)
                    & (missed["window"] == window)
                    & ((missed["kind"] == "all") == whole)
                ]["quantity"].value_counts()
                row[what] = len(tried)
                for quantity in ("messages", "bytes"):
                    row[f"{what}, {quantity}"] = len(tried) - int(gone.get(quantity, 0))
            rows.append(row)
    return pd.DataFrame(rows)


def reasons() -> pd.DataFrame:
    """Return why the measured models are off, with the number of ``cases``, most first."""
    why = misses()["reason"].value_counts().rename("cases")
    said = pd.DataFrame(read_data("measured/reasons.csv", "discostorm_book")).set_index("reason")
    return said.join(why, how="right")[["cases", "what"]].reset_index()


def refits() -> pd.DataFrame:
    """Return how far measured models were off before and after the fit to the wider grid.

    Returns
    -------
    pandas.DataFrame
        A row a ``model`` and class of ``swarms`` ("in the grid", "up to twice as large", "many
        endpoints"): how many were ``held_out`` [1], and the mean distance from 1 of the airtime of
        a startup as a part of what the model says, with the fit of ``before`` and ``after`` [1].
    """
    names = dict(
        zip(
            measured.CLASSES,
            ("in the grid", "up to twice as large", "many endpoints"),
            strict=True,
        )
    )
    rows = [
        row for row in read_data("measured/refits.csv", "discostorm_book") if row["use"] == "test"
    ]
    off: dict[tuple[str, str], list[tuple[float, float]]] = {
        (model, of): []
        for model in dict.fromkeys(r["protocol"] for r in rows)
        for of in names.values()
    }
    for row in rows:
        model = row["protocol"]
        every = lab_counts.points(model) + lab_counts.beyond(model)
        fleet = next(point.fleet for point in every if point.name == row["point"])
        size = max(measured.size_of(fleet, PROTOCOLS[model].captured or (1, 1, 1)))
        of = next(name for most, name in names.items() if size <= most)
        taken, before, after = (float(row[f"{what}_s"]) for what in ("measured", "before", "after"))
        off[model, of].append((abs(taken / before - 1), abs(taken / after - 1)))
    return pd.DataFrame(
        {"model": model, "swarms": of, "held_out": len(each)}
        | dict(zip(("before", "after"), np.mean(each, axis=0).tolist(), strict=True))
        for (model, of), each in off.items()
    )


#: Between the ends of a range.
TO = "\N{EN DASH}"


def restarts() -> pd.DataFrame:
    """Return what a process takes that restarts, and a host that joins: ranges, in words.

    Returns
    -------
    pandas.DataFrame
        A row a ``model`` and ``event``: the ``runs`` [1], airtime as a ``share`` of the startup of
        all, and as a multiple of what its own ``pairs`` of processes take in that.
    """
    return pd.DataFrame(
        {
            "model": row["protocol"],
            "event": {"restart": "one process restarts", "join": "one host joins"}[row["event"]],
            "runs": int(row["runs"]),
            "share": f"{float(row['least_share']):.0%}{TO}{float(row['most_share']):.0%}",
            "pairs": f"{float(row['low']):.1f}{TO}{float(row['high']):.1f}",
        }
        for row in read_data("measured/restarts.csv", "discostorm_planner")
    )
