"""The first page: settings of its simulation in the browser, and a picture of that run."""

from typing import Any

import numpy as np
import pandas as pd
from matplotlib.figure import Figure

from discostorm import figures, wording
from discostorm.data import data_path
from discostorm.messages import Protocol
from discostorm.palette import light_colors
from discostorm.protocols import PROTOCOLS
from discostorm.ros_releases import shipped_table
from discostorm.wifi import WIFI, Radio
from discostorm_book.figures.drawing import Style, book_figure, write_text
from discostorm_planner.change_simulation import CAUTION_LOSS
from discostorm_planner.remedy_rules import simulation_caution

#: Processes of a robot, and endpoints of each: the paper's Fig. 2.
PROCESSES, ENDPOINTS = figures.FIG2_PROCESSES, figures.FIG2_ENDPOINTS
#: The page's first settings; the picture shows their hosts, table and seed.
HOSTS, TABLE, OTHER_TABLE, SEED = 12, "Fast DDS 3.6", "Zenoh peer", 0
#: The tables of the same products with a server or router that is wired to the access point.
TABLES_WITH_SERVER = {TABLE: "Fast DDS Discovery Server", "Zenoh peer": "Zenoh router"}
#: The release that collapses without aggregation.
HUMBLE_TABLE = PROTOCOLS[shipped_table("Fast DDS", "humble")]
#: Maximum number of robots to choose [1].
MAX_HOSTS = 15
#: The same radio with one message per frame, and with aggregation.
SINGLE_FRAMES = WIFI["802.11n 20 MHz 2x2"]
AGGREGATED = Radio("802.11n", streams=2, mpdus=64).wifi()
#: Queue limits: frames [1] and seconds [s].
QUEUE = (500, 0.5)
#: End of the picture, and the shortest frame that is still seen [s].
PICTURE_END_S, MIN_WIDTH_S = 0.25, 0.35e-3


def protocol_choices() -> list[Protocol]:
    """Return the tables to choose from: the first of each product, then the paper's."""
    first: dict[str | None, Protocol] = {PROTOCOLS[TABLE].product: PROTOCOLS[TABLE]}
    for basis in ("measured", "mitigated"):
        for protocol in PROTOCOLS.values():
            if protocol.basis == basis and protocol.product:
                first.setdefault(protocol.product, protocol)
    return [*first.values(), HUMBLE_TABLE, *(p for p in PROTOCOLS.values() if p.basis == "paper")]


def _choice(protocol: Protocol) -> dict[str, str]:
    label = protocol.name + ", as the paper counts" * (protocol.basis == "paper")
    label += ", of ROS 2 Humble" * (protocol is HUMBLE_TABLE)
    return {"name": protocol.name, "label": label, "color": figures.css_color_property(protocol)}


def page_data() -> dict[str, Any]:
    """Return the choices of the page: robots, queue, channels, tables with their colors."""
    tables = [_choice(protocol) for protocol in protocol_choices()]
    behind = {name: _choice(PROTOCOLS[server]) for name, server in TABLES_WITH_SERVER.items()}
    sizes = {"processes": PROCESSES, "endpoints": ENDPOINTS, "queue": list(QUEUE)}
    first = {"hosts": HOSTS, "most": MAX_HOSTS, "table": TABLE, "other": OTHER_TABLE, **sizes}
    radios = {"radios": [SINGLE_FRAMES.name, AGGREGATED.name], "few_lost": CAUTION_LOSS}
    cautions: dict[str, list[str]] = {}  # why runs that lose more may be wrong, of which tables
    for protocol in protocol_choices():
        if caution := simulation_caution(protocol):
            cautions.setdefault(f"{wording.capitalized(caution)}.", []).append(protocol.name)
    return {**first, **radios, "tables": tables, "behind": behind, "cautions": cautions}


def draw_first_part() -> Figure:
    """Draw the first part of the run: lanes of the robots and the access point, and its queue."""
    sent = pd.read_csv(data_path("simulated/air.csv", "discostorm_book"))
    bad, charcoal = light_colors("state")["bad"], light_colors("neutral")["charcoal"]
    looks = sent.drop_duplicates("waiting")
    time = [*looks["start_s"] * 1e3, PICTURE_END_S * 1e3]
    waiting = [*looks["waiting"], sent["waiting"].iloc[-1]]
    full = next(at for at, many in zip(time, waiting, strict=True) if many >= QUEUE[0])
    failed, relayed = sent["outcome"] != 0, sent["station"] == HOSTS
    title = f"Robots collide, and the queue is full after {full / 1e3:.2f} s"
    with book_figure(4.2, title) as figure:
        lanes, queue = figure.subplots(2, 1, sharex=True, height_ratios=(4, 1))
        # Lines instead of boxes, one path for each look: a small file, and sharp at any size.
        for chosen, color, width in (
            (~failed & ~relayed, figures.color_of(PROTOCOLS[TABLE]), 8.0),
            (~failed & relayed, charcoal, 8.0),
            (failed, bad, 10.0),
        ):
            rows = sent[chosen]
            begin, none = rows["start_s"], np.full(len(rows), np.nan)
            end = begin + np.maximum(rows["end_s"] - begin, MIN_WIDTH_S)
            times = np.column_stack([begin, end, none]).ravel() * 1e3
            places = np.column_stack([rows["station"], rows["station"], none]).ravel()
            lanes.plot(times, places, color=color, linewidth=width, solid_capstyle="butt")
        names = [*(f"robot {host + 1}" for host in range(HOSTS)), "access point"]
        lanes.set(yticks=range(HOSTS + 1), yticklabels=names, ylim=(HOSTS + 0.6, -0.6))
        lanes.grid(visible=False)
        queue.fill_between(time, waiting, step="post", color=charcoal, alpha=0.35, lw=0)
        queue.axhline(QUEUE[0], color=bad, lw=1)
        look: Style = {"color": bad, "va": "bottom", "fontsize": 8}
        write_text(queue, "full: the access point drops frames", (2, QUEUE[0]), (0, 2), **look)
        queue.set(xlabel="time since the robots were switched on [ms]", ylabel="frames\nwaiting")
        queue.set(xlim=(0, PICTURE_END_S * 1e3), ylim=(0, QUEUE[0] * 1.4))
    return figure
