"""Figure of the chapter on releases: the startup of the same robots with each release."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
import pandas as pd
from matplotlib.figure import Figure

from discostorm.figures import COLORS
from discostorm.fleet import Fleet, HostGroup
from discostorm.messages import Protocol, Schedule
from discostorm.model import utilization
from discostorm.protocols import PROTOCOLS
from discostorm_book.figures.drawing import book_figure, write_text
from discostorm_book.lab_counts import WINDOWS

#: Line style of each table; all lines have the color of Fast DDS.
_DASHES = {"Fast DDS 2.6": ":", "Fast DDS 2.14": "-", "Fast DDS 3.6": "--"}
#: Vertical offset of the names at the ends of lines [points].
_NAME_OFFSETS = {"Fast DDS 2.14": -5, "Fast DDS 3.6": 3}
_OWN_TYPES = "Fast DDS 3.6, own types"
_ROBOTS = np.arange(2.0, 13)
#: Period of the budget of `with_send_budget` [s].
BUDGET_PERIOD = 0.1


def startup_airtime(name: str, robot: HostGroup, hosts: float, phase: str | None = None) -> float:
    """Return the airtime of the first 12 s of a startup, or of one of its phases [s]."""
    seconds = WINDOWS["startup"][1]
    fleet = Fleet((replace(robot, hosts=hosts),))
    return seconds * float(utilization(PROTOCOLS[name], fleet, window=seconds, phase=phase))


def startup_by_robots_data(robot: HostGroup, own_types: float) -> pd.DataFrame:
    """Return the airtime of a startup [s] by the number of robots: one column per release."""
    own = replace(robot, own_types=own_types)
    columns = {name: [startup_airtime(name, robot, n) for n in _ROBOTS] for name in _DASHES}
    columns[_OWN_TYPES] = [startup_airtime("Fast DDS 3.6", own, n) for n in _ROBOTS]
    return pd.DataFrame({"robots": _ROBOTS.astype(int)} | columns)


def startup_by_robots(data: pd.DataFrame, shipped_with: Mapping[str, str], title: str) -> Figure:
    """Draw the data of `startup_by_robots_data`, a line for each release."""
    with book_figure(3.2, title) as figure:
        axis = figure.subplots()
        for name in data.columns[1:]:
            of = name.partition(",")[0]
            dashes = "-." if name == _OWN_TYPES else _DASHES[of]
            axis.plot(data["robots"], data[name], dashes, color=COLORS[of])
            text = "3.6, programs of other types" if name == _OWN_TYPES else shipped_with[name]
            end = (data["robots"].iloc[-1], data[name].iloc[-1])
            write_text(axis, text, end, (5, _NAME_OFFSETS.get(name, 0)), va="center")
        axis.set(xlabel="robots", ylabel="airtime of a startup [s]", xlim=(2, 15.5), ylim=(0, None))
        axis.set_xticks(range(2, 13, 2))
        axis.spines[["top", "right"]].set_visible(False)
    return figure


def with_send_budget(protocol: Protocol, fleet: Fleet, kilobytes: float) -> Protocol:
    """Return the table with SEDP split by the send budget of a process [kB per 0.1 s]."""
    sedp = protocol.message("SEDP")
    sent = sedp.load(fleet) * sedp.payload.nominal / fleet.processes()
    parts = max(1, int(np.ceil(float(sent) / (1000 * kilobytes))))
    first, *_ = sedp.schedule.starts
    starts = tuple(first + BUDGET_PERIOD * np.arange(parts))
    row = replace(sedp, schedule=Schedule(starts), per_unit=sedp.per_unit / parts)
    rows = tuple(row if message is sedp else message for message in protocol.messages)
    return replace(protocol, name=f"{protocol.name}, {kilobytes:g} kB", messages=rows)
