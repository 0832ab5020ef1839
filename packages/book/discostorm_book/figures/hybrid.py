"""Figures of the chapter on the hybrid discovery: its steps in airtime, and how long it takes."""

from dataclasses import replace
from functools import cache

import numpy as np
import pandas as pd
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, NullLocator

from discostorm import words
from discostorm.data import read_data
from discostorm.figures import WIDTH, headline, style
from discostorm.messages import HOST, Message, Payload, Protocol
from discostorm.model import utilization
from discostorm.palette import lights
from discostorm.protocols import DDS, PROTOCOLS

#: Fleets of the first figure.
_FLEETS = (7, 100)
#: Rows of the second figure: scenario, from when on its time counts [s], and what it is called.
_SCENARIOS = (
    ("alike", 0, "100 hosts, identical software"),
    ("unlike", 0, "100 hosts, mixed software"),
    ("unlike, queues of 20", 0, "… with queues of 20 frames"),
    ("50 die", 0, "… and 50 of them crash"),
    ("newcomer", 1, "a late joiner"),
    ("halves", 0, "two halves meet"),
    ("50 join 50", 1, "50 join 50"),
    ("halves after a lease", 36, "two halves that timed out meet"),
    ("unlike, fades of 0.1 s", 0, "100 hosts, fades of 0.1 s"),
    ("unlike, fades of 0.5 s", 0, "100 hosts, fades of 0.5 s"),
)


@cache
def runs() -> pd.DataFrame:
    """Return all simulated runs of the hybrid discovery, a row each."""
    data = pd.DataFrame(read_data("simulated/hybrid.csv", "discostorm_book"))
    numbers = data.columns.drop("scenario")
    return data.astype(dict.fromkeys(numbers, float))


def runs_of(scenario: str) -> pd.DataFrame:
    """Return the runs of a scenario; "50 die" are all runs in which 50 crash during startup."""
    data = runs()
    if scenario == "50 die":
        return data[data["scenario"].str.startswith(scenario)]
    return data[data["scenario"] == scenario]


def steps(hosts: int, processes: int = 2, endpoints: int = 10) -> dict[str, float]:
    """Return the airtime of the first second [s] from DDS to the proposal, step by step."""
    sizes = {row["quantity"]: float(row["value"]) for row in read_data("hybrid/parameters.csv")}
    all_of_them = processes * endpoints
    size = sizes["header"] + processes * sizes["process"] + all_of_them * sizes["endpoint"]
    packed = Payload(size, size, size, "all endpoints of a host in one message")
    one_each = tuple(replace(m, payload=packed) if m.name == "SEDP" else m for m in DDS.messages)
    once = (
        Message("Set", "Sets", "multicast", "UDP", packed, HOST, 1),
        *(DDS.message(name) for name in ("Heartbeat", "ACKNACK")),
    )
    tables = {
        "DDS, as the paper counts it": (DDS, processes, endpoints),
        "one speaker per host": (DDS, 1, all_of_them),
        "… its set in one frame": (Protocol("packed", one_each), 1, 1),
        "… by multicast": (Protocol("multicast", once), 1, 0),
        "… without acknowledgments": (PROTOCOLS["hybrid"], processes, endpoints),
        "… identical software by its hash": (PROTOCOLS["hybrid, alike"], processes, endpoints),
    }
    return {
        name: float(utilization(table, hosts, each, of_each))
        for name, (table, each, of_each) in tables.items()
    }


def ladder_data() -> pd.DataFrame:
    """Return the airtime of the first second [s]: a row a step, a column a fleet."""
    return pd.DataFrame({f"{hosts} hosts [s]": steps(hosts) for hosts in _FLEETS}).rename_axis(
        "step"
    )


def ladder() -> Figure:
    """Draw the airtime from DDS to the proposal, step by step, for a small and a large fleet."""
    data = ladder_data()
    # No product has these.
    colors = [lights("neutral")[shade] for shade in ("gray", "charcoal")]
    with style():
        figure = Figure(figsize=(WIDTH, 2.9))
        axis = figure.subplots()
        places = np.arange(len(data))
        axis.axvline(1, color="black", linewidth=1)
        for column, color, across in zip(data, colors, (-7, 7), strict=True):
            axis.plot(data[column], places, "o-", color=color)
            for place, airtime in zip(places, data[column], strict=True):
                said = words.duration(airtime) if airtime < 60 else f"{airtime:.0f} s"
                axis.annotate(
                    said, (airtime, place), (across, 0),
                    textcoords="offset points", va="center", fontsize=8.5,
                    ha="left" if across > 0 else "right",
                    bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.6},
                )  # fmt: skip
            axis.annotate(
                str(column).removesuffix(" [s]"), (data[column].iloc[0], 0), (across, 9),
                textcoords="offset points", color=color, fontweight="bold",
                ha="left" if across > 0 else "right",
            )  # fmt: skip
        axis.text(1, 1.0, "1 s", ha="center", va="bottom", transform=axis.get_xaxis_transform())
        axis.set(xscale="log", xlim=(1e-4, 6e3), xlabel="airtime of the first second [s]")
        axis.set_ylim(len(data) - 0.5, -0.8)
        axis.set_yticks(places, data.index)
        axis.tick_params(axis="y", length=0, labelsize=8.5)
        axis.spines["left"].set_visible(False)
        axis.grid(visible=False, axis="y")
        # On a phone no more numbers fit below the axis.
        axis.set_xticks([10.0**power for power in (-2, 0, 2)])
        axis.xaxis.set_minor_locator(NullLocator())
        axis.xaxis.set_major_formatter(FuncFormatter(lambda x, _: f"{x:,g}"))
        headline(figure, "Every step helps; dropping acknowledgments helps most")
    return figure


def times_data() -> pd.DataFrame:
    """Return how long it takes until all hosts know each other [s]: a row a scenario."""
    rows = []
    for scenario, since, name in _SCENARIOS:
        times = np.sort(runs_of(scenario)["converged_s"].to_numpy() - since)
        rows.append(
            {
                "scenario": name,
                "runs": times.size,
                "fastest [s]": times[0],
                "median [s]": np.median(times),
                "95% [s]": times[int(np.ceil(0.95 * times.size)) - 1],
                "slowest [s]": times[-1],
            }
        )
    return pd.DataFrame(rows)


def times() -> Figure:
    """Draw the times until all hosts know each other: a line a scenario, with its median."""
    data = times_data()
    colors = lights("series")
    with style():
        figure = Figure(figsize=(WIDTH, 3.0))
        axis = figure.subplots()
        for place, row in enumerate(data.to_dict("records")):
            color = colors["vermilion" if "fades" in row["scenario"] else "blue"]
            axis.plot([row["fastest [s]"], row["slowest [s]"]], [place, place], "-", color=color)
            axis.plot(row["median [s]"], place, "o", color=color)
            axis.plot(row["95% [s]"], place, "|", color=color, markersize=11, mew=2)
            axis.annotate(
                f"{row['median [s]']:.1f} s", (row["slowest [s]"], place), (6, 0),
                textcoords="offset points", va="center", fontsize=8.5,
            )  # fmt: skip
        axis.set(xlim=(0, 1.15 * data["slowest [s]"].max()))
        axis.set_xlabel("time until all hosts know each other [s]")
        axis.set_yticks(range(len(data)), data["scenario"])
        axis.invert_yaxis()
        axis.tick_params(axis="y", length=0, labelsize=8.5)
        axis.grid(visible=False, axis="y")
        headline(figure, "Crashes and meetings cost little time, fades cost most")
    return figure
