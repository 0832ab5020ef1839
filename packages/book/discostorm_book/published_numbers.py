"""Published numbers on discovery traffic, compared with the models and the lab."""

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

import numpy as np
import pandas as pd

from discostorm.data import read_data
from discostorm.fleet import Fleet, HostGroup
from discostorm.messages import Protocol
from discostorm.protocols import DDS, PROTOCOLS, ZENOH
from discostorm_book.sweeps import load_sweep

#: Headers that Wireshark counts with the payload of a packet [B]: of Ethernet, IPv4, and UDP or TCP
#: with its timestamps.
HEADERS_IN_CAPTURES = {"UDP": 14 + 20 + 8, "TCP": 14 + 20 + 20 + 12}
_SOFTWARE = {"fast_dds": "Fast DDS", "cyclone_dds_0.10": "Cyclone DDS", "zenoh": "Zenoh"}


def staged_counts() -> pd.DataFrame:
    """Return what the lab counted when it re-enacted each published measurement (medians)."""
    return load_sweep("staged", "measured").drop(columns="title").set_index(["staging", "kind"])


def published_with_counts() -> pd.DataFrame:
    """Return each published number with the numbers of the paper, a measured model and the lab."""
    lab, rows = staged_counts(), []
    for row in read_data("vendors/published.csv", "discostorm_book"):
        zenoh = row["product"].startswith("Zenoh")
        paper, built = (ZENOH, "Zenoh peer") if zenoh else (DDS, "Fast DDS")
        counts = {"number": float(row["number"] or "nan"), "paper": _number_by_model(paper, row)}
        counts["as_built"] = _number_by_model(PROTOCOLS[built], row)
        staging = row["staged"].partition(" ")[0]
        end = "_bytes" if row["quantity"] == "bytes" else ""
        columns = (row["quantity"].replace("packets", "count"), f"least{end}", f"most{end}")
        for name, column in zip(("measured", "least", "most"), columns, strict=True):
            counts[name] = float(lab[column][staging, "packets"])
        rows.append({name: text for name, text in row.items() if name != "number"} | counts)
    return pd.DataFrame(rows).set_index("id")


def _number_by_model(protocol: Protocol, row: dict[str, str]) -> float:
    """Return the number by a model of the messages that a publication counted."""
    if not row["fleet"]:
        return float("nan")
    # Endpoints may be a mean over the processes of a host, such as 98/3.
    counts = (map(Fraction, group.split("x")) for group in row["fleet"].split())
    groups = tuple(HostGroup(int(hosts), int(some), float(each)) for hosts, some, each in counts)
    fleet, window = Fleet(groups, matching=1.0), float(row["window_s"])
    of_bytes, phases = row["quantity"] == "bytes", row["counted"].split()
    return sum(
        float(message.load(fleet))
        * float(np.asarray(message.schedule.sent(window)))
        * (message.payload.nominal + HEADERS_IN_CAPTURES[message.transport] if of_bytes else 1)
        for message in protocol.messages
        if message.phase in phases
    )


def format_count(value: float, digits: int = 3) -> str:
    """Return a count with three significant digits; a dash if there is none.

    Examples
    --------
    >>> format_count(48844.0), format_count(float("nan"))
    ('48,800', '\N{EN DASH}')
    """
    return "\N{EN DASH}" if np.isnan(value) else f"{float(f'{value:.{digits}g}'):,.0f}"


def _range_text(row: Mapping[Any, Any], middle: str) -> str:
    least, most = (format_count(row[name]) for name in ("least", "most"))
    return format_count(row[middle]) + ("" if least == most else f" ({least}\N{EN DASH}{most})")


def comparison_table() -> pd.DataFrame:
    """Return a table for a page: published number, paper, measured model and lab."""
    rows = published_with_counts().query("number.notna()").to_dict("records")
    return pd.DataFrame(
        {
            "what": f"{row['who']}, {row['published'][:4]}: "
            + row["product"].replace(" (version not said)", ""),
            "unit": row["quantity"],
            "published": format_count(row["number"], 6),
            "paper": format_count(row["paper"]),
            "measured model": format_count(row["as_built"]),
            "lab (min\N{EN DASH}max)": _range_text(row, "measured"),
        }
        for row in rows
    )


def staged_counts_table() -> pd.DataFrame:
    """Return the lab's counts of each reproduced publication, as a page shows them."""
    rows = load_sweep("staged", "measured").query("kind == 'packets'").to_dict("records")
    return pd.DataFrame(
        {
            "staged": row["title"],
            "software": _SOFTWARE[row["product"]],
            "processes": row["processes"],
            "packets (min\N{EN DASH}max)": _range_text(row, "count"),
            "bytes": format_count(row["bytes"]),
            "last endpoint known [s]": row["last_s"],
        }
        for row in rows
    )
