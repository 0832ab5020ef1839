"""Fleet files: tables of groups in TOML, checked for keys and types."""

import ipaddress
import re
import tomllib
from contextlib import AbstractContextManager, suppress
from typing import Any

from discostorm import _checks, _names, wording
from discostorm.data import read_data

#: The counts of each group, with their minimum; the maximum is `_checks.MAX_COUNT`.
MIN_COUNTS = {"hosts": 1, "processes": 1, "endpoints": 0}
COUNTS = tuple(MIN_COUNTS)
#: Maximum size of a file [B], and dots in a line: tomllib's time grows with their square.
MAX_BYTES, MAX_POINTS = 1_000_000, 256
#: Maximum of ROS_DOMAIN_ID: higher ones have no UDP ports (OMG DDSI-RTPS 2.5, 9.6).
MAX_DOMAIN = 232
#: Keys at the top of a fleet file, and keys of a group.
_TOP_KEYS = ("groups", "matching", "ros", "within", "domain", "addresses", "security", "cells")
_GROUP_KEYS = (*COUNTS, *("robot", "name", "nodes", "shared", "own_types", "wired", "data", "cell"))

#: Where keys belong that may be written elsewhere.
_KEY_PLACES = (
    dict.fromkeys(_TOP_KEYS, "above the groups")
    | dict.fromkeys(_GROUP_KEYS, "below [[groups]]")
    | {"wifi": "below [[cells]], or give --wifi to the command; '--wifi list' lists radios"}
)


def fleet_tables(content: bytes | bytearray | memoryview, name: str) -> dict[str, Any]:
    """Return the tables of a fleet file, for `check_tables`."""
    if not isinstance(content, (bytes, bytearray, memoryview)):
        got = _checks.short_repr(content)
        raise TypeError(f"content must be bytes, a bytearray or a memoryview; got {got}")
    _checks.instance("name", name, str)
    content = bytes(content)
    if len(content) > MAX_BYTES:
        raise ValueError(f"{name} must be a TOML file of at most {MAX_BYTES:,} bytes; it has more")
    if max(line.count(b".") for line in content.split(b"\n")) > MAX_POINTS:
        raise ValueError(f"{name} must be a TOML file with at most {MAX_POINTS} dots per line")
    try:
        # A byte order mark is accepted, because editors on Windows write one.
        return tomllib.loads(content.decode("utf-8-sig").replace("\r\n", "\n"))
    except (UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise ValueError(f"{name} is not valid TOML: {error}") from error
    except RecursionError:
        raise ValueError(f"{name} must be a TOML file; it is nested too deeply") from None
    except ValueError:  # more digits than Python reads
        raise ValueError(f"{name} must be a TOML file; a number is too long") from None


def error_context(number: int, table: Any, what: str = "group") -> AbstractContextManager[None]:
    """Begin errors with the number and name of the group, or of the topic, that they concern."""
    label = table.get("name") or table.get("topic") if isinstance(table, dict) else None
    name = f" ({label})" if label else ""
    return _checks.prefix_errors(f"{what} {number}{_checks.shorten_name(name)}")


def check_tables(tables: dict[str, Any]) -> None:
    """Raise an error unless keys and types are those of a fleet file; remove ``security``."""
    _names.check_keys(tables, _TOP_KEYS, "groups", _KEY_PLACES)
    if tables.pop("security", False) is not False:
        raise ValueError(f"security must be false, as {' '.join(security_warning())[:-1]}")
    groups = tables.get("groups")
    if not isinstance(groups, list) or not groups:
        raise ValueError(
            f"it must have at least one [[groups]] table; got {_checks.short_repr(groups)}"
            f"{'. Write [[groups]] in two brackets' * isinstance(groups, dict)}"
        )
    for key, most in {"matching": 1, "within": _checks.MAX_COUNT, "domain": MAX_DOMAIN}.items():
        _check_number(tables, key, 0, most)
    addresses = tables.get("addresses", {})
    if not isinstance(addresses, dict):
        raise TypeError(f"addresses must be a table; got {_checks.short_repr(addresses)}")
    for name, address in addresses.items():
        if not _is_address(address):
            rule = "an IP address, with four numbers of at most 255, or a host name"
            name = _checks.shorten_name(name)
            raise ValueError(f"addresses.{name} must be {rule}; got {_checks.short_repr(address)}")
    for number, table in enumerate(groups, start=1):
        with error_context(number, table):
            _check_group(table)
    _check_cells(tables)


def _is_address(address: Any) -> bool:
    """Return whether a text is an IP address, or a host name that does not resemble one."""
    with suppress(ValueError):
        return bool(ipaddress.ip_address(str(address)))
    name = r"(?=.*[^\d.])(?!-)[\w-]+(\.[\w-]+)*"
    return isinstance(address, str) and bool(re.fullmatch(name, address, re.ASCII))


def _check_cells(tables: dict[str, Any]) -> None:
    cells = tables.get("cells", [])
    if not isinstance(cells, list) or ("cells" in tables and not cells):
        raise TypeError(f"cells must be tables [[cells]]; got {_checks.short_repr(cells)}")
    for number, table in enumerate(cells, start=1):
        with error_context(number, table, "cell"):
            _names.check_keys(table, ("name", "wifi", "channel"), "name and wifi", _KEY_PLACES)
            for key in ("name", "wifi"):
                if not isinstance(table.get(key), str):
                    got = _checks.short_repr(table.get(key))
                    raise TypeError(f"{key} must be a text; got {got}")


def security_warning() -> tuple[str, str]:
    """Say that DDS Security is not counted, then how much airtime it added where we measured."""
    times: dict[str, list[float]] = {}
    for row in read_data("measured/security.csv"):
        times.setdefault(row["product"], []).append(float(row["times"]))
    ranges = [f"{min(t):.1f} to {max(t):.1f} with {name}" for name, t in times.items()]
    targets = [f"{60 // max(t):.0f} with {name}" for name, t in times.items()]
    return "DDS Security (SROS2) is not counted.", (
        "In startups that we captured, it multiplied airtime "
        f"by {wording.join_words(ranges)}. Keep it on your robots, but plan without it, and with "
        f"a shorter target: in place of 60 s, within = {wording.join_words(targets, 'or')}."
    )


def _check_group(table: Any) -> None:
    _names.check_keys(table, _GROUP_KEYS, ", ".join(COUNTS), _KEY_PLACES)
    sizes = table.get("processes")
    are_tables = isinstance(sizes, list) and all(isinstance(size, dict) for size in sizes)
    given_by = "robot" if "robot" in table else "processes" if are_tables and sizes else ""
    implied = {"robot": ("processes", "endpoints"), "processes": ("endpoints",)}.get(given_by, ())
    for key in implied:
        if key in table:
            got = _checks.short_repr(table[key])
            raise ValueError(f"{key} must be left out, as {given_by} sets it; got {got}")
    if given_by == "processes":
        _check_process_sizes(sizes)
    counted = MIN_COUNTS.keys() - {given_by, *implied}
    _check_counts(table, {key: MIN_COUNTS[key] for key in COUNTS if key in counted})
    for key in ("nodes", "shared", "own_types"):
        _check_number(table, key, 0)
    for key, kind, what in (
        ("wired", bool, "true or false"),
        ("data", list, "tables [[groups.data]]"),
        ("robot", str, "the name of a ready-made robot"),
        ("cell", str, "the name of a cell"),
    ):
        if not isinstance(table.get(key, kind()), kind):
            raise TypeError(f"{key} must be {what}; got {_checks.short_repr(table[key])}")


def _check_process_sizes(sizes: Any) -> None:
    """Check the tables ``[[groups.processes]]`` of a group."""
    least = {"count": 1, "endpoints": 0}
    for number, size in enumerate(sizes, start=1):
        with error_context(number, size, "processes"):
            _names.check_keys(size, least, "count and endpoints", _KEY_PLACES)
            _check_counts(size, least)
            for key, minimum in least.items():
                _checks.integer(key, size[key], minimum, _checks.MAX_COUNT)


def _check_counts(table: dict[str, Any], min_counts: dict[str, int]) -> None:
    for key, minimum in min_counts.items():
        if key not in table:
            allowed = _checks.describe_range(minimum, _checks.MAX_COUNT)
            raise ValueError(f"{key} is missing; it must be {allowed}")
        _check_number(table, key, minimum)


def _check_number(
    table: dict[str, Any], key: str, minimum: float, maximum: float = _checks.MAX_COUNT
) -> None:
    if type(table.get(key, 0)) not in (int, float):
        allowed = _checks.describe_range(minimum, maximum)
        raise TypeError(f"{key} must be {allowed}; got {_checks.short_repr(table[key])}")
