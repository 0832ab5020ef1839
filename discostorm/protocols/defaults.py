"""The middlewares' default periods, leases, counts and sizes."""

from discostorm.data import read_data


def defaults(product: str) -> dict[str, float]:
    """Return a product's default periods, leases, counts and sizes by the name of the quantity.

    Parameters
    ----------
    product : str
        "Fast DDS", "Cyclone DDS" or "Zenoh".

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
    rows = read_data("vendors/middleware_defaults.csv")
    known = dict.fromkeys(row["product"] for row in rows)
    if product not in known:
        names = " or ".join(repr(name) for name in known)
        raise ValueError(f"product must be {names}; got {product!r}")
    return {row["quantity"]: float(row["value"]) for row in rows if row["product"] == product}
