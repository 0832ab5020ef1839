"""The protocols: tables of messages.

`PROTOCOLS` holds, by their names, the paper's tables, those of products of which `as_built` reads
the rows, and each table that another file of this folder defines.
"""

from collections.abc import Mapping
from importlib import import_module
from pkgutil import iter_modules
from types import MappingProxyType

from discostorm.messages import Basis, Protocol
from discostorm.protocols.as_built import as_built, described
from discostorm.protocols.paper import DDS, ZENOH

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


def _of_basis(basis: Basis) -> frozenset[str]:
    every = (table for known in PROTOCOLS.values() for table in (known, known.wired) if table)
    return frozenset(table.name for table in every if table.basis == basis)


#: The names of those that say what products really send; the others have the paper's counts.
MEASURED = _of_basis("measured")

#: The names of those that say what products send when they are arranged against the storm.
ARRANGED = _of_basis("arranged")

__all__ = ["ARRANGED", "DDS", "MEASURED", "PROTOCOLS", "ZENOH"]
