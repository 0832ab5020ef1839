"""The middlewares' default periods, leases, counts and sizes."""

from discostorm.data import read_data
from discostorm.messages import Timers


def products() -> list[str]:
    """Return the products whose defaults are known, in the order of the data file."""
    return list(
        dict.fromkeys(row["product"] for row in read_data("vendors/middleware_defaults.csv"))
    )


def defaults(product: str) -> dict[str, float]:
    """Return a product's default periods, leases, counts and sizes by the name of the quantity.

    Parameters
    ----------
    product : str
        "Fast DDS", "Cyclone DDS", "Zenoh" or "rmw_zenoh".

    Returns
    -------
    dict
        Values in seconds, bytes or 1; the data file ``vendors/middleware_defaults.csv`` tells the
        unit, meaning and source of each.

    Raises
    ------
    ValueError
        If there is no such product.

    Examples
    --------
    >>> defaults("Zenoh")["lease"]
    10.0
    """
    if product not in products():
        names = " or ".join(repr(name) for name in products())
        raise ValueError(f"product must be {names}; got {product!r}")
    rows = read_data("vendors/middleware_defaults.csv")
    return {row["quantity"]: float(row["value"]) for row in rows if row["product"] == product}


def timers(product: str) -> Timers:
    """Return when a product sends again what its table does not repeat; see `defaults`.

    Examples
    --------
    >>> timers("Fast DDS")
    Timers(announce_first=3.0, announce_most=3.0, heartbeat_first=1.0, heartbeat_most=1.0)
    """
    values = defaults(product)
    rows = read_data("vendors/middleware_defaults.csv")
    own = {row["quantity"]: row["timers"].split() for row in rows if row["product"] == product}
    return Timers(**{timer: values[name] for name, named in own.items() for timer in named})
