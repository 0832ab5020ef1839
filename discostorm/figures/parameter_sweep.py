"""A quantity over named axes: a table with a row for each combination, and its figure."""

from collections.abc import Callable, Iterable, Mapping
from itertools import product
from typing import Any

import pandas as pd
from matplotlib.figure import Figure
from pandas.api.types import is_numeric_dtype

from discostorm.figures.style import COLORS, WIDTH, style
from discostorm.model import utilization
from discostorm.wifi import Radio


class Sweep(pd.DataFrame):
    """A row for each combination of the axes' values; the last column is the quantity."""

    @property
    def _constructor(self) -> type["Sweep"]:
        return Sweep

    def plot(self, x: str | None = None) -> Figure:  # type: ignore[override]
        """Draw the quantity against an axis, by default the first one with several numbers."""
        *axes, quantity = map(str, self.columns)
        varied = [axis for axis in axes if len(self[axis].unique()) > 1]
        numbers = [axis for axis in varied if is_numeric_dtype(self[axis])]
        x = x or (numbers or varied or axes)[0]
        others = [axis for axis in varied if axis != x]
        curves = self.groupby(others, sort=False, dropna=False) if others else [((), self)]
        with style():
            figure = Figure(figsize=(WIDTH, 3.5))
            panel = figure.subplots(subplot_kw={"xlabel": x, "ylabel": quantity})
            for values, rows in curves:
                color = COLORS.get(str(values[0])) if others == ["protocol"] else None
                panel.plot(rows[x], rows[quantity], label=", ".join(map(str, values)), color=color)
            if others:
                panel.legend(title=", ".join(others))
        return figure


def sweep(quantity: Callable[..., Any] = utilization, /, **axes: Any) -> Sweep:
    """Return a quantity for each combination of the values of named axes.

    Parameters
    ----------
    quantity : function, optional
        What to compute, such as `saturation_hosts`; `utilization` if left out.
    **axes : values
        Arguments of the function by name: one value, several, or a mapping from labels to values.

    Returns
    -------
    Sweep
        A `pandas.DataFrame` of all axes, and last the quantity, which its `plot` draws.

    Examples
    --------
    >>> import discostorm as ds
    >>> table = ds.sweep(protocol=["dds", "zenoh"], hosts=[7, 8], processes=2, endpoints=10)
    >>> table["utilization"].round(2).tolist()
    [0.95, 1.27, 0.83, 1.11]
    >>> figure = table.plot()
    """
    rows = []
    for point in product(*map(_labeled, axes.values())):
        labels, values = zip(*point, strict=True)
        rows.append([*labels, quantity(**dict(zip(axes, values, strict=True)))])
    return Sweep(rows, columns=[*axes, quantity.__name__])


def _labeled(values: Any) -> list[tuple[Any, Any]]:
    """Return the values of an axis, each with its label: a key, a name, or the value itself."""
    if isinstance(values, Mapping):
        return list(values.items())
    listed = values if isinstance(values, Iterable) and not isinstance(values, str) else [values]
    channels = (value.wifi() if isinstance(value, Radio) else value for value in listed)
    return [(getattr(value, "name", value), value) for value in channels]
