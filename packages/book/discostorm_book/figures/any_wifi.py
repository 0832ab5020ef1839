"""Figures of the chapter on radios other than the paper's."""

from typing import Any

import numpy as np
import pandas as pd
from matplotlib.figure import Figure

from discostorm import figures, notation as nt
from discostorm._numeric import lambdify
from discostorm.figures import COLORS, WIDTH, headline, style
from discostorm.messages import Protocol
from discostorm.saturation import saturation, saturation_hosts
from discostorm.wifi import PAPER, Radio, Wifi

_SMALL = (2, 10)  # processes, and endpoints of each
_FAMILIES: dict[str, tuple[dict[str, Any], int, str]] = {
    "802.11a": ({"standard": "802.11a"}, 8, "o"),
    "802.11n, 20 MHz": ({"standard": "802.11n", "streams": 2}, 8, "s"),
    "802.11ac, 80 MHz": ({"standard": "802.11ac", "streams": 2, "width": 80e6}, 10, "^"),
    "802.11ax, 80 MHz": ({"standard": "802.11ax", "streams": 2, "width": 80e6}, 12, "D"),
}
_RADIOS: dict[str, tuple[dict[str, Any], str]] = {
    "802.11n, 20 MHz": ({"standard": "802.11n"}, "-o"),
    "802.11ac, 80 MHz": ({"standard": "802.11ac", "width": 80e6}, "--s"),
    "802.11ax, 80 MHz": ({"standard": "802.11ax", "width": 80e6}, ":D"),
}
FRAMES = (1, 2, 4, 8, 16, 32, 64)


def _hosts(protocol: Protocol, channel: Wifi) -> float:
    return float(saturation_hosts(protocol, *_SMALL, channel))


def rates_data(bounds: dict[str, float]) -> pd.DataFrame:
    """Return saturation points by unicast rate: of radios, of the paper's model, and its limit."""
    rates = np.geomspace(5, 5000, 120)
    linear = {}
    for protocol in figures.PAPER_PROTOCOLS:
        given = {nt.N_P: _SMALL[0], nt.N_E: _SMALL[1], nt.U_LIMIT: 1}
        given |= protocol.values() | PAPER.values() | {nt.R_UNI: rates * 1e6}
        linear[protocol.name] = lambdify(list(given), saturation(protocol))(*given.values())
    channels = [
        (name, Radio(**radio, mcs=mcs).wifi())
        for name, (radio, count, _) in _FAMILIES.items()
        for mcs in range(count)
    ]
    points = pd.DataFrame(
        {"series": name, "rate_Mbit_s": channel.unicast.rate / 1e6}
        | {f"{p.name}_hosts": _hosts(p, channel) for p in figures.PAPER_PROTOCOLS}
        for name, channel in channels
    )
    line = {f"{name}_hosts": values for name, values in linear.items()}
    limit = {f"{name}_hosts": value for name, value in bounds.items()}
    return pd.concat(
        [
            points,
            pd.DataFrame({"series": "paper model", "rate_Mbit_s": rates} | line),
            pd.DataFrame([{"series": "limit", "rate_Mbit_s": np.inf} | limit]),
        ]
    )


def rates(bounds: dict[str, float]) -> Figure:
    """Draw saturation points against the unicast rate, with the limit for an infinite rate."""
    data = rates_data(bounds)
    with style():
        figure = Figure(figsize=(WIDTH, 3.1))
        axes = figure.subplots(1, 2, sharey=True)
        for axis, protocol in zip(axes, figures.PAPER_PROTOCOLS, strict=True):
            column, color = f"{protocol.name}_hosts", COLORS[protocol.name]
            line = data[data["series"] == "paper model"]
            axis.plot(line["rate_Mbit_s"], line[column], color=color)
            axis.text(6, line[column].iloc[0] - 0.6, "paper model", color=color, fontsize=8)
            axis.axhline(bounds[protocol.name], color="black", linestyle=":", linewidth=1)
            axis.text(
                5, bounds[protocol.name] + 0.12,
                f"infinite rate: {bounds[protocol.name]:.2f}", fontsize=8,
            )  # fmt: skip
            for name, (_, _, mark) in _FAMILIES.items():
                rows = data[data["series"] == name]
                axis.plot(
                    rows["rate_Mbit_s"], rows[column], mark, color="0.35", ms=5, mfc="none",
                    label=name,
                )  # fmt: skip
            axis.set_xscale("log")
            axis.set_xticks([10, 100, 1000], ["10", "100", "1,000"])
            axis.set(ylim=(0, 9), xlabel="unicast rate [Mbit/s]")
            axis.set_title(protocol.name)
        axes[0].set_ylabel("robots that fill a second")
        axes[0].legend(loc="lower right", fontsize=8)
        headline(figure, "Above 100 Mbit/s a faster rate gains less than one robot")
    return figure


def aggregation_data() -> pd.DataFrame:
    """Return saturation points by the number of frames in each A-MPDU."""
    return pd.DataFrame(
        {"radio": name, "frames": frames}
        | {f"{p.name}_hosts": _hosts(p, channel) for p in figures.PAPER_PROTOCOLS}
        for name, (radio, _) in _RADIOS.items()
        for frames in FRAMES
        for channel in (Radio(**radio, streams=2, mpdus=frames).wifi(),)
    )


def aggregation() -> Figure:
    """Draw saturation points against the number of frames in each A-MPDU, all of them full."""
    data = aggregation_data()
    with style():
        figure = Figure(figsize=(WIDTH, 3.1))
        axes = figure.subplots(1, 2, sharey=True)
        for axis, protocol in zip(axes, figures.PAPER_PROTOCOLS, strict=True):
            column = f"{protocol.name}_hosts"
            for name, (_, look) in _RADIOS.items():
                rows = data[data["radio"] == name]
                axis.plot(rows["frames"], rows[column], look, color=COLORS[protocol.name], ms=4)
                end = rows.iloc[-1]
                axis.text(
                    76, end[column], f"{name.split(',')[0]}: {end[column]:.0f}", fontsize=8,
                    va="bottom" if "ax" in name else "top" if "ac" in name else "center",
                )  # fmt: skip
            axis.set_xscale("log", base=2)
            axis.set_xticks(FRAMES, [str(frames) for frames in FRAMES])
            axis.set(xlim=(0.9, 520), ylim=(0, 50), xlabel="frames per A-MPDU")
            axis.set_title(protocol.name)
        axes[0].set_ylabel("robots that fill a second")
        headline(figure, "Sharing the overhead is what makes a faster radio pay off")
    return figure
