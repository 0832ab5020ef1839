"""The protocols: tables of messages, one file a family.

`PROTOCOLS` holds each table that a file of this folder defines, by its name: the paper's
first, then the others in the order of their files.
"""

from collections.abc import Mapping
from importlib import import_module
from pkgutil import iter_modules
from types import MappingProxyType

from discostorm.data import read_data
from discostorm.messages import Protocol
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

#: The names of those that say what products really send; the others have the paper's counts.
MEASURED = frozenset(row["protocol"] for row in read_data("vendors/products.csv"))

#: The names of those that say what products send when they are arranged against the storm.
ARRANGED = frozenset(row["protocol"] for row in read_data("vendors/arrangements.csv"))

__all__ = ["ARRANGED", "DDS", "MEASURED", "PROTOCOLS", "ZENOH"]
