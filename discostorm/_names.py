"""Names as people write them, whatever their case, hyphens and spaces; the nearest valid name."""

from collections.abc import Iterable, Iterator, Mapping
from difflib import get_close_matches
from typing import Any, TypeVar

Item = TypeVar("Item")


def normalize(name: str) -> str:
    """Return a name's letters and digits in lower case, the same for each spelling."""
    return "".join(filter(str.isalnum, name.casefold()))


def nearest_name(name: str, valid: Iterable[str]) -> str | None:
    """Return the valid name that begins with this name or is most similar; None if none is near."""
    by_key = {normalize(full): full for full in valid}
    wanted = normalize(name)
    longer = sorted((k for k in by_key if wanted and k.startswith(wanted)), key=len)
    matches = longer or get_close_matches(wanted, by_key, n=1)
    return by_key[matches[0]] if matches else None


def did_you_mean(name: str, valid: Iterable[str]) -> str:
    """Return the end of a message: the nearest valid name, or nothing."""
    match = nearest_name(name, valid)
    return "" if match is None else f". Did you mean {match!r}?"


def check_keys(
    table: Any, valid: Iterable[str], needed: str, places: Mapping[str, str] | None = None
) -> None:
    """Raise a ValueError for an invalid key; name the nearest key, or where the key belongs."""
    from discostorm import _checks  # here, as it loads NumPy

    if not isinstance(table, dict):
        raise TypeError(f"it must be a table with {needed}; got {_checks.short_repr(table)}")
    for name in (name for name in table if name not in valid):
        place = (places or {}).get(name)
        keys = ", ".join(valid) if len([*valid]) < 8 else "in `discostorm plan --help`"
        near = did_you_mean(name, valid) or f". Valid keys are {keys}"
        like = f". Write {name} {place}" if place else near
        got = f"{_checks.shorten_name(name)} = {_checks.short_repr(table[name])}"
        raise ValueError(f"unknown key {got}{like}")


class UnknownNameError(KeyError, ValueError):
    """A `Catalog` lacks this name; the message lists all names, and the nearest one last."""

    def __str__(self) -> str:
        from discostorm import _checks  # here, as it loads NumPy

        what, name, names, aliases = self.args
        words = [*map(repr, names)]
        return (
            f"{what} must be {', '.join(words[:-1])} or {words[-1]}; got "
            f"{_checks.shorten_name(str(name))!r}{did_you_mean(str(name), (*names, *aliases))}"
        )


class Catalog(Mapping[str, Item]):
    """Read-only items by name; the error of an unknown name suggests the nearest."""

    def __init__(
        self, what: str, items: Mapping[str, Item], aliases: Mapping[str, str] | None = None
    ) -> None:
        self._what, self._items, self._aliases = what, dict(items), dict(aliases or {})

    def __getitem__(self, name: str) -> Item:
        if name not in self._items:
            raise self._unknown(name)
        return self._items[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._items)

    def __len__(self) -> int:
        return len(self._items)

    def __repr__(self) -> str:
        return f"<{len(self)} by name: {', '.join(map(repr, [*self][:4]))}, ...>"

    def find(self, name: str) -> Item:
        """Return the item of a name or alias, in any case, with any hyphens and spaces."""
        if not isinstance(name, str):
            raise TypeError(f"{self._what} must be a str; got {name!r}")
        spelled = {normalize(alias): full for alias, full in self._aliases.items()}
        full_name = (spelled | {normalize(full): full for full in self._items}).get(normalize(name))
        if full_name is None:
            raise self._unknown(name)
        return self._items[full_name]

    def _unknown(self, name: str) -> UnknownNameError:
        return UnknownNameError(self._what, name, tuple(self._items), tuple(self._aliases))
