"""The planner's data files against the lab's runs."""

import subprocess
import sys

import numpy as np

import discostorm as ds
from discostorm.data import read_data
from discostorm.protocols.measured_tables import product_releases
from discostorm_book import lab_counts
from discostorm_planner.changes import Change
from discostorm_planner.protocol_changes import protocol_changes


def test_importing_the_package_loads_neither_pandas_nor_matplotlib_nor_click() -> None:
    code = (
        "import sys, discostorm;"
        "print([m for m in ('pandas', 'matplotlib', 'click') if m in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", code], text=True, capture_output=True, check=True)
    assert done.stdout == "[]\n"


#: What is measured of a kind of remedy: who dies, when, who, what, and whether that happens.
MEASURED_DEATHS = {
    "discovery server": """
        server killed, death, survivors, settled, yes
        server killed, newcomer, newcomer, found, no
        server killed, return, newcomer, found, yes
    """,
    "two discovery servers": """
        server killed, newcomer, newcomer, found, yes
        both servers killed, newcomer, newcomer, found, no
    """,
    "router": """
        server killed, death, survivors, settled, no
        server killed, return, survivors, found, yes
    """,
    "router on each host": """
        server killed, death, survivors, settled, yes
        server killed, death, orphans and survivors, settled, no
        server killed, return, orphans, found, yes
    """,
}


def test_what_fails_when_is_what_the_lab_measured() -> None:
    rows = {row["kind"]: row for row in read_data("vendors/remedies.csv")}
    died = {
        row["configuration"] for row in read_data("measured/configurations.csv", "discostorm_book")
    }
    assert {kind for kind, row in rows.items() if row["table"] in died} == set(MEASURED_DEATHS)
    for kind, cases in MEASURED_DEATHS.items():
        for case in cases.strip().splitlines():
            *key, happens = case.strip().split(", ")
            times = lab_counts.failure_times(rows[kind]["table"], *key)
            assert (times < np.inf).all() == (happens == "yes"), case
    for backup in ("", ", backup"):
        short = np.concatenate(
            [
                lab_counts.failure_times(f"Fast DDS Discovery Server{backup}", event, *found)
                for event in ("outage of 3 s", "outage of 10 s", "outage of 10 s, robot restarts")
                for found in [("return", "newcomer", "found")]
            ]
        )
        assert np.isinf(short).any() == (not backup)
    assert "and after short outages" in rows["discovery server"]["fails"]
    for kind in ("router", "router on each host"):
        *key, _ = MEASURED_DEATHS[kind].strip().splitlines()[-1].strip().split(", ")
        back = np.median(lab_counts.failure_times(rows[kind]["table"], *key))
        assert f"until {back:.1f} s after the router is back" in rows[kind]["fails"]


def test_a_server_forwards_as_that_of_its_release_did() -> None:
    """Captured airtime of a release with a server, over that of the table that plans take."""
    ratios: dict[str, list[float]] = {}
    shipped = [row for row in read_data("vendors/ros.csv") if row["long_term"] == "yes"]
    forwards = {(row["protocol"], row["server_forwards"]) for row in shipped}
    for row in read_data("measured/release_servers.csv", "discostorm_book"):
        if not row["release"].endswith(product_releases()[row["protocol"]]["versions"]):
            continue  # Kilted's server filters, and the table of Lyrical's stands for its peers
        # What every ROS 2 process has in common matches, or all does.
        counts = (float(row[name]) for name in ("hosts", "processes", "endpoints"))
        fleet = ds.Fleet((ds.HostGroup(*counts, shared=2.0),), float(row["point"].endswith("m")))
        protocol = ds.PROTOCOLS[row["protocol"]]
        changes = {c.kind: c for c in protocol_changes(protocol) if isinstance(c, Change)}
        table = changes["discovery server"].table
        assert table is not None
        ratio = float(row["airtime_s"]) / float(ds.utilization(table, fleet))
        ratios.setdefault(row["protocol"], []).append(ratio)
        offered = "discovery server on a robot" in changes
        assert offered == ((row["protocol"], "matched") in forwards)
    assert {name: len(found) for name, found in ratios.items()}["Fast DDS 3.6"] == 6
    for name, found in ratios.items():
        assert min(found) > 0.7, name
        assert max(found) < 1.8, name
