"""Figures of the chapter on what to change first: the discovery time after each change."""

from collections.abc import Iterable, Mapping
from textwrap import wrap

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from discostorm.fleet import Fleet
from discostorm.lookup import with_timers_of
from discostorm.palette import light_colors
from discostorm.protocols import MEASURED, PROTOCOLS, measured_tables
from discostorm.ros_releases import shipped_table
from discostorm_book.figures import drawing, servers
from discostorm_book.figures.drawing import Style, book_figure, write_text
from discostorm_planner import Plan
from discostorm_planner.discovery_time import RUNS
from discostorm_planner.simulation_jobs import MAX_IDLE_PERIODS, SEED, WITHIN_S
from discostorm_simulation import NoRecovery, simulate

#: Product, in the release that this distribution ships.
_PRODUCT, _ROS = "Fast DDS", "jazzy"
#: Position of a discovery that did not end [s].
NEVER_AT = 500.0
_MAX_LINE_LETTERS = 40  # of a name in a line
_STATES = light_colors("state")
_WORKS = f"works: 9 of 10 runs end within {WITHIN_S:g} s, and no lease expires"
#: Colors, marks and names of a fleet as it is, and of changes after which its startup works or not.
_MEANINGS: dict[str, Style] = {
    "today": {"color": light_colors("neutral")["gray"], "marker": "D"},
    _WORKS: {"color": _STATES["ok"], "marker": "o"},
    "does not": {"color": _STATES["bad"], "marker": "X"},
}


def times_by_change_data(plan: Plan) -> pd.DataFrame:
    """Return the discovery time today and after each change that was simulated with repairs."""
    found = plan.discovery
    assert found.today
    today, works, fails = _MEANINGS
    rows = [("today", found.today, today)]
    rows += [
        (change.remedy.what, change.time, works if change.time.works(plan.within) else fails)
        for change in found.changes
        if change.time and change.remedy.all_discover and not change.time.is_lower_bound
    ]
    data = pd.DataFrame(
        {"change": what, "median [s]": time.median, "nine of ten [s]": time.nine_of_ten, "is": is_}
        for what, time, is_ in rows
    )
    return data.sort_values("median [s]", kind="stable", key=lambda times: -times)


def times_by_change(plan: Plan, title: str) -> Figure:
    """Draw the discovery time today and after each change as dots, the slowest on top."""
    data = times_by_change_data(plan)
    names = ["\n".join(wrap(name, _MAX_LINE_LETTERS)) for name in data["change"]]
    heights = np.array([1 + 0.5 * name.count("\n") for name in names])
    places = heights.cumsum() - heights / 2
    with book_figure(1.2 + 0.26 * places[-1], title) as figure:
        axis = figure.subplots()
        looks = [_MEANINGS[is_] for is_ in data["is"]]
        _draw_times(axis, places, data["median [s]"], data["nine of ten [s]"], looks)
        axis.set_yticks(places, names)
        handles = [Line2D([], [], ls="", label=name, **look) for name, look in _MEANINGS.items()]
        drawing.legend_below(figure, handles, 3, columnspacing=1)
    return figure


def times_by_configuration_data(fleets: Mapping[str, Fleet]) -> pd.DataFrame:
    """Return discovery times by configuration [s], and what fails with its server."""
    shown = {*servers.replaced_products().values(), *measured_tables.configurations()}
    own, rows = PROTOCOLS[shipped_table(_PRODUCT, _ROS)], []
    for name in (name for name in PROTOCOLS if name in shown):
        row = {"configuration": name, "what else fails": servers.consequence_of(name)}
        table = own if name == _PRODUCT else with_timers_of(PROTOCOLS[name], own)
        try:
            for fleet, hosts in fleets.items():
                runs = simulate(
                    hosts, table, until=WITHIN_S, give_up=MAX_IDLE_PERIODS, runs=RUNS, seed=SEED
                ).convergence_time
                ends = np.sort(runs)[[4, 5, 8]]
                row |= {f"{fleet}: median [s]": ends[:2].mean()}
                row |= {f"{fleet}: nine of ten [s]": ends[2]}
        except NoRecovery:
            continue
        rows.append(row)
    by = [f"{fleet}: median [s]" for fleet in fleets]
    return pd.DataFrame(rows).sort_values(by, ascending=False, ignore_index=True)


def times_by_configuration(data: pd.DataFrame, fleets: Iterable[str]) -> Figure:
    """Draw what `times_by_configuration_data` returns, one panel per fleet."""
    names = [servers.FULL_NAMES.get(name, name) for name in data["configuration"]]
    names = [f"{name}, as shipped" if name in MEASURED else name for name in names]
    looks = [servers.consequence_style(what) for what in data["what else fails"]]
    title = "The configuration that is best for small robots fails with large ones"
    with book_figure(1.5 + 0.22 * len(data), title) as figure:
        panels = figure.subplots(1, len(list(fleets)), sharey=True)
        for axis, fleet in zip(panels, fleets, strict=True):
            median, late = (data[f"{fleet}: {end} [s]"] for end in ("median", "nine of ten"))
            _draw_times(axis, range(len(data)), median, late, looks)
            axis.set_title(fleet, loc="left", fontsize=9.5)
        panels[0].set_yticks(range(len(data)), names)
        servers.consequence_legend(figure, "What else fails if its server or router fails", 6)
    return figure


def _draw_times(
    axis: Axes, places: Iterable[float], medians: pd.Series, late: pd.Series, looks: list[Style]
) -> None:
    """Draw a dot at each median, and a line to the time within which nine of ten runs end."""
    rows = list(places)
    for y, median, nine, look in zip(rows, medians, late, looks, strict=True):
        ends = np.minimum([median, nine], NEVER_AT)
        axis.plot(ends, [y, y], color=look["color"], lw=2, alpha=0.5)
        axis.plot(ends[0], y, ls="", ms=7, **look)
        if median < NEVER_AT:
            digits = f"{float(f'{median:.2g}'):g}"
            left = nine >= NEVER_AT  # its line leads to the right
            across, side = (-7, "right") if left else (7, "left")
            write_text(axis, digits, (ends[1 - left], y), (across, 0), va="center", ha=side)
    axis.set(xscale="log", xlim=(0.02, 2 * NEVER_AT), xlabel="discovery time [s]")
    axis.set_xticks([0.1, 1, 10, 60, NEVER_AT], ["0.1", "1", "10", "60", "never"])
    axis.set_xticks([], minor=True)
    axis.set_ylim(rows[-1] + 0.8, rows[0] - 0.8)
    axis.spines["left"].set_visible(False)
    drawing.name_rows_without_ticks(axis, labelsize=8.5)
