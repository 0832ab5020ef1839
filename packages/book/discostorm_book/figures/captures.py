"""Figures of the page on captures."""

from collections.abc import Mapping

import pandas as pd
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from discostorm.figures import WIDTH, headline, style
from discostorm.palette import lights
from discostorm_capture import Capture

_COLORS = lights("captured")
#: What is drawn of a lane, from its top: kinds of message, where in it, and in which color.
ROWS = {
    "SPDP": (("SPDP",), -0.24, _COLORS["SPDP"]),
    "SEDP": (("SEDP",), 0.0, _COLORS["SEDP"]),
    "Heartbeat, ACKNACK": (("Heartbeat", "ACKNACK"), 0.24, "0.35"),
}
_BEFORE, _AFTER = "0.93", (lights("state")["ok"], 0.18)


def lanes_data(captures: Mapping[str, Capture], until: float) -> pd.DataFrame:
    """Return the messages of captures up to a time after their first packet [s]: a row each.

    With the ``capture``, ``time_s``, ``host`` and ``kind``, and ``complete_s``: when
    that host knew all others [s].
    """
    found = []
    for name, capture in captures.items():
        rows = capture.messages()
        complete = capture.diagnosis().hosts()["knows_all_s"]
        rows = rows[rows["time"] <= until]
        hosts = rows["sender"].astype(str)
        found.append(
            pd.DataFrame(
                {
                    "capture": name,
                    "time_s": rows["time"],
                    "host": hosts,
                    "kind": rows["kind"].astype(str),
                    "complete_s": hosts.map(complete),
                }
            )
        )
    return pd.concat(found)


def lanes(captures: Mapping[str, Capture], until: float) -> Figure:
    """Draw captures on one clock: a lane a host, a mark a message, and when it knew all others."""
    data = lanes_data(captures, until)
    names, place = {}, 0.0
    with style():
        figure = Figure(figsize=(WIDTH, 3.3))
        axis = figure.subplots()
        for name, of_capture in data.groupby("capture", sort=False):
            axis.text(0, place - 0.1, str(name), weight="bold", va="center", size=9)
            place += 0.85
            for host, rows in of_capture.groupby("host"):
                (complete,) = rows["complete_s"].unique()
                axis.barh(place, complete, height=0.82, color=_BEFORE, zorder=0)
                axis.barh(
                    place, until - complete, left=complete, height=0.82, color=_AFTER, zorder=0
                )
                for kinds, offset, color in ROWS.values():
                    times = rows["time_s"][rows["kind"].isin(kinds)]
                    axis.plot(times, [place + offset] * len(times), "|", color=color, ms=7, mew=1.6)
                said = f"{complete:.2f} s"
                axis.text(0.995 * until, place, said, ha="right", va="center", size=9)
                names[place] = str(host)
                place += 1
            place += 0.35
        axis.set(xlim=(0, until), ylim=(place - 0.6, -0.5))
        axis.set_xlabel("time since the first packet [s]")
        axis.set_yticks(list(names), list(names.values()))
        axis.grid(axis="y", visible=False)
        axis.tick_params(axis="y", length=0)
        shown: list[Line2D | Patch] = [
            Line2D([], [], marker="|", ls="", color=color, mew=1.6, ms=8, label=label)
            for label, (_, _, color) in ROWS.items()
        ]
        shown.append(Patch(color=_AFTER, label="knows all others"))
        figure.legend(handles=shown, loc="outside lower center", ncols=4)
        last = data.groupby("capture", sort=False)["complete_s"].max()
        first, slowest = last.iloc[0], last.iloc[-1]
        headline(figure, f"Lost frames delay discovery from {first:.1f} s to {slowest:.1f} s")
    return figure
