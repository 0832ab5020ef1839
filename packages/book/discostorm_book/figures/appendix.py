"""Figures of the appendix: what a frame costs, and how sure the numbers are."""

from collections.abc import Sequence

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from discostorm import lambdify, uncertainty
from discostorm.figures import WIDTH, color_of, headline, style
from discostorm.messages import Protocol
from discostorm.notation import payload_symbol
from discostorm.saturation import saturation_hosts
from discostorm.wifi import PAPER, Wifi, uplink_airtime

#: What all parameters at their best or worst ends are called.
TOGETHER = "all together"
_KINDS = {"O": "overhead", "R": "rate", "H": "headers", "s": "payload"}
_LINKS = {"uni": "unicast", "multi": "multicast"}


def parameter_name(symbol: str) -> str:
    """Return what a parameter is called, as "unicast overhead" for ``O_uni``.

    Examples
    --------
    >>> parameter_name("O_uni"), parameter_name("s_SEDP")
    ('unicast overhead', 'SEDP payload')
    """
    kind, _, of = symbol.partition("_")
    return f"{_LINKS.get(of, of)} {_KINDS[kind]}"


def tornado_data(protocols: Sequence[Protocol], processes: int, endpoints: int) -> pd.DataFrame:
    """Return the saturation points at both ends of each parameter's range, and of all together."""
    tables = []
    for protocol in protocols:
        ends = uncertainty.sensitivity(protocol, processes, endpoints)
        low, high = uncertainty.saturation_bounds(protocol, processes, endpoints)
        at = np.sort(ends[["hosts_at_low", "hosts_at_high"]].to_numpy(), axis=1)
        tables.append(
            pd.DataFrame(
                {
                    "protocol": protocol.name,
                    "parameter": [TOGETHER, *map(parameter_name, ends.index)],
                    "fewest_hosts": [low, *at[:, 0]],
                    "paper_hosts": saturation_hosts(protocol, processes, endpoints),
                    "most_hosts": [high, *at[:, 1]],
                }
            )
        )
    return pd.concat(tables)


def tornado(
    protocols: Sequence[Protocol], processes: int, endpoints: int, shown: int = 5
) -> Figure:
    """Draw how far each parameter alone moves the saturation point: a panel a protocol.

    Parameters
    ----------
    protocols : sequence of Protocol
        The paper's.
    processes, endpoints : int
        Of each host, of each process.
    shown : int
        So many parameters, those that move it most.
    """
    data = tornado_data(protocols, processes, endpoints)
    with style():
        figure = Figure(figsize=(WIDTH, 0.6 + 1.5 * len(protocols)))
        panels = figure.subplots(len(protocols), 1, sharex=True)
        for axis, protocol in zip(np.atleast_1d(panels), protocols, strict=True):
            rows = data[data["protocol"] == protocol.name].head(shown + 1)
            _bars(axis, rows, color_of(protocol))
            paper = rows["paper_hosts"].iloc[0]
            axis.set_title(f"{protocol.name}: {paper:.2f} robots by the paper's values", loc="left")
        axis.set_xlabel("robots at which the channel is full")
        axis.set_xlim(data["fewest_hosts"].min() - 0.6, data["most_hosts"].max() + 0.6)
        headline(figure, "One constant moves the result by two robots")
    return figure


def _bars(axis: Axes, rows: pd.DataFrame, color: str) -> None:
    """Draw a bar a row from the fewest to the most hosts, with both numbers at its ends."""
    places = np.arange(len(rows))[::-1]
    names = [str(name) for name in rows["parameter"]]
    spans = rows[["fewest_hosts", "most_hosts"]].to_numpy(dtype=float)
    for place, name, (fewest, most) in zip(places, names, spans, strict=True):
        axis.plot(
            [fewest, most],
            [place, place],
            color="0.35" if name == TOGETHER else color,
            linewidth=7,
            solid_capstyle="butt",
        )
        for end, align, gap in ((fewest, "right", -0.06), (most, "left", 0.06)):
            axis.text(end + gap, place, f"{end:.2f}", ha=align, va="center", fontsize=9)
    axis.axvline(rows["paper_hosts"].iloc[0], color="black", linewidth=1, zorder=3)
    axis.set_yticks(places, names)
    axis.set_ylim(-0.6, len(rows) - 0.4)
    axis.grid(axis="y", visible=False)
    axis.tick_params(axis="y", length=0)


def frame_steps_data(protocols: Sequence[Protocol], wifi: Wifi) -> pd.DataFrame:
    """Return the airtime [µs] of unicast frames by the paper's line and by the standard's steps.

    Rows without a message are the curves, those with one the frames of the protocols.
    """
    frames = [
        (message.name, message.frame_bytes) for each in protocols for message in each.messages
    ]
    lengths = np.arange(40, 521)
    names = [*[""] * len(lengths), *[name for name, _ in frames]]
    octets = np.array([*lengths, *[int(size) for _, size in frames]])
    return pd.DataFrame(
        {
            "message": names,
            "frame_B": octets,
            "paper_us": _airtime_us(octets, PAPER),
            "standard_us": _airtime_us(octets, wifi),
        }
    )


def _airtime_us(octets: NDArray[np.int_], wifi: Wifi) -> NDArray[np.float64]:
    size = payload_symbol("frame")
    values = wifi.values()
    airtime = lambdify([size, *values], uplink_airtime(size, wifi.model))
    return np.asarray(1e6 * airtime(octets, *values.values()), dtype=float)


def frame_steps(protocols: Sequence[Protocol], wifi: Wifi) -> Figure:
    """Draw the airtime of a unicast frame against its length, with the frames of the protocols."""
    data = frame_steps_data(protocols, wifi)
    curves, dots = data[data["message"] == ""], data[data["message"] != ""]
    with style():
        figure = Figure(figsize=(WIDTH, 3.1))
        axis = figure.subplots()
        end = curves.iloc[-1]
        axis.plot(curves["frame_B"], curves["paper_us"], "--", color="0.45")
        axis.plot(curves["frame_B"], curves["standard_us"], color="black", drawstyle="steps-post")
        axis.text(528, end["paper_us"], "paper", va="center", fontsize=9)
        axis.text(528, end["standard_us"], "standard", va="center", fontsize=9)
        for protocol in protocols:
            own = dots[dots["message"].isin([message.name for message in protocol.messages])]
            axis.plot(
                own["frame_B"],
                own["standard_us"],
                "o",
                color=color_of(protocol),
                markeredgecolor="black",
                label=f"frames of {protocol.name}",
                zorder=3,
            )
        for _, own in dots.groupby("standard_us"):
            names, last = ", ".join(own["message"]), float(own["frame_B"].max())
            height = float(own["standard_us"].iloc[0])
            if len(own) > 2:  # too long to stand above its step
                look = {"arrowstyle": "-", "color": "0.45"}
                axis.annotate(names, (last, height), (135, 185), fontsize=9, arrowprops=look)
            else:
                axis.text(last + 14, height + 1, names, ha="right", fontsize=9)
        axis.set(xlim=(40, 640), ylim=(180, 225))
        axis.set_xlabel("frame length [B]")
        axis.set_ylabel("airtime of a unicast frame [µs]")
        headline(figure, "Whole symbols cost more than the paper's line")
        axis.legend(loc="upper left")
    return figure
