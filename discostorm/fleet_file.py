"""Fleet files: tables of groups in TOML, checked for keys and types."""

import tomllib
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from discostorm import _checks, _names

#: What each group counts, and the least that is allowed; the most is `_checks.MOST`.
LEAST = {"hosts": 1, "processes": 1, "endpoints": 0}
COUNTS = tuple(LEAST)


def fleet_tables(content: bytes | bytearray | memoryview, name: str) -> dict[str, Any]:
    """Return what the content of a fleet file holds: ``groups``, perhaps ``matching``.

    Raises
    ------
    ValueError
        If it is not TOML, a key is missing or unknown, or a value is of a wrong type.
    TypeError
        If the content is not made of bytes, or the name is not text.
    """
    if not isinstance(content, (bytes, bytearray, memoryview)):
        raise TypeError(
            f"content must be bytes, a bytearray or a memoryview; got {_checks.short(content)}"
        )
    _checks.instance("name", name, str)
    try:
        # With a byte order mark, too, as Windows' editors write it.
        tables = tomllib.loads(bytes(content).decode("utf-8-sig").replace("\r\n", "\n"))
    except (UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise ValueError(f"{name} must be a TOML file: {error}") from error
    except RecursionError:
        raise ValueError(f"{name} must be a TOML file; it is nested too deep to read") from None
    except ValueError:  # more digits than Python reads
        raise ValueError(f"{name} must be a TOML file of numbers with fewer digits") from None
    try:
        _check(tables)
    except (TypeError, ValueError) as error:
        raise ValueError(f"{name}: {error}") from error
    return tables


@contextmanager
def told_of(number: int, table: Any, what: str = "group") -> Iterator[None]:
    """Let errors say which group, or which of its data, they are about."""
    try:
        yield
    except (TypeError, ValueError) as error:
        told = table.get("name") or table.get("topic") if isinstance(table, dict) else None
        name = f" ({told})" if told else ""
        raise ValueError(f"{what} {number}{_checks.brief(name)}: {error}") from error


def _check(tables: dict[str, Any]) -> None:
    _only_keys(tables, ("groups", "matching"))
    groups = tables.get("groups")
    if not isinstance(groups, list) or not groups:
        raise ValueError(f"it must have at least one [[groups]] table; got {_checks.short(groups)}")
    _number(tables, "matching", _checks.wanted(0, 1))
    for number, table in enumerate(groups, start=1):
        with told_of(number, table):
            _check_group(table)


def _check_group(table: Any) -> None:
    if not isinstance(table, dict):
        raise TypeError(f"it must be a table with {', '.join(COUNTS)}; got {_checks.short(table)}")
    _only_keys(table, (*COUNTS, "name", "nodes", "shared", "wired", "data"))
    for key, least in LEAST.items():
        allowed = _checks.wanted(least, _checks.MOST)
        if key not in table:
            raise ValueError(f"{key} is missing; it must be {allowed}")
        _number(table, key, allowed)
    for key in ("nodes", "shared"):
        _number(table, key, _checks.wanted(0, _checks.MOST))
    if not isinstance(table.get("wired", False), bool):
        raise TypeError(f"wired must be true or false; got {_checks.short(table['wired'])}")
    if not isinstance(table.get("data", []), list):
        raise TypeError(f"data must be tables [[groups.data]]; got {_checks.short(table['data'])}")


def _number(table: dict[str, Any], key: str, allowed: str) -> None:
    if type(table.get(key, 0)) not in (int, float):
        raise TypeError(f"{key} must be {allowed}; got {_checks.short(table[key])}")


def _only_keys(table: dict[str, Any], known: tuple[str, ...]) -> None:
    for key, value in table.items():
        if key not in known:
            raise ValueError(
                f"key must be {' or '.join(known)}; got {_checks.brief(key)} = "
                f"{_checks.short(value)}{_names.did_you_mean(key, known)}"
            )
