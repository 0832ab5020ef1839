"""The protocols: tables of messages, one file a family.

`PROTOCOLS` holds each table that a file of this folder defines, by its name: the paper's
first, then the others in the order of their files.
"""

from collections.abc import Mapping
from importlib import import_module
from pkgutil import iter_modules
from types import MappingProxyType

from discostorm.messages import Basis, Protocol
from discostorm.protocols.paper import DDS, ZENOH


def _tables() -> dict[str, Protocol]:
    names = sorted(module.name for module in iter_modules(__path__))
    found: dict[str, Protocol] = {}
    for name in sorted(names, key=lambda name: name != "paper"):
        for key, value in vars(import_module(f"{__name__}.{name}")).items():
            if not isinstance(value, Protocol) or key.startswith("_"):
                continue
            if found.setdefault(value.name, value) != value:
                raise ValueError(f"protocols must have names that differ; got two {value.name!r}")
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
