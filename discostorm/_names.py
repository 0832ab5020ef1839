"""Names as people write them, whatever their case, hyphens and spaces; the nearest one known."""

from collections.abc import Iterable, Mapping
from difflib import get_close_matches


def key(name: str) -> str:
    """Return a name without what people write differently: case, hyphens, spaces, commas.

    Examples
    --------
    >>> key("Fast-DDS") == key("fastdds") == key("FAST DDS")
    True
    """
    return "".join(filter(str.isalnum, name.casefold()))


def meant(name: str, names: Iterable[str], aliases: Mapping[str, str]) -> str | None:
    """Return the name that is meant, by itself or by an alias of it; None if none is.

    Examples
    --------
    >>> meant("fast-dds", ["Fast DDS"], {}), meant("rtps", ["Fast DDS"], {"RTPS": "Fast DDS"})
    ('Fast DDS', 'Fast DDS')
    """
    by_key = {key(one): full for one, full in aliases.items()}
    return (by_key | {key(one): one for one in names}).get(key(name))


def nearest(name: str, known: Iterable[str]) -> str | None:
    """Return the known name that begins with this one or looks most like it; None if none does.

    Examples
    --------
    >>> nearest("fastdss", ["Fast DDS", "Cyclone DDS"]), nearest("mqtt", ["Fast DDS"])
    ('Fast DDS', None)
    """
    by_key = {key(one): one for one in known}
    begun = sorted((one for one in by_key if key(name) and one.startswith(key(name))), key=len)
    found = begun or get_close_matches(key(name), by_key, n=1)
    return by_key[found[0]] if found else None


def did_you_mean(name: str, known: Iterable[str]) -> str:
    """Return the end of a message: the nearest known name, or nothing."""
    found = nearest(name, known)
    return "" if found is None else f". Did you mean {found!r}?"
