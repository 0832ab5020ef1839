"""Figures of the appendix: the airtime of a frame, and the uncertainty of the results."""

from collections.abc import Sequence
from textwrap import wrap

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from discostorm import lambdify, uncertainty
from discostorm.figures import color_of
from discostorm.messages import Protocol
from discostorm.notation import payload_symbol
from discostorm.saturation import saturation_hosts
from discostorm.wifi import PAPER, Wifi, uplink_airtime
from discostorm_book.figures.drawing import Style, book_figure, name_rows_without_ticks, write_text

#: The row with all parameters at their best or worst ends, and the number of rows of a panel.
_TOGETHER, _ROWS = "all together", 6
_QUANTITIES = {"O": "overhead", "R": "rate", "H": "headers", "s": "payload"}
_LINKS = {"uni": "unicast", "multi": "multicast"}


def _parameter_name(symbol: str) -> str:
    """Return the name of a parameter, such as "unicast overhead" for ``O_uni``."""
    kind, _, of = symbol.partition("_")
    return f"{_LINKS.get(of, of)} {_QUANTITIES[kind]}"


def tornado_data(protocols: Sequence[Protocol], processes: int, endpoints: int) -> pd.DataFrame:
    """Return the saturation points at both ends of each range, and for all ranges together."""
    tables = []
    for protocol in protocols:
        ends = uncertainty.sensitivity(protocol, processes, endpoints)
        low, high = uncertainty.saturation_bounds(protocol, processes, endpoints)
        hosts = np.sort(ends[["hosts_at_low", "hosts_at_high"]].to_numpy(), axis=1)
        names = [_TOGETHER, *map(_parameter_name, ends.index)]
        table = pd.DataFrame({"protocol": protocol.name, "parameter": names})
        table["fewest_hosts"] = [low, *hosts[:, 0]]
        table["paper_hosts"] = saturation_hosts(protocol, processes, endpoints)
        table["most_hosts"] = [high, *hosts[:, 1]]
        tables.append(table)
    return pd.concat(tables)


def tornado(protocols: Sequence[Protocol], processes: int, endpoints: int) -> Figure:
    """Draw how far the parameters that matter most move the saturation point, by protocol."""
    data = tornado_data(protocols, processes, endpoints)
    height = 0.6 + 1.5 * len(protocols)
    with book_figure(height, "One constant moves the result by two robots") as figure:
        panels = figure.subplots(len(protocols), 1, sharex=True)
        for axis, protocol in zip(np.atleast_1d(panels), protocols, strict=True):
            rows = data[data["protocol"] == protocol.name].head(_ROWS)
            _draw_range_bars(axis, rows, color_of(protocol))
            paper = rows["paper_hosts"].iloc[0]
            axis.set_title(f"{protocol.name}: {paper:.2f} robots by the paper's values", loc="left")
        axis.set_xlabel("robots at which the channel is full")
        axis.set_xlim(data["fewest_hosts"].min() - 0.6, data["most_hosts"].max() + 0.6)
    return figure


def _draw_range_bars(axis: Axes, rows: pd.DataFrame, color: str) -> None:
    """Draw one bar per row from the fewest to the most hosts, with both numbers at its ends."""
    ys = range(len(rows) - 1, -1, -1)
    for y, row in zip(ys, rows.to_dict("records"), strict=True):
        ends = row["fewest_hosts"], row["most_hosts"]
        shade = "0.35" if row["parameter"] == _TOGETHER else color
        axis.plot(ends, [y, y], color=shade, linewidth=7, solid_capstyle="butt")
        for end, side, across in zip(ends, ("right", "left"), (-5, 5), strict=True):
            write_text(axis, f"{end:.2f}", (end, y), (across, 0), ha=side, va="center")
    axis.axvline(rows["paper_hosts"].iloc[0], color="black", linewidth=1, zorder=3)
    axis.set_ylim(-0.6, len(rows) - 0.4)
    name_rows_without_ticks(axis, ys, rows["parameter"])


def airtime_by_length_data(protocols: Sequence[Protocol], wifi: Wifi) -> pd.DataFrame:
    """Return the airtime of unicast frames [µs]: curves by length, and the frames of protocols."""
    messages = [message for protocol in protocols for message in protocol.messages]
    lengths = np.arange(40, 521)
    octets = np.array([*lengths, *(int(message.frame_bytes) for message in messages)])
    names = [*[""] * len(lengths), *(message.name for message in messages)]
    airtime = {"paper_us": _airtime_us(octets, PAPER), "standard_us": _airtime_us(octets, wifi)}
    return pd.DataFrame({"message": names, "frame_B": octets} | airtime)


def _airtime_us(octets: NDArray[np.int_], wifi: Wifi) -> NDArray[np.float64]:
    size, values = payload_symbol("frame"), wifi.values()
    airtime = lambdify([size, *values], uplink_airtime(size, wifi.model))
    return np.asarray(1e6 * airtime(octets, *values.values()), dtype=float)


def airtime_by_length(protocols: Sequence[Protocol], wifi: Wifi) -> Figure:
    """Draw the airtime of a unicast frame against its length, with the frames of the protocols."""
    data = airtime_by_length_data(protocols, wifi)
    curves, dots = data[data["message"] == ""], data[data["message"] != ""]
    looks: dict[str, Style] = {
        "paper": {"linestyle": "--", "color": "0.45"},
        "standard": {"color": "black", "drawstyle": "steps-post"},
    }
    with book_figure(3.1, "Whole symbols cost more than the paper's line") as figure:
        axis = figure.subplots()
        for name, look in looks.items():
            axis.plot(curves["frame_B"], curves[f"{name}_us"], **look)
            axis.text(528, curves[f"{name}_us"].iloc[-1], name, va="center", fontsize=9)
        for protocol in protocols:
            own = dots[dots["message"].isin([message.name for message in protocol.messages])]
            look = {"color": color_of(protocol), "markeredgecolor": "black", "zorder": 3}
            label = f"frames of {protocol.name}"
            axis.plot(own["frame_B"], own["standard_us"], "o", label=label, **look)
        for _, own in dots.groupby("standard_us"):
            height = float(own["standard_us"].iloc[0])
            names, last = ", ".join(own["message"]), float(own["frame_B"].max())
            if len(own) > 2:  # too long to stand on its step: its line passes the next one's names
                look = {"arrowstyle": "-", "color": "0.45", "relpos": (0.1, 0)}
                lines, at = "\n".join(wrap(names, 20)), (own["frame_B"].min(), height)
                axis.annotate(lines, at, (44, height + 12), fontsize=9, arrowprops=look)
            else:
                write_text(axis, names.replace(" ", "\n"), (last + 11, height), (0, 6), ha="right")
        axis.set(xlim=(40, 640), ylim=(180, 225))
        axis.set(xlabel="frame length [B]", ylabel="airtime of a unicast frame [µs]")
        axis.legend(loc="upper left")
    return figure
