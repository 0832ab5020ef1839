"""Figures of the proposed (hybrid) discovery: airtime step by step, and discovery times."""

from dataclasses import replace
from functools import cache

import numpy as np
import pandas as pd
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, NullLocator

from discostorm import wording
from discostorm.data import read_data
from discostorm.messages import HOST, Message, Payload, Protocol
from discostorm.model import utilization
from discostorm.palette import light_colors
from discostorm.protocols import DDS, PROTOCOLS
from discostorm_book.figures.drawing import book_figure, name_rows_without_ticks, write_text

#: Fleets of the first figure.
_FLEET_SIZES = (7, 100)


@cache
def _all_runs() -> pd.DataFrame:
    """Return all simulated runs of the hybrid discovery, a row each."""
    data = pd.DataFrame(read_data("simulated/hybrid.csv", "discostorm_book"))
    return data.astype(dict.fromkeys(data.columns.drop("scenario"), float))


def runs_of_scenario(scenario: str) -> pd.DataFrame:
    """Return the runs of a scenario; "50 die" are all runs in which 50 crash during startup."""
    scenarios = _all_runs()["scenario"]
    crashes = scenarios.str.startswith(scenario) & (scenario == "50 die")
    return _all_runs()[crashes | (scenarios == scenario)]


def _airtime_of_steps(hosts: int, processes: int = 2, endpoints: int = 10) -> dict[str, float]:
    """Return the airtime of the first second [s] from DDS to the proposal, step by step."""
    sizes = {row["quantity"]: float(row["value"]) for row in read_data("hybrid/parameters.csv")}
    all_of_them = processes * endpoints
    size = sizes["header"] + processes * sizes["process"] + all_of_them * sizes["endpoint"]
    packed = Payload(size, size, size, "all endpoints of a host in one message")
    one_each = tuple(replace(m, payload=packed) if m.name == "SEDP" else m for m in DDS.messages)
    once = Message("Set", "Sets", "multicast", "UDP", packed, HOST, 1)
    multicast = (once, DDS.message("Heartbeat"), DDS.message("ACKNACK"))
    tables: dict[str, tuple[Protocol, int, int]] = {
        "DDS, as the paper counts it": (DDS, processes, endpoints),
        "one speaker per host": (DDS, 1, all_of_them),
        "… its set in one frame": (Protocol("packed", one_each), 1, 1),
        "… by multicast": (Protocol("multicast", multicast), 1, 0),
        "… without acknowledgments": (PROTOCOLS["hybrid"], processes, endpoints),
        "… identical software by its hash": (PROTOCOLS["hybrid, alike"], processes, endpoints),
    }
    return {
        name: float(utilization(table, hosts, each, of_each))
        for name, (table, each, of_each) in tables.items()
    }


def airtime_steps_data() -> pd.DataFrame:
    """Return the airtime of the first second [s]: one row per step, one column per fleet."""
    columns = {f"{hosts} hosts [s]": _airtime_of_steps(hosts) for hosts in _FLEET_SIZES}
    return pd.DataFrame(columns).rename_axis("step")


def airtime_steps() -> Figure:
    """Draw the airtime from DDS to the proposal, step by step, for a small and a large fleet."""
    data = airtime_steps_data()
    colors = [light_colors("neutral")[shade] for shade in ("gray", "charcoal")]
    ys = range(len(data))
    with book_figure(2.9, "Every step helps; dropping acknowledgments helps most") as figure:
        axis = figure.subplots()
        axis.axvline(1, color="black", linewidth=1)
        for column, color, side in zip(data, colors, ("right", "left"), strict=True):
            across = 7 if side == "left" else -7
            axis.plot(data[column], ys, "o", color=color)
            for y, airtime in zip(ys, data[column], strict=True):
                text = wording.duration(airtime) if airtime < 60 else f"{airtime:.0f} s"
                offset, look = (across, 0), {"ha": side, "va": "center", "fontsize": 8.5}
                if side == "left" and airtime < 1:  # else it would cover the line
                    offset, look = (0, 5), {"ha": "center", "fontsize": 8.5}
                write_text(axis, text, (airtime, y), offset, **look)
            name, first = str(column).removesuffix(" [s]"), (data[column].iloc[0], 0)
            look = {"color": color, "fontweight": "bold", "fontsize": 10}
            write_text(axis, name, first, (across, 9), ha=side, **look)
        axis.text(1, 1.0, "1 s", ha="center", va="bottom", transform=axis.get_xaxis_transform())
        axis.set(xscale="log", xlim=(1e-4, 6e3), xlabel="airtime of the first second [s]")
        axis.set_ylim(len(data) - 0.5, -0.8)
        name_rows_without_ticks(axis, ys, data.index, labelsize=8.5)
        axis.spines["left"].set_visible(False)
        # On a phone no more numbers fit below the axis.
        axis.set_xticks([10.0**power for power in (-2, 0, 2)])
        axis.xaxis.set_minor_locator(NullLocator())
        axis.xaxis.set_major_formatter(FuncFormatter(lambda x, _: f"{x:,g}"))
    return figure


def convergence_times_data() -> pd.DataFrame:
    """Return the time until all hosts have discovered each other [s]: one row per scenario."""
    rows = []
    for row in read_data("hybrid/scenarios.csv", "discostorm_book"):
        scenario, since, name, _ = row.values()
        times = np.sort(runs_of_scenario(scenario)["converged_s"].to_numpy() - float(since))
        most = times[int(np.ceil(0.95 * times.size)) - 1]
        rows.append((name, times.size, times[0], np.median(times), most, times[-1]))
    columns = ["scenario", "runs", "fastest [s]", "median [s]", "95% [s]", "slowest [s]"]
    return pd.DataFrame(rows, columns=columns)


def convergence_times() -> Figure:
    """Draw the times until all hosts have discovered each other: one line per scenario."""
    data = convergence_times_data()
    with book_figure(3.0, "Crashes and meetings cost little time, fades cost most") as figure:
        axis = figure.subplots()
        for y, row in enumerate(data.to_dict("records")):
            fades = "fades" in row["scenario"]
            color = light_colors("series")["wine"] if fades else light_colors("basis")["proposal"]
            median, slowest = row["median [s]"], row["slowest [s]"]
            axis.plot([row["fastest [s]"], slowest], [y, y], "-", color=color)
            axis.plot(median, y, "o", color=color)
            axis.plot(row["95% [s]"], y, "|", color=color, markersize=11, mew=2)
            write_text(axis, f"{median:.1f} s", (slowest, y), (6, 0), va="center", fontsize=8.5)
        axis.set(xlim=(0, 1.15 * data["slowest [s]"].max()))
        axis.set_xlabel("time until all hosts know each other [s]")
        name_rows_without_ticks(axis, range(len(data)), data["scenario"], labelsize=8.5)
        axis.invert_yaxis()
    return figure
