"""Names as people write them, whatever their case, hyphens and spaces; the nearest valid name."""

from collections.abc import Iterable, Mapping
from difflib import get_close_matches


def key(name: str) -> str:
    """Return a name without what people write differently: case, hyphens, spaces, commas."""
    return "".join(filter(str.isalnum, name.casefold()))


def meant(name: str, names: Iterable[str], aliases: Mapping[str, str]) -> str | None:
    """Return the name that is meant, by itself or by an alias of it; None if none is."""
    by_key = {key(alias): full for alias, full in aliases.items()}
    return (by_key | {key(full): full for full in names}).get(key(name))


def nearest(name: str, valid: Iterable[str]) -> str | None:
    """Return the valid name that begins with this one or looks most like it; None if none does."""
    by_key = {key(full): full for full in valid}
    longer = sorted((k for k in by_key if key(name) and k.startswith(key(name))), key=len)
    matches = longer or get_close_matches(key(name), by_key, n=1)
    return by_key[matches[0]] if matches else None


def did_you_mean(name: str, valid: Iterable[str]) -> str:
    """Return the end of a message: the nearest valid name, or nothing."""
    match = nearest(name, valid)
    return "" if match is None else f". Did you mean {match!r}?"
