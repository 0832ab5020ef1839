"""The middlewares' default periods, leases, counts and sizes."""

from discostorm import _checks
from discostorm.data import read_data
from discostorm.messages import Timers


def defaults(product: str) -> dict[str, float]:
    """Return a product's default periods, leases, counts and sizes by the name of the quantity.

    The product is "Fast DDS", "Cyclone DDS", "Zenoh" or "rmw_zenoh"; values are in seconds, bytes
    or 1. ``vendors/middleware_defaults.csv`` has the unit, meaning and source of each.
    """
    rows = read_data("vendors/middleware_defaults.csv")
    _checks.choice("product", product, list(dict.fromkeys(row["product"] for row in rows)))
    return {row["quantity"]: float(row["value"]) for row in rows if row["product"] == product}


def timers(product: str) -> Timers:
    """Return a product's timers for messages that its table does not repeat; see `defaults`."""
    values = defaults(product)
    rows = read_data("vendors/middleware_defaults.csv")
    own = {row["quantity"]: row["timers"].split() for row in rows if row["product"] == product}
    return Timers(**{timer: values[name] for name, named in own.items() for timer in named})
