"""What is known of remedies: for which tables they work, and what was simulated of them."""

from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from typing import get_args

from discostorm import words
from discostorm.data import read_data
from discostorm.messages import Family, Protocol
from discostorm.protocols import PROTOCOLS


def is_built(protocol: Protocol) -> bool:
    """Return whether a table has the counts of a product, as shipped or arranged otherwise."""
    return protocol.basis in ("measured", "mitigated")


def software(protocol: Protocol) -> str | None:
    """Return whose software sends what a table of a product as built holds, None of another table.

    rmw_zenoh is Zenoh with settings of its own; ``data/vendors/families.csv`` says so.

    Examples
    --------
    >>> import discostorm as ds
    >>> software(ds.PROTOCOLS["Zenoh router"]), software(ds.DDS)
    ('Zenoh', None)
    """
    rows = {row["product"]: row["software"] for row in read_data("vendors/families.csv")}
    return rows.get(protocol.product or "") if is_built(protocol) else None


def same(one: Protocol, other: Protocol) -> bool:
    """Return whether two tables are the same, whatever they are called."""
    return replace(one, name=other.name) == other


def known_as(protocol: Protocol) -> Protocol | None:
    """Return the table of this package that a table is, whatever it is called; None if none is."""
    return next((table for table in PROTOCOLS.values() if same(table, protocol)), None)


@cache
def configuring() -> tuple[dict[str, str], ...]:
    """Return the remedies that put the table of another configuration in place of a product's."""
    return tuple(row for row in read_data("vendors/remedies.csv") if row["table"] and row["base"])


def row_of(kind: str, of: str | None) -> dict[str, str] | None:
    """Return what the data say of a kind of remedy for a family, None if they do not."""
    rows = [row for row in read_data("vendors/remedies.csv") if row["kind"] == kind]
    found = [row for row in rows if row["family"] == of]
    return next(iter(found + [row for row in rows if row["family"] == "any"]), None)


def configuration_of(protocol: Protocol) -> dict[str, str] | None:
    """Return the remedy that puts this table in place of a product's, None of another table."""
    tables = ((row, PROTOCOLS.get(row["table"])) for row in configuring())
    return next((row for row, table in tables if table and same(table, protocol)), None)


def known(kind: str, protocol: Protocol) -> dict[str, str]:
    """Return what the data say of a kind of remedy for a protocol.

    Of switching to an configuration what holds for any: what a family counts is of its peers.
    """
    arranged = kind == "middleware" and protocol.basis == "mitigated"
    row = row_of(kind, None if arranged else protocol.family)
    assert row is not None, kind
    return row


@cache
def _simulated() -> dict[tuple[str, int], dict[tuple[str, str], float]]:
    """Return how long small robots take to all know each other, as simulated on 802.11n [s].

    By table of the paper and number of hosts, then by how they start and frames in an A-MPDU.
    """
    found: dict[tuple[str, int], dict[tuple[str, str], float]] = {}
    for row in read_data("simulated/staggered.csv", "discostorm_planner"):
        if row["radio"] == "n":
            starts = found.setdefault((row["protocol"], int(row["hosts"])), {})
            starts[row["start"], row["mpdus"]] = float(row["convergence_time_s"])
    return dict(sorted(found.items()))


def _small_robots() -> str:
    """Return what was simulated: each run has robots of one kind."""
    kinds = {
        (r["processes"], r["endpoints"])
        for r in read_data("simulated/staggered.csv", "discostorm_planner")
    }
    ((processes, endpoints),) = kinds
    return f"robots of {processes} processes with {endpoints} endpoints each"


def simulated_stagger(protocol: Protocol) -> str:
    """Return what the simulator says of small robots that start one after the other."""
    own = protocol.family
    gains = []
    for name in [own] if own else get_args(Family):
        for (_, hosts), times in [row for row in _simulated().items() if row[0][0] == name][-2:]:
            rule, together = (times[start, "1"] for start in ("rule", "together"))
            gains.append(
                f"{hosts} robots with {name} needed {rule:.0f} s instead of {together:.0f} s"
            )
    return (
        "queues then lose less: when we simulated the paper model's startup of "
        f"{_small_robots()}, {words.listed(gains)} (medians)"
    )


def simulated_aggregation(mpdus: int) -> str:
    """Return what the simulator says of aggregation, if small robots start together."""
    most = max(hosts for _, hosts in _simulated())
    gains = []
    for name in get_args(Family):
        one, many = (_simulated()[name, most]["together", n] for n in ("1", str(mpdus)))
        gains.append(f"{many:.0f} s instead of {one:.0f} s with {name}")
    return (
        f"when we simulated the paper model's startup of {most} {_small_robots()}, they needed "
        f"{words.listed(gains)} (medians)"
    )


def inapplicable(protocol: Protocol) -> Iterator[str]:
    """Yield what does not work with a protocol, and what is not known to."""
    own, built = protocol.family, is_built(protocol)
    rows = read_data("vendors/remedies.csv")
    unknown = []
    # Whoever has a product may change to the configurations of all products.
    anyones = (
        {row["kind"] for row in configuring() if row["table"] in PROTOCOLS} if built else set()
    )
    for kind in dict.fromkeys(row["kind"] for row in rows):
        if kind in anyones:
            continue
        row = row_of(kind, own)
        of_kind = [found for found in rows if found["kind"] == kind]
        if row is None and own is None:
            unknown.append(of_kind[0]["title"])
        elif row is None:
            others = words.listed([found["family"] for found in of_kind])
            yield f"{of_kind[0]['title']}: for {others} only"
        elif row["works"] == "no":
            yield f"{row['title']}: {row['why']}"
    if unknown:
        families = " nor ".join(get_args(Family))
        yield (
            f"{words.listed(unknown)}: not known for {protocol.name}, whose family is neither "
            f"{families}"
        )
