"""The protocols: tables of messages.

`PROTOCOLS` holds, by their names, the paper's tables, those of products of which `as_built` reads
the rows, and each table that another file of this folder defines.
"""

from collections.abc import Mapping
from importlib import import_module
from pkgutil import iter_modules
from types import MappingProxyType

from discostorm import _checks, _names
from discostorm.data import read_data
from discostorm.messages import Basis, Protocol
from discostorm.protocols.as_built import as_built, described
from discostorm.protocols.paper import DDS, ZENOH

#: On what the counts of tables stand, in the order in which calculator and commands offer them.
BASES: Mapping[Basis, str] = MappingProxyType(
    {
        "measured": "Products as built",
        "mitigated": "Products with mitigations",
        "paper": "As the paper counts",
        "timed": "The paper's messages, a product's periods",
        "proposal": "Proposals and other tables",
    }
)

#: Where the tables of files are among those of rows, whose column `place` says where they are.
_FILES = 50


def _tables() -> dict[str, Protocol]:
    placed = [
        (int(row["place"]), as_built(name)) for name, row in described().items() if row["place"]
    ]
    for file in sorted(module.name for module in iter_modules(__path__)):
        for key, value in vars(import_module(f"{__name__}.{file}")).items():
            if isinstance(value, Protocol) and not key.startswith("_"):
                placed.append((0 if file == "paper" else _FILES, value))
    found: dict[str, Protocol] = {}
    for _, table in sorted(placed, key=lambda pair: pair[0]):
        if found.setdefault(table.name, table) != table:
            raise ValueError(f"protocols must have names that differ; got two {table.name!r}")
    return found


#: Every protocol by its name, such as ``PROTOCOLS["Fast DDS"]``.
PROTOCOLS: Mapping[str, Protocol] = MappingProxyType(_tables())


def offered() -> tuple[Protocol, ...]:
    """Return every protocol in the order in which calculator and commands offer them."""
    order = list(BASES)
    return tuple(sorted(PROTOCOLS.values(), key=lambda one: order.index(one.basis or "proposal")))


def aliases() -> dict[str, str]:
    """Return the names of protocols by other names that people use (``vendors/aliases.csv``)."""
    return {row["alias"]: row["protocol"] for row in read_data("vendors/aliases.csv")}


def named(name: str) -> Protocol:
    """Return the protocol of a name that people use, in any case, with or without hyphens.

    Raises
    ------
    ValueError
        If there is none; the message has the nearest name.

    Examples
    --------
    >>> named("fastdds").name, named("rmw_cyclonedds_cpp").name, named("ZENOH").name
    ('Fast DDS', 'Cyclone DDS', 'Zenoh')
    """
    other = aliases()
    found = _names.meant(name, PROTOCOLS, other)
    if found is None:
        like = _names.did_you_mean(name, (*PROTOCOLS, *other))
        raise ValueError(f"protocol must be the name of one; got {_checks.brief(name)!r}{like}")
    return PROTOCOLS[found]


def _of_basis(basis: Basis) -> frozenset[str]:
    every = (table for known in PROTOCOLS.values() for table in (known, known.wired) if table)
    return frozenset(table.name for table in every if table.basis == basis)


#: The names of those that say what products really send; the others have the paper's counts.
MEASURED = _of_basis("measured")

#: The names of those that say what products send when they are arranged against the storm.
ARRANGED = _of_basis("mitigated")

__all__ = [
    "ARRANGED",
    "BASES",
    "DDS",
    "MEASURED",
    "PROTOCOLS",
    "ZENOH",
    "aliases",
    "named",
    "offered",
]
