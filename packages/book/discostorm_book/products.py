"""Tables of the messages of products, compared with the paper's counts."""

from collections.abc import Iterable
from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np
import pandas as pd

from discostorm.data import data_path, read_data
from discostorm.fleet import Fleet, HostGroup
from discostorm.messages import Protocol
from discostorm.model import breakdown, utilization
from discostorm.protocols import DDS, PROTOCOLS, ZENOH, measured_tables
from discostorm.saturation import saturation_hosts
from discostorm_book import comparison, lab_counts
from discostorm_book.lab_counts import paper_protocol_of_product

#: The measured model of each product as shipped, on Wi-Fi; the others are variants of these.
SHIPPED = ("Fast DDS", "Cyclone DDS", "Zenoh peer")
#: All measured models as shipped, with their variants.
MODELS = tuple(name for name in measured_tables.products() if name in PROTOCOLS)
#: The products that ran with DDS Security.
SECURED = ("Fast DDS", "Cyclone DDS")
#: The paper's tables.
PAPER_TABLES = (DDS.name, ZENOH.name)
#: A swarm of the half that no model was fitted to, with matching names, and its fleet.
HELD_OUT_SWARM, HELD_OUT_FLEET = "3x2x10m", Fleet((HostGroup(3, 2, 10),), matching=1.0)
#: Processes and endpoints of a small robot, and of one that runs Nav2.
SMALL, NAV2 = (2, 10), (1, 678)
#: A count of the paper is right up to this relative error [1].
COUNT_TOLERANCE = 0.1
_MESSAGE_WORDS = read_data("paper/message_words.csv", "discostorm_book")
#: Purposes of the messages that the paper counts.
PURPOSES = {row["message"]: row["purpose"] for row in _MESSAGE_WORDS}
NO_EQUATION = "no equation"
_EN_DASH = "\N{EN DASH}"


def measured_models() -> pd.DataFrame:
    """Return the measured models: table, version, programs, and number of runs."""
    every = pd.DataFrame(read_data("measured/runs.csv", "discostorm_book"))
    number = every.groupby(["product", "variant"]).size()
    return pd.DataFrame(
        {"model": name, "version": row["versions"], "what": row["what"]}
        | {"runs": number[row["product"], row["variant"]]}
        for name, row in measured_tables.products().items()
    )


def startup_counts(name: str) -> pd.DataFrame:
    """Return the messages of a startup of `HELD_OUT_FLEET`: measured, by model, by the paper."""
    every = comparison.compare_with_runs(PROTOCOLS[name])
    rows = every.query("point == @HELD_OUT_SWARM and window == 'startup' and kind != 'all'")
    messages = paper_protocol_of_product(name).messages
    counted = {m.kind: float(m.load(HELD_OUT_FLEET)) for m in messages}
    sizes = {m.kind: counted[m.kind] * m.payload.nominal for m in messages}
    rows = rows.assign(paper=rows["kind"].map(counted), paper_bytes=rows["kind"].map(sizes))
    return rows.reset_index(drop=True)


def sent_per_counted_message(names: Iterable[str] = SHIPPED) -> pd.DataFrame:
    """Return the number and the length of each of the paper's messages, as the lab counted them."""
    rows, parts = [], (0.5, 0, 1)
    for name in names:
        for message in paper_protocol_of_product(name).messages:
            ratios = np.array(lab_counts.sent_over_counted(name, message.name))
            sizes, paper = lab_counts.mean_payloads(name, message.name), message.payload
            row: dict[str, Any] = {"product": name, "message": message.name}
            row |= zip(("median", "min", "max"), np.quantile(ratios, parts), strict=True)
            row |= {"as_counted": float(np.mean(np.abs(ratios - 1) <= COUNT_TOLERANCE))}
            row |= {"paper_B": paper.nominal, "paper_low_B": paper.low, "paper_high_B": paper.high}
            row |= zip(("median_B", "min_B", "max_B"), np.quantile(sizes, parts), strict=True)
            rows.append(row)
    return pd.DataFrame(rows)


def unicast_share(name: str, kind: str) -> float:
    """Return the share of a kind of message that is unicast, in the median startup [1]."""
    keys = [("startup", kind, "", cast, "") for cast in ("unicast", "multicast")]
    casts = ([float(p.median(key)[0]) for key in keys] for p in lab_counts.grid_points(name))
    return float(np.median([unicast / (unicast + multicast) for unicast, multicast in casts]))


def periodic_traffic(names: Iterable[str] = SHIPPED) -> pd.DataFrame:
    """Return the periodic traffic of measured models: one row per message."""
    return pd.DataFrame(
        {"product": name, "message": message.name, "sent per": message.unit.name}
        | {"period [s]": message.schedule.period, "each time": message.per_unit}
        | {"payload [B]": message.payload.nominal}
        for name in names
        for message in PROTOCOLS[name].messages
        if message.schedule.per_second
    )


def airtime_by_purpose(hosts: int, processes: int, endpoints: int) -> pd.DataFrame:
    """Return the airtime of a startup by purpose [s]: one row per table, the paper's first."""
    rows: dict[str, pd.Series] = {}
    for name in SHIPPED:
        for protocol in (paper_protocol_of_product(name), PROTOCOLS[name]):
            purposes = [PURPOSES.get(m.kind, NO_EQUATION) for m in protocol.messages]
            costs = _airtime_by_message(protocol, hosts, processes, endpoints)
            rows[protocol.name] = costs.groupby(purposes).sum()
    return pd.DataFrame(rows).T.fillna(0.0)[[*dict.fromkeys(PURPOSES.values()), NO_EQUATION]]


def airtime_of_kinds(kinds: Iterable[str], name: str, *swarm: int) -> float:
    """Return the airtime of some kinds of message of a measured model, in a swarm [s]."""
    protocol, kinds = PROTOCOLS[name], set(kinds)
    chosen = [message.kind in kinds for message in protocol.messages]
    return float(_airtime_by_message(protocol, *swarm)[chosen].sum())


def _airtime_by_message(protocol: Protocol, *swarm: Any) -> pd.Series:
    """Return the airtime of each message of a swarm [s]."""
    costs = breakdown(protocol, *swarm)
    return costs["uplink_s"] + costs["downlink_s"]


def saturation_points() -> pd.DataFrame:
    """Return the hosts, and the processes on three hosts, that fill a second or a lease."""
    matching, processes = Fleet((HostGroup(1, *SMALL),), matching=1.0), np.geomspace(1, 60, 4000)
    rows = []
    for paper in (DDS, ZENOH):
        models = [name for name in MODELS if PROTOCOLS[name].family == paper.family]
        for name in (paper.name, *models):
            model = PROTOCOLS[name]
            lease = hosts_when_full(model, *SMALL, window=model.lease) if name in MODELS else np.nan
            row = {"model": name, "small robots": hosts_when_full(model, *SMALL)}
            row |= {"matching names": saturation_hosts(model, fleet=matching), "in a lease": lease}
            used = utilization(model, 3, processes, 40 / processes)  # 40 endpoints each host
            row |= {"processes": float(np.interp(1, used, processes))}
            rows.append(row | {"Nav2 robots": hosts_when_full(model, *NAV2)})
    return pd.DataFrame(rows).set_index("model")


def hosts_when_full(protocol: Protocol, processes: int, endpoints: int, **options: Any) -> float:
    """Return the hosts at which a swarm fills the channel."""
    return float(np.asarray(saturation_hosts(protocol, processes, endpoints, **options)))


def without_unsourced_messages(name: str) -> Protocol:
    """Return a measured table without third-party messages whose number has no source."""
    rows = read_data("vendors/as_built.csv")
    sourced = {row["message"] for row in rows if row["protocol"] == name and row["per_unit"]}
    kept = tuple(
        replace(message, answers=None)
        for message in PROTOCOLS[name].messages
        if "third" not in message.unit.name or message.name in sourced
    )
    return replace(PROTOCOLS[name], messages=kept)


@cache
def _all_comparisons() -> pd.DataFrame:
    tables = {name: comparison.compare_with_runs(PROTOCOLS[name]) for name in MODELS}
    return pd.concat(tables, names=["model"]).reset_index("model")


def held_out_errors(by_phase: bool = True) -> pd.DataFrame:
    """Return the relative errors on the held-out half, by phases or by kinds of message [1]."""
    table = _all_comparisons()
    rows = table[(table["use"] == "test") & ((table["kind"] == "all") == by_phase)]
    return rows[["model", "point", "window", "phase", "kind", "error", "error_bytes"]]


def cases_beyond_limits() -> pd.DataFrame:
    """Return all cases in which the measured models miss their limits, with reasons."""
    table = pd.DataFrame(read_data("measured/misses.csv", "discostorm_book"))
    return table[table["protocol"].isin(MODELS)]


def count_within_limits() -> pd.DataFrame:
    """Return the numbers of compared phases and kinds, and of those within limits."""
    table = pd.DataFrame({"model": m, "window": w} for w in lab_counts.WINDOWS for m in MODELS)
    keys = pd.MultiIndex.from_frame(table)
    for what, by_phase in (("phases", True), ("kinds", False)):
        outside = cases_beyond_limits().rename(columns={"protocol": "model"})
        outside = outside[(outside["kind"] == "all") == by_phase]
        compared = held_out_errors(by_phase).groupby(["model", "window"]).size()
        table[what] = compared.reindex(keys).to_numpy()
        for quantity in ("messages", "bytes"):
            some = outside[outside["quantity"] == quantity].groupby(["model", "window"]).size()
            table[f"{what}, {quantity}"] = table[what] - some.reindex(keys, fill_value=0).to_numpy()
    return table


def miss_reasons() -> pd.DataFrame:
    """Return the reasons why measured models miss their limits, the most frequent first."""
    cases = cases_beyond_limits()["reason"].value_counts().rename("cases")
    rows = pd.DataFrame(read_data("measured/reasons.csv", "discostorm_book")).set_index("reason")
    return rows.join(cases, how="right")[["cases", "what"]].reset_index()


def refit_errors() -> pd.DataFrame:
    """Return the mean error of the ``held_out`` airtime before and after the wider fit [1]."""
    table = pd.read_csv(data_path("measured/refits.csv", "discostorm_book"))
    rows = table[table["use"] == "test"].rename(columns={"protocol": "model"})
    for fit in ("before", "after"):
        rows[fit] = (rows["measured_s"] / rows[f"{fit}_s"] - 1).abs()
    groups = rows.groupby(["model", "swarms"], sort=False)
    means = {fit: (fit, "mean") for fit in ("before", "after")}
    return groups.agg(held_out=("point", "size"), **means).reset_index()


def restart_costs() -> pd.DataFrame:
    """Return the costs of a restart and of a joining host as shares of the startup: ranges."""
    return pd.DataFrame(
        {
            "model": row["protocol"],
            "event": {"restart": "one process restarts", "join": "one host joins"}[row["event"]],
            "runs": int(row["runs"]),
            "share": f"{float(row['least_share']):.0%}{_EN_DASH}{float(row['most_share']):.0%}",
            "pairs": f"{float(row['low']):.1f}{_EN_DASH}{float(row['high']):.1f}",
        }
        for row in read_data("measured/restarts.csv", "discostorm_planner")
    )


def airtimes_with_security() -> pd.DataFrame:
    """Return the airtime of startups with DDS Security and without: medians [s]."""
    path = data_path("measured/security.csv")
    return pd.read_csv(path, float_precision="round_trip").drop(columns="runs")


def unauthenticated_pairs(product: str) -> pd.DataFrame:
    """Return the ``pairs`` of each secured run, and the ``strangers`` that never authenticated."""
    runs = pd.read_csv(data_path("measured/security_strangers.csv", "discostorm_book"))
    return runs[runs["product"] == product].drop(columns="product")
