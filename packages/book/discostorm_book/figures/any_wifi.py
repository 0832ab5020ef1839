"""Figures of the chapter on radios other than the paper's."""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from discostorm import notation as nt
from discostorm._numeric import lambdify
from discostorm.figures import COLORS, PAPER_PROTOCOLS
from discostorm.saturation import saturation, saturation_hosts
from discostorm.wifi import PAPER, Radio, Wifi
from discostorm_book.figures.drawing import Style, book_figure, set_ticks, write_text

_SMALL_ROBOT = (2, 10)  # processes, and endpoints of each
#: Radios, how many rates each has, and their mark.
_RADIOS: dict[str, tuple[Radio, int, str]] = {
    "802.11a": (Radio("802.11a"), 8, "o"),
    "802.11n, 20 MHz": (Radio("802.11n", streams=2), 8, "s"),
    "802.11ac, 80 MHz": (Radio("802.11ac", streams=2, width=80e6), 10, "^"),
    "802.11ax, 80 MHz": (Radio("802.11ax", streams=2, width=80e6), 12, "D"),
}
#: Format of each radio's line with aggregation, and vertical alignment of its name.
_AGGREGATED = {
    "802.11n, 20 MHz": ("-o", "center"),
    "802.11ac, 80 MHz": ("--s", "top"),
    "802.11ax, 80 MHz": (":D", "bottom"),
}
_FRAMES_PER_AMPDU = (1, 2, 4, 8, 16, 32, 64)


def _hosts_at_limit(channel: Wifi) -> dict[str, float]:
    """Return the saturation point of each protocol of the paper."""
    return {
        f"{protocol.name}_hosts": float(saturation_hosts(protocol, *_SMALL_ROBOT, channel))
        for protocol in PAPER_PROTOCOLS
    }


def _protocol_panels(figure: Figure) -> Iterator[tuple[Axes, str]]:
    """Yield one panel per protocol, and the protocol's name."""
    axes = figure.subplots(1, 2, sharey=True)
    axes[0].set_ylabel("robots that fill a second")
    for axis, protocol in zip(axes, PAPER_PROTOCOLS, strict=True):
        axis.set_title(protocol.name)
        yield axis, protocol.name


def saturation_by_rate_data(bounds: dict[str, float]) -> pd.DataFrame:
    """Return saturation points by unicast rate: of radios, of the paper's model, and its limit."""
    rates = np.geomspace(5, 5000, 120)
    line = pd.DataFrame({"series": "paper model", "rate_Mbit_s": rates})
    for protocol in PAPER_PROTOCOLS:
        given = {nt.N_P: _SMALL_ROBOT[0], nt.N_E: _SMALL_ROBOT[1], nt.U_LIMIT: 1}
        given |= protocol.values() | PAPER.values() | {nt.R_UNI: rates * 1e6}
        line[f"{protocol.name}_hosts"] = lambdify([*given], saturation(protocol))(*given.values())
    points = pd.DataFrame(
        {"series": name, "rate_Mbit_s": channel.unicast.rate / 1e6} | _hosts_at_limit(channel)
        for name, (radio, count, _) in _RADIOS.items()
        for channel in (replace(radio, mcs=mcs).wifi() for mcs in range(count))
    )
    limit = {"series": "limit", "rate_Mbit_s": np.inf}
    limit |= {f"{name}_hosts": value for name, value in bounds.items()}
    return pd.concat([points, line, pd.DataFrame([limit])])


def saturation_by_rate(bounds: dict[str, float]) -> Figure:
    """Draw saturation points against the unicast rate, with the limit for an infinite rate."""
    data = saturation_by_rate_data(bounds)
    with book_figure(3.1, "Above 100 Mbit/s a faster rate gains less than one robot") as figure:
        for axis, protocol in _protocol_panels(figure):
            column, color, limit = (f"{protocol}_hosts", COLORS[protocol], bounds[protocol])
            line = data[data["series"] == "paper model"]
            axis.plot(line["rate_Mbit_s"], line[column], color=color)
            axis.text(6, line[column].iloc[0] - 0.6, "paper model", color=color, fontsize=8)
            axis.axhline(limit, color="black", linestyle=":", linewidth=1)
            write_text(axis, f"infinite rate: {limit:.2f}", (5, limit), (0, 3), fontsize=8)
            for name, (_, _, mark) in _RADIOS.items():
                rows = data[data["series"] == name]
                look: Style = {"color": "0.35", "ms": 5, "mfc": "none", "label": name}
                axis.plot(rows["rate_Mbit_s"], rows[column], mark, **look)
            axis.set(xscale="log", ylim=(0, 9), xlabel="unicast rate [Mbit/s]")
            axis.set_xticks([10, 100, 1000], ["10", "100", "1,000"])
        figure.axes[0].legend(loc="lower right", fontsize=8)
    return figure


def saturation_by_aggregation_data() -> pd.DataFrame:
    """Return saturation points by the number of frames in each A-MPDU."""
    return pd.DataFrame(
        {"radio": name, "frames": frames}
        | _hosts_at_limit(replace(_RADIOS[name][0], mpdus=frames).wifi())
        for name in _AGGREGATED
        for frames in _FRAMES_PER_AMPDU
    )


def saturation_by_aggregation() -> Figure:
    """Draw saturation points against the number of frames in each A-MPDU, all of them full."""
    data = saturation_by_aggregation_data()
    with book_figure(3.1, "A faster radio pays off only if frames share the overhead") as figure:
        for axis, protocol in _protocol_panels(figure):
            for name, (look, side) in _AGGREGATED.items():
                rows = data[data["radio"] == name]
                hosts = rows[f"{protocol}_hosts"]
                axis.plot(rows["frames"], hosts, look, color=COLORS[protocol], ms=4)
                end = hosts.iloc[-1]
                axis.text(76, end, f"{name.split(',')[0]}: {end:.0f}", fontsize=8, va=side)
            axis.set_xscale("log", base=2)
            set_ticks(axis.xaxis, _FRAMES_PER_AMPDU)
            axis.set(xlim=(0.9, 520), ylim=(0, 50), xlabel="frames per A-MPDU")
    return figure
