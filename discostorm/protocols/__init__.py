"""The protocols: tables of messages.

`PROTOCOLS` holds, by name, the tables of the paper, those of products (read by `measured_tables`),
and each table that another module of this folder defines.
"""

from collections.abc import Mapping
from importlib import import_module
from pkgutil import iter_modules

from discostorm import _names
from discostorm.data import read_data
from discostorm.messages import Basis, Protocol
from discostorm.protocols.measured_tables import (
    configurations,
    measured_table,
    product_releases,
    products,
)
from discostorm.protocols.paper import DDS as DDS, ZENOH as ZENOH

#: Sources of the tables' counts, in the order of the calculator and the commands.
BASES: Mapping[Basis, str] = {
    "measured": "Products as built",
    "mitigated": "Products with mitigations",
    "paper": "As the paper counts",
    "timed": "The paper's messages, a product's periods",
    "proposal": "Proposals and other tables",
}

#: Sort order of tables that Python files define; the column `place` sorts tables in rows.
_SORT_ORDER_OF_FILES = 50


def _protocols_by_name() -> dict[str, Protocol]:
    tables = [
        (int(row["place"]), measured_table(name))
        for name, row in (products() | product_releases() | configurations()).items()
        if row["place"]
    ]
    for file in sorted(module.name for module in iter_modules(__path__)):
        for key, value in vars(import_module(f"{__name__}.{file}")).items():
            if isinstance(value, Protocol) and not key.startswith("_"):
                tables.append((0 if file == "paper" else _SORT_ORDER_OF_FILES, value))
    by_name: dict[str, Protocol] = {}
    for _, table in sorted(tables, key=lambda pair: pair[0]):
        if by_name.setdefault(table.name, table) != table:
            raise ValueError(f"protocols must have distinct names; got two {table.name!r}")
    return by_name


def aliases() -> dict[str, str]:
    """Return the names of protocols by other names that people use (``vendors/aliases.csv``)."""
    return {row["alias"]: row["protocol"] for row in read_data("vendors/aliases.csv")}


#: Every protocol by its name, such as ``PROTOCOLS["Fast DDS"]``.
PROTOCOLS = _names.Catalog("protocol", _protocols_by_name(), aliases())


def protocols_in_order() -> tuple[Protocol, ...]:
    """Return all protocols in the order of the calculator and the commands."""
    order = list(BASES)
    return tuple(sorted(PROTOCOLS.values(), key=lambda p: order.index(p.basis or "proposal")))


def _names_of_basis(basis: Basis) -> frozenset[str]:
    tables = (table for main in PROTOCOLS.values() for table in (main, main.wired) if table)
    return frozenset(table.name for table in tables if table.basis == basis)


#: Names of the measured tables of products, for the releases that the chapters examine.
MEASURED = _names_of_basis("measured") - product_releases().keys()

#: Names of the measured tables of configurations that reduce discovery traffic.
MITIGATED = _names_of_basis("mitigated")
