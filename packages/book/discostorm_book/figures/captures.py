"""Figures of the page on captures."""

from collections.abc import Mapping

import pandas as pd
from matplotlib.artist import Artist
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from discostorm.figures import headline
from discostorm.palette import light_colors
from discostorm_book.figures.drawing import book_figure, legend_below, name_rows_without_ticks
from discostorm_capture import Capture

_COLORS = light_colors("shade")
#: Rows of a lane, from its top: kinds of message, position in the lane, and color.
ROWS = {
    "SPDP": (("SPDP",), -0.24, _COLORS["SPDP"]),
    "SEDP": (("SEDP",), 0.0, _COLORS["SEDP"]),
    "Heartbeat, ACKNACK": (("Heartbeat", "ACKNACK"), 0.24, _COLORS["Heartbeat"]),
}
_BEFORE, _AFTER = "0.93", (light_colors("state")["ok"], 0.18)


def message_lanes_data(captures: Mapping[str, Capture], end_s: float) -> pd.DataFrame:
    """Return the messages of captures up to a time [s], and when their hosts knew all others."""
    tables = []
    for name, capture in captures.items():
        rows = capture.messages()
        rows = rows[rows["time"] <= end_s]
        hosts, complete = rows["sender"].astype(str), capture.diagnosis().hosts()["knows_all_s"]
        columns = {"capture": name, "time_s": rows["time"], "host": hosts}
        columns |= {"kind": rows["kind"].astype(str), "complete_s": hosts.map(complete)}
        tables.append(pd.DataFrame(columns))
    return pd.concat(tables)


def message_lanes(captures: Mapping[str, Capture], end_s: float) -> Figure:
    """Draw captures on one clock: lanes of hosts, marks of messages, and complete discovery."""
    data = message_lanes_data(captures, end_s)
    names, y = {}, 0.0
    with book_figure(3.3) as figure:
        axis = figure.subplots()
        for name, of_capture in data.groupby("capture", sort=False):
            axis.text(0, y - 0.1, str(name), weight="bold", va="center", size=9)
            y += 0.85
            for host, rows in of_capture.groupby("host"):
                (complete,) = rows["complete_s"].unique()
                axis.barh(y, complete, 0.82, color=_BEFORE, zorder=0)
                axis.barh(y, end_s - complete, 0.82, complete, color=_AFTER, zorder=0)
                for kinds, offset, color in ROWS.values():
                    times = rows["time_s"][rows["kind"].isin(kinds)]
                    axis.plot(times, [y + offset] * len(times), "|", color=color, ms=7, mew=1.6)
                axis.text(0.995 * end_s, y, f"{complete:.2f} s", ha="right", va="center", size=9)
                names[y] = str(host)
                y += 1
            y += 0.35
        axis.set(xlim=(0, end_s), ylim=(y - 0.6, -0.5))
        axis.set_xlabel("time since the first packet [s]")
        name_rows_without_ticks(axis, list(names), list(names.values()))
        handles: list[Artist] = [
            Line2D([], [], marker="|", ls="", color=color, mew=1.6, ms=8, label=label)
            for label, (_, _, color) in ROWS.items()
        ]
        legend_below(figure, [*handles, Patch(color=_AFTER, label="knows all others")], 4)
        complete = data.groupby("capture", sort=False)["complete_s"].max().tolist()
        delay = f"from {complete[0]:.1f} s to {complete[-1]:.1f} s"
        headline(figure, f"Lost frames delay discovery {delay}")
    return figure
