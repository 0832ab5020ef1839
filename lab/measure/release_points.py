"""The swarms that the campaign of releases measured, as `discostorm_book.lab_counts` has points."""

from collections import defaultdict
from collections.abc import Mapping
from dataclasses import replace
from functools import cache

from lab_data import DATA, read_lab_table

from discostorm.fleet import Fleet, HostGroup
from discostorm_book.lab_counts import (
    SHARED_ENDPOINTS,
    GridPoint,
    counts_of_runs,
    point_from_runs,
)

RUNS = f"{DATA}/releases/"
#: Endpoints of ros_discovery_info, which each process has besides those of the grid [1].
SHARED_ROS_TOPICS = SHARED_ENDPOINTS


def fleet_of(row: dict[str, str]) -> Fleet:
    """Return the fleet of a run: with ros_discovery_info, and the types that its processes lack."""
    hosts, processes, endpoints = (int(row[name]) for name in ("hosts", "processes", "endpoints"))
    shared = 0.0 if row["names"] == "matching" else SHARED_ROS_TOPICS
    matching = float(row["names"] == "matching")
    # With roles, every second pair of endpoints has a separate type.
    own_types = {"roles": 2 * (endpoints // 4), "own": endpoints}.get(row["types"], 0)
    each = HostGroup(
        hosts, processes, endpoints + SHARED_ROS_TOPICS, shared=shared, own_types=own_types
    )
    if row["types"] == "own":  # no other host knows these types, so no two hosts are identical
        return Fleet((replace(each, hosts=1),) * hosts, matching)
    return Fleet((each,), matching)


def release_of(table: Mapping[str, str]) -> str:
    """Return the release of a row of `vendors/releases.csv` as the campaign names it."""
    return f"{table['product']}-{table['versions']}"


@cache
def release_points(release: str, server: str = "") -> tuple[GridPoint, ...]:
    """Return the points of a release, such as fast_dds-3.6.2, whose runs were on idle cores."""
    counts = counts_of_runs(RUNS)
    runs: dict[tuple[str, ...], list[dict[str, str]]] = defaultdict(list)
    for row in read_lab_table("releases/runs.csv"):
        if (row["release"], row["server"], row["again"]) == (release, server, "0"):
            names = ("hosts", "processes", "endpoints", "names", "types", "use")
            runs[tuple(row[name] for name in names)].append(row)
    found = []
    for (*swarm, topics, types, use), rows in runs.items():
        ready_s = {row["run"]: float(row["endpoints_created_s"]) for row in rows}
        name = f"{'x'.join(swarm)}{topics[0]}" + f" {types}" * (types != "one")
        found.append(point_from_runs(name, use, fleet_of(rows[0]), ready_s, counts))
    return tuple(found)
