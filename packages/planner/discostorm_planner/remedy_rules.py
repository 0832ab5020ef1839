"""Rules from data/vendors: the tables for which a remedy works, and its effort."""

from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from typing import get_args

from discostorm import wording
from discostorm.data import read_data
from discostorm.messages import Family, Protocol, legs
from discostorm.protocols import PROTOCOLS
from discostorm.protocols.measured_tables import product_releases, products

#: Minimum useful saving of a change [1].
MIN_SAVING = 0.005
#: Ratios for products without a comparison: a factor of 2, as for fleets beyond those measured.
UNMEASURED_RATIOS = {"hosts": "0", "seconds": "0", "low": "0.5", "high": "2"}


def is_measured(protocol: Protocol) -> bool:
    """Return whether a table has a product's measured counts, in any configuration."""
    return protocol.basis in ("measured", "mitigated")


def same_table(protocol: Protocol, other: Protocol) -> bool:
    """Return whether two tables have the same key in the data files."""
    return protocol.key is not None and protocol.key == other.key


def product_of(protocol: Protocol) -> str | None:
    """Return the product of a measured table, such as "Zenoh"; None for any other table.

    Examples
    --------
    >>> import discostorm as ds
    >>> product_of(ds.PROTOCOLS["Zenoh router"]), product_of(ds.DDS)
    ('Zenoh', None)
    """
    rows = {row["product"]: row["software"] for row in read_data("vendors/families.csv")}
    return rows.get(protocol.product or "") if is_measured(protocol) else None


def rule(kind: str, family: str | None) -> dict[str, str] | None:
    """Return the rule of a kind of remedy for a family, else its rule for any family."""
    rows = {row["family"]: row for row in read_data("vendors/remedies.csv") if row["kind"] == kind}
    return rows.get(family or "any") or rows.get("any")


def rule_for(kind: str, protocol: Protocol) -> dict[str, str]:
    """Return the row of a kind of remedy for a protocol.

    Switching to a configuration uses the row for any family; rows of one family count its peers.
    """
    any_family = kind == "middleware" and protocol.basis == "mitigated"
    row = rule(kind, None if any_family else protocol.family)
    assert row is not None, kind
    return row


@cache
def configuration_rules() -> tuple[dict[str, str], ...]:
    """Return the remedies that replace a product's default configuration."""
    return tuple(row for row in read_data("vendors/remedies.csv") if row["table"] and row["base"])


@cache
def efforts() -> dict[str, dict[str, str]]:
    """Return the rows of ``data/vendors/efforts.csv``, by effort."""
    return {row["effort"]: row for row in read_data("vendors/efforts.csv", "discostorm_planner")}


def describe_efforts(names: Iterable[str]) -> str:
    """Return what efforts are, in words."""
    return wording.join_words(list(dict.fromkeys(efforts()[name]["what"] for name in names)))


def time_ratios(protocol: Protocol, with_server: bool = False) -> dict[str, str]:
    """Return the range of measured discovery times as multiples of simulated times.

    The times were measured on an emulated cell with up to ``hosts`` hosts and ``seconds``, for
    ``measured`` (`air_ratios.csv`): the release, else the product, or clients of that release with
    a Discovery Server. If none apply: `UNMEASURED_RATIOS`, and ``measured`` is empty.
    """
    rows = read_data("measured/air_ratios.csv", "discostorm_planner")
    named = {r["protocol"]: r for r in rows if bool(r["server"]) == with_server}
    # Releases answer at different speeds, so that one's clients do not stand for another's.
    own = named.get(protocol.key or "", {}) if with_server else _row_of(protocol, named)
    row = own or UNMEASURED_RATIOS
    measured = own.get("protocol", "") + " with a Discovery Server" * (with_server and bool(own))
    both = " to ".join(dict.fromkeys((row["low"], row["high"])))
    return {"measured": measured, "range": both} | {name: row[name] for name in UNMEASURED_RATIOS}


def simulation_caution(protocol: Protocol) -> str:
    """Return why simulations of a product or release may be wrong, empty if nothing is known."""
    return _row_of(protocol, products() | product_releases()).get("caution", "")


def uses_server_of(protocol: Protocol, today: Protocol) -> bool:
    """Return whether a table is today's product with a wired server or router."""
    same = product_of(protocol) == product_of(today) is not None
    return same and legs.has_server(protocol) and not legs.has_server(today)


def _row_of(protocol: Protocol, rows: Mapping[str, dict[str, str]]) -> dict[str, str]:
    """Return the row of a table or, if it has none, the row of its product; empty without both."""
    names = (protocol.key or "", protocol.product or "") if is_measured(protocol) else ()
    return next((rows[name] for name in names if name in rows), {})


def is_gerund(what: str) -> bool:
    """Return whether a change's name starts with a gerund, such as "composing"."""
    return what.split()[0].endswith("ing")


def inapplicable_remedies(protocol: Protocol) -> Iterator[str]:
    """Yield each remedy that is not known to work with a protocol, with the reason."""
    rows = read_data("vendors/remedies.csv")
    unknown = []
    # Any product's users may switch to the configurations of all products.
    for_anyone = {row["kind"] for row in configuration_rules() if row["table"] in PROTOCOLS}
    for kind in dict.fromkeys(row["kind"] for row in rows):
        if is_measured(protocol) and kind in for_anyone:
            continue
        row = rule(kind, protocol.family)
        of_kind = [other for other in rows if other["kind"] == kind]
        title = of_kind[0]["title"]
        if row is None and protocol.family is None:
            unknown.append(title)
        elif row is None:
            yield f"{title}: for {wording.join_words([other['family'] for other in of_kind])} only"
        elif row["works"] == "no":
            yield f"{row['title']}: {row['why']}"
    if unknown:
        families = f"whose family is neither {' nor '.join(get_args(Family))}"
        yield f"{wording.join_words(unknown)}: not known for {protocol.name}, {families}"
