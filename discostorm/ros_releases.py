"""The table of the middleware that each ROS 2 distribution ships, by ``vendors/ros.csv``."""

from discostorm import _names
from discostorm.data import read_data


def distributions() -> tuple[str, ...]:
    """Return the names of the measured ROS 2 distributions, the oldest first."""
    return tuple(dict.fromkeys(row["ros"] for row in read_data("vendors/ros.csv")))


def newest_long_term() -> str:
    """Return the newest measured ROS 2 distribution with long-term support."""
    return [row["ros"] for row in read_data("vendors/ros.csv") if row["long_term"] == "yes"][-1]


def distribution_name(name: str) -> str:
    """Return the ROS 2 distribution of a name in any spelling; raise a ValueError if unknown."""
    names = distributions()
    aliases = {f"ros2{each}": each for each in names}
    return _names.Catalog("ros", {each: each for each in names}, aliases).find(name)


def shipped_table(name: str, ros: str | None = None) -> str:
    """Return the name of the table of the release that a distribution ships (default: newest LTS).

    A product or a configuration is valid for every distribution; a ValueError says that a table is
    of a release that the given distribution does not ship.
    """
    given = ros is not None
    ros = newest_long_term() if ros is None else distribution_name(ros)
    rows = read_data("vendors/ros.csv")
    shipped = {row["product"]: row["protocol"] for row in rows if row["ros"] == ros}
    of_product = {row["protocol"]: row["product"] for row in rows}
    if name in shipped or name in shipped.values():
        return shipped.get(name, name)
    if given and name in of_product:
        such = f"ROS 2 {ros.capitalize()} ships, such as {shipped[of_product[name]]!r}"
        raise ValueError(f"protocol must be one that {such}; got {name!r}")
    return name


def forwarding_release(product: str, ros: str | None = None) -> str:
    """Return the release of a product if its servers forward everything, else an empty text."""
    wanted = (ros or newest_long_term(), product, "all")
    rows, keys = read_data("vendors/ros.csv"), ("ros", "product", "server_forwards")
    return next((row["protocol"] for row in rows if tuple(map(row.get, keys)) == wanted), "")


def nearest_release_note(table: str, ros: str) -> str:
    """Return a sentence where a distribution ships another release than a table is fitted to."""
    tables = read_data("vendors/products.csv") + read_data("vendors/releases.csv")
    fitted = {row["protocol"]: row["versions"] for row in tables}
    for row in read_data("vendors/ros.csv"):
        if (row["ros"], row["protocol"]) == (ros, table) and row["shipped"] != fitted[table]:
            return (
                f"ROS 2 {ros.capitalize()} ships {row['product']} {row['shipped']}. The nearest "
                f"release that our model is fitted to is {fitted[table]}."
            )
    return ""
