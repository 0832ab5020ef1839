"""Figures of the chapter on servers and routers: what fits with each, and what fails with it."""

from collections.abc import Iterator
from functools import cache
from typing import Any

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from numpy.typing import ArrayLike, NDArray

from discostorm import measured
from discostorm.data import read_data
from discostorm.figures import WIDTH, headline, style
from discostorm.fleet import Fleet, HostGroup
from discostorm.model import utilization
from discostorm.palette import lights
from discostorm.protocols import PROTOCOLS
from discostorm.robots import shared_endpoints
from discostorm_book.lab_counts import death_times

#: Which topic names match: what a process shares with all, and the part of the others that match.
NAMES = {"own": (0, 0.0), "ROS 2": (shared_endpoints(), 0.0), "same": (0, 1.0)}
_MANY = np.arange(1.0, 5001)
_SERVER = "Fast DDS Discovery Server"
_HUB = "Zenoh router per host, one hub"
_SHORT = {
    "Cyclone DDS multicast SEDP": "multicast SEDP",
    "Cyclone DDS peers": "static peers",
    _SERVER: "Discovery Server",
    f"{_SERVER}, on a robot": "… on a robot",
    f"{_SERVER}, two": "two Discovery Servers",
    "Zenoh router": "central router",
    "Zenoh router per host": "router per robot",
    "Zenoh router per host, star": "… and a wired one",
    _HUB: "router per robot, one hub",
}
#: What else fails with it: color and mark.
BREAKS = {
    "nothing else": ("blue", "o"),
    "discovery of late joiners": ("orange", "s"),
    "one robot": ("purple", "D"),
    "the whole fleet": ("vermilion", "X"),
}


@cache
def instead_of() -> dict[str, str]:
    """Return the product as shipped that each configuration takes the place of."""
    rows = read_data("vendors/configuration_risks.csv", "discostorm_book")
    of = {row["protocol"]: row["instead_of"] for row in rows}
    return {name: of[name] for name in measured.configurations()}


def swarm(hosts: ArrayLike, names: str = "ROS 2") -> Fleet:
    """Return the paper's small robots with topic names that match as `NAMES` says."""
    shared, matching = NAMES[names]
    return Fleet((HostGroup(hosts, 2, 10, shared=shared),), matching)


def used(
    name: str, hosts: ArrayLike, names: str = "ROS 2", window: float = np.inf
) -> NDArray[np.float64]:
    """Return utilization by so many small robots, in the steady state if no window is given."""
    return np.asarray(utilization(PROTOCOLS[name], swarm(hosts, names), window=window))


def startup(name: str, hosts: ArrayLike, names: str = "ROS 2") -> NDArray[np.float64]:
    """Return the airtime of the first second beyond that of the steady state [s]."""
    return used(name, hosts, names, 1.0) - used(name, hosts, names)


def fit(name: str, limit: float, names: str = "ROS 2", window: float = 1.0) -> int:
    """Return how many small robots need at most this share of a window; 5,000 stands for more."""
    below = used(name, _MANY, names, window) <= limit
    return int(_MANY[below][-1]) if below.any() else 0


def breaks(name: str) -> str:
    """Return what else fails with the server or router of an configuration, as it was measured."""
    as_what = {
        row["protocol"]: row["fails_as"]
        for row in read_data("vendors/configuration_risks.csv", "discostorm_book")
    }
    killed = [
        (row["who"], float(row["seconds"]), row["quantity"])
        for row in read_data("measured/deaths.csv", "discostorm_book")
        if (row["configuration"], row["event"]) == (as_what.get(name, name), "server killed")
    ]

    def never(who: str, quantity: str) -> bool:
        return any(it == (who, np.inf, quantity) for it in killed)

    if never("survivors", "settled"):
        return "the whole fleet"
    if never("newcomer", "found"):
        return "discovery of late joiners"
    return "one robot" if never("orphans and survivors", "settled") else "nothing else"


def configurations_data() -> pd.DataFrame:
    """Return how many robots fit with each product and configuration, and what fails with it."""
    of = instead_of()
    return pd.DataFrame(
        {"product": product.split(",")[0], "configuration": name}
        | {f"one second, {names} names": fit(name, 1.0, names) for names in NAMES}
        | {
            "10% of the steady state": fit(name, 0.1, window=np.inf),
            "what else fails": breaks(name),
        }
        for product in dict.fromkeys(of.values())
        for name in (product, *(it for it in of if of[it] == product))
    )


def configurations() -> Figure:
    """Draw how many robots fit with each configuration as dots, colored by what fails with it."""
    data = configurations_data()
    colors = lights("series")
    with style():
        figure = Figure(figsize=(WIDTH, 4.4))
        start, steady = figure.subplots(1, 2, sharey=True)
        places, labels = [], []
        place = 0.0
        for row in data.to_dict("records"):
            shipped = row["configuration"] not in instead_of()
            place += 1.6 if shipped else 1.0
            places.append(place)
            labels.append(
                f"{row['product']}, as shipped"
                if shipped
                else _SHORT.get(row["configuration"], row["configuration"])
            )
            color, mark = BREAKS[row["what else fails"]]
            look: dict[str, Any] = {"marker": mark, "ms": 7, "color": colors[color]}
            look |= {"mfc": "white", "mew": 1.6} if shipped else {"mew": 0}
            ends = [row[f"one second, {names} names"] for names in ("same", "own")]
            if ends[0] != ends[1]:
                start.plot(ends, [place] * 2, color="0.6", lw=1.2, marker="|", ms=7, zorder=1)
            for axis, value in (
                (start, row["one second, ROS 2 names"]),
                (steady, row["10% of the steady state"]),
            ):
                axis.plot(value, place, **look)
                more = "+" if value == _MANY[-1] else ""
                axis.annotate(
                    f"{value:,}{more}", (value, place), (7, 0), textcoords="offset points",
                    va="center", fontsize=9,
                    bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.6},
                )  # fmt: skip
        start.set_yticks(places, labels)
        for tick, label in zip(start.get_yticklabels(), labels, strict=True):
            tick.set_weight("bold" if "shipped" in label else "normal")
        start.invert_yaxis()
        start.set(xscale="log", xlim=(2.4, 70), xlabel="robots")
        start.set_title("start within one second", loc="left", fontweight="normal")
        start.set_xticks([3, 5, 10, 20, 50], ["3", "5", "10", "20", "50"])
        steady.set(xscale="log", xlim=(5, 20000), xlabel="robots")
        steady.set_title("need 10% in the steady state", loc="left", fontweight="normal")
        steady.set_xticks([10, 100, 1000], ["10", "100", "1,000"])
        for axis in (start, steady):
            axis.minorticks_off()
            axis.tick_params(axis="y", length=0)
        handles = [
            Line2D([], [], ls="", marker=mark, ms=7, color=colors[color], mew=0, label=what)
            for what, (color, mark) in BREAKS.items()
        ]
        figure.legend(
            handles=handles,
            title="What else fails if its server or router fails",
            loc="outside lower center",
            ncols=2,
        )
        headline(
            figure, "A wired Zenoh router admits the most robots, but it can silence all of them"
        )
    return figure


_LANES = (
    (_SERVER, "server killed", "one Discovery Server"),
    (f"{_SERVER}, two", "server killed", "two Discovery Servers, one killed"),
    (f"{_SERVER}, two", "both servers killed", "two Discovery Servers, both killed"),
    ("Zenoh router", "server killed", "one central Zenoh router"),
    ("Zenoh router per host", "server killed", "a router per robot, that of robot 1 killed"),
    (_HUB, "server killed", "routers behind one hub, the hub killed"),
)
_KNOWN, _LATE, _OWN = "robots that knew each other", "late joiner", "robot 1 and the others"


def failures_data() -> pd.DataFrame:
    """Return from when on processes hear each other after a server or router was killed [s]."""
    return pd.DataFrame(
        {
            "configuration": name,
            "event": event,
            "title": title,
            "who": who,
            "from_s": begin,
            "connected_from_s": connected,
            "server_back_s": back,
            "until_s": end,
        }
        for name, event, title in _LANES
        for who, begin, connected, back, end in _lanes(name, event)
    )


def _lanes(name: str, event: str) -> Iterator[tuple[str, float, float, float, float]]:
    rows = [
        row
        for row in read_data("measured/deaths.csv", "discostorm_book")
        if (row["configuration"], row["event"]) == (name, event)
    ]
    since = {row["phase"]: float(row["since_s"]) for row in rows}
    back = since["return"]
    end = max(float(row["since_s"]) + float(row["watched_s"]) for row in rows)

    def again(who: str) -> float:
        return back + float(np.median(death_times(name, event, "return", who, "found")))

    for who, label in (("survivors", _KNOWN), ("orphans and survivors", _OWN)):
        if (who, "settled") in {(row["who"], row["quantity"]) for row in rows}:
            lost = np.isinf(death_times(name, event, "death", who, "settled")).all()
            if label == _OWN and name == _HUB:
                continue  # there the others lose each other as well
            returned = "survivors" if who == "survivors" else "orphans"
            yield label, 0.0, again(returned) if lost else 0.0, back, end
    found = float(np.median(death_times(name, event, "newcomer", "newcomer", "found")))
    begin = since["newcomer"]
    yield _LATE, begin, begin + found if np.isfinite(found) else again("newcomer"), back, end


def noticed_data() -> pd.DataFrame:
    """Return how long the others keep a robot that has failed on their lists, medians [s]."""
    leases = {
        row["configuration"]: float(row["lease_s"])
        for row in read_data("measured/configurations.csv", "discostorm_book")
    }
    staged = {
        (row["configuration"], row["event"])
        for row in read_data("measured/deaths.csv", "discostorm_book")
        if row["quantity"] == "noticed"
    }
    return pd.DataFrame(
        {
            "configuration": name,
            "event": event,
            "noticed_s": float(np.median(death_times(name, event, "death", "dead", "noticed"))),
            "lease_s": lease,
        }
        for name, lease in leases.items()
        for event in ("robot killed", "robot cut off")
        if (name, event) in staged
    )


def failures() -> Figure:
    """Draw who hears whom after a failure as swim lanes."""
    with style():
        figure = Figure(figsize=(WIDTH, 4.5))
        marks = _draw_lanes(figure.subplots(), failures_data())
        figure.legend(handles=marks, loc="outside lower center", ncols=3)
        headline(figure, "Only a central router or hub silences the fleet")
    return figure


def noticed() -> Figure:
    """Draw how long the others keep a robot that has failed on their lists, as bars."""
    with style():
        figure = Figure(figsize=(WIDTH, 2.6))
        _draw_noticed(figure.subplots(), noticed_data())
        headline(figure, "A failed robot stays listed for about one lease")
    return figure


def _draw_lanes(axis: Axes, data: pd.DataFrame) -> list[Patch | Line2D]:
    """Draw the lanes and return what their marks look like."""
    colors = lights("series")
    place, places, labels = 0.0, [], []
    for title, rows in data.groupby("title", sort=False):
        place += 1.15
        axis.text(0, place, str(title), fontsize=9, fontweight="bold", va="center")
        top = place + 0.4
        for row in rows.to_dict("records"):
            place += 0.85
            places.append(place)
            labels.append(row["who"])
            begin, connected, end = row["from_s"], row["connected_from_s"], row["until_s"]
            if connected > begin:
                axis.barh(
                    place, connected - begin, 0.55, left=begin, color="white",
                    edgecolor=colors["vermilion"], lw=0.9, hatch="////",
                )  # fmt: skip
            axis.barh(place, end - connected, 0.55, left=connected, color=colors["blue"])
            back = row["server_back_s"]
            if connected > back:
                axis.text(end + 1, place, f"+{connected - back:.1f} s", va="center", fontsize=8)
        back = rows["server_back_s"].iloc[0]
        axis.vlines(back, top, place + 0.4, color="black", lw=1.6)
    axis.set_yticks(places, labels, fontsize=8)
    axis.tick_params(axis="y", length=0)
    axis.set(xlim=(0, 144), xlabel="time since the server or router was killed [s]")
    axis.set_ylim(place + 0.6, 0.5)
    axis.grid(axis="y", visible=False)
    return [
        Patch(color=colors["blue"], label="hear each other"),
        Patch(fc="white", ec=colors["vermilion"], hatch="////", label="do not"),
        Line2D([], [], color="black", lw=1.6, label="server or router is back"),
    ]


def _draw_noticed(axis: Axes, data: pd.DataFrame) -> None:
    colors = lights("series")
    looks = {"robot killed": (-0.19, "orange", "killed"),
             "robot cut off": (0.19, "sky", "out of reach")}  # fmt: skip
    names = list(dict.fromkeys(data["configuration"]))
    for row in data.to_dict("records"):
        shift, color, _ = looks[row["event"]]
        place = names.index(row["configuration"]) + shift
        axis.barh(place, row["noticed_s"], 0.34, color=colors[color])
        short = f"{row['noticed_s']:.0f}" if row["noticed_s"] >= 0.5 else "0"
        axis.text(row["noticed_s"] + 0.8, place, f"{short}", va="center", fontsize=8)
        axis.vlines(row["lease_s"], place - 0.19, place + 0.19, color="black", lw=1.6, zorder=3)
    axis.set_yticks(range(len(names)), [_SHORT.get(name, name) for name in names], fontsize=8)
    axis.tick_params(axis="y", length=0)
    axis.invert_yaxis()
    axis.set(xlim=(0, 100), xlabel="time until the others time the robot out [s]")
    axis.grid(axis="y", visible=False)
    axis.legend(
        handles=[
            *(Patch(color=colors[color], label=label) for _, color, label in looks.values()),
            Line2D([], [], color="black", lw=1.6, label="lease"),
        ],
        loc="upper right",
    )
