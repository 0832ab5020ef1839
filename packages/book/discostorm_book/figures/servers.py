"""Figures of the chapter on servers and routers: fleets that fit, and failures."""

from collections.abc import Iterator, Mapping
from functools import cache
from typing import Any

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from numpy.typing import ArrayLike, NDArray

from discostorm.data import read_data
from discostorm.fleet import Fleet, HostGroup
from discostorm.model import utilization
from discostorm.palette import light_colors
from discostorm.protocols import PROTOCOLS, measured_tables
from discostorm.robots import shared_endpoints
from discostorm_book.figures import drawing
from discostorm_book.figures.drawing import Style, book_figure, write_text
from discostorm_book.lab_counts import failure_summary, failure_times

#: Cases of matching topic names: endpoints that always match, and matching share of the others.
TOPIC_NAMES = {"separate": (0, 0.0), "ROS 2": (shared_endpoints(), 0.0), "matching": (0, 1.0)}
_HOST_COUNTS = np.arange(1.0, 5001)
_SERIES, _STATES = light_colors("series"), light_colors("state")
_HUB_CONFIGURATION = "Zenoh router per host, one hub"
_CONFIGURATION_NAMES = read_data("vendors/short_names.csv", "discostorm_book")
#: Names of configurations for people, and shorter ones.
FULL_NAMES, _SHORT_NAMES = (
    {row["configuration"]: row[c] for row in _CONFIGURATION_NAMES} for c in ("name", "short")
)
#: Consequences of a failed server or router: color and mark.
CONSEQUENCES = {
    "nothing else": (_STATES["ok"], "o"),
    "discovery of late joiners": (_SERIES["olive"], "s"),
    "one robot": (_STATES["slow"], "D"),
    "the whole fleet": (_STATES["bad"], "X"),
}


def _configuration_risks(column: str) -> dict[str, str]:
    """Return a column of the risks of each configuration."""
    rows = read_data("vendors/configuration_risks.csv", "discostorm_book")
    return {row["protocol"]: row[column] for row in rows}


def _failures_of(name: str, event: str) -> pd.DataFrame:
    rows = failure_summary()
    return rows[(rows["configuration"] == name) & (rows["event"] == event)]


@cache
def replaced_products() -> dict[str, str]:
    """Return the product as shipped that each configuration replaces."""
    replaced = _configuration_risks("instead_of")
    return {name: replaced[name] for name in measured_tables.configurations()}


def small_robots(hosts: ArrayLike, names: str = "ROS 2") -> Fleet:
    """Return the paper's small robots with topic names that match as `TOPIC_NAMES` says."""
    shared, matching = TOPIC_NAMES[names]
    return Fleet((HostGroup(hosts, 2, 10, shared=shared),), matching)


def swarm_utilization(
    name: str, hosts: ArrayLike, names: str = "ROS 2", window: float = np.inf
) -> NDArray[np.float64]:
    """Return utilization by small robots, in the steady state if no window is given."""
    return np.asarray(utilization(PROTOCOLS[name], small_robots(hosts, names), window=window))


def startup_burst(name: str, hosts: ArrayLike, names: str = "ROS 2") -> NDArray[np.float64]:
    """Return the airtime of the first second minus the steady state's airtime per second [s]."""
    return swarm_utilization(name, hosts, names, 1.0) - swarm_utilization(name, hosts, names)


def _largest_fleet(name: str, limit: float, names: str = "ROS 2", window: float = 1.0) -> int:
    """Return the most small robots whose utilization stays within a limit, up to 5,000."""
    below = swarm_utilization(name, _HOST_COUNTS, names, window) <= limit
    return int(_HOST_COUNTS[below][-1]) if below.any() else 0


def consequence_of(name: str) -> str:
    """Return the measured consequence of a failed server or router of a configuration."""
    rows = _failures_of(_configuration_risks("fails_as").get(name, name), "server killed")
    failed = rows[rows["happened"] < rows["runs"]]
    never = set(zip(failed["who"], failed["quantity"], strict=True))
    if ("survivors", "settled") in never:
        return "the whole fleet"
    if ("newcomer", "found") in never:
        return "discovery of late joiners"
    return "one robot" if ("orphans and survivors", "settled") in never else "nothing else"


def consequence_style(consequence: str) -> Style:
    """Return color and mark of a consequence of a failure."""
    color, mark = CONSEQUENCES[consequence]
    return {"color": color, "marker": mark, "mew": 0}


def consequence_legend(figure: Figure, title: str, size: float) -> None:
    """Explain the marks of consequences below a figure."""
    looks = {what: consequence_style(what) for what in CONSEQUENCES}
    marks = [Line2D([], [], ls="", ms=size, label=what, **look) for what, look in looks.items()]
    drawing.legend_below(figure, marks, 2, title=title)


def robots_by_configuration_data() -> pd.DataFrame:
    """Return how many robots fit with each product and configuration, and its consequence."""
    replaced = replaced_products()
    return pd.DataFrame(
        {"product": product.split(",")[0], "configuration": name}
        | {f"one second, {names} names": _largest_fleet(name, 1.0, names) for names in TOPIC_NAMES}
        | {"10% of the steady state": _largest_fleet(name, 0.1, window=np.inf)}
        | {"what else fails": consequence_of(name)}
        for product in dict.fromkeys(replaced.values())
        for name in (product, *(other for other in replaced if replaced[other] == product))
    )


def robots_by_configuration() -> Figure:
    """Draw how many robots fit with each configuration as dots, colored by its consequence."""
    title = "Wired Zenoh routers admit the most robots, but can silence all of them"
    with book_figure(5.2, title) as figure:
        start, steady = figure.subplots(1, 2, sharey=True)
        labels, y = {}, 0.0
        for row in robots_by_configuration_data().to_dict("records"):
            name, look = row["configuration"], consequence_style(row["what else fails"])
            y += 1.0 if name in replaced_products() else 1.6
            labels[y] = _SHORT_NAMES.get(name, name)
            if name not in replaced_products():
                labels[y] = f"{row['product']}, as shipped"
                look |= {"mfc": "white", "mew": 1.6}
            ends = [row[f"one second, {names} names"] for names in ("matching", "separate")]
            if ends[0] != ends[1]:
                start.plot(ends, [y] * 2, color="0.6", lw=1.2, marker="|", ms=7, zorder=1)
            columns = {start: "one second, ROS 2 names", steady: "10% of the steady state"}
            for axis, column in columns.items():
                axis.plot(row[column], y, ms=7, **look)
                text = f"{row[column]:,}{'+' if row[column] == _HOST_COUNTS[-1] else ''}"
                offset, side, edge = (7, 0), "left", "center"
                if axis is start and ends[0] != ends[1]:  # its range lies beside it
                    offset, side, edge = (0, 4), "center", "bottom"
                write_text(axis, text, (row[column], y), offset, ha=side, va=edge)
        start.set_yticks(list(labels), labels.values())
        for tick in start.get_yticklabels():
            tick.set_weight("bold" if "shipped" in tick.get_text() else "normal")
        start.invert_yaxis()
        for axis, title, limits, ticks in (
            (start, "start within one second", (2.4, 70), (3, 5, 10, 20, 50)),
            (steady, "need 10% in the steady state", (5, 20000), (10, 100, 1000)),
        ):
            axis.set(xscale="log", xlim=limits, xlabel="robots")
            axis.set_title(title, loc="left", fontweight="normal")
            drawing.set_ticks(axis.xaxis, ticks)
            axis.tick_params(axis="y", length=0)
        consequence_legend(figure, "What else fails if its server or router fails", 7)
    return figure


def contact_after_failures_data() -> pd.DataFrame:
    """Return when processes receive from each other again after a server or router failed [s]."""
    return pd.DataFrame(
        lane
        for failure in read_data("measured/failures_shown.csv", "discostorm_book")
        for lane in _failure_lanes(failure["configuration"], failure["event"], failure["title"])
    )


def _failure_lanes(name: str, event: str, title: str) -> Iterator[dict[str, Any]]:
    """Yield the lanes of a failure: robots that knew each other, robot 1, and a late joiner."""
    rows = _failures_of(name, event)
    since = dict(zip(rows["phase"], rows["since_s"], strict=True))
    back, joins = since["return"], since["newcomer"]
    end = (rows["since_s"] + rows["watched_s"]).max()

    def lane(who: str, begin: float, connected: float) -> Style:
        row = {"configuration": name, "event": event, "title": title, "who": who, "from_s": begin}
        return row | {"connected_from_s": connected, "server_back_s": back, "until_s": end}

    def time_rediscovered(pair_kind: str) -> float:
        found = failure_times(name, event, "return", pair_kind, "found")
        return float(back) + float(np.median(found))

    for who, again, label in (
        ("survivors", "survivors", "robots that knew each other"),
        ("orphans and survivors", "orphans", "robot 1 and the others"),
    ):
        # If the router that links all robots fails, the other robots lose each other as well.
        if who in set(rows["who"]) and not (name == _HUB_CONFIGURATION and again == "orphans"):
            lost = np.isinf(failure_times(name, event, "death", who, "settled")).all()
            yield lane(label, 0.0, time_rediscovered(again) if lost else 0.0)
    found = joins + float(np.median(failure_times(name, event, "newcomer", "newcomer", "found")))
    yield lane("late joiner", joins, found if np.isfinite(found) else time_rediscovered("newcomer"))


def contact_after_failures() -> Figure:
    """Draw as swim lanes which processes receive from each other after a failure."""
    with book_figure(4.5, "Only a router that links all robots silences the fleet") as figure:
        axis = figure.subplots()
        y, labels = 0.0, {}
        back_look: Style = {"color": "black", "lw": 1.6}
        for title, rows in contact_after_failures_data().groupby("title", sort=False):
            y += 1.15
            axis.text(0, y, str(title), fontsize=9, fontweight="bold", va="center")
            top, back = y + 0.4, rows["server_back_s"].iloc[0]
            for row in rows.to_dict("records"):
                y += 0.85
                labels[y] = row["who"]
                _draw_lane(axis, y, row)
            axis.vlines(back, top, y + 0.4, **back_look)
        drawing.name_rows_without_ticks(axis, list(labels), labels.values(), labelsize=8)
        axis.set(xlim=(0, 144), xlabel="time since the server or router was killed [s]")
        axis.set_ylim(y + 0.6, 0.5)
        handles = [
            Patch(color=_STATES["ok"], label="hear each other"),
            Patch(fc="white", ec=_STATES["bad"], hatch="////", label="do not"),
            Line2D([], [], label="server or router is back", **back_look),
        ]
        drawing.legend_below(figure, handles, 3)
    return figure


def _draw_lane(axis: Axes, y: float, row: Mapping[Any, Any]) -> None:
    """Draw when two processes receive from each other, and when they do not."""
    begin, connected, end = row["from_s"], row["connected_from_s"], row["until_s"]
    if connected > begin:
        look: Style = {"edgecolor": _STATES["bad"], "lw": 0.9, "hatch": "////"}
        axis.barh(y, connected - begin, 0.55, begin, color="white", **look)
    axis.barh(y, end - connected, 0.55, connected, color=_STATES["ok"])
    if (late := connected - row["server_back_s"]) > 0:
        axis.text(end + 1, y, f"+{late:.1f} s", va="center", fontsize=8)


def failure_detection_data() -> pd.DataFrame:
    """Return how long the others keep a robot that has failed on their lists, medians [s]."""
    rows = failure_summary().query("phase == 'death' and who == 'dead' and quantity == 'noticed'")
    medians = rows.set_index(["configuration", "event"])["median_s"]
    return pd.DataFrame(
        {"configuration": name, "event": event, "noticed_s": medians[name, event]}
        | {"lease_s": float(row["lease_s"])}
        for row in read_data("measured/configurations.csv", "discostorm_book")
        for event in ("robot killed", "robot cut off")
        if ((name := row["configuration"]), event) in medians
    )


def failure_detection() -> Figure:
    """Draw how long the others keep a robot that has failed on their lists, as bars."""
    looks = {"robot killed": (-0.19, "slate", "killed")}
    looks |= {"robot cut off": (0.19, "olive", "out of reach")}
    data = failure_detection_data()
    names = list(dict.fromkeys(data["configuration"]))
    with book_figure(2.6, "A failed robot stays listed for about one lease") as figure:
        axis = figure.subplots()
        numbers: dict[tuple[str, str], list[tuple[float, float]]] = {}
        for row in data.to_dict("records"):
            shift, color, _ = looks[row["event"]]
            y, seconds = names.index(row["configuration"]) + shift, row["noticed_s"]
            axis.barh(y, seconds, 0.34, color=_SERIES[color])
            text = f"{seconds:.0f}" if seconds >= 0.5 else "0"
            numbers.setdefault((row["configuration"], text), []).append((seconds, y))
            axis.barh(y, 0.8, 0.4, row["lease_s"] - 0.4, zorder=3, fc="black", ec="white")
        for (_, text), ends in numbers.items():  # two equal bars share their number
            write_text(axis, text, tuple(np.mean(ends, axis=0)), (5, 0), va="center", fontsize=8)
        labels = [_SHORT_NAMES.get(name, name) for name in names]
        drawing.name_rows_without_ticks(axis, range(len(names)), labels, labelsize=8)
        axis.invert_yaxis()
        axis.set(xlim=(0, 100), xlabel="time until the others time the robot out [s]")
        bars = [Patch(color=_SERIES[color], label=label) for _, color, label in looks.values()]
        lease = Line2D([], [], c="black", ls="", marker="|", ms=10, mew=2.5, label="lease")
        axis.legend(handles=[*bars, lease], loc="upper right")
    return figure
